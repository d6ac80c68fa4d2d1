# SPDX-License-Identifier: MIT
"""The JSON of render and probe: its members, their types, and the numbers of the report's experiment."""
import json

from tap import Tap
from tool import SCENE, run_tests

TOP = ["quantity", "unit", "resolution", "max", "min", "mean", "lit", "points"]
POINT = ["screen", "pixel", "on_surface", "value", "pixel_value", "error", "position", "normal", "albedo", "lights"]
LIGHT = ["type", "irradiance", "diffuse", "specular", "error"]
EXACT = [2.7275906525546927, 11.038015039262981, 1.1299660232888e-07]
PIXELS = ["2.7488", "11.0240", "1.1835e-07"]


def report(tap, tool):
    result = tool.run("render", "--json")
    tap.equal(result.code, 0, "render --json")
    answer = result.json()
    tap.equal(list(answer)[:len(TOP)], TOP, "members of the answer")
    tap.equal(result.out.count("\n"), 1, "one line")
    tap.equal((answer["quantity"], answer["unit"], answer["resolution"]), ("brightness", "W/sr", [360, 360]), "heading")
    tap.equal("%.4f" % answer["max"]["value"], "11.7475", "maximum")
    tap.ok(answer["min"]["value"] >= 1.2e-38, "minimum above 0", answer["min"])
    for name in "max", "min":
        tap.equal(list(answer[name]), ["value", "pixel", "screen"], "members of " + name)
        column, row = answer[name]["pixel"]
        x, y = answer[name]["screen"]
        tap.near(x, -250 + column * 500 / 359, 1e-12, name + ": x of its pixel", 1e-9)
        tap.near(y, 250 - row * 500 / 359, 1e-12, name + ": y of its pixel", 1e-9)
    tap.ok(0 < answer["mean"] < answer["max"]["value"] and 0 < answer["lit"] <= 1, "mean and lit")
    for i, point in enumerate(answer["points"]):
        tap.equal(list(point), POINT, "members of point %d" % (i + 1))
        tap.near(point["value"], EXACT[i], 1e-12, "value at point %d" % (i + 1))
        form = "%.4f" if i < 2 else "%.4e"
        tap.equal(form % point["pixel_value"], PIXELS[i], "pixel value at point %d" % (i + 1))
        tap.ok(0 <= point["error"] <= 1e-12 * EXACT[i], "error at point %d" % (i + 1), point["error"])
        tap.equal(list(point["lights"][0])[:len(LIGHT)], LIGHT, "members of its light")
    tap.equal([point["pixel"] for point in answer["points"]], [[180, 180], [287, 180], [72, 180]], "pixels")
    tap.equal(answer["points"][0]["position"], [0, 0, 1300], "position of point 1")
    tap.equal(answer["points"][0]["normal"], [0, 0, 1], "normal of point 1")
    tap.equal(answer["conventions"]["sampling"], "nodes", "conventions")


def probe_agrees(tap, tool):
    rendered = tool.run("render", "--json").json()
    probed = tool.run("probe", "--json").json()
    tap.equal(probed["points"], rendered["points"], "probe and render give the same points")
    tap.equal([probed[name] for name in ("max", "min", "mean", "lit")], [None] * 4, "probe computes no picture")
    again = tool.run("probe", "-p", "0,0", "-p", "150,0", "--point=-150,0", "--json").json()
    tap.equal(again, probed, "-p of the same points")
    tap.equal(tool.run("probe", "--json").out, tool.run("probe", "report", "--json").out, "the default is report")


def nothing_there(tap, tool):
    point = tool.run("probe", "-p", "400,0", "--json").json()["points"][0]
    tap.equal(point["on_surface"], False, "a point off the surface")
    tap.equal([point[name] for name in ("pixel", "value", "pixel_value", "error", "position", "normal")], [None] * 6,
              "has no numbers")
    tap.equal(point["lights"], [], "has no lights")
    element = tool.run("probe", "--at", "0,0,1300,0,0,2", "--json").json()["points"][0]
    tap.equal((element["screen"], element["pixel"], element["pixel_value"]), (None, None, None), "a free element")
    tap.ok(element["on_surface"] and element["value"] > 0, "has a value", element)
    tap.equal(element["normal"], [0, 0, 1], "its normal has unit length")
    order = tool.run("probe", "--at", "0,0,1300,0,0,1", "-p", "0,0", "--at", "0,0,9,0,0,1", "--json").json()["points"]
    tap.equal([point["screen"] for point in order], [None, [0, 0], None], "-p and --at keep their order")
    empty = tool.run("render", "-s", "surfaces[0].center=[9000,0,1000]", "--json").json()
    tap.equal([empty[name] for name in ("max", "min", "mean", "lit")], [None] * 4, "a picture without a surface")
    dark = tool.run("render", "-s", "lights=[]", "--json").json()
    tap.equal((dark["max"]["value"], dark["min"], dark["mean"], dark["lit"]), (0, None, 0, 0), "a dark picture")
    tap.equal((dark["points"][0]["value"], dark["points"][0]["lights"]), (0, []), "a dark point is a value")
    bare = tool.run("probe", "-", "--json", stdin=SCENE.replace("points:", "#"))
    tap.equal((bare.code, bare.json()["points"]), (0, []), "a scene without points")
    tap.ok("no points" in bare.err, "says so on standard error", bare)
    tap.equal(tool.run("probe", "-", "--json", "-q", stdin=SCENE.replace("points:", "#")).err, "", "but not with -q")


def source_on_element(tap, tool):
    result = tool.run("probe", "-p", "0,0", "-s", "lights[0].position=[0,0,1300]",
                      "-s", "lights[0].attenuation=inverse-square", "--json")
    point = result.json()["points"][0]
    tap.equal(result.code, 0, "a source on the element")
    tap.equal((point["on_surface"], point["value"], point["error"]), (True, None, None), "has no value")
    tap.ok("lights[0]" in point["reason"], "and a reason", point)
    text = tool.run("probe", "-p", "0,0", "-s", "lights[0].position=[0,0,1300]")
    tap.ok("P1 (0.0, 0.0): " in text.out and "lights[0]" in text.out, "the reason in the text", text)


def names_are_escaped(tap, tool):
    name = 'a "b" \\ ü'
    scene = SCENE.replace("type: point,", "type: point, name: %s," % json.dumps(name, ensure_ascii=False))
    answer = tool.run("probe", "-", "--json", stdin=scene).json()
    tap.equal(answer["points"][0]["lights"][0]["name"], name, "a light's name")
    tap.equal(answer["points"][0]["lights"][0]["index"], 0, "a light's index")
    tap.ok(name in tool.run("probe", "-", stdin=scene).out, "a light's name in the text")


def seventeen_digits(tap, tool):
    scene = SCENE.replace("[150, 0]", "[0.1, 0.7]")
    out = tool.run("probe", "-", "--json", stdin=scene).out
    tap.ok("0.10000000000000001" in out and "0.69999999999999996" in out, "numbers have 17 digits", out)


ROOM = """luxel: 1
reflections: all
screen: {width: 3000, height: 3000, resolution: [8, 8]}
observer: {z: 9000, projection: perspective}
surfaces: [{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000],
            material: {model: lambert, diffuse: 0.5, over_pi: true}}]
lights: [{type: ambient, irradiance: 1}]
points: [[0, 0]]
"""
BALL = ("{type: sphere, center: [0, 0, 0], radius: 900, inside: true, "
         "material: {model: lambert, diffuse: 0.5, over_pi: true}}")


def reflected_light(tap, tool):
    ways = ["--quantity", "irradiance", "--reflected-error"]
    result = tool.run("render", "-", "--json", *ways, "0.01", stdin=ROOM)
    answer = result.json()
    tap.equal((result.code, list(answer)[:len(TOP)]), (0, TOP), "reflected light")
    tap.ok(0 < answer["reflected_error"] <= 0.01, "its bound is a share of the maximum", answer["reflected_error"])
    tap.near(answer["mean"], 2, 0.01, "a closed room of reflectance 0.5 in uniform light")
    point = answer["points"][0]
    tap.near(point["value"], 2, 0.01, "a point of it")
    tap.near(point["pixel_value"], 2, 0.01, "and its pixel")
    tap.ok(abs(point["value"] - 2) <= point["error"], "within the bound", point)
    probed = tool.run("probe", "-", "--json", "-o", "p.json", *ways, "0.01", stdin=ROOM).json()["points"][0]
    tap.near(probed["pixel_value"], point["pixel_value"], 0, "which probe tells as well")
    text = tool.run("probe", "-", *ways, "0.01", stdin=ROOM).out
    tap.ok("pixel (4, 4)" in text and "pixel value" not in text, "but not in text, as it takes a solution", text)
    for command in "render", "stats":
        result = tool.run(command, "-", *ways, "1e-14", "-s", "surfaces[0]=" + BALL, "-s", "reflections=1", stdin=ROOM)
        tap.ok(result.code == 5 and "maximum" in result.out and "may be off by" in result.err,
               command + " prints a picture whose bound is not reached, and says so", result)
    result = tool.run("stats", "-", "--json", stdin=ROOM)
    sides, balance = result.json()["surfaces"], result.json()["balance"]
    tap.equal([(side["wall"], side["side"]) for side in sides[:2]], [("left", "front"), ("left", "back")], "sides")
    for side, truth in zip(sides, [2, 1] * 6):
        tap.ok(abs(side["irradiance"]["value"] - truth) <= side["irradiance"]["error"] <= 2e-3, "their means", side)
    tap.ok(balance["closes"] and balance["emitted"] is None and balance["unit"] == "W", "the balance closes", balance)
    tap.near(balance["arrives"]["value"], 2 * 96, 1e-9, "what arrives at both sides of all walls")
    tap.ok(abs(balance["absorbed"]["value"] - 96 * 1.5) <= balance["absorbed"]["error"] < 0.2, "is absorbed", balance)
    text = tool.run("stats", "-", stdin=ROOM).out
    tap.ok("surfaces[0], floor" in text and "It closes" in text, "stats prints them, too", text)
    tap.ok("balance" not in tool.run("stats", "--json").json(), "without reflections there is no balance")
    result = tool.run("report", "-", "-o", "r.md", *ways, "1e-14", "-s", "surfaces[0]=" + BALL, "-s", "reflections=1",
                      stdin=ROOM)
    if "luxel-draw" in result.err:
        tap.skip("a report that misses the bound", "built without figures")
    else:
        tap.ok(result.code == 5 and result.err.count("may be off by") == 1, "so does a report, once", result)
    result = tool.run("explain", "-", "--json", "--quantity", "irradiance", stdin=ROOM)
    told = {one["choice"]: one for one in result.json()["points"][0]["alternatives"]}
    for choice, truth in {"none": 1, "1": 1.5, "all": 2}.items():
        tap.ok(abs(told[choice]["value"] - truth) <= told[choice]["error"] <= 2e-3, "explained: " + choice, told)
    tap.ok("reflected_error" not in tool.run("render", "--json").json(), "without reflections there is no bound")


run_tests(Tap(), report, probe_agrees, nothing_there, source_on_element, names_are_escaped, seventeen_digits,
          reflected_light)
