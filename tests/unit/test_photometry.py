# SPDX-License-Identifier: MIT
"""Luminaire files against a second reader that was written from the formats alone, and against closed forms."""
import math
import os
import subprocess
import sys
import tempfile

import photometry_model as model
from tap import Tap

PROGRAM = sys.argv[1]
FACTS = ("format", "type", "symmetry", "planes", "stored", "angles", "declared", "zone", "linear", "greatest", "dff",
         "beam", "field", "shape", "width", "length", "height", "multiplier", "tilt", "watts")


class Reading:
    """What the library makes of a file."""

    def __init__(self, path, questions=()):
        done = subprocess.run([PROGRAM, path], input="\n".join(questions) + "\n", capture_output=True, text=True,
                              timeout=60)
        self.code, self.err = done.returncode, done.stderr
        lines = done.stdout.splitlines()
        self.facts = dict(zip(FACTS, lines[0].split("|"))) if lines else {}
        self.answers = [[float(word) for word in line.split()] for line in lines[1:]]

    def number(self, name):
        return float(self.facts[name])


def ies(angles, planes, values, tag="IESNA:LM-63-1995", kind=1, opening="0 0 0", units=2, head="1 -1 1"):
    """A small LM-63 file."""
    text = lambda numbers: " ".join("%.17g" % number for number in numbers) + "\n"
    return "%s\n[TEST] own\n[TESTLAB] own\n[ISSUEDATE] now\n[MANUFAC] own\nTILT=NONE\n%s %d %d %d %d %s\n1 1 10\n" % (
        tag, head, len(angles), len(planes), kind, units, opening) + text(angles) + text(planes) + "".join(
            map(text, values))


def write(folder, name, data):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode("utf-8"))
    return path


def near(a, b, relative, absolute=0.0):
    return abs(a - b) <= relative * abs(b) + absolute


def random_directions(rng, lamp, count):
    for _ in range(count):
        plane = rng.choice((rng.uniform(-360, 720) if lamp.kind == "C" else rng.uniform(-95, 95),
                            rng.choice(lamp.planes)))
        angle = rng.choice((rng.uniform(0, 180) if lamp.kind == "C" else rng.uniform(-95, 95),
                            rng.choice(lamp.angles)))
        yield plane, angle


def against_the_model(tap, folder):
    wrong = []
    count = int(os.environ.get("LUXEL_FILES", 40))
    for name, data, lamp, rng in model.files(20260126, count):
        asked = list(random_directions(rng, lamp, 60))
        questions = ["%s %.17g %.17g" % (how, plane, angle) for plane, angle in asked for how in ("angle", "cosine")]
        reading = Reading(write(folder, name, data), questions)
        if reading.code != 0:
            wrong.append("%s: %s" % (name, reading.err))
            continue
        truths = [lamp.at(plane, angle, cosine) for plane, angle in asked for cosine in (False, True)]
        greatest = max(map(max, lamp.values))
        for question, answer, truth in zip(questions, reading.answers, truths):
            if not near(answer[0], truth, 1e-11, 1e-11 * greatest):
                wrong.append("%s (%s, %s): %s is %.17g, not %.17g" % (name, lamp.kind, lamp.symmetry, question,
                                                                     answer[0], truth))
        for rule, cosine in ("zone", True), ("linear", False):
            if not near(reading.number(rule), lamp.flux(cosine), 1e-10):
                wrong.append("%s: flux by the %s rule %s, not %.17g" % (name, rule, reading.facts[rule],
                                                                      lamp.flux(cosine)))
        told = (reading.facts["type"], reading.facts["symmetry"], reading.number("greatest"))
        if told[:2] != (lamp.kind, lamp.symmetry) or not near(told[2], greatest, 1e-14):
            wrong.append("%s: %s, not %s %s %.17g" % (name, told, lamp.kind, lamp.symmetry, greatest))
    tap.ok(not wrong, "%d random files, as a second reader has them" % count, *wrong[:8])


def lambert(tap, folder):
    """I0 cos gamma: both rules have closed forms, in all three types."""
    linear = {1: 0.999974614441729, 2.5: 0.999841314882386, 5: 0.999364896712247, 10: 0.997453764944882,
              15: 0.994249003451462}
    for step, share in linear.items():
        angles = [step * i for i in range(int(90 / step) + 1)]
        row = [1000 * math.cos(math.radians(angle)) if angle < 90 else 0 for angle in angles]
        reading = Reading(write(folder, "lambert.ies", ies(angles, [0], [row])))
        tap.ok(near(reading.number("zone"), 1000 * math.pi, 1e-13), "zone rule, %g degrees" % step, reading.facts)
        tap.ok(near(reading.number("linear"), 1000 * math.pi * share, 1e-13), "linear rule, %g degrees" % step,
               reading.facts)
        tap.ok(near(reading.number("beam"), 120, 2e-3), "half the intensity at 60 degrees", reading.facts)
        tap.equal(reading.number("dff"), 100.0, "all of it downwards")


def cosine_power(angle, exponent):
    return 1000 * max(0.0, math.cos(math.radians(angle))) ** exponent


def one_lamp_in_three_types(tap, folder):
    """I0 cos^m of the angle from the axis, as types A, B and C: flux, and the same intensities in 300 directions."""
    rng = model.random.Random(5)
    sides = [-90 + 2 * i for i in range(91)]
    downs, turns = [2 * i for i in range(46)], [10 * i for i in range(37)]
    cos = lambda angle: math.cos(math.radians(angle))
    tables = {"C": ies(downs, turns, [[cosine_power(g, 3) for g in downs] for _ in turns]),
              "B": ies(sides, sides, [[1000 * max(0, cos(h) * cos(v)) ** 3 for v in sides] for h in sides], kind=2),
              "A": ies(sides, sides, [[1000 * max(0, cos(x) * cos(y)) ** 3 for y in sides] for x in sides], kind=3)}
    vectors = []
    while len(vectors) < 300:
        vector = [rng.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(x * x for x in vector))
        if vector[0] > 0.05 * length:
            vectors.append([x / length for x in vector])
    back = {"C": lambda a, r, u: (math.degrees(math.atan2(u, r)), math.degrees(math.acos(a))),
            "A": lambda a, r, u: (math.degrees(math.atan2(r, a)), math.degrees(math.asin(u))),
            "B": lambda a, r, u: (math.degrees(math.asin(r)), math.degrees(math.atan2(u, a)))}
    for kind, text in tables.items():
        places = [back[kind](*vector) for vector in vectors]
        reading = Reading(write(folder, kind + ".ies", text),
                          ["direction %.17g %.17g" % place for place in places] +
                          ["angle %.17g %.17g" % place for place in places])
        tap.equal(reading.facts.get("type"), kind, "type " + kind)
        tap.ok(near(reading.number("zone"), 1000 * 2 * math.pi / 4, 2e-3), "flux of type " + kind, reading.facts)
        turned = all(max(abs(x - y) for x, y in zip(vector, answer)) < 1e-14
                     for vector, answer in zip(vectors, reading.answers))
        tap.ok(turned, "directions of type " + kind)
        same = all(abs(back_plane % 360 - place[0] % 360) < 1e-9 and abs(back_angle - place[1]) < 1e-9
                   for place, (_, _, _, back_plane, back_angle) in zip(places, reading.answers))
        tap.ok(same, "and back", reading.answers[:2])
        worst = max(abs(answer[0] - 1000 * vector[0] ** 3)
                    for vector, answer in zip(vectors, reading.answers[len(vectors):]))
        tap.ok(worst < 2.0, "intensities of type %s within what the step of the table allows" % kind, worst)


def twins(tap, folder):
    """One lamp as LM-63 and as EULUMDAT, about C0-C180 and, turned by 90 degrees, about C90-C270."""
    rng = model.random.Random(7)
    gammas, half = [7.5 * i for i in range(13)], [15 * i for i in range(13)]
    rows = [[round(rng.uniform(0, 500), 3) for _ in gammas] for _ in half]
    head = lambda symmetry: "\n".join(
        ["own", "1", str(symmetry), "24", "15", "13", "7.5", "", "", "", "", "", "300", "200", "0", "300", "200", "0",
         "0", "0", "0", "100", "100", "1", "0", "1", "1", "LED", "2000", "", "", "20"] + ["0"] * 10 +
        ["%g" % (15 * i) for i in range(24)] + ["%g" % gamma for gamma in gammas]) + "\n"
    ldt = lambda symmetry, table: head(symmetry) + "".join("%.3f\n" % value for row in table for value in row)
    scaled = [[2 * value for value in row] for row in rows]
    asked = ["%s %.17g %.17g" % (how, rng.uniform(0, 360), rng.uniform(0, 90)) for _ in range(500)
             for how in ("angle", "cosine")]
    turned = ["%s %.17g %s" % (word[0], float(word[1]) + 90, word[2]) for word in map(str.split, asked)]
    upright = Reading(write(folder, "a.ies", ies(gammas, half, scaled, opening="0.3 0.2 0")), asked)
    about_90 = Reading(write(folder, "b.ies", ies(gammas, [90 + c for c in half], scaled, opening="0.2 0.3 0")), turned)
    lines = Reading(write(folder, "c.ldt", ldt(2, rows)), asked)
    # C90 .. C270 of the turned lamp are the planes C0 .. C180; the file begins at C270 and goes through C0 to C90
    lines_90 = Reading(write(folder, "d.ldt", ldt(3, rows[::-1])), turned)
    for name, reading in ("turned .ies", about_90), (".ldt", lines), ("turned .ldt", lines_90):
        worst = max((abs(a[0] - b[0]) for a, b in zip(upright.answers, reading.answers)), default=math.inf)
        tap.ok(len(reading.answers) == 1000 and worst < 1e-9, "%s as .ies" % name, worst, reading.err)
        tap.ok(near(reading.number("zone"), upright.number("zone"), 1e-13), "and its flux", reading.facts)
    sizes = lambda reading: (reading.number("width"), reading.number("length"))
    tap.equal(sizes(upright), sizes(lines), "width is what EULUMDAT calls length")
    tap.equal(sizes(upright), sizes(about_90)[::-1], "a turned opening")
    tap.equal(lines_90.facts["symmetry"], "bilateral 90-270", "Isym 3")


def openings(tap, folder):
    shapes = {
        "0 0 0": "point", ".1 .2 0": "rectangle", ".1 .2 .3": "box", "-.1 0 0": "disk", "-.1 -.1 0": "disk",
        "-.1 -.2 0": "ellipse", "-.1 .2 0": "ellipse", ".1 -.2 0": "ellipse", "-.1 0 .3": "cylinder",
        "-.1 -.1 .3": "cylinder", "-.1 .2 .3": "elliptic cylinder", "-.1 -.1 -.1": "sphere",
        "-.1 -.2 -.3": "ellipsoid", "0 .2 -.1": "cylinder along the length", ".2 0 -.1": "cylinder along the width"}
    by_year = {"-.1 0 -.1": ("sphere", "disk facing the length"),
               "-.1 0 -.3": ("ellipsoid", "ellipse facing the length"),
               "0 -.1 -.1": ("ellipsoid", "disk facing the width"),
               "-.1 .2 -.3": ("ellipsoid", "elliptic cylinder along the length"),
               "-.1 .2 -.1": ("ellipsoid", "cylinder along the length"),
               ".2 -.1 -.1": ("ellipsoid", "cylinder along the width")}
    by_year.update({size: (shape, shape) for size, shape in shapes.items()})
    for size, expected in by_year.items():
        for year, shape in zip(("IESNA:LM-63-1995", "IESNA:LM-63-2002"), expected):
            reading = Reading(write(folder, "opening.ies", ies([0, 90], [0], [[1, 0]], tag=year, opening=size)))
            found = reading.facts.get("shape", reading.err)
            if size == "0 -.1 -.1" and year.endswith("1995"):
                shape = found  # LM-63 knows none
            tap.equal(found, shape, "%s in %s" % (size, year))
    feet = Reading(write(folder, "feet.ies", ies([0, 90], [0], [[1, 0]], units=1, opening="1 2 .5")))
    tap.ok([feet.number(side) for side in ("width", "length", "height")] == [304.8, 609.6, 152.4], "feet", feet.facts)


def factors(tap, folder):
    """The ballast-lamp factor counts before 1995 only, lamps and lumens never."""
    for tag, expected in (("IESNA91", 0.25), ("own lamp", 0.25), ("IESNA:LM-63-1995", 1.0), ("IES:LM-63-2019", 1.0)):
        text = ies([0, 90], [0], [[1, 0]], tag=tag, head="3 700 2").replace("1 1 10", "0.5 0.25 10")
        tap.equal(Reading(write(folder, "factor.ies", text)).number("multiplier"), expected, tag)


def converted(tap, folder):
    """What is written as LM-63 and as EULUMDAT and read back, by the library and by the second reader."""
    wrong = []
    for name, data, lamp, rng in model.files(1995, int(os.environ.get("LUXEL_FILES", 40))):
        path = write(folder, name, data)
        asked = list(random_directions(rng, lamp, 40))
        questions = ["%s %.17g %.17g" % (how, plane, angle) for plane, angle in asked for how in ("angle", "cosine")]
        before, greatest = Reading(path, questions), max(map(max, lamp.values))
        for ending, reader, rounding in (".ies", model.read_ies, 0.0), (".ldt", model.read_ldt, 4e-16):
            target = os.path.join(folder, "converted" + ending)
            done = subprocess.run([PROGRAM, path, target], input="", capture_output=True, text=True, timeout=60)
            if ending == ".ldt" and lamp.kind != "C":
                # tables of types A and B become one of type C, whose difference is told (tests/cli/test_photometry.py)
                wrong += [] if done.returncode == 0 and Reading(target, questions).facts["type"] == "C" else [
                    "%s: type %s as EULUMDAT: %s" % (name, lamp.kind, done.stderr)]
                continue
            after = Reading(target, questions)
            # between planes that symmetry has moved to the other side sums round apart
            worst = max((abs(a[0] - b[0]) / greatest for a, b in zip(before.answers, after.answers)), default=1)
            if after.code or len(after.answers) != len(questions) or worst > 1e-13:
                wrong.append("%s to %s: %.3g apart %s" % (name, ending, worst, after.err))
                continue
            if not near(after.number("greatest"), greatest, rounding) and greatest == before.number("greatest"):
                wrong.append("%s to %s: the greatest %s" % (name, ending, after.facts))
            with open(target, encoding="utf-8" if ending == ".ies" else "latin-1", newline="") as file:
                again = reader(file.read())
            apart = max(abs(again.at(*place) - lamp.at(*place)) / greatest for place in asked)
            if apart > 1e-11 or again.kind != lamp.kind:
                wrong.append("%s to %s, as the second reader has it: %.3g" % (name, ending, apart))
            for fact in "shape", "width", "length", "height", "type":
                if after.facts[fact] != before.facts[fact]:
                    wrong.append("%s to %s: %s %s, not %s" % (name, ending, fact, after.facts[fact],
                                                              before.facts[fact]))
    tap.ok(not wrong, "what is converted reads back", *wrong[:8])


def speed(tap, folder):
    rng = model.random.Random(1)
    planes, angles = [0.5 * i for i in range(721)], [0.5 * i for i in range(361)]
    rows = [["%.3f" % rng.uniform(0, 1000) for _ in angles] for _ in planes]
    rows[-1] = rows[0]
    text = ies(angles, planes, []) + "".join(" ".join(row) + "\n" for row in rows)
    reading = Reading(write(folder, "large.ies", text))
    tap.ok(reading.code == 0 and reading.facts["planes"] == "721", "721 × 361 values", reading.err)


def main():
    tap = Tap()
    for test in (lambert, one_lamp_in_three_types, twins, openings, factors, speed, converted, against_the_model):
        with tempfile.TemporaryDirectory() as folder:
            tap.run(test, tap, folder)
    tap.finish()


main()
