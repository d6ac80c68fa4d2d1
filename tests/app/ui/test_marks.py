# SPDX-License-Identifier: MIT
"""The marks on the picture: the wheel over them, names, tooltips, and how list and marks light each other up."""
import re

from desk import luxel, trial
from waiting import wait

NEAR = 24  # levels, within which a dot at an edge has the colour
SHARE = re.compile(r"Share (\S+), (\S+) %")
MARK = 40  # dots that a mark and its ring are wide at the most


def wheel(tap, desk):
    """The wheel zooms wherever it turns; with Alt it lifts a source, which is the chosen one from then on."""
    path = desk.path("two.yaml")
    luxel("set", "report", "-s", "lights[0].position=[200, 100, 2000]", "-s",
          "lights=[{type: point, position: [200, 100, 2000], intensity: 10, attenuation: none}, "
          "{type: point, position: [-150, -120, 1800], intensity: 10, attenuation: none}]", "-o", path)
    window = desk.start(path).window()
    wait("two sources", lambda: len(window.sources()) == 2)
    scene, scale = window.save(), window.map()[0]
    x, y = window.pixel(-150, -120)
    desk.click(x, y, 4, 3)
    wait("a greater scale", lambda: window.map()[0] > 1.3 * scale)
    tap.equal(window.save(), scene, "the wheel over a source zooms, and moves nothing")
    window.act("fit")
    wait("the whole picture", lambda: abs(window.map()[0] - scale) < 1e-3)
    desk.move(*window.pixel(-150, -120))
    desk.hand("keydown", "alt", "click", "4", "click", "4", "click", "4", "keyup", "alt")
    tap.ok(wait("the height", lambda: b"[-150, -120, 1830]" in window.save()), "with Alt it lifts the source")
    rows = list(window.widget.find("list").all("list item"))
    tap.ok(wait("the choice", lambda: rows[1].has("selected")), "which is chosen, so that the form shows its numbers")
    tap.equal(window.control("spin button", "Position, z").text, "1830", "as it does")
    desk.move(*window.pixel(100, -200))
    desk.hand("keydown", "alt", "click", "5", "keyup", "alt")
    lowered = wait("the height", lambda: b"[-150, -120, 1820]" in window.save())
    tap.ok(lowered, "beside all marks it lowers the chosen one")


def names(tap, desk):
    window = desk.start().window()
    window.act("new", "three-lights")
    wait("three sources", lambda: len(window.sources()) == 3)
    window.pointed(*window.pixel(140, 0))
    said = wait("the shares", lambda: window.says("sources "))
    tap.ok(re.search(r"sources 2: [\d.]+, 1: [\d.]+$", said), "of the sources' shares the greatest is told first", said)
    area = window.picture_area()
    desk.move(area[0] + area[2] / 2, area[1] + area[3] + 20)
    tap.ok(window.tooltip(*window.pixel(200, 0), "Point P3"), "a point says its name and place")
    rows = list(window.widget.find("list").all("list item"))
    # the second source is an arrow at the right edge; its row lights it up
    place = arrow_of(desk, window, rows[1])
    tap.ok(place, "the row of a source lights up its mark", place)
    said = window.tooltip(*place, "Source 2 fill")
    tap.ok(re.search(r"x \S+, y \S+, z \S+ mm", said), "which says its number, its name and where it is", said)


def arrow_of(desk, window, row):
    """Where dots become white when the pointer is on a row: the middle of the ring around the mark, which is in the
    right third of the picture; the row's own tooltip may reach over the rest."""
    x, y, width, height = (round(number) for number in window.picture_area())
    x, width = x + width - width // 3, width // 3

    def at_rest():
        """The picture without tooltips, twice the same."""
        seen = desk.screen(x, y, width, height)
        desk.hand("sleep", "0.3")
        alone = not any("\nx " in text for text in window.floating())
        return seen if alone and seen == desk.screen(x, y, width, height) else None

    desk.move(x, y + height + 20)
    before = wait("the picture to rest", at_rest)
    desk.move(*window.place(row))

    def ring():
        after = desk.screen(x, y, width, height)
        dots = [i for i in range(0, len(after), 3) if after[i:i + 3] != before[i:i + 3] and min(after[i:i + 3]) > 230]
        across, down = [i // 3 % width for i in dots], [i // 3 // width for i in dots]
        if len(dots) < 20 or max(across) - min(across) > MARK or max(down) - min(down) > MARK:
            return None
        return x + sum(across) / len(dots), y + sum(down) / len(dots)

    return wait("the ring around a mark", ring)


def dark(tap, desk):
    """Where there is no light, there is no maximum to be marked."""
    window = desk.start().window()
    area = window.picture_area()

    def red():
        data = desk.screen(*(round(number) for number in window.picture_area()))
        return sum(1 for i in range(0, len(data), 3) if data[i] > 200 and data[i + 1] < 130 and data[i + 2] < 130)

    wait("the mark of the maximum", lambda: red() > 5)
    window.act("source-delete")
    wait("no sources", lambda: not window.sources())
    tap.ok(wait("no mark", lambda: red() == 0), "a black picture has no mark of its maximum")
    desk.move(area[0] + 5, area[1] + 5)
    window.act("paste")
    tap.ok(wait("a word about it", lambda: window.says("there is no text on the clipboard")),
           "an empty clipboard is said to be empty")


def shares(tap, desk):
    """One colour a source, and its share of what is under the pointer."""
    window = desk.start().window()
    window.act("source-duplicate")
    wait("two sources", lambda: len(window.sources()) == 2)
    window.act("false-color")
    list_area = window.widget.find("list").area()
    left, top = window.edges()

    def dots(color):
        area = [round(number) for number in (left + list_area[0], top + list_area[1], list_area[2], list_area[3])]
        data = desk.screen(*area)
        return sum(1 for i in range(0, len(data), 3)
                   if all(abs(data[i + k] - color[k]) <= NEAR for k in range(3)))

    for color in ((201, 130, 24), (16, 156, 229)):
        tap.ok(wait("its colour", lambda: dots(color) > 40), "the list has a badge in the colour of the curve", color)
    tap.equal(window.widget.find("list").names(None, "Share"), ["Share", "Share"],
              "without a pointer there is no share")
    window.pointed(*window.pixel(0, 0))
    found = wait("the shares", lambda: [match for match in (SHARE.fullmatch(part.name) for part in
                                                            window.widget.find("list").all()) if match])
    tap.equal(len(found), 2, "under the pointer each source has its share")
    tap.ok(abs(sum(float(match.group(2)) for match in found) - 100) < 0.2, "which together are the whole")
    told = dict(part.split(": ") for part in window.says("sources ").rpartition("sources ")[2].split(", "))
    tap.equal(sorted(told.values()), sorted(match.group(1) for match in found), "the line at the edge says the same")


def values_in_pixels(tap, desk):
    window = desk.start().window()
    x, y, width, height = (round(number) for number in window.picture_area())

    def whites():
        # left of the middle and below it, where no mark is and no hint
        data = desk.screen(x + 40, y + height // 2 + 60, width // 2 - 80, height // 2 - 120)
        return sum(min(data[i:i + 3]) > 180 for i in range(0, len(data), 3))

    def zoom(times):
        for _ in range(times):
            window.act("zoom-in")

    desk.move(x + width / 2, y + height + 20)
    zoom(8)
    wait("the zoom", lambda: window.says(" %") and not window.says("146 %"))
    tap.equal(whites(), 0, "pixels that are somewhat larger have no numbers in them")
    zoom(11)
    tap.ok(wait("numbers", lambda: whites() > 40), "those with room for it have")
    window.act("fit")
    tap.ok(wait("no numbers", lambda: whites() == 0), "and they are gone when all is in view")


trial(wheel, names, values_in_pixels, dark, shares)
