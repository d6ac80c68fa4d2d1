# SPDX-License-Identifier: MIT
"""Places to probe on the command line: free elements and what is said of them, tables of places, tables of values, and
conventions that had a say."""
import csv
import io
import json
import struct

from tap import Tap
from tool import run_tests

TWO = ("surfaces=[{type: sphere, name: dull, center: [-300,0,1000], radius: 100, material: {diffuse: 0.1}},"
       "{type: rectangle, name: white, center: [300,0,1000], size: [200,200], material: {diffuse: 0.9, specular: 0}}]")
SUN = "lights=[{type: distant, direction: [0,0,-1], irradiance: 1}]"
PLACE = "150,0,1259.8076211353316,0.5,0,0.8660254037844387"


def lights(tap, tool):
    """What some lights alone give is what the scene gives with these enabled and all others not."""
    alone = ["-s", "lights[0].enabled=false", "-s", "lights[1].enabled=false"]
    files = ["-q", "-s", "screen.resolution=[60,48]"]
    tool.run("render", "three-lights", *files, "--lights", "rim", "-o", "a.png", "-o", "a.exr")
    tool.run("render", "three-lights", *files, *alone, "-o", "b.png", "-o", "b.exr")
    for name in ("a.png", "a.exr"):
        points = [tool.run("probe", picture, "-p", "150,0", "--json").json()["points"][0]
                  for picture in (name, "b" + name[1:])]
        tap.ok(points[0] == points[1] and [light["index"] for light in points[0]["lights"]] == [2],
               name + " carries the scene of this light alone", points[0])
    for command in (["probe"], ["stats"], ["profile", "--csv"], ["isophotes", "--csv"], ["explain", "-p", "150,0"]):
        chosen = tool.run(*command, "three-lights", "--lights", "2").out.partition("Conventions: ")[0]
        tap.equal(chosen, tool.run(*command, "three-lights", *alone).out.partition("Conventions: ")[0],
                  " ".join(command) + ": the third one alone")
    whole = tool.run("probe", "three-lights", "-p", "150,0", "--json").json()["points"][0]["value"]
    parts = [tool.run("probe", "three-lights", "-p", "150,0", "--lights", words, "--json").json()["points"][0]["value"]
             for words in ("key,2", "1")]
    tap.near(sum(parts), whole, 1e-12, "names and numbers; groups add up")
    wrong = tool.run("probe", "three-lights", "--lights", "0,rimm,7").err
    tap.ok('no light "rimm"; it has 3' in wrong and 'no light "7"' in wrong and "mean rim?" in wrong, "no such lights",
           wrong)
    tool.run("render", "-q", "-o", "v.npy")
    values = tool.run("stats", "v.npy", "--lights", "0").err
    tap.ok("v.npy holds values and no scene whose lights --lights could choose" in values, "values have none", values)


def said(tap, tool):
    """What is printed of an element is what counted."""
    both = tool.run("probe", "-p", "150,0", "--at", PLACE, "--json").json()
    for point in both["points"]:
        tap.near(point["value"], 11.0380150393, 1e-11, "the same place, the same value")
    element = both["points"][1]
    tap.equal((element["view"], element["material"], element["inside"]),
              ([0, 0, 1], {"surface": 0, "name": None, "lies_on_it": True}, None), "what counted")
    turned = tool.run("probe", "--at", PLACE, "--view", "3,0,4", "--json").json()
    tap.equal((turned["points"][0]["view"], turned["conventions"]["view"]), ([0.6, 0, 0.8], "[3, 0, 4]"), "--view")
    tap.ok("sampling" not in turned["conventions"] and "projection" not in turned["conventions"], "nothing else",
           turned["conventions"])
    text = tool.run("probe", "--at", PLACE, "--view", "3,0,4").out
    tap.ok("view (0.6, 0, 0.8)" in text and "lies on surfaces[0]" in text, "in text", text)
    observer = tool.run("probe", "--at", PLACE, "-s", "observer.view=observer", "--json").json()
    tap.near(observer["points"][0]["value"], 9.52637827714, 1e-11, "the scene's view")

    places = ["--at", "300,0,1000,0,0,1", "--at", "0,0,1400,0,0,1"]
    found = tool.run("probe", "-s", TWO, "-s", SUN, *places, "--json").json()
    tap.equal([point["material"] for point in found["points"]],
              [{"surface": 1, "name": "white", "lies_on_it": True},
               {"surface": 0, "name": "dull", "lies_on_it": False}],
              "whose material")
    named = tool.run("probe", "-s", TWO, "-s", SUN, "--at", "0,0,1400,0,0,1", "--material", "1", "--json").json()
    tap.near(named["points"][0]["value"], 0.9, 1e-12, "--material")
    inside = tool.run("probe", "--at", "0,0,1000,0,0,1", "--json").json()["points"][0]
    tap.equal((inside["inside"], inside["value"]), (0, 0), "inside a body")
    irradiance = tool.run("probe", "-p", "0,0", "--quantity", "irradiance", "--json").json()["conventions"]
    tap.ok("model" not in irradiance and "view" not in irradiance and "sampling" in irradiance, "no material",
           irradiance)


def tables(tap, tool):
    """Places from tables, values into tables."""
    tool.write("places.csv", "x_mm;y_mm;z_mm;nx;ny;nz\n150;0;1259,8076211353316;0,5;0;0,8660254037844387\n0;0;;;;\n")
    tool.write("plain.pts", "0 0 1300 0 0 1\n0 0 0 0 0 2\n")
    given = ["--at", PLACE, "-p", "0,0", "--at", "0,0,1300,0,0,1", "--at", "0,0,0,0,0,2"]
    by_hand = tool.run("probe", "--json", *given).json()
    result = tool.run("probe", "--points", "places.csv", "--points", "plain.pts", "--json", "-o", "values.csv", "-o",
                      "values.npy", "-o", "values.json")
    tap.equal((result.code, result.err, result.json()), (0, "", by_hand), "as by hand")
    tap.equal(json.loads(tool.read("values.json")), by_hand, ".json is what --json prints")
    rows = list(csv.DictReader(io.StringIO(tool.read("values.csv").decode("utf-8"))))
    values = [point["value"] for point in by_hand["points"]]
    tap.equal([float(row["value_W/sr"]) for row in rows], values, ".csv has the values")
    bytes_of = tool.read("values.npy")
    size = struct.unpack("<H", bytes_of[8:10])[0]
    tap.ok(b"'<f8'" in bytes_of[:size] and b"(4,)" in bytes_of[:size] and (10 + size) % 64 == 0, ".npy", bytes_of[:80])
    tap.equal(list(struct.unpack("<4d", bytes_of[10 + size:])), values, "with the values")
    tool.write("values2.csv", tool.read("values.csv").decode("utf-8"))
    again = tool.run("probe", "--points", "values2.csv", "--json").json()["points"]
    tap.ok(all(abs(a["value"] - b) <= 1e-12 * b for a, b in zip(again, values)), "a table of values is one of places",
           again)


def npy(rows, descr="<f8", columns_first=False):
    """An array as numpy.save() writes it."""
    columns = len(rows[0])
    shape = (len(rows), columns)
    text = ("{'descr': '%s', 'fortran_order': %s, 'shape': %s, }" % (descr, columns_first, shape)).encode()
    numbers = zip(*rows) if columns_first else rows
    kind = {"f8": "d", "f4": "f", "i4": "i", "i2": "h"}[descr[1:]]
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text
            + b"".join(struct.pack(descr[0] + len(line) * kind, *line) for line in numbers))


def arrays(tap, tool):
    """Arrays are read as tables without headings."""
    screen, elements = [(0, 0), (150, 0), (-150, 40)], [tuple(map(float, PLACE.split(","))), (0, 0, 1300, 0, 0, 2)]

    def found(name, content):
        tool.write(name, content)
        return tool.run("probe", "--points", name, "--json").json()

    for rows in screen, elements:
        expected = found("rows.csv", "".join(",".join(map(repr, row)) + "\n" for row in rows))
        for descr in ["<f8", ">f8"] + ([] if rows is elements else ["<i4", ">i2", "<f4"]):
            for columns_first in False, True:
                tap.equal(found("rows.npy", npy(rows, descr, columns_first)), expected,
                          "%d columns of %s%s" % (len(rows[0]), descr, ", columns first" if columns_first else ""))
    nan, good = float("nan"), npy(screen)
    for title, content, words in (
            ("three columns", npy([(1, 2, 3)]), ["(1, 3)", "(N, 2)", "(N, 6)", "x, y, z, nx, ny, nz"]),
            ("one dimension", good.replace(b"(3, 2)", b"(6,)  "), ["(6,)", "(N, 2)"]),
            ("complex numbers", good.replace(b"<f8", b"<c8"), ["<c8", "<f8"]),
            ("cut off", good[:-1], ["length", "3 rows"]), ("a header alone", good[:40], ["NPY", "header"]),
            ("not finite", npy([(1, 2), (nan, 0), (0, nan)]), ["row 2", "row 3", "finite"]),
            ("no normal", npy([(0, 0, 0, 0, 0, 1), (0, 0, 0, 0, 0, 0)]), ["rows.npy:2:1", "zero"]),
            ("no rows", good.replace(b"(3, 2)", b"(0, 2)")[:-48], ["no places"])):
        tool.write("rows.npy", content)
        result = tool.run("probe", "--points", "rows.npy", "-o", "none.csv")
        tap.ok(result.code == 4 and result.out == "" and "rows.npy" in result.err
               and all(word in result.err for word in words) and "none.csv" not in tool.files(), title, result)


def passed_over(tap, tool):
    """Columns that are not used are told with their place, unless -q was given; numbers of rows are not."""
    for text, place in (("index;x;y;Group;Room\n0;0;0;1;7\n", "1:11"), ("\n\nx,y,Group,Room\n0,0,1,7\n", "3:5"),
                        ("# x y Group Room\n0 0 1 7\n", "1"), ("# a\n# x y Group Room\n0 0 1 7\n", "2")):
        tool.write("spare.csv", text)
        result = tool.run("probe", "--points", "spare.csv")
        tap.ok(result.code == 0 and 'spare.csv:%s: advice: columns that are not used: "Group", "Room"\n' % place in
               result.err and "x, y, z, nx/normal_x/n_x" in result.err, repr(text), result)
        tap.equal(tool.run("probe", "--points", "spare.csv", "-q").err, "", "-q")
    tool.write("plain.csv", "id,x,y\n0,0,0\n")
    tap.equal(tool.run("probe", "--points", "plain.csv").err, "", "numbers of rows")


def refused(tap, tool):
    for text, words in (("1 2 3\n", ""), ("1 2 3 0 0 0\n", "zero"), ("1 2\n1 x\n", "x"), ("", "")):
        tool.write("wrong.pts", text)
        result = tool.run("probe", "--points", "wrong.pts", "-o", "none.csv")
        tap.ok(result.code == 4 and result.out == "" and words in result.err and "wrong.pts" in result.err, repr(text),
               result)
    tap.ok("none.csv" not in tool.files(), "nothing is written", tool.files())
    tap.equal(tool.run("probe", "--points", "missing.csv").code, 4, "a table that is not there")


def many(tap, tool):
    """A hundred thousand places, bounded text, the same bytes for any number of threads."""
    lines = ["%g,%g" % (i % 500 - 250, (i // 500) * 2.5 - 250) for i in range(100000)]
    tool.write("many.csv", "x,y\n" + "\n".join(lines) + "\n")
    text = tool.run("probe", "--points", "many.csv", "-o", "one.npy", "--threads", "1")
    tap.ok(text.code == 0 and len(text.out.splitlines()) < 1100 and "100000" in text.out, "bounded text",
           text.out[-300:])
    quiet = tool.run("probe", "--points", "many.csv", "-q", "-o", "three.npy", "--threads", "3")
    tap.equal((quiet.code, quiet.out, quiet.err), (0, "", ""), "-q and -o: the file alone")
    tap.ok(tool.read("one.npy") == tool.read("three.npy"), "the same bytes")


def grid_flux(tap, tool):
    """A lamp near to a coarse grid: the plane's own flux, and a warning."""
    desk = ["grid", "-s", "units=photometric", "-s", "lights=[{type: point, position: [0,0,20], intensity: 100}]",
            "-s", "surfaces=[{type: sphere, center: [9e4,0,0], radius: 1}]",
            "-s", "grids=[{center: [0,0,0], size: [1000,1000], n: [10,10]}]"]
    result = tool.run(*desk, "--json")
    grid, = result.json()["grids"]
    tap.near(grid["flux"], 605.706183, 1e-9, "flux")
    tap.near(grid["mean"], 605.706183, 1e-9, "mean of the plane")
    tap.near(grid["average"], 281.885, 1e-5, "average of the values")
    tap.near(grid["sampling_error"], 605.706183 - 281.8847, 1e-5, "how far they are apart")
    tap.ok(grid["coarse"] and "coarse" in result.err, "a warning", result.err)
    text = tool.run(*desk).out
    tap.ok("605.706183" in text and "of the values" in text, "in text", text)
    tap.equal(list(result.json()["conventions"]), ["units", "shadows", "attenuation", "pattern"], "conventions")


run_tests(Tap(), lights, said, tables, arrays, passed_over, refused, many, grid_flux)
