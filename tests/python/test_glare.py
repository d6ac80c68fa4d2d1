# SPDX-License-Identifier: MIT
"""Unified glare ratings: as the tool tells them, as worked out by hand, what is refused, tables for notebooks."""
import math
import pickle

import numpy

import luminaires
from package import Tap, luxel, raises, run_tests

SCENE = """luxel: 1
units: photometric
screen: {width: 400, height: 400, resolution: [8, 8]}
observer: {z: 9000}
surfaces: [{type: rectangle, size: [10, 10], center: [0, 0, -3000]}]
lights:
  - {type: planar, name: "<panel>", radiance: 5000,
     rectangle: {center: [0, 4000, 1800], size: [600, 600], axis: [0, 0, -1], up: [0, 1, 0]}}
  - {type: ambient, irradiance: 125.66370614359172}
  - {type: point, position: [0, 4000, 1800], intensity: 1}
"""
TRUTH = 18.0555676521171


def lamp_text(opening="0.6 0.6 0"):
    angles = range(0, 91, 5)
    values = " ".join(repr(1800 * math.cos(math.radians(g))) for g in angles)
    return luminaires.HEAD + "1 -1 1 19 1 1 2 %s\n1 1 10\n%s\n0\n%s\n" % (opening, " ".join(map(str, angles)), values)


def test_observer(tap, tool):
    scene = luxel.Scene(SCENE)
    found = scene.glare((0, 0, 0), (0, 2, 0))
    tap.near(found.ugr, TRUTH, 1e-13, "a panel, by hand")
    tap.ok(found.error < 1e-10 and found.reached and abs(found.background.value - 40) < 1e-12, "its bound", found)
    told = tool.run("glare", "-", "--json", "--eye", "0,0,0,0,2,0", stdin=SCENE).json()["observers"][0]
    tap.equal((found.ugr, found.error, tuple(found.background)),
              (told["ugr"], told["error"], (told["background"]["value"], told["background"]["error"])), "the tool's")
    tap.equal([source._asdict() for source in found.sources], [{**source, "place": None} for source in told["sources"]],
              "each light")
    tap.equal([source.status for source in found.sources], ["counts", "background", "no_area"], "what counts")
    tap.equal(pickle.loads(pickle.dumps(found)), found, "pickled")
    tilted = scene.glare(numpy.array([0, 0, 0]), (0, 1, 0), up=(1, 0, 0))
    tap.ok(tilted.sources[0].position_index < found.sources[0].position_index, "a panel beside the observer", tilted)
    tap.equal(scene.glare((0, 0, 0), (0, -1, 0)).ugr, None, "behind the observer nothing dazzles")
    tap.equal(scene.glare((0, 0, 0), (0, 1, 0), lights="<panel>").ugr, None, "a group of lights without a background")
    html = found._repr_html_()
    tap.ok("&lt;panel&gt;" in html and "UGR 18.0555" in html and "has no luminous area" in html, "a table", html)
    luxel.set_language("ru")
    try:
        tap.ok("luminous" not in found._repr_html_() and "glare" not in found._repr_html_(), "in Russian", html)
    finally:
        luxel.set_language("en")


def test_refused(tap, tool):
    scene = luxel.Scene(SCENE)
    for arguments, word in ((((0, 0), (0, 1, 0)), "eye_mm"), (((0, 0, 0), (0, 1)), "view"),
                            (((0, 0, 0), (0, 0, 0)), "view"), (((0, 0, 0), (0, 1, 0), (0, 3, 0)), "up"),
                            (((0, 0, 0), (0, 1, 0), (0, 0, 0)), "up"), (((0, 0, math.inf), (0, 1, 0)), "eye_mm")):
        error = raises(ValueError, scene.glare, *arguments)
        tap.ok(error is not None and word in str(error), "refused: %r" % (arguments,), error)
    error = raises(ValueError, luxel.Scene("report").glare, (0, 0, 0), (0, 1, 0))
    tap.ok(error is not None and "photometric" in str(error), "a scene in W", error)
    lamp = luxel.Photometry(lamp_text().encode())
    for spacing in (0.3, 0, -1, 2, math.nan):
        tap.ok(raises(ValueError, lamp.ugr, spacing), "no spacing: %r" % spacing)
    tap.ok(raises(TypeError, lamp.ugr, None), "no number")


def test_table(tap, tool):
    tool.write("lamp.ies", lamp_text())
    lamp = luxel.Photometry(tool.file("lamp.ies"))
    for spacing in (0.25, 1):
        found = lamp.ugr(spacing)
        told = tool.run("photometry", "lamp.ies", "--json", "--spacing", str(spacing)).json()["ugr"]
        tap.equal(found.spacing, told["spacing"], "the spacing")
        tap.equal([{"across": across, "along": along} for across, along in found.rooms],
                  [{"across": room["across"], "along": room["along"]} for room in told["rooms"]], "the rooms")
        tap.equal([triple._asdict() for triple in found.reflectances], told["reflectances"], "the reflectances")
        for way in ("crosswise", "endwise"):
            tap.equal(getattr(found, way).tolist(), [room[way] for room in told["rooms"]], way)
    tap.equal(found.catalogue, (told["rooms"][10]["crosswise"][0], told["rooms"][10]["endwise"][0]), "what is quoted")
    html = lamp.ugr()._repr_html_()
    tap.ok("4H × 8H" in html and "%.1f" % lamp.ugr().catalogue[0] in html and "UGR (CIE 190)" in html, "a table", html)
    tap.equal(luxel.Photometry(lamp_text("0 0 0").encode()).ugr(), None, "a point has no luminance")
    tap.ok(numpy.isfinite(found.crosswise).all() and found.crosswise.shape == (19, 5), "arrays", found.crosswise)


def test_room(tap, tool):
    tool.write("lamp.ies", lamp_text())
    lamp, done = luxel.Photometry(tool.file("lamp.ies")), []
    found = lamp.room(2, 2, 1, threads=1, progress=done.append)
    told = tool.run("photometry", "lamp.ies", "--json", "--spacing", "1", "--room", "2,2").json()["ugr"]["room"]
    tap.equal((found.across, found.along, found.spacing), (told["across"], told["along"], 1.0), "the room")
    for name, numbers in (("background", [b["value"] for b in told["background"]]),
                          ("background_error", [b["error"] for b in told["background"]]),
                          ("background_by_table", told["background_by_table"]), ("crosswise", told["crosswise"]),
                          ("endwise", told["endwise"]), ("error", told["error"])):
        tap.ok(numpy.allclose(getattr(found, name), numbers, rtol=1e-9), name, getattr(found, name), numbers)
    tap.ok(found.reached and 0.8 <= done[-1] <= 1 and done == sorted(done), "told how far it is", done)
    table = lamp.ugr(1)
    row = table.rooms.index((2.0, 2.0))
    tap.ok(numpy.abs(found.crosswise - table.crosswise[row]).max() < 1, "near to the table", found.crosswise)
    html = found._repr_html_()
    tap.ok("2H × 2H" in html and "%.2f" % found.endwise[0] in html, "a table for notebooks", html)
    tap.equal(pickle.loads(pickle.dumps(found)).reflectances, table.reflectances, "it is pickled")
    for room, word in (((5, 5), "4 and 8"), ((2, 2, 0.3), "spacing")):
        error = raises(ValueError, lamp.room, *room)
        tap.ok(error is not None and word in str(error), "refused: %r" % (room,), error)
    point = raises(ValueError, luxel.Photometry(lamp_text("0 0 0").encode()).room, 2, 2)
    tap.ok(point is not None and "luminance" in str(point), "a point", point)


run_tests(Tap(), test_observer, test_refused, test_table, test_room)
