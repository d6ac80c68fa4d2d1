# SPDX-License-Identifier: MIT
"""luxel arrange: layouts against sums by hand and a scan of spacings, dimming, reflected light, and what is refused."""
import math

from tap import Tap
from tool import run_tests

ROOM = """luxel: 1
units: photometric
maintenance_factor: 0.8
screen: {width: 6000, height: 4000, resolution: [60, 40]}
observer: {z: 9000}
surfaces:
  - {type: room, center: [0, 0, 1400], size: [7200, 4800, 2800], up: z,
     material: {model: lambert, over_pi: true, diffuse: 0.5}}
lights:
  - {type: point, name: lamps, position: [0, 0, 2800], axis: [0, 0, -1], pattern: lambertian, power: 3600}  # a panel
  # more
grids:
  - {name: desk, center: [0, 0, 750], size: [6200, 3800], n: [13, 9]}
"""
GOALS = ("--goal", "average>=500", "--goal", "U0>=0.6")
COARSE = ("--reflected-error", "0.05")
X = [6200 * ((i + .5) / 13 - .5) for i in range(13)]
Y = [3800 * ((i + .5) / 9 - .5) for i in range(9)]


def values(n, spacing):
    """The illuminance of each cell under Lambert's lamps: I h^2/r^4."""
    at = [[(k - (n[i] - 1) / 2) * spacing[i] for k in range(n[i])] for i in (0, 1)]
    return [sum(3600 * .8 / math.pi * 2050 ** 2 / ((x - a) ** 2 + (y - b) ** 2 + 2050 ** 2) ** 2
                for a in at[0] for b in at[1]) * 1e6 for y in Y[:5] for x in X[:7]], at


def reserve(n, spacing):
    quarter, _ = values(n, spacing)  # by symmetry: rows and columns but the middle ones count twice
    weights = [(1 if row == 4 else 2) * (1 if column == 6 else 2) for row in range(5) for column in range(7)]
    average = sum(value * weight for value, weight in zip(quarter, weights)) / sum(weights)
    return min(average / 500, min(quarter) / average / .6), average, min(quarter) / average


def scan(n, steps=24):
    return max(reserve(n, (7200 / max(n[0] - 1, 1) * i / steps, 4800 / max(n[1] - 1, 1) * k / steps))[0]
               for i in range(1, steps + 1) for k in range(1, steps + 1))


def by_limit(layout):
    return {limit["name"]: limit for limit in layout["limits"]}


def nine(tap, tool):
    tool.write("room.yaml", ROOM)
    result = tool.run("arrange", "room.yaml", *GOALS, "--json", "-o", "out.yaml")
    found = result.json()
    best = found["layouts"][0]
    tap.equal((result.code, best["luminaires"], best["n"], found["light"], found["light_name"], best["dimming"]),
              (0, 9, [3, 3], 0, "lamps", 1), "nine, in three columns and rows")
    missed = {tuple(layout["n"]): layout for layout in found["missed"]}
    tap.ok((4, 2) in missed and (2, 4) in missed and all(one["luminaires"] < 9 for one in found["missed"]),
           "eight of either way are told", found["missed"])
    for layout in [best, missed[4, 2], missed[2, 4]]:
        n, limits = layout["n"], by_limit(layout)
        truth = reserve(n, layout["spacing"])
        tap.near(limits["average"]["value"], truth[1], 1e-9, "the average of %d x %d" % tuple(n))
        tap.near(limits["uniformity"]["value"], truth[2], 1e-9, "and its uniformity")
        tap.near(layout["reserve"], truth[0], 1e-9, "and how near it comes")
        tap.ok(layout["reserve"] > scan(n) - 1e-4, "no spacings of a scan are better", layout)
    tap.ok(missed[4, 2]["reserve"] < 1 and missed[2, 4]["reserve"] < 1 and
           {limit["verdict"] for limit in missed[4, 2]["limits"]} == {"fail"}, "eight cannot", missed)
    counts = [layout["luminaires"] for layout in found["layouts"]]
    tap.ok(counts == sorted(counts) and len(counts) > 1, "others are offered", counts)
    written = tool.read("out.yaml").decode()
    tap.ok("# a panel" in written and "array: {\"n\": [3, 3], spacing: [%d, %d]}" % tuple(best["spacing"]) in written,
           "the scene is written, comments kept", written)
    tap.equal(tool.run("grid", "out.yaml", "--limits").code, 0, "and keeps its limits")
    again = tool.run("arrange", "out.yaml", "--json", "--threads", "1").json()
    tap.equal(again["layouts"], found["layouts"], "its limits are goals, whatever the threads")
    text = tool.run("arrange", "room.yaml", *GOALS)
    tap.ok(text.code == 0 and "average ≥ 500 lx" in text.out and "< 500" in text.out and "3 × 3" in text.out,
           "as text", text)


def dimmed(tap, tool):
    tool.write("room.yaml", ROOM)
    found = tool.run("arrange", "room.yaml", *GOALS, "--dimming", "--json", "-o", "out.yaml").json()
    best = found["layouts"][0]
    tap.ok(best["luminaires"] == 9 and .9 < best["dimming"] < .98 and
           500 <= by_limit(best)["average"]["value"] < 500.6, "no more light than is wanted", best)
    power = float(tool.read("out.yaml").decode().split("power: ")[1].split(",")[0].split("}")[0])
    tap.near(power, 3600 * best["dimming"], 1e-12, "the light's power is less")
    tap.equal(tool.run("grid", "out.yaml", "--limits").code, 0, "and the limits are kept")
    # what another light gives need not come from these
    more = ROOM.replace("  # more", "  - {type: ambient, irradiance: 200}")
    tool.write("more.yaml", more)
    helped = tool.run("arrange", "more.yaml", *GOALS, "--dimming", "--json").json()["layouts"][0]
    tap.ok(helped["luminaires"] <= 6 and by_limit(helped)["average"]["value"] >= 500, "other lights count", helped)
    most = tool.run("arrange", "room.yaml", "--goal", "average>=300", "--goal", "maximum<=350", "--dimming", "--json")
    limits = by_limit(most.json()["layouts"][0])
    tap.ok(limits["average"]["value"] >= 300 and limits["maximum"]["value"] <= 350, "least and greatest values", limits)


def reflected(tap, tool):
    made = tool.run("room", "3,2,2.5", "--array", "1,1", "-o", "small.yaml", *COARSE)
    assert made.code == 0, made
    result = tool.run("arrange", "small.yaml", "--goal", "average>=500", "--goal", "U0>=0.5", "--goal", "ugr<=25",
                      "--json", "-o", "out.yaml", *COARSE)
    best = result.json()["layouts"][0]
    limits = {(limit["of"], limit["of_name"], limit["name"]): limit for limit in best["limits"]}
    tap.ok(result.code == 0 and best["luminaires"] > 1 and all(one["verdict"] == "pass" for one in limits.values()) and
           ("observer", "along x", "ugr") in limits, "with reflected light and glare", result)
    tap.equal(tool.run("grid", "out.yaml", "--limits", *COARSE).code, 0, "it keeps them")
    spread = [(n - 1) * spacing + 600 for n, spacing in zip(best["n"], best["spacing"])]
    tap.ok(spread[0] <= 3000.5 and spread[1] <= 2000.5, "panels stay within the walls", best)


def areas(tap, tool):
    """What EN 12464-1 wants around a task area counts as well: narrow beams alone would leave that dark."""
    tool.write("task.yaml", ROOM.replace("size: [6200, 3800], n: [13, 9]",
                                         "size: [2000, 1200], n: [9, 5], surround: 800, background: 3000")
               .replace("pattern: lambertian, power: 3600", "pattern: cosine, exponent: 30, power: 1000"))
    found = tool.run("arrange", "task.yaml", "--goal", "average>=500", "--json", "-o", "out.yaml").json()
    limits = by_limit(found["layouts"][0])
    tap.ok(set(limits) == {"average", "surround_average", "surround_uniformity", "background_average",
                           "background_uniformity"} and {one["verdict"] for one in limits.values()} == {"pass"},
           "the areas have goals", limits)
    tap.equal(tool.run("grid", "out.yaml", "--limits").code, 0, "and keep them")


def unreached(tap, tool):
    tool.write("room.yaml", ROOM)
    result = tool.run("arrange", "room.yaml", "--goal", "U0>=0.99", "--most", "12", "--json", "-o", "none.yaml")
    found = result.json()
    tap.ok(result.code == 1 and found["layouts"] == [] and found["missed"] and "none.yaml" not in tool.files() and
           "% of what is wanted" in result.err and "not written" in result.err, "not reached: the nearest is told",
           result)
    tool.write("up.yaml", ROOM.replace("axis: [0, 0, -1]", "axis: [0, 0, 1]"))
    tool.write("two.yaml", ROOM.replace("grids:", "grids:\n  - {name: floor, center: [0, 0, 0], size: [5000, 3000], "
                                        "n: [5, 3]}"))
    tool.write("lights.yaml", ROOM.replace("  # more", "  - {type: point, position: [1000, 0, 2800], power: 100}"))
    tool.write("far.yaml", ROOM[:ROOM.index("  - {type: point")] + "  - {type: ambient, irradiance: 1}\n" +
               ROOM[ROOM.index("grids:"):])
    for arguments, code, words, what in (
            (("room.yaml",), 2, ["no grid has a goal", "average>=500"], "no goal"),
            (("room.yaml", "--goal", "avrage>=5", "--goal", "U0>0.6", "--goal", "average>=x"), 2,
             ['"avrage>=5" is no goal', '"U0>0.6"', '"average>=x"'], "goals that are none, all at once"),
            (("room.yaml", "--goal", "average<=500"), 2, ["did you mean average>=500?"], "the wrong way"),
            (("room.yaml", "--goal", "maximum>=500"), 2, ["did you mean maximum<=500?"], "the wrong way round"),
            (("room.yaml", "--goal", "flor:average>=500"), 2, ["flor:average>=500: there is no such", "hint", "desk"],
             "no such grid"),
            (("two.yaml", "--goal", "average>=500"), 2, ["several grids", "floor, desk"], "which grid"),
            (("report", "--goal", "average>=500"), 2, ["no such grid"], "no grid"),
            (("room.yaml", "--goal", "ugr<=19"), 2, ["no such grid or observer"], "no observer"),
            (("room.yaml", "--goal", "U0>=2"), 3, ["uniformity"], "no legal limit"),
            (("room.yaml", "--goal", "average>=-5"), 3, ["average"], "below 0"),
            (("up.yaml", *GOALS), 2, ["no light of the luminaire reaches"], "light that goes elsewhere"),
            (("lights.yaml", *GOALS), 2, ["several lights"], "which light"),
            (("far.yaml", *GOALS), 2, ["none can be arranged"], "no light that stands somewhere"),
            (("room.yaml", *GOALS, "--most", "0"), 2, ["--most"], "none at all"),
            (("room.yaml", *GOALS, "-o", "out.png"), 2, ["out.png"], "a file that holds no scene")):
        result = tool.run("arrange", *arguments)
        tap.ok(result.code == code and result.out == "" and all(word in result.err for word in words), what, result)
    few = tool.run("arrange", "room.yaml", "--goal", "average>=5000", "--most", "12")
    tap.ok(few.code == 1 and "it takes 67 luminaires at least" in few.err, "so few give too little light anywhere", few)
    two = tool.run("arrange", "two.yaml", "--goal", "desk:average>=500", "--goal", "floor:U0>=0.4", "--json").json()
    tap.equal({limit["of_name"] for limit in two["layouts"][0]["limits"]}, {"desk", "floor"}, "a goal of each grid")
    one = tool.run("arrange", "lights.yaml", *GOALS, "--lights", "0", "--json").json()
    tap.equal((one["light"], one["layouts"][0]["luminaires"]), (0, 9), "the only light that is on")


if __name__ == "__main__":
    run_tests(Tap(), nine, dimmed, reflected, areas, unreached)
