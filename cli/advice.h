/* SPDX-License-Identifier: MIT */
/* Advice about scenes, as luxel check and luxel advise gather and list it. */
#ifndef LUXEL_CLI_ADVICE_H
#define LUXEL_CLI_ADVICE_H

#include "load.h"
#include "meshes.h"

/* Whether pictures can be made of a scene that is ready, if it has surfaces; else that is told. An enum exit_code. */
int advice_check_view(const struct loaded *loaded);

/* Appends all advice about a scene that is ready to its diagnostics.  Returns an enum exit_code. */
int advice_gather(const struct options *options, const struct loaded *loaded);

/*
 * Prints everything that was found about a scene as one JSON object.  Where --strict made the scene fail by its advice,
 * that is listed among the errors.  `meshes` NULL: without them.
 */
void advice_print_json(const struct loaded *loaded, bool valid, bool strict, const struct meshes *meshes);

#endif
