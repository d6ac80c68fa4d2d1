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


HALL = """luxel: 1
units: photometric
screen: {width: 6000, height: 4000, resolution: [60, 40]}
observer: {z: 9000}
surfaces: []
lights:
%s
grids:
  - {name: desk, center: [0, 0, 0], size: [4000, 2000], n: [4, 2]}
"""
LAMP = "  - {type: point, position: [%d, 0, 2000], intensity: 500}\n"


def one_by_one(tap, tool):
    """Lamps dimmed one by one for the least flux: a linear program whose ends are tried by hand, pair by pair."""
    at = (-1200, 100, 1500)
    tool.write("hall.yaml", HALL % "".join(LAMP % x for x in at))
    free = [word for i in range(3) for word in ("--free", "lights[%d].intensity" % i)]
    result = tool.run("arrange", "hall.yaml", "--goal", "minimum>=100", "--dimming", "--json", "-o", "out.yaml", *free)
    best = result.json()["layouts"][0]
    # by symmetry one row of cells: the light of each lamp at each, per candela
    light = [[2000 / ((x - lamp) ** 2 + 500 ** 2 + 2000 ** 2) ** 1.5 * 1e6 for lamp in at] for x in
             (-1500, -500, 500, 1500)]
    ends = []
    bounds = light + [[float(i == k) for k in range(3)] for i in range(3)]
    for rows in ((i, j, k) for i in range(7) for j in range(i) for k in range(j)):
        a = [bounds[i] for i in rows]
        b = [100.0 if i < 4 else 0.0 for i in rows]
        whole = determinant(a)
        if abs(whole) < 1e-12:
            continue
        ends.append([determinant([[b[n] if m == k else a[n][m] for m in range(3)] for n in range(3)]) / whole
                     for k in range(3)])
    least = min(sum(end) for end in ends if min(end) >= -1e-9 and
                all(sum(c * i for c, i in zip(cell, end)) >= 100 - 1e-6 for cell in light))
    numbers = [best["numbers"]["lights[%d].intensity" % i] for i in range(3)]
    tap.ok(result.code == 0 and best["limits"][0]["verdict"] == "pass" and
           least - 1e-9 <= sum(numbers) <= least * 1.001, "the least flux", sum(numbers), least)
    tap.near(best["dimming"], sum(numbers) / 1500, 1e-9, "and its share")
    tap.equal(tool.run("grid", "out.yaml", "--limits").code, 0, "its scene keeps the goal")


def determinant(a):
    return (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
            a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]))


def aimed(tap, tool):
    """A narrow lamp that looks away finds the plane: by symmetry its middle; nothing of a scan is better."""
    lamp = ("  - {type: point, position: [0, 0, 2000], intensity: 5000, pattern: cosine, exponent: 4, "
            "aim: [%r, %r, 0]}\n")
    tool.write("aim.yaml", HALL % (lamp % (900, 700)))
    result = tool.run("arrange", "aim.yaml", "--goal", "minimum>=100", "--free", "lights[0].aim", "--json")
    best = result.json()["layouts"][0]
    aim = [best["numbers"]["lights[0].aim[%d]" % k] for k in range(3)]
    middle = [aim[k] * 2000 / (2000 - aim[2]) for k in range(2)]
    tap.ok(result.code == 0 and math.hypot(*middle) < 10, "at the middle", aim)
    scanned = []
    for x in (0, 40, 400):
        tool.write("scan.yaml", HALL % (lamp % (x, x / 2)))
        scanned.append(min(sum(tool.run("grid", "scan.yaml", "--json").json()["grids"][0]["values"], [])))
    tap.ok(best["limits"][0]["value"] >= max(scanned) * (1 - 1e-5), "none of a scan is better", best, scanned)
    text = tool.run("arrange", "aim.yaml", "--goal", "minimum>=1e5", "--free", "lights[0].aim")
    tap.ok(text.code == 1 and "lights[0].aim[2]" in text.out and "% of what is wanted" in text.err, "as text", text)


DAZZLING = """luxel: 1
units: photometric
reflections: 1
screen: {width: 4000, height: 4000, resolution: [40, 40]}
observer: {z: 9000}
surfaces:
  - {type: room, center: [0, 0, 1400], size: [6000, 4000, 2800], up: z,
     material: {model: lambert, diffuse: 0.6, over_pi: true}}
lights:
  - {type: planar, rectangle: {center: [600, 0, 2500], size: [400, 400]}, power: 3000}
grids: [{name: desk, center: [-1500, 0, 750], size: [1500, 1500], n: [5, 5]}]
observers: [{name: sitting, eye: [-2500, 0, 1200], view: [1, 0, 0]}]
"""


def without_glare(tap, tool):
    """The panel that lights the desk best is seen by who sits there; told so, one is found that dazzles nobody."""
    tool.write("glare.yaml", DAZZLING)
    free = ("--free", "lights[0].rectangle.center[0]", "--free", "lights[0].power", "--reflected-error", "0.05")
    found = tool.run("arrange", "glare.yaml", "--goal", "average>=150", "--goal", "ugr<=16", *free, "--json",
                     "-o", "out.yaml")
    layouts = found.json()["layouts"]
    limits = [{limit["name"]: limit["verdict"] for limit in layout["limits"]} for layout in layouts]
    tap.ok(found.code == 0 and layouts and all(one == {"average": "pass", "ugr": "pass"} for one in limits),
           "lit and not dazzled", found)
    tap.equal(tool.run("grid", "out.yaml", "--limits", "--reflected-error", "0.05").code, 0, "it keeps both")
    alone = tool.run("arrange", "glare.yaml", "--goal", "average>=150", *free, "--json").json()["layouts"][0]
    tap.ok(alone["numbers"]["lights[0].power"] > 5 * layouts[0]["numbers"]["lights[0].power"],
           "without that goal it would be bright", alone)


def several_arrays(tap, tool):
    """The spacings of two arrays at once: better than either alone."""
    array = "  - {type: point, position: [0, %d, 2000], intensity: 200, array: {n: [2, 1], spacing: [500, 1]}}\n"
    tool.write("rows.yaml", HALL % (array % -600 + array % 600))
    goals = ("--goal", "U0>=0.99", "--json")
    found = [tool.run("arrange", "rows.yaml", *goals, *(word for i in lights for word in
                                                        ("--free", "lights[%d].array.spacing[0]" % i))).json()
             for lights in ((0,), (1,), (0, 1))]
    reserves = [(one["layouts"] + one["missed"])[0]["reserve"] for one in found]
    tap.ok(reserves[2] > max(reserves[:2]) + 0.01, "two arrays", reserves)
    for options, words in ((("--free", "lights[0].type"), "numbers that vary"),
                           (("--free", "lights[9].position"), "lights")):
        refused = tool.run("arrange", "rows.yaml", "--goal", "U0>=0.9", *options)
        tap.ok(refused.code == 2 and words in refused.err and not refused.out, words, refused)


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
    run_tests(Tap(), nine, dimmed, reflected, areas, one_by_one, aimed, without_glare, several_arrays,
              unreached)
