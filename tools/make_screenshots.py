#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the pictures of the app that the READMEs show: docs/images/app-en.png and app-ru.png.

    tools/make_screenshots.py [BUILD_FOLDER]        (default: build)

Run it after the app's looks or their words have changed.  It needs what the tests of the app need (tools/setup).
"""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build")
SIZE = (1280, 800)
SECTION = {"en": "Section", "ru": "Сечение"}

# The desk of the tests takes the programs from the arguments.
sys.argv[1:] = [str(BUILD / part) for part in ("cli/luxel", "app/luxel-app", "data/desktop")]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests/app/ui")]
from desk import Desk  # noqa: E402
from waiting import wait  # noqa: E402


def make(language, path):
    with Desk(language, SIZE) as desk:
        window = desk.start().window()
        window.act("new", "three-lights")
        wait("the scene", lambda: len(window.sources()) == 3)
        window.act("false-color")
        window.press(SECTION[language], "tab")
        wait("the section", lambda: window.says("x = 0, y = 0"))
        wait("where the pointer is", lambda: window.pointed(*window.pixel(-110, 130)))
        desk.hand("sleep", "1")  # until all is painted
        desk.picture(path)


def main():
    for language in SECTION:
        make(language, ROOT / "docs/images" / ("app-%s.png" % language))


if __name__ == "__main__":
    main()
