# SPDX-License-Identifier: MIT
"""The light on surfaces and the balance of the flux: as the tool tells them, and as they are known in closed form."""
import pickle
import re
import warnings

from package import Tap, luxel, raises, run_tests

ROOM = """luxel: 1
reflections: all
screen: {width: 3000, height: 3000, resolution: [8, 8]}
observer: {z: 9000, projection: perspective}
surfaces: [{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000],
            material: {model: lambert, diffuse: 0.5, over_pi: true}}]
lights: [{type: ambient, irradiance: 1}]
"""
BALL = """luxel: 1
reflections: 2
units: photometric
screen: {width: 1000, height: 1000, resolution: [8, 8]}
observer: {z: 9000}
surfaces: [{type: sphere, name: "<ball>", center: [0, 0, 0], radius: 500, inside: true,
            material: {model: lambert, diffuse: 0.8, over_pi: true}}]
lights: [{type: point, position: [0, 0, 0], power: 1000, attenuation: inverse-square}]
"""
DARK = {"luxel": 1, "screen": {"width": 100, "height": 100, "resolution": [8, 8]}, "observer": {"z": 9000},
        "surfaces": [], "lights": [{"type": "point", "position": [500, 300, 2500], "intensity": 3}]}
QUICK = {"reflections": 1, "lights[0]": {"type": "ambient", "irradiance": 1}}
FLUXES = ("emitted", "missed", "arrives", "absorbed", "escaped", "pending", "difference")


def within(amount, truth, most):
    return abs(amount.value - truth) <= amount.error <= most


def told_amount(told):
    return told and (told["value"], told["error"])


def test_exchange(tap, tool):
    scene = luxel.Scene(ROOM)
    found, told = scene.exchange(threads=1), tool.run("exchange", "-", "--json", stdin=ROOM).json()
    tap.equal([side.area_m2 for side in found.sides], [side["area"] for side in told["sides"]], "areas")
    tap.equal(found.factors.tolist(), [[factor["value"] for factor in row] for row in told["factors"]], "factors")
    tap.equal(found.errors.tolist(), [[factor["error"] for factor in row] for row in told["factors"]], "errors")
    tap.equal((found[0, 1].value, len(found), found.sides[2].wall), (found.factors[0, 1], 6, "floor"), "one of them")
    tap.ok(found.reached and "<table" in found._repr_html_() and "6 sides" in repr(found), "words", found)


def test_measures(tap, tool):
    grid = {"center": [0, 0, 1000], "size": [100, 100], "n": [2, 2], "measure": "cylindrical"}
    plane = luxel.Scene({**DARK, "grids": [grid, {**grid, "measure": "plane"}]})
    found, flat = plane.grid(0), plane.grid(1)
    tap.equal((found.measure, flat.measure, flat.modelling), ("cylindrical", "plane", None), "measures")
    tap.ok(abs(found.modelling[0].value - found.average / flat.average) <= found.modelling[0].error + 1e-15,
           "modelling", found.modelling)


def test_skipped_pixels(tap, tool):
    scene = luxel.Scene(ROOM).changed(QUICK)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", luxel.LuxelWarning)
        whole, bare = (scene.probe((100, 200), reflected_error=0.1, skip_reflected_pixels=skips)
                       for skips in (False, True))
        many = scene.probe([(100, 200), (0, 0)], reflected_error=0.1, skip_reflected_pixels=True)
    tap.ok(whole.pixel_value is not None and whole.pixel == bare.pixel, "a probe tells the picture's value", whole)
    tap.ok(bare.pixel_value is None, "unless it takes a solution of its own and is not wanted", bare)
    tap.equal((bare.value, bare.error, many[0].value), (whole.value, whole.error, whole.value), "the exact one stays")
    tap.ok(all(probe.pixel_value is None for probe in many), "nor do many probes tell it")
    plain = luxel.Scene("report")
    tap.equal(plain.probe((0, 0), skip_reflected_pixels=True).pixel_value, plain.probe((0, 0)).pixel_value,
              "without reflected light it takes none, and is told")


def test_within(tap, tool):
    """An end by the clock: bounds that hold, and nothing else where it comes late."""
    place, plain = ([1000, -2000, 2500], [0, 1, 0]), luxel.Scene(ROOM)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", luxel.LuxelWarning)
        whole = plain.probe_element(*place, reflected_error=0.1)
        late = luxel.Scene(ROOM).probe_element(*place, reflected_error=0.1, within=1e5)
        ended = luxel.Scene(ROOM).probe_element(*place, reflected_error=1e-4, within=1e-9)
        picture = luxel.Scene(ROOM).render(reflected_error=1e-4, within=1e-9)
    tap.equal((late.value, late.error), (whole.value, whole.error), "late")
    tap.ok(1e-4 * ended.value < ended.error and abs(ended.value - whole.value) <= ended.error + whole.error, "at once",
           (ended, whole))
    tap.ok(picture.statistics.reflected_error > 1e-4, "a picture", picture.statistics)
    for wrong in (-1, float("inf"), float("nan")):
        tap.ok(raises(luxel.LuxelValueError, plain.render, within=wrong), "%s s are refused" % wrong)


def test_tool(tap, tool):
    for name, text in (("a room", ROOM), ("a ball", BALL)):
        scene = luxel.Scene(text)
        told = tool.run("stats", "-", "--json", stdin=text).json()
        scene.render()  # as the tool does, whose balance is that of the picture's reflected light
        found = scene.balance()
        tap.equal([(side.surface, side.surface_name, side.wall, side.side, side.area_m2, side.reflectance, side.direct,
                    side.irradiance) for side in found.sides],
                  [(side["surface"], side["name"], side.get("wall"), side["side"], side["area"], side["reflectance"],
                    told_amount(side["direct"]), told_amount(side["irradiance"])) for side in told["surfaces"]],
                  name + ": the sides")
        balance = told["balance"]
        tap.equal([getattr(found, flux) for flux in FLUXES], [told_amount(balance[flux]) for flux in FLUXES],
                  name + ": the fluxes")
        tap.equal((found.flux_unit, found.closes, found.reached), (balance["unit"], balance["closes"], True),
                  name + ": unit, whether it closes, whether the bound was reached")
        tap.equal(pickle.loads(pickle.dumps(found)), found, name + ": pickled")
        again = luxel.Scene(text).balance(threads=1)
        tap.ok(abs(again.absorbed.value - found.absorbed.value) <= again.absorbed.error + found.absorbed.error,
               name + ": without the picture it is within its bounds, too")


def test_truth(tap, tool):
    found = luxel.Scene(ROOM).balance(reflected_error=1e-3)
    tap.equal((found.unit, found.flux_unit, found.emitted, found.missed), ("W/m²", "W", None, None), "ambient light")
    tap.equal([(side.wall, side.side) for side in found.sides[:2]], [("left", "front"), ("left", "back")], "walls")
    for side, truth in zip(found.sides, [2, 1] * 6):
        tap.ok(within(side.irradiance, truth, 2e-3) and abs(side.area_m2 - 16) < 1e-9 and
               side.reflectance == 0.5, "the mean of " + side.wall, side)
    tap.ok(within(found.absorbed, 96 * 1.5, 0.2) and found.pending == (0, 0) and found.closes, "all is absorbed", found)
    found = luxel.Scene(BALL).balance()
    tap.ok(within(found.emitted, 1000, 1e-6) and within(found.missed, 0, 1), "a lamp in a ball", found)
    tap.ok(within(found.pending, 1000 * 0.8 ** 3, 4) and within(found.absorbed, 1000 * (1 - 0.8 ** 3), 4),
           "what is left after two bounces", found)
    tap.equal([(side.surface_name, side.wall, side.side) for side in found.sides], [("<ball>", None, "inside")],
              "its side")


def test_ways(tap, tool):
    tap.equal(luxel.Scene("report").balance(), None, "a scene without reflected light has none")
    scene = luxel.Scene(BALL)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        missed = scene.changed(QUICK).balance(reflected_error=1e-14)
    tap.equal([(one.category, one.filename) for one in told] + [missed.reached],
              [(luxel.LuxelWarning, __file__), False], "a bound that is missed is told")
    tap.ok(raises(luxel.LuxelValueError, scene.balance, reflected_error=-1), "a bound below 0 is refused")
    found = scene.balance()
    html = found._repr_html_()
    tap.ok("&lt;ball&gt;, inside" in html and "absorbed by surfaces" in html and "reflected after the last" in html,
           "tables for notebooks", html)
    shown = re.findall(r"([^>]+) ± ([^<]+)<", html)
    amounts = [found.sides[0].direct, found.sides[0].irradiance] + [getattr(found, flux) for flux in FLUXES]
    tap.equal(len(shown), len(amounts), "all numbers")
    for (value, error), amount in zip(shown, amounts):
        tap.ok(abs(float(value) - amount.value) + amount.error <= float(error) < 1e-3 * amounts[0].value,
               "within its bound", value, amount)
    tap.equal(shown[2 + FLUXES.index("escaped")][0], "0", "what is 0 within its bound is shown as 0")
    tap.ok("reflected after the last" not in luxel.Scene(ROOM).balance()._repr_html_(), "without what there is not")
    luxel.set_language("ru")
    try:
        html = found._repr_html_()
        tap.ok("absorbed" not in html and "inside" not in html and "лк" in html, "in Russian", html)
    finally:
        luxel.set_language("en")


run_tests(Tap(), test_exchange, test_measures, test_tool, test_truth, test_ways, test_skipped_pixels, test_within)
