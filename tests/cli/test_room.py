# SPDX-License-Identifier: MIT
"""luxel room: scenes that check well and keep their limits, arrays against a search by hand, and what is refused."""
import json
import math
import re

from luminaires import HEAD
from tap import Tap
from tool import run_tests

# 3600 lm by Lambert's law, as a table of every degree
LAMBERT = HEAD + "1 -1 1 91 1 1 2 .0 .0 0\n1 1 36\n%s\n0\n%s\n" % (
    " ".join(map(str, range(91))), " ".join(repr(3600 / math.pi * math.cos(math.radians(g))) for g in range(91)))
COARSE = ("--reflected-error", "0.01")  # which is fast
UPLIGHT = HEAD + "1 -1 1 3 1 1 2 .0 .0 0\n1 1 36\n0 90 180\n0\n100 100 100\n"


def average(tool, *options):
    """The mean of the room's work plane with an array, as the tool measures it."""
    made = tool.run("room", *options)
    assert made.code == 0, made
    return tool.run("grid", "-", "--json", *COARSE, stdin=made.out).json()["grids"][0]


def keeps_its_word(tap, tool):
    tool.write("lamp.ies", LAMBERT)
    tool.write("up.ies", UPLIGHT)
    for options in (("5,4,2.8", "--file", "lamp.ies", "--array", "2,1"),
                    ("3,1.51,2.4", "--file", "lamp.ies", "--array", "1,1", "--reflectances", "0.8,0.7,0.3"),
                    ("4,4,3", "--file", "up.ies", "--array", "1,1", "--maintenance", "0.67"),
                    ("6,4,3", "--array", "3,2", "--reflectances", "0,0,0")):
        options += COARSE
        made = tool.run("room", *options, "-o", "room.yaml")
        tap.ok(made.code == 0 and "luminaires: average" in made.out and not made.err, "made: %s" % (options,), made)
        checked = tool.run("check", "room.yaml", "--strict")
        tap.ok(checked.code == 0 and not checked.err, "checks silently", checked)
        judged = tool.run("grid", "room.yaml", "--limits", "--json", *COARSE)
        tap.ok(judged.code == 0, "keeps its limits", judged)
        limits = {limit["name"]: limit["wanted"] for limit in judged.json()["grids"][0]["limits"]}
        tap.ok(limits["average"] > 0, "limits are written", limits)
    drawn = tool.run("render", "room.yaml", "-s", "reflections=none", "-o", "room.png")
    tap.ok(drawn.code == 0 and "max" in drawn.out, "it can be drawn", drawn)
    printed = tool.run("room", "5,4,3", "--array", "1,2", "--reflectances", "0,0,0")
    tool.run("room", "5,4,3", "--array", "1,2", "--reflectances", "0,0,0", "-o", "room.yaml")
    with open(tool.folder + "/room.yaml", encoding="utf-8") as file:
        tap.equal(file.read(), printed.out, "a file has what standard output has")


def as_asked(tap, tool):
    tool.write("lamp.ies", LAMBERT)
    made = tool.run("room", "7.2,4.8,2.8", "--file", "lamp.ies", "--array", "5,2", "--reflectances", "0.6,0.4,0.1",
                    "--plane", "0.7", "--maintenance", "0.9", "-o", "room.yaml", *COARSE)
    assert made.code == 0, made
    for key, wanted in (("surfaces[0].size", [7200, 4800, 2800]), ("surfaces[0].center", [0, 0, 1400]),
                        ("surfaces[0].materials.ceiling.diffuse", 0.6), ("surfaces[0].material.diffuse", 0.4),
                        ("surfaces[0].materials.floor.diffuse", 0.1), ("maintenance_factor", 0.9),
                        ("lights[0].array.n", [5, 2]), ("lights[0].array.spacing", [1440, 2400]),
                        ("lights[0].position", [0, 0, 2800]), ("grids[0].center", [0, 0, 700]),
                        ("grids[0].size", [6200, 3800])):
        text = tool.run("set", "room.yaml", "-n", "%s=%s" % (key, json.dumps(wanted)))
        with open(tool.folder + "/room.yaml", encoding="utf-8") as file:
            tap.equal(text.out, file.read(), key)
    tool.write("up.ies", UPLIGHT)
    text = tool.run("room", "6,4,3", "--file", "up.ies", "--array", "1,1", *COARSE).out
    tap.ok("position: [0, 0, 2500]" in text, "what lights the ceiling hangs below it", text)


def direct_by_hand(tap, tool):
    """Nine lamps that shine by Lambert's law as points, without reflections: 3600 lm, maintenance .8."""
    tool.write("lamp.ies", LAMBERT)
    for n in ((3, 3), (5, 2), (3, 4), (4, 3)):
        grid = average(tool, "7.2,4.8,2.8", "--file", "lamp.ies", "--array", "%d,%d" % n, "--reflectances", "0,0,0")
        columns, rows = grid["n"]
        truth = []
        for row in range(rows):
            for column in range(columns):
                x, y = ((column + .5) / columns - .5) * 6.2, ((row + .5) / rows - .5) * 3.8
                truth.append(sum(0.8 * 3600 / math.pi * 2.05 ** 2 / (
                    (x - ((i + .5) / n[0] - .5) * 7.2) ** 2 + (y - ((k + .5) / n[1] - .5) * 4.8) ** 2 + 2.05 ** 2) ** 2
                    for i in range(n[0]) for k in range(n[1])))
        mean = sum(truth) / len(truth)
        tap.near(grid["average"], mean, 2e-4, "the mean of %d x %d by hand" % n)
        tap.near(grid["u0"], min(truth) / mean, 2e-4, "and its uniformity")


def fewest(tap, tool):
    tool.write("lamp.ies", LAMBERT)
    for size, target, reflectances in (("7.2,4.8,2.8", 300, "0,0,0"), ("4,3,3", 300, "0.7,0.5,0.2")):
        x, y = map(float, size.split(",")[:2])
        room = (size, "--file", "lamp.ies", "--reflectances", reflectances, *COARSE)
        made = tool.run("room", *room, "--target", str(target), "-o", "room.yaml")
        found = re.match(r"(\d+) × (\d+) = (\d+) luminaires: average ([\d.]+)", made.out)
        n = int(found[1]), int(found[2])
        tap.ok(tool.run("grid", "room.yaml", "--limits", *COARSE).code == 0, "it reaches the target", made)
        # every even array of fewer lamps, and of as many
        means = {}
        for columns in range(1, n[0] * n[1] + 1):
            for rows in range(1, n[0] * n[1] // columns + 1):
                wide, deep = x / columns, y / rows
                if max(wide, deep) <= 2 * min(wide, deep) * (1 + 1e-9):
                    means[columns, rows] = average(tool, *room, "--array", "%d,%d" % (columns, rows))
        for (columns, rows), grid in means.items():
            if columns * rows < n[0] * n[1]:
                tap.ok(grid["average"] < target, "%d x %d is too few" % (columns, rows), grid["average"])
            elif grid["average"] >= target:
                tap.ok(grid["u0"] <= means[n]["u0"], "%d x %d is the more even one" % n, (columns, rows))
        smaller = re.search(r"(\d+) × (\d+) = (\d+), the next smaller array: average ([\d.]+)", made.out)
        below = max(columns * rows for columns, rows in means if columns * rows < n[0] * n[1])
        tap.equal(int(smaller[3]), below, "the next smaller one")
        tap.near(float(smaller[4]), means[int(smaller[1]), int(smaller[2])]["average"], 1e-2, "and what it gives")
        tap.equal(tool.run("room", *room, "--target", str(target), "--threads", "1").out,
                  tool.run("room", *room, "--target", str(target), "--threads", "3").out, "for any number of threads")


def files(tap, tool):
    tool.write("lamp.ies", LAMBERT)
    tool.run("variant", "1", "-o", "there.yaml")
    for file, output, written in (("lamp.ies", "room.yaml", "file: lamp.ies"), ("lamp.ies", "./room.yaml", "/lamp.ies"),
                                  ("./lamp.ies", "./room.yaml", "file: lamp.ies")):
        made = tool.run("room", "6,4,3", "--file", file, "--array", "2,2", "-o", output, *COARSE)
        with open(tool.folder + "/room.yaml", encoding="utf-8") as stream:
            text = stream.read()
        tap.ok(made.code == 0 and written in text and tool.run("check", output).code == 0,
               "%s from %s" % (file, output), made, text)


def refused(tap, tool):
    tool.write("up.ies", HEAD + "1 -1 1 2 1 1 2 .0 .0 0\n1 1 36\n90 180\n0\n100 100\n")
    for options, code, words in (((), 2, "metres"), (("8,6",), 2, "form is luxel room X,Y,Z,"),
                                 (("8,6,0",), 2, "lengths"),
                                 (("8,6,2.8", "--plane", "3"), 2, "work plane"),
                                 (("8,6,2.8", "--reflectances", "1,0.5,0.2"), 2, "reflectances"),
                                 (("8,6,2.8", "--reflectances", "0.5,0.2"), 2, "C,W,F"),
                                 (("8,6,2.8", "--maintenance", "0"), 2, "maintenance"),
                                 (("8,6,2.8", "--array", "3"), 2, "N,M"), (("8,6,2.8", "--array", "0,2"), 2, "--array"),
                                 (("8,6,2.8", "--target", "-5"), 2, "--target"),
                                 (("8,6,2.8", "--target", "1e9"), 2, "no regular array of up to 10000 luminaires"),
                                 (("8,6,2.8", "--file", "none.ies"), 4, "none.ies"),
                                 (("6,4,3", "--file", "up.ies", "--reflectances", "0,0,0"), 2, "no light"),
                                 (("6,4,3", "-o", "room.png"), 2, "room.png")):
        result = tool.run("room", *options)
        tap.ok(result.code == code and words in result.err and not result.out,
               "refused: luxel room %s" % " ".join(options), result)


run_tests(Tap(), keeps_its_word, as_asked, direct_by_hand, fewest, files, refused)
