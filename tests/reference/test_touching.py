# SPDX-License-Identifier: MIT
"""Every light with every body, apart and touching: direct light against sums over many points of the source, of
irradiance and of brightness with highlights, and reflected light in furnaces and in integrating spheres.

The truth shares no code and no method with the library: stratified points of the lamp, each with its ray, which is
tried against each body; and in a closed room of one reflectance, whatever stands in it, ambient light E makes
E / (1 - rho) everywhere.  test_touching.py LUXEL 300 60 20 2000 tries 300 scenes, 60 furnaces and 20 integrating
spheres from the seed 2000 on; LUXEL_CAMPAIGN is the share of the usual number in per cent.
"""
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

import numpy as np

from obstacles import HIDES, beside, unit
from tap import Tap

SETS, SIDE = 16, 80       # sets of points of a lamp, and points along a side of each
CERTAIN = 8               # standard errors of the sums that are granted
SHOWN = 12
PROCESSOR_S = 120         # for a scene
FEW = 30                  # scenes, in which bodies may chance to hide nothing
MATT = {"model": "lambert", "diffuse": 0.5}
ANGLES, CANDELAS = (0.0, 40.0, 75.0, 90.0, 130.0, 180.0), (900.0, 1000.0, 250.0, 120.0, 60.0, 0.0)
TOUCHES = ("apart", "tangent", "in one plane", "reaching in", "in a wall")


# ---- points of lamps, with their normals and areas ----

def on_parallelogram(corner, a, b, u, v):
    normal = np.cross(a, b)
    area = np.linalg.norm(normal)
    return corner + np.outer(u, a) + np.outer(v, b), np.tile(normal / area, (len(u), 1)), np.full(len(u), area)


def points_of(light, u, v):
    """Points of a lamp's surface for places of the unit square, their normals, and the area per unit of the square."""
    shape, what = next((key, light[key]) for key in ("rectangle", "disk", "vertices", "box", "sphere", "cylinder")
                       if key in light)
    if shape == "rectangle":
        axis = unit(what["axis"])
        up = np.array(what["up"], float)
        up = unit(up - (up @ axis) * axis)
        right = np.cross(up, axis) * what["size"][0]
        up = up * what["size"][1]
        return on_parallelogram(np.array(what["center"]) - right / 2 - up / 2, right, up, u, v)
    if shape == "disk":
        axis, (first, second) = unit(what["axis"]), beside(what["axis"])
        r, t = what["radius"] * np.sqrt(u), 2 * math.pi * v
        return (np.array(what["center"]) + np.outer(r * np.cos(t), first) + np.outer(r * np.sin(t), second),
                np.tile(axis, (len(u), 1)), np.full(len(u), math.pi * what["radius"] ** 2))
    if shape == "vertices":  # convex
        corners, parts = np.array(what, float), []
        for i in range(1, len(corners) - 1):
            a, b = corners[i] - corners[0], corners[i + 1] - corners[0]
            normal, root = np.cross(a, b), np.sqrt(u)
            parts.append((corners[0] + np.outer(root * (1 - v), a) + np.outer(root * v, b),
                          np.tile(unit(normal), (len(u), 1)), np.full(len(u), np.linalg.norm(normal) / 2)))
        return tuple(np.concatenate(each) for each in zip(*parts))
    center = np.array(what["center"], float)
    if shape == "box":
        size, parts = np.array(what["size"], float), []
        for axis in range(3):
            for sign in -1, 1:
                a, b, c = (np.eye(3)[(axis + k) % 3] * size[(axis + k) % 3] for k in (1, 2, 0))
                a, c = a * sign, c * sign
                parts.append(on_parallelogram(center + c / 2 - a / 2 - b / 2, a, b, u, v))
        return tuple(np.concatenate(each) for each in zip(*parts))
    if shape == "sphere":
        height, turn = 2 * u - 1, 2 * math.pi * v
        flat = np.sqrt(1 - height * height)
        normals = np.stack([flat * np.cos(turn), flat * np.sin(turn), height], 1)
        return center + what["radius"] * normals, normals, np.full(len(u), 4 * math.pi * what["radius"] ** 2)
    axis, (first, second), turn = unit(what["axis"]), beside(what["axis"]), 2 * math.pi * v
    around = np.outer(np.cos(turn), first) + np.outer(np.sin(turn), second)
    side = (center + what["radius"] * around + np.outer((u - 0.5) * what["height"], axis), around,
            np.full(len(u), 2 * math.pi * what["radius"] * what["height"]))
    ends = [(center + sign * axis * what["height"] / 2 + (what["radius"] * np.sqrt(u))[:, None] * around,
             np.tile(sign * axis, (len(u), 1)), np.full(len(u), math.pi * what["radius"] ** 2)) for sign in (-1, 1)]
    return tuple(np.concatenate(each) for each in zip(side, *ends))


def sent(light, shape, u, v):
    """Points of a lamp, and for ways from a place to them the irradiance at right angles that each gives there."""
    if light["type"] in ("point", "spot"):
        def by_point(ways, squares):
            given = light["intensity"] * 1e6 / squares
            if light["type"] == "spot":
                angle = np.degrees(np.arccos(np.clip(-ways @ unit(light["axis"]) / np.sqrt(squares), -1, 1)))
                given = given * np.clip((light["outer"] - angle) / (light["outer"] - light["inner"]), 0, 1)
            return given
        return np.array([light["position"]]), by_point
    points, normals, areas = points_of(shape, u, v)
    if light["type"] == "luminaire":
        def by_table(ways, squares):
            cosines = -ways @ unit(light["axis"]) / np.sqrt(squares)
            candelas = np.interp(-cosines, -np.cos(np.radians(ANGLES)), CANDELAS)
            return candelas * areas / areas.sum() * 1e6 / squares
        return points, by_table
    return points, lambda ways, squares: (light["radiance"] / len(u) * areas * np.maximum(
        -(ways * normals).sum(1), 0) / squares ** 1.5)


def seen_by(material, normal, towards):
    """The share of the irradiance from directions that counts: its cosine, or what a material makes of it."""
    cosine = np.maximum(towards @ normal, 0)
    if material is None:
        return cosine
    if material["model"] == "phong":
        power = 2 * (towards @ normal) * normal[2] - towards[:, 2]
    else:
        half = towards + np.array([0, 0, 1.0])
        power = half @ normal / np.linalg.norm(half, axis=1)
    weight = {"plain": np.ones(len(towards)), "gated": towards @ normal > 0, "cosine": cosine}[material["highlight"]]
    return material["diffuse"] * cosine + material["specular"] * weight * np.maximum(power, 0) ** material["shininess"]


def truth(scene, shape, material, place, normal, rng):
    """The irradiance, or the brightness by a material, by each set of points, and that without bodies."""
    sums, whole = [], []
    light = scene["lights"][0]
    for _ in range(SETS):
        steps = np.arange(SIDE)
        u, v = (grid.ravel() for grid in np.meshgrid(steps, steps))
        u, v = (u + rng.random(len(u))) / SIDE, (v + rng.random(len(v))) / SIDE
        points, irradiance = sent(light, shape, u, v)
        ways = points - place
        squares = (ways * ways).sum(1)
        given = irradiance(ways, squares) * seen_by(material, normal, ways / np.sqrt(squares)[:, None])
        shines = given > 0
        ways, given = ways[shines], given[shines]
        whole.append(given.sum())
        seen = np.ones(len(ways), bool)
        for body in scene["surfaces"]:
            seen &= ~HIDES[body["type"]](body, place, ways)
        sums.append(given[seen].sum())
    return np.array(sums), np.mean(whole)


def doubt_of(sums, whole):
    """How far the mean of sums may be off; all points may miss a sliver."""
    return CERTAIN * (sums.std(ddof=1) / math.sqrt(SETS) + whole / (SETS * SIDE * SIDE))


# ---- scenes ----

def number(rng, low, high, is_round):
    value = rng.uniform(low, high)
    return round(value / 50) * 50.0 if is_round else value


def direction(rng, is_round):
    if is_round:
        return [float(x) for x in rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1), (-1, 0, 0), (1, 0, 1)])]
    return list(unit([rng.gauss(0, 1) for _ in range(3)]))


def lamp_of(kind, rng, is_round):
    """A lamp around (0, 0, 1000), most of which shine down, its axis, and the shape that shines."""
    if kind == "point":
        return {"type": "point", "position": [0.0, 0.0, 1000.0], "intensity": 100.0}, [0.0, 0.0, -1.0], None
    if kind == "spot":
        axis = [0.0, 0.0, -1.0] if rng.random() < 0.6 else direction(rng, is_round)
        return {"type": "spot", "position": [0.0, 0.0, 1000.0], "intensity": 100.0, "axis": axis, "inner": 25.0,
                "outer": 60.0, "falloff": "linear"}, axis, None
    if kind.startswith("opening "):
        return luminaire_of(kind.split()[1], rng, is_round)
    axis = [0.0, 0.0, -1.0] if rng.random() < 0.6 else direction(rng, is_round)
    up = list(beside(axis)[0]) if rng.random() < 0.5 else list(beside(axis)[1])
    center, size = [0.0, 0.0, 1000.0], [max(number(rng, 100, 600, is_round), 50) for _ in range(3)]
    shapes = {"rectangle": {"center": center, "size": size[:2], "axis": axis, "up": up},
              "disk": {"center": center, "radius": size[0] / 2, "axis": axis},
              "box": {"center": center, "size": size}, "sphere": {"center": center, "radius": size[0] / 2},
              "cylinder": {"center": center, "radius": size[0] / 4, "height": size[1], "axis": axis}}
    if kind == "vertices":
        first, second = beside(axis)
        turns = sorted(rng.uniform(0, 2 * math.pi) for _ in range(rng.randint(3, 6)))
        what = [list(np.array(center) + size[0] / 2 * (math.cos(t) * first + math.sin(t) * second)) for t in turns]
    else:
        what = shapes[kind]
    is_flat = kind in ("rectangle", "disk", "vertices")
    light = {"type": "planar" if is_flat else "volume", kind: what, "radiance": 100.0}
    return light, axis, {kind: what}


def luminaire_of(kind, rng, is_round):
    """A luminaire with an opening, whose table is the same all around."""
    _, axis, shape = lamp_of(kind, rng, is_round)
    what, axis = shape[kind], [0.0, 0.0, -1.0] if kind == "box" else [float(x) for x in axis]
    across = [0.0, 1.0, 0.0] if kind == "box" else what.get("up", beside(axis)[0])
    sizes = {key: what[key] for key in ("size", "radius", "height") if key in what}
    return {"type": "luminaire", "file": "lamp.ies", "position": what["center"], "axis": axis,
            "c0": [float(x) for x in np.cross(axis, across)], "interpolation": "cosine",
            "opening": {kind: sizes}}, axis, shape


def body_of(kind, rng, is_round, center, axis, scale):
    size = [max(number(rng, 0.3 * scale, 1.6 * scale, is_round), 50) for _ in range(3)]
    first, second = beside(axis)
    center, axis = [float(x) for x in center], [float(x) for x in axis]
    if kind == "mesh":  # a tetrahedron or a plate of two triangles, turned by the axis
        a, b, c = first * size[0] / 2, second * size[1] / 2, unit(axis) * size[2] / 2
        middle = np.array(center)
        if rng.random() < 0.5:
            corners, faces = [middle - a - b, middle + a - b, middle + a + b, middle - a + b], [(0, 1, 2), (0, 2, 3)]
        else:
            corners = [middle - c, middle + a, middle + b, middle - a - b]
            faces = [(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)]
        return {"type": "mesh", "corners": [[float(x) for x in p] for p in corners], "faces": faces}
    return {"type": kind, "center": center, **{
        "rectangle": {"size": size[:2], "axis": axis, "up": list(first)}, "disk": {"radius": size[0] / 2, "axis": axis},
        "sphere": {"radius": size[0] / 2}, "cylinder": {"radius": size[0] / 4, "height": size[1], "axis": axis},
        "box": {"size": size}}[kind]}


def reach(body, way):
    """How far a body reaches from its centre along a direction."""
    way = unit(way)
    if body["type"] == "sphere":
        return body["radius"]
    if body["type"] == "box":
        return float(np.abs(way) @ np.array(body["size"]) / 2)
    if body["type"] == "mesh":
        return 0.0
    axis = unit(body["axis"])
    flat = math.sqrt(max(1 - (way @ axis) ** 2, 0))
    if body["type"] == "disk":
        return body["radius"] * flat
    if body["type"] == "cylinder":
        return body["radius"] * flat + abs(way @ axis) * body["height"] / 2
    up = np.array(body["up"])
    return float(abs(way @ up) * body["size"][1] + abs(way @ np.cross(up, axis)) * body["size"][0]) / 2


def make(lamp, bodies, touch, rng):
    is_round = rng.random() < 0.5
    light, axis, shape = lamp_of(lamp, rng, is_round)
    what = None
    if shape and "vertices" not in shape:
        what = [{"type": kind, **keys} for kind, keys in shape.items()][0]
    surfaces = []
    for kind in bodies:
        way = unit([rng.gauss(0, 1), rng.gauss(0, 1), -abs(rng.gauss(0, 2))]) if not is_round else np.array(
            rng.choice([(0, 0, -1), (1, 0, 0), (0, 1, 0), (0, 0, -1)]), float)
        facing = axis if touch in ("in one plane", "in a wall") or rng.random() < 0.3 else direction(rng, is_round)
        body = body_of(kind, rng, is_round, (0, 0, 0), facing, 400)
        if touch == "apart":
            away = rng.uniform(500, 700) * way
        elif touch == "tangent" and what:
            away = (reach(what, way) + reach(body, way)) * way
        elif touch in ("in one plane", "in a wall"):
            first, second = beside(axis)
            away = 0 * first if touch == "in a wall" else number(rng, 100, 500, is_round) * first + number(
                rng, -200, 200, is_round) * second
        else:
            away = number(rng, 0, 300, is_round) * way
        center = np.array([0, 0, 1000.0]) + away
        if kind == "mesh":
            body["corners"] = [[float(x) for x in np.array(p) + center] for p in body["corners"]]
        else:
            body["center"] = [float(x) for x in center]
        surfaces.append(body)
    elements = []
    for _ in range(4):
        place = [number(rng, -500, 500, is_round), number(rng, -500, 500, is_round), number(rng, 0, 600, is_round)]
        normal = [0.0, 0.0, 1.0] if rng.random() < 0.6 else [rng.gauss(0, 0.5), rng.gauss(0, 0.5), 1.0]
        elements.append((place, [float(x) for x in unit(normal)]))
    return {"lights": [light], "surfaces": surfaces}, shape, elements


# ---- the trial ----

def ask(luxel, scene, elements, folder, *options, material=None):
    """What luxel tells of the elements, of which a material makes brightness."""
    surfaces = []
    with open(os.path.join(folder, "lamp.ies"), "w") as file:
        file.write("IESNA:LM-63-2002\n[TEST] own\n[TESTLAB] own\n[ISSUEDATE] now\n[MANUFAC] own\nTILT=NONE\n"
                   "1 -1 1 %d 1 1 2 0 0 0\n1 1 20\n%s\n0\n%s\n" % (
                       len(ANGLES), " ".join(map(repr, ANGLES)), " ".join(map(repr, CANDELAS))))
    for i, body in enumerate(scene["surfaces"]):
        if body["type"] == "mesh":
            with open(os.path.join(folder, "body%d.off" % i), "w") as file:
                file.write("OFF\n%d %d 0\n" % (len(body["corners"]), len(body["faces"])))
                file.writelines("%r %r %r\n" % tuple(corner) for corner in body["corners"])
                file.writelines("3 %d %d %d\n" % tuple(face) for face in body["faces"])
            body = {"type": "mesh", "file": "body%d.off" % i, "normals": "flat",
                    **({"material": body["material"]} if "material" in body else {})}
        surfaces.append({"material": material or MATT, **body})
    with open(os.path.join(folder, "scene.yaml"), "w") as file:
        json.dump({"luxel": 1, "shadows": "all", "screen": {"width": 4000, "height": 4000, "resolution": [40, 40]},
                   "observer": {"z": 9000}, **scene, "surfaces": surfaces}, file)
    with open(os.path.join(folder, "places.csv"), "w") as file:
        file.write("x,y,z,nx,ny,nz\n")
        file.writelines(",".join("%.17g" % x for x in place + normal) + "\n" for place, normal in elements)
    done = subprocess.run([luxel, "probe", "scene.yaml", "--points", "places.csv", "--quantity",
                           "brightness" if material else "irradiance", "--json", *options],
                          cwd=folder, capture_output=True, encoding="utf-8",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_S, PROCESSOR_S)))
    if done.returncode not in (0, 5):
        raise RuntimeError(done.stderr or "ended by %d" % done.returncode)
    return json.loads(done.stdout)["points"]


LAMPS = ("rectangle", "disk", "vertices", "box", "sphere", "cylinder", "point", "spot", "opening rectangle",
         "opening disk", "opening box", "opening sphere")
EACH = len(LAMPS) * len(TOUCHES) * len(HIDES)  # scenes with one of each


def glossy(rng):
    return {"model": rng.choice(["blinn-phong", "phong"]), "diffuse": 0.5, "specular": 0.4,
            "shininess": rng.choice([1, 8, 50.5]), "highlight": rng.choice(["plain", "gated", "cosine"])}


def is_doubtful(scene, place):
    """Whether a point source lies on a body, or the way to it along a border."""
    light = scene["lights"][0]
    if light["type"] not in ("point", "spot"):
        return False
    way = np.array(light["position"]) - place
    rng = np.random.default_rng(1)
    ways = np.concatenate([way + rng.normal(size=(40, 3)) * 1e-4, [way]])
    return any(len(set(HIDES[body["type"]](body, place, ways))) > 1 for body in scene["surfaces"])


def direct(tap, luxel, count, seed):
    """No error is larger than the bound that is told, and no bound larger than what arrives without bodies."""
    kinds = list(HIDES)
    false, wide, answered, hidden = [], [], 0, 0
    for i in range(count):
        rng, points = random.Random(seed + i), np.random.default_rng(seed + i)
        lamp, touch = LAMPS[i % len(LAMPS)], TOUCHES[i // len(LAMPS) % len(TOUCHES)]
        bodies = [kinds[i // (len(LAMPS) * len(TOUCHES)) % len(kinds)] if i < EACH else rng.choice(kinds)]
        bodies += [rng.choice(kinds)] if rng.random() < 0.3 else []
        scene, shape, elements = make(lamp, bodies, touch, rng)
        material = glossy(rng) if rng.random() < 0.4 else None
        with tempfile.TemporaryDirectory() as folder:
            try:
                told = ask(luxel, scene, elements, folder, material=material)
            except RuntimeError as fault:
                false.append("%d: %s, %s %s: %s" % (seed + i, lamp, ", ".join(bodies), touch, str(fault)[:300]))
                continue
        for (place, normal), point in zip(elements, told):
            if point.get("value") is None:
                continue
            if is_doubtful(scene, np.array(place)):
                continue
            sums, whole = truth(scene, shape, material, np.array(place), np.array(normal), points)
            doubt = doubt_of(sums, whole)
            answered += 1
            hidden += bool(sums.mean() < 0.999 * whole)
            words = "%d: %s, %s %s%s at %s %s: told %.9g ± %.2g, is %.9g ± %.2g of %.6g" % (
                seed + i, lamp, ", ".join(bodies), touch,
                ", %(model)s %(shininess)g %(highlight)s" % material if material else "", place,
                [round(x, 4) for x in normal], point["value"], point["error"], sums.mean(), doubt, whole)
            if abs(point["value"] - sums.mean()) > point["error"] + doubt + 1e-9 * whole:
                false.append(words)
            if point["error"] > 1.01 * whole + 1e-12:
                wide.append(words)
    tap.ok(not false, "%d places of %d scenes are within their bounds" % (answered, count), *false[:SHOWN])
    tap.ok(not wide, "no bound is larger than what arrives without bodies", *wide[:SHOWN])
    tap.ok(hidden > answered / 8 or count < FEW, "bodies hide something of the lamp", hidden, answered)


def through(tap, luxel):
    """Pipes through the far side of a globe, beyond its greatest circle, over which its light comes as well."""
    globe = {"sphere": {"center": [0.0, 0.0, 1000.0], "radius": 175.0}}
    light = {"type": "luminaire", "file": "lamp.ies", "position": [0.0, 0.0, 1000.0], "axis": [0.0, 0.0, -1.0],
             "c0": [1.0, 0.0, 0.0], "interpolation": "cosine", "opening": {"sphere": {"radius": 175.0}}}
    elements, false = [([150.0, -450.0, 100.0], [float(x) for x in unit([0.31, 0.64, 0.7])])], []
    for radius in 60, 80, 88, 95, 100:
        pipe = {"type": "cylinder", "center": [0.0, 160.0, 1000.0], "height": 50.0, "axis": [0.0, 1.0, 0.0],
                "radius": float(radius)}
        scene = {"lights": [light], "surfaces": [pipe]}
        with tempfile.TemporaryDirectory() as folder:
            point = ask(luxel, scene, elements, folder)[0]
        sums, whole = truth(scene, globe, None, *map(np.array, elements[0]), np.random.default_rng(radius))
        doubt = doubt_of(sums, whole)
        if abs(point["value"] - sums.mean()) > point["error"] + doubt or not sums.mean() + doubt < 0.99 * whole:
            false.append("radius %g: told %.9g ± %.2g, is %.9g ± %.2g of %.6g" % (
                radius, point["value"], point["error"], sums.mean(), doubt, whole))
    tap.ok(not false, "a pipe through the far side of a globe hides what it hides", *false)


# ---- furnaces ----

ROOM_MM = (4000.0, 3000.0, 2500.0)  # around (0, 0, 1250)


def is_within(body, place):
    """Whether a place lies in a body or so near that it is doubtful; for a mesh, in its box."""
    away = np.array(place) - np.array(body.get("center", (0, 0, 0)))
    if body["type"] == "mesh":
        corners = np.array(body["corners"])
        return bool(((corners.min(0) - 20 < place) & (place < corners.max(0) + 20)).all())
    if body["type"] == "sphere":
        return np.linalg.norm(away) < body["radius"] + 20
    if body["type"] == "box":
        return bool((np.abs(away) < np.array(body["size"]) / 2 + 20).all())
    axis = unit(body["axis"])
    along, aside = abs(away @ axis), math.sqrt(max(away @ away - (away @ axis) ** 2, 0))
    if body["type"] == "cylinder":
        return along < body["height"] / 2 + 20 and aside < body["radius"] + 20
    return along < 20


def on_inner_wall(rng, tube):
    """A place on the inner side of an open tube, and the way to its axis."""
    first, second = beside(tube["axis"])
    turn = rng.uniform(0, 2 * math.pi)
    out = math.cos(turn) * first + math.sin(turn) * second
    place = np.array(tube["center"]) + rng.uniform(-0.49, 0.49) * tube["height"] * unit(tube["axis"])
    return [float(x) for x in place + tube["radius"] * out], [float(-x) for x in out]


def is_in_room(place):
    return abs(place[0]) <= ROOM_MM[0] / 2 and abs(place[1]) <= ROOM_MM[1] / 2 and 0 <= place[2] <= ROOM_MM[2]


def furnace(rng, kinds):
    """A room of one reflectance with bodies that stand on its floor, in its walls, on or in each other, or free."""
    material = {"model": "lambert", "diffuse": rng.choice([0.2, 0.5, 0.7, 0.8]), "over_pi": True}
    is_round, surfaces = rng.random() < 0.6, []
    for kind in kinds:
        axis = direction(rng, is_round)
        body = body_of(kind, rng, is_round, (0, 0, 0), axis, 500)
        away = np.array([number(rng, -1200, 1200, is_round), number(rng, -800, 800, is_round), 1250.0])
        where = rng.choice(["free", "on the floor", "in a wall", "at another"])
        if where == "on the floor":
            away[2] = reach(body, (0, 0, 1))
        elif where == "in a wall":
            away[0] = 2000.0
        elif where == "at another" and surfaces and "center" in surfaces[-1]:
            way = np.array(rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, 1)]), float)
            share = rng.choice([1, 0.5, 0.9])
            away = np.array(surfaces[-1]["center"]) + share * (reach(body, way) + reach(surfaces[-1], way)) * way
        if kind == "mesh":
            body["corners"] = [[float(x) for x in np.array(p) + away] for p in body["corners"]]
        else:
            body["center"] = [float(x) for x in away]
        surfaces.append({**body, "material": material})
    elements = []
    while len(elements) < 3:
        place = [rng.uniform(-1900, 1900), rng.uniform(-1400, 1400), rng.choice([0.0, rng.uniform(100, 2400)])]
        if not any(is_within(body, place) for body in surfaces):
            elements.append((place, [0.0, 0.0, 1.0] if place[2] == 0 else [float(x) for x in unit(
                [rng.gauss(0, 1) for _ in range(3)])]))
    for tube in surfaces:
        place, normal = on_inner_wall(rng, tube) if tube["type"] == "cylinder" else (None, None)
        if place and is_in_room(place) and not any(is_within(body, place) for body in surfaces if body is not tube):
            elements.append((place, normal))
    room = {"type": "room", "center": [0.0, 0.0, ROOM_MM[2] / 2], "size": list(ROOM_MM), "material": material}
    scene = {"reflections": "all", "lights": [{"type": "ambient", "irradiance": 100}], "surfaces": [room, *surfaces]}
    return scene, elements, 100 / (1 - material["diffuse"])


def furnaces(tap, luxel, count, seed):
    """Every value is that of the furnace within its bound, and the bound no larger than that value."""
    kinds, false, wide, answered = list(HIDES), [], [], 0
    for i in range(count):
        rng = random.Random(seed + i)
        bodies = [kinds[i % len(kinds)]] + [rng.choice(kinds) for _ in range(rng.randint(0, 2))]
        scene, elements, value = furnace(rng, bodies)
        with tempfile.TemporaryDirectory() as folder:
            try:
                told = ask(luxel, scene, elements, folder, "--reflected-error", "0.01")
            except RuntimeError as fault:
                false.append("%d: %s: %s" % (seed + i, ", ".join(bodies), str(fault)[-300:]))
                continue
        for (place, normal), point in zip(elements, told):
            if point.get("value") is None:
                continue
            answered += 1
            words = "%d: %s at %s %s: told %.9g ± %.2g, is %.9g" % (
                seed + i, ", ".join(bodies), place, [round(x, 4) for x in normal], point["value"], point["error"],
                value)
            if abs(point["value"] - value) > point["error"] + 1e-9 * value:
                false.append(words)
            if point["error"] > value:
                wide.append(words)
    tap.ok(not false, "%d places of %d furnaces are within their bounds" % (answered, count), *false[:SHOWN])
    tap.ok(not wide, "no bound is larger than the value", *wide[:SHOWN])


# ---- integrating spheres ----

SPHERE_MM = 2000.0


def flux_of(light, shape):
    """All that a lamp sends."""
    if light["type"] == "point":
        return 4 * math.pi * light["intensity"]
    if light["type"] == "spot":
        inner, outer = math.radians(light["inner"]), math.radians(light["outer"])
        return 2 * math.pi * light["intensity"] * (1 - (math.sin(outer) - math.sin(inner)) / (outer - inner))
    if light["type"] == "luminaire":
        cosines = np.cos(np.radians(ANGLES))
        return 2 * math.pi * -np.trapz(CANDELAS, cosines)
    steps = (np.arange(2) + 0.5) / 2
    normals, areas = points_of(shape, steps, steps)[1:]
    return math.pi * light["radiance"] * areas.sum() / len(steps) * 1e-6


def spheres(tap, luxel, count, seed):
    """In an empty sphere that reflects rho, flux F makes F rho / (1 - rho) / area everywhere, whoever sends it."""
    false, answered = [], 0
    for i in range(count):
        rng = random.Random(seed + i)
        light, _, shape = lamp_of(LAMPS[-1 - i % len(LAMPS)], rng, rng.random() < 0.5)
        material = {"model": "lambert", "diffuse": rng.choice([0.2, 0.5, 0.8]), "over_pi": True}
        ball = {"type": "sphere", "center": [0, 0, 0], "radius": SPHERE_MM, "inside": True, "material": material}
        ways = [unit([rng.gauss(0, 1) for _ in range(3)]) for _ in range(3)]
        elements = [([float(x) for x in SPHERE_MM * way], [float(-x) for x in way]) for way in ways]
        value = flux_of(light, shape) * material["diffuse"] / (1 - material["diffuse"]) / (
            4 * math.pi * (SPHERE_MM / 1000) ** 2)
        with tempfile.TemporaryDirectory() as folder:
            try:
                told = ask(luxel, {"reflections": "all", "lights": [light], "surfaces": [ball]}, elements, folder,
                           "--reflected-error", "0.01")
            except RuntimeError as fault:
                false.append("%d: %s: %s" % (seed + i, light["type"], str(fault)[-300:]))
                continue
        for point in told:
            answered += 1
            found = point["reflected"]
            if abs(found["value"] - value) > found["error"] + 1e-9 * value:
                false.append("%d: %s: told %.9g ± %.2g, is %.9g" % (
                    seed + i, light, found["value"], found["error"], value))
    tap.ok(not false and answered == 3 * count, "%d places in %d spheres are within their bounds" % (answered, count),
           *false[:SHOWN])


def main():
    share = int(os.environ.get("LUXEL_CAMPAIGN", "100")) / 100
    counts = [max(round(usual * share), 3) for usual in (60, 12, 4)]
    given = [int(word) for word in sys.argv[2:]] + [1000]
    counts[:len(given) - 1] = given[:-1][:3]
    tap, luxel, seed = Tap(), os.path.abspath(sys.argv[1]), given[3] if len(given) > 4 else 1000
    tap.run(through, tap, luxel)
    tap.run(direct, tap, luxel, counts[0], seed)
    tap.run(furnaces, tap, luxel, counts[1], seed)
    tap.run(spheres, tap, luxel, counts[2], seed)
    tap.finish()


main()
