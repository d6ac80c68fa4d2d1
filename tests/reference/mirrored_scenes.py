# SPDX-License-Identifier: MIT
"""Light over mirrors by tracing ways back from the element: images of lamps, or of small parts of them, of which each
leg is tested against every surface.  Independent of the library: lamps are mirrored here, and elements there."""
import itertools
import math


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def along(a, t, b):
    return [x + t * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


class Plate:
    """A rectangle as scenes have it."""

    def __init__(self, center, size, axis=(0, 0, 1), up=(0, 1, 0), mirror=False):
        self.center, self.size, self.mirror = list(center), list(size), mirror
        self.axis = unit(axis)
        self.across = unit(cross(up, self.axis))
        self.up = cross(self.axis, self.across)

    def scene(self, **others):
        own = {"mirror": True} if self.mirror else {}
        return {"type": "rectangle", "center": self.center, "size": self.size, "axis": self.axis, "up": self.up,
                **own, **others}

    def meet(self, origin, way):
        """t of the place at which a line meets it, from either side, or None."""
        slope = dot(way, self.axis)
        if slope == 0:
            return None
        t = dot(sub(self.center, origin), self.axis) / slope
        at = sub(along(origin, t, way), self.center)
        inside = abs(dot(at, self.across)) <= self.size[0] / 2 and abs(dot(at, self.up)) <= self.size[1] / 2
        return t if inside else None

    def image(self, place):
        return along(place, -2 * dot(sub(place, self.center), self.axis), self.axis)

    def turned(self, way):
        return along(way, -2 * dot(way, self.axis), self.axis)


class Ball:
    """A sphere as scenes have it."""
    mirror = False

    def __init__(self, center, radius):
        self.center, self.radius = list(center), radius

    def scene(self, **others):
        return {"type": "sphere", "center": self.center, "radius": self.radius, **others}

    def meet(self, origin, way):
        from_center = sub(origin, self.center)
        a, b, c = dot(way, way), dot(from_center, way), dot(from_center, from_center) - self.radius ** 2
        root = b * b - a * c
        if root <= 0:
            return None
        near, far = (-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a
        return near if near > 1e-9 else far


def is_free(surfaces, origin, way, end, skipped):
    """Whether nothing stands between the parameters 0 and `end` of a line, but for what it begins and ends on."""
    for surface in surfaces:
        t = None if surface in skipped else surface.meet(origin, way)
        if t is not None and 1e-12 < t < end * (1 - 1e-12):
            return False
    return True


def word_is_open(surfaces, own, place, word, target, endless=False):
    """Whether the way over some mirrors, from the element on, leads to the target: its last direction, or None."""
    image = target
    for mirror in reversed(word):
        image = mirror.turned(image) if endless else mirror.image(image)
    origin, way, last = place, image if endless else sub(image, place), own
    left = math.inf if endless else 1
    for mirror in word:
        t = mirror.meet(origin, way)
        if t is None or not 1e-12 < t < left or dot(way, mirror.axis) >= 0:
            return None
        if not is_free(surfaces, origin, way, t, (last, mirror)):
            return None
        origin, way, last, left = along(origin, t, way), mirror.turned(way), mirror, left - t
    return image if is_free(surfaces, origin, way, left, (last,)) else None


def words(surfaces, most):
    mirrors = [surface for surface in surfaces if surface.mirror]
    for count in range(most + 1):
        for word in itertools.product(mirrors, repeat=count):
            if all(a is not b for a, b in zip(word, word[1:])):
                yield word


def point_irradiance(surfaces, own, place, normal, lamp, intensity, most):
    """Of a point of even intensity, mm and W/sr; `intensity`: a function of the direction from the lamp, or a number"""
    total = 0
    for word in words(surfaces, most):
        image = word_is_open(surfaces, own, place, word, lamp)
        if image is None:
            continue
        way = sub(image, place)
        square = dot(way, way)
        leaving = [-x for x in way]
        for mirror in word:
            leaving = mirror.turned(leaving)
        strength = intensity(leaving) if callable(intensity) else intensity
        total += strength * 1e6 / square * max(0, dot(normal, way)) / math.sqrt(square)
    return total


def distant_irradiance(surfaces, own, place, normal, towards, irradiance, most):
    total = 0
    for word in words(surfaces, most):
        image = word_is_open(surfaces, own, place, word, towards, True)
        total += irradiance * max(0, dot(normal, image)) if image else 0
    return total


def patches_of_rectangle(lamp, n):
    """Places, normals and areas of its parts."""
    for i, j in itertools.product(range(n), repeat=2):
        at = along(along(lamp.center, ((i + .5) / n - .5) * lamp.size[0], lamp.across),
                   ((j + .5) / n - .5) * lamp.size[1], lamp.up)
        yield at, lamp.axis, lamp.size[0] * lamp.size[1] / n ** 2


def patches_of_ball(center, radius, n):
    for i, j in itertools.product(range(n), range(2 * n)):
        z, phi = (2 * i + 1) / n - 1, math.pi * (j + .5) / n
        normal = [math.sqrt(1 - z * z) * math.cos(phi), math.sqrt(1 - z * z) * math.sin(phi), z]
        yield along(center, radius, normal), normal, 4 * math.pi * radius ** 2 / (2 * n * n)


def area_irradiance(surfaces, own, place, normal, patches, radiance, most):
    total = 0
    for at, facing, area in patches:
        def strength(leaving, facing=facing, area=area):
            return radiance * area * 1e-6 * max(0, dot(leaving, facing)) / math.sqrt(dot(leaving, leaving))
        total += point_irradiance(surfaces, own, place, normal, at, strength, most)
    return total
