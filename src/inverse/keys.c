/* SPDX-License-Identifier: MIT */
/* Free keys of a scene, read by its parameter tables and written as -s writes them. */
#include "keys.h"

#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/text.h"
#include "../parameter/words.h"
#include "../scene/path.h"

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

/* Reads the numbers of a value such as "10" or "[0, 0, 1000]". */
static bool read_numbers(const char *text, struct lx_key *key)
{
    static const char between[] = "[], ";
    size_t read = 0;
    for (text += strspn(text, between); *text && read < key->count; read++) {
        const size_t length = strcspn(text, between);
        if (!lx_read_number(text, length, &key->numbers[read]))
            return false;
        text += length;
        text += strspn(text, between);
    }
    return read == key->count && !*text;
}

/* What the key says; of zeros so much as is common in scenes. */
static double scale_of(const struct lx_key *key, enum lx_unit unit)
{
    double square = 0.0;
    for (size_t i = 0; i < key->count; i++)
        square += key->numbers[i] * key->numbers[i];
    return square > 0.0 ? sqrt(square) : unit == LX_UNIT_MM ? 200.0 : unit == LX_UNIT_DEGREES ? 20.0 : 1.0;
}

static luxel_status find_key(const luxel_scene *scene, const char *text, luxel_diagnostics *diagnostics,
                             struct lx_key *key)
{
    const struct lx_place place = {.source = "key", .text = text, .length = strlen(text)};
    struct lx_path path;
    char *value = NULL;
    luxel_status status = lx_follow_path(scene, &place, place.length, diagnostics, &path);
    if (status != LUXEL_OK)
        return status;
    key->path = lx_copy_text(text, place.length);
    if (!key->path)
        return lx_out_of_memory(diagnostics);
    key->count = numbers_at(&path);
    if (key->count == 0 || key->count > LX_MOST_NUMBERS) {
        struct lx_text type = {0};
        if (path.parameter)
            lx_add_type(&type, path.parameter);
        else
            lx_text_puts(&type, "{…}");
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_DERIVE_NO_NUMBERS,
                  LX_ARGS(text, LX_WORDS(type.bytes ? type.bytes : "")));
        lx_text_clear(&type);
        return LUXEL_ERROR_PATH;
    }
    key->is_list = key->count > 1 || (path.parameter->type == LX_REALS && path.depth == 0);
    key->is_length = path.parameter->unit == LX_UNIT_MM;
    key->legal = path.parameter->legal;
    key->unit = lx_unit_word(path.parameter->unit, lx_scene_parameters(scene)->units == LX_PHOTOMETRIC);
    status = luxel_scene_get(scene, text, diagnostics, NULL, &value);
    if (status == LUXEL_OK && (!value || !read_numbers(value, key))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_DERIVE_NO_VALUE, LX_ARGS(text));
        status = LUXEL_ERROR_PATH;
    }
    luxel_text_free(value);
    key->scale = scale_of(key, path.parameter->unit);
    return status;
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
    for (size_t i = 0; keys->list && i < keys->count; i++)
        free(keys->list[i].path);
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

static luxel_status set_key(luxel_scene *scene, const struct lx_key *key, const double *numbers,
                            luxel_diagnostics *diagnostics)
{
    struct lx_text text = {0};
    lx_text_printf(&text, "%s=%s", key->path, key->is_list ? "[" : "");
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

luxel_status lx_keys_change(const luxel_scene *scene, const struct lx_keys *keys, const double *numbers,
                            luxel_diagnostics *diagnostics, luxel_scene **changed)
{
    luxel_scene *made = luxel_scene_copy(scene);
    luxel_status status = made ? LUXEL_OK : lx_out_of_memory(diagnostics);
    for (size_t i = 0; status == LUXEL_OK && i < keys->count; i++) {
        const struct lx_key *key = &keys->list[i];
        bool is_same = true;
        for (size_t k = 0; k < key->count; k++)
            is_same = is_same && numbers[key->offset + k] == key->numbers[k];
        if (!is_same)
            status = set_key(made, key, &numbers[key->offset], diagnostics);
    }
    if (status == LUXEL_OK)
        status = luxel_scene_commit(made, diagnostics);
    if (status != LUXEL_OK) {
        luxel_scene_free(made);
        made = NULL;
    }
    *changed = made;
    return status;
}
