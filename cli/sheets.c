/* SPDX-License-Identifier: MIT */
/* Finding submissions and sheets, which mostly are those of the answer before, and what no answer was given for. */
#include "sheets.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

/* A place of a table may be rounded, but not so far. */
#define SAME_PLACE_MM 1e-6

struct place {
    double x_mm, y_mm;
    const struct answer *answer; /* the first one; NULL: none yet */
};

struct sheet {
    size_t submission;
    unsigned variant;
    struct place *points;
    size_t count, answered;
    bool has_blanks; /* of points that the submission names without an answer */
};

/* A list with room for one more. */
static void *with_room(void *list, size_t count, size_t *capacity, size_t size)
{
    void *grown;

    if (count < *capacity)
        return list;
    *capacity = *capacity > 0 ? 2 * *capacity : 16;
    grown = message_allocate(*capacity, size);
    if (count > 0)
        memcpy(grown, list, count * size);
    free(list);
    return grown;
}

/* The submission of an answer, which is that of the one before it, another, or a new one. */
static size_t find_submission(struct grading *grading, const struct answer *answer)
{
    struct submission *submission;

    for (size_t i = grading->submission_count; i-- > 0;) {
        submission = &grading->submissions[i];
        if (submission->file != answer->file)
            continue;
        if (submission->student == answer->student ||
            (submission->student && answer->student && strcmp(submission->student, answer->student) == 0))
            return i;
    }
    grading->submissions[grading->submission_count] =
        (struct submission){.file = answer->file, .student = answer->student};
    return grading->submission_count++;
}

static struct sheet *find_sheet(struct grading *grading, const struct graded *graded, const luxel_scene *scene)
{
    struct sheet *sheet;

    for (size_t i = grading->sheet_count; i-- > 0;) {
        sheet = &grading->sheets[i];
        if (sheet->submission == graded->submission && sheet->variant == graded->variant)
            return sheet;
    }
    grading->sheets = with_room(grading->sheets, grading->sheet_count, &grading->sheet_capacity, sizeof *sheet);
    sheet = &grading->sheets[grading->sheet_count++];
    *sheet = (struct sheet){
        .submission = graded->submission, .variant = graded->variant, .count = luxel_scene_point_count(scene)};
    sheet->points = message_allocate(sheet->count + 1, sizeof *sheet->points);
    for (size_t i = 0; i < sheet->count; i++)
        luxel_scene_point(scene, i, &sheet->points[i].x_mm, &sheet->points[i].y_mm);
    return sheet;
}

/* The number of the point that an answer is for, from 1; 0: it is for a place of its own. */
static unsigned find_point(const struct sheet *sheet, const struct graded *graded)
{
    if (graded->answer->point > 0)
        return graded->answer->point;
    for (size_t i = 0; i < sheet->count; i++)
        if (fabs(graded->x_mm - sheet->points[i].x_mm) <= SAME_PLACE_MM &&
            fabs(graded->y_mm - sheet->points[i].y_mm) <= SAME_PLACE_MM)
            return (unsigned)i + 1;
    return 0;
}

/* An earlier answer of the same submission to the same place, which is no point of the variant. */
static const struct answer *find_twin(const struct grading *grading, const struct graded *graded)
{
    for (const struct graded *other = grading->list; other < graded; other++)
        if (other->answer->file == graded->answer->file && other->submission == graded->submission &&
            other->variant == graded->variant && other->point == 0 && !other->first && !other->answer->is_blank &&
            fabs(graded->x_mm - other->x_mm) <= SAME_PLACE_MM && fabs(graded->y_mm - other->y_mm) <= SAME_PLACE_MM)
            return other->answer;
    return NULL;
}

void sheets_enter(struct grading *grading, struct graded *graded, const luxel_scene *scene)
{
    struct sheet *sheet;
    struct place *place;

    graded->submission = find_submission(grading, graded->answer);
    sheet = find_sheet(grading, graded, scene);
    graded->point = find_point(sheet, graded);
    if (graded->answer->is_blank) {
        sheet->has_blanks |= graded->point > 0;
        return;
    }
    if (graded->point == 0) {
        graded->first = find_twin(grading, graded);
        return;
    }
    place = &sheet->points[graded->point - 1];
    graded->first = place->answer;
    if (place->answer)
        return;
    place->answer = graded->answer;
    sheet->answered++;
}

void sheets_close(struct grading *grading)
{
    for (size_t i = 0; i < grading->sheet_count; i++) {
        const struct sheet *sheet = &grading->sheets[i];
        struct submission *submission = &grading->submissions[sheet->submission];

        if (sheet->answered == 0 && !sheet->has_blanks)
            continue;
        submission->asked += sheet->count;
        submission->answered += sheet->answered;
        for (size_t p = 0; p < sheet->count; p++) {
            if (sheet->points[p].answer)
                continue;
            grading->list = with_room(grading->list, grading->count, &grading->capacity, sizeof *grading->list);
            grading->list[grading->count++] = (struct graded){.submission = sheet->submission,
                                                              .variant = sheet->variant,
                                                              .point = (unsigned)p + 1,
                                                              .x_mm = sheet->points[p].x_mm,
                                                              .y_mm = sheet->points[p].y_mm};
        }
    }
}

char *sheets_variants(const struct grading *grading, size_t submission)
{
    char *text = message_allocate(grading->sheet_count * 12 + 1, 1), *end = text;

    for (size_t i = 0; i < grading->sheet_count; i++)
        if (grading->sheets[i].submission == submission)
            end += sprintf(end, "%s%u", end > text ? " " : "", grading->sheets[i].variant);
    return text;
}

void sheets_clear(struct grading *grading)
{
    for (size_t i = 0; i < grading->sheet_count; i++)
        free(grading->sheets[i].points);
    free(grading->sheets);
}
