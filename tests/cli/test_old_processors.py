# SPDX-License-Identifier: MIT
"""Old processors, by an emulator: the tool picks the instruction set that they have, uses no other instruction, and
makes the same bytes as that set does here."""
import emulator
from tap import Tap
from tool import run_tests

PROCESSORS = (("core2duo", "x86-64"), ("Nehalem", "x86-64"), ("Haswell", "x86-64-v3"))
SCENES = {"report": "[40,40]", "spot": "[40,40]", "three-lights": "[50,40]", "two-spheres": "[50,40]",
          "window": "[40,40]", "ball-lamp": "[40,40]"}


def emulated(tool, processor, *arguments):
    return emulator.run(processor, tool.path, *arguments, timeout=250, environment={"LC_ALL": "C.UTF-8"},
                        folder=tool.folder)


def old_processors(tap, tool):
    if emulator.why_not():
        tap.skip("old processors", emulator.why_not())
        return
    for processor, expected in PROCESSORS:
        version = emulated(tool, processor, "--version")
        tap.ok(version.returncode == 0 and version.stdout.decode().rstrip().endswith(": " + expected),
               "%s has %s" % (processor, expected), version)
        for scene, resolution in SCENES.items():
            arguments = ["render", scene, "-q", "-s", "screen.resolution=" + resolution, "-o"]
            run = emulated(tool, processor, *arguments, "old.npy")
            tap.ok(run.returncode == 0, "%s: %s" % (processor, scene), run)
            here = tool.run(*arguments, "here.npy", environment={"LUXEL_ISA": expected})
            if here.code == 0:
                tap.ok(tool.read("old.npy") == tool.read("here.npy"), "%s: the same bytes: %s" % (processor, scene))


run_tests(Tap(), old_processors)
