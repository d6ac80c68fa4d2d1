# SPDX-License-Identifier: MIT
"""Adds a light the way docs/ADDING-A-LIGHT.md says, in a copy of the sources, and tries it.

    test_adding_a_light.py SOURCE_FOLDER MESON

The page's own code blocks are taken: the kind's file, the two lines of the registry, the scene.  The new light
must give the same bytes as the two point sources that it is made of, and speak up in help and in errors.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tap import Tap

TWINS = "lights:\n" + "".join(
    "  - {type: point, position: [%d, 800, 2000], intensity: 10}\n" % x for x in (-150, 150))


def code_blocks(page):
    return [block for _, block in re.findall(r"^```(\w+)\n(.*?)^```$", page, re.S | re.M)]


def leave_out(path, condition, never):
    text = path.read_text()
    if condition not in text:
        raise ValueError("%s: no %r" % (path, condition))
    path.write_text(text.replace(condition, never))


def copy_sources(root, copy):
    shutil.copytree(root, copy, symlinks=True, ignore=shutil.ignore_patterns(".git", "build*", "__pycache__"))
    build = copy / "meson.build"
    # Only the library and the tool are needed, and of the kernels, which take the compiler longest, one set.
    build.write_text(re.sub(r"^\s*subdir\('(?!src'|front'|cli'|po').*\n", "", build.read_text(), flags=re.M))
    leave_out(copy / "src/shade/meson.build", "if host_machine.cpu_family() == 'x86_64'", "if false")
    leave_out(copy / "src/shade/dispatch.c", "#if defined __x86_64__", "#if 0")


def add_light(copy, kind, declaration, entry):
    light = copy / "src/light"
    (light / "pair.c").write_text(kind)
    registry = (light / "registry.c").read_text()
    registry = registry.replace("\nconst struct lx_variant", "\n" + declaration + "\nconst struct lx_variant", 1)
    (light / "registry.c").write_text(registry.replace("NULL,", entry + "NULL,", 1))
    files = light / "meson.build"
    files.write_text(files.read_text().replace("'placed.c'", "'pair.c', 'placed.c'"))


def call(*arguments, **options):
    return subprocess.run([str(a) for a in arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          errors="replace", **options)


def try_light(tap, luxel, folder, scene):
    (folder / "pair.yaml").write_text(scene)
    (folder / "twins.yaml").write_text(re.sub(r"lights:\n.*\n", lambda _: TWINS, scene))
    for name in ("pair", "twins"):
        made = call(luxel, "render", folder / (name + ".yaml"), "-o", folder / (name + ".npy"))
        tap.equal(made.returncode, 0, "the scene of the %s renders" % name)
    tap.ok((folder / "pair.npy").read_bytes() == (folder / "twins.npy").read_bytes(),
           "the pair gives the same bytes as its two points")
    tap.ok("how far the two sources are apart" in call(luxel, "help", "pair").stdout, "help knows its keys")
    wrong = call(luxel, "check", folder / "pair.yaml", "-s", "lights[0].distance=-1")
    tap.ok(wrong.returncode == 3 and "distance" in wrong.stderr, "an illegal value is an error", wrong.stderr)


def main():
    tap = Tap()
    root, meson = Path(sys.argv[1]), sys.argv[2]
    kind, declaration, entry, scene = code_blocks((root / "docs/ADDING-A-LIGHT.md").read_text())
    with tempfile.TemporaryDirectory(prefix="luxel-light-") as name:
        folder = Path(name)
        copy_sources(root, folder / "luxel")
        add_light(folder / "luxel", kind, declaration, entry)
        made = call(meson, "setup", folder / "build", folder / "luxel", "-Doptimization=0", "-Dwerror=true")
        if made.returncode == 0:
            made = call("ninja", "-C", folder / "build", "cli/luxel")
        if tap.ok(made.returncode == 0, "the sources with the new light build without a warning", made.stdout[-2000:],
                  made.stderr[-2000:]):
            try_light(tap, folder / "build/cli/luxel", folder, scene)
    tap.finish()


if __name__ == "__main__":
    main()
