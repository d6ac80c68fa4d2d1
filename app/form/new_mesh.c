/* SPDX-License-Identifier: MIT */
/* A mesh is tried in a copy of the document, which tells how large it is and whether the scene still stands. */
#include "new_surface.h"

#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../base/scalar.h"

/* Shares of the shorter side of the screen: how large meshes are left as they are, and how large they are made. */
static const double LEAST = 0.1, MOST = 1.2, WANTED = 0.5;
static const double GAP_MM = 20;

/* ---- files ---- */

AppFileKind app_file_kind(const char *path)
{
    static const char *const meshes[] = {".obj", ".ply", ".stl", ".off", ".gltf", ".glb"};
    static const char *const luminaires[] = {".ies", ".ldt"};
    char *lower = g_ascii_strdown(path, -1);
    AppFileKind kind = APP_FILE_OTHER;
    for (gsize i = 0; i < G_N_ELEMENTS(meshes); i++)
        if (g_str_has_suffix(lower, meshes[i]))
            kind = APP_FILE_MESH;
    for (gsize i = 0; i < G_N_ELEMENTS(luminaires); i++)
        if (g_str_has_suffix(lower, luminaires[i]))
            kind = APP_FILE_LUMINAIRE;
    g_free(lower);
    return kind;
}

char *app_file_in_scene(const AppDocument *document, const char *path)
{
    const char *scene = app_document_path(document);
    GFile *file = g_file_new_for_path(path), *own = scene ? g_file_new_for_path(scene) : NULL;
    GFile *folder = own ? g_file_get_parent(own) : NULL;
    char *relative = folder ? g_file_get_relative_path(folder, file) : NULL;
    char *found = relative ? relative : g_file_get_path(file);
    g_object_unref(file);
    g_clear_object(&own);
    g_clear_object(&folder);
    return found;
}

/* ---- meshes ---- */

/* The surface as YAML. */
static char *write_mesh(const char *file, double scale, const double position[3])
{
    char number[APP_NUMBER_SIZE], *quoted = app_yaml_quote(file), *place = app_list_write(position, 3);
    char *yaml = g_strdup_printf("{type: mesh, file: %s, scale: %s, position: %s}", quoted,
                                 app_number_plain(scale, 3, number), place);
    g_free(quoted);
    g_free(place);
    return yaml;
}

/* The scene with one more surface, committed; NULL where that cannot be. */
static luxel_scene *try_mesh(const AppDocument *document, const char *yaml, luxel_diagnostics *diagnostics)
{
    luxel_scene *scene = app_document_copy_scene(document);
    const gsize count = app_document_size(document, "surfaces");
    if (scene && luxel_scene_insert(scene, "surfaces", count, yaml, diagnostics) == LUXEL_OK &&
        luxel_scene_commit(scene, diagnostics) == LUXEL_OK && luxel_scene_check_view(scene, diagnostics) == LUXEL_OK)
        return scene;
    luxel_scene_free(scene);
    return NULL;
}

/* How large it is at one mm for a unit, and where its middle is then; the faults of places do not count yet. */
static gboolean survey(const AppDocument *document, const char *file, double size[3], double middle[3],
                       luxel_diagnostics *diagnostics)
{
    const double origin[3] = {0};
    char *yaml = write_mesh(file, 1, origin);
    AppDocument *trial = app_document_copy(document);
    /* far above everything, so that no surface is beyond the observer */
    const AppEdit high[] = {{.kind = APP_EDIT_SET, .key = "observer.z", .value = "1e9"}};
    if (app_document_get_number(document, "observer.z") > 0)
        app_document_edit(trial, high, 1, NULL, NULL);
    luxel_scene *scene = try_mesh(trial, yaml, diagnostics);
    const gsize index = app_document_size(document, "surfaces");
    bool is_mesh = false;
    luxel_mesh_survey found;
    if (scene && luxel_scene_surface_mesh(scene, index, &is_mesh, &found) == LUXEL_OK && is_mesh &&
        luxel_scene_surface_place(scene, index, middle) == LUXEL_OK)
        memcpy(size, found.size_mm, sizeof found.size_mm);
    luxel_scene_free(scene);
    g_object_unref(trial);
    g_free(yaml);
    return is_mesh;
}

/* How far up the first surface reaches, as far as its keys say it; and where its middle is. */
static double top_of_first(const AppDocument *document, double center[3])
{
    char *text = app_document_get(document, "surfaces[0].center", NULL);
    if (app_list_read(text, center, 3) != 3)
        center[0] = center[1] = center[2] = 0;
    g_free(text);
    return center[2] + app_document_get_number(document, "surfaces[0].radius");
}

char *app_new_mesh(const AppDocument *document, const char *path, luxel_diagnostics *diagnostics)
{
    char *file = app_file_in_scene(document, path), *yaml = NULL;
    double size[3] = {0}, middle[3] = {0}, center[3];
    if (!survey(document, file, size, middle, diagnostics)) {
        g_free(file);
        return NULL;
    }
    const double side =
        MIN(app_document_get_number(document, "screen.width"), app_document_get_number(document, "screen.height"));
    const double extent = MAX(MAX(size[0], size[1]), size[2]);
    const gboolean suits = extent >= LEAST * side && extent <= MOST * side;
    char number[APP_NUMBER_SIZE];
    app_number_plain(suits || !(extent > 0) ? 1 : WANTED * side / extent, 2, number);
    const double scale = g_ascii_strtod(number, NULL), half = scale * size[2] / 2;
    const double top = top_of_first(document, center), observer = app_document_get_number(document, "observer.z");
    /* before the first surface; below the observer; in its middle */
    const double heights[] = {top + GAP_MM + half, observer - GAP_MM - half, center[2]};
    for (gsize i = 0; i < G_N_ELEMENTS(heights) && !yaml; i++) {
        const double heart[3] = {center[0], center[1], heights[i]};
        double position[3];
        for (int k = 0; k < 3; k++)
            position[k] = round(heart[k] - scale * middle[k]);
        yaml = write_mesh(file, scale, position);
        luxel_scene *scene = try_mesh(document, yaml, NULL);
        if (!scene && i + 1 < G_N_ELEMENTS(heights))
            g_clear_pointer(&yaml, g_free);
        luxel_scene_free(scene);
    }
    g_free(file);
    return yaml;
}
