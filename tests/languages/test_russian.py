# SPDX-License-Identifier: MIT
"""The tool in Russian: no English is left over, and nothing else changes: codes, numbers, JSON, marks, tables."""
import os
import re
import shutil
import subprocess
import tempfile

from luminaires import AXIAL, HEAD, ODD, WRONG
from tap import Tap
from tool import SCENE, new_tool

ENGLISH = {"LC_ALL": "C.UTF-8", "LANGUAGE": ""}
CYRILLIC = re.compile("[а-яёА-ЯЁ]")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
WORD = re.compile(r"[A-Za-z][A-Za-z_-]*[A-Za-z]")
# Names of things, in every language.
NAMES = set("""luxel YAML JSON Schema UTF png pfm npy exr csv dxf PNG NPY PFM EXR CSV OpenEXR libpng zlib stdin NX NY NZ
    yaml-language-server luxel.schema json yaml NULL x_mm y_mm value_ single double NUMPY Pf quantity
    brightnesz kd ks ka my render probe grid check scene set schema help report sphere three-lights two-spheres desk
    OFF OBJ PLY STL glTF
    FILE U0 Ud window grey viridis cividis inferno magma plasma coolwarm turbo HTML PDF SVG LaTeX markdown latex
    html text figure explain derive report stats profile isophotes compare variant grade advise photometry
    glare UGR VX VY VZ
    LOW HIGH TAP cairo pango luxel-draw
    sweep study docs SWEEP shard manifest SHA
    options lp float NaN nx ny nz kc kl kq luminance lux IES EULUMDAT LM over_pi inverse-square
    center maximum rfc4180
    fit daylight exchange lighting red green blue EN Em UTC CIE rest-room meeting-room evening-class lecture-hall
    escape-route open-area
    svg pdf txt md tex yml excel-ru student off right convention wrong value answers file line answer verdict
    too_few_digits error explanations submissions key fill rim k_d sky moon bulb spotlight round lamp lantern globe
    disk-lamp box-lamp ball-lamp tube lampshade tin sundial integrating-sphere room office pot all-sources min_reached
    polar cartesian cone LORL DFF TILT NONE INCLUDE IESNA MORE TEST TESTLAB ISSUEDATE MANUFAC Lampe AG LED
    LDT ies ldt lamp TM BUG
    warm-and-cold warm cold sRGB rgb channels color grey Duv xy cct
    arrange average minimum ratio array
    repeated first_line missing_points submissions asked answered tsv relative accepted pixel""".split())

COMMANDS = [
    [], ["help"], ["--help"], ["--version"], *[["help", name] for name in (
        "render", "probe", "grid", "check", "scene", "schema", "set", "help", "figure", "explain", "report", "stats",
        "profile", "isophotes", "compare", "variant", "grade", "advise", "photometry", "sweep", "arrange")],
    ["stats"], ["stats", "--histogram"], ["profile"], ["profile", "three-lights"], ["isophotes"],
    ["compare", "report", "report"], ["compare", "report", "three-lights"], ["compare", "report"],
    ["explain", "-p", "0,0"], ["explain", "all-sources", "-p", "0,0"], ["explain", "-p", "900,0"],
    ["explain", "spot", "-p", "0,0"], ["derive", "-p", "0,0", "--free", "lights[0].position"],
    ["arrange", "desk", "--goal", "average>=1"], ["arrange", "desk", "--goal", "U0>0.6"], ["arrange", "desk"],
    ["advise"], ["advise", "spot"], ["grade", "none.csv"], ["variant"],
    ["profile", "--from", "0,0"], ["stats", "--region", "0,0,0"], ["isophotes", "--levels", "0"],
    ["grid"], ["grid", "desk"], ["grid", "desk", "-o", "a.png"], ["grid", "desk", "--quantity", "brightness"],
    ["grid", "desk", "-s", "grids[0].n=[40,30]"], ["grid", "desk", "-s", "grids[0].n=[9000,9000]"],
    ["probe", "window", "-p", "-120,90"], ["check", "-s", "lights=[{type: planar, radiance: 1}]"],
    ["check", "-s", "lights=[{type: planar, vertices: [[0,0,0],[1,1,0],[1,0,0],[0,1,0]], radiance: 1}]"],
    ["check", "-s", "lights=[{type: volume, mesh: none.off, radiance: 1}]"],
    ["render"], ["render", "spot"], ["render", "three-lights"], ["render", "-s", "lights=[]"], ["render", "-q"],
    ["render", "-s", "screen.resolution=[36,36]", "-s", "points=[[0,0],[400,0],[100,50]]"],
    ["render", "-s", "surfaces[0].center=[9000,0,1000]"], ["render", "-s", "units=photometric"],
    ["render", "-s", "lights[0].attenuation=inverse-square"], ["render", "--quantity", "irradiance"],
    ["probe"], ["probe", "-p", "0,0", "-p", "400,0"], ["probe", "three-lights", "-p", "10,10"],
    ["probe", "--at", "0,0,1300,0,0,1"], ["probe", "--at", "2000,0,2000,0,0,1"], ["probe", "-s", "points=[]"],
    ["probe", "-s", "surfaces[0].material.over_pi=true", "-s", "lights[0].attenuation=inverse-square"],
    ["probe", "--tolerance", "1e-17"],
    ["check"], ["check", "three-lights"], ["check", "--strict"], ["check", "-s", "surfaces[0].material.model=lambert"],
    ["check", "-s", "lights[0].position=[0,0,1000]"], ["scene", "--list"], ["schema"],
    ["rendr"], ["render", "-x"], ["render", "--outptu=1"], ["render", "-o"], ["render", "--json=1"],
    ["render", "--t", "1"], ["render", "a", "b"], ["--strict"], ["render", "-p", "0,0"], ["check", "-o", "a.png"],
    ["probe", "-p", "1"], ["probe", "-p", "1,a"], ["probe", "-p", "1,1e999"], ["probe", "-p", "1,"],
    ["probe", "--at", "0,0,0,0,0,0"], ["probe", "--tolerance", "2"], ["probe", "--tolerance", "x"],
    ["render", "--threads", "0"], ["render", "--precision", "dubble"], ["render", "--light-error", "1"],
    ["render", "missing.yaml"], ["render", "raport"], ["scene", "nothing"], ["help", "shinyness"], ["help", "qqq"],
    ["scene", "--list", "report"],
    ["render", "-o", "a.gif"], ["render", "-o", "a"], ["render", "-o", "missing/a.png"], ["render", "-o", "."],
    ["render", "-o", "a.png", "-o", "./a.png"], ["render", "folder"], ["render", "folder/x.yaml"],
    ["render", "-s", "screen"], ["render", "-s", "screen="], ["render", "-s", "screen.foo=1"],
    ["render", "-s", "lights.intensity=1"], ["render", "-s", "lights[3].intensity=1"], ["render", "-s", "screen[0]=1"],
    ["render", "-s", "screen.width.x=1"], ["render", "-s", "[]=1"], ["render", "-s", "luxel=2"],
    ["render", "-s", "screen.width=[1]"], ["render", "-s", "screen.width=1,5"], ["render", "-s", "screen.width='5'"],
    ["render", "-s", "screen.width=5mm"], ["render", "-s", "screen.width=nan"], ["render", "-s", "screen.width=0x10"],
    ["render", "-s", "screen.width=600"], ["render", "-s", "screen.resolution=[3.5,3]"],
    ["render", "-s", "screen.resolution=[70000,70000]"], ["render", "-s", "screen.resolution=[1,2,3]"],
    ["render", "-s", "screen.resolution=7"], ["render", "-s", "screen.sampling=node"], ["render", "-s", "screen=5"],
    ["render", "-s", "lights=5"], ["render", "-s", "lights=[{}]"], ["render", "-s", "lights=[{type: lamp}]"],
    ["render", "-s", "lights=[5]"], ["render", "-s", "lights=[{type: point}]"], ["render", "-s", "surfaces=[]"],
    ["render", "-s", "lights=[{type: spot, position: [0,0,3000], intensity: 1, inner: 50, outer: 20}]"],
    ["render", "-s", "lights=[{type: spot, position: [0,0,3000], intensity: 1, inner: 5, outer: 99}]"],
    ["render", "-s", "lights=[{type: point, position: [0,0,3000], intensity: 1, axis: [0,0,0], aim: [0,0,0]}]"],
    ["render", "-s", "lights=[{type: point, position: [0,0,3000], intensity: 1, aim: [0,0,3000]}]"],
    ["render", "-s", "lights=[{type: point, position: [0,0,3000], intensity: 1, attenuation: practical}]"],
    ["render", "-s", "lights=[{type: point, position: [0,0,3000], intensity: 1, falloff: hard}]"],
    ["render", "-s", "observer.z=10"], ["render", "-s", "points=5"], ["render", "-s", "points=[[1]]"],
    ["render", "-s", "picture.range=[5,1]"], ["render", "-s", "picture.range=maxi"],
    ["render", "-s", "surfaces[0].material.over_pi=yes"], ["render", "-s", "surfaces[0].material.over_pi='true'"],
    ["render", "-s", "lights[0].name=5"], ["render", "-s", "lights[0].intensity=1e308"],
    ["set"], ["set", "scene.yaml"], ["set", "report", "lights[0].foo=1"],
]
# Scenes with errors of the text, for standard input.
TEXTS = ["", "5", "a: b: c", "{a: [1, 2}", "[1, 2", "luxel: 1\nluxel: 1", "luxel: 1\n---\nluxel: 1", "a: &b 1",
         "%FOO\n---\n", "a: \"\\q\"", "? [1]\n: 2", "\x07", "a:\n\t- 1", "a: 'b", "luxel: 1\nlight: []", "a: @b",
         "- [a, b]]", "a: |x\n b",
         "luxel: 1\n" + "".join("k%d: 1\n" % i for i in range(25)), SCENE.replace("500", "800", 1), "[" * 40]
FIELDS = ["render", "probe", "check", "help", "help spot", "help intensity", "scene --list", "scene", "schema"]


def languages():
    """(name, environment) of the ways to be Russian that this machine has, and locales made for this test."""
    folder = tempfile.mkdtemp()
    made = []
    for name in "UTF-8", "KOI8-R":
        if shutil.which("localedef"):
            result = subprocess.run(["localedef", "-i", "ru_RU", "-f", name, os.path.join(folder, "ru_RU." + name)],
                                    capture_output=True, check=False)
            if result.returncode == 0:
                made.append(name)
    return folder, made


def known_words(tool):
    """Keys, types and choices of scenes, which have one name in every language."""
    keys = tool.run("help", "--json", environment=ENGLISH).json()
    texts = [text for key in keys["keys"] for text in (key["path"], key["of_type"], key["choices"], key["default"])]
    texts += [text for kind in keys["kinds"] for text in (kind["name"], kind["list"], kind["example"])]
    words = {word for text in texts if text for word in re.split(r"[^A-Za-z_-]+", text)}
    return words | {part for word in words for part in re.split("[_-]", word)}


def left_over(result, known):
    """English words in what was said, but for known ones, those of the command line and quoted scenes."""
    said = []
    for line in (result.out + result.err).splitlines():
        if not re.match(r"  luxel |    \S|    +\^", line) and not line.startswith("    "):
            said.append(line)
        elif re.match(r" {20,}", line):
            said.append(line)  # the help's second column
    text = " ".join(said)
    typed = {word for argument in result.arguments for word in WORD.findall(argument)}
    text = re.sub(r"(?<!\S)--?[a-z][a-z-]*|\blights?\[\S*|«[^»]*»|\\x\w\w", " ", text)
    return [word for word in WORD.findall(text) if word not in known | NAMES | typed]


def marks(text):
    """The excerpts of scenes and the marks under them."""
    return [line for line in text.splitlines() if line.startswith("    ") and not line.startswith(" " * 20)]


def compare(tap, tool, russian, known, arguments, stdin=""):
    name = " ".join(arguments) or "luxel alone"
    if stdin:
        name += " < %r" % stdin[:20]
    english = tool.run(*arguments, stdin=stdin, environment=ENGLISH)
    result = tool.run(*arguments, stdin=stdin, environment=russian)
    both = "%s\n%s" % (english, result)
    tap.equal(result.code, english.code, name + ": the exit code")
    said = english.out + english.err
    if "schema" != name and said.strip():
        tap.ok(CYRILLIC.search(result.out + result.err), name + ": it speaks Russian", both)
    tap.equal(sorted(NUMBER.findall(result.out + result.err)), sorted(NUMBER.findall(said)), name + ": the numbers")
    if english.code:
        tap.equal(marks(result.err), marks(english.err), name + ": excerpts and marks")
    if name != "schema":
        tap.equal(left_over(result, known), [], name + ": no English is left over")
    tap.ok("?" * 3 not in result.out + result.err, name + ": every character can be shown")


def texts(tap, tool, russian):
    os.mkdir(tool.file("folder"))
    tool.write("scene.yaml", SCENE)
    known = known_words(tool)
    for arguments in COMMANDS:
        compare(tap, tool, russian, known, arguments)
    for text in TEXTS:
        compare(tap, tool, russian, known, ["check", "-"], text)
    keys = tool.run("help", "--json", environment=ENGLISH).json()
    for topic in sorted({key["path"] for key in keys["keys"]} | {kind["name"] for kind in keys["kinds"]}):
        compare(tap, tool, russian, known, ["help", topic])


def luminaires(tap, tool, russian):
    """Luminaire files, odd and wrong ones."""
    known = known_words(tool)
    for arguments in [], ["a.ies", "--diagram", "cone"], ["a.ies", "-o", "a.gif"]:
        compare(tap, tool, russian, known, ["photometry"] + arguments)
    for title, text, *_ in ODD + WRONG:
        compare(tap, tool, russian, known | set(re.findall("[a-z]+", text)), ["photometry", "-"], text)
    compare(tap, tool, russian, known, ["photometry", "-"], HEAD + AXIAL)
    compare(tap, tool, russian, known, ["photometry", "-"],
            HEAD + "1 -1 1 3 3 2 2 0 0 0\n1 1 10\n-90 0 90\n-90 0 90\n0 0 0 0 9 0 0 0 0\n")


def pictures(tap, tool, russian):
    """Pictures as scenes, whole and damaged."""
    tool.run("render", "-s", "screen.resolution=[36,36]", "-o", "a.png", "-o", "a.exr", "-o", "a.npy", "-o", "a.pfm")
    known = known_words(tool)
    damaged = bytearray(tool.read("a.png"))
    damaged[200] ^= 1
    tool.write("damaged.png", bytes(damaged))
    for ending in "png", "exr":
        tool.write("cut." + ending, tool.read("a." + ending)[:300])
    tool.write("quantity.exr", tool.read("a.exr").replace(b"brightness", b"brightnesz"))
    for name in "a.png", "a.exr", "a.npy", "a.pfm", "damaged.png", "cut.png", "cut.exr", "quantity.exr":
        compare(tap, tool, russian, known | {"brightness"}, ["check", name])
    compare(tap, tool, russian, known, ["set", "a.png", "lights[0].intensity=2"])
    compare(tap, tool, russian, known, ["set", "report", "lights[0].intensity=2", "-o", "b.png"])


def json_stays(tap, tool, russian):
    """What programs read is the same in every language."""
    for command in FIELDS:
        arguments = command.split() + (["--json"] if command != "schema" else [])
        english, result = (tool.run(*arguments, environment=language) for language in (ENGLISH, russian))
        tap.ok(result.out == english.out and result.err == english.err and result.out, command + ": JSON", result)
    arguments = ["check", "-s", "screen.width=-1", "-s", "lights[0].foo=1", "--json"]
    tap.equal(tool.run(*arguments, environment=russian).out, tool.run(*arguments, environment=ENGLISH).out,
              "check: JSON of errors")
    arguments = ["probe", "--at", "2000,0,2000,0,0,1", "--json"]
    tap.equal(tool.run(*arguments, environment=russian).out, tool.run(*arguments, environment=ENGLISH).out,
              "probe: JSON of a point without a value")
    tap.equal(tool.run("scene", environment=russian).out, tool.run("scene", environment=ENGLISH).out, "a scene's text")
    for name in "a.png", "a.npy", "a.csv", "a.exr":
        written = []
        for language in ENGLISH, russian:
            tool.run("render", "-o", name, environment=language)
            written.append(tool.read(name))
        tap.ok(written[0] == written[1], name + " is the same file")


def tables(tap, tool, russian):
    """Columns end, or begin, where their headings do, in characters."""
    lines = tool.run("render", "-s", "screen.resolution=[36,36]", environment=russian).out.splitlines()
    statistics, points = lines[2:5], [line for line in lines if re.match(r"  (точка|P\d)", line)]
    tap.equal(len({len(line) for line in statistics}), 1, "the table of numbers has an even edge")
    tap.equal(len({len(line) for line in points}), 1, "the table of points has an even edge")
    lines = tool.run("probe", "three-lights", "-p", "0,0", environment=russian).out.splitlines()
    shares = [line for line in lines if re.match(r"    (источник|lights)", line)]
    tap.equal(len({len(line) for line in shares}), 1, "the table of lights has an even edge")
    for line in tool.run("help", "render", environment=russian).out.splitlines():
        tap.ok(len(line) <= 80 or line.startswith("  luxel"), "80 columns hold: " + line[:30])


def readme(tap, tool, russian):
    """The table in README.ru.md is what the tool prints."""
    path = os.path.join(os.path.dirname(__file__), "..", "..", "README.ru.md")
    with open(path, encoding="utf-8") as file:
        table = re.search(r"\n((?:    report:.*\n)(?:(?:    .*)?\n)+)", file.read()).group(1)
    lines = [line[4:] for line in table.rstrip().split("\n")]
    said = tool.run("render", environment=russian).out.split("\n")
    tap.equal(lines, said[:len(lines)], "the table of README.ru.md")


def choice(tap, tool, folder, made):
    """Which language it is."""
    def speaks(**environment):
        return bool(CYRILLIC.search(tool.run(environment={"LC_ALL": "", "LANG": "", "LC_MESSAGES": "", "LANGUAGE": "",
                                                          **environment}).out))

    tap.equal(speaks(), False, "no locale: English")
    tap.equal(speaks(LC_ALL="C", LANGUAGE="ru"), False, "the locale C: English")
    tap.equal(speaks(LANG="de_DE.UTF-8"), False, "a language without a catalogue: English")
    tap.equal(speaks(LANG="ru_RU.KOI8-R"), False, "another encoding: English")
    if "UTF-8" not in made:
        tap.skip("a locale made for the test", "localedef and its sources are not installed")
        return
    own = {"LOCPATH": folder}
    tap.equal(speaks(LANG="ru_RU.UTF-8", **own), True, "LANG")
    tap.equal(speaks(LC_MESSAGES="ru_RU.UTF-8", **own), True, "LC_MESSAGES")
    tap.equal(speaks(LC_ALL="ru_RU.UTF-8", LANG="C", **own), True, "LC_ALL goes before LANG")
    tap.equal(speaks(LC_ALL="ru_RU.UTF-8", LANGUAGE="en:ru", **own), True, "LANGUAGE: en has no catalogue, ru has")
    tap.equal(speaks(LC_NUMERIC="ru_RU.UTF-8", **own), False, "LC_NUMERIC has no say")
    tap.equal(speaks(LC_ALL="ru_RU.KOI8-R", **own), False, "another encoding that is there: English")


def main():
    tap = Tap()
    folder, made = languages()
    # Generated or not: where it is not, C.UTF-8 stands in, which every Debian has.
    ways = {"ru_RU.UTF-8 as it is here": {"LC_ALL": "ru_RU.UTF-8", "LANGUAGE": ""}}
    if "UTF-8" in made:
        ways["a generated ru_RU.UTF-8"] = {"LC_ALL": "ru_RU.UTF-8", "LANGUAGE": "", "LOCPATH": folder}
    try:
        with new_tool() as tool:
            tap.run(choice, tap, tool, folder, made)
            ways = {name: way for name, way in ways.items() if CYRILLIC.search(tool.run(environment=way).out)}
        if "UTF-8" in made:
            tap.ok("a generated ru_RU.UTF-8" in ways, "a generated locale is Russian")
        if not ways:
            tap.skip("Russian texts", "this machine has no locale for them")
        for name, way in list(ways.items())[:1]:
            tap.note("With " + name)
            for test in texts, luminaires, pictures, json_stays, tables, readme:
                with new_tool() as tool:
                    tap.run(test, tap, tool, way)
    finally:
        shutil.rmtree(folder)
    tap.finish()


main()
