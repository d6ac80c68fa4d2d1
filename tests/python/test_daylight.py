# SPDX-License-Identifier: MIT
"""Daylight factors: as the tool tells them, parts that add up, what is refused."""
import numpy

from package import Tap, luxel, raises, run_tests

SCENE = """luxel: 1
units: photometric
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
surfaces:
  - {type: room, up: z, center: [0, 0, 0], size: [4000, 4000, 3000], material: {model: lambert},
     openings: [{wall: left, size: [2000, 1000]}]}
lights: [{type: sky, kind: 16, horizontal: 10000, ground: .3}]
grids: [{name: desk, center: [0, 0, -700], size: [3000, 3000], n: [3, 2]}]
"""


def test_factors(tap, tool):
    scene = luxel.Scene(SCENE)
    found = scene.daylight([(0, 0, -700, 0, 0, 1), (1000, 0, 1500, 0, 0, -1)])
    told = tool.run("daylight", "-", "--json", "--at", "0,0,-700,0,0,1", "--at", "1000,0,1500,0,0,-1",
                    stdin=SCENE).json()
    grid = found.grids[0]
    for key in ("values", "errors", "sky", "external", "internal"):
        tap.equal(getattr(grid, key).tolist(), told["grids"][0][key], "the tool's " + key)
    tap.equal((grid.mean.value, grid.median.value), (told["grids"][0]["mean"], told["grids"][0]["median"]), "means")
    tap.equal(list(grid.shares.values()), list(told["grids"][0]["en17037"]["shares"].values()), "shares")
    tap.equal([[element.value.value, element.sky.value, element.external.value] for element in found.elements],
              [[element[key] for key in ("daylight_factor", "sky", "external")] for element in told["elements"]],
              "elements")
    tap.ok(numpy.abs(grid.sky + grid.external + grid.internal - grid.values).max() < 1e-9, "parts add up", grid)
    tap.ok(found.elements[1].sky.value == 0 < found.elements[1].external.value, "a ceiling sees the ground", found)
    tap.ok("desk" in found._repr_html_() and found.reached and found.horizontal.value == 10000, "a table", found)


def test_refused(tap, tool):
    scene = luxel.Scene(SCENE)
    tap.ok("sky" in str(raises(luxel.LuxelError, luxel.Scene(SCENE.replace("sky, kind: 16", "ambient").replace(
        "horizontal: 10000, ground: .3", "irradiance: 1")).daylight)), "no sky")
    raises(TypeError, scene.daylight, [(0, 0, 0)])


if __name__ == "__main__":
    run_tests(Tap(), test_factors, test_refused)
