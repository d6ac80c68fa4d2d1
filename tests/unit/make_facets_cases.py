# SPDX-License-Identifier: MIT
"""Writes facets_cases.h: the irradiance by facets, computed with 80 digits.

    make_facets_cases.py > facets_cases.h

Every face is a source of its own here, cut into signed triangles from its first corner; each is cut by the planes of
the horizon and of the face, and Lambert's sum is taken over its edges with so many digits that it may cancel.  Where
nothing is cut, the integral over the triangles' areas is computed numerically besides and must agree.
"""
import math

from mpmath import atan2, cos, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 80
CHECKED_DIGITS = 15
ROUNDINGS = mpf(10) ** -65


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


def triangles_of(face):
    """Triangles from the first corner, each with +1 or -1: where it turns the other way it is to be taken away."""
    all_of_it = [mpf(0)] * 3
    found = []
    for i in range(1, len(face) - 1):
        area = cross(sub(face[i], face[0]), sub(face[i + 1], face[0]))
        all_of_it = add(all_of_it, area)
        found.append(([face[0], face[i], face[i + 1]], area))
    for corners, area in found:
        sign = dot(area, all_of_it)
        if sign > 0:
            yield corners, 1
        elif sign < 0:
            yield corners[::-1], -1


def lambert(corners, place, normal):
    area = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
    if dot(area, sub(place, corners[0])) <= 0:
        return mpf(0), False
    ways = [sub(corner, place) for corner in corners]
    heights = [dot(normal, way) for way in ways]
    seen = []
    for i, (way, height) in enumerate(zip(ways, heights)):
        following, beyond = ways[(i + 1) % len(ways)], heights[(i + 1) % len(ways)]
        if height >= 0:
            seen.append(way)
        if height * beyond < 0:
            seen.append(add(way, mul(sub(following, way), height / (height - beyond))))
    total = mpf(0)
    for i, a in enumerate(seen):
        b = seen[(i + 1) % len(seen)]
        g = cross(a, b)
        if length(g) > 0:
            total -= atan2(length(g), dot(a, b)) * dot(normal, g) / length(g)
    return total / 2, min(heights) >= 0


def by_area(corners, place, normal):
    u, v = sub(corners[1], corners[0]), sub(corners[2], corners[0])
    area = cross(u, v)

    def value(s, t):
        r = sub(add(corners[0], add(mul(u, s * (1 - t)), mul(v, s * t))), place)
        return s * dot(normal, r) * -dot(area, r) / dot(r, r) ** 2

    with mp.workdps(25):
        return quad(value, [0, 1], [0, 1], maxdegree=5)


def irradiance(faces, place, normal, checked):
    total = mpf(0)
    for face in faces:
        for corners, sign in triangles_of(face):
            value, whole = lambert(corners, place, normal)
            if checked and whole and value > 0:
                other = by_area(corners, place, normal)
                assert abs(other - value) < mpf(10) ** -CHECKED_DIGITS * value, (corners, nstr(value, 20), other)
            total += sign * value
    return total


# ---- shapes: the numbers that the library is given, and the faces ----

def rectangle(center, size, axis, up):
    normal = unit(vector(axis))
    across = unit(cross(vector(up), normal))
    upward = cross(normal, across)
    corners = [add(vector(center), add(mul(across, x * mpf(size[0]) / 2), mul(upward, y * mpf(size[1]) / 2)))
               for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return "RECTANGLE", [*center, *size, *axis, *up], [corners]


def outline(*corners):
    return "OUTLINE", [x for corner in corners for x in corner], [[vector(corner) for corner in corners]]


def box(center, size):
    corners = [[mpf(center[k]) + (1 if i >> k & 1 else -1) * mpf(size[k]) / 2 for k in range(3)] for i in range(8)]
    loops = (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)
    return "BOX", [*center, *size], [[corners[i] for i in loop] for loop in loops]


def sphere(center, radius, meridians):
    bands = max(2, meridians // 2)

    def corner(band, step):
        if band in (0, bands):
            return add(vector(center), [0, 0, mpf(radius) * (1 if band == 0 else -1)])
        t, p = pi * band / bands, 2 * pi * step / meridians
        return add(vector(center), mul([sin(t) * cos(p), sin(t) * sin(p), cos(t)], mpf(radius)))

    faces = []
    for band in range(bands):
        for step in range(meridians):
            face = [corner(band, step), corner(band + 1, step), corner(band + 1, step + 1), corner(band, step + 1)]
            faces.append(face[:3] if band == 0 else face[:2] + face[3:] if band == bands - 1 else face)
    return "SPHERE", [*center, radius, meridians], faces


def cylinder(center, radius, height, axis, sides):
    up = [0, 0, 1] if axis[0] == axis[2] == 0 else [0, 1, 0]
    along = unit(vector(axis))
    across = unit(cross(vector(up), along))
    upward = cross(along, across)
    half = mul(along, mpf(height) / 2)
    rim = [add(vector(center), mul(add(mul(across, cos(2 * pi * i / sides)), mul(upward, sin(2 * pi * i / sides))),
                                   mpf(radius))) for i in range(sides)]
    low, high = [sub(corner, half) for corner in rim], [add(corner, half) for corner in rim]
    faces = [[low[i], low[(i + 1) % sides], high[(i + 1) % sides], high[i]] for i in range(sides)]
    return "CYLINDER", [*center, radius, height, *axis, sides], [*faces, high, low[::-1]]


# ---- cases ----

DOWN, UP, Y = [0, 0, -1], [0, 0, 1], [0, 1, 0]
ORIGIN = [0, 0, 0]
SLANTED = [0.48, -0.6, 0.64]
PANEL = rectangle([0, 0, 1000], [600, 400], DOWN, Y)
TILTED = rectangle([100, -200, 900], [600, 400], [2, 3, -10], [0.1, 1, 0])
NEEDLE = rectangle([0, 0, 1000], [1, 0.0001], DOWN, Y)
ARROW = outline([0, 0, 800], [300, -300, 800], [-400, 0, 800], [300, 300, 800])
SLOPE = outline([0, 0, 500], [0, 600, 500], [300, 600, 800], [300, 300, 800], [150, 300, 650], [150, 0, 650])
CUBE = box([0, 0, 3000], [1000, 1000, 1000])
BALL = sphere([200, 100, 900], 300, 9)
PRISM = cylinder([0, 0, 1000], 200, 500, [1, 0.5, -0.3], 7)


def cases():
    for name, shape in (("panel", PANEL), ("tilted", TILTED), ("arrow", ARROW), ("slope", SLOPE), ("cube", CUBE),
                        ("ball", BALL), ("prism", PRISM)):
        yield name, shape, ORIGIN, UP
        yield name + ", slanted element", shape, [250, -300, 20], SLANTED
        yield name + ", wall", shape, [-500, 0, 100], [1, 0, 0]
        yield name + ", turned away", shape, [250, -300, 20], DOWN
        yield name + ", from far", shape, [3e5, -2e5, -7e5], [-0.48, 0.36, 0.8]
        yield name + ", from a million sizes", shape, [5e8, 2e8, -3e8], [-0.6, 0, 0.8]
        yield name + ", element behind", shape, [10, 20, 5000], DOWN
    yield "in the plane", PANEL, [500, 0, 1000], [-1, 0, 0]
    yield "in the plane, slanted", TILTED, [100 + 1000, -200, 900 + 200], [-1, 0, 0]
    yield "on an edge's line", PANEL, [500, 200, 1000], [-0.6, 0, 0.8]
    yield "right below an edge's line", PANEL, [500, 200, 999.9999999999], [-1, 0, 0]
    yield "0.001 mm below the plane, upwards", PANEL, [500, 100, 999.999], UP
    yield "1e-9 mm below the plane, upwards", PANEL, [500, 100, 999.999999999], UP
    yield "1 nm below the plane, sideways", PANEL, [500, 100, 999.999999], [-1, 0, 0]
    yield "in the plane of a box's face beside it", CUBE, [700, 20, 2500], [-0.6, 0, 0.8]
    yield "on the line of a box's edge", CUBE, [700, 500, 2500], [-0.6, 0, 0.8]
    for k in (3, 6):
        size = 10.0 ** k
        yield f"1e{k} times smaller", rectangle([0, 0, 1000], [1000 / size, 700 / size], DOWN, Y), ORIGIN, SLANTED
        yield f"1e{k} times larger", rectangle([0, 0, 1000], [1000 * size, 700 * size], DOWN, Y), ORIGIN, SLANTED
        yield f"near 1e{k} times", PANEL, [100, 50, 1000 - 600 / size], [0.6, 0, 0.8]
        yield f"near a corner 1e{k} times", PANEL, [300 + 500 / size, 200, 1000 - 600 / size], [-0.6, 0, 0.8]
        yield f"box 1e{k} times smaller", box([0, 0, 1000], [1000 / size] * 3), [1, 2, 3], SLANTED
        yield f"beside a box 1e{k} times", CUBE, [500 + 500 / size, 100, 3050], [-0.6, 0, 0.8]
    yield "needle", NEEDLE, ORIGIN, UP
    yield "needle, slanted element", NEEDLE, [300, 200, 10], SLANTED
    yield "needle, end on", NEEDLE, [1000, 0, 999], [-0.6, 0, 0.8]
    yield "needle, near", NEEDLE, [0.3, 0, 999.99], UP
    yield "needle, tilted", rectangle([0, 0, 1000], [1, 0.0001], [0.3, 0.2, -1], [0.5, 1, 0]), [30, 20, 10], UP
    yield "horizon through the middle", PANEL, [-1000, 0, 1000 - 500], [math.sqrt(0.2), 0, math.sqrt(0.8)]
    yield "horizon through a corner", outline([0, 0, 0], [400, 0, 400], [0, 300, 400]), [-500, 0, 0], UP
    yield "horizon along an edge, above", outline([0, 0, 0], [0, 300, 0], [0, 0, 400]), [-500, 10, 0], UP
    yield "horizon along an edge, below", outline([0, 0, -400], [0, 0, 0], [0, 300, 0]), [-500, 10, 0], UP
    for k in (1, 3, 6, 8, 10, 12):
        low = 1000.0 / 10 ** k
        yield f"1e-{k} of an edge above", outline([0, 0, -400], [0, 0, low], [0, 300, low]), [-500, 10, 0], UP
        yield f"1e-{k} of a corner above", outline([0, -300, -400], [0, 0, low], [0, 300, -500]), [-500, 10, 0], UP
        yield (f"1e-{k} of a box's corner above",
               box([0, 0, -250], [300, 200, 500 + 2 * low]), [-500, 400, 0], UP)
        tilt = 10.0 ** -k
        yield f"edge, tilted by 1e-{k}", PANEL, [-1300, 0, 0], [-math.sqrt(0.5) - tilt, 0, math.sqrt(0.5)]
    yield "small, above the horizon by its size", rectangle([1000, 0, 1], [1, 1], [-1, 0, 0], UP), ORIGIN, UP
    yield "small, across the horizon", rectangle([1000, 0, 0.1], [1, 1], [-1, 0, 0], UP), ORIGIN, UP
    yield "tiny coordinates", rectangle([0, 0, 1e-6], [1e-6, 2e-6], DOWN, Y), [1e-6, 0, 0], UP
    yield "large coordinates", rectangle([3e8, 1e8, 1e9], [1e9, 2e9], DOWN, Y), [1, 2, 3], UP


def written(x):
    return float(x).hex() if x != int(x) or abs(x) >= 1e15 else str(int(x))


def wrapped(numbers):
    lines, line = [], "       "
    for text in numbers:
        if len(line) + len(text) + 2 > 118:
            lines.append(line)
            line = "       "
        line += " " + text + ","
    return "\n".join([*lines, line])


def main():
    print("/* SPDX-License-Identifier: MIT */\n"
          "/* The irradiance by facets of radiance 1, as two float64 numbers; by make_facets_cases.py. */\n"
          "/* clang-format off */\n"
          "static const struct facets_case {\n"
          "    const char *what;\n"
          "    enum kind { RECTANGLE, OUTLINE, BOX, SPHERE, CYLINDER } kind;\n"
          "    unsigned count;\n"
          "    double numbers[18], place_mm[3], normal[3], value, rest;\n"
          "} facets_cases[] = {")
    for name, (shape, numbers, faces), place, normal in cases():
        plain = "million" not in name and "1e" not in name and "needle" not in name and "plane" not in name
        truth = irradiance(faces, vector(place), vector(normal), plain and len(faces) <= 6)
        if abs(truth) < ROUNDINGS:
            truth = mpf(0)
        value = float(truth)
        lines = [f'{{{", ".join(map(written, place))}}}, {{{", ".join(map(written, normal))}}},',
                 f'{written(value)}, {written(float(truth - mpf(value)))}}},']
        gap = " " if len(lines[0]) + len(lines[1]) + 6 <= 120 else "\n     "
        print(f'    {{"{name}", {shape}, {len(numbers)}, {{\n{wrapped(map(written, numbers))}\n     }},\n'
              f'     {gap.join(lines)}')
    print("};")


if __name__ == "__main__":
    main()
