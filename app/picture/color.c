/* SPDX-License-Identifier: MIT */
/* Colours in words; numbers have as many digits as `luxel probe` prints of them. */
#include "color.h"

#include <math.h>

#include "../../front/words.h"
#include "../base/number.h"

enum { DIGITS = 6, PARTS = 5 /* digits behind the point of x and y */, NEAR = 4 /* and of Duv */ };

static const char *const names[] = {"R", "G", "B"};

luxel_color app_color_mean(const luxel_field *field)
{
    const gsize pixels = (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    const float *single = luxel_field_rgb_single(field);
    const double *exact = luxel_field_rgb_double(field);
    const guint8 *mask = luxel_field_mask(field);
    luxel_color mean = {.exists = FALSE};
    gsize count = 0;
    for (gsize i = 0; i < pixels && (single || exact); i++) {
        count += mask[i];
        for (gsize c = 0; c < G_N_ELEMENTS(names) && mask[i]; c++)
            mean.rgb[c] += single ? (double)single[3 * i + c] : exact[3 * i + c];
    }
    mean.exists = count > 0;
    for (gsize c = 0; c < G_N_ELEMENTS(names) && mean.exists; c++)
        mean.rgb[c] /= (double)count;
    return mean;
}

double app_color_number(const luxel_color *color, double value, AppChannel channel)
{
    luxel_chromaticity seen;
    if (!color->exists || channel <= APP_CHANNEL_LUMINANCE)
        return value;
    if (channel != APP_CHANNEL_CCT)
        return color->rgb[channel - APP_CHANNEL_RED];
    luxel_find_chromaticity(color->rgb, &seen);
    return seen.has_cct ? seen.cct_k : (double)NAN;
}

char *app_color_channels(const luxel_color *color)
{
    GString *text = g_string_new("R, G, B ");
    char number[APP_NUMBER_SIZE];
    for (gsize c = 0; c < G_N_ELEMENTS(names); c++)
        g_string_append_printf(text, "%s%s", c ? app_number_separator() : "",
                               app_number_show(color->rgb[c], DIGITS, number));
    return g_string_free(text, FALSE);
}

char *app_color_bounds(const luxel_color *color)
{
    GString *text = g_string_new(NULL);
    char amount[APP_AMOUNT_SIZE];
    for (gsize c = 0; c < G_N_ELEMENTS(names); c++)
        g_string_append_printf(text, "%s%s %s", c ? "\n" : "", names[c],
                               app_amount_write(color->rgb[c], color->error[c], amount));
    return g_string_free(text, FALSE);
}

/* A number with so many digits behind the mark. */
static const char *write_fixed(double number, int digits, char text[APP_NUMBER_SIZE])
{
    char form[8];
    g_snprintf(form, sizeof form, "%%.%df", digits);
    const double least = 0.5 * pow(10, -digits);
    g_ascii_formatd(text, APP_NUMBER_SIZE, form, fabs(number) < least ? 0 : number); /* and never "-0.0000" */
    return app_number_mark(text);
}

char *app_color_place(const luxel_color *color)
{
    luxel_chromaticity seen;
    char x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    luxel_find_chromaticity(color->rgb, &seen);
    return seen.has_xy ? g_strdup_printf("x, y %s%s%s", write_fixed(seen.xy[0], PARTS, x), app_number_separator(),
                                         write_fixed(seen.xy[1], PARTS, y))
                       : g_strdup("");
}

char *app_color_temperature(const luxel_color *color)
{
    luxel_chromaticity seen;
    char kelvin[APP_NUMBER_SIZE], duv[APP_NUMBER_SIZE];
    luxel_find_chromaticity(color->rgb, &seen);
    if (!seen.has_xy)
        return g_strdup("");
    return seen.has_cct ? g_strdup_printf(_("%s K, Duv %s"), write_fixed(seen.cct_k, 0, kelvin),
                                          write_fixed(seen.duv, NEAR, duv))
                        : g_strdup(_("no colour temperature"));
}
