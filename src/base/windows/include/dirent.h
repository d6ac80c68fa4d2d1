/* SPDX-License-Identifier: MIT */
/* Header <dirent.h> with what Windows lacks. */
#ifndef LX_WINDOWS_DIRENT_H
#define LX_WINDOWS_DIRENT_H

#include_next <dirent.h>

int scandir(const char *path, struct dirent ***entries, int (*is_wanted)(const struct dirent *),
            int (*compare)(const struct dirent **, const struct dirent **));

#endif
