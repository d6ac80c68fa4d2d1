# SPDX-License-Identifier: MIT
"""Reflected light within millimetres of where faces meet, at loose tolerances.

    test_reflected_near.py LUXEL

Values of tight tolerances, which finer tiles do not change, stand against those of loose ones.
"""
import sys

import reflected_places
from tap import Tap

# Room, place, normal, irradiance there of reflected and direct light, and how well that is known.
CASES = [
    ('beside the edge of a shadow', 22000, [1400.033376573696, 15, 0], [0, 0, 1], 6.4746, 0.0099, (3e-2, 1e-2)),
    ('on the underside of a board', 40000, [2647.561670865764, 50, 1823.180306732021], [0, -1, 0], 0.8151, 0.0016,
     (1e-1, 3e-2)),
    ('on the floor under a board', 40000, [2647.561670865764, 0, 1823.180306732021], [0, 1, 0], 0.9412, 0.0009,
     (1e-1, 3e-2)),
    ('under a box that stands on the floor', 15003, [2820.0949536417843, 0, 1915.362529592625], [0, 1, 0], 0, 0,
     (1e-1,)),
]


def main():
    tap = Tap()
    for name, seed, place, normal, truth, rest, tolerances in CASES:
        room = reflected_places.Room(seed)
        room.places = [(place, normal)]
        for tolerance in tolerances:
            [(value, bound)] = reflected_places.probe(sys.argv[1], room, tolerance)
            tap.ok(abs(value - truth) <= bound + rest, '%s at %g' % (name, tolerance),
                   '%.5g +- %.2g, not %.5g' % (value, bound, truth))

    # What stands on a floor, turned so that tiles lie partly under it, does not lie on the floor's light there.
    room = reflected_places.Room(1002)
    room.places = [room.places[12]]
    [(value, bound)] = reflected_places.probe(sys.argv[1], room, 1e-1)
    tap.ok(abs(value - 51.03) <= bound + 0.2 and bound <= 0.1 * value, 'beside the foot of a turned box',
           '%.5g +- %.2g, not 51.03' % (value, bound))
    tap.finish()


if __name__ == '__main__':
    main()
