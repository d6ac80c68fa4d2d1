#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the meshes of the built-in scene pot, data/files/pot.ply and knot.ply: those of examples/meshes with fewer
faces, as smooth normals want no more.  make_still_life.py FOLDER"""
import importlib.util
import pathlib
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "examples" / "meshes"
FEWER = {"make_pot": {"AROUND": 32, "BETWEEN": 2}, "make_knot": {"AROUND": 10, "ALONG": 80}}


def main():
    for name, numbers in FEWER.items():
        spec = importlib.util.spec_from_file_location(name, EXAMPLES / (name + ".py"))
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        for key, number in numbers.items():
            setattr(module, key, number)
        module.write(pathlib.Path(sys.argv[1]) / (name.removeprefix("make_") + ".ply"))


main()
