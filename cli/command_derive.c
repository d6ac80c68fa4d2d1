/* SPDX-License-Identifier: MIT */
/* luxel derive: how exact values at points change with keys of the scene. */
#include <luxel/luxel.h>
#include <string.h>

#include "cli.h"
#include "derived_grid.h"
#include "load.h"
#include "message.h"
#include "places.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

/* "lights[0].position[1]", or the key itself where it has one number. */
static const char *number_name(const struct options *options, const luxel_derivatives *derivatives, size_t key,
                               size_t number, char buffer[TEXT_SIZE])
{
    if (luxel_derivatives_numbers(derivatives, key) == 1)
        return options->free_keys[key];
    return text_format(buffer, "%s[%zu]", options->free_keys[key], number);
}

static void add_rows(struct text_table *table, const struct options *options, const luxel_derivatives *derivatives,
                     size_t place, size_t key)
{
    const char *unit = luxel_derivatives_unit(derivatives, key);

    for (size_t i = 0; i < luxel_derivatives_numbers(derivatives, key); i++) {
        const luxel_derivative *found = luxel_derivatives_get(derivatives, place, key, i);
        const char *words = luxel_derivative_words(found->state);
        char name[TEXT_SIZE], value[TEXT_SIZE], error[TEXT_SIZE];

        text_table_row(table, TEXT_CELLS(number_name(options, derivatives, key, i, name),
                                         words ? "" : text_bounded(value, 12, found->value, found->error),
                                         words ? "" : text_bound(error, 12, found->value, found->error),
                                         *unit ? text_unit(unit) : "1",
                                         words                                        ? _(words)
                                         : found->state == LUXEL_DERIVATIVE_ONE_SIDED ? _("from one side")
                                                                                      : ""));
    }
}

static void print_text(const struct result *result, const luxel_derivatives *derivatives, const char *name)
{
    char value[TEXT_SIZE];

    text_print_escaped(stdout, name);
    printf(_(": %s in %s, with its derivatives\n\n"), _(result_quantity_word(result)), text_unit(result_unit(result)));
    for (size_t i = 0; i < result->count; i++) {
        const luxel_probe *probe = luxel_probes_get(result->probes, i);
        struct text_table *table = text_table_new("lrrll");

        if (probe->has_value) {
            printf("%s: ", result_point_name(result, i, value));
            printf("%s %s\n", text_value_bound(value, 15, probe->value, probe->error), text_unit(result_unit(result)));
        } else {
            printf("%s\n", result_no_value(result, i, value));
        }
        text_table_row(table, TEXT_CELLS(_("key"), _("derivative"), _("error about"), _("per"), ""));
        for (size_t k = 0; k < result->options->free_key_count; k++)
            add_rows(table, result->options, derivatives, i, k);
        text_table_print(table, stdout, 4);
        fputc('\n', stdout);
    }
    result_print_conventions(result->scene, &result->use);
}

static void print(struct result *result, const luxel_derivatives *derivatives, const char *name)
{
    const struct options *options = result->options;

    if (result->count == 0 && !options->quiet)
        message_note(_("%s has no points; name some with -p X,Y, --at X,Y,Z,NX,NY,NZ or --points FILE"), name);
    result->derivatives = derivatives;
    if (options->json)
        result_print_json(result);
    else if (result->count > 0 && standard_output_is_free(options))
        print_text(result, derivatives, name);
}

/* The derivatives at the places of the result's probes; without a result the keys alone are checked. */
static int find(const struct options *options, const struct loaded *loaded, const struct result *result,
                luxel_derivatives **derivatives)
{
    struct places places = {.count = 0};
    int code = result ? places_collect(options, loaded->scene, loaded->diagnostics, &places) : EXIT_DONE;

    if (code == EXIT_DONE) {
        struct work work;

        work_begin(&work, options);
        const luxel_status status = luxel_derive_places(
            loaded->scene, &work.settings, places.list, result ? result->probes : NULL, places.count,
            options->free_keys, options->free_key_count, loaded->diagnostics, derivatives);
        code = work_end(&work, status, loaded->diagnostics);
    }
    places_clear(&places);
    return code;
}

static int derive(const struct options *options, const struct loaded *loaded)
{
    struct result result;
    luxel_derivatives *derivatives = NULL;
    int code;

    if (options->free_key_count == 0) {
        message_error(_("name the keys to derive by: --free lights[0].intensity, for instance"));
        return EXIT_USAGE;
    }
    for (size_t i = 1; i < options->free_key_count; i++)
        for (size_t j = 0; j < i; j++)
            if (strcmp(options->free_keys[i], options->free_keys[j]) == 0) {
                message_error(_("--free %s is given twice"), options->free_keys[i]);
                return EXIT_USAGE;
            }
    if (options->drawing.grid)
        return derived_grid(options, loaded);
    code = find(options, loaded, NULL, &derivatives);
    luxel_derivatives_free(derivatives);
    if (code != EXIT_DONE)
        return code;
    code = result_probe(options, loaded->scene, false, loaded->diagnostics, &result);
    if (code == EXIT_DONE || code == EXIT_TOLERANCE) {
        const int missed = code;

        code = find(options, loaded, &result, &derivatives);
        if (code == EXIT_DONE) {
            print(&result, derivatives, loaded->name);
            luxel_derivatives_free(derivatives);
            code = missed;
        }
    }
    result_clear(&result);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, derive);
}

const struct command command_derive = {
    .name = "derive",
    .bit = COMMAND_DERIVE,
    .operand = N_("SCENE"),
    .endings = "",
    .summary = N_("how exact values at points change with keys of the scene"),
    .description = N_("Prints the value at each point and its derivative by each number of the keys of --free, per the "
                      "key's own unit, with about how far it may be off. The points are those that luxel probe takes. "
                      "A point of the screen stays there where a surface moves. With --grid they are the cells of a "
                      "measuring grid, which move with it, and their average is told. A key lights[*].intensity is of "
                      "all lights that have one, which change alike. Where the value jumps or has a kink, "
                      "as at the border of a hard shadow, there is no derivative, and that is said."),
    .examples = "luxel derive --free lights[0].intensity --free lights[0].position -p 150,0\n"
                "luxel derive my.yaml --free surfaces[0].material.shininess --json\n"
                "luxel derive my.yaml --free lights[0].position --at 0,0,0,0,0,1 --quantity irradiance\n"
                "luxel derive office --grid floor --free grids[floor].center --free 'lights[*].factor'",
    .run = run,
};
