/* SPDX-License-Identifier: MIT */
/*
 * Exchange of light between the sides of surfaces: form factors, also called view or configuration factors.  Of what
 * side i sends, evenly from all of it and by Lambert's law, the share
 *
 *     F_ij = 1/A_i integral over A_i, A_j of V cos cos' / (pi r^2) dA dA'
 *
 * arrives at side j; V is 1 where nothing stands between, else 0.  It depends on shapes alone, not on lights, materials
 * and shadows.  A_i F_ij = A_j F_ji, and in a closed room the factors of each side add up to 1.
 */
#ifndef LUXEL_EXCHANGE_H
#define LUXEL_EXCHANGE_H

#include <luxel/balance.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One side of a surface. */
typedef struct luxel_exchange_side {
    size_t surface;           /* as an index in the scene */
    const char *surface_name; /* its name in the scene, NULL where it has none; lives as long as the exchange */
    unsigned part;            /* of a room the wall, of a box the side; else 0 */
    const char *part_name;    /* its name, as of luxel_scene_part_name(); NULL where the surface is one by itself */
    luxel_surface_side side;  /* which side of it; the walls of a room face it with their front */
    double area_m2;           /* of the side */
    void *reserved[4];        /* for later versions: NULL */
} luxel_exchange_side;

/* The form factors of a scene. */
typedef struct luxel_exchange {
    size_t count;                     /* of sides */
    const luxel_exchange_side *sides; /* in the order of the surfaces, fronts first; not those inside of closed bodies,
                                         nor those outside of rooms and hollow spheres unless something is there */
    const luxel_bounded *factors;     /* count x count, row by row: factors[i * count + j] is F_ij */
    bool reached;                     /* each error is at most that of the settings, see luxel_find_exchange() */
} luxel_exchange;

/*
 * Finds the form factors of a committed scene.  `settings` NULL: the defaults; of them count reflected_error, the
 * error of each factor that is wanted, as a share of what a side sends (1e-3), threads and progress.  An error that was
 * not reached is a bound as well.  The exchange is the caller's: free it with luxel_exchange_free().
 * LUXEL_ERROR_SCENE: a surface's sides are not known, or too many triangles; else errors as luxel_render() lists them.
 */
LUXEL_API luxel_status luxel_find_exchange(const luxel_scene *scene, const luxel_settings *settings,
                                           luxel_diagnostics *diagnostics, luxel_exchange **exchange);

/* Frees an exchange; NULL is harmless. */
LUXEL_API void luxel_exchange_free(luxel_exchange *exchange);

#ifdef __cplusplus
}
#endif
#endif
