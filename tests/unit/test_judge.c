/* SPDX-License-Identifier: MIT */
/* Judging answers: right ones, those that another convention gives, slips, pairs, and wrong ones. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static luxel_scene *open_report(const char *const *assignments)
{
    luxel_scene *scene;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    for (; assignments && *assignments; assignments++)
        assert_int_equal(luxel_scene_set(scene, *assignments, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_judgement *judge(const luxel_scene *scene, double x_mm, double y_mm, double answer, double rounding)
{
    luxel_judgement *judgement = NULL;
    assert_int_equal(luxel_judge_answer(scene, NULL, x_mm, y_mm, answer, 1e-3, rounding, NULL, &judgement), LUXEL_OK);
    return judgement;
}

static void expect_verdict(const luxel_scene *scene, double x_mm, double y_mm, double answer, double rounding,
                           luxel_judgement_verdict verdict)
{
    luxel_judgement *judgement = judge(scene, x_mm, y_mm, answer, rounding);
    if (judgement->verdict != verdict)
        fail_msg("%g at (%g, %g): verdict %d", answer, x_mm, y_mm, (int)judgement->verdict);
    assert_int_equal(judgement->explanation_count > 0, verdict == LUXEL_ANSWER_CONVENTION);
    luxel_judgement_free(judgement);
}

/* The one explanation is this choice (and, where there is a second, that). */
static void expect_choice(const luxel_scene *scene, double answer, double rounding, const char *first,
                          const char *second)
{
    luxel_judgement *judgement = judge(scene, 0, 0, answer, rounding);
    assert_int_equal(judgement->verdict, LUXEL_ANSWER_CONVENTION);
    assert_int_equal(judgement->explanation_count, second ? 2 : 1);
    assert_string_equal(judgement->explanations[0].choice, first);
    if (second)
        assert_string_equal(judgement->explanations[1].choice, second);
    luxel_judgement_free(judgement);
}

static void knows_right_answers(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    expect_verdict(scene, 0, 0, 2.7275906525546927, 0, LUXEL_ANSWER_RIGHT);
    expect_verdict(scene, 0, 0, 2.7276, 0.5e-4, LUXEL_ANSWER_RIGHT);
    expect_verdict(scene, 0, 0, 2.7275906525546927 * 1.00099, 0, LUXEL_ANSWER_RIGHT);
    expect_verdict(scene, 0, 0, 2.7275906525546927 * 1.00101, 0, LUXEL_ANSWER_WRONG);
    expect_verdict(scene, 0, 0, 2.7275906525546927 * 1.0011, 0.5e-3, LUXEL_ANSWER_RIGHT);
    expect_verdict(scene, 400, 0, (double)NAN, 0, LUXEL_ANSWER_RIGHT);
    luxel_judgement *judgement = judge(scene, 0, 0, 1, 0);
    assert_true(judgement->has_value && fabs(judgement->value - 2.7275906525546927) <= judgement->error + 1e-15);
    luxel_judgement_free(judgement);
    judgement = judge(scene, 400, 0, 1, 0);
    assert_true(!judgement->has_value && judgement->value == 0 && judgement->verdict == LUXEL_ANSWER_WRONG);
    luxel_judgement_free(judgement);
    luxel_scene_free(scene);
}

/* The value is 2.72759...; its own rounding to fewer digits is that, before any convention is thought of. */
static void judges_rounding_first(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    expect_verdict(scene, 0, 0, 2.73, 0.5e-2, LUXEL_ANSWER_RIGHT);
    expect_verdict(scene, 0, 0, 2.7, 0.05, LUXEL_ANSWER_COARSE);
    expect_verdict(scene, 0, 0, 3, 0.5, LUXEL_ANSWER_COARSE);
    expect_verdict(scene, 0, 0, 0, 5, LUXEL_ANSWER_COARSE);
    expect_verdict(scene, 0, 0, 2.6, 0.05, LUXEL_ANSWER_WRONG);
    expect_verdict(scene, 0, 0, 2, 0.5, LUXEL_ANSWER_WRONG);
    expect_verdict(scene, 0, 0, 2.71, 0.5e-2, LUXEL_ANSWER_WRONG);
    expect_verdict(scene, -150, 0, 0, 0.5, LUXEL_ANSWER_RIGHT); /* 1.1e-7, of 11 */
    luxel_scene_free(scene);
    /* 2.5 is 2.50, whose last digit spreadsheets drop, but 2.4 is not 2.35 */
    char intensity[64];
    snprintf(intensity, sizeof intensity, "lights[0].intensity=%.17g", 10 * 2.5039 / 2.7275906525546927);
    scene = open_report((const char *const[]){intensity, NULL});
    expect_verdict(scene, 0, 0, 2.5, 0.05, LUXEL_ANSWER_RIGHT);
    luxel_scene_free(scene);
    snprintf(intensity, sizeof intensity, "lights[0].intensity=%.17g", 10 * 2.353 / 2.7275906525546927);
    scene = open_report((const char *const[]){intensity, NULL});
    expect_verdict(scene, 0, 0, 2.4, 0.05, LUXEL_ANSWER_COARSE);
    luxel_scene_free(scene);
}

static void knows_wrong_answers(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    static const double wrong[] = {0, 1e9, -2.7276, 5.123456, HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        expect_verdict(scene, 0, 0, wrong[i], 0, LUXEL_ANSWER_WRONG);
    expect_verdict(scene, 0, 0, (double)NAN, 0, LUXEL_ANSWER_WRONG);
    luxel_scene_free(scene);
}

/* The numbers that the report itself prints are those of pixels. */
static void explains_the_report(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    expect_choice(scene, 2.7488, 0.5e-4, "pixel", NULL);
    luxel_judgement *judgement = judge(scene, 150, 0, 11.0240, 0.5e-4);
    assert_string_equal(judgement->explanations[0].choice, "pixel");
    assert_true(fabs(judgement->explanations[0].value - 11.0240) < 1e-4);
    assert_null(judgement->explanations[0].assignment);
    luxel_judgement_free(judgement);
    luxel_scene_free(scene);
}

/* Answers made by a scene with one convention changed, or two. */
static void explains_conventions(void **state)
{
    (void)state;
    static const struct {
        const char *change[3], *choices[2];
    } cases[] = {
        {{"surfaces[0].material.over_pi=true"}, {"true"}},
        {{"surfaces[0].material.model=phong"}, {"phong"}},
        {{"surfaces[0].material.model=lambert"}, {"lambert"}},
        {{"surfaces[0].material.highlight=cosine"}, {"cosine"}},
        {{"lights[0].attenuation=inverse-square"}, {"inverse-square"}},
        {{"lights[0].pattern=lambertian"}, {"lambertian"}},
        {{"surfaces[0].material.normalized=true"}, {"true"}},
        {{"surfaces[0].material.over_pi=true", "lights[0].pattern=lambertian"}, {"true", "lambertian"}},
        {{"surfaces[0].material.model=phong", "lights[0].attenuation=inverse-square"}, {"phong", "inverse-square"}},
        {{"surfaces[0].material.model=lambert", "surfaces[0].material.over_pi=true"}, {"lambert", "true"}},
    };
    luxel_scene *scene = open_report(NULL);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        luxel_scene *changed_scene = open_report(cases[i].change);
        luxel_probe *probe;
        assert_int_equal(luxel_probe_screen(changed_scene, NULL, 0, 0, NULL, &probe), LUXEL_OK);
        expect_choice(scene, probe->value, 0, cases[i].choices[0], cases[i].choices[1]);
        luxel_probe_free(probe);
        luxel_scene_free(changed_scene);
    }
    luxel_scene_free(scene);
}

static void expect_slips(const char *const *assignments)
{
    luxel_scene *scene = open_report(assignments);
    luxel_field *field;
    luxel_probe *probe;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_probe_screen(scene, NULL, 0, 0, NULL, &probe), LUXEL_OK);
    const double maximum = luxel_field_statistics(field)->maximum.value;
    expect_choice(scene, probe->shares[0].irradiance, 0, "irradiance", NULL);
    expect_choice(scene, probe->value / maximum, 0, "share of the maximum", NULL);
    expect_choice(scene, probe->pixel_value / maximum, 0, "pixel", "share of the maximum");
    expect_choice(scene, floor(255 * probe->pixel_value / maximum), 0, "grey level", NULL);
    luxel_probe_free(probe);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* A bright picture, and one that is nowhere as bright as 1. */
static void explains_slips(void **state)
{
    static const char *const dim[] = {"lights[0].intensity=0.1", NULL};
    (void)state;
    expect_slips(NULL);
    expect_slips(dim);
}

/* The nearest of several conventions within a generous tolerance is told. */
static void tells_the_nearest(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    luxel_alternatives *found;
    unsigned told = 0;
    assert_int_equal(luxel_find_alternatives(scene, NULL, 40, 25, NULL, &found), LUXEL_OK);
    for (size_t i = 0; i < found->count; i++) {
        luxel_judgement *judgement;
        if (found->list[i].is_present || !found->list[i].has_value)
            continue;
        assert_int_equal(luxel_judge_answer(scene, NULL, 40, 25, found->list[i].value, 0.05, 0, NULL, &judgement),
                         LUXEL_OK);
        if (judgement->verdict != LUXEL_ANSWER_RIGHT) {
            assert_int_equal(judgement->verdict, LUXEL_ANSWER_CONVENTION);
            assert_true(judgement->explanations[0].value == found->list[i].value);
            told++;
        }
        luxel_judgement_free(judgement);
    }
    assert_true(told >= 4);
    luxel_alternatives_free(found);
    luxel_scene_free(scene);
}

/* A whole number is a grey level only if the picture has it there. */
static void knows_its_grey_levels(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    luxel_field *field;
    luxel_probe *probe;
    static uint8_t levels[360 * 360];
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_probe_screen(scene, NULL, 100, 150, NULL, &probe), LUXEL_OK);
    assert_int_equal(luxel_field_columns(field) * luxel_field_rows(field), sizeof levels);
    luxel_field_grey(field, levels);
    const int level = levels[probe->row * luxel_field_columns(field) + probe->column];
    for (int off = -3; off <= 3; off++) {
        luxel_judgement *judgement = judge(scene, 100, 150, level + off, 0);
        bool is_grey =
            judgement->explanation_count == 1 && strcmp(judgement->explanations[0].choice, "grey level") == 0;
        assert_int_equal(is_grey, off == 0);
        luxel_judgement_free(judgement);
    }
    luxel_probe_free(probe);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Answers from nowhere must not be explained away by one of the many pairs. */
static void explains_little_by_chance(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    unsigned explained = 0, seed = 1;
    for (int i = 0; i < 300; i++) {
        seed = seed * 1664525u + 1013904223u;
        double answer = 0.5 + 5.0 * seed / 4294967296.0;
        luxel_judgement *judgement = judge(scene, 0, 0, answer, 0);
        explained += judgement->verdict == LUXEL_ANSWER_CONVENTION;
        luxel_judgement_free(judgement);
    }
    assert_true(explained <= 15);
    luxel_scene_free(scene);
}

static void refuses_bad_arguments(void **state)
{
    (void)state;
    luxel_scene *scene = open_report(NULL);
    luxel_judgement *judgement = NULL;
    static const double bad[] = {-1e-9, (double)NAN, HUGE_VAL};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(luxel_judge_answer(scene, NULL, 0, 0, 1, bad[i], 0, NULL, &judgement), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_judge_answer(scene, NULL, 0, 0, 1, 1e-3, bad[i], NULL, &judgement),
                         LUXEL_ERROR_ARGUMENT);
    }
    assert_int_equal(luxel_judge_answer(scene, NULL, (double)NAN, 0, 1, 1e-3, 0, NULL, &judgement),
                     LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=1", NULL), LUXEL_OK);
    assert_int_equal(luxel_judge_answer(scene, NULL, 0, 0, 1, 1e-3, 0, NULL, &judgement), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_judge_answer(NULL, NULL, 0, 0, 1, 1e-3, 0, NULL, &judgement), LUXEL_ERROR_ARGUMENT);
    assert_null(judgement);
    luxel_judgement_free(NULL);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(knows_right_answers),   cmocka_unit_test(knows_wrong_answers),
        cmocka_unit_test(explains_the_report),   cmocka_unit_test(explains_conventions),
        cmocka_unit_test(explains_slips),        cmocka_unit_test(tells_the_nearest),
        cmocka_unit_test(knows_its_grey_levels), cmocka_unit_test(explains_little_by_chance),
        cmocka_unit_test(refuses_bad_arguments), cmocka_unit_test(judges_rounding_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
