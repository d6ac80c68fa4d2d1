/* SPDX-License-Identifier: MIT */
/* Header <dirent.h>, for names in UTF-8 and long paths, which that of Windows' C library does not know. */
#ifndef LX_WINDOWS_DIRENT_H
#define LX_WINDOWS_DIRENT_H

struct dirent {
    char d_name[1024];
};

typedef struct lx_windows_folder DIR;

DIR *opendir(const char *path);
DIR *fdopendir(int folder);
struct dirent *readdir(DIR *folder);
int closedir(DIR *folder);
int scandir(const char *path, struct dirent ***entries, int (*is_wanted)(const struct dirent *),
            int (*compare)(const struct dirent **, const struct dirent **));

#endif
