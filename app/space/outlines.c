/* SPDX-License-Identifier: MIT */
/* Silhouettes, of meshes kept by what these are and how they are turned; where they stand only shifts them. */
#include "outlines.h"

#include <string.h>

#include "../base/number.h"

/* A mesh, as far as its silhouette depends on it. */
typedef struct Mesh {
    double size_mm[3], volume_mm3, scale_mm, turn[3], radius_mm;
    gsize triangles, corners, edges;
} Mesh;

typedef struct Outline {
    Mesh mesh;
    double centre_mm[3];
    luxel_silhouette *seen[APP_PROJECTIONS];
} Outline;

struct AppOutlines {
    GPtrArray *of; /* Outlines by surface; NULL: none yet */
};

static void free_outline(gpointer data)
{
    Outline *outline = data;
    for (int i = 0; outline && i < APP_PROJECTIONS; i++)
        luxel_silhouette_free(outline->seen[i]);
    g_free(outline);
}

AppOutlines *app_outlines_new(void)
{
    AppOutlines *outlines = g_new0(AppOutlines, 1);
    outlines->of = g_ptr_array_new_with_free_func(free_outline);
    return outlines;
}

void app_outlines_free(AppOutlines *outlines)
{
    if (!outlines)
        return;
    g_ptr_array_unref(outlines->of);
    g_free(outlines);
}

static gboolean read_mesh(const luxel_scene *scene, gsize surface, Mesh *mesh)
{
    luxel_mesh_survey survey;
    bool is_mesh = false;
    char key[APP_KEY_SIZE], *text = NULL;
    memset(mesh, 0, sizeof *mesh); /* so that meshes are compared as bytes */
    if (luxel_scene_surface_mesh(scene, surface, &is_mesh, &survey) != LUXEL_OK || !is_mesh ||
        luxel_scene_surface_radius(scene, surface, &mesh->radius_mm) != LUXEL_OK)
        return FALSE;
    g_snprintf(key, sizeof key, "surfaces[%zu].rotate", surface);
    if (luxel_scene_get(scene, key, NULL, NULL, &text) == LUXEL_OK)
        app_list_read(text, mesh->turn, G_N_ELEMENTS(mesh->turn));
    luxel_text_free(text);
    memcpy(mesh->size_mm, survey.size_mm, sizeof mesh->size_mm);
    mesh->volume_mm3 = survey.volume_mm3;
    mesh->scale_mm = survey.scale_mm;
    mesh->triangles = survey.triangles;
    mesh->corners = survey.corners;
    mesh->edges = survey.edges;
    return TRUE;
}

const luxel_silhouette *app_outlines_find(AppOutlines *outlines, const luxel_scene *scene, gsize surface,
                                          AppProjection projection, double then_mm[3], double now_mm[3])
{
    static const double x[3] = {1, 0, 0}, ups[APP_PROJECTIONS][3] = {{0, 1, 0}, {0, 0, 1}};
    Mesh mesh;
    const gboolean is_mesh = read_mesh(scene, surface, &mesh);
    if (luxel_scene_surface_place(scene, surface, now_mm) != LUXEL_OK)
        return NULL;
    if (surface >= outlines->of->len)
        g_ptr_array_set_size(outlines->of, (int)surface + 1);
    Outline *outline = g_ptr_array_index(outlines->of, surface);
    if (!outline || !is_mesh || memcmp(&outline->mesh, &mesh, sizeof mesh) != 0) {
        free_outline(outline);
        outline = g_new0(Outline, 1);
        outline->mesh = mesh;
        memcpy(outline->centre_mm, now_mm, sizeof outline->centre_mm);
        for (int i = 0; i < APP_PROJECTIONS; i++)
            if (luxel_find_silhouette(scene, surface, x, ups[i], &outline->seen[i]) != LUXEL_OK)
                outline->seen[i] = NULL;
        g_ptr_array_index(outlines->of, surface) = outline;
    }
    memcpy(then_mm, outline->centre_mm, sizeof outline->centre_mm);
    return outline->seen[projection];
}
