# SPDX-License-Identifier: MIT
"""Random good scenes that use every key of the parameter table sooner or later, the same for the same seed."""
import math

# Files that they name: a cube, in both formats, and a cloud.
CORNERS = [(x, y, z) for z in (1900, 2100) for y in (-100, 100) for x in (-100, 100)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
FILES = {
    "cube.off": "OFF\n8 6 12\n" + "".join("%d %d %d\n" % corner for corner in CORNERS)
                + "".join("4 %d %d %d %d\n" % face for face in FACES),
    "cube.obj": "".join("v %d %d %d\n" % corner for corner in CORNERS)
                + "".join("f %d %d %d %d\n" % tuple(i + 1 for i in face) for face in FACES),
    "lamps.csv": "x,y,z,intensity\n0,0,2000,5\n100,50,1900,0\n",
}


# By which a mesh may be shaded that has none of its own.
NORMALS = ["auto", "smooth", "flat"]


def _number(rng, low=-1000.0, high=1000.0):
    return rng.choice([rng.uniform(low, high), round(rng.uniform(low, high)), round(rng.uniform(low, high), 2)])


def _above(rng):
    return rng.choice([1e-300, 0.001, 1, 20, 1e300, rng.uniform(0.01, 100)])


def _from_zero(rng):
    return rng.choice([0, -0.0, 0.0, _above(rng)])


def _vector(rng):
    return rng.choice([[0, 0, -1], [1e-300, 0, 0], [0, -2.5, 0], [_number(rng, 1) for _ in range(3)]])


def _some(rng, keys):
    """Some of the keys that may be left out."""
    return {key: make() for key, make in keys.items() if rng.random() < 0.5}


def _name(rng):
    return rng.choice(["lamp", "", "5", "true", "null", "с именем", "two words", "#", "a: b", "☀", "\t", "0x1"])


def _shining(rng, position):
    light = {}
    law = rng.choice([None, "none", "inverse-square", "practical", "polynomial"])
    if law:
        light["attenuation"] = law
    if law == "practical" or rng.random() < 0.2:
        light["k"] = _above(rng)
    if law == "polynomial" or rng.random() < 0.1:
        light["coefficients"] = [_from_zero(rng), _above(rng), _from_zero(rng)]
    way = rng.choice([None, "axis", "aim"])
    if way:
        light[way] = _vector(rng) if way == "axis" else [position[0] + 1, position[1], position[2]]
    return light


def _placed(rng, strengths=("intensity", "power")):
    position = [_number(rng) for _ in range(3)]
    return {"position": position, rng.choice(strengths): _from_zero(rng), **_shining(rng, position)}


def _pattern(rng):
    light = {}
    pattern = rng.choice([None, "isotropic", "lambertian", "cosine"])
    if pattern:
        light["pattern"] = pattern
    if pattern == "cosine" or rng.random() < 0.2:
        light["exponent"] = _from_zero(rng)
    return light


def _array(rng):
    return {"n": [rng.randint(1, 4), rng.randint(1, 4)], "spacing": [rng.uniform(1, 1e4), rng.uniform(1, 1e4)],
            **_some(rng, {"axes": lambda: [[1, rng.uniform(-1, 1), 0], [0, 1, rng.uniform(-1, 1)]]})}


def _point(rng):
    return {"type": "point", **_placed(rng), **_pattern(rng), **_some(rng, {"array": lambda: _array(rng)})}


def _points(rng):
    return {"type": "points", "file": "lamps.csv", **_shining(rng, [0, 0, 0]), **_pattern(rng)}


def _spot(rng):
    outer = rng.choice([0, 30, 90, rng.uniform(0, 90)])
    inner = rng.choice([0, outer, rng.uniform(0, outer)])
    strengths = ["intensity", "power"] if outer > 0 else ["intensity"]  # no power leaves a cone of no width
    return {"type": "spot", **_placed(rng, strengths), "inner": inner, "outer": outer, **_some(rng, {
        "falloff": lambda: rng.choice(["smoothstep", "squared", "linear", "hard"]),
        "exponent": lambda: _from_zero(rng)})}


def _size(rng):
    return rng.choice([1e-3, 1, 250, 1e4, rng.uniform(0.1, 1000)])


def _outline(rng):
    """The corners of a star or a convex polygon in some plane."""
    count, center, radius = rng.randint(3, 9), [_number(rng) for _ in range(3)], _size(rng) + 1
    dent = rng.choice([1, 1, 0.3]) if count % 2 == 0 and count > 4 else 1
    turn, tilt = rng.uniform(0, 7), rng.uniform(0, 7)
    corners = []
    for i in range(count):
        angle, reach = turn + 2 * math.pi * i / count, radius * (dent if i % 2 else 1)
        x, y = reach * math.cos(angle), reach * math.sin(angle)
        corners.append([center[0] + x, center[1] + y * math.cos(tilt), center[2] + y * math.sin(tilt)])
    return corners


def _way(rng, center):
    """An axis, a point to aim at, or neither."""
    return rng.choice([{}, {"axis": _vector(rng)}, {"aim": [center[0] + 3, center[1] + 5, center[2] - 7]}])


def _spread(rng, strengths):
    """What lights of some size have in common."""
    law = rng.choice([None, "none", "inverse-square", "practical", "polynomial"])
    light = {rng.choice(strengths): _from_zero(rng)}
    if law:
        light["attenuation"] = law
    if law == "practical" or rng.random() < 0.2:
        light["k"] = _above(rng)
    if law == "polynomial" or rng.random() < 0.1:
        light["coefficients"] = [_from_zero(rng), _above(rng), _from_zero(rng)]
    return {**light, **_some(rng, {"parts": lambda: rng.choice(["converged", 1, 3, 1000])})}


def _planar(rng):
    center = [_number(rng) for _ in range(3)]
    way = _way(rng, center)
    # whatever the axis is, these are not parallel to it
    up = _some(rng, {"up": lambda: [0.3, 1, 0.7]})
    outline = rng.choice([{"vertices": _outline(rng)},
                          {"rectangle": {"center": center, "size": [_size(rng), _size(rng)], **way, **up}},
                          {"disk": {"center": center, "radius": _size(rng), **way}}])
    sides = _some(rng, {"sides": lambda: rng.choice(["front", "both"])})
    return {"type": "planar", **outline, **sides, **_spread(rng, ["intensity", "radiance", "power"])}


def _volume(rng):
    center = [_number(rng) for _ in range(3)]
    body = rng.choice([
        {"box": {"center": center, "size": [_size(rng) for _ in range(3)]}},
        {"sphere": {"center": center, "radius": _size(rng), **_some(rng, {"facets": lambda: rng.randint(4, 60)})}},
        {"cylinder": {"center": center, "radius": _size(rng), "height": _size(rng),
                      **_some(rng, {"facets": lambda: rng.randint(3, 60), "axis": lambda: _vector(rng)})}},
        {"mesh": rng.choice(["cube.obj", "cube.off"]), **_some(rng, {"scale": lambda: _size(rng)})}])
    return {"type": "volume", **body, **_spread(rng, ["radiance", "power"])}


def _grid(rng):
    size = [_size(rng), _size(rng)]
    cells = rng.choice([{"n": [1, 1]}, {"n": [7, 65536]}, {"n": [3, 4]}, {"spacing": "en12464", "size": [900, 2500.5]}])
    return {"center": [_number(rng) for _ in range(3)], "size": size, **cells,
            **_some(rng, {"name": lambda: _name(rng), "axis": lambda: _vector(rng), "up": lambda: [0.3, 1, 0.7],
                          "limits": lambda: _some(rng, {
                              "average": lambda: _from_zero(rng), "minimum": lambda: _from_zero(rng),
                              "maximum": lambda: _from_zero(rng), "uniformity": lambda: rng.choice([0, 1, 0.6]),
                              "ratio": lambda: rng.choice([0.5, 1, 40]),
                              "preset": lambda: rng.choice(["en12464-office", "en1838-open-area"])})})}


def _observer(rng):
    return {"eye": [_number(rng) for _ in range(3)], "view": _vector(rng),
            **_some(rng, {"name": lambda: _name(rng), "limits": lambda: _some(rng, {
                "ugr": lambda: rng.choice([13, 19, 28]), "preset": lambda: "en12464-corridor"})})}


def _light(rng):
    kind = rng.choice(["point", "point", "spot", "spot", "distant", "ambient", "planar", "planar", "volume", "volume",
                       "points"])
    if kind == "point":
        light = _point(rng)
    elif kind == "points":
        light = _points(rng)
    elif kind == "spot":
        light = _spot(rng)
    elif kind == "distant":
        light = {"type": kind, "direction": _vector(rng), "irradiance": _from_zero(rng)}
    elif kind == "planar":
        light = _planar(rng)
    elif kind == "volume":
        light = _volume(rng)
    else:
        light = {"type": kind, "irradiance": _from_zero(rng)}
    return {**light, **_some(rng, {"name": lambda: _name(rng), "enabled": lambda: rng.random() < 0.7})}


def _material(rng):
    material = _some(rng, {
        "model": lambda: rng.choice(["blinn-phong", "phong", "ggx", "lambert"]),
        "diffuse_model": lambda: rng.choice(["lambert", "oren-nayar", "eon"]),
        "sigma": lambda: rng.choice([0, 90, rng.uniform(0, 90)]), "roughness": lambda: rng.choice([0, 1, rng.random()]),
        "alpha": lambda: rng.choice([1, rng.uniform(1e-3, 1)]), "f0": lambda: rng.choice([0, 1, rng.random()]),
        "diffuse": lambda: _from_zero(rng), "specular": lambda: _from_zero(rng), "shininess": lambda: _above(rng),
        "ambient": lambda: _from_zero(rng), "over_pi": lambda: rng.random() < 0.5,
        "highlight": lambda: rng.choice(["plain", "gated", "cosine"]), "normalized": lambda: rng.random() < 0.5})
    if material.get("diffuse_model") == "eon" and "diffuse" in material:
        material["diffuse"] = min(material["diffuse"], 1)
    return material


def _range(rng):
    low = _number(rng)
    return rng.choice(["max", "minmax", "log", [low, low + rng.choice([1e-9, 1, 100]) * max(1, abs(low))]])


def _surface(rng):
    """A surface, and how high an observer must stand to see its front."""
    center = [_number(rng) for _ in range(3)]
    common = _some(rng, {"name": lambda: _name(rng), "material": lambda: _material(rng)})
    if rng.random() < 0.6:
        radius = rng.uniform(1e-3, 1000)
        return {"type": "sphere", "center": center, "radius": radius, **common}, center[2] + radius
    if rng.random() < 0.3:
        sizes = [rng.uniform(1e-3, 1000) for _ in range(3)]
        keys = _some(rng, {
            "rotate": lambda: [_number(rng), 90, 0], "up": lambda: rng.choice(["y", "z"]),
            "materials": lambda: _some(rng, {"top": lambda: _material(rng), "left": lambda: _material(rng)})})
        return {"type": "box", "center": center, "size": sizes, **keys, **common}, center[2] + sum(sizes)
    if rng.random() < 0.2:
        scale = rng.choice([0.1, 1, rng.uniform(0.01, 2)])
        keys = _some(rng, {
            "rotate": lambda: [_number(rng), 90, 0], "normals": lambda: rng.choice(NORMALS),
            "crease": lambda: rng.choice([0, 180, 30.5]), "sides": lambda: rng.choice(["both", "front"])})
        mesh = {"type": "mesh", "file": rng.choice(["cube.off", "cube.obj"]), "scale": scale, "position": center}
        return {**mesh, **keys, **common}, center[2] + 2200 * scale
    size = [rng.uniform(1e-3, 1000) for _ in range(2)]
    keys = _some(rng, {"axis": lambda: rng.choice([[0, 0, 1e-300], [rng.uniform(-3, 3), 2.5, 10]]),
                       "up": lambda: rng.choice([[0, 1, 0], [-1, 0, 0], [1e300, -1e300, 0]])})
    lean = 0.3 * (abs(center[0]) + abs(center[1]))
    return {"type": "rectangle", "center": center, "size": size, **keys, **common}, center[2] + sum(size) + lean


def _place(rng, height):
    """Where an observer stands who is so high above the surfaces: at a height, or somewhere, looking straight down."""
    if rng.random() < 0.6:
        return {"z": height}
    x, y = _number(rng), _number(rng)
    return {"position": [x, y, height], "target": [x, y, height - rng.choice([1, 1e4])],
            **_some(rng, {"up": lambda: [rng.choice([1, -3]), _number(rng), _number(rng)]})}


def good_scene(rng):
    """A scene as a mapping that both the tool and the schema must accept."""
    columns, rows = rng.choice([(1, 1), (360, 360), (500, 400), (65536, 1), (7, 131)])
    pitch = rng.choice([1, 0.5, 1e-3, 1e3])
    surfaces, fronts = zip(*(_surface(rng) for _ in range(rng.randint(1, 3))))
    surfaces, front = list(surfaces), max(fronts)
    projection = rng.choice([None, "orthographic", "perspective"])
    above = max(front, 0) if projection == "perspective" else front
    scene = {
        "luxel": 1,
        "screen": {"width": columns * pitch, "height": rows * pitch, "resolution": [columns, rows],
                   **_some(rng, {"sampling": lambda: rng.choice(["nodes", "centers"])})},
        "observer": {**_place(rng, above + rng.choice([1, 1500, 1e6])),
                     **({"projection": projection} if projection else {}),
                     **_some(rng, {"view": lambda: rng.choice(["parallel", "observer"])})},
        "surfaces": surfaces,
        "lights": [_light(rng) for _ in range(rng.randint(0, 4))],
        **_some(rng, {
            "units": lambda: rng.choice(["radiometric", "photometric"]),
            "shadows": lambda: rng.choice(["all", "points", "none"]),
            "maintenance_factor": lambda: rng.choice([1, 0.8, 1e-3]),
            "grids": lambda: [_grid(rng) for _ in range(rng.randint(0, 2))],
            "observers": lambda: [_observer(rng) for _ in range(rng.randint(0, 2))],
            "points": lambda: [[_number(rng), _number(rng)] for _ in range(rng.randint(0, 4))],
            "picture": lambda: _some(rng, {"range": lambda: _range(rng),
                                           "rounding": lambda: rng.choice(["truncate", "nearest"])})}),
    }
    order = list(scene)
    rng.shuffle(order)
    return {key: scene[key] for key in order}
