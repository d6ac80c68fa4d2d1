# SPDX-License-Identifier: MIT
"""A scene in colour: channels are chosen, and read under the pointer and in the statistics, as the tool has them."""
import json
import re

from desk import luxel, trial
from waiting import wait

SCENE = "warm-and-cold"
CHANNELS = ("its colours", "luminance", "red", "green", "blue", "colour temperature")
READ = re.compile(r"R, G, B (\S+), (\S+), (\S+)\tx, y (\S+), (\S+)\t(\S+) K, Duv (\S+)")


def probe(x, y):
    return json.loads(luxel("probe", SCENE, "-p", "%.17g,%.17g" % (x, y), "--json"))["points"][0]


def stats(channel):
    return json.loads(luxel("stats", SCENE, "--channel", channel, "--json"))


def edge(window):
    return next((match for match in (READ.search(label.name) for label in window.edge()) if match), None)


def reading(tap, desk):
    window = desk.start(SCENE).window()
    x, y = window.pointed(*window.pixel(-120, 10))
    found = [float(number.replace("−", "-")) for number in wait("the channels", lambda: edge(window)).groups()]
    true = probe(x, y)
    # the place is told in five digits, and so the numbers are no closer than it
    expected = [*true["rgb"]["value"], *true["xy"], true["cct"], true["duv"]]
    tap.ok(all(abs(a - b) <= 2e-3 * max(abs(b), 1e-1) for a, b in zip(found, expected)),
           "the pointer reads channels, x, y, temperature and Duv as luxel probe prints them", found, expected)
    desk.key("w")
    tap.ok(wait("the card", lambda: window.says("cd/m²", "R, G, B ", " K, Duv ")), "the card has them, too")


def channels(tap, desk):
    window = desk.start(SCENE).window()
    x, y, width, height = (round(number) for number in window.picture_area())
    middle = (x + width // 2 - 60, y + height // 2)
    colors = {}
    window.press("Picture", None)
    window.widget.find("tab", "Statistics").act()
    desk.move(x + width + 60, y + height + 60)
    for channel in CHANNELS:
        if colors:
            before = desk.color(*middle)
            window.choose("Channel", CHANNELS.index(channel))
            wait("another picture", lambda: desk.color(*middle) != before)
        colors[channel] = desk.color(*middle)
        word = "luminance" if channel == "its colours" else "cct" if channel == "colour temperature" else channel
        shown = "%.7g" % stats(word)["max"]["value"]
        tap.ok(wait("the maximum of " + channel, lambda: shown in window.numbers()), "statistics of " + channel, shown)
    grey = [color for channel, color in colors.items() if max(color) == min(color)]
    tap.equal(len(grey), len(CHANNELS) - 1, "channels are shown in grey, and colours are not")
    mean = re.search("R, G, B [^;]*", luxel("stats", SCENE).decode()).group()
    tap.ok(mean in window.numbers(), "the colour of the mean", mean)


def exposed(tap, desk):
    """Brighter is no other colour: what grows in one channel grows in the others."""
    window = desk.start(SCENE).window()
    x, y, width, height = (round(number) for number in window.picture_area())
    place = (x + width // 2 - 100, y + height // 2 + 60)
    before = desk.color(*place)
    desk.key("e")
    brighter = wait("a brighter picture", lambda: next((c for c in [desk.color(*place)] if c != before), None))
    tap.ok(brighter[0] > brighter[1] > brighter[2] and all(a >= b for a, b in zip(brighter, before)),
           "exposure keeps the colours", before, brighter)
    desk.apps[-1].quit()
    window = desk.start("sphere").window()
    window.press("Picture", None)
    tap.equal(window.widget.find("combo box", "Channel"), None, "a grey scene has no channels to choose from")


trial(reading, channels, exposed)
