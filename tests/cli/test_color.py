# SPDX-License-Identifier: MIT
"""Scenes in colour: what is printed of a colour, what files hold of it, spectra, advice, and a grey scene's silence."""
import json
import math
import struct
import zlib

import numpy

from luminaires import AXIAL, KEYS, eulumdat
from tap import Tap
from tool import run_tests

HEAD = {"luxel": 1, "screen": {"width": 200, "height": 200, "resolution": [40, 40]}, "observer": {"z": 1000}}
BALL = {"type": "sphere", "center": [0, 0, 0], "radius": 70, "material": {"diffuse": 0.8, "specular": 0.2}}
LAMP = {"type": "point", "position": [300, 200, 400], "intensity": 2}
SPECTRUM = "wavelength,power\n" + "".join("%d,%g\n" % (nm, 1) for nm in range(360, 831, 10))


def scene(lamps, material=None, channels="rgb", **more):
    screen = dict(HEAD["screen"], resolution=[40, 40])
    ball = dict(BALL, material=dict(BALL["material"], **(material or {})))
    return json.dumps(dict(HEAD, screen=screen, channels=channels, surfaces=[ball], lights=lamps, **more))


def chunks(data):
    """The chunks of a PNG in their order."""
    found, at = [], 8
    while at < len(data):
        length, = struct.unpack(">I", data[at:at + 4])
        found.append((data[at + 4:at + 8], data[at + 8:at + 8 + length]))
        at += 12 + length
    return found


def pixels_of_png(data):
    """The bytes of the rows of an 8-bit RGB picture without row filters."""
    parts = chunks(data)
    columns, rows = struct.unpack(">II", parts[0][1][:8])
    raw = zlib.decompress(b"".join(content for name, content in parts if name == b"IDAT"))
    lines = numpy.frombuffer(raw, numpy.uint8).reshape(rows, 1 + 3 * columns)
    assert not lines[:, 0].any()
    return lines[:, 1:].reshape(rows, columns, 3)


def test_probe(tap, tool):
    """JSON and text of a probe: a lamp's colour, whatever its strength; null where the luminance is 0."""
    warm = dict(LAMP, color={"temperature": 2700})
    tool.write("warm.yaml", scene([warm], {"specular": 0}))
    found = tool.run("probe", "warm.yaml", "-p", "0,0", "-p", "-68,-5", "--json").json()["points"]
    lit = found[0]
    tap.ok(abs(lit["cct"] - 2700) < 0.01 and abs(lit["duv"]) < 1e-9, "the temperature of the only lamp")
    tap.ok(abs(lit["xy"][0] - .45985903) < 1e-8 and abs(lit["xy"][1] - .41059904) < 1e-8, "its chromaticity")
    for value, factor in zip(lit["rgb"]["value"], (1.93510007, .80355312, .19179632)):
        tap.ok(abs(value / lit["value"] - factor) < 2e-8, "a channel is the luminance by the lamp's")
    tap.ok(max(lit["rgb"]["error"]) < 1e-12 * lit["value"], "with a bound")
    tap.equal([found[1][key] for key in ("value", "xy", "cct", "duv")], [0, None, None, None], "no colour in the dark")
    grey = tool.run("probe", "warm.yaml", "-s", "channels=grey", "-p", "0,0", "--json").json()["points"][0]
    tap.ok("rgb" not in grey and grey["value"] == lit["value"], "a grey scene has the same value and no channels")
    text = tool.run("probe", "warm.yaml", "-p", "0,0").out
    tap.ok("2700 K" in text and "nearest black body in u, v" in text, "the method is named")


def test_files(tap, tool):
    """PNG, NPY, PFM, CSV and EXR hold three channels; the PNG says that it is sRGB and how many were clipped."""
    lamps = [dict(LAMP, color={"temperature": 1900}), dict(LAMP, position=[-300, 0, 400], color={"temperature": 6500})]
    tool.write("two.yaml", scene(lamps))
    names = ["two.png", "two.npy", "two.pfm", "two.csv", "two.exr"]
    for threads in ("1", "2"):
        made = tool.run("render", "two.yaml", "--threads", threads, *sum((["-o", name] for name in names), []))
        bytes_of = [tool.read(name) for name in names]
        if threads == "1":
            before = bytes_of
    tap.ok(before == bytes_of, "two threads make the same bytes")
    values = numpy.load(tool.file("two.npy"))
    tap.equal((values.shape, values.dtype.str), ((40, 40, 3), "<f4"), "NPY has three channels")
    head = b"PF\n40 40\n-1.0\n"
    pfm = bytes_of[2]
    tap.ok(pfm.startswith(head), "PFM is of colour")
    tap.ok((numpy.frombuffer(pfm[len(head):], "<f4").reshape(40, 40, 3)[::-1] == values).all(), "with the same numbers")
    lines = bytes_of[3].decode().splitlines()
    tap.ok(lines[0].startswith("x_mm,y_mm,red_") and ",blue_" in lines[0], "CSV names the channels")
    table = numpy.array([[float(x) for x in line.split(",")[2:]] for line in lines[1:]], numpy.float32)
    tap.ok(numpy.array_equal(table[table.any(axis=1)], values[values.any(axis=2)]), "and has the same numbers")
    parts = chunks(bytes_of[0])
    order = [name for name, content in parts]
    tap.ok(order.index(b"sRGB") < order.index(b"IDAT") and order.index(b"cICP") < order.index(b"IDAT"),
           "PNG says that it is sRGB before the picture")
    tap.equal(dict(parts)[b"cICP"], bytes([1, 13, 0, 1]), "by its code points")
    share = numpy.clip(values / values.max(), 0, 1).astype(float)
    curve = numpy.where(share <= .0031308, 12.92 * share, 1.055 * share ** (1 / 2.4) - .055)
    tap.ok(abs(pixels_of_png(bytes_of[0]) - numpy.floor(255 * curve)).max() <= 1, "by the greatest channel, its curve")
    below = int((values < 0).sum())
    tap.ok(below > 0 and "%d of 4800" % below in made.err, "clipped channels are counted")
    exr = bytes_of[4]
    tap.ok(b"chromaticities" in exr and b"B\0" in exr, "EXR has chromaticities")
    row = numpy.frombuffer(exr[-40 * 12:], "<f4").reshape(3, 40)[::-1].T
    tap.ok((row == values[-1]).all(), "and the same numbers, in the order B, G, R")
    refused = tool.run("stats", "two.exr")
    tap.ok(refused.code == 4 and "channels" in refused.err, "a picture in colour is no field to read")
    tap.equal(tool.run("probe", "two.png", "-p", "0,0", "--json").json()["points"][0]["rgb"],
              tool.run("probe", "two.yaml", "-p", "0,0", "--json").json()["points"][0]["rgb"], "it carries its scene")


def test_spectra(tap, tool):
    """A spectrum of equal energy is E; what is no spectrum is refused at its line."""
    tool.write("equal.csv", SPECTRUM)
    tool.write("lit.yaml", scene([dict(LAMP, color={"spectrum": "equal.csv"})], {"specular": 0}))
    found = tool.run("probe", "lit.yaml", "-p", "0,0", "--json").json()["points"][0]
    tap.ok(max(abs(x - 1 / 3) for x in found["xy"]) < 1e-4 and abs(found["cct"] - 5455.4) < 5, "equal energy")
    for name, text, words in (
            ("micro", SPECTRUM.replace("3", "0.3", 1).replace("\n360,", "\n0.36,"), "in nm"),
            ("unit", SPECTRUM.replace("wavelength", "wavelength [µm]"), "in nm"),
            ("gap", "".join(line + "\n" for line in SPECTRUM.splitlines() if not line.startswith("55")
                            and not line.startswith("56")), "540"),
            ("short", "\n".join(SPECTRUM.splitlines()[:20]), "700"),
            ("back", SPECTRUM + "500,1\n", "must go up"),
            ("below", SPECTRUM.replace("500,1", "500,-1"), "below 0"),
            ("dark", SPECTRUM.replace(",1\n", ",0\n"), "no power")):
        tool.write("equal.csv", text)
        refused = tool.run("check", "lit.yaml")
        tap.ok(refused.code == 3 and words in refused.err and "equal.csv" in refused.err, "bad: " + name)


def test_advice(tap, tool):
    """Colours that count for nothing are told, and a scene in colour without any."""
    warm = dict(LAMP, color={"temperature": 2700})
    tool.write("grey.yaml", scene([warm], {"color": [1, .5, .5]}, "grey"))
    told = tool.run("check", "grey.yaml")
    tap.ok("color has no effect with channels grey" in told.err + told.out, "of a light")
    tap.equal((told.err + told.out).count("color has no effect with channels grey"), 2, "and of a material")
    tool.write("none.yaml", scene([LAMP]))
    told = tool.run("check", "none.yaml")
    tap.ok("all is grey" in told.err + told.out, "of a scene in which there are none")
    told = tool.run("check", "none.yaml", "-s", "channels=grey")
    tap.ok("colour" not in told.err + told.out, "a grey scene without colours is silent")


def test_lamp_files(tap, tool):
    """What a luminaire's file tells of its lamp is offered where nobody has said otherwise, and is taken by the key."""
    lamp = {"type": "luminaire", "file": "lamp.ldt", "position": [300, 200, 400]}
    tool.write("white.yaml", scene([lamp]))
    for words, said in (("warm white", None), ("99", None), ("0.4", None), ("123", None), ("4000K", "of 4000 K"),
                        ("4000 K, CRI 80", "of 4000 K"), ("4,000 K", "of 4000 K"), ("2700 °K", "of 2700 K"),
                        ("840", "code 840 of its lamp, a colour temperature of 4000 K"), ("LED 927 DIM", "of 2700 K"),
                        ("3000/4000 K", "temperatures 3000, 4000 K"), ("tw 2700-6500", "temperatures 2700, 6500 K"),
                        ("830/840", "temperatures 3000, 4000 K")):
        tool.write("lamp.ldt", eulumdat(line_30=words))
        told = tool.run("check", "white.yaml")
        tap.equal((told.code, "lamp.ldt tells" in told.err + told.out), (0, said is not None), words)
        tap.ok(said is None or said in told.err + told.out, words + " is read")
    shown = tool.run("photometry", "lamp.ldt").out
    tap.ok("830/840" in shown and "80" in shown, "the file's words are shown")
    for keyword, words, said in (("COLORTEMP", "3000", "of 3000 K"), ("_CCT", "3500 K", "of 3500 K"),
                                 ("LAMP", "LED 4000K 1234 lm", "of 4000 K"), ("LAMP", "LED 1234", None)):
        tool.write("lamp.ies", KEYS + "[%s] %s\n[_CRI] 90\nTILT=NONE\n" % (keyword, words) + AXIAL)
        told = tool.run("check", "white.yaml", "-s", "lights[0].file=lamp.ies")
        tap.equal(said in told.err + told.out if said else "ies tells" not in told.err + told.out, True, words)
    tap.equal(tool.run("photometry", "lamp.ies", "--json").json()["lamps"][0]["color_rendering"], "90", "and CRI")
    tool.write("lamp.ldt", eulumdat())
    told = tool.run("check", "white.yaml", "-s", "channels=grey")
    tap.ok("tells a colour" not in told.err + told.out, "not in a grey scene")
    tool.write("warm.yaml", scene([dict(lamp, color={"temperature": 2700})]))
    told = tool.run("check", "warm.yaml")
    tap.ok("tells a colour" not in told.err + told.out, "nor where the scene has said it")
    lit = tool.run("probe", "white.yaml", "-p", "0,0", "--json").json()["points"][0]
    tap.ok(len(set(lit["rgb"]["value"])) == 1 and lit["value"] > 0, "until then its light is white")


def test_grids(tap, tool):
    """A red wall beside a plane: channels of what it reflects are those of the grey scenes with its reflectances."""
    wall = {"type": "rectangle", "center": [-500, 0, 500], "size": [1000, 1000], "axis": [1, 0, 0], "up": [0, 0, 1],
            "material": {"model": "lambert", "diffuse": 0.8, "over_pi": True, "color": [1, 0.25, 0.25]}}
    floor = {"type": "rectangle", "center": [0, 0, 0], "size": [1000, 1000],
             "material": {"model": "lambert", "diffuse": 0.5, "over_pi": True}}
    whole = dict(HEAD, observer={"z": 4000}, channels="rgb", reflections="all", surfaces=[floor, wall],
                 lights=[dict(LAMP, color={"temperature": 3000})],
                 grids=[{"center": [0, 0, 0], "size": [800, 800], "n": [3, 3]}])
    tool.write("red.yaml", json.dumps(whole))
    found = tool.run("grid", "red.yaml", "--json").json()["grids"][0]
    rgb = tool.run("check", "red.yaml")
    tap.equal(rgb.code, 0, "the scene is good")
    lamp = (1.77093133, .84426137, .27207370)
    weights = (.2126390058715, .7151686787678, .0721923153607)
    sums = numpy.zeros((3, 3))
    for channel, kd in enumerate((.8, .2, .2)):
        grey = dict(whole, channels="grey", surfaces=[floor, dict(wall, material=dict(wall["material"], diffuse=kd))])
        tool.write("one.yaml", json.dumps(grey))
        alone = tool.run("grid", "one.yaml", "--json").json()["grids"][0]
        for row in range(3):
            for column in range(3):
                cell = found["rgb"][row][column]
                truth = lamp[channel] * alone["values"][row][column]
                bound = cell["error"][channel] + lamp[channel] * alone["errors"][row][column] + 1e-7 * truth
                tap.ok(abs(cell["value"][channel] - truth) <= bound, "a cell's channel within the bounds")
                sums[row, column] += weights[channel] * truth
    off = abs(numpy.array(found["values"]) - sums) / sums
    tap.ok(off.max() < 3e-3, "the values are the luminance")
    seen = found["average_color"]
    tap.ok(seen["cct"] is not None and seen["cct"] < 3000 and abs(seen["xy"][0] - .437) < 0.05, "a little redder")
    middle = ("red.yaml", "--at", "0,0,0,0,0,1", "--quantity", "irradiance")
    probe = tool.run("probe", *middle, "--json").json()["points"][0]
    cell = found["rgb"][1][1]
    for channel in range(3):
        tap.ok(abs(probe["rgb"]["value"][channel] - cell["value"][channel]) <=
               probe["rgb"]["error"][channel] + cell["error"][channel], "a probe in the middle agrees")
    peak = found["extrema"]["maximum"]
    tap.ok(peak["value"] >= found["maximum"]["value"] * (1 - 1e-6), "the plane's maximum is above that of the cells")
    place = ",".join(map(repr, peak["position"])) + ",0,0,1"
    probe = tool.run("probe", "red.yaml", "--at", place, "--quantity", "irradiance", "--json").json()["points"][0]
    tap.ok(abs(probe["value"] - peak["value"]) <= probe["error"] + peak["error"], "as a probe there says")
    for channel in range(3):
        tap.ok(abs(probe["rgb"]["value"][channel] - peak["rgb"]["value"][channel]) <=
               probe["rgb"]["error"][channel] + peak["rgb"]["error"][channel], "in each channel")
    column, row = found["maximum"]["cell"]
    tap.equal(found["maximum"]["rgb"], found["rgb"][row][column], "the greatest cell has its colour")


def test_red_wall(tap, tool):
    """What a red wall and a floor send to each other, against the integral equation solved at Gauss's nodes."""
    nodes, weights = numpy.polynomial.legendre.leggauss(20)
    u, v = (axis.ravel() for axis in numpy.meshgrid(nodes, nodes))
    area = numpy.outer(weights, weights).ravel()
    zero = 0 * u
    # the floor is 1.2 x 1 m, the wall 1 x 0.8 m, 0.3 m beside it and 0.2 m above; lengths in m
    places = numpy.concatenate([numpy.stack([.6 * u, .5 * v, zero], 1),
                                numpy.stack([zero - .9, .5 * u, .6 + .4 * v], 1)])
    areas = numpy.concatenate([.3 * area, .2 * area])
    normals = numpy.repeat([[0, 0, 1], [1, 0, 0]], len(area), 0)
    lamp = numpy.array([.3, .1, 1.1])

    def kernel(at, normal):
        """The share of what each node sends that arrives at places."""
        way = places[None] - at[:, None]
        square = (way ** 2).sum(2)
        leaving = numpy.maximum(-(way * normals[None]).sum(2), 0)
        return numpy.maximum((way * normal[:, None]).sum(2), 0) * leaving / (math.pi * square ** 2 + 1e-300) * areas

    def direct(at, normal):
        way = lamp - at
        return 40 * numpy.maximum((way * normal).sum(1), 0) / (way ** 2).sum(1) ** 1.5
    links, first = kernel(places, normals), direct(places, normals)
    matte = {"model": "lambert", "over_pi": True}
    kd, color, warm = (.5, .8), (1, .25, .1), (1.77093133, .84426137, .27207370)
    at, up = numpy.array([[-.3, .1, 0], [.2, -.3, 0]]), numpy.array([[0, 0, 1.]] * 2)
    tool.write("wall.yaml", json.dumps(dict(
        HEAD, observer={"z": 4000}, channels="rgb", reflections="all",
        surfaces=[{"type": "rectangle", "center": [0, 0, 0], "size": [1200, 1000],
                   "material": dict(matte, diffuse=kd[0])},
                  {"type": "rectangle", "center": [-900, 0, 600], "size": [1000, 800], "axis": [1, 0, 0],
                   "up": [0, 0, 1], "material": dict(matte, diffuse=kd[1], color=color)}],
        lights=[{"type": "point", "position": [300, 100, 1100], "intensity": 40, "color": {"temperature": 3000}}])))
    asked = ["--at=%g,%g,0,0,0,1" % (1000 * x, 1000 * y) for x, y, _ in at]
    found = tool.run("probe", "wall.yaml", "--quantity", "irradiance", "--json", *asked).json()["points"]
    for channel in range(3):
        reflectance = numpy.repeat([kd[0], kd[1] * color[channel]], len(area))
        lit = numpy.linalg.solve(numpy.eye(len(places)) - links * reflectance, first)
        truth = warm[channel] * (direct(at, up) + kernel(at, up) @ (reflectance * lit))
        for point, value in zip(found, truth):
            rgb = point["rgb"]
            tap.ok(abs(rgb["value"][channel] - value) <= rgb["error"][channel] + 1e-5 * value,
                   "channel %d of the floor beside a red wall" % channel, (rgb, value))
            tap.ok(rgb["error"][channel] < 2e-3 * value, "with a small bound")


ROOM = {"type": "room", "center": [0, 0, 0], "size": [2000, 2000, 2000], "up": "z",
        "material": {"model": "lambert", "diffuse": 0.7, "over_pi": True},
        "materials": {"left": {"model": "lambert", "diffuse": 0.7, "over_pi": True, "color": [1, 0.2, 0.1]}}}
WEIGHTS = (.2126390058715, .7151686787678, .0721923153607)


def in_channels(scene):
    """The three grey scenes with the reflectances of the channels."""
    for channel in range(3):
        grey = json.loads(json.dumps(dict(scene, channels="grey")))
        for surface in grey["surfaces"]:
            for material in [surface.get("material", {})] + list(surface.get("materials", {}).values()):
                if "color" in material:
                    material["diffuse"] *= material["color"][channel]
                if "specular_color" in material:
                    material["specular"] *= material["specular_color"][channel]
        yield grey


def test_balance(tap, tool):
    """The balance and the glare of a room with a red wall are the luminance of those of its channels."""
    disk = {"disk": {"center": [0, 300, 950], "radius": 150, "axis": [0, 0, -1]}, "type": "planar", "radiance": 800}
    whole = dict(HEAD, channels="rgb", units="photometric", reflections="all", surfaces=[ROOM],
                 screen={"width": 200, "height": 200, "resolution": [4, 4]},
                 observer={"position": [0, -900, 0], "target": [0, 900, 0], "up": [0, 0, 1],
                           "projection": "perspective", "view": "observer"},
                 lights=[dict(disk, color={"temperature": 3000})])
    lamp = (1.77093133, .84426137, .27207370)
    tool.write("whole.yaml", json.dumps(whole))
    ask = ("--reflected-error", "0.05", "--threads", "1")
    sight = ("--eye", "0,-900,0,0,1,0") if "--eye" in tool.run("glare", "--help").out else ()
    found = tool.run("stats", "whole.yaml", "--json", *ask).json()
    glare = tool.run("glare", "whole.yaml", "--json", *sight, *ask).json()
    sums = {}
    background = [0, 0]
    for channel, grey in enumerate(in_channels(whole)):
        share = WEIGHTS[channel] * lamp[channel]
        tool.write("one.yaml", json.dumps(grey))
        alone = tool.run("stats", "one.yaml", "--json", *ask).json()
        for key in ("arrives", "absorbed", "emitted"):
            before = sums.get(key, (0, 0))
            sums[key] = (before[0] + share * alone["balance"][key]["value"],
                         before[1] + share * alone["balance"][key]["error"])
        rating = tool.run("glare", "one.yaml", "--json", *sight, *ask).json()["observers"][0]
        background[0] += share * rating["background"]["value"]
        background[1] += share * rating["background"]["error"]
    for key, (value, error) in sums.items():
        own = found["balance"][key]
        tap.ok(abs(own["value"] - value) <= own["error"] + error + 1e-7 * value, "the balance: " + key)
    tap.equal(found["balance"]["closes"], True, "it closes")
    own = glare["observers"][0]["background"]
    tap.ok(abs(own["value"] - background[0]) <= own["error"] + background[1] + 1e-7 * background[0], "the glare")


def test_explain(tap, tool):
    """An explanation goes from white light on a white material to the channels, their luminance and their colour."""
    lamps = [dict(LAMP, color={"temperature": 2700}), dict(LAMP, position=[-300, 0, 400], color={"xy": [.3127, .329]}),
             {"type": "ambient", "irradiance": 0.5}]
    for name, material in (("blinn-phong", {"color": [1, .5, .25], "specular_color": [.5, 1, 1]}),
                           ("eon", {"diffuse_model": "eon", "roughness": 0.5, "color": [1, .5, .25]}), ("grey", {})):
        tool.write("way.yaml", scene(lamps, material))
        probe = tool.run("probe", "way.yaml", "-p", "20,10", "--json").json()["points"][0]
        told = tool.run("explain", "way.yaml", "-p", "20,10", "--json").json()["points"][0]
        tap.equal([told[key] for key in ("value", "rgb", "xy", "cct", "duv")],
                  [probe[key] for key in ("value", "rgb", "xy", "cct", "duv")], name + ": as the probe says")
        for channel in range(3):
            total = sum(light["value"][channel] for light in told["channels"])
            tap.ok(abs(total - probe["rgb"]["value"][channel]) < 1e-13 * total, name + ": the lights add up")
            tap.equal([light["value"][channel] for light in told["channels"]],
                      [light["rgb"]["value"][channel] for light in probe["lights"]], "light by light")
        text = tool.run("explain", "way.yaml", "-p", "20,10").out
        tap.ok("The colour" in text and "%.7g" % probe["rgb"]["value"][0] in text and "%.7g" % probe["xy"][0] in text,
               name + ": channels and chromaticity are shown")
        tap.ok("%.7g" % told["channels"][1]["value"][2] in text, name + ": each light has its channels")
    tool.write("red.yaml", json.dumps(dict(HEAD, channels="rgb", reflections=1, surfaces=[ROOM],
                                           lights=[dict(LAMP, color={"temperature": 2700})])))
    ask = ("--reflected-error", "0.02")
    probe = tool.run("probe", "red.yaml", "-p", "0,0", "--json", *ask).json()["points"][0]
    text = tool.run("explain", "red.yaml", "-p", "0,0", *ask).out
    tap.ok("last what other surfaces reflect" in text and "%.7g" % probe["rgb"]["value"][0] in text, "with reflections")


def test_lobes(tap, tool):
    """Pictures of coloured materials: each channel is the grey picture with the channel's reflectances, and probes'."""
    plate = {"type": "rectangle", "center": [0, 0, -150], "size": [400, 400],
             "material": {"diffuse": 0.6, "specular": 0.4, "shininess": 10, "color": [.2, .4, 1]}}
    ball = dict(BALL, material={"diffuse": 0.8, "specular": 0.3, "color": [1, .3, .2], "specular_color": [.6, 1, .3]})
    lamps = [dict(LAMP, color={"temperature": 2700}), dict(LAMP, position=[-300, 0, 400], color={"temperature": 6500}),
             {"type": "planar", "rectangle": {"center": [0, 200, 300], "size": [100, 60]}, "radiance": 20}]
    whole = dict(HEAD, channels="rgb", surfaces=[plate, ball], lights=lamps)
    tool.write("lobes.yaml", json.dumps(whole))
    tool.run("render", "lobes.yaml", "-o", "lobes.npy")
    values = numpy.load(tool.file("lobes.npy")).astype(float)
    lamp = ((1.93510007, .80355312, .19179632), (1.04338344, .98357063, 1.03497265), (1, 1, 1))
    luminance = 0
    for channel, grey in enumerate(in_channels(whole)):
        total = 0
        for i in range(3):
            tool.write("one.yaml", json.dumps(dict(grey, lights=[
                {key: value for key, value in lamps[i].items() if key != "color"}])))
            tool.run("render", "one.yaml", "-o", "one.npy", "--precision", "double", "--tolerance", "1e-6")
            total = total + lamp[i][channel] * numpy.load(tool.file("one.npy"))
        off = abs(values[..., channel] - total).max()
        tap.ok(off < 4e-6 * total.max() + 1e-3 * 0.05 * total.max(), "channel %d is off by %g" % (channel, off))
        luminance = luminance + WEIGHTS[channel] * total
    told = tool.run("render", "lobes.yaml", "--json").json()
    tap.ok(abs(told["max"]["value"] - luminance.max()) < 1e-4 * luminance.max(), "the maximum is of the luminance")
    least = told["min_reached"]
    tap.ok(least is not None and least["value"] >= told["min"]["value"], "the least where light arrives is known")
    # a bright blue plate and a dark red one: parts that would not be exact enough are rendered channel by channel
    far = dict(plate, center=[0, 60, -150], size=[400, 120],
               material={"diffuse": 1e-4, "specular": 0, "color": [1, 0, 0]})
    near = dict(plate, center=[0, -60, -150], size=[400, 110],
                material={"diffuse": 1, "specular": 0, "color": [0, 0, 1]})
    tool.write("two.yaml", json.dumps(dict(whole, surfaces=[far, near], lights=lamps[:1])))
    tool.run("render", "two.yaml", "-o", "two.npy")
    red = numpy.load(tool.file("two.npy"))[..., 0]
    tool.write("one.yaml", json.dumps(dict(whole, channels="grey", surfaces=[far, dict(near, material={
        "diffuse": 0, "specular": 0})], lights=lamps[:1])))
    tool.run("render", "one.yaml", "-o", "one.npy", "--precision", "double")
    truth = lamp[0][0] * numpy.load(tool.file("one.npy"))
    tap.ok(abs(red - truth).max() < 3e-6 * truth.max(), "a dark channel is exact")


def test_views(tap, tool):
    """Figures and statistics of a channel and of the colour temperature."""
    lamps = [dict(LAMP, color={"temperature": 2700}), dict(LAMP, position=[-300, 0, 400], color={"temperature": 6500})]
    tool.write("two.yaml", scene(lamps))
    tool.run("render", "two.yaml", "-o", "two.npy")
    values = numpy.load(tool.file("two.npy")).astype(float)
    shown = values.any(axis=2)
    mean = tool.run("stats", "two.yaml", "--json").json()["mean_color"]
    tap.ok(2700 < mean["cct"] < 6500, "the mean has a colour")
    red = tool.run("stats", "two.yaml", "--json", "--channel", "red").json()
    tap.ok(abs(red["max"]["value"] - values[..., 0].max()) == 0 and red["maximum"] is None, "statistics of red")
    cct = tool.run("stats", "two.yaml", "--json", "--channel", "cct").json()
    tap.ok(cct["unit"] == "K" and cct["pixels"] <= shown.sum() and 2699.9 < cct["min"]["value"] < cct["max"]["value"]
           < 6500.1, "statistics of the colour temperature")
    for view in ("luminance", "red", "green", "blue", "cct"):
        made = tool.run("figure", "two.yaml", "--channel", view, "-o", view + ".svg")
        tap.equal((made.code, made.err), (0, ""), "a figure of " + view)
    tap.equal(len({tool.read(view + ".svg") for view in ("luminance", "red", "green", "blue", "cct")}), 5, "all differ")
    tool.write("grey.yaml", scene(lamps, channels="grey"))
    for command in (("stats", "grey.yaml"), ("figure", "grey.yaml", "-o", "no.svg")):
        refused = tool.run(*command, "--channel", "red")
        tap.ok(refused.code == 2 and "the picture is grey" in refused.err, "none of a grey picture")
    refused = tool.run("figure", "two.yaml", "-o", "no.svg", "--channel", "cct", "--section")
    tap.ok(refused.code == 2 and "of the picture alone" in refused.err, "nor with sections")


def test_sweep(tap, tool):
    """Sweeps write channels."""
    lamps = [dict(LAMP, color={"temperature": 2700}), dict(LAMP, position=[-300, 0, 400], color={"temperature": 6500})]
    tool.write("base.yaml", scene(lamps, points=[[0, 0], [90, 90]]))
    tool.write("study.yaml", "study: 1\nscene: base.yaml\ncount: 2\nshard: 2\nvary:\n"
               "  - {key: 'lights[0].intensity', values: [1, 2]}\noutputs: {brightness: float32, probes: float64}\n")
    made = tool.run("sweep", "study.yaml", "-o", "data")
    tap.equal(made.code, 0, "a sweep in colour")
    pictures = numpy.load(tool.file("data/shard-000000/brightness.npy"))
    probes = numpy.load(tool.file("data/shard-000000/probes.npy"))
    tap.equal((pictures.shape, probes.shape), ((2, 40, 40, 3), (2, 2, 3)), "shapes")
    tool.run("render", "base.yaml", "-s", "lights[0].intensity=2", "-o", "own.npy")
    tap.ok((numpy.load(tool.file("own.npy")) == pictures[1]).all(), "the pictures are those of luxel render")
    own = tool.run("probe", "base.yaml", "-s", "lights[0].intensity=2", "-p", "0,0", "--json").json()["points"][0]
    tap.ok((probes[1, 0] == own["rgb"]["value"]).all() and numpy.isnan(probes[:, 1]).all(), "and the probes")


run_tests(Tap(), test_probe, test_files, test_spectra, test_advice, test_lamp_files, test_grids, test_red_wall,
          test_balance, test_explain, test_lobes, test_views, test_sweep)
