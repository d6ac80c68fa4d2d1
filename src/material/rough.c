/* SPDX-License-Identifier: MIT */
/* The slope that diffuse models of rough surfaces know, with its error and its kinks. */
#include <math.h>

#include "../base/vector.h"
#include "rough.h"

/* Errors are no greater than this, so that what is multiplied by 0 stays 0. */
static const double LARGEST = 1e100;

static lx_bounded greater(lx_bounded a, lx_bounded b)
{
    return (lx_bounded){fmax(a.value, b.value), fmax(a.error, b.error)};
}

struct lx_slope lx_slope_of(lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    const lx_bounded n_dot_l = lx_dot3(normal, towards), n_dot_v = lx_dot3(normal, view);
    const lx_bounded s = lx_sub(lx_dot3(towards, view), lx_mul(n_dot_l, n_dot_v));
    struct lx_slope slope = {lx_positive(n_dot_l), lx_positive(n_dot_v), s};
    const lx_bounded t = greater(slope.lit, slope.seen);
    if (s.value + s.error > 0) {
        const lx_bounded quotient = t.value > 0 ? lx_div(s, t) : (lx_bounded){0, LARGEST};
        slope.value = s.value > 0 ? quotient : (lx_bounded){s.value, fmax(quotient.error, s.error)};
    }
    slope.value.error = slope.value.error < LARGEST ? slope.value.error : LARGEST;
    return slope;
}

double lx_slope_at(const struct lx_lobe_at *at, const double towards[3], double moved, double *lit, double *error)
{
    const double n_dot_l = lx_dot(at->normal, towards), s = lx_dot(towards, at->view) - n_dot_l * at->n_dot_v;
    const double t = fmax(fmax(n_dot_l, at->n_dot_v), DBL_MIN);
    const double off = moved + at->view_error + 2 * at->normal_error + 6 * DBL_EPSILON;
    *lit = fmax(n_dot_l, 0);
    *error = s > -off ? off / t * (1 + fmax(s, 0) / t) : off;
    return s > 0 ? s / t : s;
}

size_t lx_slope_kinks(const struct lx_lobe_at *at, struct lx_border kinks[LX_MOST_KINKS])
{
    for (int i = 0; i < 3; i++) {
        kinks[0].g[i] = at->view[i] - at->n_dot_v * at->normal[i];
        kinks[1].g[i] = at->normal[i];
    }
    kinks[0].limit = 0;
    kinks[1].limit = at->n_dot_v;
    return at->n_dot_v > 0 ? 2 : 1;
}
