# SPDX-License-Identifier: MIT
"""Files that a scene names: where they are looked for, what is wrong with them, and in which face and line."""
import os

from good_scenes import CORNERS, FACES, FILES
from tap import Tap
from tool import SCENE, run_tests

LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"


def scene(mesh):
    return SCENE.replace(LIGHT, "{type: volume, mesh: %s, power: 5}" % mesh)


def off(corners, faces):
    lines = ["OFF", "%d %d 0" % (len(corners), len(faces))] + [" ".join(map(str, corner)) for corner in corners]
    return "\n".join(lines + ["%d %s" % (len(face), " ".join(map(str, face))) for face in faces]) + "\n"


def where_they_are(tap, tool):
    os.mkdir(tool.file("lamps"))
    os.mkdir(tool.file("lamps/deep"))
    tool.write("lamps/cube.off", FILES["cube.off"])
    tool.write("lamps/scene.yaml", scene("cube.off"))
    tool.write("lamps/deep/scene.yaml", scene("../cube.off"))
    tool.write("absolute.yaml", scene(tool.file("lamps/cube.off")))
    tool.write("astray.yaml", scene("cube.off"))
    for name in "lamps/scene.yaml", "lamps/deep/scene.yaml", "absolute.yaml", tool.file("lamps/scene.yaml"):
        tap.equal(tool.run("check", name).code, 0, "beside the scene: " + name)
    result = tool.run("check", "astray.yaml")
    tap.ok(result.code == 4 and "astray.yaml:11:26: error: cannot read cube.off: " in result.err, "nothing there",
           result)
    result = tool.run("check", "-", stdin=scene("cube.off"))
    tap.ok(result.code == 4 and "<stdin>:11:26: error: cannot read cube.off" in result.err, "nor for standard input",
           result)
    tap.equal(tool.run("check", "-", stdin=scene("lamps/cube.off")).code, 0, "standard input: from the current folder")
    tap.equal(tool.run("check", "lamps/scene.yaml", "-s", "lights[0].mesh=./cube.off").code, 0, "-s: as in the scene")
    result = tool.run("check", "lamps/scene.yaml", "-s", "lights[0].mesh=lamps/cube.off")
    tap.ok(result.code == 4 and "lamps/lamps/cube.off" in result.err, "and only so", result)
    tap.equal(tool.run("check", "-s", "lights=[{type: volume, mesh: lamps/cube.off, power: 1}]").code, 0,
              "a built-in scene: from the current folder")
    result = tool.run("check", "lamps/scene.yaml", "-s", "lights[0].mesh=gone.off", "-s", "screen.width=-1")
    tap.ok(result.code == 3 and "gone.off" in result.err and "width" in result.err, "two errors, one of the scene's",
           result)
    os.mkdir(tool.file("a.off"))
    result = tool.run("check", "-", stdin=scene("a.off"))
    tap.ok(result.code == 4 and "a.off" in result.err, "a folder", result)
    result = tool.run("check", "-", stdin=scene("/dev/zero"))
    tap.ok(result.code == 4 and "cannot read /dev/zero: Is a device" in result.err, "a device", result)


def carried_by_pictures(tap, tool):
    os.mkdir(tool.file("lamps"))
    tool.write("lamps/cube.off", FILES["cube.off"])
    tool.write("lamps/scene.yaml", scene("cube.off"))
    tap.equal(tool.run("render", "lamps/scene.yaml", "-o", "lamps/a.png", "-o", "a.png").code, 0, "a picture")
    tap.equal(tool.run("check", "lamps/a.png").code, 0, "beside the picture")
    result = tool.run("check", "a.png")
    tap.ok(result.code == 4 and "cannot read cube.off" in result.err, "and nowhere else", result)


def formats_agree(tap, tool):
    values = []
    for name in "cube.off", "cube.obj":
        tool.write(name, FILES[name])
        tool.write("scene.yaml", scene(name))
        values.append([point["value"] for point in tool.run("probe", "scene.yaml", "--json").json()["points"]])
    box = SCENE.replace(LIGHT, "{type: volume, box: {center: [0, 0, 2000], size: [200, 200, 200]}, power: 5}")
    tool.write("scene.yaml", box)
    values.append([point["value"] for point in tool.run("probe", "scene.yaml", "--json").json()["points"]])
    tap.ok(values[0] == values[1], "OFF and OBJ", values)
    tap.ok(all(a == b or abs(a - b) <= 1e-12 * abs(b) for a, b in zip(values[0], values[2])), "and a box", values)


def bodies_that_are_none(tap, tool):
    dented = CORNERS[:7] + [(0, 0, 2000)]
    lifted = CORNERS[:7] + [(100, 100, 2200)]
    cases = [
        ("a hole", CORNERS, FACES[:5], ["not closed", "line"]),
        ("a face too many", CORNERS, FACES + [FACES[0]], ["not closed"]),
        ("a face turned round", CORNERS, [FACES[0][::-1]] + FACES[1:], ["not closed", "face 1", "line 11"]),
        ("a second body", CORNERS + [(x + 900, y, z) for x, y, z in CORNERS],
         FACES + [tuple(i + 8 for i in face) for face in FACES], ["convex"]),
        ("a dent", dented, [face for f in FACES for face in ([f[:3], (f[0],) + f[2:]])], ["not convex", "line"]),
        ("a face that is bent", lifted, FACES, ["not flat", "face 2", "line 12"]),
        ("faces that look inwards", CORNERS, [face[::-1] for face in FACES], ["inwards", "counter-clockwise"]),
        ("a flat body", [(x, y, 1000) for x, y, _ in CORNERS[:4]], [(0, 1, 3, 2), (2, 3, 1, 0)], ["body.off"]),
    ]
    tool.write("scene.yaml", scene("body.off"))
    for title, corners, faces, words in cases:
        tool.write("body.off", off(corners, faces))
        result = tool.run("render", "scene.yaml", "-o", "a.png")
        tap.ok(result.code == 3 and "scene.yaml:11:26: error: " in result.err and not result.out
               and all(word in result.err for word in words) and "a.png" not in tool.files(), title, result)


def texts_that_are_none(tap, tool):
    tool.write("scene.yaml", scene('"b\\e\\n.off"'))
    cases = [("a text", "hello\n", ["is no OFF or OBJ file"]),
             ("nothing", "", ["is no OFF or OBJ file"]),
             ("a decimal comma", "OFF\n1 1 0\n0 0 0,5\n", ["line 3", "corner"]),
             ("an end too early", "OFF\n8 6 0\n0 0 0\n", ["ends before"]),
             ("huge numbers", "OFF\n1000001 1000001 0\n", ["million"]),
             ("bytes", bytes(range(256)), ["is no OFF or OBJ file"])]
    for title, text, words in cases:
        tool.write("b\x1b\n.off", text)
        result = tool.run("check", "scene.yaml")
        tap.ok(result.code == 3 and "scene.yaml:11:26: error: " in result.err and "\x1b" not in result.err
               and all(word in result.err for word in words), title, result)


run_tests(Tap(), where_they_are, carried_by_pictures, formats_agree, bodies_that_are_none, texts_that_are_none)
