# SPDX-License-Identifier: MIT
"""Grids of cylindrical, semicylindrical, spherical and hemispherical illuminance: against closed forms, sums over the
points of a source, and means of vertical illuminances."""
import json
import math

from tap import Tap
from tool import run_tests

MEASURES = ["cylindrical", "semicylindrical", "spherical", "hemispherical"]
MATT = {"model": "lambert", "diffuse": 0.6, "over_pi": True}


def response(measure, towards, axis=(0, 0, 1), faced=(0, 1, 0)):
    """f of a unit vector, for the defaults of a grid."""
    along = sum(a * b for a, b in zip(axis, towards))
    across, facing = math.sqrt(max(0, 1 - along * along)), sum(a * b for a, b in zip(faced, towards))
    return {"cylindrical": across / math.pi, "semicylindrical": (across + facing) / math.pi, "spherical": 0.25,
            "hemispherical": (1 + along) / 4}[measure]


def measure(tool, lights, surfaces=(), at=(0, 0, 0), measures=tuple(MEASURES), options=(), **more):
    """The values at a place, by measure, with their bounds; the answer."""
    grid = {"center": at, "size": [1, 1], "n": [1, 1], **more.pop("grid", {})}
    text = json.dumps({"luxel": 1, "units": "photometric", "screen": {"width": 10, "height": 10, "resolution": [4, 4]},
                       "observer": {"z": 90000}, "surfaces": list(surfaces), "lights": lights,
                       "grids": [{**grid, "name": name, "measure": name} for name in measures], **more})
    result = tool.run("grid", "-", "--json", *options, stdin=text, timeout=120)
    if result.code != 0:
        result.fail("grid")
    grids = result.json()["grids"]
    return {grid["name"]: (grid["values"][0][0], grid["errors"][0][0]) for grid in grids}, grids


def held(tap, found, expected, at_least, title):
    """Whether a truth is within the bound, and that as small as it should be; truths come from sums in float64."""
    value, error = found
    tap.ok(abs(value - expected) <= error + 1e-13 * abs(expected) and error <= at_least * abs(expected) + 1e-300,
           "%s: %.15g ± %.2g for %.15g" % (title, value, error, expected))


def points(tap, tool):
    """A lamp 2 m aside and 1.5 m up; light of one direction; light from everywhere."""
    lamp = {"type": "point", "position": [2000, 0, 1500], "intensity": 1}
    found, grids = measure(tool, [lamp], grid={"up": [1, 0, 0]})
    for name, expected in zip(MEASURES, (.040743665431525, .08148733086305, .04, .064)):
        tap.near(found[name][0], expected, 1e-13, name)
        tap.ok(found[name][1] < 1e-15, "bound of " + name)
    tap.equal([grid["measure"] for grid in grids], MEASURES, "names")
    tap.equal([grid["flux"] for grid in grids] + [grid["mean"] for grid in grids], [None] * 8, "no flux, no mean")
    modelling = grids[0]["modelling"]
    tap.near(modelling["value"], 4 / (3 * math.pi), 1e-13, "modelling")
    tap.equal([modelling["minimum"], modelling["maximum"]], [modelling["value"]] * 2, "of one place")
    tap.ok(all("modelling" not in grid for grid in grids[1:]), "of cylindrical illuminance alone")
    sun = {"type": "distant", "direction": [1, 2, -2], "irradiance": 9}
    found, _ = measure(tool, [sun])
    for name in MEASURES:
        held(tap, found[name], 9 * response(name, (-1 / 3, -2 / 3, 2 / 3)), 1e-13, "distant, " + name)
    found, _ = measure(tool, [{"type": "ambient", "irradiance": 5}])
    for name in MEASURES:
        tap.equal(found[name][0], 5, "ambient, " + name)
    lamp["position"] = [0, 300, -400]
    found, _ = measure(tool, [lamp])
    for name in MEASURES:
        held(tap, found[name], 4 * response(name, (0, .6, -.8)), 1e-14, "from below, " + name)
    lamp["position"] = [0, 0, 500]
    found, _ = measure(tool, [lamp])
    for name, truth in zip(MEASURES, (0, 0, 1, 2)):
        tap.ok(abs(found[name][0] - truth) <= found[name][1] <= 1e-13, "on the axis, " + name, found[name])
    lamp["position"] = [0, 300, -400]
    turned = {"axis": [0, 1, 0], "up": [1, 0, 0]}
    found, _ = measure(tool, [lamp], grid=turned)
    for name in MEASURES:
        held(tap, found[name], 4 * response(name, (0, .6, -.8), (0, 1, 0), (1, 0, 0)), 1e-14, "turned, " + name)


def ceilings(tap, tool):
    """A disk over the place, of the luminance 100: E_z = 100 (a - sin a cos a) and so on, a half the angle under which
    it is seen; half of it behind a plate."""
    radius, height = 3000, 1000
    disk = {"type": "planar", "disk": {"center": [0, 0, height], "radius": radius}, "radiance": 100}
    a = math.atan2(radius, height)
    whole = {"cylindrical": a - math.sin(a) * math.cos(a), "spherical": math.pi * (1 - math.cos(a)) / 2}
    whole["semicylindrical"] = whole["cylindrical"]
    whole["hemispherical"] = whole["spherical"] + math.pi * math.sin(a) ** 2 / 4
    found, grids = measure(tool, [disk])
    for name in MEASURES:
        held(tap, found[name], 100 * whole[name], 1e-8, "disk, " + name)
    tap.near(grids[0]["modelling"]["value"], whole["cylindrical"] / (math.pi * math.sin(a) ** 2), 1e-8,
             "modelling under a disk")
    plate = {"type": "rectangle", "center": [-5000, 0, 500], "size": [10000, 10000]}
    found, _ = measure(tool, [disk], [plate], measures=("cylindrical", "hemispherical"))
    for name in found:
        held(tap, found[name], 50 * whole[name], 1e-7, "half of the disk, " + name)
    wide = {"type": "planar", "disk": {"center": [0, 0, 10], "radius": 1e6}, "radiance": 1}
    _, grids = measure(tool, [wide], measures=("cylindrical",))
    tap.near(grids[0]["modelling"]["value"], 0.5, 1e-4, "a ceiling without end")


NODES = [(x, w) for x, w in zip(
    (-.9739065285171717, -.8650633666889845, -.6794095682990244, -.4333953941292472, -.1488743389816312),
    (.0666713443086881, .1494513491505806, .2190863625159820, .2692667193099964, .2955242247147529))]
NODES += [(-x, w) for x, w in NODES]


def panel(name, center, size, radiance, parts=12):
    """The measure at the origin of a panel that shines down, a sum over its points by Gauss's rule."""
    total = 0
    for i in range(parts * parts):
        for x, u in NODES:
            for y, v in NODES:
                place = [center[0] + size[0] * ((i % parts + (1 + x) / 2) / parts - .5),
                         center[1] + size[1] * ((i // parts + (1 + y) / 2) / parts - .5), center[2]]
                length = math.hypot(*place)
                towards = [c / length for c in place]
                total += u * v / (4 * parts * parts) * towards[2] / (length * 1e-3) ** 2 * response(name, towards)
    return radiance * total * size[0] * size[1] * 1e-6


def panels(tap, tool):
    """Beside the axis, and a lamp's table that shines from a luminous opening by way of its distribution."""
    center, size = [900, 400, 1500], [1200, 600]
    light = {"type": "planar", "rectangle": {"center": center, "size": size}, "radiance": 100}
    found, _ = measure(tool, [light])
    for name in MEASURES:
        held(tap, found[name], panel(name, center, size, 100), 2e-9, "panel, " + name)
    spot = {"type": "spot", "position": [500, 0, 1200], "axis": [0, 0, -1], "intensity": 13, "inner": 50, "outer": 50}
    found, _ = measure(tool, [spot])
    for name in MEASURES:
        held(tap, found[name], 13 / 1.69 * response(name, (5 / 13, 0, 12 / 13)), 1e-13, "spot, " + name)


def reflected(tap, tool):
    """In an integrating sphere the same light comes from everywhere; in a room the mean of vertical illuminances."""
    ball = {"type": "sphere", "center": [0, 0, 0], "radius": 1000, "inside": True, "material": MATT}
    lamp = {"type": "point", "position": [0, 0, 0], "intensity": 100}
    found, grids = measure(tool, [lamp], [ball], at=(300, 0, 400), options=("--reflected-error", "1e-2"),
                           reflections="all")
    for name in MEASURES:
        direct = 400 * response(name, (-.6, 0, -.8))
        tap.near(found[name][0], direct + 150, 1e-5, "integrating sphere, " + name)
        tap.ok(abs(found[name][0] - direct - 150) <= found[name][1], "its bound, " + name)
    room = {"type": "room", "center": [0, 0, 1400], "size": [4000, 3000, 2800], "up": "z", "material": MATT}
    lamp = {"type": "point", "position": [300, 200, 2500], "intensity": 100}
    place, options = (-500, 200, 1200), ("--reflected-error", "1e-2")
    found, grids = measure(tool, [lamp], [room], at=place, options=options, reflections=1,
                           measures=("cylindrical", "semicylindrical", "spherical", "hemispherical"))
    text = json.dumps({"luxel": 1, "units": "photometric", "screen": {"width": 10, "height": 10, "resolution": [4, 4]},
                       "observer": {"z": 90000}, "surfaces": [room], "lights": [lamp], "reflections": 1})
    count, ways = 11, []
    for k in range(count):
        ways.append((math.cos(2 * math.pi * k / count), math.sin(2 * math.pi * k / count), 0))
    ways += [(0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    arguments = [word for way in ways for word in ("--at", ",".join(map(repr, place + way)))]
    answer = tool.run("probe", "-", "--json", "--quantity", "irradiance", *options, *arguments, stdin=text,
                      timeout=120).json()
    light = [point["reflected"]["irradiance"] for point in answer["points"]]
    error = max(point["reflected"]["error"] for point in answer["points"])
    away = math.hypot(.8, 1.3)
    direct = {name: 100 * response(name, (.8 / away, 0, 1.3 / away)) / away ** 2 for name in MEASURES}
    mean = sum(light[:count]) / count
    slack = mean * (math.pi / (2 * count)) ** 2 / 3 + error  # of count planes in place of all (docs/MATHS.md)
    reflections = {name: found[name][0] - direct[name] for name in MEASURES}
    tap.ok(abs(reflections["cylindrical"] - mean) <= slack + found["cylindrical"][1],
           "the mean of vertical illuminances: %.6g, %.6g ± %.2g" % (reflections["cylindrical"], mean, slack))
    for first, second, pair, share in (("semicylindrical", "cylindrical", light[count:count + 2], 1 / math.pi),
                                       ("hemispherical", "spherical", light[count + 2:], 1 / 4)):
        difference = reflections[first] - reflections[second]
        bound = found[first][1] + found[second][1] + 2 * share * error
        tap.ok(abs(difference - share * (pair[0] - pair[1])) <= bound, "%s less %s" % (first, second))


def mirrored(tap, tool):
    """A lamp before a mirror is two, whether it is a point or of some size."""
    mirror = {"type": "rectangle", "center": [1000, 0, 0], "size": [9000, 9000], "axis": [-1, 0, 0], "mirror": True}
    light = {"type": "point", "position": [0, 0, 500], "intensity": 1}
    found, _ = measure(tool, [light], [mirror])
    away = math.hypot(2, .5)
    for name in MEASURES:
        truth = 4 * response(name, (0, 0, 1)) + response(name, (2 / away, 0, .5 / away)) / away ** 2
        held(tap, found[name], truth, 1e-12, "mirrored, " + name)
    ball = {"type": "volume", "sphere": {"center": [0, 900, 400], "radius": 100}, "radiance": 100}
    image = {"type": "volume", "sphere": {"center": [2000, 900, 400], "radius": 100}, "radiance": 100}
    found, _ = measure(tool, [ball], [mirror])
    both, _ = measure(tool, [ball, image])
    for name in MEASURES:
        tap.ok(abs(found[name][0] - both[name][0]) <= found[name][1] + both[name][1] + 1e-12 * both[name][0],
               "a mirrored ball, " + name, found[name], both[name])


def on_surfaces(tap, tool):
    """Where a cell lies on a plate what is below it is hidden, whether it is a point or of some size."""
    floor = {"type": "rectangle", "center": [0, 0, 0], "size": [2000, 2000], "material": MATT}
    lamps = [{"type": "point", "position": [0, 300, z], "intensity": 1} for z in (400, -400)]
    found, _ = measure(tool, lamps, [floor])
    for name in MEASURES:
        held(tap, found[name], 4 * response(name, (0, .6, .8)), 1e-13, "on a plate, " + name)
    ball = {"type": "volume", "sphere": {"center": [900, 0, -500], "radius": 100}, "radiance": 100}
    found, _ = measure(tool, [ball], [floor])
    tap.equal([value for value, _ in found.values()], [0] * 4, "a ball below it")


def texts(tap, tool):
    scene = ("luxel: 1\nscreen: {width: 10, height: 10, resolution: [4, 4]}\nobserver: {z: 9000}\nsurfaces: []\n"
             "lights: [{type: point, position: [2000, 0, 1500], intensity: 1}]\n"
             "grids: [{center: [0, 0, 0], size: [10, 10], n: [1, 1], measure: %s}]\n")
    result = tool.run("grid", "-", stdin=scene % "cylindrical")
    tap.equal((result.code, result.err), (0, ""), "text")
    for words in ("measure: cylindrical, about the normal as its axis", "modelling: the average by that on the plane",
                  "0.0407437"):
        tap.ok(words in result.out, "it says " + words)
    result = tool.run("grid", "-", stdin=scene % "plane")
    tap.ok("measure" not in result.out and "modelling" not in result.out, "nothing new on a plane")
    result = tool.run("grid", "-", stdin=scene % "vertical")
    tap.ok(result.code == 3 and "measure" in result.err and "semicylindrical" in result.err, "a wrong measure")


run_tests(Tap(), points, ceilings, panels, reflected, mirrored, on_surfaces, texts)
