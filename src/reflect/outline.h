/* SPDX-License-Identifier: MIT */
/*
 * Outlines: straight lines in space at which the shadows of surfaces begin, as each light sees them.  Which of them
 * fall on a cell, and what that means for its samples, crossing.h tells.
 */
#ifndef LX_REFLECT_OUTLINE_H
#define LX_REFLECT_OUTLINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../world/prepared.h"

/* A straight piece of a surface's outline as a light sees it; of what is round, one of 16. */
struct lx_shadow_outline {
    double from_mm[3], to_mm[3];
    double dark[3]; /* at right angles to the plane through it and the light, to the side where the surface is */
    uint32_t light, surface;
};

/* An emitter that casts shadows, and how far it reaches from its middle. */
struct lx_outline_light {
    const struct lx_emitter *emitter;
    struct lx_origin at;
    double reach_mm[8][3]; /* places of its outline, from there */
    unsigned reach_count;  /* 0: it has no size */
};

struct lx_outlines {
    const struct lx_prepared *prepared;
    struct lx_outline_light *lights;
    size_t light_count;
    struct lx_shadow_outline *items; /* light by light */
    size_t count, capacity;
};

/* Outlines of the prepared scene, which has to stay where it is, for all emitters but the points of clouds.  0, or -1
 * when memory ran out; to be freed by lx_outlines_clear() in any case. */
int lx_outlines_make(const struct lx_prepared *prepared, struct lx_outlines *outlines);
void lx_outlines_clear(struct lx_outlines *outlines);

#endif
