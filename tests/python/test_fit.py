# SPDX-License-Identifier: MIT
"""Fits: numbers found again, error bars that hold, what is not determined, outliers, saturation, levels, time."""
import time

import numpy

from package import Tap, luxel, raises, run_tests

UP = [0, 0, 1]
LAMP = ["lights[0].position", "lights[0].intensity"]


def desk(lamp=(2100, 1700, 2600), intensity=1000, **more):
    """A lamp over a plane at height 750."""
    return luxel.Scene({"luxel": 1, "units": "photometric", "screen": {"width": 100, "height": 100,
                                                                       "resolution": [4, 4]}, "observer": {"z": 9000},
                        "surfaces": [], "lights": [{"type": "point", "position": list(lamp), "intensity": intensity,
                                                    **more}]})


def lattice(columns, rows):
    """The middles of cells of 4 x 3 m."""
    x, y = numpy.meshgrid((numpy.arange(columns) + .5) * 4000 / columns, (numpy.arange(rows) + .5) * 3000 / rows)
    return numpy.stack([x.ravel(), y.ravel(), numpy.full(x.size, 750.)], 1)


def corners():
    return numpy.array([[0, 0, 750], [4000, 0, 750], [4000, 3000, 750], [0, 3000, 750.]])


def measure(scene, places):
    return scene.evaluate(places, UP, quantity="irradiance")["value"]


def fit(scene, values, places, keys=None, **named):
    return scene.fit(keys or LAMP, values, elements=(places, UP), quantity="irradiance", **named)


def numbers(found):
    return numpy.array([parameter.value for parameter in found.parameters], float)


def found_again(tap, tool):
    """From 30 % off, without noise, to 1e-9."""
    places, truth = lattice(4, 3), numpy.array([2100, 1700, 2600, 1000.])
    values = measure(desk(), places)
    random = numpy.random.default_rng(11)
    good = 0
    for _ in range(100):
        start = truth * (1 + .3 * random.uniform(-1, 1, 4))
        found = fit(desk(start[:3], start[3]), values, places, starts=1)
        good += found.converged and numpy.abs(numbers(found) / truth - 1).max() < 1e-9
    tap.ok(good >= 99, "from 100 starts", good)
    found = fit(desk((1500, 1500, 2000), 500), values, places)
    tap.equal((found.rank, found.undetermined, found.readings, found.dof), (4, [], 12, 8), "what is determined")
    tap.ok(found.agreed >= 2 and found.starts == 8, "several starts end here", found.agreed)
    tap.near(found.scene["lights[0].intensity"], 1000, 1e-6, "the scene of it")
    four = desk()
    for lamp in ((600, 500, 2500), (3400, 600, 2400), (800, 2500, 2700)):
        four.append("lights", {"type": "point", "position": list(lamp), "intensity": 800})
    keys = ["lights[%d].%s" % (i, key) for i in range(4) for key in ("position", "intensity")]
    values = measure(four, lattice(8, 6))
    truth = numpy.concatenate([numpy.append(four[keys[2 * i]], four[keys[2 * i + 1]]) for i in range(4)])
    off = four.changed({key: [number * (1 + .1 * random.uniform(-1, 1)) for number in four[key]] if "pos" in key else
                        700 for key in keys})
    found = fit(off, values, lattice(8, 6), keys, starts=1)
    tap.ok(found.rank == 16 and numpy.abs(numbers(found) / truth - 1).max() < 1e-7, "four lamps at once",
           numbers(found) - truth)


def error_bars(tap, tool):
    """Those of nine readings with 3 % of noise, and whether they hold."""
    places, truth = lattice(3, 3), numpy.array([2100, 1700, 2600, 1000.])
    scene, random, other_random = desk(), numpy.random.default_rng(5), numpy.random.default_rng(6)
    values = measure(scene, places)
    exact = fit(scene, values, places, noise="3%")
    for parameter, sd in zip(exact.parameters, (18.0, 22.9, 43.0, 26.1)):
        tap.near(parameter.sd, sd, 2e-2, "its standard deviation")
    tap.ok(.88 < abs(exact.correlation[2, 3]) < .94 and exact.correlation[1, 1] == 1,
           "height and intensity go together", exact.correlation)
    draws = 150
    within, wide, estimated = numpy.zeros(4), numpy.zeros(4), numpy.zeros(4)
    for _ in range(draws):
        found = fit(scene, values * (1 + .03 * random.normal(size=9)), places, noise="3%", starts=1)
        by_scatter = fit(scene, values + 2 * other_random.normal(size=9), places, starts=1)
        for k, (one, other) in enumerate(zip(found.parameters, by_scatter.parameters)):
            within[k] += abs(one.value - truth[k]) <= one.sd
            wide[k] += one.low <= truth[k] <= one.high
            estimated[k] += other.low <= truth[k] <= other.high
    tap.ok((within > .56 * draws).all() and (within < .80 * draws).all(), "68 of 100", within / draws)
    tap.ok((wide > .89 * draws).all() and (wide < draws).all(), "95 of 100", wide / draws)
    tap.ok((estimated > .88 * draws).all(), "95 of 100 where the noise is estimated, too", estimated / draws)


def least_errors(tap, tool):
    """A lamp from a picture of a sphere: the bounds of Cramer and Rao, from another program."""
    ball = {"luxel": 1, "screen": {"width": 700, "height": 700, "resolution": [200, 200]}, "observer": {"z": 9000},
            "surfaces": [{"type": "sphere", "center": [0, 0, 1000], "radius": 300,
                          "material": {"model": "blinn-phong", "diffuse": .8, "specular": 0, "shininess": 20}}],
            "lights": [{"type": "point", "position": [500, 400, 2000], "intensity": 10,
                        "attenuation": "inverse-square"}]}
    shine = ["surfaces[0].material.specular", "surfaces[0].material.shininess"]
    for what, changes, keys, bounds in (
            ("near", {}, LAMP, (.306, .259, .433, .0111)),
            ("far", {"lights[0].position": [2000, 1600, 5000], "lights[0].intensity": 160}, LAMP,
             (4.35, 3.50, 7.72, .665)),
            ("with a highlight", {shine[0]: .5}, LAMP, (.458, .381, .654, .0171)),
            ("with one that is not known", {shine[0]: .5}, LAMP + shine, (.747, .607, 1.01, .0244, 9.8e-4, .057))):
        scene = luxel.Scene(ball).changed(changes)
        picture = scene.render(precision="double")
        found = scene.fit(keys, picture, noise=.01 * picture.values.max(), starts=1)
        for parameter, bound in zip(found.parameters, bounds):
            tap.near(parameter.sd, bound, 7e-3, what + ": " + parameter.key)


def not_determined(tap, tool):
    def told(found, rank, names, what):
        left = [parameter.key for parameter in found.parameters if parameter.value is None]
        tap.ok(found.rank == rank and left == names and found.undetermined and
               all(any(name in text for text in found.undetermined) for name in names), what, found.rank, left,
               found.undetermined)

    middle = desk((2000, 1500, 2600))
    told(fit(middle, measure(middle, corners()), corners(), noise=1), 3, ["lights[0].position[2]", LAMP[1]],
         "a lamp above the middle of a rectangle of four readings")
    found = fit(desk(), measure(desk(), corners()), corners(), noise=1)
    told(found, 3, ["lights[0].position[%d]" % k for k in range(3)] + [LAMP[1]],
         "elsewhere where it stands goes with its height, too")
    scene = luxel.Scene("report")
    points = [(x, y) for x in range(-200, 201, 100) for y in range(-200, 201, 100)]
    values = [probe.value for probe in scene.probe(points)]
    told(scene.fit(["lights[0].intensity", "surfaces[0].material.diffuse", "surfaces[0].material.specular"], values,
                   points), 2, ["lights[0].intensity", "surfaces[0].material.diffuse", "surfaces[0].material.specular"],
         "a lamp and the reflectances")
    dull = scene.changed({"surfaces[0].material.specular": 0})
    values = [probe.value for probe in dull.probe(points)]
    told(dull.fit(["lights[0].intensity", "surfaces[0].material.shininess"], values, points), 1,
         ["surfaces[0].material.shininess"], "the shininess without a highlight")
    sky = desk()
    sky.append("lights", {"type": "ambient", "irradiance": 20})
    sky.append("lights", {"type": "distant", "direction": [.3, 0, -1], "irradiance": 30})
    told(fit(sky, measure(sky, lattice(4, 3)), lattice(4, 3), ["lights[0].intensity", "lights[1].irradiance",
                                                               "lights[2].irradiance"]), 2,
         ["lights[1].irradiance", "lights[2].irradiance"], "ambient light and a distant lamp on a plate")
    far = desk((2000, 1500, 20000), 1e6, attenuation="practical", k=20000)
    told(fit(far, measure(far, lattice(4, 3)), lattice(4, 3), ["lights[0].intensity", "lights[0].k"], noise="5%",
             starts=1), 1, ["lights[0].intensity", "lights[0].k"], "the law of a lamp that is far")


def outliers(tap, tool):
    places, truth = lattice(6, 5), numpy.array([2100, 1700, 2600, 1000.])
    random = numpy.random.default_rng(2)
    values = measure(desk(), places) * (1 + .01 * random.normal(size=30))
    values[[3, 11, 20]] *= 1.8
    off = {loss: numpy.abs(numbers(fit(desk(), values, places, loss=loss, starts=2)) / truth - 1).max()
           for loss in ("gaussian", "huber", "tukey")}
    tap.ok(off["huber"] < .5 * off["gaussian"] and off["tukey"] < .03 < off["gaussian"], "how far off", off)
    found = fit(desk(), values, places, loss="tukey", noise="1%", starts=2)
    tap.equal(found.outliers, 3, "which are told")
    tap.ok(all(abs(parameter.value - exact) < 3 * parameter.sd for parameter, exact in zip(found.parameters, truth)),
           "with Tukey's loss the bars hold", found.parameters)


def saturated(tap, tool):
    """Above 120 lx the meter tells nothing; without that height is biased."""
    places, random = lattice(5, 4), numpy.random.default_rng(9)
    exact, limit = measure(desk(), places), 200.
    kept, counted = [], []
    for _ in range(60):
        values = exact + 5 * random.normal(size=20)
        values = numpy.minimum(values, limit)
        found = fit(desk(), values, places, ["lights[0].intensity"], noise=5, saturated=limit, starts=1)
        below = numpy.where(values < limit, values, numpy.nan)
        kept.append(fit(desk(), below, places, ["lights[0].intensity"], noise=5, starts=1).parameters[0].value)
        counted.append((found.parameters[0].value - 1000) / found.parameters[0].sd)
    tap.ok(found.saturated > 3 and abs(numpy.mean(counted)) < .4 and .75 < numpy.std(counted) < 1.25,
           "counted for what they are", found.saturated, numpy.mean(counted), numpy.std(counted))
    tap.ok(numpy.mean(kept) <= 1001, "those that are left out alone bias it low", numpy.mean(kept))
    tap.ok(raises(luxel.LuxelError, fit, desk(), values, places, saturated=1.), "all are saturated")


def levels(tap, tool):
    """Eight bits, rounded down, of a picture known only up to a factor."""
    scene = luxel.Scene("report")
    scene.update({"screen.resolution": [48, 48], "lights[0].position": [800, 300, 2200],
                  "lights[0].attenuation": "inverse-square"})
    picture = scene.render(precision="double").values
    seen = scene.geometry().mask
    values = numpy.floor(255 * picture / picture.max())
    start = scene.changed({"lights[0].position": [700, 350, 2000]})
    found = start.fit("lights[0].position", values, relative=True, quantum=1, truncated=True)
    off = numbers(found)[:3] - [800, 300, 2200]
    tap.ok(found.rank == 4 and found.parameters[3].key == "factor" and numpy.abs(off).max() < 40 and
           (numpy.abs(off) < 4 * numpy.array([one.sd for one in found.parameters[:3]])).all(), "where the lamp is", off,
           found.parameters)
    biased = start.fit("lights[0].position", values, relative=True)
    tap.ok(numpy.abs(numbers(biased)[:3] - [800, 300, 2200]).max() > numpy.abs(off).max(), "half a level counts")
    both = start.fit(LAMP, values, relative=True, quantum=1, truncated=True)
    tap.ok([one.value is None for one in both.parameters] == [False] * 3 + [True] * 2 and both.rank == 4,
           "the intensity goes with the factor", both.parameters, both.undetermined)
    tap.ok(found.residuals.shape == (48, 48) and numpy.isnan(found.residuals[~seen]).all() and
           numpy.nanmax(numpy.abs(found.residuals)) < 2, "residuals")


def quick(tap, tool):
    """A picture of 64 x 64 pixels, with a lamp, its intensity and the shininess."""
    scene = luxel.Scene("report")
    scene["screen.resolution"] = [64, 64]
    picture = scene.render(precision="double")
    start = scene.changed({"lights[0].position": [1800, 200, 2300], "lights[0].intensity": 8,
                           "surfaces[0].material.shininess": 15})
    start["lights[0].attenuation"] = scene["lights[0].attenuation"]
    keys = LAMP + ["surfaces[0].material.shininess"]
    seconds = []
    for _ in range(3):
        begin = time.perf_counter()
        found = start.fit(keys, picture)
        seconds.append(time.perf_counter() - begin)
    tap.ok(found.converged and numpy.abs(numbers(found) - [2000, 0, 2000, 10, 20]).max() < 1e-5, "found",
           numbers(found))
    print("# a fit to 64 x 64 pixels takes %.0f ms" % (1000 * min(seconds)))
    tap.ok(min(seconds) < 2, "and quickly", seconds)


def wrong(tap, tool):
    scene, places = desk(), lattice(3, 3)
    values = measure(scene, places)
    for what, arguments, named, word in (
            ("fewer readings than unknowns", (scene, values[:3], places[:3]), {}, "readings: 3"),
            ("a number that is free twice", (scene, values, places, ["lights[0].position", "lights[0].position[1]"]),
             {}, "same number"),
            ("a choice", (scene, values, places, ["lights[0].type"]), {}, "vary continuously"),
            ("noise below 0", (scene, values, places), {"noise": -1.}, "noise")):
        error = raises(luxel.LuxelError, fit, *arguments, **named)
        tap.ok(error and word in str(error), what, error)
    error = raises(luxel.LuxelError, luxel.Scene("report").fit, "lights[0].intensity", [1., 2.],
                   [(0, 0), (4000, 0)])
    tap.ok(error and "reading 2" in str(error), "a reading off the surface", error)
    for what, arguments, named in (("no key", ([], values), {"elements": (places, UP)}),
                                   ("too few values", (LAMP, values[:5]), {"elements": (places, UP)}),
                                   ("a loss that there is not", (LAMP, values),
                                    {"elements": (places, UP), "loss": "l1"}),
                                   ("noise that is none", (LAMP, values), {"elements": (places, UP), "noise": "3%x"})):
        tap.ok(raises(ValueError, scene.fit, *arguments, **named), what)


if __name__ == "__main__":
    run_tests(Tap(), found_again, error_bars, least_errors, not_determined, outliers, saturated, levels, quick, wrong)
