/* SPDX-License-Identifier: MIT */
/* Puts advice at its place, and words and tries what mends it. */
#include "adviser.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../base/number.h"
#include "../surface/surface.h"

luxel_status lx_adviser_begin(struct lx_adviser *adviser, const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (!scene || !luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    *adviser = (struct lx_adviser){
        .scene = scene,
        .parameters = lx_scene_parameters(scene),
        .walk = lx_scene_walk(scene, diagnostics),
        .effort = LX_SCOUT_EFFORT,
    };
    return LUXEL_OK;
}

/* The node below `up` with this key, or `up` where it is not written. */
static lx_node_id below(const struct lx_document *document, lx_node_id up, const char *key)
{
    lx_node_id id = key && lx_document_node(document, up)->kind == LX_MAPPING ? lx_document_find(document, up, key) : 0;
    return id ? id : up;
}

/* A part of a node that came with an assignment where the node itself did not: then the text around it is not what
 * counts.  0: there is none. */
static lx_node_id assigned_part(const struct lx_document *document, lx_node_id id, uint32_t source)
{
    for (lx_node_id part = lx_document_node(document, id)->first; part; part = lx_document_node(document, part)->next) {
        const lx_node_id inner =
            lx_document_node(document, part)->source != source ? part : assigned_part(document, part, source);
        if (inner)
            return inner;
    }
    return 0;
}

void lx_advise(struct lx_adviser *adviser, struct lx_advised advised, enum lx_message message, const char *first)
{
    const struct lx_document *document = &adviser->scene->document;
    const struct lx_step list = {NULL, advised.list, 0}, element = {&list, NULL, advised.index};
    const struct lx_step *top = advised.has_index ? &element : &list;
    const struct lx_step key = {top, advised.key, 0}, under = {&key, advised.below, 0};
    const struct lx_step last = {&under, advised.last, 0};
    lx_node_id id = below(document, document->root, advised.list);
    if (advised.has_index && lx_document_node(document, id)->kind == LX_SEQUENCE)
        id = lx_document_element(document, id, advised.index);
    if (advised.key)
        id = below(document, id, advised.key);
    if (advised.below)
        id = below(document, id, advised.below);
    if (advised.last)
        id = below(document, id, advised.last);
    const lx_node_id part = assigned_part(document, id, lx_document_node(document, id)->source);
    id = part ? part : id;
    lx_walk_report(&adviser->walk, LUXEL_SEVERITY_ADVICE, lx_document_place(document, id),
                   advised.last    ? &last
                   : advised.below ? &under
                   : advised.key   ? &key
                                   : top,
                   message, first, NULL);
}

void lx_suggest(struct lx_adviser *adviser, const char *const *assignments)
{
    struct lx_text text = {0};
    for (; *assignments; assignments++)
        lx_text_printf(&text, "%s-s '%s'", text.length ? " " : "", *assignments);
    char *words = lx_text_take(&text);
    if (words)
        lx_hint(adviser->walk.diagnostics, LX_MSG_HINT_TRY, LX_ARGS(words));
    adviser->out_of_memory = adviser->out_of_memory || !words;
    free(words);
}

static bool suggest_if(struct lx_adviser *adviser, lx_mends *mends, const char *const *assignments)
{
    if (adviser->out_of_memory || !mends(adviser, assignments))
        return false;
    lx_suggest(adviser, assignments);
    return true;
}

bool lx_try_pair(struct lx_adviser *adviser, lx_mends *mends, const char *first, const char *second)
{
    return suggest_if(adviser, mends, (const char *const[]){first, second, NULL});
}

bool lx_try(struct lx_adviser *adviser, lx_mends *mends, const char *first, const char *second)
{
    return suggest_if(adviser, mends, (const char *const[]){first, NULL}) ||
           (second && lx_try_pair(adviser, mends, first, second));
}

/* Away from zero to a number of two digits. */
static double round_out(double value)
{
    if (value == 0)
        return 0;
    double step = pow(10, floor(log10(fabs(value))) - 1);
    return copysign(ceil(fabs(value) / step - 1e-9) * step, value);
}

/* The ways below lead so far within a room, as a share of its size. */
static const double WITHIN = 0.1;

/* The box around all surfaces; or true, and that of one which surrounds its middle, where lights have to be within. */
static bool find_space(const struct lx_scene_parameters *scene, double low[3], double high[3])
{
    for (size_t s = 0; s < scene->surfaces.count; s++) {
        const struct lx_item *surface = &scene->surfaces.items[s];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
        double from[3], to[3], middle[3];
        kind->extent(surface->parameters, from, to);
        for (int axis = 0; axis < 3; axis++)
            middle[axis] = (from[axis] + to[axis]) / 2;
        const bool surrounds = lx_surface_surrounds(kind, surface->parameters, middle);
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = surrounds ? from[axis] : fmin(low[axis], from[axis]);
            high[axis] = surrounds ? to[axis] : fmax(high[axis], to[axis]);
        }
        if (surrounds)
            return true;
    }
    return false;
}

/* Around and above the middle of all surfaces, as seen from their distance; the steeper ones last. */
bool lx_write_place(const struct lx_adviser *adviser, size_t i, char buffer[LX_PLACE_SIZE])
{
    static const double ways[][3] = {{1, 0.5, 1.5}, {1, 1, 2}, {-1, 1, 2}, {1, -1, 3}, {0, 1, 3}, {0.5, 0, 4}};
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, size = 0;
    char numbers[3][LX_NUMBER_SIZE];
    if (i >= LX_COUNT(ways))
        return false;
    const bool is_within = find_space(adviser->parameters, low, high);
    for (int axis = 0; axis < 3; axis++)
        size = fmax(size, high[axis] - low[axis]);
    for (int axis = 0; axis < 3; axis++) {
        const double middle = (low[axis] + high[axis]) / 2, from = axis == 2 && !is_within ? high[2] : middle;
        const double step = is_within ? WITHIN * (high[axis] - low[axis]) : size;
        lx_write_digits(round_out(from + step * ways[i][axis]), 15, numbers[axis]);
    }
    snprintf(buffer, LX_PLACE_SIZE, "[%s, %s, %s]", numbers[0], numbers[1], numbers[2]);
    return true;
}

/* The key that says where a light of a kind is: its position, or a centre that was given; NULL: there is none. */
static const char *place_key(const struct lx_item *light, char buffer[LX_KEY_SIZE])
{
    const struct lx_table *table = light->variant->table;
    if (lx_find_parameter(table, "position"))
        return "position";
    for (size_t i = 0; i < table->count; i++) {
        const struct lx_parameter *group = &table->parameters[i];
        if (group->type != LX_GROUP || !lx_is_given(table, light->parameters, group->name) ||
            !lx_find_parameter(group->group, "center"))
            continue;
        snprintf(buffer, LX_KEY_SIZE, "%s.center", group->name);
        return buffer;
    }
    return NULL;
}

bool lx_try_places(struct lx_adviser *adviser, lx_mends *mends, size_t light)
{
    static const char *const directions[] = {"[-2, -1, -3]", "[-1, -1, -3]", "[0, 0, -1]"};
    const struct lx_item *item = &adviser->parameters->lights.items[light];
    char words[LX_ADVICE_SIZE], buffer[LX_KEY_SIZE], place[LX_PLACE_SIZE];
    bool is_distant = lx_find_parameter(item->variant->table, "direction");
    const char *key = place_key(item, buffer);
    for (size_t i = 0; is_distant && i < LX_COUNT(directions); i++) {
        snprintf(words, sizeof words, "lights[%zu].direction=%s", light, directions[i]);
        if (lx_try(adviser, mends, words, NULL))
            return true;
    }
    for (size_t i = 0; key && lx_write_place(adviser, i, place); i++) {
        snprintf(words, sizeof words, "lights[%zu].%s=%s", light, key, place);
        if (lx_try(adviser, mends, words, NULL))
            return true;
    }
    return false;
}
