#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes of a wheel for Linux one for Windows: python_wheel.py WHEEL BUILD FOLDER, where BUILD is the folder of
tools/windows/build.

Modules and libraries are those of BUILD, with the licences of what is inside; all else is the same.  No Python for
Windows is here to try it, so each symbol is looked for in what it is said to come from: the limited interface of Python
3.11, as Python's own list has it, luxel.dll, and libraries of every Windows.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

TOOLS = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TOOLS), str(TOOLS / "linux")]
from deterministic_zip import files_of, pack  # noqa: E402
from wheel import tag_files  # noqa: E402

OF_WINDOWS = {"advapi32.dll", "dwrite.dll", "gdi32.dll", "kernel32.dll", "msimg32.dll", "msvcrt.dll", "ole32.dll",
              "shell32.dll", "shlwapi.dll", "user32.dll", "usp10.dll", "ws2_32.dll", "dnsapi.dll", "iphlpapi.dll",
              "winmm.dll", "rpcrt4.dll", "windowscodecs.dll"}


def told(path):
    return subprocess.run(["x86_64-w64-mingw32-objdump", "-p", path], check=True, capture_output=True,
                          text=True).stdout


def taken_by(path):
    """The symbols that a module takes, by the library they come from."""
    taken = {}
    for part in told(path).split("DLL Name: ")[1:]:
        lines = part.splitlines()
        taken[lines[0].strip()] = re.findall(r"^\t[0-9a-f]+\s+\d+\s+(\w+)$", part, re.MULTILINE)
    return taken


def shown_by(path):
    return set(re.findall(r"^\s*\[ *\d+\](?: \+base\[ *\d+\])?\s+(?:[0-9a-f]+ )?(\w+)$", told(path), re.MULTILINE))


def check(root, python):
    """Every symbol is where it is looked for."""
    shown = {"luxel.dll": shown_by(root / "luxel.dll"), "python3.dll": python}
    for module in sorted([*root.glob("*.pyd"), root / "luxel.dll"]):
        for library, names in taken_by(module).items():
            if library.lower() in OF_WINDOWS:
                continue
            absent = [name for name in names if name not in shown.get(library, ())]
            if absent or library not in shown:
                raise SystemExit(f"{module.name} takes {', '.join(absent)} from {library}, which has none of them")
        if module.suffix == ".pyd" and shown_by(module) != {f"PyInit_{module.stem}"}:
            raise SystemExit(f"{module.name} shows {', '.join(sorted(shown_by(module)))}")


def main(wheel, build, folder):
    build = pathlib.Path(build)
    python = set((build / "libraries/python3.def").read_text(encoding="utf-8").split()[3:])
    with tempfile.TemporaryDirectory() as place:
        root = pathlib.Path(place)
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(root)
        for path in [path for path in root.rglob("*") if ".so" in path.name]:
            path.unlink()
        for path in [*(build / "build/python/luxel").glob("*.pyd"), build / "build/src/luxel.dll"]:
            subprocess.run(["x86_64-w64-mingw32-strip", "-o", root / "luxel" / path.name, path], check=True)
        check(root / "luxel", python)
        tag_files(root, "win_amd64", build / "papers/LICENSES")
        name = re.sub(r"-[^-]*\.whl$", "-win_amd64.whl", pathlib.Path(wheel).name)
        pack(pathlib.Path(folder) / name, files_of(root, ""))
        print(name)


if __name__ == "__main__":
    main(*sys.argv[1:])
