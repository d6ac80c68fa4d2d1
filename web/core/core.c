/* SPDX-License-Identifier: MIT */
/* Scenes: opening and judging their text, changing it, and what is reported. */
#include "core.h"

#include <stdlib.h>
#include <string.h>

#include "answer.h"

struct core core;

/* The text that is being changed; it need not be whole. */
static luxel_scene *edited;
static char *edited_text;

PAGE_CALLS(page_memory) void *page_memory(size_t count)
{
    return malloc(count);
}

PAGE_CALLS(page_free) void page_free(void *memory)
{
    free(memory);
}

luxel_diagnostics *fresh_diagnostics(void)
{
    if (!core.diagnostics)
        core.diagnostics = luxel_diagnostics_new();
    else
        luxel_diagnostics_clear(core.diagnostics);
    return core.diagnostics;
}

/* The page hears of it while the core is busy, and ends its worker if it wants no more. */
void page_progress(double done);

static bool tell_progress(double done, void *data)
{
    (void)data;
    page_progress(done);
    return true;
}

luxel_settings present_settings(void)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = core.quantity;
    settings.progress = tell_progress;
    settings.share_reflected = !core.is_package;
    settings.tolerance = core.tolerance;
    settings.light_error = core.light_error;
    settings.reflected_error = core.reflected_error;
    settings.within = core.within;
    return settings;
}

static luxel_scene *without_reflections(const luxel_scene *scene)
{
    luxel_scene *copy = luxel_scene_copy(scene);
    if (copy && luxel_scene_set(copy, "reflections=none", NULL) == LUXEL_OK &&
        luxel_scene_commit(copy, NULL) == LUXEL_OK)
        return copy;
    luxel_scene_free(copy);
    return NULL;
}

const luxel_scene *computed_scene(void)
{
    if (!core.is_direct || !core.scene)
        return core.scene;
    if (!core.direct)
        core.direct = without_reflections(core.scene);
    return core.direct;
}

const luxel_evaluator *present_evaluator(void)
{
    const luxel_settings settings = present_settings();
    const luxel_scene *scene = computed_scene();
    if (!core.evaluator && scene)
        (void)luxel_evaluator_new(scene, &settings, fresh_diagnostics(), &core.evaluator);
    return core.evaluator;
}

void drop_evaluator(void)
{
    luxel_evaluator_free(core.evaluator);
    luxel_evaluator_free(core.lit);
    core.evaluator = core.lit = NULL;
    drop_stage();
}

/* Judges a text, and takes its scene in place of the present one if it is whole.  Returns a luxel_status. */
PAGE_CALLS(page_open) int page_open(const char *text, size_t length, const char *name)
{
    luxel_diagnostics *diagnostics = fresh_diagnostics();
    luxel_scene *scene = NULL;
    luxel_status status = luxel_scene_read_text(text, length, name, diagnostics, &scene);
    if (status == LUXEL_OK && core.scene)
        status = luxel_scene_keep_files(scene, core.scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics); /* the page shows pictures */
    if (status != LUXEL_OK) {
        luxel_scene_free(scene);
        return (int)status;
    }
    (void)luxel_scene_advise(scene, diagnostics);
    drop_evaluator();
    luxel_scene_free(core.direct);
    luxel_scene_free(core.scene);
    core.direct = NULL;
    core.scene = scene;
    return LUXEL_OK;
}

/* Whether only direct light is computed from now on. */
PAGE_CALLS(page_direct) void page_direct(int direct)
{
    if ((direct != 0) != core.is_direct)
        drop_evaluator();
    core.is_direct = direct != 0;
}

/* In how many seconds reflected light is solved for from now on, as well as goes; 0: as exactly as it should be. */
PAGE_CALLS(page_within) void page_within(double seconds)
{
    if (seconds != core.within)
        drop_evaluator();
    core.within = seconds;
}

PAGE_CALLS(page_quantity) void page_quantity(int irradiance)
{
    const luxel_quantity quantity = irradiance ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
    if (quantity != core.quantity)
        drop_evaluator();
    core.quantity = quantity;
}

static void answer_diagnostic(size_t i)
{
    const luxel_diagnostic *entry = luxel_diagnostics_get(core.diagnostics, i);
    char *message = luxel_diagnostics_message(core.diagnostics, i, page_translate, NULL);
    char *hint = luxel_diagnostics_hint(core.diagnostics, i, page_translate, NULL);
    answer_open('{');
    answer_key("error");
    answer_bool(entry->severity == LUXEL_SEVERITY_ERROR);
    answer_key("line");
    answer_number(entry->line);
    answer_key("column");
    answer_number(entry->column);
    answer_key("length");
    answer_number(entry->mark_length);
    answer_key("key");
    answer_string(entry->key);
    answer_key("message");
    answer_string(message);
    answer_key("hint");
    answer_string(hint);
    answer_close('}');
    luxel_text_free(message);
    luxel_text_free(hint);
}

PAGE_CALLS(page_messages) const char *page_messages(void)
{
    answer_begin();
    answer_open('[');
    for (size_t i = 0; core.diagnostics && i < luxel_diagnostics_count(core.diagnostics); i++)
        answer_diagnostic(i);
    answer_close(']');
    return answer_text();
}

/* A text is changed by beginning with it, changing it, and taking the new one.  All return a luxel_status. */
PAGE_CALLS(page_edit) int page_edit(const char *text, size_t length)
{
    luxel_scene_free(edited);
    edited = NULL;
    return (int)luxel_scene_read_text(text, length, NULL, fresh_diagnostics(), &edited);
}

PAGE_CALLS(page_set) int page_set(const char *assignment)
{
    return edited ? (int)luxel_scene_set(edited, assignment, core.diagnostics) : LUXEL_ERROR_ARGUMENT;
}

PAGE_CALLS(page_insert) int page_insert(const char *list, size_t index, const char *value)
{
    return edited ? (int)luxel_scene_insert(edited, list, index, value, core.diagnostics) : LUXEL_ERROR_ARGUMENT;
}

PAGE_CALLS(page_remove) int page_remove(const char *key)
{
    return edited ? (int)luxel_scene_remove(edited, key, core.diagnostics) : LUXEL_ERROR_ARGUMENT;
}

/* A light that fits the text that is being changed, by luxel_new_light(), and its place at the list's end. */
PAGE_CALLS(page_new_light) const char *page_new_light(const char *wanted, size_t like, int replaces)
{
    size_t count = 0;
    char *light = NULL;
    answer_begin();
    if (edited && luxel_scene_list_size(edited, "lights", fresh_diagnostics(), &count) == LUXEL_OK &&
        luxel_new_light(edited, wanted, like, replaces != 0, core.diagnostics, &light) == LUXEL_OK) {
        answer_open('{');
        answer_key("index");
        answer_number((double)count);
        answer_key("light");
        answer_string(light);
        answer_close('}');
    }
    luxel_text_free(light);
    return answer_text();
}

PAGE_CALLS(page_edited) const char *page_edited(void)
{
    luxel_text_free(edited_text);
    edited_text = NULL;
    return edited && luxel_scene_write_text(edited, &edited_text) == LUXEL_OK ? edited_text : NULL;
}

/* The value of a key of the present scene as YAML, or NULL where it has none. */
PAGE_CALLS(page_get) const char *page_get(const char *key)
{
    static char *value;
    luxel_text_free(value);
    value = NULL;
    if (core.scene)
        (void)luxel_scene_get(core.scene, key, NULL, NULL, &value);
    return value;
}
