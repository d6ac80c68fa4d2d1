# SPDX-License-Identifier: MIT
"""The truth that luxel's numbers are held against: the lighting model in 50-digit arithmetic.

Written from the description of the model, one formula after the other, for every light on spheres, on plates and on
free elements.  Numbers of a scene count as the float64 that they are read as; lengths are millimetres and become
metres where an attenuation law asks for them.  What extended sources give that has no closed form comes from
cubature.py with a statement of how certain it is.
"""
import math
from collections import namedtuple
from fractions import Fraction

from mpmath import mp, mpf

import cubature
import extended
from completion import completed

mp.dps = 50
TIE = mpf('1e-40')  # cosines that near to each other are equal: only the 50 digits tell them apart

# What one light gives to an element: its three shares, and what tells how well conditioned they are:
# N.L, the lobe's S before its power, and how far the element is from the edge of a cone (in cos theta); then how
# certain irradiance and brightness are (0: to all digits).
Share = namedtuple('Share', 'irradiance diffuse specular cosine lobe edge irradiance_doubt doubt', defaults=(0, 0))
Element = namedtuple('Element', 'position normal view material own is_free', defaults=(False,))
Answer = namedtuple('Answer', 'element shares brightness irradiance doubt irradiance_doubt')


# Vectors are lists of three numbers.

def vector(numbers):
    return [mpf(number) for number in numbers]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def scale(a, factor):
    return [x * factor for x in a]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a):
    return mp.sqrt(dot(a, a))


def unit(a):
    return scale(a, 1 / length(a))


def power(base, exponent):
    """base^exponent for base >= 0, with x^0 = 1."""
    if exponent == 0:
        return mpf(1)
    return mp.power(base, exponent) if base > 0 else mpf(0)


# What is seen.

def observer_position(scene):
    return vector([0, 0, scene['observer']['z']])


def sphere_crossings(start, direction, sphere):
    """The two t, in order, at which start + t direction crosses the sphere; none where it misses it."""
    offset = subtract(start, vector(sphere['center']))
    a = dot(direction, direction)
    b = dot(direction, offset)
    root = b * b - a * (dot(offset, offset) - mpf(sphere['radius']) ** 2)
    if root < 0:
        return []
    root = mp.sqrt(root)
    return [(-b - root) / a, (-b + root) / a]


def plate_crossing(start, direction, plate):
    """The t at which start + t direction crosses a rectangle, edges included, and the cosine it comes in with."""
    center, wide, high, axis = extended.rectangle_frame(plate, [0, 0, 1])
    slope = dot(direction, axis)
    if slope == 0:
        return None
    t = dot(subtract(center, start), axis) / slope
    met = subtract(add(start, scale(direction, t)), center)
    w, h = (mpf(size) / 2 for size in plate['size'])
    return (t, -slope) if abs(dot(met, wide)) <= w and abs(dot(met, high)) <= h else None


def seen_distance(start, direction, surface):
    """The t at which the line of sight meets the front of a surface, or None."""
    if surface['type'] == 'rectangle':
        crossing = plate_crossing(start, direction, surface)
        return crossing[0] if crossing and crossing[1] > 0 and crossing[0] > 0 else None
    crossings = sphere_crossings(start, direction, surface)
    return crossings[0] if crossings and crossings[0] > 0 else None


def normal_at(surface, position):
    if surface['type'] == 'rectangle':
        return extended.rectangle_frame(surface, [0, 0, 1])[3]
    return scale(subtract(position, vector(surface['center'])), 1 / mpf(surface['radius']))


def reach_of(surface):
    """How far a surface reaches from its center."""
    if surface['type'] == 'rectangle':
        return math.hypot(*surface['size']) / 2
    return surface['radius']


def seen_element(scene, x, y):
    """The element that is seen through the screen point (x, y), or None."""
    observer = observer_position(scene)
    perspective = scene['observer']['projection'] == 'perspective'
    if perspective:
        start, direction = observer, [mpf(x), mpf(y), -observer[2]]
    else:
        start, direction = [mpf(x), mpf(y), observer[2]], vector([0, 0, -1])
    hits = []
    for index, surface in enumerate(scene['surfaces']):
        met = seen_distance(start, direction, surface)
        if met is not None:
            hits.append((met, index))
    if not hits:
        return None
    distance, index = min(hits)
    surface = scene['surfaces'][index]
    position = add(start, scale(direction, distance))
    normal = normal_at(surface, position)
    if perspective or scene['observer']['view'] == 'observer':
        view = unit(subtract(observer, position))
    else:
        view = vector([0, 0, 1])
    return Element(position, normal, view, surface['material'], index)


def lies_on(surface, position):
    """Whether a place lies on a surface, to 1e-9 of its size."""
    near = mpf('1e-9') * reach_of(surface)
    if surface['type'] == 'rectangle':
        center, wide, high, axis = extended.rectangle_frame(surface, [0, 0, 1])
        offset = subtract(position, center)
        w, h = (mpf(size) / 2 + near for size in surface['size'])
        return abs(dot(offset, axis)) <= near and abs(dot(offset, wide)) <= w and abs(dot(offset, high)) <= h
    return abs(length(subtract(position, vector(surface['center']))) - mpf(surface['radius'])) <= near


def free_element(scene, numbers):
    """The element of a probe --at: position and normal; it belongs to the surface that it lies on, if to any."""
    position = vector(numbers[:3])
    perspective = scene['observer']['projection'] == 'perspective'
    if perspective or scene['observer']['view'] == 'observer':
        view = unit(subtract(observer_position(scene), position))
    else:
        view = vector([0, 0, 1])
    own = next((i for i, surface in enumerate(scene['surfaces']) if lies_on(surface, position)), None)
    material = scene['surfaces'][own or 0]['material']
    return Element(position, unit(vector(numbers[3:])), view, material, own, True)


# What a light gives.

def attenuation(light, distance_mm):
    distance = distance_mm / 1000
    law = light['attenuation']
    if law == 'none':
        return mpf(1)
    if law == 'inverse-square':
        return 1 / distance ** 2
    if law == 'practical':
        return 1 / (mpf(light['k']) / 1000 + distance)
    constant, linear, square = (mpf(number) for number in light['coefficients'])
    return 1 / (constant + linear * distance + square * distance ** 2)


def axis_of(light):
    if 'aim' in light:
        return unit(subtract(vector(light['aim']), vector(light['position'])))
    return unit(vector(light['axis']))


def pattern(light, cosine):
    """g of a point source, and the distance of its angle from a jump (it has none)."""
    exponent = {'isotropic': 0, 'lambertian': 1, 'cosine': light['exponent']}[light['pattern']]
    return power(max(mpf(0), cosine), exponent), mp.inf


def cone(light, cosine):
    """f max(0, cos)^m of a spot, and the distance of the cosine from the cone's edges."""
    inner, outer = mp.radians(mpf(light['inner'])), mp.radians(mpf(light['outer']))
    cos_inner, cos_outer = mp.cos(inner), mp.cos(outer)
    falloff = 'hard' if inner == outer else light['falloff']
    edge = min(abs(cosine - cos_inner), abs(cosine - cos_outer))
    if cosine < cos_outer - TIE:
        return mpf(0), edge
    if falloff == 'hard' or cosine >= cos_inner:
        factor = mpf(1)
    elif falloff == 'linear':
        factor = (outer - mp.acos(cosine)) / (outer - inner)
    else:
        t = (cosine - cos_outer) / (cos_inner - cos_outer)
        factor = t * t if falloff == 'squared' else t * t * (3 - 2 * t)
    return factor * power(max(mpf(0), cosine), light['exponent']), edge


def solid_angle(light):
    """The integral of pattern, or cone and power, over all directions: 2 pi times that of f(u) u^m over u = cos theta.

    Between the edges of a cone f is a polynomial of u, summed term by term with more digits than narrow cones cancel,
    or, linear in the angle, what is left after one integration by parts is smooth.
    """
    if light['type'] == 'point':
        exponent = {'isotropic': 0, 'lambertian': 1, 'cosine': light['exponent']}[light['pattern']]
        return 4 * mp.pi if exponent == 0 else 2 * mp.pi / (mpf(exponent) + 1)
    with mp.workdps(200):
        inner, outer = mp.radians(mpf(light['inner'])), mp.radians(mpf(light['outer']))
        low, high, m = mp.cos(outer), mp.cos(inner), mpf(light['exponent'])
        if light['outer'] == 90:
            low = mpf(0)

        def moment(power, start, end):
            return (end ** (m + power + 1) - start ** (m + power + 1)) / (m + power + 1)

        whole = moment(0, high, mpf(1))
        if light['falloff'] == 'hard' or inner == outer:
            return 2 * mp.pi * moment(0, low, mpf(1))
        width = high - low
        if light['falloff'] == 'linear':
            panels = max(4, int(mp.sqrt(m) * (outer - inner)) * 4)
            with mp.workdps(40):
                rest = mp.quad(lambda angle: mp.cos(angle) ** (m + 1), mp.linspace(inner, outer, panels + 1))
            return 2 * mp.pi * (whole + (high ** (m + 1) - rest / (outer - inner)) / (m + 1))
        square = [low ** 2 / width ** 2, -2 * low / width ** 2, 1 / width ** 2]  # t^2
        factor = [1, 0] if light['falloff'] == 'squared' else [3 + 2 * low / width, -2 / width]  # 1 or 3 - 2 t
        terms = [sum(square[i] * factor[k - i] for i in range(3) if 0 <= k - i < 2) for k in range(4)]
        edge = mp.fsum(term * moment(power, low, high) for power, term in enumerate(terms))
        return 2 * mp.pi * (whole + edge)


def intensity(light):
    """Of a point or spot; along the axis."""
    return mpf(light['power']) / solid_angle(light) if 'power' in light else mpf(light['intensity'])


def sample(light, position):
    """Direction towards the light (unit), irradiance facing it, distance in mm, distance from a cone's edge."""
    if light['type'] == 'distant':
        return scale(unit(vector(light['direction'])), mpf(-1)), mpf(light['irradiance']), mp.inf, mp.inf
    way = subtract(vector(light['position']), position)
    distance = length(way)
    direction = scale(way, 1 / distance)
    cosine = -dot(axis_of(light), direction)
    factor, edge = (pattern if light['type'] == 'point' else cone)(light, cosine)
    return direction, intensity(light) * factor * attenuation(light, distance), distance, edge


def is_behind(surface, element, direction, distance):
    """Whether the surface that a free element lies on hides what is on the other side than the element looks to."""
    outward = normal_at(surface, element.position)
    cosine = dot(outward, element.normal)
    if surface['type'] == 'rectangle':
        if abs(cosine) >= 1 - mpf('5e-7'):
            return False
        return dot(outward, direction) * (-1 if cosine < 0 else 1) < 0
    if cosine >= 1 - mpf('5e-7'):
        return False
    if cosine >= 0:
        return dot(outward, direction) < 0
    if distance == mp.inf:
        return True
    source = add(element.position, scale(direction, distance))
    return length(subtract(source, vector(surface['center']))) > mpf(surface['radius'])


def is_blocked(scene, element, direction, distance):
    """Whether a surface stands between the element and the source."""
    surfaces = scene['surfaces']
    if scene['shadows'] == 'none':
        return False
    for index, surface in enumerate(surfaces):
        if index == element.own and element.is_free and is_behind(surface, element, direction, distance):
            return True
        if index != element.own:
            if surface['type'] == 'rectangle':
                crossing = plate_crossing(element.position, direction, surface)
                crossings = [crossing[0]] if crossing else []
            else:
                crossings = sphere_crossings(element.position, direction, surface)
            if any(0 < t < distance for t in crossings):
                return True
    return False


# What the material makes of it.

def lobe(material, normal, light, view):
    """S: the cosine that the highlight is a power of."""
    if material['model'] == 'lambert':
        return mpf(0)
    if material['model'] == 'phong':
        mirrored = subtract(scale(normal, 2 * dot(normal, light)), light)
        return max(mpf(0), dot(mirrored, view))
    between = add(light, view)
    size = length(between)
    return max(mpf(0), dot(normal, between) / size) if size > TIE else mpf(0)


def normalization(material):
    """c."""
    n = mpf(material['shininess'])
    if not material['normalized']:
        return mpf(1)
    if material['model'] == 'phong':
        return (n + 2) / 2
    return (n + 2) * (n + 4) / (8 * (n + mpf(2) ** (-n / 2)))


def share(scene, element, light, highlights=True):
    """What one light gives to the element."""
    material = element.material
    p = 1 / mp.pi if material['over_pi'] else mpf(1)
    if light['type'] == 'ambient':
        irradiance = mpf(light['irradiance'])
        return Share(irradiance, p * mpf(material['ambient']) * irradiance, mpf(0), mpf(1), mpf(1), mp.inf)

    if light['type'] in ('planar', 'volume'):
        return extended_share(element, light, p, highlights)

    direction, facing, distance, edge = sample(light, element.position)
    if is_blocked(scene, element, direction, distance):
        facing = mpf(0)
    return point_share(element, p, direction, facing, edge)


def point_share(element, p, direction, facing, edge):
    material = element.material
    cosine = dot(element.normal, direction)
    s = lobe(material, element.normal, direction, element.view)
    received = max(mpf(0), cosine)
    weight = {'plain': mpf(1), 'gated': mpf(1 if cosine > TIE else 0), 'cosine': received}[material['highlight']]
    if material['model'] == 'lambert':
        weight = mpf(0)
    highlight = weight * power(s, mpf(material['shininess'])) if facing * weight > 0 else mpf(0)
    return Share(facing * received, facing * p * mpf(material['diffuse']) * received,
                 facing * p * mpf(material['specular']) * normalization(material) * highlight, cosine, s, edge)


def extended_share(element, light, p, highlights):
    """What a planar or volume source gives.  It casts no shadow, so only the element counts."""
    source = extended.source_of(light)
    if light['parts'] != 'converged':
        return parts_share(element, light, source, p)
    material = element.material
    position, normal = element.position, element.normal
    exponent = mpf(material['shininess'])
    received = glossy = received_doubt = glossy_doubt = mpf(0)
    for shape in source.shapes:
        if source.attenuation == 'inverse-square':
            part = cubature.irradiance(shape, position, normal)
        else:
            part = cubature.integral(shape, position, 'diffuse', 'plain', 1, normal, normal, source.attenuation,
                                     source.k)
        received, received_doubt = received + part.value, received_doubt + part.certainty
        if highlights and material['model'] != 'lambert' and material['specular'] > 0:
            kind = 'mirror' if material['model'] == 'phong' else 'half'
            part = cubature.integral(shape, position, kind, material['highlight'], exponent, normal, element.view,
                                     source.attenuation, source.k)
            glossy, glossy_doubt = glossy + part.value, glossy_doubt + part.certainty
    diffuse = source.radiance * p * mpf(material['diffuse'])
    specular = source.radiance * p * mpf(material['specular']) * normalization(material)
    return Share(source.radiance * received, diffuse * received, specular * glossy, None, None, mp.inf,
                 source.radiance * received_doubt, diffuse * received_doubt + specular * glossy_doubt)


def parts_share(element, light, source, p):
    """The sum over the points that stand for the parts, each with its share of the intensity."""
    shares = []
    for shape in source.shapes:
        for part in extended.parts_of(shape, light['parts']):
            way = subtract(part.position, element.position)
            distance = length(way)
            direction = scale(way, 1 / distance)
            intensity = source.radiance * part.area / 10 ** 6
            facing = intensity * max(mpf(0), -dot(part.normal, direction)) * attenuation(light, distance)
            shares.append(point_share(element, p, direction, facing, mp.inf))
    sums = [mp.fsum(share[i] for share in shares) for i in range(3)]
    return Share(*sums, None, None, mp.inf)


def answer(scene, element, highlights=True):
    """Without highlights of extended sources, which take time, where only the irradiance is asked for."""
    shares = [share(scene, element, light, highlights) for light in scene['lights']]
    return Answer(element, shares, mp.fsum(part.diffuse + part.specular for part in shares),
                  mp.fsum(part.irradiance for part in shares), mp.fsum(part.doubt for part in shares),
                  mp.fsum(part.irradiance_doubt for part in shares))


def on_source(scene, element):
    """Whether a planar or volume source lies on the element, so that there is no value."""
    return any(extended.touches(shape, element.position) for light in scene['lights']
               if light['type'] in ('planar', 'volume') and light['parts'] == 'converged'
               for shape in extended.source_of(light).shapes)


# The questions that tests ask; `scene` is as the user wrote it.

def probe_screen(scene, x, y, highlights=True):
    """Answer for what is seen through (x, y), or None off every surface or on a source."""
    scene = completed(scene)
    element = seen_element(scene, x, y)
    return answer(scene, element, highlights) if element and not on_source(scene, element) else None


def probe_element(scene, numbers, highlights=True):
    """Answer for the free element x, y, z, nx, ny, nz, or None on a source."""
    scene = completed(scene)
    element = free_element(scene, numbers)
    return None if on_source(scene, element) else answer(scene, element, highlights)


def pixel_of(scene, x, y):
    """[column, row] of the pixel that the screen point falls in, None off the screen; in exact fractions."""
    screen = completed(scene)['screen']
    width, height = Fraction(screen['width']), Fraction(screen['height'])
    across, down = (Fraction(x) + width / 2) / width, (height / 2 - Fraction(y)) / height
    if not (0 <= across <= 1 and 0 <= down <= 1):
        return None
    pixel = []
    for place, count in zip((across, down), screen['resolution']):
        if screen['sampling'] == 'nodes':
            pixel.append(int(place * (count - 1) + Fraction(1, 2)))
        else:
            pixel.append(min(int(place * count), count - 1))
    return pixel


def sample_of(scene, column, row):
    """The screen point x, y that the pixel shows."""
    screen = completed(scene)['screen']
    place = []
    for index, count, size in zip((column, row), screen['resolution'], (screen['width'], screen['height'])):
        if screen['sampling'] == 'nodes':
            place.append(-mpf(size) / 2 + index * mpf(size) / (count - 1))
        else:
            place.append(-mpf(size) / 2 + (index + mpf('0.5')) * mpf(size) / count)
    return place[0], -place[1]


def unit_of(scene, quantity):
    """The unit that results are printed in; None where the description leaves it open."""
    scene = completed(scene)
    photometric = scene['units'] == 'photometric'
    laws = {light.get('attenuation', light['type']) for light in scene['lights']}
    over_pi = {surface['material']['over_pi'] for surface in scene['surfaces']}
    if laws & {'practical', 'polynomial'} or {'none', 'inverse-square'} <= laws:
        return 'relative'
    if quantity == 'irradiance' and 'none' in laws:
        return 'relative'
    if quantity == 'brightness' and len(over_pi) > 1 or not laws:
        return None
    if laws == {'none'}:
        return ('cd' if photometric else 'W/sr') if over_pi == {False} else None
    if 'none' in laws:
        return None
    if quantity == 'irradiance' or over_pi == {False}:
        return 'lx' if photometric else 'W/m²'
    return 'cd/m²' if photometric else 'W/(sr·m²)'
