/* SPDX-License-Identifier: MIT */
/* The flat list of all parameters, made by walking the tables once. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "reflect.h"
#include "words.h"

void lx_reflection_clear(struct lx_reflection *reflection)
{
    for (size_t i = 0; i < reflection->count; i++) {
        struct lx_reflected *item = &reflection->items[i];
        free(item->path);
        free(item->type);
        free(item->choices);
        free(item->legal);
        free(item->advised);
    }
    free(reflection->items);
    *reflection = (struct lx_reflection){0};
}

/* "100 to 10000 mm", or by component: "x -10 to 10, y -10 to 10, z 0 to 10 mm". */
static char *advised_words(const struct lx_parameter *parameter, const char *unit)
{
    static const char *const names[] = {"x ", ", y ", ", z "};
    struct lx_text text = {0};
    if (!parameter->advised[0].given)
        return NULL;
    bool by_component = parameter->advised[1].given;
    for (size_t i = 0; i < (by_component ? LX_COMPONENTS : 1); i++) {
        if (by_component)
            lx_text_puts(&text, names[i]);
        lx_add_range(&text, &parameter->advised[i], !by_component || i == LX_COMPONENTS - 1 ? unit : "");
    }
    return lx_text_take(&text);
}

/* Appends a parameter; `path` and `choices` become the list's. */
static int append(struct lx_reflection *reflection, const struct lx_parameter *parameter, const char *variant,
                  char *path, char *choices)
{
    if (lx_reserve((void **)&reflection->items, &reflection->capacity, reflection->count + 1,
                   sizeof *reflection->items) < 0) {
        free(path);
        free(choices);
        return -1;
    }
    const char *unit = lx_unit_word(parameter->unit, false);
    struct lx_text type = {0}, legal = {0};
    lx_add_type(&type, parameter);
    lx_add_range(&legal, &parameter->legal, unit);
    struct lx_reflected item = {.path = path, .type = lx_text_take(&type), .choices = choices};
    item.legal = lx_text_take(&legal);
    item.advised = advised_words(parameter, unit);
    bool whole = item.path && item.type && item.legal && (item.choices || !parameter->choices) &&
                 (item.advised || !parameter->advised[0].given);
    item.shown = (luxel_parameter){
        .path = item.path,
        .variant = variant,
        .type = item.type,
        .choices = item.choices,
        .unit = unit,
        .default_value = parameter->initial,
        .required = parameter->required,
        .legal = parameter->legal.given ? item.legal : NULL,
        .advised = item.advised,
        .meaning = parameter->meaning,
    };
    reflection->items[reflection->count++] = item;
    return whole ? 0 : -1;
}

static char *join_path(const char *up, const char *key)
{
    struct lx_text path = {0};
    lx_text_puts(&path, up);
    if (up[0])
        lx_text_puts(&path, ".");
    lx_text_puts(&path, key);
    return lx_text_take(&path);
}

static int reflect_table(struct lx_reflection *reflection, const struct lx_table *table, const char *up,
                         const char *variant);

/* The key `type` of a list's elements, the keys common to them, and those of each variant. */
static int reflect_list(struct lx_reflection *reflection, const struct lx_parameter *list, const char *path)
{
    static const struct lx_parameter type = {
        .name = "type", .type = LX_CHOICE, .required = true, .meaning = "which kind it is, which decides its other keys"};
    struct lx_text element = {0}, names = {0};
    lx_text_puts(&element, path);
    lx_text_puts(&element, "[]");
    lx_add_variants(&names, list->variants);
    char *up = lx_text_take(&element), *choices = lx_text_take(&names);
    if (!up || !choices) {
        free(up);
        free(choices);
        return -1;
    }
    int result = append(reflection, &type, NULL, join_path(up, "type"), choices);
    if (result == 0)
        result = reflect_table(reflection, list->group, up, NULL);
    for (size_t i = 0; result == 0 && list->variants[i]; i++)
        result = reflect_table(reflection, list->variants[i]->table, up, list->variants[i]->name);
    free(up);
    return result;
}

static int reflect_table(struct lx_reflection *reflection, const struct lx_table *table, const char *up,
                         const char *variant)
{
    int result = 0;
    for (size_t i = 0; result == 0 && i < table->count; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        struct lx_text choices = {0};
        if (parameter->choices)
            lx_add_choices(&choices, parameter->choices);
        size_t index = reflection->count;
        result = append(reflection, parameter, variant, join_path(up, parameter->name),
                        parameter->choices ? lx_text_take(&choices) : NULL);
        if (result < 0)
            break;
        const char *path = reflection->items[index].path;
        if (parameter->type == LX_GROUP)
            result = reflect_table(reflection, parameter->group, path, variant);
        else if (parameter->type == LX_VARIANTS)
            result = reflect_list(reflection, parameter, path);
    }
    return result;
}

int lx_reflect(const struct lx_table *table, struct lx_reflection *reflection)
{
    *reflection = (struct lx_reflection){0};
    int result = reflect_table(reflection, table, "", NULL);
    if (result < 0)
        lx_reflection_clear(reflection);
    return result;
}
