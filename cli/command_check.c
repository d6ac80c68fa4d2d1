/* SPDX-License-Identifier: MIT */
/* luxel check: is the scene valid, and what would an experienced user look at again? */
#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"

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

/* With --strict advice is listed among the errors. */
static void print_json(const luxel_diagnostics *diagnostics, bool valid, bool strict)
{
    struct json json = {.stream = stdout};
    size_t errors = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR);
    size_t advice = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ADVICE);

    if (strict) {
        errors += advice;
        advice = 0;
    }
    json_open(&json, NULL, '{');
    json_bool(&json, "valid", valid);
    json_open(&json, "errors", '[');
    write_entries(&json, diagnostics, LUXEL_SEVERITY_ERROR);
    if (strict)
        write_entries(&json, diagnostics, LUXEL_SEVERITY_ADVICE);
    json_close(&json, ']');
    json_open(&json, "advice", '[');
    if (!strict)
        write_entries(&json, diagnostics, LUXEL_SEVERITY_ADVICE);
    json_close(&json, ']');
    json_whole(&json, "error_count", errors);
    json_whole(&json, "advice_count", advice);
    json_close(&json, '}');
}

static void print_text(const struct loaded *loaded, bool quiet)
{
    if (!quiet) {
        text_print_escaped(stdout, loaded->name);
        fputs(_(": valid\n"), stdout);
    }
    message_diagnostics(stdout, loaded->diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
}

/* A scene that could not be read at all has no result. */
static int report(const struct options *options, const struct loaded *loaded, int code)
{
    if (code == EXIT_DONE && !options->strict) {
        const luxel_status status = luxel_scene_advise(loaded->scene, loaded->diagnostics);

        if (status != LUXEL_OK)
            return message_failure(status, loaded->diagnostics);
    }
    if (options->json && code != EXIT_FILE)
        print_json(loaded->diagnostics, code == EXIT_DONE, options->strict);
    else if (code == EXIT_DONE)
        print_text(loaded, options->quiet);
    return code;
}

static int run(const struct options *options)
{
    struct loaded loaded;
    int code = load_scene(options, false, &loaded);

    code = report(options, &loaded, code);
    load_clear(&loaded);
    return code;
}

const struct command command_check = {
    .name = "check",
    .bit = COMMAND_CHECK,
    .operand = N_("SCENE"),
    .summary = N_("validate a scene and list advice about it"),
    .description = N_("Reports every error with its place. For a valid scene it lists what lies outside the advised "
                      "ranges, has no effect or is out of view; with --strict that makes the scene fail."),
    .examples = "luxel check my.yaml\n"
                "luxel check my.yaml --strict --json",
    .run = run,
};
