/* SPDX-License-Identifier: MIT */
/* The light on surfaces that reflect it, below the statistics: the mean on each side, and the balance of the flux. */
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "numbers_private.h"

/* "1 ball, outside", "2 room, floor"; the back of a wall is told, too. */
static char *name_side(const luxel_balance_side *side)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "%zu", side->surface + 1);
    if (side->surface_name)
        g_string_append_printf(text, " %s", side->surface_name);
    if (side->part_name)
        g_string_append_printf(text, ", %s", gettext(side->part_name));
    if (!side->part_name || side->side != LUXEL_SIDE_FRONT)
        g_string_append_printf(text, ", %s", gettext(luxel_surface_side_name(side->side)));
    return g_string_free(text, FALSE);
}

static void add_heading(GtkWidget *grid, int *row, char *text)
{
    GtkWidget *heading = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(heading), 0);
    gtk_label_set_wrap(GTK_LABEL(heading), TRUE);
    gtk_widget_add_css_class(heading, "heading");
    gtk_grid_attach(GTK_GRID(grid), heading, 0, (*row)++, 2, 1);
    g_free(text);
}

static void add_amount(GtkWidget *grid, int *row, const char *words, const luxel_bounded *amount)
{
    char text[APP_AMOUNT_SIZE];
    GtkWidget *name = gtk_label_new(words);
    GtkWidget *value = gtk_label_new(app_amount_write(amount->value, amount->error, text));
    gtk_label_set_xalign(GTK_LABEL(name), 0);
    gtk_label_set_wrap(GTK_LABEL(name), TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(name), TEXT_COLUMNS / 2);
    gtk_label_set_xalign(GTK_LABEL(value), 1);
    gtk_label_set_selectable(GTK_LABEL(value), TRUE);
    gtk_widget_add_css_class(value, "numeric");
    gtk_grid_attach(GTK_GRID(grid), name, 0, *row, 1, 1);
    gtk_grid_attach(GTK_GRID(grid), value, 1, (*row)++, 1, 1);
}

static void add_sides(GtkWidget *grid, int *row, const luxel_balance *balance)
{
    const gboolean is_photometric = strcmp(balance->flux_unit, "lm") == 0;
    add_heading(
        grid, row,
        g_strdup_printf("%s, %s",
                        is_photometric ? _("Mean illuminance of the surfaces") : _("Mean irradiance of the surfaces"),
                        gettext(balance->unit)));
    for (gsize i = 0; i < MIN(balance->side_count, APP_MOST_POINTS); i++) {
        char *name = name_side(&balance->sides[i]);
        add_amount(grid, row, name, &balance->sides[i].irradiance);
        g_free(name);
    }
}

static void add_fluxes(GtkWidget *grid, int *row, const luxel_balance *balance)
{
    add_heading(grid, row, g_strdup_printf("%s, %s", _("Balance of the flux"), gettext(balance->flux_unit)));
    if (balance->has_emitted) {
        add_amount(grid, row, _("given off by the sources"), &balance->emitted);
        add_amount(grid, row, _("of that meets no surface"), &balance->missed);
    }
    add_amount(grid, row, _("arrives at surfaces directly"), &balance->arrives);
    add_amount(grid, row, _("absorbed by surfaces"), &balance->absorbed);
    add_amount(grid, row, _("escapes after reflections"), &balance->escaped);
    if (balance->pending.error > 0)
        add_amount(grid, row, _("reflected after the last bounce"), &balance->pending);
    add_amount(grid, row, _("difference, in truth 0"), &balance->difference);
}

GtkWidget *app_numbers_new_balance(AppNumbers *self)
{
    self->balance = gtk_grid_new();
    gtk_grid_set_column_spacing(GTK_GRID(self->balance), 6);
    gtk_grid_set_row_spacing(GTK_GRID(self->balance), 4);
    gtk_widget_set_visible(self->balance, FALSE);
    return self->balance;
}

void app_numbers_await_balance(AppNumbers *self, gboolean is_coming)
{
    gtk_widget_set_visible(self->balance, is_coming && gtk_widget_get_first_child(self->balance));
}

void app_numbers_show_balance(AppNumbers *self, const luxel_balance *balance)
{
    GtkWidget *grid = self->balance, *child;
    int row = 0;
    while ((child = gtk_widget_get_first_child(grid)))
        gtk_grid_remove(GTK_GRID(grid), child);
    gtk_widget_set_visible(grid, balance != NULL);
    if (!balance)
        return;
    add_sides(grid, &row, balance);
    add_fluxes(grid, &row, balance);
    if (!balance->closes)
        add_heading(grid, &row, g_strdup(_("It does not close within its bounds: some number above is wrong.")));
}
