/* SPDX-License-Identifier: MIT */
/* Finding built-in files by their paths. */
#include "builtin_file.h"

#include <string.h>

static const char prefix[] = "builtin:";

bool lx_is_builtin_path(const char *path)
{
    return strncmp(path, prefix, sizeof prefix - 1) == 0;
}

const struct lx_builtin_file *lx_builtin_file_of(const char *path)
{
    if (!lx_is_builtin_path(path))
        return NULL;
    for (const struct lx_builtin_file *file = lx_builtin_files; file->name; file++)
        if (strcmp(file->name, path + sizeof prefix - 1) == 0)
            return file;
    return NULL;
}
