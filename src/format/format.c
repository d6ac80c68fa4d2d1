/* SPDX-License-Identifier: MIT */
/* The table of file formats, and the choice from it by ending and by content. */
#include "format.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../base/memory.h"
#include "../base/path.h"

enum { LONGEST_MAGIC = 8, MOST_OF_A_PIPE = 1 << 30 };

static const struct lx_format *const FORMATS[] = {&lx_format_png, &lx_format_npy, &lx_format_pfm, &lx_format_csv,
                                                  &lx_format_exr};
enum { FORMAT_COUNT = sizeof FORMATS / sizeof FORMATS[0] };

/* The format whose library may be missing is the last, so that those that can be written stand together. */
const char *lx_format_ending(size_t i)
{
    return i < FORMAT_COUNT && FORMATS[i]->begin ? FORMATS[i]->ending : NULL;
}

/* The ending of the last name in a path with its dot, or NULL.  A dot that begins a name begins no ending. */
static const char *ending_of(const char *path)
{
    const char *name = lx_path_name(path);
    const char *dot = strrchr(name, '.');
    return dot && dot != name && dot[1] != '\0' ? dot : NULL;
}

/* The format of an ending, or NULL. */
static const struct lx_format *format_of_ending(const char *ending)
{
    for (size_t i = 0; ending && i < FORMAT_COUNT; i++)
        if (strcasecmp(ending, FORMATS[i]->ending) == 0)
            return FORMATS[i];
    return NULL;
}

/* ".png, .npy": the endings of all formats, or of those that fields can be read from. */
static const char *list_endings(bool readable, char list[FORMAT_COUNT * 8])
{
    list[0] = '\0'; /* each ending and its separator are shorter than 8 */
    for (size_t i = 0; i < FORMAT_COUNT; i++)
        if (readable ? FORMATS[i]->read != NULL : FORMATS[i]->begin != NULL)
            strcat(strcat(list, list[0] ? ", " : ""), FORMATS[i]->ending);
    return list;
}

luxel_status lx_find_format(const char *path, luxel_diagnostics *diagnostics, const struct lx_format **format)
{
    const char *ending = ending_of(path);
    const struct lx_format *found = format_of_ending(ending);
    char known[FORMAT_COUNT * 8];
    if (found && found->begin) {
        *format = found;
        return LUXEL_OK;
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, ending ? LX_MSG_UNKNOWN_ENDING : LX_MSG_NO_ENDING,
              LX_ARGS(path, ending));
    lx_hint(diagnostics, LX_MSG_KNOWN_ENDINGS, LX_ARGS(list_endings(false, known)));
    return LUXEL_ERROR_ARGUMENT;
}

const struct lx_format *lx_format_of_content(struct lx_source *source)
{
    char start[LONGEST_MAGIC];
    uint64_t size = lx_source_size(source);
    size_t length = size < LONGEST_MAGIC ? (size_t)size : LONGEST_MAGIC;
    if (lx_source_read(source, 0, start, length) != LUXEL_OK)
        return NULL;
    for (size_t i = 0; i < FORMAT_COUNT; i++)
        if (FORMATS[i]->magic && FORMATS[i]->magic_length <= length &&
            memcmp(start, FORMATS[i]->magic, FORMATS[i]->magic_length) == 0)
            return FORMATS[i];
    return NULL;
}

static luxel_status check_image(const char *path, const struct lx_format *format, const struct lx_image *image,
                                luxel_diagnostics *diagnostics)
{
    bool no_places = format->needs_places && (!image->x_mm || !image->y_mm);
    if (!no_places && (format->samples & (unsigned)image->sample) && (image->channels == 1 || image->channels == 3) &&
        image->columns > 0 && image->rows > 0)
        return LUXEL_OK;
    return lx_refuse(diagnostics, no_places ? LX_MSG_NO_PLACES : LX_MSG_UNFIT_IMAGE, LX_ARGS(path, format->name));
}

luxel_status lx_writer_open(const struct lx_destination *destination, const struct lx_image *image,
                            luxel_diagnostics *diagnostics, struct lx_writer **writer)
{
    const struct lx_format *format;
    luxel_status status = lx_find_format(destination->path, diagnostics, &format);
    if (status == LUXEL_OK)
        status = check_image(destination->path, format, image, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct lx_writer *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    made->format = format;
    made->image = *image;
    status = lx_sink_open_at(destination, diagnostics, &made->sink);
    if (status != LUXEL_OK) {
        free(made);
        return status;
    }
    format->begin(made);
    *writer = made;
    return LUXEL_OK;
}

bool lx_writer_takes_strips(const struct lx_writer *writer)
{
    return !(writer->format->bottom_up && lx_sink_is_direct(writer->sink));
}

void lx_writer_add(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    if (lx_sink_status(writer->sink) == LUXEL_OK)
        writer->format->add(writer, strip);
}

luxel_status lx_writer_commit(struct lx_writer *writer)
{
    if (writer->format->end)
        writer->format->end(writer, lx_sink_status(writer->sink) == LUXEL_OK);
    luxel_status status = lx_sink_commit(writer->sink);
    free(writer);
    return status;
}

void lx_writer_abort(struct lx_writer *writer)
{
    if (!writer)
        return;
    if (writer->format->end)
        writer->format->end(writer, false);
    lx_sink_abort(writer->sink);
    free(writer);
}

luxel_status lx_write_image(const char *path, const struct lx_image *image, luxel_diagnostics *diagnostics)
{
    const struct lx_image_strip all = {.rows = image->rows, .data = image->data, .mask = image->mask};
    struct lx_writer *writer;
    luxel_status status = lx_writer_open(&(struct lx_destination){.path = path}, image, diagnostics, &writer);
    if (status != LUXEL_OK)
        return status;
    lx_writer_add(writer, &all);
    return lx_writer_commit(writer);
}

/* The content decides; where it tells nothing the ending does, and the format says what is wrong with the content. */
luxel_status lx_read_image_of(struct lx_source *source, struct lx_loaded *loaded)
{
    const struct lx_format *format = lx_format_of_content(source);
    char known[FORMAT_COUNT * 8];
    if (lx_source_status(source) != LUXEL_OK)
        return lx_source_status(source);
    if (!format)
        format = format_of_ending(ending_of(lx_source_name(source)));
    if (format && format->read)
        return format->read(source, loaded);
    luxel_status status = format ? lx_source_refuse(source, LX_MSG_NO_VALUES, LX_ARGS(format->name))
                                 : lx_source_refuse(source, LX_MSG_UNKNOWN_CONTENT, NULL);
    lx_hint(lx_source_diagnostics(source), LX_MSG_READABLE_FORMATS, LX_ARGS(list_endings(true, known)));
    return status;
}

luxel_status lx_read_image(const char *path, luxel_diagnostics *diagnostics, struct lx_loaded *loaded)
{
    struct lx_source *source = NULL;
    luxel_status status = lx_source_open(path, MOST_OF_A_PIPE, diagnostics, &source);
    if (status == LUXEL_OK)
        status = lx_read_image_of(source, loaded);
    lx_source_close(source);
    return status;
}

void lx_loaded_clear(struct lx_loaded *loaded)
{
    free(loaded->values);
    free(loaded->mask);
    free(loaded->x_mm);
    free(loaded->y_mm);
    free(loaded->unit);
    lx_tags_clear(&loaded->tags);
    *loaded = (struct lx_loaded){0};
}
