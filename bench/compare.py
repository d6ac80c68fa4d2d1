#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Times the kernels and what else can make the exercise's picture on this machine, in turn; prints a page.

Usage: compare.py BUILD, with the folder of a build.  Peers that are not there are left out.
"""
import json
import os
import platform
import shutil
import subprocess
import sys
import time

import matrix
import rooms

HERE = os.path.dirname(os.path.abspath(__file__))
SIDE, ROUNDS = 800, 3


def output(*command):
    """The words that a command prints; None where it cannot be run or fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=True)
    except (OSError, subprocess.SubprocessError):
        return None
    return done.stdout.split()


def build(folder, target):
    """The path of a peer that the build knows, made now; None where it does not."""
    done = subprocess.run(["ninja", "-C", folder, "bench/" + target], capture_output=True, check=False)
    return os.path.join(folder, "bench", target) if done.returncode == 0 else None


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


def povray_scene(lights):
    """The sphere as POV-Ray sees it: its own highlight, and no attenuation."""
    import math
    text = ["#version 3.7;", "global_settings { assumed_gamma 1 }",
            "camera { orthographic location <0, 0, -2000> look_at 0 right 500*x up 500*y }",
            "sphere { 0, 360 texture { pigment { rgb 1 } finish { ambient 0 diffuse 0.8 phong 0.5 phong_size 20 } } }"]
    for i in range(lights):
        angle = 2 * math.pi * i / lights
        text.append("light_source { <%.3f, %.3f, -1500> rgb 0.1 shadowless }"
                    % (2000 * math.cos(angle), 2000 * math.sin(angle)))
    return "\n".join(text)


def run_povray(folder, lights):
    if not shutil.which("povray"):
        return None
    path = os.path.join(folder, "bench", "sphere.pov")
    with open(path, "w", encoding="utf-8") as file:
        file.write(povray_scene(lights))
    start = time.monotonic()
    words = output("povray", "+I" + path, "+O" + path[:-4] + ".png", "+W%d" % SIDE, "+H%d" % SIDE, "-A", "-D")
    return None if words is None else ["%.1f" % (1e3 * (time.monotonic() - start))]


class Peers:
    """What is compared: a name, who runs it, and how."""

    def __init__(self, folder):
        plain, glsl = build(folder, "plain_sphere"), build(folder, "glsl_sphere")
        numpy = os.path.join(HERE, "peers", "numpy_sphere.py")
        python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
        self.drawn_by = ""
        self.all = [("NumPy, float64, whole arrays, one thread",
                     lambda n: output(python, numpy, str(SIDE), str(n), "2", "attenuated"))]
        if plain:
            self.all.append(("a plain C loop for this machine, float32, one thread",
                             lambda n: output(plain, str(SIDE), str(n), "10")))
        if glsl:
            self.all.append(("a GLSL shader, float32, drawn and read back", lambda n: self.shader(glsl, n)))
        self.all.append(("POV-Ray, the whole process", lambda n: run_povray(folder, n)))

    def shader(self, glsl, lights):
        words = output(glsl, str(SIDE), str(lights), "10")
        if words:
            self.drawn_by = " ".join(words[2:])
        return words


def own_times(folder):
    """Whole luxel_render() calls of the best instruction set: by one thread and by all, for 1 and for 16 sources."""
    environment = dict(os.environ, LUXEL_ISA="", LC_ALL="C.UTF-8", LANGUAGE="")
    result = subprocess.run([build(folder, "time_kernels")], capture_output=True, text=True, check=True,
                            env=environment)
    return json.loads(result.stdout)


def keep_best(row, other):
    """Of two measurements of a row: the better time by one thread, and by all; the floor is of the former's run."""
    if other["one_thread_ms"] < row["one_thread_ms"]:
        row.update({key: other[key] for key in other if not key.startswith("all_threads")})
    if other["all_threads_ms"] < row["all_threads_ms"]:
        row.update({key: other[key] for key in other if key.startswith("all_threads")})


def best_of(bench, case):
    best = bench["machine"]["instruction_sets"][0]["name"]
    return next(each for each in bench["timings"] if each["case"] == case and each["instruction_set"] == best)


def main():
    folder = os.path.abspath(sys.argv[1])
    luxel = os.path.join(folder, "cli", "luxel")
    peers = Peers(folder)
    bench, times = None, {}
    for _ in range(ROUNDS):  # in turn, so that all meet the same moods of the machine
        now = own_times(folder)
        rows = {(each["case"], each["instruction_set"]): each for each in now["timings"]}
        if bench:
            for each in bench["timings"]:
                keep_best(each, rows[each["case"], each["instruction_set"]])
        bench = bench or now
        for name, run in peers.all:
            for lights in (16, 1):
                words = run(lights)
                if words:
                    times[name, lights] = min(float(words[0]), times.get((name, lights), float("inf")))
    print_page(bench, times, peers)
    print_scenes(luxel, folder)
    print_matrix(folder)
    print()
    rooms.print_table(luxel)


def print_scenes(luxel, folder):
    """The pictures of all built-in scenes."""
    listed = subprocess.run([luxel, "scene", "--list"], capture_output=True, text=True, check=True,
                            env=dict(os.environ, LC_ALL="C.UTF-8", LANGUAGE="")).stdout
    program, names = matrix.program_of(folder), [line.split()[0] for line in listed.splitlines() if line.strip()]
    one, all_of_them = (matrix.measure(program, ROUNDS, names, threads, SIDE) for threads in (1, os.cpu_count()))
    print("\n## The built-in scenes\n")
    print("Whole `luxel_render()` calls, %d pixels along the longer side; by one thread processor time.\n" % SIDE)
    print("| scene | 1 thread, ms | %d threads, ms |\n|---|---:|---:|" % os.cpu_count())
    for row in zip(names, one, all_of_them):
        print("| %s | %.1f | %.1f |" % row)


def print_matrix(folder):
    """Sources by laws, models, surfaces and how near they stand."""
    print("\n## Extended sources\n")
    print("One source over a surface, %d × %d pixels, processor time of one thread; *far* stands 1 m and more away,"
          "\n*near* 100 mm off the sphere, *sky* is a disk of 10 km radius. *Worst*: the slowest law over"
          "\ninverse-square. Of the highlights that are in `phong` and `blinn-phong` all laws take the same samples."
          % (matrix.SIDE, matrix.SIDE))
    matrix.print_tables(matrix.times(folder, ROUNDS))


def print_page(bench, times, peers):
    machine = bench["machine"]
    print("# Performance\n")
    print("Written by `make bench` on one machine; absolute times are its own, and it was not alone on it. Compare the "
          "rows:\nall were measured in turn, the best of %d rounds counts.\n" % ROUNDS)
    print("Machine: %s, %d processors, Linux %s. Copying memory: %.0f GB/s.\n"
          % (processor(), os.cpu_count(), platform.release().split("-")[0],
             1e-9 * machine["copied_bytes_per_second"]))
    print("## Beside others\n")
    print("The exercise's picture, %d × %d pixels, all on the sphere, Blinn-Phong, shininess 20, inverse-square "
          "(POV-Ray:\nits own Phong, no attenuation). Luxel's times are whole `luxel_render()` calls, every pixel "
          "within 2e-6 of the maximum,\nwith the statistics; by all threads."
          % (SIDE, SIDE))
    if peers.drawn_by:
        print("The shader was drawn by %s, by all threads." % peers.drawn_by)
    print()
    print("| | 16 sources, ms | times Luxel | 1 source, ms | times Luxel |\n|---|---:|---:|---:|---:|")
    own = {16: best_of(bench, "point")["all_threads_ms"], 1: best_of(bench, "one-point")["all_threads_ms"]}
    alone = {16: best_of(bench, "point")["one_thread_ms"], 1: best_of(bench, "one-point")["one_thread_ms"]}
    print("| Luxel, all threads | %.2f | 1 | %.2f | 1 |" % (own[16], own[1]))
    print("| Luxel, one thread | %.2f | %.1f | %.2f | %.1f |"
          % (alone[16], alone[16] / own[16], alone[1], alone[1] / own[1]))
    for name, _ in peers.all:
        cells = []
        for lights in (16, 1):
            taken = times.get((name, lights))
            cells += ["–", "–"] if taken is None else ["%.2f" % taken, "%.3g" % (taken / own[lights])]
        if set(cells) != {"–"}:
            print("| %s | %s |" % (name, " | ".join(cells)))
    print("\n## Each kernel\n")
    print("By one thread and by all, in ms for the picture and in ns for each pixel and source. *Times floor*: against "
          "the products\nand sums of all sources at every pixel alone, at the rate that a loop of nothing else reached "
          "in the same run; below 1 where\npolynomials do for most pixels ([KERNELS.md](KERNELS.md)).\n")
    print("| case | set | sources | 1 thread, ms | ns | times floor | all threads, ms | ns |")
    print("|---|---|---:|---:|---:|---:|---:|---:|")
    for each in bench["timings"]:
        floor = "" if each["times_floor"] is None else "%.1f" % each["times_floor"]
        digits = 4 if each["lights"] > 1000 else 2
        print("| %s | %s | %d | %.2f | %.*f | %s | %.2f | %.*f |"
              % (each["case"], each["instruction_set"], each["lights"], each["one_thread_ms"],
                 digits, each["one_thread_ns"], floor, each["all_threads_ms"], digits, each["all_threads_ns"]))
    print("\nProducts and sums of float32 that one thread formed in a second: %s."
          % ", ".join("%s %.0f billion" % (each["name"], 1e-9 * each["products_per_second"])
                      for each in machine["instruction_sets"]))


main()
