/* SPDX-License-Identifier: MIT */
/* Key paths such as lights[0].intensity, and what they lead to in a scene. */
#ifndef LX_SCENE_PATH_H
#define LX_SCENE_PATH_H

#include "object.h"

enum { LX_MOST_SEGMENTS = 8 };

/* A part of a path: a key, or the index of an element, which may be called by its name instead. */
struct lx_segment {
    size_t start, end; /* bytes of the path's text */
    bool is_index;
    bool is_name; /* the text between the brackets is the element's name, and the index is found by that */
    size_t index;
    char key[64];
};

/* A path, checked against the tables and the scene. */
struct lx_path {
    struct lx_place place; /* the whole assignment */
    size_t count;
    struct lx_segment segments[LX_MOST_SEGMENTS];
    /*
     * nodes[i] is what segments 0 to i-1 lead to, nodes[0] the scene's root; 0: not written yet.  Only groups
     * may be unwritten on the way.
     */
    lx_node_id nodes[LX_MOST_SEGMENTS + 1];
    const struct lx_parameter *parameter; /* whose value, or part of a value, it leads to; NULL: a list's element */
    unsigned depth;                       /* list brackets passed within that value */
};

/*
 * Reads the path in the place's first `length` bytes and follows it through the scene.
 * LUXEL_ERROR_PATH: it is malformed or leads to no key or element, and reported.
 */
luxel_status lx_follow_path(const luxel_scene *scene, const struct lx_place *place, size_t length,
                            luxel_diagnostics *diagnostics, struct lx_path *path);

/*
 * Follows the path in the whole of the place's text to a list and sets *size to how many elements it has: 0 where it
 * is not written, or without a value.  LUXEL_ERROR_PATH as lx_follow_path(), and where no list may be, or is.
 */
luxel_status lx_follow_list(const luxel_scene *scene, const struct lx_place *place, luxel_diagnostics *diagnostics,
                            struct lx_path *path, size_t *size);

/* The text with element i of a list in place of all of them, the "[*]" at `all`; the caller's, NULL where memory ran
 * out. */
char *lx_text_of_element(const char *text, const char *all, size_t i);

/* Reports that the list of so many elements has no such element, at the whole path to it. */
luxel_status lx_refuse_index(const struct lx_path *path, size_t size, luxel_diagnostics *diagnostics);

#endif
