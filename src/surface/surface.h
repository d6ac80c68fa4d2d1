/* SPDX-License-Identifier: MIT */
/*
 * Kinds of surfaces.  A kind describes its authored parameters by a table, prepares its constants, and answers for its
 * geometry: nothing outside this room asks which kind it has.  To add one: docs/ADDING-A-SURFACE.md.
 *
 * What a kind may leave out is NULL, and the functions at the end of this header, or whoever asks, then go the general
 * way: float64 only, shadows and lines of sight by the reference, extrema by a search on the screen.
 */
#ifndef LX_SURFACE_SURFACE_H
#define LX_SURFACE_SURFACE_H

#include "../base/frame.h"
#include "../format/mesh/mesh_survey.h"
#include "../parameter/table.h"
#include "obstacle.h"
#include "shape.h"

struct lx_part;
struct lx_smooth_sheet;

/*
 * A line of sight: origin + t direction, t > 0; the direction need not be of unit length.  Both may be rounded, by no
 * more than these errors, which the place and the normal of a hit take over into theirs.
 */
struct lx_ray {
    double origin_mm[3], direction[3];
    double origin_error[3], direction_error[3];
};

/* The direction of a ray with its errors. */
static inline lx_bounded3 lx_ray_direction(const struct lx_ray *ray)
{
    const double *value = ray->direction, *error = ray->direction_error;
    return (lx_bounded3){{value[0], error[0]}, {value[1], error[1]}, {value[2], error[2]}};
}

/* Where a ray meets a surface: after t times its direction. */
struct lx_hit {
    bool exists;
    double t;
    lx_bounded3 place_mm, normal;
};

/* Where a light or an observer is: a place in mm, or, `endless`, a direction. */
struct lx_origin {
    bool endless;
    double at[3];
};

/* How an observer stands to a surface. */
enum lx_standing {
    LX_STANDS_BEFORE,  /* where the surface can be seen */
    LX_STANDS_TOO_LOW, /* not above all of it */
    LX_SEES_BACK       /* behind its front, or in its plane: it is not drawn */
};

enum { LX_MOST_GUESSES = 4 };

/*
 * Coordinates on a surface that stay smooth where the screen's do not, as at the rim of a sphere, in which a search can
 * walk: three numbers `at`, of which a kind may leave some 0.
 */
struct lx_surface_chart {
    bool by_normal; /* the coordinates are the unit normal itself, as of a sphere alone */
    /* Coordinates of a place, an offset from the anchor, with its unit normal; and the way back. */
    void (*locate)(const struct lx_shape *shape, const double offset_mm[3], const double normal[3], double at[3]);
    void (*place)(const struct lx_shape *shape, const double at[3], double place_mm[3], double normal[3]);
    /* Place and normal with bounds of the errors; `at` need not be normalized. */
    void (*element)(const struct lx_shape *shape, const double at[3], lx_bounded3 *place_mm, lx_bounded3 *normal);
    /* Two directions in which coordinates change, and coordinates moved by so many mm along them. */
    void (*directions)(const struct lx_shape *shape, const double at[3], double first[3], double second[3]);
    void (*move)(const struct lx_shape *shape, const double at[3], const double first[3], const double second[3],
                 const double step_mm[2], double moved[3]);
    /* Where what can be seen ends: how far inside of wall i (from 0 to walls - 1) a place lies, about in mm. */
    unsigned walls;
    double (*wall)(const struct lx_shape *shape, const struct lx_origin *eye, unsigned i, const double at[3]);
    /* Place i of `count` along the rim of what can be seen, and the middle of that. */
    void (*rim)(const struct lx_shape *shape, const struct lx_origin *eye, int i, int count, double at[3]);
    void (*middle)(const struct lx_shape *shape, const struct lx_origin *eye, double at[3]);
    /* NULL where lines of sight nowhere touch the surface.  Whether they nearly do so at a place, so that the screen
     * does not tell it from others; then *inside is a place towards whose picture the surface goes on. */
    bool (*is_near_limb)(const struct lx_shape *shape, const struct lx_origin *eye, const double at[3],
                         double inside_mm[3]);
    /* Places where geometry puts extrema under a light: where it is nearest, where it is mirrored to `viewer`; for the
     * least value also where it is farthest.  Returns how many; NULL: none are known. */
    int (*guess)(const struct lx_shape *shape, const struct lx_origin *light, const struct lx_origin *viewer,
                 bool for_least, double at[LX_MOST_GUESSES][3]);
};

/* What the a-priori bounds of rounding (picture/precision.h) ask of a shape. */
struct lx_surface_bounds {
    /* The place of a convex body that is farthest in a direction, from the anchor; returns the radius of the ball that
     * has to be added to that body for the surface. */
    double (*support)(const struct lx_shape *shape, const double direction[3], double place[3]);
    /* The least cosine over the surface between its normal and the direction to a place at the distance `away`; or a
     * direction (0).  NULL: not known. */
    double (*least_cosine)(const struct lx_shape *shape, const double towards[3], double away);
    double widest_turn; /* of the direction from the surface to a place nearer to the anchor than radius_mm */
    /* 1/R of a sphere, 0 of a plane.  NULL: neither of them. */
    double (*curvature)(const struct lx_shape *shape);
};

/*
 * What explanations say of a kind: a formula for the height along z, that with numbers for @R, @x, @y, @z (the place),
 * @X, @Y, @Z (the centre); one for the normal; a sentence (LX_N) with its formulas, NULL beyond the last.
 */
struct lx_surface_words {
    const char *height, *height_in_numbers, *normal;
    const char *sentence, *formulas[4];
};

/* A round opening of a shape, in the plane of its rim. */
enum { LX_MOST_OPENINGS = 2 };
struct lx_shape_opening {
    double center_mm[3], axis[3], radius_mm;
};

struct lx_surface_kind {
    struct lx_variant variant; /* first, so that a variant of the list `surfaces` is its kind */

    /* -- required; of a kind of parts (part.h) only the extent and the shape's place and size -- */

    /* The extent of the surface along the axes, in mm: lowest and highest x, y, z. */
    void (*extent)(const void *parameters, double low_mm[3], double high_mm[3]);
    /* The shape: the constants that all below compute with.  lx_surface_shape() sets its kind, unless parameters chose
     * another one that answers for it. */
    struct lx_shape (*shape)(const void *parameters);
    /* The reference: the first point of the surface on the ray, seen from its front. */
    struct lx_hit (*hit)(const struct lx_shape *shape, const struct lx_ray *ray);
    /* The unit normal at a place of the surface, an offset from the anchor. */
    void (*normal)(const struct lx_shape *shape, const double offset_mm[3], double normal[3]);
    /* Whether the surface crosses the open way from a place to `towards` away from it, that is between the
     * parameters 0 and 1 of place + t towards; `endless`: from 0 on.  1 or 0, the error 1 where it is in doubt. */
    lx_bounded (*blocks)(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless);
    /* Whether a place lies on the surface, to 1e-9 of its size. */
    bool (*holds)(const struct lx_shape *shape, const double place_mm[3]);

    /* -- what may be NULL, or false -- */

    /* What its parts are called, NULL-terminated, and how many there are; makes part i of them. */
    const char *const *part_names;
    unsigned part_count;
    void (*part)(const void *parameters, unsigned i, struct lx_part *part);

    /* Whether its own keys make its front a mirror, as a material may, too.  NULL: it cannot be one. */
    bool (*is_mirror)(const void *parameters);
    /* Whether it takes light from its own elements, as what is hollow or folded does: then `blocks` and `takes` are
     * asked for these, too, and have to leave out where the way begins.  Only for shapes without kernels of their own,
     * LX_GENERAL. */
    bool hides_itself;
    /* `hit` and `blocks` in plain float64, for the pixels of pictures, from an offset from the anchor: where a ray is
     * met, and whether a way is taken.  NULL: by those. */
    bool (*meets)(const struct lx_shape *shape, const double from_mm[3], const double direction[3], double *t,
                  double offset_mm[3]);
    bool (*takes)(const struct lx_shape *shape, const double from_mm[3], const double way[3], bool endless);
    /*
     * For a kind that may be seen from both of its sides, or whose normals need not be those of its faces: the unit
     * normal that a line of sight along `sight` sees at a place, turned to it.  NULL: `normal`.  `hides` and
     * `gather_beside` are then asked of all its own elements, and `is_behind` of those of pictures, in plain float64:
     * whether a way leads behind the face of an element with that normal.
     */
    void (*normal_seen)(const struct lx_shape *shape, const double offset_mm[3], const double sight[3],
                        double normal[3]);
    bool (*is_behind)(const struct lx_shape *shape, const double offset_mm[3], const double normal[3],
                      const double way[3]);
    /* How far it reaches along a direction: the greatest place . direction over the surface.  NULL: as its extent. */
    double (*farthest)(const void *parameters, const double direction[3]);
    /* How an observer stands to it who is at (0, 0, z), or, not in perspective, looks along -z from all that height;
     * `highest` is its greatest z.  NULL: before it where all of it is lower. */
    enum lx_standing (*standing)(const struct lx_shape *shape, double highest_mm, double observer_z_mm,
                                 bool perspective);
    /* Whether a source here lights nothing of it that is seen along -z: it is inside or behind.  NULL: never. */
    bool (*is_dark)(const struct lx_shape *shape, const double place_mm[3]);
    /* Carries what a shape has beside its place and its directions into a frame.  NULL: that looks the same in any. */
    void (*carry)(const struct lx_frame *frame, struct lx_shape *shape);
    /* Whether it is all around a place of the scene: whoever stands there cannot see all of it.  NULL: never. */
    bool (*surrounds)(const void *parameters, const double place_mm[3]);
    /*
     * Whether it takes light from a free element that it holds, on the side that the element's unit normal looks to;
     * `facing` is that normal's cosine to the surface's own.  The way to the light and the answer are as of `blocks`.
     * NULL: light from the other side of the tangent plane has to come through.
     */
    lx_bounded (*hides)(const struct lx_shape *shape, lx_bounded3 place_mm, double facing, lx_bounded3 towards,
                        bool endless);
    /*
     * What it takes of the light of extended sources: appends its obstacles (obstacle.h) that may come into a shaft,
     * which together take what `blocks` tells.  0, or -1 when memory ran out.  NULL: `blocks` is scanned.
     */
    int (*gather)(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles);
    /* For kinds that gather sheets: how many an open way from a place passes, an offset from the anchor, but for those
     * that `gather` left out because that place lies on them. */
    unsigned (*layers)(const struct lx_shape *shape, const double from_mm[3], const double way[3]);
    /* Appends the obstacles that take what `hides` tells; `beyond` hides what lies beyond the tangent plane.  NULL:
     * that, or nothing from an element that looks away from the surface. */
    int (*gather_beside)(const struct lx_shape *shape, double facing, const struct lx_obstacle *beyond,
                         const struct lx_shaft *shaft, struct lx_obstacles *obstacles);
    /* Whether a place is inside the body that it bounds, and not on the surface.  NULL: it bounds none. */
    bool (*encloses)(const struct lx_shape *shape, const double place_mm[3]);
    /* The openings that are to be covered before it bounds one, and whether a shape covers one.  NULL: there are none;
     * it covers none. */
    unsigned (*openings)(const struct lx_shape *shape, struct lx_shape_opening openings[LX_MOST_OPENINGS]);
    bool (*covers)(const struct lx_shape *shape, const struct lx_shape_opening *opening);
    /* How far outside of it a place is, an offset from the anchor, and in which direction from the nearest point; less
     * than 0 inside or behind.  NULL: by the ball around it. */
    double (*distance)(const struct lx_shape *shape, const double offset_mm[3], double direction[3]);
    /* Whether an observer may see anything of it: of what is flat, its front.  Else it hides nothing from sight.
     * NULL: always. */
    bool (*faces)(const struct lx_shape *shape, const struct lx_origin *eye);
    /* As `beside`, of the way to an observer who it faces, where it hides other things from sight than from light.
     * NULL: it does not. */
    double (*beside_sight)(const struct lx_shape *shape, const double place_mm[3], const struct lx_origin *eye);
    /* How far the way from a place passes by it; 0 on the edge of its shadow, less inside, smooth beside both. */
    double (*beside)(const struct lx_shape *shape, const double place_mm[3], const double way[3], bool endless);
    /* Quadratic functions of the place, one of which is 0 where its shadow begins: the value of function i, from 0 to
     * shadow_edges - 1, at a place; NaN where the light makes no such edge. */
    unsigned shadow_edges;
    double (*shadow_edge)(const struct lx_shape *shape, const struct lx_origin *light, unsigned i,
                          const double place_mm[3]);
    /* Place i of the shape, from 0 on, where its shadow turns though the edges there only touch; false: there is none.
     * NULL: there are none. */
    bool (*shadow_corner)(const struct lx_shape *shape, const struct lx_origin *light, unsigned i, double place_mm[3]);
    /* Place i of `steps` along the closed outline of what is seen of it, and one that is seen a little inside. */
    void (*outline)(const struct lx_shape *shape, const struct lx_origin *eye, int i, int steps, double place_mm[3],
                    double inside_mm[3]);
    /* The mesh that parameters name, where they do.  NULL: never. */
    bool (*mesh)(const void *parameters, struct lx_mesh_use *use);
    /* Its sides, cut into sheets (sheet.h), in room for LX_MOST_SHEETS; returns how many.  NULL: nobody can integrate
     * over it, so that it cannot stand in a scene with reflections, unless it is a mesh, or of parts that can. */
    int (*sheets)(const struct lx_shape *shape, struct lx_smooth_sheet *sheets);
    const struct lx_surface_chart *chart;
    const struct lx_surface_bounds *bounds;
    const struct lx_surface_words *words;
};

/* NULL-terminated: the variants of the list `surfaces`. */
extern const struct lx_variant *const lx_surface_variants[];

/* The way from a place to a light or an observer; returns whether it is without end. */
static inline bool lx_way_to(const struct lx_origin *origin, const double place_mm[3], double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] = origin->endless ? origin->at[i] : origin->at[i] - place_mm[i];
    return origin->endless;
}

/* 1/R of a sphere, 0 of what lies in a plane, less than 0 of all else. */
static inline double lx_curvature(const struct lx_shape *shape)
{
    const struct lx_surface_bounds *bounds = shape->kind->bounds;
    return bounds && bounds->curvature ? bounds->curvature(shape) : -1;
}

/* Whether it lies in a plane, as it tells: what stands before that lies on one side of it. */
static inline bool lx_shape_is_flat(const struct lx_shape *shape)
{
    return lx_curvature(shape) == 0;
}

/* Whether a surface may take light from an element, its own or another's. */
static inline bool lx_may_hide(const struct lx_shape *shape, bool is_own)
{
    return !is_own || shape->kind->hides_itself || shape->behind_mm > 0;
}

/* How far rounding may take a shape out of its extent, as something that is seen or in the way. */
static inline double lx_shape_room(const struct lx_shape *shape)
{
    return 2 * shape->touch_mm + 4 * shape->behind_mm;
}

/* The shape as something in the way of light: moved back by behind_mm, and larger by as much. */
struct lx_shape lx_shape_in_the_way(const struct lx_shape *shape);

/* The shape of authored parameters. */
struct lx_shape lx_surface_shape(const struct lx_surface_kind *kind, const void *parameters);

/* Whether the sides of a kind are known to whoever integrates over them. */
bool lx_surface_has_sides(const struct lx_surface_kind *kind);

/* A shape as a frame has it; but for roundings it is the same. */
struct lx_shape lx_shape_carried(const struct lx_shape *shape, const struct lx_frame *frame);

/* What the kind answers, or in general. */
double lx_surface_farthest(const struct lx_surface_kind *kind, const void *parameters, const double direction[3]);

/* A surface in the frame of a screen: its extent along the axes there, how an observer at the height z stands to it,
 * and whether a source at a place of the scene lights nothing of it that is seen. */
void lx_surface_extent(const struct lx_surface_kind *kind, const void *parameters, const struct lx_frame *frame,
                       double low_mm[3], double high_mm[3]);
enum lx_standing lx_surface_standing(const struct lx_surface_kind *kind, const void *parameters,
                                     const struct lx_frame *frame, double observer_z_mm, bool perspective);
bool lx_surface_is_dark(const struct lx_surface_kind *kind, const void *parameters, const struct lx_frame *frame,
                        const double place_mm[3]);
bool lx_surface_surrounds(const struct lx_surface_kind *kind, const void *parameters, const double place_mm[3]);

/* Standing of observers to what they may be in: before it above its lowest place.  Its middle is its anchor. */
enum lx_standing lx_standing_within(const struct lx_shape *shape, double highest_mm, double observer_z_mm,
                                    bool perspective);
double lx_shape_distance(const struct lx_shape *shape, const double offset_mm[3], double direction[3]);
bool lx_shape_faces(const struct lx_shape *shape, const struct lx_origin *eye);
double lx_shape_beside_sight(const struct lx_shape *shape, const double place_mm[3], const struct lx_origin *eye);

/* Whether a search can walk on it and over the edges of its shadow. */
bool lx_shape_is_walkable(const struct lx_shape *shape);

/* Whether its rim is where lines of sight touch it. */
bool lx_shape_has_limb(const struct lx_shape *shape);

#endif
