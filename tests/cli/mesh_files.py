# SPDX-License-Identifier: MIT
"""Writes meshes in every format that is read: OBJ, OFF, PLY, STL, glTF; faces are polygons, triangles where a format
has no others."""
import base64
import json
import math
import struct


def triangles_of(faces):
    return [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]


def number(x):
    return repr(float(x))


def obj(corners, faces, normals=None):
    text = "".join("v %s\n" % " ".join(map(number, corner)) for corner in corners)
    if normals:
        text += "".join("vn %s\n" % " ".join(map(number, normal)) for normal in normals)
    form = "%d//%d" if normals else "%d"
    for face in faces:
        text += "f " + " ".join(form % ((i + 1, i + 1) if normals else i + 1) for i in face) + "\n"
    return text.encode()


def off(corners, faces):
    lines = ["OFF", "%d %d 0" % (len(corners), len(faces))] + [" ".join(map(number, corner)) for corner in corners]
    return "\n".join(lines + ["%d %s" % (len(face), " ".join(map(str, face))) for face in faces]).encode() + b"\n"


def ply(corners, faces, form="ascii", normals=None, count="uchar", index="int", place="double", name="vertex_indices",
        extra=False):
    codes = {"uchar": "B", "ushort": "H", "uint": "I", "int": "i", "short": "h", "float": "f", "double": "d"}
    head = ["ply", "format %s 1.0" % form, "comment made by a test"]
    if extra:
        head += ["element camera 2", "property list uchar float distances", "property short number"]
    head += ["element vertex %d" % len(corners)] + ["property %s %s" % (place, axis) for axis in "xyz"]
    if normals:
        head += ["property float n" + axis for axis in "xyz"]
    if extra:
        head += ["property uchar red", "property list ushort double weights"]
    head += ["element face %d" % len(faces), "property list %s %s %s" % (count, index, name)]
    if extra:
        head += ["property uchar flags"]
    head += ["end_header"]
    rows = []
    if extra:
        rows += [[("uchar", 2), ("float", 0.5), ("float", 1.5), ("short", -3)], [("uchar", 0), ("short", 7)]]
    for i, corner in enumerate(corners):
        row = [(place, c) for c in corner] + ([("float", c) for c in normals[i]] if normals else [])
        rows.append(row + ([("uchar", 9), ("ushort", 1), ("double", 0.25)] if extra else []))
    for face in faces:
        rows.append([(count, len(face))] + [(index, i) for i in face] + ([("uchar", 1)] if extra else []))
    text = ("\n".join(head) + "\n").encode()
    if form == "ascii":
        return text + "\n".join(" ".join(number(v) if kind in ("float", "double") else str(v) for kind, v in row)
                                for row in rows).encode() + b"\n"
    order = "<" if "little" in form else ">"
    return text + b"".join(struct.pack(order + codes[kind], v) for row in rows for kind, v in row)


def stl_text(corners, faces, solids=1):
    faces, text = triangles_of(faces), ""
    share = -(-len(faces) // solids)
    for k in range(solids):
        text += "solid part %d\n" % k
        for face in faces[k * share:(k + 1) * share]:
            text += "facet normal 0 0 0\n  outer loop\n"
            text += "".join("    vertex %s\n" % " ".join(map(number, corners[i])) for i in face)
            text += "  endloop\nendfacet\n"
        text += "endsolid part %d\n" % k
    return text.encode()


def stl_binary(corners, faces, head=b"solid, but binary all the same"):
    faces = triangles_of(faces)
    data = head.ljust(80, b"\0") + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *corners[i]) for i in face) + b"\0\0"
    return data


def gltf_parts(corners, faces, normals=None, indexed=True, stride=0, node=None, mode=4, indices=None):
    """The document and the bytes of its buffer; `stride`: bytes between corners that say nothing."""
    indices = [i for face in triangles_of(faces) for i in face] if indices is None else indices
    if not indexed:
        corners = [corners[i] for i in indices]
        normals = [normals[i] for i in indices] if normals else None
    data, views, accessors = b"", [], []

    def add(rows, form, component, kind, pad=0):
        nonlocal data
        data += b"\0" * (-len(data) % 4)
        start = len(data)
        for row in rows:
            data += struct.pack("<" + form, *row) + b"\xee" * pad
        view = {"buffer": 0, "byteOffset": start, "byteLength": len(data) - start}
        if pad:
            view["byteStride"] = struct.calcsize("<" + form) + pad
        views.append(view)
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(rows), "type": kind})
        return len(accessors) - 1

    attributes = {"POSITION": add(corners, "3f", 5126, "VEC3", stride)}
    if normals:
        attributes["NORMAL"] = add(normals, "3f", 5126, "VEC3")
    primitive = {"attributes": attributes, "mode": mode}
    if indexed:
        primitive["indices"] = add([(i,) for i in indices], "H", 5123, "SCALAR")
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                "nodes": [dict(node or {}, mesh=0)], "meshes": [{"primitives": [primitive]}], "accessors": accessors,
                "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    return document, data


def gltf(document, data, uri=None):
    document = json.loads(json.dumps(document))
    document["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps(document).encode()


def glb(document, data):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def ball(bands, radius=1.0):
    """A closed sphere of 2 bands meridians, its corners on it, faces counter-clockwise from outside."""
    corners, faces, around = [(0, 0, radius)], [], 2 * bands
    for i in range(1, bands):
        for k in range(around):
            theta, phi = math.pi * i / bands, 2 * math.pi * k / around
            corners.append((radius * math.sin(theta) * math.cos(phi), radius * math.sin(theta) * math.sin(phi),
                            radius * math.cos(theta)))
    corners.append((0, 0, -radius))

    def at(i, k):
        return 0 if i == 0 else len(corners) - 1 if i == bands else 1 + (i - 1) * around + k % around

    for i in range(bands):
        for k in range(around):
            face = (at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1))
            faces.append(tuple(dict.fromkeys(face)))
    return corners, faces


def box(size):
    x, y, z = (s / 2 for s in size)
    corners = [(a * x, b * y, c * z) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    return corners, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
