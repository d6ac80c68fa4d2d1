# SPDX-License-Identifier: MIT
"""Names, texts and surroundings that nobody should have: nothing of a file or an argument disturbs the terminal, and
whatever is missing around the tool, it does its work or says why it cannot.
"""
import itertools
import os
import re
import resource
import subprocess

from tap import Tap
from tool import SCENE, run_tests

LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
# Colours, a bell, C1 controls, delete, and characters that turn the direction of writing.
NASTY = "a\x1b[31mred\x07\u202eevil\u2066\x9b31m\x7fz"
IN_YAML = '"a\\e[31mred\\a\\u202Eevil\\u2066\\u009B31m\\x7Fz"'
DISTURBS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]")
COMMANDS = ["render", "probe", "grid", "check", "explain", "advise", "stats", "isophotes", "profile", "scene"]
CODES = range(6)


def nasty_scene():
    named = SCENE.replace(LIGHT, LIGHT.replace("{", "{name: %s, " % IN_YAML, 1))
    named = named.replace("  - type: sphere", "  - name: %s\n    type: sphere" % IN_YAML)
    return named + "grids: [{name: %s, center: [0, 0, 1300], size: [100, 100], n: [2, 2]}]\n" % IN_YAML


def is_calm(result):
    return result.code in CODES and not DISTURBS.search(result.out + result.err)


def names_in_scenes(tap, tool):
    for name in "n.yaml", NASTY + ".yaml", "w\n.yaml":
        tool.write(name, nasty_scene())
        for command, form in itertools.product(COMMANDS, ([], ["--json"])):
            result = tool.run(command, name, *form)
            tap.ok(is_calm(result), "%s %s of %a" % (command, " ".join(form), name), result)
    told = tool.run("probe", "n.yaml", "--json").json()["points"][0]["lights"][0]["name"]
    tap.equal(told, NASTY, "JSON tells the name itself")


def names_in_drawings(tap, tool):
    if not os.path.exists(os.path.join(os.path.dirname(tool.path), "luxel-draw")):
        tap.skip("names in drawings", "built without them")
        return
    tool.write("n.yaml", nasty_scene())
    for command, name in (("figure", "a.svg"), ("report", "a.md"), ("report", "a.html"), ("report", "a.tex")):
        result = tool.run(command, "n.yaml", "-o", name)
        tap.ok(result.code == 0 and not DISTURBS.search(tool.read(name).decode("utf-8")), command + " " + name, result)


def arguments(tap, tool):
    tool.write("n.yaml", nasty_scene())
    cases = [[NASTY], ["--" + NASTY], ["--version=" + NASTY], ["help", NASTY], ["scene", NASTY], ["variant", NASTY],
             ["schema", NASTY], ["grade", NASTY], ["set", NASTY, "a=1"], ["set", "n.yaml", NASTY + "=1"],
             ["set", "n.yaml", "units=" + NASTY], ["compare", NASTY, NASTY], ["probe", "-p", NASTY],
             ["probe", "--at", NASTY], ["profile", "--through", NASTY], ["isophotes", "--levels", NASTY]]
    cases += [["render", *rest] for rest in (
        [NASTY], ["-" + NASTY], ["--" + NASTY + "=1"], ["-o", NASTY], ["-o", NASTY + "." + NASTY], ["-s", NASTY],
        ["-o", NASTY + "/a.png"], ["-s", NASTY + "=1"], ["-s", "lights[0]." + NASTY + "=1"], ["--threads", NASTY],
        ["-s", "units=" + NASTY], ["--quantity", NASTY], ["-s", "units=" + IN_YAML])]
    for case in cases:
        result = tool.run(*case)
        tap.ok(is_calm(result) and result.code in (2, 3, 4) and "error: " in result.err, "luxel %a" % case, result)
    result = tool.run("render", environment={"LUXEL_ISA": NASTY})
    tap.ok(is_calm(result) and result.code == 2, "LUXEL_ISA", result)
    tap.equal(tool.files(), ["n.yaml"], "nothing is written")


def keys_and_units(tap, tool):
    tool.write("k.yaml", "x: 1\n%s: 2\nunits: %s\n" % (IN_YAML, IN_YAML))
    result = tool.run("check", "k.yaml")
    tap.ok(is_calm(result) and result.code == 3 and "\\x1B[31mred" in result.err, "keys and values", result)
    tool.write("h.csv", "x_mm,y_mm,value_%s\n1,2,3\n2,2,4\n1,3,3\n2,3,4\n" % NASTY)
    for command in ["stats", "h.csv"], ["isophotes", "h.csv"], ["compare", "h.csv", "h.csv"]:
        for form in [], ["--json"]:
            result = tool.run(*command, *form)
            tap.ok(is_calm(result) and result.code == 0, "the unit of a table: " + " ".join(command + form), result)


def names_like_options(tap, tool):
    for name in "-x.png", "--.png", "-o.npy", "a b.png", "a\nb.png", "\xff.png":
        result = tool.run("render", "-q", "-o", name)
        tap.ok(result.code == 0 and is_calm(result) and tool.files() == [name], "-o %a" % name, result)
        os.remove(tool.file(name))
    os.symlink("target.png", tool.file("link.png"))
    tap.equal((tool.run("render", "-q", "-o", "link.png").code, os.path.islink(tool.file("link.png")), tool.files()),
              (0, True, ["link.png", "target.png"]), "a link is followed, and stays")


def few_descriptors(tap, tool):
    if os.environ.get("LUXEL_SANITIZED"):
        tap.skip("few descriptors", "sanitizers need some for themselves")
        return
    for count in range(4, 9):
        result = tool.run("render", "-q", "-o", "a.npy",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (count, count)))
        whole = os.path.exists(tool.file("a.npy"))
        tap.ok((result.code, whole) == (0, True) or ((result.code, whole) == (4, False) and "a.npy" in result.err),
               "%d descriptors" % count, result)
        if whole:
            os.remove(tool.file("a.npy"))


def small_stack(tap, tool):
    if os.environ.get("LUXEL_SANITIZED"):
        tap.skip("a small stack", "sanitizers make frames larger")
        return
    tool.write("n.yaml", nasty_scene())
    tool.write("deep.yaml", "a: " + "[" * 100000)
    for command, code in [(["deep.yaml"], 3), *[([name], 0) for name in ("n.yaml", "report")]]:
        for name in COMMANDS:
            result = tool.run(name, *command,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, (256 << 10, 256 << 10)))
            tap.ok(result.code == code or (code == 0 and result.code in CODES), "256 kB of stack: luxel %s %s" % (
                name, command[0]), result)


def surroundings(tap, tool):
    """Locales that are not there or nonsense, no home, no folder for temporary files, nothing at all."""
    plain = tool.run("render", "-o", "plain.npy").out
    cases = [{"LANG": "xx", "LC_ALL": ""}, {"LC_ALL": "C"}, {"LC_ALL": "POSIX"}, {"LC_ALL": "tr_TR.UTF-8"},
             {"LC_ALL": "ru_RU.KOI8-R", "LANGUAGE": ""}, {"LC_ALL": "x" * 5000}, {"LC_ALL": "", "LANG": ""},
             {"LANGUAGE": "nonsense:%s:../../etc"}, {"HOME": "/nonexistent"}, {"TMPDIR": "/nonexistent"},
             {"TERM": NASTY}, {"PATH": ""}]
    for environment in cases:
        result = tool.run("render", "-o", "a.npy", environment=environment)
        tap.ok(result.code == 0 and result.out == plain and tool.read("a.npy") == tool.read("plain.npy"),
               "%.60a" % environment, result)
    done = subprocess.run([tool.path, "render", "-q", "-o", "b.npy"], cwd=tool.folder, env={}, capture_output=True)
    tap.ok(done.returncode == 0 and tool.read("b.npy") == tool.read("plain.npy"), "no environment", done)


def closed_streams(tap, tool):
    """Every combination; what is closed does not become the file that is written."""
    tool.run("render", "-q", "-o", "plain.npy")
    for closed in itertools.product([False, True], repeat=3):
        def close(which=closed):
            for number in range(3):
                if which[number]:
                    os.close(number)
        done = subprocess.run([tool.path, "render", "-o", "a.npy"], cwd=tool.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=close)
        tap.equal((done.returncode, tool.read("a.npy") == tool.read("plain.npy")), (4 if closed[1] else 0, True),
                  "stdin, stdout, stderr closed: %r" % (closed,))


def masks(tap, tool):
    for mask in 0o077, 0o027, 0:
        tool.run("render", "-q", "-o", "a.npy", preexec_fn=lambda: os.umask(mask))
        tap.equal(os.stat(tool.file("a.npy")).st_mode & 0o777, 0o666 & ~mask, "umask %03o" % mask)
        os.remove(tool.file("a.npy"))


run_tests(Tap(), names_in_scenes, names_in_drawings, arguments, keys_and_units, names_like_options, few_descriptors,
          small_stack, surroundings, closed_streams, masks)
