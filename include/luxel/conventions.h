/* SPDX-License-Identifier: MIT */
/*
 * Conventions: the choices of a scene that decided a result, such as projection, shadows or the highlight's model.
 * Two people whose numbers differ will find the reason among them; so what had no say in a result is left out:
 * the sampling of a picture for an exact value, the material for an irradiance.
 */
#ifndef LUXEL_CONVENTIONS_H
#define LUXEL_CONVENTIONS_H

#include <luxel/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a result was made of; {0} is an irradiance at places in space, as of a measuring grid. */
typedef struct luxel_conventions_use {
    bool screen;          /* places of the screen: the projection, and what is seen of surfaces */
    bool pixels;          /* pixels: the sampling */
    bool range;           /* the picture's range, from which levels or colours are made */
    bool rounding;        /* the rounding of its grey levels */
    bool brightness;      /* brightness, not irradiance: materials, and the view */
    const bool *surfaces; /* which surfaces' materials counted, one for each of the scene; NULL: all of them */
    bool has_view;        /* whether some were seen from a direction of their own */
    double view[3];       /* that direction, of any length */
    bool only_view;       /* and none as the scene says */
    void *reserved[4];    /* for later versions: NULL */
} luxel_conventions_use;

/* One of them; values that differ between lights or surfaces are joined by commas. */
typedef struct luxel_convention {
    const char *key;   /* such as "sampling" */
    const char *value; /* such as "nodes" */
} luxel_convention;

/* All of a result, in the order of the scene's keys; the list and its texts live as long as it. */
typedef struct luxel_conventions {
    size_t count;                 /* of the list */
    const luxel_convention *list; /* count of them */
} luxel_conventions;

/*
 * The conventions of a committed scene that had a say in a result.  `use` NULL: all that there are.  The caller's: free
 * them with luxel_conventions_free().
 * LUXEL_ERROR_ARGUMENT: the scene is not committed.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_conventions(const luxel_scene *scene, const luxel_conventions_use *use,
                                              luxel_conventions **conventions);

/* Frees conventions; NULL is harmless. */
LUXEL_API void luxel_conventions_free(luxel_conventions *conventions);

#ifdef __cplusplus
}
#endif
#endif
