#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Times reflected light in rooms: processor time until bounds are reached; prints a part of the page of compare.py.

Usage: rooms.py LUXEL [SECONDS [ROOM...]]: no run takes longer than that, 60 s unless it is given.
"""
import json
import math
import os
import resource
import subprocess
import sys

LAMP = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'files', 'office-lamp.ies')
BOUNDS = (1e-1, 1e-2, 1e-3)
MOST_S = 60.0
MISSED = 5  # the exit code where a bound is not reached


def matte(reflectance):
    return {'model': 'lambert', 'diffuse': reflectance, 'over_pi': True}


def hull(x, y, z):
    """A room from 0 to x, y and z in mm; y is up."""
    return {'type': 'room', 'center': [x / 2, y / 2, z / 2], 'size': [x, y, z], 'material': matte(0.5),
            'materials': {'floor': matte(0.2), 'ceiling': matte(0.7)}}


def box(x, z, size, turn, foot=0.0):
    return {'type': 'box', 'center': [x, foot + size[1] / 2, z], 'size': size, 'rotate': [0, turn, 0],
            'material': matte(0.5)}


def board(center, size, axis, up):
    return {'type': 'rectangle', 'center': center, 'size': size, 'axis': axis, 'up': up, 'material': matte(0.5)}


def panel(x, y, z, across, along):
    return {'type': 'planar', 'power': 3600,
            'rectangle': {'center': [x, y, z], 'size': [across, along], 'axis': [0, -1, 0], 'up': [0, 0, 1]}}


def ends(x, y, z):
    """Places in the middle of the floor, of a wall and of the ceiling, near to a corner, and in the air."""
    return [([0.5 * x, 0, 0.45 * z], [0, 1, 0]), ([x, 0.4 * y, 0.6 * z], [-1, 0, 0]),
            ([0.35 * x, y, 0.3 * z], [0, -1, 0]), ([0.04 * x, 0, 0.05 * z], [0, 1, 0]),
            ([0.3 * x, 0.4 * y, 0.7 * z], [0, 1, 0])]


def office(things=(), lights=None):
    size = (5000, 2800, 4000)
    return [hull(*size), *things], lights or [panel(2500, 2700, 2000, 600, 600)], ends(*size)


def desks():
    return [board([x, 720, z], [1400, 700], [0, 1, 0], [0, 0, 1]) for x in (1200, 3600) for z in (900, 3000)]


def boxes():
    return [box(700 + 1200 * (i % 4), 900 + 2100 * (i // 4), [420, 500 + 60 * i, 300], 17 * i) for i in range(8)]


def blinds():
    return [board([4800, 900 + 120 * i, 2000], [100, 1600], [math.sin(0.7), math.cos(0.7), 0], [0, 0, 1])
            for i in range(12)]


def shelves():
    sides = [board([x, 1000, 250], [2000, 400], [1, 0, 0], [0, 0, 1]) for x in (1000, 2200)]
    return sides + [board([1600, 300 + 400 * i, 250], [1190, 400], [0, 1, 0], [0, 0, 1]) for i in range(5)]


def twelve(**more):
    size = (8000, 2800, 6000)
    lights = [{'type': 'luminaire', 'file': LAMP, 'position': [1000 + 2000 * (i % 4), 2799, 1000 + 2000 * (i // 4)],
               'axis': [0, -1, 0], **more} for i in range(12)]
    return [hull(*size)], lights, ends(*size)


def corridor():
    size = (12000, 2600, 1800)
    return [hull(*size)], [panel(1500 + 3000 * i, 2550, 900, 600, 150) for i in range(4)], ends(*size)


COLUMN = {'type': 'cylinder', 'center': [2000, 1400, 1300], 'radius': 200, 'height': 2790, 'axis': [0, 1, 0],
          'material': matte(0.5)}


def day(things=(), sun=False):
    """By a window with glass in the left wall, under a clear sky."""
    surfaces, _, places = office(things)
    surfaces[0]['openings'] = [{'wall': 'left', 'center': [0, 100], 'size': [2000, 1400],
                                'glass': {'n': 1.52, 'transmittance': 0.96}}]
    stand = {'up': [0, 1, 0], 'north': [0, 0, -1]}
    lights = [{'type': 'sky', 'kind': 12, 'horizontal': 12000, 'ground': 0.2,
               'sun': {'altitude': 40, 'azimuth': 290}, **stand}]
    if sun:
        lights.append({'type': 'sun', 'altitude': 40, 'azimuth': 290, 'irradiance': 60000, **stand})
    return surfaces, lights, places


def sphere_with_port():
    """Any wall above the port has 1000 lm / (4 pi R^2) / (1 - rho (1 - f)) = 4613.19 lx."""
    things = [{'type': 'sphere', 'center': [0, 0, 0], 'radius': 500, 'inside': True, 'material': matte(0.95)},
              {'type': 'disk', 'center': [0, -480, 0], 'radius': 140, 'axis': [0, 1, 0], 'material': matte(0)}]
    places = [([500, 0, 0], [-1, 0, 0]), ([0, -480, 0], [0, 1, 0])]
    return things, [{'type': 'point', 'position': [0, 0, 0], 'power': 1000}], places


ROOMS = {
    'empty': office,
    'four desks': lambda: office(desks()),
    'eight turned boxes': lambda: office(boxes()),
    'round column': lambda: office([COLUMN]),
    'ball': lambda: office([{'type': 'sphere', 'center': [2000, 700, 1300], 'radius': 300, 'material': matte(0.5)}]),
    'shelves': lambda: office(shelves()),
    'blinds of 12 slats': lambda: office(blinds()),
    'corridor, 4 panels': corridor,
    '12 luminaires': twelve,
    '12 luminaires with openings': lambda: twelve(opening='file'),
    'sphere with port': sphere_with_port,
    'window, clear sky': day,
    'window, sky and sun, four desks': lambda: day(desks(), sun=True),
    'window, sky and sun, round column': lambda: day([COLUMN], sun=True),
}


def probe(luxel, room, bound, most_s):
    """Processor seconds, whether the bound was reached, the greatest bound that was, and the values; None: it took too
    long."""
    surfaces, lights, places = room
    scene = {'luxel': 1, 'units': 'photometric', 'reflections': 'all', 'surfaces': surfaces, 'lights': lights,
             'screen': {'width': 2000, 'height': 1500, 'resolution': [20, 15]}, 'observer': {'z': 99000}}
    command = [luxel, 'probe', '-', '--quantity', 'irradiance', '--threads', '1', '--json', '--reflected-error',
               '%g' % bound]
    for place, normal in places:
        command += ['--at', ','.join('%.9f' % x for x in place + normal)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(most_s), math.ceil(most_s)))
    done = subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False,
                          preexec_fn=limit)
    taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if done.returncode < 0:
        return None
    if done.returncode not in (0, MISSED):
        sys.exit(done.stderr)
    points = json.loads(done.stdout)['points']
    reached = max(point['reflected']['error'] / point['value'] for point in points)
    return taken, done.returncode == 0, reached, [point['value'] for point in points]


def cell(found, most_s):
    if found is None:
        return '> %.0f' % most_s
    taken, is_reached, reached, _ = found
    return ('%.2f' % taken if taken < 10 else '%.0f' % taken) + ('' if is_reached else ', only %.1e' % reached)


def off(found):
    """How far the values are from the most exact ones, and the bound over that, at the median of the places."""
    whole = [answer for answer in found if answer]
    if len(whole) < 2:
        return '', ''
    truth, (_, _, bound, values) = whole[-1][3], whole[0]
    errors = sorted(abs(value - true) / true for value, true in zip(values, truth))
    middle = errors[len(errors) // 2]
    return '%.0e' % errors[-1], '%.0f' % (bound / middle) if middle > 0 else ''


def print_table(luxel, most_s=MOST_S, names=None):
    print('## Rooms\n\nReflected light at five places (`luxel probe --threads 1`), user seconds until the bound is '
          'reached, relative to the value\n(`--reflected-error`); no more than %.0f s each. *Error at 1e-1*: the '
          'greatest difference from the most exact run of the same room,\nand the printed bound over the one in the '
          'middle.\n' % most_s)
    print('| room | 1e-1 | 1e-2 | 1e-3 | error at 1e-1 | bound over it |\n|---|---:|---:|---:|---:|---:|')
    for name, make in ROOMS.items():
        if names and name not in names:
            continue
        found = []
        for bound in BOUNDS:
            found.append(probe(luxel, make(), bound, most_s) if not found or found[-1] else None)
        print('| %s | %s | %s |' % (name, ' | '.join(cell(answer, most_s) for answer in found),
                                     ' | '.join(off(found))), flush=True)
    print()


if __name__ == '__main__':
    print_table(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else MOST_S, sys.argv[3:])
