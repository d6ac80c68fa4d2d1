/* SPDX-License-Identifier: MIT */
/* luxel profile: the values along a line of the screen or a great circle of a sphere, light by light. */
#include <luxel/luxel.h>

#include <math.h>
#include <string.h>

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

enum { ARC_SAMPLES = 181, MOST_LINES = 41, MOST_LIGHT_COLUMNS = 6 };

struct profiling {
    const struct picture *picture;
    luxel_profile *profile;
    luxel_probe *probe; /* of any place: it has the lights' names; NULL where there are no shares */
};

/* ---- the path ---- */

static bool is_given(const double point[2])
{
    return !isnan(point[0]);
}

static int wrong(const char *text)
{
    message_error("%s", text);
    return EXIT_USAGE;
}

/* The place of a field's corner pixels stands for the screen of a file of values. */
static luxel_status across(const struct picture *picture, const double through[2], double degrees,
                           luxel_profile_path *path)
{
    return luxel_profile_line(picture->loaded.scene, through, degrees, picture->loaded.diagnostics, path->from_mm,
                              path->to_mm);
}

static int check_options(const struct option_analysis *analysis, bool has_scene)
{
    const bool has_ends = is_given(analysis->from_mm) || is_given(analysis->to_mm);

    if (is_given(analysis->from_mm) != is_given(analysis->to_mm))
        return wrong(_("--from and --to go together"));
    if (has_ends && (is_given(analysis->through_mm) || !isnan(analysis->angle_deg)))
        return wrong(_("a line is given either by --from and --to or by --through and --angle"));
    if (analysis->arc && !has_ends)
        return wrong(_("--arc needs --from and --to, two places of one sphere"));
    if (analysis->arc && analysis->from_picture)
        return wrong(_("--arc gives exact values: --picture does not go with it"));
    if (!has_scene && !has_ends)
        return wrong(_("a file of values needs --from and --to"));
    if (!has_scene && analysis->arc)
        return wrong(_("a file of values has no spheres: --arc needs a scene"));
    return EXIT_DONE;
}

static int make_path(const struct picture *picture, luxel_profile_path *path)
{
    static const double center[2] = {0.0, 0.0};
    const struct option_analysis *analysis = &picture->options.analysis;
    const unsigned columns = luxel_field_columns(picture->field), rows = luxel_field_rows(picture->field);
    const unsigned longer = columns > rows ? columns : rows;
    luxel_status status;

    *path = (luxel_profile_path){.type = analysis->arc ? LUXEL_PATH_ARC : LUXEL_PATH_LINE};
    path->samples = analysis->samples > 0 ? analysis->samples : analysis->arc ? ARC_SAMPLES : longer > 1 ? longer : 2;
    if (is_given(analysis->from_mm)) {
        memcpy(path->from_mm, analysis->from_mm, sizeof path->from_mm);
        memcpy(path->to_mm, analysis->to_mm, sizeof path->to_mm);
        return EXIT_DONE;
    }
    status = across(picture, is_given(analysis->through_mm) ? analysis->through_mm : center,
                    isnan(analysis->angle_deg) ? 0.0 : analysis->angle_deg, path);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, picture->loaded.diagnostics);
}

/* ---- computing ---- */

/* A probe knows the names of the lights in the order of the shares. */
static luxel_status name_lights(struct profiling *profiling, const luxel_settings *settings)
{
    static const double up[3] = {0.0, 0.0, 1.0}, far_away[3] = {1.2345e7, -2.3456e7, -3.4567e7};

    return luxel_probe_element(profiling->picture->loaded.scene, settings, far_away, up,
                               profiling->picture->loaded.diagnostics, &profiling->probe);
}

static luxel_status find_exact(struct profiling *profiling, const luxel_settings *settings,
                               const luxel_profile_path *path)
{
    const struct picture *picture = profiling->picture;
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(picture->loaded.scene, settings, picture->loaded.diagnostics, &evaluator);

    if (status == LUXEL_OK)
        status = luxel_find_profile(evaluator, path, picture->loaded.diagnostics, &profiling->profile);
    if (status == LUXEL_OK)
        status = name_lights(profiling, settings);
    luxel_evaluator_free(evaluator);
    return status;
}

static int compute(struct profiling *profiling)
{
    const struct picture *picture = profiling->picture;
    const bool exact = picture->loaded.scene && !picture->options.analysis.from_picture;
    luxel_status status;
    struct work work;
    luxel_profile_path path = {.samples = 0};
    int code = check_options(&picture->options.analysis, picture->loaded.scene != NULL);

    if (code == EXIT_DONE)
        code = make_path(picture, &path);
    if (code != EXIT_DONE)
        return code;
    work_begin(&work, &picture->options);
    status = exact ? find_exact(profiling, &work.settings, &path)
                   : luxel_field_profile(picture->field, &path, picture->loaded.diagnostics, &profiling->profile);
    return work_end(&work, status, picture->loaded.diagnostics);
}

/* The i-th light that is on, as its columns are called: its name, or lights[i]; "" beyond the last. */
static size_t light_count(const struct profiling *profiling)
{
    return profiling->probe ? profiling->probe->share_count : 0;
}

static const char *light_name(const struct profiling *profiling, size_t i, char buffer[TEXT_SIZE])
{
    const luxel_light_share *share = &profiling->probe->shares[i];

    if (!share->name)
        return text_format(buffer, "lights[%zu]", share->light);

    char *escaped = luxel_escaped_text(share->name);

    text_format(buffer, "%s", escaped ? escaped : "");
    luxel_text_free(escaped);
    return buffer;
}

static double share_of(const struct profiling *profiling, size_t sample, size_t i)
{
    return profiling->profile->shares[sample * profiling->profile->lights + profiling->probe->shares[i].light];
}

/* ---- text ---- */

static void add_sample(struct text_table *table, const struct profiling *profiling, size_t i, size_t lights)
{
    const luxel_profile_sample *sample = &profiling->profile->samples[i];
    char numbers[4 + MOST_LIGHT_COLUMNS][TEXT_SIZE];
    const char *cells[4 + MOST_LIGHT_COLUMNS];

    cells[0] = text_format(numbers[0], "%.4f", sample->abscissa);
    cells[1] = text_length(sample->x_mm, numbers[1]);
    cells[2] = text_length(sample->y_mm, numbers[2]);
    cells[3] = sample->has_value ? text_value(numbers[3], 9, sample->value) : "-";
    for (size_t k = 0; k < lights; k++)
        cells[4 + k] = sample->has_value ? text_value(numbers[4 + k], 6, share_of(profiling, i, k)) : "";
    text_table_row(table, cells);
}

static void print_text(const struct profiling *profiling)
{
    const luxel_conventions_use use =
        result_use_of_screen(&profiling->picture->options, profiling->picture->options.analysis.from_picture);
    const luxel_profile *profile = profiling->profile;
    const size_t all = light_count(profiling), lights = all > 1 && all <= MOST_LIGHT_COLUMNS ? all : 0;
    const size_t step = (profile->count + MOST_LINES - 2) / (MOST_LINES - 1);
    char heading[TEXT_SIZE], names[MOST_LIGHT_COLUMNS][TEXT_SIZE];
    const char *cells[4 + MOST_LIGHT_COLUMNS];
    struct text_table *table = text_table_new(&"rrrrrrrrrr"[MOST_LIGHT_COLUMNS - lights]);
    const char *unit = picture_unit(profiling->picture);

    picture_print_heading(profiling->picture);
    cells[0] = profile->type == LUXEL_PATH_ARC ? _("angle (°)") : _("distance (mm)");
    cells[1] = _("x (mm)");
    cells[2] = _("y (mm)");
    cells[3] = *unit ? text_format(heading, _("value (%s)"), _(unit)) : _("value");
    for (size_t k = 0; k < lights; k++)
        cells[4 + k] = light_name(profiling, k, names[k]);
    text_table_row(table, cells);
    for (size_t i = 0; i < profile->count; i += step)
        add_sample(table, profiling, i, lights);
    if ((profile->count - 1) % step != 0)
        add_sample(table, profiling, profile->count - 1, lights);
    text_table_print(table, stdout, 2);
    if (step > 1)
        printf(_("  some of %zu values; --csv and --json print all of them\n"), profile->count);
    if (profiling->picture->loaded.scene) {
        fputc('\n', stdout);
        result_print_conventions(profiling->picture->loaded.scene, &use);
    }
}

/* ---- JSON and CSV ---- */

static void write_sample(struct json *json, const struct profiling *profiling, size_t i)
{
    const luxel_profile *profile = profiling->profile;
    const luxel_profile_sample *sample = &profile->samples[i];

    json_open(json, NULL, '{');
    json_number(json, profile->type == LUXEL_PATH_ARC ? "angle" : "distance", sample->abscissa);
    json_numbers(json, "screen", (const double[]){sample->x_mm, sample->y_mm}, 2);
    json_number(json, "value", sample->has_value ? sample->value : (double)NAN);
    json_number(json, "error", sample->has_value ? sample->error : (double)NAN);
    if (profiling->probe) {
        json_open(json, "lights", '[');
        for (size_t k = 0; k < light_count(profiling); k++)
            json_number(json, NULL, sample->has_value ? share_of(profiling, i, k) : (double)NAN);
        json_close(json, ']');
    }
    json_close(json, '}');
}

static void print_json(const struct profiling *profiling)
{
    const luxel_conventions_use use =
        result_use_of_screen(&profiling->picture->options, profiling->picture->options.analysis.from_picture);
    struct json json = {.stream = stdout};
    char name[TEXT_SIZE];

    json_open(&json, NULL, '{');
    json_text(&json, "quantity", picture_quantity_name(profiling->picture));
    json_text(&json, "unit", picture_unit(profiling->picture));
    json_text(&json, "path", profiling->profile->type == LUXEL_PATH_ARC ? "arc" : "line");
    json_open(&json, "lights", '[');
    for (size_t i = 0; i < light_count(profiling); i++)
        json_text(&json, NULL, light_name(profiling, i, name));
    json_close(&json, ']');
    json_open(&json, "samples", '[');
    for (size_t i = 0; i < profiling->profile->count; i++)
        write_sample(&json, profiling, i);
    json_close(&json, ']');
    if (profiling->picture->loaded.scene)
        result_write_conventions(&json, profiling->picture->loaded.scene, &use);
    json_close(&json, '}');
}

static void write_csv(struct csv *csv, const void *data)
{
    const struct profiling *profiling = data;
    const luxel_profile *profile = profiling->profile;
    char name[TEXT_SIZE];

    csv_text(csv, profile->type == LUXEL_PATH_ARC ? "angle_deg" : "distance_mm");
    csv_text(csv, "x_mm");
    csv_text(csv, "y_mm");
    csv_heading(csv, "value", picture_unit(profiling->picture));
    for (size_t k = 0; k < light_count(profiling); k++)
        csv_text(csv, light_name(profiling, k, name));
    csv_end_line(csv);
    for (size_t i = 0; i < profile->count; i++) {
        const luxel_profile_sample *sample = &profile->samples[i];

        csv_number(csv, sample->abscissa);
        csv_number(csv, sample->x_mm);
        csv_number(csv, sample->y_mm);
        csv_number(csv, sample->has_value ? sample->value : (double)NAN);
        for (size_t k = 0; k < light_count(profiling); k++)
            csv_number(csv, sample->has_value ? share_of(profiling, i, k) : (double)NAN);
        csv_end_line(csv);
    }
}

static int run(const struct options *options)
{
    struct picture picture;
    struct profiling profiling = {.picture = &picture};
    int code = outputs_check(options, outputs_check_csv);

    if (code != EXIT_DONE)
        return code;
    code = picture_open(options, options->operand, &picture);
    if (code == EXIT_DONE)
        code = compute(&profiling);
    if (code == EXIT_DONE) {
        code = csv_write(options, write_csv, &profiling);
        if (options->json)
            print_json(&profiling);
        else if (options->csv == CSV_NONE && standard_output_is_free(options))
            print_text(&profiling);
    }
    luxel_probe_free(profiling.probe);
    luxel_profile_free(profiling.profile);
    if (code == EXIT_DONE)
        code = picture.code;
    picture_close(&picture);
    return code;
}

const struct command command_profile = {
    .name = "profile",
    .bit = COMMAND_PROFILE,
    .operand = N_("SCENE"),
    .endings = ".csv",
    .default_format = "csv",
    .summary = N_("values along a line of the screen or an arc of a sphere"),
    .description = N_("Prints the exact values along a straight line of the screen, the horizontal one through its "
                      "centre unless another is given, or along the great circle of a sphere by the angle; with the "
                      "share of each light. With --picture, or where SCENE is a file of values that gives the "
                      "places of its pixels (.csv, or an .exr that Luxel wrote), the values are those of the pixels."),
    .examples = "luxel profile my.yaml --through 0,50 --angle 30 --samples 201\n"
                "luxel profile my.yaml --from -100,0 --to 100,0 --arc --csv=excel-ru\n"
                "luxel profile -o section.csv",
    .run = run,
};
