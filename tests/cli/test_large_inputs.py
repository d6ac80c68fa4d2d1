# SPDX-License-Identifier: MIT
"""Files that ask for much: small ones are validated without work that grows beyond their size, large ones and those
that only claim to be large are refused at once, and where memory is short a message says so.
"""
import itertools
import math
import os
import resource
import struct

from tap import Tap
from tool import SCENE, run_tests

LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
SURFACES = SCENE[SCENE.index("surfaces"):SCENE.index("lights")]
PROCESSOR_SECONDS = 20  # no measure of speed: what these files once took was minutes, hours, or all memory


SANITIZED = os.environ.get("LUXEL_SANITIZED")


def limited(megabytes=None):
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))
        if megabytes:
            resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
    return limit


def with_lights(*lights):
    return SCENE.replace(LIGHT, "\n  - ".join(lights))


def outline(corners):
    return "{type: planar, vertices: [%s], radiance: 1}" % ", ".join("[%.6g, %.6g, 2000]" % xy for xy in corners)


def comb(teeth):
    """A polygon of 2 teeth + 2 corners, of which every second one is no ear."""
    return [(i, 0 if i % 2 else 100) for i in range(2 * teeth)] + [(2 * teeth, -100), (0, -100)]


def star(points):
    return [((300 if i % 2 else 100) * math.cos(-math.pi * i / points),
             (300 if i % 2 else 100) * math.sin(-math.pi * i / points)) for i in range(2 * points)]


def many_spheres(count):
    return "surfaces: [%s]\n" % ", ".join(
        "{type: sphere, center: [%d, %d, 500], radius: 1}" % (3 * (i % 50), 3 * (i // 50)) for i in range(count))


def small_files_that_ask_for_much(tap, tool):
    fine_sphere = "{type: volume, sphere: {center: [0, 0, 2000], radius: 9, facets: 1000}, power: 1}"
    cases = {"an outline of 5000 teeth": with_lights(outline(comb(2500))),
             "a star of 5000 corners": with_lights(outline(star(2500))),
             "1000 polyhedra of half a million faces": with_lights(*[fine_sphere] * 1000),
             "800 surfaces and 900 lights": with_lights(*[LIGHT] * 900).replace(SURFACES, many_spheres(800))}
    for title, scene in cases.items():
        tool.write("scene.yaml", scene)
        result = tool.run("check", "scene.yaml", timeout=300, preexec_fn=limited())
        tap.ok(result.code == 0 and len(scene) < 150000, "luxel check: " + title, result)


def npy(shape, descr="<f8"):
    words = ("{'descr': '%s', 'fortran_order': False, 'shape': %s, }" % (descr, shape)).encode()
    return b"\x93NUMPY\x01\0" + struct.pack("<H", len(words)) + words


def exr(width, height):
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channel = b"Y\0" + struct.pack("<4I", 2, 0, 1, 1) + b"\0"
    return (b"\x76\x2f\x31\x01\2\0\0\0" + attribute(b"channels", b"chlist", channel)
            + attribute(b"compression", b"compression", b"\0") + attribute(b"dataWindow", b"box2i", window)
            + attribute(b"displayWindow", b"box2i", window) + attribute(b"lineOrder", b"lineOrder", b"\0")
            + attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
            + attribute(b"screenWindowCenter", b"v2f", bytes(8))
            + attribute(b"screenWindowWidth", b"float", bytes(4)) + b"\0")


def command_for(tool, name):
    """What reads a file of this name: as a scene, as a field (f), as a mesh (m) or as a cloud (c)."""
    if name[0] not in "mc":
        return ["stats" if name[0] == "f" else "check", name]
    kind = "volume, mesh: %s, power: 1" if name[0] == "m" else "points, file: %s"
    tool.write("scene.yaml", with_lights("{type: %s}" % (kind % name)))
    return ["check", "scene.yaml"]


def files_of_a_gigabyte(tap, tool):
    """Each with a good beginning and nothing behind it on the disk."""
    starts = {"s.yaml": b"", "s.png": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "s.exr": exr(4, 4),
              "f.npy": npy("(16384, 16384)"), "f.pfm": b"Pf\n16384 16384\n-1.0\n",
              "f.csv": b"x_mm,y_mm,value_W\n", "f.exr": exr(16384, 16384),
              "m.off": b"OFF\n4 4 6\n", "m.obj": b"v 1 2 3\n", "c.csv": b"1,2,3,4\n", "c.npy": npy("(9999999, 4)")}
    for name, beginning in starts.items():
        with open(tool.file(name), "wb") as file:
            file.write(beginning)
            file.truncate((1 << 30) + 5000)
        result = tool.run(*command_for(tool, name), preexec_fn=limited(None if SANITIZED else 300))
        tap.ok(result.code in (3, 4) and name in result.err and "out of memory" not in result.err,
               "a gigabyte: " + name, result)
        os.remove(tool.file(name))


def claims(tap, tool):
    """Small files that say that they are large."""
    many = "9" * 18
    files = {"f.npy": [npy("(65536, 65536)"), npy("(%s, %s)" % (many, many)), npy("(4294967297, 1)")],
             "f.pfm": [b"Pf\n65536 65536\n-1.0\n", b"Pf\n%s 1\n-1.0\n" % many.encode(), b"Pf\n1e9 1e9\n-1.0\n"],
             "f.exr": [exr(65536, 65536), exr(1 << 30, 1 << 30), exr(-5, 3)],
             "f.csv": [b"x_mm,y_mm,value_W\n0,0,1\n1,1,1\n65000,65000,1\n",
                       b"x_mm,y_mm,value_W\n0,0,1\n1,0,1\n-1e308,1e308,1\n"],
             "m.off": [b"OFF\n999999 999999 0\n", b"OFF\n%s %s 0\n" % (many.encode(), many.encode()),
                       b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n%s 0 1 2\n" % many.encode()],
             "m.obj": [b"v 0 0 0\nf 1 2 %s\n" % many.encode(), b"v 0 0 0\nf -1 -2 -%s\n" % many.encode()],
             "c.npy": [npy("(9999999, 4)"), npy("(%s, 4)" % many)]}
    for name, texts in files.items():
        for i, text in enumerate(texts):
            tool.write(name, text)
            result = tool.run(*command_for(tool, name), preexec_fn=limited(None if SANITIZED else 300))
            tap.ok(result.code in (3, 4) and name in result.err and "out of memory" not in result.err,
                   "a claim: %s %d" % (name, i), result)


def short_of_memory(tap, tool):
    """Something is refused with a message, or done; and then whole."""
    if SANITIZED:
        tap.skip("memory limits", "sanitizers need all addresses for themselves")
        return
    tool.write("cloud.csv", "1,2,3000,4\n" * 300000)
    tool.write("cloud.yaml", with_lights("{type: points, file: cloud.csv}"))
    tool.write("lights.yaml", with_lights(*["{type: point, position: [1, 2, 3000], intensity: 1}"] * 100000))
    tool.write("facets.yaml", with_lights(
        "{type: volume, sphere: {center: [0, 0, 2000], radius: 9, facets: 600}, power: 1}"))
    before = tool.files()
    work = [["render", "-q", "-s", "screen.resolution=[%d, %d]" % (side, side), "-o", "a.npy"]
            for side in (6000, 12000)]
    work += [["probe", "cloud.yaml"], ["check", "lights.yaml"], ["check", "facets.yaml"], ["figure", "-o", "a.png"]]
    for arguments, megabytes in itertools.product(work, (60, 100, 300, 1024, 4096)):
        if arguments[0] == "figure" and megabytes < 300:
            continue  # GLib ends the process where it can have no thread
        result = tool.run(*arguments, preexec_fn=limited(megabytes))
        left = set(tool.files()) - set(before)
        tap.ok((result.code == 0 and len(left) == arguments.count("-o")) or (result.code == 3 and not left and (
            "memory" in result.err)), "%d MB: luxel %s" % (megabytes, " ".join(arguments)), result, left)
        for name in left:
            os.remove(tool.file(name))


run_tests(Tap(), small_files_that_ask_for_much, files_of_a_gigabyte, claims, short_of_memory)
