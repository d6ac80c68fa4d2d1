# SPDX-License-Identifier: MIT
"""What reports say: each sentence that stands on a condition, and each row, against numbers computed here or by another
command; the title page in every format; and the text of the scene, whole on one page."""
import re
import subprocess

import numpy as np
import yaml

from report_text import near, percent_of, report, rows, says
from tap import Tap
from tool import run_tests

SMALL = ["-s", "screen.resolution=[90,90]"]


class Sphere:
    """The report's sphere under point sources without attenuation, seen along z, by the published formula."""

    def __init__(self, lights=(((2000, 0, 2000), 10),), kd=0.8, ks=0.5, n=20, gated=False, columns=90):
        self.lights, self.kd, self.ks, self.n, self.gated = lights, kd, ks, n, gated
        places = np.linspace(-250, 250, columns)
        x, y = np.meshgrid(places, -places)
        self.shown = x * x + y * y < 300 ** 2
        self.value, self.shares, self.faced = self.at(x[self.shown], y[self.shown])

    def at(self, x, y):
        z = np.sqrt(300.0 ** 2 - x * x - y * y)
        normal = np.stack([x, y, z]) / 300
        place = np.stack([x, y, z + 1000])
        shares, faced = [], np.zeros(np.shape(x), bool)
        for position, intensity in self.lights:
            light = np.reshape(position, (3,) + (1,) * np.ndim(x)) - place
            light = light / np.sqrt((light ** 2).sum(0))
            cosine = (normal * light).sum(0)
            half = light + np.reshape([0, 0, 1], (3,) + (1,) * np.ndim(x))
            half = (normal * half).sum(0) / np.sqrt((half ** 2).sum(0))
            shine = self.ks * np.maximum(0, half) ** self.n * (cosine > 0 if self.gated else 1)
            shares.append((intensity * self.kd * np.maximum(0, cosine), intensity * shine))
            faced |= (cosine > 0) & (intensity > 0)
        return sum(d + s for d, s in shares), shares, faced


TAIL = "not quite dark all the same"
EXPLAINED = "The minimum above 0 lies where no source shines"


def the_exercise(tap, tool):
    """The report's sphere and its kind: extrema, means, shares and conclusions against NumPy."""
    two = (((2000, 0, 2000), 10), ((-1500, 900, 2500), 4))
    changes = {"gated": ["surfaces[0].material.highlight=gated"], "lambert": ["surfaces[0].material.model=lambert"],
               "no diffuse": ["surfaces[0].material.diffuse=0"], "behind": ["lights[0].position=[900,0,700]"],
               "two": ["lights=[{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}, {type: "
                       "point, name: fill, position: [-1500, 900, 2500], intensity: 4, attenuation: none}]"],
               "plain": []}
    models = {"gated": Sphere(gated=True), "lambert": Sphere(ks=0), "no diffuse": Sphere(kd=0), "two": Sphere(two),
              "behind": Sphere((((900, 0, 700), 10),)), "plain": Sphere()}
    for name, model in models.items():
        text = report(tool, *SMALL, *[part for change in changes[name] for part in ("-s", change)])
        table, values = rows(text), model.value
        lit = values[values >= 1.2e-38]
        reached = values[model.faced & (values >= 1.2e-38)]
        share = model.faced.mean()
        tap.ok(near(table["share of the picture that light reaches"][0], share, 1e-6),
               name + ": the share in the table", table, share)
        tap.ok(near(percent_of(text, r"Light reaches (\S+) % of the picture"), 100 * share, 5e-3),
               name + ": the share in the conclusions", text)
        tap.ok(near(table["mean"][0], values.mean(), 1e-6), name + ": the mean")
        tap.ok(near(table["median"][0], np.median(values), 1e-4), name + ": the median")
        tap.ok(near(table["minimum above 0"][0], lit.min(), 2e-2), name + ": the minimum above 0", table, lit.min())
        tap.ok(near(table["minimum where light arrives"][0], reached.min(), 1e-3) or reached.min() < 1e-5,
               name + ": the least value where light arrives", table, reached.min())
        tap.ok(near(table["maximum of the pixels"][0], values.max(), 1e-5), name + ": the greatest pixel")
        tap.ok(near(percent_of(text, r"The mean is \S+ \S+, (\S+) %"), 100 * values.mean() / values.max(), 5e-3),
               name + ": the mean as a share")
        says(tap, text, TAIL, bool((lit.min() < reached.min())), name)
        says(tap, text, EXPLAINED, bool(lit.min() < reached.min()), name)
        peak = [float(cell) for cell in table["true maximum"][1].strip("()\\").split(",")]
        value, shares, _ = model.at(np.array(peak[0]), np.array(peak[1]))
        tap.ok(near(table["true maximum"][0], value, 1e-6), name + ": the true maximum")
        shine = sum(s for _, s in shares) / value
        says(tap, text, "There all of the value is diffuse reflection", bool(shine == 0), name)
        says(tap, text, "There all of the value is the highlight", bool(shine == 1), name)
        if 0 < shine < 1:
            tap.ok(near(percent_of(text, r"There the highlight gives (\S+) %"), 100 * shine, 5e-3),
                   name + ": the highlight's share")
        says(tap, text, "has the greatest share there", len(shares) > 1, name)
        if len(shares) > 1:
            tap.ok(near(percent_of(text, r"greatest share there: (\S+) %"), 100 * max(d + s for d, s in shares) / value,
                        5e-3), name + ": the greatest share")
        for axis, ways in (("x", "to the left and (\\S+) mm to the right"), ("y", "downwards and (\\S+) mm upwards")):
            found = re.search(r"Along %s the value falls to half of the maximum within (\S+) mm %s" % (axis, ways),
                              text)
            for sign, width in zip((-1, 1), found.groups() if found else ()):
                there = np.array(peak) + sign * float(width) * np.array([axis == "x", axis == "y"])
                tap.ok(near(model.at(*there)[0], value / 2, 0.03), "%s: half of it along %s" % (name, axis))
        points = {"P1": (0, 0), "P2": (150, 0), "P3": (-150, 0)}
        off = {key: abs(float(table[key][3]) - float(model.at(*map(np.array, map(float, place)))[0]))
               for key, place in points.items()}
        worst = max(off, key=off.get)
        found = re.search(r"off by up to (\S+) W/sr \(at (P\d)\): (\S+) % of", text)
        tap.ok(found and found.group(2) == worst and near(found.group(1), off[worst], 1e-2) and
               near(found.group(3), 100 * off[worst] / value, 1e-2), name + ": what pixels are off", found, off)


AMBIENT = "{type: ambient, irradiance: 1}"
POINT = "{type: point, position: [2000, 0, 2000], intensity: %s, attenuation: none}"


def kinds_of_light(tap, tool):
    """Which of the sentences on light stands: by what shines."""
    share = Sphere().faced.mean()
    cases = [("both", [AMBIENT, POINT % 10], True, True), ("ambient", [AMBIENT], True, False),
             ("dark", [POINT % 0], False, False), ("none", [], False, False), ("point", [POINT % 10], False, True),
             ("off", [AMBIENT.replace("}", ", enabled: false}"), POINT % 10], False, True)]
    for name, lights, ambient, direct in cases:
        text = report(tool, *SMALL, "-s", "lights=[%s]" % ", ".join(lights))
        says(tap, text, r"Light reaches \S+ %", direct and not ambient, name)
        says(tap, text, "Ambient light is everywhere; that of the other", direct and ambient, name)
        says(tap, text, "All light is ambient", ambient and not direct, name)
        says(tap, text, "No source shines", not ambient and not direct, name)
        says(tap, text, TAIL, direct and not ambient, name)
        says(tap, text, "brightness is 0 everywhere", not ambient and not direct, name)
        says(tap, text, r"has no peak: it is 0\.8 \S+ in a whole part", ambient and not direct, name)
        says(tap, text, "The mean is", ambient or direct, name)
        says(tap, text, "sections through the maximum", direct, name)
        if direct:
            tap.ok(near(percent_of(text, r"reaches (\S+) % of the picture"), 100 * share, 5e-3), name + ": the share")
    text = report(tool, *SMALL, "-s", "lights=[%s, %s]" % (POINT % 5, POINT % 5))
    says(tap, text, "has the greatest share there", False, "two that give the same")
    text = report(tool, *SMALL, "-s", "surfaces[0].center=[9000,0,1000]")
    says(tap, text, "The screen shows no surface, so there is nothing to conclude", True, "nothing in view")
    says(tap, text, "Light reaches", False, "nothing in view")


def other_scenes(tap, tool):
    """Shadows, perspective, several surfaces and extended sources: the share against the picture of the irradiance in
    float64, in which what is not reached is 0."""
    for name, more in (("two-spheres", []), ("two-spheres", ["-s", "shadows=none"]), ("desk", []), ("spot", []),
                       ("window", []), ("tube", []), ("three-lights", []),
                       ("report", ["-s", "observer.projection=perspective"])):
        shape = re.search(r"resolution: \[(\d+), (\d+)\]", tool.run("scene", name).out)
        columns, lines = (int(part) // 5 for part in shape.groups())
        small = ["-s", "screen.resolution=[%d,%d]" % (columns, lines), *more]
        text = report(tool, name, *small)
        lights = tool.run("probe", name, "-p", "0,0", "--json").json()["points"][0]["lights"]
        direct = [part for light in lights if light["type"] == "ambient"
                  for part in ("-s", "lights[%d].enabled=false" % light["index"])]
        tool.run("render", name, *small, *direct, "--quantity", "irradiance", "--precision", "double", "-o", "e.csv")
        values = np.array([float(line.split(",")[2]) for line in tool.read("e.csv").decode().splitlines()[1:]])
        wanted = 100 * (values > 0).mean()
        tap.ok(near(percent_of(text, r"reaches (\S+) % of the picture"), wanted, 1e-2),
               "%s %s: the share" % (name, more),
               percent_of(text, r"reaches (\S+) % of the picture"), wanted)
        says(tap, text, "Where another surface stands in the way",
             name in ("two-spheres", "desk") and not more, "%s %s" % (name, more))
        says(tap, text, "The normal of a sphere", True, name)
        says(tap, text, "of a plate is its axis", name == "desk", name)


def placed_observers(tap, tool):
    """The frame of a screen that was carried stands in numbers, and lines of sight go by it."""
    place = "observer={position: [0, 900, 1000], target: [0, 0, 1000], up: [0, 0, 2], projection: %s}"
    for projection, formula in (("orthographic", r"x\,\mathbf{X} + y\,\mathbf{Y} - t\,\mathbf{Z}"),
                                ("perspective", r"t\,(\mathbf{T} + x\,\mathbf{X} + y\,\mathbf{Y} - \mathbf{O})")):
        text = report(tool, "-s", place % projection, "-s", "screen.resolution=[40, 40]")
        tap.ok(r"\mathbf{P} = \mathbf{O} + " + formula in text, projection + ": lines of sight", text)
        for wanted in (r"\mathbf{O} = (0,\, 900,\, 1000)", r"\mathbf{X} = (-1,\, 0,\, 0)",
                       r"\mathbf{Y} = (0,\, 0,\, 1)", "centre at the target"):
            tap.ok(wanted in text, projection + ": " + wanted, text)
        tap.ok("z_C" not in text, projection + ": no height along z")


def quantities(tap, tool):
    """Title, aim, task and method name what is computed, by --quantity and the units of the scene, in Russian, too."""
    names = {("radiometric", "brightness"): "brightness", ("photometric", "brightness"): "luminance",
             ("radiometric", "irradiance"): "irradiance", ("photometric", "irradiance"): "illuminance"}
    lights = ("lights=[{type: point, position: [500, 0, 2000], intensity: 4}, {type: ambient, irradiance: 1}, "
              "{type: distant, direction: [0, 0, -1], irradiance: 1}, "
              "{type: planar, disk: {center: [0, 0, 2000], radius: 9}, radiance: 3}]")
    for (units, quantity), name in names.items():
        options = [*SMALL, "-s", "units=" + units, "-s", lights, "--quantity", quantity]
        text = report(tool, *options)
        for sentence in ("^# Distribution of the %s over", "the distribution of the %s over lit surfaces, and how",
                         "Compute how the %s is dist", "^The %s is the sum over"):
            tap.ok(re.search(sentence % name, text, re.M), "%s: %s" % (name, sentence), text[:3000])
        method = text.split("Method")[1].split("Pictures")[0]
        falls = names[units, "irradiance"]
        for sentence in "faces it the %s", "direction .* and %s", "Ambient light of the %s":
            if "Ambient" not in sentence or quantity == "brightness":
                tap.ok(re.search(sentence % falls, method), "%s: %s" % (name, sentence), method)
        wrong = {"illuminance", "luminance"} if units == "radiometric" else {"irradiance", "radiance", "brightness"}
        tap.ok(not any(re.search(r"\b%s\b" % word, method) for word in wrong), name + ": no word of other units",
               method)
        russian = report(tool, *options, environment={"LANGUAGE": "ru"})
        word = "освещённости" if quantity == "irradiance" else "яркости"
        tap.ok(re.search("^# Распределение %s " % word, russian, re.M) and "облуч" not in russian, name + " in Russian",
               russian[:500])


def repetition(tap, tool):
    """The commands that repeat the report do so: their numbers are the report's."""
    text = report(tool, *SMALL, "--quantity", "irradiance", "--precision", "double")
    says(tap, text, "`luxel render scene.yaml --quantity irradiance --precision double`", True, "irradiance")
    tap.ok("brightness" not in text.split("# The lab")[0], "nothing speaks of the brightness", text)
    tool.write("scene.yaml", re.search("```yaml\n(.*?)```", text, re.S).group(1))
    data = tool.run("render", "scene.yaml", "--quantity", "irradiance", "--precision", "double", "--json").json()
    table = rows(text)
    tap.ok(near(table["mean"][0], data["mean"], 1e-6) and near(table["minimum above 0"][0], data["min"]["value"], 1e-6),
           "the same numbers")
    tap.equal(["%.12g" % point["value"] for point in data["points"]], [table["P%d" % i][1] for i in (1, 2, 3)],
              "points")
    text = report(tool, *SMALL, "-s", "points=[]")
    says(tap, text, "in the points asked for", False, "no points")
    says(tap, text, "The scene asks for no points", True, "no points")
    says(tap, report(tool, *SMALL), "in the points asked for", True, "points")


PARAMETERS = [
    ("planar", "rectangle: {center: [100, 200, 3000], size: [400, 500]}, radiance: 7",
     {"rectangle.center": "(100, 200, 3000) mm", "rectangle.size": "(400, 500) mm", "radiance": "7 W/(sr·m²)",
      "attenuation": "inverse-square"}, ["disk.center", "disk.radius", "intensity", "power", "vertices", "k"]),
    ("planar", "disk: {center: [100, 200, 3000], radius: 350}, intensity: 9",
     {"disk.center": "(100, 200, 3000) mm", "disk.radius": "350 mm", "intensity": "9 W/sr"},
     ["rectangle.center", "rectangle.size", "radiance", "power", "vertices"]),
    ("planar", "vertices: [[0, 0, 3000], [0, 90, 3000], [80, 0, 3000]], power: 3, attenuation: practical, k: 40",
     {"vertices": "(0, 0, 3000), (0, 90, 3000), (80, 0, 3000) mm", "power": "3 W", "attenuation": "practical",
      "k": "40 mm"}, ["disk.radius", "rectangle.size", "radiance", "intensity"]),
    ("volume", "box: {center: [0, 100, 3000], size: [30, 40, 50]}, power: 8",
     {"box.center": "(0, 100, 3000) mm", "box.size": "(30, 40, 50) mm", "power": "8 W"},
     ["sphere.radius", "cylinder.radius", "radiance", "mesh"]),
    ("spot", "position: [1, 2, 3000], aim: [0, 0, 1000], intensity: 5, inner: 10, outer: 20",
     {"position": "(1, 2, 3000) mm", "aim": "(0, 0, 1000) mm", "inner": "10°", "outer": "20°",
      "falloff": "smoothstep"}, ["axis", "k"]),
    ("point", "position: [1, 2, 3000], intensity: 5", {"position": "(1, 2, 3000) mm", "intensity": "5 W/sr",
                                                      "pattern": "isotropic"}, ["axis", "aim", "exponent", "k"]),
    ("distant", "direction: [0, 1, -1], irradiance: 4", {"direction": "(0, 1, -1)", "irradiance": "4 W/m²"},
     ["position", "intensity"]),
]


def parameters(tap, tool):
    """Each row against the scene; what was not given and has no effect has none."""
    for kind, keys, wanted, absent in PARAMETERS:
        text = report(tool, *SMALL, "-s", "lights=[{type: %s, %s}]" % (kind, keys))
        table = rows(text[text.index("lights\\[0"):text.index("Method")])
        for key, value in wanted.items():
            tap.equal(table.get(key, ["", "", "nothing"])[2], value, "%s: %s" % (kind, key))
        for key in absent:
            tap.ok(key not in table, "%s: no %s" % (kind, key), table.get(key))
    table = rows(report(tool, *SMALL, "-s", "surfaces[0].material.shininess=33", "-s", "observer.z=1700"))
    for key, symbol, value in (("material.diffuse", "k_d", "0.8"), ("material.specular", "k_s", "0.5"),
                               ("material.shininess", "n", "33"), ("intensity", "I", "10 W/sr"),
                               ("observer.z", "z_O", "1700 mm"), ("radius", "R", "300 mm"),
                               ("screen.resolution", "", "(90, 90)")):
        tap.equal([table[key][0].strip("$"), table[key][2]], [symbol, value], key)


def given_keys(value, prefix=""):
    """The keys of an element of a scene as rows name them, with what they were given."""
    for key, inner in value.items():
        if isinstance(inner, dict):
            yield from given_keys(inner, prefix + key + ".")
        elif key not in ("type", "name", "enabled"):
            yield prefix + key, inner


def says_value(cell, value):
    """Whether a row's cell holds a value of the scene."""
    if isinstance(value, bool):
        return cell == str(value).lower()
    if isinstance(value, str):
        return value in cell
    found = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", cell)]
    wanted = np.ravel(value).tolist()
    return found[:len(wanted)] == wanted


def every_row(tap, tool):
    """Every key that an element of a scene gives has its row, and no row belongs to a group that was not given."""
    volumes = ["{type: volume, box: {center: [0, 900, 2000], size: [90, 80, 70]}, power: 9}",
               "{type: volume, sphere: {center: [0, 900, 2000], radius: 40}, radiance: 7}",
               "{type: volume, cylinder: {center: [0, 900, 2000], radius: 40, height: 300}, radiance: 7}",
               "{type: planar, vertices: [[0, 900, 2000], [0, 950, 2000], [50, 900, 2000]], intensity: 3}",
               "{type: planar, disk: {center: [0, 900, 2000], radius: 30}, power: 3}",
               "{type: planar, rectangle: {center: [0, 900, 2000], size: [30, 20]}, radiance: 3}"]
    scenes = [("report", ["lights=[%s]" % light]) for light in volumes] + [("all-sources", [])]
    for scene, changes in scenes:
        parts = [part for change in changes + ["screen.resolution=[64,64]"] for part in ("-s", change)]
        text = tool.run("report", scene, *parts, "--tolerance", "1e-3", "-o", "r.md") and tool.read("r.md").decode()
        written = yaml.safe_load(tool.run("scene", scene, *parts).out)
        for name in ("surfaces", "lights"):
            for i, element in enumerate(written[name]):
                title = "%s[%d] of %s" % (name, i, changes[0] if changes else scene)
                heading = "%s\\[%d\\]" % (name, i)
                table = rows(next(part for part in text.split("\n#") if heading in part.split("\n")[0]))
                given = dict(given_keys(element))
                wrong = [key for key, value in given.items() if not says_value(table.get(key, [""] * 3)[2], value)]
                tap.equal(wrong, [], title + ": what was given")
                groups = {key.split(".")[0] for key in given if "." in key} | {"material"}
                strangers = [key for key in table if "." in key and key.split(".")[0] not in groups]
                tap.equal(strangers, [], title + ": rows of what was not given")


COVER = {"institution": "Ångström & Co", "faculty": "Physics <b>", "course": "Computer graphics",
         "teacher": "P. Petrov", "place": "Saint Petersburg", "author": "A_B $x$", "group": "4321", "date": "2026",
         "aim": "To see the light."}


def title_page(tap, tool):
    options = [part for key, text in COVER.items() for part in ("--" + key, text)]
    result = tool.run("report", *SMALL, *options, "-o", "c.pdf", "-o", "c.html", "-o", "c.md", "-o", "c.tex")
    tap.equal((result.code, result.err), (0, ""), "a report with a title page")
    pages = subprocess.run(["pdftotext", "-layout", tool.file("c.pdf"), "-"], capture_output=True, text=True,
                           check=True).stdout.split("\f")
    tap.ok(all(text in pages[0] for key, text in COVER.items() if key != "aim") and "Task" not in pages[0],
           "the first page of the PDF has all of it and nothing else", pages[0])
    tap.ok("1 Aim of the work" in pages[1] and COVER["aim"] in pages[1] and "2 Task" in pages[1], "the aim", pages[1])
    html = tool.read("c.html").decode()
    tap.ok('<header class="cover">' in html and "Physics &lt;b&gt;" in html and "Ångström &amp; Co" in html, "HTML")
    tap.ok("\\begin{titlepage}" in tool.read("c.tex").decode(), "LaTeX")
    plain = tool.read("c.md").decode()
    tap.ok(all(word in plain for word in ("P. Petrov", "Computer graphics", "Saint Petersburg, 2026")),
           "Markdown", plain)
    for text in (html, plain, tool.read("c.tex").decode()):
        tap.ok("Fig. 1." in text and "Fig. 2." in text and re.search("6 Results", text) and "6.1 Points" in text,
               "numbers of sections and figures")
    few = tool.run("report", *SMALL, "--author", "A. B.", "--group", "7", "-o", "c.html")
    html = tool.read("c.html").decode()
    tap.ok(few.code == 0 and "cover\">" not in html and html.count('class="byline"') == 2, "without them none")


def lamps(tap, tool):
    """Each file of luminaires that shine has a row, with the numbers of `luxel photometry`."""
    head = "IESNA:LM-63-1995\n[MANUFAC] own\n[TEST] own\nTILT=NONE\n"
    tool.write("panel.ies", head + "1 -1 1 3 3 1 2 .3 1.2 0\n1 1 10\n0 45 90\n0 45 90\n"
               "900 600 40\n900 500 30\n900 400 9\n")
    tool.write("spot.ies", head + "1 -1 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n1000 500 0\n")
    lamp = "{type: luminaire, file: %s, position: [%d, 0, 2000], attenuation: none%s}"
    lights = [lamp % ("panel.ies", 0, ", factor: 0.5"), lamp % ("spot.ies", 100, ""), lamp % ("panel.ies", 200, ""),
              lamp % ("spot.ies", 300, ", enabled: false")]
    table = rows(report(tool, *SMALL, "-s", "lights=[%s]" % ", ".join(lights)).split(" Luminaires\n")[1])
    for name, count in (("panel.ies", 2), ("spot.ies", 1)):
        about = tool.run("photometry", name, "--json").json()
        room = next((room for room in about["ugr"]["rooms"] if (room["across"], room["along"]) == (4, 8)),
                    None) if about["ugr"] else None
        ratings = ["%.1f" % room[way][0] if room else "–" for way in ("crosswise", "endwise")]
        tap.equal((table[name][0], table[name][3:]), (str(count), ratings), name + ": how many, and their glare")
        tap.ok(near(table[name][1], about["flux"]["zone"], 1e-4) and
               near(table[name][2], about["max"]["intensity"], 1e-4), name + ": flux and intensity", table)
    tap.ok(" Luminaires\n" not in report(tool, *SMALL), "without luminaires there is no such table")


def scene_on_one_page(tap, tool):
    """The scene's text is not torn where it fits a page, wherever the page begins."""
    for count in (1, 4, 8, 11, 14, 20, 26, 33, 40):
        tool.write("s.yaml", tool.run("scene", "report").out.replace(
            "  - {type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}",
            "\n".join("  - {type: point, position: [%d, 0, 2000], intensity: 1, attenuation: none}" % (100 * i)
                      for i in range(count))))
        result = tool.run("report", "s.yaml", *SMALL, "-o", "s.pdf")
        tap.equal((result.code, result.err), (0, ""), "%d lights" % count)
        pages = subprocess.run(["pdftotext", "-layout", tool.file("s.pdf"), "-"], capture_output=True, text=True,
                               check=True).stdout.split("\f")
        having = [i for i, page in enumerate(pages) if "luxel: 1" in page or "- {type: point" in page or
                  "rounding: truncate}" in page]
        tap.equal(len(having), 1, "%d lights: one page has the scene" % count)
        tap.ok("Reproducing" in pages[having[0]], "%d lights: with its heading" % count)


run_tests(Tap(), the_exercise, kinds_of_light, other_scenes, placed_observers, quantities, repetition, parameters,
          every_row, title_page, lamps, scene_on_one_page)
