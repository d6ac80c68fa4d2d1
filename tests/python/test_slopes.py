# SPDX-License-Identifier: MIT
"""Derivatives by every continuous key of random scenes, against differences of the values that are made here.

Lights of all kinds, materials, shadows, moved surfaces and observers; every fourth scene may have integrals, which take
their time.  Three arguments more: how many scenes, from which one on, and in steps of how many.
"""
import json
import os
import random
import sys

import numpy

from package import Tap, luxel, run_tests

ROWS = 7
TOLERANCE = 1e-10
LAMP = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "data", "files", "office-lamp.ies"))


def extrapolate(values, errors, first):
    """Richardson's limit of central differences for halved steps, and how far it may be off."""
    rows, noises, best, spread = [], [], None, numpy.inf
    for k, (pair, error) in enumerate(zip(values, errors)):
        step = first / 2 ** k
        row, noise = [(pair[0] - pair[1]) / (2 * step)], [(error[0] + error[1]) / (2 * step)]
        for j in range(1, k + 1):
            row.append(row[j - 1] + (row[j - 1] - rows[-1][j - 1]) / (4 ** j - 1))
            noise.append((4 ** j * noise[j - 1] + noises[-1][j - 1]) / (4 ** j - 1))
            off = max(abs(row[j] - row[j - 1]), abs(row[j] - rows[-1][j - 1])) + noise[j]
            if off < spread:
                best, spread = row[j], off
        rows.append(row)
        noises.append(noise)
    return best, spread


def draw_way(draw, lean=0.7):
    return [round(draw.uniform(-lean, lean), 3), round(draw.uniform(-lean, lean), 3), -1]


def law(draw):
    return draw.choice([{}, {}, {"attenuation": "practical", "k": 300}, {"attenuation": "none"},
                        {"attenuation": "polynomial", "coefficients": [1.5, 0.7, 1.8]}])


def above(draw):
    return [round(draw.uniform(*ends), 1) for ends in ((-1200, 1200), (-1200, 1200), (1500, 3000))]


def point(draw):
    light = {"type": "point", "position": above(draw), "intensity": draw.uniform(1, 100), **law(draw)}
    if draw.random() < 0.5:
        light.update(pattern="cosine", exponent=round(draw.uniform(.5, 9), 2), axis=draw_way(draw))
    return light


def spot(draw):
    light = {"type": "spot", "position": above(draw), "inner": round(draw.uniform(5, 30), 1),
             "outer": round(draw.uniform(35, 80), 1), "exponent": draw.choice([0, 2.5]), **law(draw),
             "falloff": draw.choice(["smoothstep", "squared", "linear", "hard"]),
             draw.choice(["intensity", "power"]): draw.uniform(1, 100)}
    light.update({"aim": [draw.uniform(-300, 300), 50, 20]} if draw.random() < 0.5 else {"axis": draw_way(draw)})
    if draw.random() < 0.3:
        light["array"] = {"n": [2, 2], "spacing": [700, 500]}
    return light


def distant(draw):
    return {"type": "distant", "direction": draw_way(draw), "irradiance": draw.uniform(1, 100)}


def ambient(draw):
    return {"type": "ambient", "irradiance": draw.uniform(1, 100)}


def luminaire(draw):
    light = {"type": "luminaire", "file": LAMP, "position": above(draw), "aim": [30, 50, 20],
             "factor": draw.uniform(.5, 2)}
    if draw.random() < 0.4:
        light["opening"] = {"rectangle": {"size": [300, 200]}}
    return light


def planar(draw):
    shape = draw.choice(["rectangle", "disk", "vertices"])
    light = {"type": "planar", "radiance": draw.uniform(1, 100)}
    if shape == "rectangle":
        light[shape] = {"center": above(draw), "size": [400, 700], "axis": draw_way(draw)}
    elif shape == "disk":
        light[shape] = {"center": above(draw), "radius": 250, "axis": draw_way(draw)}
    else:
        x, y, z = above(draw)
        light[shape] = [[x, y, z], [x, y + 500, z], [x + 600, y, z]]
    return light


def volume(draw):
    shape = draw.choice(["box", "sphere", "cylinder"])
    keys = {"center": above(draw), **{"box": {"size": [300, 200, 150]}, "sphere": {"radius": 180},
                                      "cylinder": {"radius": 120, "height": 400, "axis": [1, .3, .2]}}[shape]}
    return {"type": "volume", shape: keys, "radiance": draw.uniform(1, 100)}


def sun(draw):
    return {"type": "sun", "irradiance": 800, "altitude": round(draw.uniform(20, 70), 2),
            "azimuth": round(draw.uniform(0, 359), 2), "diameter": draw.choice([0, .533, 4])}


def sky(draw):
    return {"type": "sky", "kind": draw.choice([1, 5, 12, 16]), "sun": {"altitude": 40.5, "azimuth": 200.5},
            "horizontal": 100, "ground": .2}


LIGHTS = (point, spot, distant, ambient, luminaire, planar, volume, sun, sky)
QUICK = (point, spot, distant, ambient)


def material(draw, rough):
    made = {"model": draw.choice(["blinn-phong", "phong", "lambert"] + (["ggx"] if rough else [])),
            "diffuse": round(draw.uniform(.1, .9), 3)}
    if rough and draw.random() < 0.5:
        made.update(draw.choice([{"diffuse_model": "oren-nayar", "sigma": 25.5},
                                 {"diffuse_model": "eon", "roughness": .45}]))
    if made["model"] in ("blinn-phong", "phong"):
        made.update(shininess=round(draw.uniform(1, 60), 2), highlight=draw.choice(["plain", "gated", "cosine"]),
                    normalized=draw.random() < 0.3)
    if made["model"] == "ggx":
        made.update(alpha=.35, f0=.06)
    if made["model"] != "lambert":
        made["specular"] = round(draw.uniform(.1, .9), 3)
    if draw.random() < 0.3:
        made["ambient"] = round(draw.uniform(.1, .9), 3)
    return made


def surfaces(draw, rough):
    lit = draw.choice([
        {"type": "sphere", "center": [20, -30, 100.5], "radius": 420.5},
        {"type": "rectangle", "center": [10, 20, 5], "size": [1900, 1800], "axis": [.1, -.2, 1]},
        {"type": "disk", "center": [10, 20, 5], "radius": 950, "axis": [.1, .2, 1]},
        {"type": "box", "center": [10, 20, 5], "size": [700, 600, 500], "rotate": [20, 30, 10]},
        {"type": "cylinder", "center": [10, 20, 100], "radius": 310.5, "height": 1100, "axis": [.1, 1, .2]}])
    beside = draw.choice([None, {"type": "sphere", "center": [700, 200, 900], "radius": 250},
                          {"type": "rectangle", "center": [500, -300, 1000], "size": [500, 700], "axis": [.2, .3, 1]}])
    return [{**lit, "material": material(draw, rough)}] + (
        [{**beside, "material": material(draw, rough)}] if beside else [])


def observer(draw):
    return draw.choice([
        {"z": 9000}, {"z": 9000, "view": "observer"}, {"z": 9000, "projection": "perspective"},
        {"position": [2500, 1200, 8000], "target": [30, 20, 50], "projection": draw.choice(["perspective",
                                                                                            "orthographic"])}])


def make(seed):
    draw = random.Random(seed)
    is_quick = seed % 4 != 0
    lights = [kind(draw) for kind in draw.choices(QUICK if is_quick else LIGHTS, k=draw.randint(1, 2))]
    if draw.random() < 0.3 and all(light["type"] not in ("sun", "sky") for light in lights):
        lights[0]["group"] = "a"
    scene = {"luxel": 1, "screen": {"width": 1000, "height": 1000, "resolution": [10, 10]}, "observer": observer(draw),
             "surfaces": surfaces(draw, not is_quick and draw.random() < 0.4), "lights": lights}
    if "group" in lights[0]:
        scene["dimming"] = [{"name": "a", "factor": .6}]
    points = [[draw.uniform(-330, 330), draw.uniform(-330, 330)] for _ in range(6)]
    if draw.random() < 0.4:
        places = numpy.array([[draw.uniform(-800, 800), draw.uniform(-800, 800), -600] for _ in points])
        normals = numpy.array([[draw.uniform(-.4, .4), draw.uniform(-.4, .4), 1] for _ in points])
        return scene, {"elements": (places, normals)}, draw
    return scene, {"points": points}, draw


def keys_of(value, path=""):
    """All keys that take numbers, each number by itself."""
    if isinstance(value, dict):
        return [key for name, part in value.items() for key in keys_of(part, "%s.%s" % (path, name) if path else name)]
    if isinstance(value, list):
        return [key for i, part in enumerate(value) for key in keys_of(part, "%s[%d]" % (path, i))]
    return [path] if isinstance(value, (int, float)) and not isinstance(value, bool) else []


NOT_FREE = ("luxel", "screen", "kind", "array.n")


def values_of(scene, seen, quantity):
    if "elements" in seen:
        found = scene.evaluate(*seen["elements"], quantity=quantity, tolerance=TOLERANCE, threads=1)
        return found["value"], found["error"]
    found = scene.probe(seen["points"], quantity=quantity, tolerance=TOLERANCE, skip_reflected_pixels=True, threads=1)
    return (numpy.array([probe.value if probe.value is not None else numpy.nan for probe in found]),
            numpy.array([probe.error if probe.error is not None else numpy.nan for probe in found]))


def truths(scene, key, seen, quantity):
    """Derivatives by differences here, with how far they may be off; NaN where they do not settle."""
    at = scene[key]
    first = 2.0 ** round(numpy.log2(max(abs(at), 1) * (2e-3 if "position" in key else 4e-3)))
    rows, errors = [], []
    for k in range(ROWS):
        pair, error = [], []
        for sign in (1, -1):
            changed = scene.copy()
            changed[key] = at + sign * first / 2 ** k
            value, bound = values_of(changed, seen, quantity)
            pair.append(value)
            error.append(bound)
        rows.append(pair)
        errors.append(error)
    found = [extrapolate([(pair[0][i], pair[1][i]) for pair in rows], [(error[0][i], error[1][i]) for error in errors],
                         first) for i in range(len(rows[0][0]))]
    return numpy.array([one[0] if one[0] is not None else numpy.nan for one in found]), \
        numpy.array([one[1] for one in found]), first


def check(tap, seed, counts):
    scene_keys, seen, draw = make(seed)
    scene = luxel.Scene(json.dumps(scene_keys))
    quantity = draw.choice(["irradiance", "brightness"])
    keys = [key for key in keys_of(scene_keys) if not any(word in key for word in NOT_FREE) and
            not key.startswith("luxel")]
    keys = draw.sample(keys, min(len(keys), 9))
    found = scene.jacobian(keys, full=True, quantity=quantity, tolerance=TOLERANCE, threads=1, **seen)
    for k, key in enumerate(keys):
        try:
            truth, off, first = truths(scene, key, seen, quantity)
        except luxel.LuxelError:
            continue  # a step that is not legal
        size = numpy.nanmax(numpy.abs(found.values)) / first
        for i in range(len(truth)):
            is_smooth = off[i] < 1e-5 * abs(truth[i]) + 1e-8 * size
            if not is_smooth or numpy.isnan(found.values[i]):
                continue
            counts["smooth"] += 1
            if found.states[i, k] > 1:
                counts["missing"] += 1
                continue
            counts["exact"] += found.errors[i, k] < 1e-11 * size
            wrong = abs(found.derivatives[i, k] - truth[i]) - found.errors[i, k] - 3 * off[i]
            if not wrong <= 1e-15 * size:
                counts["wrong"] += 1
                tap.ok(False, "scene %d, %s, place %d" % (seed, key, i), quantity, found.derivatives[i, k],
                       found.errors[i, k], truth[i], off[i], json.dumps(scene_keys), seen)


def campaign(tap, tool):
    count, first, step = (int(word) for word in (sys.argv[3:6] if len(sys.argv) > 5 else ("24", "1", "1")))
    counts = {"smooth": 0, "missing": 0, "exact": 0, "wrong": 0}
    for seed in range(first, first + count * step, step):
        check(tap, seed, counts)
    print("# %d scenes: %s" % (count, json.dumps({name: int(number) for name, number in counts.items()})))
    tap.ok(counts["wrong"] == 0, "within their errors", counts)
    tap.ok(counts["smooth"] > 15 * count and counts["missing"] <= 0.02 * counts["smooth"],
           "and there where values are smooth", counts)


if __name__ == "__main__":
    run_tests(Tap(), campaign)
