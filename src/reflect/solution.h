/* SPDX-License-Identifier: MIT */
/* The solution under way: faces, their tiles, and the numbers at the tiles' nodes. */
#ifndef LX_REFLECT_SOLUTION_H
#define LX_REFLECT_SOLUTION_H

#include "direct.h"
#include "reflected.h"
#include "transfer.h"

struct lx_radiosity {
    const struct lx_prepared *prepared;
    struct lx_sampling_direct sampling;
    unsigned bounces; /* 0: all */
    double size_mm;   /* of the scene */
    struct lx_matte_face *faces;
    size_t face_count;
    bool has_round_faces;  /* balls or tubes */
    struct lx_tile *tiles; /* face by face */
    size_t tile_count, tile_capacity;
    size_t *first_tile; /* of each face, and behind the last */
    double *indirect;   /* reflected irradiance at the nodes, */
    double *before;     /* with one bounce less, which is what is reflected */
    double *slack;      /* bound of its error, and */
    double *slack_before;
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

/* Sums over all faces for a receiver. */
struct lx_arrival {
    double value, slack;
};
/* `row`: NULL, or weights of all nodes.  What is sent: direct light alone where `indirect` is NULL. */
struct lx_arrival lx_gather(const struct lx_radiosity *reflected, const struct lx_fineness *fineness,
                            const struct lx_receiver *receiver, const double *indirect, const double *slack,
                            struct lx_veils *veils, float *row);

#endif
