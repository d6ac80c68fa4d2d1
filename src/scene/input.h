/* SPDX-License-Identifier: MIT */
/* Getting at the text of a scene: a file as a whole, within the limit of its size, or what a picture carries. */
#ifndef LX_SCENE_INPUT_H
#define LX_SCENE_INPUT_H

#include "../base/source.h"
#include "carried.h"

struct lx_input {
    char *text; /* of malloc() */
    size_t length;
    struct lx_carried carried; /* the settings beside a text that a picture carries */
};

/*
 * Reads a text of at most LX_LARGEST_TEXT bytes, or finds it in a picture, which its content tells and not its name.
 * The text is the caller's, to be freed with free().
 */
luxel_status lx_read_input(struct lx_source *source, struct lx_input *input);

#endif
