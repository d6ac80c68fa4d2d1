# SPDX-License-Identifier: MIT
"""luxel bench: that it measures every instruction set that runs here, and says so as text and as JSON.

Times depend on the machine: they must be positive and agree with each other, no more.
"""
import os

from tap import Tap
from tool import run_tests

SMALL = ("-s", "screen.resolution=[40,40]")


def sets_here(tool):
    """The instruction sets that the version lists, by asking for each."""
    names = ["x86-64-v4", "x86-64-v3", "x86-64"] if os.uname().machine == "x86_64" else ["generic"]
    return [name for name in names if tool.run("render", *SMALL, environment={"LUXEL_ISA": name}).code == 0]


def one_scene(tap, tool):
    expected = sets_here(tool)
    result = tool.run("bench", "three-lights", "-s", "screen.resolution=[50,40]", "--json")
    made = result.json()
    tap.equal((result.code, result.err), (0, ""), "a scene")
    tap.equal([each["name"] for each in made["machine"]["instruction_sets"]], expected, "every set that runs here")
    tap.equal([each["instruction_set"] for each in made["timings"]], expected, "each is measured")
    tap.ok(made["machine"]["copied_bytes_per_second"] > 0, "the memory too")
    for each in made["timings"]:
        tap.equal((each["case"], each["lights"]), ("three-lights", 3), "the scene and its lights")
        tap.ok(0 < each["pixels"] <= 2000 and each["one_thread_ms"] > 0 and each["all_threads_ms"] > 0, "times", each)
        tap.near(each["one_thread_ns"], 1e6 * each["one_thread_ms"] / each["pixels"] / 3, 1e-12, "ns of ms")
        tap.equal((each["floor_ns"], each["times_floor"]), (None, None), "no floor of any scene")
    text = tool.run("bench", "three-lights", "-s", "screen.resolution=[50,40]")
    tap.ok(text.code == 0 and all(name in text.out for name in expected + ["three-lights"]), "as text", text)


def its_own_cases(tap, tool):
    best = sets_here(tool)[0]
    result = tool.run("bench", "--json", environment={"LUXEL_ISA": best}, timeout=300)
    made = result.json()["timings"]
    tap.equal({each["instruction_set"] for each in made}, {best}, "LUXEL_ISA forces one")
    if best.startswith("x86-64-v"):
        short = tool.run("bench", "report", "--json", *SMALL, environment={"LUXEL_ISA": best[-2:]}).json()
        tap.equal({each["instruction_set"] for each in short["timings"]}, {best}, "by its short name")
    cases = {each["case"]: each for each in made}
    tap.ok(len(cases) == len(made) and {"point", "one-point", "spot", "distant", "rectangle", "tube"} <= set(cases),
           "kinds of sources", sorted(cases))
    laws = {"point-none", "point", "point-practical", "point-polynomial"}
    tap.ok(laws <= set(cases), "every law of attenuation", sorted(laws - set(cases)))
    for name, each in cases.items():
        pixels = 6000 * 60 if name == "point-by-pixel" else 800 * 800
        tap.equal(each["pixels"], pixels, "every pixel shows the sphere: " + name)
        count = 65536 if name == "many-points" else 16 if name.startswith(("point", "spot", "distant")) else 1
        tap.equal(each["lights"], count, "lights: " + name)
    point = cases["point"]
    tap.near(point["times_floor"], point["one_thread_ns"] / point["floor_ns"], 1e-12, "times the floor")


def one_thread(tap, tool):
    made = tool.run("bench", "report", "--threads", "1", "--json", *SMALL).json()
    tap.ok(made["threads"] == 1 and all(each["one_thread_ms"] == each["all_threads_ms"] for each in made["timings"]),
           "--threads 1 measures once", made)


def nothing_to_see(tap, tool):
    result = tool.run("bench", "report", "--json", "-s", "surfaces[0].center=[9000,0,1000]", *SMALL)
    tap.ok(result.code == 0 and all(each["pixels"] == 0 and each["one_thread_ns"] is None
                                    for each in result.json()["timings"]), "no pixel shows a surface", result)
    dark = tool.run("bench", "report", "-s", "lights=[]", *SMALL)
    tap.ok(dark.code == 0 and "nan" not in dark.out and "inf" not in dark.out, "no light", dark)


def refused(tap, tool):
    tap.equal(tool.run("bench", "nothing.yaml").code, 4, "a file that is not there")
    tap.equal(tool.run("bench", "-s", "lights[0].intensity=-1").code, 3, "a scene with errors")
    tap.equal(tool.run("bench", "-o", "a.png").code, 2, "it writes no file")
    tap.equal(tool.run("bench", "report", environment={"LUXEL_ISA": "z80"}).code, 2, "a set that there is not")
    tap.ok(not os.listdir(tool.folder), "nothing was written", os.listdir(tool.folder))


run_tests(Tap(), one_scene, its_own_cases, one_thread, nothing_to_see, refused)
