/* SPDX-License-Identifier: MIT */
/* luxel isophotes: the lines of equal value on what the screen shows. */
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
#include "work.h"

enum { DEFAULT_LEVELS = 8 };

struct drawing {
    const struct picture *picture;
    double levels[OPTION_LEVELS];
    size_t level_count;
    bool from_picture; /* the lines are straight between the pixels' values */
    luxel_isophotes *isophotes;
};

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

static void print_text(const struct drawing *drawing)
{
    const luxel_conventions_use use = result_use_of_screen(&drawing->picture->options, drawing->from_picture);
    const char *unit = picture_unit(drawing->picture);
    struct text_table *table = text_table_new("rrlr");
    char heading[TEXT_SIZE];

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

static void write_line(struct json *json, const luxel_isophote *line)
{
    json_open(json, NULL, '{');
    json_number(json, "level", line->level);
    json_bool(json, "closed", line->closed);
    json_open(json, "vertices", '[');
    for (size_t i = 0; i < line->count; i++)
        json_numbers(json, NULL, (const double[]){line->x_mm[i], line->y_mm[i]}, 2);
    json_close(json, ']');
    json_close(json, '}');
}

static void print_json(const struct drawing *drawing)
{
    const luxel_conventions_use use = result_use_of_screen(&drawing->picture->options, drawing->from_picture);
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "quantity", picture_quantity_name(drawing->picture));
    json_text(&json, "unit", picture_unit(drawing->picture));
    json_numbers(&json, "levels", drawing->levels, drawing->level_count);
    json_open(&json, "lines", '[');
    for (size_t i = 0; i < drawing->isophotes->count; i++)
        write_line(&json, &drawing->isophotes->lines[i]);
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
    csv_end_line(csv);
    for (size_t i = 0; i < drawing->isophotes->count; i++) {
        const luxel_isophote *line = &drawing->isophotes->lines[i];

        for (size_t k = 0; k < line->count; k++) {
            csv_whole(csv, i + 1);
            csv_number(csv, line->level);
            csv_whole(csv, line->closed);
            csv_number(csv, line->x_mm[k]);
            csv_number(csv, line->y_mm[k]);
            csv_end_line(csv);
        }
    }
}

static int run(const struct options *options)
{
    struct picture picture = {.field = NULL};
    struct drawing drawing = {.picture = &picture};
    int code = outputs_check(options, outputs_check_csv);

    if (code != EXIT_DONE)
        return code;
    code = picture_open(options, options->operand, &picture);
    if (code == EXIT_DONE)
        code = compute(&drawing);
    if (code == EXIT_DONE) {
        code = csv_write(options, write_csv, &drawing);
        if (options->json)
            print_json(&drawing);
        else if (options->csv == CSV_NONE && standard_output_is_free(options))
            print_text(&drawing);
    }
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
    .endings = ".csv",
    .default_format = "csv",
    .summary = N_("lines of equal value on the screen"),
    .description =
        N_("Finds the lines along which the picture has one value, at round levels or at those given, "
           "each vertex on its level to 1e-9. With --picture, where SCENE is a file of values that "
           "gives the places of its pixels (.csv, or an .exr that Luxel wrote), and under area lights "
           "(planar, volume, openings of luminaires), they are those of the pixels, with straight lines "
           "between them; --exact has vertices on exact values there, too, which takes ten seconds and more."),
    .examples = "luxel isophotes my.yaml --levels 5\n"
                "luxel isophotes my.yaml --levels 0.5,1,2 --json\n"
                "luxel isophotes -o lines.csv --csv=excel-ru",
    .run = run,
};
