/* SPDX-License-Identifier: MIT */
/* What the files that give advice share: where it is put, and how a change that mends it is found and said. */
#ifndef LX_EXERCISE_ADVISER_H
#define LX_EXERCISE_ADVISER_H

#include <luxel/exercise.h>

#include "../field/field.h"
#include "../scene/object.h"
#include "scout.h"

enum { LX_ADVICE_SIZE = 240, LX_PLACE_SIZE = 140, LX_KEY_SIZE = 60 };

struct lx_adviser {
    const luxel_scene *scene;
    const struct lx_scene_parameters *parameters;
    struct lx_walk walk;
    struct lx_scout now; /* of the scene as it is */
    double effort;       /* what is left for further looks */
    bool out_of_memory;
};

/* LUXEL_ERROR_ARGUMENT, reported: the scene is not committed. */
luxel_status lx_adviser_begin(struct lx_adviser *adviser, const luxel_scene *scene, luxel_diagnostics *diagnostics);

/* What advice is about: "lights", lights[index], "picture.range", surfaces[index].material.specular. */
struct lx_advised {
    const char *list;
    bool has_index;
    size_t index;
    const char *key, *below; /* NULL: none */
    const char *last;        /* below that; NULL: none */
};

/* Appends advice at the place of what it is about, or of what that stands in; {1} is the text `first` (NULL: none). */
void lx_advise(struct lx_adviser *adviser, struct lx_advised advised, enum lx_message message, const char *first);

/* Gives that advice the hint to make these assignments (NULL-terminated). */
void lx_suggest(struct lx_adviser *adviser, const char *const *assignments);

/* Whether a change, or none, mends what the advice is about. */
typedef bool lx_mends(struct lx_adviser *adviser, const char *const *assignments);

/* Suggests a change if it mends, alone or else, where there is one, with a second; or only both together. */
bool lx_try(struct lx_adviser *adviser, lx_mends *mends, const char *first, const char *second);
bool lx_try_pair(struct lx_adviser *adviser, lx_mends *mends, const char *first, const char *second);

/* Suggests another place or direction of a light, from which it shines on what is seen, if one mends. */
bool lx_try_places(struct lx_adviser *adviser, lx_mends *mends, size_t light);

/* The i-th of some places from which the first surface is well lit, "[1000, 1000, 2000]"; false beyond the last. */
bool lx_write_place(const struct lx_adviser *adviser, size_t i, char buffer[LX_PLACE_SIZE]);

/* Advice about sources that stand so near or far that the law of attenuation shows too much, or not at all. */
void lx_advise_distances(struct lx_adviser *adviser);

#endif
