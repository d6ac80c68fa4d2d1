/* SPDX-License-Identifier: MIT */
/* The beginning of an NPY file, for everybody who reads arrays. */
#ifndef LX_FORMAT_NPY_H
#define LX_FORMAT_NPY_H

#include "format.h"

struct lx_npy {
    char descr[16], shape[32]; /* as they stand there, cut where they are too long */
    unsigned rows, columns;    /* both 0: the array has not two dimensions; cut where no array is that large */
    bool fortran;              /* column by column */
    bool big_endian;
    size_t width; /* of a number, in bytes: 4 or 8; 0: they are no floating-point numbers of such a width */
    size_t start; /* where they begin */
};

/* Reads it.  What is not as it should be, a word of the format; NULL: nothing, or the source has failed. */
const char *lx_npy_read_header(struct lx_source *source, struct lx_npy *npy);

/* Reads all its numbers, row by row, into values of the same width that there is room for. */
luxel_status lx_npy_read_numbers(struct lx_source *source, const struct lx_npy *npy, struct lx_loaded *loaded);

#endif
