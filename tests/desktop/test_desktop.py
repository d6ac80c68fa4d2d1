# SPDX-License-Identifier: MIT
"""What makes luxel-app part of a desktop: menu entry, catalogue entry, type of scenes, settings, icons, man page.

    test_desktop.py SOURCES BUILT_FOLDER LUXEL_APP
"""
import configparser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np
from tap import Tap

ROOT, BUILT, APP = (pathlib.Path(path).resolve() for path in sys.argv[1:4])
SOURCES = ROOT / "data" / "desktop"
ID = "org.luxel.Luxel"
SCENE = "application/x-luxel-scene"
LANGUAGES = [line for line in (ROOT / "po" / "LINGUAS").read_text().split("\n") if line and not line.startswith("#")]
LANG = "{http://www.w3.org/XML/1998/namespace}lang"
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"
# What a file manager must take for a scene, and what not: name, first bytes, type.
FILES = [
    ("a.luxel.yaml", "a: 1\n", SCENE), ("a.luxel.yml", "a: 1\n", SCENE), ("a.luxel.json", "{}", SCENE),
    ("bare", "luxel: 1\n", SCENE), ("titled", "# A lamp\n# and its shade\nluxel: 1\n", SCENE),
    ("marked", "---\nluxel: 1\n", SCENE), ("json", '{\n  "luxel": 1,\n', SCENE), ("dense", '{"luxel":1}', SCENE),
    ("own.yaml", "# A lamp\nluxel: 1\n", SCENE), ("own.yml", "luxel: 1\n", SCENE),
    ("other.yaml", "a: 1\n", "application/x-yaml"), ("other.yml", "# luxel\na: 1\n", "application/x-yaml"),
    ("other.json", '{"a": 1}', "application/json"),
    ("script", "#!/bin/sh\necho luxel\n", "application/x-shellscript"),
    ("guide.md", "# Luxel\n\nluxel: 1\n", "text/markdown"), ("note.txt", "a luxel: 1\n", "text/plain"),
]


class Missing(Exception):
    """A program that this test needs is not installed."""


def run(*command, environment=None):
    if not shutil.which(command[0]):
        raise Missing("%s is not installed; tools/setup installs it" % command[0])
    return subprocess.run([str(word) for word in command], capture_output=True, timeout=60,
                          env={**os.environ, **(environment or {})})


def succeeds(tap, name, *command, environment=None):
    """A case that the command ends well; gives what it printed."""
    done = run(*command, environment=environment)
    said = (done.stdout + done.stderr).decode("utf-8", "replace")
    tap.ok(done.returncode == 0, name, " ".join(map(str, command)), said)
    return said


def menu_entry():
    parser = configparser.RawConfigParser(delimiters="=", interpolation=None)
    parser.optionxform = str
    parser.read(BUILT / (ID + ".desktop"), encoding="utf-8")
    return parser["Desktop Entry"]


def menu(tap):
    said = succeeds(tap, "the menu entry is valid", "desktop-file-validate", BUILT / (ID + ".desktop"))
    tap.ok("warning" not in said, "without warnings", said)
    entry = menu_entry()
    tap.equal(entry["Exec"].split(), [APP.name, "%F"], "it starts the app with files")
    tap.equal(entry["MimeType"], SCENE + ";", "it opens scenes, and claims nothing else")
    tap.equal(entry["Icon"], ID, "its icon")


def catalogue(tap):
    path = BUILT / (ID + ".metainfo.xml")
    succeeds(tap, "the catalogue entry is valid", "appstreamcli", "validate", "--no-net", path)
    root = ElementTree.parse(path).getroot()
    tap.equal(root.findtext("id"), ID, "its name")
    tap.equal(root.findtext("launchable"), ID + ".desktop", "it starts the menu entry")
    tap.equal(root.findtext("provides/binary"), APP.name, "it provides the app")
    tap.equal(root.findtext("provides/mediatype"), SCENE, "it provides the type of scenes")
    version = re.search(r"version: '([\d.]+)'", (ROOT / "meson.build").read_text()).group(1)
    releases = [release.get("version") for release in root.findall("releases/release")]
    tap.equal(releases[:1], [version], "its newest release is this one")
    changes = re.findall(r"^## (\S+)$", (ROOT / "CHANGELOG.md").read_text(), re.M)
    tap.equal(releases, changes, "its releases are those of CHANGELOG.md")


def type_of_scenes(tap):
    with tempfile.TemporaryDirectory() as folder:
        packages = pathlib.Path(folder, "mime", "packages")
        packages.mkdir(parents=True)
        shutil.copy(BUILT / (ID + ".xml"), packages)
        environment = {"XDG_DATA_HOME": folder, "XDG_DATA_DIRS": "/usr/local/share:/usr/share",
                       "GIO_USE_VFS": "local"}
        said = succeeds(tap, "the type of scenes is valid", "update-mime-database", packages.parent,
                        environment=environment)
        tap.ok("rror" not in said and "arning" not in said, "without warnings", said)

        def type_of(path):
            said = run("gio", "info", "-a", "standard::content-type", path, environment=environment).stdout.decode()
            return "".join(re.findall(r"content-type: (\S+)", said))

        for name, text, expected in FILES:
            path = pathlib.Path(folder, name)
            path.write_text(text)
            tap.equal(type_of(path), expected, "the type of %s with %r" % (name, text))
        for path in sorted((ROOT / "data" / "scenes").glob("*.yaml")):
            tap.equal(type_of(path), SCENE, "the type of the built-in scene " + path.name)


def settings(tap):
    succeeds(tap, "the settings are valid", "glib-compile-schemas", "--strict", "--dry-run", SOURCES)
    for key in ElementTree.parse(SOURCES / (ID + ".gschema.xml")).getroot().iter("key"):
        tap.ok(key.findtext("summary") and key.findtext("description"), "%s is described" % key.get("name"))
    environment = {"GSETTINGS_SCHEMA_DIR": str(BUILT), "GSETTINGS_BACKEND": "memory"}
    found = succeeds(tap, "the build folder has them compiled", "gsettings", "list-recursively", ID,
                     environment=environment)
    values = dict(line.split(" ", 2)[1:] for line in found.splitlines())
    tap.equal(values.get("palette"), "'viridis'", "the colour map at first")
    tap.equal(values.get("color-scheme"), "'system'", "the colour scheme at first")
    for key, value in ("color-scheme", "pink"), ("window-width", "0"), ("left-width", "-1"):
        done = run("gsettings", "set", ID, key, value, environment=environment)
        tap.ok(done.returncode != 0, "%s is not set to %s" % (key, value), done)


def pixels(path, size):
    """Red, green, blue, alpha (0 to 255) of an icon drawn at a size."""
    with tempfile.TemporaryDirectory() as folder:
        png = os.path.join(folder, "icon.png")
        for command in (["rsvg-convert", "-w", size, "-h", size, "-o", png, path],
                        ["convert", png, "-depth", "8", "rgba:-"]):
            done = run(*command)
            if done.returncode != 0:
                raise RuntimeError(done.stderr.decode())
    return np.frombuffer(done.stdout, dtype=np.uint8).reshape(size, size, 4).astype(float)


def icons(tap):
    folder = SOURCES / "icons" / "hicolor"
    for icon in sorted(folder.rglob("*.svg")):
        done = run("gdk-pixbuf-pixdata", icon, os.devnull)
        tap.equal(done.stderr, b"", "the desktop's own reader knows %s" % icon.name)
    for size in 16, 24, 32, 48, 64, 128, 256, 512:
        picture = pixels(folder / "scalable" / "apps" / (ID + ".svg"), size)

        def brightness(x, y):
            """At a place of the drawing, which is 128 wide."""
            red, green, blue, _ = picture[int(y * size / 128), int(x * size / 128)]
            return 0.299 * red + 0.587 * green + 0.114 * blue

        tap.ok(0.6 < picture[..., 3].mean() / 255 < 0.85 and picture[0, 0, 3] == 0,
               "the icon at %d is a rounded square" % size)
        values = [brightness(*place) for place in ((61, 61), (80, 80), (92, 92))]
        tap.ok(values[0] > 225 > 150 > values[1] > 1.5 * values[2], "from highlight to shadow at %d" % size, values)
    for size in 16, 32, 64:
        picture = pixels(folder / "symbolic" / "apps" / (ID + "-symbolic.svg"), size)
        inked = picture[..., 3] == 255
        tap.ok(0.2 < picture[..., 3].mean() / 255 < 0.6, "the symbolic icon at %d is neither empty nor full" % size)
        tap.equal(len(np.unique(picture[inked][:, :3], axis=0)), 1, "it has one colour")


def translations(tap):
    listed = (ROOT / "po" / "POTFILES").read_text().split("\n")
    for name in (".desktop.in", ".metainfo.xml.in", ".xml.in"):
        tap.ok("data/desktop/%s%s" % (ID, name) in listed, "%s%s is in po/POTFILES" % (ID, name))
    entry = menu_entry()
    catalogue_entry = ElementTree.parse(BUILT / (ID + ".metainfo.xml")).getroot()
    kind = ElementTree.parse(BUILT / (ID + ".xml")).getroot()
    for language in LANGUAGES:
        for key in "GenericName", "Comment", "Keywords":
            translated = entry.get("%s[%s]" % (key, language))
            tap.ok(translated and translated != entry[key], "%s of the menu entry in %s" % (key, language), translated)
        for tag in "summary", "description/p", "description/ul/li", "releases/release/description/p":
            texts = [text.get(LANG) for text in catalogue_entry.findall(tag)]
            tap.equal(texts.count(language), texts.count(None), "%s of the catalogue entry in %s" % (tag, language))
        tap.ok(language in [text.get(LANG) for text in kind.iter(MIME + "comment")],
               "the type of scenes in " + language)


def man_page(tap):
    path = BUILT / "luxel-app.1"
    text = path.read_text(encoding="ascii")
    tap.ok(re.search(r'^\.TH LUXEL\\-APP 1 \S+ "luxel \d', text, re.M), "the man page tells its version", text[:200])
    known = run(APP, "--help", environment={"DISPLAY": "", "WAYLAND_DISPLAY": ""}).stdout.decode()
    options = set(re.findall(r"^ +(?:-\w, )?(--[\w-]+)", known, re.M)) - set(re.findall(r"--help-\w+", known))
    described = set(re.findall(r"--[\w-]+", text.replace("\\-", "-")))
    tap.equal(described, options | {"--help"}, "the man page has the options of luxel-app --help")
    for checker, arguments in ("groff", ["-ww", "-t", "-man", "-Tutf8"]), ("mandoc", ["-Tlint"]):
        if shutil.which(checker):
            done = run(checker, *arguments, path)
            faults = done.stderr if checker == "groff" else done.stdout
            tap.ok(done.returncode == 0 and not faults, "%s finds no fault in the man page" % checker, faults.decode())


def speech(tap):
    """Texts reach the terminal in letters that it has."""
    for language in LANGUAGES:
        environment = {"LC_ALL": "", "LANG": "C.UTF-8", "LANGUAGE": language, "DISPLAY": "", "WAYLAND_DISPLAY": ""}
        said = run(APP, "--help", environment=environment).stdout.decode()
        tap.ok(said.count("?") < 3 and not said.isascii(), "luxel-app --help in " + language, said)


def main():
    tap = Tap()
    for part in menu, catalogue, type_of_scenes, settings, icons, translations, man_page, speech:
        tap.run(part, tap)
    tap.finish()


main()
