/* SPDX-License-Identifier: MIT */
/* How much work pictures are thought to be, and for how many threads that is enough. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "api/rendering.h"
#include "base/rows.h"
#include "picture/effort.h"
#include "scenes.h"

#define POINT "{type: point, position: [900, 300, 2400], intensity: 2}"
#define WINDOW "{type: planar, radiance: 3, rectangle: {center: [0, 0, 2900], size: [300, 200]}}"

/* A sphere in so many pixels on each axis under some lights, and a session of its picture. */
struct work {
    luxel_scene *scene;
    struct lx_session session;
    struct luxel_field *frame;
};

static void open_work(unsigned side, const char *model, const char *lights, luxel_settings settings, struct work *work)
{
    char text[8192];
    snprintf(text, sizeof text,
             "luxel: 1\nscreen: {width: 500, height: 500, resolution: [%u, %u]}\nobserver: {z: 3000}\n"
             "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 300, material: {model: %s}}]\nlights: [%s]\n",
             side, side, model, lights);
    assert_int_equal(load(text, NULL, &work->scene), LUXEL_OK);
    assert_int_equal(lx_session_open(work->scene, &settings, NULL, &work->session), LUXEL_OK);
    assert_int_equal(lx_new_frame(&work->session, work->scene, NULL, &work->frame), LUXEL_OK);
}

static void close_work(struct work *work)
{
    luxel_field_free(work->frame);
    lx_session_clear(&work->session);
    luxel_scene_free(work->scene);
}

static double effort_of(unsigned side, const char *model, const char *lights, luxel_settings settings)
{
    struct work work;
    open_work(side, model, lights, settings, &work);
    const double effort = lx_effort_of_pixel_ns(&work.session.plan);
    close_work(&work);
    return effort;
}

static unsigned threads_for(unsigned side, const char *model, const char *lights, unsigned wanted)
{
    struct work work;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = wanted;
    open_work(side, model, lights, settings, &work);
    const unsigned threads = lx_rendering_threads(&work.session, work.frame);
    close_work(&work);
    return threads;
}

/* What is more work is told to be more, and by the narrowest vectors most. */
static void test_effort(void **state)
{
    (void)state;
    luxel_settings plain, exact, narrow;
    luxel_settings_init(&plain);
    exact = narrow = plain;
    exact.precision = LUXEL_DOUBLE;
    narrow.instruction_set = "generic";
    const double one = effort_of(100, "blinn-phong", POINT, plain);
    const double four = effort_of(100, "blinn-phong", POINT ", " POINT ", " POINT ", " POINT, plain);
    assert_true(one > 0 && four > 1.2 * one && four < 4 * one);
    assert_true(effort_of(100, "blinn-phong", POINT, exact) > one);
    assert_true(effort_of(100, "blinn-phong", POINT, narrow) >= one);
    assert_true(effort_of(1200, "blinn-phong", POINT, plain) < one); /* by polynomials */
    assert_true(effort_of(100, "lambert", WINDOW, plain) > effort_of(100, "lambert", "", plain));
    assert_true(effort_of(100, "blinn-phong", WINDOW, plain) > 5 * effort_of(100, "lambert", WINDOW, plain));
}

static void test_threads(void **state)
{
    (void)state;
    const unsigned processors = lx_thread_count(0, 1024), two = processors < 2 ? 1 : 2;
    /* quicker than a second thread would begin */
    assert_int_equal(threads_for(80, "blinn-phong", POINT, 0), 1);
    assert_int_equal(threads_for(80, "blinn-phong", "", 0), 1);
    /* a highlight by integrals is worth some even there, a large picture as well */
    assert_true(threads_for(80, "blinn-phong", WINDOW, 0) >= two);
    assert_int_equal(threads_for(4000, "blinn-phong", POINT, 0), processors < 60 ? processors : 60);
    /* as many as are asked for, but for tiny pictures */
    assert_int_equal(threads_for(100, "blinn-phong", POINT, 2), 2);
    assert_int_equal(threads_for(800, "blinn-phong", POINT, 7), 7);
    assert_int_equal(threads_for(800, "blinn-phong", POINT, 1), 1);
    assert_int_equal(threads_for(10, "blinn-phong", POINT, 7), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_effort),
        cmocka_unit_test(test_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
