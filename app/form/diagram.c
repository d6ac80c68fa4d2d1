/* SPDX-License-Identifier: MIT */
/* The file is read and drawn when another one is shown, when it was changed, and when light becomes dark. */
#include "diagram.h"

#include <luxel/figure.h>
#include <math.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/number.h"
#include "ugr_table.h"

enum { SIDE = 190, WIDTH_MM = 80, DOTS_PER_INCH = 190 };

struct _AppDiagram {
    GtkBox parent;
    GtkWidget *picture, *figures, *ugr;
    char *shown; /* what is drawn: the path, its time and the ground; NULL: nothing */
};

G_DEFINE_FINAL_TYPE(AppDiagram, app_diagram, GTK_TYPE_BOX)

static gboolean is_dark(GtkWidget *widget)
{
    GdkRGBA ink;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    return ink.red + ink.green + ink.blue > 1.5f;
}

/* Marks that tell a file from another, and from itself as it was. */
static char *state_of(AppDiagram *self, const char *path)
{
    GFile *file = g_file_new_for_path(path);
    GFileInfo *info = g_file_query_info(file, "time::modified,time::modified-usec", G_FILE_QUERY_INFO_NONE, NULL, NULL);
    char *state =
        info ? g_strdup_printf("%s %" G_GUINT64_FORMAT " %u %d", path,
                               g_file_info_get_attribute_uint64(info, "time::modified"),
                               g_file_info_get_attribute_uint32(info, "time::modified-usec"), is_dark(GTK_WIDGET(self)))
             : NULL;
    g_clear_object(&info);
    g_object_unref(file);
    return state;
}

static GdkTexture *draw(AppDiagram *self, const luxel_photometry *photometry)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_diagram_settings settings;
    unsigned char *bytes;
    size_t length;
    luxel_diagram_settings_init(&settings);
    settings.width_mm = WIDTH_MM;
    settings.dots_per_inch = DOTS_PER_INCH;
    settings.dark = is_dark(GTK_WIDGET(self));
    settings.language = &language;
    if (luxel_diagram_write_memory(photometry, &settings, "diagram.png", NULL, &bytes, &length) != LUXEL_OK)
        return NULL;
    GBytes *png = g_bytes_new(bytes, length);
    luxel_bytes_free(bytes);
    GdkTexture *texture = gdk_texture_new_from_bytes(png, NULL);
    g_bytes_unref(png);
    return texture;
}

/* Flux, beam and the greatest intensity in a line: what a table of lamps has. */
static char *figures_of(const luxel_photometry *photometry)
{
    luxel_photometry_figures figures;
    char flux[APP_NUMBER_SIZE], beam[APP_NUMBER_SIZE], greatest[APP_NUMBER_SIZE];
    if (luxel_photometry_find_figures(photometry, &figures) != LUXEL_OK)
        return g_strdup("");
    app_number_show(figures.zone_lumens, 4, flux);
    app_number_show(figures.greatest_cd, 4, greatest);
    if (!isfinite(figures.beam_deg))
        return g_strdup_printf(_("%s lm, at most %s cd"), flux, greatest);
    return g_strdup_printf(_("%s lm, at most %s cd, beam %s°"), flux, greatest,
                           app_number_show(figures.beam_deg, 3, beam));
}

void app_diagram_show(AppDiagram *self, const char *path)
{
    char *state = path ? state_of(self, path) : NULL;
    if (g_strcmp0(state, self->shown) == 0) {
        g_free(state);
        return;
    }
    g_free(self->shown);
    self->shown = state;
    luxel_photometry *photometry = NULL;
    if (!state || luxel_photometry_read(path, NULL, &photometry) != LUXEL_OK)
        photometry = NULL;
    GdkTexture *texture = photometry ? draw(self, photometry) : NULL;
    char *figures = texture ? figures_of(photometry) : g_strdup("");
    gtk_picture_set_paintable(GTK_PICTURE(self->picture), GDK_PAINTABLE(texture));
    gtk_label_set_text(GTK_LABEL(self->figures), figures);
    app_ugr_table_show(self->ugr, photometry);
    gtk_widget_set_visible(GTK_WIDGET(self), texture != NULL);
    g_clear_object(&texture);
    g_free(figures);
    luxel_photometry_free(photometry);
}

static void app_diagram_finalize(GObject *object)
{
    g_free(APP_DIAGRAM(object)->shown);
    G_OBJECT_CLASS(app_diagram_parent_class)->finalize(object);
}

static void app_diagram_class_init(AppDiagramClass *class)
{
    G_OBJECT_CLASS(class)->finalize = app_diagram_finalize;
}

static void app_diagram_init(AppDiagram *self)
{
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_widget_set_visible(GTK_WIDGET(self), FALSE);
    self->picture = gtk_picture_new();
    self->figures = gtk_label_new(NULL);
    gtk_widget_set_size_request(self->picture, -1, SIDE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->picture), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Polar diagram"),
                                   -1);
    gtk_label_set_wrap(GTK_LABEL(self->figures), TRUE);
    gtk_widget_add_css_class(self->figures, "note");
    gtk_box_append(GTK_BOX(self), self->picture);
    gtk_box_append(GTK_BOX(self), self->figures);
    self->ugr = app_ugr_table_new();
    gtk_box_append(GTK_BOX(self), self->ugr);
}

GtkWidget *app_diagram_new(void)
{
    return g_object_new(APP_TYPE_DIAGRAM, NULL);
}
