#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes a script that runs a program of this build folder on a machine that it was not built for:
#
#     emulated.sh SCRIPT PROGRAM EMULATOR [ARGUMENTS]
set -eu
script=$1 program=$2
shift 2
printf '#!/bin/sh\nexec %s %s "$@"\n' "$*" "$program" >"$script"
chmod +x "$script"
