# SPDX-License-Identifier: MIT
"""The all-weather sky of Perez, Seals and Michalsky (1993): its coefficients by the formulas of the paper."""
import math

# x1, x2, x3, x4 of each coefficient, by the eight lines of clearness.
TABLE = {
    'a': (
        (1.3525, -1.2219, -1.1, -0.5484, -0.6, -1.0156, -1, -1.05),
        (-0.2576, -0.773, -0.2515, -0.6654, -0.3566, -0.367, 0.0211, 0.0289),
        (-0.269, 1.4148, 0.8952, -0.2672, -2.5, 1.0078, 0.5025, 0.426),
        (-1.4366, 1.1016, 0.0156, 0.7117, 2.325, 1.4051, -0.5119, 0.359),
    ),
    'b': (
        (-0.767, -0.2054, 0.2782, 0.7234, 0.2937, 0.2875, -0.3, -0.325),
        (0.0007, 0.0367, -0.1812, -0.6219, 0.0496, -0.5328, 0.1922, 0.1156),
        (1.2734, -3.9128, -4.5, -5.6812, -5.6812, -3.85, 0.7023, 0.7781),
        (-0.1233, 0.9156, 1.1766, 2.6297, 1.8415, 3.375, -1.6317, 0.0025),
    ),
    'c': (
        (2.8, 6.975, 24.7219, 33.3389, 21, 14, 19, 31.0625),
        (0.6004, 0.1774, -13.0812, -18.3, -4.7656, -0.9999, -5, -14.5),
        (1.2375, 6.4477, -37.7, -62.25, -21.5906, -7.1406, 1.2438, -46.1148),
        (1, -0.1239, 34.8438, 52.0781, 7.2492, 7.5469, -1.9094, 55.375),
    ),
    'd': (
        (1.8734, -1.5798, -5, -3.5, -3.5, -3.4, -4, -7.2312),
        (0.6297, -0.5081, 1.5218, 0.0016, -0.1554, -0.1078, 0.025, 0.405),
        (0.9738, -1.7812, 3.9229, 1.1477, 1.4062, -1.075, 0.3844, 13.35),
        (0.2809, 0.108, -2.6204, 0.1062, 0.3988, 1.5702, 0.2656, 0.6234),
    ),
    'e': (
        (0.0356, 0.2624, -0.0156, 0.4659, 0.0032, -0.0672, 1.0468, 1.5),
        (-0.1246, 0.0672, 0.1597, -0.3296, 0.0766, 0.4016, -0.3788, -0.6426),
        (-0.5718, -0.219, 0.4199, -0.0876, -0.0656, 0.3017, -2.4517, 1.8564),
        (0.9938, -0.4285, -0.5562, -0.0329, -0.1294, -0.4844, 1.4656, 0.5636),
    ),
}
ENDS = (1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2)


def coefficients(direct, diffuse, altitude, outside=1367):
    """a, b, c, d, e; None where clearness or brightness are out of range, or the sky would not shine everywhere."""
    zenith = math.radians(90 - altitude)
    cube = 1.041 * zenith ** 3
    clearness = ((diffuse + direct) / diffuse + cube) / (1 + cube)
    mass = 1 / (math.cos(zenith) + .15 * (93.885 - math.degrees(zenith)) ** -1.253)
    brightness = diffuse * mass / outside
    if clearness > 12.1 or not .01 <= brightness <= .6:
        return None
    line = sum(clearness >= end for end in ENDS)
    if 1.065 < clearness < 2.8:
        brightness = max(brightness, .2)
    x = {name: [row[line] for row in TABLE[name]] for name in TABLE}
    made = {name: x[name][0] + x[name][1] * zenith + brightness * (x[name][2] + x[name][3] * zenith) for name in x}
    if line == 0:
        c, d = x['c'], x['d']
        made['c'] = math.exp((brightness * (c[0] + c[1] * zenith)) ** c[2]) - c[3]
        made['d'] = -math.exp(brightness * (d[0] + d[1] * zenith)) + d[2] + brightness * d[3]
    a, b, c, d, e = (made[name] for name in 'abcde')
    shines = b < 0 and 1 + a * math.exp(b) >= .05 and all(
        1 + c * math.exp(d * chi / 100) + e * math.cos(chi / 100) ** 2 >= .05 for chi in range(315))
    return (a, b, c, d, e) if shines else None
