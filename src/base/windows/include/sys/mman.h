/* SPDX-License-Identifier: MIT */
/* Header <sys/mman.h>, of which Windows has nothing: files are read instead, and pages are what they are. */
#ifndef LX_WINDOWS_SYS_MMAN_H
#define LX_WINDOWS_SYS_MMAN_H

#include <errno.h>
#include <stddef.h>

enum { PROT_READ = 1, MAP_PRIVATE = 2 };

#define MAP_FAILED ((void *)-1)
#define mmap(place, length, protection, flags, file, offset) ((void)(file), errno = ENOSYS, MAP_FAILED)
#define munmap(place, length) ((void)(place), (void)(length), 0)

#endif
