# SPDX-License-Identifier: MIT
"""Holds `luxel render` against the truth at every pixel of random scenes, generic and nasty.

For each instruction set of this machine and both precisions: every pixel within the promised part of the
maximum, the same bytes for any number of threads, statistics and points that belong to the picture, and the grey
levels of the PNG by the scene's rule.  A pixel may miss where the truth itself jumps nearby.
"""
import json
import math
import os
import tempfile
from fractions import Fraction

import numpy as np

import model
import scenes
import vector_model
from luxel import arguments, generator, read_png
from tap import Tap

SCENES = 5                                         # of each kind
BOUNDS = {'single': 2e-6, 'double': 1e-11}         # of the picture's maximum,
DARK = {'single': 1.2e-38, 'double': 1e-290}       # or this where the numbers end
THREADS = (1, 2, 7)
REACH_MM = 1e-6                                    # how near a jump of the truth must be to excuse a pixel
LIT = 1.2e-38                                      # the smallest value that counts as lit
RANGES = ('max', 'minmax', 'log', 'low-high')


class Truth:
    """The picture as it should be."""

    def __init__(self, scene, quantity):
        self.scene, self.quantity = scene, quantity
        self.x, self.y = vector_model.samples(scene)
        values = vector_model.evaluate(scene, self.x, self.y, quantity)
        self.value, self.mask = values.value, values.mask
        self.maximum = self.value.max()

    def excused(self, pixels):
        """Which of the pixels (indices) have a jump of the truth nearby."""
        reach = max(REACH_MM, 1e-13 * self.scene['screen']['width'])
        return vector_model.jumps_nearby(self.scene, self.x[pixels], self.y[pixels], self.quantity, reach)


def describe(scene, **details):
    return ' '.join(f'{key} {value}' for key, value in details.items()) + f'\n  scene {json.dumps(scene)}'


# Accuracy, threads, instruction sets.

class Worst:
    """The largest error of a kind of scenes, per precision, in parts of the maximum."""

    def __init__(self):
        self.error = dict.fromkeys(BOUNDS, 0.0)
        self.excused = 0
        self.failures, self.differing = [], []

    def compare(self, truth, picture, precision, instruction_set):
        """Holds one picture against the truth."""
        error = np.abs(picture.ravel().astype(vector_model.REAL) - truth.value)
        bound = max(BOUNDS[precision], place_rounding(truth.scene))
        out = np.flatnonzero(~(error <= max(bound * truth.maximum, DARK[precision])))
        excused = truth.excused(out)
        self.excused += excused.sum()
        counts = np.ones(picture.size, dtype=bool)
        counts[out[excused]] = False
        if truth.maximum * BOUNDS[precision] > DARK[precision]:
            self.error[precision] = max(self.error[precision], float((error[counts] / truth.maximum).max()))
        bad = out[~excused]
        if len(bad):
            worst = bad[np.argmax(error[bad])]
            row, column = divmod(int(worst), picture.shape[1])
            self.failures.append(describe(
                truth.scene, quantity=truth.quantity, precision=precision, set=instruction_set, bad=len(bad),
                pixel=[column, row], at=[float(truth.x[worst]), float(truth.y[worst])],
                value=picture[row, column], truth=float(truth.value[worst]), maximum=float(truth.maximum)))


def place_rounding(scene):
    """How far a picture may be off because places are rounded to float64, for a source just above a surface.

    Samples and places on a sphere are known to about 2^-52 (R + W); seen from a source at the distance d, that turns
    directions by 2^-52 (R + W)/d, which moves 1/r^2 by twice and a highlight by sqrt(n) times as much.  It exceeds
    1e-11 only where d is below some R/10000, and docs/MATHS.md says so.
    """
    gaps, slopes = [], []
    size = max(scene['screen']['width'], scene['screen']['height'])
    for surface in scene['surfaces']:
        reach = surface['radius'] if surface['type'] == 'sphere' else math.hypot(*surface['size']) / 2
        slopes.append(max(2.0, math.sqrt(surface['material']['shininess'])) * (reach + size))
        gaps += [gap_of(surface, light['position']) for light in scene['lights'] if 'position' in light]
    nearest = min(gaps, default=math.inf)
    return 2.0 ** -52 * max(slopes) / nearest if nearest else math.inf


def gap_of(surface, position):
    """The distance of a light from a surface; of a plate: from its plane."""
    if surface['type'] == 'sphere':
        return abs(math.dist(position, surface['center']) - surface['radius'])
    axis = surface.get('axis', [0, 0, 1])
    return abs(sum(a * (p - c) for a, p, c in zip(axis, position, surface['center']))) / math.hypot(*axis)


def test_accuracy(tap, options, kind, sets, folder):
    worst = Worst()
    output = os.path.join(folder, 'picture.npy')
    for index in range(options.campaign or SCENES):
        rng = generator(options.seed, 'picture', kind, index)
        scene = scenes.random_case(rng, kind).scene
        quantity = 'irradiance' if rng.random() < 0.2 else 'brightness'
        truth = Truth(scene, quantity)
        for precision in BOUNDS:
            for instruction_set in sets:
                seen = []
                for threads in THREADS:
                    options.luxel.render(scene, output, instruction_set=instruction_set, options=[
                        '--quantity', quantity, '--precision', precision, '--threads', str(threads)])
                    with open(output, 'rb') as stream:
                        seen.append(stream.read())
                if len(set(seen)) > 1:
                    worst.differing.append(describe(scene, precision=precision, set=instruction_set))
                worst.compare(truth, np.load(output), precision, instruction_set)
    tap.ok(not worst.failures, f'{kind}: every pixel within its bound', f'{len(worst.failures)} pictures',
           *worst.failures[:3])
    tap.ok(not worst.differing, f'{kind}: the same bytes for {THREADS} threads', *worst.differing[:3])
    tap.note(f'{kind}: largest error ' + ', '.join(f'{name} {error:.2g}' for name, error in worst.error.items())
             + f' of the maximum; pixels excused: {worst.excused}')


# Statistics and points.

def expected_statistics(scene, picture, mask):
    """What --json must say of a picture: extremes with their places, mean and lit share of the surface."""
    flat = picture.ravel().astype(float)
    surface = flat[mask]
    lit = np.flatnonzero(flat >= LIT)
    least = lit[np.argmin(flat[lit])] if len(lit) else None
    return {
        'max': _extreme(scene, picture, int(np.argmax(flat))) if len(lit) else None,
        'min': _extreme(scene, picture, int(least)) if least is not None else None,
        'mean': math.fsum(surface) / len(surface) if len(surface) else None,
        'lit': float((surface >= LIT).mean()) if len(surface) else None,
    }


def _extreme(scene, picture, index):
    row, column = divmod(index, picture.shape[1])
    x, y = model.sample_of(scene, column, row)
    return {'value': float(picture[row, column]), 'pixel': [column, row], 'screen': [float(x), float(y)]}


def statistics_differ(found, expected, scene):
    """A text that says where two statistics differ, '' where they agree."""
    for key in ('max', 'min'):
        if expected[key] is not None:
            if (found[key]['value'], found[key]['pixel']) != (expected[key]['value'], expected[key]['pixel']):
                return f'{key} {found[key]}, expected {expected[key]}'
            if not np.allclose(found[key]['screen'], expected[key]['screen'], rtol=0,
                               atol=1e-13 * scene['screen']['width']):
                return f'place of {key} {found[key]}, expected {expected[key]}'
    for key in ('mean', 'lit'):
        if (found[key] is None) != (expected[key] is None):
            return f'{key} {found[key]}, expected {expected[key]}'
        if expected[key] is not None and not math.isclose(found[key], expected[key], rel_tol=1e-12):
            return f'{key} {found[key]}, expected {expected[key]}'
    return ''


def test_statistics(tap, options, kind, folder):
    """The numbers of --json belong to the picture that was written, and so do those of the probe."""
    differing = []
    output = os.path.join(folder, 'picture.npy')
    for index in range(options.campaign or SCENES):
        rng = generator(options.seed, 'statistics', kind, index)
        case = scenes.random_case(rng, kind)
        scene = {**case.scene, 'points': case.points}
        precision = rng.choice(list(BOUNDS))
        mask = Truth(scene, 'brightness').mask
        switches = ['--precision', precision]
        said = options.luxel.render(scene, output, options=switches)
        picture = np.load(output)
        problem = statistics_differ(said, expected_statistics(scene, picture, mask), scene)
        if picture.dtype != {'single': np.float32, 'double': np.float64}[precision]:
            problem = f'type {picture.dtype}'
        if not list(picture.shape)[::-1] == scene['screen']['resolution'] == said['resolution']:
            problem = f'shape {picture.shape}, said {said["resolution"]}'
        if picture.ravel()[~mask].any():
            problem = 'a value off every surface'
        probed = options.luxel.probe(scene, options=switches)
        for source, points in (('render', said['points']), ('probe', probed['points'])):
            for point, place in zip(points, case.points, strict=True):
                pixel = model.pixel_of(scene, *place)
                value = float(picture[pixel[1], pixel[0]]) if pixel else None
                if point['pixel'] != pixel or (point['on_surface'] and point['pixel_value'] != value):
                    problem = f'{source} says {point}, the picture has {value} at {pixel}'
        if problem:
            differing.append(describe(scene, precision=precision, problem=problem))
    tap.ok(not differing, f'{kind}: statistics and points are those of the picture', f'{len(differing)} scenes',
           *differing[:3])


# Grey levels.

def grey_levels(picture, mask, rule):
    """255 t in exact fractions (float64 for log) for each pixel on a surface, clipped to 0..255."""
    values = [Fraction(float(value)) for value in picture.ravel()]
    surface = [value for value, on_surface in zip(values, mask) if on_surface]
    largest, least = max(values), min(surface)

    if isinstance(rule, list):
        low, high = map(Fraction, rule)
    else:
        low, high = least if rule == 'minmax' else 0, largest

    def level(value):
        if rule == 'log':
            return 255 * (1 + math.log10(value / largest) / 4) if value > 0 else 0
        return 255 * (value - low) / (high - low)

    return [min(max(level(value), 0), 255) if on_surface else 0 for value, on_surface in zip(values, mask)]


def grey_differs(found, expected, rounding):
    """The first pixel whose grey is not the rounded level; a level may be off by 1e-9 before it is rounded."""
    half, slack = Fraction(1 if rounding == 'nearest' else 0, 2), Fraction(1, 10 ** 9)
    for index, (grey, level) in enumerate(zip(found.ravel(), expected)):
        if not math.floor(level + half - slack) <= grey <= math.floor(level + half + slack):
            return f'pixel {index}: grey {grey}, level {float(level)}'
    return ''


def test_grey(tap, options, rule, rounding, folder):
    differing = []
    names = [os.path.join(folder, name) for name in ('picture.npy', 'picture.png')]
    for index in range(options.campaign or 4):
        rng = generator(options.seed, 'grey', rule, rounding, index)
        scene = scenes.random_case(rng, rng.choice(['orthographic', 'perspective', 'shadows'])).scene
        truth = Truth(scene, 'brightness')
        surface = truth.value[truth.mask]
        if not (truth.maximum > 1e-30 and surface.min() < 0.999 * truth.maximum):
            continue  # a picture of one grey has no levels to tell
        bounds = sorted([rng.uniform(-0.1, 0.6) * float(truth.maximum), rng.uniform(0.2, 1.2) * float(truth.maximum)])
        scene['picture'] = {'range': bounds if rule == 'low-high' else rule, 'rounding': rounding}
        options.luxel.render(scene, *names, options=['--precision', rng.choice(list(BOUNDS))])
        expected = grey_levels(np.load(names[0]), truth.mask, scene['picture']['range'])
        problem = grey_differs(read_png(names[1]), expected, rounding)
        if problem:
            differing.append(describe(scene, problem=problem))
    tap.ok(not differing, f'grey levels: {rule}, {rounding}', *differing[:3])


def main():
    options = arguments(__doc__)
    tap = Tap()
    sets, lacking = options.luxel.instruction_sets(scenes.random_case(generator('sets'), 'orthographic').scene)
    tap.ok(sets, 'kernels run')
    for name in lacking:
        tap.skip(f'instruction set {name}', 'not of this machine')
    with tempfile.TemporaryDirectory() as folder:
        for kind in options.kind or scenes.PICTURES:
            tap.run(test_accuracy, tap, options, kind, sets, folder)
            tap.run(test_statistics, tap, options, kind, folder)
        for rule in RANGES:
            for rounding in ('truncate', 'nearest'):
                tap.run(test_grey, tap, options, rule, rounding, folder)
    tap.finish()


main()
