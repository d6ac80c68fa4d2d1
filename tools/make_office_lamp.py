#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes data/files/office-lamp.ies, the luminaire of the built-in scene `office`: make_office_lamp.py OUTPUT

The lamp is invented: a luminaire 200 mm square with a grooved cover, so small that all of the office is farther away
than five times that.  Its intensity follows I = I0 cos(g)^1.5 (1 + a sin(g)^2), which spreads more light across the
grooves (a = 2.4 at C0) than along them (a = 0.6 at C90); I0 is what makes the flux by the zone rule 4200 lm.
"""
import math
import sys

FLUX = 4200
PLANES = [0, 15, 30, 45, 60, 75, 90]
ANGLES = [2.5 * i for i in range(37)]


def shape(c, g):
    c, g = math.radians(c), math.radians(g)
    spread = 0.6 + 1.8 * math.cos(c) ** 2
    return max(math.cos(g), 0) ** 1.5 * (1 + spread * math.sin(g) ** 2)


def zone_flux():
    """Flux of the shape by the zone rule: planes by the trapezoid rule, zones by the mean of their ends."""
    flux = 0
    for c in range(len(PLANES)):
        width = 15 * (0.5 if c in (0, len(PLANES) - 1) else 1) * 4
        for low, high in zip(ANGLES, ANGLES[1:]):
            mean = (shape(PLANES[c], low) + shape(PLANES[c], high)) / 2
            flux += math.radians(width) * mean * (math.cos(math.radians(low)) - math.cos(math.radians(high)))
    return flux


def rows(numbers, each=10):
    return "".join(" ".join(numbers[i:i + each]) + "\n" for i in range(0, len(numbers), each))


def main():
    scale = FLUX / zone_flux()
    text = ("IESNA:LM-63-2002\n[TEST] invented\n[TESTLAB] Luxel, data/files, by tools/make_office_lamp.py\n"
            "[ISSUEDATE] 2026-11-27\n[MANUFAC] Luxel\n[LUMINAIRE] square lamp with a grooved cover\n"
            "[LAMP] LED 35 W\nTILT=NONE\n"
            f"1 {FLUX} 1 {len(ANGLES)} {len(PLANES)} 1 2 0.2 0.2 0\n1 1 35\n")
    text += rows([f"{angle:g}" for angle in ANGLES], 19) + rows([str(plane) for plane in PLANES])
    for c in PLANES:
        text += rows([f"{max(scale * shape(c, g), 0):.2f}" for g in ANGLES])
    with open(sys.argv[1], "w", encoding="ascii") as output:
        output.write(text)


main()
