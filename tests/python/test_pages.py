# SPDX-License-Identifier: MIT
"""The pages keep their word: every block of docs/PYTHON.md runs, and the line of the READMEs prints what it says."""
import json
import os
import re
import subprocess
import sys

from package import Tap, run_tests

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
NEEDED = {"scipy": "SciPy", "xarray": "xarray"}  # what a block may need that need not be there


def text_of(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return file.read()


def is_missing(module):
    return subprocess.run([sys.executable, "-c", "import " + module], capture_output=True).returncode != 0


def try_blocks(tap, tool, page):
    blocks = re.findall(r"```python\n(.*?)```", text_of(page), re.DOTALL)
    tap.ok(len(blocks) > 5, page + " has blocks")
    program = ["import traceback"]
    for number, block in enumerate(blocks):
        missing = [name for module, name in NEEDED.items() if "import " + module in block or
                   "from " + module in block if is_missing(module)]
        if missing:
            tap.skip("%s, block %d" % (page, number + 1), "%s is missing" % missing[0])
            continue
        program.append("try:\n    exec(compile(%r, 'block %d', 'exec'), globals())\n    print('block %d is done')\n"
                       "except Exception:\n    traceback.print_exc()" % (block, number + 1, number + 1))
    done = subprocess.run([sys.executable, tool.write("page.py", "\n".join(program))], cwd=tool.folder,
                          capture_output=True, text=True, timeout=240)
    for number in re.findall(r"block (\d+) is done", "\n".join(program)):
        tap.ok("block %s is done\n" % number in done.stdout, "%s, block %s" % (page, number), done.stderr[-3000:])


def test_guide(tap, tool):
    try_blocks(tap, tool, "docs/PYTHON.md")


def test_notebook(tap, tool):
    """It is the page's, so its cells are the blocks run above; where there is a kernel, it runs as a whole."""
    path = os.path.join(ROOT, "docs", "python", "tutorial.ipynb")
    done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make_notebook.py"),
                           os.path.join(ROOT, "docs", "PYTHON.md"), path], capture_output=True, text=True)
    tap.equal((done.returncode, done.stderr), (0, ""), "the notebook is that of the page")
    for cell in json.loads(text_of("docs/python/tutorial.ipynb"))["cells"]:
        for target in re.findall(r"\]\(((?!http)[^)#]+)", "".join(cell["source"])):
            tap.ok(os.path.exists(os.path.join(os.path.dirname(path), target)), "%s of the notebook exists" % target)
    try:
        import ipykernel  # noqa: F401
        import nbclient
        import nbformat
    except ImportError as error:
        tap.skip("the notebook in a kernel", error)
        return
    book = nbformat.read(path, 4)
    nbformat.validate(book)
    nbclient.NotebookClient(book, timeout=120, resources={"metadata": {"path": tool.folder}}).execute()
    shown = {kind for cell in book.cells if cell.cell_type == "code" for output in cell.outputs
             for kind in output.get("data", {})}
    tap.ok({"text/html", "image/png", "image/svg+xml"} <= shown, "a kernel runs it, and it shows pictures and tables",
           shown)


def test_readmes(tap, tool):
    for page in ("README.md", "README.ru.md"):
        lines = re.findall(r"^    (PYTHONPATH=\S+ python3 -c .*)$", text_of(page), re.MULTILINE)
        tap.equal(len(lines), 1, page + " tells how the package is used")
        for line in lines:
            folder = re.match(r"PYTHONPATH=(\S+)", line).group(1)
            command = line.replace(folder, os.environ["PYTHONPATH"]).replace("python3", sys.executable)
            done = subprocess.run(command.split("   #")[0], shell=True, cwd=tool.folder, capture_output=True, text=True)
            promised = line.split("#")[1].strip()
            tap.equal(done.stdout.strip() or done.stderr, promised, page + ": it prints what it says")


run_tests(Tap(), test_guide, test_notebook, test_readmes)
