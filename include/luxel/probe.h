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

/* What one light gives.  Its texts live as long as the probe. */
typedef struct luxel_light_share {
    size_t light;      /* index in the scene's list */
    const char *type;  /* the light's type, such as "point" */
    const char *name;  /* the light's name in the scene, NULL where it has none */
    double irradiance; /* E_perp max(0, N.L), or the ambient irradiance */
    double diffuse;    /* its diffuse (or ambient) brightness */
    double specular;   /* its highlight */
    double error;      /* bounds the error of its share of the value */
    size_t parts;      /* points that an extended source was split into; 0: there is a closed form */
} luxel_light_share;

/* The answer of a probe.  Numbers of the scene's unit are those of luxel_scene_unit(). */
typedef struct luxel_probe {
    bool has_screen;           /* false for a free element; then there is no x_mm, y_mm */
    double x_mm;               /* the place on the screen */
    double y_mm;               /* the place on the screen */
    bool has_pixel;            /* false for a free element and off the screen; then there is no column, row */
    unsigned column;           /* of the pixel that the place falls in, from 0 at the left */
    unsigned row;              /* of the pixel that the place falls in, from 0 at the top */
    bool on_surface;           /* true for a free element */
    bool has_value;            /* false off every surface and where a source lies on the element */
    double value;              /* the exact value, the sum over the lights */
    double error;              /* bounds |value - truth| */
    bool tolerance_reached;    /* whether error <= tolerance * |value|; see luxel_settings */
    bool has_pixel_value;      /* false where there is no pixel, or it has no value */
    double pixel_value;        /* the picture's value at the pixel */
    double position_mm[3];     /* the element's place, where on_surface */
    double normal[3];          /* the element's unit normal, where on_surface */
    bool source_on_element;    /* whether a source lies on the element, which then has no value */
    size_t blocking_light;     /* that source's light, as an index in the scene's list */
    size_t share_count;        /* one for each enabled light, where has_value */
    luxel_light_share *shares; /* the lights' shares, in the scene's order */
} luxel_probe;

/*
 * Probes what is seen through the screen point (x, y), which may lie off the screen.
 * The probe is the caller's: free it with luxel_probe_free().
 * Errors as luxel_render() lists them; LUXEL_ERROR_RANGE: the value is beyond float64.
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

/* Frees a probe with its shares; NULL is harmless. */
LUXEL_API void luxel_probe_free(luxel_probe *probe);

/*
 * The unit of probes and pictures of this scene and quantity, in UTF-8.  Irradiance has one, W/m² or lx, where every
 * light is inverse-square, distant or ambient.  Brightness has that of the irradiance or, over_pi, of the radiance
 * then, and that of an intensity where no light is attenuated and nothing is over_pi.  All else is "relative".
 */
LUXEL_API const char *luxel_scene_unit(const luxel_scene *scene, luxel_quantity quantity);

/*
 * What a quantity is called in this scene: "brightness" or "irradiance" and, in photometric units, "luminance" or
 * "illuminance".
 */
LUXEL_API const char *luxel_scene_quantity_word(const luxel_scene *scene, luxel_quantity quantity);

#ifdef __cplusplus
}
#endif
#endif
