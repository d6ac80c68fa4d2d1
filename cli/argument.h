/* SPDX-License-Identifier: MIT */
/* Numbers in arguments: decimal, with a point, nothing before or after them, in every locale. */
#ifndef LUXEL_CLI_ARGUMENT_H
#define LUXEL_CLI_ARGUMENT_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/luxel.h>

/* Reads one number.  False, with a message that names `option` and the number that is wrong, if it is none. */
bool argument_number(const char *option, const char *text, double *value);

/* Reads a number above 0 and below 1, and seconds, above 0. */
bool argument_share(const char *option, const char *text, double *share);
bool argument_seconds(const char *option, const char *text, double *seconds);

/* Reads exactly `count` numbers with commas between them; `form` shows how they are expected: "X,Y". */
bool argument_numbers(const char *option, const char *form, const char *text, double *values, size_t count);

/* Reads a whole number from least to most. */
bool argument_whole(const char *option, const char *text, unsigned least, unsigned most, unsigned *value);

/* I/N: part I of N, from 0 or from 1 on; it becomes one from 0 on. */
bool argument_shard(const char *text, unsigned *part, unsigned *parts);

/* Numbers with commas between them, `most` at most; a comma behind the last is borne: "5," is the one level 5. */
bool argument_levels(const char *text, double *levels, size_t most, size_t *count);

/* Finds a word in a list that ends with NULL; names them all, and the nearest, if it is none of them. */
bool argument_word(const char *option, const char *text, const char *const *words, size_t *found);

/* X,Y,W,H is a rectangle around X,Y; X,Y,R a circle. */
bool argument_region(const char *option, const char *argument, luxel_region *region);

#endif
