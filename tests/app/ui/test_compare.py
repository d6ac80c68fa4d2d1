# SPDX-License-Identifier: MIT
"""With a picture pinned, whatever is shown, the picture and every number beside it speak of the same scene."""
import re

from desk import trial
from waiting import wait


def pointed_value(window, x, y):
    """What the line at the edge says when the pointer rests there."""
    window.pointed(x, y)
    return wait("a value", lambda: next((text for text in window.labels() if re.match(r"x ", text)
                                         and ("W/" in text or "relative" in text)), None))


def sides(tap, desk):
    window = desk.start().window()
    wait("a picture to be pinned", lambda: window.act("pin") or window.enabled("unpin"))
    window.press("Statistics", "tab")
    first = wait("its numbers", lambda: len(window.values()) == 3 and window.values())
    wait("its statistics", lambda: "11.74753" in window.labels())
    window.control("spin button", "Intensity").value = 25
    second = wait("other numbers", lambda: window.values() != first and window.values())
    wait("other statistics", lambda: "29.36883" in window.labels())
    place = window.pixel(0, 60)
    live = pointed_value(window, *place)
    desk.key("d")
    wait("A", lambda: window.state("side") == "pinned")
    tap.ok(wait("A's points", lambda: window.values() == first), "with A shown the points' values are A's")
    tap.ok(wait("A's statistics", lambda: "11.74753" in window.labels()), "and the statistics", window.labels())
    tap.ok(window.says("Uniformity U0") and window.says("Least value above 0"), "uniformity and least value among them")
    pinned = pointed_value(window, *place)
    tap.ok("   A:" in pinned, "the line at the edge says that it reads A", pinned)
    number = re.compile(r"N \([^)]*\)\t(\S+)")
    tap.near(float(number.search(live).group(1)), 2.5 * float(number.search(pinned).group(1)), 1e-4, "and does")
    desk.key("d")
    wait("the difference", lambda: window.state("side") == "difference")
    expected = float(second[0]) - float(first[0])
    wait("its points", lambda: window.values() not in (first, second))
    tap.near(float(window.values()[0]), expected, 1e-5, "at the difference the points' values are B - A")
    tap.ok(window.says("B − A: brightness"), "which is said where the unit is")
    tap.ok(wait("its statistics", lambda: "17.6213" in window.labels()),
           "the greatest difference stands in the statistics")
    for name in "Uniformity U0", "Diversity Ud", "Least value above 0", "Minimum where light arrives":
        tap.equal(window.says(name), None, "a difference has no such line: " + name)
    read = pointed_value(window, *place)
    found = re.search(r"A (\S+)   B (\S+)   B − A (\S+) ", read)
    tap.ok(found, "the line at the edge tells A, B and B - A", read)
    a, b, difference = (float(text) for text in found.groups())
    tap.near(difference, b - a, 1e-4, "which agree")
    window.press("Section", "tab")
    wait("the section", lambda: window.says("Through x = 0"))
    desk.key("d")
    wait("B", lambda: window.state("side") == "live")
    tap.ok(wait("B's points", lambda: window.values() == second), "then everything is B's again")
    tap.equal([window.widget.find("button", name) is not None for name in ("Pinned A", "Live B")], [True, True],
              "the buttons say which is which")


def untouched(tap, desk):
    """Marks of A are of what was: they move nothing of B."""
    window = desk.start().window()
    wait("a picture to be pinned", lambda: window.act("pin") or window.enabled("unpin"))
    window.enter("Centre, x", "50")
    scene = wait("the change", lambda: b"[50, 0, 1000]" in window.save() and window.save())
    desk.hand("windowfocus", "--sync", window.screen_id)
    window.act("side", "pinned")
    wait("A", lambda: window.state("side") == "pinned")
    desk.hand("sleep", "0.5")
    desk.drag(window.pixel(150, 0), window.pixel(100, 80))
    desk.hand("sleep", "0.3")
    tap.equal(window.save(), scene, "a point of A that is pulled moves nothing of B")


trial(sides, untouched)
