# SPDX-License-Identifier: MIT
"""Areas around a task area: their averages, uniformity and limits against sums by hand, and what is refused."""
import json
import math

from tap import Tap
from tool import run_tests

SCREEN = {"luxel": 1, "units": "photometric", "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]},
          "observer": {"z": 9000}}
LAMPS = [((-2000, 500, 2800), 1200), ((1500, -700, 2800), 900)]
LIGHTS = [{"type": "point", "position": list(place), "intensity": intensity} for place, intensity in LAMPS]
HALL = {"type": "room", "center": [0, 0, 1500], "size": [8000, 6000, 3000], "up": "z",
        "material": {"model": "lambert", "over_pi": True, "diffuse": 0.5}}
TASK = {"name": "desk", "center": [-2500, 1000, 750], "size": [1600, 800], "n": [4, 2], "surround": 500,
        "background": 3000}


def scene(grid, *surfaces, **more):
    return json.dumps({**SCREEN, "surfaces": surfaces, "lights": LIGHTS, "grids": [grid], **more})


def illuminance(place, normal):
    total = 0.0
    for lamp, intensity in LAMPS:
        way = [a - b for a, b in zip(lamp, place)]
        total += 1e6 * intensity * max(0, sum(a * b for a, b in zip(way, normal))) / math.hypot(*way) ** 3
    return total


def spacing(width):
    """EN 12464-1:2011, 4.4, of a long strip: by its width; mm."""
    return 200 * 5 ** math.log10(width / 1000)


def sum_strip(task, inner, width, walls, across=(1, 0, 0), up=(0, 1, 0)):
    """Number, average and U0 of the cells in the strip around `inner`, and the rectangle around that."""
    outer = [[max(inner[k][0] - width, walls[k][0]), min(inner[k][1] + width, walls[k][1])] for k in (0, 1)]
    n = [math.ceil((high - low) / spacing(width) * (1 - 1e-9)) for low, high in outer]
    normal = [across[(i + 1) % 3] * up[(i + 2) % 3] - across[(i + 2) % 3] * up[(i + 1) % 3] for i in range(3)]
    values = []
    for row in range(n[1]):
        for column in range(n[0]):
            u, v = (low + (high - low) * (cell + 0.5) / count
                    for (low, high), cell, count in zip(outer, (column, row), n))
            if not (inner[0][0] <= u <= inner[0][1] and inner[1][0] <= v <= inner[1][1]):
                place = [c + u * a + v * b for c, a, b in zip(task["center"], across, up)]
                values.append(illuminance(place, normal))
    return len(values), math.fsum(values) / len(values), min(values) * len(values) / math.fsum(values), outer, n


def measure(tool, text, *options):
    result = tool.run("grid", "-", "--json", *options, stdin=text)
    assert result.code == 0, result
    return result.json()["grids"][0]


def sums(tap, tool):
    """In a room, whose walls cut both strips at the left and at the back."""
    found = measure(tool, scene(TASK, {**HALL, "size": [7000, 4000, 3000]}))
    inner, walls = [[-800, 800], [-400, 400]], [[-1000, 6000], [-3000, 1000]]
    for key, width in (("surround", 500), ("background", 3000)):
        count, average, u0, outer, n = sum_strip(TASK, inner, width, walls)
        area = found[key]
        tap.equal((area["measured"], area["n"]), (count, n), "cells of the " + key)
        tap.near(area["average"], average, 1e-13, "its average", area["average_error"])
        tap.near(area["u0"], u0, 1e-13, "and its uniformity")
        tap.equal([area["center"][k] - TASK["center"][k] for k in (0, 1)], [sum(side) / 2 for side in outer], "middle")
        tap.equal(area["size"], [high - low for low, high in outer], "and size of the rectangle around it")
        inner = [[low - width, high + width] for low, high in inner]
    plain = measure(tool, scene({key: value for key, value in TASK.items() if key not in ("surround", "background")},
                                {**HALL, "size": [7000, 4000, 3000]}))
    tap.equal({key: value for key, value in found.items() if key not in ("surround", "background")}, plain,
              "the task area is what it is without")
    open_air = measure(tool, scene(TASK))
    count, average, *_ = sum_strip(TASK, [[-800, 800], [-400, 400]], 500, [[-math.inf, math.inf]] * 2)
    tap.equal(open_air["surround"]["measured"], count, "without walls the strip is whole")
    tap.near(open_air["surround"]["average"], average, 1e-13, "and so is its average")


def on_a_wall(tap, tool):
    """A board on the wall: across and up are others, and the floor cuts the strips."""
    board = {"name": "board", "center": [0, 3000, 1200], "size": [3000, 1200], "axis": [0, -1, 0], "up": [0, 0, 1],
             "n": [3, 2], "surround": 700}
    found = measure(tool, scene(board, HALL))
    count, average, u0, *_ = sum_strip(board, [[-1500, 1500], [-600, 600]], 700, [[-4000, 4000], [-1200, 1800]],
                                       (1, 0, 0), (0, 0, 1))
    tap.equal((found["surround"]["measured"], "background" in found), (count, False), "cells, and no background")
    tap.near(found["surround"]["average"], average, 1e-12, "average on a wall")
    tap.near(found["surround"]["u0"], u0, 1e-12, "U0 on a wall")
    turned = {**TASK, "up": [3, 4, 0], "center": [-3300, 2400, 750]}
    area = measure(tool, scene(turned, HALL))["surround"]
    tap.ok(0 < area["measured"] < area["n"][0] * area["n"][1] / 2, "a desk askew in a corner", area)
    cells = measure(tool, scene({**turned, "center": area["center"], "size": area["size"], "n": area["n"],
                                 "surround": 500, "background": 100}))
    up, across = (0.6, 0.8), (0.8, -0.6)
    values = []
    for row in range(area["n"][1]):
        for column in range(area["n"][0]):
            u = area["size"][0] * ((column + 0.5) / area["n"][0] - 0.5)
            v = area["size"][1] * (0.5 - (row + 0.5) / area["n"][1])
            x, y = (area["center"][k] + u * across[k] + v * up[k] for k in (0, 1))
            if (abs(u) > 800 or abs(v) > 400) and abs(x) < 4000 and abs(y) < 3000:
                values.append(cells["values"][row][column])
    tap.equal(area["measured"], len(values), "its cells in the room")
    tap.near(area["average"], math.fsum(values) / len(values), 1e-12, "and their average")


def with_reflections(tap, tool):
    """What surfaces reflect is in the areas as it is in grids of the same cells."""
    bright = ("--reflected-error", "0.005")
    area = measure(tool, scene({**TASK, "background": 100}, HALL, reflections="all"), *bright)["surround"]
    cells = measure(tool, scene({"center": area["center"], "size": area["size"], "n": area["n"]}, HALL,
                                reflections="all"), *bright)
    values, errors = [], []
    for row in range(area["n"][1]):
        for column in range(area["n"][0]):
            u = area["center"][0] - TASK["center"][0] + area["size"][0] * ((column + 0.5) / area["n"][0] - 0.5)
            v = area["center"][1] - TASK["center"][1] + area["size"][1] * (0.5 - (row + 0.5) / area["n"][1])
            if abs(u) > 800 or abs(v) > 400:
                values.append(cells["values"][row][column])
                errors.append(cells["errors"][row][column])
    off = abs(area["average"] - math.fsum(values) / len(values))
    tap.ok(off <= area["average_error"] + math.fsum(errors) / len(errors), "average with reflections", off, area)


def judged(tap, tool):
    """What EN 12464-1 wants around a task by its own level, and whether that is kept."""
    for task, wanted in ((1000, 500), (750, 500), (749, 300), (500, 300), (300, 200), (200, 150), (150, 150), (50, 50)):
        grid = measure(tool, scene({**TASK, "limits": {"average": task}}, HALL))
        limits = {limit["name"]: limit for limit in grid["limits"]}
        tap.equal([limits[name]["wanted"] for name in ("surround_average", "surround_uniformity",
                                                        "background_uniformity")], [wanted, 0.4, 0.1],
                  "around %g lx" % task)
        tap.near(limits["background_average"]["wanted"], wanted / 3, 1e-15, "and a third of that behind")
        for area in ("surround", "background"):
            for name, key in (("average", "average"), ("uniformity", "u0")):
                limit, value = limits[area + "_" + name], grid[area][key]
                tap.ok(limit["value"] == value and limit["error"] < 1e-9
                       and limit["verdict"] == ("pass" if value >= limit["wanted"] else "fail"),
                       "verdict on %s_%s" % (area, name), limit, value)
    none = measure(tool, scene({**TASK, "limits": {"uniformity": 0.5}}, HALL))
    tap.equal([limit["name"] for limit in none["limits"]], ["uniformity"], "nothing is wanted around no level")
    told = tool.run("grid", "-", "--limits", stdin=scene({**TASK, "limits": {"average": 300}}, HALL))
    tap.ok(told.code == 1 and "surrounding area: average  at least 200 lx" in told.out
           and "background area: U0" in told.out and "cells" in told.out, "as text", told)
    preset = measure(tool, scene({**TASK, "limits": {"preset": "en12464-office"}}, HALL))
    tap.equal([limit["wanted"] for limit in preset["limits"]][:4], [500, 0.6, 300, 0.4], "by the row of a standard")


def no_room(tap, tool):
    """A plane from wall to wall has nothing around it."""
    whole = measure(tool, scene({**TASK, "center": [0, 0, 750], "size": [8000, 6000], "limits": {"average": 10}}, HALL))
    tap.equal(("surround" in whole, "background" in whole, len(whole["limits"])), (False, False, 1), "no areas")
    for key, value, words in (("surround", 50, "≥ 100 mm"), ("surround", "wide", "number"),
                              ("surround", None, "surround")):
        grid = {**TASK, key: value}
        if value is None:
            del grid[key]
        result = tool.run("check", "-", stdin=scene(grid, HALL))
        tap.ok(result.code == 3 and words in result.err, "refused: %s" % value, result)


run_tests(Tap(), sums, on_a_wall, with_reflections, judged, no_room)
