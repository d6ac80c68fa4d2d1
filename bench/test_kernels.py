# SPDX-License-Identifier: MIT
"""time_kernels: that it measures every instruction set that runs here, each kind of source and every pixel.

Times depend on the machine: they must be positive and agree with each other, no more.
"""
import os

from tap import Tap
from tool import run_tests


def best_set(tool):
    """The best instruction set that runs here."""
    return tool.run("1", environment={"LUXEL_ISA": ""}, timeout=300).json()["machine"]["instruction_sets"][0]["name"]


def every_case(tap, tool):
    result = tool.run("1", timeout=300)
    made = result.json()
    tap.equal((result.code, result.err), (0, ""), "it ends well")
    sets = [each["name"] for each in made["machine"]["instruction_sets"]]
    tap.ok(len(sets) > 1 or os.uname().machine != "x86_64", "every set that runs here", sets)
    tap.ok(made["machine"]["copied_bytes_per_second"] > 0, "the memory too")
    cases = {(each["case"], each["instruction_set"]): each for each in made["timings"]}
    names = {name for name, _ in cases}
    tap.equal(set(cases), {(name, each) for name in names for each in sets}, "each case with each set")
    tap.ok({"point", "one-point", "spot", "distant", "rectangle", "disk", "box", "ball", "tube"} <= names,
           "kinds of sources", sorted(names))
    laws = {"point-none", "point", "point-practical", "point-polynomial"}
    tap.ok(laws <= names, "every law of attenuation", sorted(laws - names))
    for (name, each_set), each in cases.items():
        pixels = 6000 * 60 if name == "point-by-pixel" else 800 * 800
        tap.equal(each["pixels"], pixels, "every pixel shows the sphere: %s, %s" % (name, each_set))
        count = 65536 if name == "many-points" else 16 if name.startswith(("point", "spot", "distant")) else 1
        tap.equal(each["lights"], count, "lights: " + name)
        alone_ms = each["one_thread_ms"]
        tap.ok(alone_ms > 0 and alone_ms == each["all_threads_ms"], "one thread: " + name, each)
        tap.near(each["one_thread_ns"], 1e6 * alone_ms / pixels / count, 1e-12, "ns of ms: " + name)
    point = cases["point", sets[0]]
    tap.near(point["times_floor"], point["one_thread_ns"] / point["floor_ns"], 1e-12, "times the floor")
    tap.equal(cases["rectangle", sets[0]]["times_floor"], None, "no floor that nobody counted")


def one_set(tap, tool):
    best = best_set(tool)
    for name in [best] + ([best[-2:]] if best.startswith("x86-64-v") else []):
        made = tool.run("1", environment={"LUXEL_ISA": name}, timeout=300).json()
        tap.equal({each["instruction_set"] for each in made["timings"]}, {best}, "LUXEL_ISA=" + name)


def refused(tap, tool):
    tap.equal(tool.run("1", "2").code, 2, "what it does not know")
    tap.equal(tool.run("1", environment={"LUXEL_ISA": "z80"}).code, 2, "a set that there is not")
    tap.ok(not os.listdir(tool.folder), "nothing was written", os.listdir(tool.folder))


run_tests(Tap(), every_case, one_set, refused)
