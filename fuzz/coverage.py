# SPDX-License-Identifier: MIT
"""What each fuzz target reaches of the files that it aims at, by its inputs.

    python3 fuzz/coverage.py BUILD_FOLDER FOLDER TARGET...

of a folder that was built with -Db_coverage=true, whose counters are lost; the inputs of a target are those in
fuzz/corpus/TARGET and, where it is there, in FOLDER/TARGET.
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))
import coverage

EDITING = ["src/scene/" + name + ".c" for name in (
    "edit", "elements", "insert", "layout", "patch", "path", "rearrange", "slot", "splice", "tidy", "value", "write")]
TABLES = ["src/format/text_table" + part + ".c" for part in ("", "_columns", "_heading", "_lines", "_open")]
AIMS = {
    "scene": ["src/scene/yaml.c", "src/scene/guard.c", "src/scene/input.c", "src/scene/carried.c",
              "src/scene/validate.c", "src/parameter/decode.c", "src/parameter/value.c", "src/parameter/rules.c",
              "src/format/png_tags.c", "src/format/exr_header.c"],
    "edit": EDITING,
    "field": ["src/format/npy.c", "src/format/pfm.c", "src/format/csv_read.c", "src/format/exr_header.c",
              "src/format/exr_read.c", "src/api/input.c"],
    "photometry": ["src/format/lamp/photometry.c", "src/format/lamp/photometry_eulumdat.c",
                   "src/format/lamp/photometry_figures.c",
                   "src/format/lamp/photometry_flux.c", "src/format/lamp/photometry_lm63.c",
                   "src/format/lamp/photometry_lm63_numbers.c", "src/format/lamp/photometry_map.c",
                   "src/format/lamp/photometry_opening.c", "src/format/lamp/photometry_section.c",
                   "src/format/lamp/photometry_table.c"],
    "mesh": ["src/format/mesh/off.c", "src/format/mesh/obj.c", "src/format/mesh/mesh.c", "src/format/lines.c",
             "src/light/solid/facets_mesh.c"],
    "numbers": ["src/picture/plan_make.c", "src/picture/precision.c", "src/world/prepared.c", "src/world/reference.c",
                "src/picture/shader.c", "src/light/emitter.c", "src/material/lobe.c"],
    "answers": ["cli/answers.c", "src/exercise/judge.c", *TABLES],
    "arguments": ["cli/options.c", "cli/options_table.c", "cli/argument.c", "cli/load.c", "src/scene/edit.c",
                  "src/scene/path.c", "src/scene/value.c"],
    "points": ["src/format/cloud.c", "src/format/array_table.c", "src/format/npy.c", "src/light/points.c",
               "cli/places_file.c", *TABLES],
}


def reach(folder, found, target):
    """The line of the table."""
    for counters in folder.rglob("*.gcda"):
        counters.unlink()
    inputs = [path for path in (HERE / "corpus" / target, found / target) if path.exists()]
    replayed = subprocess.run([folder / "fuzz" / ("replay-" + target), *inputs], check=True, capture_output=True)
    count = re.search(rb"(\d+) inputs", replayed.stdout)[1].decode()
    return coverage.row("%s | %s" % (target, count), coverage.measure(folder, AIMS[target]))


def main():
    folder, found = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    rows = [reach(folder, found, target) for target in sys.argv[3:]]
    print("| target | inputs | lines | reached | branches | taken |\n|---|---|---|---|---|---|")
    print("\n".join(rows))


main()
