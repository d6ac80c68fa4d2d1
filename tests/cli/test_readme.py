# SPDX-License-Identifier: MIT
"""The READMEs keep their word: every command and the Python program that they print are run, in their order."""
import os
import re
import subprocess
import sys
import tempfile

from tap import Tap
from tool import Tool

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
DRAWING = ("figure", "report", "photometry")  # commands of a build with cairo and pango
JUDGING = ("compare", "grade")  # these may end with 1: a difference, a wrong answer
ANSWERS = "student,variant,point,value\nA,17,1,0\n"
LAMP = "IESNA:LM-63-1995\nTILT=NONE\n1 1000 1 3 1 1 2 0.1 0.1 0\n1 1 10\n0 45 90\n0\n318 225 0\n"
PLACES = "x,y\n0,0\n150,0\n-150,0\n"
READINGS = "x,y,value\n0,0,2.8\n150,0,10.9\n100,50,7.6\n"


def commands(text):
    """The lines of indented blocks that begin with luxel, continued ones joined."""
    joined = re.sub(r"\\\n\s*", "", text)
    return [line.strip() for line in joined.splitlines() if re.match(r"    luxel [a-z]", line)]


def links(text):
    """Files that are linked to or shown; what stands after # is a heading of this page."""
    for target in re.findall(r"\]\(([^)]*)\)", text):
        if not target.startswith("http"):
            yield target.partition("#")


def anchors(text):
    """The headings as GitHub names them."""
    for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def try_page(tap, tool, draws, page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        text = file.read()
    os.makedirs(os.path.join(tool.folder, "submissions"), exist_ok=True)
    tool.write("submissions/a.csv", ANSWERS)
    tool.write("places.csv", PLACES)
    tool.write("readings.csv", READINGS)
    tool.write("lamp.ies", LAMP)
    for name, scene in re.findall(r"```yaml\n# (\S+\.yaml)\n(.*?)```", text, re.DOTALL):
        tool.write(name, scene)
    shell = {**os.environ, "LC_ALL": "C.UTF-8", "PATH": os.path.dirname(tool.path) + ":" + os.environ["PATH"]}
    found = commands(text)
    tap.ok(len(found) > 15, page + " has commands")
    for command in found:
        name = command.split()[1]
        if name in DRAWING and not draws:
            tap.skip(command, "built without figures")
            continue
        done = subprocess.run(command, shell=True, cwd=tool.folder, env=shell, capture_output=True, text=True,
                              timeout=300)
        judged = done.returncode == 1 and name in JUDGING and "error:" not in done.stderr
        good = done.returncode == 0 or judged
        tap.ok(good, "%s: %s" % (page, command), "exit code %d" % done.returncode, done.stderr)
    for program in re.findall(r"```python\n(.*?)```", text, re.DOTALL):
        done = subprocess.run([sys.executable, "-c", program], cwd=tool.folder, env=shell, capture_output=True,
                              text=True, timeout=300)
        promised = re.search(r"print\(.*# (\(.*?\) \w+)", program).group(1)
        tap.equal(done.stdout.strip() or done.stderr, promised, page + ": the Python program prints what it says")
    for target, mark, anchor in links(text):
        if target:
            tap.ok(os.path.exists(os.path.join(ROOT, target)), "%s: %s exists" % (page, target))
        elif mark:
            tap.ok(anchor in anchors(text), "%s: the heading %s exists" % (page, anchor))


def main():
    tap = Tap()
    draws = len(sys.argv) > 2 and sys.argv[2] == "draws"
    for page in ("README.md", "README.ru.md"):
        with tempfile.TemporaryDirectory() as folder:
            try_page(tap, Tool(folder), draws, page)
    tap.finish()


main()
