/* SPDX-License-Identifier: MIT */
/* Colour: which channel of a picture is shown, the levels and channels of its pixels, and the colour of a value. */
#include <math.h>

#include "answer.h"
#include "core.h"

/* The view of pictures in colour from now on: of the luminance (0), a channel or the colour temperature. */
PAGE_CALLS(page_view) void page_view(int view)
{
    core.view = (luxel_color_view)view;
}

luxel_field *viewed(luxel_field *field)
{
    luxel_field *shown = NULL;
    if (core.view == LUXEL_VIEW_LUMINANCE || luxel_field_channels(field) == 1 ||
        luxel_field_of_view(field, core.view, fresh_diagnostics(), &shown) != LUXEL_OK)
        return field;
    luxel_field_free(field);
    return shown;
}

/* The channels of the last picture, 3 for each pixel; NULL: it is grey. */
PAGE_CALLS(page_rgb) const float *page_rgb(void)
{
    return core.field ? luxel_field_rgb_single(core.field) : NULL;
}

/* The levels of the picture's file, 3 for each pixel. */
PAGE_CALLS(page_srgb) int page_srgb(uint8_t *levels)
{
    if (core.field)
        (void)luxel_field_srgb(core.field, levels);
    return core.field != NULL;
}

/* What channels mean. */
static void answer_chromaticity(const double rgb[3])
{
    luxel_chromaticity found;
    luxel_find_chromaticity(rgb, &found);
    answer_key("xy");
    answer_numbers(found.has_xy ? found.xy : NULL, 2);
    answer_key("cct");
    answer_number(found.has_cct ? found.cct_k : (double)NAN);
    answer_key("duv");
    answer_number(found.has_cct ? found.duv : (double)NAN);
}

/* The colour of the exact value at a point of the screen, with bounds; NULL: the scene is grey, or nothing is there. */
PAGE_CALLS(page_color) const char *page_color(double x_mm, double y_mm)
{
    luxel_settings settings = present_settings();
    const luxel_scene *scene = computed_scene();
    luxel_probe *probe = NULL;
    settings.skip_reflected_pixels = true;
    if (!luxel_scene_has_color(scene) ||
        luxel_probe_screen(scene, &settings, x_mm, y_mm, fresh_diagnostics(), &probe) != LUXEL_OK)
        return NULL;
    const bool exists = probe->color.exists;
    answer_begin();
    if (exists) {
        answer_open('{');
        answer_key("rgb");
        answer_numbers(probe->color.rgb, 3);
        answer_key("error");
        answer_numbers(probe->color.error, 3);
        answer_chromaticity(probe->color.rgb);
        answer_close('}');
    }
    luxel_probe_free(probe);
    return exists ? answer_text() : NULL;
}

/* The channels of all lights at luminance 1. */
PAGE_CALLS(page_light_colors) const char *page_light_colors(void)
{
    double rgb[3];
    answer_begin();
    answer_open('[');
    for (size_t i = 0; core.scene && luxel_scene_light_rgb(core.scene, i, rgb) == LUXEL_OK; i++)
        answer_numbers(rgb, 3);
    answer_close(']');
    return answer_text();
}

/* The channels at luminance 1 of a black body of a temperature. */
PAGE_CALLS(page_black_body) const char *page_black_body(double kelvin)
{
    double xy[2], rgb[3];
    luxel_planck_xy(kelvin, xy);
    luxel_xy_to_rgb(xy, rgb);
    answer_begin();
    answer_numbers(rgb, 3);
    return answer_text();
}
