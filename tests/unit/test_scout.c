/* SPDX-License-Identifier: MIT */
/* The quick look before advice: what it tells of the peak, against whole pictures and the search between pixels. */
#include <math.h>
#include <stdio.h>

#include <luxel/evaluator.h>

#include "exercise/scout.h"
#include "scenes.h"

enum { MOST_LIGHTS = 8 };

struct truth {
    luxel_scene *scene;
    luxel_field *field;
    luxel_evaluator *evaluator;
    luxel_extrema extrema;
};

static void find_truth(const char *name, const char *const *changes, size_t count, bool exact, struct truth *truth)
{
    truth->scene = opened_with(name, changes, count);
    assert_int_equal(luxel_render(truth->scene, NULL, NULL, &truth->field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(truth->scene, NULL, NULL, &truth->evaluator), LUXEL_OK);
    if (exact)
        assert_int_equal(luxel_find_extrema(truth->evaluator, truth->field, NULL, NULL, &truth->extrema), LUXEL_OK);
}

static void clear(struct truth *truth)
{
    luxel_evaluator_free(truth->evaluator);
    luxel_field_free(truth->field);
    luxel_scene_free(truth->scene);
}

static struct lx_scout scouted(const luxel_scene *scene, const char *const *assignments)
{
    struct lx_scout scout;
    double effort = LX_SCOUT_EFFORT;
    assert_int_equal(lx_scout(scene, assignments, &effort, &scout), LUXEL_OK);
    assert_true(!scout.too_large && effort < LX_SCOUT_EFFORT && effort >= 0 && scout.sample_mm > 0);
    return scout;
}

/* Where points and distant lights shine the peak is that of the search. */
static void exact_peaks(void **state)
{
    static const char *const names[] = {"report", "three-lights", "two-spheres", "desk", "1", "3"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct truth truth;
        double shares[MOST_LIGHTS];
        find_truth(names[i], NULL, 0, true, &truth);
        const luxel_peak *peak = &truth.extrema.maximum;
        struct lx_scout scout = scouted(truth.scene, NULL);
        assert_true(scout.is_seen && !scout.is_coarse);
        assert_true(fabs(scout.maximum - peak->value) <= 1e-6 * peak->value);
        assert_int_equal(scout.surface, peak->surface);
        assert_int_equal(scout.place, peak->place);
        assert_true(luxel_evaluator_light_count(truth.evaluator) <= MOST_LIGHTS);
        luxel_value value;
        luxel_evaluate_screen(truth.evaluator, peak->x_mm, peak->y_mm, &value, shares);
        for (size_t k = 0; k < luxel_evaluator_light_count(truth.evaluator); k++)
            assert_true(shares[k] <= shares[scout.strongest]);
        clear(&truth);
    }
}

/* Where sources are extended it is climbed to from a pixel of a coarse picture: near it, and never above. */
static void coarse_peaks(void **state)
{
    static const char *const names[] = {"window", "tube", "disk-lamp", "ball-lamp", "box-lamp"};
    static const char *const changes[] = {"surfaces[0].material.shininess=200", "screen.resolution=[500,500]"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct truth truth;
        find_truth(names[i], changes, 2, false, &truth);
        const double maximum = luxel_field_statistics(truth.field)->maximum.value;
        struct lx_scout scout = scouted(truth.scene, NULL);
        assert_true(scout.is_seen && scout.is_coarse);
        if (!(fabs(scout.maximum - maximum) <= 1e-3 * maximum))
            fail_msg("%s: %.9g, expected %.9g", names[i], scout.maximum, maximum);
        assert_int_equal(scout.place, LUXEL_PEAK_INSIDE);
        clear(&truth);
    }
}

/* The share of what is seen that is brighter than a range reaches; none where it reaches to the maximum. */
static void what_a_range_cuts_off(void **state)
{
    static const char *const ranges[] = {"picture.range=[0, 2]", "picture.range=[1, 6]", "picture.range=[0, 20]"};
    static const double highs[] = {2, 6, 20};
    struct truth truth;
    (void)state;
    find_truth("report", NULL, 0, false, &truth);
    assert_true(scouted(truth.scene, NULL).white == 0);
    for (size_t i = 0; i < 3; i++) {
        const char *const assignments[] = {ranges[i], NULL};
        size_t above = 0, seen = luxel_field_statistics(truth.field)->surface_pixels;
        for (unsigned row = 0; row < luxel_field_rows(truth.field); row++)
            for (unsigned column = 0; column < luxel_field_columns(truth.field); column++)
                above += luxel_field_value(truth.field, column, row) > highs[i];
        const double share = (double)above / (double)seen, found = scouted(truth.scene, assignments).white;
        if (!(fabs(found - share) <= 0.01))
            fail_msg("%s: %g, expected %g", ranges[i], found, share);
    }
    clear(&truth);
}

static void what_it_costs(void **state)
{
    struct truth truth;
    struct lx_scout scout;
    double effort = 0, first = LX_SCOUT_EFFORT;
    const char *const off[] = {"lights[0].enabled=false", NULL}, *const wrong[] = {"lights[0].intensity=-1", NULL};
    (void)state;
    find_truth("report", NULL, 0, false, &truth);
    assert_int_equal(lx_scout(truth.scene, NULL, &effort, &scout), LUXEL_OK);
    assert_true(scout.too_large && !scout.is_seen && effort == 0);
    assert_int_equal(lx_scout(truth.scene, NULL, &first, &scout), LUXEL_OK);
    const double cost = LX_SCOUT_EFFORT - first;
    effort = cost * 1.0001;
    assert_int_equal(lx_scout(truth.scene, NULL, &effort, &scout), LUXEL_OK);
    assert_true(!scout.too_large && effort >= 0 && effort < cost * 0.001);
    assert_int_equal(lx_scout(truth.scene, NULL, &effort, &scout), LUXEL_OK);
    assert_true(scout.too_large);
    effort = LX_SCOUT_EFFORT;
    assert_int_equal(lx_scout(truth.scene, off, &effort, &scout), LUXEL_OK);
    assert_true(scout.is_seen && scout.maximum == 0);
    assert_int_equal(lx_scout(truth.scene, wrong, &effort, &scout), LUXEL_ERROR_SCENE);
    clear(&truth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_peaks),
        cmocka_unit_test(coarse_peaks),
        cmocka_unit_test(what_a_range_cuts_off),
        cmocka_unit_test(what_it_costs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
