# SPDX-License-Identifier: MIT
"""Bounds of daylight at places of random rooms with windows, and outdoors, against an independent witness.

    day_places.py LUXEL WITNESS SCENES [FIRST]

Rooms are those of reflected_places.py with openings, some of them glazed, and now and then a body of triangles; some
have lamps besides.  Outdoors bodies and lamps of all kinds stand on a plane, or a small house with an opening, which
has no glass, as reflected light from outside may not come through any.  The light is a sky of a kind of the CIE or of
Perez, with the ground or without, and the sun.  Places are on and beside things, in corners, near windows and shadows,
and free.  Each scene is asked without reflections, with some of them and with all, at several bounds.  The witness
follows paths at random (witness.c).  A value is dishonest where it is further from what the witness says than its bound
and four standard errors, by sixteen times as many paths, too.  Prints each scene with its errors as shares of the
bounds, and ends with `N passed, N failed`.
"""
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile

import perez
import reflected_places
import witness
from reflected_places import FAR, MORE_PATHS, MOST_S, PATHS, is_honest, little, material

UP, NORTH = [0, 1, 0], [0, 0, -1]
OPTIONS = {'direct': ('none', '1e-3', 0), 'fine': ('none', '1e-9', 0), 'twice': ('2', '3e-2', 2),
           'coarse': ('all', '1e-1', -1), 'middle': ('all', '3e-2', -1), 'close': ('all', '1e-2', -1)}


def sky(draw):
    altitude, azimuth = draw.choice([3, 15, 30, 45, 60, draw.uniform(1, 89.9)]), draw.uniform(0, 360)
    stand = {'up': UP, 'north': NORTH, 'ground': draw.choice([0, 0.1, 0.3])}
    sun = {'altitude': altitude, 'azimuth': azimuth}
    direct, diffuse = draw.uniform(0, 60000), draw.uniform(3000, 30000)
    if draw.random() < 0.25 and perez.coefficients(direct, diffuse, altitude, 127500):
        made = {'type': 'sky', 'model': 'perez', 'direct': direct, 'diffuse': diffuse,
                'extraterrestrial': 127500, 'sun': sun, **stand}
    else:
        kind = draw.choice([1, 5, 12, 16, 16, draw.randint(1, 16)])
        made = {'type': 'sky', 'kind': kind, draw.choice(['zenith', 'horizontal']): 5000, 'sun': sun, **stand}
    lights = [made]
    if draw.random() < 0.4:
        lights.append({'type': 'sun', **sun, 'up': UP, 'north': NORTH, 'irradiance': 20000,
                       'diameter': draw.choice([0.533, 0.533, 0, 5])})
    return lights


def glaze(draw, opening):
    if draw.random() < 0.5:
        opening['glass'] = {'n': draw.choice([1.52, 1.3]), 'transmittance': draw.choice([0.96, 0.6])}
    return opening


class Triangles:
    """A body of triangles with its file."""

    def __init__(self, folder):
        self.folder, self.count = folder, 0

    def make(self, draw, foot, size, reflectance):
        """A tetrahedron with a side on its foot, and its top; places on it."""
        turn = draw.uniform(0, 2 * math.pi)
        ring = [[foot[0] + size * math.cos(turn + k * 2 * math.pi / 3), foot[1],
                 foot[2] - size * math.sin(turn + k * 2 * math.pi / 3)] for k in range(3)]
        top = [foot[0] + draw.uniform(-0.5, 0.5) * size, foot[1] + draw.uniform(0.5, 2) * size, foot[2]]
        name = os.path.join(self.folder, 'body%d.obj' % self.count)
        self.count += 1
        with open(name, 'w', encoding='ascii') as file:
            file.writelines('v %.17g %.17g %.17g\n' % tuple(corner) for corner in ring + [top])
            file.write('f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n')
        edges = [[b - a for a, b in zip(ring[0], corner)] for corner in (ring[1], top)]
        middle = [sum(x) / 3 for x in zip(ring[0], ring[1], top)]
        thing = {'type': 'mesh', 'file': name, 'material': material(reflectance)}
        return thing, [(middle, witness.unit(witness.cross(*edges)))]


class DayRoom:
    """What makes a room one with windows: mixed into rooms of the other campaign."""
    folder = None

    def furnish(self):
        draw = self.random
        if draw.random() < 0.2:
            x, z, size = draw.uniform(0.25, 0.75) * self.size[0], draw.uniform(0.25, 0.75) * self.size[2], 300
            if all(math.hypot(x - u, z - v) > size + r for u, v, r in self.spots):
                self.spots.append((x, z, size))
                thing, places = self.triangles.make(draw, [x, draw.choice([0, 100]), z], size, self.reflectance())
                thing['center'], thing['radius'] = [x, 0, z], size
                self.surfaces.append(thing)
                self.places += places
                self.places.append(([x + size + little(draw), 0, z], UP))
            return
        super().furnish()

    def beside(self, thing):
        return [] if thing['type'] == 'mesh' else super().beside(thing)

    def lamps(self):
        super().lamps()
        if self.random.random() < 0.6 and not getattr(self, 'recess', None):
            self.lights = []

    def look_near(self):
        super().look_near()
        draw, (length, height, width) = self.random, self.size
        room = self.surfaces[0] if self.surfaces[0]['type'] == 'room' else None
        walls = {'left': (width, height), 'right': (width, height), 'back': (length, height),
                 'front': (length, height), 'ceiling': (length, width)}
        for wall in draw.sample(list(walls), draw.choice([1, 1, 2, 3])) if room else []:
            whole = walls[wall]
            size = [draw.choice([0.5, 0.9, draw.uniform(0.1, 0.8)]) * x for x in whole]
            middle = [draw.uniform(-0.5, 0.5) * (x - y) for x, y in zip(whole, size)]
            room.setdefault('openings', []).append(glaze(draw, {'wall': wall, 'center': middle, 'size': size}))
        self.lights += sky(draw)
        if room:
            self.look_at_windows(room)
        for thing in self.surfaces:
            if thing['type'] == 'mesh':
                del thing['center'], thing['radius']
        draw.shuffle(self.places)
        self.places = [place for place in self.places if not self.is_in_opening(place[0])][:12]

    def windows(self):
        """Openings with their middles, half vectors, and the ways inwards."""
        room = self.surfaces[0]
        for name, center, _ in witness.sides(room) if room['type'] == 'room' else ():
            for opening in room.get('openings', ()):
                if opening['wall'] == name:
                    numbers = [float(x) for x in witness.hole_line(opening, room, center).split()[1:10]]
                    inwards = witness.unit([a - b for a, b in zip(room['center'], center)])
                    yield numbers[:3], numbers[3:6], numbers[6:], inwards

    def is_in_opening(self, place):
        for middle, right, up, inwards in self.windows():
            from_it = [a - b for a, b in zip(place, middle)]

            def along(axis):
                return sum(a * b for a, b in zip(from_it, axis))
            if abs(along(inwards)) < 0.5 and all(abs(along(axis)) <= sum(x * x for x in axis) + 0.5 * math.hypot(*axis)
                                                 for axis in (right, up)):
                return True
        return False

    def look_at_windows(self, room):
        """Beside them, before them, and on the floor below."""
        draw = self.random
        for middle, right, up, inwards in self.windows():
            beyond = 1 + little(draw) / math.hypot(*right)
            s = draw.uniform(-0.8, 0.8)
            beside = [m + beyond * r + s * u for m, r, u in zip(middle, right, up)]
            if all(0 <= x <= size for x, size in zip(beside, self.size)):
                self.places.append((beside, inwards))
            before = [m + s * r + little(draw) * i for m, r, i in zip(middle, right, inwards)]
            self.places.append((before, draw.choice([inwards, [-x for x in inwards], UP])))
            below = [m + draw.choice([60, 600]) * i for m, i in zip(middle, inwards)]
            self.places.append(([below[0], 0, below[2]], UP))
            self.places += [([x + 0.001 * i for x, i in zip(beside, inwards)], inwards)] if draw.random() < 0.2 else []
        del room


class Plain(DayRoom, reflected_places.Room):
    pass


class Odd(DayRoom, reflected_places.OddRoom):
    pass


class Outdoors(reflected_places.Room):
    """Things and lamps on a plane under a sky."""

    def __init__(self, seed):
        self.random = draw = random.Random('day places %d' % seed)
        self.half, self.spots, self.places, self.lights = draw.choice([3000, 8000, 20000]), [], [], []
        self.surfaces = [{'type': 'rectangle', 'center': [0, 0, 0], 'size': [2 * self.half] * 2, 'axis': UP,
                          'up': [0, 0, -1], 'material': material(self.reflectance())}]
        for _ in range(draw.choice([0, 1, 1, 2, 3, 5])):
            self.put()
        if draw.random() < 0.4:
            self.shine()
        self.lights += sky(draw)
        x, z = draw.uniform(-2500, 2500), draw.uniform(-2500, 2500)
        self.places += [([x, 0, z], UP), ([0.98 * self.half, 0, z], UP), ([x, 5000, z], [0, -1, 0]),
                        ([x, 5000, z], witness.unit([draw.gauss(0, 1) for _ in range(3)]))]
        draw.shuffle(self.places)
        self.places = self.places[:12]

    def spot(self, radius):
        draw = self.random
        for _ in range(50):
            x, z = draw.uniform(-2000, 2000), draw.uniform(-2000, 2000)
            if all(math.hypot(x - u, z - v) > radius + r + 5 for u, v, r in self.spots):
                self.spots.append((x, z, radius))
                return x, z
        return None

    def put(self):
        draw = self.random
        kind, size = draw.choice(['box', 'box', 'ball', 'tube', 'triangles', 'board', 'house']), draw.uniform(150, 900)
        height, at = draw.uniform(100, 2500), self.spot(size * math.sqrt(2) if kind != 'house' else 1500)
        if not at:
            return
        x, z = at
        beside, thing = size + little(draw), {'material': material(self.reflectance())}
        self.places.append(([x + beside, 0, z], UP))
        if kind == 'box':
            turn = draw.choice([0, draw.uniform(0, 90)])
            c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
            thing.update(type='box', center=[x, height / 2, z], size=[2 * size, height, 2 * size], rotate=[0, turn, 0])
            self.places[-1] = ([x + beside * c, 0, z - beside * s], UP)
            self.places += [([x, height, z], UP), ([x + size * c, little(draw), z - size * s], [c, 0, -s]),
                            ([x + size * c, height / 2, z - size * s], [c, 0, -s])]
        elif kind == 'ball':
            thing.update(type='sphere', center=[x, size + draw.choice([0, 1, 200]), z], radius=size)
            way = witness.unit([draw.gauss(0, 1) for _ in range(3)])
            self.places[-1] = ([x + draw.uniform(0.1, 1.3) * size, 0, z], UP)
            self.places.append(([a + size * b for a, b in zip(thing['center'], way)], way))
        elif kind == 'tube':
            thing.update(type='cylinder', center=[x, height / 2, z], radius=size, height=height, axis=UP)
            self.places += [([x + size, draw.choice([0.5, little(draw) / height]) * height, z], [1, 0, 0]),
                            ([x, 0, z], UP)]
        elif kind == 'triangles':
            thing, places = self.triangles.make(draw, [x, draw.choice([0, 0, 300]), z], size, self.reflectance())
            self.places += places
        elif kind == 'board':
            thing.update(type='rectangle', center=[x, height / 2, z], size=[2 * size, height], axis=[0, 0, 1], up=UP)
            self.places[-1] = ([x, 0, z + little(draw)], UP)
            self.places += [([x, height / 2, z], [0, 0, 1]), ([x, height / 3, z], [0, 0, -1])]
        else:
            opening = {'wall': draw.choice(['left', 'right', 'back', 'front', 'ceiling']), 'center': [0, 0],
                       'size': [draw.uniform(300, 1500), draw.uniform(300, 1500)]}
            thing.update(type='room', center=[x, 1001, z], size=[2000, 2000, 2000], openings=[opening])
            self.places[-1:] = [([x + 300, 1, z + 200], UP), ([x - 999, 1500, z + 100], [1, 0, 0]),
                                ([x + 1000 + little(draw), 0, z], UP), ([x + 1000, 300, z + 800], [1, 0, 0])]
            self.places = [place for place in self.places if opening['wall'] != 'right' or place[1] != [1, 0, 0]]
        self.surfaces.append(thing)

    def shine(self):
        at = self.spot(300)
        if not at:
            return
        kind, center = self.random.choice(['globe', 'plate', 'point']), [at[0], 600, at[1]]
        self.lights.append({'type': 'point', 'position': center, 'power': 20000})
        if kind == 'globe':
            self.lights = [{'type': 'volume', 'sphere': {'center': center, 'radius': 150}, 'power': 20000}]
        elif kind == 'plate':
            self.lights = [{'type': 'planar', 'power': 20000, 'rectangle': {
                'center': center, 'size': [500, 300], 'axis': [0, -1, 0], 'up': [0, 0, 1]}}]
        self.places.append(([at[0] + 400, 0, at[1]], UP))


def scene_of(seed, folder):
    kind = (Plain, Outdoors, Odd, Outdoors)[seed % 4]
    made = kind.__new__(kind)
    made.triangles = Triangles(folder)
    made.__init__(seed)
    return made


def probe(luxel, scene, reflections, error):
    arguments = [luxel, 'probe', '-', '--quantity', 'irradiance', '--threads', '1', '--json']
    arguments += ['--tolerance', error] if reflections == 'none' else ['--reflected-error', error]
    for place, normal in scene.places:
        arguments += ['--at', ','.join('%.17g' % x for x in place + normal)]
    text = json.dumps({**scene.scene(), 'reflections': reflections if reflections in ('none', 'all') else
                       int(reflections)})
    ended = subprocess.run(arguments, input=text, capture_output=True, encoding='utf-8', timeout=MOST_S)
    if ended.returncode not in (0, 5):
        raise RuntimeError('exit code %d: %s\n%s' % (ended.returncode, ended.stderr.strip(), text))
    return [(point['value'], point['error']) for point in json.loads(ended.stdout)['points']]


def ask(program, scene, places, **work):
    """What the witness says; even where all paths agree it is no better than its sum over the open sky."""
    said = witness.ask(program, scene.surfaces, scene.lights, places, **work)
    return [(value, max(spread, 1e-9 * abs(value))) for value, spread in said]


def judge(luxel, program, seed, folder):
    """Errors as shares of their bounds, and whether all are honest."""
    scene, shares, honest, said = scene_of(seed, folder), [], True, {}
    names = ['direct', 'fine', 'twice', 'coarse', 'middle'] + (['close'] if seed % 3 == 0 else [])
    for name in names:
        reflections, error, bounces = OPTIONS[name]
        found = probe(luxel, scene, reflections, error)
        if bounces not in said:
            said[bounces] = ask(program, scene, scene.places, bounces=bounces, **PATHS)
        for i, place in enumerate(scene.places):
            if not is_honest(found[i], said[bounces][i]):
                said[bounces][i] = ask(program, scene, [place], seed=2, bounces=bounces, **MORE_PATHS)[0]
            (value, bound), (truth, spread) = found[i], said[bounces][i]
            if not is_honest(found[i], said[bounces][i]):
                honest = False
                print('scene %d, %s: %.6g +- %.2g, not %.6g +- %.2g, at %s' % (seed, name, value, bound, truth, spread,
                                                                             place))
            shares.append(max(abs(value - truth) - FAR * spread, 0) / bound if bound > 0 else 0)
    return shares, honest


def main():
    luxel, program, scenes, first = sys.argv[1], sys.argv[2], int(sys.argv[3]), int((sys.argv + ['1'])[4])
    passed, all_shares = 0, []
    for seed in range(first, first + scenes):
        with tempfile.TemporaryDirectory() as folder:
            shares, honest = judge(luxel, program, seed, folder)
        passed += honest
        all_shares += shares
        print('scene %d: error by bound %.4f in the middle, %.4f at most%s' %
              (seed, statistics.median(shares), max(shares), '' if honest else ', DISHONEST'), flush=True)
    print('error by bound: %.4f in the middle, %.4f at most' % (statistics.median(all_shares), max(all_shares)))
    print('%d passed, %d failed' % (passed, scenes - passed))
    return passed != scenes


if __name__ == '__main__':
    sys.exit(main())
