#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether pictures still have the bytes that they had: hashes of values and masks, for each scene, instruction set and
precision, against hashes.txt beside this file.

    frozen.py FREEZE            lists the pictures that moved; exits with 1 where there are any
    frozen.py FREEZE --write    takes the bytes of now; sets that do not run here keep their hashes

FREEZE is the built program of freeze.c.  A change that means to move no byte leaves the hashes; another one says in its
message which moved, and why they stay within the bounds.
"""
import argparse
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
HASHES = os.path.join(HERE, "hashes.txt")
PRECISIONS = ("single", "double")


def read_hashes(lines):
    """The compiler, and {(name, precision): {set: hash}}."""
    compiler, hashes = "", {}
    for line in lines:
        if line.startswith("# compiled by "):
            compiler = line.removeprefix("# compiled by ").strip()
        elif line.strip() and not line.startswith("#"):
            name, instruction_set, precision, value = line.split()
            hashes.setdefault((name, precision), {})[instruction_set] = value
    return compiler, hashes


def read_file():
    if not os.path.exists(HASHES):
        return "", {}
    lines = []
    with open(HASHES, encoding="utf-8") as file:
        for line in file:
            if line.startswith("#"):
                lines.append(line)
                continue
            name, precision, *pairs = line.split()
            for pair in pairs:
                instruction_set, _, value = pair.partition("=")
                lines.append("%s %s %s %s" % (name, instruction_set, precision, value))
    return read_hashes(lines)


def write_file(compiler, hashes):
    with open(HASHES, "w", encoding="utf-8") as file:
        file.write("# Written by `make freeze`: hashes of pictures, one line a scene and precision.\n")
        file.write("# compiled by %s\n" % compiler)
        for (name, precision), sets in hashes.items():
            file.write("%s %s %s\n" % (name, precision, " ".join("%s=%s" % pair for pair in sorted(sets.items()))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("freeze", help="the built program")
    parser.add_argument("--write", action="store_true", help="take the bytes of now")
    arguments = parser.parse_args()
    run = subprocess.run([arguments.freeze, os.path.join(HERE, "scenes.txt")], stdout=subprocess.PIPE, text=True,
                         check=False)
    if run.returncode != 0:
        sys.exit("a frozen scene is refused")
    compiler, now = read_hashes(run.stdout.splitlines())
    held_compiler, held = read_file()
    if arguments.write:
        if compiler == held_compiler:
            now = {key: {**held.get(key, {}), **sets} for key, sets in now.items()}
        write_file(compiler, now)
        return
    if compiler != held_compiler:
        sys.exit("the hashes are of pictures compiled by %s, these by %s" % (held_compiler, compiler))
    moved = ["%s %s %s" % (*key, instruction_set) for key, sets in now.items()
             for instruction_set, value in sets.items() if held.get(key, {}).get(instruction_set, value) != value]
    missing = [" ".join(key) for key in now if key not in held] + [" ".join(key) for key in held if key not in now]
    for text in ["moved: " + text for text in moved] + ["on one side only: " + text for text in missing]:
        print(text)
    print("%d pictures, %d moved" % (sum(len(sets) for sets in now.values()), len(moved)))
    sys.exit(1 if moved or missing else 0)


main()
