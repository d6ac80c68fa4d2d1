# SPDX-License-Identifier: MIT
"""Tests of the kernels as a machine without AVX-512 runs them, and one without AVX2: the instruction sets that it lacks
are left out, and what remains is tested as thoroughly.

Arguments: the program of the unit tests, and those of other tests that need no argument.
"""
import os
import sys

import emulator
from tap import Tap

PROCESSORS = ("Haswell", "Nehalem")
# Unit tests, and how many of their random scenes are tried, in per cent, as an emulator takes some 20 times as long.
CAMPAIGN = {"kernels": "3", "panels": "40"}


def emulated(tap, processor, name, *command):
    run = emulator.run(processor, *command, timeout=400,
                       environment={"LUXEL_CAMPAIGN": CAMPAIGN.get(name, "3"), "CMOCKA_MESSAGE_OUTPUT": "TAP"})
    tap.ok(run.returncode == 0, "%s: %s" % (processor, name), run.stdout.decode(),
           run.stderr.decode())


def main():
    tap = Tap()
    if emulator.why_not():
        tap.skip("kernels of old processors", emulator.why_not())
    else:
        for processor in PROCESSORS:
            for name in CAMPAIGN:
                # Panels take longest; whatever has AVX2 and no AVX-512 runs them as Haswell would.
                if (processor, name) != ("Haswell", "panels"):
                    tap.run(emulated, tap, processor, name, sys.argv[1], name)
            for program in sys.argv[2:]:
                tap.run(emulated, tap, processor, os.path.basename(program), program)
    tap.finish()


main()
