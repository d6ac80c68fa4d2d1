/* SPDX-License-Identifier: MIT */
/* From answers to judgements: each by the scene of its variant, of which the last ones are kept. */
#include "grading.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "progress.h"

enum { KEPT_VARIANTS = 16 };

#define DEFAULT_TOLERANCE 1e-3
#define MOST_ROUNDING 5e-3        /* of the answer */
#define MOST_ROUNDING_AT_ALL 1e-4 /* of the variant's largest value */

struct variant {
    unsigned number; /* 0: none yet */
    luxel_scene *scene;
    double largest; /* of the values at its points */
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

static luxel_status find_largest(const struct judging *judging, struct variant *variant)
{
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(variant->scene, &judging->settings, judging->diagnostics, &evaluator);

    for (size_t i = 0; status == LUXEL_OK && i < luxel_scene_point_count(variant->scene); i++) {
        double x_mm, y_mm;

        luxel_scene_point(variant->scene, i, &x_mm, &y_mm);
        variant->largest = fmax(variant->largest, luxel_evaluate(evaluator, x_mm, y_mm, NULL).value);
    }
    luxel_evaluator_free(evaluator);
    return status;
}

static luxel_status find_variant(struct judging *judging, unsigned number, const struct variant **found)
{
    struct variant *variant;
    luxel_status status;

    for (size_t i = 0; i < KEPT_VARIANTS; i++)
        if (judging->kept[i].number == number) {
            *found = &judging->kept[i];
            return LUXEL_OK;
        }
    variant = &judging->kept[judging->next++ % KEPT_VARIANTS];
    luxel_scene_free(variant->scene);
    *variant = (struct variant){.number = 0};
    status = open_variant(judging, number, &variant->scene);
    if (status == LUXEL_OK)
        status = find_largest(judging, variant);
    if (status == LUXEL_OK)
        variant->number = number;
    *found = variant;
    return status;
}

static luxel_status judge(struct judging *judging, struct grading *grading, struct graded *graded)
{
    const struct answer *answer = graded->answer;
    const struct variant *variant;
    luxel_status status = find_variant(judging, answer->variant, &variant);
    double most;

    if (status != LUXEL_OK)
        return status;
    graded->x_mm = answer->x_mm;
    graded->y_mm = answer->y_mm;
    if (answer->point > 0 &&
        luxel_scene_point(variant->scene, answer->point - 1, &graded->x_mm, &graded->y_mm) != LUXEL_OK) {
        answers_report(&grading->answers, answer, _("there is no point %u in variant %u"), answer->point,
                       answer->variant);
        return LUXEL_OK;
    }
    most = fmax(MOST_ROUNDING * fabs(answer->value), MOST_ROUNDING_AT_ALL * variant->largest);
    graded->rounding = isnan(answer->value) ? 0.0 : fmin(answer->rounding, most);
    return luxel_judge_answer(variant->scene, &judging->settings, graded->x_mm, graded->y_mm, answer->value,
                              grading->tolerance, graded->rounding, judging->diagnostics, &graded->judgement);
}

static luxel_status judge_all(struct judging *judging, struct grading *grading, struct progress *progress)
{
    const size_t count = grading->answers.count;
    luxel_status status = LUXEL_OK;

    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        grading->list[i].answer = &grading->answers.list[i];
        status = judge(judging, grading, &grading->list[i]);
        if (!progress_report((double)(i + 1) / (double)count, progress))
            break;
    }
    return status;
}

bool grading_is_coarse(const struct graded *graded)
{
    const luxel_judgement *judgement = graded->judgement;
    const struct answer *answer = graded->answer;

    return judgement->verdict == LUXEL_ANSWER_WRONG && judgement->has_value &&
           fabs(answer->value - judgement->value) <= answer->rounding;
}

/* The submission of an answer, which is that of the one before it, another, or a new one. */
static struct submission *find_submission(struct grading *grading, const struct answer *answer)
{
    struct submission *submission;

    for (size_t i = grading->submission_count; i-- > 0;) {
        submission = &grading->submissions[i];
        if (submission->file != answer->file)
            continue;
        if (submission->student == answer->student ||
            (submission->student && answer->student && strcmp(submission->student, answer->student) == 0))
            return submission;
    }
    submission = &grading->submissions[grading->submission_count++];
    *submission = (struct submission){.file = answer->file, .student = answer->student};
    return submission;
}

static void count(struct grading *grading)
{
    for (size_t i = 0; i < grading->answers.count; i++) {
        const struct graded *graded = &grading->list[i];

        if (!graded->judgement)
            continue;
        find_submission(grading, graded->answer)->counts[graded->judgement->verdict]++;
        grading->counts[graded->judgement->verdict]++;
    }
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
    for (size_t i = 0; i < options->operand_count; i++)
        answers_read(options->operands[i], &grading->answers);
    grading->list = message_allocate(grading->answers.count, sizeof *grading->list);
    grading->submissions = message_allocate(grading->answers.count, sizeof *grading->submissions);
    judging.diagnostics = message_new_diagnostics();
    progress_begin(&progress, options->quiet);
    status = judge_all(&judging, grading, &progress);
    progress_end(&progress);
    code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, judging.diagnostics);
    if (code == EXIT_DONE)
        count(grading);
    for (size_t i = 0; i < KEPT_VARIANTS; i++)
        luxel_scene_free(judging.kept[i].scene);
    luxel_diagnostics_free(judging.diagnostics);
    return code;
}

void grading_clear(struct grading *grading)
{
    for (size_t i = 0; i < grading->answers.count; i++)
        luxel_judgement_free(grading->list[i].judgement);
    free(grading->list);
    free(grading->submissions);
    answers_clear(&grading->answers);
}
