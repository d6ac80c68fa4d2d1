/* SPDX-License-Identifier: MIT */
/*
 * Drawing on a cairo context: colour bars, profiles and histograms as figures show them, for the screens of programs;
 * and the outlines of surfaces as lines, for programs that draw pictures of their own.
 *
 * These functions are in the library luxel-figure.  Each luxel_draw_...() draws on the rectangle from (0, 0) to
 * (width, height) of the context, in its units, over what is there, and leaves the context as it was but for its
 * current path, which is gone.  Ticks and labels are chosen so that they fit.  Threads: one at a time for a context.
 *
 * These return LUXEL_ERROR_ARGUMENT where something is missing or out of what its comment says, with nothing drawn, or
 * the context cannot be drawn on; and LUXEL_ERROR_MEMORY.
 */
#ifndef LUXEL_DRAWING_H
#define LUXEL_DRAWING_H

#include <cairo.h>

#include <luxel/document.h>
#include <luxel/profile.h>
#include <luxel/scene.h>
#include <luxel/statistics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How things are drawn; luxel_drawing_style_init() sets the defaults, which the comments name. */
typedef struct luxel_drawing_style {
    double letters;   /* the size of the letters, which all lines follow, above 0; 10 */
    double ink[3];    /* of letters and lines: red, green and blue from 0 to 1; near black or white */
    double ground[3]; /* what is drawn on, as colours are chosen to stand out from it; white or near black */
    const luxel_language *language; /* NULL: English */
    char decimal_mark;              /* in front of the fractions of ticks; '.' */
    void *reserved[4];              /* for later versions: NULL */
} luxel_drawing_style;

/* Sets every member to its default, given above; `dark`: light ink for a dark ground. */
LUXEL_API void luxel_drawing_style_init(luxel_drawing_style *style, bool dark);

/*
 * The colour in which luxel_draw_profile() draws the shares of light i, for marks, lists and keys that stand beside it:
 * red, green and blue from 0 to 1, as they suit the style's ground.  Every tenth light has the same one again; their
 * lines differ in their dashes.
 * LUXEL_ERROR_ARGUMENT: no style, a style that cannot be drawn with, or nowhere to write to.
 */
LUXEL_API luxel_status luxel_light_color(const luxel_drawing_style *style, size_t i, double color[3]);

/* A colour bar; {0} has no range: set that. */
typedef struct luxel_color_bar {
    const char *palette; /* a name of luxel_palette_name(); NULL: viridis */
    double low;          /* the range: finite, low < high */
    double high;         /* its end */
    bool logarithmic;    /* by powers of ten; then low > 0 */
    bool has_below;      /* pointed at the low end: there are values beyond it */
    bool has_above;      /* pointed at the high end */
    const char *label;   /* NULL: none */
    void *reserved[4];   /* for later versions: NULL */
} luxel_color_bar;

/*
 * Draws a colour bar with its ticks along the longer side: upright at the left with ticks and label at its right, or
 * lying at the top with them below.  A label for which there is no room across is left out.
 */
LUXEL_API luxel_status luxel_draw_color_bar(cairo_t *cairo, const luxel_drawing_style *style,
                                            const luxel_color_bar *bar, double width, double height);

/* How much room a bar of this length takes across, with its ticks and its label; `lying`: from left to right. */
LUXEL_API luxel_status luxel_color_bar_room(const luxel_drawing_style *style, const luxel_color_bar *bar, double length,
                                            bool lying, double *room);

/* What a profile is drawn along. */
typedef enum luxel_profile_along {
    LUXEL_ALONG_WAY, /* the profile's abscissa: the distance in mm or the angle in degrees */
    LUXEL_ALONG_X,   /* x on the screen in mm, where the way does not go straight up */
    LUXEL_ALONG_Y    /* y on the screen in mm, where the way does not go straight across */
} luxel_profile_along;

/* What a profile shows; luxel_profile_style_init() sets the defaults, which the comments name. */
typedef struct luxel_profile_style {
    luxel_profile_along along; /* way */
    bool stacked;              /* the lights' shares on top of each other, else as lines; false */
    bool logarithmic;          /* the values by powers of ten, but where they are stacked; false */
    double low;                /* of the values' axis; NaN: 0, or four decades below high where that is by powers */
    double high;               /* of the values' axis; NaN: a little above the greatest value */
    const char *const
        *names;          /* of the profile's lights, for a legend: one for each; a light without (NULL) is not drawn;
                               * NULL: all are drawn, without a legend */
    const char *x_label; /* NULL: what the profile is along, with its unit */
    const char *y_label; /* NULL: the quantity */
    double marker;       /* a place along it to be marked, such as the pointer's; NaN: none */
    void *reserved[4];   /* for later versions: NULL */
} luxel_profile_style;

/* Sets every member to its default, given above. */
LUXEL_API void luxel_profile_style_init(luxel_profile_style *how);

/*
 * Draws a profile: the sum as a bold line, and where more than one light is drawn the shares, with axes, the legend
 * below (if there is room for it), and the marker.  `how` NULL: the defaults.
 */
LUXEL_API luxel_status luxel_draw_profile(cairo_t *cairo, const luxel_drawing_style *style,
                                          const luxel_profile *profile, const luxel_profile_style *how, double width,
                                          double height);

/* The frame of a plot's axes, for programs that find the values under a pointer or draw more into it. */
typedef struct luxel_plot_frame {
    double x;      /* of its upper left corner */
    double y;      /* of its upper left corner, downwards */
    double width;  /* of the frame; 0 where there is no room for the plot */
    double height; /* likewise */
    double left;   /* the value at its left edge; between left and right, values lie by powers where the plot does */
    double right;  /* at its right edge */
    double bottom; /* at its lower edge */
    double top;    /* at its upper edge */
    void *reserved[4]; /* for later versions: NULL */
} luxel_plot_frame;

/* Where luxel_draw_profile() with the same arguments draws the curves. */
LUXEL_API luxel_status luxel_profile_frame(const luxel_drawing_style *style, const luxel_profile *profile,
                                           const luxel_profile_style *how, double width, double height,
                                           luxel_plot_frame *frame);

/*
 * Draws a histogram with its axes.  `colors`: the bins in the colours that their values have in this bar; NULL: in ink.
 * The labels: NULL: none.
 */
LUXEL_API luxel_status luxel_draw_histogram(cairo_t *cairo, const luxel_drawing_style *style,
                                            const luxel_histogram *histogram, const luxel_color_bar *colors,
                                            const char *x_label, const char *y_label, double width, double height);

/* Where luxel_draw_histogram() with the same arguments draws the bins. */
LUXEL_API luxel_status luxel_histogram_frame(const luxel_drawing_style *style, const luxel_histogram *histogram,
                                             const char *x_label, const char *y_label, double width, double height,
                                             luxel_plot_frame *frame);

/* A chain of places along the edge of a surface, as far as nothing stands before it. */
typedef struct luxel_surface_outline {
    size_t count;       /* of the places, 2 at least */
    const double *x_mm; /* on the screen, or beyond its edges */
    const double *y_mm; /* of the places, on the screen or beyond its edges */
} luxel_surface_outline;

/* The outlines of all surfaces.  The arrays live as long as it does. */
typedef struct luxel_surface_outlines {
    size_t count;                       /* of the chains */
    const luxel_surface_outline *lines; /* count of them */
} luxel_surface_outlines;

/*
 * Finds the outlines of a committed scene's surfaces as the observer sees them: the rims of spheres, the edges of
 * rectangles.  Lights make no difference.  Straight between its places a chain leaves a circle by no more than 3e-6 of
 * its radius.  The result is the caller's: free it with luxel_surface_outlines_free().
 * LUXEL_ERROR_ARGUMENT: the scene is not committed.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_surface_outlines(const luxel_scene *scene, luxel_diagnostics *diagnostics,
                                                   luxel_surface_outlines **outlines);

/* Frees outlines; NULL is harmless. */
LUXEL_API void luxel_surface_outlines_free(luxel_surface_outlines *outlines);

#ifdef __cplusplus
}
#endif
#endif
