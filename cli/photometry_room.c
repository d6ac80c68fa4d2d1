/* SPDX-License-Identifier: MIT */
/*
 * The room of the tabular method as a scene: its ceiling is the plane of the luminaires, its floor that of the eye, one
 * metre below.  The glare is that of the table; the background is the mean of what the walls receive by reflections,
 * solved with a bound instead of from floor, walls and ceiling that are each evenly lit.
 */
#include "photometry_room.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "argument.h"
#include "cli.h"
#include "json.h"
#include "message.h"
#include "work.h"

enum { H_MM = 1000 };
enum { CEILING, WALLS, FLOOR };             /* as luxel_ugr_reflectance() counts them */
static const double BELOW_CEILING_MM = 0.1; /* of the luminaires, which else lay on it */
static const double MOST_UPWARDS = 0.3;     /* percent of the light: it changes the ratings by less than 0.05 */
static const double WISHED = 0.01;          /* error of the reflected light, of the greatest mean irradiance */

/* The number of a room of so many heights; LUXEL_UGR_ROOMS: it is no standard room. */
static size_t room_find(double across, double along)
{
    size_t room = 0;

    while (room < LUXEL_UGR_ROOMS && (luxel_ugr_room(room, 0) != across || luxel_ugr_room(room, 1) != along))
        room++;
    return room;
}

/* ---- options ---- */

bool room_take_spacing(struct options *options, const char *argument)
{
    double spacing, parts;

    if (!argument_number("--spacing", argument, &spacing))
        return false;
    parts = spacing > 0 ? round(1 / spacing) : 0;
    if (!(parts >= 1 && parts <= 8 && fabs(parts * spacing - 1) < 0.01)) {
        message_error(_("--spacing is %s, expected 1 or its half, third ... eighth, such as 0.25"), argument);
        return false;
    }
    options->drawing.spacing = 1 / parts;
    return true;
}

/* "4,8": heights across and along the line of sight. */
bool room_take(struct options *options, const char *argument)
{
    double size[2];

    if (!argument_numbers("--room", "X,Y", argument, size, 2))
        return false;
    options->drawing.room = 1 + room_find(size[0], size[1]);
    if (options->drawing.room <= LUXEL_UGR_ROOMS)
        return true;
    message_error(_("--room is %s, expected X,Y of a room of the UGR table: heights across and along, such as 4 and 8"),
                  argument);
    return false;
}

/* ---- the room as a scene ---- */

static void write_wall(FILE *stream, const char *name, double reflectance)
{
    fprintf(stream, "%s: {model: lambert, over_pi: true, diffuse: %.17g}", name, reflectance);
}

/* The eye looks along y; z is up.  The front of a room is its greatest z. */
static void write_scene(FILE *stream, const char *path, size_t room, double spacing, size_t triple)
{
    const double x = luxel_ugr_room(room, 0), y = luxel_ugr_room(room, 1);
    const size_t across = (size_t)round(x / spacing), along = (size_t)round(y / spacing);

    fprintf(stream,
            "luxel: 1\nunits: photometric\nreflections: all\nscreen: {width: 1, height: 1, resolution: [4, 4]}\n"
            "observer: {z: %d}\nsurfaces:\n  - type: room\n    center: [0, 0, %g]\n    size: [%g, %g, %d]\n    ",
            9 * H_MM, H_MM / 2.0, x * H_MM, y * H_MM, H_MM);
    write_wall(stream, "material", luxel_ugr_reflectance(triple, WALLS));
    fprintf(stream, "\n    materials: {");
    write_wall(stream, "front", luxel_ugr_reflectance(triple, CEILING));
    write_wall(stream, ", back", luxel_ugr_reflectance(triple, FLOOR));
    fprintf(stream, "}\nlights:\n");
    for (size_t i = 0; i < across * along; i++) {
        fprintf(stream, "  - {type: luminaire, file: ");
        json_text(&(struct json){.stream = stream}, NULL, path); /* which is a string of YAML, too */
        fprintf(stream, ", position: [%.17g, %.17g, %.17g], c0: [0, 1, 0]}\n",
                H_MM * (((double)(i % across) + 0.5) * spacing - x / 2),
                H_MM * (((double)(i / across) + 0.5) * spacing - y / 2), H_MM - BELOW_CEILING_MM);
    }
}

static luxel_status make_scene(const char *path, size_t room, double spacing, size_t triple,
                               luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    luxel_status status;

    if (!stream)
        return LUXEL_ERROR_MEMORY;
    write_scene(stream, path, room, spacing, triple);
    if (fclose(stream) != 0) {
        free(text);
        return LUXEL_ERROR_MEMORY;
    }
    status = luxel_scene_read_text(text, length, "room", diagnostics, scene);
    free(text);
    return status == LUXEL_OK ? luxel_scene_commit(*scene, diagnostics) : status;
}

/* ---- the background ---- */

/* The mean indirect illuminance of the four walls over pi. */
static luxel_amount background_of(const luxel_balance *balance)
{
    luxel_amount light = {0, 0};
    double area = 0;

    for (size_t i = 0; i < balance->side_count; i++) {
        const luxel_lit_side *side = &balance->sides[i];

        if (side->side != LUXEL_FRONT || side->part >= 6 || strcmp(side->part_name, "front") == 0 ||
            strcmp(side->part_name, "back") == 0)
            continue;
        light.value += side->area_m2 * (side->irradiance.value - side->direct.value);
        light.error += side->area_m2 * (side->irradiance.error + side->direct.error);
        area += side->area_m2;
    }
    return (luxel_amount){light.value / area / M_PI, light.error / area / M_PI};
}

static int rate_triple(const struct options *options, const luxel_ugr_table *table, size_t triple,
                       struct room_ratings *ratings)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    luxel_balance *balance = NULL;
    luxel_scene *scene = NULL;
    struct work work;
    luxel_status status = make_scene(options->operand, ratings->room, table->spacing, triple, diagnostics, &scene);
    int code;

    if (status == LUXEL_OK)
        luxel_diagnostics_clear(diagnostics); /* advice about such a scene */
    work_begin(&work, options);
    work.settings.reflected_error = WISHED;
    if (status == LUXEL_OK)
        status = luxel_find_balance(scene, &work.settings, diagnostics, &balance);
    code = work_end(&work, status, diagnostics);
    if (balance) {
        const luxel_amount light = background_of(balance);
        const double table_light = table->backgrounds[ratings->room][triple];

        ratings->background[triple] = light;
        for (int way = 0; way < 2; way++)
            ratings->ratings[way][triple] =
                table->ratings[ratings->room][way][triple] + 8 * log10(table_light / light.value);
        ratings->errors[triple] = -8 * log10(fmax(0, 1 - light.error / light.value));
    }
    luxel_balance_free(balance);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return code;
}

int room_rate(const struct options *options, const luxel_photometry *photometry, const luxel_ugr_table *table,
              double dff, struct room_ratings *ratings)
{
    int code = EXIT_DONE;

    *ratings = (struct room_ratings){0};
    if (options->drawing.room == 0)
        return EXIT_DONE;
    ratings->room = options->drawing.room - 1;
    if (!table->exists) {
        message_error(photometry->type == LUXEL_TYPE_C
                          ? _("--room: the luminaire is a point, and has no luminance towards an observer")
                          : _("--room: types A and B do not say how the luminaire hangs in a room"));
        return EXIT_USAGE;
    }
    if (strcmp(options->operand, "-") == 0) {
        message_error(_("--room needs the name of the luminaire's file, not standard input"));
        return EXIT_USAGE;
    }
    if (!(100 - dff < MOST_UPWARDS)) {
        message_error(_("--room: %.3g %% of the light goes upwards, and what it makes of the ceiling depends on how "
                        "far below it the luminaire hangs"),
                      100 - dff);
        message_hint(_("make a scene of the room, and ask luxel glare"));
        return EXIT_USAGE;
    }
    for (size_t triple = 0; triple < LUXEL_UGR_REFLECTANCES && (code == EXIT_DONE || code == EXIT_TOLERANCE);
         triple++) {
        const int done = rate_triple(options, table, triple, ratings);

        code = done == EXIT_DONE ? code : done;
    }
    ratings->exists = code == EXIT_DONE || code == EXIT_TOLERANCE;
    return code;
}
