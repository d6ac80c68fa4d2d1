/* SPDX-License-Identifier: MIT */
/*
 * NumPy's array file, version 1.0: a magic number, a Python dictionary that describes the array, and its bytes.
 * The shape is (rows, columns) in C order, so that numpy.load() gives row 0 first.  Little-endian on every host.
 * Format: numpy.lib.format.
 */
#include <stdio.h>
#include <string.h>

#include "format.h"

enum { LX_NPY_ALIGNMENT = 64, LX_NPY_PREFIX = 10, LX_NPY_HEADER = 128 };

static void write_npy(const struct lx_image *image, struct lx_sink *sink) {
    size_t width = image->sample == LX_SAMPLE_F64 ? sizeof(double) : sizeof(float);
    char header[LX_NPY_HEADER + 1];
    int written =
        snprintf(header + LX_NPY_PREFIX, sizeof header - LX_NPY_PREFIX,
                 "{'descr': '<f%zu', 'fortran_order': False, 'shape': (%u, %u), }", width, image->rows, image->columns);
    size_t used = LX_NPY_PREFIX + (size_t)written;
    size_t length = (used + 1 + LX_NPY_ALIGNMENT - 1) / LX_NPY_ALIGNMENT * LX_NPY_ALIGNMENT; /* 1: the line's end */

    memcpy(header, "\x93NUMPY\x01\x00", 8);
    header[8] = (char)(length - LX_NPY_PREFIX); /* of two bytes, little-endian; never above 255 here */
    header[9] = 0;
    memset(header + used, ' ', length - used);
    header[length - 1] = '\n';

    luxel_status status = lx_sink_write(sink, header, length);
    for (unsigned row = 0; row < image->rows && status == LUXEL_OK; row++) {
        status = lx_write_row(image, row, width, sink);
    }
}

const struct lx_format lx_format_npy = {".npy", "NPY", LX_SAMPLE_F32 | LX_SAMPLE_F64, write_npy};
