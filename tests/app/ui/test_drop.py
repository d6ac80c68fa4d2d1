# SPDX-License-Identifier: MIT
"""Meshes and photometry files come into the scene that is open, where they are seen; Undo takes them back."""
import json

from gi.repository import GLib

from desk import luxel, trial
from waiting import wait

TETRAHEDRON = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
LAMP = """IESNA:LM-63-2002
[TEST] a lamp of this test
[MANUFAC] nobody
TILT=NONE
1 1000 1 5 1 1 2 0 0 0
1 1 10
0 22.5 45 67.5 90
0
300 280 200 90 0
"""


def write(desk, name, text):
    path = desk.path(name)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    return path


def meshes(tap, desk):
    window = desk.start().window()
    window.save(desk.path("own.yaml"))
    scene = window.save()
    window.act("take-path", write(desk, "tetra.obj", TETRAHEDRON))
    text = wait("a second surface", lambda: window.save() if b"tetra.obj" in window.save() else None)
    tap.ok(b"file: tetra.obj" in text or b'file: "tetra.obj"' in text, "a mesh is named from the scene's folder", text)
    tap.ok(b"scale: 120" in text or b"scale: 130" in text, "a small one is made half as large as the screen", text)
    tap.ok(wait("the numbers", window.values), "and the scene is computed with it")
    tap.ok(window.widget.find("button", "Open…"), "beside the file's name another one can be chosen")
    other = write(desk, "other.obj", TETRAHEDRON.replace("2", "3"))
    window.act("choose-file-path", GLib.Variant("(ss)", ("surfaces[1].file", other)))
    wait("the other file", lambda: b"other.obj" in window.save())
    window.act("undo")
    window.act("undo")
    tap.equal(wait("no mesh", lambda: window.save() if b"obj" not in window.save() else None), scene,
              "Undo takes it back")
    window.act("take-path", write(desk, "broken.obj", "v 0 0 0\nf 1 2 3\n"))
    tap.ok(wait("a word about it", lambda: window.says("broken.obj")), "what is wrong with a file is said")
    tap.equal(window.save(), scene, "and the scene stays as it was")


def luminaires(tap, desk):
    window = desk.start().window()
    scene = window.save(desk.path("own.yaml"))

    def diagram():
        return window.says(" lm, at most 300 cd, beam ")

    tap.ok(not diagram(), "a point has no diagram")
    window.act("take-path", write(desk, "lamp.ies", LAMP))
    wait("a second source", lambda: len(window.sources()) == 2)
    text = window.save()
    tap.ok(b"type: luminaire" in text and b"lamp.ies" in text and b"aim: [0, 0, 1000]" in text,
           "a photometry file becomes a luminaire, aimed at the surface", text)
    tap.ok(wait("its diagram", diagram), "whose polar diagram stands in the form, with its flux, peak and beam")
    tap.ok(window.widget.find("image", "Polar diagram"), "and a name for those who do not see it")
    tap.ok(not window.says("UGR "), "a point has no luminance, and no glare ratings")
    window.act("undo")
    wait("one source again", lambda: len(window.sources()) == 1)
    window.act("take-path", write(desk, "panel.ies", LAMP.replace("2 0 0 0", "2 .6 .6 0")))
    told = json.loads(luxel("photometry", desk.path("panel.ies"), "--json"))["ugr"]["rooms"]
    room = next(room for room in told if (room["across"], room["along"]) == (4, 8))
    line = "UGR %.1f crosswise, %.1f endwise" % (room["crosswise"][0], room["endwise"][0])
    tap.ok(wait("its ratings", lambda: window.says(line)), "a panel's stand below its diagram: " + line)
    window.act("undo")
    wait("one source", lambda: len(window.sources()) == 1)
    tap.equal(window.save(), scene, "Undo takes it back")
    tap.ok(wait("no diagram", lambda: not diagram()), "and the diagram with it")
    window.act("take-path", write(desk, "broken.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 5"))
    tap.ok(wait("a word about it", lambda: window.says("broken.ies")), "what is wrong with a file is said")
    tap.equal(window.save(), scene, "and the scene stays as it was")


trial(meshes, luminaires)
