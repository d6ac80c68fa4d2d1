/* SPDX-License-Identifier: MIT */
/*
 * Advice about a committed scene, luxel_scene_advise() itself included: what the tables advise, surfaces that
 * are not wholly in view, lights that no visible part of a surface can see.
 */
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../surface/surface.h"
#include "object.h"

/*
 * How far a surface reaches beyond the edge of the screen on the side where `axis` (0: x, 1: y) has this sign, in
 * mm; negative: not at all.  In perspective the edge is the plane through the observer and the screen's edge.
 */
static double beyond_edge(const struct lx_scene_parameters *scene, const struct lx_item *surface, int axis, double sign)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
    double half = (axis == 0 ? scene->screen.width_mm : scene->screen.height_mm) / 2;
    double normal[3] = {0, 0, 0};
    normal[axis] = sign;
    if (scene->observer.projection == LX_ORTHOGRAPHIC)
        return kind->farthest(surface->parameters, normal) - half;
    double eye = scene->observer.z_mm, length = hypot(eye, half);
    normal[axis] = sign * eye / length;
    normal[2] = half / length;
    return kind->farthest(surface->parameters, normal) - eye * normal[2];
}

static void advise_view(struct lx_walk *walk, const struct lx_scene_parameters *scene, lx_node_id surfaces)
{
    static const char *const sides[2][2] = {{LX_N("left"), LX_N("right")}, {LX_N("bottom"), LX_N("top")}};
    lx_node_id id = lx_document_node(walk->document, surfaces)->first;
    for (size_t i = 0; i < scene->surfaces.count; i++, id = lx_document_node(walk->document, id)->next) {
        struct lx_text edges = {0};
        for (int axis = 0; axis < 2; axis++)
            for (int side = 0; side < 2; side++) {
                double tiny = 1e-9 * (scene->screen.width_mm + scene->screen.height_mm);
                if (!(beyond_edge(scene, &scene->surfaces.items[i], axis, side ? 1 : -1) > tiny))
                    continue;
                lx_text_puts(&edges, edges.length ? ", " : "");
                lx_add_phrase(&edges, sides[axis][side], NULL);
            }
        struct lx_step list = {NULL, "surfaces", 0}, step = {&list, NULL, i};
        if (edges.length)
            lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, id), &step,
                           LX_MSG_NOT_IN_VIEW, edges.bytes, NULL);
        lx_text_clear(&edges);
    }
}

static void advise_lights(struct lx_walk *walk, const struct lx_scene_parameters *scene, lx_node_id lights)
{
    lx_node_id id = lx_document_node(walk->document, lights)->first;
    for (size_t i = 0; i < scene->lights.count; i++, id = lx_document_node(walk->document, id)->next) {
        const struct lx_item *light = &scene->lights.items[i];
        const struct lx_light_common *common = light->common;
        const struct lx_parameter *position = lx_find_parameter(light->variant->table, "position");
        if (!position || !common->enabled)
            continue;
        bool behind = true;
        for (size_t s = 0; s < scene->surfaces.count && behind; s++) {
            const struct lx_item *surface = &scene->surfaces.items[s];
            const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
            behind = kind->is_dark(surface->parameters, lx_const_member(position, light->parameters));
        }
        if (!behind)
            continue;
        struct lx_step list = {NULL, "lights", 0}, item = {&list, NULL, i}, step = {&item, "position", 0};
        lx_walk_report(walk, LUXEL_SEVERITY_ADVICE,
                       lx_document_place(walk->document, lx_document_find(walk->document, id, "position")), &step,
                       LX_MSG_LIGHT_BEHIND, NULL, NULL);
    }
}

luxel_status luxel_scene_advise(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (!luxel_scene_is_committed(scene)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NOT_COMMITTED, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    struct lx_walk walk = lx_scene_walk(scene, diagnostics);
    lx_node_id root = scene->document.root;
    lx_advise_parameters(&walk, &lx_scene_table, &scene->parameters);
    advise_view(&walk, &scene->parameters, lx_document_find(&scene->document, root, "surfaces"));
    advise_lights(&walk, &scene->parameters, lx_document_find(&scene->document, root, "lights"));
    return walk.out_of_memory ? lx_out_of_memory(diagnostics) : LUXEL_OK;
}
