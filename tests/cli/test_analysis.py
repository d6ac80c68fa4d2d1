# SPDX-License-Identifier: MIT
"""luxel stats, profile, isophotes, compare and explain: their numbers against NumPy and luxel probe, their forms, and
what they refuse."""
import csv
import io
import json
import math
import re

import numpy

from tap import Tap
from tool import SCENE, run_tests

SMALL = SCENE.replace("[36, 36]", "[41, 41]")


def values_of(tool, *arguments, scene=SMALL):
    """The picture's values and its mask, by way of files."""
    tool.run("render", "-", "-q", "-o", "values.npy", "-o", "values.csv", *arguments, stdin=scene)
    array = numpy.load(tool.file("values.npy")).astype(float)
    rows = list(csv.DictReader(io.StringIO(tool.read("values.csv").decode())))
    return array, rows


def probe(tool, x, y, *arguments, scene=SMALL):
    point, = tool.run("probe", "-", "-p", "%r,%r" % (x, y), "--json", *arguments, stdin=scene).json()["points"]
    return point


def statistics(tap, tool):
    _, rows = values_of(tool)
    values = numpy.array([float(row["value_W/sr"]) for row in rows])
    for source in ("-", "values.csv"):
        answer = tool.run("stats", source, "--json", stdin=SMALL).json()
        tap.equal(answer["pixels"], len(values), "%s: pixels" % source)
        for key, expected in (("mean", values.mean()), ("median", numpy.median(values)),
                              ("standard_deviation", values.std()), ("u0", values.min() / values.mean()),
                              ("ud", values.min() / values.max()), ("lit", (values >= 1.2e-38).mean())):
            tap.near(answer[key], float(expected), 1e-6, "%s: %s" % (source, key))
        tap.near(answer["max"]["value"], values.max(), 1e-7, "%s: max" % source)
        tap.equal(answer["min"]["value"], values.min(), "%s: min, 0 included" % source)
    circle = [float(row["value_W/sr"]) for row in rows
              if math.hypot(float(row["x_mm"]) - 50, float(row["y_mm"]) + 20) <= 60]
    answer = tool.run("stats", "-", "--region", "50,-20,60", "--json", stdin=SMALL).json()
    tap.equal((answer["pixels"], answer["region"]), (len(circle), {"center": [50, -20], "radius": 60}), "a circle")
    tap.near(answer["median"], float(numpy.median(circle)), 1e-6, "its median")
    box = [float(row["value_W/sr"]) for row in rows
           if abs(float(row["x_mm"])) <= 40 and abs(float(row["y_mm"]) - 10) <= 30]
    answer = tool.run("stats", "-", "--region", "0,10,80,60", "--json", stdin=SMALL).json()
    tap.near(answer["standard_deviation"], float(numpy.std(box)), 1e-6, "of a rectangle")


def histogram(tap, tool):
    _, rows = values_of(tool)
    values = numpy.array([numpy.float32(row["value_W/sr"]) for row in rows]).astype(float)
    answer = tool.run("stats", "-", "--histogram", "--bins", "10", "--scale", "1,9", "--json", stdin=SMALL).json()
    counts, edges = numpy.histogram(values, bins=10, range=(1, 9))
    found = answer["histogram"]
    tap.equal(found["counts"], counts.tolist(), "counts as NumPy's")
    tap.ok(numpy.allclose(found["edges"], edges, rtol=1e-15), "edges as NumPy's")
    tap.equal(sum(found["counts"]) + found["below"] + found["above"], len(values), "nothing is lost")
    answer = tool.run("stats", "-", "--histogram", "--log", "--json", stdin=SMALL).json()["histogram"]
    tap.equal((answer["scale"], sum(answer["counts"])), ("log", int((values > 0).sum())), "logarithmic")
    text = tool.run("stats", "-", "--histogram", stdin=SMALL)
    tap.equal((text.code, text.err), (0, ""), "as text")
    tap.ok("█" in text.out and "true maximum" in text.out, "with bars", text.out)


def extrema(tap, tool):
    answer = tool.run("stats", "--json").json()
    tap.near(answer["maximum"]["value"], 11.747879166893981, 1e-13, "the true maximum of the report")
    tap.near(answer["maximum"]["screen"][0], 177.48276, 1e-7, "where it is")
    tap.equal((answer["maximum"]["place"], answer["minimum"]["place"]), ("inside", "plateau"), "the kinds of places")
    x, y = answer["maximum"]["screen"]
    tap.equal(tool.run("probe", "-p", "%r,%r" % (x, y), "--json").json()["points"][0]["value"],
              answer["maximum"]["value"], "luxel probe says the same there")


def profiles(tap, tool):
    answer = tool.run("profile", "three-lights", "--from", "-200,50", "--to", "100,-30", "--samples", "7",
                      "--json").json()
    tap.equal((answer["path"], len(answer["samples"]), answer["lights"]), ("line", 7, ["key", "fill", "rim"]), "a line")
    for sample in answer["samples"]:
        x, y = sample["screen"]
        point, = tool.run("probe", "three-lights", "-p", "%r,%r" % (x, y), "--json").json()["points"]
        tap.equal((sample["value"], sample["error"]), (point["value"], point["error"]), "the probe's value, to the bit")
        tap.equal(sample["lights"], [light["diffuse"] + light["specular"] for light in point["lights"]], "its shares")
    arc = tool.run("profile", "--from", "-100,40", "--to", "150,-20", "--arc", "--samples", "11", "--json").json()
    places = [[*sample["screen"], math.sqrt(300 ** 2 - sum(c * c for c in sample["screen"]))]
              for sample in arc["samples"]]  # from the sphere's centre
    steps = [math.degrees(math.acos(sum(a * b for a, b in zip(p, q)) / 300 ** 2))
             for p, q in zip(places, places[1:])]
    tap.ok(max(steps) - min(steps) < 1e-6, "equal angles", steps)
    tap.near(arc["samples"][-1]["angle"], sum(steps), 1e-9, "which add up")
    tap.near(arc["samples"][5]["value"], tool.run("probe", "-p", "%r,%r" % tuple(arc["samples"][5]["screen"]),
                                                  "--json").json()["points"][0]["value"], 1e-9, "the value on the arc")
    table = tool.run("profile", "--csv", "--samples", "5")
    lines = table.out.split("\r\n")
    tap.equal((lines[0], len(lines), lines[-1]), ("distance_mm,x_mm,y_mm,value_W/sr,lights[0]", 7, ""), "CSV, RFC 4180")
    russian = tool.run("profile", "--csv=excel-ru", "--samples", "5")
    tap.ok(russian.out.startswith("\ufeffdistance_mm;x_mm;") and "\r\n125;-125;0;4,28136" in russian.out,
           "as spreadsheets in Russia read it", russian.out)
    tool.run("render", "-", "-q", "-o", "p.csv", stdin=SMALL)
    pixels = tool.run("profile", "p.csv", "--from", "-250,0", "--to", "250,0", "--samples", "41", "--json").json()
    exact = tool.run("profile", "-", "--picture", "--json", stdin=SMALL).json()
    tap.equal([s["value"] for s in pixels["samples"]], [s["value"] for s in exact["samples"]], "a file's own pixels")


def isophotes(tap, tool):
    answer = tool.run("isophotes", "-", "--levels", "2,5.5,9", "--json", stdin=SMALL).json()
    tap.equal(sorted({line["level"] for line in answer["lines"]}), [2, 5.5, 9], "levels")
    for line in answer["lines"]:
        for x, y in line["vertices"][::17]:
            tap.near(probe(tool, x, y)["value"], line["level"], 1e-9, "a vertex on its level by luxel probe")
    result = tool.run("isophotes", "-", "--levels", "5,", "-o", "lines.csv", stdin=SMALL)
    rows = list(csv.reader(io.StringIO(tool.read("lines.csv").decode(), newline="")))
    tap.equal((result.code, rows[0]), (0, ["line", "level_W/sr", "closed", "x_mm", "y_mm"]), "CSV to a file")
    tap.ok(all(len(row) == 5 and row[1] == "5" for row in rows[1:]), "rows", rows[1])


def comparison(tap, tool):
    tool.write("a.yaml", SMALL)
    tool.write("b.yaml", SMALL.replace("shininess: 20", "shininess: 25"))
    same = tool.run("compare", "a.yaml", "a.yaml", "--json")
    tap.equal((same.code, same.json()["same"], same.json()["largest"]["value"]), (0, True, 0), "a scene with itself")
    result = tool.run("compare", "a.yaml", "b.yaml", "--json", "-o", "d.npy", "-o", "d.png")
    made = result.json()
    a = numpy.load(tool.file(tool_render(tool, "a.yaml"))).astype(float)
    b = numpy.load(tool.file(tool_render(tool, "b.yaml"))).astype(float)
    tap.equal((result.code, made["same"]), (1, False), "two scenes that differ")
    tap.near(made["largest"]["value"], float(numpy.abs(b - a).max()), 1e-7, "the largest difference")
    column, row = made["largest"]["pixel"]
    tap.near(abs(b[row, column] - a[row, column]), made["largest"]["value"], 1e-7, "where it is")
    tap.ok(numpy.allclose(numpy.load(tool.file("d.npy")), b - a, atol=1e-6), "the picture of differences")
    tap.near(made["rms"], float(numpy.sqrt(((b - a)[a != 0] ** 2).mean())), 0.05, "about the root mean square")
    tap.equal(tool.run("compare", "a.yaml", "b.yaml", "--tolerance", "0.5").code, 0, "within a tolerance")
    tap.equal(tool.run("compare", "a.yaml.npy", "a.yaml").code, 0, "a file of values that tells no mask")
    tap.equal(tool.run("compare", "a.yaml.npy", "b.yaml", "-s", "surfaces[0].material.shininess=20").code, 0,
              "-s changes the scene alone")
    table = tool.run("compare", "a.yaml", "b.yaml", "--csv").out.split("\r\n")
    tap.equal(len(table[0].split(",")), len(table[1].split(",")), "CSV")


def passed_over(tap, tool):
    """Columns of a table of values that are not used are told, whichever command reads it."""
    tool.write("t.csv", "x,y,value,Camera,Dose\n" + "".join("%d,%d,%d,3,4\n" % (i % 3, i // 3, i) for i in range(9)))
    for command in (["stats", "t.csv"], ["compare", "t.csv", "t.csv"], ["isophotes", "t.csv", "--levels", "2"]):
        result = tool.run(*command)
        tap.ok(result.code == 0 and 't.csv:1:11: advice: columns that are not used: "Camera", "Dose"\n' in result.err,
               command[0], result)
        tap.equal(tool.run(*command, "-q").err, "", command[0] + " -q")


def tool_render(tool, scene):
    tool.run("render", scene, "-q", "-o", scene + ".npy")
    return scene + ".npy"


def quantities(tap, tool):
    """Every name of a quantity is that of what is shown, by --quantity and the units of the scene."""
    names = {("radiometric", "brightness"): "brightness", ("photometric", "brightness"): "luminance",
             ("radiometric", "irradiance"): "irradiance", ("photometric", "irradiance"): "illuminance"}
    for (units, quantity), name in names.items():
        options = ["-s", "units=" + units, "--quantity", quantity, "-s", "screen.resolution=[50, 40]"]
        title = tool.run("explain", "desk", *options, "-p", "0,100").out.splitlines()[0]
        tap.equal(title, "The %s seen at x = 0, y = 100 mm" % name, "explain: " + name)
        for command in ["render"], ["probe"], ["stats"], ["isophotes", "--levels", "2"], [
                "profile", "--from", "-50,0", "--to", "50,0"]:
            head = tool.run(command[0], "desk", *command[1:], *options).out
            tap.ok("desk: %s in " % name in head, "%s: %s" % (command[0], name), head[:300])
            others = set(names.values()) - {name, names[units, "irradiance"]}
            tap.ok(not any(re.search(r"\b%s\b" % other, head) for other in others), "nothing else: " + command[0],
                   head)


def explanation(tap, tool):
    answer = tool.run("explain", "-p", "0,0", "--json").json()
    point, = answer["points"]
    tap.near(point["value"], 2.7275906525546927, 1e-15, "the exact value of the report")
    found = {(a["convention"], a["choice"]): a for a in point["alternatives"]}
    tap.equal("%.4f" % found["place", "pixel"]["value"], "2.7488", "what the report prints is the pixel")
    tap.ok(found["place", "exact point"]["present"] and not found["place", "pixel"]["present"], "and is marked so")
    for alternative in point["alternatives"]:
        if alternative["assignment"] is None:
            continue
        arguments = [word for one in alternative["assignment"].split(" -s ") for word in ("-s", one)]
        result = tool.run("probe", "-p", "0,0", "--json", *arguments)
        tap.equal(result.json()["points"][0]["value"], alternative["value"],
                  "%s %s: as luxel probe with it" % (alternative["convention"], alternative["choice"]))
    text = tool.run("explain", "-p", "0,0")
    for words in ("2.748817", "2.727591", "S = max(0, N · H) = 0.8155827", "3.303504"):
        tap.ok(words in text.out, "the text has " + words, text.out)
    for name in json.loads(tool.run("scene", "--list", "--json").out)["scenes"]:
        name = name["name"] if isinstance(name, dict) else name
        for point_text in ("0,0", "1e6,0"):
            result = tool.run("explain", name, "-p", point_text)
            tap.equal((result.code, result.err), (0, ""), "%s at %s is explained" % (name, point_text))
            tap.ok("\\" not in result.out and "{" not in result.out, "without leftovers of notation", result.out)
    for ending, start in ((".txt", "The brightness"), (".md", "# The brightness"), (".tex", "\\documentclass"),
                          (".html", "<!DOCTYPE html>")):
        result = tool.run("explain", "-p", "150,0", "-o", "value" + ending)
        tap.equal((result.code, result.out), (0, ""), "to a file" + ending)
        tap.ok(tool.read("value" + ending).decode().startswith(start), "which begins as it should")


REFUSED = [
    (["stats", "--region", "0,0,-5"], 2, "must be above 0"),
    (["stats", "--region", "0,0"], 2, "X,Y,W,H or X,Y,R"),
    (["stats", "--bins", "0"], 2, "1 to 65536"),
    (["stats", "--scale", "5,1"], 2, "LOW must be below HIGH"),
    (["stats", "--histogram", "--log", "--scale", "0,1"], 2, "begin above 0"),
    (["stats", "values.npy", "-s", "units=photometric"], 2, "no scene"),
    (["stats", "nothing.npy"], 4, "nothing.npy"),
    (["isophotes", "values.npy"], 2, ".csv files do"),
    (["profile", "values.npy", "--from", "0,0", "--to", "9,9"], 2, ".csv files do"),
    (["stats", "values.npy", "--region", "0,0,5"], 2, ".csv files do"),
    (["profile", "--from", "0,0"], 2, "--from and --to go together"),
    (["profile", "--from", "0,0", "--to", "1,1", "--angle", "3"], 2, "either by --from and --to"),
    (["profile", "--arc"], 2, "needs --from and --to"),
    (["profile", "--from", "0,0", "--to", "0,0"], 2, "two different"),
    (["profile", "--from", "-240,-240", "--to", "0,0", "--arc"], 2, "no"),
    (["profile", "--through", "0,900"], 2, "does not cross"),
    (["profile", "-o", "p.png"], 2, "known extensions: .csv"),
    (["profile", "--samples", "1"], 2, "2 to 10000000"),
    (["isophotes", "--levels", "1,x"], 2, "x"),
    (["isophotes", "--levels", "0"], 2, "1 to 50"),
    (["compare", "report"], 2, "needs two"),
    (["compare", "report", "report", "report"], 2, "one too many"),
    (["compare", "report", "spot"], 1, "resolution"),
    (["explain", "-o", "x.png", "-p", "0,0"], 2, "known extensions"),
    (["explain", "-o", "x.md"], 2, "one point"),
    (["explain", "--format", "word"], 2, "text, markdown, latex, html"),
    (["profile", "--csv=word"], 2, "rfc4180, excel-ru"),
]


def refused(tap, tool):
    values_of(tool)
    before = tool.files()
    for arguments, code, words in REFUSED:
        result = tool.run(*arguments)
        tap.equal((result.code, result.out), (code, ""), "refused: " + " ".join(arguments))
        tap.ok(words in result.err, "and said why", result.err)
    tap.equal(tool.files(), before, "nothing was written")


run_tests(Tap(), statistics, histogram, extrema, profiles, isophotes, comparison, passed_over, quantities, explanation,
          refused)
