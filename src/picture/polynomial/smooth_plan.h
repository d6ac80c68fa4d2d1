/* SPDX-License-Identifier: MIT */
/*
 * Constants that a plan keeps for polynomials over squares of its picture (smooth.h): the bases, which are the same for
 * all surfaces, and for each surface its lights as polynomials take them.
 */
#ifndef LX_PICTURE_SMOOTH_PLAN_H
#define LX_PICTURE_SMOOTH_PLAN_H

#include <stdint.h>

#include "../../kernel/kernel.h"
#include "../patch.h"

/* Polynomials through so many nodes on each axis. */
struct lx_basis {
    unsigned nodes;
    double place[LX_MOST_NODES];                         /* of the nodes, from 1 to -1 */
    _Alignas(64) double series[LX_MOST_NODES][LX_LANES]; /* [node][degree], as lx_find_polynomial() takes them */
    double reach; /* of the ellipse: the sum of its half axes, for half a square's side */
    double share; /* of the bound in it, which the polynomial is off by at most */
    double slip;  /* of what is not analytic: so much of `share` for its largest value among the nodes and between */
};

/* How many bases there are for diffuse light, for highlights of extended sources, and for luminaires. */
enum { LX_BASES = 4, LX_GLOSS_BASES = 3, LX_TABLE_BASES = 4 };

/* What of these sources is round: which share of it each part has. */
struct lx_round_part {
    const struct lx_area_light *lamp;
    struct lx_cell cell; /* of the only patch of its kind that the area light has */
};

struct lx_round_parts {
    struct lx_round_part *parts;
    size_t count;
};

/* Luminaires over a surface with tables of equal cells. */
struct lx_luminaires {
    uint32_t *which; /* of the surface's lights */
    uint32_t *runs;  /* which run each of them is in */
    size_t count;
    struct lx_smooth_lights evenly; /* as if they shone evenly */
};

/*
 * What a plan knows for them of a surface.  Extended sources follow the lights, for what is diffuse: the surface's
 * first area light is light lights.count.  Their highlights have polynomials of their own (smooth_gloss.h).
 */
struct lx_smooth {
    bool pays; /* where it does not nothing else is there */
    struct lx_smooth_lights lights;
    /* of the area lights, as lx_smooth_area_light_bound() takes them; infinite: to be summed for each pixel */
    double *gains;
    bool has_highlights;
    struct lx_smooth_lights parts;       /* that highlights are of */
    struct lx_smooth_lights plain_parts; /* the same as if they shone as much in all directions */
    struct lx_round_parts round;
    struct lx_luminaires luminaires;
    size_t count;     /* of lights and area lights */
    double radius_mm; /* of the surface, as it looks on the screen */
};

#endif
