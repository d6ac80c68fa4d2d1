/* SPDX-License-Identifier: MIT */
/* Painting a field through a table of colours. */
#include "display.h"

#include <luxel/colour.h>
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
           display->exposure == 0 && display->channel != APP_CHANNEL_CCT;
}

luxel_field *app_display_view(const luxel_field *field, AppChannel channel)
{
    const luxel_color_view view = (luxel_color_view)(channel - APP_CHANNEL_LUMINANCE + LUXEL_VIEW_LUMINANCE);
    luxel_field *shown = NULL;
    if (channel != APP_CHANNEL_COLORS && luxel_field_channels(field) > 1)
        (void)luxel_field_of_view(field, view, NULL, &shown);
    return shown;
}

gboolean app_display_is_colored(const AppDisplay *display, const luxel_field *field)
{
    return display->channel == APP_CHANNEL_COLORS && luxel_field_channels(field) > 1 &&
           strcmp(display->palette, "grey") == 0;
}

static double channel_of(const luxel_field *field, gsize i)
{
    const float *single = luxel_field_rgb_single(field);
    return single ? (double)single[i] : luxel_field_rgb_double(field)[i];
}

void app_display_ends(const AppDisplay *display, const luxel_field *field, double ends[2])
{
    const gboolean colored = app_display_is_colored(display, field);
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const guint8 *mask = luxel_field_mask(field);
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (gsize i = 0; i < (gsize)columns * rows; i++)
        for (gsize c = 0; mask[i] && c < (colored ? 3 : 1); c++) {
            const double value = colored ? channel_of(field, 3 * i + c)
                                         : luxel_field_value(field, (guint)(i % columns), (guint)(i / columns));
            least = fmin(least, value);
            greatest = fmax(greatest, value);
        }
    ends[0] = least <= greatest ? least : 0;
    ends[1] = least <= greatest ? greatest : 0;
}

/* The range of a field by itself: from 0 to its greatest number, temperatures from the least to the greatest. */
static void own_range(const AppDisplay *display, const luxel_field *field, double range[2])
{
    const luxel_statistics *statistics = luxel_field_statistics(field);
    range[0] = 0;
    range[1] = statistics->maximum.exists && statistics->maximum.value > 0 ? statistics->maximum.value : 1;
    if (display->channel != APP_CHANNEL_CCT && !app_display_is_colored(display, field))
        return;
    double ends[2];
    app_display_ends(display, field, ends);
    if (ends[1] > 0)
        range[1] = ends[1];
    if (display->channel == APP_CHANNEL_CCT && ends[1] > 0) { /* one temperature stands in the middle */
        range[0] = ends[0] - (ends[0] < ends[1] ? 0 : 1);
        range[1] = ends[1] + (ends[0] < ends[1] ? 0 : 1);
    }
}

void app_display_range(const AppDisplay *display, const luxel_field *field, double *low, double *high)
{
    double own[2];
    own_range(display, field, own);
    *low = display->is_locked ? display->low : own[0];
    *high = display->is_locked ? display->high : own[1];
    if (display->logarithmic && !(*high > 0))
        *high = own[1];
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

void app_display_color(const AppDisplay *display, const luxel_field *field, double part, double color[3])
{
    color[0] = color[1] = color[2] = 0;
    if (!app_display_is_colored(display, field))
        luxel_palette_color(display->palette, part, color);
    else
        color[0] = color[1] = color[2] = display->logarithmic ? part : luxel_srgb_curve(part);
}

static void fill_table(const AppDisplay *display, const luxel_field *field, guint32 table[COLORS])
{
    for (int i = 0; i < COLORS; i++) {
        double color[3];
        app_display_color(display, field, (double)i / (COLORS - 1), color);
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

static const guint32 levels_of[] = {0xff0000, 0xff00, 0xff}; /* red, green, blue */

static void paint_colors(const AppDisplay *display, const luxel_field *field, double low, double high, guint32 *pixels)
{
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const Ramp ramp = ramp_of(display, low, high);
    const gboolean colored = app_display_is_colored(display, field);
    guint32 table[COLORS];
    float *room = g_new(float, columns);
    fill_table(display, field, table);
    for (gsize i = 0; colored && i < (gsize)columns * rows; i++) {
        pixels[i] = GUINT32_TO_LE(0xff000000u);
        for (gsize c = 0; c < 3; c++)
            pixels[i] |= table[color_of(&ramp, (float)channel_of(field, 3 * i + c))] & GUINT32_TO_LE(levels_of[c]);
    }
    for (guint row = 0; !colored && row < rows; row++) {
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
