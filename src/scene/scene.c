/* SPDX-License-Identifier: MIT */
/*
 * The scene object, public functions included: made from a text, committed (decoded, validated), copied, freed, and
 * asked for what it says.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/path.h"
#include "../surface/part.h"
#include "guard.h"
#include "input.h"
#include "object.h"
#include "yaml.h"

/* ---- making ---- */

/* Makes a scene of a text that malloc() gave and that becomes the scene's. */
static luxel_status make_scene(char *text, size_t length, const char *source, luxel_diagnostics *diagnostics,
                               luxel_scene **result)
{
    luxel_scene *scene = lx_new_array(1, sizeof *scene);
    if (!scene) {
        free(text);
        return lx_out_of_memory(diagnostics);
    }
    uint32_t empty;
    luxel_status status = LUXEL_OK;
    if (lx_document_add_source(&scene->document, source, text, length) < 0 ||
        lx_document_add_text(&scene->document, "", 0, &empty) < 0)
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = lx_yaml_read(&scene->document, 0, 0, 0, diagnostics, &scene->document.root);
    lx_node_id root = scene->document.root;
    if (status == LUXEL_OK && (!root || lx_document_node(&scene->document, root)->kind != LX_MAPPING)) {
        struct lx_place place =
            root ? lx_document_place(&scene->document, root) : lx_document_stretch(&scene->document, 0, 0, 0);
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_NO_MAPPING, NULL);
        lx_hint(diagnostics, LX_MSG_HINT_EXAMPLE, NULL);
        status = LUXEL_ERROR_SCENE;
    }
    scene->compact_bytes = lx_document_bytes(&scene->document);
    if (status == LUXEL_OK)
        *result = scene;
    else
        luxel_scene_free(scene);
    return status;
}

/* Makes a scene of what a source holds, and closes it. */
static luxel_status read_source(struct lx_source *source, luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    struct lx_input input;
    luxel_status status = lx_read_input(source, &input);
    if (status == LUXEL_OK)
        status = make_scene(input.text, input.length, lx_source_name(source), diagnostics, scene);
    if (status == LUXEL_OK)
        (*scene)->carried = input.carried;
    lx_source_close(source);
    return status;
}

luxel_status luxel_scene_read_text(const char *text, size_t length, const char *source, luxel_diagnostics *diagnostics,
                                   luxel_scene **scene)
{
    if (!scene || (!text && length))
        return LUXEL_ERROR_ARGUMENT;
    struct lx_source *bytes;
    luxel_status status = lx_source_of_bytes(source ? source : "<text>", text, length, diagnostics, &bytes);
    return status == LUXEL_OK ? read_source(bytes, diagnostics, scene) : status;
}

luxel_status luxel_scene_set_folder_of(luxel_scene *scene, const char *path)
{
    if (!scene)
        return LUXEL_ERROR_ARGUMENT;
    const size_t length = path ? (size_t)(lx_path_name(path) - path) : 0;
    char *folder = length > 0 ? lx_copy_text(path, length) : NULL;
    if (length > 0 && !folder)
        return LUXEL_ERROR_MEMORY;
    free(scene->folder);
    scene->folder = folder;
    lx_scene_uncommit(scene);
    lx_scene_part_from_original(scene);
    return LUXEL_OK;
}

luxel_status luxel_scene_keep_files(luxel_scene *scene, const luxel_scene *other)
{
    if (!scene || !other || scene == other)
        return LUXEL_ERROR_ARGUMENT;
    return lx_kept_copy(&other->kept, &scene->kept) < 0 ? LUXEL_ERROR_MEMORY : LUXEL_OK;
}

luxel_status luxel_scene_read_file(const char *path, luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    if (!path || !scene)
        return LUXEL_ERROR_ARGUMENT;
    struct lx_source *file;
    luxel_scene *made = NULL;
    luxel_status status = lx_source_open(path, LX_LARGEST_TEXT, diagnostics, &file);
    if (status == LUXEL_OK)
        status = read_source(file, diagnostics, &made);
    if (status == LUXEL_OK && luxel_scene_set_folder_of(made, path) != LUXEL_OK)
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        *scene = made;
    else
        luxel_scene_free(made);
    return status;
}

static luxel_status commit(luxel_scene *scene, luxel_diagnostics *diagnostics);

/* What is kept in one slot is in another one, too; NULL: there is none. */
static void share_slot(struct lx_kept_slot *from, struct lx_kept_slot *to)
{
    struct lx_kept *kept = from && to ? lx_kept_slot_look(from) : NULL;
    if (kept)
        lx_kept_slot_put(to, kept);
    lx_kept_release(kept);
}

luxel_scene *luxel_scene_copy(const luxel_scene *scene)
{
    luxel_scene *copy = scene && !scene->is_ahead ? lx_new_array(1, sizeof *copy) : NULL;
    if (!copy)
        return NULL;
    if (scene->folder)
        copy->folder = lx_copy_text(scene->folder, strlen(scene->folder));
    if ((scene->folder && !copy->folder) || lx_document_copy(&scene->document, &copy->document) < 0 ||
        lx_kept_copy(&scene->kept, &copy->kept) < 0 || (scene->committed && commit(copy, NULL) != LUXEL_OK)) {
        luxel_scene_free(copy);
        return NULL;
    }
    copy->compact_bytes = lx_document_bytes(&copy->document);
    copy->carried = scene->carried;
    share_slot(scene->reflected, copy->reflected);
    share_slot(scene->reflected_on_plane, copy->reflected_on_plane);
    copy->reflected_elsewhere = scene->reflected ? lx_kept_slot_look(scene->reflected) : NULL;
    return copy;
}

void luxel_scene_free(luxel_scene *scene)
{
    if (!scene)
        return;
    lx_scene_uncommit(scene);
    lx_scene_part_from_original(scene);
    lx_document_clear(&scene->document);
    lx_kept_clear(&scene->kept);
    free(scene->folder);
    free(scene);
}

/* ---- committing ---- */

void lx_scene_uncommit(luxel_scene *scene)
{
    lx_parameters_clear(&lx_scene_table, &scene->parameters);
    memset(&scene->parameters, 0, sizeof scene->parameters);
    scene->committed = scene->is_ahead = false;
    lx_kept_slot_free(scene->reflected);
    lx_kept_slot_free(scene->reflected_on_plane);
    scene->reflected = scene->reflected_on_plane = NULL;
}

void lx_scene_part_from_original(luxel_scene *scene)
{
    lx_kept_release(scene->reflected_elsewhere);
    scene->reflected_elsewhere = NULL;
}

struct lx_kept *lx_scene_reflected_elsewhere(const luxel_scene *scene)
{
    return scene->is_ahead || !scene->reflected_elsewhere ? NULL : lx_kept_hold(scene->reflected_elsewhere);
}

struct lx_kept_slot *lx_scene_reflected(const luxel_scene *scene)
{
    return scene->is_ahead ? NULL : scene->reflected;
}

struct lx_kept_slot *lx_scene_reflected_on_plane(const luxel_scene *scene)
{
    return scene->is_ahead ? NULL : scene->reflected_on_plane;
}

lx_node_id lx_scene_node(const luxel_scene *scene, const char *group, const char *key)
{
    lx_node_id mapping = lx_document_find(&scene->document, scene->document.root, group);
    return mapping ? lx_document_find(&scene->document, mapping, key) : 0;
}

struct lx_walk lx_scene_walk(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    lx_node_id units = lx_document_find(&scene->document, scene->document.root, "units");
    bool photometric = units && lx_document_node(&scene->document, units)->kind == LX_SCALAR &&
                       strcmp(lx_document_text(&scene->document, units), "photometric") == 0;
    return (struct lx_walk){.document = &scene->document, .diagnostics = diagnostics, .photometric = photometric};
}

/* Files that the scene has read already are not read again. */
static luxel_status commit(luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    lx_scene_uncommit(scene);
    struct lx_walk walk = lx_scene_walk(scene, diagnostics);
    walk.folder = scene->folder;
    walk.kept = &scene->kept;
    luxel_status status = lx_decode(&walk, &lx_scene_table, &scene->parameters);
    if (status != LUXEL_ERROR_MEMORY) {
        lx_place_grids(&walk, scene);
        lx_check_dimming(&walk, scene);
        lx_validate_reflections(&walk, scene);
        if (walk.errors > walk.unread)
            lx_validate_view(&walk, scene); /* so that all that is wrong is told at once */
        status = lx_walk_status(&walk);
    }
    if (status == LUXEL_OK && scene->parameters.reflections.choice != LX_REFLECTIONS_NONE) {
        scene->reflected = lx_kept_slot_new(); /* without it, it is found each time */
        scene->reflected_on_plane = lx_kept_slot_new();
    }
    if (status == LUXEL_OK)
        scene->committed = true;
    else
        lx_scene_uncommit(scene);
    return status;
}

luxel_status luxel_scene_commit(luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (!scene)
        return LUXEL_ERROR_ARGUMENT;
    const size_t read_before = scene->kept.count;
    lx_kept_refresh(&scene->kept);
    if (scene->kept.count != read_before)
        lx_scene_part_from_original(scene);
    luxel_status status = commit(scene, diagnostics);
    if (status == LUXEL_OK)
        lx_kept_drop_unused(&scene->kept);
    return status;
}

bool luxel_scene_is_committed(const luxel_scene *scene)
{
    return scene && scene->committed;
}

bool lx_scene_is_ahead(const luxel_scene *scene)
{
    return scene->is_ahead;
}

const struct lx_scene_parameters *lx_scene_parameters(const luxel_scene *scene)
{
    return luxel_scene_is_committed(scene) ? &scene->parameters : NULL;
}

/* ---- asking ---- */

size_t luxel_scene_point_count(const luxel_scene *scene)
{
    return luxel_scene_is_committed(scene) ? scene->parameters.points.count : 0;
}

luxel_status luxel_scene_point(const luxel_scene *scene, size_t i, double *x_mm, double *y_mm)
{
    if (i >= luxel_scene_point_count(scene) || !x_mm || !y_mm)
        return LUXEL_ERROR_ARGUMENT;
    *x_mm = scene->parameters.points.xy[i][0];
    *y_mm = scene->parameters.points.xy[i][1];
    return LUXEL_OK;
}

size_t luxel_scene_surface_count(const luxel_scene *scene)
{
    return luxel_scene_is_committed(scene) ? scene->parameters.surfaces.count : 0;
}

static struct lx_shape shape_of(const luxel_scene *scene, size_t i)
{
    const struct lx_item *item = &scene->parameters.surfaces.items[i];
    return lx_surface_shape((const struct lx_surface_kind *)item->variant, item->parameters);
}

luxel_status luxel_scene_surface_place(const luxel_scene *scene, size_t i, double center_mm[3])
{
    if (i >= luxel_scene_surface_count(scene) || !center_mm)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_shape shape = shape_of(scene, i);
    memcpy(center_mm, shape.anchor_mm, sizeof shape.anchor_mm);
    return LUXEL_OK;
}

luxel_status luxel_scene_surface_radius(const luxel_scene *scene, size_t i, double *radius_mm)
{
    if (i >= luxel_scene_surface_count(scene) || !radius_mm)
        return LUXEL_ERROR_ARGUMENT;
    *radius_mm = shape_of(scene, i).radius_mm;
    return LUXEL_OK;
}

const char *luxel_scene_part_name(const luxel_scene *scene, size_t i, unsigned part)
{
    if (i >= luxel_scene_surface_count(scene))
        return NULL;
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)scene->parameters.surfaces.items[i].variant;
    return part < lx_part_count(kind) ? lx_part_name(kind, part) : NULL;
}

luxel_status luxel_scene_resolution(const luxel_scene *scene, unsigned *columns, unsigned *rows)
{
    if (!luxel_scene_is_committed(scene) || !columns || !rows)
        return LUXEL_ERROR_ARGUMENT;
    *columns = scene->parameters.screen.resolution[0];
    *rows = scene->parameters.screen.resolution[1];
    return LUXEL_OK;
}
