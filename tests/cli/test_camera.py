# SPDX-License-Identifier: MIT
"""An observer anywhere: scenes that are moved as a whole together with their observer look the same.

Rotations have rational matrices, and places are multiples of their denominators, so that moved scenes are exactly what
they are meant to be: pictures, probes with their bounds, extrema, isophotes, batches and sweeps can be held against
those of the scene at its place.  The bounds themselves are held against lines of sight of 60 digits.
"""
import hashlib
import json
import math
import random
import re

import mpmath
import numpy
from mpmath import mpf

from tap import Tap
from tool import run_tests

mpmath.mp.dps = 60


class Motion:
    """A rotation by a quaternion of whole numbers, and a shift; `still` leaves all where it is."""

    def __init__(self, quaternion=(1, 0, 0, 0), shift=(0, 0, 0)):
        a, b, c, d = quaternion
        self.norm = a * a + b * b + c * c + d * d
        self.rows = [[a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
                     [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
                     [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]]
        self.shift = shift
        self.is_still = self.norm == 1 and shift == (0, 0, 0)
        self.cloud = "cloud-%d%d%d%d%+d%+d%+d.csv" % (*quaternion, *shift)

    def direction(self, *v):
        """`norm` times the turned direction, which is as good as that itself."""
        return [sum(row[k] * v[k] for k in range(3)) for row in self.rows]

    def place(self, *v):
        turned = [sum(row[k] * v[k] for k in range(3)) for row in self.rows]
        assert all(float(t).is_integer() and t % self.norm == 0 for t in turned), (v, self.norm)
        return [t // self.norm + s for t, s in zip(turned, self.shift)]

    def near(self, v, is_place):
        """The same of any place or direction, rounded."""
        turned = [sum(row[k] * v[k] for k in range(3)) / self.norm for row in self.rows]
        return [t + s for t, s in zip(turned, self.shift)] if is_place else turned


STILL = Motion()
# Norms 3, 9 and 45: denominators 3, 9, 45.
MOTIONS = [Motion((1, 1, 1, 0), (0, 0, 0)), Motion((2, 2, 1, 0), (1000, -2000, 500)),
           Motion((0, 3, 0, 0), (0, 0, 0)), Motion((4, 2, 5, 0), (-7, 11, 4096)), Motion((1, 0, 0, 0), (123, 45, -6))]
HEIGHT = 45 * 60

POINT = {"type": "point", "intensity": 10}
TABLE = """IESNA:LM-63-1995
[TEST] own
[MANUFAC] own
TILT=NONE
1 -1 1 5 4 1 2 .1 .2 0
1 1 10
0 30 60 90 120
0 90 180 270
1000 900 500 200 0
1000 800 300 100 0
1000 700 450 150 0
1000 950 600 250 0
"""


def lights(m):
    """Each kind of light under its name."""
    return {
        "point": [dict(POINT, position=m.place(900, 450, 2250))],
        "unattenuated": [dict(POINT, position=m.place(1800, 0, 1800), attenuation="none")],
        "ambient": [{"type": "ambient", "irradiance": 3}, dict(POINT, position=m.place(900, 450, 2250))],
        "lambertian": [dict(POINT, position=m.place(-900, 450, 2250), pattern="cosine", exponent=2,
                            aim=m.place(45, 0, 900), attenuation="practical", k=100)],
        "distant": [{"type": "distant", "direction": m.direction(-2, -1, -3), "irradiance": 2}],
        "spot": [{"type": "spot", "position": m.place(450, 450, 2700), "aim": m.place(0, 45, 900), "intensity": 20,
                  "inner": 4, "outer": 9}],
        "points": [{"type": "points", "file": m.cloud, "pattern": "lambertian",
                    "aim": m.place(0, 0, 900)}],
        "rectangle": [{"type": "planar", "radiance": 50,
                       "rectangle": {"center": m.place(450, 450, 2250), "size": [400, 250],
                                     "axis": m.direction(-1, -1, -3), "up": m.direction(0, 1, 0)}}],
        "polygon": [{"type": "planar", "radiance": 50, "vertices": [
            m.place(450, 0, 2250), m.place(450, 450, 2250), m.place(900, 450, 2250), m.place(900, 45, 2250)]}],
        "parts": [{"type": "planar", "radiance": 50, "parts": 8,
                   "rectangle": {"center": m.place(450, 450, 2250), "size": [400, 250],
                                 "axis": m.direction(-1, -1, -3), "up": m.direction(0, 1, 0)}}],
        "disk": [{"type": "planar", "radiance": 50, "attenuation": "practical", "k": 50,
                  "disk": {"center": m.place(-450, 450, 2250), "radius": 150, "axis": m.direction(1, -1, -3)}}],
        "ball": [{"type": "volume", "radiance": 50, "sphere": {"center": m.place(-450, 450, 2250), "radius": 150}}],
        "tube": [{"type": "volume", "radiance": 50, "cylinder": {
            "center": m.place(450, 450, 2250), "radius": 50, "height": 500, "axis": m.direction(1, 2, 0)}}],
        "luminaire": [{"type": "luminaire", "file": "lamp.ies", "position": m.place(450, 450, 2250),
                       "aim": m.place(0, 0, 900), "c0": m.direction(1, 0, 0)}],
    }


GLOSSY = {"diffuse": 0.7, "specular": 0.4, "shininess": 30}


def surfaces(m):
    ball = {"type": "sphere", "center": m.place(45, -45, 900), "radius": 200, "material": GLOSSY}
    return {
        "ball": [ball],
        "balls": [ball, {"type": "sphere", "center": m.place(135, 90, 1125), "radius": 60,
                         "material": dict(GLOSSY, model="phong")}],
        "plates": [{"type": "rectangle", "center": m.place(0, 0, 450), "size": [600, 420], "axis": m.direction(1, 0, 5),
                    "up": m.direction(0, 1, 0), "material": GLOSSY},
                   {"type": "disk", "center": m.place(90, 45, 900), "radius": 70, "axis": m.direction(0, 1, 4),
                    "material": GLOSSY}],
        "shell": [{"type": "sphere", "center": m.place(45, -45, 1800), "radius": 1600, "inside": True,
                   "material": GLOSSY}, ball],
        "tube": [{"type": "cylinder", "center": m.place(0, 0, 900), "radius": 120, "height": 400,
                  "axis": m.direction(1, 3, 1), "material": GLOSSY}, ball | {"center": m.place(225, -45, 900)}],
    }


def observer(m, **more):
    """Where the scene stands still, at a height; else at a position."""
    place = {"z": HEIGHT} if m.is_still else {"position": m.place(0, 0, HEIGHT), "target": m.place(0, 0, 0),
                                              "up": m.direction(0, 1, 0)}
    return dict(place, **more)


VIEWS = {"parallel": {}, "observer": {"view": "observer"}, "perspective": {"projection": "perspective"}}


def make(m, light="point", surface="balls", view="parallel", pixels=80, **more):
    """The text of a scene that was moved."""
    scene = {"luxel": 1, "screen": {"width": 500, "height": 500, "resolution": [pixels, pixels]},
             "observer": observer(m, **VIEWS[view]), "surfaces": surfaces(m)[surface], "lights": lights(m)[light]}
    return json.dumps(dict(scene, **more))


def write_files(tool):
    draw = random.Random(5)
    rows = [[45 * draw.randrange(-20, 20), 45 * draw.randrange(-20, 20), 45 * draw.randrange(45, 55)]
            for _ in range(200)]
    for m in [STILL] + MOTIONS:
        text = "x,y,z,intensity\n" + "".join("%d,%d,%d,%r\n" % (*m.place(*row), 0.1) for row in rows)
        tool.write(m.cloud, text)
    tool.write("lamp.ies", TABLE)


def render(tool, scene, *options):
    result = tool.run("render", "-", "-q", "-o", "picture.npy", *options, stdin=scene)
    if result.code != 0:
        result.fail("render")
    return numpy.load(tool.file("picture.npy")).astype(float)


def compare_pictures(tap, tool, name, still, moved, *options):
    for precision, allowed in (("single", 2e-6), ("double", 2e-11)):
        a, b = (render(tool, scene, "--precision", precision, *options) for scene in (still, moved))
        most = a.max()
        # a pixel on a rim may be on either side of it by rounding: none of these does
        off = abs(a - b).max() / most
        tap.ok(most > 0 and off <= allowed, "%s, %s" % (name, precision), "off by %r of the maximum" % off)


PROBES = [(0, 0), (45, -45), (130.5, 88.25), (-40, 60), (45, 154.9999999), (100, 10), (-100.5, -90), (249, 249)]


def compare_probes(tap, tool, name, m, still, moved):
    """Values within both bounds; places and normals are the scene's."""
    options = [word for x, y in PROBES for word in ("-p", "%r,%r" % (x, y))]
    answers = [tool.run("probe", "-", "--json", *options, stdin=scene).json()["points"] for scene in (still, moved)]
    wrong = []
    seen = 0
    for a, b in zip(*answers):
        if a["on_surface"] != b["on_surface"] or a["pixel"] != b["pixel"] or a["screen"] != b["screen"]:
            wrong.append((a, b))
        if not a["on_surface"] or not b["on_surface"]:
            continue
        seen += 1
        apart = abs(a["value"] - b["value"])
        place = max(abs(p - q) for p, q in zip(m.near(a["position"], True), b["position"]))
        normal = max(abs(p - q) for p, q in zip(m.near(a["normal"], False), b["normal"]))
        if not (apart <= a["error"] + b["error"] and place <= 1e-6 and normal <= 1e-8):
            wrong.append((apart, a, b, place, normal))
        if b["error"] > 1e-6 * abs(b["value"]) + 1e-9:
            wrong.append(("a loose bound", b))
    tap.ok(not wrong and seen > 0, name + ": probes", wrong[:2])


def moved_scenes(tap, tool):
    write_files(tool)
    for k, (light, _) in enumerate(lights(STILL).items()):
        m = MOTIONS[k % 4]
        view = list(VIEWS)[k % 3]
        still, moved = make(STILL, light, view=view), make(m, light, view=view)
        name = "%s, %s" % (light, view)
        compare_pictures(tap, tool, name, still, moved)
        compare_probes(tap, tool, name, m, still, moved)
    for k, (surface, _) in enumerate(surfaces(STILL).items()):
        for view in VIEWS:
            m = MOTIONS[(k + len(view)) % 5]
            still, moved = make(STILL, "point", surface, view), make(m, "point", surface, view)
            name = "%s, %s" % (surface, view)
            compare_pictures(tap, tool, name, still, moved)
            compare_probes(tap, tool, name, m, still, moved)


def smooth_pictures(tap, tool):
    """Pictures that are made panel by panel, with clustered points, and with highlights of extended sources."""
    write_files(tool)
    for light, options in (("parts", ()), ("points", ("--light-error", "0.01")), ("rectangle", ()), ("spot", ())):
        a, b = (render(tool, make(m, light, "ball", pixels=400), *options) for m in (STILL, MOTIONS[1]))
        off, allowed = abs(a - b).max() / a.max(), 0.02 if options else 2e-3 if light == "rectangle" else 3e-6
        tap.ok(off <= allowed, "400 x 400, %s" % light, off)
    tool.run("render", "-", "-q", "-o", "one.npy", "--threads", "1", stdin=make(MOTIONS[1], "rectangle", pixels=300))
    tool.run("render", "-", "-q", "-o", "two.npy", "--threads", "4", stdin=make(MOTIONS[1], "rectangle", pixels=300))
    tap.ok(tool.read("one.npy") == tool.read("two.npy"), "the same bytes for any number of threads")


def own_frame(tap, tool):
    """An observer with a position above a target at the origin sees the picture of one with a height, to the byte."""
    names = json.loads(tool.run("scene", "--list", "--json").out)["scenes"]
    files = ["values.npy", "values.pfm", "values.csv"]
    outputs = [word for name in files for word in ("-o", name)]
    for name in [each if isinstance(each, str) else each["name"] for each in names]:
        text = tool.run("scene", name).out
        line = next(row for row in text.splitlines() if row.startswith("observer:"))
        if "position" in line:
            continue
        height = line.split("z: ")[1].split(",")[0].rstrip("}")
        more = line[line.index("z: ") + 3 + len(height):]
        size = re.search(r"resolution: \[(\d+), (\d+)\]", text).groups()
        small = ["-s", "screen.resolution=[%d, %d]" % tuple(int(side) // 4 for side in size)]
        hashes = []
        for words in line, "observer: {position: [0, 0, %s], target: [0, 0, 0]%s" % (height, more), \
                "observer: {position: [0, 0, %s], target: [0, 0, 0], up: [0, 3, 1]%s" % (height, more):
            scene = text.replace(line, words)
            result = tool.run("render", "-", "-q", "--json", *small, *outputs, stdin=scene)
            probe = tool.run("probe", "-", "--json", "-p", "10,20", stdin=scene).json()["points"]
            answer = result.json()
            answer.pop("conventions", None)
            hashes.append((json.dumps(answer), probe, [hashlib.sha256(tool.read(each)).hexdigest() for each in files]))
        tap.ok(hashes[0] == hashes[1] == hashes[2], name + ": a position above the origin")


# ---- bounds against lines of sight of 60 digits ----

def vector(numbers):
    return mpmath.matrix([mpf(n) for n in numbers])


def dot(a, b):
    return sum(a[i] * b[i] for i in range(3))


def cross(a, b):
    return vector([a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3)])


def unit(a):
    return a / mpmath.sqrt(dot(a, a))


def truth(scene, x, y):
    """The brightness seen at a point of the screen of a scene with one surface and one point source; None: nothing."""
    eye, target = vector(scene["observer"]["position"]), vector(scene["observer"]["target"])
    z = unit(eye - target)
    right = unit(cross(vector(scene["observer"].get("up", [0, 1, 0])), z))
    up = cross(z, right)
    aside = mpf(x) * right + mpf(y) * up
    perspective = scene["observer"].get("projection") == "perspective"
    start, way = (eye, target + aside - eye) if perspective else (eye + aside, -z)
    surface, light = scene["surfaces"][0], scene["lights"][0]
    center = vector(surface["center"])
    if surface["type"] == "sphere":
        radius, off = mpf(surface["radius"]), start - center
        b, c, a = dot(off, way), dot(off, off) - radius ** 2, dot(way, way)
        if b * b - a * c < 0:
            return None
        place = start + (-b - mpmath.sqrt(b * b - a * c)) / a * way
        normal = (place - center) / radius
    else:
        normal = unit(vector(surface["axis"]))
        place = start + dot(center - start, normal) / dot(way, normal) * way
    view = unit(eye - place) if perspective or scene["observer"].get("view") == "observer" else z
    to_light = vector(light["position"]) - place
    r, towards = mpmath.sqrt(dot(to_light, to_light)), unit(to_light)
    half = unit(towards + view)
    material = surface["material"]
    value = mpf(material["diffuse"]) * max(0, dot(normal, towards))
    value += mpf(material["specular"]) * max(0, dot(normal, half)) ** mpf(material["shininess"])
    return mpf(light["intensity"]) * value / (r / 1000) ** 2


def honest_bounds(tap, tool):
    draw = random.Random(2)
    worst = loosest = 0
    count = 0
    for n in range(60):
        position = [draw.uniform(-3000, 3000) for _ in range(3)]
        target = [draw.uniform(-300, 300) for _ in range(3)]
        away = math.dist(position, target)
        if away < 800:
            continue
        plate = n % 3 == 2
        towards = [(p - t) / away for p, t in zip(position, target)]
        scene = {
            "luxel": 1, "screen": {"width": 600, "height": 600, "resolution": [10, 10]},
            "observer": {"position": position, "target": target, "up": [draw.gauss(0, 1) for _ in range(3)],
                         **list(VIEWS.values())[n // 3 % 3]},
            "surfaces": [{"type": "rectangle", "center": target, "size": [900, 900],
                          "axis": [t + draw.uniform(-0.4, 0.4) for t in towards]} if plate else
                         {"type": "sphere", "center": target, "radius": draw.uniform(50, 250)}],
            "lights": [{"type": "point", "position": [t + 900 * d + draw.uniform(-300, 300)
                                                      for t, d in zip(target, towards)], "intensity": 10}],
        }
        scene["surfaces"][0]["material"] = {"diffuse": 0.7, "specular": 0.5, "shininess": draw.choice([3, 40, 2000])}
        radius = scene["surfaces"][0].get("radius", 250)
        points = [(draw.uniform(-1, 1) * radius * 0.7, draw.uniform(-1, 1) * radius * 0.7) for _ in range(6)]
        for share in 1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13:  # ever nearer to the rim
            turn = draw.uniform(0, 2 * math.pi)
            points.append((radius * (1 - share) * math.cos(turn), radius * (1 - share) * math.sin(turn)))
        options = [word for x, y in points for word in ("-p", "%r,%r" % (x, y))]
        result = tool.run("probe", "-", "--json", *options, stdin=json.dumps(scene))
        if result.code != 0:
            result.fail("probe")
        for (x, y), point in zip(points, result.json()["points"]):
            exact = truth(scene, x, y)
            if point["value"] is None or exact is None:
                continue
            off = abs(mpf(point["value"]) - exact)
            count += 1
            worst = max(worst, off / mpf(point["error"]) if point["error"] else (0 if off == 0 else mpf("inf")))
            if (x, y) in points[:7]:
                loosest = max(loosest, point["error"] / max(point["value"], 1e-3))
    tap.ok(count > 400 and worst <= 1, "values lie within their bounds", "worst %s of %d" % (float(worst), count))
    tap.ok(loosest < 1e-10, "bounds away from the rim are tight", loosest)


def pixels_and_probes(tap, tool):
    """Pictures are computed in the frame of the screen, probes in that of the scene: any observer sees the same."""
    write_files(tool)
    draw = random.Random(9)
    for n, light in enumerate(("point", "spot", "rectangle", "ball", "luminaire", "points")):
        scene = json.loads(make(STILL, light, ("balls", "tube")[n % 2], pixels=64))
        for surface in scene["surfaces"]:
            surface["material"] = dict(surface["material"], specular=0 if light in ("rectangle", "ball") else 0.4)
        away = [draw.gauss(0, 1), draw.gauss(0, 1), 1 + abs(draw.gauss(0, 1))]
        target = [draw.uniform(0, 90), draw.uniform(-40, 40), draw.uniform(900, 1000)]
        size = 2000 / math.hypot(*away)
        scene["observer"] = {"position": [t + size * a for t, a in zip(target, away)], "target": target,
                             "up": [draw.gauss(0, 1) for _ in range(3)], **list(VIEWS.values())[n % 3]}
        picks = [(draw.randrange(64), draw.randrange(64)) for _ in range(150)]
        options = [word for column, row in picks for word in
                   ("-p", "%r,%r" % (500 * (column + 0.5) / 64 - 250, 250 - 500 * (row + 0.5) / 64))]
        points = tool.run("probe", "-", "--json", *options, stdin=json.dumps(scene)).json()["points"]
        for precision, allowed in (("single", 2e-6), ("double", 1e-11)):
            picture = render(tool, json.dumps(scene), "--precision", precision)
            off = max(abs(picture[row][column] - (p["value"] or 0)) - (p["error"] or 0)
                      for p, (column, row) in zip(points, picks)) / picture.max()
            tap.ok(picture.max() > 0 and off <= allowed, "pixels and probes, %s, %s" % (light, precision), off)


def rooms(tap, tool):
    """An observer inside of a room looks into a corner of it, at a ball: pixels and probes agree."""
    scene = {"luxel": 1, "screen": {"width": 400, "height": 300, "resolution": [64, 48]},
             "observer": {"position": [1500, -900, 1400], "target": [1100, -500, 1000], "projection": "perspective"},
             "surfaces": [{"type": "room", "center": [0, 0, 0], "size": [4000, 2600, 3400],
                           "materials": {"floor": {"diffuse": 0.3}}},
                          {"type": "sphere", "center": [-100, 600, -200], "radius": 400, "material": GLOSSY}],
             "lights": [{"type": "point", "position": [300, 1100, 600], "intensity": 10},
                        {"type": "planar", "radiance": 5, "rectangle": {
                            "center": [0, 1290, 0], "size": [300, 300], "axis": [0, -1, 0]}}]}
    places = [(column, row) for column in range(0, 64, 5) for row in range(0, 48, 5)]
    options = [word for column, row in places for word in
               ("-p", "%r,%r" % (400 * (column + 0.5) / 64 - 200, 150 - 300 * (row + 0.5) / 48))]
    result = tool.run("probe", "-", "--json", *options, stdin=json.dumps(scene))
    tap.equal((result.code, result.err), (0, ""), "an observer in a room")
    points = result.json()["points"]
    picture = render(tool, json.dumps(scene), "--precision", "double")
    off = [abs(picture[row][column] - p["value"]) - p["error"] for p, (column, row) in zip(points, places)]
    tap.ok(all(p["on_surface"] for p in points) and len({tuple(p["normal"]) for p in points}) > 12,
           "walls and the ball are seen", points[:2])
    tap.ok(max(off) <= 1e-3 * picture.max(), "pixels and probes in a room", max(off) / picture.max())


# ---- what is read off the picture ----

def readings(tap, tool):
    write_files(tool)
    for view, m in zip(VIEWS, MOTIONS):
        still, moved = make(STILL, "spot", "balls", view), make(m, "spot", "balls", view)
        extrema = [tool.run("stats", "-", "--json", stdin=scene).json() for scene in (still, moved)]
        for name in "maximum", "minimum":
            a, b = (answer[name] for answer in extrema)
            tap.ok(a and b and abs(a["value"] - b["value"]) <= 1e-9 * abs(a["value"]) + 1e-12,
                   "%s, %s: %s" % (view, name, "value"), a, b)
            if name == "maximum":
                tap.ok(math.dist(a["screen"], b["screen"]) < 1e-3, view + ": where it is seen", a, b)
                tap.ok(math.dist(m.near(a["position"], True), b["position"]) < 1e-3, view + ": and in the scene",
                       a, b)
        lines = [total_length(tool.run("isophotes", "-", "--levels", "2,5", "--json", stdin=scene).json())
                 for scene in (still, moved)]
        tap.ok(lines[0] > 100 and abs(lines[0] - lines[1]) < 1e-4 * lines[0], view + ": isophotes", lines)
        rows = []
        for scene in still, moved:
            answer = tool.run("profile", "-", "--from", "-100,-80", "--to", "120,60", "--samples", "9", "--json",
                              stdin=scene).json()
            arc = tool.run("profile", "-", "--from", "30,-80", "--to", "50,-20", "--arc", "--samples", "5", "--json",
                           stdin=scene).json()
            rows.append([sample for part in (answer, arc) for sample in part["samples"]])
        tap.ok(all((a["value"] is None) == (b["value"] is None) and
                   (a["value"] is None or abs(a["value"] - b["value"]) <= 1e-10 * abs(a["value"]) + 1e-12) and
                   max(abs(p - q) for p, q in zip(a["screen"], b["screen"])) < 1e-6 for a, b in zip(*rows)),
               view + ": profiles along lines and arcs", rows)


def total_length(answer):
    return sum(math.dist(p, q) for line in answer["lines"] for p, q in zip(line["vertices"], line["vertices"][1:]))


def free_elements(tap, tool):
    """The view vector of a free element is the screen's z axis, or leads to the observer."""
    for view, m in (("parallel", MOTIONS[1]), ("observer", MOTIONS[3]), ("parallel", MOTIONS[0])):
        answers = []
        for motion in STILL, m:
            place, normal = motion.place(45, -45, 1125), motion.direction(1, 0, 4)
            result = tool.run("probe", "-", "--at", ",".join("%r" % n for n in place + normal), "--json",
                              stdin=make(motion, view=view))
            answers.append(result.json()["points"][0])
        a, b = answers
        tap.ok(abs(a["value"] - b["value"]) <= a["error"] + b["error"] and a["value"] > 0, "free element, " + view, a,
               b)
        many = "".join(",".join("%r" % n for n in m.place(45 * k, -45, 1125) + m.direction(1, 0, 4)) + "\n"
                       for k in range(-9, 9))
        tool.write("places.csv", "x,y,z,nx,ny,nz\n" + many)
        batch = tool.run("probe", "-", "--points", "places.csv", "--json", stdin=make(m, view=view)).json()["points"]
        single = [tool.run("probe", "-", "--at", row, "--json", stdin=make(m, view=view)).json()["points"][0]
                  for row in many.split()]
        tap.ok([p["value"] for p in batch] == [p["value"] for p in single], "many free elements, " + view)


def sweeps(tap, tool):
    """Scenes of a study whose observer moves are those that are rendered one by one; normals are the scene's."""
    target = MOTIONS[1].place(45, -45, 900)
    scene = json.loads(make(MOTIONS[1], pixels=16))
    scene["observer"] = {"position": [0, 0, 0], "target": target, "projection": "perspective"}
    tool.write("base.yaml", json.dumps(dict(scene, observer={"position": [0, 0, 9000], "target": target})))
    tool.write("study.yaml", json.dumps({
        "study": 1, "scene": "base.yaml", "count": 5, "seed": 3, "shard": 5,
        "vary": [{"key": "observer.position", "random": "sphere", "center": target, "radius": 1500}],
        "outputs": {"brightness": "float64", "normals": "float64", "depth": "float64"}}))
    result = tool.run("sweep", "study.yaml", "-o", "out", "-q")
    tap.equal((result.code, result.err), (0, ""), "a sweep of positions")
    arrays = {name: numpy.load(tool.file("out/shard-000000/%s.npy" % name))
              for name in ("brightness", "normals", "depth", "parameters")}
    for i in range(5):
        position = [float(n) for n in arrays["parameters"][i]]
        scene["observer"] = {"position": position, "target": target}
        text = json.dumps(scene)
        picture = render(tool, text, "--precision", "double")
        tap.ok((picture == arrays["brightness"][i]).all(), "scene %d of a sweep" % i)
        points = [(column, row) for column in (6, 8, 9) for row in (6, 8)]
        options = [word for column, row in points for word in
                   ("-p", "%r,%r" % (500 * (column + 0.5) / 16 - 250, 250 - 500 * (row + 0.5) / 16))]
        answer = tool.run("probe", "-", "--json", *options, stdin=text).json()["points"]
        seen = [(p, row, column) for p, (column, row) in zip(answer, points) if p["on_surface"]]
        axis = [(p - t) / math.dist(position, target) for p, t in zip(position, target)]
        tap.ok(seen and all(
            max(abs(a - b) for a, b in zip(arrays["normals"][i][row][column], p["normal"])) < 1e-15
            for p, row, column in seen) and all(
            abs(sum(a * (o - q) for a, o, q in zip(axis, position, p["position"])) -
                arrays["depth"][i][row][column]) < 1e-9 for p, row, column in seen), "normals, depth %d" % i)


# ---- what is refused ----

def refusals(tap, tool):
    base = "luxel: 1\nscreen: {width: 100, height: 100, resolution: [4, 4]}\nobserver: %s\n" \
        "surfaces: [{type: sphere, center: [0, 0, 0], radius: 10}]\nlights: []\n"
    cases = [
        ("{z: 100, position: [0, 0, 100], target: [0, 0, 0]}", "3:20", "z and position are mutually exclusive|"
         "position and z are mutually exclusive|mutually exclusive: give exactly one of z, position"),
        ("{position: [0, 0, 100]}", "3:11", 'missing key "target": position needs it'),
        ("{target: [0, 0, 100]}", "3:11", 'missing key "position": target needs it'),
        ("{z: 100, target: [0, 0, 0]}", "3:11", 'missing key "position": target needs it'),
        ("{}", "3:11", "observer needs one of z, position"),
        ("{position: [1, 2, 3], target: [1, 2, 3]}", "3:22", "position and target must differ"),
        ("{position: [0, 50, 0], target: [0, 0, 0], up: [0, 1, 0]}", "3:57", "must not be parallel"),
        ("{position: [0, 0, 50], target: [0, 0, 0], up: [0, 0, -1e-3]}", "3:57", "must not be parallel"),
        ("{position: [0, 0, 50], target: [0, 0, 0], up: [0, 0, 0]}", "3:57", "up"),
        ("{position: [1e308, 0, 0], target: [-1e308, 0, 0]}", "3:22", "too far apart"),
        ("{position: [.nan, 0, 0], target: [1, 0, 0]}", "3:23", "finite"),
        ("{position: [5, 0, 0], target: [0, 0, 0]}", "3:22", "stand in front of every surface"),
        ("{position: [0, 0, 3], target: [0, 0, 0], projection: perspective}", "3:22", "z = 10|in front of every"),
    ]
    for words, place, message in cases:
        result = tool.run("check", "-", stdin=base % words)
        tap.ok(result.code == 3 and place in result.err and any(each in result.err for each in message.split("|")),
               words, result)
    for up in "", ", up: [0, 0, 1]", ", up: [1e-9, 1, 0]", ", up: [1e-300, 1e-295, 1e-290]":
        result = tool.run("probe", "-", "--json", "-p", "1,2",
                          stdin=base % ("{position: [0, 500, 0], target: [0, 0, 0]%s}" % up))
        good = result.code == 0
        tap.ok(good, "looking along y" + up, result)
        if good:
            place = result.json()["points"][0]["position"]
            expected = [-1, math.sqrt(95), 2] if "1e-9" not in up else [2, math.sqrt(95), 1]
            tap.ok(max(abs(p - q) for p, q in zip(place, expected)) < 1e-8, "what is up" + up, place)
    turned = base.replace("type: sphere, center: [0, 0, 0], radius: 10",
                          "type: rectangle, center: [0, 0, 0], size: [9, 9], axis: [0, 0, 1]")
    for words in "{position: [0, 0, -50], target: [0, 0, 0]}", \
            "{position: [0, 9, -50], target: [0, 0, 0], projection: perspective}":
        result = tool.run("check", "-", stdin=turned % words)
        tap.ok(result.code == 0 and "surfaces[0] is not drawn" in result.out, words, result)


def explanations(tap, tool):
    """The whole calculation of a point knows no height along z."""
    for view in "parallel", "perspective":
        result = tool.run("explain", "-", "-p", "45,-45", stdin=make(MOTIONS[1], view=view))
        text = " ".join(result.out.split())
        tap.ok(result.code == 0 and "z_C" not in text and "N = (P − C) / R" in text, view + ": a point", result)


def advice(tap, tool):
    """What is in view, and what is behind, is judged as the screen has it."""
    scene = "luxel: 1\nscreen: {width: 300, height: 300, resolution: [300, 300]}\n" \
        "observer: {position: [1500, 0, 1000], target: [0, 0, 1000]}\n" \
        "surfaces: [{type: sphere, center: [0, 0, %d], radius: 100}]\n" \
        "lights: [{type: point, position: [%d, 20, 1100], intensity: 10}]\n"
    good = tool.run("check", "-", stdin=scene % (1050, 900))
    tap.ok(good.code == 0 and "advice" not in good.out + good.err, "in view, and lit", good)
    aside = tool.run("check", "-", stdin=scene % (1100, 900))
    tap.ok("on these sides: left" in aside.out + aside.err, "not wholly in view", aside)
    behind = tool.run("check", "-", stdin=scene % (1050, -900))
    told = behind.out + behind.err
    tap.ok("stands inside or behind every surface" in told and "hint" in told, "a light behind", behind)
    if "lights[0].position=" in told:
        mended = tool.run("check", "-", "-s", told.split("'")[1], stdin=scene % (1050, -900))
        tap.ok("behind" not in mended.out + mended.err, "and what mends it", mended)


run_tests(Tap(), own_frame, moved_scenes, smooth_pictures, honest_bounds, pixels_and_probes, rooms, readings,
          free_elements, sweeps, explanations, advice, refusals)
