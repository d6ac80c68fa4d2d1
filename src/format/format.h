/* SPDX-License-Identifier: MIT */
/*
 * File formats for arrays of numbers, in one table by the ending of the file's name.  A format takes a plain
 * image and writes it to a sink; it knows nothing of scenes and fields.  To add one: a file like pfm.c, and a
 * line in the table of format.c.
 */
#ifndef LX_FORMAT_FORMAT_H
#define LX_FORMAT_FORMAT_H

#include "../base/sink.h"

/* What the samples of an image are; one bit each, so that a format can name several. */
enum lx_sample { LX_SAMPLE_U8 = 1, LX_SAMPLE_F32 = 2, LX_SAMPLE_F64 = 4 };

/* An image: rows x columns x channels samples, row 0 on top, without gaps.  The data are the caller's. */
struct lx_image {
    unsigned columns, rows;
    unsigned channels; /* 1: no format takes more yet */
    enum lx_sample sample;
    const void *data; /* uint8_t, float or double in the host's byte order */
};

struct lx_format {
    const char *ending; /* lower case, with its dot: ".png" */
    const char *name;   /* as people call it: "PNG" */
    unsigned samples;   /* the kinds of samples that it takes: bits of enum lx_sample */
    /* Writes an image that it takes, row by row.  A failure is the sink's to keep. */
    void (*write)(const struct lx_image *image, struct lx_sink *sink);
};

extern const struct lx_format lx_format_png, lx_format_npy, lx_format_pfm;

/*
 * The format for the ending of a file's name, in whatever case: "a/b.PNG".  Where there is none, says so with
 * the endings that are known.  LUXEL_ERROR_ARGUMENT.
 */
luxel_status lx_find_format(const char *path, luxel_diagnostics *diagnostics, const struct lx_format **format);

/*
 * Writes an image to a file, whole or not at all, in the format of its ending.
 * LUXEL_ERROR_ARGUMENT: no such format, or one that takes no image of this kind.  LUXEL_ERROR_FILE.
 */
luxel_status lx_write_image(const char *path, const struct lx_image *image, luxel_diagnostics *diagnostics);

/*
 * For the formats: writes one row of floating-point samples as little-endian numbers of `width` bytes (4 or 8),
 * rounding where the image has more.
 */
luxel_status lx_write_row(const struct lx_image *image, unsigned row, size_t width, struct lx_sink *sink);

#endif
