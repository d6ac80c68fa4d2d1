# SPDX-License-Identifier: MIT
"""Places copied in another program become sources or points, however they are written; values are copied from here."""
import re

from desk import trial
from waiting import wait

SOURCES = [
    ("2000, 0, 2000; -500,5 100 1500", ["[2000, 0, 2000]", "[-500.5, 100, 1500]"]),
    ("[1, 2, 3]\n[4, 5, 6]\n", ["[1, 2, 3]", "[4, 5, 6]"]),
    ("10\t20\t30\r\n40\t50\t60", ["[10, 20, 30]", "[40, 50, 60]"]),
    ("0,5 1,5 2000", ["[0.5, 1.5, 2000]"]),
]
POINTS = [
    ("10, 20; 30, 40", "[10, 20], [30, 40]"),
    ("−10 20,5", "[-10, 20.5]"),
]


def sources(tap, desk):
    window = desk.start().window()
    before = window.save()
    for text, places in SOURCES:
        desk.copy(text)
        window.press("Paste sources: x, y, z; x, y, z")
        wait("the sources", lambda: len(window.sources()) == 1 + len(places))
        found = re.findall(r"position: (\[[^\]]*\])", window.save().decode())
        tap.equal(found, ["[2000, 0, 2000]"] + places, "%r becomes sources" % text)
        tap.ok(window.save().count(b"intensity: 10") == 1 + len(places), "as strong as the chosen one")
        window.act("undo")
        tap.equal(window.save(), before, "which one undo takes back")


def points(tap, desk):
    window = desk.start().window()
    before = window.save()
    for text, places in POINTS:
        desk.copy(text)
        window.act("point-paste")
        count = 3 + places.count("[")
        wait("the points", lambda: len(window.values()) == count)
        tap.ok(b"points: [[0, 0], [150, 0], [-150, 0], %s]" % places.encode() in window.save(),
               "%r becomes points" % text, window.save())
        window.act("undo")
        wait("the points of before", lambda: len(window.values()) == 3)
        tap.equal(window.save(), before, "which one undo takes back")


def by_keys(tap, desk):
    window = desk.start().window()
    before = window.save()
    desk.copy("100, 200, 2500")
    desk.key("ctrl+v")
    wait("a source", lambda: len(window.sources()) == 2)
    tap.ok(b"position: [100, 200, 2500]" in window.save(), "Ctrl+V on the picture: three numbers are a source")
    window.act("undo")
    wait("one source", lambda: len(window.sources()) == 1)
    desk.copy("33, 44")
    desk.key("ctrl+v")
    wait("a point", lambda: len(window.values()) == 4)
    tap.ok(b"[33, 44]" in window.save(), "two are a point")
    window.act("undo")
    desk.copy("no numbers at all")
    desk.key("ctrl+v")
    tap.ok(wait("a word about it", lambda: window.says("no numbers at all")), "what is neither is said to be none")
    tap.equal(window.save(), before, "and changes nothing")
    # In a field the same keys paste text.
    desk.copy("42")
    window.enter("Intensity", "", key=None)
    desk.key("ctrl+a", "ctrl+v", "Return")
    tap.ok(wait("the number", lambda: b"intensity: 42" in window.save()), "in a field they paste into the field")


def from_here(tap, desk):
    window = desk.start().window()
    window.click(window.control("label", "Intensity"), button=3)
    wait("the menu", lambda: window.widget.find("button", "Copy as key=value"))
    window.press("Copy as key=value")
    wait("a text on the clipboard", lambda: desk.copied() == "lights[0].intensity=10", 10)
    tap.ok(True, "a value is copied as the command line takes it")


trial(sources, points, by_keys, from_here)
