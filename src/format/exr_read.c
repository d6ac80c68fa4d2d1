/* SPDX-License-Identifier: MIT */
/*
 * Reading the picture of an EXR file through OpenEXR's C library, once its header is known to be one that can be
 * read: the library has had faults in tiles, deep data and odd compressions, which are not let in.
 */
#include "exr_read.h"

#include <stdio.h>
#include <stdlib.h>

#include <OpenEXR/openexr.h>

#include "exr_header.h"

/* As the file numbers them; those that keep every bit. */
static const char *const COMPRESSIONS[] = {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"};
enum {
    LOSSLESS = 5,
    MOST_SHRUNK = 1100 /* times, by any of these */,
    COMPRESSION_COUNT = sizeof COMPRESSIONS / sizeof COMPRESSIONS[0]
};

static luxel_status check_header(struct lx_source *source, const struct lx_exr_header *header)
{
    char number[12];
    if (!header->is_plain)
        return lx_source_refuse(source, LX_MSG_EXR_STORAGE, NULL);
    if (header->channels != 1 || header->is_sampled)
        return lx_unfit_file(source, LX_EXR_NAME, "channels", header->channels ? header->channel_names : "0", "Y");
    if (header->compression < 0 || header->compression >= COMPRESSION_COUNT || !header->has_window ||
        header->has_odd_preview)
        return lx_bad_file(source, LX_EXR_NAME, "header");
    if (header->compression >= LOSSLESS)
        return lx_unfit_file(source, LX_EXR_NAME, "compression", COMPRESSIONS[header->compression],
                             "none, rle, zips, zip, piz");
    for (size_t i = 0; i < 4; i++) /* so that differences of them stay whole numbers */
        if (header->window[i] < -(1 << 30) || header->window[i] > 1 << 30) {
            snprintf(number, sizeof number, "%d", (int)header->window[i]);
            return lx_unfit_file(source, LX_EXR_NAME, "dataWindow", number, NULL);
        }
    if (header->window[2] < header->window[0] || header->window[3] < header->window[1])
        return lx_bad_file(source, LX_EXR_NAME, "dataWindow");
    return LUXEL_OK;
}

static int64_t get_bytes(exr_const_context_t context, void *data, void *bytes, uint64_t count, uint64_t offset,
                         exr_stream_error_func_ptr_t tell)
{
    struct lx_source *source = data;
    uint64_t size = lx_source_size(source);
    (void)context;
    (void)tell;
    /* Like pread(): less at the end.  OpenEXR reads ahead there. */
    if (offset >= size)
        return 0;
    if (count > size - offset)
        count = size - offset;
    return lx_source_read(source, offset, bytes, (size_t)count) == LUXEL_OK ? (int64_t)count : -1;
}

static int64_t get_size(exr_const_context_t context, void *data)
{
    (void)context;
    return (int64_t)lx_source_size(data);
}

/* What the library says is not for users of Luxel; the source gets a report of its own. */
static void be_silent(exr_const_context_t context, exr_result_t code, const char *text)
{
    (void)context;
    (void)code;
    (void)text;
}

static exr_result_t read_chunk(exr_context_t context, int row, int first_row, struct lx_loaded *loaded,
                               exr_decode_pipeline_t *pipeline, int *next)
{
    exr_chunk_info_t chunk;
    bool first = row == first_row;
    exr_result_t result = exr_read_scanline_chunk_info(context, 0, row, &chunk);
    if (result != EXR_ERR_SUCCESS)
        return result;
    size_t at = (size_t)(chunk.start_y - first_row);
    if (chunk.start_y != row || chunk.height < 1 || at + (size_t)chunk.height > loaded->rows ||
        chunk.width != (int)loaded->columns)
        return EXR_ERR_CORRUPT_CHUNK;
    result = first ? exr_decoding_initialize(context, 0, &chunk, pipeline)
                   : exr_decoding_update(context, 0, &chunk, pipeline);
    if (result != EXR_ERR_SUCCESS)
        return result;
    exr_coding_channel_info_t *channel = &pipeline->channels[0];
    channel->decode_to_ptr = (uint8_t *)((float *)loaded->values + at * loaded->columns);
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
    channel->user_pixel_stride = sizeof(float);
    channel->user_line_stride = (int32_t)(loaded->columns * sizeof(float));
    if (first)
        result = exr_decoding_choose_default_routines(context, 0, pipeline);
    *next = row + chunk.height;
    return result == EXR_ERR_SUCCESS ? exr_decoding_run(context, 0, pipeline) : result;
}

static exr_result_t read_picture(struct lx_source *source, const struct lx_exr_header *header, struct lx_loaded *loaded)
{
    exr_context_initializer_t about = {.size = sizeof about,
                                       .error_handler_fn = be_silent,
                                       .user_data = source,
                                       .read_fn = get_bytes,
                                       .size_fn = get_size,
                                       .max_image_width = LX_MOST_PIXELS,
                                       .max_image_height = LX_MOST_PIXELS,
                                       .zip_level = -2,
                                       .dwa_quality = -1,
                                       .flags = EXR_CONTEXT_FLAG_SILENT_HEADER_PARSE |
                                                EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION};
    exr_context_t context = NULL;
    exr_decode_pipeline_t pipeline = {0};
    exr_result_t result = exr_start_read(&context, "picture", &about);
    if (result != EXR_ERR_SUCCESS)
        return result;
    for (int row = header->window[1]; row <= header->window[3] && result == EXR_ERR_SUCCESS;)
        result = read_chunk(context, row, header->window[1], loaded, &pipeline, &row);
    exr_decoding_destroy(context, &pipeline);
    exr_finish(&context);
    return result;
}

luxel_status lx_exr_read(struct lx_source *source, struct lx_loaded *loaded)
{
    struct lx_exr_header header;
    luxel_status status = lx_exr_read_header(source, &header, &loaded->tags);
    if (status == LUXEL_OK)
        status = check_header(source, &header);
    if (status != LUXEL_OK)
        return status;
    loaded->columns = (unsigned)(header.window[2] - header.window[0]) + 1;
    loaded->rows = (unsigned)(header.window[3] - header.window[1]) + 1;
    loaded->sample = LX_SAMPLE_F32;
    if (loaded->columns <= LX_MOST_PIXELS && loaded->rows <= LX_MOST_PIXELS &&
        (double)lx_source_size(source) * MOST_SHRUNK < 2.0 * loaded->columns * loaded->rows)
        return lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL);
    status = lx_loaded_allocate(source, loaded);
    if (status != LUXEL_OK)
        return status;
    exr_result_t result = read_picture(source, &header, loaded);
    if (result == EXR_ERR_OUT_OF_MEMORY)
        return lx_source_out_of_memory(source);
    return result == EXR_ERR_SUCCESS ? lx_source_status(source) : lx_bad_file(source, LX_EXR_NAME, "picture");
}
