/* SPDX-License-Identifier: MIT */
/*
 * What was read of the files that a scene names: it never changes once read, and scenes share it.  Each kind of it,
 * such as struct lx_mesh, begins with struct lx_kept.
 *
 * Threads: users may come and go in any thread; a list belongs to one thread at a time.
 */
#ifndef LX_FORMAT_KEPT_H
#define LX_FORMAT_KEPT_H

#include <stddef.h>

struct lx_kept {
    _Atomic size_t users;
    void (*free)(struct lx_kept *kept); /* frees all of it; what it is of is told by this, too */
};

/* Makes what begins with it have one user. */
void lx_kept_init(struct lx_kept *kept, void (*free)(struct lx_kept *kept));

/* One more user; one less (NULL is harmless), the last frees it. */
struct lx_kept *lx_kept_hold(struct lx_kept *kept);
void lx_kept_release(struct lx_kept *kept);

/* What was read, by the paths of the files; starts as {0}. */
struct lx_kept_files {
    struct lx_kept_file {
        char *path;
        struct lx_kept *kept;
    } * items;
    size_t count, capacity;
};

/* What was read of a path as the kind that `free` frees, which keeps its user; NULL where there is none. */
struct lx_kept *lx_kept_find(const struct lx_kept_files *files, const char *path, void (*free)(struct lx_kept *kept));
/* Keeps what was read of a path, as one more user; 0, or -1 when memory ran out. */
int lx_kept_add(struct lx_kept_files *files, const char *path, struct lx_kept *kept);
/* Keeps all of another list; 0, or -1 when memory ran out. */
int lx_kept_copy(const struct lx_kept_files *files, struct lx_kept_files *copy);
void lx_kept_clear(struct lx_kept_files *files);

#endif
