# SPDX-License-Identifier: MIT
"""Planar and volumetric sources in 50-digit arithmetic: what a light of a scene means, its irradiance by the law
1/r^2, and the points that stand for it when it is cut into parts.

A source is a list of shapes, each of which shines from one side: polygons, disks, balls, the sides of cylinders.
The irradiance of a polygon is Lambert's sum over its edges, clipped to the element's horizon.  That of a round shape
is half the integral of sin^2(theta) dphi along its outline (theta, phi polar angles about the normal), where theta is
held at 90 degrees below the horizon:

    E = -radiance/2 * integral of N.(r x dr) / (r.r - min(0, N.r)^2),

which needs neither the cone's own frame nor the points where the horizon closes the outline.
"""
from collections import namedtuple

from mpmath import mp, mpf

mp.dps = 50

Polygon = namedtuple('Polygon', 'vertices normal area')          # counter-clockwise seen from the lit side
Disk = namedtuple('Disk', 'center radius axis frame')            # shines along its axis; frame: where parts begin
Ball = namedtuple('Ball', 'center radius')
Side = namedtuple('Side', 'center radius height axis')           # of a cylinder, without its caps
# W/(sr m^2); k in mm, or of the polynomial law its coefficients
Source = namedtuple('Source', 'shapes radiance attenuation k')


# Vectors are lists of three numbers.

def vector(numbers):
    return [mpf(number) for number in numbers]


def add(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def scale(a, factor):
    return [x * factor for x in a]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return mp.sqrt(dot(a, a))


def unit(a):
    return scale(a, 1 / length(a))


def beside(axis):
    """Two unit vectors that make a right-handed frame with the axis."""
    least = min(range(3), key=lambda i: abs(axis[i]))
    first = unit(cross(axis, [mpf(i == least) for i in range(3)]))
    return first, cross(axis, first)


# Shapes.

def polygon(vertices):
    twice = [mpf(0)] * 3
    for a, b in zip(vertices, vertices[1:] + vertices[:1]):
        twice = add(twice, cross(subtract(a, vertices[0]), subtract(b, vertices[0])))
    return Polygon(vertices, unit(twice), length(twice) / 2)


def rectangle_frame(mapping, default_axis):
    """Center, unit vectors along w and h, and the axis of anything that lies as a rectangle does."""
    center = vector(mapping['center'])
    axis = mapping.get('axis', default_axis)
    axis = unit(subtract(vector(mapping['aim']), center) if 'aim' in mapping else vector(axis))
    up = vector(mapping.get('up', [0, 1, 0]))
    if 'up' not in mapping and length(cross(up, axis)) < mpf('1e-30'):
        up = vector([0, 0, 1])
    high = unit(add(up, axis, -dot(up, axis)))
    return center, cross(high, axis), high, axis


def rectangle_corners(mapping, default_axis):
    """The corners, counter-clockwise as seen from where the axis points to."""
    center, wide, high, _ = rectangle_frame(mapping, default_axis)
    w, h = (mpf(size) / 2 for size in mapping['size'])
    return [add(add(center, wide, i * w), high, j * h) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def usual_frame(axis):
    """The directions of w and h of a rectangle with this axis; facets and parts of round shapes begin along w."""
    _, wide, high, _ = rectangle_frame({'center': [0, 0, 0], 'axis': axis}, None)
    return wide, high


def axis_or_aim(mapping, default):
    if 'aim' in mapping:
        return unit(subtract(vector(mapping['aim']), vector(mapping['center'])))
    return unit(vector(mapping.get('axis', default)))


def hull_faces(loops):
    """Polygons, each turned so that it shines away from the middle of them all."""
    corners = [corner for loop in loops for corner in loop]
    middle = scale([mp.fsum(column) for column in zip(*corners)], mpf(1) / len(corners))
    faces = []
    for loop in loops:
        face = polygon(loop)
        inwards = dot(face.normal, subtract(loop[0], middle)) < 0
        faces.append(polygon(loop[::-1]) if inwards else face)
    return faces


def box_faces(box):
    center, half = vector(box['center']), [mpf(size) / 2 for size in box['size']]
    loops = []
    for axis in range(3):
        across, along = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            loop = []
            for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = list(center)
                corner[axis] += sign * half[axis]
                corner[across] += i * half[across]
                corner[along] += j * half[along]
                loop.append(corner)
            loops.append(loop)
    return hull_faces(loops)


def globe_faces(sphere):
    """The polyhedron of N meridians, the first at +x, and N/2 bands of equal latitude, poles along z."""
    center, radius, meridians = vector(sphere['center']), mpf(sphere['radius']), sphere['facets']
    bands = max(2, meridians // 2)

    def corner(band, meridian):
        polar, turn = mp.pi * band / bands, 2 * mp.pi * meridian / meridians
        ring = mp.sin(polar) if 0 < band < bands else mpf(0)
        return add(center, [ring * mp.cos(turn), ring * mp.sin(turn), mp.cos(polar)], radius)

    loops = []
    for meridian in range(meridians):
        for band in range(bands):
            loop = [corner(band, meridian), corner(band + 1, meridian), corner(band + 1, meridian + 1),
                    corner(band, meridian + 1)]
            if band == 0:
                loop = loop[:3]
            elif band == bands - 1:
                loop = [loop[0], loop[1], loop[3]]
            loops.append(loop)
    return hull_faces(loops)


def prism_faces(cylinder):
    """The inscribed prism."""
    center, radius, sides = vector(cylinder['center']), mpf(cylinder['radius']), cylinder['facets']
    axis = unit(vector(cylinder.get('axis', [0, 0, 1])))
    first, second = usual_frame(axis)
    rim = []
    for side in range(sides):
        turn = 2 * mp.pi * side / sides
        rim.append(add(scale(first, radius * mp.cos(turn)), second, radius * mp.sin(turn)))
    half = scale(axis, mpf(cylinder['height']) / 2)
    top = [add(add(center, half), corner) for corner in rim]
    bottom = [add(add(center, half, -1), corner) for corner in rim]
    loops = [top, bottom]
    loops += [[bottom[i - 1], bottom[i], top[i], top[i - 1]] for i in range(sides)]
    return hull_faces(loops)


def mesh_faces(corners, loops):
    """Faces of a mesh as its file gives them: counter-clockwise from outside."""
    return [polygon([vector(corners[index]) for index in loop]) for loop in loops]


def area(shape):
    """mm^2"""
    if isinstance(shape, Polygon):
        return shape.area
    if isinstance(shape, Disk):
        return mp.pi * shape.radius ** 2
    if isinstance(shape, Ball):
        return 4 * mp.pi * shape.radius ** 2
    return 2 * mp.pi * shape.radius * shape.height


def shapes_of(light):
    """The shapes of a planar or volume light.  A mesh comes as {'corners': …, 'faces': …} under the key 'solid'."""
    if 'vertices' in light:
        return [polygon([vector(corner) for corner in light['vertices']])]
    if 'rectangle' in light:
        return [polygon(rectangle_corners(light['rectangle'], [0, 0, -1]))]
    if 'disk' in light:
        disk = light['disk']
        axis = axis_or_aim(disk, [0, 0, -1])
        return [Disk(vector(disk['center']), mpf(disk['radius']), axis, usual_frame(axis))]
    if 'box' in light:
        return box_faces(light['box'])
    if 'sphere' in light:
        sphere = light['sphere']
        if 'facets' in sphere:
            return globe_faces(sphere)
        return [Ball(vector(sphere['center']), mpf(sphere['radius']))]
    if 'cylinder' in light:
        cylinder = light['cylinder']
        if 'facets' in cylinder:
            return prism_faces(cylinder)
        center, radius, height = vector(cylinder['center']), mpf(cylinder['radius']), mpf(cylinder['height'])
        axis = unit(vector(cylinder.get('axis', [0, 0, 1])))
        frame = usual_frame(axis)
        return [Side(center, radius, height, axis), Disk(add(center, axis, height / 2), radius, axis, frame),
                Disk(add(center, axis, -height / 2), radius, scale(axis, -1), frame)]
    return mesh_faces(light['solid']['corners'], light['solid']['faces'])


def turned(shape):
    """The other side of a flat one."""
    if isinstance(shape, Polygon):
        return polygon(shape.vertices[::-1])
    axis = scale(shape.axis, -1)
    return Disk(shape.center, shape.radius, axis, usual_frame(axis))


def source_of(light):
    shapes = shapes_of(light)
    square_metres = mp.fsum(area(shape) for shape in shapes) / 10 ** 6
    shining = square_metres
    if light.get('sides') == 'both':
        shapes = shapes + [turned(shape) for shape in shapes]
        shining = 2 * square_metres
    if 'radiance' in light:
        radiance = mpf(light['radiance'])
    elif 'intensity' in light:
        radiance = mpf(light['intensity']) / square_metres
    else:
        radiance = mpf(light['power']) / (mp.pi * shining)
    k = mpf(light.get('k', 0))
    if light['attenuation'] == 'polynomial':
        k = vector(light['coefficients'])
    return Source(shapes, radiance, light['attenuation'], k)


def shines_to(shape, place):
    """Whether the place is on the side that the shape shines to (so it can see some of it)."""
    if isinstance(shape, Polygon):
        return dot(subtract(place, shape.vertices[0]), shape.normal) > 0
    away = subtract(place, shape.center)
    if isinstance(shape, Disk):
        return dot(away, shape.axis) > 0
    if isinstance(shape, Ball):
        return length(away) > shape.radius
    return length(cross(away, shape.axis)) > shape.radius


def touches(shape, place):
    """Whether the place lies on the shape, its edges included (to what 50 digits can tell)."""
    tiny = mpf('1e-30')
    if isinstance(shape, Polygon):
        size = mp.sqrt(shape.area)
        corners = [subtract(corner, place) for corner in shape.vertices]
        if abs(dot(corners[0], shape.normal)) > tiny * size:
            return False
        turn = mpf(0)
        for a, b in zip(corners, corners[1:] + corners[:1]):
            along = dot(cross(a, b), shape.normal)
            if abs(along) <= tiny * size * size and dot(a, b) <= tiny * size * size:
                return True
            turn += mp.atan2(along, dot(a, b))
        return abs(turn) > mp.pi
    away = subtract(place, shape.center)
    near = tiny * shape.radius
    if isinstance(shape, Ball):
        return abs(length(away) - shape.radius) <= near
    height, beside = dot(away, shape.axis), length(cross(away, shape.axis))
    if isinstance(shape, Disk):
        return abs(height) <= near and beside <= shape.radius + near
    return abs(beside - shape.radius) <= near and abs(height) <= shape.height / 2 + near


# Irradiance by the law 1/r^2, for a radiance of 1.

def irradiance(shape, place, normal):
    if not shines_to(shape, place):
        return mpf(0)
    if isinstance(shape, Polygon):
        return lambert([subtract(corner, place) for corner in shape.vertices], normal)
    return around_outline(outline(shape, place), normal)[0]


def clipped(corners, normal):
    """The part of a polygon above the element's horizon."""
    result = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        above_a, above_b = dot(a, normal), dot(b, normal)
        if above_a >= 0:
            result.append(a)
        if above_a * above_b < 0:
            result.append(add(a, subtract(b, a), above_a / (above_a - above_b)))
    return result


def lambert(corners, normal):
    """Corners relative to the element."""
    corners = clipped(corners, normal)
    total = mpf(0)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        plane = cross(b, a)
        size = length(plane)
        if size > 0:
            total += mp.atan2(size, dot(a, b)) * dot(normal, plane) / size
    return max(mpf(0), total / 2)


# One piece of an outline: r(t) and r'(t) for t from low to high; a circle also says how it is made, for closed roots.
Piece = namedtuple('Piece', 'r low high')
Straight = namedtuple('Straight', 'start way')           # start + t way
Arc = namedtuple('Arc', 'center first second')           # center + first cos t + second sin t


def point_on(r, t):
    if isinstance(r, Straight):
        return add(r.start, r.way, t), r.way
    cosine, sine = mp.cos(t), mp.sin(t)
    return (add(add(r.center, r.first, cosine), r.second, sine),
            add(scale(r.second, cosine), r.first, -sine))


def circle(center, radius, axis):
    first, second = beside(axis)
    return Piece(Arc(center, scale(first, radius), scale(second, radius)), mpf(0), 2 * mp.pi)


def outline(shape, place):
    """What bounds the shape as the place sees it, counter-clockwise, relative to the place."""
    center = subtract(shape.center, place)
    if isinstance(shape, Disk):
        return [circle(center, shape.radius, shape.axis)]
    if isinstance(shape, Ball):
        squared = dot(center, center)
        seen = 1 - shape.radius ** 2 / squared
        return [circle(scale(center, seen), shape.radius * mp.sqrt(seen), unit(scale(center, -1)))]
    # The side: the near arc below, up one generator, the near arc above back, down the other generator.
    across = add(scale(center, -1), shape.axis, dot(center, shape.axis))  # from the axis to the place
    away = length(across)
    first = scale(across, 1 / away)
    second = cross(shape.axis, first)
    half = mp.acos(shape.radius / away)
    first, second = scale(first, shape.radius), scale(second, shape.radius)
    bottom = Arc(add(center, shape.axis, -shape.height / 2), first, second)
    top = Arc(add(center, shape.axis, shape.height / 2), first, second)
    up = scale(shape.axis, shape.height)
    return [Piece(bottom, -half, half), Piece(Straight(point_on(bottom, half)[0], up), mpf(0), mpf(1)),
            Piece(top, half, -half), Piece(Straight(point_on(top, -half)[0], scale(up, -1)), mpf(0), mpf(1))]


def zeros(constant, cosine, sine):
    """The t in [0, 2 pi) at which constant + cosine cos t + sine sin t = 0."""
    size = mp.hypot(cosine, sine)
    if abs(constant) >= size:
        return []
    middle, half = mp.atan2(sine, cosine), mp.acos(-constant / size)
    return [(middle + half) % (2 * mp.pi), (middle - half) % (2 * mp.pi)]


def minima(function, low, high):
    """Where a function has minima inside an interval, roughly: they are good places to split an integral."""
    count = 64
    grid = [low + (high - low) * i / count for i in range(count + 1)]
    with mp.workdps(20):
        values = [function(t) for t in grid]
        found = []
        for i in range(1, count):
            if values[i] <= values[i - 1] and values[i] <= values[i + 1]:
                a, b = grid[i - 1], grid[i + 1]
                for _ in range(60):
                    c, d = a + (b - a) * mpf('0.382'), a + (b - a) * mpf('0.618')
                    a, b = (a, d) if function(c) < function(d) else (c, b)
                found.append((a + b) / 2)
    return found


def all_below(pieces, normal):
    """Whether the horizon hides everything: then the integral along the outline is 0 but for rounding."""
    for piece in pieces:
        r = piece.r
        if isinstance(r, Straight):
            highest = max(dot(normal, r.start), dot(normal, add(r.start, r.way)))
        else:
            highest = dot(normal, r.center) + mp.hypot(dot(normal, r.first), dot(normal, r.second))
        if highest > 0:
            return False
    return True


def around_outline(pieces, normal):
    """The integral, and how certain it is."""
    if all_below(pieces, normal):
        return mpf(0), mpf(0)
    total = doubt = mpf(0)
    for piece in pieces:
        def integrand(t, r=piece.r):
            at, way = point_on(r, t)
            height = min(mpf(0), dot(normal, at))
            return dot(normal, cross(at, way)) / (dot(at, at) - height * height)

        def nearness(t, r=piece.r):
            at, _ = point_on(r, t)
            height = min(mpf(0), dot(normal, at))
            return dot(at, at) - height * height

        low, high = sorted((piece.low, piece.high))
        splits = [low, high]
        if isinstance(piece.r, Straight):
            start, way = dot(normal, piece.r.start), dot(normal, piece.r.way)
            splits += [-start / way] if way else []
        else:
            turns = zeros(dot(normal, piece.r.center), dot(normal, piece.r.first), dot(normal, piece.r.second))
            splits += [t + turn for t in turns for turn in (-2 * mp.pi, 0, 2 * mp.pi)]
        splits += minima(nearness, low, high)
        splits = sorted(t for t in set(splits) if low <= t <= high)
        with mp.workdps(35):
            part, error = mp.quad(integrand, splits, error=True, maxdegree=9)
        doubt += error + abs(part) * mpf('1e-33')
        total += part if piece.low < piece.high else -part
    return max(mpf(0), -total / 2 + (mp.pi if holds_nadir(pieces, normal) else 0)), 10 * doubt


def holds_nadir(pieces, normal):
    """Whether the direction straight below the element is inside the outline: the angle around it is a full turn."""
    first, second = beside(normal)
    turn, before = mpf(0), None
    below = True
    with mp.workdps(20):
        for piece in pieces:
            for step in range(65):
                at, _ = point_on(piece.r, piece.low + (piece.high - piece.low) * step / 64)
                below = below and dot(at, normal) < 0
                angle = mp.atan2(dot(at, second), dot(at, first))
                if before is not None:
                    turn += (angle - before + mp.pi) % (2 * mp.pi) - mp.pi
                before = angle
    # An outline that runs below the horizon all around holds it; so may one that is cut by the horizon.
    return abs(turn) > mp.pi and turn > 0


# Parts.

Part = namedtuple('Part', 'position normal area')


def parts_of(shape, count):
    """The count x count parts of a shape (of a polygon that is no parallelogram: of each of its triangles)."""
    if isinstance(shape, Polygon):
        corners = shape.vertices
        if len(corners) == 4 and length(subtract(add(corners[0], corners[2]), add(corners[1], corners[3]))) < \
                mpf('1e-9') * mp.sqrt(shape.area):
            return parallelogram_parts(shape, count)
        return [part for triangle in fan(corners) for part in triangle_parts(triangle, shape.normal, count)]
    return disk_parts(shape, count) if isinstance(shape, Disk) else round_parts(shape, count)


def parallelogram_parts(shape, count):
    a, b, _, d = shape.vertices
    wide, high = subtract(b, a), subtract(d, a)
    return [Part(add(add(a, wide, mpf(2 * i + 1) / (2 * count)), high, mpf(2 * j + 1) / (2 * count)), shape.normal,
                 shape.area / count ** 2) for j in range(count) for i in range(count)]


def fan(corners):
    return [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]


def triangle_parts(triangle, normal, count):
    a, b, c = triangle
    u, v = scale(subtract(b, a), mpf(1) / count), scale(subtract(c, a), mpf(1) / count)
    size = dot(cross(u, v), normal) / 2
    parts = []
    for i in range(count):
        for j in range(count - i):
            parts.append(Part(add(add(a, u, i + mpf(1) / 3), v, j + mpf(1) / 3), normal, size))
            if j < count - i - 1:
                parts.append(Part(add(add(a, u, i + mpf(2) / 3), v, j + mpf(2) / 3), normal, size))
    return parts


def disk_parts(disk, count):
    """Rings of equal area in sectors; the point is the centroid of each."""
    first, second = disk.frame
    half = mp.pi / count
    parts = []
    for ring in range(count):
        inner, outer = (disk.radius * mp.sqrt(mpf(i) / count) for i in (ring, ring + 1))
        reach = mpf(2) / 3 * (outer ** 3 - inner ** 3) / (outer ** 2 - inner ** 2)
        reach *= mp.sin(half) / half if count > 1 else 0
        for sector in range(count):
            turn = (2 * sector + 1) * half
            at = add(add(disk.center, first, reach * mp.cos(turn)), second, reach * mp.sin(turn))
            parts.append(Part(at, disk.axis, area(disk) / count ** 2))
    return parts


def round_parts(shape, count):
    """Bands of equal height in sectors; the point is on the surface in the middle of each."""
    axis = shape.axis if isinstance(shape, Side) else vector([0, 0, 1])
    first, second = usual_frame(axis)
    height = shape.height if isinstance(shape, Side) else 2 * shape.radius
    parts = []
    for band in range(count):
        level = height * (mpf(2 * band + 1) / (2 * count) - mpf(1) / 2)
        ring = shape.radius if isinstance(shape, Side) else mp.sqrt(shape.radius ** 2 - level ** 2)
        for sector in range(count):
            turn = mp.pi * (2 * sector + 1) / count
            out = add(scale(first, ring * mp.cos(turn)), second, ring * mp.sin(turn))
            at = add(out, axis, level)
            normal = unit(out) if isinstance(shape, Side) else unit(at)
            parts.append(Part(add(shape.center, at), normal, area(shape) / count ** 2))
    return parts
