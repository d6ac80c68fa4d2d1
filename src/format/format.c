/* SPDX-License-Identifier: MIT */
/* The table of file formats, and what they have in common: the choice by ending, and rows of numbers as bytes. */
#include "format.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

enum { LX_ROW_PART = 512 }; /* samples turned into bytes at a time */

/* In the order in which messages name them. */
static const struct lx_format *const FORMATS[] = {&lx_format_png, &lx_format_npy, &lx_format_pfm};
enum { FORMAT_COUNT = sizeof FORMATS / sizeof FORMATS[0] };

/* The ending of the last name in a path with its dot, or NULL.  A dot that begins a name begins no ending. */
static const char *ending_of(const char *path) {
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(name, '.');

    return dot != NULL && dot != name && dot[1] != '\0' ? dot : NULL;
}

static void report_unknown(const char *path, const char *ending, luxel_diagnostics *diagnostics) {
    char known[FORMAT_COUNT * 8] = ""; /* each ending and its separator are shorter than 8 */

    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        strcat(strcat(known, i > 0 ? ", " : ""), FORMATS[i]->ending);
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, ending != NULL ? LX_MSG_UNKNOWN_ENDING : LX_MSG_NO_ENDING,
              LX_ARGS(path, ending));
    lx_hint(diagnostics, LX_MSG_KNOWN_ENDINGS, LX_ARGS(known));
}

luxel_status lx_find_format(const char *path, luxel_diagnostics *diagnostics, const struct lx_format **format) {
    const char *ending = ending_of(path);

    for (size_t i = 0; ending != NULL && i < FORMAT_COUNT; i++) {
        if (strcasecmp(ending, FORMATS[i]->ending) == 0) {
            *format = FORMATS[i];
            return LUXEL_OK;
        }
    }
    report_unknown(path, ending, diagnostics);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status lx_write_image(const char *path, const struct lx_image *image, luxel_diagnostics *diagnostics) {
    const struct lx_format *format;
    struct lx_sink *sink;
    luxel_status status = lx_find_format(path, diagnostics, &format);

    if (status != LUXEL_OK) {
        return status;
    }
    if ((format->samples & (unsigned)image->sample) == 0 || image->channels != 1 || image->columns == 0 ||
        image->rows == 0) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_UNFIT_IMAGE, LX_ARGS(path, format->name));
        return LUXEL_ERROR_ARGUMENT;
    }
    status = lx_sink_open(path, NULL, diagnostics, &sink);
    if (status != LUXEL_OK) {
        return status;
    }
    format->write(image, sink);
    return lx_sink_commit(sink);
}

/* The bits of a sample as a number of `width` bytes. */
static uint64_t sample_bits(const struct lx_image *image, size_t i, size_t width) {
    bool is_double = image->sample == LX_SAMPLE_F64;
    uint64_t bits64;
    uint32_t bits32;

    if (width == sizeof(double)) {
        double value = is_double ? ((const double *)image->data)[i] : (double)((const float *)image->data)[i];
        memcpy(&bits64, &value, sizeof bits64);
        return bits64;
    }
    float value = is_double ? (float)((const double *)image->data)[i] : ((const float *)image->data)[i];
    memcpy(&bits32, &value, sizeof bits32);
    return bits32;
}

luxel_status lx_write_row(const struct lx_image *image, unsigned row, size_t width, struct lx_sink *sink) {
    unsigned char bytes[LX_ROW_PART * sizeof(double)];
    size_t start = (size_t)row * image->columns, end = start + image->columns;
    luxel_status status = LUXEL_OK;

    while (start < end && status == LUXEL_OK) {
        size_t used = 0;

        for (size_t part = 0; part < LX_ROW_PART && start < end; part++, start++) {
            uint64_t bits = sample_bits(image, start, width);
            for (size_t byte = 0; byte < width; byte++) {
                bytes[used++] = (unsigned char)(bits >> (8 * byte));
            }
        }
        status = lx_sink_write(sink, bytes, used);
    }
    return status;
}
