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

/* A surface as its extent shows it: the centre and half the size along each axis. */
struct bounds {
    double center_mm[3], half_mm[3];
};

static struct bounds bounds_of(const struct lx_item *surface)
{
    double low[3], high[3];
    struct bounds bounds;
    ((const struct lx_surface_kind *)surface->variant)->extent(surface->parameters, low, high);
    for (int i = 0; i < 3; i++) {
        bounds.center_mm[i] = low[i] / 2 + high[i] / 2;
        bounds.half_mm[i] = high[i] / 2 - low[i] / 2;
    }
    return bounds;
}

/*
 * How far a surface reaches beyond the edge of the screen on the side where `axis` (0: x, 1: y) has this sign, in
 * mm; negative: not at all.  The surface counts as the ellipsoid in its bounds, which is exact for a sphere.
 * In perspective the edge is the plane through the observer and the screen's edge.
 */
static double beyond_edge(const struct lx_scene_parameters *scene, const struct bounds *bounds, int axis, double sign)
{
    double half = (axis == 0 ? scene->screen.width_mm : scene->screen.height_mm) / 2;
    double across = sign * bounds->center_mm[axis];
    if (scene->observer.projection == LX_ORTHOGRAPHIC)
        return across + bounds->half_mm[axis] - half;
    double eye = scene->observer.z_mm, length = hypot(eye, half);
    double normal_across = eye / length, normal_z = half / length;
    double distance = across * normal_across + (bounds->center_mm[2] - eye) * normal_z;
    return distance + hypot(bounds->half_mm[axis] * normal_across, bounds->half_mm[2] * normal_z);
}

static void advise_view(struct lx_walk *walk, const struct lx_scene_parameters *scene, lx_node_id surfaces)
{
    static const char *const sides[2][2] = {{LX_N("left"), LX_N("right")}, {LX_N("bottom"), LX_N("top")}};
    lx_node_id id = lx_document_node(walk->document, surfaces)->first;
    for (size_t i = 0; i < scene->surfaces.count; i++, id = lx_document_node(walk->document, id)->next) {
        struct bounds bounds = bounds_of(&scene->surfaces.items[i]);
        struct lx_text edges = {0};
        for (int axis = 0; axis < 2; axis++)
            for (int side = 0; side < 2; side++) {
                double tiny = 1e-9 * (scene->screen.width_mm + scene->screen.height_mm);
                if (!(beyond_edge(scene, &bounds, axis, side ? 1 : -1) > tiny))
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

/*
 * Whether a source here lights nothing of the surface that the observer sees: it is inside, or behind and in
 * the shadow of the outline.  Exact for a sphere seen along z.
 */
static bool is_behind(const struct bounds *bounds, const double place_mm[3])
{
    double q[3];
    for (int i = 0; i < 3; i++) {
        if (!(bounds->half_mm[i] > 0))
            return false;
        q[i] = (place_mm[i] - bounds->center_mm[i]) / bounds->half_mm[i];
    }
    double across = q[0] * q[0] + q[1] * q[1];
    return across + (q[2] < 0 ? 0 : q[2] * q[2]) <= 1;
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
            struct bounds bounds = bounds_of(&scene->surfaces.items[s]);
            behind = is_behind(&bounds, lx_const_member(position, light->parameters));
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
