# SPDX-License-Identifier: MIT
"""Sets for photometric stereo, in the files of the public ones: pictures, masks, light directions, normals."""
from __future__ import annotations

import os
import struct
import zlib
from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Tuple, Union

from ._arrays import floats
from ._settings import Lights

if TYPE_CHECKING:
    from ._arrays import Bools, Floats
    from ._scene import Scene

Path = Union[str, "os.PathLike[str]"]
_MARK = b"\x89PNG\r\n\x1a\n"


class StereoSet(NamedTuple):
    """Pictures of one view, each under one lamp, and what is known of them.

    Directions and normals are the viewer's: x to the right, y up, z towards the viewer.
    """

    images: "Floats"  #: lamps x rows x columns
    mask: "Bools"  #: rows x columns: where the object is
    directions: "Floats"  #: lamps x 3: from the middle of the object to each lamp, of length 1
    intensities: "Floats"  #: lamps: how strong each is there, the irradiance of what faces it
    normals: "Optional[Floats]" = None  #: rows x columns x 3, 0 off the object; None where they are not known

    def write(self, folder: Path) -> None:
        """Writes a folder as those of DiLiGenT: 001.png ... of 16 bits, filenames.txt, light_directions.txt,
        light_intensities.txt (three equal numbers a line), mask.png, and the normals as Normal_gt.npy."""
        import numpy

        os.makedirs(folder, exist_ok=True)
        greatest = float(self.images.max()) or 1.0
        names = ["%03d.png" % (i + 1) for i in range(len(self.images))]
        for name, image in zip(names, self.images):
            levels = numpy.rint(numpy.clip(image / greatest, 0, 1) * 65535).astype(">u2")
            _put(os.path.join(folder, name), _png_of(levels))
        _put(os.path.join(folder, "mask.png"), _png_of(numpy.where(self.mask, 255, 0).astype("u1")))
        _put(os.path.join(folder, "filenames.txt"), "".join(name + "\n" for name in names).encode())
        numpy.savetxt(os.path.join(folder, "light_directions.txt"), self.directions, "%.17g")
        # pictures are shares of the greatest value, and so is what lit them
        numpy.savetxt(os.path.join(folder, "light_intensities.txt"),
                      numpy.repeat(self.intensities[:, None] / greatest, 3, 1), "%.17g")
        if self.normals is not None:
            numpy.save(os.path.join(folder, "Normal_gt.npy"), self.normals)

    @staticmethod
    def read(folder: Path) -> "StereoSet":
        """Reads such a folder: pictures of 8 or 16 bits, grey or in colour, of which the channels' mean by the lamp's
        intensity in each is taken; normals from Normal_gt.npy or, with SciPy, from Normal_gt.mat, if they are there.

        ValueError: a picture is no such PNG, or numbers do not fit each other.
        """
        import numpy

        with open(os.path.join(folder, "filenames.txt"), encoding="utf-8") as file:
            names = file.read().split()
        directions = floats(numpy.loadtxt(os.path.join(folder, "light_directions.txt"), ndmin=2))
        strengths = floats(numpy.loadtxt(os.path.join(folder, "light_intensities.txt"), ndmin=2))
        if directions.shape != (len(names), 3) or strengths.shape not in ((len(names), 3), (len(names), 1)):
            raise ValueError("%s: %d pictures are named, there are %d directions and %d intensities" %
                             (os.fspath(folder), len(names), len(directions), len(strengths)))
        images: List[Any] = []
        for name, strength in zip(names, strengths):
            levels = _levels_of(os.path.join(folder, name))
            images.append((levels / strength).mean(-1) * strength.mean())
        mask = _levels_of(os.path.join(folder, "mask.png")).max(-1) > 0
        if any(image.shape != mask.shape for image in images):
            raise ValueError("%s: pictures and mask have different sizes" % os.fspath(folder))
        lengths = numpy.linalg.norm(directions, axis=1, keepdims=True)
        return StereoSet(numpy.stack(images), mask, directions / lengths, strengths.mean(1), _normals_in(folder))


def _normals_in(folder: Path) -> "Optional[Floats]":
    import numpy

    path = os.path.join(folder, "Normal_gt.npy")
    if os.path.exists(path):
        return floats(numpy.load(path))
    path = os.path.join(folder, "Normal_gt.mat")
    if not os.path.exists(path):
        return None
    try:
        import importlib

        loaded: Any = importlib.import_module("scipy.io").loadmat(path)
    except ImportError:
        return None
    return floats(loaded["Normal_gt"])


def _put(path: str, content: bytes) -> None:
    with open(path, "wb") as file:
        file.write(content)


def _chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def _png_of(levels: Any) -> bytes:
    """A grey PNG, of 16 bits where the levels have as many."""
    rows, columns = levels.shape
    lines = b"".join(b"\0" + line.tobytes() for line in levels)
    head = struct.pack(">IIBBBBB", columns, rows, 8 * levels.dtype.itemsize, 0, 0, 0, 0)
    return _MARK + _chunk(b"IHDR", head) + _chunk(b"IDAT", zlib.compress(lines)) + _chunk(b"IEND", b"")


def _levels_of(path: str) -> "Floats":
    """The levels of a PNG, 0 to 1: rows x columns x channels, without an alpha channel."""
    import numpy

    with open(path, "rb") as file:
        content = file.read()
    at, packed, head = len(_MARK), b"", b""
    while at + 8 <= len(content):
        length, name = struct.unpack(">I4s", content[at:at + 8])
        if name == b"IHDR":
            head = content[at + 8:at + 8 + length]
        if name == b"IDAT":
            packed += content[at + 8:at + 8 + length]
        at += length + 12
    if not content.startswith(_MARK) or len(head) != 13:
        raise ValueError("%s: a PNG is expected" % path)
    columns, rows, bits, kind, _, _, interlaced = struct.unpack(">IIBBBBB", head)
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(kind, 0)
    if bits not in (8, 16) or channels == 0 or interlaced:
        raise ValueError("%s: grey or coloured pixels of 8 or 16 bits are expected, no palette, not interlaced" % path)
    step = channels * bits // 8
    raw = numpy.frombuffer(zlib.decompress(packed), "u1")
    if raw.size != rows * (1 + columns * step):
        raise ValueError("%s: the PNG is cut short" % path)
    lines = raw.reshape(rows, 1 + columns * step)
    plain = numpy.zeros((rows + 1, (columns + 1) * step), numpy.int64)  # a row above and a pixel before are 0
    for row in range(rows):
        _unfilter(int(lines[row, 0]), lines[row, 1:], plain[row], plain[row + 1], step)
    content_bytes = plain[1:, step:].astype("u1").tobytes()
    levels = numpy.frombuffer(content_bytes, ">u2" if bits == 16 else "u1").reshape(rows, columns, channels)
    return floats(levels[..., :3 if channels > 2 else 1] / float((1 << bits) - 1))


def _unfilter(kind: int, line: Any, above: Any, into: Any, step: int) -> None:
    """Undoes the filter of a row (PNG, 9.2): columns that follow from each other one after the other."""
    if kind in (0, 2):
        into[step:] = (line + (above[step:] if kind == 2 else 0)) & 255
        return
    for i in range(step, into.size):
        left, up, corner = int(into[i - step]), int(above[i]), int(above[i - step])
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + up) // 2
        else:
            distances = (abs(up - corner), abs(left - corner), abs(left + up - 2 * corner))
            guess = (left, up, corner)[distances.index(min(distances))]
        into[i] = (int(line[i - step]) + guess) & 255


def _frame(scene: "Scene") -> "Floats":
    """The viewer's axes, as rows: to the right, up, towards the viewer."""
    origin = floats(scene.unproject((0, 0), 0))
    return floats([floats(scene.unproject((x, y), z)) - origin for x, y, z in ((1, 0, 0), (0, 1, 0), (0, 0, 1))])


def stereo(self: "Scene", *, lights: Optional[Lights] = None, threads: int = 0) -> StereoSet:
    """Pictures under one lamp each, with the true directions and normals: a set to try photometric stereo on.

    All lights that are on, or those of `lights`, by name or index; each has to stand somewhere or shine one way.
    ValueError: one does neither, or no surface is seen.
    """
    import numpy

    chosen = self._group(lights) or [i for i, light in enumerate(self.lights) if light.enabled]
    seen = self.geometry(threads=threads)
    if not chosen or not seen.mask.any():
        raise ValueError("a light that is on, and a surface that is seen, are expected")
    frame, middle = _frame(self), seen.positions_mm[seen.mask].mean(0)
    images, ways, strengths = [], [], []
    for i in chosen:
        way, strength = _towards(self, i, middle)
        images.append(numpy.asarray(self.render(lights=[i], precision="double", threads=threads)))
        ways.append(frame @ way)
        strengths.append(strength)
    return StereoSet(numpy.stack(images), seen.mask, floats(ways), floats(strengths), seen.normals @ frame.T)


def _towards(scene: "Scene", i: int, middle: "Floats") -> Tuple["Floats", float]:
    """The direction from a place to a light, and the irradiance of what faces it there."""
    import numpy

    light = scene.lights[i]
    if light.position_mm is not None:
        way = floats(light.position_mm) - middle
    elif light.direction is not None:
        way = -floats(light.direction)
    else:
        raise ValueError("lights[%d] of type %s comes from no direction" % (i, light.type))
    way = way / numpy.linalg.norm(way)
    bare = scene.changed({"shadows": "none"})
    return way, float(bare.evaluate(middle, way, quantity="irradiance", lights=[i])["value"])
