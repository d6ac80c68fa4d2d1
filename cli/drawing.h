/* SPDX-License-Identifier: MIT */
/*
 * Commands that draw: figure, report, and photometry where it draws.  They need cairo and pango, which would make every
 * start of the tool slower by a millisecond and more.  So they run in a second program, luxel-draw, which is this tool
 * linked with the library luxel-figure; `luxel figure` hands its whole command line to it.
 *
 * Each function returns an enum exit_code.  drawing_elsewhere.c defines them for luxel, draw/ for luxel-draw.
 */
#ifndef LUXEL_CLI_DRAWING_H
#define LUXEL_CLI_DRAWING_H

#include "options.h"

int drawing_figure(const struct options *options);
int drawing_report(const struct options *options);
int drawing_photometry(const struct options *options);

#endif
