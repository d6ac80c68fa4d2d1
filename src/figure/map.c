/* SPDX-License-Identifier: MIT */
/* The map of a figure: the picture in its colours, outlines, isophotes with their labels, and marks. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "figure.h"

static const double LINE = 0.1;   /* widths of lines, of the letters' size */
static const double LABEL = 0.85; /* size of labels in the map */

enum { MARK_TEXT = 48 };

/* A mark or a text of the map, placed before anything is drawn. */
struct mark {
    enum { TEXT, RING, CROSS } type;
    char text[MARK_TEXT];
    double x, y, across, down, angle;
    double color[3], halo[3];
    bool bold;
    struct lx_box gap; /* of a label on a line: the line's room that it takes; no width: none */
};

/* All of them, with the boxes that they take, so that nothing covers anything else. */
struct labels {
    const struct lx_figure *figure;
    const struct lx_canvas *canvas;
    const struct lx_plot *plot;
    struct lx_box boxes[LX_MOST_BOXES];
    size_t count;
    struct mark marks[LX_MOST_BOXES];
    size_t mark_count;
};

static struct mark *add_mark(struct labels *labels, double x, double y, const double color[3], const double halo[3])
{
    /* more than there is room for replace the last one */
    labels->mark_count += labels->mark_count < LX_MOST_BOXES;
    struct mark *mark = &labels->marks[labels->mark_count - 1];
    *mark = (struct mark){.x = x, .y = y};
    memcpy(mark->color, color, sizeof mark->color);
    memcpy(mark->halo, halo, sizeof mark->halo);
    return mark;
}

static bool fits(const struct labels *labels, const struct lx_box *box)
{
    const struct lx_box *map = &labels->plot->box;
    if (box->x < map->x || box->y < map->y || box->x + box->width > map->x + map->width ||
        box->y + box->height > map->y + map->height || labels->count == LX_MOST_BOXES)
        return false;
    for (size_t i = 0; i < labels->count; i++)
        if (lx_boxes_meet(box, &labels->boxes[i]))
            return false;
    return true;
}

/* The ground of what shows no surface: near the paper's, so that the surface stands out. */
static void empty_color(const struct lx_canvas *canvas, double color[3])
{
    for (int i = 0; i < 3; i++)
        color[i] = 0.9 * canvas->ground[i] + 0.1 * canvas->ink[i];
}

/* ---- the picture ---- */

/* The value as it is shown: of its band the middle, where there are bands. */
static double shown_value(const struct lx_figure *figure, double value)
{
    double below = figure->scale.low, above = figure->scale.high;
    if (figure->settings.bands != LUXEL_BANDS)
        return value;
    for (size_t i = 0; i < figure->level_count; i++) {
        if (figure->levels[i] <= value)
            below = fmax(below, figure->levels[i]);
        else
            above = fmin(above, figure->levels[i]);
    }
    return figure->scale.logarithmic ? sqrt(below * above) : (below + above) / 2;
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
            if (mask[(size_t)row * columns + column] && figure->settings.bands != LUXEL_LINES)
                lx_figure_color(figure, shown_value(figure, luxel_field_value(figure->field, column, row)), color);
            else if (mask[(size_t)row * columns + column])
                memcpy(color, canvas->ground, sizeof color);
            else
                empty_color(canvas, color);
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
    const struct lx_screen *screen = &figure->scene->screen;
    double side = columns > 1 ? x[1] - x[0] : rows > 1 ? y[0] - y[1] : screen->width_mm;
    double left = lx_plot_x(plot, x[0] - side / 2), right = lx_plot_x(plot, x[columns - 1] + side / 2);
    double top = lx_plot_y(plot, y[0] + side / 2), bottom = lx_plot_y(plot, y[rows - 1] - side / 2);
    cairo_t *cairo = canvas->cairo;
    cairo_save(cairo);
    cairo_translate(cairo, left, top);
    cairo_scale(cairo, (right - left) / columns, (bottom - top) / rows);
    cairo_set_source_surface(cairo, image, 0, 0);
    /* squares when they are enlarged, means when they are made smaller */
    double dots = 1, unused = 0;
    cairo_user_to_device_distance(cairo, &dots, &unused);
    cairo_pattern_set_filter(cairo_get_source(cairo), fabs(dots) < 0.9 ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
}

/* ---- lines ---- */

static double brightness_of(const double color[3])
{
    return 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2];
}

/* What stands out from the colour of a value: its own colour on white, else ink or paper. */
static void line_color(const struct lx_figure *figure, const struct lx_canvas *canvas, double value, double color[3])
{
    lx_figure_color(figure, value, color);
    if (figure->settings.bands == LUXEL_LINES) {
        bool pale = brightness_of(color) > 0.75 && brightness_of(canvas->ground) > 0.5;
        for (int i = 0; i < 3; i++)
            color[i] *= pale ? 0.75 : 1;
        return;
    }
    bool dark = brightness_of(color) < 0.5;
    for (int i = 0; i < 3; i++)
        color[i] = dark ? 0.97 : 0.08;
}

static void trace(const struct lx_plot *plot, cairo_t *cairo, const luxel_isophote *line)
{
    for (size_t i = 0; i < line->count; i++)
        cairo_line_to(cairo, lx_plot_x(plot, line->x_mm[i]), lx_plot_y(plot, line->y_mm[i]));
    if (line->closed)
        cairo_close_path(cairo);
}

/* Lines are left out under their labels, where they would strike out a decimal point. */
static void clip_gaps(const struct labels *labels)
{
    const struct lx_box *map = &labels->plot->box;
    cairo_t *cairo = labels->canvas->cairo;
    cairo_rectangle(cairo, map->x, map->y, map->width, map->height);
    for (size_t i = 0; i < labels->mark_count; i++) {
        const struct mark *mark = &labels->marks[i];
        if (!(mark->gap.width > 0))
            continue;
        cairo_save(cairo);
        cairo_translate(cairo, mark->x, mark->y);
        cairo_rotate(cairo, mark->angle);
        cairo_rectangle(cairo, -mark->gap.width / 2, -mark->gap.height / 2, mark->gap.width, mark->gap.height);
        cairo_restore(cairo);
    }
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_clip(cairo);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
}

static void draw_lines(const struct labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const struct lx_canvas *canvas = labels->canvas;
    const struct lx_plot *plot = labels->plot;
    cairo_save(canvas->cairo);
    clip_gaps(labels);
    cairo_set_line_join(canvas->cairo, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; figure->isophotes && i < figure->isophotes->count; i++) {
        const luxel_isophote *line = &figure->isophotes->lines[i];
        double color[3];
        line_color(figure, canvas, line->level, color);
        lx_color(canvas, color, figure->settings.bands == LUXEL_LINES ? 1 : 0.75);
        cairo_set_line_width(canvas->cairo, (figure->settings.bands == LUXEL_LINES ? 1.4 : 0.9) * LINE * plot->size);
        trace(plot, canvas->cairo, line);
        cairo_stroke(canvas->cairo);
    }
    cairo_restore(canvas->cairo);
}

static void draw_outlines(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    lx_color(canvas, canvas->ink, 0.8);
    cairo_set_line_width(canvas->cairo, LINE * plot->size);
    for (size_t i = 0; i < figure->outline_count; i++) {
        const struct lx_outline *outline = &figure->outlines[i];
        for (size_t k = 0; k < outline->count; k++)
            cairo_line_to(canvas->cairo, lx_plot_x(plot, outline->places_mm[k][0]),
                          lx_plot_y(plot, outline->places_mm[k][1]));
        cairo_stroke(canvas->cairo);
    }
}

/* ---- labels of isophotes ---- */

/* The box around a text that is turned around its middle. */
static struct lx_box turned_box(const struct lx_box *size, double x, double y, double angle)
{
    double width = fabs(size->width * cos(angle)) + fabs(size->height * sin(angle));
    double height = fabs(size->width * sin(angle)) + fabs(size->height * cos(angle));
    return (struct lx_box){x - width / 2, y - height / 2, width, height};
}

/* Where a line is at a length along it, between its vertices. */
struct track {
    double (*at)[2];
    double *length;
    size_t count;
};

static void at_length(const struct track *track, double length, double at[2])
{
    size_t low = 0, high = track->count - 1;
    while (high - low > 1) {
        size_t half = (low + high) / 2;
        if (track->length[half] <= length)
            low = half;
        else
            high = half;
    }
    double span = track->length[high] - track->length[low];
    double share = span > 0 ? (length - track->length[low]) / span : 0;
    for (int i = 0; i < 2; i++)
        at[i] = track->at[low][i] * (1 - share) + track->at[high][i] * share;
}

static bool make_track(const struct lx_plot *plot, const luxel_isophote *line, struct track *track)
{
    *track = (struct track){.at = lx_new_array(line->count + 1, sizeof *track->at),
                            .length = lx_new_array(line->count + 1, sizeof *track->length),
                            .count = line->count + line->closed};
    for (size_t i = 0; track->at && track->length && i < track->count; i++) {
        size_t vertex = i % line->count;
        track->at[i][0] = lx_plot_x(plot, line->x_mm[vertex]);
        track->at[i][1] = lx_plot_y(plot, line->y_mm[vertex]);
        if (i > 0)
            track->length[i] = track->length[i - 1] +
                               hypot(track->at[i][0] - track->at[i - 1][0], track->at[i][1] - track->at[i - 1][1]);
    }
    return track->at && track->length;
}

/* Along the chord under the label, upright for who reads; how far the line bulges away from it counts against it. */
static double try_place(const struct labels *labels, const struct track *track, double length,
                        const struct lx_box *size, double *angle, double middle[2])
{
    double before[2], behind[2], total = track->length[track->count - 1], half = size->width / 2;
    if (length - half < 0 || length + half > total)
        return HUGE_VAL;
    at_length(track, length - half, before);
    at_length(track, length + half, behind);
    at_length(track, length, middle);
    *angle = atan2(behind[1] - before[1], behind[0] - before[0]);
    if (cos(*angle) < 0)
        *angle += M_PI;
    struct lx_box box = turned_box(size, middle[0], middle[1], *angle);
    if (!fits(labels, &box))
        return HUGE_VAL;
    double bulge = hypot(middle[0] - (before[0] + behind[0]) / 2, middle[1] - (before[1] + behind[1]) / 2);
    return bulge / size->height + 0.3 * fabs(sin(*angle));
}

static void label_line(struct labels *labels, const luxel_isophote *line)
{
    enum { TRIES = 48 };
    const struct lx_figure *figure = labels->figure;
    char text[LX_TICK_TEXT];
    double color[3], halo[3];
    struct track track;
    lx_tick_text(line->level, text);
    line_color(figure, labels->canvas, line->level, color);
    if (figure->settings.bands == LUXEL_LINES)
        memcpy(halo, labels->canvas->ground, sizeof halo);
    else
        lx_figure_color(figure, line->level, halo);
    struct lx_type type = {.size = LABEL * labels->plot->size, .color = color, .halo = halo};
    struct lx_box size = lx_measure(labels->canvas, text, &type);
    if (make_track(labels->plot, line, &track)) {
        double total = track.length[track.count - 1], best = 1, angle = 0, middle[2] = {0, 0};
        for (int i = 1; i < TRIES; i++) {
            double there = 0, at[2], badness = try_place(labels, &track, total * i / TRIES, &size, &there, at);
            if (badness >= best)
                continue;
            best = badness;
            angle = there;
            memcpy(middle, at, sizeof middle);
        }
        if (best < 1) {
            struct mark *mark = add_mark(labels, middle[0], middle[1], color, halo);
            labels->boxes[labels->count++] = turned_box(&size, middle[0], middle[1], angle);
            snprintf(mark->text, sizeof mark->text, "%s", text);
            mark->across = mark->down = 0.5;
            mark->angle = angle;
            mark->gap = (struct lx_box){.width = size.width + 0.3 * type.size, .height = 0.8 * size.height};
        }
    }
    free(track.at);
    free(track.length);
}

/* ---- marks ---- */

/* A text beside a mark, on the side where there is room; none where there is none. */
static void label_mark(struct labels *labels, const char *text, double x, double y, const double color[3],
                       const double halo[3])
{
    static const double sides[][2] = {{0, 1}, {0, 0}, {1, 1}, {1, 0}, {0.5, 1.6}, {0.5, -0.6}};
    const double away = 0.5 * labels->plot->size;
    struct lx_type type = {.size = LABEL * labels->plot->size, .color = color, .halo = halo, .bold = true};
    struct lx_box size = lx_measure(labels->canvas, text, &type);
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        double left = x + (sides[i][0] == 0.5 ? 0 : sides[i][0] < 0.5 ? away : -away);
        double top = y + (sides[i][1] > 0.5 ? -away / 2 : away / 2);
        struct lx_box box = {left - sides[i][0] * size.width, top - sides[i][1] * size.height, size.width, size.height};
        if (!fits(labels, &box))
            continue;
        struct mark *mark = add_mark(labels, left, top, color, halo);
        labels->boxes[labels->count++] = box;
        snprintf(mark->text, sizeof mark->text, "%s", text);
        mark->across = sides[i][0];
        mark->down = sides[i][1];
        mark->bold = true;
        return;
    }
}

/* The colours that stand out where a mark is. */
static void mark_colors(const struct labels *labels, double x_mm, double y_mm, double color[3], double halo[3])
{
    const struct lx_figure *figure = labels->figure;
    const double *xs = luxel_field_x_mm(figure->field), *ys = luxel_field_y_mm(figure->field);
    unsigned columns = luxel_field_columns(figure->field), rows = luxel_field_rows(figure->field), u = 0, v = 0;
    while (u + 1 < columns && fabs(xs[u + 1] - x_mm) < fabs(xs[u] - x_mm))
        u++;
    while (v + 1 < rows && fabs(ys[v + 1] - y_mm) < fabs(ys[v] - y_mm))
        v++;
    bool shown = luxel_field_mask(figure->field)[(size_t)v * columns + u];
    memcpy(halo, labels->canvas->ground, 3 * sizeof *halo);
    if (shown && figure->settings.bands != LUXEL_LINES)
        lx_figure_color(figure, luxel_field_value(figure->field, u, v), halo);
    for (int i = 0; i < 3; i++)
        color[i] = brightness_of(halo) < 0.5 ? 0.97 : 0.08;
}

static void draw_cross(const struct lx_canvas *canvas, double x, double y, double reach)
{
    cairo_move_to(canvas->cairo, x - reach, y);
    cairo_line_to(canvas->cairo, x + reach, y);
    cairo_move_to(canvas->cairo, x, y - reach);
    cairo_line_to(canvas->cairo, x, y + reach);
    cairo_stroke(canvas->cairo);
}

static bool is_on_map(const struct lx_figure *figure, const double at[2])
{
    return fabs(at[0]) <= figure->scene->screen.width_mm / 2 && fabs(at[1]) <= figure->scene->screen.height_mm / 2;
}

/* A mark takes room of its own before any label is placed. */
static void keep_free(struct labels *labels, double x, double y)
{
    double reach = 0.5 * labels->plot->size;
    if (labels->count < LX_MOST_BOXES)
        labels->boxes[labels->count++] = (struct lx_box){x - reach, y - reach, 2 * reach, 2 * reach};
}

static void mark_maximum(struct labels *labels)
{
    const luxel_peak *peak = &labels->figure->extrema.maximum;
    double x = lx_plot_x(labels->plot, peak->x_mm), y = lx_plot_y(labels->plot, peak->y_mm), color[3], halo[3];
    struct lx_text text = {0};
    char number[LX_NUMBER_SIZE];
    mark_colors(labels, peak->x_mm, peak->y_mm, color, halo);
    keep_free(labels, x, y);
    add_mark(labels, x, y, color, halo)->type = RING;
    lx_text_puts(&text, lx_figure_word(labels->figure, LX_N("max")));
    lx_text_puts(&text, " ");
    lx_text_puts(&text, lx_write_digits(peak->value, 6, number));
    if (text.bytes)
        label_mark(labels, text.bytes, x, y, color, halo);
    lx_text_clear(&text);
}

static void mark_points(struct labels *labels)
{
    const luxel_scene *scene = labels->figure->copy;
    for (size_t i = 0; i < luxel_scene_point_count(scene); i++) {
        double at[2], color[3], halo[3];
        struct lx_text name = {0};
        luxel_scene_point(scene, i, &at[0], &at[1]);
        if (!is_on_map(labels->figure, at))
            continue;
        double x = lx_plot_x(labels->plot, at[0]), y = lx_plot_y(labels->plot, at[1]);
        mark_colors(labels, at[0], at[1], color, halo);
        keep_free(labels, x, y);
        add_mark(labels, x, y, color, halo)->type = CROSS;
        lx_text_printf(&name, "P%zu", i + 1);
        if (name.bytes)
            label_mark(labels, name.bytes, x, y, color, halo);
        lx_text_clear(&name);
    }
}

/* Where the sections go through the map. */
static void draw_section_lines(const struct lx_figure *figure, const struct lx_canvas *canvas,
                               const struct lx_plot *plot)
{
    const double dashes[] = {0.6 * plot->size, 0.4 * plot->size};
    const struct lx_box *box = &plot->box;
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

static void draw_mark(const struct labels *labels, const struct mark *mark)
{
    const struct lx_canvas *canvas = labels->canvas;
    const struct lx_type type = {
        .size = LABEL * labels->plot->size, .color = mark->color, .halo = mark->halo, .bold = mark->bold};
    lx_color(canvas, mark->color, 1);
    cairo_set_line_width(canvas->cairo, 1.3 * LINE * labels->plot->size);
    if (mark->type == RING) {
        cairo_arc(canvas->cairo, mark->x, mark->y, 0.45 * labels->plot->size, 0, 2 * M_PI);
        cairo_stroke(canvas->cairo);
    } else if (mark->type == CROSS) {
        draw_cross(canvas, mark->x, mark->y, 0.4 * labels->plot->size);
    } else {
        lx_write(canvas, mark->text, &type, mark->x, mark->y, mark->across, mark->down, mark->angle);
    }
}

/* Marks first, then the labels of lines, where there is room left. */
static void place_labels(struct labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const luxel_peak *peak = &figure->extrema.maximum;
    if (figure->settings.extrema && peak->exists && peak->value > 0 && peak->place != LUXEL_PEAK_PLATEAU)
        mark_maximum(labels);
    if (figure->settings.points)
        mark_points(labels);
    for (size_t i = 0; figure->isophotes && i < figure->isophotes->count; i++)
        label_line(labels, &figure->isophotes->lines[i]);
}

void lx_draw_map(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    struct labels *labels = lx_new_array(1, sizeof *labels);
    cairo_save(canvas->cairo);
    cairo_rectangle(canvas->cairo, plot->box.x, plot->box.y, plot->box.width, plot->box.height);
    cairo_clip(canvas->cairo);
    draw_image(figure, canvas, plot);
    draw_section_lines(figure, canvas, plot);
    if (labels) {
        *labels = (struct labels){.figure = figure, .canvas = canvas, .plot = plot};
        place_labels(labels);
        draw_lines(labels);
    }
    draw_outlines(figure, canvas, plot);
    if (labels)
        for (size_t i = 0; i < labels->mark_count; i++)
            draw_mark(labels, &labels->marks[i]);
    cairo_restore(canvas->cairo);
    free(labels);
}
