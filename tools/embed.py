#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns scene files into a C table of names, titles and texts: embed.py OUTPUT SCENE..."""
import pathlib
import sys


def c_string(text):
    """A C string literal, a line of source for each line of text."""
    lines = []
    for line in text.splitlines(keepends=True):
        escaped = line.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
        lines.append(f'     "{escaped}"')
    return "\n".join(lines)


def main():
    output, *scenes = map(pathlib.Path, sys.argv[1:])
    entries = []
    for scene in scenes:
        text = scene.read_text(encoding="utf-8")
        first = text.splitlines()[0]
        if not first.startswith("# "):
            sys.exit(f"{scene}: the first line must be a comment with the scene's title")
        title = c_string(first[2:]).strip()
        entries.append(f'    {{"{scene.stem}", {title},\n{c_string(text)}}},\n')
    output.write_text(
        "/* Made by tools/embed.py from data/scenes/. */\n"
        '#include "scene/builtin.h"\n\n'
        "const struct lx_builtin lx_builtins[] = {\n" + "".join(entries) + "    {0, 0, 0},\n};\n",
        encoding="utf-8",
    )


main()
