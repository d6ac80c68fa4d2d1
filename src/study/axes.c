/* SPDX-License-Identifier: MIT */
/*
 * From what a study file says to axes: each key is followed through the base scene, and every value is decoded by the
 * parameter of the key, so that what is wrong is told as in a scene, at its place in the study.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../scene/bind.h"
#include "../scene/tidy.h"
#include "study.h"

/* One element of `vary` on the way to its axis. */
struct making {
    struct lx_walk *walk;
    const struct luxel_study *study;
    const struct lx_vary *vary;
    lx_node_id mapping;
    struct lx_step step; /* vary[i] */
    struct lx_axis *axis;
};

static void report(const struct making *making, const char *key, enum lx_message message, const char *first,
                   const char *second)
{
    const struct lx_document *document = making->walk->document;
    struct lx_step step = {&making->step, key, 0};
    lx_walk_report(making->walk, LUXEL_SEVERITY_ERROR,
                   lx_document_place(document, lx_document_find(document, making->mapping, key)), &step, message, first,
                   second);
}

/* How many numbers a value of a type is; 0: it is none. */
static unsigned width_of(const struct lx_parameter *parameter)
{
    switch (parameter->type) {
    case LX_REAL:
    case LX_WHOLE: return 1;
    case LX_REALS:
    case LX_WHOLES: return parameter->count <= LX_MOST_WIDTH ? parameter->count : 0;
    default: return 0;
    }
}

/* Follows a key, one of all elements of a list (lights[*].factor) by the first that has it; the last one's errors are
 * told. */
static luxel_status follow(const luxel_scene *scene, const char *key, luxel_diagnostics *found, struct lx_path *path)
{
    const char *all = strstr(key, "[*]");
    struct lx_place place = {.source = "-s", .text = key, .length = strlen(key)};
    luxel_status status = LUXEL_ERROR_PATH;
    size_t count = 0;
    if (!all)
        return lx_follow_path(scene, &place, place.length, found, path);
    char *list = lx_copy_text(key, (size_t)(all - key));
    if (!list)
        return LUXEL_ERROR_MEMORY;
    place = (struct lx_place){.source = "-s", .text = list, .length = strlen(list)};
    status = lx_follow_list(scene, &place, found, path, &count);
    free(list);
    if (status != LUXEL_OK)
        return status;
    status = LUXEL_ERROR_PATH;
    for (size_t i = 0; (i < count || i == 0) && status == LUXEL_ERROR_PATH; i++) {
        char *one = lx_text_of_element(key, all, i);
        if (!one)
            return LUXEL_ERROR_MEMORY;
        place = (struct lx_place){.source = "-s", .text = one, .length = strlen(one)};
        status = lx_follow_path(scene, &place, place.length, i + 1 >= count ? found : NULL, path);
        free(one);
    }
    return status;
}

/* Follows the key; what is wrong with it is told at the study's place. */
static bool follow_key(struct making *making)
{
    const char *key = making->vary->key;
    struct lx_axis *axis = making->axis;
    const struct lx_document *document = making->walk->document;
    struct lx_place place = lx_document_place(document, lx_document_find(document, making->mapping, "key"));
    luxel_diagnostics *found = luxel_diagnostics_new();
    struct lx_path path;
    bool good = follow(making->study->plain, key, found, &path) == LUXEL_OK;
    lx_hand_over(making->walk->diagnostics, found, "-s", &place);
    luxel_diagnostics_free(found);
    if (!good) {
        making->walk->failed = true;
        making->walk->errors++;
        return false;
    }
    if (path.parameter) {
        axis->parameter = *path.parameter;
        axis->has_parameter = !lx_has_tables(path.parameter) || path.parameter->type == LX_GROUP;
        if (path.depth > 0 && width_of(path.parameter) > 0) {
            axis->parameter.type = path.parameter->type == LX_REALS ? LX_REAL : LX_WHOLE;
            axis->parameter.nonzero = false;
        } else if (path.depth > 0) {
            axis->has_parameter = false;
        }
    }
    if (path.parameter && strcmp(path.segments[0].key, "screen") == 0 &&
        (path.count == 1 || strcmp(path.segments[1].key, "resolution") == 0)) {
        report(making, "key", LX_MSG_STUDY_SIZE, key, NULL);
        return false;
    }
    axis->width = axis->has_parameter ? width_of(&axis->parameter) : 0;
    axis->size = axis->has_parameter ? lx_bound_size(&axis->parameter) : 0;
    return true;
}

/* The numbers of a decoded value. */
static void numbers_of(const struct lx_axis *axis, const void *value, double *numbers)
{
    bool is_whole = axis->parameter.type == LX_WHOLE || axis->parameter.type == LX_WHOLES;
    for (unsigned i = 0; i < axis->width; i++)
        numbers[i] = is_whole ? ((const unsigned *)value)[i] : ((const double *)value)[i];
}

/* Decodes one value of a node by the parameter of the key. */
static bool decode(const struct making *making, const struct lx_step *step, lx_node_id id, void *value)
{
    union {
        double reals[LX_MOST_WIDTH];
        void *pointers[4];
    } other = {{0}};
    const struct lx_parameter *parameter = &making->axis->parameter;
    const bool photometric = making->walk->photometric;
    const struct lx_scene_parameters *base = lx_scene_parameters(making->study->base);
    making->walk->photometric = base && base->units == LX_PHOTOMETRIC;
    bool good = lx_decode_value(making->walk, step, parameter, id, value ? value : (void *)&other);
    making->walk->photometric = photometric;
    if (!value && (parameter->type == LX_POINTS || parameter->type == LX_VECTORS))
        free(other.pointers[0]);
    return good;
}

/* Listed values: each by its parameter, where it has one of that kind, and as the text of an assignment. */
static void take_values(struct making *making)
{
    const struct lx_document *document = making->walk->document;
    struct lx_axis *axis = making->axis;
    struct lx_step values = {&making->step, "values", 0};
    axis->count = lx_document_size(document, making->vary->values);
    axis->words = lx_new_array(axis->count, sizeof *axis->words);
    axis->bytes = lx_new_array(axis->count, axis->size ? axis->size : 1);
    axis->numbers = lx_new_array(axis->count, (axis->width ? axis->width : 1) * sizeof *axis->numbers);
    if (!axis->words || !axis->bytes || !axis->numbers) {
        making->walk->out_of_memory = true;
        return;
    }
    size_t i = 0;
    for (lx_node_id id = lx_document_node(document, making->vary->values)->first; id;
         id = lx_document_node(document, id)->next, i++) {
        struct lx_step step = {&values, NULL, i};
        void *value = axis->size ? (char *)axis->bytes + i * axis->size : NULL;
        bool is_group = axis->has_parameter && axis->parameter.type == LX_GROUP;
        if (axis->has_parameter && !is_group && !decode(making, &step, id, value))
            continue;
        if (axis->width)
            numbers_of(axis, value, axis->numbers + i * axis->width);
        struct lx_text words = {0};
        lx_write_flow(&words, document, id, false);
        axis->words[i] = lx_text_take(&words);
        making->walk->out_of_memory = making->walk->out_of_memory || !axis->words[i];
    }
}

/* An end of a range: numbers as the key takes them. */
static void take_end(struct making *making, const char *key, lx_node_id id, double *numbers)
{
    struct lx_step step = {&making->step, key, 0};
    double value[LX_MOST_WIDTH] = {0};
    const struct lx_axis *axis = making->axis;
    if (axis->width == 0) {
        report(making, key, LX_MSG_STUDY_NO_NUMBERS, axis->key, NULL);
        return;
    }
    if (!decode(making, &step, id, value))
        return;
    numbers_of(axis, value, numbers);
    for (unsigned i = 0; i < axis->width; i++)
        if (axis->is_random && axis->random == LX_LOGARITHMIC && !(numbers[i] > 0)) {
            report(making, key, LX_MSG_STUDY_LOG, NULL, NULL);
            return;
        }
}

static void take_sphere(struct making *making)
{
    struct lx_axis *axis = making->axis;
    memcpy(axis->center, making->vary->center, sizeof axis->center);
    axis->radius = making->vary->radius;
    if (axis->width == 3 && axis->parameter.type == LX_REALS)
        return;
    struct lx_text type = {0};
    if (axis->has_parameter)
        lx_add_type(&type, &axis->parameter);
    char *words = lx_text_take(&type);
    struct lx_step step = {&making->step, "random", 0};
    const struct lx_document *document = making->walk->document;
    lx_walk_tell(making->walk, LUXEL_SEVERITY_ERROR,
                 lx_document_place(document, lx_document_find(document, making->mapping, "random")), &step,
                 LX_MSG_STUDY_SPHERE, LX_ARGS(axis->key, LX_WORDS(words ? words : "")));
    free(words);
}

/* Whether one key is another one or a part of it; [0] and .0 are alike. */
static bool is_within(const char *part, const char *whole)
{
    for (; *whole; part++, whole++) {
        if (*whole == ']' && *part != ']')
            part--;
        else if (*part == ']' && *whole != ']')
            whole--;
        else if (*part != *whole && !(*part == '.' && *whole == '[') && !(*part == '[' && *whole == '.'))
            return false;
    }
    return !*part || *part == '.' || *part == '[' || *part == ']';
}

static void make_axis(struct making *making, size_t i)
{
    const struct lx_vary *vary = making->vary;
    struct lx_axis *axis = making->axis;
    axis->is_random = lx_is_given(lx_find_parameter(&lx_study_table, "vary")->group, vary, "random");
    axis->random = (enum lx_random)vary->random;
    axis->key = lx_copy_text(vary->key, strlen(vary->key));
    axis->column = making->study->width;
    if (!axis->key) {
        making->walk->out_of_memory = true;
        return;
    }
    for (size_t k = 0; k < i; k++) {
        const char *other = making->study->axes[k].key;
        if (other && (is_within(axis->key, other) || is_within(other, axis->key))) {
            report(making, "key", LX_MSG_STUDY_OVERLAP, other, NULL);
            return;
        }
    }
    if (!follow_key(making))
        return;
    if (vary->values) {
        take_values(making);
    } else if (axis->is_random && axis->random == LX_ON_SPHERE) {
        take_sphere(making);
    } else {
        take_end(making, "from", vary->from, axis->from);
        take_end(making, "to", vary->to, axis->to);
        axis->count = axis->is_random ? 0 : vary->steps;
    }
}

/* Counts the scenes: the product of the grid's axes, times the draws. */
static void count_scenes(struct lx_walk *walk, struct luxel_study *study)
{
    const uint64_t most = UINT64_C(1) << 53;
    const struct lx_study_parameters *parameters = &study->parameters;
    const bool given = lx_is_given(&lx_study_table, parameters, "count");
    uint64_t grid = 1;
    bool any_random = false, too_many = false;
    for (size_t i = study->axis_count; i-- > 0;) {
        struct lx_axis *axis = &study->axes[i];
        any_random = any_random || axis->is_random;
        axis->stride = grid;
        if (!axis->is_random)
            too_many = __builtin_mul_overflow(grid, axis->count ? axis->count : 1, &grid) || grid > most || too_many;
    }
    study->count = grid;
    if (any_random)
        too_many = __builtin_mul_overflow(grid, given ? parameters->count : 1, &study->count) || too_many;
    too_many = too_many || study->count > most;
    struct lx_step step = {NULL, "count", 0};
    const struct lx_document *document = walk->document;
    lx_node_id id = lx_document_find(document, document->root, "count");
    struct lx_place place = lx_document_place(document, id ? id : document->root);
    char number[LX_NUMBER_SIZE];
    if (too_many)
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_STUDY_TOO_LARGE, NULL, NULL);
    else if (any_random && !given)
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_STUDY_COUNT, NULL, NULL);
    else if (!any_random && given && parameters->count != grid)
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_STUDY_NO_COUNT,
                       lx_write_number((double)grid, number), NULL);
}

void lx_axes_make(struct lx_walk *walk, struct luxel_study *study)
{
    const struct lx_groups *groups = &study->parameters.vary;
    const struct lx_document *document = walk->document;
    study->axes = lx_new_array(groups->count, sizeof *study->axes);
    if (!study->axes) {
        walk->out_of_memory = true;
        return;
    }
    study->axis_count = groups->count;
    struct lx_step vary = {NULL, "vary", 0};
    lx_node_id id = lx_document_find(document, document->root, "vary");
    id = id ? lx_document_node(document, id)->first : 0;
    for (size_t i = 0; i < groups->count && !walk->out_of_memory; i++, id = lx_document_node(document, id)->next) {
        struct making making = {walk,           study, (const struct lx_vary *)groups->items + i, id, {&vary, NULL, i},
                                &study->axes[i]};
        make_axis(&making, i);
        study->width += study->axes[i].width ? study->axes[i].width : 1;
    }
    if (!walk->failed && !walk->out_of_memory)
        count_scenes(walk, study);
}

void lx_axis_clear(struct lx_axis *axis)
{
    for (size_t i = 0; axis->words && i < axis->count; i++)
        free(axis->words[i]);
    free(axis->words);
    free(axis->numbers);
    free(axis->bytes);
    free(axis->key);
}
