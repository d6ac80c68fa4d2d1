/* SPDX-License-Identifier: MIT */
/* Probers: a scene of their own, prepared once, and its exact values at many places, or in the cells of a grid. */
#ifndef LX_INVERSE_PROBER_H
#define LX_INVERSE_PROBER_H

#include <luxel/evaluator.h>
#include <luxel/grid.h>

/* A value with its bound; `exists` is false off every surface and where a source lies on the element. */
struct lx_probed {
    bool exists;
    double value, error;
};

struct lx_prober {
    const luxel_scene *scene;   /* NULL: not open */
    luxel_scene *own;           /* the same where it goes with the prober; else NULL */
    luxel_settings settings;    /* without the lists of the caller's */
    luxel_evaluator *evaluator; /* NULL: places share a solution of reflected light, which is made for them */
    struct lx_probed *cells;    /* of a grid that was measured; NULL: none was */
};

/* Whether the values of a committed scene take a solution of reflected light, which all places had better share. */
bool lx_prober_solves(const luxel_scene *scene);

/* Looks at a committed scene, which must outlive it and not be changed meanwhile. */
luxel_status lx_prober_look(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct lx_prober *prober);
/* Takes over a committed scene, which goes with it, and in case of an error at once. */
luxel_status lx_prober_open(luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct lx_prober *prober);
/* Likewise, and measures its i-th grid, whose cells alone it then knows; where these are other ones than `count`, none
 * has a value. */
luxel_status lx_prober_measure(luxel_scene *scene, const luxel_settings *settings, size_t i, size_t count,
                               luxel_diagnostics *diagnostics, struct lx_prober *prober);
void lx_prober_close(struct lx_prober *prober);

/* The values at places. */
luxel_status lx_prober_values(const struct lx_prober *prober, const luxel_place *places, size_t count,
                              luxel_diagnostics *diagnostics, struct lx_probed *values);

#endif
