/* SPDX-License-Identifier: MIT */
/*
 * Measuring grids: the irradiance at the centres of the cells of a scene's measuring planes, and what lighting
 * designers read off them: average, minimum, maximum, and how evenly the plane is lit.
 *
 * A grid lies as a rectangle does: its axis is the normal of its elements, its rows are stacked along `up` made
 * perpendicular to the axis, its columns stand side by side along up x axis.  Row 0 is the top one, farthest along up;
 * column 0 is the first along up x axis, the left one for who looks at the front.  Values lie row by row.
 *
 * Each value is that of a free surface element at the cell's centre, in float64 with a bound of its error, as
 * luxel_probe_element() has it.  The quantity is the irradiance, whatever the settings say: a measuring plane has no
 * material.
 *
 * The measure of a grid may be another one than that of its plane: the mean of the irradiance on the surface of a small
 * body at the centre.  Light of the irradiance E on a plane facing it, at the angle theta from the axis and psi from up
 * about that, counts as E sin(theta)/pi, cylindrical; E sin(theta) (1 + cos(psi))/pi, semicylindrical; E/4, spherical;
 * E (1 + cos(theta))/4, hemispherical (EN 12665).  Where a cell lies on a surface only light from its side counts.
 * Flux and mean are those of the measure plane; others have none.
 *
 * Cells inside of bodies have no value: nobody sees or measures there.  A body is what a surface closes around, a
 * sphere that is seen from outside, a closed mesh, or a tube with covers, unless a light shines in it: that is a room.
 *
 * What is read off the values is what the cells' centres tell of the plane: where the light varies over a cell, their
 * average is not the plane's.  So the irradiance is integrated over the plane, too, whatever its cells: `mean` and
 * `flux` are those of the plane, and `sampling_error` tells how far the average of the values is from that.
 */
#ifndef LUXEL_GRID_H
#define LUXEL_GRID_H

#include <luxel/bounded.h>
#include <luxel/colour.h>
#include <luxel/field.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The least or the greatest value of a grid and its cell; ties: first in row order. */
typedef struct luxel_grid_extremum {
    double value;          /* in the grid's unit */
    unsigned column;       /* of its cell */
    unsigned row;          /* of its cell */
    double position_mm[3]; /* the cell's centre */
} luxel_grid_extremum;

/*
 * A measured grid.  Its texts and arrays live as long as the grid.  What is read off the values takes in the cells
 * that have one: average, extrema and what is made of them exist where `measured` is above 0, and are 0 elsewhere.
 */
typedef struct luxel_grid {
    const char *name;            /* in the scene, NULL where it has none */
    unsigned columns;            /* cells along up x axis */
    unsigned rows;               /* cells along up */
    double center_mm[3];         /* of the plane */
    double size_mm[2];           /* along up x axis, and along up */
    double axis[3];              /* unit: the normal of the elements */
    double up[3];                /* unit, perpendicular to the axis */
    double across[3];            /* unit: up x axis */
    const char *unit;            /* of the values, in UTF-8, that of luxel_scene_unit() for the irradiance */
    const double *values;        /* rows x columns; 0 for a cell without a value */
    const double *errors;        /* rows x columns: bounds of |value - truth|; 0 for a cell without a value */
    const uint8_t *mask;         /* rows x columns: 1 where the cell has a value, 0 on a source or inside a body */
    size_t measured;             /* the number of cells that have a value */
    size_t blocking_light;       /* where more than `enclosed` have none: the light on the first, by index */
    double error;                /* the largest of the bounds */
    luxel_bounded average;       /* the plain mean of the values; the truth is that of the true values there */
    luxel_grid_extremum minimum; /* the least value */
    luxel_grid_extremum maximum; /* the greatest value */
    bool has_evenness;           /* whether the average is above 0; else the next two are 0 */
    double u0;                   /* minimum / average, the uniformity U0 (EN 12665) */
    double ud;                   /* minimum / maximum, the diversity Ud */
    bool has_mean;               /* whether the next two are known: the unit is a power by area, no source in the way */
    luxel_bounded mean;          /* the mean irradiance of the plane, its integral by its area, bodies and all */
    const char *flux_unit;       /* "W" or "lm"; NULL where there is no mean */
    luxel_bounded flux;          /* the power that falls on the plane: its mean times its area; 0 without flux_unit */
    bool has_sampling_error;     /* false where a cell has no value */
    double sampling_error;       /* how far the average may be from the plane's mean */
    bool sampling_is_bound;      /* it is a bound, from the mean; else an estimate, from a grid of half as many cells */
    bool is_coarse;              /* the sampling error is above a hundredth of the mean: finer cells are needed */
    size_t enclosed;             /* the number of cells whose centres are inside the bodies of surfaces: see `inside` */
    size_t enclosing_surface;    /* where there are some: the surface around the first, as an index in the scene */
    bool has_reflected;          /* whether surfaces reflect light to each other; then all numbers above have it */
    double reflected_average;    /* the plain mean of what is reflected */
    double reflected_error;      /* the largest of the bounds of its errors */
    bool reflected_reached;      /* whether each of them is at most reflected_error times the value; see settings */
    bool tolerance_reached;      /* whether each error is at most the tolerance times the value (for a dark cell, times
                                    the maximum or, where all is dark, what the lights bring to it): the settings'
                                    tolerance, or 1e-9 where there is no closed form */
    const luxel_color *colors;   /* rows x columns: the values' channels; NULL in a scene without channels: rgb */
    const uint8_t *inside;       /* rows x columns: 1 where the cell is inside the body of a surface, else 0 */
    const char *measure;         /* what the values are, as the scene has it: "plane", "cylindrical" and so on */
    bool has_modelling;          /* whether the next three are known: the measure is cylindrical, the plane not dark */
    luxel_bounded modelling;     /* the average by that of the irradiance on the plane at the same places, */
    luxel_bounded least_modelling;    /* and the least */
    luxel_bounded greatest_modelling; /* and the greatest of such ratios at a place (luxel_find_grid() alone) */
    struct luxel_grid *surround;      /* the area around this one (EN 12464-1) as a grid without flux and mean, whose
                                         cells fill the rectangle around it: those that are not in it have no value
                                         and are marked as `inside`; NULL: none is asked for, or walls leave no room */
    struct luxel_grid *background;    /* likewise the area around that */
} luxel_grid;

/* The number of measuring grids of a committed scene. */
LUXEL_API size_t luxel_scene_grid_count(const luxel_scene *scene);
/* The name of the i-th grid, the scene's until that changes; NULL where it has none, or where there is no such grid. */
LUXEL_API const char *luxel_scene_grid_name(const luxel_scene *scene, size_t i);
/* The cells of the i-th grid of a committed scene.  LUXEL_ERROR_ARGUMENT: not committed, or no such. */
LUXEL_API luxel_status luxel_scene_grid_resolution(const luxel_scene *scene, size_t i, unsigned *columns,
                                                   unsigned *rows);

/*
 * Measures the scene's i-th grid.  `settings` NULL: the defaults.  The call blocks; it may be cancelled as rendering
 * may.  The grid is the caller's: free it with luxel_grid_free().
 * Errors as luxel_render() lists them.  LUXEL_ERROR_ARGUMENT: no such grid, too.  LUXEL_ERROR_RANGE: a value is beyond
 * float64.
 */
LUXEL_API luxel_status luxel_find_grid(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                       luxel_diagnostics *diagnostics, luxel_grid **grid);

/*
 * The values of luxel_find_grid() alone, with their average and extrema: without the flux and the mean of the plane
 * and the sampling error, which for sources of some size behind obstacles take most of the time.
 */
LUXEL_API luxel_status luxel_find_grid_values(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                              luxel_diagnostics *diagnostics, luxel_grid **grid);

/* The least or the greatest value on a whole plane. */
typedef struct luxel_grid_peak {
    bool exists;           /* false where no place has a value; then the rest is 0 */
    double value;          /* in the grid's unit */
    double error;          /* bounds |value - truth at this very place| */
    double position_mm[3]; /* of the place */
    double on_plane_mm[2]; /* from the plane's middle, along up x axis and along up */
    double rgb[3];         /* the value's channels, in a scene with channels: rgb; else 0 */
    double rgb_error;      /* bounds |channel - truth| of each */
} luxel_grid_peak;

/* Both. */
typedef struct luxel_grid_extrema {
    luxel_grid_peak minimum; /* the least value */
    luxel_grid_peak maximum; /* the greatest value */
    void *reserved[4];       /* for later versions: NULL */
} luxel_grid_extrema;

/*
 * Finds the extrema on the plane of the scene's i-th grid, its sides and corners included, between the points of the
 * grid.  They are looked for at the centres, sides and corners of all cells and, where no light takes integrals, at
 * some thousand places, and refined from there; so neither is less extreme than that of the grid's values, and no bound
 * is known of what is narrower than the places lie apart.  Where light jumps, at the edge of a shadow say, the place is
 * as near as the steps lead.  Of light that surfaces reflect to each other what luxel_find_grid() has found for the
 * plane is used, if it was the last one, and else found anew, so that the numbers may differ within their errors.
 * In a scene with channels: rgb they are those of the luminance.
 * Errors as luxel_find_grid().
 */
LUXEL_API luxel_status luxel_find_grid_extrema(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                               luxel_diagnostics *diagnostics, luxel_grid_extrema *extrema);

/*
 * Measures the plane of the scene's i-th grid at the centres of other cells, so many columns and rows, as a field: the
 * irradiance in float64, row 0 the top one, its places in mm from the plane's middle, x along up x axis and y along up.
 * An odd multiple of the grid's own cells has their centres among its own.  Columns and rows of 0 are such multiples,
 * so many that figures and lines of equal value show no corners, measured no more exactly than these need.  The field
 * is the caller's, as luxel_render() has it, but knows no scene.
 * Errors as luxel_find_grid(); LUXEL_ERROR_ARGUMENT: columns or rows are not 1 to 65536, or both 0, too.
 */
LUXEL_API luxel_status luxel_find_grid_field(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                             unsigned columns, unsigned rows, luxel_diagnostics *diagnostics,
                                             luxel_field **field);

/* Frees a grid with its values; NULL is harmless. */
LUXEL_API void luxel_grid_free(luxel_grid *grid);

/* The centre of a cell, of which there need be none: the plane goes on. */
LUXEL_API void luxel_grid_position(const luxel_grid *grid, unsigned column, unsigned row, double position_mm[3]);

/* Whether grids can be written to a file of this name: ".csv" is the extension that goes.  LUXEL_ERROR_ARGUMENT. */
LUXEL_API luxel_status luxel_check_grid_output_name(const char *path, luxel_diagnostics *diagnostics);

/*
 * Writes `count` grids of one unit to a .csv file, whole or not at all: under a line with the columns' names
 * (grid,column,row,x_mm,y_mm,z_mm,irradiance_UNIT,error_UNIT, in colour red_UNIT,green_UNIT,blue_UNIT too) a line for
 * each cell, grid by grid and row by row.  A grid goes by its name or, where it has none, by "grid 1" and so on, as it
 * stands in the list; the last two fields of a cell without a value, on a source or inside a body, are empty.
 * LUXEL_ERROR_ARGUMENT: another extension, or no grid.  LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_grids_write(const luxel_grid *const *grids, size_t count, const char *path,
                                         luxel_diagnostics *diagnostics);

#ifdef __cplusplus
}
#endif
#endif
