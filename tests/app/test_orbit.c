/* SPDX-License-Identifier: MIT */
/* How a scene is looked at in space: where places are seen, and that the camera of the library sees them there. */
#include "../../app/space/orbit.h"

#include <math.h>

#include "scenes.h"

/* An orbit around a built-in scene as it begins, on a widget of 600 x 400. */
static AppOrbit begin(AppMoment *moment, AppSpace **space)
{
    AppOrbit orbit = {.width = 600, .height = 400};
    *space = app_space_new(moment, NULL);
    assert_non_null(*space);
    app_orbit_begin(&orbit, moment->scene, *space);
    return orbit;
}

static AppMoment *moment_of_builtin(const char *name)
{
    AppDocument *document = document_of_builtin(name);
    AppMoment *moment = moment_of(document);
    g_object_unref(document);
    return moment;
}

static void assert_near(double value, double wanted, double within)
{
    if (!(fabs(value - wanted) <= within))
        fail_msg("%.17g is not within %g of %.17g", value, within, wanted);
}

/* All lamps are in view, whatever the scene, and stay so from every side once it is fitted. */
static void test_fits(void **state)
{
    static const char *const names[] = {"report", "room", "pot", "all-sources", "spot"};
    (void)state;
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        AppMoment *moment = moment_of_builtin(names[i]);
        AppSpace *space;
        AppOrbit orbit = begin(moment, &space);
        for (int side = 0; side < 4; side++) {
            for (guint k = 0; k < space->things->len; k++) {
                const AppThing *thing = &g_array_index(space->things, AppThing, k);
                double seen[3];
                if (thing->kind != APP_THING_LAMP)
                    continue;
                assert_true(app_orbit_see(&orbit, thing->at_mm, seen));
                assert_true(seen[0] >= 0 && seen[0] <= 600 && seen[1] >= 0 && seen[1] <= 400);
            }
            app_orbit_turn(&orbit, 90, 20);
            app_orbit_fit(&orbit, moment->scene, space);
        }
        app_space_free(space);
        app_moment_unref(moment);
    }
}

/* The way back from what is seen leads to the place. */
static void test_places(void **state)
{
    static const double place[3] = {120, -340, 510};
    AppSpace *space;
    AppMoment *moment = moment_of_builtin("report");
    AppOrbit orbit = begin(moment, &space);
    double seen[3], found[3];
    (void)state;
    assert_true(app_orbit_see(&orbit, place, seen));
    app_orbit_place(&orbit, seen, found);
    for (int k = 0; k < 3; k++)
        assert_near(found[k], place[k], 1e-9 * 600);
    app_space_free(space);
    app_moment_unref(moment);
}

/* The library's camera sees a place at the point of its screen that the orbit tells, in the height that it tells. */
static void test_camera(void **state)
{
    static const double place[3] = {100, 50, 900};
    AppSpace *space;
    AppMoment *moment = moment_of_builtin("report");
    AppOrbit orbit = begin(moment, &space);
    const camera from = app_orbit_camera(&orbit, 1);
    double seen[3], screen[2], height;
    (void)state;
    assert_int_equal(from.columns, 600);
    assert_int_equal(from.rows, 400);
    luxel_scene *scene = camera_scene(moment->scene, &from, NULL);
    assert_non_null(scene);
    assert_true(app_orbit_see(&orbit, place, seen));
    assert_true(luxel_scene_project(scene, place, screen));
    assert_true(luxel_scene_height(scene, place, &height));
    assert_near(orbit.width / 2 + screen[0] * orbit.scale, seen[0], 1e-6);
    assert_near(orbit.height / 2 - screen[1] * orbit.scale, seen[1], 1e-6);
    assert_near(orbit.distance_mm - height, seen[2], 1e-6);
    luxel_scene_free(scene);
    app_space_free(space);
    app_moment_unref(moment);
}

/* What is under the pointer stays there when it zooms, and goes with it when it moves. */
static void test_zoom(void **state)
{
    static const double at[2] = {420, 90};
    AppSpace *space;
    AppMoment *moment = moment_of_builtin("report");
    AppOrbit orbit = begin(moment, &space);
    const double seen[3] = {at[0], at[1], orbit.distance_mm};
    double place[3], again[3];
    (void)state;
    app_orbit_place(&orbit, seen, place);
    app_orbit_zoom(&orbit, at, 1.7);
    app_orbit_see(&orbit, place, again);
    assert_near(again[0], at[0], 1e-6);
    assert_near(again[1], at[1], 1e-6);
    app_orbit_pan(&orbit, 25, -10);
    app_orbit_see(&orbit, place, again);
    assert_near(again[0], at[0] + 25, 1e-6);
    assert_near(again[1], at[1] - 10, 1e-6);
    app_space_free(space);
    app_moment_unref(moment);
}

/* In a room y is upwards, elsewhere z: from the front that is upwards on the screen. */
static void test_upwards(void **state)
{
    static const struct {
        const char *name;
        int up;
    } scenes[] = {{"room", 1}, {"report", 2}};
    (void)state;
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        AppMoment *moment = moment_of_builtin(scenes[i].name);
        AppSpace *space;
        AppOrbit orbit = begin(moment, &space);
        app_orbit_front(&orbit);
        for (int k = 0; k < 3; k++)
            assert_true(k == scenes[i].up ? orbit.up[k] > 0.9 : fabs(orbit.up[k]) < 0.2);
        assert_near(orbit.right[0], 1, 1e-12);
        app_space_free(space);
        app_moment_unref(moment);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fits), cmocka_unit_test(test_places),  cmocka_unit_test(test_camera),
        cmocka_unit_test(test_zoom), cmocka_unit_test(test_upwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
