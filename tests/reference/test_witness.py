# SPDX-License-Identifier: MIT
"""The witness of reflected light and daylight against closed forms, and rooms of luxel against the witness.

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


# The irradiance of a horizontal plane by pi times the zenith's radiance under kinds 1 to 16, the sun 60 and 30 degrees
# high: two orders of Gauss's rule in polar coordinates about the sun, which agree to 1e-12.
HORIZONTAL = (
    (.779713076812, .779713076812), (.664001809149, .813784472092), (.881714509487, .881714509487),
    (.737020791941, .919962381382), (1, 1), (.822563805189, 1.043364231443), (.770699937114, 1.169166723118),
    (.741146356118, 1.312416041501), (1.101136826948, 1.449186381964), (1.009125248115, 1.637676033184),
    (.951447602446, 1.851809612558), (1.015590860662, 2.035307105882), (.963158946694, 2.226646190044),
    (1.023989142609, 2.453563520524), (.959976859304, 2.583410489401), (7 / 9, 7 / 9))
# CIE 171, 5.9: a square metre of a black room's roof is open, in percent of the horizontal irradiance: of places G to J
# of the floor and B of a wall, kinds 5, 12 and 16, by adaptive cubature over the opening.
ROOF = {5: (1.9551898, 2.5227700, 3.0451840, 3.3670260, 2.3934970),
        12: (5.7225874, 6.0048155, 5.1131773, 3.9680372, 3.7569566),
        16: (2.2890722, 3.0739533, 3.8225396, 4.2944060, 1.7825983)}
UP = [0, 0, 1]


def sky(kind, altitude=60, azimuth=0, **more):
    return {'type': 'sky', 'kind': kind, 'sun': {'altitude': altitude, 'azimuth': azimuth}, **more}


def black_room(opening):
    return {'type': 'room', 'up': 'z', 'center': [2000, 2000, 1500], 'size': [4000, 4000, 3000],
            'openings': [opening], 'material': material(0)}


def try_open_skies(tap, program):
    for kind in range(1, 17):
        for truth, altitude in zip(HORIZONTAL[kind - 1], (60, 30)):
            [found] = witness.ask(program, [], [sky(kind, altitude, zenith=1)], [([0, 0, 0], UP)], batches=8)
            tap.ok(off(found, math.pi * truth) and found[1] < 2e-3 * found[0], 'kind %d, %d degrees' % (kind, altitude),
                   '%s, not %.9g' % (found, math.pi * truth))
    [found] = witness.ask(program, [], [sky(12, 25, 130, horizontal=1e4)], [([0, 0, 0], UP)], side=64, batches=8)
    tap.ok(off(found, 1e4), 'a sky by its horizontal irradiance', '%s' % (found,))
    for kind, truth in ((16, .39617707781931), (5, .5)):
        aside = [([0, 0, 0], [1, 0, 0])]
        [found] = witness.ask(program, [], [sky(kind, horizontal=1, ground=0)], aside, side=64, batches=8)
        tap.ok(off(found, truth), 'a vertical plane under kind %d' % kind, '%s, not %.9g' % (found, truth))
        [found] = witness.ask(program, [], [sky(kind, horizontal=1, ground=.3)], aside, side=64, batches=8)
        tap.ok(off(found, truth + .15), 'and with the ground', '%s, not %.9g' % (found, truth + .15))


def try_openings(tap, program):
    roof = black_room({'wall': 'ceiling', 'center': [0, 0], 'size': [1000, 1000]})
    places = [([2000, y, 0], UP) for y in (250, 750, 1250, 1750)] + [([2000, 0, 2250], [0, 1, 0])]
    for kind, truths in ROOF.items():
        said = witness.ask(program, [roof], [sky(kind, horizontal=100)], places, side=64, batches=8)
        for place, found, truth in zip(places, said, truths):
            tap.ok(off(found, truth) and found[1] < .01 * truth, 'roof, kind %d, %s' % (kind, place),
                   '%s, not %.9g' % (found, truth))
    for altitude, truth in ((90, .8814597855), (60, .8770467252), (30, .8015189826)):
        glazed = black_room({'wall': 'ceiling', 'center': [0, 0], 'size': [4000, 4000],
                             'glass': {'n': 1.52, 'transmittance': .96}})
        sun = {'type': 'sun', 'altitude': altitude, 'azimuth': 180, 'diameter': 0, 'irradiance': 100}
        [found] = witness.ask(program, [glazed], [sun], [([2000, 3900, 2990], UP)], side=4, batches=2)
        truth *= 100 * math.sin(math.radians(altitude))
        tap.ok(abs(found[0] - truth) < 1e-7, 'glass, a sun %d degrees high' % altitude, '%s, not %.9g' % (found, truth))
    sun = {'type': 'sun', 'altitude': 90, 'azimuth': 0, 'diameter': 40, 'irradiance': 100}
    [found] = witness.ask(program, [], [sun], [([0, 0, 0], UP)], side=64, batches=8)
    tap.ok(off(found, 100), 'a large sun', '%s' % (found,))


def try_furnaces(tap, program):
    """Where the same light comes from everywhere and nothing swallows any, each place receives pi times that."""
    everywhere = sky(5, zenith=1, ground=1)
    room = black_room({'wall': 'back', 'center': [300, 200], 'size': [1500, 1200]})
    room['openings'].append({'wall': 'ceiling', 'center': [-500, 600], 'size': [1000, 2000]})
    room['material'] = material(1)
    ball = {'type': 'sphere', 'center': [1500, 1500, 600], 'radius': 500, 'material': material(1)}
    places = [([2500, 3000, 0], UP), ([1500, 1500, 50], [0, 0, -1]), ([2300, 3990, 1000], [1, 0, 0]),
              ([0, 1000, 2900], [1, 0, 0]), ([2000, 5000, 1000], [0, 1, 0])]
    for place, found in zip(places, witness.ask(program, [room, ball], [everywhere], places, side=64, batches=8)):
        tap.ok(abs(found[0] - math.pi) <= FAR * found[1] + 1e-8, 'a furnace with openings, %s' % (place,),
               '%s' % (found,))
    ground = {'type': 'disk', 'center': [0, 0, 0], 'radius': 3000, 'axis': UP, 'material': material(.4)}
    for bounces, truth in ((0, 0), (1, math.pi * .4 * .9), (-1, math.pi * .4 * .9)):
        [found] = witness.ask(program, [ground], [sky(5, zenith=1)], [([0, 0, 1000], [0, 0, -1])], side=64, batches=8,
                              bounces=bounces)
        tap.ok(off(found, truth), 'over a disk, %d bounces' % bounces, '%s, not %.9g' % (found, truth))


def main():
    tap, program = Tap(), sys.argv[2]
    try_open_skies(tap, program)
    try_openings(tap, program)
    try_furnaces(tap, program)
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

    for seed in (7,):
        room = reflected_places.room_of(seed)
        room.places = room.places[::3]
        said = witness.ask(program, room.surfaces, room.lights, room.places, side=64, batches=16)
        for found, by_paths, place in zip(reflected_places.probe(sys.argv[1], room, 3e-2), said, room.places):
            tap.ok(abs(found[0] - by_paths[0]) <= found[1] + FAR * by_paths[1], 'room %d, %s' % (seed, place),
                   '%s, by paths %s' % (found, by_paths))
    tap.finish()


if __name__ == '__main__':
    main()
