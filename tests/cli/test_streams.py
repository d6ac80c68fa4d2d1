# SPDX-License-Identifier: MIT
"""Standard streams, signals and locales: outputs that fail, Ctrl-C, languages with a decimal comma."""
import os
import signal
import subprocess
import time

from tap import Tap
from tool import AT_ONCE, PATIENCE, SCENE, run_tests, wait_until_caught

GRIDS = "grids=[{center: [0,0,2000], size: [100,100], n: [3,2]}]"
COMMANDS = [("render",), ("render", "--json"), ("probe",), ("probe", "--json"), ("grid", "-s", GRIDS),
            ("grid", "-s", GRIDS, "--json"), ("check",), ("check", "--json"),
            ("scene",), ("scene", "--list"), ("help",), ("help", "radius"), ("--version",), ()]


def stdout_that_fails(tap, tool):
    for arguments in COMMANDS:
        name = "luxel " + " ".join(arguments)
        with open("/dev/full", "w") as full:
            result = tool.run(*arguments, stdout=full)
        tap.ok(result.code == 4 and "standard output" in result.err, name + ": a full disk", result)
        result = tool.run(*arguments, stdout=None, preexec_fn=lambda: os.close(1))
        tap.ok(result.code == 4 and "standard output" in result.err, name + ": closed", result)
        reading, writing = os.pipe()
        os.close(reading)
        result = tool.run(*arguments, stdout=writing)
        os.close(writing)
        tap.ok((result.code, result.err) == (0, ""), name + ": a reader who left has seen enough", result)


def files_come_first(tap, tool):
    result = tool.run("render", "-o", "a.png", "-o", "b.npy", stdout=None, preexec_fn=lambda: os.close(1))
    tap.equal((result.code, tool.files()), (4, ["a.png", "b.npy"]), "files are written though stdout is closed")
    tap.ok(tool.read("a.png").startswith(b"\x89PNG") and tool.read("b.npy").startswith(b"\x93NUMPY"),
           "and nothing else stands in them")
    closed = tool.run("render", "-o", "c.png", stdout=None, preexec_fn=lambda: [os.close(i) for i in range(3)])
    tap.equal((closed.code, tool.read("c.png") == tool.read("a.png")), (4, True), "with all streams closed")
    result = tool.run("render", "-o", "d.png", preexec_fn=lambda: os.close(2))
    tap.equal((result.code, tool.read("d.png") == tool.read("a.png")), (0, True), "with stderr closed")


def stdin_that_fails(tap, tool):
    result = tool.run("render", "-", preexec_fn=lambda: os.close(0))
    tap.ok(result.code == 4 and "standard input" in result.err, "standard input is closed", result)
    reader, writer = os.pipe()
    os.close(writer)
    folder = os.open(tool.folder, os.O_RDONLY)
    result = tool.run("render", "-", preexec_fn=lambda: os.dup2(folder, 0))
    os.close(folder)
    os.close(reader)
    tap.ok(result.code == 4 and "standard input" in result.err, "standard input is a folder", result)
    tap.equal(tool.run("render", "/dev/stdin", "--json", stdin=SCENE).code, 0, "/dev/stdin is a file")


def interrupts(tap, tool):
    tool.write("long.yaml", SCENE.replace("[36, 36]", "[16384, 16384]").replace(
        "lights:\n", "lights:\n" + "  - {type: point, position: [500, 800, 2500], intensity: 1}\n" * 500))
    for seconds in 0.05, 0.5, 1.5:
        process = subprocess.Popen([tool.path, "render", "long.yaml", "-o", "x.npy", "-o", "x.png"], cwd=tool.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_caught(process)
        time.sleep(seconds * PATIENCE)
        process.send_signal(signal.SIGINT)
        start = time.monotonic()
        out, err = process.communicate(timeout=120)
        took = time.monotonic() - start
        if process.returncode == 3:
            tap.skip("interrupted after %g s" % seconds, "this machine cannot hold the picture")
            continue
        tap.equal((process.returncode, out, tool.files()), (130, b"", ["long.yaml"]),
                  "interrupted after %g s" % seconds)
        tap.ok(took < AT_ONCE, "it ends soon", "%.2f s" % took, err)
    process = subprocess.Popen([tool.path, "render", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    wait_until_caught(process)
    time.sleep(0.2 * PATIENCE)
    process.send_signal(signal.SIGINT)
    tap.equal(process.wait(timeout=10), 130, "interrupted while it waits for standard input")


def locales(tap, tool):
    known = subprocess.run(["locale", "-a"], capture_output=True, encoding="utf-8").stdout.split()
    plain = {command: tool.run(*command, environment={"LC_ALL": "C"}).out for command in COMMANDS}
    for name in "ru_RU.utf8", "de_DE.utf8", "fr_FR.utf8", "C.utf8", "nonsense":
        if name not in known and name != "nonsense":
            tap.skip("LC_ALL=" + name, "not installed")
            continue
        environment = {"LC_ALL": name, "LANGUAGE": name[:2]}
        for command, out in plain.items():
            if not name.startswith("ru") or "--json" in command:  # Russian texts have their own test
                result = tool.run(*command, environment=environment)
                tap.ok(result.out == out, "LC_ALL=%s %s" % (name, " ".join(command)), result)
        result = tool.run("probe", "-p", "1,5", "--json", environment=environment)
        tap.equal(result.json()["points"][0]["screen"], [1, 5], "LC_ALL=%s: 1,5 is two numbers" % name)
        result = tool.run("probe", "-p", "1.5,-0.25", "--json", environment=environment)
        tap.equal(result.json()["points"][0]["screen"], [1.5, -0.25], "LC_ALL=%s: 1.5 is one" % name)


def runs_repeat(tap, tool):
    for command in COMMANDS:
        tap.ok(tool.run(*command).out == tool.run(*command).out, "twice the same: luxel " + " ".join(command))


run_tests(Tap(), stdout_that_fails, files_come_first, stdin_that_fails, interrupts, locales, runs_repeat)
