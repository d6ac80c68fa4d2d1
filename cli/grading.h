/* SPDX-License-Identifier: MIT */
/* Judges answers by the variants that they are for, and counts them for each submission. */
#ifndef LUXEL_CLI_GRADING_H
#define LUXEL_CLI_GRADING_H

#include <luxel/luxel.h>

#include "answers.h"
#include "options.h"

/* An answer with its judgement. */
struct graded {
    const struct answer *answer;
    double x_mm, y_mm;
    double rounding;            /* what its digits were granted; see grading_judge() */
    luxel_judgement *judgement; /* NULL: it was not judged, since its point is none; that was reported */
};

/* A file, or what one student has in it. */
struct submission {
    size_t file;
    const char *student; /* NULL: the whole file */
    size_t counts[3];    /* by luxel_verdict */
};

struct grading {
    struct answers answers;
    double tolerance;
    struct graded *list; /* one for each answer */
    struct submission *submissions;
    size_t submission_count;
    size_t counts[3]; /* by luxel_verdict */
};

/*
 * Reads the tables named on the command line and judges them.  The digits of an answer are granted their half unit, but
 * no more than 0.5 % of it or 1e-4 of the largest of the variant's points: three digits are asked for.
 * Returns an enum exit_code, EXIT_DONE whatever the answers are; grading_clear() is due in either case.
 */
int grading_make(const struct options *options, struct grading *grading);
void grading_clear(struct grading *grading);

/* Whether a wrong answer would be right if so few digits were enough. */
bool grading_is_coarse(const struct graded *graded);

#endif
