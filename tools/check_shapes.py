# SPDX-License-Identifier: MIT
"""Surfaces and emitters answer for themselves: nothing outside src/surface asks which shape a surface has, and
nothing outside src/light which kind an emitter is of.

Nor does it ask of which type the sheets of its sides are.  The kernels stand by shape in their table, which
world/general.h and general.c read; the structs of what users write are seen by the kinds, and by tests, alone.
"""
import re
import sys
from pathlib import Path

from tap import Tap

# An outline of a planar source is a shape, too, of another kind (light/spread.c), and so is a group of parameters.
ASKS = re.compile(r"\bLX_SPHERE\b|\bLX_PLATE\b|\bLX_GENERAL\b|\bLX_SHAPE_TYPES\b|\benum lx_shape_type\b|"
                  r"\bshape(?:\.|->)type\b(?! [!=]= LX_GROUP)|\blx_(?:sphere|plate)_parameters\b|surface/authored\.h|"
                  r"\blx_(?:plate|triangle|disk|tube|ball)_sheet\b|"
                  r"\blx_(?:sphere|plate|disk|cylinder|mesh|room|inside)_kind\b|"
                  r"variant->name, \"(?:sphere|rectangle|disk|cylinder)\"")
# Emitters tell what they are by light/emitter_kind.h; kernels stand by type in their table.
ASKS_EMITTER = re.compile(r"\bLX_(?:POINT|DIRECTION|UNIFORM|FACETS|DISK|BALL|CYLINDER)\b|"
                          r"\bemitter(?:->|\.)type\b(?!,$)|"
                          r"\bshell(?:->|\.)type (?:[!=]=|\?)")
MAY_ASK_EMITTER = re.compile(r"^src/(light/|kernel/kernel\.c$)")
MAY_ASK = re.compile(r"^src/(surface/|kernel/[a-z_]*|world/(kernel[a-z_]*|general)\.[ch]$|light/)")


def find_askers(root, asks, may_ask):
    for folder in ("src", "cli", "app", "front", "python"):
        for path in sorted((root / folder).rglob("*.[ch]")):
            name = path.relative_to(root).as_posix()
            if may_ask.match(name):
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if asks.search(line):
                    yield "%s:%d: %s" % (name, number, line.strip())


def main():
    tap = Tap()
    root = Path(sys.argv[1])
    askers = list(find_askers(root, ASKS, MAY_ASK))
    tap.ok(not askers, "nothing outside src/surface asks which shape a surface has", *askers)
    askers = list(find_askers(root, ASKS_EMITTER, MAY_ASK_EMITTER))
    tap.ok(not askers, "nothing outside src/light asks which kind an emitter is of", *askers)
    tap.ok(list((root / "src/surface").glob("*.c")), "there are kinds of surfaces")
    tap.finish()


if __name__ == "__main__":
    main()
