/* SPDX-License-Identifier: MIT */
/*
 * The line tells what catalogues quote, the ratings of the room of 4 by 8 heights; unfolded, all rooms stand below each
 * other, crosswise before endwise, so that the table is as narrow as the form.
 */
#include "ugr_table.h"

#include <luxel/glare.h>
#include <math.h>

#include "../../front/words.h"
#include "../base/number.h"

enum { CELL_SIZE = 32, GAP = 8 };
static const double SPACING = 0.25; /* as catalogues have it */

static void put(GtkWidget *grid, const char *text, int column, int row, int columns, gboolean is_heading)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), column == 0 ? 0 : 1);
    gtk_widget_add_css_class(label, "note");
    gtk_widget_add_css_class(label, is_heading ? "heading" : "numeric");
    gtk_widget_set_hexpand(label, column > 0);
    gtk_grid_attach(GTK_GRID(grid), label, column, row, columns, 1);
}

static const char *rating_text(double rating, char text[CELL_SIZE])
{
    if (isnan(rating))
        return "—";
    g_snprintf(text, CELL_SIZE, "%.1f", rating);
    app_number_mark(text);
    return text;
}

/* Reflectances of ceiling, walls and floor above, then a row for each room. */
static int add_block(GtkWidget *grid, const luxel_ugr_table *table, int way, const char *title, int row)
{
    const char *const parts[] = {_("ceiling, %"), _("walls, %"), _("floor, %")};
    char text[CELL_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    put(grid, title, 0, row++, 1 + LUXEL_UGR_REFLECTANCES, TRUE);
    for (size_t part = 0; part < G_N_ELEMENTS(parts); part++, row++) {
        put(grid, parts[part], 0, row, 1, FALSE);
        for (size_t i = 0; i < LUXEL_UGR_REFLECTANCES; i++) {
            g_snprintf(text, sizeof text, "%.0f", 100 * luxel_ugr_reflectance(i, part));
            put(grid, text, (int)i + 1, row, 1, FALSE);
        }
    }
    for (size_t room = 0; room < LUXEL_UGR_ROOMS; room++, row++) {
        g_snprintf(text, sizeof text, "%sH × %sH", app_number_show(luxel_ugr_room(room, 0), 3, x),
                   app_number_show(luxel_ugr_room(room, 1), 3, y));
        put(grid, text, 0, row, 1, FALSE);
        for (size_t i = 0; i < LUXEL_UGR_REFLECTANCES; i++)
            put(grid, rating_text(table->ratings[room][way][i], text), (int)i + 1, row, 1, FALSE);
    }
    return row;
}

static GtkWidget *new_grid(const luxel_ugr_table *table)
{
    GtkWidget *grid = gtk_grid_new();
    gtk_grid_set_column_spacing(GTK_GRID(grid), GAP);
    const int row = add_block(grid, table, 0, _("crosswise: C0-C180 along the line of sight"), 0);
    add_block(grid, table, 1, _("endwise: C90-C270 along the line of sight"), row);
    return grid;
}

/* The room that catalogues quote. */
static const double *quoted(const luxel_ugr_table *table, int way)
{
    size_t room = 0;
    while (luxel_ugr_room(room, 0) != 4 || luxel_ugr_room(room, 1) != 8)
        room++;
    return table->ratings[room][way];
}

void app_ugr_table_show(GtkWidget *expander, const luxel_photometry *photometry)
{
    luxel_ugr_table table = {0};
    char across[CELL_SIZE], along[CELL_SIZE];
    if (photometry && luxel_photometry_find_ugr_table(photometry, SPACING, &table) != LUXEL_OK)
        table.exists = false;
    gtk_widget_set_visible(expander, table.exists);
    gtk_expander_set_child(GTK_EXPANDER(expander), table.exists ? new_grid(&table) : NULL);
    if (!table.exists)
        return;
    char *line = g_strdup_printf(_("UGR %s crosswise, %s endwise"), rating_text(quoted(&table, 0)[0], across),
                                 rating_text(quoted(&table, 1)[0], along));
    gtk_expander_set_label(GTK_EXPANDER(expander), line);
    g_free(line);
}

GtkWidget *app_ugr_table_new(void)
{
    GtkWidget *expander = gtk_expander_new(NULL);
    gtk_widget_set_visible(expander, FALSE);
    gtk_widget_set_tooltip_text(
        expander, _("Unified glare rating by the tabular method of CIE 190, luminaires a quarter of their height above "
                    "the eye apart: the line has the room of 4H × 8H with reflectances of 70, 50 and 20 %"));
    return expander;
}
