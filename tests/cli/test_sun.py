# SPDX-License-Identifier: MIT
"""Hours and patches of sun: against the sun's place second by second, polygons cast by hand, and probed places."""
import csv
import math
import random

import numpy

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
BERLIN = "{type: sun, irradiance: 1, date: '2026-03-21T12:00+01:00', latitude: 52.5, longitude: 13.4, diameter: 0%s}"
ROOM = "{type: room, up: z, center: [2000, 2000, 1500], size: [4000, 4000, 3000], name: hall, openings: [%s]}"


def sun(days, latitude, longitude):
    """The ways to the sun, x east, y north, z up, at days from noon of 1 January 2000, by the Astronomical Almanac."""
    anomaly = numpy.radians(357.528 + .9856003 * days)
    along = numpy.radians(280.460 + .9856474 * days + 1.915 * numpy.sin(anomaly) + .020 * numpy.sin(2 * anomaly))
    tilt = numpy.radians(23.439 - .0000004 * days)
    x, y, z = numpy.cos(along), numpy.cos(tilt) * numpy.sin(along), numpy.sin(tilt) * numpy.sin(along)
    turned = numpy.radians(280.46062 + 360.98564737 * days + longitude)
    outwards, east = x * numpy.cos(turned) + y * numpy.sin(turned), y * numpy.cos(turned) - x * numpy.sin(turned)
    north = math.radians(latitude)
    return numpy.stack([east, z * math.cos(north) - outwards * math.sin(north),
                        z * math.sin(north) + outwards * math.cos(north)], -1)


def ways(day, offset, seconds, latitude=52.5, longitude=13.4):
    """`day`: how many days after 1 January 2000."""
    return sun(day - .5 + (seconds - offset * 3600) / 86400, latitude, longitude)


def hidden_by_box(place, towards, low, high):
    with numpy.errstate(divide="ignore", invalid="ignore"):
        ends = [(numpy.array(end) - place) / towards for end in (low, high)]
    near, far = numpy.minimum(*ends).max(-1), numpy.maximum(*ends).min(-1)
    return (near < far) & (far > 1e-9)


def hidden_by_ball(place, towards, center, radius):
    offset = numpy.array(center) - place
    along = towards @ offset
    return (along > 0) & (offset @ offset - along ** 2 < radius ** 2)


def hidden_by_rectangle(place, towards, axis, at, low, high):
    """One across an axis; low and high along the two others."""
    with numpy.errstate(divide="ignore", invalid="ignore"):
        t = (at - place[axis]) / towards[:, axis]
    others = [k for k in range(3) if k != axis]
    inside = t > 1e-9
    for k, least, most in zip(others, low, high):
        met = place[k] + t * towards[:, k]
        inside &= (met > least) & (met < most)
    return inside


def ask(tool, surfaces, places, date="2026-03-21+01:00", light=BERLIN % "", options=()):
    tool.write("sun.yaml", SCENE % (surfaces, light))
    at = [word for place in places for word in ("--at", ",".join("%.17g" % part for part in place))]
    made = tool.run("daylight", "sun.yaml", "--sun-hours", date, "--json", *at, *options)
    assert made.code == 0, str(made)
    return made.json()


def spans_of(lit):
    """Beginnings and ends of what is lit second by second."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate([[0], lit.astype(int), [0]])))
    return list(zip(edges[::2], edges[1::2]))


def agrees(tap, told, lit, name):
    """Spans against seconds 0 to 86399: each end lies in the second before the lit one, or the last lit one."""
    spans, truth = [(span["from_s"], span["to_s"]) for span in told["spans"]], spans_of(lit)
    tap.ok(len(spans) == len(truth) and all(
        first - 1.01 <= found[0] <= first + .01 and last - 1.01 <= found[1] <= last + .01
        for found, (first, last) in zip(spans, truth)), name, spans, truth)
    tap.ok(abs(told["hours"] * 3600 - sum(last - first for first, last in spans)) < 1e-6, name + ": together", told)


DAYS = {"2026-03-21": 9576, "2026-06-21": 9668, "2026-02-01": 9528, "2026-12-21": 9851}


def hours(tap, tool):
    """Boxes, a ball, a plate and a window, against rays to the sun in each second of the day."""
    seconds = numpy.arange(86400.)
    surfaces = "[" + ", ".join((
        "{type: box, center: [2000, -6000, 2000], size: [3000, 1000, 4000], material: {model: lambert}}",
        "{type: box, center: [9000, -4000, 3000], size: [1000, 2000, 6000], material: {model: lambert}}",
        "{type: sphere, center: [-3000, -4000, 3500], radius: 800}",
        "{type: rectangle, center: [2000, -500, 3100], size: [5000, 1000], axis: [0, 0, -1]}",
        ROOM % "{wall: front, center: [300, 100], size: [2200, 1500], glass: {}}")) + "]"
    inside, outside = (2000., 700., 800.), (2500., -40., 1300.)
    places = [(*inside, 0, 0, 1), (*outside, 0, -1, 0), (*inside, 0, -1, 0), (*outside, 0, 1, 0)]
    for date, day in DAYS.items():
        told = ask(tool, surfaces, places, date + "+01:00")
        towards = ways(day, 1, seconds)
        up = towards[:, 2] > 0
        agrees(tap, told["open"], up, date + ", the open sky")
        for place, element in zip(places, told["elements"]):
            at, normal = numpy.array(place[:3]), numpy.array(place[3:])
            lit = up & (towards @ normal > 0) & ~hidden_by_box(at, towards, (500, -6500, 0), (3500, -5500, 4000)) & \
                ~hidden_by_box(at, towards, (8500, -5000, 0), (9500, -3000, 6000)) & \
                ~hidden_by_ball(at, towards, (-3000, -4000, 3500), 800) & \
                ~hidden_by_rectangle(at, towards, 2, 3100, (-500, -1000), (4500, 0))
            if at[1] > 0:  # through the window, whose width runs to the right as seen from inside: against x
                lit &= hidden_by_rectangle(at, towards, 1, 0, (600, 850), (2800, 2350))
            elif normal[1] > 0:
                lit &= ~hidden_by_box(at, towards, (0, 0, 0), (4000, 4000, 3000))
            agrees(tap, element, lit, "%s at %s" % (date, place))
    # a wall to the south at the equinox, and far north in summer and winter
    wall, = ask(tool, "[]", [(0, 0, 0, 0, -1, 0)])["elements"]
    towards = ways(DAYS["2026-03-21"], 1, seconds)
    agrees(tap, wall, (towards[:, 2] > 0) & (towards[:, 1] < 0), "a wall to the south")
    north = ("--location", "75,20")
    told = ask(tool, "[]", [(0, 0, 0, 0, 0, 1)], "2026-06-21", options=north)
    tap.equal((told["open"]["hours"], told["latitude"], told["open"]["spans"][0]["to"]), (24, 75, "24:00:00"), "a day")
    told = ask(tool, "[]", [(0, 0, 0, 0, 0, 1)], "2026-12-21", options=north)
    tap.equal((told["open"]["hours"], told["elements"][0]["spans"]), (0, []), "a night")
    # no lower than so many degrees; and where y is up and north is where -x is
    told = ask(tool, "[]", [(0, 0, 0, 0, 0, 1)], "2026-06-21+01:00", options=("--least-altitude", "25"))
    towards = ways(DAYS["2026-06-21"], 1, seconds)
    agrees(tap, told["elements"][0], towards[:, 2] > math.sin(math.radians(25)), "above 25 degrees")
    turned = ask(tool, "[]", [(0, 0, 0, 1, 0, 0)], light=BERLIN % ", up: [0, 1, 0], north: [-1, 0, 0]")
    tap.near(turned["elements"][0]["hours"], wall["hours"], 1e-6, "another way up")


def levels(tap, tool):
    """EN 17037: 1.5, 3 and 4 hours, from 1 February to 21 March; grids, tables and text."""
    grids = "grids: [{name: desk, center: [2000, 1000, 850], size: [1000, 1000], n: [2, 2]}]\n"
    room = "[" + ROOM % "{wall: front, size: [2000, 1000]}" + "]"
    tool.write("grid.yaml", SCENE % (room, BERLIN % "") + grids)
    places = ("--at", "2000,-1,1500,0,-1,0", "--at", "2000,3000,850,0,0,-1")
    told = tool.run("daylight", "grid.yaml", "--sun-hours", "2026-03-21+01:00", "--json", *places).json()
    cells = [cell for row in told["grids"][0]["cells"] for cell in row]
    for one in cells + told["elements"]:
        kept = sum(one["hours"] >= least for least in (1.5, 3, 4))
        tap.equal(one["en17037"], ("none", "minimum", "medium", "high")[kept], "what %.2f h keep" % one["hours"])
    tap.equal([one["en17037"] for one in told["elements"]], ["high", "none"], "before the wall, and from below")
    for date, has_level in (("2026-01-31", False), ("2026-02-01", True), ("2026-03-22", False)):
        told = tool.run("daylight", "grid.yaml", "--sun-hours", date, "--json").json()
        tap.equal(told["open"]["en17037"] is not None, has_level, "a level on " + date)
    made = tool.run("daylight", "grid.yaml", "--sun-hours", "2026-03-21+01:00", "-o", "sun.csv", *places)
    with open(tool.file("sun.csv"), encoding="utf-8", newline="") as file:
        lines = list(csv.DictReader(file))
    tap.ok(made.code == 0 and len(lines) == 6 and lines[4]["grid"] == "P1" and lines[4]["en17037"] == "high" and
           [float(line["sun_h"]) for line in lines[:4]] == [cell["hours"] for cell in cells] and
           lines[5]["span1"] == "", "a table", lines)
    text = tool.run("daylight", "grid.yaml", "--sun-hours", "2026-03-21+01:00", *places)
    first = cells[0]["spans"][0] if cells[0]["spans"] else {"from": "", "to": ""}
    tap.ok(text.code == 0 and all(word in text.out for word in ("desk", "EN 17037", "never", "high", "52.5")),
           "as text", text, first)


def cast(tap, tool):
    """A window cast by hand onto the floor, a wall and a table, and less the shadow of a box."""
    light = "{type: sun, irradiance: 1, altitude: 45, azimuth: 180, diameter: 0}"
    window = ROOM % "{wall: front, size: [2000, 1000]}, {wall: back, size: [500, 500]}"

    def found(surfaces, source=light):
        tool.write("cast.yaml", SCENE % (surfaces, source))
        return tool.run("daylight", "cast.yaml", "--sun-patches", "--json").json()

    told = found("[%s]" % window)
    patch, = told["patches"]
    tap.near(told["altitude"], 45, 1e-12, "its altitude")
    tap.ok((patch["surface"], patch["part"], patch["room"], patch["opening"], patch["others"]) ==
           (0, "floor", 0, 0, []), "one patch, on the floor", patch)
    corners = [(1000, 1000, 0), (3000, 1000, 0), (3000, 2000, 0), (1000, 2000, 0)]
    tap.ok(len(patch["corners_mm"]) == 4 and all(any(math.dist(corner, one) < 1e-9 for one in patch["corners_mm"])
                                                  for corner in corners), "its corners", patch)
    tap.near(patch["area_m2"], 2, 1e-12, "its area")
    a, b, c = patch["corners_mm"][:3]
    tap.ok((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0, "counter-clockwise", patch)
    # the sun so low that the light falls on the far wall, by tan 10 degrees times 4 m lower
    low = found("[%s]" % window, light.replace("45", "10"))["patches"]
    drop = 4000 * math.tan(math.radians(10))
    gap = .5 * (2 - drop / 1000 - 1.25)  # what of it goes out through the other window
    tap.ok(all(one["part"] == "back" for one in low), "on the wall", low)
    tap.near(sum(one["area_m2"] for one in low), 2 - gap, 1e-9, "its area, less the other window")
    heights = sorted({round(corner[2], 6) for one in low for corner in one["corners_mm"]})
    tap.ok(abs(heights[0] - (1000 - drop)) < 1e-5 and abs(heights[-1] - (2000 - drop)) < 1e-5, "its heights", heights)
    # a table whose shadow lies beside it
    table = "{type: rectangle, center: [2000, 1000, 700], size: [1000, 800], axis: [0, 0, 1], name: table}"
    patches = found("[%s, %s]" % (window, table))["patches"]
    on_table = [one for one in patches if one["name"] == "table"]
    on_floor = [one for one in patches if one["part"] == "floor"]
    # at the height 700 the light reaches from y = 300 to 1300, and the table from 600 to 1400
    tap.near(sum(one["area_m2"] for one in on_table), .7, 1e-12, "on the table")
    tap.near(sum(one["area_m2"] for one in on_floor), 1.3, 1e-12, "beside its shadow")
    ball = "{type: sphere, center: [2000, 1500, 300], radius: 100}, {type: sphere, center: [500, 3500, 300], radius: 9}"
    patch, = found("[%s, %s]" % (window, ball))["patches"]
    tap.equal(patch["others"], [1], "a ball in the light, not one beside it")


def lit_places(tap, tool):
    """Random places of rooms and plates are lit by the sun exactly where a patch has them."""
    draw = random.Random(20260321)
    for _ in range(6):
        boxes = ", ".join("{type: box, center: [%g, %g, %g], size: [%g, %g, %g]}" % (
            draw.uniform(600, 3400), draw.uniform(600, 3400), 300, *(draw.uniform(200, 900) for _ in range(2)), 600)
            for _ in range(3))
        plates = ", ".join("{type: rectangle, center: [%g, %g, %g], size: [%g, %g], axis: [%g, %g, %g]}" % (
            draw.uniform(0, 4000), draw.uniform(-2500, -500), draw.uniform(500, 3500), draw.uniform(300, 1500),
            draw.uniform(300, 1500), *(draw.uniform(-1, 1) for _ in range(3))) for _ in range(3))
        window = ROOM % "{wall: front, center: [-700, 0], size: [1200, 1500]}, {wall: right, size: [2000, 1000]}, " \
            "{wall: front, center: [1000, 0], size: [900, 1900]}"
        light = "{type: sun, irradiance: 1, altitude: %g, azimuth: %g, diameter: 0}" % (
            draw.uniform(15, 65), draw.uniform(95, 200))
        tool.write("lit.yaml", SCENE % ("[%s, %s, %s]" % (window, boxes, plates), light))
        patches = tool.run("daylight", "lit.yaml", "--sun-patches", "--json").json()["patches"]
        floor = [one["corners_mm"] for one in patches if one["part"] == "floor"]
        places = [(draw.uniform(0, 4000), draw.uniform(0, 4000)) for _ in range(300)]
        at = "x,y,z,nx,ny,nz\n" + "".join("%.17g,%.17g,0,0,0,1\n" % place for place in places)
        tool.write("at.csv", at)
        probed = tool.run("probe", "lit.yaml", "--quantity", "irradiance", "--json", "--points", "at.csv").json()
        wrong = count = 0
        for (x, y), point in zip(places, probed["points"]):
            inside = any(all((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0
                             for a, b in zip(corners, corners[1:] + corners[:1])) for corners in floor)
            wrong += inside != (point["value"] > 0)
            count += inside
        tap.ok(wrong == 0 and count > 0, "places of the floor", wrong, count, light)


def refused(tap, tool):
    tool.write("none.yaml", SCENE % ("[]", "{type: sky, kind: 16, zenith: 1}"))
    tool.write("sun.yaml", SCENE % ("[]", BERLIN % ""))
    at = ("--at", "0,0,0,0,0,1")
    for scene, options, code, words in (
            ("none.yaml", ("--sun-hours", "2026-03-21", *at), 2, ("no light of the scene", "--location")),
            ("none.yaml", ("--sun-patches",), 3, ("no sun", "type: sun")),
            ("sun.yaml", ("--sun-hours", "2026-02-29", *at), 2, ("2026-02-29", "2026-03-21+01:00")),
            ("sun.yaml", ("--sun-hours", "2026-03-21T12:00", *at), 2, ("2026-03-21T12:00",)),
            ("sun.yaml", ("--sun-hours", "midsummer", *at), 2, ("midsummer",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21"), 2, ("no measuring grids",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21", "--location", "91,0", *at), 2, ("-90 to 90",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21", "--location", "9", *at), 2, ("LATITUDE,LONGITUDE",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21", "--least-altitude", "91", *at), 2, ("0 to 90",)),
            ("sun.yaml", ("--least-altitude", "9", *at), 2, ("--sun-hours",)),
            ("sun.yaml", ("--location", "9,9", *at), 2, ("--sun-hours",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21", "--outdoor", "9", *at), 2, ("--outdoor",)),
            ("sun.yaml", ("--sun-hours", "2026-03-21", "--sun-patches"), 2, ("--sun-patches",)),
            ("sun.yaml", ("--sun-patches", *at), 2, ("--at",))):
        result = tool.run("daylight", scene, *options)
        tap.ok(result.code == code and all(word in result.err for word in words), "wrong: %s" % (options,), result)
    # a sky without a sun tells the ways, a place from the command line the rest
    told = tool.run("daylight", "none.yaml", "--sun-hours", "2026-06-21", "--location", "0,0", "--json", *at).json()
    tap.ok(abs(told["open"]["hours"] - 12) < .1, "a sky of its own", told)


if __name__ == "__main__":
    run_tests(Tap(), hours, levels, cast, lit_places, refused)
