#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface: soname, version script and exported symbols agree, and no symbol that was ever there is gone.

    check_abi.py ROOT NM READELF SHARED_LIBRARY...            the test
    check_abi.py ROOT NM READELF SHARED_LIBRARY... --update   adds new symbols to the lists, with the current version

The list of a library is tests/abi/NAME_1.symbols: a symbol a line, with the version of Luxel that brought it.  What
Debian's tools read, debian/libNAME1.symbols, is written from it.
"""
import os
import re
import subprocess
import sys

HEAD = "# SPDX-License-Identifier: MIT\n# The symbols of %s, each with the version of Luxel that brought it.\n"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def exported(nm, library):
    """Each exported symbol with the version node it is bound to."""
    lines = subprocess.run([nm, "-D", "--defined-only", "--format=posix", library], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    symbols = (line.split()[0].partition("@") for line in lines if line.split()[1] != "A")
    return {name: node.lstrip("@") for name, _, node in symbols}


def holds_kernels(nm, library):
    """Whether kernels are in a library, by its own names; None where they were taken out of it."""
    names = subprocess.run([nm, "--defined-only", "--format=posix", library], capture_output=True, text=True,
                           check=True).stdout
    return "lx_kernels_get" in names if "lx_" in names else None


def soname(readelf, library):
    text = subprocess.run([readelf, "-d", library], capture_output=True, text=True, check=True).stdout
    match = re.search(r"\(?SONAME\)?.*\[(.*)\]", text)
    return match.group(1) if match else None


class Library:
    """One of the libraries: its names, the version script of its node, and its lists."""

    def __init__(self, root, path):
        self.path = path
        self.name = os.path.basename(path).split(".so")[0][len("lib"):]
        self.soname = "lib%s.so.1" % self.name
        self.node = self.name.upper().replace("-", "_") + "_1"
        self.script = os.path.join(root, "src", {"luxel": "", "luxel-figure": "figure"}[self.name], self.name + ".map")
        self.list = os.path.join(root, "tests", "abi", self.name + "_1.symbols")
        self.debian = os.path.join(root, "debian", "lib%s1.symbols" % self.name)

    def listed(self):
        """The list: symbol and version."""
        lines = read(self.list).splitlines() if os.path.exists(self.list) else []
        return dict(line.split() for line in lines if line and not line.startswith("#"))

    def debian_text(self, symbols):
        """The list in the form of deb-symbols(5); the version node counts as a symbol."""
        lines = ["%s lib%s1 #MINVER#" % (self.soname, self.name), "* Build-Depends-Package: libluxel-dev"]
        oldest = min(symbols.values(), key=lambda text: [int(part) for part in text.split(".")])
        names = {self.node: oldest, **symbols}
        return "\n".join(lines + [" %s@%s %s" % (name, self.node, names[name]) for name in sorted(names)]) + "\n"


def update(root, library, names):
    version, = re.findall(r"^  version: '(.*)'", read(os.path.join(root, "meson.build")), re.MULTILINE)
    symbols = library.listed()
    gone = sorted(set(symbols) - set(names))
    if gone:
        sys.exit("gone, which takes a new soname: " + ", ".join(gone))
    symbols.update({name: version for name in names if name not in symbols})
    with open(library.list, "w", encoding="utf-8") as file:
        file.write(HEAD % library.node + "".join("%s %s\n" % (name, symbols[name]) for name in sorted(symbols)))
    with open(library.debian, "w", encoding="utf-8") as file:
        file.write(library.debian_text(symbols))


def check(tap, library, name, symbols):
    known = library.listed()
    script = re.sub(r"/\*.*?\*/|#.*", "", read(library.script), flags=re.DOTALL)
    nodes = re.findall(r"^(\w+)\s*\{", script, re.MULTILINE)

    tap.equal(name, library.soname, "%s: the soname" % library.name)
    tap.ok(os.path.basename(library.path).startswith(library.soname), "the file is named after it", library.path)
    tap.equal(nodes, [library.node], "the version script has the node of this soname")
    strangers = sorted(symbol for symbol, node in symbols.items() if node not in nodes)
    tap.ok(symbols and not strangers, "every exported symbol is bound to it", *strangers)
    gone = sorted(set(known) - set(symbols))
    tap.ok(known and not gone, "no symbol of the list is gone", *gone)
    new = sorted(set(symbols) - set(known))
    tap.ok(not new, "every symbol is in the list (`make abi` adds what is new)", *new)
    if os.path.exists(library.debian):
        tap.equal(read(library.debian), library.debian_text(known), library.debian + " holds the same list")


def main():
    root, nm, readelf, *rest = sys.argv[1:]
    libraries = [Library(root, path) for path in rest if path != "--update"]
    if "--update" in rest:
        for library in libraries:
            update(root, library, exported(nm, library.path))
        return
    from tap import Tap  # the tests' own module, found through PYTHONPATH
    tap = Tap()
    for library in libraries:
        check(tap, library, soname(readelf, library.path), exported(nm, library.path))
        if holds_kernels(nm, library.path) is not None:
            tap.equal(holds_kernels(nm, library.path), library.name == "luxel",
                      library.name + ": kernels are in libluxel alone")
    tap.finish()


main()
