#!/bin/sh
# SPDX-License-Identifier: MIT
# luxel-sweep-mpi as one Slurm job of many ranks, which fetch shards as they need them; it may be submitted again until
# all is there:
#   STUDY=study.yaml FOLDER=/shared/data sbatch --ntasks=64 sweep-mpi.sh
#SBATCH --job-name=luxel-sweep
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
: "${STUDY:?names the study file}" "${FOLDER:?names the folder that all nodes see}"
# shellcheck disable=SC2086
exec mpirun ${MPIRUN_OPTIONS:-} "${LUXEL_SWEEP_MPI:-luxel-sweep-mpi}" "$STUDY" -o "$FOLDER"
