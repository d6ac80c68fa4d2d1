/* SPDX-License-Identifier: MIT */
/* Which luminaires polynomials do for over a square of pixels, and what they add to it. */
#include "tabled.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../light/distribution.h"
#include "../plan.h"
#include "../seen.h"
#include "../shader.h"
#include "smooth.h"

/*
 * Bases, with wide ellipses for few nodes: angles are bounded loosely, and enter multiplied by the slopes of tables.
 */
static const struct {
    unsigned nodes;
    double reach;
} BASES[LX_TABLE_BASES] = {{8, 11}, {10, 7.5}, {12, 5.5}, {16, 4}};

/* How much of the distance from the axis a square and the ellipse around it may take: less than the root of 1/2. */
static const double MOST_OF_DISTANCE = 0.7;

/* Errors of the four numbers of a cell and of what is made of them: units in the last place of the greatest. */
static const double CELL_ROUNDINGS = 6;

static const double unit = 5.9604644775390625e-08; /* 2^-24 */

void lx_table_bases_make(struct lx_basis *bases)
{
    for (int b = 0; b < LX_TABLE_BASES; b++)
        lx_basis_make(BASES[b].nodes, BASES[b].reach, &bases[b]);
}

/* ---- luminaires of a surface ---- */

static const struct lx_pointed *luminaire_of(const struct lx_planned_surface *surface, size_t light)
{
    const struct lx_lights *lights = &surface->lights;
    return lights->cloud_count > 0 ? NULL : lights->exacts[light].luminaire;
}

static size_t find_luminaires(const struct lx_planned_surface *surface, uint32_t *which, uint32_t *runs)
{
    size_t count = 0;
    for (size_t r = 0; r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        for (size_t i = run->first; i < run->first + run->count; i++) {
            const struct lx_pointed *luminaire = luminaire_of(surface, i);
            if (!luminaire || !luminaire->distribution->even.cells)
                continue;
            if (which)
                which[count] = (uint32_t)i, runs[count] = (uint32_t)r;
            count++;
        }
    }
    return count;
}

int lx_luminaires_make(const struct lx_planned_surface *surface, struct lx_luminaires *made)
{
    *made = (struct lx_luminaires){.count = find_luminaires(surface, NULL, NULL)};
    if (made->count == 0)
        return 0;
    made->which = lx_new_array(made->count, sizeof *made->which);
    made->runs = lx_new_array(made->count, sizeof *made->runs);
    if (!made->which || !made->runs)
        return -1;
    find_luminaires(surface, made->which, made->runs);
    return lx_smooth_luminaires_make(&surface->lights, made->which, made->count, &made->evenly);
}

void lx_luminaires_clear(struct lx_luminaires *luminaires)
{
    free(luminaires->which);
    free(luminaires->runs);
    lx_smooth_lights_clear(&luminaires->evenly);
    *luminaires = (struct lx_luminaires){.count = 0};
}

/* ---- angles ---- */

/* How a luminaire sees the middle of a square, and how far its angles go from there. */
struct sight {
    double polar, azimuth, cosine, ahead[2]; /* ahead: cosine and sine of the azimuth */
    double polar_within, azimuth_within;     /* in the square */
    double polar_most, azimuth_most;         /* in the ellipse, as analytic functions: from the middle */
    double cosine_most;                      /* and the cosine itself */
};

/* The greatest |log(1 + z)| where |z| <= q. */
static double log_within(double q)
{
    return q < 1 ? -log1p(-q) : HUGE_VAL;
}

/*
 * With d the way to the place in the luminaire's frame, beside = sqrt((d0 + i d1)(d0 - i d1)), both factors change by
 * no more than the share q < 1 of what they are: the azimuth is half the difference of their logarithms over i, and the
 * polar angle that of d2 + i beside and d2 - i beside, whose product is r^2.  Whatever these do, with Re beside^2 > 0
 * and Re r^2 > 0 the real part of the polar angle stays between 0 and pi, and its imaginary part is half the logarithm
 * of the quotient of their sizes, each of which is between r^2 over the largest and the largest.
 */
static bool find_sight(const struct lx_pointed *luminaire, const double place[3], const struct lx_vicinity *at,
                       struct sight *sight)
{
    const struct lx_deviation *deviation = &at->place_deviation;
    const double real = deviation->first + deviation->second, tile = deviation->tile;
    const double all = lx_smaller(real + deviation->imaginary, at->straight);
    double way[3], d[3];
    for (int k = 0; k < 3; k++)
        way[k] = at->place[k] - place[k];
    for (int k = 0; k < 3; k++)
        d[k] = lx_dot(luminaire->frame_double[k], way);
    const double beside = sqrt(d[0] * d[0] + d[1] * d[1]), r = sqrt(lx_dot(d, d));
    const double least_square = (r - real) * (r - real) - deviation->imaginary * deviation->imaginary;
    if (!(all < MOST_OF_DISTANCE * beside && r > real && least_square > 0.01 * r * r))
        return false;
    const double q = all / beside, built = 1 - sqrt(1 - q), moved = beside * built * (2 + built);
    const double nearby = log_within((all + moved) / r), largest = r + all + moved;
    const double anywhere = M_PI + log(largest / sqrt(least_square));
    *sight = (struct sight){
        .polar = atan2(beside, d[2]),
        .azimuth = atan2(d[1], d[0]),
        .cosine = d[2] / r,
        .ahead = {d[0] / beside, d[1] / beside},
        .polar_within = 2 * asin(lx_smaller(tile / r, 1)),
        .azimuth_within = asin(lx_smaller(tile / beside, 1)),
        .polar_most = lx_smaller(nearby, anywhere),
        .azimuth_most = log_within(q),
        .cosine_most = (fabs(d[2]) + all) / sqrt(least_square),
    };
    return true;
}

/* Cells along one angle that a square may see. */
struct cells_seen {
    double first; /* the first one's number, from the table's beginning */
    size_t count;
};

/* Cells of polar angles, or of azimuths on less than a turn.  False: light may jump there.  None where all is dark. */
static bool see_cells(const struct lx_even_lines *lines, double angle, double within, bool has_jump,
                      struct cells_seen *seen)
{
    const double margin = 1e-6, middle = (angle - lines->start) * lines->per_radian;
    const double half = within * lines->per_radian + margin, last = (double)lines->cells - 1;
    const double low = middle - half, high = middle + half, end = (double)lines->cells;
    *seen = (struct cells_seen){0};
    if ((low > end && !lines->is_closed[1]) || (high < 0 && !lines->is_closed[0]))
        return true;
    if (has_jump && ((low < 0 && !lines->is_closed[0]) || (high > end && !lines->is_closed[1])))
        return false;
    seen->first = lx_smaller(lx_larger(floor(low), 0), last);
    seen->count = (size_t)(lx_smaller(lx_larger(floor(high), seen->first), last) - seen->first) + 1;
    return true;
}

/* Cells of azimuths of a whole turn. */
static void see_turn(const struct lx_even_lines *lines, double angle, double within, struct cells_seen *seen)
{
    const double cells = (double)lines->cells, half = within * lines->per_radian + 1e-6;
    const double low = floor((angle - lines->start) * lines->per_radian - half);
    const double high = floor((angle - lines->start) * lines->per_radian + half);
    seen->first = low - cells * floor(low / cells);
    seen->count = (size_t)lx_smaller(high - low + 1, cells);
}

/* A luminaire over a square. */
struct fit {
    const struct lx_pointed *luminaire;
    struct sight sight;
    struct cells_seen polar, azimuth;
    struct lx_even_extent extent;
    double most, error; /* of its light if it shone evenly, as an analytic function; and of what polynomials give */
    double slope;       /* of the table for a unit of the cosine, by which a cell's share is found */
};

static bool is_by_cosine(const struct lx_pointed *luminaire)
{
    return luminaire->distribution->interpolation == LUXEL_INTERPOLATE_COSINE;
}

/* For a unit of the cosine, at most, how many cells there are where the square sees the table. */
static double steps_of_cosine(const struct lx_even_table *even, const struct cells_seen *seen)
{
    const double *cosine = even->cosines + (size_t)seen->first;
    double least = HUGE_VAL;
    for (size_t j = 0; j < seen->count; j++)
        least = lx_smaller(least, cosine[j] - cosine[j + 1]);
    return 1 / least;
}

/*
 * Whether a luminaire fits, and what it is off by: the light by the share of its bound that the basis tells, and g by
 * that of the angles' bounds, in cells, times what g changes by in a cell.  By the cosine the polar angle chooses the
 * cell alone: beyond its end g goes on as it was, and differs from what it should be by no more than four times that.
 */
static bool find_fit(const struct lx_planned_surface *surface, const struct lx_luminaires *luminaires, size_t i,
                     const struct lx_vicinity *at, const struct lx_basis *basis, double most, struct fit *fit)
{
    const struct lx_light_double *light = &surface->lights.exacts[luminaires->which[i]];
    const struct lx_distribution *distribution = light->luminaire->distribution;
    const struct lx_even_table *even = &distribution->even;
    const double place[3] = {light->x, light->y, light->z};
    const bool has_jump = !(distribution->slope < HUGE_VAL);
    *fit = (struct fit){.luminaire = light->luminaire, .most = most};
    if (!(most >= 0 && most < HUGE_VAL) || !find_sight(light->luminaire, place, at, &fit->sight))
        return false;
    const struct sight *sight = &fit->sight;
    if (!see_cells(&even->polar, sight->polar, sight->polar_within, has_jump, &fit->polar))
        return false;
    if (distribution->table_double.is_axial)
        fit->azimuth.count = 1;
    else if (even->is_turn)
        see_turn(&even->azimuth, sight->azimuth, sight->azimuth_within, &fit->azimuth);
    else if (!see_cells(&even->azimuth, sight->azimuth, sight->azimuth_within, has_jump, &fit->azimuth))
        return false;
    if (fit->polar.count > LX_MOST_LINES)
        return false;
    const size_t first[2] = {(size_t)fit->azimuth.first, (size_t)fit->polar.first};
    const size_t count[2] = {fit->azimuth.count, fit->polar.count};
    fit->extent = lx_even_extent_of(even, first, count);
    double off = fit->extent.along * even->polar.per_radian * sight->polar_most;
    if (is_by_cosine(light->luminaire)) {
        fit->slope = fit->extent.along * steps_of_cosine(even, &fit->polar);
        off = 4 * off + fit->slope * sight->cosine_most;
    }
    off += fit->extent.across * even->azimuth.per_radian * sight->azimuth_most;
    fit->error = most * basis->share * (fit->extent.greatest + off);
    return true;
}

/* ---- polynomials ---- */

/* A square, and the basis that is tried. */
struct work {
    const struct lx_plan *plan;
    struct lx_fitting *fitting;
    struct lx_shader_memory *shader;
    const struct lx_square *square;
    const struct lx_basis *basis;
    bool has_nodes; /* the elements at the nodes of the basis are there */
};

static double make_polynomial(const struct work *work, const double *values, struct lx_polynomial *polynomial)
{
    polynomial->side = work->square->side;
    polynomial->power = 1;
    return work->plan->kernels->find_polynomial(work->basis->series, work->basis->nodes, values, polynomial);
}

/* The largest size of the polynomials; terms beyond their own sizes are 0. */
static unsigned size_of_all(const struct lx_tabled *tabled)
{
    const struct lx_polynomial *all[] = {&tabled->brightness, &tabled->polar, &tabled->azimuth, &tabled->cosine};
    unsigned size = 0;
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        size = all[k]->size > size ? all[k]->size : size;
    return size;
}

/* Makes the polynomials of a luminaire that fits; returns what roundings may make its light off by. */
static double make_tabled(const struct work *work, const struct fit *fit, const struct lx_light_double *light,
                          struct lx_tabled *tabled)
{
    const struct lx_kernels *kernels = work->plan->kernels;
    const struct lx_block_double *block = &lx_shader_seen(work->shader)->block;
    const struct lx_even_table *even = &fit->luminaire->distribution->even;
    const size_t nodes = (size_t)work->basis->nodes * work->basis->nodes, padded = lx_padded(nodes);
    const double place[3] = {light->x, light->y, light->z};
    _Alignas(64) double brightness[LX_BLOCK], polar[LX_BLOCK], azimuth[LX_BLOCK], cosines[LX_BLOCK];
    struct lx_light_double evenly = *light;
    evenly.luminaire = NULL;
    *tabled = (struct lx_tabled){
        .is_axial = fit->luminaire->distribution->table_double.is_axial,
        .by_cosine = is_by_cosine(fit->luminaire),
        .cells = (const lx_even_cell *)even->cells,
        .row = (int)even->polar.cells,
        .first_polar = (int)fit->polar.first,
        .first_azimuth = (int)fit->azimuth.first,
        .polar_count = (int)fit->polar.count,
        .azimuth_count = (int)fit->azimuth.count,
        .turn = even->is_turn ? (int)even->azimuth.cells : INT_MAX,
    };
    kernels->set_all(brightness, padded, 0);
    kernels->shade_double(&evenly, NULL, 1, &work->square->surface->lobe_exact, block, NULL, NULL, nodes, brightness);
    kernels->find_angles(fit->luminaire, place, fit->sight.ahead, block, padded, polar,
                         tabled->by_cosine ? cosines : NULL, tabled->is_axial ? NULL : azimuth);
    double ahead = (fit->sight.azimuth - even->azimuth.start) * even->azimuth.per_radian - fit->azimuth.first;
    if (even->is_turn) /* to where the middle is among the cells that are seen */
        ahead -= (double)even->azimuth.cells * floor(ahead / (double)even->azimuth.cells);
    for (size_t i = 0; i < padded; i++)
        polar[i] = (polar[i] - even->polar.start) * even->polar.per_radian - fit->polar.first;
    for (size_t i = 0; i < padded && !tabled->is_axial; i++)
        azimuth[i] = azimuth[i] * even->azimuth.per_radian + ahead;
    for (size_t i = 0; i < padded && tabled->by_cosine; i++)
        cosines[i] -= fit->sight.cosine;
    for (size_t j = 0; j < fit->polar.count && tabled->by_cosine; j++) {
        const double *cosine = even->cosines + (size_t)fit->polar.first + j;
        tabled->start[j] = (float)(cosine[0] - fit->sight.cosine);
        tabled->per_step[j] = (float)(1 / (cosine[1] - cosine[0]));
    }
    const double of_brightness = make_polynomial(work, brightness, &tabled->brightness);
    double of_table = make_polynomial(work, polar, &tabled->polar) * fit->extent.along;
    if (tabled->by_cosine)
        of_table = 4 * of_table + (make_polynomial(work, cosines, &tabled->cosine) + unit) * fit->slope;
    of_table += CELL_ROUNDINGS * unit * fit->extent.greatest;
    if (!tabled->is_axial)
        of_table += make_polynomial(work, azimuth, &tabled->azimuth) * fit->extent.across;
    tabled->size = size_of_all(tabled);
    double greatest = 0;
    for (size_t i = 0; i < nodes; i++)
        greatest = lx_larger(greatest, brightness[i]);
    return of_brightness * fit->extent.greatest + (greatest + fit->error) * of_table;
}

/* ---- the square ---- */

/* Adds luminaires that the basis does for.  How many. */
static size_t add_by_basis(struct work *work, const struct lx_square_values *to, struct lx_allowance *allowance)
{
    const struct lx_plan *plan = work->plan;
    const struct lx_planned_surface *surface = work->square->surface;
    const struct lx_luminaires *luminaires = &surface->smooth.luminaires;
    struct lx_fitting *fitting = work->fitting;
    struct lx_vicinity *at = &fitting->vicinity;
    const double *x = luminaires->evenly.x, *y = luminaires->evenly.y, *z = luminaires->evenly.z;
    size_t left = 0, added = 0;
    for (size_t i = 0; i < luminaires->count; i++)
        left += fitting->is_left[luminaires->which[i]];
    if (left == 0 || !lx_find_vicinity(plan, work->square, work->basis, at))
        return 0;
    plan->kernels->bound_smooth(at, &luminaires->evenly, 0, luminaires->count, &surface->lobe_exact, fitting->sizes);
    const struct lx_ball part = lx_vicinity_ball(at);
    const double fair = allowance->error / (double)left;
    for (size_t i = 0; i < luminaires->count; i++) {
        uint8_t *is_left = &fitting->is_left[luminaires->which[i]];
        const struct lx_light_run *run = &surface->runs[luminaires->runs[i]];
        const struct lx_ball light = {.center = {x[i], y[i], z[i]}};
        struct fit fit;
        if (!*is_left || !find_fit(surface, luminaires, i, at, work->basis, fitting->sizes[i], &fit) ||
            fit.error > fair || lx_light_may_be_blocked(plan, surface, run, &part, &light))
            continue;
        if (fit.polar.count == 0 || fit.azimuth.count == 0 || !(fit.extent.greatest > 0) || fit.most == 0) {
            *is_left = 0, added++; /* it is dark there */
            continue;
        }
        if (!work->has_nodes)
            lx_gather_nodes(plan, lx_shader_seen(work->shader), work->square, work->basis, false);
        work->has_nodes = true;
        const double rounding = make_tabled(work, &fit, &surface->lights.exacts[luminaires->which[i]], fitting->tabled);
        if (!(rounding <= allowance->rounding))
            continue;
        plan->kernels->spread_tabled(fitting->tabled, to->rows, to->columns, to->values, to->stride);
        allowance->error -= fit.error;
        allowance->rounding -= rounding;
        *is_left = 0, added++;
    }
    return added;
}

size_t lx_add_tabled(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                     const struct lx_square *square, const struct lx_square_values *to, struct lx_allowance *allowance)
{
    size_t added = 0;
    for (int b = 0; b < LX_TABLE_BASES; b++) {
        struct work work = {plan, fitting, shader, square, &plan->table_bases[b], .has_nodes = false};
        added += add_by_basis(&work, to, allowance);
    }
    return added;
}
