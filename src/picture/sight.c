/* SPDX-License-Identifier: MIT */
/* What elements see of cells. */
#include <float.h>
#include <math.h>

#include "../base/larger.h"
#include "../base/vector.h"
#include "sight.h"

/* Cells up to this share of the lobe's width are begun with one sample against four. */
static const double TINY = 0.0625;

/* Far from its peak a lobe is narrower, as it falls there by more than this within a width. */
static const double STEEP = 6;

/*
 * No sample lies within GAP times a cell's half size of its sides (the rule of Gauss in the quarters).  In doubt is of
 * the light of a cell in which it jumps CUT_SHARE: all in a strip as wide, and some more; and where it begins with a
 * bend instead SLIVER_SHARE, as light rises to its greatest there, GAP / 2 of the area is on average half as bright.
 */
static const double GAP = 0.1127, CUT_SHARE = 0.1, SLIVER_SHARE = 0.0282;

void lx_receivers_find(const struct lx_block_double *block, size_t start, const struct lx_lobe_double *lobe,
                       struct lx_receivers *receivers)
{
    const double grazing = 0.15; /* lobes of half vectors get narrow towards the rim; below this the cells stay */
    receivers->block = block;
    receivers->start = start;
    receivers->lobe = lobe;
    receivers->power = lx_power_lobe_of(lobe->model);
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        size_t i = start + lane;
        double n[3] = {block->nx[i], block->ny[i], block->nz[i]}, v[3] = {block->vx[i], block->vy[i], block->vz[i]};
        struct lx_lobe_at *at = &receivers->at[lane];
        lx_lobe_at_set(n, v, at);
        const double half = 2 * lx_larger(at->n_dot_v, grazing);
        receivers->width[lane] = lx_smaller(1, receivers->power->width(lobe->exponent.value, half));
    }
}

/* A cell as seen by an element. */
struct look {
    double radius;     /* of a ball around it */
    double towards[3]; /* unit, to its middle */
    double distance;
    double size;   /* no place in it is seen farther from its middle than under the angle with this sine */
    double height; /* N.L towards its middle */
    double above;  /* the plane of the cell, or what is bent */
    bool may;      /* whether it may light the element at all */
};

/* Finds the directions, and for which elements the cell is in front of both. */
static void look(const struct lx_receivers *receivers, const struct lx_patch *patch, const struct lx_cell *cell,
                 struct look looks[LX_LANES])
{
    const struct lx_block_double *block = receivers->block;
    const struct lx_lobe_double *lobe = receivers->lobe;
    const bool is_flat = patch->kind == LX_PATCH_FLAT || patch->kind == LX_PATCH_DISK;
    const bool by_cosine = LX_ENDS_AT_HORIZON(lobe->highlight);
    double middle[3], radius = 0;
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        const size_t i = receivers->start + lane;
        const double place[3] = {block->px[i], block->py[i], block->pz[i]};
        const double n[3] = {block->nx[i], block->ny[i], block->nz[i]};
        struct look *seen = &looks[lane];
        double *towards = seen->towards;
        if (!is_flat || lane == 0)
            radius = lx_cell_look(patch, cell, place, middle);
        for (int k = 0; k < 3; k++)
            towards[k] = middle[k] - place[k];
        const bool in_front = !is_flat || lx_dot(towards, patch->n) < 0;
        const double distance = sqrt(lx_dot(towards, towards));
        seen->may = radius >= 0 && in_front && (!by_cosine || lx_dot(n, towards) > -radius);
        seen->above = lx_patch_above(patch, place);
        seen->radius = radius;
        seen->distance = distance;
        seen->size = radius / distance;
        for (int k = 0; k < 3; k++)
            towards[k] /= lx_larger(distance, DBL_MIN);
        seen->height = lx_dot(n, towards);
    }
}

/* The length of L + V towards the middle of the cell, less what it may be shorter elsewhere in it; 1 where it does not
 * matter. */
static double half_length(const struct lx_receivers *receivers, size_t lane, const struct look *seen)
{
    const struct lx_block_double *block = receivers->block;
    const size_t i = receivers->start + lane;
    const double *l = seen->towards;
    if (!receivers->power->asks_half)
        return 1;
    const double half[3] = {l[0] + block->vx[i], l[1] + block->vy[i], l[2] + block->vz[i]};
    return sqrt(lx_dot(half, half)) - seen->size;
}

/*
 * The largest square of S over the cell's places, for an element.  With A the angle between L and the mirrored view
 * and the cell seen under no more than rho from its middle, no angle to the mirrored view is less than A - rho.
 */
static double greatest_square(const struct lx_receivers *receivers, size_t lane, const struct look *seen)
{
    const double cosine = lx_smaller(lx_dot(seen->towards, receivers->at[lane].mirrored), 1), size = seen->size;
    if (!(size < 1))
        return 1;
    double around = sqrt(1 - size * size), sine = sqrt(lx_larger(1 - cosine * cosine, 0));
    double nearest = cosine >= around ? 1 : lx_smaller(cosine * around + sine * size, 1);
    return receivers->power->greatest_square(nearest);
}

/*
 * The share of a cell's light that is in doubt as the lobe jumps or bends in it: at the horizon, at L = -V, which has
 * no half vector, and at S = 0, that is N.L = -N.V or R.V = 0, where S^n with n < 1 begins with an infinite slope.
 * `half`: the least length of L + V, or 1; `greatest`: that of S.
 */
static double doubtful_share(const struct lx_receivers *receivers, size_t lane, const struct look *seen, double half,
                             double greatest)
{
    const struct lx_lobe_double *lobe = receivers->lobe;
    const double size = seen->size;
    double limit;
    const double *end = lx_lobe_kinds[lobe->model]->end(&receivers->at[lane], &limit);
    const double beyond_end = lx_dot(seen->towards, end) - limit;
    const bool is_at_horizon = fabs(seen->height) < size, is_at_end = fabs(beyond_end) < size;
    if (!(half > 0) || (LX_JUMPS_AT_HORIZON(lobe->highlight) && is_at_horizon) ||
        (lobe->exponent.value < 1 && is_at_end))
        return CUT_SHARE;
    double share = 0;
    if (LX_FALLS_TO_HORIZON(lobe->highlight) && is_at_horizon)
        share = SLIVER_SHARE * lx_smaller(seen->height + size, GAP * size);
    if (is_at_end) /* beyond the gap no S is more than this share of the greatest */
        share = lx_larger(share, SLIVER_SHARE * lx_smaller(1, GAP * size / (half * greatest)));
    return share;
}

/*
 * How fast the lobe falls where the square of S is `square`: the slope of the logarithm of S^n, n tan(theta), over the
 * angle 1/sqrt(n) that it is as wide as.  Grows without end towards the dark.
 */
static double tail_steepness(const struct lx_lobe_double *lobe, double square)
{
    return sqrt(lobe->exponent.value * lx_larger(1 - square, 0) / lx_larger(square, DBL_MIN));
}

static double attenuate(const struct lx_sampled *source, double distance_mm)
{
    switch (source->law) {
    case LX_INVERSE_SQUARE: return 1 / (distance_mm * distance_mm);
    case LX_PRACTICAL: return 1e-3 / (source->emitter->k_mm + distance_mm);
    case LX_POLYNOMIAL: return 1e-6 * lx_by_polynomial(source->emitter->coefficients, distance_mm / 1000);
    case LX_NO_ATTENUATION: break;
    }
    return 1e-6;
}

/*
 * No cosine of incidence in the cell is greater.  What is bent has at most four times the area of its middle section.
 * Far cells that face the element are not worth the question.
 */
static double incidence(const struct lx_patch *patch, const struct look *seen)
{
    const bool is_bent = patch->kind == LX_PATCH_BALL || patch->kind == LX_PATCH_SIDE;
    const double nearest = seen->distance - seen->radius;
    if (!patch->is_near || !(nearest > 0))
        return 1;
    return lx_smaller((is_bent ? 4 : 1) * lx_larger(seen->above, 0) / nearest, 1);
}

void lx_see(const struct lx_receivers *receivers, const struct lx_sampled *source, const struct lx_patch *patch,
            const struct lx_cell *cell, double hardly, struct lx_sight *sight)
{
    const bool is_round = lx_cell_is_round(patch, cell);
    /* half sizes: in radians, and in widths of the lobe */
    const double widest = is_round ? 0.5 : 0.7, widths = is_round ? 2 : 4;
    const struct lx_lobe_double *lobe = receivers->lobe;
    const double weight = M_PI * source->lamp->radiance * lobe->specular;
    double greatest = 0, square = 0;
    struct look looks[LX_LANES];
    look(receivers, patch, cell, looks);
    for (int lane = 0; lane < LX_LANES; lane++) {
        const double radius = looks[lane].radius, nearest = looks[lane].distance - radius;
        double own = nearest > 0
                         ? weight * radius * radius * attenuate(source, nearest) * incidence(patch, &looks[lane])
                         : HUGE_VAL;
        greatest = looks[lane].may ? lx_larger(greatest, own) : greatest;
    }
    /* from where on S^n is worth looking at */
    double least_square = hardly > 0 ? pow(lx_smaller(hardly / greatest, 1), 2 / lobe->exponent.value) : 0;
    *sight = (struct lx_sight){.is_tiny = true};
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        const struct look *seen = &looks[lane];
        if (!seen->may)
            continue;
        const double own = greatest_square(receivers, lane, seen);
        square = lx_larger(square, own);
        if (own < least_square)
            continue;
        const double half = half_length(receivers, lane, seen), radius = seen->radius;
        const double share = doubtful_share(receivers, lane, seen, half, sqrt(own));
        if (share > 0) {
            const double content =
                weight * 2 / M_PI * radius * radius * attenuate(source, seen->distance) * incidence(patch, seen);
            sight->doubt[lane] = share * content * pow(own, lobe->exponent.value / 2);
        }
        double width = lx_smaller(widest, widths * receivers->width[lane]), from = seen->distance - radius;
        width *= lx_smaller(1, 2 * lx_larger(half, 0)); /* half vectors turn fast where they are short */
        width *= lx_smaller(1, STEEP / tail_steepness(lobe, own));
        sight->is_wide = sight->is_wide || !(radius <= width * from) || (is_round && sight->doubt[lane] > 0);
        sight->is_tiny = sight->is_tiny && sight->doubt[lane] == 0 && radius < TINY * width * from;
    }
    const double power = pow(square, lobe->exponent.value / 2);
    sight->bound = !(square > 0) ? 0 : greatest < HUGE_VAL ? greatest * power : greatest;
}
