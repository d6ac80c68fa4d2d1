/* SPDX-License-Identifier: MIT */
/*
 * luxel render: the picture of a scene, as files and as a table of its numbers.  The picture goes to its files row by
 * row, as it need not fit in memory; they are written before anything is printed, so that a reader of the table who
 * goes away never costs a file.
 */
#include <luxel/luxel.h>

#include <math.h>
#include <string.h>

#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "outputs.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

static void add_extremum(struct text_table *table, const char *name, const luxel_extremum *extremum)
{
    char value[TEXT_SIZE], pixel[TEXT_SIZE], screen[TEXT_SIZE];

    if (!extremum->exists) {
        text_table_row(table, TEXT_CELLS(name, _("none"), "", ""));
        return;
    }
    text_table_row(table, TEXT_CELLS(name, text_value(value, 6, extremum->value),
                                     text_format(pixel, "(%u, %u)", extremum->column, extremum->row),
                                     text_lengths((const double[]){extremum->x_mm, extremum->y_mm}, 2, screen)));
}

/* What the least value above 0 is where no light arrives; it is a tiny number that wants to be told. */
static void explain_minimum(const luxel_statistics *statistics)
{
    const luxel_extremum *least = &statistics->minimum, *reached = &statistics->minimum_reached;

    if (least->exists && (!reached->exists || least->value < reached->value))
        text_definition(stdout, "", 2,
                        _("The minimum above 0 lies where no source shines on the surface: what is there is the tail "
                          "of a highlight that is not gated, or ambient light."));
}

/* What light over more mirrors than are counted may be, in the unit of the values. */
static const char *mirrored_error(const luxel_statistics *statistics, char buffer[TEXT_SIZE])
{
    const double error = statistics->mirrored_error * statistics->maximum.value;

    return isfinite(error) ? text_error(error, buffer) : _("not bounded");
}

static void print_statistics(const struct result *result)
{
    const luxel_statistics *statistics = result->statistics;
    /* where points are taken together, and in colour, it may not have been looked for */
    const bool is_known = statistics->minimum_reached.exists ||
                          !(result->options->settings.light_error > 0.0 || luxel_scene_has_color(result->scene));
    struct text_table *table = text_table_new("lrrr");
    char heading[TEXT_SIZE], mean[TEXT_SIZE], lit[TEXT_SIZE], reflected[TEXT_SIZE], mirrored[TEXT_SIZE];

    text_format(heading, _("value (%s)"), _(result_unit(result)));
    text_table_row(table, TEXT_CELLS("", heading, _("pixel (u, v)"), _("screen x, y (mm)")));
    add_extremum(table, _("maximum"), &statistics->maximum);
    add_extremum(table, _("minimum above 0"), &statistics->minimum);
    if (is_known)
        add_extremum(table, _("minimum where light arrives"), &statistics->minimum_reached);
    if (statistics->has_surface) {
        text_table_row(table, TEXT_CELLS(_("mean"), text_value(mean, 6, statistics->mean), "", ""));
        text_table_row(table,
                       TEXT_CELLS(_("pixels above 0"), text_format(lit, "%.2f %%", 100.0 * statistics->lit), "", ""));
    } else {
        text_table_line(table, _("no pixel shows a surface"));
    }
    if (statistics->has_reflected && statistics->has_surface)
        text_table_row(table, TEXT_CELLS(_("error of reflected light"),
                                         text_error(statistics->reflected_error * statistics->maximum.value, reflected),
                                         "", ""));
    if (statistics->mirrored_error > 0.0 && statistics->has_surface)
        text_table_row(table,
                       TEXT_CELLS(_("error of light over mirrors"), mirrored_error(statistics, mirrored), "", ""));
    text_table_print(table, stdout, 2);
    if (is_known)
        explain_minimum(statistics);
}

/* A point with a value is a row; one without is a line that says why. */
static void add_point(struct text_table *table, const struct result *result, size_t i)
{
    const luxel_probe *probe = luxel_probes_get(result->probes, i);
    char name[TEXT_SIZE], value[TEXT_SIZE], error[TEXT_SIZE], pixel_value[TEXT_SIZE], pixel[TEXT_SIZE];

    result_point_name(result, i, name);
    if (!probe->has_value) {
        text_table_line(table, result_no_value(result, i, value));
        return;
    }
    if (probe->has_pixel)
        text_format(pixel, "(%u, %u)", probe->column, probe->row);
    else
        text_format(pixel, "%s", _("off the screen"));
    text_table_row(table,
                   TEXT_CELLS(name, text_bounded(value, 12, probe->value, probe->error),
                              text_bound(error, 12, probe->value, probe->error),
                              probe->has_pixel_value ? text_value(pixel_value, 6, probe->pixel_value) : "", pixel));
}

static void print_points(const struct result *result)
{
    struct text_table *table = text_table_new("lrrrr");
    bool has_reflected = false; /* which is known to a bound alone */

    for (size_t i = 0; i < result->count; i++)
        has_reflected = has_reflected || luxel_probes_get(result->probes, i)->has_reflected;
    text_table_row(table, TEXT_CELLS(_("point x, y (mm)"), has_reflected ? _("value") : _("exact value"),
                                     _("error at most"), _("pixel value"), _("pixel (u, v)")));
    for (size_t i = 0; i < result->count; i++)
        add_point(table, result, i);
    text_table_print(table, stdout, 2);
}

static void print_text(const struct result *result, const char *name)
{
    unsigned columns = 0, rows = 0;

    luxel_scene_resolution(result->scene, &columns, &rows);
    text_print_escaped(stdout, name);
    printf(_(": %s in %s, %u × %u pixels\n\n"), _(result_quantity_word(result)), text_unit(result_unit(result)),
           columns, rows);
    print_statistics(result);
    if (result->count > 0) {
        fputc('\n', stdout);
        print_points(result);
    }
    fputc('\n', stdout);
    result_print_conventions(result->scene, &result->use);
}

/* Whether mirrors leave something out of the picture. */
static bool is_left_out(const luxel_diagnostics *diagnostics)
{
    bool is_told = false;

    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++)
        is_told = is_told || strcmp(luxel_diagnostics_get(diagnostics, i)->id, "picture-of-mirrors") == 0;
    return is_told;
}

/* The picture and its files, and what Ctrl-C does to them.  EXIT_FILE goes with statistics. */
static int compute(const struct options *options, const struct loaded *loaded, luxel_statistics *statistics)
{
    const luxel_field_output how = {.bits = options->bits};
    struct work work;
    luxel_status status;

    work_begin(&work, options);
    work.settings.minimum_reached = true;
    status = luxel_render_files(loaded->scene, &work.settings, options->outputs, options->output_count, &how,
                                loaded->diagnostics, statistics);
    const int code = work_end(&work, status, loaded->diagnostics);

    if (code == EXIT_DONE && (luxel_scene_has_color(loaded->scene) || is_left_out(loaded->diagnostics)))
        message_passed_over(loaded->diagnostics, options->quiet); /* what was clipped */
    return code;
}

/* Grey levels are of .png files alone. */
static bool writes_grey(const struct options *options)
{
    static const char *const endings[] = {".png"};

    for (size_t i = 0; i < options->output_count; i++)
        if (luxel_check_ending(options->outputs[i], endings, COUNT_OF(endings), NULL) == LUXEL_OK)
            return true;
    return false;
}

static int render(const struct options *options, const struct loaded *loaded)
{
    luxel_statistics statistics;
    struct result result;
    int code = result_probe(options, loaded->scene, true, loaded->diagnostics, &result), write_code;

    if (code == EXIT_DONE || code == EXIT_TOLERANCE) {
        write_code = compute(options, loaded, &statistics);
        if (write_code != EXIT_DONE)
            code = write_code;
        if (write_code == EXIT_DONE || write_code == EXIT_TOLERANCE || write_code == EXIT_FILE) {
            result.statistics = &statistics;
            result.use.screen = result.use.pixels = true;
            result.use.surfaces = NULL;
            result.use.range = result.use.rounding = writes_grey(options);
            if (options->json)
                result_print_json(&result);
            else if (standard_output_is_free(options))
                print_text(&result, loaded->name);
        }
    }
    result_clear(&result);
    return code;
}

static int run(const struct options *options)
{
    const int code = outputs_check(options, luxel_check_output_name);

    if (code != EXIT_DONE)
        return code;
    if (options->bits && !writes_grey(options)) {
        message_error(_("--bits is of a picture in grey levels: -o FILE.png"));
        return EXIT_USAGE;
    }
    return load_and(options, render);
}

const struct command command_render = {
    .name = "render",
    .bit = COMMAND_RENDER,
    .operand = N_("SCENE"),
    .summary = N_("compute the picture, print its numbers, write it to files"),
    .description =
        N_("Prints the maximum, the minimum above 0, the least value where light arrives (N·L > 0 for some source or a "
           "part of one, shadows included; in JSON min_reached) and the mean of the picture, and the exact value at "
           "each point of the scene. Each FILE appears whole or not at all, and the picture need not fit in memory."),
    .examples = "luxel render\n"
                "luxel render my.yaml -o sphere.png -o sphere.npy\n"
                "luxel render -s 'lights[0].position=[1500,800,2400]' -s 'surfaces[0].material.shininess=60'",
    .run = run,
};
