# SPDX-License-Identifier: MIT
"""Every case of cases.json through `luxel probe`, to its own tolerance and to the digits that were printed, and
the one place where the model has no value: where a source lies on the element."""
import os
import tempfile

import numpy as np

from cases import CASES, absolute_tolerance, places
from luxel import arguments
from tap import Tap

CONTACT = {
    'luxel': 1,
    'screen': {'width': 150, 'height': 150, 'resolution': [3, 3], 'sampling': 'nodes'},
    'observer': {'z': 1000},
    'surfaces': [{'type': 'sphere', 'center': [0, 0, 0], 'radius': 100}],
    'lights': [{'type': 'point', 'position': [0, 0, 100], 'intensity': 10},
               {'type': 'distant', 'direction': [0, 0, -1], 'irradiance': 1}],
    'points': [[0, 0], [50, 0]],
}


def test_case(tap, luxel, case):
    where = places(case)
    key = 'points' if len(where[0]) == 2 else 'elements'
    options = ['--quantity', case['quantity']]
    found = luxel.values_at(case['scene'], **{key: where}, options=options)
    name = f'{case["id"]} ({case["why"]})'
    tap.equal(len(found), len(where), f'{name}: number of values')
    for place, value, expected in zip(where, found, case['expect']):
        if expected is None:
            tap.equal(value, None, f'{name} at {place}')
        else:
            tap.near(value, expected, case['relative_tolerance'], f'{name} at {place}', absolute_tolerance(case))
    printed = case.get('printed', {'values': []})
    for index, (place, value, expected) in enumerate(zip(where, found, printed['values'])):
        if index not in printed.get('skip', []):
            tap.near(value, expected, printed['tolerance'], f'{name} at {place}, as printed')


def test_contact(tap, luxel):
    """A probe there has no value but a reason; in a picture the source counts as 1e-6 mm above the surface."""
    touched, beside = luxel.probe(CONTACT)['points']
    tap.equal((touched['on_surface'], touched['value']), (True, None), 'no value under a source on the element')
    tap.ok('lights[0]' in touched.get('reason', ''), 'the reason names the source', touched)
    tap.ok(beside['value'] > 0, 'the other points have theirs')
    element = luxel.probe(CONTACT, elements=[[0, 0, 100, 0, 1, 1]])['points'][0]
    tap.equal(element['value'], None, 'no value for a free element either')
    with tempfile.TemporaryDirectory() as folder:
        for precision, accuracy in (('single', 2e-6), ('double', 1e-11)):
            output = os.path.join(folder, precision + '.npy')
            luxel.render(CONTACT, output, options=['--precision', precision])
            tap.near(float(np.load(output)[1, 1]), 10 * 1e18 * (0.8 + 0.5), accuracy,
                     f'the picture has 1e-6 mm there, {precision}')


def main():
    luxel = arguments(__doc__).luxel
    tap = Tap()
    for case in CASES:
        tap.run(test_case, tap, luxel, case)
    tap.run(test_contact, tap, luxel)
    tap.finish()


main()
