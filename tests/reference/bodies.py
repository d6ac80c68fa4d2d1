# SPDX-License-Identifier: MIT
"""The shapes of extended.py as an element sees them, in NumPy: what bounds them, and how far they are along directions.

Lengths are millimetres, the element is at the origin.  `real` is the type that the numbers have, np.float64 or
np.longdouble.
"""
import math

import numpy as np
from mpmath import mpf

import extended

LONG = np.longdouble


def exact(number, real):
    """An mpf as a NumPy real without losing more digits than the type does."""
    high = float(number)
    if real is not LONG or not math.isfinite(high):
        return real(high)
    return LONG(high) + LONG(float(number - mpf(high)))


def array(vectors, real):
    return np.array([[exact(x, real) for x in v] for v in vectors], dtype=real)


def as_mpf(number):
    high = float(number)
    return mpf(high) + (mpf(float(number - type(number)(high))) if math.isfinite(high) else 0)


def dot(a, b):
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def cross(a, b):
    return np.stack([a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1], a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
                     a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]], axis=-1)


def unit(a):
    return a / np.sqrt(dot(a, a))[..., None]


def frame(pole):
    least = np.argmin(np.abs(pole))
    other = np.zeros(3, dtype=pole.dtype)
    other[least] = 1
    first = unit(cross(pole, other))
    return first, cross(pole, first)


# Shapes as seen from the element, which is at the origin.

class Curve:
    """r(t) on an interval: a straight edge or an arc of a circle."""

    def __init__(self, piece, real):
        self.straight = isinstance(piece.r, extended.Straight)
        self.parts = array(piece.r, real)
        self.low, self.high = (exact(t, real) for t in sorted((piece.low, piece.high)))

    def at(self, t):
        t = np.asarray(t)[..., None]
        if self.straight:
            return self.parts[0] + t * self.parts[1]
        return self.parts[0] + np.cos(t) * self.parts[1] + np.sin(t) * self.parts[2]

    def way(self, t):
        t = np.asarray(t)[..., None]
        if self.straight:
            return self.parts[1] + 0 * t
        return np.cos(t) * self.parts[2] - np.sin(t) * self.parts[1]


class FlatBody:
    """A polygon or a disk."""

    def __init__(self, shape, place, real):
        if isinstance(shape, extended.Polygon):
            corners = [extended.subtract(corner, place) for corner in shape.vertices]
            pieces = [extended.Piece(extended.Straight(a, extended.subtract(b, a)), mpf(0), mpf(1))
                      for a, b in zip(corners, corners[1:] + corners[:1])]
            normal, self.radius = shape.normal, None
            self.origin = array(corners[:1], real)[0]
        else:
            pieces = extended.outline(shape, place)
            normal, self.radius = shape.axis, exact(shape.radius, real)
            self.origin = array([extended.subtract(shape.center, place)], real)[0]
            corners = [extended.subtract(shape.center, place)]
        self.curves = [Curve(piece, real) for piece in pieces]
        self.normal = array([normal], real)[0]
        self.depth = exact(extended.dot(corners[0], normal), real)
        if self.radius is None:
            wide, high = extended.beside(normal)
            self.wide, self.high = array([wide, high], real)
            flat = [extended.subtract(corner, corners[0]) for corner in corners]
            self.flat = np.array([[exact(extended.dot(c, wide), real), exact(extended.dot(c, high), real)]
                                  for c in flat], dtype=real)

    def distance(self, direction):
        """Along the direction to the shape; NaN where it misses."""
        with np.errstate(all='ignore'):
            r = self.depth / dot(direction, self.normal)
        r = np.where(np.isfinite(r), r, -1)
        # p is the place that is met, from the origin of the shape: r L - origin, without cancellation.
        p = cross(self.normal, cross(direction, self.origin)) * (r / self.depth)[..., None]
        if self.radius is not None:
            inside = dot(p, p) <= self.radius ** 2
        else:
            x, y = dot(p, self.wide), dot(p, self.high)
            inside = np.zeros(x.shape, dtype=bool)
            for (x0, y0), (x1, y1) in zip(self.flat, np.roll(self.flat, -1, axis=0)):
                if y0 != y1:
                    with np.errstate(all='ignore'):
                        inside ^= ((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) / (y1 - y0) * (x1 - x0))
        return np.where(inside & (r > 0), r, np.nan)


class RoundBody:
    """A ball or the side of a cylinder."""

    def __init__(self, shape, place, real):
        self.curves = [Curve(piece, real) for piece in extended.outline(shape, place)]
        self.center = array([extended.subtract(shape.center, place)], real)[0]
        self.radius = exact(shape.radius, real)
        self.axis = None
        if isinstance(shape, extended.Side):
            self.axis, self.half = array([shape.axis], real)[0], exact(shape.height / 2, real)

    def distance(self, direction):
        if self.axis is None:
            along = dot(direction, self.center)
            beside = cross(direction, self.center)
            root = self.radius ** 2 - dot(beside, beside)
            with np.errstate(all='ignore'):
                r = along - np.sqrt(root)
            return np.where(r > 0, r, np.nan)
        flat = direction - dot(direction, self.axis)[..., None] * self.axis
        center = self.center - dot(self.center, self.axis) * self.axis
        size = dot(flat, flat)
        beside = dot(cross(flat, center), self.axis)
        with np.errstate(all='ignore'):
            r = (dot(flat, center) - np.sqrt(size * self.radius ** 2 - beside ** 2)) / size
            level = r * dot(direction, self.axis) - dot(self.center, self.axis)
        return np.where((r > 0) & (np.abs(level) <= self.half), r, np.nan)


def body_of(shape, place, real):
    kind = FlatBody if isinstance(shape, (extended.Polygon, extended.Disk)) else RoundBody
    return kind(shape, place, real)
