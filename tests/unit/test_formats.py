# SPDX-License-Identifier: MIT
"""The files that people's own tools read: NumPy loads the .npy, and in every format row 0 is the picture's top.

Argument: the program write_images.
"""
import os
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy as np

from tap import Tap


def read_pfm(path):
    """The picture with row 0 on top, as a reader shows it that knows that the file begins at the bottom."""
    with open(path, "rb") as file:
        kind, size, scale = file.readline(), file.readline(), float(file.readline())
        columns, rows = map(int, size.split())
        data = np.frombuffer(file.read(), "<f4" if scale < 0 else ">f4")
    assert kind == b"Pf\n" and abs(scale) == 1
    return data.reshape(rows, columns)[::-1]


def read_png(path):
    """Grey without row filters, or of 16 bits with the line above taken off: chunk by chunk, each against its checksum.
    """
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            columns, rows, depth, colour = struct.unpack(">IIBB", body[:10])
            assert depth in (8, 16) and colour == 0
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    assert kind == b"IEND"
    lines = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(rows, columns * depth // 8 + 1)
    assert (lines[:, 0] == (0 if depth == 8 else 2)).all()
    bytes_of_rows = lines[:, 1:] if depth == 8 else np.cumsum(lines[:, 1:], axis=0, dtype=np.uint8)
    return np.ascontiguousarray(bytes_of_rows).view(">u%d" % (depth // 8))


def check(tap, folder):
    truth = np.arange(4)[:, None] + np.arange(7)[None, :] / 8
    for name, kind in [("single.npy", "<f4"), ("double.npy", "<f8")]:
        loaded = np.load(os.path.join(folder, name), allow_pickle=False)
        tap.equal((loaded.dtype.str, loaded.shape, loaded.flags.c_contiguous), (kind, (4, 7), True), "shape of " + name)
        tap.ok(np.array_equal(loaded, truth), "values of " + name, loaded)
        mapped = np.load(os.path.join(folder, name), mmap_mode="r")
        tap.ok(mapped.offset % 64 == 0, "alignment of " + name, mapped.offset)
    picture = read_pfm(os.path.join(folder, "single.pfm"))
    tap.ok(np.array_equal(picture, truth), "values of single.pfm", picture)
    picture = read_png(os.path.join(folder, "grey.png"))
    tap.ok(np.array_equal(picture, truth * 8), "values of grey.png", picture)
    picture = read_png(os.path.join(folder, "fine.png"))
    tap.ok(np.array_equal(picture, truth * 8 * 259), "values of fine.png", picture)


def main():
    tap = Tap()
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.argv[1], folder])
        tap.equal(run.returncode, 0, "every format is written")
        tap.run(check, tap, folder)
    tap.finish()


main()
