#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns the plain comments of a public header into Doxygen's: doxygen_filter.py HEADER.

The first paragraph becomes the page of the file, a comment before a declaration that declaration's text, and one
behind a member or a value its text.  The statuses that a function's comment lists become a table.  Lines stay where
they are, so that warnings name the line of the header.
"""
import re
import sys

COMMENT = re.compile(r"/\*(.*?)\*/", re.DOTALL)
LICENCE = "SPDX-License-Identifier"
# What Doxygen or Markdown would take for markup.
MARKUP = re.compile(r"[\\<>#@%&]")
CODE_INDENT = 5
STATUS = re.compile(r"\b(LUXEL_ERROR_\w+|LUXEL_CANCELLED)(?:: |\.)")


def escape(line):
    """A line of prose, with nothing left in it that would be markup; a line of code stays as it is."""
    bare = re.sub(r"^\s*\*", "", line)
    return line if len(bare) - len(bare.lstrip()) >= CODE_INDENT else MARKUP.sub(r"\\\g<0>", line)


def returned(text):
    """The text with "LUXEL_ERROR_X: why." as a row of the table of returned values."""
    return STATUS.sub(lambda match: r"@retval %s " % match.group(1), text)


def converted(match, source):
    """What stands in the place of one comment.

    The licence line opens the file's page, the first paragraph fills it.
    """
    inside = match.group(1)
    before = source[source.rfind("\n", 0, match.start()) + 1:match.start()]
    above = source[:match.start()]
    if LICENCE in inside:
        return "/** @file"
    text = "\n".join(map(escape, inside.split("\n")))
    if not COMMENT.sub("", above).strip():
        return "  " + text + "*/" if LICENCE in above else "/** @file\n" + text + "*/"
    if before.lstrip().startswith("#"):
        return match.group(0)
    return "/**<" + text + "*/" if before.strip() else "/**" + returned(text) + "*/"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        source = file.read()
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(COMMENT.sub(lambda match: converted(match, source), source))


main()
