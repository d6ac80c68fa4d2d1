# SPDX-License-Identifier: MIT
"""The numbers beside the picture are those of `luxel probe`, whichever way the scene was changed."""
import json
import re

from desk import luxel, trial
from waiting import wait


def probed(desk, window):
    """What the tool says of the scene as the app saved it, with as many digits as the table has."""
    path = desk.path("probed.yaml")
    window.save(path)
    points = json.loads(luxel("probe", path, "--json"))["points"]
    return ["%.7g" % point["value"] if point["on_surface"] else "off the surface" for point in points]


def same_as_probe(tap, desk, window, before, name):
    wait("new numbers", lambda: window.values() != before)
    wait("the numbers of the tool", lambda: window.values() == probed(desk, window), 10)
    tap.equal(window.values(), probed(desk, window), name)
    return window.values()


def typed_and_set(tap, desk):
    window = desk.start().window()
    values = same_as_probe(tap, desk, window, None, "as it starts")
    field = window.enter("Intensity", "17,5")
    values = same_as_probe(tap, desk, window, values, "after an intensity with a decimal comma")
    tap.equal(field.value, 17.5, "which was read as 17.5")
    tap.ok(b"intensity: 17.5" in window.save(), "and is written so")
    shininess = window.control("spin button", "Shininess n")
    shininess.value = 60
    values = same_as_probe(tap, desk, window, values, "after the shininess was set by a screen reader")
    tap.ok(b"shininess: 60" in window.save(), "which is written")
    window.enter("Position, y", "-1 500,25")
    values = same_as_probe(tap, desk, window, values, "after a place with a gap between its digits")
    tap.ok(b"position: [2000, -1500.25, 2000]" in window.save(), "which is written as YAML has it")
    window.enter("Specular reflection ks", "0.25", key="Tab")
    values = same_as_probe(tap, desk, window, values, "after a number that was left by Tab")
    window.act("quantity", "irradiance")
    path = desk.path("irradiance.yaml")
    window.save(path)
    found = json.loads(luxel("probe", path, "--json", "--quantity", "irradiance"))
    wait("the irradiance", lambda: window.says("irradiance, %s" % found["unit"]))
    wait("its values", lambda: window.values() != values)
    tap.equal(window.values(), ["%.7g" % point["value"] for point in found["points"]], "as irradiance")


def statistics(tap, desk):
    window = desk.start().window()
    window.press("Statistics", "tab")
    path = desk.path("statistics.yaml")
    window.save(path)
    found = json.loads(luxel("stats", path, "--json"))
    for name, value in (("maximum of the pixels", found["max"]["value"]), ("mean", found["mean"]),
                        ("median", found["median"]), ("true maximum", found["maximum"]["value"]),
                        ("lit part", 100 * found["lit"])):
        text = "%.7g" % value
        tap.ok(wait(name, lambda: text in window.numbers()), "the %s is that of luxel stats" % name)
    window.press("Section", "tab")
    tap.ok(wait("the section", lambda: window.says("Through x = 0, y = 0 mm")), "the section says where it lies")


# A lamp that nearly touches the line in which two plates cross: a hundredth of the maximum is far out of reach there.
CROSSING = """luxel: 1
reflections: 1
screen: {width: 3000, height: 3000, resolution: [4, 4]}
observer: {z: 9000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [3000, 3000], material: {model: lambert, diffuse: 0.8, over_pi: true}}
  - {type: rectangle, center: [0, 0, 0], size: [1000, 1000], axis: [0.9, 0, 0.5],
     material: {model: lambert, diffuse: 0.8, over_pi: true}}
lights: [{type: point, position: [0, 0, 0.01], intensity: 1, attenuation: inverse-square}]
points: [[0, 1000]]
"""


def reflected_light(tap, desk):
    path = desk.path("crossing.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(CROSSING)
    window = desk.start(path).window()
    desk.move(5, 5)
    tap.ok(wait("the missed bound", lambda: window.says("less exact than it should be")), "a missed bound is told")
    window.press("Statistics", "tab")
    tap.ok(wait("the bound", lambda: window.says(" %", "\u26a0")), "and stands beside the statistics")


# A floor and a ball above it, each of which lights the other.
BALL = """luxel: 1
reflections: 1
screen: {width: 1000, height: 1000, resolution: [20, 20]}
observer: {z: 3000}
surfaces:
  - {type: rectangle, name: floor, center: [0, 0, 0], size: [900, 900],
     material: {model: lambert, diffuse: 0.7, over_pi: true}}
  - {type: sphere, name: ball, center: [0, 0, 400], radius: 150,
     material: {model: lambert, diffuse: 0.5, over_pi: true}}
lights: [{type: point, position: [-300, 0, 900], power: 20, attenuation: inverse-square}]
points: [[400, 0]]
"""


def balance(tap, desk):
    """Where the light stays: means and fluxes with their bounds, which hold the numbers of luxel stats."""
    path = desk.path("ball.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(BALL)
    window = desk.start(path).window()
    window.press("Statistics", "tab")
    told = json.loads(luxel("stats", path, "--json"))
    for words, name in (("absorbed by surfaces", "absorbed"), ("difference, in truth 0", "difference"),
                        ("1 floor, front", None)):
        wait(words, lambda: words in window.numbers())
        texts = window.numbers()
        value, error = map(float, texts[texts.index(words) + 1].split(" \u00b1 "))
        amount = told["balance"][name] if name else told["surfaces"][0]["irradiance"]
        tap.ok(abs(value - amount["value"]) + amount["error"] <= error * 1.001, words, value, error, amount)
    tap.ok("Mean irradiance of the surfaces, W/m\u00b2" in window.numbers(), "with their unit")
    tap.ok(wait("all light", lambda: not window.says("Direct light;")), "the picture has all light by then")


BIN = re.compile(r"(\S+) … (\S+): (\d+) pixels?, (\S+) %")
READ = re.compile(r"([xy]) = (\S+) mm: (\S+)\s*((?:\d+ \S+\s*)*)")


def read(window, name, share):
    """What is read off a plot at a share of its width: the pointer comes there again until something is."""
    desk, plot = window.desk, wait(name, lambda: window.panes()[2].find(name=name))

    def come():
        x, y, width, height = plot.area()
        left, top = window.edges()
        desk.move(left + x + width * share - 1, top + y + height / 2)
        desk.move(left + x + width * share, top + y + height / 2)
        return plot.description

    return wait("what is read off the %s" % name.lower(), come)


def reads(plot):
    """The bin that is read off a histogram."""
    said = BIN.fullmatch(plot.description)
    return said and said.groups()[:3]


def sections_are_read(tap, desk):
    path = desk.path("lights.yaml")
    with open(path, "wb") as file:
        file.write(luxel("scene", "three-lights"))
    window = desk.start(path).window()
    window.press("Section", "tab")
    wait("the section", lambda: window.says("Through x = 0, y = 0 mm"))
    for name, along in (("Horizontal section", "x"), ("Vertical section", "y")):
        said = wait("the curve", lambda: READ.fullmatch(read(window, name, 0.55)))
        place = float(said.group(2).replace("\u2212", "-"))
        point = json.loads(luxel("probe", path, "-p", "%r,0" % place if along == "x" else "0,%r" % place, "--json"))
        probe = point["points"][0]
        tap.equal((said.group(1), said.group(3)), (along, "%.7g" % probe["value"]),
                  "a %s is read with the value of luxel probe" % name.lower())
        shares = dict(zip(*[iter(said.group(4).split())] * 2))
        expected = {str(i + 1): "%.5g" % (light["diffuse"] + light["specular"])
                    for i, light in enumerate(probe["lights"]) if light["irradiance"]}
        tap.equal(shares, expected, "and with the sources' shares")
    desk.move(*window.pixel(0, 0))
    plot = window.panes()[2].find(name="Horizontal section")
    tap.ok(wait("nothing", lambda: not plot.description), "beside the curves nothing is read")


def histogram_is_read(tap, desk):
    path = desk.path("lights.yaml")
    with open(path, "wb") as file:
        file.write(luxel("scene", "three-lights"))
    window = desk.start(path).window()
    window.press("Statistics", "tab")
    wait("the numbers", lambda: "Pixels on a surface" in window.numbers())
    plot = wait("the histogram", lambda: window.panes()[2].find(name="Histogram"))
    said = wait("a bin", lambda: BIN.fullmatch(read(window, "Histogram", 0.5)))
    found = json.loads(luxel("stats", path, "--json", "--histogram", "--bins", "64"))["histogram"]
    bins = [("%.7g" % found["edges"][i], "%.7g" % found["edges"][i + 1], str(count))
            for i, count in enumerate(found["counts"])]
    tap.ok(said.groups()[:3] in bins, "a bin is read as luxel stats has it", said.group())
    desk.hand("click", "1")
    wait("the keyboard", lambda: plot.has("focused"))
    desk.move(*window.pixel(0, 0))
    wait("nothing is read", lambda: not plot.description)
    for key, index in (("Home", 0), ("Right", 1), ("End", len(bins) - 1), ("Left", len(bins) - 2)):
        desk.key(key)
        tap.ok(wait(key, lambda i=index: reads(plot) == bins[i]), "%s goes to its bin" % key)


trial(typed_and_set, statistics, reflected_light, balance, sections_are_read, histogram_is_read)
