/* SPDX-License-Identifier: MIT */
/* A figure, computed: all that is drawn, whatever it is drawn to. */
#ifndef LX_FIGURE_FIGURE_H
#define LX_FIGURE_FIGURE_H

#include <luxel/figure.h>
#include <luxel/grid.h>

#include "../document/document.h"
#include "../scene/scene.h"
#include "parts.h"

enum { LX_MOST_LEVELS = 64, LX_MOST_BOXES = 256 };

/* Outlines of surfaces on the screen, as chains of places. */
struct lx_figure_outline {
    double (*places_mm)[2];
    size_t count, capacity;
};

/* A light in front of a measuring plane: where it stands, in mm from the plane's middle. */
struct lx_lamp {
    double place_mm[2];
    size_t light; /* index in the scene */
};

/* What the figure of a measuring plane has beside that of a picture. */
struct lx_figure_plane {
    luxel_grid *grid;
    luxel_grid_extrema extrema; /* on the whole plane */
    struct lx_lamp *lamps;
    size_t lamp_count;
    char *caption; /* what is read off the values */
};

/* The picture of a scene, and what tells of it between the pixels; of a measuring plane its field alone. */
struct lx_rendered {
    luxel_field *field;
    luxel_evaluator *evaluator;
    luxel_extrema extrema; /* none where they are not wanted */
};

struct lx_figure {
    luxel_figure_settings settings;
    const struct lx_scene_parameters *scene;
    luxel_scene *copy;      /* of the scene, which the rest points into */
    luxel_scene *daylit;    /* what is measured for daylight factors (api/sun/daylight.h); NULL: the copy is */
    struct lx_rendered own; /* empty where it was given one */
    const luxel_field *field;
    luxel_field *view;             /* that, where it is a view of the picture in colour; else NULL */
    struct lx_figure_plane *plane; /* NULL: it shows the picture */
    double size_mm[2];             /* of the map, whose middle is at (0, 0) */
    struct lx_scale axes[2];       /* what is written along its sides, which may run downwards */
    const char *axis_names[2];     /* English */
    luxel_isophotes *isophotes;    /* NULL: none are drawn */
    luxel_extrema extrema;
    double levels[LX_MOST_LEVELS];
    size_t level_count;
    struct lx_scale scale;              /* of the colours */
    char *title, *label, *print;        /* the small print */
    bool has_below, has_above;          /* whether the picture has values beyond it */
    struct lx_figure_outline *outlines; /* one for each chain of what is seen of a contour */
    size_t outline_count, outline_capacity;
    struct lx_figure_outline *contours; /* closed, one for each surface; together they enclose what shows one */
    size_t contour_count;
    struct lx_labels *labels;   /* where the map is labelled, of its last drawing: one is drawn at a time */
    luxel_profile *sections[2]; /* horizontal, vertical; NULL: none */
    double section_mm[2];
    char **lights; /* the names of those that are on, in the order of the shares */
    size_t *light_places;
    size_t light_count;
    char *maximum; /* its mark's words */
    char *section_titles[2];
};

/* Renders the whole picture.  lx_rendered_clear() is due whatever it returns. */
luxel_status lx_rendered_make(const luxel_scene *scene, const luxel_settings *settings, bool wants_extrema,
                              luxel_diagnostics *diagnostics, struct lx_rendered *rendered);
void lx_rendered_clear(struct lx_rendered *rendered);

/*
 * Computes a figure; the scene is copied.  `rendered`, unless it is NULL, is the scene's picture with its extrema, by
 * the same settings, and must outlive the figure.  lx_figure_free() is due whatever it returns.
 */
luxel_status lx_figure_make(const luxel_scene *scene, const luxel_settings *settings,
                            const luxel_figure_settings *wanted, const struct lx_rendered *rendered,
                            luxel_diagnostics *diagnostics, struct lx_figure **figure);
void lx_figure_free(struct lx_figure *figure);

/* The settings (NULL: the defaults) for the whole picture, whatever stride they have. */
luxel_settings lx_whole_picture(const luxel_settings *settings);

/* The plane of a grid: its values, the field between them, the lights before it, and its axes (plane.c). */
const luxel_scene *lx_figure_measured(const struct lx_figure *figure); /* the scene whose plane it is */
luxel_status lx_figure_plane(struct lx_figure *figure, const luxel_settings *settings, luxel_diagnostics *diagnostics);
void lx_plane_free(struct lx_figure_plane *plane);

/* The outlines of the surfaces as they are seen, each contour in so many steps; 0, or -1 when memory ran out. */
int lx_figure_outline(struct lx_figure *figure, const luxel_evaluator *evaluator, int steps);

/* Draws it `width` points wide from (0, 0) on, or with `cairo` NULL only measures; returns the height. */
double lx_figure_draw(const struct lx_figure *figure, cairo_t *cairo, double width);

/* The map, on its own rectangle. */
void lx_draw_map(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot);

/* What the map says of colours: of a value with its bands, of a line of a level, of no surface. */
double lx_shown_value(const struct lx_figure *figure, double value);
void lx_line_color(const struct lx_figure *figure, const struct lx_canvas *canvas, double value, double color[3]);
void lx_empty_color(const struct lx_canvas *canvas, double color[3]);
/* Whether the maximum is marked. */
bool lx_shows_maximum(const struct lx_figure *figure);

/* A value at a point of a grid: three digits, or all that stand before the point. */
const char *lx_value_text(double value, char buffer[LX_TICK_TEXT]);

/* Makes all texts, in the figure's language. */
luxel_status lx_figure_texts(struct lx_figure *figure, luxel_diagnostics *diagnostics);
/* A text in the figure's language. */
const char *lx_figure_word(const struct lx_figure *figure, const char *english);

/* A kind of light or a shape by its key, and a convention with its values, in the figure's language. */
const char *lx_figure_kind(const struct lx_figure *figure, const char *key);
void lx_figure_add_convention(const struct lx_figure *figure, struct lx_text *text, const char *key, const char *value);

/* The colour of a value. */
void lx_figure_color(const struct lx_figure *figure, double value, double color[3]);

/* The figure as a PNG file's bytes, the caller's; LUXEL_ERROR_MEMORY. */
luxel_status lx_figure_png(const struct lx_figure *figure, luxel_diagnostics *diagnostics, unsigned char **bytes,
                           size_t *length);

/* A figure as a drawing of a document, which takes the figure over. */
struct lx_drawing lx_figure_drawing(struct lx_figure *figure);

#endif
