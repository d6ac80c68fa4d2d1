/* SPDX-License-Identifier: MIT */
/* The page of measuring grids and observers: what was measured, and which limits are kept, with the numbers. */
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "numbers_private.h"

enum { LIMIT_DIGITS = 4 };

static const char *const sign_classes[] = {[LUXEL_PASS] = "kept", [LUXEL_FAIL] = "missed", [LUXEL_UNDECIDED] = "open"};
static const char *const signs[] = {[LUXEL_PASS] = "✓", [LUXEL_FAIL] = "✗", [LUXEL_UNDECIDED] = "?"};

/* ---- lines ---- */

/* A line: a sign, words, which may be as long as there is room for, and a value at the right. */
typedef enum LineKind { LINE_PLAIN, LINE_HEADING, LINE_NOTE } LineKind;

/* The lines while they are filled anew: those that are there already are used again. */
typedef struct Table {
    GtkWidget *box, *next; /* the next line; NULL: there is none yet */
} Table;

static GtkWidget *new_line(Table *table)
{
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *sign = gtk_label_new(NULL);
    GtkWidget *words = gtk_label_new(NULL), *value = gtk_label_new(NULL);
    gtk_label_set_width_chars(GTK_LABEL(sign), 2);
    gtk_label_set_xalign(GTK_LABEL(words), 0);
    gtk_label_set_wrap(GTK_LABEL(words), TRUE);
    gtk_label_set_selectable(GTK_LABEL(value), TRUE);
    gtk_widget_set_hexpand(words, TRUE);
    gtk_widget_set_valign(sign, GTK_ALIGN_START);
    gtk_widget_set_valign(value, GTK_ALIGN_START);
    gtk_widget_add_css_class(value, "numeric");
    gtk_box_append(GTK_BOX(line), sign);
    gtk_box_append(GTK_BOX(line), words);
    gtk_box_append(GTK_BOX(line), value);
    gtk_box_append(GTK_BOX(table->box), line);
    return line;
}

static void choose_class(GtkWidget *widget, const char *class, gboolean has)
{
    if (has)
        gtk_widget_add_css_class(widget, class);
    else
        gtk_widget_remove_css_class(widget, class);
}

/* One line more; `verdict` NULL: it is none of a limit; `value` NULL: the words have all the room. */
static void add_line(Table *table, LineKind kind, const luxel_verdict *verdict, const char *words, const char *value)
{
    GtkWidget *line = table->next ? table->next : new_line(table), *sign = gtk_widget_get_first_child(line);
    GtkWidget *label = gtk_widget_get_next_sibling(sign), *number = gtk_widget_get_last_child(line);
    const char *said = verdict ? gettext(luxel_verdict_word(*verdict)) : "";
    table->next = gtk_widget_get_next_sibling(line);
    app_numbers_set_text(sign, verdict ? signs[*verdict] : "");
    for (gsize i = 0; i < G_N_ELEMENTS(sign_classes); i++)
        choose_class(sign, sign_classes[i], verdict && *verdict == (luxel_verdict)i);
    gtk_widget_set_tooltip_text(sign, verdict ? said : NULL);
    gtk_accessible_update_property(GTK_ACCESSIBLE(sign), GTK_ACCESSIBLE_PROPERTY_LABEL, said, -1);
    app_numbers_set_text(label, words);
    choose_class(label, "heading", kind == LINE_HEADING);
    choose_class(label, "note", kind == LINE_NOTE);
    choose_class(label, "dim-label", kind == LINE_NOTE);
    app_numbers_set_text(number, value ? value : "");
    gtk_widget_set_visible(number, value != NULL);
}

static void add_bounded(Table *table, LineKind kind, const char *words, const luxel_bounded *value)
{
    char amount[APP_AMOUNT_SIZE];
    add_line(table, kind, NULL, words, app_amount_write(value->value, value->error, amount));
}

/* "≥ 500 lx", "≥ 95 %: ≥ 300 lx". */
static char *tell_wanted(const luxel_limit *limit, const char *unit)
{
    char wanted[APP_NUMBER_SIZE], above[APP_NUMBER_SIZE];
    const gboolean has_unit = luxel_limit_has_unit(limit), is_share = strcmp(limit->name, "share") == 0;
    app_number_show(limit->wanted, LIMIT_DIGITS, wanted);
    app_number_show(limit->above, LIMIT_DIGITS, above);
    if (is_share)
        return g_strdup_printf("≥ %s %%: ≥ %s %s", wanted, above, unit);
    return g_strdup_printf("%s %s%s%s", limit->is_most ? "≤" : "≥", wanted, has_unit ? " " : "", has_unit ? unit : "");
}

/* A limit in two lines: whose it is, and below it which it is and the number with its bound. */
static void add_limits(Table *table, const luxel_limit *limits, gsize count, const char *unit)
{
    for (gsize i = 0; i < count; i++) {
        char *wanted = tell_wanted(&limits[i], unit);
        add_line(table, LINE_PLAIN, &limits[i].verdict, gettext(luxel_limit_word(&limits[i])), NULL);
        if (limits[i].has_value)
            add_bounded(table, LINE_NOTE, wanted, &limits[i].value);
        else
            add_line(table, LINE_NOTE, NULL, wanted, "–");
        g_free(wanted);
    }
}

/* ---- what they tell ---- */

static gboolean is_judged(const AppGrid *grid, const char *name)
{
    for (gsize i = 0; i < grid->limit_count; i++)
        if (strcmp(grid->limits[i].name, name) == 0)
            return TRUE;
    return FALSE;
}

/* Numbers that limits tell already are not told twice. */
static void add_grid(Table *table, const AppGrids *grids, gsize i)
{
    const AppGrid *grid = &grids->list[i];
    const luxel_grid *measured = grid->grid;
    const luxel_bounded least = {.value = measured->minimum.value, .error = measured->error};
    const luxel_bounded greatest = {.value = measured->maximum.value, .error = measured->error};
    char *name = app_grid_name(grids, i), evenness[APP_NUMBER_SIZE];
    char *heading = g_strdup_printf("%s, %s", name, gettext(measured->unit));
    add_line(table, LINE_HEADING, NULL, heading, NULL);
    g_free(heading);
    g_free(name);
    add_limits(table, grid->limits, grid->limit_count, gettext(measured->unit));
    if (measured->measured == 0) {
        add_line(table, LINE_PLAIN, NULL, _("no cell has a value"), NULL);
        return;
    }
    if (!is_judged(grid, "average"))
        add_bounded(table, LINE_PLAIN, _("average of the values"), &measured->average);
    if (!is_judged(grid, "minimum"))
        add_bounded(table, LINE_PLAIN, _("minimum"), &least);
    if (!is_judged(grid, "maximum"))
        add_bounded(table, LINE_PLAIN, _("maximum"), &greatest);
    if (!is_judged(grid, "uniformity") && measured->has_evenness)
        add_line(table, LINE_PLAIN, NULL, _("U0 = minimum / average"), app_number_show(measured->u0, 4, evenness));
}

static void add_eye(Table *table, const AppEyes *eyes, gsize i)
{
    const AppEye *eye = &eyes->list[i];
    char *name = app_eye_name(eyes, i);
    add_line(table, LINE_HEADING, NULL, name, NULL);
    g_free(name);
    add_limits(table, eye->limits, eye->limit_count, "");
    if (eye->limit_count == 0 && eye->has_rating)
        add_bounded(table, LINE_PLAIN, "UGR", &eye->rating);
    else if (eye->limit_count == 0)
        add_line(table, LINE_PLAIN, NULL, "UGR", "–");
}

/* Which of all limits are kept stands above the others. */
static void add_summary(Table *table, const AppGrids *grids, const AppEyes *eyes, gboolean is_coming)
{
    gsize counts[LUXEL_UNDECIDED + 1] = {0};
    for (gsize i = 0; i < grids->count; i++)
        for (gsize k = 0; k < grids->list[i].limit_count; k++)
            counts[grids->list[i].limits[k].verdict]++;
    for (gsize i = 0; eyes && i < eyes->count; i++)
        for (gsize k = 0; k < eyes->list[i].limit_count; k++)
            counts[eyes->list[i].limits[k].verdict]++;
    const gsize all = counts[LUXEL_PASS] + counts[LUXEL_FAIL] + counts[LUXEL_UNDECIDED];
    const gboolean is_open = counts[LUXEL_UNDECIDED] > 0 || is_coming;
    const luxel_verdict verdict = counts[LUXEL_FAIL] > 0 ? LUXEL_FAIL : is_open ? LUXEL_UNDECIDED : LUXEL_PASS;
    if (all == 0)
        return;
    char *text = g_strdup_printf(is_coming ? _("%zu of %zu limits kept so far") : _("%zu of %zu limits kept"),
                                 counts[LUXEL_PASS], all);
    add_line(table, LINE_HEADING, &verdict, text, NULL);
    g_free(text);
}

/* Takes the lines away that are left over. */
static void cut(Table *table)
{
    while (table->next) {
        GtkWidget *line = table->next;
        table->next = gtk_widget_get_next_sibling(line);
        gtk_box_remove(GTK_BOX(table->box), line);
    }
}

static void fill(AppNumbers *self)
{
    Table table = {.box = self->lighting, .next = gtk_widget_get_first_child(self->lighting)};
    const AppGrids *grids = self->grids;
    const gboolean has_eyes = grids && self->eyes && self->eyes->moment->serial == grids->moment->serial;
    const AppEyes *eyes = has_eyes ? self->eyes : NULL;
    const gboolean is_coming = grids && !eyes && luxel_scene_observer_count(grids->moment->scene) > 0;
    if (grids)
        add_summary(&table, grids, eyes, is_coming);
    else
        add_line(&table, LINE_PLAIN, NULL, _("The grids of this scene cannot be measured"), NULL);
    for (gsize i = 0; grids && i < grids->count; i++)
        add_grid(&table, grids, i);
    for (gsize i = 0; eyes && i < eyes->count; i++)
        add_eye(&table, eyes, i);
    if (is_coming)
        add_line(&table, LINE_NOTE, NULL, _("What observers see is being rated…"), NULL);
    cut(&table);
}

GtkWidget *app_numbers_new_lighting(AppNumbers *self)
{
    GtkWidget *scrolled = gtk_scrolled_window_new();
    self->lighting = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), self->lighting);
    return scrolled;
}

void app_numbers_show_lighting(AppNumbers *self, AppGrids *grids, AppEyes *eyes, guint64 serial)
{
    if (eyes) {
        app_eyes_unref(self->eyes);
        self->eyes = app_eyes_ref(eyes);
    } else {
        app_grids_ref(grids);
        app_grids_unref(self->grids);
        self->grids = grids;
    }
    fill(self);
    app_numbers_follow_lighting(self, serial);
}

void app_numbers_forget_lighting(AppNumbers *self)
{
    g_clear_pointer(&self->grids, app_grids_unref);
    g_clear_pointer(&self->eyes, app_eyes_unref);
    cut(&(Table){.box = self->lighting, .next = gtk_widget_get_first_child(self->lighting)});
}
