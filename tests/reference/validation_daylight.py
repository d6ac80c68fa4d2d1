# SPDX-License-Identifier: MIT
"""Daylight in docs/VALIDATION.md: printed numbers of CIE 171, tests 5.9 to 5.12, that are off, beside exact values.

The exact values are those of the witness (sky_witness.c); cie_daylight.py prints all numbers in three columns, and
holds luxel to the witness in a test.
"""
from cie_daylight import CASES
from validation_page import figures, off_exact, off_printed

# Case, sky, and by place what the witness gives, to 9 digits.
ERRATA = (
    (0, 3, {'A': 0.792029779, 'B': 2.04588014, 'C': 2.46049485, 'D': 2.2194292, 'E': 1.77765642, 'F': 1.3609143}),
    (1, 1, {'A': 35.8228502}), (1, 3, {'A': 40.9624711}), (1, 5, {'A': 45.1226036}),
    (1, 13, {'A': 68.1542365, 'G': 47.013298}), (1, 15, {'A': 74.7957167}), (1, 16, {'A': 37.3553341}),
    (3, 5, {'A': 31.2291567}), (3, 15, {'A': 52.1610852}),
    (4, 8, {'L': 15.3765118}),
    (5, 5, {'A': 6.18279247, 'C': 11.3444921, 'D': 13.2223262, 'F': 15.4101708, 'N': 44.4915387}),
    (5, 15, {'A': 8.54512859, 'D': 23.2158241}), (5, 14, {'G': 10.1188452, 'J': 25.0933143, 'N': 68.4853279}),
    (6, 15, {'H': 2.73426664}), (7, 5, {'A': 5.42845751, 'N': 31.1193782}),
)
DIGITS = -8  # powers of ten: the exact values here have nine digits


def daylight(page):
    page.heading(
        'CIE 171, tests 5.9 to 5.12: daylight through openings',
        'A black room of 4 m × 4 m × 3 m under the skies 1 to 16, the sun, which does not count, at 60° on the side of '
        'the opening: in the roof (5.9; with glass 5.10), or in a wall before a ground of reflectance 0.3 (5.11; with '
        'glass 5.12). The glass is n = 1.526, 0.96 of the light is left at right angles. Percent of the horizontal '
        'illuminance under the open sky. `tests/reference/cie_daylight.py LUXEL WITNESS --print` prints all 1824 '
        'numbers in three columns: printed, exact and Luxel.',
        'The printed numbers of small openings are right to their digits: of 1 m × 1 m in the roof all but '
        'row A to F of sky 3, which stands in reverse order, and three that are off by 0.02; of 2 m × 1 m '
        'in the wall to 0.034, but for place H of sky 15 behind glass. Those of large openings are not: '
        'beside an opening of 4 m × 4 m or 4 m × 3 m they are off by up to 2.1 and 1.2 points, in the '
        'uniform sky (5) as well, of which Lambert\'s formula gives the exact value; place G of sky 13 in '
        '5.9, 4 m × 4 m, has a wrong digit, and the floor of sky 14 in 5.11, 4 m × 3 m, is a copy of that '
        'of sky 15. Some of these numbers, and the worst:')
    rows = []
    for number, kind, exact in ERRATA:
        case = CASES[number]
        scene = case.scene(kind)
        names = case.names()
        elements = [scene.places[names.index(name)] for name in exact]
        found = page.luxel.values_at(scene.document(), elements=[place + normal for place, normal in elements],
                                     options=['--quantity', 'irradiance'])
        for (name, truth), value in zip(exact.items(), found):
            printed = case.row(kind)[names.index(name)]
            rows.append([case.test, case.title.replace('x', '×'), str(kind), name, f'{printed:.2f}', figures(truth, 9),
                         figures(value, 9), off_exact(value, truth, DIGITS), off_printed(value, printed)])
    page.table(['test', 'opening (m)', 'sky', 'place', 'printed (%)', 'exact (%)', 'Luxel (%)', 'off the exact',
                'off the printed'], rows)
