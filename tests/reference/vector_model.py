# SPDX-License-Identifier: MIT
"""The lighting model for many screen points at once, in NumPy's extended precision: the truth for pictures.

A second writing of model.py, held against it by test_model.py.  Besides the values it tells the decisions that
were taken at each point (which surface is seen, who stands in whose shadow, inside or outside a hard cone), so
that a test can tell a jump of the truth itself from an error.
"""
from collections import namedtuple

import numpy as np

import model
from completion import completed

REAL = np.longdouble
PI = REAL(4) * np.arctan(REAL(1))

# Arrays over the points: value, whether on a surface, and one row of small integers per decision.
Values = namedtuple('Values', 'value mask decisions')
# The seen elements, as arrays with x, y, z in rows, and the index of the surface they belong to.
Elements = namedtuple('Elements', 'position normal view own')


def real(number):
    return REAL(number)


def column(numbers):
    """A vector as a column that combines with arrays of vectors."""
    return np.array([REAL(number) for number in numbers], dtype=REAL)[:, None]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def unit(a):
    return a / np.sqrt(dot(a, a))


def power(base, exponent):
    """base^exponent for base >= 0, with x^0 = 1."""
    return np.ones_like(base) if exponent == 0 else np.power(base, real(exponent))


def crossings(start, direction, sphere):
    """Where rays cross a sphere: the two t, NaN where they miss it."""
    offset = start - column(sphere['center'])
    a = dot(direction, direction)
    b = dot(direction, offset)
    # a R^2 - |D x O|^2 is b^2 - a (O^2 - R^2) without its cancellation.
    beside = cross(direction, offset)
    root = np.sqrt(a * real(sphere['radius']) ** 2 - dot(beside, beside))
    return (-b - root) / a, (-b + root) / a


def plate_frame(plate):
    """Center, unit vectors along w and h, axis, as columns."""
    center = column(plate['center'])
    axis = unit(column(plate.get('axis', [0, 0, 1])))
    up = column(plate.get('up', [0, 1, 0]))
    if 'up' not in plate and not cross(up, axis).any():
        up = column([0, 0, 1])
    high = unit(up - dot(up, axis) * axis)
    return center, cross(high, axis), high, axis


def plate_crossing(start, direction, plate):
    """Where rays cross a rectangle: t, NaN where they miss it; and whether they come from its front."""
    center, wide, high, axis = plate_frame(plate)
    slope = dot(direction, axis)
    t = dot(center - start, axis) / slope
    met = start + t * direction - center
    w, h = (real(size) / 2 for size in plate['size'])
    return np.where((np.abs(dot(met, wide)) <= w) & (np.abs(dot(met, high)) <= h), t, np.nan), slope < 0


def seen_distance(start, direction, surface):
    if surface['type'] == 'rectangle':
        t, front = plate_crossing(start, direction, surface)
        return np.where(front, t, np.nan)
    return crossings(start, direction, surface)[0]


def all_crossings(start, direction, surface):
    if surface['type'] == 'rectangle':
        return [plate_crossing(start, direction, surface)[0]]
    return crossings(start, direction, surface)


def seen_elements(scene, x, y):
    observer = column([0, 0, scene['observer']['z']])
    perspective = scene['observer']['projection'] == 'perspective'
    zero = np.zeros_like(x)
    if perspective:
        start = observer + np.array([zero, zero, zero])
        direction = np.array([x, y, zero]) - observer
    else:
        start = np.array([x, y, zero + observer[2]])
        direction = column([0, 0, -1]) + np.array([zero, zero, zero])
    nearest = np.full_like(x, np.inf)
    own = np.full(x.shape, -1)
    normal = np.zeros_like(start)
    for index, surface in enumerate(scene['surfaces']):
        distance = seen_distance(start, direction, surface)
        closer = (distance > 0) & (distance < nearest)
        nearest = np.where(closer, distance, nearest)
        own = np.where(closer, index, own)
        if surface['type'] == 'rectangle':
            outwards = plate_frame(surface)[3] + np.zeros_like(start)
        else:
            outwards = unit(start + distance * direction - column(surface['center']))
        normal = np.where(closer, outwards, normal)
    position = np.where(own < 0, 0, start + nearest * direction)
    for index, surface in enumerate(scene['surfaces']):
        if surface['type'] == 'sphere':
            position = np.where(own == index, column(surface['center']) + real(surface['radius']) * normal, position)
    if perspective or scene['observer']['view'] == 'observer':
        view = unit(observer - position)
    else:
        view = column([0, 0, 1]) + np.zeros_like(position)
    return Elements(position, normal, view, own)


def attenuation(light, distance_mm):
    distance = distance_mm / 1000
    law = light['attenuation']
    if law == 'none':
        return np.ones_like(distance)
    if law == 'inverse-square':
        return 1 / distance ** 2
    if law == 'practical':
        return 1 / (real(light['k']) / 1000 + distance)
    constant, linear, square = (real(number) for number in light['coefficients'])
    return 1 / (constant + linear * distance + square * distance ** 2)


def cone(light, axis, direction, decisions):
    """f max(0, cos)^m of a spot, with 1 - cos as 2 sin^2 of half the angle, so that needles keep their digits."""
    inner, outer = (real(light[key]) * PI / 180 for key in ('inner', 'outer'))
    apart, together = -direction - axis, axis - direction
    depth = dot(apart, apart) / 2
    depth_inner, depth_outer = (2 * np.sin(angle / 2) ** 2 for angle in (inner, outer))
    falloff = 'hard' if inner == outer else light['falloff']
    if falloff == 'hard':
        factor = np.where(depth <= depth_outer, REAL(1), REAL(0))
        decisions.append(factor > 0)
    elif falloff == 'linear':
        angle = 2 * np.arctan2(np.sqrt(dot(apart, apart)), np.sqrt(dot(together, together)))
        factor = np.clip((outer - angle) / (outer - inner), 0, 1)
    else:
        t = np.clip((depth_outer - depth) / (depth_outer - depth_inner), 0, 1)
        factor = t * t if falloff == 'squared' else t * t * (3 - 2 * t)
    return factor * power(np.maximum(1 - depth, 0), light['exponent'])


def sample(light, position, decisions):
    """Direction towards the light, irradiance facing it, distance in mm."""
    if light['type'] == 'distant':
        direction = -unit(column(light['direction'])) + np.zeros_like(position)
        return direction, np.full_like(position[0], real(light['irradiance'])), np.full_like(position[0], np.inf)
    way = column(light['position']) - position
    distance = np.sqrt(dot(way, way))
    direction = way / distance
    axis = unit(column(light['aim']) - column(light['position']) if 'aim' in light else column(light['axis']))
    if light['type'] == 'spot':
        factor = cone(light, axis, direction, decisions)
    else:
        exponent = {'isotropic': 0, 'lambertian': 1, 'cosine': light['exponent']}[light['pattern']]
        factor = power(np.maximum(-dot(axis, direction), 0), exponent)
    return direction, real(str(model.intensity(light))) * factor * attenuation(light, distance), distance


def blocked(scene, elements, direction, distance):
    """Where another surface stands between element and source."""
    result = np.zeros(elements.own.shape, dtype=bool)
    if scene['shadows'] == 'none':
        return result
    for index, surface in enumerate(scene['surfaces']):
        for t in all_crossings(elements.position, direction, surface):
            result |= (elements.own != index) & (t > 0) & (t < distance)
    return result


def lobe(material, normal, light, view):
    if material['model'] == 'phong':
        return np.maximum(dot(2 * dot(normal, light) * normal - light, view), 0)
    between = light + view
    size = np.sqrt(dot(between, between))
    return np.where(size > 0, np.maximum(dot(normal, between) / size, 0), 0)


def normalization(material):
    n = real(material['shininess'])
    if not material['normalized']:
        return REAL(1)
    if material['model'] == 'phong':
        return (n + 2) / 2
    return (n + 2) * (n + 4) / (8 * (n + REAL(2) ** (-n / 2)))


def brightness_per_irradiance(material, elements, direction, cosine, decisions):
    """kd max(0, N.L) + ks c w S^n, times p: what the material makes of one unit facing the light."""
    received = np.maximum(cosine, 0)
    result = real(material['diffuse']) * received
    if material['model'] != 'lambert':
        weight = REAL(1)
        if material['highlight'] == 'gated':
            weight = np.where(cosine > 0, REAL(1), REAL(0))
            decisions.append(cosine > 0)
        elif material['highlight'] == 'cosine':
            weight = received
        s = lobe(material, elements.normal, direction, elements.view)
        highlight = weight * power(s, material['shininess'])
        result = result + real(material['specular']) * normalization(material) * highlight
    return result / PI if material['over_pi'] else result


def evaluate(scene, x, y, quantity='brightness'):
    """Values for the screen points x, y (arrays of one length), of the scene as the user wrote it."""
    scene = completed(scene)
    x, y = np.asarray(x, dtype=REAL), np.asarray(y, dtype=REAL)
    with np.errstate(all='ignore'):
        elements = seen_elements(scene, x, y)
        decisions = [elements.own]
        value = np.zeros_like(x)
        for light in scene['lights']:
            value = value + _from_light(scene, elements, light, quantity, decisions)
    mask = elements.own >= 0
    return Values(np.where(mask, value, 0), mask, np.array([np.where(mask, taken, -1) for taken in decisions]))


def _from_light(scene, elements, light, quantity, decisions):
    """What one light adds to the value at every point."""
    result = np.zeros_like(elements.position[0])
    materials = [surface['material'] for surface in scene['surfaces']]
    if light['type'] == 'ambient':
        irradiance = real(light['irradiance'])
        if quantity == 'irradiance':
            return result + irradiance
        for index, material in enumerate(materials):
            p = 1 / PI if material['over_pi'] else REAL(1)
            result = np.where(elements.own == index, p * real(material['ambient']) * irradiance, result)
        return result
    direction, facing, distance = sample(light, elements.position, decisions)
    shadow = blocked(scene, elements, direction, distance)
    decisions.append(shadow)
    facing = np.where(shadow, 0, facing)
    cosine = dot(elements.normal, direction)
    if quantity == 'irradiance':
        return facing * np.maximum(cosine, 0)
    for index, material in enumerate(materials):
        reflected = brightness_per_irradiance(material, elements, direction, cosine, decisions)
        result = np.where(elements.own == index, facing * reflected, result)
    return result


def samples(scene):
    """The screen points of all pixels in row order, as two arrays."""
    screen = completed(scene)['screen']
    columns, rows = screen['resolution']
    axes = []
    for count, size in ((columns, real(screen['width'])), (rows, real(screen['height']))):
        index = np.arange(count, dtype=REAL)
        if screen['sampling'] == 'nodes':
            axes.append(-size / 2 + index * size / (count - 1))
        else:
            axes.append(-size / 2 + (index + REAL(0.5)) * size / count)
    x, y = np.meshgrid(axes[0], -axes[1])
    return x.ravel(), y.ravel()


def jumps_nearby(scene, x, y, quantity, reach):
    """Whether a decision changes within `reach` of each screen point (so the truth may jump there)."""
    here = evaluate(scene, x, y, quantity).decisions
    result = np.zeros(len(x), dtype=bool)
    for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1), (0.7, 0.7), (0.7, -0.7), (-0.7, 0.7), (-0.7, -0.7)):
        there = evaluate(scene, x + REAL(dx) * reach, y + REAL(dy) * reach, quantity).decisions
        result |= (here != there).any(axis=0)
    return result
