# SPDX-License-Identifier: MIT
"""luxel report --for lighting: verdicts, schedule and values against JSON and sums by hand, in both languages."""
import csv
import json
import math
import os
import re

from luminaires import HEAD
from tap import Tap
from tool import run_tests

ANGLES = range(0, 91, 5)
LAMP = HEAD.replace("TILT", "[LUMCAT] P600\nTILT") + (
    "1 -1 1 19 1 1 2 .6 .6 0\n1 1 28\n%s\n0\n%s\n") % (
    " ".join(map(str, ANGLES)), " ".join(repr(1000 * math.cos(math.radians(g))) for g in ANGLES))
SCENE = {
    "luxel": 1, "units": "photometric", "maintenance_factor": 0.8,
    "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]}, "observer": {"z": 9000},
    "surfaces": [{"type": "room", "name": "hall", "center": [0, 0, 1500], "size": [6000, 4000, 3000], "up": "z",
                  "material": {"model": "lambert", "over_pi": True, "diffuse": 0.5}}],
    "lights": [{"type": "luminaire", "name": "panels", "file": "lamp.ies", "position": [0, 0, 3000],
                "maintenance_factor": 0.9, "array": {"n": [2, 3], "spacing": [3000, 1300]}},
               {"type": "luminaire", "file": "lamp.ies", "position": [0, 1900, 2500], "enabled": False},
               {"type": "ambient", "irradiance": 30}],
    "grids": [{"name": "plane", "center": [0, 0, 750], "size": [5000, 3000], "n": [5, 3],
               "limits": {"average": 100, "uniformity": 0.99}},
              {"center": [0, 0, 10], "size": [5000, 3000], "n": [13, 2]}],
    "observers": [{"name": "desk", "eye": [0, -1900, 1200], "view": [0, 1, 0], "limits": {"ugr": 30}}],
}


def rows(text):
    """The cells of all tables of a Markdown text."""
    return [[cell.strip().strip("*") for cell in line.strip("|").split("|")] for line in text.splitlines()
            if line.startswith("|")]


def report(tool, name, *options, **environment):
    result = tool.run("report", "scene.yaml", "--for", "lighting", "-o", name, *options, environment=environment)
    assert result.code == 0, result
    with open(tool.folder + "/" + name, encoding="utf-8") as file:
        return file.read()


def contents(tap, tool):
    tool.write("lamp.ies", LAMP)
    tool.write("scene.yaml", json.dumps(SCENE))
    text = report(tool, "report.md")
    cells = rows(text)
    told = tool.run("grid", "scene.yaml", "--limits", "--json").json()
    for judged, name in ((told["grids"][0], "plane"), (told["observers"][0], "desk")):
        for limit in judged["limits"]:
            row = [row for row in cells if row[0] == name and "%g" % limit["wanted"] in row[2]][0]
            value, error = map(float, row[3].split(" ± "))
            tap.ok(row[4] == limit["verdict"] and abs(value - limit["value"]) <= error,
                   "%s of %s" % (limit["name"], name), row, limit)
    tap.ok("Of 3 limits 1 are not kept" in text, "the summary", text[:400])
    figures = tool.run("photometry", "lamp.ies", "--json").json()
    row = [row for row in cells if row[0] == "panels" and "Lampe AG" in row[1]][0]
    flux = figures["flux"]["linear"]
    tap.ok("P600" in row[1] and [row[i] for i in (2, 4)] == ["6", "28"], "the schedule", row)
    tap.ok(["panels", "0.72", "1", "3000"] in cells, "maintenance factors and heights")
    tap.near(float(row[3]), flux, 1e-4, "flux of one new luminaire")
    tap.near(float(row[5]), flux / 28, 1e-3, "lm/W")
    total = [row for row in cells if row[0] == "together"][0]
    tap.ok(total[2] == "6" and total[4] == "168", "totals", total)
    tap.near(float(total[3]), 6 * flux, 1e-4, "the flux of all")
    tap.ok("On 24 m² of floor that is 7 W/m²" in text, "the power density")
    density = re.search(r"it is ([\d.]+) W/m² for 100 lx", text)
    tap.near(float(density[1]), 700 / told["grids"][0]["average"], 1e-3, "and for 100 lx")
    places = {tuple(map(float, row[2:])) for row in cells if len(row) == 5 and row[1] == "panels"}
    tap.equal(places, {(x, y, 3000) for x in (-1500, 1500) for y in (-1300, 0, 1300)}, "where each luminaire hangs")
    table = [[float(cell) for cell in row] for row in cells
             if len(row) == 5 and all(re.fullmatch(r"\d+", cell) for cell in row)]
    values = [row for row in table if row != [1, 2, 3, 4, 5]]
    tap.equal(values, [[float("%.0f" % value) for value in row] for row in told["grids"][0]["values"]],
              "values of a grid")
    tap.ok("grid 2" in text and "maintenance_factor" in text, "the second grid, the conventions")
    tap.ok("{" not in text.split("luxel: 1")[0].split('{"luxel"')[0], "no sentence has a gap left")
    tap.equal(report(tool, "again.md", "--threads", "1"), text, "for any number of threads")


def forms(tap, tool):
    tool.write("lamp.ies", LAMP)
    tool.write("scene.yaml", json.dumps(SCENE))
    russian = report(tool, "ru.md", LANGUAGE="ru")
    tap.ok("Проект освещения" in russian and "Светильники" in russian, "in Russian", russian[:300])
    page = report(tool, "report.html")
    tap.ok(page.count("<img") + page.count("<svg") >= 3 and "panels" in page, "plan and grids as pictures")
    made = tool.run("report", "scene.yaml", "--for", "lighting", "-o", "report.pdf")
    with open(tool.folder + "/report.pdf", "rb") as file:
        tap.ok(made.code == 0 and file.read(5) == b"%PDF-", "pages")
    wrong = tool.run("report", "scene.yaml", "--for", "roads", "-o", "report.pdf")
    tap.ok(wrong.code == 2 and "exercise, lighting" in wrong.err, "another purpose", wrong)
    empty = tool.run("report", "report", "--for", "lighting", "-o", "empty.md")
    with open(tool.folder + "/empty.md", encoding="utf-8") as file:
        tap.ok(empty.code == 0 and "no limits" in file.read(), "a scene without grids", empty)


def tables(tap, tool):
    """Each table as a file, bounds in columns of their own; what the tables leave out beside them."""
    tool.write("lamp.ies", LAMP)
    room = {**SCENE, "reflections": "all", "lights": SCENE["lights"][:2],
            "grids": [{**SCENE["grids"][0], "n": [3, 2]}],
            "observers": SCENE["observers"] + [{"name": "walk", "eye": [0, 0, 1200], "size": [2000, 1000], "n": [2, 1],
                                                "limits": {"ugr": 30}}]}
    tool.write("scene.yaml", json.dumps(room))
    made = tool.run("report", "scene.yaml", "--for", "lighting", "--tables", "tables", "-o", "report.md",
                    "--reflected-error", "0.05")
    tap.equal((made.code, made.err), (0, ""), "with a report")
    files = {}
    for name in sorted(os.listdir(tool.file("tables"))):
        with open(tool.file("tables/" + name), encoding="utf-8", newline="") as file:
            files[name] = list(csv.reader(file)) if name.endswith(".csv") else file.read()
    tap.equal(sorted(files), sorted("%s.csv" % name for name in (
        "balance", "glare", "glare-2", "grids", "isolux", "limits", "luminaires", "maintenance", "positions",
        "surfaces", "values")) [:5] + ["isolux.dxf"] + ["%s.csv" % name for name in (
            "limits", "luminaires", "maintenance", "positions", "surfaces", "values")], "the files")
    tap.equal({name: len({len(row) for row in rows}) for name, rows in files.items() if name.endswith(".csv")},
              {name: 1 for name in files if name.endswith(".csv")}, "all lines of a table are as long")
    told = tool.run("grid", "scene.yaml", "--limits", "--json", "--reflected-error", "0.02").json()
    judged = told["grids"][0]["limits"] + told["observers"][0]["limits"]
    tap.equal(files["limits.csv"][0], ["grid or observer", "what", "limit", "value", "value ±", "verdict"], "headings")
    for row, limit in zip(files["limits.csv"][1:], judged):
        tap.ok(abs(float(row[3]) - limit["value"]) <= float(row[4]) + limit["error"], limit["name"], row, limit)
    tap.equal([row[0] for row in files["limits.csv"][1:]], ["plane", "plane", "desk", "walk"], "all verdicts")
    for row, grid in zip(files["grids.csv"][1:], told["grids"]):
        tap.near(float(row[6]), grid["average"], 1e-12, "average of " + row[0], float(row[7]) + grid["average_error"])
        tap.near(float(row[11]), float(row[8]) / float(row[6]), 1e-15, "U0 of " + row[0])
    values = [float(row[6]) for row in files["values.csv"][1:]]
    wanted = [value for grid in told["grids"] for line in grid["values"] for value in line]
    tap.ok(len(values) == len(wanted) and all(abs(a / b - 1) < 0.05 for a, b in zip(values, wanted)), "all values")
    balance = {row[0]: (float(row[1]), float(row[2])) for row in files["balance.csv"][1:]}
    tap.near(balance["given off by the sources"][0], 6 * 0.72 * 1000 * math.pi, 2e-2, "the balance, of 1000 cd Lambert")
    tap.ok(abs(balance["difference, in truth 0"][0]) <= balance["difference, in truth 0"][1], "which closes")
    tap.equal(len(files["surfaces.csv"]), 7, "six sides under a heading")
    tap.equal((len(files["glare-2.csv"]), len(files["glare-2.csv"][0])), (3, 9), "four ways at each of two places")
    levels = {(row[0], float(row[2])) for row in files["isolux.csv"][1:]}
    layers = set(re.findall(r"ISOLUX_\w+", files["isolux.dxf"]))
    tap.equal(layers, {"ISOLUX_%g" % level for _, level in levels}, "isolux layers")
    tool.write("scene.yaml", json.dumps(SCENE))
    alone = tool.run("report", "scene.yaml", "--for", "lighting", "--tables", "tables", environment={"LANGUAGE": "ru"})
    tap.equal((alone.code, alone.err), (0, ""), "without a report, into a folder that is there")
    with open(tool.file("tables/limits.csv"), encoding="utf-8") as file:
        tap.ok("соблюдён" in file.read(), "in the language of the report")
    for options, code, words in ((["--for", "exercise"], 2, "--for lighting"), (["--for", "lighting"], 4, "cannot")):
        wrong = tool.run("report", "scene.yaml", "--tables", "scene.yaml/no", *options)
        tap.ok(wrong.code == code and words in wrong.err, "refused", wrong)


run_tests(Tap(), contents, forms, tables)
