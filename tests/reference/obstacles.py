# SPDX-License-Identifier: MIT
"""Whether bodies lie before what is sent from a place, for many rays at once, sharing no code with the library."""
import numpy as np

NEAR = 1e-7  # of the way of a ray that is neither its begin nor its end



# ---- vectors ----

def unit(a):
    return np.asarray(a, float) / np.linalg.norm(a)


def beside(axis):
    """Two directions at right angles to an axis and to each other."""
    axis = unit(axis)
    first = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    return first, np.cross(axis, first)


# ---- what rays meet: whether a body lies between NEAR and 1 - NEAR of ways from a place ----

def between(share):
    return (share > NEAR) & (share < 1 - NEAR)


def by_plane(place, ways, center, axis):
    with np.errstate(divide="ignore", invalid="ignore"):
        share = ((center - place) @ axis) / (ways @ axis)
        met = place + share[:, None] * ways - center
    return between(share), met


def hides_rectangle(body, place, ways):
    axis = unit(body["axis"])
    up = np.array(body["up"], float)
    up = unit(up - (up @ axis) * axis)
    hit, met = by_plane(place, ways, np.array(body["center"]), axis)
    return hit & (abs(met @ np.cross(up, axis)) < body["size"][0] / 2) & (abs(met @ up) < body["size"][1] / 2)


def hides_disk(body, place, ways):
    hit, met = by_plane(place, ways, np.array(body["center"]), unit(body["axis"]))
    return hit & ((met * met).sum(1) < body["radius"] ** 2)


def roots(a, b, c):
    """Of a t^2 + 2 b t + c."""
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(np.maximum(b * b - a * c, 0))
        return b * b > a * c, (-b - root) / a, (-b + root) / a


def hides_sphere(body, place, ways):
    away = place - np.array(body["center"])
    real, near, far = roots((ways * ways).sum(1), ways @ away, away @ away - body["radius"] ** 2)
    return real & (between(near) | between(far))


def hides_cylinder(body, place, ways):
    axis, away = unit(body["axis"]), place - np.array(body["center"])
    flat, start = ways - np.outer(ways @ axis, axis), away - (away @ axis) * axis
    real, near, far = roots((flat * flat).sum(1), flat @ start, start @ start - body["radius"] ** 2)
    hidden = np.zeros(len(ways), bool)
    for share in near, far:
        hidden |= real & between(share) & (abs(away @ axis + share * (ways @ axis)) < body["height"] / 2)
    return hidden


def hides_box(body, place, ways):
    """The entrance or the exit lies between."""
    half, away = np.array(body["size"]) / 2, place - np.array(body["center"])
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = (-half - away) / ways, (half - away) / ways
    enters, leaves = np.fmin(low, high).max(1), np.fmax(low, high).min(1)
    return (enters < leaves) & (between(enters) | between(leaves))


def hides_mesh(body, place, ways):
    hidden = np.zeros(len(ways), bool)
    corners = np.array(body["corners"])
    for face in body["faces"]:
        a, b, c = corners[list(face)]
        normal = np.cross(b - a, c - a)
        hit, met = by_plane(place, ways, a, unit(normal))
        inside = np.ones(len(ways), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            inside &= (met + a - p) @ np.cross(normal, q - p) > 0
        hidden |= hit & inside
    return hidden


HIDES = {"rectangle": hides_rectangle, "disk": hides_disk, "sphere": hides_sphere, "cylinder": hides_cylinder,
         "box": hides_box, "mesh": hides_mesh}
