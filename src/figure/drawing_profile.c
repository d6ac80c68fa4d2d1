/* SPDX-License-Identifier: MIT */
/* Profiles on the caller's context: curves in their axes, a legend below, and a marker. */
#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "drawing.h"

/* A profile as it is drawn. */
struct drawing {
    struct lx_curves curves;
    struct lx_legend legend;
    struct lx_plot plot;
    const char *x_label, *y_label;
    size_t *lights; /* those that are drawn, and their names */
    const char **names;
};

void luxel_profile_style_init(luxel_profile_style *how)
{
    *how = (luxel_profile_style){.low = (double)NAN, .high = (double)NAN, .marker = (double)NAN};
}

static const char *word(const luxel_language *language, const char *english)
{
    return language && language->translate ? language->translate(english, language->data) : english;
}

static const char *way_word(const luxel_profile *profile, luxel_profile_along along)
{
    switch (along) {
    case LUXEL_ALONG_X: return LX_N("x, mm");
    case LUXEL_ALONG_Y: return LX_N("y, mm");
    default: return profile->type == LUXEL_PATH_ARC ? LX_N("angle, degrees") : LX_N("distance, mm");
    }
}

static void choose_labels(const luxel_drawing_style *style, const luxel_profile *profile,
                          const luxel_profile_style *how, struct drawing *drawing)
{
    drawing->x_label = how->x_label ? how->x_label : word(style->language, way_word(profile, how->along));
    drawing->y_label = how->y_label;
    if (!drawing->y_label)
        drawing->y_label = word(style->language, profile->quantity_word);
    drawing->legend.whole = word(style->language, LX_N("all together"));
}

/* The lights that have a name, or all; 0, or -1 when out of memory. */
static int choose_lights(const luxel_profile *profile, const luxel_profile_style *how, struct drawing *drawing)
{
    size_t lights = profile->shares ? profile->lights : 0, count = 0;
    drawing->lights = lx_new_array(lights + 1, sizeof *drawing->lights);
    drawing->names = lx_new_array(lights + 1, sizeof *drawing->names);
    if (!drawing->lights || !drawing->names)
        return -1;
    for (size_t i = 0; i < lights; i++) {
        if (how->names && !how->names[i])
            continue;
        drawing->lights[count] = i;
        drawing->names[count++] = how->names ? how->names[i] : "";
    }
    drawing->curves.lights = drawing->lights;
    drawing->curves.light_count = count;
    drawing->legend.names = drawing->names;
    drawing->legend.count = how->names ? count : 0;
    return 0;
}

/* From the one end of the way to the other, whichever is less. */
static void choose_x(struct drawing *drawing)
{
    double first = lx_curves_place(&drawing->curves, 0);
    double last = lx_curves_place(&drawing->curves, drawing->curves.profile->count - 1);
    drawing->plot.x = (struct lx_scale){.low = fmin(first, last), .high = fmax(first, last)};
}

/* What is not given follows from the values. */
static void choose_y(const luxel_profile_style *how, struct drawing *drawing)
{
    const luxel_profile *profile = drawing->curves.profile;
    struct lx_scale *scale = &drawing->plot.y;
    double most = 0, least = HUGE_VAL;
    for (size_t i = 0; i < profile->count; i++) {
        const luxel_profile_sample *sample = &profile->samples[i];
        if (!sample->has_value)
            continue;
        most = fmax(most, sample->value);
        least = sample->value > 0 ? fmin(least, sample->value) : least;
    }
    /* sums are areas, which begin at 0 */
    scale->logarithmic = how->logarithmic && !how->stacked && (how->high > 0 || (isnan(how->high) && most > 0));
    scale->high = how->high;
    if (isnan(scale->high))
        scale->high = most > 0 ? (scale->logarithmic ? 1.3 : 1.06) * most : 1;
    scale->low = how->low;
    if (isnan(scale->low)) /* by powers, a decade and a half at least: shares are less than the sums */
        scale->low = scale->logarithmic ? fmax(1e-4 * scale->high, fmin(least / 1.3, scale->high / 30))
                                        : fmin(0, scale->high - 1);
    if (isnan(how->high) && scale->high <= scale->low) /* all values are below what is asked for */
        scale->high = scale->logarithmic ? 10 * scale->low : scale->low + fmax(1, fabs(scale->low));
}

/* A dashed line at a place, and a dot where it meets the sum. */
static void draw_marker(const struct drawing *drawing, const struct lx_canvas *canvas, double marker)
{
    const struct lx_plot *plot = &drawing->plot;
    const luxel_profile_sample *samples = drawing->curves.profile->samples;
    const double dashes[] = {0.5 * plot->size, 0.3 * plot->size};
    cairo_t *cairo = canvas->cairo;
    double x = lx_plot_x(plot, marker);
    if (!(marker >= plot->x.low && marker <= plot->x.high))
        return;
    cairo_set_dash(cairo, dashes, 2, 0);
    cairo_set_line_width(cairo, 0.1 * plot->size);
    lx_color(canvas, canvas->ink, 0.6);
    cairo_move_to(cairo, x, plot->box.y);
    cairo_line_to(cairo, x, plot->box.y + plot->box.height);
    cairo_stroke(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
    for (size_t i = 0; i + 1 < drawing->curves.profile->count; i++) {
        double from = lx_curves_place(&drawing->curves, i), to = lx_curves_place(&drawing->curves, i + 1);
        double share = (marker - from) / (to - from);
        if (!(share >= 0 && share <= 1) || !samples[i].has_value || !samples[i + 1].has_value)
            continue;
        double value = samples[i].value * (1 - share) + samples[i + 1].value * share;
        double y = lx_plot_y(plot, value);
        if (!(y >= plot->box.y && y <= plot->box.y + plot->box.height))
            return;
        cairo_arc(cairo, x, y, 0.4 * plot->size, 0, 2 * M_PI);
        lx_color(canvas, canvas->ink, 1);
        cairo_fill_preserve(cairo);
        lx_color(canvas, canvas->ground, 1);
        cairo_stroke(cairo);
        return;
    }
}

/* Fits the plot into its rectangle, above the legend, of which *legend is the height, where that leaves room for it;
 * false: there is none for the plot either. */
static bool lay_out(struct drawing *drawing, const struct lx_canvas *canvas, double width, double height,
                    double *legend)
{
    const double size = drawing->plot.size;
    const double least = 5 * size; /* of the plot, that a legend must leave */
    const struct lx_pane below = {.x = 0.3 * size, .width = width - 0.6 * size};
    struct lx_plot *plot = &drawing->plot;
    *legend = lx_draw_legend(&drawing->legend, canvas, &below, size, false);
    plot->box = (struct lx_pane){.width = width, .height = height - *legend - (*legend > 0 ? 0.4 * size : 0)};
    bool fits = plot->box.height > 0 && lx_fit_plot(canvas, plot, drawing->x_label, drawing->y_label);
    if (*legend > 0 && (!fits || plot->box.height < least)) {
        *legend = 0;
        plot->box = (struct lx_pane){.width = width, .height = height};
        fits = lx_fit_plot(canvas, plot, drawing->x_label, drawing->y_label);
    }
    return fits;
}

static void draw(struct drawing *drawing, const struct lx_canvas *canvas, double width, double height, double marker)
{
    const double size = drawing->plot.size;
    double legend;
    if (!lay_out(drawing, canvas, width, height, &legend))
        return;
    lx_draw_axes(canvas, &drawing->plot, drawing->x_label, drawing->y_label, true);
    lx_draw_curves(&drawing->curves, canvas, &drawing->plot);
    draw_marker(drawing, canvas, marker);
    const struct lx_pane below = {.x = 0.3 * size, .y = height - legend, .width = width - 0.6 * size};
    if (legend > 0)
        lx_draw_legend(&drawing->legend, canvas, &below, size, true);
}

/* False: the profile cannot be drawn. */
static bool begin(const luxel_drawing_style *style, const luxel_profile *profile, const luxel_profile_style *how,
                  struct drawing *drawing)
{
    static const enum lx_along ways[] = {LX_ALONG_WAY, LX_ALONG_X, LX_ALONG_Y};
    if (!profile || !profile->samples || profile->count < 2 || how->along > LUXEL_ALONG_Y ||
        LX_CHECK_RESERVE(how, NULL) != LUXEL_OK)
        return false;
    *drawing = (struct drawing){
        .curves = {.profile = profile, .along = ways[how->along], .stacked = how->stacked},
        .legend.stacked = how->stacked,
        .plot.size = style->letters,
    };
    choose_x(drawing);
    choose_y(how, drawing);
    return lx_scale_goes(&drawing->plot.x) && lx_scale_goes(&drawing->plot.y);
}

static void end(struct drawing *drawing)
{
    free(drawing->lights);
    free(drawing->names);
}

luxel_status luxel_draw_profile(cairo_t *cairo, const luxel_drawing_style *style, const luxel_profile *profile,
                                const luxel_profile_style *how, double width, double height)
{
    luxel_profile_style defaults;
    struct drawing drawing;
    luxel_profile_style_init(&defaults);
    how = how ? how : &defaults;
    if (!lx_can_draw(cairo, style, width, height) || !begin(style, profile, how, &drawing))
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (choose_lights(profile, how, &drawing) == 0) {
        struct lx_canvas canvas = lx_drawing_begin(cairo, style, width, height);
        choose_labels(style, profile, how, &drawing);
        draw(&drawing, &canvas, width, height, how->marker);
        status = lx_drawing_end(&canvas);
    }
    end(&drawing);
    return status;
}

luxel_status luxel_profile_frame(const luxel_drawing_style *style, const luxel_profile *profile,
                                 const luxel_profile_style *how, double width, double height, luxel_plot_frame *frame)
{
    luxel_profile_style defaults;
    struct drawing drawing;
    double legend;
    luxel_profile_style_init(&defaults);
    how = how ? how : &defaults;
    if (!lx_can_measure(style, width, height) || !frame || !begin(style, profile, how, &drawing))
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (choose_lights(profile, how, &drawing) == 0) {
        struct lx_canvas canvas = lx_measuring_begin(style, width, height);
        choose_labels(style, profile, how, &drawing);
        const bool fits = lay_out(&drawing, &canvas, width, height, &legend);
        *frame = lx_frame_of(&drawing.plot, fits);
        status = lx_measuring_end(&canvas);
    }
    end(&drawing);
    return status;
}
