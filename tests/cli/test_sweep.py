# SPDX-License-Identifier: MIT
"""luxel sweep: the same bytes for any number of workers, after kills and in parts; scenes equal `luxel render`; studies
that are wrong; folders that are another's, in use, full or not writable; what is kept of each scene; merging."""
import hashlib
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import time

import numpy
import yaml

from tap import Tap
from tool import run_tests, wait_until_caught

STUDY = """study: 1
scene: report
set: ['screen.resolution=[24,24]']
count: 600
seed: 7
shard: 50
vary:
  - {key: 'lights[0].position', random: box, from: [-2000, -2000, 1500], to: [2000, 2000, 4000]}
  - {key: 'surfaces[0].material.shininess', random: log, from: 5, to: 200}
outputs: {brightness: float32}
"""


def contents(tool, folder):
    """Every file below a folder, by its name, hidden ones included."""
    found = {}
    for where, _, files in os.walk(tool.file(folder)):
        for name in files:
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, tool.file(folder))] = hashlib.sha256(file.read()).hexdigest()
    return found


def whole(tool, folder):
    with open(tool.file(folder + "/manifest.json"), encoding="utf-8") as file:
        return json.load(file)


def workers(tap, tool):
    tool.write("s.yaml", STUDY)
    result = tool.run("sweep", "s.yaml", "-o", "one", "--workers", "1")
    tap.equal((result.code, result.err), (0, ""), "a sweep by one worker")
    expected = contents(tool, "one")
    tap.equal(len(expected), 1 + 12 * 3, "a manifest, and three files a shard")
    for count in (2, 4):
        tool.run("sweep", "s.yaml", "-o", "of%d" % count, "--workers", str(count), "-q")
        tap.ok(contents(tool, "of%d" % count) == expected, "%d workers, the same bytes" % count)
    for part in (2, 0, 1):
        tool.run("sweep", "s.yaml", "-o", "parts", "--shard", "%d/3" % part, "-q")
        tap.equal(whole(tool, "parts")["complete"], part == 1, "part %d of 3" % part)
    tap.ok(contents(tool, "parts") == expected, "three parts, the same bytes")
    for part in (1, 2):
        tool.run("sweep", "s.yaml", "-o", "halves", "--shard", "%d/2" % part, "-q")
    tap.ok(contents(tool, "halves") == expected, "two parts counted from 1, the same bytes")
    manifest = whole(tool, "one")
    tap.equal({name: sum for name, sum in expected.items() if name != "manifest.json"}, manifest["files"],
              "the manifest's sums")
    check = subprocess.run(["sha256sum", "-c", "--quiet", "SHA256SUMS"], cwd=tool.file("one/shard-000003"),
                           capture_output=True, text=True, check=False)
    tap.equal((check.returncode, check.stdout), (0, ""), "sha256sum -c")
    tap.equal((manifest["scenes"], manifest["shards"], manifest["complete"]), (600, 12, True), "the manifest's numbers")
    before = os.stat(tool.file("one/shard-000003/brightness.npy")).st_mtime_ns
    os.remove(tool.file("one/shard-000005/brightness.npy"))
    os.truncate(tool.file("one/shard-000007/parameters.npy"), 1000)
    result = tool.run("sweep", "s.yaml", "-o", "one")
    tap.ok(contents(tool, "one") == expected and "now: 100" in result.out, "what is missing is computed again",
           result.out)
    tap.equal(os.stat(tool.file("one/shard-000003/brightness.npy")).st_mtime_ns, before, "and nothing else")


def scenes(tap, tool):
    tool.write("s.yaml", STUDY)
    tool.run("sweep", "s.yaml", "-o", "data", "-q")
    for i in (0, 411, 599):
        shown = tool.run("sweep", "s.yaml", "--show", str(i))
        tool.write("scene.yaml", shown.out)
        tool.run("render", "scene.yaml", "-o", "scene.npy", "-q")
        shard = numpy.load(tool.file("data/shard-%06d/brightness.npy" % (i // 50)))
        tap.ok((shard[i % 50] == numpy.load(tool.file("scene.npy"))).all() and shard[i % 50].max() > 0,
               "scene %d is that of luxel render" % i)
        row = numpy.load(tool.file("data/shard-%06d/parameters.npy" % (i // 50)))[i % 50]
        position = "[%s]" % ", ".join(repr(float(x)) for x in row[:3])
        tap.ok(position in shown.out and "shininess: %r" % float(row[3]) in shown.out, "its parameters are those shown",
               row, shown.out)
    row = numpy.concatenate([numpy.load(tool.file("data/shard-%06d/parameters.npy" % k)) for k in range(12)])
    low, high = numpy.array([-2000, -2000, 1500, 5]), numpy.array([2000, 2000, 4000, 200])
    tap.ok((row >= low).all() and (row <= high).all(), "drawn within the ranges")
    share = (row[:, :3] - low[:3]) / (high - low)[:3]
    tap.ok(abs(share.mean() - .5) < .04 and abs(share.std() - 12 ** -.5) < .02, "evenly", share.mean(), share.std())
    logs = numpy.log(row[:, 3] / 5) / math.log(40)
    tap.ok(abs(logs.mean() - .5) < .06 and abs(logs.std() - 12 ** -.5) < .03, "evenly in the logarithm", logs.mean())
    result = tool.run("sweep", "s.yaml", "--show", "600")
    tap.ok(result.code == 2 and "600 scenes" in result.err, "no scene 600", result.err)


def grids(tap, tool):
    tool.write("g.yaml", """study: 1
set: ['screen.resolution=[8, 8]']
shard: 5
vary:
  - {key: 'surfaces[0].material.model', values: [blinn-phong, phong, lambert]}
  - {key: 'lights.0.position[2]', from: 1500, to: 2500, steps: 5}
outputs: {brightness: float64, statistics: float64}
""")
    result = tool.run("sweep", "g.yaml", "--dry-run", "--json").json()
    tap.equal((result["scenes"], result["shards"]), (15, 3), "a grid's count is its product")
    tool.run("sweep", "g.yaml", "-o", "grid", "-q")
    rows = numpy.concatenate([numpy.load(tool.file("grid/shard-00000%d/parameters.npy" % k)) for k in range(3)])
    tap.equal(rows.tolist(), [[m, z] for m in range(3) for z in (1500, 1750, 2000, 2250, 2500)], "in order")
    size = sum(os.path.getsize(os.path.join(where, name)) for where, _, names in os.walk(tool.file("grid"))
               for name in names if name.endswith(".npy"))
    tap.equal(size, result["bytes"], "as many bytes as --dry-run tells")
    tap.equal(whole(tool, "grid")["parameters"][0]["values"], ["blinn-phong", "phong", "lambert"],
              "words in the manifest")
    tool.write("scene.yaml", tool.run("sweep", "g.yaml", "--show", "7").out)
    tool.run("render", "scene.yaml", "--precision", "double", "-o", "scene.npy", "-q")
    shard = numpy.load(tool.file("grid/shard-000001/brightness.npy"))
    tap.ok((shard[2] == numpy.load(tool.file("scene.npy"))).all(), "float64 is --precision double")
    statistics = numpy.load(tool.file("grid/shard-000001/statistics.npy"))
    tap.ok((statistics[:, 0] == shard.max(axis=(1, 2))).all(), "the maximum of each")


def outputs(tap, tool):
    tool.write("o.yaml", """study: 1
scene: two-spheres
set: ['screen.resolution=[40, 32]', 'points=[[0, 0], [100, 0]]']
count: 6
vary: [{key: 'lights[0].position', random: sphere, center: [0, 0, 1000], radius: 3000},
       {key: units, random: choice, values: [radiometric, photometric]}]
outputs: {brightness: float16, irradiance: float32, mask: uint8, normals: float64, depth: float64, probes: float64,
          statistics: float32, light_positions: float64, positions: float64, surfaces: int32}
""")
    result = tool.run("sweep", "o.yaml", "-o", "all", "-q")
    tap.equal((result.code, result.err), (0, ""), "all outputs")
    load = {name: numpy.load(tool.file("all/shard-000000/%s.npy" % name)) for name in (
        "brightness", "irradiance", "mask", "normals", "depth", "probes", "statistics", "light_positions",
        "positions", "surfaces", "parameters")}
    for i in (0, 5):
        tool.write("scene.yaml", tool.run("sweep", "o.yaml", "--show", str(i)).out)
        tool.run("render", "scene.yaml", "-o", "b.npy", "-q")
        single = numpy.load(tool.file("b.npy"))
        tap.ok((load["brightness"][i] == single.astype(numpy.float16)).all(), "float16 is the nearest")
        tool.run("render", "scene.yaml", "--quantity", "irradiance", "-o", "e.npy", "-q")
        tap.ok((load["irradiance"][i] == numpy.load(tool.file("e.npy"))).all(), "irradiance")
        probes = tool.run("probe", "scene.yaml", "--json").json()["points"]
        found = [math.nan if p["value"] is None else p["value"] for p in probes]
        tap.ok(numpy.array_equal(load["probes"][i], found, equal_nan=True), "probes", load["probes"][i], found)
        for p in probes:
            column, row = p["pixel"]
            tap.equal(bool(load["mask"][i][row][column]), p["on_surface"], "the mask")
        places, owners = load["positions"][i][load["mask"][i] == 1], load["surfaces"][i][load["mask"][i] == 1]
        balls = yaml.safe_load(tool.read("scene.yaml"))["surfaces"]
        away = numpy.stack([numpy.linalg.norm(places - ball["center"], axis=1) - ball["radius"] for ball in balls])
        tap.ok((owners == numpy.abs(away).argmin(0)).all() and numpy.abs(away).min(0).max() < 1e-9 and
               set(owners) == {0, 1} and (load["surfaces"][i][load["mask"][i] == 0] == -1).all(), "places, surfaces")
        shown = tool.run("probe", "scene.yaml", "--json", "--quantity", "irradiance", *[
            word for place, normal in list(zip(places, load["normals"][i][load["mask"][i] == 1]))[::37]
            for word in ("--at", ",".join(repr(float(x)) for x in (*place, *normal)))]).json()["points"]
        tap.ok(numpy.allclose([p["value"] for p in shown], load["irradiance"][i][load["mask"][i] == 1][::37], rtol=1e-5,
                              atol=1e-5), "places and normals are those of the pixels")
    place = load["light_positions"][:, 0]
    tap.ok(numpy.allclose(numpy.linalg.norm(place - [0, 0, 1000], axis=1), 3000), "places on the sphere")
    tap.ok((place == load["parameters"][:, :3]).all(), "light positions are the parameters")
    size = numpy.linalg.norm(load["normals"], axis=3)
    tap.ok(numpy.allclose(size[load["mask"] == 1], 1) and (size[load["mask"] == 0] == 0).all(), "unit normals")
    tap.ok((load["normals"][..., 2][load["mask"] == 1] > 0).all(), "towards the observer")
    tap.ok((load["depth"][load["mask"] == 0] == 0).all() and (load["depth"][load["mask"] == 1] > 0).all(), "depths")
    tool.write("o.yaml", tool.read("o.yaml").decode().split("outputs")[0] + "outputs: {light_positions: lp}")
    tool.run("sweep", "o.yaml", "-o", "lp", "-q")
    lines = tool.read("lp/shard-000000/light_positions.lp").decode().split("\n")
    direction = (place[5] - whole_center(tool)) / numpy.linalg.norm(place[5] - whole_center(tool))
    tap.ok(lines[0] == "6" and numpy.allclose([float(x) for x in lines[6].split()[1:4]], direction, atol=1e-8), "lp",
           lines, direction)


def whole_center(tool):
    scene = tool.run("probe", "two-spheres", "-p", "0,0", "--json")
    assert scene.code == 0
    import yaml
    return numpy.array(yaml.safe_load(tool.run("scene", "two-spheres").out)["surfaces"][0]["center"], dtype=float)


WRONG = [
    ("studdy: 1", ["s.yaml:1:1", "unknown key", "did you mean", "study"]),
    ("study: 2", ["s.yaml:1:8", "study"]),
    ("study: 1\nscene: reprt", ["s.yaml:2:8", "reprt", "did you mean", "report"]),
    ("study: 1\nscene: none.yaml", ["s.yaml:2:8", "none.yaml"], 4),
    ("study: 1\nset: 5", ["s.yaml:2:6", "KEY=VALUE"]),
    ("study: 1\nset: ['lights[0].intensty=5']", ["s.yaml:2:7", "intensty", "intensity"]),
    ("study: 1\nset: ['lights[0].intensity=-5']", ["s.yaml:2:6", "intensity"]),
    ("study: 1\nvary: [{key: 'lights[7].intensity', values: [1]}]", ["s.yaml:2:14", "lights"]),
    ("study: 1\nvary: [{key: 'lights[0].intensty', values: [1]}]", ["s.yaml:2:14", "intensity"]),
    ("study: 1\nvary: [{key: 'lights[0].intensity'}]", ["s.yaml:2:14", "say how"]),
    ("study: 1\nvary: [{key: 'lights[0].intensity', values: []}]", ["s.yaml:2:45", "at least one"]),
    ("study: 1\nvary: [{key: 'lights[0].intensity', values: [1, -3, x]}]",
     ["s.yaml:2:49", "s.yaml:2:53", "values[1]", "values[2]", "≥ 0"]),
    ("study: 1\nvary: [{key: 'surfaces[0].material.model', values: [phong, lambrt]}]", ["2:60", "lambert"]),
    ("study: 1\nvary: [{key: 'surfaces[0].material.model', from: 1, to: 2, steps: 3}]", ["2:50", "no numbers"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].position', random: box, from: [0, 0], to: [1, 1, 1]}]",
     ["3:55", "3 numbers"]),
    ("study: 1\nvary: [{key: 'lights[0].intensity', random: uniform, from: 0, to: 1}]", ["1:1", "missing key count"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].intensity', random: log, from: 0, to: 1}]", ["3:56", "above 0"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].intensity', random: unifrm, from: 0, to: 1}]", ["3:45", "uniform"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].intensity', random: uniform, from: 0}]", ["3:8", "missing key to"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].intensity', random: sphere, center: [0, 0, 0], radius: 1}]",
     ["3:45", "three numbers"]),
    ("study: 1\nvary: [{key: 'lights[0].intensity', values: [1], steps: 3}]",
     ["2:57", "steps does not go with values"]),
    ("study: 1\ncount: 3\nvary: [{key: 'lights[0].intensity', values: [1, 2]}]", ["2:8", "2 scenes"]),
    ("study: 1\nvary: [{key: 'lights[0].position', values: [[0, 0, 2000]]},\n"
     "       {key: 'lights.0.position[1]', values: [1]}]", ["varies already"]),
    ("study: 1\nvary: [{key: screen.resolution, values: [[8, 8]]}]", ["2:14", "same size"]),
    ("study: 1\ncount: 2000000000000\nvary: [{key: observer.z, random: uniform, from: 1500, to: 1600}]",
     ["2:8", "count", "4294967295"]),
    ("study: 1\nseed: -1", ["2:7", "seed", "4294967295"]),
    ("study: 1\noutputs: {brightness: float8}", ["2:23", "float16, float32, float64"]),
    ("study: 1\noutputs: {brigthness: float32}", ["2:11", "did you mean", "brightness"]),
    ("study: 1\nshard: 0", ["2:8", "shard"]),
    ("study: 1\nscene: report\nset: ['lights[0].intensty=5']\ncount: -3\n"
     "vary: [{key: 'lights[0].power', values: [-1]}]", ["3:7", "4:8", "5:42"]),
    ("study: 1\nscene: report\nset: ['lights[0].intensty=5']\nvary: [{values: [-1]}, {key: 5, steps: 2}]",
     ["3:7", "4:8", "4:30"]),
    ("[1, 2]", ["1:1", "mapping"]),
    ("", ["1:1"]),
    ("study: 1\nstudy: 1", ["2:1", "study"]),
]


def wrong(tap, tool):
    for text, expected, *code in WRONG:
        tool.write("s.yaml", text)
        result = tool.run("sweep", "s.yaml", "-o", "none")
        tap.ok(result.code == (code or [3])[0] and all(word in result.err for word in expected) and not os.path.exists(
            tool.file("none")), "refused: " + text.replace("\n", " | ")[:90], result.code, result.err, expected)
    tool.write("s.yaml", "study: 1\nset: ['screen.resolution=[8,8]']\n"
               "vary: [{key: 'observer.z', values: [1500, 1600, 900]}]")
    result = tool.run("sweep", "s.yaml", "-o", "late")
    tap.ok(result.code == 3 and "scene 2 of the study" in result.err and "observer" in result.err,
           "a wrong scene is named", result.err)
    for arguments, code, words in ((["s.yaml"], 2, "-o FOLDER"), ([], 2, "study file"),
                                   (["no.yaml", "-o", "x"], 4, "no.yaml"),
                                   (["s.yaml", "-o", "x", "--shard", "5/4"], 2, "part 5 of 4"),
                                   (["s.yaml", "-o", "x", "--shard", "5"], 2, "I/N"),
                                   (["s.yaml", "-o", "x", "--workers", "0"], 2, "--workers"),
                                   (["s.yaml", "-o", "/proc/nothing"], 4, "/proc/nothing"),
                                   (["s.yaml", "-o", "s.yaml"], 4, "s.yaml")):
        result = tool.run("sweep", *arguments)
        tap.ok(result.code == code and words in result.err, "sweep " + " ".join(arguments), result.code, result.err)


def folders(tap, tool):
    tool.write("s.yaml", STUDY)
    tool.run("sweep", "s.yaml", "-o", "data", "-q")
    before = contents(tool, "data")
    tool.write("s.yaml", STUDY.replace("seed: 7", "seed: 8"))
    result = tool.run("sweep", "s.yaml", "-o", "data")
    tap.ok(result.code == 4 and "another sweep" in result.err and contents(tool, "data") == before,
           "a changed study is refused, and nothing changes", result.err)
    tool.write("s.yaml", "# a comment\n" + STUDY.replace("seed: 7", "seed:   7"))
    tap.equal(tool.run("sweep", "s.yaml", "-o", "data").code, 0, "a comment is no change")
    tool.write("c.csv", "x,y,z,intensity\n500,0,2000,10\n")
    tool.write("c.yaml", "study: 1\nset: ['screen.resolution=[8,8]', 'lights=[{type: points, file: c.csv}]']\n"
               "vary: [{key: 'surfaces[0].material.diffuse', values: [0.1, 0.2]}]")
    tap.equal(tool.run("sweep", "c.yaml", "-o", "cloud", "-q").code, 0, "a scene that names a file")
    tap.equal(tool.run("sweep", "c.yaml", "-o", "cloud", "-q").code, 0, "the same again")
    tool.write("c.csv", "x,y,z,intensity\n500,0,2000,20\n")
    result = tool.run("sweep", "c.yaml", "-o", "cloud", "-q")
    tap.ok(result.code == 4 and "another sweep" in result.err, "another content of that file is another sweep",
           result.code, result.err)
    tool.write("long.yaml", STUDY.replace("600", "100000").replace("24,24", "64,64").replace("d: 50", "d: 2000"))
    first = subprocess.Popen([tool.path, "sweep", "long.yaml", "-o", "busy", "--workers", "1"], cwd=tool.folder,
                             stderr=subprocess.PIPE, text=True)
    wait_for(lambda: os.path.exists(tool.file("busy/.work-0-1/shard-000000")))
    result = tool.run("sweep", "long.yaml", "-o", "busy")
    tap.ok(result.code == 4 and "process %d" % first.pid in result.err, "two sweeps in one folder", result.err)
    wait_until_caught(first)
    first.send_signal(signal.SIGINT)
    tap.equal(first.wait(60), 130, "Ctrl-C")
    left = sorted(os.listdir(tool.file("busy")))
    tap.ok("manifest.json" in left and all(not name.startswith(".") for name in left), "leaves only what is done", left)
    size = 60000

    def limited():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    small = STUDY.replace("600", "60")
    tool.write("s.yaml", small.replace("shard: 50", "shard: 50"))
    result = tool.run("sweep", "s.yaml", "-o", "full", preexec_fn=limited)
    tap.ok(result.code == 4 and "cannot be written" in result.err and "is kept" in result.err,
           "a file that cannot grow", result.code, result.err)
    left = sorted(os.listdir(tool.file("full")))
    tap.ok("shard-000000" not in left and not any(name.startswith(".") for name in left), "no half shard", left)
    tool.run("sweep", "s.yaml", "-o", "full", "-q")
    tool.run("sweep", "s.yaml", "-o", "fresh", "-q")
    tap.ok(contents(tool, "full") == contents(tool, "fresh"), "and goes on when it can")


def wait_for(condition, seconds=30, pause=0.005):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(pause)
    assert condition()


def kills(tap, tool):
    """Killed at random moments, the same bytes whenever one gets through; LUXEL_SWEEP_KILLS=200 for more of them."""
    wanted = int(os.environ.get("LUXEL_SWEEP_KILLS", "6"))
    rng = random.Random(1)
    tool.write("s.yaml", STUDY)
    begin = time.monotonic()
    tool.run("sweep", "s.yaml", "-o", "expected", "-q")
    whole = time.monotonic() - begin
    expected = contents(tool, "expected")
    killed = finished = 0
    wrong = []
    for i in range(20 * wanted):
        if killed >= wanted:
            break
        process = subprocess.Popen([tool.path, "sweep", "s.yaml", "-o", "killed", "-q", "--workers",
                                    str(rng.choice((1, 2, 4)))], cwd=tool.folder)
        if i == 0:  # certainly at work: the first shard is not whole yet
            wait_for(lambda: os.path.exists(tool.file("killed")) and any(
                name.startswith(".work") for name in os.listdir(tool.file("killed"))), pause=0)
            process.kill()
        try:
            process.wait(rng.uniform(0.002, whole / 3))
        except subprocess.TimeoutExpired:
            process.send_signal(rng.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT)))
        code = process.wait(60)
        killed += code != 0
        if code == 0:  # got through in spite of it: all of it anew
            finished += 1
            if contents(tool, "killed") != expected:
                wrong.append(i)
            shutil.rmtree(tool.file("killed"))
    tap.ok(killed >= wanted, "%d were killed at work" % killed, wanted, finished)
    tap.equal(wrong, [], "the same bytes each of the %d times that a sweep got through" % finished)
    tool.run("sweep", "s.yaml", "-o", "killed", "-q")
    tap.ok(contents(tool, "killed") == expected, "the same bytes after the kills")


def has_hdf5(tool):
    return os.path.exists(os.path.join(os.path.dirname(tool.path), "luxel-hdf5"))


def merging(tap, tool):
    tool.write("s.yaml", STUDY)
    os.mkdir(tool.file("empty"))
    for name in ("nowhere", "empty"):
        result = tool.run("sweep", "s.yaml", "-o", name, "--merge", "brightness.npy")
        tap.ok(result.code == 4 and name + "/manifest.json" in result.err, "nothing to merge in " + name, result.err)
    tap.ok(not os.path.exists(tool.file("nowhere")) and os.listdir(tool.file("empty")) == [], "no folder is begun")
    tool.run("sweep", "s.yaml", "-o", "data", "--shard", "0/2", "-q")
    result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", "brightness.npy")
    tap.ok(result.code == 4 and "shard 1 is missing" in result.err, "an incomplete sweep is not merged", result.err)
    tool.run("sweep", "s.yaml", "-o", "data", "-q")
    before = contents(tool, "data")
    for name in ("brightness", "parameters"):
        result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", name + ".npy")
        tap.equal((result.code, result.err), (0, ""), "merging %s" % name)
        parts = [numpy.load(tool.file("data/shard-%06d/%s.npy" % (k, name))) for k in range(12)]
        tap.ok(numpy.array_equal(numpy.load(tool.file(name + ".npy")), numpy.concatenate(parts)), "its numbers")
    tap.ok(contents(tool, "data") == before, "the folder stays as it is")
    damaged = tool.file("data/shard-000002/brightness.npy")
    for at in 128 + 4 * 24 * 24, -1:
        data = bytearray(tool.read(damaged))
        data[at] ^= 1
        tool.write(damaged, bytes(data))
        for name in ["brightness.npy"] + ["damaged.h5"] * has_hdf5(tool):
            os.path.exists(tool.file(name)) and os.remove(tool.file(name))
            result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", name)
            tap.ok(result.code == 4 and "shard-000002/brightness.npy is damaged" in result.err and
                   result.err.count("error") == 1 and not os.path.exists(tool.file(name)), "a flipped bit: " + name,
                   result.err)
        tap.equal(tool.run("sweep", "s.yaml", "-o", "data", "--merge", "parameters.npy").code, 0, "it is not in others")
        data[at] ^= 1
        tool.write(damaged, bytes(data))
    tap.ok(contents(tool, "data") == before and
           tool.run("sweep", "s.yaml", "-o", "data", "--merge", "brightness.npy").code == 0, "put right")
    result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", "depth.npy")
    tap.ok(result.code == 2 and "depth.npy" in result.err, "an output that is not there", result.err)
    if not has_hdf5(tool):
        result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", "d.h5")
        tap.ok(result.code in (0, 4), "HDF5 is not built in", result.err)
        return
    for name in ("d.h5", "e.h5"):
        result = tool.run("sweep", "s.yaml", "-o", "data", "--merge", name)
        tap.equal((result.code, result.err), (0, ""), "merging %s" % name)
    tap.ok(tool.read("d.h5") == tool.read("e.h5"), "HDF5 files of the same bytes")
    try:
        import h5py
    except ImportError:
        tap.skip("HDF5 by h5py", "no h5py")
        return
    with h5py.File(tool.file("d.h5")) as file:
        tap.ok((file["brightness"][:] == numpy.load(tool.file("brightness.npy"))).all(), "its numbers, by h5py")
        tap.equal([list(axis.keys()) for axis in file["brightness"].dims], [["scene"], ["row"], ["column"]], "its axes")
        tap.equal(file.attrs["parameters"].decode().split("\n")[3], "surfaces[0].material.shininess", "its names")
    try:
        import netCDF4  # noqa: F401, what xarray reads HDF5 by
        import xarray
    except ImportError as error:
        tap.skip("HDF5 by xarray", error)
        return
    with xarray.open_dataset(tool.file("d.h5")) as file:
        tap.ok((file.brightness == numpy.load(tool.file("brightness.npy"))).all(), "its numbers, by xarray")
        tap.equal((file.brightness.dims, file.parameters.dims), (("scene", "row", "column"), ("scene", "parameter")),
                  "its axes, by xarray")


def instruction_sets(tap, tool):
    """A set that there is not spoils no folder."""
    tool.write("s.yaml", STUDY)
    for folder in "new", "data":
        if folder == "data":
            tool.run("sweep", "s.yaml", "-o", "data", "-q")
        before = contents(tool, folder)
        for more in ((), ("--merge", "brightness.npy"), ("--shard", "0/2")):
            result = tool.run("sweep", "s.yaml", "-o", folder, *more, environment={"LUXEL_ISA": "z80"})
            tap.ok(result.code == 2 and "LUXEL_ISA=z80" in result.err and contents(tool, folder) == before,
                   "LUXEL_ISA=z80, %s %s" % (folder, more), result.err)
    tap.ok(not os.path.exists(tool.file("new")), "no folder is begun")
    tap.equal(tool.run("sweep", "s.yaml", "-o", "new", "-q").code, 0, "and it works without")


def alone(tap, tool):
    """An HDF5 file that travels alone: names, words, units, places, the study and its seed are in it."""
    if not has_hdf5(tool):
        tap.skip("an HDF5 file that explains itself", "HDF5 is not built in")
        return
    try:
        import h5py
    except ImportError:
        tap.skip("an HDF5 file that explains itself, by h5py", "no h5py")
        return
    text = """study: 1   # a lamp
scene: two-spheres
set: ['screen.resolution=[20, 16]', 'points=[[0, 0], [100, 0]]']
count: 6
seed: 4294967295
shard: 4
vary:
  - {key: 'lights[0].position', random: sphere, center: [0, 0, 1000], radius: 3000}
  - {key: 'surfaces[0].material.model', random: choice, values: [lambert, phong, blinn-phong]}
outputs: {brightness: float16, irradiance: float32, mask: uint8, normals: float64, depth: float64, probes: float64,
          statistics: float32, light_positions: float64, positions: float32, surfaces: int32}
"""
    tool.write("a.yaml", text)
    tool.run("sweep", "a.yaml", "-o", "data", "-q")
    result = tool.run("sweep", "a.yaml", "-o", "data", "--merge", "a.h5")
    tap.equal((result.code, result.err), (0, ""), "merging all outputs")
    tool.write("scene.yaml", tool.run("sweep", "a.yaml", "--show", "0").out)
    tool.run("render", "scene.yaml", "-o", "picture.csv", "-q")
    rows = [line.split(",")[:2] for line in tool.read("picture.csv").decode().splitlines()[1:]]
    with h5py.File(tool.file("a.h5")) as file:
        parameters = file["parameters"]
        names = [entry["name"] for entry in whole(tool, "data")["parameters"]]
        tap.equal(list(parameters.attrs["names"]), names, "a name for each column")
        tap.equal(list(parameters.attrs["values_3"]), ["lambert", "phong", "blinn-phong"], "what its words stand for")
        tap.ok("values_0" not in parameters.attrs, "numbers have none")
        tap.equal(list(file["statistics"].attrs["names"]), ["maximum", "minimum", "mean", "lit", "surface_pixels"],
                  "names of the statistics")
        units = {name: file[name].attrs["units"].decode() for name in file if "units" in file[name].attrs}
        tap.equal(units, {"brightness": "W/(sr·m²)", "irradiance": "W/m²", "probes": "W/(sr·m²)", "mask": "1",
                          "normals": "1", "surfaces": "1", "depth": "mm", "positions": "mm",
                          "light_positions": "mm", "x_mm": "mm", "y_mm": "mm"}, "units")
        seen = file["mask"][0] == 1
        x, y = numpy.meshgrid(file["x_mm"][:], file["y_mm"][:])
        tap.ok(numpy.allclose(numpy.array(rows, float), numpy.stack([x[seen], y[seen]], 1)), "places of the pixels")
        tap.equal([list(file[name].dims[0].keys()) for name in ("x_mm", "y_mm")], [["column"], ["row"]], "its axes")
        attributes = {name: value.decode() if isinstance(value, bytes) else value for name, value in file.attrs.items()}
        tap.equal((int(attributes["seed"]), attributes["study"], attributes["instruction_set"]),
                  (4294967295, text, whole(tool, "data")["instruction_set"]), "seed, study and instruction set")
        tool.write("again.yaml", attributes["study"])
        tap.equal(tool.run("sweep", "again.yaml", "--dry-run", "--json").json()["identity"], attributes["identity"],
                  "the study is the sweep's")
    tool.write("b.yaml", STUDY.replace("'surfaces[0].material.shininess'", "screen.width").replace(
        "random: log, from: 5, to: 200", "values: [400]").replace(
            "['screen", "['screen.width=400', 'screen.height=400', 'screen"))
    tool.run("sweep", "b.yaml", "-o", "varied", "-q")
    tap.equal(tool.run("sweep", "b.yaml", "-o", "varied", "--merge", "b.h5").code, 0, "a screen that varies")
    with h5py.File(tool.file("b.h5")) as file:
        tap.ok("x_mm" not in file and "row" in file, "it has no places of its own")


def dry_runs(tap, tool):
    """What is timed is what is asked: a value that is too large for its type is found, and nothing is written."""
    tool.write("d.yaml", STUDY.replace("brightness: float32", "depth: float16").replace(
        "['screen", "['observer.z=100000', 'screen"))
    result = tool.run("sweep", "d.yaml", "--dry-run")
    tap.ok(result.code == 3 and "too large for its type" in result.err, "a depth that float16 does not hold", result)
    tool.write("d.yaml", STUDY.replace("brightness: float32", "depth: float16, normals: float16, surfaces: int32"))
    result = tool.run("sweep", "d.yaml", "--dry-run", "--json")
    tap.ok(result.code == 0 and result.json()["seconds_per_scene"] > 0 and tool.files() == ["d.yaml"],
           "and one that it does", result, tool.files())


def words(tap, tool):
    tool.write("s.yaml", STUDY)
    lines = tool.run("sweep", "s.yaml", "-o", "data", "--json").out.splitlines()
    events = [json.loads(line) for line in lines]
    tap.equal(([e["event"] for e in events], events[-1]["complete"], events[-1]["done"]),
              (["shard"] * 12 + ["end"], True, 600), "--json has a line for each shard")
    tap.equal(tool.run("sweep", "s.yaml", "-o", "data2", "-q").out, "", "-q says nothing")
    result = tool.run("help", "study")
    tap.ok(result.code == 0 and "vary[].random" in result.out and "sphere" in result.out, "luxel help study",
           result.out)
    result = tool.run("help", "study.seed")
    tap.ok(result.code == 0 and "seed" in result.out, "luxel help study.seed", result.out + result.err)
    try:
        import jsonschema
        import yaml
    except ImportError:
        tap.skip("the schema of studies", "no jsonschema")
        return
    validator = jsonschema.Draft7Validator(tool.run("schema", "study").json())
    tap.ok(validator.is_valid(yaml.safe_load(STUDY)), "the schema takes the study")
    tap.ok(not validator.is_valid(yaml.safe_load(STUDY.replace("seed", "sed"))), "and refuses a wrong key")


# A lamp that nearly touches two plates which cross: light changes within ten thousandths of a millimetre, too fast for
# a hundredth.
CROSSING = """luxel: 1
reflections: 1
screen: {width: 3000, height: 3000, resolution: [4, 4]}
observer: {z: 9000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [3000, 3000], material: {model: lambert, diffuse: 0.8, over_pi: true}}
  - {type: rectangle, center: [0, 0, 1], size: [1000, 100], axis: [0.9, 0, 0.5],
     material: {model: lambert, diffuse: 0.8, over_pi: true}}
lights: [{type: point, position: [0, 0, 0.0001], intensity: 1, attenuation: inverse-square}]
"""
CROSSINGS = """study: 1
scene: crossing.yaml
count: 2
shard: 2
vary: [{key: reflections, values: [none, 1]}]
outputs: {brightness: float32}
"""


def keys_of_all(tap, tool):
    """A key of all lights that have it is one axis."""
    tool.write("all.yaml", """study: 1
scene: three-lights
set: ['screen.resolution=[25,20]']
vary:
  - {key: 'lights[*].intensity', values: [1, 2]}
outputs: {brightness: float32}
""")
    result = tool.run("sweep", "all.yaml", "-o", "all", "-q")
    shard = numpy.load(tool.file("all/shard-000000/brightness.npy"))
    tool.run("render", "three-lights", "-s", "screen.resolution=[25,20]", "-s", "lights[*].intensity=2",
             "-o", "two.npy")
    tap.ok(result.code == 0 and (shard[1] == numpy.load(tool.file("two.npy"))).all(), "lights[*] in a study", result)
    wrong = tool.run("sweep", "-", "-o", "wrong", stdin="study: 1\nscene: three-lights\nvary:\n"
                     "  - {key: 'lights[*].intensty', values: [1]}\noutputs: {brightness: float32}\n")
    tap.ok(wrong.code == 3 and "intensity" in wrong.err, "and a key that none has", wrong)


def missed_bounds(tap, tool):
    tool.write("crossing.yaml", CROSSING)
    tool.write("s.yaml", CROSSINGS)
    result = tool.run("sweep", "s.yaml", "-o", "data", "-q")
    tap.ok(result.code == 5 and "of 1 scene " in result.err and "should be: scene 1" in result.err,
           "scenes whose reflected light is less exact than it should be are told", result)
    tap.ok(whole(tool, "data")["complete"], "and kept")
    result = tool.run("sweep", "s.yaml", "-o", "data2", "--json")
    tap.equal((result.code, json.loads(result.out.splitlines()[-1])["reflected_missed"]), (5, 1), "in JSON, too")
    result = tool.run("sweep", "s.yaml", "-o", "data", "-q")
    tap.equal((result.code, result.err), (0, ""), "nothing is left to compute, and nothing to tell")


tap = Tap()
run_tests(tap, workers, scenes, grids, outputs, wrong, folders, kills, merging, instruction_sets, alone, dry_runs,
          words, missed_bounds, keys_of_all)
tap.finish()
