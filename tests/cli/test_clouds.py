# SPDX-License-Identifier: MIT
"""Clouds of point sources: where their files are looked for, what is wrong with them and where, and a large one."""
import os
import resource
import struct

from tap import Tap
from tool import SCENE, run_tests

LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
ROWS = [(2000, 0, 2000, 10), (-300.5, 200, 1800, 2.5), (0, 0, 1500, 0.125)]
MILLION = 1000000
LARGEST_BYTES = 400 << 20


def scene(file, keys="attenuation: none"):
    return SCENE.replace(LIGHT, "{type: points, file: %s, %s}" % (file, keys))


def csv(rows):
    return "".join(",".join(map(str, row)) + "\n" for row in rows)


def npy(rows, descr="<f8", shape=None):
    columns = len(rows[0]) if rows else 4
    text = ("{'descr': '%s', 'fortran_order': False, 'shape': %s, }" % (descr, shape or (len(rows), columns))).encode()
    order, kind = (">" if descr[0] == ">" else "<"), ("f" if descr.endswith("4") else "d")
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text
            + b"".join(struct.pack(order + columns * kind, *row) for row in rows))


def where_they_are(tap, tool):
    os.mkdir(tool.file("lamps"))
    tool.write("lamps/cloud.csv", csv(ROWS))
    tool.write("lamps/scene.yaml", scene("cloud.csv"))
    tap.equal(tool.run("check", "lamps/scene.yaml").code, 0, "beside the scene")
    tap.equal(tool.run("check", "-", stdin=scene("lamps/cloud.csv")).code, 0, "standard input: from the current folder")
    result = tool.run("check", "-", stdin=scene("cloud.csv"))
    tap.ok(result.code == 4 and "<stdin>:11:26: error: cannot read cloud.csv: " in result.err, "nothing there", result)
    tap.equal(tool.run("check", "-s", "lights=[{type: points, file: lamps/cloud.csv}]").code, 0, "a built-in scene")
    os.mkdir(tool.file("a.csv"))
    result = tool.run("check", "-", stdin=scene("a.csv"))
    tap.ok(result.code == 4 and "a.csv" in result.err, "a folder", result)
    for device in "/dev/zero", "/dev/urandom", "/dev/null":
        result = tool.run("check", "-", stdin=scene(device))
        tap.ok(result.code == 4 and "cannot read %s: Is a device" % device in result.err, device, result)


def comma(rows, separator=";"):
    return csv(rows).replace(",", separator).replace(".", ",")


def dialects():
    """Files of the same rows as spreadsheets, pandas, R, numpy and instruments write them."""
    heading, quoted = "x,y,z,intensity\n", '"x","y","z","intensity"\n'
    numbered = "".join("%d,%s\n" % (i, line) for i, line in enumerate(csv(ROWS).split()))
    turned = "".join("%s;%s;%s;%s\n" % (i, z / 1000, x / 1000, y / 10) for x, y, z, i in ROWS)
    return {"excel-ru.csv": b"\xef\xbb\xbf" + comma(ROWS).replace("\n", "\r\n").encode(),
            "tabs.csv": comma(ROWS, "\t"), "blanks.csv": csv(ROWS).replace(",", ", "), "wide.csv": comma(ROWS, "   "),
            "quoted.csv": quoted + csv(ROWS), "all-quoted.csv": quoted + "".join(
                '"%s"\n' % line.replace(",", '","') for line in csv(ROWS).split()),
            "sep.csv": "sep=;\r\n" + csv(ROWS).replace(",", ";"), "old-mac.csv": csv(ROWS).replace("\n", "\r"),
            "pandas.csv": "," + heading + numbered, "r.csv": quoted.replace(",", " ") + numbered.replace(",", " "),
            "trailing.csv": csv(ROWS).replace("\n", ",\n"), "numpy.csv": "# " + heading + csv(ROWS),
            "units.csv": "I (W/sr);Z [m];X, m;y_cm\n" + turned,
            "utf-16.csv": (heading + csv(ROWS)).encode("utf-16"), "utf-16-be.csv": b"\xfe\xff" + csv(ROWS).encode(
                "utf-16-be"),
            "cp1251.csv": "Х;У;Z;Сила света\n".encode("cp1251") + comma(ROWS).encode(),
            "spare.csv": "name,x,y,z,note,intensity\n" + "".join('"a, b",%s,%s,%s,dim,%s\n' % row for row in ROWS)}


def lamps_alone(tap, tool):
    """Files that tell places only: one intensity for all of them."""
    tool.write("dome.lp", "3\n" + "".join("photo-%d.jpg %s %s %s\n" % (i, *row[:3]) for i, row in enumerate(ROWS)))
    tool.write("places.csv", "".join("%s,%s,%s\n" % row[:3] for row in ROWS))
    tool.write("same.csv", csv([row[:3] + (2.5,) for row in ROWS]))
    tool.write("ones.csv", csv([row[:3] + (1,) for row in ROWS]))

    def value(file, *more):
        tool.write("scene.yaml", scene(file))
        return tool.run("probe", "scene.yaml", "--json", *more).json()["points"][0]["value"]

    tap.equal(value("dome.lp"), value("ones.csv"), "an .lp file gives no intensities: each lamp has 1")
    tap.equal(value("dome.lp", "-s", "lights[0].intensity=2.5"), value("same.csv"), "the key gives another one")
    tap.equal(value("places.csv", "-s", "lights[0].intensity=2.5"), value("same.csv"), "three columns and the key")
    for name, descr in ("places.npy", "<f8"), ("single.npy", "<f4"), ("big.npy", ">f8"):
        tool.write(name, npy([row[:3] for row in ROWS], descr))
        tap.equal(value(name, "-s", "lights[0].intensity=2.5"), value("same.csv"), "an array of places: " + name)
        refused = tool.run("check", "-", stdin=scene(name))
        tap.ok(refused.code == 3 and "no intensities" in refused.err and "the key intensity" in refused.err,
               "which needs the key: " + name, refused)
    tool.write("scene.yaml", scene("same.csv"))
    both = tool.run("check", "scene.yaml", "-s", "lights[0].intensity=2")
    tap.ok(both.code == 3 and "intensity is for files without intensities" in both.err, "both", both)


def formats_agree(tap, tool):
    points = ", ".join("{type: point, position: [%s, %s, %s], intensity: %s, attenuation: none}" % row for row in ROWS)
    files = {"a.csv": csv(ROWS), "b.csv": "X\tY\tZ\tIntensity\r\n" + csv(ROWS).replace(",", "\t").replace("\n", "\r\n"),
             "a.npy": npy(ROWS), "named.csv": npy(ROWS, ">f4")}
    tool.write("scene.yaml", SCENE.replace("- " + LIGHT, "").replace("lights:", "lights: [%s]" % points))
    expected = tool.run("probe", "scene.yaml", "--json").json()["points"]
    files.update(dialects())
    for name, content in files.items():
        tool.write(name, content)
        tool.write("scene.yaml", scene(name))
        found = tool.run("probe", "scene.yaml", "--json").json()["points"]
        tap.ok(all(abs(a["value"] - b["value"]) <= a["error"] + b["error"] for a, b in zip(found, expected)),
               "as many points: " + name, found, expected)
        for a, b in zip(found, expected):
            light, = a["lights"]
            tap.ok(light["type"] == "points" and all(light[part] == sum(each[part] for each in b["lights"])
                                                     for part in ("irradiance", "diffuse", "specular")),
                   "one light, the sum of them: " + name, a, b)
    text = tool.run("explain", "scene.yaml").out
    tap.ok("sum of 3 sources" in text and len(text) < 20000, "explained as one", text)


def passed_over(tap, tool):
    """Columns that are not used are told, all of them, and names of rows are not."""
    tool.write("spare.csv", "id,x,y,z,Colour,intensity,note\n" + "".join("1,%s,%s,%s,7,%s,dim\n" % row for row in ROWS))
    result = tool.run("check", "-", stdin=scene("spare.csv"))
    tap.ok(result.code == 0 and 'spare.csv that are not used: "Colour", "note"\n' in result.out, "two columns", result)


def files_that_are_none(tap, tool):
    cases = [("no rows", "", ["no row"]), ("three numbers", "1,2,3\n", ["no intensities", "the key intensity"]),
             ("five numbers", csv(ROWS) + "1,2,3,4,5\n", ["line 4, column 1", "5", "4"]),
             ("a decimal comma", "1,5,2,3,4\n", ["line 1", "decimal commas", "semicolons"]),
             ("a word", "x,y,z,intensity\n1,2,3,much\n", ["line 2, column 7", '"much"']),
             ("not a number", "1,2,3,nan\n", ["line 1, column 7", "nan", "finite"]),
             ("too large a number", "1,2,-1e999,1\n", ["line 1, column 5", "-1e999", "finite"]),
             ("a dark hole", csv(ROWS) + "1,2,3,-4\n", ["line 4, column 7", "below 0"]),
             ("an unknown unit", "x (parsec),y,z,I\n1,2,3,4\n", ["line 1", "parsec", "mm, cm, m"]),
             ("an unknown unit of intensity", "x,y,z,I (%)\n1,2,3,4\n", ["%", "W/sr"]),
             ("groups of digits", "x;y;z;I\n1.5;2;3;4\n2;2;1,800;4\n", ["line 3, column 5", "comma", "point"]),
             ("a column too few", "x,z,intensity\n1,2,3\n", ["line 1", "x, y, z, intensity", "x_mm"]),
             ("bytes", bytes(range(256)), ["line"]),
             ("the beginning of NPY", b"\x93NUMPY", ["NPY"]),
             ("an array cut off", npy(ROWS)[:-1], ["length", "3 rows"]),
             ("five columns", npy(ROWS, shape="(3, 5)"), ["(3, 5)", "(N, 4)", "(N, 3)"]),
             ("complex numbers", npy(ROWS, "<c8"), ["<c8", "<f4"]), ("no array", npy([]), ["no row"]),
             ("an array too long", npy(ROWS, shape="(10000001, 4)"), ["ten million"]),
             ("infinity", npy(ROWS + [(1, 2, float("inf"), 4)]), ["row 4", "finite"]),
             ("below 0", npy(ROWS + [(1, 2, 3, -1)], "<f4"), ["row 4", "below 0"])]
    for title, content, words in cases:
        tool.write("c\x1b.csv", content)
        tool.write("scene.yaml", scene('"c\\e.csv"'))
        for command in ["check", "scene.yaml"], ["render", "scene.yaml", "-o", "a.png"]:
            result = tool.run(*command)
            tap.ok(result.code == 3 and "scene.yaml:11:26: error: " in result.err and "\x1b" not in result.err
                   and all(word in result.err for word in words) and "a.png" not in tool.files(), title, result)
    tool.write("a.csv", csv(ROWS))
    tool.write("scene.yaml", scene("a.csv", "pattern: lambertian, aim: [0, 0, 1500]"))
    result = tool.run("check", "scene.yaml")
    tap.ok(result.code == 3 and "number 3 of a.csv" in result.err, "aimed at its own place", result)
    tool.write("a.csv", csv([(10, 10, 1500, 1), (10, 20, 20, 1), (10, 1500, 1500, 1), (10, 20, 1500, 1)]))
    tool.write("scene.yaml", scene("a.csv", "pattern: lambertian, aim: [10, 20, 1500]"))
    result = tool.run("check", "scene.yaml")
    tap.ok(result.code == 3 and "number 4 of a.csv" in result.err, "aimed at one place of them alone", result)
    with open(tool.file("large.csv"), "wb") as file:
        file.truncate((1 << 30) + 1)
    result = tool.run("check", "-", stdin=scene("large.csv"))
    tap.ok(result.code == 3 and "large.csv is larger than 1024 MB" in result.err, "larger than can be", result)


def a_million(tap, tool):
    rows = ("%d,%d.5,%d,0.001\n" % (i % 1999 - 999, i % 997 - 498, 1500 + i % 1009) for i in range(MILLION))
    tool.write("cloud.csv", "x,y,z,intensity\n" + "".join(rows))
    tool.write("scene.yaml", scene("cloud.csv", "pattern: lambertian"))
    tap.equal(tool.run("check", "scene.yaml").code, 0, "a million rows")
    tap.ok(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024 < LARGEST_BYTES, "in 400 MB of memory")


run_tests(Tap(), where_they_are, formats_agree, lamps_alone, passed_over, files_that_are_none, a_million)
