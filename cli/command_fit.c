/* SPDX-License-Identifier: MIT */
/* luxel fit: the keys of a scene that make it give what was measured, with error bars. */
#include <luxel/luxel.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../front/language.h"
#include "cli.h"
#include "csv.h"
#include "json.h"
#include "message.h"
#include "outputs.h"
#include "readings.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

/* A fit, and what it was made from. */
struct fitted {
    const struct options *options;
    const struct loaded *loaded;
    const struct readings *readings;
    const luxel_fit *fit;
};

/* ---- JSON ---- */

static void print_json(const struct fitted *fitted)
{
    const luxel_fit *fit = fitted->fit;
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_open(&json, "parameters", '[');
    for (size_t i = 0; i < fit->count; i++) {
        const luxel_fit_parameter *parameter = &fit->parameters[i];

        json_open(&json, NULL, '{');
        json_text(&json, "key", parameter->key);
        json_number(&json, "value", parameter->value);
        json_number(&json, "sd", parameter->sd);
        json_number(&json, "low", parameter->low);
        json_number(&json, "high", parameter->high);
        json_text(&json, "unit", parameter->unit);
        json_bool(&json, "determined", parameter->is_determined);
        json_bool(&json, "at_limit", parameter->is_at_limit);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_whole(&json, "rank", fit->rank);
    json_whole(&json, "free", fit->count);
    json_number(&json, "chi2", fit->chi2);
    json_whole(&json, "dof", fit->dof);
    json_open(&json, "correlation", '[');
    for (size_t i = 0; i < fit->count; i++)
        json_numbers(&json, NULL, &fit->correlation[i * fit->count], fit->count);
    json_close(&json, ']');
    json_open(&json, "undetermined", '[');
    for (size_t i = 0; i < fit->undetermined; i++) {
        char *words = luxel_fit_undetermined(fit, i, NULL, NULL);

        json_text(&json, NULL, words);
        luxel_text_free(words);
    }
    json_close(&json, ']');
    char *determined = luxel_fit_determined(fit, NULL, NULL);

    json_text(&json, "determined", determined);
    luxel_text_free(determined);
    json_whole(&json, "readings", fit->readings);
    json_whole(&json, "saturated", fit->saturated);
    json_whole(&json, "outliers", fit->outliers);
    json_whole(&json, "without_derivative", fit->without_derivative);
    json_open(&json, "noise", '{');
    json_number(&json, "sd", fit->noise);
    json_bool(&json, "estimated", fit->noise_is_estimated);
    json_close(&json, '}');
    json_open(&json, "starts", '{');
    json_whole(&json, "taken", fit->starts);
    json_whole(&json, "agreed", fit->agreed);
    json_close(&json, '}');
    json_bool(&json, "converged", fit->has_converged);
    json_text(&json, "unit", luxel_settings_unit(fitted->loaded->scene, &fitted->options->settings));
    json_close(&json, '}');
}

/* ---- text ---- */

/* A value in as many digits as its standard deviation leaves. */
static const char *text_parameter(const luxel_fit_parameter *parameter, double number, char buffer[TEXT_SIZE])
{
    if (!parameter->has_errors)
        return text_format(buffer, "%.10g", number);
    return text_bounded(buffer, 12, number, parameter->sd);
}

static void print_parameters(const luxel_fit *fit)
{
    struct text_table *table = text_table_new("lrrrll");

    text_table_row(table, TEXT_CELLS(_("key"), _("value"), "± sd", "95 %", "", ""));
    for (size_t i = 0; i < fit->count; i++) {
        const luxel_fit_parameter *parameter = &fit->parameters[i];
        char value[TEXT_SIZE], sd[TEXT_SIZE], low[TEXT_SIZE], high[TEXT_SIZE], interval[TEXT_SIZE];
        const bool has = parameter->has_errors;

        if (has)
            text_format(interval, "%.150s … %.150s", text_parameter(parameter, parameter->low, low),
                        text_parameter(parameter, parameter->high, high));
        text_table_row(table,
                       TEXT_CELLS(parameter->key,
                                  parameter->is_determined ? text_parameter(parameter, parameter->value, value) : "–",
                                  has ? text_format(sd, "%.2g", parameter->sd) : "", has ? interval : "",
                                  *parameter->unit ? text_unit(parameter->unit) : "",
                                  !parameter->is_determined ? _("not determined")
                                  : parameter->is_at_limit  ? _("at the end of what is legal")
                                                            : ""));
    }
    text_table_print(table, stdout, 4);
}

static void print_correlation(const luxel_fit *fit)
{
    char alignment[TEXT_COLUMNS + 1] = "l";
    const char *cells[TEXT_COLUMNS] = {""};
    char numbers[TEXT_COLUMNS][TEXT_SIZE];

    if (fit->count < 2 || fit->count + 1 > TEXT_COLUMNS)
        return;
    memset(alignment + 1, 'r', fit->count);
    alignment[fit->count + 1] = '\0';

    struct text_table *table = text_table_new(alignment);

    for (size_t i = 0; i < fit->count; i++) {
        cells[0] = fit->parameters[i].key;
        for (size_t k = 0; k < fit->count; k++) {
            const double r = fit->correlation[i * fit->count + k];

            cells[k + 1] = isnan(r) ? "–" : text_format(numbers[k], "%.3f", r + 0.0);
        }
        text_table_row(table, cells);
    }
    printf("\n%s\n", _("Correlation:"));
    text_table_print(table, stdout, 4);
}

static void print_noise(const struct fitted *fitted)
{
    const luxel_fit *fit = fitted->fit;
    const char *unit = text_unit(luxel_settings_unit(fitted->loaded->scene, &fitted->options->settings));

    if (!fit->noise_is_estimated)
        printf(_("\nχ² %.6g for %zu degrees of freedom (%.3g each)\n"), fit->chi2, fit->dof,
               fit->dof > 0 ? fit->chi2 / (double)fit->dof : 0.0);
    else if (fit->dof > 0)
        printf(_("\nThe readings scatter by %.3g %s; %zu degrees of freedom\n"), fit->noise, unit, fit->dof);
    else
        printf("\n%s\n", _("As many readings as unknowns: without --noise there are no error bars."));
    if (fit->saturated > 0)
        printf(_("Saturated readings: %zu\n"), fit->saturated);
    if (fit->outliers > 0)
        printf(_("Readings that are off by more than 3.5 standard deviations: %zu\n"), fit->outliers);
    if (fit->without_derivative > 0)
        printf(_("Readings where the value jumps or has a kink, which say nothing of the errors: %zu\n"),
               fit->without_derivative);
    printf(_("Of %zu starts %zu ended here.\n"), fit->starts, fit->agreed);
    if (!fit->has_converged)
        printf("%s\n", _("The numbers were still changing after the most steps that are taken."));
}

static void print_text(const struct fitted *fitted)
{
    const luxel_fit *fit = fitted->fit;
    const struct option_fit *how = &fitted->options->fit;

    text_print_escaped(stdout, fitted->loaded->name);
    fputs(_(", fitted to "), stdout);
    text_print_escaped(stdout, how->values ? how->values : how->picture);
    printf(_(": %zu readings, %zu of %zu numbers determined\n\n"), fit->readings, fit->rank, fit->count);
    print_parameters(fit);
    if (fit->undetermined > 0) {
        char *words = luxel_fit_determined(fit, language_translate, NULL);

        printf("\n%s\n", words ? words : "");
        luxel_text_free(words);
    }
    for (size_t i = 0; i < fit->undetermined; i++) {
        char *words = luxel_fit_undetermined(fit, i, language_translate, NULL);

        printf("%s\n", words ? words : "");
        luxel_text_free(words);
    }
    print_correlation(fit);
    print_noise(fitted);
}

/* ---- files ---- */

/* Row by row: the place, the reading, and what is left of it. */
static void write_residuals(struct csv *csv, const void *data)
{
    const struct fitted *fitted = data;
    const struct readings *readings = fitted->readings;
    const char *unit = luxel_settings_unit(fitted->loaded->scene, &fitted->options->settings);
    static const char *const names[] = {"x_mm", "y_mm", "z_mm", "nx", "ny", "nz"};
    bool has_elements = false;

    for (size_t i = 0; i < readings->list.count; i++)
        has_elements = has_elements || readings->list.places[i].is_element;
    for (size_t k = 0; k < (has_elements ? 6 : 2); k++)
        csv_text(csv, names[k]);
    csv_heading(csv, "value", unit);
    csv_heading(csv, "residual", unit);
    csv_end_line(csv);
    for (size_t i = 0; i < readings->list.count; i++) {
        const luxel_place *place = &readings->list.places[i];

        for (size_t k = 0; k < (has_elements ? 6 : 2); k++)
            if (place->is_element)
                csv_number(csv, k < 3 ? place->position_mm[k] : place->normal[k - 3]);
            else if (k < 2)
                csv_number(csv, place->screen_mm[k]);
            else
                csv_blank(csv);
        csv_number(csv, readings->list.values[i]);
        csv_number(csv, fitted->fit->residuals[i]);
        csv_end_line(csv);
    }
}

static int write_residual_picture(const struct fitted *fitted)
{
    const luxel_field *picture = fitted->readings->picture;
    const size_t count = (size_t)luxel_field_columns(picture) * luxel_field_rows(picture);
    unsigned char *mask = message_allocate(count, 1);
    double *values = message_allocate(count, sizeof *values);
    luxel_field *field = NULL;

    for (size_t i = 0; i < count; i++) {
        mask[i] = (unsigned char)(isnan(fitted->fit->residuals[i]) ? 0 : 1);
        values[i] = mask[i] ? fitted->fit->residuals[i] : 0.0;
    }
    const luxel_field_content content = {.columns = luxel_field_columns(picture),
                                         .rows = luxel_field_rows(picture),
                                         .precision = LUXEL_DOUBLE,
                                         .values = values,
                                         .mask = mask,
                                         .x_mm = luxel_field_x_mm(picture),
                                         .y_mm = luxel_field_y_mm(picture)};
    luxel_status status = luxel_field_of_values(&content, fitted->loaded->diagnostics, &field);

    if (status == LUXEL_OK)
        status = luxel_field_write(field, fitted->options->fit.residual, fitted->loaded->diagnostics);
    luxel_field_free(field);
    free(mask);
    free(values);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, fitted->loaded->diagnostics);
}

static int write_residual(const struct fitted *fitted)
{
    struct options table = *fitted->options;

    if (fitted->readings->picture)
        return write_residual_picture(fitted);
    table.csv = CSV_NONE;
    table.outputs = (const char *[]){fitted->options->fit.residual};
    table.output_count = 1;
    return csv_write(&table, write_residuals, fitted);
}

/* A scene that is only partly known is not written. */
static int write_files(const struct fitted *fitted)
{
    const struct options *options = fitted->options;
    int worst = options->fit.residual ? write_residual(fitted) : EXIT_DONE;

    if (options->output_count > 0 && fitted->fit->undetermined > 0) {
        message_note(_("the scene is not written, as not all of its free numbers are determined"));
        return worst;
    }
    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status =
            luxel_scene_write_file(luxel_fit_scene(fitted->fit), options->outputs[i], fitted->loaded->diagnostics);

        if (status != LUXEL_OK)
            worst = message_failure(status, fitted->loaded->diagnostics);
    }
    return worst;
}

/* ---- the command ---- */

/* Everything that is wrong with the options. */
static int check(const struct options *options)
{
    const struct option_fit *fit = &options->fit;
    bool good = true;

    if (options->free_key_count == 0) {
        message_error(_("no key is free: name at least one, such as --free lights[0].intensity"));
        good = false;
    }
    if (!fit->picture == !fit->values) {
        message_error(_("name what was measured by --picture FILE or by --values FILE, one of them"));
        good = false;
    }
    if (!good)
        return EXIT_USAGE;
    if (fit->residual) {
        luxel_diagnostics *diagnostics = message_new_diagnostics();
        const luxel_status status = fit->values ? outputs_check_csv(fit->residual, diagnostics)
                                                : luxel_check_output_name(fit->residual, diagnostics);
        const int code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);

        luxel_diagnostics_free(diagnostics);
        if (code != EXIT_DONE)
            return code;
    }
    return outputs_check_places(options);
}

static int fit_readings(const struct options *options, const struct loaded *loaded, const struct readings *readings,
                        luxel_fit **fit)
{
    struct work work;
    luxel_status status;

    work_begin(&work, options);
    if (readings->picture)
        status = luxel_fit_picture(loaded->scene, &work.settings, readings->picture, &readings->list,
                                   options->free_keys, options->free_key_count, loaded->diagnostics, fit);
    else
        status = luxel_fit_readings(loaded->scene, &work.settings, &readings->list, options->free_keys,
                                    options->free_key_count, loaded->diagnostics, fit);
    return work_end(&work, status, loaded->diagnostics);
}

static int fit_scene(const struct options *options, const struct loaded *loaded)
{
    struct readings readings;
    luxel_fit *fit = NULL;
    int code = check(options);

    if (code != EXIT_DONE)
        return code;
    code = readings_read(options, loaded, &readings);
    if (code == EXIT_DONE)
        code = fit_readings(options, loaded, &readings, &fit);
    if (fit) {
        const struct fitted fitted = {options, loaded, &readings, fit};

        if (options->json)
            print_json(&fitted);
        else if (standard_output_is_free(options))
            print_text(&fitted);
        if (fit->undetermined > 0 && !options->json)
            message_error(_("the readings do not determine all free numbers"));
        code = write_files(&fitted);
        if (code == EXIT_DONE && fit->undetermined > 0)
            code = EXIT_TOLERANCE;
    }
    luxel_fit_free(fit);
    readings_clear(&readings);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, fit_scene);
}

const struct command command_fit = {
    .name = "fit",
    .bit = COMMAND_FIT,
    .operand = N_("SCENE"),
    .endings = ".yaml .yml .json",
    .summary = N_("find keys of a scene from what was measured, with error bars"),
    .description =
        N_("Changes the keys of --free until the scene gives what was measured: the pixels of --picture, or the values "
           "at the points of --values. Prints each number with its standard deviation, the interval that holds the "
           "truth in 95 of 100 cases, and how the numbers go together. What the readings do not determine is named and "
           "gets no number; the exit code is 5 then."),
    .examples = "luxel fit --free lights[0].intensity --values readings.csv --noise 3%\n"
                "luxel fit desk.yaml --free lights[0].position --values readings.csv --json\n"
                "luxel fit ball.yaml --free lights[0].position --picture p.exr -o fitted.yaml\n"
                "luxel fit ball.yaml --free lights[0].position --picture p.png --loss huber",
    .run = run,
};
