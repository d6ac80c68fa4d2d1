/* SPDX-License-Identifier: MIT */
/* Derivatives of a grid as text, of its average and the range of its cells, and as JSON, of every cell. */
#include "derived_grid.h"

#include <luxel/luxel.h>

#include <math.h>

#include "grid_named.h"
#include "json.h"
#include "message.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

struct derived {
    const struct options *options;
    const struct loaded *loaded;
    const luxel_derivatives *found;
    size_t grid;
    unsigned columns, rows;
    const char *unit;
};

/* What the cells that have a value make of a number of a key: the average, and the range. */
struct of_cells {
    luxel_derivative average;
    double least, greatest;
};

static size_t count_cells(const struct derived *derived)
{
    return (size_t)derived->columns * derived->rows;
}

static luxel_bounded average_value(const struct derived *derived)
{
    luxel_bounded sum = {0, 0}, one;
    double count = 0;

    for (size_t i = 0; i < count_cells(derived); i++) {
        if (!luxel_derivatives_value(derived->found, i, &one))
            continue;
        sum.value += one.value;
        sum.error += one.error;
        count++;
    }
    return (luxel_bounded){sum.value / count, sum.error / count};
}

/* A cell without a value counts for nothing; one with a value and no derivative leaves the average without. */
static struct of_cells look_at_cells(const struct derived *derived, size_t key, size_t number)
{
    struct of_cells of = {.least = HUGE_VAL, .greatest = -HUGE_VAL};
    double count = 0;

    for (size_t i = 0; i < count_cells(derived); i++) {
        const luxel_derivative *one = luxel_derivatives_get(derived->found, i, key, number);
        luxel_bounded value;

        if (!luxel_derivatives_value(derived->found, i, &value))
            continue;
        of.average.value += one->value;
        of.average.error += one->error;
        if (one->state > of.average.state)
            of.average.state = one->state;
        of.least = fmin(of.least, one->value);
        of.greatest = fmax(of.greatest, one->value);
        count++;
    }
    of.average.value /= count;
    of.average.error /= count;
    if (count == 0)
        of.average.state = LUXEL_DERIVATIVE_NO_VALUE;
    return of;
}

static void print_json(const struct derived *derived)
{
    struct json json = {.stream = stdout};
    const luxel_bounded average = average_value(derived);

    json_open(&json, NULL, '{');
    json_text(&json, "grid", luxel_scene_grid_name(derived->loaded->scene, derived->grid));
    json_whole(&json, "index", derived->grid);
    json_text(&json, "unit", derived->unit);
    json_wholes(&json, "n", (const unsigned[]){derived->columns, derived->rows}, 2);
    json_open(&json, "average", '{');
    json_number(&json, "value", average.value);
    json_number(&json, "error", average.error);
    json_open(&json, "derivatives", '{');
    for (size_t k = 0; k < derived->options->free_key_count; k++) {
        const size_t numbers = luxel_derivatives_numbers(derived->found, k);
        const char *key = derived->options->free_keys[k];

        if (numbers > 1)
            json_open(&json, key, '[');
        for (size_t i = 0; i < numbers; i++) {
            const struct of_cells of = look_at_cells(derived, k, i);

            result_write_derivative(&json, numbers > 1 ? NULL : key, &of.average);
        }
        if (numbers > 1)
            json_close(&json, ']');
    }
    json_close(&json, '}');
    json_close(&json, '}');
    json_open(&json, "cells", '[');
    for (size_t i = 0; i < count_cells(derived); i++) {
        luxel_bounded value = {(double)NAN, (double)NAN};

        luxel_derivatives_value(derived->found, i, &value);
        json_open(&json, NULL, '{');
        json_wholes(&json, "cell", (const unsigned[]){(unsigned)i % derived->columns, (unsigned)(i / derived->columns)},
                    2);
        json_number(&json, "value", value.value);
        json_number(&json, "error", value.error);
        result_write_derivatives(&json, derived->options, derived->found, i);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
}

static void add_row(struct text_table *table, const struct derived *derived, size_t key, size_t number)
{
    const struct of_cells of = look_at_cells(derived, key, number);
    const char *words = luxel_derivative_words(of.average.state), *unit = luxel_derivatives_unit(derived->found, key);
    const char *name = derived->options->free_keys[key];
    char numbered[TEXT_SIZE], value[TEXT_SIZE], error[TEXT_SIZE], least[TEXT_SIZE], greatest[TEXT_SIZE];
    const bool has_range = of.least <= of.greatest;

    if (luxel_derivatives_numbers(derived->found, key) > 1)
        name = text_format(numbered, "%s[%zu]", name, number);
    text_table_row(table, TEXT_CELLS(name, words ? "" : text_bounded(value, 12, of.average.value, of.average.error),
                                     words ? "" : text_bound(error, 12, of.average.value, of.average.error),
                                     has_range ? text_format(least, "%.6g", of.least) : "",
                                     has_range ? text_format(greatest, "%.6g", of.greatest) : "",
                                     *unit ? text_unit(unit) : "1", words ? _(words) : ""));
}

static void print_text(const struct derived *derived)
{
    const char *name = luxel_scene_grid_name(derived->loaded->scene, derived->grid);
    struct text_table *table = text_table_new("lrrrrll");
    char value[TEXT_SIZE], number[TEXT_SIZE];
    const luxel_bounded average = average_value(derived);

    text_print_escaped(stdout, derived->loaded->name);
    fputs(": ", stdout);
    text_print_escaped(stdout, name ? name : text_format(number, "grids[%zu]", derived->grid));
    printf(_(", the average of %u × %u cells: %s %s, with its derivatives\n\n"), derived->columns, derived->rows,
           text_value_bound(value, 15, average.value, average.error), text_unit(derived->unit));
    text_table_row(table, TEXT_CELLS(_("key"), _("derivative"), _("error about"), _("least of a cell"),
                                     _("greatest of a cell"), _("per"), ""));
    for (size_t k = 0; k < derived->options->free_key_count; k++)
        for (size_t i = 0; i < luxel_derivatives_numbers(derived->found, k); i++)
            add_row(table, derived, k, i);
    text_table_print(table, stdout, 4);
}

int derived_grid(const struct options *options, const struct loaded *loaded)
{
    const size_t number = grid_named(options->drawing.grid, loaded);
    struct derived derived = {options, loaded, .unit = luxel_scene_unit(loaded->scene, LUXEL_IRRADIANCE)};
    luxel_derivatives *found = NULL;
    struct work work;

    if (number == 0)
        return EXIT_USAGE;
    if (options->place_count > 0) {
        message_error(_("--grid and points are two things: name one of them"));
        return EXIT_USAGE;
    }
    derived.grid = number - 1;
    luxel_scene_grid_resolution(loaded->scene, derived.grid, &derived.columns, &derived.rows);
    work_begin(&work, options);
    const luxel_status status = luxel_derive_grid(loaded->scene, &work.settings, derived.grid, options->free_keys,
                                                  options->free_key_count, loaded->diagnostics, &found);
    const int code = work_end(&work, status, loaded->diagnostics);

    derived.found = found;
    if (found && options->json)
        print_json(&derived);
    else if (found && standard_output_is_free(options))
        print_text(&derived);
    luxel_derivatives_free(found);
    return code;
}
