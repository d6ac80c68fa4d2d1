/* SPDX-License-Identifier: MIT */
/*
 * PNG pictures of 8-bit or 16-bit grey, or of sRGB, which they then say, through libpng, with their tags as iTXt chunks
 * before the picture.  The same image gives the same bytes: nothing of time or place goes in.  Without row filters and
 * at zlib's level 4 an 800 x 800 picture takes 3 ms, a fifth of libpng's defaults, and is hardly larger (48 instead of
 * 45 kB; level 1: 2.3 ms and 77 kB).  Of 16 bits the line above is taken off: without, the low bytes look like noise
 * (it saves three quarters of the size and costs no time).
 */
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "format.h"
#include "png_tags.h"

enum {
    LEVEL = 4,
    LONG_TEXT = 16 * 1024 /* longer ones are compressed; shorter ones can be read with any pager */
};

static void put_bytes(png_structp png, png_bytep bytes, size_t count)
{
    if (lx_sink_write(png_get_io_ptr(png), bytes, count) != LUXEL_OK)
        png_error(png, "the sink failed");
}

/* The sink flushes when it is committed. */
static void flush_nothing(png_structp png)
{
    (void)png;
}

/* libpng wants this never to return.  A sink that has failed keeps the report that it has. */
static void fail(png_structp png, const char *text)
{
    lx_sink_fail(png_get_error_ptr(png), LX_MSG_PNG_FAILED, text);
    png_longjmp(png, 1);
}

static void ignore_warning(png_structp png, const char *text)
{
    (void)png;
    (void)text;
}

/* libpng reads keys and texts only, although its struct is not made for constants. */
static char *as_variable(const char *text)
{
    char *same;
    memcpy(&same, &text, sizeof same);
    return same;
}

struct own {
    png_structp png;
    png_infop info;
};

static size_t width_of(const struct lx_image *image)
{
    return image->sample == LX_SAMPLE_U16 ? sizeof(uint16_t) : sizeof(uint8_t);
}

static void set_texts(const struct own *own, const struct lx_image *image, png_text *texts)
{
    for (size_t i = 0; i < image->tag_count; i++) {
        size_t length = strlen(image->tags[i].value);
        texts[i] = (png_text){
            .compression = length > LONG_TEXT ? PNG_ITXT_COMPRESSION_zTXt : PNG_ITXT_COMPRESSION_NONE,
            .key = as_variable(image->tags[i].key),
            .text = as_variable(image->tags[i].value),
            .itxt_length = length,
        };
    }
    if (image->tag_count > 0)
        png_set_text(own->png, own->info, texts, (int)image->tag_count);
}

/* Says that colours are sRGB: by its own chunk and, for displays of today, by cICP, which libpng 1.6 does not know. */
static void set_srgb(const struct own *own)
{
    png_byte code[4] = {1, 13, 0, 1};
    png_unknown_chunk chunk = {.name = "cICP", .data = code, .size = sizeof code, .location = PNG_HAVE_IHDR};
    png_set_sRGB(own->png, own->info, PNG_sRGB_INTENT_RELATIVE);
    png_set_keep_unknown_chunks(own->png, PNG_HANDLE_CHUNK_ALWAYS, NULL, 0);
    png_set_unknown_chunks(own->png, own->info, &chunk, 1);
}

static void write_header(const struct own *own, const struct lx_image *image, png_text *texts)
{
    png_structp png = own->png;
    const size_t width = width_of(image);
    png_set_IHDR(png, own->info, image->columns, image->rows, (int)(8 * width),
                 image->channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (image->channels == 3)
        set_srgb(own);
    png_set_compression_level(png, LEVEL);
    png_set_text_compression_level(png, LEVEL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, width > 1 ? PNG_FILTER_UP : PNG_FILTER_NONE);
    set_texts(own, image, texts);
    png_write_info(png, own->info);
    if (width > 1 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
        png_set_swap(png);
}

/* In the functions that libpng jumps back to nothing changes until it does, so nothing needs to be volatile. */
static void begin_png(struct lx_writer *writer)
{
    struct own *own = writer->own = lx_new_array(1, sizeof *own);
    png_text *texts = lx_new_array(writer->image.tag_count, sizeof *texts);
    if (own)
        own->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, writer->sink, fail, ignore_warning);
    if (own && own->png)
        own->info = png_create_info_struct(own->png);
    if (!own || !own->info || !texts) {
        lx_sink_out_of_memory(writer->sink);
    } else if (setjmp(png_jmpbuf(own->png)) == 0) {
        png_set_write_fn(own->png, writer->sink, put_bytes, flush_nothing);
        write_header(own, &writer->image, texts);
    }
    free(texts);
}

static void write_rows(png_structp png, const struct lx_image *image, const struct lx_image_strip *strip)
{
    for (unsigned row = 0; row < strip->rows; row++)
        png_write_row(png, (const png_byte *)strip->data + row * lx_row_samples(image) * width_of(image));
}

static void add_png(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    struct own *own = writer->own;
    if (setjmp(png_jmpbuf(own->png)) == 0)
        write_rows(own->png, &writer->image, strip);
}

static void end_png(struct lx_writer *writer, bool whole)
{
    struct own *own = writer->own;
    if (whole && setjmp(png_jmpbuf(own->png)) == 0)
        png_write_end(own->png, NULL);
    if (own)
        png_destroy_write_struct(&own->png, &own->info);
    free(own);
}

const struct lx_format lx_format_png = {
    .ending = ".png",
    .name = "PNG",
    .samples = LX_SAMPLE_U8 | LX_SAMPLE_U16,
    .magic = LX_PNG_MAGIC,
    .magic_length = LX_PNG_MAGIC_LENGTH,
    .begin = begin_png,
    .add = add_png,
    .end = end_png,
    .read_tags = lx_png_read_tags,
};
