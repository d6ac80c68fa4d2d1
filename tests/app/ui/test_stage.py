# SPDX-License-Identifier: MIT
"""Plan and elevation: lamps are taken in each of them, and light up everywhere; a drag is one step of undo."""
import re

from desk import luxel, trial
from waiting import wait

ORANGE = (230, 159, 0)
POSITION = re.compile(rb"position: \[([-\d.]+), ([-\d.]+), ([-\d.]+)\]")


def badges(desk, window):
    """The middles of the first source's badges, in the plan and in the elevation, on the screen."""
    left, top = window.edges()
    area = window.widget.find("image", "Plan and elevation").area()
    x, y, width, height = (round(number) for number in (left + area[0], top + area[1], area[2], area[3]))
    data = desk.screen(x, y, width, height)
    dots = [(i // 3 % width, i // 3 // width) for i in range(0, len(data), 3) if tuple(data[i:i + 3]) == ORANGE]
    gaps = sorted({dot[1] for dot in dots})
    widest = max(range(1, len(gaps)), key=lambda i: gaps[i] - gaps[i - 1])
    found = []
    for part in ([dot for dot in dots if dot[1] < gaps[widest]], [dot for dot in dots if dot[1] >= gaps[widest]]):
        found.append((x + sum(dot[0] for dot in part) / len(part), y + sum(dot[1] for dot in part) / len(part)))
    return found


def resting(desk, window):
    """Where the first badge is, once the scale is that of both sources."""
    before = badges(desk, window)[0]
    desk.hand("sleep", "0.3")
    return before if badges(desk, window)[0] == before else None


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
    tap.ok(wait("a hint", lambda: window.says("Rest with the pointer")), "before a place it says what to do")
    window.pointed(*window.pixel(60, 40))
    formula = wait("the formula", lambda: window.says("N · L = ", "B = B_d + Bₛ"))
    where = re.search(r"x = (\S+), y = (\S+) mm", window.says("x = ", "y = "))
    tap.ok(where and abs(float(where.group(1)) - 60) < 1 and abs(float(where.group(2)) - 40) < 1, "where it is", where)
    product = float(re.search(r"N · L = ([\d.]+)", formula).group(1))
    told = luxel("explain", "report", "-p", "60,40").decode()
    tap.ok(abs(product - float(re.search(r"N · L = ([\d.]+)", told).group(1))) < 0.01, "as luxel explain has it")
    window.press("The whole…", None)
    whole = wait("the whole", lambda: next((part for top in desk.reader.program(window.app.process.pid).children()
                                            for part in top.all(None, "Why this value?")
                                            if "Text" in part.interfaces), None))
    tap.ok(formula.split("\n")[-1] in whole.text and "The point of the surface" in whole.text,
           "one click away is the whole calculation")


trial(drags, lights_up, why)
