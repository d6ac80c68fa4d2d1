# SPDX-License-Identifier: MIT
"""Values of luxel under random skies, suns and lamps, through windows and past bodies, against the witness.

    test_skies.py LUXEL WITNESS [--campaign N] [--seed SEED] [--kind outdoors|indoors]

A value must be the true one within its error, and the error small but for places that touch something.
"""
import argparse
import os
import statistics
import tempfile

import sky_scenes
from luxel import generator
from tap import Tap

FEW, CLOSER = 12, (3000, 1300)
CAUTION = 10  # the witness's estimate is of that trust


def is_true(found, truth):
    return abs(found[0] - truth[0]) <= found[1] + CAUTION * truth[1] + 1e-12 * abs(truth[0])


def held(tap, scene, number, found, witness):
    """Whether all values of a scene hold; returns their relative errors.  In doubt the witness looks
    closer, and again."""
    errors, truth = [], scene.witness(witness)
    if not all(map(is_true, found, truth)):
        closer = [scene.witness(witness, panels) for panels in CLOSER]
        truth = [(one[0], one[1] + abs(one[0] - other[0])) for one, other in zip(*closer)]
    for place, (value, error), (true, off) in zip(scene.places, found, truth):
        good = is_true((value, error), (true, off))
        tap.ok(good, 'scene %s, %s' % (number, scene.name), 'place %s' % (place,), 'found %r +- %r' % (value, error),
               'by the witness %r +- %r' % (true, off), *[] if good else [scene.document()])
        if true > 0:
            errors.append(error / true)
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('luxel')
    parser.add_argument('witness')
    parser.add_argument('--campaign', type=int, default=FEW, help='scenes of each kind')
    parser.add_argument('--seed', default='sky')
    parser.add_argument('--kind', action='append', choices=('outdoors', 'indoors'))
    asked = parser.parse_args()
    tap, errors, program = Tap(), [], os.path.abspath(asked.luxel)
    for kind in asked.kind or ('outdoors', 'indoors'):
        for number in range(asked.campaign):
            scene = getattr(sky_scenes, kind)(generator(asked.seed, kind, number))
            with tempfile.TemporaryDirectory() as folder:
                found = scene.luxel(program, folder)
            errors += held(tap, scene, '%s %d' % (kind, number), found, asked.witness)
    errors.sort()
    tap.note('relative bounds: median %.2g, of nine in ten at most %.2g, worst %.2g' % (
        statistics.median(errors), errors[len(errors) * 9 // 10], errors[-1]))
    tap.ok(statistics.median(errors) < 1e-8, 'bounds are small')
    tap.finish()


if __name__ == '__main__':
    main()
