# SPDX-License-Identifier: MIT
"""A desktop with larger letters: all that is written or drawn grows with them, and no number is cut."""
import os

from desk import trial
from waiting import wait
from window import VALUE

USUAL, LARGE = 10, 20  # points
FEW = 3  # dots
DARK = 450  # the sum of red, green and blue, below which a dot is ink


def window_with(desk, points, width):
    folder = desk.path("config_home", "gtk-4.0")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "settings.ini"), "w", encoding="ascii") as file:
        file.write("[Settings]\ngtk-font-name=Sans %d\n" % points)
    window = desk.start("three-lights").window()
    desk.hand("windowsize", "--sync", window.screen_id, width, 900)
    wait("the size", lambda: abs(window.widget.area()[2] - width) < 80)
    desk.hand("sleep", "0.5")
    return window


def ink(window, x, y, width, height):
    """How far letters reach in a part of the window, to the right and down."""
    left, top = window.edges()
    dots = window.desk.screen(round(left + x), round(top + y), width, height)
    dark = [i // 3 for i in range(0, len(dots), 3) if sum(dots[i:i + 3]) < DARK]
    return max((i % width for i in dark), default=0), max((i // width for i in dark), default=0)


def measured(desk, points):
    """What a window of 1600 dots has: how wide and high things are."""
    window = window_with(desk, points, 1600)
    right = window.panes()[2]
    bar = window.control("group", "Colour bar").area()
    plan = right.find("widget", "LuxelStage") or right.find(None, "Plan and elevation")
    x, y, width, _height = plan.area()
    found = {
        "the label of a row": window.control("label", "Intensity").area()[3],
        "the colour bar": bar[3],
        "its numbers": ink(window, bar[0] + 20, bar[1] + 30, 500, bar[3] - 31)[1],
        "the title of the plan": ink(window, x + 2, y + 2, width - 4, 30)[0],
        "the pane of numbers": right.area()[2],
        "the field of a number": window.control("spin button", "Intensity").area()[2],
        "that of a choice": window.control("combo box", "Attenuation").area()[2],
    }
    return window, found


def grows(tap, desk):
    usual = measured(desk, USUAL)[1]
    desk.apps[-1].quit()
    window, large = measured(desk, LARGE)
    for name in ("the label of a row", "its numbers", "the title of the plan"):
        tap.ok(1.7 * usual[name] < large[name] < 2.3 * usual[name], "twice as large: " + name, usual[name], large[name])
    for name in ("the colour bar", "the pane of numbers", "the field of a number"):
        tap.ok(large[name] > 1.2 * usual[name], "with more room: " + name, usual[name], large[name])
    for found in (usual, large):
        tap.ok(abs(found["the field of a number"] - found["that of a choice"]) <= FEW,
               "fields are as wide as one another", found)
    window.press("Points", "tab")
    edge = window.widget.area()[2]

    def whole():
        values = [label.area() for label in window.panes()[2].all("label") if VALUE.fullmatch(label.name)]
        return len(values) == 4 and all(width and x + width <= edge for x, _y, width, _height in values)

    tap.ok(wait("whole values", whole), "no value of a point is cut")


def drawer(tap, desk):
    window = window_with(desk, LARGE, 1024)
    window.act("numbers")
    wait("the drawer", lambda: window.panes()[2])
    tap.ok(wait("its width", lambda: window.panes()[2].area()[2] > 500), "the drawer of a small window is wider",
           window.panes()[2].area())


trial(grows, drawer, size=(1700, 1100))
