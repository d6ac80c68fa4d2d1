/* SPDX-License-Identifier: MIT */
/*
 * GMRES (Saad and Schultz 1986), with Givens rotations, and products by rows in parallel.  Sums of vectors go in one
 * order, so that the digits do not depend on the number of threads.
 */
#include "linear.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "links.h"
#include "solution.h"

enum { MOST_STEPS = 120 };

/* A product under way. */
struct product {
    const struct lx_linear *linear;
    const float *sent; /* rho x at the nodes of groups */
    double *sum;
};

static double row_of(const struct lx_links *row, const float *sent)
{
    double total = 0;
    for (size_t i = 0; i < row->weight_count; i++) {
        const struct lx_weights *weights = &row->weights[i];
        const float *values = sent + (size_t)weights->group * LX_RULE_NODES;
        float sums[4] = {0};
        for (int q = 0; q < LX_RULE_NODES; q += 4)
            for (int k = 0; k < 4; k++)
                sums[k] += weights->of[q + k] * values[q + k];
        total += (double)((sums[0] + sums[1]) + (sums[2] + sums[3]));
    }
    return total;
}

static void multiply_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct product *product = data;
    (void)worker;
    (void)is_caller;
    for (size_t t = first; t < last; t++) {
        const struct lx_rows *rows = product->linear->reflected->tiles[t].rows;
        if (product->linear->reflected->tiles[t].is_blind)
            continue;
        double *sum = product->sum + t * LX_RULE_NODES;
        for (int q = 0; q < lx_rows_nodes(rows); q++)
            sum[q] = row_of(&rows->of[q], product->sent);
        lx_rows_spread(rows, sum);
    }
}

/* rho x / scale at the nodes of groups; false: memory ran out. */
static bool send(const struct lx_linear *linear, const double *x, double scale, float *sent)
{
    const size_t count = linear->reflected->group_count * LX_RULE_NODES;
    double *tiles = lx_new_array(linear->count, sizeof *tiles), *groups = lx_new_array(count, sizeof *groups);
    const bool has_room = tiles && groups;
    for (size_t i = 0; i < linear->count && has_room; i++)
        tiles[i] = linear->reflectance[i] * x[i] / scale;
    if (has_room)
        lx_groups_lift(linear->reflected, tiles, groups);
    for (size_t i = 0; i < count && has_room; i++)
        sent[i] = (float)groups[i];
    free(tiles);
    free(groups);
    return has_room;
}

bool lx_linear_bounce(const struct lx_linear *linear, const double *right, const double *x, double *sum)
{
    float *sent = lx_new_array(linear->reflected->group_count * LX_RULE_NODES, sizeof *sent);
    double largest = 0;
    for (size_t i = 0; i < linear->count; i++)
        largest = fmax(largest, fabs(linear->reflectance[i] * x[i]));
    /* float32 numbers would not hold every strength of light */
    const double scale = largest > 0 ? ldexp(1, ilogb(largest)) : 1;
    struct product product = {linear, sent, sum};
    const struct lx_rows_part part = {.last = (unsigned)linear->reflected->tile_count,
                                      .tile_rows = 4,
                                      .counts_itself = true,
                                      .work = multiply_rows,
                                      .data = &product};
    const bool whole =
        sent && send(linear, x, scale, sent) && lx_rows_run_part(linear->control, linear->threads, &part);
    for (size_t i = 0; i < linear->count && whole; i++)
        sum[i] = scale * sum[i] + (right ? right[i] : 0);
    free(sent);
    return whole;
}

static double dot(const double *a, const double *b, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* The basis of Krylov's space and what the rotations left of the small system. */
struct krylov {
    double *basis; /* MOST_STEPS + 1 vectors */
    double column[MOST_STEPS][MOST_STEPS + 1];
    double cosine[MOST_STEPS], sine[MOST_STEPS], rest[MOST_STEPS + 1];
};

static void rotate(struct krylov *krylov, int step)
{
    double *column = krylov->column[step];
    for (int k = 0; k < step; k++) {
        const double upper = krylov->cosine[k] * column[k] + krylov->sine[k] * column[k + 1];
        column[k + 1] = krylov->cosine[k] * column[k + 1] - krylov->sine[k] * column[k];
        column[k] = upper;
    }
    const double length = hypot(column[step], column[step + 1]);
    krylov->cosine[step] = length > 0 ? column[step] / length : 1;
    krylov->sine[step] = length > 0 ? column[step + 1] / length : 0;
    column[step] = length;
    krylov->rest[step + 1] = -krylov->sine[step] * krylov->rest[step];
    krylov->rest[step] *= krylov->cosine[step];
}

/* The next vector of the basis, orthogonal to all before. */
static bool extend(const struct lx_linear *linear, struct krylov *krylov, int step)
{
    const size_t count = linear->count;
    const double *from = krylov->basis + (size_t)step * count;
    double *next = krylov->basis + (size_t)(step + 1) * count;
    if (!lx_linear_bounce(linear, NULL, from, next))
        return false;
    for (size_t i = 0; i < count; i++)
        next[i] = from[i] - next[i];
    for (int k = 0; k <= step; k++) {
        const double *other = krylov->basis + (size_t)k * count, share = dot(next, other, count);
        krylov->column[step][k] = share;
        for (size_t i = 0; i < count; i++)
            next[i] -= share * other[i];
    }
    const double length = sqrt(dot(next, next, count));
    krylov->column[step][step + 1] = length;
    for (size_t i = 0; i < count && length > 0; i++)
        next[i] /= length;
    return true;
}

static void add_up(const struct krylov *krylov, int steps, size_t count, double *x)
{
    double share[MOST_STEPS];
    for (int k = steps - 1; k >= 0; k--) {
        share[k] = krylov->rest[k];
        for (int l = k + 1; l < steps; l++)
            share[k] -= krylov->column[l][k] * share[l];
        share[k] /= krylov->column[k][k];
    }
    for (int k = 0; k < steps; k++)
        for (size_t i = 0; i < count; i++)
            x[i] += share[k] * krylov->basis[(size_t)k * count + i];
}

int lx_linear_solve(const struct lx_linear *linear, const double *right, double *x)
{
    const size_t count = linear->count;
    const double length = sqrt(dot(right, right, count));
    struct krylov *krylov = lx_new_array(1, sizeof *krylov);
    bool whole = krylov && (krylov->basis = lx_new_array((MOST_STEPS + 1) * count, sizeof *krylov->basis));
    int steps = 0;
    memset(x, 0, count * sizeof *x);
    for (size_t i = 0; i < count && whole && length > 0; i++)
        krylov->basis[i] = right[i] / length;
    if (whole)
        krylov->rest[0] = length;
    while (whole && length > 0 && steps < MOST_STEPS && fabs(krylov->rest[steps]) > linear->rest * length) {
        whole = extend(linear, krylov, steps);
        if (whole)
            rotate(krylov, steps++);
    }
    if (whole)
        add_up(krylov, steps, count, x);
    if (krylov)
        free(krylov->basis);
    free(krylov);
    return whole ? 0 : -1;
}
