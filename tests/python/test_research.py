# SPDX-License-Identifier: MIT
"""Studies that go on, cameras against geometry, noise by counter, and functions with gradients through a stand-in of
torch, which has the few names that are used of it."""
import os
import struct
import sys
import types
import zlib

import numpy

from package import Tap, luxel, raises, run_tests

STUDY = {"study": 1, "scene": "report", "set": ["screen.resolution=[16, 16]"], "count": 5, "seed": 7, "shard": 2,
         "vary": [{"key": "lights[0].intensity", "random": "log", "from": 1, "to": 100},
                  {"key": "surfaces[0].material.model", "random": "choice", "values": ["phong", "lambert"]}],
         "outputs": {"brightness": "float32"}}


def studies(tap, tool):
    study = luxel.Study(STUDY)
    tap.equal((len(study), study.shard, study.keys),
              (5, 2, ["lights[0].intensity", "surfaces[0].material.model"]), "what it is")
    told = [study.parameters(i) for i in range(5)]
    tap.ok(all(scene["lights[0].intensity"] == one["lights[0].intensity"] and
               scene["surfaces[0].material.model"] == one["surfaces[0].material.model"]
               for scene, one in zip(study, told)) and study[-1].text == study[4].text, "its scenes", told)
    calls = []

    def work(scene):
        calls.append(1)
        if len(calls) == 4:
            raise RuntimeError("power cut")
        return numpy.asarray(scene.render())

    folder = os.path.join(tool.folder, "kept")
    tap.ok(raises(RuntimeError, lambda: study.map(work, folder)), "the work is interrupted")
    tap.equal(sorted(os.listdir(folder)), ["shard-000000.npy", "study.txt"], "whole shards are kept")
    whole = study.map(work, folder)
    tap.equal((len(calls), whole.shape), (4 + 3, (5, 16, 16)), "and not computed again")
    tap.ok((whole == study.map(lambda scene: numpy.asarray(scene.render()))).all(), "the same without a folder")
    other = luxel.Study(dict(STUDY, seed=8))
    tap.ok(raises(ValueError, lambda: other.map(work, folder)), "a folder belongs to one study")
    tap.ok(raises(IndexError, lambda: study[5]) and
           raises(luxel.LuxelError, lambda: luxel.Study({"study": 1, "scene": "nothing"})) and
           raises(luxel.LuxelError, lambda: luxel.Study("none.yaml")), "what is refused")


def cameras(tap, tool):
    for sampling in ("nodes", "centers"):
        scene = luxel.Scene({"luxel": 1, "screen": {"width": 500, "height": 400, "resolution": [100, 80],
                                                    "sampling": sampling},
                             "observer": {"position": [300, -200, 1500], "target": [50, 20, 0],
                                          "projection": "perspective"},
                             "surfaces": [{"type": "sphere", "center": [0, 0, 0], "radius": 150}], "lights": []})
        camera, seen = scene.camera(), scene.geometry()
        row, column = numpy.nonzero(seen.mask)
        off = camera.project(seen.positions_mm[seen.mask]) - numpy.stack([column, row], -1)
        tap.ok(numpy.abs(off).max() < 1e-9, "pixels are where geometry says: " + sampling, numpy.abs(off).max())
        tap.ok(numpy.abs(camera.R @ camera.R.T - numpy.eye(3)).max() < 1e-12 and numpy.linalg.det(camera.R) > 0,
               "the turning is one")
    back = scene.changed(luxel.Camera(camera.K, camera.R, camera.t, (100, 80)).keys())
    again = back.camera()
    tap.ok(all(numpy.allclose(a, b, rtol=1e-9, atol=1e-9) for a, b in zip(again[:3], camera[:3])), "and back", again)
    plain = luxel.Scene("sphere").changed({"observer.projection": "perspective"}).camera()
    tap.ok(numpy.allclose(plain.R, numpy.diag([1, -1, -1])) and plain.t[2] > 0, "an observer on the z axis", plain)
    shifted = camera._replace(K=camera.K + numpy.array([[0, 0, 5], [0, 0, 0], [0, 0, 0]]))
    skewed = camera._replace(K=camera.K + numpy.array([[0, 9, 0], [0, 0, 0], [0, 0, 0]]))
    tap.ok(raises(ValueError, shifted.keys) and raises(ValueError, skewed.keys) and
           raises(ValueError, luxel.Scene("report").camera), "what no observer sees so")


def noise(tap, tool):
    values = numpy.full(20000, 2.0)
    drawn = luxel.measured(values, noise="3%+0.08", seed=5, number=2)
    tap.ok(abs(drawn.std() - 0.1) < 0.003 and abs(drawn.mean() - 2) < 0.004, "as wide as is asked for", drawn.std())
    tap.ok((drawn == luxel.measured(values, noise="3%+0.08", seed=5, number=2)).all() and
           (drawn != luxel.measured(values, noise="3%+0.08", seed=5, number=3)).all(), "by counter")
    tap.equal(luxel.measured([0.26, 0.74, 3.0], saturated=2, quantum=0.5).tolist(), [0.5, 0.5, 2.0], "levels")
    tap.equal(luxel.measured([0.26, 0.74], quantum=0.5, truncated=True).tolist(), [0.0, 0.5], "rounded down")


class Foreign:
    """An array of a library that NumPy does not know: DLPack is all that it has."""

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **how):
        return self.array.__dlpack__(**how)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


def foreign_arrays(tap, tool):
    scene = luxel.Scene("report")
    points = numpy.array([(0.0, 0.0), (150.0, 0.0), (100.0, -50.0)])
    tap.equal(scene.jacobian("lights[0].intensity", Foreign(points)).tolist(),
              scene.jacobian("lights[0].intensity", points).tolist(), "places come by DLPack")
    places, normals = numpy.array([[0.0, 0.0, 1300.0]]), numpy.array([[0.0, 0.0, 1.0]])
    tap.equal(scene.jacobian("lights[0].intensity", elements=(Foreign(places), Foreign(normals))).tolist(),
              scene.jacobian("lights[0].intensity", elements=(places, normals)).tolist(), "pairs of them")
    values = numpy.array([2.0, 3.0])
    tap.equal(luxel.measured(Foreign(values.astype(numpy.float32)), quantum=0.5).tolist(), [2.0, 3.0], "values, too")


def filtered_png(levels):
    """A PNG of 16 bits in colour whose rows take all filters in turn, written from the standard's words."""
    rows, columns, channels = levels.shape
    plain = [row.astype(">u2").tobytes() for row in levels]
    step, lines = 2 * channels, []
    for number, row in enumerate(plain):
        above, kind, line = plain[number - 1] if number else bytes(len(row)), number % 5, bytearray()
        for i, byte in enumerate(row):
            left, up = row[i - step] if i >= step else 0, above[i]
            corner = above[i - step] if i >= step else 0
            near = min((left, up, corner), key=lambda one: abs(left + up - corner - one))
            line.append((byte - (0, left, up, (left + up) // 2, near)[kind]) & 255)
        lines.append(bytes([kind]) + bytes(line))

    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    head = struct.pack(">IIBBBBB", columns, rows, 16, 2, 0, 0, 0)
    packed = zlib.compress(b"".join(lines))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def stereo_sets(tap, tool):
    """Twelve lamps far away over a matt ball: the textbook's method finds its normals; a folder keeps them."""
    ways = [(numpy.cos(2.4 * i) * t, numpy.sin(2.4 * i) * t, -1) for i, t in enumerate(numpy.linspace(.1, .7, 12))]
    scene = luxel.Scene({"luxel": 1, "screen": {"width": 500, "height": 400, "resolution": [50, 40]},
                         "observer": {"position": [300, -200, 1500], "target": [50, 20, 0]},
                         "surfaces": [{"type": "sphere", "center": [0, 0, 0], "radius": 150,
                                       "material": {"model": "lambert"}}],
                         "lights": [{"type": "distant", "direction": list(way), "irradiance": 1 + i / 10}
                                    for i, way in enumerate(ways)]})
    made = scene.stereo()
    tap.equal((made.images.shape, made.mask.shape, made.normals.shape), ((12, 40, 50), (40, 50), (40, 50, 3)), "shapes")

    def off(given, close, name):
        lit = given.mask & (given.images > 0).all(0)
        rows = given.directions * given.intensities[:, None]
        found = numpy.linalg.lstsq(rows, given.images[:, lit], rcond=None)[0].T
        found /= numpy.linalg.norm(found, axis=1, keepdims=True)
        worst = numpy.abs(found - given.normals[lit]).max()
        tap.ok(lit.sum() > 200 and worst < close, name, worst)
    off(made, 1e-9, "normals are the ball's, as the viewer has them")
    folder = os.path.join(tool.folder, "ballPNG")
    made.write(folder)
    tap.ok({"001.png", "012.png", "mask.png", "filenames.txt", "light_directions.txt", "light_intensities.txt",
            "Normal_gt.npy"} <= set(os.listdir(folder)), "the files of the public sets", os.listdir(folder))
    back = luxel.StereoSet.read(folder)
    tap.ok((back.mask == made.mask).all() and numpy.allclose(back.directions, made.directions, atol=1e-15), "read back")
    off(back, 1e-3, "with what 16 bits leave")
    levels = numpy.random.default_rng(3).integers(0, 65536, (40, 50, 3))
    with open(os.path.join(folder, "001.png"), "wb") as file:
        file.write(filtered_png(levels))
    numpy.savetxt(os.path.join(folder, "light_intensities.txt"), numpy.tile([1.0, 2.0, 4.0], (12, 1)))
    read = luxel.StereoSet.read(folder)
    tap.ok(numpy.allclose(read.images[0], (levels / 65535 / [1, 2, 4]).mean(-1) * 7 / 3, rtol=1e-12), "in colour")
    with open(os.path.join(folder, "filenames.txt"), "a", encoding="utf-8") as file:
        file.write("013.png\n")
    tap.ok(raises(ValueError, lambda: luxel.StereoSet.read(folder)) and
           raises(ValueError, lambda: luxel.Scene("report").changed({"lights": [
               {"type": "ambient", "irradiance": 1}]}).stereo()), "what does not fit")


def stand_in():
    """As much of torch as is used: tensors are arrays, and a function keeps what its gradient is made from."""
    class Tensor(numpy.ndarray):
        detach = cpu = numpy_ = lambda self: self
        device = "cpu"

        def numpy(self):
            return numpy.asarray(self)

    class Function:
        @classmethod
        def apply(cls, *given):
            cls.context = types.SimpleNamespace()
            cls.last = cls
            Function.latest = cls
            return cls.forward(cls.context, *given)

    torch = types.ModuleType("torch")
    torch.autograd = types.SimpleNamespace(Function=Function)
    torch.as_tensor = lambda array, dtype=None, device=None: numpy.asarray(array, dtype).view(Tensor)
    return torch


def gradients(tap, tool):
    sys.modules.setdefault("torch", stand_in())
    torch = sys.modules["torch"]
    scene = luxel.Scene("report")
    keys = ["lights[0].position", "surfaces[0].material.diffuse"]
    points = [(0, 0), (150, 0), (100, -50)]
    numbers = torch.as_tensor(numpy.array([2000.0, 100.0, 2100.0, 0.7]))
    function = scene.torch_function(keys, points)
    values = function(numbers)
    there = scene.changed({"lights[0].position": [2000, 100, 2100], "surfaces[0].material.diffuse": 0.7})
    tap.equal(numpy.asarray(values).tolist(), [probe.value for probe in there.probe(points)], "values")
    weights = torch.as_tensor(numpy.array([1.0, -2.0, 0.5]))
    latest = torch.autograd.Function.latest
    pulled = latest.backward(latest.context, weights)
    tap.ok(numpy.allclose(pulled, numpy.asarray(weights) @ there.jacobian(keys, points), rtol=1e-12),
           "gradients are products with the derivatives", pulled)
    tap.ok(raises(ValueError, lambda: function(torch.as_tensor(numpy.ones(3)))), "so many numbers as keys have")


if __name__ == "__main__":
    run_tests(Tap(), studies, cameras, noise, foreign_arrays, stereo_sets, gradients)
