# SPDX-License-Identifier: MIT
"""luxel exchange: form factors against closed forms (J. R. Howell's catalogue), sums of rows, what stands between."""
import json
import math

from tap import Tap
from tool import run_tests

HEAD = {"luxel": 1, "screen": {"width": 10, "height": 10, "resolution": [4, 4]}, "observer": {"z": 90000}, "lights": []}


def exchange(tool, surfaces, *options, **more):
    result = tool.run("exchange", "-", "--json", *options, stdin=json.dumps({**HEAD, "surfaces": surfaces, **more}),
                      timeout=120)
    if result.code != 0:
        result.fail("exchange")
    answer = result.json()
    names = [side["name"] for side in answer["sides"]]
    return answer, {(names[i], names[j]): (factor["value"], factor["error"])
                    for i, row in enumerate(answer["factors"]) for j, factor in enumerate(row)}


def held(tap, found, truth, title, at_most=1e-3):
    value, error = found
    tap.ok(abs(value - truth) <= error <= at_most, "%s: %.9g ± %.2g for %.9g" % (title, value, error, truth))


def parallel(a, b, c):
    x, y = a / c, b / c
    return 2 / (math.pi * x * y) * (
        math.log((1 + x * x) * (1 + y * y) / (1 + x * x + y * y)) / 2
        + x * math.sqrt(1 + y * y) * math.atan(x / math.sqrt(1 + y * y))
        + y * math.sqrt(1 + x * x) * math.atan(y / math.sqrt(1 + x * x)) - x * math.atan(x) - y * math.atan(y))


def perpendicular(h, w, length):
    """From the one of the width w to that of the height h, which meet in an edge."""
    h, w = h / length, w / length
    p, q, s = h * h, w * w, h * h + w * w
    logs = math.log((1 + q) * (1 + p) / (1 + s)) + q * math.log(q * (1 + s) / ((1 + q) * s)) \
        + p * math.log(p * (1 + s) / ((1 + p) * s))
    return (w * math.atan(1 / w) + h * math.atan(1 / h) - math.sqrt(s) * math.atan(1 / math.sqrt(s))
            + logs / 4) / (math.pi * w)


def coaxial(r1, r2, h):
    s = 1 + (1 + (r2 / h) ** 2) / (r1 / h) ** 2
    return (s - math.sqrt(s * s - 4 * (r2 / r1) ** 2)) / 2


def rectangle(name, center, size, axis, up=(0, 1, 0)):
    return {"type": "rectangle", "name": name, "center": center, "size": size, "axis": axis, "up": up}


def areas(tap, answer, title, truth):
    told = [side["area"] for side in answer["sides"]]
    tap.ok(all(abs(area - truth) <= 4e-16 * truth for area in told), "%s: areas %s" % (title, told))


def sums(tap, answer, title, truth=1):
    for side, row in zip(answer["sides"], answer["factors"]):
        value, error = sum(factor["value"] for factor in row), sum(factor["error"] for factor in row)
        tap.ok(abs(value - truth) <= error + 1e-12,
               "%s: row of %s is %.9g ± %.2g" % (title, side["name"], value, error))


def plates(tap, tool):
    answer, factors = exchange(tool, [rectangle("a", [0, 0, 0], [2000, 1000], [0, 0, 1]),
                                      rectangle("b", [0, 0, 700], [2000, 1000], [0, 0, -1])])
    tap.equal(list(answer), ["sides", "factors"], "members")
    tap.equal([list(side) for side in answer["sides"]], [["name", "area"]] * 4, "of sides")
    tap.equal([side["name"] for side in answer["sides"]], ["a, front", "a, back", "b, front", "b, back"], "names")
    tap.equal([side["area"] for side in answer["sides"]], [2] * 4, "areas in m²")
    tap.ok(all(list(factor) == ["value", "error"] for row in answer["factors"] for factor in row), "of factors")
    truth = parallel(2, 1, 0.7)
    held(tap, factors["a, front", "b, front"], truth, "parallel rectangles")
    held(tap, factors["b, front", "a, front"], truth, "and back")
    tap.equal([factors[pair] for pair in factors if "back" in pair[0] + pair[1] or pair[0] == pair[1]],
              [(0, 0)] * 14, "what does not see each other")
    answer, factors = exchange(tool, [rectangle("floor", [0, 0, 0], [1500, 1000], [0, 0, 1]),
                                      rectangle("wall", [-750, 0, 350], [700, 1000], [1, 0, 0])])
    there, back = factors["floor, front", "wall, front"], factors["wall, front", "floor, front"]
    held(tap, there, perpendicular(.7, 1.5, 1), "perpendicular rectangles")
    held(tap, back, perpendicular(1.5, .7, 1), "and back")
    tap.near(there[0] * 1.5, back[0] * .7, 1e-9, "reciprocity")


def rounds(tap, tool):
    disks = [{"type": "disk", "name": name, "center": [0, 0, z], "radius": r, "axis": [0, 0, axis]}
             for name, z, r, axis in (("a", 0, 500, 1), ("b", 800, 300, -1))]
    _, factors = exchange(tool, disks)
    held(tap, factors["a, front", "b, front"], coaxial(500, 300, 800), "coaxial disks")
    ball = {"type": "sphere", "name": "ball", "center": [0, 0, 1200], "radius": 200}
    answer, factors = exchange(tool, [disks[0], ball])
    held(tap, factors["ball, outside", "a, front"], (1 - 1 / math.sqrt(1 + (5 / 12) ** 2)) / 2, "a ball over a disk")
    tap.equal([side["name"] for side in answer["sides"]], ["a, front", "a, back", "ball, outside"], "no inside of it")
    answer, factors = exchange(tool, [{**ball, "inside": True}])
    tap.equal([side["name"] for side in answer["sides"]], ["ball, inside"], "an integrating sphere")
    held(tap, factors["ball, inside", "ball, inside"], 1, "sees all of itself")


def rooms(tap, tool):
    room = {"type": "room", "name": "room", "center": [0, 0, 0], "size": [1000, 1000, 1000]}
    answer, factors = exchange(tool, [room])
    tap.equal(len(answer["sides"]), 6, "six walls, and nothing outside")
    for (a, b), found in factors.items():
        pair = {a.split(", ")[1], b.split(", ")[1]}
        opposite = pair in ({"left", "right"}, {"floor", "ceiling"}, {"back", "front"})
        truth = 0 if a == b else parallel(1, 1, 1) if opposite else perpendicular(1, 1, 1)
        held(tap, found, truth, "cube, %s to %s" % (a, b))
    sums(tap, answer, "cube")
    areas(tap, answer, "cube", 1)
    box = {"type": "box", "name": "box", "center": [300, 200, -200], "size": [250, 300, 200], "rotate": [0, 0, 30]}
    answer, factors = exchange(tool, [{**room, "size": [1500, 1200, 900]}, box], reflections="none")
    tap.equal(len(answer["sides"]), 12, "with a box in it")
    sums(tap, answer, "room with a box")
    inner = [name for name in dict.fromkeys(pair[0] for pair in factors) if name.startswith("box")]
    tap.ok(all(factors[a, b] == (0, 0) for a in inner for b in inner), "sides of the box do not see each other")


def between(tap, tool):
    """A plate that covers all, and one that covers as much of the view as it leaves, by symmetry."""
    ends = [rectangle("a", [0, 0, 0], [1000, 1000], [0, 0, 1]), rectangle("b", [0, 0, 1000], [1000, 1000], [0, 0, -1])]
    _, factors = exchange(tool, ends + [rectangle("shield", [0, 0, 500], [1100, 1100], [0, 0, 1])])
    tap.ok(factors["a, front", "b, front"][0] <= factors["a, front", "b, front"][1] <= 1e-4, "hidden",
           factors["a, front", "b, front"])
    _, factors = exchange(tool, ends + [rectangle("shield", [2500, 0, 500], [5000, 5000], [0, 0, 1])])
    held(tap, factors["a, front", "shield, back"], 0.5 - perpendicular_share(), "to half a plane", 2e-3)


def perpendicular_share():
    """What a plate of 5 m at x > 0, half as high over a square as that is wide, leaves of half of its view: by symmetry
    nothing but what its rim does."""
    steps, total = 60, 0
    for i in range(steps):
        for j in range(steps):
            x, y = ((k + .5) / steps - .5 for k in (i, j))
            for dx, dy, sign in ((5, 2.5, 1), (5, -2.5, -1), (0, 2.5, -1), (0, -2.5, 1)):
                total += sign * corner(dx - x, dy - y, .5)
    return 0.5 - total / steps ** 2


def corner(x, y, z):
    """The irradiance of a horizontal element by a horizontal rectangle from over it to the corner (x, y), over pi."""
    p, q = math.hypot(x, z), math.hypot(y, z)
    return (x / p * math.atan(y / p) + y / q * math.atan(x / q)) / (2 * math.pi)


def texts(tap, tool):
    room = {"type": "room", "name": "<room>", "center": [0, 0, 0], "size": [1000, 1500, 1200]}
    text = json.dumps({**HEAD, "surfaces": [room]})
    result = tool.run("exchange", "-", stdin=text)
    tap.equal((result.code, result.err), (0, ""), "a room")
    for words in ("form factors", "from side", "to 0", "sum", "floor"):
        tap.ok(words in result.out, "it says " + words)
    fine = tool.run("exchange", "-", "--json", "--reflected-error", "1e-4", stdin=text)
    worst = max(factor["error"] for row in fine.json()["factors"] for factor in row)
    tap.ok(fine.code == (0 if worst <= 1e-4 else 5), "the error that is asked for, or the exit code", worst)
    many = [rectangle("plate %d" % i, [2000 * i, 0, 0], [100, 100], [0, 0, 1]) for i in range(11)]
    result = tool.run("exchange", "-", stdin=json.dumps({**HEAD, "surfaces": many}))
    tap.ok(result.code == 0 and "too many sides" in result.out and "plate 10, back" in result.out, "many sides", result)
    empty = tool.run("exchange", "-", "--json", stdin=json.dumps({**HEAD, "surfaces": []}))
    tap.equal((empty.code, empty.json()), (0, {"sides": [], "factors": []}), "no surfaces")
    one, many = (tool.run("exchange", "-", "--json", "--threads", n, stdin=text).out for n in ("1", "4"))
    tap.ok(one == many, "the same bytes by any number of threads")


run_tests(Tap(), plates, rounds, rooms, between, texts)
