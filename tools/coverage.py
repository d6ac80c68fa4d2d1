#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which lines and branches of the library the tests reached, as a table of the rooms.

    coverage.py BUILD_FOLDER [SOURCE...]

of a folder that was built with -Db_coverage=true and in which tests have run.  With sources (as
src/format/mesh/obj.c), just these, each in a line.  BUILD_FOLDER/coverage.json and, without sources, the pages in
BUILD_FOLDER/coverage/ show all.

The kernels are inlined for each kind and precision of each instruction set, and gcov counts a branch once for each
copy, most of them decided while compiling: of these files only the lines count.
"""
import json
import pathlib
import re
import subprocess
import sys

KERNELS = re.compile(r"src/(kernel/.*|world/kernel.*)")
ROOT = pathlib.Path(__file__).resolve().parent.parent


def measure(folder, sources):
    """gcovr's account of each file."""
    account = folder / "coverage.json"
    command = ["gcovr", "--root", ROOT, "--object-directory", folder, folder, "--json", account, "--json-summary",
               folder / "coverage-summary.json", "-j", "2"]
    for source in sources or ["src/"]:
        command += ["--filter", str(ROOT / re.escape(source))]
    if not sources:
        (folder / "coverage").mkdir(exist_ok=True)
        command += ["--html-details", folder / "coverage" / "index.html"]
    subprocess.run(command, check=True, cwd=ROOT)
    return json.loads((folder / "coverage-summary.json").read_text())["files"]


def row(name, files):
    branching = [file for file in files if not KERNELS.fullmatch(file["filename"])]
    lines, reached = (sum(file[what] for file in files) for what in ("line_total", "line_covered"))
    branches, taken = (sum(file[what] for file in branching) for what in ("branch_total", "branch_covered"))
    return "| %s | %d | %.1f %% | %d | %.1f %% |" % (
        name, lines, 100 * reached / max(lines, 1), branches, 100 * taken / max(branches, 1))


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    files = measure(folder, sys.argv[2:])
    groups = {}
    for file in files:
        name = file["filename"]
        groups.setdefault(name if sys.argv[2:] else "/".join(name.split("/")[:2]), []).append(file)
    print("| | lines | reached | branches | taken |\n|---|---|---|---|---|")
    for name, group in groups.items():
        print(row(name, group))
    print(row("all", files))


if __name__ == "__main__":
    main()
