/* SPDX-License-Identifier: MIT */
/* A luminaire file that was read, with what is measured in it: what luxel photometry shows and writes. */
#ifndef LUXEL_CLI_PHOTOMETRY_H
#define LUXEL_CLI_PHOTOMETRY_H

#include <luxel/luxel.h>

#include "options.h"
#include "photometry_room.h"

struct luminaire {
    const char *name; /* as results show it */
    luxel_photometry *photometry;
    luxel_photometry_figures figures;
    luxel_ugr_table glare;
    double zones[LUXEL_FLUX_ZONES];
    luxel_utilization_table utilization;
    luxel_bug_rating bug;
    struct room_ratings room;
    luxel_diagnostics *diagnostics; /* its advice are the warnings */
};

/* Reads FILE; what is wrong is printed here.  An enum exit_code; luminaire_close() is due in every case. */
int luminaire_open(const struct options *options, struct luminaire *luminaire);
void luminaire_close(struct luminaire *luminaire);

/* The i-th warning with its place, in the language of the user or in English; NULL beyond the last.  For free(). */
char *luminaire_warning(const struct luminaire *luminaire, size_t i, bool in_english);

/* Whether a file of -o is the luminaire's sheet, not a diagram alone. */
bool luminaire_is_sheet(const struct options *options, const char *path);

/* Draws a luminaire to a file. */
typedef luxel_status luminaire_draw(const struct options *options, const struct luminaire *luminaire, const char *path,
                                    luxel_diagnostics *diagnostics);

/* The command itself: writes the files of -o, figures by `draw` (NULL: none is one), and prints the numbers. */
int luminaire_show(const struct options *options, luminaire_draw *draw);

void luminaire_print_json(const struct luminaire *luminaire);

#endif
