# SPDX-License-Identifier: MIT
"""The app in Russian: what stands in its window comes from the catalogue, and no English is left over."""
import os
import re

from catalogue import read

from desk import trial
from waiting import wait

CATALOGUE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "po", "ru.po")
EXPECTED = ["Open", "Save", "Undo", "Redo", "Main menu", "False colour", "Pin as A", "Sources", "Material", "Surfaces",
            "Screen and observer", "Points", "Picture", "Section", "Statistics", "Solo", "Add a source", "Intensity",
            "Attenuation", "Radius"]
POINT = re.compile(r"\d\.\d")
WORD = re.compile(r"[A-Za-z][A-Za-z]+")
# Names of things in every language: keys and kinds of scenes, forms of files; and what GTK says of itself.
NAMES = set("""Luxel report kd ks ka Ud YAML PNG Minimize Maximize Close None viridis inferno turbo coolwarm
    cividis magma plasma gray""".split())


def translations():
    return {entry.english[0]: entry.translations[0] for entry in read(CATALOGUE)
            if entry.translations and entry.translations[0] and "fuzzy" not in entry.flags}


def window_in_russian(tap, desk):
    russian = translations()
    window = desk.start().window()
    names = set(window.widget.names())
    for text in EXPECTED:
        tap.ok(russian.get(text) in names and russian.get(text) != text, "%s is called %s" % (text, russian.get(text)))
    tap.equal(window.values(), ["2,727591", "11,03802", "1,129966e-07"], "numbers have a decimal comma")
    window.pointed(*window.pixel(0, 0))  # the line at the edge speaks, too
    names |= set(window.labels())
    field = window.enter("%s" % russian.get("Intensity"), "abc")
    tap.ok(field.has("invalid"), "a wrong number is marked")
    names |= set(window.widget.names()) - {"“abc” is not a number"}
    tap.equal(sorted(name for name in names if POINT.search(name)), [], "no number has a decimal point")
    left = sorted(name for name in names if not name.startswith("Gtk")
                  and set(WORD.findall(name.replace("abc", ""))) - NAMES)
    tap.equal(left, [], "no English is left over in the window")
    tap.ok(wait("the reason", lambda: window.says("abc", "»") or window.says("abc", "”")), "the reason is said")
    window.enter("%s" % russian.get("Intensity"), "17,5")
    tap.ok(wait("the number", lambda: b"intensity: 17.5" in window.save()),
           "a decimal comma is read, a point is written")


def why(tap, desk):
    """The calculation of a value, the library's text, has commas, too, and lists that can be read with them."""
    russian = translations()
    window = desk.start().window()
    window.click(wait("a button", lambda: window.widget.find(None, russian["Why?"])))
    window.press(russian["Formula of the chosen source"], None)
    window.pointed(*window.pixel(60, -20))
    wait("the calculation", lambda: window.says("N · L"))
    said = [name for name in window.labels() if "=" in name]
    tap.equal([name for name in said if POINT.search(name)], [], "no point")
    tap.ok(any(re.search(r"\(−?[\d,]+; −?[\d,]+; −?[\d,]+\)", name) for name in said), "lists", *said)


def menus(tap, desk):
    russian = translations()
    window = desk.start().window()
    desk.key("F10")
    for text in ("New", "Open…", "Save as…", "Export", "Appearance", "Quantity", "Keyboard shortcuts", "About Luxel"):
        tap.ok(text in russian, "%s is translated" % text)
        wait("the menu", lambda: russian.get(text, text) in window.widget.names())
    tap.ok(True, "the menu is in Russian")


trial(window_in_russian, why, menus, language="ru")
