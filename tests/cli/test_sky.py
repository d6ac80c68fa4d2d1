# SPDX-License-Identifier: MIT
"""The sky and the sun: closed forms, integrals to twelve digits, positions of the sun, what hides them, wrong keys."""
import csv
import math

import mpmath

from tap import Tap
from tool import run_tests

SCENE = """luxel: 1
units: photometric
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
surfaces: %s
lights:
  - %s
"""

# Horizontal illuminance over pi times the zenith's luminance, with the sun at 60 and at 30 degrees.
HORIZONTAL = {
    1: (.779713076812, .779713076812), 2: (.664001809149, .813784472092), 3: (.881714509487, .881714509487),
    4: (.737020791941, .919962381382), 5: (1, 1), 6: (.822563805189, 1.043364231443),
    7: (.770699937114, 1.169166723118), 8: (.741146356118, 1.312416041501), 9: (1.101136826948, 1.449186381964),
    10: (1.009125248115, 1.637676033184), 11: (.951447602446, 1.851809612558), 12: (1.015590860662, 2.035307105882),
    13: (.963158946694, 2.226646190044), 14: (1.023989142609, 2.453563520524), 15: (.959976859304, 2.583410489401),
    16: (7 / 9, 7 / 9)}


def light(tool, source, places, surfaces="[]", options=()):
    """Values and errors of elements, (x, y, z, nx, ny, nz) each."""
    tool.write("sky.yaml", SCENE % (surfaces, source))
    at = [word for place in places for word in ("--at", ",".join("%.17g" % part for part in place))]
    result = tool.run("probe", "sky.yaml", "--quantity", "irradiance", "--json", *at, *options)
    assert result.code in (0, 5), str(result)
    return [(point["value"], point["error"]) for point in result.json()["points"]]


def holds(tap, found, truth, name, close=1e-9, known=1e-12):
    """Whether a value is the true one within its error, and that is small."""
    value, error = found
    tap.ok(abs(value - truth) <= error + known * abs(truth) and error <= close * abs(truth), name, found, truth)


def open_skies(tap, tool):
    up, south = (0, 0, 0, 0, 0, 1), (0, 0, 0, 0, -1, 0)
    for kind, values in HORIZONTAL.items():
        for altitude, value in zip((60, 30), values):
            source = "{type: sky, kind: %d, sun: {altitude: %d, azimuth: 200}, zenith: 1}" % (kind, altitude)
            found = light(tool, source, [up])[0]
            holds(tap, found, math.pi * value, "kind %d, sun at %d degrees" % (kind, altitude), known=4e-12)
    vertical, = light(tool, "{type: sky, kind: 16, zenith: 1}", [south])
    holds(tap, vertical, math.pi / 6 + 4 / 9, "a vertical plane under the overcast sky")
    vertical, = light(tool, "{type: sky, kind: 16, horizontal: 10000}", [south])
    holds(tap, vertical, 3961.7707781931, "as a share of the horizontal one", known=1e-13 * 50)
    for kind, altitude in ((5, 40), (12, 40), (9, 3), (15, 88), (14, .5)):
        source = "{type: sky, kind: %d, sun: {altitude: %g, azimuth: 200}, horizontal: 10000, ground: 0.3}"
        found = light(tool, source % (kind, altitude), [up, (0, 0, 0, 0, 0, -1)])
        holds(tap, found[0], 10000, "horizontal of kind %d, sun at %g" % (kind, altitude), known=1e-11)
        holds(tap, found[1], 3000, "the ground")


def suns(tap, tool):
    places = [(0, 0, 0, 0, 0, 1), (0, 0, 0, 0, -1, 0), (0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 0, -1)]
    for diameter, close in ((0, 1e-14), (.533, 1e-11), (20, 1e-11)):
        source = "{type: sun, irradiance: 1000, altitude: 30, azimuth: 180, diameter: %g}" % diameter
        found = light(tool, source, places)
        holds(tap, found[0], 500, "sun on the ground, diameter %g" % diameter, close)
        holds(tap, found[1], 500 * math.sqrt(3), "on a wall to the south", close)
        # a plane that the sun grazes sees half of its disk
        a = math.radians(diameter / 2)
        half = 1000 * (a - math.sin(a) * math.cos(a)) / (math.pi * math.sin(a) ** 2) if diameter else 0
        tap.ok(abs(found[2][0] - half) <= found[2][1] + 1e-11 * half + 1e-9, "on a wall to the east", found[2], half)
        tap.ok(found[3] == (0, 0), "from below", found[3])
    turned = light(tool, "{type: sun, irradiance: 1000, altitude: 20, azimuth: 90, up: [0, 1, 0], diameter: 0}",
                   [(0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0)])
    holds(tap, turned[0], 1000 * math.cos(math.radians(20)), "east where y is up and -z is north")
    holds(tap, turned[1], 1000 * math.sin(math.radians(20)), "up")
    # NREL's solar position algorithm, without refraction: altitude 39.87205, azimuth 194.34024
    date = "{type: sun, irradiance: 1, date: '2003-10-17T12:30:30-07:00', latitude: 39.742476, longitude: -105.1786, " \
           "diameter: 0}"
    altitude, azimuth = math.radians(39.87205), math.radians(194.34024)
    found = light(tool, date, [(0, 0, 0, 0, 0, 1), (0, 0, 0, 1, 0, 0), (0, 0, 0, -1, 0, 0), (0, 0, 0, 0, -1, 0)])
    tap.ok(abs(found[0][0] - math.sin(altitude)) < math.radians(.01), "altitude by date and place", found[0])
    tap.ok(abs(found[2][0] + math.cos(altitude) * math.sin(azimuth)) < math.radians(.01), "its azimuth", found[2])


PLATES = """
  - {type: rectangle, center: [2000, 750, 3000], size: [4000, 1500], axis: [0, 0, -1]}
  - {type: rectangle, center: [2000, 3250, 3000], size: [4000, 1500], axis: [0, 0, -1]}
  - {type: rectangle, center: [750, 2000, 3000], size: [1500, 1000], axis: [0, 0, -1]}
  - {type: rectangle, center: [3250, 2000, 3000], size: [1500, 1000], axis: [0, 0, -1]}
  - {type: rectangle, center: [0, 2000, 1500], size: [4000, 3000], axis: [1, 0, 0], up: [0, 0, 1]}
  - {type: rectangle, center: [4000, 2000, 1500], size: [4000, 3000], axis: [-1, 0, 0], up: [0, 0, 1]}
  - {type: rectangle, center: [2000, 0, 1500], size: [4000, 3000], axis: [0, 1, 0], up: [0, 0, 1]}
  - {type: rectangle, center: [2000, 4000, 1500], size: [4000, 3000], axis: [0, -1, 0], up: [0, 0, 1]}"""
# CIE 171, 5.9: an opening of 1 m x 1 m in the roof; exact values, the printed ones agree to their digits.
ROOF = {
    1: ".4573081 1.6437625 2.3363329 2.2609766 1.8760108 1.4654373 2.3350248 3.1099927 3.8388393 4.2938590",
    5: "1.0401380 2.3934970 2.5885970 2.1982680 1.6998872 1.2732985 1.9551898 2.5227700 3.0451840 3.3670260",
    12: "1.7430954 3.7569566 4.5466642 4.6093917 4.2399300 3.6333844 5.7225874 6.0048155 5.1131773 3.9680372 "
        "2.8972835 2.0345186 1.4022747 .9647079",
    16: ".5641729 1.7825983 2.3180628 2.1978594 1.8211515 1.4274710 2.2890722 3.0739533 3.8225396 4.2944060"}


def roofs(tap, tool):
    places = [(2000, 0, 2750 - 500 * i, 0, 1, 0) for i in range(6)]
    places += [(2000, 250 + 500 * i, 0, 0, 0, 1) for i in range(8)]
    for kind, values in ROOF.items():
        source = "{type: sky, kind: %d, sun: {altitude: 60, azimuth: 0}, horizontal: 100}" % kind
        truths = [float(value) for value in values.split()]
        truths += reversed(truths[6:]) if len(truths) < len(places) else []
        for i, (found, truth) in enumerate(zip(light(tool, source, places, PLATES), truths)):
            holds(tap, found, truth, "kind %d, place %s" % (kind, "ABCDEFGHIJKLMN"[i]), 1e-8, 6e-8 / truth)


def obstacles(tap, tool):
    up, tilted = (0, 0, 0, 0, 0, 1), (0, 0, 0, .48, .6, .64)
    uniform, clear = "{type: sky, kind: 5, zenith: 1}", \
        "{type: sky, kind: 12, sun: {altitude: 35, azimuth: 140}, zenith: 1, ground: .2}"
    ball = "[{type: sphere, center: [0, 0, 1000], radius: 400}]"
    found, = light(tool, uniform, [up], ball)
    holds(tap, found, math.pi * (1 - .16), "a ball overhead")
    box = "[{type: box, center: [300, -200, 700], size: [400, 500, 300]}]"
    tool.write("box.obj", "".join("v %g %g %g\n" % (x, y, z) for x in (100, 500) for y in (-450, 50)
                                  for z in (550, 850)) +
               "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n")
    mesh = "[{type: mesh, file: box.obj}]"
    for name, source in (("uniform", uniform), ("clear", clear)):
        places = [up, tilted, (0, 0, 0, 0, -.6, -.8)]
        for one, other in zip(light(tool, source, places, box), light(tool, source, places, mesh)):
            tap.ok(abs(one[0] - other[0]) <= one[1] + other[1] and one[1] < 1e-8 * one[0],
                   "a box as a surface and as a mesh, " + name, one, other)
    open_, = light(tool, clear, [up])
    for shadows in ("none", "points"):
        found, = light(tool, clear, [up], box, ("-s", "shadows=" + shadows))
        tap.equal(found, open_, "shadows: " + shadows)
    # a half of the sun beyond the edge of a plate, which is above the place's east and as long as can be
    sun = "{type: sun, irradiance: 1, altitude: 90, azimuth: 0, diameter: 2}"
    plate = "[{type: rectangle, center: [50000, 0, 1000], size: [100000, 100000]}]"
    found, = light(tool, sun, [up], plate)
    holds(tap, found, .5, "half of the sun")


ROOM = "[{type: room, up: z, center: [2000, 2000, 1500], size: [4000, 4000, 3000], material: {model: lambert}, " \
       "openings: [%s]}]"


def windows(tap, tool):
    """CIE 171, 5.9 to 5.11, with the opening as a key of the room, and glass."""
    roof = ROOM % "{wall: ceiling, size: [1000, 1000]}"
    places = [(2000, 0, 2750 - 500 * i, 0, 1, 0) for i in range(6)]
    places += [(2000, 250 + 500 * i, 0, 0, 0, 1) for i in range(8)]
    source = "{type: sky, kind: 12, sun: {altitude: 60, azimuth: 0}, horizontal: 100}"
    for found, value in zip(light(tool, source, places, roof), ROOF[12].split()):
        holds(tap, found, float(value), "5.9", 1e-8, 6e-8 / float(value))
    facade = ROOM % "{wall: front, center: [0, 0], size: [2000, 1000]}"
    source = "{type: sky, kind: 3, sun: {altitude: 60, azimuth: 180}, horizontal: 100, ground: .3}"
    ceiling = [(2000, 3750 - 500 * i, 3000, 0, 0, -1) for i in range(8)]
    exact = ".3796719 .5262217 .7463504 1.0774660 1.5553630 2.1340764 2.3978559 1.2384196"
    for found, value in zip(light(tool, source, ceiling, facade), exact.split()):
        holds(tap, found, float(value), "5.11, the ceiling", 1e-8, 6e-8 / float(value))
    walls = [(2000, 4000, 2750 - 500 * i, 0, -1, 0) for i in range(6)]
    for found, value in zip(light(tool, source, walls, facade), (.95, 1.06, 1.56, 2.42, 2.75, 2.58)):
        tap.ok(abs(found[0] - value) < .0061 and found[1] < 1e-8, "5.11, the wall, as printed", found, value)
    floor = [(2000, 3750 - 500 * i, 0, 0, 0, 1) for i in range(8)]
    for found, value in zip(light(tool, source, floor, facade), (1.08, 1.54, 2.26, 3.40, 5.11, 7.34, 8.61, 4.56)):
        tap.ok(abs(found[0] - value) < .036 and found[1] < 1e-8, "5.11, the floor, as printed", found, value)
    glazed = ROOM % "{wall: ceiling, size: [1000, 1000], glass: {n: 1.526}}"
    source = "{type: sky, kind: 5, horizontal: 100}"
    printed = (.35, 1.69, 2.12, 1.87, 1.47, 1.11, 1.71, 2.22, 2.68, 2.96)
    for found, value in zip(light(tool, source, places, glazed), printed):
        tap.ok(abs(found[0] - value) < .0155 and found[1] < 1e-8, "5.10, as printed", found, value)
    # light of other sources comes through, too, less by what glass takes at its angle
    for angle, passes in ((0, .8814597855), (60, .8015189826)):
        for source in ("{type: point, position: [%.12g, 2000, 10000], intensity: 100}",
                       "{type: distant, direction: [%.12g, 0, -1], irradiance: 100}",
                       "{type: planar, disk: {center: [%.12g, 2000, 10000], radius: 1}, radiance: 1e6}"):
            aside = 7000 * math.tan(math.radians(angle))
            at = (2000, 2000, 3000 - 1e-3, 0, 0, 1)
            source %= -aside / 7000 if "direction" in source else 2000 + aside
            wide = "{wall: ceiling, size: [3000, 3000]%s}"
            open_, = light(tool, source, [at], ROOM % wide % "")
            glass, = light(tool, source, [at], ROOM % wide % ", glass: {}")
            tap.ok(open_[0] > 0 and abs(glass[0] / open_[0] - passes) < 1e-6, "glass at %d" % angle, open_, glass)
    # of lamps before it glass takes nothing
    for shape, name in (("planar, disk: {center: [2000, 2000, 1000], radius: 300, axis: [0, 0, -1]}", "disk"),
                        ("volume, sphere: {center: [2000, 2000, 1000], radius: 300}", "ball")):
        lamp = "{type: %s, radiance: 1}" % shape
        open_, glass = (light(tool, lamp, [(2300, 2000, 0, 0, 0, 1)], ROOM % wide % pane)[0]
                        for pane in ("", ", glass: {}"))
        tap.ok(open_[0] > 0 and abs(glass[0] - open_[0]) <= open_[1] + glass[1], "a %s before glass" % name, open_,
               glass)
    for wall, place, inwards in (("left", (0, 1200, 2100), (1, 0, 0)), ("right", (4000, 1200, 2100), (-1, 0, 0)),
                                 ("back", (1300, 4000, 2100), (0, -1, 0)), ("front", (1300, 0, 2100), (0, 1, 0))):
        # a beam through the middle of a window, and past its edges, falls on an element within
        right = {"left": 1200 - 2000, "right": 2000 - 1200, "back": 1300 - 2000, "front": 2000 - 1300}[wall]
        room = ROOM % "{wall: %s, center: [%g, 600], size: [400, 200]}" % (wall, right)
        sun = "{type: distant, direction: [%g, %g, 0], irradiance: 1}" % inwards[:2]
        along = (0, 1) if inwards[0] else (1, 0)
        seen = [(place[0] + 500 * inwards[0] + off * along[0], place[1] + 500 * inwards[1] + off * along[1],
                 place[2] + up, -inwards[0], -inwards[1], 0)
                for off, up in ((0, 0), (199, 99), (-199, -99), (201, 0), (-201, 0), (0, 101), (0, -101))]
        tap.equal([value for value, _ in light(tool, sun, seen, room)], [1, 1, 1, 0, 0, 0, 0], "window: " + wall)


def lambert(corners):
    """The irradiance of a plane z = 0 by a polygon of radiance 1, with 40 digits."""
    mpmath.mp.dps = 40
    total = mpmath.mpf(0)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        a, b = ([mpmath.mpf(part) for part in corner] for corner in (a, b))
        turn = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        size = mpmath.sqrt(sum(part * part for part in turn))
        total += turn[2] / size * mpmath.atan2(size, sum(x * y for x, y in zip(a, b)))
    return abs(total) / 2


def at_windows(tap, tool):
    """Places in the plane of a window, and before it."""
    even = "{type: sky, kind: 5, zenith: 1, ground: 1}"
    lid = ROOM % "{wall: ceiling, size: [4000, 4000]}"
    places = [(2000, 2000, 3000, *way) for way in ((1, 0, 0), (.6, 0, .8), (.6, 0, -.8), (0, 0, -1), (0, 0, 1))]
    for found, truth in zip(light(tool, even, places, lid), (.5, .9, .1, 0, 1)):
        holds(tap, found, math.pi * truth, "in the plane of an opening")
    # all around a window as large as its wall there is light, but for what the room takes
    wall = ROOM % "{wall: left, size: [4000, 3000]}"
    for away in (1, 10, 300):
        found, = light(tool, even, [(-away, 3980, 1500, 1, 0, 0)], wall)
        sides = [(y, z, away) for y, z in ((-3980, -1500), (20, -1500), (20, 1500), (-3980, 1500))]
        truth = float(mpmath.pi - lambert(sides))
        holds(tap, found, truth, "%g mm before an opening" % away, 1e-6)


# Percent of the horizontal irradiance in the room of `daylight`, by 1.5 million random ways, and their deviation.
PATHS = ((6.0324, .0163), (6.1553, .0168))

GRIDS = """grids:
  - {name: desk, center: [2000, 2000, 850], size: [3000, 3000], n: [2, 3]}
"""


def daylight(tap, tool):
    open_ = SCENE % ("[]", "{type: sky, kind: 16, zenith: 3, ground: .2}")
    tool.write("open.yaml", open_)
    told = tool.run("daylight", "open.yaml", "--json", "--at", "0,0,0,0,0,1", "--at", "0,0,0,1,0,0").json()
    flat, wall = told["elements"]
    holds(tap, (flat["daylight_factor"], flat["error"]), 100, "the open sky")
    tap.near(wall["sky"], 39.617707781931, 1e-10, "a wall's sky")
    tap.near(wall["external"], 10, 1e-9, "the ground before it")
    tap.equal((wall["internal"], told["grids"]), (0, []), "nothing reflects")
    window = ROOM.replace("{model: lambert}", "{model: lambert, diffuse: .5, over_pi: true}") % \
        "{wall: front, size: [2000, 1000]}"
    scene = SCENE % (window, "{type: sky, kind: 5, horizontal: 10000, ground: 1}") + GRIDS
    tool.write("room.yaml", scene)
    tool.write("reflecting.yaml", scene + "reflections: all\n")
    direct = tool.run("daylight", "room.yaml", "--json").json()["grids"][0]
    made = tool.run("daylight", "reflecting.yaml", "--json", "--reflected-error", "0.1", "--at", "2000,2000,850,0,0,1",
                    "--at", "2000,4000,1500,0,-1,0", timeout=200)
    tap.equal(made.code, 0, "with reflections")
    grid = made.json()["grids"][0]
    values, errors = grid["values"], grid["errors"]
    tap.equal((grid["name"], len(values), len(values[0])), ("desk", 3, 2), "its cells")
    for row in range(3):
        for column in range(2):
            parts = [grid[key][row][column] for key in ("sky", "external", "internal")]
            tap.ok(abs(sum(parts) - values[row][column]) < 1e-9 and parts[2] > 0 and
                   abs(direct["values"][row][column] - parts[0] - parts[1]) < 1e-9, "parts add up", parts)
    flat = sorted(value for row in values for value in row)
    tap.near(grid["mean"], sum(flat) / 6, 1e-12, "the mean")
    tap.near(grid["median"], (flat[2] + flat[3]) / 2, 1e-12, "the median")
    shares = grid["en17037"]["shares"]
    truth = sum(value - error >= 3 for row, cells in zip(values, errors) for value, error in zip(row, cells)) / 6
    tap.ok(list(shares) == ["100", "300", "500", "750"] and shares["300"] == truth and
           sorted(shares.values(), reverse=True) == list(shares.values()), "shares of EN 17037", shares)
    # the world outside is uniform all around
    for found, (truth, known) in zip(made.json()["elements"], PATHS):
        tap.ok(abs(found["daylight_factor"] - truth) <= found["error"] + 4 * known and found["error"] < .15 * truth,
               "reflected light against random ways", found, truth)
    text = tool.run("daylight", "room.yaml")
    tap.ok(text.code == 0 and "desk" in text.out and "median" in text.out and "EN 17037" in text.out, "as text", text)
    # a table of the same numbers, and the cells behind the no-sky line: beside the window below its wall
    made = tool.run("daylight", "room.yaml", "--at", "2000,2000,850,0,0,1", "-o", "factors.csv")
    with open(tool.file("factors.csv"), encoding="utf-8", newline="") as file:
        lines = list(csv.DictReader(file))
    held = direct["values"]
    tap.ok(made.code == 0 and len(lines) == 7 and lines[6]["grid"] == "P1" and lines[6]["column"] == "" and all(
        float(line["daylight_factor_%"]) == held[int(line["row"])][int(line["column"])] for line in lines[:6]),
        "a table", made, lines[:2])
    tap.equal(tool.run("daylight", "room.yaml", "--csv").out.splitlines()[0],
              "grid,column,row,daylight_factor_%,error_%,sky_%,external_%,internal_%", "its heading")
    tap.equal(tool.run("daylight", "room.yaml", "-o", "factors.png").code, 2, "no other ending")
    tap.equal(direct["without_sky"], 0, "sky is seen from all cells")
    high = SCENE % (window, "{type: sky, kind: 5, horizontal: 10000, ground: 1}") + \
        "grids: [{name: top, center: [2000, 2000, 2500], size: [3000, 3000], n: [2, 2]}]\n"
    tool.write("high.yaml", high)
    tap.equal(tool.run("daylight", "high.yaml", "--json").json()["grids"][0]["without_sky"], 1, "the no-sky line")
    lamp = SCENE % ("[]", "{type: ambient, irradiance: 1}") + GRIDS
    tool.write("lamp.yaml", lamp)
    result = tool.run("daylight", "lamp.yaml")
    tap.ok(result.code == 3 and "no sky" in result.err and "type: sky" in result.err, "no sky", result)
    tap.equal(tool.run("daylight", "open.yaml").code, 2, "nothing to find")
    tap.equal(tool.run("daylight", "room.yaml", "--outdoor", "0").code, 2, "no outdoor light")


def outside(tap, tool):
    """A window before an even sky and ground is a panel, whatever the outside of the room has."""
    room = ROOM.replace("{model: lambert}", "{model: lambert, diffuse: .5, over_pi: true}") % \
        "{wall: ceiling, size: [2000, 1000]}"
    sky = SCENE % (room, "{type: sky, kind: 5, zenith: 1000, ground: 1}") + "reflections: all\n"
    panel = SCENE % (room, "{type: planar, rectangle: {center: [2000, 2000, 3000], size: [2000, 1000], "
                     "axis: [0, 0, -1]}, radiance: 1000}") + "reflections: all\n"
    told = []
    for number, scene in enumerate((sky, panel)):
        tool.write("like.yaml", scene)
        result = tool.run("probe", "like.yaml", "--quantity", "irradiance", "--reflected-error", ".1", "--json",
                          "--at", "2000,2000,850,0,0,1", "--at", "10,1000,1200,1,0,0", timeout=200)
        told.append([(point["value"], point["error"]) for point in result.json()["points"]])
    for by_sky, by_panel in zip(*told):
        tap.ok(abs(by_sky[0] - by_panel[0]) <= by_sky[1] + by_panel[1], "the panel", (by_sky, by_panel))
        tap.ok(by_sky[1] <= 2 * by_panel[1], "as exact as that", (by_sky, by_panel))
    # the outside of the room reflects to whoever stands before it, asked for alone or not
    tool.write("like.yaml", sky)
    before = "2000,-500,1000,0,1,0"
    seen = []
    for others in ((), ("--at", "2000,2000,850,0,0,1")):
        point = tool.run("probe", "like.yaml", "--quantity", "irradiance", "--reflected-error", ".1", "--json",
                         "--at", before, *others, timeout=200).json()["points"][0]
        seen.append((point["value"], point["error"]))
        tap.ok(point["reflected"]["value"] > 100, "the outside reflects", point)
    tap.ok(abs(seen[0][0] - seen[1][0]) <= seen[0][1] + seen[1][1], "alone or not", seen)


PEREZ, SUN = "{type: sky, model: perez, extraterrestrial: 1367, %s", "sun: {altitude: 40, azimuth: 120}}"


def weather(tap, tool):
    """The sky of Perez: its level, and that it is brighter on the side of the sun."""
    up, towards, away = (0, 0, 0, 0, 0, 1), (0, 0, 0, .8660254, -.5, 0), (0, 0, 0, -.8660254, .5, 0)
    for direct, diffuse in ((0, 60), (200, 150), (600, 120), (850, 80)):
        source = PEREZ % ("direct: %g, diffuse: %g, " % (direct, diffuse)) + SUN
        level, near, far = light(tool, source, [up, towards, away])
        holds(tap, level, diffuse, "the light of the sky", known=1e-12)
        tap.ok(near[0] > (1.5 if direct > 100 else 1) * far[0], "brighter around the sun", near, far)


def wrong(tap, tool):
    for source, words in (
            ("{type: sky, kind: 12, zenith: 1}", ("sky-needs-sun", "sun: {altitude")),
            ("{type: sky, kind: 17, zenith: 1}", ("16",)),
            ("{type: sky, kind: 5}", ("zenith", "horizontal")),
            ("{type: sky, kind: 5, zenith: 1, horizontal: 1}", ("exclusive",)),
            ("{type: sky, kind: 12, zenith: 1, sun: {altitude: -3, azimuth: 0}}", ("> 0",)),
            ("{type: sky, kind: 12, zenith: 1, sun: {date: 2026-06-21T23:00Z, latitude: 50, longitude: 8}}",
             ("below the horizon",)),
            ("{type: sky}", ("kind", "zenith")),
            (PEREZ % "direct: 600, diffuse: 900, " + SUN, ("perez-range", "from 31.95 to 528.3")),
            (PEREZ % "direct: 1500, diffuse: 100, " + SUN, ("perez-range", "1367")),
            (PEREZ % "direct: 100, diffuse: 20, " + SUN, ("perez-range", "kind of the CIE")),
            (PEREZ % "direct: 100, " + SUN, ("diffuse",)),
            (PEREZ % "direct: 100, diffuse: 20, zenith: 3, " + SUN, ("exclusive",)),
            (PEREZ % "direct: 100, diffuse: 50}", ("sun",)),
            (PEREZ.replace("extraterrestrial: 1367, ", "") % "direct: 900, diffuse: 300, " + SUN,
             ("perez-units", "127500")),
            ("{type: sky, kind: 5, direct: 1, diffuse: 1}", ("perez-only", "model: perez")),
            ("{type: sun, irradiance: 1, date: 2026-06-21T12:00Z}", ("latitude", "longitude")),
            ("{type: sun, irradiance: 1, date: midsummer, latitude: 1, longitude: 1}", ("sun-date", "T12:00")),
            ("{type: sun, irradiance: 1, date: 2026-02-29T12:00Z, latitude: 1, longitude: 1}", ("sun-date",)),
            ("{type: sun, irradiance: 1}", ("altitude", "date")),
            ("{type: sun, irradiance: 1, altitude: 30}", ("azimuth",)),
            ("{type: sun, irradiance: 1, altitude: 3, azimuth: 0, north: [0, 0, 2]}", ("parallel",)),
            ("{type: sky, kind: 5, zenith: 1, ground: 1.5}", ("ground",)),
            ("{wall: left, size: [5000, 100]}", ("opening-beyond", "4000 mm wide and 3000 mm high")),
            ("{wall: front, size: [500, 100], center: [0, 1460]}", ("opening-beyond",)),
            ("{wall: front, size: [500, 100]}, {wall: front, size: [500, 100], center: [10, 90]}",
             ("openings-overlap", "openings[0]")),
            ("{wall: front, size: [500, 100], glass: {transmittance: 0}}", ("transmittance",)),
            ("{wall: front, size: [500, 100], glass: {transmittance: 1.2}}", ("transmittance",)),
            ("{wall: roof, size: [500, 100]}", ("ceiling",))):
        is_window = "wall" in source
        tool.write("sky.yaml", SCENE % (ROOM % source if is_window else "[]",
                                        "{type: sky, kind: 5, zenith: 1}" if is_window else source))
        result = tool.run("check", "sky.yaml", "--json")
        tap.ok(result.code == 3 and all(word in result.out + result.err for word in words), "wrong: " + source, result)


def pictures(tap, tool):
    """Pixels are what probes say."""
    balls = "[{type: sphere, center: [0, 0, 500], radius: 100, material: {diffuse: .7, specular: .3}}, " \
            "{type: rectangle, center: [0, 0, 0], size: [400, 400], material: {model: lambert}}]"
    tool.write("sky.yaml", SCENE % (balls, "{type: sky, kind: 12, sun: {altitude: 40, azimuth: 120}, zenith: 10}"))
    made = tool.run("render", "sky.yaml", "-o", "sky.csv")
    tap.equal(made.code, 0, "a picture")
    at = [(-75., 75.), (25., -25.), (175., 125.)]
    probed = tool.run("probe", "sky.yaml", "--json", *(word for x, y in at for word in ("-p", "%g,%g" % (x, y))))
    with open(tool.file("sky.csv"), encoding="utf-8") as file:
        pixels = {(float(x), float(y)): float(value) for x, y, value in list(csv.reader(file))[1:]}
    for place, point in zip(at, probed.json()["points"]):
        tap.ok(point["value"] > 0, "a pixel shines", point)
        tap.near(pixels[place], point["value"], 1e-6, "a pixel is what a probe says")
    # highlights on a flat thing before parallel lines of sight: in the open one number, less beside a ball
    glossy = "[{type: rectangle, center: [0, 0, 0], size: [4000, 4000], material: {diffuse: .6, specular: .3}}%s]"
    ball = ", {type: sphere, center: [350, 0, 100], radius: 100, material: {model: lambert}}"
    for things, is_open in (("", True), (ball, False)):
        tool.write("gloss.yaml", SCENE % (glossy % things, "{type: sky, kind: 12, sun: {altitude: 40, azimuth: 120}, "
                                          "zenith: 10}"))
        tool.run("render", "gloss.yaml", "-o", "gloss.csv")
        told = tool.run("probe", "gloss.yaml", "--json", "-p", "-75,75", "-p", "25,-25").json()["points"]
        with open(tool.file("gloss.csv"), encoding="utf-8") as file:
            pixels = {(float(x), float(y)): float(value) for x, y, value in list(csv.reader(file))[1:]}
        tap.equal(len(set(pixels.values())) == 1, is_open, "a glossy plane under an open sky has one brightness")
        tap.ok(all(point["lights"][0]["specular"] > 0 for point in told), "with a highlight", told)
        for place, point in zip([(-75., 75.), (25., -25.)], told):
            tap.near(pixels[place], point["value"], 1e-3, "a glossy pixel is what a probe says")
    # a wall with a window sees nothing through that, as exactly as a camera beside it tells its places
    window = SCENE.replace("observer: {z: 9000}", "observer: {position: [3800, 3800, 1700], target: [1500, 500, 1000], "
                           "up: [0, 0, 1], projection: perspective}") % \
        (ROOM % "{wall: front, size: [2000, 1000], center: [0, 900]}", "{type: sky, kind: 16, horizontal: 10000}")
    tool.write("wall.yaml", window)
    told = tool.run("stats", "wall.yaml", "--json").json()
    tap.equal((told["max"]["value"], told["min"]["value"]), (0, 0), "the wall of the window")
    # with all that the room reflects: its outside, which has the whole sky, leaves effort for the inside
    seen = window.replace("position: [3800, 3800, 1700], target: [1500, 500, 1000]",
                          "position: [3600, 3600, 1700], target: [1500, 500, 1000]") + "reflections: all\n"
    tool.write("seen.yaml", seen.replace("{model: lambert}", "{model: lambert, diffuse: .7, over_pi: true}"))
    tap.equal(tool.run("render", "seen.yaml", "-o", "seen.npy", "--reflected-error", ".1").code, 0,
              "the bound that is wanted of a picture of a room with a window")


if __name__ == "__main__":
    run_tests(Tap(), open_skies, suns, roofs, obstacles, windows, at_windows, weather, daylight, outside, wrong,
              pictures)
