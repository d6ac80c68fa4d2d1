/* SPDX-License-Identifier: MIT */
/* luxel sweep: what help says of it; sweep/command.c is what it does. */
#include <stddef.h>

#include "cli.h"
#include "sweep/command.h"

const struct command command_sweep = {
    .name = "sweep",
    .bit = COMMAND_SWEEP,
    .operand = N_("STUDY"),
    .operand_kind = OPERAND_FILE,
    .endings = "",
    .summary = N_("compute the many scenes of a study into a folder, restartable"),
    .description = N_(
        "STUDY is a YAML file: a base scene, what varies and how, and what is kept of each scene; luxel help study "
        "explains its keys, and docs/SWEEP.md all of it. FOLDER gets a folder shard-000000 and so on with NPY files, "
        "and a manifest.json with the SHA-256 of each. Shards are written whole; the same command goes on after an "
        "interruption with what is missing, and the bytes are the same for any number of workers."),
    .examples = "luxel sweep study.yaml --dry-run\n"
                "luxel sweep study.yaml -o data --workers 2\n"
                "luxel sweep study.yaml --show 4711 > scene.yaml\n"
                "luxel sweep study.yaml -o data --shard 3/16\n"
                "luxel sweep study.yaml -o data --merge data.h5",
    .run = sweep_command_run,
};
