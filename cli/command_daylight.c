/* SPDX-License-Identifier: MIT */
/* luxel daylight: daylight factors of measuring grids and free elements, and the shares of area of EN 17037. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "csv.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "outputs.h"
#include "places.h"
#include "standard_output.h"
#include "sun.h"
#include "text.h"
#include "work.h"

/* Larger grids are not printed as a table: lines would not fit, and nobody reads them. */
enum { MOST_COLUMNS = 20, MOST_ROWS = 100 };

/*
 * The recommendations of EN 17037: lx that half of a plane is to reach and that 95 % of it are, both for half of the
 * hours of daylight.
 */
enum { STEPS = 3 };
static const struct step {
    const char *name, *word;
    size_t half, most; /* of luxel_daylight_level() */
} steps[STEPS] = {{"minimum", N_("minimum"), 1, 0}, {"medium", N_("medium"), 2, 1}, {"high", N_("high"), 3, 2}};

/* How many of them a grid keeps, the lowest first. */
static int steps_kept(const luxel_daylight_grid *grid)
{
    int kept = 0;

    while (kept < STEPS && grid->shares[steps[kept].half] >= 0.5 && grid->shares[steps[kept].most] >= 0.95)
        kept++;
    return kept;
}

/* The share of the cells from which no sky is seen: behind the no-sky line. */
static double share_without_sky(const luxel_daylight_grid *grid)
{
    size_t count = 0;

    for (size_t i = 0; i < (size_t)grid->columns * grid->rows; i++) {
        const luxel_daylight_factor *cell = &grid->cells[i];

        count += cell->has_value && !(cell->sky.value + cell->sky.error > 0.0);
    }
    return (double)count / (double)grid->measured;
}

/* ---- JSON ---- */

static void write_cells(struct json *json, const char *key, const luxel_daylight_grid *grid, size_t offset, bool error)
{
    json_open(json, key, '[');
    for (unsigned row = 0; row < grid->rows; row++) {
        json_open(json, NULL, '[');
        for (unsigned column = 0; column < grid->columns; column++) {
            const luxel_daylight_factor *cell = &grid->cells[(size_t)row * grid->columns + column];
            const luxel_bounded *number = (const luxel_bounded *)((const char *)cell + offset);

            if (cell->has_value)
                json_number(json, NULL, error ? number->error : number->value);
            else
                json_null(json, NULL);
        }
        json_close(json, ']');
    }
    json_close(json, ']');
}

static void write_grid(struct json *json, const luxel_daylight *found, const luxel_daylight_grid *grid)
{
    const int kept = steps_kept(grid);

    json_open(json, NULL, '{');
    json_text(json, "name", grid->name);
    write_cells(json, "values", grid, offsetof(luxel_daylight_factor, value), false);
    write_cells(json, "errors", grid, offsetof(luxel_daylight_factor, value), true);
    write_cells(json, "sky", grid, offsetof(luxel_daylight_factor, sky), false);
    write_cells(json, "external", grid, offsetof(luxel_daylight_factor, external), false);
    write_cells(json, "internal", grid, offsetof(luxel_daylight_factor, internal), false);
    json_number_if(json, "mean", grid->measured > 0, grid->mean.value);
    json_number_if(json, "mean_error", grid->measured > 0, grid->mean.error);
    json_number_if(json, "median", grid->measured > 0, grid->median.value);
    json_number_if(json, "median_error", grid->measured > 0, grid->median.error);
    json_number_if(json, "without_sky", grid->measured > 0, share_without_sky(grid));
    if (isfinite(found->outdoor) && grid->measured > 0) {
        json_open(json, "en17037", '{');
        json_number(json, "outdoor", found->outdoor);
        json_open(json, "shares", '{');
        for (size_t i = 0; i < LUXEL_DAYLIGHT_LEVELS; i++) {
            char key[TEXT_SIZE];

            json_number(json, text_format(key, "%g", luxel_daylight_level(i)), grid->shares[i]);
        }
        json_close(json, '}');
        json_text(json, "level", kept > 0 ? steps[kept - 1].name : NULL);
        json_close(json, '}');
    }
    json_close(json, '}');
}

static void write_element(struct json *json, const luxel_daylight_factor *element)
{
    json_open(json, NULL, '{');
    json_number_if(json, "daylight_factor", element->has_value, element->value.value);
    json_number_if(json, "error", element->has_value, element->value.error);
    json_number_if(json, "sky", element->has_value, element->sky.value);
    json_number_if(json, "external", element->has_value, element->external.value);
    json_number_if(json, "internal", element->has_value, element->internal.value);
    json_close(json, '}');
}

static void print_json(const luxel_scene *scene, const luxel_daylight *found)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "unit", "%");
    json_open(&json, "horizontal", '{');
    json_number(&json, "value", found->horizontal.value);
    json_number(&json, "error", found->horizontal.error);
    json_text(&json, "unit", luxel_scene_unit(scene, LUXEL_IRRADIANCE));
    json_close(&json, '}');
    json_open(&json, "grids", '[');
    for (size_t i = 0; i < found->grid_count; i++)
        write_grid(&json, found, &found->grids[i]);
    json_close(&json, ']');
    json_open(&json, "elements", '[');
    for (size_t i = 0; i < found->element_count; i++)
        write_element(&json, &found->elements[i]);
    json_close(&json, ']');
    json_close(&json, '}');
}

/* ---- text ---- */

static void print_values(const luxel_daylight_grid *grid)
{
    char alignment[MOST_COLUMNS + 2] = {0}, numbers[MOST_COLUMNS][TEXT_SIZE];
    const char *cells[MOST_COLUMNS] = {""};
    struct text_table *table;

    for (unsigned i = 0; i < grid->columns; i++)
        alignment[i] = 'r';
    table = text_table_new(alignment);
    for (unsigned row = 0; row < grid->rows; row++) {
        for (unsigned column = 0; column < grid->columns; column++) {
            const luxel_daylight_factor *cell = &grid->cells[(size_t)row * grid->columns + column];

            cells[column] = text_format(numbers[column], cell->has_value ? "%.4g" : "-", cell->value.value);
        }
        text_table_row(table, cells);
    }
    text_table_print(table, stdout, 2);
    fputc('\n', stdout);
}

static void print_shares(const luxel_daylight *found, const luxel_daylight_grid *grid)
{
    const int kept = steps_kept(grid);

    printf(_("  share of the cells for certain at %.6g lx under the open sky:"), found->outdoor);
    for (size_t i = 0; i < LUXEL_DAYLIGHT_LEVELS; i++)
        printf(_("%s %g lx %.1f %%"), i > 0 ? "," : "", luxel_daylight_level(i), 100.0 * grid->shares[i]);
    printf(kept > 0 ? _("\n  EN 17037: %s\n") : _("\n  EN 17037: not kept\n"), kept > 0 ? _(steps[kept - 1].word) : "");
}

static void print_grid(const luxel_daylight *found, size_t i)
{
    const luxel_daylight_grid *grid = &found->grids[i];
    char mean[TEXT_SIZE], median[TEXT_SIZE];

    fputc('\n', stdout);
    if (grid->name)
        text_print_escaped(stdout, grid->name);
    else
        printf(_("grid %zu"), i + 1);
    printf(_(": %u × %u cells, daylight factor in %%\n\n"), grid->columns, grid->rows);
    if (grid->columns <= MOST_COLUMNS && grid->rows <= MOST_ROWS)
        print_values(grid);
    if (grid->measured == 0)
        return;
    printf(_("  mean %s %%, median %s %%\n"), text_value_bound(mean, 6, grid->mean.value, grid->mean.error),
           text_value_bound(median, 6, grid->median.value, grid->median.error));
    printf(_("  no sky is seen from %.1f %% of the cells\n"), 100.0 * share_without_sky(grid));
    if (isfinite(found->outdoor))
        print_shares(found, grid);
}

static void print_elements(const luxel_daylight *found)
{
    struct text_table *table = text_table_new("lrrrr");

    text_table_row(table, TEXT_CELLS(_("element"), _("daylight factor, %"), _("sky"), _("external"), _("internal")));
    for (size_t i = 0; i < found->element_count; i++) {
        const luxel_daylight_factor *element = &found->elements[i];
        char name[TEXT_SIZE], value[TEXT_SIZE], sky[TEXT_SIZE], external[TEXT_SIZE], internal[TEXT_SIZE];

        text_format(name, "P%zu", i + 1);
        text_table_row(table, TEXT_CELLS(name,
                                         element->has_value
                                             ? text_value_bound(value, 8, element->value.value, element->value.error)
                                             : _("none"),
                                         text_format(sky, "%.5g", element->sky.value),
                                         text_format(external, "%.5g", element->external.value),
                                         text_format(internal, "%.5g", element->internal.value)));
    }
    fputc('\n', stdout);
    text_table_print(table, stdout, 2);
}

static void print_text(const struct loaded *loaded, const luxel_daylight *found)
{
    char horizontal[TEXT_SIZE];

    text_print_escaped(stdout, loaded->name);
    printf(_(": daylight factors; %s %s on a horizontal plane under the open sky\n"),
           text_value_bound(horizontal, 8, found->horizontal.value, found->horizontal.error),
           text_unit(luxel_scene_unit(loaded->scene, LUXEL_IRRADIANCE)));
    for (size_t i = 0; i < found->grid_count; i++)
        print_grid(found, i);
    if (found->element_count > 0)
        print_elements(found);
}

/* ---- tables ---- */

static void write_number(struct csv *csv, bool is_known, double number)
{
    if (is_known)
        csv_number(csv, number);
    else
        csv_blank(csv);
}

static void write_factor(struct csv *csv, const luxel_daylight_factor *factor)
{
    write_number(csv, factor->has_value, factor->value.value);
    write_number(csv, factor->has_value, factor->value.error);
    write_number(csv, factor->has_value, factor->sky.value);
    write_number(csv, factor->has_value, factor->external.value);
    write_number(csv, factor->has_value, factor->internal.value);
    csv_end_line(csv);
}

/* A line for each cell of the grids, then one for each element, P1 and so on, whose column and row are blank. */
static void write_table(struct csv *csv, const void *data)
{
    static const char *const places[] = {"grid", "column", "row"}, *const factors[] = {"daylight_factor", "error",
                                                                                       "sky", "external", "internal"};
    const luxel_daylight *found = data;
    char name[TEXT_SIZE];

    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        csv_text(csv, places[i]);
    for (size_t i = 0; i < sizeof factors / sizeof *factors; i++)
        csv_heading(csv, factors[i], "%");
    csv_end_line(csv);
    for (size_t i = 0; i < found->grid_count; i++) {
        const luxel_daylight_grid *grid = &found->grids[i];

        for (size_t cell = 0; cell < (size_t)grid->columns * grid->rows; cell++) {
            csv_text(csv, grid->name ? grid->name : "");
            csv_whole(csv, cell % grid->columns);
            csv_whole(csv, cell / grid->columns);
            write_factor(csv, &grid->cells[cell]);
        }
    }
    for (size_t i = 0; i < found->element_count; i++) {
        csv_text(csv, text_format(name, "P%zu", i + 1));
        csv_blank(csv);
        csv_blank(csv);
        write_factor(csv, &found->elements[i]);
    }
}

/* ---- the command ---- */

static int find_factors(const struct options *options, const struct loaded *loaded, const struct places *places)
{
    struct work work;
    luxel_daylight *found = NULL;

    work_begin(&work, options);
    const luxel_status status = luxel_find_daylight(loaded->scene, &work.settings, places->list, places->count,
                                                    options->outdoor, loaded->diagnostics, &found);
    int code = work_end(&work, status, loaded->diagnostics);

    if (code == EXIT_DONE) {
        code = csv_write(options, write_table, found);
        if (options->json)
            print_json(loaded->scene, found);
        else if (options->csv == CSV_NONE && standard_output_is_free(options))
            print_text(loaded, found);
        if (!found->reached) {
            message_error(_("daylight factors are not known as well as asked for; the bounds hold"));
            code = EXIT_TOLERANCE;
        }
    }
    luxel_daylight_free(found);
    return code;
}

static int find(const struct options *options, const struct loaded *loaded)
{
    struct places places = {.list = NULL};
    int code = EXIT_DONE;

    if (options->sun.patches)
        return sun_print_patches(options, loaded);
    if (options->place_count > 0)
        code = places_collect(options, loaded->scene, loaded->diagnostics, &places);
    if (code == EXIT_DONE && options->place_count == 0 && luxel_scene_grid_count(loaded->scene) == 0) {
        message_error(_("%s has no measuring grids"), loaded->name);
        message_hint(_("give it some by its key grids, or name elements with --at X,Y,Z,NX,NY,NZ or --points FILE"));
        code = EXIT_USAGE;
    }
    if (code == EXIT_DONE)
        code = options->sun.day ? sun_print_hours(options, loaded, &places) : find_factors(options, loaded, &places);
    places_clear(&places);
    return code;
}

static int run(const struct options *options)
{
    int code = sun_check_options(options);

    if (code == EXIT_DONE)
        code = outputs_check(options, outputs_check_csv);
    return code == EXIT_DONE ? load_and(options, find) : code;
}

const struct command command_daylight = {
    .name = "daylight",
    .bit = COMMAND_DAYLIGHT,
    .operand = N_("SCENE"),
    .endings = ".csv",
    .default_format = "csv",
    .summary = N_("daylight factors, hours of sun and patches of sun"),
    .description = N_(
        "Prints what share of the light that a horizontal plane has under the open sky reaches the cells of the "
        "scene's measuring grids, and free elements, in percent with bounds: the daylight factor, of which parts come "
        "from the sky, from the ground, and from surfaces that reflect (the scene's key reflections). The sun and "
        "lamps do not count. For each grid it prints the mean, the median, the share of its cells from which no sky is "
        "seen and, by EN 17037, of those that reach 100, 300, 500 and 750 lx. -o writes a table of all cells and "
        "elements. With --sun-hours it prints instead when, on a day, the sun's middle shines on the front of each of "
        "them, past all surfaces and through openings with glass or none, how long together, and what of EN 17037 that "
        "keeps: 1.5 h of sun, medium 3 h, high 4 h. With --sun-patches it prints on which parts of rectangles, boxes "
        "and rooms the scene's sun shines, by whose openings, as polygons with their areas, less the shadows of all "
        "that "
        "is flat; what else may take some of a patch is named."),
    .examples = "luxel daylight room.yaml\n"
                "luxel daylight room.yaml --outdoor 13900 --json\n"
                "luxel daylight room.yaml -o factors.csv\n"
                "luxel daylight room.yaml --at 0,0,850,0,0,1\n"
                "luxel daylight room.yaml --sun-hours 2026-03-21+01:00 --location 52.5,13.4 --at 1990,0,1200,1,0,0\n"
                "luxel daylight room.yaml --sun-patches --json",
    .run = run,
};
