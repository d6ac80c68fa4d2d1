# SPDX-License-Identifier: MIT
"""What is made for people: explanations, figures, reports, tables, judgements; as the tool makes them."""
import os
import pickle
import re

import numpy

from package import Tap, luxel, raises, run_tests
from tool import SCENE


def test_explain(tap, tool):
    scene = luxel.Scene("report")
    document = scene.explain((150, 0))
    tap.equal(str(document), tool.run("explain", "report", "-p", "150,0").out, "the text of the tool")
    for ending, text in ((".md", document.markdown), (".tex", document.latex), (".html", document.html)):
        tool.run("explain", "report", "-p", "150,0", "-o", "a" + ending)
        document.save(tool.file("b" + ending))
        tap.ok(text == tool.read("a" + ending).decode() == tool.read("b" + ending).decode(), ending + ": its bytes")
    again = pickle.loads(pickle.dumps(document))
    again.save(tool.file("c.html"))
    tap.equal((again.text, tool.read("c.html")), (document.text, tool.read("a.html")), "a pickle")
    tap.equal((document._repr_html_(), document._repr_markdown_()), (document.html, document.markdown), "in notebooks")
    tap.ok("luxel.Document" in repr(document), "what it shows as", repr(document))
    tap.ok(raises(luxel.LuxelError, document.save, tool.file("a.doc")), "an ending that there is not")
    tap.ok(raises(ValueError, again.save, tool.file("a.doc")), "of a pickle, too")
    told = tool.run("explain", "report", "-p", "0,0", "--json").json()["points"][0]["alternatives"]
    tap.equal([(one.convention, one.choice, one.value, one.present, one.assignment) for one in scene.alternatives()],
              [(one["convention"], one["choice"], one["value"], one["present"], one["assignment"]) for one in told],
              "the alternatives")


def test_judge(tap, tool):
    scene = luxel.Scene("report")
    value = scene.probe((0, 0)).value
    tap.equal(scene.judge((0, 0), value).verdict, "right", "the exact value is right")
    tap.equal(scene.judge((0, 0), 7).verdict, "wrong", "another one is not")
    pixel = scene.judge((0, 0), scene.probe((0, 0)).pixel_value, tolerance=1e-6)
    tap.equal((pixel.verdict, [reason.choice for reason in pixel.explanations]), ("convention", ["pixel"]),
              "the pixel's value is explained")
    tap.ok(raises(ValueError, scene.judge, (0, 0), 1, tolerance=-1), "a tolerance below 0")


def without_numbers(svg):
    """An SVG without the numbers of its parts, which cairo counts through a process."""
    return re.sub(rb'(id="|href="#|url\(#)([a-z]+)[0-9]+', rb"\1\2", svg)


def test_figures(tap, tool):
    try:
        palettes = luxel.palettes()
    except ImportError as error:
        tap.skip("figures", error)
        return
    tap.ok("viridis" in palettes and "turbo" in palettes, "palettes")
    scene = luxel.Scene("three-lights")
    for words, look in ((["--title", "Ж"], {"title": "Ж"}),
                        (["--palette", "turbo", "--section=maximum", "--width", "120", "--title", "T"],
                         {"palette": "turbo", "section": "maximum", "width_mm": 120, "title": "T"})):
        figure = scene.figure(**look)
        for ending, made in ((".svg", figure.svg().encode()), (".png", figure.png())):
            tool.run("figure", "three-lights", "-o", "a" + ending, *words)
            tap.ok(without_numbers(made) == without_numbers(tool.read("a" + ending)),
                   "%s with %r has the bytes of the tool" % (ending, look))
    tap.ok(figure.pdf().startswith(b"%PDF"), "a PDF")
    figure.save(tool.file("b.png"))
    tap.ok(tool.read("b.png") == figure.png() == pickle.loads(pickle.dumps(figure)).png(), "saved, and pickled")
    scene["lights[0].intensity"] = 99
    tap.ok(figure.png() == tool.read("b.png"), "a figure shows the scene as it was")
    tap.ok(figure._repr_svg_().startswith("<?xml") and "luxel.Figure" in repr(figure), "in notebooks")
    for wrong in ({"palette": "mud"}, {"bands": "mud"}, {"width_mm": 1}, {"section": "mud"}, {"levels": [1.0] * 51}):
        tap.ok(raises(ValueError, lambda: scene.figure(**wrong).svg()), "%r is refused" % (wrong,))
    report = luxel.Scene("report")
    report.report(tool.file("b.html"), author="A. Student", group="4321")
    tool.run("report", "report", "-o", "a.html", "--author", "A. Student", "--group", "4321")
    tap.ok(tool.read("a.html") == tool.read("b.html"), "a report has the bytes of the tool")
    tap.ok(raises(luxel.LuxelError, report.report, tool.file("a.odt")), "an ending that there is not")
    luxel.set_language("ru")
    try:
        tool.run("figure", "report", "-o", "r.svg", "--title", "T", environment={"LANGUAGE": "ru"})
        made = report.figure(title="T").svg().encode()
        tap.ok(without_numbers(made) == without_numbers(tool.read("r.svg")), "in Russian")
    finally:
        luxel.set_language("en")


TWO_GRIDS = [{"name": "table", "center": [0, 0, 900], "size": [400, 200], "n": [4, 2]},
             {"name": "shelf", "center": [0, 0, 500], "size": [800, 400], "n": [4, 2]}]


def test_grid_figures(tap, tool):
    try:
        luxel.palettes()
    except ImportError as error:
        tap.skip("figures of grids", error)
        return
    scene = luxel.Scene("desk").changed({"grids": TWO_GRIDS})
    scene.save(tool.file("two.yaml"))
    for grid, told in (("table", "table"), ("shelf", "shelf"), (1, "2")):  # the tool counts from 1
        figure = scene.figure(grid=grid, title="T", bands="lines")
        tool.run("figure", "two.yaml", "--grid", told, "-o", "a.svg", "--title", "T", "--lines")
        tap.ok(without_numbers(figure.svg().encode()) == without_numbers(tool.read("a.svg")),
               "of grid %s, with the bytes of the tool" % grid)
    tap.ok(figure.png() == pickle.loads(pickle.dumps(figure)).png(), "pickled")
    tap.ok(scene.figure(grid="shelf").png() != scene.figure(grid="table").png() != scene.figure().png(),
           "each grid has its own, and the picture")
    for wrong in ("floor", 2, -1):
        told = str(raises(ValueError, scene.figure, grid=wrong))
        tap.ok(told.startswith("grid: %r: " % wrong) and "table, shelf" in told, "grids that there are", told)
    told = str(raises(ValueError, luxel.Scene("report").figure, grid=0))
    tap.ok("no measuring grids" in told, "none at all", told)
    for wrong in ({"section": "center"}, {"section": (0, 0)}, {"quantity": "brightness"}):
        tap.ok(raises(ValueError, scene.figure, grid=1, **wrong), "%r of a grid is refused" % wrong)
    tap.ok(scene.figure(grid=1, quantity="irradiance").svg().startswith("<?xml"), "the irradiance is not")


def test_grid_extrema(tap, tool):
    """Between the points of the grid, as the tool tells them and as free elements have them there."""
    scene = luxel.Scene("desk").changed({"grids": TWO_GRIDS})
    scene.save(tool.file("two.yaml"))
    for index, told in enumerate(tool.run("grid", "two.yaml", "--json").json()["grids"]):
        grid = scene.grid(index)
        found = grid.extrema()
        for kind in ("maximum", "minimum"):
            peak, expected = getattr(found, kind), told["extrema"][kind]
            tap.equal((peak.value, peak.error, list(peak.position_mm)),
                      (expected["value"], expected["error"], expected["position"]), "%s of %s" % (kind, grid.name))
            value, error = scene.evaluate(peak.position_mm, grid.axis, quantity="irradiance").tolist()
            tap.near(value, peak.value, error + peak.error + 1e-9 * peak.value, "is that of an element there")
            place = [c + peak.on_plane_mm[0] * x + peak.on_plane_mm[1] * y
                     for c, x, y in zip(grid.center_mm, grid.across, grid.up)]
            tap.ok(numpy.allclose(place, peak.position_mm, rtol=0, atol=1e-9), "on the plane", place, peak)
        tap.ok(found.minimum.value <= grid.minimum.value and found.maximum.value >= grid.maximum.value,
               "none of the cells is beyond")
    scene["lights[0].enabled"] = False
    tap.equal((grid.extrema(), pickle.loads(pickle.dumps(grid)).extrema()), (found, found),
              "those of the scene that was measured")
    long = luxel.Scene("window").changed({"grids": [dict(TWO_GRIDS[1], n=[100, 50])]}).grid()  # for seconds
    cancelled = raises(luxel.LuxelError, long.extrema, progress=lambda done: False)
    tap.equal(cancelled and cancelled.status, "cancelled", "progress that returns False ends the search")
    below = dict(TWO_GRIDS[0], center=[0, 0, 300])
    shining = luxel.Scene("two-spheres").changed({"grids": [below], "reflections": 1})
    grid = shining.grid(reflected_error=0.1)
    found = grid.extrema()
    tap.ok(found.minimum.value <= grid.minimum.value + found.minimum.error and found.maximum.error > 0 and
           found.maximum.value >= grid.maximum.value - found.maximum.error, "with reflected light, too", found)


def test_grid(tap, tool):
    told = tool.run("grid", "desk", "--json").json()["grids"][0]
    scene = luxel.Scene("desk")
    grid = scene.grid("desk")
    tap.equal(scene.grids, ["desk"], "its name")
    tap.equal((grid.average, grid.u0, grid.ud, grid.flux, grid.mean, grid.minimum.value, grid.maximum.value),
              (told["average"], told["u0"], told["ud"], told["flux"], told["mean"], told["minimum"]["value"],
               told["maximum"]["value"]), "what the tool tells")
    tap.equal(grid.values.tolist(), told["values"], "the cells")
    tap.equal(grid.positions_mm[0, 0].tolist(), list(scene.grid(0).positions_mm[0, 0]), "their places")
    tap.ok((grid.errors <= grid.error).all() and grid.mask.all() and not grid.values.flags.writeable, "bounds and mask")
    ball = scene.changed({"surfaces[0]": {"type": "sphere", "center": list(grid.positions_mm[0, 0]), "radius": 1}})
    within = ball.grid("desk")
    tap.equal((within.enclosed, within.inside[0, 0], within.mask[0, 0], within.inside.sum(), within.measured),
              (1, True, False, 1, grid.measured - 1), "a cell inside a body")
    tap.ok(within.blocking_light is None and not grid.inside.any(), "on which no light lies")
    values = scene.evaluate(grid.positions_mm, grid.axis, quantity="irradiance")["value"]
    tap.ok((values == grid.values).all(), "each cell is a free element")
    grid.write(tool.file("b.csv"))
    tool.run("grid", "desk", "-o", "a.csv")
    tap.equal(tool.read("b.csv"), tool.read("a.csv"), "the file has the bytes of the tool")
    tap.ok("<table>" in grid._repr_html_() and "desk" in repr(grid), "a table for notebooks")
    again = pickle.loads(pickle.dumps(grid))
    again.write(tool.file("c.csv"))
    tap.equal((again.values.tolist(), again.flux, tool.read("c.csv")), (grid.values.tolist(), grid.flux,
              tool.read("b.csv")), "a pickle is measured again")
    values = grid.values
    del grid
    tap.equal(values.tolist(), told["values"], "the numbers outlive the grid")
    for error, wrong in ((KeyError, "floor"), (IndexError, 1), (IndexError, -1)):
        told = str(raises(error, scene.grid, wrong))
        tap.ok(repr(wrong) in told and "desk" in told, "a grid that there is not: those that there are", told)
    tap.ok("no measuring grids" in str(raises(KeyError, luxel.Scene("report").grid, "desk")), "none at all")
    tap.ok(raises(AttributeError, lambda: scene.grid().nonsense), "or something it does not have")


def test_tables(tap, tool):
    probes = luxel.Scene(SCENE).probe()
    told = tool.run("probe", tool.write("a.yaml", SCENE), "--json").json()["points"]
    html = probes._repr_html_()
    for probe, point in zip(probes, told):
        tap.ok("%.12g" % probe.value in html and probe.value == point["value"], "the value that the tool tells")
    tap.equal((probes[0]._repr_html_().count("<tr>"), html.count("<tr>")), (2, 4), "a row for each")
    tap.equal((type(probes).__name__, len(probes), probes[1].screen_mm), ("Probes", 3, (150.0, 0.0)),
              "a tuple of probes")
    tap.ok(luxel.Scene(SCENE)._repr_png_() == luxel.Scene(SCENE).render().png(), "a scene shows its picture")
    named = luxel.Scene(SCENE).changed({"lights[0].name": "<lamp> & Ж"})
    tap.equal(named.probe((0, 0)).shares[0].name, "<lamp> & Ж", "a light's name")
    tap.ok(os.path.exists(os.path.join(os.path.dirname(luxel.__file__), "py.typed")), "types are there")


run_tests(Tap(), test_explain, test_judge, test_figures, test_grid_figures, test_grid_extrema, test_grid, test_tables)
