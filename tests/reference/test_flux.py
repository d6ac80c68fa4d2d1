# SPDX-License-Identifier: MIT
"""Flux and intensity of lights: what a power gives is held against the integral of pattern or cone over all directions,
in 50 digits and more, and what `lights` says in JSON against the same."""
import math

from mpmath import mp, mpf

import extended
import model
from completion import completed
from luxel import arguments, generator
from tap import Tap

STAGE = {
    'luxel': 1,
    'screen': {'width': 100, 'height': 100, 'resolution': [2, 2]},
    'observer': {'z': 5000},
    'surfaces': [{'type': 'sphere', 'center': [0, 0, 0], 'radius': 50}],
}
PUBLISHED = {'smoothstep': 0.61035483, 'squared': 0.53321070, 'linear': 0.59591047, 'hard': 0.84178721}
ANGLES = [(20, 30), (0, 90), (90, 90), (89.9, 90), (0, 1e-6), (1e-6, 1e-6), (0.9e-6, 1e-6), (45, 45 + 1e-9), (30, 30),
          (0, 60), (10, 10.001), (59, 90), (1e-3, 80)]
EXPONENTS = [0, 1, 0.5, 2, 7.25, 80, 3000]


def point(**keys):
    return {'type': 'point', 'position': [0, 0, 1000], **keys}


def spot(inner, outer, falloff, exponent=0, **keys):
    return {'type': 'spot', 'position': [0, 0, 1000], 'inner': inner, 'outer': outer, 'falloff': falloff,
            'exponent': exponent, **keys}


def lights_of(luxel, lights):
    """What luxel says of the lights, all of one scene."""
    return luxel.run(['probe', '-', '-p', '0,0'], {**STAGE, 'lights': lights})['lights']


def same(tap, found, expected, bound, name):
    expected = mpf(expected)
    off = abs(mpf(found) - expected) / abs(expected) if found is not None else mp.inf
    told = f'{name}: {found} for {mp.nstr(expected, 20)}, {mp.nstr(off, 3)} off'
    tap.ok(off <= bound, name if off <= bound else told)


def test_power(tap, luxel):
    """I = power / solid angle, to 1e-13: every pattern and falloff, exponents of any kind, needles, equal angles."""
    rng = generator('flux')
    lights = [point(), point(pattern='lambertian')]
    lights += [point(pattern='cosine', exponent=m) for m in EXPONENTS]
    lights += [spot(inner, outer, falloff, m) for inner, outer in ANGLES for falloff in PUBLISHED for m in EXPONENTS]
    for _ in range(100):
        outer = rng.choice([rng.uniform(0, 90), 10 ** rng.uniform(-6, 1.9)])
        exponent = rng.choice([0, rng.uniform(0, 50)])
        lights.append(spot(outer * rng.random(), outer, rng.choice(list(PUBLISHED)), exponent))
    lights = [{**light, 'power': 10 ** rng.uniform(-3, 4)} for light in lights]
    told = lights_of(luxel, lights)
    whole = completed({**STAGE, 'lights': lights})['lights']
    worst, where = mpf(0), None
    for light, answer in zip(whole, told):
        expected = model.intensity(light)
        off = abs(mpf(answer['intensity']) - expected) / expected
        off = max(off, abs(mpf(answer['flux']) - mpf(light['power'])) / mpf(light['power']))
        worst, where = max((worst, where), (off, light), key=lambda pair: pair[0])
    tap.ok(worst <= mpf('1e-13'), f'{len(lights)} powers: {mp.nstr(worst, 3)} off at most ({where})')


def test_published(tap, luxel):
    told = lights_of(luxel, [spot(20, 30, falloff, intensity=1) for falloff in PUBLISHED])
    for (falloff, flux), light in zip(PUBLISHED.items(), told):
        tap.near(light['flux'], flux, 1e-8, f'the flux of a cone of 20 and 30 degrees, {falloff}')


def test_values(tap, luxel):
    """A power brightens as its intensity does, within the errors that are told."""
    light = spot(10, 25, 'smoothstep', 3, power=700)
    intensity = model.intensity(completed({**STAGE, 'lights': [light]})['lights'][0])
    exact = {key: value for key, value in light.items() if key != 'power'}
    one, other = (luxel.run(['probe', '-', '-p', '3,4'], {**STAGE, 'lights': [each]})['points'][0]
                  for each in (light, {**exact, 'intensity': float(intensity)}))
    tap.ok(abs(one['value'] - other['value']) <= one['error'] + other['error'],
           'the brightness by a power is that by its intensity')


def test_extended(tap, luxel):
    """pi times radiance times area, of both sides where both shine; the intensity along the normal."""
    sheet = {'type': 'planar', 'rectangle': {'center': [0, 0, 1000], 'size': [200, 300]}}
    polygon = {'type': 'planar', 'vertices': [[0, 0, 900], [0, 300, 900], [100, 50, 900], [200, 0, 900]]}
    disk = {'type': 'planar', 'disk': {'center': [0, 0, 1000], 'radius': 40, 'axis': [1, 0, -1]}}
    for name, light in (('rectangle', sheet), ('polygon', polygon), ('disk', disk)):
        for sides, times in (('front', 1), ('both', 2)):
            for key in ('radiance', 'intensity', 'power'):
                for law in ({}, {'attenuation': 'none'}):
                    whole = {**light, 'sides': sides, key: 7, **law}
                    source = extended.source_of({'attenuation': 'inverse-square', **whole})
                    area = extended.area(source.shapes[0]) / 10 ** 6
                    told = lights_of(luxel, [whole])[0]
                    same(tap, told['flux'], times * mp.pi * source.radiance * area, 1e-12,
                         f'the flux of a {name} by its {key}, sides {sides}, {law}')
                    same(tap, told['intensity'], source.radiance * area, 1e-12,
                         f'the intensity of a {name} by its {key}, sides {sides}, {law}')
    ball = lights_of(luxel, [{'type': 'volume', 'sphere': {'center': [0, 0, 1000], 'radius': 100}, 'power': 40}])[0]
    tap.near(ball['flux'], 40, 1e-11, 'the flux of a ball')
    tap.near(ball['intensity'], 40 / (4 * math.pi), 1e-12, 'the intensity of a ball, the same in all directions')


def test_none(tap, luxel):
    lights = [{'type': 'ambient', 'irradiance': 1}, {'type': 'distant', 'direction': [0, 0, -1], 'irradiance': 1},
              {'type': 'volume', 'box': {'center': [0, 0, 1000], 'size': [10, 10, 20]}, 'power': 3}]
    told = lights_of(luxel, lights)
    tap.ok(all(light['flux'] is None and light['intensity'] is None for light in told[:2]),
           'ambient and distant light have neither')
    tap.ok(told[2]['intensity'] is None and abs(told[2]['flux'] - 3) < 1e-11, 'a box has a flux and no one intensity')


def main():
    options = arguments(__doc__)
    tap = Tap()
    for test in (test_published, test_power, test_values, test_extended, test_none):
        test(tap, options.luxel)
    tap.finish()


main()
