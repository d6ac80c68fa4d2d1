/* SPDX-License-Identifier: MIT */
/* Sweeps where the system cannot make their folders: a message instead. */
#include "../../front/language.h"
#include "../cli.h"
#include "../message.h"
#include "command.h"

int sweep_command_run(const struct options *options)
{
    (void)options;
    message_error(_("luxel sweep is not in Luxel for Windows"));
    message_hint(_("run it in Luxel for Linux, which Windows has as WSL"));
    return EXIT_FILE;
}
