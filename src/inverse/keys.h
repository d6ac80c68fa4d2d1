/* SPDX-License-Identifier: MIT */
/* Keys of a scene that are free to change: their numbers, what is legal, and scenes in which they are others. */
#ifndef LX_INVERSE_KEYS_H
#define LX_INVERSE_KEYS_H

#include <luxel/scene.h>

#include "../scene/bind.h"

enum { LX_MOST_NUMBERS = 8 }; /* that a key takes */

/* A value that a key is: its path, and the numbers that it has in the scene. */
struct lx_target {
    char *path;
    double numbers[LX_MOST_NUMBERS];
    double scale; /* how large such a number is */
};

/* A key: one value, or with lights[*].intensity those of all elements of a list that have it, which change alike. */
struct lx_key {
    char *path;       /* as it was named */
    const char *unit; /* "" for none */
    bool is_list, is_length;
    size_t count, offset; /* its numbers, and the first of them among those of all keys */
    struct lx_target *targets;
    size_t target_count;
    struct lx_interval legal; /* of each number */
};

struct lx_keys {
    struct lx_key *list;
    size_t count, number_count;
};

/* Finds the keys in a scene.  LUXEL_ERROR_PATH: all that are wrong are reported.  Clear them in any case. */
luxel_status lx_keys_find(const luxel_scene *scene, const char *const *paths, size_t count,
                          luxel_diagnostics *diagnostics, struct lx_keys *keys);
void lx_keys_clear(struct lx_keys *keys);

/* The key that a number of all of them belongs to. */
const struct lx_key *lx_keys_of(const struct lx_keys *keys, size_t number);

/* A value of a key; zero-initialise to begin before the first of all. */
struct lx_each {
    const struct lx_key *key;
    const struct lx_target *target;
};

/* Goes on to the next value of all keys; false: there is none. */
bool lx_keys_next(const struct lx_keys *keys, struct lx_each *each);

/* Commits a copy of the scene in which number i of one of the key's values has changed so much.  LUXEL_ERROR_SCENE:
 * there is no such scene. */
luxel_status lx_key_shift(const luxel_scene *scene, const struct lx_key *key, size_t target, size_t i, double change,
                          luxel_diagnostics *diagnostics, luxel_scene **changed);

/* Commits a copy of the scene in which the keys have these numbers, number_count of them; what it has already is left
 * as it is written.  LUXEL_ERROR_SCENE: there is no such scene. */
luxel_status lx_keys_change(const luxel_scene *scene, const struct lx_keys *keys, const double *numbers,
                            luxel_diagnostics *diagnostics, luxel_scene **changed);

/*
 * A scene whose keys are changed time and again: where their numbers can be bound (scene/bind.h) it takes microseconds.
 */
struct lx_changer {
    const luxel_scene *scene;
    const struct lx_keys *keys;
    luxel_scene *own;            /* the scene with other numbers */
    struct lx_binding *bindings; /* of each key's values in it; NULL: it is made anew each time */
    size_t binding_count;
};

/* Clear it in any case. */
luxel_status lx_changer_make(const luxel_scene *scene, const struct lx_keys *keys, luxel_diagnostics *diagnostics,
                             struct lx_changer *changer);
void lx_changer_clear(struct lx_changer *changer);

/* The scene with these numbers, the changer's until the next change; NULL: there is none, or no memory. */
const luxel_scene *lx_changer_change(struct lx_changer *changer, const double *numbers);

#endif
