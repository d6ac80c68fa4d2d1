/* SPDX-License-Identifier: MIT */
/* Adaptive sampling of extended sources for runs of elements. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "sampling.h"

enum { MOST_CELLS = LX_MOST_CELLS, DEEPEST = 40, QUARTERS = LX_QUARTERS, RULE = 3 };

/* Samples on a circle of what is round, by the finer rule, and of what is tiny. */
enum { SPOKES = 6, MORE_SPOKES = 8, FEW_SPOKES = 3, MOST_ON_CIRCLES = RULE * MORE_SPOKES };
_Static_assert((int)MOST_ON_CIRCLES <= (int)LX_MOST_SAMPLES, "there is room for the circles of a half");

/* Cells that are looked at between two questions whether to go on. */
enum { BETWEEN_CHECKS = 16 };

/* Shares of the tolerance for what is dropped unseen, and for what is not looked at again. */
static const double DROPPED = 0.125, SETTLED = 0.125;

struct cell {
    const struct lx_sampled *source;
    const struct lx_patch *patch;
    struct lx_cell part;
    int depth;
    bool is_tiny;                        /* coarse is one sample, the quarters are one each; few, if it is round */
    double doubt[LX_LANES];              /* where the lobe jumps in the cell: the difference counts as no less */
    double coarse[LX_LANES];             /* by the rule in all of it */
    double quarters[QUARTERS][LX_LANES]; /* by the rule in each quarter; if round, in the inner and outer half */
};

struct pending {
    const struct lx_sampled *source;
    const struct lx_patch *patch;
    struct lx_cell part;
    int depth;
    struct lx_sight sight;
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
    struct lx_receivers receivers;
    double known[LX_LANES], value[LX_LANES], error[LX_LANES]; /* error: of cells that are still looked at */
    double kept[LX_LANES];                                    /* value of those that are not */
    double sure[LX_LANES], kept_sure[LX_LANES];               /* what all cells, and these, give at least */
    double peak[LX_LANES];                                    /* the most that value and error have been */
    double dropped, settled; /* error of those that never were and those that are no more */
    size_t steps;
    bool is_stopped;
};

static bool goes_on(struct run *run)
{
    if (++run->steps % BETWEEN_CHECKS == 0 && !run->is_stopped)
        run->is_stopped = !lx_asking_goes_on(run->sampling->asking);
    return !run->is_stopped;
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

/* What the error may reach.  With nothing seen yet, light that bounds say is there, but that samples in float32 give 0
 * for, would else be looked for in ever smaller cells. */
static double allowed(const struct run *run)
{
    double greatest = run->sampling->least_maximum;
    for (int i = 0; i < LX_LANES; i++)
        greatest = lx_larger(greatest, run->known[i] + run->sure[i]);
    return lx_larger(run->sampling->tolerance * greatest, run->sampling->least);
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
    to->by_none = (float)from->by_none, to->by_root = (float)from->by_root, to->by_square = (float)from->by_square;
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

/* Begins samples of a patch in the memory; returns what those of a unit area shine with. */
static double begin_samples(const struct run *run, const struct lx_sampled *source, const struct lx_patch *patch)
{
    static const double metres[] = {
        [LX_INVERSE_SQUARE] = 1, [LX_PRACTICAL] = 1e-3, [LX_NO_ATTENUATION] = 1e-6, [LX_POLYNOMIAL] = 1e-6};
    struct lx_samples_double *samples = &run->memory->samples;
    samples->law = source->law;
    samples->k = source->emitter->k_mm;
    samples->by_none = source->emitter->coefficients[0];
    samples->by_root = source->emitter->coefficients[1];
    samples->by_square = source->emitter->coefficients[2];
    lx_patch_samples(patch, source->lamp->touch_mm, samples);
    return source->lamp->radiance * metres[source->law];
}

static void finish_samples(const struct run *run, const struct lx_sampled *source, size_t count)
{
    if (!source->in_double)
        copy_samples(&run->memory->samples, count, &run->memory->copy);
}

/* The light of all that is round between two shares of the radius. */
static void shade_rings(const struct run *run, const struct cell *cell, double from_s, double to_s, unsigned spokes,
                        double off, double *result)
{
    const unsigned rings = cell->is_tiny ? 1 : RULE;
    const double gain = begin_samples(run, cell->source, cell->patch);
    lx_round_samples(cell->patch, from_s, to_s, rings, spokes, off, gain, &run->memory->samples);
    finish_samples(run, cell->source, (size_t)rings * spokes);
    shade_samples(run, cell->source, 0, (size_t)rings * spokes, result);
}

static void shade_whole(const struct run *run, struct cell *cell)
{
    const unsigned side = cell->is_tiny ? 1 : RULE;
    if (lx_cell_is_round(cell->patch, &cell->part)) {
        shade_rings(run, cell, 0, 1, cell->is_tiny ? FEW_SPOKES : SPOKES, 0, cell->coarse);
        return;
    }
    const double gain = begin_samples(run, cell->source, cell->patch);
    lx_cell_samples(cell->patch, &cell->part, side, gain, 0, &run->memory->samples);
    finish_samples(run, cell->source, (size_t)side * side);
    shade_samples(run, cell->source, 0, (size_t)side * side, cell->coarse);
}

static void shade_quarters(const struct run *run, struct cell *cell)
{
    const unsigned side = cell->is_tiny ? 1 : RULE, points = side * side;
    if (lx_cell_is_round(cell->patch, &cell->part)) {
        const unsigned spokes = cell->is_tiny ? SPOKES : MORE_SPOKES;
        shade_rings(run, cell, 0, 0.5, spokes, 0.25, cell->quarters[0]);
        shade_rings(run, cell, 0.5, 1, spokes, 0.75, cell->quarters[1]);
        memset(&cell->quarters[2], 0, 2 * sizeof cell->quarters[2]);
        return;
    }
    const double gain = begin_samples(run, cell->source, cell->patch);
    for (int q = 0; q < QUARTERS; q++) {
        struct lx_cell part = lx_cell_quarter(cell->patch, &cell->part, q);
        lx_cell_samples(cell->patch, &part, side, gain, (size_t)q * points, &run->memory->samples);
    }
    finish_samples(run, cell->source, (size_t)QUARTERS * points);
    for (int q = 0; q < QUARTERS; q++)
        shade_samples(run, cell->source, (size_t)q * points, points, cell->quarters[q]);
}

/* What a cell gives to an element by its quarters, and how far the coarse rule is from that at least. */
static double fine_of(const struct cell *cell, int lane)
{
    return cell->quarters[0][lane] + cell->quarters[1][lane] + cell->quarters[2][lane] + cell->quarters[3][lane];
}

static double difference_of(const struct cell *cell, int lane)
{
    return lx_larger(fabs(fine_of(cell, lane) - cell->coarse[lane]), cell->doubt[lane]);
}

/* What it gives at least, be it that other cells are not known at all yet. */
static double sure_of(const struct cell *cell, int lane)
{
    return lx_larger(fine_of(cell, lane) - difference_of(cell, lane), 0);
}

/* Takes a cell whose rules have been applied into the list, or only into the sums where it hardly matters. */
static void enlist(struct run *run, const struct cell *cell)
{
    struct lx_sampling_memory *memory = run->memory;
    double worst = 0;
    for (int i = 0; i < LX_LANES; i++) {
        run->value[i] += fine_of(cell, i);
        run->sure[i] += sure_of(cell, i);
        worst = lx_larger(worst, difference_of(cell, i));
    }
    const double limit = SETTLED * allowed(run);
    const bool is_full = memory->cell_count == MOST_CELLS || cell->depth >= DEEPEST;
    const bool is_settled = is_full || (run->settled + worst <= limit && worst <= limit / 64);
    for (int i = 0; i < LX_LANES; i++) {
        run->kept[i] += is_settled ? fine_of(cell, i) : 0;
        run->kept_sure[i] += is_settled ? sure_of(cell, i) : 0;
        run->error[i] += is_settled ? 0 : difference_of(cell, i);
        run->peak[i] = lx_larger(run->peak[i], run->value[i] + run->error[i]);
    }
    if (is_settled) {
        run->settled += worst;
        return;
    }
    memory->worst[memory->cell_count] = worst;
    memory->cells[memory->cell_count++] = *cell;
}

/* Sums all cells anew where more has been taken off the sums than is left, which then is what rounding left. */
static void refresh_sums(struct run *run)
{
    const double worn = 1e-6;
    const struct lx_sampling_memory *memory = run->memory;
    bool is_worn = false;
    for (int i = 0; i < LX_LANES; i++)
        is_worn = is_worn || run->value[i] + run->error[i] < worn * run->peak[i];
    for (int i = 0; i < LX_LANES && is_worn; i++) {
        run->value[i] = run->kept[i];
        run->error[i] = 0;
        run->sure[i] = run->kept_sure[i];
        for (size_t c = 0; c < memory->cell_count; c++) {
            run->value[i] += fine_of(&memory->cells[c], i);
            run->error[i] += difference_of(&memory->cells[c], i);
            run->sure[i] += sure_of(&memory->cells[c], i);
        }
        run->peak[i] = run->value[i] + run->error[i];
    }
}

/* Takes a cell off the list and the sums. */
static struct cell delist(struct run *run, size_t index)
{
    struct lx_sampling_memory *memory = run->memory;
    const struct cell cell = memory->cells[index];
    memory->cell_count--;
    memory->cells[index] = memory->cells[memory->cell_count];
    memory->worst[index] = memory->worst[memory->cell_count];
    for (int i = 0; i < LX_LANES; i++) {
        run->value[i] -= fine_of(&cell, i);
        run->error[i] -= difference_of(&cell, i);
        run->sure[i] -= sure_of(&cell, i);
    }
    refresh_sums(run);
    return cell;
}

static int by_bound(const void *a, const void *b)
{
    double x = ((const struct pending *)a)->sight.bound, y = ((const struct pending *)b)->sight.bound;
    return (x > y) - (x < y);
}

/* Merges sorted halves of an order of what is pending, those with equal bounds as they were. */
static void merge(struct run *run, const struct pending *all, const uint32_t *from, size_t half, size_t count,
                  uint32_t *to)
{
    enum { BETWEEN_STEPS = 1024 };
    size_t i = 0, j = half;
    for (size_t k = 0; k < count && (k % BETWEEN_STEPS != 0 || goes_on(run)); k++)
        to[k] =
            j >= count || (i < half && all[from[i]].sight.bound <= all[from[j]].sight.bound) ? from[i++] : from[j++];
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
        lx_see(&run->receivers, last[i].source, last[i].patch, &last[i].part, limit, &last[i].sight);
    if (count <= QUARTERS)
        qsort(last, count, sizeof *last, by_bound);
    else
        sort_many(run, last, count);
}

/*
 * Whether light may be left out unseen.  Around an element that a large source is near to cells come in rings, each
 * twice as far as the one before and half as bright, the farthest last: one ring must not use up what is allowed for
 * all beyond it.
 */
static bool is_hardly_seen(const struct run *run, const struct pending *next)
{
    const double cells = next->patch->is_near ? 16 : 1;
    return run->dropped + cells * next->sight.bound <= DROPPED * allowed(run);
}

/* Drops, halves or evaluates what is pending. */
static void work_off(struct run *run)
{
    struct lx_sampling_memory *memory = run->memory;
    sort_out(run, memory->pending_count);
    while (memory->pending_count > 0 && goes_on(run)) {
        struct pending next = memory->pending[--memory->pending_count];
        if (next.sight.is_wide && memory->cell_count == MOST_CELLS) {
            run->dropped += next.sight.bound; /* no room to halve it, and the rule cannot be believed */
            continue;
        }
        if (next.sight.bound == 0 || is_hardly_seen(run, &next)) {
            run->dropped += next.sight.bound;
            continue;
        }
        if (next.sight.is_wide && next.depth < DEEPEST) {
            for (int q = 0; q < QUARTERS; q++)
                memory->pending[memory->pending_count++] = (struct pending){
                    .source = next.source,
                    .patch = next.patch,
                    .part = lx_cell_fourth(next.patch, &next.part, q),
                    .depth = next.depth + 1,
                };
            sort_out(run, QUARTERS);
            continue;
        }
        struct cell cell = {.source = next.source, .patch = next.patch, .part = next.part, .depth = next.depth};
        cell.is_tiny = next.sight.is_tiny;
        memcpy(cell.doubt, next.sight.doubt, sizeof cell.doubt);
        shade_whole(run, &cell);
        shade_quarters(run, &cell);
        enlist(run, &cell);
    }
}

static bool is_doubtful(const struct cell *cell)
{
    bool any = false;
    for (int i = 0; i < LX_LANES; i++)
        any = any || cell->doubt[i] > 0;
    return any;
}

/* What is in doubt in a part of a cell; nothing where nothing was in all of it. */
static void find_doubt(const struct run *run, const struct cell *parent, struct cell *part)
{
    if (!is_doubtful(parent))
        return;
    struct lx_sight sight;
    lx_see(&run->receivers, part->source, part->patch, &part->part, 0, &sight);
    memcpy(part->doubt, sight.doubt, sizeof part->doubt);
}

/* Replaces a cell by its quarters; one of few samples by the same with more.  Where the lobe jumps its size tells more
 * of the error than the rules. */
static void refine(struct run *run, size_t index)
{
    struct cell parent = delist(run, index);
    if (parent.is_tiny) {
        parent.is_tiny = false;
        shade_whole(run, &parent);
        shade_quarters(run, &parent);
        enlist(run, &parent);
        return;
    }
    const bool by_length = is_doubtful(&parent) && lx_cell_is_long(parent.patch, &parent.part);
    for (int q = 0; q < QUARTERS; q++) {
        struct cell part = {.source = parent.source, .patch = parent.patch, .depth = parent.depth + 1};
        part.part =
            by_length ? lx_cell_fourth(parent.patch, &parent.part, q) : lx_cell_quarter(parent.patch, &parent.part, q);
        find_doubt(run, &parent, &part);
        if (by_length || lx_cell_is_round(parent.patch, &parent.part))
            shade_whole(run, &part); /* its quarters were others, its halves no sectors */
        else
            memcpy(part.coarse, parent.quarters[q], sizeof part.coarse);
        shade_quarters(run, &part);
        enlist(run, &part);
    }
}

static bool is_done(const struct run *run)
{
    double greatest = 0;
    for (int i = 0; i < LX_LANES; i++)
        greatest = lx_larger(greatest, run->error[i]);
    return greatest + run->dropped + run->settled <= allowed(run);
}

/* A patch as the first cells; half turns are too long for the rule of Gauss. */
static void begin(struct run *run, const struct lx_sampled *source, const struct lx_patch *patch)
{
    struct lx_sampling_memory *memory = run->memory;
    const int parts = patch->kind == LX_PATCH_SIDE ? 2 : 1;
    for (int i = 0; i < parts; i++) {
        struct pending *first = &memory->pending[memory->pending_count++];
        *first = (struct pending){.source = source, .patch = patch, .part = {0, (double)i / parts, 1, 1.0 / parts}};
        first->depth = lx_cell_is_round(patch, &first->part) ? -1 : 0;
    }
}

/* Whether all elements are so near to the plane of a face that, against their height over it, places are rounded by
 * more than the tolerance. */
static bool is_edge_on(const struct run *run, const struct lx_area_light *lamp, const struct lx_patch *patch)
{
    const double enough = 16; /* so many roundings must fit into the tolerance */
    double height = run->around.radius;
    if (patch->kind != LX_PATCH_FLAT && patch->kind != LX_PATCH_DISK)
        return false;
    for (int k = 0; k < 3; k++)
        height += patch->n[k] * (run->around.center[k] - patch->o[k]);
    return height * run->sampling->tolerance < enough * lamp->touch_mm;
}

bool lx_sample_run(const struct lx_sampler *sampling, struct lx_sampling_memory *memory,
                   const struct lx_block_double *block, const struct lx_block_single *copy, size_t start, double *sum)
{
    struct run run = {.sampling = sampling, .memory = memory, .block = block, .copy = copy, .start = start};
    run.around = lx_run_around(block, start);
    lx_receivers_find(block, start, sampling->lobe, &run.receivers);
    for (int i = 0; i < LX_LANES; i++)
        run.known[i] = sum[i];
    memory->cell_count = memory->pending_count = 0;
    size_t patches = 0;
    for (size_t s = 0; s < sampling->source_count; s++) {
        const struct lx_sampled *source = &sampling->sources[s];
        if (source->lamp->is_general)
            return false;
        size_t count = lx_patches_make(source->lamp, &run.around, sampling->asking, memory->patches + patches);
        for (size_t i = 0; i < count && goes_on(&run); i++) {
            if (is_edge_on(&run, source->lamp, memory->patches + patches + i))
                return false;
            begin(&run, source, memory->patches + patches + i);
        }
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
