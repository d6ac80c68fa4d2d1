# SPDX-License-Identifier: MIT
"""Continuous maxima held against an independent optimiser: Newton's method with the model's 50 digits, from the
picture's highest pixel, in two coordinates or along the border of the screen."""
import os
import tempfile

import numpy as np
from mpmath import mp, mpf

import model
import vector_model
from luxel import arguments, generator
from tap import Tap

SCENES = 30
STEP = mpf(10) ** -8  # mm: its cube and square stand well above 50 digits


def material(random):
    return {'model': random.choice(['blinn-phong', 'phong', 'lambert']), 'diffuse': random.uniform(0.2, 1),
            'specular': random.uniform(0, 0.6), 'shininess': 10 ** random.uniform(0.5, 2.5),
            'highlight': random.choice(['plain', 'gated', 'cosine']), 'over_pi': random.random() < 0.5}


def light(random):
    position = [random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(1900, 3500)]
    law = random.choice([{'attenuation': 'inverse-square'}, {'attenuation': 'none'},
                         {'attenuation': 'practical', 'k': 300},
                         {'attenuation': 'polynomial', 'coefficients': [0.1, 0.4, 0.3]}])
    return random.choice([
        {'type': 'point', 'position': position, 'intensity': random.uniform(1, 20), **law},
        {'type': 'point', 'position': position, 'intensity': random.uniform(1, 20), 'pattern': 'lambertian',
         'aim': [0, 0, 900], **law},
        {'type': 'distant', 'direction': [random.uniform(-1, 1), random.uniform(-1, 1), -1],
         'irradiance': random.uniform(1, 5)},
        {'type': 'spot', 'position': position, 'aim': [random.uniform(-100, 100), 0, 1000], 'intensity': 9, 'inner': 4,
         'outer': 15, **law},
    ])


def surface(random):
    common = {'center': [random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(600, 1000)],
              'material': material(random)}
    if random.random() < 0.6:
        return {'type': 'sphere', 'radius': random.uniform(150, 260), **common}
    return {'type': 'rectangle', 'size': [2000, 2000],
            'axis': [random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 1], **common}


def random_scene(random):
    return {'luxel': 1, 'screen': {'width': 500, 'height': 500, 'resolution': [100, 100]},
            'observer': {'z': 3000, 'projection': random.choice(['orthographic', 'perspective']),
                         'view': random.choice(['parallel', 'observer'])},
            'surfaces': [surface(random)], 'lights': [light(random) for _ in range(random.randint(1, 3))]}


def value(scene, x, y):
    answer = model.probe_screen(scene, x, y)
    return answer.brightness if answer else None


def highest_pixel(luxel, scene):
    """Where the picture's maximum lies."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'field.npy')
        luxel.render(scene, path, options=['--precision', 'double'])
        highest = np.argmax(np.load(path))
    x, y = vector_model.samples(scene)
    return float(x[highest]), float(y[highest])


def climb(scene, x, y):
    """Newton's method; a coordinate that reaches the border of the screen stays there.  None: it comes to no end."""
    place, half = [mpf(x), mpf(y)], mpf(250)
    for _ in range(40):
        def at(i, j):
            return value(scene, place[0] + i * STEP, place[1] + j * STEP)
        try:
            middle, right, left, up, down = at(0, 0), at(1, 0), at(-1, 0), at(0, 1), at(0, -1)
            corner = at(1, 1)
            slope = [(right - left) / (2 * STEP), (up - down) / (2 * STEP)]
        except TypeError:  # off the surface
            return None
        bend = [[(right - 2 * middle + left) / STEP ** 2, (corner - right - up + middle) / STEP ** 2],
                [None, (up - 2 * middle + down) / STEP ** 2]]
        held = [abs(place[i]) >= half and slope[i] * place[i] > 0 for i in range(2)]
        if all(held):
            return place, middle
        if any(held):
            free = held.index(False)
            step = [0, 0]
            step[free] = -slope[free] / bend[free][free]
            concave = bend[free][free] < 0
        else:
            area = bend[0][0] * bend[1][1] - bend[0][1] ** 2
            concave = area > 0 and bend[0][0] < 0
            step = [(bend[0][1] * slope[1] - bend[1][1] * slope[0]) / area if area else 0,
                    (bend[0][1] * slope[0] - bend[0][0] * slope[1]) / area if area else 0]
        if not concave:
            step = [0 if held[i] else mp.sign(slope[i]) * 2 for i in range(2)]
        longest = max(abs(part) for part in step)
        if concave and longest < 1e-9:
            return place, middle
        shrink = min(1, 6 / longest) if longest else 1
        place = [max(-half, min(half, place[i] + shrink * step[i])) for i in range(2)]
    return None


def test_maxima(tap, luxel, campaign, seed):
    compared = 0
    for number in range(campaign or SCENES):
        scene = random_scene(generator(seed, 'extrema', number))
        found = luxel.run(['stats', '-'], scene)['maximum']
        top = climb(scene, *highest_pixel(luxel, scene)) if found else None
        if not top:
            continue
        place, truth = top
        compared += 1
        tap.ok(found['value'] >= truth * (1 - mpf(10) ** -12), f'scene {number}: not below the optimiser', found,
               mp.nstr(truth, 20), scene)
        if max(abs(found['screen'][i] - place[i]) for i in range(2)) < 1e-3:
            tap.near(found['value'], float(truth), 1e-12, f'scene {number}: the same maximum')
    tap.ok(compared >= (campaign or SCENES) // 2, f'{compared} maxima compared')


def main():
    options = arguments(__doc__)
    tap = Tap()
    tap.run(test_maxima, tap, options.luxel, options.campaign, options.seed)
    tap.finish()


main()
