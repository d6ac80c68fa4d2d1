# SPDX-License-Identifier: MIT
"""A render that is killed at any moment: the old file or the new one stands there whole, and nothing else stays.

LUXEL_KILLS sets how often (60 by default; a third of that for a picture of several strips).
"""
import os
import random
import signal
import subprocess
import time

from tap import Tap
from tool import run_tests

KILLS = int(os.environ.get("LUXEL_KILLS", "60"))


def contents(tool, names):
    return [tool.read(name) for name in names]


def kill_at_any_moment(tap, tool, size, names, kills):
    rng = random.Random(7)
    outputs = [part for name in names for part in ("-o", name)]
    tool.run("render", "-s", size, "-s", "lights[0].intensity=20", *outputs)
    new = contents(tool, names)
    begun = time.monotonic()
    tool.run("render", "-s", size, *outputs)
    seconds = time.monotonic() - begun
    old = contents(tool, names)
    torn, seen = [], {"old": 0, "new": 0}
    for i in range(kills):
        process = subprocess.Popen([tool.path, "render", "-q", "-s", size, "-s", "lights[0].intensity=20",
                                    *outputs], cwd=tool.folder, stdout=subprocess.DEVNULL)
        time.sleep(rng.uniform(0, 1.2 * seconds))
        process.send_signal(signal.SIGKILL)
        process.wait()
        for name, before, after in zip(names, old, new):
            now = tool.read(name)
            seen["new" if now == after else "old"] += 1
            if now not in (before, after):
                torn.append((i, name, len(now)))
        tool.run("render", "-s", size, *outputs)
    tap.equal(torn, [], "every file is the old one or the new one (%(old)d old, %(new)d new)" % seen)
    tap.equal(sorted(tool.files()), sorted(names), "and after the next run nothing else is there")


def killed_at_any_moment(tap, tool):
    kill_at_any_moment(tap, tool, "screen.resolution=[300, 300]", ["a.png", "a.npy", "a.exr", "a.csv"], KILLS)


def killed_between_strips(tap, tool):
    kill_at_any_moment(tap, tool, "screen.resolution=[1600, 1600]", ["a.npy", "a.pfm", "a.exr"], KILLS // 3)


run_tests(Tap(), killed_at_any_moment, killed_between_strips)
