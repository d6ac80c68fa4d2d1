# SPDX-License-Identifier: MIT
"""The catalogues are complete and up to date: who adds a text runs `make po` and translates it."""
import errno
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import catalogue
from tap import Tap

ROOT = pathlib.Path(sys.argv[1])
LUXEL = os.path.abspath(sys.argv[2])
PO = ROOT / "po"
LANGUAGES = [line for line in (PO / "LINGUAS").read_text().split("\n") if line and not line.startswith("#")]
PLACEHOLDER = re.compile(r"\{\d\}")
DIRECTIVE = re.compile(r"%(?:%|[-+ #0]*(?:\d+|\*)?(?:\.(?:\d+|\*))?(?:hh|h|ll|l|z|j|t)?[a-zA-Z])")
MIXED = re.compile(r"[a-zA-Z][а-яёА-ЯЁ]|[а-яёА-ЯЁ][a-zA-Z]")
LITERAL = r'"((?:[^"\\]|\\.)*)"'
# Files that must be in POTFILES if they have texts, and what shows that they do.
IN_C = r"\b(?:N?_|ngettext)\("
HAVE_TEXTS = [("cli/*.c", IN_C), ("cli/draw/*.c", IN_C), ("front/*.c", IN_C), ("app/*/*.c", IN_C),
              ("app/ui/*.ui", 'translatable="yes"'), ("data/desktop/*.desktop.in", ""), ("data/desktop/*.xml.in", "")]
# Properties and attributes of the app's forms whose texts people see or hear.
SHOWN = {"title", "label", "tooltip-text", "placeholder-text"}


def template(tap):
    """luxel.pot is what the sources have."""
    if not shutil.which("xgettext"):
        tap.skip("luxel.pot follows the sources", "xgettext is not installed")
        return
    arguments = re.findall(r"'(--[^']*)'", (PO / "meson.build").read_text())
    with tempfile.TemporaryDirectory() as folder:
        fresh = os.path.join(folder, "fresh.pot")
        subprocess.run([sys.executable, ROOT / "tools" / "extract_messages.py", "-D", ROOT, "-f", PO / "POTFILES",
                        "-k_", "-o", fresh, *arguments], check=True, cwd=folder)
        wanted = catalogue.english(catalogue.read(fresh))
    found = catalogue.english(catalogue.read(PO / "luxel.pot"))
    tap.ok(found == wanted, "luxel.pot follows the sources", "run: make po",
           *["new: %r" % text for text in sorted(wanted - found)],
           *["gone: %r" % text for text in sorted(found - wanted)])


def sources(tap):
    """Nothing that should be in luxel.pot escapes the extraction, found here by other means."""
    found = catalogue.english(catalogue.read(PO / "luxel.pot"))
    listed = set((PO / "POTFILES").read_text().split("\n"))
    for pattern, text in HAVE_TEXTS:
        for path in sorted(ROOT.glob(pattern)):
            if re.search(text, path.read_text(encoding="utf-8")):
                name = str(path.relative_to(ROOT))
                tap.ok(name in listed, "%s is in POTFILES" % name)
    for path in sorted(ROOT.glob("app/ui/*.ui")):
        for element in ElementTree.parse(path).iter():
            if element.get("translatable") == "yes":
                tap.ok(element.text in found, "%s: %r is in luxel.pot" % (path.name, element.text))
            elif element.get("name", element.tag) in SHOWN and re.search("[a-z]{2}", element.text or ""):
                tap.equal(element.text, "Luxel", "%s: what is not translated is a name" % path.name)

    files = sorted((ROOT / "src" / "base").glob("messages*.def"))
    messages = "".join(path.read_text(encoding="utf-8") for path in files)
    parts = LITERAL.replace("(", "(?:", 1)
    for name, literals in re.findall(r'LX_MESSAGE\((\w+),\s*"[^"]*",\s*((?:%s\s*)+)\)' % parts, messages):
        text = "".join(re.findall(LITERAL, literals)).replace('\\"', '"').replace("\\\\", "\\")
        tap.ok(text in found, "message %s is in luxel.pot" % name, text)
    tap.equal(len(re.findall(r"\nLX_MESSAGE\(\w+,\s*\"", messages)), messages.count("\nLX_MESSAGE("), "all are read")

    keys = json.loads(subprocess.check_output([LUXEL, "help", "--json"]))
    for item in [*keys["keys"], *keys["kinds"]]:
        if "label" in item:
            tap.ok(item["label"] in found, "the label of %s is in luxel.pot" % item["path"])
        tap.ok(item["meaning"] in found, "the meaning of %s is in luxel.pot" % (item.get("path") or item["name"]), item)
    scenes = json.loads(subprocess.check_output([LUXEL, "scene", "--list", "--json"]))["scenes"]
    for scene in scenes:
        tap.ok(scene["title"] in found, "the title of %s is in luxel.pot" % scene["name"])
    for number in (errno.ENOENT, errno.EACCES, errno.ENOSPC, errno.EISDIR, errno.ENOTDIR, errno.EIO, errno.EPIPE,
                   errno.EROFS, errno.EBADF, errno.ENAMETOOLONG, errno.ELOOP, errno.EMFILE, errno.EFBIG, errno.EDQUOT):
        tap.ok(os.strerror(number) in found, "the reason %s is in luxel.pot" % errno.errorcode[number])


def completeness(tap, language):
    path = PO / (language + ".po")
    entries = catalogue.read(path)
    tap.equal(catalogue.english(catalogue.read(PO / "luxel.pot")) - catalogue.english(entries), set(),
              "%s.po has every text of luxel.pot" % language)
    tap.equal([entry.english[0] for entry in entries if not all(entry.translations) or not entry.translations], [],
              "%s.po: everything is translated" % language)
    tap.equal([entry.english[0] for entry in entries if "fuzzy" in entry.flags], [],
              "%s.po: nothing is fuzzy" % language)
    if not shutil.which("msgfmt"):
        tap.skip("%s.po passes msgfmt" % language, "msgfmt is not installed")
        return
    result = subprocess.run(["msgfmt", "--check", "--statistics", "--output-file", os.devnull, path],
                            capture_output=True, encoding="utf-8", env={**os.environ, "LC_ALL": "C"}, check=False)
    tap.ok(result.returncode == 0 and re.fullmatch(r"\d+ translated messages\.\n", result.stderr),
           "%s.po passes msgfmt" % language, result.stderr)


def forms(tap, language):
    """Arguments, directives, edges and letters agree."""
    def differs(pattern, text, translation):
        return sorted(pattern.findall(text)) != sorted(pattern.findall(translation))

    def edges(text):
        return text[:len(text) - len(text.lstrip())], text[len(text.rstrip()):]

    entries = catalogue.read(PO / (language + ".po"))
    pairs = [(entry, translation) for entry in entries for translation in entry.translations]
    tap.equal([entry.english[0] for entry, text in pairs if set(PLACEHOLDER.findall(entry.english[-1])) !=
               set(PLACEHOLDER.findall(text))], [], "%s.po: the same {0}, {1} ..." % language)
    tap.equal([entry.english[0] for entry, text in pairs if "c-format" in entry.flags and
               differs(DIRECTIVE, entry.english[-1], text)], [], "%s.po: the same directives of printf" % language)
    tap.equal([entry.english[0] for entry, text in pairs if edges(entry.english[-1]) != edges(text)], [],
              "%s.po: the same blanks and line ends around" % language)
    tap.equal([text for _, text in pairs if MIXED.search(text)], [], "%s.po: no word of mixed letters" % language)
    lists = "52.5,13.4|0,0|1234,5|8,6,2.8|0.7,0.5,0.2"
    tap.equal([text for _, text in pairs if re.search(r"\d,\d", re.sub(lists, "", text))], [],
              "%s.po: no decimal comma" % language)


def main():
    tap = Tap()
    tap.run(template, tap)
    tap.run(sources, tap)
    for language in LANGUAGES:
        tap.run(completeness, tap, language)
        tap.run(forms, tap, language)
    tap.finish()


main()
