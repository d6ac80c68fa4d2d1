/* SPDX-License-Identifier: MIT */
/*
 * Sheets: which points of a variant a submission has answered, so that it can be told which are missing, and which were
 * answered twice.
 */
#ifndef LUXEL_CLI_SHEETS_H
#define LUXEL_CLI_SHEETS_H

#include "grading.h"

/*
 * Enters an answer whose place is known into the sheet of its submission and variant: finds its submission, its point
 * where a place is that of one, and the answer that the point has already.
 */
void sheets_enter(struct grading *grading, struct graded *graded, const luxel_scene *scene);

/* Appends what is missing, once all answers are entered. */
void sheets_close(struct grading *grading);
/* The variants of a submission, "5 6"; free() it. */
char *sheets_variants(const struct grading *grading, size_t submission);
void sheets_clear(struct grading *grading);

#endif
