#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the pot of the scene beside this program: a body with a lid and a knob, turned about its axis.  Writes a binary
PLY file of triangles and quadrangles, in mm; it stands on its origin and is closed."""
import math
import struct
import sys

AROUND, BETWEEN = 48, 4  # faces around the axis, and between two places of the profile
PROFILE = [(0, 0), (72, 0), (96, 18), (112, 62), (101, 108), (73, 136), (78, 142), (66, 152), (34, 164), (13, 169),
           (11, 175), (20, 186), (14, 198), (0, 202)]
EDGES = {1, 5, 6, 9}  # places of the profile where it has an edge


def spline(a, b, c, d, t):
    """Catmull and Rom's curve from b to c."""
    return tuple(q + t / 2 * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)))
                 for p, q, r, s in zip(a, b, c, d))


def outline():
    places = []
    for i in range(len(PROFILE) - 1):
        b, c = PROFILE[i], PROFILE[i + 1]
        a = PROFILE[i - 1] if i > 0 and i not in EDGES else b
        d = PROFILE[i + 2] if i + 2 < len(PROFILE) and i + 1 not in EDGES else c
        steps = 1 if i == 0 else BETWEEN
        places += [spline(a, b, c, d, k / steps) for k in range(steps)]
    return places + [PROFILE[-1]]


def pot():
    rings = outline()[1:-1]
    corners, faces = [(0, 0, PROFILE[0][1])], []
    for radius, height in rings:
        for k in range(AROUND):
            turn = 2 * math.pi * k / AROUND
            corners.append((radius * math.cos(turn), radius * math.sin(turn), height))
    top = len(corners)
    corners.append((0, 0, PROFILE[-1][1]))
    for k in range(AROUND):
        following = (k + 1) % AROUND
        faces.append((0, 1 + following, 1 + k))
        for i in range(len(rings) - 1):
            low, high = 1 + i * AROUND, 1 + (i + 1) * AROUND
            faces.append((low + k, low + following, high + following, high + k))
        last = 1 + (len(rings) - 1) * AROUND
        faces.append((last + k, last + following, top))
    return corners, faces


def write(name):
    corners, faces = pot()
    with open(name, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\ncomment a pot, made by make_pot.py\n"
                    "element vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement face %d\n"
                    "property list uchar ushort vertex_indices\nend_header\n" % (len(corners), len(faces))).encode())
        for corner in corners:
            file.write(struct.pack("<3f", *(round(c, 3) for c in corner)))
        for face in faces:
            file.write(struct.pack("<B%dH" % len(face), len(face), *face))


if __name__ == "__main__":
    write(sys.argv[1] if len(sys.argv) > 1 else "pot.ply")
