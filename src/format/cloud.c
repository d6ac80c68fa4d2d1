/* SPDX-License-Identifier: MIT */
/* Reading clouds of points: tables row by row, so that only the numbers stay in memory, and NPY. */
#include "cloud.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "npy.h"

static const struct lx_cloud_report GOOD = {.message = LX_MSG_COUNT};

void lx_cloud_free(struct lx_kept *kept)
{
    struct lx_cloud *cloud = (struct lx_cloud *)kept;
    free(cloud->values);
    lx_kept_slot_free(cloud->tree);
    free(cloud);
}

struct lx_cloud *lx_cloud_new(size_t count)
{
    struct lx_cloud *cloud = lx_new_array(1, sizeof *cloud);
    if (!cloud)
        return NULL;
    lx_kept_init(&cloud->kept, lx_cloud_free);
    cloud->count = count;
    cloud->values = lx_new_aligned(count, LX_CLOUD_COLUMNS * sizeof(double));
    if (cloud->values)
        return cloud;
    lx_cloud_free(&cloud->kept);
    return NULL;
}

static struct lx_cloud_report say(enum lx_message message, const char *text)
{
    struct lx_cloud_report report = {.message = message};
    snprintf(report.text, sizeof report.text, "%s", text);
    return report;
}

static struct lx_cloud_report wrong(const struct lx_text_table_fault *fault)
{
    struct lx_cloud_report report = {.message = LX_MSG_CLOUD_TABLE, .fault = *fault};
    report.fault.text = NULL; /* the text is gone when it is told */
    report.number = fault->line;
    if (fault->message == LX_MSG_OUT_OF_MEMORY)
        report.message = fault->message;
    else if (fault->line > 0)
        report.message = fault->column > 0 ? LX_MSG_CLOUD_PLACE : LX_MSG_CLOUD_LINE;
    return report;
}

/* ---- CSV ---- */

static const char *const X_NAMES[] = {"x", "х", "pos_x", "position_x", "px", NULL};
static const char *const Y_NAMES[] = {"y", "у", "pos_y", "position_y", "py", NULL};
static const char *const Z_NAMES[] = {"z", "pos_z", "position_z", "pz", NULL};
static const char *const INTENSITY_NAMES[] = {"intensity",
                                              "radiant intensity",
                                              "luminous intensity",
                                              "radiant_intensity",
                                              "luminous_intensity",
                                              "интенсивность",
                                              "сила света",
                                              "сила излучения",
                                              "i",
                                              NULL};

static const luxel_table_column COLUMNS[LX_CLOUD_COLUMNS] = {
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = X_NAMES},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = Y_NAMES},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = Z_NAMES},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = INTENSITY_NAMES},
};

static const struct lx_text_table_form FORM = {.columns = COLUMNS, .count = LX_CLOUD_COLUMNS, .takes_lp = true};

/* What a number in a unit of intensity is in W/sr or cd; 0: it is none. */
static double intensity_unit(const char *unit)
{
    static const struct {
        const char *name;
        double size;
    } units[] = {
        {"", 1},         {"W/sr", 1},      {"w/sr", 1},   {"cd", 1},     {"lm/sr", 1}, {"W sr^-1", 1}, {"W sr⁻¹", 1},
        {"W sr-1", 1},   {"Cd", 1},        {"W·sr⁻¹", 1}, {"Вт/ср", 1},  {"кд", 1},    {"лм/ср", 1},   {"candela", 1},
        {"mW/sr", 1e-3}, {"мВт/ср", 1e-3}, {"mcd", 1e-3}, {"мкд", 1e-3}, {"kcd", 1e3}, {"ккд", 1e3},   {"kW/sr", 1e3},
    };
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(units[i].name, unit) == 0)
            return units[i].size;
    return 0;
}

static struct lx_cloud_report read_rows(struct lx_text_table *table, struct lx_cloud *cloud)
{
    bool has_intensities = lx_text_table_has(table, 3);
    double scale = intensity_unit(lx_text_table_unit(table, 3)), row[LX_CLOUD_COLUMNS];
    struct lx_text_table_fault fault;
    size_t capacity = 0;
    if (scale == 0)
        return say(LX_MSG_CLOUD_UNIT, lx_text_table_unit(table, 3));
    while (lx_text_table_next(table, row, &fault)) {
        if (has_intensities && isnan(row[3]))
            fault = lx_text_table_fault_at(table, 3, LX_MSG_TABLE_MISSING);
        else if (row[3] < 0)
            fault = lx_text_table_fault_at(table, 3, LX_MSG_CLOUD_NEGATIVE);
        if (fault.message != LX_MSG_COUNT) {
            snprintf(fault.words[1], sizeof fault.words[1], "%s", INTENSITY_NAMES[0]);
            return wrong(&fault);
        }
        if (cloud->count == LX_MOST_POINTS)
            return (struct lx_cloud_report){.message = LX_MSG_CLOUD_TOO_LARGE, .number = lx_text_table_line(table)};
        if (lx_reserve(&cloud->values, &capacity, cloud->count + 1, sizeof row) < 0)
            return say(LX_MSG_OUT_OF_MEMORY, "");
        row[3] = has_intensities ? row[3] * scale : 1;
        memcpy((double *)cloud->values + LX_CLOUD_COLUMNS * cloud->count++, row, sizeof row);
    }
    if (fault.message != LX_MSG_COUNT)
        return wrong(&fault);
    cloud->intensities = has_intensities ? LX_CLOUD_TOLD : lx_text_table_is_lp(table) ? LX_CLOUD_LP : LX_CLOUD_NOT_TOLD;
    lx_text_table_list_unused(table, cloud->unused, sizeof cloud->unused);
    return cloud->count > 0 ? GOOD : say(LX_MSG_CLOUD_EMPTY, "");
}

static struct lx_cloud_report read_csv(struct lx_source *source, struct lx_cloud *cloud)
{
    struct lx_text_table_fault fault;
    struct lx_text_table *table = lx_text_table_new(source, &FORM, &fault);
    if (!table)
        return say(LX_MSG_OUT_OF_MEMORY, "");
    struct lx_cloud_report report = fault.message == LX_MSG_COUNT ? read_rows(table, cloud) : wrong(&fault);
    lx_text_table_free(table);
    size_t bytes = cloud->count * LX_CLOUD_COLUMNS * sizeof(double);
    void *fitting = bytes > 0 ? realloc(cloud->values, bytes) : NULL;
    if (fitting)
        cloud->values = fitting;
    return report;
}

/* ---- NPY ---- */

static struct lx_cloud_report check_header(const struct lx_npy *npy, uint64_t size)
{
    if (npy->width == 0)
        return say(LX_MSG_CLOUD_DESCR, npy->descr);
    if (npy->columns != LX_CLOUD_COLUMNS && npy->columns != LX_CLOUD_COLUMNS - 1)
        return say(LX_MSG_CLOUD_SHAPE, npy->shape);
    if (npy->rows == 0)
        return say(LX_MSG_CLOUD_EMPTY, "");
    if (npy->rows > LX_MOST_POINTS)
        return say(LX_MSG_CLOUD_TOO_LARGE, "");
    if (npy->start + (uint64_t)npy->rows * npy->columns * npy->width != size)
        return (struct lx_cloud_report){.message = LX_MSG_CLOUD_SIZE, .number = npy->rows};
    return GOOD;
}

/* Gives rows that tell places only the intensity 1, from the last one on, as they lie in front of what they become. */
static void add_intensities(struct lx_cloud *cloud)
{
    const size_t size = cloud->is_single ? sizeof(float) : sizeof(double);
    char *values = cloud->values;
    for (size_t i = cloud->count; i-- > 0;) {
        char *row = values + LX_CLOUD_COLUMNS * i * size;
        memmove(row, values + (LX_CLOUD_COLUMNS - 1) * i * size, (LX_CLOUD_COLUMNS - 1) * size);
        if (cloud->is_single)
            ((float *)cloud->values)[LX_CLOUD_COLUMNS * i + LX_CLOUD_COLUMNS - 1] = 1;
        else
            ((double *)cloud->values)[LX_CLOUD_COLUMNS * i + LX_CLOUD_COLUMNS - 1] = 1;
    }
    cloud->intensities = LX_CLOUD_NOT_TOLD;
}

static struct lx_cloud_report check_rows(const struct lx_cloud *cloud)
{
    for (size_t i = 0; i < cloud->count; i++) {
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(cloud, i, row);
        if (!isfinite(row[0]) || !isfinite(row[1]) || !isfinite(row[2]) || !isfinite(row[3]))
            return (struct lx_cloud_report){.message = LX_MSG_CLOUD_ROW_NOT_FINITE, .number = i + 1};
        if (row[3] < 0)
            return (struct lx_cloud_report){.message = LX_MSG_CLOUD_ROW_NEGATIVE, .number = i + 1};
    }
    return GOOD;
}

static struct lx_cloud_report read_npy(struct lx_source *source, struct lx_cloud *cloud)
{
    struct lx_npy npy;
    const char *word = lx_npy_read_header(source, &npy);
    if (word)
        return say(LX_MSG_CLOUD_DAMAGED, word);
    if (lx_source_status(source) != LUXEL_OK)
        return GOOD;
    struct lx_cloud_report report = check_header(&npy, lx_source_size(source));
    if (report.message != LX_MSG_COUNT)
        return report;
    size_t numbers = (size_t)npy.rows * LX_CLOUD_COLUMNS;
    cloud->is_single = npy.sample == LX_SAMPLE_F32;
    cloud->values = lx_new_array(numbers, cloud->is_single ? sizeof(float) : sizeof(double));
    cloud->count = npy.rows;
    if (!cloud->values)
        return say(LX_MSG_OUT_OF_MEMORY, "");
    struct lx_loaded loaded = {.sample = npy.sample, .values = cloud->values};
    if (lx_npy_read_numbers(source, &npy, &loaded) != LUXEL_OK)
        return GOOD;
    if (npy.columns < LX_CLOUD_COLUMNS)
        add_intensities(cloud);
    return check_rows(cloud);
}

/* ---- either ---- */

struct lx_cloud *lx_cloud_with_intensity(const struct lx_cloud *cloud, double intensity)
{
    struct lx_cloud *copy = lx_cloud_new(cloud->count);
    if (!copy)
        return NULL;
    copy->intensities = cloud->intensities;
    memcpy(copy->unused, cloud->unused, sizeof copy->unused);
    for (size_t i = 0; i < cloud->count; i++) {
        double *row = (double *)copy->values + LX_CLOUD_COLUMNS * i;
        lx_cloud_row(cloud, i, row);
        row[3] = intensity;
    }
    return copy;
}

struct lx_cloud_report lx_cloud_read(struct lx_source *source, struct lx_cloud **result)
{
    struct lx_cloud *cloud = lx_new_array(1, sizeof *cloud);
    *result = NULL;
    if (!cloud)
        return say(LX_MSG_OUT_OF_MEMORY, "");
    lx_kept_init(&cloud->kept, lx_cloud_free);
    cloud->tree = lx_kept_slot_new();
    if (!cloud->tree) {
        lx_cloud_free(&cloud->kept);
        return say(LX_MSG_OUT_OF_MEMORY, "");
    }
    bool is_npy = lx_format_of_content(source) == &lx_format_npy;
    struct lx_cloud_report report = is_npy ? read_npy(source, cloud) : read_csv(source, cloud);
    if (report.message == LX_MSG_COUNT && lx_source_status(source) == LUXEL_OK)
        *result = cloud;
    else
        lx_cloud_free(&cloud->kept);
    return report;
}
