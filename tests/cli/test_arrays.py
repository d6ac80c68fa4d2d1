# SPDX-License-Identifier: MIT
"""Arrays of lights against the same lights written one by one, and what is told of them."""
import itertools
import json
import math

from luminaires import HEAD
from tap import Tap
from tool import run_tests

SCENE = {"luxel": 1, "units": "photometric", "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]},
         "observer": {"z": 4000},
         "surfaces": [{"type": "sphere", "center": [0, 0, 500], "radius": 300},
                      {"type": "rectangle", "center": [0, 0, 0], "size": [4000, 4000]}],
         "points": [[0, 0], [120, -70], [700, 500], [-450, 300]]}
LAMP = HEAD + "1 -1 1 4 1 1 2 .1 .2 0\n1 1 20\n0 30 60 90\n0\n1000 700 300 10\n"
PLACE, N, SPACING = [100, 50, 2000], [3, 2], [500, 400]
ARRAY = {"n": N, "spacing": SPACING}
TURNED = {**ARRAY, "axes": [[0, 2, 0], [0, 0, -1]]}


def places(array):
    axes = array.get("axes", [[1, 0, 0], [0, 1, 0]])
    units = [[part / math.hypot(*axis) for part in axis] for axis in axes]
    for row, column in itertools.product(range(array["n"][1]), range(array["n"][0])):
        steps = [(at - (count - 1) / 2) * step for at, count, step in zip((column, row), array["n"], array["spacing"])]
        yield [PLACE[i] + steps[0] * units[0][i] + steps[1] * units[1][i] for i in range(3)]


def lights(place):
    """One light of each kind and form at a place."""
    x, y, z = place
    return {
        "point": {"type": "point", "position": place, "intensity": 10},
        "spot": {"type": "spot", "position": place, "intensity": 10, "inner": 20, "outer": 40, "axis": [-1, 0, -9]},
        "luminaire": {"type": "luminaire", "file": "lamp.ies", "position": place, "c0": [1, 1, 0]},
        "opening": {"type": "luminaire", "file": "lamp.ies", "position": place, "opening": "file"},
        "rectangle": {"type": "planar", "rectangle": {"center": place, "size": [100, 200]}, "radiance": 10},
        "both sides": {"type": "planar", "sides": "both", "radiance": 10,
                       "vertices": [[x - 50, y - 50, z], [x - 50, y + 50, z], [x + 50, y - 50, z]]},
        "disk": {"type": "planar", "disk": {"center": place, "radius": 70}, "radiance": 10},
        "few parts": {"type": "planar", "rectangle": {"center": place, "size": [90, 90]}, "intensity": 1, "parts": 3},
        "many parts": {"type": "planar", "rectangle": {"center": place, "size": [90, 90]}, "intensity": 1, "parts": 9},
        "box": {"type": "volume", "box": {"center": place, "size": [100, 200, 30]}, "radiance": 10},
        "ball": {"type": "volume", "sphere": {"center": place, "radius": 60}, "radiance": 10},
        "cylinder": {"type": "volume", "cylinder": {"center": place, "radius": 60, "height": 90}, "power": 10},
    }


def scene(*lights, **others):
    return json.dumps({**SCENE, "lights": lights, **others})


def like_single_lights(tap, tool):
    tool.write("lamp.ies", LAMP)
    for array, (name, light) in itertools.product((ARRAY, TURNED), lights(PLACE).items()):
        tool.write("array.yaml", scene({**light, "array": array}))
        tool.write("single.yaml", scene(*(lights(place)[name] for place in places(array))))
        together = tool.run("probe", "array.yaml", "--json").json()["points"]
        apart = tool.run("probe", "single.yaml", "--json").json()["points"]
        for one, other in zip(together, apart):
            slack = one["error"] + other["error"]
            tap.ok(abs(one["value"] - other["value"]) <= slack <= 1e-6 * max(one["value"], 1),
                   "%s, at %s" % (name, one["screen"]), "%r, %r" % (one, other))
            tap.equal([len(one["lights"]), len(other["lights"])], [1, 6], "one light of its list")
            tap.near(one["lights"][0]["irradiance"], sum(light["irradiance"] for light in other["lights"]),
                     1e-6, "with the sum of its places")


def pictures_and_observers(tap, tool):
    tool.write("lamp.ies", LAMP)
    observer = {"position": [900, -800, 3000], "target": [0, 0, 100], "projection": "perspective"}
    for name in "point", "luminaire", "rectangle", "many parts", "box", "disk":
        one, many = {**lights(PLACE)[name], "array": ARRAY}, [lights(place)[name] for place in places(ARRAY)]
        tool.write("array.yaml", scene(one, observer=observer))
        tool.write("single.yaml", scene(*many, observer=observer))
        together, apart = (tool.run("render", file, "--json").json()
                           for file in ("array.yaml", "single.yaml"))
        tap.near(together["mean"], apart["mean"], 3e-5, "%s, the mean of a picture" % name)
        tap.near(together["max"]["value"], apart["max"]["value"], 3e-3, "its maximum")


def one_place(tap, tool):
    light = lights(PLACE)["point"]
    tool.write("array.yaml", scene({**light, "array": {"n": [1, 1], "spacing": [1, 1]}}))
    tool.write("single.yaml", scene(light))
    together, apart = (tool.run("probe", file, "--json").json()["points"] for file in ("array.yaml", "single.yaml"))
    tap.equal([point["value"] for point in together], [point["value"] for point in apart], "an array of one place")


def glare(tap, tool):
    """Each place is a source of its own, as single lights are."""
    tool.write("lamp.ies", LAMP)
    sky = {"type": "ambient", "irradiance": 30}
    for name in ("luminaire", "opening", "rectangle", "both sides", "few parts", "ball", "point"):
        tool.write("array.yaml", scene({**lights(PLACE)[name], "name": "lamps", "array": ARRAY}, sky))
        tool.write("single.yaml", scene(*(lights(place)[name] for place in places(ARRAY)), sky))
        together, apart = (tool.run("glare", file, "--eye", "0,-3000,1200,0,1,0", "--json").json()["observers"][0]
                           for file in ("array.yaml", "single.yaml"))
        if apart["ugr"] is None:
            tap.equal(together["ugr"], None, "no glare: " + name)
        else:
            tap.near(together["ugr"], apart["ugr"], 0, "glare of an array: " + name,
                     together["error"] + apart["error"])
        tap.equal([(source.get("place"), source["light"], source["status"]) for source in together["sources"]],
                  [(i if i < 6 else None, i // 6, source["status"]) for i, source in enumerate(apart["sources"])],
                  "its places: " + name)
    result = tool.run("glare", "array.yaml", "--eye", "0,-3000,1200,0,1,0")
    tap.ok("lights[0] lamps, place 6" in result.out, "places in words", result)


def set_from_outside(tap, tool):
    light = lights(PLACE)["point"]
    tool.write("array.yaml", scene({**light, "array": ARRAY}))
    tool.write("single.yaml", scene(light))
    before = tool.run("probe", "array.yaml", "--json").json()["points"]
    given = tool.run("probe", "single.yaml", "--json", "-s", "lights[0].array={n: [3, 2], spacing: [500, 400]}")
    tap.equal([p["value"] for p in given.json()["points"]], [p["value"] for p in before], "an array by -s")
    wider = tool.run("probe", "array.yaml", "--json", "-s", "lights[0].array.n=[1, 1]").json()["points"]
    alone = tool.run("probe", "single.yaml", "--json").json()["points"]
    tap.equal([p["value"] for p in wider], [p["value"] for p in alone], "fewer places by -s")


def told(tap, tool):
    tool.write("lamp.ies", LAMP)
    tool.write("array.yaml", scene({**lights(PLACE)["luminaire"], "array": {"n": [4, 3], "spacing": [500, 500]}}))
    near = tool.run("check", "array.yaml", "-s", "lights[0].position=[5000, 5000, 10]")
    tap.ok(near.code == 0 and "light lies behind" not in near.out + near.err, "no advice about its middle", near)


def faults(tap, tool):
    light = lights(PLACE)["point"]
    for array, words in (({"n": [3, 2]}, 'missing key "spacing"'), ({"spacing": [1, 1]}, 'missing key "n"'),
                         ({**ARRAY, "n": [0, 2]}, "n[0]"), ({**ARRAY, "n": [1001, 2]}, "1000"),
                         ({**ARRAY, "spacing": [-1, 2]}, "spacing[0]"), ({**ARRAY, "spacing": [1, 0]}, "spacing[1]"),
                         ({**ARRAY, "axes": [[1, 0, 0]]}, "2 or more"),
                         ({**ARRAY, "axes": [[1, 0, 0], [-3, 0, 0]]}, "not parallel"),
                         ({**ARRAY, "axes": [[1, 0, 0], [0, 0, 0]]}, "neither of them 0"),
                         ({**ARRAY, "axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, "two directions"),
                         ({**ARRAY, "gap": 1}, 'unknown key "gap"')):
        tool.write("scene.yaml", scene({**light, "array": array}))
        result = tool.run("render", "scene.yaml", "-o", "a.png")
        tap.ok(result.code == 3 and words in result.err and "a.png" not in tool.files(), "array %s" % array, result)
    for light in {"type": "ambient", "irradiance": 1}, {"type": "distant", "direction": [0, 0, -1], "irradiance": 1}:
        result = tool.run("check", "-", stdin=scene({**light, "array": ARRAY}))
        tap.ok(result.code == 3 and 'unknown key "array"' in result.err, "%s has no place" % light["type"], result)


run_tests(Tap(), like_single_lights, pictures_and_observers, one_place, glare, set_from_outside, told, faults)
