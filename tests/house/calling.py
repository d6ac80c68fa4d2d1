# SPDX-License-Identifier: MIT
"""Programs called by tests of the house."""
import subprocess


def call(*arguments, **options):
    return subprocess.run([str(a) for a in arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          errors="replace", **options)
