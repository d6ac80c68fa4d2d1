/* SPDX-License-Identifier: MIT */
/* Painting a field through a table of colours. */
#include "display.h"

#include <math.h>
#include <string.h>

enum { COLORS = 1024, BYTES = 4 };
static const double DECADES = 4; /* of the logarithmic range, as of the scene's range `log` */

void app_display_init(AppDisplay *display)
{
    *display = (AppDisplay){.palette = "grey", .high = 1, .maximum = TRUE, .marks = TRUE, .outline = TRUE};
}

gboolean app_display_is_plain(const AppDisplay *display)
{
    return strcmp(display->palette, "grey") == 0 && !display->logarithmic && !display->is_locked &&
           display->exposure == 0;
}

void app_display_range(const AppDisplay *display, const luxel_field *field, double *low, double *high)
{
    const luxel_statistics *statistics = luxel_field_statistics(field);
    const double maximum = statistics->maximum.exists && statistics->maximum.value > 0 ? statistics->maximum.value : 1;
    *low = display->is_locked ? display->low : 0;
    *high = display->is_locked ? display->high : maximum;
    if (display->logarithmic && !(*high > 0))
        *high = maximum;
    if (!(*high > *low))
        *high = *low >= 0 ? fmax(*low * 2, 1e-30) : 0;
    if (display->logarithmic && !(*low > 0))
        *low = *high * pow(10, -DECADES);
}

double app_range_place(const AppRange *range, double value)
{
    if (!range->logarithmic)
        return (value - range->low) / (range->high - range->low);
    return value > 0 ? log(value / range->low) / log(range->high / range->low) : -HUGE_VAL;
}

/* The ends keep a thousandth of the length between them, so that the way back is open. */
AppRange app_range_move(const AppRange *range, gboolean upper, double parts)
{
    static const double LEAST_PART = 1e-3;
    const double at = upper ? MAX(1 + parts, LEAST_PART) : MIN(parts, 1 - LEAST_PART);
    const double value = range->logarithmic ? range->low * pow(range->high / range->low, at)
                                            : range->low + at * (range->high - range->low);
    AppRange moved = *range;
    if (upper)
        moved.high = value;
    else
        moved.low = range->low >= 0 && !range->logarithmic ? MAX(value, 0) : value;
    return moved;
}

static guint32 pack(const double color[3])
{
    guint32 bytes[3];
    for (int i = 0; i < 3; i++)
        bytes[i] = (guint32)(CLAMP(color[i], 0, 1) * 255 + 0.5);
    return GUINT32_TO_LE(0xff000000u | bytes[0] << 16 | bytes[1] << 8 | bytes[2]);
}

static void fill_table(const char *palette, guint32 table[COLORS])
{
    for (int i = 0; i < COLORS; i++) {
        double color[3] = {0, 0, 0};
        luxel_palette_color(palette, (double)i / (COLORS - 1), color);
        table[i] = pack(color);
    }
}

/* The place of a value among the colours. */
typedef struct Ramp {
    float scale, shift;
    gboolean logarithmic;
} Ramp;

static Ramp ramp_of(const AppDisplay *display, double low, double high)
{
    const double gain = exp2(display->exposure);
    double scale = gain / (high - low), shift = -low / (high - low);
    if (display->logarithmic) {
        scale = 1 / log(high / low);
        shift = log(gain / low) * scale;
    }
    return (Ramp){(float)(scale * (COLORS - 1)), (float)(shift * (COLORS - 1)), display->logarithmic};
}

static inline int color_of(const Ramp *ramp, float value)
{
    if (ramp->logarithmic)
        value = value > 0 ? logf(value) : -1e30f;
    float place = value * ramp->scale + ramp->shift + 0.5f;
    place = place > 0 ? place : 0;
    place = place < COLORS - 1 ? place : COLORS - 1;
    return (int)place;
}

/* One row of values as floats, whatever the field's precision. */
static const float *row_of(const luxel_field *field, guint row, float *room)
{
    const gsize columns = luxel_field_columns(field);
    const float *single = luxel_field_single(field);
    if (single)
        return single + row * columns;
    const double *values = luxel_field_double(field) + row * columns;
    for (gsize i = 0; i < columns; i++)
        room[i] = (float)values[i];
    return room;
}

static void paint_grey(const luxel_field *field, guint32 *pixels)
{
    const gsize count = (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    guint8 *grey = (guint8 *)pixels + (BYTES - 1) * count; /* the last quarter, which is overwritten last */
    luxel_field_grey(field, grey);
    for (gsize i = 0; i < count; i++)
        pixels[i] = GUINT32_TO_LE(0xff000000u | grey[i] * 0x010101u);
}

/* The colours themselves, by the range of the grey levels. */
static void paint_srgb(const luxel_field *field, guint32 *pixels)
{
    const gsize count = (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    guint8 *levels = (guint8 *)pixels + count; /* the last three quarters, which are overwritten last */
    luxel_field_srgb(field, levels);
    for (gsize i = 0; i < count; i++)
        pixels[i] = GUINT32_TO_LE(0xff000000u | (guint32)levels[3 * i] << 16 | (guint32)levels[3 * i + 1] << 8 |
                                  levels[3 * i + 2]);
}

static void paint_colors(const AppDisplay *display, const luxel_field *field, double low, double high, guint32 *pixels)
{
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const Ramp ramp = ramp_of(display, low, high);
    guint32 table[COLORS];
    float *room = g_new(float, columns);
    fill_table(display->palette, table);
    for (guint row = 0; row < rows; row++) {
        const float *values = row_of(field, row, room);
        guint32 *line = pixels + (gsize)row * columns;
        for (guint i = 0; i < columns; i++)
            line[i] = table[color_of(&ramp, values[i])];
    }
    g_free(room);
}

static void paint_outside(const AppDisplay *display, const luxel_field *field, guint32 *pixels)
{
    const gsize count = (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    const guint8 *mask = luxel_field_mask(field);
    const guint32 background = pack(display->background);
    for (gsize i = 0; i < count; i++)
        if (!mask[i])
            pixels[i] = background;
}

void app_display_paint(const AppDisplay *display, const luxel_field *field, double low, double high, guchar *pixels)
{
    guint32 *words = (guint32 *)(void *)pixels;
    if (app_display_is_plain(display))
        (luxel_field_channels(field) > 1 ? paint_srgb : paint_grey)(field, words);
    else
        paint_colors(display, field, low, high, words);
    if (luxel_field_statistics(field)->surface_pixels < (gsize)luxel_field_columns(field) * luxel_field_rows(field))
        paint_outside(display, field, words);
}
