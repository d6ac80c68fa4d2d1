/* SPDX-License-Identifier: MIT */
/*
 * Figures: pictures for people, drawn to PNG, SVG or PDF: false colour or grey with a colour bar, axes in mm, labelled
 * isophotes, outlines, marks and the plots of sections.
 *
 * These functions are in a library of their own, luxel-figure (pkg-config luxel-figure), because they need cairo and
 * pango.  Fonts are embedded in PDF and outlines in SVG, so that a figure looks the same everywhere.
 */
#ifndef LUXEL_FIGURE_H
#define LUXEL_FIGURE_H

#include <luxel/document.h>
#include <luxel/extrema.h>
#include <luxel/isophotes.h>
#include <luxel/photometry.h>
#include <luxel/profile.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How values become colours. */
typedef enum luxel_figure_bands {
    LUXEL_BANDS_SMOOTH,   /* one colour for each value */
    LUXEL_BANDS_STEPS,    /* steps: one colour from each level to the next */
    LUXEL_BANDS_CONTOURS, /* smooth colours under labelled isophotes */
    LUXEL_BANDS_LINES     /* isophotes alone, coloured, on white */
} luxel_figure_bands;

/* The place that a section is drawn through. */
typedef enum luxel_figure_section {
    LUXEL_SECTION_NONE,
    LUXEL_SECTION_CENTER, /* the screen's centre */
    LUXEL_SECTION_MAXIMUM,
    LUXEL_SECTION_POINT
} luxel_figure_section;

/*
 * The contents of a figure; luxel_figure_settings_init() sets the defaults, which the comments name.
 *
 * The figure of a grid shows the irradiance on its plane as it is seen from its front, whatever the screen shows: the
 * colours and isophotes of cells much finer than its own, its values at its own points where there is room for them
 * (`points`), the maximum on the plane (`extrema`), where lights stand in front of it, and what is read off its values:
 * average, minimum, maximum and U0.  Its axes are the scene's where it lies along them, else from its middle on.  The
 * range of its colours is 0 to its maximum unless one is given, or the scene's picture says minmax or log.  It has no
 * sections, whatever the settings say.
 */
typedef struct luxel_figure_settings {
    const char *palette;          /* a name of luxel_palette_name(): NULL: viridis */
    double low;                   /* of the range of the bar; NaN: what the picture of the scene says, or its values */
    double high;                  /* of the range of the bar; NaN likewise */
    bool logarithmic;             /* the bar by powers of ten; false */
    luxel_figure_bands bands;     /* contours */
    size_t levels;                /* about so many round ones, 1 to 50; 8 */
    const double *level_list;     /* or just these; NULL */
    size_t level_list_count;      /* of them */
    bool extrema;                 /* mark the maximum; true */
    bool points;                  /* mark the scene's points; true */
    luxel_figure_section section; /* none; else the plots of the horizontal and the vertical section stand below */
    double section_mm[2];         /* of LUXEL_SECTION_POINT */
    bool stacked;                 /* in sections: the lights' shares on top of each other, else as lines; false */
    const char *title;            /* NULL or "": none */
    const char *label;            /* of the bar; NULL: the quantity with its unit */
    double width_mm;              /* of the whole figure on paper, 40 to 1000; 160 */
    double dots_per_inch;         /* of a PNG, 30 to 2400; 200 */
    bool dark;                    /* light lines on a dark ground, for projectors; false */
    bool small_print;             /* the parameters under the picture; true */
    const luxel_language *language; /* NULL: English */
    size_t grid;           /* 0: the picture; else the plane of the scene's grid of this number, from 1 on; see below */
    luxel_color_view view; /* of a picture in colour; luminance.  Others have no sections, and lines of pixels alone */
    size_t daylight;       /* not 0: the figure of a grid shows daylight factors in percent (daylight.h); 0 */
    void *reserved[2];     /* for later versions: NULL */
} luxel_figure_settings;

/* Sets every member to its default, given above. */
LUXEL_API void luxel_figure_settings_init(luxel_figure_settings *settings);

/* The name of the i-th palette, such as "viridis"; NULL beyond the last. */
LUXEL_API const char *luxel_palette_name(size_t i);
/* The purpose of the i-th palette, English, to be translated; NULL beyond the last. */
LUXEL_API const char *luxel_palette_meaning(size_t i);
/* The colour of a palette (NULL: viridis) at t from 0 to 1 (clipped), as red, green, blue from 0 to 1; false: no such
 * palette. */
LUXEL_API bool luxel_palette_color(const char *name, double t, double color[3]);

/*
 * Draws the scene's figure to a file by the extension of its name: .png, .svg or .pdf, whole or not at all.
 * `settings` are those of the values; `figure` NULL: the defaults.
 * LUXEL_ERROR_ARGUMENT: another extension, an unknown palette, a setting out of its range.  LUXEL_ERROR_FILE: it
 * could not be written.  Errors as luxel_render() lists them, too.
 */
LUXEL_API luxel_status luxel_figure_write(const luxel_scene *scene, const luxel_settings *settings,
                                          const luxel_figure_settings *figure, const char *path,
                                          luxel_diagnostics *diagnostics);

/*
 * Draws the figure to several files, for which it is computed once.  Names are checked before anything is computed; a
 * file that cannot be written does not stop the others, and the status is that of the last that failed.  written[i]
 * tells whether paths[i] was written.
 */
LUXEL_API luxel_status luxel_figure_write_files(const luxel_scene *scene, const luxel_settings *settings,
                                                const luxel_figure_settings *figure, const char *const *paths,
                                                size_t count, luxel_diagnostics *diagnostics, bool *written);

/*
 * Draws the figure that luxel_figure_write() would write, in memory: *bytes, *length of them, the caller's, freed with
 * luxel_bytes_free().  `name` tells the format by its extension: "figure.svg".  Errors as luxel_figure_write(); *bytes
 * and *length then stay as they were.
 */
LUXEL_API luxel_status luxel_figure_write_memory(const luxel_scene *scene, const luxel_settings *settings,
                                                 const luxel_figure_settings *figure, const char *name,
                                                 luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length);

/* Whether luxel_figure_write() knows the extension of this name; if not, says so in the diagnostics. */
LUXEL_API luxel_status luxel_check_figure_name(const char *path, luxel_diagnostics *diagnostics);

/* The kinds of diagrams of a luminaire. */
typedef enum luxel_diagram {
    LUXEL_DIAGRAM_POLAR,     /* the sections C0-C180 and C90-C270 around the luminaire, nadir below */
    LUXEL_DIAGRAM_CARTESIAN, /* the intensity over gamma, plane by plane */
    LUXEL_DIAGRAM_CONE       /* the beam from 1 to 5 m below: its diameters, and the illuminance in its middle */
} luxel_diagram;

/* How it is drawn; luxel_diagram_settings_init() sets the defaults, which the comments name. */
typedef struct luxel_diagram_settings {
    luxel_diagram diagram;          /* polar */
    const char *title;              /* NULL or "": none */
    double width_mm;                /* of the whole on paper, 40 to 1000; 160 */
    double dots_per_inch;           /* of a PNG, 30 to 2400; 200 */
    bool dark;                      /* light lines on a dark ground; false */
    const luxel_language *language; /* NULL: English */
    void *reserved[4];              /* for later versions: NULL */
} luxel_diagram_settings;

/* Sets every member to its default, given above. */
LUXEL_API void luxel_diagram_settings_init(luxel_diagram_settings *settings);

/*
 * Draws a luminaire to a file by the extension of its name: .png, .svg or .pdf, whole or not at all.  Intensities are
 * in cd/klm where the photometry is relative, else in cd.  `settings` NULL: the defaults.
 * LUXEL_ERROR_ARGUMENT: another extension, a setting out of its range.  LUXEL_ERROR_FILE: it cannot be written.
 * LUXEL_ERROR_MEMORY: there is not enough.
 */
LUXEL_API luxel_status luxel_diagram_write(const luxel_photometry *photometry, const luxel_diagram_settings *settings,
                                           const char *path, luxel_diagnostics *diagnostics);

/* Draws a luminaire in memory, as luxel_figure_write_memory() does a figure; errors as luxel_diagram_write(). */
LUXEL_API luxel_status luxel_diagram_write_memory(const luxel_photometry *photometry,
                                                  const luxel_diagram_settings *settings, const char *name,
                                                  luxel_diagnostics *diagnostics, unsigned char **bytes,
                                                  size_t *length);

/* What a luminaire's sheet says and computes beside what its file gives; zero-initialise it, all may be NULL or 0. */
typedef struct luxel_sheet_settings {
    const char *title;                 /* NULL: the name of the luminaire in the file */
    const char *file;                  /* the file's name as the sheet shows it; NULL: none */
    const char *path;                  /* of the file, for rooms that are solved with reflections; NULL: none are */
    double spacing;                    /* of the UGR table; 0: 0.25 */
    const luxel_diagnostics *warnings; /* of reading the file, to be listed; NULL: none */
    const luxel_settings *settings;    /* of those rooms; NULL: the defaults */
    const luxel_language *language;    /* NULL: English */
    void *reserved[4];                 /* for later versions: NULL */
} luxel_sheet_settings;

/*
 * Writes the sheet of a luminaire by the extension of the name, .pdf (A4), .html (one file), .md, .tex, .csv (its
 * tables): what its file says, diagrams, intensities, flux of zones, luminances, utilization factors, unified glare
 * ratings, and the rating of backlight, uplight and glare.  Types A and B, and points, have not all of it.  `settings`
 * NULL: none of its texts.
 * LUXEL_ERROR_ARGUMENT: another extension.  LUXEL_ERROR_FILE: it cannot be written.  LUXEL_ERROR_MEMORY.  Of `path`
 * errors as luxel_find_room_utilization() lists them, too.
 */
LUXEL_API luxel_status luxel_sheet_write(const luxel_photometry *photometry, const luxel_sheet_settings *settings,
                                         const char *path, luxel_diagnostics *diagnostics);

/* Makes the sheet in memory, as luxel_figure_write_memory() does a figure; errors as luxel_sheet_write(). */
LUXEL_API luxel_status luxel_sheet_write_memory(const luxel_photometry *photometry,
                                                const luxel_sheet_settings *settings, const char *name,
                                                luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length);

/* The purpose of a report. */
typedef enum luxel_report_purpose {
    LUXEL_REPORT_EXERCISE, /* what students hand in */
    LUXEL_REPORT_LIGHTING  /* what a lighting designer hands over */
} luxel_report_purpose;

/* Texts that a report says of itself; all may be NULL. */
typedef struct luxel_report_settings {
    const char *title;              /* of the report; NULL: one that says what it is about */
    const char *author;             /* who hands it in */
    const char *group;              /* the group of the author */
    const char *date;               /* as it is to stand there; NULL: none, so that reports can be repeated */
    const luxel_language *language; /* NULL: English */
    const char *palette;            /* of the false colour; NULL: viridis */
    const char *institution;        /* where it is handed in; with any of this and the next four a title page is made */
    const char *faculty;            /* of the institution */
    const char *course;             /* what the report is for */
    const char *teacher;            /* who checks it */
    const char *place;              /* the town, say */
    const char *aim;                /* of the work, a paragraph; NULL: to compute and show what is computed */
    unsigned digits;                /* significant digits of values, to 17; 0: 7, and 12 of the values of points */
    luxel_report_purpose purpose;   /* what the report is to show */
    const char *tables;             /* a folder for the tables of a report for lighting; NULL: they are in it alone */
    void *reserved[2];              /* for later versions: NULL */
} luxel_report_settings;

/*
 * Writes the report that the exercise asks for, by the extension of the name: .pdf (A4), .html (one file), .md, .tex
 * or, of its tables alone, .csv:
 * aim, task, parameters, formulas, pictures, sections, points, extrema, conclusions, and the scene to reproduce them.
 * With LUXEL_REPORT_LIGHTING: a summary of the limits with their verdicts, the plan, the luminaires with totals, each
 * measuring grid as figure and table, the glare of observers, the light on surfaces, the conventions, and the scene.
 * With `tables` that one writes files into a folder, which must be there: each of its tables as NAME.csv, bounds in
 * columns of their own (limits, luminaires, maintenance, positions, glare, glare-N of the N-th observer, surfaces,
 * balance), and what tables leave out: grids.csv, a line for each grid, values.csv as luxel_grids_write() has it, and
 * the isolux lines of the figures as isolux.csv and isolux.dxf.
 * `report` NULL: none of its texts.  Zero-initialise its settings, so that members that come later are NULL.
 * LUXEL_ERROR_ARGUMENT: another extension.  LUXEL_ERROR_FILE.  Errors as luxel_render() lists them, too.
 */
LUXEL_API luxel_status luxel_report_write(const luxel_scene *scene, const luxel_settings *settings,
                                          const luxel_report_settings *report, const char *path,
                                          luxel_diagnostics *diagnostics);

/* Writes the report to several files, for which it is made once, as luxel_figure_write_files() does a figure. */
LUXEL_API luxel_status luxel_report_write_files(const luxel_scene *scene, const luxel_settings *settings,
                                                const luxel_report_settings *report, const char *const *paths,
                                                size_t count, luxel_diagnostics *diagnostics, bool *written);

/* Makes the report in memory, as luxel_figure_write_memory() does a figure; errors as luxel_report_write(). */
LUXEL_API luxel_status luxel_report_write_memory(const luxel_scene *scene, const luxel_settings *settings,
                                                 const luxel_report_settings *report, const char *name,
                                                 luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length);

/* Whether luxel_report_write() knows the extension of this name; if not, says so in the diagnostics. */
LUXEL_API luxel_status luxel_check_report_name(const char *path, luxel_diagnostics *diagnostics);

#ifdef __cplusplus
}
#endif
#endif
