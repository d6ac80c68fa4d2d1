/* SPDX-License-Identifier: MIT */
/* luxel variant: a numbered variant of the exercise, as a scene file. */
#include <string.h>

#include <luxel/luxel.h>

#include "argument.h"
#include "cli.h"
#include "json.h"
#include "message.h"
#include "options.h"
#include "outputs.h"

static luxel_status check_name(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".yaml", ".yml"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}

static int write_files(const struct options *options, const char *text, luxel_diagnostics *diagnostics)
{
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status = luxel_text_write(options->outputs[i], text, strlen(text), diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
    }
    return code;
}

static void print_json(unsigned number, const char *text)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_whole(&json, "variant", number);
    json_text(&json, "text", text);
    json_close(&json, '}');
}

/* With --strict advice is an error, as everywhere. */
static bool has_advice(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    luxel_scene_advise(scene, diagnostics);
    message_diagnostics(stderr, diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ERROR);
    return luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ADVICE) > 0;
}

/* The text with the changes of -s, which must go; NULL where they do not, which is reported. */
static char *change(const struct options *options, const char *text, luxel_diagnostics *diagnostics, int *code)
{
    luxel_scene *scene = NULL;
    char *changed = NULL;
    luxel_status status = luxel_scene_read_text(text, strlen(text), "variant", diagnostics, &scene);

    for (size_t i = 0; status == LUXEL_OK && i < options->assignment_count; i++)
        status = luxel_scene_set(scene, options->assignments[i], diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    *code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
    if (*code == EXIT_DONE && options->strict && has_advice(scene, diagnostics))
        *code = EXIT_SCENE;
    if (*code == EXIT_DONE && luxel_scene_write_text(scene, &changed) != LUXEL_OK)
        *code = message_failure(LUXEL_ERROR_MEMORY, diagnostics);
    luxel_scene_free(scene);
    return changed;
}

static int print(const struct options *options, unsigned number, const char *text, luxel_diagnostics *diagnostics)
{
    const int code = write_files(options, text, diagnostics);

    if (options->json)
        print_json(number, text);
    else if (options->output_count == 0)
        fputs(text, stdout);
    return code;
}

static int run(const struct options *options)
{
    luxel_diagnostics *diagnostics;
    char *text = NULL, *changed;
    luxel_status status;
    unsigned number;
    int code;

    if (!options->operand) {
        message_error(_("luxel variant needs a number from 1 to %u"), LUXEL_LAST_VARIANT);
        return EXIT_USAGE;
    }
    if (!argument_whole("N", options->operand, 1, LUXEL_LAST_VARIANT, &number))
        return EXIT_USAGE;
    code = outputs_check(options, check_name);
    if (code != EXIT_DONE)
        return code;
    diagnostics = message_new_diagnostics();
    status = luxel_variant_text(number, diagnostics, &text);
    code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
    if (code == EXIT_DONE && options->assignment_count > 0) {
        changed = change(options, text, diagnostics, &code);
        luxel_text_free(text);
        text = changed;
    }
    if (code == EXIT_DONE)
        code = print(options, number, text, diagnostics);
    luxel_text_free(text);
    luxel_diagnostics_free(diagnostics);
    return code;
}

const struct command command_variant = {
    .name = "variant",
    .bit = COMMAND_VARIANT,
    .operand = N_("N"),
    .operand_kind = OPERAND_NONE,
    .endings = ".yaml .yml",
    .default_format = "yaml",
    .summary = N_("print a numbered variant of the exercise as a scene file"),
    .description = N_("The same number, from 1 to 1000000, always gives the same scene: a sphere wholly in view, one "
                      "source or, in every third variant, two, a pronounced peak, and five points; all numbers are "
                      "round and within the ranges of the exercise. Values follow the published solution: no "
                      "attenuation, the same intensity in all directions. luxel grade judges the answers."),
    .examples = "luxel variant 17 > variant-17.yaml\n"
                "luxel variant 17 -s 'lights[0].attenuation=inverse-square'\n"
                "luxel variant 17 -o variant-17.yaml",
    .run = run,
};
