/* SPDX-License-Identifier: MIT */
/*
 * Probes: the exact value at one place, in float64, light by light, with a bound of its error.
 *
 * What `error` is, and which threads may ask, stands in luxel.h.
 */
#ifndef LUXEL_PROBE_H
#define LUXEL_PROBE_H

#include <luxel/bounded.h>
#include <luxel/colour.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

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
    const luxel_color *color; /* the channels of its share of the value; NULL in a grey scene */
    void *reserved[1];        /* for later versions: NULL */
} luxel_light_share;

/*
 * Where to probe: a point of the screen, which may lie off its edges, or a free surface element.  {0} and a place on
 * the screen, or an element's position and normal, will do.
 *
 * A free element that lies on a surface, to 1e-9 of its size, belongs to it: it has its material.  Elsewhere it has the
 * material of the surface that is named, which is the first unless another one is; in a scene without surfaces that
 * which has all keys by default.  Surfaces are counted from 0, as in
 * surfaces[0].  It is seen as the scene's observer.view says: from (0, 0, 1) where that is `parallel`, else from where
 * the observer is; or from a direction of its own.  Each surface of the scene, be there one or many, takes the light of
 * point-like and distant sources from it where it stands in its way; one that it lies on takes what comes from behind.
 */
typedef struct luxel_place {
    double screen_mm[2];   /* of a point of the screen */
    bool is_element;       /* it is a free element: what follows counts, and screen_mm does not */
    bool has_view;         /* whether `view` counts */
    double position_mm[3]; /* of an element */
    double normal[3];      /* of an element; of any length but 0 */
    double view[3];        /* the direction from the element to the observer; of any length but 0 */
    size_t surface;        /* whose material an element has that lies on no surface */
    void *reserved[3];     /* for later versions: NULL */
} luxel_place;

/* The answer of a probe.  Numbers of the scene's unit are those of luxel_scene_unit(). */
typedef struct luxel_probe {
    bool has_screen;        /* false for a free element; then there is no x_mm, y_mm */
    double x_mm;            /* the place on the screen */
    double y_mm;            /* the place on the screen */
    bool has_pixel;         /* false for a free element and off the screen; then there is no column, row */
    unsigned column;        /* of the pixel that the place falls in, from 0 at the left */
    unsigned row;           /* of the pixel that the place falls in, from 0 at the top */
    bool on_surface;        /* true for a free element */
    bool has_value;         /* false off every surface and where a source lies on the element */
    double value;           /* the exact value, the sum over the lights */
    double error;           /* bounds |value - truth| */
    bool tolerance_reached; /* whether error <= tolerance * |value|, or, where the error does not tell the value from
                                 0, tolerance times what would arrive if nothing stood in the way; see luxel_settings */
    bool has_reflected;     /* whether surfaces reflect light to each other; then value and error have it */
    double reflected_irradiance; /* E_r, what the element receives this way */
    luxel_bounded reflected;     /* what that adds to the value */
    bool reflected_reached;      /* whether its error <= reflected_error * |value|; see luxel_settings */
    bool has_pixel_value;        /* false where there is no pixel, or no value of it, or it is skipped: see settings */
    double pixel_value;          /* the picture's value at the pixel */
    double position_mm[3];       /* the element's place, where on_surface */
    double normal[3];            /* the element's unit normal, where on_surface */
    double view[3];              /* the unit vector V to the observer that was used, where on_surface */
    size_t surface;            /* the surface whose material counts, as an index in the scene's list, where on_surface;
                               * SIZE_MAX where the list is empty */
    const char *surface_name;  /* its name in the scene, NULL where it has none; lives as long as the probe */
    unsigned part;             /* the part of it that the element lies on, of a room a wall, of a box a side; else 0 */
    const char *part_name;     /* what that is called, such as "floor"; NULL where the surface has no parts */
    bool lies_on_surface;      /* whether the element lies on that surface; always where has_screen */
    bool is_enclosed;          /* whether a free element is inside the body that a surface bounds */
    size_t enclosing_surface;  /* that surface, the first of them */
    bool source_on_element;    /* whether a source lies on the element, which then has no value */
    size_t blocking_light;     /* that source's light, as an index in the scene's list */
    luxel_color color;         /* the value's channels, in a scene with channels: rgb */
    size_t share_count;        /* one for each enabled light, where has_value */
    luxel_light_share *shares; /* the lights' shares, in the scene's order */
} luxel_probe;

/* The answers to many places; made by luxel_probe_places(). */
typedef struct luxel_probes luxel_probes;

/*
 * Probes what is seen through the screen point (x, y), which may lie off the screen.
 * The probe is the caller's: free it with luxel_probe_free().
 * Errors as luxel_render() lists them; LUXEL_ERROR_RANGE: the value is beyond float64.
 */
LUXEL_API luxel_status luxel_probe_screen(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                          double y_mm, luxel_diagnostics *diagnostics, luxel_probe **probe);

/*
 * Probes a free surface element, as luxel_place describes it, seen as the scene says and with the material of the
 * surface that it lies on, else of the first.  `normal` need not be of unit length but must not be zero.
 */
LUXEL_API luxel_status luxel_probe_element(const luxel_scene *scene, const luxel_settings *settings,
                                           const double position_mm[3], const double normal[3],
                                           luxel_diagnostics *diagnostics, luxel_probe **probe);

/*
 * Probes one place, with all that luxel_place says of it.  LUXEL_ERROR_ARGUMENT: its numbers are not finite, or 0 where
 * they must not be, or there is no such surface.  Else errors as luxel_probe_screen().
 */
LUXEL_API luxel_status luxel_probe_place(const luxel_scene *scene, const luxel_settings *settings,
                                         const luxel_place *place, luxel_diagnostics *diagnostics, luxel_probe **probe);

/*
 * What the probe's material reflects towards its view of light that comes from all sides alike, as a share of that: the
 * directional albedo, above 1 where more is sent back than falls in.  It is that of the weights divided by pi, whether
 * or not the material is over_pi; in colour that of white light.  NaN: off every surface, seen from behind, or not one
 * of this scene.
 */
LUXEL_API double luxel_probe_albedo(const luxel_scene *scene, const luxel_probe *probe);

/* Frees a probe with its shares; NULL is harmless. */
LUXEL_API void luxel_probe_free(luxel_probe *probe);

/*
 * Probes `count` places, of a scene that is prepared once for all of them, by several threads: a hundred thousand take
 * seconds.  *probes has as many, each the very probe that its place has by itself; they are the caller's: free them
 * with luxel_probes_free().  Progress and cancelling as of luxel_render().
 * Errors as luxel_probe_place().
 */
LUXEL_API luxel_status luxel_probe_places(const luxel_scene *scene, const luxel_settings *settings,
                                          const luxel_place *places, size_t count, luxel_diagnostics *diagnostics,
                                          luxel_probes **probes);

/* How many probes there are. */
LUXEL_API size_t luxel_probes_count(const luxel_probes *probes);
/* The i-th probe, of the i-th place, which lives as long as all of them; NULL beyond the last. */
LUXEL_API const luxel_probe *luxel_probes_get(const luxel_probes *probes, size_t i);
/* Frees probes with their shares; NULL is harmless. */
LUXEL_API void luxel_probes_free(luxel_probes *probes);

/*
 * The unit of probes and pictures of this scene and quantity, in UTF-8.  Irradiance has one, W/m² or lx, where every
 * light is inverse-square, distant or ambient.  Brightness has that of the irradiance or, over_pi, of the radiance
 * then, and that of an intensity where no light is attenuated and nothing is over_pi.  All else is "relative".
 */
LUXEL_API const char *luxel_scene_unit(const luxel_scene *scene, luxel_quantity quantity);

/*
 * The unit of what the settings compute of this scene: of their quantity, by the laws of the lights of their group
 * alone, where they name one.  `settings` NULL: the defaults.
 */
LUXEL_API const char *luxel_settings_unit(const luxel_scene *scene, const luxel_settings *settings);

/*
 * What a quantity is called in this scene: "brightness" or "irradiance" and, in photometric units, "luminance" or
 * "illuminance".
 */
LUXEL_API const char *luxel_scene_quantity_word(const luxel_scene *scene, luxel_quantity quantity);

#ifdef __cplusplus
}
#endif
#endif
