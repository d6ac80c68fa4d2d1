/* SPDX-License-Identifier: MIT */
/* Lists of the tags that were found in a file. */
#include "tags.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

bool lx_is_our_tag(const char *key)
{
    return strncmp(key, "luxel:", 6) == 0;
}

bool lx_tags_are_full(const struct lx_tags *tags, size_t length)
{
    return length > LX_LARGEST_TAG || tags->taken + length + LX_SMALLEST_TAG > LX_LARGEST_TAGS;
}

int lx_tags_add(struct lx_tags *tags, const char *key, char *value, size_t length)
{
    char *copy = NULL;
    value[length] = '\0';
    bool doubled = lx_tags_find(tags, key) != NULL;
    if (!doubled)
        copy = lx_copy_text(key, strlen(key));
    if (copy && lx_reserve(&tags->items, &tags->capacity, tags->count + 1, sizeof *tags->items) == 0) {
        tags->items[tags->count++] = (struct lx_read_tag){.key = copy, .value = value, .length = length};
        tags->taken += length + LX_SMALLEST_TAG;
        return 0;
    }
    free(copy);
    free(value);
    return doubled ? 0 : -1;
}

const struct lx_read_tag *lx_tags_find(const struct lx_tags *tags, const char *key)
{
    for (size_t i = 0; i < tags->count; i++)
        if (strcmp(tags->items[i].key, key) == 0)
            return &tags->items[i];
    return NULL;
}

void lx_tags_clear(struct lx_tags *tags)
{
    for (size_t i = 0; i < tags->count; i++) {
        free(tags->items[i].key);
        free(tags->items[i].value);
    }
    free(tags->items);
    *tags = (struct lx_tags){0};
}

luxel_status lx_tag_too_large(struct lx_source *source, const char *key, const char *format)
{
    return lx_source_refuse(source, LX_MSG_TAG_TOO_LARGE, LX_ARGS(key, format, LX_TERM(LX_N("64 MB"))));
}
