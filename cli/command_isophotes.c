/* SPDX-License-Identifier: MIT */
/* luxel isophotes: the lines of equal value on what the screen shows, or on the plane of a measuring grid. */
#include <luxel/luxel.h>

#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "csv.h"
#include "grid_named.h"
#include "json.h"
#include "message.h"
#include "outputs.h"
#include "picture.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

enum { DEFAULT_LEVELS = 8 };

struct drawing {
    const struct picture *picture; /* of a grid's plane the field on that */
    luxel_grid *grid;              /* NULL: the lines are those of the screen */
    size_t number;                 /* of the grid, from 1 on */
    double levels[OPTION_LEVELS];
    size_t level_count;
    bool from_picture; /* the lines are straight between the pixels' values */
    luxel_isophotes *isophotes;
};

/* The screen is no plane of the scene, and nobody looks through it at a grid. */
static luxel_conventions_use conventions_of(const struct drawing *drawing)
{
    return drawing->grid ? (luxel_conventions_use){.screen = false}
                         : result_use_of_screen(&drawing->picture->options, drawing->from_picture);
}

/* The levels that were given, or round ones within the picture's range. */
static void choose_levels(struct drawing *drawing)
{
    const struct option_analysis *analysis = &drawing->picture->options.analysis;
    const luxel_statistics *statistics = luxel_field_statistics(drawing->picture->field);
    const size_t wanted = analysis->wanted_levels > 0 ? analysis->wanted_levels : DEFAULT_LEVELS;
    double low = analysis->scale[0], high = analysis->scale[1];

    if (analysis->level_count > 0) {
        drawing->level_count = analysis->level_count;
        for (size_t i = 0; i < analysis->level_count; i++)
            drawing->levels[i] = analysis->levels[i];
        return;
    }
    if (isnan(low)) {
        low = 0.0;
        high = statistics->maximum.exists ? statistics->maximum.value : 0.0;
    }
    drawing->level_count = luxel_round_levels(low, high, analysis->logarithmic, wanted, drawing->levels, OPTION_LEVELS);
}

/* Exact values under area lights take thousands of times what pixels do; figures take their lines from these, too. */
static bool is_costly(const struct drawing *drawing, const luxel_evaluator *evaluator)
{
    return luxel_evaluator_integrates(evaluator) && !drawing->picture->options.analysis.exact;
}

static int compute(struct drawing *drawing)
{
    const struct picture *picture = drawing->picture;
    const bool exact = picture->loaded.scene && !picture->options.analysis.from_picture;
    luxel_diagnostics *diagnostics = picture->loaded.diagnostics;
    luxel_evaluator *evaluator = NULL;
    luxel_status status = LUXEL_OK;
    struct work work;
    int code;

    choose_levels(drawing);
    work_begin(&work, &picture->options);
    if (exact)
        status = luxel_evaluator_new(picture->loaded.scene, &work.settings, diagnostics, &evaluator);
    drawing->from_picture = status == LUXEL_OK && (!evaluator || is_costly(drawing, evaluator));
    if (status == LUXEL_OK)
        status = luxel_find_isophotes(picture->field, drawing->from_picture ? NULL : evaluator, drawing->levels,
                                      drawing->level_count, diagnostics, &drawing->isophotes);
    luxel_evaluator_free(evaluator);
    code = work_end(&work, status, diagnostics);
    if (exact && drawing->from_picture && code == EXIT_DONE && !picture->options.quiet)
        message_note(_("under area lights the lines are those of the picture's pixels; --exact takes exact values"));
    return code;
}

/* Along the chords between the vertices. */
static double length_of(const luxel_isophote *line)
{
    double length = 0.0;

    for (size_t i = 1; i < line->count; i++)
        length += hypot(line->x_mm[i] - line->x_mm[i - 1], line->y_mm[i] - line->y_mm[i - 1]);
    if (line->closed)
        length += hypot(line->x_mm[0] - line->x_mm[line->count - 1], line->y_mm[0] - line->y_mm[line->count - 1]);
    return length;
}

/* "office.yaml: illuminance in lx on the plane of desk", or of its number. */
static void print_grid_heading(const struct drawing *drawing)
{
    char label[TEXT_SIZE], *name = drawing->grid->name ? luxel_escaped_text(drawing->grid->name) : NULL;

    if (!name)
        text_format(label, _("grid %zu"), drawing->number);
    text_print_escaped(stdout, drawing->picture->loaded.name);
    printf(_(": %s in %s on the plane of %s\n\n"), _(picture_quantity(drawing->picture)),
           text_unit(picture_unit(drawing->picture)), name ? name : label);
    luxel_text_free(name);
}

static void print_text(const struct drawing *drawing)
{
    const luxel_conventions_use use = conventions_of(drawing);
    const char *unit = picture_unit(drawing->picture);
    struct text_table *table = text_table_new("rrlr");
    char heading[TEXT_SIZE];

    if (drawing->grid)
        print_grid_heading(drawing);
    else
        picture_print_heading(drawing->picture);
    text_table_row(table, TEXT_CELLS(*unit ? text_format(heading, _("level (%s)"), _(unit)) : _("level"), _("vertices"),
                                     "", _("length (mm)")));
    for (size_t i = 0; i < drawing->isophotes->count; i++) {
        const luxel_isophote *line = &drawing->isophotes->lines[i];
        char level[TEXT_SIZE], vertices[TEXT_SIZE], length[TEXT_SIZE];

        text_table_row(table, TEXT_CELLS(text_value(level, 9, line->level), text_format(vertices, "%zu", line->count),
                                         line->closed ? _("closed") : _("open"),
                                         text_format(length, "%.3f", length_of(line))));
    }
    text_table_print(table, stdout, 2);
    if (drawing->isophotes->count == 0)
        printf(_("  no value of the picture crosses a level\n"));
    if (drawing->picture->loaded.scene) {
        fputc('\n', stdout);
        result_print_conventions(drawing->picture->loaded.scene, &use);
    }
}

/* A vertex on the screen or, of a grid, in space: returns how many numbers there are. */
static size_t vertex_of(const luxel_grid *grid, const luxel_isophote *line, size_t i, double place[3])
{
    place[0] = line->x_mm[i];
    place[1] = line->y_mm[i];
    for (int k = 0; grid && k < 3; k++)
        place[k] = grid->center_mm[k] + line->x_mm[i] * grid->across[k] + line->y_mm[i] * grid->up[k];
    return grid ? 3 : 2;
}

static void write_line(struct json *json, const luxel_grid *grid, const luxel_isophote *line)
{
    double place[3];

    json_open(json, NULL, '{');
    json_number(json, "level", line->level);
    json_bool(json, "closed", line->closed);
    json_open(json, "vertices", '[');
    for (size_t i = 0; i < line->count; i++)
        json_numbers(json, NULL, place, vertex_of(grid, line, i, place));
    json_close(json, ']');
    json_close(json, '}');
}

static void print_json(const struct drawing *drawing)
{
    const luxel_conventions_use use = conventions_of(drawing);
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "quantity", picture_quantity_name(drawing->picture));
    json_text(&json, "unit", picture_unit(drawing->picture));
    if (drawing->grid)
        json_text(&json, "grid", drawing->grid->name);
    json_numbers(&json, "levels", drawing->levels, drawing->level_count);
    json_open(&json, "lines", '[');
    for (size_t i = 0; i < drawing->isophotes->count; i++)
        write_line(&json, drawing->grid, &drawing->isophotes->lines[i]);
    json_close(&json, ']');
    if (drawing->picture->loaded.scene)
        result_write_conventions(&json, drawing->picture->loaded.scene, &use);
    json_close(&json, '}');
}

static void write_csv(struct csv *csv, const void *data)
{
    const struct drawing *drawing = data;

    csv_text(csv, "line");
    csv_heading(csv, "level", picture_unit(drawing->picture));
    csv_text(csv, "closed");
    csv_text(csv, "x_mm");
    csv_text(csv, "y_mm");
    if (drawing->grid)
        csv_text(csv, "z_mm");
    csv_end_line(csv);
    for (size_t i = 0; i < drawing->isophotes->count; i++) {
        const luxel_isophote *line = &drawing->isophotes->lines[i];

        for (size_t k = 0; k < line->count; k++) {
            double place[3];
            const size_t count = vertex_of(drawing->grid, line, k, place);

            csv_whole(csv, i + 1);
            csv_number(csv, line->level);
            csv_whole(csv, line->closed);
            for (size_t c = 0; c < count; c++)
                csv_number(csv, place[c]);
            csv_end_line(csv);
        }
    }
}

/* What is computed goes to files and to standard output. */
static int show(const struct options *options, const struct drawing *drawing)
{
    const int code = csv_write(options, write_csv, drawing);

    if (options->json)
        print_json(drawing);
    else if (options->csv == CSV_NONE && standard_output_is_free(options))
        print_text(drawing);
    return code;
}

/* ---- planes of grids ---- */

static luxel_status measure(struct picture *picture, struct drawing *drawing, size_t i, const luxel_settings *settings)
{
    const luxel_scene *scene = picture->loaded.scene;
    luxel_diagnostics *diagnostics = picture->loaded.diagnostics;
    luxel_status status = luxel_find_grid_values(scene, settings, i, diagnostics, &drawing->grid);

    if (status == LUXEL_OK)
        status = luxel_find_grid_field(scene, settings, i, 0, 0, diagnostics, &picture->field);
    if (status != LUXEL_OK)
        return status;
    choose_levels(drawing);
    return luxel_find_grid_isophotes(scene, settings, i, picture->field, drawing->levels, drawing->level_count,
                                     diagnostics, &drawing->isophotes);
}

/* Drawings by the library; tables, with what goes to standard output, here. */
static int write_plane(const struct options *options, struct drawing *drawing)
{
    const luxel_grid *const grids[] = {drawing->grid};
    const luxel_isophotes *const lines[] = {drawing->isophotes};
    const char **tables = message_allocate(options->output_count, sizeof *tables);
    struct options others = *options;
    int code = EXIT_DONE;

    others.outputs = tables;
    others.output_count = 0;
    for (size_t i = 0; i < options->output_count; i++) {
        luxel_diagnostics *diagnostics = drawing->picture->loaded.diagnostics;
        luxel_status status = LUXEL_OK;

        if (outputs_check_csv(options->outputs[i], NULL) == LUXEL_OK)
            tables[others.output_count++] = options->outputs[i];
        else
            status = luxel_grid_isophotes_write(grids, lines, 1, options->outputs[i], diagnostics);
        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
    }
    const int of_tables = show(&others, drawing);
    free(tables);
    return of_tables == EXIT_DONE ? code : of_tables;
}

static int draw_plane(const struct options *options, const struct loaded *loaded)
{
    struct picture picture = {.loaded = *loaded, .options = *options};
    struct drawing drawing = {.picture = &picture, .number = grid_named(options->drawing.grid, loaded)};
    struct work work;
    int code;

    if (drawing.number == 0)
        return EXIT_USAGE;
    picture.options.settings.quantity = LUXEL_IRRADIANCE;
    work_begin(&work, options);
    code = work_end(&work, measure(&picture, &drawing, drawing.number - 1, &work.settings), loaded->diagnostics);
    if (code == EXIT_DONE)
        code = write_plane(options, &drawing);
    luxel_isophotes_free(drawing.isophotes);
    luxel_field_free(picture.field);
    luxel_grid_free(drawing.grid);
    return code;
}

static luxel_status check_plane_name(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".csv", ".dxf"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}

/* Whether all that is asked for can be found on the plane of a grid; if not, says what cannot. */
static bool suits_plane(const struct options *options)
{
    if (options->analysis.from_picture || options->analysis.exact)
        message_error(_("--picture and --exact are of the picture: the lines of a grid are those between its values"));
    else if (options_given(options, "quantity") && options->settings.quantity != LUXEL_IRRADIANCE)
        message_error(_("luxel grid measures the irradiance: a measuring plane has no material to be bright by"));
    else
        return true;
    return false;
}

/* ---- the command ---- */

static int run(const struct options *options)
{
    const bool is_plane = options->drawing.grid;
    struct picture picture = {.field = NULL};
    struct drawing drawing = {.picture = &picture};
    int code;

    if (is_plane && !suits_plane(options))
        return EXIT_USAGE;
    code = outputs_check(options, is_plane ? check_plane_name : outputs_check_csv);
    if (code != EXIT_DONE)
        return code;
    if (is_plane)
        return load_and(options, draw_plane);
    code = picture_open(options, options->operand, &picture);
    if (code == EXIT_DONE)
        code = compute(&drawing);
    if (code == EXIT_DONE)
        code = show(options, &drawing);
    luxel_isophotes_free(drawing.isophotes);
    if (code == EXIT_DONE)
        code = picture.code;
    picture_close(&picture);
    return code;
}

const struct command command_isophotes = {
    .name = "isophotes",
    .bit = COMMAND_ISOPHOTES,
    .operand = N_("SCENE"),
    .endings = ".csv .dxf",
    .default_format = "csv",
    .summary = N_("lines of equal value on the screen or a measuring grid"),
    .description =
        N_("Finds the lines along which the picture has one value, at round levels or at those given, "
           "each vertex on its level to 1e-9. With --picture, where SCENE is a file of values that "
           "gives the places of its pixels (.csv, or an .exr that Luxel wrote), and under area lights "
           "(planar, volume, openings of luminaires), they are those of the pixels, with straight lines "
           "between them; --exact has vertices on exact values there, too, which takes ten seconds and more. "
           "With --grid they are isolux lines on the plane of a measuring grid, in the coordinates of the scene: a "
           ".dxf has them for programs of computer-aided design, in mm, each level on a layer of its own."),
    .examples = "luxel isophotes my.yaml --levels 5\n"
                "luxel isophotes my.yaml --levels 0.5,1,2 --json\n"
                "luxel isophotes -o lines.csv --csv=excel-ru\n"
                "luxel isophotes office.yaml --grid desk --levels 200,300,500 -o isolux.dxf",
    .run = run,
};
