# SPDX-License-Identifier: MIT
"""Each public header compiles alone, twice over, as C11 and as C++17, without a warning.

Arguments: the root, the folder of cairo's headers ("" where there are none), the C compiler's command, "--", and the
C++ compiler ("" where there is none).
"""
import os
import subprocess
import sys

from tap import Tap

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
NEED_CAIRO = ["drawing.h"]


def compile_alone(command, standard, language, folders, name):
    """Compiles a file that holds nothing but the include, twice; returns what the compiler says."""
    source = "#include <luxel/%s>\n" % name * 2
    run = subprocess.run(command + ["-x", language, "-std=" + standard, "-fsyntax-only"] + folders + WARNINGS + ["-"],
                         input=source, capture_output=True, text=True)
    return run.returncode, run.stderr


def main():
    root, cairo, rest = sys.argv[1], sys.argv[2], sys.argv[3:]
    split = rest.index("--")
    compilers = [(rest[:split], "c11", "c"), ([rest[split + 1]], "c++17", "c++")]
    headers = sorted(name for name in os.listdir(os.path.join(root, "include", "luxel")) if name.endswith(".h"))
    tap = Tap()

    for command, standard, language in compilers:
        if not command[0]:
            tap.skip("every public header compiles alone as " + standard, "no compiler")
            continue
        for name in headers:
            folders = ["-I" + os.path.join(root, "include")]
            if name in NEED_CAIRO and not cairo:
                tap.skip("<luxel/%s> compiles alone as %s" % (name, standard), "no cairo")
                continue
            if name in NEED_CAIRO:
                folders += ["-isystem", cairo]
            code, text = compile_alone(command, standard, language, folders, name)
            tap.ok(code == 0, "<luxel/%s> compiles alone as %s" % (name, standard), text)
    tap.finish()


main()
