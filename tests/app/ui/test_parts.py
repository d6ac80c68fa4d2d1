# SPDX-License-Identifier: MIT
"""The other parts of the window: names that are dragged, sections, comparing, light from afar, dialogs."""
import re

from desk import trial
from waiting import wait


def dragged_names(tap, desk):
    window = desk.start().window()
    before, values = window.save(), window.values()
    x, y = window.place(window.control("label", "Radius"))
    desk.drag((x, y), (x + 2, y))
    tap.equal(window.save(), before, "a click with two dots of jitter changes nothing")
    desk.drag((x, y), (x + 9, y))
    wait("other numbers", lambda: window.values() != values)
    after = window.save()
    tap.ok(after != before and b"radius: 300" not in after, "a name that is dragged changes the scene")
    radius = float(re.search(rb"radius: ([\d.]+)", after).group(1))
    tap.equal(float(window.control("spin button", "Radius").text), radius, "and the field beside it")
    window.act("undo")
    tap.equal(window.save(), before, "its whole way is one step of undo")
    wait("the old numbers", lambda: window.values() == values)
    window.enter("Radius", "250")
    wait("other numbers", lambda: window.values() != values)
    window.click(window.control("label", "Radius"), count=2)
    wait("the old numbers", lambda: window.values() == values)
    tap.equal(window.save(), before, "a double click on the name brings the old value back")


def surfaces(tap, desk):
    window = desk.start().window()
    before, values = window.save(), window.values()
    tap.ok(not window.enabled("surface-delete"), "the only surface stays")
    for count, kind in enumerate(("sphere", "cylinder", "disk", "rectangle"), 2):
        window.act("surface-add", kind)
        wait("one more surface", lambda: window.save().count(b"{type: " + kind.encode()) == 1)
        tap.ok(wait("it is chosen", lambda: window.says("%d  %s" % (count, kind))), "a %s is added and chosen" % kind)
        tap.equal(window.says("Not this scene"), None, "and stands where it can be computed")
    window.press("Duplicate the surface")
    tap.ok(wait("the double", lambda: window.save().count(b"{type: rectangle") == 2), "a surface is doubled")
    window.press("Delete the surface")
    tap.ok(wait("no double", lambda: window.save().count(b"{type: rectangle") == 1), "and deleted")
    for _ in range(6):
        window.act("undo")
    tap.equal(window.save(), before, "undo takes all of it back")
    wait("the old numbers", lambda: window.values() == values)
    window.act("redo")
    tap.ok(wait("a surface", lambda: window.enabled("surface-delete")), "redo brings it")


def vectors(tap, desk):
    window = desk.start().window()
    fields = [window.control("spin button", "Position, " + axis) for axis in "xyz"]
    tap.equal(len({field.area()[1] for field in fields}), 1, "x, y and z stand in one line")
    places = [field.area()[0] for field in fields]
    tap.equal(places, sorted(places), "in their order")
    tap.ok(all(field.area()[2] >= 40 for field in fields), "each with room for its digits", fields)
    form = [window.control(*part) for part in (("combo box", "Type"), ("spin button", "Intensity"),
                                               ("combo box", "Attenuation"), ("combo box", "Pattern"))]
    left, right = ([part.area()[0] + side * part.area()[2] for part in form] for side in (0, 1))
    tap.ok(max(left) - min(left) <= 2 and max(right) - min(right) <= 2, "fields and lists have one edge and one width",
           left, right)
    name = next(label for label in window.widget.all("label", "y")
                if abs(label.area()[1] - fields[1].area()[1]) < 20)
    x, y = window.place(name)
    values = window.values()
    desk.drag((x, y), (x + 20, y))
    wait("other numbers", lambda: window.values() != values)
    place = re.search(rb"position: \[2000, ([\d.]+), 2000\]", window.save())
    tap.ok(place and float(place.group(1)) > 100, "each name moves its own number", window.save())
    window.act("undo")
    tap.ok(wait("as before", lambda: b"position: [2000, 0, 2000]" in window.save()), "its way is one step of undo")
    window.enter("Position, z", "1e999")
    tap.ok(wait("what is wrong", lambda: window.says("1e999")), "what cannot be taken is said below")
    desk.key("Escape")
    window.enter("Position, x", "1234")
    window.enter("Position, y", "-17")
    wait("another place", lambda: window.enabled("undo"))
    window.click(window.control("label", "Position"), count=2)
    wait("the old place", lambda: window.control("spin button", "Position, x").text == "2000")
    tap.ok(b"position: [2000, 0, 2000]" in window.save(),
           "a double click on the name brings all three back, as they were saved")


def opened(tap, desk):
    """A part at the bottom that is opened is brought into sight."""
    window = desk.start().window()
    window.press("Screen and observer", None)
    panel = window.panel()
    field = window.control("combo box", "Projection")
    seen = lambda: panel[1] <= field.area()[1] and field.area()[1] + field.area()[3] <= panel[1] + panel[3]
    tap.ok(wait("the panel", seen), "what it holds is seen", panel, field.area())


def sections(tap, desk):
    window = desk.start().window()
    window.press("Section", "tab")
    wait("the section", lambda: window.says("Through x = 0, y = 0 mm"))
    before = window.save()
    desk.drag(window.pixel(0, 60), window.pixel(90, 60))
    said = wait("another place", lambda: window.says("Through x = ", ", y = 0 mm") and
                not window.says("Through x = 0,") and window.says("Through x = "))
    tap.ok(abs(float(re.search(r"x = (\S+),", said).group(1)) - 90) <= 2, "the vertical line is dragged", said)
    tap.equal(window.save(), before, "which changes nothing of the scene")
    tap.ok(not window.enabled("undo"), "and is no step of undo")


def comparing(tap, desk):
    window = desk.start().window()
    wait("a picture to be pinned", lambda: window.act("pin") or window.enabled("unpin"))
    field = window.control("spin button", "Intensity")
    field.value = 20
    said = wait("the comparison", lambda: not window.says("largest difference 0 ") and
                window.says("largest difference", "%"))
    difference = float(re.search(r"difference (\S+)", said).group(1))
    tap.near(difference, 11.747531890869141, 1e-4, "twice the light differs by the maximum of before")
    window.press("Difference B − A")
    tap.equal(wait("the difference", lambda: window.state("side") == "difference" and window.state("side")),
              "difference", "the difference is shown")
    field.value = 10
    tap.ok(wait("no difference", lambda: window.says("largest difference 0 ")), "the same scene has none")
    window.press("Unpin")
    wait("the end", lambda: not window.enabled("unpin"))
    tap.equal(window.state("side"), "live", "unpinned, the present picture is shown")


def from_afar(tap, desk):
    window = desk.start().window()
    window.act("new", "distant")
    wait("its scene", lambda: "distant" in window.title)
    before = window.save()
    direction = [float(number) for number in re.search(rb"direction: \[([^\]]*)\]", before).group(1).split(b",")]
    sides = [float(re.search(rb"%s: ([\d.]+)" % name, before).group(1)) for name in (b"width", b"height")]
    length, radius = sum(number * number for number in direction) ** 0.5, min(sides) / 2
    start = window.pixel(-direction[0] / length * radius, -direction[1] / length * radius)
    desk.drag(start, (start[0] + 30, start[1] + 20))
    after = wait("another direction", lambda: window.save() != before and window.save())
    found = [float(number) for number in re.search(rb"direction: \[([^\]]*)\]", after).group(1).split(b",")]
    tap.near(sum(number * number for number in found), 1, 1e-3, "light from afar is turned by its mark")
    desk.key("ctrl+z")
    tap.ok(wait("the direction of before", lambda: window.save() == before), "one undo turns it back")


def dialogs(tap, desk):
    app = desk.start()
    window = app.window()
    for name, key in (("the shortcuts", "ctrl+question"), ("a file to open", "ctrl+o"), ("a file to save", "ctrl+s"),
                      ("a picture to export", "ctrl+e")):
        before = app.on_screen()
        desk.key(key)
        opened = wait(name, lambda: app.on_screen() - before)
        tap.ok(True, "%s asks for %s" % (key, name))
        desk.hand("windowfocus", "--sync", *opened)
        desk.key("Escape")
        wait("the end of it", lambda: app.on_screen() == before)
        window.raise_()
    before = app.on_screen()
    app.act("about")
    opened = wait("about", lambda: app.on_screen() - before)
    desk.hand("windowfocus", "--sync", *opened)
    desk.key("Escape")
    wait("the end of it", lambda: app.on_screen() == before)
    app.act("color-scheme", "dark")
    app.act("color-scheme", "light")
    tap.equal(window.values()[0], "2.727591", "light or dark, the numbers stay")


trial(dragged_names, surfaces, vectors, opened, sections, comparing, from_afar, dialogs)
