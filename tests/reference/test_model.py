# SPDX-License-Identifier: MIT
"""Holds the two models against each other and against the published cases, without luxel: who tests the testers."""
from mpmath import mpf

import model
import scenes
import vector_model
from cases import CASES, places
from luxel import generator
from tap import Tap

SCENES = 25  # of each kind


def test_cases(tap):
    for case in CASES:
        worst = mpf(0)
        for place, expected in zip(places(case), case['expect']):
            answer = (model.probe_screen(case['scene'], *place) if len(place) == 2
                      else model.probe_element(case['scene'], place))
            off = abs(getattr(answer, case['quantity']) - mpf(expected))
            worst = max(worst, off / max(abs(mpf(expected)), mpf('1e-30')))
        tap.ok(worst <= case['relative_tolerance'], f'the model gives case {case["id"]}',
               f'relative error {float(worst)}')


def exact(number):
    """A NumPy long double as an mpf, without a digit lost."""
    high = float(number)
    return mpf(high) + mpf(float(number - vector_model.REAL(high)))


def test_kind(tap, kind):
    """Both models at random screen points: the same visibility, and values that agree to extended precision."""
    mismatches, worst = [], mpf(0)
    for index in range(SCENES):
        case = scenes.random_case(generator('model', kind, index), kind)
        for quantity in ('brightness', 'irradiance'):
            x, y = zip(*case.points)
            values = vector_model.evaluate(case.scene, x, y, quantity)
            answers = [model.probe_screen(case.scene, *point) for point in case.points]
            scale = max([getattr(answer, quantity) for answer in answers if answer] or [0])
            for answer, value, on_surface in zip(answers, values.value, values.mask):
                if (answer is not None) != on_surface:
                    mismatches.append((index, 'visibility'))
                elif answer and scale > 1e-250:  # float64 hands the values over
                    worst = max(worst, abs(exact(value) - getattr(answer, quantity)) / scale)
    tap.ok(not mismatches, f'{kind}: both models see the same', mismatches)
    tap.ok(worst < 1e-13, f'{kind}: both models agree', f'largest difference {float(worst)} of the maximum')


def main():
    tap = Tap()
    test_cases(tap)
    for kind in scenes.KINDS:
        if kind != 'elements':
            test_kind(tap, kind)
    tap.finish()


main()
