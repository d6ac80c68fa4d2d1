/* SPDX-License-Identifier: MIT */
/* luxel stats: what the values of a picture or of a part of it are like, and the true extrema between its pixels. */
#include <luxel/luxel.h>

#include <math.h>
#include <stdlib.h>

#include "balance.h"
#include "cli.h"
#include "csv.h"
#include "json.h"
#include "message.h"
#include "picture.h"
#include "result.h"
#include "text.h"
#include "work.h"

enum { DEFAULT_BINS = 16, BAR_COLUMNS = 50 };

struct stats {
    const struct options *options;
    struct picture *picture;
    luxel_summary summary;
    luxel_extrema extrema;
    bool has_extrema; /* of a scene that shows a surface in the region */
    luxel_histogram *histogram;
    bool in_color;
    double mean_rgb[3];     /* of the pixels, where it is in colour */
    luxel_balance *balance; /* NULL: no scene, or one that reflects no light */
};

/* The words of JSON; those of texts are below. */
static const char *const place_names[] = {
    [LUXEL_PEAK_INSIDE] = "inside", [LUXEL_PEAK_LIMB] = "limb",       [LUXEL_PEAK_BORDER] = "border",
    [LUXEL_PEAK_JUMP] = "jump",     [LUXEL_PEAK_PLATEAU] = "plateau",
};

static const char *const place_words[] = {
    [LUXEL_PEAK_INSIDE] = N_("within the surface"),
    [LUXEL_PEAK_LIMB] = N_("on the rim of the surface"),
    [LUXEL_PEAK_BORDER] = N_("on the edge of the screen or region"),
    [LUXEL_PEAK_JUMP] = N_("at a jump or kink"),
    [LUXEL_PEAK_PLATEAU] = N_("in a part of one value"),
};

/* ---- computing ---- */

static luxel_status find_extrema(struct stats *stats, const luxel_settings *settings)
{
    const struct picture *picture = stats->picture;
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(picture->loaded.scene, settings, picture->loaded.diagnostics, &evaluator);

    if (status == LUXEL_OK)
        status = luxel_find_extrema(evaluator, picture->field, &stats->options->analysis.region,
                                    picture->loaded.diagnostics, &stats->extrema);
    stats->has_extrema = status == LUXEL_OK && stats->extrema.maximum.exists;
    luxel_evaluator_free(evaluator);
    return status;
}

/* The mean of the channels of the pixels that the summary is of. */
static void find_mean_color(struct stats *stats)
{
    const luxel_field *field = stats->picture->field;
    const float *single = luxel_field_rgb_single(field);
    const double *exact = luxel_field_rgb_double(field), *x_mm = luxel_field_x_mm(field),
                 *y_mm = luxel_field_y_mm(field);
    const size_t columns = luxel_field_columns(field), pixels = columns * luxel_field_rows(field);

    stats->in_color = (single || exact) && stats->summary.pixels > 0;
    for (size_t i = 0; i < pixels && stats->in_color; i++)
        for (size_t c = 0; c < 3 && luxel_field_mask(field)[i]; c++)
            if (luxel_region_holds(&stats->options->analysis.region, x_mm[i % columns], y_mm[i / columns]))
                stats->mean_rgb[c] += single ? (double)single[3 * i + c] : exact[3 * i + c];
    for (size_t c = 0; c < 3 && stats->in_color; c++)
        stats->mean_rgb[c] /= (double)stats->summary.pixels;
}

/* Puts the view that is asked for in the place of the picture. */
static luxel_status show(struct stats *stats)
{
    const luxel_color_view view = (luxel_color_view)stats->options->analysis.view;
    struct picture *picture = stats->picture;
    luxel_field *shown = NULL;
    const luxel_status status = view == LUXEL_VIEW_LUMINANCE
                                    ? LUXEL_OK
                                    : luxel_field_of_view(picture->field, view, picture->loaded.diagnostics, &shown);

    if (shown) {
        luxel_field_free(picture->field);
        picture->field = shown;
    }
    return status;
}

static int compute(struct stats *stats)
{
    const struct option_analysis *analysis = &stats->options->analysis;
    struct picture *picture = stats->picture;
    const luxel_histogram_scale scale = analysis->logarithmic ? LUXEL_HISTOGRAM_LOGARITHMIC : LUXEL_HISTOGRAM_LINEAR;
    struct work work;
    luxel_status status;

    work_begin(&work, &picture->options);
    status = show(stats);
    if (status == LUXEL_OK)
        status = luxel_field_summary(picture->field, &analysis->region, picture->loaded.diagnostics, &stats->summary);
    if (status == LUXEL_OK)
        find_mean_color(stats);
    if (status == LUXEL_OK && analysis->histogram && stats->summary.pixels > 0)
        status = luxel_field_histogram(picture->field, &analysis->region, scale, analysis->scale[0], analysis->scale[1],
                                       analysis->bins > 0 ? analysis->bins : DEFAULT_BINS, picture->loaded.diagnostics,
                                       &stats->histogram);
    if (status == LUXEL_OK && picture->loaded.scene && analysis->view == LUXEL_VIEW_LUMINANCE)
        status = find_extrema(stats, &work.settings);
    return work_end(&work, status, picture->loaded.diagnostics);
}

/* The light on all surfaces, of a scene that reflects light; a bound that was missed is told, and counts at the end. */
static int find_balance(struct stats *stats)
{
    struct picture *picture = stats->picture;
    struct work work;

    if (!picture->loaded.scene)
        return EXIT_DONE;
    work_begin(&work, &picture->options);
    const luxel_status status =
        luxel_find_balance(picture->loaded.scene, &work.settings, picture->loaded.diagnostics, &stats->balance);
    const int code = work_end(&work, status, picture->loaded.diagnostics);
    if (code != EXIT_TOLERANCE)
        return code;
    picture->code = EXIT_TOLERANCE;
    return EXIT_DONE;
}

/* ---- text ---- */

static void add_value(struct text_table *table, const char *name, double value, const char *place, const char *words)
{
    char number[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name, text_value(number, 10, value), place, words));
}

static void add_pixel(struct text_table *table, const char *name, const luxel_extremum *extremum)
{
    char screen[TEXT_SIZE] = "", pixel[TEXT_SIZE];

    if (isfinite(extremum->x_mm))
        text_lengths((const double[]){extremum->x_mm, extremum->y_mm}, 2, screen);
    add_value(table, name, extremum->value, screen,
              text_format(pixel, _("pixel (%u, %u)"), extremum->column, extremum->row));
}

/* A place between the pixels: to six decimals of a millimetre. */
static const char *micro(double value_mm, char buffer[TEXT_SIZE])
{
    return text_format(buffer, "%.6f", fabs(value_mm) < 5e-7 ? 0.0 : value_mm);
}

static void add_peak(struct text_table *table, const char *name, const luxel_peak *peak)
{
    char value[TEXT_SIZE], screen[2 * TEXT_SIZE], x[TEXT_SIZE], y[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name, text_value_bound(value, 15, peak->value, peak->error),
                                     text_format(screen, "(%s, %s)", micro(peak->x_mm, x), micro(peak->y_mm, y)),
                                     _(place_words[peak->place])));
}

static void print_histogram(const luxel_histogram *histogram)
{
    struct text_table *table = text_table_new("rrl");
    size_t most = 1;

    for (size_t i = 0; i < histogram->bins; i++)
        most = histogram->counts[i] > most ? histogram->counts[i] : most;
    text_table_row(table, TEXT_CELLS(_("from"), _("pixels"), ""));
    for (size_t i = 0; i < histogram->bins; i++) {
        char from[TEXT_SIZE], pixels[TEXT_SIZE], bar[BAR_COLUMNS * 3 + 1];
        const size_t columns = (histogram->counts[i] * BAR_COLUMNS + most - 1) / most;
        size_t used = 0;

        for (size_t k = 0; k < columns; k++)
            used += (size_t)snprintf(bar + used, sizeof bar - used, "█");
        bar[used] = '\0';
        text_table_row(table, TEXT_CELLS(text_value(from, 4, histogram->edges[i]),
                                         text_format(pixels, "%zu", histogram->counts[i]), bar));
    }
    text_table_print(table, stdout, 2);
    printf(_("  up to %.4g; %zu pixels below, %zu above\n"), histogram->edges[histogram->bins], histogram->below,
           histogram->above);
}

static void print_mean_color(const struct stats *stats)
{
    const luxel_color mean = {.rgb = {stats->mean_rgb[0], stats->mean_rgb[1], stats->mean_rgb[2]}};
    char words[TEXT_SIZE];

    printf(_("  colour of the mean: %s\n"), result_color_text(&mean, words));
}

static void print_text(const struct stats *stats)
{
    const luxel_conventions_use use = result_use_of_screen(&stats->picture->options, true);
    const luxel_summary *summary = &stats->summary;
    struct text_table *table = text_table_new("lrrl");

    picture_print_heading(stats->picture);
    text_table_row(table, TEXT_CELLS("", _("value"), _("screen x, y (mm)"), ""));
    if (stats->has_extrema) {
        add_peak(table, _("true maximum"), &stats->extrema.maximum);
        add_peak(table, _("true minimum"), &stats->extrema.minimum);
    }
    if (summary->pixels > 0) {
        add_pixel(table, _("maximum of the pixels"), &summary->maximum);
        add_pixel(table, _("minimum of the pixels"), &summary->minimum);
        add_value(table, _("mean"), summary->mean, "", "");
        add_value(table, _("median"), summary->median, "", "");
        add_value(table, _("standard deviation"), summary->standard_deviation, "", "");
        add_value(table, _("share above 0"), summary->lit, "", "");
    } else {
        text_table_line(table, _("no pixel shows a surface"));
    }
    if (summary->has_evenness) {
        add_value(table, _("U0 = minimum / mean"), summary->u0, "", "");
        add_value(table, _("Ud = minimum / maximum"), summary->ud, "", "");
    }
    text_table_print(table, stdout, 2);
    printf(ngettext("  %zu pixel\n", "  %zu pixels\n", summary->pixels), summary->pixels);
    if (stats->in_color)
        print_mean_color(stats);
    if (stats->histogram) {
        fputc('\n', stdout);
        print_histogram(stats->histogram);
    }
    if (stats->balance)
        balance_print(stats->balance);
    if (stats->picture->loaded.scene) {
        fputc('\n', stdout);
        result_print_conventions(stats->picture->loaded.scene, &use);
    }
}

/* ---- JSON and CSV ---- */

static void write_number_if(struct json *json, const char *key, bool exists, double value)
{
    if (exists)
        json_number(json, key, value);
    else
        json_null(json, key);
}

static void write_peak(struct json *json, const char *key, const luxel_scene *scene, const luxel_peak *peak)
{
    const char *wall = luxel_scene_part_name(scene, peak->surface, peak->part);

    if (!peak->exists) {
        json_null(json, key);
        return;
    }
    json_open(json, key, '{');
    json_number(json, "value", peak->value);
    json_number(json, "error", peak->error);
    json_numbers(json, "screen", (const double[]){peak->x_mm, peak->y_mm}, 2);
    json_whole(json, "surface", peak->surface);
    if (wall)
        json_text(json, "wall", wall);
    json_numbers(json, "position", peak->position_mm, 3);
    json_numbers(json, "normal", peak->normal, 3);
    json_text(json, "place", place_names[peak->place]);
    json_close(json, '}');
}

static void write_region(struct json *json, const luxel_region *region)
{
    if (region->type == LUXEL_REGION_ALL) {
        json_null(json, "region");
        return;
    }
    json_open(json, "region", '{');
    json_numbers(json, "center", region->center_mm, 2);
    if (region->type == LUXEL_REGION_CIRCLE)
        json_number(json, "radius", region->radius_mm);
    else
        json_numbers(json, "size", region->size_mm, 2);
    json_close(json, '}');
}

static void write_histogram(struct json *json, const luxel_histogram *histogram)
{
    if (!histogram) {
        json_null(json, "histogram");
        return;
    }
    json_open(json, "histogram", '{');
    json_text(json, "scale", histogram->scale == LUXEL_HISTOGRAM_LOGARITHMIC ? "log" : "linear");
    json_numbers(json, "edges", histogram->edges, histogram->bins + 1);
    json_open(json, "counts", '[');
    for (size_t i = 0; i < histogram->bins; i++)
        json_whole(json, NULL, histogram->counts[i]);
    json_close(json, ']');
    json_whole(json, "below", histogram->below);
    json_whole(json, "above", histogram->above);
    json_close(json, '}');
}

static void print_json(const struct stats *stats)
{
    const luxel_conventions_use use = result_use_of_screen(&stats->picture->options, true);
    const luxel_summary *summary = &stats->summary;
    const luxel_field *field = stats->picture->field;
    const bool some = summary->pixels > 0;
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "quantity", picture_quantity_name(stats->picture));
    json_text(&json, "unit", picture_unit(stats->picture));
    json_wholes(&json, "resolution", (const unsigned[]){luxel_field_columns(field), luxel_field_rows(field)}, 2);
    write_region(&json, &stats->options->analysis.region);
    json_whole(&json, "pixels", summary->pixels);
    result_write_extremum(&json, "max", &summary->maximum);
    result_write_extremum(&json, "min", &summary->minimum);
    write_number_if(&json, "mean", some, summary->mean);
    if (stats->in_color) {
        json_open(&json, "mean_color", '{');
        json_numbers(&json, "rgb", stats->mean_rgb, 3);
        result_write_seen(&json, stats->mean_rgb);
        json_close(&json, '}');
    }
    write_number_if(&json, "median", some, summary->median);
    write_number_if(&json, "standard_deviation", some, summary->standard_deviation);
    write_number_if(&json, "lit", some, summary->lit);
    write_number_if(&json, "u0", summary->has_evenness, summary->u0);
    write_number_if(&json, "ud", summary->has_evenness, summary->ud);
    write_peak(&json, "maximum", stats->picture->loaded.scene, &stats->extrema.maximum);
    write_peak(&json, "minimum", stats->picture->loaded.scene, &stats->extrema.minimum);
    write_histogram(&json, stats->histogram);
    if (stats->balance)
        balance_write(&json, stats->balance);
    if (stats->picture->loaded.scene)
        result_write_conventions(&json, stats->picture->loaded.scene, &use);
    json_close(&json, '}');
}

static void write_csv_line(struct csv *csv, const char *name, bool exists, double value, double x_mm, double y_mm)
{
    csv_text(csv, name);
    csv_number(csv, exists ? value : (double)NAN);
    csv_number(csv, exists ? x_mm : (double)NAN);
    csv_number(csv, exists ? y_mm : (double)NAN);
    csv_end_line(csv);
}

static void write_csv(struct csv *csv, const void *data)
{
    const struct stats *stats = data;
    const luxel_summary *summary = &stats->summary;
    const luxel_peak *maximum = &stats->extrema.maximum, *minimum = &stats->extrema.minimum;
    const bool some = summary->pixels > 0;
    const double none = (double)NAN;

    csv_text(csv, "statistic");
    csv_heading(csv, "value", picture_unit(stats->picture));
    csv_text(csv, "x_mm");
    csv_text(csv, "y_mm");
    csv_end_line(csv);
    write_csv_line(csv, "maximum", stats->has_extrema, maximum->value, maximum->x_mm, maximum->y_mm);
    write_csv_line(csv, "minimum", stats->has_extrema, minimum->value, minimum->x_mm, minimum->y_mm);
    write_csv_line(csv, "max", some, summary->maximum.value, summary->maximum.x_mm, summary->maximum.y_mm);
    write_csv_line(csv, "min", some, summary->minimum.value, summary->minimum.x_mm, summary->minimum.y_mm);
    write_csv_line(csv, "mean", some, summary->mean, none, none);
    write_csv_line(csv, "median", some, summary->median, none, none);
    write_csv_line(csv, "standard_deviation", some, summary->standard_deviation, none, none);
    write_csv_line(csv, "lit", some, summary->lit, none, none);
    write_csv_line(csv, "u0", summary->has_evenness, summary->u0, none, none);
    write_csv_line(csv, "ud", summary->has_evenness, summary->ud, none, none);
    write_csv_line(csv, "pixels", true, (double)summary->pixels, none, none);
}

static int run(const struct options *options)
{
    struct picture picture;
    struct stats stats = {.options = options, .picture = &picture};
    int code = picture_open(options, options->operand, &picture);

    if (code == EXIT_DONE)
        code = compute(&stats);
    if (code == EXIT_DONE)
        code = find_balance(&stats);
    if (code == EXIT_DONE) {
        if (options->csv != CSV_NONE)
            code = csv_write(options, write_csv, &stats);
        else if (options->json)
            print_json(&stats);
        else
            print_text(&stats);
    }
    luxel_histogram_free(stats.histogram);
    luxel_balance_free(stats.balance);
    if (code == EXIT_DONE)
        code = picture.code;
    picture_close(&picture);
    return code;
}

const struct command command_stats = {
    .name = "stats",
    .bit = COMMAND_STATS,
    .operand = N_("SCENE"),
    .summary = N_("statistics of the picture, and its true maximum and minimum"),
    .description = N_(
        "Prints maximum, minimum, mean, median, standard deviation and uniformity of the pixels that show a "
        "surface, in the whole picture or in a region, and the true extrema, which lie between the "
        "pixels. Of a scene whose surfaces reflect light also the mean irradiance of each surface and the balance of "
        "the flux: what is absorbed and what escapes. SCENE may also be a file of values: .npy, .pfm, .exr, .csv."),
    .examples = "luxel stats my.yaml --region 0,0,100 --json\n"
                "luxel stats sphere.npy --histogram --bins 20 --log",
    .run = run,
};
