# SPDX-License-Identifier: MIT
"""Types: the package and a user's program pass `mypy --strict`, wrong ones do not; the stubs, which are made from the
modules' sources, agree with the modules, and these with what they say of themselves."""
import importlib
import inspect
import os
import re
import shutil
import subprocess
import sys

from package import Tap, luxel, raises, run_tests

GOOD = '''
import numpy as np
import numpy.typing as npt
import luxel

scene = luxel.Scene("report")
scene.update({"lights[0].intensity": 20, "surfaces[0].name": "ball"})
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
own_field: luxel.Field = luxel.Field.of(values, mask=lit, unit="W/sr")
lines: list[luxel.Isophote] = field.isophotes([1.0, 2.0])
peak = field.extrema().maximum
place: str = peak.place if peak else ""
seen: luxel.Geometry = scene.geometry(threads=1)
exact = scene.evaluate(seen.positions_mm, seen.normals, surface="ball", surface_tolerance=1e-4)
content: bytes = bytes(field)
brightest: float = float(field.max()) + float(field[0, 0]) + len(field)
difference: npt.NDArray[np.float64] = field - 2 * field
names_of_keys: list[str] = list(scene)
try:
    luxel.Scene("nothing.yaml")
except OSError as missing:
    reason: str = str(missing)
grid: luxel.Grid = luxel.Scene("desk").grid("desk")
cells: npt.NDArray[np.float64] = grid.values
greatest: luxel.GridPeak | None = grid.extrema().maximum
light: luxel.Balance | None = scene.balance()
flux: float = light.absorbed.value if light else 0.0
plane: luxel.Figure = luxel.Scene("desk").figure(grid="desk")
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
         'luxel.Scene().render().shape.upper()', 'luxel.Scene("desk").figure(grid=1.5)',
         'luxel.Scene().balance().sides', 'luxel.Scene().geometry().depth', 'luxel.Scene().render().maximum()',
         'luxel.Scene().evaluate([0], [0], surface=1.5)']


FOLDER = os.path.dirname(os.path.dirname(luxel.__file__))
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def mypy(tool, path, *arguments):
    """Runs a program of mypy over the sources in a folder; what it knows of NumPy is kept in the build folder."""
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=tool.folder,
                          env={**os.environ, "MYPYPATH": path, "MYPY_CACHE_DIR": os.path.join(FOLDER, "types")})


def knows_buffers():
    """Whether mypy takes a type with the method of PEP 688 for a buffer."""
    from mypy.version import __version__ as version
    return tuple(int(part) for part in re.findall(r"\d+", version)[:2]) >= (1, 5)


def installed(tool):
    """The interpreter of an environment of its own, in which the package lies as a wheel installs it."""
    made = tool.file("environment")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", made], check=True)
    python = os.path.join(made, "bin", "python")
    where = subprocess.run([python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"], check=True,
                           capture_output=True, text=True).stdout.strip()
    shutil.copytree(os.path.dirname(luxel.__file__), os.path.join(where, "luxel"))
    return python


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
    # Until Python 3.12 a type of C has its buffer without a method that says so.
    tool.write("allowed", "".join("luxel._luxel.%s.__buffer__\n" % name for name in ("FieldHandle", "View")))
    allowed = ["--allowlist", "allowed"] if sys.version_info < (3, 12) else []
    done = mypy(tool, tool.folder, "mypy.stubtest", *allowed, *["luxel." + name for name in names])
    tap.equal(done.returncode, 0, "the stubs agree with the modules") or tap.note(done.stdout, done.stderr)


def names_of(module):
    return [name for name, value in vars(module).items() if inspect.isbuiltin(value)]


def test_signatures(tap, tool):
    """Each function takes as many arguments as it says; its stub is its signature and result, word for word."""
    for name in ["_luxel"] + (["_figure"] if has_figures() else []):
        module = importlib.import_module("luxel." + name)
        with open(os.path.join(FOLDER, "luxel", name + ".pyi"), encoding="utf-8") as file:
            stub = re.sub(r"\(\n +|\n(?=\) ->)", lambda found: found.group()[:1].strip(), file.read())
        lines = {re.match(r"def (\w+)", line).group(1): line for line in stub.splitlines() if line.startswith("def ")}
        tap.equal(sorted(lines), sorted(names_of(module)), name + ": each function has a stub")
        for function in names_of(module):
            called = getattr(module, function)
            told = "def %s%s %s: ..." % (function, called.__text_signature__, called.__doc__)
            tap.equal(lines[function], told, "%s.%s: its stub" % (name, function))
            count = called.__text_signature__.count(": ")
            error = raises(TypeError, called, *[None] * (count + 1))
            found = re.search(r"takes (?:exactly )?(one|no|\d+) arguments? \((\d+) given\)", str(error))
            wanted = {"one": 1, "no": 0}.get(found.group(1), found.group(1)) if found else str(error)
            tap.equal((int(wanted) if found else wanted, found and int(found.group(2))), (count, count + 1),
                      "%s.%s: takes %d arguments" % (name, function, count))


def test_tool_of_stubs(tap, tool):
    """What is no such line is told, not left out."""
    made = [sys.executable, os.path.join(ROOT, "tools", "make_stubs.py"), "A module.", tool.file("x.pyi")]
    good = '    FUNCTION("f", f, METH_VARARGS, "a: int, "\n             "b: Any, /", "None"),\n'
    done = subprocess.run(made + [tool.file(tool.write("x.c", good))], capture_output=True, text=True)
    tap.equal((done.returncode, tool.read("x.pyi").decode()), (
        0, "# SPDX-License-Identifier: MIT\n# A module.\nfrom typing import Any\n\n"
        "def f(a: int, b: Any, /) -> None: ...\n"), "a stub")
    tool.write("x.c", good + '    FUNCTION("g", g, METH_O, PARAMETERS, "None"),\n')
    done = subprocess.run(made + [tool.file("x.c")], capture_output=True, text=True)
    tap.ok(done.returncode != 0 and "FUNCTION()" in done.stderr, "another form is refused", done.stderr)


def test_types(tap, tool):
    try:
        import mypy as found  # noqa: F401
    except ImportError as error:
        tap.skip("types", error)
        return
    tool.write("good.py", GOOD + "view: memoryview = memoryview(field)\n" * knows_buffers())
    tool.write("wrong.py", "import luxel\n" + "\n".join(WRONG) + "\n")
    python = installed(tool)
    # A package on PYTHONPATH counts as installed, and of such mypy tells nothing: here it is source, there it is not.
    del os.environ["PYTHONPATH"]
    for title, path, more in ("its source", FOLDER, []), ("installed", "", ["--python-executable", python]):
        done = mypy(tool, path, "mypy", "--strict", *more, "good.py", "wrong.py")
        told = done.stdout.splitlines()
        tap.equal([line for line in told if line.startswith("good.py")], [],
                  "a user's program passes mypy --strict: " + title)
        lines = {int(line.split(":")[1]) for line in told if line.startswith("wrong.py") and ": error:" in line}
        tap.equal(sorted(lines), list(range(2, 2 + len(WRONG))), "and each wrong line is found: " + title)
        tap.ok(not any("good.py" not in line and "wrong.py" not in line and ": error:" in line for line in told),
               "the package passes mypy --strict itself: " + title, done.stdout, done.stderr)
    shutil.copytree(os.path.dirname(luxel.__file__), tool.file("broken/luxel"))
    with open(tool.file("broken/luxel/_html.py"), "a", encoding="utf-8") as file:
        file.write("\n\ndef wrong(number: int) -> str:\n    return number\n")
    done = mypy(tool, tool.file("broken"), "mypy", "--strict", "-c", "import luxel")
    tap.ok(done.returncode == 1 and "_html.py" in done.stdout, "what is wrong in the package is told", done.stdout)
    os.environ["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    done = subprocess.run([sys.executable, tool.write("run.py", GOOD)], cwd=tool.folder, capture_output=True, text=True)
    tap.equal((done.returncode, done.stderr), (0, ""), "the program runs")


def has_figures():
    return os.path.exists(os.path.join(os.path.dirname(luxel.__file__), "_figure.abi3.so"))


run_tests(Tap(), test_types, test_stubs, test_signatures, test_tool_of_stubs)
