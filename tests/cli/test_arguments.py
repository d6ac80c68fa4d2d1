# SPDX-License-Identifier: MIT
"""Arguments: the wrong ones end with exit code 2 and say what was expected, the right ones are understood."""
import os
import re

from tap import Tap
from tool import AT_ONCE, SCENE, run_tests

# (arguments, words that the message must have)
WRONG = [
    ("rendr", "rendr render"),
    ("render report more", "more"),
    ("--json", "command"),
    ("render --jsno", "--jsno --json"),
    ("render --outptu x.png", "--outptu --output"),
    ("render -x", "-x"),
    ("render -j", "-j"),
    ("render -qx", "-x"),
    ("render --p", "--p"),
    ("render -o", "-o FILE"),
    ("render -s", "-s KEY=VALUE"),
    ("render --threads", "--threads N"),
    ("render --json=yes", "--json"),
    ("render -p 0,0", "point probe"),
    ("render --at 0,0,0,0,0,1", "at probe"),
    ("check -o x.png", "output render"),
    ("probe -o x.png", "x.png .csv .npy .json"),
    ("probe -p 0,0 --view 0,0,1", "--view elements --at"),
    ("probe --at 0,0,0,0,0,1 --view 0,0,0", "--view zero"),
    ("probe --at 0,0,0,0,0,1 --material 1", "surfaces[1] surfaces[0]"),
    ("check --list", "list scene"),
    ("render -o x", "x"),
    ("render -o x.jpg", "x.jpg .png"),
    ("render -o x.png.", "x.png."),
    ("render -o .png.txt", ".png.txt"),
    ("render -o -", "-"),
    ("render -o x.png -o x.png", "x.png"),
    ("render -o x.png -o ./x.png", "./x.png"),
    ("render -o x.png -o ../%s/x.png", "x.png"),
    ("render --quantity brightnes", "brightnes brightness irradiance"),
    ("render --quantity=", "brightness"),
    ("render --precision triple", "triple single double"),
    ("render --precision Double", "Double double"),
    ("render --threads 0", "0 1024"),
    ("render --threads -1", "-1"),
    ("render --threads 1025", "1025"),
    ("render --threads 2.0", "2.0"),
    ("render --threads two", "two"),
    ("render --threads 99999999999999999999", "99999999999999999999"),
    ("render --threads 0x2", "0x2"),
    ("render --tolerance 0", "0"),
    ("render --tolerance 1", "1"),
    ("render --tolerance -1e-3", "-1e-3"),
    ("render --tolerance nan", "nan"),
    ("render --tolerance 1e-9x", "1e-9x"),
    ("render --tolerance 0,5", "0,5"),
    ("render --light-error 1", "1"),
    ("render --light-error -0.1", "-0.1"),
    ("render --light-error inf", "inf"),
    ("probe -p 0", "0 X,Y"),
    ("probe -p 0,0,0", "X,Y 3"),
    ("probe -p 0,", "missing X,Y"),
    ("probe -p ,0", "missing"),
    ("probe -p 0;0", "0;0"),
    ("probe -p 1.5.2,0", "1.5.2"),
    ("probe -p nan,0", "nan"),
    ("probe -p 0,inf", "inf"),
    ("probe -p 0,-Infinity", "-Infinity"),
    ("probe -p 0x1,0", "0x1"),
    ("probe -p 1e,0", "1e"),
    ("probe -p 1e999,0", "1e999"),
    ("probe -p 1mm,0", "1mm"),
    ("probe -p --1,0", "--1"),
    ("probe -p 0,0x", "0x"),
    ("probe -p (0,0)", "(0"),
    ("probe -p -json", "json"),
    ("probe --at 0,0,0", "X,Y,Z,NX,NY,NZ 3 6"),
    ("probe --at 0,0,0,0,0,0", "normal zero"),
    ("probe --at 0,0,0,0,0,nan", "nan"),
    ("probe --at 0,0,0,0,0,1,2", "7"),
    ("probe -p 149,7214,-0,6964", "4 fraction point X,Y"),
    ("probe -p 149,7,0", "3 fraction point"),
    ("probe -p 1,5e2,0", "3 fraction point"),
    ("probe -p 149,72;-0,69", "fraction point"),
    ("probe -p 149,72;0", "fraction point"),
    ("probe --at 149,7,0,5,0,0,0,1", "8 6 fraction point X,Y,Z,NX,NY,NZ"),
    ("probe --at 0,0,0,0,0,1 --view 0,5,0,1", "4 3 fraction point"),
    ("profile --from 0,5,1 --to 3,4", "--from 3 fraction point"),
    ("stats --region 0,5,0,10,10", "5 4 fraction point"),
    ("isophotes --levels 0,5;1,5", "fraction point"),
    ("probe -p 1,2,3,4,x", "x form X,Y"),
    ("render -s intensity", "="),
    ("render -s =5", "="),
    ("render -s lights[0].intensty=5", "intensty intensity"),
    ("render -s lights[1].intensity=5", "lights[1]"),
    ("render -s lights[-1].intensity=5", "lights"),
    ("render -s lights[x].intensity=5", "lights"),
    ("render -s lights[0.intensity=5", "lights"),
    ("render -s lights[0]intensity=5", "lights"),
    ("render -s lights..intensity=5", "lights"),
    ("render -s .screen.width=5", "screen"),
    ("render -s screen.=5", "screen"),
    ("render -s screen.width.x=5", "width"),
    ("render -s screen.widht=5", "widht width"),
    ("render -s scren.width=5", "scren screen"),
    ("render -s surfaces[0].material.shinyness=5", "shinyness shininess"),
    ("render -s surfaces[9].radius=5", "surfaces"),
    ("render -s screen.resolution[5]=5", "resolution"),
    ("scene --list report", "--list"),
    ("help nosuchthing", "nosuchthing"),
    ("help shinines", "shinines shininess"),
    ("help rendr", "rendr render"),
]

# A known key with an illegal value: as in a file.
ILLEGAL = [
    "screen.width=0", "screen.width=-5", "screen.width=wide", "screen.width=", "screen.width=[1", "screen.width={",
    "screen.width=1e999", "screen.width=.nan", "screen.resolution=[0,0]", "screen.resolution=[36]",
    "screen.resolution=[36,30]", "lights[0].intensity=-1", "lights[0].type=sun", "lights=5", "surfaces=[5]",
    "observer.z=0", "surfaces[0].radius=0", "surfaces[0].material.shininess=0", "luxel=2", "points=[[0]]",
    "lights[0].intensity=10,5", "lights[0].position=[2000,5,0,2000]", "observer.z=1500,0", "points=[[149,7,0,7]]",
    "picture.range=[1]", "lights[0].position=[1,2]", "units=5", "lights=[{type: point}]",
]


def wrong(tap, tool):
    for text, words in WRONG:
        arguments = [part.replace("%s", os.path.basename(tool.folder)) for part in text.split(" ")]
        result = tool.run(*arguments)
        missing = [word for word in words.split() if word not in result.err]
        good = (result.code == 2 and not result.out and not missing and tool.files() == [] and
                "error:" in result.err and result.seconds < AT_ONCE)
        tap.ok(good, "luxel " + text, "missing: %s" % missing, result)


def illegal_values(tap, tool):
    for assignment in ILLEGAL:
        result = tool.run("render", "-s", assignment, "-o", "x.png")
        key = re.split(r"[=]", assignment)[0]
        good = (result.code == 3 and not result.out and tool.files() == [] and "error:" in result.err and
                result.seconds < AT_ONCE)
        tap.ok(good and key.split(".")[-1].split("[")[0] in result.err, "-s " + assignment, result)


def decimal_commas(tap, tool):
    """A fraction behind a comma is told from a number too many, in the values of -s as in a scene."""
    for assignment in ("lights[0].intensity=10,5", "lights[0].position=[2000,5,0,2000]", "observer.z=1500,5",
                       "points=[[149,7,0,7]]", "surfaces[0].material={diffuse: 0,8, specular: 0.5}",
                       "lights[0]={type: point, position: [2000, 0, 2000], intensity: 10,5}"):
        result = tool.run("probe", "-s", assignment)
        tap.ok(result.code == 3 and "hint: write the fraction with a point" in result.err, "-s " + assignment, result)
    for assignment in "lights[0].position=[2000, 5, 0, 2000]", "lights[0].position=[1,2]", "points=[[1, 2, 3]]":
        result = tool.run("probe", "-s", assignment)
        tap.ok(result.code == 3 and "fraction" not in result.err, "no decimal comma: -s " + assignment, result)


def digits(tap, tool):
    """--digits rounds what is printed for people, and a bound is that of the number as it stands there."""
    for count in 1, 4, 7, 17:
        result = tool.run("probe", "-p", "0,0", "--digits", str(count))
        shown, bound = re.search(r"P1 \(0\.0, 0\.0\): (\S+) ± (\S+) W/sr", result.out).groups()
        tap.equal(shown, "%.*g" % (count, 2.7275906525546927), "%d digits" % count)
        off = abs(float(shown) - 2.7275906525546927)
        tap.ok(off <= float(bound) <= 1.11 * off + 2e-14, "and their bound", off, bound)
    small = ["-s", "screen.resolution=[9,9]"]
    for command in ["render"], ["stats"], ["grid", "desk"], ["compare", "report", "report", *small]:
        result = tool.run(*command, "--digits", "3")
        tap.ok(result.code in (0, 1) and not result.err, command[0] + " takes it", result)
    plain, few = (tool.run("probe", "--json", *more).out for more in ([], ["--digits", "3"]))
    tap.equal(plain, few, "JSON keeps all digits")
    for wrong in "0", "18", "2.5", "x":
        tap.equal(tool.run("probe", "--digits", wrong).code, 2, "--digits " + wrong)


def paths(tap, tool):
    """Backslashes of a path in double quotes are escapes; where none is lost the folders' sign is what is wrong."""
    quotes, slash = "put a path in single quotes", "hint: write / between folders"
    for value, hint in (('"C:\\lab\\lamps.csv"', quotes), ('"tables\\new.csv"', quotes), ('"C:\\\\lab.csv"', slash),
                        ("'C:\\lab.csv'", slash), ("C:\\lab.csv", slash), ("lab/lamps.csv", None)):
        result = tool.run("probe", "-s", "lights[0]={type: points, file: %s}" % value)
        tap.ok(result.code in (3, 4) and (hint or "error:") in result.err, "file: " + value, result)
        tap.equal((quotes in result.err, slash in result.err), (hint == quotes, hint == slash), "no other: " + value)


def hostile_texts(tap, tool):
    long = "x" * 100000
    for arguments in (("render", long), ("render", "-s", long), ("render", "-s", long + "=1"), ("probe", "-p", long),
                      (long,), ("--" + long,), ("help", long), ("scene", long), ("render", "-o", long + ".png"),
                      ("render", "-s", "screen.width=" + long), ("render", "-s", "a" + "[0]" * 30000 + "=1"),
                      ("render", "-s", "lights=" + "[" * 50000)):
        result = tool.run(*arguments)
        tap.ok(result.code in (2, 3, 4) and result.seconds < AT_ONCE, "a long argument: " + " ".join(arguments)[:30],
               str(result)[:500])
    for text in "\x1b[31m", "\x01", "\n", "\x7f":
        for arguments in (("render", text), (text,), ("render", "-s", text + "=1"), ("probe", "-p", text),
                          ("render", "--quantity", text), ("render", "-o", text + ".txt"), ("help", text)):
            result = tool.run(*arguments)
            tap.ok(result.code in (2, 4) and not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", result.err),
                   "a control character is escaped: %r" % (arguments,), repr(result.err))


def right(tap, tool):
    base = tool.run("render", "--json").out
    for options in (["--quantity", "brightness"], ["--quantity=brightness"], ["--precision", "single"], ["--quiet"],
                    ["-q"], ["--threads", "3"], ["--threads=1024"], ["--light-error", "0"], ["--tolerance", "0.5"],
                    ["--tolerance", "1e-9"], ["--tolerance", "+.5"]):
        tap.equal(tool.run("render", "--json", *options).out, base, "render " + " ".join(options))
    tap.equal(tool.run("--json", "render").out, base, "an option before the command")
    tap.equal(tool.run("render", "--json", "report").out, base, "an option before the scene")
    tap.equal(tool.run("render", "--js").out, base, "a shortened option")
    double = tool.run("render", "--precision", "double", "--json").json()
    tap.near(double["max"]["value"], 11.7475, 1e-5, "--precision double")
    irradiance = tool.run("probe", "--quantity", "irradiance", "--json").json()
    tap.equal(irradiance["quantity"], "irradiance", "--quantity irradiance")
    point = irradiance["points"][0]
    tap.near(point["value"], point["lights"][0]["irradiance"], 1e-12, "its value")
    expected = tool.run("probe", "--json", "-p", "-150,0").out
    for form in ("-p-150,0", "--point=-150,0", "-p-1.5e2,0.0", "-p-150.,0e5", "-p-150,-0"):
        values = [answer["points"][0]["value"] for answer in
                  (tool.run("probe", "--json", form).json(), tool.run("probe", "--json", "-p", "-150,0").json())]
        tap.equal(values[0], values[1], form)
    tap.ok("-150" in expected, "a negative number is a value")
    negative = tool.run("probe", "--at", "-1,-2,-3,-1,0,0", "--json").json()["points"][0]
    tap.equal((negative["position"], negative["normal"]), ([-1, -2, -3], [-1, 0, 0]), "--at with negative numbers")


def version_and_usage(tap, tool):
    alone = tool.run()
    tap.ok(alone.code == 0 and not alone.err and "luxel render" in alone.out, "luxel alone", alone)
    tap.equal(tool.run("--help").out, alone.out, "luxel --help")
    tap.equal(tool.run("help").out, alone.out, "luxel help")
    version = tool.run("--version")
    tap.ok(version.code == 0 and re.match(r"luxel 0\.1\.0\ninstruction set: [\w-]+\n$", version.out), "--version",
           version)
    for words in ("--version", "--json"), ("version", "--json"), ("render", "--version", "--json"):
        data = tool.run(*words).json()
        tap.equal((list(data), data["version"], data["instruction_set"] in version.out),
                  (["version", "instruction_set"], "0.1.0", True), " ".join(words))
    for command in "render", "probe", "grid", "check", "scene", "help":
        for word in (command, "--help"), ("help", command), (command, "-h"):
            result = tool.run(*word)
            tap.ok(result.code == 0 and result.out.startswith("Usage: luxel " + command), " ".join(word), result)
        tap.equal(tool.run(command, "--version").out, version.out, command + " --version")
        computes, reads = command in ("render", "probe", "grid"), command != "help"
        for option, value, is_taken in (("--set", "units=radiometric", reads), ("--quantity", "irradiance", computes),
                                        ("--json", None, True), ("--strict", None, reads),
                                        ("--tolerance", "1e-3", computes), ("--threads", "1", computes),
                                        ("--precision", "double", computes), ("--light-error", "0", computes)):
            tap.equal(bool(re.search(r"%s\b" % option, tool.run(command, "--help").out.split("Examples:")[0].split(
                "Common options")[1])), is_taken, "%s --help tells %s: %s" % (command, option, is_taken))
            refused = tool.run(command, *[word for word in (option, value) if word])
            said = refused.err.startswith("luxel: error: luxel %s takes no %s\n" % (command, option))
            tap.ok(said != is_taken, "%s takes it: %s" % (option, is_taken), refused)
            if not is_taken:
                listed = "hint: luxel %s takes " % command in refused.err and "--help" in refused.err
                tap.ok(refused.code == 2 and listed, "and those that it takes are listed", refused)
    once = tool.run("help", "options")
    tap.ok(once.code == 0 and all(once.out.count("--%s " % option) == 1 for option in
                                  ("set", "quantity", "tolerance", "precision", "threads", "light-error", "strict")),
           "luxel help options says each common one once", once)
    tap.ok(len(tool.run("help", "scene").out.splitlines()) < 30, "the help of a small command is short")
    tap.equal(tool.run("version").out, version.out, "luxel version")
    forced = tool.run("--version", environment={"LUXEL_ISA": "generic"})
    widest = "x86-64" if os.uname().machine == "x86_64" else "generic"
    tap.ok("instruction set: %s\n" % widest in forced.out, "LUXEL_ISA", forced)
    if "instruction set: x86-64-v3\n" in tool.run("--version", environment={"LUXEL_ISA": "x86-64-v3"}).out:
        short = tool.run("--version", environment={"LUXEL_ISA": "v3"})
        tap.ok("instruction set: x86-64-v3\n" in short.out, "a short name of a set", short)
    tap.equal(tool.run("render", environment={"LUXEL_ISA": "nonsense"}).code, 2, "an unknown LUXEL_ISA")
    tool.write("my.yaml", SCENE)
    hint = tool.run("my.yaml")
    tap.ok(hint.code == 2 and "luxel render my.yaml" in hint.err, "a scene for a command", hint)


run_tests(Tap(), wrong, illegal_values, decimal_commas, digits, paths, hostile_texts, right, version_and_usage)
