#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns files that built-in scenes name into a C table of names and bytes: embed_files.py OUTPUT FILE...
With --array NAME before them one file becomes the bytes of that name."""
import pathlib
import sys

EACH = 24


def main():
    array = sys.argv[2] if sys.argv[1] == "--array" else None
    output, *files = map(pathlib.Path, sys.argv[3 if array else 1:])
    arrays, entries = [], []
    for i, file in enumerate(files):
        data = file.read_bytes()
        lines = [",".join(map(str, data[k:k + EACH])) for k in range(0, len(data), EACH)]
        arrays.append(f"static const unsigned char bytes_{i}[] = {{\n" + ",\n".join(lines) + "};\n")
        entries.append(f'    {{"{file.name}", bytes_{i}, sizeof bytes_{i}}},\n')
    if array:
        output.write_text("/* Made by tools/embed_files.py. */\n"
                          f"extern const unsigned char {array}[];\n"
                          + arrays[0].replace("static const unsigned char bytes_0", f"const unsigned char {array}"),
                          encoding="ascii")
        return
    output.write_text(
        "/* Made by tools/embed_files.py from data/files/. */\n"
        '#include "base/builtin_file.h"\n\n' + "".join(arrays)
        + "\nconst struct lx_builtin_file lx_builtin_files[] = {\n" + "".join(entries) + "    {0, 0, 0},\n};\n",
        encoding="ascii",
    )


main()
