# SPDX-License-Identifier: MIT
"""Tests of the kernels as a machine without AVX-512 runs them, and one without AVX2: the instruction sets that it lacks
are left out, and what remains is tested as thoroughly.

Arguments: the programs of these tests.
"""
import os
import sys

import emulator
from tap import Tap

PROCESSORS = ("Haswell", "Nehalem")
# How many of a program's random scenes are tried, in per cent, as an emulator takes some 20 times as long.
CAMPAIGN = {"test_kernels": "3", "test_panels": "40"}


def emulated(tap, processor, program):
    name = os.path.basename(program)
    run = emulator.run(processor, program, timeout=400,
                       environment={"LUXEL_CAMPAIGN": CAMPAIGN.get(name, "3"), "CMOCKA_MESSAGE_OUTPUT": "TAP"})
    tap.ok(run.returncode == 0, "%s: %s" % (processor, name), run.stdout.decode(),
           run.stderr.decode())


def main():
    tap = Tap()
    if emulator.why_not():
        tap.skip("kernels of old processors", emulator.why_not())
    else:
        for processor in PROCESSORS:
            for program in sys.argv[1:]:
                # Panels take longest; whatever has AVX2 and no AVX-512 runs them as Haswell would.
                if (processor, os.path.basename(program)) != ("Haswell", "test_panels"):
                    tap.run(emulated, tap, processor, program)
    tap.finish()


main()
