/* SPDX-License-Identifier: MIT */
/* Writing a field to a file in the format of its ending, with what is needed to compute it again. */
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../field/field.h"
#include "../format/format.h"
#include "../scene/carried.h"

luxel_status luxel_check_output_name(const char *path, luxel_diagnostics *diagnostics)
{
    const struct lx_format *format;
    return lx_find_format(path, diagnostics, &format);
}

const char *luxel_output_ending(size_t i)
{
    return lx_format_ending(i);
}

/* The texts that go into a picture; those that would be empty are left out. */
struct tags {
    struct lx_tag list[LX_CARRIED_TAGS];
    size_t count;
    char tolerance[LX_NUMBER_SIZE], light_error[LX_NUMBER_SIZE];
};

static void add_tag(struct tags *tags, const char *key, const char *value)
{
    if (value && *value)
        tags->list[tags->count++] = (struct lx_tag){key, value};
}

static void collect_tags(const luxel_field *field, struct tags *tags)
{
    tags->count = 0;
    add_tag(tags, LX_TAG_QUANTITY, lx_carried_quantities[field->quantity]);
    add_tag(tags, LX_TAG_PRECISION, lx_carried_precisions[field->precision]);
    if (field->tolerance > 0)
        add_tag(tags, LX_TAG_TOLERANCE, lx_write_number(field->tolerance, tags->tolerance));
    if (field->light_error > 0)
        add_tag(tags, LX_TAG_LIGHT_ERROR, lx_write_number(field->light_error, tags->light_error));
    add_tag(tags, LX_TAG_UNIT, field->unit);
    add_tag(tags, LX_TAG_SCENE, field->scene);
}

static luxel_status write_image(const luxel_field *field, const char *path, enum lx_sample sample, const void *data,
                                luxel_diagnostics *diagnostics)
{
    struct tags tags;
    collect_tags(field, &tags);
    struct lx_image image = {
        .columns = field->columns,
        .rows = field->rows,
        .channels = 1,
        .sample = sample,
        .data = data,
        .mask = field->mask,
        .x_mm = field->x_mm,
        .y_mm = field->y_mm,
        .unit = field->unit,
        .tags = tags.list,
        .tag_count = tags.count,
    };
    return lx_write_image(path, &image, diagnostics);
}

static luxel_status write_grey(const luxel_field *field, const char *path, bool fine, luxel_diagnostics *diagnostics)
{
    void *grey = lx_new_aligned((size_t)field->columns * field->rows, fine ? sizeof(uint16_t) : sizeof(uint8_t));
    if (!grey)
        return lx_out_of_memory(diagnostics);
    if (fine)
        luxel_field_grey16(field, grey);
    else
        luxel_field_grey(field, grey);
    luxel_status status = write_image(field, path, fine ? LX_SAMPLE_U16 : LX_SAMPLE_U8, grey, diagnostics);
    free(grey);
    return status;
}

luxel_status luxel_field_write_as(const luxel_field *field, const char *path, const luxel_output *how,
                                  luxel_diagnostics *diagnostics)
{
    const struct lx_format *format;
    const unsigned bits = how && how->bits ? how->bits : 8;
    luxel_status status = lx_find_format(path, diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    if (bits != 8 && bits != 16)
        return lx_setting_out_of_range(diagnostics, "bits", bits, LX_N("8 or 16"));
    if (!(format->samples & (LX_SAMPLE_F32 | LX_SAMPLE_F64)))
        return write_grey(field, path, bits == 16, diagnostics);
    enum lx_sample sample = field->precision == LUXEL_DOUBLE ? LX_SAMPLE_F64 : LX_SAMPLE_F32;
    return write_image(field, path, sample, field->values, diagnostics);
}

luxel_status luxel_field_write(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics)
{
    return luxel_field_write_as(field, path, NULL, diagnostics);
}
