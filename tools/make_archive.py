#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the static library that is installed: make_archive.py OUTPUT ARCHIVE OBJCOPY AR -- COMPILER...

All objects of ARCHIVE are linked into one, in which names of hidden visibility become local.  So the archive links
alone, a program that has an lx_ name of its own does not collide with ours, and no shared library shows them on.
"""
import os
import subprocess
import sys
import tempfile


def main():
    output, archive, objcopy, ar, separator, *compiler = sys.argv[1:]
    if separator != "--" or not compiler:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory(dir=os.path.dirname(os.path.abspath(output))) as folder:
        joined = os.path.join(folder, "luxel.o")
        subprocess.run([*compiler, "-r", "-nostdlib", "-Wl,--whole-archive", archive, "-Wl,--no-whole-archive",
                        "-o", joined], check=True)
        subprocess.run([objcopy, "--localize-hidden", joined], check=True)
        made = os.path.join(folder, "made.a")
        subprocess.run([ar, "rcsD", made, joined], check=True)
        os.replace(made, output)


main()
