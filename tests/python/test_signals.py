# SPDX-License-Identifier: MIT
"""Ctrl-C and progress: both end a computation at once, and leave all as it was."""
import signal
import subprocess
import sys
import threading
import time

from package import Tap, luxel, raises, run_tests
from tool import AT_ONCE

LONG = {"render": "scene.render(precision='double')", "probe": "scene.probe([(0, 0)] * 1000000)",
        "evaluate": "scene.evaluate(numpy.ones((4000000, 3)), numpy.ones(3))",
        "isophotes": "field.isophotes(50)", "grid": "scene.grid()"}
PROGRAM = """
import numpy, sys, time
import luxel
scene = luxel.Scene("window")
field = scene.render() if %(name)r == "isophotes" else None
scene.update({"screen.resolution": [9000, 9000], "grids": [{"center": [0, 0, 1], "size": [10, 10], "axis": [0, 0, 1],
    "up": [0, 1, 0], "n": [900, 900]}]})
print("ready", flush=True)
try:
    %(call)s
    print("done", flush=True)
except KeyboardInterrupt:
    print("interrupted", scene.probe((0, 0)).error is not None, flush=True)
"""


def test_interrupt(tap, tool):
    for name, call in LONG.items():
        process = subprocess.Popen([sys.executable, "-c", PROGRAM % {"name": name, "call": call}], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.readline()
        time.sleep(0.3)
        start = time.monotonic()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=120)
        tap.ok(out.startswith(("interrupted", "done")) and name != "render" or out.startswith("interrupted"),
               "Ctrl-C ends %s" % name, out, err)
        tap.ok(time.monotonic() - start < AT_ONCE, "%s: at once" % name)


def test_progress(tap, tool):
    scene = luxel.Scene("window").changed({"screen.resolution": [4000, 4000]})
    seen = []
    error = raises(luxel.LuxelError, scene.render, progress=lambda done: seen.append(done) or len(seen) < 3)
    tap.equal((error and error.status, len(seen)), ("cancelled", 3), "progress that returns False ends the work")
    tap.ok(all(0 <= a <= b <= 1 for a, b in zip(seen, seen[1:])), "it tells the share done", seen)

    def fail(done):
        raise RuntimeError("mine")

    tap.equal(str(raises(RuntimeError, scene.render, progress=fail)), "mine", "its exceptions come through")
    tap.ok(scene.changed({"screen.resolution": [4, 4]}).render(progress=fail), "a short work does not ask")


def test_other_threads(tap, tool):
    """In another thread than the main one signals are not looked for, but the work goes on."""
    scene = luxel.Scene("window").changed({"screen.resolution": [1500, 1500]})
    found = []
    thread = threading.Thread(target=lambda: found.append(scene.render()))
    thread.start()
    count = 0
    while thread.is_alive():
        count += 1
    tap.ok(found and count > 1000, "the lock is released while a picture is computed", "counted to %d" % count)


run_tests(Tap(), test_interrupt, test_progress, test_other_threads)
