# SPDX-License-Identifier: MIT
"""Waiting by asking again and again; the deadline is only there so that a broken program does not hang a test."""
import time

from accessible import Rejected

DEADLINE = 120  # seconds
STEP = 0.05  # between two questions


class Late(AssertionError):
    """Something did not come to pass before the deadline."""


def wait(what, question, deadline=DEADLINE):
    """Asks until the answer is true, and gives it."""
    end = time.monotonic() + deadline
    while True:
        reason = ""
        try:
            answer = question()
        except Rejected as gone:  # a widget that was there a moment ago
            answer, reason = None, str(gone)
        if answer:
            return answer
        if time.monotonic() > end:
            raise Late("waited %g s in vain: %s %s" % (deadline, what, reason))
        time.sleep(STEP)
