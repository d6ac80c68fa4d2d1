/* SPDX-License-Identifier: MIT */
/*
 * Layouts: how many luminaires a room needs, and how far apart, to reach goals on measuring grids and for observers.
 *
 * One light of the scene stands in columns and rows around its place (its key `array`).  Numbers and spacings are
 * looked for that reach every limit of the scene's grids, the areas around them and observers (<luxel/limits.h>) with
 * the fewest luminaires, then, where they can be dimmed, with the least power.  Places are tried by superposition: the
 * light of one luminaire at places all over the field is found once, and that of an array is a sum of these.  What
 * surfaces reflect is taken for what one array of them gives, and corrected by each that is computed.  What is told of
 * a layout is computed from its scene, with bounds: the search finds it, and proves nothing of layouts in between.
 *
 * Threads as luxel.h says.
 */
#ifndef LUXEL_ARRANGE_H
#define LUXEL_ARRANGE_H

#include <luxel/limits.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The most luminaires that are tried where nothing else is said. */
enum { LUXEL_MOST_ARRANGED = 100 };

/* What is wanted; {0} will do where the scene has limits and one light with an array. */
typedef struct luxel_arranging {
    const char *const *goals; /* beside the scene's limits: "average>=500", "desk:U0>=0.6", "ugr<=19"; see below */
    size_t goal_count;        /* of them */
    const char *light;        /* the one to arrange, by name or number; NULL: the only one that has an array, or is */
    bool dims;                /* luminaires may be dimmed, all alike: then the least power is looked for */
    bool is_even;             /* columns and rows stand as far apart as twice their distance from the walls */
    unsigned most;            /* luminaires; 0: LUXEL_MOST_ARRANGED */
    const char *const *keys;  /* of the scene, to be changed instead of numbers and spacings; see below */
    size_t key_count;         /* of them */
    void *reserved[2];        /* for later versions: NULL */
} luxel_arranging;

/*
 * A goal is a limit of a grid or an observer: [NAME:]KEY>=NUMBER or [NAME:]KEY<=NUMBER.  KEY is average (E), minimum,
 * uniformity (U0), ratio, which are least values, maximum and ugr, which are greatest ones.  NAME may be left out where
 * there is one grid; of ugr all observers are meant then.
 */

/*
 * Keys that take numbers, as luxel_derive_places() knows them, are changed where numbers of luminaires stay: aims
 * (lights[0].aim), places, spacings of arrays (lights[1].array.spacing), intensities or dimming[row].factor one by
 * one.  From several starts the least of all values by their goals is made as great as can be, by linear programs; with
 * `dims` the flux of all lights as small as the goals allow, and `dimming` is its share of the scene's.  Layouts have
 * no columns and rows then, and are told by what they reach.
 */

/* A limit and what a layout makes of it. */
typedef struct luxel_layout_limit {
    bool is_observer;  /* else a grid */
    size_t index;      /* of it in the scene's list */
    luxel_limit limit; /* with value and verdict */
    void *reserved[2]; /* for later versions: NULL */
} luxel_layout_limit;

/* A layout. */
typedef struct luxel_layout {
    unsigned n[2];                    /* columns, rows */
    double spacing_mm[2];             /* of the columns, of the rows */
    double dimming;                   /* the share of its light that each gives, 1 where they are not dimmed */
    bool reaches;                     /* all limits are kept, their bounds included */
    bool is_undecided;                /* the bound of a value spans its limit */
    double reserve;                   /* the least of the values by their goals; below 1 one is missed */
    const luxel_layout_limit *limits; /* in the order of the scene: grids, then observers */
    size_t limit_count;               /* of them */
    const double *numbers;            /* where keys were changed: theirs, number_count of them; else NULL */
    void *reserved[3];                /* for later versions: NULL */
} luxel_layout;

/* What was found.  Texts and arrays live as long as it does. */
typedef struct luxel_arrangement {
    size_t light;               /* the one that is arranged, by index; SIZE_MAX where keys were changed */
    size_t count;               /* of the next; 0: the goals are not reached */
    const luxel_layout *found;  /* that reach the goals: the fewest first, of these the least power, the most reserve */
    size_t missed_count;        /* of the next */
    const luxel_layout *missed; /* of fewer luminaires (or, where none reaches them, of all): the nearest first */
    unsigned fewest;            /* fewer give too little light, wherever they stand; none is tried above `most` */
    size_t tried;               /* how many numbers of columns and rows, or starts of keys, were looked at */
    size_t computed;            /* layouts whose scene was computed */
    size_t number_count;        /* of the keys' numbers: 0 where columns and rows were looked for */
    const char *const *names;   /* of each: lights[0].aim[2] */
    const char *const *units;   /* of each in UTF-8, "" where it has none */
} luxel_arrangement;

/*
 * Looks for layouts.  *arrangement is the caller's: free it with luxel_arrangement_free().  It succeeds, too, where
 * the goals are not reached.  The answer is the same for any number of threads.  Progress and cancelling as of
 * luxel_render().
 * LUXEL_ERROR_ARGUMENT: no limit and no goal; goals that cannot be read, of which all are reported; no light that can
 * be arranged, or several; it gives no light; too many keys.  LUXEL_ERROR_SCENE: a goal is no legal limit.
 * LUXEL_ERROR_PATH: keys that take no numbers, all of them reported.  Else errors as luxel_find_grid() and
 * luxel_find_glare() list them.
 */
LUXEL_API luxel_status luxel_arrange(const luxel_scene *scene, const luxel_settings *settings,
                                     const luxel_arranging *arranging, luxel_diagnostics *diagnostics,
                                     luxel_arrangement **arrangement);

/* The scene of a layout, committed: with the goals as its limits.  The arrangement's; NULL without memory. */
LUXEL_API const luxel_scene *luxel_arrangement_scene(const luxel_arrangement *arrangement, const luxel_layout *layout);

/* Frees an arrangement; NULL is harmless. */
LUXEL_API void luxel_arrangement_free(luxel_arrangement *arrangement);

#ifdef __cplusplus
}
#endif
#endif
