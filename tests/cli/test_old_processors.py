# SPDX-License-Identifier: MIT
"""Old processors, by an emulator: the tool picks the instruction set that they have, uses no other instruction, and
makes the same bytes as that set does here."""
import os
import platform
import shutil
import subprocess

from tap import Tap
from tool import run_tests

EMULATOR = shutil.which("qemu-x86_64")
PROCESSORS = (("core2duo", "x86-64"), ("Nehalem", "x86-64"), ("Haswell", "x86-64-v3"))
SCENES = {"report": "[40,40]", "spot": "[40,40]", "three-lights": "[50,40]", "two-spheres": "[50,40]",
          "window": "[40,40]", "ball-lamp": "[40,40]"}


def emulated(tool, processor, *arguments):
    environment = {name: value for name, value in os.environ.items() if name != "LUXEL_ISA"}
    return subprocess.run([EMULATOR, "-cpu", processor, tool.path, *arguments], cwd=tool.folder, capture_output=True,
                          timeout=250, env={**environment, "LC_ALL": "C.UTF-8"}, check=False)


def old_processors(tap, tool):
    if not EMULATOR or platform.machine() != "x86_64":
        tap.skip("old processors", "qemu-x86_64 is not here, or this is no such machine")
        return
    if os.environ.get("LUXEL_SANITIZED"):
        tap.skip("old processors", "sanitizers need all addresses for themselves")
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
