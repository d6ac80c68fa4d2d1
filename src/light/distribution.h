/* SPDX-License-Identifier: MIT */
/*
 * The distribution of a luminaire: the table of a photometry file as a function of the direction, bilinear in two
 * angles.  Whatever type the file has, the table is brought to one frame of three directions at right angles:
 *
 *     azimuth  the angle about the third direction, from the first one towards the second
 *     polar    the angle from the third direction
 *
 *     type C   c0, c0 x a, a:   azimuth C, polar gamma
 *     type A   a, c0, a x c0:   azimuth X, polar 90 + Y
 *     type B   a, c0 x a, -c0:  azimuth V, polar 90 + H
 *
 * with the axis a.  Between its lines the function is linear in the azimuth, and in the polar angle or in its cosine;
 * beyond the outermost lines it is 0.  Values are shares of a power of two, so that none is changed by rounding.
 *
 * Threads: a distribution never changes once it was made.
 */
#ifndef LX_LIGHT_DISTRIBUTION_H
#define LX_LIGHT_DISTRIBUTION_H

#include <stdint.h>

#include "../base/frame.h"
#include "../format/lamp/photometry.h"
#include "distribution_even.h"
#include "profile.h"

/*
 * Lines of the grid in radians for the kernels, of which the first and the last are in `line`.  A number lies in cell i
 * where edge[i] <= number < edge[i + 1]; the outermost edges are beyond all angles.  `first` has the cell in which, or
 * below which, a number is whose (number - start) * per_radian rounds down to the index.
 */
#define LX_DISTRIBUTION_TYPES(real, suffix)                                                                            \
    struct lx_lines_##suffix {                                                                                         \
        uint32_t cells;                                                                                                \
        uint32_t last; /* index of `first` */                                                                          \
        real start, per_radian;                                                                                        \
        real even; /* cells a radian, where all are alike; else 0 */                                                   \
        const uint32_t *first;                                                                                         \
        const real *edge, *line, *per_step; /* 1 over the step to the next line */                                     \
        real dark_below, dark_above;                                                                                   \
    };                                                                                                                 \
    struct lx_table_##suffix {                                                                                         \
        /* the azimuth does not matter */                                                                              \
        bool is_axial;                                                                                                 \
        /* the polar lines are of the versine, or, from `south` on, of less that from the other pole */                \
        bool by_cosine;                                                                                                \
        uint32_t south; /* the first such cell */                                                                      \
        struct lx_lines_##suffix azimuth, polar;                                                                       \
        const real *values; /* by azimuth, then by polar angle */                                                      \
    }

LX_DISTRIBUTION_TYPES(double, double);
LX_DISTRIBUTION_TYPES(float, single);

struct lx_distribution {
    struct lx_kept kept;
    const struct lx_photometry *photometry; /* what it was made of */
    luxel_photometry_interpolation interpolation;
    size_t azimuth_count, polar_count; /* lines */
    double *azimuths, *polars;         /* degrees */
    double *values;                    /* by azimuth, then by polar angle */
    double unit_cd;                    /* cd for a value of 1, a power of two; the greatest value is 1/2 to 1 */
    double zone_lumens, solid_angle;   /* flux by the zone rule; the integral of the function over all directions */
    double slope;                      /* the greatest, for a radian of a direction; infinite where it jumps */
    struct lx_table_double table_double;
    struct lx_table_single table_single;
    void *room; /* of the kernels' lines */
    struct lx_even_table even;
};

/* Makes it of a photometry, of which it becomes one more user; NULL: memory ran out.  Freed as lx_kept. */
struct lx_distribution *lx_distribution_make(struct lx_photometry *photometry,
                                             luxel_photometry_interpolation interpolation);

/* Function that frees it, by which lists of what was read tell the two interpolations apart. */
void (*lx_distribution_free_of(luxel_photometry_interpolation interpolation))(struct lx_kept *kept);

/* A distribution in space. */
struct lx_pointed {
    const struct lx_distribution *distribution;
    lx_bounded3 axis, c0, across; /* a, c0 and c0 x a: unit, at right angles */
    lx_bounded3 frame[3];         /* as above */
    double frame_double[3][3];
    float frame_single[3][3];
};

/* Points a distribution: `axis` of any length but 0, c0 not parallel to it. */
void lx_point_distribution(const struct lx_distribution *distribution, const double axis[3], const double c0[3],
                           struct lx_pointed *pointed);
/* A distribution is aimed at another place, which need not be at a distance of float64 numbers. */
void lx_aim_distribution(const struct lx_distribution *distribution, const double from[3], const double to[3],
                         const double c0[3], struct lx_pointed *pointed);

/* One that was pointed, as a frame has it. */
void lx_turn_distribution(const struct lx_pointed *pointed, const struct lx_frame *frame, struct lx_pointed *turned);

/* The function for the unit direction L to the light. */
lx_bounded lx_pointed_value(const struct lx_pointed *pointed, lx_bounded3 towards);

/* The function in plain float64, and its greatest slope, for a radian, where it does not jump. */
double lx_pointed_plain(const struct lx_pointed *pointed, const double towards[3]);
double lx_pointed_slope(const struct lx_pointed *pointed);

/* A cell of the table, and a direction in it: those near by are found without arc tangents. */
struct lx_kept_angle {
    double angle, cosine, sine;
    size_t cell;
};

struct lx_kept_cell {
    bool is_set;
    struct lx_kept_angle azimuth, polar;
};

/* The value of lx_pointed_plain() up to roundings, for directions of which many follow each other in one cell;
 * zero-initialise `kept`. */
double lx_pointed_near(const struct lx_pointed *pointed, const double towards[3], struct lx_kept_cell *kept);

/* An arc of directions L = direction cos(tau) + pole sin(tau), both unit and at right angles. */
struct lx_pointed_arc {
    double direction[3], pole[3];
    double from, width; /* of tau */
};

/* Where a line of the table crosses an arc. */
struct lx_pointed_crossing {
    double tau;
    uint32_t line; /* which one it is; one that an arc crosses twice has two numbers */
};

/* The crossings of the lines of the table and an arc, line by line, at most so many of them; how many. */
size_t lx_pointed_crossings(const struct lx_pointed *pointed, const struct lx_pointed_arc *arc, size_t most,
                            struct lx_pointed_crossing *crossings);

/* C and gamma, or the horizontal and the vertical angle, of that direction in degrees. */
void lx_pointed_angles(const struct lx_pointed *pointed, const double towards[3], double *plane_deg, double *angle_deg);

/* Breaks of the distribution, as lx_profile_break() gives them. */
bool lx_pointed_break(const struct lx_pointed *pointed, size_t i, struct lx_break *place);

#endif
