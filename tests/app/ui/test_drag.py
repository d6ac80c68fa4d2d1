# SPDX-License-Identifier: MIT
"""What is taken on the picture with the mouse: sources, points, the surface, the view itself."""
import re

from desk import trial
from waiting import wait


HALL = b"""\
luxel: 1
screen: {width: 3000, height: 2000, resolution: [90, 60]}
observer: {position: [0, 0, 3800], target: [0, 0, 0], projection: perspective}
surfaces:
  - {type: room, center: [0, 0, 2000], size: [4000, 2600, 4400], material: {model: lambert, diffuse: 0.6}}
lights:
  - {type: point, position: [-600, 700, 1800], intensity: 30}
points: [[300, 200]]
"""

def numbers(scene, key):
    """The numbers of the first list of this key in a saved scene."""
    found = re.search(re.escape(key) + r" *\[+([^\]]*)\]", scene.decode())
    return [float(number) for number in found.group(1).split(",")]


def rest(window):
    """The scene when what the mouse did has arrived."""
    window.desk.hand("sleep", "0.1")
    return window.save()


def drag(window, start, end, **how):
    window.desk.drag(start, end, **how)
    return rest(window)


def source(tap, desk):
    window = desk.start().window()
    x, y, width, height = window.picture_area()
    scale, origin_x, origin_y = window.map()
    before, values = window.save(), window.values()
    # The source lies far to the right: an arrow at the edge stands for it.
    arrow = (x + width - 14, origin_y)
    after = drag(window, arrow, (arrow[0] - 60, arrow[1] - 80))
    place = numbers(after, "position:")
    tap.ok(place[0] < 2000 and place[1] > 0, "the source follows the mouse", place)
    tap.equal(place[2], 2000, "at its height")
    tap.equal([float(window.control("spin button", "Position, " + axis).text) for axis in "xyz"], place,
              "and so do the fields")
    wait("other numbers", lambda: window.values() != values)
    window.desk.key("ctrl+z")
    wait("nothing more to undo", lambda: not window.enabled("undo"))
    tap.equal(window.save(), before, "one undo takes the whole drag back, to the byte")
    wait("the numbers of before", lambda: window.values() == values)
    window.desk.key("ctrl+shift+z")
    wait("nothing more to redo", lambda: not window.enabled("redo"))
    tap.equal(window.save(), after, "one redo brings it back, to the byte")


def point(tap, desk):
    window = desk.start().window()
    before = window.save()
    start, end = window.pixel(150, 0), window.pixel(100, 80)
    after = drag(window, start, end)
    places = numbers(after, "points: [[0, 0],")
    tap.ok(abs(places[0] - 100) <= 2 and abs(places[1] - 80) <= 2, "a point is dragged to where the mouse goes", places)
    tap.equal(after.replace(b"[%g, %g]" % tuple(places), b"[150, 0]"), before, "and nothing else changes")
    window.desk.key("ctrl+z")
    wait("nothing more to undo", lambda: not window.enabled("undo"))
    tap.equal(window.save(), before, "one undo takes it back")
    # With Shift a tenth of the way.
    after = drag(window, window.pixel(-150, 0), window.pixel(-50, 0), held=("shift",))
    places = numbers(after, "points: [[0, 0], [150, 0],")
    tap.ok(abs(places[0] + 140) <= 1 and abs(places[1]) <= 1, "with Shift it goes a tenth of the way", places)
    # With Ctrl onto round numbers.
    after = drag(window, window.pixel(0, 0), window.pixel(33, 47), held=("ctrl",))
    places = numbers(after, "points: [")
    tap.ok(places[0] % 10 == 0 and places[1] % 10 == 0 and places[0] > 0 and places[1] > 0,
           "with Ctrl onto round numbers", places)


def sphere(tap, desk):
    window = desk.start().window()
    before, scale = window.save(), window.map()[0]
    start, end = window.pixel(-60, -100), window.pixel(-20, -70)
    window.pointed(*start)  # what is under the pointer is known
    tap.equal(drag(window, start, end), before, "a surface that is not chosen is not moved: the view is")
    window.act("fit")
    wait("the whole picture", lambda: abs(window.map()[0] - scale) < 1e-3)
    window.pointed(*start)
    desk.click(*start)
    tap.equal(drag(window, start, (start[0] + 2, start[1] + 2)), before, "nor is one by a hand that trembles")
    after = drag(window, start, end)
    center = numbers(after, "center:")
    tap.ok(abs(center[0] - 40) <= 2 and abs(center[1] - 30) <= 2, "the sphere follows the mouse", center)
    tap.equal(center[2], 1000, "at its height")
    window.desk.key("ctrl+z")
    wait("nothing more to undo", lambda: not window.enabled("undo"))
    window.pointed(*start)
    after = drag(window, start, (start[0] + 30, start[1] - 50), held=("alt",))
    center = numbers(after, "center:")
    tap.equal(center[:2], [0, 0], "with Alt it does not move aside")
    tap.ok(center[2] > 1000, "but rises", center)


def room(tap, desk):
    """In a room every place is one of its walls: a hand takes none of them, however often it clicks."""
    with open(desk.path("hall.yaml"), "wb") as file:
        file.write(HALL)
    window = desk.start(desk.path("hall.yaml")).window()
    before = window.save()
    start = window.pixel(-900, 500)
    for _ in range(2):
        window.pointed(*start)
        tap.equal(drag(window, start, (start[0] + 40, start[1] + 30)), before, "a room is never moved from within")
        window.act("fit")
        desk.click(*start)
    tap.equal(window.save(), before, "nor by a click")


def view(tap, desk):
    window = desk.start().window()
    before = window.save()
    fitted = window.map()
    x, y, width, height = window.picture_area()
    at = (round(x + width / 4), round(y + height / 4))
    there = window.pointed(*at)
    desk.hand("click", "--repeat", "5", "--delay", "40", "4")
    wait("a greater scale", lambda: window.map()[0] > 1.5 * fitted[0])
    again = window.pointed(*at)
    tap.ok(max(abs(a - b) for a, b in zip(there, again)) < 1, "the wheel zooms, what is under the pointer stays",
           there, again)
    desk.key("f")
    tap.ok(wait("the whole picture", lambda: abs(window.map()[0] - fitted[0]) < 1e-3), "F fits the picture again")
    desk.key("ctrl+0")
    one = 360 / 500  # but for the half pixel at both edges
    tap.ok(wait("one to one", lambda: abs(window.map()[0] - one) < 4e-3), "Ctrl+0 shows one pixel as one pixel")
    desk.key("f")
    wait("the whole picture", lambda: abs(window.map()[0] - fitted[0]) < 1e-3)
    desk.drag((x + width / 2, y + height / 2), (x + width / 2 + 50, y + height / 2 + 30), button=2)
    moved = window.map()
    tap.ok(abs(moved[1] - fitted[1] - 50) < 1.5 and abs(moved[2] - fitted[2] - 30) < 1.5,
           "the middle button moves the view", fitted, moved)
    tap.equal(window.save(), before, "none of it changes the scene")


trial(source, point, sphere, room, view)
