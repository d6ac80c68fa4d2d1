/* SPDX-License-Identifier: MIT */
/* From answers to judgements: each by the scene of its variant, of which the last ones are kept. */
#include "grading.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "progress.h"
#include "sheets.h"

enum { KEPT_VARIANTS = 16 };

#define DEFAULT_TOLERANCE 1e-3

const char *const grade_words[GRADE_COUNT] = {"right", "convention", "wrong", "too_few_digits", "repeated", "missing"};

struct variant {
    unsigned number; /* 0: none yet */
    luxel_scene *scene;
};

struct judging {
    const struct options *options;
    luxel_settings settings;
    luxel_diagnostics *diagnostics;
    struct variant kept[KEPT_VARIANTS];
    size_t next;
};

/* The scene of a variant with the changes of -s. */
static luxel_status open_variant(const struct judging *judging, unsigned number, luxel_scene **scene)
{
    char *text = NULL;
    luxel_status status = luxel_variant_text(number, judging->diagnostics, &text);

    if (status == LUXEL_OK)
        status = luxel_scene_read_text(text, strlen(text), "variant", judging->diagnostics, scene);
    luxel_text_free(text);
    for (size_t i = 0; status == LUXEL_OK && i < judging->options->assignment_count; i++)
        status = luxel_scene_set(*scene, judging->options->assignments[i], judging->diagnostics);
    return status == LUXEL_OK ? luxel_scene_commit(*scene, judging->diagnostics) : status;
}

static luxel_status find_variant(struct judging *judging, unsigned number, const luxel_scene **found)
{
    struct variant *variant;
    luxel_status status;

    for (size_t i = 0; i < KEPT_VARIANTS; i++)
        if (judging->kept[i].number == number) {
            *found = judging->kept[i].scene;
            return LUXEL_OK;
        }
    variant = &judging->kept[judging->next++ % KEPT_VARIANTS];
    luxel_scene_free(variant->scene);
    *variant = (struct variant){.number = 0};
    status = open_variant(judging, number, &variant->scene);
    if (status == LUXEL_OK)
        variant->number = number;
    *found = variant->scene;
    return status;
}

/* By the value at the point, and where that is accepted by that of its pixel. */
static luxel_status judge_as(const struct judging *judging, const struct grading *grading, struct graded *graded,
                             const luxel_scene *scene)
{
    const double value = graded->answer->value, rounding = isnan(value) ? 0.0 : graded->answer->rounding;
    luxel_judgement *of_pixel = NULL;
    luxel_status status = luxel_judge_answer(scene, &judging->settings, graded->x_mm, graded->y_mm, value,
                                             grading->tolerance, rounding, judging->diagnostics, &graded->judgement);

    if (status != LUXEL_OK || !judging->options->accepts_pixel || graded->judgement->verdict == LUXEL_ANSWER_RIGHT)
        return status;
    status = luxel_judge_pixel_answer(scene, &judging->settings, graded->x_mm, graded->y_mm, value, grading->tolerance,
                                      rounding, judging->diagnostics, &of_pixel);
    if (status != LUXEL_OK || of_pixel->verdict != LUXEL_ANSWER_RIGHT) {
        luxel_judgement_free(of_pixel);
        return status;
    }
    luxel_judgement_free(graded->judgement);
    graded->judgement = of_pixel;
    graded->is_of_pixel = true;
    return LUXEL_OK;
}

static luxel_status judge(struct judging *judging, struct grading *grading, struct graded *graded)
{
    const struct answer *answer = graded->answer;
    const luxel_scene *scene;
    luxel_status status = find_variant(judging, answer->variant, &scene);

    if (status != LUXEL_OK)
        return status;
    graded->variant = answer->variant;
    graded->x_mm = answer->x_mm;
    graded->y_mm = answer->y_mm;
    if (answer->point > 0 && luxel_scene_point(scene, answer->point - 1, &graded->x_mm, &graded->y_mm) != LUXEL_OK) {
        answers_report(&grading->answers, answer, _("there is no point %u in variant %u"), answer->point,
                       answer->variant);
        return LUXEL_OK;
    }
    sheets_enter(grading, graded, scene);
    return answer->is_blank ? LUXEL_OK : judge_as(judging, grading, graded, scene);
}

static luxel_status judge_all(struct judging *judging, struct grading *grading, struct progress *progress)
{
    const size_t count = grading->answers.count;
    luxel_status status = LUXEL_OK;

    for (size_t i = 0; i < count; i++)
        grading->list[i].answer = &grading->answers.list[i];
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        status = judge(judging, grading, &grading->list[i]);
        if (!progress_report((double)(i + 1) / (double)count, progress))
            break;
    }
    return status;
}

double grading_factor(const struct graded *graded)
{
    const luxel_judgement *judgement = graded->judgement;

    return judgement && judgement->has_value && judgement->value != 0.0 ? graded->answer->value / judgement->value
                                                                        : (double)NAN;
}

bool grading_tells(const struct graded *graded)
{
    return !graded->answer || graded->judgement;
}

enum grade grading_grade(const struct graded *graded)
{
    static const enum grade grades[] = {
        [LUXEL_ANSWER_RIGHT] = GRADE_RIGHT,
        [LUXEL_ANSWER_CONVENTION] = GRADE_CONVENTION,
        [LUXEL_ANSWER_WRONG] = GRADE_WRONG,
        [LUXEL_ANSWER_COARSE] = GRADE_COARSE,
    };

    if (!graded->answer)
        return GRADE_MISSING;
    return graded->first ? GRADE_REPEATED : grades[graded->judgement->verdict];
}

static void count(struct grading *grading)
{
    for (size_t i = 0; i < grading->count; i++) {
        const struct graded *graded = &grading->list[i];
        enum grade grade;

        if (!grading_tells(graded))
            continue;
        grade = grading_grade(graded);
        grading->submissions[graded->submission].counts[grade]++;
        grading->counts[grade]++;
    }
}

size_t grading_total(const struct grading *grading)
{
    size_t total = 0;

    for (size_t i = 0; i < GRADE_COUNT; i++)
        total += grading->counts[i];
    return total;
}

int grading_make(const struct options *options, struct grading *grading)
{
    struct judging judging = {.options = options, .settings = options->settings};
    struct progress progress;
    luxel_status status;
    int code;

    *grading = (struct grading){.tolerance = options->settings.tolerance};
    if (!(grading->tolerance > 0))
        grading->tolerance = DEFAULT_TOLERANCE;
    judging.settings.tolerance = 0; /* of the exact values */
    grading->answers.is_quiet = options->quiet;
    for (size_t i = 0; i < options->operand_count; i++)
        answers_read(options->operands[i], &grading->answers);
    grading->count = grading->capacity = grading->answers.count;
    grading->list = message_allocate(grading->count, sizeof *grading->list);
    grading->submissions = message_allocate(grading->answers.count, sizeof *grading->submissions);
    judging.diagnostics = message_new_diagnostics();
    progress_begin(&progress, options->quiet);
    status = judge_all(&judging, grading, &progress);
    progress_end(&progress);
    code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, judging.diagnostics);
    if (code == EXIT_DONE) {
        sheets_close(grading);
        count(grading);
    }
    for (size_t i = 0; i < KEPT_VARIANTS; i++)
        luxel_scene_free(judging.kept[i].scene);
    luxel_diagnostics_free(judging.diagnostics);
    return code;
}

void grading_clear(struct grading *grading)
{
    for (size_t i = 0; i < grading->count; i++)
        luxel_judgement_free(grading->list[i].judgement);
    free(grading->list);
    free(grading->submissions);
    sheets_clear(grading);
    answers_clear(&grading->answers);
}
