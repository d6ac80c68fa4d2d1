/* SPDX-License-Identifier: MIT */
/* Reading tables of pixels: first the lines, then the grid that they lie on. */
#include "csv_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "text_table.h"

/* A grid may lack so many pixels for each that there is, or be so large: two small surfaces far apart. */
static const double MOST_MISSING = 1000, SMALL_GRID = 1 << 24;

struct pixel {
    double x_mm, y_mm, value;
};

enum column { X, Y, VALUE, COLUMN_COUNT };

static const char *const X_NAMES[] = {"x", "х", NULL};
static const char *const Y_NAMES[] = {"y", "у", NULL};
static const char *const VALUE_NAMES[] = {
    "value",        "значение",     "brightness",   "яркость",  "irradiance", "illuminance",
    "освещённость", "освещенность", "облучённость", "radiance", "luminance",  NULL,
};

static const luxel_table_column COLUMNS[COLUMN_COUNT] = {
    [X] = {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = X_NAMES},
    [Y] = {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = Y_NAMES},
    [VALUE] = {.type = LUXEL_TABLE_VALUE, .is_required = true, .names = VALUE_NAMES},
};

static const struct lx_text_table_form FORM = {.columns = COLUMNS, .count = COLUMN_COUNT};

/* Whether a value is written as a float32 is written here. */
static bool is_single(const struct lx_text_table *table, double value)
{
    char single[LX_NUMBER_SIZE];
    size_t length;
    bool is_quoted;
    const char *text = lx_text_table_field(table, VALUE, &length, &is_quoted);
    if (!isfinite(value))
        return true;
    lx_write_digits((double)(float)value, LX_CSV_SINGLE_DIGITS, single);
    if (strlen(single) != length)
        return false;
    for (size_t i = 0; i < length; i++)
        if (text[i] != single[i] && !(text[i] == ',' && single[i] == '.'))
            return false;
    return true;
}

static luxel_status refuse(struct lx_source *source, const struct lx_text_table_fault *fault)
{
    luxel_diagnostics *diagnostics = lx_source_diagnostics(source);
    if (fault->message == LX_MSG_OUT_OF_MEMORY)
        return lx_source_out_of_memory(source);
    lx_report_fault(diagnostics, lx_source_name(source), fault);
    return lx_source_give_up(source);
}

/* Reads all pixels; `loaded` gets the unit and the kind of samples. */
static luxel_status read_pixels(struct lx_text_table *table, struct lx_source *source, struct lx_loaded *loaded,
                                struct pixel **pixels, size_t *count)
{
    struct lx_text_table_fault fault;
    const char *unit = lx_text_table_unit(table, VALUE);
    double row[COLUMN_COUNT];
    size_t capacity = 0;
    bool all_single = true;
    if (lx_text_table_has_heading(table) && !(loaded->unit = lx_copy_text(unit, strlen(unit))))
        return lx_source_out_of_memory(source);
    while (lx_text_table_next(table, row, &fault)) {
        if (lx_reserve(pixels, &capacity, *count + 1, sizeof **pixels) < 0)
            return lx_source_out_of_memory(source);
        (*pixels)[(*count)++] = (struct pixel){row[X], row[Y], row[VALUE]};
        all_single = all_single && is_single(table, row[VALUE]);
    }
    if (fault.message != LX_MSG_COUNT)
        return refuse(source, &fault);
    loaded->sample = all_single ? LX_SAMPLE_F32 : LX_SAMPLE_F64;
    return *count > 0 ? lx_source_status(source) : lx_source_refuse(source, LX_MSG_TABLE_EMPTY, NULL);
}

/* The steps of the grid along one axis, which may run down. */
struct axis {
    double start, step;
    unsigned count;
};

/* The equal steps between sorted places; false where there are none. */
static bool find_steps(const double *places, size_t count, bool down, struct axis *axis)
{
    double range = places[count - 1] - places[0], least = HUGE_VAL;
    for (size_t i = 1; i < count; i++)
        least = fmin(least, places[i] - places[i - 1]);
    double steps = count > 1 ? round(range / least) : 0;
    if (!(steps < LX_MOST_PIXELS))
        return false;
    double step = steps > 0 ? range / steps : 1;
    for (size_t i = 0; i < count; i++) {
        double at = (places[i] - places[0]) / step;
        if (!(fabs(at - round(at)) < 1e-3))
            return false;
    }
    *axis = (struct axis){down ? places[count - 1] : places[0], down ? -step : step, (unsigned)steps + 1};
    return true;
}

/* Finds an axis from one number of each pixel. */
static luxel_status find_axis(struct lx_source *source, const struct pixel *pixels, size_t count, bool down,
                              struct axis *axis)
{
    double *places = lx_new_array(count, sizeof *places);
    if (!places)
        return lx_source_out_of_memory(source);
    for (size_t i = 0; i < count; i++)
        places[i] = down ? pixels[i].y_mm : pixels[i].x_mm;
    qsort(places, count, sizeof *places, lx_by_value);
    size_t unique = 1;
    for (size_t i = 1; i < count; i++)
        if (places[i] != places[unique - 1])
            places[unique++] = places[i];
    bool good = find_steps(places, unique, down, axis);
    free(places);
    return good ? LUXEL_OK : lx_source_refuse(source, LX_MSG_CSV_NO_GRID, LX_ARGS(down ? "y_mm" : "x_mm"));
}

static double *new_places(const struct axis *axis)
{
    double *places = lx_new_array(axis->count, sizeof *places);
    for (unsigned i = 0; places && i < axis->count; i++)
        places[i] = axis->start + i * axis->step;
    return places;
}

static luxel_status allocate(struct lx_source *source, const struct axis axes[2], size_t count,
                             struct lx_loaded *loaded)
{
    loaded->columns = axes[0].count;
    loaded->rows = axes[1].count;
    double grid = (double)loaded->columns * loaded->rows;
    if (grid > SMALL_GRID && grid > MOST_MISSING * (double)count)
        return lx_source_refuse(source, LX_MSG_CSV_NO_GRID, LX_ARGS("x_mm, y_mm"));
    luxel_status status = lx_loaded_allocate(source, loaded);
    if (status != LUXEL_OK)
        return status;
    loaded->mask = lx_new_array((size_t)loaded->columns * loaded->rows, 1);
    loaded->x_mm = new_places(&axes[0]);
    loaded->y_mm = new_places(&axes[1]);
    return loaded->mask && loaded->x_mm && loaded->y_mm ? LUXEL_OK : lx_source_out_of_memory(source);
}

/* The places that the file tells replace the calculated ones, which may differ in the last digit. */
static luxel_status put_pixel(struct lx_source *source, const struct axis axes[2], const struct pixel *pixel,
                              struct lx_loaded *loaded)
{
    size_t column = (size_t)round((pixel->x_mm - axes[0].start) / axes[0].step);
    size_t row = (size_t)round((pixel->y_mm - axes[1].start) / axes[1].step), i = row * loaded->columns + column;
    if (loaded->mask[i]) {
        char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE];
        return lx_source_refuse(source, LX_MSG_CSV_DOUBLED,
                                LX_ARGS(lx_write_number(pixel->x_mm, x), lx_write_number(pixel->y_mm, y)));
    }
    loaded->mask[i] = 1;
    loaded->x_mm[column] = pixel->x_mm;
    loaded->y_mm[row] = pixel->y_mm;
    if (loaded->sample == LX_SAMPLE_F64)
        ((double *)loaded->values)[i] = pixel->value;
    else
        ((float *)loaded->values)[i] = (float)pixel->value;
    return LUXEL_OK;
}

/* Puts the pixels on the grid on which they lie. */
static luxel_status put_pixels(struct lx_source *source, const struct pixel *pixels, size_t count,
                               struct lx_loaded *loaded)
{
    struct axis axes[2];
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; status == LUXEL_OK && i < 2; i++)
        status = find_axis(source, pixels, count, i == 1, &axes[i]);
    if (status == LUXEL_OK)
        status = allocate(source, axes, count, loaded);
    for (size_t i = 0; status == LUXEL_OK && i < count; i++)
        status = put_pixel(source, axes, &pixels[i], loaded);
    return status;
}

luxel_status lx_csv_read(struct lx_source *source, struct lx_loaded *loaded)
{
    struct lx_text_table_fault fault;
    struct pixel *pixels = NULL;
    size_t count = 0;
    struct lx_text_table *table = lx_text_table_new(source, &FORM, &fault);
    if (!table)
        return lx_source_out_of_memory(source);
    luxel_status status = lx_source_status(source);
    if (status == LUXEL_OK && fault.message != LX_MSG_COUNT)
        status = refuse(source, &fault);
    if (status == LUXEL_OK) {
        lx_text_table_report_unused(table, lx_source_name(source), lx_source_diagnostics(source));
        status = read_pixels(table, source, loaded, &pixels, &count);
    }
    lx_text_table_free(table);
    if (status == LUXEL_OK)
        status = put_pixels(source, pixels, count, loaded);
    free(pixels);
    return status;
}
