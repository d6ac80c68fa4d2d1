/* SPDX-License-Identifier: MIT */
/* luxel compare: how far two pictures are apart, and where. */
#include <luxel/luxel.h>

#include <math.h>

#include "cli.h"
#include "csv.h"
#include "json.h"
#include "message.h"
#include "outputs.h"
#include "picture.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"

struct comparing {
    const struct picture *a, *b;
    luxel_comparison made;
    bool same;        /* within the tolerance */
    double tolerance; /* relative to the scale */
};

static void add(struct text_table *table, const char *name, double value, double relative)
{
    char number[TEXT_SIZE], share[TEXT_SIZE] = "";

    if (!isnan(relative))
        text_format(share, _("%.3g of the scale"), relative);
    text_table_row(table, TEXT_CELLS(name, text_value(number, 9, value + 0.0), share));
}

static void print_place(const luxel_extremum *largest)
{
    char screen[TEXT_SIZE];

    if (isfinite(largest->x_mm))
        printf(_("  at pixel (%u, %u), screen %s mm\n"), largest->column, largest->row,
               text_lengths((const double[]){largest->x_mm, largest->y_mm}, 2, screen));
    else
        printf(_("  at pixel (%u, %u)\n"), largest->column, largest->row);
}

static void print_text(const struct comparing *comparing)
{
    const luxel_comparison *made = &comparing->made;
    const double none = (double)NAN;
    struct text_table *table = text_table_new("lrl");

    text_print_escaped(stdout, comparing->a->loaded.name);
    fputs(_(" and "), stdout);
    text_print_escaped(stdout, comparing->b->loaded.name);
    fputs(comparing->same ? _(": the same") : _(": different"), stdout);
    fputs("\n\n", stdout);
    if (made->pixels > 0) {
        add(table, _("largest difference"), made->largest.value, made->largest_relative);
        add(table, _("  in the first"), made->a, none);
        add(table, _("  in the second"), made->b, none);
        add(table, _("mean difference"), made->mean, none);
        add(table, _("mean magnitude"), made->mean_magnitude, none);
        add(table, _("root mean square"), made->rms, made->rms_relative);
        add(table, _("scale: the largest value"), made->scale, none);
    } else {
        text_table_line(table, _("no pixel shows a surface in both"));
    }
    text_table_print(table, stdout, 2);
    if (made->pixels > 0 && made->largest.value > 0.0)
        print_place(&made->largest);
    if (made->only_a > 0 || made->only_b > 0)
        printf(_("  %zu pixels show a surface in the first alone, %zu in the second alone\n"), made->only_a,
               made->only_b);
}

static void print_json(const struct comparing *comparing)
{
    const luxel_comparison *made = &comparing->made;
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "unit", picture_unit(comparing->a));
    json_bool(&json, "same", comparing->same);
    json_number(&json, "tolerance", comparing->tolerance);
    json_whole(&json, "pixels", made->pixels);
    json_whole(&json, "only_a", made->only_a);
    json_whole(&json, "only_b", made->only_b);
    result_write_extremum(&json, "largest", &made->largest);
    json_number(&json, "a", made->a);
    json_number(&json, "b", made->b);
    json_number(&json, "mean", made->mean);
    json_number(&json, "mean_magnitude", made->mean_magnitude);
    json_number(&json, "rms", made->rms);
    json_number(&json, "scale", made->scale);
    json_number(&json, "largest_relative", made->largest_relative);
    json_number(&json, "rms_relative", made->rms_relative);
    json_close(&json, '}');
}

static void write_csv(struct csv *csv, const void *data)
{
    static const char *const names[] = {
        "same",        "pixels", "only_a", "only_b", "largest",        "x_mm", "y_mm",  "column",
        "row",         "a",      "b",      "mean",   "mean_magnitude", "rms",  "scale", "largest_relative",
        "rms_relative"};
    const struct comparing *comparing = data;
    const luxel_comparison *made = &comparing->made;
    const double values[] = {comparing->same,
                             (double)made->pixels,
                             (double)made->only_a,
                             (double)made->only_b,
                             made->largest.value,
                             made->largest.x_mm,
                             made->largest.y_mm,
                             made->largest.column,
                             made->largest.row,
                             made->a,
                             made->b,
                             made->mean,
                             made->mean_magnitude,
                             made->rms,
                             made->scale,
                             made->largest_relative,
                             made->rms_relative};

    for (size_t i = 0; i < COUNT_OF(names); i++)
        csv_text(csv, names[i]);
    csv_end_line(csv);
    for (size_t i = 0; i < COUNT_OF(values); i++)
        csv_number(csv, values[i]);
    csv_end_line(csv);
}

static int write_outputs(const struct options *options, const luxel_field *difference, luxel_diagnostics *diagnostics)
{
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status = luxel_field_write(difference, options->outputs[i], diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
    }
    return code;
}

static int compare(const struct options *options, const struct picture *a, const struct picture *b)
{
    struct comparing comparing = {.a = a, .b = b, .tolerance = options->settings.tolerance};
    luxel_diagnostics *diagnostics = a->loaded.diagnostics;
    luxel_field *difference = NULL;
    luxel_status status;
    struct options table = *options;
    int code;

    status =
        luxel_compare(a->field, b->field, diagnostics, &comparing.made, options->output_count > 0 ? &difference : NULL);
    if (status != LUXEL_OK) {
        message_failure(status, diagnostics);
        return EXIT_DIFFERENCE;
    }
    comparing.same = comparing.made.largest_relative <= comparing.tolerance && comparing.made.only_a == 0 &&
                     comparing.made.only_b == 0;
    code = write_outputs(options, difference, diagnostics);
    luxel_field_free(difference);
    table.output_count = 0; /* they are pictures, and written */
    if (options->json)
        print_json(&comparing);
    else if (options->csv != CSV_NONE)
        csv_write(&table, write_csv, &comparing);
    else if (standard_output_is_free(options))
        print_text(&comparing);
    return code != EXIT_DONE ? code : comparing.same ? EXIT_DONE : EXIT_DIFFERENCE;
}

/* -s is for scenes: where one of the two is a file of values, for the other alone. */
static int open_one(const struct options *options, size_t i, struct picture *picture)
{
    struct options rendering = *options;

    rendering.settings.tolerance = 0.0; /* it is that of the comparison */
    if (picture_holds_values(options->operands[i]) && !picture_holds_values(options->operands[1 - i]))
        rendering.assignment_count = 0;
    return picture_open(&rendering, options->operands[i], picture);
}

static int run(const struct options *options)
{
    struct picture a = {.field = NULL}, b = {.field = NULL};
    int code;

    if (options->operand_count != 2) {
        message_error(_("luxel compare needs two pictures or scenes"));
        return EXIT_USAGE;
    }
    code = outputs_check(options, luxel_check_output_name);
    if (code != EXIT_DONE)
        return code;
    code = open_one(options, 0, &a);
    if (code == EXIT_DONE)
        code = open_one(options, 1, &b);
    if (code == EXIT_DONE)
        code = compare(options, &a, &b);
    if (code == EXIT_DONE)
        code = a.code != EXIT_DONE ? a.code : b.code;
    picture_close(&a);
    picture_close(&b);
    return code;
}

const struct command command_compare = {
    .name = "compare",
    .bit = COMMAND_COMPARE,
    .operand = "A",
    .more = "B",
    .more_kind = OPERAND_SCENE,
    .most_operands = 2,
    .summary = N_("compare two pictures: how far they are apart, and where"),
    .description =
        N_("A and B are scenes, which are computed, or files of values (.npy, .pfm, .exr, .csv). Exit code 1 "
           "where the largest difference is beyond the tolerance times the largest value (default 0: any "
           "difference counts), or where one of them shows a surface and the other none; also where their "
           "pixels are not the same places. FILE becomes the picture of the differences, B less A; in a .png "
           "middle grey is no difference."),
    .examples = "luxel compare mine.npy report --tolerance 1e-4\n"
                "luxel compare a.yaml b.yaml -o difference.png --json",
    .run = run,
};
