/* SPDX-License-Identifier: MIT */
/*
 * Bindings of keys to the decoded parameters, and the checks of what they can change: the legal range of the value, the
 * rules of the mappings around it, and what must hold between the parts of the scene.
 */
#include "bind.h"

#include <string.h>

size_t lx_bound_size(const struct lx_parameter *parameter)
{
    switch (parameter->type) {
    case LX_REAL: return sizeof(double);
    case LX_REALS: return parameter->count * sizeof(double);
    case LX_WHOLE: return sizeof(unsigned);
    case LX_WHOLES: return parameter->count * sizeof(unsigned);
    case LX_BOOLEAN: return sizeof(bool);
    case LX_CHOICE: return sizeof(int);
    default: return 0;
    }
}

/* Where a walk along a path stands: in a mapping of one or two tables, or at a value. */
struct stand {
    size_t table_count;
    const struct lx_table *tables[2];
    void *parameters[2];
    const struct lx_parameter *parameter; /* NULL inside a mapping */
    void *value;
};

static void enter_mapping(struct stand *stand, const struct lx_table *table, void *parameters)
{
    *stand = (struct stand){.table_count = 1, .tables = {table}, .parameters = {parameters}};
}

/* Enters an element of a list of mappings; false where there is none such. */
static bool enter_element(struct stand *stand, size_t index)
{
    const struct lx_parameter *list = stand->parameter;
    if (list->type == LX_GROUPS) {
        const struct lx_groups *groups = stand->value;
        if (index >= groups->count)
            return false;
        enter_mapping(stand, list->group, (char *)groups->items + index * list->group->size);
        return true;
    }
    const struct lx_list *items = stand->value;
    if (index >= items->count || !items->items[index].variant)
        return false;
    const struct lx_item *item = &items->items[index];
    *stand = (struct stand){.table_count = 2,
                            .tables = {item->variant->table, list->group},
                            .parameters = {item->parameters, item->common}};
    return true;
}

/* Steps to the value of a key; the mapping that has it joins those of the binding. */
static bool step_to_key(struct stand *stand, const char *key, lx_node_id mapping, struct lx_binding *binding)
{
    for (size_t t = 0; t < stand->table_count; t++) {
        const struct lx_parameter *found = lx_find_parameter(stand->tables[t], key);
        if (!found)
            continue;
        memmove(binding->mappings + 1, binding->mappings, binding->mapping_count * sizeof *binding->mappings);
        binding->mappings[0] = (struct lx_bound_mapping){stand->tables[t], stand->parameters[t], mapping};
        binding->mapping_count++;
        void *value = lx_member(found, stand->parameters[t]);
        *stand = (struct stand){.parameter = found, .value = value};
        if (found->type == LX_GROUP)
            enter_mapping(stand, found->group, value);
        return true;
    }
    return false;
}

bool lx_bind(luxel_scene *scene, const struct lx_path *path, struct lx_binding *binding)
{
    struct stand stand;
    *binding = (struct lx_binding){0};
    if (!scene->committed || !path->nodes[path->count])
        return false;
    enter_mapping(&stand, &lx_scene_table, &scene->parameters);
    for (size_t i = 0; i < path->count; i++) {
        const struct lx_segment *segment = &path->segments[i];
        if (!segment->is_index) {
            if (!step_to_key(&stand, segment->key, path->nodes[i], binding))
                return false;
        } else if (stand.parameter && lx_has_tables(stand.parameter)) {
            if (!enter_element(&stand, segment->index))
                return false;
        } else {
            binding->is_component = true;
            binding->component = (unsigned)segment->index;
        }
    }
    binding->parameter = stand.parameter;
    binding->value = stand.value;
    bool good = stand.parameter && lx_bound_size(stand.parameter) > 0;
    for (size_t i = 0; i < binding->mapping_count; i++)
        good = good && !binding->mappings[i].table->release;
    return good;
}

void lx_bound_put(luxel_scene *scene, const struct lx_binding *binding, const void *value)
{
    size_t size = lx_bound_size(binding->parameter), offset = 0;
    if (binding->is_component) {
        size /= binding->parameter->count;
        offset = size * binding->component;
    }
    memcpy((char *)binding->value + offset, value, size);
    scene->is_ahead = true;
}

static bool in_range(const struct lx_binding *binding)
{
    const struct lx_parameter *parameter = binding->parameter;
    const double *reals = binding->value;
    const unsigned *wholes = binding->value;
    bool is_whole = parameter->type == LX_WHOLE || parameter->type == LX_WHOLES;
    if (!is_whole && parameter->type != LX_REAL && parameter->type != LX_REALS)
        return true;
    unsigned count = parameter->type == LX_REALS || parameter->type == LX_WHOLES ? parameter->count : 1;
    bool zero = true;
    for (unsigned i = 0; i < count; i++) {
        double number = is_whole ? wholes[i] : reals[i];
        if (!(number - number <= 0) || !lx_interval_holds(&parameter->legal, number))
            return false;
        zero = zero && !(number > 0 || number < 0);
    }
    return !(parameter->nonzero && zero);
}

bool lx_bound_check(luxel_scene *scene, const struct lx_binding *bindings, size_t count)
{
    struct lx_walk walk = lx_scene_walk(scene, NULL);
    walk.folder = scene->folder;
    for (size_t i = 0; i < count; i++) {
        if (!in_range(&bindings[i]))
            return false;
        for (size_t k = 0; k < bindings[i].mapping_count; k++) {
            const struct lx_bound_mapping *mapping = &bindings[i].mappings[k];
            const struct lx_check check = {&walk, NULL, mapping->table, mapping->parameters, mapping->node, false};
            uint64_t given = *(const uint64_t *)mapping->parameters;
            lx_check_rules(&check, given, given);
            if (mapping->table->check && !walk.failed)
                mapping->table->check(&check, mapping->parameters);
        }
    }
    lx_place_grids(&walk, scene);
    lx_validate_reflections(&walk, scene);
    return !walk.failed && !walk.out_of_memory;
}
