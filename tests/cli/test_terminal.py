# SPDX-License-Identifier: MIT
"""What depends on a terminal: colour and NO_COLOR, progress with the time that is left, -q; and what -- ends."""
import os
import re
import sys
import time

from tap import Tap
from terminal import Terminal
from tool import SCENE, run_tests

PROGRESS = re.compile(r"\r *(\d+) %, (\d+) s left\x1b\[K")


def long_scene(side, lights):
    return SCENE.replace("[36, 36]", "[%d, %d]" % (side, side)).replace("lights:\n", "lights:\n" + "".join(
        "  - {type: point, position: [%d, 800, 2500], intensity: 1}\n" % i for i in range(lights)))


def on_terminal(tool, *arguments, seconds=120, **variables):
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "TERM": "xterm", **variables}
    terminal = Terminal([tool.path, *arguments], tool.folder, environment)
    try:
        return terminal.finish(seconds)
    finally:
        terminal.close()


def colour(tap, tool):
    tool.write("bad.yaml", SCENE.replace("radius: 200", "radius: -200"))
    tool.write("wide.yaml", SCENE.replace("radius: 200", "radius: 30"))
    for title, variables, expected in (
            ("a terminal", {}, True), ("NO_COLOR=1", {"NO_COLOR": "1"}, False),
            ("NO_COLOR=0", {"NO_COLOR": "0"}, False),
            ("an empty NO_COLOR", {"NO_COLOR": ""}, True), ("TERM=dumb", {"TERM": "dumb"}, False)):
        text, code = on_terminal(tool, "check", "bad.yaml", **variables)
        tap.equal(("\x1b[1;31merror:\x1b[0m" in text, "\x1b" in text, code), (expected, expected, 3),
                  "%s: an error in red" % title)
        text, code = on_terminal(tool, "check", "wide.yaml", **variables)
        tap.equal(("\x1b[1;34madvice:\x1b[0m" in text, "\x1b" in text, code), (expected, expected, 0),
                  "%s: advice in blue" % title)
    text, code = on_terminal(tool, "rendr")
    tap.ok(code == 2 and "luxel: \x1b[1;31merror:\x1b[0m unknown command" in text, "wrong usage in red", text)
    for arguments in ("check", "bad.yaml"), ("check", "wide.yaml"), ("rendr",):
        result = tool.run(*arguments, environment={"TERM": "xterm"})
        tap.ok("\x1b" not in result.out + result.err, "no colour without a terminal: " + " ".join(arguments), result)
    for arguments in ("render",), ("probe",), ("help", "render"), ("help", "radius"), ("scene", "--list"):
        text, code = on_terminal(tool, *arguments)
        tap.ok(code == 0 and "\x1b" not in text, "no colour in results: " + " ".join(arguments), text)


def progress(tap, tool):
    arguments = ("render", "long.yaml", "--precision", "double", "--threads", "1")
    for side, lights in (500, 120), (1000, 120), (2000, 120), (4000, 120), (4000, 500), (4000, 2000):  # machines differ
        tool.write("long.yaml", long_scene(side, lights))
        start = time.monotonic()
        text, code = on_terminal(tool, *arguments)
        seconds = time.monotonic() - start
        steps = PROGRESS.findall(text)
        if steps and seconds > 2.5:
            break
    if not tap.ok(code == 0 and steps, "progress is shown", "in %.1f s" % seconds, text[:2000]):
        return
    quiet, code = on_terminal(tool, *arguments, "-q")
    tap.ok(code == 0 and "s left" not in quiet and "\x1b" not in quiet, "-q: no progress", quiet)
    tap.ok("maximum" in quiet, "-q: the results")
    shares = [int(share) for share, _ in steps]
    tap.ok(shares == sorted(shares) and shares[-1] <= 100, "it goes on", shares)
    tap.ok(len(steps) <= 10 * seconds + 1, "not more often than ten times a second", len(steps), seconds)
    last = re.sub(r"\rcomputing for \d+ s\x1b\[K", "", PROGRESS.sub("", text))
    tap.ok(last.startswith("\r\x1b[K"), "its line is erased before the results", last[:80])
    tap.equal(last[len("\r\x1b[K"):].replace("\r\n", "\n"), quiet.replace("\r\n", "\n"), "the results are the same")
    text, _ = on_terminal(tool, *arguments, TERM="dumb")
    tap.ok("s left" not in text and "\x1b" not in text, "none on a terminal that cannot erase")
    result = tool.run(*arguments)
    tap.ok(not result.err, "none without a terminal", result.err)


def first_progress(tap, tool):
    """Nothing within the first second, then the share done and an honest guess of the time that is left."""
    tool.write("long.yaml", long_scene(16000, 500))
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "TERM": "xterm"}
    terminal = Terminal([tool.path, "render", "long.yaml", "--threads", "1"], tool.folder, environment)
    try:
        start = time.monotonic()
        share = int(terminal.wait_for(r"(\d+) %, \d+ s left", 60))
        after = time.monotonic() - start
        left = int(terminal.wait_for(r"%, (\d+) s left", 60))
        tap.ok(after >= 0.9, "the first after a second", "%.2f s" % after)
        tap.ok(share < 100 and left > 0, "its numbers", share, left)
        terminal.send("\x03")
        text, code = terminal.finish(20)
        tap.ok(code == 130 and text.endswith("\r\x1b[K"), "Ctrl-C erases it", code, repr(text[-80:]))
    finally:
        terminal.close()


HALL = """luxel: 1
units: photometric
reflections: all
screen: {width: 5000, height: 2500, resolution: [400, 200]}
observer: {position: [0, 1600, 3900], target: [0, 1200, 0]}
surfaces:
  - {type: room, center: [0, 1400, 2000], size: [6000, 2800, 4000],
     material: {model: lambert, diffuse: 0.7, over_pi: true}}
  - {type: sphere, center: [0, 600, 2000], radius: 500, material: {model: lambert, diffuse: 0.5, over_pi: true}}
lights:
  - {type: luminaire, file: lamp.ies, position: [-1500, 2800, 2000], axis: [0, -1, 0]}
  - {type: planar, rectangle: {center: [1500, 2700, 2000], size: [300, 300], axis: [0, -1, 0]}, radiance: 900}
grids: [{name: plane, center: [0, 750, 2000], size: [4000, 3000], axis: [0, 1, 0], up: [0, 0, -1], n: [20, 15]}]
"""
LAMP = "IESNA:LM-63-1995\nTILT=NONE\n1 1000 1 3 1 1 2 0.1 0.1 0\n1 1 10\n0 45 90\n0\n318 225 0\n"


def untold_progress(tap, tool):
    """Work that does not tell how far it is shows how long it has been going on, and never that all is done."""
    tool.write("hall.yaml", HALL)
    tool.write("lamp.ies", LAMP)
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "TERM": "xterm"}
    commands = [["glare", "hall.yaml", "--eye", "0,1200,3900,0,0,-1"], ["grid", "hall.yaml"]]
    if tool.run("figure", "-o", "f.png").code == 0:
        commands += [["figure", "hall.yaml", "--grid", "plane", "-o", "p.pdf"], ["report", "hall.yaml", "-o", "r.md"],
                     ["photometry", "lamp.ies", "--room", "4,8"]]
    for command in commands:
        more = [] if command[0] == "photometry" else ["--reflected-error", "1e-6"]
        terminal = Terminal([tool.path, *command, *more], tool.folder, environment)
        try:
            terminal.wait_for(r"(computing for [1-9]\d* s|\d %, \d+ s left)\x1b\[K", 30)
            terminal.wait_for(r"(computing for [1-9]\d* s|\d %, \d+ s left)\x1b\[K", 30)
            terminal.send("\x03")
            text, code = terminal.finish(20)
            tap.ok(code == 130 and "100 %" not in text, "luxel %s on a terminal" % command[0], code, repr(text[-80:]))
        finally:
            terminal.close()


def short_work(tap, tool):
    text, code = on_terminal(tool, "render", "report")
    tap.ok(code == 0 and "left" not in text and "\x1b" not in text, "no progress for short work", text)


def quiet(tap, tool):
    tool.write("good.yaml", SCENE.replace("[36, 36]", "[360, 360]"))
    tool.write("bare.yaml", SCENE.replace("points: [[0, 0], [150, 0], [-150, 0]]", "points: []"))
    tap.ok("valid" in tool.run("check", "good.yaml").out, "check confirms")
    tap.equal((tool.run("check", "good.yaml", "-q").out, tool.run("check", "good.yaml", "-q").err), ("", ""),
              "check -q does not")
    tap.ok("points" in tool.run("probe", "bare.yaml").err, "probe notes that there are no points")
    tap.equal(tool.run("probe", "bare.yaml", "-q").err, "", "probe -q does not")
    result = tool.run("render", "-q", "nosuch.yaml")
    tap.ok(result.code == 4 and "error:" in result.err, "errors are not quiet", result)
    result = tool.run("check", "-q", "good.yaml", "-s", "surfaces[0].radius=20")
    tap.ok(result.code == 0 and "advice" in result.out, "nor is advice, which is check's result", result)


def dashes(tap, tool):
    for name in "--json", "-q", "-s", "-x.yaml", "--":
        tool.write(name, SCENE.replace("[36, 36]", "[360, 360]"))
        result = tool.run("check", "--", name)
        tap.ok(result.code == 0 and name in result.out, "check -- " + name, result)
    tap.equal(tool.run("--", "check", "--json").code, 0, "-- before the command")
    tap.equal(tool.run("check", "-q", "--", "-x.yaml").out, "", "options before it count")
    result = tool.run("check", "--", "-x.yaml", "-q")
    tap.ok(result.code == 2 and "-q" in result.err, "what is behind it is no option", result)
    tap.ok(tool.run("check", "--").out.startswith("report"), "-- at the end")
    tap.equal(tool.run("render", "-s", "--", "report").code, 2, "an option's argument may be --")
    tap.equal(tool.run("check", "-").code, 3, "- alone is standard input")


if not hasattr(os, "waitstatus_to_exitcode"):
    sys.exit("Python 3.9 or newer is needed")
run_tests(Tap(), colour, short_work, progress, first_progress, untold_progress, quiet, dashes)
