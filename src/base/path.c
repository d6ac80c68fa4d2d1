/* SPDX-License-Identifier: MIT */
/* Paths of files. */
#include "path.h"

#include <ctype.h>
#include <string.h>

#ifdef _WIN32
static const bool has_drives = true;
static const char separators[] = "/\\";
#else
static const bool has_drives = false;
static const char separators[] = "/";
#endif

static bool has_drive(const char *path)
{
    return has_drives && isalpha((unsigned char)path[0]) && path[1] == ':';
}

const char *lx_path_name(const char *path)
{
    const char *name = has_drive(path) ? path + 2 : path;
    for (const char *at = name; (at = strpbrk(at, separators)) != NULL;)
        name = ++at;
    return name;
}

bool lx_path_is_absolute(const char *path)
{
    return has_drive(path) || (path[0] != '\0' && strchr(separators, path[0]));
}
