# SPDX-License-Identifier: MIT
"""Dimming groups: lights of all kinds by the factor of their group, elements by their names, and what is refused."""
import json

from luminaires import HEAD
from tap import Tap
from tool import run_tests

LAMP = HEAD + "1 -1 1 4 1 1 2 .1 .2 0\n1 1 20\n0 30 60 90\n0\n1000 700 300 10\n"
SCREEN = {"luxel": 1, "units": "photometric", "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]},
          "observer": {"z": 4000}}
POINT = {"type": "point", "position": [0, 0, 2000], "intensity": 1000}
PANEL = {"type": "planar", "rectangle": {"center": [0, 400, 1800], "size": [600, 600], "axis": [0, 0, -1]},
         "radiance": 5000}
GRID = {"name": "plane", "center": [0, 0, 0], "size": [3000, 2000], "n": [3, 2]}
AT = ("--at", "200,100,0,0,0,1", "--quantity", "irradiance", "--tolerance", "1e-7")


def scene(*lights, dimming=(), **more):
    return json.dumps({**SCREEN, "surfaces": [], "lights": lights, "grids": [GRID], "dimming": dimming, **more})


def probe(tool, *options, command="probe"):
    result = tool.run(command, "scene.yaml", "--json", *AT, *options)
    assert result.code == 0, result
    return result.json()["points"][0]


def kinds(tap, tool):
    """Each kind of light gives its share, and a light without a group all."""
    tool.write("lamp.ies", LAMP)
    tool.write("cloud.csv", "x,y,z,intensity\n0,0,2000,3\n100,50,1500,7\n")
    lights = [POINT, PANEL, {**PANEL, "parts": 30}, {"type": "ambient", "irradiance": 100},
              {"type": "distant", "direction": [0, 1, -2], "irradiance": 90},
              {"type": "spot", "position": [0, 0, 2000], "power": 10, "inner": 20, "outer": 40},
              {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2000]},
              {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2000], "opening": "file"},
              {"type": "points", "file": "cloud.csv"}, {**POINT, "array": {"n": [2, 2], "spacing": [300, 300]}},
              {"type": "volume", "sphere": {"center": [0, 0, 2000], "radius": 50}, "power": 10}]
    for light in lights:
        found = []
        for factor in (1, 0.3, 0):
            tool.write("scene.yaml", scene({**light, "group": "a"}, {"type": "ambient", "irradiance": 50},
                                           dimming=[{"name": "a", "factor": factor}]))
            found.append((probe(tool), tool.run("grid", "scene.yaml", "--json").json()["grids"][0]))
        whole, dimmed, dark = (point["value"] - 50 for point, _ in found)
        tap.ok(whole > 0 and found[0][0]["error"] < 1e-6 * whole, "light of " + light["type"], found[0][0])
        tap.near(dimmed, 0.3 * whole, 2e-14, "dimmed to .3", found[1][0]["error"] + 0.3 * found[0][0]["error"])
        tap.ok(abs(dark) <= found[2][0]["error"], "and to nothing", found[2][0])
        averages = [grid["average"] - 50 for _, grid in found]
        tap.near(averages[1], 0.3 * averages[0], 1e-13, "on a grid", found[1][1]["average_error"] +
                 found[0][1]["average_error"])
    tool.write("scene.yaml", scene({**POINT, "group": "a"}, dimming=[{"name": "a", "factor": 0.7}],
                                   maintenance_factor=0.9))
    tap.near(probe(tool)["value"], 0.63 * tool.run("probe", "scene.yaml", "--json", *AT, "-s", "dimming=[]", "-s",
                                                   "maintenance_factor=1").json()["points"][0]["value"], 1e-15,
             "beside the maintenance factor")


def by_name(tap, tool):
    """Elements of lists by their names, in -s, sweeps and derivatives."""
    tool.write("scene.yaml", scene({**POINT, "name": "left lamp", "group": "windows"},
                                   {**POINT, "position": [900, 0, 2000], "group": "door.2"},
                                   dimming=[{"name": "windows", "factor": 0.5}, {"name": "door.2", "factor": 1}]))
    shares = [light["irradiance"] for light in probe(tool)["lights"]]
    for assignment, wanted in (("dimming[windows].factor=1", 2 * shares[0] + shares[1]),
                               ("dimming[door.2].factor=0.25", shares[0] + shares[1] / 4),
                               ("dimming[0].factor=0", shares[1]), ("dimming[*].factor=1", 2 * shares[0] + shares[1]),
                               ("lights[left lamp].intensity=3000", 3 * shares[0] + shares[1])):
        tap.near(probe(tool, "-s", assignment)["value"], wanted, 1e-15, assignment)
    derived = probe(tool, "--free", "dimming[windows].factor", command="derive")
    slope = derived["derivatives"]["dimming[windows].factor"]
    tap.near(slope["value"], 2 * shares[0], 1e-9, "the derivative is the light at full strength", slope["error"])
    tool.write("values.csv", "x,y,z,nx,ny,nz,value\n%s" % "".join(
        "%g,0,0,0,0,1,%r\n" % (x, tool.run("probe", "scene.yaml", "--json", "--at", "%g,0,0,0,0,1" % x, "--quantity",
                                           "irradiance", "-s", "dimming[windows].factor=0.8", "-s",
                                           "dimming[door.2].factor=0.4").json()["points"][0]["value"])
        for x in (-500, 0, 500, 1000)))
    fit = tool.run("fit", "scene.yaml", "--free", "dimming[windows].factor", "--free", "dimming[door.2].factor",
                   "--values", "values.csv", "--quantity", "irradiance", "--json")
    tap.ok(fit.code == 0, "luxel fit finds how groups are dimmed", fit)
    for parameter, wanted in zip(fit.json()["parameters"], (0.8, 0.4)):
        tap.near(parameter["value"], wanted, 1e-6, parameter["key"])
    told = tool.run("grid", "scene.yaml").out
    tap.ok("dimming windows 0.5, door.2 1" in " ".join(told.split()), "the groups are told with the conventions", told)
    tool.write("study.yaml", "study: 1\nscene: scene.yaml\n"
                             "vary:\n- {key: 'dimming[windows].factor', values: [0.1, 0.9]}\n"
                             "outputs: {irradiance: float32}\n"
                             "set: ['surfaces=[{type: rectangle, center: [0, 0, 0], size: [9000, 9000]}]']\n")
    swept = tool.run("sweep", "study.yaml", "--show", "1")
    tap.ok(swept.code == 0 and '0.9' in swept.out, "a sweep goes through them", swept)


def refusals(tap, tool):
    lights = ({**POINT, "group": "windows"}, POINT)
    for dimming, words in (([{"name": "window", "factor": 1}], "one of windows, not window"),
                           ([{"name": "windows", "factor": 1}, {"name": "windows", "factor": 0.5}], "given twice"),
                           ([{"name": "windows", "factor": 1.2}], "factor"), ([{"name": "windows"}], "factor"),
                           ([{"factor": 0.5}], "name")):
        result = tool.run("check", "-", stdin=scene(*lights, dimming=dimming))
        tap.ok(result.code == 3 and words in result.err, "refused: %s" % dimming, result)
    tool.write("scene.yaml", scene(*lights, dimming=[{"name": "windows", "factor": 1}]))
    for assignment, words in (("dimming[window].factor=1", "dimming[…] must be one of windows, not window"),
                              ("dimming[].factor=1", "not a valid key path"),
                              ("lights[lamp].intensity=1", "lights has 2 elements, lights[0] to lights[1]"),
                              ("grids[plane.n=[1,1]", "not a valid key path")):
        result = tool.run("grid", "scene.yaml", "-s", assignment)
        tap.ok(result.code == 2 and words in result.err, "refused: " + assignment, result)
    told = tool.run("derive", "scene.yaml", *AT, "--free", "lights[*].intensity", "--json").json()["points"][0]
    tap.near(told["derivatives"]["lights[*].intensity"]["value"] * 1000, told["value"], 1e-9, "by all together")


run_tests(Tap(), kinds, by_name, refusals)
