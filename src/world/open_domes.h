/* SPDX-License-Identifier: MIT */
/*
 * What domes give where nothing stands before them, kept with a prepared scene for all who ask, in any thread: an
 * integral over a patch of the sky takes milliseconds, and flat surfaces and grids ask for the same one at each of
 * their elements.  What is kept is what anybody would find, so it is no matter who finds it.
 */
#ifndef LX_WORLD_OPEN_DOMES_H
#define LX_WORLD_OPEN_DOMES_H

#include "../light/sky/dome.h"

struct lx_lobe;

/* What an emitter gives to an element. */
struct lx_lighting {
    bool on_element; /* the emitter lies on the element: there is no value */
    lx_bounded irradiance, diffuse, specular;
    size_t parts; /* points of an extended emitter that were looked at; 0: a closed form did */
};

/*
 * What patches of a dome give where nothing stands before them, remembered from one element to the next: as a dome has
 * no distance, that is the same for all elements of one normal, as those of a flat surface, and where they reflect by
 * the view, of one view vector.
 */
struct lx_open_patch {
    bool is_known;
    struct lx_lighting lighting;
};
struct lx_open_dome {
    const struct lx_dome *dome; /* NULL: nothing is known yet */
    const struct lx_lobe *lobe;
    lx_bounded3 normal, view;
    struct lx_open_patch patches[LX_MOST_DOME_PATCHES];
};

struct lx_open_domes;

/* NULL: memory ran out, and nothing is kept. */
struct lx_open_domes *lx_open_domes_new(void);
void lx_open_domes_free(struct lx_open_domes *domes);

/* What a patch gives to elements like those that `open` is for, as exact as integrals of a tolerance are; false: nobody
 * has found that yet. */
bool lx_open_domes_look(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        struct lx_lighting *lighting);
void lx_open_domes_note(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        const struct lx_lighting *lighting);

#endif
