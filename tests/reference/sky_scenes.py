# SPDX-License-Identifier: MIT
"""Random scenes of daylight, as luxel reads them and as lists for the witness (sky_witness.c).

A scene has one source (a sky of each kind, the sun, or a lamp), bodies that stand apart, touch or cut each other, rooms
with openings, and places: free, on bodies, in the planes of plates and windows, close to windows, outside of rooms.
"""
import json
import math
import subprocess

import perez

# Coefficients a, b, c, d, e of CIE S 011/E:2003, table 1: gradation groups I to VI, indicatrix groups 1 to 6.
GRADATIONS = ((4, -.7), (1.1, -.8), (0, -1), (-1, -.55), (-1, -.32), (-1, -.15))
INDICATRICES = ((0, -1, 0), (2, -1.5, .15), (5, -2.5, .3), (10, -3, .45), (16, -3, .3), (24, -2.8, .15))
GROUPS = ('I1', 'I2', 'II1', 'II2', 'III1', 'III2', 'III3', 'III4', 'IV2', 'IV3', 'IV4', 'V4', 'V5', 'VI5', 'VI6')
ROMAN = {'I': 0, 'II': 1, 'III': 2, 'IV': 3, 'V': 4, 'VI': 5}
OVERCAST = 16


def coefficients(kind):
    group = GROUPS[kind - 1]
    return GRADATIONS[ROMAN[group[:-1]]] + INDICATRICES[int(group[-1]) - 1]


# ---- vectors ----

def add(a, b, by=1.0):
    return [x + by * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(a, by):
    return [by * x for x in a]


def unit(a):
    return times(a, 1 / math.sqrt(dot(a, a)))


def across(n):
    a = unit(cross(n, [1, 0, 0] if abs(n[0]) < .6 else [0, 1, 0]))
    return a, cross(n, a)


def words(*parts):
    out = []
    for part in parts:
        for number in part if isinstance(part, (list, tuple)) else (part,):
            out.append(number if isinstance(number, str) else '%.17g' % number)
    return ' '.join(out)


# ---- bodies: what luxel reads, and lines of the witness ----

MATTE = {'model': 'lambert'}


def ball(center, radius):
    return {'type': 'sphere', 'center': center, 'radius': radius, 'material': MATTE}, [words('ball', center, radius)]


def plate(center, size, axis, up):
    axis = unit(axis)
    up = unit(add(up, axis, -dot(up, axis)))
    side = cross(up, axis)
    lines = [words('quad', center, times(side, size[0] / 2), times(up, size[1] / 2))]
    return {'type': 'rectangle', 'center': center, 'size': size, 'axis': axis, 'up': up, 'material': MATTE}, lines


def disk(center, radius, axis):
    return ({'type': 'disk', 'center': center, 'radius': radius, 'axis': axis, 'material': MATTE},
            [words('disk', center, axis, radius)])


def tube(center, radius, height, axis):
    return ({'type': 'cylinder', 'center': center, 'radius': radius, 'height': height, 'axis': axis,
             'material': MATTE}, [words('tube', center, axis, height / 2, radius)])


def turned(degrees):
    """The axes of a body turned about x, then y, then z."""
    axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for k, angle in enumerate(degrees):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        i, j = (k + 1) % 3, (k + 2) % 3
        for axis in axes:
            axis[i], axis[j] = c * axis[i] - s * axis[j], s * axis[i] + c * axis[j]
    return axes


def box_sides(center, size, axes):
    lines = []
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        for side in (-.5, .5):
            middle = add(center, axes[k], side * size[k])
            lines.append(words('quad', middle, times(axes[i], size[i] / 2), times(axes[j], size[j] / 2)))
    return lines


def box(center, size, rotate=(0, 0, 0)):
    made = {'type': 'box', 'center': center, 'size': size, 'material': MATTE}
    if any(rotate):
        made['rotate'] = list(rotate)
    return made, box_sides(center, size, turned(rotate))


def mesh(name, center, size, rotate, files):
    """A tetrahedron: one corner of a box with its three edges."""
    axes = turned(rotate)
    corners = [center] + [add(center, axes[k], size[k]) for k in range(3)]
    files[name] = ''.join('v %.17g %.17g %.17g\n' % tuple(corner) for corner in corners) + \
        'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n'
    lines = [words('tri', *(corners[i] for i in face)) for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))]
    return {'type': 'mesh', 'file': name, 'material': MATTE}, lines


# Walls of a room with z up: axis and side, the way to the right as seen from inside, and up.
WALLS = {'left': (0, -1, [0, 1, 0], [0, 0, 1]), 'right': (0, 1, [0, -1, 0], [0, 0, 1]),
         'back': (1, 1, [1, 0, 0], [0, 0, 1]), 'front': (1, -1, [-1, 0, 0], [0, 0, 1]),
         'floor': (2, -1, [1, 0, 0], [0, 1, 0]), 'ceiling': (2, 1, [-1, 0, 0], [0, 1, 0])}


def room(center, size, openings):
    lines = []
    for name, (axis, side, right, up) in WALLS.items():
        middle = list(center)
        middle[axis] += side * size[axis] / 2
        half = [abs(dot(way, size)) / 2 for way in (right, up)]
        lines.append(words('wall', middle, times(right, half[0]), times(up, half[1])))
        for opening in openings:
            if opening['wall'] != name:
                continue
            hole = add(add(middle, right, opening['center'][0]), up, opening['center'][1])
            glass = opening.get('glass')
            lines.append(words('hole', hole, times(right, opening['size'][0] / 2), times(up, opening['size'][1] / 2),
                               glass['n'] if glass else 0, glass['transmittance'] if glass else 1))
    return {'type': 'room', 'up': 'z', 'center': center, 'size': size, 'openings': openings,
            'material': MATTE}, lines


# ---- sources ----

def to_sun(altitude, azimuth):
    a, b = math.radians(altitude), math.radians(azimuth)
    return [math.cos(a) * math.sin(b), math.cos(a) * math.cos(b), math.sin(a)]


def sky(kind, altitude, azimuth, by, value, ground):
    made = {'type': 'sky', 'kind': kind, by: value, 'ground': ground,
            'sun': {'altitude': altitude, 'azimuth': azimuth}}
    if kind == OVERCAST:
        return made, words('overcast', [0, 0, 1], by, value, ground)
    a, b, c, d, e = coefficients(kind)
    return made, words('sky', a, b, c, d, e, math.exp(d * math.pi / 2), [0, 0, 1], to_sun(altitude, azimuth), by, value,
                       ground)


def weather(altitude, azimuth, direct, diffuse, ground):
    """The sky of Perez; None where the model has none."""
    found = perez.coefficients(direct, diffuse, altitude)
    made = {'type': 'sky', 'model': 'perez', 'direct': direct, 'diffuse': diffuse, 'extraterrestrial': 1367,
            'ground': ground, 'sun': {'altitude': altitude, 'azimuth': azimuth}}
    return found and (made, words('sky', *found, 0, [0, 0, 1], to_sun(altitude, azimuth), 'horizontal', diffuse,
                                  ground))


def sun(altitude, azimuth, diameter, irradiance):
    return ({'type': 'sun', 'altitude': altitude, 'azimuth': azimuth, 'diameter': diameter, 'irradiance': irradiance},
            words('sun', to_sun(altitude, azimuth), math.radians(diameter / 2), irradiance))


# ---- asking ----

class Scene:
    def __init__(self, name):
        self.name, self.surfaces, self.lines, self.files, self.places = name, [], [], {}, []
        self.light = self.source = None

    def put(self, made):
        self.surfaces.append(made[0])
        self.lines += made[1]

    def lit_by(self, made):
        self.light, self.source = made

    def document(self):
        return {'luxel': 1, 'units': 'photometric', 'screen': {'width': 400, 'height': 400, 'resolution': [8, 8]},
                'observer': {'z': 1e5}, 'surfaces': self.surfaces, 'lights': [self.light]}

    def witness(self, program, panels=16):
        lines = self.lines + [self.source] + [words('place', place, normal) for place, normal in self.places]
        done = subprocess.run([program, str(panels)], input='\n'.join(lines) + '\n', capture_output=True,
                              encoding='utf-8', check=True, timeout=600)
        return [tuple(map(float, line.split())) for line in done.stdout.splitlines()]

    def luxel(self, program, folder, options=()):
        for name, text in self.files.items():
            with open('%s/%s' % (folder, name), 'w', encoding='utf-8') as file:
                file.write(text)
        with open(folder + '/scene.json', 'w', encoding='utf-8') as file:
            json.dump(self.document(), file)
        at = []
        for place, normal in self.places:
            at += ['--at', ','.join('%.17g' % number for number in place + normal)]
        done = subprocess.run([program, 'probe', 'scene.json', '--quantity', 'irradiance', '--json', *at, *options],
                              cwd=folder, capture_output=True, encoding='utf-8', timeout=600)
        if done.returncode not in (0, 5):
            raise RuntimeError('%s\n%s' % (done.stderr, json.dumps(self.document())))
        return [(point['value'], point['error']) for point in json.loads(done.stdout)['points']]


# ---- at random ----

def some_way(random, up=None):
    while True:
        way = [random.uniform(-1, 1) for _ in range(3)]
        if .01 < dot(way, way) <= 1 and (up is None or dot(way, up) > .05):
            return unit(way)


def some_angles(random):
    return [random.choice((0, 0, 90, random.uniform(-180, 180))) for _ in range(3)]


def some_source(random, inside=None):
    """A sky, mostly; `inside`: where a lamp outside shines at."""
    altitude = random.choice((.5, 3, 12, 35, 60, 85, 89.9999, 90, random.uniform(.1, 90)))
    azimuth = random.choice((0, 90, 180, random.uniform(0, 360)))
    kind = random.choice(['sky'] * 6 + ['sun'] * 2 + (['plate', 'globe', 'point', 'distant'] if inside else []))
    if kind == 'sky':
        made = random.random() < .3 and weather(altitude, azimuth, random.choice((0, random.uniform(0, 900))),
                                                 random.uniform(10, 400), random.choice((0, .2)))
        if made:
            return made
        return sky(random.randint(1, 16), altitude, azimuth, random.choice(('zenith', 'horizontal')), 1000,
                   random.choice((0, 0, .2, 1)))
    if kind == 'sun':
        return sun(altitude, azimuth, random.choice((.533, .533, 5, 40)), 1000)
    way = some_way(random)
    at = add(inside, way, random.uniform(7000, 12000))
    if kind == 'plate':
        side, up = across(way)
        size = [random.uniform(200, 2000), random.uniform(200, 2000)]
        axis = times(way, -1)
        return ({'type': 'planar', 'radiance': 1000,
                 'rectangle': {'center': at, 'size': size, 'axis': axis, 'up': up}},
                words('plate', at, times(side, -size[0] / 2), times(up, size[1] / 2), 1000)
                if dot(cross(side, up), way) > 0 else
                words('plate', at, times(side, size[0] / 2), times(up, size[1] / 2), 1000))
    if kind == 'globe':
        return ({'type': 'volume', 'radiance': 1000, 'sphere': {'center': at, 'radius': 600}},
                words('globe', at, 600, 1000))
    if kind == 'point':
        return {'type': 'point', 'position': at, 'intensity': 1000}, words('point', at, 1000)
    return {'type': 'distant', 'direction': times(way, -1), 'irradiance': 1000}, words('distant', way, 1000)


def some_body(random, scene, center, size):
    """A body about so large; returns places on it with their normals."""
    kind = random.choice(('ball', 'box', 'turned', 'plate', 'disk', 'tube', 'mesh'))
    scene.name += ' ' + kind
    if kind == 'ball':
        scene.put(ball(center, size))
        way = some_way(random)
        return [(add(center, way, size), way)]
    if kind in ('box', 'turned'):
        sides = [size * random.uniform(.3, 2) for _ in range(3)]
        angles = some_angles(random) if kind == 'turned' else (0, 0, 0)
        scene.put(box(center, sides, angles))
        axis = turned(angles)[2]
        return [(add(center, axis, sides[2] / 2), axis)]
    axis = random.choice(([0, 0, 1], [1, 0, 0], some_way(random)))
    if kind == 'plate':
        up = across(axis)[0] if random.random() < .5 else unit(cross(axis, some_way(random)))
        sides = [size * random.uniform(.2, 3), size * random.uniform(.2, 3)]
        scene.put(plate(center, sides, axis, up))
        return [(center, axis)]
    if kind == 'disk':
        scene.put(disk(center, size, axis))
        return [(center, axis)]
    if kind == 'tube':
        scene.put(tube(center, size, size * random.uniform(.5, 4), axis))
        side = across(axis)[0]
        return [(add(center, side, size), side)]
    scene.put(mesh('mesh%d.obj' % len(scene.surfaces), center, [size * random.uniform(.5, 2) for _ in range(3)],
                   some_angles(random), scene.files))
    return []


def outdoors(random):
    """Bodies under the open sky around a place."""
    scene = Scene('outdoors')
    place, normal = [random.choice((0, 123.4)), 0, 0], random.choice(([0, 0, 1], [1, 0, 0], some_way(random)))
    scene.lit_by(some_source(random))
    scene.places.append((place, normal))
    before = None
    for _ in range(random.randint(0, 3)):
        how = random.choice(('apart', 'apart', 'tangent', 'in the horizon', 'through', 'at the sun', 'under'))
        size = random.uniform(50, 600)
        way = some_way(random, normal)
        center = add(place, way, size * random.uniform(2, 6))
        scene.name += ', ' + how
        if how == 'tangent' and before:
            other, radius = before
            center = add(other, some_way(random), radius + size)
            if math.dist(center, place) > size * 1.01:
                scene.put(ball(center, size))
            continue
        if how == 'in the horizon':
            side, up = across(normal)
            center = add(place, side, size * 2)
            scene.put(plate(center, [size, size], random.choice((normal, up)), random.choice((side, some_way(random)))))
            continue
        if how == 'through':
            center = add(place, across(normal)[0], size * 2)
        if how == 'at the sun' and 'altitude' in scene.light:
            towards = to_sun(scene.light['altitude'], scene.light['azimuth'])
            side = across(towards)[random.randint(0, 1)]
            center = add(add(place, towards, size * 6), side, size * random.uniform(.5, 1.5))
        if how == 'under':
            center = add(place, normal, -size * 1.5)
        if math.dist(center, place) > size * 4:
            on = some_body(random, scene, center, size)
        else:
            scene.put(ball(center, size))
            on = [(add(center, unit(add(center, place, -1)), -size), unit(add(place, center, -1)))]
        before = center, size
        if on and random.random() < .5:
            scene.places += on
    return scene


def indoors(random):
    """A room with openings, bodies in it and before it, and places inside, at windows and outside."""
    scene = Scene('indoors')
    center, size = [random.choice((0, 500)), 100, 1500], [random.choice((3000, 4000)), 5000, 3000]
    openings = []
    for _ in range(random.randint(1, 3)):
        wall = random.choice(list(WALLS))
        axis, _side, right, up = WALLS[wall]
        whole = [abs(dot(way, size)) for way in (right, up)]
        how = random.choice(('within', 'at the edge', 'whole', 'touching'))
        wide = [random.uniform(.1, .6) * whole[0], random.uniform(.1, .6) * whole[1]]
        at = [random.uniform(-.5, .5) * (whole[k] - wide[k]) for k in range(2)]
        if how == 'at the edge':
            at[random.randint(0, 1)] = 0
            at = [random.choice((-1, 1)) * (whole[k] - wide[k]) / 2 if at[k] else 0. for k in range(2)]
        if how == 'whole':
            wide, at = list(whole), [0., 0.]
        if how == 'touching' and openings:
            last = openings[-1]
            wall = last['wall']
            wide = [last['size'][0] / 2, last['size'][1]]
            at = [last['center'][0] + last['size'][0] / 2 + wide[0] / 2, last['center'][1]]
        opening = {'wall': wall, 'center': at, 'size': wide}
        if random.random() < .5:
            opening['glass'] = {'n': random.choice((1.526, 1.3, 2)), 'transmittance': random.choice((.96, 1, .5))}
        axis, _side, right, up = WALLS[wall]
        whole = [abs(dot(way, size)) for way in (right, up)]
        fits = all(abs(at[k]) + wide[k] / 2 <= whole[k] / 2 * (1 + 1e-12) for k in range(2))
        apart = all(other['wall'] != wall or any(abs(other['center'][k] - at[k]) >=
                                                 (other['size'][k] + wide[k]) / 2 * (1 - 1e-12) for k in range(2))
                    for other in openings)
        if fits and apart:
            openings.append(opening)
            scene.name += ', %s %s%s' % (how, wall, ' glazed' if 'glass' in opening else '')
    scene.put(room(center, size, openings))
    scene.lit_by(some_source(random, center))
    for _ in range(random.choice((0, 0, 1, 2))):
        at = [center[k] + random.uniform(-.3, .3) * size[k] for k in range(3)]
        if random.random() < .3:
            at = add(center, some_way(random), 4500)
        on = some_body(random, scene, at, random.uniform(50, 400))
        if on and random.random() < .3:
            scene.places += on
    inside = [center[k] + random.uniform(-.45, .45) * size[k] for k in range(3)]
    scene.places.append((inside, some_way(random)))
    floor = [inside[0], inside[1], center[2] - size[2] / 2]
    scene.places.append((floor, [0, 0, 1]))
    for opening in openings[:1]:
        axis, side, right, up = WALLS[opening['wall']]
        inwards = [0, 0, 0]
        inwards[axis] = -side
        hole = list(center)
        hole[axis] += side * size[axis] / 2
        hole = add(add(hole, right, opening['center'][0]), up, opening['center'][1])
        hole = add(hole, right, random.uniform(-.5, .5) * opening['size'][0])
        for depth in random.sample((1, 1e-3, 100, 0, -1, -800), 2):
            normal = random.choice((inwards, times(inwards, -1), some_way(random), right))
            scene.places.append((add(hole, inwards, depth), normal))
    return scene
