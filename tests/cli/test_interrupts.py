# SPDX-License-Identifier: MIT
"""SIGINT and SIGTERM at any moment of long work: the tool ends at once with 130, or by the signal; each file is the old
one or the new one whole, and nothing else stays.

LUXEL_INTERRUPTS sets how often (20 by default); then the times from the signal to the end are printed.
"""
import os
import random
import signal
import statistics
import subprocess
import time

from tap import Tap
from tool import SCENE, run_tests

LIGHT = "  - {type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}\n"
PANEL = "  - {type: planar, rectangle: {center: [%d, 0, 2000], size: [200, 100]}, radiance: 1}\n"
ROWS = 200000


def with_lights(lights, side):
    return SCENE.replace(LIGHT, lights).replace("[36, 36]", "[%d, %d]" % (side, side))


def write_scenes(tool):
    rows = ("%d,%d.5,%d,0.001\n" % (i % 1999 - 999, i % 997 - 498, 1500 + i % 1009) for i in range(ROWS))
    tool.write("cloud.csv", "x,y,z,intensity\n" + "".join(rows))
    tool.write("cloud.yaml", with_lights("  - {type: points, file: cloud.csv}\n", 400))
    tool.write("long.yaml", with_lights(LIGHT * 300, 3000))
    tool.write("probe.yaml", with_lights("".join(PANEL % i for i in range(40)), 36).replace(
        "points: [[0, 0], [150, 0], [-150, 0]]", "points: [%s]" % ", ".join(
            "[%d, %d]" % (i % 100, i // 100) for i in range(3000))))
    tool.write("facets.yaml", with_lights("  - {type: volume, sphere: {center: [0, 0, 2000], radius: 9, facets: 1000}, "
                                          "power: 1}\n" * 40, 100))  # seconds before the first pixel


def work():
    """What is interrupted, and the files that it writes."""
    return [(["render", "long.yaml", "-o", "a.png", "-o", "a.npy"], ["a.png", "a.npy"]),
            (["render", "cloud.yaml", "-o", "a.exr"], ["a.exr"]), (["probe", "probe.yaml"], []),
            (["render", "facets.yaml", "-o", "a.csv"], ["a.csv"]), (["figure", "long.yaml", "-o", "f.png"], ["f.png"])]


def interrupted(tap, tool):
    rng = random.Random(11)
    write_scenes(tool)
    inputs, took, faults = tool.files(), [], []
    for i in range(int(os.environ.get("LUXEL_INTERRUPTS", "20"))):
        arguments, names = work()[i % len(work())]
        number = rng.choice([signal.SIGINT, signal.SIGTERM])
        for name in names:
            tool.write(name, "old")
        process = subprocess.Popen([tool.path, *arguments], cwd=tool.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        time.sleep(rng.choice([0.02, 0.2, 1]) * rng.random() + 0.02)
        over = process.poll() is not None
        process.send_signal(number)
        start = time.monotonic()
        _, err = process.communicate(timeout=10)
        took.append(time.monotonic() - start)
        kept = [tool.read(name) == b"old" for name in names]
        expected = {-number}  # SIGINT, too, before the program has begun
        if number == signal.SIGINT:
            expected.add(130)
        if not all(kept) or not names or over:  # it may have come to its end, or to its own words about that
            expected.add(0)
        if process.returncode not in expected or err or tool.files() != sorted(inputs + names):
            faults.append((arguments, number.name, process.returncode, err, tool.files()))
        for name in names:
            os.remove(tool.file(name))
    tap.equal(faults, [], "%d signals: it ends by each, and nothing is left" % len(took))
    if "LUXEL_INTERRUPTS" in os.environ:
        tap.note("from the signal to the end: median %.1f ms, worst %.1f ms" % (
            1000 * statistics.median(took), 1000 * max(took)))


run_tests(Tap(), interrupted)
