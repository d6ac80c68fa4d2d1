# SPDX-License-Identifier: MIT
"""The time of derivatives by ten numbers at a million elements, as a multiple of the time of the values alone.

    PYTHONPATH=build/python bench/derivatives.py [ELEMENTS]

Both by one thread, in processor time, the best of several runs that take turns.
"""
import sys
import time

import numpy

import luxel

SCENE = """luxel: 1
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
surfaces: [{type: sphere, center: [0, 0, 1000], radius: 150}]
lights:
  - {type: point, position: [1000, 2000, 3000], intensity: 100}
  - {type: spot, position: [-500, 0, 3000], aim: [0, 0, 0], intensity: 100, inner: 20, outer: 50}
"""
WAYS = {
    "two lamps: places, strengths, cone, on planes": (
        "irradiance", ["lights[0].position", "lights[0].intensity", "lights[1].position", "lights[1].intensity",
                       "lights[1].inner", "lights[1].outer"]),
    "two lamps: places, one strength; kd, ks, n": (
        "brightness", ["lights[0].position", "lights[0].intensity", "lights[1].position",
                       "surfaces[0].material.diffuse", "surfaces[0].material.specular",
                       "surfaces[0].material.shininess"]),
    "one lamp: place, strength, aim, cone, on planes": (
        "irradiance", ["lights[1].position", "lights[1].intensity", "lights[1].aim", "lights[1].inner",
                       "lights[1].outer", "maintenance_factor"]),
}


def time_of(function):
    start = time.process_time()
    function()
    return time.process_time() - start


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000000
    places = numpy.random.default_rng(5).uniform(-3000, 3000, (count, 3)) * [1, 1, 0]
    print("| %d elements | values, ns | ten derivatives, ns | ratio |\n|---|---|---|---|" % count)
    for name, (quantity, keys) in WAYS.items():
        scene = luxel.Scene(SCENE + "maintenance_factor: 0.8\n")
        named = {"quantity": quantity, "threads": 1}
        values, derived = [], []
        for _ in range(4):
            values.append(time_of(lambda: scene.evaluate(places, [0, 0, 1], **named)))
            derived.append(time_of(lambda: scene.jacobian(keys, elements=(places, [0, 0, 1]), **named)))
        value, slope = (min(times) / count * 1e9 for times in (values, derived))
        print("| %s | %.0f | %.0f | %.1f |" % (name, value, slope, slope / value))


if __name__ == "__main__":
    main()
