# SPDX-License-Identifier: MIT
"""How tools/run_tests.py counts what tests say, by logs as Meson writes them.

Argument: the project's folder.
"""
import json
import os
import subprocess
import sys
import tempfile

from tap import Tap

# What stands in for Meson: it leaves the log that it was given, and its exit code.
MESON = """#!/bin/sh
cp "$3/given.json" "$3/meson-logs/testlog.json"
exit "$(cat "$3/code")"
"""


def counted(root, tests, code):
    """The exit code and the output of run_tests.py for these tests, each a name, a result, an exit code, an output."""
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, "meson-logs"))
        with open(os.path.join(folder, "given.json"), "w", encoding="utf-8") as file:
            for name, result, returncode, output in tests:
                json.dump({"name": name, "result": result, "returncode": returncode, "stdout": output}, file)
                file.write("\n")
        with open(os.path.join(folder, "code"), "w", encoding="utf-8") as file:
            file.write(str(code))
        meson = os.path.join(folder, "meson")
        with open(meson, "w", encoding="utf-8") as file:
            file.write(MESON)
        os.chmod(meson, 0o700)
        run = subprocess.run([sys.executable, os.path.join(root, "tools", "run_tests.py"), meson, folder],
                             capture_output=True, check=False)
        return run.returncode, run.stdout.decode()


def check(tap, root, name, tests, code, expected_code, *expected):
    found_code, output = counted(root, tests, code)
    tap.ok(found_code == expected_code and all(text in output for text in expected), name, output)


def main():
    tap, root = Tap(), sys.argv[1]
    good = ("good", "OK", 0, "1..2\nok 1 - first\nok 2 - second # SKIP no such thing\n")
    cmocka = ("cmocka", "FAIL", 0, "1..2\nnot ok 1 # SKIP first\nok 2 - second\n")
    check(tap, root, "cases and what is skipped", [good], 0, 0, "SKIPPED  good: second (no such thing)\n",
          "1 passed, 0 failed\n")
    check(tap, root, "cmocka's way to skip", [good, cmocka], 1, 0, "SKIPPED  cmocka: first (", "2 passed, 0 failed\n")
    check(tap, root, "Meson's own failure beside it", [cmocka], 2, 1, "FAILED   meson test ended with exit code 2")
    check(tap, root, "a failure beside it", [("both", "FAIL", 1, "not ok 1 # SKIP a\nnot ok 2 - b\n# why\n")], 1, 1,
          "FAILED   both: b\n         # why\n", "0 passed, 1 failed\n")
    check(tap, root, "a program that skips and then ends badly", [("bad", "FAIL", 3, "not ok 1 # SKIP a\nok 2 - b\n")],
          1, 1, "bad: ended with FAIL, exit code 3", "1 passed, 1 failed\n")
    check(tap, root, "a crash after good cases", [("crash", "ERROR", -11, "1..2\nok 1 - a\n")], 1, 1,
          "crash: ended with ERROR, exit code -11", "1 passed, 1 failed\n")
    check(tap, root, "a program that leaves itself out", [good, ("absent", "SKIP", 0, "1..0 # SKIP not here\n")], 0, 0,
          "SKIPPED  absent (not here)\n", "1 passed, 0 failed\n")
    check(tap, root, "a program that does not say why", [good, ("absent", "SKIP", 77, "")], 0, 1,
          "absent: ran no case", "1 passed, 1 failed\n")
    check(tap, root, "a program without cases", [("plain", "OK", 0, "")], 0, 0, "1 passed, 0 failed\n")
    check(tap, root, "Meson itself", [good], 2, 1, "FAILED   meson test ended with exit code 2", "1 passed, 1 failed\n")
    check(tap, root, "no test", [], 0, 1, "no test ran", "0 passed, 0 failed\n")
    tap.finish()


main()
