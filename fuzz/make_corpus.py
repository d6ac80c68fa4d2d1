# SPDX-License-Identifier: MIT
"""Writes the first inputs of the fuzz targets into fuzz/corpus/: what users have, and the wrong scenes of the tests.

    python3 fuzz/make_corpus.py BUILD      # BUILD/cli/luxel makes pictures and numbers
"""
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tests/cli"))
sys.path.insert(0, str(HERE.parent / "tests"))


def put(target, name, data):
    folder = HERE / "corpus" / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())


def scenes(luxel):
    listed = subprocess.run([luxel, "scene", "--list"], check=True, capture_output=True, text=True).stdout
    for name in [line.split()[0] for line in listed.split("\n") if line.strip()]:
        text = subprocess.run([luxel, "scene", name], check=True, capture_output=True).stdout
        put("scene", name + ".yaml", text)


def malformed():
    import malformed as pieces
    from tool import SCENE
    for i, (_, piece, replacement, _) in enumerate(pieces.PIECES):
        put("scene", "wrong-%03d.yaml" % i, SCENE.replace(piece, replacement.replace("^", ""), 1))


def pictures(luxel, folder):
    small = ["-s", "screen.resolution=[12, 12]"]
    for ending in ["png", "exr", "npy", "pfm", "csv"]:
        path = folder / ("a." + ending)
        subprocess.run([luxel, "render", "report", *small, "-o", path, "-q"], check=True, capture_output=True)
        data = path.read_bytes()
        if ending in ("png", "exr"):
            put("scene", "carried." + ending, data)
        if ending != "png":
            put("field", "a." + ending, bytes([["npy", "pfm", "csv", "exr"].index(ending)]) + data)
    subprocess.run([luxel, "render", "report", *small, "-o", folder / "d.npy", "--precision", "double", "-q"],
                   check=True, capture_output=True)
    put("field", "double.npy", b"\0" + (folder / "d.npy").read_bytes())


EDITS = [
    "report\nlights[0].intensity=20\nlights[0].name=lamp\n-lights[0].name\n"
    "+lights 1 {type: ambient, irradiance: 1}\n",
    "three-lights\n>lights 0 2\n-lights[1]\nsurfaces[0].material.shininess=1e3\n-lights[0]\n-lights[0]\n",
    "window\nlights[0].parts=4\nlights[0].parts=converged\n+points 0 [1, 2]\n>points 0 0\n-points[0]\n",
    "desk\n-grids\n+grids 0 {name: a, center: [0, 0, 0], size: [10, 10], n: [2, 2]}\npicture.range=[1, 2]\n",
    "all-sources\n-lights[8]\n-lights[7]\n-lights[6]\nscreen={width: 100, height: 100, resolution: [5, 5]}\n",
    "spot\nlights=[]\n+lights 0 {type: spot, position: [0, 0, 2000], inner: 1, outer: 2, intensity: 3}\n"
    "units=radiometric\n",
    "nothing\nlights[0]=5\nlights.0.x=1\nlights[99999999999999999999]=1\n=\nx\n+lights x\n>lights 1\n",
]


def meshes():
    import good_scenes
    put("mesh", "cube.off", b"\0" + good_scenes.FILES["cube.off"].encode())
    put("mesh", "cube.obj", b"\1" + good_scenes.FILES["cube.obj"].encode())
    put("mesh", "open.off", "\0OFF\n4 3 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n3 0 2 1\n3 0 1 3\n3 1 2 3\n")
    put("mesh", "comments.obj", "\1# a body\nv 0 0 1500\nv 90 0 1500 # corner\nv 0 90 1500\nv 0 0 1590\n"
        "f 1/1 3/2 2//3\nf -4 -3 -1\nf 2 3 4\nf 3 1 4\n")
    put("mesh", "huge.off", "\0OFF\n999999999 999999999 0\n1 2 3\n")


def main():
    luxel = sys.argv[1] + "/cli/luxel"
    rng = random.Random(1)
    scenes(luxel)
    malformed()
    with tempfile.TemporaryDirectory() as folder:
        pictures(luxel, pathlib.Path(folder))
    for i, text in enumerate(EDITS):
        put("edit", "edits-%d.txt" % i, text)
    meshes()
    for i in range(24):
        put("numbers", "random-%02d" % i, rng.randbytes(96))


main()
