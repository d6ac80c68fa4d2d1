/* SPDX-License-Identifier: MIT */
/*
 * Clouds of points: files of rows x, y, z, intensity, told by their content.
 *
 * CSV   a row on each line, between its numbers commas, semicolons, or blanks and tabs: the same throughout, as the
 *       first line has it.  That line may name the columns instead: x, y, z, intensity, in any case.
 * NPY   an array of the shape (N, 4) of float32 or float64, in either order of bytes and of axes.
 *
 * In CSV # begins a comment, and numbers have a decimal point.
 */
#ifndef LX_FORMAT_CLOUD_H
#define LX_FORMAT_CLOUD_H

#include "../base/diagnostics.h"
#include "../base/source.h"
#include "kept.h"

enum { LX_LARGEST_CLOUD = 1 << 30, LX_MOST_POINTS = 10000000, LX_CLOUD_COLUMNS = 4 };

/* At least one row; all numbers are finite, no intensity is below 0. */
struct lx_cloud {
    struct lx_kept kept;
    size_t count;
    bool is_single;            /* the values are float, as an array of these has them; else double */
    void *values;              /* row by row */
    struct lx_kept_slot *tree; /* what was planted of it (shade/tree.h); NULL: it is not kept */
};

static inline void lx_cloud_row(const struct lx_cloud *cloud, size_t i, double row[LX_CLOUD_COLUMNS])
{
    if (cloud->is_single) {
        const float *values = (const float *)cloud->values + LX_CLOUD_COLUMNS * i;
        for (size_t k = 0; k < LX_CLOUD_COLUMNS; k++)
            row[k] = (double)values[k];
    } else {
        const double *values = (const double *)cloud->values + LX_CLOUD_COLUMNS * i;
        for (size_t k = 0; k < LX_CLOUD_COLUMNS; k++)
            row[k] = values[k];
    }
}

/* A cloud with room for so many rows of double, one user, and no file; NULL: memory ran out. */
struct lx_cloud *lx_cloud_new(size_t count);

/* What is wrong with a file: the message, whose {2} is the number and {3} the text; LX_MSG_COUNT: nothing. */
struct lx_cloud_report {
    enum lx_message message;
    size_t number; /* of the line, or of the row, from 1 on */
    char text[48];
};

/*
 * Reads it; the cloud has one user.  There is none where something is wrong, or where the source has failed, which it
 * keeps.
 */
struct lx_cloud_report lx_cloud_read(struct lx_source *source, struct lx_cloud **cloud);

/* Frees a cloud: what its users come to in the end. */
void lx_cloud_free(struct lx_kept *kept);

#endif
