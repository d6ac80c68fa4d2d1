/* SPDX-License-Identifier: MIT */
/*
 * Built-in files: those of data/files/ that built-in scenes name, which tools/embed_files.py turns into a table.  A
 * path `builtin:NAME` means one of them wherever a file is read (source.h), so a scene that names one can be copied
 * anywhere, and be read where there is no file system.  To add one: a file there, and its line in meson.build here.
 */
#ifndef LX_BASE_BUILTIN_FILE_H
#define LX_BASE_BUILTIN_FILE_H

#include <stdbool.h>
#include <stddef.h>

struct lx_builtin_file {
    const char *name;
    const unsigned char *bytes;
    size_t length;
};

extern const struct lx_builtin_file lx_builtin_files[]; /* ends with a name that is NULL */

/* Whether a path means a built-in file, be there one of that name or not. */
bool lx_is_builtin_path(const char *path);

/* The built-in file that a path means; NULL: there is none of that name. */
const struct lx_builtin_file *lx_builtin_file_of(const char *path);

#endif
