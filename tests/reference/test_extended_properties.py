# SPDX-License-Identifier: MIT
"""What must hold for planar and volumetric sources without any reference: superposition, symmetry, scale, splitting,
limits, and the places where a source has nothing to give."""
import math
import os
import tempfile

import numpy as np

import extended_scenes
import scenes
from luxel import TOLERANCE, arguments, generator
from tap import Tap

SCENES = 4
STAGE = {
    'luxel': 1,
    'screen': {'width': 100, 'height': 100, 'resolution': [10, 10]},
    'observer': {'z': 20000},
    'surfaces': [{'type': 'sphere', 'center': [0, 0, -90000], 'radius': 100}],
}
IRRADIANCE = ('--quantity', 'irradiance')
# Where lengths, places and directions stand in a light or a surface.
PLACES = ('center', 'position', 'aim')
DIRECTIONS = ('axis', 'up', 'direction')
LENGTHS = ('radius', 'height', 'size', 'k')


def found(luxel, scene, elements, options=()):
    # Slivers may be known to less than the tolerance: their stated error says so.
    points = luxel.probe(scene, elements=elements, options=options, accept=(0, TOLERANCE))['points']
    return [point['value'] for point in points], [point['error'] for point in points]


def mapped(node, place, direction, length):
    """A copy of a light or surface with every place, direction and length replaced."""
    result = {}
    for key, value in node.items():
        if key in PLACES:
            value = place(value)
        elif key in DIRECTIONS:
            value = direction(value)
        elif key in LENGTHS:
            value = [length(x) for x in value] if isinstance(value, list) else length(value)
        elif key == 'vertices':
            value = [place(corner) for corner in value]
        elif isinstance(value, dict) and key != 'material':
            value = mapped(value, place, direction, length)
        result[key] = value
    return result


def random_light(rng, makes=None, size=None, laws=False):
    """A source around the origin and elements above its lit side."""
    size = size or scenes._log_uniform(rng, 10, 1000)
    center, axis = [rng.uniform(-1, 1) * size for _ in range(3)], scenes._direction(rng)
    make = rng.choice(makes or [make for make in extended_scenes.PLANAR + extended_scenes.BODIES
                                if make is not extended_scenes._solid and make is not extended_scenes._prism])
    light = extended_scenes._source(rng, make, center, size, axis, laws=laws)
    elements = []
    for _ in range(3):
        towards = scenes._unit(scenes._add(scenes._direction(rng), axis, 1))
        elements.append(extended_scenes._element(rng, center, size * scenes._log_uniform(rng, 1, 10), towards))
    return light, elements


def with_defaults(light):
    """The axis and up that a light has when it does not say so, said: so that they can be turned."""
    light = dict(light)
    for key in ('rectangle', 'disk'):
        if key in light:
            extra = {} if 'axis' in light[key] or 'aim' in light[key] else {'axis': [0, 0, -1]}
            light[key] = {**extra, **({'up': [0, 1, 0]} if key == 'rectangle' else {}), **light[key]}
    return light


def agree(tap, luxel, name, pairs, options=(), relative=1e-12):
    """Two scenes that must give the same, but for their stated errors."""
    bad = []
    for (scene, elements), (other, moved) in pairs:
        one, error = found(luxel, scene, elements, options)
        two, more = found(luxel, other, moved, options)
        for i, (a, b) in enumerate(zip(one, two, strict=True)):
            if not abs(a - b) <= relative * abs(a) + error[i] + more[i]:
                bad.append(f'{a!r} and {b!r}, stated {error[i]:.3g} and {more[i]:.3g}\n  at {elements[i]} of {scene}\n'
                           f'  at {moved[i]} of {other}')
    tap.ok(pairs and not bad, name, f'{len(bad)} places', *bad[:2])


def scene_of(*lights, **keys):
    return {**STAGE, 'lights': list(lights), **keys}


def drawn(options, name, count=None):
    return [generator(options.seed, name, i) for i in range(options.campaign or count or SCENES)]


def test_superposition(tap, options):
    pairs = []
    bad = []
    for rng in drawn(options, 'superposition'):
        light, elements = random_light(rng, laws=True)
        other = {**random_light(rng, laws=True)[0]}
        surface = {**STAGE['surfaces'][0], 'material': scenes.material(rng)}
        whole, error = found(options.luxel, scene_of(light, other, surfaces=[surface]), elements)
        parts = [found(options.luxel, scene_of(one, surfaces=[surface]), elements) for one in (light, other)]
        for i, value in enumerate(whole):
            total = parts[0][0][i] + parts[1][0][i]
            pairs.append(value)
            if abs(value - total) > 1e-12 * value + error[i] + parts[0][1][i] + parts[1][1][i]:
                bad.append(f'{value!r} and {total!r} at {elements[i]} of {light} and {other}')
    tap.ok(pairs and not bad, 'two sources give the sum of what each gives', *bad[:2])


def test_turned(tap, options):
    """The whole scene turned about z."""
    pairs = []
    for rng in drawn(options, 'turned'):
        light, elements = random_light(rng, laws=True)
        light = with_defaults(light)
        if 'facets' in light.get('sphere', {}) or 'box' in light:
            light, elements = random_light(rng, (extended_scenes._convex, extended_scenes._cylinder), laws=True)
        c, s = math.cos(1.1), math.sin(1.1)

        def turn(v):
            return [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]]

        surface = {**STAGE['surfaces'][0], 'material': scenes.material(rng)}
        other = mapped(light, turn, turn, lambda x: x)
        pairs.append(((scene_of(light, surfaces=[surface]), elements),
                      (scene_of(other, surfaces=[surface]), [turn(e[:3]) + turn(e[3:]) for e in elements])))
    # The turned numbers are rounded: places by 1e-16 of the scene, and lobes are steep.
    agree(tap, options.luxel, 'the whole scene turned about z looks the same', pairs, relative=1e-11)


def test_scaled(tap, options):
    pairs = []
    for rng in drawn(options, 'scaled'):
        light, elements = random_light(rng)
        light = {**light, 'radiance': 1}
        for key in ('power', 'intensity'):
            light.pop(key, None)
        factor = 2.0 ** rng.randint(-12, 12)

        def longer(v):
            return [factor * x for x in v]

        other = mapped(light, longer, lambda v: v, lambda x: factor * x)
        pairs.append(((scene_of(light), elements), (scene_of(other), [longer(e[:3]) + e[3:] for e in elements])))
    agree(tap, options.luxel, 'closed forms do not know the unit of length', pairs, IRRADIANCE)


def test_split(tap, options):
    """A convex outline cut along a line between two of its corners."""
    bad, count = [], 0
    for rng in drawn(options, 'split', 10):
        light, elements = random_light(rng, (extended_scenes._convex,))
        corners = light['vertices']
        if len(corners) == 3:
            continue
        cut = rng.randint(2, len(corners) - 2)
        whole, *parts = ({'type': 'planar', 'vertices': part, 'radiance': 3}
                         for part in (corners, corners[:cut + 1], corners[cut:] + corners[:1]))
        (one, error), (two, more) = (found(options.luxel, scene, elements, IRRADIANCE)
                                     for scene in (scene_of(whole), scene_of(*parts)))
        count += 1
        bad += [f'{a!r} and {b!r} at {e} of {corners}' for a, b, x, y, e in zip(one, two, error, more, elements)
                if abs(a - b) > 1e-12 * a + x + y]
    tap.ok(count and not bad, 'an outline cut in two gives the same', *bad[:2])


def mirrored(elements, corners):
    """Elements mirrored in an outline's plane: each sees of the back what it saw of the front."""
    a, b, c = (np.array(corner) for corner in corners[:3])
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal)
    result = []
    for element in elements:
        place, up = np.array(element[:3]), np.array(element[3:])
        result.append([*(place - 2 * np.dot(place - a, normal) * normal), *(up - 2 * np.dot(up, normal) * normal)])
    return result


def test_reversed(tap, options):
    """One side shines to where it faces alone; both sides shine alike to either, whatever the order of the corners."""
    bad, lit = {'front': [], 'both': []}, {'front': 0, 'both': 0}
    for rng in drawn(options, 'reversed'):
        drawn_light, elements = random_light(rng, (extended_scenes._convex, extended_scenes._star))
        for sides in lit:
            light = {**drawn_light, 'sides': sides}
            back = {**light, 'vertices': light['vertices'][::-1]}
            others = mirrored(elements, light['vertices'])
            answers = [found(options.luxel, scene_of(one), places, IRRADIANCE)[0]
                       for one in (light, back) for places in (elements, others)]
            for values in zip(*answers):
                front, front_mirrored, reverse, reverse_mirrored = values
                lit[sides] += front > 0
                behind = front if sides == 'both' else 0
                pairs = (reverse_mirrored, front), (front_mirrored, behind), (reverse, behind)
                if any(abs(value - expected) > 1e-9 * expected for value, expected in pairs):
                    bad[sides].append(f'{values} of {light}')
    tap.ok(lit['front'] and not bad['front'], 'reversed vertices let the other side shine, and only that',
           *bad['front'][:2])
    tap.ok(lit['both'] and not bad['both'], 'both sides shine alike, whatever the order of the vertices',
           *bad['both'][:2])


def test_far(tap, options):
    """Seen from far, a source is its point law with an error of order 2 in size/distance."""
    for light, intensity in (({'rectangle': {'center': [0, 0, 0], 'size': [60, 40]}, 'intensity': 7}, 7),
                             ({'disk': {'center': [0, 0, 0], 'radius': 30}, 'intensity': 7}, 7),
                             ({'vertices': [[-30, 10, 0], [0, 40, 0], [30, 10, 0], [0, -60, 0]], 'intensity': 7}, 7),
                             ({'sphere': {'center': [0, 0, 0], 'radius': 30}, 'power': 4 * math.pi}, None)):
        scene = scene_of({'type': 'planar' if intensity else 'volume', **light})
        errors = []
        for distance in (1000, 2000, 4000):
            # 16 degrees off its axis.
            element = [0.28 * distance, 0, -0.96 * distance, -0.28, 0, 0.96]
            value = found(options.luxel, scene, [element], IRRADIANCE)[0][0]
            law = (7 * 0.96 if intensity else 1.0) / (distance / 1000) ** 2
            errors.append(value / law - 1)
        # A ball is its point law exactly.
        falls = all(3.9 * abs(b) < abs(a) < 4.1 * abs(b) for a, b in zip(errors, errors[1:]))
        good = max(map(abs, errors)) < 1e-12 or falls
        tap.ok(good, f'far from {next(iter(light))} the point law holds with order 2', errors)


def test_parts(tap, options):
    """Cut into N x N parts a source converges with order 2, and N = 1 is the textbook's far formula."""
    for law in ({}, {'attenuation': 'practical', 'k': 200}, {'attenuation': 'none'},
                {'attenuation': 'polynomial', 'coefficients': [0.2, 0.5, 0.8]}):
        for shape in ({'rectangle': {'center': [100, 50, 800], 'size': [400, 300]}},
                      {'vertices': [[-200, -100, 800], [0, 200, 800], [150, -50, 800]]},
                      {'vertices': [[-200, -100, 800], [-150, 200, 800], [50, 200, 800], [150, -50, 800]]},
                      {'disk': {'center': [50, 0, 800], 'radius': 200}}):
            light = {'type': 'planar', **shape, 'radiance': 2, **law}
            if 'vertices' in shape:
                light['vertices'] = shape['vertices']
            element = [0, 0, 0, 0.2, 0.1, 1]
            limit = found(options.luxel, scene_of(light), [element], IRRADIANCE)[0][0]
            errors = [found(options.luxel, scene_of({**light, 'parts': n}), [element], IRRADIANCE)[0][0] - limit
                      for n in (4, 8, 16, 32)]
            ratios = [a / b for a, b in zip(errors, errors[1:])]
            name = f'{next(iter(shape))} of {len(shape.get("vertices", "1234"))} corners, {law or "inverse-square"}'
            tap.ok(limit > 0 and all(3.5 < ratio < 4.5 for ratio in ratios[1:]), f'parts converge with order 2: {name}',
                   limit, errors, ratios)


def test_one_part(tap, options):
    """I/(k + r) cos cos, as the textbook writes it."""
    light = {'type': 'planar', 'rectangle': {'center': [100, 50, 800], 'size': [400, 300]}, 'intensity': 5, 'parts': 1,
             'attenuation': 'practical', 'k': 200}
    value = found(options.luxel, scene_of(light), [[0, 0, 0, 0.6, 0, 0.8]], IRRADIANCE)[0][0]
    r = math.sqrt(100 ** 2 + 50 ** 2 + 800 ** 2)
    expected = 5 / (0.2 + r / 1000) * (800 / r) * ((0.6 * 100 + 0.8 * 800) / r)
    tap.near(value, expected, 1e-12, 'one part is the far formula of the textbook')


def test_faceted(tap, options):
    """Lamp shades become round: the error of an inscribed polyhedron falls with order 2 in the number of facets."""
    for shape in ({'sphere': {'center': [0, 0, 900], 'radius': 200}},
                  {'cylinder': {'center': [0, 0, 900], 'radius': 200, 'height': 300}}):
        key = next(iter(shape))
        element = [500, 0, 0, -0.1, 0.1, 1]
        light = {'type': 'volume', 'radiance': 2, **shape}
        limit = found(options.luxel, scene_of(light), [element], IRRADIANCE)[0][0]
        faceted = [scene_of({**light, key: {**shape[key], 'facets': n}}) for n in (16, 32, 64, 128)]
        errors = [found(options.luxel, scene, [element], IRRADIANCE)[0][0] - limit for scene in faceted]
        ratios = [a / b for a, b in zip(errors, errors[1:])]
        tap.ok(all(error < 0 for error in errors) and 3 < ratios[-1] < 5,
               f'facets of a {key} converge from below with order 2', errors, ratios)


def test_sphere_mean(tap, options):
    """Mean irradiance over a whole sphere from a polygon: M times its solid angle over 4 pi."""
    rng = generator(options.seed, 'mean')
    nodes, weights = np.polynomial.legendre.leggauss(24)
    for make in (extended_scenes._convex, extended_scenes._star, extended_scenes._rectangle):
        light = extended_scenes._source(rng, make, [0, 0, 0], 900, [0, 0, -1], laws=False)
        for key in ('power', 'intensity'):
            light.pop(key, None)
        light['radiance'] = 1 / math.pi
        if 'rectangle' in light:
            light['rectangle'] = {'center': [0, 0, 0], 'size': [900, 500], 'axis': [0, 0, -1]}
        center = [80, -50, -400]
        angle = solid_angle(corners_of(light), center)
        for radius in (100, 350):
            elements, shares = [], []
            for node, weight in zip(nodes, weights):
                ring = math.sqrt(1 - node * node)
                for i in range(48):
                    turn = 2 * math.pi * (i + 0.5) / 48
                    normal = [ring * math.cos(turn), ring * math.sin(turn), node]
                    elements.append([c + radius * n for c, n in zip(center, normal)] + normal)
                    shares.append(weight / 96)
            values = found(options.luxel, scene_of(light), elements, IRRADIANCE)[0]
            mean = math.fsum(value * share for value, share in zip(values, shares))
            tap.near(mean, angle / (4 * math.pi), 2e-4,
                     f'mean over a sphere of {radius} mm of {next(iter(light.keys() - {"type", "radiance"}))}')


def corners_of(light):
    if 'vertices' in light:
        return light['vertices']
    w, h = (size / 2 for size in light['rectangle']['size'])
    x, y, z = light['rectangle']['center']
    return [[x - w, y - h, z], [x - w, y + h, z], [x + w, y + h, z], [x + w, y - h, z]]


def solid_angle(corners, center):
    """Signed solid angles of the triangles of a fan, by Van Oosterom and Strackee."""
    total = 0.0
    a, *rest = (np.subtract(corner, center) for corner in corners)
    for b, c in zip(rest, rest[1:]):
        la, lb, lc = (np.linalg.norm(v) for v in (a, b, c))
        total += 2 * math.atan2(np.dot(a, np.cross(b, c)),
                                la * lb * lc + np.dot(a, b) * lc + np.dot(a, c) * lb + np.dot(b, c) * la)
    return abs(total)


def test_places(tap, options):
    """On a source: no value but a reason; in its plane, behind it, inside it: 0."""
    plane = {'center': [0, 0, 500], 'size': [200, 100]}
    for name, light, on, dark in (
            ('rectangle', {'type': 'planar', 'rectangle': plane},
             [[0, 0, 500], [100, 50, 500], [100, 0, 500], [-30, 20, 500]], [[101, 0, 500], [0, 0, 501], [0, 70, 500]]),
            ('disk', {'type': 'planar', 'disk': {'center': [0, 0, 500], 'radius': 100}},
             [[0, 0, 500], [100, 0, 500], [60, 80, 500]], [[101, 0, 500], [0, 0, 501]]),
            ('vertices', {'type': 'planar', 'vertices': [[0, 0, 500], [0, 100, 500], [50, 20, 500], [100, 0, 500]]},
             [[10, 10, 500], [0, 0, 500], [50, 20, 500]], [[90, 90, 500], [60, 40, 500], [10, 10, 600]]),
            ('box', {'type': 'volume', 'box': {'center': [0, 0, 500], 'size': [100, 200, 300]}},
             [[50, 0, 500], [50, 100, 650], [10, 10, 350]], [[0, 0, 500], [49, 99, 649]]),
            ('sphere', {'type': 'volume', 'sphere': {'center': [0, 0, 500], 'radius': 100}},
             [[0, 0, 400], [60, 0, 580]], [[0, 0, 500], [0, 0, 599]]),
            ('cylinder', {'type': 'volume', 'cylinder': {'center': [0, 0, 500], 'radius': 100, 'height': 200}},
             [[0, 0, 400], [60, 80, 500], [100, 0, 600]], [[0, 0, 500], [70, 70, 599]])):
        scene = scene_of({**light, 'radiance': 1})
        normals = ([0, 0, 1], [1, 1, 1], [0, -1, -0.5])
        answers = options.luxel.probe(scene, elements=[place + n for place in on for n in normals])['points']
        tap.ok(all(a['value'] is None and 'lights[0]' in a.get('reason', '') for a in answers),
               f'{name}: no value on the source, and the reason', [a for a in answers if a['value'] is not None][:3])
        answers = options.luxel.probe(scene, elements=[place + n for place in dark for n in normals])['points']
        tap.ok(all(a['value'] == 0 and a['error'] < 1e-12 for a in answers), f'{name}: 0 where nothing shines',
               [a for a in answers if a['value'] != 0 or a['error'] >= 1e-12][:3])


def test_hidden(tap, options):
    """What a sphere takes from a plate: all light; by `points` that of points and parts, by `none` nothing."""
    surfaces = [{'type': 'rectangle', 'center': [0, 0, 0], 'size': [400, 400]},
                {'type': 'sphere', 'center': [0, 0, 300], 'radius': 50}]
    screen = {'width': 400, 'height': 400, 'resolution': [8, 8]}
    lamp = {'rectangle': {'center': [200, 0, 600], 'size': [20, 20], 'aim': [-100, 0, 0]}, 'radiance': 100}
    for name, light, hiding in (
            ('converged', {'type': 'planar', **lamp}, ('all',)),
            ('in parts', {'type': 'planar', 'parts': 3, **lamp}, ('all', 'points')),
            ('a point', {'type': 'point', 'position': [200, 0, 600], 'intensity': 0.04}, ('all', 'points'))):
        for shadows in ('all', 'points', 'none'):
            scene = {**STAGE, 'shadows': shadows, 'screen': screen, 'surfaces': surfaces, 'lights': [light]}
            alone = {**scene, 'surfaces': surfaces[:1]}
            element, switches, what = [[-200, 0, 0, 0, 0, 1]], IRRADIANCE, f'{name}, shadows {shadows}'
            value = options.luxel.probe(scene, elements=element, options=switches)['points'][0]['value']
            expected = options.luxel.probe(alone, elements=element, options=switches)['points'][0]['value']
            tap.ok(expected > 0 and value == (0 if shadows in hiding else expected), f'behind a sphere: {what}', value,
                   expected)
            point = options.luxel.probe(scene, points=[[-175, 25]], options=switches)['points'][0]
            tap.ok(abs(point['value'] - point['pixel_value']) <= 4e-6 * expected, f'in the picture: {what}', point)


def test_pictures(tap, options):
    """Every pixel against the probe of its own place."""
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, 'picture.npy')
        for kind in ('planar', 'volume'):
            bad, pixels = [], 0
            for rng in drawn(options, 'picture ' + kind, 3):
                scene = dict(extended_scenes.random_case(rng, kind).scene)
                if any('solid' in light for light in scene['lights']):
                    continue
                columns, rows = 9, 7
                pitch = scene['screen']['height'] / scene['screen']['resolution'][1] * 6
                scene['screen'] = {**scene['screen'], 'width': columns * pitch, 'height': rows * pitch,
                                   'resolution': [columns, rows], 'sampling': 'centers'}
                for quantity, precision, share in (('irradiance', 'single', 2e-6), ('irradiance', 'double', 1e-11),
                                                   ('brightness', 'single', 1e-3 + 2e-6)):
                    switches = ['--quantity', quantity]
                    points = [[(i + 0.5) * pitch - scene['screen']['width'] / 2,
                               scene['screen']['height'] / 2 - (j + 0.5) * pitch]
                              for j in range(rows) for i in range(columns)]
                    probes = options.luxel.probe(scene, points=points, options=switches,
                                                 accept=(0, TOLERANCE))['points']
                    options.luxel.render(scene, output, options=[*switches, '--precision', precision])
                    picture = np.load(output).astype(float).ravel()
                    values = np.array([0 if probe['value'] is None else probe['value'] for probe in probes])
                    off = np.abs(picture - values)
                    pixels += (values > 0).sum()
                    if off.max() > share * values.max() + 1e-38:
                        worst = int(np.argmax(off))
                        bad.append(f'{quantity} {precision}: {picture[worst]!r} and {values[worst]!r} at '
                                   f'{points[worst]}, maximum {values.max()!r}\n  {scene}')
            tap.ok(pixels > 50 and not bad, f'{kind}: every pixel is what the probe says', pixels, *bad[:2])


def main():
    options = arguments(__doc__)
    tap = Tap()
    for test in (test_superposition, test_turned, test_scaled, test_split, test_reversed, test_far, test_parts,
                 test_one_part, test_faceted, test_sphere_mean, test_places, test_hidden, test_pictures):
        if not options.kind or test.__name__.removeprefix('test_') in options.kind:
            tap.run(test, tap, options)
    tap.finish()


main()
