# SPDX-License-Identifier: MIT
"""The commands as people use them: their texts, the scenes they take, -s, --strict, exit codes."""
import json
import re

from tap import Tap
from tool import SCENE, run_tests


def render_text(tap, tool):
    result = tool.run("render")
    tap.equal((result.code, result.err), (0, ""), "render")
    for text in ("brightness in W/sr, 360 × 360 pixels", "11.7475", "P1 (0.0, 0.0)", "2.74882", "11.024",
                 "2.72759065255", "11.0380150393", "1.12996602329e-07", "(287, 180)", "sampling nodes"):
        tap.ok(text in result.out, "the table has " + text, result)
    tap.ok(re.search(r"maximum +11\.7475 +\(307, 1[78]\d\)", result.out), "the maximum's line", result)
    off = tool.run("render", "-s", "points=[[0,0],[400,0],[-240,240]]", "-s", "surfaces[0].radius=200")
    tap.ok("P2 (400.0, 0.0): off the surface" in off.out, "a point off the surface", off)
    tap.ok("P2 (400.0, 0.0): off the surface, off the screen" in off.out, "and off the screen", off)
    tap.ok("P3 (-240.0, 240.0): off the surface\n" in off.out, "a point of the screen off the surface", off)
    seen = tool.run("render", "-s", "points=[[270,0]]")
    tap.ok(re.search(r"P1 \(270\.0, 0\.0\) .*off the screen", seen.out), "a point of the surface off the screen", seen)
    empty = tool.run("render", "-s", "surfaces[0].center=[9000,0,1000]")
    tap.ok(empty.code == 0 and "no pixel shows a surface" in empty.out, "no surface in view", empty)
    lux = tool.run("render", "-s", "units=photometric", "--quantity", "irradiance",
                   "-s", "lights[0].attenuation=inverse-square")
    tap.ok("illuminance in lx" in lux.out, "photometric words", lux)


def probe_text(tap, tool):
    result = tool.run("probe", "-p", "0,0", "--at", "1,2,3,0,0,1")
    tap.equal((result.code, result.err), (0, ""), "probe")
    for text in ("P1 (0.0, 0.0): 2.727590652554", " ± ", "W/sr", "pixel (180, 180), pixel value 2.74882",
                 "P2 (1.0, 2.0, 3.0): ", "lights[0]", "point", "position (0.0, 0.0, 1300.0) mm, normal (0, 0, 1)"):
        tap.ok(text in result.out, "the text has " + text, result)


def bounds_in_text(tap, tool):
    """A bound is printed rounded up, and covers what was rounded off the number beside it."""
    false, found = [], 0
    for scene in "report", "office", "room":
        for command, row in (("probe", r"P\d+ \([^)]*\): (\S+) ± (\S+)"),
                             ("render", r"  P\d+ \([^)]*\) +(\S+) +(\S+)")):
            told = tool.run("probe", scene, "--json").json()["points"]
            shown = re.findall(row, tool.run(command, scene).out)
            found += len(shown)
            for (number, bound), point in zip(shown, (each for each in told if each["value"] is not None)):
                if abs(float(number) - point["value"]) + point["error"] > float(bound) * (1 + 1e-12):
                    false.append("%s %s: %s, %s, not %r ± %r" % (
                        command, scene, number, bound, point["value"], point["error"]))
    tap.ok(not false, "bounds in text are bounds", *false)
    tap.ok(found >= 12, "points in text", found)


def scenes(tap, tool):
    text = tool.run("scene")
    tap.equal((text.code, text.err), (0, ""), "scene")
    tap.equal(tool.run("scene", "report").out, text.out, "the default is report")
    tool.write("my.yaml", text.out)
    expected = tool.run("render", "--json").out
    tap.equal(tool.run("render", "my.yaml", "--json").out, expected, "the printed scene is the scene")
    tap.equal(tool.run("render", "-", "--json", stdin=text.out).out, expected, "from standard input")
    tap.equal(tool.run("render", "--json", "--", "my.yaml").out, expected, "after --")
    changed = tool.run("scene", "-s", "screen.width=1000", "-s", "screen.height=1000")
    tap.equal(changed.code, 0, "scene -s")
    tap.equal(tool.run("render", "-", "--json", stdin=changed.out).out,
              tool.run("render", "-s", "screen.width=1000", "-s", "screen.height=1000", "--json").out,
              "the printed changed scene is the changed scene")
    listing = tool.run("scene", "--list")
    tap.ok(listing.code == 0 and re.search(r"^report +\w", listing.out, re.M), "scene --list", listing)
    names = [scene["name"] for scene in tool.run("scene", "--list", "--json").json()["scenes"]]
    for name in names:
        own = tool.run("scene", name)
        tap.equal(tool.run("check", "-", "-q", stdin=own.out).code, 0, name + " is valid")
        tap.equal(tool.run("scene", name, "--json").json()["text"], own.out, name + " as JSON")
    tap.equal(tool.run("scene", "--list", "report").code, 2, "scene --list takes no name")
    wrong = tool.run("scene", "reprot")
    tap.ok(wrong.code == 4 and "did you mean report?" in wrong.err and not wrong.out, "an unknown scene", wrong)
    for command in "scene", "probe":
        wrong = tool.run(command, "qqqqqq")
        tap.ok(wrong.code == 4 and "luxel scene --list" in wrong.err, "nothing is near: " + command, wrong)
    absent = tool.run("scene", "absent.yaml")
    tap.ok(absent.code == 4 and "absent.yaml: no such file" in absent.err, "a file that is not there", absent)
    tool.write("a.yaml", tool.run("scene", "my.yaml").out)
    tap.equal(tool.run("render", "a.yaml", "--json").out, expected, "scene takes a file")
    tool.write("report", "no scene")
    tap.equal(tool.run("scene", "report").out, text.out, "a built-in scene goes before a file of its name")
    tap.equal(tool.run("scene", "-s", "screen.width=-1").code, 3, "scene -s with an illegal value")


def exact_zero(tap, tool):
    """What is known exactly has no bound, and relative values a unit that reads well."""
    dark = tool.run("probe", "three-lights", "-p", "0,-300")
    tap.ok(": 0 W/(sr·m²)\n" in dark.out and "± 0" not in dark.out, "an unlit place", dark.out)
    stats = tool.run("stats", "lampshade")
    tap.ok(" in relative units, " in stats.out and "± 0 " not in stats.out, "relative units", stats.out)


def json_scene(tap, tool):
    scene = {"luxel": 1, "screen": {"width": 500, "height": 500, "resolution": [36, 36], "sampling": "nodes"},
             "observer": {"z": 1500}, "surfaces": [{"type": "sphere", "center": [0, 0, 1000], "radius": 200}],
             "lights": [{"type": "point", "position": [2000, 0, 2000], "intensity": 10, "attenuation": "none"}],
             "points": [[0, 0], [150, 0], [-150, 0]]}
    tool.write("scene.json", json.dumps(scene, indent=2))
    tool.write("scene.yaml", SCENE)
    tap.equal(tool.run("render", "scene.json", "--json").out, tool.run("render", "scene.yaml", "--json").out,
              "a JSON scene is a scene")


def names_and_files(tap, tool):
    tool.write("report", SCENE)
    tap.equal(tool.run("render", "report", "--json").json()["resolution"], [36, 36], "a file goes before a built-in")
    tap.equal(tool.run("render", "--json").json()["resolution"], [360, 360], "not where no SCENE is given")
    gone = tool.run("render", "gone.yaml")
    tap.ok(gone.code == 4 and "gone.yaml" in gone.err and "no such file" in gone.err, "no such file", gone)
    near = tool.run("check", "reporrt")
    tap.ok(near.code == 4 and "did you mean report?" in near.err, "neither a file nor a built-in", near)
    tap.equal(tool.run("render", ".").code, 4, "a folder is no scene")
    tap.equal(tool.run("render", "").code, 4, "an empty name is no scene")


def assignments(tap, tool):
    def first(*options):
        result = tool.run("probe", "-p", "0,0", "--json", *options)
        return result.json()["points"][0]["value"] if result.code == 0 else result.fail("no value")

    base = first()
    tap.near(first("-s", "lights[0].intensity=20"), 2 * base, 1e-12, "-s lights[0].intensity=20")
    tap.near(first("-s", "lights.0.intensity=20"), 2 * base, 1e-12, "-s lights.0.intensity=20")
    tap.near(first("--set", "lights[0].intensity=20"), 2 * base, 1e-12, "--set")
    tap.near(first("--set=lights[0].intensity=20"), 2 * base, 1e-12, "--set=")
    tap.near(first("-slights[0].intensity=20"), 2 * base, 1e-12, "-sKEY=VALUE")
    tap.near(first("-s", "lights[0].intensity=5", "-s", "lights[0].intensity=30"), 3 * base, 1e-12, "the last wins")
    light = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
    tap.near(first("-s", "lights=[%s, %s]" % (light, light)), 2 * base, 1e-12, "a whole list")
    tap.near(first("-s", "lights[0]={type: ambient, irradiance: 3}"), 2.4, 1e-12, "a whole element")
    tap.near(first("-s", "surfaces[0].material.over_pi=true"), base / 3.141592653589793, 1e-12, "a key not yet there")
    tap.equal(first("-s", "lights=[]"), 0, "an empty list")
    tool.write("bad.yaml", SCENE.replace("radius: 200", "radius: -200"))
    both = tool.run("render", "bad.yaml", "-s", "lights[0].intensty=3", "-s", "nonsense")
    tap.equal(both.code, 2, "a wrong path weighs more than a wrong file")
    for text in ("bad.yaml:8:13: error:", "intensity", "nonsense"):
        tap.ok(text in both.err, "and all errors are told: " + text, both)
    repaired = tool.run("render", "bad.yaml", "-s", "surfaces[0].radius=200", "--json")
    tap.equal(repaired.code, 0, "-s can repair a file")


def check(tap, tool):
    scene = SCENE.replace("[36, 36]", "[240, 240]")
    tool.write("good.yaml", scene)
    good = tool.run("check", "good.yaml")
    tap.equal((good.code, good.out.split("\n")[0], good.err), (0, "good.yaml: valid", ""), "a valid scene")
    tap.equal(tool.run("check", "-", stdin=scene).out.split("\n")[0], "<stdin>: valid", "from standard input")
    tap.equal(tool.run("check", "good.yaml", "-q").out, "", "quietly")
    tap.equal(tool.run("check", "good.yaml", "--strict").code, 0, "without advice --strict passes")
    report = tool.run("check")
    tap.ok(report.code == 0 and report.out.startswith("report: valid\n") and "advice:" in report.out,
           "the report's sphere is larger than its screen", report)
    tool.write("odd.yaml", scene.replace("intensity: 10", "intensity: 1e6"))
    odd = tool.run("check", "odd.yaml")
    tap.ok(odd.code == 0 and "odd.yaml:11:57: advice:" in odd.out, "advice has a place", odd)
    answer = tool.run("check", "odd.yaml", "--json").json()
    tap.equal((answer["valid"], answer["errors"]), (True, []), "check --json of a valid scene")
    entry = answer["advice"][0]
    tap.equal(list(entry), ["id", "message", "hint", "source", "line", "column", "key"], "members of an entry")
    tap.equal((entry["source"], entry["line"], entry["column"], entry["key"]),
              ("odd.yaml", 11, 57, "lights[0].intensity"), "place of the advice")
    strict = tool.run("check", "odd.yaml", "--strict", "--json")
    tap.equal((strict.code, strict.json()["valid"], len(strict.json()["errors"])), (3, False, 1), "--strict --json")
    tool.write("bad.yaml", SCENE.replace("radius: 200", "radius: 0").replace("width: 500", "width: x"))
    bad = tool.run("check", "bad.yaml", "--json")
    tap.equal((bad.code, bad.json()["valid"], [entry["line"] for entry in bad.json()["errors"]]), (3, False, [3, 8]),
              "check --json of a scene with errors")
    tap.ok("bad.yaml:3:17: error:" in bad.err and "bad.yaml:8:13: error:" in bad.err, "errors on stderr too", bad)


def strict_everywhere(tap, tool):
    odd = ("-s", "lights[0].intensity=1e6", "--strict")
    for arguments in (("render", "-o", "x.png"), ("probe",), ("check",), ("scene",)):
        result = tool.run(*arguments, *odd)
        tap.ok(result.code == 3 and not result.out and "error:" in result.err and "intensity" in result.err,
               "%s --strict" % arguments[0], result)
    tap.equal(tool.files(), [], "and nothing is written")
    tap.equal(tool.run("render", *odd[:2]).err, "", "without it render prints no advice")


def tolerance(tap, tool):
    tight = tool.run("probe", "--tolerance", "1e-300", "--json")
    tap.equal(tight.code, 5, "a tolerance that cannot be reached")
    tap.ok("above the tolerance: 3 of 3" in tight.err, "is told", tight)
    tap.near(tight.json()["points"][0]["value"], 2.7275906525546927, 1e-12, "the values are printed all the same")
    cells = tool.run("grid", "desk", "--tolerance", "1e-300")
    tap.ok(cells.code == 5 and "above the tolerance: 1 of 1" in cells.err and cells.out, "grid, too", cells)
    tap.equal(tool.run("render", "--tolerance", "1e-300", "-o", "x.png").code, 5, "render, too")
    tap.equal(tool.files(), ["x.png"], "and files are written")
    tap.equal(tool.run("probe", "--tolerance", "1e-6").code, 0, "one that is reached")
    far = "lights=[{type: point, position: [0, 0, 1e170], intensity: 1}]"
    for scene, command in (("report", "probe"), ("report", "render"), ("desk", "grid")):
        result = tool.run(command, scene, "-s", far)
        tap.ok(result.code == 5 and result.out, "no bound is never good enough: %s" % command, result)


def radii(tap, tool):
    """A sphere looks the same whatever the power of two that its lengths are multiplied by."""
    def ball(radius):
        return tool.run("probe", "-p", "0,0", "-s", "surfaces=[{type: sphere, center: [0, 0, %r], radius: %r}]" %
                        (-radius, radius), "-s", "observer.z=%r" % (2 * radius), "-s",
                        "lights=[{type: distant, direction: [1, 2, -3], irradiance: 5}]", "--json").json()["points"][0]

    usual = ball(1.0)
    tap.equal(usual["normal"], [0, 0, 1], "the top of a sphere")
    for power in (-1070, -1000, -600, -520, 510, 600, 1000):
        told = ball(2.0 ** power)
        for key in "value", "error", "normal":
            tap.equal(told[key], usual[key], "%s for a radius of 2^%d mm" % (key, power))


def many_errors(tap, tool):
    scene = SCENE + "".join("wrong%d: 1\n" % i for i in range(30))
    result = tool.run("check", "-", stdin=scene)
    tap.equal((result.code, len(re.findall(r"^<stdin>:\d+:1: error:", result.err, re.M))), (3, 20), "20 errors kept")
    tap.ok("and 10 more errors" in result.err, "and the number of the rest", result)


run_tests(Tap(), render_text, probe_text, bounds_in_text, scenes, exact_zero, json_scene, names_and_files, assignments,
          check, strict_everywhere, tolerance, radii, many_errors)
