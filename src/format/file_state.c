/* SPDX-License-Identifier: MIT */
/* The state of a file, which tells it from what it was, by the system's record of it. */
#include <stdint.h>
#include <sys/stat.h>
#include <time.h>

#include "../base/builtin_file.h"
#include "kept.h"

/* Seconds after which the times of a file tell it from a later change. */
enum { SETTLING = 2 };

struct lx_file_state lx_file_state_of(const char *path)
{
    struct stat about;
    struct timespec now;
    struct lx_file_state state = {.is_known = false};
    if (lx_builtin_file_of(path))
        return (struct lx_file_state){.is_known = true}; /* it never changes */
    if (stat(path, &about) != 0 || !S_ISREG(about.st_mode) || clock_gettime(CLOCK_REALTIME, &now) != 0)
        return state;
    state.is_known = now.tv_sec - about.st_mtim.tv_sec > SETTLING && now.tv_sec - about.st_ctim.tv_sec > SETTLING;
    state.device = (uint64_t)about.st_dev;
    state.inode = (uint64_t)about.st_ino;
    state.size = (int64_t)about.st_size;
    state.modified_s = (int64_t)about.st_mtim.tv_sec;
    state.modified_ns = (int64_t)about.st_mtim.tv_nsec;
    state.changed_s = (int64_t)about.st_ctim.tv_sec;
    state.changed_ns = (int64_t)about.st_ctim.tv_nsec;
    return state;
}
