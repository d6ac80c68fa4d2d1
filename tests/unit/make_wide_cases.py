# SPDX-License-Identifier: MIT
"""Writes wide_cases.h: operations on wide numbers with their results to twice the digits, as three float64 numbers.

    make_wide_cases.py > wide_cases.h
"""
import random

from mpmath import atan2, atanh, log, mp, mpf, sqrt

mp.prec = 400
CASES = 24
OPERATIONS = ['ADD', 'SUB', 'MUL', 'DIV', 'SQRT', 'ATAN2', 'LOG', 'ATANH']
chance = random.Random(171)


def wide(low, high):
    """A wide number of either sign between two powers of 2; some with little or no low part."""
    first = chance.choice((-1, 1)) * chance.uniform(1, 2) * 2.0 ** chance.randint(low, high)
    second = first * chance.uniform(-1, 1) * 2.0 ** -54 * chance.choice((1, 1, 0, 2.0 ** -chance.randint(0, 50)))
    high_part = first + second
    return high_part, second - (high_part - first)


def near(a, off):
    first, second = a[0] * (1 + off), a[1] * chance.uniform(-1, 1)
    high_part = first + second
    return high_part, second - (high_part - first)


def negative(a):
    return -a[0], -a[1]


def absolute(a):
    return a if a[0] > 0 else negative(a)


def operands(operation, index):
    a, b = wide(-60, 60), wide(-60, 60)
    off = chance.uniform(-1, 1) * 2.0 ** -chance.choice((0, 1, 10, 40, 52, 60, 90))
    if operation in ('ADD', 'SUB') and index % 2:  # what cancels
        b = near(negative(a) if operation == 'ADD' else a, off)
    if operation == 'ATAN2' and index % 4:  # any ratio
        a, b = ((wide(-1, 1), wide(-1, 1)), (wide(-430, 0), wide(0, 0)), (wide(0, 0), wide(-430, 0)))[index % 4 - 1]
    if operation == 'SQRT':
        a = absolute(wide(-300, 300))
    if operation == 'LOG':
        a = near((1.0, 2.0 ** -60), 0.1 * off) if index % 2 else absolute(wide(-300, 300))
    if operation == 'ATANH':
        a = wide(-200, -1) if index % 2 else wide(-5, -1)
        a = a if abs(a[0]) < 1 else (a[0] / 2, a[1] / 2)
    return a, b


def exact(a):
    return mpf(a[0]) + mpf(a[1])


def result(operation, a, b):
    x, y = exact(a), exact(b)
    if operation in ('ADD', 'SUB', 'MUL', 'DIV'):
        return {'ADD': x + y, 'SUB': x - y, 'MUL': x * y, 'DIV': x / y}[operation]
    if operation == 'ATAN2':
        return atan2(x, y)
    return {'SQRT': sqrt, 'LOG': log, 'ATANH': atanh}[operation](x)


def parts(value):
    found = []
    for _ in range(3):
        found.append(float(value))
        value -= mpf(found[-1])
    return found


def main():
    print('/* SPDX-License-Identifier: MIT */')
    print('/* Operations on wide numbers and their results, as three float64 numbers; by make_wide_cases.py. */')
    print('/* clang-format off */')
    print('static const struct wide_case {')
    print('    enum operation { %s } operation;' % ', '.join(OPERATIONS))
    print('    lx_wide a, b;')
    print('    double result[3];')
    print('} wide_cases[] = {')
    for operation in OPERATIONS:
        for index in range(CASES):
            a, b = operands(operation, index)
            numbers = ', '.join(x.hex() for x in parts(result(operation, a, b)))
            print('    {%s, {%s, %s}, {%s, %s},\n     {%s}},' % (operation, a[0].hex(), a[1].hex(), b[0].hex(),
                                                                 b[1].hex(), numbers))
    print('};')


if __name__ == '__main__':
    main()
