# SPDX-License-Identifier: MIT
"""Meshes as surfaces: every format shows the same, what they show is what other surfaces of the same form do, and
whatever is wrong with a file is told."""
import json
import math
import os
import random
import subprocess
import sys

import mesh_files
from tap import Tap
from tool import run_tests

SCENE = """\
luxel: 1
screen: {width: 500, height: 500, resolution: [40, 40]}
observer: {z: 2000, projection: perspective}
surfaces:
%s
lights:
  - {type: point, position: [300, 500, 1500], intensity: 10}
  - {type: distant, direction: [1, -0.5, -1], irradiance: 3}
points: [[0, 0], [60, 40], [-70, 10], [33.25, -41.5], [-120, -90]]
"""
MATERIAL = "material: {model: lambert}"
SIZE = (240, 160, 120)
# Light that has no peak, for which no other lamps are tried where only the mesh counts.
EVENLY = ("-s", "lights=[{type: ambient, irradiance: 1}]")


def scene(*surfaces):
    return SCENE % "\n".join("  - " + surface for surface in surfaces)


def mesh(name, more=""):
    return "{type: mesh, file: %s, %sposition: [10, 20, 500], %s}" % (name, more, MATERIAL)


def values(tool, text, *more):
    tool.write("scene.yaml", text)
    result = tool.run("probe", "scene.yaml", "--json", *more)
    return [(point["value"], point.get("error")) for point in result.json()["points"]]


def near(found, expected, share=1e-12):
    return len(found) == len(expected) and all(
        (a is None and b is None) or (a is not None and b is not None and abs(a - b) <= share * abs(b) + ea + eb)
        for (a, ea), (b, eb) in zip(found, expected))


def files_of(corners, faces, normals=None):
    document, data = mesh_files.gltf_parts(corners, faces, normals)
    mirrored = [(-x, y, z) for x, y, z in corners]
    apart, apart_data = mesh_files.gltf_parts(mirrored, [face[::-1] for face in faces], None, indexed=False, stride=8,
                                              node={"scale": [-1, 1, 1]})
    little, big = "binary_little_endian", "binary_big_endian"
    return {
        "a.obj": mesh_files.obj(corners, faces), "a.off": mesh_files.off(corners, faces),
        "ascii.ply": mesh_files.ply(corners, faces), "more.ply": mesh_files.ply(corners, faces, extra=True),
        "little.ply": mesh_files.ply(corners, faces, little, extra=True, index="uint"),
        "big.ply": mesh_files.ply(corners, faces, big, extra=True, count="ushort", place="float", name="vertex_index"),
        "text.stl": mesh_files.stl_text(corners, faces, solids=3), "binary.stl": mesh_files.stl_binary(corners, faces),
        "data.gltf": mesh_files.gltf(document, data), "file.gltf": mesh_files.gltf(document, data, "the%20buffer.bin"),
        "the buffer.bin": data, "a.glb": mesh_files.glb(document, data), "apart.glb": mesh_files.glb(apart, apart_data),
    }


def formats_agree(tap, tool):
    corners, faces = mesh_files.box(SIZE)
    expected = None
    os.mkdir(tool.file("models"))
    for name, content in files_of(corners, faces).items():
        tool.write("models/" + name, content)
    for name in sorted(os.listdir(tool.file("models"))):
        if name.endswith(".bin"):
            continue
        found = values(tool, scene(mesh("models/" + name, "rotate: [10, 20, 30], scale: 1, ")))
        expected = expected or found
        tap.ok(near(found, expected, 0) and all(value is not None for value, _ in found[:4]), name, found, expected)
    document, data = mesh_files.gltf_parts([[c / 1000 for c in corner] for corner in corners], faces)
    tool.write("metres.glb", mesh_files.glb(document, data))
    found = values(tool, scene(mesh("metres.glb", "rotate: [10, 20, 30], ")))
    tap.ok(near(found, expected, 1e-5), "glTF is in metres", found, expected)


def strips_and_sparse(tap, tool):
    corners, faces = mesh_files.box(SIZE)
    tool.write("plain.obj", mesh_files.obj(corners, faces))
    expected = values(tool, scene(mesh("plain.obj", "rotate: [10, 20, 30], ")))
    strip = [(a, b, d, c) for a, b, c, d in faces]
    indices = [i for k, quad in enumerate(strip) for i in ([65535] if k else []) + list(quad)]
    document, data = mesh_files.gltf_parts(corners, faces, mode=5, indices=indices)
    tool.write("strip.glb", mesh_files.glb(document, data))
    fan = [i for k, quad in enumerate(faces) for i in ([65535] if k else []) + list(quad)]
    document, data = mesh_files.gltf_parts(corners, faces, mode=6, indices=fan)
    tool.write("fan.glb", mesh_files.glb(document, data))
    moved = [(0, 0, 0)] + corners[1:]
    document, data = mesh_files.gltf_parts(moved, faces)
    other, more = mesh_files.gltf_parts([corners[0]], [], indices=[0])
    base = len(data) + (-len(data) % 4)
    document["bufferViews"] += [dict(view, byteOffset=view["byteOffset"] + base) for view in other["bufferViews"]]
    document["accessors"][0]["sparse"] = {
        "count": 1, "values": {"bufferView": 2}, "indices": {"bufferView": 3, "componentType": 5123}}
    data += b"\0" * (-len(data) % 4) + more
    document["buffers"][0]["byteLength"] = len(data)
    tool.write("sparse.glb", mesh_files.glb(document, data))
    for name in "strip.glb", "fan.glb", "sparse.glb":
        found = values(tool, scene(mesh(name, "rotate: [10, 20, 30], scale: 1, ")))
        tap.ok(near(found, expected, 0), name, found, expected)


def plates(size, center):
    """The six sides of a box; those that would turn their backs to the observer at (0, 0, 2000) look into it."""
    x, y, z = size
    sides = [((1, 0, 0), (z, y)), ((-1, 0, 0), (z, y)), ((0, 1, 0), (x, z)), ((0, -1, 0), (x, z)), ((0, 0, 1), (x, y)),
             ((0, 0, -1), (x, y))]
    made = []
    for axis, (w, h) in sides:
        at = [c + a * s / 2 for c, a, s in zip(center, axis, size)]
        if sum(a * (e - c) for a, e, c in zip(axis, (0, 0, 2000), at)) < 0:
            axis = tuple(-a for a in axis)
        made.append("{type: rectangle, center: %s, size: [%s, %s], axis: %s, %s}" % (at, w, h, list(axis), MATERIAL))
    return made


def as_other_surfaces(tap, tool):
    corners, faces = mesh_files.box(SIZE)
    tool.write("box.obj", mesh_files.obj(corners, faces))
    floor = "{type: disk, center: [0, 0, 300], radius: 900, %s}" % MATERIAL
    found = values(tool, scene(mesh("box.obj"), floor))
    expected = values(tool, scene(floor, *plates(SIZE, (10, 20, 500))))
    tap.ok(near(found, expected), "a box is six plates, with shadows", found, expected)
    lamps = ("lights=[{type: planar, rectangle: {center: [300, 400, 1500], size: [400, 300], axis: [-1, -1, -3]}, "
             "radiance: 9}]")
    found = values(tool, scene(mesh("box.obj"), floor), "-s", lamps)
    expected = values(tool, scene(floor, *plates(SIZE, (10, 20, 500))), "-s", lamps)
    tap.ok(near(found, expected, 1e-9), "and the soft shadows of an area", found, expected)
    for projection in "perspective", "orthographic":
        both = []
        for text in scene(mesh("box.obj"), floor), scene(floor, *plates(SIZE, (10, 20, 500))):
            tool.write("scene.yaml", text)
            tool.run("render", "scene.yaml", "-s", "observer.projection=" + projection, "-o", "a.csv", "--precision",
                     "double")
            with open(tool.file("a.csv"), encoding="utf-8") as file:
                both.append([float(line.split(",")[2]) for line in file.readlines()[1:]])
        most = max(both[1])
        tap.ok(len(both[0]) == len(both[1]) and all(abs(a - b) <= 1e-11 * most for a, b in zip(*both)),
               "pictures, too: " + projection)


def balls_tend_to_a_ball(tap, tool):
    ball = "{type: sphere, center: [10, 20, 500], radius: 200, %s}" % MATERIAL
    expected = values(tool, scene(ball))
    off = []
    for bands in 16, 32, 64:
        corners, faces = mesh_files.ball(bands, 200)
        tool.write("ball.ply", mesh_files.ply(corners, faces, "binary_little_endian"))
        found = values(tool, scene(mesh("ball.ply", "normals: smooth, ")))
        off.append(sum(abs(a - b) for (a, _), (b, _) in zip(found, expected)))
    tap.ok(3 < off[0] / off[1] < 5.3 and 3 < off[1] / off[2] < 5.3, "four times nearer with twice the bands", off)


def soft_shadows(tap, tool):
    """Of balls of bands, which tend to that of the ball; in the umbra nothing is in doubt, and where a mesh stands in a
    round source all is, which is told."""
    floor = "{type: rectangle, center: [0, 0, 0], size: [1200, 1200], %s}" % MATERIAL
    lamp = "lights=[{type: planar, rectangle: {center: [50, 30, 1500], size: [400, 300]}, radiance: 9}]"
    places = ("--at", "260,40,0,0,0,1", "--at", "-190,200,0,0,0,1", "--at", "150,-250,0,0.2,0,1")
    expected = values(tool, scene("{type: sphere, center: [10, 20, 500], radius: 200, %s}" % MATERIAL, floor), "-s",
                      lamp, *places)
    off = []
    for bands in 16, 32, 64:
        corners, faces = mesh_files.ball(bands, 200)
        tool.write("ball.ply", mesh_files.ply(corners, faces, "binary_little_endian"))
        text = scene(mesh("ball.ply"), floor)
        found = values(tool, text, "-s", lamp, *places)
        off.append(sum(abs(a - b) for (a, _), (b, _) in zip(found, expected)))
        tap.ok(all(0 < value and error <= 1e-9 * value for value, error in found), "%d bands, to 1e-9" % bands, found)
    tap.ok(off[1] < off[0] / 3 and off[2] < off[1] / 3 and 11 < off[0] / off[2] < 23,
           "sixteen times nearer with four times the bands", off)
    result = tool.run("probe", "scene.yaml", "--json", "-s", lamp, "--at", "10,20,0,0,0,1")
    tap.ok(result.code == 0 and result.json()["points"][0]["value"] == 0, "the umbra is dark, without a doubt", result)
    tool.write("in.yaml", text.replace("lights:", "lights:\n  - {type: volume, radiance: 1, sphere: "
                                       "{center: [180, 20, 650], radius: 90}}"))
    result = tool.run("probe", "in.yaml", "--json", "--at", "420,20,0,0,0,1")
    point = result.json()["points"][0]["lights"][0]
    tap.ok(result.code == 5 and point["error"] >= 0.5 * point["irradiance"] > 0, "a mesh in a globe is in doubt",
           result)


def turns(tap, tool):
    """x, then y, then z: against corners that are turned here."""
    corners, faces = mesh_files.box(SIZE)
    angles = (20, -35, 50)
    moved = corners
    for axis, degrees in enumerate(angles):
        s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        y, z = (axis + 1) % 3, (axis + 2) % 3
        for_axis = []
        for corner in moved:
            corner = list(corner)
            corner[y], corner[z] = c * corner[y] - s * corner[z], s * corner[y] + c * corner[z]
            for_axis.append(tuple(corner))
        moved = for_axis
    tool.write("as_is.obj", mesh_files.obj(corners, faces))
    tool.write("turned.obj", mesh_files.obj(moved, faces))
    found = values(tool, scene(mesh("as_is.obj", "rotate: %s, " % list(angles))))
    tap.ok(near(found, values(tool, scene(mesh("turned.obj")))), "rotate", found)
    quarter = values(tool, scene(mesh("as_is.obj", "rotate: [0, 0, 90], ")))
    turned = [(-y, x, z) for x, y, z in corners]
    tool.write("quarter.obj", mesh_files.obj(turned, faces))
    tap.ok(near(quarter, values(tool, scene(mesh("quarter.obj"))), 0), "a quarter, without rounding", quarter)


def sides(tap, tool):
    sheet = [(-100, -100, 0), (100, -100, 0), (100, 100, 0), (-100, 100, 0)]
    tool.write("front.obj", mesh_files.obj(sheet, [(0, 1, 2, 3)]))
    tool.write("back.obj", mesh_files.obj(sheet, [(3, 2, 1, 0)]))
    front = values(tool, scene(mesh("front.obj")))
    tap.ok(near(values(tool, scene(mesh("back.obj"))), front, 0), "both sides are seen", front)
    back = values(tool, scene(mesh("back.obj", "sides: front, ")))
    tap.ok(all(value is None for value, _ in back), "a back is not, with sides: front", back)
    behind = "lights=[{type: point, position: [0, 0, -800], intensity: 10}]"
    dark = values(tool, scene("{type: mesh, file: front.obj, position: [0, 0, 500]}"), "-s", behind)
    tap.ok(dark[0][0] == 0, "light from behind does not come through, not even as a highlight", dark)
    tap.equal(tool.run("check", "scene.yaml", "-s", "surfaces[0].normals=file").code, 3, "a file without normals")


def files_are_told(tap, tool):
    tool.write("scene.yaml", scene(mesh("model.obj")))
    result = tool.run("check", "scene.yaml")
    tap.ok(result.code == 4 and "cannot read model.obj" in result.err, "no file", result)
    cases = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n": "line 4: the face has a corner that is not in the file",
        "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n": "line 2: expected a corner",
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n": "have no area",
        "": "has no faces",
        "ply\nformat ascii 1.0\nelement vertex x\nend_header\n": "line 3: expected a line of the header",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n":
            "corner 1 is not at a finite place",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        "1 2 3\n4 5 6\n": "ends before",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nfacet\n": "line 5: expected vertex or endfacet",
        '{"asset": {"version": "1.0"}}': "not glTF 2.x",
        '{"asset": {"version": "2.0"},\n "nodes": [}': "line 2: expected JSON",
        '{"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"]}':
            "KHR_draco_mesh_compression",
        '{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"children": [0]}]}': "below itself",
        '{"asset": {"version": "2.0"}, "buffers": [{"uri": "gone.bin", "byteLength": 4}]}': "cannot read gone.bin",
    }
    for text, words in cases.items():
        tool.write("model.obj" if "{" not in text else "model.gltf", text)
        tool.write("scene.yaml", scene(mesh("model.obj" if "{" not in text else "model.gltf")))
        result = tool.run("check", "scene.yaml")
        tap.ok(result.code in (3, 4) and words in result.err, "told: " + words, result)
    document, data = mesh_files.gltf_parts(*mesh_files.box(SIZE))
    for change in ({"count": 1 << 29}, {"byteOffset": 1 << 29}, {"count": 9}, {"byteOffset": 5}):
        broken = json.loads(json.dumps(document))
        broken["accessors"][0].update(change)
        tool.write("model.gltf", mesh_files.gltf(broken, data))
        result = tool.run("check", "scene.yaml")
        tap.ok(result.code == 3 and "accessors[0] goes beyond" in result.err, "told: %s" % change, result)


def broken_files_end(tap, tool):
    """Hundreds of mutations: an error or a mesh, at once, never anything else."""
    chance, corners, faces = random.Random(31), *mesh_files.box(SIZE)
    codes = set()
    for name, content in files_of(corners, faces).items():
        for k in range(12):
            data = bytearray(content)
            for _ in range(chance.randrange(1, 4)):
                at, way = chance.randrange(len(data)), chance.randrange(3)
                if way == 0:
                    data[at] = chance.randrange(256)
                elif way == 1:
                    del data[at:at + chance.randrange(1, 40)]
                else:
                    data[at:at] = bytes(chance.choice(b"0123456789-.e\n \xff\0") for _ in range(chance.randrange(1, 9)))
                data = data or bytearray(b" ")
            tool.write(name, bytes(data))
            tool.write("scene.yaml", scene(mesh("file.gltf" if name.endswith("bin") else name)))
            codes.add(tool.run("check", "scene.yaml", *EVENLY).code)
    tap.ok(codes <= {0, 3, 4} and {0, 3} <= codes, "broken files end in a mesh or an error", codes)


def as_scenes_go(tap, tool):
    corners, faces = mesh_files.box(SIZE)
    os.mkdir(tool.file("room"))
    tool.write("room/box.obj", mesh_files.obj(corners, faces))
    tool.write("room/scene.yaml", scene(mesh("box.obj")))
    tap.equal(tool.run("render", "room/scene.yaml", "-o", "room/a.png", "-o", "away.png").code, 0, "a picture")
    tap.equal(tool.run("check", "room/a.png").code, 0, "carries a scene that finds its mesh beside it")
    tap.equal(tool.run("check", "away.png").code, 4, "and not elsewhere")
    tool.write("room/other.obj", mesh_files.obj([(2 * x, y, z) for x, y, z in corners], faces))
    result = tool.run("render", "room/scene.yaml", "--json", "-s", "surfaces[0].file=other.obj")
    tap.ok(result.code == 0 and result.json()["max"]["value"] > 0, "-s file", result)


def highlights_behind(tap, tool):
    """Highlights that meshes hide in part: quick rules between the outline's edges against the reference's arcs, which
    a small tolerance asks for; the same with each number of threads, and where two windows take turns."""
    corners, faces = ring(180, 45, 20, 9)
    tool.write("ring.obj", mesh_files.obj(corners, faces))
    window = "planar, rectangle: {center: [%d, %d, 1300], size: [%d, 500], axis: [%d, %d, -2]}, radiance: 60}"
    for highlight, shininess, turn in ("gated", 40, 30), ("plain", 300, 70), ("cosine", 8, 5):
        shine = "material: {diffuse: 0.3, specular: 0.7, shininess: %d, highlight: %s}" % (shininess, highlight)
        tool.write("scene.yaml", "\n".join([
            "luxel: 1", "screen: {width: 840, height: 660, resolution: [28, 22]}",
            "observer: {position: [100, -900, 900], target: [0, 0, 100], projection: perspective}", "surfaces:",
            "  - {type: rectangle, center: [0, 0, 0], size: [2000, 2000], %s}" % shine,
            "  - {type: mesh, file: ring.obj, position: [0, 0, 260], rotate: [%d, 20, 0], normals: smooth, %s}" % (
                turn, shine),
            "lights:", "  - {type: " + window % (-500, 400, 700, 1, -1),
            "  - {type: " + window % (600, 500, 300, -1, -1)]) + "\n")
        for name, words in (("quick.npy", ("--threads", "1")), ("threads.npy", ("--threads", "3")),
                            ("exact.npy", ("--tolerance", "1e-6"))):
            tap.equal(tool.run("render", "scene.yaml", "-o", name, *words).code, 0, "%s: %s" % (highlight, name))
        tap.ok(tool.read("quick.npy") == tool.read("threads.npy"), "the same bytes with three threads")
        found = tool.run("compare", "quick.npy", "exact.npy", "--json").json()
        tap.ok(found["largest"]["value"] <= 1e-4 * found["scale"] and found["rms"] > 0, "as exact as can be seen",
               found)


def the_example(tap, tool):
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "meshes")
    made = subprocess.run([sys.executable, os.path.join(folder, "make_knot.py"), tool.file("knot.ply")], check=False)
    with open(os.path.join(folder, "knot.ply"), "rb") as kept, open(tool.file("knot.ply"), "rb") as again:
        tap.ok(made.returncode == 0 and kept.read() == again.read(), "its mesh is what its program makes")
    made = subprocess.run([sys.executable, os.path.join(folder, "make_pot.py"), tool.file("pot.ply")], check=False)
    with open(os.path.join(folder, "pot.ply"), "rb") as kept, open(tool.file("pot.ply"), "rb") as again:
        tap.ok(made.returncode == 0 and kept.read() == again.read(), "so is the other one's")
    built_in, program = [os.path.join(folder, "..", "..", *way) for way in (
        ("data", "files"), ("tools", "make_still_life.py"))]
    made = subprocess.run([sys.executable, "-B", program, tool.folder], check=False)
    for name in "pot.ply", "knot.ply":
        with open(os.path.join(built_in, name), "rb") as kept:
            tap.ok(made.returncode == 0 and kept.read() == tool.read(name), "so is the built-in " + name)
    checked = tool.run("check", "pot", "--json")
    meshes = checked.json()["meshes"]
    tap.ok(checked.code == 0 and checked.json()["advice_count"] == 0 and len(meshes) == 2 and
           all(mesh["closed"] and mesh["flipped_faces"] == 0 for mesh in meshes) and
           [mesh["euler_number"] for mesh in meshes] == [2, 0], "of a built-in scene without advice", checked)
    result = tool.run("render", os.path.join(folder, "window.yaml"), "--json", "-s", "screen.resolution=[40, 30]")
    tap.ok(result.code == 0 and result.json()["lit"] > 0.9, "under a window", result)
    result = tool.run("render", os.path.join(folder, "knot.yaml"), "--json", "-s", "screen.resolution=[60, 60]")
    tap.ok(result.code == 0 and 0.5 < result.json()["lit"] <= 1, "and it is seen", result)
    result = tool.run("check", os.path.join(folder, "knot.yaml"))
    tap.ok(result.code == 0 and "advice" not in result.out, "a closed mesh without advice", result)


def ring(big=300, small=60, around=48, across=24):
    """A torus of quadrilaterals."""
    corners = []
    for i in range(around):
        for k in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * k / across
            r = big + small * math.cos(v)
            corners.append((r * math.cos(u), r * math.sin(u), small * math.sin(v)))

    def name(i, k):
        return i % around * across + k % across
    return corners, [(name(i, k), name(i + 1, k), name(i + 1, k + 1), name(i, k + 1)) for i in range(around)
                     for k in range(across)]


def surveys(tap, tool):
    corners, faces = mesh_files.box(SIZE)
    x, y, z = SIZE
    tool.write("box.obj", mesh_files.obj(corners, faces))
    tool.write("inwards.obj", mesh_files.obj(corners, [face[::-1] for face in faces]))
    tool.write("flipped.obj", mesh_files.obj(corners, faces[:4] + [faces[4][::-1]] + faces[5:]))
    tool.write("open.obj", mesh_files.obj(corners, faces[1:]))
    tool.write("ring.off", mesh_files.off(*ring()))
    far = [(cx + 1000, cy, cz) for cx, cy, cz in corners]
    two = faces + [tuple(i + len(corners) for i in face) for face in faces]
    tool.write("two.ply", mesh_files.ply(corners + far, two))

    def survey(name, more=""):
        tool.write("scene.yaml", scene(mesh(name, more)))
        result = tool.run("check", "scene.yaml", "--json", *EVENLY)
        (found,) = result.json()["meshes"]
        text = tool.run("check", "scene.yaml", *EVENLY).out
        tap.ok("surfaces[0].file: %s\n" % name in text and "triangles" in text, "the text of " + name, text)
        return found, text

    found, _ = survey("box.obj", "scale: 2, rotate: [10, 20, 30], ")
    tap.ok((found["key"], found["file"], found["triangles"], found["corners"], found["edges"], found["closed"]) ==
           ("surfaces[0].file", "box.obj", 12, 8, 12, True) and found["euler_number"] == 2 and found["parts"] == 1 and
           found["flipped_faces"] == found["open_edges"] == found["crowded_edges"] == 0, "a box", found)
    tap.ok(abs(found["volume_mm3"] / (8 * x * y * z) - 1) < 1e-12 and found["scale_mm"] == 2 and
           all(abs(a - 2 * b) < 1e-9 for a, b in zip(found["size_mm"], SIZE)), "its volume and size", found)
    found, text = survey("inwards.obj")
    tap.ok(abs(found["volume_mm3"] / (x * y * z) + 1) < 1e-12 and found["flipped_faces"] == 0 and
           "its faces look inwards" in text, "inside out", found)
    found, text = survey("flipped.obj")
    tap.ok(found["closed"] and found["flipped_faces"] == 1 and found["volume_mm3"] is None and
           "1, the first is face 5" in text, "a face that looks inwards alone", found, text)
    found, text = survey("open.obj")
    tap.ok(not found["closed"] and found["open_edges"] == 4 and found["euler_number"] == 1 and
           found["volume_mm3"] is None and "no; edges of one face alone: 4" in text, "a box without a lid", found, text)
    found, _ = survey("two.ply")
    tap.ok(found["closed"] and found["parts"] == 2 and found["euler_number"] == 4 and
           abs(found["volume_mm3"] / (2 * x * y * z) - 1) < 1e-12, "two of them", found)
    found, _ = survey("ring.off")
    # between two planes of the axis at an angle t each strip at the distance r has the length 2 r sin(t/2), and lies at
    # r cos(t/2): the area by the distance of its middle by sin t
    area, step = 12 * 60 ** 2 * math.sin(math.pi / 12), math.pi / 24
    exact = area * 2 * math.pi * 300 * math.sin(step) / step
    tap.ok(found["closed"] and found["euler_number"] == 0 and abs(found["volume_mm3"] / exact - 1) < 1e-9,
           "a ring", found)
    tool.write("scene.yaml", scene(mesh("box.obj"), mesh("box.obj"), mesh("box.obj", "scale: 3, ")).replace(
        "points:", "  - {type: volume, mesh: box.obj, radiance: 1}\npoints:"))
    result = tool.run("check", "scene.yaml", "--json").json()["meshes"]
    tap.equal([entry["key"] for entry in result],
              ["surfaces[0].file", "surfaces[1].file", "surfaces[2].file", "lights[2].mesh"], "all that name one")
    text = tool.run("check", "scene.yaml").out
    tap.ok("surfaces[0].file" in text and "surfaces[1].file" not in text and "surfaces[2].file" in text and
           "lights[2].mesh" not in text, "told once for each scale", text)
    tap.ok("box.obj" not in tool.run("check", "scene.yaml", "--quiet").out, "not with --quiet")
    tool.write("plain.yaml", scene("{type: sphere, center: [0, 0, 0], radius: 100}"))
    tap.equal(tool.run("check", "plain.yaml", "--json").json()["meshes"], [], "a scene without meshes")


run_tests(Tap(), formats_agree, strips_and_sparse, as_other_surfaces, balls_tend_to_a_ball, soft_shadows, turns, sides,
          files_are_told, broken_files_end, surveys, highlights_behind,
          as_scenes_go, the_example)
