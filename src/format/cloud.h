/* SPDX-License-Identifier: MIT */
/*
 * Clouds of points: files of rows x, y, z, intensity, told by their content.
 *
 * CSV   a table (text_table.h) with the columns x, y, z and intensity, or an .lp file, which tells no intensities.
 * NPY   an array of the shape (N, 4) or, without intensities, (N, 3), in either order of bytes and of axes.
 */
#ifndef LX_FORMAT_CLOUD_H
#define LX_FORMAT_CLOUD_H

#include "../base/diagnostics.h"
#include "../base/source.h"
#include "kept.h"
#include "text_table.h"

enum { LX_LARGEST_CLOUD = 1 << 30, LX_MOST_POINTS = 10000000, LX_CLOUD_COLUMNS = 4 };

/* Whether the file tells the intensities; where it does not they are all 1. */
enum lx_cloud_intensities { LX_CLOUD_TOLD, LX_CLOUD_NOT_TOLD, LX_CLOUD_LP };

/* At least one row; all numbers are finite, no intensity is below 0. */
struct lx_cloud {
    struct lx_kept kept;
    size_t count;
    bool is_single; /* the values are float, as an array of these has them; else double */
    void *values;   /* row by row */
    enum lx_cloud_intensities intensities;
    char unused[LX_UNUSED_SIZE]; /* the names of columns that were passed over; "": there were none */
    struct lx_kept_slot *tree;   /* what was planted of it (picture/cluster/tree.h); NULL: it is not kept */
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

/* A cloud with the same places and one intensity; NULL: memory ran out. */
struct lx_cloud *lx_cloud_with_intensity(const struct lx_cloud *cloud, double intensity);

/*
 * What is wrong with a file: the message, whose {2} is the number and {3} the text; LX_MSG_COUNT: nothing.  Of
 * CLOUD_TABLE, CLOUD_LINE and CLOUD_PLACE the fault is {3}, and its column {4}.
 */
struct lx_cloud_report {
    enum lx_message message;
    size_t number; /* of the line, or of the row, from 1 on */
    char text[48];
    struct lx_text_table_fault fault;
};

/*
 * Reads it; the cloud has one user.  There is none where something is wrong, or where the source has failed, which it
 * keeps.
 */
struct lx_cloud_report lx_cloud_read(struct lx_source *source, struct lx_cloud **cloud);

/* Frees a cloud: what its users come to in the end. */
void lx_cloud_free(struct lx_kept *kept);

#endif
