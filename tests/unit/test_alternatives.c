/* SPDX-License-Identifier: MIT */
/*
 * Alternatives: each value is what the scene gives once its assignment is made, the present choice is the scene's own
 * number, the report's two numbers for its first point are told apart, and the scene stays as it is.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scenes.h"

static double probe_value(const luxel_scene *scene, double x, double y, bool *has_value)
{
    luxel_probe *probe = NULL;
    assert_int_equal(luxel_probe_screen(scene, NULL, x, y, NULL, &probe), LUXEL_OK);
    double value = probe->value;
    *has_value = probe->has_value;
    luxel_probe_free(probe);
    return value;
}

/* The assignments are joined by " -s ", as the command line takes them; false where the scene does not allow them. */
static bool assign(luxel_scene *scene, const char *joined)
{
    char *text = strdup(joined), *next = text;
    while (next) {
        char *end = strstr(next, " -s ");
        if (end)
            *end = '\0';
        assert_int_equal(luxel_scene_set(scene, next, NULL), LUXEL_OK);
        next = end ? end + 4 : NULL;
    }
    free(text);
    const luxel_status status = luxel_scene_commit(scene, NULL);
    assert_true(status == LUXEL_OK || status == LUXEL_ERROR_SCENE);
    return status == LUXEL_OK && luxel_scene_check_view(scene, NULL) == LUXEL_OK;
}

static void test_builtins(void **state)
{
    (void)state;
    static const double places[][2] = {{0, 0}, {-60, 35}, {150, -120}, {320, 320}};
    unsigned refused = 0; /* such as an orthographic observer among what it looks at */
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++) {
        const char *name = luxel_builtin_scene_name(i);
        const double *place = places[i % 4];
        luxel_scene *scene = builtin(name);
        luxel_alternatives *found = NULL;
        bool has_value;
        double own = probe_value(scene, place[0], place[1], &has_value);
        assert_int_equal(luxel_find_alternatives(scene, NULL, place[0], place[1], NULL, &found), LUXEL_OK);
        assert_true(found->count > 4);
        for (size_t k = 0; k < found->count; k++) {
            const luxel_alternative *each = &found->list[k];
            bool first = k == 0 || strcmp(each->convention, found->list[k - 1].convention) != 0;
            assert_true(first || !each->is_present); /* the surfaces or lights may differ in it: then none is */
            assert_true(each->is_present || k > 0);
            assert_true(*each->choice && *each->meaning);
            if (each->is_present) {
                assert_int_equal(each->has_value, has_value);
                assert_true(!has_value || each->value == own);
            } else if (each->assignment) {
                bool other_has = false;
                luxel_scene *other = builtin(name);
                const bool is_legal = assign(other, each->assignment);
                refused += !is_legal;
                double value = is_legal ? probe_value(other, place[0], place[1], &other_has) : 0;
                other_has = is_legal && other_has;
                assert_int_equal(each->has_value, other_has);
                assert_true(!other_has || fabs(each->value - value) <= 1e-12 * fabs(value));
                luxel_scene_free(other);
            }
        }
        luxel_alternatives_free(found);
        luxel_scene_free(scene);
    }
    assert_true(refused > 0);
}

static const luxel_alternative *find(const luxel_alternatives *found, const char *convention, const char *choice)
{
    for (size_t i = 0; i < found->count; i++)
        if (strcmp(found->list[i].convention, convention) == 0 && strcmp(found->list[i].choice, choice) == 0)
            return &found->list[i];
    fail_msg("no %s: %s", convention, choice);
    return NULL;
}

/* The published table has 2.7488 at the centre: the nearest pixel.  At the point itself it is 2.72759. */
static void test_report(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_alternatives *found = NULL;
    assert_int_equal(luxel_find_alternatives(scene, NULL, 0, 0, NULL, &found), LUXEL_OK);
    const luxel_alternative *point = &found->list[0];
    assert_string_equal(point->convention, "place");
    assert_true(fabs(point->value - 2.72759) < 5e-6);
    assert_true(fabs(find(found, "place", "pixel")->value - 2.7488) < 5e-5);
    assert_null(find(found, "place", "pixel")->assignment);
    assert_true(fabs(find(found, "division by π", "true")->value - point->value / M_PI) < 1e-12);
    luxel_alternatives_free(found);
    luxel_scene_free(scene);
}

/* The sample nearest to a place, among the columns or rows of a picture. */
static double nearest(const double *samples, unsigned count, double place)
{
    double found = samples[0];
    for (unsigned i = 1; i < count; i++)
        if (fabs(samples[i] - place) < fabs(found - place))
            found = samples[i];
    return found;
}

/* A scene that shines unevenly on a coarse screen: every other place has another value. */
static luxel_scene *uneven(const char *sampling)
{
    luxel_scene *scene = builtin("report");
    assign(scene, "screen={width: 500, height: 400, resolution: [25, 20]} -s lights[0].position=[1500, 900, 2000]");
    assign(scene, sampling);
    return scene;
}

/* Each place where someone may have looked has the value that a probe has there; off the screen there is no pixel. */
static void test_places(void **state)
{
    (void)state;
    static const char *const samplings[] = {"screen.sampling=nodes", "screen.sampling=centers"};
    static const double x = 37.3, y = 81.9;
    bool has_value;
    for (int i = 0; i < 2; i++) {
        luxel_scene *scene = uneven(samplings[i]), *other = uneven(samplings[1 - i]);
        luxel_field *field = NULL, *other_field = NULL;
        luxel_alternatives *found = NULL;
        assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
        assert_int_equal(luxel_render(other, NULL, NULL, &other_field), LUXEL_OK);
        assert_int_equal(luxel_find_alternatives(scene, NULL, x, y, NULL, &found), LUXEL_OK);
        double px = nearest(luxel_field_x_mm(field), 25, x), py = nearest(luxel_field_y_mm(field), 20, y);
        double ox = nearest(luxel_field_x_mm(other_field), 25, x), oy = nearest(luxel_field_y_mm(other_field), 20, y);
        assert_true(find(found, "place", "exact point")->value == probe_value(scene, x, y, &has_value));
        assert_true(find(found, "place", "pixel")->value == probe_value(scene, px, py, &has_value));
        assert_true(find(found, "place", "pixel of the other sampling")->value ==
                    probe_value(scene, ox, oy, &has_value));
        double turned = probe_value(scene, px, -py, &has_value);
        assert_true(fabs(find(found, "place", "pixel, flipped vertically")->value - turned) <= 1e-12 * turned);
        luxel_alternatives_free(found);
        assert_int_equal(luxel_find_alternatives(scene, NULL, 251, y, NULL, &found), LUXEL_OK);
        assert_true(find(found, "place", "exact point")->has_value && !find(found, "place", "pixel")->has_value);
        luxel_alternatives_free(found);
        luxel_field_free(field);
        luxel_field_free(other_field);
        luxel_scene_free(scene);
        luxel_scene_free(other);
    }
}

/*
 * A law is compared where the scene has what it needs: k or coefficients, whichever law they stand beside.  From the
 * lamp the surface at the centre of the report's sphere is r away; none gives the value without the factor a(r).
 */
static void test_laws(void **state)
{
    (void)state;
    static const char *const laws[] = {"none", "inverse-square", "practical", "polynomial"};
    const double r = sqrt(2.0 * 2.0 + 0.7 * 0.7);
    const double factors[] = {1, 1 / (r * r), 1 / (0.3 + r), 1 / (0.5 + 0.25 * r + 2 * r * r)};
    for (size_t present = 0; present < 4; present++) {
        luxel_scene *scene = builtin("report");
        luxel_alternatives *found = NULL;
        char law[64];
        assign(scene, "lights[0].k=300 -s lights[0].coefficients=[0.5, 0.25, 2]");
        snprintf(law, sizeof law, "lights[0].attenuation=%s", laws[present]);
        assign(scene, law);
        assert_int_equal(luxel_find_alternatives(scene, NULL, 0, 0, NULL, &found), LUXEL_OK);
        const double whole = find(found, "attenuation", "none")->value;
        for (size_t i = 0; i < 4; i++) {
            const luxel_alternative *each = find(found, "attenuation", laws[i]);
            assert_int_equal(each->is_present, i == present);
            assert_true(fabs(each->value - whole * factors[i]) <= 1e-12 * whole);
        }
        luxel_alternatives_free(found);
        luxel_scene_free(scene);
    }
}

/* What is switched off has no say: neither is it asked for its law nor changed. */
static void test_off(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("three-lights");
    luxel_alternatives *found = NULL;
    assign(scene, "lights[1].enabled=false");
    assert_int_equal(luxel_find_alternatives(scene, NULL, 0, 0, NULL, &found), LUXEL_OK);
    for (size_t i = 0; i < found->count; i++)
        if (found->list[i].assignment && strstr(found->list[i].assignment, "lights["))
            assert_null(strstr(found->list[i].assignment, "lights[1]"));
    luxel_alternatives_free(found);
    luxel_scene_free(scene);
}

static void test_refused(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_alternatives *found = NULL;
    assert_int_equal(luxel_find_alternatives(scene, NULL, (double)NAN, 0, NULL, &found), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_set(scene, "points=[]", NULL), LUXEL_OK); /* not committed */
    assert_int_equal(luxel_find_alternatives(scene, NULL, 0, 0, NULL, &found), LUXEL_ERROR_ARGUMENT);
    assert_null(found);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_builtins), cmocka_unit_test(test_report), cmocka_unit_test(test_places),
        cmocka_unit_test(test_laws),     cmocka_unit_test(test_off),    cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
