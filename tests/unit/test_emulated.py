# SPDX-License-Identifier: MIT
"""Tests of the kernels as a machine without AVX-512 runs them, and one without AVX2: the instruction sets that it lacks
are left out, and what remains is tested as thoroughly.

Arguments: the programs of these tests.
"""
import os
import platform
import shutil
import subprocess
import sys

from tap import Tap

EMULATOR = shutil.which("qemu-x86_64")
PROCESSORS = ("Haswell", "Nehalem")
SCENES = "70"  # of 250, as an emulator takes some 20 times as long


def emulated(tap, processor, program):
    environment = {**os.environ, "LUXEL_TEST_SCENES": SCENES, "CMOCKA_MESSAGE_OUTPUT": "TAP"}
    run = subprocess.run([EMULATOR, "-cpu", processor, program], env=environment, capture_output=True, timeout=400,
                         check=False)
    tap.ok(run.returncode == 0, "%s: %s" % (processor, os.path.basename(program)), run.stdout.decode(),
           run.stderr.decode())


def main():
    tap = Tap()
    if not EMULATOR or platform.machine() != "x86_64":
        tap.skip("kernels of old processors", "qemu-x86_64 is not here, or this is no such machine")
    elif os.environ.get("LUXEL_SANITIZED"):
        tap.skip("kernels of old processors", "sanitizers need all addresses for themselves")
    else:
        for processor in PROCESSORS:
            for program in sys.argv[1:]:
                tap.run(emulated, tap, processor, program)
    tap.finish()


main()
