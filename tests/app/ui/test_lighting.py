# SPDX-License-Identifier: MIT
"""Measuring grids and observers: numbers and verdicts are those of `luxel grid --limits`, and follow every change;
arrays are moved as one."""
import json
import math
import re
import subprocess

from desk import LUXEL, luxel, trial
from waiting import DEADLINE, wait

ORANGE = (201, 130, 24)

# Two panels in an array above a floor that reflects light, which an observer looks along.
SCENE = """luxel: 1
units: photometric
reflections: 1
screen: {width: 6000, height: 4000, resolution: [30, 20]}
observer: {z: 9000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [6000, 4000], material: {model: lambert, diffuse: 0.3, over_pi: true}}
lights:
  - type: planar
    power: 3600
    rectangle: {center: [0, 0, 2800], size: [600, 600]}
    array: {n: [2, 1], spacing: [2400, 2400]}
points: [[0, 0]]
grids:
  - {name: desk, center: [0, 0, 750], size: [4000, 2000], n: [4, 2], surround: 500,
     limits: {average: 100, uniformity: 0.97}}
  - {center: [0, 0, 0], size: [2000, 2000], n: [2, 2]}
observers:
  - {name: along x, eye: [-2500, 0, 1200], view: [1, 0, 0], limits: {ugr: 30}}
"""


def open_scene(desk):
    path = desk.path("room.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCENE)
    return desk.start(path).window()


def judged(desk, window):
    """Verdicts and values as the tool has them for the scene as the app saved it, in the order of the page."""
    path = desk.path("judged.yaml")
    window.save(path)
    told = subprocess.run([LUXEL, "grid", path, "--limits", "--json"], capture_output=True, timeout=DEADLINE,
                          check=False, env=desk.environment)
    found = json.loads(told.stdout)
    return [limit for part in found["grids"] + found["observers"] for limit in part.get("limits", [])]


def page(window):
    """Verdicts, and numbers with bounds, as they stand on the page."""
    texts = window.numbers()
    verdicts = [text for text in texts if text in ("pass", "fail", "undecided")]
    amounts = [tuple(map(float, text.split(" \u00b1 "))) for text in texts
               if re.fullmatch(r"[-\d.e]+ \u00b1 [-\d.e+]+", text)]
    return verdicts, amounts


def same_as_tool(desk, window):
    """The first verdict is that of all."""
    limits, (verdicts, amounts) = judged(desk, window), page(window)
    return verdicts[1:] == [limit["verdict"] for limit in limits] and all(
        any(abs(value - limit["value"]) <= error + limit["error"] for value, error in amounts) for limit in limits)


def verdicts_follow(tap, desk):
    window = open_scene(desk)
    window.press("Lighting", "tab")
    tap.ok(wait("all limits", lambda: window.says("4 of 5 limits kept") and same_as_tool(desk, window)),
           "numbers and verdicts are those of the tool", page(window), judged(desk, window))
    texts = window.numbers()
    tap.ok("desk, lx" in texts and "grid 2, lx" in texts and "along x" in texts, "grids and observers have names")
    tap.ok("\u2265 100 lx" in texts and "\u2264 30" in texts and "\u2265 0.97" in texts, "limits are told")
    tap.equal(page(window)[0][0], "fail", "one that is missed is the verdict of all")
    window.enter("Power", "360")
    tap.ok(wait("other verdicts", lambda: window.says("2 of 5 limits kept") and same_as_tool(desk, window)),
           "they follow a change")
    window.act("undo")
    tap.ok(wait("the verdicts of before", lambda: window.says("4 of 5 limits kept")), "and undo")


def comes_and_goes(tap, desk):
    window = desk.start().window()
    tap.equal(window.widget.find("tab", "Lighting"), None, "a scene without grids has no such page")
    desk.apps[0].quit()
    window = open_scene(desk)
    tap.ok(wait("the page", lambda: window.widget.find("tab", "Lighting")), "one that has some has it")


def plan(desk, window):
    """The dots of the first source in the plan, which is the upper half."""
    left, top = window.edges()
    area = window.widget.find("image", "Plan and elevation").area()
    x, y, width, height = (round(number) for number in (left + area[0], top + area[1], area[2], area[3] / 2))
    data = desk.screen(x, y, width, height)
    return [(x + i // 3 % width, y + i // 3 // width) for i in range(0, len(data), 3)
            if tuple(data[i:i + 3]) == ORANGE]


def array_moves(tap, desk):
    """The left place of the array is taken, and its middle goes as far."""
    window = open_scene(desk)
    window.press("Plan", "tab")
    dots = wait("the array", lambda: plan(desk, window))
    first = min(dots)
    ring = [dot for dot in dots if math.dist(dot, first) < 14]
    start = tuple(sum(dot[k] for dot in ring) / len(ring) for k in range(2))
    desk.drag(start, (start[0] + 12, start[1] - 20))
    place = wait("a place", lambda: re.search(rb"center: \[([-\d.]+), ([-\d.]+), 2800\], size: \[600",
                                              window.save()))
    x, y = float(place.group(1)), float(place.group(2))
    tap.ok(x > 0 and y > 0 and abs(y / x - 20 / 12) < 0.25, "a place that is dragged moves the array", x, y)
    tap.ok(b"spacing: [2400, 2400]" in window.save(), "as one")
    window.act("undo")
    tap.ok(wait("undo", lambda: b"center: [0, 0, 2800]" in window.save()), "in one step")


def cells_are_read(tap, desk):
    """A tooltip tells the value of the cell under the pointer, which is a number of the tool."""
    window = open_scene(desk)
    window.press("Plan", "tab")
    wait("the grids", lambda: not window.says("being computed"))
    path = desk.path("cells.yaml")
    window.save(path)
    dots = wait("the array", lambda: plan(desk, window))
    middle = tuple(sum(dot[k] for dot in dots) / len(dots) for k in range(2))
    said = window.tooltip(middle[0] + 20, middle[1] + 8, "desk: ")
    value, error = map(float, re.match(r"desk: (\S+) \u00b1 (\S+) lx", said).groups())
    values = json.loads(luxel("grid", path, "--json"))["grids"][0]["values"]
    cells = [number for row in values for number in (row if isinstance(row, list) else [row])]
    tap.ok(any(abs(value - cell) <= 2 * error for cell in cells), "the value is one of luxel grid's", said)


def dialog(desk, window):
    """The small window that asks for a room."""
    program = desk.reader.program(window.app.process.pid)
    return next((part for part in program.children() if part.name == "A new room with luminaires"), None)


def fill(asked, values):
    for name, text in values:
        wait(name, lambda n=name: asked.find("text box", n)).text = text
    asked.find("button", "Make the room").act()


def new_room(tap, desk):
    """A room of a few numbers is that of luxel room, byte for byte; what is wrong is said, and nothing is made."""
    window = desk.start().window()
    window.act("new-room")
    asked = wait("the dialog", lambda: dialog(desk, window))
    fill(asked, (("Along x, m", "4"), ("Along y, m", "x"), ("Luminaires along x", "2"), ("Luminaires along y", "2")))
    tap.ok(wait("the fault", lambda: [label for label in asked.names("label") if "is not a number" in label]),
           "what is no number is said")
    fill(asked, (("Along y, m", "4"), ("Average on the work plane, lx", "")))
    wait("the room", lambda: not dialog(desk, window))
    tap.ok(wait("its page", lambda: window.widget.find("tab", "Lighting")), "it has a grid with limits")
    tap.equal(window.save(), luxel("room", "4,4,2.8", "--array", "2,2"), "and is that of luxel room")


trial(new_room, verdicts_follow, comes_and_goes, array_moves, cells_are_read)
