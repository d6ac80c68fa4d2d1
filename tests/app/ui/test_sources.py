# SPDX-License-Identifier: MIT
"""The list of sources: adding, doubling, moving, deleting, switching off, looking at one alone; undo of each."""
import json
import math
import re

from desk import luxel, trial
from waiting import Late, wait
from window import HOVER


def kinds(window):
    return [name.split(None, 1)[1] for name in window.sources()]


def checked(desk, window):
    """The saved scene is in order by the tool's judgement; its bytes."""
    path = desk.path("checked.yaml")
    scene = window.save(path)
    luxel("check", path)
    return scene


def list_of_sources(tap, desk):
    window = desk.start().window()
    first = window.save()
    window.act("source-add", "spot")
    wait("two sources", lambda: len(kinds(window)) == 2)
    tap.equal(kinds(window), ["point", "spot"], "a spot is added")
    checked(desk, window)
    tap.ok(wait("flux and irradiance", lambda: len([text for text in window.labels() if re.match(
        r"Φ \S+ W   E \S+( \S+)?$", text)]) == 2), "each source says its flux and what it gives to the surface")
    window.press("Duplicate the source")
    wait("three", lambda: len(kinds(window)) == 3)
    tap.equal(kinds(window), ["point", "spot", "spot"], "it is doubled")
    checked(desk, window)
    window.click(window.control("list item", "1  point"))
    window.press("Move the source down")
    tap.equal(wait("the order", lambda: kinds(window)[0] == "spot" and kinds(window)), ["spot", "point", "spot"],
              "a source is moved down")
    checked(desk, window)
    window.press("Delete the source")
    tap.equal(wait("two", lambda: len(kinds(window)) == 2 and kinds(window)), ["spot", "spot"], "and deleted")
    checked(desk, window)
    for _ in range(4):
        window.act("undo")
    tap.equal(window.save(), first, "four undos take it all back, to the byte")
    tap.ok(not window.enabled("undo"), "and there are no more")


def every_kind(tap, desk):
    window = desk.start().window()
    kinds_of_lights = json.loads(luxel("schema"))["definitions"]
    names = [key[len("lights-"):] for key, kind in kinds_of_lights.items()
             if key.startswith("lights-") and "file" not in kind.get("required", [])]
    for name in names:
        window.act("source-add", name)
        checked(desk, window)
    tap.equal(sorted(kinds(window)), sorted(names + ["point"]), "every kind that needs no file can be added")
    tap.equal(window.says("error"), None, "without a fault")
    window.act("source-delete")
    while len(window.sources()) > 1:
        window.act("source-delete")
    window.act("source-delete")
    tap.equal(window.sources(), [], "all can be deleted")
    tap.ok(not window.enabled("source-delete"), "then there is nothing to delete")
    checked(desk, window)


def names_of_quantities(tap, desk):
    """In photometric units the form speaks of illuminance, in radiometric ones of irradiance."""
    window = desk.start().window()
    window.act("new", "desk")
    window.click(window.control("list item", "2  room (ambient)"))
    tap.ok(wait("a row of the illuminance", lambda: window.says("Illuminance")), "illuminance in lx")
    tap.equal(window.says("Irradiance"), None, "and no irradiance")
    window.act("new", "ambient")
    tap.ok(wait("a row of the irradiance", lambda: window.says("Irradiance")), "irradiance in W/m²")
    tap.equal(window.says("Illuminance"), None, "and no illuminance")


def on_off_alone(tap, desk):
    window = desk.start().window()
    window.act("new", "three-lights")
    wait("three sources", lambda: len(window.sources()) == 3)
    values = wait("their numbers", lambda: len(window.values()) == 4 and window.values())
    scene = window.save()
    switch = window.control("checkbox", "Source 2 on")
    window.click(switch)
    wait("the source to be off", lambda: not switch.has("checked"))
    wait("other numbers", lambda: window.values() != values)
    off = checked(desk, window)
    tap.ok(b"enabled: false" in off, "a source is switched off in the scene")
    window.click(switch)
    wait("the numbers of before", lambda: window.values() == values)
    tap.ok(b"enabled: false" not in window.save(), "and on again")
    window.act("undo")
    window.act("undo")
    tap.equal(window.save(), scene, "both steps can be undone")
    wait("the numbers of before", lambda: window.values() == values)
    window.press("Only source 1")
    wait("the numbers of one", lambda: window.values() != values)
    tap.equal(window.save(), scene, "one source alone is only looked at: the scene stays")
    path = desk.path("one.yaml")
    with open(path, "wb") as file:
        file.write(scene)
    alone = json.loads(luxel("probe", path, "-s", "lights[1].enabled=false", "-s", "lights[2].enabled=false", "--json"))
    tap.equal(window.values(), ["%.7g" % one["value"] for one in alone["points"]], "its numbers are those of it alone")
    window.press("Only source 1")
    tap.ok(wait("all", lambda: window.values() == values), "and then all shine again")


def aimed(tap, desk):
    window = desk.start().window()
    window.act("source-add", "spot")
    wait("the spot", lambda: len(window.sources()) == 2)
    window.press("Aim the source at the surface")
    tap.ok(wait("the aim", lambda: b"aim: [0, 0, 1000]" in checked(desk, window)), "a spot is aimed at the sphere")


def choose_type(desk, window, place, kind):
    window.choose("Type", place)
    wait("a " + kind, lambda: kinds(window) == [kind])


def other_type(tap, desk):
    """A list of choices, and the menu of a row, that make the form another one while they are open."""
    window = desk.start().window()
    scene = window.save()
    for place, kind in ((2, "spot"), (4, "planar"), (5, "volume"), (6, "distant"), (7, "ambient")):
        choose_type(desk, window, place, kind)
        checked(desk, window)
    tap.equal(window.says("error"), None, "the type of a source is chosen by hand, each kind gives a good scene")
    choose_type(desk, window, 2, "spot")
    window.click(window.control("label", "Type"), button=3)
    window.press("Back to what was opened")
    wait("what was saved", lambda: kinds(window) == ["ambient"])
    for _ in range(7):
        window.act("undo")
    tap.equal(window.save(), scene, "taken back by the menu of a row that goes with it, and undone")


def another_key(tap, desk):
    """The menu of a row, and a key that is given instead of its own."""
    window = desk.start().window()
    window.act("source-add", "planar")
    wait("the planar source", lambda: len(kinds(window)) == 2)
    given, other = "Radiance", "Power"
    wait("its form", lambda: window.widget.find("spin button", given))

    def there():
        return window.widget.find("spin button", other)

    def choose():
        """A form that is just laid out may take the menu away again."""
        if there():
            return True
        window.click(window.control("label", given), button=3)
        window.press("Give “%s” instead" % other)
        try:
            return wait("the other row", there, HOVER)
        except Late:
            return False

    wait("the other key", choose)
    scene = checked(desk, window).decode()
    tap.ok(other.lower() + ":" in scene and given.lower() + ":" not in scene.split("planar")[1].split("\n")[0],
           "%s is given instead of %s" % (other.lower(), given.lower()), scene)


LIGHT = re.compile(rb"\{type: point, position: \[([^]]*)\], intensity: ([^,]*)")


def lights(window):
    """Places and intensities of the sources, as the scene is saved."""
    return [([float(number) for number in place.split(b",")], float(intensity))
            for place, intensity in LIGHT.findall(window.save())]


def scene_of(desk, *lamps):
    """A window of the lab report's sphere under other lamps, each a mapping of YAML."""
    path = desk.path("lamps.yaml")
    head, rest = luxel("scene", "report").split(b"lights:\n")
    with open(path, "wb") as file:
        file.write(head + b"lights:\n" + b"".join(b"  - {%s}\n" % lamp for lamp in lamps) + rest.split(b"\n", 1)[1])
    return desk.start(path).window()


def three_in_view(desk):
    """A scene of three point sources that are all seen, and the window of it."""
    return scene_of(desk, *(b"type: point, position: [%d, %d, 2000], intensity: %d, attenuation: none" % lamp
                            for lamp in ((-100, 100, 3), (120, 60, 4), (0, -150, 5))))


def chosen(window):
    return [row.has("selected") for row in window.widget.find("list").all("list item")]


def several_by_list(tap, desk):
    window = three_in_view(desk)
    before = window.save()
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[1])
    wait("the second", lambda: chosen(window) == [False, True, False])
    window.click(rows[0])
    tap.ok(wait("the first", lambda: chosen(window) == [True, False, False]), "a click chooses one alone")
    desk.move(*window.place(rows[2]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("two", lambda: chosen(window) == [True, False, True]), "Ctrl and a click choose one more source")
    tap.ok(wait("how many", lambda: window.says("2 sources")), "which is said above the form")
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("one", lambda: chosen(window) == [True, False, False]), "and once more, that it is no longer")
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    wait("two", lambda: chosen(window) == [True, False, True])
    window.enter("Intensity", "7")
    tap.ok(wait("both", lambda: [one[1] for one in lights(window)] == [7, 4, 7]), "a number that is typed is both's")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "and one step of undo")
    window.act("source-duplicate")
    tap.ok(wait("five", lambda: [one[1] for one in lights(window)] == [3, 4, 5, 3, 5]), "both are doubled")
    tap.ok(wait("the doubles", lambda: chosen(window) == [False, False, False, True, True]), "the doubles are chosen")
    window.act("source-delete")
    tap.ok(wait("three", lambda: window.save() == before), "and deleted together")
    tap.equal(sum(chosen(window)), 1, "after which one is chosen")
    window.act("undo")
    tap.ok(wait("five", lambda: len(lights(window)) == 5), "which is one step, too")


def another_key_of_several(tap, desk):
    """A key that is given instead of another is so of all chosen sources that have it, as one step."""
    point = b"type: point, position: [%d, 0, 2000], intensity: %d, attenuation: none"
    window = scene_of(desk, point % (-100, 3), b"type: distant, direction: [0, 0, -1], irradiance: 2", point % (100, 4))
    wait("three", lambda: len(window.sources()) == 3)
    before = window.save()
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[0])
    wait("one", lambda: chosen(window) == [True, False, False])
    desk.move(*window.place(rows[2]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("two", lambda: window.says("2 sources") and not window.says("stands nowhere")),
           "of two that stand somewhere no more is said")
    desk.move(*window.place(rows[1]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("all", lambda: window.says("3 sources") and window.says("turns light from far away")),
           "of light from far away it is said that it is turned")
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    wait("both", lambda: chosen(window) == [True, False, True])
    window.click(window.control("label", "Intensity"), button=3)
    window.press("Give “Power” instead")
    tap.ok(wait("both", lambda: window.save().count(b"power:") == 2), "both have the other key", window.save())
    tap.equal(window.save().count(b"intensity:"), 0, "and none the one of before")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo")


def several_by_marks(tap, desk):
    window = three_in_view(desk)
    before, start = window.save(), lights(window)
    scale, x, y = window.map()
    marks = [(x + place[0] * scale, y - place[1] * scale) for place, _intensity in start]
    desk.click(*marks[0])
    wait("the first", lambda: chosen(window) == [True, False, False])
    desk.move(*marks[1])
    desk.hand("keydown", "shift", "click", "1", "keyup", "shift")
    tap.ok(wait("two", lambda: chosen(window) == [True, True, False]), "Shift and a click choose one more mark")
    tap.equal(window.save(), before, "and move nothing")
    desk.drag(marks[0], (marks[0][0] + 40, marks[0][1] - 25))
    wait("a motion", lambda: lights(window)[0] != start[0])
    moved = lights(window)
    way = [[after[0][k] - earlier[0][k] for k in range(3)] for earlier, after in zip(start, moved)]
    tap.ok(abs(way[0][0] - 40 / scale) < 2 and abs(way[0][1] - 25 / scale) < 2, "a drag moves the one", way)
    tap.ok(all(abs(way[0][k] - way[1][k]) < 1e-5 for k in range(3)), "and the other as far", way)
    tap.equal(way[2], [0, 0, 0], "and not the third")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo")
    desk.key("Left")
    tap.ok(wait("the keys", lambda: [one[0][0] for one in lights(window)] == [-110, 110, 0]), "arrows move both")
    window.act("undo")
    wait("as before", lambda: window.save() == before)
    desk.move(*marks[1])
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    tap.ok(wait("one", lambda: chosen(window) == [True, False, False]), "one more click takes the mark out")


DIRECTION = re.compile(rb"direction: \[([^\]]*)\]")


def directions(window):
    """Of all sources from far away, as unit vectors."""
    found = [[float(number) for number in text.split(b",")] for text in DIRECTION.findall(window.save())]
    return [[number / math.hypot(*way) for number in way] for way in found]


def angles(ways):
    """Between each two of them, in degrees."""
    return [math.degrees(math.acos(min(1, sum(a * b for a, b in zip(one, other)))))
            for i, one in enumerate(ways) for other in ways[:i]]


def turned_together(first, before, after):
    """The first two have turned, with the angle between them as it was, and the others not at all."""
    both = angles(after[:2])[0], angles(first[:2])[0]
    return after[0] != before[0] and after[1] != before[1] and after[2:] == before[2:] and abs(both[0] - both[1]) < 0.02


def several_from_far(tap, desk):
    """Sources from far away that are chosen together turn as one that is dragged in the picture, or moved by keys."""
    distant = b"type: distant, direction: [%s], irradiance: 2"
    window = scene_of(desk, *(distant % way for way in (b"0.3, 0, -0.9", b"-0.3, 0.4, -0.8", b"0, -0.5, -0.8")))
    wait("three", lambda: len(window.sources()) == 3)
    before, start = window.save(), directions(window)
    scale, x, y = window.map()
    width, height = (float(re.search(rb"%s: ([\d.]+)" % side, before).group(1)) for side in (b"width", b"height"))
    radius = min(width, height) / 2 * scale
    marks = [(x - way[0] * radius, y + way[1] * radius) for way in start]
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[0])
    wait("the first", lambda: chosen(window) == [True, False, False])
    desk.move(*window.place(rows[1]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    wait("two", lambda: chosen(window) == [True, True, False])
    desk.drag(marks[0], (marks[0][0] + 40, marks[0][1] + 30))
    now = wait("a turn", lambda: directions(window) if directions(window)[0] != start[0] else None)
    tap.ok(turned_together(start, start, now), "a drag of one turns both", start, now)
    tap.ok(abs(now[0][0] - start[0][0] + 40 / radius) < 0.02 and abs(now[0][1] - start[0][1] - 30 / radius) < 0.02,
           "it follows the pointer", start[0], now[0])
    tap.equal(chosen(window), [True, True, False], "both stay chosen")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo")
    desk.key("Right")
    now = wait("the keys", lambda: directions(window) if directions(window)[0] != start[0] else None)
    tap.ok(turned_together(start, start, now) and now[0][0] < start[0][0], "arrows turn both", start, now)
    desk.key("Up")
    other = wait("more keys", lambda: directions(window) if directions(window)[0] != now[0] else None)
    tap.ok(turned_together(start, now, other), "and further", now, other)
    while window.save() != before:
        window.act("undo")
    tap.equal(directions(window), start, "undone")


def several_at_once(tap, desk):
    """The box of a chosen row is that of all that are chosen, and so is "aim"; each is one step of undo."""
    spot = b"type: spot, position: [%d, 0, 2000], axis: [0, 0, -1], inner: 10, outer: 20, intensity: 9"
    window = scene_of(desk, spot % -100, b"type: point, position: [0, 0, 2000], intensity: 9", spot % 100)
    wait("three", lambda: len(window.sources()) == 3)
    before = window.save()
    rows = list(window.widget.find("list").all("list item"))
    window.click(rows[0])
    wait("one", lambda: chosen(window) == [True, False, False])
    desk.move(*window.place(rows[2]))
    desk.hand("keydown", "ctrl", "click", "1", "keyup", "ctrl")
    wait("both", lambda: chosen(window) == [True, False, True])
    window.click(window.control("checkbox", "Source 1 on"))
    tap.ok(wait("both off", lambda: window.save().count(b"enabled: false") == 2), "both are switched off by one box")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo")
    window.click(window.control("checkbox", "Source 2 on"))
    tap.ok(wait("one off", lambda: window.save().count(b"enabled: false") == 1), "the box of another row is its own")
    window.act("undo")
    wait("as before", lambda: window.save() == before)
    window.press("Aim the source at the surface")
    tap.ok(wait("both aimed", lambda: window.save().count(b"aim: [0, 0, 1000]") == 2), "both are aimed at the surface")
    tap.ok(b"axis" not in window.save(), "instead of along an axis")
    window.act("undo")
    tap.ok(wait("as before", lambda: window.save() == before), "in one step of undo, too")


trial(other_type, another_key, another_key_of_several, list_of_sources, every_kind, names_of_quantities, on_off_alone,
      aimed, several_by_list, several_by_marks, several_from_far,
      several_at_once)
