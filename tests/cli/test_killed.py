# SPDX-License-Identifier: MIT
"""A render that is killed at any moment: the old file or the new one stands there whole, and nothing else stays.

LUXEL_KILLS sets how often (60 by default).
"""
import os
import random
import signal
import subprocess
import time

from tap import Tap
from tool import run_tests

NAMES = ["a.png", "a.npy", "a.exr", "a.csv"]
SIZE = "screen.resolution=[300, 300]"


def outputs():
    return [part for name in NAMES for part in ("-o", name)]


def contents(tool):
    return [tool.read(name) for name in NAMES]


def killed_at_any_moment(tap, tool):
    rng = random.Random(7)
    tool.run("render", "-s", SIZE, "-s", "lights[0].intensity=20", *outputs())
    new = contents(tool)
    begun = time.monotonic()
    tool.run("render", "-s", SIZE, *outputs())
    seconds = time.monotonic() - begun
    old = contents(tool)
    torn, seen = [], {"old": 0, "new": 0}
    for i in range(int(os.environ.get("LUXEL_KILLS", "60"))):
        process = subprocess.Popen([tool.path, "render", "-q", "-s", SIZE, "-s", "lights[0].intensity=20",
                                    *outputs()], cwd=tool.folder, stdout=subprocess.DEVNULL)
        time.sleep(rng.uniform(0, 1.2 * seconds))
        process.send_signal(signal.SIGKILL)
        process.wait()
        for name, before, after in zip(NAMES, old, new):
            now = tool.read(name)
            seen["new" if now == after else "old"] += 1
            if now not in (before, after):
                torn.append((i, name, len(now)))
        tool.run("render", "-s", SIZE, *outputs())
    tap.equal(torn, [], "every file is the old one or the new one (%(old)d old, %(new)d new)" % seen)
    tap.equal(sorted(tool.files()), sorted(NAMES), "and after the next run nothing else is there")


run_tests(Tap(), killed_at_any_moment)
