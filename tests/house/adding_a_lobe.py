# SPDX-License-Identifier: MIT
"""The lobe that docs/ADDING-A-LOBE.md adds (test_adding.py).

The new model must give what its formula gives, pixel by pixel and integrated over a lamp, within the bounds that are
told; be Lambert's where its exponent is 1; leave irradiance alone; be refused where light is reflected to and fro, by
the name of its material; and speak up in help, explanations and errors.
"""
import json

import numpy

from calling import call


def add(source, blocks):
    """The guide's steps in a copy of the sources; returns the golden scene."""
    file, line, member, row, rule, scene = blocks
    room = source / "src/material"
    (room / "minnaert.c").write_text(file)
    for name, before, text in (("model.h", '    X(LX_LAMBERT, lx_lambert_lobe, "lambert")', line),
                               ("material.h", "    bool over_pi;\n", member),
                               ("material.c", '    {\n        .name = "over_pi",\n', row),
                               ("material.c", '    {LX_RULE_USED, "normalized",', rule),
                               ("meson.build", "'phong.c'", "'minnaert.c', ")):
        old = (room / name).read_text()
        assert old.count(before) == 1, (name, before)
        (room / name).write_text(old.replace(before, text + before))
    return scene


CENTER, RADIUS = numpy.zeros(3), 300.0
DIFFUSE, DARKENING = 0.9, 1.5


def brightness(places, lamps, strengths):
    """Of places of the ball by lamps that send their strengths, W/sr: kd/pi E (N.L)^k (N.V)^(k-1), V = (0, 0, 1)."""
    normals = (places - CENTER) / RADIUS
    seen = numpy.maximum(normals[..., 2], 0)
    total = numpy.zeros(places.shape[:-1])
    for lamp, strength in zip(lamps, strengths):
        ways = lamp - places
        lengths = numpy.linalg.norm(ways, axis=-1)
        lit = numpy.maximum((normals * ways).sum(-1) / lengths, 0)
        total += strength / (lengths / 1000) ** 2 * lit ** DARKENING
    return DIFFUSE / numpy.pi * total * seen ** (DARKENING - 1)


def try_pictures(tap, luxel, folder):
    """Orthographic pictures along -z."""
    side, step = 80, 10.0
    x = (numpy.arange(side) - side / 2 + 0.5) * step
    across, down = numpy.meshgrid(x, -x)
    square = RADIUS ** 2 - across ** 2 - down ** 2
    places = numpy.stack([across, down, numpy.sqrt(numpy.maximum(square, 0))], axis=-1)
    expected = numpy.where(square > 0, brightness(places, numpy.array([[900.0, 500.0, 1600.0]]), [10.0]), 0)
    for precision, allowed in (("double", 1e-11), ("single", 2e-6)):
        made = call(luxel, "render", folder / "moon.yaml", "--precision", precision, "-o", folder / "moon.npy")
        tap.ok(made.returncode == 0, "it renders in %s" % precision, made.stderr)
        off = numpy.abs(numpy.load(folder / "moon.npy") - expected).max() / expected.max()
        tap.ok(off <= allowed, "each pixel is what the formula gives, in %s" % precision, str(off))
    pictures = []
    for model in ("minnaert", "lambert"):
        call(luxel, "render", folder / "moon.yaml", "--precision", "double", "-o", folder / "plain.npy",
             "-s", "surfaces[0].material={model: %s, diffuse: 0.9, over_pi: true}" % model)
        pictures.append(numpy.load(folder / "plain.npy"))
    tap.ok(numpy.abs(pictures[0] - pictures[1]).max() <= 1e-13 * pictures[1].max() and pictures[1].max() > 0,
           "with the exponent 1 it is Lambert's")


def points_of(luxel, *arguments):
    made = call(luxel, "probe", *arguments, "--json")
    return json.loads(made.stdout)["points"] if made.returncode == 0 else made


LAMP = "lights=[{type: planar, disk: {center: [500, 300, 900], radius: 200, aim: [0, 0, 0]}, radiance: 50}]"


def try_lamp(tap, luxel, folder):
    """A disk lamp against a rule of Gauss over it, of whose points each shines with the cosine of its angle."""
    nodes, weights = numpy.polynomial.legendre.leggauss(48)
    radii, turns = 100 * (nodes + 1), numpy.arange(96) * (2 * numpy.pi / 96)
    center = numpy.array([500.0, 300.0, 900.0])
    axis = -center / numpy.linalg.norm(center)
    across = numpy.cross(axis, [0.0, 0.0, 1.0])
    across /= numpy.linalg.norm(across)
    upward = numpy.cross(axis, across)
    rings = radii[:, None, None] * (numpy.cos(turns)[None, :, None] * across + numpy.sin(turns)[None, :, None] * upward)
    lamps = (center + rings).reshape(-1, 3)
    areas = numpy.repeat(100 * weights * radii * (2 * numpy.pi / 96) * 1e-6, 96)
    points = points_of(luxel, folder / "moon.yaml", "-s", LAMP, "-p", "60,30", "-p", "150,-80", "-p", "-200,150")
    # The last is where the horizon cuts the lamp, which the rule knows less well.
    for point, known in zip(points, (1e-9, 1e-9, 1e-5)):
        place = numpy.array(point["position"])
        ways = place - lamps
        cosines = ways @ axis / numpy.linalg.norm(ways, axis=1)
        truth = brightness(place, lamps, 50 * areas * cosines)
        tap.ok(truth > 0 and abs(point["value"] - truth) <= point["error"] + known * truth and
               point["error"] <= 1e-7 * truth, "under a lamp it is the formula's integral", str((point, truth)))
    made = call(luxel, "render", folder / "moon.yaml", "-s", LAMP, "-o", folder / "lamp.npy")
    middle = numpy.load(folder / "lamp.npy")[34:40, 42:50]
    tap.ok(made.returncode == 0 and (middle > 0).all() and
           abs(middle[2, 3] / points_of(luxel, folder / "moon.yaml", "-s", LAMP, "-p", "55,35")[0]["value"] - 1) < 2e-3,
           "and so it is in a picture", made.stderr)


def try_lobe(tap, luxel, folder, scene):
    moon = folder / "moon.yaml"
    moon.write_text(scene)
    try_pictures(tap, luxel, folder)
    try_lamp(tap, luxel, folder)
    point = points_of(luxel, moon, "-p", "60,30")[0]
    truth = brightness(numpy.array(point["position"]), numpy.array([[900.0, 500.0, 1600.0]]), [10.0])
    tap.ok(abs(point["value"] - truth) <= point["error"] + 1e-14 * truth and 0 < point["error"] < 1e-13 * truth,
           "a probe is within its bound of the formula", str((point, truth)))
    grids = [call(luxel, "grid", moon, "--json", "-s", "surfaces[0].material.model=%s" % model, "-s",
                  "grids=[{center: [0, 0, 500], size: [400, 400], n: [4, 4]}]").stdout
             for model in ("minnaert", "lambert")]
    tap.ok(grids[0] == grids[1] and '"mean"' in grids[0], "irradiance on a grid knows no lobe", grids[0][:500])
    refused = call(luxel, "render", moon, "-s", "reflections=1", "-o", folder / "none.npy")
    tap.ok(refused.returncode == 3 and "model is minnaert, which does not reflect as Lambert's law" in refused.stderr,
           "reflections are refused by the name of the material", refused.stderr)
    stats = json.loads(call(luxel, "stats", moon, "--json").stdout)
    tap.ok(stats["maximum"]["value"] >= stats["max"]["value"] > 0,
           "its true maximum is no less than that of the pixels", str(stats)[:500])
    told = call(luxel, "explain", moon, "-p", "60,30")
    tap.ok(told.returncode == 0 and "p k_d (N · L)((N · L)(N · V))ᵏ⁻¹ = " in told.stdout,
           "an explanation has its formula", told.stdout[:3000], told.stderr)
    tap.ok("Minnaert's exponent" in call(luxel, "help", "darkening").stdout, "help knows its keys")
    wrong = call(luxel, "check", moon, "-s", "surfaces[0].material.darkening=0.5")
    tap.ok(wrong.returncode == 3 and "darkening" in wrong.stderr, "an illegal value is an error", wrong.stderr)
    made = call(luxel, "advise", moon)
    tap.ok(made.returncode == 0, "luxel advise takes it", made.stderr)


PAGE = "docs/ADDING-A-LOBE.md"
