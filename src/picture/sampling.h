/* SPDX-License-Identifier: MIT */
/*
 * Sampling: the highlights of extended sources in pictures, and their diffuse light by laws other than 1/r^2, as sums
 * over samples.
 *
 * A run of LX_LANES elements is treated at once.  The sources are cut into cells.  A cell that is large against the
 * lobe is halved both ways unseen, one that cannot matter by a bound of its light is dropped; each other is integrated
 * by a product rule of Gauss and again by its four quarters, and the cell with the largest difference between the two
 * is replaced by its quarters until the sum of the differences, which the errors stay below, is small enough for every
 * element of the run.  A disk, or a ball, begins as a whole, by samples on circles and again on twice as many; where
 * that is not enough it is cut into four sectors.
 */
#ifndef LX_PICTURE_SAMPLING_H
#define LX_PICTURE_SAMPLING_H

#include "sight.h"

enum { LX_MOST_CELLS = 1024 };

struct lx_sampler {
    const struct lx_kernels *kernels;
    const struct lx_sampled *sources;
    size_t source_count;
    const struct lx_lobe_double *lobe; /* what is summed: a lobe without its diffuse part, or that alone */
    const struct lx_lobe_single *lobe_single;
    double tolerance, least_maximum; /* errors may reach tolerance times the greatest value of the picture, which is
                                        no less than least_maximum, nor than what is in the run itself; */
    double least;                    /* or this, which no picture could show */
    size_t most_cells;               /* how many may be looked at again, up to LX_MOST_CELLS */
    const struct lx_asking *asking;  /* whether to go on */
};

/* Scratch memory of one thread, for sources of so many patches together: its size, and making it of bytes that are
 * aligned as lx_new_aligned() does. */
struct lx_sampling_memory;
size_t lx_sampling_memory_size(size_t most_patches);
struct lx_sampling_memory *lx_sampling_memory_of(void *bytes, size_t most_patches);

/*
 * Adds the light to sum[0 ... LX_LANES - 1] of the elements from `start` on, of which the last may be repetitions.
 * Returns whether the tolerance was reached, or the work is to stop; it is not where places are rounded by too much.
 */
bool lx_sample_run(const struct lx_sampler *sampling, struct lx_sampling_memory *memory,
                   const struct lx_block_double *block, const struct lx_block_single *copy, size_t start, double *sum);

/* A ball around the places of the run that begins there. */
struct lx_around lx_run_around(const struct lx_block_double *block, size_t start);

#endif
