# SPDX-License-Identifier: MIT
"""luxel derive: derivatives against closed forms, complex steps and each other, and where there are none."""
import cmath
import math
import random

from tap import Tap
from tool import run_tests

SCENE = """luxel: 1
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
lights:
%s
surfaces: %s
"""
PLANAR = "  - {type: planar, rectangle: {center: %s, size: %s, axis: [0, 0, -1], up: [0, 1, 0]}, radiance: 1}\n"
ORIGIN = ("--at", "0,0,0,0,0,1", "--quantity", "irradiance")


def derive(tool, lights, keys, surfaces="[]", options=ORIGIN):
    tool.write("scene.yaml", SCENE % (lights, surfaces))
    result = tool.run("derive", "scene.yaml", "--json", *(word for key in keys for word in ("--free", key)), *options)
    assert result.code == 0, result.err
    return result.json()["points"][0]["derivatives"]


def holds(tap, found, truth, name, close=1e-11):
    """Whether a derivative is the true one, within its error, and that is small."""
    tap.ok(found["value"] is not None and abs(found["value"] - truth) <= found["error"] + 4e-16 * abs(truth) and
           found["error"] <= close * max(abs(truth), 1e-5), name, found, truth)


def the_exercise(tap, tool):
    truths = {"lights[0].intensity": 1.103801503926, "lights[0].position": [-.001556507289091, 0, .003890256867052],
              "surfaces[0].material.diffuse": 7.859275364362, "surfaces[0].material.specular": 9.501189495547,
              "surfaces[0].material.shininess": -.01215394349537, "surfaces[0].radius": -.02710810642691,
              "surfaces[0].center[2]": -.003890256867052}
    result = tool.run("derive", "-p", "150,0", "--json", *(word for key in truths for word in ("--free", key)))
    found = result.json()["points"][0]["derivatives"]
    for key, truth in truths.items():
        for one, exact in zip(found[key] if isinstance(truth, list) else [found[key]],
                              truth if isinstance(truth, list) else [truth]):
            tap.near(one["value"], exact, 1e-12, "report by " + key)
            tap.ok(one["error"] < 1e-11, "its error", one)
    text = tool.run("derive", "-p", "150,0", "--free", "lights[0].position").out
    row = next(line.split() for line in text.splitlines() if "position[2]" in line)
    exact = found["lights[0].position"][2]["value"]
    tap.ok(abs(float(row[1]) - exact) <= float(row[2]), "the error covers what is rounded off the text", row, exact)
    tap.ok("lights[0].position[2]" in text and "0.003890256867" in text and " mm" in text, "as text", text)
    twice = tool.run("derive", "--json", *("--free", "lights[0].intensity") * 2)
    tap.ok(twice.code == 2 and not twice.out and "given twice" in twice.err, "a key of JSON is there once", twice)


def closed_forms(tap, tool):
    lamp = "  - {type: point, position: [1000, 2000, 3000], intensity: 100}\n"
    found = derive(tool, lamp, ["lights[0].position", "lights[0].intensity"])
    for one, truth in zip(found["lights[0].position"], (-1.227219988373, -2.454439976747, -1.772651094317)):
        tap.near(one["value"], truth / 1000, 1e-12, "a point, by position")
    tap.near(found["lights[0].intensity"]["value"], .05727026612409, 1e-12, "a point, by intensity")
    keys = ["lights[0].rectangle.center", "lights[0].rectangle.size"]
    found = derive(tool, PLANAR % ("[300, 200, 2000]", "[1000, 1000]"), keys)
    for one, truth in zip(found[keys[0]] + found[keys[1]], (-.05477277210594, -.03650181317168, -.191710472006,
                                                            .2041035001907, .2030496380876)):
        tap.near(one["value"], truth / 1000, 1e-12, "a rectangle")


def soft_shadows(tap, tool):
    """A plate's edge at half of the height hides a lamp from twice its own x on: that moves the lamp's end."""
    plate = "[{type: rectangle, center: [1050, 0, 1000], size: [2000, 6000], axis: [0, 0, 1]}]"
    moved = derive(tool, PLANAR % ("[0, 0, 2000]", "[1000, 1000]"), ["surfaces[0].center"], plate)["surfaces[0].center"]
    keys = ["lights[0].rectangle.center", "lights[0].rectangle.size"]
    cut = derive(tool, PLANAR % ("[-200, 0, 2000]", "[600, 1000]"), keys)
    end = cut[keys[0]][0]["value"] / 2 + cut[keys[1]][0]["value"]
    holds(tap, moved[0], 2 * end, "a plate before a lamp", 1e-9)
    holds(tap, moved[1], 0, "moved along its edge", 1e-7)


def random_spots(tap, tool):
    """Spots against complex steps of the formula."""
    draw = random.Random(7)

    def irradiance(x, y, z, intensity, exponent):
        distance = cmath.sqrt(x * x + y * y + z * z)
        return intensity * (z / distance) ** exponent * z / distance ** 3 * 1e6  # aimed along -z

    for i in range(12):
        numbers = [draw.uniform(-1500, 1500), draw.uniform(-1500, 1500), draw.uniform(300, 3000), draw.uniform(1, 1000),
                   draw.uniform(.3, 20)]
        lamp = ("  - {type: point, position: [%r, %r, %r], intensity: %r, pattern: cosine, exponent: %r}\n" %
                tuple(numbers))
        found = derive(tool, lamp, ["lights[0].position", "lights[0].intensity", "lights[0].exponent"])
        found = found["lights[0].position"] + [found["lights[0].intensity"], found["lights[0].exponent"]]
        for k, one in enumerate(found):
            step = [number + (1e-30j if j == k else 0) for j, number in enumerate(numbers)]
            truth = irradiance(*step).imag / 1e-30
            name = "lamp %d by number %d" % (i, k)
            tap.ok(abs(one["value"] - truth) <= one["error"] + 1e-14 * abs(truth), name, one, truth)
            tap.ok(one["error"] <= 1e-8 * abs(truth) + 1e-12, "its error", one)


def none_there(tap, tool):
    keys = ["lights[0].position"]
    lamp = "  - {type: point, position: [0, 0, 2000], intensity: 1}\n"
    plate = "[{type: rectangle, center: [%r, 0, 1000], size: [2000, 6000], axis: [0, 0, 1]}]"
    edge = derive(tool, lamp, keys, plate % 1000)["lights[0].position"]
    tap.ok(edge[0]["value"] is None and "jumps" in edge[0]["reason"], "at the edge of a hard shadow", edge)
    beside = derive(tool, lamp, keys, plate % 1000.01)["lights[0].position"]
    holds(tap, beside[0], 0, "a hundredth of a millimetre beside it", 1e-6)
    holds(tap, beside[2], -2 / 2000 * .25, "by height", 1e-7)
    level = derive(tool, lamp.replace("[0, 0, 2000]", "[2000, 0, 0]"), keys)["lights[0].position"]
    tap.ok(level[2]["value"] is None and "kink" in level[2]["reason"], "where a lamp rises over the plane", level)
    holds(tap, level[1], 0, "along the plane")
    sky = derive(tool, "  - {type: ambient, irradiance: 0}\n", ["lights[0].irradiance"])["lights[0].irradiance"]
    tap.equal((sky["value"], sky.get("one_sided")), (1, True), "from one side")
    tool.write("scene.yaml", SCENE % (lamp, "[]"))
    wrong = tool.run("derive", "scene.yaml", *ORIGIN, "--free", "lights[0].type", "--free", "lights[0].power", "--free",
                     "lights[0].intensty", "--free", "screen.resolution", "--free", "lights[0]")
    tap.ok(wrong.code == 2 and wrong.out == "" and wrong.err.count("error:") == 5 and "intensity" in wrong.err,
           "keys that cannot be derived by, all at once", wrong)
    tap.equal(tool.run("derive", "scene.yaml", *ORIGIN).code, 2, "no key")


def on_any_machine(tap, tool):
    """The same numbers by every instruction set."""
    lamps = ("  - {type: spot, position: [300, 100, 2000], aim: [0, 0, 0], intensity: 9, inner: 5, outer: 60}\n"
             "  - {type: distant, direction: [1, 2, -3], irradiance: 2}\n")
    sphere = "[{type: sphere, center: [0, 0, 100], radius: 150, material: {model: %s}}]"
    free = [word for key in ("lights[0].position", "lights[0].inner", "lights[1].direction", "surfaces[0].center",
                             "surfaces[0].material.shininess", "observer.z") for word in ("--free", key)]
    for model in ("phong", "blinn-phong"):
        tool.write("scene.yaml", SCENE % (lamps, sphere % model))
        runs = [tool.run("derive", "scene.yaml", "--json", "-p", "30,40", "-p", "-90,20", *free,
                         environment={"LUXEL_ISA": name} if name else {})
                for name in ("", "generic", "x86-64", "x86-64-v3")]
        told = [[point["derivatives"] for point in run.json()["points"]] for run in runs if run.code == 0]
        tap.ok(len(told) > 1 and all(one == told[0] for one in told), model, told)


def kinks(tap, tool):
    """Rules that change at the element: at the edge of a hard cone, where a linear one begins to fall, at a plate's."""
    lamp = ("  - {type: spot, position: [0, 0, 1000], axis: [0, 0, -1], intensity: 9, inner: %r, outer: 45, "
            "falloff: %s}\n")
    at = ("--at", "%r,0,0,0,0,1" % (1000 * math.tan(math.radians(30))), "--quantity", "irradiance")
    hard = derive(tool, lamp % (45, "hard"), ["lights[0].position"], options=("--at", "1000,0,0,0,0,1", *at[2:]))
    tap.ok("jumps" in hard["lights[0].position"][0]["reason"], "the edge of a hard cone", hard)
    linear = derive(tool, lamp % (30, "linear"), ["lights[0].position", "lights[0].outer"], options=at)
    tap.ok("kink" in linear["lights[0].position"][0]["reason"], "where a cone begins to fall", linear)
    holds(tap, linear["lights[0].position"][1], 0, "along the edge", 1e-7)
    edge = "[{type: rectangle, center: [0, 0, 0], size: [200, 200]}]"
    lamp = "  - {type: point, position: [0, 0, 2000], intensity: 1}\n"
    seen = derive(tool, lamp, ["surfaces[0].center", "lights[0].intensity"], edge, ("-p", "100,20"))
    tap.ok(seen["surfaces[0].center"][0]["value"] is None and seen["surfaces[0].center"][1]["value"] is not None,
           "the edge of a plate that moves", seen)


def of_all_lights(tap, tool):
    """By a key of all lights that have it: theirs add up, and by a dimming group's factor they do in their shares."""
    lamps = ("  - {type: ambient, irradiance: 1}\n  - {type: point, group: g, position: [300, 0, 900], intensity: 3}\n"
             "  - {type: point, group: g, position: [-700, 200, 2000], intensity: 5}\n"
             "dimming: [{name: g, factor: 0.5}]\n")
    keys = ["lights[*].intensity", "lights[1].intensity", "lights[2].intensity", "dimming[g].factor",
            "lights[*].position", "lights[1].position", "lights[2].position"]
    found = derive(tool, lamps, keys)
    by = [found[key] for key in keys]
    holds(tap, by[0], by[1]["value"] + by[2]["value"], "by the intensity of all")
    holds(tap, by[3], 2 * (3 * by[1]["value"] + 5 * by[2]["value"]), "by a dimming factor")
    for k in range(3):
        holds(tap, by[4][k], by[5][k]["value"] + by[6][k]["value"], "by the place of all", 1e-10)
    wrong = tool.run("derive", "scene.yaml", *ORIGIN, "--free", "lights[*].inner", "--free", "grids[*].center")
    tap.ok(wrong.code == 2 and "type spot" in wrong.err and "grids has no elements" in wrong.err, "none has it", wrong)


def of_grids(tap, tool):
    """The cells of a grid move with it: by its height as by the lamp's, but for the sign."""
    lamp = ("  - {type: point, position: [300, 100, 2000], intensity: 100}\n"
            "grids: [{name: desk, center: [0, 0, 500], size: [2000, 1000], n: [4, 3], measure: %s}]\n")
    keys = ["grids[desk].center", "lights[0].position", "grids[0].size"]
    options = ("--grid", "desk")
    for measure in ("plane", "cylindrical"):
        tool.write("scene.yaml", SCENE % (lamp % measure, "[]"))
        free = [word for key in keys for word in ("--free", key)]
        result = tool.run("derive", "scene.yaml", "--json", *options, *free)
        found = result.json()
        cells, average = found["cells"], found["average"]["derivatives"]
        tap.ok(result.code == 0 and found["n"] == [4, 3] and len(cells) == 12, measure, result)
        truth = tool.run("grid", "scene.yaml", "--json").json()["grids"][0]["values"]
        tap.ok(max(abs(cell["value"] - truth[cell["cell"][1]][cell["cell"][0]]) for cell in cells) < 1e-9,
               "the values are the grid's", cells, truth)
        for k in range(3):
            tap.ok(max(abs(cell["derivatives"][keys[0]][k]["value"] + cell["derivatives"][keys[1]][k]["value"]) -
                       2e-11 for cell in cells) <= 0, "against the lamp's place", cells)
            mean = sum(cell["derivatives"][keys[0]][k]["value"] for cell in cells) / 12
            tap.ok(abs(average[keys[0]][k]["value"] - mean) <= 1e-14, "the average of the cells", average, mean)
        corner = cells[0]["derivatives"]
        tap.near(corner[keys[2]][0]["value"], -0.375 * corner[keys[0]][0]["value"], 1e-9, "by the grid's width")
    text = tool.run("derive", "scene.yaml", *options, "--free", "grids[0].center")
    tap.ok(text.code == 0 and "the average of 4 × 3 cells" in text.out and "grids[0].center[2]" in text.out, "as text",
           text)
    tap.equal((tool.run("derive", "scene.yaml", *options, "-p", "0,0", "--free", "lights[0].intensity").code,
               tool.run("derive", "scene.yaml", "--grid", "dusk", "--free", "lights[0].intensity").code), (2, 2),
              "a grid or points, and one that there is")


def touching(tap, tool):
    """A lamp in the ceiling is outside of a lower room: what counts as touching hides no jump."""
    room = "[{type: room, center: [0, 0, 1400], size: [7200, 4800, 2800], up: z}]"
    lamp = "  - {type: point, position: [0, 0, 2800], intensity: 100}\n"
    found = derive(tool, lamp, ["surfaces[0].size"], room, ("--at", "100,200,750,0,0,1", "--quantity", "irradiance"))
    tap.ok(found["surfaces[0].size"][2]["value"] is None, "lower the lamp is outside", found)
    holds(tap, found["surfaces[0].size"][0], 0, "narrower it is not", 1e-10)


def reflected_light(tap, tool):
    """A furnace: all is E/(1 - rho), so that by E it is 1/(1 - rho), within what the bounds leave."""
    room = ("[{type: room, center: [0, 0, 0], size: [2000, 2000, 2000], "
            "material: {model: lambert, diffuse: .5, over_pi: true}}]")
    sky = "  - {type: ambient, irradiance: 2}\nreflections: all\n"
    found = derive(tool, sky, ["lights[0].irradiance"], room,
                   ("--at", "0,0,-1000,0,0,1", "--quantity", "irradiance"))["lights[0].irradiance"]
    tap.ok(abs(found["value"] - 2) <= found["error"] < .2, "a furnace", found)


if __name__ == "__main__":
    run_tests(Tap(), the_exercise, closed_forms, soft_shadows, random_spots, none_there, on_any_machine, kinks,
              of_all_lights, of_grids, touching, reflected_light)
