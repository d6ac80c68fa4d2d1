/* SPDX-License-Identifier: MIT */
/*
 * How extrema are hunted for: what the files of this search share.
 *
 * A spot is a place on a surface, in coordinates that stay smooth where the screen's do not: the normal of a sphere,
 * whose rim is a line of the screen without width, or the offsets on a plate.  Edges are where the function may not be
 * walked over (walls: the rim of what is seen, the screen, the region) or where it jumps or has a kink (shadows, cones,
 * the light's own horizon).  Each edge is the zero line of a smooth function, so that a climb can hold on to it, and
 * the sides on which a climb stands choose a piece of the function that is smooth beyond its edges too.
 */
#ifndef LX_FIELD_EXTREMA_H
#define LX_FIELD_EXTREMA_H

#include <luxel/extrema.h>

#include "../base/rows.h"
#include "../shade/evaluate.h"

struct lx_spot {
    size_t surface;
    double at[3]; /* the unit normal of a sphere; of a plate the offsets across and upward in mm, and 0 */
};

/* Two directions on the surface at a spot: steps in mm go along them. */
struct lx_chart {
    double first[3], second[3];
};

enum lx_edge_type {
    LX_EDGE_LIMB,       /* of the own sphere */
    LX_EDGE_SIDE,       /* of the own plate */
    LX_EDGE_HIDDEN,     /* behind another surface */
    LX_EDGE_SCREEN,     /* the sides of the screen */
    LX_EDGE_REGION,     /* the sides of the region, or its circle */
    LX_EDGE_SHADOW,     /* of another surface: jumps */
    LX_EDGE_CONE,       /* an angle of a spotlight's cone: jumps where it is hard */
    LX_EDGE_TERMINATOR, /* where the light sets: N.L = 0; jumps where highlights are gated */
    LX_EDGE_LOBE,       /* where the highlight ends */
    LX_EDGE_PATTERN     /* where a light's pattern ends */
};

struct lx_edge {
    enum lx_edge_type type;
    unsigned side;    /* of screen, region or plate: 0 to 3 */
    bool closed;      /* whether what is on the line belongs to the inside, where the function is above 0 */
    size_t surface;   /* that hides or shades */
    size_t emitter;   /* of those that can be walked over */
    double angle_rad; /* of a cone */
};

static inline bool lx_edge_is_wall(const struct lx_edge *edge)
{
    return edge->type <= LX_EDGE_REGION;
}

/* The lobes of a surface where highlights are gated: as if the gate were open, and shut. */
struct lx_gates {
    struct lx_lobe open, shut;
};

/* A place where a climb ended. */
struct lx_summit {
    struct lx_spot spot;
    double value, length_mm;
};

/* One search for the maximum (sign 1) or the minimum (sign -1). */
struct lx_hunt {
    const struct luxel_evaluator *evaluator;
    const struct lx_prepared *prepared;
    struct lx_prepared quick; /* with a coarse tolerance: to look around */
    struct lx_prepared bare;  /* of the pieces: the edges know of the shadows */
    const luxel_region *region;
    double sign;
    double scale_mm;    /* of the coordinates, for what rounding leaves of them */
    double pixel_mm;    /* between the samples */
    bool costly;        /* a value needs integrals */
    bool knows_lights;  /* whether there are edges of lights; else their number is too large */
    struct lx_gates *gates; /* of each surface */
    struct lx_edge *edges;  /* of the surface `edged` */
    size_t edge_count, edge_capacity, edged;
    signed char *sides; /* on which side of each edge the climb stands: 1, -1 */
    size_t side_capacity;
    struct lx_summit *summits;
    size_t summit_count, summit_capacity;
    struct lx_control control;
    bool stopped, short_of_memory;
};

/* Whether the search goes on: it was neither cancelled nor is memory short. */
bool lx_hunt_goes_on(struct lx_hunt *hunt);

/* -- spots (extrema_spot.c) -- */

const struct lx_shape *lx_spot_shape(const struct lx_hunt *hunt, const struct lx_spot *spot);
struct lx_chart lx_spot_chart(const struct lx_hunt *hunt, const struct lx_spot *spot);
struct lx_spot lx_spot_moved(const struct lx_hunt *hunt, const struct lx_spot *spot, const struct lx_chart *chart,
                             const double step_mm[2]);
/* The spot of what was found through the screen. */
struct lx_spot lx_spot_of(const struct lx_hunt *hunt, size_t surface, const double place_mm[3],
                          const double normal[3]);
void lx_spot_place(const struct lx_hunt *hunt, const struct lx_spot *spot, double place_mm[3], double normal[3]);
struct lx_element lx_spot_element(const struct lx_hunt *hunt, const struct lx_spot *spot);
/* Where on the screen a place is seen. */
void lx_screen_of(const struct lx_hunt *hunt, const double place_mm[3], double screen_mm[2]);
/* The middle direction of the part of a sphere that faces the observer, and the cosine of its rim. */
double lx_sphere_front(const struct lx_hunt *hunt, size_t surface, double front[3]);
/* The way from a place to the observer; returns whether it is without end. */
bool lx_way_to_observer(const struct lx_hunt *hunt, const double place_mm[3], double way[3]);
/* The value seen through a screen point, roughly; false: nothing is seen there, or there is no value. */
bool lx_spot_seen(struct lx_hunt *hunt, const double screen_mm[2], struct lx_spot *spot, double *value);

/* -- edges (extrema_edge.c) -- */

/* Lists the edges of a surface, unless they are listed; false: memory ran out. */
bool lx_edges_of(struct lx_hunt *hunt, size_t surface);
/* How far inside of an edge a spot lies, about in mm. */
double lx_edge_distance(const struct lx_hunt *hunt, const struct lx_edge *edge, const struct lx_spot *spot);
/* Takes the sides on which a spot stands; false: it lies outside of a wall. */
bool lx_edges_enter(struct lx_hunt *hunt, const struct lx_spot *spot);
/* The unit direction towards the side on which the climb stands; false: there is none. */
bool lx_edge_inward(const struct lx_hunt *hunt, size_t edge, const struct lx_spot *spot, const struct lx_chart *chart,
                    double inward[2]);
/* Moves a spot onto an edge; false: the edge is not near. */
bool lx_edge_reach(const struct lx_hunt *hunt, size_t edge, struct lx_spot *spot);

/* The piece of the function on the sides where the climb stands: sign * value, and the bound of its error.  NaN: there
 * is no value, or the search has ended. */
double lx_piece_value(struct lx_hunt *hunt, const struct lx_spot *spot, double *error);

/* -- the climb (extrema_climb.c) -- */

struct lx_climb {
    struct lx_spot at;
    double value;     /* sign * value of the piece */
    double noise;     /* what of it is rounding, relative */
    double trust_mm;  /* how far its model reaches */
    double length_mm; /* over which the function changes */
    size_t active[2]; /* the edges that it stands on */
    unsigned active_count;
    bool flat;  /* all around is the same */
    bool known; /* it comes to a summit that was found before */
};

/* Climbs from climb->at until it goes no higher; the sides must have been taken. */
void lx_climb_up(struct lx_hunt *hunt, struct lx_climb *climb);

/* -- where to begin (extrema_seed.c) -- */

struct lx_seed {
    struct lx_spot spot;
    double value;  /* sign * value there, roughly */
    double margin; /* how much more a climb may find */
    size_t order;  /* between equals */
};

struct lx_seeds {
    struct lx_seed *items;
    size_t count, capacity;
};

/* The places to begin at, the best first; false: stopped, or memory ran out.  Free items with free(). */
bool lx_hunt_seeds(struct lx_hunt *hunt, const luxel_field *field, struct lx_seeds *seeds);

/* -- small vectors -- */

static inline double lx_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The length of a vector, which becomes of unit length unless it is 0. */
static inline double lx_normalize(double a[3])
{
    double length = hypot(hypot(a[0], a[1]), a[2]);
    for (int i = 0; i < 3 && length > 0; i++)
        a[i] /= length;
    return length;
}

#endif
