/* SPDX-License-Identifier: MIT */
/*
 * Numbers as people type them, with a decimal point or comma in every language, as scenes have them, with a point, and
 * as they are shown, with the mark of the language; and lists of numbers that are pasted, "x, y, z; x, y, z".
 */
#ifndef LUXEL_APP_NUMBER_H
#define LUXEL_APP_NUMBER_H

#include <glib.h>

enum { APP_NUMBER_SIZE = 40 };

/*
 * Reads one number: "0.45", "0,45", "1e3", "-2", "−2", blanks around it and between groups of three digits allowed
 * ("10 000").  FALSE for anything else, such as "1,2,3", "" or what is not finite.
 */
gboolean app_number_read(const char *text, double *value);

/* Writes the shortest text that reads back as the same number; returns `text`. */
const char *app_number_write(double value, char text[APP_NUMBER_SIZE]);

/* Writes it with so many significant digits, without zeros at the end; returns `text`. */
const char *app_number_round(double value, int digits, char text[APP_NUMBER_SIZE]);

/* Rounds it to so many significant digits and writes it as people do, "3000" and not "3e+03"; returns `text`. */
const char *app_number_plain(double value, int digits, char text[APP_NUMBER_SIZE]);

/* ---- for people alone ---- */

/* The mark in front of fractions of numbers that are shown, '.' at first; once, before any is. */
void app_number_set_mark(char mark);

/*
 * A number that was written with a point gets that mark, and a minus as wide as a plus, for which there is room for two
 * letters more; returns `text`.
 */
const char *app_number_mark(char *text);

/* As app_number_round(), but from 1 to a million as app_number_plain(), to be shown. */
const char *app_number_show(double value, int digits, char text[APP_NUMBER_SIZE]);
/* A bound of an error to be shown, rounded up so that it still is one. */
const char *app_bound_show(double error, int digits, char text[APP_NUMBER_SIZE]);
/* As app_number_write() with that mark and the minus of the keyboard, for fields, and for what is copied. */
const char *app_number_show_all(double value, char text[APP_NUMBER_SIZE]);

/* The separator of numbers that are shown: ", ", or "; " where the mark is a comma. */
const char *app_number_separator(void);

/*
 * A text of the library as it is shown: its numbers get the mark and the minus, and where the mark is a comma the
 * numbers of a list in brackets are set apart by semicolons, "(60; −20; 893,2576)"; the caller's.
 */
char *app_text_show(const char *text);

/*
 * Writes a number with the bound of its error, "208.33 ± 0.086": no digits beyond those of the bound, which is rounded
 * up and covers the rounding of the number; returns `text`.
 */
enum { APP_AMOUNT_SIZE = 2 * APP_NUMBER_SIZE + 8 };
const char *app_amount_write(double value, double error, char text[APP_AMOUNT_SIZE]);

/*
 * Writes a place on a screen of this size, of which a millionth part is resolved: what lies below is none, and reads 0.
 */
const char *app_number_place(double value, double size, char text[APP_NUMBER_SIZE]);

/* ---- lists ---- */

/*
 * Reads groups of `size` numbers with commas, blanks or semicolons between them, the groups set apart by semicolons or
 * line breaks; brackets around groups are ignored.  Within a group that is set apart by blanks or tabs alone, or by
 * semicolons in a text whose groups stand on lines of their own, a comma is a decimal comma.
 * Returns count x size numbers, the caller's; NULL with *fault, the caller's, the group that is no such group.
 */
double *app_numbers_read(const char *text, gsize size, gsize *count, char **fault);

/*
 * Reads one pair, "x, y", "x y" or "x; y"; with blanks alone or a semicolon between them commas are decimal commas.
 * FALSE for "60,5", too, which may be a pair, or one number with a decimal comma.
 */
gboolean app_pair_read(const char *text, double pair[2]);

/* Reads the numbers of a YAML list such as "[0, 0, 1000]" or of a single number: at most `room`; returns how many. */
gsize app_list_read(const char *text, double *numbers, gsize room);

/* Numbers as a YAML list, "[0, 0, 1000]"; the caller's. */
char *app_list_write(const double *numbers, gsize count);

#endif
