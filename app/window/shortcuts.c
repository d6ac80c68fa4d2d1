/* SPDX-License-Identifier: MIT */
/*
 * The list of keys.  GTK has a window for such lists, too, but that of 4.8 complains of its own labels, which is an end
 * where warnings are fatal.
 */
#include "shortcuts.h"

#include "../../front/words.h"
#include "dialog.h"

enum { MARGIN = 16, COLUMNS = 2, HALF = 3 /* groups in the first column */ };

/* A line without keys is the title of a group. */
static const struct {
    const char *keys, *meaning;
} lines[] = {
    {NULL, N_("Scene")},
    {"F2", N_("Pictures of the scenes")},
    {"Ctrl+O", N_("Open")},
    {"Ctrl+S", N_("Save the scene")},
    {"Ctrl+Shift+S", N_("Save as")},
    {"Ctrl+E", N_("Save the picture as 8-bit grey PNG")},
    {"Ctrl+Z", N_("Undo")},
    {"Ctrl+Shift+Z", N_("Redo")},
    {"Ctrl+N", N_("A new window")},
    {"Ctrl+W", N_("Close the window")},
    {"Ctrl+Q", N_("Quit")},
    {NULL, N_("Sources and points")},
    {"Ctrl+D", N_("Duplicate the source")},
    {"Ctrl+Delete", N_("Delete the source")},
    {"1 … 9", N_("Choose the source of this number")},
    {"Alt+1 … 9", N_("Why? at the point P1 … P9")},
    {N_("Ctrl+click, Shift+click"), N_("Choose one more source, in the list or on the picture")},
    {"Alt+↑, Alt+↓", N_("Move the source in the list")},
    {"Ctrl+V", N_("Paste sources “x, y, z; …” or points “x, y; …”")},
    {"Ctrl+K", N_("Search the form")},
    {"Esc", N_("In a field: back to the value that holds")},
    {NULL, N_("General")},
    {"F9", N_("Numbers at the side")},
    {"F6, Shift+F6", N_("To the next pane, to the one before")},
    {"Ctrl+1, Ctrl+2, Ctrl+3", N_("To the scene, the picture, the numbers")},
    {"F10", N_("Main menu")},
    {"F1", N_("Keyboard shortcuts")},
    {NULL, N_("Picture")},
    {"S", N_("The scene in space, or the picture")},
    {"F", N_("Fit the picture")},
    {"Ctrl+0", N_("One pixel to one pixel")},
    {N_("+, −, wheel"), N_("Zoom")},
    {"E, Shift+E", N_("Brighter, darker by half a stop")},
    {"N", N_("Lock the range to this picture")},
    {"R", N_("Reset exposure and range")},
    {"C", N_("False colour or grey")},
    {"I", N_("Isophotes")},
    {"P", N_("Pin the picture as A")},
    {"D", N_("Show live B, pinned A or the difference in turn")},
    {"W", N_("Why? The value where the pointer rests, and its formula")},
    {N_("double click"), N_("Why? at this place")},
    {NULL, N_("Marks on the picture")},
    {"[, ]", N_("Go from mark to mark")},
    {"← → ↑ ↓", N_("Move the mark by 10 mm (Shift: 1 mm, Ctrl: 100 mm)")},
    {"Page Up, Page Down", N_("Raise or lower the mark")},
    {N_("Alt+wheel"), N_("Raise or lower the source under the pointer, or the chosen one")},
    {"Alt", N_("While dragging: raise or lower")},
    {"Shift", N_("While dragging: a tenth of the motion")},
    {"Ctrl", N_("While dragging: to round numbers")},
};

static GtkWidget *new_label(const char *text, const char *style)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    if (style)
        gtk_widget_add_css_class(label, style);
    return label;
}

static GtkWidget *new_list(void)
{
    GtkWidget *columns = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2 * MARGIN), *grid = NULL;
    int groups = 0, row = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++) {
        if (!lines[i].keys && groups++ % HALF == 0) {
            grid = gtk_grid_new();
            gtk_grid_set_column_spacing(GTK_GRID(grid), MARGIN);
            gtk_grid_set_row_spacing(GTK_GRID(grid), MARGIN / 4);
            gtk_box_append(GTK_BOX(columns), grid);
            row = 0;
        }
        if (!lines[i].keys)
            gtk_grid_attach(GTK_GRID(grid), new_label(_(lines[i].meaning), "heading"), 0, row++, COLUMNS, 1);
        else {
            gtk_grid_attach(GTK_GRID(grid), new_label(_(lines[i].keys), "numeric"), 0, row, 1, 1);
            gtk_grid_attach(GTK_GRID(grid), new_label(_(lines[i].meaning), NULL), 1, row++, 1, 1);
        }
    }
    return columns;
}

void app_shortcuts_show(GtkWindow *parent)
{
    gtk_window_present(GTK_WINDOW(app_dialog_frame(parent, _("Keyboard shortcuts"), new_list())));
}
