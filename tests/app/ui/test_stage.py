# SPDX-License-Identifier: MIT
"""Plan and elevation: lamps are taken in each of them, and light up everywhere; a drag is one step of undo."""
import math
import re

from desk import luxel, trial
from waiting import wait

ORANGE = (201, 130, 24)
POSITION = re.compile(rb"position: \[([-\d.]+), ([-\d.]+), ([-\d.]+)\]")


def dots_of(desk, window):
    """The places of the first source's colour on the screen, in the plan and in the elevation."""
    left, top = window.edges()
    area = window.widget.find("image", "Plan and elevation").area()
    x, y, width, height = (round(number) for number in (left + area[0], top + area[1], area[2], area[3]))
    data = desk.screen(x, y, width, height)
    dots = [(i // 3 % width, i // 3 // width) for i in range(0, len(data), 3) if tuple(data[i:i + 3]) == ORANGE]
    gaps = sorted({dot[1] for dot in dots})
    widest = max(range(1, len(gaps)), key=lambda i: gaps[i] - gaps[i - 1])
    dots = [(x + dot[0], y + dot[1]) for dot in dots]
    return [[dot for dot in dots if (dot[1] < y + gaps[widest]) == is_plan] for is_plan in (True, False)]


def middle(dots):
    return tuple(sum(dot[k] for dot in dots) / len(dots) for k in range(2))


def badges(desk, window):
    """The middles of the first source's badges, in the plan and in the elevation, on the screen."""
    return [middle(part) for part in dots_of(desk, window)]


def far_badge(desk, window, number):
    """The badge at the upper right end of the arrow of light from far away, once it rests."""
    def look():
        part = dots_of(desk, window)[number]
        end = max(part, key=lambda dot: dot[0] - dot[1])
        return middle([dot for dot in part if math.dist(dot, end) < 10])

    before = look()
    desk.hand("sleep", "0.3")
    return before if look() == before else None


def resting(desk, window):
    """Where the first badge is, once the scale is that of both sources."""
    before = badges(desk, window)[0]
    desk.hand("sleep", "0.3")
    return before if badges(desk, window)[0] == before else None


def places(window):
    """Where all sources are: a position, or the centre of a rectangle."""
    lamps = re.search(rb"lights:(.*)", window.save(), re.S).group(1)
    found = re.findall(rb"(?:position|center): \[([^\]]*)\]", lamps)
    return [[float(number) for number in place.split(b",")] for place in found][:2]


def place(window):
    return tuple(map(float, POSITION.search(window.save()).groups()))


def drags(tap, desk):
    path = desk.path("lamp.yaml")
    luxel("set", "report", "-s", "lights[0].position=[900, 400, 1900]", "-o", path)
    window = desk.start(path).window()
    start = place(window)
    plan, elevation = wait("the badges", lambda: badges(desk, window))
    tap.ok(abs(plan[0] - elevation[0]) < 2, "plan and elevation stand above each other on one x", (plan, elevation))
    desk.drag(plan, (plan[0] - 20, plan[1] - 15))
    moved = wait("a new place", lambda: place(window) if place(window) != start else None)
    scale = (start[0] - moved[0]) / 20
    tap.ok(scale > 0 and abs((moved[1] - start[1]) / 15 - scale) < 0.2 * scale, "the plan moves x and y", moved)
    tap.equal(moved[2], start[2], "and leaves the height")
    plan, elevation = badges(desk, window)
    desk.drag(elevation, (elevation[0], elevation[1] - 30))
    raised = wait("a new height", lambda: place(window) if place(window) != moved else None)
    tap.ok(raised[2] > moved[2] and raised[:2] == moved[:2], "the elevation raises it, without another key", raised)
    window.act("undo")
    tap.equal(wait("the step before", lambda: place(window) if place(window) != raised else None), moved,
              "a drag is one step of undo")
    window.act("undo")
    tap.equal(place(window), start, "each of them")


def together(tap, desk):
    """Lamps that are chosen together are moved together, in the plan and in the elevation."""
    path = desk.path("lamps.yaml")
    luxel("set", "report", "-s", "lights[0].position=[900, 400, 1900]", "-o", path)
    window = desk.start(path).window()
    window.act("source-add", "planar")
    wait("two sources", lambda: len(window.sources()) == 2)
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[1])
    chosen = lambda: [row.has("selected") for row in window.widget.find("list").all("list item")]
    wait("the second", lambda: chosen() == [False, True])
    before = places(window)
    plan = wait("badges that rest", lambda: resting(desk, window))
    desk.move(*plan)
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("both", lambda: chosen() == [True, True]), "Ctrl and a click choose one more lamp in the plan")
    tap.equal(places(window), before, "and move nothing")
    desk.drag(plan, (plan[0] - 24, plan[1] - 12))
    moved = wait("new places", lambda: places(window) if places(window) != before else None)
    ways = [[moved[i][k] - before[i][k] for k in range(3)] for i in range(2)]
    tap.ok(ways[0][0] < 0 < ways[0][1] and ways[0][2] == 0, "a drag in the plan moves the lamp", ways)
    tap.ok(all(abs(ways[0][k] - ways[1][k]) < 1e-5 for k in range(3)), "and the other as far", ways)
    tap.equal(chosen(), [True, True], "both stay chosen")
    window.act("undo")
    tap.ok(wait("as before", lambda: places(window) == before), "which is one step of undo")
    elevation = wait("badges that rest", lambda: resting(desk, window) and badges(desk, window)[1])
    desk.drag(elevation, (elevation[0], elevation[1] - 20))
    raised = wait("new heights", lambda: places(window) if places(window) != before else None)
    rises = [raised[i][2] - before[i][2] for i in range(2)]
    tap.ok(rises[0] > 0 and abs(rises[0] - rises[1]) < 1e-5, "a drag in the elevation raises both", rises)
    window.act("undo")
    wait("as before", lambda: places(window) == before)
    plan = wait("badges that rest", lambda: resting(desk, window))
    desk.click(*plan)
    tap.ok(wait("one", lambda: chosen() == [True, False]), "a click chooses the one alone")


def turned(tap, desk):
    """Light from far away that is chosen together turns together, in the plan and in the elevation."""
    path = desk.path("far.yaml")
    head, rest = luxel("scene", "report").split(b"lights:\n")
    with open(path, "wb") as file:
        file.write(head + b"lights:\n" + b"".join(
            b"  - {type: distant, direction: [%s], irradiance: 3}\n" % way
            for way in (b"-0.5, -0.3, -0.8", b"0.3, -0.4, -0.8")) + rest.split(b"\n", 1)[1])
    window = desk.start(path).window()
    wait("two sources", lambda: len(window.sources()) == 2)
    chosen = lambda: [row.has("selected") for row in window.widget.find("list").all("list item")]

    def ways():
        found = re.findall(rb"direction: \[([^\]]*)\]", window.save())
        return [[float(number) for number in way.split(b",")] for way in found]

    def between(pair):
        return sum(a * b for a, b in zip(*pair)) / math.hypot(*pair[0]) / math.hypot(*pair[1])

    start = ways()
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[0])
    wait("the first", lambda: chosen() == [True, False])
    desk.move(*window.place(rows[1]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    wait("both", lambda: chosen() == [True, True])
    for name, number in (("plan", 0), ("elevation", 1)):
        before = window.save()
        badge = wait("badges that rest", lambda: far_badge(desk, window, number))
        desk.drag(badge, (badge[0] - 14, badge[1] + 9))
        now = wait("a turn", lambda: ways() if ways()[0] != start[0] else None)
        tap.ok(now[1] != start[1] and abs(between(now) - between(start)) < 5e-4, "a drag in the %s turns both" % name,
               now)
        window.act("undo")
        tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo")


def lights_up(tap, desk):
    window = desk.start().window()
    window.act("source-duplicate")  # which is the chosen one from then on
    wait("two sources", lambda: len(window.sources()) == 2)
    row, scene = next(window.widget.find("list").all("list item")), window.save()
    plan = wait("badges that rest", lambda: resting(desk, window))
    x, y, width, height = row.area()
    left, top = window.edges()

    def frame():
        return desk.screen(*(round(number) for number in (left + x - 8, top + y - 8, width + 16, height + 16)))

    plain = frame()
    desk.move(plan[0] - 1, plan[1])
    desk.move(*plan)
    tap.ok(wait("a frame around the row", lambda: frame() != plain), "a lamp in the plan lights up its row")
    said = window.tooltip(*plan, "Source 1\n")
    tap.equal(said, "Source 1\nx 2000, y 0, z 2000 mm", "and says where it is")
    tap.equal(window.save(), scene, "nothing is changed by that")


def why(tap, desk):
    """The formula of the chosen source with the numbers of the place, which are those of luxel explain."""
    window = desk.start().window()
    window.click(wait("a button", lambda: window.widget.find(None, "Why?")))
    window.press("Formula of the chosen source", None)
    tap.ok(wait("a hint", lambda: window.says("Rest with the pointer")), "before a place it says what to do")
    window.pointed(*window.pixel(60, 40))

    def there():
        where = re.search(r"x = (\S+), y = (\S+) mm", window.says("x = ", "y = ") or "")
        return where and abs(float(where.group(1)) - 60) < 1 and abs(float(where.group(2)) - 40) < 1

    tap.ok(wait("the place", there), "where it is")
    formula = wait("the formula", lambda: window.says("N · L = ", "B = B_d + Bₛ"))
    value = float(re.search(r"exact ([\d.]+)|digits: ([\d.]+)", luxel("explain", "report", "-p", "60,40").decode())[2])
    result = wait("the result", lambda: next((label for label in window.widget.all("label")
                                              if re.fullmatch(r"[\d.]+ W/sr", label.name)), None))
    tap.ok(abs(float(result.name.split()[0]) - value) < 0.01 * value, "the value itself comes first", result.name)
    top, height = result.area()[1], result.area()[3]
    tap.ok(top + height <= window.control("label", formula).area()[1], "its result stands above it", formula)
    product = float(re.search(r"N · L = ([\d.]+)", formula).group(1))
    told = luxel("explain", "report", "-p", "60,40").decode()
    tap.ok(abs(product - float(re.search(r"N · L = ([\d.]+)", told).group(1))) < 0.01, "as luxel explain has it")
    window.press("The whole…", None)
    whole = wait("the whole", lambda: next((part for top in desk.reader.program(window.app.process.pid).children()
                                            for part in top.all(None, "Why this value?")
                                            if "Text" in part.interfaces), None))
    tap.ok(formula.split("\n")[-1] in whole.text and "The point of the surface" in whole.text,
           "one click away is the whole calculation")


trial(drags, together, turned, lights_up, why)
