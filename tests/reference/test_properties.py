# SPDX-License-Identifier: MIT
"""What must hold for any scene, whatever the numbers are: superposition, scaling, symmetry, order.

Two ways to the same value may differ by their stated errors and 1e-12 of the value.
"""
import json

import scenes
from luxel import arguments, generator
from tap import Tap

SCENES = 15
KINDS = ('orthographic', 'perspective', 'shadows', 'elements')
VECTORS = ('center', 'position', 'aim', 'axis', 'direction')


class Values:
    """Values at the places of a case, with the errors that luxel states."""

    def __init__(self, luxel, case, lights=None):
        scene = case.scene if lights is None else {**case.scene, 'lights': lights}
        self.found = luxel.probe(scene, points=case.points, elements=case.elements)['points']
        self.value = [point['value'] for point in self.found]
        self.error = [point['error'] for point in self.found]


def turned(case, turn):
    """The case with a linear map of space applied to everything; the map leaves z alone."""
    def mapped(mapping):
        return {key: turn(value) if key in VECTORS else value for key, value in mapping.items()}

    scene = {**case.scene, 'surfaces': [mapped(surface) for surface in case.scene['surfaces']],
             'lights': [mapped(light) for light in case.scene['lights']]}
    return scenes.Case(scene, [turn([*point, 0])[:2] for point in case.points],
                       [turn(element[:3]) + turn(element[3:]) for element in case.elements])


def superposition(luxel, case):
    """The whole is the sum of the lights."""
    whole = Values(luxel, case)
    parts = [Values(luxel, case, [light]) for light in case.scene['lights']]
    value = [sum(column) for column in zip(*(part.value for part in parts))]
    error = [sum(column) for column in zip(whole.error, *(part.error for part in parts))]
    return compared(whole.value, value, error)


def proportionality(luxel, case):
    """Three times the light is three times as bright."""
    once, thrice = Values(luxel, case), Values(luxel, scenes.Case(scenes.enlarged(case.scene, 1, 3), *case[1:]))
    return compared(thrice.value, [3 * value for value in once.value],
                    [3 * a + b for a, b in zip(once.error, thrice.error)])


def mirror(luxel, case):
    """Left and right are alike."""
    return same_as(luxel, case, turned(case, lambda v: [-v[0], v[1], v[2]]))


def quarter_turn(luxel, case):
    """A quarter turn around the line of sight changes nothing."""
    return same_as(luxel, case, turned(case, lambda v: [-v[1], v[0], v[2]]))


def order(luxel, case):
    """The order of the lights does not matter."""
    return same_as(luxel, case, scenes.Case({**case.scene, 'lights': case.scene['lights'][::-1]}, *case[1:]))


def size(luxel, case):
    """Everything eight times as large, without attenuation, looks the same."""
    lights = [{**light, 'attenuation': 'none'} if 'attenuation' in light else light for light in case.scene['lights']]
    case = scenes.Case({**case.scene, 'lights': lights}, *case[1:])
    larger = scenes.Case(scenes.enlarged(case.scene, 8, 1), [[8 * x for x in point] for point in case.points],
                         [[8 * x for x in element] for element in case.elements])
    return same_as(luxel, case, larger)


def disabled(luxel, case):
    """A disabled light is as good as none: not even a rounding differs."""
    extra = {'type': 'point', 'position': [10, 20, 5000], 'intensity': 1e4, 'enabled': False}
    without, with_it = Values(luxel, case), Values(luxel, case, [extra, *case.scene['lights']])
    for point in without.found + with_it.found:
        for share in point['lights']:
            share.pop('index', None)
    return [(one, two, one == two) for one, two in zip(without.found, with_it.found)]


def same_as(luxel, case, other):
    one, two = Values(luxel, case), Values(luxel, other)
    return compared(one.value, two.value, [a + b for a, b in zip(one.error, two.error)])


def compared(one, two, error):
    """Both values of each place, and whether they are the same but for the error and the last digits."""
    return [(a, b, abs(a - b) <= 1e-12 * abs(a) + bound) for a, b, bound in zip(one, two, error)]


def test_property(tap, options, holds, kind):
    broken = []
    for index in range(options.campaign or SCENES):
        case = scenes.random_case(generator(options.seed, 'property', kind, index), kind)
        for place, (one, two, same) in zip(case.points or case.elements, holds(options.luxel, case), strict=True):
            if not same:
                broken.append(f'{one!r} and {two!r} at {place}\n  scene {json.dumps(case.scene)}')
    tap.ok(not broken, f'{kind}: {holds.__doc__.rstrip(".").lower()}', f'{len(broken)} places', *broken[:3])


def main():
    options = arguments(__doc__)
    tap = Tap()
    for kind in options.kind or KINDS:
        for holds in (superposition, proportionality, mirror, quarter_turn, order, size, disabled):
            tap.run(test_property, tap, options, holds, kind)
    tap.finish()


main()
