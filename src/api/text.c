/* SPDX-License-Identifier: MIT */
/* Texts for people, as front ends need them. */
#include <luxel/bounded.h>
#include <luxel/text.h>

#include <string.h>

#include "../base/diagnostics.h"
#include "../base/ending.h"
#include "../base/number.h"
#include "../base/sink.h"
#include "../base/text.h"

double luxel_round_bound(double error, int digits)
{
    return lx_round_up(error, digits);
}

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

luxel_status luxel_text_write(const char *path, const char *text, size_t length, luxel_diagnostics *diagnostics)
{
    struct lx_sink *sink;
    luxel_status status = lx_sink_open(path, NULL, diagnostics, &sink);
    if (status != LUXEL_OK)
        return status;
    lx_sink_write(sink, text, length);
    return lx_sink_commit(sink);
}

luxel_status luxel_check_ending(const char *path, const char *const *endings, size_t count,
                                luxel_diagnostics *diagnostics)
{
    size_t found;
    return lx_find_ending(path, endings, count, diagnostics, &found);
}
