# SPDX-License-Identifier: MIT
"""Controls for fingers, as they are switched on under Appearance: what can be pressed is 44 dots across at least."""
from desk import trial
from waiting import wait

FINGER = 44
BORDERS = 2  # which the areas that GTK tells are without
PRESSED = ("button", "toggle button", "checkbox", "spin button", "combo box", "slider", "entry", "list item")


def small(window):
    """What can be pressed and is too small for a finger."""
    found = []
    for role in PRESSED:
        for control in window.widget.all(role):
            _x, _y, width, height = control.area()
            if 0 < width and 0 < height and not (min(width, height) >= FINGER - BORDERS):
                found.append((role, control.name, width, height))
    return found


def sizes(tap, desk):
    app = desk.start()
    window = app.window()
    window.act("new", "three-lights")
    wait("three sources", lambda: len(window.sources()) == 3)
    tap.ok(small(window), "for a mouse some controls are smaller than a fingertip")
    app.act("touch")
    left = []

    def all_large():
        left[:] = small(window)
        return not left

    try:
        wait("large controls", all_large, 30)
    except AssertionError:
        pass
    tap.equal(left, [], "for fingers none is")
    app.act("touch")
    tap.ok(wait("small controls", lambda: small(window)), "and small again, once that is switched off")


def reach(tap, desk):
    """Marks are taken from as far away as a fingertip is wide."""
    app = desk.start()
    window = app.window()
    before = window.save()
    x, y = window.pixel(150, 0)
    desk.drag((x + 17, y), (x + 57, y + 30))
    desk.hand("sleep", "0.2")
    tap.ok(b"[150, 0]" in window.save(), "a press 17 dots beside a point does not take it")
    if window.save() != before:
        window.act("undo")
    app.act("touch")
    wait("large controls", lambda: window.widget.find("button", "Undo").area()[3] >= FINGER - BORDERS)
    x, y = window.pixel(150, 0)
    desk.drag((x + 17, y), (x + 57, y + 30))
    tap.ok(wait("another place", lambda: b"[150, 0]" not in window.save()), "for fingers it does")


trial(sizes, reach)
