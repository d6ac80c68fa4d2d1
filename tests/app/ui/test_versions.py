# SPDX-License-Identifier: MIT
"""All that is shown and copied belongs to one version of the scene: a scene whose reflected light takes long stands
beside a quick one and is changed in all ways, and what is not dimmed is at each moment what luxel says of the text."""
import json
import re
import time

from accessible import Rejected
from desk import luxel, trial
from waiting import wait
from window import VALUE

HALL = """\
luxel: 1
units: photometric
reflections: all
screen: {width: 3000, height: 2000, resolution: [90, 60]}
observer: {position: [0, 0, 3800], target: [0, 0, 0], projection: perspective}
surfaces:
  - {type: room, name: hall, center: [0, 0, 2000], size: [4000, 2600, 4400],
     material: {model: lambert, diffuse: 0.6, over_pi: true}}
%s
lights:
  - {type: point, name: lamp, position: [-600, 700, 1800], power: 3000}
points: [[300, 200], [-500, -300]]
"""
BALL = """\
  - {type: sphere, center: [%d, %d, %d], radius: %d,
     material: {model: lambert, diffuse: 0.8, over_pi: true}}"""
# Each of so many balls lights all others: no machine finds that while this test runs, and none has to.
BALLS = [BALL % (400 * i, 250 * j, 500 + (7 * i + 3 * j) % 10 * 60, 60) for i in range(-4, 5) for j in range(-4, 5)]
SLOW = (HALL % "\n".join(BALLS)).encode()
ROOM = (HALL % (BALL % (500, -400, 900, 400))).encode()  # this takes a second
FLUX = re.compile(r"Φ (\S+) (\S+)")
FOLLOWS = 4  # seconds within which a changed scene may still show what it was
LOOKS = 1.5  # seconds for which it is watched then
LONG = 420   # that reflected light may take on a busy machine


class Truth:
    """What luxel says of a text; of one that is too slow for all of its light, there are no values at all."""

    def __init__(self, desk, text, is_slow=False):
        path = desk.path("truth.yaml")
        with open(path, "wb") as file:
            file.write(text)
        found = json.loads(luxel("probe", path, "-s", "reflections=none", "--json"))
        self.fluxes = ["%.4g" % light["flux"] for light in found["lights"]]
        self.unit = "lm" if found["unit"].startswith("cd") else "W"
        self.points = [] if is_slow else found["points"]
        self.slack = 0
        if b"reflections: all" in text and not is_slow:
            self.points = json.loads(luxel("probe", path, "--reflected-error", "0.01", "--json"))["points"]
            # the app has the bound of pictures: a hundredth of the greatest of them
            self.slack = 0.01 * json.loads(luxel("render", path, "--json"))["max"]["value"]

    def has_value(self, i, text):
        if i >= len(self.points):
            return False
        value = self.points[i]["value"]
        return abs(float(text) - value) <= self.slack + self.points[i]["error"] + 1e-5 * abs(value)

    def has_flux(self, i, number, unit):
        return i < len(self.fluxes) and (number, unit) == (self.fluxes[i], self.unit)


def texts(widget, is_dim=False):
    """All labels, and whether they or what they stand in are dimmed."""
    for child in widget.children():
        try:
            dims = is_dim or child.has("busy")
            if child.role == "label":
                yield child.name, dims
            else:
                yield from texts(child, dims)
        except Rejected:  # gone while it was looked at
            continue


def wrong(window, *truths):
    """What is shown bright and belongs to none of these."""
    found, row = [], 0
    for text, is_dim in list(texts(window.panes()[2])):
        match = VALUE.fullmatch(text)
        number = match and re.fullmatch(r"[-+.e0-9]+", match.group(2))
        if number and not is_dim and not any(truth.has_value(int(match.group(1)) - 1, match.group(2))
                                             for truth in truths):
            found.append(text)
    for text, is_dim in list(texts(window.widget.find("list"))):
        match = FLUX.match(text)
        if match:
            if not is_dim and not any(truth.has_flux(row, *match.groups()) for truth in truths):
                found.append(text)
            row += 1
    return found


def copies(window):
    return window.control("button", "Copy results").has("sensitive")


def copied_values(desk, window):
    window.press("Copy results")
    text = wait("the results", lambda: "P1\t" in desk.copied() and desk.copied())
    return text, [line.split("\t")[1] for line in text.split("\n") if re.match(r"P\d", line)]


def watch(window, truth, before=None):
    """Looks again and again; what was wrong.  For a while after a change what was before it is right, too: until
    nothing of it is left, as it must not come back then."""
    start, found, looks = time.monotonic(), [], 0
    while before and time.monotonic() < start + FOLLOWS and wrong(window, truth):
        seen = wrong(window, truth, before)
        if seen and wrong(window, truth, before) == seen:  # no change came between the looks at its parts
            found.append(seen)
    start = time.monotonic()
    while time.monotonic() < start + LOOKS or looks < 2:
        seen = wrong(window, truth)
        if seen and wrong(window, truth) == seen:
            found.append(seen)
        looks += 1
    return found


def open_slow(tap, desk):
    """A slow scene in the place of a quick one, on its way to the reflected light, which it has not reached when its
    file becomes a quick one, and then a slow one again."""
    slow = desk.path("slow.yaml")
    with open(slow, "wb") as file:
        file.write(SLOW)
    truth = Truth(desk, SLOW, True)
    app = desk.start("builtin:sphere")
    window = app.window()
    window.act("open-path", slow)
    tap.equal(wrong(window, truth), [], "nothing of the quick scene is left when the slow one is opened")
    tap.ok("slow.yaml" in window.title and not copies(window), "nor can it be copied under the name of the slow one")
    tap.equal(watch(window, truth), [], "nor does it come back")
    wait("the flux", lambda: window.says("Φ 3000 lm"))
    tap.ok(True, "what the lamps give is there before reflected light is")
    wait("the direct light", lambda: window.says("Direct light; "))
    tap.ok(not window.values() and not copies(window) and window.says("being computed…"),
           "the points say that they are being computed")
    wait("the progress", lambda: window.says("reflected light: "), LONG)
    window.press("Stop")
    wait("the end of it", lambda: window.says("Direct light alone; "))
    tap.ok(not copies(window), "it can be stopped, and then direct light is not copied for the whole")
    window.act("zoom-in")
    window.act("source-duplicate")
    saved = desk.path("saved.yaml")
    two = Truth(desk, window.save(saved), True)
    tap.equal(watch(window, two, truth), [], "a second lamp, while it is stopped")
    window.act("undo")
    tap.equal(watch(window, truth, two), [], "and without it again")
    window.press("Go on")
    window.act("zoom-out")
    wait("the direct light", lambda: window.says("Direct light; "))
    wait("the progress", lambda: window.says("reflected light: "), LONG)
    tap.ok(not copies(window), "it goes on where it is wanted, however the picture is looked at meanwhile")
    with open(saved, "wb") as file:
        file.write(ROOM)
    room = Truth(desk, ROOM)
    window.act("reload")
    tap.equal(watch(window, room, truth), [], "a quick scene in its place")
    wait("all of the light", lambda: copies(window), LONG)
    tap.ok(not window.says("Direct light"), "of which the picture has all light")
    tap.equal(watch(window, room), [], "the points agree with luxel probe")
    text, values = copied_values(desk, window)
    tap.ok(len(values) == 2 and all(room.has_value(i, values[i]) for i in range(2)), "as does what is copied", text)
    window.act("source-duplicate")
    two = Truth(desk, window.save(saved))
    tap.equal(watch(window, two, room), [], "a change of the whole scene")
    wait("all of its light", lambda: copies(window), LONG)
    text, values = copied_values(desk, window)
    tap.ok(len(values) == 2 and all(two.has_value(i, values[i]) for i in range(2)), "is in what is copied", text)
    with open(saved, "wb") as file:
        file.write(SLOW)
    window.act("reload")
    wait("the slow one", lambda: window.says("Direct light; "))
    start = time.monotonic()
    window.act("source-add", "spot")
    tap.ok(time.monotonic() - start < 15, "a lamp is added without waiting for reflected light")
    tap.ok(not copies(window), "is not copied before it is computed")
    start = time.monotonic()
    tap.equal(app.quit(), 0, "closing meanwhile")
    tap.ok(time.monotonic() - start < 30, "waits for nothing", time.monotonic() - start)


def beside(tap, desk):
    """A quick window beside a slow one, each with its own, through changes of every kind."""
    slow = desk.path("slow.yaml")
    with open(slow, "wb") as file:
        file.write(SLOW)
    truth = Truth(desk, SLOW, True)
    fast = desk.path("fast.yaml")
    with open(fast, "wb") as file:
        file.write(luxel("scene", "report"))
    app = desk.start(fast)
    quick = app.window()
    quick.act("open-path", slow)
    window = wait("the slow one", lambda: next((one for one in app.windows() if "slow.yaml" in one.name), None))
    now = Truth(desk, quick.save())
    tap.equal(watch(quick, now), [], "the quick one has its own numbers")
    for name, words in (("source-add", ["spot"]), ("undo", []), ("redo", []), ("source-delete", []), ("undo", [])):
        before = now
        quick.act(name, *words)
        now = Truth(desk, quick.save())
        tap.equal(watch(quick, now, before), [], "so it has after " + name)
    wait("all of it", lambda: copies(quick), LONG)
    text, values = copied_values(desk, quick)
    tap.ok(all(now.has_value(i, value) for i, value in enumerate(values)) and len(values) == 3,
           "and that is what it copies", text)
    quick.root, kept = window, quick.root
    tap.equal([text for text in wrong(quick, truth)], [], "the slow one has its own meanwhile")
    quick.root = kept


def why(tap, desk):
    """The formula of a place follows every change of the scene, wherever the pointer is."""
    window = desk.start().window()
    window.click(wait("a button", lambda: window.widget.find(None, "Why?")))
    window.press("Formula of the chosen source", None)
    window.pointed(*window.pixel(60, 40))
    wait("the formula", lambda: window.says("N · L = "))
    x, y, width, height = window.picture_area()
    desk.move(x + width / 2, y + height + 20)
    window.enter("Intensity", "77")
    tap.ok(wait("the formula of now", lambda: window.says("N · L = ", "77 W/sr")), "the numbers are of the change")
    told = luxel("explain", "report", "-s", "lights[0].intensity=77", "-p", "60,40").decode()
    flux = re.search(r"together is (\S+) W", told).group(1)
    tap.ok(window.says("together is %s W" % flux), "as luxel explain has them")
    where = window.says("x = ", "y = ")
    window.act("undo")
    tap.ok(wait("the formula of before", lambda: window.says("N · L = ", " 10 W/sr")), "and so after undo")
    tap.equal(window.says("x = ", "y = "), where, "at the same place")


def list_follows(tap, desk):
    """The list of many lamps shows the one that is chosen by its number."""
    window = desk.start("all-sources").window()

    def is_seen(number):
        """Whether its row stands between the toolbar above the list and the form below it."""
        row = next(item for item in window.widget.find("list").all("list item") if item.name.startswith(number))
        above, below = window.control("button", "Delete the source").area(), window.control("combo box", "Type").area()
        return above[1] + above[3] <= row.area()[1] + 2 and row.area()[1] + row.area()[3] <= below[1] + 2

    tap.ok(is_seen("1") and not is_seen("9"), "the last of many is not in sight")
    desk.key("9")
    tap.ok(wait("its row", lambda: is_seen("9")), "until it is chosen")


trial(open_slow, beside, why, list_follows)
