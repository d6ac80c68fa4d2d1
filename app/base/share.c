/* SPDX-License-Identifier: MIT */
/* The numbers stand at the end of the bar, whose track is always there.  Both are drawn by hand: a pointer that moves
 * must change a few dots only, and no layout. */
#include "share.h"

#include <math.h>

#include "../../front/words.h"
#include "lamp.h"
#include "number.h"

enum { HEIGHT = 15, BAR = 4, LEAST_BAR = 40, WIDE = 190, NUMBER_WIDTH = 50, PERCENT_WIDTH = 44, GAP = 4 };

struct _AppShare {
    GtkWidget parent;
    gsize light;
    double share, whole;
};

G_DEFINE_FINAL_TYPE(AppShare, app_share, GTK_TYPE_WIDGET)

/* A share of the whole, 0 to 1; light cannot be taken away, so rounding alone goes beyond. */
static double part_of(const AppShare *self)
{
    return self->whole > 0 ? CLAMP(self->share / self->whole, 0, 1) : 0;
}

/* A text that ends at a place; where it begins. */
static double draw_text(GtkWidget *widget, GtkSnapshot *snapshot, const char *text, double right)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, text);
    GdkRGBA ink;
    int width, height;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    pango_layout_get_pixel_size(layout, &width, &height);
    gtk_snapshot_save(snapshot);
    gtk_snapshot_translate(snapshot, &GRAPHENE_POINT_INIT((float)(right - width), (HEIGHT - (float)height) / 2));
    gtk_snapshot_append_layout(snapshot, layout, &ink);
    gtk_snapshot_restore(snapshot);
    g_object_unref(layout);
    return right - width;
}

static void app_share_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    const AppShare *self = APP_SHARE(widget);
    const float width = (float)gtk_widget_get_width(widget), top = (HEIGHT - BAR) / 2.0f;
    const float wanted = PERCENT_WIDTH + GAP + (width > WIDE ? NUMBER_WIDTH + GAP : 0);
    const float length = MAX(width - wanted, LEAST_BAR);
    const double part = part_of(self);
    char number[APP_NUMBER_SIZE], percent[APP_NUMBER_SIZE];
    double color[3];
    GdkRGBA ink;
    if (width < 1)
        return;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    ink.alpha = 0.14f;
    gtk_snapshot_append_color(snapshot, &ink, &GRAPHENE_RECT_INIT(0, top, length, BAR));
    if (!isfinite(self->share))
        return;
    app_lamp_color(self->light, color);
    const GdkRGBA fill = {(float)color[0], (float)color[1], (float)color[2], 1};
    gtk_snapshot_append_color(snapshot, &fill, &GRAPHENE_RECT_INIT(0, top, length * (float)part, BAR));
    g_snprintf(percent, sizeof percent, "%.*f %%", part < 0.9995 ? 1 : 0, 100 * part); /* "100.0 %" is too wide */
    const double left = draw_text(widget, snapshot, app_number_mark(percent), (double)width);
    const double end = MIN((double)width - PERCENT_WIDTH, left - GAP);
    if (end > (double)length + NUMBER_WIDTH) /* else there is room for the share alone */
        draw_text(widget, snapshot, app_number_show(self->share, 4, number), end);
}

static void app_share_measure(GtkWidget *widget, GtkOrientation orientation, int size, int *least, int *natural,
                              int *least_baseline, int *natural_baseline)
{
    (void)widget;
    (void)size;
    *least = *natural = orientation == GTK_ORIENTATION_VERTICAL ? HEIGHT : LEAST_BAR + PERCENT_WIDTH + GAP;
    *least_baseline = *natural_baseline = -1;
}

static void app_share_class_init(AppShareClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    widget->snapshot = app_share_snapshot;
    widget->measure = app_share_measure;
    gtk_widget_class_set_css_name(widget, "share");
    gtk_widget_class_set_accessible_role(widget, GTK_ACCESSIBLE_ROLE_METER);
}

static void app_share_init(AppShare *self)
{
    self->share = (double)NAN;
}

static void tell(AppShare *self)
{
    char number[APP_NUMBER_SIZE];
    char *text = isfinite(self->share) ? g_strdup_printf(_("Share %s, %.1f %%"),
                                                         app_number_show(self->share, 4, number), 100 * part_of(self))
                                       : g_strdup(_("Share"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
    g_free(text);
}

void app_share_set(AppShare *self, double share, double whole)
{
    if ((share == self->share && whole == self->whole) || (isnan(share) && isnan(self->share)))
        return;
    self->share = share;
    self->whole = whole;
    gtk_widget_queue_draw(GTK_WIDGET(self));
    tell(self);
}

GtkWidget *app_share_new(gsize light)
{
    AppShare *self = g_object_new(APP_TYPE_SHARE, NULL);
    self->light = light;
    tell(self);
    return GTK_WIDGET(self);
}
