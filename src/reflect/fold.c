/* SPDX-License-Identifier: MIT */
/* Which folds cross a cell, and how much light its nodes do not tell of. */
#include "fold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/distribution.h"
#include "../world/reference.h"

/*
 * A function that is a power p of the distance from a line on one side, and 0 on the other: of it Gauss's rule misses
 * in the mean over all lines across a square 0.025, 0.0012 and 0.0002 of what it is one radius away, for p = 0, 1 and
 * 2: no more than the first share of what it is an eighth of the radius away.
 */
static const double MISSED = 0.025, NEAR = 0.125;
/* Cells are seldom wider than this as the light sees them; a line all around it crosses about so many diagonals. */
static const double WIDE = 0.25, PER_DIAGONAL = 4.4;
/* Lines of a table at which cells of that size miss no more of all its light than this are bent as smooth light is. */
static const double SMOOTH = 1e-3;

/* Directions around an axis that are looked at. */
enum { AROUND = 8, AROUND_POLE = 4 };

/* ---- how much it bends ---- */

/* The profile in a direction away from the light. */
static double value_at(const struct lx_profile *profile, const double direction[3])
{
    const double towards[3] = {-direction[0], -direction[1], -direction[2]};
    return profile->luminaire ? lx_pointed_plain(profile->luminaire, towards)
                              : lx_profile_value(profile, lx_exact3(towards)).value;
}

/* How much it is away from a straight line at a direction of the fold, so far across it; or jumps. */
static double bend_at(const struct lx_fold *fold, const double at[3], const double across[3], double step_rad)
{
    const struct lx_profile *profile = &fold->emitter->profile;
    double sides[2];
    for (int side = 0; side < 2; side++) {
        double direction[3];
        for (int k = 0; k < 3; k++)
            direction[k] = cos(step_rad) * at[k] + (side ? 1 : -1) * sin(step_rad) * across[k];
        sides[side] = value_at(profile, direction);
    }
    return fold->place.order == LX_JUMP ? fabs(sides[1] - sides[0])
                                        : fabs(sides[1] + sides[0] - 2 * value_at(profile, at));
}

/* The bend of a cone, where the axis and a vector at right angles to it span a half-plane. */
static double bend_of_cone(const struct lx_fold *fold, const double aside[3], double step_rad)
{
    const double *axis = fold->place.axis, sine = sin(fold->place.angle_rad), cosine = cos(fold->place.angle_rad);
    double at[3], across[3];
    for (int k = 0; k < 3; k++) {
        at[k] = cosine * axis[k] + sine * aside[k];
        across[k] = cosine * aside[k] - sine * axis[k];
    }
    return bend_at(fold, at, across, step_rad);
}

/* The greatest one all around. */
static double greatest_around(const struct lx_fold *fold, int count, double step_rad)
{
    double first[3], second[3], greatest = 0;
    lx_around_axis(fold->place.axis, first, second);
    for (int i = 0; i < count; i++) {
        const double turn = 2 * M_PI * i / count;
        double aside[3];
        for (int k = 0; k < 3; k++)
            aside[k] = cos(turn) * first[k] + sin(turn) * second[k];
        greatest = fmax(greatest, bend_of_cone(fold, aside, step_rad));
    }
    return greatest;
}

/* The normal of the plane that a fold is part of, if it is no cone. */
static void normal_of(const struct lx_break *place, double normal[3])
{
    if (place->shape == LX_BREAK_PLANE)
        memcpy(normal, place->axis, sizeof place->axis);
    else
        lx_cross(place->axis, place->begin, normal);
}

/* How much the profile bends where a fold crosses what is seen in a direction, so far around it; 0: it does not. */
static double bend_across(const struct lx_fold *fold, const double direction[3], double width_rad)
{
    const struct lx_break *place = &fold->place;
    const double along = lx_dot(direction, place->axis);
    double aside[3], normal[3];
    if (place->shape == LX_BREAK_CONE) {
        const double off = acos(fmax(-1, fmin(1, along)));
        if (fabs(off - place->angle_rad) > width_rad)
            return 0;
        for (int k = 0; k < 3; k++)
            aside[k] = direction[k] - along * place->axis[k];
        return off <= width_rad || !(lx_normalize(aside) > 0) ? greatest_around(fold, AROUND_POLE, NEAR * width_rad)
                                                              : bend_of_cone(fold, aside, NEAR * width_rad);
    }
    normal_of(place, normal);
    const double beside = lx_dot(direction, normal);
    if (fabs(beside) > sin(width_rad) ||
        (place->shape == LX_BREAK_HALF_PLANE && lx_dot(direction, place->begin) < -sin(width_rad)))
        return 0;
    for (int k = 0; k < 3; k++)
        aside[k] = direction[k] - beside * normal[k];
    lx_normalize(aside);
    return bend_at(fold, aside, normal, NEAR * width_rad);
}

/* ---- making ---- */

/* The flux that wide cells all along a line of a table miss, as a share of all its light. */
static double missed_of_table(const struct lx_fold *fold)
{
    const struct lx_distribution *table = fold->emitter->profile.luminaire->distribution;
    const double step_rad = NEAR * WIDE;
    double greatest = 0, normal[3];
    if (fold->place.shape == LX_BREAK_CONE) {
        greatest = sin(fold->place.angle_rad) * greatest_around(fold, AROUND, step_rad);
    } else {
        normal_of(&fold->place, normal);
        for (int i = 1; i < AROUND; i++) {
            const double polar = M_PI * i / AROUND;
            double at[3];
            for (int k = 0; k < 3; k++)
                at[k] = cos(polar) * fold->place.axis[k] + sin(polar) * fold->place.begin[k];
            greatest = fmax(greatest, bend_at(fold, at, normal, step_rad) / 2);
        }
    }
    return MISSED * 2 * WIDE * PER_DIAGONAL * greatest / table->solid_angle;
}

static int add_folds(const struct lx_emitter *emitter, double share, struct lx_folds *folds)
{
    struct lx_fold fold = {.emitter = emitter};
    for (size_t i = 0; lx_profile_break(&emitter->profile, i, &fold.place); i++) {
        if (emitter->profile.luminaire && missed_of_table(&fold) <= fmax(share, SMOOTH))
            continue;
        if (lx_reserve(&folds->items, &folds->capacity, folds->count + 1, sizeof *folds->items))
            return -1;
        folds->items[folds->count++] = fold;
    }
    return 0;
}

int lx_folds_make(const struct lx_emitters *emitters, double share, struct lx_folds *folds)
{
    const size_t count = lx_item_count(emitters);
    *folds = (struct lx_folds){0};
    for (size_t i = 0; i < count; i++)
        if (lx_is_point(&emitters->items[i]) && add_folds(&emitters->items[i], share, folds))
            return -1;
    return 0;
}

void lx_folds_clear(struct lx_folds *folds)
{
    free(folds->items);
    *folds = (struct lx_folds){0};
}

/* ---- cells ---- */

static double cosine_of(const struct lx_tile_cell *cell, const double direction[3])
{
    double greatest = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        greatest = fmax(greatest, -lx_dot(cell->normal[q], direction));
    return greatest;
}

static bool is_hidden(const struct lx_prepared *shadows, size_t surface, const struct lx_tile_cell *cell,
                      const struct lx_emitter *emitter)
{
    const struct lx_element element = {.place_mm = lx_exact3(cell->center_mm),
                                       .normal = lx_exact3(cell->normal[0]),
                                       .own = &shadows->surfaces[surface],
                                       .is_free = true};
    return lx_openness_of(shadows, &element, emitter).value < 0.5;
}

/* What the light would give where its profile is 1. */
static double whole_irradiance(const struct lx_emitter *emitter, const struct lx_tile_cell *cell)
{
    struct lx_emitter bare = *emitter;
    bare.profile = lx_profile_isotropic();
    const struct lx_sample sample = lx_emitter_sample(&bare, lx_exact3(cell->center_mm));
    return sample.on_element ? 0 : sample.e_perp.value;
}

struct lx_beside lx_folds_beside(const struct lx_folds *folds, const struct lx_tile_cell *cell,
                                 const struct lx_prepared *shadows, size_t surface)
{
    struct lx_beside beside = {0, 0};
    double direction[3] = {0}, width_rad = 0;
    for (size_t i = 0; i < folds->count; i++) {
        const struct lx_emitter *emitter = folds->items[i].emitter;
        if (i == 0 || emitter != folds->items[i - 1].emitter) {
            for (int k = 0; k < 3; k++)
                direction[k] = cell->center_mm[k] - emitter->position_mm[k];
            const double away = lx_normalize(direction);
            width_rad = cell->radius_mm < away ? asin(cell->radius_mm / away) : M_PI / 2;
        }
        const double bend = bend_across(&folds->items[i], direction, width_rad);
        const double cosine = bend > 0 ? cosine_of(cell, direction) : 0;
        if (!(cosine > 0) || (shadows && is_hidden(shadows, surface, cell, emitter)))
            continue;
        const double flux = MISSED * bend * cosine * whole_irradiance(emitter, cell) * lx_cell_area(cell);
        if (folds->items[i].place.order == LX_JUMP)
            beside.jumps += flux;
        else
            beside.bends += flux;
    }
    return beside;
}
