# SPDX-License-Identifier: MIT
"""Layouts: those of the tool, from Python; the scene stays as it is; what is refused."""
import json

from package import Tap, luxel, raises, run_tests

HALL = """luxel: 1
units: photometric
screen: {width: 6000, height: 4000, resolution: [60, 40]}
observer: {z: 9000}
surfaces: [{type: room, center: [0, 0, 1400], size: [7200, 4800, 2800], up: z}]
lights:
  - {type: point, name: lamps, position: [0, 0, 2800], axis: [0, 0, -1], pattern: lambertian, power: 2880}
  - {type: point, name: spare, enabled: false, position: [0, 0, 2000], power: 100}
grids: [{name: desk, center: [0, 0, 750], size: [6200, 3800], n: [13, 9]}]
"""


def layouts(tap, tool):
    scene = luxel.Scene(HALL)
    before = scene.text
    shares = []
    found = scene.arrange("average>=500", "U0>=0.6", progress=shares.append)
    told = json.loads(tool.run("arrange", tool.write("hall.yaml", HALL), "--goal", "average>=500", "--goal", "U0>=0.6",
                               "--json").out)
    tap.equal([(list(layout.n), list(layout.spacing_mm), layout.reserve) for layout in found.layouts + found.missed],
              [(layout["n"], layout["spacing"], layout["reserve"]) for layout in told["layouts"] + told["missed"]],
              "those of the tool")
    best = found.layouts[0]
    tap.ok(best.luminaires == 9 and found.light == 0 and best.dimming == 1 and scene.text == before and
           best.scene["grids[0].limits.average"] == 500 and best.scene["lights[0].array.n"] == list(best.n),
           "nine, and their scene", best)
    tap.ok([of.limit.verdict for of in best.limits] == ["pass", "pass"] and
           best.limits[0].limit.value == best.scene.grid().average, "with what is judged", best.limits)
    tap.ok(shares and all(0 <= share <= 1 for share in shares) and shares == sorted(shares), "progress goes on", shares)
    tap.ok("columns" in found._repr_html_(), "a notebook shows it")
    even = scene.arrange("average>=500", "U0>=0.6", even=True).layouts[0]
    tap.ok(even.luminaires == 10 and even.spacing_mm == (7200 / even.n[0], 4800 / even.n[1]),
           "half a spacing from the walls it takes ten", even)
    tap.ok(scene.arrange("average>=500", "U0>=0.6", dimming=True).layouts[0].dimming < 1, "dimmed")


def keys(tap, tool):
    """Keys instead of numbers of luminaires: those of the tool."""
    hall = HALL.replace("power: 2880}", "power: 2880, array: {n: [3, 3], spacing: [1500, 900]}}")
    found = luxel.Scene(hall).arrange("average>=500", "U0>=0.6", free="lights[0].array.spacing")
    told = json.loads(tool.run("arrange", tool.write("hall.yaml", hall), "--goal", "average>=500", "--goal", "U0>=0.6",
                               "--free", "lights[0].array.spacing", "--json").out)
    tap.equal([(layout.numbers, layout.reserve) for layout in found.layouts],
              [(layout["numbers"], layout["reserve"]) for layout in told["layouts"]], "those of the tool")
    best = found.layouts[0]
    spacing = [best.numbers["lights[0].array.spacing[%d]" % k] for k in range(2)]
    free = luxel.Scene(HALL).arrange("average>=500", "U0>=0.6").layouts[0]
    tap.ok(found.light is None and best.scene["lights[0].array.spacing"] == spacing and
           best.reserve > free.reserve - 1e-3, "as good as the search of spacings", best, free)
    tap.ok("spacing[1]" in found._repr_html_(), "a notebook shows it")
    error = raises(luxel.LuxelError, lambda: luxel.Scene(hall).arrange("average>=500", free=["lights[0].type"]))
    tap.ok(error and "numbers" in str(error), "no key of numbers")


def refused(tap, tool):
    scene = luxel.Scene(HALL)
    for goals, options, words in (((), {}, "no grid has a goal"), (("avg>=5", "U0<=0.6"), {}, "avg>=5"),
                                  (("average>=5",), {"light": "lamp"}, "no light of that name"),
                                  (("average>=5",), {"light": "spare"}, "is on")):
        error = raises(luxel.LuxelError, lambda: scene.arrange(*goals, **options))
        tap.ok(error and words in str(error), words, error)
    tap.ok(raises(TypeError, lambda: scene.arrange(5)), "a goal is a text")
    none = scene.arrange("U0>=0.99", most=6)
    tap.ok(none.layouts == [] and none.missed[0].reserve < 1, "what cannot be reached is no error", none.missed[:1])


if __name__ == "__main__":
    run_tests(Tap(), layouts, keys, refused)
