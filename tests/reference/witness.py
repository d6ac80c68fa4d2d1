# SPDX-License-Identifier: MIT
"""Scenes as witness.c takes them, which shares no code with the library, and what it answers.

Converts what rooms of the campaigns are made of, and raises ValueError at anything else.
"""
import math
import subprocess

import perez
import sky_scenes


def length(vector):
    return math.sqrt(sum(x * x for x in vector))


def unit(vector):
    return [x / length(vector) for x in vector]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def line(word, *parts):
    numbers = []
    for part in parts:
        numbers += part if isinstance(part, list) else [part]
    return ' '.join([word] + ['%.17g' % number for number in numbers])


def frame(thing):
    """The half vectors of a rectangle: across and up."""
    axis = unit(thing['axis'])
    up = thing['up']
    along = sum(a * b for a, b in zip(axis, up))
    up = unit([b - along * a for a, b in zip(axis, up)])
    wide = cross(up, axis)
    width, height = thing['size']
    return [x * width / 2 for x in wide], [x * height / 2 for x in up]


def sides(thing):
    """The six sides of a box that is turned around y, or of a room: name, center and half vectors."""
    angle = math.radians(thing.get('rotate', [0, 0, 0])[1])
    if thing.get('rotate', [0, 0, 0])[0] or thing.get('rotate', [0, 0, 0])[2]:
        raise ValueError('turned around another axis')
    c, s = math.cos(angle), math.sin(angle)
    axes = [[c, 0, -s], [0, 1, 0], [s, 0, c]]
    half = [size / 2 for size in thing['size']]
    names = [['left', 'right'], ['floor', 'ceiling'], ['back', 'front']]
    if thing.get('up') == 'z':
        names = [['left', 'right'], ['front', 'back'], ['floor', 'ceiling']]
    for k in range(3):
        for i, sign in enumerate((-1, 1)):
            center = [a + sign * half[k] * b for a, b in zip(thing['center'], axes[k])]
            others = [[half[m] * x for x in axes[m]] for m in range(3) if m != k]
            yield names[k][i], center, others


def hole_line(opening, room, middle):
    """An opening of a wall: to the right as seen from inside, and up."""
    outwards = unit([a - b for a, b in zip(middle, room['center'])])
    up = [0, 0, 1] if room.get('up') == 'z' else [0, 1, 0]
    if opening['wall'] in ('floor', 'ceiling'):
        up = [up[0], up[2], up[1]]
    right = cross(outwards, up)
    (x, y), (width, height), glass = opening['center'], opening['size'], opening.get('glass', {'n': 0})
    return line('hole', [m + x * r + y * u for m, r, u in zip(middle, right, up)], [width / 2 * r for r in right],
                [height / 2 * u for u in up], glass['n'], glass.get('transmittance', 1))


def mesh_lines(name, reflectance):
    """The triangles of an OBJ file."""
    with open(name, encoding='ascii') as file:
        rows = [text.split() for text in file]
    corners = [[float(x) for x in row[1:]] for row in rows if row[0] == 'v']
    return [line('tri', *(corners[int(i) - 1] for i in row[1:]), reflectance) for row in rows if row[0] == 'f']


def surface_lines(thing):
    reflectance, kind = thing['material']['diffuse'], thing['type']
    if kind in ('room', 'box'):
        lines = []
        for name, center, (u, v) in sides(thing):
            lines.append(line('quad', center, u, v, thing.get('materials', {}).get(name, thing['material'])['diffuse']))
            lines += [hole_line(opening, thing, center) for opening in thing.get('openings', ())
                      if opening['wall'] == name]
        return lines
    if kind == 'mesh':
        return mesh_lines(thing['file'], reflectance)
    if kind == 'rectangle':
        u, v = frame(thing)
        return [line('quad', thing['center'], u, v, reflectance)]
    if kind == 'disk':
        return [line('disk', thing['center'], thing['axis'], thing['radius'], reflectance)]
    if kind == 'sphere':
        return [line('ball', thing['center'], thing['radius'], reflectance)]
    if kind == 'cylinder':
        return [line('tube', thing['center'], thing['axis'], thing['height'] / 2, thing['radius'], reflectance)]
    raise ValueError(kind)


def spot_line(lamp, place):
    """A smooth cone, or one with a hard edge, whose flux in all is the power."""
    inner, outer = (math.cos(math.radians(lamp[key])) for key in ('inner', 'outer'))
    if inner - outer < 1e-12:
        solid, inner = 1 - outer, outer + 1e-12
    else:
        solid = 1 - inner + (inner - outer) / 2  # a smooth step has half of the zone that it lies on
    axis = [a - b for a, b in zip(lamp['aim'], place)]
    return line('spot', place, axis, lamp['power'] / (2 * math.pi * solid), inner, outer)


OPENING = 4  # points along each side of an opening, that stand for it


def opening_lines(lamp, place):
    """The rectangle that a file declares in metres, its length along c0, around the place."""
    axis, c0 = (unit(lamp.get(key, usual)) for key, usual in (('axis', [0, 0, -1]), ('c0', [1, 0, 0])))
    words = table_words(lamp)
    if words[6] != 2 or words[9] != 0 or words[7] <= 0 or words[8] <= 0:
        raise ValueError(lamp['file'])
    across = cross(c0, axis)
    shares = [(2 * i + 1) / (2 * OPENING) - 0.5 for i in range(OPENING)]
    return [table_line(lamp, [p + 1000 * (a * words[8] * u + b * words[7] * v) for p, u, v in zip(place, c0, across)],
                       1 / OPENING ** 2) for a in shares for b in shares]


def table_words(lamp):
    with open(lamp['file'], encoding='latin-1') as file:
        text = file.read()
    return [float(word) for word in text[text.index('TILT=NONE') + 9:].split()]


def table_line(lamp, place, share=1):
    """A file whose planes are a quarter of the round, from 0 to 90 degrees."""
    words = table_words(lamp)
    factor, ups, arounds = words[2], int(words[3]), int(words[4])
    up, around = words[13:13 + ups], words[13 + ups:13 + ups + arounds]
    rows = words[13 + ups + arounds:]
    factor *= words[10] * words[11] * share
    if around[0] != 0 or around[-1] != 90 or len(rows) != ups * arounds:
        raise ValueError(lamp['file'])
    return line('table', place, lamp.get('axis', [0, 0, -1]), lamp.get('c0', [1, 0, 0]), ups, arounds, up, around,
                [factor * x for x in rows])


def copies(lamp, place):
    """The places of an array."""
    array = lamp.get('array')
    if not array:
        return [place]
    axes = [unit(axis) for axis in array.get('axes', [[1, 0, 0], [0, 1, 0]])]
    steps = [[(i - (n - 1) / 2) * spacing for i in range(n)] for n, spacing in zip(array['n'], array['spacing'])]
    return [[p + a * u + b * v for p, u, v in zip(place, *axes)] for b in steps[1] for a in steps[0]]


def along(altitude, azimuth, up=(0, 0, 1), north=(0, 1, 0)):
    """The way to a place of the sky."""
    a, b = math.radians(altitude), math.radians(azimuth)
    return [math.cos(a) * (math.sin(b) * e + math.cos(b) * n) + math.sin(a) * u
            for e, n, u in zip(cross(north, up), north, up)]


def sky_line(sky):
    altitude, azimuth = (sky.get('sun', {}).get(key, 0) for key in ('altitude', 'azimuth'))
    up, north = sky.get('up', [0, 0, 1]), sky.get('north', [0, 1, 0])
    by = next(key for key in ('zenith', 'horizontal', 'diffuse') if key in sky)
    level = ' %s ' % ('zenith' if by == 'zenith' else 'horizontal') + line('', sky[by], sky.get('ground', 0)).strip()
    if sky.get('kind') == sky_scenes.OVERCAST:
        return line('overcast', up) + level
    if 'kind' in sky:
        shape = [*sky_scenes.coefficients(sky['kind'])]
        shape.append(math.exp(shape[3] * math.pi / 2))
    else:
        shape = [*perez.coefficients(sky['direct'], sky['diffuse'], altitude, 127500), 0]
    return line('sky', shape, up, along(altitude, azimuth, up, north)) + level


def lamp_lines(lamp):
    kind = lamp['type']
    if kind == 'sky':
        return [sky_line(lamp)]
    if kind == 'sun':
        way = along(lamp['altitude'], lamp['azimuth'], lamp.get('up', [0, 0, 1]), lamp.get('north', [0, 1, 0]))
        return [line('sun', way, math.radians(lamp['diameter']) / 2, lamp['irradiance'])]
    if kind == 'planar':
        shape = lamp['rectangle']
        u, v = frame(shape)
        area = shape['size'][0] * shape['size'][1] * 1e-6
        return [line('plate', place, u, v, lamp['power'] / (math.pi * area)) for place in copies(lamp, shape['center'])]
    if kind == 'volume':
        radius = lamp['sphere']['radius']
        return [line('globe', lamp['sphere']['center'], radius,
                     lamp['power'] / (math.pi * 4 * math.pi * radius * radius * 1e-6))]
    places = copies(lamp, lamp['position'])
    if kind == 'point':
        return [line('point', place, lamp['power'] / (4 * math.pi)) for place in places]
    if kind == 'spot':
        return [spot_line(lamp, place) for place in places]
    if kind == 'luminaire' and lamp.get('opening') == 'file':
        return [text for place in places for text in opening_lines(lamp, place)]
    if kind == 'luminaire':
        return [table_line(lamp, place) for place in places]
    raise ValueError(kind)


def listing(surfaces, lights, places, side=64, batches=16, seed=1, bounces=-1):
    lines = [text for thing in surfaces for text in surface_lines(thing)]
    lines += [text for lamp in lights for text in lamp_lines(lamp)]
    lines += [line('place', place, normal) for place, normal in places]
    return '\n'.join(lines + [line('work', side, batches, seed, bounces)]) + '\n'


def ask(program, surfaces, lights, places, **work):
    """Irradiances at places, [(value, standard error)]."""
    ended = subprocess.run([program], input=listing(surfaces, lights, places, **work), capture_output=True,
                           encoding='ascii', check=True)
    return [tuple(float(x) for x in text.split()) for text in ended.stdout.split('\n') if text]
