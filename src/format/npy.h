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
    char kind;                  /* 'f': real, 'i': whole, 'u': whole from 0 on, 'b': true or false */
    size_t width;               /* of a number, in bytes; 0: they are of another kind */
    enum lx_sample_type sample; /* what holds them: float32 where it does so exactly, else float64 */
    size_t start;               /* where they begin */
};

/* Reads it.  What is not as it should be, a word of the format; NULL: nothing, or the source has failed. */
const char *lx_npy_read_header(struct lx_source *source, struct lx_npy *npy);

/* Reads all its numbers, row by row, into values of its kind of samples that there is room for. */
luxel_status lx_npy_read_numbers(struct lx_source *source, const struct lx_npy *npy, struct lx_loaded *loaded);

#endif
