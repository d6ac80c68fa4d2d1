# SPDX-License-Identifier: MIT
"""Unified glare rating of luminaires in standard rooms, against a calculation of its own: Lambertian flux on rectangles
in closed form, form factors of walls one by one, bounces one by one, and the plain sum over the luminaires.  Only the
numbers of the table of CIE 117 are read from the source; tests/unit/test_glare.c compares them with the fit."""
import math
import os
import re

from luminaires import HEAD
from tap import Tap
from tool import run_tests

ROOMS = ((2, 2), (2, 3), (2, 4), (2, 6), (2, 8), (2, 12), (4, 2), (4, 3), (4, 4), (4, 6), (4, 8), (4, 12), (8, 4),
         (8, 6), (8, 8), (8, 12), (12, 4), (12, 6), (12, 8))
REFLECTANCES = ((.7, .5, .2), (.7, .3, .2), (.5, .5, .2), (.5, .3, .2), (.3, .3, .2))  # ceiling, walls, floor


def lamp(intensity, opening=".4 1.2 0", step=1, planes=(0, 22.5, 45, 67.5, 90)):
    """A file with I(C, gamma); width and length of the opening in metres."""
    angles = range(0, 91, step)
    rows = (" ".join(repr(intensity(c, gamma)) for gamma in angles) for c in planes)
    return HEAD + "1 -1 1 %d %d 1 2 %s\n1 1 10\n%s\n%s\n%s\n" % (
        len(angles), len(planes), opening, " ".join(map(str, angles)), " ".join(map(str, planes)), "\n".join(rows))


def lambert(_, gamma):
    return 1000 * max(0, math.cos(math.radians(gamma)))


def read_indices():
    source = os.path.join(os.path.dirname(__file__), "..", "..", "src", "base", "glare.c")
    with open(source, encoding="utf-8") as file:
        rows = re.findall(r"^    \{([\d, ]+)\}", file.read(), re.MULTILINE)
    return [[int(number) / 100 for number in row.split(",")] for row in rows]


INDICES = read_indices()  # aside / ahead by above / ahead, in tenths; 0: none


def index(ahead, aside, above):
    """The position index, linear along a row and then between two; None where the table has none."""
    row, column = round(10 * abs(aside) / ahead, 9), round(10 * above / ahead, 9)
    if row > 30 or column > 19:
        return None

    def along(numbers):
        here, share = int(column), column % 1
        used = numbers[here:here + (2 if share else 1)]
        return None if 0 in used else used[0] + share * (used[-1] - used[0])

    found = [along(numbers) for numbers in INDICES[int(row):math.ceil(row) + 1]]
    return None if None in found else found[0] + row % 1 * (found[-1] - found[0])


def on_corner(a, b):
    """The share of Lambertian light from a point on the axis of a corner that falls on a rectangle 1 away."""
    p, q = math.sqrt(1 + a * a), math.sqrt(1 + b * b)
    return (a / p * math.atan(b / p) + b / q * math.atan(a / q)) / (2 * math.pi)


def next_to(length, depth, height):
    """The form factor of a floor to the wall on one of its sides of that length."""
    h, w = height / length, depth / length
    s = h * h + w * w
    logs = ((1 + w * w) * (1 + h * h) / (1 + s) * (w * w * (1 + s) / ((1 + w * w) * s)) ** (w * w) *
            (h * h * (1 + s) / ((1 + h * h) * s)) ** (h * h))
    return (w * math.atan(1 / w) + h * math.atan(1 / h) - math.sqrt(s) * math.atan(1 / math.sqrt(s)) +
            math.log(logs) / 4) / (math.pi * w)


def background(x, y, spacing, reflectances):
    """Lb under Lambertian luminaires of 1000 cd."""
    nx, ny = round(x / spacing), round(y / spacing)
    places = [(i + .5) * spacing for i in range(nx)], [(j + .5) * spacing for j in range(ny)]
    share = sum(on_corner(a, b) + on_corner(x - a, b) + on_corner(a, y - b) + on_corner(x - a, y - b)
                for a in places[0] for b in places[1])
    flux = 1000 * math.pi
    floor, walls = x * y, 2 * (x + y)
    to_walls = 2 * next_to(x, y, 1) + 2 * next_to(y, x, 1)
    ceiling_light, wall_light, floor_light = 0, flux * (nx * ny - share), flux * share  # lumens that arrive
    indirect = 0
    for _ in range(400):
        from_ceiling, from_walls, from_floor = (a * b for a, b in
                                                zip(reflectances, (ceiling_light, wall_light, floor_light)))
        up = to_walls * floor / walls  # of the walls to the floor, and to the ceiling
        ceiling_light = from_walls * up + from_floor * (1 - to_walls)
        floor_light = from_walls * up + from_ceiling * (1 - to_walls)
        wall_light = (from_ceiling + from_floor) * to_walls + from_walls * (1 - 2 * up)
        indirect += wall_light
    return indirect / walls / math.pi


def glare(x, y, spacing, intensity, area, turn):
    """The sum over the luminaires that are seen; area(C, gamma) as it is seen."""
    total = 0
    for i in range(round(x / spacing)):
        for j in range(round(y / spacing)):
            aside, ahead = (i + .5) * spacing - x / 2, (j + .5) * spacing
            gamma = math.degrees(math.atan(math.hypot(aside, ahead)))
            p = index(ahead, aside, 1)
            if gamma > 85.5 or p is None:
                continue
            c = turn + math.degrees(math.atan(abs(aside) / ahead)) * (-1 if turn else 1)
            total += intensity(c, gamma) ** 2 / area(c, gamma) / (1 + aside ** 2 + ahead ** 2) / p ** 2
    return total


def compare(tap, about, spacing, intensity, area, allowed, name):
    worst = 0
    for (x, y), room in zip(ROOMS, about["ugr"]["rooms"]):
        tap.ok((room["across"], room["along"]) == (x, y), "the room is %gH by %gH" % (x, y))
        for way, turn in (("crosswise", 0), ("endwise", 90)):
            total = glare(x, y, spacing, intensity, area, turn)
            for reflectances, rating in zip(REFLECTANCES, room[way]):
                expected = 8 * math.log10(.25 / background(x, y, spacing, reflectances) * total)
                worst = max(worst, abs(rating - expected))
    tap.ok(worst < allowed, name, worst)


def rooms(tap, tool):
    flat = lambda c, gamma: .4 * 1.2 * math.cos(math.radians(gamma))
    tool.write("lamp.ies", lamp(lambert))
    about = tool.run("photometry", "lamp.ies", "--json").json()
    tap.equal(about["ugr"]["spacing"], .25, "the spacing of catalogues")
    tap.equal([(r["ceiling"], r["walls"], r["floor"]) for r in about["ugr"]["reflectances"]], list(REFLECTANCES),
              "reflectances")
    compare(tap, about, .25, lambert, flat, .002, "a Lambertian panel, 0.25 of its height apart")
    about = tool.run("photometry", "lamp.ies", "--json", "--spacing", "1").json()
    compare(tap, about, 1, lambert, flat, .002, "a Lambertian panel, as far apart as it is high")
    # Its mean over C is Lambertian, as far as trapezoids of 22.5 degrees go, which is exact for cos 2C.
    uneven = lambda c, gamma: lambert(c, gamma) * (1 + .5 * math.cos(math.radians(2 * c)))
    tool.write("uneven.ies", lamp(uneven, step=1, planes=[3 * i for i in range(31)]))
    about = tool.run("photometry", "uneven.ies", "--json", "--spacing", "0.5").json()
    compare(tap, about, .5, uneven, flat, .02, "one that shines along C0-C180: crosswise is not endwise")
    box = lambda c, gamma: (flat(c, gamma) + .1 * math.sin(math.radians(gamma)) * (
        .4 * abs(math.cos(math.radians(c))) + 1.2 * abs(math.sin(math.radians(c)))))
    tool.write("box.ies", lamp(lambert, ".4 1.2 .1"))
    about = tool.run("photometry", "box.ies", "--json", "--spacing", "0.5").json()
    compare(tap, about, .5, lambert, box, .002, "a box with luminous sides")
    disk = lambda c, gamma: math.pi * .09 * math.cos(math.radians(gamma))
    tool.write("disk.ies", lamp(lambert, "-.6 -.6 0"))
    about = tool.run("photometry", "disk.ies", "--json", "--spacing", "0.5").json()
    compare(tap, about, .5, lambert, disk, .002, "a disk")
    tool.write("brighter.ies", lamp(lambda c, gamma: 10 * lambert(c, gamma), "-.6 -.6 0"))
    brighter = tool.run("photometry", "brighter.ies", "--json", "--spacing", "0.5").json()["ugr"]["rooms"]
    tap.near(brighter[7]["endwise"][2] - about["ugr"]["rooms"][7]["endwise"][2], 8, 1e-9, "ten times the light")


def patches(size, count):
    """The middles, normals, areas and walls of count x count patches on each face of a box (0, 0, 0) to `size`."""
    found = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, 1):
            normal = [0, 0, 0]
            normal[axis] = 1 - 2 * end
            for i in range(count):
                for j in range(count):
                    middle = [0, 0, 0]
                    middle[axis] = end * size[axis]
                    middle[u], middle[v] = (i + .5) / count * size[u], (j + .5) / count * size[v]
                    found.append((middle, normal, size[u] * size[v] / count ** 2, 2 * axis + end))
    return found


def exact_background(size, lamps, reflectances, count=7):
    """The mean indirect illuminance of the walls over pi under Lambertian lamps of 1000 cd, patch by patch: each pair
    by its middles, and each row of factors made to add up to 1."""
    found = patches(size, count)
    rho = [reflectances[1]] * 4 + [reflectances[2], reflectances[0]]
    rows, direct = [], []
    for place, normal, _, face in found:
        row = []
        for other, axis, area, from_face in found:
            way = [b - a for a, b in zip(place, other)]
            squared = sum(x * x for x in way)
            here, there = sum(a * b for a, b in zip(way, normal)), -sum(a * b for a, b in zip(way, axis))
            row.append(0 if face == from_face else here * there * area / squared ** 2)
        rows.append([x / sum(row) for x in row])
        light = 0
        for lamp in lamps:
            way = [b - a for a, b in zip(place, lamp)]
            squared = sum(x * x for x in way)
            light += 1000 * max(0, way[2]) * max(0, sum(a * b for a, b in zip(way, normal))) / squared ** 2
        direct.append(light)
    light = direct
    for _ in range(25):
        sent = [rho[patch[3]] * x for patch, x in zip(found, light)]
        light = [x + sum(a * b for a, b in zip(row, sent)) for x, row in zip(direct, rows)]
    walls = [(patch[2], a - b) for patch, a, b in zip(found, light, direct) if patch[3] < 4]
    return sum(a * b for a, b in walls) / sum(a for a, _ in walls) / math.pi


def one_room(tap, tool):
    tool.write("lamp.ies", lamp(lambert))
    about = tool.run("photometry", "lamp.ies", "--json", "--spacing", "1", "--room", "2,2", "-q").json()["ugr"]
    room, table = about["room"], about["rooms"][0]
    tap.equal((room["across"], room["along"]), (2, 2), "the room")
    lamps = [(x, y, 1) for x in (.5, 1.5) for y in (.5, 1.5)]
    for i, reflectances in enumerate(REFLECTANCES):
        light, told = room["background"][i], background(2, 2, 1, reflectances)
        truth = exact_background((2, 2, 1), lamps, reflectances)
        tap.near(room["background_by_table"][i], told, 1e-4, "the table's background")
        tap.ok(abs(light["value"] - truth) < light["error"] + .01 * truth and light["error"] < .03 * truth,
               "the background by reflections", light, truth)
        for way in ("crosswise", "endwise"):
            tap.near(room[way][i] - table[way][i], 8 * math.log10(told / light["value"]), 1e-2, way)
        tap.near(room["error"][i], -8 * math.log10(1 - light["error"] / light["value"]), 1e-12, "its error")
    lines = tool.run("photometry", "lamp.ies", "--spacing", "1", "--room", "2,2", "-q").out
    tap.ok("2H × 2H by the light that its walls really reflect" in lines and "%.2f" % room["endwise"][0] in lines,
           "text", lines[-900:])
    tool.write("up.ies", HEAD + "1 -1 1 3 1 1 2 .4 .4 0\n1 1 10\n0 90 180\n0\n9 9 9\n")
    tool.write("point.ies", lamp(lambert, "0 0 0"))
    for name, room, word in (("lamp.ies", "3,3", "such as 4 and 8"), ("lamp.ies", "4", "--room"),
                             ("up.ies", "4,8", "upwards"), ("point.ies", "4,8", "a point"),
                             ("-", "4,8", "standard input")):
        result = tool.run("photometry", name, "--room", room, stdin=lamp(lambert) if name == "-" else None)
        tap.ok(result.code == 2 and word in result.err and not result.out, "%s, --room %s" % (name, room), result)


def texts(tap, tool):
    tool.write("lamp.ies", lamp(lambert))
    table = tool.run("photometry", "lamp.ies", "--json").json()["ugr"]["rooms"]
    lines = tool.run("photometry", "lamp.ies").out.splitlines()
    row = [line for line in lines if line.split()[:3] == ["4H", "×", "8H"]]
    tap.equal(row[0].split()[3:], ["%.1f" % value for way in ("crosswise", "endwise") for value in table[10][way]],
              "a room of the table")
    tap.ok(any(line.split() == ["walls,", "%"] + ["50", "30", "50", "30", "30"] * 2 for line in lines), "walls", lines)
    tool.write("point.ies", lamp(lambert, "0 0 0"))
    tap.equal(tool.run("photometry", "point.ies", "--json").json()["ugr"], None, "a point has no luminance")
    tap.ok("UGR" not in tool.run("photometry", "point.ies").out, "and no table")
    tool.write("up.ies", lamp(lambda c, gamma: 0))
    result = tool.run("photometry", "up.ies", "--json")
    tap.equal(result.json()["ugr"]["rooms"][0]["crosswise"], [None] * 5, "a lamp that is dark below dazzles nobody")
    for spacing in ("0.3", "0", "-1", "2", "x"):
        result = tool.run("photometry", "lamp.ies", "--spacing", spacing)
        tap.ok(result.code == 2 and "--spacing" in result.err, "no spacing: " + spacing, result.err)


if __name__ == "__main__":
    run_tests(Tap(), rooms, one_room, texts)
