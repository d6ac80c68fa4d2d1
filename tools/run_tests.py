#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every test of a build folder and counts their single cases.

    run_tests.py MESON BUILD_FOLDER [arguments of `meson test`]

Prints what failed, and as its last line "N passed, N failed".  A test program that crashes, runs too long, says
nothing or breaks the protocol counts as a failed case, one that says "1..0 # SKIP why" as skipped.  Exits with 1 on
any failure, or if nothing ran.

cmocka writes "not ok 1 # SKIP name" for what it skips, which Meson takes for a failure: it is none.
"""
import json
import os
import re
import subprocess
import sys

CASE = re.compile(r"^\s*(not )?ok\b[ \t]*(\d*)[ \t]*-?[ \t]*(.*?)(?:(?<!\\)#[ \t]*(SKIP)\b[ \t]*(.*))?$", re.I)
NO_CASE = re.compile(r"^1\.\.0[ \t]*#[ \t]*SKIP\S*[ \t]*(.*)$", re.I | re.M)


class Counts:
    def __init__(self):
        self.passed, self.failed, self.skipped = [], [], []
        self.misread = 0  # tests that Meson took for failed, as they skipped something


def read_case(match):
    bad, number, name, skip, reason = match.groups()
    if bad and skip:
        name, reason = reason, "left out by the test"
    title = name.strip().replace("\\#", "#") or "case %s" % number
    return {"bad": bool(bad) and not skip, "title": title, "skipped": bool(skip), "reason": reason, "details": []}


def cases_of(output):
    """The cases in a test's output, each with the # lines that follow it."""
    cases = []
    for line in output.splitlines():
        match = CASE.match(line)
        if match:
            cases.append(read_case(match))
        elif cases and line.lstrip().startswith("#"):
            cases[-1]["details"].append(line.strip())
    return cases


def count_test(test, counts):
    """Adds one test program's cases to the counts."""
    cases = cases_of(test.get("stdout") or "")
    failed_before = len(counts.failed)

    for case in cases:
        title = "%s: %s" % (test["name"], case["title"])
        if case["skipped"]:
            counts.skipped.append((title, case["reason"]))
        elif case["bad"]:
            counts.failed.append((title, case["details"]))
        else:
            counts.passed.append(title)
    result = test["result"]
    skipped = NO_CASE.search(test.get("stdout") or "")
    if not cases and skipped and result == "SKIP" and test["returncode"] == 0:
        counts.skipped.append((test["name"], skipped.group(1)))
        return
    if result == "FAIL" and test["returncode"] == 0 and any(case["skipped"] for case in cases):
        counts.misread += 1
        result = "OK"
    if not cases and result == "OK":
        counts.passed.append(test["name"])  # a plain program, which tells by its exit code
    elif (not cases or result not in ("OK", "SKIP")) and len(counts.failed) == failed_before:
        ending = "ran no case" if result == "SKIP" else "ended with %s, exit code %s" % (result, test["returncode"])
        counts.failed.append(("%s: %s" % (test["name"], ending), (test.get("stderr") or "").splitlines()[-40:]))


def read_log(path):
    """The tests of Meson's log, one JSON object a line; none if Meson did not get that far."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return [json.loads(line) for line in file if line.strip()]
    except FileNotFoundError:
        return []


def log_name(arguments):
    """Meson names its log after the wrapper, if there is one."""
    wrappers = [argument.split("=", 1)[1] for argument in arguments if argument.startswith("--wrapper=")]
    return "testlog%s.json" % ("-" + os.path.basename(wrappers[-1].split()[0]) if wrappers else "")


def main():
    meson, folder, arguments = sys.argv[1], sys.argv[2], sys.argv[3:]
    log = os.path.join(folder, "meson-logs", log_name(arguments))

    if os.path.exists(log):
        os.remove(log)
    run = subprocess.run([meson, "test", "-C", folder, "--print-errorlogs"] + arguments,
                         stdin=subprocess.DEVNULL)
    counts = Counts()
    for test in read_log(log):
        count_test(test, counts)

    print()
    for title, reason in counts.skipped:
        print("SKIPPED  %s (%s)" % (title, reason))
    for title, details in counts.failed:
        print("FAILED   %s" % title)
        for line in details:
            print("         " + line)
    if run.returncode != counts.misread and not counts.failed:  # it tells how many tests failed
        counts.failed.append("meson")
        print("FAILED   meson test ended with exit code %d" % run.returncode)
    if not counts.passed and not counts.failed:
        print("no test ran")
    print("%d passed, %d failed" % (len(counts.passed), len(counts.failed)))
    return 0 if counts.passed and not counts.failed else 1


sys.exit(main())
