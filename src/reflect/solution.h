/* SPDX-License-Identifier: MIT */
/* The solution under way: faces, their tiles, and the numbers at the tiles' nodes. */
#ifndef LX_REFLECT_SOLUTION_H
#define LX_REFLECT_SOLUTION_H

#include "direct.h"
#include "reflected.h"
#include "transfer.h"

/* No solution has many more tiles. */
enum { LX_MOST_TILES = 560 };

struct lx_radiosity {
    struct lx_kept kept;
    struct lx_reflected_key key;
    const struct lx_prepared *prepared; /* while it is made; */
    struct lx_prepared sampled;         /* likewise, with the tolerance that samples of direct light are good for */
    struct lx_sampling_direct sampling;
    unsigned bounces; /* 0: all */
    double size_mm;   /* of the scene */
    struct lx_matte_face *faces;
    size_t face_count;
    bool has_round_faces;  /* balls or tubes */
    int most_cells;        /* along a face at first */
    struct lx_tile *tiles; /* face by face */
    size_t tile_count, tile_capacity;
    size_t *first_tile; /* of each face, and behind the last */
    double *indirect;   /* reflected irradiance at the nodes, */
    double *before;     /* with one bounce less, which is what is reflected */
    double *slack;      /* bound of its error, and */
    double *slack_before;
    double *seen; /* the share of all ways from a node, by Lambert's law, that end on faces */
    unsigned threads;
    struct lx_control *control;
};

/* Faces and tiles of the scene at first, without light; 0, or -1 when memory ran out. */
int lx_tiling_make(struct lx_radiosity *reflected);
/* Cuts the tiles of which that is asked: bit 0 across s, bit 1 across t; 0, or -1. */
int lx_tiling_cut(struct lx_radiosity *reflected, const uint8_t *cuts);
/* Faces that have light or see another stay. */
int lx_tiling_drop(struct lx_radiosity *reflected, const uint8_t *is_lit);
/* Whether one face may send light to the other. */
bool lx_faces_meet(const struct lx_matte_face *a, const struct lx_matte_face *b);

/* For places: whether all of them have errors as small as wished; how much each tile matters, 0 or -1. */
bool lx_places_are_reached(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish);
/* Which tiles are to be cut for them, as lx_tiling_cut() has it; 1: some, 0: none, -1: memory ran out. */
int lx_places_cut(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish, uint8_t *cuts);

/* Likewise for what a picture shows. */
bool lx_spots_are_reached(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish);
int lx_spots_cut(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish, uint8_t *cuts);

/* Likewise for the means of all sides. */
bool lx_means_are_reached(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish);
int lx_means_cut(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish, uint8_t *cuts);

/* Marks the tiles with the greatest scores: most of their sum, but no more than `most` tiles.  As above. */
int lx_cut_greatest(const struct lx_radiosity *reflected, const double *scores, size_t most, uint8_t *cuts);
double lx_tile_area(const struct lx_tile *tile);

/* Sums over all faces for a receiver. */
struct lx_arrival {
    double value, slack;
    double seen; /* of all ways, how many end on faces */
};
/* `row`: NULL, or weights of all nodes.  What is sent: direct light alone where `indirect` is NULL. */
struct lx_arrival lx_gather(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                            const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                            const double *indirect, const double *slack, struct lx_veils *veils, float *row);

#endif
