/* SPDX-License-Identifier: MIT */
/* Reading an array as a table: its header is held against the columns that are wanted, its numbers become double. */
#include "array_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "npy.h"

struct lx_array_table {
    const struct lx_text_table_form *form;
    struct lx_npy npy;
    void *values; /* float or double, row by row */
    size_t next;
};

bool lx_is_array(struct lx_source *source)
{
    return lx_format_of_content(source) == &lx_format_npy;
}

static size_t required_columns(const struct lx_text_table_form *form)
{
    size_t required = 0;
    while (required < form->count && form->columns[required].is_required)
        required++;
    return required;
}

/* What is wrong with a header; LUXEL_OK: nothing. */
static luxel_status check_header(struct lx_source *source, const struct lx_npy *npy,
                                 const struct lx_text_table_form *form)
{
    size_t required = required_columns(form);
    char text[64];
    if (form->needs_heading) {
        lx_text_table_list_columns(form, text, sizeof text);
        return lx_source_refuse(source, LX_MSG_TABLE_NAMELESS, LX_ARGS(text));
    }
    if (npy->width == 0)
        return lx_source_refuse(source, LX_MSG_TABLE_DESCR, LX_ARGS(npy->descr));
    if (npy->columns == 0 || (npy->columns != required && npy->columns != form->count)) {
        snprintf(text, sizeof text, required < form->count ? "(N, %zu), (N, %zu)" : "(N, %zu)", required, form->count);
        return lx_source_refuse(source, LX_MSG_TABLE_SHAPE, LX_ARGS(npy->shape, text));
    }
    if (npy->start + (uint64_t)npy->rows * npy->columns * npy->width != lx_source_size(source))
        return lx_source_refuse(source, LX_MSG_TABLE_SIZE, LX_ARGS(lx_write_number(npy->rows, text)));
    return LUXEL_OK;
}

luxel_status lx_array_table_new(struct lx_source *source, const struct lx_text_table_form *form,
                                struct lx_array_table **array)
{
    struct lx_array_table *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_source_out_of_memory(source);
    made->form = form;
    const char *word = lx_npy_read_header(source, &made->npy);
    luxel_status status = word ? lx_bad_file(source, lx_format_npy.name, word) : lx_source_status(source);
    if (status == LUXEL_OK)
        status = check_header(source, &made->npy, form);
    if (status == LUXEL_OK && made->npy.rows > 0) {
        size_t width = made->npy.sample == LX_SAMPLE_F32 ? sizeof(float) : sizeof(double);
        made->values = lx_new_array((size_t)made->npy.rows * made->npy.columns, width);
        struct lx_loaded loaded = {.sample = made->npy.sample, .values = made->values};
        status = made->values ? lx_npy_read_numbers(source, &made->npy, &loaded) : lx_source_out_of_memory(source);
    }
    if (status == LUXEL_OK)
        *array = made;
    else
        lx_array_table_free(made);
    return status;
}

void lx_array_table_free(struct lx_array_table *array)
{
    if (!array)
        return;
    free(array->values);
    free(array);
}

bool lx_array_table_has(const struct lx_array_table *array, size_t column)
{
    return column < array->npy.columns;
}

size_t lx_array_table_row(const struct lx_array_table *array)
{
    return array->next;
}

bool lx_array_table_next(struct lx_array_table *array, double *numbers, bool *is_good)
{
    const struct lx_npy *npy = &array->npy;
    size_t start = array->next * npy->columns;
    if (array->next == npy->rows)
        return false;
    array->next++;
    *is_good = true;
    for (size_t c = 0; c < array->form->count; c++) {
        numbers[c] = c >= npy->columns              ? (double)NAN
                     : npy->sample == LX_SAMPLE_F32 ? (double)((const float *)array->values)[start + c]
                                                    : ((const double *)array->values)[start + c];
        bool must_be_finite = c < npy->columns && array->form->columns[c].type != LUXEL_TABLE_VALUE;
        *is_good = *is_good && (!must_be_finite || isfinite(numbers[c]));
    }
    return true;
}
