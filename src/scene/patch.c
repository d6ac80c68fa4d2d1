/* SPDX-License-Identifier: MIT */
/* Collecting and applying patches. */
#include <stdlib.h>

#include "../base/memory.h"
#include "patch.h"

void lx_give_up(struct lx_splicer *splicer, enum lx_splice_result result)
{
    if (splicer->result == LX_SPLICED)
        splicer->result = result;
}

void lx_patch(struct lx_splicer *splicer, size_t start, size_t end, const char *first, const char *second)
{
    size_t words = splicer->words.length;
    lx_text_puts(&splicer->words, first);
    lx_text_puts(&splicer->words, second);
    if (splicer->words.failed ||
        lx_reserve(&splicer->patches, &splicer->capacity, splicer->count + 1, sizeof(struct lx_text_patch)) < 0) {
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
        return;
    }
    splicer->patches[splicer->count] =
        (struct lx_text_patch){start, end, words, splicer->words.length - words, splicer->count};
    splicer->count++;
}

static int compare(const void *a, const void *b)
{
    const struct lx_text_patch *one = a, *other = b;
    if (one->start != other->start)
        return one->start < other->start ? -1 : 1;
    return one->number < other->number ? -1 : one->number > other->number;
}

void lx_apply_patches(struct lx_splicer *splicer, struct lx_text *text)
{
    size_t at = 0;
    if (splicer->count)
        qsort(splicer->patches, splicer->count, sizeof splicer->patches[0], compare);
    for (size_t i = 0; i < splicer->count; i++) {
        const struct lx_text_patch *patch = &splicer->patches[i];
        if (patch->start < at || patch->end < patch->start || patch->end > splicer->old.length) {
            lx_give_up(splicer, LX_NOT_SPLICED);
            return;
        }
        lx_text_add(text, splicer->old.text + at, patch->start - at);
        lx_text_add(text, splicer->words.bytes + patch->words, patch->size);
        at = patch->end;
    }
    lx_text_add(text, splicer->old.text + at, splicer->old.length - at);
    if (text->failed)
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
}

void lx_clear_patches(struct lx_splicer *splicer)
{
    free(splicer->patches);
    lx_text_clear(&splicer->words);
}
