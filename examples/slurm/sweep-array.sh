#!/bin/sh
# SPDX-License-Identifier: MIT
# luxel sweep as an array of Slurm jobs, each of which does its part of the shards; it may be submitted again until all
# is there:
#   STUDY=study.yaml FOLDER=/shared/data sbatch --array=0-15 --cpus-per-task=8 sweep-array.sh
#SBATCH --job-name=luxel-sweep
#SBATCH --array=0-3
#SBATCH --ntasks=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
: "${STUDY:?names the study file}" "${FOLDER:?names the folder that all nodes see}"
exec "${LUXEL:-luxel}" sweep "$STUDY" -o "$FOLDER" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    --workers "${SLURM_CPUS_PER_TASK:-1}" -q
