# SPDX-License-Identifier: MIT
"""Random good scenes that use every key of the parameter table sooner or later, the same for the same seed."""


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


def _placed(rng):
    position = [_number(rng) for _ in range(3)]
    light = {"position": position, "intensity": _from_zero(rng)}
    law = rng.choice([None, "none", "inverse-square", "practical"])
    if law:
        light["attenuation"] = law
    if law == "practical" or rng.random() < 0.2:
        light["k"] = _above(rng)
    way = rng.choice([None, "axis", "aim"])
    if way:
        light[way] = _vector(rng) if way == "axis" else [position[0] + 1, position[1], position[2]]
    return light


def _point(rng):
    light = {"type": "point", **_placed(rng)}
    pattern = rng.choice([None, "isotropic", "lambertian", "cosine"])
    if pattern:
        light["pattern"] = pattern
    if pattern == "cosine" or rng.random() < 0.2:
        light["exponent"] = _from_zero(rng)
    return light


def _spot(rng):
    outer = rng.choice([0, 30, 90, rng.uniform(0, 90)])
    inner = rng.choice([0, outer, rng.uniform(0, outer)])
    return {"type": "spot", **_placed(rng), "inner": inner, "outer": outer, **_some(rng, {
        "falloff": lambda: rng.choice(["smoothstep", "squared", "linear", "hard"]),
        "exponent": lambda: _from_zero(rng)})}


def _light(rng):
    kind = rng.choice(["point", "point", "spot", "spot", "distant", "ambient"])
    if kind == "point":
        light = _point(rng)
    elif kind == "spot":
        light = _spot(rng)
    elif kind == "distant":
        light = {"type": kind, "direction": _vector(rng), "irradiance": _from_zero(rng)}
    else:
        light = {"type": kind, "irradiance": _from_zero(rng)}
    return {**light, **_some(rng, {"name": lambda: _name(rng), "enabled": lambda: rng.random() < 0.7})}


def _material(rng):
    return _some(rng, {
        "model": lambda: rng.choice(["blinn-phong", "phong", "lambert"]),
        "diffuse": lambda: _from_zero(rng), "specular": lambda: _from_zero(rng), "shininess": lambda: _above(rng),
        "ambient": lambda: _from_zero(rng), "over_pi": lambda: rng.random() < 0.5,
        "highlight": lambda: rng.choice(["plain", "gated", "cosine"]), "normalized": lambda: rng.random() < 0.5})


def _range(rng):
    low = _number(rng)
    return rng.choice(["max", "minmax", "log", [low, low + rng.choice([1e-9, 1, 100]) * max(1, abs(low))]])


def good_scene(rng):
    """A scene as a mapping that both the tool and the schema must accept."""
    columns, rows = rng.choice([(1, 1), (360, 360), (500, 400), (65536, 1), (7, 131)])
    pitch = rng.choice([1, 0.5, 1e-3, 1e3])
    surfaces = [{"type": "sphere", "center": [_number(rng) for _ in range(3)], "radius": rng.uniform(1e-3, 1000),
                 **_some(rng, {"name": lambda: _name(rng), "material": lambda: _material(rng)})}
                for _ in range(rng.randint(1, 3))]
    front = max(surface["center"][2] + surface["radius"] for surface in surfaces)
    projection = rng.choice([None, "orthographic", "perspective"])
    above = max(front, 0) if projection == "perspective" else front
    scene = {
        "luxel": 1,
        "screen": {"width": columns * pitch, "height": rows * pitch, "resolution": [columns, rows],
                   **_some(rng, {"sampling": lambda: rng.choice(["nodes", "centers"])})},
        "observer": {"z": above + rng.choice([1, 1500, 1e6]), **({"projection": projection} if projection else {}),
                     **_some(rng, {"view": lambda: rng.choice(["parallel", "observer"])})},
        "surfaces": surfaces,
        "lights": [_light(rng) for _ in range(rng.randint(0, 4))],
        **_some(rng, {
            "units": lambda: rng.choice(["radiometric", "photometric"]),
            "shadows": lambda: rng.choice(["points", "none"]),
            "points": lambda: [[_number(rng), _number(rng)] for _ in range(rng.randint(0, 4))],
            "picture": lambda: _some(rng, {"range": lambda: _range(rng),
                                           "rounding": lambda: rng.choice(["truncate", "nearest"])})}),
    }
    order = list(scene)
    rng.shuffle(order)
    return {key: scene[key] for key in order}
