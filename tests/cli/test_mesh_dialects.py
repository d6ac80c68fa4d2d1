# SPDX-License-Identifier: MIT
"""Meshes as other programs write them: STL files with attributes, wrong counts and odd words, strips of PLY files, glTF
files of whole numbers.  Each is a box whose volume and light are known, or refused for what is wrong with it."""
import itertools
import json
import math
import struct

import mesh_files
from tap import Tap
from tool import run_tests

SIZE = (200, 300, 400)
SCENE = """\
luxel: 1
screen: {width: 1000, height: 1000, resolution: [20, 20]}
observer: {z: 5000}
surfaces: [{type: mesh, file: %s, scale: 1, normals: %s, material: {model: lambert}}]
lights: [{type: point, position: [300, 400, 2000], intensity: 10}]
points: [[20, 30]]
"""
# The top of the box lies at z = 200, the lamp 1800 mm above it: diffuse 0.8 of it, by the inverse square, in W/sr.
RIGHT = 0.8 * 10 * 1.8 / (0.28 ** 2 + 0.37 ** 2 + 1.8 ** 2) ** 1.5


def check(tool, name, content, normals="flat"):
    tool.write(name, content)
    tool.write("scene.yaml", SCENE % (name, normals))
    return tool.run("check", "scene.yaml", "--json")


def is_the_box(tap, tool, name, content, advice=(), normals="flat", share=1e-12):
    """Reads as the box, with this advice and no other."""
    result = check(tool, name, content, normals)
    given = result.json()
    if result.code != 0:
        tap.ok(False, name, result)
        return
    (mesh,) = given["meshes"]
    codes = sorted(entry["id"] for entry in given["advice"] if entry["key"] == "surfaces[0].file")
    tap.ok((mesh["triangles"], mesh["closed"]) == (12, True) and
           abs(mesh["volume_mm3"] / math.prod(SIZE) - 1) <= share and codes == sorted(advice), name, mesh, codes)
    (point,) = tool.run("probe", "scene.yaml", "--json", "--quantity", "brightness").json()["points"]
    tap.ok(abs(point["value"] / RIGHT - 1) <= max(share, 1e-12), "its light: " + name, point, RIGHT)


def is_refused(tap, tool, name, content, words):
    result = check(tool, name, content)
    tap.ok(result.code == 3 and words in result.err + result.out, "refused: " + words, result)


def binary_stl(count=None, head=b"own", attributes=lambda i: b"", mark=lambda i: None, behind=b""):
    """Triangles with bytes of attributes; `mark`: what stands in place of their number."""
    corners, faces = mesh_files.box(SIZE)
    faces = mesh_files.triangles_of(faces)
    data = head.ljust(80) + struct.pack("<I", len(faces) if count is None else count)
    for i, face in enumerate(faces):
        more = attributes(i)
        data += bytes(12) + b"".join(struct.pack("<3f", *corners[k]) for k in face)
        data += struct.pack("<H", len(more) if mark(i) is None else mark(i)) + more
    return data + behind


def binary_stl_files(tap, tool):
    for name, content, advice in (
            ("attributes.stl", binary_stl(attributes=lambda i: bytes([i]) * (i * 7 % 11)), ()),
            ("few.stl", binary_stl(attributes=lambda i: b"\xff" * 50 * (i == 3)), ()),
            ("colours.stl", binary_stl(mark=lambda i: 0x8000 + i), ()),
            ("count-0.stl", binary_stl(0), ("triangle-count",)),
            ("count-minus-1.stl", binary_stl(0xffffffff), ("triangle-count",)),
            ("too-big.stl", binary_stl(1000), ("triangle-count",)),
            ("too-small.stl", binary_stl(5), ("triangle-count",)),
            ("solid.stl", binary_stl(head=b"solid own"), ()),
            ("solid-behind.stl", binary_stl(head=b"solid own", behind=b"1234567"), ("bytes-behind",)),
            ("solid-attributes.stl", binary_stl(head=b"solid own", attributes=lambda i: b"ab"), ())):
        is_the_box(tap, tool, name, content, advice)
    whole = binary_stl(attributes=lambda i: b"abc")
    for content in whole[:-2], whole + b"x", binary_stl(mark=lambda i: 7, behind=b"xyz"):
        is_refused(tap, tool, "odd.stl", content, "is as long neither as")
    is_refused(tap, tool, "cut.stl", binary_stl()[:-30], "ends before")
    is_refused(tap, tool, "none.stl", binary_stl()[:80] + bytes(4), "has no faces")


def text_stl_files(tap, tool):
    plain = mesh_files.stl_text(*mesh_files.box(SIZE)).decode()
    ended = plain[:plain.index("endsolid")]
    bare = "".join(line + "\n" for line in plain.splitlines() if "facet" not in line)
    alone = "".join(line + "\n" for line in plain.splitlines() if "loop" not in line)
    for name, content, advice in (
            ("plain.stl", plain, ()), ("end-solid.stl", plain.replace("endsolid", "end solid"), ()),
            ("end-loop.stl", plain.replace("endloop", "end loop").replace("endfacet", "END FACET"), ()),
            ("no-endsolid.stl", ended, ("no-endsolid",)), ("no-facets.stl", bare, ()), ("no-loops.stl", alone, ()),
            ("loop.stl", plain.replace("part 0", "end loop facet"), ())):
        is_the_box(tap, tool, name, content, advice)
    is_refused(tap, tool, "cut.stl", ended[:ended.rindex("vertex")], "in the middle of a facet")
    is_refused(tap, tool, "facet.stl", ended[:ended.rindex("endloop")] + "facet normal 0 0 1\n", "expected vertex")
    is_refused(tap, tool, "loop.stl", bare.replace("endloop", "", 1), "expected vertex")


def strip_ply(form, index="int"):
    """The box as one list of strips: two that go round it, with a turn of an odd number of corners, and a quadrilateral
    that leads to another one by corners named twice."""
    corners, _ = mesh_files.box(SIZE)
    strip = [0, 1, 2, 3, 6, 7, 4, 5, 0, 1, -1, 0, 2, 4, 6, 6, 1, 1, 5, 3, 7]
    head = "ply\nformat %s 1.0\nelement vertex 8\n" % form + "".join("property float %s\n" % axis for axis in "XyZ")
    head += "element tristrips 1\nproperty list int %s vertex_indices\nend_header\n" % index
    if form == "ascii":
        return (head + "".join("%r %r %r\n" % corner for corner in corners) +
                " ".join(map(str, [len(strip)] + strip)) + "\n").encode()
    order = "<" if "little" in form else ">"
    return head.encode() + b"".join(struct.pack(order + "3f", *corner) for corner in corners) + struct.pack(
        order + "i%di" % len(strip), len(strip), *strip)


def ply_files(tap, tool):
    for form in "ascii", "binary_little_endian", "binary_big_endian":
        is_the_box(tap, tool, form + ".ply", strip_ply(form))
    corners, faces = mesh_files.box(SIZE)
    capital = mesh_files.ply(corners, faces).decode()
    for name in "x", "y", "z", "vertex_indices":
        capital = capital.replace(" %s\n" % name, " %s\n" % name.upper())
    is_the_box(tap, tool, "capital.ply", capital)
    is_refused(tap, tool, "index.ply", strip_ply("ascii").replace(b" 7\n", b" 8\n"), "a corner that is not in the file")
    is_refused(tap, tool, "minus.ply", strip_ply("ascii").replace(b" 7\n", b" -2\n"), "a corner that is not in the")


FORMS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535)}


def quantized(code, is_normalized, with_normals, listed="extensionsRequired"):
    """The box with its corners at the ends of the type's range, which the node maps to its size; flat normals."""
    corners, faces = mesh_files.box(SIZE)
    form, most = FORMS[code]
    # The least number of a signed type lies beyond -1, and is taken as -1 where it is normalized.
    low = 0 if form.isupper() else -most - is_normalized
    span = 1 if is_normalized else most
    rows, normals = [], []
    for a, b, c in mesh_files.triangles_of(faces):
        sides = [[corners[k][i] - corners[a][i] for i in range(3)] for k in (b, c)]
        normal = [sides[0][i - 2] * sides[1][i - 1] - sides[0][i - 1] * sides[1][i - 2] for i in range(3)]
        rows += [[most if x > 0 else low for x in corners[k]] for k in (a, b, c)]
        normals += [[127 if x > 0 else -127 if x < 0 else 0 for x in normal]] * 3
    data = b"".join(struct.pack("<3%s" % form, *row) + b"\xee" * (-3 * struct.calcsize(form) % 4) for row in rows)
    views = [{"buffer": 0, "byteLength": len(data), "byteStride": 4 if form in "bB" else 8}]
    accessors = [{"bufferView": 0, "componentType": code, "count": len(rows), "type": "VEC3",
                  "normalized": is_normalized}]
    attributes = {"POSITION": 0}
    if with_normals:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": 4 * len(rows), "byteStride": 4})
        data += b"".join(struct.pack("<4b", *normal, 9) for normal in normals)
        accessors.append({"bufferView": 1, "componentType": 5120, "count": len(rows), "type": "VEC3",
                          "normalized": True})
        attributes["NORMAL"] = 1
    whole = 1 if form.isupper() else 2
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0, "scale": [s / whole / span for s in SIZE],
                           "translation": [-s / 2 if form.isupper() else 0 for s in SIZE]}],
                "meshes": [{"primitives": [{"attributes": attributes}]}], "accessors": accessors, "bufferViews": views,
                "buffers": [{"byteLength": len(data)}]}
    document[listed] = ["KHR_mesh_quantization"]
    return document, data


def gltf_files(tap, tool):
    for code, is_normalized, with_normals in itertools.product(FORMS, (False, True), (False, True)):
        name = "%s-%s.glb" % (FORMS[code][0] * 2 if FORMS[code][0].isupper() else FORMS[code][0], is_normalized)
        is_the_box(tap, tool, name, mesh_files.glb(*quantized(code, is_normalized, with_normals)),
                   normals="file" if with_normals else "flat", share=1e-9)
    is_the_box(tap, tool, "used.gltf", mesh_files.gltf(*quantized(5122, True, False, "extensionsUsed")), share=1e-9)
    is_refused(tap, tool, "plain.gltf", mesh_files.gltf(*quantized(5122, True, False, "extras")), "accessors[0]")
    document, data = quantized(5122, True, False)
    document = json.loads(json.dumps(document).replace("5122", "5125"))
    is_refused(tap, tool, "wide.gltf", mesh_files.gltf(document, data), "accessors[0]")


run_tests(Tap(), binary_stl_files, text_stl_files, ply_files, gltf_files)
