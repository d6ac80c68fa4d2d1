# SPDX-License-Identifier: MIT
"""Every malformed scene ends with exit code 3, a message that names the place, and no output."""
import os
import re
import resource

from malformed import TEXTS, scenes
from tap import Tap
from tool import AT_ONCE, SCENE, run_tests


def judge(tap, tool, title, place, words, result):
    """One case: all that holds for every malformed scene."""
    error = re.search(r"^scene\.yaml:(\d+):(\d+): error: .+", result.err, re.M)
    faults = []
    if result.code != 3:
        faults.append("exit code")
    if not error:
        faults.append("no place")
    elif place and not re.search(r"^scene\.yaml:%s: error: " % place, result.err, re.M):
        faults.append("not at " + place)
    faults += ["no word " + word for word in words if word not in result.err]
    if result.out or tool.files() != ["scene.yaml"]:
        faults.append("output")
    if result.seconds > AT_ONCE:
        faults.append("slow")
    if re.search("[\x00-\x08\x0b-\x1f\x7f-\xa0\u200b-\u200f\u2028-\u202f\u2060-\u206f\ufeff]", result.err):
        faults.append("control characters")
    if error and "\n    " not in result.err:
        faults.append("no excerpt")
    tap.ok(not faults, title, ", ".join(faults), str(result)[:3000])


def pieces(tap, tool):
    for title, text, place, words in scenes():
        tool.write("scene.yaml", text)
        judge(tap, tool, title, place, words, tool.run("render", "scene.yaml", "-o", "a.png", "-o", "a.npy"))


def whole_texts(tap, tool):
    for title, text, place in TEXTS:
        tool.write("scene.yaml", text)
        result = tool.run("render", "scene.yaml", "-o", "a.png")
        if len(text) > 64 << 20:
            tap.ok(result.code == 3 and "64" in result.err and tool.files() == ["scene.yaml"], title, result)
        else:
            judge(tap, tool, title, place, [], result)


def every_command_agrees(tap, tool):
    tool.write("scene.yaml", SCENE.replace("radius: 200", "radius: -200"))
    for command in "render", "probe", "grid", "check":
        result = tool.run(command, "scene.yaml")
        tap.ok(result.code == 3 and "scene.yaml:8:13: error:" in result.err and not result.out, command, result)
    result = tool.run("render", "-", stdin=tool.read("scene.yaml"))
    tap.ok(result.code == 3 and "<stdin>:8:13: error:" in result.err, "standard input", result)
    result = tool.run("render", "-", stdin=b"")
    tap.ok(result.code == 3 and "<stdin>:1:1: error:" in result.err, "empty standard input", result)


def encodings(tap, tool):
    """What editors and shells on Windows make of a scene."""
    tool.write("scene.yaml", SCENE)
    expected = tool.run("probe", "scene.yaml", "--json").out
    named = SCENE.replace("type: point,", "type: point, name: Лампа,")
    for name, content in (("UTF-16", SCENE.encode("utf-16")), ("UTF-16, the other order",
                                                               b"\xfe\xff" + SCENE.encode("utf-16-be")),
                          ("UTF-16 without a mark", SCENE.encode("utf-16-le")),
                          ("UTF-8 with a mark", b"\xef\xbb\xbf" + SCENE.encode())):
        tool.write("scene.yaml", content)
        tap.equal(tool.run("probe", "scene.yaml", "--json").out, expected, name)
    tool.write("scene.yaml", named.encode("utf-16"))
    tap.equal(tool.run("check", "scene.yaml").code, 0, "Russian letters in UTF-16")
    tool.write("scene.yaml", named.encode("cp1251"))
    found = tool.run("check", "scene.yaml")
    tap.ok(found.code == 3 and "scene.yaml:11:" in found.err and "save it as UTF-8" in found.err and
           "1251" in found.err, "and in the code page 1251", found)


    for name in "picture.png", "numbers.npy", "scene.yaml":
        tool.write(name, bytes(range(128, 256)) + bytes(range(64)))
        found = tool.run("check", name)
        tap.ok(found.code == 3 and name + ":1:1: error: this is not a text file" in found.err and
               "1251" not in found.err and "YAML" in found.err, "bytes called " + name, found)


def underline(tap, tool):
    tool.write("scene.yaml", SCENE.replace("radiometric", "radiometrix"))
    lines = tool.run("check", "scene.yaml").err.split("\n")
    tap.equal(lines[0].split(" error:")[0], "scene.yaml:2:8:", "the place")
    tap.equal(lines[1].strip(), "units: radiometrix", "the line")
    offset = lines[1].index("radiometrix")
    tap.equal(lines[2], " " * offset + "^" + "~" * (len("radiometrix") - 1), "the mark")
    tap.ok("radiometric" in "".join(lines[3:]) + lines[0], "the nearest word", lines)
    tool.write("scene.yaml", SCENE.replace("units: radiometric", "# ü\nunits: ünits"))
    lines = tool.run("check", "scene.yaml").err.split("\n")
    tap.equal(lines[2].index("^"), lines[1].index("ünits"), "the mark beside letters of two bytes")


def all_at_once(tap, tool):
    scene = (SCENE.replace("width: 500", "width: -1").replace("z: 1500", "z: far").replace("radius: 200", "radios: 1")
             .replace("intensity: 10", "intensity: -1"))
    tool.write("scene.yaml", scene)
    result = tool.run("render", "scene.yaml", "-o", "a.png")
    for place in "3:17", "4:15", "8:5", "11:57":
        tap.ok("scene.yaml:%s: error:" % place in result.err, "error at " + place, result)


def files_that_cannot_be_read(tap, tool):
    for name in "gone.yaml", ".", "gone/scene.yaml", "x" * 300 + ".yaml":
        result = tool.run("render", name, "-o", "a.png")
        tap.ok(result.code == 4 and name in result.err and tool.files() == [], "no file: " + name[:20], result)


def pictures_too_large(tap, tool):
    huge = ("stats", "report", "-s", "screen.resolution=[65536,65536]", "--precision", "double")
    limit = 4 << 30
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    ways = {}
    if os.environ.get("LUXEL_SANITIZED"):
        tap.skip("a picture that a limit cannot hold", "sanitizers need all addresses for themselves")
    else:
        ways["a limit"] = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))}
    if memory < 30 << 30:
        ways["the machine"] = {}
    for name, way in ways.items():
        result = tool.run(*huge, **way)
        tap.ok(result.code == 3 and re.search(r"\d+(\.\d+)? ?[GT]i?B", result.err) and tool.files() == [],
               "a picture that %s cannot hold" % name, result)


run_tests(Tap(), encodings, pieces, whole_texts, every_command_agrees, underline, all_at_once,
          files_that_cannot_be_read, pictures_too_large)
