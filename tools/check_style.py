# SPDX-License-Identifier: MIT
"""The form of the source files: licence line, a first paragraph, a readable length, and nothing forbidden.

Library code prints nothing, never ends the process and leaves the locale alone.
"""
import os
import re
import sys

from tap import Tap

FOLDERS = ["include", "src", "front", "cli", "app", "tests", "tools", "bench", "fuzz", "examples", "data", "web/core",
           "python"]
C_LIKE = (".c", ".h", ".def", ".inc", ".cpp", ".hpp")
LONGEST = 600
# What others made, under their own licence.
THEIRS = {os.path.join("src", "figure", "palette_turbo.h"): "Apache-2.0"}
TABLE = "_cases.h"  # numbers that a script wrote; they may be as many as they like
WIDEST = 120
# A comment's first noun is what it is about.
BEGINNING = re.compile(r"^[ \t]*(?:/\*|//| \*)[ \t]+((?:Of|The same|Likewise|So many|So much) .*)", re.MULTILINE)
FORBIDDEN = re.compile(r"(?<![\w.>])(v?f?printf|puts|fputs|putchar|perror|exit|_exit|quick_exit|abort|setlocale|assert)"
                       r"\s*\(")
COMMENT_OR_TEXT = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)


def is_script(path):
    """Whether a file without an ending begins with #!."""
    if "." in os.path.basename(path):
        return False
    with open(path, "rb") as file:
        return file.read(2) == b"#!"


def sources(root):
    for folder in FOLDERS:
        for where, folders, files in os.walk(os.path.join(root, folder)):
            folders[:] = sorted(name for name in folders if not name.startswith((".", "__")))
            for name in sorted(files):
                path = os.path.join(where, name)
                if name.endswith(C_LIKE + (".py", ".sh")) or is_script(path):
                    yield os.path.relpath(path, root)


def first_paragraph(path, text):
    """Whether the file begins with its licence, and after that tells what it is for."""
    lines = text.split("\n")
    if lines[0].startswith("#!"):
        lines = lines[1:]
    head = "\n".join(lines)
    if path.endswith(C_LIKE):
        licence = r"/\* SPDX-License-Identifier: %s \*/\n" % re.escape(THEIRS.get(path, "MIT"))
        paragraph = r"/\*\s*\n? ?\*? ?\w"
    else:
        licence = r"# SPDX-License-Identifier: MIT\n"
        paragraph = r'(""".*\w|# \w)'
    if not re.match(licence, head):
        return "no SPDX line at the top"
    if not re.match(licence + r"\n?" + paragraph, head):
        return "no paragraph that says what the file is for"
    return None


def layout_faults(text):
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > WIDEST:
            yield "line %d is %d columns wide" % (number, len(line))
        if line != line.rstrip():
            yield "line %d ends with blanks" % number
        if "\t" in line:
            yield "line %d has a tab" % number
    if text and not text.endswith("\n"):
        yield "the last line has no end"


def forbidden_calls(text):
    """Calls that a library must not make, with their lines."""
    bare = COMMENT_OR_TEXT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    for match in FORBIDDEN.finditer(bare):
        yield "line %d calls %s()" % (bare.count("\n", 0, match.start()) + 1, match.group(1))


def main():
    root = sys.argv[1]
    tap = Tap()
    heads, lengths, layouts, calls, beginnings = [], [], [], [], []

    for path in sources(root):
        with open(os.path.join(root, path), encoding="utf-8") as file:
            text = file.read()
        head = first_paragraph(path, text)
        length = text.count("\n")
        heads += ["%s: %s" % (path, head)] if head else []
        lengths += ["%s: %d lines" % (path, length)] if length > LONGEST and not path.endswith(TABLE) else []
        layouts += ["%s: %s" % (path, fault) for fault in layout_faults(text)]
        if path.startswith("src" + os.sep):
            calls += ["%s: %s" % (path, fault) for fault in forbidden_calls(text)]
        beginnings += ["%s: %s" % (path, match) for match in BEGINNING.findall(text)]
    tap.ok(not heads, "every file has its licence line and says what it is for", *heads)
    tap.ok(not lengths, "no file is longer than %d lines" % LONGEST, *lengths)
    tap.ok(not layouts, "no line is wider than %d columns, has tabs or ends with blanks" % WIDEST, *layouts)
    tap.ok(not beginnings, "comments begin with their subject", *beginnings)
    tap.ok(not calls, "the library neither prints nor exits nor touches the locale", *calls)
    tap.finish()


main()
