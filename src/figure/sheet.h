/* SPDX-License-Identifier: MIT */
/* A sheet: something drawn by cairo on paper of a width, and written as PNG, SVG or PDF. */
#ifndef LX_FIGURE_SHEET_H
#define LX_FIGURE_SHEET_H

#include <cairo.h>
#include <stdbool.h>

#include "../base/sink.h"

struct lx_page_sheet {
    const char *title; /* of the PDF */
    double width_mm, dots_per_inch;
    bool dark;
    /* Draws it `width` points wide from (0, 0) on, or with `cairo` NULL only measures; returns the height. */
    double (*draw)(const void *what, cairo_t *cairo, double width);
    const void *what;
};

/* The sheet as a PNG file's bytes, the caller's; LUXEL_ERROR_MEMORY. */
luxel_status lx_sheet_png(const struct lx_page_sheet *sheet, luxel_diagnostics *diagnostics, unsigned char **bytes,
                          size_t *length);

/* Writes it as a file by the extension of its name, whole or not at all. */
luxel_status lx_sheet_write(const struct lx_page_sheet *sheet, const struct lx_destination *destination,
                            luxel_diagnostics *diagnostics);

#endif
