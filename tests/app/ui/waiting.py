# SPDX-License-Identifier: MIT
"""Waiting by asking again and again; the deadline is only there so that a broken program does not hang a test."""
import time

from accessible import Rejected

DEADLINE = 120  # seconds
STEP = 0.05  # between two questions, or as long as the question took: who is asked has other work


class Late(AssertionError):
    """Something did not come to pass before the deadline."""


def wait(what, question, deadline=DEADLINE):
    """Asks until the answer is true, and gives it."""
    end = time.monotonic() + deadline
    while True:
        reason, start = "", time.monotonic()
        try:
            answer = question()
        except Rejected as gone:  # a widget that was there a moment ago
            answer, reason = None, str(gone)
        if answer:
            return answer
        now = time.monotonic()
        if now > end:
            raise Late("waited %g s in vain: %s %s" % (deadline, what, reason))
        time.sleep(max(STEP, now - start))
