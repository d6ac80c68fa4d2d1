# SPDX-License-Identifier: MIT
"""The command under valgrind: every built-in scene, format and command once, small, and what it refuses.

    under_valgrind.py LUXEL VALGRIND [its options]      # part of make check-valgrind; too slow for make check

A case fails where valgrind finds an access, a value or a leak, or where the exit code is not the one that is due.
"""
import os
import shutil
import sys

import malformed
from tap import Tap
from tool import SCENE, run_tests

LUXEL = os.path.abspath(sys.argv[1])
VALGRIND = [*sys.argv[3:], "--trace-children=yes", LUXEL]  # luxel hands over to luxel-draw
SMALL = ["-q", "-s", "screen={width: 800, height: 800, resolution: [10, 10]}"]
EVERY = 8  # of the malformed scenes, whose whole list the fuzz target goes through

TABLE = "variant,point,value,student\n5,1,2.5,Ann\n5,2,off,\n5,P3,0,\"B, C\"\n5,x,1,\n"
CLOUD = "x;y;z;intensity\n0;0;2000;5\n100;50;1900;0\n"
BODY = ("OFF\n4 4 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
# Its plate ends within a tile: some rows of that show it in every pixel, others nowhere.
PLATE = ("luxel: 1\nscreen: {width: 64, height: 64, resolution: [64, 64]}\nobserver: {z: 500}\n"
         "surfaces: [{type: rectangle, center: [0, 0, 0], size: [200, 59]}]\n"
         "lights: [{type: planar, rectangle: {center: [0, 0, 300], size: [50, 50]}, radiance: 9, parts: 24}]\n")


def check(tap, tool, code, *arguments, stdin=""):
    result = tool.run(*VALGRIND, *arguments, stdin=stdin, timeout=600)
    tap.ok(result.code == code, " ".join(arguments), result)


def scenes(tap, tool):
    listed = tool.run(*VALGRIND, "scene", "--list").out.split("\n")
    for name in [line.split()[0] for line in listed if line.strip()]:
        check(tap, tool, 0, "render", name, *SMALL, "--threads", "2", "-o", name + ".png")
        check(tap, tool, 0, "probe", name, *SMALL, "-p", "0,0", "-p", "100,50", "--tolerance", "1e-4", "--json")


def panels(tap, tool):
    for name, side in ("report", 640), ("spot", 640), ("window", 300):
        check(tap, tool, 0, "render", name, "-q", "-s", "screen.resolution=[%d,%d]" % (side, side), "-o", "large.npy")


def formats(tap, tool):
    for ending in "png", "npy", "pfm", "csv", "exr":
        for precision in "single", "double":
            check(tap, tool, 0, "render", *SMALL, "--precision", precision, "-o", "%s.%s" % (precision, ending))
    check(tap, tool, 0, "render", *SMALL, "--bits", "16", "-o", "fine.png")
    check(tap, tool, 0, "render", "single.exr", "-q", "-o", "again.png")
    check(tap, tool, 0, "check", "single.png")
    for ending in "npy", "pfm", "csv", "exr":
        check(tap, tool, 0, "compare", "single." + ending, "single." + ending, "--json")
        check(tap, tool, 0, "stats", "single." + ending, "--histogram")
    tool.write("lamps.csv", CLOUD)
    tool.write("body.off", BODY)
    check(tap, tool, 0, "render", *SMALL, "-s", "lights=[{type: points, file: lamps.csv}]", "-o", "a.png")
    check(tap, tool, 0, "probe", *SMALL, "-s", "lights=[{type: volume, mesh: body.off, power: 3}]")


def commands(tap, tool):
    tool.write("table.csv", TABLE)
    tool.write("scene.yaml", SCENE)
    for code, line in (
            (0, "probe report --at 0,0,1300,0,0,1 --at 1,2,3,0,0,1 -p 0,0 -p 999,999"), (0, "explain report -p 0,0"),
            (0, "explain spot --format latex"), (0, "stats two-spheres"), (0, "isophotes report --levels 3"),
            (0, "profile report --from -100,0 --to 100,50 --arc --samples 9"), (0, "grid desk -o grid.csv"),
            (0, "figure report -o a.svg --section --dark"), (0, "figure two-spheres -o a.pdf --bands"),
            (0, "figure report -o a.png --log"), (0, "report report -o a.pdf"), (0, "check window"), (0, "advise spot"),
            (0, "variant 7 -o seven.yaml"), (4, "grade table.csv --json"), (0, "schema"), (0, "help shininess"),
            (0, "set scene.yaml lights[0].intensity=20 shadows=none points=[[1,2]]"),
            (2, "set scene.yaml lights[0].intensty=20"), (3, "set scene.yaml lights[0].intensity=x")):
        small = SMALL if line.split()[0] in ("stats", "isophotes", "figure", "report") else []
        check(tap, tool, code, *line.split(), *small)


def clusters(tap, tool):
    tool.write("plate.yaml", PLATE)
    check(tap, tool, 0, "render", "plate.yaml", "-q", "--light-error", "0.01")


def refusals(tap, tool):
    for title, piece, replacement, _ in malformed.PIECES[::EVERY]:
        name = tool.write("scene.yaml", SCENE.replace(piece, replacement.replace("^", ""), 1))
        check(tap, tool, 3, "check", name)
        tap.note(title)
    for name, content in (("a.exr", b"v/1\1\2\0\0\0"), ("a.npy", b"\x93NUMPY\1\0\xff\xff"), ("a.csv", b"x,y\n1,\xff")):
        check(tap, tool, 4, "stats", tool.write(name, content))
    check(tap, tool, 3, "render", "-", stdin="\x00")
    check(tap, tool, 4, "render", "gone.yaml")
    check(tap, tool, 4, "render", *SMALL, "-o", "gone/a.png")
    for line in "probe -p 1;2", "rendr", "render --tolerance 0", "render --outpt a", "probe --at 1,2,3,0,0,0", "-x":
        check(tap, tool, 2, *line.split())


sys.argv[1] = shutil.which(sys.argv[2])  # what the tool of the tests starts
run_tests(Tap(), scenes, panels, formats, commands, clusters, refusals)
