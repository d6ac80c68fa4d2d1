# SPDX-License-Identifier: MIT
"""Numbers of scenes that no picture can be made of, advice for designs, and what reflected light is asked for."""
from luminaires import eulumdat
from tap import Tap
from tool import SCENE, run_tests

WALL = "{model: lambert, diffuse: %s, over_pi: true}"
PLATES = """luxel: 1
units: photometric
reflections: all
screen: {width: 1000, height: 1000, resolution: [20, 20]}
observer: %s
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [1000, 1000], axis: [0, 0, 1], material: %s}
  - {type: rectangle, center: [0, 0, 1000], size: [1000, 1000], axis: [0, 0, -1], material: %s}
lights: [{type: point, position: [200, 100, 400], intensity: 100}]
grids: [{name: between, center: [0, 0, 300], size: [500, 500], n: [3, 3]}]
points: [[0, 0]]
"""
ASKED = ("--at", "0,0,0,0,0,1", "--quantity", "irradiance", "--json")
ROOM = """luxel: 1
units: %s
reflections: %s
screen: {width: 8000, height: 6000, resolution: [40, 30]}
observer: {position: [-3900, -2900, 1700], target: [0, 0, 1000], up: [0, 0, 1], projection: perspective}
surfaces:
  - {type: room, center: [0, 0, 1400], size: [%d, 6000, 2800], up: %s, material: %s,
     materials: {floor: %s, ceiling: %s}}
lights:
%s
grids: [{name: work plane, center: [0, 0, 750], size: [7000, 5000], spacing: en12464%s}]
points: [[0, 0]]
"""


def room(tool, lamps, units="photometric", reflections="none", width=8000, up="z", axis="", grid=""):
    tool.write("lamp.ldt", eulumdat())
    lights = "\n".join("  - {type: luminaire, file: lamp.ldt, position: [%d, %d, 2800]%s}" % (*place, axis)
                       for place in lamps)
    tool.write("room.yaml", ROOM % (units, reflections, width, up, WALL % .5, WALL % .2, WALL % .7, lights, grid))


def ids(tool, *options):
    """What is advised about all but the picture."""
    found = tool.run("check", "room.yaml", "--json", *options).json()["advice"]
    return [(entry["id"], entry["key"]) for entry in found if not entry["key"].startswith("screen")]


def backs(tap, tool):
    """Two plates that face each other, from between them, where all is seen, and from elsewhere: the same numbers."""
    answers = []
    for observer in "{z: 500, projection: perspective}", "{z: 2000}", "{z: 2000, projection: perspective}":
        tool.write("s.yaml", PLATES % (observer, WALL % .7, WALL % .5))
        checked = tool.run("check", "s.yaml")
        tap.equal((checked.code, "surfaces[1] is not drawn" in checked.out), (0, bool(answers)), "check: " + observer)
        result = tool.run("probe", "s.yaml", *ASKED)
        grid = tool.run("grid", "s.yaml", "--json")
        glare = tool.run("glare", "s.yaml", "--eye", "0,-400,500,0,1,0", "--json")
        tap.ok((result.code, grid.code, glare.code) == (0, 0, 0), "numbers: " + observer, result, grid, glare)
        answers.append((result.json()["points"][0]["value"], grid.json()["grids"][0]["average"]))
        point = tool.run("probe", "s.yaml", "--at", "300,200,0,0,0,1", *ASKED[2:]).json()["points"][0]
        tap.near(point["value"], 546.02404813, 1e-8, "by a Nyström solution of 24 x 24 nodes a plate: " + observer)
        picture = tool.run("render", "s.yaml", "--json")
        tap.ok(picture.code == 0 and picture.json()["lit"] == 1, "the floor is drawn: " + observer, picture)
    tap.ok(all(abs(a - b) <= 1e-9 * b for each in answers for a, b in zip(each, answers[0])), "equal", *answers)


def observers(tap, tool):
    """An observer inside a surface, and pixels that are not square, spoil what looks through the screen alone."""
    for change, words in (("observer.z=1000", "observer"), ("screen.resolution=[36, 30]", "square")):
        tool.write("s.yaml", SCENE + "grids: [{center: [0, 0, 1200], size: [9, 9], n: [2, 2]}]\n")
        for command in ("render", "probe", "stats", "isophotes", "explain", "check", "advise", "profile"):
            result = tool.run(command, "s.yaml", "-s", change)
            tap.ok(result.code == 3 and words in result.err and "-s:1:" in result.err and not result.out,
                   command + " " + change, result)
        tap.equal(tool.run("probe", "s.yaml", "-p", "1,1", "-s", change).code, 3, "a point " + change)
        both = tool.run("probe", "s.yaml", "-p", "1,1", "--at", "0,0,1200,0,0,1", "-s", change)
        tap.equal((both.code, both.out), (3, ""), "a point and an element " + change)
        right = tool.run("probe", "s.yaml", "--at", "0,0,1200,0,0,1", "--json").json()["points"]
        result = tool.run("probe", "s.yaml", "--at", "0,0,1200,0,0,1", "--json", "-s", change)
        tap.ok(result.code == 0 and result.json()["points"] == right, "an element " + change, result)
        tap.equal(tool.run("grid", "s.yaml", "-s", change).code, 0, "a grid " + change)
    result = tool.run("check", "s.yaml", "-s", "observer.z=1000", "-s", "screen.resolution=[36, 30]",
                      "-s", "lights[0].intensity=-1", "--json")
    tap.equal(sorted(entry["id"] for entry in result.json()["errors"]),
              ["not-square", "observer-too-low", "out-of-range"], "all that is wrong is told at once")


def nothing(tap, tool):
    """No surfaces: E = I / r^2, materials by default; a picture is refused in words."""
    tool.write("s.yaml", "luxel: 1\nscreen: {width: 9, height: 9, resolution: [3, 3]}\nobserver: {z: 1}\nsurfaces: []\n"
               "lights: [{type: point, position: [0, 0, 1000], intensity: 10}]\n"
               "grids: [{center: [0, 0, 0], size: [0.001, 0.001], n: [2, 2]}]\n")
    for reflections in "none", "all":
        more = ("-s", "reflections=" + reflections)
        point = tool.run("probe", "s.yaml", *ASKED, *more).json()["points"][0]
        tap.near(point["value"], 10, 1e-14, "an element, reflections " + reflections)
        tap.equal(point["material"]["surface"], None, "belongs to no surface")
        result = tool.run("probe", "s.yaml", "--at", "0,0,0,0,0,1", *more)
        tap.ok("P1 (0.0, 0.0, 0.0): 13 " in result.out and "by default" in result.out, "a material by default", result)
        tap.near(tool.run("grid", "s.yaml", "--json", *more).json()["grids"][0]["average"], 10, 1e-9, "a grid")
    for command in "render", "stats", "isophotes", "explain":
        result = tool.run(command, "s.yaml")
        tap.ok(result.code == 3 and "s.yaml:4:11: error: there is nothing to see" in result.err, command, result)
    for command in "check", "advise":
        result = tool.run(command, "s.yaml")
        tap.ok(result.code == 0 and "there is nothing to see" in result.out, command, result)


def designs(tap, tool):
    """Rooms that lie on their side, lux in W, luminaires like each other, and halls."""
    lamps = [(x, y) for x in (-3000, -1000, 1000, 3000) for y in (-2000, 0, 2000)]
    room(tool, lamps[:2], up="y")
    tap.equal([key for name, key in ids(tool) if name == "looks-at-wall"], ["lights[0]", "lights[1]", "grids[0]"],
              "walls")
    text = tool.run("check", "room.yaml").out
    tap.ok("lights[0] looks at the wall back of surfaces[0]" in text and "try -s 'surfaces[0].up=z'" in text and
           "  likewise: lights[1]\n" in text and "grids[0] looks at the wall front" in text, "the words", text)
    room(tool, lamps[:2])
    tap.equal(ids(tool), [], "a room with z up")
    room(tool, lamps[:2], axis=", axis: [0, 0, -1]", grid=", axis: [0, 1, 0], up: [0, 0, 1]")
    tap.equal(ids(tool), [], "a grid whose axis is written, beside luminaires that look at the floor")
    room(tool, lamps[:2], units="radiometric")
    tap.equal(ids(tool), [("luminaire-units", "units")], "lux in W, once")
    tap.equal(tool.run("check", "room.yaml", "--strict").code, 3, "--strict")
    room(tool, [(15000, 0)], width=40000)
    tap.equal(ids(tool), [], "a hall has luminaires in it")
    tool.write("s.yaml", SCENE)
    far = tool.run("check", "s.yaml", "-s", "lights[0].position=[15000, 0, 2000]").out
    tap.ok("lights[0].position=10000" in far or "lights[0].position[0]=10000" in far, "a ball does not", far)
    tool.write("lamp.ldt", eulumdat())
    room(tool, lamps, up="y")
    text = tool.run("check", "room.yaml").out
    tap.ok(text.count("looks at the wall") == 2 and "likewise: lights[1] … lights[11]\n" in text, "told once", text)


def spacing(tap, tool):
    """What a rule spaces is no warning, and nobody is told to raise n."""
    room(tool, [(-3000, -2000)])
    with open(tool.file("room.yaml"), encoding="utf-8") as file:
        tool.write("room.yaml", file.read().replace("center: [0, 0, 750]", "center: [0, 0, 2400]"))
    result = tool.run("grid", "room.yaml")
    tap.ok(result.code == 0 and "raise n" not in result.err and "spaced by its rule" in result.err, "by the rule",
           result)
    with open(tool.file("room.yaml"), encoding="utf-8") as file:
        tool.write("room.yaml", file.read().replace("spacing: en12464", "n: [10, 7]"))
    result = tool.run("grid", "room.yaml")
    tap.ok("raise n" in result.err, "by n", result)


def reflected(tap, tool):
    """A hundredth in pictures and means, a thousandth at elements and in grids; what is reached is silent."""
    room(tool, [(x, 0) for x in (-2000, 2000)], reflections="all")
    for command in "render", "stats":
        result = tool.run(command, "room.yaml", "-s", "points=[]")
        tap.ok(result.code == 0 and not result.err, command, result)
    loose = tool.run("render", "room.yaml", "-s", "points=[]", "--json").json()["reflected_error"]
    asked = tool.run("render", "room.yaml", "-s", "points=[]", "--json", "--reflected-error", "0.01").json()
    tap.ok(0 < loose <= 1e-2 and loose == asked["reflected_error"], "a hundredth", loose, asked)
    result = tool.run("probe", "room.yaml", "--at", "500,0,0,0,0,1", "--json")
    point = result.json()["points"][0]
    tap.ok(result.code == 0 and point["reflected"]["error"] <= 1e-3 * point["value"], "a thousandth", result)
    tool.write("s.yaml", PLATES % ("{z: 2000}", WALL % .7, WALL % .5))
    missed = tool.run("render", "s.yaml", "-s", "points=[]", "--json", "--reflected-error", "1e-12")
    tap.ok(missed.code == 5 and missed.json()["max"]["value"] > 0 and "off by" in missed.err, "not reached", missed)


if __name__ == "__main__":
    run_tests(Tap(), backs, observers, nothing, designs, spacing, reflected)
