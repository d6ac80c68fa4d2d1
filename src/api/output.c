/* SPDX-License-Identifier: MIT */
/* Writing a field to a file in the format of its ending. */
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../field/field.h"
#include "../format/format.h"

luxel_status luxel_check_output_name(const char *path, luxel_diagnostics *diagnostics)
{
    const struct lx_format *format;
    return lx_find_format(path, diagnostics, &format);
}

static luxel_status write_grey(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics)
{
    uint8_t *grey = lx_new_aligned((size_t)field->columns * field->rows, 1);
    if (!grey)
        return lx_out_of_memory(diagnostics);
    luxel_field_grey(field, grey);
    struct lx_image image = {
        .columns = field->columns, .rows = field->rows, .channels = 1, .sample = LX_SAMPLE_U8, .data = grey};
    luxel_status status = lx_write_image(path, &image, diagnostics);
    free(grey);
    return status;
}

luxel_status luxel_field_write(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics)
{
    const struct lx_format *format;
    luxel_status status = lx_find_format(path, diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    if (!(format->samples & (LX_SAMPLE_F32 | LX_SAMPLE_F64)))
        return write_grey(field, path, diagnostics);
    struct lx_image image = {
        .columns = field->columns,
        .rows = field->rows,
        .channels = 1,
        .sample = field->precision == LUXEL_DOUBLE ? LX_SAMPLE_F64 : LX_SAMPLE_F32,
        .data = field->values,
    };
    return lx_write_image(path, &image, diagnostics);
}
