/* SPDX-License-Identifier: MIT */
/*
 * What was read of the files that a scene names: it never changes once read, and scenes share it.  Each kind of it,
 * such as struct lx_mesh, begins with struct lx_kept.
 *
 * Threads: users may come and go in any thread; a list belongs to one thread at a time.
 */
#ifndef LX_FORMAT_KEPT_H
#define LX_FORMAT_KEPT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct lx_kept {
    _Atomic size_t users;
    void (*end)(struct lx_kept *kept); /* frees all of it; what it is of is told by this, too */
    /* Whether the files that it was read from beside its own are as they were; NULL: there are none. */
    bool (*is_current)(const struct lx_kept *kept);
};

/* Makes what begins with it have one user. */
void lx_kept_init(struct lx_kept *kept, void (*end)(struct lx_kept *kept));

/* One more user; one less (NULL is harmless), the last frees it. */
struct lx_kept *lx_kept_hold(struct lx_kept *kept);
void lx_kept_release(struct lx_kept *kept);

/*
 * A place for what was made of something that was read and takes longer to make than to keep, such as the tree of a
 * cloud: the last of it.  Any thread may look and put at any time; what is in it never changes.
 */
struct lx_kept_slot;

struct lx_kept_slot *lx_kept_slot_new(void); /* NULL: memory ran out */
void lx_kept_slot_free(struct lx_kept_slot *slot);
/* What is in it, with one more user; NULL: nothing. */
struct lx_kept *lx_kept_slot_look(struct lx_kept_slot *slot);
/* Puts something in, as one more user, instead of what was there. */
void lx_kept_slot_put(struct lx_kept_slot *slot, struct lx_kept *kept);

/*
 * What tells a file from what it was before.  It is known only of a regular file that had not changed for a while when
 * it was looked at: the times of a file are too coarse to tell two changes in a row.
 */
struct lx_file_state {
    bool is_known;
    uint64_t device, inode;
    int64_t size, modified_s, modified_ns, changed_s, changed_ns;
};

struct lx_file_state lx_file_state_of(const char *path);

/* Whether a file is known to be as it was. */
bool lx_file_is_as_before(const char *path, const struct lx_file_state *then);

/* What was read, by the paths of the files; starts as {0}. */
struct lx_kept_files {
    struct lx_kept_file {
        char *path;
        struct lx_kept *kept;
        struct lx_file_state state; /* before it was read */
        bool is_used;               /* it was found or added since lx_kept_refresh() */
    } * items;
    size_t count, capacity;
};

/* What was read of a path as the kind that `end` ends, which keeps its user; NULL where there is none. */
struct lx_kept *lx_kept_find(struct lx_kept_files *files, const char *path, void (*end)(struct lx_kept *kept));
/* Keeps what was read of a path, as one more user; 0, or -1 when memory ran out. */
int lx_kept_add(struct lx_kept_files *files, const char *path, struct lx_kept *kept);
/* Drops what was read of files that are not known to be as they were. */
void lx_kept_refresh(struct lx_kept_files *files);
/* Drops what was not used since. */
void lx_kept_drop_unused(struct lx_kept_files *files);
/* Keeps all of another list; 0, or -1 when memory ran out. */
int lx_kept_copy(const struct lx_kept_files *files, struct lx_kept_files *copy);
void lx_kept_clear(struct lx_kept_files *files);

#endif
