/* SPDX-License-Identifier: MIT */
/* Pictures of bodies in space have the light of the library's own camera, and the distances of what they show. */
#include "../../app/space/lit.h"

#include <math.h>
#include <string.h>

#include "scenes.h"

typedef struct Kept {
    AppLit *lit;
    guint columns; /* that are waited for */
} Kept;

static void keep(AppLit *lit, gpointer owner)
{
    Kept *kept = owner;
    app_lit_unref(kept->lit);
    kept->lit = app_lit_ref(lit);
}

static gboolean is_finest(gpointer data)
{
    const Kept *kept = data;
    return kept->lit && kept->lit->columns == kept->columns;
}

static gboolean has_come(gpointer data)
{
    return ((const Kept *)data)->lit != NULL;
}

/* The first surface from near. */
static AppLitWish wish_of(AppMoment *moment, const AppSpace *space)
{
    static const double middle[2] = {60, 45};
    AppLitWish wish = {.moment = moment, .dots = 1, .high = 10, .orbit = {.width = 120, .height = 90}};
    app_display_init(&wish.display);
    wish.display.palette = "viridis";
    wish.display.is_locked = TRUE;
    wish.display.high = 10;
    app_orbit_begin(&wish.orbit, moment->scene, space);
    assert_int_equal(luxel_scene_surface_place(moment->scene, 0, wish.orbit.center_mm), LUXEL_OK);
    app_orbit_zoom(&wish.orbit, middle, 10);
    return wish;
}

/* A scene of which the finest picture is there. */
static void begin(const char *name, AppMoment **moment, AppLitWish *wish, Kept *kept)
{
    AppDocument *document = document_of_builtin(name);
    *moment = moment_of(document);
    AppSpace *space = app_space_new(*moment, NULL);
    AppLighter *lighter = app_lighter_new(keep, kept);
    *wish = wish_of(*moment, space);
    *kept = (Kept){.columns = 120};
    app_lighter_ask(lighter, wish);
    wait_until(is_finest, kept);
    app_lighter_free(lighter);
    app_space_free(space);
    g_object_unref(document);
}

/* Its colours are those of the field that the camera renders, and transparent where nothing is seen. */
static void test_light(void **state)
{
    AppMoment *moment;
    AppLitWish wish;
    Kept kept = {0};
    luxel_field *field;
    (void)state;
    begin("report", &moment, &wish, &kept);
    const camera from = app_orbit_camera(&wish.orbit, 1);
    luxel_scene *scene = camera_scene(moment->scene, &from, NULL);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    const gsize count = (gsize)kept.lit->columns * kept.lit->rows;
    guint32 *wanted = g_new(guint32, count);
    assert_int_equal(luxel_field_rows(field), kept.lit->rows);
    app_display_paint(&wish.display, field, 0, 10, (guchar *)wanted);
    gsize seen = 0;
    for (gsize i = 0; i < count; i++) {
        const gboolean is_body = luxel_field_mask(field)[i];
        assert_int_equal(kept.lit->pixels[i], is_body ? wanted[i] : 0);
        seen += is_body ? 1 : 0;
    }
    assert_in_range(seen, count / 50, count - 1);
    g_free(wanted);
    luxel_field_free(field);
    luxel_scene_free(scene);
    app_lit_unref(kept.lit);
    app_moment_unref(moment);
}

/* The distance to the sphere's nearest place is known, what is behind is hidden, and what is before is not. */
static void test_depth(void **state)
{
    AppMoment *moment;
    AppLitWish wish;
    Kept kept = {0};
    double center[3], radius, seen[3];
    (void)state;
    begin("report", &moment, &wish, &kept);
    assert_int_equal(luxel_scene_surface_place(moment->scene, 0, center), LUXEL_OK);
    assert_int_equal(luxel_scene_surface_radius(moment->scene, 0, &radius), LUXEL_OK);
    assert_true(app_orbit_see(&wish.orbit, center, seen));
    const double depth = app_lit_depth(kept.lit, seen[0], seen[1]);
    assert_true(fabs(depth - (seen[2] - radius)) < 0.02 * radius + 5);
    assert_true(app_lit_hides(kept.lit, seen));
    seen[2] -= 1.1 * radius;
    assert_false(app_lit_hides(kept.lit, seen));
    assert_true(app_lit_depth(kept.lit, 1, 1) == 0);
    assert_true(app_lit_depth(kept.lit, -5, 1) == 0);
    app_lit_unref(kept.lit);
    app_moment_unref(moment);
}

/* From inside a body nothing is seen, which is told. */
static void test_inside(void **state)
{
    AppDocument *document = document_of_builtin("report");
    AppMoment *moment = moment_of(document);
    AppSpace *space = app_space_new(moment, NULL);
    AppLitWish wish = wish_of(moment, space);
    Kept kept = {0};
    AppLighter *lighter = app_lighter_new(keep, &kept);
    (void)state;
    luxel_scene_surface_place(moment->scene, 0, wish.orbit.center_mm);
    wish.orbit.distance_mm = 1;
    app_lighter_ask(lighter, &wish);
    wait_until(has_come, &kept);
    assert_null(kept.lit->moment);
    app_lighter_free(lighter);
    app_lit_unref(kept.lit);
    app_space_free(space);
    app_moment_unref(moment);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_light),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
