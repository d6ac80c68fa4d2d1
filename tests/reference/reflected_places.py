# SPDX-License-Identifier: MIT
"""Bounds of reflected light at places of random rooms: values of loose tolerances against an independent witness.

    reflected_places.py LUXEL WITNESS ROOMS [FIRST]

Rooms have boxes, boards, balls, disks and tubes, apart or on the floor, and lamps of all kinds; places are on walls,
in corners, on and beside things, and free, and some of them within millimetres of where surfaces meet, where shadows
end, or between a thing and the floor.  Of each three one has columns, boards beside walls, screens, things that touch,
arrays of lamps and lamps in niches of the ceiling besides, and maybe no wall in front; and in one things hang and stand
anyhow: tubes, disks and boards at any tilt, columns with a gap above and below, bins, balls, lamps with shades around
them and baffles below them, and luminaires with openings.  The witness follows paths at random (witness.c).  A value is
dishonest where it is further from what the witness says than its bound and four standard errors, by sixteen times as
many paths, too.  Prints each room with its errors as shares of the bounds, and ends with `N passed, N failed`.
"""
import json
import math
import os
import random
import statistics
import subprocess
import sys

import witness

LOOSE = (1e-1, 3e-2, 1e-2)
NEAR = 6  # places within millimetres of something, at most
MOST_S = 1800
PATHS = {'side': 128, 'batches': 16}
MORE_PATHS = {'side': 512, 'batches': 16}
FAR = 4  # standard errors


def little(draw):
    return draw.choice([1, 3, 8, 15, 30])


def material(reflectance):
    return {'model': 'lambert', 'diffuse': reflectance, 'over_pi': True}


class Room:
    """A room with its lower corner at 0; y is up."""

    def __init__(self, seed):
        self.random = random.Random('reflected places %d' % seed)
        draw = self.random
        self.size = [draw.uniform(2500, 6000), draw.uniform(2200, 3200), draw.uniform(2200, 4500)]
        self.spots, self.places, self.surfaces = [], [], []
        self.surfaces.append({'type': 'room', 'center': [s / 2 for s in self.size], 'size': self.size,
                              'material': material(self.reflectance()),
                              'materials': {'floor': material(self.reflectance()),
                                            'ceiling': material(self.reflectance())}})
        for _ in range(draw.choice([0, 1, 1, 1, 2, 2])):
            self.furnish()
        self.lamps()
        self.look()
        self.look_near()

    def reflectance(self):
        return round(self.random.uniform(0.1, 0.8), 3)

    def furnish(self):
        """A thing that keeps away from walls and others, but maybe only by some centimetres."""
        draw = self.random
        kind = draw.choice(['box', 'box', 'board', 'ball', 'disk', 'tube'])
        for _ in range(50):
            a, b, height = draw.uniform(100, 450), draw.uniform(100, 450), draw.uniform(100, 900)
            radius = a if kind in ('ball', 'disk') else math.hypot(a, b)
            x, z = draw.uniform(0, self.size[0]), draw.uniform(0, self.size[2])
            gap = radius + draw.choice([20, 60])
            if (gap < x < self.size[0] - gap and gap < z < self.size[2] - gap and
                    all(math.hypot(x - u, z - v) > radius + r for u, v, r in self.spots)):
                break
        else:
            return
        self.spots.append((x, z, radius))
        foot = draw.choice([0, 0, draw.uniform(20, 700)])
        angle = draw.choice([0, draw.uniform(0, 360)])
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        thing = {'type': kind, 'material': material(self.reflectance())}
        if kind == 'box':
            thing.update(center=[x, foot + height / 2, z], size=[2 * a, height, 2 * b], rotate=[0, angle, 0])
            self.places.append(([x + 0.3 * a, foot + height, z], [0, 1, 0]))
            self.places.append(([x + a * c, foot + draw.uniform(0.05, 0.9) * height, z - a * s], [c, 0, -s]))
        elif kind == 'board':
            thing.update(type='rectangle', center=[x, foot + 50, z], size=[2 * a, 2 * b], axis=[0, 1, 0],
                         up=[-s, 0, c])
            self.places.append(([x, foot + 50, z], [0, 1, 0]))
        elif kind == 'ball':
            thing.update(type='sphere', center=[x, foot + a + 1, z], radius=a)
            self.places.append(([x, foot + 2 * a + 1, z], [0, 1, 0]))
        elif kind == 'disk':
            thing.update(center=[x, foot + 50, z], radius=a, axis=[0, 1, 0])
            self.places.append(([x, foot + 50, z], [0, 1, 0]))
        else:
            thing.update(type='cylinder', center=[x, foot + height / 2 + 1, z], radius=a / 2, height=height,
                         axis=[0, 1, 0])
        self.surfaces.append(thing)
        beside = radius + draw.choice([5, 30, 120])
        if x + beside < self.size[0]:
            self.places.append(([x + beside, 0, z], [0, 1, 0]))

    def lamps(self):
        draw = self.random
        self.lights, kinds = [], ['point', 'point', 'hard', 'soft', 'plate', 'globe', 'luminaire']
        for _ in range(draw.choice([1, 1, 2])):
            kind = draw.choice(kinds)
            place = [draw.uniform(0.15, 0.85) * self.size[0], self.size[1] - draw.choice([50, 200, 300, 700]),
                     draw.uniform(0.15, 0.85) * self.size[2]]
            aim = [draw.uniform(0, self.size[0]), 0, draw.uniform(0, self.size[2])]
            if kind == 'point':
                lamp = {'type': 'point', 'position': place, 'power': 1000}
            elif kind in ('hard', 'soft'):
                outer = draw.uniform(12, 50)
                lamp = {'type': 'spot', 'position': place, 'aim': aim, 'power': 1000, 'outer': outer,
                        'inner': outer if kind == 'hard' else outer * draw.uniform(0.2, 0.8)}
            elif kind == 'plate':
                lamp = {'type': 'planar', 'power': 1000,
                        'rectangle': {'center': place, 'size': [draw.uniform(200, 1000), draw.uniform(200, 600)],
                                      'axis': [0, -1, 0], 'up': [0, 0, 1]}}
            elif kind == 'globe':
                place[1] = min(place[1], self.size[1] - 160)
                lamp = {'type': 'volume', 'sphere': {'center': place, 'radius': draw.uniform(20, 140)}, 'power': 1000}
            else:
                lamp = {'type': 'luminaire', 'position': place, 'file': OFFICE_LAMP}
            self.lights.append(lamp)

    def look(self):
        draw, (length, height, width) = self.random, self.size

        def inner(size):
            return draw.uniform(0.03, 0.97) * size
        near = draw.choice([15, 40, 100])
        self.places = self.places[:4] + [
            ([inner(length), 0, inner(width)], [0, 1, 0]), ([inner(length), height, inner(width)], [0, -1, 0]),
            ([length, inner(height), inner(width)], [-1, 0, 0]), ([near, near, 0], [0, 0, 1]),
            ([inner(length), near, 0], [0, 0, 1])]
        tilt, turn = draw.uniform(0, 3.1), draw.uniform(0, 6.2)
        self.places.append(([0.5 * length, 0.45 * height, 0.4 * width],
                            [math.sin(tilt) * math.cos(turn), math.cos(tilt), math.sin(tilt) * math.sin(turn)]))

    def on_wall(self, wall, share, height):
        """A place so far along one of the four walls."""
        x, z = share * self.size[0], share * self.size[2]
        return [([x, height, 0], [0, 0, 1]), ([x, height, self.size[2]], [0, 0, -1]), ([0, height, z], [1, 0, 0]),
                ([self.size[0], height, z], [-1, 0, 0])][wall]

    def look_near(self):
        draw = self.random
        places = [self.on_wall(draw.randrange(4), draw.uniform(0.02, 0.98), little(draw)) for _ in range(2)]
        edges = [edge for thing in self.surfaces[1:] for lamp in self.lights for edge in self.shadow_ends(thing, lamp)]
        draw.shuffle(edges)
        places += [self.on_wall(wall, share, little(draw)) for wall, share in edges[:3]]
        for thing in self.surfaces[1:]:
            places += self.beside(thing)
        places = [(place, normal) for place, normal in places
                  if all(0 <= x <= size for x, size in zip(place, self.size))]
        draw.shuffle(places)
        self.places += places[:NEAR]

    def shadow_ends(self, thing, lamp):
        """Where the shadow of the ball around a thing ends along the feet of the walls."""
        source = lamp.get('position') or lamp.get('rectangle', lamp.get('sphere'))['center']
        radius = thing.get('radius') or math.hypot(thing['size'][0], thing['size'][-1]) / 2
        ends, steps = [], 400
        for wall in range(4):
            was_dark = None
            for i in range(steps + 1):
                share = 0.01 + 0.98 * i / steps
                way = [a - b for a, b in zip(self.on_wall(wall, share, 0)[0], source)]
                t = sum((c - b) * w for c, b, w in zip(thing['center'], source, way)) / sum(w * w for w in way)
                passing = [b + t * w for b, w in zip(source, way)]
                is_dark = 0 < t < 1 and math.dist(thing['center'], passing) < radius
                if was_dark is not None and is_dark != was_dark:
                    ends.append((wall, share))
                was_dark = is_dark
        return ends

    def beside(self, thing):
        """Places beside the foot of a thing, under it, and on its underside."""
        draw, (x, y, z), kind = self.random, thing['center'], thing['type']
        up, down, turn, near = [0, 1, 0], [0, -1, 0], draw.uniform(0, 2 * math.pi), little(draw)
        c, s = math.cos(turn), math.sin(turn)
        if kind == 'box':
            (a, height, b), angle = thing['size'], math.radians(thing['rotate'][1])
            c, s, foot = math.cos(angle), math.sin(angle), y - height / 2

            def at(u, h, v):
                return [x + u * c + v * s, h, z - u * s + v * c]
            places = [(at(a / 2 + near, 0, draw.uniform(-0.5, 0.5) * b), up),
                      (at(a / 2, foot + near, draw.uniform(-0.49, 0.49) * b), [c, 0, -s])]
            if foot > 1:
                places += [(at(draw.uniform(-0.6, 0.6) * a, 0, draw.uniform(-0.6, 0.6) * b), up),
                           (at(draw.uniform(-0.45, 0.45) * a, foot, b / 2 - near), down)]
            return places
        if kind == 'rectangle':
            (a, b), (u, _, v) = thing['size'], thing['up']
            p, q = draw.uniform(-0.5, 0.5) * a, b / 2 - near
            under = [x + p * v + q * u, y, z - p * u + q * v]
            return [(under, down), ([under[0], 0, under[2]], up)]
        radius = thing['radius']
        if kind == 'disk':
            q = radius - near
            return [([x + q * c, y, z + q * s], down), ([x + q * c, 0, z + q * s], up)]
        if kind == 'sphere':
            return [([x + q * c, 0, z + q * s], up)
                    for q in (draw.uniform(0.02, 1.2) * radius, draw.uniform(0.5, 1.3) * radius)]
        q = radius + near
        return [([x + q * c, 0, z + q * s], up),
                ([x + radius * c, y - thing['height'] / 2 + near, z + radius * s], [c, 0, s])]

    def scene(self):
        return {'luxel': 1, 'units': 'photometric', 'reflections': 'all',
                'screen': {'width': 2000, 'height': 1500, 'resolution': [20, 15]}, 'observer': {'z': 9000},
                'surfaces': self.surfaces, 'lights': self.lights}


OFFICE_LAMP = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'data', 'files', 'office-lamp.ies')


def probe(luxel, room, error):
    arguments = [luxel, 'probe', '-', '--quantity', 'irradiance', '--reflected-error', '%g' % error, '--threads',
                 '1', '--json']
    for place, normal in room.places:
        arguments += ['--at', ','.join('%.9f' % x for x in place + normal)]
    ended = subprocess.run(arguments, input=json.dumps(room.scene()), capture_output=True, encoding='utf-8',
                           timeout=MOST_S)
    if ended.returncode not in (0, 5):
        raise RuntimeError('exit code %d: %s' % (ended.returncode, ended.stderr.strip()))
    return [(point['value'], point['error']) for point in json.loads(ended.stdout)['points']]


class OddRoom(Room):
    """A room with what stands in corners and close to walls as well, and lamps in numbers."""
    recess = None

    def furnish(self):
        draw = self.random
        kind = draw.choice(['thing', 'column', 'screen', 'shelf', 'pair', 'niche'])
        length, height, width = self.size
        if kind == 'thing':
            super().furnish()
            return
        x, z = draw.uniform(0.3, 0.7) * length, draw.uniform(0.3, 0.7) * width
        if any(math.hypot(x - u, z - v) < 900 for u, v, _ in self.spots):
            return
        self.spots.append((x, z, 500))
        a, b, turn = draw.uniform(100, 300), draw.uniform(100, 300), draw.choice([0, draw.uniform(0, 90)])
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        if kind == 'column':
            self.add_box([x, height / 2, z], [2 * a, height, 2 * b], turn)
        elif kind == 'screen':  # a thin board that stands on the floor
            tall = draw.uniform(300, 1800)
            self.add_board([x, tall / 2, z], [2 * b, tall], [c, 0, -s], [0, 1, 0])
            self.places.append(([x + 10 * c, 0, z - 10 * s], [0, 1, 0]))
        elif kind == 'shelf':  # some millimetres or centimetres before a wall
            away, up = draw.choice([2, 10, 40]), draw.uniform(0.2, 0.8) * height
            self.add_board([x, up, away], [2 * a, draw.choice([60, 400])], [0, 0, 1], [0, 1, 0])
            self.places += [([x + 0.4 * a, up - 220, 0], [0, 0, 1]), ([x + 0.9 * a, up, 0], [0, 0, 1])]
        elif kind == 'pair':  # a box on another one
            low, top = draw.uniform(100, 600), draw.uniform(50, 400)
            self.add_box([x, low / 2, z], [2 * a, low, 2 * b], turn)
            self.add_box([x, low + top / 2, z], [a, top, b], draw.uniform(0, 90))
            self.places.append(([x + 0.55 * a * c, low, z - 0.55 * a * s], [0, 1, 0]))
        else:  # four boards around a lamp under the ceiling, which they touch
            deep = draw.uniform(100, 300)
            for axis in ([1, 0, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1]):
                center = [x + 200 * axis[0], height - deep / 2, z + 200 * axis[2]]
                self.add_board(center, [400, deep], axis, [0, 1, 0])
            self.recess = [x, height - draw.uniform(0.3, 0.8) * deep, z]
            self.places.append(([x + 150, height, z + 100], [0, -1, 0]))

    def add_box(self, center, size, turn):
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        self.surfaces.append({'type': 'box', 'material': material(self.reflectance()), 'center': center, 'size': size,
                              'rotate': [0, turn, 0]})
        foot = center[1] - size[1] / 2
        for beside, up in ((little(self.random), 0), (0, little(self.random))):
            away = size[0] / 2 + beside
            self.places.append(([center[0] + away * c, foot + up, center[2] - away * s],
                                [0, 1, 0] if beside else [c, 0, -s]))

    def add_board(self, center, size, axis, up):
        self.surfaces.append({'type': 'rectangle', 'material': material(self.reflectance()), 'center': center,
                              'size': size, 'axis': axis, 'up': up})

    def lamps(self):
        draw = self.random
        super().lamps()
        if self.recess:
            self.lights[0] = {'type': 'point', 'position': self.recess, 'power': 1000}
        elif draw.random() < 0.4:
            place = [self.size[0] / 2, self.size[1] - 60, self.size[2] / 2]
            array = {'n': [draw.choice([2, 3]), 2], 'spacing': [600, 800], 'axes': [[1, 0, 0], [0, 0, 1]]}
            self.lights[0] = {'type': 'luminaire', 'position': place, 'file': OFFICE_LAMP, 'axis': [0, -1, 0],
                              'array': array}
        if draw.random() < 0.25:  # no wall in front
            self.open_front()

    def open_front(self):
        length, height, width = self.size
        walls = [([length / 2, 0, width / 2], [length, width], [0, 1, 0], [0, 0, 1]),
                 ([length / 2, height, width / 2], [length, width], [0, -1, 0], [0, 0, 1]),
                 ([length / 2, height / 2, 0], [length, height], [0, 0, 1], [0, 1, 0]),
                 ([0, height / 2, width / 2], [width, height], [1, 0, 0], [0, 1, 0]),
                 ([length, height / 2, width / 2], [width, height], [-1, 0, 0], [0, 1, 0])]
        del self.surfaces[0]
        for wall in walls:
            self.add_board(*wall)

    def look_near(self):
        self.places = self.places[:12]
        for _ in range(3):
            self.places += [self.on_wall(self.random.choice([0, 2, 3]), self.random.uniform(0.02, 0.98),
                                         little(self.random))]
        self.places = [(place, normal) for place, normal in self.places
                       if all(0 <= x <= size for x, size in zip(place, self.size))]


class MixedRoom(OddRoom):
    """A room in which any of many kinds of things stand and hang beside any of many kinds of lamps."""

    def tilt(self):
        """A direction at random, or along an axis."""
        draw = self.random
        if draw.random() < 0.3:
            return draw.choice([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]])
        y, turn = draw.uniform(-1, 1), draw.uniform(0, 2 * math.pi)
        return [math.sqrt(1 - y * y) * math.cos(turn), y, math.sqrt(1 - y * y) * math.sin(turn)]

    def furnish(self):
        for _ in range(self.random.choice([1, 1, 2])):
            self.hang(self.random.choice(['column', 'tube', 'tube', 'ball', 'disk', 'board', 'box', 'bin']))

    def hang(self, kind):
        draw, (length, height, width) = self.random, self.size
        radius = draw.uniform(60, 350)
        for _ in range(50):
            x, z = draw.uniform(0.1, 0.9) * length, draw.uniform(0.1, 0.9) * width
            if (radius + 30 < x < length - radius - 30 and radius + 30 < z < width - radius - 30 and
                    all(math.hypot(x - u, z - v) > 2 * radius + r for u, v, r in self.spots)):
                break
        else:
            return
        self.spots.append((x, z, 2 * radius))
        y, thing = draw.uniform(0.25, 0.6) * height, {'material': material(self.reflectance())}
        if kind == 'column':
            gap = draw.choice([1, 5, 40])
            thing.update(type='cylinder', center=[x, height / 2, z], radius=radius, height=height - 2 * gap,
                         axis=[0, 1, 0])
        elif kind == 'bin':
            tall = draw.uniform(200, 900)
            thing.update(type='cylinder', center=[x, tall / 2 + 1, z], radius=radius, height=tall, axis=[0, 1, 0])
            self.places.append(([x + 0.5 * radius, 0, z], [0, 1, 0]))
        elif kind == 'tube':
            thing.update(type='cylinder', center=[x, y, z], radius=0.4 * radius, height=draw.uniform(0.3, 1.8) * radius,
                         axis=self.tilt())
        elif kind == 'ball':
            thing.update(type='sphere', center=[x, y, z], radius=radius)
        elif kind == 'disk':
            thing.update(type='disk', center=[x, y, z], radius=radius, axis=self.tilt())
        elif kind == 'box':
            self.add_box([x, y, z], [radius, draw.uniform(0.2, 1.5) * radius, radius], draw.uniform(0, 90))
            return
        else:
            axis = self.tilt()
            up = [0, 1, 0] if abs(axis[1]) < 0.9 else [1, 0, 0]
            thing.update(type='rectangle', center=[x, y, z], size=[radius, draw.uniform(0.2, 1.5) * radius], axis=axis,
                         up=up)
        self.surfaces.append(thing)
        self.places.append(([x, 0, z + 0.3 * radius], [0, 1, 0]))

    def lamps(self):
        draw = self.random
        Room.lamps(self)
        for lamp in self.lights:
            if lamp['type'] == 'luminaire':
                lamp.update(axis=[0, -1, 0], opening='file')
            place = lamp.get('position') or lamp.get('rectangle', lamp.get('sphere'))['center']
            beside = draw.choice(['nothing', 'nothing', 'shade', 'baffle'])
            if beside == 'shade' and lamp['type'] in ('point', 'globe', 'soft', 'hard'):
                radius = draw.uniform(180, 260)
                self.surfaces.append({'type': 'cylinder', 'center': place, 'radius': radius,
                                      'height': min(draw.uniform(100, 400), 1.8 * (self.size[1] - place[1])),
                                      'axis': [0, 1, 0], 'material': material(self.reflectance())})
            elif beside == 'baffle':
                self.add_board([place[0], place[1] - draw.uniform(160, 500), place[2]],
                               [draw.uniform(100, 900), draw.uniform(50, 300)], self.tilt(), [0.1, 0.2, 0.97])

    def beside(self, thing):
        return []


def room_of(seed):
    return (Room, OddRoom, MixedRoom)[seed % 3](seed)


def is_honest(found, said):
    return abs(found[0] - said[0]) <= found[1] + FAR * said[1] + 1e-9


def look_closer(program, room, found, said):
    """What the witness says with more paths where a value is not what it should be."""
    for i, place in enumerate(room.places):
        if not is_honest(found[i], said[i]):
            said[i] = witness.ask(program, room.surfaces, room.lights, [place], seed=2, **MORE_PATHS)[0]


def judge(luxel, program, seed):
    """Errors of loose values as shares of their bounds, and whether all are honest."""
    room = room_of(seed)
    said = witness.ask(program, room.surfaces, room.lights, room.places, **PATHS)
    shares, honest = [], True
    for error in LOOSE:
        found = probe(luxel, room, error)
        look_closer(program, room, found, said)
        for (value, bound), (truth, spread), place in zip(found, said, room.places):
            if not is_honest((value, bound), (truth, spread)):
                honest = False
                print('room %d at %g: %.5g +- %.2g, not %.5g +- %.2g, at %s' % (seed, error, value, bound, truth,
                                                                             spread, place))
            shares.append(max(abs(value - truth) - FAR * spread, 0) / bound if bound > 0 else 0)
    return shares, honest


def main():
    luxel, program, rooms, first = sys.argv[1], sys.argv[2], int(sys.argv[3]), int((sys.argv + ['1'])[4])
    passed, all_shares = 0, []
    for seed in range(first, first + rooms):
        shares, honest = judge(luxel, program, seed)
        passed += honest
        all_shares += shares
        print('room %d: error by bound %.4f in the middle, %.4f at most%s' %
              (seed, statistics.median(shares), max(shares), '' if honest else ', DISHONEST'), flush=True)
    print('error by bound: %.4f in the middle, %.4f at most' % (statistics.median(all_shares), max(all_shares)))
    print('%d passed, %d failed' % (passed, rooms - passed))
    return passed != rooms


if __name__ == '__main__':
    sys.exit(main())
