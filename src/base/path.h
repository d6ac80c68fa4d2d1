/* SPDX-License-Identifier: MIT */
/* Paths of files: a folder, which ends in a slash, and a name.  Windows knows backslashes and drives too. */
#ifndef LX_BASE_PATH_H
#define LX_BASE_PATH_H

#include <stdbool.h>

/* Where the name begins, behind the folder with its last separator; the start where there is no folder. */
const char *lx_path_name(const char *path);

/* Whether a path begins at a root, so that no other folder is put before it. */
bool lx_path_is_absolute(const char *path);

#endif
