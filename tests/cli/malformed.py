# SPDX-License-Identifier: MIT
"""Malformed scenes, each the example scene with one piece replaced.

A case is (title, piece, replacement, words).  ^ in the replacement stands where the error must point, and is
not part of the scene; without it only the line of the replacement counts.  The words must be in the message.
"""
from tool import SCENE

RADIUS = "radius: 200"
SPHERE = "type: sphere\n    center: [0, 0, 1000]\n    radius: 200"
PLATE = "type: rectangle\n    center: [0, 0, 1000]\n    size: [200, 100]"
MATERIAL = "material: {model: blinn-phong, diffuse: 0.8, specular: 0.5, shininess: 20, highlight: plain}"
LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
SPOT = "type: spot, position: [2000, 0, 2000], intensity: 10"
CENTER = "center: [0, 0, 2000]"
FLAT = "{type: planar, rectangle: {%s, size: [100, 50]}, " % CENTER
SQUARE = "[0, 0, 2000], [0, 9, 2000], [9, 9, 2000]"
PICTURE = "picture: {range: max, rounding: truncate}"
GRID = "grids: [{%s, size: [10, 10], " % CENTER
SCREEN = "screen: {width: 500, height: 500, resolution: [36, 36], sampling: nodes}"

PIECES = [
    # keys
    ("unknown key", "units:", "^unitz:", "unitz units"),
    ("unknown key of the screen", "width:", "^widht:", "widht width"),
    ("unknown key of a surface", RADIUS, "^radios: 200", "radios radius"),
    ("unknown key of the material", "shininess", "^shinyness", "shinyness shininess"),
    ("unknown key of a light", "intensity", "^intensty", "intensty intensity"),
    ("unknown key of another type", "intensity: 10,", "intensity: 10, ^falloff: hard,", "falloff"),
    ("key in the wrong case", "units:", "^Units:", "Units units"),
    ("doubled key", "units: radiometric", "units: radiometric\n^units: photometric", "units"),
    ("doubled key of the screen", "width: 500,", "width: 500, ^width: 500,", "width"),
    ("doubled key of a light", "intensity: 10,", "intensity: 10, ^intensity: 10,", "intensity"),
    ("missing luxel", "luxel: 1\n", "", "luxel"),
    ("missing screen", SCREEN, "#", "screen"),
    ("missing width", "{width: 500, ", "^{", "width"),
    ("missing resolution", " resolution: [36, 36],", "", "resolution"),
    ("missing observer", "observer:", "#", "observer"),
    ("missing z", "{z: 1500, projection", "^{projection", "z"),
    ("missing lights", "lights:\n  - " + LIGHT, "#", "lights"),
    ("missing surfaces", SCENE[SCENE.index("surfaces"):SCENE.index("lights")], "", "surfaces"),
    ("missing type of a surface", "- type: sphere\n    center", "- ^center", "type"),
    ("missing radius", RADIUS, "", "radius"),
    ("missing center", "    center: [0, 0, 1000]\n", "", "center"),
    ("missing type of a light", "{type: point, ", "^{", "type"),
    ("missing position", "{type: point, position: [2000, 0, 2000],", "^{type: point,", "position"),
    ("missing intensity", "{type: point, position: [2000, 0, 2000], intensity: 10,",
     "^{type: point, position: [2000, 0, 2000],", "intensity"),
    ("key without value", RADIUS, "radius:", ""),
    ("null", RADIUS, "radius: ^null", ""),
    ("axis and aim", LIGHT, "{type: point, pattern: lambertian, position: [2000, 0, 2000], intensity: 10, "
     "axis: [0, 0, -1], aim: [0, 0, 1]}", "axis aim"),
    ("practical without k", "attenuation: none", "attenuation: practical", "k"),
    ("cosine without exponent", "attenuation: none", "pattern: cosine", "exponent"),
    ("merge key", "units: radiometric", "^<<: {units: radiometric}", ""),
    # types
    ("text for a number", RADIUS, "radius: ^big", "big number"),
    ("quoted number", RADIUS, 'radius: ^"200"', "number"),
    ("true for a number", RADIUS, "radius: ^true", "true number"),
    ("number with unit", RADIUS, "radius: ^200mm", "200mm"),
    ("decimal comma", RADIUS, "radius: ^200,5", "200,5"),
    ("hexadecimal number", RADIUS, "radius: ^0xc8", "0xc8"),
    ("nan", RADIUS, "radius: ^.nan", ""),
    ("infinity", RADIUS, "radius: ^.inf", ""),
    ("number beyond float64", RADIUS, "radius: ^1e999", "1e999"),
    ("list for a number", RADIUS, "radius: ^[200]", ""),
    ("mapping for a number", RADIUS, "radius: ^{mm: 200}", ""),
    ("number for a list", "[2000, 0, 2000]", "^2000", ""),
    ("two numbers for three", "[2000, 0, 2000]", "^[2000, 0]", "3"),
    ("four numbers for three", "[2000, 0, 2000]", "[2000, 0, 2000, 1]", "3"),
    ("text in a list of numbers", "[2000, 0, 2000]", "[2000, ^x, 2000]", "x"),
    ("nan in a list", "[2000, 0, 2000]", "[2000, ^.nan, 2000]", ""),
    ("mapping for a list", "lights:\n  - " + LIGHT, "lights: ^{a: 1}", ""),
    ("list for a mapping", SCREEN, "screen: ^[500, 500]", ""),
    ("scalar for a mapping", SCREEN, "screen: ^large", ""),
    ("scalar for a material", MATERIAL, "material: ^shiny", ""),
    ("scalar for a light", LIGHT, "^bulb", ""),
    ("points of one number", "[[0, 0], [150, 0]", "[^[0], [150, 0]", ""),
    ("points without pairs", "[[0, 0], [150, 0], [-150, 0]]", "[^0, 0]", ""),
    ("fraction for a whole number", "[36, 36]", "[^36.5, 36]", "36.5"),
    ("number for yes or no", "diffuse: 0.8", "over_pi: ^1", ""),
    ("yes for true", "diffuse: 0.8", "normalized: ^yes", "true"),
    ("number for a word", "units: radiometric", "units: ^5", ""),
    ("tagged value", RADIUS, "radius: !!str 200", ""),
    # values
    ("another version", "luxel: 1", "luxel: ^2", ""),
    ("zero radius", RADIUS, "radius: ^0", ""),
    ("negative radius", RADIUS, "radius: ^-200", "-200"),
    ("zero width", "width: 500", "width: ^0", ""),
    ("negative height", "height: 500", "height: ^-500", ""),
    ("no pixels", "[36, 36]", "[^0, 36]", ""),
    ("too many pixels", "[36, 36]", "[36, ^65537]", "65536"),
    ("negative resolution", "[36, 36]", "[^-36, 36]", ""),
    ("pixels that are not square", "[36, 36]", "[36, 30]", "square"),
    ("screen whose pixels are not square", "width: 500", "width: 400", "square"),
    ("unknown sampling", "sampling: nodes", "sampling: ^node", "node nodes"),
    ("unknown projection", "orthographic", "^ortographic", "ortographic orthographic"),
    ("unknown view", "view: parallel", "view: ^paralel", "parallel"),
    ("unknown units", "radiometric", "^radiometrick", "radiometric"),
    ("unknown type of surface", "type: sphere", "type: ^shpere", "shpere sphere"),
    ("unknown type of light", "type: point", "type: ^pointt", "pointt point"),
    ("unknown model", "blinn-phong", "^blin-phong", "blinn-phong"),
    ("unknown highlight", "highlight: plain", "highlight: ^plane", "plain"),
    ("unknown attenuation", "attenuation: none", "attenuation: ^inverse", "inverse-square"),
    ("unknown range", "range: max", "range: ^maximum", "max"),
    ("unknown rounding", "rounding: truncate", "rounding: ^trunc", "truncate"),
    ("negative diffuse", "diffuse: 0.8", "diffuse: ^-0.8", "-0.8"),
    ("negative specular", "specular: 0.5", "specular: ^-1", ""),
    ("zero shininess", "shininess: 20", "shininess: ^0", ""),
    ("negative intensity", "intensity: 10", "intensity: ^-10", "-10"),
    ("zero k", "attenuation: none", "attenuation: practical, k: ^0", ""),
    ("zero axis", "attenuation: none", "pattern: lambertian, axis: ^[0, 0, 0]", ""),
    ("zero direction", LIGHT, "{type: distant, direction: ^[0, 0, 0], irradiance: 1}", ""),
    ("distant with intensity", LIGHT, "{type: distant, direction: [0, 0, -1], ^intensity: 1}", "intensity"),
    ("spot wider than 90 degrees", LIGHT, "{%s, inner: 20, outer: ^91}" % SPOT, "90"),
    ("spot without outer", LIGHT, "^{%s, inner: 20}" % SPOT, "outer"),
    ("spot with inner beyond outer", LIGHT, "{%s, inner: 40, outer: 30}" % SPOT, "inner outer"),
    ("negative inner", LIGHT, "{%s, inner: ^-1, outer: 30}" % SPOT, "-1"),
    ("unknown falloff", LIGHT, "{%s, inner: 10, outer: 30, falloff: ^smooth}" % SPOT, "smoothstep"),
    ("no surfaces", SCENE[SCENE.index("surfaces"):SCENE.index("lights")], "surfaces: ^[]\n", ""),
    ("rectangle without size", SPHERE, "^type: rectangle\n    center: [0, 0, 1000]", "size"),
    ("rectangle with a radius", SPHERE, PLATE + "\n    ^radius: 100", "radius sphere"),
    ("rectangle without width", SPHERE, "type: rectangle\n    center: [0, 0, 1000]\n    size: [^0, 100]", "> 0 mm"),
    ("rectangle of one side", SPHERE, "type: rectangle\n    center: [0, 0, 1000]\n    size: ^[100]", "2"),
    ("rectangle with a zero axis", SPHERE, PLATE + "\n    axis: ^[0, 0, 0]", "axis"),
    ("rectangle with a zero up", SPHERE, PLATE + "\n    up: ^[0, 0, 0]", "up"),
    ("rectangle with up along its axis", SPHERE, PLATE + "\n    axis: [0.1, 0.2, 0.3]\n    up: ^[-3, -6, -9]",
     "parallel"),
    ("rectangle that shows its back", SPHERE, PLATE + "\n    axis: ^[0, 1, -0.1]", "surfaces[0]"),
    # lights of some size
    ("planar without outline", LIGHT, "^{type: planar, radiance: 1}", "vertices rectangle disk"),
    ("planar with two outlines", LIGHT, FLAT + "^disk: {%s, radius: 5}, radiance: 1}" % CENTER, "rectangle disk"),
    ("planar with a late outline", LIGHT, "{type: planar, disk: {%s, radius: 5}, radiance: 1, ^vertices: [%s]}" % (
        CENTER, SQUARE), "disk vertices"),
    ("planar without strength", LIGHT, "^" + FLAT.rstrip(", ") + "}", "intensity radiance power"),
    ("planar with two strengths", LIGHT, FLAT + "radiance: 1, ^power: 1}", "radiance power"),
    ("planar with all strengths", LIGHT, FLAT + "radiance: 1, ^power: 1, intensity: 1}", "radiance power intensity"),
    ("negative radiance", LIGHT, FLAT + "radiance: ^-1}", "W/(sr·m²)"),
    ("negative power", LIGHT, FLAT + "power: ^-1}", "W"),
    ("keys of a rectangle outside it", LIGHT, "{type: planar, ^center: [0, 0, 2000], radiance: 1}", "rectangle disk"),
    ("outline that is a list", LIGHT, "{type: planar, rectangle: ^[1, 2], radiance: 1}", "rectangle"),
    ("outline without center", LIGHT, "{type: planar, rectangle: ^{size: [1, 2]}, radiance: 1}", "center"),
    ("unknown key of an outline", LIGHT, FLAT.replace("size", "^sise") + "radiance: 1}", "sise size"),
    ("outline of no height", LIGHT, FLAT.replace("50", "^0") + "radiance: 1}", "> 0 mm"),
    ("axis and aim of an outline", LIGHT, FLAT.replace("size", "axis: [0, 0, 1], ^aim: [0, 0, 1], size")
     + "radiance: 1}", "axis aim"),
    ("aim at the center", LIGHT, FLAT.replace("size", "aim: ^[0, 0, 2000], size") + "radiance: 1}", "aim center"),
    ("up along the axis", LIGHT, FLAT.replace("size", "up: ^[0, 0, 3], size") + "radiance: 1}", "up parallel"),
    ("up along the aim", LIGHT, FLAT.replace("size", "up: ^[1, 2, 3], aim: [-1, -2, 1997], size") + "radiance: 1}",
     "up parallel"),
    ("two vertices", LIGHT, "{type: planar, vertices: ^[[0, 0, 2000], [1, 1, 2000]], radiance: 1}", "3"),
    ("vertices of two numbers", LIGHT, "{type: planar, vertices: [^[0, 2000], [1, 1, 2], [2, 3, 4]], radiance: 1}",
     "3"),
    ("vertices that are one", LIGHT, "{type: planar, vertices: ^5, radiance: 1}", "[x, y, z]"),
    ("vertices with a text", LIGHT, "{type: planar, vertices: [%s, [9, ^far, 2000]], radiance: 1}" % SQUARE, "far"),
    ("a corner twice", LIGHT, "{type: planar, vertices: [%s, ^[9, 9, 2000]], radiance: 1}" % SQUARE, "vertices[3]"),
    ("corners on a line", LIGHT, "{type: planar, vertices: ^[[0, 0, 0], [1, 1, 1], [2, 2, 2]], radiance: 1}", "area"),
    ("corners in no plane", LIGHT, "{type: planar, vertices: [%s, [9, 0, 2001]], radiance: 1}" % SQUARE, "plane"),
    ("edges that cross", LIGHT, "{type: planar, vertices: [[0, 0, 20], [9, 9, 20], [9, 0, 20], [0, 5, 20]], power: 1}",
     "cross"),
    ("an area beyond reason", LIGHT, "{type: planar, disk: ^{%s, radius: 1e-60}, radiance: 1}" % CENTER, "area disk"),
    ("no parts", LIGHT, FLAT + "radiance: 1, parts: ^0}", "1 to 1000"),
    ("half a part", LIGHT, FLAT + "radiance: 1, parts: ^0.5}", "whole"),
    ("parts in words", LIGHT, FLAT + "radiance: 1, parts: ^many}", "converged"),
    ("nearly converged", LIGHT, FLAT + "radiance: 1, parts: ^converge}", 'mean "converged"'),
    ("practical without k for a panel", LIGHT, "^" + FLAT + "radiance: 1, attenuation: practical}", "k"),
    ("volume without body", LIGHT, "^{type: volume, radiance: 1}", "box sphere cylinder mesh"),
    ("volume with two bodies", LIGHT, "{type: volume, mesh: a.off, ^sphere: {%s, radius: 5}, radiance: 1}" % CENTER,
     "mesh sphere"),
    ("volume with an intensity", LIGHT, "{type: volume, sphere: {%s, radius: 5}, ^intensity: 1}" % CENTER, "intensity"),
    ("sphere of three facets", LIGHT, "{type: volume, sphere: {%s, radius: 5, facets: ^3}, power: 1}" % CENTER,
     "4 to 1000"),
    ("cylinder of two facets", LIGHT, "{type: volume, cylinder: {%s, radius: 5, height: 1, facets: ^2}, power: 1}"
     % CENTER, "3 to 1000"),
    ("cylinder without height", LIGHT, "{type: volume, cylinder: ^{%s, radius: 5}, power: 1}" % CENTER, "height"),
    ("box of two lengths", LIGHT, "{type: volume, box: {%s, size: ^[5, 5]}, power: 1}" % CENTER, "3"),
    ("mesh by a number", LIGHT, "{type: volume, mesh: ^5, power: 1}", "text"),
    ("mesh that is the scene", LIGHT, "{type: volume, mesh: ^scene.yaml, power: 1}", "OFF OBJ"),
    ("cloud without a file", LIGHT, "^{type: points, pattern: isotropic}", "file"),
    ("file by a number", LIGHT, "{type: points, file: ^5}", "text"),
    ("cloud that is the scene", LIGHT, "{type: points, file: ^scene.yaml}", "line number"),
    ("cloud with a position", LIGHT, "{type: points, file: a.csv, ^position: [1, 2, 3]}", "position"),
    ("cloud without exponent", LIGHT, "^{type: points, file: scene.yaml, pattern: cosine}", "exponent"),
    ("practical cloud without k", LIGHT, "^{type: points, file: scene.yaml, attenuation: practical}", "k"),
    ("cloud with axis and aim", LIGHT, "{type: points, file: scene.yaml, axis: [0, 0, 1], ^aim: [0, 0, 1]}", "axis"),
    # grids
    ("grid without cells", PICTURE, "grids: [^{%s, size: [10, 10]}]" % CENTER, "n"),
    ("grid of no columns", PICTURE, GRID + "n: [^0, 5]}]", "1 to 65536"),
    ("grid of too many cells", PICTURE, GRID + "n: ^[65536, 65536]}]", "10000000"),
    ("grid with up along its axis", PICTURE, GRID + "n: [1, 1], up: ^[0, 0, -1]}]", "up parallel"),
    ("grid with a type", PICTURE, GRID + "n: [1, 1], ^type: plane}]", "type"),
    ("grids without list", PICTURE, "grids: ^{n: [1, 1]}", "list"),
    ("grid that is a number", PICTURE, "grids: [^5]", "mapping"),
    ("observer inside the sphere", "z: 1500", "z: 1000", ""),
    ("observer below the sphere", "z: 1500", "z: -100", ""),
    # the text
    ("unclosed mapping", "sampling: nodes}", "sampling: nodes", ""),
    ("unclosed list", "[2000, 0, 2000]", "[2000, 0, 2000", ""),
    ("unclosed quotes", "units: radiometric", 'units: "radiometric', ""),
    ("tab for indentation", "    radius", "\tradius", ""),
    ("bad indentation", "    radius", "   radius", ""),
    ("no colon", "units: radiometric", "units radiometric", ""),
    ("anchor and alias", RADIUS, "radius: &r 200\n    name: *r", ""),
    ("alias of nothing", RADIUS, "radius: *r", ""),
    ("control character", "units: radiometric", "units: radio\x01metric", ""),
    ("terminal escape", "units: radiometric", 'units: "\x1b[31mred"', ""),
    ("escape in a quoted text", "units: radiometric", 'units: ^"\\e[31mred"', ""),
]

# Whole texts: (title, bytes, line:column or None)
TEXTS = [
    ("empty file", b"", "1:1"),
    ("blank file", b"\n\n  \n", "1:1"),
    ("only a comment", b"# nothing\n", "1:1"),
    ("only a marker", b"---\n", None),
    ("a scalar", b"hello\n", "1:1"),
    ("a list", b"[1, 2]\n", "1:1"),
    ("two documents", SCENE.encode() + b"---\n" + SCENE.encode(), "14:1"),
    ("a second, broken document", SCENE.encode() + b"---\n{", None),
    ("binary", bytes(range(256)) * 16, None),
    ("zeros", b"\0" * 4096, None),
    ("zero byte inside", SCENE.replace("units", "un\0its").encode(), None),
    ("no UTF-8", SCENE.encode().replace(b"units", b"un\xff\xfeits"), None),
    ("UTF-16", SCENE.encode("utf-16").replace(b"l\0u\0x\0", b"x\0u\0x\0"), None),
    ("a PNG", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\0\0\0\0", None),
    ("deep lists", b"luxel: " + b"[" * 100000, None),
    ("deep closed lists", b"luxel: " + b"[" * 5000 + b"]" * 5000, None),
    ("deep mappings", b"{a: " * 50000, None),
    ("deep blocks", "".join(" " * i + "a:\n" for i in range(2000)).encode(), None),
    ("aliases that multiply", b"a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
        "%s: &%s [%s]\n" % (b, b, ", ".join(["*" + a] * 10)) for a, b in zip("abcdefgh", "bcdefghi")).encode(), None),
    ("beyond 64 MB", SCENE.encode() + b"# padding\n" * 6800000, None),
    ("many doubled keys", SCENE.encode() + b"units: radiometric\n" * 20000, None),
    ("many unknown keys", SCENE.encode() + "".join("k%d: 1\n" % i for i in range(20000)).encode(), None),
    ("a very long line", SCENE.replace("units: radiometric", "units: " + "x" * 1000000).encode(), None),
    ("a very long key", ("k" * 1000000 + ": 1\n").encode() + SCENE.encode(), None),
]


def scenes():
    """Yields (title, text, place or line, words) of every case of PIECES."""
    for title, piece, replacement, words in PIECES:
        if SCENE.count(piece) < 1:
            raise ValueError("%s: the scene has no %r" % (title, piece))
        start = SCENE.index(piece)
        before = SCENE[:start] + replacement.split("^")[0]
        text = SCENE[:start] + replacement.replace("^", "") + SCENE[start + len(piece):]
        place = None
        if "^" in replacement:
            place = "%d:%d" % (before.count("\n") + 1, len(before) - before.rfind("\n"))
        yield title, text, place, words.split()
