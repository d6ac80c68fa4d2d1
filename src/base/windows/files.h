/* SPDX-License-Identifier: MIT */
/* What the files that stand for POSIX's functions of files on Windows share. */
#ifndef LX_BASE_WINDOWS_FILES_H
#define LX_BASE_WINDOWS_FILES_H

#include <dirent.h>
#include <sys/stat.h>
#include <wchar.h>

#include <windows.h>

/* The longest path of all, with its end. */
enum { LX_LONGEST_PATH = 32768 };

/* A path as Windows wants it, also one beyond 260 characters; NULL and errno where it is none.  The caller frees it. */
wchar_t *lx_windows_wide(const char *path);

/* The number of POSIX for an error of Windows. */
int lx_windows_error(DWORD error);

/* The functions of POSIX, of a wide path, which they free; NULL: errno says why already. */
int lx_windows_open_wide(wchar_t *path, int flags);
int lx_windows_stat_wide(wchar_t *path, struct stat *about);
int lx_windows_rename_wide(wchar_t *from, wchar_t *to);
DIR *lx_windows_opendir_wide(wchar_t *path);

#endif
