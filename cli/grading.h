/* SPDX-License-Identifier: MIT */
/* Judges answers by the variants that they are for, and finds those that are missing or given twice. */
#ifndef LUXEL_CLI_GRADING_H
#define LUXEL_CLI_GRADING_H

#include <luxel/luxel.h>

#include "answers.h"
#include "options.h"

/* What an answer is found to be, or a point without one. */
enum grade {
    GRADE_RIGHT,
    GRADE_CONVENTION, /* of another convention, which is named */
    GRADE_WRONG,
    GRADE_COARSE,   /* right as far as its digits go, but too few of them */
    GRADE_REPEATED, /* the same point was answered before: whatever it is, it does not count */
    GRADE_MISSING,  /* a point of a variant that nobody answered */
    GRADE_COUNT
};

/* The grade in JSON and CSV. */
extern const char *const grade_words[GRADE_COUNT];

/* An answer with its judgement, or a point that has none. */
struct graded {
    const struct answer *answer; /* NULL: it is missing */
    const struct answer *first;  /* the earlier answer to the same point; NULL: none */
    size_t submission;
    unsigned variant;
    unsigned point; /* of the variant, from 1, also where x and y tell it; 0: none of them */
    double x_mm, y_mm;
    luxel_judgement *judgement; /* NULL: missing, blank, or its point is none, which was reported */
    bool is_of_pixel;           /* right as the value of the pixel that the point falls in, which was accepted */
};

/* A file, or what one student has in it. */
struct submission {
    size_t file;
    const char *student; /* NULL: the whole file */
    size_t asked;        /* points of the variants that it answers, */
    size_t answered;     /* and how many of them it does */
    size_t counts[GRADE_COUNT];
};

/* A variant in a submission. */
struct sheet;

struct grading {
    struct answers answers;
    double tolerance;
    struct graded *list; /* one for each answer, then one for each that is missing */
    size_t count, capacity;
    struct submission *submissions;
    size_t submission_count;
    struct sheet *sheets;
    size_t sheet_count, sheet_capacity;
    size_t counts[GRADE_COUNT];
};

/*
 * Reads the tables named on the command line and judges them.  Nothing is missing of a variant of which a submission
 * answers none of the points, but places of its own.
 * Returns an enum exit_code, EXIT_DONE whatever the answers are; grading_clear() is due in either case.
 */
int grading_make(const struct options *options, struct grading *grading);
void grading_clear(struct grading *grading);

/* What was judged, and what is missing. */
size_t grading_total(const struct grading *grading);

/* How many times the right value an answer is; NaN where there is none, or it is 0. */
double grading_factor(const struct graded *graded);

/* Whether it is one of these. */
bool grading_tells(const struct graded *graded);
enum grade grading_grade(const struct graded *graded);

#endif
