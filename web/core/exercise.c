/* SPDX-License-Identifier: MIT */
/* Exercises: the numbered variants, and the judgement of an answer about the present scene. */
#include "answer.h"
#include "core.h"

/* The text of the variant with this number; NULL: there is none. */
PAGE_CALLS(page_variant) const char *page_variant(unsigned number)
{
    static char *text;
    luxel_text_free(text);
    text = NULL;
    return luxel_variant_text(number, fresh_diagnostics(), &text) == LUXEL_OK ? text : NULL;
}

static void answer_judgement(const luxel_judgement *judgement)
{
    static const char *const words[] = {[LUXEL_ANSWER_RIGHT] = "right",
                                        [LUXEL_ANSWER_CONVENTION] = "convention",
                                        [LUXEL_ANSWER_WRONG] = "wrong",
                                        [LUXEL_ANSWER_COARSE] = "coarse"};
    answer_open('{');
    answer_key("verdict");
    answer_string(words[judgement->verdict]);
    answer_key("value");
    if (judgement->has_value)
        answer_number(judgement->value);
    else
        answer_string(NULL);
    answer_key("error");
    answer_number(judgement->error);
    answer_key("explanations");
    answer_open('[');
    for (size_t i = 0; i < judgement->explanation_count; i++)
        answer_string(page_translate(judgement->explanations[i].meaning, NULL));
    answer_close(']');
    answer_close('}');
}

/* Judges what was typed for a point of the screen, to within a share of the value; NULL: it is no number. */
PAGE_CALLS(page_judge) const char *page_judge(const char *typed, double x_mm, double y_mm, double tolerance)
{
    const luxel_settings settings = present_settings();
    luxel_judgement *judgement = NULL;
    double value, rounding;
    if (!core.scene || !luxel_table_number(typed, &value, &rounding) ||
        luxel_judge_answer(core.scene, &settings, x_mm, y_mm, value, tolerance, rounding, fresh_diagnostics(),
                           &judgement) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_judgement(judgement);
    luxel_judgement_free(judgement);
    return answer_text();
}
