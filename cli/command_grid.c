/* SPDX-License-Identifier: MIT */
/*
 * luxel grid: the irradiance on a scene's measuring planes.  As with pictures, the files are written before anything is
 * printed.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "grid_color.h"
#include "grid_json.h"
#include "grid_limits.h"
#include "grid_measure.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "outputs.h"
#include "progress.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"

/* Larger grids are not printed as a table: lines would not fit, and nobody reads them. */
enum { MOST_COLUMNS = 20, MOST_ROWS = 100 };

/* A measuring plane knows no screen, no material and no view. */
static const luxel_conventions_use of_planes = {.screen = false};

struct grids {
    const luxel_scene *scene;
    const char *unit;
    luxel_grid **list;
    luxel_grid_extrema *extrema; /* on the planes of each */
    size_t count;
    bool judges;                /* whether --limits is given: then there are also */
    struct observers observers; /* those of the scene */
};

/* Progress of all grids together, by their cells, for each of which the extrema count as much again. */
struct share {
    struct progress *progress;
    double before, own, all;
};

static bool report_share(double done, void *data)
{
    const struct share *share = data;

    return progress_report((share->before + done * share->own) / share->all, share->progress);
}

static bool report_bound(double bound, void *data)
{
    return progress_is_enough(bound, ((const struct share *)data)->progress);
}

static double count_cells(const luxel_scene *scene, size_t i)
{
    unsigned columns = 0, rows = 0;

    luxel_scene_grid_resolution(scene, i, &columns, &rows);
    return (double)columns * rows;
}

/* Measures all grids of the scene; grids_clear() is due in every case. */
static luxel_status measure(const struct options *options, const struct loaded *loaded, struct grids *grids)
{
    const size_t count = luxel_scene_grid_count(loaded->scene);
    luxel_settings settings = options->settings;
    luxel_settings irradiance = settings;
    struct progress progress;
    struct share share = {.progress = &progress};
    luxel_status status = LUXEL_OK;

    irradiance.quantity = LUXEL_IRRADIANCE;
    *grids = (struct grids){.scene = loaded->scene,
                            .unit = luxel_settings_unit(loaded->scene, &irradiance),
                            .list = message_allocate(count, sizeof *grids->list),
                            .extrema = message_allocate(count, sizeof *grids->extrema),
                            .judges = options->judges};
    for (size_t i = 0; i < count; i++)
        share.all += 2 * count_cells(loaded->scene, i);
    settings.progress = report_share;
    settings.progress_data = &share;
    progress_begin(&progress, options->quiet);
    if (progress.wanted || options->keeps || settings.within > 0.0)
        settings.enough = report_bound;
    while (status == LUXEL_OK && grids->count < count) {
        const size_t i = grids->count;

        share.own = count_cells(loaded->scene, i);
        settings.within = progress_share(count - i);
        status = luxel_find_grid(loaded->scene, &settings, i, loaded->diagnostics, &grids->list[i]);
        grids->count += status == LUXEL_OK;
        share.before += share.own;
        if (status == LUXEL_OK)
            status = luxel_find_grid_extrema(loaded->scene, &settings, i, loaded->diagnostics, &grids->extrema[i]);
        share.before += share.own;
    }
    if (status == LUXEL_OK && options->judges)
        status = observers_rate(loaded->scene, &options->settings, loaded->diagnostics, &grids->observers);
    progress_end(&progress);
    return status;
}

static void grids_clear(struct grids *grids)
{
    observers_clear(&grids->observers);
    for (size_t i = 0; i < grids->count; i++)
        luxel_grid_free(grids->list[i]);
    free(grids->list);
    free(grids->extrema);
}

static void print_json(const struct grids *grids)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "quantity", "irradiance");
    json_text(&json, "unit", grids->unit);
    json_open(&json, "grids", '[');
    for (size_t i = 0; i < grids->count; i++) {
        const struct judged judged = limits_of_grid(grids->scene, i, grids->list[i]);

        grid_write_json(&json, grids->list[i], &grids->extrema[i], &judged);
    }
    json_close(&json, ']');
    if (grids->judges)
        observers_write(&json, &grids->observers);
    result_write_conventions(&json, grids->scene, &of_planes);
    json_close(&json, '}');
}

/* "floor", or "grid 2". */
static void print_name(const luxel_grid *grid, size_t i)
{
    if (grid->name)
        text_print_escaped(stdout, grid->name);
    else
        printf(_("grid %zu"), i + 1);
}

static void print_plane(const luxel_grid *grid)
{
    char center[TEXT_SIZE], width[TEXT_SIZE], height[TEXT_SIZE];
    const double *axis = grid->axis, *up = grid->up;

    printf(_(": %u × %u cells, %s × %s mm around %s\n"), grid->columns, grid->rows,
           text_length(grid->size_mm[0], width), text_length(grid->size_mm[1], height),
           text_lengths(grid->center_mm, 3, center));
    printf(_("  normal (%.6g, %.6g, %.6g), up (%.6g, %.6g, %.6g)\n\n"), axis[0] + 0.0, axis[1] + 0.0, axis[2] + 0.0,
           up[0] + 0.0, up[1] + 0.0, up[2] + 0.0);
    grid_measure_print(grid);
}

/* The values as the plane is seen from its front, with the numbers of the columns above and of the rows at the left. */
static void print_values(const luxel_grid *grid)
{
    char alignment[MOST_COLUMNS + 2] = {0}, numbers[MOST_COLUMNS + 1][TEXT_SIZE];
    const char *cells[MOST_COLUMNS + 1] = {""};
    struct text_table *table;

    for (unsigned i = 0; i <= grid->columns; i++)
        alignment[i] = 'r';
    table = text_table_new(alignment);
    for (unsigned column = 0; column < grid->columns; column++)
        cells[column + 1] = text_format(numbers[column + 1], "%u", column);
    text_table_row(table, cells);
    for (unsigned row = 0; row < grid->rows; row++) {
        cells[0] = text_format(numbers[0], "%u", row);
        for (unsigned column = 0; column < grid->columns; column++) {
            const size_t cell = (size_t)row * grid->columns + column;

            text_format(numbers[column + 1], grid->mask[cell] ? "%.5g" : "-", grid->values[cell]);
            cells[column + 1] = numbers[column + 1];
        }
        text_table_row(table, cells);
    }
    text_table_print(table, stdout, 2);
    fputc('\n', stdout);
}

static void add_number(struct text_table *table, const char *name, bool exists, double value)
{
    char number[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name, exists ? text_value(number, 6, value) : _("none"), "", ""));
}

static void add_extremum(struct text_table *table, const char *name, const luxel_grid *grid,
                         const luxel_grid_extremum *extremum)
{
    char value[TEXT_SIZE], cell[TEXT_SIZE], position[TEXT_SIZE];

    if (grid->measured == 0) {
        add_number(table, name, false, 0.0);
        return;
    }
    text_table_row(table, TEXT_CELLS(name, text_value(value, 6, extremum->value),
                                     text_format(cell, "(%u, %u)", extremum->column, extremum->row),
                                     text_lengths(extremum->position_mm, 3, position)));
}

/* An extremum between the points, with its bound. */
static void add_peak(struct text_table *table, const char *name, const luxel_grid_peak *peak)
{
    char value[TEXT_SIZE], bound[TEXT_SIZE], cell[TEXT_SIZE], position[TEXT_SIZE];

    if (peak->exists)
        text_table_row(table, TEXT_CELLS(name, text_bounded(value, 6, peak->value, peak->error),
                                         text_format(cell, "± %s", text_bound(bound, 6, peak->value, peak->error)),
                                         text_lengths(peak->position_mm, 3, position)));
}

/* A number in as many digits as may hold, with its bound. */
static void add_bounded(struct text_table *table, const char *name, double value, double error)
{
    char number[TEXT_SIZE], bound[TEXT_SIZE], cell[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name, text_bounded(number, 9, value, error),
                                     text_format(cell, "± %s", text_bound(bound, 9, value, error)), ""));
}

/* How far the average of the values is from the mean over the plane. */
static void add_sampling(struct text_table *table, const luxel_grid *grid)
{
    const double size = fabs(grid->has_mean ? grid->mean.value : grid->average.value);
    char number[TEXT_SIZE], share[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(grid->sampling_is_bound ? _("average of the values off the mean by at most")
                                                             : _("average of the values off the mean by about"),
                                     text_error(grid->sampling_error, number),
                                     size > 0.0 ? text_format(share, "%.2g %%",
                                                              luxel_round_bound(100.0 * grid->sampling_error / size, 2))
                                                : "",
                                     ""));
}

static void print_statistics(const luxel_grid *grid, const luxel_grid_extrema *extrema)
{
    struct text_table *table = text_table_new("lrrr");
    char heading[TEXT_SIZE], flux[TEXT_SIZE], error[TEXT_SIZE];
    const bool measured = grid->measured > 0;

    text_format(heading, _("value (%s)"), _(grid->unit));
    text_table_row(table, TEXT_CELLS("", heading, _("cell (column, row)"), _("position x, y, z (mm)")));
    add_number(table, _("average of the values"), measured, grid->average.value);
    add_extremum(table, _("minimum"), grid, &grid->minimum);
    add_extremum(table, _("maximum"), grid, &grid->maximum);
    add_peak(table, _("minimum on the whole plane"), &extrema->minimum);
    add_peak(table, _("maximum on the whole plane"), &extrema->maximum);
    text_table_row(table, TEXT_CELLS(_("error of the values at most"),
                                     measured ? text_error(grid->error, error) : _("none"), "", ""));
    add_number(table, _("U0 = minimum / average of the values"), grid->has_evenness, grid->u0);
    add_number(table, _("Ud = minimum / maximum of the values"), grid->has_evenness, grid->ud);
    grid_measure_add(table, grid);
    grid_areas_add(table, grid);
    if (grid->has_mean)
        add_bounded(table, _("mean over the plane, whatever its cells"), grid->mean.value, grid->mean.error);
    if (grid->flux_unit) {
        text_format(flux, _("flux through the plane (%s)"), _(grid->flux_unit));
        add_bounded(table, flux, grid->flux.value, grid->flux.error);
    }
    if (grid->has_sampling_error)
        add_sampling(table, grid);
    text_table_print(table, stdout, 2);
}

static void print_grid(const luxel_grid *grid, const luxel_grid_extrema *extrema, const struct judged *judged, size_t i)
{
    const size_t without = (size_t)grid->columns * grid->rows - grid->measured - grid->enclosed;

    print_name(grid, i);
    print_plane(grid);
    if (grid->columns <= MOST_COLUMNS && grid->rows <= MOST_ROWS)
        print_values(grid);
    print_statistics(grid, extrema);
    limits_print(judged, grid->unit);
    if (grid->colors && grid->measured > 0)
        grid_color_print(grid, extrema);
    if (without > 0)
        printf(ngettext("  %zu cell lies on a source, lights[%zu], and has no value\n",
                        "  %zu cells lie on a source, the first of them on lights[%zu], and have no value\n", without),
               without, grid->blocking_light);
    if (grid->enclosed > 0)
        printf(ngettext("  %zu cell is inside a body, that of surfaces[%zu], and is left out\n",
                        "  %zu cells are inside bodies, the first of them in that of surfaces[%zu], and are left out\n",
                        grid->enclosed),
               grid->enclosed, grid->enclosing_surface);
    if (grid->columns > MOST_COLUMNS || grid->rows > MOST_ROWS)
        printf(_("  too many values for a table: --json prints them, -o FILE.csv writes them\n"));
    fputc('\n', stdout);
}

static void print_text(const struct grids *grids, const char *name)
{
    text_print_escaped(stdout, name);
    printf(_(": %s in %s\n\n"), _(luxel_scene_quantity_word(grids->scene, LUXEL_IRRADIANCE)), text_unit(grids->unit));
    for (size_t i = 0; i < grids->count; i++) {
        const struct judged judged = limits_of_grid(grids->scene, i, grids->list[i]);

        print_grid(grids->list[i], &grids->extrema[i], &judged, i);
    }
    observers_print(&grids->observers);
    result_print_conventions(grids->scene, &of_planes);
}

/* A file that fails does not stop the others. */
static int write_outputs(const struct options *options, const struct grids *grids, luxel_diagnostics *diagnostics)
{
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status =
            luxel_grids_write((const luxel_grid *const *)grids->list, grids->count, options->outputs[i], diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
    }
    return code;
}

/* Whether the cells of a grid are as many as a rule wants. */
static bool has_spacing(const luxel_scene *scene, size_t i)
{
    char key[64], *spacing = NULL;
    bool is_there;

    snprintf(key, sizeof key, "grids[%zu].spacing", i);
    is_there = luxel_scene_get(scene, key, NULL, NULL, &spacing) == LUXEL_OK && spacing;
    luxel_text_free(spacing);
    return is_there;
}

/* What somebody who reads the average alone should know. */
static void warn(const luxel_scene *scene, const luxel_grid *grid, size_t i)
{
    const double size = fabs(grid->has_mean ? grid->mean.value : grid->average.value);
    char label[TEXT_SIZE], *name = grid->name ? luxel_escaped_text(grid->name) : NULL;

    if (name)
        text_format(label, "%s", name);
    else
        text_format(label, _("grid %zu"), i + 1);
    luxel_text_free(name);
    if (grid->is_coarse && has_spacing(scene, i))
        message_note(
            _("note: %s: the average of the %u × %u values, spaced by its rule, is off the mean over the plane "
              "by %.2g %%"),
            label, grid->columns, grid->rows, 100.0 * grid->sampling_error / size);
    else if (grid->is_coarse)
        message_note(_("warning: %s: %u × %u cells are too coarse for this light: the average of the values is off the "
                       "mean over the plane by %.2g %%; raise n"),
                     label, grid->columns, grid->rows, 100.0 * grid->sampling_error / size);
    if (grid->enclosed > 0)
        message_note(ngettext("warning: %s: %zu cell is inside the body of surfaces[%zu] and is left out",
                              "warning: %s: %zu cells are inside bodies, the first of them in that of surfaces[%zu], "
                              "and are left out",
                              grid->enclosed),
                     label, grid->enclosed, grid->enclosing_surface);
}

static int finish(const struct options *options, const struct loaded *loaded, const struct grids *grids)
{
    const int code = write_outputs(options, grids, loaded->diagnostics);
    size_t missed = 0;

    for (size_t i = 0; i < grids->count; i++)
        missed += !(grids->list[i]->tolerance_reached && grids->list[i]->reflected_reached);
    if (options->json)
        print_json(grids);
    else if (standard_output_is_free(options))
        print_text(grids, loaded->name);
    for (size_t i = 0; i < grids->count && !options->quiet; i++)
        warn(loaded->scene, grids->list[i], i);
    if (missed > 0)
        message_tolerance(missed, grids->count);
    if (code == EXIT_DONE && options->judges &&
        !limits_all_pass(grids->scene, (const luxel_grid *const *)grids->list, grids->count, &grids->observers))
        return EXIT_DIFFERENCE;
    return code == EXIT_DONE && missed > 0 ? EXIT_TOLERANCE : code;
}

static int grid(const struct options *options, const struct loaded *loaded)
{
    struct grids grids;
    luxel_status status;
    int code;

    if (options->judges && !limits_can_judge(loaded))
        return EXIT_SCENE;
    if (luxel_scene_grid_count(loaded->scene) == 0 && !options->judges) {
        message_error(_("%s has no measuring grids"), loaded->name);
        message_hint(_("add some under the key grids, or try %s"),
                     "-s 'grids=[{center: [0,0,0], size: [1000,1000], n: [10,10]}]'");
        return EXIT_USAGE;
    }
    status = measure(options, loaded, &grids);
    code = status == LUXEL_OK ? finish(options, loaded, &grids) : message_failure(status, loaded->diagnostics);
    grids_clear(&grids);
    return code;
}

static int run(const struct options *options)
{
    int code;

    if (options_given(options, "quantity") && options->settings.quantity != LUXEL_IRRADIANCE) {
        message_error(_("luxel grid measures the irradiance: a measuring plane has no material to be bright by"));
        return EXIT_USAGE;
    }
    code = outputs_check(options, luxel_check_grid_output_name);
    return code == EXIT_DONE ? load_and(options, grid) : code;
}

const struct command command_grid = {
    .name = "grid",
    .bit = COMMAND_GRID,
    .operand = N_("SCENE"),
    .endings = ".csv",
    .default_format = "csv",
    .summary = N_("measure the irradiance on planes and its uniformity"),
    .description = N_("Prints the irradiance at the centres of the cells of each measuring grid of the scene (its key "
                      "grids), seen from the front of the plane, with the average, the minimum, the maximum, the "
                      "extrema on the whole plane between the cells' centres, the uniformity and the flux "
                      "that falls on it. Cells inside of bodies, where no light shines, are told and left out. Where "
                      "a grid has limits each is a pass or a fail, or undecided where the bound of the number spans "
                      "the limit. Each FILE, of comma-separated values, appears whole or not at all."),
    .examples = "luxel grid room.yaml\n"
                "luxel grid room.yaml --json -o room.csv\n"
                "luxel grid room.yaml --limits\n"
                "luxel grid spot -s 'grids=[{center: [0,0,0], size: [1000,1000], n: [10,10]}]'",
    .run = run,
};
