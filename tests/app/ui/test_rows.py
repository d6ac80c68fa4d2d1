# SPDX-License-Identifier: MIT
"""Rows of the form are made when first seen: with what the scene has then, at their places; a search finds them."""
from desk import luxel, trial
from waiting import wait

ROLES = ("spin button", "combo box", "text box", "checkbox")


def rows(window):
    """The names of the fields of the chosen source as they stand, from above."""
    end = window.control(None, "Surfaces").area()[1]
    found = [(part.area()[1], part.area()[0], part.name) for role in ROLES for part in window.panes()[0].all(role)]
    return [name for y, _x, name in sorted(found) if 0 < y < end and not name.startswith("Source ")]


def in_order(tap, desk):
    """A row that a value calls for comes to where a form made with that value has it, and goes with it."""
    window = desk.start().window()
    first = rows(window)
    window.choose("Attenuation", 3)
    wait("its numbers", lambda: window.widget.find("spin button", "Coefficients, z"))
    window.choose("Attenuation", 1)
    wait("its length", lambda: "Length k" in rows(window))
    window.choose("Pattern", 1)
    window.click(window.control("checkbox", "Array"))
    wait("the rows of the array", lambda: len(rows(window)) > len(first) + 6)
    late = rows(window)
    with open(desk.path("late.yaml"), "wb") as file:
        file.write(window.save())
    while window.enabled("undo"):
        window.act("undo")
    tap.equal(wait("the rows of before", lambda: len(rows(window)) == len(first) and rows(window)), first,
              "undo takes the rows away")
    desk.apps[-1].quit()
    window = desk.start(desk.path("late.yaml")).window()
    tap.equal(rows(window), late, "rows that came one by one stand as those that came together")


def as_it_is_then(tap, desk):
    """A section that is opened after all of it was changed, and one that is searched while it is closed."""
    with open(desk.path("other.yaml"), "wb") as file:
        file.write(luxel("scene", "report").replace(b": 500", b": 640").replace(b"radiometric", b"photometric"))
    window = desk.start_bare().window()
    tap.equal(window.widget.find("spin button", "Width"), None, "a section that is closed shows no rows")
    window.act("open-path", desk.path("other.yaml"))
    wait("the other scene", lambda: window.title.startswith("other.yaml"))
    desk.key("ctrl+k")
    desk.type("screen.width")
    wait("what is found", lambda: [text for text in window.floating() if "screen.width" in text])
    desk.key("Return")
    field = window.control("spin button", "Width")
    tap.ok(wait("the keyboard", lambda: field.has("focused")), "a row that was not made yet is found")
    tap.equal(field.text, "640", "and has what the scene has now")
    window.choose("Sampling", 0)
    wait("the change", lambda: window.enabled("undo"))
    window.press("Screen and observer", None)
    wait("the section to close", lambda: not window.widget.find("spin button", "Width"))
    window.act("undo")
    window.press("Screen and observer", None)
    tap.ok(wait("what was undone", lambda: "grid nodes" in window.control("combo box", "Sampling").names("label")),
           "what is changed while a section is closed is there when it is opened again")
    window.choose("Type", 6)
    tap.ok(wait("its quantity", lambda: "Illuminance" in rows(window)),
           "rows of another type have the names of the scene's units", rows(window))


trial(in_order, as_it_is_then)
