# SPDX-License-Identifier: MIT
"""Test results in the TAP format, for every Python test of the project.

A test makes one Tap, states what must hold, and ends with finish(), which prints the plan and exits:

    from tap import Tap
    tap = Tap()
    tap.ok(total == 3, "three parts", "total: %r" % total)
    tap.equal(name, "sphere", "its name")
    tap.near(value, 2.5, 1e-12, "its value")
    tap.run(function)          # the function's own exceptions become a failed case
    tap.finish()

A test without a single case fails: a test that checks nothing must not look like one that passed.
With LUXEL_TIMES in the environment run() tells how long of a processor each function takes.
"""
import math
import os
import sys
import traceback


class Tap:
    def __init__(self):
        self.count = 0
        self.failed = 0

    def _line(self, good, name, directive=""):
        self.count += 1
        self.failed += not good
        # '#' would begin a directive, and a line break a new line of the protocol.
        safe = str(name).replace("#", "\\#").replace("\n", " ")
        print("%s %d - %s%s" % ("ok" if good else "not ok", self.count, safe, directive), flush=True)

    @staticmethod
    def note(*texts):
        """Prints lines that belong to no case."""
        for text in texts:
            for line in str(text).splitlines():
                print("# " + line, flush=True)

    def ok(self, good, name, *details):
        """One case; the details are printed where it failed."""
        self._line(bool(good), name)
        if not good:
            self.note(*details)
        return bool(good)

    def equal(self, found, expected, name):
        return self.ok(found == expected, name, "found:    %r" % (found,), "expected: %r" % (expected,))

    def near(self, found, expected, relative, name, absolute=0.0):
        """|found - expected| <= relative * |expected| + absolute; false for what is not finite."""
        bound = relative * abs(expected) + absolute
        good = isinstance(found, (int, float)) and math.isfinite(found) and abs(found - expected) <= bound
        return self.ok(good, name, "found:    %r" % (found,), "expected: %r within %g" % (expected, bound))

    def skip(self, name, reason):
        """A case that could not be tried here; it counts neither as passed nor as failed."""
        self._line(True, name, " # SKIP " + str(reason).replace("\n", " "))

    def run(self, function, *arguments):
        """Calls a function that states cases; an exception is a failed case of its name."""
        before = os.times()
        try:
            function(*arguments)
        except Exception:
            self.ok(False, "%s ends without an exception" % function.__name__, traceback.format_exc())
        if "LUXEL_TIMES" in os.environ:
            self.note("%s: %.2f s of a processor" % (function.__name__, sum(os.times()[:4]) - sum(before[:4])))

    def finish(self):
        """Prints the plan and ends the process."""
        if self.count == 0:
            self.ok(False, "the test has at least one case")
        print("1..%d" % self.count, flush=True)
        sys.exit(1 if self.failed else 0)
