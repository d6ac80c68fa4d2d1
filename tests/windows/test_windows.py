# SPDX-License-Identifier: MIT
"""luxel.exe under Wine against the tool for Linux: test_windows.py LUXEL LUXEL.EXE FOLDER (of Wine's own files)."""
import os
import pathlib
import subprocess
import sys
import tempfile

from tap import Tap

NATIVE, WINDOWS, PREFIX = (os.path.abspath(path) for path in sys.argv[1:4])
FORMATS = ("png", "pfm", "npy", "csv", "exr")
SCENE = "luxel: 1\nunits: radiometric\nsurfaces:\n  - {type: sphere, center: [0, 0, 1000], radius: 200}\n"
tap = Tap()


def run(program, folder, *arguments, **more):
    """Ends with exit code, standard output and standard error."""
    variables = {**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": "", "WINEPREFIX": PREFIX, "WINEDEBUG": "-all",
                 "LUXEL_ISA": "", **more.pop("environment", {})}
    variables = {name: value for name, value in variables.items() if value or name == "LANGUAGE"}
    command = ["wine", WINDOWS] if program == WINDOWS else [NATIVE]
    done = subprocess.run([*command, *arguments], cwd=folder, env=variables, timeout=300, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)
    return done.returncode, done.stdout, done.stderr


def both(folder, *arguments, **more):
    return run(NATIVE, folder, *arguments, **more), run(WINDOWS, folder, *arguments, **more)


def same(folder, name, *arguments, **more):
    native, windows = both(folder, *arguments, **more)
    tap.equal(windows, native, name)


def scenes_and_formats(folder):
    """Pictures of all built-in scenes, and one in each format, are the same bytes."""
    for name in sorted(path.stem for path in SOURCES.glob("*.yaml")):
        same(folder, f"picture of {name}", "render", name, "-q", "-o", "-", "--format", "pfm")
    for ending in FORMATS:
        same(folder, f"{ending} by standard output", "render", "-q", "-o", "-", "--format", ending)
        for program, place in ((NATIVE, "one"), (WINDOWS, "other")):
            run(program, folder, "render", "-q", "-o", f"{place}.{ending}")
        tap.equal((folder / f"other.{ending}").read_bytes(), (folder / f"one.{ending}").read_bytes(), f"{ending} file")


def texts(folder):
    """What is printed, wrong usage, and exit codes."""
    same(folder, "probe as JSON", "probe", "report", "--json")
    same(folder, "help", "help")
    same(folder, "wrong option", "render", "--sise", "3")
    same(folder, "no such scene", "render", "absent.yaml", "-o", "a.png")
    same(folder, "a folder as scene", "render", ".", "-o", "a.png")
    same(folder, "Russian help", "help", environment={"LC_ALL": "C.UTF-8", "LANGUAGE": "ru", "LANG": "ru_RU.UTF-8"})
    code, _, told = run(WINDOWS, folder, "sweep", "study.yaml")
    tap.ok(code == 4 and b"not in Luxel for Windows" in told, "sweeps are refused", told)


def inputs(folder):
    """Names in Cyrillic, ends of lines, scenes by standard input, files that are replaced."""
    (folder / "сцена.yaml").write_text(SCENE, encoding="utf-8")
    (folder / "crlf.yaml").write_bytes(SCENE.replace("\n", "\r\n").encode())
    same(folder, "name in Cyrillic", "check", "сцена.yaml")
    same(folder, "ends of lines", "check", "crlf.yaml")
    same(folder, "standard input", "check", "-", input=SCENE.encode())
    code, _, told = run(WINDOWS, folder, "render", "-q", "-o", "картина.png")
    tap.ok(code == 0 and (folder / "картина.png").stat().st_size > 1000, "output in Cyrillic", told)
    before = (folder / "картина.png").read_bytes()
    code, _, told = run(WINDOWS, folder, "render", "-q", "distant", "-o", "картина.png")
    tap.ok(code == 0 and (folder / "картина.png").read_bytes() != before, "a file is replaced", told)
    tap.equal([path.name for path in folder.iterdir() if path.name.endswith(".part")], [], "nothing is left beside it")


SOURCES = pathlib.Path(__file__).resolve().parents[2] / "data/scenes"
for test in (scenes_and_formats, texts, inputs):
    with tempfile.TemporaryDirectory() as name:
        tap.run(test, pathlib.Path(name))
print(f"{tap.count - tap.failed} passed, {tap.failed} failed")
tap.finish()
