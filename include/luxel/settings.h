/* SPDX-License-Identifier: MIT */
/*
 * Settings: how a scene is to be computed, whatever is asked of it: a picture, a probe, a grid.
 *
 * They are plain values of the caller, who makes them by luxel_settings_init() and so is ready for members of later
 * versions (luxel.h, "Growth").
 */
#ifndef LUXEL_SETTINGS_H
#define LUXEL_SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The quantity that is computed for each element of a surface. */
typedef enum luxel_quantity {
    LUXEL_BRIGHTNESS, /* sum of the lights' brightness by the material */
    LUXEL_IRRADIANCE  /* sum of E_perp max(0, N.L) and ambient irradiance */
} luxel_quantity;

/* How exactly a picture is computed, and the type of its values. */
typedef enum luxel_precision {
    LUXEL_SINGLE, /* float32: within 2e-6 of the picture's maximum */
    LUXEL_DOUBLE  /* float64: within 1e-11 of the picture's maximum */
} luxel_precision;

/*
 * Called at most 4000 times a second from the calling thread with the share done, 0 to 1, so it should do little;
 * returning false cancels the rendering, which then ends with LUXEL_CANCELLED, as a rule within a millisecond of when
 * it first would have been false (docs/KERNELS.md tells what takes longer).
 */
typedef bool (*luxel_progress)(double done, void *data);

/*
 * Called as often, with the same data, while reflected light is refined: with the bound of its error that is reached so
 * far, in the terms of reflected_error, infinite as long as there is none; and once more where it was ended early.
 * Returning true says that this is enough: the best so far is taken, and its bounds told.
 */
typedef bool (*luxel_enough)(double bound, void *data);

/* How to compute; luxel_settings_init() sets the defaults, which the comments name. */
typedef struct luxel_settings {
    luxel_quantity quantity;     /* brightness */
    luxel_precision precision;   /* single */
    unsigned threads;            /* 0: as many as pay, one per processor at most; at most 1024 */
    const char *instruction_set; /* NULL: what LUXEL_ISA says, else the best of this machine */
    double tolerance;            /* of probes, relative; 0: 1e-9 where there is no closed form */
    double light_error;          /* 0: each point is summed; else many are taken together: see luxel_render() */
    double reflected_error;      /* of reflected light, relative to the value of a probe or a grid's cell (0: 1e-3), or
                                  * to the maximum of a picture, the greatest mean of a surface (0: 1e-2) */
    unsigned stride;             /* 1 (0 too): every pixel; n, to 65536: each n-th column and row: see luxel_render() */
    bool minimum_reached; /* false; true: statistics tell the least value where light arrives, see luxel_statistics */
    bool share_reflected; /* false; true: one solution of reflected light serves all that is asked, see below */
    bool skip_reflected_pixels; /* false; true: probes tell no pixel_value where that takes a solution of its own */
    luxel_progress progress;    /* NULL: none */
    void *progress_data;        /* handed to `progress`; NULL */
    const size_t *lights; /* NULL: the enabled ones give light; else those of this group, by index, and no others */
    size_t light_count;   /* of the group: 0, and all is dark */
    double within;        /* seconds for each solution of reflected light; 0: no end, see below */
    luxel_enough enough;  /* NULL: nobody is asked */
    void *reserved[2];    /* for later versions: NULL */
} luxel_settings;

/*
 * Light that surfaces reflect to each other takes a solution, and by default whatever is asked for gets one that is as
 * exact as the settings ask for there.  With share_reflected the solution that luxel_render() makes for the picture, by
 * the same quantity, tolerance, reflected_error, instruction set and lights, serves probes, grids, glare and the
 * balance as well, which tell the bounds that it has where they ask, and whether those are reached.  Pictures and
 * evaluators take it in any case, and their values are the same either way.  A copy of the scene, in which observer,
 * screen, points and picture alone are changed after that, is another camera of the same light: it takes the solution,
 * too, for each picture of it.
 *
 * A probe on the screen tells the picture's value at its pixel, which takes the picture's solution beside its own, and
 * mostly longer than that.  With skip_reflected_pixels it does without where surfaces reflect light, unless one
 * solution serves all, and takes as long as a free element at that place.
 *
 * A committed scene keeps the last solution of its picture, and so do its copies until they are changed.  Whoever asks
 * first, in any thread, makes it; two that ask before it is there both make it, so do ask one after the other.
 */

/*
 * By default a solution of reflected light is refined until the bound is reached, or its effort spent, so that values
 * are the same on any machine.  With `within` it ends after so many seconds of the clock at the latest with the best
 * bound that was reached by then, or, before there is any, with what can be told at once.  Values and bounds are as
 * true as ever; how small the bounds are depends on the machine where the time was the end, and nothing does where it
 * was not.  Colours take several solutions, one for each spectral band, and so do some questions, such as a probe of a
 * pixel.
 */

/* Sets every member to its default, given above. */
LUXEL_API void luxel_settings_init(luxel_settings *settings);

#ifdef __cplusplus
}
#endif

#endif
