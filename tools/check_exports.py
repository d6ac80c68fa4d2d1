# SPDX-License-Identifier: MIT
"""What the library shows and keeps: it exports exactly what its headers declare, and has no global state.

Arguments: the root, nm, the shared library, the static library, and "sanitized" where the compiler added
data of its own.
"""
import os
import re
import subprocess
import sys

from tap import Tap

DECLARATION = re.compile(r"\bLUXEL_API\b[^;{(]*?\b(\w+)\s*\(")


def declared(root):
    """The functions that the public headers mark as exported."""
    names = set()
    folder = os.path.join(root, "include", "luxel")
    for header in sorted(os.listdir(folder)):
        with open(os.path.join(folder, header), encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.DOTALL)
        text = re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)
        names.update(DECLARATION.findall(text))
    return names


def listing(nm, *arguments):
    return subprocess.run([nm, *arguments], capture_output=True, text=True, check=True).stdout


def exported(nm, library):
    """Names that other programs can link to; the version's own name is absolute (A)."""
    names = set()
    for line in listing(nm, "-D", "--defined-only", "--format=posix", library).splitlines():
        fields = line.split()
        if len(fields) >= 2 and fields[1] != "A":
            names.add(fields[0].split("@")[0])
    return names


def writable_data(nm, library):
    """Objects in sections that stay writable; constants with addresses in them are in .data.rel.ro."""
    found = []
    for line in listing(nm, "--defined-only", "--format=sysv", library).splitlines():
        fields = [field.strip() for field in line.split("|")]
        if len(fields) == 7 and re.match(r"\.(data|bss|tdata|tbss|ldata|lbss)(?!\.rel\.ro)", fields[6]):
            found.append("%s in %s" % (fields[0], fields[6]))
    return found


def main():
    root, nm, shared, static, kind = sys.argv[1:]
    tap = Tap()
    names, promised = exported(nm, shared), declared(root)

    foreign = sorted(name for name in names if not name.startswith("luxel_"))
    tap.ok(not foreign, "only luxel_ names are exported", *foreign)
    missing = sorted(promised - names)
    tap.ok(promised and not missing, "every function of the headers is exported", *missing)
    secret = sorted(name for name in names - promised if name.startswith("luxel_"))
    tap.ok(not secret, "every exported function is in a header", *secret)
    if kind == "sanitized":
        tap.skip("the library has no variable of its own", "sanitizers add data")
    else:
        state = writable_data(nm, static)
        tap.ok(not state, "the library has no variable of its own", *state)
    tap.finish()


main()
