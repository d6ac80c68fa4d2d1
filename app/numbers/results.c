/* SPDX-License-Identifier: MIT */
/* Results as text. */
#include "results.h"

#include "../../front/words.h"
#include "../base/number.h"

enum { DIGITS = 7 };

static void add_line(GString *text, const char *name, double value, double x_mm, double y_mm, double size_mm)
{
    char number[APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    g_string_append_printf(text, "%s\t%s\tx = %s, y = %s %s\n", name, app_number_show(value, DIGITS, number),
                           app_number_place(x_mm, size_mm, x), app_number_place(y_mm, size_mm, y), _("mm"));
}

static void add_extrema(GString *text, const AppResults *results, double size_mm)
{
    const luxel_statistics *statistics = luxel_field_statistics(results->field);
    const luxel_extremum *maximum = &statistics->maximum, *least = &statistics->minimum;
    const luxel_extremum *reached = results->reached;
    const luxel_extrema *extrema = results->extrema;
    if (maximum->exists)
        add_line(text, _("Maximum of the pixels"), maximum->value, maximum->x_mm, maximum->y_mm, size_mm);
    if (extrema && extrema->maximum.exists)
        add_line(text, _("True maximum"), extrema->maximum.value, extrema->maximum.x_mm, extrema->maximum.y_mm,
                 size_mm);
    if (extrema && extrema->minimum.exists)
        add_line(text, _("True minimum"), extrema->minimum.value, extrema->minimum.x_mm, extrema->minimum.y_mm,
                 size_mm);
    if (least->exists)
        add_line(text, _("Least value above 0"), least->value, least->x_mm, least->y_mm, size_mm);
    if (reached && reached->exists)
        add_line(text, _("Minimum where light arrives"), reached->value, reached->x_mm, reached->y_mm, size_mm);
}

static void add_point(GString *text, const AppPoint *point, gsize i)
{
    char number[APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    const char *value = !point->on_surface         ? _("off the surface")
                        : point->source_on_element ? _("a source lies here")
                        : point->has_value         ? app_number_show(point->value, DIGITS, number)
                                                   : "–";
    g_string_append_printf(text, "P%zu\t%s\tx = %s, y = %s %s\n", i + 1, value, app_number_show_all(point->x_mm, x),
                           app_number_show_all(point->y_mm, y), _("mm"));
}

char *app_results_text(const AppResults *results)
{
    GString *text = g_string_new(NULL);
    if (results->field) {
        const double *x = luxel_field_x_mm(results->field);
        add_extrema(text, results, x[luxel_field_columns(results->field) - 1] - x[0]);
    }
    for (gsize i = 0; i < results->point_count; i++)
        add_point(text, &results->points[i], i);
    g_string_replace(text, "\u2212", "-", 0); /* the minus that programs read */
    char *title = g_strdup_printf("%s\t%s\n", results->title, results->unit);
    g_string_prepend(text, title);
    g_free(title);
    return g_string_free(text, FALSE);
}
