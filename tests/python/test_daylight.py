# SPDX-License-Identifier: MIT
"""Daylight factors, hours and patches of sun: as the tool tells them, parts that add up, what is refused."""
import datetime

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
    tap.equal(grid.without_sky, told["grids"][0]["without_sky"], "the share without sky")
    high = luxel.Scene(SCENE.replace("[0, 0, -700]", "[0, 0, 1000]")).daylight().grids[0]
    tap.equal(high.without_sky, 1, "no sky is seen from above the window")
    tap.ok(numpy.abs(grid.sky + grid.external + grid.internal - grid.values).max() < 1e-9, "parts add up", grid)
    tap.ok(found.elements[1].sky.value == 0 < found.elements[1].external.value, "a ceiling sees the ground", found)
    tap.ok("desk" in found._repr_html_() and found.reached and found.horizontal.value == 10000, "a table", found)


def test_sun(tap, tool):
    text = SCENE.replace("ground: .3}]", "ground: .3}, {type: sun, irradiance: 1, date: '2026-03-21T16:00+01:00', "
                         "latitude: 52.5, longitude: 13.4}]")
    scene = luxel.Scene(text)
    found = scene.sunlight("2026-03-21+01:00", [(-1900, 0, 0, -1, 0, 0)])
    told = tool.run("daylight", "-", "--json", "--sun-hours", "2026-03-21+01:00", "--at", "-1900,0,0,-1,0,0",
                    stdin=text).json()
    cells = [[cell["hours"] for cell in row] for row in told["grids"][0]["cells"]]
    tap.equal(found.grids[0].hours.tolist(), cells, "the tool's hours")
    one, same = found.elements[0], told["elements"][0]
    tap.ok((one.hours, one.level, [list(span) for span in one.spans]) == (
        same["hours"], same["en17037"], [[span["from_s"], span["to_s"]] for span in same["spans"]]) and
        one.hours > 3, "an element", one, same)
    tap.ok(found.offset == datetime.timedelta(hours=1) and found.latitude == 52.5 and "P1" in found._repr_html_() and
           found.open.hours > 12, "the day", found)
    far = scene.sunlight(datetime.date(2026, 6, 21), place=(75, 20), least_altitude=0)
    tap.equal((far.open.hours, far.open.level), (24, None), "another place, and a day that has no level")
    patches = scene.sun_patches()
    same = tool.run("daylight", "-", "--json", "--sun-patches", stdin=text).json()["patches"]
    tap.ok(len(patches) == len(same) > 0 and all(
        (patch.part, patch.room, patch.opening, patch.area / 1e6, patch.corners.tolist(), list(patch.others)) ==
        (other["part"], other["room"], other["opening"], other["area_m2"], other["corners_mm"], other["others"])
        for patch, other in zip(patches, same)), "the tool's patches", patches, same)
    tap.ok("midsummer" in str(raises(luxel.LuxelError, scene.sunlight, "midsummer")), "a date")
    tap.ok("sun" in str(raises(luxel.LuxelError, luxel.Scene(SCENE).sun_patches)), "no sun")
    tap.ok("latitude" in str(raises(luxel.LuxelError, luxel.Scene(SCENE).sunlight, "2026-03-21")), "no place")


def test_refused(tap, tool):
    scene = luxel.Scene(SCENE)
    tap.ok("sky" in str(raises(luxel.LuxelError, luxel.Scene(SCENE.replace("sky, kind: 16", "ambient").replace(
        "horizontal: 10000, ground: .3", "irradiance: 1")).daylight)), "no sky")
    raises(TypeError, scene.daylight, [(0, 0, 0)])


if __name__ == "__main__":
    run_tests(Tap(), test_factors, test_sun, test_refused)
