/* SPDX-License-Identifier: MIT */
/* Free keys of a scene, read by its parameter tables and written as -s writes them. */
#include "keys.h"

#include <stdlib.h>
#include <string.h>

#include "../api/refuse.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/text.h"
#include "../parameter/words.h"

/* How many numbers stand at the end of a path, 0: no continuous ones do. */
static size_t numbers_at(const struct lx_path *path)
{
    const struct lx_parameter *parameter = path->parameter;
    if (!parameter)
        return 0;
    switch (parameter->type) {
    case LX_REAL: return path->depth == 0;
    case LX_REALS: return path->depth == 0 ? parameter->count : 1;
    case LX_POINTS: return path->depth == 1 ? 2 : path->depth == 2;
    case LX_VECTORS: return path->depth == 1 ? 3 : path->depth == 2;
    default: return 0;
    }
}

/* Reads so many numbers of a value such as "10" or "[0, 0, 1000]". */
static bool read_numbers(const char *text, size_t count, double *numbers)
{
    static const char between[] = "[], ";
    size_t read = 0;
    for (text += strspn(text, between); *text && read < count; read++) {
        const size_t length = strcspn(text, between);
        if (!lx_read_number(text, length, &numbers[read]))
            return false;
        text += length;
        text += strspn(text, between);
    }
    return read == count && !*text;
}

/* What the value says; of zeros so much as is common in scenes. */
static double scale_of(const struct lx_target *target, size_t count, enum lx_unit unit)
{
    double square = 0.0;
    for (size_t i = 0; i < count; i++)
        square += target->numbers[i] * target->numbers[i];
    return square > 0.0 ? sqrt(square) : unit == LX_UNIT_MM ? 200.0 : unit == LX_UNIT_DEGREES ? 20.0 : 1.0;
}

static luxel_status refuse_type(const struct lx_place *place, const struct lx_parameter *parameter,
                                luxel_diagnostics *diagnostics)
{
    struct lx_text type = {0};
    if (parameter)
        lx_add_type(&type, parameter);
    else
        lx_text_puts(&type, "{…}");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, place, LX_MSG_DERIVE_NO_NUMBERS,
              LX_ARGS(place->text, LX_WORDS(type.bytes ? type.bytes : "")));
    lx_text_clear(&type);
    return LUXEL_ERROR_PATH;
}

/* Adds the value that a path leads to to the key's targets. */
static luxel_status find_target(const luxel_scene *scene, const char *text, luxel_diagnostics *diagnostics,
                                struct lx_key *key)
{
    const struct lx_place place = {.source = "key", .text = text, .length = strlen(text)};
    struct lx_target *target = &key->targets[key->target_count];
    struct lx_path path;
    char *value = NULL;
    luxel_status status = lx_follow_path(scene, &place, place.length, diagnostics, &path);
    if (status != LUXEL_OK)
        return status;
    const size_t count = numbers_at(&path);
    if (count == 0 || count > LX_MOST_NUMBERS)
        return refuse_type(&place, path.parameter, diagnostics);
    status = luxel_scene_get(scene, text, diagnostics, NULL, &value);
    if (status == LUXEL_OK && (!value || !read_numbers(value, count, target->numbers))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_DERIVE_NO_VALUE, LX_ARGS(text));
        status = LUXEL_ERROR_PATH;
    }
    luxel_text_free(value);
    if (status != LUXEL_OK)
        return status;
    key->count = count;
    key->is_list = count > 1 || (path.parameter->type == LX_REALS && path.depth == 0);
    key->is_length = path.parameter->unit == LX_UNIT_MM;
    key->legal = path.parameter->legal;
    key->unit = lx_unit_word(path.parameter->unit, lx_scene_parameters(scene)->units == LX_PHOTOMETRIC);
    target->scale = scale_of(target, count, path.parameter->unit);
    target->path = lx_copy_text(text, place.length);
    key->target_count++;
    return target->path ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

/* The values of all elements of a list that have one; what is wrong with the last is told where none has. */
static luxel_status find_each(const luxel_scene *scene, const char *text, const char *all,
                              luxel_diagnostics *diagnostics, struct lx_key *key)
{
    char *list = lx_copy_text(text, (size_t)(all - text));
    if (!list)
        return lx_out_of_memory(diagnostics);
    const struct lx_place place = {.source = "key", .text = list, .length = strlen(list)};
    struct lx_path path;
    size_t count = 0;
    luxel_status status = lx_follow_list(scene, &place, diagnostics, &path, &count);
    if (status == LUXEL_OK && count == 0) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_NO_ELEMENTS, LX_ARGS(list));
        status = LUXEL_ERROR_PATH;
    }
    free(list);
    if (status == LUXEL_OK && !(key->targets = lx_new_array(count, sizeof *key->targets)))
        status = lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        char *one = lx_text_of_element(text, all, i);
        if (!one)
            return lx_out_of_memory(diagnostics);
        luxel_diagnostics *told = key->target_count == 0 && i + 1 == count ? diagnostics : NULL;
        status = find_target(scene, one, told, key);
        if (status == LUXEL_ERROR_PATH && !told)
            status = LUXEL_OK;
        free(one);
    }
    return status;
}

static luxel_status find_key(const luxel_scene *scene, const char *text, luxel_diagnostics *diagnostics,
                             struct lx_key *key)
{
    const char *all = strstr(text, "[*]");
    key->path = lx_copy_text(text, strlen(text));
    if (all && key->path)
        return find_each(scene, text, all, diagnostics, key);
    key->targets = lx_new_array(1, sizeof *key->targets);
    return key->path && key->targets ? find_target(scene, text, diagnostics, key) : lx_out_of_memory(diagnostics);
}

luxel_status lx_keys_find(const luxel_scene *scene, const char *const *paths, size_t count,
                          luxel_diagnostics *diagnostics, struct lx_keys *keys)
{
    luxel_status status = LUXEL_OK;
    *keys = (struct lx_keys){.list = lx_new_array(count + 1, sizeof *keys->list), .count = count};
    if (!keys->list)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < count; i++) {
        const luxel_status one = find_key(scene, paths[i], diagnostics, &keys->list[i]);
        if (one != LUXEL_OK && one != LUXEL_ERROR_PATH)
            return one;
        if (one != LUXEL_OK)
            status = one;
        keys->list[i].offset = keys->number_count;
        keys->number_count += keys->list[i].count;
    }
    return status;
}

void lx_keys_clear(struct lx_keys *keys)
{
    for (size_t i = 0; keys->list && i < keys->count; i++) {
        for (size_t k = 0; keys->list[i].targets && k < keys->list[i].target_count; k++)
            free(keys->list[i].targets[k].path);
        free(keys->list[i].targets);
        free(keys->list[i].path);
    }
    free(keys->list);
    *keys = (struct lx_keys){.count = 0};
}

const struct lx_key *lx_keys_of(const struct lx_keys *keys, size_t number)
{
    const struct lx_key *key = keys->list;
    while (number >= key->offset + key->count)
        key++;
    return key;
}

static luxel_status set_target(luxel_scene *scene, const struct lx_key *key, const struct lx_target *target,
                               const double *numbers, luxel_diagnostics *diagnostics)
{
    struct lx_text text = {0};
    lx_text_printf(&text, "%s=%s", target->path, key->is_list ? "[" : "");
    for (size_t i = 0; i < key->count; i++) {
        char digits[LX_NUMBER_SIZE];
        lx_write_number(numbers[i], digits);
        lx_text_printf(&text, "%s%s", i > 0 ? ", " : "", digits);
    }
    lx_text_puts(&text, key->is_list ? "]" : "");
    const luxel_status status =
        text.failed ? lx_out_of_memory(diagnostics) : luxel_scene_set(scene, text.bytes, diagnostics);
    lx_text_clear(&text);
    return status;
}

/* Commits the scene, or frees it. */
static luxel_status end_change(luxel_scene *made, luxel_status status, luxel_diagnostics *diagnostics,
                               luxel_scene **changed)
{
    if (status == LUXEL_OK)
        status = luxel_scene_commit(made, diagnostics);
    if (status != LUXEL_OK) {
        luxel_scene_free(made);
        made = NULL;
    }
    *changed = made;
    return status;
}

luxel_status lx_key_shift(const luxel_scene *scene, const struct lx_key *key, size_t target, size_t i, double change,
                          luxel_diagnostics *diagnostics, luxel_scene **changed)
{
    double numbers[LX_MOST_NUMBERS];
    luxel_scene *made = luxel_scene_copy(scene);
    memcpy(numbers, key->targets[target].numbers, sizeof numbers);
    numbers[i] += change;
    return end_change(
        made, made ? set_target(made, key, &key->targets[target], numbers, diagnostics) : lx_out_of_memory(diagnostics),
        diagnostics, changed);
}

bool lx_keys_next(const struct lx_keys *keys, struct lx_each *each)
{
    if (each->key && ++each->target < each->key->targets + each->key->target_count)
        return true;
    each->key = each->key ? each->key + 1 : keys->list;
    while (each->key < keys->list + keys->count && each->key->target_count == 0)
        each->key++;
    each->target = each->key < keys->list + keys->count ? each->key->targets : NULL;
    return each->target;
}

luxel_status lx_keys_change(const luxel_scene *scene, const struct lx_keys *keys, const double *numbers,
                            luxel_diagnostics *diagnostics, luxel_scene **changed)
{
    luxel_scene *made = luxel_scene_copy(scene);
    luxel_status status = made ? LUXEL_OK : lx_out_of_memory(diagnostics);
    for (struct lx_each each = {.key = NULL}; status == LUXEL_OK && lx_keys_next(keys, &each);) {
        const double *wanted = &numbers[each.key->offset];
        bool is_same = true;
        for (size_t k = 0; k < each.key->count; k++)
            is_same = is_same && wanted[k] == each.target->numbers[k];
        if (!is_same)
            status = set_target(made, each.key, each.target, wanted, diagnostics);
    }
    return end_change(made, status, diagnostics, changed);
}

/* Binds a value in a scene that writes it. */
static bool bind(struct lx_changer *changer, const struct lx_target *target)
{
    const struct lx_place place = {.source = "key", .text = target->path, .length = strlen(target->path)};
    struct lx_path path;
    return lx_follow_path(changer->own, &place, place.length, NULL, &path) == LUXEL_OK &&
           lx_bind(changer->own, &path, &changer->bindings[changer->binding_count++]);
}

luxel_status lx_changer_make(const luxel_scene *scene, const struct lx_keys *keys, luxel_diagnostics *diagnostics,
                             struct lx_changer *changer)
{
    luxel_status status = LUXEL_OK;
    size_t count = 0;
    bool is_bound = true;
    *changer = (struct lx_changer){.scene = scene, .keys = keys};
    /* a solution of reflected light that a scene keeps knows nothing of bindings */
    if (lx_wants_reflections(lx_scene_parameters(scene)))
        return LUXEL_OK;
    for (struct lx_each each = {.key = NULL}; lx_keys_next(keys, &each);)
        count++;
    changer->own = luxel_scene_copy(scene);
    changer->bindings = lx_new_array(count + 1, sizeof *changer->bindings);
    if (!changer->own || !changer->bindings)
        return lx_out_of_memory(diagnostics);
    for (struct lx_each each = {.key = NULL}; status == LUXEL_OK && lx_keys_next(keys, &each);)
        status = set_target(changer->own, each.key, each.target, each.target->numbers, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(changer->own, diagnostics);
    for (struct lx_each each = {.key = NULL}; status == LUXEL_OK && is_bound && lx_keys_next(keys, &each);)
        is_bound = bind(changer, each.target);
    if (!is_bound) {
        free(changer->bindings);
        changer->bindings = NULL;
    }
    return status;
}

void lx_changer_clear(struct lx_changer *changer)
{
    luxel_scene_free(changer->own);
    free(changer->bindings);
    *changer = (struct lx_changer){.own = NULL};
}

const luxel_scene *lx_changer_change(struct lx_changer *changer, const double *numbers)
{
    size_t next = 0;
    if (!changer->bindings) {
        luxel_scene_free(changer->own);
        lx_keys_change(changer->scene, changer->keys, numbers, NULL, &changer->own);
        return changer->own;
    }
    for (struct lx_each each = {.key = NULL}; lx_keys_next(changer->keys, &each);)
        lx_bound_put(changer->own, &changer->bindings[next++], &numbers[each.key->offset]);
    return lx_bound_check(changer->own, changer->bindings, changer->binding_count) ? changer->own : NULL;
}
