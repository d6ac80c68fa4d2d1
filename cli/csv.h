/* SPDX-License-Identifier: MIT */
/*
 * Writes tables as comma-separated values: RFC 4180, lines ending in CR LF, or as spreadsheets in Russia read them,
 * with semicolons, decimal commas and a byte order mark.  Numbers read back as the same double.
 */
#ifndef LUXEL_CLI_CSV_H
#define LUXEL_CLI_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "options.h"

struct csv {
    FILE *stream;
    enum option_csv variant; /* not CSV_NONE */
    bool in_line;
};

void csv_begin(struct csv *csv, FILE *stream, enum option_csv variant);
void csv_text(struct csv *csv, const char *text);
/* "value_W/sr": a name, and where the unit is known the unit */
void csv_heading(struct csv *csv, const char *name, const char *unit);
void csv_number(struct csv *csv, double value);
void csv_whole(struct csv *csv, size_t value);
void csv_blank(struct csv *csv);
void csv_end_line(struct csv *csv);

/*
 * Writes a table, which `write` makes, to standard output if --csv was given, and to each FILE of -o, whole or not at
 * all.  Returns an enum exit_code; failures are printed here, and one file that fails does not stop the others.
 */
int csv_write(const struct options *options, void (*write)(struct csv *csv, const void *data), const void *data);

#endif
