# SPDX-License-Identifier: MIT
"""Luminaires: the numbers of `luxel photometry`, intensities in any direction, files, diagrams, what is refused."""
import math
import os
import pickle
import re
import threading

import numpy

import luminaires
from package import Tap, luxel, raises, run_tests

AXIAL = luminaires.HEAD + luminaires.AXIAL


def quadrant():
    """A type C file of planes 0, 45 and 90 whose intensities tell their place."""
    rows = ["%g %g %g %g" % tuple(100 * plane + angle for angle in (4, 3, 2, 1)) for plane in (1, 2, 3)]
    return luminaires.HEAD + "1 1000 1 4 3 1 2 .1 .2 0\n1 1 10\n0 30 60 90\n0 45 90\n" + "\n".join(rows) + "\n"


def test_numbers(tap, tool):
    """Everything is as the tool's JSON has it."""
    for name, text in (("a.ies", AXIAL), ("q.ies", quadrant()), ("b.ldt", luminaires.eulumdat())):
        tool.write(name, text)
        answer = tool.run("photometry", name, "--json").json()
        lamp = luxel.Photometry(tool.file(name))
        found = lamp.figures
        tap.equal((lamp.format, lamp.type, lamp.symmetry, lamp.opening.shape, lamp.declared_lumens),
                  (answer["format"], answer["type"], answer["symmetry"], answer["opening"]["shape"]
                   if isinstance(answer["opening"], dict) else answer["opening"], answer["declared_lumens"]),
                  name + ": what it is")
        tap.equal((found.flux, found.linear_flux, found.lorl, found.dff, found.beam_deg, found.field_deg),
                  (answer["flux"]["zone"], answer["flux"]["linear"], answer["lorl"], answer["dff"],
                   answer["beam_angle"], answer["field_angle"]), name + ": what is read off it")
        tap.equal((found.greatest.intensity, found.greatest.c_deg, found.greatest.gamma_deg),
                  (answer["max"]["intensity"], answer["max"]["c"], answer["max"]["gamma"]), name + ": the greatest")
        with open(tool.file(name), "rb") as file:
            tap.ok((luxel.Photometry(file.read(), name).intensities == lamp.intensities).all(), name + ": its bytes")
    tap.equal((lamp.lamp_sets[0].lumens, lamp.lamp_sets[0].type, lamp.housing_mm), (1000, "LED", (100, 100, 50)),
              "lamps and housing")
    tap.equal(dict(luxel.Photometry(AXIAL.encode()).texts)["MANUFAC"], "Lampe AG", "texts")


def test_directions(tap, tool):
    lamp = luxel.Photometry(quadrant().encode())
    tap.equal((lamp.intensities.shape, lamp.planes[0], lamp.planes[-1], list(lamp.angles)),
              ((len(lamp.planes), 4), 0, 360, [0, 30, 60, 90]), "the table is complete")
    tap.equal((lamp.intensity(0, 30), lamp.intensity(22.5, 30), lamp.intensity(-45, 45), lamp.intensity(0, 91)),
              (103, 153, 202.5, 0), "at places, between them, by symmetry, and beyond")
    planes, angles = numpy.meshgrid(numpy.linspace(0, 360, 13), numpy.linspace(0, 90, 7), indexing="ij")
    array = lamp.intensity(planes, angles)
    tap.ok(array.shape == (13, 7) and all(array[i, j] == lamp.intensity(planes[i, j], angles[i, j])
                                          for i in range(13) for j in range(7)), "arrays")
    tap.ok((lamp.intensity(planes[:, :1], angles[:1]) == array).all(), "are broadcast")
    tap.ok((lamp.intensity(planes.T, angles.T) == array.T).all(), "whatever their strides")
    by_cosine = lamp.intensity(0, 45, "cosine")
    share = (math.cos(math.radians(30)) - math.cos(math.radians(45))) / (math.cos(math.radians(30)) - 0.5)
    tap.near(by_cosine, 103 - share, 1e-14, "linear in the cosine")
    ways = lamp.direction(planes, angles)
    tap.ok(ways.shape == (13, 7, 3) and numpy.allclose((ways ** 2).sum(-1), 1, atol=1e-15), "unit vectors")
    tap.ok(numpy.allclose(ways[:, :, 0], numpy.cos(numpy.radians(angles)), atol=1e-15), "the axis is nadir")
    back = lamp.angles_of(3 * ways[1:-1, 1:])
    tap.ok(numpy.allclose(back[..., 0], planes[1:-1, 1:], atol=1e-12) and
           numpy.allclose(back[..., 1], angles[1:-1, 1:], atol=1e-12), "there and back")
    tap.ok(raises(ValueError, lamp.angles_of, [1, 2]) and raises(ValueError, lamp.intensity, 0, 0, "linear"), "refused")
    view = lamp.intensities
    tap.ok(raises(ValueError, view.__setitem__, (0, 0), 1), "the table cannot be written")
    del lamp
    tap.equal(view[0, 1], 103, "and lives as long as it is used")


def test_files(tap, tool):
    lamp = luxel.Photometry(quadrant().encode())
    for name in "copy.ies", "copy.ldt":
        lamp.write(tool.file(name))
        again = luxel.Photometry(tool.file(name))
        tap.ok(numpy.allclose(again.intensity(lamp.planes[:, None], lamp.angles), lamp.intensities, rtol=1e-12),
               name + " reads back")
        pickled = pickle.dumps(again)
        os.remove(tool.file(name))
        tap.equal(pickle.loads(pickled).intensities.tolist(), again.intensities.tolist(),
                  name + ": a pickle has its file")
        lamp.write(tool.file(name))
    tap.ok(raises(luxel.LuxelValueError, lamp.write, tool.file("copy.txt")), "another extension")
    tap.ok(raises(luxel.LuxelError, lamp.write, tool.file("no/folder.ies")), "a folder that is not there")
    scene = luxel.Scene("desk")
    scene.update({"lights": [{"type": "luminaire", "file": tool.file("copy.ies"), "position": [0, 0, 5000]}],
                  "shadows": "none"})
    angle = math.degrees(math.atan2(1, 2))
    found = scene.probe_element((0, 1000, 3000), (0, 0, 1), quantity="irradiance").value
    tap.near(found, lamp.intensity(90, angle) * math.cos(math.radians(angle)) / 5, 1e-12, "the light of a scene")


def test_refused(tap, tool):
    for title, text, place, words in luminaires.WRONG[:12]:
        error = raises(luxel.LuxelError, luxel.Photometry, text.encode("latin-1"), "lamp")
        tap.ok(error and words in str(error) and "lamp:" + place in str(error), title, error)
    for title, text, words in luminaires.ODD[:12]:
        entries = luxel.Photometry(text.encode("latin-1"), "lamp").warnings
        told = ["line %d, column %d: %s" % (entry.line, entry.column, entry.message) for entry in entries]
        tap.ok(any(words in each for each in told), title, told)
    error = raises(luxel.LuxelError, luxel.Photometry, tool.file("none.ies"))
    tap.ok(error and error.status == "file" and "none.ies" in str(error), "no file", error)
    tap.ok(raises(TypeError, luxel.Photometry, 5), "a number is no luminaire")


def drawn(svg):
    """An SVG without the numbers by which cairo counts what a process has drawn."""
    return re.sub(r"surface\d+", "surface", svg)


def test_diagrams(tap, tool):
    tool.write("a.ies", AXIAL)
    lamp = luxel.Photometry(tool.file("a.ies"))
    try:
        luxel.palettes()
    except ImportError:
        tap.skip("diagrams", "no figures")
        return
    for kind in "polar", "cartesian", "cone":
        diagram = lamp.diagram(kind, dark=kind == "cone")
        diagram.save(tool.file("d.svg"))
        tap.ok(drawn(tool.read("d.svg").decode()) == drawn(diagram.svg()) == drawn(diagram._repr_svg_()),
               kind + " as SVG")
        tap.ok(pickle.loads(pickle.dumps(diagram)).png() == diagram.png(), kind + " pickled")
        tap.ok(diagram.png().startswith(b"\x89PNG") and diagram.pdf().startswith(b"%PDF"), kind + " as PNG and PDF")
    tool.run("photometry", "a.ies", "-o", "tool.svg", "--title", "A lamp")
    tap.ok(drawn(lamp.diagram(title="A lamp").svg()) == drawn(tool.read("tool.svg").decode()), "as the tool draws it")
    tap.ok(raises(luxel.LuxelValueError, lamp.diagram(width_mm=1).png) and raises(ValueError, lamp.diagram, "round"),
           "refused")
    tap.ok("LM-63-1995" in repr(lamp) and "<table>" in lamp._repr_html_(), "notebooks")


def test_threads(tap, tool):
    """Luminaires never change: any number of threads may use one."""
    lamp, found = luxel.Photometry(quadrant().encode()), []
    threads = [threading.Thread(target=lambda: found.append(lamp.intensity(numpy.linspace(0, 360, 100000), 45).sum()))
               for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    tap.equal(len(set(found)), 1, "four threads, one sum")
    tap.ok(os.path.exists(tool.path), "and nothing broke")


run_tests(Tap(), test_numbers, test_directions, test_files, test_refused, test_diagrams, test_threads)
