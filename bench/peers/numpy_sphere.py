# SPDX-License-Identifier: MIT
"""The exercise as it is usually programmed: whole arrays in NumPy, one source after the other.

Prints the best time of some runs in ms.  Usage: numpy_sphere.py SIDE LIGHTS RUNS [ATTENUATED]
"""
import math
import sys
import time

import numpy


def picture(side, lights, attenuated):
    radius, depth, shininess, diffuse, specular = 360.0, 1000.0, 20, 0.8, 0.5
    places = (numpy.arange(side) + 0.5) / side * 500 - 250
    x, y = numpy.meshgrid(places, -places)
    height = numpy.sqrt(numpy.maximum(radius ** 2 - x ** 2 - y ** 2, 0))
    points = numpy.stack([x, y, depth + height], axis=-1)
    normals = (points - numpy.array([0, 0, depth])) / radius
    view = numpy.array([0.0, 0.0, 1.0])
    brightness = numpy.zeros((side, side))
    for i in range(lights):
        angle = 2 * math.pi * i / lights
        light = numpy.array([2000 * math.cos(angle), 2000 * math.sin(angle), 2500])
        towards = light - points
        distance = numpy.linalg.norm(towards, axis=-1, keepdims=True)
        towards = towards / distance
        cosine = numpy.maximum(numpy.sum(normals * towards, axis=-1), 0)
        half = towards + view
        half = half / numpy.linalg.norm(half, axis=-1, keepdims=True)
        shine = numpy.maximum(numpy.sum(normals * half, axis=-1), 0) ** shininess
        strength = 10.0 / (distance[..., 0] / 1000) ** 2 if attenuated else 10.0
        brightness += strength * (diffuse * cosine + specular * shine)
    return brightness


def main():
    side, lights, runs = (int(argument) for argument in sys.argv[1:4])
    attenuated = "attenuated" in sys.argv[4:]
    best = math.inf
    for _ in range(runs):
        start = time.perf_counter()
        maximum = picture(side, lights, attenuated).max()
        best = min(best, time.perf_counter() - start)
    print("%.3f %.6f" % (1e3 * best, maximum))


main()
