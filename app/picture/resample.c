/* SPDX-License-Identifier: MIT */
/* Columns and rows are prepared once, each as the two old ones between which it lies; then pixels are plain work. */
#include "resample.h"

#include <math.h>

enum { UNIT = 256, MOST_SAMPLES = 8, SQUARES_FROM = 4 };

/* Where one sample lies among the old columns or rows: so much of `second`, the rest of `first`, of UNIT. */
typedef struct Tap {
    guint first, second;
    guint32 weight;
} Tap;

/* One direction: `samples` taps for each new pixel. */
typedef struct Axis {
    Tap *taps;
    guint count, samples;
    double low, high; /* in dots */
} Axis;

AppArea app_area_of(const luxel_field *field)
{
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    double dx = columns > 1 ? (x[columns - 1] - x[0]) / (columns - 1) : 0;
    double dy = rows > 1 ? (y[0] - y[rows - 1]) / (rows - 1) : dx;
    dy = dy > 0 ? dy : 1;
    dx = dx > 0 ? dx : dy;
    return (AppArea){.low = {x[0] - dx / 2, y[rows - 1] - dy / 2}, .high = {x[columns - 1] + dx / 2, y[0] + dy / 2}};
}

/* From `from` to `to` dots lie `count` old pixels; the new ones are the whole dots of them within the view's `size`. */
static gboolean prepare(Axis *axis, double from, double to, guint count, int size, gboolean smooth)
{
    const double dot = count / (to - from); /* old pixels for a dot */
    axis->low = MAX(round(from), 0);
    axis->high = MIN(round(to), size);
    if (!(axis->high - axis->low >= 1) || !isfinite(dot))
        return FALSE;
    axis->count = (guint)(axis->high - axis->low);
    axis->samples = (guint)CLAMP(ceil(dot - 1e-6), 1, MOST_SAMPLES);
    axis->taps = g_new(Tap, (gsize)axis->count * axis->samples);
    for (gsize i = 0; i < (gsize)axis->count * axis->samples; i++) {
        const double at = axis->low + ((double)i + 0.5) / axis->samples;
        const double place = CLAMP((at - from) * dot - 0.5, 0, count - 1.0);
        /* to the nearest part, so that a frame that is not quite round still gives a copy, and squares */
        const gboolean whole = (dot * SQUARES_FROM <= 1 + 1e-9 && !smooth) || axis->samples > 1;
        const guint64 parts = (guint64)(whole ? floor(place + 0.5) * UNIT : floor(place * UNIT + 0.5));
        const guint first = (guint)(parts / UNIT);
        axis->taps[i] = (Tap){first, MIN(first + 1, count - 1), (guint32)(parts % UNIT)};
    }
    return TRUE;
}

/* Two bytes at a time, which leave room for each other. */
static inline guint32 blend(guint32 a, guint32 b, guint32 weight)
{
    const guint32 mask = 0x00ff00ff;
    const guint32 low = ((a & mask) * (UNIT - weight) + (b & mask) * weight) >> 8 & mask;
    const guint32 high = ((a >> 8 & mask) * (UNIT - weight) + (b >> 8 & mask) * weight) & ~mask;
    return low | high;
}

static inline guint32 sample(const guint32 *upper, const guint32 *lower, const Tap *across, guint32 down)
{
    const guint32 above = blend(upper[across->first], upper[across->second], across->weight);
    const guint32 below = blend(lower[across->first], lower[across->second], across->weight);
    return blend(above, below, down);
}

/* One new row with one sample for each pixel. */
static void blend_row(const guint32 *old, guint width, const Axis *x, const Tap *down, guint32 *row)
{
    const guint32 *upper = old + (gsize)down->first * width, *lower = old + (gsize)down->second * width;
    for (guint i = 0; i < x->count; i++)
        row[i] = sample(upper, lower, &x->taps[i], down->weight);
}

/* One new row whose pixels are averages of the old ones that are nearest to their samples. */
static void average_row(const guint32 *old, guint width, const Axis *x, const Axis *y, const Tap *down, guint32 *row)
{
    const guint32 mask = 0x00ff00ff, number = x->samples * y->samples;
    const guint32 share = (1 << 16) / number, half = 1 << 15; /* of a sum of at most 64 bytes */
    for (guint i = 0; i < x->count; i++) {
        const Tap *across = x->taps + i * x->samples;
        guint32 low = 0, high = 0; /* 14 bits each at most */
        for (guint v = 0; v < y->samples; v++) {
            const guint32 *line = old + (gsize)down[v].first * width;
            for (guint u = 0; u < x->samples; u++) {
                const guint32 found = line[across[u].first];
                low += found & mask;
                high += found >> 8 & mask;
            }
        }
        row[i] = ((low & 0xffff) * share + half) >> 16 | ((low >> 16) * share + half) >> 16 << 16 |
                 ((high & 0xffff) * share + half) >> 16 << 8 | ((high >> 16) * share + half) >> 16 << 24;
    }
}

guchar *app_resample(const guchar *pixels, const luxel_field *field, const AppFrame *frame, gboolean smooth,
                     guint *columns, guint *rows, AppArea *area)
{
    const guint32 *old = (const guint32 *)(const void *)pixels;
    const guint width = luxel_field_columns(field);
    const AppArea all = app_area_of(field);
    Axis x = {0}, y = {0};
    guint32 *made = NULL;
    if (prepare(&x, frame->origin[0] + all.low[0] * frame->scale, frame->origin[0] + all.high[0] * frame->scale, width,
                frame->width, smooth) &&
        prepare(&y, frame->origin[1] - all.high[1] * frame->scale, frame->origin[1] - all.low[1] * frame->scale,
                luxel_field_rows(field), frame->height, smooth)) {
        made = g_new(guint32, (gsize)x.count * y.count);
        for (guint row = 0; row < y.count; row++) {
            const Tap *down = y.taps + (gsize)row * y.samples;
            if (x.samples == 1 && y.samples == 1)
                blend_row(old, width, &x, down, made + (gsize)row * x.count);
            else
                average_row(old, width, &x, &y, down, made + (gsize)row * x.count);
        }
        *columns = x.count;
        *rows = y.count;
        *area = (AppArea){{(x.low - frame->origin[0]) / frame->scale, (frame->origin[1] - y.high) / frame->scale},
                          {(x.high - frame->origin[0]) / frame->scale, (frame->origin[1] - y.low) / frame->scale}};
    }
    g_free(x.taps);
    g_free(y.taps);
    return (guchar *)made;
}
