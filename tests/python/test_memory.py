# SPDX-License-Identifier: MIT
"""Nothing is left of what was freed: a hundred thousand pictures and as much else without growth; no lost reference."""
import gc
import os
import sys
import time

import numpy

from package import Tap, luxel, raises, run_tests
from tool import PATIENCE, SCENE

SETTINGS = luxel._settings.settings(None)
LIMIT = 20 * PATIENCE  # seconds, after which a loop ends early on a slow machine

BALL = """luxel: 1
reflections: 1
screen: {width: 1000, height: 1000, resolution: [8, 8]}
observer: {z: 9000}
surfaces: [{type: sphere, center: [0, 0, 0], radius: 500, inside: true,
            material: {model: lambert, diffuse: 0.8, over_pi: true}}]
lights: [{type: ambient, irradiance: 1}]
"""


def resident():
    """Kilobytes of memory that the process has."""
    with open("/proc/self/status", encoding="utf-8") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS:"))


def grows(tap, name, function, count):
    """Calls a function many times, after a tenth as many to warm up; the memory may not grow by more than 2 MB."""
    for _ in range(count // 10):
        function()
    gc.collect()
    before, end, done = resident(), time.monotonic() + LIMIT, 0
    while done < count and (done % 1000 or time.monotonic() < end):
        function()
        done += 1
    gc.collect()
    grown = resident() - before
    tap.ok(grown < 2048, "%s: %d times without growth" % (name, done), "grown by %d kB" % grown)


def test_growth(tap, tool):
    if "LUXEL_SANITIZED" in os.environ:
        tap.skip("memory", "the sanitizer keeps what is freed")
        return
    scene = luxel.Scene(luxel.Scene(SCENE).changed({"screen.resolution": [4, 4]}).text)
    places, normals = numpy.ones((3, 3)), numpy.ones((3, 3))
    grows(tap, "fields", scene.render, 100_000)
    grows(tap, "arrays", lambda: scene.render().values.sum(), 10_000)
    grows(tap, "probes", scene.probe, 5_000)
    grows(tap, "values", lambda: scene.evaluate(places, normals, per_light=True), 5_000)
    grows(tap, "scenes", lambda: luxel.Scene(SCENE), 2_000)
    grows(tap, "changes", lambda: scene.__setitem__("lights[0].intensity", 11), 2_000)
    grows(tap, "errors", lambda: raises(luxel.LuxelError, scene.__setitem__, "lights[0].intensity", -1), 2_000)
    short = (places, normals, None, numpy.empty(2), numpy.empty(3), None)
    grows(tap, "refused arrays", lambda: raises(ValueError, luxel._luxel.evaluate, scene._handle, short, 0, SETTINGS),
          5_000)
    grows(tap, "lines", lambda: scene.render().isophotes(3, exact=False), 2_000)
    grows(tap, "sections", lambda: scene.section(samples=5).value.sum(), 2_000)
    grows(tap, "documents", lambda: scene.explain().text, 60)
    desk = luxel.Scene("desk").changed({"grids[0].n": [2, 2]})
    grows(tap, "grids", lambda: desk.grid().values.sum(), 60)
    shining = luxel.Scene(BALL)
    grows(tap, "balances", lambda: shining.balance(reflected_error=0.05), 200)
    measured = desk.grid()
    grows(tap, "extrema of grids", measured.extrema, 60)


def test_references(tap, tool):
    scene = luxel.Scene(SCENE)
    handle = scene._handle
    field = scene.render()

    def work():
        luxel._luxel.scene_capsule(handle)
        memoryview(field).release()
        numpy.asarray(field)
        field.mask, field.x_mm
        field.extrema()
        luxel._luxel.probe(handle, [(0.0, 0.0), (0.0, 0.0, 1300.0, 0.0, 0.0, 1.0, None, 0)], SETTINGS)
        raises(TypeError, luxel._luxel.probe, handle, [(1.0,)], SETTINGS)
        raises(ValueError, luxel._luxel.grid_extrema, handle, 0, SETTINGS)
        raises(TypeError, luxel._luxel.render, handle, int, SETTINGS)
        raises(KeyError, luxel._luxel.scene_get, handle, "nonsense")

    watched = (None, True, False, handle, field, SETTINGS, luxel.Field, luxel._luxel.SceneHandle, luxel._luxel.View,
               luxel._luxel.Holder)
    for _ in range(20):
        work()
    gc.collect()
    before = [sys.getrefcount(one) for one in watched]
    for _ in range(300):
        work()
    gc.collect()
    after = [sys.getrefcount(one) for one in watched]
    tap.ok(all(abs(b - a) < 100 for a, b in zip(before, after)), "references are given back",
           list(zip(watched, before, after)))


run_tests(Tap(), test_references, test_growth)
