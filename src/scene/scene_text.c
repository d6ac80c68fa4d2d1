/* SPDX-License-Identifier: MIT */
/* The text of a scene that a picture carries: a copy of the document, and its text once somebody wanted it. */
#include "scene_text.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../format/tags.h"
#include "object.h"

struct lx_scene_text {
    struct lx_document document; /* empty where the text was read */
    _Atomic(char *) written;     /* NULL: nobody wanted it yet */
};

struct lx_scene_text *lx_scene_text_of(const luxel_scene *scene)
{
    struct lx_scene_text *text = lx_new_array(1, sizeof *text);
    if (text && lx_document_copy(&scene->document, &text->document) == 0)
        return text;
    free(text);
    return NULL;
}

struct lx_scene_text *lx_scene_text_copy(const char *bytes, size_t length)
{
    struct lx_scene_text *text = lx_new_array(1, sizeof *text);
    char *copy = text ? lx_copy_text(bytes, length) : NULL;
    if (copy) {
        atomic_init(&text->written, copy);
        return text;
    }
    free(text);
    return NULL;
}

void lx_scene_text_free(struct lx_scene_text *text)
{
    if (!text)
        return;
    lx_document_clear(&text->document);
    free(atomic_load(&text->written));
    free(text);
}

luxel_status lx_scene_text_get(struct lx_scene_text *text, const char **characters)
{
    char *found = text ? atomic_load(&text->written) : NULL, *before = NULL;
    *characters = NULL;
    if (text && !found) {
        if (lx_write_document(&text->document, &found) != LUXEL_OK)
            return LUXEL_ERROR_MEMORY;
        if (!atomic_compare_exchange_strong(&text->written, &before, found)) { /* another thread was faster */
            free(found);
            found = before;
        }
    }
    if (found && strlen(found) <= LX_LARGEST_TAG)
        *characters = found;
    return LUXEL_OK;
}
