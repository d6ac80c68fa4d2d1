/* SPDX-License-Identifier: MIT */
/*
 * Any table of answers, as `luxel grade` reads it; an answer that stands alone is judged, which takes a while.  Lines
 * that are no answers are reported, in words that do no harm to a terminal.
 */
#include "fuzz.h"

#include <math.h>
#include <string.h>

#include "../cli/answers.h"

static const char scene_text[] = "luxel: 1\n"
                                 "screen: {width: 600, height: 600, resolution: [8, 8]}\n"
                                 "observer: {z: 5000}\n"
                                 "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 250}]\n"
                                 "lights: [{type: point, position: [500, 0, 2000], intensity: 10}]\n";

static void check(const struct answer *answer)
{
    fuzz_must(answer->file == 0 && answer->line >= 1, "an answer has a line of its table");
    fuzz_must(answer->variant >= 1 && answer->variant <= LUXEL_LAST_VARIANT, "there is such a variant");
    fuzz_must(isfinite(answer->x_mm) && isfinite(answer->y_mm), "a place has numbers");
    fuzz_must(!isinf(answer->value) && answer->rounding >= 0, "a value is a number, or none");
    fuzz_must(!answer->student || *answer->student, "who is named has a name");
}

static void judge(const luxel_scene *scene, const struct answer *answer)
{
    luxel_judgement *judgement;
    double rounding = fmin(answer->rounding, 1);
    if (luxel_judge_answer(scene, NULL, answer->x_mm, answer->y_mm, answer->value, 1e-3, rounding, NULL, &judgement) !=
        LUXEL_OK)
        return;
    bool is_explained = judgement->verdict == LUXEL_ANSWER_CONVENTION;
    fuzz_must(is_explained ? judgement->explanation_count - 1 < 2 : judgement->explanation_count == 0,
              "one or two choices explain");
    for (size_t i = 0; i < judgement->explanation_count; i++)
        fuzz_must(*judgement->explanations[i].convention && *judgement->explanations[i].choice, "choices have names");
    if (judgement->verdict == LUXEL_ANSWER_RIGHT && judgement->has_value)
        fuzz_must(fabs(answer->value - judgement->value) <= 1e-3 * judgement->value + rounding, "right is near");
    luxel_judgement_free(judgement);
}

static void judge_alone(const struct answer *answer)
{
    luxel_scene *scene;
    fuzz_must(luxel_scene_read_text(scene_text, strlen(scene_text), "fuzz", NULL, &scene) == LUXEL_OK &&
                  luxel_scene_commit(scene, NULL) == LUXEL_OK,
              "the scene of the answers");
    judge(scene, answer);
    luxel_scene_free(scene);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_file file = fuzz_open(data, size, ".csv");
    struct answers answers = {.is_quiet = true};
    struct fuzz_words words;
    fuzz_listen(&words);
    answers_read(file.path, &answers);
    size_t lines = fuzz_heard(&words);
    fuzz_must(answers.mistakes == 0 ? lines == 0 : lines >= answers.mistakes, "mistakes are told, and nothing else");
    for (size_t i = 0; i < answers.count; i++)
        check(&answers.list[i]);
    if (answers.count == 1)
        judge_alone(answers.list);
    answers_clear(&answers);
    fuzz_close(&file);
    return 0;
}
