/* SPDX-License-Identifier: MIT */
/* Counting the users of what was read, and lists of it by path. */
#include "kept.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

void lx_kept_init(struct lx_kept *kept, void (*free)(struct lx_kept *kept))
{
    atomic_init(&kept->users, 1);
    kept->free = free;
}

struct lx_kept *lx_kept_hold(struct lx_kept *kept)
{
    atomic_fetch_add(&kept->users, 1);
    return kept;
}

void lx_kept_release(struct lx_kept *kept)
{
    if (kept && atomic_fetch_sub(&kept->users, 1) == 1)
        kept->free(kept);
}

struct lx_kept *lx_kept_find(const struct lx_kept_files *files, const char *path, void (*free)(struct lx_kept *kept))
{
    for (size_t i = 0; i < files->count; i++)
        if (files->items[i].kept->free == free && strcmp(files->items[i].path, path) == 0)
            return files->items[i].kept;
    return NULL;
}

int lx_kept_add(struct lx_kept_files *files, const char *path, struct lx_kept *kept)
{
    char *copy = lx_copy_text(path, strlen(path));
    if (!copy || lx_reserve(&files->items, &files->capacity, files->count + 1, sizeof *files->items) < 0) {
        free(copy);
        return -1;
    }
    files->items[files->count++] = (struct lx_kept_file){copy, lx_kept_hold(kept)};
    return 0;
}

int lx_kept_copy(const struct lx_kept_files *files, struct lx_kept_files *copy)
{
    for (size_t i = 0; i < files->count; i++)
        if (lx_kept_add(copy, files->items[i].path, files->items[i].kept) < 0)
            return -1;
    return 0;
}

void lx_kept_clear(struct lx_kept_files *files)
{
    for (size_t i = 0; i < files->count; i++) {
        free(files->items[i].path);
        lx_kept_release(files->items[i].kept);
    }
    free(files->items);
    *files = (struct lx_kept_files){0};
}
