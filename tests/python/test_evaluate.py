# SPDX-License-Identifier: MIT
"""Exact values of arrays of elements: those of probes to the last bit, wherever and however the arrays lie."""
import time

import numpy

from package import Tap, luxel, raises, run_tests
from tool import SCENE

GENERATOR = numpy.random.default_rng(2026)


def elements(count):
    """Places on and beside the sphere of SCENE and normals, some of any length."""
    normals = GENERATOR.normal(size=(count, 3))
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    places = normals / lengths * 200 + [0, 0, 1000]
    places[::3] += GENERATOR.normal(size=places[::3].shape) * 50
    return places, normals


def same(a, b):
    return ((a == b) | (numpy.isnan(a) & numpy.isnan(b))).all()


def test_probes(tap, tool):
    for name in luxel.builtin_scenes():
        scene = luxel.Scene(name)
        places, normals = elements(60)
        for quantity in ("brightness", "irradiance"):
            found = scene.evaluate(places, normals, quantity=quantity, per_light=True, tolerance=1e-6)
            probes = [scene.probe_element(p, n, quantity=quantity, tolerance=1e-6)
                      for p, n in zip(places[:12], normals)]
            tap.ok(all(probe.value is None or (probe.value == value and probe.error == error)
                       for probe, (value, error, _) in zip(probes, found)), "%s, %s: as probes" % (name, quantity))
            good = ~numpy.isnan(found["value"])
            tap.ok(numpy.allclose(found["shares"][good].sum(1), found["value"][good], rtol=1e-12),
                   "%s, %s: the lights' shares add up" % (name, quantity))


def test_tool(tap, tool):
    tool.write("a.yaml", SCENE)
    scene = luxel.Scene(SCENE)
    places, normals = elements(8)
    words = []
    for place, normal in zip(places, normals):
        words += ["--at", ",".join(repr(float(number)) for number in (*place, *normal))]
    told = tool.run("probe", "a.yaml", "--json", *words).json()["points"]
    found = scene.evaluate(places, normals)
    tap.equal([(point["value"], point["error"]) for point in told], [tuple(row) for row in found.tolist()],
              "the tool's numbers")
    told = tool.run("probe", "a.yaml", "--json", "-p", "0,0", "-p", "30,-40", "-p", "240,240").json()["points"]
    found = scene.probe([(0, 0), (30, -40), (240, 240)])
    tap.equal([(point["value"], point["error"], point["pixel_value"]) for point in told],
              [(probe.value, probe.error, probe.pixel_value) for probe in found], "of the screen, too")
    tap.equal((found[2].value, bool(numpy.isnan(found.value[2])), found[2].on_surface), (None, True, False),
              "off the surface there is none")


def test_layouts(tap, tool):
    scene = luxel.Scene(SCENE)
    places, normals = elements(3000)
    expected = scene.evaluate(places, normals)
    twice = numpy.empty((6000, 7))
    twice[::2, 1:4], twice[::2, 4:] = places, normals
    packed = numpy.zeros(3000, [("tag", "i1"), ("p", "f8", (3,)), ("n", "f8", (3,))])
    packed["p"], packed["n"] = places, normals
    ways = {"columns of a table": (twice[::2, 1:4], twice[::2, 4:]),
            "Fortran's order": (numpy.asfortranarray(places), numpy.asfortranarray(normals)),
            "not aligned": (packed["p"], packed["n"]), "lists": (places.tolist(), normals.tolist()),
            "another order of bytes": (places.astype(">f8"), normals.astype(">f8")),
            "backwards": (places[::-1][::-1], numpy.ascontiguousarray(normals[::-1])[::-1])}
    for name, (p, n) in ways.items():
        tap.ok(same(scene.evaluate(p, n)["value"], expected["value"]), name)
    found = scene.evaluate(places[::-1], normals[::-1])
    tap.ok(same(found["value"][::-1], expected["value"]) and same(found["error"][::-1], expected["error"]), "reversed")
    shaped = scene.evaluate(places.reshape(30, 100, 3), normals.reshape(30, 100, 3))
    tap.ok(shaped.shape == (30, 100) and same(shaped["value"].ravel(), expected["value"]), "of two dimensions")
    one = scene.evaluate(places[:100], [0, 0, 1])
    tap.ok(same(one["value"], scene.evaluate(places[:100], [[0, 0, 2.0]] * 100)["value"]), "one normal for all")
    tap.equal(scene.evaluate(places[0], normals[0]).shape, (), "a single element")
    tap.equal(scene.evaluate(numpy.empty((0, 3)), numpy.empty((0, 3))).shape, (0,), "none at all")
    out = numpy.empty(3000, expected.dtype)
    tap.ok(scene.evaluate(places, normals, out=out) is out and same(out["value"], expected["value"]), "into an array")
    for threads in (1, 4):
        found = scene.evaluate(places, normals, threads=threads)
        tap.ok(same(found["value"], expected["value"]), "%d threads" % threads)
    many = numpy.tile(places, (12, 1)), numpy.tile(normals, (12, 1))
    tap.ok(same(scene.evaluate(*many)["value"], numpy.tile(expected["value"], 12)), "more than one part")


def test_view(tap, tool):
    scene = luxel.Scene(SCENE)
    places, normals = elements(50)
    view = GENERATOR.normal(size=(50, 3))
    found = scene.evaluate(places, normals, view)
    probes = [scene.probe_element(p, n, view=v).value for p, n, v in zip(places, normals, view)]
    tap.ok(same(found["value"], numpy.array(probes)), "a view for each element")
    tap.ok(same(scene.evaluate(places, normals, view[0])["value"],
                numpy.array([scene.probe_element(p, n, view=view[0]).value for p, n in zip(places, normals)])),
           "one for all")
    two = luxel.Scene("two-spheres")
    far = [[1e6, 0, 0]]
    values = [two.evaluate(far, [[0, 0, 1]], surface=i)["value"][0] for i in (0, 1)]
    tap.equal(values, [two.probe_element(far[0], (0, 0, 1), surface=i).value for i in (0, 1)], "another material")


def test_odd(tap, tool):
    scene = luxel.Scene(SCENE)
    places = numpy.zeros((5, 3))
    normals = numpy.tile([0, 0, 1.0], (5, 1))
    places[1, 0], normals[2], normals[3, 1] = numpy.nan, 0, numpy.inf
    places[4] = [2000, 0, 2000]
    found = scene.evaluate(places, normals, per_light=True)
    tap.equal(numpy.isnan(found["value"]).tolist(), [False, True, True, True, True],
              "no number, no direction, and a source on the element")
    tap.ok((numpy.isnan(found["error"]) == numpy.isnan(found["value"])).all() and numpy.isnan(found["shares"][4]).all(),
           "error and shares with it")
    wide = numpy.empty((2, 4), found.dtype)
    for name, call in (("a shape", lambda: scene.evaluate([[0, 0]], [[0, 0]])),
                       ("shapes that do not go together",
                        lambda: scene.evaluate(numpy.ones((4, 3)), numpy.ones((5, 3)))),
                       ("an array of another kind", lambda: scene.evaluate(places, normals, out=numpy.empty(5))),
                       ("a hole in the result",
                        lambda: scene.evaluate(numpy.ones((2, 2, 3)), normals[0], out=wide[:, ::2])),
                       ("words", lambda: scene.evaluate([["a", "b", "c"]], [[0, 0, 1]]))):
        tap.ok(raises(ValueError, call), name + " is refused")
    tap.ok(raises(IndexError, scene.evaluate, places, normals, surface=1), "a surface that there is not")
    tap.ok(raises(IndexError, scene.probe_element, places[0], normals[0], surface=-1), "of a probe, too")
    raw = luxel._luxel.evaluate
    how = luxel._settings.settings(None)
    column, whole = numpy.empty(5), numpy.zeros((5, 3))
    for arrays in ((whole, whole, None, column[:4], column, None), (whole, whole[:, :2], None, column, column, None),
                   (whole.astype("f4"), whole, None, column, column, None),
                   (column, whole, None, column, column, None)):
        tap.ok(raises((ValueError, TypeError), raw, scene._handle, arrays, 0, how), "arrays that do not fit")
    column.flags.writeable = False
    tap.ok(raises((ValueError, BufferError), raw, scene._handle, (whole, whole, None, column, column, None), 0, how),
           "a result that cannot be written")
    strong = scene.changed({"lights[0].intensity": 1e308, "surfaces[0].material.diffuse": 1e300})
    tap.ok(raises(luxel.LuxelError, strong.evaluate, [[0, 0, 1200.0]], [[0, 0, 1.0]]), "beyond float64")
    tap.ok(raises(luxel.LuxelError, scene.probe, (float("nan"), 0)), "a probe of no place")


def test_numbers(tap, tool):
    """What is masked has no value; complex numbers are no places."""
    scene = luxel.Scene(SCENE)
    places, normals = elements(6)
    masked = numpy.ma.array(places, mask=numpy.zeros(places.shape, bool))
    masked[2, 1] = masked[4] = numpy.ma.masked
    found, expected = scene.evaluate(masked, normals)["value"], scene.evaluate(places, normals)["value"]
    hidden = numpy.array([False, False, True, False, True, False])
    tap.ok(numpy.isnan(found[hidden]).all() and (found[~hidden] == expected[~hidden]).all(), "masked places", found)
    tap.ok(raises(TypeError, scene.evaluate, places + 1j, normals), "complex places")
    tap.ok(raises(TypeError, scene.evaluate, places, normals, surface_tolerance=1j), "a complex tolerance")


def test_speed(tap, tool):
    """A million elements; a time is no test on a machine that others use, so it is only told."""
    scene = luxel.Scene(SCENE)
    places, normals = elements(100_000)
    start = time.perf_counter()
    found = scene.evaluate(places, normals)
    tap.note("%.2f microseconds an element" % ((time.perf_counter() - start) * 10))
    tap.equal(int(numpy.isnan(found["value"]).sum()), 0, "a hundred thousand values")


run_tests(Tap(), test_probes, test_tool, test_layouts, test_view, test_odd, test_numbers, test_speed)
