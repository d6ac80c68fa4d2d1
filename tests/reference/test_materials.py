# SPDX-License-Identifier: MIT
"""Materials beyond Blinn and Phong against their formulas in NumPy, written with angles as their papers have them.

Random scenes of a ball under point-like lights, pixel by pixel, in both precisions and for any number of threads; a
rectangular lamp as a sum over its parts, and integrals of rough tolerance against fine ones; the directional albedo;
and what is told to people: errors, advice, help and explanations.
"""
import json
import os
import subprocess
import tempfile

import numpy as np

from luxel import arguments, generator
from tap import Tap

SCENES = 4
CENTER, RADIUS = np.array([0.0, 0.0, 1000.0]), 300.0
VIEW = np.array([0.0, 0.0, 1.0])


def dot(a, b):
    return (a * b).sum(-1)


def angle(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), dot(a, b))


def oren_nayar(sigma, n, v, l):
    """D of Oren and Nayar's qualitative model, by its angles."""
    square = np.radians(sigma) ** 2
    a, b = 1 - square / (2 * (square + 0.33)), 0.45 * square / (square + 0.09)
    across_l, across_v = l - dot(n, l)[..., None] * n, v - dot(n, v)[..., None] * n
    lengths = np.linalg.norm(across_l, axis=-1) * np.linalg.norm(across_v, axis=-1)
    cosine = np.divide(dot(across_l, across_v), lengths, out=np.zeros_like(lengths), where=lengths > 0)
    lit, seen = angle(n, l), angle(n, v)
    return a + b * np.maximum(0, cosine) * np.sin(np.maximum(lit, seen)) * np.tan(np.minimum(lit, seen))


def fujii_albedo(roughness, theta):
    sine, cosine = np.sin(theta), np.cos(theta)
    tangent = np.divide(sine * (1 - sine ** 3), cosine, out=np.zeros_like(sine), where=cosine > 1e-7)
    g = sine * (theta - sine * cosine) + 2 / 3 * (tangent - sine)
    return (1 + roughness * g / np.pi) / (1 + (0.5 - 2 / (3 * np.pi)) * roughness)


def eon(roughness, rho, n, v, l):
    """D of EON, as its paper has it: single and multiple scattering, over rho."""
    af = 1 / (1 + (0.5 - 2 / (3 * np.pi)) * roughness)
    mean = af * (1 + (2 / 3 - 28 / (15 * np.pi)) * roughness)
    s = dot(l, v) - dot(n, l) * dot(n, v)
    t = np.where(s > 0, np.maximum(dot(n, l), dot(n, v)), 1)
    single = af * (1 + roughness * s / t)
    rho_multiple = rho ** 2 * mean / (1 - rho * (1 - mean))
    lost = (1 - fujii_albedo(roughness, angle(n, l))) * (1 - fujii_albedo(roughness, angle(n, v)))
    return single + rho_multiple / rho * lost / (1 - mean)


def ggx(alpha, f0, n, v, l):
    """pi D G2 F/(4 N.L N.V), G2 by Smith's lambda."""
    h = l + v
    h = h / np.linalg.norm(h, axis=-1)[..., None]
    tangent = np.tan(angle(n, h))
    cosine = np.cos(angle(n, h))
    d = 1 / (np.pi * alpha ** 2 * cosine ** 4 * (1 + (tangent / alpha) ** 2) ** 2)
    lit, seen = np.tan(angle(n, l)), np.tan(angle(n, v))
    g = 1 / (np.sqrt(1 + (alpha * lit) ** 2) / 2 + np.sqrt(1 + (alpha * seen) ** 2) / 2)
    f = f0 + (1 - f0) * (1 - np.clip(dot(v, h), 0, 1)) ** 5
    return np.pi * d * g * f / (4 * dot(n, l) * dot(n, v))


def blinn(shininess, n, v, l):
    h = l + v
    h = h / np.linalg.norm(h, axis=-1)[..., None]
    return np.maximum(0, dot(n, h)) ** shininess


def reflected(material, n, v, l):
    """Brightness for each unit of E, where the light is above the horizon and seen from above."""
    with np.errstate(divide='ignore', invalid='ignore'):
        lit = dot(n, l)
        rough = {'oren-nayar': lambda: oren_nayar(material['sigma'], n, v, l),
                 'eon': lambda: eon(material['roughness'], material['diffuse'], n, v, l)}
        value = material['diffuse'] * lit * rough.get(material['diffuse_model'], lambda: 1)()
        if material['model'] == 'ggx':
            value = value + material['specular'] * lit * ggx(material['alpha'], material['f0'], n, v, l)
        if material['model'] == 'blinn-phong':
            value = value + material['specular'] * lit * blinn(material['shininess'], n, v, l)
        return np.where((lit > 0) & (dot(n, v) > 0), value, 0) / (np.pi if material['over_pi'] else 1)


def random_material(random, number):
    """Each diffuse model with each highlight in turn."""
    return {'diffuse_model': ('oren-nayar', 'eon', 'lambert')[number % 3],
            'model': ('lambert', 'ggx', 'blinn-phong', 'ggx')[number % 4], 'diffuse': random.uniform(0.05, 1),
            'specular': random.uniform(0.05, 1), 'sigma': random.uniform(0, 90), 'roughness': random.uniform(0, 1),
            'alpha': 10 ** random.uniform(-1.5, 0), 'f0': random.uniform(0, 1), 'highlight': 'cosine',
            'shininess': 10 ** random.uniform(0, 2), 'over_pi': random.random() < 0.5}


def scene_of(material, lights, side=60):
    return {'luxel': 1, 'screen': {'width': 640, 'height': 640, 'resolution': [side, side]}, 'observer': {'z': 1500},
            'surfaces': [{'type': 'sphere', 'center': list(CENTER), 'radius': RADIUS, 'material': material}],
            'lights': lights}


def random_lights(random):
    """A point, a direction and a cone, and light from everywhere."""
    place = [random.uniform(-1500, 1500), random.uniform(-1500, 1500), random.uniform(900, 3000)]
    aim = [random.uniform(-100, 100), random.uniform(-100, 100), 1300]
    return [{'type': 'point', 'position': place, 'intensity': 10},
            {'type': 'distant', 'direction': [random.uniform(-1, 1), random.uniform(-1, 1), -1], 'irradiance': 2},
            {'type': 'spot', 'position': [-400, random.uniform(-300, 300), 2500], 'aim': aim, 'intensity': 5,
             'inner': 10, 'outer': 25, 'falloff': 'squared'},
            {'type': 'ambient', 'irradiance': 0.25}]


def light_of(light, places):
    """L and E of one light."""
    if light['type'] == 'distant':
        way = -np.array(light['direction'], dtype=float)
        return np.broadcast_to(way / np.linalg.norm(way), places.shape), light['irradiance']
    ways = np.array(light['position'], dtype=float) - places
    lengths = np.linalg.norm(ways, axis=-1)
    towards, e = ways / lengths[..., None], light['intensity'] / (lengths / 1000) ** 2
    if light['type'] == 'spot':
        axis = np.array(light['aim'], dtype=float) - np.array(light['position'], dtype=float)
        cosine = dot(-towards, axis / np.linalg.norm(axis))
        inner, outer = np.cos(np.radians(light['inner'])), np.cos(np.radians(light['outer']))
        e = e * np.clip((cosine - outer) / (inner - outer), 0, 1) ** 2
    return towards, e


def truth_of(scene, x, y):
    """Brightness of the ball at places of the screen; NaN off it."""
    material = scene['surfaces'][0]['material']
    square = RADIUS ** 2 - x ** 2 - y ** 2
    places = np.stack([x, y, CENTER[2] + np.sqrt(np.maximum(square, 0))], axis=-1)
    normals = (places - CENTER) / RADIUS
    views = np.broadcast_to(VIEW, normals.shape)
    total = np.zeros(x.shape)
    for light in scene['lights']:
        if light['type'] == 'ambient':
            total = total + material['diffuse'] * light['irradiance'] / (np.pi if material['over_pi'] else 1)
            continue
        towards, e = light_of(light, places)
        total = total + e * reflected(material, normals, views, towards)
    return np.where(square > 0, total, np.nan)


def check_points(tap, luxel, random, count):
    """Pictures and probes under point-like lights."""
    worst, off, missed, threads = {'single': 0.0, 'double': 0.0}, [], [], []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'made.npy')
        for number in range(count * 3):
            scene = scene_of(random_material(random, number), random_lights(random))
            x = (np.arange(60) + 0.5) * 640 / 60 - 320
            truth = truth_of(scene, *np.meshgrid(x, -x))
            for precision in worst:
                pictures = []
                for thread_count in (1, 3):
                    luxel.render(scene, path, options=['--precision', precision, '--threads', str(thread_count)])
                    pictures.append(np.load(path))
                threads += [scene] * (pictures[0].tobytes() != pictures[1].tobytes())
                error = np.nanmax(np.abs(pictures[0] - truth)) / np.nanmax(truth)
                worst[precision] = max(worst[precision], error)
            points = [[random.uniform(-210, 210), random.uniform(-210, 210)] for _ in range(20)]
            expected = truth_of(scene, *np.array(points).T)
            for point, value in zip(luxel.probe(scene, points)['points'], expected):
                off += [scene] * (not abs(point['value'] - value) <= point['error'] + 2e-12 * value)
                missed += [scene] * (not point['error'] <= 1e-9 * value)
    tap.ok(worst['single'] <= 2e-6 and worst['double'] <= 1e-11, 'pictures are what the formulas give', str(worst))
    tap.ok(not threads, 'the same bytes for any number of threads', json.dumps(threads[:1]))
    tap.ok(not off, 'probes are within their bounds of the formulas', json.dumps(off[:1]))
    tap.ok(not missed, 'and their bounds are small', json.dumps(missed[:1]))


LAMP = {'type': 'planar', 'rectangle': {'center': [350, 200, 1700], 'size': [500, 300], 'axis': [-0.5, -0.2, -1]},
        'radiance': 50}


def lamp_sum(material, place, steps=500):
    """The lamp as steps x steps parts, each as its middle sends."""
    axis = np.array(LAMP['rectangle']['axis'], dtype=float)
    axis /= np.linalg.norm(axis)
    up = np.array([0.0, 1.0, 0.0]) - axis[1] * axis
    up /= np.linalg.norm(up)
    across = np.cross(up, axis)
    steps_of = (np.arange(steps) + 0.5) / steps - 0.5
    i, j = np.meshgrid(steps_of * 500, steps_of * 300)
    ways = np.array(LAMP['rectangle']['center'], dtype=float) + i[..., None] * across + j[..., None] * up - place
    lengths = np.linalg.norm(ways, axis=-1)
    towards = ways / lengths[..., None]
    e = 50 * np.maximum(0, -dot(towards, axis)) / (lengths / 1000) ** 2 * (0.5 * 0.3 / steps ** 2)
    normal = np.broadcast_to((place - CENTER) / RADIUS, towards.shape)
    return (e * reflected(material, normal, np.broadcast_to(VIEW, towards.shape), towards)).sum()


def check_lamps(tap, luxel, random, count):
    """A lamp against its parts, and rough integrals against fine ones, in the open and behind a plate."""
    off, rough, slack = [], [], 0.0
    plate = {'type': 'rectangle', 'center': [120, 60, 1450], 'size': [90, 70], 'axis': [0, 0, -1]}
    for number in range(count * 3):
        material = random_material(random, number)
        scene = scene_of(material, [LAMP])
        points = [[random.uniform(-200, 200), random.uniform(-200, 200)] for _ in range(2)]
        found = luxel.probe(scene, points, accept=(0, 5))['points']
        for point in found:
            value, coarse = (lamp_sum(material, np.array(point['position']), steps) for steps in (500, 250))
            doubt = abs(value - coarse) + 1e-6 * value  # the horizon may cut the lamp
            off += [(scene, point, value)] * (not abs(point['value'] - value) <= point['error'] + doubt)
        for places in (scene, {**scene, 'surfaces': scene['surfaces'] + [plate]}):
            fine = luxel.probe(places, points, options=['--tolerance', '1e-8'], accept=(0, 5))['points']
            for tolerance in ('1e-2', '1e-5'):
                coarse = luxel.probe(places, points, options=['--tolerance', tolerance], accept=(0, 5))['points']
                for a, b in zip(coarse, fine):
                    away = abs(a['value'] - b['value'])
                    rough += [(places, tolerance, a, b)] * (not away <= a['error'] + b['error'])
                    slack = max(slack, away / max(a['error'], 1e-300))
    tap.ok(not off, 'under a lamp it is the sum over its parts', json.dumps(off[:1]))
    tap.ok(not rough, f'integrals of any tolerance are within their bounds, {slack:.2g} of them at most',
           json.dumps(rough[:1]))


def check_albedo(tap, luxel):
    """What probe and explain say is reflected in all, straight on and at 60 degrees."""
    known = [({'model': 'lambert', 'diffuse_model': 'oren-nayar', 'sigma': float(np.degrees(0.5)), 'diffuse': 1},
              (.7844827586, .8831284199)),
             ({'model': 'lambert', 'diffuse_model': 'eon', 'roughness': 1, 'diffuse': 1}, (1, 1)),
             ({'model': 'ggx', 'alpha': 0.5, 'f0': 1, 'diffuse': 0, 'specular': 1}, (.6878485151, .6982506969)),
             ({'model': 'lambert', 'diffuse': 0.3}, (.3, .3))]
    for material, values in known:
        scene = scene_of(material, [])
        points = luxel.probe(scene, [[0, 0], [RADIUS * np.sin(np.pi / 3), 0], [310, 0]])['points']
        told = luxel.run(['explain', '-', '-p', '0,0'], scene)['points'][0]['albedo']
        tap.ok(max(abs(point['albedo'] - value) for point, value in zip(points, values)) <= 1e-10 and
               points[2]['albedo'] is None and told == points[0]['albedo'], 'the albedo of ' + json.dumps(material),
               json.dumps(points))


def tell(luxel, *words, scene=None):
    made = subprocess.run([luxel.path, *words], input=json.dumps(scene), capture_output=True, encoding='utf-8',
                          env={**os.environ, 'LC_ALL': 'C.UTF-8', 'LANGUAGE': ''})
    return made.returncode, made.stdout, made.stderr


def check_words(tap, luxel):
    """Errors name the key and what is allowed, and advice what has no effect, or reflects too much."""
    wrong = [({'model': 'ggx', 'alpha': 0}, 'alpha must be > 0, ≤ 1, not 0'), ({'model': 'ggx', 'f0': 1.5}, 'f0'),
             ({'diffuse_model': 'oren-nayar', 'sigma': 91}, 'sigma'), ({'diffuse_model': 'eon', 'roughness': -1},
                                                              'roughness'),
             ({'diffuse_model': 'eon', 'diffuse': 1.25}, 'diffuse is 1.25: diffuse_model: eon reflects between'),
             ({'diffuse_model': 'oren'}, 'oren-nayar')]
    for material, words in wrong:
        code, _, said = tell(luxel, 'probe', '-', '-p', '0,0', scene=scene_of(material, []))
        tap.ok(code == 3 and words in said, 'an error names ' + words, said)
    unused = [({'sigma': 30}, 'sigma has no effect'), ({'roughness': 0.5}, 'roughness has no effect'),
              ({'alpha': 0.5}, 'alpha has no effect'), ({'model': 'ggx', 'shininess': 5}, 'shininess has no effect'),
              ({'model': 'ggx', 'highlight': 'gated'}, 'highlight has no effect'),
              ({'specular': 1.0, 'shininess': 2, 'over_pi': True}, 'reflects 230 % of the light, seen straight on')]
    for material, words in unused:
        code, out, said = tell(luxel, 'check', '-', scene=scene_of(material, [LAMP]))
        tap.ok(words in out + said, 'luxel check mentions that ' + words, out + said)
    matt = {'diffuse_model': 'eon', 'diffuse': 0.5, 'over_pi': True, 'model': 'lambert'}
    closed = {**scene_of(matt, [LAMP]), 'reflections': 1}
    code, _, said = tell(luxel, 'probe', '-', '-p', '0,0', scene=closed)
    tap.ok(code == 3 and 'diffuse_model is eon, which does not reflect as Lambert' in said and
           'set diffuse_model: lambert' in said, 'reflections name the material that is not', said)
    chalk = {**matt, 'diffuse_model': 'lambert'}
    walls = {'type': 'room', 'center': [0, 0, 0], 'size': [5000] * 3, 'material': chalk, 'materials': {'left': matt}}
    code, _, said = tell(luxel, 'probe', '-', '-p', '0,0', scene={
        **closed, 'surfaces': [{**closed['surfaces'][0], 'material': chalk}, walls]})
    tap.ok(code == 3 and 'surfaces[1].materials.left: diffuse_model is eon' in said, 'of which surface, and wall', said)
    closed['surfaces'][0]['material'] = {**matt, 'roughness': 0}
    tap.ok(tell(luxel, 'probe', '-', '-p', '0,0', scene=closed)[0] == 0, 'but not one that is smooth')
    for key, words in (('sigma', 'standard deviation of the slopes'), ('f0', 'falls straight on it'),
                       ('diffuse_model', 'oren-nayar')):
        tap.ok(words in tell(luxel, 'help', key)[1], 'help knows ' + key)
    point = {'type': 'point', 'position': [500, 300, 2000], 'intensity': 10}
    for material, words in (({'diffuse_model': 'oren-nayar'}, 'D = A + B'), ({'diffuse_model': 'eon'}, 'D = A'),
                            ({'model': 'ggx'}, 'G₂')):
        code, out, said = tell(luxel, 'explain', '-', '-p', '0,0', scene=scene_of(material, [point]))
        tap.ok(code == 0 and words in out and 'the material would send' in out,
               'an explanation has ' + words, out + said)


def main():
    options = arguments(__doc__)
    tap = Tap()
    count = options.campaign or SCENES
    random = generator('materials', options.seed)
    check_points(tap, options.luxel, random, count)
    check_lamps(tap, options.luxel, random, max(count // 2, 1))
    check_albedo(tap, options.luxel)
    check_words(tap, options.luxel)
    tap.finish()


main()
