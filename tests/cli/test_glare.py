# SPDX-License-Identifier: MIT
"""luxel glare: ratings of observers against closed forms, what is hidden, and lights that do not count."""
import math

from luminaires import HEAD
from tap import Tap
from tool import run_tests

SCENE = """luxel: 1
units: photometric
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {position: [-1000, -9000, 3000], target: [0, 0, 0], projection: perspective}
%s
lights:
%s
surfaces:
%s
"""
PANEL = ("  - {type: planar, rectangle: {center: [0, 4000, 1800], size: [600, 600], axis: [0, 0, -1], up: [0, 1, 0]},"
         " radiance: 5000}\n")
SKY = "  - {type: ambient, irradiance: 125.66370614359172}\n"  # a background of 40 cd/m2
AWAY = "  - {type: rectangle, size: [10, 10], center: [0, 0, -3000]}\n"
EYE = ("--eye", "0,0,0,0,1,0")


def rate(tool, lights, surfaces=AWAY, more="", options=EYE):
    tool.write("scene.yaml", SCENE % (more, lights, surfaces))
    result = tool.run("glare", "scene.yaml", "--json", *options)
    assert result.code == 0, result.err
    return result.json()["observers"]


def panels(tap, tool):
    truth = 18.0555676521171  # of 0.6 m x 0.6 m, 5000 cd/m2, 4 m ahead and 1.8 m above the eye, before 40 cd/m2
    rating = rate(tool, PANEL + SKY)[0]
    tap.near(rating["ugr"], truth, 1e-13, "a panel, by hand")
    tap.ok(abs(rating["ugr"] - truth) <= rating["error"] + 1e-13 and rating["error"] < 1e-10, "its bound", rating)
    tap.near(rating["background"]["value"], 40, 1e-14, "the background")
    source = rating["sources"][0]
    tap.near(source["solid_angle"], .00767834115584029, 1e-13, "its solid angle")
    tap.near(source["luminance"], 5000, 1e-13, "its luminance")
    tap.equal((source["status"], source["seen"], source["share"]), ("counts", 1, 1), "it counts")
    tap.equal(rating["sources"][1]["status"], "background", "ambient light is background")
    # The lamp of a file of the same luminance, as a point with its opening and as that opening.
    angles = range(91)
    values = " ".join(repr(1800 * math.cos(math.radians(g))) for g in angles)
    tool.write("lamp.ies", HEAD + "1 -1 1 91 1 1 2 .6 .6 0\n1 1 10\n%s\n0\n%s\n" % (" ".join(map(str, angles)), values))
    for opening in ("point", "file"):
        lamp = "  - {type: luminaire, file: lamp.ies, position: [0, 4000, 1800], opening: %s}\n" % opening
        rating = rate(tool, lamp + SKY)[0]
        tap.near(rating["ugr"], truth, 2e-3, "a luminaire, opening: " + opening)
        tap.near(rating["sources"][0]["solid_angle"], .00767834115584029, 1e-12, "its area, opening: " + opening)
    # Two of them count as one of the double light would not: the sum is of their glare.
    two = rate(tool, PANEL + PANEL.replace("[0, 4000", "[1000, 4000") + SKY)[0]
    single = rate(tool, PANEL.replace("[0, 4000", "[1000, 4000") + SKY)[0]["ugr"]
    tap.near(10 ** (two["ugr"] / 8), 10 ** (truth / 8) + 10 ** (single / 8), 1e-12, "glare adds up")
    tap.near(sum(source["share"] for source in two["sources"]), 1, 1e-12, "shares")
    # Tilted by the direction up: the same panel to an observer who lies on his side.
    side = rate(tool, PANEL.replace("4000, 1800", "4000, 0").replace("[0, 4", "[1800, 4").replace(
        "axis: [0, 0, -1]", "axis: [-1, 0, 0]") + SKY, options=EYE + ("--up", "1,0,0"))[0]["ugr"]
    tap.near(side, truth, 1e-12, "up is where --up says")
    # A plan of a room has observer.up in the floor; what is up for those in the room is what the room says.
    room = "  - {type: room, center: [0, 0, 0], size: [20000, 20000, 10000], up: %s, material: {diffuse: 0.5}}\n"
    plan = SCENE.replace("[-1000, -9000, 3000], target", "[0, 0, 3000], up: [0, 1, 0], target").replace(
        "[0, 0, 0], proj", "[0, 10, 0], proj")
    along_z = PANEL.replace("[0, 4000, 1800]", "[0, 1800, 4000]").replace("axis: [0, 0, -1], up: [0, 1, 0]",
                                                                          "axis: [0, -1, 0]")
    for axis, eye, panel in ("z", EYE, PANEL), ("y", ("--eye", "0,0,0,0,0,1"), along_z):
        tool.write("room.yaml", plan % ("", panel + SKY, room % axis))
        result = tool.run("glare", "room.yaml", "--json", *eye)
        tap.ok(result.code == 0, "a room with up: " + axis, result.err)
        tap.near(result.json()["observers"][0]["ugr"], truth, 1e-12, "its UGR")


def shadows(tap, tool):
    facing = PANEL.replace("axis: [0, 0, -1], up: [0, 1, 0]", "axis: [0, -4000, -1800], up: [0, 0, 1]")
    whole = rate(tool, facing + SKY)[0]
    board = "  - {type: rectangle, size: [2000, 4000], center: [%s, 2000, 1000], axis: [0, -1, 0], up: [0, 0, 1]}\n"
    half = rate(tool, facing + SKY, board % "-1000")[0]
    tap.near(half["sources"][0]["seen"], .5, 1e-9, "a board in front of its left half")
    tap.near(whole["ugr"] - half["ugr"], 8 * math.log10(2), 1e-8, "half of the glare")
    hidden = rate(tool, facing + SKY, board % "0")[0]
    tap.equal((hidden["ugr"], hidden["error"], hidden["sources"][0]["status"]), (None, None, "hidden"), "all hidden")
    tap.equal(rate(tool, facing + SKY, board % "0", "shadows: none")[0]["ugr"], whole["ugr"], "shadows: none")


def reflections(tap, tool):
    # An even lamp in the middle of a sphere of 2 m: the walls send back rho flux / (area (1 - rho)) all over.
    ball = "  - {type: volume, sphere: {center: [0, 0, 0], radius: 100}, radiance: 2000}\n"
    wall = ("  - {type: sphere, center: [0, 0, 0], radius: 2000, inside: true,"
            " material: {model: lambert, diffuse: .5, over_pi: true}}\n")
    flux = math.pi * 2000 * 4 * math.pi * .01
    background = flux / (4 * math.pi * 4) / math.pi
    rating = rate(tool, ball, wall, "reflections: all", ("--eye", "0,-1000,-300,0,1,0", "--reflected-error", "1e-4"))[0]
    found = rating["background"]
    tap.ok(abs(found["value"] - background) <= found["error"] < 1e-3 * background, "the background of a sphere",
           (found, background))
    off = math.degrees(math.atan(.3))
    index = math.exp((35.2 - 1.22) * off / 1e3 + 21 * off ** 2 / 1e5)
    truth = 8 * math.log10(.25 / background * 2000 ** 2 * math.pi * .01 / 1.09 / index ** 2)
    tap.ok(abs(rating["ugr"] - truth) <= rating["error"] < .01, "its rating", (rating, truth))
    dark = rate(tool, PANEL)[0]
    tap.equal((dark["ugr"], dark["background"]["value"]), (None, 0), "nothing reflects: no background")


def what_does_not_count(tap, tool):
    lights = (PANEL.replace("1800]", "-100]") + PANEL.replace("axis: [0, 0, -1]", "axis: [0, 0, 1]") +
              PANEL.replace("[0, 4000", "[0, -4000") + "  - {type: point, position: [0, 3000, 900], intensity: 100}\n" +
              "  - {type: distant, direction: [0, -1, -1], irradiance: 10}\n" +
              PANEL.replace("4000, 1800", "900, 1800") + SKY)
    statuses = [source["status"] for source in rate(tool, lights)[0]["sources"]]
    tap.equal(statuses, ["dark", "dark", "unseen", "no_area", "no_area", "unseen", "background"],
              "below the eye and away from it, behind it, a point, from afar, too high")
    tool.write("scene.yaml", SCENE % ("", PANEL + SKY, AWAY))
    both = tool.run("glare", "scene.yaml", *EYE, "--eye", "0,0,0,0,-1,0")
    tap.ok(both.code == 0 and "UGR 18.1\n" in both.out and "no UGR: nothing dazzles" in both.out and
           "outside the field of view" in both.out, "two observers", both.out)
    for options, code, words in (((), 2, "--eye"), (("--eye", "0,0,0,0,0,0"), 2, "must not be zero"),
                                 (("--eye", "0,0,0"), 2, "--eye"), (EYE + ("--up", "0,0,0"), 2, "--up"),
                                 (EYE + ("-s", "units=radiometric"), 3, "photometric")):
        result = tool.run("glare", "scene.yaml", *options)
        tap.ok(result.code == code and words in result.err, "refused: " + " ".join(options), (result.code, result.err))


if __name__ == "__main__":
    run_tests(Tap(), panels, shadows, reflections, what_does_not_count)
