# SPDX-License-Identifier: MIT
"""Fields are those of the tool: the same bytes in every format, statistics, lines, sections and differences."""
import pickle
import time
import warnings

import numpy

from package import Tap, luxel, raises, run_tests
from tool import SCENE

WAYS = [("report", {}, {}), ("three-lights", {"screen.resolution": [50, 40]}, {"precision": "double"}),
        ("two-spheres", {"screen.resolution": [50, 40]}, {"quantity": "irradiance"}),
        ("window", {"screen.resolution": [40, 40]}, {}),
        ("all-sources", {"screen.resolution": [30, 30]}, {"precision": "double", "quantity": "irradiance"})]

ROOM = """luxel: 1
reflections: all
screen: {width: 3000, height: 3000, resolution: [12, 12]}
observer: {z: 9000, projection: perspective}
surfaces: [{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000],
            material: {model: lambert, diffuse: 0.5, over_pi: true}}]
lights: [{type: ambient, irradiance: 1}]
"""


def arguments(changes, settings):
    found = []
    for key, value in changes.items():
        found += ["-s", "%s=%s" % (key, value)]
    for key, value in settings.items():
        found += ["--" + key, value]
    return found


def test_lights(tap, tool):
    """Groups of lights: what they give is what the scene with these lights enabled gives, in a pickle, too."""
    scene = luxel.Scene("three-lights").changed({"screen.resolution": [50, 40]})
    alone = scene.changed({"lights[0].enabled": False, "lights[1].enabled": False})
    field, truth = scene.render(lights="rim"), alone.render()
    tap.ok((numpy.asarray(field) == numpy.asarray(truth)).all(), "by name: the picture")
    tap.ok((numpy.asarray(scene.render(lights=2)) == numpy.asarray(truth)).all(), "by number")
    tap.ok((numpy.asarray(pickle.loads(pickle.dumps(field))) == numpy.asarray(truth)).all(), "a pickle")
    tap.equal(field.extrema().maximum.value, truth.extrema().maximum.value, "extrema of the field are of its lights")
    tap.equal(scene.probe((150, 0), lights=["rim"]).value, alone.probe((150, 0)).value, "a probe")
    places = numpy.array([[0, 0, 1001.0], [100, 0, 1001]])
    tap.equal(list(scene.evaluate(places, [0, 0, 1], lights=2)["value"]),
              list(alone.evaluate(places, [0, 0, 1])["value"]), "elements")
    tap.ok((scene.section(lights="rim").value == alone.section().value).all(), "a section")
    tap.equal(scene.render(lights=[]).statistics.maximum.value, 0.0, "no light: dark")
    tap.ok(raises(KeyError, scene.render, lights="none") and raises(IndexError, scene.render, lights=3),
           "there are no such lights")


def test_files(tap, tool):
    for name, changes, settings in WAYS:
        endings = [".png", ".npy", ".pfm", ".csv", ".exr"]
        tool.run("render", name, *arguments(changes, settings), "-q",
                 *[word for ending in endings for word in ("-o", "a" + ending)])
        scene = luxel.Scene(name).changed(changes)
        field = scene.render(**settings)
        for ending in endings:
            field.write(tool.file("b" + ending))
            tap.ok(tool.read("a" + ending) == tool.read("b" + ending),
                   "%s%s has the bytes of the tool" % (name, ending))
        tap.ok(field._repr_png_() == tool.read("a.png"), name + ": so has what a notebook shows")
        tap.ok((numpy.load(tool.file("a.npy")) == numpy.asarray(field)).all(), name + ": the array is that of the file")
        statistics = scene.render_files(tool.file("c.png"), tool.file("c.npy"), **settings)
        tap.ok(tool.read("c.png") == tool.read("a.png") and statistics == field.statistics, name + ": row by row")
        tap.ok(pickle.loads(pickle.dumps(field)).png() == tool.read("a.png"), name + ": a pickle renders it anew")
        for extension in (".npy", ".csv", ".png"):
            field.write(tool.file("b" + extension))
            tap.ok(field.to_bytes(extension) == tool.read("b" + extension), "%s: to_bytes(%r)" % (name, extension))
        tap.ok(raises(ValueError, field.to_bytes, ".bmp"), name + ": to_bytes() of no format")
    tool.run("render", "report", "-q", "--bits", "16", "-o", "d.png")
    tap.ok(luxel.Scene().render().png(16) == tool.read("d.png"), "16 bits")
    for threads in (1, 3):
        tap.ok((numpy.asarray(luxel.Scene().render(threads=threads)) == numpy.asarray(luxel.Scene().render())).all(),
               "%d threads" % threads)
    tap.ok(raises(luxel.LuxelError, field.write, tool.file("a.jpg")), "an ending that there is not")
    tap.ok(raises(luxel.LuxelError, field.write, tool.file("no/a.png")), "a folder that there is not")


def test_read(tap, tool):
    field = luxel.Scene(SCENE).render()
    for ending in (".npy", ".pfm", ".csv", ".exr"):
        field.write(tool.file("a" + ending))
        again = luxel.read(tool.file("a" + ending))
        tap.ok(ending == ".csv" or (numpy.asarray(again) == numpy.asarray(field)).all(), ending + " is read back")
        tap.equal(again.scene is not None, ending == ".exr", ending + ": whether it knows its scene")
        tap.ok(numpy.isnan(again.error), ending + ": no bound is known of what was read")
        tap.equal(content_of(pickle.loads(pickle.dumps(again))), content_of(again), ending + ": a pickle is as it is")
    tap.ok(raises(ValueError, again.extrema), "what was read has no exact function")
    tap.ok(again.isophotes(3, exact=False), "but lines as the picture has them")
    tap.ok(raises(luxel.LuxelError, luxel.read, tool.file("nothing.npy")), "a file that there is not")


def content_of(field):
    """All that a field tells of itself, to compare."""
    places = [None if place is None else place.tolist() for place in (field.x_mm, field.y_mm)]
    return (field.shape, field.precision, field.quantity, field.quantity_word, field.unit, field.scene_text, places,
            bytes(field), field.mask.tobytes(), str(field.statistics))


def test_of(tap, tool):
    """Values of one's own: fields as those that are rendered or read."""
    field = luxel.Scene("report").changed({"screen.resolution": [40, 40]}).render()
    copy = luxel.Field.of(field.values, mask=field.mask, x_mm=field.x_mm, y_mm=field.y_mm, unit=field.unit,
                          quantity=field.quantity)
    told = (content_of(copy)[:5], content_of(copy)[6:])
    tap.equal(told, (content_of(field)[:5], content_of(field)[6:]), "a field of a field's values")
    compared = luxel.compare(field, copy)
    tap.equal((compared.pixels, compared.largest.value, compared.only_a), (int(field.mask.sum()), 0, 0), "is equal")
    again = pickle.loads(pickle.dumps(copy))
    tap.equal(content_of(again), content_of(copy), "and can be pickled")
    tap.equal(content_of(pickle.loads(pickle.dumps(compared)).difference), content_of(compared.difference),
              "so can a difference")
    image = numpy.linspace(0, 5, 12).reshape(4, 3)[::-1, ::2]
    bare = luxel.Field.of(image)
    tap.equal((bare.precision, bare.quantity_word, bare.unit, bare.x_mm), ("double", "values", "", None),
              "values alone")
    tap.ok((numpy.asarray(bare) == image).all() and (bare.mask == (image != 0)).all(), "of any strides")
    tap.equal(content_of(pickle.loads(pickle.dumps(bare))), content_of(bare), "can be pickled")
    bare.write(tool.file("a.npy"))
    tap.ok((numpy.load(tool.file("a.npy")) == image).all(), "and written")
    tap.equal(luxel.Field.of([[1, 2], [3, 0]]).statistics.pixels, 3, "lists of whole numbers")
    for wrong in (lambda: luxel.Field.of([1, 2]), lambda: luxel.Field.of(numpy.zeros((0, 4))),
                  lambda: luxel.Field.of(image, mask=[[True]]), lambda: luxel.Field.of(image, quantity="colour")):
        tap.ok(raises(ValueError, wrong), "wrong shapes and words are refused")
    error = raises(luxel.LuxelError, luxel.Field.of, image, x_mm=[1, 0], y_mm=[3, 2, 1, 0])
    tap.ok("the setting x_mm is 0; it must be finite and above the one before" in str(error), "places that go back",
           str(error))
    tap.ok(raises(luxel.LuxelError, luxel.Field.of, image, x_mm=[0, 1]), "or are told for one axis alone")


def test_statistics(tap, tool):
    told = tool.run("stats", "report", "--json").json()
    field = luxel.Scene("report").render()
    statistics, summary = field.statistics, field.summary()
    tap.equal((summary.mean, summary.median, summary.standard_deviation, summary.maximum.value),
              (told["mean"], told["median"], told["standard_deviation"], told["max"]["value"]), "the summary")
    tap.equal(statistics.pixels, summary.pixels, "statistics agree with it")
    values, mask = numpy.asarray(field, dtype=float), field.mask
    tap.equal((values.max(), int(mask.sum())), (statistics.maximum.value, statistics.pixels), "and with NumPy")
    tap.near(statistics.mean, values[mask].mean(), 1e-12, "the mean too")
    part = field.summary((0, 0, 100))
    inside = mask & (field.x_mm[None, :] ** 2 + field.y_mm[:, None] ** 2 <= 100 ** 2)
    tap.equal(part.pixels, int(inside.sum()), "a circle's pixels")
    tap.near(part.mean, values[inside].mean(), 1e-12, "and their mean")
    tap.equal(field.summary((0, 0, 500, 500)).pixels, summary.pixels, "a rectangle")
    tap.ok(raises(ValueError, field.summary, (0, 0, -1)), "a region of no size")
    histogram = field.histogram(20)
    counts, edges = numpy.histogram(values[mask], 20)
    tap.ok((histogram.counts == counts).all() and numpy.allclose(histogram.edges, edges, rtol=1e-12), "the histogram")
    room = luxel.Scene.from_text(ROOM)
    reflected = room.render(quantity="irradiance", reflected_error=0.01)
    bound = reflected.statistics.reflected_error
    tap.ok(0 < bound <= 0.01 and abs(numpy.asarray(reflected) - 2).max() <= bound * reflected.statistics.maximum.value,
           "a closed room of reflectance 0.5 in uniform light has twice its irradiance")
    tap.ok(luxel.Scene("report").render().statistics.reflected_error is None, "without reflections there is no bound")
    reached = luxel.Scene("report").render(minimum_reached=True).statistics.minimum_reached
    tap.equal(reached.value, tool.run("render", "report", "--json").json()["min_reached"]["value"],
              "where light arrives")
    tap.ok("<table>" in statistics._repr_html_(), "a table for notebooks")
    tap.near(field.error, 2e-6 * statistics.maximum.value, 0, "the bound of the values")
    exact = luxel.Scene("report").render(precision="double")
    tap.ok(numpy.abs(values - numpy.asarray(exact)).max() <= field.error + exact.error, "which holds")


def test_missed_bound(tap, tool):
    room = luxel.Scene.from_text(ROOM.replace("reflections: all", "reflections: 1"))
    ball = room.changed({"surfaces[0]": {"type": "sphere", "center": [0, 0, 0], "radius": 900, "inside": True,
                                         "material": {"model": "lambert", "diffuse": 0.5, "over_pi": True}}})
    ways = {"quantity": "irradiance", "reflected_error": 1e-14}
    for name, make in (("a picture", lambda: ball.render(**ways)),
                       ("files", lambda: ball.render_files(tool.file("missed.npy"), **ways))):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            make()
        tap.equal([(one.category, one.filename) for one in told], [(luxel.LuxelWarning, __file__)],
                  name + " that misses its bound is made, with one warning where it was asked for")
        tap.ok("maximum" in str(told[0].message), "which tells the bound", str(told[0].message))
    with warnings.catch_warnings():
        warnings.simplefilter("error", luxel.LuxelWarning)
        tap.ok(raises(luxel.LuxelWarning, ball.render, **ways), "which may be made an error")
        ball.render(quantity="irradiance", reflected_error=0.02)
    choices = room.alternatives((0, 0), quantity="irradiance")
    tap.ok(all(abs(one.value - {"none": 1, "1": 1.5, "all": 2}[one.choice]) <= one.error for one in choices),
           "alternatives have bounds", choices)


def test_extrema(tap, tool):
    told = tool.run("stats", "report", "--json").json()
    extrema = luxel.Scene("report").render().extrema()
    for name, peak in (("maximum", extrema.maximum), ("minimum", extrema.minimum)):
        tap.equal((peak.value, peak.error, peak.x_mm, peak.y_mm), tuple(
            [told[name]["value"], told[name]["error"]] + told[name]["screen"]), "the true " + name)
    tap.equal(luxel.Scene("report").render().extrema((0, 0, 10)).maximum.place, "border", "in a region")


def test_lines(tap, tool):
    told = tool.run("isophotes", "report", "--json").json()
    field = luxel.Scene("report").render()
    lines = field.isophotes()
    tap.equal([(line.level, line.closed, numpy.stack([line.x_mm, line.y_mm], 1).tolist()) for line in lines],
              [(line["level"], line["closed"], line["vertices"]) for line in told["lines"]], "the tool's lines")
    for line in lines:
        values = luxel.Scene("report").probe(numpy.stack([line.x_mm, line.y_mm], 1)[1:-1:7]).value
        tap.ok(numpy.abs(values - line.level).max() <= 1e-8 * line.level, "lie on their level %g" % line.level)
    rough = tool.run("isophotes", "report", "--levels", "5,10", "--picture", "--json").json()
    tap.equal([line.x_mm.tolist() for line in field.isophotes([5, 10], exact=False)],
              [[x for x, _ in line["vertices"]] for line in rough["lines"]], "those of the picture")
    tap.ok(raises(ValueError, field.isophotes, [float("nan")]), "a level that is no number")
    tap.ok(raises(ValueError, field.isophotes, [1.0] * 1001), "too many levels")


def test_profiles(tap, tool):
    told = tool.run("profile", "three-lights", "--through", "0,50", "--angle", "30", "--json").json()
    scene = luxel.Scene("three-lights")
    found = scene.section((0, 50), 30)
    values = [value if has else None for value, has in zip(found.value.tolist(), found.has_value.tolist())]
    tap.equal(values, [sample["value"] for sample in told["samples"]], "a section")
    tap.equal((found.abscissa.tolist(), found.x_mm.tolist()),
              ([sample["distance"] for sample in told["samples"]], [sample["screen"][0] for sample in told["samples"]]),
              "and its places")
    tap.ok(numpy.allclose(found.shares.sum(1), found.value, rtol=1e-13), "the lights' shares add up")
    arc = scene.profile((-100, 0), (100, 20), 11, arc=True)
    tap.equal((len(arc.value), arc.abscissa[0]), (11, 0.0), "along a great circle")
    field = scene.render()
    pixels = field.profile((-100, 0), (100, 0), 5)
    tap.equal((pixels.shares, set(pixels.value.tolist()) <= set(numpy.asarray(field, dtype=float).ravel().tolist())),
              (None, True), "of a picture")
    tap.ok(raises(ValueError, scene.profile, (0, 0), (0, 0)), "a line of no length")
    tap.ok(raises(ValueError, scene.section, (1e4, 0), 90), "a line off the screen")


def test_compare(tap, tool):
    tool.run("render", "report", "-q", "-o", "a.npy")
    told = tool.run("compare", "report", "report", "-s", "lights[0].intensity=12", "--json").json()
    a = luxel.Scene("report").render()
    b = luxel.Scene("report").changed({"lights[0].intensity": 12}).render()
    found = luxel.compare(a, b)
    difference = numpy.asarray(b, dtype=float) - numpy.asarray(a, dtype=float)
    tap.near(found.largest.value, numpy.abs(difference).max(), 1e-15, "the largest difference")
    tap.near(found.rms, numpy.sqrt((difference[a.mask] ** 2).mean()), 1e-12, "the root mean square")
    tap.ok(numpy.allclose(numpy.asarray(found.difference), difference, atol=2e-6), "the picture of it")
    tap.ok(told, "the tool compares, too")
    tap.ok(raises(ValueError, luxel.compare, a, luxel.Scene(SCENE).render()), "pictures of different sizes")


def test_array_like(tap, tool):
    """A field counts as its array: indices, arithmetic, comparisons, reductions, bytes, other libraries."""
    field, other = luxel.Scene(SCENE).render(precision="double"), luxel.Scene("report").render()
    values = field.values
    tap.ok(len(field) == 36 and field[18, 20] == values[18, 20] and (field[3:5, ::2] == values[3:5, ::2]).all() and
           field[field > 0].shape == values[values > 0].shape, "indices")
    for name, found, expected in (
            ("+", field + 1, values + 1), ("r+", 1 + field, values + 1), ("-", field - field, values * 0),
            ("r-", 1 - field, 1 - values), ("*", 2 * field, 2 * values), ("/", field / 3, values / 3),
            ("r/", 3 / (field + 1), 3 / (values + 1)), ("**", field ** 2, values ** 2), ("-x", -field, -values),
            ("abs", abs(-1 * field), values), ("<", field < 1, values < 1), (">=", field >= 1, values >= 1),
            ("<=", field <= field, values <= values), ("array -", values - field, values * 0),
            ("other type", other * 2, numpy.asarray(other) * 2)):
        tap.ok(isinstance(found, numpy.ndarray) and found.dtype == expected.dtype and (found == expected).all(), name)
    tap.equal([float(number) for number in (field.max(), field.min(), field.mean(), numpy.max(field), numpy.mean(field),
                                            numpy.sum(field))],
              [float(number) for number in (values.max(), values.min(), values.mean(), values.max(), values.mean(),
                                            values.sum())], "reductions")
    tap.ok((field.max(axis=0) == values.max(axis=0)).all(), "along an axis")
    tap.ok(bytes(field) == memoryview(field).tobytes() == values.tobytes(), "bytes")
    taken = numpy.from_dlpack(field)
    tap.ok((taken == values).all() and taken.base is not values and not numpy.shares_memory(taken, values), "DLPack")
    tap.equal((field.__dlpack_device__(), bool(raises(BufferError, field.__dlpack__, copy=False))), ((1, 0), True),
              "DLPack hands over copies alone")
    tap.ok(field == field and field != other and len({field, other}) == 2, "== stays that of objects")


def test_precision(tap, tool):
    """Finite differences of the size that SciPy takes: float32 sees none, "double" the derivative."""
    step = 1.5e-8
    slopes = {}
    for precision in "single", "double":
        one, two = [luxel.Scene(SCENE).changed({"lights[0].position": [2000 * (1 + change), 0, 2000]})
                    .render(precision=precision) for change in (0, step)]
        slopes[precision] = (numpy.asarray(two, "f8") - numpy.asarray(one, "f8"))[18, 22] / step
    one, two = [luxel.Scene(SCENE).changed({"lights[0].position": [2000 * (1 + change), 0, 2000]})
                .render(precision="double")[18, 22] for change in (-1e-4, 1e-4)]
    tap.ok(slopes["single"] == 0 and abs(slopes["double"] / ((two - one) / 2e-4) - 1) < 1e-5 and
           '"double" is needed' in luxel.Scene.render.__doc__.replace("\n", " "), "differences of pictures", slopes)


def test_xarray(tap, tool):
    field = luxel.Scene(SCENE).render()
    try:
        array = field.to_xarray()
    except ImportError as error:
        tap.skip("xarray", error)
        return
    tap.equal((array.dims, array.attrs["units"], array.attrs["convention_sampling"]),
              (("y_mm", "x_mm"), "W/sr", "nodes"), "what xarray knows")
    tap.ok((numpy.isnan(array.values) == ~field.mask).all(), "off the surface it is NaN")
    tap.equal(float(array.sel(x_mm=30, y_mm=-50, method="nearest")),
              float(numpy.asarray(field)[numpy.abs(field.y_mm + 50).argmin(), numpy.abs(field.x_mm - 30).argmin()]),
              "by places")


def test_tables(tap, tool):
    """Notebooks show what is read off pictures as tables, in the user's language."""
    scene = luxel.Scene(SCENE)
    field = scene.render()
    section, extrema = scene.section(samples=101), field.extrema()
    page = section._repr_html_()
    tap.equal(page.count("<tr>"), 22, "a section has a heading and 21 of its samples")
    for i in (0, 50, 100):
        tap.ok(">%.7g<" % section.x_mm[i] in page, "sample %d is one of them" % i, page)
    tap.ok("%.12g" % section.value[50] in page and "—" in page, "its values, and where there is none", page)
    tap.equal(scene.section(samples=2)._repr_html_().count("<tr>"), 3, "a section of two samples")
    tap.ok("%.12g" % extrema.maximum.value in extrema._repr_html_(), "extrema", extrema._repr_html_())
    tap.equal(luxel.Extrema(None, None)._repr_html_().count("<tr>"), 1, "no extrema")
    tap.ok("%.9g" % field.summary().median in field.summary()._repr_html_(), "a summary")
    luxel.set_language("ru")
    try:
        tap.ok("x (мм)" in section._repr_html_(), "in Russian")
    finally:
        luxel.set_language("en")


def test_text(tap, tool):
    """A picture's scene is that of its rendering, though its text is written when somebody first asks for it: that
    takes several times as long as a small picture.  Times are told, not tested: others use this machine, too."""
    scene = luxel.Scene(SCENE).changed({"screen.resolution": [1, 1]})
    for name, call in (("a text", lambda: scene.text), ("a picture of one pixel", scene.render)):
        start = time.perf_counter()
        for _ in range(100):
            call()
        tap.note("%s takes %.1f microseconds" % (name, (time.perf_counter() - start) * 1e4))
    field = scene.render()
    expected = scene.text
    scene["lights[0].intensity"] = 7
    tap.equal(field.scene_text, expected, "the text is that of the scene as it was rendered")


run_tests(Tap(), test_array_like, test_precision, test_text, test_lights, test_tables, test_files, test_read, test_of,
          test_statistics, test_missed_bound, test_extrema, test_lines, test_profiles, test_compare, test_xarray)
