/* SPDX-License-Identifier: MIT */
/* What the two halves of the reader of LM-63 share: texts and TILT before the numbers, and the numbers. */
#ifndef LX_FORMAT_PHOTOMETRY_LM63_H
#define LX_FORMAT_PHOTOMETRY_LM63_H

#include "photometry.h"

/* The numbers of the header: ten, and three behind them. */
enum lx_lm63_number {
    LX_LM63_LAMPS,
    LX_LM63_LUMENS,
    LX_LM63_MULTIPLIER,
    LX_LM63_ANGLES,
    LX_LM63_PLANES,
    LX_LM63_TYPE,
    LX_LM63_UNITS,
    LX_LM63_WIDTH,
    LX_LM63_LENGTH,
    LX_LM63_HEIGHT,
    LX_LM63_BALLAST,
    LX_LM63_LAMP_BALLAST,
    LX_LM63_WATTS,
    LX_LM63_NUMBERS
};

/* A file with its words: numbers between blanks and commas, whatever the lines are. */
struct lx_lm63 {
    struct lx_luminaire_file *file;
    unsigned year;
    bool is_odd_tag;     /* of no year that is known */
    bool decimal_commas; /* commas are in numbers, not between them */
    bool has_tilt;       /* TILT=INCLUDE: its numbers come first */
    double numbers[LX_LM63_NUMBERS];
    struct lx_token tokens[LX_LM63_NUMBERS];
};

/* The next word; false at the end. */
bool lx_lm63_word(struct lx_lm63 *lm63, struct lx_token *token);
/*
 * The next number, called `name` in reports; what is none is reported and becomes NaN.  False: the file ends, which is
 * reported, too.
 */
bool lx_lm63_next(struct lx_lm63 *lm63, const char *name, double *number, struct lx_token *token);

/* Reports that a number is not as it should be. */
void lx_lm63_unfit(struct lx_lm63 *lm63, const char *name, double number, struct lx_token token, const char *expected);

/* The factors for the tilt of the lamp, as they stand at this place. */
void lx_lm63_read_tilt(struct lx_lm63 *lm63);

/* Finds out whether commas are decimal. */
void lx_lm63_judge_commas(struct lx_lm63 *lm63);

/* Everything behind TILT. */
void lx_lm63_read_numbers(struct lx_lm63 *lm63);

#endif
