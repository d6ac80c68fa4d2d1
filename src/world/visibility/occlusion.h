/* SPDX-License-Identifier: MIT */
/*
 * Occlusion: what surfaces take from one element of one extended source.
 *
 * The obstacles (surface/obstacle.h) between them are gathered once.  On each arc of a sweep, which lies in a half
 * plane from the element, an obstacle is a segment, a circle or a conic, and the source a line or a circle: so the
 * latitudes at which light begins to be hidden and is seen again are known in closed form, and the integral along the
 * arc runs over what is left.  Across the arcs it is continuous; the longitudes at which obstacles begin and end are
 * known before, and where else arcs change their form the adaptive rule is told (adaptive.h).
 */
#ifndef LX_WORLD_OCCLUSION_H
#define LX_WORLD_OCCLUSION_H

#include <stdint.h>

#include "../../surface/obstacle.h"
#include "../element.h"
#include "../integral/sweep.h"

struct lx_prepared;

/* A hidden part of an arc in tau: where it begins and ends, what bounds it there, and how far that may be off. */
struct lx_hidden {
    double ends[2], slack[2];
    unsigned bounds[2];
};

struct lx_sheet_outline;

/* Planes through the element behind which nothing is looked at: its horizon, that of the face it lies on, and those of
 * the edges of an opening. */
enum { LX_MOST_HORIZONS = 6 };

struct lx_occlusion {
    struct lx_obstacles obstacles; /* their places are offsets from the element, but those of shapes */
    struct lx_shaft shaft;
    double place_mm[3];
    double horizons[LX_MOST_HORIZONS][3];
    unsigned horizon_count;
    struct lx_sheet_outline *outline; /* of the sheets, whose memory is kept */
    bool has_outline, is_dark;        /* they hide something perhaps; all, certainly */
    bool has_polygons;                /* those that may reach into a round source are obstacles as well */
    double error_mm;                  /* how far any of them may be off */
    struct lx_hidden *hidden;         /* room for the most on an arc */
    size_t most_hidden;
};

/* A part of an arc that is seen, with what bounds it. */
struct lx_seen_arc {
    double from, to;
    unsigned bounds[2]; /* 0: it is not an obstacle */
    double slack[2];
};

/*
 * Gathers what may stand between an element and a source that it does not touch, and room to work.  `above`: what is
 * below the element's horizon does not matter.  0, or -1 when memory ran out.  Clear in any case.
 */
int lx_occlusion_make(const struct lx_prepared *prepared, const struct lx_element *element,
                      const struct lx_emitter *emitter, bool above, struct lx_occlusion *occlusion);
void lx_occlusion_clear(struct lx_occlusion *occlusion);

/*
 * Gathering step by step: begins with no obstacles, and returns the shaft in which they are to be gathered; gathers
 * those of a shape, which may be the element's own, turned away from its normal; then leaves out those that hide
 * nothing.  `normal`: what is below that horizon does not matter; NULL: it does.  0, or -1 when memory ran out.
 */
const struct lx_shaft *lx_occlusion_begin(const double place_mm[3], const double *normal,
                                          const struct lx_emitter *emitter, struct lx_occlusion *occlusion);
int lx_occlusion_gather(const struct lx_shape *shape, bool is_own, bool is_turned, const double normal[3],
                        struct lx_occlusion *occlusion);
int lx_occlusion_settle(const struct lx_emitter *emitter, double place_error_mm, struct lx_occlusion *occlusion);

/* Room for what is hidden of an arc, when outlines are laid out; 0, or -1. */
int lx_occlusion_make_room(struct lx_occlusion *occlusion);

/* Whether one of the obstacles hides all of the source, as far as can be told at once. */
bool lx_occlusion_hides_all(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter);

static inline bool lx_is_occluded(const struct lx_occlusion *occlusion)
{
    return occlusion && (occlusion->obstacles.count > 0 || occlusion->has_outline || occlusion->is_dark);
}

/* The shaft from a ball of places to a source; all obstacles that count are before it. */
struct lx_shaft lx_shaft_to(const double from_mm[3], double radius_mm, const struct lx_emitter *emitter);

/* What is hidden of an arc: parts in the order of tau that share nothing; returns how many, in occlusion->hidden. */
size_t lx_occlusion_hide(const struct lx_occlusion *occlusion, const struct lx_sweep *sweep, const struct lx_arc *arc);

/* What one obstacle hides of an arc, appended from hidden[count] on; returns the new count.  `number` from 1. */
size_t lx_obstacle_hide(const struct lx_occlusion *occlusion, size_t number, const struct lx_sweep *sweep,
                        const struct lx_arc *arc, struct lx_hidden *hidden, size_t count);

/* The most parts that an obstacle may hide of an arc. */
enum { LX_MOST_HIDDEN = 4, LX_SCANNED = 64 };

/*
 * Directions (of any length) whose longitudes about a frame's pole are those where an obstacle begins, ends, or has a
 * corner; returns how many.  *round: there the hidden part begins like a root.
 */
enum { LX_MOST_MERIDIANS = 4 };
size_t lx_obstacle_meridians(const struct lx_obstacle *obstacle, const struct lx_sweep_frame *frame,
                             double meridians[LX_MOST_MERIDIANS][3], bool *round);

#endif
