/* SPDX-License-Identifier: MIT */
/* Random tables of luminaires, as files. */
#ifndef TESTS_UNIT_LAMP_TABLES_H
#define TESTS_UNIT_LAMP_TABLES_H

#include "random_scenes.h"

enum { MOST_TEXT = 1 << 20 };

/* Appends to a text of which there is room for MOST_TEXT. */
void append(char *text, const char *format, ...);

/* Writes a lamp that is soft or narrow, whose table is even, or only in part, or ends in light; by way of `text`. */
void write_table(struct randomness *random, const char *path, char *text);

#endif
