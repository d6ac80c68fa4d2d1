# SPDX-License-Identifier: MIT
"""Luminous openings of luminaires: against closed forms of Lambertian sources, and against sums over many points."""
import json
import math
import os
import random
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "unit"))

from tap import Tap
from tool import run_tests

HEAD = "IESNA:LM-63-2002\n[TEST] own\n[TESTLAB] own\n[ISSUEDATE] now\n[MANUFAC] own\nTILT=NONE\n"
MATT = {"model": "lambert", "diffuse": 1}
SCENE = {"luxel": 1, "shadows": "none", "screen": {"width": 4000, "height": 4000, "resolution": [40, 40]},
         "observer": {"z": 9000},
         "surfaces": [{"type": "rectangle", "center": [0, 0, 0], "size": [4000, 4000], "material": MATT}]}


def lamp_text(angles, planes, intensity, opening="0 0 0"):
    rows = [[intensity(plane, angle) for angle in angles] for plane in planes]
    return HEAD + "1 -1 1 %d %d 1 2 %s\n1 1 20\n%s\n%s\n%s\n" % (
        len(angles), len(planes), opening, " ".join(map(repr, angles)), " ".join(map(repr, planes)),
        "\n".join(" ".join(map(repr, row)) for row in rows))


def lambert(opening="0 0 0"):
    """Exact by the cosine: 1000 cd downwards, nothing upwards."""
    return lamp_text([0.0, 90.0], [0.0], lambda plane, angle: 1000.0 if angle == 0 else 0.0, opening)


def wings(plane, angle):
    c, g = math.radians(plane), math.radians(angle)
    return 900 * (0.3 + math.cos(g / 2) ** 2) * (1 + math.sin(g) ** 2 * (0.5 * math.cos(2 * c) + 0.25 * math.sin(c)))


ANGLES, PLANES = [7.5 * i for i in range(25)], [15.0 * i for i in range(25)]
WINGS = lamp_text(ANGLES, PLANES, wings)
TABLE = np.array([[wings(plane, angle) for angle in ANGLES] for plane in PLANES])


def table_at(towards, axis, c0):
    """The table towards unit ways from the lamp, linear in both angles, by the words of the specification."""
    across = np.cross(c0, axis)
    polar = np.degrees(np.arccos(np.clip(towards @ axis, -1, 1))) / 7.5
    azimuth = np.degrees(np.arctan2(towards @ across, towards @ c0)) % 360 / 15
    i, j = np.minimum(azimuth.astype(int), 23), np.minimum(polar.astype(int), 23)
    u, v = azimuth - i, polar - j
    return ((1 - u) * ((1 - v) * TABLE[i, j] + v * TABLE[i, j + 1]) +
            u * ((1 - v) * TABLE[i + 1, j] + v * TABLE[i + 1, j + 1]))


def unit(vector):
    return np.asarray(vector, float) / np.linalg.norm(vector)


def grid_rule(count):
    """Gauss's rule with three places on each of so many parts of 0 to 1."""
    places, weights = np.polynomial.legendre.leggauss(3)
    return ((np.arange(count)[:, None] + (places + 1) / 2) / count).ravel(), np.tile(weights / 2 / count, count)


def points_of(shape, frame, center, count=160):
    """Places over an opening and their shares of its area; the frame is c0, across, axis."""
    kind, keys = next(iter(shape.items()))
    s, w = grid_rule(count)
    u, v = (a.ravel() for a in np.meshgrid(s, s))
    weight = np.outer(w, w).ravel()
    if kind == "rectangle":
        local = np.stack([(u - 0.5) * keys["size"][0], (v - 0.5) * keys["size"][1], 0 * u], 1)
    elif kind == "disk":
        radius = keys["radius"] * np.sqrt(u)
        local = np.stack([radius * np.cos(2 * np.pi * v), radius * np.sin(2 * np.pi * v), 0 * u], 1)
    elif kind == "sphere":
        z, flat = 2 * u - 1, np.sqrt(1 - (2 * u - 1) ** 2)
        local = keys["radius"] * np.stack([flat * np.cos(2 * np.pi * v), flat * np.sin(2 * np.pi * v), z], 1)
    elif kind == "cylinder":
        radius, height = keys["radius"], keys["height"]
        side = np.stack([radius * np.cos(2 * np.pi * v), radius * np.sin(2 * np.pi * v), (u - 0.5) * height], 1)
        ring = radius * np.sqrt(u)
        ends = [np.stack([ring * np.cos(2 * np.pi * v), ring * np.sin(2 * np.pi * v), 0 * u + sign * height / 2], 1)
                for sign in (-1, 1)]
        parts = [(2 * np.pi * radius * height, side)] + [(np.pi * radius ** 2, end) for end in ends]
    elif kind in ("ellipse", "elliptic cylinder"):
        a, b, turned = keys["along"], keys["across"], 2 * np.pi * v
        rim = np.stack([a * np.cos(turned), b * np.sin(turned), 0 * u], 1)
        local = np.sqrt(u)[:, None] * rim
        if kind == "elliptic cylinder":
            up = np.array([0, 0, keys["height"]])
            side = 2 * np.pi * keys["height"] * np.hypot(a * np.sin(turned), b * np.cos(turned))
            parts = [(side, rim + (u - 0.5)[:, None] * up)] + [(np.pi * a * b, local + s * up) for s in (-0.5, 0.5)]
    elif kind == "ellipsoid":
        z, flat, radii = 2 * u - 1, np.sqrt(1 - (2 * u - 1) ** 2), np.array(keys["radii"])
        sphere = np.stack([flat * np.cos(2 * np.pi * v), flat * np.sin(2 * np.pi * v), z], 1)
        local = radii * sphere
        weight = weight * np.linalg.norm(sphere / radii, axis=1)
        weight /= weight.sum()
    if kind == "box":
        size = keys["size"]
        parts = []
        for way in range(3):
            a, b = [k for k in range(3) if k != way]
            for sign in (-0.5, 0.5):
                face = np.zeros((len(u), 3))
                face[:, a], face[:, b], face[:, way] = (u - 0.5) * size[a], (v - 0.5) * size[b], sign * size[way]
                parts.append((size[a] * size[b], face))
    if kind in ("box", "cylinder", "elliptic cylinder"):
        local = np.concatenate([part for _, part in parts])
        weight = np.concatenate([area * weight for area, _ in parts])
        weight /= weight.sum()
    return center + local @ frame, weight


def shining(places, weights, place, normal, view, material, axis, c0):
    """Irradiance and highlight at an element, summed over the places."""
    way = places - place
    r = np.linalg.norm(way, axis=1)
    way /= r[:, None]
    e = weights * table_at(-way, axis, c0) / (r / 1000) ** 2
    half = way + view
    half /= np.linalg.norm(half, axis=1)[:, None]
    lobe = material["specular"] * np.maximum(half @ normal, 0) ** material["shininess"]
    return e @ np.maximum(way @ normal, 0), e @ lobe


def scene(tool, name, *lights, **others):
    tool.write(name, json.dumps({**SCENE, **others, "lights": list(lights)}))
    return name


def probe(tool, name, elements, *words):
    tool.write("places.csv", "x,y,z,nx,ny,nz\n" + "".join(
        ",".join("%.17g" % x for x in list(place) + list(normal)) + "\n" for place, normal in elements))
    return tool.run("probe", name, "--points", "places.csv", "--json", *words).json()["points"]


def value_at(tool, name, at, *words):
    return tool.run("probe", name, "-p", at, "--json", *words).json()["points"][0]["value"]


def panel_below(tap, tool):
    """The panel of 0.6 m by 0.6 m with 1000 lm: values of the closed form."""
    tool.write("l.ies", lambert("0.6 0.6 0"))
    for z, lux in ((300, 1539.24006660992), (600, 665.156862391038), (1000, 284.366081147748),
                   (2000, 77.2629448818329), (3000, 34.9027013714797)):
        for opening in "file", {"rectangle": {"size": [600, 600]}}:
            name = scene(tool, "s.yaml", {"type": "luminaire", "file": "l.ies", "position": [0, 0, z],
                                          "flux": 1000, "interpolation": "cosine", "opening": opening})
            point = tool.run("probe", name, "-p", "0,0", "--json").json()["points"][0]
            tap.ok(abs(point["value"] - lux) <= point["error"] + 1e-12 * lux and point["error"] < 1e-9 * lux,
                   "%d mm below the panel, %s" % (z, "file" if opening == "file" else "size"), point["value"], lux,
                   point["error"])
            tap.near(point["lights"][0]["flux"], 1000, 1e-12, "its flux")


def as_planar(tap, tool):
    """A Lambertian table makes the planar source, tilted, in shadows, with highlights, and in pictures."""
    tool.write("l.ies", lambert())
    balls = [{"type": "sphere", "center": [150, 60, 700], "radius": 160, "material": {"shininess": 40}},
             {"type": "sphere", "center": [-500, -300, 300], "radius": 250, "material": {"shininess": 12}}]
    floor = {**SCENE["surfaces"][0], "material": {"shininess": 30, "specular": 0.4}}
    for shape, planar in (
            ({"rectangle": {"size": [500, 300]}}, {"rectangle": {"size": [500, 300], "up": [-0.25, 1, 0.25]}}),
            ({"disk": {"radius": 220}}, {"disk": {"radius": 220}})):
        key = next(iter(planar))
        planar[key].update(center=[100, 50, 1500], axis=[0.25, 0.3, -0.95])
        for law in ({"attenuation": "inverse-square"},) if key == "disk" else ({"attenuation": "practical", "k": 300},):
            values, pictures = [], []
            # up is along C = 90, so that w runs along C = 0
            axis = [0.25, 0.3, -0.95]
            lamp = {"type": "luminaire", "file": "l.ies", "position": [100, 50, 1500], "axis": axis, "opening": shape,
                    "c0": np.cross(axis, [-0.25, 1, 0.25]).tolist(), "interpolation": "cosine", **law}
            for light in lamp, {"type": "planar", "intensity": 1000, **planar, **law}:
                name = scene(tool, "p.yaml", light, surfaces=[floor] + balls, shadows="all")
                ways = [word for i in range(8) for word in ("-p", "%d,%d" % (80 * i - 300, 70 * i - 250))]
                values.append(tool.run("probe", name, *ways, "--json").json()["points"])
                tool.run("render", name, "-q", "-o", "p.npy", "--tolerance", "1e-4")
                pictures.append(np.load(tool.file("p.npy")))
            bad = ["%r: %r, not %r; errors %r, %r" % (a["screen"], a["value"], b["value"], a["error"], b["error"])
                   for a, b in zip(*values)
                   if not abs(a["value"] - b["value"]) <= a["error"] + b["error"] or a["error"] > 2e-9 * a["value"]]
            tap.ok(not bad, "as the planar %s by the law %s" % (key, law["attenuation"]), *bad)
            worst = np.abs(pictures[0] - pictures[1]).max() / pictures[1].max()
            tap.ok(worst < 2e-4, "and in a picture", worst)


def random_elements(tap, tool):
    """Every shape with a table that is like nothing else, around it and in its plane, against sums over its points."""
    rng = random.Random(20261127)
    material = {"diffuse": 1, "specular": 0.5, "shininess": 25}
    floor = {**SCENE["surfaces"][0], "material": material}
    for shape in ({"rectangle": {"size": [600, 250]}}, {"disk": {"radius": 240}}, {"box": {"size": [400, 250, 150]}},
                  {"sphere": {"radius": 200}}, {"cylinder": {"radius": 120, "height": 500}},
                  {"ellipse": {"along": 250, "across": 140, "file": "-0.28 -0.5 0"}},
                  {"elliptic cylinder": {"along": 180, "across": 60, "height": 400, "file": "-0.12 -0.36 0.4"}},
                  {"ellipsoid": {"radii": [250, 140, 60], "file": "-0.28 -0.5 -0.12"}},
                  {"ellipsoid": {"radii": [60, 120, 260], "file": "-0.24 -0.12 -0.52"}}):
        kind = next(iter(shape))
        in_file = shape[kind].get("file")  # of what only files can declare
        tool.write("w.ies", lamp_text(ANGLES, PLANES, wings, in_file or "0 0 0"))
        axis, center = unit([rng.gauss(0, 1) for _ in range(3)]), np.array([100.0, 200.0, 3000.0])
        c0 = unit(np.cross(axis, [rng.gauss(0, 1) for _ in range(3)]))
        frame = np.stack([c0, np.cross(c0, axis), axis])
        name = scene(tool, "r.yaml", {
            "type": "luminaire", "file": "w.ies", "position": center.tolist(), "axis": axis.tolist(), "c0": c0.tolist(),
            "opening": "file" if in_file else shape}, surfaces=[floor])
        elements = []
        for i in range(4):
            way = unit([rng.gauss(0, 1) for _ in range(3)])
            if i == 0 and kind not in ("sphere", "ellipsoid"):  # in the plane of the opening's middle
                way = unit(frame[0] * 0.8 + frame[1] * 0.6)
            distance = rng.uniform(450, 1200)
            elements.append((center + distance * way, unit(-way + [rng.uniform(-0.7, 0.7) for _ in range(3)])))
        told = probe(tool, name, elements, "--tolerance", "1e-6")
        places, weights = points_of(shape, frame, center)
        bad = []
        for (place, normal), point in zip(elements, told):
            irradiance, highlight = shining(places, weights, place, normal, np.array([0, 0, 1.0]), material, axis, c0)
            share = point["lights"][0]
            if not (abs(share["irradiance"] - irradiance) <= 4e-6 * irradiance and
                    abs(share["specular"] - highlight) <= 4e-6 * (highlight + irradiance) and
                    0 < point["error"] <= 1e-6 * point["value"]):
                bad.append("%r: %r %r, not %r %r; error %r of %r" % (
                    place.tolist(), share["irradiance"], share["specular"], irradiance, highlight, point["error"],
                    point["value"]))
        tap.ok(not bad, "elements around the %s" % kind, *bad)


def openings_of_files(tap, tool):
    """The file's opening is the shape that it declares."""
    for opening, shape in (
            ("0.3 0.5 0", {"rectangle": {"size": [500, 300]}}), ("0.3 0.5 0.1", {"box": {"size": [500, 300, 100]}}),
            ("-0.3 -0.3 0", {"disk": {"radius": 150}}), ("-0.3 -0.3 -0.3", {"sphere": {"radius": 150}}),
            ("-0.3 -0.3 0.2", {"cylinder": {"radius": 150, "height": 200}}),
            ("-0.1 0.6 -0.1", {"cylinder": {"radius": 50, "height": 600, "axis": [0, 1, 0]}}),
            ("0 -0.2 -0.2", {"disk": {"radius": 100, "axis": [1, 0, 0]}}), ("0 0 0", "point")):
        tool.write("o.ies", lamp_text(ANGLES, PLANES, wings, opening))
        light = {"type": "luminaire", "file": "o.ies", "position": [0, 0, 900], "c0": [0, 1, 0]}
        values = [value_at(tool, scene(tool, "o.yaml", {**light, "opening": how}), "200,100", "--tolerance", "1e-7")
                  for how in ("file", shape)]
        tap.ok(values[0] > 0 and values[0] == values[1], "width, length, height %s" % opening, *values)


def openings_not_round(tap, tool):
    """Ellipses and bodies over them: nearly round ones, small ones, and one body along each of the directions."""
    even = {"type": "luminaire", "file": "o.ies", "position": [0, 0, 900], "c0": [0, 1, 0], "opening": "file"}

    def told(opening, **others):
        tool.write("o.ies", lamp_text(ANGLES, PLANES, wings, opening))
        name = scene(tool, "o.yaml", {**even, **others})
        return tool.run("probe", name, "-p", "200,100", "-p", "-20,10", "--json", "--tolerance",
                        "1e-8").json()["points"]

    for form in "-0.3 -0.3{} 0", "-0.3 -0.3{} 0.2", "-0.3 -0.3{} -0.3", "-0.3{} 0.6 -0.3", "0 -0.3{} -0.3":
        pairs = list(zip(told(form.format("")), told(form.format("000000001"))))
        tap.ok(all(abs(a["value"] - b["value"]) <= a["error"] + b["error"] + 1e-7 * a["value"] for a, b in pairs),
               "nearly round: " + form, *[(a["value"], b["value"], a["error"]) for a, b in pairs])
    for opening in "-0.0002 -0.0001 0", "-0.0002 -0.0001 0.0003", "-0.0001 -0.0002 -0.0003":
        pairs = list(zip(told(opening), told("0 0 0")))
        tap.ok(all(abs(a["value"] - b["value"]) <= 1e-6 * b["value"] for a, b in pairs), "tiny: " + opening,
               *[(a["value"], b["value"]) for a, b in pairs])
    values = []
    for opening, axis, c0 in (("-0.2 -0.3 0.5", [0, 0, -1], [1, 0, 0]), ("-0.2 0.5 -0.3", [1, 0, 0], [0, 0, 1]),
                              ("0.5 -0.2 -0.3", [1, 0, 0], [0, 1, 0])):
        tool.write("o.ies", lamp_text([0.0, 180.0], [0.0], lambda plane, angle: 500.0, opening))
        name = scene(tool, "o.yaml", {**even, "axis": axis, "c0": c0})
        values.append(value_at(tool, name, "200,100", "--tolerance", "1e-10"))
    tap.ok(max(values) - min(values) < 1e-9 * values[0], "one cylinder along each direction", values)
    tool.write("o.ies", lambert("-0.3 -0.5 0"))
    name = scene(tool, "o.yaml", {**even, "interpolation": "cosine", "position": [0, 0, 400]})
    outline = [[150 * math.sin(math.pi * i / 720), 250 * math.cos(math.pi * i / 720), 400] for i in range(1440)]
    other = scene(tool, "q.yaml", {"type": "planar", "intensity": 1000, "vertices": outline})
    a, b = value_at(tool, name, "100,50"), value_at(tool, other, "100,50")
    tap.ok(abs(a - b) < 1e-5 * b, "a Lambertian ellipse and a polygon of 1440 corners", a, b)


def pictures_not_round(tap, tool):
    """Pictures of ellipses and bodies over them, with a ball in the way, show what probes tell."""
    ball = {"type": "sphere", "center": [200, 100, 500], "radius": 200, "material": MATT}
    screen = {**SCENE["screen"], "width": 2000, "height": 2000, "resolution": [6, 6]}
    for opening in "-0.2 -0.5 0", "-0.2 -0.5 0.3", "-0.2 -0.5 -0.3":
        tool.write("w.ies", lamp_text(ANGLES, PLANES, wings, opening))
        name = scene(tool, "e.yaml", {"type": "luminaire", "file": "w.ies", "position": [-300, 100, 1100],
                                      "aim": [0, 0, 0], "c0": [1, 2, 0], "opening": "file"},
                     surfaces=SCENE["surfaces"] + [ball], shadows="all", screen=screen)
        tool.run("render", name, "-q", "-o", "e.npy")
        picture = np.load(tool.file("e.npy"))
        places = [(x, y) for x in range(0, 6, 2) for y in range(1, 6, 2)]
        at = [(-1000 + 1000 / 3 * (x + 0.5), 1000 - 1000 / 3 * (y + 0.5)) for x, y in places]
        ways = [word for place in at for word in ("-p", "%r,%r" % place)]
        told = tool.run("probe", name, *ways, "--json", "--tolerance", "1e-7").json()["points"]
        worst = max(abs(picture[y, x] - point["value"]) for (x, y), point in zip(places, told)) / picture.max()
        tap.ok(worst < 2e-6 and picture.min() >= 0, "a picture under the opening %s" % opening, worst)


RINGS = [62.0, 48.0, 17.0, 35.0, 29.0, 48.0, 33.0, 17.0, 11.0, 0.0]  # every 10 degrees from the axis
RINGED = lamp_text([10.0 * i for i in range(10)], [0.0], lambda plane, angle: RINGS[round(angle / 10)])


def lines_of_tables(tap, tool):
    """A table's lines make kinks across the arcs of a body, which its bounds know of."""
    tool.write("rings.ies", RINGED)
    for opening, tolerance, element in (
            ({"box": {"size": [260, 240, 280]}}, "1e-4", [-241, -271, 1473, 0.05, 0.08, 1.93]),
            ({"sphere": {"radius": 150}}, "1e-6", [-690, 666, 1563, 0.08, -1.87, 0.65]),
            ({"cylinder": {"radius": 120, "height": 300}}, "1e-6", [-335, 1113, 436, 0.56, -1.51, 0.21])):
        place, normal, center = np.array(element[:3]), unit(element[3:]), np.array([0, 0, 1500])
        name = scene(tool, "k.yaml", {"type": "luminaire", "file": "rings.ies", "position": [0, 0, 1500],
                                      "opening": opening})
        told = probe(tool, name, [(place, normal)], "--quantity", "irradiance", "--tolerance", tolerance)[0]
        places, weights = points_of(opening, np.array([[1, 0, 0], [0, 1, 0], [0, 0, -1]]), center, 400)
        way = places - place
        r = np.linalg.norm(way, axis=1)
        angles = np.degrees(np.arccos(way[:, 2] / r))  # from the axis, which goes down
        truth = (weights / (r / 1000) ** 2 * np.interp(angles, range(0, 100, 10), RINGS, right=0)) @ np.maximum(
            way @ normal / r, 0)
        tap.ok(abs(told["value"] - truth) <= told["error"] + 1e-7 * truth, "lines of a table: %s" % opening,
               told["value"], told["error"], truth)


def pictures_across(tap, tool):
    """Pictures in float32 beside a box whose light ends at a right angle to its axis, which its sides cross."""
    tool.write("rings.ies", RINGED)
    screen = {**SCENE["screen"], "resolution": [20, 20]}
    name = scene(tool, "a.yaml", {"type": "luminaire", "file": "rings.ies", "position": [100, 50, 433.3],
                                  "axis": [0.3, -1, 0], "opening": {"box": {"size": [260, 240, 280]}}}, screen=screen)
    pictures = []
    for precision in "single", "double":
        tool.run("render", name, "-q", "--precision", precision, "-o", "a.npy")
        pictures.append(np.load(tool.file("a.npy")).astype(float))
    worst = abs(pictures[0] - pictures[1]).max() / pictures[1].max()
    tap.ok(worst < 2e-6, "a picture across a box's sides", worst)
    told = value_at(tool, name, "100,100", "--tolerance", "1e-9")
    tap.near(pictures[0][9, 10], told, 0, "a pixel there is what a probe tells", 2e-6 * pictures[1].max())


def hidden_bodies(tap, tool):
    """What plates hide of bodies, they hide as meshes as well."""
    tool.write("plate.off", "OFF\n8 12 0\n%s\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n%s" % (
        "\n".join("%r %r %r" % (x, y, z) for z in (699.9999, 700.0001)
                  for x, y in ((-150, -100), (150, -100), (150, 300), (-150, 300))),
        "".join("3 %d %d %d\n3 %d %d %d\n" % (i, j, j + 4, i, j + 4, i + 4)
                for i, j in ((0, 1), (1, 2), (2, 3), (3, 0)))))
    plates = [{"type": "mesh", "file": "plate.off", "material": MATT},
              {"type": "rectangle", "center": [0, 100, 700], "size": [300, 400], "material": MATT}]
    ways = [word for p in ("0,0", "250,-100", "30,-300", "-450,450") for word in ("-p", p)]
    # 250 is in the plane of an end of some
    for opening, shape in (("0 0 0", {"cylinder": {"radius": 100, "height": 500, "axis": [1, 0, 0]}}),
                           ("0 0 0", {"cylinder": {"radius": 120, "height": 500, "axis": [1, 0.2, 0]}}),
                           ("-0.2 0.5 -0.1", "file"), ("0.5 -0.2 -0.1", "file"), ("-0.1 -0.3 -0.5", "file"),
                           ("-0.2 -0.4 0", "file")):
        tool.write("w.ies", lamp_text(ANGLES, PLANES, wings, opening))
        lamp = {"type": "luminaire", "file": "w.ies", "position": [0, 0, 1500], "opening": shape}
        told = []
        for plate in plates:
            name = scene(tool, "h.yaml", lamp, surfaces=SCENE["surfaces"] + [plate], shadows="all")
            told.append(tool.run("probe", name, *ways, "--json", "--tolerance", "1e-4").json()["points"])
        bad = [(a["value"], b["value"], a["error"], b["error"]) for a, b in zip(*told)
               if not abs(a["value"] - b["value"]) <= a["error"] + b["error"] + 1e-6 * b["value"]]
        tap.ok(not bad and told[1][1]["value"] > 0, "half hidden: %s %s" % (opening, json.dumps(shape)), *bad)


def wrong_openings(tap, tool):
    tool.write("l.ies", lambert("0.6 0.6 0"))
    light = {"type": "luminaire", "file": "l.ies", "position": [0, 0, 2500]}
    for opening, words in (("files", ("point, file or a mapping", 'did you mean "file"')), (5, ("or a mapping", "5")),
                           ({}, ("rectangle", "disk", "box")), ([], ("or a mapping",)),
                           ({"rectangle": {"size": [600, 600]}, "disk": {"radius": 5}}, ("rectangle", "disk")),
                           ({"rectangle": {"size": [600, 0]}}, ("size", "> 0")),
                           ({"rectangle": {}}, ("size", "missing")), ({"disk": {"radius": -1}}, ("radius",)),
                           ({"ring": {"radius": 1}}, ("ring",)), ({"box": {"size": [1, 2]}}, ("3 numbers",))):
        result = tool.run("probe", scene(tool, "w.yaml", {**light, "opening": opening}))
        tap.ok(result.code == 3 and all(word in result.err for word in words) and "w.yaml:1:" in result.err,
               "opening: %s" % json.dumps(opening), result.err)
    name = scene(tool, "n.yaml", {**light, "position": [0, 0, 900]})
    tap.ok("opening: file" in tool.run("check", name).out, "check names the key")
    tap.ok("five times" not in tool.run("check", name, "-s", "lights[0].opening=file").out, "and is content with it")
    told = [value_at(tool, name, "0,0", "-s", "lights[0].opening" + words)
            for words in ("=file", "={rectangle: {size: [600, 600]}}", ".rectangle={size: [600, 600]}")]
    tap.ok(told[0] == told[1] == told[2], "set from the command line", told)
    tool.write("p.ies", lambert())
    result = tool.run("check", scene(tool, "p.yaml", {**light, "file": "p.ies", "opening": "file"}))
    tap.ok("declares no luminous opening" in result.out, "a file without an opening", result.out)


def pictures_and_grids(tap, tool):
    """Pictures show what probes tell, in either precision and for any number of threads; and so do grids."""
    tool.write("w.ies", WINGS)
    ball = {"type": "sphere", "center": [300, 100, 500], "radius": 200, "material": MATT}
    lights = [{"type": "luminaire", "file": "w.ies", "position": [-300, 100, 900], "aim": [0, 0, 0], "c0": [1, 2, 0],
               "opening": {"rectangle": {"size": [600, 200]}}},
              {"type": "luminaire", "file": "w.ies", "position": [600, -400, 1200],
               "opening": {"disk": {"radius": 150}}}]
    grids = [{"name": "floor", "center": [0, 0, 0], "size": [2000, 2000], "n": [3, 3]}]
    name = scene(tool, "g.yaml", *lights, surfaces=SCENE["surfaces"] + [ball], shadows="all", grids=grids)
    for out, side, words in (("1.npy", 20, ("--threads", "1")), ("2.npy", 20, ("--threads", "3")),
                             ("d.npy", 8, ("--precision", "double"))):
        tool.run("render", name, "-q", "-o", out, "-s", "screen.resolution=[%d, %d]" % (side, side), *words)
    single, other, double = (np.load(tool.file(out)) for out in ("1.npy", "2.npy", "d.npy"))
    tap.ok((single == other).all(), "the same bytes by any number of threads")
    for picture, side, allowed in ((single, 20, 2e-6), (double, 8, 1e-11)):
        places = [(x, y) for x in range(1, side, side // 4) for y in range(0, side, side // 4)]
        step = 4000 / side
        ways = [word for x, y in places for word in (
            "-p", "%.17g,%.17g" % (-2000 + step * (x + 0.5), 2000 - step * (y + 0.5)))]
        tolerance = "1e-12" if side == 8 else "1e-9"
        told = tool.run("probe", name, *ways, "--json", "--tolerance", tolerance).json()["points"]
        worst = max(abs(picture[y, x] - point["value"]) for (x, y), point in zip(places, told)) / single.max()
        tap.ok(worst < allowed, "%d pixels a side as probes tell" % side, worst)
    grid = tool.run("grid", name, "--json").json()["grids"][0]
    values = [point["value"] for point in probe(tool, name, [
        ((2000 / 3 * i, 2000 / 3 * j, 0), (0, 0, 1)) for j in (1, 0, -1) for i in (-1, 0, 1)],
        "--quantity", "irradiance")]
    cells = np.array(grid["values"]).ravel()
    tap.ok(np.allclose(np.sort(cells), np.sort(values), rtol=3e-9), "a grid as probes tell", cells, values)
    text = tool.run("explain", name, "-p", "0,0").out
    tap.ok("opening" in text and "closed form" not in text, "explained", text)


def within_a_sphere(tap, tool):
    """What stands within a spherical opening hides its far side alone, against sums over many points of it."""
    tool.write("w.ies", WINGS)
    center, axis, c0 = np.array([0.0, 0, 900]), np.array([0.0, 0, -1]), np.array([1.0, 0, 0])
    light = {"type": "luminaire", "file": "w.ies", "position": list(center), "opening": {"sphere": {"radius": 200}}}
    places, weights = points_of(light["opening"], np.array([c0, np.cross(c0, axis), axis]), center, 80)
    elements = [((40, 20, 100), (0.1, 0.2, 1)), ((400, -300, 300), (-0.3, 0.1, 1))]

    def by_plate(place, ways):
        with np.errstate(divide="ignore"):
            share = (920 - place[2]) / ways[:, 2]
        met = np.abs(place + share[:, None] * ways)
        return (share > 0) & (share < 1) & (met[:, 0] < 110) & (met[:, 1] < 90)

    def by_ball(place, ways):
        share = np.clip(((center - place) * ways).sum(1) / (ways * ways).sum(1), 0, 1)
        return np.linalg.norm(place + share[:, None] * ways - center, axis=1) < 90

    def by_tube(place, ways):
        a, b, c = (ways[:, :2] ** 2).sum(1), (ways[:, :2] * place[:2]).sum(1), (place[:2] ** 2).sum() - 60 ** 2
        root, hidden = np.sqrt(np.maximum(b * b - a * c, 0)), np.zeros(len(ways), bool)
        for share in (-b - root) / a, (-b + root) / a:
            hidden |= (b * b > a * c) & (share > 0) & (share < 1) & (np.abs(place[2] + share * ways[:, 2] - 900) < 80)
        return hidden

    for surface, hides in (({"type": "rectangle", "center": [0, 0, 920], "size": [220, 180]}, by_plate),
                           ({"type": "sphere", "center": list(center), "radius": 90}, by_ball),
                           ({"type": "cylinder", "center": list(center), "radius": 60, "height": 160,
                             "axis": [0, 0, 1]}, by_tube)):
        name = scene(tool, "i.yaml", light, surfaces=SCENE["surfaces"] + [surface], shadows="all")
        told = probe(tool, name, elements, "--quantity", "irradiance", "--tolerance", "1e-5")
        for (place, normal), point in zip(elements, told):
            seen = weights * ~hides(np.array(place), places - place)
            truth = [shining(places, part, np.array(place), unit(normal), axis, {"specular": 0, "shininess": 1}, axis,
                             c0)[0] for part in (seen, weights)]
            tap.ok(abs(point["value"] - truth[0]) < 0.03 * (truth[1] - truth[0]),
                   "a %s within a spherical opening" % surface["type"], point["value"], *truth)


def meshes_as_plates(tap, tool):
    """Two triangles hide of round sources what the plate does: before, reaching into them, on the axis of a tube."""
    tool.write("w.ies", WINGS)
    tool.write("m.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n")
    center, lamp = [0, 0, 900], {"type": "luminaire", "file": "w.ies", "position": [0, 0, 900]}
    elements = [((0, 0, 100), (0, 0.2, 1)), ((40, 20, 100), (0.1, 0.2, 1)), ((30, 10, 640), (0.2, 0, 1)),
                ((500, -300, 200), (-0.3, 0.1, 1)), ((-700, 0, 850), (1, 0, 0.2))]
    sources = [("ball", {"type": "volume", "radiance": 100, "sphere": {"center": center, "radius": 180}}),
               ("cylinder", {"type": "volume", "radiance": 100, "cylinder": {
                   "center": center, "radius": 120, "height": 400, "axis": [1, 0.5, 0]}}),
               ("tube", {**lamp, "opening": {"cylinder": {"radius": 120, "height": 400}}}),
               ("lying tube", {**lamp, "opening": {"cylinder": {"radius": 60, "height": 500, "axis": [1, 2, 0]}}})]
    for kind, light in sources:
        whole = probe(tool, scene(tool, "m.yaml", light), elements, "--quantity", "irradiance", "--tolerance", "1e-6")
        for at in [0, 0, 450], [90, 30, 760]:
            told = []
            for plate in ({"type": "rectangle", "size": [240, 240]},
                          {"type": "mesh", "file": "m.obj", "scale": 120, "normals": "flat"}):
                plate["position" if plate["type"] == "mesh" else "center"] = at
                name = scene(tool, "m.yaml", light, surfaces=SCENE["surfaces"] + [plate], shadows="all")
                told.append(probe(tool, name, elements, "--quantity", "irradiance", "--tolerance", "1e-6"))
            # what is wholly hidden of a source is 0 but for the rounding of what would arrive without the plate
            bad = [(place, a["value"], a["error"], b["value"], b["error"])
                   for (place, _), a, b, c in zip(elements, *told, whole)
                   if abs(a["value"] - b["value"]) > a["error"] + b["error"] or
                   b["error"] > max(1e-5 * a["value"], 1e-11 * c["value"])]
            tap.ok(not bad and any(point["value"] > 0 for point in told[0]), "%s, a mesh at %s" % (kind, at), *bad)


# with sanitizers pictures take minutes, and memory is as well tried by those of as_planar()
run_tests(Tap(), panel_below, as_planar, random_elements, openings_of_files, openings_not_round, lines_of_tables,
          hidden_bodies, meshes_as_plates, within_a_sphere, wrong_openings,
          *([] if os.environ.get("LUXEL_SANITIZED") else [pictures_and_grids, pictures_not_round, pictures_across]))
