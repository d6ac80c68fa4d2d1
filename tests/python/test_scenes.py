# SPDX-License-Identifier: MIT
"""Scenes: where they come from, keys, edits, what is refused and how it is told, languages, pickles."""
import copy
import json
import os
import pathlib
import pickle
import subprocess
import sys

import numpy

from package import Tap, luxel, raises, run_tests
from tool import SCENE


def test_sources(tap, tool):
    path = tool.file(tool.write("my.yaml", SCENE))
    as_dict = {"luxel": 1, "screen": {"width": 500, "height": 500, "resolution": numpy.array([4, 4])},
               "observer": {"z": 1500}, "surfaces": [{"type": "sphere", "center": (0, 0, 1000), "radius": 200,
                                                     "material": {"model": "lambert", "diffuse": numpy.float64(0.8)}}],
               "lights": [{"type": "ambient", "irradiance": 3}]}
    sources = {"the name of a file": luxel.Scene(path), "a path": luxel.Scene(pathlib.Path(path)),
               "text": luxel.Scene(SCENE), "bytes": luxel.Scene(SCENE.encode()),
               "a scene": luxel.Scene(luxel.Scene(SCENE)), "from_text": luxel.Scene.from_text(SCENE, "mine"),
               "from_file": luxel.Scene.from_file(path)}
    for name, scene in sources.items():
        tap.equal(scene.text, SCENE, "a scene from " + name)
    scene = luxel.Scene(as_dict)
    tap.equal((scene["screen.resolution"], scene["surfaces[0].material.diffuse"]), ([4, 4], 0.8), "a scene from a dict")
    tap.near(scene.probe((0, 0)).value, 2.4, 1e-15, "and its value")
    text = json.dumps(as_dict, default=lambda array: array.tolist())
    tap.equal(luxel.Scene(text).probe((0, 0)).value, scene.probe((0, 0)).value, "JSON")
    for name in luxel.builtin_scenes():
        tap.equal(luxel.Scene(name).text, tool.run("scene", name).out, "the built-in scene " + name)
    tap.ok(raises(TypeError, luxel.Scene, 5), "a number is no scene")


def test_picture(tap, tool):
    tool.run("render", "report", "-s", "screen.resolution=[9,9]", "--precision", "double", "--quantity", "irradiance",
             "-o", "a.png")
    scene = luxel.Scene(tool.file("a.png"))
    field = scene.render()
    tap.equal((field.precision, field.quantity), ("double", "irradiance"), "a picture's scene is rendered as it was")
    tap.equal(field.png(), tool.read("a.png"), "to the same bytes")
    tap.equal(pickle.loads(pickle.dumps(scene)).render().png(), tool.read("a.png"), "and after pickling")
    tap.equal(scene.render(precision="single").precision, "single", "unless it is told otherwise")
    tap.equal(luxel.Scene(tool.read("a.png")).text, scene.text, "its bytes are as good")


def test_meshes(tap, tool):
    tool.write("box.obj", "".join("v %d %d %d\n" % (x, y, z) for x in (0, 2) for y in (0, 3) for z in (0, 4)) +
               "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n")
    path = tool.file(tool.write("mesh.yaml", SCENE.replace(
        "lights:", "  - {type: mesh, file: box.obj, scale: 10}\nlights:\n"
        "  - {type: volume, mesh: box.obj, radiance: 1}")))
    first, second = luxel.Scene(path).meshes
    tap.equal((first.key, first.file, first.triangles, first.closed, first.euler_number, first.size_mm),
              ("surfaces[1].file", "box.obj", 12, True, 2, (20, 30, 40)), "a mesh of a surface")
    tap.near(first.volume_mm3, 24000, 1e-12, "its volume")
    tap.equal((second.key, second.corners, second.edges, second.flipped_faces, second.scale_mm),
              ("lights[0].mesh", 8, 12, 0, 1), "a mesh of a source")
    tap.equal(luxel.Scene(SCENE).meshes, [], "none")


def test_keys(tap, tool):
    scene = luxel.Scene(SCENE)
    before = scene.copy()
    tap.equal(scene["lights[0].intensity"], 10, "a number")
    tap.equal(scene["lights.0.position"], [2000, 0, 2000], "a list")
    tap.equal(scene["surfaces[0].material.model"], "blinn-phong", "a word")
    tap.equal(scene["lights[0].enabled"], True, "a default")
    tap.equal(scene["lights[0].name"], None, "neither a value nor a default")
    tap.equal(scene["points"], [[0, 0], [150, 0], [-150, 0]], "points")
    tap.equal(("lights[0].name" in scene, "lights[0].intensity" in scene, "nonsense" in scene), (False, True, False),
              "what the scene writes")
    scene["lights[0].intensity"] = 20
    scene["lights[0].name"] = "a \"lamp\", Ж: #1"
    scene["lights[0].position"] = numpy.array([1.5, 2, 1e3])
    scene["points"] = [(0, 0)]
    tap.equal(scene["lights[0].name"], "a \"lamp\", Ж: #1", "a text comes back as it was set")
    tap.equal(scene["lights[0].position"], [1.5, 2, 1000], "an array does")
    tap.equal((scene["lights[0].intensity"], before["lights[0].intensity"]), (20, 10), "a copy stays as it was")
    scene.set("lights[0].intensity=30", "screen.sampling=centers")
    tap.equal((scene["lights[0].intensity"], scene["screen.sampling"]), (30, "centers"), "assignments as of -s")
    scene.append("lights", {"type": "ambient", "irradiance": 1})
    scene.insert("lights", 0, {"type": "ambient", "irradiance": 2})
    tap.equal([light.type for light in scene.lights], ["ambient", "point", "ambient"], "lights are put in")
    scene.move("lights", 0, 2)
    tap.equal([scene["lights[%d].irradiance" % i] for i in (1, 2)], [1, 2], "and moved")
    del scene["lights[0]"]
    tap.equal(scene.size("lights"), 2, "and taken out")
    scene.update({"surfaces[0].material": {"model": "lambert", "diffuse": 0.5}, "surfaces[0].radius": 100})
    tap.equal(scene["surfaces[0].material.diffuse"], 0.5, "several at once")
    scene.save(tool.file("saved.yaml"))
    tap.equal(tool.read("saved.yaml").decode(), scene.text, "it is saved as its text")
    tap.ok(scene.text.startswith("luxel: 1\nunits: radiometric\nscreen: {"), "whose layout stays")


def test_refused(tap, tool):
    scene = luxel.Scene(SCENE)
    error = raises(luxel.LuxelError, scene.__setitem__, "lights[0].intensity", -1)
    entry = error.diagnostics[0]
    tap.equal((error.status, len(error.diagnostics), entry.id, entry.file, entry.key, entry.line, entry.column),
              ("scene", 1, "out-of-range", "-s", "lights[0].intensity", 1, 21),
              "a wrong value is refused with its place")
    tap.equal(scene.text, SCENE, "and changes nothing")
    tap.ok(isinstance(raises(KeyError, scene.__setitem__, "lights[3].intensity", 1), luxel.LuxelKeyError),
           "a missing element is a KeyError")
    tap.ok(raises(KeyError, lambda: scene["lights[0].nonsense"]), "so is a key that there is not")
    tap.ok(raises(KeyError, scene.set, "screen.nonsense=1"), "of an assignment, too")
    tap.ok(raises(IndexError, scene.insert, "lights", -1, {}), "an index is not negative")
    tap.ok(raises(TypeError, scene.__setitem__, "lights[0].intensity", object()), "an object is no value")
    tool.write("wrong.yaml", SCENE.replace("height: 500", "heigth: 500").replace("radius: 200", "radius: -2"))
    error = raises(luxel.LuxelError, luxel.Scene, tool.file("wrong.yaml"))
    told = tool.run("check", "wrong.yaml").err
    tap.ok(len(error.diagnostics) >= 2, "all that is wrong with a file is told", str(error))
    for entry in error.diagnostics:
        tap.ok("wrong.yaml:%d:%d: error: %s" % (entry.line, entry.column, entry.message) in told and
               (entry.text or "") in told and entry.hint in told, "as the tool tells it: " + entry.message, told)
    again = pickle.loads(pickle.dumps(error))
    tap.equal((type(again), again.diagnostics, str(again)), (luxel.LuxelValueError, error.diagnostics, str(error)),
              "an error can be pickled")
    error = raises(luxel.LuxelError, luxel.Scene, "repport")
    tap.ok("no built-in scene" in str(error) and "did you mean report?" in str(error), "a name that is not there",
           str(error))
    tap.ok(raises(luxel.LuxelError, luxel.Scene, "luxel: [\n"), "text that is none")
    tap.ok(raises(ValueError, scene.render, precision="triple"), "a word that there is not")
    tap.ok(isinstance(raises(ValueError, scene.render, instruction_set="abacus"), luxel.LuxelValueError),
           "a setting that the library refuses is a ValueError")
    many = luxel.Scene(SCENE)
    error = raises(luxel.LuxelError, many.set, *["nonsense%d=1" % i for i in range(25)])
    tap.equal((len(error.diagnostics), error.total), (20, 25), "of many errors 20 are kept")
    tap.ok(str(error).endswith("and 5 more errors"), "and the others are counted", str(error)[-60:])
    tool.write("no-mesh.yaml", SCENE.replace("- type: sphere", "- {type: mesh, file: gone.obj}\n  - type: sphere"))
    for kind, builtin, run in (
            (luxel.LuxelValueError, ValueError, lambda: luxel.Scene({"luxel": 1, "nonsense": 2, "lights": 3})),
            (luxel.LuxelNotFoundError, FileNotFoundError, lambda: luxel.Scene("gone.yaml")),
            (luxel.LuxelFileError, OSError, lambda: luxel.Scene(tool.file("no-mesh.yaml"))),
            (luxel.LuxelFileError, OSError, lambda: luxel.read(tool.file("gone.npy"))),
            (luxel.LuxelFileError, OSError, lambda: scene.render().write(tool.file("gone/a.png"))),
            (luxel.LuxelMemoryError, MemoryError,
             lambda: scene.changed({"screen.resolution": [65536, 65536]}).render())):
        error = raises(builtin, run)
        again = pickle.loads(pickle.dumps(error))
        tap.ok(type(error) is kind and isinstance(error, luxel.LuxelError) and
               (type(again), str(again), again.status) == (kind, str(error), error.status),
               "%s is a %s" % (kind.__name__, builtin.__name__), type(error), error)
    tap.equal(list(scene), list(luxel._flow.load(json.dumps(
        {key: 0 for key in ("luxel", "units", "screen", "observer", "surfaces", "lights", "points", "picture")}))),
        "a scene iterates over the keys that it writes")
    tap.equal(dict(luxel.Scene({key: value for key, value in dict(scene).items()}))["lights"], scene["lights"],
              "dict(scene) makes the same scene")


def test_arguments(tap, tool):
    """Arguments are judged before anything is computed; the message names the wrong one and says what is expected."""
    scene = luxel.Scene(SCENE)
    field = scene.render()
    pair, triple, number = "two numbers are expected", "three numbers are expected", "a number is expected"
    cases = [(TypeError, "points: 5: pairs", lambda: scene.probe(5)),
             (ValueError, "points[1]: (1, 2, 3): " + pair, lambda: scene.probe([(0, 0), (1, 2, 3)])),
             (ValueError, "points[0]: ('x', 1): " + pair, lambda: scene.probe([("x", 1)])),
             (ValueError, "through: (0,): " + pair, lambda: scene.section(through=(0,))),
             (ValueError, "angle: 'x': " + number, lambda: scene.section(angle="x")),
             (ValueError, "end: (1,): " + pair, lambda: scene.profile((0, 0), (1,))),
             (ValueError, "start: 'a': " + pair, lambda: field.profile("a", (1, 0))),
             (ValueError, "point: 3: " + pair, lambda: scene.explain(3)),
             (ValueError, "normal: (0, 1): " + triple, lambda: scene.probe_element((0, 0, 0), (0, 1))),
             (IndexError, "surface: 4: the scene has 1", lambda: scene.probe_element((0, 0, 0), (0, 0, 1), surface=4)),
             (IndexError, "surface: -1: the scene has 1", lambda: scene.evaluate([0, 0, 0], [0, 0, 1], surface=-1)),
             (ValueError, "threads: -1: a whole number", lambda: scene.render(threads=-1)),
             (TypeError, "threads: 1.5: a whole number", lambda: scene.render(threads=1.5)),
             (ValueError, "reflected_error: 'x': " + number, lambda: scene.render(reflected_error="x")),
             (TypeError, "tolerance: {}: ", lambda: scene.section(tolerance=object())),
             (ValueError, "levels[1]: 'x': " + number, lambda: field.isophotes([5, "x"]))]
    for kind, text, call in cases:
        error = raises(kind, call)
        tap.ok(error is not None and str(error).startswith(text.split("{}")[0]), text, repr(error))
    tap.equal(numpy.asarray(scene.render(threads=numpy.int64(1))).tobytes(), numpy.asarray(field).tobytes(),
              "numbers of NumPy are numbers")


def test_language(tap, tool):
    scene = luxel.Scene(SCENE)
    luxel.set_language("ru")
    try:
        error = raises(luxel.LuxelError, scene.__setitem__, "lights[0].intensity", -1)
        tap.ok("значение должно быть" in str(error), "errors in Russian", str(error))
        told = tool.run("explain", "report", "-p", "0,0", environment={"LC_ALL": "C.UTF-8", "LANGUAGE": "ru"})
        tap.equal(luxel.Scene("report").explain((0, 0)).text, told.out, "explanations are those of the tool")
        tap.ok("точное значение" in scene.probe()._repr_html_(), "tables")
    finally:
        luxel.set_language("en")
    error = raises(luxel.LuxelError, scene.__setitem__, "lights[0].intensity", -1)
    tap.ok("must be" in str(error), "and in English again", str(error))
    tap.ok(raises(ValueError, luxel.set_language, "tlh"), "a language that there is not")
    luxel.set_language()
    program = "import luxel\ntry:\n luxel.Scene('nothing')\nexcept luxel.LuxelError as e: print(e)"
    for variables, word in (({"LC_ALL": "ru_RU.UTF-8", "LANGUAGE": ""}, "нет ни такого файла"),
                            ({"LC_ALL": "C", "LANGUAGE": "ru"}, "no such file"),
                            ({"LC_ALL": "", "LC_MESSAGES": "", "LANG": "en_US.UTF-8", "LANGUAGE": ""}, "no such file")):
        done = subprocess.run([sys.executable, "-X", "utf8", "-c", program], env={**os.environ, **variables},
                              capture_output=True, text=True, encoding="utf-8")
        tap.ok(word in done.stdout, "the language of %r" % (variables,), done.stdout, done.stderr)


def test_pickles(tap, tool):
    os.makedirs(tool.file("deep"))
    tool.write("deep/cloud.csv", "x,y,z,intensity\n0,0,2000,5\n100,0,2000,5\n")
    tool.write("deep/my.yaml", SCENE.split("lights:")[0] + "lights: [{type: points, file: cloud.csv}]\n")
    scene = luxel.Scene(tool.file("deep/my.yaml"))
    for name, other in (("a pickle", pickle.loads(pickle.dumps(scene))), ("a copy", copy.copy(scene)),
                        ("a deep copy", copy.deepcopy(scene))):
        tap.equal((other.text, other.probe().value.tolist()), (scene.text, scene.probe().value.tolist()),
                  name + " finds the files beside")
    here = os.getcwd()
    os.chdir(tool.file("deep"))
    beside = luxel.Scene("my.yaml")
    os.chdir("/")
    beside["lights[0].enabled"] = False
    beside["lights[0].enabled"] = True
    tap.equal(beside.probe().value.tolist(), scene.probe().value.tolist(), "as does a program that goes elsewhere")
    os.chdir(here)
    changed = scene.changed({"screen.resolution": [3, 3]})
    tap.equal((changed.resolution, scene.resolution), ((3, 3), (36, 36)), "a changed copy")
    tap.equal(pickle.loads(pickle.dumps(changed)).resolution, (3, 3), "is pickled as changed")


def test_about(tap, tool):
    scene = luxel.Scene("desk")
    told = tool.run("render", "desk", "--json").json()
    used = told["conventions"]
    tap.equal({key: scene.conventions[key] for key in used}, used, "conventions, those of the range beside")
    tap.equal(scene.unit(), told["unit"], "the unit")
    tap.equal([(light.type, light.flux, light.intensity) for light in scene.lights],
              [(light["type"], light.get("flux"), light.get("intensity")) for light in told["lights"]], "lights")
    report = luxel.Scene("report")
    tap.equal(report.points, [(0.0, 0.0), (150.0, 0.0), (-150.0, 0.0)], "points")
    tap.equal(report.project((10, 20, 300)), (10.0, 20.0), "projection")
    tap.equal(report.unproject((10, 20), 300), (10.0, 20.0, 300.0), "and back")
    tap.equal(report.height((10, 20, 300)), 300.0, "a height")
    aside = luxel.Scene("report").changed({"observer": {"position": [1500, 0, 1000], "target": [0, 0, 1000]}})
    tap.equal((aside.project((300, 20, 990)), aside.height((300, 20, 990)), aside.unproject((10, 20), 300)),
              ((10.0, 20.0), 300.0, (300.0, 20.0, 990.0)), "from the side")
    advised = [entry.message for entry in report.advice()]
    tap.ok(advised and all(message in tool.run("advise", "report").out + tool.run("advise", "report").err
                           for message in advised), "advice is that of the tool", advised)
    tap.equal(luxel.variant(17).text, tool.run("variant", "17").out, "a variant")
    tap.equal(luxel.schema(), json.loads(tool.run("schema").out), "the schema")
    tap.equal(raises(ValueError, luxel.variant, 0).status, "argument", "there is no variant 0")
    tap.ok("report" in repr(report) and "360 x 360" in repr(report), "what it shows as", repr(report))


run_tests(Tap(), test_sources, test_picture, test_meshes, test_keys, test_refused, test_arguments, test_language,
          test_pickles, test_about)
