/* SPDX-License-Identifier: MIT */
/* Header <fcntl.h> with what Windows lacks: folders that are opened as files are, and locks of bytes. */
#ifndef LX_WINDOWS_FCNTL_H
#define LX_WINDOWS_FCNTL_H

#include_next <fcntl.h>

#define O_CLOEXEC _O_NOINHERIT
#define O_NOCTTY 0
#define O_DIRECTORY 0x10000000
#define O_NOFOLLOW 0

enum { AT_FDCWD = -100, AT_REMOVEDIR = 0x200 };
enum { F_GETFD = 1, F_GETLK = 5, F_SETLK, F_SETLKW };
enum { F_RDLCK, F_WRLCK, F_UNLCK };

struct flock {
    short l_type, l_whence;     /* from the start alone */
    long long l_start, l_len;   /* 0: all from there on */
    int l_pid;
};

/*
 * F_GETFD: whether the file is open.  F_SETLK and F_SETLKW: a lock of bytes, which nobody has but by this open file,
 * and which other files of the same process do not share.  F_GETLK finds none.
 */
int fcntl(int file, int command, ...);

/* open(), which opens folders, too, lets others remove or rename what is open, and knows /dev/null. */
int lx_windows_open(const char *path, int flags, ...);
int openat(int folder, const char *name, int flags, ...);
#define open lx_windows_open

enum { FALLOC_FL_KEEP_SIZE = 1 };

/* 0, or -1 and errno where the volume has not so much room. */
int fallocate(int file, int mode, long long from, long long bytes);

#endif
