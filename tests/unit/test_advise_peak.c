/* SPDX-License-Identifier: MIT */
/* Advice about what a scene shows, and that every change which a hint suggests does mend what it is about. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exercise/scout.h"
#include "scenes.h"

static luxel_scene *open_scene(const char *name, const char *const *assignments)
{
    luxel_scene *scene;
    assert_int_equal(luxel_scene_open_builtin(name, NULL, &scene), LUXEL_OK);
    for (; assignments && *assignments; assignments++)
        assert_int_equal(luxel_scene_set(scene, *assignments, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_diagnostics *advise(const luxel_scene *scene)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
    return diagnostics;
}

/* Makes the assignments of a hint, "try -s 'KEY=VALUE' -s 'KEY=VALUE'". */
static void follow(luxel_scene *scene, const char *hint)
{
    const char *at = hint;
    int count = 0;
    while ((at = strstr(at, "-s '")) != NULL) {
        const char *end = strchr(at + 4, '\'');
        char *assignment = strndup(at + 4, (size_t)(end - at - 4));
        assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
        free(assignment);
        at = end;
        count++;
    }
    assert_true(count > 0);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
}

static bool has(const luxel_diagnostics *diagnostics, const char *id, const char *key)
{
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
        if (strcmp(entry->id, id) == 0 && (!key || (entry->key && strcmp(entry->key, key) == 0)))
            return true;
    }
    return false;
}

struct wanted {
    const char *scene, *changes[4], *id, *key;
};

static const struct wanted wanted[] = {
    {"report", {"surfaces[0].material.specular=0.03"}, "peak-low", "surfaces[0].material.specular"},
    {"report", {"surfaces[0].material.specular=0"}, "peak-low", "surfaces[0].material.specular"},
    {"three-lights", {"surfaces[0].material.specular=0.001"}, "peak-low", "surfaces[0].material.specular"},
    {"window", {"surfaces[0].material.specular=0.001"}, "peak-low", "surfaces[0].material.specular"},
    {"tube", {"surfaces[0].material.specular=0.001"}, "peak-low", "surfaces[0].material.specular"},
    {"report", {"surfaces[0].material.shininess=2"}, "peak-wide", "surfaces[0].material.shininess"},
    {"report", {"surfaces[0].material.model=phong", "surfaces[0].material.shininess=0.5"}, "peak-wide", NULL},
    {"report", {"surfaces[0].material.shininess=200000"}, "peak-narrow", "surfaces[0].material.shininess"},
    {"report", {"lights=[]"}, "picture-dark", "lights"},
    {"report", {"lights[0].enabled=false"}, "picture-dark", "lights"},
    {"report", {"lights[0].intensity=0"}, "picture-dark", "lights"},
    {"distant", {"lights[0].irradiance=0", "lights[1].irradiance=0"}, "picture-dark", "lights"},
    {"window", {"lights[0].radiance=0", "lights[1].irradiance=0"}, "picture-dark", "lights"},
    {"report", {"surfaces[0].material.diffuse=0", "surfaces[0].material.specular=0"}, "picture-dark", "lights"},
    {"report", {"lights[0].position=[0,0,1000]", "surfaces[0].material.highlight=gated"}, "picture-dark", "lights"},
    {"report", {"screen={width: 300, height: 300, resolution: [300, 300]}"}, "peak-at-border", "screen"},
    {"report", {"screen={width: 303, height: 307, resolution: [303, 307]}"}, "peak-at-border", "screen"},
    {"distant", {"lights=[{type: distant, direction: [-1, 0, 1], irradiance: 10}]"}, "peak-at-rim", "surfaces[0]"},
    {"distant", {"lights=[{type: point, position: [2000, 0, 200], intensity: 10}]"}, "peak-at-rim", "surfaces[0]"},
    {"report", {"picture.range=[0,5]"}, "range-clips", "picture.range"},
    {"report", {"picture.range=[0,1000]"}, "range-dim", "picture.range"},
    {"report", {"picture.range=[100,1000]"}, "range-dim", "picture.range"},
    {"report",
     {"lights[0].position=[0,0,1305]", "lights[0].attenuation=inverse-square"},
     "light-near",
     "lights[0].position"},
    {"report",
     {"lights[0].position=[2e5,0,2e5]", "lights[0].attenuation=inverse-square"},
     "light-far",
     "lights[0].position"},
    {"report", {"lights[0].attenuation=practical", "lights[0].k=2e6"}, "light-far", "lights[0].position"},
    {"desk", {"lights[0].position=[0, -150, 901]"}, "light-near", "lights[0].position"},
    /* and what luxel_scene_advise() says */
    {"report", {NULL}, "not-in-view", "surfaces[0]"},
    {"spot", {"surfaces[0].center=[900, 0, 600]"}, "not-in-view", "surfaces[0]"},
    {"two-spheres", {"surfaces[1].center=[2000, 0, 1330]"}, "not-in-view", "surfaces[1]"},
    {"report", {"lights[0].position=[10, 0, 300]"}, "light-behind", "lights[0].position"},
    {"report", {"lights[0].position=[0, 0, 1000]"}, "light-behind", "lights[0].position"},
    {"report", {"lights[0].intensity=1e6"}, "not-advised", "lights[0].intensity"},
    {"report", {"lights[0].position=[2000, 2e5, 2000]"}, "not-advised", "lights[0].position[1]"},
    {"report", {"screen={width: 50, height: 25, resolution: [400, 200]}"}, "not-advised", "screen.width"},
    {"report", {"screen={width: 20000, height: 10000, resolution: [400, 200]}"}, "not-advised", "screen.width"},
    {"report", {"screen.resolution=[1000, 1000]"}, "not-advised", "screen.resolution[0]"},
    {"report", {"screen={width: 300, height: 200, resolution: [150, 100]}"}, "not-advised", "screen.resolution[1]"},
    {"report", {"observer.z=20000"}, "not-advised", "observer.z"},
};

/* Each is given, with a hint, and gone after the hint was followed. */
static void mends_what_it_advises(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        const struct wanted *w = &wanted[i];
        luxel_scene *scene = open_scene(w->scene, w->changes);
        luxel_diagnostics *diagnostics = advise(scene);
        if (!has(diagnostics, w->id, w->key))
            fail_msg("case %zu (%s, %s): no %s", i, w->scene, w->changes[0] ? w->changes[0] : "", w->id);
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, k);
            char *hint = luxel_diagnostics_hint(diagnostics, k, NULL, NULL);
            assert_int_equal(entry->severity, LUXEL_SEVERITY_ADVICE);
            if (strcmp(entry->id, w->id) == 0 && !strstr(hint, "-s '"))
                fail_msg("case %zu (%s): no hint: %s", i, w->id, hint);
            if (strstr(hint, "-s '")) {
                luxel_scene *mended = luxel_scene_copy(scene);
                follow(mended, hint);
                luxel_diagnostics *after = advise(mended);
                if (has(after, entry->id, entry->key))
                    fail_msg("case %zu (%s): %s is still there after: %s", i, w->scene, entry->id, hint);
                luxel_diagnostics_free(after);
                luxel_scene_free(mended);
            }
            luxel_text_free(hint);
        }
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* The built-in scenes are as they are on purpose: only the report's sphere is larger than its screen, and some shine
 * more than they may. */
static void is_silent_where_all_is_well(void **state)
{
    (void)state;
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++) {
        luxel_scene *scene = open_scene(luxel_builtin_scene_name(i), NULL);
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++)
            if (strcmp(luxel_diagnostics_get(diagnostics, k)->id, "albedo-above-one") != 0)
                fail_msg("%s: %s", luxel_builtin_scene_name(i), luxel_diagnostics_get(diagnostics, k)->id);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* What is said is the truth: the rise of the maximum, by two pictures. */
static void tells_true_numbers(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene("report", (const char *const[]){"screen.width=620", "screen.height=620",
                                                                    "surfaces[0].material.specular=0.15", NULL});
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_field *with, *without;
    char shown[80];
    assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &with), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].material.specular=0", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &without), LUXEL_OK);
    double rise = luxel_field_statistics(with)->maximum.value / luxel_field_statistics(without)->maximum.value - 1;
    assert_true(rise > 0.01 && rise < 0.1);
    snprintf(shown, sizeof shown, "only %.1f %%", (int)(1000 * rise) / 10.0);
    expect_entry(diagnostics, 0, WANTED("peak-low", .message = shown));
    luxel_field_free(with);
    luxel_field_free(without);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

/* How far the highlight raises the maximum of the report's scene, told like this. */
static double rise_at(const luxel_scene *scene, double specular)
{
    char with[80];
    struct lx_scout bright, dull;
    double effort = LX_SCOUT_EFFORT;
    snprintf(with, sizeof with, "surfaces[0].material.specular=%.17g", specular);
    assert_int_equal(lx_scout(scene, (const char *const[]){with, NULL}, &effort, &bright), LUXEL_OK);
    assert_int_equal(lx_scout(scene, (const char *const[]){"surfaces[0].material.specular=0", NULL}, &effort, &dull),
                     LUXEL_OK);
    return bright.maximum / dull.maximum - 1;
}

static double specular_that_raises(const luxel_scene *scene, double rise)
{
    double low = 0, high = 1;
    for (int i = 0; i < 30; i++) {
        double middle = (low + high) / 2;
        if (rise_at(scene, middle) < rise)
            low = middle;
        else
            high = middle;
    }
    return high;
}

static double maximum_of(const luxel_scene *scene)
{
    struct lx_scout scout;
    double effort = LX_SCOUT_EFFORT;
    assert_int_equal(lx_scout(scene, NULL, &effort, &scout), LUXEL_OK);
    return scout.maximum;
}

/* Where `value` stands for the %g of a change. */
static bool is_told(const char *const *before, const char *change, double value, const char *id)
{
    char words[120];
    luxel_scene *scene = open_scene("report", before);
    snprintf(words, sizeof words, change, value);
    assert_int_equal(luxel_scene_set(scene, words, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_diagnostics *diagnostics = advise(scene);
    bool told = has(diagnostics, id, NULL);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
    return told;
}

/* Advice is given beyond its limit and not before it, the limits being computed from what the advice is about. */
static void speaks_from_its_limit_on(void **state)
{
    (void)state;
    static const char *const none[] = {NULL}, *const phong[] = {"surfaces[0].material.model=phong", NULL};
    static const char *const near[] = {"lights[0].attenuation=inverse-square", NULL};
    static const char *const practical[] = {"lights[0].attenuation=practical", "lights[0].k=1",
                                            "lights[0].position=[0,0,3000]", NULL};
    luxel_scene *scene = open_scene("report", NULL);
    const double radius = 300,
                 pixel = 500.0 / 360; /* mm; the light looks along (1, 0, 1) at the centre, (0, 0, 1000) */
    const double turn = 35 * M_PI / 180, maximum = maximum_of(scene), specular = specular_that_raises(scene, 0.1);
    const double ratio = sqrt(1.01), far = radius * (ratio + 1) / (ratio - 1);
    const struct {
        const char *const *before, *change, *id;
        double silent, told;
    } cases[] = {
        {none, "picture.range=[0, %.17g]", "range-dim", 255 * maximum / 32.1, 255 * maximum / 31.9},
        {none, "surfaces[0].material.specular=%.17g", "peak-low", 1.001 * specular, 0.999 * specular},
        {none, "surfaces[0].material.shininess=%.17g", "peak-wide", -1.01 / log2(cos(turn)), -0.99 / log2(cos(turn))},
        {phong, "surfaces[0].material.shininess=%.17g", "peak-wide", -1.01 / log2(cos(2 * turn)),
         -0.99 / log2(cos(2 * turn))},
        {none, "surfaces[0].material.shininess=%.17g", "peak-narrow", -0.99 / log2(cos(asin(pixel / radius))),
         -1.01 / log2(cos(asin(pixel / radius)))},
        {near, "lights[0].position=[0, 0, %.17g]", "light-near", 1000 + 1.0501 * radius, 1000 + 1.0499 * radius},
        {near, "lights[0].position=[0, 0, %.17g]", "light-far", 1000 + 0.999 * far, 1000 + 1.001 * far},
        /* (k + 2300)/(k + 1700) is 1.01 for k = 58 300 */
        {practical, "lights[0].k=%.17g", "light-far", 58290, 58310},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (is_told(cases[i].before, cases[i].change, cases[i].silent, cases[i].id))
            fail_msg("%s is told for %s with %g", cases[i].id, cases[i].change, cases[i].silent);
        if (!is_told(cases[i].before, cases[i].change, cases[i].told, cases[i].id))
            fail_msg("%s is not told for %s with %g", cases[i].id, cases[i].change, cases[i].told);
    }
    luxel_scene_free(scene);
}

/* Switched on, the source of 51 x 25 faces of a million parts each would take all memory. */
static void leaves_out_what_costs_too_much(void **state)
{
    (void)state;
    static const char *const dark[] = {"lights=[{type: volume, sphere: {center: [0, 0, 2000], radius: 10, facets: 51}, "
                                       "power: 1, parts: 1000, enabled: false}]",
                                       NULL};
    static const char *const enabled[] = {"lights[0].enabled=true", NULL};
    luxel_scene *scene = open_scene("report", dark);
    luxel_diagnostics *diagnostics = advise(scene);
    struct lx_scout scout;
    double effort = LX_SCOUT_EFFORT;
    assert_true(has(diagnostics, "picture-dark", "lights"));
    assert_int_equal(lx_scout(scene, enabled, &effort, &scout), LUXEL_OK);
    assert_true(scout.too_large && effort == LX_SCOUT_EFFORT);
    assert_int_equal(lx_scout(scene, NULL, &effort, &scout), LUXEL_OK);
    assert_true(!scout.too_large && effort < LX_SCOUT_EFFORT);
    effort = 1; /* hardly any is left */
    assert_int_equal(lx_scout(scene, NULL, &effort, &scout), LUXEL_OK);
    assert_true(scout.too_large && effort == 1);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

static void wants_a_committed_scene(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene("report", NULL);
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=1", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_advise_peak(scene, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_advise_peak(NULL, NULL), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mends_what_it_advises),
        cmocka_unit_test(is_silent_where_all_is_well),
        cmocka_unit_test(tells_true_numbers),
        cmocka_unit_test(speaks_from_its_limit_on),
        cmocka_unit_test(leaves_out_what_costs_too_much),
        cmocka_unit_test(wants_a_committed_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
