# SPDX-License-Identifier: MIT
"""Pictures that do not fit in memory: they are written all the same, and what needs all of them says so."""
import os
import resource

import numpy as np

from luxel import read_pfm
from tap import Tap
from tool import run_tests

SIZE = "screen.resolution=[4000, 4000]"
FIELD = 4000 * 4000 * 5  # bytes: a float32 and a byte of the mask for each pixel
LIMIT = FIELD - (8 << 20)  # of all memory


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (LIMIT, LIMIT))


def is_sanitized(tap):
    if os.environ.get("LUXEL_SANITIZED"):
        tap.skip("an address limit", "sanitizers need more")
        return True
    return False


def memory_is_bounded(tap, tool):
    if is_sanitized(tap):
        return
    outputs = [part for name in ("a.npy", "a.pfm", "a.exr", "a.png") for part in ("-o", name)]
    result = tool.run("render", "-s", SIZE, "-s", "picture.range=[0, 12]", "--threads", "2", "--json", *outputs,
                      preexec_fn=limited)
    tap.equal((result.code, result.err, tool.files()), (0, "", ["a.exr", "a.npy", "a.pfm", "a.png"]),
              "four files of a picture larger than memory")
    values, answer = np.load(tool.file("a.npy"), mmap_mode="r"), result.json()
    column, row = answer["max"]["pixel"]
    tap.equal((values.shape, float(values.max()), float(values[row, column])),
              ((4000, 4000),) + (answer["max"]["value"],) * 2, "its maximum")
    lit = values[values >= np.float32(1.2e-38)]
    tap.near(answer["mean"], float(lit.mean(dtype=float)) * answer["lit"], 1e-12, "its mean")
    for point in answer["points"]:
        column, row = point["pixel"]
        tap.equal(point["pixel_value"], float(values[row, column]), "its value at %r" % point["screen"])
    tap.ok(np.array_equal(read_pfm(tool.file("a.pfm")), values), "the other order of rows")
    os.remove(tool.file("a.exr"))
    for arguments in (["stats", "a.npy"], ["stats", "-s", SIZE]):
        result = tool.run(*arguments, preexec_fn=limited)
        tap.ok(result.code == 3 and "4000 x 4000" in result.err and "GB" in result.err,
               "what needs all of it says how much: " + arguments[-1], result)


def pipes(tap, tool):
    """A pipe takes no rows out of order and keeps nothing: what needs that is held in memory."""
    for name in "a.pfm", "a.png", "a.npy", "a.csv":
        size = SIZE if name != "a.csv" else "screen.resolution=[300, 300]"
        tool.run("render", "-s", size, "-o", name)
        expected = tool.read(name)
        os.remove(tool.file(name))
        os.mkfifo(tool.file(name))
        child = os.fork()
        if child == 0:
            os._exit(tool.run("render", "-s", size, "-o", name).code)
        found = tool.read(name)
        tap.equal(os.waitpid(child, 0)[1], 0, name + " to a pipe")
        tap.ok(found == expected, "the same bytes")


def full_disk(tap, tool):
    """A .png whose grey levels wait is kept in a larger file meanwhile, for which there may be no room."""
    most = 16 << 20

    def little_room():
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

    tool.write("a.png", "old")
    result = tool.run("render", "-s", "screen.resolution=[5500, 5500]", "-o", "a.png", "--json", preexec_fn=little_room)
    tap.ok(result.code == 4 and "a.png" in result.err and result.err.count("error") == 1, "it is told", result)
    tap.equal((tool.read("a.png"), tool.files()), (b"old", ["a.png"]), "the old file stays, and nothing else")
    tap.equal(result.json()["resolution"], [5500, 5500], "the numbers are printed")


def values_of_points(tap, tool):
    """What a point says of its pixel is what stands there."""
    for scene in "three-lights", "window", "ball-lamp":
        for precision in "single", "double":
            answer = tool.run("render", scene, "--precision", precision, "-o", "a.npy", "--json").json()
            values = np.load(tool.file("a.npy"))
            for point in answer["points"]:
                if point["pixel"] and point["on_surface"]:
                    column, row = point["pixel"]
                    tap.equal(point["pixel_value"], float(values[row, column]), "%s, %s" % (scene, precision))


run_tests(Tap(), memory_is_bounded, pipes, full_disk, values_of_points)
