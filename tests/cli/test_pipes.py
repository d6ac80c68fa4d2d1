# SPDX-License-Identifier: MIT
"""Results in pipes: -o - in every format, what else may be printed then, readers who leave, --json."""
import json
import os
import pty
import subprocess

from tap import Tap
from tool import SCENE, run_tests

GRIDS = "grids=[{center: [0,0,1000], size: [100,100], n: [3,2]}]"
FORMATS = [("render", "png", b"\x89PNG"), ("render", "npy", b"\x93NUMPY"), ("render", "pfm", b"Pf\n"),
           ("render", "csv", b"x_mm,"), ("render", "exr", b"\x76\x2f\x31\x01"), ("profile", "csv", b"distance_mm,"),
           ("isophotes", "csv", b"line,")]


def run_bytes(tool, *arguments, **how):
    return subprocess.run([tool.path] + list(arguments), cwd=tool.folder, capture_output=True, check=False, **how)


def the_file_itself(tap, tool):
    for command, form, start in FORMATS:
        tool.run(command, "-o", "file." + form)
        for name in "-", "/dev/stdout", "/dev/fd/1":
            piped = run_bytes(tool, command, "-o", name, "--format", form)
            tap.equal((piped.returncode, piped.stderr), (0, b""), "luxel %s -o %s --format %s" % (command, name, form))
            tap.ok(piped.stdout.startswith(start) and piped.stdout == tool.read("file." + form),
                   "is the file, and nothing else")
    tap.equal(run_bytes(tool, "profile", "-o", "-").stdout, tool.read("file.csv") and
              run_bytes(tool, "profile", "-o", "-", "--format", "csv").stdout, "a single format needs no name")
    grid = run_bytes(tool, "grid", "-s", GRIDS, "-o", "-")
    tap.ok(grid.stdout.startswith(b"grid,column,row"), "luxel grid -o -", grid.stdout[:100])
    variant = run_bytes(tool, "variant", "3", "-o", "-")
    tap.equal(variant.stdout, tool.run("variant", "3").out.encode(), "luxel variant -o -")
    explained = run_bytes(tool, "explain", "-p", "0,0", "-o", "-", "--format", "markdown")
    tap.equal(explained.stdout.decode(), tool.run("explain", "-p", "0,0", "--format", "markdown").out,
              "luxel explain -o -")
    both = run_bytes(tool, "render", "-o", "both.png", "-o", "-", "--format", "npy")
    tap.ok(both.stdout.startswith(b"\x93NUMPY") and os.path.exists(tool.file("both.png")), "beside a file", both.stderr)


def a_shells_files(tap, tool):
    with open(tool.file("out.npy"), "wb") as out:
        subprocess.run([tool.path, "render", "-o", "-", "--format", "npy"], cwd=tool.folder, stdout=out, check=True)
    tool.run("render", "-o", "file.npy")
    tap.equal(tool.read("out.npy"), tool.read("file.npy"), "redirected to a file")
    with open(tool.file("log.csv"), "ab") as out:
        out.write(b"first\n")
        out.flush()
        subprocess.run([tool.path, "profile", "-o", "/dev/stdout"], cwd=tool.folder, stdout=out, check=True)
    tap.ok(tool.read("log.csv").startswith(b"first\ndistance_mm"), "appended to a file", tool.read("log.csv")[:40])


def refusals(tap, tool):
    for arguments, said in ((["render", "-o", "-"], "png, npy, pfm, csv, exr"),
                            (["render", "-o", "/dev/stdout"], "--format NAME"),
                            (["render", "-o", "-", "--format", "npyy"], "expected one of png, npy, pfm, csv, exr"),
                            (["render", "-o", "-", "--format", "svg"], "expected one of"),
                            (["render", "--format", "png"], "-o -"),
                            (["render", "-o", "a.png", "--format", "png"], "-o -"),
                            (["render", "-o", "-", "--format", "png", "--json"], "--json"),
                            (["profile", "-o", "-", "--csv"], "--csv"),
                            (["render", "-o", "-", "-o", "/dev/stdout", "--format", "png"], "same file")):
        result = tool.run(*arguments)
        tap.ok(result.code == 2 and said in result.err and result.out == "", "luxel " + " ".join(arguments), result)
    terminal, end = pty.openpty()
    result = tool.run("render", "-o", "-", "--format", "png", stdout=end)
    os.close(end)
    os.close(terminal)
    tap.ok(result.code == 2 and "terminal" in result.err, "a terminal is not sent a .png", result)


def readers_who_leave(tap, tool):
    for arguments in (["probe", "--json"], ["render", "-o", "-", "--format", "npy"],
                      ["render", "-o", "-", "--format", "csv"],
                      ["profile", "-o", "-"], ["scene"]):
        reading, writing = os.pipe()
        os.close(reading)
        result = tool.run(*arguments, stdout=writing)
        os.close(writing)
        tap.equal((result.code, result.err), (0, ""), "a reader left: luxel " + " ".join(arguments))
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = tool.run("render", "-o", "-", "--format", "npy", stdout=full)
    tap.ok(result.code == 4 and "space" in result.err, "a full disk is an error all the same", result)


def quiet(tap, tool):
    for command in ["render"], ["grid", "-s", GRIDS], ["profile"], ["isophotes"], ["compare", "report", "report"]:
        out = "q.png" if command[0] in ("render", "compare") else "q.csv"
        result = tool.run(*command, "-o", out, "-q")
        tap.ok((result.out, result.err) == ("", "") and os.path.exists(tool.file(out)), "-q -o: " + command[0], result)
        tap.ok(tool.run(*command, "-q").out != "", "-q alone still answers: " + command[0])
        os.remove(tool.file(out))
    tap.ok(tool.run("render", "-o", "q.png", "-q", "--json").json()["max"], "-q --json prints what it was asked for")


def places_first(tap, tool):
    for command in ["render"], ["grid", "-s", GRIDS], ["profile"], ["set", "report", "screen.sampling=centers"]:
        result = tool.run(*command, "-o", "gone/a." + ("csv" if command[0] in ("grid", "profile") else
                                                      "png" if command[0] == "render" else "yaml"))
        tap.ok(result.code == 4 and result.out == "" and "gone/a." in result.err,
               "no such folder: " + command[0], result)


def every_json(tap, tool):
    tool.write("s.yaml", SCENE)
    tool.write("a.csv", "student,variant,point,value\nA,17,1,4.53\n")
    tool.run("render", "-o", "a.npy")
    for arguments in (["render"], ["probe"], ["explain", "-p", "0,0"], ["grid", "-s", GRIDS], ["stats"], ["profile"],
                      ["isophotes"], ["compare", "a.npy", "report"], ["check"], ["advise"], ["variant", "3"],
                      ["grade", "a.csv"], ["scene"], ["scene", "--list"], ["schema"],
                      ["set", "s.yaml", "observer.z=1501"],
                      ["set", "report", "observer.z=1501"], ["set", "s.yaml", "observer.z=1502", "-o", "t.yaml"],
                      ["set", "s.yaml", "observer.z=1502", "--dry-run"], ["help"], ["help", "radius"],
                      ["help", "render"], ["help", "lux"], ["help", "options"]):
        result = tool.run(*arguments, "--json")
        try:
            answer = json.loads(result.out)
        except ValueError:
            answer = None
        tap.ok(isinstance(answer, dict), "--json is one object: luxel " + " ".join(arguments), result)
    for files, what in (["s.yaml"], "the file that was changed"), ([], "and none where it stayed as it is"):
        tap.equal(tool.run("set", "s.yaml", "observer.z=1503", "--json").json(), {"files": files}, what)
    figure = tool.run("figure", "-o", "f.svg", "-o", "f.png", "--json")
    if "luxel-draw" in figure.err:
        tap.skip("--json of figures", "built without them")
        return
    tap.equal(figure.json(), {"files": ["f.svg", "f.png"]}, "luxel figure --json")
    tap.equal(tool.run("report", "-o", "r.md", "--json").json(), {"files": ["r.md"]}, "luxel report --json")
    tap.ok(tool.run("figure", "--palettes", "--json").json()["palettes"][0]["name"], "luxel figure --palettes --json")
    svg = run_bytes(tool, "figure", "-o", "-", "--format", "svg")
    tap.ok(svg.stdout == tool.read("f.svg") and svg.stderr == b"", "luxel figure -o - --format svg", svg.stderr)
    report = run_bytes(tool, "report", "-o", "-", "--format", "md")
    tap.equal(report.stdout, tool.read("r.md"), "luxel report -o - --format md")


run_tests(Tap(), the_file_itself, a_shells_files, refusals, readers_who_leave, quiet, places_first, every_json)
