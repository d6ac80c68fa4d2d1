/* SPDX-License-Identifier: MIT */
/* Functions that glibc has had since 2.32 and 2.33 only, by those that it had before. */
#define _GNU_SOURCE
#include <string.h>
#include <sys/stat.h>

#define HIDDEN __attribute__((visibility("hidden")))
#ifdef __aarch64__
enum { VERSION_OF_STAT = 0 }; /* _STAT_VER */
#else
enum { VERSION_OF_STAT = 1 };
#endif

int __xstat64(int version, const char *path, struct stat64 *state);
int __lxstat64(int version, const char *path, struct stat64 *state);
int __fxstat64(int version, int file, struct stat64 *state);
int __fxstatat64(int version, int folder, const char *path, struct stat64 *state, int flags);
const char *strerrordesc_np(int number);

HIDDEN int stat64(const char *path, struct stat64 *state)
{
    return __xstat64(VERSION_OF_STAT, path, state);
}

HIDDEN int lstat64(const char *path, struct stat64 *state)
{
    return __lxstat64(VERSION_OF_STAT, path, state);
}

HIDDEN int fstat64(int file, struct stat64 *state)
{
    return __fxstat64(VERSION_OF_STAT, file, state);
}

HIDDEN int fstatat64(int folder, const char *path, struct stat64 *state, int flags)
{
    return __fxstatat64(VERSION_OF_STAT, folder, path, state, flags);
}

/* Both machines have one structure for either. */
HIDDEN int stat(const char *path, struct stat *state)
{
    return __xstat64(VERSION_OF_STAT, path, (struct stat64 *)state);
}

HIDDEN int lstat(const char *path, struct stat *state)
{
    return __lxstat64(VERSION_OF_STAT, path, (struct stat64 *)state);
}

HIDDEN int fstat(int file, struct stat *state)
{
    return __fxstat64(VERSION_OF_STAT, file, (struct stat64 *)state);
}

/* In the user's language, where its namesake is English. */
HIDDEN const char *strerrordesc_np(int number)
{
    return strerror(number);
}
