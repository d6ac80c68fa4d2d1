/* SPDX-License-Identifier: MIT */
/* The list of potentials: read without a lock, as it only grows. */
#include "potentials.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "../base/memory.h"

/* Scenes have few skies, and windows that look few ways. */
enum { MOST = 32 };

struct lx_potentials {
    pthread_mutex_t mutex; /* of who appends */
    struct lx_sky_potential *items[MOST];
    atomic_size_t count;
};

struct lx_potentials *lx_potentials_new(void)
{
    struct lx_potentials *potentials = lx_new_array(1, sizeof *potentials);
    if (potentials && pthread_mutex_init(&potentials->mutex, NULL) != 0) {
        free(potentials);
        return NULL;
    }
    return potentials;
}

void lx_potentials_free(struct lx_potentials *potentials)
{
    if (!potentials)
        return;
    for (size_t i = 0; i < atomic_load(&potentials->count); i++)
        lx_sky_potential_free(potentials->items[i]);
    pthread_mutex_destroy(&potentials->mutex);
    free(potentials);
}

static const struct lx_sky_potential *look(struct lx_potentials *potentials, const struct lx_sky *sky,
                                           const struct lx_glass_pane *opening)
{
    const size_t count = atomic_load_explicit(&potentials->count, memory_order_acquire);
    for (size_t i = 0; i < count; i++)
        if (lx_sky_potential_is_of(potentials->items[i], sky, opening))
            return potentials->items[i];
    return NULL;
}

const struct lx_sky_potential *lx_potentials_find(struct lx_potentials *potentials, const struct lx_sky *sky,
                                                  const struct lx_glass_pane *opening)
{
    const struct lx_sky_potential *found = potentials ? look(potentials, sky, opening) : NULL;
    if (!found && potentials) {
        pthread_mutex_lock(&potentials->mutex);
        found = look(potentials, sky, opening);
        const size_t count = atomic_load(&potentials->count);
        if (!found && count < MOST) {
            potentials->items[count] = lx_sky_potential_new(sky, opening);
            found = potentials->items[count];
            atomic_store_explicit(&potentials->count, count + (found != NULL), memory_order_release);
        }
        pthread_mutex_unlock(&potentials->mutex);
    }
    return found && lx_sky_potential_is_good(found) ? found : NULL;
}
