# SPDX-License-Identifier: MIT
"""Holds `luxel probe` against the truth for planar and volumetric sources at random places, generic and nasty.

At every place: the stated error is a true bound, for the value and for each light's share; closed forms are right to
1e-12 and everything to 2e-9, where the place is well conditioned; the tolerance is reached.  The truth says how
certain it is; a place where that is not enough to judge is counted.
"""
import json
import os
import subprocess
import tempfile

from mpmath import mp, mpf

import extended_scenes
import model
from luxel import TOLERANCE, Failed, arguments, generator
from tap import Tap

SCENES = 2                  # of each kind
ACCURACY = mpf('2e-9')      # of every value,
CLOSED = mpf('1e-12')       # of those in closed form,
CONDITION = 50              # per so much relative change of the value for a relative move of the place
MOVE = mpf('1e-7')
REACHED = mpf('1e-9')       # the tolerance that luxel takes when none is given
STATED = mpf('1e-13')       # what rounding may add to the stated error, per condition
CERTAIN = mpf('0.2')        # the truth must know this part of what it judges
SMALLEST = mpf('1e-290')
SHOWN = 4
TIMEOUT_S = 20              # of a handful of places

CLAIMS = {
    'answered': 'every place has its value',
    'honest': 'the stated error bounds the error',
    'shares': 'the same for each light',
    'accurate': 'right where well conditioned',
    'reached': 'the tolerance is reached',
}


class Findings:
    def __init__(self):
        self.texts = {sort: [] for sort in CLAIMS}
        self.counts = dict.fromkeys(CLAIMS, 0)
        self.places = self.dark = self.uncertain = 0
        self.errors = {True: [], False: []}
        self.stated = []

    def fail(self, sort, scene, place, found, text):
        self.counts[sort] += 1
        if len(self.texts[sort]) < 3 * SHOWN:
            self.texts[sort] += [text, f'  place {place}, answer {json.dumps(found)}', f'  scene {json.dumps(scene)}']


def written(scene, folder):
    """The scene for luxel: meshes go into files."""
    lights = []
    for light in scene['lights']:
        if 'solid' in light:
            light = dict(light)
            solid = light.pop('solid')
            light['mesh'] = os.path.join(folder, f'solid{len(lights)}.off')
            with open(light['mesh'], 'w', encoding='ascii') as stream:
                print('OFF', file=stream)
                print(len(solid['corners']), len(solid['faces']), 0, file=stream)
                for corner in solid['corners']:
                    print(*map(repr, corner), file=stream)
                for face in solid['faces']:
                    print(len(face), *face, file=stream)
        lights.append(light)
    return {**scene, 'lights': lights}


class Asked:
    def __init__(self, scene, place, quantity):
        self.scene, self.place, self.quantity = scene, place, quantity
        self.answer = self.ask(place)
        if self.answer:
            self.value = getattr(self.answer, quantity)
            self.doubt = self.answer.doubt if quantity == 'brightness' else self.answer.irradiance_doubt

    def ask(self, place):
        highlights = self.quantity == 'brightness'
        if len(place) == 6:
            return model.probe_element(self.scene, place, highlights)
        return model.probe_screen(self.scene, *place, highlights)

    def is_closed(self):
        """Whether a closed form gives all of the value."""
        laws = {light.get('attenuation', 'inverse-square') for light in self.scene['lights']}
        cut = all(light.get('parts', 'converged') != 'converged' for light in self.scene['lights'])
        return cut or laws == {'inverse-square'} and self.quantity == 'irradiance'

    def condition(self):
        """About the largest relative change of the value for a relative move of the place by one."""
        worst = mpf(0)
        sizes = [1 + max(map(abs, self.place[:3]))] * len(self.place)
        if len(self.place) == 6:
            sizes[3:] = [max(map(abs, self.place[3:]))] * 3
        for axis, size in enumerate(sizes):
            moved = [mpf(number) for number in self.place]
            moved[axis] += size * MOVE
            there = self.ask(moved)
            if not there:
                return mp.inf
            worst = max(worst, abs(getattr(there, self.quantity) - self.value) / self.value / MOVE)
        return worst


def check_place(findings, asked, found):
    findings.places += 1
    scene, place = asked.scene, asked.place
    if not asked.answer or found['value'] is None:
        if asked.answer or found['value'] is not None:
            findings.fail('answered', scene, place, found, 'a value where there is none, or none where there is one')
        return
    off = abs(mpf(found['value']) - asked.value)
    error = mpf(found['error'])
    if off > error + asked.doubt:
        findings.fail('honest', scene, place, found, f'truth {mp.nstr(asked.value, 20)} (certain to '
                      f'{mp.nstr(asked.doubt, 3)}), off by {mp.nstr(off, 5)}, stated {mp.nstr(error, 5)}')
    for index, (share, truth) in enumerate(zip(found['lights'], asked.answer.shares, strict=True)):
        if asked.quantity == 'irradiance':
            apart, doubt = abs(mpf(share['irradiance']) - truth.irradiance), truth.irradiance_doubt
        else:
            apart = abs(mpf(share['diffuse']) + mpf(share['specular']) - truth.diffuse - truth.specular)
            doubt = truth.doubt
        if apart > mpf(share['error']) + doubt:
            findings.fail('shares', scene, place, found, f'light {index} off by {mp.nstr(apart, 5)} from '
                          f'{[mp.nstr(part, 20) for part in truth[:3]]}')
    if asked.value < SMALLEST:
        findings.dark += 1
        return
    accuracy = CLOSED if asked.is_closed() else ACCURACY
    if asked.doubt > CERTAIN * accuracy * asked.value:
        findings.uncertain += 1
        return
    relative = off / asked.value
    findings.stated.append(error / asked.value)
    findings.errors[asked.is_closed()].append(relative)
    if relative > accuracy:
        condition = asked.condition()
        if relative > accuracy * max(1, condition / CONDITION):
            findings.fail('accurate', scene, place, found, f'truth {mp.nstr(asked.value, 20)}, relative error '
                          f'{mp.nstr(relative, 3)}, condition {mp.nstr(condition, 3)}')


def check_reached(findings, asked, found):
    """The stated error is within the tolerance, or the place itself allows no better."""
    if not found['value'] or not asked.answer or asked.value < SMALLEST:
        return
    stated = found['error'] / mpf(found['value'])
    if stated > REACHED:
        condition = asked.condition()
        if stated > REACHED + STATED * condition:
            findings.fail('reached', asked.scene, asked.place, found,
                          f'stated {mp.nstr(stated, 3)}, condition {mp.nstr(condition, 3)}')


def check_case(findings, luxel, case, quantity, folder):
    places = case.points or case.elements
    key = 'points' if case.points else 'elements'
    scene = written(case.scene, folder)
    options = ['--quantity', quantity]
    try:
        answer = luxel.probe(scene, **{key: places}, options=options)
    except Failed as failure:
        if failure.code != TOLERANCE:
            findings.fail('answered', case.scene, places, None, str(failure))
            return
        answer = luxel.probe(scene, **{key: places}, options=options, accept=(0, TOLERANCE))
        for place, found in zip(places, answer['points']):
            check_reached(findings, Asked(case.scene, place, quantity), found)
    except subprocess.TimeoutExpired:
        findings.fail('answered', case.scene, places, None, 'no answer in time')
        return
    for place, found in zip(places, answer['points'], strict=True):
        check_place(findings, Asked(case.scene, place, quantity), found)


def spread(errors):
    if not errors:
        return 'none'
    errors = sorted(errors)
    return f'median {mp.nstr(errors[len(errors) // 2], 2)}, largest {mp.nstr(errors[-1], 2)} of {len(errors)}'


def test_kind(tap, options, kind, folder):
    findings = Findings()
    for index in range(options.campaign or SCENES):
        rng = generator(options.seed, 'extended', kind, index)
        quantity = 'irradiance' if rng.random() < 0.35 else 'brightness'
        case = extended_scenes.random_case(rng, kind)
        check_case(findings, options.luxel, case, quantity, folder)
    for sort, claim in CLAIMS.items():
        tap.ok(not findings.texts[sort], f'{kind}: {claim}', f'{findings.counts[sort]} failures',
               *findings.texts[sort])
    tap.note(f'{kind}: {findings.places} places, {findings.dark} dark, {findings.uncertain} undecided; relative error '
             f'in closed form {spread(findings.errors[True])}; otherwise {spread(findings.errors[False])}; '
             f'stated {spread(findings.stated)}')


def main():
    options = arguments(__doc__)
    options.luxel.timeout_s = TIMEOUT_S
    tap = Tap()
    with tempfile.TemporaryDirectory() as folder:
        for kind in options.kind or extended_scenes.KINDS:
            tap.run(test_kind, tap, options, kind, folder)
    tap.finish()


main()
