/* SPDX-License-Identifier: MIT */
/*
 * One arc of a source: what is integrated, where it begins and ends on the arc, and the integral along it.
 *
 * The integrand is smooth but for two borders, N.L = 0 (the horizon) and S = 0 (where the lobe ends: N.H = 0, that
 * is N.L = -N.V, or R.V = 0).  On an arc both are conditions a cos(tau) + b sin(tau) > c, whose roots are known.
 *
 * A rough place, normal or view vector moves the integral.  The derivative of the integrand by them is integrated
 * beside it: S^n changes by n tan(theta) S^n for the angle theta whose cosine S is, and dw by 1/(r cos incidence) +
 * 3/r for each unit that the element moves.
 */
#ifndef LX_WORLD_ALONG_H
#define LX_WORLD_ALONG_H

#include "../../base/rows.h"
#include "../../light/distribution.h"
#include "../../material/lobe.h"
#include "../visibility/crossings.h"
#include "../visibility/occlusion.h"
#include "adaptive.h"
#include "sweep.h"

enum { MOST_CONDITIONS = 2, MOST_INTERVALS = 2 * MOST_CONDITIONS + 1, MOST_PLACES = LX_MOST_PEAKS + 2 * LX_MOST_KINKS };

/* Where the integrand begins like a power or a root, the variable is eased in: x = from + (to - from) ease(t). */
struct lx_arc_stretch {
    double from, to;
    bool eased;
};

/* A part of a sweep with nothing that changes within. */
struct lx_piece {
    size_t sweep;
    struct lx_arc_stretch range;
};

/* Lines of a luminaire's table that an arc is cut at; beyond them the adaptive rule finds its way. */
enum { MOST_LINES = 192 };

/* One integral over a source, and where its work stands. */
struct lx_problem {
    const struct lx_emitter *emitter;
    const struct lx_lobe *lobe; /* NULL: N.L is integrated, without the lobe */
    struct lx_lobe_at at;
    double place_mm[3], place_error_mm;
    struct lx_border conditions[MOST_CONDITIONS]; /* g.L > limit */
    size_t condition_count;
    struct lx_border kinks[LX_MOST_KINKS]; /* of the lobe */
    size_t kink_count;
    const struct lx_sweeps *sweeps;
    struct lx_piece *pieces;
    size_t piece_count;
    double known, tolerance;
    bool is_coarse;   /* rules of few points do */
    double top;       /* logarithm of the greatest value of the lobe expected; values are relative to it */
    double highest;   /* the greatest met */
    double at_border; /* the greatest value met where a gated highlight jumps */
    double running;   /* the integral, so far */
    size_t parts;
    const struct lx_asking *asking; /* whether to go on */
    bool is_stopped;
    struct lx_occlusion *occlusion;        /* what stands in the way; NULL: nothing */
    const struct lx_directions *crossings; /* of its borders */
    struct lx_arc_stretch *room;           /* for the parts of an arc that are left, */
    struct lx_panel *panels;               /* and for the integrals along them */
    size_t room_count, panel_count;
    /* of the arc that is being integrated */
    const struct lx_sweep *sweep;
    struct lx_arc arc;
    struct lx_arc_stretch whole[MOST_INTERVALS];
    struct lx_arc_stretch *intervals; /* those that are seen: whole or room */
    struct lx_kept_cell kept;         /* of the luminaire's table, where the last direction lay */
    double wanted;                    /* for it, absolutely */
    double doubt;                     /* for what obstacles may be off */
    uint64_t form;                    /* which of them bound what is seen, and which lines of the table cross it */
    struct lx_pointed_crossing lines[MOST_LINES];
    size_t line_count; /* of these */
};

static inline double lx_dot_plain(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Whether all must begin anew, with a higher top. */
bool lx_outgrew_top(const struct lx_problem *problem);

/* Whether it is worth to refine: not then, nor when enough has been done, nor where the work is to stop. */
bool lx_goes_on(struct lx_problem *problem);

/* On the arc, g.L = amplitude cos(tau - peak). */
void lx_along_arc(const struct lx_border *border, const struct lx_sweep *sweep, const struct lx_arc *arc,
                  double *amplitude, double *peak);

/* Room for what obstacles leave of an arc; 0, or -1 when memory ran out.  free() room and panels. */
int lx_make_room_on_arcs(struct lx_problem *problem);

/* Looks how great the lobe gets on the arc at x of a sweep: raises the problem's top. */
void lx_look_at(struct lx_problem *problem, const struct lx_sweep *sweep, double x);

/* The integral along the arc at x of a sweep, by longitude; `is_free`: of all of it, whatever hides it. */
double lx_light_along(struct lx_problem *problem, const struct lx_sweep *sweep, double x, bool is_free);

/* The integral along the arc at t of a piece, as an integrand for lx_integrate_panels(); data is the problem. */
struct lx_point_value lx_integrate_arc(void *data, size_t piece, double t);

/* Its form: which obstacles bound the parts of the arc that are seen, and which lines of a table cross it. */
uint64_t lx_form_of_arc(void *data, size_t piece, double t);

#endif
