/* SPDX-License-Identifier: MIT */
/* The grey levels of PNG pictures, which say what light was there only to those who know how they were made. */
#ifndef LX_FORMAT_PNG_LEVELS_H
#define LX_FORMAT_PNG_LEVELS_H

#include <luxel/diagnostics.h>

struct lx_levels {
    unsigned columns, rows;
    unsigned greatest; /* 255 or 65535 */
    double *list;      /* rows x columns, from the top; free with free() */
};

/* LUXEL_ERROR_FILE: it cannot be read, or is no PNG picture of 8 or 16 bits of grey. */
luxel_status lx_png_read_levels(const char *path, luxel_diagnostics *diagnostics, struct lx_levels *levels);

#endif
