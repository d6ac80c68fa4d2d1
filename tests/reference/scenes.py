# SPDX-License-Identifier: MIT
"""Random scenes, generic and nasty, the same for the same seed.

random_case(rng, kind) makes a scene with places worth asking at: screen points that show its surfaces, and free
elements.  KINDS lists what there is; each kind has one difficulty that the others lack.
"""
import math
from collections import namedtuple

# A scene as the user would write it (a dict), screen points x, y, free elements x, y, z, nx, ny, nz.
Case = namedtuple('Case', 'scene points elements')
# A place on a surface that lights are put around.
Place = namedtuple('Place', 'position normal radius')

# Small, odd, and long enough at times for rows of several blocks.
RESOLUTIONS = [(61, 47)] * 4 + [(47, 61), (131, 9), (261, 5), (7, 131)]


# Small vector helpers in plain floats: scenes need no accuracy, only their numbers as they come out.

def _add(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _unit(a):
    size = math.sqrt(_dot(a, a))
    return [x / size for x in a]


def _direction(rng):
    return _unit([rng.gauss(0, 1) for _ in range(3)])


def _beside(rng, normal):
    """A random unit vector at right angles to normal."""
    other = _direction(rng)
    return _unit(_add(other, normal, -_dot(other, normal)))


def _log_uniform(rng, low, high):
    return 10 ** rng.uniform(math.log10(low), math.log10(high))


# Materials, surfaces, screens.

def material(rng, shininess=None):
    return {
        'model': rng.choice(['blinn-phong', 'blinn-phong', 'phong', 'lambert']),
        'diffuse': 0 if rng.random() < 0.15 else rng.uniform(0, 1),
        'specular': rng.uniform(0, 1),
        'shininess': shininess if shininess else rng.choice([1, 2, 20, rng.uniform(0.5, 60)]),
        'ambient': rng.uniform(0, 1),
        'over_pi': rng.random() < 0.5,
        'highlight': rng.choice(['plain', 'gated', 'cosine']),
        'normalized': rng.random() < 0.5,
    }


def _stage(rng, shininess=None, spheres=1, projection=None):
    """A scene without lights: spheres, an observer in front of them, a screen that shows the first one."""
    radius = _log_uniform(rng, 30, 600)
    center = [rng.uniform(-0.5, 0.5) * radius, rng.uniform(-0.5, 0.5) * radius, rng.uniform(-2, 5) * radius]
    surfaces = [{'type': 'sphere', 'center': center, 'radius': radius, 'material': material(rng, shininess)}]
    for _ in range(spheres - 1):
        away = _add(center, _direction(rng), radius * rng.uniform(0.9, 2.5))
        surfaces.append({'type': 'sphere', 'center': away, 'radius': radius * rng.uniform(0.1, 0.8),
                         'material': material(rng, shininess)})
    front = max(surface['center'][2] + surface['radius'] for surface in surfaces)
    projection = projection or rng.choice(['orthographic', 'perspective'])
    observer = max(front, 0) + radius * _log_uniform(rng, 0.3, 30)
    magnified = observer / (observer - center[2]) if projection == 'perspective' else 1
    resolution = rng.choice(RESOLUTIONS)
    pitch = 2 * radius * magnified * rng.uniform(0.8, 1.6) / sorted(resolution)[0 if min(resolution) > 40 else 1]
    return {
        'luxel': 1,
        'shadows': rng.choice(['points', 'points', 'none']),
        'screen': {'width': pitch * resolution[0], 'height': pitch * resolution[1], 'resolution': list(resolution),
                   'sampling': rng.choice(['nodes', 'centers'])},
        'observer': {'z': observer, 'projection': projection, 'view': rng.choice(['parallel', 'observer'])},
        'surfaces': surfaces,
        'lights': [],
    }


def _visible_place(rng, scene, index=0, facing=(0.1, 1.0)):
    """A random place on the front of a sphere, its normal at a cosine within `facing` to the view."""
    sphere = scene['surfaces'][index]
    center, radius, eye = sphere['center'], sphere['radius'], [0, 0, scene['observer']['z']]
    cosine = rng.uniform(*facing)
    if scene['observer']['projection'] == 'perspective':
        towards = _add(eye, center, -1)
        away = math.sqrt(_dot(towards, towards))
        # The law of sines in the triangle of eye, center and element gives the element's angle at the center.
        sine = math.sqrt(1 - cosine * cosine) * radius / away
        polar = math.acos(cosine) - math.asin(sine)
    else:
        towards, polar = [0, 0, 1], math.acos(cosine)
    towards = _unit(towards)
    normal = _add([x * math.cos(polar) for x in towards], _beside(rng, towards), math.sin(polar))
    return Place(_add(center, normal, radius), normal, radius)


def screen_point(scene, position):
    """Where on the screen a position is seen."""
    x, y, z = position
    eye = scene['observer']['z']
    factor = eye / (eye - z) if scene['observer']['projection'] == 'perspective' else 1
    return [x * factor, y * factor]


# Lights.

def _laws(rng):
    law = rng.choice(['none', 'inverse-square', 'practical', 'polynomial'])
    if law == 'polynomial':
        return {'attenuation': law, 'coefficients': coefficients(rng)}
    return {'attenuation': law, **({'k': _log_uniform(rng, 5, 3000)} if law == 'practical' else {})}


def coefficients(rng):
    """Those of the polynomial law: each may be 0, but not all of them."""
    numbers = [rng.choice([0, 1, _log_uniform(rng, 1e-3, 10)]) for _ in range(3)]
    return numbers if any(numbers) else [0.5, 0.2, 0.1]


def _aimed(rng, position, target, spread):
    target = _add(target, _direction(rng), spread)
    if rng.random() < 0.5:
        return {'aim': target}
    size = _log_uniform(rng, 1e-3, 10)
    return {'axis': [size * x for x in _add(target, position, -1)]}


def _intensity(rng):
    return _log_uniform(rng, 0.01, 10000)


def _strength(rng):
    return {rng.choice(['intensity', 'intensity', 'power']): _intensity(rng)}


def _point(rng, position, target, spread):
    pattern = rng.choice(['isotropic', 'lambertian', 'cosine'])
    light = {'type': 'point', 'position': position, **_strength(rng), 'pattern': pattern, **_laws(rng)}
    if pattern == 'cosine':
        light['exponent'] = rng.choice([0, 0.5, 3, rng.uniform(0, 20)])
    if pattern != 'isotropic':
        light.update(_aimed(rng, position, target, spread))
    return light


def _spot(rng, position, target, spread, angles=None):
    inner, outer = angles or sorted([rng.uniform(0, 60), rng.uniform(10, 90)])
    return {'type': 'spot', 'position': position, **_strength(rng), 'inner': inner, 'outer': outer,
            'falloff': rng.choice(['smoothstep', 'squared', 'linear', 'hard']),
            'exponent': rng.choice([0, 1, rng.uniform(0, 20)]), **_laws(rng), **_aimed(rng, position, target, spread)}


def _light(rng, place, direction=None, distance=None):
    """Any light that is meant for the place, seen from it in a direction, at a distance."""
    direction = direction or _unit(_add(_direction(rng), place.normal, rng.uniform(0.2, 1.5)))
    distance = distance or place.radius * _log_uniform(rng, 0.3, 30)
    position = _add(place.position, direction, distance)
    spread = min(place.radius, distance) * 0.3
    kind = rng.choice(['point'] * 5 + ['spot'] * 4 + ['distant'] * 2 + ['ambient'])
    if kind == 'point':
        return _point(rng, position, place.position, spread)
    if kind == 'spot':
        return _spot(rng, position, place.position, spread)
    if kind == 'ambient':
        return {'type': 'ambient', 'irradiance': _log_uniform(rng, 0.01, 10)}
    return {'type': 'distant', 'direction': [-x for x in direction], 'irradiance': _log_uniform(rng, 0.01, 1000)}


def _tilted(place, tangent, height):
    """The direction along the surface at a place, raised to the cosine `height` to its normal."""
    return _unit(_add(tangent, place.normal, height))


# The kinds.

def _with_places(scene, places, elements=()):
    return Case(scene, [screen_point(scene, place.position) for place in places], list(elements))


def _generic(rng, **stage):
    scene = _stage(rng, **stage)
    places = [_visible_place(rng, scene) for _ in range(6)]
    scene['lights'] = [_light(rng, rng.choice(places)) for _ in range(rng.randint(1, 4))]
    return _with_places(scene, places)


def _orthographic(rng):
    return _generic(rng, projection='orthographic')


def _perspective(rng):
    return _generic(rng, projection='perspective')


def _shininess(rng):
    """Highlights from very wide to needles, with places in their peak."""
    scene = _stage(rng, shininess=_log_uniform(rng, 0.1, 10000), projection='orthographic')
    scene['observer']['view'] = 'parallel'
    places = [_visible_place(rng, scene, facing=(0.72, 1.0)) for _ in range(3)]
    for place in places:
        nx, ny, nz = place.normal
        mirror = _unit([2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1])
        scene['lights'].append(_light(rng, place, mirror, place.radius * _log_uniform(rng, 0.5, 100)))
    places += [_visible_place(rng, scene) for _ in range(3)]
    return _with_places(scene, places)


def _cones(rng):
    """Cones of any width, needles and half spaces among them."""
    scene = _stage(rng)
    places = [_visible_place(rng, scene) for _ in range(3)]
    for place in places:
        distance = place.radius * _log_uniform(rng, 0.3, 30)
        position = _add(place.position, _tilted(place, _beside(rng, place.normal), rng.uniform(0.2, 3)), distance)
        outer = rng.choice([90, _log_uniform(rng, 0.001, 90)])
        inner = outer * rng.choice([0, 1, rng.random(), 1 - _log_uniform(rng, 1e-6, 0.1)])
        spread = distance * math.tan(math.radians(min(outer, 45))) * rng.uniform(0, 1.2)
        scene['lights'].append(_spot(rng, position, place.position, spread, (inner, outer)))
    return _with_places(scene, places + [_visible_place(rng, scene)])


def _shadows(rng):
    """Several spheres, in one another's shadow."""
    scene = _stage(rng, spheres=rng.randint(2, 5))
    places = [_visible_place(rng, scene, rng.randrange(len(scene['surfaces']))) for _ in range(8)]
    scene['lights'] = [_light(rng, rng.choice(places)) for _ in range(rng.randint(1, 4))]
    return _with_places(scene, places)


def _free_spot(rng, center, radius):
    """A place anywhere around a sphere, or on it with its normal, about that, or any."""
    direction = _direction(rng)
    if rng.random() < 0.6:
        return Place(_add(center, direction, radius * rng.uniform(0, 4)), _direction(rng), radius)
    normal = rng.choice([direction, _direction(rng), _add(direction, _direction(rng), 0.3),
                         [-number for number in direction]])
    return Place(_add(center, direction, radius), normal, radius)


def _elements(rng):
    """Free elements around several spheres or one."""
    scene = _stage(rng, spheres=rng.randint(1, 3))
    radius = scene['surfaces'][0]['radius']
    center = scene['surfaces'][0]['center']
    spots = [_free_spot(rng, center, radius) for _ in range(6)]
    scene['lights'] = [_light(rng, rng.choice(spots)) for _ in range(rng.randint(1, 4))]
    length = _log_uniform(rng, 1e-3, 1e3)
    return Case(scene, [], [spot.position + [x * length for x in spot.normal] for spot in spots])


def _grazing(rng):
    """Light that comes along the surface, from a little above its horizon or below."""
    scene = _stage(rng)
    places = [_visible_place(rng, scene, facing=(0.05, 0.95)) for _ in range(4)]
    for place in places:
        height = rng.choice([1, 1, -1]) * _log_uniform(rng, 1e-9, 0.1)
        scene['lights'].append(_light(rng, place, _tilted(place, _beside(rng, place.normal), height)))
    return _with_places(scene, places)


def _limb(rng):
    """Places at the edge of what is seen of a sphere."""
    scene = _stage(rng)
    places = []
    for _ in range(6):
        cosine = _log_uniform(rng, 1e-5, 0.1)
        places.append(_visible_place(rng, scene, facing=(cosine, cosine)))
    scene['lights'] = [_light(rng, rng.choice(places)) for _ in range(rng.randint(1, 3))]
    return _with_places(scene, places)


def _near(rng):
    """Lights that almost touch the surface."""
    scene = _stage(rng)
    places = []
    for _ in range(2):
        place = _visible_place(rng, scene)
        height = _log_uniform(rng, 0.01, 10)
        direction = _tilted(place, _beside(rng, place.normal), rng.uniform(0.3, 30))
        scene['lights'].append(_point(rng, _add(place.position, direction, height), place.position, height * 0.3))
        for _ in range(3):
            aside = _add(place.position, _beside(rng, place.normal), height * rng.uniform(0, 3))
            places.append(Place(aside, place.normal, place.radius))
    return _with_places(scene, places)


def _touching(rng):
    """A light a hundredth of a millimetre above the place that one of the picture's own samples shows."""
    scene = _stage(rng, projection='orthographic')
    scene['screen']['sampling'] = 'centers'
    sphere, screen = scene['surfaces'][0], scene['screen']
    # The sample nearest to a place near the middle of the sphere.
    point = [sphere['center'][i] + sphere['radius'] * rng.uniform(-0.4, 0.4) for i in (0, 1)]
    for i, size in enumerate((screen['width'], screen['height'])):
        pitch = size / screen['resolution'][i]
        index = min(max(round((point[i] + size / 2) / pitch - 0.5), 0), screen['resolution'][i] - 1)
        point[i] = (index + 0.5) * pitch - size / 2
    beside = [(x - c) / sphere['radius'] for x, c in zip(point, sphere['center'])]
    if _dot(beside, beside) > 0.9:
        return _touching(rng)
    normal = [*beside, math.sqrt(1 - _dot(beside, beside))]
    place = Place(_add(sphere['center'], normal, sphere['radius']), normal, sphere['radius'])
    direction = _tilted(place, _beside(rng, normal), rng.uniform(0.5, 5))
    scene['lights'] = [_point(rng, _add(place.position, direction, 0.01), place.position, 0.003)]
    return _with_places(scene, [place])


def _vanishing(rng):
    """Highlights far from their peak, beyond what float64 can tell from darkness."""
    case = _generic(rng, shininess=_log_uniform(rng, 300, 10000))
    case.scene['surfaces'][0]['material'].update(model=rng.choice(['blinn-phong', 'phong']), diffuse=0)
    return case


def _far(rng):
    """Lights at up to 10 km."""
    scene = _stage(rng)
    places = [_visible_place(rng, scene) for _ in range(4)]
    scene['lights'] = [_light(rng, place, distance=_log_uniform(rng, 1e5, 1e7)) for place in places[:3]]
    return _with_places(scene, places)


def _behind(rng):
    """Lights behind the sphere and inside it: only highlights that ask no leave reach the eye."""
    scene = _stage(rng)
    scene['surfaces'][0]['material'].update(highlight=rng.choice(['plain', 'plain', 'gated']))
    places = [_visible_place(rng, scene) for _ in range(5)]
    for place in places[:3]:
        inwards = [-x for x in place.normal]
        direction = _unit(_add(_direction(rng), inwards, rng.uniform(0.5, 2)))
        scene['lights'].append(_light(rng, place, direction, place.radius * _log_uniform(rng, 0.05, 10)))
    return _with_places(scene, places)


def _rim(rng):
    """The picture's own samples at the edge of the sphere: the first and last column of the middle row."""
    scene = _stage(rng, projection='orthographic')
    sphere, screen = scene['surfaces'][0], scene['screen']
    sphere['center'][:2] = [0, 0]
    screen['sampling'] = 'nodes'
    screen['width'] = 2 * sphere['radius'] * (1 - _log_uniform(rng, 1e-8, 1e-2))
    screen['height'] = screen['width'] / screen['resolution'][0] * screen['resolution'][1]
    scene['lights'] = [_light(rng, _visible_place(rng, scene)) for _ in range(rng.randint(1, 3))]
    half = screen['width'] / 2
    return Case(scene, [[half, 0], [-half, 0], [half * 0.99, half * 0.1]], [])


def _whole(rng):
    """Whole numbers and round angles: exact ties, right angles, sources straight above, below and inside."""
    def place(low, high):
        return [rng.randint(low, high) * rng.choice([0, 1, 1, 10]) for _ in range(3)]

    def axis():
        return rng.choice([[0, 0, -1], [0, 0, 2], [1, 0, -1], [-3, 0, -4], [0, -1, 0], [1, 1, -1]])

    case = _generic(rng)
    scene, sphere = case.scene, case.scene['surfaces'][0]
    sphere.update(center=[rng.randint(-2, 2), rng.randint(-2, 2), rng.randint(-5, 20)], radius=13)
    sphere['material'].update(diffuse=0.5, specular=0.25, shininess=rng.choice([1, 2, 4, 0.5]))
    scene['observer']['z'] = sphere['center'][2] + 13 + rng.choice([1, 10, 100])
    scene['screen'].update(width=60, height=46, resolution=[60, 46])
    if scene['screen']['sampling'] == 'nodes':
        scene['screen'].update(width=61, height=47, resolution=[61, 47])
    scene['lights'] = []
    for _ in range(rng.randint(1, 3)):
        light = {'type': 'point', 'position': place(-12, 12), 'intensity': rng.randint(1, 9), **_laws(rng)}
        if rng.random() < 0.5:
            inner, outer = sorted([rng.choice([0, 30, 45, 60, 90]), rng.choice([30, 45, 60, 90])])
            light.update(type='spot', inner=inner, outer=outer, axis=axis(), exponent=rng.choice([0, 0, 1, 2]),
                         falloff=rng.choice(['smoothstep', 'squared', 'linear', 'hard', 'hard']))
        elif rng.random() < 0.5:
            light.update(pattern='cosine', exponent=rng.choice([0, 1, 2]), axis=axis())
        elif rng.random() < 0.3:
            light = {'type': 'distant', 'direction': axis(), 'irradiance': 2}
        scene['lights'].append(light)
    x, y, _ = sphere['center']
    return Case(scene, [[x + a, y + b] for a, b in ((0, 0), (0, 5), (12, 0), (3, 4), (-4, 12), (-4, -3), (0, -13))], [])


def _sizes(rng):
    """Lengths and intensities some powers of ten away from the usual."""
    return _rescaled(_generic(rng), _log_uniform(rng, 1e-3, 1e3), _log_uniform(rng, 1e-20, 1e20))


def _extremes(rng):
    """Lengths and intensities that only float64 holds."""
    return _rescaled(_generic(rng), _log_uniform(rng, 1e-6, 1e6), _log_uniform(rng, 1e-100, 1e100))


def _rescaled(case, longer, stronger):
    return Case(enlarged(case.scene, longer, stronger), [[x * longer for x in point] for point in case.points], [])


def enlarged(scene, longer, stronger):
    """The scene with all lengths and all strengths of light multiplied."""
    def lengths(mapping, keys):
        return {key: ([x * longer for x in value] if isinstance(value, list) else value * longer)
                if key in keys else value for key, value in mapping.items()}

    lights = [lengths(light, ('position', 'aim', 'k')) for light in scene['lights']]
    for light in lights:
        for key in ('intensity', 'irradiance', 'power'):
            if key in light:
                light[key] *= stronger
    return {**scene, 'screen': lengths(scene['screen'], ('width', 'height')),
            'observer': lengths(scene['observer'], ('z',)),
            'surfaces': [lengths(surface, ('center', 'radius', 'size')) for surface in scene['surfaces']],
            'lights': lights}


def _plate(rng, sphere, behind):
    """A rectangle behind a sphere or beside it, seen from the front."""
    radius = sphere['radius']
    axis = _unit(_add(_direction(rng), [0, 0, 1], rng.uniform(1.2, 5)))
    center = _add(sphere['center'], [*_direction(rng)[:2], 0], radius * rng.uniform(0, 1))
    center[2] -= radius * (rng.uniform(1, 2.5) if behind else 0)
    plate = {'type': 'rectangle', 'center': center, 'size': [radius * rng.uniform(1, 6) for _ in range(2)]}
    if rng.random() < 0.7:
        stretch = _log_uniform(rng, 0.01, 100)
        plate['axis'] = [x * stretch for x in axis]
    if rng.random() < 0.5:
        plate['up'] = _add(_beside(rng, _unit(plate.get('axis', [0, 0, 1]))), axis, rng.random())
    return {**plate, 'material': material(rng)}


def _plate_places(rng, scene, plate, count):
    """Places on a plate, whether seen or hidden behind something."""
    axis = _unit(plate.get('axis', [0, 0, 1]))
    reach = min(plate['size']) / 2
    return [Place(_add(plate['center'], _beside(rng, axis), reach * rng.uniform(0, 0.95)), axis, reach)
            for _ in range(count)]


def _plates(rng):
    """A plate alone, or with a sphere before it or beside it and one in the other's shadow."""
    scene = _stage(rng)
    sphere = scene['surfaces'][0]
    plate = _plate(rng, sphere, rng.random() < 0.7)
    places = _plate_places(rng, scene, plate, 4)
    if rng.random() < 0.3:
        scene['surfaces'] = [plate]
    else:
        scene['surfaces'].insert(rng.choice([0, 1]), plate)
        places += [_visible_place(rng, {**scene, 'surfaces': [sphere]}) for _ in range(3)]
    scene['observer']['z'] += 3 * max(plate['size'])
    axis = _unit(plate.get('axis', [0, 0, 1]))
    if _dot(axis, _add([0, 0, scene['observer']['z']], plate['center'], -1)) <= 0:
        return _plates(rng)
    scene['lights'] = [_light(rng, rng.choice(places)) for _ in range(rng.randint(1, 3))]
    return _with_places(scene, places)


# Kinds whose numbers are well conditioned at most places, and those made to be hard.
GENERIC = {'orthographic': _orthographic, 'perspective': _perspective, 'shininess': _shininess, 'cones': _cones,
           'shadows': _shadows, 'plates': _plates, 'elements': _elements, 'far': _far}
NASTY = {'grazing': _grazing, 'limb': _limb, 'rim': _rim, 'near': _near, 'touching': _touching, 'behind': _behind,
         'vanishing': _vanishing, 'whole': _whole, 'sizes': _sizes, 'extremes': _extremes}
KINDS = {**GENERIC, **NASTY}
# Those that make a picture in float32.
PICTURES = [kind for kind in KINDS if kind not in ('elements', 'extremes')]


def random_case(rng, kind):
    return KINDS[kind](rng)
