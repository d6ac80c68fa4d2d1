#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/GALLERY.md and its pictures from the built-in scenes.

    tools/make_gallery.py [LUXEL]        (default: build/cli/luxel)

Run it after a built-in scene was added or changed.
"""
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEAD = """# Gallery

The built-in scenes, made by `tools/make_gallery.py`. Each is a file to start from: `luxel scene NAME > my.yaml`.
"""


def run(luxel, *arguments):
    return subprocess.run([luxel, *arguments], check=True, capture_output=True, text=True).stdout


def section(luxel, name, title):
    picture = "images/%s.png" % name
    run(luxel, "render", name, "-o", str(ROOT / "docs" / picture))
    scene = run(luxel, "scene", name).split("\n", 1)[1]
    return "\n## %s\n\n%s.\n\n![%s](%s)\n\n```yaml\n%s```\n" % (name, title, title, picture, scene)


def main():
    luxel = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/cli/luxel")
    (ROOT / "docs/images").mkdir(exist_ok=True)
    scenes = [line.split(None, 1) for line in run(luxel, "scene", "--list").splitlines()]
    text = HEAD + "".join(section(luxel, name, title.strip().rstrip(".")) for name, title in scenes)
    (ROOT / "docs/GALLERY.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
