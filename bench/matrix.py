#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long pictures by extended sources take: source x placement x law, for each model and surface, in turn.

Usage: matrix.py BUILD [ROUNDS] [WORD]..., with the folder of a build.  Only rows whose names contain all words are
measured.  Prints Markdown tables: processor time of one thread for 400 x 400 pixels, and how many times as long each
law takes as inverse-square does in the same scene, and as the median of its row.
"""
import os
import statistics
import subprocess
import sys
import tempfile

SIDE = 400
# Each law with what it needs of keys, the first being what the others are compared with.
LAWS = {"inverse-square": "", "practical": ", k: 300", "none": "", "polynomial": ", coefficients: [1, 0.7, 1.8]"}
MODELS = ("lambert", "phong", "blinn-phong")
SURFACES = {
    "sphere": "{type: sphere, center: [0, 0, 1000], radius: 300, material: {model: %s}}",
    "plate": "{type: rectangle, center: [0, 0, 1000], size: [640, 640], axis: [0.3, -0.2, 1], material: {model: %s}}",
}
# How the outlines stand: over one side as lamps do, or so that 100 mm are left to the sphere.
FAR, NEAR = "far", "near"
SOURCES = {
    "rectangle": {FAR: "planar, rectangle: {center: [300, 200, 2200], size: [600, 400], aim: [0, 0, 1000]}",
                  NEAR: "planar, rectangle: {center: [0, 0, 1400], size: [300, 200]}"},
    "polygon": {FAR: "planar, vertices: [[0, 0, 2200], [300, 200, 2200], [600, 600, 2200], [600, 0, 2200]]",
                NEAR: "planar, vertices: [[-150, -150, 1400], [0, 0, 1400], [150, 150, 1400], [150, -150, 1400]]"},
    "disk": {FAR: "planar, disk: {center: [300, 200, 2200], radius: 300, aim: [0, 0, 1000]}",
             NEAR: "planar, disk: {center: [0, 0, 1400], radius: 150}"},
    "box": {FAR: "volume, box: {center: [300, 200, 2200], size: [400, 300, 200]}",
            NEAR: "volume, box: {center: [50, 0, 1450], size: [200, 150, 100]}"},
    "ball": {FAR: "volume, sphere: {center: [300, 200, 2200], radius: 300}",
             NEAR: "volume, sphere: {center: [0, 0, 1500], radius: 100}"},
    "tube": {FAR: "volume, cylinder: {center: [300, 200, 2200], radius: 100, height: 800, axis: [1, 1, 0]}",
             NEAR: "volume, cylinder: {center: [0, 0, 1420], radius: 20, height: 400, axis: [1, 0, 0]}"},
    "sky": {FAR: "planar, disk: {center: [0, 0, 3000], radius: 1.0e+7}"},
}
SCENE = """luxel: 1
screen: {width: 700, height: 700, resolution: [%d, %d]}
observer: {z: 2500}
surfaces: [%s]
lights: [{type: %s, radiance: 10, attenuation: %s%s}]
"""


def rows():
    """The names and the parts of scenes that all laws are tried in."""
    for surface in SURFACES:
        for source, placements in SOURCES.items():
            for placement in placements:
                for model in MODELS:
                    yield (surface, source, placement, model)


def laws_of(row):
    """A plane without end gives by the other laws what grows with its size: there is one law for a sky."""
    return [law for law in LAWS if law == "inverse-square" or row[1] != "sky"]


def write_scene(folder, row, law):
    surface, source, placement, model = row
    path = os.path.join(folder, "-".join(row + (law,)) + ".yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCENE % (SIDE, SIDE, SURFACES[surface] % model, SOURCES[source][placement], law, LAWS[law]))
    return path


def measure(program, rounds, scenes, threads=1, side=0):
    """Milliseconds of each picture, the least of some rounds; `side`: its pixels along the longer side, 0: as it is."""
    done = subprocess.run([program, str(rounds), str(threads), str(side)] + scenes,
                          capture_output=True, text=True, check=True)
    return [float(word) for word in done.stdout.split()]


def program_of(folder):
    subprocess.run(["ninja", "-C", folder, "bench/time_pictures"], capture_output=True, check=True)
    return os.path.join(folder, "bench", "time_pictures")


def times(folder, rounds=3, words=()):
    """{row: {law: ms}}"""
    program, found = program_of(folder), {}
    with tempfile.TemporaryDirectory() as scenes:
        for row in rows():
            if not all(word in row for word in words):
                continue
            laws = laws_of(row)
            taken = measure(program, rounds, [write_scene(scenes, row, law) for law in laws])
            found[row] = dict(zip(laws, taken))
            print("%-40s %s" % (" ".join(row), "  ".join("%s %.2f" % pair for pair in found[row].items())),
                  file=sys.stderr, flush=True)
    return found


def ratios(found, to):
    """(ratio, row, law) of the laws but the first, the worst first; `to` tells what of a row is 1."""
    return sorted(((taken[law] / to(taken), row, law) for row, taken in found.items() for law in list(taken)[1:]),
                  reverse=True)


def to_square(taken):
    return taken["inverse-square"]


def to_median(taken):
    return statistics.median(taken.values())


def print_tables(found):
    """One table for each surface: a row a source and model, its laws in ms and in times inverse-square."""
    laws = list(LAWS)
    for surface in SURFACES:
        if not any(row[0] == surface for row in found):
            continue
        print("\n%s:\n" % surface.capitalize())
        print("| source | model | %s | worst |" % " | ".join("%s, ms" % law for law in laws))
        print("|---|---|%s---:|" % ("---:|" * len(laws)))
        for row, taken in found.items():
            if row[0] != surface:
                continue
            cells = ["%.2f" % taken[law] if law in taken else "" for law in laws]
            worst = max(taken.values()) / to_square(taken) if len(taken) > 1 else None
            print("| %s, %s | %s | %s | %s |"
                  % (row[1], row[2], row[3], " | ".join(cells), "" if worst is None else "%.1f" % worst))
    for title, to in (("inverse-square in the same scene", to_square), ("the median of its row", to_median)):
        worst = ratios(found, to)
        if worst:
            ratio, row, law = worst[0]
            surface, source, placement, model = row
            print("\nWorst against %s: %.1f (%s on a %s, %s, %s, %s)."
                  % (title, ratio, source, surface, placement, model, law))


if __name__ == "__main__":
    arguments = sys.argv[1:]
    count = int(arguments[1]) if len(arguments) > 1 else 3
    print_tables(times(arguments[0], count, arguments[2:]))
