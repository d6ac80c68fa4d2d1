# SPDX-License-Identifier: MIT
"""What cannot be taken is marked and said, changes nothing, and is forgotten when something good comes."""
from desk import trial
from waiting import wait


def refused(tap, desk, window, typed, *reason):
    values, scene = window.values(), window.save()
    field = window.enter("Intensity", typed)
    said = wait("the reason", lambda: window.says(*reason))
    tap.ok(field.has("invalid"), "%r is marked as invalid" % typed)
    tap.note(said)
    tap.equal(field.text, typed, "it stays in the field, to be mended")
    tap.equal(window.values(), values, "the numbers stay")
    tap.equal(window.save(), scene, "and the scene")


def numbers(tap, desk):
    window = desk.start().window()
    refused(tap, desk, window, "abc", "abc", "is not a number")
    refused(tap, desk, window, "-5", "must be at least 0")
    refused(tap, desk, window, "1,5,5", "1,5,5", "is not a number")
    field = window.enter("Intensity", "20")
    wait("the mark to go", lambda: not field.has("invalid"))
    wrong = window.says("must be at least 0") or window.says("is not a number")
    tap.ok(not wrong, "a good value clears the reason")
    tap.equal(wait("twice the brightness", lambda: window.values()[:1] == ["5.455181"] and window.values()[0]),
              "5.455181", "and counts")
    window.act("undo")
    wait("the old value", lambda: field.text == "10")
    tap.ok(not window.enabled("undo"), "what was refused left no step of undo")


def points(tap, desk):
    window = desk.start().window()
    values = window.values()
    window.press("Points")
    field = window.enter("Point 1: x, y in mm", "nowhere", "text box")
    tap.ok(wait("the mark", lambda: field.has("invalid")), "a point that is none is marked")
    tap.equal(window.values(), values, "and changes nothing")
    window.enter("Point 1: x, y in mm", "12,5; -20", "text box")
    wait("the mark to go", lambda: not field.has("invalid"))
    wait("another value", lambda: window.values()[0] != values[0])
    tap.ok(b"points: [[12.5, -20], [150, 0], [-150, 0]]" in window.save(), "a good one is taken, decimal comma and all",
           window.save())


def at_start(tap, desk):
    """What is wrong with the file of the command line stays to be read, though the first picture comes after it."""
    path = desk.path("wrong.yaml")
    with open(path, "w") as file:
        file.write("luxel: 1\nlamps: []\n")
    window = desk.start(path).window()
    wait("the picture of the scene that is shown instead", lambda: len(window.values()) == 3)
    window.act("false-color")
    wait("another picture", lambda: window.state("false-color"))
    tap.ok(window.says(path, "lamps"), "a wrong file at the start is told, and stays told")


trial(at_start, numbers, points)
