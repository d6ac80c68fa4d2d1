/* SPDX-License-Identifier: MIT */
/* Advice about colours: such as count for nothing, and lamps whose files tell a colour temperature. */
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../format/lamp/lamp_color.h"
#include "../light/light.h"
#include "colours.h"
#include "materials.h"
#include "object.h"

/* The node of light or surface i, and that of a key in it or itself. */
static lx_node_id node_of(const struct lx_document *document, const char *list, size_t i, const char *key)
{
    const lx_node_id all = lx_document_find(document, document->root, list);
    const lx_node_id element = all ? lx_document_element(document, all, i) : 0;
    const lx_node_id found = element && key ? lx_document_find(document, element, key) : 0;
    return found ? found : element ? element : document->root;
}

/* Reports at a key of light or surface i that it has no effect in a grey scene. */
static void advise_unused(struct lx_walk *walk, const char *list, size_t i, const char *place, const char *key)
{
    const struct lx_step up = {NULL, list, 0}, element = {&up, NULL, i}, group = {&element, place, 0},
                         step = {&group, key, 0};
    lx_walk_report(walk, LUXEL_SEVERITY_ADVICE,
                   lx_document_place(walk->document, node_of(walk->document, list, i, place)), key ? &step : &group,
                   LX_MSG_COLORS_NOT_USED, NULL, NULL);
    lx_hint(walk->diagnostics, LX_MSG_HINT_CHANNELS_RGB, NULL);
}

/* The first light or material that has a colour; false: none has. */
static bool tell_colors(struct lx_walk *walk, const struct lx_scene_parameters *scene, bool are_unused)
{
    bool any = false;
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_light_common *light = scene->lights.items[i].common;
        any = any || light->color.given;
        if (light->color.given && are_unused)
            advise_unused(walk, "lights", i, "color", NULL);
    }
    struct lx_scene_material at = {.material = NULL};
    while (lx_next_material(scene, &at)) {
        any = any || lx_has_color(at.material);
        if (lx_has_color(at.material) && are_unused)
            advise_unused(walk, "surfaces", at.surface, at.part ? "materials" : "material",
                          at.part ? at.part : "color");
    }
    return any;
}

/* Tells what a file says of its lamp's colour, at the key that names it. */
static void tell_lamp(struct lx_walk *walk, const struct lx_step *step, lx_node_id node, const char *file,
                      const struct lx_lamp_color *color)
{
    const struct lx_place place = lx_document_place(walk->document, node);
    struct lx_text list = {0};
    for (size_t i = 0; i < color->count; i++) {
        char number[LX_NUMBER_SIZE];
        lx_text_printf(&list, "%s%s", i > 0 ? ", " : "", lx_write_number(color->kelvins[i], number));
    }
    const char *kelvins = list.bytes ? list.bytes : "";
    if (color->count > 1)
        lx_walk_tell(walk, LUXEL_SEVERITY_ADVICE, place, step, LX_MSG_LAMP_COLORS, LX_ARGS(file, kelvins));
    else if (color->code[0])
        lx_walk_tell(walk, LUXEL_SEVERITY_ADVICE, place, step, LX_MSG_LAMP_COLOR_CODE,
                     LX_ARGS(file, color->code, kelvins));
    else
        lx_walk_tell(walk, LUXEL_SEVERITY_ADVICE, place, step, LX_MSG_LAMP_COLOR, LX_ARGS(file, kelvins));
    lx_text_clear(&list);
}

/* Lamps whose files tell a colour temperature that the scene does not have. */
static void advise_lamps(struct lx_walk *walk, const struct lx_scene_parameters *scene)
{
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *item = &scene->lights.items[i];
        const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
        const struct lx_light_common *light = item->common;
        const char *file;
        if (light->color.given || !light->enabled || !kind->photometry)
            continue;
        const luxel_photometry *photometry = kind->photometry(item->parameters, &file);
        const struct lx_lamp_color color =
            photometry ? lx_lamp_color_of(photometry) : (struct lx_lamp_color){.count = 0};
        const struct lx_step up = {NULL, "lights", 0}, element = {&up, NULL, i}, step = {&element, "file", 0};
        if (color.count > 0)
            tell_lamp(walk, &step, node_of(walk->document, "lights", i, "file"), file, &color);
    }
}

void lx_advise_colors(struct lx_walk *walk, const luxel_scene *scene)
{
    const bool is_rgb = scene->parameters.channels == LX_RGB;
    const bool any = tell_colors(walk, &scene->parameters, !is_rgb);
    if (!is_rgb)
        return;
    if (!any)
        lx_walk_report(
            walk, LUXEL_SEVERITY_ADVICE,
            lx_document_place(walk->document, lx_document_find(walk->document, walk->document->root, "channels")),
            &(struct lx_step){NULL, "channels", 0}, LX_MSG_NO_COLORS, NULL, NULL);
    advise_lamps(walk, &scene->parameters);
}
