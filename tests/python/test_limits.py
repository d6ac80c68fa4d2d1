# SPDX-License-Identifier: MIT
"""Limits, observers and rooms as the tool has them."""
import pickle

from package import Tap, luxel, raises, run_tests

MORE = {"grids": [{"name": "floor", "center": [0, 1, 2700], "size": [3000, 3000], "axis": [0, 1, 0], "up": [0, 0, -1],
                   "n": [3, 3], "limits": {"average": 100, "minimum": 1e5, "ratio": 40}}],
        "observers": [{"name": "desk", "eye": [0, 1200, 5300], "view": [0, 0, -1], "limits": {"ugr": 28}},
                      {"eye": [0, 1200, 5000], "view": [0, 0, -1]}],
        "reflections": 1, "maintenance_factor": 0.8}


def test_limits(tap, tool):
    scene = luxel.Scene("office").changed(MORE)
    scene.save("office.yaml")
    result = tool.run("grid", "office.yaml", "--limits", "--json")
    told = result.json()
    grid = scene.grid()
    tap.equal([limit._asdict() for limit in grid.limits], told["grids"][0]["limits"], "of a grid")
    tap.equal([limit.verdict for limit in grid.limits], ["pass", "fail", "pass"], "verdicts")
    tap.equal(pickle.loads(pickle.dumps(grid)).limits, grid.limits, "pickled")
    observers = scene.observers()
    tap.equal([(seen.name, list(seen.eye_mm), list(seen.view), seen.glare.ugr, seen.glare.error,
                [limit._asdict() for limit in seen.limits]) for seen in observers],
              [(seen["name"], seen["eye"], seen["view"], seen["ugr"], seen["error"], seen.get("limits", []))
               for seen in told["observers"]], "of observers")
    tap.equal(observers[0].glare.ugr, scene.glare((0, 1200, 5300), (0, 0, -1)).ugr, "as scene.glare()")
    tap.equal((luxel.Scene("office").grid().limits, luxel.Scene("office").observers()), ((), []), "none")
    tap.ok(raises(ValueError, luxel.Scene("report").observers), "radiometric units")


def test_all_lights(tap, tool):
    scene = luxel.Scene("office")
    scene["lights[*].factor"] = 0.5
    tap.equal([scene["lights[%d].factor" % i] for i in range(4)], [0.5] * 4, "a key of all lights")
    tap.ok(raises(luxel.LuxelKeyError, scene.set, "lights[*].radius=3"), "one that none has")
    tap.equal(scene["lights[0].factor"], 0.5, "it changes nothing")


def test_room(tap, tool):
    room = luxel.room(6, 4, 3, target=300, maintenance=0.9)
    made = tool.run("room", "6,4,3", "--target", "300", "--maintenance", "0.9")
    tap.equal(room.text, made.out, "the text")
    grid = room.scene.grid()
    tap.equal((grid.average, grid.average_error, grid.u0), (*room.chosen.average, room.chosen.uniformity),
              "its numbers")
    tap.ok(room.smaller.average[0] < 300 <= grid.average, "the least array", room)
    tap.equal({limit.verdict for limit in grid.limits}, {"pass"}, "it keeps its limits")
    tap.ok(raises(luxel.LuxelError, luxel.room, 6, 4, 0), "no room")


run_tests(Tap(), test_limits, test_all_lights, test_room)
