/* SPDX-License-Identifier: MIT */
/* What the formats share: numbers as bytes in either order, room for an image within the limits, and refusals. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "format.h"

enum {
    PART = 2048,               /* samples turned into bytes at a time */
    WORTH_RESERVING = 64 << 20 /* bytes: less is written before anybody waits */
};

/* The bits of a sample as a number of `width` bytes. */
static uint64_t sample_bits(const void *samples, bool is_double, size_t i, size_t width)
{
    uint64_t bits64;
    uint32_t bits32;
    if (width == sizeof(double)) {
        double value = is_double ? ((const double *)samples)[i] : (double)((const float *)samples)[i];
        memcpy(&bits64, &value, sizeof bits64);
        return bits64;
    }
    float value = is_double ? (float)((const double *)samples)[i] : ((const float *)samples)[i];
    memcpy(&bits32, &value, sizeof bits32);
    return bits32;
}

luxel_status lx_write_numbers(struct lx_writer *writer, const struct lx_image_strip *strip, size_t i, size_t count,
                              size_t width)
{
    unsigned char bytes[PART * sizeof(double)];
    bool is_double = writer->image.sample == LX_SAMPLE_F64;
    size_t own_width = is_double ? sizeof(double) : sizeof(float), end = i + count;
    if (width == own_width && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
        return lx_sink_write(writer->sink, (const unsigned char *)strip->data + i * width, count * width);
    luxel_status status = LUXEL_OK;
    while (i < end && status == LUXEL_OK) {
        size_t used = 0;
        for (size_t part = 0; part < PART && i < end; part++, i++) {
            uint64_t bits = sample_bits(strip->data, is_double, i, width);
            for (size_t byte = 0; byte < width; byte++)
                bytes[used++] = (unsigned char)(bits >> (8 * byte));
        }
        status = lx_sink_write(writer->sink, bytes, used);
    }
    return status;
}

void lx_reserve_numbers(struct lx_writer *writer, size_t width)
{
    uint64_t bytes = (uint64_t)lx_row_samples(&writer->image) * writer->image.rows * width;
    if (bytes >= WORTH_RESERVING)
        lx_sink_reserve(writer->sink, bytes);
}

static size_t width_of(const struct lx_loaded *loaded)
{
    return loaded->sample == LX_SAMPLE_F64 ? sizeof(double) : sizeof(float);
}

static void store_bits(struct lx_loaded *loaded, size_t i, uint64_t bits)
{
    uint32_t bits32 = (uint32_t)bits;
    if (loaded->sample == LX_SAMPLE_F64)
        memcpy((double *)loaded->values + i, &bits, sizeof bits);
    else
        memcpy((float *)loaded->values + i, &bits32, sizeof bits32);
}

luxel_status lx_read_numbers(struct lx_source *source, uint64_t offset, bool big_endian, struct lx_loaded *loaded,
                             size_t first, size_t stride, size_t count)
{
    unsigned char bytes[PART * sizeof(double)];
    size_t width = width_of(loaded);
    for (size_t done = 0; done < count;) {
        size_t part = count - done < PART ? count - done : PART;
        if (lx_source_read(source, offset + done * width, bytes, part * width) != LUXEL_OK)
            break;
        for (size_t i = 0; i < part; i++, done++) {
            uint64_t bits = 0;
            for (size_t byte = 0; byte < width; byte++)
                bits = bits << 8 | bytes[i * width + (big_endian ? byte : width - 1 - byte)];
            store_bits(loaded, first + done * stride, bits);
        }
    }
    return lx_source_status(source);
}

luxel_status lx_loaded_allocate(struct lx_source *source, struct lx_loaded *loaded)
{
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
    char needs[LX_AMOUNT_SIZE], has[LX_AMOUNT_SIZE];
    lx_write_number(loaded->columns, columns);
    lx_write_number(loaded->rows, rows);
    if (loaded->columns > LX_MOST_PIXELS || loaded->rows > LX_MOST_PIXELS)
        return lx_source_refuse(source, LX_MSG_TOO_MANY_PIXELS,
                                LX_ARGS(columns, rows, lx_write_number(LX_MOST_PIXELS, most)));
    size_t pixels = (size_t)loaded->columns * loaded->rows;
    double needed = (double)pixels * (double)(width_of(loaded) + 1), available = lx_available_bytes();
    if (needed <= available)
        loaded->values = lx_new_aligned(pixels, width_of(loaded));
    if (!loaded->values)
        return lx_source_fail(source, LUXEL_ERROR_MEMORY, LX_MSG_PICTURE_TOO_LARGE,
                              LX_ARGS(columns, rows, lx_write_amount(needed, needs),
                                      lx_write_amount(needed <= available ? 0 : available, has)));
    memset(loaded->values, 0, pixels * width_of(loaded));
    return LUXEL_OK;
}

luxel_status lx_check_size(struct lx_source *source, const char *name, const struct lx_loaded *loaded, size_t width,
                           size_t header)
{
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], wanted[LX_NUMBER_SIZE], found[LX_NUMBER_SIZE];
    double bytes = (double)loaded->columns * (double)loaded->rows * (double)width + (double)header;
    double size = (double)lx_source_size(source); /* both are exact below 2^53 */
    if (size == bytes)
        return LUXEL_OK;
    return lx_source_refuse(source, LX_MSG_BAD_FILE_SIZE,
                            LX_ARGS(name, lx_write_number(loaded->columns, columns),
                                    lx_write_number(loaded->rows, rows), lx_write_number(bytes, wanted),
                                    lx_write_number(size, found)));
}

luxel_status lx_bad_file(struct lx_source *source, const char *name, const char *part)
{
    return lx_source_refuse(source, LX_MSG_BAD_FILE, LX_ARGS(name, LX_TERM(part)));
}

luxel_status lx_unfit_file(struct lx_source *source, const char *name, const char *part, const char *value,
                           const char *expected)
{
    bool first = lx_source_status(source) == LUXEL_OK;
    luxel_status status = lx_source_refuse(source, LX_MSG_UNFIT_FILE, LX_ARGS(name, part, value));
    if (first && expected)
        lx_hint(lx_source_diagnostics(source), LX_MSG_HINT_EXPECTED, LX_ARGS(LX_TERM(expected)));
    return status;
}
