/* SPDX-License-Identifier: MIT */
/* The page of points, and what all pages share. */
#include "numbers_private.h"

#include <luxel/drawing.h>
#include <math.h>
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/choices.h"
#include "../base/dim.h"
#include "../base/number.h"
#include "../base/row.h"
#include "../picture/color.h"
#include "results.h"

enum { POINT_COLUMNS = 5 };

enum { WANTED, READ, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppNumbers, app_numbers, GTK_TYPE_BOX)

/* ---- points ---- */

/* A point has two lines, so that no number is cut where the pane is narrow: its name, place and value, and below the
 * place the grey level, below the value that of the pixel. */
enum { LINES_OF_POINT = 2 };
static const int places_of_columns[POINT_COLUMNS][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}};

static void put_cell(AppNumbers *self, GtkWidget *label, int column, guint row)
{
    const int *place = places_of_columns[column];
    gtk_label_set_xalign(GTK_LABEL(label), column == 0 ? 0 : 1);
    gtk_grid_attach(GTK_GRID(self->points), label, place[0], (int)row * LINES_OF_POINT + place[1], 1, 1);
    if (place[1] > 0)
        gtk_widget_add_css_class(label, "note");
}

/* The row of the i-th point; the head of the table is above it. */
static GtkWidget *cell(AppNumbers *self, int column, guint i)
{
    const int *place = places_of_columns[column], line = ((int)i + 1) * LINES_OF_POINT + place[1];
    GtkWidget *label = gtk_grid_get_child_at(GTK_GRID(self->points), place[0], line);
    if (label)
        return label;
    label = gtk_label_new(NULL);
    gtk_label_set_selectable(GTK_LABEL(label), column > 0);
    gtk_widget_add_css_class(label, "numeric");
    put_cell(self, label, column, i + 1);
    return label;
}

/* Labels are only touched when their text is another: laying them out is what costs. */
void app_numbers_set_text(GtkWidget *label, const char *text)
{
    if (strcmp(gtk_label_get_text(GTK_LABEL(label)), text) != 0)
        gtk_label_set_text(GTK_LABEL(label), text);
}

void app_numbers_set_number(GtkWidget *label, double number)
{
    char text[APP_NUMBER_SIZE];
    app_numbers_set_text(label, app_number_show(number, DIGITS, text));
}

static void name_cell(GtkWidget *label, const char *column, guint row)
{
    char *text = g_strdup_printf("P%u %s: %s", row + 1, column, gtk_label_get_text(GTK_LABEL(label)));
    gtk_accessible_update_property(GTK_ACCESSIBLE(label), GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
    g_free(text);
}

/* The channels of an exact value with their bounds, and what they mean. */
static char *tell_color(const luxel_color *color)
{
    char *bounds = app_color_bounds(color), *seen = app_color_place(color), *kelvin = app_color_temperature(color);
    char *text = g_strdup_printf("\n%s\n%s\n%s", bounds, seen, kelvin);
    g_free(bounds);
    g_free(seen);
    g_free(kelvin);
    return text;
}

static void show_point(AppNumbers *self, const AppPoint *point, guint row)
{
    char text[2 * APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], amount[APP_AMOUNT_SIZE];
    GtkWidget *value = cell(self, 2, row);
    g_snprintf(text, sizeof text, "P%u", row + 1);
    app_numbers_set_text(cell(self, 0, row), text);
    g_snprintf(text, sizeof text, "%s%s%s", app_number_show(point->x_mm, PLACE_DIGITS, x), app_number_separator(),
               app_number_show(point->y_mm, PLACE_DIGITS, y));
    app_numbers_set_text(cell(self, 1, row), text);
    if (!point->on_surface)
        app_numbers_set_text(value, _("off the surface"));
    else if (point->source_on_element)
        app_numbers_set_text(value, _("a source lies here"));
    else if (point->has_value)
        app_numbers_set_number(value, point->value);
    else
        app_numbers_set_text(value, "–");
    char *colors = point->color.exists ? tell_color(&point->color) : g_strdup("");
    char *told = g_strconcat(app_amount_write(point->value, point->error, amount), colors, NULL);
    gtk_widget_set_tooltip_text(value, point->has_value ? told : NULL);
    g_free(told);
    g_free(colors);
    name_cell(value, _("value"), row);
    if (point->has_pixel)
        app_numbers_set_number(cell(self, 3, row), point->pixel_value);
    else
        app_numbers_set_text(cell(self, 3, row), "–");
    g_snprintf(text, sizeof text, "%u", point->grey);
    app_numbers_set_text(cell(self, 4, row), point->has_grey ? text : "–");
}

static void show_points(AppNumbers *self, const AppMeasures *measures)
{
    const guint count = (guint)measures->point_count;
    for (guint row = 0; row < count; row++)
        show_point(self, &measures->points[row], row);
    for (guint line = self->point_rows * LINES_OF_POINT; line > count * LINES_OF_POINT; line--)
        gtk_grid_remove_row(GTK_GRID(self->points), (int)line + LINES_OF_POINT - 1);
    self->point_rows = count;
    char *left =
        g_strdup_printf(ngettext("and %zu more", "and %zu more", measures->points_left), measures->points_left);
    app_numbers_set_text(self->points_left, measures->points_left > 0 ? left : "");
    g_free(left);
}

static GtkWidget *new_points(AppNumbers *self)
{
    const char *const heads[POINT_COLUMNS] = {"", _("x, y, mm"), _("value"), _("pixel"), _("grey")};
    GtkWidget *page = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6), *scrolled = gtk_scrolled_window_new();
    self->points = gtk_grid_new();
    self->points_left = gtk_label_new(NULL);
    self->unit = gtk_label_new(NULL);
    gtk_grid_set_column_spacing(GTK_GRID(self->points), 9);
    gtk_grid_set_row_spacing(GTK_GRID(self->points), 2);
    for (int i = 0; i < POINT_COLUMNS; i++) {
        GtkWidget *head = gtk_label_new(heads[i]);
        gtk_widget_add_css_class(head, "heading");
        put_cell(self, head, i, 0);
    }
    gtk_label_set_xalign(GTK_LABEL(self->unit), 0);
    gtk_label_set_xalign(GTK_LABEL(self->points_left), 0);
    gtk_widget_add_css_class(self->unit, "dim-label");
    gtk_label_set_wrap(GTK_LABEL(self->unit), TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(self->unit), TEXT_COLUMNS);
    /* the table may be wider than there is room for, the words below it never are */
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), self->points);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scrolled), TRUE);
    gtk_box_append(GTK_BOX(page), scrolled);
    gtk_box_append(GTK_BOX(page), self->points_left);
    gtk_box_append(GTK_BOX(page), self->unit);
    return page;
}

/* ---- plots ---- */

luxel_drawing_style app_numbers_style(GtkWidget *widget, luxel_language *language)
{
    luxel_drawing_style style;
    GdkRGBA ink;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    const double lightness = (double)(ink.red + ink.green + ink.blue) / 3;
    *language = (luxel_language){.translate = language_translate, .code = language_code()};
    luxel_drawing_style_init(&style, lightness > 0.5);
    style.letters = 11;
    style.language = language;
    style.decimal_mark = language_decimal_mark();
    return style;
}

/* ---- which version they are of ---- */

static const char *const page_names[] = {"space", "points", "section", "statistics", "lighting"};

static GtkWidget *page_of(AppNumbers *self, AppPage page)
{
    return gtk_stack_get_child_by_name(GTK_STACK(self->stack), page_names[page]);
}

static gboolean is_of(const AppNumbers *self, Part part)
{
    return part == PART_LIGHTING ? self->versions[part].shot >= self->live
                                 : app_version_equal(&self->versions[part], &self->wanted);
}

/* The reason why results cannot be copied; NULL: there is none. */
static const char *why_no_copy(const AppNumbers *self)
{
    if (self->wanted.is_direct)
        return _("What surfaces reflect is not computed yet");
    if (!self->is_latest || !is_of(self, PART_POINTS) || !self->shot)
        return _("The numbers of this scene are still being computed");
    return self->shot->is_fine ? NULL : _("The picture is still a coarse one");
}

static void judge(AppNumbers *self)
{
    GtkWidget *const parts[PARTS] = {
        [PART_POINTS] = page_of(self, APP_PAGE_POINTS),
        [PART_SECTION] = page_of(self, APP_PAGE_SECTION),
        [PART_STATISTICS] = page_of(self, APP_PAGE_STATISTICS),
        [PART_BALANCE] = self->balance,
        [PART_LIGHTING] = page_of(self, APP_PAGE_LIGHTING)};
    /* the balance stands among the statistics, with which it would be dimmed twice */
    for (Part part = 0; part < PARTS; part++)
        app_set_stale(parts[part], !is_of(self, part) && (part != PART_BALANCE || is_of(self, PART_STATISTICS)));
    const char *why = why_no_copy(self);
    gtk_widget_set_sensitive(self->copy, why == NULL);
    gtk_widget_set_tooltip_text(self->copy, why ? why : _("Maximum, minimum and points as one text"));
}

void app_numbers_follow_lighting(AppNumbers *self, guint64 serial)
{
    self->versions[PART_LIGHTING].shot = serial;
    judge(self);
}

void app_numbers_offer_lighting(AppNumbers *self, gboolean is_offered)
{
    GtkWidget *page = page_of(self, APP_PAGE_LIGHTING);
    self->has_lighting = is_offered;
    gtk_stack_page_set_visible(gtk_stack_get_page(GTK_STACK(self->stack), page), is_offered);
    if (!is_offered)
        app_numbers_forget_lighting(self);
}

gboolean app_numbers_set_version(AppNumbers *self, const AppVersion *version, guint64 live, gboolean is_latest)
{
    static const Part needed[] = {[APP_PAGE_SPACE] = PART_POINTS,
                                  [APP_PAGE_POINTS] = PART_POINTS,
                                  [APP_PAGE_SECTION] = PART_SECTION,
                                  [APP_PAGE_STATISTICS] = PART_STATISTICS,
                                  [APP_PAGE_LIGHTING] = PART_LIGHTING};
    if (!app_version_equal(&self->wanted, version) || self->live != live || self->is_latest != is_latest) {
        self->wanted = *version;
        self->live = live;
        self->is_latest = is_latest;
        judge(self);
    }
    const AppPage page = app_numbers_page(self);
    const gboolean needs_lighting = page == APP_PAGE_SPACE && self->has_lighting; /* grids are drawn there */
    return is_of(self, needed[page]) && (!needs_lighting || is_of(self, PART_LIGHTING));
}

void app_numbers_set_late(AppNumbers *self, gboolean is_late)
{
    app_numbers_set_text(self->waiting, is_late ? _("being computed…") : "");
}

void app_numbers_forget(AppNumbers *self)
{
    const AppMeasures none = {.has_points = TRUE};
    show_points(self, &none);
    app_numbers_set_text(self->unit, "");
    app_numbers_set_text(self->section_place, "");
    for (int i = 0; i < 2; i++)
        g_clear_pointer(&self->curves[i], app_curve_free);
    g_clear_pointer(&self->bins, luxel_histogram_free);
    for (int i = 0; i < LINES; i++)
        app_numbers_set_text(self->lines[i], "");
    app_numbers_show_balance(self, NULL);
    app_numbers_forget_lighting(self);
    for (int i = 0; i < PLOTS; i++)
        app_numbers_tell_cursor(self, (Plot)i);
    g_clear_pointer(&self->shot, app_shot_unref);
    self->has_extrema = FALSE;
    memset(self->versions, 0, sizeof self->versions);
    judge(self);
}

/* ---- all ---- */

/* What can be copied; extrema of another shot are no longer those of this one. */
static void keep_results(AppNumbers *self, const AppMeasures *measures)
{
    if (measures->shot != self->shot || measures->is_difference != self->is_difference) {
        app_shot_unref(self->shot);
        self->shot = app_shot_ref(measures->shot);
        self->is_difference = measures->is_difference;
        self->has_extrema = FALSE;
    }
    if (measures->has_points) {
        g_free(self->measured);
        self->measured_count = measures->point_count;
        self->measured = g_memdup2(measures->points, measures->point_count * sizeof *measures->points);
    }
    if (measures->has_extrema) {
        self->has_extrema = TRUE;
        self->extrema = measures->extrema;
        self->reached = measures->reached;
    }
}

static void copy_results(AppNumbers *self)
{
    if (why_no_copy(self))
        return;
    const char *name = app_document_name(self->document);
    const AppResults results = {.title = *name ? name : _("a new scene"),
                                .unit = self->unit_name,
                                .field = self->is_difference ? NULL : app_shot_light(self->shot),
                                .extrema = self->has_extrema ? &self->extrema : NULL,
                                .reached = self->has_extrema ? &self->reached : NULL,
                                .points = self->measured,
                                .point_count = self->measured_count};
    char *text = app_results_text(&results);
    gdk_clipboard_set_text(gtk_widget_get_clipboard(GTK_WIDGET(self)), text);
    g_free(text);
}

char *app_numbers_name(const AppMeasures *measures, const luxel_field *field)
{
    return g_strdup_printf("%s%s, %s", measures->is_difference ? _("B − A: ") : "",
                           gettext(luxel_field_quantity_word(field)), gettext(luxel_field_unit(field)));
}

void app_numbers_show(AppNumbers *self, AppMeasures *measures)
{
    g_free(self->unit_name);
    self->unit_name = app_numbers_name(measures, app_shot_light(measures->shot));
    keep_results(self, measures);
    if (measures->has_points)
        self->versions[PART_POINTS] = measures->version;
    if (measures->has_section)
        self->versions[PART_SECTION] = measures->version;
    if (measures->has_statistics)
        self->versions[PART_STATISTICS] = measures->version;
    if (measures->has_balance)
        self->versions[PART_BALANCE] = measures->version;
    if (measures->has_points) {
        char *text = g_strdup_printf(
            _("Values: %s. “value” is exact at the point, “pixel” what the picture has there."), self->unit_name);
        app_numbers_set_text(self->unit, text);
        g_free(text);
        show_points(self, measures);
    }
    if (measures->has_section)
        app_numbers_show_sections(self, measures);
    if (measures->has_statistics)
        app_numbers_show_statistics(self, measures);
    if (measures->has_balance)
        app_numbers_show_balance(self, measures->balance);
    judge(self);
}

void app_numbers_set_colors(AppNumbers *self, const char *palette, double low, double high, gboolean logarithmic)
{
    self->palette = palette;
    self->low = low;
    self->high = high;
    self->logarithmic = logarithmic;
}

AppPage app_numbers_page(AppNumbers *self)
{
    const char *name = gtk_stack_get_visible_child_name(GTK_STACK(self->stack));
    for (int i = 0; i < (int)G_N_ELEMENTS(page_names); i++)
        if (g_strcmp0(name, page_names[i]) == 0)
            return (AppPage)i;
    return APP_PAGE_POINTS;
}

static void page_turned(AppNumbers *self)
{
    g_signal_emit(self, signals[WANTED], 0);
}

static void app_numbers_dispose(GObject *object)
{
    AppNumbers *self = APP_NUMBERS(object);
    g_clear_object(&self->document);
    G_OBJECT_CLASS(app_numbers_parent_class)->dispose(object);
}

static void app_numbers_finalize(GObject *object)
{
    AppNumbers *self = APP_NUMBERS(object);
    app_curve_free(self->curves[0]);
    app_curve_free(self->curves[1]);
    app_shot_unref(self->shot);
    g_free(self->measured);
    luxel_histogram_free(self->bins);
    app_grids_unref(self->grids);
    app_eyes_unref(self->eyes);
    g_strfreev(self->names);
    g_free(self->bins_name);
    g_free(self->unit_name);
    G_OBJECT_CLASS(app_numbers_parent_class)->finalize(object);
}

static void app_numbers_class_init(AppNumbersClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_numbers_dispose;
    G_OBJECT_CLASS(class)->finalize = app_numbers_finalize;
    signals[READ] = g_signal_new("read", APP_TYPE_NUMBERS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 3,
                                 G_TYPE_DOUBLE, G_TYPE_DOUBLE, G_TYPE_BOOLEAN);
    signals[WANTED] = g_signal_new("wanted", APP_TYPE_NUMBERS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void app_numbers_init(AppNumbers *self)
{
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 8);
    for (int i = 0; i < PLOTS; i++)
        self->cursors[i].at = -1;
}

GtkWidget *app_numbers_new(AppDocument *document, GtkWidget *space)
{
    AppNumbers *self = g_object_new(APP_TYPE_NUMBERS, NULL);
    GtkWidget *switcher = gtk_stack_switcher_new();
    self->document = g_object_ref(document);
    self->stack = gtk_stack_new();
    gtk_stack_add_titled(GTK_STACK(self->stack), space, page_names[0], _("Plan"));
    gtk_stack_add_titled(GTK_STACK(self->stack), new_points(self), page_names[1], _("Points"));
    gtk_stack_add_titled(GTK_STACK(self->stack), app_numbers_new_sections(self), page_names[2], _("Section"));
    gtk_stack_add_titled(GTK_STACK(self->stack), app_numbers_new_statistics(self), page_names[3], _("Statistics"));
    gtk_stack_add_titled(GTK_STACK(self->stack), app_numbers_new_lighting(self), page_names[4], _("Lighting"));
    app_numbers_offer_lighting(self, FALSE);
    gtk_stack_switcher_set_stack(GTK_STACK_SWITCHER(switcher), GTK_STACK(self->stack));
    gtk_widget_set_vexpand(self->stack, TRUE);
    g_signal_connect_swapped(self->stack, "notify::visible-child", G_CALLBACK(page_turned), self);
    GtkWidget *copy = self->copy = gtk_button_new_with_label(_("Copy results"));
    self->waiting = gtk_label_new(NULL);
    gtk_label_set_ellipsize(GTK_LABEL(self->waiting), PANGO_ELLIPSIZE_END);
    gtk_widget_add_css_class(self->waiting, "note");
    gtk_label_set_xalign(GTK_LABEL(self->waiting), 0);
    gtk_widget_set_halign(copy, GTK_ALIGN_START);
    g_signal_connect_swapped(copy, "clicked", G_CALLBACK(copy_results), self);
    gtk_box_append(GTK_BOX(self), switcher);
    gtk_box_append(GTK_BOX(self), self->stack);
    gtk_box_append(GTK_BOX(self), self->waiting);
    gtk_box_append(GTK_BOX(self), copy);
    judge(self);
    return GTK_WIDGET(self);
}
