# SPDX-License-Identifier: MIT
"""luxel grid: its numbers against closed ones and a model with 50 digits, its text, JSON and CSV, what it refuses."""
import csv
import io
import json
import math
import re
import os
import random
import signal
import subprocess
import time

import mpmath
from mpmath import mpf

from tap import Tap
from tool import AT_ONCE, run_tests, wait_until_caught

mpmath.mp.dps = 50

TOP = ["quantity", "unit", "grids", "conventions"]
GRID = ["name", "center", "size", "axis", "up", "n", "average", "minimum", "maximum", "extrema", "u0", "ud", "flux",
        "flux_unit", "flux_error", "mean", "mean_error", "error", "average_error", "sampling_error",
        "sampling_error_is", "coarse", "measured", "inside", "values", "errors"]


def scene(lights, grids, units="radiometric", **more):
    """The text of a scene whose surface is out of the way."""
    return json.dumps({
        "luxel": 1, "units": units, "shadows": "none",
        "screen": {"width": 100, "height": 100, "resolution": [8, 8]}, "observer": {"z": 20000},
        "surfaces": [{"type": "sphere", "center": [0, 0, 9000], "radius": 10}],
        "lights": lights, "grids": grids, **more})


LAMP = {"type": "point", "pattern": "lambertian", "position": [0, 0, 3000], "intensity": 1000}
FLOOR = {"name": "floor", "center": [0, 0, 0], "size": [3500, 3500], "n": [7, 7]}


def closed_numbers(tap, tool):
    """CIE 171:2006, 5.2, by the cells of a plane; the values are those of the reference cases."""
    path = os.path.join(os.path.dirname(__file__), "..", "reference", "cases.json")
    with open(path, encoding="utf-8") as file:
        case, = [case for case in json.load(file)["cases"] if case["id"] == "cie171-5.2"]
    result = tool.run("grid", "-", "--json", stdin=scene([LAMP], [FLOOR], "photometric"))
    tap.equal((result.code, result.err), (0, ""), "grid --json")
    answer = result.json()
    grid, = answer["grids"]
    tap.equal(list(answer), TOP, "members of the answer")
    tap.equal(list(grid), GRID, "members of a grid")
    tap.equal((answer["quantity"], answer["unit"]), ("irradiance", "lx"), "heading")
    tap.equal([grid[key] for key in ("name", "center", "size", "axis", "up", "n", "measured")],
              ["floor", [0, 0, 0], [3500, 3500], [0, 0, 1], [0, 1, 0], [7, 7], 49], "the plane")
    for (x, y, *_), expected in zip(case["elements"], case["expect"]):
        column, row = round(x / 500 + 3), round(3 - y / 500)
        tap.near(grid["values"][row][column], expected, 1e-12, "at (%g, %g)" % (x, y))
    values = [value for row in grid["values"] for value in row]
    errors = [error for row in grid["errors"] for error in row]
    tap.equal([len(grid["values"]), {len(row) for row in grid["values"]}], [7, {7}], "rows of columns")
    tap.near(grid["average"], math.fsum(values) / 49, 1e-15, "average")
    tap.equal((grid["minimum"]["value"], grid["minimum"]["cell"], grid["minimum"]["position"]),
              (min(values), [0, 0], [-1500, 1500, 0]), "minimum, the first of four equal ones")
    tap.equal((grid["maximum"]["value"], grid["maximum"]["cell"]), (max(values), [3, 3]), "maximum")
    tap.near(grid["u0"], min(values) / grid["average"], 1e-15, "u0")
    tap.near(grid["ud"], min(values) / max(values), 1e-15, "ud")
    tap.near(grid["flux"], grid["mean"] * 12.25, 1e-15, "flux")
    tap.near(grid["mean"], grid["average"], 1e-2, "mean of the plane")
    gap = abs(grid["average"] - grid["mean"])
    tap.ok(gap <= grid["sampling_error"] <= gap + 1e-9, "the sampling error is how far they are apart", grid)
    tap.equal((grid["sampling_error_is"], grid["coarse"], grid["inside"]), ("bound", False, 0), "and is known")
    tap.equal((grid["flux_unit"], grid["error"]), ("lm", max(errors)), "its unit, and the largest error")
    tap.ok(all(0 <= error <= 1e-13 * value for error, value in zip(errors, values)), "bounds of the errors", errors)


def closed_room(tap, tool):
    """CIE 171:2006, 5.4: all that a source sends out falls on the walls of a closed room."""
    walls = [{"center": [0, 0, 0], "size": [4000, 4000], "axis": [0, 0, 1], "n": [80, 80]},
             {"center": [0, 0, 3000], "size": [4000, 4000], "axis": [0, 0, -1], "n": [80, 80]}]
    for x, y in (1, 0), (-1, 0), (0, 1), (0, -1):
        walls.append({"center": [2000 * x, 2000 * y, 1500], "size": [4000, 3000], "axis": [-x, -y, 0],
                      "up": [0, 0, 1], "n": [80, 60]})
    lamp = {"type": "point", "position": [0, 0, 1500], "intensity": 10000 / (4 * math.pi)}
    answer = tool.run("grid", "-", "--json", stdin=scene([lamp], walls, "photometric")).json()
    tap.near(sum(grid["flux"] for grid in answer["grids"]), 10000, 1e-12, "the flux over six walls")


def extended(tap, tool):
    """A disk and a square on the ceiling: closed numbers, cells on the source and beside it, and integrals."""
    disk = {"type": "planar", "disk": {"center": [0, 0, 2000], "radius": 500}, "radiance": 100}
    ceiling = {"center": [0, 0, 2000], "size": [3000, 3000], "axis": [0, 0, -1], "n": [3, 3]}
    below = {"center": [0, 0, 0], "size": [10, 10], "n": [1, 1]}
    first, second = tool.run("grid", "-", "--json", stdin=scene([disk], [below, ceiling])).json()["grids"]
    tap.near(first["values"][0][0], math.pi * 100 * 0.25 / 4.25, 1e-12, "below the centre of a disk")
    tap.equal((second["values"], second["measured"]), ([[0, 0, 0], [0, None, 0], [0, 0, 0]], 8), "in the disk's plane")

    planes = [ceiling, {**ceiling, "up": [1, 2, 0]}]
    beside = tool.run("grid", "-", "--tolerance", "1e-12", stdin=scene([disk], planes))
    tap.equal(beside.code, 0, "the rounding of a dark plane is no tolerance missed")
    edge = {"type": "spot", "position": [0, 0, 1000], "intensity": 5, "inner": 45, "outer": 45, "falloff": "hard"}
    doubt = tool.run("grid", "-", "--tolerance", "1e-3", "--json",
                     stdin=scene([edge], [{"center": [1000, 0, 0], "size": [1, 1], "n": [1, 1]}]))
    tap.equal((doubt.code, doubt.json()["grids"][0]["error"] > 1), (5, True), "a cell on the edge of a cone is one")

    lamp = {"type": "planar", "rectangle": {"center": [500, -300, 3000], "size": [1000, 600]}, "power": 10000}
    walls = [{"center": [0, 0, 0], "size": [4000, 4000], "n": [80, 80]}]
    for x, y in (1, 0), (-1, 0), (0, 1), (0, -1):
        walls.append({"center": [2000 * x, 2000 * y, 1500], "size": [4000, 3000], "axis": [-x, -y, 0],
                      "up": [0, 0, 1], "n": [80, 60]})
    answer = tool.run("grid", "-", "--json", stdin=scene([lamp], walls, "photometric")).json()
    tap.near(sum(grid["flux"] for grid in answer["grids"]), 10000, 1e-8, "the flux of a square lamp over its room")

    soft = {**lamp, "attenuation": "practical", "k": 500}
    tool.write("soft.yaml", scene([soft], [{"center": [0, 0, 0], "size": [4000, 4000], "n": [4, 3]}]))
    result = tool.run("grid", "soft.yaml", "--json", "--tolerance", "1e-6")
    grid, = result.json()["grids"]
    tap.equal((result.code, grid["flux"], result.json()["unit"]), (0, None, "relative"), "an integral")
    tap.ok(0 < grid["error"] <= 1e-6 * grid["maximum"]["value"], "to the tolerance", grid["error"])
    x, y, z = grid["maximum"]["position"]
    probe = tool.run("probe", "soft.yaml", "--quantity", "irradiance", "--json", "--at", "%r,%r,%r,0,0,1" % (x, y, z))
    tap.near(grid["maximum"]["value"], probe.json()["points"][0]["value"], 1e-6, "as a probe has it")


def unit(v):
    length = mpmath.sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def true_values(grid, lamps):
    """The irradiance of each cell by point sources, with 50 digits from the numbers of the scene."""
    axis = unit([mpf(c) for c in grid["axis"]])
    across = unit(cross([mpf(c) for c in grid["up"]], axis))
    upward = cross(axis, across)
    columns, rows = grid["n"]
    for row in range(rows):
        for column in range(columns):
            u = mpf(grid["size"][0]) * (2 * column + 1 - columns) / (2 * columns)
            v = -mpf(grid["size"][1]) * (2 * row + 1 - rows) / (2 * rows)
            place = [mpf(c) + u * a + v * b for c, a, b in zip(grid["center"], across, upward)]
            total = mpf(0)
            for lamp in lamps:
                way = [(mpf(c) - p) / 1000 for c, p in zip(lamp["position"], place)]
                r = mpmath.sqrt(dot(way, way))
                total += mpf(lamp["intensity"]) * max(0, dot(way, axis)) / r ** 3
            yield row, column, place, total


def honest_errors(tap, tool):
    chance = random.Random(7)
    wrong, loose, cells = [], [], 0
    for _ in range(30):
        def vector(size):
            return [chance.uniform(-size, size) for _ in range(3)]
        size = 10 ** chance.uniform(0, 4)
        grid = {"center": vector(2000), "size": [size, size * chance.uniform(0.1, 2)], "axis": vector(1),
                "up": vector(1), "n": [chance.randint(1, 4), chance.randint(1, 4)]}
        lamps = [{"type": "point", "position": vector(3000), "intensity": chance.uniform(0.1, 1000)}
                 for _ in range(chance.randint(1, 3))]
        near = chance.random() < 0.5  # a lamp that stands so near to a cell that the rounding of its place counts
        if near:
            _, _, place, _ = chance.choice(list(true_values(grid, [])))
            size = 10 ** chance.uniform(-9, -3)
            lamps[0]["position"] = [float(c) + chance.uniform(-size, size) for c in place]
        result = tool.run("grid", "-q", "-", "-o", "a.csv", stdin=scene(lamps, [grid]))
        if (result.code, result.err) != (0, ""):
            wrong.append(result)
            continue
        lines = list(csv.reader(io.StringIO(tool.read("a.csv").decode("utf-8"))))[1:]
        for line, (row, column, place, truth) in zip(lines, true_values(grid, lamps)):
            value, error = float(line[6]), float(line[7])
            cells += 1
            if (line[1], line[2]) != (str(column), str(row)) or not abs(mpf(value) - truth) <= error:
                wrong.append((grid, line, truth))
            if any(abs(mpf(float(text)) - c) > 1e-8 for text, c in zip(line[3:6], place)):
                wrong.append(("place", grid, line))
            if not near and truth > 0 and error > 1e-10 * truth + 1e-13:
                loose.append((grid, line, truth))
    tap.ok(not wrong, "|value - truth| <= error in all of %d cells" % cells, *wrong[:3])
    tap.ok(not loose, "the errors are small", *loose[:3])


def text(tap, tool):
    result = tool.run("grid", "-", stdin=scene([LAMP], [FLOOR, {"center": [0, 0, 100], "size": [10, 10], "n": [1, 2]}],
                                               "photometric"))
    tap.equal((result.code, result.err), (0, ""), "grid")
    for part in ("<stdin>: illuminance in lx", "floor: 7 × 7 cells, 3500.0 × 3500.0 mm around (0.0, 0.0, 0.0)",
                 "normal (0, 0, 1), up (0, 1, 0)", "111.11", "49.383", "grid 2: 1 × 2 cells", "U0 = minimum / average",
                 "Ud = minimum / maximum", "(lm)", "(3, 3)", "(-1500.0, 1500.0, 0.0)", "Conventions:"):
        tap.ok(part in result.out, "the text has " + part, result)
    large = tool.run("grid", "-", stdin=scene([LAMP], [{**FLOOR, "n": [21, 1]}]))
    tap.ok("--json" in large.out and ".csv" in large.out and "average" in large.out, "a grid too large to print", large)
    tap.ok("too many" not in tool.run("grid", "-", stdin=scene([LAMP], [{**FLOOR, "n": [20, 100]}])).out,
           "one that is just small enough")
    hostile = tool.run("grid", "-", stdin=scene([], [{**FLOOR, "name": "a\x85b"}]))
    tap.ok("\x85" not in hostile.out, "names are escaped", hostile)
    dark = tool.run("grid", "-", stdin=scene([], [FLOOR]))
    tap.ok(dark.code == 0 and "none" in dark.out, "a dark plane has no evenness", dark)


def on_a_source(tap, tool):
    grid = {"center": [0, 0, 0], "size": [30, 30], "n": [3, 3]}
    lights = [{"type": "ambient", "irradiance": 2}, {"type": "point", "position": [10, 0, 0], "intensity": 1}]
    tool.write("a.yaml", scene(lights, [grid, {**grid, "center": [10, 0, 0], "n": [1, 1]}]))
    result = tool.run("grid", "a.yaml", "--json")
    first, second = result.json()["grids"]
    tap.equal(result.code, 0, "a source on a cell")
    tap.equal(first["values"], [[2, 2, 2], [2, 2, None], [2, 2, 2]], "has no value")
    tap.equal((first["measured"], first["average"], first["flux"], first["flux_unit"]), (8, 2, None, None),
              "and is left out of the statistics")
    tap.equal([second[key] for key in ("measured", "values", "average", "minimum", "maximum", "u0", "ud", "error")],
              [0, [[None]], None, None, None, None, None, None], "a grid without any value")
    spoken = tool.run("grid", "a.yaml")
    tap.ok("1 cell lies on a source, lights[1], and has no value" in spoken.out and " -" in spoken.out, "the text",
           spoken)
    tool.run("grid", "a.yaml", "-o", "a.csv")
    lines = tool.read("a.csv").decode("utf-8").splitlines()
    tap.equal((lines[0], lines[5], lines[6]), (
        "grid,column,row,x_mm,y_mm,z_mm,irradiance_W/m²,error_W/m²", "grid 1,1,1,0,0,0,2," + lines[5].split(",")[-1],
        "grid 1,2,1,10,0,0,,"), "the CSV file")


def tables(tap, tool):
    odd = 'a "b", c'
    tool.write("a.yaml", scene([LAMP], [FLOOR, {**FLOOR, "name": odd, "axis": [1, 2, 3], "n": [2, 3]},
                                        {"center": [0, 0, 9], "size": [1, 2], "n": [1, 1]}]))
    result = tool.run("grid", "-q", "a.yaml", "-o", "a.csv", "-o", "b.CSV", "--json")
    tap.equal((result.code, result.err, tool.files()), (0, "", ["a.csv", "a.yaml", "b.CSV"]), "-o FILE.csv")
    tap.ok(tool.read("a.csv") == tool.read("b.CSV"), "twice the same")
    rows = list(csv.reader(io.StringIO(tool.read("a.csv").decode("utf-8"))))
    tap.equal(len(rows), 1 + 49 + 6 + 1, "a line for each cell")
    tap.equal([row[0] for row in rows[1:]], ["floor"] * 49 + [odd] * 6 + ["grid 3"], "names")
    expected = [(value, error) for grid in result.json()["grids"] for values, errors in
                zip(grid["values"], grid["errors"]) for value, error in zip(values, errors)]
    tap.equal([(float(row[6]), float(row[7])) for row in rows[1:]], expected, "the numbers read back as the same ones")
    tap.equal([row[1:3] for row in rows[50:56]], [[column, row] for row in "012" for column in "01"],
              "columns and rows")
    for names, words in ((["a.png"], "a.png .csv"), (["a"], "a .csv"), (["c.csv", "./c.csv"], "same file"),
                         (["c.csv", "d.npy"], "d.npy .csv")):
        bad = tool.run("grid", "a.yaml", *[word for name in names for word in ("-o", name)])
        tap.ok(bad.code == 2 and not bad.out and all(word in bad.err for word in words.split(" ")),
               "refused: " + " ".join(names), bad)
    gone = tool.run("grid", "a.yaml", "-o", "gone/c.csv", "-o", "d.csv", "--json")
    tap.equal((gone.code, gone.out == result.out, tool.files()), (4, True, ["a.csv", "a.yaml", "b.CSV", "d.csv"]),
              "a file that cannot be written does not stop the others")
    before = tool.read("a.csv")
    with open("/dev/full", "w") as full:
        failed = tool.run("grid", "a.yaml", "-o", "a.csv", stdout=full)
    tap.equal((failed.code, tool.read("a.csv") == before), (4, True), "files come before the text")


def refused(tap, tool):
    none = tool.run("grid")
    tap.ok(none.code == 2 and not none.out and "no measuring grids" in none.err and "grids=[{" in none.err,
           "a scene without grids", none)
    words = none.err[none.err.index("-s '") + 4:].split("'")[0]
    tap.equal(tool.run("grid", "-s", words).code, 0, "the hint works")
    tool.write("a.yaml", scene([LAMP], [FLOOR]))
    bright = tool.run("grid", "a.yaml", "--quantity", "brightness")
    tap.ok(bright.code == 2 and "irradiance" in bright.err and not bright.out, "--quantity brightness", bright)
    plain = tool.run("grid", "a.yaml", "--json")
    tap.equal(tool.run("grid", "a.yaml", "--json", "--quantity", "irradiance").out, plain.out, "--quantity irradiance")
    tap.equal(tool.run("grid", "a.yaml", "-p", "0,0").code, 2, "-p is no option of it")
    tight = tool.run("grid", "a.yaml", "--json", "--tolerance", "1e-18")
    tap.equal((tight.code, tight.out == plain.out), (5, True), "a tolerance that cannot be reached")
    tap.equal(tool.run("grid", "a.yaml", "--tolerance", "1e-10").code, 0, "one that is")
    tap.equal(tool.run("grid", "a.yaml", "-s", "grids[0].n=[0,1]").code, 3, "an illegal value")
    half = tool.run("grid", "a.yaml", "--json", "-s", "grids[0].n=[3,2]", "-s", "lights[0].intensity=500").json()
    tap.equal((half["grids"][0]["n"], [len(row) for row in half["grids"][0]["values"]]), ([3, 2], [3, 3]), "-s")
    drawn = tool.run("grid", "a.yaml", "-o", "a.png")
    words = re.search("this draws it: luxel (.*)", drawn.err)
    tap.ok(drawn.code == 2 and words, "a picture of it", drawn)
    tap.equal((tool.run(*words[1].split()).code, "a.png" in tool.files()), (0, True), "the hint draws it")
    odd = tool.run("grid", "a.yaml", "--strict", "-s", "lights[0].intensity=1e6")
    tap.equal((odd.code, odd.out), (3, ""), "--strict")


def threads(tap, tool):
    tool.write("a.yaml", scene([LAMP, {"type": "point", "position": [100, 200, 300], "intensity": 3}],
                               [{**FLOOR, "axis": [0.1, 0.2, 1], "n": [61, 37]}]))
    one = tool.run("grid", "a.yaml", "--json", "--threads", "1", "-o", "one.csv")
    for count in "2", "3", "8", "100":
        other = tool.run("grid", "a.yaml", "--json", "--threads", count, "-o", "other.csv")
        tap.ok(other.out == one.out and tool.read("other.csv") == tool.read("one.csv"), "%s threads" % count)


def a_picture(tap, tool):
    """A picture that carries its scene carries its grids, whatever quantity it shows."""
    tool.write("a.yaml", scene([LAMP], [FLOOR]))
    tool.run("render", "a.yaml", "-o", "a.png")
    tap.equal(tool.run("grid", "a.png", "--json").out, tool.run("grid", "a.yaml", "--json").out, "grid of a picture")


def spacing(tap, tool):
    """Cells by EN 12464-1: the published distances, the side that counts, whole cells, and what does not go with it."""
    def cells(*size):
        plane = {"center": [0, 0, 0], "size": size, "spacing": "en12464"}
        result = tool.run("grid", "-", "--json", stdin=scene([LAMP], [plane]))
        return result.json()["grids"][0]["n"] if result.code == 0 else result.err

    # p = 0.2, 0.324669, 0.616012, 1, 1.623345, 3.080059 and 5 m for d = 1, 2, 5, 10, 20, 50 and 100 m
    for size, expected in (((1000, 1000), [5, 5]), ((2000, 2000), [7, 7]), ((5000, 4000), [9, 7]),
                           ((4000, 5000), [7, 9]), ((10000, 10000), [10, 10]), ((20000, 15000), [13, 10]),
                           ((50000, 50000), [17, 17]), ((100000, 100000), [20, 20]),
                           ((10000, 5000), [17, 9]),  # twice as long: by the shorter side
                           ((10000, 5001), [10, 6]), ((100000, 1000), [500, 5]),
                           ((1000000, 600000), [100, 60])):  # no more than 10 m
        tap.equal(cells(*size), expected, "cells of %g x %g mm" % size)
    tap.ok("30000 x 20000 cells are too many" in cells(3e8, 2e8), "too many")
    plane = {key: FLOOR[key] for key in ("center", "size")}
    answers = [tool.run("grid", "-", "--json", stdin=scene([LAMP], [{**plane, **cells}])).json()
               for cells in ({"spacing": "en12464"}, {"n": [8, 8]})]
    tap.equal(answers[0], answers[1], "the numbers are those of n")
    for grid, word in (({**FLOOR, "spacing": "en12464"}, "mutually exclusive"), (plane, "needs one of n, spacing"),
                       ({**plane, "spacing": "en12463"}, 'did you mean "en12464"')):
        result = tool.run("grid", "-", stdin=scene([LAMP], [grid]))
        tap.ok(result.code == 3 and word in result.err, word, result.code, result.err)


def extrema(tap, tool):
    """Between the points: below a lamp and in the corner that is farthest from it, and never within the points' own."""
    lamp = {"type": "point", "position": [137, 211, 2000], "intensity": 1000}
    plane = {"center": [0, 0, 0], "size": [3500, 2500], "n": [4, 3]}
    found = tool.run("grid", "-", "--json", stdin=scene([lamp], [plane])).json()["grids"][0]["extrema"]
    far = (137 + 1750) ** 2 + (211 + 1250) ** 2
    for name, truth, place, near in (("maximum", 1000 / 2.0 ** 2, [137, 211, 0], 0.1),
                                     ("minimum", 1000 * 2.0 / ((far + 2000 ** 2) * 1e-6) ** 1.5, [-1750, -1250, 0], 0)):
        tap.near(found[name]["value"], truth, 1e-12, name)
        tap.ok(found[name]["error"] <= 1e-12 * truth, "with its bound", found[name])
        tap.ok(math.dist(found[name]["position"], place) <= near, "and its place", found[name])
    rng, inside, missed = random.Random(32), [], []
    for i in range(24):
        lights = [{"type": "spot", "position": [rng.uniform(-1500, 1500), rng.uniform(-1000, 1000), 2000],
                   "intensity": rng.uniform(1, 9), "inner": rng.uniform(5, 15), "outer": rng.uniform(20, 35)}
                  for _ in range(3)]
        ball = [{"type": "sphere", "center": [rng.uniform(-1000, 1000), 0, 900], "radius": 200}]
        text = scene(lights, [{**plane, "n": [7, 5]}, {**plane, "n": [175, 125]}], shadows="all", surfaces=ball)
        coarse, fine = tool.run("grid", "-", "--json", stdin=text).json()["grids"]
        for name, sign in (("maximum", 1), ("minimum", -1)):
            value = sign * coarse["extrema"][name]["value"]
            inside += [(i, name)] * (value < sign * coarse[name]["value"])
            missed += [(i, name)] * (value < sign * fine[name]["value"] - 1e-3 * fine["maximum"]["value"])
    tap.ok(not inside, "never less extreme than the points", *inside)
    tap.ok(not missed, "nor than a grid of 21 875 points", *missed)
    wall = {"model": "lambert", "diffuse": 0.5, "over_pi": True}
    lit = scene([lamp], [plane], reflections=1, surfaces=[
        {"type": "sphere", "center": [0, 0, 900], "radius": 200, "material": wall}])
    answer, = tool.run("grid", "-", "--json", "--reflected-error", "1e-4", stdin=lit).json()["grids"]
    for name, sign in (("maximum", 1), ("minimum", -1)):
        peak = answer["extrema"][name]
        at = ",".join("%.17g" % number for number in (*peak["position"], 0, 0, 1))
        probe, = tool.run("probe", "-", "--at", at, "--quantity", "irradiance", "--reflected-error", "1e-6", "--json",
                          stdin=lit).json()["points"]
        tap.ok(abs(peak["value"] - probe["value"]) <= peak["error"] + probe["error"] < 0.1 * probe["value"],
               "with reflected light the %s is that of its place" % name, peak, probe)
        tap.ok(sign * (peak["value"] - answer[name]["value"]) >= -peak["error"], "no less extreme than the points",
               peak, answer[name])
    for key in "mean", "flux", "sampling_error":
        tap.ok(answer[key] is not None, "with reflected light the plane has its " + key, answer)
    tap.ok(abs(answer["flux"] - answer["mean"] * 3.5 * 2.5) <= answer["flux_error"], "the flux", answer)
    told = " ".join(tool.run("grid", "-", stdin=scene([lamp], [plane])).out.split())
    tap.ok("maximum on the whole plane 250 ±" in told, "the text", told)


def across_a_body(tap, tool):
    """Ambient light has no shadow: it reaches the cells that lie inside of a body."""
    body = {"shadows": "all", "surfaces": [{"type": "sphere", "center": [0, 0, 1000], "radius": 320}]}
    plane = {"center": [0, 0, 900], "size": [2000, 2000], "n": [8, 8]}
    ambient = {"type": "ambient", "irradiance": 15}
    alone, lamp, both = (tool.run("grid", "-", "--json", stdin=scene(lights, [plane], **body)).json()["grids"][0]
                         for lights in ([ambient], [LAMP], [ambient, LAMP]))
    tap.equal((alone["average"], alone["mean"], alone["extrema"]["minimum"]["value"]), (15, 15, 15), "ambient alone")
    tap.ok(abs(both["mean"] - lamp["mean"] - 15) <= both["mean_error"] + lamp["mean_error"], "beside a lamp", both)
    tap.ok(lamp["inside"] > 0 and lamp["extrema"]["minimum"]["value"] == 0, "which leaves them dark", lamp)


# What closes around cells of BODIES: a ball, a tube with covers, a closed mesh; and what does not, a tube without.
CUBE = """OFF
8 6 12
-100 -100 -100
100 -100 -100
-100 100 -100
100 100 -100
-100 -100 100
100 -100 100
-100 100 100
100 100 100
4 0 2 3 1
4 4 5 7 6
4 0 1 5 4
4 2 6 7 3
4 0 4 6 2
4 1 3 7 5
"""
TUBE = {"type": "cylinder", "center": [600, 0, 0], "axis": [0, 0, 1], "radius": 100, "height": 200}
COVERS = [{"type": "disk", "center": [600, 0, 100], "radius": 100},
          {"type": "rectangle", "center": [600, 0, -100], "size": [250, 200]}]
BODIES = [([{"type": "sphere", "center": [-600, 0, 0], "radius": 100}], [1]), ([TUBE], []), ([TUBE, *COVERS], [7]),
          ([TUBE, COVERS[0]], []), ([{"type": "mesh", "file": "cube.off"}], [4])]


def inside_bodies(tap, tool):
    """Cells inside of bodies are told and left out of all that is read off the others."""
    tool.write("cube.off", CUBE)
    plane = {"center": [0, 0, 1], "size": [1800, 200], "n": [9, 1]}
    lamp = {"type": "planar", "rectangle": {"center": [0, 0, 1500], "size": [300, 300]}, "radiance": 1000}
    for surfaces, expected in BODIES:
        text = scene([lamp], [plane], shadows="all", surfaces=surfaces)
        grid = tool.run("grid", "-", "--json", "-o", "cells.csv", stdin=text).json()["grids"][0]
        values = grid["values"][0]
        kept = [value for value in values if value is not None]
        tap.equal((grid["inside"], grid.get("inside_cells", [])), (len(expected), [[column, 0] for column in expected]),
                  "the cells within are told")
        tap.equal([i for i in range(9) if values[i] is None], expected, "and have no value")
        tap.equal((grid["measured"], grid["minimum"]["value"]), (len(kept), min(kept)), "the others have")
        tap.near(grid["average"], sum(kept) / len(kept), 1e-14, "the average is theirs")
        tap.near(grid["u0"], min(kept) / grid["average"], 1e-14, "and U0")
        lines = tool.read("cells.csv").decode().splitlines()[1:]
        tap.equal([i for i, line in enumerate(lines) if line.endswith(",,")], expected, "as in the table")
        told = tool.run("grid", "-", stdin=text).out
        tap.equal("inside a body" in told, bool(expected), "and in text")
    lit = scene([{**LAMP, "position": [0, 0, 50]}], [plane], shadows="all", surfaces=BODIES[-1][0])
    room = tool.run("grid", "-", "--json", stdin=lit).json()["grids"][0]
    tap.ok(room["inside"] == 0 and room["values"][0][4] > 0, "what a light shines in is a room", room)


def interrupted(tap, tool):
    tool.write("long.yaml", scene([{**LAMP, "position": [i, 0, 3000]} for i in range(300)],
                                  [{**FLOOR, "n": [2000, 2000]}]))
    for seconds in 0.1, 0.6:
        process = subprocess.Popen([tool.path, "grid", "long.yaml", "-o", "x.csv"], cwd=tool.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_caught(process)
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
        start = time.monotonic()
        out, _ = process.communicate(timeout=60)
        tap.equal((process.returncode, out, tool.files()), (130, b"", ["long.yaml"]),
                  "interrupted after %g s" % seconds)
        tap.ok(time.monotonic() - start < AT_ONCE, "it ends soon")


run_tests(Tap(), closed_numbers, closed_room, extended, honest_errors, text, on_a_source, tables, refused, threads,
          a_picture, spacing, extrema, across_a_body, inside_bodies, interrupted)
