/* SPDX-License-Identifier: MIT */
/* When the sun shines on grids and elements: as text, JSON and a table. */
#include "sun.h"

#include <math.h>
#include <stdlib.h>

#include "argument.h"
#include "cli.h"
#include "csv.h"
#include "json.h"
#include "message.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

/* Larger grids are not printed as a table: lines would not fit, and nobody reads them. */
enum { MOST_COLUMNS = 20, MOST_ROWS = 100 };

/* luxel_sun_level, in JSON and tables, and for people. */
static const char *const level_names[] = {"none", "minimum", "medium", "high"};
static const char *const level_words[] = {N_("not kept"), N_("minimum"), N_("medium"), N_("high")};

/* ---- options ---- */

bool sun_take_outdoor(struct options *options, const char *argument)
{
    if (argument_number("--outdoor", argument, &options->outdoor) && !(options->outdoor > 0.0))
        message_error(_("--outdoor must be above 0, not \"%s\""), argument);
    return options->outdoor > 0.0;
}

bool sun_take_location(struct options *options, const char *argument)
{
    const double *place = options->sun.location;

    if (!argument_numbers("--location", "LATITUDE,LONGITUDE", argument, options->sun.location, 2))
        return false;
    options->sun.has_location = fabs(place[0]) <= 90.0 && fabs(place[1]) <= 180.0;
    if (!options->sun.has_location)
        message_error(_("--location %s: latitudes are from -90 to 90 degrees, longitudes from -180 to 180"), argument);
    return options->sun.has_location;
}

bool sun_take_least_altitude(struct options *options, const char *argument)
{
    double *least = &options->sun.least_altitude_deg;

    if (!argument_number("--least-altitude", argument, least))
        return false;
    if (*least >= 0.0 && *least <= 90.0)
        return true;
    message_error(_("--least-altitude must be 0 to 90 degrees, not \"%s\""), argument);
    return false;
}

int sun_check_options(const struct options *options)
{
    static const char *const of_hours[] = {"location", "least-altitude"};
    const bool asks_hours = options->sun.day != NULL;

    for (size_t i = 0; i < sizeof of_hours / sizeof *of_hours && !asks_hours; i++)
        if (options_given(options, of_hours[i])) {
            message_error(_("--%s counts with --sun-hours alone"), of_hours[i]);
            return EXIT_USAGE;
        }
    if (asks_hours && options->sun.patches) {
        message_error(_("--sun-hours and --sun-patches are two questions: ask them one after the other"));
        return EXIT_USAGE;
    }
    if ((asks_hours || options->sun.patches) && options->outdoor > 0.0) {
        message_error(_("--outdoor counts for daylight factors alone"));
        return EXIT_USAGE;
    }
    if (options->sun.patches && options->place_count > 0) {
        message_error(_("--at and --points count for daylight factors and --sun-hours alone"));
        return EXIT_USAGE;
    }
    return EXIT_DONE;
}

/* ---- texts ---- */

/* "08:12:33", of a day that ends at 24:00:00. */
static const char *clock_text(double seconds, char buffer[TEXT_SIZE])
{
    const unsigned whole = (unsigned)(seconds + 0.5);

    return text_format(buffer, "%02u:%02u:%02u", whole / 3600, whole / 60 % 60, whole % 60);
}

static const char *span_text(const luxel_sun_span *span, char buffer[TEXT_SIZE])
{
    char from[TEXT_SIZE], to[TEXT_SIZE];

    return text_format(buffer, "%.32s-%.32s", clock_text(span->from_s, from), clock_text(span->to_s, to));
}

static double hours_of(const luxel_sun_hours *hours)
{
    return hours->total_s / 3600.0;
}

static void print_grid(const luxel_sun_grid *grid, size_t number)
{
    char alignment[MOST_COLUMNS + 1] = {0}, numbers[MOST_COLUMNS][TEXT_SIZE];
    const char *cells[MOST_COLUMNS] = {""};
    const size_t count = (size_t)grid->columns * grid->rows;
    double least = HUGE_VAL, most = 0.0, sum = 0.0;
    size_t kept = 0;

    fputc('\n', stdout);
    if (grid->name)
        text_print_escaped(stdout, grid->name);
    else
        printf(_("grid %zu"), number);
    printf(_(": %u × %u cells, hours of sun\n\n"), grid->columns, grid->rows);
    for (size_t i = 0; i < count; i++) {
        least = fmin(least, hours_of(&grid->cells[i]));
        most = fmax(most, hours_of(&grid->cells[i]));
        sum += hours_of(&grid->cells[i]);
        kept += grid->cells[i].level >= LUXEL_SUN_MINIMUM;
    }
    if (grid->columns <= MOST_COLUMNS && grid->rows <= MOST_ROWS) {
        for (unsigned i = 0; i < grid->columns; i++)
            alignment[i] = 'r';
        struct text_table *table = text_table_new(alignment);

        for (unsigned row = 0; row < grid->rows; row++) {
            for (unsigned i = 0; i < grid->columns; i++)
                cells[i] = text_format(numbers[i], "%.3f", hours_of(&grid->cells[(size_t)row * grid->columns + i]));
            text_table_row(table, cells);
        }
        text_table_print(table, stdout, 2);
        fputc('\n', stdout);
    }
    printf(_("  from %.3f h to %.3f h, mean %.3f h\n"), least, most, sum / (double)count);
    if (grid->cells[0].level != LUXEL_SUN_NO_LEVEL)
        printf(_("  EN 17037: %.1f %% of the cells keep the minimum of 1.5 h\n"), 100.0 * (double)kept / (double)count);
}

static void print_elements(const luxel_sunlight *found)
{
    struct text_table *table = text_table_new("lrll");

    text_table_row(table, TEXT_CELLS(_("element"), _("sun, h"), _("from, to"), "EN 17037"));
    for (size_t i = 0; i < found->element_count; i++) {
        const luxel_sun_hours *element = &found->elements[i];
        char name[TEXT_SIZE], hours[TEXT_SIZE], span[TEXT_SIZE];

        for (size_t k = 0; k == 0 || k < element->span_count; k++)
            text_table_row(
                table, TEXT_CELLS(k == 0 ? text_format(name, "P%zu", i + 1) : "",
                                  k == 0 ? text_format(hours, "%.4f", hours_of(element)) : "",
                                  k < element->span_count ? span_text(&element->spans[k], span) : _("never"),
                                  k > 0 || element->level == LUXEL_SUN_NO_LEVEL ? "" : _(level_words[element->level])));
    }
    fputc('\n', stdout);
    text_table_print(table, stdout, 2);
}

static void print_text(const struct options *options, const struct loaded *loaded, const luxel_sunlight *found)
{
    char span[TEXT_SIZE];

    text_print_escaped(stdout, loaded->name);
    printf(_(": hours of sun on %s at latitude %g°, longitude %g°\n"), options->sun.day, found->latitude_deg,
           found->longitude_deg);
    printf(_("  under the open sky %.4f h:"), hours_of(&found->open));
    for (size_t i = 0; i < found->open.span_count; i++)
        printf("%s %s", i > 0 ? "," : "", span_text(&found->open.spans[i], span));
    printf(_("\n  times are those of the sun's middle, whose place is known to 0.01°, some 2.4 s of its way\n"));
    for (size_t i = 0; i < found->grid_count; i++)
        print_grid(&found->grids[i], i + 1);
    if (found->element_count > 0)
        print_elements(found);
    if (found->open.level == LUXEL_SUN_NO_LEVEL)
        printf(_("\n  EN 17037 judges a day from 1 February to 21 March\n"));
}

/* ---- JSON ---- */

static void write_spans(struct json *json, const luxel_sun_hours *hours)
{
    char text[TEXT_SIZE];

    json_open(json, "spans", '[');
    for (size_t i = 0; i < hours->span_count; i++) {
        const luxel_sun_span *span = &hours->spans[i];

        json_open(json, NULL, '{');
        json_text(json, "from", clock_text(span->from_s, text));
        json_text(json, "to", clock_text(span->to_s, text));
        json_number(json, "from_s", span->from_s);
        json_number(json, "to_s", span->to_s);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static const char *level_name(const luxel_sun_hours *hours)
{
    return hours->level == LUXEL_SUN_NO_LEVEL ? NULL : level_names[hours->level];
}

static void write_place(struct json *json, const char *key, const luxel_sun_hours *hours)
{
    json_open(json, key, '{');
    json_number(json, "hours", hours_of(hours));
    json_text(json, "en17037", level_name(hours));
    write_spans(json, hours);
    json_close(json, '}');
}

static void print_json(const struct options *options, const luxel_sunlight *found)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "date", options->sun.day);
    json_number(&json, "latitude", found->latitude_deg);
    json_number(&json, "longitude", found->longitude_deg);
    json_number(&json, "least_altitude", found->least_altitude_deg);
    write_place(&json, "open", &found->open);
    json_open(&json, "grids", '[');
    for (size_t i = 0; i < found->grid_count; i++) {
        const luxel_sun_grid *grid = &found->grids[i];

        json_open(&json, NULL, '{');
        json_text(&json, "name", grid->name);
        json_open(&json, "cells", '[');
        for (unsigned row = 0; row < grid->rows; row++) {
            json_open(&json, NULL, '[');
            for (unsigned column = 0; column < grid->columns; column++)
                write_place(&json, NULL, &grid->cells[(size_t)row * grid->columns + column]);
            json_close(&json, ']');
        }
        json_close(&json, ']');
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_open(&json, "elements", '[');
    for (size_t i = 0; i < found->element_count; i++)
        write_place(&json, NULL, &found->elements[i]);
    json_close(&json, ']');
    json_close(&json, '}');
}

/* ---- tables ---- */

/* All lines have as many fields as the one with the most spans. */
static void write_line(struct csv *csv, const luxel_sun_hours *hours, size_t spans)
{
    char text[TEXT_SIZE];

    csv_number(csv, hours_of(hours));
    csv_text(csv, hours->level == LUXEL_SUN_NO_LEVEL ? "" : level_names[hours->level]);
    for (size_t i = 0; i < spans; i++)
        if (i < hours->span_count)
            csv_text(csv, span_text(&hours->spans[i], text));
        else
            csv_blank(csv);
    csv_end_line(csv);
}

static size_t most_spans(const luxel_sun_hours *hours, size_t count, size_t most)
{
    for (size_t i = 0; i < count; i++)
        most = hours[i].span_count > most ? hours[i].span_count : most;
    return most;
}

/* A line for each cell of the grids, then one for each element, P1 and so on, whose column and row are blank. */
static void write_table(struct csv *csv, const void *data)
{
    static const char *const headings[] = {"grid", "column", "row", "sun_h", "en17037"};
    const luxel_sunlight *found = data;
    char name[TEXT_SIZE];
    size_t spans = most_spans(found->elements, found->element_count, 0);

    for (size_t i = 0; i < found->grid_count; i++)
        spans = most_spans(found->grids[i].cells, (size_t)found->grids[i].columns * found->grids[i].rows, spans);
    for (size_t i = 0; i < sizeof headings / sizeof *headings; i++)
        csv_text(csv, headings[i]);
    for (size_t i = 0; i < spans; i++)
        csv_text(csv, text_format(name, "span%zu", i + 1));
    csv_end_line(csv);
    for (size_t i = 0; i < found->grid_count; i++) {
        const luxel_sun_grid *grid = &found->grids[i];

        for (size_t cell = 0; cell < (size_t)grid->columns * grid->rows; cell++) {
            csv_text(csv, grid->name ? grid->name : "");
            csv_whole(csv, cell % grid->columns);
            csv_whole(csv, cell / grid->columns);
            write_line(csv, &grid->cells[cell], spans);
        }
    }
    for (size_t i = 0; i < found->element_count; i++) {
        csv_text(csv, text_format(name, "P%zu", i + 1));
        csv_blank(csv);
        csv_blank(csv);
        write_line(csv, &found->elements[i], spans);
    }
}

/* ---- the whole ---- */

int sun_print_hours(const struct options *options, const struct loaded *loaded, const struct places *places)
{
    const luxel_sun_day day = {.date = options->sun.day,
                               .has_place = options->sun.has_location,
                               .latitude_deg = options->sun.location[0],
                               .longitude_deg = options->sun.location[1],
                               .least_altitude_deg = options->sun.least_altitude_deg};
    luxel_sunlight *found = NULL;
    struct work work;

    work_begin(&work, options);
    const luxel_status status = luxel_find_sunlight(loaded->scene, &work.settings, &day, places->list, places->count,
                                                    loaded->diagnostics, &found);
    int code = work_end(&work, status, loaded->diagnostics);

    if (code == EXIT_DONE) {
        code = csv_write(options, write_table, found);
        if (options->json)
            print_json(options, found);
        else if (options->csv == CSV_NONE && standard_output_is_free(options))
            print_text(options, loaded, found);
    }
    luxel_sunlight_free(found);
    return code;
}
