# SPDX-License-Identifier: MIT
"""Types: the package and a user's program pass `mypy --strict`, wrong ones do not; the stubs agree with the modules."""
import os
import shutil
import subprocess
import sys

from package import Tap, luxel, run_tests

GOOD = '''
import numpy as np
import numpy.typing as npt
import luxel

scene = luxel.Scene("report")
scene["lights[0].intensity"] = 20
scene.update({"screen.resolution": [90, 90]})
field: luxel.Field = scene.render(threads=2, precision="double", progress=lambda done: done < 1)
values: npt.NDArray[np.float64] = np.asarray(field, dtype=np.float64)
lit: npt.NDArray[np.bool_] = field.mask
maximum = field.statistics.maximum
if maximum is not None:
    column: int = maximum.column
one: luxel.Probe = scene.probe((0, 0))
many: luxel.Probes = scene.probe([(0, 0), (1, 1)])
own: luxel.Probes = scene.probe()
names = [share.type.upper() for share in one.shares]
result = scene.evaluate(np.zeros((4, 3)), [0, 0, 1], per_light=True)
total: float = float(result["value"].sum())
lines: list[luxel.Isophote] = field.isophotes([1.0, 2.0])
peak = field.extrema().maximum
place: str = peak.place if peak else ""
grid: luxel.Grid = luxel.Scene("desk").grid("desk")
cells: npt.NDArray[np.float64] = grid.values
svg: str = scene.figure(palette="turbo", section=(0, 0)).svg()
text: str = scene.explain((0, 0)).html
try:
    luxel.Scene({"luxel": 1})
except luxel.LuxelError as error:
    entry: luxel.Diagnostic = error.diagnostics[0]
    where: tuple[str | None, int, int] = (entry.file, entry.line, entry.column)
'''
WRONG = ['luxel.Scene(5)', 'luxel.Scene().render(thread=2)', 'luxel.Scene().render(threads="2")',
         'luxel.Scene().probe((0, 0)).valeu', 'luxel.Scene().grid(1.5)', 'luxel.Scene().explain("a").text',
         'luxel.Scene().render().shape.upper()']


FOLDER = os.path.dirname(os.path.dirname(luxel.__file__))


def mypy(tool, path, *arguments):
    """Runs a program of mypy over the sources in a folder; what it knows of NumPy is kept in the build folder."""
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=tool.folder,
                          env={**os.environ, "MYPYPATH": path, "MYPY_CACHE_DIR": os.path.join(FOLDER, "types")})


def test_stubs(tap, tool):
    """Without the package around them, which would bring NumPy's types with it."""
    try:
        import mypy.stubtest as found  # noqa: F401
    except ImportError as error:
        tap.skip("stubs", error)
        return
    os.mkdir(tool.file("luxel"))
    tool.write("luxel/__init__.pyi", "")
    names = ["_luxel"] + (["_figure"] if has_figures() else [])
    for name in names:
        shutil.copy(os.path.join(FOLDER, "luxel", name + ".pyi"), tool.file("luxel"))
    done = mypy(tool, tool.folder, "mypy.stubtest", *["luxel." + name for name in names])
    tap.equal(done.returncode, 0, "the stubs agree with the modules") or tap.note(done.stdout, done.stderr)


def test_types(tap, tool):
    try:
        import mypy as found  # noqa: F401
    except ImportError as error:
        tap.skip("types", error)
        return
    tool.write("good.py", GOOD)
    tool.write("wrong.py", "import luxel\n" + "\n".join(WRONG) + "\n")
    done = mypy(tool, FOLDER, "mypy", "--strict", "good.py", "wrong.py")
    told = done.stdout.splitlines()
    tap.equal([line for line in told if line.startswith("good.py")], [], "a user's program passes mypy --strict")
    lines = {int(line.split(":")[1]) for line in told if line.startswith("wrong.py") and ": error:" in line}
    tap.equal(sorted(lines), list(range(2, 2 + len(WRONG))), "and each wrong line is found")
    tap.ok(not any("good.py" not in line and "wrong.py" not in line and ": error:" in line for line in told),
           "the package passes mypy --strict itself", done.stdout, done.stderr)
    done = subprocess.run([sys.executable, tool.write("run.py", GOOD)], cwd=tool.folder, capture_output=True, text=True)
    tap.equal((done.returncode, done.stderr), (0, ""), "the program runs")


def has_figures():
    return os.path.exists(os.path.join(os.path.dirname(luxel.__file__), "_figure.abi3.so"))


run_tests(Tap(), test_types, test_stubs)
