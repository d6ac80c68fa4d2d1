/* SPDX-License-Identifier: MIT */
/* Counting the users of what was read, and lists of it by path. */
#include "kept.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

void lx_kept_init(struct lx_kept *kept, void (*end)(struct lx_kept *kept))
{
    atomic_init(&kept->users, 1);
    kept->end = end;
    kept->is_current = NULL;
}

struct lx_kept *lx_kept_hold(struct lx_kept *kept)
{
    atomic_fetch_add(&kept->users, 1);
    return kept;
}

void lx_kept_release(struct lx_kept *kept)
{
    if (kept && atomic_fetch_sub(&kept->users, 1) == 1)
        kept->end(kept);
}

struct lx_kept_slot {
    pthread_mutex_t mutex;
    struct lx_kept *kept;
};

struct lx_kept_slot *lx_kept_slot_new(void)
{
    struct lx_kept_slot *slot = lx_new_array(1, sizeof *slot);
    if (slot && pthread_mutex_init(&slot->mutex, NULL) != 0) {
        free(slot);
        return NULL;
    }
    return slot;
}

void lx_kept_slot_free(struct lx_kept_slot *slot)
{
    if (!slot)
        return;
    pthread_mutex_destroy(&slot->mutex);
    lx_kept_release(slot->kept);
    free(slot);
}

struct lx_kept *lx_kept_slot_look(struct lx_kept_slot *slot)
{
    pthread_mutex_lock(&slot->mutex);
    struct lx_kept *kept = slot->kept ? lx_kept_hold(slot->kept) : NULL;
    pthread_mutex_unlock(&slot->mutex);
    return kept;
}

void lx_kept_slot_put(struct lx_kept_slot *slot, struct lx_kept *kept)
{
    lx_kept_hold(kept);
    pthread_mutex_lock(&slot->mutex);
    struct lx_kept *before = slot->kept;
    slot->kept = kept;
    pthread_mutex_unlock(&slot->mutex);
    lx_kept_release(before);
}

bool lx_file_is_as_before(const char *path, const struct lx_file_state *then)
{
    const struct lx_file_state now = lx_file_state_of(path);
    return then->is_known && now.is_known && now.device == then->device && now.inode == then->inode &&
           now.size == then->size && now.modified_s == then->modified_s && now.modified_ns == then->modified_ns &&
           now.changed_s == then->changed_s && now.changed_ns == then->changed_ns;
}

static bool is_as_before(const struct lx_kept_file *file)
{
    return lx_file_is_as_before(file->path, &file->state) &&
           (!file->kept->is_current || file->kept->is_current(file->kept));
}

struct lx_kept *lx_kept_find(struct lx_kept_files *files, const char *path, void (*end)(struct lx_kept *kept))
{
    for (size_t i = 0; i < files->count; i++)
        if (files->items[i].kept->end == end && strcmp(files->items[i].path, path) == 0) {
            files->items[i].is_used = true;
            return files->items[i].kept;
        }
    return NULL;
}

/* Drops the items that are not to stay. */
static void filter(struct lx_kept_files *files, bool (*stays)(const struct lx_kept_file *file))
{
    size_t count = 0;
    for (size_t i = 0; i < files->count; i++) {
        struct lx_kept_file *file = &files->items[i];
        if (stays(file)) {
            files->items[count++] = *file;
            continue;
        }
        free(file->path);
        lx_kept_release(file->kept);
    }
    files->count = count;
}

static bool is_used(const struct lx_kept_file *file)
{
    return file->is_used;
}

void lx_kept_refresh(struct lx_kept_files *files)
{
    filter(files, is_as_before);
    for (size_t i = 0; i < files->count; i++)
        files->items[i].is_used = false;
}

void lx_kept_drop_unused(struct lx_kept_files *files)
{
    filter(files, is_used);
}

int lx_kept_add(struct lx_kept_files *files, const char *path, struct lx_kept *kept)
{
    char *copy = lx_copy_text(path, strlen(path));
    if (!copy || lx_reserve(&files->items, &files->capacity, files->count + 1, sizeof *files->items) < 0) {
        free(copy);
        return -1;
    }
    files->items[files->count++] = (struct lx_kept_file){.path = copy, .kept = lx_kept_hold(kept), .is_used = true};
    return 0;
}

int lx_kept_copy(const struct lx_kept_files *files, struct lx_kept_files *copy)
{
    for (size_t i = 0; i < files->count; i++) {
        if (lx_kept_add(copy, files->items[i].path, files->items[i].kept) < 0)
            return -1;
        copy->items[copy->count - 1].state = files->items[i].state;
    }
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
