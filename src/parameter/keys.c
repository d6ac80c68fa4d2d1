/* SPDX-License-Identifier: MIT */
/* Finding keys in tables, and what to say about those that are in none. */
#include <stdlib.h>
#include <string.h>

#include "decode.h"

const struct lx_parameter *lx_find_parameter(const struct lx_table *table, const char *name)
{
    for (size_t i = 0; table && i < table->count; i++)
        if (strcmp(table->parameters[i].name, name) == 0)
            return &table->parameters[i];
    return NULL;
}

static void add_word(struct lx_text *text, const char *word)
{
    if (text->length)
        lx_text_puts(text, ", ");
    lx_text_puts(text, word);
}

/* The types of the list that have a key of this name, "" for none. */
static char *types_with(const struct lx_parameter *list, const char *key)
{
    struct lx_text types = {0};
    for (size_t i = 0; list && list->variants[i]; i++)
        if (lx_find_parameter(list->variants[i]->table, key))
            add_word(&types, list->variants[i]->name);
    return lx_text_take(&types);
}

/* The groups of the tables that have a key of this name, "" for none. */
static char *groups_with(const struct lx_table *const *tables, size_t count, const char *key)
{
    struct lx_text groups = {0};
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++)
            if (tables[t]->parameters[i].type == LX_GROUP && lx_find_parameter(tables[t]->parameters[i].group, key))
                add_word(&groups, tables[t]->parameters[i].name);
    return lx_text_take(&groups);
}

static bool is_strength(const struct lx_parameter *parameter)
{
    return parameter && parameter->unit >= LX_UNIT_INTENSITY && parameter->unit <= LX_UNIT_POWER;
}

/* The keys of the tables that tell how strong a light is, "" for none. */
static char *strengths_of(const struct lx_table *const *tables, size_t count)
{
    struct lx_text keys = {0};
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++)
            if (is_strength(&tables[t]->parameters[i]))
                add_word(&keys, tables[t]->parameters[i].name);
    return lx_text_take(&keys);
}

/* Says of which types a key is, and, of a strength, what there is instead of it; false: of none. */
static bool hint_other_types(luxel_diagnostics *diagnostics, const char *key, const struct lx_table *const *tables,
                             size_t count, const struct lx_parameter *list)
{
    char *types = types_with(list, key), *strengths = strengths_of(tables, count);
    const bool found = types && types[0];
    bool tells_strength = false;
    for (size_t i = 0; found && list->variants[i]; i++)
        tells_strength = tells_strength || is_strength(lx_find_parameter(list->variants[i]->table, key));
    if (found && tells_strength && strengths && strengths[0])
        lx_hint(diagnostics, LX_MSG_HINT_OTHER_STRENGTH, LX_ARGS(key, types, strengths));
    else if (found)
        lx_hint(diagnostics, LX_MSG_HINT_OTHER_TYPES, LX_ARGS(key, types));
    free(types);
    free(strengths);
    return found;
}

/* What other programs call a key of the tables; NULL: there is none. */
static const char *usual_key(const char *key, const struct lx_table *const *tables, size_t count)
{
    static const char *const names[][2] = {
        {"flux", "power"},
        {"luminous_flux", "power"},
        {"radiant_flux", "power"},
        {"lumens", "power"},
        {"lumen", "power"},
        {"watts", "power"},
        {"watt", "power"},
        {"candela", "intensity"},
        {"candelas", "intensity"},
        {"lux", "irradiance"},
        {"illuminance", "irradiance"},
        {"luminance", "radiance"},
    };
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < LX_COUNT(names); i++)
            if (strcmp(names[i][0], key) == 0 && lx_find_parameter(tables[t], names[i][1]))
                return names[i][1];
    return NULL;
}

/* "z:1500", a key and its value without a space between them, is one word to YAML. */
static bool hint_colon(luxel_diagnostics *diagnostics, const char *key, const struct lx_table *const *tables,
                       size_t count)
{
    const char *colon = strchr(key, ':');
    struct lx_text name = {0};
    bool is_known = false;
    if (!colon || !colon[1])
        return false;
    lx_text_printf(&name, "%.*s", (int)(colon - key), key);
    for (size_t t = 0; t < count && name.bytes; t++)
        is_known |= lx_find_parameter(tables[t], name.bytes) != NULL;
    if (is_known)
        lx_hint(diagnostics, LX_MSG_HINT_COLON, NULL);
    lx_text_clear(&name);
    return is_known;
}

const char *lx_hint_unknown_key(luxel_diagnostics *diagnostics, const char *key, const struct lx_table *const *tables,
                                size_t count, const struct lx_parameter *list)
{
    const char *usual = usual_key(key, tables, count);
    if (usual) {
        lx_hint(diagnostics, LX_MSG_DID_YOU_MEAN, LX_ARGS(usual));
        return usual;
    }
    if (hint_other_types(diagnostics, key, tables, count, list) || hint_colon(diagnostics, key, tables, count))
        return NULL;
    char *groups = groups_with(tables, count, key);
    if (groups && groups[0]) {
        lx_hint(diagnostics, LX_MSG_HINT_BELOW, LX_ARGS(key, groups));
        free(groups);
        return NULL;
    }
    free(groups);
    struct lx_nearest nearest = {.word = key, .length = strlen(key)};
    struct lx_text known = {0};
    if (list) {
        lx_nearest_offer(&nearest, "type");
        add_word(&known, "type");
    }
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++) {
            lx_nearest_offer(&nearest, tables[t]->parameters[i].name);
            add_word(&known, tables[t]->parameters[i].name);
        }
    char *words = lx_text_take(&known);
    if (!lx_hint_nearest(diagnostics, &nearest) && words)
        lx_hint(diagnostics, LX_MSG_HINT_KNOWN_KEYS, LX_ARGS(words));
    free(words);
    return nearest.best;
}

bool lx_hint_nearest(luxel_diagnostics *diagnostics, const struct lx_nearest *nearest)
{
    if (nearest->best)
        lx_hint(diagnostics, LX_MSG_DID_YOU_MEAN, LX_ARGS(nearest->best));
    return nearest->best != NULL;
}

const struct lx_variant *lx_find_variant(const struct lx_parameter *list, const char *name)
{
    for (size_t i = 0; list->variants[i]; i++)
        if (strcmp(list->variants[i]->name, name) == 0)
            return list->variants[i];
    return NULL;
}
