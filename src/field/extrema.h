/* SPDX-License-Identifier: MIT */
/*
 * How extrema are searched for: what the files of this search share.
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
#include "../base/vector.h"
#include "../world/evaluate.h"

struct lx_spot {
    size_t surface;
    double at[3]; /* in the coordinates of the surface's chart */
};

/* Two directions on the surface at a spot: steps in mm go along them. */
struct lx_chart {
    double first[3], second[3];
};

enum lx_edge_type {
    LX_EDGE_RIM,        /* of what can be seen of the own surface */
    LX_EDGE_HIDDEN,     /* behind another surface */
    LX_EDGE_SCREEN,     /* the sides of the screen */
    LX_EDGE_REGION,     /* the sides of the region, or its circle */
    LX_EDGE_SHADOW,     /* of another surface: jumps */
    LX_EDGE_CONE,       /* an angle at which a profile has a kink, or jumps as hard cones do */
    LX_EDGE_TERMINATOR, /* where the light sets: N.L = 0; jumps where highlights are gated */
    LX_EDGE_LOBE,       /* where the highlight ends */
    LX_EDGE_PATTERN     /* a plane through the light on which its profile has a kink */
};

struct lx_search_edge {
    enum lx_edge_type type;
    unsigned side;  /* of screen or region, 0 to 3; of the own surface its wall */
    bool closed;    /* whether what is on the line belongs to the inside, where the function is above 0 */
    size_t surface; /* that hides or shades */
    size_t emitter; /* of those that can be walked over */
    size_t place;   /* of a profile: which of its breaks */
};

static inline bool lx_edge_is_wall(const struct lx_search_edge *edge)
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
struct lx_extremum_search {
    const struct luxel_evaluator *evaluator;
    const struct lx_prepared *prepared;
    struct lx_prepared quick; /* with a coarse tolerance: to look around */
    struct lx_prepared bare;  /* of the pieces: the edges know of the shadows */
    const luxel_region *region;
    double sign;
    double scale_mm;              /* of the coordinates, for what rounding leaves of them */
    double pixel_mm;              /* between the samples */
    bool costly;                  /* a value needs integrals */
    bool knows_lights;            /* whether there are edges of lights; else their number is too large */
    struct lx_gates *gates;       /* of each surface */
    struct lx_search_edge *edges; /* of the surface `edged` */
    size_t edge_count, edge_capacity, edged;
    signed char *sides; /* on which side of each edge the climb stands: 1, -1 */
    size_t side_capacity;
    struct lx_summit *summits;
    size_t summit_count, summit_capacity;
    struct lx_control control;
    bool stopped, short_of_memory;
};

/* Whether the search goes on: it was neither cancelled nor is memory short. */
bool lx_search_goes_on(struct lx_extremum_search *search);

/* -- spots (extrema_spot.c) -- */

const struct lx_shape *lx_spot_shape(const struct lx_extremum_search *search, const struct lx_spot *spot);
struct lx_chart lx_spot_chart(const struct lx_extremum_search *search, const struct lx_spot *spot);
struct lx_spot lx_spot_moved(const struct lx_extremum_search *search, const struct lx_spot *spot,
                             const struct lx_chart *chart, const double step_mm[2]);
/* The spot of what was found through the screen. */
struct lx_spot lx_spot_of(const struct lx_extremum_search *search, size_t surface, const double place_mm[3],
                          const double normal[3]);
void lx_spot_place(const struct lx_extremum_search *search, const struct lx_spot *spot, double place_mm[3],
                   double normal[3]);
struct lx_element lx_spot_element(const struct lx_extremum_search *search, const struct lx_spot *spot);
/* Where on the screen a place is seen; false, and infinitely far: it is not before an observer in perspective. */
bool lx_screen_of(const struct lx_extremum_search *search, const double place_mm[3], double screen_mm[2]);
/* Where lines of sight start, and where view vectors point to. */
struct lx_origin lx_eye_of(const struct lx_extremum_search *search);
struct lx_origin lx_viewer_of(const struct lx_extremum_search *search);
/* What is seen through a screen point; false: nothing. */
bool lx_spot_shown(const struct lx_extremum_search *search, const double screen_mm[2], struct lx_spot *spot);
/* The value seen through a screen point, roughly; false: nothing is seen there, or there is no value. */
bool lx_spot_seen(struct lx_extremum_search *search, const double screen_mm[2], struct lx_spot *spot, double *value);

/* -- edges (extrema_edge.c) -- */

/* Lists the edges of a surface, unless they are listed; false: memory ran out. */
bool lx_edges_of(struct lx_extremum_search *search, size_t surface);
/* How far inside of an edge a spot lies, about in mm. */
double lx_edge_distance(const struct lx_extremum_search *search, const struct lx_search_edge *edge,
                        const struct lx_spot *spot);
/* Takes the sides on which a spot stands; false: it lies outside of a wall. */
bool lx_edges_enter(struct lx_extremum_search *search, const struct lx_spot *spot);
/* The unit direction towards the side on which the climb stands; false: there is none. */
bool lx_edge_inward(const struct lx_extremum_search *search, size_t edge, const struct lx_spot *spot,
                    const struct lx_chart *chart, double inward[2]);
/* Moves a spot onto an edge; false: the edge is not near. */
bool lx_edge_reach(const struct lx_extremum_search *search, size_t edge, struct lx_spot *spot);

/* Moves a spot that lies near to where two edges meet to that place, if they do not only touch there. */
void lx_edges_meet(const struct lx_extremum_search *search, const size_t edges[2], struct lx_spot *spot);

/* The piece of the function on the sides where the climb stands: sign * value, and the bound of its error.  NaN: there
 * is no value, or the search has ended. */
double lx_piece_value(struct lx_extremum_search *search, const struct lx_spot *spot, double *error);

/* -- the climb (extrema_climb.c) -- */

struct lx_climb {
    struct lx_spot at;
    double value;     /* sign * value of the piece */
    double noise;     /* what of it is rounding, relative */
    double trust_mm;  /* how far its model reaches */
    double length_mm; /* over which the function changes */
    size_t active[2]; /* the edges that it stands on */
    unsigned active_count;
    bool looked; /* whether the length is more than a guess */
    bool flat;   /* all around is the same */
    bool known;  /* it comes to a summit that was found before */
};

/* Climbs from climb->at until it goes no higher; the sides must have been taken. */
void lx_climb_up(struct lx_extremum_search *search, struct lx_climb *climb);

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
bool lx_search_seeds(struct lx_extremum_search *search, const luxel_field *field, struct lx_seeds *seeds);

/* What seeds are gathered in. */
struct lx_gathering {
    struct lx_extremum_search *search;
    struct lx_seeds *seeds;
    double low[2], high[2]; /* the box around screen and region */
};

void lx_gather_spot(struct lx_gathering *gathering, const struct lx_spot *spot, double value, double margin);
/* How much more than a value a climb may find where no neighbour tells. */
double lx_unreported_margin(const struct lx_extremum_search *search, double value);
/* What is seen through a screen point, or, off the screen or the region, through the nearest point of their box, and
 * the sign * value there; false: nothing. */
bool lx_look_through(struct lx_gathering *gathering, const double screen_mm[2], struct lx_spot *spot, double *value);
/* The sign * value of a spot; false: it is hidden or off the screen. */
bool lx_look_at_spot(struct lx_extremum_search *search, const struct lx_spot *spot, double *value);

/* -- along the edges (extrema_rim.c) -- */

/* The peaks along the rim of a surface, and beside it of surfaces behind. */
void lx_gather_rim(struct lx_gathering *gathering, size_t surface);
/* The peaks along the screen or the region, and places inside a region. */
void lx_gather_border(struct lx_gathering *gathering);

#endif
