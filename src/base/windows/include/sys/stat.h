/* SPDX-License-Identifier: MIT */
/* Header <sys/stat.h> with what Windows lacks: long paths, which file it is, and folders below open ones. */
#ifndef LX_WINDOWS_SYS_STAT_H
#define LX_WINDOWS_SYS_STAT_H

#include_next <sys/stat.h>

/* The structure and the functions have one name, which <sys/stat.h> makes another, so that is what is replaced. */
int lx_windows_stat(const char *path, struct stat *about);
int lx_windows_fstat(int file, struct stat *about);
int lx_windows_mkdir(const char *path, int mode);
int fstatat(int folder, const char *name, struct stat *about, int flags);
int mkdirat(int folder, const char *name, int mode);
#define _stat64(path, about) lx_windows_stat(path, about)
#define _fstat64(file, about) lx_windows_fstat(file, about)
#define mkdir lx_windows_mkdir

#endif
