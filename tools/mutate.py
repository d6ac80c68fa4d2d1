#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the tests: builds the library with one deliberate fault after the other and sees whether a test fails.

    mutate.py FOLDER                      every mutant that tools/mutants/ lists
    mutate.py FOLDER --only NAME...       those whose names begin so
    mutate.py FOLDER --random N --seed S  N places of the core's files, drawn by chance
    mutate.py FOLDER --count N            the first N of what was asked for
    mutate.py FOLDER --suites SUITE...    tried by these tests alone
    mutate.py FOLDER --within SECONDS     tried by those tests alone that take no longer without a fault; what they
                                          miss can be asked for by name, of random mutants with the same N and S

FOLDER receives copies of the sources, one for each of --jobs, and what is built of them; the sources are not touched.
Every test of SUITES must pass without a fault first.  For each mutant they then run one at a time until one fails:
first those that caught a fault of the same file, then its room's own, then by suite and by the time that they take.  A
test that takes much longer than without the fault counts as failed.

Prints a line for each mutant and, last, the share of those caught; exits with 1 if that is below 95 %.  Not counted are
mutants that do not compile, those of which the compiler makes the same code, and those that the list calls equivalent.
"""
import argparse
import hashlib
import json
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

from mutant import core_files, random_mutants, read_list

SUITES = ["unit", "properties", "formats", "reference", "cli", "fuzz", "examples", "figure"]
ENOUGH = 95.0
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIBRARY = "src/libluxel-objects.a"
# Tests of what lights elements and pixels.
LIGHT_TESTS = ["rounding", "adaptive", "work", "tight", "surfaces", "shells", "lights", "blocks", "grid",
               "precision", "cubature", "plates", "kernel functions generic", "kernels", "units", "evaluator",
               "reference probes", "extended_pictures", "reference pictures"]
# The tests of a room's own, which find most of its faults; the others follow by suite.
OWN_TESTS = {
    "src/base": ["bounded", "wide", "number", "rows"],
    "src/light": ["contours", "tight", "light", "facets", "round", "points", "facet_shapes", "outlines", "lights",
                  "cubature", "reference probes"],
    "src/material": ["lobe", "tight", "reference probes"],
    "src/surface": ["surfaces", "tight", "plates", "view", "reference probes"],
    "src/kernel": LIGHT_TESTS,
    "src/world": LIGHT_TESTS,
    "src/flux": LIGHT_TESTS,
    "src/picture": LIGHT_TESTS,
    "src/field": ["statistics", "compare", "greys", "work", "profile", "foreign", "isophotes", "field_files",
                  "extrema"],
    "src/scene": ["guard", "yaml", "validate", "write", "advise", "advice_texts", "alternatives", "advise_peak"],
    "src/parameter": ["plain", "parameters", "validate", "yaml", "edit"],
    "src/format": ["formats", "formats_read", "exr", "field_files", "formats in Python"],
    "src/api": ["api", "grid", "evaluator", "light", "stride"],
    "src/inverse": ["cli derive", "cli arrange", "cli fit"],
    "src/exercise": ["judge", "alternatives", "advice_texts", "explain_texts", "scout", "advise_peak"],
}
MESON = "/usr/bin/meson" if os.path.exists("/usr/bin/meson") else "meson"


class Test:
    """A test of the build folder, as Meson would run it, with the seconds that it takes without a fault."""

    def __init__(self, told, targets, home):
        self.name, self.command, self.environment = told["name"], told["cmd"], told["env"]
        self.home = home  # the copy of which it was told
        self.suite = SUITES.index(told["suite"][0].split(":")[-1])
        self.targets = [target for name in told["depends"] for target in targets[name]]
        self.skipping = 77 if told["protocol"] == "exitcode" else None
        self.seconds = None

    def limit(self):
        """Generous, because other programs may slow a test down: a mutant is not to be caught by chance."""
        return 600 if self.seconds is None else 30 + 10 * self.seconds


class Copy:
    """A copy of the sources with a build folder of its own."""

    def __init__(self, folder, processes):
        self.tree, self.build = folder, os.path.join(folder, "build")
        self.processes = str(processes)

    def prepare(self):
        """Brings the copy up to date with the sources; what is the same already is not built anew."""
        wanted = {path: os.path.join(ROOT, path) for path in sources()}
        for path in sources(self.tree) if os.path.isdir(self.tree) else []:
            if path not in wanted:
                os.remove(os.path.join(self.tree, path))
        for path, source in wanted.items():
            target = os.path.join(self.tree, path)
            if not os.path.lexists(target) or not same_bytes(source, target):
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copy(source, target, follow_symlinks=False)
        if not os.path.exists(os.path.join(self.build, "build.ninja")):
            compiler = ["ccache"] if shutil.which("ccache") else []
            environment = dict(os.environ, CC=" ".join(compiler + [os.environ.get("CC", "gcc")]))
            subprocess.run([MESON, "setup", self.build, self.tree, "-Dtests=true", "-Dapp=disabled",
                            "-Doptimization=1", "-Ddebug=false"],
                           env=environment, stdout=subprocess.DEVNULL, check=True)
        if not self.compile([]):
            sys.exit("the sources do not compile: ninja -C %s tells why" % self.build)

    def compile(self, targets):
        return subprocess.run(["ninja", "-C", self.build, "-j", self.processes] + targets, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def code(self):
        """What the compiler made of the library, in a few bytes."""
        digest = hashlib.sha256()
        for where, _, names in os.walk(os.path.join(self.build, "src")):
            for name in sorted(names):
                if name.endswith(".o"):
                    with open(os.path.join(where, name), "rb") as file:
                        digest.update(name.encode() + file.read())
        return digest.digest()

    def tests(self, suites):
        """The tests of some suites by Meson's own account, without those that need nothing of what is built."""
        told = json.loads(subprocess.run([MESON, "introspect", self.build, "--tests", "--targets"],
                                         stdout=subprocess.PIPE, check=True).stdout)
        targets = {target["id"]: [os.path.relpath(name, self.build) for name in target["filename"]]
                   for target in told["targets"]}
        return [Test(test, targets, self.tree) for test in told["tests"]
                if test["depends"] and test["suite"][0].split(":")[-1] in suites]

    def passes(self, test):
        """Whether a test passes: by its exit code, and no case of it fails."""
        if not self.compile(test.targets):
            return False
        command = [part.replace(test.home, self.tree) for part in test.command]
        own = {name: value.replace(test.home, self.tree) for name, value in test.environment.items()}
        process = subprocess.Popen(command, cwd=self.build, env=dict(os.environ, **own), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True)
        try:
            output = process.communicate(timeout=test.limit())[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return False
        failed = re.search(rb"^\s*not ok\b", output, re.M)
        return not failed and process.returncode in (0, test.skipping)


def sources(root=ROOT):
    """The files of the project, without what was built and what Git keeps."""
    for where, folders, files in os.walk(root):
        inside = os.path.relpath(where, root)
        folders[:] = [name for name in folders if name not in (".git", "__pycache__")
                      and not (inside == "." and name.startswith(("build", "obj-")))]
        yield from (os.path.normpath(os.path.join(inside, name)) for name in files)


def digest_of_sources():
    digest = hashlib.sha256()
    for path in sorted(sources()):
        with open(os.path.join(ROOT, path), "rb") as file:
            digest.update(path.encode() + file.read())
    return digest.hexdigest()


def same_bytes(one, other):
    with open(one, "rb") as first, open(other, "rb") as second:
        return first.read() == second.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


class Trial:
    """All mutants, one after the other, in as many copies as there are jobs."""

    def __init__(self, copies, mutants, known, suites, within):
        self.copies, self.known, self.suites, self.within = copies, known, suites, within
        self.waiting = queue.Queue()
        for mutant in mutants:
            self.waiting.put(mutant)
        self.tests = []
        self.original = None
        self.catches = {}  # (file or room, name of a test): how many of the faults there it caught
        self.results = []
        self.lock = threading.Lock()

    def measure(self, path):
        """Runs every test without a fault; none may fail.  The times are kept until the sources change."""
        copy = self.copies[0]
        self.original, self.tests = copy.code(), copy.tests(self.suites)
        try:
            with open(path, encoding="utf-8") as file:
                kept = json.load(file)
        except FileNotFoundError:
            kept = {}
        if kept.get("sources") != digest_of_sources():
            kept = {"sources": digest_of_sources(), "seconds": {}}
        for test in self.tests:
            if test.name not in kept["seconds"]:
                start = time.monotonic()
                if not copy.passes(test):
                    sys.exit("the test %r fails without any fault" % test.name)
                kept["seconds"][test.name] = time.monotonic() - start
                write(path, json.dumps(kept))
            test.seconds = kept["seconds"][test.name]

    def order(self, path):
        """A fault is sought first where others of its file were found, then in its room's own tests."""
        room = "/".join(path.split(os.sep)[:2])
        own = OWN_TESTS.get(room, [])

        def key(test):
            in_file, in_room = (self.catches.get((place, test.name), 0) for place in (path, room))
            rank = own.index(test.name) if test.name in own else len(own)
            return -in_file, rank, test.suite, -in_room, test.seconds

        return sorted((test for test in self.tests if test.seconds <= self.within), key=key)

    def note_catch(self, path, name):
        with self.lock:
            for place in (path, os.path.dirname(path)):
                self.catches[place, name] = self.catches.get((place, name), 0) + 1

    def judge(self, copy, mutant):
        """What became of a mutant, and by which test."""
        path = os.path.join(copy.tree, mutant.path)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        changed = mutant.apply(text)
        if mutant.equivalent or (mutant.path, changed) in self.known:
            return "equivalent", mutant.equivalent or self.known[mutant.path, changed]
        write(path, changed)
        try:
            if not copy.compile([LIBRARY]):
                return "does not compile", ""
            if copy.code() == self.original:
                return "equivalent", "the compiler makes the same code of it"
            for test in self.order(mutant.path):
                if not copy.passes(test):
                    self.note_catch(mutant.path, test.name)
                    return "caught", test.name
            return "survived", ""
        finally:
            write(path, text)

    def work(self, copy):
        while True:
            try:
                mutant = self.waiting.get_nowait()
            except queue.Empty:
                return
            verdict, by = self.judge(copy, mutant)
            with self.lock:
                self.results.append(verdict)
                print("%-16s %s%s" % (verdict, mutant, "  <- %s" % by if by else ""), flush=True)

    def run(self):
        workers = [threading.Thread(target=self.work, args=[copy], daemon=True) for copy in self.copies]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()


def chosen_mutants(arguments, listed):
    mutants = listed
    if arguments.random:
        mutants = random_mutants(ROOT, core_files(ROOT), arguments.random, arguments.seed)
    return [mutant for mutant in mutants if mutant.name.startswith(tuple(arguments.only or [""]))]


def report(results):
    """The last line; whether enough were caught."""
    counts = {verdict: results.count(verdict) for verdict in ("caught", "survived", "equivalent", "does not compile")}
    tried = counts["caught"] + counts["survived"]
    share = 100.0 * counts["caught"] / tried if tried else 0.0
    print("%d mutants: %d caught, %d survived, %d equivalent, %d do not compile: %.1f %% caught"
          % (len(results), *counts.values(), share))
    return share >= ENOUGH


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="where the copies are made and built")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="the mutants whose names begin so")
    parser.add_argument("--random", type=int, metavar="N", help="N mutants drawn by chance instead of the list")
    parser.add_argument("--seed", type=int, default=1, help="of the random mutants (default: 1)")
    parser.add_argument("--count", type=int, help="at most so many mutants")
    parser.add_argument("--suites", nargs="+", choices=SUITES, default=SUITES, help="the tests (default: all of them)")
    parser.add_argument("--within", type=float, default=float("inf"), metavar="SECONDS",
                        help="only tests that take no longer (default: all)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="mutants at a time (default: processors)")
    arguments = parser.parse_args()

    listed = read_list(ROOT)
    mutants = chosen_mutants(arguments, listed)[:arguments.count]
    jobs = max(1, min(arguments.jobs, len(mutants)))
    known = {}
    for mutant in listed:
        if mutant.equivalent:
            with open(os.path.join(ROOT, mutant.path), encoding="utf-8") as file:
                known[mutant.path, mutant.apply(file.read())] = mutant.equivalent
    processes = max(1, (os.cpu_count() or 1) // jobs)
    copies = [Copy(os.path.join(os.path.abspath(arguments.folder), "copy-%d" % number), processes)
              for number in range(1, jobs + 1)]
    for copy in copies:
        copy.prepare()
    trial = Trial(copies, mutants, known, arguments.suites, arguments.within)
    trial.measure(os.path.join(arguments.folder, "times.json"))
    trial.run()
    return 0 if report(trial.results) and len(trial.results) == len(mutants) else 1


sys.exit(main())
