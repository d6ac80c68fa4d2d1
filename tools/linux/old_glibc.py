#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Libraries to link with, so that what is linked runs on systems with an older glibc: old_glibc.py FOLDER VERSION
[MACHINE ROOT], for this machine or by a cross compiler for aarch64, whose system is in ROOT.

For each of glibc's libraries FOLDER gets a stand-in without code, which has the symbols of that system's in the newest
version that VERSION, such as 2.28, had.  What became a function of its own later is in libold.a (old_glibc.c).
`-LFOLDER` puts them before the system's own.
"""
import collections
import os
import pathlib
import re
import subprocess
import sys

SYMBOL = re.compile(r"^[0-9a-f]+ .{6}(?P<kind>[FO ]) \S+\s+[0-9a-f]+\s+"
                    r"\(?GLIBC_(?P<version>[\d.]+)\)?\s+(?P<name>\w+)$", re.M)
# Since 2.34 libc has what these had; of programs that were linked earlier it has it in versions of then alone.
FORMER = {"libpthread.so.0": ("pthread_", "sem_"), "libdl.so.2": ("dl",)}


def number(version):
    return tuple(int(part) for part in version.split("."))


def symbols_of(tool, library, limit):
    """By name: kind and newest version up to the limit, and whether there is a newer one."""
    text = subprocess.run([tool + "objdump", "-T", library], check=True, capture_output=True, text=True).stdout
    found = collections.defaultdict(list)
    for symbol in SYMBOL.finditer(text):
        found[symbol["name"]].append((number(symbol["version"]), symbol["kind"], symbol["version"]))
    old = {}
    for name, versions in found.items():
        known = [each for each in versions if each[0] <= limit]
        if known:
            _, kind, version = max(known)
            old[name] = (kind, version, max(versions)[0] > limit)
    return old


def make_stand_in(tool, folder, soname, symbols):
    """An ELF library of these symbols: name, kind, version."""
    lines, nodes = [".text"], sorted({version for _, _, version in symbols}, key=number)
    for i, (name, kind, version) in enumerate(symbols):
        lines += [f".globl s{i}", f".type s{i}, %{'object' if kind == 'O' else 'function'}", f".size s{i}, 8",
                  f"s{i}: .quad 0", f".symver s{i}, {name}@@GLIBC_{version}, remove"]
    source, versions = folder / (soname + ".s"), folder / (soname + ".map")
    source.write_text("\n".join(lines) + "\n.section .note.GNU-stack\n", encoding="ascii")
    versions.write_text("".join(f"GLIBC_{version} {{}};\n" for version in nodes), encoding="ascii")
    subprocess.run([tool + "gcc", "-shared", "-nostdlib", f"-Wl,-soname,{soname}", f"-Wl,--version-script={versions}",
                    "-o", folder / soname, source], check=True)


def main(place, version, machine=None, root=""):
    folder = pathlib.Path(place).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    limit = number(version)
    tool = f"{machine}-linux-gnu-" if machine else ""
    library = pathlib.Path(f"{root}/lib/{machine or os.uname().machine}-linux-gnu")
    loader = next(library.glob("ld-linux*.so.*"))
    former = {soname: [] for soname in FORMER}
    own = []
    for name, (kind, found, has_newer) in sorted(symbols_of(tool, library / "libc.so.6", limit).items()):
        soname = next((soname for soname, starts in FORMER.items() if has_newer and name.startswith(starts)), None)
        (former[soname] if soname else own).append((name, kind, found))
    make_stand_in(tool, folder, "libc.so.6", own)
    for soname, symbols in former.items():
        make_stand_in(tool, folder, soname, symbols)
    maths = symbols_of(tool, library / "libm.so.6", limit)
    make_stand_in(tool, folder, "libm.so.6", [(name, kind, found) for name, (kind, found, _) in sorted(maths.items())])
    source = pathlib.Path(__file__).with_suffix(".c")
    subprocess.run([tool + "gcc", "-O2", "-fPIC", "-c", "-o", folder / "old.o", source], check=True)
    (folder / "libold.a").unlink(missing_ok=True)
    subprocess.run([tool + "ar", "-Drcs", folder / "libold.a", folder / "old.o"], check=True)
    needed = " ".join(str(folder / soname) for soname in former)
    (folder / "libc.so").write_text(f"GROUP({folder}/libold.a {folder}/libc.so.6 AS_NEEDED({needed} {loader}))\n",
                                    encoding="ascii")
    (folder / "libm.so").unlink(missing_ok=True)
    (folder / "libm.so").symlink_to("libm.so.6")


if __name__ == "__main__":
    main(*sys.argv[1:])
