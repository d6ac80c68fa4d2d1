/* SPDX-License-Identifier: MIT */
/* Reliefs: how a surface of the present scene looks from any side, for the space view. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "core.h"

/* Room beside the ball around the surface. */
#define MARGIN 1.02

#define NUMBERS 13 /* in the text of a lone scene, each of less than 32 letters */

/* A scene of this surface alone as a far observer sees it who looks at its centre, or NULL. */
static luxel_scene *lone_scene(const char *surface, const double center[3], double reach, const double eye[3],
                               const double up[3], unsigned pixels)
{
    static const char form[] =
        "luxel: 1\n"
        "screen: {width: %.17g, height: %.17g, resolution: [%u, %u]}\n"
        "observer: {position: [%.17g, %.17g, %.17g], target: [%.17g, %.17g, %.17g], up: [%.17g, %.17g, %.17g]}\n"
        "surfaces: [%s]\n"
        "lights: [{type: ambient, irradiance: 1}]\n";
    const double side = 2 * MARGIN * reach, far = 4 * reach;
    const size_t room = strlen(surface) + sizeof form + NUMBERS * 32;
    char *text = malloc(room);
    luxel_scene *scene = NULL;
    if (!text)
        return NULL;
    const int length =
        snprintf(text, room, form, side, side, pixels, pixels, center[0] + far * eye[0], center[1] + far * eye[1],
                 center[2] + far * eye[2], center[0], center[1], center[2], up[0], up[1], up[2], surface);
    luxel_status status = luxel_scene_read_text(text, (size_t)length, "scene.yaml", fresh_diagnostics(), &scene);
    free(text);
    if (status == LUXEL_OK)
        status = luxel_scene_keep_files(scene, core.scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, core.diagnostics);
    if (status == LUXEL_OK)
        return scene;
    luxel_scene_free(scene);
    return NULL;
}

/* 0 where nothing is seen, else 1 to 255, the more the surface there is turned to the eye. */
static uint8_t shade(double depth, const double normal[3], const double eye[3])
{
    if (depth == 0)
        return 0;
    const double turned = normal[0] * eye[0] + normal[1] * eye[1] + normal[2] * eye[2];
    return (uint8_t)(1 + lround(254 * fmin(1, fabs(turned))));
}

/*
 * The shades of a surface, pixels x pixels of them row by row from the top, on a square around its centre with sides of
 * 2 MARGIN times the reach of page_scene(), looked at from the unit vector `eye` with `up` upwards.  NULL: there are
 * none.
 */
PAGE_CALLS(page_relief)
const uint8_t *page_relief(unsigned surface, double eye_x, double eye_y, double eye_z, double up_x, double up_y,
                           double up_z, unsigned pixels)
{
    static uint8_t *shades;
    const double eye[3] = {eye_x, eye_y, eye_z}, up[3] = {up_x, up_y, up_z};
    const size_t count = (size_t)pixels * pixels;
    double center[3], reach;
    char key[32], *text = NULL;
    free(shades);
    shades = NULL;
    if (!core.scene || luxel_scene_surface_place(core.scene, surface, center) != LUXEL_OK ||
        luxel_scene_surface_radius(core.scene, surface, &reach) != LUXEL_OK)
        return NULL;
    (void)snprintf(key, sizeof key, "surfaces[%u]", surface);
    if (luxel_scene_get(core.scene, key, NULL, NULL, &text) != LUXEL_OK || !text)
        return NULL;
    luxel_scene *scene = lone_scene(text, center, reach, eye, up, pixels);
    luxel_text_free(text);
    double *depth = calloc(count, sizeof *depth);
    double(*normals)[3] = calloc(count, sizeof *normals);
    uint8_t *made = malloc(count);
    const luxel_geometry wanted = {.depth_mm = depth, .normals = normals};
    if (scene && depth && normals && made &&
        luxel_find_geometry(scene, NULL, fresh_diagnostics(), &wanted) == LUXEL_OK) {
        for (size_t i = 0; i < count; i++)
            made[i] = shade(depth[i], normals[i], eye);
        shades = made;
    } else
        free(made);
    free(normals);
    free(depth);
    luxel_scene_free(scene);
    return shades;
}
