# SPDX-License-Identifier: MIT
"""The list of mutants fits the sources: each text is found once in its file, and what replaces it is another one.

Random mutants are the same for the same seed, stand in code, and change one line each.
"""
import os
import sys

from tap import Tap

ROOT = sys.argv[1]
sys.path.insert(0, os.path.join(ROOT, "tools"))

from mutant import core_files, random_mutants, read_list  # noqa: E402 (the path is an argument)


def text_of(mutant):
    with open(os.path.join(ROOT, mutant.path), encoding="utf-8") as file:
        return file.read()


def check_list(tap):
    mutants = read_list(ROOT)
    names = [mutant.name for mutant in mutants]
    tap.equal(sorted(names), sorted(set(names)), "each name stands once")
    for mutant in mutants:
        try:
            tap.ok(mutant.apply(text_of(mutant)) != text_of(mutant), "%s changes its file" % mutant.name)
        except (OSError, ValueError) as error:
            tap.ok(False, "%s fits its file" % mutant.name, error)


def check_random(tap):
    mutants, again = (random_mutants(ROOT, core_files(ROOT), 300, 7) for _ in range(2))
    tap.equal([str(mutant) for mutant in mutants], [str(mutant) for mutant in again], "a seed draws the same again")
    for mutant in mutants:
        lines = list(zip(text_of(mutant).split("\n"), mutant.apply(text_of(mutant)).split("\n")))
        changed = [old for old, new in lines if old != new]
        good = len(changed) == 1 and not changed[0].lstrip().startswith(("#", "/*", "* "))
        tap.ok(good, "%s changes one line of code" % mutant.name, str(mutant))


tap = Tap()
tap.run(check_list, tap)
tap.run(check_random, tap)
tap.finish()
