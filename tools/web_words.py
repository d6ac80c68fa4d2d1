#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The words of the core in another language, for the web page: web_words.py FILE.po FILE.json FOLDERS...

Takes from a catalogue of gettext the texts that come from the folders, as a mapping from the English ones.
"""
import json
import re
import sys

ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}


def unquoted(lines):
    """The text of the quoted lines that begin a message or go on with it."""
    text = "".join(re.search(r'"(.*)"', line).group(1) for line in lines)
    return re.sub(r"\\(.)", lambda found: ESCAPES[found.group(1)], text)


def entry_of(block):
    """Where the text of a block comes from, the English text, and its translation."""
    places, parts, part = [], {"msgid": [], "msgstr": []}, None
    for line in block.splitlines():
        if line.startswith("#:"):
            places += line[2:].split()
        elif line.startswith("msg"):
            part = line.split()[0]
        if part in parts and not line.startswith("#"):
            parts[part].append(line)
    return places, unquoted(parts["msgid"]), unquoted(parts["msgstr"])


def main(catalogue, target, *folders):
    words = {}
    with open(catalogue, encoding="utf-8") as file:
        for block in file.read().split("\n\n"):
            if "msgid_plural" in block or "msgctxt" in block:
                continue
            places, english, translation = entry_of(block)
            roots = {place.split("/")[0] for place in places} | {place.rpartition("/")[0] for place in places}
            if english and translation and roots & set(folders):
                words[english] = translation
    with open(target, "w", encoding="utf-8") as file:
        json.dump(words, file, ensure_ascii=False, separators=(",", ":"))


main(*sys.argv[1:])
