/* SPDX-License-Identifier: MIT */
/*
 * EXR pictures through OpenEXR's C library: scan lines of one float32 channel "Y" and the tags as attributes of type
 * string.  The same image gives the same bytes.  Lines are not compressed: zlib would take off an eighth to a half,
 * and eight times as long (at 3200 x 3200 pixels 0.8 s instead of 0.1 s).  So the table of where the lines begin can be
 * foreseen; it stands before them, although the library writes it last, and a sink cannot go back.
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <OpenEXR/openexr.h>

#include "../base/memory.h"
#include "../base/reason.h"
#include "exr_header.h"
#include "exr_read.h"
#include "format.h"

enum { LEADER = 8, ENTRY = 8 }; /* bytes: before each line, and for each in the table */

struct writer {
    const struct lx_image *image;
    struct lx_sink *sink;
    exr_context_t context;
    int part;
    float *line;       /* where the image's samples are no float32 */
    uint64_t position; /* bytes that the sink has */
    uint64_t table;    /* where the table begins; 0: not known yet */
};

/* Where a line begins, as the table says it. */
static void table_entry(const struct writer *writer, unsigned row, unsigned char entry[ENTRY])
{
    uint64_t lines = writer->table + (uint64_t)ENTRY * writer->image->rows;
    uint64_t start = lines + (uint64_t)row * (LEADER + sizeof(float) * (uint64_t)writer->image->columns);
    for (size_t byte = 0; byte < ENTRY; byte++)
        entry[byte] = (unsigned char)(start >> (8 * byte));
}

static void put_table(struct writer *writer)
{
    unsigned char entry[ENTRY];
    writer->table = writer->position;
    for (unsigned row = 0; row < writer->image->rows; row++) {
        table_entry(writer, row, entry);
        lx_sink_write(writer->sink, entry, ENTRY);
    }
    writer->position += (uint64_t)ENTRY * writer->image->rows;
}

static bool is_table(const struct writer *writer, const unsigned char *bytes)
{
    unsigned char entry[ENTRY];
    for (unsigned row = 0; row < writer->image->rows; row++) {
        table_entry(writer, row, entry);
        if (memcmp(bytes + (size_t)row * ENTRY, entry, ENTRY) != 0)
            return false;
    }
    return true;
}

static int64_t put_bytes(exr_const_context_t context, void *data, const void *bytes, uint64_t count, uint64_t offset,
                         exr_stream_error_func_ptr_t tell)
{
    struct writer *writer = data;
    uint64_t table_size = (uint64_t)ENTRY * writer->image->rows;
    if (writer->table && offset == writer->table && count == table_size && is_table(writer, bytes))
        return (int64_t)count;
    if (!writer->table && offset == writer->position + table_size)
        put_table(writer);
    if (offset != writer->position)
        return tell(context, EXR_ERR_WRITE_IO, "a file of another layout than was foreseen"), -1;
    writer->position += count;
    return lx_sink_write(writer->sink, bytes, (size_t)count) == LUXEL_OK ? (int64_t)count : -1;
}

static void report(exr_const_context_t context, exr_result_t code, const char *text)
{
    void *data = NULL;
    (void)code;
    if (exr_get_user_data(context, &data) == EXR_ERR_SUCCESS && data)
        lx_sink_fail(((struct writer *)data)->sink, LX_MSG_EXR_FAILED, text);
}

static exr_result_t write_header(struct writer *writer)
{
    const struct lx_image *image = writer->image;
    exr_context_t context = writer->context;
    exr_result_t result = exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &writer->part);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, writer->part, (int32_t)image->columns,
                                                     (int32_t)image->rows, EXR_COMPRESSION_NONE);
    if (result == EXR_ERR_SUCCESS)
        result = exr_add_channel(context, writer->part, "Y", EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    for (size_t i = 0; i < image->tag_count && result == EXR_ERR_SUCCESS; i++)
        result = exr_attr_set_string(context, writer->part, image->tags[i].key, image->tags[i].value);
    return result == EXR_ERR_SUCCESS ? exr_write_header(context) : result;
}

/* A line as float32. */
static const float *line_from(struct writer *writer, unsigned row)
{
    size_t first = (size_t)row * writer->image->columns;
    if (writer->image->sample == LX_SAMPLE_F32)
        return (const float *)writer->image->data + first;
    for (unsigned i = 0; i < writer->image->columns; i++)
        writer->line[i] = (float)((const double *)writer->image->data)[first + i];
    return writer->line;
}

static exr_result_t write_line(struct writer *writer, unsigned row, exr_encode_pipeline_t *pipeline)
{
    exr_chunk_info_t chunk;
    exr_context_t context = writer->context;
    exr_result_t result = exr_write_scanline_chunk_info(context, writer->part, (int)row, &chunk);
    if (result == EXR_ERR_SUCCESS)
        result = row == 0 ? exr_encoding_initialize(context, writer->part, &chunk, pipeline)
                          : exr_encoding_update(context, writer->part, &chunk, pipeline);
    if (result != EXR_ERR_SUCCESS)
        return result;
    exr_coding_channel_info_t *channel = &pipeline->channels[0];
    channel->encode_from_ptr = (const uint8_t *)line_from(writer, row);
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
    channel->user_pixel_stride = sizeof(float);
    channel->user_line_stride = (int32_t)(writer->image->columns * sizeof(float));
    if (row == 0)
        result = exr_encoding_choose_default_routines(context, writer->part, pipeline);
    return result == EXR_ERR_SUCCESS ? exr_encoding_run(context, writer->part, pipeline) : result;
}

static exr_result_t write_file(struct writer *writer)
{
    exr_context_initializer_t about = {.size = sizeof about,
                                       .error_handler_fn = report,
                                       .user_data = writer,
                                       .write_fn = put_bytes,
                                       .zip_level = -2,
                                       .dwa_quality = -1};
    exr_encode_pipeline_t pipeline = {0};
    exr_result_t result = exr_start_write(&writer->context, "picture", EXR_WRITE_FILE_DIRECTLY, &about);
    if (result != EXR_ERR_SUCCESS)
        return result;
    result = write_header(writer);
    for (unsigned row = 0; row < writer->image->rows && result == EXR_ERR_SUCCESS; row++)
        result = write_line(writer, row, &pipeline);
    exr_encoding_destroy(writer->context, &pipeline);
    exr_result_t end = exr_finish(&writer->context); /* writes the table */
    return result == EXR_ERR_SUCCESS ? end : result;
}

static void write_exr(const struct lx_image *image, struct lx_sink *sink)
{
    struct writer writer = {.image = image, .sink = sink};
    if (image->sample == LX_SAMPLE_F64)
        writer.line = lx_new_array(image->columns, sizeof *writer.line);
    if (image->sample == LX_SAMPLE_F64 && !writer.line) {
        lx_sink_fail(sink, LX_MSG_FILE_NOT_WRITTEN, lx_reason(ENOMEM));
    } else {
        exr_result_t result = write_file(&writer);
        if (result != EXR_ERR_SUCCESS)
            lx_sink_fail(sink, LX_MSG_EXR_FAILED, exr_get_default_error_message(result));
    }
    free(writer.line);
}

static luxel_status read_tags(struct lx_source *source, struct lx_tags *tags)
{
    struct lx_exr_header header;
    return lx_exr_read_header(source, &header, tags);
}

const struct lx_format lx_format_exr = {
    .ending = ".exr",
    .name = LX_EXR_NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .magic = LX_EXR_MAGIC,
    .magic_length = LX_EXR_MAGIC_LENGTH,
    .write = write_exr,
    .read = lx_exr_read,
    .read_tags = read_tags,
};
