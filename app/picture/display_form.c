/* SPDX-License-Identifier: MIT */
/* Rows for an AppDisplay. */
#include "display_form.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "../base/row.h"

enum { DIGITS = 6 };

typedef enum Field {
    FIELD_CHANNEL,
    FIELD_PALETTE,
    FIELD_LOGARITHMIC,
    FIELD_LOCKED,
    FIELD_LOW,
    FIELD_HIGH,
    FIELD_EXPOSURE,
    FIELD_BACKGROUND,
    FIELD_OUTLINE,
    FIELD_ISOPHOTES,
    FIELD_MAXIMUM,
    FIELD_MARKS,
    FIELDS
} Field;

static const struct {
    AppRowKind kind;
    const char *label, *meaning;
} fields[FIELDS] = {
    [FIELD_CHANNEL] = {APP_ROW_CHOICE, N_("Channel"),
                       N_("What is shown of a picture in colour: its colours, which in false colour are the luminance, "
                          "or one number of each pixel")},
    [FIELD_PALETTE] = {APP_ROW_CHOICE, N_("Colours"),
                       N_("The colours of the values; what is saved as grey PNG stays grey")},
    [FIELD_LOGARITHMIC] = {APP_ROW_SWITCH, N_("Logarithmic"),
                           N_("Colours by the logarithm of the value, over four decades")},
    [FIELD_LOCKED] = {APP_ROW_SWITCH, N_("Range locked"),
                      N_("The same range for every picture; else from 0 to each one's maximum")},
    [FIELD_LOW] = {APP_ROW_NUMBER, N_("From"), N_("The value of the first colour")},
    [FIELD_HIGH] = {APP_ROW_NUMBER, N_("To"), N_("The value of the last colour")},
    [FIELD_EXPOSURE] = {APP_ROW_NUMBER, N_("Exposure"),
                        N_("Each stop doubles what is shown; E brighter, Shift+E darker, R resets")},
    [FIELD_BACKGROUND] = {APP_ROW_CHOICE, N_("Background"), N_("The colour where no surface is seen")},
    [FIELD_OUTLINE] = {APP_ROW_SWITCH, N_("Outline"), N_("A line around the surfaces, which shows their dark limb")},
    [FIELD_ISOPHOTES] = {APP_ROW_SWITCH, N_("Isophotes"), N_("Lines of equal value")},
    [FIELD_MAXIMUM] = {APP_ROW_SWITCH, N_("Mark the maximum"), N_("A cross at the brightest pixel")},
    [FIELD_MARKS] = {APP_ROW_SWITCH, N_("Show marks"), N_("Sources, points and sections on the picture")},
};

static const char *const channels[APP_CHANNELS] = {
    [APP_CHANNEL_COLORS] = N_("its colours"),
    [APP_CHANNEL_LUMINANCE] = N_("luminance"),
    [APP_CHANNEL_RED] = N_("red"),
    [APP_CHANNEL_GREEN] = N_("green"),
    [APP_CHANNEL_BLUE] = N_("blue"),
    [APP_CHANNEL_CCT] = N_("colour temperature"),
};

static const struct {
    const char *name;
    double color[3];
} backgrounds[] = {
    {N_("black"), {0, 0, 0}},
    {N_("dark"), {0.12, 0.13, 0.16}},
    {N_("grey"), {0.5, 0.5, 0.5}},
    {N_("white"), {1, 1, 1}},
};

struct _AppDisplayForm {
    GtkBox parent;
    AppDisplay display;
    double low, high; /* of the picture */
    GtkWidget *rows[FIELDS];
};

enum { CHANGED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppDisplayForm, app_display_form, GTK_TYPE_BOX)

const char *app_palette_named(const char *name)
{
    for (gsize i = 0; luxel_palette_name(i); i++)
        if (strcmp(luxel_palette_name(i), name) == 0)
            return luxel_palette_name(i);
    return NULL;
}

static void show_number(AppDisplayForm *self, Field field, double number)
{
    char text[APP_NUMBER_SIZE];
    app_row_set(APP_ROW(self->rows[field]), app_number_write(number, text));
}

static void show_switch(AppDisplayForm *self, Field field, gboolean on)
{
    app_row_set(APP_ROW(self->rows[field]), on ? "true" : "false");
}

/* What was typed as it is, what is the picture's rounded. */
static void show_range(AppDisplayForm *self)
{
    char text[APP_NUMBER_SIZE];
    const gboolean locked = self->display.is_locked;
    const double bounds[] = {locked ? self->display.low : self->low, locked ? self->display.high : self->high};
    for (int i = 0; i < 2; i++)
        app_row_set(APP_ROW(self->rows[FIELD_LOW + i]),
                    locked ? app_number_write(bounds[i], text) : app_number_round(bounds[i], DIGITS, text));
}

static void refresh(AppDisplayForm *self)
{
    const AppDisplay *display = &self->display;
    app_row_set(APP_ROW(self->rows[FIELD_CHANNEL]), _(channels[display->channel]));
    app_row_set(APP_ROW(self->rows[FIELD_PALETTE]), display->palette);
    for (gsize i = 0; i < G_N_ELEMENTS(backgrounds); i++)
        if (memcmp(backgrounds[i].color, display->background, sizeof display->background) == 0)
            app_row_set(APP_ROW(self->rows[FIELD_BACKGROUND]), _(backgrounds[i].name));
    show_switch(self, FIELD_LOGARITHMIC, display->logarithmic);
    show_switch(self, FIELD_LOCKED, display->is_locked);
    show_range(self);
    show_number(self, FIELD_EXPOSURE, display->exposure);
    show_switch(self, FIELD_OUTLINE, display->outline);
    show_switch(self, FIELD_ISOPHOTES, display->isophotes);
    show_switch(self, FIELD_MAXIMUM, display->maximum);
    show_switch(self, FIELD_MARKS, display->marks);
}

static void changed(AppDisplayForm *self)
{
    refresh(self);
    g_signal_emit(self, signals[CHANGED], 0);
}

/* Typing a bound locks the range, the other bound being what it is now. */
static void set_bound(AppDisplayForm *self, Field field, double value)
{
    double low = self->display.is_locked ? self->display.low : self->low;
    double high = self->display.is_locked ? self->display.high : self->high;
    if (field == FIELD_LOW)
        low = value;
    else
        high = value;
    if (!(low < high)) {
        app_row_set_fault(APP_ROW(self->rows[field]), _("the range must go from a smaller value to a greater one"));
        return;
    }
    self->display.is_locked = TRUE;
    self->display.low = low;
    self->display.high = high;
}

static void lock(AppDisplayForm *self, gboolean locked)
{
    self->display.is_locked = locked;
    if (locked) {
        self->display.low = self->low;
        self->display.high = self->high;
    }
}

static void edited(AppRow *row, const char *yaml, AppDisplayForm *self)
{
    const double number = g_ascii_strtod(yaml, NULL);
    const gboolean on = strcmp(yaml, "true") == 0;
    Field field = 0;
    while (self->rows[field] != GTK_WIDGET(row))
        field++;
    app_row_set_fault(row, NULL);
    switch (field) {
    case FIELD_CHANNEL:
        for (gsize i = 0; i < G_N_ELEMENTS(channels); i++)
            if (strcmp(_(channels[i]), yaml) == 0)
                self->display.channel = (AppChannel)i;
        break;
    case FIELD_PALETTE: self->display.palette = app_palette_named(yaml); break;
    case FIELD_LOGARITHMIC: self->display.logarithmic = on; break;
    case FIELD_LOCKED: lock(self, on); break;
    case FIELD_LOW:
    case FIELD_HIGH: set_bound(self, field, number); break;
    case FIELD_EXPOSURE: self->display.exposure = number; break;
    case FIELD_BACKGROUND:
        for (gsize i = 0; i < G_N_ELEMENTS(backgrounds); i++)
            if (strcmp(_(backgrounds[i].name), yaml) == 0)
                memcpy(self->display.background, backgrounds[i].color, sizeof backgrounds[i].color);
        break;
    case FIELD_OUTLINE: self->display.outline = on; break;
    case FIELD_ISOPHOTES: self->display.isophotes = on; break;
    case FIELD_MAXIMUM: self->display.maximum = on; break;
    case FIELD_MARKS: self->display.marks = on; break;
    case FIELDS: break;
    }
    changed(self);
}

const AppDisplay *app_display_form_get(AppDisplayForm *self)
{
    return &self->display;
}

void app_display_form_set(AppDisplayForm *self, const AppDisplay *display)
{
    self->display = *display;
    changed(self);
}

void app_display_form_tell_range(AppDisplayForm *self, double low, double high)
{
    if (low == self->low && high == self->high)
        return;
    self->low = low;
    self->high = high;
    if (!self->display.is_locked)
        show_range(self);
}

void app_display_form_tell_color(AppDisplayForm *self, gboolean colored)
{
    gtk_widget_set_visible(self->rows[FIELD_CHANNEL], colored);
}

void app_display_form_expose(AppDisplayForm *self, double stops)
{
    self->display.exposure = CLAMP(self->display.exposure + stops, -40, 40);
    changed(self);
}

void app_display_form_normalise(AppDisplayForm *self)
{
    lock(self, TRUE);
    self->display.exposure = 0;
    changed(self);
}

void app_display_form_reset(AppDisplayForm *self)
{
    self->display.exposure = 0;
    self->display.is_locked = FALSE;
    changed(self);
}

static void app_display_form_class_init(AppDisplayFormClass *class)
{
    (void)class;
    signals[CHANGED] =
        g_signal_new("changed", APP_TYPE_DISPLAY_FORM, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

/* The words of a list that has one for each i. */
static char *join(const char *(*name)(gsize i))
{
    GString *words = g_string_new(NULL);
    for (gsize i = 0; name(i); i++)
        g_string_append_printf(words, "%s%s", i ? ", " : "", name(i));
    return g_string_free(words, FALSE);
}

static const char *channel_name(gsize i)
{
    return i < G_N_ELEMENTS(channels) ? _(channels[i]) : NULL;
}

static const char *background_name(gsize i)
{
    return i < G_N_ELEMENTS(backgrounds) ? _(backgrounds[i].name) : NULL;
}

static void app_display_form_init(AppDisplayForm *self)
{
    char *palettes = join(luxel_palette_name), *grounds = join(background_name), *views = join(channel_name);
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 4);
    app_display_init(&self->display);
    self->high = 1;
    for (int i = 0; i < FIELDS; i++) {
        AppRowSpec spec = {.kind = fields[i].kind,
                           .label = _(fields[i].label),
                           .meaning = _(fields[i].meaning),
                           .choices = i == FIELD_PALETTE   ? palettes
                                      : i == FIELD_CHANNEL ? views
                                                           : grounds};
        if (i == FIELD_EXPOSURE) {
            spec.legal = (luxel_parameter_range){TRUE, -40, 40, FALSE};
            spec.advised = (luxel_parameter_range){TRUE, -10, 10, FALSE};
            spec.unit = _("stops");
        }
        self->rows[i] = app_row_new(&spec);
        g_signal_connect(self->rows[i], "edited", G_CALLBACK(edited), self);
        gtk_box_append(GTK_BOX(self), self->rows[i]);
    }
    g_free(palettes);
    g_free(grounds);
    g_free(views);
    app_display_form_tell_color(self, FALSE);
    refresh(self);
}

GtkWidget *app_display_form_new(void)
{
    return g_object_new(APP_TYPE_DISPLAY_FORM, NULL);
}
