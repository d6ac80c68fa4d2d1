/* SPDX-License-Identifier: MIT */
/* The map of a figure: the picture in its colours, outlines, isophotes, and their labels and marks over them. */
#include <math.h>

#include "labels.h"
#include "thin.h"

static const double LINE = 0.1; /* widths of lines, of the letters' size */

/* The ground of what shows no surface: near the paper's, so that the surface stands out. */
void lx_empty_color(const struct lx_canvas *canvas, double color[3])
{
    for (int i = 0; i < 3; i++)
        color[i] = 0.92 * canvas->ground[i] + 0.08 * canvas->ink[i];
}

double lx_lightness(const double color[3])
{
    return 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2];
}

bool lx_shows_maximum(const struct lx_figure *figure)
{
    const luxel_peak *peak = &figure->extrema.maximum;
    return figure->settings.extrema && peak->exists && peak->value > 0 && peak->place != LUXEL_PEAK_PLATEAU;
}

/* ---- the picture ---- */

double lx_shown_value(const struct lx_figure *figure, double value)
{
    double below = figure->scale.low, above = figure->scale.high;
    if (figure->settings.bands != LUXEL_BANDS_STEPS)
        return value;
    for (size_t i = 0; i < figure->level_count; i++) {
        if (figure->levels[i] <= value)
            below = fmax(below, figure->levels[i]);
        else
            above = fmin(above, figure->levels[i]);
    }
    return figure->scale.logarithmic ? sqrt(below * above) : (below + above) / 2;
}

/*
 * The sample that a pixel shows: its own, or, off the surfaces, that of the nearest pixel at most two away, because a
 * surface whose edge runs through the pixel is drawn to that edge; false where there is none.
 */
static bool find_sample(const uint8_t *mask, unsigned columns, unsigned rows, unsigned column, unsigned row,
                        size_t *sample)
{
    static const signed char around[][2] = {{0, 0},  {1, 0},   {-1, 0},  {0, 1},  {0, -1}, {1, 1},  {-1, 1},
                                            {1, -1}, {-1, -1}, {2, 0},   {-2, 0}, {0, 2},  {0, -2}, {2, 1},
                                            {2, -1}, {-2, 1},  {-2, -1}, {1, 2},  {-1, 2}, {1, -2}, {-1, -2},
                                            {2, 2},  {-2, 2},  {2, -2},  {-2, -2}};
    for (size_t i = 0; i < sizeof around / sizeof around[0]; i++) {
        long u = (long)column + around[i][0], v = (long)row + around[i][1];
        if (u < 0 || v < 0 || u >= (long)columns || v >= (long)rows)
            continue;
        *sample = (size_t)v * columns + (size_t)u;
        if (mask[*sample])
            return true;
    }
    return false;
}

static cairo_surface_t *make_image(const struct lx_figure *figure, const struct lx_canvas *canvas)
{
    unsigned columns = luxel_field_columns(figure->field), rows = luxel_field_rows(figure->field);
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)columns, (int)rows);
    const uint8_t *mask = luxel_field_mask(figure->field);
    if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS)
        return image;
    unsigned char *pixels = cairo_image_surface_get_data(image);
    size_t stride = (size_t)cairo_image_surface_get_stride(image);
    for (unsigned row = 0; row < rows; row++) {
        uint32_t *line = (uint32_t *)(void *)(pixels + row * stride);
        for (unsigned column = 0; column < columns; column++) {
            double color[3];
            size_t sample;
            lx_empty_color(canvas, color);
            if (find_sample(mask, columns, rows, column, row, &sample)) {
                double value =
                    luxel_field_value(figure->field, (unsigned)(sample % columns), (unsigned)(sample / columns));
                lx_figure_color(figure, lx_shown_value(figure, value), color);
            }
            line[column] = (uint32_t)lround(255 * color[0]) << 16 | (uint32_t)lround(255 * color[1]) << 8 |
                           (uint32_t)lround(255 * color[2]);
        }
    }
    cairo_surface_mark_dirty(image);
    return image;
}

/* Each sample in the middle of its square; those on the screen's edges reach beyond and are clipped. */
static void draw_image(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    cairo_surface_t *image = make_image(figure, canvas);
    const double *x = luxel_field_x_mm(figure->field), *y = luxel_field_y_mm(figure->field);
    unsigned columns = luxel_field_columns(figure->field), rows = luxel_field_rows(figure->field);
    /* pixels are squares, cells of a plane need not be */
    double wide = columns > 1 ? x[1] - x[0] : rows > 1 && !figure->plane ? y[0] - y[1] : figure->size_mm[0];
    double high = rows > 1 ? y[0] - y[1] : figure->plane ? figure->size_mm[1] : wide;
    double left = lx_plot_x(plot, x[0] - wide / 2), right = lx_plot_x(plot, x[columns - 1] + wide / 2);
    double top = lx_plot_y(plot, y[0] + high / 2), bottom = lx_plot_y(plot, y[rows - 1] - high / 2);
    cairo_t *cairo = canvas->cairo;
    cairo_save(cairo);
    cairo_translate(cairo, left, top);
    cairo_scale(cairo, (right - left) / columns, (bottom - top) / rows);
    cairo_set_source_surface(cairo, image, 0, 0);
    /* squares when they are enlarged, as pixels are data, and what lies between the cells of a plane; means when they
     * are made smaller */
    double dots = 1, unused = 0;
    const bool is_even = figure->plane && figure->settings.bands != LUXEL_BANDS_STEPS;
    cairo_user_to_device_distance(cairo, &dots, &unused);
    cairo_pattern_set_extend(cairo_get_source(cairo), is_even ? CAIRO_EXTEND_PAD : CAIRO_EXTEND_NONE);
    cairo_pattern_set_filter(cairo_get_source(cairo), fabs(dots) < 0.9 ? CAIRO_FILTER_GOOD
                                                      : is_even        ? CAIRO_FILTER_BILINEAR
                                                                       : CAIRO_FILTER_NEAREST);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
}

/* The surfaces within their contours, on the ground of what shows none. */
static void draw_surfaces(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    cairo_t *cairo = canvas->cairo;
    double color[3];
    lx_empty_color(canvas, color);
    lx_color(canvas, color, 1);
    cairo_paint(cairo);
    cairo_save(cairo);
    for (size_t i = 0; i < figure->contour_count; i++) {
        const struct lx_figure_outline *contour = &figure->contours[i];
        cairo_new_sub_path(cairo);
        for (size_t k = 0; k < contour->count; k++)
            cairo_line_to(cairo, lx_plot_x(plot, contour->places_mm[k][0]), lx_plot_y(plot, contour->places_mm[k][1]));
        cairo_close_path(cairo);
    }
    cairo_clip(cairo);
    lx_color(canvas, canvas->ground, 1);
    if (figure->settings.bands == LUXEL_BANDS_LINES)
        cairo_paint(cairo);
    else
        draw_image(figure, canvas, plot);
    cairo_restore(cairo);
}

/* ---- lines ---- */

/* What stands out from the colour of a value: its own colour on paper, else ink or paper. */
void lx_line_color(const struct lx_figure *figure, const struct lx_canvas *canvas, double value, double color[3])
{
    lx_figure_color(figure, value, color);
    double lightness = lx_lightness(color), ground = lx_lightness(canvas->ground);
    for (int i = 0; i < 3; i++) {
        if (figure->settings.bands != LUXEL_BANDS_LINES)
            color[i] = lightness < 0.5 ? 0.97 : 0.08;
        else if (ground > 0.5)
            color[i] *= lightness > 0.7 ? 0.7 / lightness : 1;
        else
            color[i] = lightness < 0.5 ? 1 - (1 - color[i]) * 0.5 / (1 - lightness) : color[i];
    }
}

static void draw_lines(const struct lx_labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const struct lx_plot *plot = labels->plot;
    cairo_t *cairo = labels->canvas->cairo;
    bool alone = figure->settings.bands == LUXEL_BANDS_LINES, bands = figure->settings.bands == LUXEL_BANDS_STEPS;
    cairo_save(cairo);
    lx_clip_labels(labels);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, (alone ? 1.3 : bands ? 0.6 : 0.9) * LINE * plot->size);
    struct lx_thinning thinning = {0};
    uint16_t level = 0;
    lx_thinning_begin(&thinning, &plot->box);
    /* level by level, the greatest first, as the lower ones are left out where there is no room for all */
    for (size_t i = figure->isophotes ? figure->isophotes->count : 0; i-- > 0;) {
        const luxel_isophote *line = &figure->isophotes->lines[i];
        double color[3];
        lx_line_color(figure, labels->canvas, line->level, color);
        lx_color(labels->canvas, color, alone ? 1 : bands ? 0.5 : 0.75);
        if (i + 1 < figure->isophotes->count && line[1].level != line->level)
            level++;
        lx_thinning_add_line(&thinning, cairo, plot, line, level);
        cairo_stroke(cairo);
    }
    lx_thinning_clear(&thinning);
    cairo_restore(cairo);
}

static void draw_outlines(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    lx_color(canvas, canvas->ink, 1);
    cairo_set_line_width(canvas->cairo, LINE * plot->size);
    cairo_set_line_join(canvas->cairo, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; i < figure->outline_count; i++) {
        const struct lx_figure_outline *outline = &figure->outlines[i];
        for (size_t k = 0; k < outline->count; k++)
            cairo_line_to(canvas->cairo, lx_plot_x(plot, outline->places_mm[k][0]),
                          lx_plot_y(plot, outline->places_mm[k][1]));
        cairo_stroke(canvas->cairo);
    }
}

/* Where the sections go through the map. */
static void draw_section_lines(const struct lx_figure *figure, const struct lx_canvas *canvas,
                               const struct lx_plot *plot)
{
    const double dashes[] = {0.6 * plot->size, 0.4 * plot->size};
    const struct lx_pane *box = &plot->box;
    double x = lx_plot_x(plot, figure->section_mm[0]), y = lx_plot_y(plot, figure->section_mm[1]);
    if (!figure->sections[0])
        return;
    cairo_set_dash(canvas->cairo, dashes, 2, 0);
    cairo_set_line_width(canvas->cairo, 0.8 * LINE * plot->size);
    lx_color(canvas, (const double[]){0.5, 0.5, 0.5}, 0.9);
    cairo_move_to(canvas->cairo, box->x, y);
    cairo_line_to(canvas->cairo, box->x + box->width, y);
    cairo_move_to(canvas->cairo, x, box->y);
    cairo_line_to(canvas->cairo, x, box->y + box->height);
    cairo_stroke(canvas->cairo);
    cairo_set_dash(canvas->cairo, NULL, 0, 0);
}

void lx_draw_map(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    lx_place_labels(figure->labels, figure, canvas, plot);
    cairo_save(canvas->cairo);
    cairo_rectangle(canvas->cairo, plot->box.x, plot->box.y, plot->box.width, plot->box.height);
    cairo_clip(canvas->cairo);
    draw_surfaces(figure, canvas, plot);
    draw_section_lines(figure, canvas, plot);
    draw_lines(figure->labels);
    draw_outlines(figure, canvas, plot);
    lx_draw_labels(figure->labels);
    cairo_restore(canvas->cairo);
}
