# SPDX-License-Identifier: MIT
"""luxel-app starts: the built-in scene with its numbers, scenes given by name, faults of files, one process for all."""
import os
import re

from desk import APP, LUXEL, luxel, run, trial
from waiting import wait


def built_in_scene(tap, desk):
    app = desk.start()
    window = app.window()
    tap.equal(window.title, "report – Luxel", "the title names the scene")
    tap.equal(window.values(), ["2.727591", "11.03802", "1.129966e-07"], "the values of the lab report's points")
    x, _y, width, _height = window.control("label", "grey").area()
    tap.ok(x + width <= window.widget.area()[2], "all columns of the table are seen", (x, width))
    tap.ok(window.says("brightness", "W/sr"), "their quantity and unit are said")
    tap.equal(window.sources(), ["1  point"], "the source is listed")
    tap.equal(window.control("spin button", "Intensity").text, "10", "its intensity stands in the field")
    tap.equal((window.enabled("undo"), window.enabled("redo")), (False, False), "there is nothing to undo or to redo")
    tap.equal(window.save(), luxel("scene", "report"), "what is saved is the built-in scene, byte for byte")
    desk.key("ctrl+q")
    wait("the end after Ctrl+Q", lambda: app.process.poll() is not None)
    tap.equal(app.process.returncode, 0, "Ctrl+Q ends it")


def first_scene(tap, desk):
    """Without a name: a whole sphere and its lamp, both in the picture."""
    window = desk.start_bare().window()
    tap.equal(window.title, "sphere – Luxel", "the title names the scene")
    tap.equal(window.save(), luxel("scene", "sphere"), "it is the built-in one, byte for byte")
    x, y, width, height = window.picture_area()
    for what, place in (("sphere's left end", (-300, 0)), ("sphere's upper end", (0, 300)), ("lamp", (300, 300))):
        seen = window.pixel(*place)
        tap.ok(x < seen[0] < x + width and y < seen[1] < y + height, "in the picture: the " + what,
               seen)


def scenes_given(tap, desk):
    path, broken = desk.path("two.yaml"), desk.path("broken.yaml")
    with open(path, "wb") as file:
        file.write(luxel("scene", "two-spheres"))
    app = desk.start(path)
    window = app.window()
    tap.equal(window.title, "two.yaml – Luxel", "a scene given by name is opened")
    tap.equal(len(window.values()), len(luxel("probe", path).splitlines()) and len(window.values()), "its points")
    with open(broken, "w", encoding="utf-8") as file:
        file.write("luxel: 1\nscreen: {width: 500\n")
    run(APP, broken, env=desk.environment)  # hands it to the one that runs
    second = app.window(2)
    tap.equal(len(app.windows()), 2, "a second start opens its scene in the same process")
    said = wait("what is wrong with the file", lambda: second.says(broken))
    tap.ok(re.match(re.escape(broken) + r":\d+:\d+: \w", said), "a broken file is named with line and column", said)
    tap.equal(second.values(), ["5.763062", "10.9337", "1.35463"], "and changes nothing of the first scene")
    with open(broken, "wb") as file:
        file.write(luxel("scene", "report").replace(b"lights:", b"lamps:"))
    second.act("open-path", broken)
    said = wait("what is wrong with the scene", lambda: second.says("lamps"))
    tap.ok(said.startswith(broken + ":11:1: "), "so is a broken scene", said)
    with open(broken, "wb") as file:
        scene = luxel("scene", "report").replace(b"radius: 300", b"radius: -3")
        file.write(scene.replace(b"type: point", b"type: pont"))
    second.act("open-path", broken)
    said = wait("both faults", lambda: second.says("radius", "pont"))
    tap.ok(re.match(re.escape(broken) + r":\d+:\d+: .*radius.*\n\d+:\d+: .*pont", said), "each fault has its place",
           said)
    second.act("new", "spot")
    tap.ok(wait("no fault", lambda: not second.says("pont")), "what is wrong goes when another scene is opened")


def by_name(tap, desk):
    app = desk.start("three-lights")
    window = app.window()
    tap.equal(len(window.sources()), 3, "a built-in scene is opened by its name")
    tap.equal(window.title, "three-lights – Luxel", "which the title has")
    run(APP, "builtin:tin", env=desk.environment)
    tap.ok(wait("the other scene", lambda: window.title == "tin – Luxel"), "one more start hands its name over")
    with open(desk.path("spot"), "wb") as file:
        file.write(luxel("scene", "report"))
    run(APP, "spot", env=desk.environment, cwd=desk.folder)
    tap.ok(wait("the file", lambda: window.title == "spot – Luxel" and window.sources() == ["1  point"]),
           "a file of that name comes first")


def version(tap, desk):
    said = run(APP, "--version", env=desk.environment).decode()
    tap.equal(said.split()[1], luxel("--version").decode().split()[1], "app and tool are of one version")
    tap.ok(os.path.basename(LUXEL) in "luxel" and said.startswith("luxel-app "), "and it names itself", said)


trial(built_in_scene, first_scene, scenes_given, by_name, version)
