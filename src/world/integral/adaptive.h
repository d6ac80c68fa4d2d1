/* SPDX-License-Identifier: MIT */
/*
 * Adaptive integration of functions >= 0 over a list of intervals: the rule of Gauss and Kronrod with 10 and 21
 * points (Piessens et al., QUADPACK, 1983) in each panel, the panel with the greatest error estimate halved until the
 * sum of the estimates is small enough.  The estimate is 10 |K21 - G10|, which the error of K21 stays far below where
 * the panel is resolved; where the function varies too much between neighbouring points for that to be
 * believed, the panel's whole possible content counts as its error, with peaks that may hide between the points.
 *
 * A function that is made of pieces tells the form that it has at each point.  Where that changes from one point to the
 * next there is a kink between them: both rules may miss the same there, so the estimate holds what it may amount to,
 * and such a panel is cut where the form changes.
 */
#ifndef LX_WORLD_ADAPTIVE_H
#define LX_WORLD_ADAPTIVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The function at a point. */
struct lx_point_value {
    double value, error; /* error: of the value, from elsewhere; it is integrated beside it */
    uint64_t form;       /* which piece of the function it is on; 0 where there is but one */
};

/* A form that is told by numbers, one after the other. */
static inline uint64_t lx_mixed_form(uint64_t form, uint64_t number)
{
    return (form ^ number) * UINT64_C(0x100000001b3) + UINT64_C(0x9e3779b97f4a7c15);
}

struct lx_panel {
    size_t interval; /* which function of the list it belongs to */
    double from, to;
    double value, estimate, inherited;
    double kink_from, kink_to; /* where its form changes, as far as that matters; the same: nowhere */
};

struct lx_panels {
    struct lx_panel *items;
    size_t count, capacity; /* intervals first; the capacity limits the work */
};

struct lx_integral {
    double value;
    double error;     /* the sum of the estimates */
    double inherited; /* the integral of the points' errors */
};

struct lx_integrand {
    struct lx_point_value (*at)(void *data, size_t interval, double x);
    /* How small the sum of the estimates must become, told the integral so far. */
    double (*target)(void *data, const struct lx_integral *integral);
    void *data;
    /* The form alone; NULL: it never changes. */
    uint64_t (*form)(void *data, size_t interval, double x);
    double narrowest; /* how near a change of the form is found, as a share of a panel; 0: until no number is between */
    bool is_smooth;   /* between the ends of the panels: then few points do, and no peak is looked for */
    bool is_coarse;   /* with 3 and 7 points, for tolerances from some 1e-4 on */
};

/* Integrates over the panels that are in the list, of which interval, from and to are set; leaves them refined. */
struct lx_integral lx_integrate_panels(const struct lx_integrand *integrand, struct lx_panels *panels);

#endif
