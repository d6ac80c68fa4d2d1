/* SPDX-License-Identifier: MIT */
/* Where labels go: the best of some places for each; first the marks, then the lines, long ones before short ones. */
#include "labels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

static const double LETTERS = 0.9; /* size of labels in the map, of the letters elsewhere */
static const double LINE = 0.1;    /* widths of lines, of the letters' size */
static const double AWAY = 0.35;   /* from the frame, of the letters' size */

enum { CELL_SHARED = 0xffff, PALE = 97, DARK = 8 };

int lx_labels_prepare(struct lx_figure *figure)
{
    struct lx_labels *labels = lx_new_array(1, sizeof *labels);
    size_t longest = 0, lines = figure->isophotes ? figure->isophotes->count : 0;
    figure->labels = labels;
    if (!labels)
        return -1;
    for (size_t i = 0; i < lines; i++)
        longest = figure->isophotes->lines[i].count > longest ? figure->isophotes->lines[i].count : longest;
    labels->track = lx_new_array(longest + 1, sizeof *labels->track);
    labels->order = lx_new_array(lines + 1, sizeof *labels->order);
    return labels->track && labels->order ? 0 : -1;
}

void lx_labels_free(struct lx_labels *labels)
{
    if (!labels)
        return;
    free(labels->track);
    free(labels->order);
    free(labels);
}

/* ---- patches ---- */

/* Half of what a patch covers along a direction. */
static double reach_along(const struct lx_label_patch *patch, double along_x, double along_y)
{
    double c = cos(patch->angle), s = sin(patch->angle);
    return (fabs(c * along_x + s * along_y) * patch->width + fabs(c * along_y - s * along_x) * patch->height) / 2;
}

/* Whether some line of the sides of `a` has all of `b` behind it. */
static bool is_apart(const struct lx_label_patch *a, const struct lx_label_patch *b)
{
    for (int side = 0; side < 2; side++) {
        double x = cos(a->angle + side * M_PI / 2), y = sin(a->angle + side * M_PI / 2);
        if (fabs((b->x - a->x) * x + (b->y - a->y) * y) >= reach_along(a, x, y) + reach_along(b, x, y))
            return true;
    }
    return false;
}

static bool meet(const struct lx_label_patch *a, const struct lx_label_patch *b)
{
    return !is_apart(a, b) && !is_apart(b, a);
}

static bool fits(const struct lx_labels *labels, const struct lx_label_patch *patch)
{
    const struct lx_pane *map = &labels->plot->box;
    double across = reach_along(patch, 1, 0) + AWAY * labels->size, up = reach_along(patch, 0, 1) + AWAY * labels->size;
    if (patch->x - across < map->x || patch->x + across > map->x + map->width || patch->y - up < map->y ||
        patch->y + up > map->y + map->height)
        return false;
    for (size_t i = 0; i < labels->count; i++)
        if (labels->labels[i].patch.width > 0 && meet(patch, &labels->labels[i].patch))
            return false;
    for (size_t i = 0; i < labels->mark_count; i++)
        if (meet(patch, &labels->marks[i]))
            return false;
    return true;
}

/* ---- what lies where ---- */

static uint16_t *cell_at(struct lx_labels *labels, double x, double y)
{
    const struct lx_pane *map = &labels->plot->box;
    double column = floor((x - map->x) / map->width * LX_LABEL_CELLS);
    double row = floor((y - map->y) / map->height * LX_LABEL_CELLS);
    if (!(column >= 0 && column < LX_LABEL_CELLS && row >= 0 && row < LX_LABEL_CELLS))
        return NULL;
    return &labels->cells[(size_t)row][(size_t)column];
}

/* Enters a stretch of a line into the cells that it runs through. */
static void enter(struct lx_labels *labels, const double from[2], const double to[2], uint16_t line)
{
    const struct lx_pane *map = &labels->plot->box;
    double cell = fmin(map->width, map->height) / LX_LABEL_CELLS;
    double steps = fmin(ceil(hypot(to[0] - from[0], to[1] - from[1]) / cell) + 1, 4 * LX_LABEL_CELLS);
    for (double i = 0; i <= steps; i++) {
        uint16_t *at =
            cell_at(labels, from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps);
        if (at)
            *at = *at == 0 || *at == line ? line : CELL_SHARED;
    }
}

/* A stretch between two places of the screen. */
static void enter_mm(struct lx_labels *labels, double from_x, double from_y, double to_x, double to_y, uint16_t line)
{
    const struct lx_plot *plot = labels->plot;
    enter(labels, (const double[]){lx_plot_x(plot, from_x), lx_plot_y(plot, from_y)},
          (const double[]){lx_plot_x(plot, to_x), lx_plot_y(plot, to_y)}, line);
}

static void enter_lines(struct lx_labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const struct lx_plot *plot = labels->plot;
    memset(labels->cells, 0, sizeof labels->cells);
    for (size_t i = 0; figure->isophotes && i < figure->isophotes->count; i++) {
        const luxel_isophote *line = &figure->isophotes->lines[i];
        uint16_t name = i + 1 < CELL_SHARED ? (uint16_t)(i + 1) : CELL_SHARED;
        for (size_t k = 1; k < line->count + line->closed; k++)
            enter_mm(labels, line->x_mm[k - 1], line->y_mm[k - 1], line->x_mm[k % line->count],
                     line->y_mm[k % line->count], name);
    }
    for (size_t i = 0; i < figure->outline_count; i++) {
        const struct lx_figure_outline *outline = &figure->outlines[i];
        for (size_t k = 1; k < outline->count; k++)
            enter_mm(labels, outline->places_mm[k - 1][0], outline->places_mm[k - 1][1], outline->places_mm[k][0],
                     outline->places_mm[k][1], CELL_SHARED);
    }
    if (figure->sections[0]) {
        enter_mm(labels, plot->x.low, figure->section_mm[1], plot->x.high, figure->section_mm[1], CELL_SHARED);
        enter_mm(labels, figure->section_mm[0], plot->y.low, figure->section_mm[0], plot->y.high, CELL_SHARED);
    }
}

/* The share of a patch that other lines than `own` run through. */
static double crowded(struct lx_labels *labels, const struct lx_label_patch *patch, uint16_t own)
{
    enum { ACROSS = 24, DOWN = 12 };
    double c = cos(patch->angle), s = sin(patch->angle);
    int busy = 0;
    for (int i = 0; i < ACROSS; i++)
        for (int k = 0; k < DOWN; k++) {
            double x = patch->width * ((i + 0.5) / ACROSS - 0.5), y = patch->height * ((k + 0.5) / DOWN - 0.5);
            const uint16_t *at = cell_at(labels, patch->x + c * x - s * y, patch->y + s * x + c * y);
            busy += at && *at != 0 && *at != own;
        }
    return (double)busy / (ACROSS * DOWN);
}

/* What is painted at a place of the map. */
static void ground_at(const struct lx_labels *labels, double x, double y, double color[3])
{
    const struct lx_figure *figure = labels->figure;
    const struct lx_pane *map = &labels->plot->box;
    const luxel_field *field = figure->field;
    unsigned columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    double u = floor((x - map->x) / map->width * columns), v = floor((y - map->y) / map->height * rows);
    unsigned column = (unsigned)fmin(fmax(u, 0), columns - 1.0), row = (unsigned)fmin(fmax(v, 0), rows - 1.0);
    if (!luxel_field_mask(field)[(size_t)row * columns + column])
        lx_empty_color(labels->canvas, color);
    else if (figure->settings.bands == LUXEL_BANDS_LINES)
        memcpy(color, labels->canvas->ground, 3 * sizeof *color);
    else
        lx_figure_color(figure, lx_shown_value(figure, luxel_field_value(field, column, row)), color);
}

/* The mean colour under a patch; returns how much the brightness varies there. */
static double ground_under(const struct lx_labels *labels, const struct lx_label_patch *patch, double color[3])
{
    enum { ACROSS = 9, DOWN = 3 };
    double least = 1, most = 0, sum[3] = {0, 0, 0};
    for (int i = 0; i < ACROSS * DOWN; i++) {
        double at[3], x = patch->x + patch->width * ((i % ACROSS) / (ACROSS - 1.0) - 0.5);
        ground_at(labels, x, patch->y + patch->height * ((i / ACROSS) / (DOWN - 1.0) - 0.5), at);
        least = fmin(least, lx_lightness(at));
        most = fmax(most, lx_lightness(at));
        for (int k = 0; k < 3; k++)
            sum[k] += at[k];
    }
    for (int k = 0; k < 3; k++)
        color[k] = sum[k] / (ACROSS * DOWN);
    return most - least;
}

static void contrast(const double ground[3], double color[3])
{
    for (int i = 0; i < 3; i++)
        color[i] = lx_lightness(ground) < 0.5 ? PALE / 100.0 : DARK / 100.0;
}

/* ---- marks ---- */

static void add_mark(struct lx_labels *labels, enum lx_mark_type type, double x_mm, double y_mm)
{
    double x = lx_plot_x(labels->plot, x_mm), y = lx_plot_y(labels->plot, y_mm), ground[3];
    double room = (type == LX_MARK_RING ? 1.2 : 1) * labels->size;
    if (labels->count == LX_MOST_LABELS)
        return;
    struct lx_label *label = &labels->labels[labels->count++];
    *label = (struct lx_label){.mark = type, .marked = {x, y}};
    ground_at(labels, x, y, ground);
    contrast(ground, label->mark_color);
    labels->marks[labels->mark_count++] = (struct lx_label_patch){.x = x, .y = y, .width = room, .height = room};
}

/* The lights before a plane, by their names. */
static void add_lamps(struct lx_labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const struct lx_figure_plane *plane = figure->plane;
    for (size_t i = 0; i < plane->lamp_count && labels->count < LX_MOST_LABELS / 4; i++) {
        add_mark(labels, LX_MARK_LAMP, plane->lamps[i].place_mm[0], plane->lamps[i].place_mm[1]);
        for (size_t k = 0; k < figure->light_count; k++)
            if (figure->light_places[k] == plane->lamps[i].light)
                snprintf(labels->labels[labels->count - 1].text, LX_LABEL_TEXT, "%s", figure->lights[k]);
    }
}

static void add_marks(struct lx_labels *labels)
{
    const struct lx_figure *figure = labels->figure;
    const double *size_mm = figure->size_mm;
    if (lx_shows_maximum(figure)) {
        add_mark(labels, LX_MARK_RING, figure->extrema.maximum.x_mm, figure->extrema.maximum.y_mm);
        snprintf(labels->labels[labels->count - 1].text, LX_LABEL_TEXT, "%s", figure->maximum);
    }
    if (figure->plane) {
        add_lamps(labels);
        return;
    }
    for (size_t i = 0; figure->settings.points && i < luxel_scene_point_count(figure->copy); i++) {
        double x, y;
        luxel_scene_point(figure->copy, i, &x, &y);
        if (fabs(x) > size_mm[0] / 2 || fabs(y) > size_mm[1] / 2 || labels->count == LX_MOST_LABELS)
            continue;
        add_mark(labels, LX_MARK_CROSS, x, y);
        snprintf(labels->labels[labels->count - 1].text, LX_LABEL_TEXT, "P%zu", i + 1);
    }
}

/* The nearest place around the mark that is free, without many lines and of about one colour. */
static void place_beside(struct lx_labels *labels, struct lx_label *label)
{
    static const double directions[][2] = {{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}};
    static const double steps[] = {0.55, 1.3, 2.2, 3.4, 5};
    struct lx_type type = {.size = LETTERS * labels->size, .bold = true};
    struct lx_pane text = lx_measure(labels->canvas, label->text, &type);
    struct lx_label_patch best = {.width = 0};
    double least = HUGE_VAL;
    for (size_t i = 0; i < LX_COUNT(steps) * LX_COUNT(directions); i++) {
        const double *way = directions[i % LX_COUNT(directions)];
        double step = steps[i / LX_COUNT(directions)], away = step * labels->size, ground[3];
        /* beside the mark its label is at its height or a little above or below */
        struct lx_label_patch patch = {.x = label->marked[0] + way[0] * (away + text.width / 2),
                                       .y = label->marked[1] + way[1] * (away * 0.4 + text.height / 2),
                                       .width = text.width,
                                       .height = text.height};
        if (way[0] == 0)
            patch.y = label->marked[1] + way[1] * (away + text.height / 2);
        struct lx_label_patch apart = patch; /* so that two of them do not read as one */
        apart.width += labels->size;
        if (!fits(labels, &apart))
            continue;
        double badness = 0.35 * step + 4 * crowded(labels, &patch, 0) + 1.5 * ground_under(labels, &patch, ground) +
                         0.01 * (double)(i % LX_COUNT(directions));
        if (badness >= least)
            continue;
        least = badness;
        best = patch;
        label->led = step > 1.5;
    }
    if (!(best.width > 0)) {
        label->text[0] = '\0';
        return;
    }
    label->patch = best;
    ground_under(labels, &best, label->halo);
    contrast(label->halo, label->color);
}

/* ---- values ---- */

/* How many cells lie from one value to the next along a side, so that they stand apart. */
static unsigned value_step(double length, unsigned cells, double room)
{
    unsigned step = (unsigned)fmin(ceil(room * cells / length), cells);
    return step > 0 ? step : 1;
}

/* The value at a point of the grid; left out where a mark stands. */
static void add_value(struct lx_labels *labels, unsigned column, unsigned row)
{
    const luxel_grid *grid = labels->figure->plane->grid;
    const struct lx_pane *map = &labels->plot->box;
    const struct lx_type type = {.size = LETTERS * labels->size};
    const size_t cell = (size_t)row * grid->columns + column;
    char number[LX_TICK_TEXT];
    if (!grid->mask[cell])
        return;
    const struct lx_pane text = lx_measure(labels->canvas, lx_value_text(grid->values[cell], number), &type);
    struct lx_label label = {.patch = {.x = map->x + map->width * (column + 0.5) / grid->columns,
                                       .y = map->y + map->height * (row + 0.5) / grid->rows,
                                       .width = text.width + 0.35 * type.size,
                                       .height = 0.8 * text.height}};
    if (!fits(labels, &label.patch))
        return;
    snprintf(label.text, LX_LABEL_TEXT, "%s", number);
    ground_under(labels, &label.patch, label.halo);
    contrast(label.halo, label.color);
    labels->labels[labels->count++] = label;
}

/* The values at the points of a plane's grid; where there is no room for all, at every second, third and so on. */
static void add_values(struct lx_labels *labels)
{
    enum { MOST = 300 };
    const luxel_grid *grid = labels->figure->plane->grid;
    const struct lx_pane *map = &labels->plot->box;
    const struct lx_type type = {.size = LETTERS * labels->size};
    double widest = 0, height = 0;
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows && i < 4 * MOST; i++) {
        char number[LX_TICK_TEXT];
        const struct lx_pane text = lx_measure(labels->canvas, lx_value_text(grid->values[i], number), &type);
        widest = fmax(widest, text.width);
        height = fmax(height, text.height);
    }
    unsigned across = value_step(map->width, grid->columns, widest + labels->size);
    unsigned down = value_step(map->height, grid->rows, 1.6 * height);
    while ((size_t)((grid->columns + across - 1) / across) * ((grid->rows + down - 1) / down) > MOST)
        across++, down++;
    for (unsigned row = (grid->rows - 1) % down / 2; row < grid->rows; row += down)
        for (unsigned column = (grid->columns - 1) % across / 2; column < grid->columns; column += across)
            add_value(labels, column, row);
}

/* ---- lines ---- */

/* Fills the track with a line; returns its length. */
static double make_track(struct lx_labels *labels, const luxel_isophote *line, size_t *count)
{
    double(*track)[3] = labels->track;
    *count = line->count + line->closed;
    for (size_t i = 0; i < *count; i++) {
        size_t vertex = i % line->count;
        track[i][0] = lx_plot_x(labels->plot, line->x_mm[vertex]);
        track[i][1] = lx_plot_y(labels->plot, line->y_mm[vertex]);
        track[i][2] = i > 0 ? track[i - 1][2] + hypot(track[i][0] - track[i - 1][0], track[i][1] - track[i - 1][1]) : 0;
    }
    return *count > 0 ? track[*count - 1][2] : 0;
}

static void at_length(double (*track)[3], size_t count, double length, double at[2])
{
    size_t low = 0, high = count - 1;
    while (high - low > 1) {
        size_t half = (low + high) / 2;
        if (track[half][2] <= length)
            low = half;
        else
            high = half;
    }
    double span = track[high][2] - track[low][2], share = span > 0 ? (length - track[low][2]) / span : 0;
    for (int i = 0; i < 2; i++)
        at[i] = track[low][i] * (1 - share) + track[high][i] * share;
}

/* Along the chord under the label, upright for who reads; how far the line bulges away from it counts against it. */
static double try_place(struct lx_labels *labels, size_t count, double length, const struct lx_pane *text, uint16_t own,
                        struct lx_label_patch *patch)
{
    double before[2], behind[2], middle[2], total = labels->track[count - 1][2], half = text->width / 2;
    if (length - half < 0 || length + half > total)
        return HUGE_VAL;
    at_length(labels->track, count, length - half, before);
    at_length(labels->track, count, length + half, behind);
    at_length(labels->track, count, length, middle);
    double angle = atan2(behind[1] - before[1], behind[0] - before[0]);
    if (cos(angle) < 0)
        angle += M_PI;
    *patch = (struct lx_label_patch){middle[0], middle[1], text->width, text->height, angle};
    if (!fits(labels, patch))
        return HUGE_VAL;
    double bulge = hypot(middle[0] - (before[0] + behind[0]) / 2, middle[1] - (before[1] + behind[1]) / 2);
    return bulge / text->height + 0.25 * fabs(sin(angle)) + 6 * crowded(labels, patch, own);
}

static void label_line(struct lx_labels *labels, size_t index)
{
    enum { TRIES = 64 };
    const luxel_isophote *line = &labels->figure->isophotes->lines[index];
    uint16_t own = index + 1 < CELL_SHARED ? (uint16_t)(index + 1) : CELL_SHARED;
    size_t count;
    double total = make_track(labels, line, &count), least = 0.75;
    struct lx_type type = {.size = LETTERS * labels->size};
    struct lx_label label = {.mark = LX_MARK_NONE};
    lx_tick_text(line->level, label.text);
    struct lx_pane text = lx_measure(labels->canvas, label.text, &type);
    text.width += 0.35 * type.size; /* a little of the line is left out on either side */
    text.height *= 0.8;
    /* a label must not be most of its line */
    if (labels->count == LX_MOST_LABELS || total < (line->closed ? 4 : 2.5) * text.width)
        return;
    for (int i = 1; i < TRIES; i++) {
        struct lx_label_patch patch;
        double badness = try_place(labels, count, total * i / TRIES, &text, own, &patch);
        if (badness >= least)
            continue;
        least = badness;
        label.patch = patch;
    }
    if (!(label.patch.width > 0))
        return;
    lx_line_color(labels->figure, labels->canvas, line->level, label.color);
    if (labels->figure->settings.bands == LUXEL_BANDS_LINES)
        memcpy(label.halo, labels->canvas->ground, sizeof label.halo);
    else
        lx_figure_color(labels->figure, line->level, label.halo);
    labels->labels[labels->count++] = label;
}

static double length_of(const luxel_isophote *line)
{
    double length = 0;
    for (size_t i = 1; i < line->count; i++)
        length += hypot(line->x_mm[i] - line->x_mm[i - 1], line->y_mm[i] - line->y_mm[i - 1]);
    return length;
}

/* The longest lines first: they are what people follow.  Insertion keeps equal ones in their order. */
static size_t order_lines(struct lx_labels *labels)
{
    enum { MOST = 300 }; /* a map of more lines has no room for their labels */
    const luxel_isophotes *isophotes = labels->figure->isophotes;
    double lengths[MOST];
    size_t count = 0;
    for (size_t i = 0; isophotes && i < isophotes->count; i++) {
        double length = length_of(&isophotes->lines[i]);
        if (count == MOST && length <= lengths[MOST - 1])
            continue;
        size_t at = count < MOST ? count++ : MOST - 1;
        for (; at > 0 && lengths[at - 1] < length; at--) {
            lengths[at] = lengths[at - 1];
            labels->order[at] = labels->order[at - 1];
        }
        lengths[at] = length;
        labels->order[at] = i;
    }
    return count;
}

void lx_place_labels(struct lx_labels *labels, const struct lx_figure *figure, const struct lx_canvas *canvas,
                     const struct lx_plot *plot)
{
    labels->count = labels->mark_count = 0;
    labels->figure = figure;
    labels->canvas = canvas;
    labels->plot = plot;
    labels->size = plot->size;
    enter_lines(labels);
    add_marks(labels);
    const size_t marks = labels->count;
    if (figure->plane && figure->settings.points)
        add_values(labels);
    for (size_t i = 0; i < marks; i++)
        place_beside(labels, &labels->labels[i]);
    if (figure->settings.bands == LUXEL_BANDS_STEPS) /* the bar tells them apart */
        return;
    size_t lines = order_lines(labels);
    for (size_t i = 0; i < lines; i++)
        label_line(labels, labels->order[i]);
}

/* ---- drawing ---- */

void lx_clip_labels(const struct lx_labels *labels)
{
    const struct lx_pane *map = &labels->plot->box;
    cairo_t *cairo = labels->canvas->cairo;
    cairo_rectangle(cairo, map->x, map->y, map->width, map->height);
    for (size_t i = 0; i < labels->count; i++) {
        const struct lx_label_patch *patch = &labels->labels[i].patch;
        if (!*labels->labels[i].text || labels->labels[i].mark != LX_MARK_NONE)
            continue;
        cairo_save(cairo);
        cairo_translate(cairo, patch->x, patch->y);
        cairo_rotate(cairo, patch->angle);
        cairo_rectangle(cairo, -patch->width / 2, -patch->height / 2, patch->width, patch->height);
        cairo_restore(cairo);
    }
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_clip(cairo);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
}

static void draw_mark(const struct lx_labels *labels, const struct lx_label *label)
{
    cairo_t *cairo = labels->canvas->cairo;
    double x = label->marked[0], y = label->marked[1], reach = 0.4 * labels->size;
    if (label->mark == LX_MARK_RING) {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, x, y, 1.1 * reach, 0, 2 * M_PI);
    } else if (label->mark == LX_MARK_LAMP) { /* as drawings of electrical installations have it */
        const double arm = reach * M_SQRT1_2;
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, x, y, reach, 0, 2 * M_PI);
        cairo_move_to(cairo, x - arm, y - arm);
        cairo_line_to(cairo, x + arm, y + arm);
        cairo_move_to(cairo, x - arm, y + arm);
        cairo_line_to(cairo, x + arm, y - arm);
    } else {
        cairo_move_to(cairo, x - reach, y);
        cairo_line_to(cairo, x + reach, y);
        cairo_move_to(cairo, x, y - reach);
        cairo_line_to(cairo, x, y + reach);
    }
    lx_color(labels->canvas, label->mark_color, 1);
    cairo_set_line_width(cairo, 1.3 * LINE * labels->size);
    cairo_stroke(cairo);
}

/* From the mark to the nearest point of its label. */
static void draw_leader(const struct lx_labels *labels, const struct lx_label *label)
{
    const struct lx_label_patch *patch = &label->patch;
    double x = fmin(fmax(label->marked[0], patch->x - patch->width / 2), patch->x + patch->width / 2);
    double y = fmin(fmax(label->marked[1], patch->y - patch->height / 4), patch->y + patch->height / 4);
    double length = hypot(x - label->marked[0], y - label->marked[1]), start = 0.6 * labels->size;
    cairo_t *cairo = labels->canvas->cairo;
    if (length <= start)
        return;
    cairo_move_to(cairo, label->marked[0] + (x - label->marked[0]) * start / length,
                  label->marked[1] + (y - label->marked[1]) * start / length);
    cairo_line_to(cairo, x, y);
    lx_color(labels->canvas, label->mark_color, 0.9);
    cairo_set_line_width(cairo, 0.7 * LINE * labels->size);
    cairo_stroke(cairo);
}

void lx_draw_labels(const struct lx_labels *labels)
{
    for (size_t i = 0; i < labels->count; i++) {
        const struct lx_label *label = &labels->labels[i];
        struct lx_type type = {.size = LETTERS * labels->size,
                               .color = label->color,
                               .halo = label->halo,
                               .bold = label->mark != LX_MARK_NONE};
        if (label->mark != LX_MARK_NONE)
            draw_mark(labels, label);
        if (!*label->text)
            continue;
        if (label->mark != LX_MARK_NONE && label->led)
            draw_leader(labels, label);
        lx_write(labels->canvas, label->text, &type, label->patch.x, label->patch.y, 0.5, 0.5, label->patch.angle);
    }
}
