/* SPDX-License-Identifier: MIT */
/*
 * Slopes: how values at elements change with some numbers that the prepared scene depends on, as the numbers of keys
 * are.  Somebody tells at which rates the scene's constants change with each of them; the gradients at an element
 * (gradient.h), of which one is enough for all, say what that makes of its value.
 *
 * Points, parallel and uniform light are known so, on lobes that are powers or have no highlight, from round and flat
 * surfaces that may move beneath lines of sight.
 */
#ifndef LX_WORLD_SLOPES_H
#define LX_WORLD_SLOPES_H

#include "world.h"

/* Constants of a prepared scene stand in a row: those of each emitter (gradient.h), of the lobe of each surface and of
 * each as its list has it, of each shape, and of the camera. */
enum { LX_OF_EMITTER = LX_BY_EMITTER, LX_OF_LOBE = 4, LX_OF_SHAPE = 7, LX_OF_CAMERA = 15 };

/* What has constants, by its number: emitters first, then surfaces' lobes and so on. */
struct lx_constants {
    size_t emitters, surfaces, authored; /* how many there are */
    size_t count;                        /* of all constants */
    lx_bounded *list;
};

/* The constants of a scene whose values are known by slopes.  0, or -1 where they are not or memory ran out: then
 * nothing is kept.  `bright`: lobes count. */
int lx_constants_make(const struct lx_prepared *prepared, bool bright, struct lx_constants *constants);
void lx_constants_clear(struct lx_constants *constants);

/* Whether two scenes are the same but for these constants, so that each goes over into the other. */
bool lx_constants_are_alike(const struct lx_prepared *a, const struct lx_prepared *b);

/* A constant changes with a number, for each unit of it. */
struct lx_rate {
    size_t constant, number;
    lx_bounded rate;
};

/* What a number may change beside constants. */
struct lx_moving {
    bool moves;      /* what is seen through points of the screen */
    size_t surface;  /* all about this one of the scene's list, 1 more than its index; 0: none */
    bool is_limited; /* it can only grow, or only fall: its derivatives are those of one side */
    bool is_known;   /* else somebody else has to tell its slopes */
};

struct lx_slopes {
    struct lx_constants constants; /* without their list */
    struct lx_rate *rates;
    size_t rate_count, rate_capacity;
    struct lx_moving *numbers;
    size_t number_count;
    bool moves; /* whether one of them does */
};

/* By the constants first. */
void lx_slopes_sort(struct lx_slopes *slopes);
void lx_slopes_clear(struct lx_slopes *slopes);

/*
 * Sets the slope of element i of a batch by number k in sums[k], for all k, and where they are in doubt, as at edges
 * of shadows, so that somebody else has to tell.  `screen_mm`: the points of the screen through which the elements are
 * seen; NULL: they are free.
 */
void lx_slope_elements(const struct lx_world *world, const struct lx_slopes *slopes, const struct lx_elements *elements,
                       enum lx_wanted wanted, const double (*screen_mm)[2], bool have_views, struct lx_column *sums,
                       bool in_doubt[LX_BATCH]);

#endif
