/* SPDX-License-Identifier: MIT */
/* The page of statistics: what is read off the pixels, what lies between them, and the histogram. */
#include <luxel/drawing.h>
#include <math.h>
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/number.h"
#include "../picture/color.h"
#include "numbers_private.h"

static const char *const line_names[LINES] = {
    [LINE_MAXIMUM] = N_("Maximum of the pixels"),
    [LINE_MAXIMUM_PLACE] = N_("at x, y, mm"),
    [LINE_TRUE_MAXIMUM] = N_("True maximum"),
    [LINE_TRUE_MAXIMUM_PLACE] = N_("at x, y, mm"),
    [LINE_MINIMUM] = N_("Minimum of the pixels"),
    [LINE_TRUE_MINIMUM] = N_("True minimum"),
    [LINE_LEAST] = N_("Least value above 0"),
    [LINE_LEAST_PLACE] = N_("at x, y, mm"),
    [LINE_REACHED] = N_("Minimum where light arrives"),
    [LINE_REACHED_PLACE] = N_("at x, y, mm"),
    [LINE_MEAN] = N_("Mean"),
    [LINE_MEDIAN] = N_("Median"),
    [LINE_DEVIATION] = N_("Standard deviation"),
    /* xgettext:no-c-format */
    [LINE_LIT] = N_("Above 0, % of the pixels"),
    [LINE_U0] = N_("Uniformity U0 = minimum / mean"),
    [LINE_UD] = N_("Diversity Ud = minimum / maximum"),
    [LINE_PIXELS] = N_("Pixels on a surface"),
    [LINE_COLOR] = N_("Colour of the mean"),
    [LINE_COLOR_PLACE] = N_("chromaticity"),
    [LINE_COLOR_TEMPERATURE] = N_("colour temperature"),
    [LINE_REFLECTED] = N_("Error of reflected light, of the maximum"),
    [LINE_MIRRORED] = N_("Error of light over mirrors, of the maximum"),
};

static void draw_histogram(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    AppNumbers *self = data;
    luxel_language language;
    luxel_drawing_style style = app_numbers_style(GTK_WIDGET(area), &language);
    const luxel_color_bar bar = {
        .palette = self->palette, .low = self->low, .high = self->high, .logarithmic = self->logarithmic};
    if (!self->bins)
        return;
    luxel_draw_histogram(cairo, &style, self->bins, self->palette && self->high > self->low ? &bar : NULL,
                         self->bins_name, _("pixels"), width, height);
    if (luxel_histogram_frame(&style, self->bins, self->bins_name, _("pixels"), width, height,
                              &self->cursors[PLOT_HISTOGRAM].frame) == LUXEL_OK)
        app_numbers_draw_cursor(self, PLOT_HISTOGRAM, cairo, &style);
}

static gboolean is_place(Line line)
{
    return line == LINE_MAXIMUM_PLACE || line == LINE_TRUE_MAXIMUM_PLACE || line == LINE_LEAST_PLACE ||
           line == LINE_REACHED_PLACE || line == LINE_COLOR || line == LINE_COLOR_PLACE ||
           line == LINE_COLOR_TEMPERATURE;
}

GtkWidget *app_numbers_new_statistics(AppNumbers *self)
{
    GtkWidget *page = gtk_box_new(GTK_ORIENTATION_VERTICAL, 8), *grid = gtk_grid_new();
    GtkWidget *scrolled = gtk_scrolled_window_new();
    gtk_grid_set_column_spacing(GTK_GRID(grid), 6);
    gtk_grid_set_row_spacing(GTK_GRID(grid), 4);
    for (int i = 0; i < LINES; i++) {
        GtkWidget *name = gtk_label_new(_(line_names[i]));
        gtk_label_set_xalign(GTK_LABEL(name), 0);
        gtk_label_set_wrap(GTK_LABEL(name), TRUE);
        gtk_label_set_max_width_chars(GTK_LABEL(name), TEXT_COLUMNS * 2 / 3);
        self->lines[i] = gtk_label_new(NULL);
        gtk_label_set_xalign(GTK_LABEL(self->lines[i]), 1);
        gtk_label_set_selectable(GTK_LABEL(self->lines[i]), TRUE);
        gtk_widget_add_css_class(self->lines[i], "numeric");
        if (is_place((Line)i)) /* two numbers are as wide as a narrow pane */
            gtk_widget_add_css_class(self->lines[i], "note");
        gtk_grid_attach(GTK_GRID(grid), name, 0, i, 1, 1);
        gtk_grid_attach(GTK_GRID(grid), self->lines[i], 1, i, 1, 1);
    }
    /* above the table, which is higher than most windows leave for both */
    app_numbers_add_plot(self, PLOT_HISTOGRAM, draw_histogram, _("Histogram"), page);
    gtk_box_append(GTK_BOX(page), grid);
    gtk_box_append(GTK_BOX(page), app_numbers_new_balance(self));
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), page);
    return scrolled;
}

/* As wide as the pixels lie apart from the first to the last: what places are rounded by. */
static double size_of(const luxel_field *field)
{
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    return MAX(x[luxel_field_columns(field) - 1] - x[0], y[0] - y[luxel_field_rows(field) - 1]);
}

static void show_place(AppNumbers *self, Line line, double x_mm, double y_mm)
{
    char text[2 * APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    g_snprintf(text, sizeof text, "%s%s%s", app_number_place(x_mm, self->size_mm, x), app_number_separator(),
               app_number_place(y_mm, self->size_mm, y));
    app_numbers_set_text(self->lines[line], text);
}

/* A line with its name. */
static void choose_line(AppNumbers *self, Line line, gboolean is_shown)
{
    GtkWidget *value = self->lines[line], *name = gtk_widget_get_prev_sibling(value);
    gtk_widget_set_visible(value, is_shown);
    gtk_widget_set_visible(name, is_shown);
}

/* Leaves out the lines that say nothing: a difference has no least value above 0 and no uniformity, and of a channel no
 * extrema between the pixels are found. */
static void choose_lines(AppNumbers *self, gboolean is_difference, gboolean is_channel)
{
    static const Line of_light[] = {LINE_TRUE_MAXIMUM, LINE_TRUE_MAXIMUM_PLACE, LINE_TRUE_MINIMUM, LINE_REACHED,
                                    LINE_REACHED_PLACE};
    static const Line of_pictures[] = {LINE_LEAST, LINE_LEAST_PLACE, LINE_U0, LINE_UD};
    for (gsize i = 0; i < G_N_ELEMENTS(of_pictures); i++)
        choose_line(self, of_pictures[i], !is_difference);
    for (gsize i = 0; i < G_N_ELEMENTS(of_light); i++)
        choose_line(self, of_light[i], !is_channel && !(is_difference && of_light[i] >= LINE_REACHED));
}

/* The bound of what surfaces reflect, where they do; marked where it is larger than it should be. */
static void show_reflected(AppNumbers *self, const luxel_statistics *statistics, gboolean is_difference)
{
    char text[APP_NUMBER_SIZE + 8], number[APP_NUMBER_SIZE];
    const gboolean is_missed = !statistics->reflected_reached;
    GtkWidget *label = self->lines[LINE_REFLECTED];
    choose_line(self, LINE_REFLECTED, statistics->has_reflected && !is_difference);
    g_snprintf(text, sizeof text, "%s %%%s", app_bound_show(100 * statistics->reflected_error, 2, number),
               is_missed ? " ⚠" : "");
    app_numbers_set_text(label, text);
    gtk_widget_set_tooltip_text(label, is_missed ? _("Less exact than it should be: many surfaces stand close to each "
                                                     "other. Values are shown all the same.")
                                                 : NULL);
    if (is_missed)
        gtk_widget_add_css_class(label, "warning");
    else
        gtk_widget_remove_css_class(label, "warning");
}

/* The bound of what comes over more mirrors than are counted, where there may be such light. */
static void show_mirrored(AppNumbers *self, const luxel_statistics *statistics, gboolean is_difference)
{
    char text[APP_NUMBER_SIZE + 8], number[APP_NUMBER_SIZE];
    choose_line(self, LINE_MIRRORED, statistics->mirrored_error > 0 && !is_difference);
    if (isfinite(statistics->mirrored_error))
        g_snprintf(text, sizeof text, "%s %%", app_bound_show(100 * statistics->mirrored_error, 2, number));
    else
        g_snprintf(text, sizeof text, "%s", _("not bounded"));
    app_numbers_set_text(self->lines[LINE_MIRRORED], text);
}

/* The colour of the pixels' mean; left out of a grey picture. */
static void show_mean(AppNumbers *self, const luxel_color *mean)
{
    static char *(*const tell[])(const luxel_color *) = {app_color_channels, app_color_place, app_color_temperature};
    for (gsize i = 0; i < G_N_ELEMENTS(tell); i++) {
        char *text = mean->exists ? tell[i](mean) : g_strdup("");
        app_numbers_set_text(self->lines[LINE_COLOR + i], text);
        choose_line(self, (Line)(LINE_COLOR + i), *text != '\0');
        g_free(text);
    }
}

/* The place of a least value in the line below it. */
static void show_least(AppNumbers *self, Line line, const luxel_extremum *least)
{
    show_place(self, line + 1, least->x_mm, least->y_mm);
    if (!least->exists) {
        app_numbers_set_text(self->lines[line], "–");
        app_numbers_set_text(self->lines[line + 1], "–");
    }
}

void app_numbers_show_statistics(AppNumbers *self, AppMeasures *measures)
{
    const luxel_summary *summary = &measures->summary;
    const luxel_peak *maximum = &measures->extrema.maximum, *minimum = &measures->extrema.minimum;
    const luxel_statistics *statistics = luxel_field_statistics(measures->shot->field);
    const luxel_statistics *light = luxel_field_statistics(app_shot_light(measures->shot));
    self->size_mm = size_of(measures->shot->field);
    const double numbers[LINES] = {
        [LINE_MAXIMUM] = summary->maximum.value,
        [LINE_TRUE_MAXIMUM] = maximum->value,
        [LINE_MINIMUM] = summary->minimum.value,
        [LINE_TRUE_MINIMUM] = minimum->value,
        [LINE_LEAST] = statistics->minimum.value,
        [LINE_REACHED] = measures->reached.value,
        [LINE_MEAN] = summary->mean,
        [LINE_MEDIAN] = summary->median,
        [LINE_DEVIATION] = summary->standard_deviation,
        [LINE_LIT] = 100 * summary->lit,
        [LINE_U0] = summary->u0,
        [LINE_UD] = summary->ud,
        [LINE_PIXELS] = (double)summary->pixels,
    };
    for (int i = 0; i < LINES; i++)
        app_numbers_set_number(self->lines[i], numbers[i]);
    show_place(self, LINE_MAXIMUM_PLACE, summary->maximum.x_mm, summary->maximum.y_mm);
    show_place(self, LINE_TRUE_MAXIMUM_PLACE, maximum->x_mm, maximum->y_mm);
    choose_lines(self, measures->is_difference, measures->shot->channel > APP_CHANNEL_LUMINANCE);
    show_mean(self, &measures->mean);
    show_reflected(self, light, measures->is_difference);
    show_mirrored(self, light, measures->is_difference);
    app_numbers_await_balance(self, light->has_reflected && !measures->is_difference);
    show_least(self, LINE_LEAST, &statistics->minimum);
    show_least(self, LINE_REACHED, &measures->reached);
    if (!measures->has_extrema) {
        app_numbers_set_text(self->lines[LINE_TRUE_MAXIMUM], "–");
        app_numbers_set_text(self->lines[LINE_TRUE_MAXIMUM_PLACE], "–");
        app_numbers_set_text(self->lines[LINE_TRUE_MINIMUM], "–");
    }
    if (!summary->has_evenness) {
        app_numbers_set_text(self->lines[LINE_U0], "–");
        app_numbers_set_text(self->lines[LINE_UD], "–");
    }
    g_free(self->bins_name);
    self->bins_name = app_numbers_name(measures, measures->shot->field);
    luxel_histogram_free(self->bins);
    self->bins = g_steal_pointer(&measures->histogram);
    app_numbers_tell_cursor(self, PLOT_HISTOGRAM);
}
