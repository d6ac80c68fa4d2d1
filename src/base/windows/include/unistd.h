/* SPDX-License-Identifier: MIT */
/* Header <unistd.h> with what Windows lacks. */
#ifndef LX_WINDOWS_UNISTD_H
#define LX_WINDOWS_UNISTD_H

#include_next <unistd.h>

enum { _SC_NPROCESSORS_ONLN = 1, _SC_PAGESIZE };

/* The place in the file may be moved by it. */
ssize_t pread(int file, void *bytes, size_t count, long long place);
long sysconf(int name);

#endif
