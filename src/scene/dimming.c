/* SPDX-License-Identifier: MIT */
/* Dimming groups: lights that are dimmed together, by the name of their group. */
#include <string.h>

#include "../light/light.h"
#include "object.h"

static const struct lx_parameter dimming_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_dimming, name),
        .required = true,
        .meaning = "the name of the group, which is the key group of its lights",
    },
    {
        .name = "factor",
        .label = "Factor",
        .type = LX_REAL,
        .offset = offsetof(struct lx_dimming, factor),
        .required = true,
        .legal = LX_BETWEEN(0, 1),
        .meaning = "the share of their light that the lights of the group give; sky and sun are never dimmed",
    },
};

const struct lx_table lx_dimming_table = {
    .parameters = dimming_parameters,
    .count = LX_COUNT(dimming_parameters),
    .size = sizeof(struct lx_dimming),
};

static const char *group_of(const struct lx_item *light)
{
    return light->common ? ((const struct lx_light_common *)light->common)->group : NULL;
}

static const struct lx_dimming *dimming_at(const struct lx_scene_parameters *scene, size_t i)
{
    return (const struct lx_dimming *)scene->dimming.items + i;
}

double lx_dimming_of(const struct lx_scene_parameters *scene, const struct lx_item *light)
{
    const char *group = group_of(light);
    for (size_t i = 0; group && i < scene->dimming.count; i++)
        if (strcmp(dimming_at(scene, i)->name, group) == 0)
            return dimming_at(scene, i)->factor;
    return 1;
}

/* Reports the name of a group of which no light is, and the groups that there are. */
static void report_empty(struct lx_walk *walk, const struct lx_scene_parameters *scene, struct lx_place place,
                         const struct lx_step *step, const char *name)
{
    struct lx_text groups = {0};
    for (size_t i = 0; i < scene->lights.count; i++) {
        const char *group = group_of(&scene->lights.items[i]);
        bool is_new = group != NULL;
        for (size_t k = 0; k < i && is_new; k++) {
            const char *other = group_of(&scene->lights.items[k]);
            is_new = !other || strcmp(other, group) != 0;
        }
        if (is_new)
            lx_text_printf(&groups, "%s%.100s", groups.length > 0 ? ", " : "", group);
    }
    lx_walk_tell(walk, LUXEL_SEVERITY_ERROR, place, step, LX_MSG_WRONG_CHOICE,
                 LX_ARGS(groups.bytes ? groups.bytes : "–", name));
    lx_text_clear(&groups);
}

void lx_check_dimming(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_scene_parameters *parameters = &scene->parameters;
    const struct lx_document *document = walk->document;
    const lx_node_id list = lx_document_find(document, document->root, "dimming");
    for (size_t i = 0; i < parameters->dimming.count; i++) {
        const char *name = dimming_at(parameters, i)->name;
        const lx_node_id mapping = list ? lx_document_element(document, list, i) : 0;
        const struct lx_place place =
            lx_document_place(document, mapping ? lx_document_find(document, mapping, "name") : 0);
        const struct lx_step of_list = {NULL, "dimming", 0}, item = {&of_list, NULL, i}, step = {&item, "name", 0};
        bool is_used = false, is_doubled = false;
        for (size_t k = 0; name && k < i; k++) {
            const char *other = dimming_at(parameters, k)->name;
            is_doubled = is_doubled || (other && strcmp(other, name) == 0);
        }
        for (size_t k = 0; name && k < parameters->lights.count; k++) {
            const char *group = group_of(&parameters->lights.items[k]);
            is_used = is_used || (group && strcmp(group, name) == 0);
        }
        if (is_doubled)
            lx_walk_tell(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_DOUBLED_KEY, NULL);
        else if (name && !is_used)
            report_empty(walk, parameters, place, &step, name);
    }
}
