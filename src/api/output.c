/* SPDX-License-Identifier: MIT */
/*
 * Writing a picture to a file in the format of its ending, with what is needed to compute it again.
 *
 * Grey levels whose rule needs the whole picture wait for it.  Strips that come before are kept: their values and masks
 * go to a file beside the output, which is never put in place and vanishes with its sink.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../format/format.h"
#include "../scene/carried.h"
#include "output.h"

luxel_status luxel_check_output_name(const char *path, luxel_diagnostics *diagnostics)
{
    const struct lx_format *format;
    return lx_find_format(path, diagnostics, &format);
}

const char *luxel_field_output_ending(size_t i)
{
    return lx_format_ending(i);
}

/* The texts that go into a picture; those that would be empty are left out. */
struct tags {
    struct lx_tag list[LX_CARRIED_TAGS];
    size_t count;
    char tolerance[LX_NUMBER_SIZE], light_error[LX_NUMBER_SIZE], reflected_error[LX_NUMBER_SIZE];
};

struct lx_output {
    const struct luxel_field *field;
    struct lx_destination destination;
    luxel_diagnostics *diagnostics;
    luxel_status status; /* what keeping strips failed with; the writer keeps its own failures */
    struct tags tags;
    struct lx_writer *writer;
    unsigned bits;        /* of a grey level; 0: the values themselves are written */
    void *levels;         /* room for those of some rows */
    unsigned level_rows;  /* how many */
    struct lx_sink *kept; /* values and mask of each strip, one strip after the other; NULL: none was kept */
    double least;         /* lx_greys_least() of all strips that came */
    unsigned channels;    /* of a pixel; a picture in colour comes as one strip */
    size_t clipped;       /* channels */
};

enum { LEVELS = 1 << 16 }; /* pixels turned into grey levels at a time */

static void add_tag(struct tags *tags, const char *key, const char *value)
{
    if (value && *value)
        tags->list[tags->count++] = (struct lx_tag){key, value};
}

static luxel_status collect_tags(const luxel_field *field, struct tags *tags)
{
    const char *scene;
    const luxel_status status = lx_scene_text_get(field->scene, &scene);
    tags->count = 0;
    add_tag(tags, LX_TAG_QUANTITY, lx_carried_quantities[field->quantity]);
    add_tag(tags, LX_TAG_PRECISION, lx_carried_precisions[field->precision]);
    if (field->tolerance > 0)
        add_tag(tags, LX_TAG_TOLERANCE, lx_write_number(field->tolerance, tags->tolerance));
    if (field->light_error > 0)
        add_tag(tags, LX_TAG_LIGHT_ERROR, lx_write_number(field->light_error, tags->light_error));
    if (field->reflected_error > 0)
        add_tag(tags, LX_TAG_REFLECTED_ERROR, lx_write_number(field->reflected_error, tags->reflected_error));
    add_tag(tags, LX_TAG_UNIT, field->unit);
    add_tag(tags, LX_TAG_SCENE, scene);
    return status;
}

luxel_status lx_output_check(const char *path, const luxel_field_output *how, luxel_diagnostics *diagnostics)
{
    const unsigned bits = how ? how->bits : 0;
    luxel_status status = luxel_check_output_name(path, diagnostics);
    if (status == LUXEL_OK && bits != 0 && bits != 8 && bits != 16)
        status = lx_setting_out_of_range(diagnostics, "bits", bits, LX_N("8 or 16"));
    if (status == LUXEL_OK && how)
        status = LX_CHECK_RESERVE(how, diagnostics);
    return status;
}

bool lx_output_carries(const char *path)
{
    const struct lx_format *format;
    return lx_find_format(path, NULL, &format) == LUXEL_OK && format->read_tags;
}

static enum lx_sample_type sample_of(const struct luxel_field *field, unsigned bits)
{
    if (bits > 0)
        return bits == 16 ? LX_SAMPLE_U16 : LX_SAMPLE_U8;
    return field->precision == LUXEL_DOUBLE ? LX_SAMPLE_F64 : LX_SAMPLE_F32;
}

static luxel_status begin(struct lx_output *output, const luxel_field_output *how)
{
    const struct luxel_field *field = output->field;
    const struct lx_format *format;
    luxel_status status = lx_find_format(output->destination.path, output->diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    output->channels = luxel_field_channels(field);
    if (!(format->samples & (LX_SAMPLE_F32 | LX_SAMPLE_F64))) {
        output->bits = how && how->bits ? how->bits : 8;
        output->level_rows = field->columns < LEVELS ? LEVELS / field->columns : 1;
        output->levels =
            lx_new_aligned((size_t)output->level_rows * field->columns * output->channels, output->bits / 8);
        if (!output->levels)
            return lx_out_of_memory(output->diagnostics);
    }
    if (collect_tags(field, &output->tags) != LUXEL_OK)
        return lx_out_of_memory(output->diagnostics);
    const struct lx_image image = {
        .columns = field->columns,
        .rows = field->rows,
        .channels = output->channels,
        .sample = sample_of(field, output->bits),
        .x_mm = field->x_mm,
        .y_mm = field->y_mm,
        .unit = field->unit,
        .tags = output->tags.list,
        .tag_count = output->tags.count,
    };
    return lx_writer_open(&output->destination, &image, output->diagnostics, &output->writer);
}

luxel_status lx_output_open(const struct luxel_field *field, const struct lx_destination *destination,
                            const luxel_field_output *how, luxel_diagnostics *diagnostics, struct lx_output **output)
{
    struct lx_output *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    *made =
        (struct lx_output){.field = field, .destination = *destination, .diagnostics = diagnostics, .least = HUGE_VAL};
    luxel_status status = begin(made, how);
    if (status == LUXEL_OK)
        *output = made;
    else
        lx_output_abort(made);
    return status;
}

bool lx_output_waits(const struct lx_output *output)
{
    return output->bits > 0 && lx_greys_wait(output->field);
}

bool lx_output_wants_all(const struct lx_output *output)
{
    return !lx_writer_takes_strips(output->writer) ||
           (lx_output_waits(output) && lx_sink_is_direct(output->writer->sink));
}

static void write_levels(struct lx_output *output, const struct lx_strip *strip)
{
    const struct luxel_field *field = output->field;
    const struct lx_greys greys = strip->rgb ? lx_greys_of_rgb(field) : lx_greys_of(field, output->least);
    for (unsigned row = 0; row < strip->rows; row += output->level_rows) {
        unsigned left = strip->rows - row, rows = left < output->level_rows ? left : output->level_rows;
        const size_t first = (size_t)row * field->columns, count = (size_t)rows * field->columns;
        if (strip->rgb)
            output->clipped += lx_srgb_levels(&greys, field, first, count, output->bits, output->levels);
        else
            lx_grey_levels(&greys, field, strip, first, count, output->bits, output->levels);
        const struct lx_image_strip levels = {.first = strip->first + row, .rows = rows, .data = output->levels};
        lx_writer_add(output->writer, &levels);
    }
}

/* Bytes of the values of some rows. */
static size_t values_size(const struct luxel_field *field, unsigned rows)
{
    return (size_t)field->columns * rows * (field->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float));
}

static void keep(struct lx_output *output, const struct lx_strip *strip)
{
    const struct luxel_field *field = output->field;
    if (!output->kept) {
        const uint64_t row_size = values_size(field, 1) + field->columns;
        output->status = lx_sink_open_at(&output->destination, output->diagnostics, &output->kept);
        if (output->status == LUXEL_OK)
            output->status = lx_sink_reserve(output->kept, row_size * field->rows);
    }
    if (output->status == LUXEL_OK)
        output->status = lx_sink_write(output->kept, strip->values, values_size(field, strip->rows));
    if (output->status == LUXEL_OK)
        output->status = lx_sink_write(output->kept, strip->mask, (size_t)field->columns * strip->rows);
}

void lx_output_add(struct lx_output *output, const struct lx_strip *strip)
{
    if (output->status != LUXEL_OK)
        return;
    if (output->bits > 0)
        output->least = fmin(output->least, lx_greys_least(output->field, strip));
    if (lx_output_waits(output) && strip->rows < output->field->rows) {
        keep(output, strip);
    } else if (output->bits > 0) {
        write_levels(output, strip);
    } else {
        const struct lx_image_strip values = {strip->first, strip->rows, strip->rgb ? strip->rgb : strip->values,
                                              strip->mask};
        lx_writer_add(output->writer, &values);
    }
}

void lx_output_catch_up(struct lx_output *output, struct lx_strip *strip)
{
    const struct luxel_field *field = output->field;
    size_t values = values_size(field, strip->rows), mask = (size_t)field->columns * strip->rows;
    uint64_t place = (uint64_t)strip->first * (values_size(field, 1) + field->columns);
    if (!output->kept || output->status != LUXEL_OK)
        return;
    output->status = lx_sink_read_back(output->kept, place, strip->values, values);
    if (output->status == LUXEL_OK)
        output->status = lx_sink_read_back(output->kept, place + values, strip->mask, mask);
    if (output->status == LUXEL_OK)
        write_levels(output, strip);
}

luxel_status lx_output_commit(struct lx_output *output)
{
    luxel_status status = output->status;
    if (output->clipped > 0) {
        const double all = 3.0 * output->field->columns * output->field->rows;
        char clipped[LX_NUMBER_SIZE], channels[LX_NUMBER_SIZE];
        lx_report(output->diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_CHANNELS_CLIPPED,
                  LX_ARGS(output->destination.path, lx_write_number((double)output->clipped, clipped),
                          lx_write_number(all, channels)));
    }
    if (status == LUXEL_OK) {
        status = lx_writer_commit(output->writer);
        output->writer = NULL;
    }
    lx_output_abort(output);
    return status;
}

void lx_output_abort(struct lx_output *output)
{
    if (!output)
        return;
    lx_writer_abort(output->writer);
    lx_sink_abort(output->kept);
    free(output->levels);
    free(output);
}

static luxel_status write_to(const struct lx_destination *destination, const luxel_field *field,
                             const luxel_field_output *how, luxel_diagnostics *diagnostics)
{
    const struct lx_strip all = lx_whole_strip(field);
    struct lx_output *output;
    luxel_status status = lx_output_check(destination->path, how, diagnostics);
    if (status == LUXEL_OK)
        status = lx_output_open(field, destination, how, diagnostics, &output);
    if (status != LUXEL_OK)
        return status;
    lx_output_add(output, &all);
    return lx_output_commit(output);
}

luxel_status luxel_field_write_as(const luxel_field *field, const char *path, const luxel_field_output *how,
                                  luxel_diagnostics *diagnostics)
{
    return write_to(&(struct lx_destination){.path = path}, field, how, diagnostics);
}

luxel_status luxel_field_write_memory(const luxel_field *field, const char *name, const luxel_field_output *how,
                                      luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length)
{
    return write_to(&(struct lx_destination){name, bytes, length}, field, how, diagnostics);
}

luxel_status luxel_field_write(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics)
{
    return luxel_field_write_as(field, path, NULL, diagnostics);
}
