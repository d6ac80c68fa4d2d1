# SPDX-License-Identifier: MIT
"""Many surfaces are found by a tree, few are asked one by one: what neither shows nor hides anything, put to few so
that they are many, changes no byte of a picture and no digit of a probe; and thousands take nobody's time."""
import random
import time

from tap import Tap
from tool import AT_ONCE, run_tests

LIGHTS = {
    "points": ["{type: point, position: [1500, 1500, 3000], intensity: 20}",
               "{type: distant, direction: [1, -0.4, -2], irradiance: 2}"],
    "a window": ["{type: planar, rectangle: {center: [1500, 1500, 3000], size: [600, 600], axis: [-1, -1, -2]}, "
                 "radiance: 20}"],
    "a globe": ["{type: volume, sphere: {center: [-900, 700, 2500], radius: 200}, radiance: 30}"],
}
OBSERVERS = {
    "in perspective": "{z: 5000, projection: perspective}", "in parallel": "{z: 5000, projection: orthographic}",
    "from aside": "{position: [3000, -2500, 4000], target: [0, 0, 300], projection: perspective}",
}


def surface(chance, spread, z):
    place = [round(chance.uniform(-spread, spread)), round(chance.uniform(-spread, spread)), round(chance.uniform(*z))]
    kind = chance.randrange(4)
    if kind == 0:
        form = "type: rectangle, center: %s, size: [%d, %d], axis: [%g, %g, 1]" % (
            place, chance.randrange(50, 300), chance.randrange(50, 300), chance.uniform(-1, 1), chance.uniform(-1, 1))
    elif kind == 1:
        form = "type: disk, center: %s, radius: %d" % (place, chance.randrange(30, 150))
    else:
        form = "type: sphere, center: %s, radius: %d" % (place, chance.randrange(30, 150))
    return "{%s, material: {model: lambert, diffuse: 0.8}}" % form


def scene(surfaces, lights, observer, side=28):
    return "\n".join(["luxel: 1", "screen: {width: 2400, height: 2400, resolution: [%d, %d]}" % (side, side),
                      "observer: " + observer, "surfaces:"] + ["  - " + one for one in surfaces] +
                     ["lights:"] + ["  - " + one for one in lights]) + "\n"


def others_change_nothing(tap, tool):
    chance = random.Random(31)
    plain = [surface(chance, 1000, (0, 900)) for _ in range(34)]
    floor = "{type: rectangle, center: [0, 0, -200], size: [9000, 9000], material: {model: lambert, diffuse: 0.7}}"
    away = ["{type: sphere, center: [%d, %d, -30000], radius: 10}" % (x * 900, y * 900) for x in range(10)
            for y in range(10)]
    for lamp, lights in LIGHTS.items():
        for how, observer in OBSERVERS.items():
            tool.write("few.yaml", scene(plain + [floor], lights, observer))
            tool.write("many.yaml", scene(plain + [floor] + away, lights, observer))
            pictures, probes = [], []
            for name in "few", "many":
                result = tool.run("render", name + ".yaml", "-o", name + ".npy")
                tap.equal(result.code, 0, "%s, %s: %s of them" % (lamp, how, name))
                pictures.append(tool.read(name + ".npy"))
                probes.append([(point["value"], point["error"]) for point in tool.run(
                    "probe", name + ".yaml", "--json", "-p", "0,0", "-p", "330,-210", "-p", "-720.5,400",
                    "-p", "10,810").json()["points"]])
            tap.ok(pictures[0] == pictures[1], "the same picture")
            tap.equal(probes[0], probes[1], "the same values")


def places_change_nothing(tap, tool):
    """Elements anywhere, in batches."""
    chance = random.Random(5)
    plain = [surface(chance, 1000, (0, 900)) for _ in range(40)]
    away = ["{type: sphere, center: [%d, %d, -30000], radius: 10}" % (x * 900, y * 900) for x in range(10)
            for y in range(10)]
    rows = ["x,y,z,nx,ny,nz"] + ["%.3f,%.3f,%.3f,%.3f,%.3f,1" % (
        chance.uniform(-1000, 1000), chance.uniform(-1000, 1000), chance.uniform(-50, 50), chance.uniform(-1, 1),
        chance.uniform(-1, 1)) for _ in range(300)]
    tool.write("places.csv", "\n".join(rows) + "\n")
    for lamp, lights in LIGHTS.items():
        found = []
        for surfaces in plain, plain + away:
            tool.write("scene.yaml", scene(surfaces, lights, OBSERVERS["in parallel"]))
            tool.write("few.csv", "\n".join(rows[:20]) + "\n")
            name = "places.csv" if lamp == "points" else "few.csv"
            result = tool.run("probe", "scene.yaml", "--points", name, "-o", "a.csv")
            found.append((result.code, tool.read("a.csv")))
        tap.ok(found[0] == found[1] and found[0][0] == 0 and len(found[0][1]) > 1000, "the same places: " + lamp)


def thousands_are_quick(tap, tool):
    chance = random.Random(9)
    surfaces = ["{type: sphere, center: [%d, %d, %d], radius: %d}" % (
        chance.randrange(-1150, 1150), chance.randrange(-1150, 1150), chance.randrange(0, 900), chance.randrange(5, 12))
        for _ in range(5000)]
    floor = "{type: rectangle, center: [0, 0, -200], size: [2400, 2400]}"
    tool.write("scene.yaml", scene(surfaces + [floor], LIGHTS["points"][:1], OBSERVERS["in perspective"], 160))
    for words in ("check",), ("render",), ("probe", "-p", "0,0", "-p", "100,200"):
        begin = time.monotonic()
        result = tool.run(words[0], "scene.yaml", *words[1:])
        tap.ok(result.code == 0 and time.monotonic() - begin < AT_ONCE, words[0],
               "%.1f s" % (time.monotonic() - begin), result)


run_tests(Tap(), others_change_nothing, places_change_nothing, thousands_are_quick)
