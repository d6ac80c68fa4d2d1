/* SPDX-License-Identifier: MIT */
/*
 * The lights of a plan as constants of the kernels.  Those of a large cloud are not stored for each surface, where they
 * would take ten times the room of the cloud, but made when they are needed, a few at a time.
 */
#ifndef LX_PICTURE_LIGHTS_H
#define LX_PICTURE_LIGHTS_H

#include "../kernel/kernel.h"

/* Lights that a kernel takes at once: those in float32 are summed by themselves before they join the float64 sum. */
enum { LX_MOST_IN_RUN = 16 };

/* The largest clouds whose constants are stored. */
enum { LX_MOST_STORED = 4096 };

/* The lights of a cloud that are not stored. */
struct lx_cloud_lights {
    size_t first, end; /* of the surface's lights */
    const struct lx_point_set *set;
    struct lx_light_double model; /* what they have in common */
    struct lx_light_single model_single;
};

/* The lights over one surface, numbered in the order of their emitters; zero-initialise. */
struct lx_lights {
    struct lx_light_single *singles; /* of those that are stored, in either precision */
    struct lx_light_double *exacts;
    size_t stored, singles_capacity, exacts_capacity;
    struct lx_cloud_lights *clouds;
    size_t cloud_count, cloud_capacity;
    size_t count;
    double anchor_mm[3]; /* of the surface */
    bool is_flat;
    double axis[3]; /* of a flat one */
};

/* How far from a surface's plane rounding may put a lamp that is in it, so far from the surface's anchor. */
double lx_plane_rounding_mm(const double anchor_mm[3], double distance_mm);

/* The plane of a surface, where it is flat: light in it, as of a lamp on a ceiling, arrives nowhere on it. */
void lx_lights_set_plane(struct lx_lights *lights, const struct lx_shape *shape);

/* The constants of an emitter that is not extended, over a surface that is anchored there. */
void lx_light_set(const struct lx_emitter *emitter, const double anchor_mm[3], struct lx_light_double *light);
/* Those of another point that differs in its place and strength alone. */
void lx_light_move(const double anchor_mm[3], const double row[4], struct lx_light_double *light);
/* A light's constants in float32. */
struct lx_light_single lx_light_single_of(const struct lx_light_double *light);

struct lx_lobe_single lx_lobe_single_of(const struct lx_lobe_double *lobe);
struct lx_exponent_double lx_exponent_of(double exponent);

/* Makes room at once for as many lights as are to be stored.  0, or -1 when memory ran out. */
int lx_lights_make_room(struct lx_lights *lights, size_t count);

/* Appends a light, or those of a point set.  0, or -1 when memory ran out. */
int lx_lights_append(struct lx_lights *lights, const struct lx_emitter *emitter);
int lx_lights_append_point_set(struct lx_lights *lights, const struct lx_point_set *set);
void lx_lights_clear(struct lx_lights *lights);

/* What a kernel knows of a light when it is compiled. */
enum lx_kernel_light lx_light_kind_of(const struct lx_emitter *emitter);
/* Whether what it gives has edges, so that the kernels of float32 ask for it in float64, too. */
bool lx_has_edges(const struct lx_emitter *emitter, const struct lx_lobe_double *lobe);

/* Room for lights that are made when they are needed, with what those of one cloud have in common; zero-initialise. */
struct lx_light_room {
    const struct lx_cloud_lights *of_singles, *of_exacts; /* the cloud that is ready there */
    struct lx_light_single singles[LX_MOST_IN_RUN];
    struct lx_light_double exacts[LX_MOST_IN_RUN];
};

/* Some lights that follow each other, at most LX_MOST_IN_RUN, made in `room` where they are not stored. */
const struct lx_light_single *lx_lights_single(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_room *room);
const struct lx_light_double *lx_lights_double(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_room *room);

#endif
