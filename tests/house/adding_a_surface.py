# SPDX-License-Identifier: MIT
"""The surface that docs/ADDING-A-SURFACE.md adds (test_adding.py).

The new surface, a ring, must look as the disk that it is cut out of, show through its hole what is behind, take away
the light that the disk takes and the disk in its hole does not, reflect what these reflect, have a true maximum, and
speak up in help and errors.
"""
import json
import re

import numpy

from calling import call


def disk_instead(scene, radius):
    return re.sub(r"type: ring(.*?)radius: \d+, hole: \d+", r"type: disk\1radius: %d" % radius, scene)


class Pictures:
    """Values of a scene with the ring, and with disks of both of its radii, or none, in its place."""

    def __init__(self, tap, luxel, folder, scene):
        outer, hole = (int(number) for number in re.search(r"radius: (\d+), hole: (\d+)", scene).groups())
        texts = {"ring": scene, "outer": disk_instead(scene, outer), "inner": disk_instead(scene, hole),
                 "none": re.sub(r".*type: ring.*\n", "", scene)}
        for name, text in texts.items():
            (folder / (name + ".yaml")).write_text(text)
            made = call(luxel, "render", folder / (name + ".yaml"), "--precision", "double", "-o",
                        folder / (name + ".npy"))
            tap.ok(made.returncode == 0, "the scene with %s renders" % name, made.stderr)
            setattr(self, name, numpy.load(folder / (name + ".npy")))


def compare(tap, pictures):
    """Where the disks differ from the floor alone is known, and so is what the ring has to show everywhere."""
    changed_by_outer = pictures.outer != pictures.none
    changed_by_inner = pictures.inner != pictures.none
    expected = numpy.where(changed_by_outer, pictures.outer, pictures.none)
    # In the hole, and in the light that falls through it, there is what is behind: but only where the ring itself
    # neither is seen nor takes the light, of which the ring's own picture tells by being the floor's.
    open_to_both = changed_by_inner & (pictures.ring == pictures.none)
    expected = numpy.where(open_to_both, pictures.none, expected)
    # What is seen through the hole may lie in the ring's own shadow, which nothing else lights.
    close = numpy.abs(pictures.ring - expected) <= 1e-11 * pictures.none.max()
    close |= changed_by_inner & (pictures.ring == 0) & (pictures.none > 0)
    tap.ok(close.all(), "the ring shows what the disk shows, and its hole what is behind",
           "%d pixels differ" % (~close).sum())
    tap.ok(open_to_both.sum() > 100 and (changed_by_outer & ~changed_by_inner).sum() > 500,
           "both are seen in many pixels", str(open_to_both.sum()))
    # Nothing but what the disk in the hole changes differs between the ring and the whole disk.
    tap.ok(not ((numpy.abs(pictures.ring - pictures.outer) > 1e-11 * pictures.none.max()) & ~changed_by_inner).any(),
           "outside of the hole and its light the ring is the disk")
    lost = changed_by_inner & ~open_to_both
    tap.ok(lost.sum() < 0.5 * changed_by_inner.sum(), "most of what the hole opens is open", str(lost.sum()))


# A ring upright over a floor, lit from one side; by one bounce each place of the floor has what the ring sends there.
REFLECTING = """luxel: 1
screen: {width: 800, height: 800, resolution: [16, 16]}
observer: {z: 2500, projection: perspective}
reflections: %s
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [800, 800], material: {model: lambert, diffuse: 0.5, over_pi: true}}
  - {type: %s, center: [0, 0, 400], axis: [1, 0, 0.1], material: {model: lambert, diffuse: 0.8, over_pi: true}}
lights:
  - {type: point, position: [350, 0, 200], intensity: 10}
"""


def reflected(luxel, folder, bounces, surface):
    (folder / "reflecting.yaml").write_text(REFLECTING % (bounces, surface))
    made = call(luxel, "probe", folder / "reflecting.yaml", "--at", "100,0,0,0,0,1", "--quantity", "irradiance",
                "--json", "--reflected-error", "1e-4")
    return json.loads(made.stdout)["points"][0]["reflected"] if made.returncode == 0 else made


def try_reflections(tap, luxel, folder):
    """The ring sends on what a disk does, less what its hole would; without sides it is refused, not black."""
    ring = reflected(luxel, folder, 1, "ring, radius: 150, hole: 60")
    disk, hole = (reflected(luxel, folder, 1, "disk, radius: %d" % radius) for radius in (150, 60))
    off = abs(ring["irradiance"] - (disk["irradiance"] - hole["irradiance"]))
    tap.ok(ring["error"] < 2e-3 * ring["irradiance"] and off <= ring["error"] + disk["error"] + hole["error"],
           "by one bounce it sends what the disk sends and the disk in its hole does not", str((ring, disk, hole)))
    narrow, whole = (reflected(luxel, folder, "all", surface) for surface in
                     ("ring, radius: 150, hole: 0.01", "disk, radius: 150"))
    tap.ok(narrow["irradiance"] > 1 and
           abs(narrow["irradiance"] - whole["irradiance"]) <= narrow["error"] + whole["error"],
           "with next to no hole it reflects as the disk does", str((narrow, whole)))
    kind = folder / "luxel/src/surface/ring.c"
    sides = r"/\* Its sides.*?^}\n\n|    \.sheets = ring_sheets,\n"
    kind.write_text(re.sub(sides, "", kind.read_text(), flags=re.S | re.M))
    made = call("ninja", "-C", folder / "build", "cli/luxel")
    tap.ok(made.returncode == 0, "it builds without sides", made.stdout[-2000:])
    bare = reflected(luxel, folder, 1, "ring, radius: 150, hole: 60")
    tap.ok(not isinstance(bare, dict) and bare.returncode == 3 and
           "surfaces of kind ring cannot reflect light" in bare.stderr, "without sides it is refused", str(bare))


# Each line of the silhouette of the last surface, as the app's plan and the page's space view ask for it: how many
# places it has, and the area that it goes around.
OUTLINES = r"""
#include <luxel/luxel.h>
#include <stdio.h>

int main(int count, char **names)
{
    const double right[3] = {1, 0, 0}, up[3] = {0, 1, 0};
    luxel_scene *scene;
    luxel_silhouette *seen;
    if (count != 2 || luxel_scene_read_file(names[1], NULL, &scene) || luxel_scene_commit(scene, NULL) ||
        luxel_find_silhouette(scene, luxel_scene_surface_count(scene) - 1, right, up, &seen))
        return 1;
    for (size_t i = 0; i < seen->count; i++) {
        const luxel_silhouette_line *line = &seen->lines[i];
        double area = 0;
        for (size_t k = 0; k < line->count; k++) {
            const double *a = line->places_mm[k], *b = line->places_mm[(k + 1) % line->count];
            area += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
        printf("%zu %.17g\n", line->count, area);
    }
    luxel_silhouette_free(seen);
    luxel_scene_free(scene);
    return 0;
}
"""


def try_outlines(tap, folder):
    """The plan shows a circle around the ring, and one around its hole that runs the other way."""
    (folder / "outlines.c").write_text(OUTLINES)
    made = call("ninja", "-C", folder / "build")
    if made.returncode == 0:
        made = call("cc", "-o", folder / "outlines", folder / "outlines.c", "-I", folder / "luxel/include",
                    "-L", folder / "build/src", "-lluxel", "-Wl,-rpath," + str(folder / "build/src"))
    tap.ok(made.returncode == 0, "a program that asks for outlines builds", made.stdout[-1000:], made.stderr[-1000:])
    lines = [line.split() for line in call(folder / "outlines", folder / "ring.yaml").stdout.splitlines()]
    areas = [float(area) for _, area in lines]
    # The ring is tilted: its plan is smaller by the cosine of its axis to z; polygons have a little less.
    cosine = (0.2 ** 2 + 0.3 ** 2 + 1) ** -0.5
    tap.ok(len(areas) == 2 and 0.99 < areas[0] / (numpy.pi * 150 ** 2 * cosine) < 1 and
           0.99 < -areas[1] / (numpy.pi * 60 ** 2 * cosine) < 1, "its plan is a ring", str(lines))


def try_surface(tap, luxel, folder, scene):
    compare(tap, Pictures(tap, luxel, folder, scene))
    ring = folder / "ring.yaml"
    single = call(luxel, "render", ring, "-o", folder / "single.npy")
    exact, rounded = numpy.load(folder / "ring.npy"), numpy.load(folder / "single.npy")
    tap.ok(single.returncode == 0 and numpy.abs(rounded - exact).max() <= 2e-6 * exact.max(),
           "float32 keeps its accuracy")
    stats = json.loads(call(luxel, "stats", ring, "--json", "-s", "lights[0].position=[100, 60, 1300]").stdout)
    outer = json.loads(call(luxel, "stats", folder / "outer.yaml", "--json", "-s",
                            "lights[0].position=[150, 90, 1300]").stdout)
    tap.ok(stats["maximum"]["value"] >= stats["max"]["value"], "its true maximum is no less than that of the pixels",
           str(stats)[:500])
    moved = json.loads(call(luxel, "stats", ring, "--json", "-s", "lights[0].position=[150, 90, 1300]").stdout)
    tap.ok(abs(moved["maximum"]["value"] / outer["maximum"]["value"] - 1) < 1e-9,
           "the search on the screen finds the maximum that a disk's own coordinates lead to",
           str(moved["maximum"]), str(outer["maximum"]))
    tap.ok("the radius of the hole" in call(luxel, "help", "ring").stdout, "help knows its keys")
    wrong = call(luxel, "check", ring, "-s", "surfaces[1].hole=-1")
    tap.ok(wrong.returncode == 3 and "hole" in wrong.stderr, "an illegal value is an error", wrong.stderr)
    for command in ("explain", "advise", "isophotes"):
        made = call(luxel, command, ring)
        tap.ok(made.returncode == 0, "luxel %s takes it" % command, made.stderr)
    try_outlines(tap, folder)
    try_reflections(tap, luxel, folder)


GUIDE = ("docs/ADDING-A-SURFACE.md", "src/surface", "ring.c", "sphere.c", try_surface)
