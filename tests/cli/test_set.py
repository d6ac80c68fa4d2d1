# SPDX-License-Identifier: MIT
"""luxel set: the file changes in place and keeps what was not changed, or it is not touched at all."""
import json
import os
import stat

from tap import Tap
from tool import SCENE, run_tests

NOBODY = 65534
COMMENTED = SCENE.replace("luxel: 1\n", "# My scene\n\nluxel: 1   # always\n").replace(
    "attenuation: none}", "attenuation: none}  # the lamp") + "\n# the end"


def in_place(tap, tool):
    tool.write("a.yaml", COMMENTED)
    os.chmod(tool.file("a.yaml"), 0o640)
    result = tool.run("set", "a.yaml", "lights[0].intensity=20", "shadows=none")
    tap.equal((result.code, result.out, result.err), (0, "", ""), "silent")
    expected = COMMENTED.replace("intensity: 10", "intensity: 20").replace("\n\n# the end",
                                                                           "\nshadows: none\n\n# the end")
    tap.equal(tool.read("a.yaml").decode(), expected, "only the values change")
    tap.equal(stat.S_IMODE(os.stat(tool.file("a.yaml")).st_mode), 0o640, "the permissions stay")
    tap.equal(tool.files(), ["a.yaml"], "nothing is left beside it")
    tap.equal(tool.run("set", "-q", "-s", "shadows=points", "a.yaml", "units=photometric").code, 0, "-s and -q")
    tap.equal(tool.read("a.yaml").decode(),
              expected.replace("shadows: none", "shadows: points").replace("radiometric", "photometric"), "both")


def same_value(tap, tool):
    tool.write("a.yaml", COMMENTED)
    os.utime(tool.file("a.yaml"), ns=(10**18, 10**18))
    before = os.stat(tool.file("a.yaml"))
    tap.equal(tool.run("set", "a.yaml", "lights[0].intensity=10", "units=\"radiometric\"").code, 0, "no change")
    after = os.stat(tool.file("a.yaml"))
    tap.equal((after.st_mtime_ns, after.st_ino), (before.st_mtime_ns, before.st_ino), "the file is not touched")


def into_groups_and_lists(tap, tool):
    lamp = "{type: planar, vertices: [[0, 0, 2000], [0, 90, 2000], [90, 0, 2000]], radiance: 5}  # a corner"
    grid = "grids: [{center: [0, 0, 0], size: [10, 10], n: [3, 3]}]\n"
    text = COMMENTED.replace("{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}", lamp)
    tool.write("a.yaml", text + "\n" + grid)
    changes = [("lights[0].vertices[1]=[0, 80, 2000]", "[0, 90, 2000]", "[0, 80, 2000]"),
               ("lights[0].vertices[2][0]=70", "[90, 0, 2000]", "[70, 0, 2000]"),
               ("lights.0.parts=3", "radiance: 5}", "radiance: 5, parts: 3}"),
               ("lights[0].parts=converged", "parts: 3}", "parts: converged}"),
               ("grids[0].n[1]=4", "n: [3, 3]", "n: [3, 4]"),
               ("grids[0].up=[1, 1, 0]", "n: [3, 4]}", "n: [3, 4], up: [1, 1, 0]}")]
    for change, old, new in changes:
        before = tool.read("a.yaml").decode()
        result = tool.run("set", "a.yaml", change)
        tap.equal((result.code, tool.read("a.yaml").decode()), (0, before.replace(old, new)), change)
    outline = "lights[0]={type: planar, rectangle: {center: [0, 0, 2000], size: [9, 9]}, power: 1}"
    tap.equal(tool.run("set", "a.yaml", outline, "lights[0].rectangle.size=[100, 200]",
                       "lights[0].rectangle.aim=[5, 5, 0]").code, 0, "a group, and keys in it")
    tap.ok("rectangle: {center: [0, 0, 2000], size: [100, 200], aim: [5, 5, 0]}" in tool.read("a.yaml").decode(),
           "both are there", tool.read("a.yaml"))
    before = tool.read("a.yaml")
    for change, code, words in [
            ("lights[0].disk.radius=5", 3, ["disk", "rectangle"]), ("lights[0].rectangle.sise=5", 2, ["size"]),
            ("grids[1].n=[1, 1]", 2, ["grids[0]"]), ("grids.n=[1, 1]", 2, ["grids[0].n"]),
            ("grids[0].n[2]=1", 2, ["grids[0].n[1]"]), ("lights[0].parts[0]=1", 2, ["parts", "list"]),
            ("lights[0].rectangle[0]=1", 2, ["rectangle", "list"]), ("grids[0].n=[9999, 9999]", 3, ["10000000"])]:
        result = tool.run("set", "a.yaml", change)
        tap.ok(result.code == code and all(word in result.err for word in words) and tool.read("a.yaml") == before,
               change, result)


def errors(tap, tool):
    tool.write("a.yaml", COMMENTED)
    tool.write("bad.yaml", COMMENTED.replace("width: 500", "width: -5"))
    cases = [(3, "a.yaml", ["lights[0].intensity=-1", "screen.width=x"], ["intensity", "width"]),
             (3, "a.yaml", ["lights=[{type: spot"], ["not closed"]),
             (2, "a.yaml", ["lights[0].intensty=1"], ["intensity"]),
             (2, "a.yaml", ["lights[7].intensity=1"], ["lights[0]"]),
             (2, "a.yaml", ["shadows"], ["'='"]),
             (2, "a.yaml", [], ["SCENE"]),
             (3, "bad.yaml", ["shadows=none"], ["width"]),
             (4, "none.yaml", ["shadows=none"], ["none.yaml"])]
    for code, name, sets, words in cases:
        before = {each: tool.read(each) for each in tool.files()}
        result = tool.run("set", name, *sets)
        tap.equal((result.code, result.out), (code, ""), "%s %s" % (name, sets))
        tap.ok(all(word in result.err for word in words), "the message names it", result)
        tap.equal({each: tool.read(each) for each in tool.files()}, before, "nothing was touched")
    tap.equal(tool.run("set").code, 2, "without a scene")
    tap.equal(tool.run("set", "bad.yaml", "screen.width=500").code, 0, "a wrong scene may be mended")
    tap.equal(tool.read("bad.yaml").decode(), COMMENTED, "and then is right")


def judged(tap, tool):
    """What no picture can be made of is written, as it may be a step on the way, and told."""
    tool.write("a.yaml", COMMENTED)
    result = tool.run("set", "a.yaml", "observer.z=10", "observer.projection=perspective")
    tap.ok(result.code == 0 and "no picture" in result.err and "observer" in result.err, "an observer too low", result)
    tap.ok("z: 10" in tool.read("a.yaml").decode(), "it is written", tool.read("a.yaml"))
    tap.equal(tool.run("check", "a.yaml").code, 3, "luxel check refuses it")
    result = tool.run("set", "a.yaml", "observer.z=1500", "-q")
    tap.equal((result.code, result.err), (0, ""), "mended: nothing is said")


def elsewhere(tap, tool):
    tool.write("a.yaml", COMMENTED)
    changed = COMMENTED.replace("radiometric", "photometric")
    result = tool.run("set", "a.yaml", "units=photometric", "-o", "b.yaml", "-o", "-")
    tap.equal((result.code, result.out), (0, changed), "-o - is standard output")
    tap.equal(tool.read("b.yaml").decode(), changed, "-o writes elsewhere")
    for dry in "-n", "--dry-run":
        result = tool.run("set", "a.yaml", "units=photometric", dry, "-o", "c.yaml")
        tap.equal((result.code, result.out), (0, changed), dry)
    tap.equal(tool.read("a.yaml").decode(), COMMENTED, "the scene stays")
    tap.equal(tool.files(), ["a.yaml", "b.yaml"], "a dry run writes nothing")
    result = tool.run("set", "-", "units=photometric", stdin=COMMENTED)
    tap.equal((result.code, result.out), (0, changed), "standard input goes to standard output")
    result = tool.run("set", "-", "units=photometric", "--json", stdin=COMMENTED)
    tap.equal(json.loads(result.out), {"name": "<stdin>", "text": changed}, "as JSON")
    builtin = tool.run("scene", "report").out
    result = tool.run("set", "report", "units=photometric")
    tap.equal((result.code, result.out), (0, builtin.replace("radiometric", "photometric")), "a built-in scene")
    result = tool.run("scene", "report", "-s", "units=photometric")
    tap.equal((result.code, result.out), (0, builtin.replace("radiometric", "photometric")), "luxel scene -s")
    tap.equal(tool.files(), ["a.yaml", "b.yaml"], "nothing was written")
    tap.equal(tool.run("set", "a.yaml", "shadows=none", "-o", "gone/b.yaml").code, 4, "no such folder")


def pictures(tap, tool):
    tap.equal(tool.run("render", "report", "-s", "screen.resolution=[36, 36]", "-o", "a.png").code, 0, "a picture")
    before = tool.read("a.png")
    result = tool.run("set", "a.png", "shadows=none")
    tap.equal((result.code, result.out), (2, ""), "is not changed in place")
    result = tool.run("set", "a.yaml", "shadows=none", "-o", "a.png")
    tap.equal(result.code, 2, "and no scene gets its name")
    tap.ok("a.png" in result.err, "the message names it", result)
    tap.equal(tool.run("set", "a.png", "shadows=none", "-o", "a.yaml").code, 0, "its scene is written elsewhere")
    tap.ok(tool.read("a.yaml").startswith(b"# The lab report"), "with its comments", tool.read("a.yaml"))
    tap.equal((tool.read("a.png"), tool.files()), (before, ["a.png", "a.yaml"]), "the picture stays")


def links_and_folders(tap, tool):
    os.mkdir(tool.file("folder"))
    tool.write("folder/a.yaml", COMMENTED)
    os.symlink("folder/a.yaml", tool.file("link.yaml"))
    tap.equal(tool.run("set", "link.yaml", "shadows=none").code, 0, "through a link")
    tap.ok(os.path.islink(tool.file("link.yaml")), "which stays")
    tap.ok(b"shadows: none" in tool.read("folder/a.yaml"), "its file is written")
    before = tool.read("folder/a.yaml")
    as_nobody = {}
    if os.getuid() == 0:
        as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        os.chmod(tool.folder, 0o755)
        os.chown(tool.file("folder"), NOBODY, NOBODY)
        os.chown(tool.file("folder/a.yaml"), NOBODY, NOBODY)
    os.chmod(tool.file("folder"), 0o500)
    try:
        result = tool.run("set", "link.yaml", "shadows=points", **as_nobody)
        tap.equal((result.code, tool.read("folder/a.yaml")), (4, before), "a read-only folder")
        tap.ok("link.yaml" in result.err, "the message names the file", result)
    except PermissionError:
        tap.skip("a read-only folder", "others may not run the tool")
    os.chmod(tool.file("folder"), 0o700)
    tap.equal(tool.run("set", "folder", "shadows=points").code, 4, "a folder is no scene")


def json_scenes(tap, tool):
    tool.write("a.json", '{\r\n  "luxel": 1, "screen": {"width": 500, "height": 500, "resolution": [36, 36]},\r\n'
                         '  "observer": {"z": 1500},\r\n'
                         '  "surfaces": [{"type": "sphere", "center": [0, 0, 1000], "radius": 200}],\r\n'
                         '  "lights": []\r\n}')
    before = tool.read("a.json").decode()
    tap.equal(tool.run("set", "a.json", "observer.z=+1600", "observer.view=observer", "surfaces[0].radius=.5e2",
                       "lights=[{type: ambient, irradiance: 3}]", "units=photometric").code, 0, "JSON")
    after = tool.read("a.json").decode()
    tap.equal(after, before.replace('{"z": 1500}', '{"z": 1600, "view": "observer"}').replace(
        '"radius": 200', '"radius": 0.5e2').replace('"lights": []', '"lights": [{"type": "ambient", "irradiance": 3}],'
                                                    '\r\n  "units": "photometric"'), "stays as it is")
    tap.equal(json.loads(after)["units"], "photometric", "and is JSON")


run_tests(Tap(), in_place, same_value, into_groups_and_lists, errors, judged, elsewhere, pictures, links_and_folders,
          json_scenes)
