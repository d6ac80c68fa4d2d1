# SPDX-License-Identifier: MIT
"""The memory of luxel-app: little, and no more after thousands of changes."""
import re
import time

from desk import SANITIZED, luxel, trial
from waiting import wait

CHANGES = 10000
PATIENCE = 90  # seconds; where the machine is slow fewer changes must do
LARGEST, GROWTH = 200, 20  # MiB


def resident(app):
    """MiB of memory that are in use."""
    with open("/proc/%d/status" % app.process.pid, encoding="ascii") as file:
        return int(re.search(r"VmRSS:\s+(\d+) kB", file.read()).group(1)) / 1024


def many_changes(tap, desk):
    path = desk.path("large.yaml")
    with open(path, "wb") as file:
        file.write(luxel("scene", "report").replace(b"resolution: [360, 360]", b"resolution: [800, 800]"))
    app = desk.start(path)
    window = app.window()
    field = window.control("spin button", "Intensity")
    changes, end, first = 0, time.monotonic() + PATIENCE, None
    while changes < CHANGES and time.monotonic() < end:
        field.value = 10 + changes % 1000 / 100
        changes += 1
        if changes == 1000:
            first = resident(app)
    wait("the last number", lambda: window.control("spin button", "Intensity").value == 10 + (changes - 1) % 1000 / 100)
    last = resident(app)
    tap.note("%d changes; %s MiB after 1000, %.1f MiB in the end" % (changes, first, last))
    tap.ok(changes >= 1000, "changes are taken as fast as they come", changes)
    if SANITIZED:
        tap.skip("little memory", "sanitizers take their own")
        return
    tap.ok(last < LARGEST, "at 800 x 800 it takes less than %d MiB" % LARGEST, last)
    tap.ok(last - first < GROWTH, "and grows by less than %d MiB" % GROWTH, first, last)


trial(many_changes)
