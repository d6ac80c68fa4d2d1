# SPDX-License-Identifier: MIT
"""Holds the two models against each other and against the published cases, without luxel: who tests the testers."""
from mpmath import mp, mpf

import cubature
import extended
import extended_scenes
import model
import scenes
import vector_model
from cases import CASES, absolute_tolerance, places
from completion import completed
from luxel import generator
from tap import Tap

SCENES = 4  # of each kind
EXTENDED_SCENES = 1


def test_cases(tap):
    for case in CASES:
        worst = mpf(0)
        for place, expected in zip(places(case), case['expect']):
            highlights = case['quantity'] == 'brightness'
            answer = (model.probe_screen(case['scene'], *place, highlights) if len(place) == 2
                      else model.probe_element(case['scene'], place, highlights))
            off = abs(getattr(answer, case['quantity']) - mpf(expected)) - absolute_tolerance(case)
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


def test_closed(tap, kind):
    """The closed forms against integrals over directions: two ways that share no formula."""
    differing, places = [], 0
    for index in range(EXTENDED_SCENES):
        case = extended_scenes.random_case(generator('closed', kind, index), kind)
        scene = completed(case.scene)
        for place in case.points or case.elements:
            element = model.seen_element(scene, *place) if len(place) == 2 else model.free_element(scene, place)
            for shape in extended.source_of(scene['lights'][0]).shapes if element else []:
                closed = cubature.irradiance(shape, element.position, element.normal)
                other = cubature.integral(shape, element.position, 'diffuse', 'plain', 1, element.normal,
                                          element.normal, 'inverse-square', 0)
                places += closed.value > 0
                doubt = closed.certainty + other.certainty + mpf('1e-12') * closed.value
                if abs(closed.value - other.value) > doubt:
                    differing.append(f'{closed.value} and {other.value} at {place} of {case.scene}')
    tap.ok(places and not differing, f'{kind}: closed forms and integrals agree', places, *differing[:2])


def test_highlights(tap):
    """Highlights against a plain integral over the source's area in 15 digits, with mpmath's own rules."""
    corners = [[-200, -100, 700], [-150, 300, 800], [250, 250, 900]]
    shape = extended.polygon([extended.vector(corner) for corner in corners])
    if not extended.shines_to(shape, [mpf(0)] * 3):
        shape = extended.polygon(shape.vertices[::-1])
    normal, view = (extended.unit(extended.vector(v)) for v in ([0.1, 0.2, 1], [-0.3, 0.1, 1]))
    a, b, c = shape.vertices
    material = {'model': None, 'shininess': None}
    for lobe, name in (('half', 'blinn-phong'), ('mirror', 'phong')):
        for law, k in (('inverse-square', 0), ('practical', 300), ('none', 0), ('polynomial', [0.3, 0.2, 0.7])):
            def integrand(u, v, name=name, law=law, k=k):
                way = extended.add(extended.add(a, extended.subtract(b, a), u), extended.subtract(c, b), u * v)
                distance = extended.length(way)
                light = extended.scale(way, 1 / distance)
                s = model.lobe({**material, 'model': name}, normal, light, view)
                facing = -extended.dot(light, shape.normal) * max(mpf(0), extended.dot(light, normal))
                return 2 * shape.area * u * facing * s ** 7.5 / 10 ** 6 * model.attenuation(
                    {'attenuation': law, 'k': k, 'coefficients': k}, distance)

            with mp.workdps(15):
                expected = mp.quad(integrand, [0, 1], [0, 1], maxdegree=5)
            found = cubature.integral(shape, [mpf(0)] * 3, lobe, 'cosine', 7.5, normal, view, law,
                                      extended.vector(k) if law == 'polynomial' else mpf(k))
            tap.near(float(found.value), float(expected), 1e-11, f'the highlight of a triangle: {name}, {law}')


def main():
    tap = Tap()
    test_cases(tap)
    test_highlights(tap)
    for kind in ('free', 'volume', 'horizon', 'touching', 'whole', 'huge'):
        test_closed(tap, kind)
    for kind in scenes.KINDS:
        if kind != 'elements':
            test_kind(tap, kind)
    tap.finish()


main()
