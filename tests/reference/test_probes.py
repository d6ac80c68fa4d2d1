# SPDX-License-Identifier: MIT
"""Holds `luxel probe` against the truth at random places of random scenes, generic and nasty.

At every place: the error that luxel states is a true bound, for the value and for each light's share, and what
is seen, the pixel and the unit are right.  Where the truth is well conditioned: the value is right to 1e-12 or
1e-11, and the stated error is small.  What was found is printed kind by kind.
"""
import json

from mpmath import mp, mpf

import model
import scenes
from luxel import Failed, arguments, generator
from tap import Tap

SCENES = 15           # of each kind
# Relative accuracy up to a condition: the relative change of the value per relative move of the place.
ACCURACY = ((50, 1e-12), (1000, 1e-11))
STATED = 3e-12        # the stated error, relative, per 1 + condition
MOVE = mpf('1e-20')   # how far the place moves to find the condition
SMALLEST = mpf('1e-290')  # values below are left to subnormal numbers
SHOWN = 5             # failures of a sort that are printed in full


class Asked:
    """A place of a scene, the truth there, and how far the truth moves with the place."""

    def __init__(self, scene, place, quantity):
        self.scene, self.place, self.quantity = scene, place, quantity
        self.is_element = len(place) == 6
        self.answer = self._ask(place)
        self.value = getattr(self.answer, quantity) if self.answer else None

    def _ask(self, place):
        if self.is_element:
            return model.probe_element(self.scene, place)
        return model.probe_screen(self.scene, *place)

    def condition(self):
        """The largest relative change of the value for a relative move of the place by one."""
        if not self.value:
            return mp.inf
        sizes = [model.reach_of(self.scene['surfaces'][0]) + max(map(abs, self.place[:3]))] * len(self.place)
        if self.is_element:
            sizes[3:] = [max(map(abs, self.place[3:]))] * 3
        worst = mpf(0)
        for axis, size in enumerate(sizes):
            moved = [mpf(number) for number in self.place]
            moved[axis] += size * MOVE
            there = self._ask(moved)
            if not there:
                return mp.inf
            worst = max(worst, abs(getattr(there, self.quantity) / self.value - 1) / MOVE)
        return worst


class Findings:
    """What the probes of one kind of scene gave."""

    def __init__(self):
        self.failures = {}  # sort: list of texts
        self.counts = {}    # sort: how many
        self.generic = []   # relative errors, well conditioned
        self.stated = []    # stated errors, relative, well conditioned
        self.nasty = []     # relative errors, elsewhere

    def fail(self, sort, asked, found, text):
        self.counts[sort] = self.counts.get(sort, 0) + 1
        listed = self.failures.setdefault(sort, [])
        if len(listed) < SHOWN:
            listed += [f'{text}', f'  place {asked.place}, {asked.quantity}, answer {json.dumps(found)}',
                       f'  scene {json.dumps(asked.scene)}']


def check_place(findings, asked, found):
    """What is seen, where, and through which pixel."""
    element = asked.answer.element if asked.answer else None
    if found['on_surface'] != (element is not None):
        findings.fail('place', asked, found, f'on a surface: {element is not None}')
        return
    if not asked.is_element:
        pixel = model.pixel_of(asked.scene, *asked.place)
        if found['pixel'] != pixel:
            findings.fail('place', asked, found, f'pixel {pixel}')
        if found['screen'] != asked.place:
            findings.fail('place', asked, found, 'screen point')
    if element:
        depth = abs(model.dot(element.normal, element.view)) if element.own is not None else mpf(1)
        reach = mpf('1e-12') / max(depth, mpf('1e-8'))
        scale = model.reach_of(asked.scene['surfaces'][0]) + model.length(element.position)
        for key, truth, size in (('position', element.position, scale), ('normal', element.normal, 1)):
            if max(abs(mpf(number) - true) for number, true in zip(found[key], truth)) > reach * size:
                findings.fail('place', asked, found, f'{key} {[float(number) for number in truth]}')


def check_bounds(findings, asked, found):
    """The stated errors hold, of the value and of each light's share."""
    if abs(mpf(found['value']) - asked.value) > mpf(found['error']):
        findings.fail('honest', asked, found,
                      f'truth {mp.nstr(asked.value, 20)}, off by {mp.nstr(abs(mpf(found["value"]) - asked.value), 5)}')
    if len(found['lights']) != len(asked.answer.shares):
        findings.fail('shares', asked, found, f'{len(asked.answer.shares)} lights')
        return
    for index, (share, truth) in enumerate(zip(found['lights'], asked.answer.shares)):
        if asked.quantity == 'irradiance':
            off = abs(mpf(share['irradiance']) - truth.irradiance)
        else:
            off = abs(mpf(share['diffuse']) + mpf(share['specular']) - truth.diffuse - truth.specular)
        if off > mpf(share['error']):
            findings.fail('shares', asked, found, f'light {index} off by {mp.nstr(off, 5)}: '
                          f'{[mp.nstr(part, 20) for part in truth[:3]]}')


def check_accuracy(findings, asked, found):
    """The value is near the truth, and the stated error is no excuse."""
    if not asked.value:
        return
    relative = abs(mpf(found['value']) / asked.value - 1)
    stated = mpf(found['error']) / asked.value
    condition = asked.condition() if asked.value > SMALLEST else mp.inf
    accuracy = next((accuracy for limit, accuracy in ACCURACY if condition <= limit), None)
    if accuracy is None:
        findings.nasty.append(relative)
        return
    findings.generic.append(relative)
    findings.stated.append(stated)
    sizes = f'error {mp.nstr(relative, 5)}, stated {mp.nstr(stated, 5)}, condition {mp.nstr(condition, 5)}'
    if relative > accuracy:
        findings.fail('accurate', asked, found, f'truth {mp.nstr(asked.value, 20)}, {sizes}')
    if stated > STATED * (1 + condition):
        findings.fail('sharp', asked, found, sizes)


def check_case(findings, luxel, case, quantity):
    places = case.points or case.elements
    key = 'points' if case.points else 'elements'
    try:
        answer = luxel.probe(case.scene, **{key: places}, options=['--quantity', quantity])
    except Failed as failure:
        findings.fail('place', Asked(case.scene, places[0], quantity), None, str(failure))
        return
    unit = model.unit_of(case.scene, quantity)
    for place, found in zip(places, answer['points'], strict=True):
        asked = Asked(case.scene, place, quantity)
        check_place(findings, asked, found)
        if unit and answer['unit'] != unit:
            findings.fail('place', asked, answer['unit'], f'unit {unit}')
        if asked.answer and found['value'] is not None:
            check_bounds(findings, asked, found)
            check_accuracy(findings, asked, found)
        elif asked.answer or found['value'] is not None:
            findings.fail('place', asked, found, 'a value where there is none, or none where there is one')


def spread(errors):
    """A distribution in one line: median, 99 of 100, largest."""
    if not errors:
        return 'none'
    errors = sorted(errors)
    return ', '.join(f'{name} {mp.nstr(errors[min(int(share * len(errors)), len(errors) - 1)], 2)}'
                     for name, share in (('median', 0.5), ('99 %', 0.99), ('largest', 1))) + f' of {len(errors)}'


CLAIMS = {
    'place': 'what is seen, its pixel and unit are right',
    'honest': 'the stated error bounds the error',
    'shares': 'the same for each light',
    'accurate': 'right where well conditioned',
    'sharp': 'the stated error is small there',
}


def test_kind(tap, options, kind):
    findings = Findings()
    for index in range(options.campaign or SCENES):
        rng = generator(options.seed, kind, index)
        quantity = 'irradiance' if rng.random() < 0.2 else 'brightness'
        check_case(findings, options.luxel, scenes.random_case(rng, kind), quantity)
    for sort, claim in CLAIMS.items():
        failures = findings.failures.get(sort, [])
        tap.ok(not failures, f'{kind}: {claim}', f'{findings.counts.get(sort)} failures', *failures)
    tap.note(f'{kind}: relative error {spread(findings.generic)}; stated {spread(findings.stated)}; '
             f'ill conditioned {spread(findings.nasty)}')


def main():
    options = arguments(__doc__)
    tap = Tap()
    for kind in options.kind or scenes.KINDS:
        tap.run(test_kind, tap, options, kind)
    tap.finish()


main()
