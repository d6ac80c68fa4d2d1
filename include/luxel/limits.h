/* SPDX-License-Identifier: MIT */
/*
 * Limits of a scene's measuring grids and observers (the keys `limits`), and whether they are kept.  A number is known
 * with a bound: where that reaches to both sides of the limit, nothing is said.
 */
#ifndef LUXEL_LIMITS_H
#define LUXEL_LIMITS_H

#include <luxel/glare.h>
#include <luxel/grid.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What is said of a limit: it is kept, it is not, or the bound of the value spans it. */
typedef enum luxel_verdict { LUXEL_PASS, LUXEL_FAIL, LUXEL_UNDECIDED } luxel_verdict;

/* The English word of a verdict, for callers to translate; NULL: no such verdict. */
LUXEL_API const char *luxel_verdict_word(luxel_verdict verdict);

/* A limit and what is judged by it. */
typedef struct luxel_limit {
    const char *name;      /* the key, such as "average"; static */
    double wanted;         /* the limit */
    bool is_most;          /* it is the greatest value that is good; else the least */
    bool has_value;        /* false, and the value 0: of a grid without values, where nothing dazzles */
    luxel_bounded value;   /* its error may be infinite */
    luxel_verdict verdict; /* what is said of it */
    double above;          /* of "share": the value that so many percents of the cells are to have; else 0 */
    void *reserved[3];     /* for later versions: NULL */
} luxel_limit;

enum { LUXEL_MOST_LIMITS = 8 };

/* What a limit is of, in English, for callers to translate: "uniformity U0". */
LUXEL_API const char *luxel_limit_word(const luxel_limit *limit);

/* Whether it has the unit of the values that it is of: averages, minima and maxima do. */
LUXEL_API bool luxel_limit_has_unit(const luxel_limit *limit);

/* Whether a committed scene has limits. */
LUXEL_API bool luxel_scene_has_limits(const luxel_scene *scene);

/*
 * Judges the values of the scene's i-th grid, as luxel_find_grid() or luxel_find_grid_values() has found them, by its
 * limits, of which there are *count, in the order of the keys.  `average` is that of the values, `uniformity` the
 * minimum by it; `ratio` up to 1 is the minimum by the maximum, above 1 the maximum by the minimum; `share` is
 * the percents of the cells that have at least `above`.
 * LUXEL_ERROR_ARGUMENT: NULL, or no such grid.
 */
LUXEL_API luxel_status luxel_judge_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                                        luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count);

/*
 * Judges the areas around the scene's i-th grid by what EN 12464-1:2011 wants of them, where the grid is to have some
 * average: surround_average at least that of its table 1 (from 750 lx on 500 lx, from 500 on 300, from 300 on 200, from
 * 200 on 150, below that as much as the task area) and surround_uniformity, the minimum by the average, at least 0.4;
 * background_average at least a third of that and background_uniformity at least 0.1.  An area that there is no room
 * for has no limits.
 * LUXEL_ERROR_ARGUMENT: NULL, or no such grid.
 */
LUXEL_API luxel_status luxel_judge_areas(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                                         luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count);

/*
 * Judges the grid as luxel_judge_grid() does and then the areas around it as luxel_judge_areas() does, in one list.
 * Errors are theirs.
 */
LUXEL_API luxel_status luxel_judge_grid_and_areas(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                                                  luxel_limit limits[2 * LUXEL_MOST_LIMITS], size_t *count);

/* The number of observers (the key `observers`) of a committed scene; one with several places or without a view counts
 * once for each place and each way that it looks, place by place, row by row. */
LUXEL_API size_t luxel_scene_observer_count(const luxel_scene *scene);
/* The i-th of them: its name, the scene's until that changes, NULL where it has none, and where it is and looks; either
 * may be NULL.  LUXEL_ERROR_ARGUMENT: no such. */
LUXEL_API luxel_status luxel_scene_observer(const luxel_scene *scene, size_t i, const char **name,
                                            luxel_glare_sight *sight);

/* Those that are one entry of the list in the scene. */
typedef struct luxel_observer_places {
    size_t first;      /* the first of them */
    size_t count;      /* how many there are: columns x rows x views */
    unsigned columns;  /* of places, side by side */
    unsigned rows;     /* of places; row 0 is the farthest one along up x across */
    unsigned views;    /* ways it looks from each: 1, or 4 level ones */
    void *reserved[4]; /* for later versions: NULL */
} luxel_observer_places;

/* Those that the i-th observer belongs to.  LUXEL_ERROR_ARGUMENT: NULL, or no such observer. */
LUXEL_API luxel_status luxel_scene_observer_places(const luxel_scene *scene, size_t i, luxel_observer_places *places);

/*
 * Judges the rating of the i-th observer by its limits, of which there are *count.  Where nothing dazzles there is no
 * rating, and the limit is kept; where lights without an area shine at the eye, the rating is only known to be no less.
 * LUXEL_ERROR_ARGUMENT: NULL, or no such observer.
 */
LUXEL_API luxel_status luxel_judge_glare(const luxel_scene *scene, size_t i, const luxel_glare *glare,
                                         luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count);

/* Limits of one kind, at least one, as one: the greatest value, and the worst verdict. */
LUXEL_API luxel_limit luxel_worst_limit(const luxel_limit *limits, size_t count);

#ifdef __cplusplus
}
#endif
#endif
