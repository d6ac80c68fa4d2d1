#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the torus knot of the scene beside this program: a tube around a curve that winds three times around a ring
while it goes twice through its hole.  Writes a binary PLY file of quadrangles, in mm."""
import math
import struct
import sys

AROUND, ALONG = 16, 160  # quadrangles around the tube, and along it
RING, WINDING, TUBE = 220.0, 90.0, 48.0


def place(t):
    """The curve."""
    reach = RING + WINDING * math.cos(3 * t)
    return reach * math.cos(2 * t), reach * math.sin(2 * t), WINDING * math.sin(3 * t)


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def knot():
    corners = []
    for i in range(ALONG):
        t, step = 2 * math.pi * i / ALONG, 1e-4
        before, here, after = place(t - step), place(t), place(t + step)
        ahead = unit([b - a for a, b in zip(before, after)])
        out = unit(cross(ahead, cross((here[0] / RING, here[1] / RING, 0), ahead)))
        side = cross(ahead, out)
        for k in range(AROUND):
            turn = 2 * math.pi * k / AROUND
            corners.append([h + TUBE * (math.cos(turn) * o + math.sin(turn) * s) for h, o, s in zip(here, out, side)])
    faces = []
    for i in range(ALONG):
        for k in range(AROUND):
            a, b = i * AROUND, (i + 1) % ALONG * AROUND
            faces.append((a + k, a + (k + 1) % AROUND, b + (k + 1) % AROUND, b + k))
    return corners, faces


def write(name):
    corners, faces = knot()
    with open(name, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\ncomment a torus knot, made by make_knot.py\n"
                    "element vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement face %d\n"
                    "property list uchar ushort vertex_indices\nend_header\n" % (len(corners), len(faces))).encode())
        for corner in corners:
            file.write(struct.pack("<3f", *(round(c, 3) for c in corner)))
        for face in faces:
            file.write(struct.pack("<B4H", 4, *face))


if __name__ == "__main__":
    write(sys.argv[1] if len(sys.argv) > 1 else "knot.ply")
