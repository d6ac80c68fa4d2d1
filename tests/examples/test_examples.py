# SPDX-License-Identifier: MIT
"""One example program, run as its comment says: arguments are the program and the root of the sources."""
import math
import os
import re
import subprocess
import sys
import tempfile

from tap import Tap

tap = Tap()


def run(program, *arguments, folder=None):
    return subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder, timeout=60)


def render_to_png(program, _):
    with tempfile.TemporaryDirectory() as folder:
        plain = run(program, "sphere.png", folder=folder)
        tap.equal((plain.returncode, plain.stderr), (0, ""), "the built-in scene is rendered")
        tap.equal(plain.stdout, "360 x 360 pixels\nmaximum 11.7475 W/sr in column 307, row 179\n", "its maximum")
        with open(os.path.join(folder, "sphere.png"), "rb") as file:
            tap.equal(file.read(8), b"\x89PNG\r\n\x1a\n", "the picture is a PNG")

        changed = run(program, "sphere.pfm", "lights[0].intensity=20", folder=folder)
        tap.equal(changed.stdout.splitlines()[1:], ["maximum 23.4951 W/sr in column 307, row 179"],
                  "twice the intensity, twice the maximum")
        with open(os.path.join(folder, "sphere.pfm"), "rb") as file:
            tap.equal(file.read(2), b"Pf", "another ending, another format")

        wrong = run(program, "no.png", "surfaces[0].radius=-1", "lights[0].intensity=bright", folder=folder)
        tap.equal(wrong.returncode, 1, "a wrong scene fails")
        tap.ok("radius" in wrong.stderr and "intensity" in wrong.stderr, "both errors are told at once", wrong.stderr)
        tap.ok(not os.path.exists(os.path.join(folder, "no.png")), "and nothing is written")
        tap.equal(run(program, "sphere.bmp", folder=folder).returncode, 1, "an unknown ending fails")
    tap.equal(run(program).returncode, 2, "without arguments it tells its usage")


def probe_points(program, root):
    report = run(program)
    values = re.findall(r"^\((\S+), (\S+)\) mm: (\S+) W/sr, error at most (\S+)$", report.stdout, re.MULTILINE)
    tap.equal([value[:2] for value in values], [("0", "0"), ("150", "0"), ("-150", "0")], "the three points")
    for (_, _, value, error), expected in zip(values, [2.7275906525546927, 11.0380150393, 1.12996602329e-07]):
        tap.near(float(value), expected, 1e-11, "the value %g" % expected)
        tap.ok(0 < float(error) <= 1e-12 * expected, "its bound is narrow", error)
    shares = re.findall(r"^    light (\d+) \((\w+)\): diffuse (\S+), highlight (\S+)$", report.stdout, re.MULTILINE)
    tap.equal([share[:2] for share in shares], [("0", "point")] * 3, "one light a point")
    for share, value in zip(shares, values):
        tap.near(float(share[2]) + float(share[3]), float(value[2]), 1e-8, "the shares add up to %s" % value[2])

    lights = run(program, os.path.join(root, "data", "scenes", "three-lights.yaml"))
    tap.equal(lights.returncode, 0, "a scene from a file")
    tap.ok("light 2 (" in lights.stdout, "has three lights", lights.stdout)
    missing = run(program, "/no/such/scene.yaml")
    tap.ok(missing.returncode == 1 and "scene.yaml" in missing.stderr, "a missing file is named", missing.stderr)


def probe_many(program, root):
    """Points of the screen against the sphere's own formula; elements of a table, an array and with a wrong row."""
    def brightness(x, y):
        n = [x / 300, y / 300, math.sqrt(1 - (x * x + y * y) / 9e4)]
        place = [x, y, 1000 + 300 * n[2]]
        towards = [a - b for a, b in zip((2000, 0, 2000), place)]
        length = math.sqrt(sum(a * a for a in towards))
        half = [a / length + b for a, b in zip(towards, (0, 0, 1))]
        size = math.sqrt(sum(a * a for a in half))
        cosine = sum(a * b for a, b in zip(n, towards)) / length
        return 10 * (0.8 * max(0, cosine) + 0.5 * max(0, sum(a * b for a, b in zip(n, half)) / size) ** 20)

    sides = [(i + 0.5) * 5 - 250 for i in range(100)]
    expected = [brightness(x, y) for x in sides for y in sides if x * x + y * y < 9e4]
    plain = run(program)
    form = (r"10000 places, (\d+) with a value\nmean (\S+) W/sr, errors at most (\S+)\n"
            r"greatest (\S+) W/sr at \((\S+), (\S+), (\S+)\) mm\n")
    found = re.fullmatch(form, plain.stdout)
    if tap.ok(plain.returncode == 0 and plain.stderr == "" and found, "ten thousand points", plain):
        tap.equal(int(found[1]), len(expected), "as many as lie on the sphere")
        tap.near(float(found[2]), sum(expected) / len(expected), 1e-8, "their mean")
        tap.near(float(found[4]), max(expected), 1e-11, "the greatest of them")
        tap.ok(float(found[3]) < 1e-12, "narrow bounds", found[3])
    with tempfile.TemporaryDirectory() as folder:
        scene, table = os.path.join(root, "data", "scenes", "three-lights.yaml"), os.path.join(folder, "places.csv")
        with open(table, "w", encoding="utf-8") as file:
            file.write("x;y;z;nx;ny;nz\n0;0;1300;0;0;1\n150;0;1259,8076;0,5;0;0,866\n")
        both = run(program, scene, table)
        tap.ok(both.returncode == 0 and "2 places, 2 with a value" in both.stdout, "elements of a table", both)
        with open(table, "a", encoding="utf-8") as file:
            file.write("1;2;3;4;5;much\n")
        wrong = run(program, scene, table)
        tap.ok(wrong.returncode == 1 and wrong.stdout == "" and "much" in wrong.stderr, "a wrong row", wrong)
    missing = run(program, scene, "/no/such/places.csv")
    tap.ok(missing.returncode == 1 and "places.csv" in missing.stderr, "a missing table is named", missing.stderr)


def compare_conventions(program, _):
    both = run(program)
    tap.equal((both.returncode, both.stderr), (0, ""), "both scenes are rendered")
    lines = both.stdout.splitlines()
    maxima = [re.fullmatch(r"observer\.view=(\w+): maximum (\S+) W/sr", line) for line in lines[:2]]
    if tap.ok(len(lines) == 3 and all(maxima), "two maxima and their difference", both.stdout):
        tap.equal([match.group(1) for match in maxima], ["parallel", "observer"], "in their order")
        tap.near(float(maxima[0].group(2)), 11.7475, 1e-5, "the report's maximum")
        tap.ok(abs(float(maxima[1].group(2)) - 11.7475) > 1e-3, "and another one", both.stdout)
    late = run(program, "-1")
    tap.equal(late.returncode, 1, "when the time is over it fails")
    tap.ok(re.fullmatch(r"(observer\.view=\w+: cancelled at \d+ %\n){2}", late.stdout), "both are cancelled",
           late.stdout)


def measure_plane(program, root):
    floor = run(program)
    form = r"(\d+) x \1 cells: average \S+, minimum \S+, maximum \S+ lx, U0 \S+, flux (\S+) lm"
    lines = [re.fullmatch(form, line) for line in floor.stdout.splitlines()]
    if tap.ok(floor.returncode == 0 and len(lines) > 2 and all(lines), "the floor is measured", floor):
        tap.equal([int(line[1]) for line in lines], [2 ** (i + 1) for i in range(len(lines))], "with finer cells")
        # The power from a Lambertian point on a square below it: I h^2 times the integral of 1/r^4.
        a, h = 2.0, 3.0
        root_of = math.sqrt(a * a + h * h)
        exact = 4000 * (a / root_of) * math.atan(a / root_of)
        tap.near(float(lines[-1][2]), exact, 2e-3, "the flux")
    missing = run(program, os.path.join(root, "data", "scenes", "report.yaml"))
    tap.ok(missing.returncode == 1 and "grids" in missing.stderr, "a scene without grids", missing.stderr)


def main():
    program, root = map(os.path.abspath, sys.argv[1:])
    name = os.path.basename(program)
    tap.run({"render_to_png": render_to_png, "probe_points": probe_points, "probe_many": probe_many,
             "measure_plane": measure_plane, "compare_conventions": compare_conventions}[name], program, root)
    tap.finish()


main()
