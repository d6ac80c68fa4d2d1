# SPDX-License-Identifier: MIT
"""luxel isophotes --grid: lines on planes against circles and sums by hand, as text, JSON, CSV and DXF."""
import csv
import io
import json
import math

from tap import Tap
from tool import run_tests

INTENSITY, HEIGHT = 1000.0, 2000.0
SCREEN = {"luxel": 1, "units": "photometric", "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]},
          "observer": {"z": 4000}, "surfaces": []}
LAMP = {"type": "point", "position": [0, 0, HEIGHT], "intensity": INTENSITY}


def scene(tool, *grids, **more):
    tool.write("scene.yaml", json.dumps({**SCREEN, "lights": [LAMP], "grids": grids, **more}))


def illuminance(place, normal):
    """Of the lamp, in lx; places in mm."""
    way = [a - b for a, b in zip((0, 0, HEIGHT), place)]
    distance = math.hypot(*way)
    return INTENSITY * max(0, sum(a * b for a, b in zip(way, normal))) / distance ** 3 * 1e6


def cylindrical(place):
    """About an upright axis: I sin(theta) / (pi r^2)."""
    away = math.hypot(*place[:2])
    return INTENSITY * away / math.pi / math.hypot(away, HEIGHT - place[2]) ** 3 * 1e6


def read_csv(text):
    """Level, closed and places of each line."""
    lines = {}
    for row in csv.DictReader(io.StringIO(text)):
        line = lines.setdefault((row.get("grid"), row["line"]), (float(row["level_lx"]), row["closed"] == "1", []))
        line[2].append(tuple(float(row[key]) for key in ("x_mm", "y_mm", "z_mm")))
    return list(lines.values())


class Drawing:
    """A DXF file, read by its own rules: pairs of a code and a value, sections, tables, entities."""

    def __init__(self, data):
        words = data.decode("ascii").split("\r\n")
        assert words[-1] == "" and len(words) % 2 == 1
        pairs = [(int(words[i]), words[i + 1]) for i in range(0, len(words) - 1, 2)]
        self.comments = [value for code, value in pairs if code == 999]
        self.layers, self.lines, self.words, self.header = {}, [], [], {}
        section, name, item = None, None, {}
        for code, value in [pair for pair in pairs if pair[0] != 999]:
            if code != 0:
                if code == 2 and item == {0: "SECTION"}:
                    section = value
                elif section == "HEADER" and code == 9:
                    name = value
                elif section == "HEADER":
                    self.header.setdefault(name, []).append(value)
                item.setdefault(code, value)
                continue
            self.take(item)
            item = {0: value}
        assert item == {0: "EOF"}, item

    def take(self, item):
        kind = item.get(0)
        if kind == "LAYER":
            self.layers[item[2]] = int(item[62])
        elif kind == "POLYLINE":
            assert item[66] == "1" and int(item[70]) & 8
            self.lines.append((item[8], bool(int(item[70]) & 1), []))
        elif kind == "VERTEX":
            assert item[8] == self.lines[-1][0] and item[70] == "32"
            self.lines[-1][2].append(self.place(item, 10))
        elif kind == "TEXT":
            normal = self.place(item, 210)
            level = abs(normal[0]) < 1 / 64 and abs(normal[1]) < 1 / 64
            x = cross((0, 1, 0) if level else (0, 0, 1), normal)
            x = [part / math.hypot(*x) for part in x]
            y = cross(normal, x)
            at = self.place(item, 10)
            turn = math.radians(float(item[50]))
            self.words.append((item[8], item[1],
                               [sum(parts) for parts in zip(*([at[i] * part for part in axis]
                                                              for i, axis in enumerate((x, y, normal))))],
                               [math.cos(turn) * a + math.sin(turn) * b for a, b in zip(x, y)]))

    @staticmethod
    def place(item, code):
        return tuple(float(item[code + 10 * i]) for i in range(3))


def cross(a, b):
    return [a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3)]


def lines_of(tool, *options):
    result = tool.run("isophotes", "scene.yaml", "-o", "lines.csv", "-o", "lines.dxf", "--json", *options)
    assert (result.code, result.err) == (0, ""), result
    return result.json(), read_csv(tool.read("lines.csv").decode()), Drawing(tool.read("lines.dxf"))


def circles(tap, tool):
    """Under a point lamp each line is a circle, whose radius is known."""
    scene(tool, {"center": [0, 0, 0], "size": [100, 100], "n": [2, 2]},
          {"name": "desk; \u2116 1", "center": [0, 0, 0], "size": [6000, 6000], "n": [6, 6]})
    answer, table, drawing = lines_of(tool, "--grid", "2", "--levels", "200,100,62.5")
    tap.equal(list(answer), ["quantity", "unit", "grid", "levels", "lines", "conventions"], "members of the answer")
    tap.equal((answer["unit"], answer["grid"]), ("lx", "desk; \u2116 1"), "of the grid")
    tap.equal([(line[0], line[1]) for line in table], [(200, True), (100, True), (62.5, True)], "closed lines")
    for level, _, places in table:
        radius = math.sqrt((INTENSITY * HEIGHT * 1e6 / level) ** (2 / 3) - HEIGHT ** 2)
        off = max(abs(math.hypot(*place[:2]) - radius) for place in places)
        tap.ok(off < 0.2 and {place[2] for place in places} == {0}, "the circle of %g lx" % level, off)
    tap.equal([[tuple(vertex) for vertex in line["vertices"]] for line in answer["lines"]],
              [line[2] for line in table], "JSON has the same vertices")
    outline, *lines = drawing.lines
    tap.equal(outline, ("GRIDS", True, [(-3000, -3000, 0), (3000, -3000, 0), (3000, 3000, 0), (-3000, 3000, 0)]),
              "the edges of the plane")
    tap.equal([line[0] for line in lines], ["ISOLUX_200", "ISOLUX_100", "ISOLUX_62_5"], "a layer for each level")
    tap.equal({layer for layer, *_ in drawing.lines + drawing.words}, set(drawing.layers), "no more, no fewer layers")
    for drawn, (_, closed, places) in zip(lines, table):
        far = max(math.dist(a, b) for a, b in zip(drawn[2], places))
        tap.ok(drawn[1] == closed and len(drawn[2]) == len(places) and far < 1e-7, "the drawing has it too", far)
    tap.equal([words[:2] for words in drawing.words],
              [("GRIDS", "desk; \\U+2116 1: lx"), ("ISOLUX_200", "200"), ("ISOLUX_100", "100"),
               ("ISOLUX_62_5", "62.5")], "words beside them")
    tap.ok("mm" in drawing.comments[0] and drawing.header["$ACADVER"] == ["AC1009"], "the unit of lengths is said",
           drawing.comments)
    tap.equal(drawing.header["$EXTMAX"], ["3000", "3000", "0"], "how far it reaches")
    chosen = tool.run("isophotes", "scene.yaml", "--grid", "desk; \u2116 1").out
    tap.ok("desk; \u2116 1" in chosen and "160 " in chosen and "closed" in chosen, "as text, at round levels", chosen)


def slanting(tap, tool):
    """A plane that stands askew: vertices in space, words that lie on it."""
    axis, up = (0.48, 0.6, 0.64), (0, 0, 1)
    scene(tool, {"center": [-500, -300, 700], "size": [3000, 2000], "axis": list(axis), "up": list(up), "n": [6, 4]})
    _, table, drawing = lines_of(tool, "--grid", "1")
    tap.ok(len(table) > 2, "lines")
    high = max(abs(sum((a - b) * c for a, b, c in zip(place, (-500, -300, 700), axis)))
               for line in drawing.lines for place in line[2])
    tap.ok(high < 1e-7, "all vertices on the plane", high)
    off = max(abs(illuminance(place, axis) / level - 1) for level, _, places in table for place in places)
    tap.ok(off < 1e-4, "and on their levels", off)
    across = [part / 0.768374908488 for part in cross(up, axis)]
    for layer, text, place, along in drawing.words:
        on = abs(sum((a - b) * c for a, b, c in zip(place, (-500, -300, 700), axis)))
        tap.ok(on < 1e-6 and math.dist(along, across) < 1e-9, "words on the plane", layer, text, on, along)


def other_measures(tap, tool):
    """Lines of cylindrical illuminance are not those of the plane."""
    scene(tool, {"center": [1500, 0, 1200], "size": [2000, 2000], "n": [4, 4], "measure": "cylindrical"})
    _, table, _ = lines_of(tool, "--grid", "1")
    off = [abs(cylindrical(place) / level - 1) for level, _, places in table for place in places]
    tap.ok(len(off) > 100 and max(off) < 1e-3, "vertices on their levels by that measure", max(off))


def shadows(tap, tool):
    """Where light jumps at the edge of a shadow lines run along that, and have no teeth."""
    plate = {"type": "rectangle", "center": [500, 0, 1000], "size": [500, 4000], "axis": [0, 0, 1], "name": "plate"}
    scene(tool, {"center": [0, 0, 0], "size": [4000, 1000], "n": [8, 2]}, surfaces=[plate])
    _, table, _ = lines_of(tool, "--grid", "1", "--levels", "100,")
    edges = [place[0] for _, _, places in table for place in places if 0 < place[0] < 1700]
    tap.ok(len(edges) > 40 and max(min(abs(x - edge) for edge in (500, 1500)) for x in edges) < 0.1,
           "the shadow's edges", edges[:8])


def refusals(tap, tool):
    scene(tool, {"name": "desk", "center": [0, 0, 0], "size": [1000, 1000], "n": [2, 2]})
    for options, words in ((["--grid", "dusk"], "did you mean desk"), (["--grid", "desk", "--exact"], "--exact"),
                           (["--grid", "desk", "--quantity", "brightness"], "no material"),
                           (["--grid", "desk", "-o", "a.pdf"], "luxel figure"),
                           (["-o", "a.dxf"], "luxel isophotes scene.yaml --grid 1 -o a.dxf")):
        result = tool.run("isophotes", "scene.yaml", *options)
        tap.ok(result.code == 2 and words in result.err and result.out == "", "refused: " + " ".join(options), result)
    hint = tool.run("grid", "scene.yaml", "-o", "a.dxf")
    tap.ok(hint.code == 2 and "luxel isophotes" in hint.err, "luxel grid says who draws", hint)
    tap.equal(tool.files(), ["scene.yaml"], "and nothing is written")
    table = tool.run("isophotes", "scene.yaml", "--grid", "desk", "--csv=excel-ru")
    tap.ok(table.out.startswith("\ufeffline;level_lx;closed;x_mm;y_mm;z_mm"), "as other tables", table.out[:80])


run_tests(Tap(), circles, slanting, other_measures, shadows, refusals)
