# SPDX-License-Identifier: MIT
"""Integrals of luxel's own values that are known in closed form: the flux of spots and patterns, and the share
of light that a normalized lobe reflects."""
import math

import numpy as np

from luxel import arguments
from tap import Tap

PUBLISHED_FLUX = {'smoothstep': 0.61035483, 'squared': 0.53321070, 'linear': 0.59591047, 'hard': 0.84178721}
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
STAGE = {
    'luxel': 1,
    'screen': {'width': 100, 'height': 100, 'resolution': [10, 10]},
    'observer': {'z': 5000},
    'surfaces': [{'type': 'sphere', 'center': [0, 0, 0], 'radius': 50}],
}


def polar_rule(*edges, order=24):
    """Nodes and weights of a Gauss rule in the polar angle, panel by panel, with 2 pi sin in the weights."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    angles = [low + (high - low) * (nodes + 1) / 2 for low, high in zip(edges, edges[1:])]
    spans = [(high - low) / 2 * weights for low, high in zip(edges, edges[1:])]
    angles = np.concatenate(angles)
    return angles, np.concatenate(spans) * 2 * math.pi * np.sin(angles)


def around(axis, angles):
    """Directions at polar angles to an axis, winding around it."""
    axis = np.array(axis) / np.linalg.norm(axis)
    side = np.cross(axis, [0.3, 0.5, 0.7])
    side /= np.linalg.norm(side)
    turns = GOLDEN_ANGLE * np.arange(len(angles))
    across = np.outer(np.cos(turns), side) + np.outer(np.sin(turns), np.cross(axis, side))
    return np.cos(angles)[:, None] * axis + np.sin(angles)[:, None] * across


# Flux.

def flux(luxel, light, edges):
    """The light's flux for the intensity 1 on its axis: irradiance summed over the sphere of 1 m around it."""
    position, axis = [700, -300, 200], [0.4, -0.2, 1]
    scene = {**STAGE, 'lights': [{'position': position, 'axis': axis, 'intensity': 1, **light}]}
    angles, weights = polar_rule(*edges)
    elements = [[*(np.array(position) + 1000 * direction), *(-direction)] for direction in around(axis, angles)]
    return float(np.dot(weights, luxel.values_at(scene, elements=elements, options=['--quantity', 'irradiance'])))


def closed_flux(falloff, a, b):
    """The same in closed form, for exponent 0."""
    if falloff == 'linear':
        return 2 * math.pi * (1 - (math.sin(b) - math.sin(a)) / (b - a))
    within = {'smoothstep': 1 / 2, 'squared': 1 / 3, 'hard': 1}[falloff]
    return 2 * math.pi * (1 - math.cos(a) + within * (math.cos(a) - math.cos(b)))


def test_spots(tap, luxel):
    for falloff, published in PUBLISHED_FLUX.items():
        for inner, outer in ((20, 30), (0, 90), (5, 6), (40, 89)):
            light = {'type': 'spot', 'inner': inner, 'outer': outer, 'falloff': falloff}
            a, b = math.radians(inner), math.radians(outer)
            found = flux(luxel, light, (0, a, b) if a else (0, b))
            tap.near(found, closed_flux(falloff, a, b), 1e-11, f'flux of a {falloff} spot, {inner} to {outer} degrees')
            if (inner, outer) == (20, 30):
                tap.near(found, published, 0, f'flux of a {falloff} spot as published', absolute=5.1e-9)
    for exponent in (0, 1, 3.5, 40):
        light = {'type': 'spot', 'inner': 25, 'outer': 25, 'exponent': exponent}
        expected = 2 * math.pi * (1 - math.cos(math.radians(25)) ** (exponent + 1)) / (exponent + 1)
        tap.near(flux(luxel, light, (0, math.radians(25))), expected, 1e-11, f'flux of a spot with exponent {exponent}')


def test_patterns(tap, luxel):
    whole = (0, math.pi / 2, math.pi)
    for light, expected in (({'pattern': 'isotropic'}, 4 * math.pi), ({'pattern': 'lambertian'}, math.pi),
                            ({'pattern': 'cosine', 'exponent': 3}, math.pi / 2),
                            ({'pattern': 'cosine', 'exponent': 0}, 4 * math.pi)):
        found = flux(luxel, {'type': 'point', **light}, whole)
        tap.near(found, expected, 1e-11, f'flux of a point source {light}')


# Reflected share.

def reflected_share(luxel, material):
    """What the top of the sphere, seen from straight above, reflects of light from everywhere: a sum of distant
    lights."""
    halves = [2.0 ** -k for k in range(24, 0, -1)]
    edges = np.array([0, *halves, *(1 - half for half in halves[-2::-1]), 1]) * math.pi / 2
    angles, weights = polar_rule(*edges, order=12)
    lights = [{'type': 'distant', 'direction': list(-direction), 'irradiance': weight}
              for direction, weight in zip(around([0, 0, 1], angles), weights)]
    surface = {**STAGE['surfaces'][0], 'material': {'over_pi': True, **material}}
    scene = {**STAGE, 'surfaces': [surface], 'lights': lights}
    return luxel.values_at(scene, elements=[[0, 0, surface['radius'], 0, 0, 1]])[0]


def test_albedo(tap, luxel):
    for model in ('blinn-phong', 'phong'):
        for shininess in (0.1, 1, 20, 300, 10000):
            lobe = reflected_share(luxel, {'model': model, 'diffuse': 0, 'specular': 0.37, 'shininess': shininess,
                                           'highlight': 'cosine', 'normalized': True})
            tap.near(lobe, 0.37, 1e-10, f'a normalized {model} lobe, {shininess}, reflects ks')
    matt = reflected_share(luxel, {'model': 'lambert', 'diffuse': 0.73})
    tap.near(matt, 0.73, 1e-11, 'a diffuse surface reflects kd')


def main():
    luxel = arguments(__doc__).luxel
    tap = Tap()
    for test in (test_spots, test_patterns, test_albedo):
        tap.run(test, tap, luxel)
    tap.finish()


main()
