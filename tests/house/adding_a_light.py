# SPDX-License-Identifier: MIT
"""The light that docs/ADDING-A-LIGHT.md adds (test_adding.py).

The new light must give the same bytes as the two point sources that it is made of, and speak up in help and in errors.
"""
import re

from calling import call

TWINS = "lights:\n" + "".join(
    "  - {type: point, position: [%d, 800, 2000], intensity: 10}\n" % x for x in (-150, 150))


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


GUIDE = ("docs/ADDING-A-LIGHT.md", "src/light", "pair.c", "placed.c", try_light)
