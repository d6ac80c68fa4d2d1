# SPDX-License-Identifier: MIT
"""Mirrors: light by the images of lamps and what sights meet, against ways traced leg by leg, and against the same
scenes with lamps mirrored by hand."""
import json
import math
import random

import mirrored_scenes as ways
from tap import Tap
from tool import run_tests

FLOOR = ways.Plate([0, 0, 0], [6000, 6000])
HEAD = {"luxel": 1, "screen": {"width": 600, "height": 600, "resolution": [12, 12]}, "observer": {"z": 50000}}
MATTE = {"over_pi": True, "specular": 0}
POINT = {"type": "point", "position": [200, 100, 700], "intensity": 10, "attenuation": "inverse-square"}


def scene(tool, surfaces, lights, **others):
    own = [surface if isinstance(surface, dict) else surface.scene(material=MATTE) for surface in surfaces]
    tool.write("mirror.yaml", json.dumps({**HEAD, "surfaces": own, "lights": lights, **others}))
    return "mirror.yaml"


def probe(tool, name, *places, quantity="irradiance"):
    at = [word for place in places for word in ("--at", ",".join(map(str, place)))]
    return tool.run("probe", name, "--quantity", quantity, "--json", *at, "--tolerance", "1e-6").json()["points"]


def is_close(tap, point, truth, share, name):
    bound = math.inf if point["error"] is None else point["error"]
    tap.ok(abs(point["value"] - truth) <= bound + share * truth + 1e-12, name,
              "%r is not %.12g" % ((point["value"], point["error"]), truth))


# ---- lamps of all kinds ----

def lamp_at(kind, place, draw):
    """A light of a kind, and its irradiance by ways."""
    if kind == "point":
        return {**POINT, "position": place}, lambda *task: ways.point_irradiance(*task[:4], place, 10, task[4])
    if kind == "spot":
        axis = ways.unit([draw.uniform(-1, 1), draw.uniform(-1, 1), -.5])

        def intensity(leaving):
            return 10 if ways.dot(leaving, axis) >= math.cos(math.radians(60)) * math.hypot(*leaving) else 0
        return ({"type": "spot", "position": place, "axis": axis, "intensity": 10, "inner": 60, "outer": 60,
                 "attenuation": "inverse-square"},
                lambda *task: ways.point_irradiance(*task[:4], place, intensity, task[4]))
    if kind == "distant":
        towards = ways.unit([draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(.3, 1)])
        return ({"type": "distant", "direction": [-x for x in towards], "irradiance": 10},
                lambda *task: ways.distant_irradiance(*task[:4], towards, 10, task[4]))
    if kind == "rectangle":
        plate = ways.Plate(place, [draw.uniform(50, 300) for _ in "ab"], [draw.uniform(-1, 1) for _ in "abc"],
                           [.2, .3, 1])
        return ({"type": "planar", "radiance": 10, "rectangle":
                 {"center": place, "size": plate.size, "axis": plate.axis, "up": plate.up}},
                lambda *task: ways.area_irradiance(*task[:4], ways.patches_of_rectangle(plate, 14), 10, task[4]))
    radius = draw.uniform(30, 120)
    return ({"type": "volume", "sphere": {"center": place, "radius": radius}, "radiance": 10},
            lambda *task: ways.area_irradiance(*task[:4], ways.patches_of_ball(place, radius, 11), 10, task[4]))


def drawn_surfaces(draw):
    """Mirrors at right angles or at any, and what may stand in the way."""
    surfaces = [FLOOR]
    at_right_angles = draw.random() < .5
    for i in range(draw.choice([1, 2, 2, 3])):
        turn = i * math.pi / 2 if at_right_angles else draw.uniform(0, 2 * math.pi)
        axis = [-math.cos(turn), -math.sin(turn), 0 if at_right_angles else draw.uniform(-.2, .2)]
        surfaces.append(ways.Plate([1500 * math.cos(turn), 1500 * math.sin(turn), 1100],
                                   [draw.uniform(600, 2900), draw.uniform(600, 2000)], axis, [0, 0, 1], True))
    for _ in range(draw.choice([0, 1, 2])):
        place = [draw.uniform(-900, 900), draw.uniform(-900, 900), draw.uniform(300, 1500)]
        axis, size = [draw.uniform(-1, 1) for _ in "abc"], draw.uniform(80, 250)
        surfaces.append(draw.choice([
            ways.Ball(place, size), ways.Disk(place, size, axis), ways.Tube(place, size / 2, 2 * size, axis),
            ways.Plate(place, [size, draw.uniform(100, 600)], axis, [.3, .5, 1])]))
    return surfaces


def lamps_of_all_kinds(tap, tool):
    for seed, kind in enumerate(("point", "spot", "distant", "rectangle", "ball") * 4):
        draw = random.Random(seed)
        surfaces, most = drawn_surfaces(draw), draw.choice([1, 2, 3])
        place = [draw.uniform(-900, 900), draw.uniform(-900, 900), draw.uniform(600, 1900)]
        light, truth = lamp_at(kind, place, draw)
        places = [[draw.uniform(-1200, 1200), draw.uniform(-1200, 1200), 0] for _ in range(3)]
        name = scene(tool, surfaces, [light], mirrors=most)
        for at, point in zip(places, probe(tool, name, *([*at, 0, 0, 1] for at in places))):
            share = .05 if kind in ("rectangle", "ball") else 1e-9
            is_close(tap, point, truth(surfaces, FLOOR, at, [0, 0, 1], most), share, "%s, scene %d" % (kind, seed))


# ---- images by hand ----

MIRROR = ways.Plate([1000, 0, 1000], [2000, 2000], [-1, 0, 0], [0, 0, 1], True)
AT = [300, 50, 0, 0, 0, 1]


def a_lamp_before_a_mirror(tap, tool):
    lights = {"point": ({**POINT}, {**POINT, "position": [1800, 100, 700]}),
              "rectangle": tuple({"type": "planar", "radiance": 10, "rectangle": {
                  "center": [x, 100, 900], "size": [200, 100], "axis": [side, 0, -1], "up": [0, 1, 0]}}
                  for x, side in ((200, 1), (1800, -1))),
              "disk": tuple({"type": "planar", "radiance": 10, "disk": {
                  "center": [x, 100, 900], "radius": 80, "axis": [side, 0, -2]}} for x, side in ((200, 1), (1800, -1))),
              "ball": tuple({"type": "volume", "radiance": 10, "sphere": {"center": [x, 100, 900], "radius": 80}}
                            for x in (200, 1800)),
              "cylinder": tuple({"type": "volume", "radiance": 10, "cylinder": {
                  "center": [x, 100, 900], "radius": 50, "height": 300, "axis": [side, 1, 0]}}
                  for x, side in ((200, 1), (1800, -1))),
              "box": tuple({"type": "volume", "radiance": 10, "box": {"center": [x, 100, 900], "size": [90, 80, 70]}}
                           for x in (200, 1800)),
              "practical": tuple({"type": "point", "position": [x, 100, 700], "intensity": 10, "attenuation":
                                  "practical", "k": 500} for x in (200, 1800))}
    for size, hole in ((2000, False), (700, True)):
        mirror = ways.Plate([1000, 0, 400], [size, size], [-1, 0, 0], [0, 0, 1], True)
        side, reach = size / 2, 30000
        frame = [ways.Plate([1000, y, z], [w, h], [-1, 0, 0], [0, 0, 1]) for y, z, w, h in (
            (-side - reach / 2, 400, reach, 2 * reach), (side + reach / 2, 400, reach, 2 * reach),
            (0, 400 + side + reach / 2, size, reach), (0, 400 - side - reach / 2, size, reach))] if hole else []
        for kind, (lamp, image) in lights.items():
            got = probe(tool, scene(tool, [FLOOR, mirror], [lamp]), AT)[0]
            direct = probe(tool, scene(tool, [FLOOR], [lamp]), AT)[0]
            mirrored = probe(tool, scene(tool, [FLOOR, *frame], [image]), AT)[0]
            tap.ok(mirrored["value"] > 0, "%s: its image is seen" % kind)
            is_close(tap, got, direct["value"] + mirrored["value"], 1e-6, "%s in a mirror of %d mm" % (kind, size))


def facing_mirrors(tap, tool):
    pair = [ways.Plate([side * 1000, 0, 1000], [8000, 2000], [-side, 0, 0], [0, 0, 1], True) for side in (-1, 1)]
    normal, place = [0, 0, 1], AT[:3]

    def by_hand(most):
        total = 0
        for n in range(-most, most + 1):
            x = 2000 * n + (200 if n % 2 == 0 else -200)
            way = [x - place[0], 100 - place[1], 700]
            total += 10e6 * way[2] / ways.dot(way, way) ** 1.5
        return total
    previous = None
    for most in (1, 2, 4, 20):
        point = probe(tool, scene(tool, [FLOOR, *pair], [POINT], mirrors=most), AT)[0]
        bound = point["error"]
        tap.ok(abs(point["value"] - by_hand(most)) <= 1e-9 * by_hand(most), "%d images each way" % most)
        tap.ok(by_hand(3000) - point["value"] <= bound, "the bound holds the rest of %d" % most)
        tap.ok(previous is None or bound < previous, "which is less than of fewer")
        previous = bound
    tap.near(ways.point_irradiance([FLOOR, *pair], FLOOR, place, normal, POINT["position"], 10, 4), by_hand(4), 1e-9,
             "so tell the ways")
    tap.ok(probe(tool, scene(tool, [FLOOR, *pair], [{**POINT, "attenuation": "none"}]), AT)[0]["error"] is None,
           "of light that distance does not weaken no bound is known")
    cylindrical = tool.run("grid", scene(tool, [FLOOR, *pair], [POINT], grids=[
        {"center": AT[:3], "size": [9, 9], "n": [1, 1], "measure": "cylindrical"}]), "--json").json()["grids"][0]
    tap.ok(cylindrical["values"][0][0] > 0 and 0 < cylindrical["errors"][0][0] < 10, "measures have a bound, too")


def two_pairs(tap, tool):
    """Four facing walls: images on a lattice, summed by hand; a bound where one is known, and none where they add up to
    more than any number."""
    walls = [ways.Plate([x * 1000, y * 1500, 1000], [8000, 2000], [-x, -y, 0], [0, 0, 1], True)
             for x, y in ((-1, 0), (1, 0), (0, -1), (0, 1))]
    place = [300, 50, 0]
    away = [place, [300, 50, 700]]

    def by_hand(most, at, up, downlight):
        total = 0
        for n in range(-most, most + 1):
            x = 2000 * n + (200 if n % 2 == 0 else -200)
            for k in range(-most + abs(n), most - abs(n) + 1):
                y = 3000 * k + (100 if k % 2 == 0 else -100)
                way = [x - at[0], y - at[1], 900 - at[2]]
                square = ways.dot(way, way)
                total += 10e6 * max(ways.dot(way, up), 0) / square ** 1.5 * (way[2] / square ** .5 if downlight else 1)
        return total
    lamp = {**POINT, "position": [200, 100, 900]}
    down = {**lamp, "pattern": "lambertian"}
    tilted = ways.unit([1, 2, 3])
    for light, at, up, is_bounded, name in ((lamp, away[0], [0, 0, 1], True, "what faces the third axis"),
                                            (lamp, away[1], [0, 0, 1], True, "so above the floor"),
                                            (lamp, away[1], tilted, False, "what does not: the sum has no bound"),
                                            (down, away[1], tilted, True, "a downlight does not fill the hall")):
        previous = None
        for most in (2, 4, 6):
            point = probe(tool, scene(tool, [FLOOR, *walls], [light], mirrors=most), [*at, *up])[0]
            truth = by_hand(most, at, up, light is down)
            tap.near(point["value"], truth, 1e-9, "%s: %d mirrors in a row" % (name, most))
            if not is_bounded:
                tap.ok(point["error"] is None, "and no bound is told")
                continue
            rest = by_hand(400, at, up, light is down) - truth
            tap.ok(0 < rest <= point["error"] < 12 * rest, "the bound holds the rest", (rest, point["error"]))
            tap.ok(previous is None or point["error"] < previous, "and less of more mirrors")
            previous = point["error"]
    spot = {"type": "spot", "position": [200, 100, 900], "intensity": 10, "inner": 40, "outer": 50}
    point = probe(tool, scene(tool, [FLOOR, *walls], [spot], mirrors=4), [*away[1], *tilted])[0]
    tap.ok(point["error"] < 1e-9 * point["value"], "of a cone no light comes from far images", point)
    room = {"type": "room", "center": [0, 0, 1000], "size": [2000, 3000, 2000], "up": "z", "material": {"mirror": True}}
    tap.ok(probe(tool, scene(tool, [room], [lamp], mirrors=2), [*away[1], 0, 0, 1])[0]["error"] is None,
           "of three pairs no bound is told")


def a_corner(tap, tool):
    """Three images, and nothing else: the bound is that of roundings."""
    corner = [MIRROR, ways.Plate([0, 1000, 1000], [2000, 2000], [0, -1, 0], [0, 0, 1], True)]
    point = probe(tool, scene(tool, [FLOOR, *corner], [POINT]), AT)[0]
    truth = 0
    for x, y in ((200, 100), (1800, 100), (200, 1900), (1800, 1900)):
        way = [x - 300, y - 50, 700]
        truth += 10e6 * way[2] / ways.dot(way, way) ** 1.5
    is_close(tap, point, truth, 1e-12, "a corner has three images")
    tap.ok(point["error"] < 1e-9 * truth, "and no rest")
    name = scene(tool, [{"type": "room", "center": [0, 0, 1000], "size": [2000, 2000, 2000], "up": "z",
                         "material": MATTE, "materials": {"right": {"mirror": True}, "back": {"mirror": True}}}],
                 [POINT])
    is_close(tap, probe(tool, name, AT)[0], truth, 1e-12, "so has that of a room")
    name = scene(tool, [FLOOR, {"type": "box", "center": [1500, 0, 1000], "size": [1000, 2000, 2000], "up": "z",
                                "material": MATTE, "materials": {"left": {"mirror": True}}}], [POINT])
    is_close(tap, probe(tool, name, AT)[0], probe(tool, scene(tool, [FLOOR, MIRROR], [POINT]), AT)[0]["value"], 1e-12,
             "the side of a box is a mirror like a rectangle")


def what_stands_before_it(tap, tool):
    """On the way to the mirror, and on that from it."""
    direct = probe(tool, scene(tool, [FLOOR], [POINT]), AT)[0]["value"]
    both = probe(tool, scene(tool, [FLOOR, MIRROR], [POINT]), AT)[0]["value"]
    image = [1800, 100, 700]
    on_mirror = ways.along(AT[:3], 700 / 1500, ways.sub(image, AT[:3]))
    for name, middle in (("to", ways.along(POINT["position"], .5, ways.sub(on_mirror, POINT["position"]))),
                         ("from", ways.along(AT[:3], .5, ways.sub(on_mirror, AT[:3])))):
        ball = ways.Ball(middle, 20)
        got = probe(tool, scene(tool, [FLOOR, MIRROR, ball], [POINT]), AT)[0]["value"]
        tap.ok(got == direct and both > direct, "what stands on the way %s the mirror takes the image" % name)
        free = probe(tool, scene(tool, [FLOOR, MIRROR, ball], [POINT], shadows="none"), AT)[0]["value"]
        tap.ok(free == both, "without shadows it does not")
    behind = [*AT[:2], 0, 0, 0, 1]
    behind[0] = 1300
    tap.ok(probe(tool, scene(tool, [FLOOR, MIRROR], [POINT]), behind)[0]["value"] == 0,
              "behind the mirror it is dark")


def bodies_and_meshes(tap, tool):
    """The same body as a box and as a mesh, before a mirror and across its plane."""
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    tool.write("cube.obj", "".join("v %g %g %g\n" % tuple(100 * x for x in corner) for corner in corners) +
               "".join("f %d %d %d %d\n" % face for face in faces))
    lamp = {"type": "planar", "radiance": 10, "rectangle": {"center": [200, 100, 900], "size": [300, 300],
                                                            "axis": [1, 0, -1], "up": [0, 1, 0]}}
    places = [[x, 30, 0, 0, 0, 1] for x in (100, 300, 500, 700, 900)]
    for x in (600, 1000):
        box = {"type": "box", "center": [x, 40, 500], "size": [200, 200, 200], "material": MATTE}
        mesh = {"type": "mesh", "file": "cube.obj", "position": [x, 40, 500], "material": MATTE}
        values = [probe(tool, scene(tool, [FLOOR, MIRROR, body], [lamp]), *places) for body in (box, mesh)]
        for one, other in zip(*values):
            tap.ok(abs(one["value"] - other["value"]) <= one["error"] + other["error"] + 1e-6 * one["value"],
                      "a mesh at x = %d hides what a box does" % x, (one["value"], one["error"], other["value"],
                                                                     other["error"]))


# ---- sights ----

SHINY = {"over_pi": True, "specular": .4, "shininess": 30}


def room_with_mirror(tool, **others):
    surfaces = [FLOOR.scene(material=SHINY), ways.Ball([-100, 50, 200], 150).scene(material=SHINY),
                ways.Plate([600, 0, 500], [900, 900], [-1, 0, 0], [0, 0, 1], True).scene()]
    return scene(tool, surfaces, [{**POINT, "position": [0, -300, 800]}],
                 observer={"position": [-900, 0, 700], "target": [600, 0, 400], "up": [0, 0, 1],
                           "projection": "perspective"}, **others)


def what_a_mirror_shows(tap, tool):
    name = room_with_mirror(tool)
    seen = tool.run("probe", name, "-p", "60,30", "-p", "0,0", "-p", "-120,-200", "--json").json()["points"]
    for point in seen:
        at, view = [*point["position"], *point["normal"]], ways.unit(ways.sub([2100, 0, 700], point["position"]))
        again = tool.run("probe", name, "--at", ",".join(map(repr, at)), "--view", ",".join(map(repr, view)),
                         "--json").json()["points"][0]
        tap.ok(abs(again["value"] - point["value"]) <= 1e-9 * point["value"] and point["value"] > 0,
               "a pixel of a mirror is what its sight meets, seen from the mirrored eye",
               (again["value"], point["value"]))
    tap.ok(math.dist(seen[1]["position"], [-100, 50, 200]) < 150 + 1e-6, "in the middle it is the ball")
    place = [600, 20, 450]
    sight = ways.unit(ways.sub([-900, 0, 700], place))
    free = tool.run("probe", name, "--at", "600,20,450,-1,0,0", "--json").json()["points"][0]
    met = ways.unit(ways.sub(place, free["position"]))
    tap.ok(ways.dot(met, [-sight[0], sight[1], sight[2]]) > 1 - 1e-9, "a point of a mirror shows what its sight meets",
           (met, sight))


def colours_in_a_mirror(tap, tool):
    """What a mirror shows has the colours of what it shows, in pictures as in probes: here the back of the ball."""
    tool.run("render", "mirror", "-o", "mirror.csv")
    rows = [line.split(",") for line in tool.read("mirror.csv").decode().splitlines()[1:]]
    for at in ("-273.75,176.25", "-251.25,176.25", "168.75,-153.75"):
        point = tool.run("probe", "mirror", "-p", at, "--json").json()["points"][0]
        shown = [[float(word) for word in row[2:5]] for row in rows if ",".join(row[:2]) == at]
        exact = point["rgb"]["value"]
        tap.ok(len(shown) == 1 and all(abs(a - b) <= 1e-5 * max(exact) for a, b in zip(shown[0], exact)), "at " + at,
               exact, shown)


def pictures(tap, tool):
    name = room_with_mirror(tool)
    for threads in ("1", "3"):
        tool.run("render", name, "-o", "picture%s.npy" % threads, "--threads", threads)
    tap.ok(tool.read("picture1.npy") == tool.read("picture3.npy"),
              "threads change no byte")
    points = [word for i in range(-5, 6, 2) for word in ("-p", "%d,%d" % (50 * i + 25, 25 - 50 * i))]
    for point in tool.run("probe", name, "--json", *points).json()["points"]:
        tap.ok(abs(point["pixel_value"] - point["value"]) <= 2e-6 * max(point["value"], 1),
                  "a pixel has the probe's value", (point["pixel_value"], point["value"]))


def pictures_tell_the_rest(tap, tool):
    """A picture's bound of what more mirrors give, against the picture of many mirrors."""
    pair = [ways.Plate([side * 400, 0, 400], [3000, 800], [-side, 0, 0], [0, 0, 1], True) for side in (-1, 1)]
    surfaces = [FLOOR.scene(material=SHINY), ways.Ball([50, 100, 60], 60).scene(material=SHINY),
                *(plate.scene() for plate in pair)]
    others = {"observer": {"position": [100, -900, 700], "target": [0, 0, 100], "up": [0, 0, 1],
                           "projection": "perspective"},
              "screen": {"width": 900, "height": 900, "resolution": [24, 24]}}
    for color in ({}, {"channels": "rgb"}):
        lights = [{**POINT, "position": [100, -100, 600], **({"color": {"temperature": 2700}} if color else {})},
                  {**POINT, "position": [-200, 50, 500], "intensity": 3}]
        pictures = []
        for most in (1, 3, 30):
            name = scene(tool, surfaces, lights, mirrors=most, **others, **color)
            found = tool.run("render", name, "-o", "deep.csv", "--json")
            lines = tool.read("deep.csv").decode().splitlines()[1:]
            channels = [list(map(float, line.split(",")[2:])) for line in lines]
            values = [ways.dot(row, (.2126390058715, .7151686787678, .0721923153607)) if color else row[0]
                      for row in channels]
            pictures.append((found.json(), values))
            told = tool.run("render", name)
            tap.ok("error of light over mirrors" in told.out and "is missing in the picture: up to" in told.err,
                   "%d: told in words" % most, told.out + told.err)
        truth = pictures[-1][1]
        for most, (found, values) in zip((1, 3), pictures):
            apart = max(abs(a - b) for a, b in zip(values, truth)) / found["max"]["value"]
            tap.ok(0 < apart <= found["mirrored_error"], "%d mirrors: the bound holds" % most,
                   (color, apart, found["mirrored_error"]))
    name = room_with_mirror(tool)
    tap.ok("mirrored_error" not in tool.run("render", name, "--json").json(), "one mirror leaves nothing out")
    name = scene(tool, surfaces, [{**POINT, "attenuation": "none"}], mirrors=1, **others)
    found = tool.run("render", name, "--json")
    tap.ok(found.json()["mirrored_error"] is None and "no bound of it is known" in found.err,
           "where no bound is known that is told", found.err)


def sights_without_end(tap, tool):
    """More mirrors in a row than are counted: what is there is in the bound."""
    pair = [ways.Plate([side * 300, 0, 500], [4000, 1000], [-side, 0, .01], [0, 0, 1], True).scene()
            for side in (-1, 1)]
    surfaces = [FLOOR.scene(material=SHINY), *pair]
    others = {"observer": {"position": [0, 0, 900], "target": [300, 0, 700], "up": [0, 0, 1],
                           "projection": "perspective"}}
    points = {}
    for most in (1, 16):
        name = scene(tool, surfaces, [{**POINT, "position": [0, -300, 800]}], mirrors=most, **others)
        points[most] = tool.run("probe", name, "-p", "0,0", "--json").json()["points"][0]
    tap.ok("in a row is missing" in tool.run("render", name, "-o", "pair.npy").err, "a picture tells of it")
    tap.ok(points[1]["value"] == 0 and points[16]["value"] > 0 and points[1]["error"] >= points[16]["value"],
              "what is not followed is in the bound", points)


def commands(tap, tool):
    name = room_with_mirror(tool, grids=[{"center": [100, 300, 5], "size": [500, 400], "n": [3, 2]}])
    grid = tool.run("grid", name, "--json").json()["grids"][0]
    for row in range(2):
        for column in range(3):
            place = [100 + (column - 1) * 500 / 3, 300 - (row - .5) * 200, 5, 0, 0, 1]
            value = probe(tool, name, place)[0]["value"]
            tap.ok(abs(grid["values"][row][column] - value) <= 1e-9 * value, "a grid has what probes have")
    text = tool.run("explain", name, "-p", "0,0").out
    tap.ok("meets a mirror" in text, "explain tells of the mirror that is looked into")
    tap.ok("Over mirrors the light comes" in tool.run("explain", name, "-p", "0,-250").out + text,
              "and of light over mirrors")
    tap.ok("valid" in tool.run("check", name).out, "check finds it valid")


def what_is_refused(tap, tool):
    sphere = {**ways.Ball([0, 0, 200], 100).scene(), "material": {"mirror": True}}
    window = {"type": "room", "center": [0, 0, 1000], "size": [3000, 3000, 2000],
              "openings": [{"wall": "right", "center": [0, 0], "size": [500, 500]}]}
    for surfaces, others, words in (
            ([sphere], {}, "sphere cannot be a mirror"),
            ([FLOOR, MIRROR], {"mirrors": 0}, "mirrors"),
            ([FLOOR, MIRROR], {"mirrors": -1}, "mirrors"),
            ([FLOOR, MIRROR], {"mirrors": 2.5}, "mirrors"),
            ([FLOOR, MIRROR], {"reflections": "all"}, "calculated of lamps alone"),
            ([FLOOR, {"type": "room", "center": [0, 0, 1000], "size": [3000, 3000, 2000], "material": MATTE,
                      "materials": {"left": {"mirror": True}}}], {"reflections": 2}, "calculated of lamps alone")):
        result = tool.run("probe", scene(tool, surfaces, [POINT], **others), "--at", "0,0,0,0,0,1")
        tap.ok(words in result.err, "refused: %s" % words, result.err)
    for surfaces, light in (([FLOOR, MIRROR], {"type": "sky", "kind": 5, "zenith": 1}),
                            ([FLOOR, MIRROR], {"type": "sun", "irradiance": 1, "altitude": 40, "azimuth": 200}),
                            ([window, MIRROR], POINT)):
        result = tool.run("probe", scene(tool, surfaces, [light]), "--at", "0,0,0,0,0,1")
        tap.ok(result.code == 3 and "light of the sky, of the sun and through openings" in result.err,
               "refused with daylight: %s" % light["type"], result.err)


if __name__ == "__main__":
    run_tests(Tap(), lamps_of_all_kinds, a_lamp_before_a_mirror, facing_mirrors, two_pairs, a_corner,
              colours_in_a_mirror,
              what_stands_before_it, bodies_and_meshes, what_a_mirror_shows, pictures, pictures_tell_the_rest,
              sights_without_end, commands, what_is_refused)
