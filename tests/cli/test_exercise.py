# SPDX-License-Identifier: MIT
"""luxel variant and luxel grade: against a model of the published solution of their own, and hostile tables."""
import csv
import io
import json
import math
import os
import shutil

import numpy as np

from tap import Tap
from tool import run_tests
import yaml12


def variant(tool, number, *more):
    result = tool.run("variant", str(number), *more)
    if result.code != 0:
        result.fail("no variant")
    return yaml12.read(result.out)


def brightness(scene, x, y, place="point", **other):
    """The published formulas, for arrays of screen points; NaN off the sphere.  `other` changes a convention."""
    screen, sphere = scene["screen"], scene["surfaces"][0]
    material = {**sphere["material"], **other}
    center, radius = np.array(sphere["center"], float), sphere["radius"]
    (columns, rows), width, height = screen["resolution"], screen["width"], screen["height"]
    if place == "pixel":
        u, v = np.floor((x + width / 2) / width * (columns - 1) + 0.5), np.floor(
            (height / 2 - y) / height * (rows - 1) + 0.5)
        x, y = -width / 2 + u * width / (columns - 1), height / 2 - v * height / (rows - 1)
    dx, dy = (x - center[0]) / radius, (y - center[1]) / radius
    with np.errstate(invalid="ignore"):
        normal = np.stack([dx, dy, np.sqrt(1 - dx * dx - dy * dy)])
    total = 0
    for light in scene["lights"]:
        towards = np.array(light["position"], float).reshape((3,) + (1,) * dx.ndim) - (
            center.reshape((3,) + (1,) * dx.ndim) + radius * normal)
        distance = np.sqrt((towards ** 2).sum(axis=0))
        towards = towards / distance
        half = towards + np.array([0, 0, 1.0]).reshape((3,) + (1,) * dx.ndim)
        half = half / np.sqrt((half ** 2).sum(axis=0))
        cosine, power = np.maximum(0, (normal * towards).sum(axis=0)), np.maximum(0, (normal * half).sum(axis=0))
        e = light["intensity"] * (1 / (distance / 1000) ** 2 if other.get("attenuated") else 1)
        specular = 0 if material["model"] == "lambert" else material["specular"]
        total = total + e * (material["diffuse"] * cosine + specular * power ** material["shininess"])
    return total / math.pi if material["over_pi"] else total


def multiple(number, step):
    return abs(number / step - round(number / step)) < 1e-9


def variants(tap, tool):
    """Their numbers, with the ranges written down once more, and their peaks by the model."""
    seen, wrong = set(), []
    for number in [*range(1, 200), *range(999900, 1000001, 5)]:
        text = tool.run("variant", str(number)).out
        seen.add(text.split("\n", 1)[1])
        scene = yaml12.read(text)
        screen, sphere, lights = scene["screen"], scene["surfaces"][0], scene["lights"]
        (columns, rows), width, height = screen["resolution"], screen["width"], screen["height"]
        (x, y, z), radius, material = sphere["center"], sphere["radius"], sphere["material"]
        good = {
            "screen": 100 <= height <= width <= 10000 and multiple(width, 50) and multiple(height, 50),
            "pixels": 200 <= rows <= columns <= 800 and width * rows == height * columns,
            "in view": abs(x) + radius <= width / 2 and abs(y) + radius <= height / 2,
            "sphere": multiple(x, 50) and multiple(y, 50) and multiple(z, 100) and 50 <= radius <= 2000 and
                      multiple(radius, 50) and 100 <= z - radius and z <= 10000,
            "observer": z + radius < scene["observer"]["z"] <= 10000,
            "material": all(0 < material[key] <= 1 and multiple(material[key], 0.05) for key in ("diffuse", "specular"))
                        and 1 <= material["shininess"] <= 500,
            "sources": len(lights) == (2 if number % 3 == 0 else 1) and all(
                max(abs(light["position"][0]), abs(light["position"][1])) <= 10000 and
                100 <= light["position"][2] <= 10000 and all(multiple(p, 100) for p in light["position"]) and
                0.01 <= light["intensity"] <= 10000 and float("%.2g" % light["intensity"]) == light["intensity"]
                for light in lights),
            "points": len(scene["points"]) == 5 and scene["points"][0] == [x, y] and all(
                0 < math.hypot(px - x, py - y) < 0.8 * radius and 0 in (px - x, py - y)
                for px, py in scene["points"][1:]),
            "comment": text.startswith("# Variant %d:" % number),
        }
        grid = np.linspace(-radius, radius, 81)
        gx, gy = np.meshgrid(grid + x, grid + y)
        values = brightness(scene, gx, gy)
        peak = np.nanargmax(values)
        far = np.hypot(gx.flat[peak] - x, gy.flat[peak] - y) / radius
        diffuse = np.nanmax(brightness(scene, gx, gy, model="lambert"))
        away = np.hypot(gx - gx.flat[peak], gy - gy.flat[peak]) > 0.45 * radius
        good["the peak inside"] = 0.2 < far < 0.8
        good["the highlight"] = values.flat[peak] > 1.2 * diffuse
        good["contrast"] = values.flat[peak] > 2 * np.nanmean(values)
        good["one peak"] = np.nanmax(values[away]) < 0.95 * values.flat[peak]
        wrong += ["%d: %s" % (number, key) for key, well in good.items() if not well]
    tap.ok(not wrong, "every number is round and in its range, every peak stands out", *wrong[:9])
    tap.equal(len(seen), 220, "all are different")


def variant_outputs(tap, tool):
    plain = tool.run("variant", "17")
    tap.equal((plain.code, plain.err), (0, ""), "luxel variant 17")
    tap.equal(tool.run("variant", "17").out, plain.out, "again the same")
    made = tool.run("variant", "17", "-o", "a.yaml", "-o", "b.yml")
    tap.equal((made.code, made.out, tool.read("a.yaml").decode(), tool.read("b.yml").decode()),
              (0, "", plain.out, plain.out), "-o FILE")
    tap.equal(tool.run("variant", "17", "--json").json(), {"variant": 17, "text": plain.out}, "--json")
    tap.equal(tool.run("check", "a.yaml", "--strict").code, 0, "luxel check --strict")
    tap.equal(tool.run("advise", "a.yaml").out, "a.yaml: nothing to advise\n", "luxel advise")
    changed = tool.run("variant", "17", "-s", "lights[0].attenuation=inverse-square")
    tap.equal(changed.out, plain.out.replace("attenuation: none", "attenuation: inverse-square", 1), "-s")
    for arguments, code, words in ((["0"], 2, "1 to 1000000"), (["1000001"], 2, "1 to 1000000"), (["-1"], 2, "-1"),
                                   (["1.5"], 2, "whole"), (["x"], 2, "whole"), ([], 2, "number"), (["1", "2"], 2, "2"),
                                   (["1", "-s", "lights[0].intensity=-1"], 3, "intensity"),
                                   (["1", "-s", "nothing=1"], 2, "nothing"), (["1", "-o", "a.png"], 2, ".yaml"),
                                   (["1", "-o", "c.yaml", "-o", "./c.yaml"], 2, "same file"),
                                   (["1", "-o", "gone/c.yaml"], 4, "gone/c.yaml"),
                                   (["1", "--strict", "-s", "surfaces[0].radius=5"], 3, "radius")):
        bad = tool.run("variant", *arguments)
        tap.ok(bad.code == code and words in bad.err, "refused: " + " ".join(arguments), bad)
    tap.equal(tool.files(), ["a.yaml", "b.yml"], "and nothing is written")


NUMBERS = [3, 7, 12, 20, 31]


def answers(tool, digits, *more, **other):
    """Lines of answers for the points of some variants, by the model."""
    lines = []
    for number in NUMBERS:
        scene = variant(tool, number, *more)
        for i, (x, y) in enumerate(scene["points"]):
            value = float(brightness(scene, np.array(float(x)), np.array(float(y)), **other))
            lines.append((number, i + 1, x, y, "%.*g" % (digits, value), value))
    return lines


def table(rows, separator=",", end="\n"):
    return end.join(separator.join(str(cell) for cell in row) for row in rows) + end


def right_answers(tap, tool):
    exact = answers(tool, 5)
    tool.write("points.csv", table([("variant", "point", "value"), *[row[:2] + row[4:5] for row in exact]]))
    tool.write("places.csv", "\ufeff" + table(
        [("y_mm", "x_mm", "value_W/sr", "remark", "variant", "student"),
         *[(row[3], row[2], row[4].replace(".", ","), '"a;\r\n""b"', row[0], "Ann") for row in exact]], ";", "\r\n"))
    tool.write("tabs.csv", table([("VARIANT", "Point", "value"), *[(row[0], "P%d" % row[1], " %s " % row[4])
                                                                   for row in exact]], "\t", "\r"))
    tool.write("quoted.csv", table([('"variant"', '"point"', '"value"'), *[
        ('"%d"' % row[0], '"%d"' % row[1], '"%s"' % row[4].replace(".", ",")) for row in exact]]))
    for name in tool.files():
        result = tool.run("grade", name)
        lines = result.out.splitlines()
        told = [line for line in result.err.splitlines() if "advice: " in line]
        expected = ['places.csv:1:22: advice: columns that are not used: "remark"'] if name == "places.csv" else []
        tap.equal((result.code, told, lines[:2]), (0, expected, ["TAP version 13", "1..25"]), name)
        tap.ok(sum(line.startswith("ok ") for line in lines) == 25 and "not ok" not in result.out,
               "all of them are right", result)
    judged = tool.run("grade", "points.csv", "--json").json()
    loose = [answer for answer, row in zip(judged["answers"], exact)
             if abs(answer["value"] - row[5]) > 1e-11 * abs(row[5]) + answer["error"]]
    tap.ok(len(judged["answers"]) == 25 and not loose, "the exact values are those of the model", *loose[:3])
    tap.equal((judged["right"], judged["convention"], judged["wrong"], judged["mistakes"], judged["tolerance"]),
              (25, 0, 0, 0, 0.001), "the totals")
    few = answers(tool, 3)
    tool.write("few.csv", table([("variant", "point", "value"), *[row[:2] + row[4:5] for row in few]]))
    tap.equal(tool.run("grade", "few.csv").code, 0, "three digits are enough")


def verdicts(tap, tool, lines, *more):
    tool.write("a.csv", table([("variant", "point", "value"), *[row[:2] + row[4:5] for row in lines]]))
    result = tool.run("grade", "a.csv", "--json", *more)
    return result, result.json()["answers"]


def conventions(tap, tool):
    """Whole tables by another convention: each answer that differs is explained by it."""
    # away from the highlight it is all one whether there is none or another one
    for name, choices, other in (("pixels", ["pixel"], {"place": "pixel"}), ("over pi", ["true"], {"over_pi": True}),
                                 ("no highlight", ["lambert", "phong", "cosine"], {"model": "lambert"}),
                                 ("attenuated", ["inverse-square"], {"attenuated": True})):
        result, judged = verdicts(tap, tool, answers(tool, 6, **other))
        named = [answer for answer in judged if answer["verdict"] == "convention" and
                 any(part["choice"] in choices for part in answer["explanations"])]
        wrong = [answer for answer in judged if answer["verdict"] == "wrong"]
        right = [answer for answer in judged if answer["verdict"] == "right"]
        tap.ok(result.code == 1 and len(named) >= 0.9 * (25 - len(right)) and len(named) > 10 and not wrong,
               name + " is recognised", "named %d, right %d" % (len(named), len(right)), *judged[:4])
        single = [answer for answer in named if len(answer["explanations"]) == 1]
        tap.ok(len(single) == len(named), "and one choice is enough for " + name)
    both, judged = verdicts(tap, tool, answers(tool, 7, over_pi=True, attenuated=True))
    pairs = [sorted(part["choice"] for part in answer["explanations"]) for answer in judged]
    tap.ok(pairs.count(["inverse-square", "true"]) >= 23, "two choices together are recognised", *pairs)
    changed, judged = verdicts(tap, tool, answers(tool, 6, attenuated=True), "-s",
                               "lights[0].attenuation=inverse-square")
    ones = [answer for answer in judged if answer["variant"] % 3 != 0]
    tap.ok(all(answer["verdict"] == "right" for answer in ones), "with -s the changed variants count", changed)


def output_forms(tap, tool):
    exact = answers(tool, 6)
    rows = [("student", "variant", "point", "value")]
    rows += [("Ann # TODO", *row[:2], row[4]) for row in exact[:5]]
    rows += [("Боб\\", *row[:2], "%.6g" % (row[5] / math.pi)) for row in exact[:5]]
    rows += [("'Eve'", 7, 1, "123.4"), ("'Eve'", 7, 3, "off"), ("'Eve'", 7, 2, "-3")]
    tool.write("a.csv", table(rows))
    result = tool.run("grade", "a.csv")
    tap.equal(result.code, 1, "some are wrong")
    lines = result.out.splitlines()
    tap.ok("ok 1 - a.csv:2: Ann \\# TODO, variant 3, P1 (" in result.out, "a # in a name is no directive", result)
    tap.ok("explanation: 'division by π: true'" in result.out, "the convention is named", result)
    tap.equal([line.split(", ", 1)[1] for line in lines if line.startswith("# ")],
              ["Ann # TODO: 5 right, 0 by another convention, 0 wrong",
               "Боб\\: 0 right, 5 by another convention, 0 wrong",
               "'Eve': 0 right, 0 by another convention, 3 wrong; 3 of 5 points answered"],
              "a line for each submission")
    numbers = [int(line.split(" - ")[0].split()[-1]) for line in lines if line.startswith(("ok", "not ok"))]
    tap.equal((numbers, lines[1]), (list(range(1, 16)), "1..15"), "the plan and the numbers")
    tap.equal((result.out.count("  ---\n"), result.out.count("  ...\n")), (10, 10),
              "a block for each that is not right")
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal([list(data), list(data["answers"][0])],
              [["tolerance", "answers", "missing_points", "submissions", "right", "convention", "wrong",
                "too_few_digits", "repeated", "missing", "mistakes"],
               ["file", "line", "student", "variant", "point", "screen", "answer", "verdict", "too_few_digits", "value",
                "error", "factor", "relative", "accepted", "explanations"]], "the keys")
    tap.equal([answer["verdict"] for answer in data["answers"]], ["right"] * 5 + ["convention"] * 5 + ["wrong"] * 3,
              "the verdicts")
    tap.equal(data["answers"][5]["explanations"][0],
              {"convention": "division by π", "choice": "true", "assignment": "surfaces[0].material.over_pi=true"},
              "the explanation")
    tap.equal(data["submissions"][1],
              {"file": "a.csv", "student": "Боб\\", "asked": 5, "answered": 5, "right": 0, "convention": 5, "wrong": 0,
               "too_few_digits": 0, "repeated": 0, "missing": 0}, "a submission")
    listed = list(csv.DictReader(io.StringIO(tool.run("grade", "a.csv", "--csv").out, newline="")))
    tap.equal([row["verdict"] for row in listed],
              [answer["verdict"] for answer in data["answers"]] + ["missing"] * 2, "--csv")
    tap.equal([float(row["value"]) for row in listed[:13]], [answer["value"] for answer in data["answers"]],
              "its numbers are the same")
    tap.equal([row["factor"] for row in listed[12:]], [repr(data["answers"][12]["factor"]), "", ""], "and the factor")
    excel = tool.run("grade", "a.csv", "--csv=excel-ru").out
    tap.ok(excel.startswith("\ufefffile;line;") and ";0,5" not in excel.split("\r\n")[0], "--csv=excel-ru")
    tap.equal(tool.run("grade", "a.csv", "--csv", "--json").code, 2, "--csv and --json exclude each other")


def digits(tap, tool):
    scene = variant(tool, 7)
    x, y = scene["points"][0]
    value = float(brightness(scene, np.array(float(x)), np.array(float(y))))
    cases = [("%.1e" % value, value, True), ("%.0f" % value, value, True), ("%.10g" % value, value, False)]
    for text, _, coarse in cases:
        tool.write("a.csv", "variant,point,value\n7,1,%s\n" % text)
        answer = tool.run("grade", "a.csv", "--json").json()["answers"][0]
        near = abs(float(text) - value) <= 1e-3 * value + 0.5 * 10.0 ** (math.floor(math.log10(float(text))) - 2)
        tap.equal((answer["too_few_digits"], answer["verdict"]),
                  (coarse and not near, "right" if near or not coarse else "too_few_digits"), "the answer " + text)


def rounding(tap, tool):
    """What is the exact value correctly rounded to one or two digits is that, and never another convention."""
    seen = 0
    for number in range(1, 41):
        scene = variant(tool, number)
        values = [float(brightness(scene, np.array(float(x)), np.array(float(y)))) for x, y in scene["points"]]
        for count in (1, 2):
            rows = [(number, i + 1, "%.*e" % (count - 1, value)) for i, value in enumerate(values)]
            tool.write("a.csv", table([("variant", "point", "value"), *rows]))
            result = tool.run("grade", "a.csv", "--json")
            coarse = 0
            for answer, value, row in zip(result.json()["answers"], values, rows):
                off, half = abs(float(row[2]) - value), 0.5 * 10.0 ** (math.floor(math.log10(value)) + 1 - count)
                third = half * 10.0 ** (count - 3)
                right = off <= 1e-3 * value + min(half, max(third, 1e-4 * max(values)))
                coarse += not right
                tap.equal(answer["verdict"], "right" if right else "too_few_digits",
                          "variant %d, %s for %g" % (number, row[2], value))
            tap.equal(result.code, 1 if coarse else 0, "its exit code")
            seen += coarse
    tap.ok(seen > 150, "most are coarse", seen)


def missing_and_repeated(tap, tool):
    scene = variant(tool, 17)
    exact = ["%.6g" % float(brightness(scene, np.array(float(x)), np.array(float(y)))) for x, y in scene["points"]]
    tool.write("a.csv", "student,variant,point,value\nA,17,1,%s\n" % exact[0])
    result = tool.run("grade", "a.csv")
    tap.ok(result.code == 1 and "1..5\n" in result.out and "1 of 5 points answered" in result.out and
           [line.startswith("not ok") and line.endswith(": no answer") for line in result.out.splitlines()
            if " - " in line] == [False, True, True, True, True], "one of five answers", result)
    rows = [(17, 1, exact[0]), (17, 1, "77"), (17, 1, exact[0])] + [(17, i, exact[i - 1]) for i in range(2, 6)]
    tool.write("a.csv", table([("variant", "point", "value"), *rows]))
    data = tool.run("grade", "a.csv", "--json")
    tap.equal((data.code, data.json()["right"], data.json()["repeated"], data.json()["missing"]), (1, 5, 2, 0),
              "three tries at one point")
    tap.equal([answer.get("first_line") for answer in data.json()["answers"]], [None, 2, 2] + [None] * 4,
              "and where the first one stands")
    tap.ok("answered in line 2 already" in tool.run("grade", "a.csv").out, "in TAP")
    places = [(17, *scene["points"][i], exact[i]) for i in (0, 1, 2, 3, 4, 0)]
    tool.write("a.csv", table([("variant", "x", "y", "value"), *places]))
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal(([answer["point"] for answer in data["answers"]], data["repeated"]), ([1, 2, 3, 4, 5, 1], 1),
              "a place is known as the point that it is")
    tool.write("a.csv", table([("student", "variant", "point", "value"),
                               *[(who, 17, i, exact[i - 1]) for i in range(1, 6) for who in ("A", "B")]]))
    tap.equal(tool.run("grade", "a.csv").code, 0, "two students may answer the same points")
    tool.write("a.csv", "Фамилия;Имя;Вариант;Точка;Ответ\n" + "".join(
        "%s;17;%d;%s\n" % (who, i, exact[i - 1].replace(".", ",")) for i in range(1, 6)
        for who in ("Иванов;Пётр", "Иванов;Павел", ";Ольга")))
    data = tool.run("grade", "a.csv", "--json")
    tap.equal((data.code, [one["student"] for one in data.json()["submissions"]]),
              (0, ["Иванов Пётр", "Иванов Павел", "Ольга"]), "Russian headings, and a name of two columns")
    tool.write("a.csv", "variant,x,y,value\n17,-9000,0,off\n17,-9000,0,off\n17,-9000,1,off\n")
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal((data["right"], data["repeated"], data["missing"]), (2, 1, 0),
              "places of one's own leave nothing missing")


def folders(tap, tool):
    exact = answers(tool, 6)
    os.mkdir(tool.file("in"))
    for name, factor in (("b.csv", 1), ("a.CSV", 2), ("c d.csv", 1), (".hidden.csv", 1)):
        tool.write("in/" + name, table([("variant", "point", "value"),
                                        *[(*row[:2], "%.6g" % (row[5] * factor)) for row in exact]]))
    tool.write("in/notes.txt", "nothing")
    result = tool.run("grade", "in")
    comments = [line for line in result.out.splitlines() if line.startswith("#")]
    tap.ok(comments[0].startswith("# in/a.CSV: ") and " 25 right" not in comments[0], "a submission of other answers")
    tap.equal(comments[1:],
              ["# in/b.csv: 25 right, 0 by another convention, 0 wrong",
               "# in/c d.csv: 25 right, 0 by another convention, 0 wrong"], "each file is a submission")
    tap.equal(result.code, 1, "its exit code")
    tap.equal(result.err, "luxel: skipped: in/notes.txt is no .csv or .tsv file\n", "what is skipped is told")
    several = tool.run("grade", "in/b.csv", "in/c d.csv")
    tap.ok(several.code == 0 and "1..50" in several.out, "several files", several)
    tool.write("in/z.csv", "no table\n")
    broken = tool.run("grade", "in/", "--json")
    tap.ok(broken.code == 4 and "in/z.csv:1:1: error:" in broken.err and broken.json()["mistakes"] == 1 and
           len(broken.json()["answers"]) == 75, "one that is no table does not stop the others", broken)
    os.mkdir(tool.file("empty"))
    for name, words in (("empty", ".csv"), ("gone.csv", "gone.csv"), ("gone/", "gone/")):
        bad = tool.run("grade", name)
        tap.ok(bad.code == 4 and words in bad.err and not bad.out, "refused: " + name, bad)
    tap.equal(tool.run("grade").code, 2, "without a table")
    shutil.rmtree(tool.file("in"))


MALFORMED = [
    ("1,1,abc", 1, 5), ("0,1,2", 1, 1), ("1000001,1,2", 1, 1), ("1.5,1,2", 1, 1), ("1,6,2", 1, 1),
    ("1,0,2", 1, 3), ("1,P,2", 1, 3), ("1,-1,2", 1, 3), ("1,1", 1, 1), ("1,1,2,3", 1, 1), ("1,1,2,,3", 1, 1),
    ("1,1,inf", 1, 5), ("1,1,0x10", 1, 5), ("1,1,1e99999", 1, 5), ("1,1,1e999", 1, 5), ("1,1,2 mm", 1, 5),
    ("1,1,--2", 1, 5), ("1,1,2e", 1, 5), ('1,1,"2', 1, 5), ('1,1,"2"x', 1, 8), ("99999999999999999999,1,2", 1, 1),
    ("1,1,\u22122", 1, 5), ("Ж,1,2", 1, 1),
]


def tabs_in_folders(tap, tool):
    """Who hands in .tsv is graded beside those who hand in .csv, and other files are told unless -q is given."""
    rows = [("variant", "point", "value"), *[row[:2] + row[4:5] for row in answers(tool, 5)[:5]]]
    os.mkdir(tool.file("class"))
    tool.write("class/1_commas.csv", table(rows))
    tool.write("class/2_tabs.TSV", table(rows, "\t"))
    tool.write("class/3_sheet.xlsx", b"PK")
    os.mkdir(tool.file("class/late"))
    result = tool.run("grade", "class", "--json")
    tap.equal([(one["file"], one["right"], one["asked"]) for one in result.json()["submissions"]],
              [("class/1_commas.csv", 5, 5), ("class/2_tabs.TSV", 5, 5)], "both are graded")
    tap.equal((result.code, result.err.splitlines()),
              (0, ["luxel: skipped: class/%s is no .csv or .tsv file" % name for name in ("3_sheet.xlsx", "late")]),
              "what is skipped is told")
    tap.equal(tool.run("grade", "class", "-q").err, "", "-q")
    shutil.rmtree(tool.file("class"))
    os.mkdir(tool.file("class"))
    tool.write("class/tabs.tsv", table(rows, "\t"))
    tap.equal(tool.run("grade", "class").code, 0, "a folder of .tsv alone")
    shutil.rmtree(tool.file("class"))


def blanks(tap, tool):
    """A cell without an answer is a point without one, however that is written; off is an answer."""
    exact = answers(tool, 6)[:5]
    for word in ("", "-", "–", "—", "?", "n/a", "N/A", "нет", "Нет", " - "):
        tool.write("a.csv", table([("variant", "point", "value"), *[row[:2] + row[4:5] for row in exact[:4]],
                                   (*exact[4][:2], word)]))
        data = tool.run("grade", "a.csv", "--json")
        tap.equal((data.code, data.err, data.json()["right"], data.json()["wrong"], data.json()["mistakes"],
                   [(point["point"], point["screen"]) for point in data.json()["missing_points"]]),
                  (1, "", 4, 0, 0, [(5, [float(exact[4][2]), float(exact[4][3])])]), "missing: \"%s\"" % word)
    tool.write("a.csv", table([("student", "variant", "point", "value"), *[("A", *row[:2], "-") for row in exact]]))
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal((data["missing"], data["submissions"][0]["asked"], data["submissions"][0]["answered"]), (5, 5, 0),
              "who answers nothing is asked all the same")
    tool.write("a.csv", table([("variant", "point", "value"), (*exact[0][:2], "?"), exact[0][:2] + exact[0][4:5],
                               (*exact[1][:2], "off")]))
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal((data["right"], data["wrong"] + data["convention"], data["repeated"], data["missing"]), (1, 1, 0, 3),
              "an answer after a blank counts, and off is one")
    tool.write("a.csv", "variant,x,y,value\n17,-9000,0,-\n17,-9000,0,off\n")
    data = tool.run("grade", "a.csv", "--json").json()
    tap.equal((data["right"], data["repeated"]), (1, 0), "a blank at a place of its own is no first answer")


def accepted_pixels(tap, tool):
    """Published answers are those of pixels: with --accept pixel they are right, and what else is wrong stays wrong."""
    exact, pixels = answers(tool, 6), answers(tool, 6, place="pixel")
    away = sum(abs(a[5] - b[5]) > 2e-3 * a[5] for a, b in zip(exact, pixels))
    tap.ok(away > 5, "the pixels differ from the points", away)
    twice = [(*row[:4], "%.6g" % (2 * row[5]), 2 * row[5]) for row in pixels]
    for name, lines, code in (("pixels", pixels, 0), ("points", exact, 0), ("twice the pixels", twice, 1)):
        result, judged = verdicts(tap, tool, lines, "--accept", "pixel")
        right = sum(answer["verdict"] == "right" for answer in judged)
        tap.equal((result.code, right), (code, 25 if code == 0 else 0), name + " with --accept pixel")
        by = [answer for answer in judged if answer["accepted"]]
        loose = [answer for answer in by if answer["accepted"] != "pixel" or
                 abs(answer["answer"] - answer["value"]) > 1.1e-3 * abs(answer["value"])]
        tap.ok(not loose and (len(by) >= away) == (name == "pixels"), "by the pixel where the point is off", *by)
    tap.equal(tool.run("grade", "a.csv", "--accept", "anything").code, 2, "another word")
    tap.equal(verdicts(tap, tool, pixels)[0].code, 1, "without it they are not")


def how_far_off(tap, tool):
    exact = answers(tool, 17)[:5]
    rows = [(*row[:2], "%.17g" % (row[5] * factor)) for row, factor in zip(exact, (2, 0.31, -1, 1, 0))]
    tool.write("a.csv", table([("variant", "point", "value"), *rows]))
    judged = tool.run("grade", "a.csv", "--json").json()["answers"]
    factors = [answer["factor"] for answer in judged]
    tap.ok(all(abs(one - other) < 1e-9 for one, other in zip(factors, (2, 0.31, -1, 1, 0))), "factors", factors)
    tap.ok(all(abs(answer["relative"] - (answer["factor"] - 1)) < 1e-12 for answer in judged), "relative", judged)
    out = tool.run("grade", "a.csv").out
    tap.ok("\n  factor: 2\n  relative: 1\n" in out and "\n  factor: 0.31\n  relative: -0.69\n" in out, "in TAP", out)


def by_student(tap, tool):
    """One line a student: the same counts as JSON's, variants, and the file's name where there is no student's."""
    exact = answers(tool, 6)
    os.mkdir(tool.file("in"))
    tool.write("in/Smith.csv", table([("variant", "point", "value"), *[row[:2] + row[4:5] for row in exact[:10]]]))
    tool.write("in/two.csv", table([("student", "variant", "point", "value"),
                                    *[("A; B", *row[:2], "%.6g" % (3 * row[5])) for row in exact[:3]],
                                    *[("Лев", *row[:2], row[4]) for row in exact[5:10]]]))
    data = tool.run("grade", "in", "--json").json()
    result = tool.run("grade", "in", "--students")
    listed = list(csv.DictReader(io.StringIO(result.out, newline="")))
    first, second = str(exact[0][0]), str(exact[5][0])
    tap.equal((result.code, [(row["student"], row["variants"]) for row in listed]),
              (1, [("Smith", first + " " + second), ("A; B", first), ("Лев", second)]), "students and variants")
    tap.equal([[int(row[key]) for key in list(row)[3:]] for row in listed],
              [[one[key] for key in list(listed[0])[3:]] for one in data["submissions"]], "the counts of --json")
    excel = tool.run("grade", "in", "--csv=excel-ru", "--students").out
    tap.ok(excel.startswith("\ufefffile;student;variants;") and '"A; B";' in excel, "for spreadsheets", excel)
    tap.equal(tool.run("grade", "in", "--students", "--json").code, 2, "not with --json")
    shutil.rmtree(tool.file("in"))


def dialects(tap, tool):
    """One table of answers in the encodings and with the headings that programs write."""
    rows = [row[:2] + row[4:5] for row in answers(tool, 5)[:5]]
    plain, body = table([("variant", "point", "value"), *rows]), table(rows, ";", "\r\n").replace(".", ",")
    russian = "вариант;точка;значение, Вт/ср\r\n" + body
    expected = None
    for name, data in (("plain", plain.encode()), ("UTF-16", plain.encode("utf-16")),
                       ("code page 1251", russian.encode("cp1251")), ("sep=;", ("sep=;\n" + russian).encode()),
                       ("capitals", russian.replace("вариант", "ВАРИАНТ").encode()),
                       ("numbered lines", table([("", "variant", "point", "value"),
                                                 *[(i, *row) for i, row in enumerate(rows)]]).encode()),
                       ("a comment before", ("# group 5\n" + plain).encode())):
        tool.write("a.csv", data)
        result = tool.run("grade", "a.csv", "--json")
        judged = [(answer["variant"], answer["point"], answer["answer"]) for answer in result.json()["answers"]]
        expected = expected or judged
        tap.ok(result.code == 0 and judged == expected and len(judged) == 5, "read: " + name, result)


def passed_over(tap, tool):
    """Columns that nobody reads are told, with their line and what is understood; what only names rows is not."""
    rows = [row[:2] + row[4:5] for row in answers(tool, 5)[:5]]
    body = table([(1, *row, "b", "9.5") for row in rows])
    for name, heading, place in (("English", "id,variant,point,value,Group,Mark\n", "a.csv:1:24"),
                                 ("below a comment", "# June\n\nn,variant,point,value,Group,Mark\n", "a.csv:3:23"),
                                 ("Russian", "№,вариант,точка,значение,Group,Mark\n", "a.csv:1:26")):
        tool.write("a.csv", heading + body)
        result = tool.run("grade", "a.csv")
        tap.ok(result.code == 0 and place + ': advice: columns that are not used: "Group", "Mark"\n' in result.err and
               "variant/вариант, value/answer/значение/ответ, point/точка, x, y, student/" in result.err and
               result.out.count("\nok ") == 5, name, result)
        tap.equal(tool.run("grade", "a.csv", "-q").err, "", "-q: " + name)
    tool.write("a.csv", table([("id", "variant", "point", "value"), *[(1, *row) for row in rows]]))
    tap.equal(tool.run("grade", "a.csv").err, "", "nothing else is there")
    header = b"\x93NUMPY\x01\x00\x46\x00{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }"
    tool.write("a.npy", header.ljust(80) + bytes(24))
    result = tool.run("grade", "a.npy")
    tap.ok(result.code == 4 and "names no columns" in result.err and "variant, value, point" in result.err, "an array",
           result)


def malformed(tap, tool):
    for text, line, column in MALFORMED:
        tool.write("a.csv", "variant,point,value\n" + text + "\n")
        bad = tool.run("grade", "a.csv")
        tap.ok(bad.code == 4 and bad.err.startswith("a.csv:%d:%d: error: " % (line + 1, column)) and not bad.out,
               "refused: " + text, bad)
    tool.write("a.csv", "variant,point,value\n1,1,x\n1,2,y\n\n1,3,2\n1,P4,z\n")
    many = tool.run("grade", "a.csv")
    tap.ok(many.code == 4 and many.err.count("error: ") == 3 and "a.csv:6:6:" in many.err and "1..5\n" in many.out,
           "all malformed lines are reported, and the others judged", many)
    for name, text in (("no header", "1,1,2\n"), ("no value", "variant,point\n1,1\n"),
                       ("neither point nor place", "variant,value,x\n1,2,3\n"), ("empty", ""), ("blank", "\n \n\r\n"),
                       ("a column twice", "variant,point,value,value\n1,1,2,2\n"),
                       ("no answers", "variant,point,value\n"),
                       ("a picture", b"\x89PNG\r\n\x1a\n\x00\x00"), ("bytes", bytes(range(1, 256)) * 40),
                       ("quotes", b'"' * 99999), ("commas", b"," * 99999 + b"\n"), ("one long line", b"a" * 1000000)):
        tool.write("a.csv", text)
        bad = tool.run("grade", "a.csv", timeout=20)
        tap.ok(bad.code == 4 and "error:" in bad.err and "\x1b" not in bad.err, "refused: " + name, bad)
    tool.write("a.csv", 'student,variant,point,value\n"\x1b[31m\nred",1,1,x\n"\x1b[31m\nred",1,1,9\n')
    hostile = tool.run("grade", "a.csv")
    tap.ok("\x1b" not in hostile.out + hostile.err and "a.csv:3:10:" in hostile.err and
           all(line.startswith(("TAP", "1..", "ok", "not ok", "  ", "#")) for line in hostile.out.splitlines()),
           "names cannot write to the terminal, nor lines of their own", hostile)


def off_the_surface(tap, tool):
    tool.write("a.csv", "variant,x,y,value\n1,-500,400,off\n1,-500,401,0\n1,150,-100,OFF\n1,9999,9999,nan\n")
    judged = tool.run("grade", "a.csv", "--json").json()["answers"]
    tap.equal([(answer["verdict"], answer["answer"], answer["value"] is None) for answer in judged],
              [("right", None, True), ("wrong", 0, True), ("wrong", None, False), ("right", None, True)],
              "answers off the surface")


def many_answers(tap, tool):
    rows = [("variant", "point", "value")] + [(1 + i // 5, 1 + i % 5, "3.14159") for i in range(400)]
    tool.write("a.csv", table(rows))
    result = tool.run("grade", "a.csv", "--csv", timeout=60)
    tap.ok(result.code == 1 and result.out.count("\r\n") == 401, "four hundred wrong answers", result.err)


def advice(tap, tool):
    report = tool.run("advise")
    tap.ok(report.code == 0 and "not wholly in view" in report.out and
           "hint: try -s 'screen.width=600' -s 'screen.height=600'" in report.out, "luxel advise", report)
    tap.equal(tool.run("advise", "-s", "screen.width=600", "-s", "screen.height=600").out,
              "report: nothing to advise\n", "after its hint")
    low = tool.run("advise", "-s", "surfaces[0].material.specular=0.02", "--json").json()
    tap.equal([entry["id"] for entry in low["advice"]], ["not-in-view", "peak-at-border", "peak-low"], "--json")
    tap.equal(low["advice"], tool.run("check", "-s", "surfaces[0].material.specular=0.02", "--json").json()["advice"],
              "luxel check says the same")
    fails = tool.run("advise", "--strict")
    tap.equal((fails.code, fails.out), (3, ""), "--strict")
    passes = tool.run("check", "distant", "--strict", "--json", "-s", "picture.range=[0,1]")
    tap.ok(passes.code == 0 and passes.json()["valid"] and passes.json()["error_count"] == 0 and
           [entry["id"] for entry in passes.json()["advice"]] == ["range-clips"],
           "advice about the picture is no error with --strict", passes)
    tap.equal(tool.run("render", "distant", "--strict", "-s", "picture.range=[0,1]").code, 0, "nor for luxel render")
    tap.equal(tool.run("advise", "distant", "-q").out, "", "--quiet")
    tap.equal(tool.run("advise", "nothing.yaml").code, 4, "a file that is not there")
    tap.equal(tool.run("advise", "-s", "lights[0].intensity=-1").code, 3, "a scene with errors")


run_tests(Tap(), variants, variant_outputs, right_answers, conventions, output_forms, digits, rounding,
          missing_and_repeated, folders, tabs_in_folders, blanks, accepted_pixels, how_far_off, by_student, dialects,
          passed_over, malformed, off_the_surface, many_answers, advice)
