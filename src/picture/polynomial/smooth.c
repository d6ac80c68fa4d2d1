/* SPDX-License-Identifier: MIT */
/* Which lights a polynomial does for over a square of pixels, and the polynomial. */
#include "smooth.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../world/among.h"
#include "../../world/blocking.h"
#include "../../world/general.h"
#include "../penumbra.h"
#include "../seen.h"
#include "../shader.h"
#include "../area_light_bound.h"

/*
 * The bases: how many nodes on each axis, and the half axes of the ellipses, found by trying (docs/KERNELS.md).  One is
 * not worth trying where the surface's radius is not more than so many times half the square's side.
 */
static const struct {
    unsigned nodes;
    double reach, least_radius;
} BASES[LX_BASES] = {{8, 9.5, 25}, {10, 7, 14}, {12, 5, 0}, {16, 3.6, 0}};

/* Lights that are summed between two questions whether to go on, and those that are bounded or taken; and that are
 * bounded at once, if any of them is left. */
enum { LIGHTS_BETWEEN_CHECKS = 128, BOUNDS_BETWEEN_CHECKS = 4096, BOUNDED_AT_ONCE = 64 };

/* Lights in a quarter of a panel that nodes do not do for and that are worth more nodes there; fewer are as soon summed
 * for each pixel. */
enum { MOST_FOR_PIXELS = 4 };

/* What lights cost that are left, in lights at nodes: each as much for so many pixels as at a node, and where they are
 * left over a whole panel, the trouble with its quarters. */
enum { PIXELS_A_NODE = 4, COST_OF_QUARTERS = 3000 };

/* What float32 may add to the error of a polynomial, of its largest value. */
static const double ROUNDINGS = 4e-7;

/* And in all: beyond that terms might be infinite in float32, and no number their sum. */
static const double MOST_ROUNDING = (double)FLT_EPSILON / 2 * (double)FLT_MAX;

/* What all of it may be, of the least brightness in the square: its own digits may count however faint it is. */
static const double OF_ITSELF = 1e-3;

/* ---- polynomials ---- */

/* Chebyshev's nodes: a function no larger than M in the ellipse of the given reach r is not farther from the polynomial
 * through n of them than 4 M/(r^(n - 1) (r - 1)) (Trefethen, Approximation Theory and Approximation Practice, theorem
 * 8.2); on the second axis that grows by no more than Lebesgue's constant, 1 + 2 ln(n)/pi.  Whatever is no larger than
 * e in the square is off by no more than e itself and, on both axes, the square of that constant times e. */
void lx_basis_make(unsigned nodes, double reach, struct lx_basis *basis)
{
    *basis = (struct lx_basis){.nodes = nodes, .reach = reach};
    const double lebesgue = 1 + 2 * log(nodes) / M_PI;
    basis->share = (1 + lebesgue) * 4 / (pow(reach, nodes - 1) * (reach - 1));
    basis->slip = (1 + lebesgue * lebesgue) / basis->share;
    for (unsigned i = 0; i < nodes; i++) {
        const double angle = M_PI * (i + 0.5) / nodes;
        const double place = cos(angle);
        double before = place, now = 1; /* of Chebyshev's polynomials, T_-1 = T_1 and T_0 */
        basis->place[i] = place;
        for (unsigned m = 0; m < nodes; m++) {
            const double next = 2 * place * now - before;
            basis->series[i][m] = (m > 0 ? 2 : 1) * now / nodes;
            before = now;
            now = next;
        }
    }
}

void lx_bases_make(struct lx_basis bases[LX_BASES])
{
    for (int b = 0; b < LX_BASES; b++)
        lx_basis_make(BASES[b].nodes, BASES[b].reach, &bases[b]);
}

/* ---- lights ---- */

/* The most that an area light shines with, in front of it. */
static double gain_of(const struct lx_planned_area_light *planned, double diffuse)
{
    const struct lx_area_light *lamp = &planned->lamp;
    return planned->by_reference ? HUGE_VAL : diffuse * lamp->radiance * lamp->section_mm2;
}

/* The parts that highlights are of, and numbers that stand for the profile of flat ones where they have none. */
static int make_parts(const struct lx_planned_surface *surface, struct lx_smooth *smooth)
{
    if (lx_smooth_parts_make(surface, &smooth->parts, &smooth->round))
        return -1;
    const size_t count = lx_padded(smooth->parts.count);
    double *numbers = lx_new_aligned(3 * count, sizeof *numbers);
    smooth->plain_parts = smooth->parts;
    smooth->plain_parts.inner = numbers;
    smooth->plain_parts.outer = numbers + count;
    smooth->plain_parts.exponent = smooth->plain_parts.is_broken = numbers + 2 * count;
    for (size_t i = 0; i < count && numbers; i++) {
        numbers[i] = -2;
        numbers[count + i] = -3;
        numbers[2 * count + i] = 0;
    }
    return numbers ? 0 : -1;
}

luxel_status lx_smooth_make(const struct lx_planned_surface *surface, double radius_mm, const struct lx_asking *asking,
                            struct lx_smooth *smooth)
{
    const struct lx_lights *lights = &surface->lights;
    smooth->pays = true;
    smooth->has_highlights = surface->glossy_count > 0;
    smooth->count = lights->count + surface->area_light_count;
    smooth->radius_mm = radius_mm;
    smooth->gains = lx_new_array(surface->area_light_count, sizeof *smooth->gains);
    if (!smooth->gains || lx_luminaires_make(surface, &smooth->luminaires) ||
        (smooth->has_highlights && make_parts(surface, smooth)))
        return LUXEL_ERROR_MEMORY;
    for (size_t s = 0; s < surface->area_light_count; s++)
        smooth->gains[s] = gain_of(&surface->area_lights[s], surface->lobe_exact.diffuse);
    return lx_smooth_lights_make(lights, asking, &smooth->lights);
}

void lx_smooth_clear(struct lx_smooth *smooth)
{
    lx_smooth_lights_clear(&smooth->lights);
    lx_smooth_lights_clear(&smooth->parts);
    lx_round_parts_clear(&smooth->round);
    lx_luminaires_clear(&smooth->luminaires);
    free(smooth->gains);
    free(smooth->plain_parts.inner);
}

/* ---- fitting ---- */

static size_t larger_count(size_t a, size_t b)
{
    return a > b ? a : b;
}

int lx_fitting_make(const struct lx_plan *plan, struct lx_fitting *fitting)
{
    size_t most = 0, parts = 0, most_round = 0;
    for (size_t s = 0; s < plan->surface_count; s++) {
        const struct lx_smooth *smooth = &plan->surfaces[s].smooth;
        most = larger_count(most, smooth->count);
        most_round = larger_count(most_round, smooth->round.count);
        parts = larger_count(parts, larger_count(smooth->parts.count, smooth->round.count));
    }
    const size_t count = lx_padded(most);
    *fitting = (struct lx_fitting){
        .is_left = lx_new_array((1 + LX_BASES) * count, 1),
        .sizes = lx_new_aligned(count, sizeof *fitting->sizes),
        .part_sizes = lx_new_aligned(lx_padded(parts), sizeof *fitting->part_sizes),
        .turned = lx_new_aligned(1, sizeof *fitting->turned),
        .polynomials = lx_new_aligned(1 + LX_MOST_FOLDED, sizeof *fitting->polynomials),
        .tabled = lx_new_aligned(1, sizeof *fitting->tabled),
    };
    if (!fitting->is_left || !fitting->sizes || !fitting->part_sizes || !fitting->turned || !fitting->polynomials ||
        !fitting->tabled || lx_round_lights_make(most_round, &fitting->round))
        return -1;
    *fitting->turned = (struct lx_block_double){.vx = {0}};
    for (size_t b = 0; b < LX_BASES; b++)
        fitting->how[b] = fitting->is_left + (1 + b) * count;
    return 0;
}

void lx_fitting_clear(struct lx_fitting *fitting)
{
    free(fitting->is_left);
    free(fitting->sizes);
    free(fitting->part_sizes);
    lx_smooth_lights_clear(&fitting->round);
    free(fitting->turned);
    free(fitting->polynomials);
    free(fitting->tabled);
}

/* How a light is taken. */
enum { NOT_TAKEN, WHOLE, FOLDED };

struct taken {
    const struct lx_basis *basis;
    const uint8_t *how;
    size_t count, folded; /* of lights */
    double error;
    double cost; /* HUGE_VAL where none is taken */
};

static size_t count_left(const struct lx_smooth *smooth, const struct lx_fitting *fitting)
{
    size_t left = 0;
    for (size_t i = 0; i < smooth->count; i++)
        left += fitting->is_left[i];
    return left;
}

/* The cost of polynomials for `taken` lights at nodes, and of summing the others for each pixel. */
static double cost_of(const struct lx_square *square, unsigned nodes, size_t taken, size_t left)
{
    const double further = square->side == LX_PANEL_SIDE && taken < left ? COST_OF_QUARTERS : 0;
    return (double)taken * nodes + (double)(left - taken) * (square->side * square->side / PIXELS_A_NODE) + further;
}

bool lx_light_may_be_blocked(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                             const struct lx_light_run *run, const struct lx_ball *part, const struct lx_ball *light)
{
    if (run->blocker_count == 0)
        return false;
    const bool endless = run->kind == LX_DISTANT;
    const double *anchor = surface->shape.anchor_mm;
    const uint32_t *blockers = surface->blockers + run->blocker_first;
    struct lx_found found;
    const bool is_found =
        run->blocker_count > LX_FEW_BOXES && lx_among_balls(plan->prepared, anchor, part, light, endless, &found);
    const size_t count = lx_found_count(&found, is_found, run->blocker_count);
    for (size_t b = 0; b < count; b++) {
        const uint32_t s = is_found ? found.items[b] : blockers[b];
        if ((!is_found || lx_is_among(blockers, run->blocker_count, s)) &&
            lx_shape_may_block(&plan->surfaces[s].shape, anchor, part, light, endless))
            return true;
    }
    return false;
}

/* Leaves lights, and extended sources, in whose way something may stand for some of the square. */
static void leave_shadows(const struct lx_plan *plan, struct lx_fitting *fitting,
                          const struct lx_planned_surface *surface)
{
    const struct lx_ball part = lx_vicinity_ball(&fitting->vicinity);
    double *const of_area_lights = fitting->sizes + surface->smooth.lights.count;
    for (size_t s = 0; s < surface->area_light_count; s++)
        if (surface->area_lights[s].blocker_count > 0 &&
            lx_area_light_may_be_hidden(plan, surface, &surface->area_lights[s], &part))
            of_area_lights[s] = HUGE_VAL;
    for (size_t r = 0; r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        const struct lx_smooth_lights *lights = &surface->smooth.lights;
        for (size_t i = run->first; run->blocker_count > 0 && i < run->first + run->count; i++) {
            const struct lx_ball light = {.center = {lights->x[i], lights->y[i], lights->z[i]}};
            if (fitting->is_left[i] && lx_light_may_be_blocked(plan, surface, run, &part, &light))
                fitting->sizes[i] = HUGE_VAL;
        }
    }
}

/* Bounds lights and area lights that are left in the vicinity, and maybe others.  False: the work is to stop. */
static bool bound_lights(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_square *square,
                         const struct lx_asking *asking)
{
    const struct lx_planned_surface *surface = square->surface;
    const struct lx_smooth *smooth = &surface->smooth;
    const size_t count = smooth->lights.count;
    for (size_t first = 0, end; first < count; first = end) {
        end = count - first < BOUNDED_AT_ONCE ? count : first + BOUNDED_AT_ONCE;
        if (end % BOUNDS_BETWEEN_CHECKS == 0 && !lx_asking_goes_on(asking))
            return false;
        if (memchr(fitting->is_left + first, 1, end - first))
            plan->kernels->bound_smooth(&fitting->vicinity, &smooth->lights, first, end, &surface->lobe_exact,
                                        fitting->sizes);
    }
    for (size_t s = 0; s < surface->area_light_count; s++)
        fitting->sizes[count + s] =
            lx_smooth_area_light_bound(&surface->area_lights[s].lamp, smooth->gains[s], &fitting->vicinity);
    leave_shadows(plan, fitting, surface);
    return true;
}

/* Takes lights as long as what they are off by together is allowed: first those that keep to a fair share.  None where
 * the work is to stop. */
static struct taken take_lights(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_square *square,
                                int b, double allowance, size_t left, const struct lx_asking *asking)
{
    const size_t lights = square->surface->smooth.count;
    const struct lx_basis *basis = &plan->bases[b];
    uint8_t *how = fitting->how[b];
    const struct taken none = {.basis = basis, .how = how, .cost = HUGE_VAL};
    struct taken taken = none;
    memset(how, NOT_TAKEN, lights);
    if (!lx_find_vicinity(plan, square, basis, &fitting->vicinity) || !bound_lights(plan, fitting, square, asking))
        return none;
    for (int round = 0; round < 2 && taken.count < left; round++) {
        const double limit = round == 0 ? allowance / (double)left : HUGE_VAL;
        for (size_t i = 0; i < lights; i++) {
            const bool is_folded = fitting->sizes[i] < 0;
            const double error = fabs(fitting->sizes[i]) * basis->share;
            if (i % BOUNDS_BETWEEN_CHECKS == BOUNDS_BETWEEN_CHECKS - 1 && !lx_asking_goes_on(asking))
                return none;
            if (!fitting->is_left[i] || how[i] || !(error <= limit && taken.error + error <= allowance) ||
                (is_folded && taken.folded == LX_MOST_FOLDED))
                continue;
            how[i] = is_folded ? FOLDED : WHOLE;
            taken.count++;
            taken.folded += is_folded;
            taken.error += error;
        }
    }
    if (taken.count > 0)
        taken.cost = cost_of(square, basis->nodes * basis->nodes, taken.count, left);
    return taken;
}

/* Takes lights with the basis that costs least.  Where it is all of them, it is the one that was tried last. */
static struct taken choose_lights(const struct lx_plan *plan, struct lx_fitting *fitting,
                                  const struct lx_square *square, double allowance, size_t left,
                                  const struct lx_asking *asking)
{
    const double half = lx_larger(square->half_mm[0], square->half_mm[1]);
    const size_t enough = square->side == LX_PANEL_SIDE ? left
                          : left < MOST_FOR_PIXELS      ? 1
                                                        : left - MOST_FOR_PIXELS + 1;
    struct taken best = {.cost = HUGE_VAL};
    for (int b = 0; b < LX_BASES && best.count < enough; b++) {
        const unsigned nodes = BASES[b].nodes * BASES[b].nodes;
        if (half * BASES[b].least_radius >= square->surface->smooth.radius_mm ||
            nodes * PIXELS_A_NODE >= square->side * square->side)
            continue;
        const struct taken taken = take_lights(plan, fitting, square, b, allowance, left, asking);
        best = taken.cost < best.cost ? taken : best;
    }
    return best;
}

void lx_gather_nodes(const struct lx_plan *plan, struct lx_seen *seen, const struct lx_square *square,
                     const struct lx_basis *basis, bool in_tiles)
{
    const struct lx_planned_surface *surface = square->surface;
    const struct lx_shape *shape = &surface->shape;
    struct lx_block_double *block = &seen->block;
    const unsigned nodes = basis->nodes;
    _Alignas(64) double x[LX_LANES], depth[LX_LANES], places[3][LX_LANES];
    double observer[3];
    for (unsigned i = 0; i < LX_LANES; i++)
        x[i] = square->x_mm + square->half_mm[0] * basis->place[i < nodes ? i : nodes - 1];
    _Static_assert((int)LX_MOST_NODES * LX_MOST_NODES <= (int)LX_BLOCK, "a block holds all nodes");
    for (unsigned j = 0; j < nodes; j++) {
        const struct lx_row_view view = lx_row_view_of(plan, square->y_mm - square->half_mm[1] * basis->place[j]);
        lx_meet_shape(plan->kernels, shape, &view, x, LX_LANES, depth, places[0], places[1], places[2]);
        for (unsigned i = 0; i < nodes; i++) {
            const size_t k = in_tiles ? lx_node_in_tiles(nodes, i, j) : (size_t)j * nodes + i;
            block->px[k] = places[0][i], block->py[k] = places[1][i], block->pz[k] = places[2][i];
        }
    }
    lx_seen_pad(block->px, (size_t)nodes * nodes);
    lx_seen_pad(block->py, (size_t)nodes * nodes);
    lx_seen_pad(block->pz, (size_t)nodes * nodes);
    const struct lx_origin eye = lx_eye_from(plan, surface);
    lx_complete_shape(plan->kernels, shape, lx_observer_from(plan, surface, observer), &eye, block, &seen->copy,
                      (size_t)nodes * nodes);
}

/* Sums the lights that are taken that way over the elements of a block; something else where the work is to stop.
 * False: an extended source is too near to one of them for the rules of its law. */
static bool sum_lights(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                       const struct lx_block_double *block, size_t count, const uint8_t *how, int wanted,
                       const struct lx_lobe_double *lobe, const struct lx_asking *asking, struct lx_light_room *room,
                       double *sum)
{
    const struct lx_lights *lights = &surface->lights;
    const size_t most = lights->cloud_count > 0 ? LX_MOST_IN_RUN : LIGHTS_BETWEEN_CHECKS;
    for (size_t r = 0; r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        for (size_t first = run->first, end = run->first + run->count, next; first < end; first = next) {
            for (next = first; next < end && next - first < most && how[next] == how[first];)
                next++;
            if (next - first == most && !lx_asking_goes_on(asking))
                return true;
            if (how[first] == wanted)
                plan->kernels->shade_double(lx_lights_double(lights, first, next - first, room), NULL, next - first,
                                            lobe, block, NULL, NULL, count, sum);
        }
    }
    uint8_t left[LX_BLOCK] = {0};
    for (size_t s = 0; s < surface->area_light_count; s++) {
        const struct lx_area_light *lamp = &surface->area_lights[s].lamp;
        if (how[surface->lights.count + s] != wanted)
            continue;
        if (surface->area_lights[s].emitter->attenuation == LX_INVERSE_SQUARE) {
            plan->kernels->light_by_area_light[lamp->type](lamp, lobe->diffuse, block, count, asking, sum);
            continue;
        }
        struct lx_area_light by_rules = *lamp;
        by_rules.nodes_each = 0; /* those are as good as a pixel needs it */
        plan->kernels->law_double[lamp->type](&by_rules, plan->node_rules, lobe->diffuse, block, count, asking, sum,
                                              left);
    }
    return !memchr(left, 1, count);
}

/* Adds the polynomial through sums at nodes; returns what it may be off by in float32. */
static double add_polynomial(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_basis *basis,
                             unsigned side, const double *sums)
{
    struct lx_polynomial *polynomial = &fitting->polynomials[fitting->count++];
    polynomial->side = side;
    polynomial->power = 1;
    return plan->kernels->find_polynomial(basis->series, basis->nodes, sums, polynomial);
}

/* The diffuse light of those that are folded, each on its own, without the fold: what falls on the surface less what
 * would if its normals were turned round.  Returns what they may be off by in float32. */
static double add_folded(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                         struct lx_fitting *fitting, const struct lx_block_double *block, const struct lx_basis *basis,
                         unsigned side, const uint8_t *how)
{
    const size_t nodes = (size_t)basis->nodes * basis->nodes, padded = lx_padded(nodes);
    struct lx_block_double *turned = fitting->turned;
    double rounding = 0;
    for (size_t i = 0; i < padded; i++) {
        turned->px[i] = block->px[i], turned->py[i] = block->py[i], turned->pz[i] = block->pz[i];
        turned->nx[i] = -block->nx[i], turned->ny[i] = -block->ny[i], turned->nz[i] = -block->nz[i];
    }
    for (size_t i = 0; i < surface->smooth.lights.count; i++) {
        if (how[i] != FOLDED)
            continue;
        _Alignas(64) double sum[LX_BLOCK], below[LX_BLOCK];
        const struct lx_light_double *light = lx_lights_double(&surface->lights, i, 1, &fitting->room);
        plan->kernels->set_all(sum, padded, 0);
        plan->kernels->set_all(below, padded, 0);
        plan->kernels->shade_double(light, NULL, 1, &surface->matte_exact, block, NULL, NULL, nodes, sum);
        plan->kernels->shade_double(light, NULL, 1, &surface->matte_exact, turned, NULL, NULL, nodes, below);
        for (size_t k = 0; k < padded; k++)
            sum[k] -= below[k];
        rounding += add_polynomial(plan, fitting, basis, side, sum);
    }
    return rounding;
}

/* The least of the sums at nodes; where they are of all lights it tells which quarters are fainter than they may be. */
static double find_least(const struct lx_basis *basis, const double *sums, double limit, bool are_all,
                         struct lx_fitting *fitting)
{
    const unsigned half = basis->nodes / 2; /* so many nodes of each axis are to the right, and below, the middle */
    const unsigned to[4] = {half * basis->nodes + half, half * basis->nodes, half, 0};
    double least[4] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (unsigned j = 0; j < half; j++)
        for (unsigned i = 0; i < half; i++)
            for (unsigned q = 0; q < 4; q++)
                least[q] = lx_smaller(least[q], sums[j * basis->nodes + i + to[q]]);
    for (unsigned q = 0; q < 4; q++)
        fitting->is_faint[q] = are_all && !(least[q] >= limit);
    return lx_smaller(lx_smaller(least[0], least[1]), lx_smaller(least[2], least[3]));
}

/* The only light that reaches a square; the number of all where there is none, or more. */
static size_t find_only_light(const struct lx_smooth *smooth, const struct lx_fitting *fitting)
{
    size_t only = smooth->count;
    for (size_t i = 0; i < smooth->count; i++) {
        if (fitting->sizes[i] == 0)
            continue;
        if (only < smooth->count)
            return smooth->count;
        only = i;
    }
    return only;
}

/*
 * Fits the foot of a highlight, which is all that the sums at nodes are: n times as steep as its n-th root is, it keeps
 * its digits only as the n-th power of the root's polynomial.  All lights are taken with the basis that was tried last.
 * False: there is no such foot, or it would be off by too much.
 */
static bool fit_foot(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_square *square,
                     const struct lx_basis *basis, double least, double *sums, double *error, double *rounding)
{
    const struct lx_smooth *smooth = &square->surface->smooth;
    const struct lx_lobe_double *lobe = &square->surface->lobe_exact;
    const size_t light = find_only_light(smooth, fitting), lights = smooth->lights.count;
    const double n = lobe->exponent.value;
    if (light >= lights || !LX_HAS_HIGHLIGHT(lobe->model) || LX_ENDS_AT_HORIZON(lobe->highlight) ||
        lobe->exponent.whole == 0 || !(least >= DBL_MIN))
        return false;
    const struct lx_foot foot = plan->kernels->bound_foot(&fitting->vicinity, &smooth->lights, light, lobe);
    if (!(foot.root < HUGE_VAL))
        return false;
    plan->kernels->find_roots(sums, lx_padded((size_t)basis->nodes * basis->nodes), n);
    const double rounded = add_polynomial(plan, fitting, basis, square->side, sums), off = foot.root * basis->share;
    fitting->polynomials[fitting->count - 1].power = lobe->exponent.whole;
    /* (q + d)^n - q^n is no more than n d (q + d)^(n - 1) */
    const double top = pow(foot.most, 1 / n) + off + rounded, slope = n * pow(top, n - 1);
    *error += slope * off;
    *rounding = slope * (rounded + (double)FLT_EPSILON * top); /* each product of the power is rounded once */
    const double lowest = pow(least, 1 / n);
    return n * (off + rounded + (double)FLT_EPSILON * lowest) <= OF_ITSELF * lowest;
}

bool lx_smooth_fit(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                   const struct lx_square *square, double uniform, bool alone, const struct lx_asking *asking,
                   double *allowance)
{
    const struct lx_planned_surface *surface = square->surface;
    const struct lx_smooth *smooth = &surface->smooth;
    struct lx_seen *seen = lx_shader_seen(shader);
    const size_t left = count_left(smooth, fitting);
    const struct taken taken = choose_lights(plan, fitting, square, *allowance, left, asking);
    const struct lx_basis *basis = taken.basis;
    fitting->count = 0;
    memset(fitting->is_faint, 0, sizeof fitting->is_faint);
    if (taken.count == 0)
        return false;
    _Alignas(64) double sum[LX_BLOCK];
    const size_t nodes = (size_t)basis->nodes * basis->nodes;
    lx_gather_nodes(plan, seen, square, basis, false);
    plan->kernels->set_all(sum, lx_padded(nodes), uniform);
    if (!sum_lights(plan, surface, &seen->block, nodes, taken.how, WHOLE, &surface->lobe_exact, asking, &fitting->room,
                    sum))
        return false;
    if (taken.folded > 0 && LX_HAS_HIGHLIGHT(surface->glossy_exact.model) &&
        !sum_lights(plan, surface, &seen->block, nodes, taken.how, FOLDED, &surface->glossy_exact, asking,
                    &fitting->room, sum))
        return false;
    const double least =
        alone ? find_least(basis, sum, taken.error / OF_ITSELF, taken.count == left, fitting) : HUGE_VAL;
    const bool has_digits = taken.error <= OF_ITSELF * least;
    double rounding, error = taken.error, maximum = plan->least_maximum;
    if (has_digits) {
        rounding = add_polynomial(plan, fitting, basis, square->side, sum);
        maximum = lx_larger(maximum, (double)fitting->polynomials[0].terms[0][0]);
    } else if (uniform > 0 || taken.count < left ||
               !fit_foot(plan, fitting, square, basis, least, sum, &error, &rounding)) {
        return false;
    }
    if (taken.folded > 0)
        rounding += add_folded(plan, surface, fitting, &seen->block, basis, square->side, taken.how);
    if (!(rounding <= ROUNDINGS * maximum && rounding <= MOST_ROUNDING && error <= *allowance) ||
        (has_digits && !(rounding + error <= OF_ITSELF * least)))
        return false;
    for (size_t i = 0; i < smooth->count; i++)
        fitting->is_left[i] &= taken.how[i] == NOT_TAKEN;
    *allowance -= error;
    return true;
}
