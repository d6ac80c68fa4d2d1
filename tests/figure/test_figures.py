# SPDX-License-Identifier: MIT
"""luxel figure and luxel report: every built-in scene in every format, sizes, texts and fonts, the same bytes again,
even palettes, and what is refused.  test_figures.py LUXEL, on the path of the tests of the command line."""
import json
import math
import re
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zlib

from tap import Tap
from tool import run_tests


def png_parts(data):
    """Width, height, dots per metre and the rows of an 8-bit RGB picture."""
    at, parts = 8, {}
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        parts[kind] = parts.get(kind, b"") + data[at + 8:at + 8 + length]
        at += 12 + length
    width, height, depth, color = struct.unpack(">IIBB", parts[b"IHDR"][:10])
    assert (depth, color) == (8, 2)
    raw, stride = zlib.decompress(parts[b"IDAT"]), 3 * width + 1
    rows = [raw[i * stride + 1:(i + 1) * stride] for i in range(height)]
    assert not any(raw[i * stride] for i in range(height))  # no filters
    return width, height, struct.unpack(">I", parts[b"pHYs"][:4])[0], rows


def text_of(tool, name, order="-layout"):
    return subprocess.run(["pdftotext", order, tool.file(name), "-"], capture_output=True, text=True,
                          check=True).stdout


def builtin_scenes(tool):
    return re.findall(r"^([a-z-]+) +", tool.run("scene", "--list").out, re.M)


def coarse(tool, name):
    """A built-in scene with a quarter of its rows and columns, or half, and integrals to 1e-4: drawn as large in less
    time."""
    resolution = re.search(r"resolution: \[(\d+), (\d+)\]", tool.run("scene", name).out)
    columns, rows = map(int, resolution.groups())
    coarser = 4 if columns % 4 == rows % 4 == 0 else 2
    return [name, "-s", "screen.resolution=[%d,%d]" % (columns // coarser, rows // coarser), "--tolerance", "1e-4"]


def every_scene(tap, tool):
    names = builtin_scenes(tool)
    tap.ok(len(names) >= 14, "built-in scenes", names)
    for name in names:
        scene = coarse(tool, name)
        result = tool.run("figure", *scene, "-o", "f.png", "-o", "f.svg", "-o", "f.pdf",
                          "--section=maximum")
        tap.equal((result.code, result.out, result.err), (0, "", ""), "figures of " + name)
        width, height, density, rows = png_parts(tool.read("f.png"))
        tap.equal((width, density), (round(160 / 25.4 * 200), round(200 / 0.0254)), "%s: as wide as asked for" % name)
        tap.ok(0.5 < height / width < 3 and len({bytes(row) for row in rows}) > 100, "%s: something is drawn" % name)
        ElementTree.fromstring(tool.read("f.svg"))
        unit = tool.run("render", *scene, "--json").json()["unit"]
        label = ("luminance, " if unit == "cd/m²" else "brightness, ") + unit
        # a label that is broken into lines stays together in the order of reading
        text = text_of(tool, "f.pdf", "-raw")
        tap.ok(label in " ".join(text.split()) and "mm" in text, "%s: labels with units" % name, text)


def numbers(tap, tool):
    """What stands in the figure is what the other commands say."""
    tool.run("figure", "-o", "f.pdf", "--levels", "2.5,6.25", "--title", "Two <levels> & a title")
    text = text_of(tool, "f.pdf")
    maximum = tool.run("stats", "--json").json()["maximum"]["value"]
    tap.ok("max %.6g" % maximum in text, "the true maximum", text)
    # turned labels come out letter by letter
    tap.ok(re.search(r"25\s+6\.|6\.\s+25", text) and "Two <levels> & a title" in text, "levels and title", text)
    words = " ".join(text.split())
    tap.ok("highlight plain" in words and "point source (2000, 0, 2000) mm, 10 W/sr" in words, "small print", text)
    fonts = subprocess.run(["pdffonts", tool.file("f.pdf")], capture_output=True, text=True, check=True).stdout
    embedded = [line.split()[-5] for line in fonts.splitlines()[2:]]
    tap.ok(embedded and set(embedded) == {"yes"}, "fonts are embedded", fonts)


def thinned(tap, tool):
    """Isophotes of different levels are drawn no nearer to each other than about a millimetre."""
    tool.run("figure", "report", "--log", "-o", "l.svg")
    lines = []
    for path in re.findall(r'<path ([^>]*stroke-linejoin:round[^>]*stroke-opacity:0.75[^>]*)/>',
                           tool.read("l.svg").decode()):
        numbers = [float(part) for part in re.findall(r"-?[\d.]+", re.search(r' d="([^"]*)"', " " + path).group(1))]
        lines.append(list(zip(numbers[::2], numbers[1::2])))
    nearest = min((math.hypot(a[0] - b[0], a[1] - b[1]) for i, one in enumerate(lines) for other in lines[:i]
                   for a in one[::3] for b in other[::3]), default=0)
    tap.ok(len(lines) >= 5 and nearest > 0.8 * 72 / 25.4, "isophotes by the logarithm are apart", len(lines), nearest)


def titles(tap, tool):
    """Without --title: that of a built-in scene as it is, its name where it was changed, the comment that a file begins
    with; none where it begins otherwise."""
    scene = tool.run("scene", "report").out
    bare = scene[scene.index("luxel:"):]
    tool.write("own.yaml", "# yaml-language-server: $schema=luxel.schema.json\n#\n#  A ball of mine\n# and more\n" +
               bare)
    tool.write("bare.yaml", bare)
    for arguments, stdin, title in ((["report"], "", "The lab report's sphere"),
                                    (["report", "-s", "lights[0].intensity=20"], "", "report"),
                                    (["own.yaml"], "", "A ball of mine"), (["bare.yaml"], "", "250"),
                                    (["-"], scene, "The lab report's sphere"), (["-"], bare, "250")):
        result = tool.run("figure", *arguments, "-o", "f.pdf", stdin=stdin)
        tap.ok(result.code == 0 and text_of(tool, "f.pdf").strip().startswith(title), "the title of " + arguments[0],
               result)


def repeated(tap, tool):
    for ending in ("png", "svg", "pdf"):
        for name in ("a", "b"):
            tool.run("figure", "three-lights", "-o", "%s.%s" % (name, ending), "--threads", "1" if name == "a" else "5")
        tap.equal(tool.read("a." + ending), tool.read("b." + ending), "the same bytes again: ." + ending)
    for ending in ("pdf", "html", "md", "tex"):
        for name in ("a", "b"):
            result = tool.run("report", "-o", "%s.%s" % (name, ending), "--author", "Ann <b> $x$ \\O")
            tap.equal((result.code, result.err), (0, ""), "a report ." + ending)
        tap.equal(tool.read("a." + ending), tool.read("b." + ending), "the same bytes again: report." + ending)


def shapes(tap, tool):
    """Wide and high screens, narrow paper, marks and bands: drawn, and as large as asked for."""
    for size, resolution in (("width=1500", "200,40"), ("height=1500", "40,200")):
        other = "screen.height=300" if size.startswith("width") else "screen.width=300"
        for paper in (60, 90, 300):
            result = tool.run("figure", "-s", "screen." + size, "-s", other,
                              "-s", "screen.resolution=[%s]" % resolution,
                              "-o", "f.png", "--width", str(paper), "--dpi", "100", "--section")
            tap.equal((result.code, result.err), (0, ""), "%s on %d mm" % (size, paper))
            tap.equal(png_parts(tool.read("f.png"))[0], round(paper / 25.4 * 100), "its width")
    for option in ("--bands", "--lines", "--plain", "--log", "--dark", "--stacked", "--no-extrema", "--no-points"):
        result = tool.run("figure", "three-lights", "-o", option + ".png", option, "--dpi", "60", "--section")
        tap.equal((result.code, result.err), (0, ""), option)
    plain = tool.read("--plain.png")
    tap.ok(all(tool.read(option + ".png") != plain for option in ("--bands", "--lines", "--log", "--dark")),
           "which changes the picture")


def lightness(color):
    """CIE L* of an sRGB colour of 0 to 255."""
    linear = [c / 255 / 12.92 if c <= 10.31 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in color]
    y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


def palettes(tap, tool):
    """The bar's colours: their lightness rises evenly, but for those with a middle."""
    names = re.findall(r"^  (\w+)", tool.run("figure", "--palettes").out, re.M)
    tap.ok({"viridis", "cividis", "inferno", "magma", "plasma", "grey", "coolwarm",
            "turbo"} <= set(names), "palettes", names)
    for name in names:
        tool.run("figure", "distant", "-o", "f.png", "--palette", name, "--plain")
        width, height, _, rows = png_parts(tool.read("f.png"))
        # the column of the bar: the one with the most different colours in a row without repeats
        column = max(range(int(width * 0.8), width), key=lambda x: len({row[3 * x:3 * x + 3] for row in rows}))
        colors = [tuple(row[3 * column:3 * column + 3]) for row in rows]
        first, last = min(i for i, c in enumerate(colors) if c != (255, 255, 255)), None
        last = max(i for i, c in enumerate(colors[:int(height * 0.88)]) if c != (255, 255, 255))
        steps = [lightness(c) for c in colors[first + 4:last - 4]]
        changes = [a - b for a, b in zip(steps, steps[1:])]
        if name not in ("coolwarm", "turbo"):
            tap.ok(min(changes) > -0.8, "%s: never darker towards higher values" % name, min(changes))
            tap.ok(steps[0] - steps[-1] > 55, "%s: from dark to light" % name, steps[0], steps[-1])


def planes(tap, tool):
    """The figure of a grid says what luxel grid does."""
    tool.write("office.yaml", tool.run("scene", "office", "-s", "shadows=none", "-s", "lights=" + json.dumps([
        {"type": "point", "name": name, "position": place, "intensity": intensity} for name, place, intensity in (
            ("front left", [-1200, 2800, 1400], 2700), ("back right", [1200, 2800, 4000], 4500))])).out)
    answer = tool.run("grid", "office.yaml", "--json").json()
    for name, axes in (("floor", ("x, mm", "z, mm")), ("desk at the wall", ("x, mm", "z, mm"))):
        grid, = [grid for grid in answer["grids"] if grid["name"] == name]
        result = tool.run("figure", "office.yaml", "--grid", name, "-o", "f.pdf", "-o", "f.png", "-o", "f.svg")
        tap.equal((result.code, result.out, result.err), (0, "", ""), "figure --grid '%s'" % name)
        words = " ".join(text_of(tool, "f.pdf").split())
        for part in (name, *axes, "average %.0f lx" % grid["average"], "minimum %.0f lx" % grid["minimum"]["value"],
                     "maximum %.0f lx" % grid["maximum"]["value"], "U0 = %.3g" % grid["u0"],
                     "on the whole plane: minimum %.0f lx" % grid["extrema"]["minimum"]["value"],
                     "max %.0f" % grid["extrema"]["maximum"]["value"]):
            tap.ok(part in words, "%s says %s" % (name, part), words)
        shown = re.findall(r"\d+", words)
        values = ["%.0f" % value for row in grid["values"] for value in row]
        tap.ok(sum(value in shown for value in values) > 0.7 * len(values), "%s: values at its points" % name, words)
        tap.ok(tool.read("f.png")[:4] == b"\x89PNG" and b"<svg" in tool.read("f.svg"), "as PNG and SVG")
    tool.run("figure", "office.yaml", "--grid", "3", "-o", "g.pdf", "--no-points")
    words = " ".join(text_of(tool, "g.pdf").split())
    tap.ok(all(name in words for name in ("floor", "front left", "back right")), "by number, with its lights", words)
    large = [{"center": [0, 10, 2700], "size": [3800, 4400], "axis": [0, 1, 0], "n": [100, 120]}]
    result = tool.run("figure", "office.yaml", "-s", "grids=" + json.dumps(large), "--grid", "1", "-o", "h.pdf")
    count = len(re.findall(r"\d{2,}", text_of(tool, "h.pdf")))
    tap.ok(result.code == 0 and 60 < count < 450, "values are thinned where there are too many", count, result.err)
    tap.equal([tool.run("figure", "office.yaml", "--grid", "floor", "-o", "%d.pdf" % n, "--threads", str(n)).code
               for n in (1, 3)], [0, 0], "twice")
    tap.ok(tool.read("1.pdf") == tool.read("3.pdf"), "the same bytes for any number of threads")


DAYLIT = """luxel: 1
units: photometric
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
surfaces:
  - {type: room, up: z, center: [0, 0, 0], size: [4000, 4000, 3000], material: {model: lambert},
     openings: [{wall: left, size: [2000, 1000]}]}
lights: [{type: sky, %s, ground: .3}, {type: point, name: lamp, position: [0, 0, 1000], intensity: 500}]
grids: [{name: desk, center: [0, 0, -700], size: [3000, 3000], n: [3, 2]}]
"""


def daylight(tap, tool):
    """The figure of daylight factors has the numbers of luxel daylight, whatever the sky is said by; lamps are off."""
    for sky in ("kind: 16, horizontal: 8000", "kind: 5, zenith: 700",
                "model: perez, direct: 3e4, diffuse: 2e4, extraterrestrial: 127500, sun: {altitude: 40, azimuth: 90}"):
        tool.write("room.yaml", DAYLIT % sky)
        told = tool.run("daylight", "room.yaml", "--json").json()["grids"][0]
        result = tool.run("figure", "room.yaml", "--grid", "desk", "--daylight", "-o", "d.pdf")
        tap.equal((result.code, result.out, result.err), (0, "", ""), "figure --daylight, " + sky)
        words = " ".join(text_of(tool, "d.pdf").split())
        values = [value for row in told["values"] for value in row]
        for part in ("daylight factor in %", "average %.3g %%" % told["mean"], "minimum %.3g %%" % min(values),
                     "maximum %.3g %%" % max(values)):
            tap.ok(part in words, "says " + part, words)
    for arguments, code, part in ((("figure", "room.yaml", "--daylight", "-o", "x.png"), 2, "--grid"),
                                  (("figure", "office", "--grid", "floor", "--daylight", "-o", "x.png"), 3, "no sky")):
        result = tool.run(*arguments)
        tap.ok(result.code == code and part in result.err, "refused: " + " ".join(arguments), result)


SHADOW = """luxel: 1
units: photometric
screen: {width: 3000, height: 3000, resolution: [300, 300]}
observer: {z: 4000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [3000, 2000], material: {model: lambert, diffuse: 0.5}}
  - {type: rectangle, center: [900, 0, 1000], size: [1800, 5000], up: [0.3, 1, 0], material: {model: lambert}}
lights: [{type: point, position: [0, 0, 2000], intensity: 1000}]
grids: [{name: floor, center: [0, 0, 0], size: [2000, 1000], n: [4, 2]}]
"""


def edges(tap, tool):
    """An isolux line along the straight edge of a shadow is straight, and as steep as the edge that throws it."""
    tool.write("shadow.yaml", SHADOW)
    result = tool.run("figure", "shadow.yaml", "--grid", "floor", "--levels", "120,", "--no-points", "-o", "e.svg")
    tap.equal((result.code, result.err), (0, ""), "the figure of a shadow's edge")
    svg = tool.read("e.svg").decode()
    paths = [[tuple(map(float, pair)) for pair in re.findall(r"[ML] ([-0-9.]+) ([-0-9.]+)", path)]
             for path in re.findall(r'<path style="fill:none;[^>]* d="([^"]*)"', svg)]
    lines = [path for path in paths if len(path) > 100]  # words have fewer corners
    tap.equal(len(lines), 1, "one line of it")
    for line in lines:
        (x0, y0), (x1, y1) = line[0], line[-1]
        length = math.hypot(x1 - x0, y1 - y0)
        off = max(abs((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) / length for x, y in line)
        cell = length / len(line)  # about half a sample's
        tap.ok(off < 0.05 * cell, "without teeth", off, cell)
        tap.ok(abs(abs((x1 - x0) / (y1 - y0)) - 0.3) < 1e-3, "as steep as the edge", line[0], line[-1])


REFUSED = [
    (["figure"], "needs a file"),
    (["figure", "-o", "f.bmp"], "known extensions: .png, .svg, .pdf"),
    (["figure", "-o", "f.png", "--palette", "jet"], "the palettes are viridis"),
    (["figure", "-o", "f.png", "--width", "5"], "40 to 1000"),
    (["figure", "-o", "f.png", "--dpi", "5"], "30 to 2400"),
    (["figure", "-o", "f.png", "--dpi", "2400", "--width", "1000"], "dots_per_inch"),
    (["figure", "-o", "f.png", "--bands", "--lines"], "only one"),
    (["figure", "-o", "f.png", "--section=top"], "center, maximum or X,Y"),
    (["figure", "-o", "f.png", "--section=0,9000"], "does not cross"),
    (["figure", "-o", "f.png", "--log", "--scale", "0,5"], "above 0"),
    (["figure", "office", "-o", "f.png", "--grid", "flor"], 'did you mean floor'),
    (["figure", "office", "-o", "f.png", "--grid", "4"], 'numbered from 1 to 3; luxel grid office shows them'),
    (["figure", "office", "-o", "f.png", "--grid", "4"], "no measuring grid"),
    (["figure", "-o", "f.png", "--grid", "1"], "add some under the key grids"),
    (["figure", "office", "-o", "f.png", "--grid", "floor", "--section"], "no sections"),
    (["figure", "office", "-o", "f.png", "--grid", "floor", "--quantity", "brightness"], "measures the irradiance"),
    (["report"], "needs a file"),
    (["report", "-o", "r.doc"], "known extensions: .pdf"),
]


def refused(tap, tool):
    for arguments, words in REFUSED:
        result = tool.run(*arguments)
        tap.equal((result.code, result.out), (2, ""), "refused: " + " ".join(arguments))
        tap.ok(words in result.err, "and said why", result.err)
    result = tool.run("figure", "-o", "nowhere/f.png")
    tap.equal(result.code, 4, "a folder that is not there")
    tap.equal(tool.files(), [], "nothing was written")


def in_digits_of(value, error, most):
    """In the digits that an error leaves: down to the second one of its own."""
    digits = math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 2 if error > 0 else most
    return "%.*g" % (min(digits, most), value)


def reports(tap, tool):
    for name in builtin_scenes(tool):
        scene = coarse(tool, name)
        result = tool.run("report", *scene, "-o", "r.pdf", "-o", "r.html", "-o", "r.md", "--author", "A. Student",
                          "--group", "4321")
        tap.equal((result.code, result.out, result.err), (0, "", ""), "report on " + name)
        text, page = " ".join(text_of(tool, "r.pdf").split()), tool.read("r.html").decode()
        told = [row.strip("|").split("|") for row in re.findall(r"^\| P\d.*", tool.read("r.md").decode(), re.M)]
        for i, point in enumerate(tool.run("probe", *scene, "--json").json()["points"]):
            if point["value"]:
                value, bound = (cell.strip() for cell in told[i][2:4])
                tap.equal(value, in_digits_of(point["value"], point["error"], 12),
                          "%s: the value of P%d" % (name, i + 1))
                rounded = abs(float(in_digits_of(point["value"], point["error"], 12)) - point["value"])
                tap.equal(bound, "%.2g" % (point["error"] + rounded), "%s: and its error" % name)
                tap.ok(value in text and value in page, "%s: in the other formats" % name, text[:3000])
        maximum = tool.run("stats", *scene, "--json").json()["maximum"]
        tap.ok(" %s " % in_digits_of(maximum["value"], maximum["error"], 7) in text and
               ">%s<" % in_digits_of(maximum["value"], maximum["error"], 7) in page, "%s: the true maximum" % name)
        tap.ok(not re.search(r"(src|href)=\"(?!data:|#)", page) and "<script" not in page,
               "%s: no outside links" % name)


# reports on all scenes take as long as all else together
run_tests(Tap(), *([reports] if "reports" in sys.argv[2:] else [
    every_scene, numbers, thinned, titles, repeated, shapes, palettes, planes, daylight, edges, refused]))
