/* SPDX-License-Identifier: MIT */
/* The list of what open domes give, of which the oldest is forgotten for what is new. */
#include "open_domes.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../material/lobe.h"

/* Scenes have few flat surfaces of one normal and one material each. */
enum { MOST = 64 };

struct kept {
    struct lx_lobe lobe; /* which open.lobe was */
    double tolerance;
    struct lx_open_dome open;
};

struct lx_open_domes {
    pthread_mutex_t mutex;
    struct kept items[MOST];
    size_t count, oldest;
};

struct lx_open_domes *lx_open_domes_new(void)
{
    struct lx_open_domes *domes = lx_new_array(1, sizeof *domes);
    if (domes && pthread_mutex_init(&domes->mutex, NULL) != 0) {
        free(domes);
        return NULL;
    }
    return domes;
}

void lx_open_domes_free(struct lx_open_domes *domes)
{
    if (!domes)
        return;
    pthread_mutex_destroy(&domes->mutex);
    free(domes);
}

static struct kept *find(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance)
{
    for (size_t i = 0; i < domes->count; i++) {
        struct kept *kept = &domes->items[i];
        if (kept->open.dome == open->dome && kept->tolerance == tolerance &&
            memcmp(&kept->open.normal, &open->normal, sizeof open->normal) == 0 &&
            memcmp(&kept->open.view, &open->view, sizeof open->view) == 0 &&
            memcmp(&kept->lobe, open->lobe, sizeof kept->lobe) == 0)
            return kept;
    }
    return NULL;
}

bool lx_open_domes_look(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        struct lx_lighting *lighting)
{
    if (!domes)
        return false;
    pthread_mutex_lock(&domes->mutex);
    const struct kept *kept = find(domes, open, tolerance);
    const bool is_known = kept && kept->open.patches[patch].is_known;
    if (is_known)
        *lighting = kept->open.patches[patch].lighting;
    pthread_mutex_unlock(&domes->mutex);
    return is_known;
}

void lx_open_domes_note(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        const struct lx_lighting *lighting)
{
    if (!domes)
        return;
    pthread_mutex_lock(&domes->mutex);
    struct kept *kept = find(domes, open, tolerance);
    if (!kept) {
        kept = &domes->items[domes->count < MOST ? domes->count++ : domes->oldest++ % MOST];
        *kept = (struct kept){
            .lobe = *open->lobe,
            .tolerance = tolerance,
            .open = {.dome = open->dome, .lobe = &kept->lobe, .normal = open->normal, .view = open->view},
        };
    }
    kept->open.patches[patch] = (struct lx_open_patch){true, *lighting};
    pthread_mutex_unlock(&domes->mutex);
}
