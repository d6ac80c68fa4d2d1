# SPDX-License-Identifier: MIT
"""Reads gettext catalogues: entries with their texts in both languages."""
import re

KEYWORD = re.compile(r'^(msgctxt|msgid|msgid_plural|msgstr(?:\[\d+\])?) (".*")$')


def _text(literal):
    return re.sub(r'\\(.)', lambda match: {"n": "\n", "t": "\t", "r": "\r"}.get(match.group(1), match.group(1)),
                  literal[1:-1])


class Entry:
    """One text: its English forms and their translations; the flags that stand above it."""

    def __init__(self):
        self.english, self.translations, self.flags = [], [], set()


def read(path):
    """The entries of a catalogue, without its header and without what is obsolete."""
    entries, texts = [Entry()], None
    with open(path, encoding="utf-8") as file:
        for line in [*file.read().splitlines(), ""]:
            keyword = KEYWORD.match(line)
            if keyword:
                texts = entries[-1].english if keyword.group(1).startswith("msgid") else entries[-1].translations
                texts.append(_text(keyword.group(2)))
            elif line.startswith('"'):
                texts[-1] += _text(line)
            elif line.startswith("#, "):
                entries[-1].flags |= set(line[3:].split(", "))
            elif not line:
                entries.append(Entry())
    return [entry for entry in entries if entry.english and entry.english[0]]


def english(entries):
    return {text for entry in entries for text in entry.english}
