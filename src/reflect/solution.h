/* SPDX-License-Identifier: MIT */
/* The solution under way: faces, their tiles, and the numbers at the tiles' nodes. */
#ifndef LX_REFLECT_SOLUTION_H
#define LX_REFLECT_SOLUTION_H

#include "../base/effort.h"
#include "../format/kept.h"
#include "closed_box.h"
#include "direct.h"
#include "request.h"

struct lx_group;
struct lx_rows;

/* A part of a tile as pictures show it. */
struct lx_shown_part {
    size_t tile;
    uint32_t group; /* that is the tile */
    struct lx_window window;
    size_t first;                            /* of the parts that it is cut into; */
    unsigned count;                          /* 0: it is not */
    double nodes[LX_RULE_NODES];             /* reflected irradiance */
    double residual[2][2], own_error, error; /* as of tiles, */
    unsigned worst;                          /* likewise */
    struct lx_rows *rows;
};

struct lx_radiosity {
    struct lx_kept kept;
    struct lx_reflected_key key;
    bool *on; /* the key's */
    size_t light_count;
    const struct lx_prepared *prepared; /* while it is made; */
    struct lx_prepared sampled;         /* likewise, with the tolerance that samples of direct light are good for, */
    struct lx_prepared open;            /* and without shadows */
    struct lx_sampling_direct sampling;
    struct lx_near *near; /* the places that are asked, and what they see from close by */
    size_t near_count, near_capacity;
    double error;     /* the bound that is wanted */
    unsigned bounces; /* 0: all */
    double size_mm;   /* of the scene */
    struct lx_matte_face *faces;
    size_t face_count;
    struct lx_matte_face *left_out; /* those that no other one sees, nor a place that was asked */
    size_t left_out_count;
    bool has_round_faces; /* balls or tubes */
    struct lx_closed_boxes boxes;
    struct lx_tile *tiles; /* face by face */
    size_t tile_count, tile_capacity;
    size_t most_tiles; /* no solution has many more */
    struct lx_group *groups;
    size_t group_count, group_capacity;
    size_t *first_tile; /* of each face, and behind the last */
    struct lx_fineness fine, coarse;
    double rule;      /* errors of the rules of integration, as a share of what arrives */
    double *indirect; /* reflected irradiance at the nodes, */
    double *before;   /* with one bounce less, which is what is reflected */
    double *slack;    /* bound of its error, and */
    double *slack_before;
    double *sent, *sent_slack;   /* both of `before`, at the nodes of groups */
    struct lx_shown_part *parts; /* first one of each tile, which is all of it */
    size_t part_count, part_capacity;
    struct lx_effort effort;   /* of all work */
    double begun;              /* what the control said was done before it */
    double cut_within;         /* seconds that it had, if time was the end; infinite: a wish was; 0: neither */
    struct lx_effort *efforts; /* of the pieces of a work (within.h) */
    size_t effort_capacity;
    size_t *order; /* of tiles, in which they are worked on */
    double *seen;  /* the share of all ways from a node, by Lambert's law, that end on faces */
    unsigned threads;
    struct lx_control *control;
};

/* A solution of which there is nothing but its faces and tiles, and how fine integrals are; freed by
 * lx_reflected_free() in any case.  LUXEL_OK or LUXEL_ERROR_MEMORY. */
luxel_status lx_reflected_begin(const struct lx_reflected_request *request, struct lx_radiosity **made);

/* A copy of what a solution under way has found, for whoever asks at places; NULL: memory ran out. */
struct lx_radiosity *lx_reflected_copy(const struct lx_radiosity *reflected);

/* Faces and tiles of the scene at first, without light, as far as a request has to do with them; 0, or -1 when memory
 * ran out. */
int lx_tiling_make(struct lx_radiosity *reflected, const struct lx_reflected_request *request);
/* Faces that have light or see another stay. */
int lx_tiling_drop(struct lx_radiosity *reflected, const bool *is_lit);
/* Whether one face may send light to the other. */
bool lx_faces_meet(const struct lx_matte_face *a, const struct lx_matte_face *b);

/* Whether none of the faces that were left out reflects light to a receiver. */
bool lx_reflected_is_whole(const struct lx_radiosity *reflected, const struct lx_receiver *receiver);
/* For places: the greatest bound of their errors, as requests ask for it; where one is above `most`, any such. */
double lx_places_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, double most);
/* Which tiles are to be cut for them; 1: some, 0: none, -1: memory ran out. */
int lx_places_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts);

/* Parts of the solution as it is: first the tiles. */
luxel_status lx_parts_make(struct lx_radiosity *reflected);
/* Without any. */
void lx_parts_clear(struct lx_radiosity *reflected);
/* Cuts parts as long as they show more error than is allowed on each tile and this is their own. */
luxel_status lx_parts_refine(struct lx_radiosity *reflected, const double *allowed);
/* The greatest share of what is allowed that arrives anywhere. */
double lx_parts_arriving(const struct lx_radiosity *reflected, const double *allowed);
/* The greatest share of it that parts show. */
double lx_parts_showing(const struct lx_radiosity *reflected, const double *allowed);
/* Sets places at which more error arrives than a share of what is allowed, the worst ones of them; how many, or -1. */
int lx_parts_worst(const struct lx_radiosity *reflected, const double *allowed, double share, size_t most,
                   struct lx_reflected_place *places);
/* The reflected irradiance on a tile, at coordinates of its face. */
lx_bounded lx_parts_value(const struct lx_radiosity *reflected, size_t tile, const double at[2]);

/* What the parts have of errors in what a picture shows, as above, and which groups are to be cut for it. */
double lx_spots_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request);
int lx_spots_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts);
/* Parts for it, if what arrives of errors lets it be reached by them, or anyway. */
luxel_status lx_spots_show(struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool anyway);

/* What the means of all sides have, and which groups are to be cut for those. */
double lx_means_error(const struct lx_radiosity *reflected);
int lx_means_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts);

/* Sets how much the residual of each tile matters: by what the places see of it, and by its share of all.  0, or -1. */
int lx_weigh(const struct lx_radiosity *reflected, const struct lx_reflected_place *places, size_t count,
             double *scores);
/* Marks the tiles with the greatest scores: most of their sum, but no more than `most` tiles.  As above. */
int lx_cut_greatest(const struct lx_radiosity *reflected, const double *scores, size_t most, bool *cuts);

#endif
