# SPDX-License-Identifier: MIT
"""luxel fit: what it prints and writes, tables and pictures, what is not determined, and messages about wrong input."""
import random

from tap import Tap
from tool import SCENE, run_tests

DESK = """luxel: 1
units: photometric
screen: {width: 5000, height: 4000, resolution: [50, 40]}
observer: {z: 9000}
surfaces: []
lights:
  - {type: point, position: [%s], intensity: %s}   # as the ladder tells
"""
LAMP = ("--free", "lights[0].position", "--free", "lights[0].intensity", "--quantity", "irradiance")
GRID = [(x, y) for y in (500, 1500, 2500) for x in (500, 2000, 3500)]
CORNERS = [(0, 0), (4000, 0), (4000, 3000), (0, 3000)]


def illuminance(x, y, lamp=(2100, 1700, 2600), intensity=1000):
    offset = (lamp[0] - x, lamp[1] - y, lamp[2] - 750)
    return intensity * offset[2] / sum(one * one for one in offset) ** 1.5 * 1e6


def write(tool, places=GRID, noise=0.0, heading="x_mm,y_mm,z_mm,nx,ny,nz,value_lx", lamp=(2100, 1700, 2600),
          start=("2000, 1500, 2400", "800")):
    draw = random.Random(3)
    tool.write("desk.yaml", DESK % start)
    tool.write("readings.csv", heading + "\n" + "".join(
        "%r,%r,750,0,0,1,%r\n" % (x, y, illuminance(x, y, lamp) * (1 + noise * draw.gauss(0, 1))) for x, y in places))


def readings(tap, tool):
    write(tool)
    result = tool.run("fit", "desk.yaml", *LAMP, "--values", "readings.csv", "--noise", "3%", "--json", "-o",
                      "fitted.yaml", "--residual", "left.csv")
    found = result.json()
    tap.equal((result.code, found["rank"], found["free"], found["dof"], found["undetermined"], found["readings"]),
              (0, 4, 4, 5, [], 9), "what is determined")
    for parameter, truth, name in zip(found["parameters"], (2100, 1700, 2600, 1000),
                                      ["lights[0].position[%d]" % k for k in range(3)] + ["lights[0].intensity"]):
        tap.equal(parameter["key"], name, "its key")
        tap.near(parameter["value"], truth, 1e-9, "its value")
        tap.ok(abs(parameter["high"] - truth - 1.96 * parameter["sd"]) < 1e-3 * parameter["sd"] and
               abs(parameter["low"] + parameter["high"] - 2 * truth) < 1e-6 * truth, "its interval", parameter)
    tap.ok(all(found["correlation"][i][i] == 1 for i in range(4)) and found["correlation"][2][3] > .85, "correlation",
           found["correlation"])
    text = tool.read("fitted.yaml").decode()
    tap.ok("# as the ladder tells" in text and "surfaces: []" in text and tool.run(
        "fit", "fitted.yaml", *LAMP, "--values", "readings.csv", "--json").json()["starts"]["agreed"] > 0,
           "the fitted scene keeps its layout", text)
    lines = tool.read("left.csv").decode().split()
    tap.ok(lines[0] == "x_mm,y_mm,z_mm,nx,ny,nz,value_lx,residual_lx" and len(lines) == 10 and
           all(abs(float(line.split(",")[-1])) < 1e-6 for line in lines[1:]), "residuals", lines)
    write(tool, noise=.03)
    result = tool.run("fit", "desk.yaml", *LAMP, "--values", "readings.csv")
    tap.ok(result.code == 0 and "9 readings, 4 of 4 numbers determined" in result.out and "± sd" in result.out and
           "Correlation:" in result.out and "scatter by" in result.out, "as text", result)
    tool.write("points.csv", "x,y,value\n0,0,2.7\n150,0,11.0\n-150,0,0.05\n100,50,8\n")
    result = tool.run("fit", "--free", "lights[0].intensity", "--values", "points.csv", "--json")
    found = result.json()
    tap.ok(result.code == 0 and 9 < found["parameters"][0]["value"] < 11 and found["noise"]["estimated"],
           "points of the screen", result)


def not_determined(tap, tool):
    write(tool, CORNERS, lamp=(2000, 1500, 2600))
    result = tool.run("fit", "desk.yaml", *LAMP, "--values", "readings.csv", "--noise", "1", "--json", "-o",
                      "none.yaml")
    found = result.json()
    tap.equal((result.code, found["rank"], found["free"], len(found["undetermined"])), (5, 3, 4, 1), "four corners")
    tap.ok([parameter["value"] is None for parameter in found["parameters"]] == [False, False, True, True] and
           all(found["parameters"][3][name] is None for name in ("sd", "low", "high")) and
           "lights[0].position[2], lights[0].intensity" in found["undetermined"][0], "what is not has no number", found)
    tap.ok("none.yaml" not in tool.files() and "not written" in result.err, "nor a scene", result.err)
    result = tool.run("fit", "desk.yaml", *LAMP, "--values", "readings.csv", "--noise", "1")
    tap.ok("4 readings, 3 determined: lights[0].position[0], lights[0].position[1], one combination of "
           "lights[0].position[2], lights[0].intensity" in result.out and "not determined" in result.out, "as text",
           result)


def pictures(tap, tool):
    scene = SCENE.replace("attenuation: none", "attenuation: inverse-square")
    tool.write("truth.yaml", scene)
    for name in ("p.exr", "p.npy", "p.png", "p16.png"):
        result = tool.run("render", "truth.yaml", "-o", name, *(["--bits", "16"] if "16" in name else []))
        assert result.code == 0, result.err
    start = ("-s", "lights[0].position=[1800, 150, 2300]")
    keys = ("--free", "lights[0].position", "--free", "surfaces[0].material.shininess")
    for name, close in (("p.exr", .5), ("p.npy", .5), ("p16.png", 2), ("p.png", 60)):
        result = tool.run("fit", "truth.yaml", *start, *keys, "--picture", name, "--json", "--residual", "left.npy")
        found = [parameter["value"] for parameter in result.json()["parameters"]]
        tap.ok(result.code == 0 and all(abs(one - truth) < close for one, truth in zip(found, (2000, 0, 2000, 20))),
               "of " + name, result)
        tap.equal(len(found), 5 if "png" in name else 4, "levels have a factor")
    stats = tool.run("stats", "left.npy", "--json").json()
    tap.ok(abs(stats["max"]["value"]) < 3, "residuals of it are some levels", stats)
    values = ("-s", "picture.range=[0, 6]")
    tool.run("render", "truth.yaml", *values, "-o", "range.png", "--bits", "16")
    result = tool.run("fit", "truth.yaml", *values, *start, *keys, "--free", "lights[0].intensity", "--picture",
                      "range.png", "--json")
    tap.ok(result.code == 0 and abs(result.json()["parameters"][4]["value"] - 10) < .05, "levels of a known range",
           result)


def wrong(tap, tool):
    write(tool)
    tool.write("log.yaml", SCENE.replace("range: max", "range: log"))
    tool.run("render", "log.yaml", "-o", "log.png")
    tool.write("bad.csv", "x,y,z,nx,ny,nz,value\n1,2,3,0,0,0,5\n1,2,3,0,0,,5\n1,2,3,0,0,1,six\n")
    tool.write("few.csv", "x,y,z,nx,ny,nz,value\n1,2,3,0,0,1,5\n")
    tool.write("off.csv", "x,y,value\n0,0,1\n4000,0,1\n5000,0,2\n")
    tool.write("unit.csv", "x,y,value_lx\n0,0,1\n")
    values = ("--values", "readings.csv")
    for arguments, code, words, what in (
            (("desk.yaml", *values), 2, ["no key is free"], "no free key"),
            (("desk.yaml", "--free", "lights[0].intensity"), 2, ["--picture FILE or by --values FILE"], "no readings"),
            (("desk.yaml", *LAMP, *values, "--picture", "p.exr"), 2, ["one of them"], "two kinds of readings"),
            (("desk.yaml", "--free", "lights[0].type", "--free", "screen.resolution", *values), 2,
             ["vary continuously", "resolution"], "a choice and whole numbers"),
            (("desk.yaml", "--free", "lights[0].position", "--free", "lights[0].position[0]", *values), 2,
             ["the same number"], "one that is free twice"),
            (("desk.yaml", *LAMP, "--values", "few.csv"), 2, ["readings: 1", "to be found from them: 4", "hint"],
             "fewer readings than unknowns"),
            (("--free", "lights[0].intensity", "--values", "off.csv"), 2,
             ["reading 2 at (4000, 0)", "reading 3", "hint"], "readings off the surface, all of them"),
            (("desk.yaml", *LAMP, *values, "--saturated", "1"), 2, ["all readings are saturated", "hint"],
             "all are saturated"),
            (("--free", "lights[0].intensity", "--values", "unit.csv"), 4, ["lx", "W/sr", "hint"],
             "units that do not fit"),
            (("desk.yaml", *LAMP, "--values", "bad.csv"), 4, ["bad.csv:2:7", "bad.csv:3", "six"], "rows, all at once"),
            (("desk.yaml", *LAMP, "--values", "none.csv"), 4, ["none.csv"], "no file"),
            (("desk.yaml", *LAMP, *values, "--noise", "3%x"), 2, ["--noise 3%x"], "noise that is none"),
            (("desk.yaml", *LAMP, *values, "--noise", "0"), 2, ["above 0"], "no noise"),
            (("desk.yaml", *LAMP, *values, "--loss", "hubber"), 2, ["did you mean huber"], "another loss"),
            (("log.yaml", "--free", "lights[0].intensity", "--picture", "log.png"), 2, ["picture.range is log", "hint"],
             "levels that tell no values"),
            (("log.yaml", "-s", "screen.resolution=[8, 8]", "-s", "picture.range=max", "--free", "lights[0].intensity",
              "--picture", "log.png"), 2, ["36 x 36", "8 x 8", "resolution=[36, 36]"], "another size"),
            (("desk.yaml", *LAMP, *values, "--residual", "left.exr"), 2, ["left.exr"],
             "residuals of points as a picture"),
            (("desk.yaml", *LAMP, *values, "-o", "no/where.yaml"), 4, ["no/where.yaml"], "no such folder")):
        result = tool.run("fit", *arguments)
        tap.ok(result.code == code and result.out == "" and all(word in result.err for word in words), what, result)
    tap.ok("--picture" in tool.run("profile", "--help").out and tool.run("profile", "--picture", "--json").code == 0,
           "luxel profile keeps its flag of that name")


def told_once(tap, tool):
    tap.equal(tool.run("fit", "--help").out.count("Extensions of FILE"), 1, "help names the extensions once")


def of_all(tap, tool):
    """One intensity of two lamps; where they have two there is no such number to begin with."""
    lamps = "lights:\n" + "".join("  - {type: point, position: [%d, 0, 1000], intensity: %d}\n" % one
                                  for one in ((-200, 3), (400, 3)))
    tool.write("both.yaml", "luxel: 1\nscreen: {width: 400, height: 400, resolution: [8, 8]}\nobserver: {z: 9000}\n"
               "surfaces: []\n" + lamps)
    at = [(0, 0), (100, 0), (300, 50)]
    told = [7 * sum(1000 / ((x - lamp) ** 2 + y * y + 1e6) ** 1.5 * 1e6 for lamp in (-200, 400)) for x, y in at]
    tool.write("both.csv", "x,y,z,nx,ny,nz,value\n" + "".join("%r,%r,0,0,0,1,%r\n" % (x, y, value)
                                                            for (x, y), value in zip(at, told)))
    key = ("--free", "lights[*].intensity", "--values", "both.csv", "--quantity", "irradiance")
    found = tool.run("fit", "both.yaml", *key, "--noise", "1%", "--json", "-o", "out.yaml").json()["parameters"]
    tap.ok(len(found) == 1 and found[0]["key"] == "lights[*].intensity" and abs(found[0]["value"] - 7) < 1e-8,
           "one number for both", found)
    written = [float(part.split("}")[0]) for part in tool.read("out.yaml").decode().split("intensity: ")[1:]]
    tap.equal(written, [found[0]["value"]] * 2, "both have it")
    apart = tool.run("fit", "both.yaml", "-s", "lights[1].intensity=4", *key)
    twice = tool.run("fit", "both.yaml", "--free", "lights[1].intensity", *key)
    tap.ok(apart.code == 2 and "is to be one number" in apart.err and twice.code == 2 and "free only once" in twice.err,
           "refused", apart, twice)


if __name__ == "__main__":
    run_tests(Tap(), readings, not_determined, pictures, wrong, of_all,
              told_once)
