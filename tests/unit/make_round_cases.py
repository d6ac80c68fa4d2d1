# SPDX-License-Identifier: MIT
"""Writes round_cases.h: the irradiance by disks, balls and cylinders, computed with 80 digits.

    make_round_cases.py > round_cases.h

The contour of what an element sees is walked along numerically, E = 1/2 closed integral of N.(r x dr)/|r|^2: arcs of
circles by adaptive quadrature, straight ways by their angle.  Where a case is not made to be hard, the integral of
cos cos'/r^2 over the source's surface is computed besides and must agree.
"""
import math

from mpmath import acos, atan2, cos, floor, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 80
NEGLIGIBLE = mpf(10) ** -60
SURFACE_STEPS, SURFACE_AGREES = 400, 2e-3


def vector(v):
    return [mpf(x) for x in v]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def mul(a, t):
    return [x * t for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return sqrt(dot(a, a))


def unit(a):
    return mul(a, 1 / length(a))


class Circle:
    """Seen from the origin: its axis points away from there, u from the axis through the origin to its centre."""

    def __init__(self, center, axis, radius):
        self.center, self.axis, self.radius = center, axis, radius
        away = sub(center, mul(axis, dot(center, axis)))
        self.rho = length(away)
        if self.rho < NEGLIGIBLE * length(center):
            smallest = min(range(3), key=lambda i: abs(axis[i]))
            other = [mpf(i == smallest) for i in range(3)]
            away, self.rho = sub(other, mul(axis, dot(other, axis))), mpf(0)
        self.u = unit(away)
        self.v = cross(axis, self.u)

    def place(self, w):
        return add(self.center, add(mul(self.u, self.radius * cos(w)), mul(self.v, self.radius * sin(w))))

    def way(self, w):
        return add(mul(self.u, -self.radius * sin(w)), mul(self.v, self.radius * cos(w)))

    def above(self, normal):
        """w0 and half the angle of what is above the horizon, None: all, 0: nothing."""
        middle, x, y = dot(normal, self.center), dot(normal, self.u), dot(normal, self.v)
        reach = self.radius * sqrt(x * x + y * y)
        if middle >= reach:
            return mpf(0), None
        if middle <= -reach:
            return mpf(0), mpf(0)
        return atan2(y, x), atan2(sqrt((reach - middle) * (reach + middle)), -middle)

    def arc(self, normal, begin, end):
        """The integral along an arc, divided where it passes near to the origin."""
        if begin == end:
            return mpf(0)

        def integrand(w):
            place = self.place(w)
            return dot(normal, cross(place, self.way(w))) / dot(place, place)

        near = pi * (2 * floor((begin + end) / 2 / (2 * pi)) + 1)
        points = {begin, end, near, *(near + sign * mpf(2) ** -k for k in range(-2, 40, 2) for sign in (-1, 1))}
        return quad(integrand, sorted(p for p in points if begin <= p <= end))


def straight(normal, begin, end):
    product = cross(begin, end)
    if length(product) < NEGLIGIBLE * length(begin) * length(end):
        return mpf(0)
    return atan2(length(product), dot(begin, end)) * dot(normal, product) / length(product)


def along_horizon(normal, begin, end):
    return length(normal) * atan2(abs(dot(normal, cross(begin, end))) / length(normal), dot(begin, end))


def circle_seen(circle, normal):
    top, half = circle.above(normal)
    if half is None:
        return circle.arc(normal, -pi, pi) / 2
    if half == 0:
        return mpf(0)
    begin, end = top - half, top + half
    chord = along_horizon(normal, circle.place(end), circle.place(begin))
    return (circle.arc(normal, begin, end) + chord) / 2


def disk(place, normal, numbers):
    center, radius, axis = sub(vector(numbers[:3]), vector(place)), mpf(numbers[3]), unit(vector(numbers[4:]))
    if dot(center, axis) >= 0:
        return mpf(0)
    return circle_seen(Circle(center, mul(axis, -1), radius), normal)


def ball(place, normal, numbers):
    center, radius = sub(vector(numbers[:3]), vector(place)), mpf(numbers[3])
    distance2 = dot(center, center)
    share = (distance2 - radius ** 2) / distance2
    return circle_seen(Circle(mul(center, share), unit(center), radius * sqrt(share)), normal)


def cylinder(place, normal, numbers):
    center, axis = sub(vector(numbers[:3]), vector(place)), unit(vector(numbers[5:]))
    radius, height = vector(numbers[3:5])
    if dot(center, axis) < 0:
        axis = mul(axis, -1)
    half = mul(axis, height / 2)
    rims = [Circle(sub(center, half), axis, radius), Circle(add(center, half), axis, radius)]
    below = dot(rims[0].center, axis) > 0
    if rims[0].rho <= radius:
        return circle_seen(rims[0], normal)
    touch = pi - acos(radius / rims[0].rho)
    corners = [[rim.place(touch), rim.place(-touch)] for rim in rims]
    pieces = [(rims[1], touch, 2 * pi - touch, 1), (corners[1][1], corners[0][1])]
    pieces += [(rims[0], -touch, touch, 1)] if below else [(rims[0], touch, 2 * pi - touch, -1)]
    pieces += [(corners[0][0], corners[1][0])]
    total, leaves, enters = mpf(0), [], []
    for piece in pieces:
        if len(piece) == 2:
            (begin, end), heights = piece, [dot(normal, p) for p in piece]
            if max(heights) <= 0:
                continue
            if min(heights) < 0:
                met = add(begin, mul(sub(end, begin), heights[0] / (heights[0] - heights[1])))
                (leaves if heights[1] < 0 else enters).append(met)
                begin, end = (begin, met) if heights[1] < 0 else (met, end)
            total += straight(normal, begin, end)
            continue
        rim, begin, end, sign = piece
        top, seen = rim.above(normal)
        if seen is None:
            total += sign * rim.arc(normal, begin, end)
        elif seen > 0:
            for turn in (-1, 0, 1):
                low, high = max(begin, top - seen + 2 * pi * turn), min(end, top + seen + 2 * pi * turn)
                if low < high:
                    total += sign * rim.arc(normal, low, high)
                    if low > begin:
                        (enters if sign > 0 else leaves).append(rim.place(low))
                    if high < end:
                        (leaves if sign > 0 else enters).append(rim.place(high))
    assert len(leaves) == len(enters) <= 1
    if leaves:
        total += along_horizon(normal, leaves[0], enters[0])
    return total / 2


# ---- over the surface ----

def parts_of_disk(center, radius, normal, across, upward, steps):
    for i in range(steps):
        r = radius * math.sqrt((i + 0.5) / steps)
        for k in range(steps):
            w = 2 * math.pi * (k + 0.5) / steps
            yield ([c + r * (math.cos(w) * a + math.sin(w) * b) for c, a, b in zip(center, across, upward)], normal,
                   math.pi * radius ** 2 / steps ** 2)


def parts(kind, numbers, steps):
    numbers = [float(x) for x in numbers]
    center, radius = numbers[:3], numbers[3]
    axis = [float(x) for x in unit(vector(numbers[-3:]))] if kind != 'BALL' else [0, 0, 1]
    smallest = min(range(3), key=lambda i: abs(axis[i]))
    across = [float(x) for x in unit(cross(axis, [i == smallest for i in range(3)]))]
    upward = [float(x) for x in cross(axis, across)]
    if kind == 'DISK':
        yield from parts_of_disk(center, radius, axis, across, upward, steps)
        return
    height = numbers[4] if kind == 'CYLINDER' else 2 * radius
    for i in range(steps):
        t = (i + 0.5) / steps * 2 - 1
        for k in range(steps):
            w = 2 * math.pi * (k + 0.5) / steps
            outwards = [math.cos(w) * a + math.sin(w) * b for a, b in zip(across, upward)]
            if kind == 'BALL':
                outwards = [math.sqrt(1 - t * t) * o + t * a for o, a in zip(outwards, axis)]
                place = [c + radius * o for c, o in zip(center, outwards)]
            else:
                place = [c + radius * o + height / 2 * t * a for c, o, a in zip(center, outwards, axis)]
            yield place, outwards, 2 * math.pi * radius * height / steps ** 2
    if kind == 'CYLINDER':
        for sign in (-1, 1):
            cap = [c + sign * height / 2 * a for c, a in zip(center, axis)]
            yield from parts_of_disk(cap, radius, [sign * a for a in axis], across, upward, steps)


def over_surface(kind, numbers, place, normal):
    total = 0.0
    for at, facing, area in parts(kind, numbers, SURFACE_STEPS):
        r = [a - b for a, b in zip(at, place)]
        above, towards = sum(a * b for a, b in zip(normal, r)), -sum(a * b for a, b in zip(facing, r))
        if above > 0 and towards > 0:
            total += above * towards * area / sum(a * a for a in r) ** 2
    return total


# ---- cases ----

UP, DOWN, ORIGIN = [0, 0, 1], [0, 0, -1], [0, 0, 0]
SLANTED = [0.48, -0.6, 0.64]
EASY, HARD = True, False


def away_from(to, off):
    """Nearly a unit vector at right angles to (a, 0, b), and turned towards it by so many radians."""
    size = math.hypot(to[0], to[2])
    across = [-to[2] / size, 0, to[0] / size]
    return [math.cos(off) * a + math.sin(off) * b / size for a, b in zip(across, to)]


def disks():
    lamp = [0, 0, 1000, 300, 0, 0, -1]
    turned = [200, -100, 1000, 300, 1, 2, -2]
    yield 'on the axis', lamp, ORIGIN, UP, EASY
    yield 'off the axis', lamp, [250, -320, 20], SLANTED, EASY
    yield 'turned', turned, [250, -320, 20], SLANTED, EASY
    yield 'behind', turned, [900, 500, 2000], DOWN, EASY
    yield 'in its plane', lamp, [800, 0, 1000], [-0.6, 0, 0.8], EASY
    yield 'below the horizon', lamp, ORIGIN, [0, 0.6, -0.8], EASY
    yield 'cut by the horizon', lamp, ORIGIN, [0.96, 0, 0.28], EASY
    yield 'cut through its middle', lamp, ORIGIN, [0.6, 0.8, 0], EASY
    yield 'cut, turned', turned, [600, 100, 40], [-0.28, 0.96, 0], EASY
    yield 'over the head', lamp, [100, 0, 999], UP, HARD
    yield 'close', lamp, [100, 50, 999.9999], SLANTED, HARD
    yield 'close, a wall', lamp, [100, 50, 999.9999], [0.6, 0.8, 0], HARD
    yield 'near the rim, below', lamp, [300, 0, 999.99999], SLANTED, HARD
    yield 'near the rim, outside', lamp, [300.0001, 0, 999.9999], [-0.6, 0, 0.8], HARD
    yield 'near the rim, cut', lamp, [300.0001, 0, 999.9999], [-0.6, 0.8, 0], HARD
    yield 'edge on', lamp, [800, 0, 999.999999], [-0.6, 0, 0.8], HARD
    yield 'edge on, cut', lamp, [800, 0, 999.999999], [0, 0.8, 0.6], HARD
    yield 'far', lamp, [3e8, -2e8, -7e8], [-0.48, 0.36, 0.8], HARD
    yield 'far, cut', [1e9, 0, 0, 300, -3, 2, 6], ORIGIN, [1e-7, 0, 1], HARD
    yield 'huge', [0, 0, 1, 1e6, 0, 0, -1], [20, 30, 0], SLANTED, HARD
    yield 'huge, a wall', [0, 0, 1, 1e6, 0, 0, -1], [20, 30, 0], [1, 0, 0], HARD
    yield 'tiny coordinates', [0, 0, 1e-6, 3e-6, 0, 0, -1], [1e-6, 0, 0], SLANTED, HARD
    for k in (2, 6, 10, 13):
        yield f'1e-{k} of it above', [1000, 0, 0, 300, -1, 0, 0], ORIGIN, [-0.3 + 10.0 ** -k, 0, 1], HARD
    for k in (2, 6, 10):
        yield f'1e-{k} of a far one above', [1e6, 0, 0, 1, -1, 0, 0], ORIGIN, [-1e-6 * (1 - 10.0 ** -k), 0, 1], HARD


def balls():
    globe = [700, -600, 2000, 150]
    yield 'before it', globe, [100, 50, 80], UP, EASY
    yield 'slanted', globe, [100, 50, 80], [0.64, 0.6, 0.48], EASY
    yield 'cut by the horizon', [0, 0, 1000, 500], ORIGIN, [1, 0, 0], EASY
    yield 'cut low', [0, 0, 1000, 500], ORIGIN, [0.96, 0, -0.28], EASY
    yield 'below the horizon', [0, 0, 1000, 500], ORIGIN, [0, 0.6, -0.8], EASY
    yield 'near', [0, 0, 1000, 999.999999], ORIGIN, SLANTED, HARD
    yield 'near, a wall', [0, 0, 1000, 999.999999], ORIGIN, [1, 0, 0], HARD
    yield 'far', globe, [-3e8, 5e8, 1e9], [0.36, -0.48, -0.8], HARD
    yield 'far, cut', [1e9, 0, 0, 1], ORIGIN, [1e-10, 0, 1], HARD
    for k in (2, 6, 10, 13):
        yield f'1e-{k} of it above', [1000, 0, 0, 600], ORIGIN, [-0.75 + 10.0 ** -k, 0, 1], HARD


def cylinders():
    tube = [0, 0, 1000, 150, 800, 0, 0, 1]
    turned = [200, -100, 1000, 150, 800, 1, 2, -2]
    coin = [0, 0, 1000, 400, 1, 0.6, 0, 0.8]
    yield 'from below', tube, [50, 30, 0], UP, EASY
    yield 'from below, beside', tube, [500, 30, 0], [-0.48, 0.6, 0.64], EASY
    yield 'beside', tube, [500, 200, 900], [-0.8, 0.6, 0], EASY
    yield 'from above', tube, [-700, 200, 2900], [0.6, 0, -0.8], EASY
    yield 'in the plane of a cap', tube, [500, 200, 600], [-0.8, 0, 0.6], EASY
    yield 'turned', turned, [500, 200, 100], SLANTED, EASY
    yield 'turned, cut', turned, [500, 200, 100], [-0.6, 0.8, 0], EASY
    yield 'below the horizon', tube, [500, 200, 900], [0.8, 0.6, 0], EASY
    yield 'cut across', tube, [500, 0, 900], UP, EASY
    yield 'cut along', tube, [500, 0, 900], [0, 1, 0], EASY
    yield 'cut aslant', tube, [500, 0, 900], [-0.28, 0, 0.96], EASY
    yield 'only a cap and a bit', tube, [160, 0, 0], [-0.96, 0, 0.28], EASY
    yield 'the far arc hidden', tube, [500, 0, 0], [-0.96, 0, 0.28], EASY
    yield 'the middle of an arc', tube, [500, 0, 900], [-0.36, 0, -0.932952303175248], EASY
    yield 'coin', coin, [500, 0, 100], SLANTED, EASY
    yield 'coin, edge on', coin, [800, 0, 400], [-0.8, 0, 0.6], HARD
    yield 'needle', [0, 0, 1000, 1e-4, 2000, 1, 1, 0], [30, 20, 10], UP, HARD
    yield 'close to the side', tube, [150.000001, 0, 900], SLANTED, HARD
    yield 'close to a cap', tube, [20, 30, 599.999999], [0, 0.6, 0.8], HARD
    yield 'close to a rim', tube, [150.000001, 0, 599.99999], [-0.6, 0, 0.8], HARD
    yield 'close to a rim, cut', tube, [150.000001, 0, 599.99999], [0, 0.96, 0.28], HARD
    yield 'far', turned, [3e8, -2e8, -7e8], [-0.48, 0.36, 0.8], HARD
    yield 'far, cut', [1e9, 0, 0, 1, 2, 1, 0, 1], ORIGIN, [1e-10, 0, 1], HARD
    yield 'huge', [0, 0, 2e6, 1e6, 2e6, 0, 1, 0], [10, 20, 999999], UP, HARD
    for k in (2, 6, 10, 13):
        yield (f'1e-{k} of it above', [1000, 0, 0, 100, 400, 0, 0, 1], ORIGIN,
               away_from([900, 0, 200], 100 * 10.0 ** -k), HARD)
        yield (f'1e-{k} of a far one above', [1e6, 0, 0, 1, 4, 0, 0, 1], ORIGIN,
               away_from([999999, 0, 2], 10.0 ** -k), HARD)


def written(x):
    return float(x).hex() if x != int(x) or abs(x) >= 1e15 else str(int(x))


def main():
    print('/* SPDX-License-Identifier: MIT */\n'
          '/* The irradiance by round sources of radiance 1, as two float64 numbers; by make_round_cases.py:\n'
          ' * centre, radius, height of a cylinder, axis of a disk or cylinder. */\n'
          '/* clang-format off */\n'
          'static const struct round_case {\n'
          '    const char *what;\n'
          '    enum kind { DISK, BALL, CYLINDER } kind;\n'
          '    double numbers[8], place_mm[3], normal[3], value, rest;\n'
          '} round_cases[] = {')
    kinds = (('DISK', disks, disk), ('BALL', balls, ball), ('CYLINDER', cylinders, cylinder))
    for kind, cases, irradiance in kinds:
        for what, numbers, place, normal, easy in cases():
            truth = irradiance(place, vector(normal), numbers)
            if abs(truth) < NEGLIGIBLE:
                truth = mpf(0)
            if easy:
                besides = over_surface(kind, numbers, place, normal)
                assert abs(besides - truth) <= SURFACE_AGREES * max(truth, 1e-3), (kind, what, besides, nstr(truth, 10))
            value = float(truth)
            rows = [', '.join(map(written, row)) for row in (numbers, place, normal)]
            print(f'    {{"{what}", {kind},\n     {{{rows[0]}}},\n     {{{rows[1]}}},\n     {{{rows[2]}}},\n'
                  f'     {written(value)}, {written(float(truth - mpf(value)))}}},')
    print('};')


if __name__ == '__main__':
    main()
