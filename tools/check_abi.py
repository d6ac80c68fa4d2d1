#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface: soname, version script and exported symbols agree, and no symbol that was ever there is gone.

    check_abi.py ROOT NM READELF SHARED_LIBRARY            the test
    check_abi.py ROOT NM READELF SHARED_LIBRARY --update   adds new symbols to the lists, with the current version

The list is tests/abi/luxel_1.symbols: a symbol a line, with the version of Luxel that brought it.  What Debian's tools
read, debian/libluxel1.symbols, is written from it.
"""
import os
import re
import subprocess
import sys

LIST = os.path.join("tests", "abi", "luxel_1.symbols")
DEBIAN = os.path.join("debian", "libluxel1.symbols")
HEAD = "# SPDX-License-Identifier: MIT\n# The symbols of LUXEL_1, each with the version of Luxel that brought it.\n"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def exported(nm, library):
    """Each exported symbol with the version node it is bound to."""
    lines = subprocess.run([nm, "-D", "--defined-only", "--format=posix", library], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    symbols = (line.split()[0].partition("@") for line in lines if line.split()[1] != "A")
    return {name: node.lstrip("@") for name, _, node in symbols}


def soname(readelf, library):
    text = subprocess.run([readelf, "-d", library], capture_output=True, text=True, check=True).stdout
    match = re.search(r"\(?SONAME\)?.*\[(.*)\]", text)
    return match.group(1) if match else None


def listed(root):
    """The list: symbol and version."""
    path = os.path.join(root, LIST)
    lines = read(path).splitlines() if os.path.exists(path) else []
    return dict(line.split() for line in lines if line and not line.startswith("#"))


def debian_text(symbols):
    """The list in the form of deb-symbols(5); the version node counts as a symbol."""
    lines = ["libluxel.so.1 libluxel1 #MINVER#", "* Build-Depends-Package: libluxel-dev"]
    names = {"LUXEL_1": min(symbols.values(), key=lambda text: [int(part) for part in text.split(".")]), **symbols}
    return "\n".join(lines + [" %s@LUXEL_1 %s" % (name, names[name]) for name in sorted(names)]) + "\n"


def update(root, names):
    version, = re.findall(r"^  version: '(.*)'", read(os.path.join(root, "meson.build")), re.MULTILINE)
    symbols = listed(root)
    gone = sorted(set(symbols) - set(names))
    if gone:
        sys.exit("gone, which takes a new soname: " + ", ".join(gone))
    symbols.update({name: version for name in names if name not in symbols})
    with open(os.path.join(root, LIST), "w", encoding="utf-8") as file:
        file.write(HEAD + "".join("%s %s\n" % (name, symbols[name]) for name in sorted(symbols)))
    with open(os.path.join(root, DEBIAN), "w", encoding="utf-8") as file:
        file.write(debian_text(symbols))


def check(root, library, name, symbols):
    from tap import Tap  # the tests' own module, found through PYTHONPATH
    tap = Tap()
    known = listed(root)
    script = re.sub(r"/\*.*?\*/|#.*", "", read(os.path.join(root, "src", "luxel.map")), flags=re.DOTALL)
    nodes = re.findall(r"^(\w+)\s*\{", script, re.MULTILINE)

    tap.equal(name, "libluxel.so.1", "the soname")
    tap.ok(os.path.basename(library).startswith("libluxel.so.1"), "the file is named after it", library)
    tap.equal(nodes, ["LUXEL_1"], "the version script has the node of this soname")
    strangers = sorted(symbol for symbol, node in symbols.items() if node not in nodes)
    tap.ok(symbols and not strangers, "every exported symbol is bound to it", *strangers)
    gone = sorted(set(known) - set(symbols))
    tap.ok(known and not gone, "no symbol of the list is gone", *gone)
    new = sorted(set(symbols) - set(known))
    tap.ok(not new, "every symbol is in the list (`make abi` adds what is new)", *new)
    if os.path.exists(os.path.join(root, DEBIAN)):
        tap.equal(read(os.path.join(root, DEBIAN)), debian_text(known), DEBIAN + " holds the same list")
    tap.finish()


def main():
    root, nm, readelf, library, *rest = sys.argv[1:]
    symbols = exported(nm, library)
    if rest == ["--update"]:
        update(root, symbols)
    else:
        check(root, library, soname(readelf, library), symbols)


main()
