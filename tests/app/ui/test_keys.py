# SPDX-License-Identifier: MIT
"""All by the keyboard: the keys of the picture, Tab from part to part; the same keys under a Russian layout."""
from accessible import Rejected
from desk import trial
from waiting import wait

# Keys by where they are, whatever letter a layout gives them.
E, R, I, P, D, F, Z, X, C, N, BRACKET_LEFT, BRACKET_RIGHT = "26 27 31 33 40 41 52 53 54 57 34 35".split()


def becomes(tap, name, question):
    tap.ok(wait(name, question), name)


def letters(tap, desk, window, layout):
    """The keys without Ctrl, on the picture."""
    under = " (%s)" % layout
    exposure = window.control("spin button", "Exposure")
    locked = window.control("checkbox", "Range locked")
    becomes(tap, "there is a field for the exposure" + under, lambda: exposure.value == 0)
    desk.key(E, E)
    becomes(tap, "E brightens by half a stop" + under, lambda: exposure.value == 1)
    desk.key("shift+" + E)
    becomes(tap, "Shift+E darkens" + under, lambda: exposure.value == 0.5)
    desk.key(N)
    becomes(tap, "N locks the range" + under, lambda: locked.has("checked") and exposure.value == 0)
    desk.key(E, R)
    becomes(tap, "R resets both" + under, lambda: not locked.has("checked") and exposure.value == 0)
    desk.key(C)
    becomes(tap, "C shows false colours" + under, lambda: window.state("false-color"))
    desk.key(C)
    becomes(tap, "and grey again" + under, lambda: not window.state("false-color"))
    desk.key(I)
    becomes(tap, "I shows isophotes" + under, lambda: window.state("isophotes"))
    desk.key(I)
    becomes(tap, "and hides them" + under, lambda: not window.state("isophotes"))
    desk.key(P)
    becomes(tap, "P pins the picture" + under, lambda: window.enabled("unpin"))
    sides = []
    for _ in range(3):
        before = window.state("side")
        desk.key(D)
        wait("another side", lambda: window.state("side") != before)
        sides.append(window.state("side"))
    tap.equal(sides, ["pinned", "difference", "live"], "D shows A, the difference and B in turn" + under)
    window.act("unpin")
    scale = window.map()[0]
    desk.key("plus" if layout == "us" else "21")
    becomes(tap, "+ zooms" + under, lambda: window.map()[0] > 1.1 * scale)
    desk.key("ctrl+0")
    becomes(tap, "Ctrl+0 shows pixels as they are, which the line at the edge tells" + under,
            lambda: window.says("100 %") == "100 %")
    desk.key(F)
    becomes(tap, "F fits" + under, lambda: abs(window.map()[0] - scale) < 1e-3)


def marks(tap, desk, window, layout):
    """The keys that move what is selected: at first the source."""
    under = " (%s)" % layout
    before = window.save()
    desk.key("Left")
    becomes(tap, "an arrow moves the source by 10 mm" + under, lambda: b"[1990, 0, 2000]" in window.save())
    desk.key("shift+Up")
    becomes(tap, "with Shift by 1 mm" + under, lambda: b"[1990, 1, 2000]" in window.save())
    desk.key("ctrl+Down")
    becomes(tap, "with Ctrl by 100 mm" + under, lambda: b"[1990, -99, 2000]" in window.save())
    desk.key("Prior")
    becomes(tap, "Page Up lifts it" + under, lambda: b"[1990, -99, 2010]" in window.save())
    while window.enabled("undo"):
        steps = window.save()
        desk.key("ctrl+" + Z)
        wait("the undo", lambda: window.save() != steps)
    tap.equal(window.save(), before, "Ctrl+Z takes it back" + under)
    desk.key("ctrl+shift+" + Z)
    becomes(tap, "Ctrl+Shift+Z brings it again" + under, lambda: window.save() != before)
    desk.key("ctrl+" + Z)
    becomes(tap, "and Ctrl+Z takes it back" + under, lambda: window.save() == before)
    desk.key(BRACKET_RIGHT)
    desk.key("Up")
    becomes(tap, "] goes on to the first point" + under, lambda: b"points: [[0, 10], " in window.save())
    desk.key("ctrl+" + Z, BRACKET_LEFT, BRACKET_LEFT, "Up")
    becomes(tap, "[ back to the sphere" + under, lambda: b"center: [0, 10, 1000]" in window.save())
    desk.key("ctrl+" + Z, BRACKET_RIGHT)
    becomes(tap, "and all as before" + under, lambda: window.save() == before)


def latin(tap, desk):
    window = desk.start().window()
    marks(tap, desk, window, "us")
    window.press("Picture")
    letters(tap, desk, window, "us")


def cyrillic(tap, desk):
    desk.layout("ru")
    window = desk.start().window()
    marks(tap, desk, window, "ru")
    window.press("Picture")
    letters(tap, desk, window, "ru")


def both_layouts(tap, desk):
    desk.layout("us,ru", "-option", "grp:caps_toggle")
    window = desk.start().window()
    before = window.save()
    desk.key("Left")
    wait("the move", lambda: window.save() != before)
    desk.key("66")  # Caps Lock: from here on Russian
    desk.key("ctrl+" + Z)
    becomes(tap, "Ctrl+Я undoes after the layout was switched", lambda: window.save() == before)
    desk.key(C)
    becomes(tap, "С shows false colours", lambda: window.state("false-color"))


def focused(window):
    """The name of what has the keyboard."""
    widget = window.widget.find(state="focused")
    return widget and widget.name


class Walk:
    """A walk by Tab: what has the keyboard next is looked for behind what had it, as the whole window takes a while."""

    def __init__(self, window):
        self.widgets = list(window.widget.all())
        self.place = 0

    def name(self, step=1):
        """The name of what has the keyboard, looked for forward or, by a step of -1, backward."""
        for _ in self.widgets:
            try:
                if self.widgets[self.place].has("focused"):
                    return self.widgets[self.place].name
            except Rejected:  # gone meanwhile
                pass
            self.place = (self.place + step) % len(self.widgets)
        return None


def from_part_to_part(tap, desk):
    window = desk.start().window()
    tap.equal(focused(window), "Picture", "at the start the picture has the keyboard")
    wanted = {"Picture", "Position, x", "Intensity", "Attenuation", "Material",
              "Shininess n", "Only source 1", "Source 1 on", "Add a source", "Points", "Open"}
    met, walk = set(), Walk(window)
    for _ in range(120):
        desk.key("Tab")
        met.add(walk.name())
        if wanted <= met:
            break
    tap.ok(wanted <= met, "Tab goes to every part", "not met: %s" % sorted(wanted - met), sorted(map(str, met)))
    tap.equal([name for name in met if not name or name.startswith("Gtk")], [], "and each has a name to be read out")
    for _ in range(120):
        if walk.name(-1) == "Intensity":
            break
        desk.key("shift+Tab")
    desk.key("ctrl+a")
    desk.type("33")
    desk.key("Return")
    becomes(tap, "where Tab goes, numbers can be typed", lambda: b"intensity: 33" in window.save())
    desk.key("F10")
    becomes(tap, "F10 opens the menu", lambda: window.widget.find("menu item") or window.says("Open…"))
    desk.key("Escape")
    desk.key("F9")
    becomes(tap, "F9 hides the numbers", lambda: not window.state("numbers"))
    desk.key("F9")
    becomes(tap, "and shows them", lambda: window.state("numbers"))


def pane(window):
    """Which pane has the keyboard, by where on the window it is."""
    focus = window.widget.find(state="focused")
    left, picture = window.panel(), window.panes()[1].find("image").area()
    x, y = focus.area()[:2]
    return ("scene" if x < left[0] + left[2] else "numbers" if x >= picture[0] + picture[2]
            else "picture" if focus.role == "image" else "bar" if y >= picture[1] + picture[3] else "other")


def round_the_panes(tap, desk):
    window = desk.start().window()
    met = []
    for _ in range(4):
        before = focused(window)
        desk.key("F6")
        wait("another part with the keyboard", lambda: focused(window) != before)
        met.append(pane(window))
    tap.equal(met, ["numbers", "bar", "scene", "picture"], "F6 goes round the panes")
    desk.key("shift+F6")
    becomes(tap, "Shift+F6 goes back", lambda: pane(window) == "scene")
    for key, name in (("ctrl+3", "numbers"), ("ctrl+1", "scene"), ("ctrl+2", "picture")):
        desk.key(key)
        becomes(tap, "%s goes to the %s" % (key, name), lambda: pane(window) == name)
    desk.key("F9")
    wait("no numbers", lambda: not window.state("numbers"))
    desk.key("ctrl+3")
    becomes(tap, "which are shown where they were not", lambda: window.state("numbers") and pane(window) == "numbers")


def digits(tap, desk):
    window = desk.start("three-lights").window()
    items = list(window.widget.find("list").all("list item"))
    for number in (3, 1, 2):
        desk.key(str(number))
        becomes(tap, "%d chooses that source" % number,
                lambda: [item.has("selected") for item in items] == [i == number - 1 for i in range(3)])
    desk.key("9")
    tap.ok(items[1].has("selected"), "a digit without a source chooses none")


def keys_in_fields(tap, desk):
    window = desk.start().window()
    window.enter("Name", "nerd.fic", "text box")
    becomes(tap, "letters that are typed into a field are its own", lambda: b"name: nerd.fic" in window.save()
            or b'name: "nerd.fic"' in window.save())
    tap.ok(not window.state("false-color") and not window.state("isophotes"), "and switch nothing")


trial(latin, cyrillic, both_layouts, from_part_to_part, round_the_panes, digits, keys_in_fields)
