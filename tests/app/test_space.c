/* SPDX-License-Identifier: MIT */
/* Plan and elevation: where things are, and that a projection moves what it shows and nothing else. */
#include "../../app/space/space.h"

#include <math.h>
#include <string.h>

#include "../../app/space/outlines.h"
#include "scenes.h"

static AppOutlines *outlines; /* of the group of tests */

static int begin(void **state)
{
    (void)state;
    outlines = app_outlines_new();
    return 0;
}

static int end(void **state)
{
    (void)state;
    g_clear_pointer(&outlines, app_outlines_free);
    return 0;
}

/* A thing of a document's scene; fails where there is none. */
static AppThing thing_of(const AppDocument *document, AppThingKind kind, gsize index)
{
    AppMoment *moment = moment_of(document);
    AppSpace *space = app_space_new(moment, outlines);
    AppThing found = {.kind = APP_THING_NONE};
    for (guint i = 0; i < space->things->len; i++) {
        const AppThing *thing = &g_array_index(space->things, AppThing, i);
        if (thing->kind == kind && thing->index == index)
            found = *thing;
    }
    app_space_free(space);
    app_moment_unref(moment);
    assert_int_equal(found.kind, kind);
    return found;
}

static void assert_place(const double place[3], double x, double y, double z)
{
    const double wanted[3] = {x, y, z};
    for (int k = 0; k < 3; k++)
        assert_true(fabs(place[k] - wanted[k]) < 1e-6 * MAX(1, fabs(wanted[k])));
}

/* Each projection moves two coordinates, to round numbers; the third stays as it is written. */
static void test_lamps(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppThing lamp = thing_of(document, APP_THING_LAMP, 0);
    assert_place(lamp.at_mm, 2000, 0, 2000);
    assert_string_equal(lamp.key, "lights[0].position");
    assert_true(app_space_move(&lamp, APP_PLAN, (double[3]){1234.4, 567.6, 9}, 1, document));
    assert_key(document, "lights[0].position", "[1234, 568, 2000]");
    assert_true(app_space_move(&lamp, APP_ELEVATION, (double[3]){1000.04, -5, 1800.26}, 0.1, document));
    assert_key(document, "lights[0].position", "[1000, 568, 1800.3]");
    g_object_unref(document);
}

/* An observer above the screen has a height alone, which the plan does not show; it never sinks below the screen. */
static void test_observer(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppThing eye = thing_of(document, APP_THING_OBSERVER, 0);
    assert_place(eye.at_mm, 0, 0, 1500);
    assert_false(app_space_moves(&eye, APP_PLAN));
    assert_false(app_space_move(&eye, APP_PLAN, (double[3]){5, 5, 5}, 1, document));
    assert_true(app_space_move(&eye, APP_ELEVATION, (double[3]){77, 0, 1600}, 1, document));
    assert_key(document, "observer.z", "1600");
    assert_true(app_space_move(&eye, APP_ELEVATION, (double[3]){0, 0, -300}, 1, document));
    assert_key(document, "observer.z", "1");
    g_object_unref(document);
}

/* Distant light comes from where it is dragged to; its handle and its vector are one line through the surface. */
static void test_distant(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("distant");
    AppThing sun = thing_of(document, APP_THING_DIRECTION, 0);
    const double to[3] = {sun.from_mm[0] + 300, sun.from_mm[1], sun.from_mm[2] + 400};
    assert_true(app_space_move(&sun, APP_ELEVATION, to, 1, document));
    assert_key(document, "lights[0].direction", "[-0.6, 0, -0.8]");
    sun = thing_of(document, APP_THING_DIRECTION, 0);
    const double rise = sun.at_mm[2] - sun.from_mm[2], aside = sun.at_mm[0] - sun.from_mm[0];
    assert_true(rise > 0 && fabs(aside / rise - 0.75) < 1e-6);
    assert_false(app_space_move(&sun, APP_ELEVATION, sun.from_mm, 1, document)); /* no direction at all */
    g_object_unref(document);
}

/* A polygon is moved with all its corners, however often. */
static void test_polygon(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    set(document, "lights", "[{type: planar, vertices: [[0, 0, 2000], [0, 200, 2000], [200, 0, 2000]], radiance: 5}]");
    AppThing panel = thing_of(document, APP_THING_LAMP, 0);
    assert_place(panel.at_mm, 200.0 / 3, 200.0 / 3, 2000);
    for (int i = 0; i < 3; i++) {
        const double to[3] = {panel.at_mm[0] + 10, 0, panel.at_mm[2] - 20};
        assert_true(app_space_move(&panel, APP_ELEVATION, to, 1, document));
    }
    assert_key(document, "lights[0].vertices", "[[30, 0, 1940], [30, 200, 1940], [230, 0, 1940]]");
    g_object_unref(document);
}

/* A place of an array is taken as the array is: all of it is moved by as much. */
static void test_array(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    set(document, "lights",
        "[{type: point, position: [100, 0, 2000], intensity: 5, array: {n: [3, 2], spacing: [200, 300]}}]");
    AppMoment *moment = moment_of(document);
    AppSpace *space = app_space_new(moment, outlines);
    AppThing lamp = g_array_index(space->things, AppThing, 0), last = g_array_index(space->things, AppThing, 6);
    assert_true(lamp.kind == APP_THING_LAMP && lamp.place == 0 && lamp.places == 6);
    assert_true(last.kind == APP_THING_LAMP && last.place == 6 && last.index == 0);
    assert_place(lamp.at_mm, 100, 0, 2000);
    assert_place(last.at_mm, 300, 150, 2000);
    /* nothing shines in the middle of an array of two rows */
    const double below[3] = {100, 0, 0}, up[3] = {0, 0, 1};
    double light[3];
    assert_false(app_space_light(&lamp, below, up, light));
    assert_true(app_space_light(&last, below, up, light) && light[0] > 0 && light[1] > 0);
    assert_true(app_space_move(&last, APP_PLAN, (double[3]){350, 170, 9}, 1, document));
    assert_key(document, "lights[0].position", "[150, 20, 2000]");
    assert_place(last.at_mm, 350, 170, 2000);
    app_space_free(space);
    app_moment_unref(moment);
    g_object_unref(document);
}

/* All of a scene is in view: each thing and each place of each line. */
static void test_everything_is_in_view(void **state)
{
    (void)state;
    for (gsize scene = 0; luxel_builtin_scene_name(scene); scene++) {
        AppDocument *document = document_of_builtin(luxel_builtin_scene_name(scene));
        AppMoment *moment = moment_of(document);
        AppSpace *space = app_space_new(moment, outlines);
        assert_true(space->things->len > 1 && space->lines->len > 1);
        for (guint i = 0; i < space->things->len; i++)
            for (int k = 0; k < 3; k++) {
                const double at = g_array_index(space->things, AppThing, i).at_mm[k];
                assert_true(at >= space->low[k] && at <= space->high[k]);
            }
        for (guint i = 0; i < space->places->len; i++)
            for (int k = 0; k < 3; k++) {
                const double at = ((const double(*)[3])(const void *)space->places->data)[i][k];
                assert_true(at >= space->low[k] && at <= space->high[k]);
            }
        app_space_free(space);
        app_moment_unref(moment);
        g_object_unref(document);
    }
}

/* The outline of a sphere is a circle of its radius in both projections; a plate seen on edge is a line. */
static void test_outlines(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppMoment *moment = moment_of(document);
    AppSpace *space = app_space_new(moment, outlines);
    guint seen = 0;
    for (guint i = 0; i < space->lines->len; i++) {
        const AppLine *line = &g_array_index(space->lines, AppLine, i);
        if (line->kind != APP_LINE_SURFACE)
            continue;
        seen |= line->projections;
        const int up = line->projections == 1u << APP_PLAN ? 1 : 2;
        const double(*places)[3] = (const double(*)[3])(const void *)space->places->data;
        for (gsize k = 0; k < line->count; k++)
            assert_true(fabs(hypot(places[line->first + k][0], places[line->first + k][up] - (up == 2 ? 1000 : 0)) -
                             300) < 1e-9);
    }
    assert_int_equal(seen, 3);
    app_space_free(space);
    app_moment_unref(moment);
    g_object_unref(document);
}

/* V is the screen's axis, or the way to the observer, as the scene says. */
static void test_view(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    for (int i = 0; i < 2; i++) {
        double view[3];
        AppMoment *moment = moment_of(document);
        AppSpace *space = app_space_new(moment, outlines);
        app_space_view(space, (double[3]){300, 0, 1100}, view);
        assert_place(view, i ? -0.6 : 0, 0, i ? 0.8 : 1);
        app_space_free(space);
        app_moment_unref(moment);
        set(document, "observer.view", "observer");
    }
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lamps),   cmocka_unit_test(test_observer), cmocka_unit_test(test_distant),
        cmocka_unit_test(test_polygon), cmocka_unit_test(test_outlines), cmocka_unit_test(test_array),
        cmocka_unit_test(test_everything_is_in_view),
        cmocka_unit_test(test_view),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
