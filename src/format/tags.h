/* SPDX-License-Identifier: MIT */
/*
 * Tags: texts that a file carries beside its image, by key.  Keys of this program begin with "luxel:"; what other
 * programs put into a file is passed over when it is read.
 */
#ifndef LX_FORMAT_TAGS_H
#define LX_FORMAT_TAGS_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/source.h"

/* The longest text that is read, and what all of one file may take, in which even an empty one counts something. */
enum { LX_LARGEST_TAG = 64 << 20, LX_LARGEST_TAGS = LX_LARGEST_TAG + (1 << 20), LX_SMALLEST_TAG = 1 << 14 };

/* A tag to write: UTF-8, ending with 0. */
struct lx_tag {
    const char *key, *value;
};

/* A tag that was read, and a list of them; start with {0}. */
struct lx_read_tag {
    char *key;
    char *value; /* ends with a 0 byte, but may hold others: a file may hold anything */
    size_t length;
};

struct lx_tags {
    struct lx_read_tag *items;
    size_t count, capacity;
    size_t taken; /* of LX_LARGEST_TAGS */
};

/* Whether a text of this length is more than may be read, by itself or with those that are there. */
bool lx_tags_are_full(const struct lx_tags *tags, size_t length);

/* Whether a key is one of this program's. */
bool lx_is_our_tag(const char *key);

/*
 * Adds a tag; `value`, of malloc() with room for a 0 byte behind its length, becomes the list's, or is freed.
 * The first of several tags with one key counts.  0, or -1 when memory ran out.
 */
int lx_tags_add(struct lx_tags *tags, const char *key, char *value, size_t length);

/* The tag of this key, or NULL. */
const struct lx_read_tag *lx_tags_find(const struct lx_tags *tags, const char *key);

void lx_tags_clear(struct lx_tags *tags);

/* Reports a text beyond the limit. */
luxel_status lx_tag_too_large(struct lx_source *source, const char *key, const char *format);

#endif
