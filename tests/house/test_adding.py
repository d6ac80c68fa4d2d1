# SPDX-License-Identifier: MIT
"""Adds a light, a surface, an emitter and a lobe as the guides in docs/ say, in a copy of the sources, and tries them.

    test_adding.py SOURCE_FOLDER MESON

The pages' own code blocks are taken: of each the kind's file, of an emitter its row, its lines elsewhere, and a scene.
"""
import re
import shutil
import sys
import tempfile
from pathlib import Path

import adding_a_light
import adding_a_lobe
import adding_a_surface
import adding_an_emitter
from calling import call
from tap import Tap

GUIDES = (adding_a_light.GUIDE, adding_a_surface.GUIDE, adding_an_emitter.GUIDE)


def code_blocks(page):
    return [block for _, block in re.findall(r"^```(\w+)\n(.*?)^```$", page, re.S | re.M)]


def copy_sources(root, copy):
    shutil.copytree(root, copy, symlinks=True, ignore=shutil.ignore_patterns(".git", "build*", "__pycache__"))
    build = copy / "meson.build"
    # Only the library and the tool are needed.
    build.write_text(re.sub(r"^\s*subdir\('(?!src'|front'|cli'|po').*\n", "", build.read_text(), flags=re.M))


def add_kind(room, name, before, kind, declaration, entry):
    """Writes the file of a kind, lists it before another file of its room, and adds its lines to the registry."""
    (room / name).write_text(kind)
    registry = (room / "registry.c").read_text()
    registry = registry.replace("\nconst struct lx_variant", "\n" + declaration + "\nconst struct lx_variant", 1)
    (room / "registry.c").write_text(registry.replace("NULL,", entry + "NULL,", 1))
    files = room / "meson.build"
    files.write_text(files.read_text().replace("'%s'" % before, "'%s', '%s'" % (name, before)))


def add_row(sources, row):
    """Adds the row of an emitter behind the last one of its list."""
    header = sources / "src/light/emitter.h"
    last = r"(#define LX_EMITTER_KINDS(?:.*\\\n)+.*)\n"
    header.write_text(re.sub(last, lambda rows: rows.group(1) + " \\\n" + row, header.read_text(), count=1))


def main():
    tap = Tap()
    root, meson = Path(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory(prefix="luxel-adding-") as place:
        folder = Path(place)
        copy_sources(root, folder / "luxel")
        scenes = []
        for page, room, name, before, _ in GUIDES:
            kind, *rows, declaration, entry, scene = code_blocks((root / page).read_text())
            for row in rows:
                add_row(folder / "luxel", row)
            add_kind(folder / "luxel" / room, name, before, kind, declaration, entry)
            scenes.append(scene)
        lobe_scene = adding_a_lobe.add(folder / "luxel", code_blocks((root / adding_a_lobe.PAGE).read_text()))
        # Kernels take the compiler longest: those for every processor do.
        made = call(meson, "setup", folder / "build", folder / "luxel", "-Doptimization=0", "-Dwerror=true",
                    "-Dinstruction_sets=[]")
        if made.returncode == 0:
            made = call("ninja", "-C", folder / "build", "cli/luxel")
        if tap.ok(made.returncode == 0, "the sources with the new kinds build without a warning",
                  made.stdout[-2000:], made.stderr[-2000:]):
            for (*_, attempt), scene in zip(GUIDES, scenes):
                attempt(tap, folder / "build/cli/luxel", folder, scene)
            adding_a_lobe.try_lobe(tap, folder / "build/cli/luxel", folder, lobe_scene)
    tap.finish()


main()
