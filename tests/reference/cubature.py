# SPDX-License-Identifier: MIT
"""Integrals over extended sources for which no closed form exists: highlights, and the laws 1/(k + r) and 1.

Directions are taken in polar coordinates about the pole in which the lobe is simplest: the half vector H about the
normal (d omega of L is 4 V.H d omega of H), the mirrored view of a Phong lobe, the normal of a diffuse surface.  So
S = cos(theta) there, and the ends S = 0, N.L = 0 and V.H = 0 are known curves.  What bounds the source is cut
into arcs along which phi grows or falls steadily; each meridian then meets each arc in one place, found by bisection.
Along the meridian, and over phi from event to event (corners, turning points, peaks, the known curves), there are
tanh-sinh rules, which forgive what happens at their ends; intervals of phi are halved until two rules agree.

Everything is done twice, with other nodes and other splits; the difference of the two says how certain the result is.
"""
from collections import namedtuple
from functools import lru_cache

import numpy as np
from mpmath import mp, mpf

import extended
from bodies import LONG, Curve, array, as_mpf, body_of, cross, dot, exact, frame

# value, how certain it is (both mpf).
Integral = namedtuple('Integral', 'value certainty')


@lru_cache(None)
def tanh_sinh(steps, real):
    """Nodes in (0, 1), weights, and which nodes belong to the rule of twice the step."""
    reach = 3.2 if real is np.float64 else 3.4
    count = int(reach * steps)
    t = np.arange(-count, count + 1, dtype=LONG) / steps
    quarter = 2 * np.arctan(LONG(1))
    x = 1 / (1 + np.exp(-2 * quarter * np.sinh(t)))
    w = quarter * np.cosh(t) / 2 / np.cosh(quarter * np.sinh(t)) ** 2 / steps
    return x.astype(real), w.astype(real), np.arange(-count, count + 1) % 2 == 0


# The integral.

def polynomial(coefficients, distance_m):
    constant, linear, square = coefficients
    return constant + linear * distance_m + square * distance_m ** 2


class Integrand:
    """Lobe S^n and weight: `half` of the half vector, `mirror` of the mirrored view, `diffuse` max(0, N.L)."""

    def __init__(self, lobe, weight, exponent, normal, view, law, k_mm, real):
        self.lobe, self.weight, self.law = lobe, weight, law
        self.normal = array([normal], real)[0]
        self.view = array([view], real)[0]
        self.pole = self.normal
        if lobe == 'mirror':
            mirrored = extended.subtract(extended.scale(normal, 2 * extended.dot(normal, view)), view)
            self.pole = array([extended.unit(mirrored)], real)[0]
        self.exponent = real(exponent)
        self.k = None if law == 'polynomial' else exact(k_mm, real)
        self.coefficients = [exact(number, real) for number in k_mm] if law == 'polynomial' else None
        self.real = real
        self.first, self.second = frame(self.pole)

    def turn(self, angle):
        """Another zero of phi."""
        c, s = np.cos(self.real(angle)), np.sin(self.real(angle))
        self.first, self.second = c * self.first + s * self.second, c * self.second - s * self.first

    def central(self, r):
        """What has the coordinates theta, phi of the direction r (not a unit vector)."""
        if self.lobe != 'half':
            return r
        return r + np.sqrt(dot(r, r))[..., None] * self.view

    def central_way(self, r, way):
        if self.lobe != 'half':
            return way
        return way + (dot(r, way) / np.sqrt(dot(r, r)))[..., None] * self.view

    def direction(self, theta, tangent):
        """L and the factor of d omega."""
        h = np.cos(theta)[..., None] * self.pole + np.sin(theta)[..., None] * tangent
        if self.lobe != 'half':
            return h, 1
        along = dot(h, self.view)
        return 2 * along[..., None] * h - self.view, np.where(along > 0, 4 * along, 0)

    def tangent(self, phi):
        return np.cos(phi)[..., None] * self.first + np.sin(phi)[..., None] * self.second

    def known_angles(self, tangent):
        """theta at which a meridian meets N.L = 0 and V.H = 0."""
        angles = []
        n_first, n_second = dot(self.normal, self.pole), dot(tangent, self.normal)
        if self.lobe == 'mirror' and self.weight != 'plain':
            angles.append(np.arctan2(np.abs(n_first) + 0 * n_second, -np.copysign(1, n_first) * n_second))
        if self.lobe == 'half':
            v_first, v_second = dot(self.view, self.pole), dot(tangent, self.view)
            angle = np.arctan2(np.abs(v_first) + 0 * v_second, -np.copysign(1, v_first) * v_second)
            angles.append(angle)
            if self.weight != 'plain':
                angles.append(angle / 2)
        return angles

    def split_functions(self, r, way):
        """Functions along a curve whose zeros are events: turning points of phi, peaks of S, known curves."""
        h, h_way = self.central(r), self.central_way(r, way)
        yield dot(self.pole, cross(h, h_way))
        yield dot(self.pole, h_way) * dot(h, h) - dot(self.pole, h) * dot(h, h_way)
        yield dot(self.pole, h)
        if self.weight != 'plain' and self.lobe != 'diffuse':
            yield dot(self.normal, r)

    def known_events(self):
        """phi at which the known curves are special."""
        phis = []
        for vector in ([self.view] if self.lobe == 'half' else [self.normal]):
            phi = np.arctan2(dot(self.second, vector), dot(self.first, vector))
            phis += [phi + i * np.pi / 2 for i in range(4)]
        return phis

    def value(self, theta, tangent, log_top, distance):
        light, factor = self.direction(theta, tangent)
        r = distance(light)
        seen = ~np.isnan(r)
        r = np.where(seen, r, 1)
        s = np.cos(theta)
        with np.errstate(all='ignore'):
            value = np.exp(self.exponent * (np.log(s) - log_top)) * np.sin(theta) * factor
        if self.weight == 'cosine':
            value = value * np.maximum(dot(light, self.normal), 0)
        elif self.weight == 'gated':
            value = np.where(dot(light, self.normal) > 0, value, 0)
        if self.law == 'none':
            value = value * (r / 1000) ** 2
        elif self.law == 'practical':
            value = value * (r / 1000) ** 2 / ((self.k + r) / 1000)
        elif self.law == 'polynomial':
            value = value * (r / 1000) ** 2 / polynomial(self.coefficients, r / 1000)
        return np.where(seen & (s > 0), value, 0)


MonotoneArc = namedtuple('MonotoneArc', 'curve low high phi_low phi_high')


def bisected(function, low, high, steps=70):
    """Zeros of functions with a sign change in each interval."""
    sign = np.sign(function(low))
    for _ in range(steps):
        middle = (low + high) / 2
        same = np.sign(function(middle)) == sign
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return (low + high) / 2


def monotone_arcs(body, integrand, samples=129):
    """The outline, cut wherever something happens to it."""
    arcs, tops = [], []
    for curve in body.curves:
        grid = curve.low + (curve.high - curve.low) * np.arange(samples, dtype=curve.low.dtype) / (samples - 1)
        cuts = [curve.low, curve.high]
        values = list(integrand.split_functions(curve.at(grid), curve.way(grid)))
        for index, value in enumerate(values):
            changes = np.flatnonzero(np.sign(value[:-1]) * np.sign(value[1:]) < 0)
            if len(changes):
                cuts += list(bisected(lambda t, i=index: list(integrand.split_functions(curve.at(t), curve.way(t)))[i],
                                      grid[changes], grid[changes + 1]))
            cuts += list(grid[1:-1][value[1:-1] == 0])
        cuts = np.array(sorted(set(cuts)))
        h = integrand.central(curve.at(cuts))
        with np.errstate(all='ignore'):
            tops += list(dot(h, integrand.pole) / np.sqrt(dot(h, h)))
        spans = list(zip(cuts, cuts[1:]))
        while spans:
            low, high = spans.pop()
            phis = unwrapped(curve, integrand, low, high)
            # A meridian's plane would meet a longer arc twice, once behind the pole.
            if abs(phis[1] - phis[0]) > 1.5 and high - low > 1e-15:
                spans += [(low, (low + high) / 2), ((low + high) / 2, high)]
                continue
            # The pole itself is on every meridian: an arc that begins or ends there begins a little later.
            short = 1e-8 * (high - low)
            arcs.append(MonotoneArc(curve, low + short * in_pole(curve, integrand, low),
                                    high - short * in_pole(curve, integrand, high), *phis))
    return arcs, tops


def phi_of(integrand, h):
    return np.arctan2(dot(h, integrand.second), dot(h, integrand.first))


def in_pole(curve, integrand, t):
    h = integrand.central(curve.at(t))
    beside = cross(h, integrand.pole)
    return dot(beside, beside) < 1e-26 * dot(h, h)


def unwrapped(curve, integrand, low, high):
    """phi at both ends of an arc along which it is steady, the second so that the way between is right."""
    grid = low + (high - low) * np.arange(33, dtype=low.dtype) / 32
    h = integrand.central(curve.at(grid))
    phi = phi_of(integrand, h)
    # Where the arc begins or ends in the pole, phi is that of the way out of it.
    for end, sign in ((0, 1), (-1, -1)):
        if in_pole(curve, integrand, grid[end]):
            way = integrand.central_way(curve.at(grid[end]), curve.way(grid[end]))
            phi[end] = phi_of(integrand, sign * way)
    middle = curve.at((low + high) / 2), curve.way((low + high) / 2)
    sense = np.sign(dot(integrand.pole, cross(integrand.central(middle[0]), integrand.central_way(*middle))))
    two_pi = 8 * np.arctan(type(low)(1))
    steps = np.mod(np.diff(phi) * sense, two_pi)
    steps = np.where(steps > two_pi - 1e-6, steps - two_pi, steps)
    return phi[0], phi[0] + sense * steps.sum()


def meetings(arcs, integrand, phi):
    """theta at which each meridian meets each arc; NaN where it does not.  Shape: meridians, candidates."""
    two_pi = 8 * np.arctan(integrand.real(1))
    meridian, which = [], []
    for index, arc in enumerate(arcs):
        first, last = sorted((arc.phi_low, arc.phi_high))
        for turn in range(int(np.floor((first - phi.max()) / two_pi)), int(np.ceil((last - phi.min()) / two_pi)) + 1):
            hit = np.flatnonzero((phi + turn * two_pi > first) & (phi + turn * two_pi < last))
            meridian.append(hit)
            which.append(np.full(len(hit), index))
    if not meridian:
        return np.full((len(phi), 0), np.nan, dtype=phi.dtype)
    theta = []
    for hit, index in zip(meridian, which):
        column = np.full(len(phi), np.nan, dtype=phi.dtype)
        if len(hit):
            arc = arcs[index[0]]
            tangent = integrand.tangent(phi[hit])
            plane = cross(np.broadcast_to(integrand.pole, tangent.shape), tangent)

            def beside(t):
                return dot(integrand.central(arc.curve.at(t)), plane)

            t = crossing(beside, np.full(len(hit), arc.low), np.full(len(hit), arc.high))
            h = integrand.central(arc.curve.at(t))
            column[hit] = np.arctan2(dot(h, tangent), dot(h, integrand.pole))
            if (column[hit] < -1e-6).any():
                raise ArithmeticError('a meridian meets an arc behind the pole')
        theta.append(column)
    theta = np.stack(theta, axis=1)
    return theta[:, ~np.isnan(theta).all(axis=0)] if theta.size else theta


def crossing(function, low, high):
    """Where a function changes its sign between low and high: false position kept honest by halving."""
    f_low, f_high = function(low), function(high)
    limit = np.finfo(low.dtype).eps * np.maximum(np.abs(low), np.abs(high))
    for step in range(200):
        with np.errstate(all='ignore'):
            middle = low - f_low * (high - low) / (f_high - f_low)
        bad = ~((middle > np.minimum(low, high)) & (middle < np.maximum(low, high)))
        middle = np.where(bad | (step % 3 == 2), (low + high) / 2, middle)
        f = function(middle)
        same = np.sign(f) == np.sign(f_low)
        # Illinois: the end that stays loses half of its weight.
        f_high = np.where(same, f_high / 2, f)
        f_low = np.where(same, f, f_low / 2)
        low, high = np.where(same, middle, low), np.where(same, high, middle)
        done = (np.abs(high - low) <= 2 * limit) | (f == 0)
        if done.all():
            break
    return np.where(f == 0, middle, (low + high) / 2)


class Meridians:
    """The inner integral, for many meridians at once."""

    def __init__(self, body, integrand, arcs, log_top, steps):
        self.body, self.integrand, self.arcs, self.log_top, self.steps = body, integrand, arcs, log_top, steps

    def __call__(self, phi):
        integrand, real = self.integrand, self.integrand.real
        quarter = 2 * np.arctan(real(1))
        tangent = integrand.tangent(phi)
        ends = [np.zeros_like(phi), np.full_like(phi, quarter), *integrand.known_angles(tangent)]
        met = meetings(self.arcs, integrand, phi)
        ends = np.concatenate([np.stack(ends, axis=1), np.where(np.isnan(met), 0, met)], axis=1)
        ends = np.sort(np.clip(ends, 0, quarter), axis=1)
        low, high = ends[:, :-1].ravel(), ends[:, 1:].ravel()
        index = np.repeat(np.arange(len(phi)), ends.shape[1] - 1)
        middle = (low + high) / 2
        light, factor = integrand.direction(middle, tangent[index])
        active = (high > low) & ~np.isnan(self.body.distance(light)) & (factor > 0)
        if integrand.weight != 'plain':
            active &= dot(light, integrand.normal) > 0
        low, high, index = low[active], high[active], index[active]
        result = np.zeros_like(phi)
        if not len(low):
            return result
        for first, last in self.panels(low, high):
            x, w, _ = tanh_sinh(self.steps, real)
            theta = first[:, None] + (last - first)[:, None] * x
            value = integrand.value(theta, tangent[index][:, None, :], self.log_top, self.body.distance)
            np.add.at(result, index, (value @ w) * (last - first))
        return result

    def panels(self, low, high):
        """Where S^n falls fast the interval is cut into panels that follow it."""
        n = float(self.integrand.exponent)
        # S^n has fallen by e^-depth where cos(theta) = cos(low) e^(-depth/n).
        edges = [low]
        for depth in (6, 18, 50):
            with np.errstate(all='ignore'):
                edges.append(np.minimum(high, np.arccos(np.cos(low) * np.exp(-depth / self.integrand.exponent))))
            edges[-1] = np.maximum(edges[-1], edges[-2])
        edges.append(high)
        if n < 6:
            return [(low, high)]
        return [(a, b) for a, b in zip(edges, edges[1:]) if (b > a).any()]


def adaptive(function, panels, steps, real, limit=40):
    """The integral over panels that are halved until the rule agrees with that of twice the step."""
    x, w, coarse = tanh_sinh(steps, real)
    low, high = (np.array(ends, dtype=real) for ends in zip(*panels))
    total = real(0)
    doubt = real(0)
    for depth in range(limit):
        phi = low[:, None] + (high - low)[:, None] * x
        value = function(phi.ravel()).reshape(phi.shape)
        fine = (value @ w) * (high - low)
        rough = 2 * (value[:, coarse] @ w[coarse]) * (high - low)
        size = abs(total) + np.abs(fine).sum()
        off = np.abs(fine - rough)
        good = (off <= 1e-8 * np.abs(fine)) | (off <= 1e-9 * size * 2.0 ** (-depth)) | (np.abs(fine) < 1e-17 * size)
        # Below that there is only rounding.
        good |= (off <= 8 * np.finfo(real).eps * size) | (high - low < 1e-14)
        total += fine[good].sum()
        if good.all():
            return total, doubt
        low, high = low[~good], high[~good]
        if len(low) > 600:
            break
        middle = (low + high) / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    return total + fine[~good].sum(), doubt + off[~good].sum()


def once(shape, place, make, steps, turn, extra, real):
    """One of the two runs: the integral, its remaining doubt, and ln of the factor that belongs to both."""
    body = body_of(shape, place, real)
    integrand = make(real)
    integrand.turn(turn)
    arcs, tops = monotone_arcs(body, integrand)
    polar, factor = integrand.direction(np.zeros(1, dtype=real), integrand.first[None])
    if not np.isnan(body.distance(polar))[0]:
        tops.append(real(1))
    top = max((top for top in tops if np.isfinite(top)), default=real(0))
    # With the pole near the source the bound 1 is as good.
    log_top = np.log(max(top, real(1e-30)))
    if top <= 0:
        # The lobe may still reach what lies inside the outline; it is then near S = 0.
        log_top = real(0)
    two_pi = 8 * np.arctan(real(1))
    events = [arc.phi_low for arc in arcs] + [arc.phi_high for arc in arcs] + integrand.known_events()
    events += [extra + i * two_pi / 3 for i in range(3)]
    events = np.unique(np.mod(np.array(events, dtype=real), two_pi))
    events = np.concatenate([events, [events[0] + two_pi]])
    panels = [(a, b) for a, b in zip(events, events[1:]) if b - a > 1e-18]
    total, doubt = adaptive(Meridians(body, integrand, arcs, log_top, steps), panels, steps, real)
    return total, doubt, log_top * integrand.exponent


def width_of(shape, place):
    """About how narrow the shape looks, in radians."""
    if isinstance(shape, extended.Polygon):
        corners = [extended.subtract(corner, place) for corner in shape.vertices]
        spread = max(extended.length(extended.subtract(a, b)) for a in corners for b in corners)
        near = min(extended.length(corner) for corner in corners)
        far = max(extended.length(corner) for corner in corners)
        depth = abs(extended.dot(corners[0], shape.normal))
        return float(min(shape.area / spread / far, 1) * min(1, depth / far) * min(1, (near + spread) / far))
    away = extended.length(extended.subtract(place, shape.center))
    size = shape.radius / (away + shape.radius)
    if isinstance(shape, extended.Disk):
        size *= abs(extended.dot(extended.subtract(place, shape.center), shape.axis)) / (away + shape.radius)
    return float(size)


def bend_of(shape, place):
    """How far corners that were rounded to float64 lie out of their plane, in parts of its distance."""
    if not isinstance(shape, extended.Polygon):
        return mpf(0)
    depth = abs(extended.dot(extended.subtract(shape.vertices[0], place), shape.normal))
    return max(abs(extended.dot(extended.subtract(corner, shape.vertices[0]), shape.normal))
               for corner in shape.vertices) / depth


def integral(shape, place, lobe, weight, exponent, normal, view, law, k_mm, careful=False):
    """Integral over the shape of (weight) S^n r^2 a(r) d omega, r in metres."""
    if not extended.shines_to(shape, place):
        return Integral(mpf(0), mpf(0))

    def make(real):
        return Integrand(lobe, weight, exponent, normal, view, law, k_mm, real)

    attempts = [(np.float64, 10, 15), (LONG, 14, 20)]
    width = width_of(shape, place)
    if careful or width < 1e-3:
        attempts = attempts[1:]
    result = None
    for real, steps, more in attempts:
        one, doubt, factor = once(shape, place, make, more, 0.0, 0.7, real)
        two, doubt_two, factor_two = once(shape, place, make, steps, 1.234, 2.9, real)
        scale = mp.exp(as_mpf(factor))
        value = as_mpf(one) * scale
        other = as_mpf(two) * mp.exp(as_mpf(factor_two))
        certainty = 2 * abs(value - other) + scale * as_mpf(doubt + doubt_two)
        certainty += abs(value) * (mpf(float(np.finfo(real).eps)) * (16 + 32 / mpf(width)) + 4 * bend_of(shape, place))
        result = Integral(value, certainty)
        if certainty <= mpf('2e-12') * abs(value):
            return result
    return min(result, over_area(shape, place, lobe, weight, exponent, normal, view, law, k_mm),
               key=lambda found: found.certainty)


def over_area(shape, place, lobe, weight, exponent, normal, view, law, k_mm):
    """The same as an integral over the area of a convex polygon whose sight is smooth: far, small or thin ones."""
    unknown = Integral(mpf(0), mp.inf)
    if not isinstance(shape, extended.Polygon):
        return unknown
    corner = array([extended.subtract(shape.vertices[0], place)], LONG)[0]
    sides = array([extended.subtract(other, shape.vertices[0]) for other in shape.vertices[1:]], LONG)
    facing, up, eye = (array([v], LONG)[0] for v in (shape.normal, normal, view))
    depth = -exact(extended.dot(extended.subtract(shape.vertices[0], place), shape.normal), LONG)
    results = []
    for count in (16, 24):
        x, w = gauss(count)
        u, v = np.meshgrid(x, x, indexing='ij')
        weights = np.outer(w, w) * u
        total = LONG(0)
        for first, second in zip(sides, sides[1:]):
            # The sides are differences of exact corners, so a needle keeps its digits.
            r = corner + u[..., None] * (first + v[..., None] * (second - first))
            double = dot(cross(first, second), facing)
            distance = np.sqrt(dot(r, r))
            light = r / distance[..., None]
            height = dot(light, up)
            if lobe == 'half':
                between = light + eye
                s = dot(between, up) / np.sqrt(dot(between, between))
            else:
                s = 2 * height * dot(up, eye) - dot(light, eye) if lobe == 'mirror' else height
            if double <= 0 or (s <= 0).any() != (s <= 0).all() or (height <= 0).any() != (height <= 0).all():
                return unknown
            value = np.where(s > 0, np.power(np.maximum(s, 1e-300), LONG(float(exponent))), 0)
            if weight != 'plain':
                value = np.where(height > 0, value, 0)
            if weight == 'cosine':
                value = value * height
            if law == 'polynomial':
                law_m = 1 / polynomial([exact(number, LONG) for number in k_mm], distance / 1000)
            elif law == 'practical':
                law_m = 1 / ((exact(k_mm, LONG) + distance) / 1000)
            else:
                law_m = 1 if law == 'none' else 1 / (distance / 1000) ** 2
            total += (weights * value * depth / distance * law_m).sum() * double / 1000000
        results.append(total)
    value = as_mpf(results[1])
    return Integral(value, 10 * abs(value - as_mpf(results[0])) + abs(value) * mpf('2e-12'))


@lru_cache(None)
def gauss(count):
    """Nodes and weights of Gauss on (0, 1)."""
    with mp.workdps(30):
        nodes = []
        for start in np.polynomial.legendre.leggauss(count)[0]:
            x = mp.findroot(lambda t: mp.legendre(count, t), mpf(float(start)))
            slope = count * (x * mp.legendre(count, x) - mp.legendre(count - 1, x)) / (x * x - 1)
            nodes.append(((1 + x) / 2, 1 / ((1 - x * x) * slope ** 2)))
        return tuple(np.array([exact(pair[i], LONG) for pair in nodes], dtype=LONG) for i in (0, 1))


# The outline integral of extended.py, faster: in extended precision, and how certain it is.

def irradiance(shape, place, normal):
    """By the law 1/r^2, for a radiance of 1.  A polygon's is exact to the 50 digits."""
    if isinstance(shape, extended.Polygon) or not extended.shines_to(shape, place):
        return Integral(extended.irradiance(shape, place, normal), mpf(0))
    pieces = extended.outline(shape, place)
    if extended.all_below(pieces, normal):
        return Integral(mpf(0), mpf(0))
    up = array([normal], LONG)[0]
    total, doubt, size = LONG(0), LONG(0), LONG(0)
    for piece in pieces:
        curve = Curve(piece, LONG)

        def squared(t):
            at = curve.at(t)
            height = np.minimum(dot(at, up), 0)
            return dot(at, at) - height * height

        def integrand(t):
            return dot(up, cross(curve.at(t), curve.way(t))) / squared(t)

        grid = curve.low + (curve.high - curve.low) * np.arange(257, dtype=LONG) / 256
        height = dot(curve.at(grid), up)
        cuts = [curve.low, curve.high]
        changes = np.flatnonzero(np.sign(height[:-1]) * np.sign(height[1:]) < 0)
        if len(changes):
            cuts += list(bisected(lambda t: dot(curve.at(t), up), grid[changes], grid[changes + 1]))
        near = squared(grid)
        least = 1 + np.flatnonzero((near[1:-1] <= near[:-2]) & (near[1:-1] <= near[2:]))
        cuts += list(golden(squared, grid[least - 1], grid[least + 1])) if len(least) else []
        cuts = sorted(set(cuts))
        part = [adaptive(integrand, list(zip(cuts, cuts[1:])), steps, LONG) for steps in (14, 20)]
        whole = adaptive(lambda t: np.abs(integrand(t)), list(zip(cuts, cuts[1:])), 10, LONG)[0]
        doubt += 2 * abs(part[0][0] - part[1][0]) + part[1][1]
        size += whole
        total += part[1][0] if piece.low < piece.high else -part[1][0]
    doubt += 64 * np.finfo(LONG).eps * size
    value = -as_mpf(total) / 2 + (mp.pi if extended.holds_nadir(pieces, normal) else 0)
    certainty = as_mpf(doubt)
    if certainty > mpf('1e-15') * abs(value) and certainty > 0:
        return Integral(*extended.around_outline(pieces, normal))
    return Integral(max(value, mpf(0)), certainty)


def golden(function, low, high):
    for _ in range(60):
        c, d = low + (high - low) * LONG(0.382), low + (high - low) * LONG(0.618)
        left = function(c) < function(d)
        low, high = np.where(left, low, c), np.where(left, d, high)
    return (low + high) / 2
