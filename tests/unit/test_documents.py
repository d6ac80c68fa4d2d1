# SPDX-License-Identifier: MIT
"""Documents as others read them: HTML and its MathML are well-formed and link nowhere, LaTeX's groups are closed.

Argument: the program write_documents.
"""
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from tap import Tap

NAMES = ("english", "russian", "hostile", "long")
CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "mover": 2, "munderover": 3}
LEAVES = {"mi", "mn", "mo", "mtext", "mspace"}
BRANCHES = {"math", "mrow", "msqrt", "mtable", "mtr", "mtd"} | set(CHILDREN)


def check_formula(tap, name, element):
    """Each element is known, has the children that its kind has, and text only where it may."""
    wrong = []
    for part in element.iter():
        if part.tag in LEAVES:
            good = len(part) == 0
        else:
            good = part.tag in BRANCHES and not (part.text or "").strip()
            good = good and len(part) == CHILDREN.get(part.tag, len(part))
        wrong += [] if good else [ElementTree.tostring(part, "unicode")]
    if wrong:
        tap.ok(False, "%s: MathML" % name, *wrong)
    return not wrong


def check_html(tap, name, text):
    tap.ok(text.startswith("<!DOCTYPE html>\n"), name + ": doctype")
    root = ElementTree.fromstring(text[len("<!DOCTYPE html>\n"):])
    tap.equal(root.tag, "html", name + ": root")
    tags = {element.tag for element in root.iter()}
    tap.ok(not tags & {"script", "link", "iframe", "object", "embed", "a"}, name + ": nothing that loads or runs", tags)
    sources = [element.get(key) for element in root.iter() for key in ("src", "href") if element.get(key)]
    tap.ok(all(source.startswith("data:image/png;base64,") for source in sources), name + ": no outside links", sources)
    tap.ok("url(" not in text and "@import" not in text, name + ": no outside styles")
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    tap.equal(len(ids), len(set(ids)), name + ": ids differ")
    formulas = list(root.iter("math"))
    tap.ok(all([check_formula(tap, name, formula) for formula in formulas]), name + ": formulas", len(formulas))
    tap.ok(name == "hostile" or len(formulas) > 7, name + ": has formulas")
    for table in root.iter("table"):
        widths = {len(row) for row in table.iter("tr")}
        tap.equal(len(widths), 1, name + ": rows are as wide as each other")


def check_latex(tap, name, text):
    bare = re.sub(r"\\\\|\\[{}$&#%_]", "", text)  # what is escaped opens and closes nothing
    depth, least = 0, 0
    for character in bare:
        depth += (character == "{") - (character == "}")
        least = min(least, depth)
    tap.ok(depth == 0 and least == 0, name + ": braces", depth, least)
    tap.equal(bare.count("$") % 2, 0, name + ": dollars")
    open_ones = []
    for kind, what in re.findall(r"\\(begin|end)\{([^}]*)\}", bare):
        if kind == "begin":
            open_ones.append(what)
        else:
            tap.ok(open_ones and open_ones.pop() == what, "%s: end of %s" % (name, what))
    tap.equal(open_ones, [], name + ": all is closed")


def check_markdown(tap, name, text):
    lines = [line for line in text.split("\n") if line.startswith("|")]
    cells = {len(re.findall(r"(?<!\\)\|", line)) for line in lines}
    tap.ok(len(cells) <= 2, name + ": rows are as wide as their table", cells)
    tap.ok(not re.search(r"^<", re.sub(r"^(```+).*?^\1$", "", text, flags=re.M | re.S), re.M), name + ": no HTML")


def main():
    tap = Tap()
    with tempfile.TemporaryDirectory() as folder:
        tap.equal(subprocess.run([sys.argv[1], folder], check=False).returncode, 0, "the program writes")
        for name in NAMES:
            for ending, check in ((".html", check_html), (".tex", check_latex), (".md", check_markdown)):
                with open(os.path.join(folder, name + ending), encoding="utf-8") as file:
                    check(tap, name, file.read())
    tap.finish()


main()
