# SPDX-License-Identifier: MIT
"""Derivatives at arrays of places: against complex steps and the tool; where there are none; their time."""
import json
import time

import numpy

from package import Tap, luxel, raises, run_tests

DESK = """luxel: 1
screen: {width: 400, height: 400, resolution: [12, 12], sampling: centers}
observer: {z: 9000}
surfaces: [{type: sphere, center: [0, 0, 1000], radius: 150}]
lights:
  - {type: point, position: [1000, 2000, 3000], intensity: 100}
grids: [{name: desk, center: [0, 0, 0], size: [4000, 3000], n: [5, 4]}]
"""
KEYS = ["lights[0].position", "lights[0].intensity"]


def truth_at(places, lamp=(1000, 2000, 3000), intensity=100.0):
    """By complex steps of I z/r^3 over elements that face +z."""
    found = numpy.empty((len(places), 4))
    for k in range(4):
        numbers = numpy.array(list(lamp) + [intensity], complex)
        numbers[k] += 1e-30j
        offset = numbers[:3] - places
        value = numbers[3] * offset[:, 2] / (offset ** 2).sum(1) ** 1.5 * 1e6
        found[:, k] = value.imag / 1e-30
    return found


def elements(tap, tool):
    scene = luxel.Scene(DESK)
    random = numpy.random.default_rng(3)
    places = random.uniform(-3000, 3000, (70000, 3)) * [1, 1, 0]
    jacobian = scene.jacobian(KEYS, elements=(places, [0, 0, 1]), quantity="irradiance", full=True)
    truth = truth_at(places)
    lit = jacobian.mask.all(1)
    columns = ["lights[0].position[0]", "lights[0].position[1]", "lights[0].position[2]", "lights[0].intensity"]
    tap.equal((jacobian.derivatives.shape, jacobian.derivatives.dtype, jacobian.columns),
              ((70000, 4), numpy.dtype("float64"), columns), "its form")
    shadow = scene.evaluate(places, [0, 0, 1], quantity="irradiance")["value"] == 0
    off = numpy.abs(jacobian.derivatives - truth)[lit & ~shadow]
    errors = jacobian.errors[lit & ~shadow]
    tap.ok(lit.mean() > .99 and (off <= errors + 1e-15 * numpy.abs(truth[lit & ~shadow])).mean() > .9999,
           "within their errors", lit.mean(), (off - errors).max())
    tap.ok((off <= 1e-10 * numpy.abs(truth).max(0)).all(), "to ten digits", (off / numpy.abs(truth).max(0)).max())
    tap.ok((jacobian.derivatives[lit & shadow] == 0).all(), "nothing changes in the middle of a shadow")
    plain = scene.jacobian(KEYS, elements=(places[:50], [0, 0, 1]), quantity="irradiance")
    tap.ok(plain.shape == (50, 4) and numpy.array_equal(plain, jacobian.derivatives[:50], equal_nan=True),
           "the same at a few places alone, to the last bit")
    tap.ok(numpy.array_equal(jacobian.values[~numpy.isnan(jacobian.values)], scene.evaluate(
        places, [0, 0, 1], quantity="irradiance", tolerance=1e-11)["value"][~numpy.isnan(jacobian.values)]),
           "values are those of evaluate()")


def points_and_pixels(tap, tool):
    scene = luxel.Scene("report")
    keys = ["lights[0].intensity", "surfaces[0].material.shininess", "surfaces[0].radius", "lights[0].position"]
    found = scene.jacobian(keys)
    told = tool.run("derive", "--json", *(word for key in keys for word in ("--free", key))).json()["points"]
    for row, point in zip(found, told):
        derivatives = point["derivatives"]
        flat = [derivatives[key] for key in keys[:3]] + derivatives[keys[3]]
        tap.ok(all(abs(one - other["value"]) <= other["error"] for one, other in zip(row, flat)), "as the tool has it",
               row, flat)
    tap.near(scene.jacobian("lights[0].intensity", [(150, 0)])[0, 0], 1.103801503926, 1e-12, "one key")
    scene = luxel.Scene(DESK)
    found = scene.jacobian(["lights[0].intensity"], pixels=True, full=True)
    picture = scene.render(precision="double")
    seen = picture.mask.ravel()
    tap.ok(found.derivatives.shape == (144, 1) and numpy.array_equal(found.mask[:, 0], seen) and
           (found.states[~seen] == luxel.STATES.index("no value")).all() and
           numpy.abs(found.derivatives[seen, 0] * 100 - picture.values.ravel()[seen]).max() < 1e-10 *
           picture.values.max(), "pixels, and none off the surface")


def grids(tap, tool):
    scene = luxel.Scene(DESK)
    plane = scene.grid("desk")
    found = scene.jacobian(KEYS, grid="desk", full=True)
    bright = found.values > 0
    truth = truth_at(plane.positions_mm.reshape(-1, 3))
    tap.ok(numpy.array_equal(found.values, plane.values.ravel()) and
           numpy.abs(found.derivatives - truth)[bright].max() < 1e-11 * numpy.abs(truth).max(), "cells of a grid")
    moved = scene.jacobian(["grids[desk].center", "lights[0].position"], grid="desk")[bright]
    tap.ok(numpy.abs(moved[:, :3] + moved[:, 3:6]).max() < 1e-10 * numpy.abs(moved).max() + 1e-15,
           "cells move with their grid", moved)
    buried = luxel.Scene(DESK.replace("center: [0, 0, 1000]", "center: [0, 0, 0]").replace("n: [5, 4]", "n: [5, 5]"))
    tap.ok(numpy.isnan(buried.jacobian(KEYS, grid=0)[12]).all(), "none inside a body")


def none_there(tap, tool):
    scene = luxel.Scene(DESK.replace("[{type: sphere, center: [0, 0, 1000], radius: 150}]",
                                     "[{type: rectangle, center: [1500, 1000, 1500], size: [1000, 4000]}]"))
    # the plate's edge at x = 1000 shadows from x = 1000 on, below a lamp at x = 1000
    found = scene.jacobian(KEYS, elements=([(1000, 0, 0), (900, 0, 0), (1300, 500, 0), (numpy.nan, 0, 0)], [0, 0, 1]),
                           quantity="irradiance", full=True)
    names = [[luxel.STATES[state] for state in row] for row in found.states]
    tap.ok(names[0][0] == "jump" and numpy.isnan(found.derivatives[0, 0]) and names[1] == ["exists"] * 4 and
           names[2] == ["exists"] * 4 and (found.derivatives[2] == 0).all() and names[3] == ["no value"] * 4,
           "the edge of a hard shadow, beside it, in it, and nowhere", names, found.derivatives)
    for what, arguments, named in (("two kinds of places", (KEYS, [(0, 0)]), {"pixels": True}),
                                   ("no key", ([],), {}), ("points of three numbers", (KEYS, [(0, 0, 0)]), {}),
                                   ("elements without normals", (KEYS,),
                                    {"elements": [(0, 0, 0)]})):
        tap.ok(raises(ValueError, scene.jacobian, *arguments, **named), what)
    error = raises(luxel.LuxelError, scene.jacobian, ["lights[0].type", "screen.resolution", "lights[0].intensty"])
    tap.ok(error and len(error.diagnostics) == 3 and "intensity" in str(error), "wrong keys, all at once", error)


if __name__ == "__main__":
    run_tests(Tap(), elements, points_and_pixels, grids, none_there)
