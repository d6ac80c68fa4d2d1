/* SPDX-License-Identifier: MIT */
/*
 * Kernels: the light of one emitter on a block of elements of one surface, in float32 and float64, and the
 * geometry of the shapes for a row of lines of sight.  One source, kernel.c with lanes.h and kernel_real.h, is
 * compiled once for each instruction set; lx_kernels_choose() picks at run time.
 *
 * Elements stand as a structure of arrays.  The kernels work on whole lanes: they read and write up to
 * lx_padded(count) entries of each array, and an element's result depends on that element alone, so the same
 * element gives the same bytes wherever it stands in a block.  What lies beyond the count must be places of the
 * surface, too: that a light, or a part of an extended source, reaches no element is decided for many at once.
 *
 * Lengths are mm; places are offsets from the surface's anchor.  The formulas are those of the references in
 * light/emitter.c, material/ and surface/sphere.c; those for extended sources stand in kernel_facets.h and
 * kernel_round.h.
 */
#ifndef LX_KERNEL_KERNEL_H
#define LX_KERNEL_KERNEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../base/rows.h"
#include "../light/distribution_even.h"
#include "../light/emitter.h"
#include "../material/model.h"
#include "../surface/shape.h"
#include "rules.h"

enum { LX_BLOCK = 256, LX_LANES = 16, LX_MOST_SAMPLES = 36 };

static inline size_t lx_padded(size_t count)
{
    return (count + LX_LANES - 1) / LX_LANES * LX_LANES;
}

/*
 * How the samples of a source lie.
 *
 * flat  at (x, y, z) from the anchor, in a plane of the unit normal n
 * ball  on a ball around o, in a polar frame of each element's own, so that what it sees is all there is: at the angle
 *       2 atan(x T) from the direction to the element, T = sqrt((d - R)/(d + R)), and turned from a by the angle whose
 *       cosine and sine are y and z
 * side  on a cylinder around o along n, likewise: x along n, at the angle 2 atan(y T) from the direction to the
 *       element
 */
enum lx_bend { LX_FLAT, LX_BALL_SHAPED, LX_SIDE };

/* What a kernel knows of its lights when it is compiled: parallel light, and points by their law; those whose intensity
 * depends on the direction come with any law. */
enum lx_kernel_light { LX_DISTANT, LX_BY_SQUARE, LX_BY_SUM, LX_UNATTENUATED, LX_PROFILED };

/* The constants of an emitter and a lobe, and a block of elements, once in each precision. */
#define LX_KERNEL_TYPES(real, suffix)                                                                                  \
    struct lx_exponent_##suffix {                                                                                      \
        real value;                                                                                                    \
        unsigned whole; /* the same where it is whole and not very large; else 0 */                                    \
    };                                                                                                                 \
    struct lx_light_##suffix {                                                                                         \
        enum lx_kernel_light kind;                                                                                     \
        real x, y, z; /* a point's place from the anchor, or the unit vector L */                                      \
        real gain;    /* E_perp = gain * a, with a by law: 1/r^2, 1/(k + r), 1; r in mm; or: */                        \
        enum lx_attenuation law;                                                                                       \
        real k;                                                                                                        \
        real by_none, by_root, by_square; /* 1/(by_none + by_root r + by_square r^2), r in m */                        \
        enum lx_falloff falloff;                                                                                       \
        real axis_x, axis_y, axis_z;                                                                                   \
        struct lx_exponent_##suffix exponent; /* of g; 0: none */                                                      \
        real edge;         /* of the cone: the outer versine, or the outer angle where it is linear */                 \
        real edge_slope;   /* 1 / (outer - inner) of the same */                                                       \
        real inner_cosine; /* of its angles */                                                                         \
        real cosine, sine; /* of the outer one */                                                                      \
        const struct lx_pointed *luminaire; /* instead of all of g; NULL: none */                                      \
    };                                                                                                                 \
    struct lx_lobe_##suffix {                                                                                          \
        enum lx_model model;                                                                                           \
        enum lx_highlight highlight;                                                                                   \
        real diffuse, specular;                                                                                        \
        struct lx_exponent_##suffix exponent;                                                                          \
    };                                                                                                                 \
    struct lx_block_##suffix {                                                                                         \
        _Alignas(64) real px[LX_BLOCK]; /* place from the anchor */                                                    \
        real py[LX_BLOCK], pz[LX_BLOCK];                                                                               \
        real nx[LX_BLOCK], ny[LX_BLOCK], nz[LX_BLOCK]; /* normal, unit */                                              \
        real vx[LX_BLOCK], vy[LX_BLOCK], vz[LX_BLOCK]; /* to the observer, unit */                                     \
    };                                                                                                                 \
    struct lx_samples_##suffix {                                                                                       \
        enum lx_bend bend;                                                                                             \
        real x[LX_MOST_SAMPLES], y[LX_MOST_SAMPLES], z[LX_MOST_SAMPLES];                                               \
        real gain[LX_MOST_SAMPLES];                                                                                    \
        real ox, oy, oz, ax, ay, az, nx, ny, nz, radius;                                                               \
        real height; /* normal.place of a flat one, with room for rounding: it shines on what is above */              \
        real touch;  /* elements that near to the others lie on them */                                                \
        enum lx_attenuation law;                                                                                       \
        real k, by_none, by_root, by_square; /* as in struct lx_light */                                               \
    };                                                                                                                 \
    struct lx_beams_##suffix {                                                                                         \
        _Alignas(64) real x[LX_BLOCK], y[LX_BLOCK], z[LX_BLOCK]; /* a direction, of any length */                      \
        real weight[LX_BLOCK];                                                                                         \
    };                                                                                                                 \
    struct lx_area_light_face_##suffix {                                                                               \
        real normal[3]; /* unit */                                                                                     \
        real height;    /* of its plane over the source's centre */                                                    \
    };                                                                                                                 \
    struct lx_area_light_edge_##suffix {                                                                               \
        real from[3], to[3], along[3]; /* from the centre; along = to - from */                                        \
        real both[3], product;         /* from + to, from . to */                                                      \
        real moment[3];                /* from x to */                                                                 \
        int left, right;               /* as in struct lx_edge */                                                      \
    };                                                                                                                 \
    typedef void lx_shade_##suffix(const struct lx_light_##suffix *lights, const struct lx_light_double *exacts,       \
                                   size_t light_count, const struct lx_lobe_##suffix *lobe,                            \
                                   const struct lx_block_##suffix *block, const struct lx_block_double *exact,         \
                                   const float *open, size_t count, double *sum);                                      \
    typedef void lx_shade_samples_##suffix(const struct lx_samples_##suffix *samples, size_t first, size_t count,      \
                                           const struct lx_lobe_##suffix *lobe, const struct lx_block_##suffix *block, \
                                           size_t start, real *sum);                                                   \
    typedef double lx_sum_beams_##suffix(const struct lx_beams_##suffix *beams, size_t count,                          \
                                         const struct lx_lobe_##suffix *lobe, const double normal[3],                  \
                                         const double view[3])

/*
 * lx_shade_single, lx_shade_double: add to sum[i] what the lights, at least one and all of one kind, give to element i.
 * open[i] is 1 where the way to them is free, 0 where it is blocked; NULL: free everywhere.  The same lights and
 * elements in float64 tell float32 on which side of an edge an element lies; they may be NULL in float64, and where
 * lx_has_edges() says no.
 *
 * lx_shade_samples_single, lx_shade_samples_double: samples of Lambertian area lights.  Set sum[0 ... LX_LANES - 1] to
 * the brightness that `count` of them, from the first on, give to the elements from `start` on.  A sample gives gain
 * cos(its angle) a, with a by law: 1/r^2, 1/(k + r), 1; r in mm.  Of a ball gain is area, over R^2, for a unit of x and
 * of the turn, but for sin(angle) d angle/dx; of a side over R for a unit of length and y, but for d angle/dy.
 *
 * lx_sum_beams_single, lx_sum_beams_double: what one element makes of light from many directions: the sum of their
 * weights times the highlight, for a specular coefficient of 1 and not cut at the horizon, over the cubes of their
 * lengths.  Of `count` directions in whole lanes; those beyond the ones that are meant weigh 0.
 */
LX_KERNEL_TYPES(double, double);
LX_KERNEL_TYPES(float, single);

/* Sets values[i], of `count` elements, to `uniform` and what the lights give, whose way is free and which have no
 * edges. */
typedef void lx_value_single(const struct lx_light_single *lights, size_t light_count,
                             const struct lx_lobe_single *lobe, const struct lx_block_single *block, size_t count,
                             float uniform, float *values);

/* What some values have in common, none of which is below 0. */
struct lx_survey {
    double maximum;  /* 0 where there are none */
    double minimum;  /* of those from `least` up; infinite where there are none */
    size_t at_least; /* how many those are */
    double sum;      /* by LX_LANES sums of every LX_LANES-th, the same by all sets; NaN where one is */
};

typedef struct lx_survey lx_survey_single(const float *values, size_t count, double least);
typedef struct lx_survey lx_survey_double(const double *values, size_t count, double least);

/* The lines of sight of a row of pixels. */
struct lx_row_view {
    bool perspective;
    double observer_z_mm;
    double y_mm; /* of the row on the screen */
};

/*
 * For the screen points (x[i], y): depth[i], how far along the line of sight the shape is met (infinite where
 * it is not; comparable between shapes), and the place there, from the shape's anchor.  Returns how many meet it.
 */
typedef size_t lx_meet_lines(const struct lx_shape *shape, const struct lx_row_view *view, const double *x_mm,
                             size_t count, double *depth, double *px, double *py, double *pz);

/*
 * Fills in the normals and view vectors of a block whose places are set, and copies the block to float32.
 * `observer_mm` is the observer's place from the shape's anchor; NULL: the view vectors stay as they are.
 */
typedef void lx_complete_block(const struct lx_shape *shape, const double *observer_mm, struct lx_block_double *block,
                               struct lx_block_single *copy, size_t count);

/* What a block holds of a run of pixels: `count` elements from pixel `first` on, of which `met` are on the shape. */
struct lx_stretch {
    size_t first, count, met;
};

/* What lines of sight along -z in some columns have in common whatever their row: where they are on the screen and from
 * the anchor, and of a sphere the normal's x, and its square in twice the precision. */
struct lx_columns {
    _Alignas(64) double x_mm[LX_BLOCK];
    float px[LX_BLOCK], nx[LX_BLOCK], square[LX_BLOCK], rest[LX_BLOCK];
    size_t count;
};

/* Sets columns to those of lines from left to right, the last of which is repeated up to lx_padded(count). */
typedef void lx_set_columns(const struct lx_shape *shape, const double *x_mm, size_t count, struct lx_columns *columns);

/*
 * Both at once, in float32 alone, of a row of such lines.  Sets mask[i] to 1 where line i meets the shape, else to 0,
 * and the places and normals of a block, from the first whole lanes with such a line to the last ones, to what the two
 * functions above make, within 2^-23 of the shape's radius and of 1.  The light of elements between that are not on the
 * shape means nothing.
 */
typedef struct lx_stretch lx_view_single(const struct lx_shape *shape, const struct lx_row_view *view,
                                         const struct lx_columns *columns, struct lx_block_single *block,
                                         uint8_t *mask);

/* Sets values to one number, and rounds them to float32: plain loops, but a tenth of a picture under one light. */
typedef void lx_set_all(double *values, size_t count, double number);
typedef void lx_round_all(const double *values, size_t count, float *rounded);

/*
 * A polynomial of the place in a square of `side` times `side` pixels of a picture: the sum of terms[j][i] u^j t^i over
 * i, j < size, with t = (2 column + 1)/side - 1, likewise u of the row; and the power of it that is meant.
 */
enum { LX_MOST_NODES = 16, LX_PANEL_SIDE = 64 };
struct lx_polynomial {
    _Alignas(64) float terms[LX_MOST_NODES][LX_LANES]; /* in the first rows that the size tells; 0 beyond them there */
    unsigned size;                                     /* 6, 7, 8, 12 or 16 */
    unsigned side;                                     /* LX_PANEL_SIDE or half of it */
    unsigned power;                                    /* from 1 on */
};

/* Sets values[row * stride + column] of the square's first rows and columns, no more than `side`, to the polynomial's
 * power, or `adds` it to them; where the polynomial is less than 0, 0. */
typedef void lx_spread_polynomial(const struct lx_polynomial *polynomial, unsigned rows, unsigned columns, bool adds,
                                  float *values, size_t stride);

/*
 * The polynomial through values at nodes x nodes places, an even number from 8 on, values[row * nodes + column];
 * series[node][k]: the share of Chebyshev's polynomial T_k in what is 1 at a node and 0 at the others, 0 beyond the
 * nodes.  Of these polynomials the last ones are left out where all that is left out is below the roundings of float32.
 * Returns what the terms may be off by, for that reason and in float32.  Side and power are the caller's to set.
 */
typedef double lx_find_polynomial(const double (*series)[LX_LANES], unsigned nodes, const double *values,
                                  struct lx_polynomial *polynomial);

/*
 * A luminaire over a square of pixels: what it would give if it shone with 1 in all directions, times g, which is what
 * a cell of its table makes of two angles (light/distribution_even.h).  All three are polynomials, the angles in cells
 * from the first one that the square sees; with `by_cosine` so is the cosine of the polar angle, less that of the
 * middle, from which the share of a cell comes.
 */
enum { LX_MOST_LINES = 128 };
struct lx_tabled {
    struct lx_polynomial brightness, polar, azimuth, cosine;
    unsigned size;            /* of the largest of them; terms beyond their own sizes are 0 */
    bool is_axial, by_cosine; /* is_axial: there is no azimuth */
    const lx_even_cell *cells;
    int row;                                                    /* cells of an azimuth */
    int first_polar, first_azimuth, polar_count, azimuth_count; /* cells that the square sees */
    int turn;                                                   /* number of azimuths behind which they begin again */
    float start[LX_MOST_LINES], per_step[LX_MOST_LINES]; /* of each cell: the cosine there, less that of the middle */
};

/* Adds the light of a luminaire to the square's first rows and columns, as lx_spread_polynomial() takes them. */
typedef void lx_spread_tabled(const struct lx_tabled *tabled, unsigned rows, unsigned columns, float *values,
                              size_t stride);

/*
 * Angles under which a luminaire at a place from the anchor sees the elements of a block: the polar angle, its cosine,
 * and the azimuth from the one whose cosine and sine are in `ahead`, -pi to pi; NULL where they are not asked for.
 */
typedef void lx_find_angles(const struct lx_pointed *luminaire, const double place[3], const double ahead[2],
                            const struct lx_block_double *block, size_t count, double *polar, double *cosine,
                            double *azimuth);

/*
 * How far a vector that depends on the place (x, y) on the screen may be from what it is in the middle of a square,
 * where x and y are complex numbers of some region around it (smooth.h): its real part by a change `first` that real
 * x and y could make as well, and by `second` besides; its imaginary part; and by `tile` within the square itself.
 */
struct lx_deviation {
    double first, second, imaginary, tile;
};

/* The elements of a surface in such a region: in the middle, and how far from that; lengths from the anchor. */
struct lx_vicinity {
    double place[3], normal[3], view[3];
    double level; /* normal . place, which is the same everywhere */
    /* how far a plate's place is from the middle where it moves along a line by a complex number, and along the other
     * axis as within the square; infinite on what is no plate */
    double straight;
    double slip; /* what may not be analytic counts for so many times its largest value in the square */
    struct lx_deviation place_deviation, normal_deviation, view_deviation;
};

/*
 * Lights as lx_bound_smooth() takes them, a structure of arrays, each of which goes on to whole lanes.
 *
 * radius         within which places of a light are from its own, any of which it may have; 0: it is a point
 * strays, sways  likewise, of their real and their imaginary parts, at complex places of the surface
 * moves          1 for a point, 0 for a direction
 * by_square ...  E_perp = gain/(by_square r^2 + by_root r + by_none)
 * inner, outer   all of the light is within the cone with the first cosine, none without the second
 * exponent       of the cosine pattern, or 0; is_broken: 1 where that is not whole, else 0
 */
struct lx_smooth_lights {
    double *x, *y, *z, *radius, *strays, *sways, *moves, *gain, *by_square, *by_root, *by_none;
    double *axis_x, *axis_y, *axis_z, *inner, *outer, *exponent, *is_broken;
    size_t count;
};

/* Sets sizes[i] to a bound of the brightness by light i, as an analytic function, in the vicinity, with the slip of a
 * highlight that may not be one; to that less than 0 where N.L, which is cut off at 0, may be so within the square;
 * infinite where the light may not be analytic.  Of whole lanes of lights from `first` on, up to `end`. */
typedef void lx_bound_smooth(const struct lx_vicinity *vicinity, const struct lx_smooth_lights *lights, size_t first,
                             size_t end, const struct lx_lobe_double *lobe, double *sizes);

/* The n-th root of a highlight E_perp ks S^n: a bound of it as an analytic function in a vicinity, and one of the
 * highlight itself within the square. */
struct lx_foot {
    double root, most;
};

/* The root for light i, the only one that reaches the square, and a lobe with a plain highlight and a whole exponent n.
 * The root is infinite where there may be no such function, S may be 0, or diffuse light is not cut off. */
typedef struct lx_foot lx_bound_foot(const struct lx_vicinity *vicinity, const struct lx_smooth_lights *lights,
                                     size_t i, const struct lx_lobe_double *lobe);

/* Replaces normal numbers above 0, up to whole lanes, by their n-th roots. */
typedef void lx_find_roots(double *values, size_t count, double n);

/* A shape in the way of light: its anchor stands relative to the block's; the light is a place or a direction. */
struct lx_blocker {
    struct lx_shape shape;
    bool is_point;
    double light[3];
};

/* Sets open[i] to 0 for the elements that the shape takes the light from; leaves the others. */
typedef void lx_block_light(const struct lx_blocker *blocker, const struct lx_block_double *block, size_t count,
                            float *open);

/* A convex quadrilateral of a face, whose corners are offsets from the source's centre, counter-clockwise as seen from
 * where it shines to; of a triangle the last corner is the first one. */
struct lx_area_light_quad {
    double corners[4][3], normal[3];
};

/* a(r) = 1/(none + root r + square r^2), r in mm, times what makes mm^2 of the source m^2; as it has poles at negative
 * r, or where their real part is, 1/r is no more than minus `pole` at any of them. */
struct lx_area_light_law {
    double none, root, square, pole;
};

/* A place of a rule over a flat part of an area light, from the source's centre, and what it weighs in mm^2. */
struct lx_area_light_node {
    double x_double, y_double, z_double, weight_double;
    float x_single, y_single, z_single, weight_single;
};

/* An extended source, as offsets from the anchor of a surface or from the source's centre. */
struct lx_area_light {
    enum lx_emitter_type type; /* for the tables of kernels alone */
    bool is_disk, is_ball, has_side;
    bool is_general; /* no kernels are for it: the reference and integrals light each element */
    double radiance;
    struct lx_area_light_law law;
    double center[3]; /* from the anchor */
    double radius_mm; /* of a sphere about the centre around all of it */
    double touch_mm;  /* heights below this are rounding */
    double axis[3];   /* of a disk or cylinder */
    double round_mm;  /* radius of a round one */
    double half_mm;   /* half the height of its side */
    double turned_mm2,
        section_mm2; /* of its area what counts as turned to one place at most, and its largest section */
    struct lx_area_light_face_double *faces_double;
    struct lx_area_light_edge_double *edges_double;
    struct lx_area_light_face_single *faces_single; /* NULL where float32 does not do */
    struct lx_area_light_edge_single *edges_single;
    size_t face_count, edge_count;
    struct lx_area_light_quad *quads; /* of all faces, where the law is not 1/r^2 */
    size_t quad_count;
    /*
     * Where it is so far from the surface that rules of a few places do for all elements that see all of it; else 0.
     * As many places of each flat part, which are the quadrilaterals, or the end along the axis and the other one; of a
     * ball as many rings, which have no places of their own.
     */
    unsigned nodes_each;
    struct lx_area_light_node *nodes;
    size_t most_patches;            /* that its faces can be cut into (patch.h) */
    const struct lx_facets *facets; /* what they were made of; NULL: it is round */
};

/* A ball around the places of a block. */
struct lx_around {
    double center[3], radius;
};

/* Add `diffuse` times the irradiance by the law 1/r^2, r in mm and the area light in mm; something else where the work
 * is to stop. */
typedef void lx_light_by_area_light_single(const struct lx_area_light *lamp, double diffuse,
                                           const struct lx_block_single *block, size_t count,
                                           const struct lx_asking *asking, double *sum);
typedef void lx_light_by_area_light_double(const struct lx_area_light *lamp, double diffuse,
                                           const struct lx_block_double *block, size_t count,
                                           const struct lx_asking *asking, double *sum);

/*
 * Add `diffuse` times the irradiance by the area light's own law, to what the rules are for, and set left[i] to 1, and
 * add nothing, where they do not do as the element is too near; something else where the work is to stop.  In float32
 * or float64, from elements in float64.
 */
typedef void lx_light_by_law(const struct lx_area_light *lamp, const struct lx_gauss_rules *rules, double diffuse,
                             const struct lx_block_double *block, size_t count, const struct lx_asking *asking,
                             double *sum, uint8_t *left);

struct lx_kernels {
    const char *name;
    bool (*runs)(void); /* whether this machine has the instruction set */
    unsigned width;     /* of its vectors, in numbers of float32 */
    lx_shade_single *shade_single;
    lx_shade_double *shade_double;
    lx_value_single *value_single;
    lx_shade_samples_single *samples_single;
    lx_shade_samples_double *samples_double;
    lx_sum_beams_single *beams_single;
    lx_sum_beams_double *beams_double;
    lx_survey_single *survey_single;
    lx_survey_double *survey_double;
    lx_set_all *set_all;
    lx_round_all *round_all;
    lx_find_polynomial *find_polynomial;
    lx_spread_polynomial *spread_polynomial;
    lx_spread_tabled *spread_tabled;
    lx_find_angles *find_angles;
    lx_bound_smooth *bound_smooth;
    lx_bound_foot *bound_foot;
    lx_find_roots *find_roots;
    lx_light_by_area_light_single *facets_single;
    /* by the type of the emitter; NULL for those that are not extended */
    lx_light_by_area_light_double *light_by_area_light[LX_EMITTER_TYPES];
    lx_light_by_law *law_single[LX_EMITTER_TYPES], *law_double[LX_EMITTER_TYPES];
    /* by the type of the shape */
    lx_meet_lines *meet_lines[LX_SHAPE_TYPES];
    lx_complete_block *complete_block[LX_SHAPE_TYPES];
    lx_set_columns *set_columns[LX_SHAPE_TYPES];
    lx_view_single *view_single[LX_SHAPE_TYPES];
    lx_block_light *block_light[LX_SHAPE_TYPES];
};

/* The kernels by name ("x86-64-v3", "v3" ...; NULL: by LUXEL_ISA, else the best that runs here); NULL: none. */
const struct lx_kernels *lx_kernels_choose(const char *name);

/* The sets that were built, best first; NULL beyond the last. */
const struct lx_kernels *lx_kernels_get(size_t i);

#endif
