# SPDX-License-Identifier: MIT
"""Reads reports in Markdown: their tables and sentences."""
import re


def report(tool, *arguments, **environment):
    result = tool.run("report", *arguments, "-o", "r.md", **environment)
    assert (result.code, result.out, result.err) == (0, "", ""), result
    return tool.read("r.md").decode()


def rows(text):
    """The tables' rows by their first cell; cells of code without their marks."""
    return {cells[0].strip("` "): [cell.strip() for cell in cells[1:]] for cells in
            (line.strip("|").split("|") for line in text.splitlines() if line.startswith("|"))}


def near(found, wanted, relative=1e-4):
    return abs(float(found) - wanted) <= relative * abs(wanted)


def percent_of(text, sentence):
    found = re.search(sentence, text)
    return float(found.group(1)) if found else None


def says(tap, text, what, wanted, name):
    tap.equal(bool(re.search(what, text)), wanted, "%s: %s" % (name, what))
