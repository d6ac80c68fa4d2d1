# SPDX-License-Identifier: MIT
"""--within and --keep: reflected light that the clock or Ctrl-C ends is told with bounds that hold, and says so."""
import json
import os
import re
import signal
import subprocess
import time

from tap import Tap
from tool import AT_ONCE, PATIENCE, run_tests, wait_until_caught

BOX = ("  - {type: box, center: [%d, 300, %d], size: [500, 600, 400], rotate: [0, %d, 0], "
       "material: {model: lambert, diffuse: 0.5, over_pi: true}}\n")
ROOM = """luxel: 1
units: photometric
reflections: all
screen: {width: 3200, height: 2400, resolution: [16, 12]}
observer: {position: [2500, 1600, 3800], target: [2500, 1000, 0], projection: perspective}
surfaces:
  - {type: room, center: [2500, 1400, 2000], size: [5000, 2800, 4000],
     material: {model: lambert, diffuse: 0.5, over_pi: true}}
""" + "".join(BOX % (900 + 1100 * (i % 4), 900 + 2000 * (i // 4), 20 * i) for i in range(8)) + """lights:
  - {type: point, position: [2300, 2600, 1900], power: 4000}
grids:
  - {center: [2500, 2000, 2000], size: [600, 400], n: [3, 2]}
  - {center: [2500, 1000, 2000], size: [600, 400], n: [3, 2]}
"""
AT = ("--at", "2500,0,2000,0,1,0", "--at", "300,2800,300,0,-1,0", "--quantity", "irradiance", "--threads", "1")
FINE = ("--reflected-error", "1e-4")


# Two plates in one plane: which is seen nobody knows, so that no effort makes the bound small.
IN_ONE_PLANE = """luxel: 1
reflections: all
screen: {width: 400, height: 400, resolution: [4, 4]}
observer: {z: 3000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [400, 400], material: {model: lambert, diffuse: 0.5, over_pi: true}}
  - {type: rectangle, center: [0, 0, 0], size: [200, 200], material: {model: lambert, diffuse: 0.2, over_pi: true}}
  - {type: rectangle, center: [200, 0, 200], size: [400, 400], axis: [-1, 0, 0],
     material: {model: lambert, diffuse: 0.5, over_pi: true}}
lights:
  - {type: point, position: [0, 0, 300], intensity: 10}
grids:
  - {center: [100, 0, 100], size: [20, 20], axis: [-1, 0, 0], n: [1, 1]}
"""


def values(result):
    return [(point["value"], point["error"]) for point in result.json()["points"]]


def agree(first, second):
    return all(abs(a - b) <= e + f and e < 1e300 for (a, e), (b, f) in zip(first, second))


def the_time_is_the_end(tap, tool):
    tool.write("room.yaml", ROOM)
    coarse = tool.run("probe", "room.yaml", *AT, "--reflected-error", "0.3", "--json")
    tap.ok(coarse.code == 0 and not coarse.err, "without an end", coarse)
    patient = tool.run("probe", "room.yaml", *AT, "--reflected-error", "0.3", "--within", "100000", "--json")
    tap.equal((patient.code, patient.out, patient.err), (0, coarse.out, ""), "a late end changes nothing")
    for seconds in ("0.001", "%g" % (0.5 * coarse.seconds), "%g" % (3 * coarse.seconds + 2)):
        ended = tool.run("probe", "room.yaml", *AT, *FINE, "--within", seconds, "--json")
        tap.ok(ended.code == 5 and "the time was the end" in ended.err and agree(values(ended), values(coarse)),
               "--within %s: values, bounds and exit code 5" % seconds, ended)
    tap.ok(ended.seconds < 10 * PATIENCE * (float(seconds) + 1), "it ends soon after", ended.seconds)
    told = re.search("bound of reflected light is ([^ ]*) where", ended.err)
    worst = max(error / value for value, error in values(ended))
    tap.ok(told and abs(float(told[1]) - worst) <= 0.1 * worst, "the bound is told", ended)
    quiet = tool.run("probe", "room.yaml", *AT, *FINE, "--within", "0.001", "-q")
    tap.ok(quiet.code == 5 and "the time" not in quiet.err, "-q says less", quiet)
    direct = tool.run("probe", "room.yaml", *AT, "-s", "reflections=none", "--within", "1", "--keep")
    tap.ok(direct.code == 0 and not direct.err, "nothing is reflected", direct)


def what_ended(answer):
    return [part["reflected"]["ended"] for part in answer.get("points", []) + answer.get("grids", [])]


def json_says_what_ended_it(tap, tool):
    tool.write("room.yaml", ROOM)
    tool.write("plates.yaml", IN_ONE_PLANE)
    asked = ("--at", "200,0,100,-1,0,0", "--quantity", "irradiance", "--json")
    for error, word, code in (("1e-3", "effort", 5), ("0.999", None, 0)):
        for command in (("probe", "plates.yaml", *asked), ("grid", "plates.yaml", "--json")):
            ended = tool.run(*command, "--reflected-error", error)
            tap.equal((ended.code, what_ended(ended.json())), (code, [word]), "%s: %s" % (command[0], word))
    ended = tool.run("probe", "room.yaml", *AT, *FINE, "--within", "0.05", "--json")
    tap.equal(what_ended(ended.json()), ["time", "time"], "time")


def in_all_commands(tap, tool):
    tool.write("room.yaml", ROOM)
    for command, at_end in ((["grid", "room.yaml"], 5), (["render", "room.yaml", "-o", "a.png"], 5),
                            (["stats", "room.yaml"], 5),
                            (["glare", "room.yaml", "--eye", "2500,1200,3500,0,0,-1"], 5)):
        ended = tool.run(*command, *FINE, "--within", "0.2", "--threads", "1", timeout=120)
        tap.ok(ended.code == at_end and "the time was the end" in ended.err and ended.out,
               "luxel %s" % command[0], ended)


def what_is_wrong(tap, tool):
    for word in ("0", "-1", "nan", "inf", "x", "", "1e7"):
        refused = tool.run("probe", "--within", word)
        tap.ok(refused.code == 2 and "--within" in refused.err and not refused.out, "--within %r" % word, refused)
    refused = tool.run("check", "--within", "1")
    tap.ok(refused.code == 2, "check refines nothing", refused)


def ctrl_c(tap, tool):
    tool.write("room.yaml", ROOM)
    coarse = values(tool.run("probe", "room.yaml", *AT, "--reflected-error", "0.3", "--json"))
    for keeps in (True, False):
        process = subprocess.Popen([tool.path, "probe", "room.yaml", *AT, *FINE, "--json"] + ["--keep"] * keeps,
                                   cwd=tool.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env={**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": ""})
        wait_until_caught(process)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=3 * AT_ONCE)
        if keeps and not out:
            tap.note("the signal came before anything was refined")
            continue
        tap.equal(process.returncode, 130, "the exit code")
        if not keeps:
            tap.equal((out, err), ("", ""), "without --keep nothing is printed")
            continue
        told = [(point["value"], point["error"]) for point in json.loads(out)["points"]]
        tap.ok(agree(told, coarse) and "Ctrl-C was the end" in err, "the best so far", (out, err))
        tap.equal(what_ended(json.loads(out)), ["interrupt", "interrupt"], "JSON says so")


run_tests(Tap(), the_time_is_the_end, json_says_what_ended_it, in_all_commands, what_is_wrong, ctrl_c)
