/* SPDX-License-Identifier: MIT */
/* Texts for people, as front ends need them. */
#include <luxel/text.h>

#include <string.h>

#include "../base/text.h"

const char *luxel_nearest_word(const char *typed, const char *const *words, size_t count)
{
    struct lx_nearest nearest = {.word = typed, .length = strlen(typed)};
    for (size_t i = 0; i < count; i++)
        if (words[i])
            lx_nearest_offer(&nearest, words[i]);
    return nearest.best;
}

char *luxel_escaped_text(const char *text)
{
    struct lx_text escaped = {0};
    lx_text_add_escaped(&escaped, text, strlen(text));
    return lx_text_take(&escaped);
}
