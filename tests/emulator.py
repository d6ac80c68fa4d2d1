# SPDX-License-Identifier: MIT
"""Programs as old processors run them."""
import os
import platform
import shutil
import subprocess

EMULATOR = shutil.which("qemu-x86_64")


def why_not():
    """Why nothing can be emulated here; None where it can."""
    if not EMULATOR or platform.machine() != "x86_64":
        return "qemu-x86_64 is not here, or this is no such machine"
    if os.environ.get("LUXEL_SANITIZED"):
        return "sanitizers need all addresses for themselves"
    return None


def run(processor, program, *arguments, timeout, environment=None, folder=None):
    """A program on a processor that has this name in qemu, with these variables beside those here, but LUXEL_ISA."""
    variables = {name: value for name, value in os.environ.items() if name != "LUXEL_ISA"}
    return subprocess.run([EMULATOR, "-cpu", processor, program, *arguments], cwd=folder, capture_output=True,
                          timeout=timeout, env={**variables, **(environment or {})}, check=False)
