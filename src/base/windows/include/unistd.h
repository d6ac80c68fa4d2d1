/* SPDX-License-Identifier: MIT */
/* Header <unistd.h> with what Windows lacks. */
#ifndef LX_WINDOWS_UNISTD_H
#define LX_WINDOWS_UNISTD_H

#include_next <unistd.h>

enum { _SC_NPROCESSORS_ONLN = 1, _SC_PAGESIZE };

/* The place in the file may be moved by it. */
ssize_t pread(int file, void *bytes, size_t count, long long place);
long sysconf(int name);
int fsync(int file);

/* As many bytes as its C library takes at once. */
ssize_t lx_windows_read(int file, void *bytes, size_t count);
ssize_t lx_windows_write(int file, const void *bytes, size_t count);
#define read lx_windows_read
#define write lx_windows_write

int lx_windows_access(const char *path, int mode);
int lx_windows_unlink(const char *path);
int unlinkat(int folder, const char *name, int flags);
#define access lx_windows_access
#define unlink lx_windows_unlink

#endif
