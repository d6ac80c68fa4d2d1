# SPDX-License-Identifier: MIT
"""The include rules of the house: a room may include only the rooms that stand before it, and its own.

What lies outside the library (commands, app, bindings, examples and their tests) may include the public headers
only, and what is shared by the front ends (front/); and the libraries of the desktop stay where they belong.
"""
import os
import re
import sys

from tap import Tap

# From the ground up.  Rooms of one line never include each other.
FLOORS = [["base"], ["format"], ["parameter"], ["material"], ["light", "surface"], ["scene"], ["study"],
          ["kernel"], ["world"], ["flux"],
          ["picture"], ["reflect"], ["field"], ["document"], ["api"], ["exercise", "inverse"], ["figure"]]
# The same for the desktop app, within app/.
APP_FLOORS = [["base"], ["files"], ["picture"], ["space"], ["form"], ["numbers"], ["window"]]
# Folders of programs that use the library as any other program would.
OUTSIDE = ["front", "cli", "app", "web", "bindings", "examples", "python", "tests/cli", "tests/app",
           "tests/properties"]
# Tests of a program that look inside it.
INSIDERS = {"tests/app": "app"}
# Who may include the headers of a foreign library whose name begins so.
KEEPERS = {"gtk/": "app", "glib": "app", "gio/": "app", "gdk/": "app", "cairo": "figure", "pango": "figure"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
SOURCES = (".c", ".h", ".def", ".inc", ".cpp", ".hpp")


def sources(root, folder):
    """Every source file under a folder, as a path relative to the root."""
    for where, folders, files in os.walk(os.path.join(root, folder)):
        folders.sort()
        for name in sorted(files):
            if name.endswith(SOURCES):
                yield os.path.relpath(os.path.join(where, name), root)


def includes(root, path):
    """Each include of a file: whether it stands in angle brackets, and its text."""
    with open(os.path.join(root, path), encoding="utf-8") as file:
        for bracket, target in INCLUDE.findall(file.read()):
            yield bracket == "<", target


def room_of(path):
    parts = path.split(os.sep)
    return parts[1] if parts[0] == "src" and len(parts) > 2 else None


def allowed_rooms(room, floors=FLOORS):
    """The rooms that a room may include."""
    allowed = {room}
    for floor in floors:
        if room in floor:
            return allowed
        allowed.update(floor)
    return set()


def resolve(root, path, target):
    """The file that a quoted include means, relative to the root, or None."""
    for folder in (os.path.dirname(path), "src"):
        found = os.path.normpath(os.path.join(folder, target))
        if os.path.exists(os.path.join(root, found)):
            return found
    return None


def room_faults(root, room):
    allowed = allowed_rooms(room)
    for path in sources(root, os.path.join("src", room)):
        for angle, target in includes(root, path):
            keeper = next((k for start, k in KEEPERS.items() if angle and target.startswith(start)), room)
            if keeper != room:
                yield "%s: <%s> belongs to %s" % (path, target, keeper)
            if angle:
                continue
            found = resolve(root, path, target)
            if found is None:
                yield "%s: cannot find \"%s\"" % (path, target)
            elif found.startswith("include" + os.sep):
                yield "%s: include public headers as <luxel/...>, not \"%s\"" % (path, target)
            elif room_of(found) not in allowed:
                yield "%s: %s must not include %s (\"%s\")" % (path, room, room_of(found) or found, target)


def app_faults(root, room):
    allowed = allowed_rooms(room, APP_FLOORS)
    for path in sources(root, os.path.join("app", room)):
        for angle, target in includes(root, path):
            found = None if angle else os.path.normpath(os.path.join(os.path.dirname(path), target))
            if found and found.startswith("app" + os.sep) and found.split(os.sep)[1] not in allowed:
                yield "%s: %s must not include \"%s\"" % (path, room, target)


def public_faults(root):
    for path in sources(root, "include"):
        for angle, target in includes(root, path):
            if not angle:
                yield "%s: a public header includes \"%s\" without angle brackets" % (path, target)
            elif target.endswith(".h") and "/" in target and not target.startswith("luxel/"):
                yield "%s: a public header includes <%s>" % (path, target)


def outside_faults(root, folder):
    """Programs see <luxel/...> and their own files."""
    program = INSIDERS.get(folder, folder)
    own = (folder + os.sep, program + os.sep, "front" + os.sep)
    for path in sources(root, folder):
        for angle, target in includes(root, path):
            found = None if angle else os.path.normpath(os.path.join(os.path.dirname(path), target))
            if not angle and not found.startswith(own):
                yield "%s: \"%s\" is not its own" % (path, target)
            if angle and program != "app" and any(target.startswith(start) for start in KEEPERS):
                yield "%s: <%s> has no place here" % (path, target)


def main():
    root = sys.argv[1]
    tap = Tap()
    rooms = [room for floor in FLOORS for room in floor]

    for entry in sorted(os.listdir(os.path.join(root, "src"))):
        if os.path.isdir(os.path.join(root, "src", entry)):
            tap.ok(entry in rooms, "src/%s is a room of the list" % entry)
    for room in rooms:
        if os.path.isdir(os.path.join(root, "src", room)):
            faults = list(room_faults(root, room))
            tap.ok(not faults, "src/%s includes only rooms before it" % room, *faults)
    for room in sorted(os.listdir(os.path.join(root, "app"))):
        if any(sources(root, os.path.join("app", room))):
            faults = list(app_faults(root, room))
            tap.ok(room in sum(APP_FLOORS, []) and not faults, "app/%s includes only rooms before it" % room, *faults)
    faults = list(public_faults(root))
    tap.ok(not faults, "include/luxel includes only itself and the C library", *faults)
    for folder in OUTSIDE:
        if os.path.isdir(os.path.join(root, folder)):
            faults = list(outside_faults(root, folder))
            tap.ok(not faults, "%s includes only <luxel/...> and its own files" % folder, *faults)
    tap.finish()


main()
