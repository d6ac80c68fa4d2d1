# SPDX-License-Identifier: MIT
"""The emitter that docs/ADDING-AN-EMITTER.md adds (test_adding.py).

The new emitter, a capsule, must give what the cosine integrated over the directions that meet it gives, with and
without a ball in the way, and its highlight what the lobe does; with a short side all that a ball gives; and its
pictures what its probes tell.
"""
import json
import re

import numpy

from calling import call

# Free elements: beside it, cut by the horizon, beyond an end, aslant.
FREE = ([0, 0, 0, 0, 0, 1], [200, 300, 480, -0.6, 0, 0.8], [-50, 100, 800, 0, 0.6, -0.8],
        [350, 220, 580, -1, 0, 0], [-300, 25, 450, 1, 0, 0], [-250, 40, 462, 0.8, -0.6, 0],
        [-60, 160, 500, 0, -1, 0], [0, 3000, 0, 0, -0.96, 0.28])
# Elements of the floor: in the open, and where the ball takes some of the light, or most.
FLOOR = ([-100, -100, 0, 0, 0, 1], [250, 20, 0, 0, 0, 1], [290, 20, 0, 0, 0, 1], [330, 60, 0, 0, 0, 1])


class Capsule:
    """The capsule of a scene, in numpy."""

    def __init__(self, scene):
        text = re.search(r"type: capsule.*", scene).group()
        vector = lambda key: numpy.array([float(x) for x in re.search(key + r": \[(.*?)\]", text).group(1).split(",")])
        number = lambda key: float(re.search(key + r": ([\d.]+)", text).group(1))
        self.center, axis = vector("center"), vector("axis")
        self.axis = axis / numpy.linalg.norm(axis)
        self.radius, self.half, self.radiance = number("radius"), number("height") / 2, number("radiance")

    def is_met(self, place, ways):
        """Whether rays come within the radius of the axis: the nearest place of it is quadratic in where it is."""
        middle, ahead, along = self.center - place, ways @ (self.center - place), ways @ self.axis
        across = numpy.maximum(1 - along ** 2, 1e-300)
        at = numpy.clip(-(middle @ self.axis - ahead * along) / across, -self.half, self.half)
        square = middle @ middle + 2 * at * (middle @ self.axis) + at ** 2 - (ahead + at * along) ** 2
        return square < self.radius ** 2

    def directions(self, place, count):
        """Directions about the middle with their weights, from there to where it ends by halving."""
        z = (self.center - place) / numpy.linalg.norm(self.center - place)
        x = numpy.cross(z, [0.3, 0.5, 0.8])
        x /= numpy.linalg.norm(x)
        turn = 2 * numpy.pi * (numpy.arange(count) + 0.5) / count
        aside = numpy.outer(numpy.cos(turn), x) + numpy.outer(numpy.sin(turn), numpy.cross(z, x))
        low, high = numpy.zeros(count), numpy.full(count, numpy.pi)
        for _ in range(50):
            mid = (low + high) / 2
            met = self.is_met(place, numpy.cos(mid)[:, None] * z + numpy.sin(mid)[:, None] * aside)
            low, high = numpy.where(met, mid, low), numpy.where(met, high, mid)
        nodes, weights = numpy.polynomial.legendre.leggauss(400)
        angle = low[:, None] * (nodes + 1) / 2
        ways = numpy.cos(angle)[..., None] * z + numpy.sin(angle)[..., None] * aside[:, None, :]
        return ways, numpy.sin(angle) * low[:, None] * weights / 2 * 2 * numpy.pi / count

    def sums(self, element, ball=None, shininess=None, view=None):
        """The irradiance, and the sum of the highlight for a specular coefficient of 1."""
        place, normal = numpy.array(element[:3], float), numpy.array(element[3:], float)
        ways, weights = self.directions(place, 1600)
        if ball is not None:
            ahead = ways @ (ball[:3] - place)
            hidden = (ahead > 0) & ((ball[:3] - place) @ (ball[:3] - place) - ahead ** 2 < ball[3] ** 2)
            weights = numpy.where(hidden, 0, weights)
        irradiance = self.radiance * (weights * numpy.maximum(ways @ normal, 0)).sum()
        if shininess is None:
            return irradiance
        half = ways + view
        cosine = numpy.maximum(half @ normal / numpy.linalg.norm(half, axis=-1), 0)
        return irradiance, self.radiance * (weights * cosine ** shininess).sum()


def probe(luxel, scene, elements, *options):
    at = [part for element in elements for part in ("--at", ",".join("%r" % x for x in element))]
    made = call(luxel, "probe", scene, *at, "--json", *options)
    return json.loads(made.stdout) if made.returncode == 0 else {"points": [], "why": made.stderr}


def try_free(tap, luxel, folder, scene, capsule):
    (folder / "free.yaml").write_text(re.sub(r".*type: sphere.*\n", "", scene))
    told = probe(luxel, folder / "free.yaml", FREE, "--quantity", "irradiance")
    truth = [capsule.sums(element) for element in FREE]
    off = [abs(point["value"] / value - 1) for point, value in zip(told["points"], truth)]
    tap.ok(len(off) == len(FREE) and max(off) < 2e-5, "its irradiance is that of all rays that meet it", str(off),
           str(told.get("why")))
    tap.ok(all(point["error"] < 1e-9 * point["value"] for point in told["points"]), "with a small bound")
    area = 4 * numpy.pi * capsule.radius * (capsule.radius + capsule.half) * 1e-6
    tap.ok(abs(told["lights"][0]["flux"] / (numpy.pi * capsule.radiance * area) - 1) < 1e-12, "its flux is known")


def try_floor(tap, luxel, folder, capsule):
    """What the ball of the scene takes, and highlights."""
    ball = numpy.array([120, 60, 250, 80.0])
    told = probe(luxel, folder / "capsule.yaml", FLOOR, "--tolerance", "1e-5")
    worst = [0, 0]
    for element, point in zip(FLOOR, told["points"]):
        light = point["lights"][0]
        truth = capsule.sums(element, ball, 30, numpy.array(point["view"]))
        found = (light["irradiance"], light["specular"] / 0.4)
        worst = [max(w, abs(f - t) / max(t, 1e-3)) for w, f, t in zip(worst, found, truth)]
    tap.ok(len(told["points"]) == len(FLOOR) and worst[0] < 2e-3, "the ball takes what it hides", str(worst),
           str(told.get("why")))
    tap.ok(worst[1] < 2e-3, "highlights are those of its directions", str(worst))


def try_short(tap, luxel, folder, scene):
    """With next to no side it is a ball, hidden or not, whose light has formulas and kernels of its own."""
    short = re.sub(r"height: 300", "height: 1e-7", scene)
    ball = re.sub(r"type: capsule, (center: \[.*?\]), (radius: \d+).*?radiance",
                  r"type: volume, sphere: {\1, \2}, radiance", scene)
    values = {}
    for name, text in ("short", short), ("ball", ball):
        (folder / (name + ".yaml")).write_text(text)
        made = call(luxel, "render", folder / (name + ".yaml"), "--precision", "double", "-o", folder / (name + ".npy"))
        tap.ok(made.returncode == 0, "the scene with a %s renders" % name, made.stderr)
        values[name] = numpy.load(folder / (name + ".npy"))
    off = numpy.abs(values["short"] - values["ball"]).max() / values["ball"].max()
    tap.ok(off < 1e-3, "with a short side its picture is that of a ball", str(off))


def try_picture(tap, luxel, folder):
    made = call(luxel, "render", folder / "capsule.yaml", "-o", folder / "capsule.npy")
    tap.ok(made.returncode == 0, "its scene renders", made.stderr)
    asked = [part for x in (-310, -110, 130, 210, 310) for part in ("-p", "%d,30" % x)]
    told = json.loads(call(luxel, "probe", folder / "capsule.yaml", *asked, "--json").stdout)
    most = numpy.load(folder / "capsule.npy").max()
    off = [abs(point["pixel_value"] - point["value"]) / most for point in told["points"]]
    tap.ok(len(off) == 5 and max(off) < 1e-5, "pixels are what probes tell", str(off))


def try_emitter(tap, luxel, folder, scene):
    (folder / "capsule.yaml").write_text(scene)
    capsule = Capsule(scene)
    try_free(tap, luxel, folder, scene, capsule)
    try_floor(tap, luxel, folder, capsule)
    try_short(tap, luxel, folder, scene)
    try_picture(tap, luxel, folder)
    tap.ok("the height of the side" in call(luxel, "help", "capsule").stdout, "help knows its keys")
    wrong = call(luxel, "check", folder / "capsule.yaml", "-s", "lights[0].radius=-1")
    tap.ok(wrong.returncode == 3 and "radius" in wrong.stderr, "an illegal value is an error", wrong.stderr)
    for command in "explain", "check":
        made = call(luxel, command, folder / "capsule.yaml")
        tap.ok(made.returncode == 0, "luxel %s takes it" % command, made.stderr)


GUIDE = ("docs/ADDING-AN-EMITTER.md", "src/light", "capsule.c", "carry.c", try_emitter)
