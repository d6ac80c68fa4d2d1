/* SPDX-License-Identifier: MIT */
/*
 * Advice about a committed scene, luxel_scene_advise() itself included: what the tables advise, surfaces that
 * are not wholly in view, lights that no visible part of a surface can see.
 */
#include <math.h>

#include "../base/number.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "../surface/part.h"
#include "mend.h"
#include "object.h"
#include "observer.h"

/* How far a surface reaches along a direction of the screen's frame, from its origin. */
static double farthest_on_screen(const struct lx_scene_parameters *scene, const struct lx_surface_kind *kind,
                                 const void *parameters, const double direction[3])
{
    const struct lx_frame frame = lx_observer_frame(&scene->observer);
    double in_scene[3];
    lx_frame_turn_back(&frame, direction, in_scene);
    return lx_surface_farthest(kind, parameters, in_scene) - lx_dot(in_scene, frame.origin_mm);
}

/*
 * How far a surface reaches beyond the edge of the screen, made `times` as large, on the side where `axis` (0: x,
 * 1: y) has this sign, in mm; negative: not at all.  In perspective the edge is the plane through the observer and the
 * screen's edge.
 */
static double beyond_edge(const struct lx_scene_parameters *scene, const struct lx_item *surface, int axis, double sign,
                          double times)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
    double half = times * (axis == 0 ? scene->screen.width_mm : scene->screen.height_mm) / 2;
    double normal[3] = {0, 0, 0};
    normal[axis] = sign;
    if (scene->observer.projection == LX_ORTHOGRAPHIC)
        return farthest_on_screen(scene, kind, surface->parameters, normal) - half;
    double eye = lx_observer_height(&scene->observer), length = hypot(eye, half);
    normal[axis] = sign * eye / length;
    normal[2] = half / length;
    return farthest_on_screen(scene, kind, surface->parameters, normal) - eye * normal[2];
}

static bool is_beyond(const struct lx_scene_parameters *scene, const struct lx_item *surface, int axis, bool upper,
                      double times)
{
    double tiny = 1e-9 * (scene->screen.width_mm + scene->screen.height_mm);
    return beyond_edge(scene, surface, axis, upper ? 1 : -1, times) > tiny;
}

/* Whether the observer stands within a surface, and so sees it on all sides. */
static bool is_around(const struct lx_scene_parameters *scene, const struct lx_item *surface)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
    const struct lx_frame frame = lx_observer_frame(&scene->observer);
    double place[3] = {0, 0, lx_observer_height(&scene->observer)};
    lx_frame_bring(&frame, place, place);
    return lx_surface_surrounds(kind, surface->parameters, place);
}

/* Whether a surface is one that nobody wants to see the ends of: it surrounds the observer, or fills the screen beyond
 * all its sides behind or under others, as a floor does. */
static bool is_backdrop(const struct lx_scene_parameters *scene, const struct lx_item *surface)
{
    bool fills = scene->surfaces.count > 1;
    for (int edge = 0; edge < 4 && fills; edge++)
        fills = is_beyond(scene, surface, edge / 2, edge % 2, 1);
    return fills || is_around(scene, surface);
}

/* The first of some round factors by which the screen must grow to show all surfaces; 0: none will do. */
static double find_growth(const struct lx_scene_parameters *scene)
{
    static const double factors[] = {1.1, 1.2, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    for (double ten = 1; ten <= 1e4; ten *= 10)
        for (size_t f = 0; f < LX_COUNT(factors); f++) {
            bool fits = true;
            for (size_t i = 0; i < scene->surfaces.count && fits; i++)
                for (int edge = 0; edge < 4 && fits && !is_backdrop(scene, &scene->surfaces.items[i]); edge++)
                    fits = !is_beyond(scene, &scene->surfaces.items[i], edge / 2, edge % 2, ten * factors[f]);
            if (fits)
                return ten * factors[f];
        }
    return 0;
}

static void mend_view(struct lx_walk *walk, const struct lx_scene_parameters *scene, double growth)
{
    char width[LX_NUMBER_SIZE], height[LX_NUMBER_SIZE];
    struct lx_text text = {0};
    if (!(growth > 0))
        return;
    lx_mend_add(&text, "screen.width=%s", lx_write_digits(scene->screen.width_mm * growth, 12, width));
    lx_mend_add(&text, "screen.height=%s", lx_write_digits(scene->screen.height_mm * growth, 12, height));
    lx_mend_hint(walk, &text);
}

void lx_add_sides_beyond(const struct lx_scene_parameters *scene, size_t surface, struct lx_text *sides)
{
    static const char *const names[2][2] = {{LX_N("left"), LX_N("right")}, {LX_N("bottom"), LX_N("top")}};
    const struct lx_item *item = &scene->surfaces.items[surface];
    for (int edge = 0; edge < 4 && !is_backdrop(scene, item); edge++) {
        if (!is_beyond(scene, item, edge / 2, edge % 2, 1))
            continue;
        lx_text_puts(sides, sides->length ? ", " : "");
        lx_add_phrase(sides, names[edge / 2][edge % 2], NULL);
    }
}

static void advise_view(struct lx_walk *walk, const struct lx_scene_parameters *scene, lx_node_id surfaces)
{
    lx_node_id id = lx_document_node(walk->document, surfaces)->first;
    double growth = -1; /* not known yet */
    for (size_t i = 0; i < scene->surfaces.count; i++, id = lx_document_node(walk->document, id)->next) {
        struct lx_text edges = {0};
        lx_add_sides_beyond(scene, i, &edges);
        struct lx_step list = {NULL, "surfaces", 0}, step = {&list, NULL, i};
        if (edges.length) {
            lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, id), &step,
                           LX_MSG_NOT_IN_VIEW, edges.bytes, NULL);
            growth = growth < 0 ? find_growth(scene) : growth;
            mend_view(walk, scene, growth);
        }
        lx_text_clear(&edges);
    }
}

static bool is_behind(const struct lx_scene_parameters *scene, const double place_mm[3])
{
    const struct lx_frame frame = lx_observer_frame(&scene->observer);
    bool is_behind_all = scene->surfaces.count > 0;
    for (size_t s = 0; s < scene->surfaces.count && is_behind_all; s++) {
        const struct lx_item *surface = &scene->surfaces.items[s];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
        is_behind_all = lx_surface_is_dark(kind, surface->parameters, &frame, place_mm);
    }
    return is_behind_all;
}

/* The place, raised above the first surface, as the screen has it. */
static void mend_behind(struct lx_walk *walk, const struct lx_scene_parameters *scene, size_t light,
                        const double place_mm[3])
{
    const struct lx_item *surface = &scene->surfaces.items[0];
    char numbers[3][LX_NUMBER_SIZE];
    double low[3], high[3], place[3];
    struct lx_text text = {0};
    const struct lx_frame frame = lx_observer_frame(&scene->observer);
    lx_surface_extent((const struct lx_surface_kind *)surface->variant, surface->parameters, &frame, low, high);
    double raised = high[2] + fmax(high[0] - low[0], high[1] - low[1]), step = pow(10, floor(log10(fabs(raised))) - 1);
    raised = raised != 0 ? ceil(raised / step) * step : 0;
    lx_frame_carry(&frame, place_mm, place);
    place[2] = raised;
    lx_frame_bring(&frame, place, place);
    for (int i = 0; i < 3 && !frame.is_own && step > 0; i++)
        place[i] = round(place[i] / step) * step + 0.0;
    if (is_behind(scene, place))
        return;
    lx_mend_add(&text, "lights[%zu].position=[%s, %s, %s]", light,
                frame.is_own ? lx_write_number(place[0], numbers[0]) : lx_write_digits(place[0], 12, numbers[0]),
                frame.is_own ? lx_write_number(place[1], numbers[1]) : lx_write_digits(place[1], 12, numbers[1]),
                lx_write_digits(place[2], 12, numbers[2]));
    lx_mend_hint(walk, &text);
}

static void advise_lights(struct lx_walk *walk, const struct lx_scene_parameters *scene, lx_node_id lights)
{
    lx_node_id id = lx_document_node(walk->document, lights)->first;
    for (size_t i = 0; i < scene->lights.count; i++, id = lx_document_node(walk->document, id)->next) {
        const struct lx_item *light = &scene->lights.items[i];
        const struct lx_light_common *common = light->common;
        const struct lx_parameter *position = lx_find_parameter(light->variant->table, "position");
        if (!position || !common->enabled || lx_array_of(light))
            continue;
        const double *place_mm = lx_const_member(position, light->parameters);
        if (!is_behind(scene, place_mm))
            continue;
        struct lx_step list = {NULL, "lights", 0}, item = {&list, NULL, i}, step = {&item, "position", 0};
        const bool is_kept = lx_keeps(walk->diagnostics, LUXEL_SEVERITY_ADVICE);
        lx_walk_report(walk, LUXEL_SEVERITY_ADVICE,
                       lx_document_place(walk->document, lx_document_find(walk->document, id, "position")), &step,
                       LX_MSG_LIGHT_BEHIND, NULL, NULL);
        if (is_kept)
            mend_behind(walk, scene, i, place_mm);
    }
}

/* Which lengths are usual in a scene beyond those that are advised: as far as its rooms and large surfaces reach. */
static struct lx_interval lengths_of(const struct lx_scene_parameters *scene)
{
    struct lx_interval lengths = {.low = 0, .high = 0};
    for (size_t s = 0; s < scene->surfaces.count; s++) {
        const struct lx_item *surface = &scene->surfaces.items[s];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
        const struct lx_shape shape = lx_surface_shape(kind, surface->parameters);
        double low[3], high[3], largest = 0;
        kind->extent(surface->parameters, low, high);
        for (int i = 0; i < 3; i++)
            largest = fmax(largest, high[i] - low[i]);
        if (!lx_surface_surrounds(kind, surface->parameters, shape.anchor_mm) && !(largest > LX_USUAL_MM))
            continue;
        lengths.given = true;
        lengths.high = fmax(lengths.high, largest);
        for (int i = 0; i < 3; i++) {
            lengths.low = fmin(lengths.low, low[i]);
            lengths.high = fmax(lengths.high, high[i]);
        }
    }
    return lengths;
}

luxel_status luxel_scene_advise(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    struct lx_walk walk = lx_scene_walk(scene, diagnostics);
    walk.mend = lx_mend_number;
    walk.scene = scene;
    lx_node_id root = scene->document.root;
    walk.lengths = lengths_of(&scene->parameters);
    lx_advise_parameters(&walk, &lx_scene_table, &scene->parameters);
    advise_view(&walk, &scene->parameters, lx_document_find(&scene->document, root, "surfaces"));
    lx_advise_unseen(&walk, scene);
    advise_lights(&walk, &scene->parameters, lx_document_find(&scene->document, root, "lights"));
    lx_advise_design(&walk, scene);
    lx_advise_colors(&walk, scene);
    return walk.out_of_memory ? lx_out_of_memory(diagnostics) : LUXEL_OK;
}
