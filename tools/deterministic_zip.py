#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A folder as an archive whose bytes are always the same: deterministic_zip.py FILE.zip FOLDER NAME (within)."""
import os
import pathlib
import sys
import time
import zipfile


def add(archive, name, content):
    """A file of the date SOURCE_DATE_EPOCH."""
    date = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", "315532800")))[:6]
    entry = zipfile.ZipInfo(name, date)
    entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
    archive.writestr(entry, content)


def pack(target, files):
    """Files by their names in the archive, in the order of these."""
    with zipfile.ZipFile(target, "w") as archive:
        for name, path in sorted(files.items()):
            add(archive, name, pathlib.Path(path).read_bytes())


def files_of(folder, name):
    root = pathlib.Path(folder)
    return {f"{name}/{path.relative_to(root).as_posix()}" if name else path.relative_to(root).as_posix(): path
            for path in root.rglob("*") if path.is_file()}


if __name__ == "__main__":
    pack(sys.argv[1], files_of(sys.argv[2], sys.argv[3]))
