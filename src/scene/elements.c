/* SPDX-License-Identifier: MIT */
/*
 * Changing which elements and keys a scene has.  The scene's text is read anew, so that every node knows its place in
 * it; patches change the text, links change the tree; and only where the changed text reads as the changed tree does
 * it become the scene's.  Else the list is set as a whole, or at the top the whole text is written anew.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "path.h"
#include "rearrange.h"
#include "tidy.h"
#include "yaml.h"

/* An edit on its way.  It leaves the scene alone until its end. */
struct edit {
    luxel_scene *scene;
    luxel_diagnostics *diagnostics;
    struct lx_path path;        /* in the scene, later in `now` */
    luxel_scene *now;           /* the scene read anew from its text */
    struct lx_splicer splicer;  /* that text and its patches */
    lx_node_id parent, changed; /* in `now`: the list or mapping that changes, and what holds it (0: nothing) */
    size_t length;              /* bytes of the path that lead to it; 0: it is the root */
};

static struct lx_place place_of(const char *key)
{
    return (struct lx_place){.source = "key", .text = key, .length = strlen(key)};
}

/* The scene's text; with `empty` as it is when the list of the path is written as an empty one. */
static luxel_status write_now(const struct edit *edit, bool empty, char **text)
{
    if (!empty)
        return luxel_scene_write_text(edit->scene, text);
    luxel_scene trial = {.compact_bytes = edit->scene->compact_bytes};
    struct lx_text assignment = {0};
    lx_text_printf(&assignment, "%s=[]", edit->path.place.text);
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (!assignment.failed && lx_document_copy(&edit->scene->document, &trial.document) == 0)
        status = luxel_scene_set(&trial, assignment.bytes, NULL);
    if (status == LUXEL_OK)
        status = luxel_scene_write_text(&trial, text);
    lx_document_clear(&trial.document);
    lx_text_clear(&assignment);
    return status;
}

/* The name that reports give the scene's text. */
static const char *source_name(const luxel_scene *scene)
{
    return lx_document_place(&scene->document, scene->document.root).source;
}

/* Reads the scene anew and finds in it what the first `segments` segments of the path lead to. */
static luxel_status begin(struct edit *edit, size_t segments, bool empty)
{
    char *text = NULL;
    struct lx_place place = edit->path.place;
    luxel_status status = write_now(edit, empty, &text);
    if (status == LUXEL_OK)
        status = luxel_scene_read_text(text, strlen(text), source_name(edit->scene), NULL, &edit->now);
    free(text);
    if (status == LUXEL_OK)
        status = lx_follow_path(edit->now, &place, place.length, NULL, &edit->path);
    if (status != LUXEL_OK)
        return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(edit->diagnostics) : status;
    struct lx_document *document = &edit->now->document;
    struct lx_place whole = lx_document_place(document, document->root);
    edit->splicer.old = (struct lx_layout){whole.text, whole.length, document};
    edit->splicer.json = lx_is_json_document(&edit->splicer.old);
    edit->changed = edit->path.nodes[segments];
    edit->parent = segments ? edit->path.nodes[segments - 1] : 0;
    return LUXEL_OK;
}

/* ---- the end of an edit ---- */

/* Hangs a child out of the changed node. */
static void unlink_child(const struct edit *edit, lx_node_id id)
{
    struct lx_document *document = &edit->now->document;
    lx_node_id *link = &document->nodes[edit->changed].first;
    while (*link != id)
        link = &document->nodes[*link].next;
    *link = document->nodes[id].next;
}

/* Hangs a child in before the one with this number. */
static void link_child(const struct edit *edit, lx_node_id id, size_t index)
{
    struct lx_document *document = &edit->now->document;
    lx_node_id *link = &document->nodes[edit->changed].first;
    while (*link && index-- > 0)
        link = &document->nodes[*link].next;
    document->nodes[id].next = *link;
    *link = id;
}

/* Makes the text the scene's, if it reads as the changed tree. */
static luxel_status adopt(const struct edit *edit, const struct lx_text *text, bool *adopted)
{
    luxel_scene *scene = edit->scene, *changed = NULL;
    const struct lx_document *wanted = &edit->now->document;
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (!text->failed)
        status = luxel_scene_read_text(text->bytes, text->length, source_name(scene), NULL, &changed);
    *adopted =
        status == LUXEL_OK && lx_document_same(wanted, wanted->root, &changed->document, changed->document.root, false);
    if (*adopted) {
        lx_scene_uncommit(scene);
        lx_scene_part_from_original(scene);
        lx_document_clear(&scene->document);
        scene->document = changed->document;
        scene->compact_bytes = changed->compact_bytes;
        changed->document = (struct lx_document){0};
    }
    luxel_scene_free(changed);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(edit->diagnostics) : LUXEL_OK;
}

/* What is done where the text cannot be patched. */
static luxel_status write_instead(struct edit *edit)
{
    const struct lx_document *document = &edit->now->document;
    struct lx_text text = {0};
    luxel_status status;
    if (edit->length == 0) {
        bool adopted;
        lx_write_whole(&text, document, edit->splicer.json);
        status = adopt(edit, &text, &adopted);
        if (status == LUXEL_OK && !adopted)
            status = LUXEL_ERROR_SCENE;
    } else {
        lx_text_add(&text, edit->path.place.text, edit->length);
        lx_text_puts(&text, "=");
        lx_write_flow(&text, document, edit->changed, edit->splicer.json);
        status = text.failed ? lx_out_of_memory(edit->diagnostics)
                             : luxel_scene_set(edit->scene, text.bytes, edit->diagnostics);
    }
    lx_text_clear(&text);
    return status;
}

/* Applies the patches, hangs a child out and one in (0: none), and makes the result the scene's. */
static luxel_status finish(struct edit *edit, lx_node_id out, lx_node_id in, size_t index)
{
    struct lx_text text = {0};
    bool adopted = false;
    luxel_status status = LUXEL_OK;
    if (edit->splicer.result == LX_SPLICED)
        lx_apply_patches(&edit->splicer, &text);
    if (out)
        unlink_child(edit, out);
    if (in)
        link_child(edit, in, index);
    if (edit->splicer.result == LX_SPLICE_NO_MEMORY)
        status = lx_out_of_memory(edit->diagnostics);
    else if (edit->splicer.result == LX_SPLICED)
        status = adopt(edit, &text, &adopted);
    if (status == LUXEL_OK && !adopted)
        status = write_instead(edit);
    lx_text_clear(&text);
    return status;
}

static void clear(struct edit *edit)
{
    lx_clear_patches(&edit->splicer);
    luxel_scene_free(edit->now);
}

/* ---- the edits ---- */

/* Reads the value of a new element into the document of `now`. */
static luxel_status read_value(struct edit *edit, const char *value, lx_node_id *id)
{
    struct lx_document *document = &edit->now->document;
    struct lx_place place = {.source = "value", .text = value, .length = strlen(value)};
    char *text = lx_copy_text(value, place.length);
    if (!text || lx_document_add_source(document, place.source, text, place.length) < 0)
        return lx_out_of_memory(edit->diagnostics);
    luxel_status status =
        lx_yaml_read(document, document->source_count - 1, 0, (unsigned)edit->path.count + 1, edit->diagnostics, id);
    if (status == LUXEL_OK && !*id) {
        lx_report(edit->diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_NO_ELEMENT, LX_ARGS(edit->path.place.text));
        status = LUXEL_ERROR_SCENE;
    }
    return status;
}

static luxel_status insert(struct edit *edit, size_t index, const char *value)
{
    lx_node_id id = 0;
    struct lx_text words = {0};
    luxel_status status = read_value(edit, value, &id);
    if (status != LUXEL_OK)
        return status;
    lx_write_flow(&words, &edit->now->document, id, edit->splicer.json);
    if (words.failed)
        status = lx_out_of_memory(edit->diagnostics);
    else
        lx_put_in(&edit->splicer, edit->parent, edit->changed, index, words.bytes, lx_has_tables(edit->path.parameter));
    lx_text_clear(&words);
    return status == LUXEL_OK ? finish(edit, 0, id, index) : status;
}

luxel_status luxel_scene_insert(luxel_scene *scene, const char *list, size_t index, const char *value,
                                luxel_diagnostics *diagnostics)
{
    if (!scene || !list || !value)
        return LUXEL_ERROR_ARGUMENT;
    struct edit edit = {.scene = scene, .diagnostics = diagnostics};
    struct lx_place place = place_of(list);
    size_t size;
    luxel_status status = lx_follow_list(scene, &place, diagnostics, &edit.path, &size);
    if (status == LUXEL_OK && index > size)
        status = lx_refuse_index(&edit.path, size, diagnostics);
    if (status != LUXEL_OK)
        return status;
    lx_node_id node = edit.path.nodes[edit.path.count];
    edit.length = place.length;
    status = begin(&edit, edit.path.count, !node || lx_document_node(&scene->document, node)->kind != LX_SEQUENCE);
    if (status == LUXEL_OK)
        status = insert(&edit, index, value);
    clear(&edit);
    return status;
}

luxel_status luxel_scene_remove(luxel_scene *scene, const char *key, luxel_diagnostics *diagnostics)
{
    if (!scene || !key)
        return LUXEL_ERROR_ARGUMENT;
    struct edit edit = {.scene = scene, .diagnostics = diagnostics};
    struct lx_place place = place_of(key);
    luxel_status status = lx_follow_path(scene, &place, place.length, diagnostics, &edit.path);
    size_t count = edit.path.count;
    if (status != LUXEL_OK || !edit.path.nodes[count])
        return status;
    edit.length = count > 1 ? edit.path.segments[count - 1].start - 1 : 0;
    status = begin(&edit, count - 1, false);
    if (status == LUXEL_OK) {
        lx_take_out(&edit.splicer, edit.parent, edit.changed, edit.path.nodes[count]);
        status = finish(&edit, edit.path.nodes[count], 0, 0);
    }
    clear(&edit);
    return status;
}

luxel_status luxel_scene_move(luxel_scene *scene, const char *list, size_t from, size_t to,
                              luxel_diagnostics *diagnostics)
{
    if (!scene || !list)
        return LUXEL_ERROR_ARGUMENT;
    struct edit edit = {.scene = scene, .diagnostics = diagnostics};
    struct lx_place place = place_of(list);
    size_t size;
    luxel_status status = lx_follow_list(scene, &place, diagnostics, &edit.path, &size);
    if (status == LUXEL_OK && (from >= size || to >= size))
        status = lx_refuse_index(&edit.path, size, diagnostics);
    if (status != LUXEL_OK || from == to)
        return status;
    edit.length = place.length;
    status = begin(&edit, edit.path.count, false);
    if (status == LUXEL_OK) {
        lx_node_id id = lx_document_element(&edit.now->document, edit.changed, from);
        lx_move_to(&edit.splicer, edit.changed, from, to);
        status = finish(&edit, id, id, to);
    }
    clear(&edit);
    return status;
}
