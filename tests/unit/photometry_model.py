# SPDX-License-Identifier: MIT
"""Luminaire files read a second time, from the formats alone: by tokens for LM-63, by lines for EULUMDAT.

Nothing is completed here: a direction is folded into the planes that the file holds, which is another way than the
library's.  And files of random lamps are written, in all the ways in which programs write them.
"""
import bisect
import math
import random
import re

MM = {1: 304.8, 2: 1000.0}


class Lamp:
    """A table as the file holds it."""

    def __init__(self, kind, symmetry, planes, angles, values):
        self.kind, self.symmetry, self.planes, self.angles, self.values = kind, symmetry, planes, angles, values

    def fold(self, plane):
        """The stored plane that a plane is like."""
        if self.kind != "C":
            return abs(plane) if self.symmetry == "lateral" else plane
        plane %= 360.0
        if self.symmetry == "axial":
            return self.planes[0]
        if self.symmetry == "quadrant":
            plane = min(plane, 360.0 - plane)
            return min(plane, 180.0 - plane)
        if self.symmetry == "bilateral 0-180":
            return min(plane, 360.0 - plane)
        if self.symmetry == "bilateral 90-270":
            turned = (plane + 90.0) % 360.0  # C270 is 0
            turned = min(turned, 360.0 - turned)
            return turned - 90.0 if self.planes[0] < 0 else 270.0 - turned
        return plane

    @staticmethod
    def between(numbers, at, measure):
        i = min(max(bisect.bisect_right(numbers, at) - 1, 0), len(numbers) - 2)
        low, high, here = measure(numbers[i]), measure(numbers[i + 1]), measure(at)
        return i, (here - low) / (high - low)

    def at(self, plane, angle, cosine=False):
        """The intensity, linear between the places of the table."""
        plane = self.fold(plane)
        if not self.angles[0] <= angle <= self.angles[-1]:
            return 0.0
        same, cos, sin = float, lambda x: math.cos(math.radians(x)), lambda x: math.sin(math.radians(x))
        along = {"C": cos, "A": sin, "B": same}[self.kind] if cosine else same
        across = sin if cosine and self.kind == "B" else same
        j, t = self.between(self.angles, angle, along)
        row = lambda i: (1.0 - t) * self.values[i][j] + t * self.values[i][j + 1]
        if len(self.planes) == 1:
            return row(0)
        if self.kind != "C" and not self.planes[0] <= plane <= self.planes[-1]:
            return 0.0
        if self.symmetry == "none" and self.kind == "C" and plane > self.planes[-1]:  # the last plane is missing
            s = (plane - self.planes[-1]) / (self.planes[0] + 360.0 - self.planes[-1])
            return (1.0 - s) * row(len(self.planes) - 1) + s * row(0)
        i, s = self.between(self.planes, plane, across)
        return (1.0 - s) * row(i) + s * row(i + 1)

    def flux(self, cosine):
        """The integral of that map in cd·sr, by Gauss's rule in each cell of the table."""
        nodes = sorted({p % 360.0 for p in self.all_planes()}) if self.kind == "C" else self.all_planes()
        if self.kind == "C":
            nodes = nodes + [nodes[0] + 360.0]
        total = 0.0
        for a, b in zip(nodes, nodes[1:]):
            for c, d in zip(self.angles, self.angles[1:]):
                total += self.cell(a, b, c, d, cosine)
        return total

    def cell(self, a, b, c, d, cosine):
        total = 0.0
        across, along = (MANY, TWO) if self.kind == "B" else (TWO, MANY)  # the other way the map is linear
        for x, u in across:
            for y, v in along:
                plane, angle = (a + b) / 2 + (b - a) / 2 * x, (c + d) / 2 + (d - c) / 2 * y
                polar = {"C": math.sin(math.radians(angle)), "A": math.cos(math.radians(angle)),
                         "B": math.cos(math.radians(plane))}[self.kind]
                total += u * v * self.at(plane, angle, cosine) * polar
        return total * math.radians(b - a) / 2 * math.radians(d - c) / 2

    def all_planes(self):
        """Where the map has kinks across."""
        if self.kind != "C":
            return sorted({-p for p in self.planes} | set(self.planes)) if self.symmetry == "lateral" else self.planes
        images = {"axial": [lambda p: 0.0], "none": [lambda p: p],
                  "quadrant": [lambda p: p, lambda p: 180.0 - p, lambda p: 180.0 + p, lambda p: 360.0 - p],
                  "bilateral 0-180": [lambda p: p, lambda p: 360.0 - p],
                  "bilateral 90-270": [lambda p: p, lambda p: 180.0 - p]}[self.symmetry]
        return [round(image(p) % 360.0, 9) % 360.0 for p in self.planes for image in images]


def gauss(count):
    """Nodes and weights of Gauss's rule by Newton's method."""
    found = []
    for k in range(count):
        x = math.cos(math.pi * (k + 0.75) / (count + 0.5))
        for _ in range(50):
            p, q = 1.0, 0.0
            for n in range(count):
                p, q = ((2 * n + 1) * x * p - n * q) / (n + 1), p
            slope = count * (x * p - q) / (x * x - 1.0)
            x -= p / slope
        found.append((x, 2.0 / ((1.0 - x * x) * slope * slope)))
    return found


TWO, MANY = gauss(2), gauss(12)


def read_ies(text):
    """A right LM-63 file."""
    lines = text.splitlines()
    tag = lines[0] if lines[0].startswith("IES") else ""
    years = (("2019", 2019), ("2002", 2002), ("95", 1995), ("91", 1991))
    year = next((year for key, year in years if key in tag), 1986)
    where = next(i for i, line in enumerate(lines) if re.match(r"\s*TILT\s*=", line, re.I))
    words = [float(word) for word in re.split(r"[\s,]+", " ".join(lines[where + 1:])) if word]
    if "INCLUDE" in lines[where]:
        words = words[2 + 2 * int(words[1]):]
    head, words = words[:13], words[13:]
    count, planes = int(head[3]), int(head[4])
    angles, across, words = words[:count], words[count:count + planes], words[count + planes:]
    factor = head[2] * head[10] * (head[11] if year < 1995 else 1.0)
    values = [[factor * word for word in words[i * count:(i + 1) * count]] for i in range(planes)]
    kind = {1: "C", 2: "B", 3: "A"}[int(head[5])]
    ends = (across[0], across[-1])
    if kind != "C":
        symmetry = "lateral" if across[0] == 0 else "none"
    else:
        symmetry = "axial" if planes == 1 else {(0, 90): "quadrant", (0, 180): "bilateral 0-180",
                                                (90, 270): "bilateral 90-270"}.get(ends, "none")
    return Lamp(kind, symmetry, across, angles, values)


def read_ldt(text):
    """A right EULUMDAT file."""
    lines = [line.strip() for line in text.splitlines()]
    number = lambda i: float(lines[i - 1].replace(",", ".") or 0)
    symmetry, planes, angles, sets = (int(number(i)) for i in (3, 4, 6, 26))
    at = 27 + 6 * sets + 10
    across = [number(at + i) for i in range(planes)]
    gammas = [number(at + planes + i) for i in range(angles)]
    stored = {0: planes, 1: 1, 2: planes // 2 + 1, 3: planes // 2 + 1, 4: planes // 4 + 1}[symmetry]
    if symmetry == 3:
        first = 3 * planes // 4
        across = [c - 360.0 for c in across[first:]] + across[:planes // 4 + 1]
    factor, at = number(24) * number(29) / 1000.0, at + planes + angles
    values = [[factor * number(at + i * angles + j) for j in range(angles)] for i in range(stored)]
    name = ["none", "axial", "bilateral 0-180", "bilateral 90-270", "quadrant"][symmetry]
    return Lamp("C", name, across[:stored], gammas, values)


# ---- random files ----

def rising(rng, low, high, count, even):
    if even:
        return [low + (high - low) * i / (count - 1) for i in range(count)]
    inner = sorted(rng.sample(range(1, int((high - low) * 2)), count - 2))
    return [low] + [low + 0.5 * i for i in inner] + [high]


def short(number):
    return "%.10g" % number


def random_values(rng, planes, angles):
    return [[round(rng.uniform(0, 2000), rng.choice((0, 1, 3))) for _ in range(angles)] for _ in range(planes)]


def join(rng, words):
    """Words over lines as it happens, between blanks, commas or both."""
    comma = rng.choice((" ", " ", "  ", ",", ", "))
    text, width = "", rng.choice((20, 80, 130, 100000))
    line = ""
    for word in words:
        if line and len(line) + len(word) > width:
            text, line = text + line + "\n", ""
        line += (comma if line else "") + word
    return text + line + "\n"


def random_ies(rng):
    """A right LM-63 file, as bytes and as text."""
    tag, year = rng.choice((("", 1986), ("IESNA91", 1991), ("IESNA:LM-63-1995", 1995), ("IESNA:LM-63-2002", 2002),
                            ("IES:LM-63-2019", 2019)))
    kind = rng.choice(("1", "1", "1", "2", "3"))
    if kind == "1":
        ends = rng.choice(((0, 0), (0, 90), (0, 180), (0, 360)) + (((90, 270),) if year == 1995 else ()))
        angles = rising(rng, *rng.choice(((0, 90), (90, 180), (0, 180))), rng.randint(3, 40), rng.random() < 0.5)
    else:
        ends = rng.choice(((0, 90), (-90, 90)))
        angles = rising(rng, -90, 90, rng.randint(3, 40), rng.random() < 0.5)
    planes = [0] if ends == (0, 0) else rising(rng, *ends, rng.randint(3, 20), rng.random() < 0.5)
    values = random_values(rng, len(planes), len(angles))
    if ends == (0, 360):
        values[-1] = values[0]
    lines = [tag] if tag else []
    lines += ["[%s] %s" % (key, text) if tag else text for key, text in (
        ("TEST", "1"), ("TESTLAB", "own"), ("ISSUEDATE", "today"), ("MANUFAC", "Lampe AG, 54°"),
        ("LUMINAIRE", "TILT=INCLUDE is but a name" if tag else "own"))]
    words = []
    if rng.random() < 0.2:
        lines.append("TILT=INCLUDE")
        words = ["1", "3", "0", "45", "90", "1.0", ".95", "0.9"]
    else:
        lines.append(rng.choice(("TILT=NONE", " tilt = none")))
    whole = "%d.0" if year == 1986 else "%d"
    words += [whole % rng.randint(1, 4), rng.choice(("-1", "1000")), short(rng.choice((1, 1.5, 0.25))),
              whole % len(angles), whole % len(planes), kind, rng.choice("12"), "0.3", "0.6", "0"]
    words += [short(rng.choice((1, 0.95))), short(rng.choice((1, 0.9)) if year < 1995 else rng.choice((1, 1.10000))),
              "40"]
    for numbers in [angles, planes] + values:
        words += [short(number) for number in numbers]
    return encode(rng, "\n".join(lines) + "\n" + join(rng, words))


def mirrored(rng, symmetry):
    """The C planes of a whole turn."""
    if rng.random() < 0.5:
        count = 4 * rng.randint(1, 9)
        return [360.0 * i / count for i in range(count)]
    quarter = rising(rng, 0, 90, rng.randint(2, 8), False)
    half = quarter + [180 - c for c in quarter[-2::-1]]
    if symmetry == 2:
        half = quarter + [90 + c for c in rising(rng, 0, 90, rng.randint(2, 8), False)[1:]]
    if symmetry == 3:
        second = [-c for c in rising(rng, 0, 90, len(quarter), False)[:0:-1]]
        right = second + quarter  # -90 to 90
        return sorted({c % 360.0 for c in right} | {(180.0 - c) % 360.0 for c in right})
    if symmetry == 0:
        return rising(rng, 0, 360, rng.randint(3, 20), False)[:-1]
    return half + [360 - c for c in half[-2:0:-1]]


def random_ldt(rng):
    """A right EULUMDAT file."""
    symmetry = rng.randint(0, 4)
    planes = [0] if symmetry == 1 and rng.random() < 0.5 else mirrored(rng, symmetry)
    angles = rising(rng, 0, rng.choice((90, 180)), rng.randint(3, 37), rng.random() < 0.5)
    count = len(planes)
    stored = {0: count, 1: 1, 2: count // 2 + 1, 3: count // 2 + 1, 4: count // 4 + 1}[symmetry]
    sets = rng.choice((1, 1, 2))
    blank = lambda: rng.choice(("0", ""))
    lines = ["Lampe AG", "1", str(symmetry), str(count), blank(), str(len(angles)), blank(), "report", "name", "number",
             "file.ldt", "date", "600", "300", "50", "590", "290", blank(), blank(), blank(), blank(), "0", "0",
             short(rng.choice((1, 1.25))), blank(), str(sets)]
    for i in range(sets):
        lines += [str(rng.choice((1, -1, 2))), "LED", short(rng.choice((1000, 1234.5))), "4000K", "80", "20"]
    lines += ["0"] * 10 + [short(number) for number in planes + angles]
    lines += [short(value) for row in random_values(rng, stored, len(angles)) for value in row]
    text = "\n".join(lines) + "\n"
    return encode(rng, text.replace(".", ",") if rng.random() < 0.3 else text)


def encode(rng, text):
    """Bytes as programs write them, and the text."""
    ending = rng.choice(("\n", "\n", "\r\n", "\r"))
    encoding, mark = rng.choice((("latin-1", b""), ("utf-8", b""), ("utf-8", b"\xef\xbb\xbf"), ("utf-16", b"")))
    return mark + text.replace("\n", ending).encode(encoding), text


def files(seed, count):
    """Names, bytes and the lamps that they hold."""
    rng = random.Random(seed)
    for i in range(count):
        if i % 2:
            data, text = random_ldt(rng)
            yield "%d.ldt" % i, data, read_ldt(text), rng
        else:
            data, text = random_ies(rng)
            yield "%d.ies" % i, data, read_ies(text), rng
