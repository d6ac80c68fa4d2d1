/* SPDX-License-Identifier: MIT */
/* From the command line to a scene that is ready: the SCENE argument, its changes by -s, its checks. */
#ifndef LUXEL_CLI_LOAD_H
#define LUXEL_CLI_LOAD_H

#include <stdbool.h>

#include <luxel/luxel.h>

#include "options.h"

struct loaded {
    luxel_scene *scene;             /* NULL if it could not even be read */
    const char *name;               /* as results show it */
    size_t *lights, light_count;    /* of --lights; NULL: it was not given */
    luxel_diagnostics *diagnostics; /* everything that was found; with --strict the advice too */
};

/*
 * Reads the scene, applies -s, commits, and with --strict turns advice into errors.  Errors are printed here.
 * Returns an enum exit_code; load_clear() is due in either case.  SCENE is `-`, a file (a scene, or a picture that
 * carries one) or a built-in name; of a name that is both it is the file, unless `builtin_first`.
 */
int load_scene(const struct options *options, bool builtin_first, struct loaded *loaded);
void load_clear(struct loaded *loaded);

/*
 * Loads a scene and, if it is ready, does `action` with it and with the options as they count for it: those that are
 * not given are the settings that a picture carries.  Returns an enum exit_code.
 */
int load_and(const struct options *options, int (*action)(const struct options *, const struct loaded *));

/* The options as they count for what was loaded: a picture's own settings are the defaults of those not given. */
struct options load_options(const struct options *options, const struct loaded *loaded);

/* Takes in standard input, a little more than 64 MB of it at most; the text is freed with free() in any case. */
int load_standard_input(char **text, size_t *length);

/* The index of a built-in scene (NULL: the default one), or the number of them. */
size_t load_find_builtin(const char *name);

#endif
