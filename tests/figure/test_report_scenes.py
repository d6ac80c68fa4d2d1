# SPDX-License-Identifier: MIT
"""Reports of rooms, meshes, reflected light and surfaces that the screen cuts off: what is said holds for the scene,
and what does not hold for it is not said."""
import re
import subprocess

from report_text import near, percent_of, report, rows, says
from tap import Tap
from tool import run_tests

MATT = "{model: lambert, diffuse: %g, over_pi: true}"
WALLS = ("left", "right", "floor", "ceiling", "back", "front")
ROOM = """luxel: 1
units: %(units)s
reflections: %(reflections)s
screen: {width: 3000, height: 2000, resolution: [30, 20]}
observer: {position: [0, 1250, 3000], target: [0, 1250, 0], projection: perspective, view: observer}
surfaces:
  - type: room
    center: [0, 1250, 1500]
    size: [4000, 2500, 4000]
    material: {model: lambert, diffuse: 0.5, over_pi: true}
    materials: {%(walls)s}
%(more)slights:
  - {type: point, name: lamp, position: [0, 2000, 1000], intensity: 100}
  - {type: point, name: side, position: [800, 1900, 1000], intensity: 30}
points: [[0, 0]]
"""
TABLE = ("  - {type: rectangle, name: table, center: [0, 700, 500], size: [1200, 800], axis: [0, 1, 0], "
         "up: [0, 0, -1], material: {model: lambert, diffuse: 0.6, over_pi: true}}\n")
BALL = ("  - {type: sphere, name: ball, center: [900, 300, 500], radius: 200, "
        "material: {model: phong, diffuse: 0.5, specular: 0.2, shininess: 9, highlight: gated, over_pi: true}}\n")
GOOD_ENOUGH = ["--reflected-error", "0.02"]


def write_room(tool, units="photometric", reflections="none", walls="", more=""):
    tool.write("room.yaml", ROOM % {"units": units, "reflections": reflections, "walls": walls, "more": more})


def section(text, name):
    return re.split(r"^## \d+ ", text.split(name, 1)[1], maxsplit=1, flags=re.M)[0]


def materials(tap, tool):
    """A wall that is not named has no row, and the room's own material none where each wall is named."""
    for named in ((), ("floor",), ("left", "ceiling"), WALLS):
        write_room(tool, walls=", ".join("%s: %s" % (wall, MATT % (0.2 + 0.1 * i)) for i, wall in enumerate(named)))
        text = report(tool, "room.yaml")
        table = rows(text[text.index("surfaces\\[0"):text.index("lights\\[0")])
        told = {key.split(".")[1] for key in table if key.startswith("materials.")}
        tap.equal(told, set(named), "walls with a row, of " + (", ".join(named) or "none"))
        tap.equal([table.get("materials.%s.diffuse" % wall, [""] * 3)[2] for wall in named],
                  ["%g" % (0.2 + 0.1 * i) for i in range(len(named))], "and their reflectances")
        tap.equal([table[key][2] for key in table if key == "material.diffuse"], ["0.5"] if named != WALLS else [],
                  "the room's own material")
        strangers = [key for key in table if "shininess" in key or "specular" in key]
        tap.equal(strangers, [], "nothing of a highlight")


def formulas(tap, tool):
    """One formula for all surfaces that reflect by it, with their names where there are several."""
    write_room(tool, more=TABLE)
    method = section(report(tool, "room.yaml"), "Method")
    tap.equal((method.count("\nB = "), "Of surfaces" in method), (1, False), "walls and a table: one formula")
    write_room(tool, walls="floor: " + MATT % 0.2, more=TABLE + BALL)
    method = section(report(tool, "room.yaml"), "Method").replace("\\[", "[").replace("\\]", "]")
    tap.equal((method.count("\nB = "), re.findall("^Of (.*):$", method, re.M)),
              (2, ["surfaces[0], surfaces[0].materials.floor, surfaces[1]", "surfaces[2]"]), "with a ball: two")
    many = "".join(TABLE.replace("500]", "%d]" % (500 + 10 * i), 1) for i in range(20))
    write_room(tool, more=many + BALL)
    method = section(report(tool, "room.yaml"), "Method")
    tap.ok(re.search(r"^Of surfaces\\\[0\\\], .*surfaces\\\[11\\\] and 9 more:$", method, re.M), "twenty", method)


def normals(tap, tool):
    """The normal of each kind of surface that there is, and of no other one."""
    tool.write("cube.off", "OFF\n4 4 0\n0 0 0\n300 0 0\n0 300 0\n0 0 300\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
    mesh = "  - {type: mesh, file: cube.off, position: [-500, 1000, 500], material: {model: lambert, over_pi: true}}\n"
    sentences = {"wall": "of a wall of a room points straight into the room", "plate": "of a plate is its axis",
                 "sphere": "The normal of a sphere", "mesh": "of a mesh is that of the triangle"}
    for more, kinds in (("", ["wall"]), (TABLE, ["wall", "plate"]), (BALL, ["wall", "sphere"]),
                        (mesh, ["wall", "mesh"])):
        write_room(tool, more=more)
        method = section(report(tool, "room.yaml"), "Method")
        for kind, sentence in sentences.items():
            tap.equal(method.count(sentence), kind in kinds, "%s in a scene of %s" % (kind, ", ".join(kinds)))


def reflections(tap, tool):
    """The row, the formulas and the shares at the maximum, of which luxel probe knows, too."""
    for bounces, last in (("none", None), ("1", "1"), ("3", "3"), ("all", r"\infty")):
        for quantity in ("brightness", "irradiance"):
            name = "%s reflections, %s" % (bounces, quantity)
            write_room(tool, reflections=bounces)
            text = report(tool, "room.yaml", "--quantity", quantity, *GOOD_ENOUGH)
            method, found = section(text, "Method"), re.search(r"\\sum_\{n=1\}\^\{(.*?)\} E_n", text)
            tap.equal((rows(text)["reflections"][2], found and found.group(1)), (bounces, last), name)
            tap.equal((method.count("Surfaces reflect light to each other"), "k_d E_r" in method),
                      (bounces != "none", bounces != "none" and quantity == "brightness"), name + ": the method")
            place = rows(text)["true maximum"][1].strip("()\\ ").replace(" ", "")
            point = tool.run("probe", "room.yaml", "-p", place, "--quantity", quantity, "--json",
                             *GOOD_ENOUGH).json()["points"][0]
            says(tap, text, "gives the most there directly", bounces != "none", name)
            says(tap, text, "has the greatest share there", bounces == "none", name)
            values = [light["irradiance"] if quantity == "irradiance" else light["diffuse"] + light["specular"]
                      for light in point["lights"]]
            share = percent_of(text, r"(?:there directly|share there): (\S+) % of the value")
            tap.ok(near(share, 100 * max(values) / point["value"], 0.02), name + ": the greatest share", share, point)
            given = percent_of(text, r"reflect to each other gives (\S+) % of the value there")
            if bounces == "none":
                tap.equal(given, None, name + ": none of it is reflected")
            else:
                tap.ok(near(given, 100 * point["reflected"]["value"] / point["value"], 0.02) and
                       near(given, 100 * (1 - sum(values) / point["value"]), 0.02), name + ": what is reflected", point)
    write_room(tool, units="radiometric", reflections="2")
    says(tap, report(tool, "room.yaml", *GOOD_ENOUGH), "give the irradiance .E_0", True, "radiometric")
    tap.ok("reflections" not in rows(report(tool, "-s", "screen.resolution=[40,40]")), "no row where none was given")


def lengths(tap, tool):
    """Lengths as people write them, and no width where the maximum lies on the edge of what is seen."""
    write_room(tool, more=TABLE)
    conclusions = section(report(tool, "room.yaml"), "Conclusions")
    widths = [float(width) for width in re.findall(r"(\S+) mm (?:to the|downwards|upwards|and)", conclusions)]
    tap.ok("e+" not in conclusions and "e-" not in conclusions, "no powers of ten", conclusions)
    tap.ok(widths and all(width > 1 for width in widths), "no width of nothing", conclusions)
    tap.ok("within 1070 mm to the left" in conclusions, "more than a metre", conclusions)


def views(tap, tool):
    """Which sides of the screen a sphere reaches beyond, by its outline."""
    for x, y, radius in ((0, 0, 200), (0, 0, 300), (100, 0, 200), (0, -90, 180), (-160, 160, 100), (0, 51, 200)):
        text = report(tool, "-s", "screen.resolution=[40,40]", "-s", "surfaces[0].radius=%d" % radius, "-s",
                      "surfaces[0].center=[%d,%d,1000]" % (x, y))
        sides = [side for side, far in (("left", -x), ("right", x), ("bottom", -y), ("top", y)) if far + radius > 250]
        found = re.search(r"surfaces..0.. is not wholly in view: .*sides: (.*)\.$", text, re.M)
        tap.equal(found.group(1).split(", ") if found else [], sides, "a sphere of %d at %d, %d" % (radius, x, y))
    write_room(tool, more=TABLE)
    says(tap, report(tool, "room.yaml"), r"surfaces..0.* is not wholly in view", False, "a room around the observer")


def digits(tap, tool):
    """--digits rounds values, and counts the rounding as an error."""
    exact = tool.run("probe", "--json").json()["points"]
    for count in (1, 3, 5, 17):
        text = report(tool, "-s", "screen.resolution=[90,90]", "--digits", str(count))
        table = rows(text)
        for i, point in enumerate(exact):
            shown, bound = table["P%d" % (i + 1)][1:3]
            tap.equal(shown, "%.*g" % (count, point["value"]), "P%d in %d digits" % (i + 1, count))
            tap.ok(abs(float(shown) - point["value"]) <= 1.06 * float(bound), "and how far that is off", bound)
        for key in ("true maximum", "mean", "median"):
            tap.ok(len(re.sub(r"e.*|^[-0.]*|\.", "", table[key][0])) <= count, "%s in %d" % (key, count), table[key])
    tap.equal(tool.run("report", "-o", "r.md", "--digits", "18").code, 2, "--digits 18")


def choices_in_russian(tap, tool):
    """A Russian report has the scene's choices in Russian, an English one as the scene writes them."""
    write_room(tool, reflections="all", more=BALL)
    for language in ("", "ru"):
        text = report(tool, "room.yaml", *GOOD_ENOUGH, environment={"LANGUAGE": language})
        table = rows(text)
        values = [table[key][2] for key in ("units", "reflections", "screen.sampling", "observer.projection",
                                            "material.highlight", "material.over_pi", "attenuation", "pattern")]
        english = ["photometric", "all", "centers", "perspective", "gated", "true", "inverse-square", "isotropic"]
        if language:
            tap.ok(not any(re.search("[a-z]", value) for value in values), "in Russian", *values)
        else:
            tap.equal(values, english, "in English")


def language_of_pdf(tap, tool):
    """A PDF says its language, in a catalogue that its cross-references lead to, and readers find nothing wrong."""
    for language in ("en", "ru"):
        result = tool.run("report", "-s", "screen.resolution=[40,40]", "-o", "r.pdf",
                          environment={"LANGUAGE": "" if language == "en" else language})
        pdf = tool.read("r.pdf")
        start = int(pdf.rsplit(b"startxref\n", 1)[1].split()[0])
        root = int(re.search(rb"/Root (\d+) 0 R", pdf[start:]).group(1))
        entry = re.match(rb"xref\n(\d+) 1\n(\d{10}) 00000 n \n", pdf[start:])
        tap.ok(result.code == 0 and entry and int(entry.group(1)) == root, language + ": cross-references", pdf[start:])
        catalogue = pdf[int(entry.group(2)):].split(b"endobj")[0]
        tap.ok(catalogue.startswith(b"%d 0 obj\n" % root) and b"/Lang (%s)" % language.encode() in catalogue and
               b"/Pages" in catalogue and b"/Outlines" in catalogue, language + ": the catalogue", catalogue)
        before = int(re.search(rb"/Prev (\d+)", pdf[start:]).group(1))
        tap.equal(pdf[before:before + 5], b"xref\n", language + ": what was there before")
        for program in (["pdfinfo", tool.file("r.pdf")], ["pdftotext", tool.file("r.pdf"), "-"]):
            read = subprocess.run(program, capture_output=True, text=True, check=False)
            tap.ok(read.returncode == 0 and not read.stderr and len(read.stdout) > 100,
                   "%s: %s reads it" % (language, program[0]), read)


def figures_share_a_page(tap, tool):
    """Both pictures of a square screen fit one page, whatever the language."""
    for language in ("", "ru"):
        tool.run("report", "-o", "r.pdf", environment={"LANGUAGE": language})
        pages = subprocess.run(["pdftotext", "-layout", tool.file("r.pdf"), "-"], capture_output=True, text=True,
                               check=True).stdout.split("\f")
        first, second = ("Fig. 1", "Fig. 2") if not language else ("Рис. 1", "Рис. 2")
        tap.equal(len(pages) - 1, 6, "six pages")
        having = [[i for i, page in enumerate(pages) if name in page][0] for name in (first, second)]
        tap.ok(having[1] - having[0] <= (not language), "the figures' pages", having)


def logarithmic_footer(tap, tool):
    """The small print of a figure says the range of its colours."""
    for more, words in (([], "range max"), (["--log"], "range log")):
        tool.run("figure", *more, "-o", "f.pdf", "-s", "screen.resolution=[60,60]")
        read = subprocess.run(["pdftotext", tool.file("f.pdf"), "-"], capture_output=True, text=True, check=True).stdout
        tap.equal(re.findall("range (?:max|log)", " ".join(read.split())), [words], "luxel figure " + " ".join(more))


run_tests(Tap(), materials, formulas, normals, reflections, lengths, views, digits, choices_in_russian,
          language_of_pdf, figures_share_a_page, logarithmic_footer)
