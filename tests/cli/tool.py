# SPDX-License-Identifier: MIT
"""Runs luxel the way a shell does, for the tests of the command line."""
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

PATIENCE = float(os.environ.get("LUXEL_PATIENCE", 1))  # how much longer than usual a slow build may take
AT_ONCE = 10 * PATIENCE  # seconds: what is to end at once has so long, since a shared machine may stand still

SCENE = """\
luxel: 1
units: radiometric
screen: {width: 500, height: 500, resolution: [36, 36], sampling: nodes}
observer: {z: 1500, projection: orthographic, view: parallel}
surfaces:
  - type: sphere
    center: [0, 0, 1000]
    radius: 200
    material: {model: blinn-phong, diffuse: 0.8, specular: 0.5, shininess: 20, highlight: plain}
lights:
  - {type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}
points: [[0, 0], [150, 0], [-150, 0]]
picture: {range: max, rounding: truncate}
"""


def wait_until_caught(process, number=signal.SIGINT):
    """Waits until a program has begun so far that it catches a signal; without /proc it is believed to do so."""
    end = time.monotonic() + AT_ONCE
    while os.path.exists("/proc/self/status") and process.poll() is None and time.monotonic() < end:
        with open("/proc/%d/status" % process.pid, encoding="utf-8") as file:
            caught = [int(line.split()[1], 16) for line in file if line.startswith("SigCgt:")]
        if caught and caught[0] >> (number - 1) & 1:
            return
        time.sleep(0.005)


class Result:
    """What a run ended with."""

    def __init__(self, arguments, code, out, err, seconds):
        self.arguments, self.code, self.out, self.err, self.seconds = arguments, code, out, err, seconds

    def json(self):
        return json.loads(self.out, parse_constant=lambda word: self.fail("no JSON: " + word))

    def fail(self, reason):
        raise AssertionError("%s\n%s" % (reason, self))

    def __str__(self):
        return "luxel %s\nexit code %s after %.2f s\nstdout: %s\nstderr: %s" % (
            " ".join(self.arguments), self.code, self.seconds, self.out[:2000], self.err[:4000])


class Tool:
    """The executable named by the test's first argument, run inside a folder of its own."""

    def __init__(self, folder):
        self.path = os.path.abspath(sys.argv[1])
        self.folder = folder

    def run(self, *arguments, stdin="", environment=None, timeout=60, **more):
        variables = {**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": "", **(environment or {})}
        if "LUXEL_ISA" not in (environment or {}):
            variables.pop("LUXEL_ISA", None)
        if isinstance(stdin, str):
            stdin = stdin.encode("utf-8")
        start = time.monotonic()
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
        done = subprocess.run([self.path, *arguments], input=stdin, cwd=self.folder, env=variables,
                              timeout=timeout * PATIENCE, **streams)
        return Result(arguments, done.returncode, (done.stdout or b"").decode("utf-8"),
                      (done.stderr or b"").decode("utf-8", "replace"), time.monotonic() - start)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode("utf-8"))
        return name

    def file(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.file(name), "rb") as file:
            return file.read()

    def files(self):
        return sorted(os.listdir(self.folder))


@contextlib.contextmanager
def new_tool():
    """A tool in an empty folder, which vanishes afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        yield Tool(folder)


def run_tests(tap, *tests):
    """Calls each test with the tap and a tool of its own, and ends the process."""
    for test in tests:
        with new_tool() as tool:
            tap.run(test, tap, tool)
    tap.finish()
