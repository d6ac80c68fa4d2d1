/* SPDX-License-Identifier: MIT */
/* Silhouettes in plan and elevation: found anew where a mesh changes, and shifted where it only moves. */
#include "../../app/space/outlines.h"

#include <math.h>
#include <string.h>

#include "scenes.h"

static AppDocument *document_of_pot(void)
{
    AppDocument *document = document_of_builtin("report");
    set(document, "surfaces", "[{type: mesh, file: 'builtin:pot.ply', position: [0, 0, 300]}]");
    return document;
}

/* The first line of the surface in a projection, as the stage has it; *count of places. */
static double *line_of(const AppDocument *document, AppOutlines *outlines, AppProjection projection, gsize *count)
{
    AppMoment *moment = moment_of(document);
    AppSpace *space = app_space_new(moment, outlines);
    double *places = NULL;
    for (guint i = 0; i < space->lines->len && !places; i++) {
        const AppLine *line = &g_array_index(space->lines, AppLine, i);
        if (line->kind != APP_LINE_SURFACE || !(line->projections & 1u << projection))
            continue;
        *count = line->count;
        places = g_memdup2((const double(*)[3])(const void *)space->places->data + line->first, 24 * line->count);
    }
    app_space_free(space);
    app_moment_unref(moment);
    assert_non_null(places);
    return places;
}

/* A silhouette that is kept stands where one that is found anew does. */
static void test_moving(void **state)
{
    (void)state;
    AppDocument *document = document_of_pot();
    AppOutlines *kept = app_outlines_new();
    for (int i = 0; i < APP_PROJECTIONS; i++) {
        gsize count, before_count, fresh_count;
        set(document, "surfaces[0].position", "[0, 0, 300]");
        double *before = line_of(document, kept, (AppProjection)i, &before_count);
        set(document, "surfaces[0].position", "[120, -70, 410]");
        double *moved = line_of(document, kept, (AppProjection)i, &count);
        AppOutlines *fresh = app_outlines_new();
        double *anew = line_of(document, fresh, (AppProjection)i, &fresh_count);
        assert_int_equal(count, before_count);
        assert_int_equal(count, fresh_count);
        assert_true(count > 20);
        const int up = app_projection_up((AppProjection)i);
        for (gsize k = 0; k < count; k++) {
            assert_true(fabs(moved[3 * k] - before[3 * k] - 120) < 1e-9);
            assert_true(fabs(moved[3 * k + (gsize)up] - before[3 * k + (gsize)up] - (up == 1 ? -70 : 110)) < 1e-9);
            for (gsize axis = 0; axis < 3; axis++)
                assert_true(fabs(moved[3 * k + axis] - anew[3 * k + axis]) < 1e-6);
        }
        app_outlines_free(fresh);
        g_free(anew);
        g_free(moved);
        g_free(before);
    }
    app_outlines_free(kept);
    g_object_unref(document);
}

static const luxel_silhouette *find(const AppDocument *document, AppOutlines *outlines)
{
    double then_mm[3], now_mm[3];
    AppMoment *moment = moment_of(document);
    const luxel_silhouette *found = app_outlines_find(outlines, moment->scene, 0, APP_PLAN, then_mm, now_mm);
    app_moment_unref(moment);
    return found;
}

static double width_of(const luxel_silhouette *silhouette)
{
    double low = (double)INFINITY, high = (double)-INFINITY;
    assert_non_null(silhouette);
    for (gsize i = 0; i < silhouette->count; i++)
        for (gsize k = 0; k < silhouette->lines[i].count; k++) {
            low = MIN(low, silhouette->lines[i].places_mm[k][0]);
            high = MAX(high, silhouette->lines[i].places_mm[k][0]);
        }
    return high - low;
}

static void test_changing(void **state)
{
    (void)state;
    AppDocument *document = document_of_pot();
    AppOutlines *outlines = app_outlines_new();
    const luxel_silhouette *first = find(document, outlines);
    const double width = width_of(first);
    set(document, "surfaces[0].position", "[5, 5, 305]");
    assert_ptr_equal(find(document, outlines), first);
    set(document, "surfaces[0].scale", "2");
    assert_true(fabs(width_of(find(document, outlines)) - 2 * width) < 0.01 * width);
    set(document, "surfaces[0].scale", "1");
    set(document, "surfaces[0].rotate", "[90, 0, 45]");
    assert_true(fabs(width_of(find(document, outlines)) - width) > 0.01 * width);
    set(document, "surfaces[0]", "{type: sphere, center: [0, 0, 0], radius: 100}");
    assert_true(fabs(width_of(find(document, outlines)) - 200) < 1);
    set(document, "surfaces[0]", "{type: box, center: [0, 0, 0], size: [100, 100, 50], rotate: [0, 0, 45]}");
    assert_true(fabs(width_of(find(document, outlines)) - 100 * G_SQRT2) < 1e-6);
    app_outlines_free(outlines);
    app_outlines_free(NULL);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_moving), cmocka_unit_test(test_changing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
