/* SPDX-License-Identifier: MIT */
/*
 * EXR pictures through OpenEXR's C library: scan lines of one float32 channel "Y", or of R, G and B, and the tags as
 * attributes of type string.  The same image gives the same bytes.  Lines are not compressed: zlib would take off an
 * eighth to a half, and eight times as long (at 3200 x 3200 pixels 0.8 s instead of 0.1 s).  So the table of where the
 * lines begin can be foreseen; it stands before them, although the library writes it last, and a sink cannot go back.
 */
#include <stdlib.h>
#include <string.h>

#include <OpenEXR/openexr.h>

#include "../base/memory.h"
#include "exr_header.h"
#include "exr_read.h"
#include "format.h"

enum { LEADER = 8, ENTRY = 8 }; /* bytes: before each line, and for each in the table */

struct own {
    const struct lx_image *image;
    struct lx_sink *sink; /* NULL: the file is given up, and what OpenEXR says to that goes nowhere */
    exr_context_t context;
    int part;
    exr_encode_pipeline_t pipeline;
    float *line;       /* where the image's samples are no float32 */
    uint64_t position; /* bytes that the sink has */
    uint64_t table;    /* where the table begins; 0: not known yet */
};

/* Where a line begins, as the table says it. */
static void table_entry(const struct own *own, unsigned row, unsigned char entry[ENTRY])
{
    uint64_t lines = own->table + (uint64_t)ENTRY * own->image->rows;
    uint64_t start = lines + (uint64_t)row * (LEADER + sizeof(float) * (uint64_t)lx_row_samples(own->image));
    for (size_t byte = 0; byte < ENTRY; byte++)
        entry[byte] = (unsigned char)(start >> (8 * byte));
}

static void put_table(struct own *own)
{
    unsigned char entry[ENTRY];
    own->table = own->position;
    for (unsigned row = 0; row < own->image->rows; row++) {
        table_entry(own, row, entry);
        lx_sink_write(own->sink, entry, ENTRY);
    }
    own->position += (uint64_t)ENTRY * own->image->rows;
}

static bool is_table(const struct own *own, const unsigned char *bytes)
{
    unsigned char entry[ENTRY];
    for (unsigned row = 0; row < own->image->rows; row++) {
        table_entry(own, row, entry);
        if (memcmp(bytes + (size_t)row * ENTRY, entry, ENTRY) != 0)
            return false;
    }
    return true;
}

static int64_t put_bytes(exr_const_context_t context, void *data, const void *bytes, uint64_t count, uint64_t offset,
                         exr_stream_error_func_ptr_t tell)
{
    struct own *own = data;
    if (!own->sink)
        return (int64_t)count;
    uint64_t table_size = (uint64_t)ENTRY * own->image->rows;
    if (own->table && offset == own->table && count == table_size && is_table(own, bytes))
        return (int64_t)count;
    if (!own->table && offset == own->position + table_size)
        put_table(own);
    if (offset != own->position)
        return tell(context, EXR_ERR_WRITE_IO, "a file of another layout than was foreseen"), -1;
    own->position += count;
    return lx_sink_write(own->sink, bytes, (size_t)count) == LUXEL_OK ? (int64_t)count : -1;
}

static void report(exr_const_context_t context, exr_result_t code, const char *text)
{
    void *data = NULL;
    (void)code;
    if (exr_get_user_data(context, &data) == EXR_ERR_SUCCESS && data && ((struct own *)data)->sink)
        lx_sink_fail(((struct own *)data)->sink, LX_MSG_EXR_FAILED, text);
}

static const char *const COLORS[] = {"R", "G", "B"};
static const exr_attr_chromaticities_t SRGB = {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F};

static exr_result_t write_header(struct own *own)
{
    const struct lx_image *image = own->image;
    exr_context_t context = own->context;
    exr_result_t result = exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &own->part);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, own->part, (int32_t)image->columns, (int32_t)image->rows,
                                                     EXR_COMPRESSION_NONE);
    for (unsigned c = 0; c < image->channels && result == EXR_ERR_SUCCESS; c++)
        result = exr_add_channel(context, own->part, image->channels == 3 ? COLORS[c] : "Y", EXR_PIXEL_FLOAT,
                                 EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    if (result == EXR_ERR_SUCCESS && image->channels == 3)
        result = exr_attr_set_chromaticities(context, own->part, "chromaticities", &SRGB);
    for (size_t i = 0; i < image->tag_count && result == EXR_ERR_SUCCESS; i++)
        result = exr_attr_set_string(context, own->part, image->tags[i].key, image->tags[i].value);
    return result == EXR_ERR_SUCCESS ? exr_write_header(context) : result;
}

/* The i-th line of a strip as float32. */
static const float *line_from(const struct own *own, const struct lx_image_strip *strip, unsigned i)
{
    const size_t samples = lx_row_samples(own->image), first = i * samples;
    if (own->image->sample == LX_SAMPLE_F32)
        return (const float *)strip->data + first;
    for (size_t k = 0; k < samples; k++)
        own->line[k] = (float)((const double *)strip->data)[first + k];
    return own->line;
}

static exr_result_t write_line(struct own *own, unsigned row, const float *line)
{
    exr_chunk_info_t chunk;
    exr_context_t context = own->context;
    exr_encode_pipeline_t *pipeline = &own->pipeline;
    exr_result_t result = exr_write_scanline_chunk_info(context, own->part, (int)row, &chunk);
    if (result == EXR_ERR_SUCCESS)
        result = row == 0 ? exr_encoding_initialize(context, own->part, &chunk, pipeline)
                          : exr_encoding_update(context, own->part, &chunk, pipeline);
    if (result != EXR_ERR_SUCCESS)
        return result;
    /* a file's channels stand in the order of their names, B before G before R */
    const unsigned channels = own->image->channels;
    for (unsigned c = 0; c < channels; c++) {
        exr_coding_channel_info_t *channel = &pipeline->channels[c];
        channel->encode_from_ptr = (const uint8_t *)(line + (channels - 1 - c));
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_pixel_stride = (int32_t)(channels * sizeof(float));
        channel->user_line_stride = (int32_t)(lx_row_samples(own->image) * sizeof(float));
    }
    if (row == 0)
        result = exr_encoding_choose_default_routines(context, own->part, pipeline);
    return result == EXR_ERR_SUCCESS ? exr_encoding_run(context, own->part, pipeline) : result;
}

static void check(const struct own *own, exr_result_t result)
{
    if (result != EXR_ERR_SUCCESS)
        lx_sink_fail(own->sink, LX_MSG_EXR_FAILED, exr_get_default_error_message(result));
}

static void begin_exr(struct lx_writer *writer)
{
    struct own *own = writer->own = lx_new_array(1, sizeof *own);
    if (own && writer->image.sample == LX_SAMPLE_F64)
        own->line = lx_new_array(lx_row_samples(&writer->image), sizeof *own->line);
    if (!own || (writer->image.sample == LX_SAMPLE_F64 && !own->line)) {
        lx_sink_out_of_memory(writer->sink);
        return;
    }
    own->image = &writer->image;
    own->sink = writer->sink;
    exr_context_initializer_t about = {.size = sizeof about,
                                       .error_handler_fn = report,
                                       .user_data = own,
                                       .write_fn = put_bytes,
                                       .zip_level = -2,
                                       .dwa_quality = -1};
    exr_result_t result = exr_start_write(&own->context, "picture", EXR_WRITE_FILE_DIRECTLY, &about);
    check(own, result == EXR_ERR_SUCCESS ? write_header(own) : result);
    lx_reserve_numbers(writer, sizeof(float));
}

static void add_exr(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    struct own *own = writer->own;
    exr_result_t result = EXR_ERR_SUCCESS;
    for (unsigned i = 0; i < strip->rows && result == EXR_ERR_SUCCESS; i++)
        result = write_line(own, strip->first + i, line_from(own, strip, i));
    check(own, result);
}

static void end_exr(struct lx_writer *writer, bool whole)
{
    struct own *own = writer->own;
    if (own && !whole)
        own->sink = NULL;
    if (own && own->context) {
        exr_encoding_destroy(own->context, &own->pipeline);
        exr_result_t result = exr_finish(&own->context); /* writes the table */
        if (whole)
            check(own, result);
    }
    if (own)
        free(own->line);
    free(own);
}

const struct lx_format lx_format_exr = {
    .ending = ".exr",
    .name = LX_EXR_NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .magic = LX_EXR_MAGIC,
    .magic_length = LX_EXR_MAGIC_LENGTH,
    .begin = begin_exr,
    .add = add_exr,
    .end = end_exr,
    .read = lx_exr_read,
    .read_tags = lx_exr_read_tags,
};
