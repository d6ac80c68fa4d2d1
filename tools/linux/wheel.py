#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes of a wheel that was built here one for others: wheel.py WHEEL FOLDER LICENCES [MACHINE PACKAGE], with another
machine's libraries of the folder PACKAGE in place of this one's.

The licences of the folder LICENCES go with it.  Its libraries are stripped; its tag says which glibc they need, by the
versions of the symbols that they take; order and dates of its files are always the same.  A library from outside that
is not on every system is an error, but for those of figures (cairo, pango), which are loaded when something is drawn.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from deterministic_zip import files_of, pack  # noqa: E402

EVERYWHERE = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "ld-linux-x86-64.so.2",
              "ld-linux-aarch64.so.1"}
OF_FIGURES = ("libcairo", "libpango", "libgobject", "libglib", "libharfbuzz", "libfontconfig", "libz.so")
DRAWS = ("_figure", "libluxel-figure")


def told(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def glibc_of(tool, library):
    """The newest version of glibc's symbols that a library takes."""
    versions = re.findall(r"\(?GLIBC_(\d+)\.(\d+)(?:\.\d+)?\)?", told(tool + "objdump", "-T", library))
    return max(((int(a), int(b)) for a, b in versions), default=(2, 17))


def check_needs(library, own):
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", told("readelf", "-d", library))
    odd = [name for name in needed if name not in EVERYWHERE and name not in own and
           not (library.name.startswith(DRAWS) and name.startswith(OF_FIGURES))]
    if odd:
        raise SystemExit(f"{library.name} needs {', '.join(odd)}, which is neither on every system nor in the wheel")


def tag_files(root, tag, licences):
    """Writes the tag into the wheel's metadata, with licences, and the sums of all files anew."""
    information = next(root.glob("*.dist-info"))
    shutil.copytree(licences, information / "licenses", dirs_exist_ok=True)
    about = information / "WHEEL"
    about.write_text(re.sub(r"^Tag: (.*-)[^-]*$", rf"Tag: \g<1>{tag}", about.read_text(encoding="utf-8"), flags=re.M),
                     encoding="utf-8")
    lines = []
    for path in sorted(path for path in root.rglob("*") if path.is_file()):
        name = path.relative_to(root).as_posix()
        content = path.read_bytes()
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{name},," if path.name == "RECORD" else f"{name},sha256={digest},{len(content)}")
    (information / "RECORD").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main(wheel, folder, licences, machine=os.uname().machine, package=None):
    tool = f"{machine}-linux-gnu-" if package else ""
    with tempfile.TemporaryDirectory() as place:
        root = pathlib.Path(place)
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(root)
        libraries = [path for path in root.rglob("*") if ".so" in path.name]
        for library in libraries:
            if package:
                shutil.copyfile(pathlib.Path(package) / library.name, library)
            subprocess.run([tool + "strip", "--strip-unneeded", library], check=True)
            check_needs(library, {path.name for path in libraries})
        needs = {library.name: glibc_of(tool, library) for library in libraries}
        for name, version in sorted(needs.items()):
            print(f"{name}: glibc {version[0]}.{version[1]}")
        newest = max(*needs.values(), (2, 28))
        tag = f"manylinux_{newest[0]}_{newest[1]}_{machine}"
        tag_files(root, tag, licences)
        name = re.sub(r"-[^-]*\.whl$", f"-{tag}.whl", pathlib.Path(wheel).name)
        pack(pathlib.Path(folder) / name, files_of(root, ""))
        print(name)


if __name__ == "__main__":
    main(*sys.argv[1:])
