# SPDX-License-Identifier: MIT
"""The schema and the tool judge scenes alike, but for what a schema cannot say and what only the text tells."""
import json
import os
import random
import sys

import jsonschema
import yaml
from good_scenes import FILES, good_scene
from malformed import LIGHT, SPOT, TEXTS, scenes
import luminaires
from tap import Tap
from tool import SCENE, run_tests
from yaml12 import read

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "reference"))
import scenes as reference  # noqa: E402  (another generator, of scenes whose numbers are compared)

# The only scenes of malformed.py that the schema accepts, each with the rule that it cannot say.
BEYOND = {
    "power of no cone": "a power needs a cone of some width",
    "closed ring of corners": "the last corner must not repeat the first",
    "pixels that are not square": "pixels are square",
    "screen whose pixels are not square": "pixels are square",
    "observer inside the sphere": "the observer is above every surface",
    "observer below the sphere": "the observer is above every surface",
    "rectangle with up along its axis": "up and axis are not parallel",
    "grid with up along its axis": "up and axis are not parallel",
    "up along the axis": "up and axis are not parallel",
    "up along the aim": "up and axis are not parallel",
    "aim at the center": "aim differs from center",
    "a corner twice": "an outline encloses an area",
    "corners on a line": "an outline encloses an area",
    "an area beyond reason": "an outline encloses an area",
    "corners in no plane": "an outline lies in a plane",
    "edges that cross": "the edges of an outline do not cross",
    "mesh that is the scene": "a mesh is one of the formats that are read",
    "cloud that is the scene": "a cloud is a CSV or NPY file",
    "grid of too many cells": "a grid has ten million cells at most",
    "whole number as a fraction": "a whole number has no point",
    "whole number with an exponent": "a whole number has no exponent",
    "TRUE": "true is written in small letters",
    "half of a pair": "texts are Unicode",
    "a directive": "a text has no tags",
}

# More of what is wrong, as (title, piece, replacement).
MORE = [
    ("version as a text", "luxel: 1", 'luxel: "1"'),
    ("version of a fraction", "luxel: 1", "luxel: 1.5"),
    ("true for the version", "luxel: 1", "luxel: true"),
    ("unknown shadows", "units: radiometric", "shadows: soft"),
    ("one resolution", "[36, 36]", "[36]"),
    ("three resolutions", "[36, 36]", "[36, 36, 1]"),
    ("resolution without list", "[36, 36]", "36"),
    ("resolution of texts", "[36, 36]", '["36", "36"]'),
    ("perspective at the screen", "z: 1500, projection: orthographic", "z: 0, projection: perspective"),
    ("perspective behind the screen", "z: 1500, projection: orthographic", "z: -1, projection: perspective"),
    ("nan for z", "z: 1500", "z: .nan"),
    ("infinity for z", "z: 1500", "z: -.inf"),
    ("number for a name", "radius: 200", "radius: 200\n    name: 5"),
    ("true for a name", "radius: 200", "radius: 200\n    name: true"),
    ("null for a name", "radius: 200", "radius: 200\n    name:"),
    ("list for a name", "radius: 200", "radius: 200\n    name: [a]"),
    ("a character that no name has", "radius: 200", 'radius: 200\n    name: "a\\0b"'),
    ("empty material", "material: {model: blinn-phong, diffuse: 0.8, specular: 0.5, shininess: 20, highlight: plain}",
     "material:"),
    ("radius of a light", "intensity: 10", "intensity: 10, radius: 5"),
    ("intensity of a sphere", "radius: 200", "radius: 200\n    intensity: 5"),
    ("text for yes or no", "diffuse: 0.8", 'over_pi: "true"'),
    ("null for yes or no", "diffuse: 0.8", "over_pi: ~"),
    ("negative shininess", "shininess: 20", "shininess: -1"),
    ("negative ambient", "diffuse: 0.8", "ambient: -0.1"),
    ("text in the center", "center: [0, 0, 1000]", "center: [0, 0, far]"),
    ("number for type", "type: point", "type: 5"),
    ("list for type", "type: point", "type: [point]"),
    ("type in the wrong case", "type: point", "type: Point"),
    ("light that is a list", LIGHT, "[point]"),
    ("light that is null", LIGHT, "~"),
    ("enabled by a word", "intensity: 10", "intensity: 10, enabled: on"),
    ("enabled by a number", "intensity: 10", "intensity: 10, enabled: 1"),
    ("practical without k for a spot", LIGHT, "{%s, inner: 1, outer: 2, attenuation: practical}" % SPOT),
    ("negative k that is not used", "attenuation: none", "attenuation: none, k: -1"),
    ("cosine without exponent and pattern quoted", "attenuation: none", 'pattern: "cosine"'),
    ("negative exponent", "attenuation: none", "pattern: cosine, exponent: -1"),
    ("axis and aim of a spot", LIGHT, "{%s, inner: 1, outer: 2, axis: [0, 0, 1], aim: [0, 0, 1]}" % SPOT),
    ("axis and aim of no use", "attenuation: none", "axis: [0, 0, 1], aim: [0, 0, 1]"),
    ("zero axis of no use", "attenuation: none", "axis: [0, -0.0, 0e5]"),
    ("aim of two numbers", "attenuation: none", "pattern: lambertian, aim: [0, 0]"),
    ("direction without list", LIGHT, "{type: distant, direction: down, irradiance: 1}"),
    ("distant without direction", LIGHT, "{type: distant, irradiance: 1}"),
    ("distant without irradiance", LIGHT, "{type: distant, direction: [0, 0, 1]}"),
    ("distant with a position", LIGHT, "{type: distant, direction: [0, 0, 1], irradiance: 1, position: [0, 0, 0]}"),
    ("ambient without irradiance", LIGHT, "{type: ambient}"),
    ("ambient with attenuation", LIGHT, "{type: ambient, irradiance: 1, attenuation: none}"),
    ("negative irradiance", LIGHT, "{type: ambient, irradiance: -1}"),
    ("spot without inner", LIGHT, "{%s, outer: 20}" % SPOT),
    ("spot with angles of texts", LIGHT, "{%s, inner: a, outer: b}" % SPOT),
    ("inner little beyond outer", LIGHT, "{%s, inner: 20, outer: 19.999}" % SPOT),
    ("inner beyond an outer of 0", LIGHT, "{%s, inner: 1, outer: 0}" % SPOT),
    ("inner beyond outer, both fractions", LIGHT, "{%s, inner: 20.5, outer: 19.5}" % SPOT),
    ("spot with a pattern", LIGHT, "{%s, inner: 1, outer: 2, pattern: cosine}" % SPOT),
    ("point that is a mapping", "[150, 0]", "{x: 150, y: 0}"),
    ("point of three numbers", "[150, 0]", "[150, 0, 0]"),
    ("point of texts", "[150, 0]", '["150", "0"]'),
    ("points that are null", "points: [[0, 0], [150, 0], [-150, 0]]", "points:"),
    ("range of one number", "range: max", "range: [1]"),
    ("range of three numbers", "range: max", "range: [1, 2, 3]"),
    ("range of equal numbers", "range: max", "range: [0.3, 0.3]"),
    ("range that falls", "range: max", "range: [10, 0]"),
    ("range that falls a little", "range: max", "range: [2, 1.9]"),
    ("range that falls below zero", "range: max", "range: [-1, -20]"),
    ("range of texts", "range: max", "range: [a, b]"),
    ("range that is a number", "range: max", "range: 5"),
    ("range that is a mapping", "range: max", "range: {low: 0, high: 1}"),
    ("range of infinity", "range: max", "range: [0, .inf]"),
    ("unknown key of the picture", "range: max", "ranges: max"),
    ("unknown key of the observer", "z: 1500", "z: 1500, x: 0"),
    ("picture that is a word", "picture: {range: max, rounding: truncate}", "picture: max"),
]

# What only the tool refuses, for the reasons that the schema's $comment gives.
INEXPRESSIBLE = [
    ("pixels are square", "[36, 36]", "[36, 35]"),
    ("the observer is above every surface", "z: 1500", "z: 1199"),
    ("aim differs from position", "attenuation: none", "pattern: lambertian, aim: [2000, 0, 2000]"),
    ("inner is at most outer within one degree", LIGHT, "{%s, inner: 20.6, outer: 20.5}" % SPOT),
    ("up is not parallel to axis", LIGHT, "{type: planar, rectangle: {center: [0, 0, 2000], size: [1, 1], axis: "
     "[1, 0, 0], up: [-2, 0, 0]}, power: 1}"),
    ("a mesh is closed", LIGHT, "{type: volume, mesh: gone.off, power: 1}"),
    ("a cloud can be read", LIGHT, "{type: points, file: gone.csv}"),
    ("a range rises between two steps", "range: max", "range: [1.9, 1.8]"),
    ("360.0 is no whole number", "[36, 36]", "[36.0, 36]"),
    ("truth values are true and false", "diffuse: 0.8", "over_pi: True"),
]


class Judges:
    """Both judges of a scene."""

    def __init__(self, tool):
        self.tool = tool
        for name, text in FILES.items():
            tool.write(name, text)
        schema = tool.run("schema").json()
        jsonschema.Draft7Validator.check_schema(schema)
        self.validator = jsonschema.Draft7Validator(schema)

    def tool_accepts(self, text):
        self.tool.write("scene.yaml", text)
        code = self.tool.run("check", "scene.yaml").code
        if code not in (0, 3, 4):  # 4: a damaged picture
            raise AssertionError("exit code %d" % code)
        return code == 0

    def complaints(self, value):
        return ["%s: %s" % ("/".join(map(str, error.absolute_path)), error.message[:200])
                for error in self.validator.iter_errors(value)]


def builtin_scenes(tap, tool):
    judges = Judges(tool)
    for entry in tool.run("scene", "--list", "--json").json()["scenes"]:
        text = tool.run("scene", entry["name"]).out
        complaints = judges.complaints(read(text))
        tap.ok(judges.tool_accepts(text) and not complaints, "built-in " + entry["name"], *complaints)


def examples(tap, tool):
    judges = Judges(tool)
    for kind in tool.run("help", "--json").json()["kinds"]:
        if not kind["example"]:
            continue
        scene = read(SCENE)
        scene[kind["list"]] = [read(kind["example"])]
        complaints = judges.complaints(scene)
        tap.ok(judges.tool_accepts(json.dumps(scene)) and not complaints, "example of " + kind["name"], *complaints)
        tap.equal(scene[kind["list"]][0]["type"], kind["name"], "it is one")


def used_paths(up, value):
    """The paths of all keys, as luxel help writes them."""
    if isinstance(value, dict):
        for key, below in value.items():
            path = up + "." + key if up else key
            yield path
            yield from used_paths(path, below)
    elif isinstance(value, list):
        for element in value:
            yield from used_paths(up + "[]", element)


def random_scenes(tap, tool):
    judges = Judges(tool)
    rng = random.Random(7)
    made = [("scene %d" % i, good_scene(rng)) for i in range(120)]
    made += [("%s %d" % (kind, i), reference.random_case(rng, kind).scene) for kind in reference.KINDS
             for i in range(3)]
    made.append(("scene of a disk and a cylinder", {
        "luxel": 1, "screen": {"width": 800, "height": 800, "resolution": [80, 80]}, "observer": {"z": 3000},
        "surfaces": [{"type": "disk", "center": [0, 0, 0], "radius": 300, "axis": [0, 1, 2]},
                     {"type": "cylinder", "center": [0, 0, 500], "radius": 90, "height": 200, "axis": [1, 1, 0]}],
        "lights": [{"type": "point", "position": [0, 900, 2000], "intensity": 5}]}))
    tool.write("lamp.ies", luminaires.HEAD + luminaires.AXIAL)
    made.append(("scene of a luminaire", {**made[-1][1], "lights": [
        {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2500], "c0": [0, 1, 0], "flux": 900, "factor": 0.8,
         "maintenance_factor": 0.7, "interpolation": "cosine", "opening": "file"}] + [
             {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2500], "opening": shape} for shape in (
                 {"rectangle": {"size": [600, 300], "center": [0, 0, 2490]}},
                 {"disk": {"radius": 90, "center": [0, 0, 2490], "axis": [0, 1, 0]}},
                 {"box": {"size": [600, 300, 90], "center": [0, 0, 2490]}},
                 {"sphere": {"radius": 90, "center": [0, 0, 2490]}},
                 {"cylinder": {"radius": 90, "height": 600, "center": [0, 0, 2490], "axis": [1, 0, 0]}})]}))
    wall = {"model": "phong", "diffuse": 0.5, "specular": 0.2, "shininess": 9, "ambient": 0.1, "over_pi": True,
            "highlight": "cosine", "normalized": True, "diffuse_model": "oren-nayar", "sigma": 12, "roughness": 0.5,
            "alpha": 0.3, "f0": 0.5, "color": [0.2, 0.5, 1], "specular_color": [1, 0.9, 0.1], "mirror": False}
    made.append(("scene of a room, a box and a sphere from inside", {
        **made[-2][1], "reflections": "none", "mirrors": 2,
        "lights": [{"type": "sun", "irradiance": 9, "date": "2026-06-21T12:00Z", "latitude": 50, "longitude": 8,
                    "diameter": 1, "up": [0, 0, 1], "north": [0, 1, 0]},
                   {"type": "sun", "irradiance": 9, "altitude": 40, "azimuth": 200, "group": "windows"},
                   {"type": "sky", "kind": 12, "sun": {"altitude": 40, "azimuth": 200}, "zenith": 9, "ground": 0.2},
                   {"type": "sky", "model": "perez", "direct": 500, "diffuse": 120, "extraterrestrial": 1361,
                    "sun": {"altitude": 40, "azimuth": 200}},
                   {"type": "sky", "kind": 12, "horizontal": 9,
                    "sun": {"date": "2026-06-21T12:00Z", "latitude": 50, "longitude": 8}}],
        "dimming": [{"name": "windows", "factor": 0.5}],
        "grids": [{"center": [0, 0, 0], "size": [900, 600], "spacing": "en12464", "measure": "spherical"},
                  {"center": [0, 0, 0], "size": [300, 300], "n": [2, 2], "surround": 500, "background": 900},
                  {"surface": "hall", "side": "floor", "border": 100, "n": [3, 2],
                   "limits": {"share": {"above": 3, "percent": 95}}}],
        "observers": [{"eye": [0, 0, 900], "size": [300, 300], "n": [2, 2]}],
        "surfaces": [{"type": "room", "name": "hall", "center": [0, 0, 1000], "size": [2000, 2000, 2000], "up": "z",
                      "openings": [
                      {"wall": "left", "center": [0, 9], "size": [500, 400], "glass": {"n": 1.5, "transmittance": 1}}],
                      "materials": {
            name: wall for name in ("left", "right", "floor", "ceiling", "back", "front")}},
                     {"type": "box", "center": [0, 0, 300], "size": [200, 200, 200], "materials": {
                         name: wall for name in ("left", "right", "bottom", "top", "back", "front")}},
                     {"type": "sphere", "center": [0, 0, 500], "radius": 200, "inside": True, "material": wall},
                     {"type": "rectangle", "center": [0, 700, 500], "size": [300, 200], "mirror": False}]}))
    tool.write("lamp-spectrum.csv", "nm,power\n" + "".join("%d,1\n" % nm for nm in range(400, 701, 20)))
    made.append(("scene in colour", {**made[-1][1], "channels": "rgb", "lights": [
        {"type": "point", "position": [0, 0, 1500], "intensity": 5, "group": "windows", "color": color} for color in (
            {"temperature": 2700}, {"xy": [0.4, 0.4]}, {"rgb": [1, 0.5, 0.1]}, {"spectrum": "lamp-spectrum.csv"})]}))
    used = set()
    for title, scene in made:
        complaints = judges.complaints(scene)
        tap.ok(judges.tool_accepts(json.dumps(scene)) and not complaints, "good " + title, json.dumps(scene),
               *complaints)
        used |= set(used_paths("", scene))
    paths = {key["path"] for key in tool.run("help", "--json").json()["keys"]}
    tap.ok(paths <= used, "every key was used", sorted(paths - used))


def malformed(tap, tool):
    judges = Judges(tool)
    cases = [(title, text) for title, text, _, _ in scenes()]
    cases += [(title, SCENE.replace(piece, replacement, 1)) for title, piece, replacement in MORE]
    cases += [(title, text) for title, text, _ in TEXTS if len(text) < 1 << 16]
    compared = 0
    # no error where only elements and grids are asked
    for title, text in (case for case in cases if case[0] != "no surfaces"):
        tap.ok(not judges.tool_accepts(text), "the tool refuses: " + title)
        try:
            value = read(text)
        except (yaml.YAMLError, ValueError, RecursionError):
            continue
        compared += 1
        accepted = not judges.complaints(value)
        tap.equal(accepted, title in BEYOND, "the schema %s: %s" % (
            "cannot say that " + BEYOND[title] if title in BEYOND else "refuses", title))
    tap.ok(compared >= 140, "malformed scenes were compared", compared)


def beyond(tap, tool):
    judges = Judges(tool)
    for title, piece, replacement in INEXPRESSIBLE:
        text = SCENE.replace(piece, replacement, 1)
        tap.ok(not judges.tool_accepts(text) and not judges.complaints(read(text)), "only the tool knows: " + title)
    comment = tool.run("schema").json()["$comment"]
    for word in ("square", "observer", "aim", "parallel", "plane", "cross", "mesh", "cloud", "cells", "inner", "rise",
                 "360.0", "true", "Doubled", "anchors", "tags"):
        tap.ok(word in comment, "the schema's comment tells of %s" % word)


def form(tap, tool):
    result = tool.run("schema")
    tap.ok(result.code == 0 and not result.err and result.out.endswith("}\n"), "luxel schema", result.err)
    tap.equal(tool.run("schema", "--json").out, result.out, "--json changes nothing")
    tap.equal(tool.run("schema", environment={"LC_ALL": "ru_RU.utf8", "LANGUAGE": "ru"}).out, result.out,
              "nor does the language")
    extra = tool.run("schema", "report")
    tap.ok(extra.code == 2 and "report" in extra.err, "it takes no argument", extra)
    schema = result.json()
    keys = tool.run("help", "--json").json()["keys"]
    for key in keys:
        if "." not in key["path"]:
            described = schema["properties"][key["path"]]["description"]
            tap.ok(key["meaning"][1:] in described, "%s has its meaning" % key["path"], described)
            tap.equal(schema["properties"][key["path"]]["title"], key["label"], "%s has its label" % key["path"])


run_tests(Tap(), form, builtin_scenes, examples, random_scenes, malformed, beyond)
