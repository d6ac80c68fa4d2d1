# SPDX-License-Identifier: MIT
"""Bounds of reflected light at places of random rooms: values of loose tolerances against those of a tight one.

    reflected_places.py LUXEL ROOMS [FIRST]

Rooms have boxes, boards, balls, disks and tubes, apart or on the floor, and lamps of all kinds; places are on walls,
in corners, on and beside things, and free, and some of them within millimetres of where surfaces meet, where shadows
end, or between a thing and the floor.  A value is dishonest where it is further from the tight one than both
bounds together.  Prints each room with its errors as shares of the bounds, and ends with `N passed, N failed`.
"""
import json
import math
import os
import random
import statistics
import subprocess
import sys

LOOSE = (1e-1, 3e-2, 1e-2)
NEAR = 6  # places within millimetres of something, at most
MOST_TIGHT_S = 1800


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
                           timeout=MOST_TIGHT_S)
    if ended.returncode not in (0, 5):
        raise RuntimeError('exit code %d: %s' % (ended.returncode, ended.stderr.strip()))
    return [(point['value'], point['error']) for point in json.loads(ended.stdout)['points']]


def judge(luxel, seed):
    """Errors of loose values as shares of their bounds, and whether all are honest."""
    room = Room(seed)
    tight = probe(luxel, room, 1e-3 if not room.spots else 3e-3)
    shares, honest = [], True
    for error in LOOSE:
        for (value, bound), (truth, rest), place in zip(probe(luxel, room, error), tight, room.places):
            away = abs(value - truth)
            if away > bound + rest:
                honest = False
                print('room %d at %g: %.5g +- %.2g, not %.5g +- %.2g, at %s' % (seed, error, value, bound, truth, rest,
                                                                             place))
            shares.append(away / bound if bound > 0 else 0)
    return shares, honest


def main():
    luxel, rooms, first = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
    passed, all_shares = 0, []
    for seed in range(first, first + rooms):
        shares, honest = judge(luxel, seed)
        passed += honest
        all_shares += shares
        print('room %d: error by bound %.4f in the middle, %.4f at most%s' %
              (seed, statistics.median(shares), max(shares), '' if honest else ', DISHONEST'), flush=True)
    print('error by bound: %.4f in the middle, %.4f at most' % (statistics.median(all_shares), max(all_shares)))
    print('%d passed, %d failed' % (passed, rooms - passed))
    return passed != rooms


if __name__ == '__main__':
    sys.exit(main())
