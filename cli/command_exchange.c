/* SPDX-License-Identifier: MIT */
/* luxel exchange: the form factors between all sides of the surfaces of a scene. */
#include <math.h>
#include <stdio.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"
#include "work.h"

/* A larger matrix is told by the sums of its rows alone: lines would not fit. */
enum { MOST_COLUMNS = 20 };

/* "box, floor", "ball, outside", or "surfaces[1], front": names in JSON, which is not translated. */
static void print_name(const luxel_exchange_side *side, bool is_translated, char buffer[TEXT_SIZE])
{
    const bool is_inner_wall = side->part_name && side->side == LUXEL_SIDE_FRONT;
    const char *word = luxel_surface_side_name(side->side);
    char index[TEXT_SIZE];

    text_format(buffer, "%s%s%s%s%s",
                side->surface_name ? side->surface_name : text_format(index, "surfaces[%zu]", side->surface),
                side->part_name ? ", " : "", side->part_name ? side->part_name : "", is_inner_wall ? "" : ", ",
                is_inner_wall   ? ""
                : is_translated ? _(word)
                                : word);
}

static luxel_bounded factor_of(const luxel_exchange *exchange, size_t i, size_t j)
{
    return exchange->factors[i * exchange->count + j];
}

static void print_json(const luxel_exchange *exchange)
{
    struct json json = {.stream = stdout};
    char name[TEXT_SIZE];

    json_open(&json, NULL, '{');
    json_open(&json, "sides", '[');
    for (size_t i = 0; i < exchange->count; i++) {
        print_name(&exchange->sides[i], false, name);
        json_open(&json, NULL, '{');
        json_text(&json, "name", name);
        json_number(&json, "area", exchange->sides[i].area_m2);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_open(&json, "factors", '[');
    for (size_t i = 0; i < exchange->count; i++) {
        json_open(&json, NULL, '[');
        for (size_t j = 0; j < exchange->count; j++) {
            json_open(&json, NULL, '{');
            json_number(&json, "value", factor_of(exchange, i, j).value);
            json_number(&json, "error", factor_of(exchange, i, j).error);
            json_close(&json, '}');
        }
        json_close(&json, ']');
    }
    json_close(&json, ']');
    json_close(&json, '}');
}

/* A row with the side that sends, its factors in the digits that their bounds leave, and their sum. */
static void add_row(struct text_table *table, const luxel_exchange *exchange, size_t i)
{
    char name[TEXT_SIZE], label[TEXT_SIZE], area[TEXT_SIZE], numbers[MOST_COLUMNS + 1][TEXT_SIZE];
    const char *cells[MOST_COLUMNS + 3] = {label, area};
    const size_t shown = exchange->count <= MOST_COLUMNS ? exchange->count : 0;
    luxel_bounded sum = {0.0, 0.0};

    print_name(&exchange->sides[i], true, name);
    char *escaped = luxel_escaped_text(name);

    text_format(label, "%zu %s", i, escaped ? escaped : "");
    luxel_text_free(escaped);
    text_format(area, "%.4g", exchange->sides[i].area_m2);
    for (size_t j = 0; j < exchange->count; j++) {
        const luxel_bounded factor = factor_of(exchange, i, j);

        if (shown > 0)
            cells[j + 2] = text_bounded(numbers[j], 6, factor.value, factor.error);
        sum.value += factor.value;
        sum.error += factor.error;
    }
    cells[shown + 2] = text_value_bound(numbers[shown], 6, sum.value, sum.error);
    text_table_row(table, cells);
}

static void print_matrix(const luxel_exchange *exchange)
{
    char alignment[MOST_COLUMNS + 4] = "l", numbers[MOST_COLUMNS][TEXT_SIZE];
    const char *cells[MOST_COLUMNS + 3] = {_("from side"), _("area, m²")};
    const size_t shown = exchange->count <= MOST_COLUMNS ? exchange->count : 0;
    struct text_table *table;

    for (size_t i = 1; i < shown + 3; i++)
        alignment[i] = 'r';
    table = text_table_new(alignment);
    for (size_t j = 0; j < shown; j++)
        cells[j + 2] = text_format(numbers[j], _("to %zu"), j);
    cells[shown + 2] = _("sum");
    text_table_row(table, cells);
    for (size_t i = 0; i < exchange->count; i++)
        add_row(table, exchange, i);
    text_table_print(table, stdout, 2);
}

static void print_text(const luxel_exchange *exchange, const char *name)
{
    char error[TEXT_SIZE];
    double largest = 0.0;

    for (size_t i = 0; i < exchange->count * exchange->count; i++)
        largest = fmax(largest, exchange->factors[i].error);
    text_print_escaped(stdout, name);
    printf(_(": form factors, the share of what a side sends that arrives at another\n\n"));
    print_matrix(exchange);
    if (exchange->count > MOST_COLUMNS)
        printf(_("  too many sides for a table of all factors: --json prints them\n"));
    printf(_("  error of the factors at most %s\n"), text_error(largest, error));
}

static int exchange(const struct options *options, const struct loaded *loaded)
{
    luxel_exchange *found = NULL;
    struct work work;
    int code;

    work_begin(&work, options);
    code = work_end(&work, luxel_find_exchange(loaded->scene, &work.settings, loaded->diagnostics, &found),
                    loaded->diagnostics);
    if (code != EXIT_DONE)
        return code;
    if (options->json)
        print_json(found);
    else
        print_text(found, loaded->name);
    if (!found->reached) {
        message_error(_("form factors are not known as well as --reflected-error asks for; the bounds hold"));
        code = EXIT_TOLERANCE;
    }
    luxel_exchange_free(found);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, exchange);
}

const struct command command_exchange = {
    .name = "exchange",
    .bit = COMMAND_EXCHANGE,
    .operand = N_("SCENE"),
    .endings = "",
    .summary = N_("form factors between all sides of surfaces"),
    .description = N_(
        "Prints the matrix of form factors, also called view factors: of what a side of a surface sends evenly by "
        "Lambert's law, the share that arrives at another, with what stands between, and a bound of the error of each. "
        "Rows are the sides that send; the factors of a side in a closed room add up to 1. Lights and materials do not "
        "matter. --reflected-error is the error that is wanted, as a share of what is sent (1e-3)."),
    .examples = "luxel exchange room\n"
                "luxel exchange room.yaml --json --reflected-error 1e-4",
    .run = run,
};
