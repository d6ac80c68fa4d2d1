# SPDX-License-Identifier: MIT
"""The man page and docs/SCENE.md, made from the tables: complete, well-formed, up to date.

    test_pages.py LUXEL MAN_PAGE LUXEL_PAGES docs/SCENE.md
"""
import os
import re
import shutil
import subprocess
import sys

import yaml
from tap import Tap
from tool import run_tests

MAN, PAGES, SCENE_MD = (os.path.abspath(path) for path in sys.argv[2:5])
SECTIONS = ["NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "OPTIONS", "SCENE KEYS", "EXIT STATUS", "ENVIRONMENT",
            "FILES", "EXAMPLES", "SEE ALSO"]


def run(*command, environment=None):
    return subprocess.run(command, capture_output=True, env={**os.environ, **(environment or {})}, timeout=60)


def source():
    with open(MAN, encoding="ascii") as file:
        return file.read()


def plain(text):
    """The text without fonts and escapes, in one line."""
    text = re.sub(r"\\f[BIR]|\\&", "", text).replace("\\-", "-").replace("\\(aq", "'").replace("\\(dq", '"')
    return " ".join(text.replace("\\e", "\\").split())


def man_is_complete(tap, tool):
    text = source()
    tap.equal([name.strip('"') for name in re.findall(r"^\.SH (.*)$", text, re.M)], SECTIONS, "the sections")
    text = plain(text)
    usage = tool.run("help").out
    for command in re.findall(r"^  (\w+)  +\w", usage, re.M):
        tap.ok("luxel %s" % command in text, "luxel " + command)
        for options in re.findall(r"^ +((?:-\w, )?--[\w-]+(?: [A-Z=,]+)?)", tool.run("help", command).out, re.M):
            tap.ok(options.strip() in text, "%s of %s" % (options.strip(), command))
    for key in tool.run("help", "--json").json()["keys"]:
        tap.ok(re.search(r"\b%s\b" % key["path"].split(".")[-1], text), "key " + key["path"])
    for word in "LUXEL_ISA", "NO_COLOR", "LC_ALL", "130 interrupted", "my.yaml":
        tap.ok(word in text, word)


def man_is_well_formed(tap, tool):
    text = source()
    tap.ok(all(len(line) <= 130 for line in text.split("\n")), "no line is too long")
    if shutil.which("groff"):
        for device in "utf8", "ascii", "latin1", "ps":
            done = run("groff", "-ww", "-man", "-T" + device, MAN)
            tap.ok(done.returncode == 0 and not done.stderr, "groff -ww -T" + device, done.stderr.decode())
    if shutil.which("mandoc"):
        done = run("mandoc", "-Tlint", MAN)
        faults = [line for line in done.stdout.decode().split("\n") if line and "longer than 80" not in line]
        tap.ok(not faults, "mandoc -Tlint", *faults)
    if shutil.which("man") and shutil.which("groff"):
        done = run("man", "--warnings", "-l", MAN, environment={"LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
        shown = done.stdout.decode()
        tap.ok(done.returncode == 0 and not done.stderr, "man --warnings", done.stderr.decode())
        tap.ok("luxel - compute how light sources brighten a surface" in shown, "man shows its name")
        tap.ok("luxel render -s 'lights[0].position=[1500,800,2400]' -o" in shown, "examples can be copied")


def scene_md_is_up_to_date(tap, tool):
    made = run(PAGES, "scene", environment={"LC_ALL": "ru_RU.UTF-8", "LANGUAGE": "ru"})
    with open(SCENE_MD, encoding="utf-8") as file:
        kept = file.read()
    tap.ok(made.returncode == 0 and made.stdout.decode("utf-8") == kept,
           "docs/SCENE.md is what build/cli/pages/luxel-pages scene prints")


def scene_md_is_complete(tap, tool):
    with open(SCENE_MD, encoding="utf-8") as file:
        text = file.read()
    for key in tool.run("help", "--json").json()["keys"]:
        row = re.search(r"^\| %s \|.*$" % re.escape(key["path"].split(".")[-1]), text, re.M)
        tap.ok(row and key["meaning"][1:] in text, "%s of %s" % (key["path"], key["of_type"]))
        tap.ok(not key["advised"] or key["advised"] in text, "its advised range")
        tap.ok(not key["legal"] or key["legal"] in text, "its legal range")
    for line in text.split("\n"):
        if line.startswith("|"):
            tap.ok(line.count("|") == 6, "a row of five cells: " + line[:30], line)
    base = yaml.safe_load(tool.run("scene").out)
    examples = re.findall(r"^```yaml\n(.*?)^```", text, re.M | re.S)
    tap.ok(len(examples) > 5, "it has examples")
    for example in examples:
        scene = yaml.safe_load(example)
        if scene is None:
            continue
        tool.write("example.yaml", yaml.safe_dump({**base, **scene}))
        result = tool.run("check", "example.yaml")
        tap.ok(result.code == 0, "the example is valid: " + example.split("\n")[1][:40], result)


def usage(tap, tool):
    for arguments in [], ["nosuch"], ["man", "more"], ["bash"]:
        done = run(PAGES, *arguments)
        tap.ok(done.returncode == 2 and not done.stdout, "luxel-pages " + " ".join(arguments), done)
    tap.equal(run(PAGES, "bash", "/nonexistent").returncode, 1, "a script that is not there")


run_tests(Tap(), man_is_complete, man_is_well_formed, scene_md_is_up_to_date, scene_md_is_complete, usage)
