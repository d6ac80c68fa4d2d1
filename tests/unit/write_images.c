/* SPDX-License-Identifier: MIT */
/* Writes one asymmetric image in every format into a folder, for test_formats.py to read: value = row + column / 8. */
#include <stdint.h>
#include <stdio.h>

#include "format/format.h"

enum { COLUMNS = 7, ROWS = 4 };

static int write_as(const char *folder, const char *name, enum lx_sample_type sample, const void *data)
{
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = sample, .data = data};
    char path[4096];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    return lx_write_image(path, &image, NULL) != LUXEL_OK;
}

int main(int count, char **arguments)
{
    double doubles[ROWS * COLUMNS];
    float singles[ROWS * COLUMNS];
    uint8_t greys[ROWS * COLUMNS];
    uint16_t fine[ROWS * COLUMNS];

    if (count != 2) {
        fputs("usage: write_images FOLDER\n", stderr);
        return 2;
    }
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        doubles[i] = i / COLUMNS + i % COLUMNS / 8.0;
        singles[i] = (float)doubles[i];
        greys[i] = (uint8_t)(doubles[i] * 8);
        fine[i] = (uint16_t)(doubles[i] * 8 * 259);
    }
    return write_as(arguments[1], "grey.png", LX_SAMPLE_U8, greys) |
           write_as(arguments[1], "fine.png", LX_SAMPLE_U16, fine) |
           write_as(arguments[1], "single.npy", LX_SAMPLE_F32, singles) |
           write_as(arguments[1], "double.npy", LX_SAMPLE_F64, doubles) |
           write_as(arguments[1], "single.pfm", LX_SAMPLE_F32, singles);
}
