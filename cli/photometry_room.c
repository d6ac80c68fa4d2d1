/* SPDX-License-Identifier: MIT */
/* The options --spacing and --room, and the ratings of that room. */
#include "photometry_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "argument.h"
#include "cli.h"
#include "message.h"
#include "work.h"

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

/* ---- ratings ---- */

static int rate_triple(const struct options *options, const luxel_ugr_table *table, size_t triple,
                       struct room_ratings *ratings)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    luxel_room_rating rating = {0};
    struct work work;
    luxel_status status;
    int code;

    work_begin(&work, options);
    work.settings.reflected_error = 0;
    status =
        luxel_find_room_rating(options->operand, table, ratings->room, triple, &work.settings, diagnostics, &rating);
    code = work_end(&work, status, diagnostics);
    ratings->background[triple] = rating.background;
    for (int way = 0; way < 2; way++)
        ratings->ratings[way][triple] = rating.ratings[way];
    ratings->errors[triple] = rating.error;
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
        message_error(photometry->type == LUXEL_PHOTOMETRY_TYPE_C
                          ? _("--room: the luminaire is a point, and has no luminance towards an observer")
                          : _("--room: types A and B do not say how the luminaire hangs in a room"));
        return EXIT_USAGE;
    }
    if (strcmp(options->operand, "-") == 0) {
        message_error(_("--room needs the name of the luminaire's file, not standard input"));
        return EXIT_USAGE;
    }
    if (!(100 - dff < LUXEL_ROOM_UPWARDS)) {
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
