# SPDX-License-Identifier: MIT
"""luxel isophotes: its lines against circles known in advance, its text, JSON and CSV, pictures, what it refuses."""
import csv
import io
import json
import math

from tap import Tap
from tool import SCENE, run_tests

RADIUS, IRRADIANCE, DIFFUSE = 200.0, 5.0, 0.8
LIGHT = (2 / 3, -1 / 3, 2 / 3)

SPHERE = json.dumps({
    "luxel": 1, "screen": {"width": 500, "height": 500, "resolution": [60, 60]}, "observer": {"z": 1500},
    "surfaces": [{"type": "sphere", "center": [0, 0, 1000], "radius": RADIUS,
                  "material": {"model": "lambert", "diffuse": DIFFUSE}}],
    "lights": [{"type": "distant", "direction": [-2, 1, -2], "irradiance": IRRADIANCE}]})


def exact(x, y):
    """The value seen through a place of the screen, and how well coordinates near the limb tell it."""
    square = (RADIUS - math.hypot(x, y)) * (RADIUS + math.hypot(x, y))
    height = math.sqrt(max(square, 0))
    cosine = (LIGHT[0] * x + LIGHT[1] * y + LIGHT[2] * height) / RADIUS
    return DIFFUSE * IRRADIANCE * cosine, 1e-12 / max(height / RADIUS, 1e-6)


def circles(tap, tool):
    tool.write("a.yaml", SPHERE)
    result = tool.run("isophotes", "a.yaml", "--json", "--levels", "3.5,0.5,1,3,2")
    tap.equal((result.code, result.err), (0, ""), "isophotes --json")
    answer = result.json()
    tap.equal(list(answer), ["quantity", "unit", "levels", "lines", "conventions"], "members of the answer")
    tap.equal((answer["quantity"], answer["unit"], answer["levels"]), ("brightness", "W/m²", [3.5, 0.5, 1, 3, 2]),
              "heading")
    tap.equal([line["level"] for line in answer["lines"]], [3.5, 0.5, 1, 3, 2], "one line each, in the order given")
    # about the light, at 48.2 degrees from the observer, a circle is seen whole if its angle is below 41.8 degrees
    tap.equal([line["closed"] for line in answer["lines"]], [True, False, False, True, False], "closed or open")
    for line in answer["lines"]:
        tap.equal(list(line), ["level", "closed", "vertices"], "members of a line")
        off = [abs(exact(x, y)[0] - line["level"]) / line["level"] - exact(x, y)[1] for x, y in line["vertices"]]
        tap.ok(max(off) <= 1e-9, "each vertex of %g on its level" % line["level"], max(off))
        ends = [math.hypot(*line["vertices"][i]) for i in (0, -1)]
        if not line["closed"]:
            tap.ok(all(0 <= RADIUS - end < 1e-3 for end in ends), "%g ends at the limb" % line["level"], ends)


def area_lights(tap, tool):
    """Lines of the pixels under area lights, as in figures; on exact values where --exact asks for them."""
    lamp = [{"type": "planar", "rectangle": {"center": [0, 0, 900], "size": [300, 200], "axis": [0, 0, -1]},
             "radiance": 30}]
    scene = {**json.loads(SPHERE), "observer": {"z": 2000}, "lights": lamp,
             "surfaces": [{"type": "rectangle", "center": [0, 0, 0], "size": [480, 480],
                           "material": {"model": "lambert", "diffuse": DIFFUSE}}]}
    tool.write("area.yaml", json.dumps(scene))
    quick, pixels, slow = (tool.run("isophotes", "area.yaml", "--json", "--levels", "1.2,1.4", *options)
                           for options in ((), ("--picture",), ("--exact",)))
    tap.ok("--exact" in quick.err and (pixels.err, slow.err) == ("", ""), "a note says so", (quick.err, slow.err))
    tap.equal(quick.json()["lines"], pixels.json()["lines"], "area lights: the pixels' lines")
    near, exact_lines = quick.json()["lines"], slow.json()["lines"]
    tap.equal(len(near), len(exact_lines), "as many lines")
    worst = 0
    for line in exact_lines:
        for x, y in line["vertices"][::20]:
            value = tool.run("probe", "area.yaml", "--json", "-p", "%r,%r" % (x, y)).json()["points"][0]["value"]
            worst = max(worst, abs(value / line["level"] - 1))
    tap.ok(worst <= 1e-9, "--exact: vertices on their levels", worst)
    tap.equal(tool.run("isophotes", "area.yaml", "-q").err, "", "no note with -q")


def probed(tap, tool):
    """The vertices have their level by luxel probe, too."""
    tool.write("a.yaml", SCENE)
    lines = tool.run("isophotes", "a.yaml", "--json", "--levels", "4").json()["lines"]
    tap.ok(len(lines) > 2, "round levels", lines)
    for line in lines:
        x, y = line["vertices"][len(line["vertices"]) // 2]
        probe = tool.run("probe", "a.yaml", "--json", "-p", "%r,%r" % (x, y)).json()
        text = json.dumps(probe)
        values = [point["value"] for point in probe["points"]] if "points" in probe else [probe["value"]]
        tap.ok(any(abs(value - line["level"]) <= 1e-9 * line["level"] for value in values), "probed", text)


def tables(tap, tool):
    tool.write("a.yaml", SPHERE)
    lines = tool.run("isophotes", "a.yaml", "--json", "--levels", "1,3,2").json()["lines"]
    expected = [[str(i + 1), line["level"], str(int(line["closed"])), *vertex]
                for i, line in enumerate(lines) for vertex in line["vertices"]]
    printed = tool.run("isophotes", "a.yaml", "--csv", "--levels", "1,3,2", "-o", "a.csv")
    tap.equal(printed.code, 0, "--csv")
    content = tool.read("a.csv").decode()
    tap.ok(content == printed.out.replace("\r\n", "\n").replace("\n", "\r\n"), "printed and written are the same")
    tap.ok(content.endswith("\r\n") and content.count("\n") == content.count("\r\n"), "lines end in CR LF")
    rows = list(csv.reader(io.StringIO(content)))
    tap.equal((rows[0][0], rows[0][1][:6], rows[0][2:]), ("line", "level_", ["closed", "x_mm", "y_mm"]), "heading")
    tap.ok([[a, float(b), c, float(x), float(y)] for a, b, c, x, y in rows[1:]] == expected, "the same numbers")
    tool.run("isophotes", "a.yaml", "--csv=excel-ru", "--levels", "1,3,2", "-o", "b.csv")
    russian = tool.read("b.csv").decode()
    tap.ok(russian.startswith("\ufeffline;level_"), "byte order mark and semicolons")
    again = [row.replace(",", ".").split(";") for row in russian[1:].splitlines()]
    tap.ok(again == [list(row) for row in rows], "decimal commas")


def text(tap, tool):
    tool.write("a.yaml", SPHERE)
    result = tool.run("isophotes", "a.yaml", "--levels", "1,3.5,99")
    tap.equal((result.code, result.err), (0, ""), "text")
    rows = [line.split() for line in result.out.splitlines() if line.strip().endswith(tuple("0123456789"))]
    rows = [row for row in rows if len(row) == 4 and row[2] in ("open", "closed")]
    tap.equal([(row[0], row[2]) for row in rows], [("1", "open"), ("3.5", "closed")], "a line a line")
    # the circle of 3.5, tilted by acos(2/3): an ellipse, whose length Ramanujan's formula gives to 1e-9
    wide = RADIUS * math.sqrt(1 - (3.5 / 4) ** 2)
    narrow = wide * 2 / 3
    h = ((wide - narrow) / (wide + narrow)) ** 2
    length = math.pi * (wide + narrow) * (1 + 3 * h / (10 + math.sqrt(4 - 3 * h)))
    tap.ok(0 < length - float(rows[1][3]) < 3e-3 * length, "its length, by chords", rows)
    none = tool.run("isophotes", "a.yaml", "--levels", "0,-1,99")
    tap.ok(none.code == 0 and "no value" in none.out, "levels that nothing crosses", none)


def round_levels(tap, tool):
    tool.write("a.yaml", SPHERE)
    for arguments, expected in [
            (["--levels", "3"], [1, 2, 3]),
            (["--levels", "4", "--scale", "1,2"], [1.2, 1.4, 1.6, 1.8]),
            (["--levels", "7", "--log", "--scale", "0.03,3"], [0.05, 0.1, 0.2, 0.5, 1, 2]),
            (["--scale", "1e17,100000000000000016"], [])]:
        answer = tool.run("isophotes", "a.yaml", "--json", *arguments, timeout=20).json()
        tap.equal(answer["levels"], expected, "levels by %s" % " ".join(arguments))


def pictures(tap, tool):
    """From the pixels alone lines are near to the exact ones, whether the picture is computed or read."""
    tool.write("a.yaml", SPHERE)
    tool.run("render", "a.yaml", "-o", "a.csv", "-o", "a.npy", "-o", "a.exr")
    computed = tool.run("isophotes", "a.yaml", "--picture", "--json", "--levels", "3.9,").json()["lines"]
    tap.equal(len(computed), 1, "one line of the picture")
    off = max(abs(exact(x, y)[0] - 3.9) for x, y in computed[0]["vertices"])
    tap.ok(1e-6 < off < 0.02, "its vertices are near the level", off)
    for name in "a.csv", "a.exr":
        read = tool.run("isophotes", name, "--json", "--levels", "3.9,").json()["lines"]
        same = len(read) == 1 and len(read[0]["vertices"]) == len(computed[0]["vertices"]) and all(
            math.dist(a, b) < 1e-6 for a, b in zip(read[0]["vertices"], computed[0]["vertices"]))
        tap.ok(same, "the line of %s" % name, read)
    placeless = tool.run("isophotes", "a.npy", "--levels", "3.9,")
    tap.ok(placeless.code != 0 and not placeless.out and "where on the screen" in placeless.err, "no places",
           placeless)


def threads(tap, tool):
    tool.write("a.yaml", SCENE)
    one = tool.run("isophotes", "a.yaml", "--json", "--threads", "1")
    for count in "2", "5", "64":
        tap.ok(tool.run("isophotes", "a.yaml", "--json", "--threads", count).out == one.out, "%s threads" % count)


def refused(tap, tool):
    tool.write("a.yaml", SCENE)
    for arguments in (["--levels", "x"], ["--levels", "0"], ["--levels", "1,x"], ["--levels", "51"],
                      ["-o", "a.png"], ["--csv=x"], ["--scale", "2,1"], ["-p", "0,0"]):
        result = tool.run("isophotes", "a.yaml", *arguments)
        tap.ok(result.code == 2 and not result.out and result.err.startswith("luxel: "), " ".join(arguments), result)
    tap.equal(tool.files(), ["a.yaml"], "nothing is written")
    tap.equal(tool.run("isophotes", "none.yaml").code, 4, "a scene that is not there")


run_tests(Tap(), circles, area_lights, probed, tables, text, round_levels, pictures, threads, refused)
