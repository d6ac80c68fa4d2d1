/* SPDX-License-Identifier: MIT */
/* Each mark is a small drawing of its own, so that little is painted anew when the picture is. */
#include "view_draw.h"

#include <math.h>
#include <string.h>

#include "../base/lamp.h"

enum { MARK_ROOM = 14, EDGE = 16, DIRECTIONS = 64, SEAM = 2, BESIDE = 8, MOST_NAMES = 512 };

/* What is drawn once and then copied: a mark costs more to draw than to put on the screen. */
typedef enum Shape { SHAPE_LAMP, SHAPE_SUN, SHAPE_ARROW, SHAPE_POINT, SHAPE_MAXIMUM, SHAPE_RING } Shape;

typedef struct Look {
    Shape shape;
    gsize light;   /* whose it is, of a source */
    int direction; /* of an arrow, of DIRECTIONS */
    gboolean is_on, selected;
    int dots; /* for a pixel */
} Look;

void app_map_to_widget(const AppMap *map, const double place_mm[2], double at[2])
{
    at[0] = map->origin[0] + place_mm[0] * map->scale;
    at[1] = map->origin[1] - place_mm[1] * map->scale;
}

void app_map_from_widget(const AppMap *map, const double at[2], double place_mm[2])
{
    place_mm[0] = (at[0] - map->origin[0]) / map->scale;
    place_mm[1] = (map->origin[1] - at[1]) / map->scale;
}

gboolean app_mark_shown(const AppMap *map, const AppMark *mark, double width, double height, double at[2],
                        double *angle)
{
    app_map_to_widget(map, mark->screen_mm, at);
    gboolean inside = at[0] >= EDGE && at[0] <= width - EDGE && at[1] >= EDGE && at[1] <= height - EDGE;
    if (inside || mark->kind != APP_MARK_SOURCE)
        return FALSE;
    /* on the line from the middle, as far out as the edge allows */
    double middle[2] = {width / 2, height / 2}, out[2] = {at[0] - middle[0], at[1] - middle[1]};
    double share = MIN((middle[0] - EDGE) / MAX(fabs(out[0]), 1e-9), (middle[1] - EDGE) / MAX(fabs(out[1]), 1e-9));
    *angle = atan2(out[1], out[0]);
    for (int k = 0; k < 2; k++)
        at[k] = middle[k] + out[k] * MIN(share, 1);
    return TRUE;
}

/* A dark seam under a light line shows on black, white and every colour between. */
static void stroke(cairo_t *cairo, double width, double red, double green, double blue)
{
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.65);
    cairo_set_line_width(cairo, width + 2);
    cairo_stroke_preserve(cairo);
    cairo_set_source_rgb(cairo, red, green, blue);
    cairo_set_line_width(cairo, width);
    cairo_stroke(cairo);
}

static void draw_lamp(cairo_t *cairo, const Look *look)
{
    const AppBadge badge = {.light = look->light, .is_on = look->is_on, .selected = look->selected};
    double color[3];
    app_lamp_color(look->light, color);
    for (int i = 0; i < 8; i++) {
        const double angle = (i + 0.5) * G_PI / 4, outer = look->shape == SHAPE_SUN ? 13 : 11.5;
        cairo_move_to(cairo, 9 * cos(angle), 9 * sin(angle));
        cairo_line_to(cairo, outer * cos(angle), outer * sin(angle));
    }
    stroke(cairo, look->shape == SHAPE_SUN ? 2 : 1.2, color[0], color[1], color[2]);
    app_lamp_draw_badge(cairo, &badge);
}

static void draw_arrow(cairo_t *cairo, const Look *look)
{
    double color[3];
    app_lamp_color(look->light, color);
    cairo_rotate(cairo, 2 * G_PI * look->direction / DIRECTIONS);
    cairo_move_to(cairo, 11, 0);
    cairo_line_to(cairo, -5, -8);
    cairo_line_to(cairo, -1, 0);
    cairo_line_to(cairo, -5, 8);
    cairo_close_path(cairo);
    cairo_set_source_rgba(cairo, color[0], color[1], color[2], look->is_on ? 1 : 0.15);
    cairo_fill_preserve(cairo);
    if (look->selected)
        stroke(cairo, 2, 1, 1, 1);
    else
        stroke(cairo, 1, color[0], color[1], color[2]);
}

static void draw_cross(cairo_t *cairo, gboolean selected)
{
    for (int i = 0; i < 4; i++) {
        const int x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
        cairo_move_to(cairo, 3 * x[i], 3 * y[i]);
        cairo_line_to(cairo, 9 * x[i], 9 * y[i]);
    }
    stroke(cairo, selected ? 2.2 : 1.4, 0.55, 0.85, 1);
}

static void draw_maximum(cairo_t *cairo)
{
    cairo_move_to(cairo, -5, -5);
    cairo_line_to(cairo, 5, 5);
    cairo_move_to(cairo, -5, 5);
    cairo_line_to(cairo, 5, -5);
    stroke(cairo, 1.6, 1, 0.35, 0.3);
}

/* Around the mark that the pointer is on. */
static void draw_ring(cairo_t *cairo)
{
    cairo_arc(cairo, 0, 0, MARK_ROOM - 2, 0, 2 * G_PI);
    stroke(cairo, 1.6, 1, 1, 1);
}

static void draw_shape(cairo_t *cairo, const Look *look)
{
    if (look->shape == SHAPE_ARROW)
        draw_arrow(cairo, look);
    else if (look->shape == SHAPE_POINT)
        draw_cross(cairo, look->selected);
    else if (look->shape == SHAPE_MAXIMUM)
        draw_maximum(cairo);
    else if (look->shape == SHAPE_RING)
        draw_ring(cairo);
    else
        draw_lamp(cairo, look);
}

static void free_pixels(gpointer surface)
{
    cairo_surface_destroy(surface);
}

/* Takes the surface over. */
static GdkTexture *texture_of_surface(cairo_surface_t *surface)
{
    cairo_surface_flush(surface);
    const int stride = cairo_image_surface_get_stride(surface), height = cairo_image_surface_get_height(surface);
    GBytes *pixels = g_bytes_new_with_free_func(cairo_image_surface_get_data(surface), (gsize)stride * (gsize)height,
                                                free_pixels, surface);
    GdkTexture *texture = gdk_memory_texture_new(cairo_image_surface_get_width(surface), height, GDK_MEMORY_DEFAULT,
                                                 pixels, (gsize)stride);
    g_bytes_unref(pixels);
    return texture;
}

static GdkTexture *new_texture(const Look *look)
{
    const int side = 2 * MARK_ROOM * look->dots;
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, side, side);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, look->dots, look->dots);
    cairo_translate(cairo, MARK_ROOM, MARK_ROOM);
    draw_shape(cairo, look);
    cairo_destroy(cairo);
    return texture_of_surface(surface);
}

/* Textures of a widget, kept as long as it lives; the key is all of a look. */
static GdkTexture *texture_of(GtkWidget *widget, const Look *look)
{
    static const char name[] = "luxel-marks";
    enum { MOST_DOTS = 8 };
    const guint shape = (guint)(((look->dots % MOST_DOTS) * DIRECTIONS + look->direction) * 8 + (int)look->shape);
    const guint key = (((guint)look->light * MOST_DOTS * DIRECTIONS * 8 + shape) * 8) + (app_lamp_is_dark() ? 4 : 0) +
                      (look->is_on ? 2 : 0) + (look->selected ? 1 : 0);
    GHashTable *textures = g_object_get_data(G_OBJECT(widget), name);
    if (!textures) {
        textures = g_hash_table_new_full(g_direct_hash, g_direct_equal, NULL, g_object_unref);
        g_object_set_data_full(G_OBJECT(widget), name, textures, (GDestroyNotify)g_hash_table_unref);
    }
    GdkTexture *texture = g_hash_table_lookup(textures, GUINT_TO_POINTER(key));
    if (!texture) {
        texture = new_texture(look);
        g_hash_table_insert(textures, GUINT_TO_POINTER(key), texture);
    }
    return texture;
}

static void put_shape(GtkSnapshot *snapshot, GtkWidget *widget, const double at[2], Look look)
{
    look.dots = gtk_widget_get_scale_factor(widget);
    const double x = round((at[0] - MARK_ROOM) * look.dots) / look.dots;
    const double y = round((at[1] - MARK_ROOM) * look.dots) / look.dots;
    gtk_snapshot_append_texture(snapshot, texture_of(widget, &look),
                                &GRAPHENE_RECT_INIT((float)x, (float)y, 2 * MARK_ROOM, 2 * MARK_ROOM));
}

/* A name with a dark seam, which makes it readable on every ground. */
static GdkTexture *new_name(GtkWidget *widget, const char *name, const GdkRGBA *color, int dots)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, name);
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (width + 2 * SEAM) * dots, (height + 2 * SEAM) * dots);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, dots, dots);
    cairo_move_to(cairo, SEAM, SEAM);
    pango_cairo_layout_path(cairo, layout);
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.75);
    cairo_set_line_width(cairo, 2.5);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke_preserve(cairo);
    gdk_cairo_set_source_rgba(cairo, color);
    cairo_fill(cairo);
    cairo_destroy(cairo);
    g_object_unref(layout);
    return texture_of_surface(surface);
}

/* The textures of names are kept, as laying out texts is what costs; of a few hundred only, as names change. */
static GdkTexture *name_of(GtkWidget *widget, const char *name, const GdkRGBA *color, int dots)
{
    static const char kept[] = "luxel-names";
    GHashTable *textures = g_object_get_data(G_OBJECT(widget), kept);
    char *key = g_strdup_printf("%d %.2f %s", dots, (double)color->red, name);
    if (!textures || g_hash_table_size(textures) > MOST_NAMES) {
        textures = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_object_unref);
        g_object_set_data_full(G_OBJECT(widget), kept, textures, (GDestroyNotify)g_hash_table_unref);
    }
    GdkTexture *texture = g_hash_table_lookup(textures, key);
    if (texture) {
        g_free(key);
        return texture;
    }
    texture = new_name(widget, name, color, dots);
    g_hash_table_insert(textures, key, texture);
    return texture;
}

/* Beside the mark, on its other side where the edge is near. */
static void draw_name(GtkSnapshot *snapshot, GtkWidget *widget, const double at[2], const char *name,
                      const GdkRGBA *color)
{
    const int dots = gtk_widget_get_scale_factor(widget);
    GdkTexture *texture = name_of(widget, name, color, dots);
    const double width = (double)gdk_texture_get_width(texture) / dots;
    const double height = (double)gdk_texture_get_height(texture) / dots;
    double x = at[0] + BESIDE, y = at[1] + BESIDE / 2.0;
    if (x + width > gtk_widget_get_width(widget))
        x = at[0] - BESIDE - width;
    if (y + height > gtk_widget_get_height(widget))
        y = at[1] - BESIDE / 2.0 - height;
    gtk_snapshot_append_texture(snapshot, texture,
                                &GRAPHENE_RECT_INIT((float)(round(x * dots) / dots), (float)(round(y * dots) / dots),
                                                    (float)width, (float)height));
}

void app_draw_text(GtkSnapshot *snapshot, GtkWidget *widget, const double middle[2], const char *text)
{
    static const GdkRGBA white = {1, 1, 1, 1};
    const int dots = gtk_widget_get_scale_factor(widget);
    GdkTexture *texture = name_of(widget, text, &white, dots);
    const double width = (double)gdk_texture_get_width(texture) / dots;
    const double height = (double)gdk_texture_get_height(texture) / dots;
    gtk_snapshot_append_texture(snapshot, texture,
                                &GRAPHENE_RECT_INIT((float)(round((middle[0] - width / 2) * dots) / dots),
                                                    (float)(round((middle[1] - height / 2) * dots) / dots),
                                                    (float)width, (float)height));
}

void app_draw_mark(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppMark *mark, gboolean selected,
                   gboolean hovered)
{
    static const GdkRGBA of_points = {0.65f, 0.9f, 1, 1}, of_lamps = {1, 1, 1, 1}, of_dark = {0.8f, 0.8f, 0.8f, 1};
    double at[2], angle;
    gboolean arrow = app_mark_shown(map, mark, gtk_widget_get_width(widget), gtk_widget_get_height(widget), at, &angle);
    if (mark->kind == APP_MARK_SURFACE)
        return;
    Look look = {.shape = mark->is_distant ? SHAPE_SUN : SHAPE_LAMP,
                 .light = mark->index,
                 .is_on = mark->is_on && !mark->is_behind,
                 .selected = selected};
    if (mark->kind == APP_MARK_POINT)
        look = (Look){.shape = SHAPE_POINT, .selected = selected};
    if (arrow) {
        look.shape = SHAPE_ARROW;
        look.direction = ((int)round(angle / (2 * G_PI) * DIRECTIONS) + DIRECTIONS) % DIRECTIONS;
    }
    put_shape(snapshot, widget, at, look);
    if (hovered)
        put_shape(snapshot, widget, at, (Look){.shape = SHAPE_RING});
    /* a badge has its number in it already */
    const char *name = mark->kind == APP_MARK_SOURCE && !arrow ? strchr(mark->label, ' ') : mark->label;
    if (!name)
        return;
    draw_name(snapshot, widget, at, name,
              mark->kind == APP_MARK_POINT ? &of_points
              : look.is_on                 ? &of_lamps
                                           : &of_dark);
}

void app_draw_hint(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppMark *mark, const char *hint)
{
    enum { APART = 8, PAD = 8 };
    static const GdkRGBA ground = {0.1f, 0.1f, 0.1f, 0.85f}, ink = {1, 1, 1, 1};
    const int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, hint);
    double at[2], angle;
    int wide, high;
    app_mark_shown(map, mark, width, height, at, &angle);
    pango_layout_get_pixel_size(layout, &wide, &high);
    const double x = CLAMP(at[0] - wide / 2.0, 2 * PAD, MAX(width - wide - 2 * PAD, 2 * PAD));
    /* below the mark and its name, or above it where the lower edge is near */
    const double apart = APART + PAD + high, below = at[1] + apart;
    const double y = below + high + PAD > height ? at[1] - apart - high : below;
    GskRoundedRect rounded;
    gsk_rounded_rect_init_from_rect(
        &rounded,
        &GRAPHENE_RECT_INIT((float)round(x) - PAD, (float)round(y) - PAD, (float)wide + 2 * PAD, (float)high + 2 * PAD),
        PAD);
    gtk_snapshot_push_rounded_clip(snapshot, &rounded);
    gtk_snapshot_append_color(snapshot, &ground, &rounded.bounds);
    gtk_snapshot_pop(snapshot);
    gtk_snapshot_save(snapshot);
    gtk_snapshot_translate(snapshot, &GRAPHENE_POINT_INIT((float)round(x), (float)round(y)));
    gtk_snapshot_append_layout(snapshot, layout, &ink);
    gtk_snapshot_restore(snapshot);
    g_object_unref(layout);
}

/* Dashes of two colours, as lines that show on everything. */
static void append_line(GtkSnapshot *snapshot, float x, float y, float width, float height)
{
    static const GdkRGBA dark = {0, 0, 0, 0.55f}, light = {1, 1, 1, 0.75f};
    gtk_snapshot_append_color(snapshot, &dark, &GRAPHENE_RECT_INIT(x - 1, y - 1, width + 2, height + 2));
    gtk_snapshot_append_color(snapshot, &light, &GRAPHENE_RECT_INIT(x, y, width, height));
}

void app_draw_section(GtkSnapshot *snapshot, const AppMap *map, const double section_mm[2], double width, double height)
{
    double at[2];
    app_map_to_widget(map, section_mm, at);
    append_line(snapshot, 0, (float)round(at[1]), (float)width, 1);
    append_line(snapshot, (float)round(at[0]), 0, 1, (float)height);
}

void app_draw_read(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const double place_mm[2])
{
    double at[2];
    app_map_to_widget(map, place_mm, at);
    put_shape(snapshot, widget, at, (Look){.shape = SHAPE_RING});
}

void app_draw_isophotes(GtkSnapshot *snapshot, const AppMap *map, const luxel_isophotes *isophotes,
                        const graphene_rect_t *area)
{
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, area);
    for (gsize i = 0; i < isophotes->count; i++) {
        const luxel_isophote *line = &isophotes->lines[i];
        for (gsize k = 0; k < line->count; k++) {
            const double place[2] = {line->x_mm[k], line->y_mm[k]};
            double at[2];
            app_map_to_widget(map, place, at);
            cairo_line_to(cairo, at[0], at[1]);
        }
        if (line->closed)
            cairo_close_path(cairo);
        cairo_new_sub_path(cairo);
    }
    stroke(cairo, 1, 1, 1, 1);
    cairo_destroy(cairo);
}

void app_draw_maximum(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const luxel_extremum *maximum)
{
    const double place[2] = {maximum->x_mm, maximum->y_mm};
    double at[2];
    if (!maximum->exists || !(isfinite(place[0]) && isfinite(place[1])))
        return;
    app_map_to_widget(map, place, at);
    put_shape(snapshot, widget, at, (Look){.shape = SHAPE_MAXIMUM});
}
