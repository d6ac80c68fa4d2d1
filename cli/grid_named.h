/* SPDX-License-Identifier: MIT */
/* A measuring grid that --grid asks for. */
#ifndef LUXEL_CLI_GRID_NAMED_H
#define LUXEL_CLI_GRID_NAMED_H

#include "load.h"

/* The number, from 1 on, of the scene's grid of this name, else of this number; 0: there is none, as was said. */
size_t grid_named(const char *wanted, const struct loaded *loaded);

#endif
