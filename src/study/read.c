/* SPDX-License-Identifier: MIT */
/* Study files: read, decoded by their table, their base scene opened, changed and committed; and what they say. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/path.h"
#include "../base/source.h"
#include "../scene/guard.h"
#include "../scene/input.h"
#include "../scene/yaml.h"
#include "study.h"

/* ---- the base scene ---- */

/* A path that the study names, from its folder on. */
static char *path_of(const struct luxel_study *study, const char *name)
{
    struct lx_text text = {0};
    if (study->folder && !lx_path_is_absolute(name))
        lx_text_puts(&text, study->folder);
    lx_text_puts(&text, name);
    return lx_text_take(&text);
}

static bool is_builtin(const char *name)
{
    for (size_t i = 0; luxel_builtin_scene_name(i); i++)
        if (strcmp(luxel_builtin_scene_name(i), name) == 0)
            return true;
    return false;
}

static bool names_file(const char *name)
{
    return strpbrk(name, "/.") != NULL;
}

/* Opens the base scene; errors without a place of their own are told at the key `scene`. */
static luxel_status open_base(struct lx_walk *walk, struct luxel_study *study)
{
    const char *name = study->parameters.scene ? study->parameters.scene : "report";
    luxel_diagnostics *found = luxel_diagnostics_new();
    luxel_status status;
    if (is_builtin(name) || !names_file(name)) {
        status = luxel_scene_open_builtin(name, found, &study->plain);
    } else {
        char *path = path_of(study, name);
        status = path ? luxel_scene_read_file(path, found, &study->plain) : LUXEL_ERROR_MEMORY;
        free(path);
    }
    const struct lx_document *document = walk->document;
    lx_node_id id = lx_document_find(document, document->root, "scene");
    struct lx_place place = lx_document_place(document, id ? id : document->root);
    place.key = "scene";
    lx_hand_over(walk->diagnostics, found, NULL, &place);
    luxel_diagnostics_free(found);
    return status == LUXEL_ERROR_ARGUMENT ? LUXEL_ERROR_SCENE : status;
}

/* Applies one change of the base scene; what is wrong with it is told at its place in the study. */
static luxel_status change_base(struct lx_walk *walk, struct luxel_study *study, lx_node_id id)
{
    const struct lx_document *document = walk->document;
    luxel_diagnostics *found = luxel_diagnostics_new();
    luxel_status status = luxel_scene_set(study->plain, lx_document_text(document, id), found);
    struct lx_place place = lx_document_place(document, id);
    lx_hand_over(walk->diagnostics, found, "-s", &place);
    luxel_diagnostics_free(found);
    return status == LUXEL_ERROR_PATH ? LUXEL_ERROR_SCENE : status;
}

/* The base scene with the changes of `set`, committed; all errors are reported. */
static luxel_status make_base(struct lx_walk *walk, struct luxel_study *study)
{
    const struct lx_document *document = walk->document;
    luxel_status status = open_base(walk, study), worst = status;
    lx_node_id set = study->parameters.set;
    for (lx_node_id id = set && status == LUXEL_OK ? lx_document_node(document, set)->first : 0; id;
         id = lx_document_node(document, id)->next) {
        status = change_base(walk, study, id);
        worst = worst == LUXEL_OK ? status : worst;
        status = LUXEL_OK;
    }
    if (!study->plain || worst == LUXEL_ERROR_MEMORY)
        return worst;
    study->base = luxel_scene_copy(study->plain);
    if (!study->base)
        return lx_out_of_memory(walk->diagnostics);
    luxel_diagnostics *found = luxel_diagnostics_new();
    status = luxel_scene_commit(study->base, found);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(study->base, found);
    struct lx_place place = lx_document_place(document, set ? set : document->root);
    lx_hand_over(walk->diagnostics, found, "-s", &place);
    luxel_diagnostics_free(found);
    return worst == LUXEL_OK ? status : worst;
}

/* ---- the file ---- */

static luxel_status decode(struct luxel_study *study, luxel_diagnostics *diagnostics)
{
    struct lx_walk walk = {.document = &study->document, .diagnostics = diagnostics};
    struct lx_study_parameters *parameters = &study->parameters;
    luxel_status status = lx_decode(&walk, &lx_study_table, parameters);
    /* what is wrong elsewhere is told all the same, as far as it is known what it is about */
    if (status == LUXEL_ERROR_MEMORY || (status != LUXEL_OK && !lx_is_given(&lx_study_table, parameters, "scene")))
        return status;
    if (!lx_is_given(&lx_study_table, parameters, "outputs")) {
        parameters->outputs.given = 1 << LUXEL_STUDY_BRIGHTNESS;
        parameters->outputs.words[LUXEL_STUDY_BRIGHTNESS] = LUXEL_STUDY_FLOAT32 - LUXEL_STUDY_FLOAT16;
    }
    const luxel_status of_base = make_base(&walk, study);
    const bool is_varied = lx_is_given(&lx_study_table, parameters, "vary"); /* and each axis is good by itself */
    if (study->plain && of_base != LUXEL_ERROR_MEMORY && (is_varied || parameters->vary.count == 0))
        lx_axes_make(&walk, study);
    status = lx_walk_status(&walk);
    return status == LUXEL_OK ? of_base : status;
}

static luxel_status read_document(struct luxel_study *study, struct lx_source *source, luxel_diagnostics *diagnostics)
{
    struct lx_input input;
    struct lx_document *document = &study->document;
    uint32_t empty;
    luxel_status status = lx_read_input(source, &input);
    if (status != LUXEL_OK)
        return status;
    if (lx_document_add_source(document, lx_source_name(source), input.text, input.length) < 0 ||
        lx_document_add_text(document, "", 0, &empty) < 0)
        return lx_out_of_memory(diagnostics);
    status = lx_yaml_read(document, 0, 0, 0, diagnostics, &document->root);
    if (status == LUXEL_OK && (!document->root || lx_document_node(document, document->root)->kind != LX_MAPPING)) {
        struct lx_place place =
            document->root ? lx_document_place(document, document->root) : lx_document_stretch(document, 0, 0, 0);
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_STUDY_NO_MAPPING, NULL);
        status = LUXEL_ERROR_SCENE;
    }
    return status;
}

/* Reads a study from a source, and closes that. */
static luxel_status read_study(struct lx_source *source, const char *folder, luxel_diagnostics *diagnostics,
                               luxel_study **result)
{
    luxel_study *study = lx_new_array(1, sizeof *study);
    luxel_status status = study ? LUXEL_OK : lx_out_of_memory(diagnostics);
    if (study && folder && !(study->folder = lx_copy_text(folder, strlen(folder))))
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = read_document(study, source, diagnostics);
    if (status == LUXEL_OK)
        status = decode(study, diagnostics);
    lx_source_close(source);
    if (status == LUXEL_OK)
        *result = study;
    else
        luxel_study_free(study);
    return status;
}

luxel_status luxel_study_read_text(const char *text, size_t length, const char *source, luxel_diagnostics *diagnostics,
                                   luxel_study **study)
{
    if (!study || (!text && length))
        return LUXEL_ERROR_ARGUMENT;
    struct lx_source *bytes;
    luxel_status status = lx_source_of_bytes(source ? source : "<text>", text, length, diagnostics, &bytes);
    return status == LUXEL_OK ? read_study(bytes, NULL, diagnostics, study) : status;
}

luxel_status luxel_study_read_file(const char *path, luxel_diagnostics *diagnostics, luxel_study **study)
{
    if (!path || !study)
        return LUXEL_ERROR_ARGUMENT;
    struct lx_source *file;
    luxel_status status = lx_source_open(path, LX_LARGEST_TEXT, diagnostics, &file);
    if (status != LUXEL_OK)
        return status;
    const size_t length = (size_t)(lx_path_name(path) - path);
    char *folder = length > 0 ? lx_copy_text(path, length) : NULL;
    status = read_study(file, folder, diagnostics, study);
    free(folder);
    return status;
}

void luxel_study_free(luxel_study *study)
{
    if (!study)
        return;
    for (size_t i = 0; i < study->axis_count; i++)
        lx_axis_clear(&study->axes[i]);
    free(study->axes);
    luxel_scene_free(study->plain);
    luxel_scene_free(study->base);
    lx_parameters_clear(&lx_study_table, &study->parameters);
    lx_document_clear(&study->document);
    free(study->folder);
    free(study);
}

/* ---- asking ---- */

uint64_t luxel_study_count(const luxel_study *study)
{
    return study ? study->count : 0;
}

unsigned luxel_study_shard(const luxel_study *study)
{
    return study ? study->parameters.shard : 0;
}

const luxel_scene *luxel_study_base(const luxel_study *study)
{
    return study ? study->base : NULL;
}

unsigned luxel_study_seed(const luxel_study *study)
{
    return study ? study->parameters.seed : 0;
}

const char *luxel_study_text(const luxel_study *study)
{
    return study ? lx_document_place(&study->document, study->document.root).text : NULL;
}

luxel_study_type luxel_study_wanted(const luxel_study *study, luxel_study_output output)
{
    return study && (unsigned)output < LUXEL_STUDY_OUTPUTS ? lx_study_wanted(&study->parameters.outputs, output)
                                                           : LUXEL_STUDY_NONE;
}

static void add_numbers(struct lx_text *text, const double *numbers, size_t count)
{
    char number[LX_NUMBER_SIZE];
    for (size_t i = 0; i < count; i++) {
        lx_text_puts(text, " ");
        lx_text_puts(text, lx_write_number(numbers[i], number));
    }
}

static void identify_axis(struct lx_text *text, const struct lx_axis *axis)
{
    lx_text_printf(text, "vary %s %s %u %zu", axis->key, axis->is_random ? "random" : "grid", (unsigned)axis->random,
                   axis->count);
    if (axis->words) {
        for (size_t i = 0; i < axis->count; i++)
            lx_text_printf(text, "\n  %s", axis->words[i]);
    } else if (axis->is_random && axis->random == LX_ON_SPHERE) {
        add_numbers(text, axis->center, 3);
        add_numbers(text, &axis->radius, 1);
    } else {
        add_numbers(text, axis->from, axis->width);
        add_numbers(text, axis->to, axis->width);
    }
    lx_text_puts(text, "\n");
}

/* A sum of a file's bytes (FNV-1a), 0 where it cannot be read any more. */
static uint64_t sum_of_file(const char *path)
{
    unsigned char bytes[4096];
    struct lx_source *source = lx_source_try(path, SIZE_MAX);
    const uint64_t size = source && !lx_source_reason(source) ? lx_source_size(source) : 0;
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (uint64_t at = 0; at < size; at += sizeof bytes) {
        const size_t count = size - at < sizeof bytes ? (size_t)(size - at) : sizeof bytes;
        if (lx_source_read(source, at, bytes, count) != LUXEL_OK)
            break;
        for (size_t i = 0; i < count; i++)
            sum = (sum ^ bytes[i]) * UINT64_C(0x100000001b3);
    }
    lx_source_close(source);
    return size ? sum : 0;
}

char *luxel_study_identity(const luxel_study *study)
{
    struct lx_text text = {0};
    char *scene = NULL;
    if (!study || luxel_scene_write_text(study->base, &scene) != LUXEL_OK)
        return NULL;
    lx_text_printf(&text, "luxel study 1\ncount %llu\nseed %u\nshard %u\n", (unsigned long long)study->count,
                   study->parameters.seed, study->parameters.shard);
    for (size_t i = 0; i < study->axis_count; i++)
        identify_axis(&text, &study->axes[i]);
    for (luxel_study_output k = 0; k < LUXEL_STUDY_OUTPUTS; k++)
        if (luxel_study_wanted(study, k) != LUXEL_STUDY_NONE)
            lx_text_printf(&text, "output %s %s\n", luxel_study_output_name(k),
                           luxel_study_type_name(luxel_study_wanted(study, k)));
    for (size_t i = 0; i < study->base->kept.count; i++)
        lx_text_printf(&text, "file %016llx\n", (unsigned long long)sum_of_file(study->base->kept.items[i].path));
    lx_text_puts(&text, scene);
    luxel_text_free(scene);
    return lx_text_take(&text);
}
