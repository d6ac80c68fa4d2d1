/* SPDX-License-Identifier: MIT */
/* Numbers as text, with a decimal point in every locale. */
#ifndef LX_BASE_NUMBER_H
#define LX_BASE_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

enum { LX_NUMBER_SIZE = 40 }; /* room for any number written here */

/*
 * Reads a decimal number (optional sign, digits, optional fraction and exponent; YAML 1.2 core, without
 * hexadecimal, octal, infinity and NaN).  The whole text must be the number.  False if it is not one or does
 * not fit a double.
 */
bool lx_read_number(const char *text, size_t length, double *value);

/* Whether the text has the form of a number that lx_read_number() reads, be it in a double's range or not. */
bool lx_looks_like_number(const char *text, size_t length);

/* Writes with the fewest digits that read back as the same double: 0.1, 300, 1e-07.  Returns buffer. */
char *lx_write_number(double value, char buffer[LX_NUMBER_SIZE]);

/* Writes with `digits` significant digits like printf's %.*g.  Returns buffer. */
char *lx_write_digits(double value, int digits, char buffer[LX_NUMBER_SIZE]);

/* The least number of so many significant digits that is not below a value above 0; another value as it is. */
double lx_round_up(double value, int digits);
/* The bound of a number as a text shows it, which has rounded something away. */
double lx_error_of_shown(const char *shown, double value, double error);
/* Writes a bound, rounded up so that it is still one.  Returns buffer. */
char *lx_write_bound(double error, int digits, char buffer[LX_NUMBER_SIZE]);

#endif
