# SPDX-License-Identifier: MIT
"""Random scenes with planar and volumetric sources, generic and nasty, the same for the same seed.

As scenes.py, whose stages, materials and small helpers it uses.  Every kind has one difficulty that the others lack;
KINDS lists them.
"""
import math

import scenes
from scenes import Case, Place, _add, _beside, _direction, _dot, _log_uniform, _unit, coefficients


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _turned_frame(rng, axis):
    first = _beside(rng, axis)
    return first, _cross(axis, first)


# Outlines and bodies of about a size (half of it in every direction) around a center.

def _rectangle(rng, center, size, axis, ratio=None):
    ratio = ratio or _log_uniform(rng, 0.2, 1)
    result = {'center': center, 'size': rng.choice([[size, size * ratio], [size * ratio, size]])}
    stretch = _log_uniform(rng, 0.01, 100)
    if rng.random() < 0.3:
        result['aim'] = _add(center, axis, size * stretch)
    else:
        result['axis'] = [x * stretch for x in axis]
    if rng.random() < 0.6:
        result['up'] = _add(_beside(rng, axis), axis, rng.uniform(-2, 2))
    return {'rectangle': result}


def _disk(rng, center, size, axis, ratio=None):
    stretch = _log_uniform(rng, 0.01, 100)
    return {'disk': {'center': center, 'radius': size / 2, 'axis': [x * stretch for x in axis]}}


def _outline(rng, center, size, axis, radii, flat=1.0):
    """A polygon that is star-shaped about the center, counter-clockwise about the axis."""
    first, second = _turned_frame(rng, axis)
    count = len(radii)
    start = rng.uniform(0, 7)
    corners = []
    for i, radius in enumerate(radii):
        turn = start + 2 * math.pi * (i + rng.uniform(-0.3, 0.3)) / count
        corners.append(_add(_add(center, first, size / 2 * radius * math.cos(turn)), second,
                            size / 2 * radius * flat * math.sin(turn)))
    return {'vertices': corners}


def _convex(rng, center, size, axis, ratio=None):
    return _outline(rng, center, size, axis, [1] * rng.randint(3, 7), ratio or _log_uniform(rng, 0.2, 1))


def _star(rng, center, size, axis, ratio=None):
    count = rng.randint(2, 5)
    return _outline(rng, center, size, axis, [1, rng.uniform(0.15, 0.6)] * count, ratio or _log_uniform(rng, 0.3, 1))


def _box(rng, center, size, axis, ratio=None):
    return {'box': {'center': center, 'size': [size * rng.uniform(0.3, 1) for _ in range(3)]}}


def _ball(rng, center, size, axis, ratio=None):
    return {'sphere': {'center': center, 'radius': size / 2}}


def _cylinder(rng, center, size, axis, ratio=None):
    body = {'center': center, 'radius': size / 2 * rng.uniform(0.2, 1), 'height': size * rng.uniform(0.2, 1.5)}
    if rng.random() < 0.8:
        body['axis'] = [x * 3 for x in _direction(rng)]
    return {'cylinder': body}


def _globe(rng, center, size, axis, ratio=None):
    return {'sphere': {'center': center, 'radius': size / 2, 'facets': rng.randint(4, 9)}}


def _prism(rng, center, size, axis, ratio=None):
    light = _cylinder(rng, center, size, axis)
    light['cylinder']['facets'] = rng.randint(3, 7)
    return light


def _solid(rng, center, size, axis, ratio=None):
    """A tetrahedron or a cut octahedron with corners in general position, as a mesh."""
    if rng.random() < 0.5:
        corners = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
        faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
    else:
        corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
        faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    corners = [_add(center, [x * rng.uniform(0.3, 1) for x in corner], size / 2) for corner in corners]
    return {'solid': {'corners': corners, 'faces': faces}}


PLANAR = (_rectangle, _disk, _convex, _star)
BODIES = (_box, _ball, _cylinder, _globe, _prism, _solid)


def _source(rng, make, center, size, axis, laws=True, ratio=None):
    light = {'type': 'planar' if make in PLANAR else 'volume', **make(rng, center, size, axis, ratio)}
    strengths = ['radiance', 'power'] + (['intensity'] if make in PLANAR else [])
    light[rng.choice(strengths)] = _log_uniform(rng, 0.01, 10000)
    if make in PLANAR and rng.random() < 0.25:
        light['sides'] = 'both'
    if laws:
        light.update(scenes._laws(rng) if rng.random() < 0.5 else {})
    return light


def _around(rng, place, distance, size, makes, spread=1.0, **options):
    """A source in the half space above a place, its lit side more or less towards it."""
    direction = _unit(_add(_direction(rng), place.normal, rng.uniform(0.3, 1.5)))
    center = _add(place.position, direction, distance)
    axis = _unit(_add(_direction(rng), direction, -rng.uniform(1.1, 2.5) / spread))
    return _source(rng, rng.choice(makes), center, size, axis, **options)


# The kinds.

def _on_sphere(rng, makes, **stage):
    scene = scenes._stage(rng, **stage)
    sphere = scene['surfaces'][0]
    places = [scenes._visible_place(rng, scene) for _ in range(3)]
    size = sphere['radius'] * _log_uniform(rng, 0.05, 5)
    distance = size * rng.uniform(0.2, 3) + sphere['radius'] * _log_uniform(rng, 0.1, 5)
    scene['lights'].append(_around(rng, places[0], distance, size, makes))
    # The one that the light was made for, and the one that is turned most like it.
    nearest = max(places[1:], key=lambda place: _dot(place.normal, places[0].normal))
    return scenes._with_places(scene, [places[0], nearest])


def _planar(rng):
    """Every outline over a sphere, near and not so near, cut by the horizons of the places or not."""
    return _on_sphere(rng, PLANAR)


def _volume(rng):
    return _on_sphere(rng, BODIES)


def _element(rng, center, distance, towards=None):
    """A free element at a distance from a center, its horizon anywhere."""
    direction = towards or _direction(rng)
    normal = _unit(_add(_direction(rng), direction, -rng.uniform(0, 1.5)))
    stretch = _log_uniform(rng, 1e-2, 1e2)
    return _add(center, direction, distance) + [x * stretch for x in normal]


def _free(rng, makes, near, far, ratio=None, shininess=None, laws=True, count=3, size=None):
    """Free elements on the lit side of one source, between two distances in parts of its size."""
    scene = scenes._stage(rng, shininess=shininess)
    size = size or scene['surfaces'][0]['radius'] * _log_uniform(rng, 0.1, 10)
    center = [rng.uniform(-1, 1) * size, rng.uniform(-1, 1) * size, rng.uniform(-3, 3) * size]
    axis = _direction(rng)
    scene['lights'] = [_source(rng, rng.choice(makes), center, size, axis, laws=laws, ratio=ratio)]
    elements = []
    for _ in range(count):
        towards = _unit(_add(_direction(rng), axis, rng.uniform(0.3, 1.2)))
        elements.append(_element(rng, center, size * _log_uniform(rng, near, far), towards))
    return Case(scene, [], elements)


def _elements(rng):
    return _free(rng, PLANAR + BODIES, 0.8, 10)


def _tiny(rng):
    """Sources up to a million times smaller than their distance."""
    return _free(rng, PLANAR + BODIES, 1e2, 1e6)


def _huge(rng):
    """Sources up to a million times larger than their distance."""
    case = _free(rng, PLANAR[:3], 1, 2, laws=rng.random() < 0.3)
    return _close(rng, case, 1e-6, 1e-2)


def _touching(rng):
    """Elements close to the source's surface."""
    return _close(rng, _free(rng, PLANAR, 1, 2), 1e-4, 0.1)


def _close(rng, case, low, high):
    """Moves the elements to just above the middle of a flat source."""
    light = case.scene['lights'][0]
    if 'vertices' in light:
        corners = light['vertices']
        center = [sum(column) / len(corners) for column in zip(*corners)]
        size = math.dist(center, corners[0])
        axis = _unit(_cross(_add(corners[1], corners[0], -1), _add(corners[2], corners[0], -1)))
        newell = [0.0, 0.0, 0.0]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            newell = _add(newell, _cross(_add(a, center, -1), _add(b, center, -1)))
        axis = _unit(newell)
    else:
        shape = light.get('rectangle') or light['disk']
        center, size = shape['center'], min(shape.get('size', [shape.get('radius')])) / 2
        axis = _unit(_add(shape['aim'], center, -1) if 'aim' in shape else shape['axis'])
    elements = []
    for _ in case.elements:
        aside = _add(center, _beside(rng, axis), size * rng.uniform(0, 2))
        normal = _unit(_add(_direction(rng), axis, -rng.uniform(0, 1.5)))
        elements.append(_add(aside, axis, size * _log_uniform(rng, low, high)) + normal)
    return Case(case.scene, [], elements)


def _needle(rng):
    """1 by 0.0001 at a distance of a thousand, and others like it."""
    return _free(rng, (_rectangle, _convex), 1, 1e3, ratio=_log_uniform(rng, 1e-7, 1e-3))


def _horizon(rng):
    """The horizon leaves little of the source, or takes little."""
    case = _free(rng, PLANAR + BODIES, 1, 20)
    light = case.scene['lights'][0]
    target = _middle(light)
    elements = []
    for element in case.elements:
        towards = _unit(_add(target, element[:3], -1))
        reach = _log_uniform(rng, 1e-3, 0.5) * rng.choice([1, 1, -1])
        elements.append(element[:3] + _unit(_add(_beside(rng, towards), towards, reach)))
    return Case(case.scene, [], elements)


def _middle(light):
    if 'vertices' in light or 'solid' in light:
        corners = light['vertices'] if 'vertices' in light else light['solid']['corners']
        return [sum(column) / len(corners) for column in zip(*corners)]
    return next(light[key] for key in ('rectangle', 'disk', 'box', 'sphere', 'cylinder') if key in light)['center']


def _exponents(rng):
    """Lobes from almost none to needles, some of them aimed at the source."""
    case = _free(rng, PLANAR + BODIES, 0.7, 30, shininess=_log_uniform(rng, 0.001, 10000))
    case.scene['surfaces'][0]['material'].update(model=rng.choice(['blinn-phong', 'phong']))
    target = _middle(case.scene['lights'][0])
    eye = [0, 0, case.scene['observer']['z']]
    elements = []
    for element in case.elements:
        light, view = (_unit(_add(place, element[:3], -1)) for place in (target, eye))
        between = _add(light, view)
        if rng.random() < 0.6 and _dot(between, between) > 1e-3:
            element = element[:3] + _unit(_add(_unit(between), _direction(rng), _log_uniform(rng, 1e-3, 0.3)))
        elements.append(element)
    return Case(case.scene, [], elements)


def _averted(rng):
    """The observer is below the element's horizon, or on it."""
    case = _free(rng, PLANAR + BODIES, 0.8, 10)
    case.scene['surfaces'][0]['material'].update(highlight=rng.choice(['plain', 'plain', 'gated', 'cosine']),
                                                 model=rng.choice(['blinn-phong', 'phong']))
    eye, target = [0, 0, case.scene['observer']['z']], _middle(case.scene['lights'][0])
    elements = []
    for element in case.elements:
        view, light = (_unit(_add(place, element[:3], -1)) for place in (eye, target))
        across = _unit(_add(_direction(rng), light, 1.5))
        across = _unit(_add(across, view, -_dot(across, view)))
        elements.append(element[:3] + _unit(_add(across, view, -rng.choice([0, 1e-3, rng.uniform(0, 0.7)]))))
    return Case(case.scene, [], elements)


def _laws(rng):
    case = _free(rng, PLANAR + BODIES, 0.6, 10)
    law = rng.choice(['none', 'practical', 'polynomial'])
    case.scene['lights'][0].update(attenuation=law, k=_log_uniform(rng, 1, 10000))
    if law == 'polynomial':
        case.scene['lights'][0].update(coefficients=coefficients(rng))
    return case


def _parts(rng):
    """Sources cut into parts; a polygon of another shape than a parallelogram is cut triangle by triangle."""
    case = _free(rng, (_rectangle, _rectangle, _disk, _box, _ball, _cylinder), 1, 10)
    case.scene['lights'][0]['parts'] = rng.choice([1, 1, 2, 3, 4])
    case.scene['shadows'] = 'none'
    return case


def _whole(rng):
    """Whole numbers: elements in the plane of the source, under its edges and corners, horizons along them."""
    case = _free(rng, (_rectangle,), 1, 2)
    scene = case.scene
    axis = rng.choice([[0, 0, -1], [0, 0, 1], [1, 0, 0], [0, -1, 0]])
    size = [rng.randint(1, 4) * 100, rng.randint(1, 4) * 100]
    place = rng.choice([{'rectangle': {'center': [0, 0, 300], 'size': size, 'axis': axis}},
                        {'disk': {'center': [0, 0, 300], 'radius': 100, 'axis': axis}}])
    body = rng.choice([{'box': {'center': [0, 0, 300], 'size': [200, 200, 400]}},
                       {'sphere': {'center': [0, 0, 300], 'radius': 100}},
                       {'cylinder': {'center': [0, 0, 300], 'radius': 100, 'height': 200, 'axis': axis}}])
    scene['lights'] = [rng.choice([{'type': 'planar', **place}, {'type': 'volume', **body}])]
    scene['lights'][0].update(radiance=1, **scenes._laws(rng))
    scene['surfaces'][0].update(center=[0, 0, -2000], radius=100)
    scene['surfaces'][0]['material'].update(shininess=rng.choice([1, 2, 10, 20]), specular=0.5, diffuse=0.5)
    scene['observer']['z'] = 2000
    elements = []
    for _ in range(4):
        position = [rng.choice([-300, -100, 0, 100, 200]) for _ in range(2)] + [rng.choice([0, 0, 100, 700, 1000])]
        normal = rng.choice([[0, 0, 1], [0, 0, 1], [1, 0, 0], [0, 1, 0], [1, 0, 1], [0, -3, 4], [0, 0, -1], [1, 1, 1]])
        elements.append(position + normal)
    return Case(scene, [], elements)


def _many(rng):
    """Several sources of all sorts at once."""
    case = _free(rng, PLANAR, 1, 10)
    for _ in range(2):
        more = _free(rng, PLANAR + BODIES, 1, 10)
        case.scene['lights'] += more.scene['lights']
    place = Place(case.elements[0][:3], _unit(case.elements[0][3:]), 100)
    case.scene['lights'].append(scenes._light(rng, place))
    return case


KINDS = {'planar': _planar, 'volume': _volume, 'free': _elements, 'tiny': _tiny, 'huge': _huge, 'touching': _touching,
         'needle': _needle, 'horizon': _horizon, 'exponents': _exponents, 'averted': _averted, 'laws': _laws,
         'parts': _parts, 'whole': _whole, 'many': _many}


def random_case(rng, kind):
    return KINDS[kind](rng)
