# SPDX-License-Identifier: MIT
"""luxel.exe, and programs with luxel.dll, under Wine against the tool for Linux: test_windows.py LUXEL LUXEL.EXE FOLDER
(of Wine's own files) [NAME...] (of tests below)."""
import array
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from xml.etree import ElementTree

from tap import Tap

NATIVE, WINDOWS, PREFIX = (os.path.abspath(path) for path in sys.argv[1:4])
FORMATS = ("png", "pfm", "npy", "csv", "exr")
SCENE = """\
luxel: 1
screen: {width: 800, height: 800, resolution: [60, 60]}
observer: {z: 2500}
surfaces:
  - {type: %s, material: {diffuse: 0.7, specular: 0}}
lights:
  - {type: point, position: [800, 900, 2400], intensity: 40}
"""
STUDY = """\
study: 1
scene: report
set: ['screen.resolution=[64,64]']
count: 600
shard: 100
vary:
  - {key: 'lights[0].position', random: box, from: [-2000, -2000, 1500], to: [2000, 2000, 4000]}
outputs: {brightness: float32, normals: float16}
"""
LAMP = """\
IESNA:LM-63-2002
TILT=NONE
1 -1 1 3 1 1 2 .1 .1 0
1 1 20
0 45 90
0
900 600 0
"""
BALL = SCENE % "sphere, center: [0, 0, 1000], radius: 300"
POT = SCENE % "mesh, file: parts/pot.ply, position: [0, 0, 1000]"
# Of the maximum: what each may be from the exact value.  Bytes may differ, as the C library of Windows rounds sines,
# exponentials and their like in its own way, and a symmetric scene may be seen by them as its mirror image.
# With highlights of extended sources that is 1e-3 (docs/RELIABILITY.md), of which a thin one takes its part.
TOLERANCE, TOLERANCES = 2e-6, {"tube": 1e-3}
NUMBER = re.compile(rb"-?\d[-+.e\d]*")
INSTRUCTIONS = ""
tap = Tap()


def run(program, folder, *arguments, **more):
    """Ends with exit code, standard output and standard error."""
    variables = {**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": "", "WINEPREFIX": PREFIX, "WINEDEBUG": "-all",
                 "LUXEL_ISA": INSTRUCTIONS, **more.pop("environment", {})}
    variables = {name: value for name, value in variables.items() if value or name == "LANGUAGE"}
    command = ["wine", WINDOWS] if program == WINDOWS else [NATIVE]
    done = subprocess.run([*command, *arguments], cwd=folder, env=variables, timeout=300, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)
    return done.returncode, done.stdout, done.stderr


def shared_instructions():
    """The widest set of instructions that both programs have and this machine runs: with it they round alike."""
    for name in ("x86-64-v4", "x86-64-v3", "x86-64"):
        if all(run(program, ".", "render", "-q", "-o", "-", "--format", "pfm", environment={"LUXEL_ISA": name})[0] == 0
               for program in (NATIVE, WINDOWS)):
            return name
    raise SystemExit("no set of instructions is in both programs")


def both(folder, *arguments, **more):
    return run(NATIVE, folder, *arguments, **more), run(WINDOWS, folder, *arguments, **more)


def same(folder, name, *arguments, **more):
    native, windows = both(folder, *arguments, **more)
    tap.equal(windows, native, name)


def values(picture):
    """The header of a PFM file, and its numbers."""
    *header, numbers = picture.split(b"\n", 3)
    return header, array.array("f", numbers)


def same_values(folder, name, tolerance, *arguments):
    """The same picture, but for the rounding of another C library."""
    (code, native, _), (other_code, windows, told) = both(folder, *arguments)
    if not tap.equal((other_code, code, told), (0, 0, b""), f"{name}: both render it"):
        return
    (header, expected), (other_header, found) = values(native), values(windows)
    tap.equal((other_header, len(found)), (header, len(expected)), f"{name}: size")
    apart = max(abs(a - b) for a, b in zip(found, expected))
    tap.ok(apart <= tolerance * max(expected), f"{name}: values", f"apart by {apart / max(expected)} of the maximum")


def scenes_and_formats(folder):
    """Pictures of all built-in scenes have the same values; a small one is the same bytes in each format."""
    for name in sorted(path.stem for path in SOURCES.glob("*.yaml")):
        same_values(folder, name, TOLERANCES.get(name, TOLERANCE), "render", name, "-q", "-o", "-", "--format", "pfm")
    for ending in FORMATS:
        same(folder, f"{ending} by standard output", "render", "-q", "-o", "-", "--format", ending)
        for program, place in ((NATIVE, "one"), (WINDOWS, "other")):
            run(program, folder, "render", "-q", "-o", f"{place}.{ending}")
        tap.equal((folder / f"other.{ending}").read_bytes(), (folder / f"one.{ending}").read_bytes(), f"{ending} file")


def texts(folder):
    """What is printed, wrong usage, and exit codes."""
    (code, native, _), (other_code, windows, told) = both(folder, "probe", "report", "--json")
    tap.equal((other_code, code, told), (0, 0, b""), "probe as JSON")
    tap.equal(NUMBER.sub(b"", windows), NUMBER.sub(b"", native), "probe as JSON: keys")
    for found, expected in zip(NUMBER.findall(windows), NUMBER.findall(native)):
        tap.near(float(found), float(expected), 1e-12, "probe as JSON: a number")
    same(folder, "help", "help")
    same(folder, "wrong option", "render", "--sise", "3")
    same(folder, "no such scene", "render", "absent.yaml", "-o", "a.png")
    same(folder, "a folder as scene", "render", ".", "-o", "a.png")
    same(folder, "Russian help", "help", environment={"LC_ALL": "C.UTF-8", "LANGUAGE": "ru", "LANG": "ru_RU.UTF-8"})


def inputs(folder):
    """Names in Cyrillic, ends of lines, scenes by standard input, files that are replaced."""
    (folder / "сцена.yaml").write_text(BALL, encoding="utf-8")
    (folder / "crlf.yaml").write_bytes(BALL.replace("\n", "\r\n").encode())
    same(folder, "name in Cyrillic", "check", "сцена.yaml")
    same(folder, "ends of lines", "check", "crlf.yaml")
    same(folder, "standard input", "check", "-", input=BALL.encode())
    code, _, told = run(WINDOWS, folder, "render", "-q", "-o", "картина.png")
    tap.ok(code == 0 and (folder / "картина.png").stat().st_size > 1000, "output in Cyrillic", told)
    before = (folder / "картина.png").read_bytes()
    code, _, told = run(WINDOWS, folder, "render", "-q", "distant", "-o", "картина.png")
    tap.ok(code == 0 and (folder / "картина.png").read_bytes() != before, "a file is replaced", told)
    tap.equal([path.name for path in folder.iterdir() if path.name.endswith(".part")], [], "nothing is left beside it")


def paths(folder):
    """Backslashes and drives: Wine's drive Z is the root of all files."""
    (folder / "place/parts").mkdir(parents=True)
    (folder / "place/pot.yaml").write_text(POT, encoding="utf-8")
    shutil.copy(SOURCES.parent / "files/pot.ply", folder / "place/parts")
    drive = "Z:" + str(folder).replace("/", "\\")
    code, expected, told = run(NATIVE, folder, "render", "place/pot.yaml", "-q", "-o", "-", "--format", "pfm")
    tap.ok(code == 0 and expected, "a scene with a file beside it", told)
    names = ("place/pot.yaml", r"place\pot.yaml", rf"{drive}\place\pot.yaml", f"{drive[:2]}{folder}/place/pot.yaml")
    for name in names:
        found = run(WINDOWS, folder, "render", name, "-q", "-o", "-", "--format", "pfm")
        tap.equal(found, (0, expected, b""), f"file beside {name.replace(str(drive), 'Z:...')}")
    (folder / "place/whole.yaml").write_text(POT.replace("parts/pot.ply", rf"'{drive}\place\parts\pot.ply'"),
                                             encoding="utf-8")
    found = run(WINDOWS, folder, "render", r"place\whole.yaml", "-q", "-o", "-", "--format", "pfm")
    tap.equal(found, (0, expected, b""), "a scene that names a drive")
    found = run(WINDOWS, folder, "render", "-q", "-o", rf"{drive}\place\out.pfm")
    tap.ok(found[0] == 0 and (folder / "place/out.pfm").is_file(), "output behind backslashes", found)
    code, _, told = run(WINDOWS, folder, "render", "-q", "-o", r"pictures.png\out")
    tap.ok(code == 2 and b"needs an extension" in told, "a dot of a folder begins no extension", code, told)


def long_paths(folder):
    """Files of 300 and more characters, which Windows takes in a form of their own."""
    deep = folder / "/".join(f"папка с длинным именем {i:02d}" for i in range(12))
    deep.mkdir(parents=True)
    (deep / "scene.yaml").write_text(BALL, encoding="utf-8")
    name = deep.relative_to(folder)
    tap.ok(len(str(name)) > 260, "it is a long path", len(str(name)))
    same(folder, "a scene of a long path", "check", f"{name}/scene.yaml")
    code, _, told = run(WINDOWS, folder, "render", f"{name}/scene.yaml", "-q", "-o", f"{name}/out.npy")
    tap.ok(code == 0 and (deep / "out.npy").stat().st_size > 1000, "a picture of a long path", told)
    code, _, told = run(WINDOWS, folder, "set", f"{name}/scene.yaml", "lights[0].intensity=20")
    tap.ok(code == 0 and "intensity: 20" in (deep / "scene.yaml").read_text(encoding="utf-8"), "it is replaced", told)


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def sweeps(folder):
    """A sweep has the bytes of one on Linux, also when it was killed, or is shared; a folder is one sweep's alone."""
    (folder / "study.yaml").write_text(STUDY, encoding="utf-8")
    run(NATIVE, folder, "sweep", "study.yaml", "-q", "-o", "native")
    code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "выборка")
    expected = contents(folder / "native")
    tap.equal((code, told), (0, b""), "a sweep")
    tap.equal(contents(folder / "выборка"), expected, "a sweep: files and their bytes")
    environment = {**os.environ, "WINEPREFIX": PREFIX, "WINEDEBUG": "-all", "LUXEL_ISA": INSTRUCTIONS}
    with subprocess.Popen(["wine", WINDOWS, "sweep", "study.yaml", "-q", "-o", "killed", "--workers", "1"], cwd=folder,
                          env=environment) as working:
        until = time.monotonic() + 120
        while not (folder / "killed/shard-000001").exists() and time.monotonic() < until:
            time.sleep(0.01)
        code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "killed")
        if working.poll() is None:
            tap.ok(code == 4 and b"another luxel sweep works in this folder" in told, "a second one", code, told)
            working.kill()
    code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "killed")
    tap.equal((code, told), (0, b""), "one that was killed goes on")
    tap.equal(contents(folder / "killed"), expected, "one that was killed: files and their bytes")
    for part in ("0/2", "1/2"):
        code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "parts", "--shard", part)
        tap.equal((code, told), (0, b""), f"part {part}")
    tap.equal(contents(folder / "parts"), expected, "parts: files and their bytes")
    code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "parts", "--merge", "brightness.npy")
    tap.ok(code == 0 and (folder / "brightness.npy").stat().st_size > 1000, "shards are merged", told)
    code, _, told = run(WINDOWS, folder, "sweep", "study.yaml", "-q", "-o", "parts", "--merge", "data.h5")
    tap.ok(code == 4 and b"merge into .npy" in told and not (folder / "data.h5").exists(), "HDF5 is not there", told)


def pages_of(path):
    told = subprocess.run(["pdfinfo", path], capture_output=True, text=True, check=True).stdout
    return int(re.search(r"^Pages: +(\d+)", told, re.MULTILINE)[1])


def words_of(path):
    return subprocess.run(["pdftotext", path, "-"], capture_output=True, text=True, check=True).stdout.split()


def drawings(folder):
    """Figures and reports, whose fonts are those of the system: pages and words are the same as on Linux."""
    for name in ("figure.png", "figure.svg", "figure.pdf"):
        code, _, told = run(WINDOWS, folder, "figure", "report", "-q", "-o", name)
        tap.equal((code, told), (0, b""), name)
    tap.ok((folder / "figure.png").read_bytes()[:4] == b"\x89PNG", "it is a PNG")
    root = ElementTree.parse(folder / "figure.svg").getroot()
    tap.ok(root.tag.endswith("svg") and len(list(root.iter())) > 100, "it is an SVG", root.tag)
    for language in ("en", "ru"):
        words, environment = {}, {"LC_ALL": "C.UTF-8", "LANGUAGE": language, "LANG": "ru_RU.UTF-8"}
        for program, name in ((NATIVE, "native"), (WINDOWS, "windows")):
            path = folder / f"{name}-{language}.pdf"
            code, _, told = run(program, folder, "report", "report", "-q", "-o", path.name, environment=environment)
            tap.equal((code, told), (0, b""), f"{path.name}: a report")
            words[name] = words_of(path)
        tap.ok(len(words["native"]) > 500, f"a report in {language} has words")
        left = [word for word in set(words["native"]) - set(words["windows"]) if word.isalpha() and len(word) > 3]
        tap.ok(len(left) < 20, f"a report in {language}: the same words", left)
        tap.ok(abs(pages_of(folder / f"windows-{language}.pdf") - pages_of(folder / f"native-{language}.pdf")) <= 1,
               f"a report in {language}: pages")
    (folder / "lamp.ies").write_text(LAMP, encoding="utf-8")
    code, _, told = run(WINDOWS, folder, "photometry", "lamp.ies", "-q", "-o", "polar.svg")
    tap.ok(code == 0 and (folder / "polar.svg").stat().st_size > 1000, "a diagram of a luminaire", told)


def library(folder):
    """Examples that are linked with luxel.dll by either import library run, and give the tool's numbers."""
    root = SOURCES.parents[1]
    built = pathlib.Path(WINDOWS).parent
    shutil.copy(built / "luxel.dll", folder)
    value = json.loads(run(NATIVE, folder, "probe", "report", "-p", "0,0", "--json")[1])["points"][0]["value"]
    examples = {"probe_points": f"{value:.12g}", "render_to_png": "11.7475", "measure_plane": "flux"}
    for kind in ("luxel.lib", "libluxel.dll.a"):
        for name, wanted in examples.items():
            program = folder / f"{name}.exe"
            linked = subprocess.run(["x86_64-w64-mingw32-gcc-posix", "-std=gnu11", "-Wall", "-Wextra", "-Werror",
                                     f"-I{root}/include", "-o", program, root / f"examples/{name}.c", built / kind],
                                    capture_output=True, text=True, check=False)
            tap.equal((linked.returncode, linked.stderr), (0, ""), f"{name} is linked by {kind}")
            told = subprocess.run(["wine", program, *(["sphere.png"] if name == "render_to_png" else [])], cwd=folder,
                                  env={**os.environ, "WINEPREFIX": PREFIX, "WINEDEBUG": "-all"}, timeout=120,
                                  capture_output=True, text=True, check=False)
            tap.ok(told.returncode == 0 and wanted in told.stdout, f"{name} runs", told.stdout, told.stderr)
    shown = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", built / "luxel.dll"], capture_output=True, text=True,
                           check=True).stdout
    names = re.findall(r"^\s*\[ *\d+\](?: \+base\[ *\d+\])?\s+(?:[0-9a-f]+ )?(\w+)$", shown, re.MULTILINE)
    symbols = "".join((root / f"tests/abi/{name}_1.symbols").read_text(encoding="utf-8")
                      for name in ("luxel", "luxel-figure"))
    listed = re.findall(r"^(luxel_\w+) ", symbols, re.MULTILINE)
    tap.equal(set(names) ^ set(listed), set(), "functions that luxel.dll shows")


INSTRUCTIONS = shared_instructions()
SOURCES = pathlib.Path(__file__).resolve().parents[2] / "data/scenes"
for test in (paths, long_paths, sweeps, drawings, library, texts, inputs, scenes_and_formats):
    if not sys.argv[4:] or test.__name__ in sys.argv[4:]:
        with tempfile.TemporaryDirectory() as name:
            tap.run(test, pathlib.Path(name))
print(f"{tap.count - tap.failed} passed, {tap.failed} failed")
tap.finish()
