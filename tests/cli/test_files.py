# SPDX-License-Identifier: MIT
"""What render writes: the right values in the right places, whole files or none, the same bytes every time."""
import os
import stat

import numpy as np

from luxel import INSTRUCTION_SETS, read_pfm, read_png
from tap import Tap
from tool import SCENE, run_tests

# Nothing in it is symmetric: neither the sphere, nor the light, nor the picture's shape.
ASYMMETRIC = SCENE.replace("width: 500, height: 500, resolution: [36, 36]",
                           "width: 600, height: 400, resolution: [60, 40]")
ASYMMETRIC = ASYMMETRIC.replace("sampling: nodes", "sampling: centers").replace("center: [0, 0, 1000]",
                                                                                "center: [-130, 60, 1000]")
ASYMMETRIC = ASYMMETRIC.replace("radius: 200", "radius: 110").replace("[2000, 0, 2000]", "[-900, 1700, 2100]")


def surface_of_asymmetric():
    """Which pixels show its sphere."""
    y, x = np.mgrid[0:40, 0:60]
    return np.hypot(-300 + (x + 0.5) * 10 + 130, 200 - (y + 0.5) * 10 - 60) < 110


def rows_run_down(tap, tool):
    for sampling in "centers", "nodes":
        tool.write("scene.yaml", ASYMMETRIC.replace("centers", sampling))
        rendered = tool.run("render", "scene.yaml", "-o", "a.png", "-o", "a.npy", "-o", "a.pfm", "--json")
        tap.equal((rendered.code, tool.files()), (0, ["a.npy", "a.pfm", "a.png", "scene.yaml"]), "three files")
        values, answer = np.load(tool.file("a.npy")), rendered.json()
        tap.equal((values.shape, values.dtype.str), ((40, 60), "<f4"), "NPY: its shape and type")
        tap.ok(np.array_equal(read_pfm(tool.file("a.pfm")), values), "PFM has the values of NPY")
        grey = np.floor(255.0 * values.astype(float) / values.max())
        tap.ok(np.abs(read_png(tool.file("a.png")) - grey).max() <= 1, "PNG has their grey levels")
        tap.ok(values[:20].max() > 1.01 * values[20:].max(), "the light is above")
        column, row = answer["max"]["pixel"]
        tap.equal((values[row, column], row < 20, column < 30), (values.max(), True, True), "the maximum's pixel")
        lit = values[values >= np.float32(1.2e-38)]
        column, row = answer["min"]["pixel"]
        tap.equal((float(values[row, column]), answer["min"]["value"]), (float(lit.min()),) * 2, "the minimum's pixel")
        places = ["%r,%r" % (x, y) for x in (-205, -125, -65) for y in (5, 65, 135)]
        options = [part for place in places for part in ("-p", place)]
        for point in tool.run("probe", "scene.yaml", "--json", *options).json()["points"]:
            column, row = point["pixel"]
            tap.equal(point["pixel_value"], float(values[row, column]), "%s: point %r" % (sampling, point["screen"]))
            if sampling == "centers":
                tap.near(point["pixel_value"], point["value"], 0, "at its centre it is exact", 2e-6 * values.max())


def precisions(tap, tool):
    tool.write("scene.yaml", ASYMMETRIC)
    tool.run("render", "scene.yaml", "-o", "single.npy", "-o", "single.PFM")
    answer = tool.run("render", "scene.yaml", "--precision", "double", "-o", "double.npy", "-o", "a.pfm", "--json")
    single, double = np.load(tool.file("single.npy")), np.load(tool.file("double.npy"))
    tap.equal(double.dtype.str, "<f8", "NPY of double precision")
    tap.ok(np.abs(single - double).max() <= 2e-6 * double.max(), "single is near double")
    tap.ok(np.array_equal(read_pfm(tool.file("a.pfm")), double.astype(np.float32)), "PFM is rounded to float32")
    surface = surface_of_asymmetric()
    tap.near(answer.json()["mean"], double[surface].mean(), 1e-12, "mean")
    tap.near(answer.json()["lit"], (double[surface] >= 1.2e-38).mean(), 1e-12, "lit")
    tool.run("render", "scene.yaml", "--quantity", "irradiance", "-o", "e.npy")
    irradiance = np.load(tool.file("e.npy"))
    tap.near(float(irradiance.max()), 10.0, 0.01, "irradiance of a source without attenuation")


def grey_levels(tap, tool):
    """By each rule of `picture`, with 8 bits and with 16."""
    rules = {"{range: max, rounding: truncate}": lambda v, s, m: np.floor(np.clip(m * v / v.max(), 0, m)),
             "{range: max, rounding: nearest}": lambda v, s, m: np.floor(np.clip(m * v / v.max(), 0, m) + 0.5),
             "{range: [1, 4]}": lambda v, s, m: np.where(s, np.floor(np.clip(m * (v - 1) / 3, 0, m)), 0),
             "{range: minmax}": lambda v, s, m: np.where(s, np.floor(np.clip(
                 m * (v - v[s].min()) / (v[s].max() - v[s].min()), 0, m)), 0),
             "{range: log}": lambda v, s, m: np.floor(m * np.clip(1 + np.log10(
                 np.maximum(v, 1e-300) / v.max()) / 4, 0, 1))}
    surface = surface_of_asymmetric()
    for picture, rule in rules.items():
        tool.write("scene.yaml", ASYMMETRIC.replace("{range: max, rounding: truncate}", picture))
        for bits in 8, 16:
            result = tool.run("render", "scene.yaml", "--precision", "double", "-o", "a.npy", "-o", "a.png", "--bits",
                              str(bits))
            tap.equal((result.code, result.err), (0, ""), "--bits %d goes with other files, too" % bits)
            values, levels = np.load(tool.file("a.npy")), read_png(tool.file("a.png"))
            off = np.abs(levels.astype(int) - rule(values, surface, 2 ** bits - 1).astype(int))
            tap.ok(levels.itemsize == bits // 8 and off.max() <= 1 and np.count_nonzero(off) <= 5,
                   "picture: %s, %d bits" % (picture, bits), levels.dtype, off.max(), np.count_nonzero(off))


def sixteen_bits(tap, tool):
    """A .png of 16 bits is a SCENE as one of 8 bits is, and --bits is refused where it says nothing."""
    tool.write("scene.yaml", ASYMMETRIC)
    tool.run("render", "scene.yaml", "-o", "a.png", "-o", "b.PNG", "--bits", "16")
    tool.run("render", "scene.yaml", "-o", "c.png")
    tap.ok(tool.read("a.png") == tool.read("b.PNG"), "every .png is written so")
    tap.equal(tool.run("scene", "a.png").out, tool.run("scene", "c.png").out, "it carries the same scene")
    tool.run("render", "a.png", "-o", "d.png", "-o", "e.npy", "--bits=16")
    tap.ok(tool.read("d.png") == tool.read("a.png"), "and repeats itself")
    tool.run("render", "a.png", "-o", "f.png")
    tool.run("render", "c.png", "-o", "g.png", "--bits=8")
    tap.ok(tool.read("f.png") == tool.read("c.png") == tool.read("g.png"), "8 bits are the default")
    for arguments, words in ((["render", "--bits", "16"], "-o FILE.png"),
                             (["render", "--bits", "16", "-o", "n.npy"], "-o FILE.png"),
                             (["render", "--bits", "12", "-o", "n.png"], "one of 8, 16"),
                             (["figure", "--bits", "16", "-o", "n.png"], "luxel render takes it")):
        result = tool.run(*arguments)
        tap.ok(result.code == 2 and words in result.err and not os.path.exists(tool.file(arguments[-1])),
               "refused: " + " ".join(arguments), result)


def one_of_them_fails(tap, tool):
    result = tool.run("render", "-o", "a.png", "-o", "gone/b.npy", "-o", "c.pfm", "--json")
    tap.equal((result.code, tool.files()), (4, ["a.png", "c.pfm"]), "the others are written")
    tap.ok("gone/b.npy" in result.err and "a.png" not in result.err, "the message names the one", result)
    tap.equal(result.json()["resolution"], [360, 360], "the results are printed")
    os.mkdir(tool.file("folder.png"))
    tap.equal(tool.run("render", "-o", "folder.png").code, 4, "a folder cannot be written")
    os.symlink("/dev/full", tool.file("full.npy"))
    result = tool.run("render", "-o", "full.npy", "-o", "d.png")
    tap.equal((result.code, os.path.exists(tool.file("d.png"))), (4, True), "a full disk")
    tap.ok("full.npy" in result.err, "the message names it", result)


def old_files(tap, tool):
    tool.write("a.png", "old")
    os.chmod(tool.file("a.png"), 0o640)
    tap.equal(tool.run("render", "-o", "a.png", "-s", "screen.width=-1").code, 3, "a wrong scene")
    tap.equal(tool.read("a.png"), b"old", "leaves the old file")
    tap.equal(tool.run("render", "-o", "a.png").code, 0, "a good one")
    tap.ok(tool.read("a.png").startswith(b"\x89PNG"), "replaces it")
    tap.equal(stat.S_IMODE(os.stat(tool.file("a.png")).st_mode), 0o640, "with its permissions")
    tap.equal(tool.files(), ["a.png"], "and leaves nothing beside it")


def same_bytes(tap, tool):
    tool.write("scene.yaml", ASYMMETRIC.replace("[60, 40]", "[615, 410]"))
    names = ["a.png", "a.npy", "a.pfm"]
    options = [part for name in names for part in ("-o", name)]
    for precision in "single", "double":
        expected = None
        for threads in "1", "2", "7", "1", "64":
            result = tool.run("render", "scene.yaml", "--threads", threads, "--precision", precision, *options)
            tap.equal(result.code, 0, "%s threads, %s" % (threads, precision))
            found = [tool.read(name) for name in names]
            expected = expected or found
            tap.ok(found == expected, "the same bytes")


def instruction_sets(tap, tool):
    tool.write("scene.yaml", ASYMMETRIC)
    tool.run("render", "scene.yaml", "--precision", "double", "-o", "a.npy")
    exact, tried = np.load(tool.file("a.npy")), 0
    own = tool.run("--version").out.split("instruction set: ")[1].split()[0]  # all there is on other processors
    for name in dict.fromkeys([*INSTRUCTION_SETS, own]):
        environment = {"LUXEL_ISA": name}
        result = tool.run("render", "scene.yaml", "-o", "b.npy", "--threads", "2", environment=environment)
        if result.code == 2:
            tap.skip(name, "not of this machine")
            continue
        tried += 1
        error = np.abs(np.load(tool.file("b.npy")) - exact).max()
        tap.ok(result.code == 0 and error <= 2e-6 * exact.max(), name, error, result)
        bytes_of_two = tool.read("b.npy")
        tool.run("render", "scene.yaml", "-o", "b.npy", "--threads", "7", environment=environment)
        tap.ok(tool.read("b.npy") == bytes_of_two, name + ": the same bytes for another number of threads")
        version = tool.run("--version", environment=environment)
        tap.ok("instruction set: " + name in version.out, name + ": the version tells it", version)
    tap.ok(tried > 0, "an instruction set was tried")


run_tests(Tap(), rows_run_down, precisions, grey_levels, sixteen_bits, one_of_them_fails, old_files,
          same_bytes, instruction_sets)
