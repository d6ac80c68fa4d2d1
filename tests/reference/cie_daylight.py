# SPDX-License-Identifier: MIT
"""CIE 171:2006, tests 5.9 to 5.12, in three columns: printed, exact by the witness (sky_witness.c), and by luxel.

    cie_daylight.py LUXEL WITNESS            a test: luxel keeps its bounds, and what of the print agrees still does
    cie_daylight.py LUXEL WITNESS --print    all numbers, table by table, then those of the print that are off

The room is 4 m x 4 m x 3 m and black; the sun, which does not count, stands at 60 degrees on the side of the opening.
"""
import argparse
import os
import tempfile

import cie_daylight_tables as tables
import sky_scenes
from tap import Tap

GLASS = {'n': 1.526, 'transmittance': .96}
KNOWN = 1e-12  # roundings, relatively, beside what the witness doubts itself
AGREES = .0155  # percent: the print has two digits, and its own values are rounded ones of rounded ones
NAMES = 'ABCDEFGHIJKLMN'
WALL = [([2000, 0, 2750 - 500 * i], [0, 1, 0]) for i in range(6)]
FAR_WALL = [([2000, 4000, 2750 - 500 * i], [0, -1, 0]) for i in range(6)]
FLOOR = [([2000, 250 + 500 * i, 0], [0, 0, 1]) for i in range(8)]
CEILING = [([2000, 3750 - 500 * i, 3000], [0, 0, -1]) for i in range(8)]


class Case:
    """A table of the publication: one opening, all skies."""

    def __init__(self, test, opening, printed, glass=None, ceiling=None):
        self.test, self.title, self.printed, self.ceiling = test, opening, printed, ceiling
        width, height = (float(part) for part in opening.split(' x '))
        self.is_roof, self.is_small = width == height, width < 3
        self.opening = {'wall': 'ceiling' if self.is_roof else 'front', 'center': [0., 0.],
                        'size': [1000 * width, 1000 * height]}
        if glass:
            self.opening['glass'] = glass

    def names(self):
        return list(NAMES) + [name + "'" for name in NAMES[6:]] if self.ceiling else list(NAMES)

    def row(self, kind):
        """What is printed for a sky."""
        return self.printed[kind - 1] + (self.ceiling or [])

    def scene(self, kind):
        made = sky_scenes.Scene(self.test)
        made.put(sky_scenes.room([2000, 2000, 1500], [4000, 4000, 3000], [self.opening]))
        made.lit_by(sky_scenes.sky(kind, 60, 0 if self.is_roof else 180, 'horizontal', 100, 0 if self.is_roof else .3))
        made.places = (WALL + FLOOR) if self.is_roof else (FAR_WALL + FLOOR[::-1] + CEILING)
        return made


CASES = [
    Case('5.9', '1 x 1', tables.ROOF_1), Case('5.9', '4 x 4', tables.ROOF_4),
    Case('5.10', '1 x 1', tables.GLAZED_ROOF_1, GLASS), Case('5.10', '4 x 4', tables.GLAZED_ROOF_4, GLASS),
    Case('5.11', '2 x 1', tables.FACADE_2, None, tables.CEILING_2),
    Case('5.11', '4 x 3', tables.FACADE_4, None, tables.CEILING_4),
    Case('5.12', '2 x 1', tables.GLAZED_FACADE_2, GLASS, tables.GLAZED_CEILING_2),
    Case('5.12', '4 x 3', tables.GLAZED_FACADE_4, GLASS, tables.GLAZED_CEILING_4),
]


def measure(case, kind, luxel, witness):
    """Name, printed, exact with its own doubt, and luxel's value with its bound, of each place."""
    scene = case.scene(kind)
    with tempfile.TemporaryDirectory() as folder:
        found = scene.luxel(luxel, folder)
    return list(zip(case.names(), case.row(kind), scene.witness(witness), found))


def check(luxel, witness, kinds):
    tap = Tap()
    for case in CASES:
        agreeing = count = 0
        for kind in kinds:
            for name, printed, (exact, doubt), (value, bound) in measure(case, kind, luxel, witness):
                where = '%s, %s m, sky %d, %s' % (case.test, case.title, kind, name)
                tap.ok(abs(value - exact) <= bound + 3 * doubt + KNOWN * exact and bound < 1e-6 * exact, where,
                       'exact %.12g, found %.12g +- %.2g' % (exact, value, bound))
                agreeing += abs(printed - exact) < AGREES
                count += 1
        tap.ok(agreeing >= (.85 if case.is_small else .05) * count,
               '%s, %s m: %d of %d printed numbers agree' % (case.test, case.title, agreeing, count))
    tap.finish()


def write(luxel, witness):
    errata = []
    for case in CASES:
        print('\n%s, opening %s m: printed / exact / luxel, percent' % (case.test, case.title))
        for kind in range(1, 17):
            measured = measure(case, kind, luxel, witness)
            print('sky %2d  ' % kind + '  '.join('%s %.2f/%.7f/%.7f' % (name, printed, exact[0], found[0])
                                                 for name, printed, exact, found in measured))
            errata += [(case, kind, name, printed, exact[0]) for name, printed, exact, _ in measured
                       if abs(printed - exact[0]) >= AGREES]
    print('\nprinted numbers that are off:')
    for case, kind, name, printed, exact in errata:
        print('%s  %s m  sky %2d  %-2s  %6.2f  exact %.5f' % (case.test, case.title, kind, name, printed, exact))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('luxel')
    parser.add_argument('witness')
    parser.add_argument('--print', action='store_true', help='all numbers instead of a test')
    asked = parser.parse_args()
    luxel, witness = os.path.abspath(asked.luxel), os.path.abspath(asked.witness)
    if asked.print:
        write(luxel, witness)
    else:
        check(luxel, witness, (1, 5, 12, 15, 16))


if __name__ == '__main__':
    main()
