# SPDX-License-Identifier: MIT
"""The scene in space, in the place of the picture: lit bodies, lamps that move in the plane of the view, a view that
turns, moves and is fitted again, and the value of a place that the pointer is on."""
import re

from desk import luxel, trial
from waiting import wait

POSITION = re.compile(rb"position: \[([-\d.]+), ([-\d.]+), ([-\d.]+)\]")


def place(window):
    return tuple(map(float, POSITION.search(window.save()).groups()))


def space_area(window):
    """x, y, width, height of the view on the screen."""
    x, y, width, height = (round(number) for number in window.widget.find("image", "Space").area())
    left, top = window.edges()
    return round(left) + x, round(top) + y, width, height


def dots_of(desk, window, is_such):
    """The places of dots of the view that are such."""
    x, y, width, height = space_area(window)
    data = desk.screen(x, y, width, height)
    return [(x + i // 3 % width, y + i // 3 // width) for i in range(0, len(data), 3) if is_such(data[i:i + 3])]


FIRST = (201, 130, 24)  # the colour of the first lamp
BADGE = 12  # dots, more than its colour is high, and less than its plumb line hangs below it


def badge(desk, window):
    """The middle of the first lamp's badge; None: it is not in view."""
    dots = dots_of(desk, window, lambda dot: tuple(dot) == FIRST)
    top = min((dot[1] for dot in dots), default=0)
    part = [dot for dot in dots if dot[1] <= top + BADGE]
    return tuple((min(dot[k] for dot in part) + max(dot[k] for dot in part)) / 2 for k in range(2)) if part else None


def resting(desk, window):
    """The same, once it stays where it is."""
    before = badge(desk, window)
    desk.hand("sleep", "0.4")
    return before if before and before == badge(desk, window) else None


def open_space(desk):
    path = desk.path("lamp.yaml")
    luxel("set", "report", "-s", "lights[0].position=[500, 300, 1900]", "-o", path)
    window = desk.start(path).window()
    desk.key("s")
    wait("the space view", lambda: window.widget.find("image", "Space"))
    return window


def lamps(tap, desk):
    window = open_space(desk)
    tap.equal(window.state("space"), True, "S shows the scene in space")
    before = window.save()
    lamp = wait("the lamp", lambda: resting(desk, window))
    desk.drag(lamp, (lamp[0] + 2, lamp[1]))
    tap.equal(window.save(), before, "a press with two dots of jitter moves nothing")
    start = place(window)
    desk.drag(lamp, (lamp[0] + 40, lamp[1]))
    moved = wait("a new place", lambda: place(window) if place(window) != start else None)
    tap.ok(moved[0] > start[0] and abs(moved[2] - start[2]) < 2, "a lamp moves in the plane of the view", moved)
    window.act("undo")
    tap.equal(window.save(), before, "as one step of undo")
    desk.key("s")
    wait("the picture", lambda: not window.state("space"))


def turns(tap, desk):
    window = open_space(desk)
    x, y, width, height = space_area(window)
    lamp = wait("the lamp", lambda: resting(desk, window))
    corner = (x + 30, y + height - 30)
    desk.drag(corner, (corner[0] + 80, corner[1]))
    turned = wait("another view", lambda: next((at for at in [resting(desk, window)] if at and at != lamp), None))
    tap.ok(abs(turned[0] - lamp[0]) > 10, "a drag on nothing turns the view", (lamp, turned))
    desk.drag(turned, (turned[0] + 50, turned[1] + 20), button=3)
    panned = wait("a view that moved",
                  lambda: next((at for at in [resting(desk, window)] if at and at != turned), None))
    tap.ok(abs(panned[0] - turned[0] - 50) < 3 and abs(panned[1] - turned[1] - 20) < 3,
           "the right button moves what it presses with the hand", (turned, panned))
    desk.click(x + width / 2, y + height / 2, 4, 3)
    zoomed = wait("a larger view", lambda: next((at for at in [resting(desk, window)] if at != panned), None))
    desk.key("f")
    fitted = wait("all of it", lambda: next((at for at in [resting(desk, window)] if at and at != zoomed), None))
    tap.ok(x < fitted[0] < x + width and y < fitted[1] < y + height, "F takes all of it into view", fitted)


def values(tap, desk):
    window = open_space(desk)
    wait("the lamp", lambda: resting(desk, window))
    x, y, width, height = space_area(window)

    def told(at):
        desk.move(*at)
        desk.hand("sleep", "0.3")
        return window.place_said()

    places = [(x + width * i // 16, y + height * k // 12) for k in range(1, 12) for i in range(1, 16)]
    body = wait("a body under the pointer", lambda: next((at for at in places if told(at)), None))
    tap.ok(any("W/sr" in label.name for label in window.edge()), "the pointer on a body reads its value", body)
    desk.move(x + 3, y + 3)
    wait("none beside the bodies", lambda: not window.place_said())


def points(tap, desk):
    window = desk.start().window()
    before = wait("what the source gives", lambda: window.says("Φ", "E "))
    desk.key("alt+2")
    tap.ok(wait("Why? at the second point", lambda: window.says("x = 150, y = 0")), "Alt+2 asks why at P2")
    wait("what the source gives there", lambda: window.says("Φ", "E ") not in (None, before))
    desk.key("w")
    wait("what it gives in the middle", lambda: window.says("Φ", "E ") == before)
    tap.ok(True, "the list tells E at the place where Why? is kept")


def clicks(tap, desk):
    """Why? at a double click, and at a point, with which it goes."""
    window = desk.start().window()
    at = window.pixel(40, 40)
    desk.click(*at, count=2)
    tap.ok(wait("the card", lambda: window.says("x = ", "y = ")), "a double click asks why")
    tap.ok(wait("the place", lambda: re.match(r"x = 40(\.|,)?|x = (39|40)\.", window.says("x = ", "y = "))),
           "at the place that is clicked", window.says("x = ", "y = "))
    desk.key("Escape")
    wait("no card", lambda: not window.says("x = ", "y = "))
    tap.equal(window.state("why"), False, "Esc closes the card")
    desk.key("alt+2")
    tap.ok(wait("P2", lambda: window.says("P2  x = 150, y = 0")), "the card has the name of its point")
    desk.drag(window.pixel(150, 0), window.pixel(120, 30))
    moved = wait("another place", lambda: next((text for text in [window.says("P2  x = ")]
                                                if text and "x = 150" not in text), None))
    tap.ok(moved, "and goes where that is moved", moved)


trial(lamps, turns, values, points, clicks)
