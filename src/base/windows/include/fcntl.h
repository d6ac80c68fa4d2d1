/* SPDX-License-Identifier: MIT */
/* Header <fcntl.h> with what Windows lacks. */
#ifndef LX_WINDOWS_FCNTL_H
#define LX_WINDOWS_FCNTL_H

#include_next <fcntl.h>

enum { F_GETFD = 1 };

#define O_CLOEXEC _O_NOINHERIT
#define O_NOCTTY 0

/* F_GETFD alone: whether the file is open. */
int fcntl(int file, int command);

/* open(), which calls a folder a folder, and knows /dev/null. */
int lx_windows_open(const char *path, int flags, ...);
#define open lx_windows_open

enum { FALLOC_FL_KEEP_SIZE = 1 };

/* 0, or -1 and errno where the volume has not so much room. */
int fallocate(int file, int mode, long long from, long long bytes);

#endif
