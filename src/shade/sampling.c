/* SPDX-License-Identifier: MIT */
/* Adaptive sampling of extended sources for runs of elements. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "sampling.h"

enum { MOST_CELLS = LX_MOST_CELLS, DEEPEST = 14, QUARTERS = 4, RULE = 3 };

/* Cells that are looked at between two questions whether to go on. */
enum { BETWEEN_CHECKS = 16 };

/* Cells up to this share of the lobe's width are begun with one sample against four. */
static const double TINY = 0.0625;

/* Of the light of a cell that a jump cuts this share is in doubt: a strip of this width lies between samples. */
static const double CUT_SHARE = 0.1;

/* Shares of the tolerance for what is dropped unseen, and for what is not looked at again. */
static const double DROPPED = 0.125, SETTLED = 0.125;

struct cell {
    const struct lx_sampled *source;
    const struct lx_patch *patch;
    struct lx_cell part;
    int depth;
    bool is_tiny;                        /* coarse is one sample, the quarters are one each */
    double doubt[LX_LANES];              /* where the lobe jumps in the cell: the difference counts as no less */
    double coarse[LX_LANES];             /* by the rule in all of it */
    double quarters[QUARTERS][LX_LANES]; /* by the rule in each quarter */
};

struct pending {
    const struct lx_sampled *source;
    const struct lx_patch *patch;
    struct lx_cell part;
    int depth;
    double bound; /* no element gets more light from it */
    bool is_wide; /* too large for the rule of Gauss */
    bool is_tiny;
    double doubt[LX_LANES];
};

struct lx_sampling_memory {
    struct lx_samples_double samples;
    struct lx_samples_single copy;
    size_t cell_count, pending_count;
    double worst[MOST_CELLS]; /* the largest difference in each cell */
    struct cell cells[MOST_CELLS];
    struct lx_patch *patches;
    struct pending *pending;
    uint32_t *order; /* twice as many as may be pending */
};

/* Halving one of those that are pending leaves three more. */
static size_t most_pending(size_t most_patches)
{
    return QUARTERS * most_patches + 3 * DEEPEST + 1;
}

size_t lx_sampling_memory_size(size_t most_patches)
{
    return sizeof(struct lx_sampling_memory) + most_patches * sizeof(struct lx_patch) +
           most_pending(most_patches) * (sizeof(struct pending) + 2 * sizeof(uint32_t));
}

struct lx_sampling_memory *lx_sampling_memory_of(void *bytes, size_t most_patches)
{
    struct lx_sampling_memory *memory = bytes;
    memory->patches = (void *)((char *)bytes + sizeof *memory);
    memory->pending = (void *)(memory->patches + most_patches);
    memory->order = (void *)(memory->pending + most_pending(most_patches));
    return memory;
}

/* ---- a run of elements ---- */

struct run {
    const struct lx_sampler *sampling;
    struct lx_sampling_memory *memory;
    const struct lx_block_double *block;
    const struct lx_block_single *copy;
    size_t start;
    struct lx_around around;
    double mirrored[LX_LANES][3];                             /* views */
    double width[LX_LANES];                                   /* of the lobe, as an angle of L */
    double known[LX_LANES], value[LX_LANES], error[LX_LANES]; /* error: of cells that are still looked at */
    double dropped, settled;                                  /* of those that are not */
    size_t steps;
    bool is_stopped;
};

static bool goes_on(struct run *run)
{
    if (++run->steps % BETWEEN_CHECKS == 0 && !run->is_stopped)
        run->is_stopped = !lx_asking_goes_on(run->sampling->asking);
    return !run->is_stopped;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct lx_around lx_run_around(const struct lx_block_double *block, size_t start)
{
    const double *places[3] = {block->px + start, block->py + start, block->pz + start};
    struct lx_around around = {.radius = 0};
    for (int k = 0; k < 3; k++) {
        double low = places[k][0], high = places[k][0];
        for (size_t i = 1; i < LX_LANES; i++) {
            low = places[k][i] < low ? places[k][i] : low;
            high = places[k][i] > high ? places[k][i] : high;
        }
        around.center[k] = low + (high - low) / 2;
        around.radius = hypot(around.radius, (high - low) / 2);
    }
    around.radius *= 1 + 1e-12;
    return around;
}

static void find_lobes(struct run *run)
{
    const double grazing = 0.15; /* lobes of half vectors get narrow towards the rim; below this the cells stay */
    const struct lx_block_double *block = run->block;
    const struct lx_lobe_double *lobe = run->sampling->lobe;
    double sigma = 1 / sqrt(fmax(lobe->exponent.value, 1));
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        size_t i = run->start + lane;
        double n[3] = {block->nx[i], block->ny[i], block->nz[i]}, v[3] = {block->vx[i], block->vy[i], block->vz[i]};
        double facing = dot(n, v);
        for (int k = 0; k < 3; k++)
            run->mirrored[lane][k] = 2 * facing * n[k] - v[k];
        run->width[lane] = lobe->model == LX_LAMBERT ? 1
                           : lobe->model == LX_PHONG ? sigma
                                                     : fmin(1, 2 * fmax(facing, grazing) * sigma);
    }
}

/* ---- bounds of cells ---- */

/* How a run sees a cell. */
struct sight {
    double radius[LX_LANES];     /* of a ball around it */
    double towards[LX_LANES][3]; /* unit, to its middle */
    double distance[LX_LANES];
    bool may[LX_LANES]; /* whether it may light the element at all */
};

/* Finds the directions, and for which elements the cell is in front of both. */
static void look(const struct run *run, const struct pending *cell, struct sight *sight)
{
    const struct lx_block_double *block = run->block;
    const struct lx_lobe_double *lobe = run->sampling->lobe;
    const struct lx_patch *patch = cell->patch;
    bool is_flat = patch->kind == LX_PATCH_FLAT || patch->kind == LX_PATCH_DISK;
    bool by_cosine = lobe->model == LX_LAMBERT || lobe->highlight != LX_HIGHLIGHT_PLAIN;
    double middle[3], radius = 0;
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        size_t i = run->start + lane;
        double place[3] = {block->px[i], block->py[i], block->pz[i]}, *towards = sight->towards[lane], above = 1;
        if (!is_flat || lane == 0)
            radius = lx_cell_look(patch, &cell->part, place, middle);
        for (int k = 0; k < 3; k++)
            towards[k] = middle[k] - place[k];
        double distance = sqrt(dot(towards, towards));
        if (is_flat)
            above = -dot(towards, patch->n);
        double height = block->nx[i] * towards[0] + block->ny[i] * towards[1] + block->nz[i] * towards[2];
        sight->may[lane] = radius >= 0 && above > 0 && (!by_cosine || height > -radius);
        sight->radius[lane] = radius;
        sight->distance[lane] = distance;
        for (int k = 0; k < 3; k++)
            towards[k] /= fmax(distance, DBL_MIN);
    }
}

/* The length of L + V towards the middle of the cell, less what it may be shorter elsewhere in it. */
static double half_length(const struct run *run, const struct sight *sight, size_t lane)
{
    const struct lx_block_double *block = run->block;
    const size_t i = run->start + lane;
    const double *l = sight->towards[lane];
    const double half[3] = {l[0] + block->vx[i], l[1] + block->vy[i], l[2] + block->vz[i]};
    return sqrt(dot(half, half)) - sight->radius[lane] / sight->distance[lane];
}

/* Whether the lobe jumps in the cell: at the horizon where it is gated, at L = -V, which has no half vector, and, where
 * S^n begins with an infinite slope, at S = 0, that is N.L = -N.V or R.V = 0.  `half`: the least length of L + V. */
static bool is_cut(const struct run *run, const struct sight *sight, size_t lane, double half)
{
    const struct lx_block_double *block = run->block;
    const struct lx_lobe_double *lobe = run->sampling->lobe;
    const double *l = sight->towards[lane], size = sight->radius[lane] / sight->distance[lane];
    size_t i = run->start + lane;
    if (lobe->model == LX_LAMBERT)
        return false;
    double height = block->nx[i] * l[0] + block->ny[i] * l[1] + block->nz[i] * l[2];
    if (lobe->highlight == LX_HIGHLIGHT_GATED && fabs(height) < size)
        return true;
    if (lobe->model == LX_BLINN_PHONG && !(half > 0))
        return true;
    if (lobe->exponent.value >= 1)
        return false;
    if (lobe->model == LX_PHONG)
        return fabs(dot(l, run->mirrored[lane])) < size;
    double facing = block->nx[i] * block->vx[i] + block->ny[i] * block->vy[i] + block->nz[i] * block->vz[i];
    return fabs(height + facing) < size;
}

/*
 * The largest square of S over the cell's places, for an element.  With A the angle between L and the mirrored view
 * and the cell seen under no more than rho from its middle, it is at most the square of cos(A - rho); the angle
 * between N and H is at least half that of L and the mirrored view.
 */
static double greatest_square(const struct run *run, const struct sight *sight, int lane)
{
    double cosine = fmin(dot(sight->towards[lane], run->mirrored[lane]), 1);
    double size = sight->radius[lane] / sight->distance[lane];
    if (!(size < 1))
        return 1;
    double around = sqrt(1 - size * size), sine = sqrt(fmax(1 - cosine * cosine, 0));
    double nearest = cosine >= around ? 1 : fmin(cosine * around + sine * size, 1);
    if (run->sampling->lobe->model == LX_BLINN_PHONG)
        return (1 + nearest) / 2;
    return nearest > 0 ? nearest * nearest : 0;
}

static double attenuate(const struct lx_sampled *source, double distance_mm)
{
    switch (source->law) {
    case LX_INVERSE_SQUARE: return 1 / (distance_mm * distance_mm);
    case LX_PRACTICAL: return 1e-3 / (source->k_mm + distance_mm);
    case LX_NO_ATTENUATION: break;
    }
    return 1e-6;
}

/* Sets the bound and the size of a cell.  What an element sees of less than `hardly` does not matter for the size. */
static void see(const struct run *run, double hardly, struct pending *cell)
{
    const double widest = 0.7, widths = 4; /* half sizes: in radians, and in widths of the lobe */
    const struct lx_lobe_double *lobe = run->sampling->lobe;
    bool is_matte = lobe->model == LX_LAMBERT;
    struct sight sight;
    look(run, cell, &sight);
    double weight = M_PI * cell->source->shell->radiance * (is_matte ? lobe->diffuse : lobe->specular);
    double greatest = 0, square = 0;
    for (int lane = 0; lane < LX_LANES; lane++) {
        double nearest = sight.distance[lane] - sight.radius[lane], radius = sight.radius[lane];
        double own = nearest > 0 ? weight * radius * radius * attenuate(cell->source, nearest) : HUGE_VAL;
        greatest = sight.may[lane] ? fmax(greatest, own) : greatest;
    }
    /* from where on S^n is worth looking at */
    double least_square = is_matte || !(hardly > 0) ? 0 : pow(fmin(hardly / greatest, 1), 2 / lobe->exponent.value);
    cell->is_wide = false;
    cell->is_tiny = true;
    for (int lane = 0; lane < LX_LANES; lane++) {
        cell->doubt[lane] = 0;
        if (!sight.may[lane])
            continue;
        double own = is_matte ? 1 : greatest_square(run, &sight, lane);
        square = fmax(square, own);
        if (own < least_square)
            continue;
        const double half = lobe->model == LX_BLINN_PHONG ? half_length(run, &sight, (size_t)lane) : 1;
        if (is_cut(run, &sight, (size_t)lane, half)) {
            double content = weight * 2 / M_PI * sight.radius[lane] * sight.radius[lane];
            content *= attenuate(cell->source, sight.distance[lane]) * pow(own, lobe->exponent.value / 2);
            cell->doubt[lane] = CUT_SHARE * content;
        }
        double width = fmin(widest, widths * run->width[lane]), radius = sight.radius[lane];
        width *= fmin(1, 2 * fmax(half, 0)); /* half vectors turn fast where they are short */
        double from = sight.distance[lane] - radius;
        cell->is_wide = cell->is_wide || !(radius <= width * from);
        cell->is_tiny = cell->is_tiny && cell->doubt[lane] == 0 && radius < TINY * width * from;
    }
    double power = is_matte ? 1 : pow(square, lobe->exponent.value / 2);
    cell->bound = !(square > 0) ? 0 : greatest < HUGE_VAL ? greatest * power : greatest;
}

/* What the error may reach. */
static double allowed(const struct run *run)
{
    double greatest = run->sampling->least_maximum;
    for (int i = 0; i < LX_LANES; i++)
        greatest = fmax(greatest, run->known[i] + run->value[i] - run->error[i]);
    return run->sampling->tolerance * greatest;
}

/* ---- evaluating cells ---- */

static void copy_samples(const struct lx_samples_double *from, size_t count, struct lx_samples_single *to)
{
    for (size_t i = 0; i < count; i++) {
        to->x[i] = (float)from->x[i], to->y[i] = (float)from->y[i], to->z[i] = (float)from->z[i];
        to->gain[i] = (float)from->gain[i];
    }
    to->bend = from->bend;
    to->ox = (float)from->ox, to->oy = (float)from->oy, to->oz = (float)from->oz;
    to->ax = (float)from->ax, to->ay = (float)from->ay, to->az = (float)from->az;
    to->nx = (float)from->nx, to->ny = (float)from->ny, to->nz = (float)from->nz;
    to->radius = (float)from->radius;
    to->height = (float)from->height;
    to->touch = (float)from->touch;
    to->law = from->law;
    to->k = (float)from->k;
}

/* The light of samples of the memory. */
static void shade_samples(const struct run *run, const struct lx_sampled *source, size_t first, size_t count,
                          double *result)
{
    const struct lx_sampler *sampling = run->sampling;
    struct lx_sampling_memory *memory = run->memory;
    if (source->in_double) {
        sampling->kernels->samples_double(&memory->samples, first, count, sampling->lobe, run->block, run->start,
                                          result);
        return;
    }
    float values[LX_LANES];
    sampling->kernels->samples_single(&memory->copy, first, count, sampling->lobe_single, run->copy, run->start,
                                      values);
    for (int i = 0; i < LX_LANES; i++)
        result[i] = (double)values[i];
}

static struct lx_cell quarter_of(const struct lx_cell *cell, int quarter)
{
    double ds = cell->ds / 2, dt = cell->dt / 2;
    return (struct lx_cell){cell->s + (quarter & 1 ? ds : 0), cell->t + (quarter & 2 ? dt : 0), ds, dt};
}

/* Puts samples of a cell into the memory. */
static void take_samples(const struct run *run, const struct lx_sampled *source, const struct lx_patch *patch,
                         const struct lx_cell *part, unsigned side, size_t first)
{
    static const double metres[] = {[LX_INVERSE_SQUARE] = 1, [LX_PRACTICAL] = 1e-3, [LX_NO_ATTENUATION] = 1e-6};
    struct lx_samples_double *samples = &run->memory->samples;
    samples->law = source->law;
    samples->k = source->k_mm;
    lx_patch_samples(patch, source->shell->touch_mm, samples);
    lx_cell_samples(patch, part, side, source->shell->radiance * metres[source->law], first, samples);
}

static void finish_samples(const struct run *run, const struct lx_sampled *source, size_t count)
{
    if (!source->in_double)
        copy_samples(&run->memory->samples, count, &run->memory->copy);
}

static void shade_whole(const struct run *run, struct cell *cell, unsigned side)
{
    take_samples(run, cell->source, cell->patch, &cell->part, side, 0);
    finish_samples(run, cell->source, (size_t)side * side);
    shade_samples(run, cell->source, 0, (size_t)side * side, cell->coarse);
}

static void shade_quarters(const struct run *run, struct cell *cell)
{
    unsigned side = cell->is_tiny ? 1 : RULE, points = side * side;
    for (int q = 0; q < QUARTERS; q++) {
        struct lx_cell part = quarter_of(&cell->part, q);
        take_samples(run, cell->source, cell->patch, &part, side, (size_t)q * points);
    }
    finish_samples(run, cell->source, (size_t)QUARTERS * points);
    for (int q = 0; q < QUARTERS; q++)
        shade_samples(run, cell->source, (size_t)q * points, points, cell->quarters[q]);
}

/* Adds (sign 1) or takes off (-1) what a cell has by its quarters, and the difference; returns the largest one. */
static double account(struct run *run, const struct cell *cell, double sign, bool is_open)
{
    double worst = 0;
    for (int i = 0; i < LX_LANES; i++) {
        double fine = cell->quarters[0][i] + cell->quarters[1][i] + cell->quarters[2][i] + cell->quarters[3][i];
        double difference = fmax(fabs(fine - cell->coarse[i]), cell->doubt[i]);
        run->value[i] += sign * fine;
        run->error[i] += is_open ? sign * difference : 0;
        worst = fmax(worst, difference);
    }
    return worst;
}

/* Takes a cell whose rules have been applied into the list, or only into the sums where it hardly matters. */
static void enlist(struct run *run, const struct cell *cell)
{
    struct lx_sampling_memory *memory = run->memory;
    double worst = account(run, cell, 1, false), limit = SETTLED * allowed(run);
    bool is_full = memory->cell_count == MOST_CELLS || cell->depth >= DEEPEST;
    if (is_full || (run->settled + worst <= limit && worst <= limit / 64)) {
        run->settled += worst;
        return;
    }
    account(run, cell, -1, false);
    account(run, cell, 1, true);
    memory->worst[memory->cell_count] = worst;
    memory->cells[memory->cell_count++] = *cell;
}

static int by_bound(const void *a, const void *b)
{
    double x = ((const struct pending *)a)->bound, y = ((const struct pending *)b)->bound;
    return (x > y) - (x < y);
}

/* Merges sorted halves of an order of what is pending, those with equal bounds as they were. */
static void merge(struct run *run, const struct pending *all, const uint32_t *from, size_t half, size_t count,
                  uint32_t *to)
{
    enum { BETWEEN_STEPS = 1024 };
    size_t i = 0, j = half;
    for (size_t k = 0; k < count && (k % BETWEEN_STEPS != 0 || goes_on(run)); k++)
        to[k] = j >= count || (i < half && all[from[i]].bound <= all[from[j]].bound) ? from[i++] : from[j++];
}

/* Sorts by bounds, in steps that can be stopped; there may be a million of them. */
static void sort_many(struct run *run, struct pending *all, size_t count)
{
    uint32_t *order = run->memory->order, *other = order + count;
    for (size_t i = 0; i < count; i++)
        order[i] = (uint32_t)i;
    for (size_t width = 1; width < count; width *= 2) {
        for (size_t first = 0; first < count && !run->is_stopped; first += 2 * width) {
            const size_t left = count - first, both = left < 2 * width ? left : 2 * width;
            merge(run, all, order + first, width < both ? width : both, both, other + first);
        }
        uint32_t *made = other;
        other = order;
        order = made;
    }
    /* item i has to come from order[i]: cycle by cycle */
    for (size_t i = 0; i < count && goes_on(run); i++) {
        if (order[i] == i)
            continue;
        const struct pending moved = all[i];
        size_t at = i;
        for (size_t from = order[at]; from != i; from = order[at]) {
            all[at] = all[from];
            order[at] = (uint32_t)at;
            at = from;
        }
        all[at] = moved;
        order[at] = (uint32_t)at;
    }
}

/* Looks at the last ones of what is pending; the brightest comes first then, so that soon it is known what matters. */
static void sort_out(struct run *run, size_t count)
{
    const double hardly = 1e-4; /* of what is allowed */
    struct lx_sampling_memory *memory = run->memory;
    struct pending *last = memory->pending + memory->pending_count - count;
    double limit = hardly * allowed(run);
    for (size_t i = 0; i < count && goes_on(run); i++)
        see(run, limit, &last[i]);
    if (count <= QUARTERS)
        qsort(last, count, sizeof *last, by_bound);
    else
        sort_many(run, last, count);
}

/* Drops, halves or evaluates what is pending. */
static void work_off(struct run *run)
{
    struct lx_sampling_memory *memory = run->memory;
    sort_out(run, memory->pending_count);
    while (memory->pending_count > 0 && goes_on(run)) {
        struct pending next = memory->pending[--memory->pending_count];
        if (next.is_wide && memory->cell_count == MOST_CELLS) {
            run->dropped += next.bound; /* no room to halve it, and the rule cannot be believed */
            continue;
        }
        if (next.bound == 0 || run->dropped + next.bound <= DROPPED * allowed(run)) {
            run->dropped += next.bound;
            continue;
        }
        if (next.is_wide && next.depth < DEEPEST) {
            for (int q = 0; q < QUARTERS; q++)
                memory->pending[memory->pending_count++] = (struct pending){
                    .source = next.source,
                    .patch = next.patch,
                    .part = quarter_of(&next.part, q),
                    .depth = next.depth + 1,
                };
            sort_out(run, QUARTERS);
            continue;
        }
        struct cell cell = {.source = next.source, .patch = next.patch, .part = next.part, .depth = next.depth};
        cell.is_tiny = next.is_tiny;
        memcpy(cell.doubt, next.doubt, sizeof cell.doubt);
        shade_whole(run, &cell, cell.is_tiny ? 1 : RULE);
        shade_quarters(run, &cell);
        enlist(run, &cell);
    }
}

/* What is in doubt in a part of a cell; nothing where nothing was in all of it. */
static void find_doubt(const struct run *run, const struct cell *parent, struct cell *part)
{
    bool any = false;
    for (int i = 0; i < LX_LANES; i++)
        any = any || parent->doubt[i] > 0;
    if (!any)
        return;
    struct pending look = {.source = part->source, .patch = part->patch, .part = part->part};
    see(run, 0, &look);
    memcpy(part->doubt, look.doubt, sizeof part->doubt);
}

/* Replaces a cell by its quarters; one of few samples by the same with more. */
static void refine(struct run *run, size_t index)
{
    struct lx_sampling_memory *memory = run->memory;
    struct cell parent = memory->cells[index];
    account(run, &parent, -1, true);
    memory->cell_count--;
    memory->cells[index] = memory->cells[memory->cell_count];
    memory->worst[index] = memory->worst[memory->cell_count];
    if (parent.is_tiny) {
        parent.is_tiny = false;
        shade_whole(run, &parent, RULE);
        shade_quarters(run, &parent);
        enlist(run, &parent);
        return;
    }
    for (int q = 0; q < QUARTERS; q++) {
        struct cell part = {.source = parent.source, .patch = parent.patch, .depth = parent.depth + 1};
        part.part = quarter_of(&parent.part, q);
        find_doubt(run, &parent, &part);
        for (int i = 0; i < LX_LANES; i++)
            part.coarse[i] = parent.quarters[q][i];
        shade_quarters(run, &part);
        enlist(run, &part);
    }
}

static bool is_done(const struct run *run)
{
    double greatest = 0;
    for (int i = 0; i < LX_LANES; i++)
        greatest = fmax(greatest, run->error[i]);
    return greatest + run->dropped + run->settled <= allowed(run);
}

/* A patch as the first cells; full turns are too long for the rule of Gauss. */
static void begin(struct run *run, const struct lx_sampled *source, const struct lx_patch *patch)
{
    struct lx_sampling_memory *memory = run->memory;
    int parts = patch->kind == LX_PATCH_FLAT ? 1 : patch->kind == LX_PATCH_SIDE ? 2 : 4;
    for (int i = 0; i < parts; i++)
        memory->pending[memory->pending_count++] =
            (struct pending){.source = source, .patch = patch, .part = {0, (double)i / parts, 1, 1.0 / parts}};
}

bool lx_sample_run(const struct lx_sampler *sampling, struct lx_sampling_memory *memory,
                   const struct lx_block_double *block, const struct lx_block_single *copy, size_t start, double *sum)
{
    struct run run = {.sampling = sampling, .memory = memory, .block = block, .copy = copy, .start = start};
    run.around = lx_run_around(block, start);
    find_lobes(&run);
    for (int i = 0; i < LX_LANES; i++)
        run.known[i] = sum[i];
    memory->cell_count = memory->pending_count = 0;
    size_t patches = 0;
    for (size_t s = 0; s < sampling->source_count; s++) {
        const struct lx_sampled *source = &sampling->sources[s];
        size_t count = lx_patches_make(source->shell, &run.around, sampling->asking, memory->patches + patches);
        for (size_t i = 0; i < count && goes_on(&run); i++)
            begin(&run, source, memory->patches + patches + i);
        patches += count;
    }
    work_off(&run);
    while (memory->cell_count > 0 && memory->cell_count + QUARTERS < sampling->most_cells && !is_done(&run) &&
           goes_on(&run)) {
        size_t index = 0;
        for (size_t i = 1; i < memory->cell_count; i++)
            index = memory->worst[i] > memory->worst[index] ? i : index;
        if (!(memory->worst[index] > 0))
            break;
        refine(&run, index);
    }
    for (int i = 0; i < LX_LANES; i++)
        sum[i] += run.value[i] > 0 ? run.value[i] : 0;
    return run.is_stopped || is_done(&run);
}
