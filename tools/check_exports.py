# SPDX-License-Identifier: MIT
"""What the libraries show and keep: they export exactly what their headers declare, and have no global state.

Arguments: the root, nm, "sanitized" where the compiler added data of its own, else "plain", and pairs of a shared and a
static library.
"""
import os
import re
import subprocess
import sys

from tap import Tap

DECLARATION = re.compile(r"\bLUXEL_API\b[^;{(]*?\b(\w+)\s*\(")


# All others are of libluxel.
HEADERS_OF_FIGURES = ["drawing.h", "figure.h"]


def declared(root, headers):
    """The functions that these public headers mark as exported."""
    names = set()
    folder = os.path.join(root, "include", "luxel")
    for header in sorted(headers):
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
    root, nm, kind, *libraries = sys.argv[1:]
    tap = Tap()
    for shared, static in zip(libraries[::2], libraries[1::2]):
        name = os.path.basename(shared).split(".so")[0]
        own = set(HEADERS_OF_FIGURES)
        headers = own if name == "libluxel-figure" else set(os.listdir(os.path.join(root, "include", "luxel"))) - own
        names, promised = exported(nm, shared), declared(root, headers)
        foreign = sorted(name for name in names if not name.startswith("luxel_"))
        tap.ok(not foreign, "%s: only luxel_ names are exported" % name, *foreign)
        missing = sorted(promised - names)
        tap.ok(promised and not missing, "%s: every function of the headers is exported" % name, *missing)
        secret = sorted(found for found in names - promised if found.startswith("luxel_"))
        tap.ok(not secret, "%s: every exported function is in a header" % name, *secret)
        if kind == "sanitized":
            tap.skip("%s has no variable of its own" % name, "sanitizers add data")
        else:
            state = writable_data(nm, static)
            tap.ok(not state, "%s has no variable of its own" % name, *state)
    tap.finish()


main()
