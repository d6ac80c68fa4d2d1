/* SPDX-License-Identifier: MIT */
/* Unified glare ratings of a luminaire in one standard room, with the light that its walls really reflect. */
#ifndef LUXEL_CLI_PHOTOMETRY_ROOM_H
#define LUXEL_CLI_PHOTOMETRY_ROOM_H

#include <luxel/luxel.h>

#include "options.h"

/* For each triple of reflectances. */
struct room_ratings {
    bool exists;
    size_t room;                                      /* as luxel_ugr_room() counts them */
    luxel_bounded background[LUXEL_UGR_REFLECTANCES]; /* Lb in cd/m², where the height above the eye is 1 m */
    double ratings[2][LUXEL_UGR_REFLECTANCES];        /* crosswise, endwise; NaN: nothing dazzles */
    double errors[LUXEL_UGR_REFLECTANCES];            /* by the bound of the background's error */
};

/* The options --spacing and --room. */
bool room_take_spacing(struct options *options, const char *argument);
bool room_take(struct options *options, const char *argument);

/*
 * Rates the room of --room; without that option there are no ratings.  What stands in the way is printed here.
 * An enum exit_code; EXIT_TOLERANCE: the ratings hold, but their errors are greater than wished.
 */
int room_rate(const struct options *options, const luxel_photometry *photometry, const luxel_ugr_table *table,
              double dff, struct room_ratings *ratings);

#endif
