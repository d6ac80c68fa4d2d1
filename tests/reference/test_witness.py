# SPDX-License-Identifier: MIT
"""The witness of reflected light against closed forms, and rooms of luxel against the witness.

    test_witness.py LUXEL WITNESS
"""
import math
import sys

import reflected_places
import witness
from tap import Tap

FAR = 5  # standard errors


def material(reflectance):
    return {'diffuse': reflectance}


def off(found, truth):
    return abs(found[0] - truth) <= FAR * found[1] + 1e-9 * truth


def main():
    tap, program = Tap(), sys.argv[2]
    ball = {'type': 'sphere', 'center': [0, 0, 0], 'radius': 700, 'material': material(0.6)}
    lamp = {'type': 'point', 'position': [100, 200, -300], 'power': 500}
    [found] = witness.ask(program, [ball], [lamp], [([0, -700, 0], [0, 1, 0])], side=64, batches=8)
    square = (0.1 ** 2 + 0.9 ** 2 + 0.3 ** 2)
    direct = 500 / (4 * math.pi) / square * 0.9 / math.sqrt(square)
    truth = direct + 0.6 / 0.4 * 500 / (4 * math.pi * 0.7 ** 2)
    tap.ok(off(found, truth), 'inside a ball all places receive as much of what is reflected',
           '%s, not %.9g' % (found, truth))

    # A square plate over a small patch, straight above it: Lambert's formula.
    plate = {'type': 'planar', 'power': 100,
             'rectangle': {'center': [0, 1000, 0], 'size': [1000, 1000], 'axis': [0, -1, 0], 'up': [0, 0, 1]}}
    [found] = witness.ask(program, [], [plate], [([0, 0, 0], [0, 1, 0])], side=64, batches=8)
    a = 0.5 / math.sqrt(1.25)
    truth = 100 / math.pi * 4 * a * math.atan(a)
    tap.ok(off(found, truth), 'a square plate straight above', '%s, not %.9g' % (found, truth))

    # A plate that reflects lights the place from below a globe, which hides nothing.
    globe = {'type': 'volume', 'sphere': {'center': [0, 2000, 0], 'radius': 100}, 'power': 80}
    [found] = witness.ask(program, [], [globe], [([0, 0, 0], [0, 1, 0])], side=64, batches=8)
    truth = 80 / (4 * math.pi) / 4
    tap.ok(off(found, truth), 'a globe is as bright as a point', '%s, not %.9g' % (found, truth))

    for seed in (4, 7):
        room = reflected_places.room_of(seed)
        room.places = room.places[::3]
        said = witness.ask(program, room.surfaces, room.lights, room.places, side=64, batches=16)
        for found, by_paths, place in zip(reflected_places.probe(sys.argv[1], room, 3e-2), said, room.places):
            tap.ok(abs(found[0] - by_paths[0]) <= found[1] + FAR * by_paths[1], 'room %d, %s' % (seed, place),
                   '%s, by paths %s' % (found, by_paths))
    tap.finish()


if __name__ == '__main__':
    main()
