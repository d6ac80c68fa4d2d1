# SPDX-License-Identifier: MIT
"""A guide to adding a kind is followed in a copy of the sources: its code blocks are built, and the tool is tried.

The blocks are the kind's file, the two lines of its registry, and a scene.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tap import Tap


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


def call(*arguments, **options):
    return subprocess.run([str(a) for a in arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          errors="replace", **options)


def follow(page, what, room, name, before, attempt):
    """Builds what a page says, the file `name` in a room of src/, and calls attempt(tap, luxel, folder, scene)."""
    tap = Tap()
    root, meson = Path(sys.argv[1]), sys.argv[2]
    kind, declaration, entry, scene = code_blocks((root / page).read_text())
    with tempfile.TemporaryDirectory(prefix="luxel-%s-" % what) as place:
        folder = Path(place)
        copy_sources(root, folder / "luxel")
        add_kind(folder / "luxel" / room, name, before, kind, declaration, entry)
        # Kernels take the compiler longest: the generic ones do.
        made = call(meson, "setup", folder / "build", folder / "luxel", "-Doptimization=0", "-Dwerror=true",
                    "-Dinstruction_sets=[]")
        if made.returncode == 0:
            made = call("ninja", "-C", folder / "build", "cli/luxel")
        if tap.ok(made.returncode == 0, "the sources with the new %s build without a warning" % what,
                  made.stdout[-2000:], made.stderr[-2000:]):
            attempt(tap, folder / "build/cli/luxel", folder, scene)
    tap.finish()
