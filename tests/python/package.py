# SPDX-License-Identifier: MIT
"""What the tests of the package share: the package itself, and running them.

Where a sanitizer is built in, the test begins anew with its runtime loaded first.
"""
import os
import sys

from tap import Tap
from tool import run_tests


def load_sanitizer():
    """Begins anew with the runtime of the sanitizer, or ends where it cannot be loaded."""
    runtime = os.environ.get("LUXEL_SANITIZER")
    if not runtime or runtime in os.environ.get("LD_PRELOAD", ""):
        return
    if runtime == "none":
        tap = Tap()
        tap.skip("the Python package", "this sanitizer cannot be loaded into Python")
        tap.finish()
    os.environ["LD_PRELOAD"] = runtime
    # What the interpreter keeps to its end is no leak of the module.
    os.environ["ASAN_OPTIONS"] = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
    os.execv(sys.executable, [sys.executable] + sys.argv)


load_sanitizer()

import luxel  # noqa: E402


def raises(kind, function, *arguments, **named):
    """The exception of a kind that a call raises; None where it raises none."""
    try:
        function(*arguments, **named)
    except kind as error:
        return error
    return None


__all__ = ["Tap", "luxel", "raises", "run_tests"]
