/* SPDX-License-Identifier: MIT */
/*
 * Portable float map: three lines of text and float32 numbers.  Its rows run from the bottom of the picture to
 * the top, so the image's last row comes first; a reader that knows that shows row 0 on top.  The negative
 * scale says little-endian.  Format: http://www.pauldebevec.com/Research/HDR/PFM/
 */
#include <stdio.h>

#include "format.h"

static void write_pfm(const struct lx_image *image, struct lx_sink *sink) {
    char header[48];
    int length = snprintf(header, sizeof header, "Pf\n%u %u\n-1.0\n", image->columns, image->rows);
    luxel_status status = lx_sink_write(sink, header, (size_t)length);

    for (unsigned row = image->rows; row > 0 && status == LUXEL_OK; row--) {
        status = lx_write_row(image, row - 1, sizeof(float), sink);
    }
}

const struct lx_format lx_format_pfm = {".pfm", "PFM", LX_SAMPLE_F32 | LX_SAMPLE_F64, write_pfm};
