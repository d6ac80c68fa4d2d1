# SPDX-License-Identifier: MIT
"""Scenes in colour: arrays with three channels, the luminance beside them, and the colours of probes."""
import pickle

import numpy

from package import Tap, luxel, raises, run_tests

SCENE = """luxel: 1
channels: rgb
screen: {width: 200, height: 160, resolution: [40, 32]}
observer: {z: 1000}
surfaces: [{type: sphere, center: [0, 0, 0], radius: 70, material: {model: lambert, color: [1, 0.5, 0.25]}}]
lights: [{type: point, position: [300, 200, 400], intensity: 2, color: {temperature: 2700}}]
"""
WEIGHTS = (.2126390058715, .7151686787678, .0721923153607)


def test_pictures(tap, tool):
    """Rows x columns x 3, which share memory; statistics, grey levels and NaN are of the luminance."""
    scene = luxel.Scene.from_text(SCENE)
    for precision, kind, close in (("single", numpy.float32, 1e-6), ("double", numpy.float64, 1e-14)):
        field = scene.render(precision=precision)
        values = numpy.asarray(field)
        tap.equal((values.shape, values.dtype, field.shape), ((32, 40, 3), kind, (32, 40, 3)), "three channels")
        tap.ok(field.values.base is not None and numpy.shares_memory(values, field.values), "of the library's memory")
        off = abs(values.astype(float) @ numpy.array(WEIGHTS) - field.luminance)
        tap.ok(off.max() <= close * field.luminance.max(), "the luminance is theirs")
        tap.equal(field.statistics.maximum.value, float(field.luminance.max()), "statistics of the luminance")
        tap.equal(field.grey().shape, (32, 40), "grey levels of the luminance")
        again = pickle.loads(pickle.dumps(field))
        tap.ok((numpy.asarray(again) == values).all(), "a pickle has the channels")
    grey = luxel.Scene.from_text(SCENE).changed({"channels": "grey"}).render()
    tap.equal(numpy.asarray(grey).shape, (32, 40), "a grey scene has one")
    tap.ok((grey.luminance == grey.values).all(), "which is its luminance")


def test_probes(tap, tool):
    """A probe's colour is that of the tool."""
    scene = luxel.Scene.from_text(SCENE)
    probe = scene.probe((0, 0))
    tool.write("a.yaml", SCENE)
    told = tool.run("probe", "a.yaml", "-p", "0,0", "--json").json()["points"][0]
    tap.equal((list(probe.color.rgb), list(probe.color.error), list(probe.color.xy), probe.color.cct, probe.color.duv),
              (told["rgb"]["value"], told["rgb"]["error"], told["xy"], told["cct"], told["duv"]), "as told")
    tap.equal(list(probe.color.uv), told["uv"], "u', v', too")
    tap.equal(scene.changed({"channels": "grey"}).probe((0, 0)).color, None, "none in a grey scene")
    tap.equal((list(probe.shares[0].color.rgb), list(probe.shares[0].color.error)),
              (told["lights"][0]["rgb"]["value"], told["lights"][0]["rgb"]["error"]), "each light has its own")
    tap.equal(scene.changed({"channels": "grey"}).probe((0, 0)).shares[0].color, None, "but in a grey scene")


def test_views(tap, tool):
    """A picture's channels and colour temperatures are fields of their own."""
    field = luxel.Scene.from_text(SCENE).render()
    for channel, name in enumerate(("red", "green", "blue")):
        tap.ok((field.view(name).values == field.values[..., channel]).all(), name)
    warm = luxel.Scene.from_text(SCENE).changed({"surfaces[0].material.color": [1, 1, 1]}).render().view("cct")
    tap.ok(warm.unit == "K" and abs(warm.values[warm.mask] - 2700).max() < 0.01, "colour temperatures")
    tap.ok(not warm.values[~warm.mask].any() and warm.shape == (32, 40), "which dark pixels have not")
    tap.ok(raises(ValueError, field.view, "yellow"), "no such view")
    tap.ok(raises(luxel.LuxelError, warm.view, "red"), "nor one of a grey field")


def test_albedo(tap, tool):
    """The share that a probe's material reflects is that of the tool, as long as it tells it, and None elsewhere."""
    scene = luxel.Scene.from_text(SCENE.replace("model: lambert", "specular: 0.5"))
    tool.write("b.yaml", scene.text)
    told = tool.run("probe", "b.yaml", "-p", "0,0", "-p", "50,0", "-p", "90,0", "--json").json()["points"]
    found = scene.probe([(0, 0), (50, 0), (90, 0)])
    tap.equal([probe.albedo for probe in found], [point["albedo"] for point in told], "as told")
    white = sum(weight * factor for weight, factor in zip(WEIGHTS, (1, 0.5, 0.25)))
    tap.ok(abs(found[0].albedo - 0.8 * white - 0.5 * 8 / 22 * (1 - 2 ** -11)) < 1e-10, "Blinn's, straight on")
    tap.equal(found[2].albedo, None, "none off every surface")
    tap.equal({probe.albedo for probe in scene.probe([(0, 0)] * 1001)}, {None}, "none of very many places")


run_tests(Tap(), test_pictures, test_probes, test_views, test_albedo)
