/* SPDX-License-Identifier: MIT */
/*
 * Changing a scene by assignments, luxel_scene_set() itself included.  The value is read into new nodes behind
 * the scene's own and only linked in at the end, so a failure leaves nothing behind; what a change replaces
 * stays as garbage until it outweighs the scene, and is then left out by copying.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "path.h"
#include "yaml.h"

/* Garbage worth leaving alone. */
static const size_t SLACK_BYTES = 64 * 1024;

static luxel_status refuse(struct lx_place place, size_t start, enum lx_message message, luxel_status status,
                           luxel_diagnostics *diagnostics)
{
    place.start = start;
    place.end = place.length;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, message, NULL);
    lx_hint(diagnostics, LX_MSG_HINT_ASSIGNMENT, NULL);
    return status;
}

/* Gives a node the key of a segment. */
static int name_node(struct lx_document *document, lx_node_id id, const struct lx_segment *segment)
{
    uint32_t key;
    if (lx_document_add_text(document, segment->key, strlen(segment->key), &key) < 0)
        return -1;
    document->nodes[id].key = key;
    document->nodes[id].key_start = (uint32_t)segment->start;
    document->nodes[id].key_end = (uint32_t)segment->end;
    return 0;
}

/*
 * Hangs the value into the scene, in groups that are made where they are missing.  Nothing that was there is
 * touched before all memory is at hand.
 */
static int link_value(struct lx_document *document, const struct lx_path *path, lx_node_id value)
{
    size_t i = path->count;
    lx_node_id child = value;
    for (;; i--) {
        const struct lx_segment *segment = &path->segments[i - 1];
        if (!segment->is_index && name_node(document, child, segment) < 0)
            return -1;
        lx_node_id parent = path->nodes[i - 1];
        if (parent && lx_document_node(document, parent)->kind != LX_SCALAR)
            break;
        /* it stands on its key in the path, and so before the '=', where nothing else of a value is */
        const struct lx_segment *own = &path->segments[i - 2];
        struct lx_node group = {.kind = LX_MAPPING,
                                .first = child,
                                .start = (uint32_t)own->start,
                                .end = (uint32_t)own->end,
                                .source = lx_document_node(document, value)->source};
        if (lx_document_add_node(document, group, &child) < 0)
            return -1;
    }
    if (path->nodes[i])
        lx_document_replace(document, path->nodes[i - 1], path->nodes[i], child);
    else
        lx_document_append(document, path->nodes[i - 1], child);
    return 0;
}

/* A replaced element of a list keeps no key, a replaced key its old one: both are right as they are. */
static luxel_status assign(luxel_scene *scene, const struct lx_path *path, size_t value_start,
                           luxel_diagnostics *diagnostics)
{
    struct lx_document *document = &scene->document;
    struct lx_document_mark mark = lx_document_mark(document);
    const struct lx_place *place = &path->place;
    char *text = lx_copy_text(place->text, place->length);
    luxel_status status = LUXEL_OK;
    if (!text || lx_document_add_source(document, place->source, text, place->length) < 0)
        return lx_out_of_memory(diagnostics);
    lx_node_id value = 0;
    status =
        lx_yaml_read(document, document->source_count - 1, value_start, (unsigned)path->count, diagnostics, &value);
    if (status == LUXEL_OK && !value)
        status = refuse(*place, value_start, LX_MSG_NO_VALUE, LUXEL_ERROR_SCENE, diagnostics);
    if (status == LUXEL_OK && link_value(document, path, value) < 0)
        status = lx_out_of_memory(diagnostics);
    if (status != LUXEL_OK)
        lx_document_rewind(document, mark);
    return status;
}

/* Leaves the garbage out once it outweighs the rest; where memory is short, another time. */
static void compact(luxel_scene *scene)
{
    struct lx_document copy;
    if (lx_document_bytes(&scene->document) < 2 * scene->compact_bytes + SLACK_BYTES ||
        lx_document_copy(&scene->document, &copy) < 0)
        return;
    lx_document_clear(&scene->document);
    scene->document = copy;
    scene->compact_bytes = lx_document_bytes(&copy);
}

/* Whether a key is of what sees a scene and of what is made of that, so that bodies and light stay. */
static bool is_of_sight(const struct lx_segment *segment)
{
    static const char *const keys[] = {"observer", "screen", "picture", "points"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (!segment->is_index && strcmp(segment->key, keys[i]) == 0)
            return true;
    return false;
}

static luxel_status set(luxel_scene *scene, const char *assignment, luxel_diagnostics *diagnostics)
{
    struct lx_place place = {.source = "-s", .text = assignment, .length = strlen(assignment)};
    const char *equals = strchr(assignment, '=');
    if (!equals)
        return refuse(place, 0, LX_MSG_NO_EQUALS, LUXEL_ERROR_PATH, diagnostics);
    struct lx_path path;
    size_t key_length = (size_t)(equals - assignment);
    luxel_status status = lx_follow_path(scene, &place, key_length, diagnostics, &path);
    if (status == LUXEL_OK)
        status = assign(scene, &path, key_length + 1, diagnostics);
    if (status == LUXEL_OK) {
        lx_scene_uncommit(scene);
        if (!is_of_sight(&path.segments[0]))
            lx_scene_part_from_original(scene);
        compact(scene);
    }
    return status;
}

/* ---- all elements of a list ---- */

/* Where an assignment names all elements of a list; NULL: nowhere. */
static const char *find_all(const char *assignment)
{
    for (const char *at = assignment; *at && *at != '='; at++)
        if (strncmp(at, "[*]", 3) == 0)
            return strchr(at, '=') ? at : NULL;
    return NULL;
}

/* How many elements the list before `all` has; what is wrong with it is reported at the assignment. */
static luxel_status count_elements(const luxel_scene *scene, const char *assignment, const char *all, size_t *count,
                                   luxel_diagnostics *diagnostics)
{
    char *list = lx_copy_text(assignment, (size_t)(all - assignment));
    struct lx_path path;
    if (!list)
        return lx_out_of_memory(diagnostics);
    const struct lx_place place = {.source = "-s", .text = list, .length = strlen(list)};
    const luxel_status status = lx_follow_list(scene, &place, diagnostics, &path, count);
    free(list);
    return status;
}

/* Sets the key of all elements that have it; `set_count` tells how many. */
static luxel_status set_each(luxel_scene *scene, const char *assignment, const char *all, size_t count,
                             luxel_diagnostics *diagnostics, size_t *set_count)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        struct lx_path path;
        char *one = lx_text_of_element(assignment, all, i);
        if (!one)
            return lx_out_of_memory(diagnostics);
        const struct lx_place place = {.source = "-s", .text = one, .length = strlen(one)};
        const size_t key_length = (size_t)(strchr(one, '=') - one);
        /* that none has it is told of the last */
        luxel_diagnostics *told = *set_count == 0 && i + 1 == count ? diagnostics : NULL;
        const luxel_status found = lx_follow_path(scene, &place, key_length, told, &path);
        if (found == LUXEL_OK) {
            status = set(scene, one, diagnostics);
            *set_count += status == LUXEL_OK;
        } else if (told) {
            status = found;
        }
        free(one);
    }
    return status;
}

/* All of them, or none. */
static luxel_status set_all(luxel_scene *scene, const char *assignment, const char *all, luxel_diagnostics *diagnostics)
{
    struct lx_place place = {.source = "-s", .text = assignment, .length = strlen(assignment)};
    struct lx_document before;
    size_t count = 0, set_count = 0;
    luxel_status status = count_elements(scene, assignment, all, &count, diagnostics);
    if (status != LUXEL_OK)
        return status;
    if (count == 0) {
        char *list = lx_copy_text(assignment, (size_t)(all - assignment));
        place.end = (size_t)(all - assignment);
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_NO_ELEMENTS, LX_ARGS(list ? list : ""));
        free(list);
        return LUXEL_ERROR_PATH;
    }
    if (lx_document_copy(&scene->document, &before) < 0)
        return lx_out_of_memory(diagnostics);
    status = set_each(scene, assignment, all, count, diagnostics, &set_count);
    if (status == LUXEL_OK || set_count == 0) {
        lx_document_clear(&before);
    } else {
        lx_document_clear(&scene->document);
        scene->document = before;
    }
    return status;
}

luxel_status luxel_scene_set(luxel_scene *scene, const char *assignment, luxel_diagnostics *diagnostics)
{
    if (!scene || !assignment)
        return LUXEL_ERROR_ARGUMENT;
    const char *all = find_all(assignment);
    return all ? set_all(scene, assignment, all, diagnostics) : set(scene, assignment, diagnostics);
}
