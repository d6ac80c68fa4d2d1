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


def turned(decimals):
    """The cube turned about two axes, each corner rounded."""
    places = []
    for x, y, z in CORNERS:
        z -= 2000
        x, y = 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y
        y, z = 5 / 13 * y - 12 / 13 * z, 12 / 13 * y + 5 / 13 * z
        places.append(tuple(round(c, decimals) for c in (x, y, z + 2000)))
    return places


def value(tool, name, *more):
    tool.write("scene.yaml", scene(name))
    return [point["value"] for point in tool.run("probe", "scene.yaml", "--json", *more).json()["points"]]


def obj(corners, faces):
    return "".join("v %s %s %s\n" % corner for corner in corners) + "".join(
        "f %s\n" % " ".join(str(i + 1) for i in face) for face in faces)


def as_programs_write(tap, tool):
    tool.write("plain.off", off(CORNERS, FACES))
    expected = value(tool, "plain.off")
    plain, text = off(CORNERS, FACES), obj(CORNERS, FACES)
    apart = [corner for face in FACES for corner in (CORNERS[i] for i in face)]
    noisy = [tuple(c + 1e-12 * ((7 * i + k) % 5 - 2) for k, c in enumerate(corner))
             for i, corner in enumerate(apart)]
    singles = [tuple(range(4 * i, 4 * i + 4)) for i in range(6)]
    files = {"mark.off": b"\xef\xbb\xbf" + plain.encode(), "mark.obj": b"\xef\xbb\xbf" + text.encode(),
             "joined.off": plain.replace("OFF\n", "OFF"), "small.off": plain.replace("OFF", "off"),
             "line.off": plain.replace("\n", " "), "mac.obj": text.replace("\n", "\r"),
             "utf-16.obj": text.encode("utf-16"), "thin.obj": text + "f 1 2\nf 3\n",
             "twice.obj": text + text.split("\n")[-2] + "\n",
             "carried on.obj": text.replace("f ", "f \\ \t\n"), "noisy.off": off(noisy, singles)}
    for name, content in files.items():
        tool.write(name, content)
        tap.ok(all(abs(a - b) <= 1e-9 * b for a, b in zip(value(tool, name), expected)), name, name)
    for name, words in (("thin.obj", ["fewer than three", ": 2 (line 15)"]), ("twice.obj", ["there twice", ": 1 "])):
        found = tool.run("check", "scene.yaml", "-s", "lights[0].mesh=" + name)
        tap.ok(found.code == 0 and all(word in found.out for word in words), "told: " + name, found)


def few_digits(tap, tool):
    tool.write("fine.off", off(turned(12), FACES))
    fine = value(tool, "fine.off")
    for decimals in 4, 3, 2, 1:
        tool.write("coarse.off", off(turned(decimals), FACES))
        found = value(tool, "coarse.off")
        tap.ok(all(abs(a - b) <= 10.0 ** -decimals / 20 * b for a, b in zip(found, fine)),
               "a turned cube with %d decimals" % decimals, found, fine)
    dent = turned(3)
    dent[0] = tuple(0.997 * a + 0.003 * b for a, b in zip(dent[0], (0, 0, 2000)))
    triangles = [part for face in FACES for part in (face[:3], (face[0],) + face[2:])]
    tool.write("dent.off", off([tuple(round(c, 3) for c in corner) for corner in dent], triangles))
    tool.write("scene.yaml", scene("dent.off"))
    found = tool.run("check", "scene.yaml")
    tap.ok(found.code == 3 and "not convex" in found.err and " mm outside" in found.err,
           "a dent is none of digits", found)


def in_other_units(tap, tool):
    tool.write("mm.off", off(CORNERS, FACES))
    tool.write("m.off", off([tuple(c / 1000 for c in corner) for corner in CORNERS], FACES))
    tool.write("cm.obj", obj([tuple(c / 10 for c in corner) for corner in CORNERS], FACES))
    expected = value(tool, "mm.off")
    for name, scale in (("m.off", 1000), ("cm.obj", 10)):
        found = value(tool, name, "-s", "lights[0].scale=%s" % scale)
        tap.ok(all(abs(a - b) <= 1e-12 * b for a, b in zip(found, expected)), "scale: %s" % name, found)
    tool.write("scene.yaml", scene("m.off"))
    found = tool.run("check", "scene.yaml")
    tap.ok("0.2 mm across: is the file in metres?" in found.out and "scale: 1000" in found.out, "an odd size", found)
    found = tool.run("check", "scene.yaml", "-s", "lights[0].scale=1000")
    tap.ok("across" not in found.out, "and one of a lamp", found)
    tap.equal(tool.run("check", "scene.yaml", "-s", "lights[0].scale=0").code, 3, "scale: 0")


def bodies_that_are_none(tap, tool):
    dented = CORNERS[:7] + [(0, 0, 2000)]
    lifted = CORNERS[:7] + [(100, 100, 2200)]
    cases = [
        ("a hole", CORNERS, FACES[:5], ["not closed", "line"]),
        ("a face turned round", CORNERS, [FACES[0][::-1]] + FACES[1:], ["not closed", "face 1", "line 11"]),
        ("a second body", CORNERS + [(x + 900, y, z) for x, y, z in CORNERS],
         FACES + [tuple(i + 8 for i in face) for face in FACES], ["convex"]),
        ("a dent", dented, [face for f in FACES for face in ([f[:3], (f[0],) + f[2:]])],
         ["not convex", "line", " mm "]),
        ("a face that is bent", lifted, FACES, ["not flat", "face 2", "line 12", "23.6 mm off", "digits"]),
        ("one bent by more than its digits", [(x + 0.25, y, z) for x, y, z in CORNERS[:7]] + [(100.25, 100, 2102)],
         FACES, ["not flat", "mm off", "allow", "triangles"]),
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
    cases = [("a text", "hello\n", ["is no mesh that is read"]),
             ("nothing", "", ["is no mesh that is read"]),
             ("a decimal comma", "OFF\n1 1 0\n0 0 0,5\n", ["line 3", "corner"]),
             ("binary", b"OFF BINARY\n\0\0\0\1", ["binary OFF"]), ("four dimensions", "4OFF\n1 1 1\n", ["4OFF"]),
             ("a patch", "v 0 0 0\ncstype bezier\n", ["line 2", "free-form"]),
             ("an end too early", "OFF\n8 6 0\n0 0 0\n", ["ends before"]),
             ("huge numbers", "OFF\n1 30000001 0\n", ["million"]),
             ("bytes", bytes(range(256)), ["is no mesh that is read"])]
    for title, text, words in cases:
        tool.write("b\x1b\n.off", text)
        result = tool.run("check", "scene.yaml")
        tap.ok(result.code == 3 and "scene.yaml:11:26: error: " in result.err and "\x1b" not in result.err
               and all(word in result.err for word in words), title, result)


run_tests(Tap(), where_they_are, carried_by_pictures, formats_agree, as_programs_write, few_digits, in_other_units,
          bodies_that_are_none, texts_that_are_none)
