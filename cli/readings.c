/* SPDX-License-Identifier: MIT */
/* Reading measured values: tables with a place and a value in each row, pictures of values, and grey levels. */
#include "readings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "argument.h"
#include "cli.h"
#include "message.h"

/* A percentage or a number, or both with a plus between them: 3%, 0.01 or 3%+0.01. */
bool readings_take_noise(struct options *options, const char *argument)
{
    const char *percent = strchr(argument, '%');
    char *first = message_allocate(strlen(argument) + 1, 1);
    bool good = true;

    memcpy(first, argument, percent ? (size_t)(percent - argument) : strlen(argument));
    if (percent && percent[1] != '\0' && percent[1] != '+') {
        message_error(_("--noise %s: expected a share such as 3%%, a number, or both: 3%%+0.01"), argument);
        good = false;
    } else if (percent) {
        good = argument_number("--noise", first, &options->fit.relative_noise) &&
               (percent[1] == '\0' || argument_number("--noise", percent + 2, &options->fit.noise));
    } else {
        good = argument_number("--noise", first, &options->fit.noise);
    }
    free(first);
    options->fit.relative_noise /= 100.0;
    if (good && !(options->fit.noise >= 0.0 && options->fit.relative_noise >= 0.0 &&
                  options->fit.noise + options->fit.relative_noise > 0.0)) {
        message_error(_("--noise %s: it must be above 0; without the option it is told by how the readings scatter"),
                      argument);
        good = false;
    }
    return good;
}

bool readings_take_saturated(struct options *options, const char *argument)
{
    if (!argument_number("--saturated", argument, &options->fit.saturated))
        return false;
    if (options->fit.saturated > 0.0)
        return true;
    message_error(_("--saturated %s: the limit must be above 0"), argument);
    return false;
}

enum { X, Y, VALUE, Z, NX, NY, NZ, COLUMNS };

static const luxel_table_column columns[COLUMNS] = {
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"x", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"y", NULL}},
    {.type = LUXEL_TABLE_NUMBER,
     .is_required = true,
     .names =
         (const char *const[]){"value", "brightness", "irradiance", "luminance", "illuminance", "reading", "e", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = false, .names = (const char *const[]){"z", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"nx", "normal_x", "n_x", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"ny", "normal_y", "n_y", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"nz", "normal_z", "n_z", NULL}},
};

static const char form[] = N_("the columns are x, y, value of points of the screen, or x, y, z, nx, ny, nz, value of "
                              "elements, in mm");

/* A row; false: it is none, which is said. */
static bool take_row(const struct options *options, const luxel_table *table, const double *numbers,
                     struct readings *readings)
{
    size_t given = 0;
    const bool has_normal = numbers[NX] != 0.0 || numbers[NY] != 0.0 || numbers[NZ] != 0.0;
    unsigned line, place;

    for (size_t i = Z; i < COLUMNS; i++)
        given += isnan(numbers[i]) ? 0 : 1;
    if ((given > 0 && given < 4) || !has_normal) {
        luxel_table_place(table, given < 4 ? X : NX, &line, &place);
        message_error("%s:%u:%u: %s", options->fit.values, line, place,
                      has_normal ? _("a place is x, y on the screen, or x, y, z and its normal nx, ny, nz")
                                 : _("the normal must not be zero"));
        return false;
    }
    if (given == 0)
        memcpy(places_add(&readings->places)->screen_mm, numbers, 2 * sizeof *numbers);
    else
        places_set_element(places_add(&readings->places),
                           (const double[]){numbers[X], numbers[Y], numbers[Z], numbers[NX], numbers[NY], numbers[NZ]});
    readings->places.list[readings->places.count - 1].surface = options->material;
    if (readings->places.count > readings->capacity) {
        const size_t capacity = 2 * readings->places.count + 64;
        double *values = message_allocate(capacity, sizeof *values);

        if (readings->values)
            memcpy(values, readings->values, readings->capacity * sizeof *values);
        free(readings->values);
        readings->values = values;
        readings->capacity = capacity;
    }
    readings->values[readings->places.count - 1] = numbers[VALUE];
    return true;
}

/* The unit that the heading gives is that of the scene's values. */
static bool has_right_unit(const struct options *options, const struct loaded *loaded, const luxel_table *table)
{
    const char *unit = luxel_table_unit(table, VALUE), *own = luxel_settings_unit(loaded->scene, &options->settings);

    if (*unit == '\0' || strcmp(unit, own) == 0 || options->fit.is_relative)
        return true;
    message_error(_("%s: the readings are in %s, but the values of the scene in %s"), options->fit.values, unit, own);
    message_hint(_("--quantity and the scene's keys units, attenuation and over_pi decide its unit"));
    return false;
}

static int read_values(const struct options *options, const struct loaded *loaded, struct readings *readings)
{
    luxel_table *table = NULL;
    const luxel_table_row *row;
    size_t wrong = 0;
    const luxel_status status =
        luxel_table_open(options->fit.values, columns, COLUMNS, true, loaded->diagnostics, &table);

    if (status != LUXEL_OK)
        return message_table_failure(status, loaded->diagnostics, _(form));
    message_passed_over(loaded->diagnostics, options->quiet);
    if (!has_right_unit(options, loaded, table)) {
        luxel_table_free(table);
        return EXIT_FILE;
    }
    while (luxel_table_next(table, &row) && wrong < LUXEL_DIAGNOSTICS_KEPT)
        if (row)
            wrong += !take_row(options, table, row->numbers, readings);
    luxel_table_free(table);
    if (luxel_diagnostics_total(loaded->diagnostics, LUXEL_SEVERITY_ERROR) > 0)
        return message_table_failure(LUXEL_ERROR_FILE, loaded->diagnostics, _(form));
    readings->list.places = readings->places.list;
    readings->list.values = readings->values;
    readings->list.count = readings->places.count;
    return wrong > 0 ? EXIT_FILE : EXIT_DONE;
}

/* ---- grey levels ---- */

/* The scene's picture.range: its word, or "" and both ends. */
static bool range_of(const luxel_scene *scene, char word[16], double ends[2])
{
    char *text = NULL;
    bool good = luxel_scene_get(scene, "picture.range", NULL, NULL, &text) == LUXEL_OK && text;

    word[0] = '\0';
    if (good && text[0] == '[')
        good = sscanf(text, "[%lf, %lf", &ends[0], &ends[1]) == 2;
    else if (good)
        snprintf(word, 16, "%s", text);
    luxel_text_free(text);
    return good;
}

static bool is_truncated(const luxel_scene *scene)
{
    char *text = NULL;
    const bool truncates = luxel_scene_get(scene, "picture.rounding", NULL, NULL, &text) == LUXEL_OK && text &&
                           strcmp(text, "truncate") == 0;

    luxel_text_free(text);
    return truncates;
}

/* Makes values of the levels of a field, by a range [low, high]: level 0 may be anything below. */
static int scale_levels(const struct loaded *loaded, const double ends[2], double greatest, struct readings *readings)
{
    const unsigned wide = luxel_field_columns(readings->picture), high = luxel_field_rows(readings->picture);
    double *values = message_allocate((size_t)wide * high, sizeof *values);
    unsigned char *mask = message_allocate((size_t)wide * high, 1);
    luxel_field *scaled = NULL;

    for (size_t i = 0; i < (size_t)wide * high; i++) {
        const double level = luxel_field_value(readings->picture, (unsigned)(i % wide), (unsigned)(i / wide));

        mask[i] = 1;
        values[i] = level == 0 && ends[0] > 0.0 ? (double)NAN : ends[0] + level / greatest * (ends[1] - ends[0]);
    }
    const luxel_field_content content = {
        .columns = wide, .rows = high, .precision = LUXEL_DOUBLE, .values = values, .mask = mask};
    const luxel_status status = luxel_field_of_values(&content, loaded->diagnostics, &scaled);

    free(values);
    free(mask);
    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    luxel_field_free(readings->picture);
    readings->picture = scaled;
    return EXIT_DONE;
}

static int read_levels(const struct options *options, const struct loaded *loaded, struct readings *readings)
{
    double greatest, ends[2];
    char word[16];
    const luxel_status status =
        luxel_read_levels(options->fit.picture, loaded->diagnostics, &readings->picture, &greatest);

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    readings->list.is_truncated = is_truncated(loaded->scene);
    if (!range_of(loaded->scene, word, ends) || (*word && strcmp(word, "max") != 0)) {
        message_error(_("%s: values cannot be told from levels where picture.range is %s"), options->fit.picture, word);
        message_hint(_("levels tell values where it is max, up to a factor, or [low, high]"));
        return EXIT_USAGE;
    }
    if (*word) {
        readings->list.quantum = 1.0;
        readings->list.is_relative = true;
        return EXIT_DONE;
    }
    readings->list.quantum = (ends[1] - ends[0]) / greatest;
    if (!(readings->list.saturated > 0.0))
        readings->list.saturated = ends[1];
    return scale_levels(loaded, ends, greatest, readings);
}

static bool is_png(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot && strcasecmp(dot, ".png") == 0;
}

int readings_read(const struct options *options, const struct loaded *loaded, struct readings *readings)
{
    const struct option_fit *fit = &options->fit;

    *readings = (struct readings){.list = {.noise = fit->noise,
                                           .relative_noise = fit->relative_noise,
                                           .saturated = fit->saturated,
                                           .is_relative = fit->is_relative,
                                           .loss = fit->loss}};
    if (fit->values)
        return read_values(options, loaded, readings);
    if (is_png(fit->picture))
        return read_levels(options, loaded, readings);
    const luxel_status status = luxel_field_read(fit->picture, loaded->diagnostics, &readings->picture);

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    message_passed_over(loaded->diagnostics, options->quiet);
    return EXIT_DONE;
}

void readings_clear(struct readings *readings)
{
    places_clear(&readings->places);
    free(readings->values);
    luxel_field_free(readings->picture);
}
