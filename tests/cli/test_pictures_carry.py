# SPDX-License-Identifier: MIT
"""Pictures that carry their scene: a .png or .exr file is a SCENE itself and repeats itself byte for byte.

Also the files that carry values, read by readers that are not Luxel's: .csv by Python's csv module, .exr by hand.
"""
import csv
import os
import re
import struct
import zlib

import numpy as np

from tap import Tap
from tool import AT_ONCE, SCENE, run_tests

SPOKEN = SCENE.replace("  - type: sphere\n", "  - type: sphere\n    name: \"Шар № 1: 'левый'\"  # имя\n")
SMALL = ["-s", "screen.resolution=[60, 60]"]


def read_exr(path):
    """The attributes and the picture of an EXR file with uncompressed lines of one float32 channel."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x76\x2f\x31\x01\x02\0\0\0", data[:8]
    at, attributes = 8, {}
    while data[at]:
        name, kind = (data[at:].split(b"\0", 2)[i].decode() for i in (0, 1))
        at += len(name) + len(kind) + 2
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    at += 1
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    columns, rows = right - left + 1, bottom - top + 1
    picture = np.empty((rows, columns), np.float32)
    for row, start in enumerate(struct.unpack_from("<%dQ" % rows, data, at)):
        assert struct.unpack_from("<2i", data, start) == (top + row, 4 * columns)
        picture[row] = np.frombuffer(data, "<f4", columns, start + 8)
    return attributes, picture


def png_chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def png_texts(data):
    """The uncompressed iTXt chunks by key."""
    texts = {}
    for kind, body in png_chunks(data):
        if kind == b"iTXt":
            key, rest = body.split(b"\0", 1)
            assert rest[:4] == b"\0\0\0\0"
            texts[key.decode()] = rest[4:].decode("utf-8")
    return texts


def make_png(*chunks):
    data = b"\x89PNG\r\n\x1a\n"
    for kind, body in chunks:
        data += struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return data


# ---- what is in the files ----

def tables(tap, tool):
    for scene, unit in (SPOKEN, "W/sr"), (SPOKEN.replace("attenuation: none", "attenuation: inverse-square").replace(
            "shininess: 20", "shininess: 20, over_pi: true"), "W/(sr·m²)"):
        for precision, kind in ("single", np.float32), ("double", np.float64):
            tool.write("scene.yaml", scene)
            done = tool.run("render", "scene.yaml", "-o", "a.csv", "-o", "a.npy", "--precision", precision)
            with open(tool.file("a.csv"), newline="", encoding="utf-8") as file:
                head, *lines = csv.reader(file)
            tap.equal((done.code, head), (0, ["x_mm", "y_mm", "value_" + unit]), "the first line: " + unit)
            values = np.load(tool.file("a.npy"))
            y, x = np.mgrid[250:-250:36j, -250:250:36j]
            on = np.hypot(x, y) < 200
            tap.equal(len(lines), int(on.sum()), "a line for each pixel on the surface")
            places = np.array([[float(a), float(b)] for a, b, _ in lines])
            tap.ok(np.allclose(places, np.c_[x[on], y[on]], atol=1e-9), "top-down, from left to right")
            found = np.array([kind(value) for _, _, value in lines])
            tap.ok(np.array_equal(found, values[on]), "each value reads back exactly: " + precision)


def exr_values(tap, tool):
    tool.write("scene.yaml", SPOKEN)
    for precision in "single", "double":
        tool.run("render", "scene.yaml", "-o", "a.exr", "-o", "a.npy", "--precision", precision)
        attributes, picture = read_exr(tool.file("a.exr"))
        tap.ok(np.array_equal(picture, np.load(tool.file("a.npy")).astype(np.float32)), "EXR: the values, " + precision)
        tap.ok(attributes["channels"][1].startswith(b"Y\0\2\0\0\0"), "one channel Y of float32")
        texts = {name: value.decode("utf-8") for name, (kind, value) in attributes.items() if kind == "string"}
        tap.equal([texts["luxel:" + key] for key in ("quantity", "precision", "unit")],
                  ["brightness", precision, "W/sr"], "EXR: what the values are")
        tap.ok("Шар № 1" in texts["luxel:scene"], "EXR: the scene", texts["luxel:scene"])


def png_carries(tap, tool):
    tool.write("scene.yaml", SPOKEN)
    tool.run("render", "scene.yaml", "-o", "a.png", "--quantity", "irradiance", "-s", "lights[0].intensity=20")
    texts = png_texts(tool.read("a.png"))
    tap.equal([texts["luxel:" + key] for key in ("quantity", "precision", "unit")],
              ["irradiance", "single", "relative"], "PNG: what the picture is")
    tool.write("out.yaml", texts["luxel:scene"])
    tap.ok("intensity: 20" in texts["luxel:scene"], "PNG: the scene as it was changed by -s", texts["luxel:scene"])
    tap.equal(tool.run("scene", "a.png").out, texts["luxel:scene"], "luxel scene prints it")
    tap.equal(tool.run("scene", "a.png", "--json").json(),
              {"name": "a.png", "title": None, "text": texts["luxel:scene"]}, "luxel scene --json")
    expected = tool.run("probe", "scene.yaml", "--json", "--quantity", "irradiance", "-s", "lights[0].intensity=20")
    tap.equal(tool.run("probe", "a.png", "--json").out, expected.out, "luxel probe takes it, with its quantity")
    tap.ok(tool.run("check", "a.png").out.startswith("a.png: valid"), "luxel check takes it")
    os.rename(tool.file("a.png"), tool.file("no name at all"))
    tap.equal(tool.run("probe", "no name at all", "--json").out, expected.out, "known by its content")
    with open(tool.file("no name at all"), "rb") as file:
        tap.equal(tool.run("probe", "-", "--json", stdin=file.read()).out, expected.out, "from standard input")


# ---- byte for byte ----

def repeat(tap, tool, name, *arguments):
    """Renders, renders again from each file, and once more from those."""
    made = tool.run("render", *arguments, "-o", "a.png", "-o", "a.exr")
    if not tap.equal(made.code, 0, name):
        return tap.note(made)
    for source in "a.png", "a.exr":
        again = tool.run("render", source, "-o", "b.png", "-o", "b.exr")
        twice = tool.run("render", "b." + source[-3:], "-o", "c.png", "-o", "c.exr")
        tap.equal((again.code, twice.code), (0, 0), "%s: %s is a scene" % (name, source))
        for ending in "png", "exr":
            first = tool.read("a." + ending)
            tap.ok(tool.read("b." + ending) == first and tool.read("c." + ending) == first,
                   "%s: .%s from %s has the same bytes" % (name, ending, source))
        tap.equal(again.out.split("\n", 1)[1], made.out.split("\n", 1)[1], "%s: %s: the same numbers" % (name, source))


def builtin_scenes(tap, tool):
    for name in (scene["name"] for scene in tool.run("scene", "--list", "--json").json()["scenes"]):
        size = re.search(r"resolution: \[(\d+), (\d+)\]", tool.run("scene", name).out).groups()
        width, height = int(size[0]), int(size[1])
        part = next(part for part in (4, 5, 3, 2, 1) if width % part == height % part == 0)  # pixels stay square
        small = ["-s", "screen.resolution=[%d, %d]" % (width // part, height // part)]
        repeat(tap, tool, name, name, *small)
        repeat(tap, tool, name + ", irradiance, double", name, "--quantity", "irradiance", "--precision", "double",
               *small)


def own_scenes(tap, tool):
    tool.write("scene.yaml", "# Заголовок\n\n" + SPOKEN + "# конец\n")
    tool.write("scene.json", '{"luxel": 1, "screen": {"width": 50e1, "height": 500, "resolution": [40, 40]}, '
                             '"observer": {"z": 1.5E3}, "lights": [], "surfaces": [{"type": "sphere", '
                             '"name": "\\u0428\\t\\"x\\" # \\\\", '
                             '"center": [0, -0.0, 1e3], "radius": 123.4567890123456789}]}')
    repeat(tap, tool, "comments and Cyrillic names", "scene.yaml")
    repeat(tap, tool, "JSON", "scene.json")
    repeat(tap, tool, "precision double", "scene.yaml", "--precision", "double")
    for edits in (["lights[0].intensity=0.1"], ["lights=[]"], ["screen.sampling=centers", "picture.range=log"],
                  ["picture={range: [0.1, 7.25], rounding: nearest}", "units=photometric"],
                  ["surfaces[0].name='да: # нет'", "lights[0].name=\"\""],
                  ["lights=[{type: spot, position: [0, 0, 1500], intensity: 1e-3, inner: 5, outer: 60}, "
                   "{type: ambient, irradiance: 3}]", "observer.projection=perspective"]):
        repeat(tap, tool, " ".join(edits), "scene.yaml", *(part for edit in edits for part in ("-s", edit)))
    lights = ", ".join("{type: point, position: [%d, 0, 2000], intensity: 0.01}" % i for i in range(2000))
    repeat(tap, tool, "a scene of 100 kB, which is packed", "scene.yaml", "-s", "lights=[%s]" % lights)
    tap.ok(b"\0\1\0\0\0x" in tool.read("a.png"), "it is packed indeed")


def options_win(tap, tool):
    tool.run("render", "-o", "a.png", "--quantity", "irradiance", "--precision", "double")
    tap.equal(tool.run("render", "a.png", "--json").json()["quantity"], "irradiance", "the picture's quantity")
    found = tool.run("render", "a.png", "--json", "--quantity", "brightness", "-o", "b.npy").json()["quantity"]
    tap.equal((found, np.load(tool.file("b.npy")).dtype.str), ("brightness", "<f8"), "--quantity goes before it")
    tool.run("render", "a.png", "--precision", "single", "-o", "c.npy")
    tap.equal(np.load(tool.file("c.npy")).dtype.str, "<f4", "--precision goes before it")
    tool.run("render", "a.png", "-s", "lights[0].intensity=20", "-o", "d.png")
    tap.ok("intensity: 20" in png_texts(tool.read("d.png"))["luxel:scene"], "-s changes the picture's scene")


def tolerances(tap, tool):
    tool.run("render", "-o", "a.png", "--tolerance", "1e-5", "--light-error", "0.001", *SMALL)
    texts = png_texts(tool.read("a.png"))
    tap.equal((texts["luxel:tolerance"], texts["luxel:light-error"]), ("1e-05", "0.001"), "they are carried")
    tool.run("render", "a.png", "-o", "b.png")
    tap.ok(tool.read("a.png") == tool.read("b.png"), "and count again")


# ---- what is no picture with a scene ----

def without_scene(tap, tool):
    header = (b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))
    rest = ((b"IDAT", zlib.compress(b"\0\0")), (b"IEND", b""))
    tool.write("bare.png", make_png(header, *rest))
    tool.run("render", "-o", "a.npy", *SMALL)
    tool.write("bare.exr", b"\x76\x2f\x31\x01\x02\0\0\0\0")
    for name in "bare.png", "bare.exr", "a.npy":
        kind = name[-3:].upper()
        for command in "render", "probe", "check", "scene":
            result = tool.run(command, name)
            tap.ok(result.code == 3 and "%s:1:1: error: this %s file carries no scene" % (name, kind) in result.err and
                   "hint:" in result.err and not result.out, "%s %s" % (command, name), result)
    tool.write("bad.png", make_png(header, (b"iTXt", b"luxel:scene\0\0\0\0\0luxel: 2\n"), *rest))
    result = tool.run("render", "bad.png")
    tap.ok(result.code == 3 and "bad.png:1:" in result.err, "errors of the carried scene have their place", result)
    good = b"luxel:scene\0\0\0\0\0" + SCENE.encode()
    tool.write("future.png", make_png(header, (b"iTXt", b"luxel:quantity\0\0\0\0\0colour"), (b"iTXt", good), *rest))
    result = tool.run("render", "future.png")
    tap.ok(result.code == 3 and "luxel:quantity" in result.err and "colour" in result.err, "an unknown setting", result)
    tool.write("late.png", make_png(header, rest[0], (b"zTXt", b"luxel:scene\0\0" + zlib.compress(SCENE.encode())),
                                    rest[1]))
    tap.equal(tool.run("probe", "late.png").code, 0, "a scene behind the picture, as a packed Latin text")
    bomb = zlib.compress(b" " * (80 << 20), 9)
    tool.write("bomb.png", make_png(header, (b"iTXt", b"luxel:scene\0\1\0\0\0" + bomb), *rest))
    result = tool.run("check", "bomb.png")
    tap.ok(result.code == 3 and "64 MB" in result.err and result.seconds < AT_ONCE, "a bomb", result)


def damaged(tap, tool):
    tool.write("scene.yaml", SPOKEN)
    tool.run("render", "scene.yaml", "-o", "a.png", "-o", "a.exr")
    for name in "a.png", "a.exr":
        whole = tool.read(name)
        start = whole.index("Шар".encode())
        tool.write("short" + name, whole[:start + 2])
        result = tool.run("render", "short" + name)
        tap.ok(result.code == 3 and "the file ends too early" in result.err, "short " + name, result)
        codes = set()
        for at in list(range(0, 200, 7)) + list(range(start, start + 60, 5)):
            broken = bytearray(whole)
            broken[at] ^= 0x41
            tool.write("broken", bytes(broken))
            result = tool.run("render", "broken", *SMALL, timeout=10)
            codes.add(result.code)
            if result.code not in (0, 3) or (result.code != 0 and "error:" not in result.err):
                tap.ok(False, "byte %d of %s turned" % (at, name), result)
        tap.ok(codes <= {0, 3} and 3 in codes, name + ": damage is an error or does no harm", codes)
    result = tool.run("render", "a.png", "-o", "a.png")
    tap.equal(result.code, 0, "a picture may be replaced by itself")


run_tests(Tap(), tables, exr_values, png_carries, builtin_scenes, own_scenes, options_win, tolerances, without_scene,
          damaged)
