# SPDX-License-Identifier: MIT
"""Maintenance factors of scenes, keys of all lights, and limits: verdicts against sums by hand, and what is refused."""
import itertools
import json
import math

from luminaires import HEAD
from tap import Tap
from tool import run_tests

LAMP = HEAD + "1 -1 1 4 1 1 2 .1 .2 0\n1 1 20\n0 30 60 90\n0\n1000 700 300 10\n"
SCREEN = {"luxel": 1, "units": "photometric", "screen": {"width": 2000, "height": 2000, "resolution": [40, 40]},
          "observer": {"z": 4000}}
POINT = {"type": "point", "position": [0, 0, 2000], "intensity": 1000}
GRID = {"name": "plane", "center": [0, 0, 0], "size": [3000, 2000], "n": [3, 2]}
CLOSED = {"type": "room", "center": [0, 0, 1500], "size": [4000, 3000, 3000], "up": "z",
          "material": {"model": "lambert", "over_pi": True, "diffuse": 0.5}}
# 0.6 m x 0.6 m, 5000 cd/m2, 4 m ahead and 1.8 m above the eye, before 40 cd/m2
PANEL = {"type": "planar", "rectangle": {"center": [0, 4000, 1800], "size": [600, 600], "axis": [0, 0, -1],
                                         "up": [0, 1, 0]}, "radiance": 5000}
SKY = {"type": "ambient", "irradiance": 125.66370614359172}
UGR = 18.0555676521171


def scene(*lights, grid=None, **others):
    return json.dumps({**SCREEN, "surfaces": [], "lights": lights,
                       **({"grids": [{**GRID, **grid}]} if grid is not None else {}), **others})


def values():
    """E = I cos / r^2 of the point at the cells' centres."""
    for y, x in itertools.product((0.5, -0.5), (-1, 0, 1)):
        yield 1000 * 2 / math.hypot(x, y, 2) ** 3


def judge(tool, limits, *options, code=None, **others):
    text = scene(POINT, grid={"limits": limits}, **others)
    result = tool.run("grid", "-", "--limits", "--json", *options, stdin=text)
    assert code is None or result.code == code, result
    return {limit["name"]: limit for limit in result.json()["grids"][0]["limits"]}, result


# ---- maintenance ----

def maintained(tap, tool):
    tool.write("lamp.ies", LAMP)
    tool.write("cloud.csv", "x,y,z,intensity\n0,0,2000,3\n100,50,1500,7\n")
    kinds = [POINT, {**PANEL, "parts": 80}, PANEL, SKY, {"type": "distant", "direction": [0, 1, -2], "irradiance": 90},
             {"type": "spot", "position": [0, 0, 2000], "power": 10, "inner": 20, "outer": 40},
             {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2000], "maintenance_factor": 0.9},
             {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2000], "opening": "file", "flux": 700},
             {"type": "points", "file": "cloud.csv"}, {**POINT, "array": {"n": [2, 2], "spacing": [300, 300]}},
             {"type": "volume", "sphere": {"center": [0, 0, 2000], "radius": 50}, "power": 10}]
    for light in kinds:
        found = []
        for factor in (1, 0.7):
            tool.write("scene.yaml", scene(light, grid={}, maintenance_factor=factor))
            probe = tool.run("probe", "scene.yaml", "--json", "--at", "200,100,0,0,0,1", "--quantity", "irradiance")
            found.append((probe.json()["points"][0], tool.run("grid", "scene.yaml", "--json").json()["grids"][0]))
        (whole, grid), (part, kept) = found
        tap.ok(whole["value"] > 0, "there is light", whole)
        tap.near(part["value"], 0.7 * whole["value"], 2e-16, "the factor, " + light["type"],
                 part["error"] + 0.7 * whole["error"])
        for key in ("flux", "mean"):
            if grid[key] is None:
                tap.ok(kept[key] is None, "no %s, %s" % (key, light["type"]))
            else:
                tap.near(kept[key], 0.7 * grid[key], 3e-16, "its " + key,
                         kept[key + "_error"] + 0.7 * grid[key + "_error"])
        tap.ok(part["error"] > 0, "its rounding is in the bound", part)
    both = [tool.run("grid", "-", "--json", stdin=scene({**kinds[6], "maintenance_factor": own}, grid={},
                                                        maintenance_factor=factor))
            for own, factor in ((0.5, 0.8), (0.8, 0.5), (1, 1))]
    averages = [result.json()["grids"][0]["average"] for result in both]
    tap.near(averages[0], averages[1], 1e-15, "a luminaire's own factor and that of the scene are one product")
    tap.near(averages[0], 0.4 * averages[2], 1e-15, "which is that")
    plain = [tool.run("grid", "-", "--json", stdin=scene(POINT, grid={}, **more)).out
             for more in ({}, {"maintenance_factor": 1})]
    tap.equal(plain[0], plain[1], "a factor of 1 changes no byte")
    told = tool.run("grid", "-", stdin=scene(POINT, grid={}, maintenance_factor=0.67))
    tap.ok("0.67" in told.out, "it is among the conventions", told)
    for factor in (0, 1.2, -1):
        result = tool.run("check", "-", stdin=scene(POINT, maintenance_factor=factor))
        tap.ok(result.code == 3 and "maintenance_factor" in result.err, "%g is refused" % factor, result)


# ---- all lights ----

def all_lights(tap, tool):
    tool.write("lamp.ies", LAMP)
    tool.write("scene.yaml", scene(POINT, SKY, {"type": "luminaire", "file": "lamp.ies", "position": [0, 0, 2000]},
                                   {**POINT, "position": [500, 0, 2000]}, grid={}))
    def average(*options):
        return tool.run("grid", "scene.yaml", "--json", *options).json()["grids"][0]["average"]
    tap.equal(average("-s", "lights[*].intensity=300"),
              average("-s", "lights[0].intensity=300", "-s", "lights[3].intensity=300"), "those that have the key")
    tap.equal(average("-s", "lights[*].enabled=false"), 0, "a key of all")
    tap.equal(average("-s", "lights[*].array={n: [2, 1], spacing: [100, 100]}"),
              average(*itertools.chain.from_iterable(
                  ("-s", "lights[%d].array={n: [2, 1], spacing: [100, 100]}" % i) for i in (0, 2, 3))), "a group")
    for key, words in (("lights[*].inner=3", "inner"), ("lights[*].intensty=3", "intensity"),
                       ("points[*].x=1", "points"), ("surfaces[*].name=a", "surfaces"), ("lights[*].intensity", "=")):
        result = tool.run("grid", "scene.yaml", "-s", key)
        tap.ok(result.code == 2 and words in result.err, "none has " + key, result)
    wrong = tool.run("check", "scene.yaml", "-s", "lights[*].intensity=-3")
    tap.ok(wrong.code == 3 and "lights[0].intensity" in wrong.err and "lights[3].intensity" in wrong.err,
           "each wrong one is told", wrong)
    tool.run("set", "scene.yaml", "lights[*].intensity=300", "-o", "dimmed.yaml")
    tap.equal(tool.run("grid", "dimmed.yaml", "--json").json()["grids"][0]["average"],
              average("-s", "lights[*].intensity=300"), "luxel set")


# ---- grids ----

def verdicts(tap, tool):
    truth = list(values())
    mean, least, most = sum(truth) / 6, min(truth), max(truth)
    numbers = {"average": mean, "minimum": least, "maximum": most, "uniformity": least / mean, "ratio": least / most}
    for side, verdict in ((1 - 1e-9, "pass"), (1 + 1e-9, "fail")):
        limits = {name: number * (2 - side if name == "maximum" else side) for name, number in numbers.items()}
        found, _ = judge(tool, limits, code=0 if verdict == "pass" else 1)
        tap.equal(list(found), list(numbers), "their order")
        for name, number in numbers.items():
            tap.near(found[name]["value"], number, 1e-13, name)
            tap.ok(found[name]["wanted"] == limits[name] and found[name]["verdict"] == verdict and
                   0 < found[name]["error"] < 1e-11 * number, "%s: %s" % (name, verdict), found[name])
    found, _ = judge(tool, {"ratio": 40}, code=0)
    tap.near(found["ratio"]["value"], most / least, 1e-13, "above 1 the ratio is the other way round")
    judge(tool, {"ratio": most / least * (1 - 1e-9)}, code=1)
    for one in numbers:  # one that fails is enough
        limits = {name: number * (1.1 if name == "maximum" else 0.9) for name, number in numbers.items()}
        limits[one] = numbers[one] * (0.9 if one == "maximum" else 1.1)
        found, _ = judge(tool, limits, code=1)
        tap.equal([name for name in found if found[name]["verdict"] != "pass"], [one], "only " + one)


def undecided(tap, tool):
    room = {"surfaces": [CLOSED], "reflections": "all"}
    options = ("--reflected-error", "0.05")
    limits = {"average": 1, "minimum": 1, "maximum": 1e6, "uniformity": 0, "ratio": 1e-6}
    first, _ = judge(tool, limits, *options, **room)
    exact, _ = judge(tool, {"average": 1, "uniformity": 0, "ratio": 1e-6}, "--reflected-error", "1e-3", **room)
    for name, limit in first.items():
        value, error = limit["value"], limit["error"]
        tap.ok(error > 1e-6 * value, "a bound that can be seen", limit)
        if name in exact:
            tap.ok(abs(exact[name]["value"] - value) <= error + exact[name]["error"], "the bound holds", limit, exact)
        sign = 1 if name == "maximum" else -1
        for steps, verdict in ((0.5 * sign, "undecided"), (-0.5 * sign, "undecided"), (1.01 * sign, "pass"),
                               (-1.01 * sign, "fail")):
            found, result = judge(tool, {name: value + steps * error}, *options, **room)
            tap.ok(found[name]["verdict"] == verdict and (result.code == 0) == (verdict == "pass"),
                   "%s %+.2f bounds away: %s" % (name, steps, verdict), found, result)
            tap.ok(result.code in (0, 1), "it ends with 0 or 1", result)


def without_values(tap, tool):
    ball = {"type": "sphere", "center": [0, 0, 0], "radius": 1950}
    found, result = judge(tool, {"average": 1}, surfaces=[ball])
    tap.ok(found["average"]["value"] is None and found["average"]["verdict"] == "undecided" and result.code == 1,
           "cells inside of bodies are left out, and nothing is said of none", found, result)
    dark, result = judge(tool, {"average": 0, "uniformity": 0.5, "ratio": 2}, "-s", "lights=[]")
    tap.ok(dark["average"]["verdict"] == "pass" and dark["uniformity"]["value"] is None and result.code == 1,
           "where all is dark there is no uniformity", dark)


def told(tap, tool):
    text = scene(POINT, grid={"limits": {"average": 100, "uniformity": 0.9}})
    result = tool.run("grid", "-", "--limits", stdin=text)
    lines = [line.split() for line in result.out.splitlines()]
    tap.ok(result.code == 1 and any(line[:4] == ["average", "at", "least", "100"] and line[-1] == "pass"
                                    for line in lines) and
           any(line[:2] == ["uniformity", "U0"] and line[-1] == "fail" for line in lines), "in words", result)
    plain = tool.run("grid", "-", "--json", stdin=text)
    tap.ok(plain.code == 0 and plain.json()["grids"][0]["limits"][1]["verdict"] == "fail" and
           "observers" not in plain.json(), "without --limits they are told and change no exit code", plain)
    tap.ok("limits" not in tool.run("grid", "-", "--json", stdin=scene(POINT, grid={})).out, "a grid without limits")
    none = tool.run("grid", "-", "--limits", stdin=scene(POINT, grid={}))
    tap.ok(none.code == 3 and "has no limits" in none.err and not none.out, "nothing to judge", none)
    for limits, words in (({"average": -1}, "average"), ({"uniformity": 1.5}, "uniformity"), ({"ratio": 0}, "ratio"),
                          ({"ugr": 19}, "ugr"), ({"average": "500"}, "number"),
                          ({"preset": "office"}, "en12464-office"),
                          ({"avarage": 500}, "average")):
        result = tool.run("check", "-", stdin=scene(POINT, grid={"limits": limits}))
        tap.ok(result.code == 3 and words in result.err, "limits %s" % limits, result)


# ---- observers ----

def observers(tap, tool):
    def rate(lights, limits, *options, **others):
        seen = {"name": "desk", "eye": [0, 0, 0], "view": [0, 2, 0], "limits": limits}
        text = scene(*lights, observers=[seen], **others)
        result = tool.run("grid", "-", "--limits", "--json", *options, stdin=text)
        return result, result.json()["observers"][0] if result.out else None
    for ugr, verdict in ((19, "pass"), (UGR + 1e-9, "pass"), (UGR - 1e-9, "fail"), (16, "fail")):
        result, found = rate((PANEL, SKY), {"ugr": ugr})
        tap.ok(found["limits"][0]["verdict"] == verdict and result.code == (verdict == "fail") and
               (found["name"], found["eye"], found["view"]) == ("desk", [0, 0, 0], [0, 2, 0]), "UGR %g" % ugr, result)
        tap.near(found["limits"][0]["value"], UGR, 1e-13, "its value")
    glare = tool.run("glare", "-", "--json", "--eye", "0,0,0,0,2,0", stdin=scene(PANEL, SKY)).json()["observers"][0]
    tap.equal((found["ugr"], found["error"]), (glare["ugr"], glare["error"]), "as luxel glare rates it")
    lamp = {"type": "point", "position": [0, 3000, 1500], "intensity": 100}
    for limit, verdict in ((19, "undecided"), (16, "fail")):
        result, found = rate((PANEL, lamp, SKY), {"ugr": limit})
        tap.ok(found["limits"][0]["verdict"] == verdict and result.code == 1, "lamps without area only add", result)
    result, found = rate((PANEL, SKY), {"ugr": 13}, "-s", "lights[0].rectangle.center=[0,-4000,1800]")
    tap.ok(found["ugr"] is None and found["limits"][0]["verdict"] == "pass" and result.code == 0, "nothing dazzles",
           result)
    result, found = rate((PANEL,), {"ugr": 19})
    tap.ok(found["limits"][0]["verdict"] == "undecided" and result.code == 1, "no background, no verdict", result)
    result, found = rate((PANEL, SKY), {"preset": "en12464-office"})
    tap.equal((found["limits"][0]["wanted"], result.code), (19, 0), "by the row of a standard")
    result, found = rate((PANEL, SKY), {"preset": "en12464-office", "ugr": 18})
    tap.equal((found["limits"][0]["wanted"], result.code), (18, 1), "which a number replaces")
    result, _ = rate((PANEL, SKY), {"ugr": 19}, "-s", "units=radiometric")
    tap.ok(result.code == 3 and "radiometric" in result.err, "radiometric units", result)
    text = tool.run("grid", "-", "--limits", stdin=scene(PANEL, SKY, observers=[
        {"eye": [0, 0, 0], "view": [0, 1, 0], "limits": {"ugr": 16}}]))
    tap.ok(text.code == 1 and "observer 1: the eye at" in text.out and "fail" in text.out, "in words", text)
    for wrong, words in (({"eye": [0, 0, 0]}, "view"), ({"eye": [0, 0, 0], "view": [0, 0, 0]}, "view"),
                         ({"eye": [0, 0, 0], "view": [0, 1, 0], "limits": {"average": 3}}, "average"),
                         ({"eye": [0, 0, 0], "view": [0, 1, 0], "limits": {"preset": "en12464-walls"}}, "preset")):
        result = tool.run("check", "-", stdin=scene(PANEL, observers=[wrong]))
        tap.ok(result.code == 3 and words in result.err, "observers %s" % wrong, result)


def presets(tap, tool):
    rows = {"en12464-corridor": (100, 0.4, 28), "en12464-stairs": (100, 0.4, 25), "en12464-canteen": (200, 0.4, 22),
            "en12464-rest-room": (100, 0.4, 22), "en12464-store": (100, 0.4, 25), "en12464-office": (500, 0.6, 19),
            "en12464-filing": (300, 0.4, 19), "en12464-drawing": (750, 0.7, 16), "en12464-meeting-room": (500, 0.6, 19),
            "en12464-reception": (300, 0.6, 22), "en12464-archive": (200, 0.4, 25), "en12464-classroom": (300, 0.6, 19),
            "en12464-evening-class": (500, 0.6, 19), "en12464-lecture-hall": (500, 0.6, 19),
            "en12464-walls": (75, 0.1, None), "en12464-ceiling": (50, 0.1, None),
            "en12464-cylindrical": (150, 0.1, None), "en12193-hall-1": (750, 0.7, None),
            "en12193-hall-2": (500, 0.7, None), "en12193-hall-3": (200, 0.5, None),
            "en12193-football-1": (500, 0.7, None), "en12193-football-2": (200, 0.6, None),
            "en12193-football-3": (75, 0.5, None)}
    for name, (average, uniformity, ugr) in rows.items():
        sight = [{"eye": [0, 0, 0], "view": [0, 1, 0], "limits": {"preset": name}}] if ugr else []
        result = tool.run("grid", "-", "--limits", "--json",
                          stdin=scene(POINT, grid={"limits": {"preset": name}}, observers=sight)).json()
        found = [limit["wanted"] for judged in result["grids"] + result["observers"] for limit in judged["limits"]]
        tap.equal(found, [number for number in (average, uniformity, ugr) if number], name)
    for name, least in (("en1838-escape-route", 1), ("en1838-open-area", 0.5)):
        found, _ = judge(tool, {"preset": name})
        tap.equal({key: limit["wanted"] for key, limit in found.items()}, {"minimum": least, "ratio": 40}, name)
    found, _ = judge(tool, {"preset": "en12464-office", "average": 300})
    tap.equal((found["average"]["wanted"], found["uniformity"]["wanted"]), (300, 0.6),
              "a number replaces that of the row")


def shares(tap, tool):
    """The percents of the cells, by the values one by one."""
    own = sorted(values())
    for above, percent, verdict in ((own[0] * (1 - 1e-9), 100, "pass"), (own[-1] * (1 + 1e-9), 1, "fail"),
                                    (own[4] * (1 - 1e-9), 33, "pass"), (own[4] * (1 - 1e-9), 34, "fail")):
        found, result = judge(tool, {"share": {"above": above, "percent": percent}})
        share = found["share"]
        count = 100 * sum(value >= above for value in own) / 6
        tap.ok(share["verdict"] == verdict and abs(share["value"] - count) < 1e-9 and share["above"] == above and
               share["wanted"] == percent and result.code == (verdict == "fail"), "%g %% from %g on" % (percent, above),
               share)
    text = tool.run("grid", "-", stdin=scene(POINT, grid={"limits": {"share": {"above": 200, "percent": 50}}}))
    tap.ok("at least 50 % from 200 lx on" in text.out, "in words", text)
    for wrong, words in (({"above": 300}, "percent"), ({"above": 300, "percent": 101}, "percent"), (300, "mapping")):
        result = tool.run("check", "-", stdin=scene(POINT, grid={"limits": {"share": wrong}}))
        tap.ok(result.code == 3 and words in result.err, "share %s" % wrong, result)


# ---- observers at several places ----

def places(tap, tool):
    """Each place and way is one observer; the limit is kept where all keep it."""
    seats = {"name": "seats", "eye": [100, 0, 0], "size": [1000, 600], "n": [2, 3], "limits": {"ugr": 19}}
    text = scene(PANEL, SKY, observers=[{"name": "desk", "eye": [0, 0, 0], "view": [0, 1, 0]}, seats])
    found = tool.run("glare", "-", "--json", stdin=text).json()["observers"]
    eyes = [[100 + 1000 * (x - 0.5) / 2, 600 * y / 3, 0] for y, x in itertools.product((1, 0, -1), (0, 1))]
    ways = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
    own = [(eye, way) for eye in eyes for way in ways]
    tap.ok(len(found) == 25 and all(math.dist(a["eye"], eye) < 1e-9 and math.dist(a["view"], way) < 1e-12
                                    for a, (eye, way) in zip(found[1:], own)), "where they are and look", found[1:])
    by_hand = [tool.run("glare", "-", "--json", "--eye", ",".join(map(repr, [*eye, *way])),
                        stdin=text).json()["observers"][0]["ugr"] for eye, way in own[:8]]
    tap.equal([one["ugr"] for one in found[1:9]], by_hand, "as one by one")
    told = tool.run("glare", "-", stdin=text)
    worst = max(one["ugr"] for one in found[1:] if one["ugr"] is not None)
    tap.ok(told.code == 0 and "2 × 3 places" in told.out and "%.2f" % worst in told.out and "pass" in told.out,
           "a table", told)
    strict = scene(PANEL, SKY, observers=[{**seats, "limits": {"ugr": worst - 1e-6}}])
    judged = tool.run("grid", "-", "--limits", stdin=strict)
    tap.ok(judged.code == 1 and judged.out.count("fail") == 1, "one verdict of all", judged)
    one_way = scene(PANEL, SKY, observers=[{**seats, "view": [0, 1, 0]}])
    tap.equal(len(tool.run("glare", "-", "--json", stdin=one_way).json()["observers"]), 6, "with a view only that")
    for wrong, words in (({**seats, "n": None}, "n"), ({key: seats[key] for key in ("eye", "n")}, "size"),
                         ({key: seats[key] for key in ("eye", "size")}, "n"), ({**seats, "n": [0, 1]}, "n"),
                         ({**seats, "size": [0, 5]}, "size")):
        for language in "en", "ru":
            result = tool.run("check", "-", stdin=scene(PANEL, observers=[wrong]), environment={"LANGUAGE": language})
            tap.ok(result.code == 3 and words in result.err,
                   "observers %s" % wrong, result)
    nobody = tool.run("glare", "-", stdin=scene(PANEL, SKY))
    tap.ok(nobody.code == 2 and "--eye" in nobody.err, "a scene without observers", nobody)


# ---- grids on sides ----

def sides(tap, tool):
    """A grid of a side is the same as one that is written out."""
    room = {**CLOSED, "name": "hall", "center": [100, 0, 1500]}
    box = {"type": "box", "name": "cupboard", "center": [-1500, -1000, 400], "size": [600, 400, 800],
           "rotate": [0, 0, 30], "up": "z", "material": CLOSED["material"]}
    plate = {"type": "rectangle", "center": [500, 500, 700], "size": [900, 400], "axis": [0, 0, 1],
             "material": CLOSED["material"]}
    ball = {"type": "sphere", "name": "ball", "center": [1200, 0, 300], "radius": 200, "material": CLOSED["material"]}
    surfaces = [room, box, plate, ball]

    def measure(*grids, code=0, **others):
        result = tool.run("grid", "-", "--json", stdin=json.dumps({**SCREEN, "surfaces": surfaces, "lights": [POINT],
                                                                    "grids": grids, **others}))
        assert result.code == code, result
        return result.json()["grids"] if code == 0 else result
    written = {
        ("hall", "left"): ([-1900, 0, 1500], [3000, 3000], [1, 0, 0], [0, 0, 1]),
        ("hall", "right"): ([2100, 0, 1500], [3000, 3000], [-1, 0, 0], [0, 0, 1]),
        ("hall", "floor"): ([100, 0, 0], [4000, 3000], [0, 0, 1], [0, 1, 0]),
        ("hall", "ceiling"): ([100, 0, 3000], [4000, 3000], [0, 0, -1], [0, 1, 0]),
        ("hall", "back"): ([100, 1500, 1500], [4000, 3000], [0, -1, 0], [0, 0, 1]),
        ("hall", "front"): ([100, -1500, 1500], [4000, 3000], [0, 1, 0], [0, 0, 1]),
        ("surfaces[2]", None): ([500, 500, 700], [900, 400], [0, 0, 1], [0, 1, 0]),
        ("surfaces[2]", "back"): ([500, 500, 700], [900, 400], [0, 0, -1], [0, 1, 0]),
    }
    for (surface, side), (center, size, axis, up) in written.items():
        by_name = {"surface": surface, "n": [5, 4], "border": 100, **({"side": side} if side else {})}
        plain = {"center": center, "size": [number - 200 for number in size], "axis": axis, "up": up, "n": [5, 4]}
        a, b = measure(by_name, plain)
        tap.ok(a["values"] == b["values"] and a["errors"] == b["errors"] and a["size"] == b["size"],
               "%s %s" % (surface, side), a, b)
    top, = measure({"surface": "cupboard", "side": "top", "n": [3, 2]})
    turned = math.radians(30)
    tap.ok(math.dist(top["center"], [-1500, -1000, 800]) < 1e-9 and math.dist(top["axis"], [0, 0, 1]) < 1e-12 and
           abs(abs(top["up"][1]) - math.cos(turned)) < 1e-12, "a side of a turned box", top)
    spaced, = measure({"surface": "hall", "side": "floor", "border": 500, "spacing": "en12464"})
    tap.equal(spaced["n"], [7, 5], "the spacing of EN 12464-1: 3 x 2 m, p = 0.431 m")
    for wrong, words in (({"surface": "hal", "side": "left"}, "hall, cupboard, surfaces[2]"),
                         ({"surface": "ball"}, "hall, cupboard, surfaces[2]"),
                         ({"surface": "hall"}, "left, right, floor, ceiling, back, front"),
                         ({"surface": "hall", "side": "top"}, "left, right, floor, ceiling, back, front"),
                         ({"surface": "cupboard", "side": "floor"}, "left, right, bottom, top, back, front"),
                         ({"surface": "surfaces[2]", "side": "top"}, "front, back"),
                         ({"surface": "hall", "side": "floor", "border": 1500}, "1500"),
                         ({"surface": "hall", "side": "floor", "border": -1}, "border"),
                         ({"surface": "hall", "side": "floor", "center": [0, 0, 0], "size": [1, 1]}, "center"),
                         ({"surface": "hall", "side": "floor", "axis": [0, 0, 1]}, "axis"),
                         ({"center": [0, 0, 0]}, "size"), ({}, "center")):
        for language in "en", "ru":
            text = json.dumps({**SCREEN, "surfaces": surfaces, "lights": [POINT], "grids": [{**wrong, "n": [2, 2]}]})
            result = tool.run("check", "-", stdin=text, environment={"LANGUAGE": language})
            tap.ok(result.code == 3 and words in result.err, "grid %s, %s" %
                   (wrong, language), result)
    both = tool.run("check", "-", stdin=json.dumps({**SCREEN, "surfaces": surfaces, "lights": [POINT], "grids": [
        {"surface": "no", "n": [2, 2]}, {"surface": "hall", "side": "no", "n": [2, 2]}]}))
    tap.ok("surface must be one of" in both.err and "side must be one of" in both.err, "all errors at once", both)


run_tests(Tap(), maintained, all_lights, verdicts, undecided, without_values, told, observers, presets, shares, places,
          sides)
