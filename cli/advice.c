/* SPDX-License-Identifier: MIT */
/* Gathers advice and lists it as JSON. */
#include "advice.h"

#include "cli.h"
#include "json.h"
#include "message.h"

int advice_check_view(const struct loaded *loaded)
{
    const luxel_status status = luxel_scene_surface_count(loaded->scene) > 0
                                    ? luxel_scene_check_view(loaded->scene, loaded->diagnostics)
                                    : LUXEL_OK;

    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

int advice_gather(const struct options *options, const struct loaded *loaded)
{
    luxel_status status = LUXEL_OK;

    if (!options->strict) /* else it is there already */
        status = luxel_scene_advise(loaded->scene, loaded->diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_advise_peak(loaded->scene, loaded->diagnostics);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

static void write_place(struct json *json, const char *key, unsigned number)
{
    if (number > 0)
        json_whole(json, key, number);
    else
        json_null(json, key);
}

static void write_entry(struct json *json, const luxel_diagnostics *diagnostics, size_t i)
{
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
    char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
    char *hint = luxel_diagnostics_hint(diagnostics, i, NULL, NULL);
    char *source = entry->source ? luxel_escaped_text(entry->source) : NULL; /* a file's name may be no UTF-8 */

    json_open(json, NULL, '{');
    json_text(json, "id", entry->id);
    json_text(json, "message", message);
    json_text(json, "hint", hint && *hint ? hint : NULL);
    json_text(json, "source", source);
    write_place(json, "line", entry->line);
    write_place(json, "column", entry->column);
    json_text(json, "key", entry->key);
    json_close(json, '}');
    luxel_text_free(message);
    luxel_text_free(hint);
    luxel_text_free(source);
}

static void write_entries(struct json *json, const luxel_diagnostics *diagnostics, luxel_severity severity)
{
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++)
        if (luxel_diagnostics_get(diagnostics, i)->severity == severity)
            write_entry(json, diagnostics, i);
}

void advice_print_json(const struct loaded *loaded, bool valid, bool strict, const struct meshes *meshes)
{
    const luxel_diagnostics *diagnostics = loaded->diagnostics;
    const bool as_errors = strict && !valid;
    struct json json = {.stream = stdout};
    size_t errors = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR);
    size_t advice = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ADVICE);

    if (as_errors) {
        errors += advice;
        advice = 0;
    }
    json_open(&json, NULL, '{');
    json_bool(&json, "valid", valid);
    json_open(&json, "errors", '[');
    write_entries(&json, diagnostics, LUXEL_SEVERITY_ERROR);
    if (as_errors)
        write_entries(&json, diagnostics, LUXEL_SEVERITY_ADVICE);
    json_close(&json, ']');
    json_open(&json, "advice", '[');
    if (!as_errors)
        write_entries(&json, diagnostics, LUXEL_SEVERITY_ADVICE);
    json_close(&json, ']');
    json_whole(&json, "error_count", errors);
    json_whole(&json, "advice_count", advice);
    if (meshes)
        meshes_write(&json, meshes);
    json_close(&json, '}');
}
