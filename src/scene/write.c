/* SPDX-License-Identifier: MIT */
/*
 * The scene as text, the public functions: what the user wrote, with what was changed spliced in.  What comes out
 * is read again and compared with the scene; should it ever say something else, the whole is written anew.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/sink.h"
#include "object.h"
#include "splice.h"
#include "tidy.h"
#include "yaml.h"

/* Whether a text reads as what the document holds. */
static luxel_status check_text(const struct lx_document *document, const struct lx_text *text, bool *same)
{
    struct lx_document again = {0};
    luxel_status status = text->failed ? LUXEL_ERROR_MEMORY : lx_yaml_read_text(text->bytes, text->length, &again);
    *same = status == LUXEL_OK && again.root && lx_document_same(document, document->root, &again, again.root, false);
    lx_document_clear(&again);
    return status == LUXEL_ERROR_MEMORY ? status : LUXEL_OK;
}

static luxel_status write_changed(const struct lx_document *document, struct lx_text *text)
{
    struct lx_place written = lx_document_place(document, document->root);
    bool json = false, same = false;
    enum lx_splice_result result = lx_splice(document, document->root, written.text, written.length, text, &json);
    luxel_status status = result == LX_SPLICE_NO_MEMORY ? LUXEL_ERROR_MEMORY : LUXEL_OK;
    if (result == LX_SPLICED)
        status = check_text(document, text, &same);
    if (status == LUXEL_OK && !same) {
        lx_text_clear(text);
        lx_write_whole(text, document, json);
    }
    return status;
}

luxel_status lx_write_document(const struct lx_document *document, char **text)
{
    struct lx_place written = lx_document_place(document, document->root);
    struct lx_text words = {0};
    luxel_status status = LUXEL_OK;
    if (lx_is_as_read(document, document->root))
        lx_text_add(&words, written.text, written.length);
    else
        status = write_changed(document, &words);
    if (status == LUXEL_OK && words.failed)
        status = LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        *text = lx_text_take(&words);
    lx_text_clear(&words);
    return status;
}

luxel_status luxel_scene_write_text(const luxel_scene *scene, char **text)
{
    if (!scene || !text || scene->is_ahead)
        return LUXEL_ERROR_ARGUMENT;
    return lx_write_document(&scene->document, text);
}

luxel_status luxel_scene_write_file(const luxel_scene *scene, const char *path, luxel_diagnostics *diagnostics)
{
    struct lx_sink *sink;
    char *text = NULL;
    if (!scene || !path)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = luxel_scene_write_text(scene, &text);
    if (status == LUXEL_ERROR_MEMORY)
        return lx_out_of_memory(diagnostics);
    status = lx_sink_open(path, NULL, diagnostics, &sink);
    if (status == LUXEL_OK) {
        lx_sink_write(sink, text, strlen(text));
        status = lx_sink_commit(sink);
    }
    free(text);
    return status;
}
