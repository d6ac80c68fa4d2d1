# SPDX-License-Identifier: MIT
"""luxel photometry -o sheet.pdf: the tables of a luminaire's sheet against closed forms and sums of their own."""
import json
import math
import re

from luminaires import HEAD, eulumdat
from tap import Tap
from tool import run_tests

ANGLES = range(0, 91, 5)
FLUX = math.pi * 1000
CODES = "fl fm fh fvh bl bm bh bvh ul uh".upper().split()


def lamp(intensity, planes=(0,), opening=".6 .6 0", angles=ANGLES):
    rows = (" ".join(repr(intensity(c, gamma)) for gamma in angles) for c in planes)
    return HEAD + "1 -1 1 %d %d 1 2 %s\n1 1 28\n%s\n%s\n%s\n" % (
        len(angles), len(planes), opening, " ".join(map(str, angles)), " ".join(map(str, planes)), "\n".join(rows))


def lambert(_, gamma):
    return 1000 * max(0, math.cos(math.radians(gamma)))


def rows(text):
    """The cells of all tables of a Markdown text."""
    return [[cell.strip().strip("*") for cell in line.strip("|").split("|")] for line in text.splitlines()
            if line.startswith("|")]


def sheet(tool, name, file="lamp.ies", *options, **environment):
    result = tool.run("photometry", file, "-o", name, "-q", *options, environment=environment)
    assert result.code == 0, result
    with open(tool.folder + "/" + name, encoding="utf-8") as made:
        return made.read()


def after(cells, first):
    """The row that begins so."""
    return [row for row in cells if row[0] == first][0]


def contents(tap, tool):
    """A Lambertian panel, whose every number has a closed form."""
    tool.write("lamp.ies", lamp(lambert))
    text = sheet(tool, "sheet.md")
    cells = rows(text)
    tap.ok("Lampe AG" in text and after(cells, "file")[1] == "lamp.ies" and "LM-63-1995, type C" in text, "the header",
           text[:600])
    for i in range(9):
        lumens, share, total, part = map(float, after(cells, "%d–%d" % (10 * i, 10 * i + 10))[1:])
        low, high = (math.sin(math.radians(10 * k)) ** 2 for k in (i, i + 1))
        tap.ok(abs(lumens - FLUX * (high - low)) <= 0.051 and abs(share - 100 * (high - low)) <= 0.051 and
               abs(total - FLUX * high) <= 0.051 and abs(part - 100 * high) <= 0.051, "zone %d" % i, lumens, share)
    for gamma in (45, 60, 85):
        found = [row for row in cells if row[0] == str(gamma)]
        tap.equal([row[1] for row in found], ["%.3g" % lambert(0, gamma), "2778"],
                  "intensity and luminance at %d" % gamma)
    zones = dict(zip(after(cells, "zone")[1:], map(float, after(cells, "lm")[1:])))
    tap.equal(list(zones), CODES, "the zones of TM-15")
    edges = (0, 30, 60, 80, 90)
    for i, name in enumerate(("L", "M", "H", "VH")):
        half = FLUX / 2 * (math.sin(math.radians(edges[i + 1])) ** 2 - math.sin(math.radians(edges[i])) ** 2)
        tap.ok(abs(zones["F" + name] - half) <= 0.51 and zones["B" + name] == zones["F" + name],
               "half the flux " + name)
    tap.ok("B1 U0 G1" in text and "all sides alike" in text, "its rating: BM 785 lm, FVH 47 lm, round", zones)
    told = tool.run("photometry", "lamp.ies", "--json").json()
    for k, room in enumerate(told["utilization"]["rooms"]):
        row = list(map(float, after(cells, "k = %g" % room["room_index"])[1:]))
        tap.ok(all(abs(a - 100 * b) <= 0.051 for a, b in zip(row, room["factors"])), "utilization %d" % k, row, room)
    tap.ok(len([row for row in cells if "H ×" in row[0]]) == 19, "the UGR table")
    tap.ok("{" not in text, "no sentence has a gap left")


def next_to(length, depth, height):
    """The form factor of a floor to the wall on one of its sides of that length."""
    h, w = height / length, depth / length
    s = h * h + w * w
    logs = ((1 + w * w) * (1 + h * h) / (1 + s) * (w * w * (1 + s) / ((1 + w * w) * s)) ** (w * w) *
            (h * h * (1 + s) / ((1 + h * h) * s)) ** (h * h))
    return (w * math.atan(1 / w) + h * math.atan(1 / h) - math.sqrt(s) * math.atan(1 / math.sqrt(s)) +
            math.log(logs) / 4) / (math.pi * w)


def bounce(side, flux, reflectances):
    """The flux on the floor of a square room, bounce by bounce: floor, walls, ceiling."""
    to_walls = 4 * next_to(side, side, 1)
    back = to_walls * side / 4
    send = ((0, to_walls, 1 - to_walls), (back, 1 - 2 * back, back), (1 - to_walls, to_walls, 0))
    total, now = flux[0], list(flux)
    for _ in range(500):
        now = [sum(now[i] * reflectances[i] * send[i][j] for i in range(3)) for j in range(3)]
        total += now[0]
    return total


def utilization(tap, tool):
    """Factors by form factors of their own; one room by a grid on its floor."""
    tool.write("lamp.ies", lamp(lambert))
    tool.write("up.ldt", eulumdat(line_7="90", line_45="90", line_46="180", line_47="200", line_48="100", line_49="30"))
    for file in "lamp.ies", "up.ldt":
        told = tool.run("photometry", file, "--json").json()
        table, lumens = told["utilization"], told["flux"]["zone"]
        down = lumens * told["dff"] / 100
        worst = 0
        for room, ratio in zip(table["rooms"], told["direct_ratios"]["ratio"]):
            for factor, part in zip(room["factors"], table["reflectances"]):
                flux = (down * ratio, down * (1 - ratio), lumens - down)
                own = bounce(2 * room["room_index"], flux, (part["floor"], part["walls"], part["ceiling"]))
                worst = max(worst, abs(factor * table["lumens"] - own) / lumens)
        tap.ok(worst < 1e-9, "the tabular method, " + file, worst)
    tap.equal(told["utilization"]["lumens"], 1000, "related to the lamps")
    text = sheet(tool, "sheet.md")
    found = {row[0]: tuple(map(float, row[2:])) for row in rows(text)
             if len(row) == 4 and re.fullmatch(r"[\d.]+", row[0])}
    tap.equal(sorted(map(float, found)), [0.6, 0.8, 1, 1.25, 1.5], "the smaller rooms by reflections")
    wall = {"model": "lambert", "over_pi": True}
    room = {"luxel": 1, "units": "photometric", "reflections": "all",
            "screen": {"width": 1, "height": 1, "resolution": [4, 4]}, "observer": {"z": 9000},
            "surfaces": [{"type": "room", "name": "hall", "center": [0, 0, 500], "size": [2000, 2000, 1000], "up": "z",
                          "material": {**wall, "diffuse": .5}, "materials": {"ceiling": {**wall, "diffuse": .7},
                                                                            "floor": {**wall, "diffuse": .2}}}],
            "lights": [{"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 999.9],
                        "array": {"n": [2, 2], "spacing": [1000, 1000]}}],
            "grids": [{"surface": "hall", "side": "floor", "n": [10, 10]}]}
    tool.write("room.yaml", json.dumps(room))
    floor = tool.run("grid", "room.yaml", "--json", "--reflected-error", "0.01").json()["grids"][0]
    value, error = found["1"]
    own = 100 * floor["average"] * 4 / (4 * FLUX)
    tap.ok(abs(value - own) <= error + 0.5, "k = 1 by reflections: the mean over its floor", value, error, own)
    tap.ok(error < 2, "a useful bound", error)


def lopsided(tap, tool):
    """Light to one side alone: the front of LM-63 is C = 0, that of EULUMDAT C = 90."""
    planes = (0, 80, 90, 180)
    tool.write("lamp.ies", lamp(lambda c, g: 1000 if c <= 80 else 0, planes, angles=range(0, 181, 10)))
    bug = tool.run("photometry", "lamp.ies", "--json").json()["bug"]
    whole = 1000 * (160 + 10) * math.pi / 180  # cd rad over C
    edges = (0, 30, 60, 80, 90)
    for i, name in enumerate(("fl", "fm", "fh", "fvh")):
        own = whole * (math.cos(math.radians(edges[i])) - math.cos(math.radians(edges[i + 1])))
        tap.near(bug["lumens"][name], own, 1e-12, "before it " + name)
    tap.ok(all(bug["lumens"][name] == 0 for name in ("bl", "bm", "bh", "bvh")), "nothing behind it", bug)
    tap.near(bug["lumens"]["uh"] + bug["lumens"]["ul"], whole, 1e-12, "above it")
    tap.equal([bug[key] for key in ("backlight", "uplight", "glare", "front_c", "around")], [0, 5, 4, 0, False],
              "rated")
    made = tool.run("photometry", "lamp.ies", "-o", "lamp.ldt", "-q")
    turned = tool.run("photometry", "lamp.ldt", "--json").json()["bug"]
    tap.ok(made.code == 0 and turned["front_c"] == 90 and turned["lumens"]["bm"] > 100, "of EULUMDAT C = 90", turned)


def forms(tap, tool):
    """Pages, HTML, Russian; diagrams alone; what has no tables."""
    tool.write("lamp.ies", lamp(lambert))
    russian = sheet(tool, "ru.md", LANGUAGE="ru")
    tap.ok("Коэффициенты использования" in russian and "Силы света" in russian, "in Russian", russian[:300])
    page = sheet(tool, "sheet.html")
    tap.ok(page.count("<img") + page.count("<svg") >= 1 and "<table" in page, "as HTML")
    for name, options in ("sheet.pdf", ()), ("polar.pdf", ("--diagram", "polar")):
        made = tool.run("photometry", "lamp.ies", "-o", name, *options)
        tap.ok(made.code == 0 and tool.read(name)[:5] == b"%PDF-", name, made)
    pages = [len(re.findall(rb"/Type */Page\b", tool.read(name))) for name in ("sheet.pdf", "polar.pdf")]
    tap.ok(pages[0] > 1 and pages[1] == 1, "--diagram makes a .pdf the diagram alone", pages)
    tool.write("point.ies", lamp(lambert, opening="0 0 0"))
    point = sheet(tool, "point.md", "point.ies")
    tap.ok("Luminances" not in point and "Unified" not in point and "Utilization" in point, "a point has no luminance")
    tool.write("b.ies", HEAD + "1 -1 1 3 3 2 2 .1 .1 0\n1 1 10\n-90 0 90\n-90 0 90\n0 0 0\n0 1000 0\n0 0 0\n")
    side = sheet(tool, "b.md", "b.ies")
    tap.ok("Backlight" not in side and "Flux of zones" not in side and "vertical" in side, "type B", side)
    piped = tool.run("photometry", "-", "-o", "piped.md", "-q", stdin=lamp(lambert))
    tap.ok(piped.code == 0 and b"by reflections" not in tool.read("piped.md"), "of standard input no room is solved")
    tables = sheet(tool, "sheet.csv")
    tap.ok("Utilization factors" in tables and '"LM-63-1995, type C"' in tables and "0–10," in tables,
           "tables for spreadsheets", tables[:200])
    wrong = tool.run("photometry", "lamp.ies", "-o", "sheet.docx")
    tap.ok(wrong.code == 2 and ".html" in wrong.err, "another extension", wrong)


run_tests(Tap(), contents, utilization, lopsided, forms)
