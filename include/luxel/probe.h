/* SPDX-License-Identifier: MIT */
/*
 * Probes: the exact value at one place, in float64, light by light, with a bound of its error.
 *
 * `error` bounds |value - truth| with every rounding included, the truth being the real-number result of the
 * scene's numbers as they stand in float64.  Threads as for luxel_render().
 */
#ifndef LUXEL_PROBE_H
#define LUXEL_PROBE_H

#include <luxel/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What one light gives.  `type` and `name` (NULL where it has none) live as long as the probe. */
typedef struct luxel_light_share {
    size_t light;      /* index in the scene's list */
    const char *type;
    const char *name;
    double irradiance; /* E_perp max(0, N.L), or the ambient irradiance */
    double diffuse;    /* its diffuse (or ambient) brightness */
    double specular;   /* its highlight */
    double error;      /* bounds the error of its share of the value */
} luxel_light_share;

typedef struct luxel_probe {
    bool has_screen;          /* false for a free element */
    double x_mm, y_mm;
    bool has_pixel;           /* false for a free element and off the screen */
    unsigned column, row;
    bool on_surface;          /* true for a free element */
    bool has_value;           /* false off every surface and where a source lies on the element */
    double value, error;
    bool tolerance_reached;   /* whether error <= tolerance * |value| for an explicit tolerance */
    bool has_pixel_value;
    double pixel_value;       /* the picture's value at the pixel */
    double position_mm[3], normal[3]; /* where on_surface */
    bool source_on_element;   /* then `blocking_light` lies on the element and there is no value */
    size_t blocking_light;
    size_t share_count;       /* one for each enabled light, where has_value */
    luxel_light_share *shares;
} luxel_probe;

/*
 * Probes what is seen through the screen point (x, y), which may lie off the screen.
 * The probe is the caller's: free it with luxel_probe_free().
 */
LUXEL_API luxel_status luxel_probe_screen(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                          double y_mm, luxel_diagnostics *diagnostics, luxel_probe **probe);

/*
 * Probes a free surface element: V points to the observer, the material is the first surface's.  `normal`
 * need not be of unit length but must not be zero.
 */
LUXEL_API luxel_status luxel_probe_element(const luxel_scene *scene, const luxel_settings *settings,
                                           const double position_mm[3], const double normal[3],
                                           luxel_diagnostics *diagnostics, luxel_probe **probe);

LUXEL_API void luxel_probe_free(luxel_probe *probe);

/* The unit of probes and pictures of this scene and quantity, in UTF-8. */
LUXEL_API const char *luxel_scene_unit(const luxel_scene *scene, luxel_quantity quantity);

#ifdef __cplusplus
}
#endif
#endif
