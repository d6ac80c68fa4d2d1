#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""xgettext for this project: runs the real one with the same arguments on what it finds by itself, and on texts that it
could not find, which are gathered here: the library's messages (LX_MESSAGE, LX_N), the labels and meanings in its
parameter tables, the titles of the built-in scenes, and what the system and other libraries say (po/others.txt)."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LITERAL = r'"(?:[^"\\]|\\.)*"'
# What stands before a text that is translated; between the parts of a text there may be blanks and line ends.
BEFORE = [
    r"\.label\s*=\s*",
    r"\.meaning\s*=\s*",
    r"\bLX_N\(\s*",
    r"\bLX_MESSAGE\(\s*\w+\s*,\s*" + LITERAL + r"\s*,\s*",
    r"\blx_bad_file\(\s*\w+\s*,\s*\w+\s*,\s*(?=\"[a-z ]+\")",
    r"\blx_unfit_file\((?:[^;]*?),\s*(?=\"[a-z ()]+, [a-z ,()]+\"\s*\)\s*;)",
]
COMMENT = re.compile(r"/\*.*?\*/|(%s)" % LITERAL, re.DOTALL)
TEXT = re.compile("(?:%s)(%s(?:[\\s\\\\]*%s)*)" % ("|".join(BEFORE), LITERAL, LITERAL))


def quoted(text):
    return '"%s"' % text.replace("\\", "\\\\").replace('"', '\\"')


def blank(match):
    """A comment as so many lines of nothing; a literal as it is."""
    return match.group(1) or "\n" * match.group(0).count("\n")


def from_sources():
    """(file, line, C literal) of each text in the library's sources."""
    for path in sorted((ROOT / "src").rglob("*")):
        if path.suffix not in (".c", ".h", ".def"):
            continue
        source = COMMENT.sub(blank, path.read_text(encoding="utf-8"))
        for match in TEXT.finditer(source):
            parts = re.findall(LITERAL, match.group(1))
            yield path.relative_to(ROOT), source.count("\n", 0, match.start(1)) + 1, " ".join(parts)


def from_lines():
    """The same for titles of scenes and for texts that others write."""
    for path in sorted((ROOT / "data" / "scenes").glob("*.yaml")):
        title = path.read_text(encoding="utf-8").splitlines()[0]
        yield path.relative_to(ROOT), 1, quoted(title.removeprefix("# "))
    path = ROOT / "po" / "others.txt"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line and not line.startswith("#"):
            yield path.relative_to(ROOT), number, quoted(line)


def as_source():
    """All of them as C that xgettext reads, with their places."""
    lines = []
    for path, number, literal in [*from_sources(), *from_lines()]:
        lines += ['#line %d "%s"' % (number, path), "/* xgettext:no-c-format */ _(%s)" % literal]
    return "\n".join(lines) + "\n"


def real_xgettext():
    here = pathlib.Path(__file__).resolve()
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        program = pathlib.Path(folder, "xgettext")
        if os.access(program, os.X_OK) and program.resolve() != here:
            return str(program)
    sys.exit("xgettext is not installed")


def main():
    with tempfile.TemporaryDirectory() as folder:
        gathered = pathlib.Path(folder, "library.c")
        gathered.write_text(as_source(), encoding="utf-8")
        arguments = sys.argv[1:]
        if "--version" not in arguments:
            arguments.append(str(gathered))
        sys.exit(subprocess.run([real_xgettext(), *arguments], check=False).returncode)


if __name__ == "__main__":
    main()
