# SPDX-License-Identifier: MIT
"""luxel photometry: what it tells of right files, of odd ones, and where it sees what is wrong."""
import math
import os
import re
import xml.etree.ElementTree

from luminaires import AXIAL, HEAD, KEYS, ODD, WRONG, eulumdat
from tap import Tap
from tool import run_tests

def lambert(step):
    angles = [step * i for i in range(90 // step + 1)]
    values = [1000 * math.cos(math.radians(angle)) if angle < 90 else 0 for angle in angles]
    return HEAD + "2 1570.796326794897 1 %d 1 1 2 .1 .2 0\n1 1 20\n%s\n0\n%s\n" % (
        len(angles), " ".join(map(str, angles)), " ".join(map(repr, values)))


def told(tap, tool):
    tool.write("lamp.ies", lambert(5))
    result = tool.run("photometry", "lamp.ies", "--json")
    about = result.json()
    tap.equal(result.code, 0, "a Lambert lamp")
    for key, expected in (("format", "LM-63-1995"), ("type", "C"), ("symmetry", "axial"), ("planes", 1),
                          ("angles", 19), ("warnings", []), ("absolute", False), ("watts", 20),
                          ("cie_flux_code", [44, 75, 94, 100, 100]), ("c_angles", [0, 360])):
        tap.equal(about[key], expected, key)
    for key, expected in (("declared_lumens", 1000 * math.pi), ("lorl", 100), ("dff", 100), ("beam_angle", 120)):
        tap.near(about[key], expected, 1e-12, key)
    tap.near(about["flux"]["zone"], 1000 * math.pi, 1e-13, "the zone rule is exact for it")
    tap.near(about["flux"]["linear"], 1000 * math.pi * 0.999364896712247, 1e-13, "the linear rule")
    tap.equal(about["max"], {"intensity": 1000, "c": 0, "gamma": 0}, "the greatest intensity")
    tap.near(about["field_angle"], 2 * 84.26, 1e-3, "the field angle")
    tap.equal(about["opening"], {"shape": "rectangle", "width_mm": 100, "length_mm": 200, "height_mm": 0}, "opening")
    spacing = about["spacing_criterion"]
    tap.near(spacing["c0_c180"], 2 * math.tan(math.acos(0.5 ** 0.25)), 2e-3, "cos^4 is 1/2")
    tap.near(spacing["diagonal"], math.sqrt(2), 2e-3, "cos^4 is 1/4")
    tap.equal([text["text"] for text in about["texts"] if text["keyword"] == "LUMINAIRE"], ["a\nb"], "[MORE]")
    ratios = about["direct_ratios"]
    tap.ok(ratios["room_index"] == [0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5] and
           all(a < b < 1 for a, b in zip(ratios["ratio"], ratios["ratio"][1:])), "direct ratios", ratios)
    shares = (7 / 16, 3 / 4, 15 / 16, 1)  # of the four cones
    weights = (943, -317, 481, -107)
    tap.near(ratios["ratio"][0], sum(a * b for a, b in zip(shares, weights)) / 1000, 1e-3, "by the four cones")
    text = tool.run("photometry", "lamp.ies").out
    for words in ("LM-63-1995, type C", "3141.593 lm", "3139.597 lm", "44 75 94 100 100", "1000 cd at C = 0",
                  "100 mm along C90-C270", "Lampe AG"):
        tap.ok(words in text, "the table has " + words, text)
    tap.equal(tool.run("photometry", "-", "--json", stdin=lambert(5)).json()["flux"], about["flux"], "standard input")


def eulumdat_files(tap, tool):
    tool.write("lamp.ldt", eulumdat())
    about = tool.run("photometry", "lamp.ldt", "--json").json()
    tap.equal((about["format"], about["symmetry"], about["declared_lumens"], about["declared_lorl"]),
              ("EULUMDAT", "axial", 1000, 100), "what it says")
    tap.near(about["max"]["intensity"], 318.31, 1e-14, "cd/klm")
    tap.equal(about["opening"]["shape"], "disk", "a width of 0: round")
    tool.write("two.ldt", eulumdat(line_26="2", line_32="10\n2\nLED\n700\n\n\n5"))
    about = tool.run("photometry", "two.ldt", "--json").json()
    tap.ok("several lamp sets" in about["warnings"][0], "two lamp sets", about)
    tap.equal((len(about["lamps"]), about["declared_lumens"]), (2, 1000), "the first one counts")
    tool.write("absolute.ldt", eulumdat(line_27="-1"))
    tap.equal(tool.run("photometry", "absolute.ldt", "--json").json()["absolute"], True, "absolute photometry")
    tool.write("blank.ldt", eulumdat(line_18="", line_25="", line_29="1000,0", line_44=""))
    result = tool.run("photometry", "blank.ldt", "--json")
    tap.ok(result.code == 0 and result.json()["declared_lumens"] == 1000, "blank numbers, a decimal comma", result)


def encodings(tap, tool):
    text = HEAD.replace("Lampe AG", "Lämpe 54°") + AXIAL
    expected = tool.run("photometry", "-", "--json", stdin=text).json()
    for title, data in (("Latin-1", text.encode("latin-1")), ("a byte order mark", b"\xef\xbb\xbf" + text.encode()),
                        ("UTF-16", text.encode("utf-16")), ("CR", text.replace("\n", "\r").encode()),
                        ("CR LF", text.replace("\n", "\r\n").encode()),
                        ("CR CR LF", text.replace("\n", "\r\r\n").encode()),
                        ("the end of a file of DOS", text.encode() + b"\x1a"),
                        ("commas", (KEYS.replace("Lampe AG", "Lämpe 54°") + "TILT=NONE\n" +
                                    AXIAL.replace(" ", ",")).encode())):
        tool.write("lamp.ies", data)
        tap.equal(tool.run("photometry", "lamp.ies", "--json").json(), expected, title)
    commas = HEAD + AXIAL.replace(".1 .2", "0,1 0,2")
    about = tool.run("photometry", "-", "--json", stdin=commas).json()
    tap.ok(about["opening"]["width_mm"] == 100 and "decimal commas" in about["warnings"][0], "decimal commas", about)


def padded(tap, tool):
    """Zero bytes behind a file are padding; and planes from 90 to 270 are what they are in files of any version."""
    plain = tool.run("photometry", "-", "--json", stdin=lambert(5)).json()
    for behind in b"\0", b"\0" * 512, b"\x1a" + b"\0" * 7:
        found = tool.run("photometry", "-", "--json", stdin=lambert(5).encode() + behind)
        tap.ok(found.code == 0 and found.json() == plain, "zero bytes behind the end", found)
    rows = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n"
    halves = HEAD + "1 -1 1 3 5 1 2 .1 .2 0\n1 1 10\n0 45 90\n90 135 180 225 270\n" + rows
    whole = HEAD + "1 -1 1 3 9 1 2 .1 .2 0\n1 1 10\n0 45 90\n0 45 90 135 180 225 270 315 360\n" + (
        "7 8 9 4 5 6 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 10 11 12 7 8 9\n")
    right = tool.run("photometry", "-", "--json", stdin=whole).json()
    for version in "1995", "2002", "1991":
        found = tool.run("photometry", "-", "--json", stdin=halves.replace("1995", version)).json()
        tap.ok(found["symmetry"] == "bilateral 90-270" and found["flux"] == right["flux"] and
               len(found["warnings"]) == (version != "1995"), "planes from 90 to 270, " + version, found["warnings"])


def odd(tap, tool):
    for title, text, words in ODD:
        result = tool.run("photometry", "-", "--json", stdin=text)
        about = result.json() if result.code == 0 else {"warnings": []}
        tap.ok(any(words in warning for warning in about["warnings"]), title, result)
    table = tool.run("photometry", "-", stdin=ODD[0][1]).out
    tap.ok("Warnings:\n  line 1, column 1: " in table, "warnings in the table", table)


def wrong(tap, tool):
    for title, text, place, words in WRONG:
        tool.write("lamp", text)
        result = tool.run("photometry", "lamp", "--json")
        found = re.search(r"^lamp:%s: error: .*" % place, result.err, re.M)
        tap.ok(result.code == 4 and result.out == "" and found and words in result.err, title, result)
    several = HEAD + AXIAL.replace("3 1 1 2", "3 1 1 5").replace("500", "x").replace("1 1 10", "0 1 10")
    result = tool.run("photometry", "-", stdin=several)
    tap.equal(result.err.count(": error: "), 3, "all errors at once")
    many = tool.run("photometry", "-", stdin=HEAD + AXIAL.replace("3 1 1", "300 1 1") + "x " * 700)
    tap.ok(20 <= many.err.count("error:") <= 21, "twenty of many, and their number", many)
    result = tool.run("photometry", "none.ies")
    tap.ok(result.code == 4 and "cannot read" in result.err, "no such file", result)
    tap.equal(tool.run("photometry").code, 2, "no file named")
    tap.equal(tool.run("photometry", "a", "b").code, 2, "two files")


def tilt_files(tap, tool):
    os.mkdir(tool.file("lamps"))
    tool.write("lamps/a.tlt", "1\n3\n0 45 90\n1 0.95 0.9\n")
    tool.write("lamps/lamp.ies", KEYS + "TILT=a.tlt\n" + AXIAL)
    about = tool.run("photometry", "lamps/lamp.ies", "--json").json()
    tap.equal(about["tilt"], {"geometry": 1, "angles": [0, 45, 90], "factors": [1, 0.95, 0.9]}, "beside the luminaire")
    tap.equal(about["max"]["intensity"], 1000, "not applied")
    tool.write("lamps/a.tlt", "1\n3\n0 45 40\n1 x 0.9\n")
    result = tool.run("photometry", "lamps/lamp.ies")
    tap.ok(result.code == 4 and "lamps/a.tlt:3:6: error:" in result.err and "lamps/a.tlt:4:3: error:" in result.err,
           "wrong", result)


def conversion(tap, tool):
    tool.write("lamp.ies", lambert(5))
    about = tool.run("photometry", "lamp.ies", "--json").json()
    result = tool.run("photometry", "lamp.ies", "-o", "a.ies", "-o", "b.LDT", "--json")
    tap.ok(result.code == 0 and result.json() == about, "two files and the numbers", result)
    for name, kind in ("a.ies", "LM-63-2002"), ("b.LDT", "EULUMDAT"):
        again = tool.run("photometry", name, "--json").json()
        tap.equal((again["format"], again["warnings"]), (kind, []), name)
        tap.equal((again["opening"], again["declared_lumens"], again["watts"]),
                  (about["opening"], about["declared_lumens"], 20), name + " says the same")
        tap.near(again["max"]["intensity"], 1000, 2e-16, "and has the same greatest intensity")
        tap.near(again["flux"]["zone"], about["flux"]["zone"], 1e-15, "and has the same flux")
    texts = {text["keyword"]: text["text"] for text in tool.run("photometry", "a.ies", "--json").json()["texts"]}
    tap.equal((texts["MANUFAC"], texts["LUMINAIRE"]), ("Lampe AG", "a\nb"), "and the same texts")
    tap.ok(max(map(len, tool.read("a.ies").split(b"\n"))) <= 132, "no line is too long")
    to_pipe = tool.run("photometry", "lamp.ies", "-o", "-", "--format", "ies")
    tap.ok(to_pipe.code == 0 and to_pipe.out.encode() == tool.read("a.ies"), "standard output", to_pipe)
    quiet = tool.run("photometry", "lamp.ies", "-o", "c.ldt", "-q")
    tap.ok(quiet.code == 0 and not quiet.out + quiet.err, "-q", quiet)
    sideways = HEAD + "1 -1 1 3 3 2 2 0 0 0\n1 1 10\n-90 0 90\n-90 0 90\n0 0 0 0 9 0 0 0 0\n"
    tap.equal(tool.run("photometry", "-", "-o", "d.ies", "-q", stdin=sideways).code, 0, "which LM-63 knows")
    result = tool.run("photometry", "lamp.ies", "-o", "a.gif")
    tap.ok(result.code == 2 and ".ldt" in result.err, "another extension", result)
    result = tool.run("photometry", "lamp.ies", "-o", "none/a.ies")
    tap.ok(result.code == 4 and not result.out, "no such folder", result)
    tool.write("wrong.ies", WRONG[6][1])
    tap.ok(tool.run("photometry", "wrong.ies", "-o", "e.ies").code == 4 and "e.ies" not in tool.files(),
           "of a wrong file nothing is written")
    cyrillic = HEAD.replace("Lampe AG", "Светильник") + AXIAL
    tool.run("photometry", "-", "-o", "f.ldt", "-q", stdin=cyrillic)
    tap.ok("Светильник" in tool.read("f.ldt").decode("utf-8"), "what ISO 8859-1 has not is UTF-8")
    tool.run("photometry", "-", "-o", "g.ldt", "-q", stdin=HEAD.replace("Lampe AG", "Lämpe") + AXIAL)
    tap.ok(b"L\xe4mpe" in tool.read("g.ldt"), "what it has is ISO 8859-1")


def turned(tap, tool):
    """Types A and B become type C in EULUMDAT: in the directions of its grid exactly, elsewhere as near as is told."""
    def tables():
        for kind, number in (("B", 2), ("A", 3)):
            for step, width in ((5, 1), (15, 1), (5, 12)):
                angles = [step * i - 90 for i in range(180 // step + 1)]
                rows = []
                for plane in angles:
                    h, v = math.radians(plane), [math.radians(angle) for angle in angles]
                    axis = [math.cos(h) * math.cos(each) for each in v]
                    right = [math.sin(h) * (1 if kind == "B" else math.cos(each)) for each in v]
                    rows.append([max(0, a) ** (2 * width) * (1000 + 300 * r) for a, r in zip(axis, right)])
                yield "%s, %d, %d" % (kind, step, width), HEAD + "1 -1 1 %d %d %d 2 .1 .2 0\n1 1 10\n%s\n%s\n%s\n" % (
                    len(angles), len(angles), number, " ".join(map(repr, angles)), " ".join(map(repr, angles)),
                    "\n".join(" ".join(map(repr, row)) for row in rows))

    scene = ("luxel: 1\nunits: photometric\nscreen: {width: 100, height: 100, resolution: [4, 4]}\n"
             "observer: {z: 9000}\nsurfaces: [{type: sphere, center: [0, 0, -90000], radius: 1}]\n"
             "lights: [{type: luminaire, file: %s, position: [0, 0, 0], opening: point, c0: [1, 0, 0]}]\n")
    for title, text in tables():
        tool.write("lamp.ies", text)
        result = tool.run("photometry", "lamp.ies", "-o", "lamp.ldt", "-q")
        tap.ok(result.code == 0 and not result.err, "-q: " + title, result)
        result = tool.run("photometry", "lamp.ies", "-o", "lamp.ldt")
        told = re.search(r"every ([\d.]+) degrees of C and ([\d.]+) of gamma, .*up to ([\d.e-]+) %", result.err)
        if not tap.ok(result.code == 0 and told, "told: " + title, result):
            continue
        plane, angle, off = map(float, told.groups())
        about = tool.run("photometry", "lamp.ldt", "--json").json()
        before = tool.run("photometry", "lamp.ies", "--json").json()
        tap.ok(about["type"] == "C" and about["planes"] == 360 / plane and about["angles"] == 180 / angle + 1 and
               abs(about["flux"]["linear"] / before["flux"]["linear"] - 1) < 0.02, "the table: " + title, about)
        ways = [(plane * i, angle * j) for i, j in ((0, 0), (3, 5), (7, 11), (25, 20), (40, 17), (66, 3))]
        free = [(0.7 + 13.1 * i % 360, 0.3 + 7.3 * i % 85) for i in range(120)]
        words = []
        for c, gamma in ways + free:
            c, gamma = math.radians(c), math.radians(gamma)
            way = math.sin(gamma) * math.cos(c), -math.sin(gamma) * math.sin(c), -math.cos(gamma)
            words += ["--at", ",".join(repr(x) for x in [2000 * w for w in way] + [-w for w in way])]
        values = []
        for name in "lamp.ies", "lamp.ldt":
            tool.write("scene.yaml", scene % name)
            found = tool.run("probe", "scene.yaml", "--json", "--quantity", "irradiance", *words).json()["points"]
            values.append([4 * point["value"] for point in found])
        greatest = before["max"]["intensity"]
        apart = [abs(a - b) / greatest for a, b in zip(*values)]
        tap.ok(max(apart[:len(ways)]) < 1e-9 and max(apart) <= off / 100 * 1.001 and max(apart) > off / 5000,
               "as near as is told: " + title, max(apart[:len(ways)]), max(apart), off)
        tap.ok(off <= 0.5 or (plane, angle) == (1, 0.5), "as fine as is needed: " + title, plane, angle, off)


def curve(svg, color):
    """The places of the line of a colour, in points."""
    found = re.findall(r'<path [^>]*?stroke(?::|=")rgb\(%s\)[^>]*? d="([^"]*)"' % color, svg)
    longest = max(found, key=len)
    numbers = [float(number) for number in re.findall(r"-?[0-9.]+(?:e-?[0-9]+)?", longest)]
    return list(zip(numbers[::2], numbers[1::2]))


def diagrams(tap, tool):
    if not os.path.exists(os.path.join(os.path.dirname(tool.path), "luxel-draw")):
        tap.skip("diagrams", "built without figures")
        return
    tool.write("lamp.ies", lambert(5))
    names = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}
    for kind in "polar", "cartesian", "cone":
        for ending, start in names.items():
            result = tool.run("photometry", "lamp.ies", "-o", kind + ending, "--diagram", kind, "-q")
            tap.ok(result.code == 0 and tool.read(kind + ending).startswith(start), kind + ending, result)
        xml.etree.ElementTree.parse(tool.file(kind + ".svg"))
    tap.ok(len({tool.read(kind + ".svg") for kind in ("polar", "cartesian", "cone")}) == 3, "three kinds")
    cuts = re.findall(r'd="M ([0-9.]+) ([0-9.]+) L ([0-9.]+) \2 "', tool.read("cone.svg").decode())
    wide = [float(right) - float(left) for left, _, right in cuts]
    tap.ok(len(wide) == 5 and all(abs(wide[i] / wide[4] - (i + 1) / 5) < 1e-3 for i in range(5)),
           "a beam of 120 degrees is a cone as far as 5 m", wide)
    again = tool.run("photometry", "lamp.ies", "-o", "again.svg", "-o", "again.ies", "--json")
    tap.ok(again.code == 0 and tool.read("again.svg") == tool.read("polar.svg") and "again.ies" in tool.files() and
           again.json()["type"] == "C", "polar by default, with a conversion and the numbers", again)
    places = curve(tool.read("polar.svg").decode(), "84%, ?37%, ?0%")
    x, low = places[0][0], max(y for _, y in places)  # the curve of a Lambert lamp is a circle through the middle
    radius = (low - places[0][1]) / 2
    worst = max(abs(math.hypot(px - x, py - places[0][1] - radius) - radius) for px, py in places)
    tap.ok(len(places) > 80 and radius > 20 and worst < 0.003 * radius, "a circle", worst, radius, len(places))
    straight = curve(tool.read("cartesian.svg").decode(), "84%, ?37%, ?0%")
    top, bottom, width = straight[0][1], straight[-1][1], straight[-1][0] - straight[0][0]
    cosines = [(bottom - y) / (bottom - top) - math.cos((px - straight[0][0]) / width * math.pi / 2)
               for px, y in straight]
    tap.ok(len(straight) == 19 and max(map(abs, cosines)) < 1e-4, "a cosine", cosines)
    dark = tool.run("photometry", "lamp.ies", "-o", "dark.svg", "--dark", "--title", "Zimt", "--width", "80")
    tap.ok(dark.code == 0 and tool.read("dark.svg") != tool.read("polar.svg"), "dark, narrow, with a title", dark)
    sideways = HEAD + "1 -1 1 3 3 2 2 0 0 0\n1 1 10\n-90 0 90\n-90 0 90\n0 0 0 0 9 0 0 0 0\n"
    for text in sideways, HEAD + AXIAL.replace("1000 500 0", "0 0 0"), eulumdat(line_44="90\n135\n180\n1\n2\n3"):
        for kind in "polar", "cartesian", "cone":
            result = tool.run("photometry", "-", "-o", "odd.svg", "--diagram", kind, "-q", stdin=text)
            tap.ok(result.code == 0, kind + " of a lamp that is otherwise", result)
    for wrong in ["--diagram", "cone"], ["-o", "a.ies", "--diagram", "polar"], ["-o", "a.svg", "--diagram", "cones"]:
        result = tool.run("photometry", "lamp.ies", *wrong)
        tap.ok(result.code == 2 and "--diagram" in result.err, " ".join(wrong), result)
    result = tool.run("photometry", "lamp.ies", "-o", "a.svg", "--width", "5")
    tap.ok(result.code == 2 and "40 to 1000" in result.err, "too narrow", result)


def sections(tap, tool):
    """Beam and field angles of lamps that do not shine straight down."""
    def beam(planes, rows, gammas=(0, 10, 20, 30, 40, 50, 60, 70, 80, 90)):
        text = HEAD + "1 -1 1 %d %d 1 2 0 0 0\n1 1 10\n%s\n%s\n%s\n" % (
            len(gammas), len(planes), " ".join(map(str, gammas)), " ".join(map(str, planes)),
            "\n".join(" ".join(map(str, row)) for row in rows))
        about = tool.run("photometry", "-", "--json", stdin=text).json()
        return about["beam_angle"], about["field_angle"], about["beam_angles"]

    batwing = [20, 40, 60, 80, 100, 100, 60, 20, 0, 0]
    tap.near(beam([0], [batwing])[0], 2 * 62.5, 1e-12, "a batwing: across the axis")
    tap.near(beam([0], [batwing])[1], 2 * 75, 1e-12, "and its field")
    one_side, dark = [0, 0, 20, 60, 100, 60, 20, 0, 0, 0], [0] * 10
    about = beam([0, 90, 180, 270, 360], [one_side, dark, dark, dark, one_side])
    tap.near(about[0], 2 * 12.5, 1e-12, "one side: around the greatest")
    tap.equal(about[2][1], None, "the section across has no light")
    up = [0] * 10 + [50, 100, 50, 100]
    tap.near(beam([0], [up], (0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 130, 160, 180))[0], 2 * 80, 1e-12,
             "upwards: across the opposite direction")
    tap.equal(beam([0], [[5, 5, 5]], (0, 90, 180))[0], 360, "all around")


def main():
    run_tests(Tap(), told, eulumdat_files, encodings, padded, odd, wrong, tilt_files, conversion, turned, diagrams,
              sections)


main()
