/* SPDX-License-Identifier: MIT */
/* Marks: where they are, and that what is dragged ends where it was dragged to. */
#include <math.h>
#include <string.h>

#include "../../app/base/number.h"
#include "../../app/picture/marks.h"
#include "scenes.h"

static const AppTouch exact = {.mm_per_pixel = 1e-6}; /* so that rounding is nothing */

/* A mark in hand, and what it is moved in. */
typedef struct Drag {
    AppDocument *document;
    AppMoment *moment;
    AppMark mark;
    AppHand hand;
    double pointer_mm[2];
} Drag;

/* The mark of a kind and index; fails where there is none. */
static AppMark mark_of(const AppMoment *moment, AppMarkKind kind, gsize index)
{
    AppMark found = {.kind = APP_MARK_NONE};
    GArray *marks = app_marks_of(moment);
    for (guint i = 0; i < marks->len; i++) {
        const AppMark *mark = &g_array_index(marks, AppMark, i);
        if (mark->kind == kind && mark->index == index)
            found = *mark;
    }
    g_array_unref(marks);
    assert_int_equal(found.kind, kind);
    return found;
}

/* Takes it a little beside its middle. */
static Drag take(AppDocument *document, AppMarkKind kind, gsize index)
{
    Drag drag = {.document = document, .moment = moment_of(document)};
    drag.mark = mark_of(drag.moment, kind, index);
    drag.pointer_mm[0] = drag.mark.screen_mm[0] + 3;
    drag.pointer_mm[1] = drag.mark.screen_mm[1] - 2;
    app_hand_take(&drag.hand, &drag.mark, drag.pointer_mm, drag.mark.screen_mm);
    return drag;
}

static Drag take_builtin(const char *scene, AppMarkKind kind, gsize index)
{
    return take(document_of_builtin(scene), kind, index);
}

static gboolean pull(Drag *drag, double x_mm, double y_mm, AppTouch touch)
{
    drag->pointer_mm[0] += x_mm;
    drag->pointer_mm[1] += y_mm;
    memcpy(touch.pointer_mm, drag->pointer_mm, sizeof touch.pointer_mm);
    return app_hand_move(&drag->hand, &touch, drag->moment, drag->document);
}

/* The mark as it is now. */
static AppMark drop(Drag *drag)
{
    AppMoment *moment = moment_of(drag->document);
    AppMark mark = mark_of(moment, drag->mark.kind, drag->mark.index);
    app_moment_unref(moment);
    return mark;
}

static void end(Drag *drag)
{
    app_moment_unref(drag->moment);
    g_object_unref(drag->document);
}

static void expect_near(const double *found, double x, double y, double within)
{
    if (!(fabs(found[0] - x) <= within && fabs(found[1] - y) <= within))
        fail_msg("(%.12g, %.12g) instead of (%.12g, %.12g)", found[0], found[1], x, y);
}

/* ---- where they are ---- */

static void marks_everything(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("all-sources");
    AppMoment *moment = moment_of(document);
    GArray *marks = app_marks_of(moment);
    assert_int_equal(marks->len, 1 + 8 + 5); /* the ambient light stands nowhere */
    AppMark mark = mark_of(moment, APP_MARK_SOURCE, 2);
    expect_near(mark.place_mm, -1100, 900, 0);
    assert_true(mark.is_on && !mark.is_distant);
    mark = mark_of(moment, APP_MARK_SOURCE, 1);
    assert_true(mark.is_distant && !mark.is_behind);
    const double length = sqrt(0.3 * 0.3 + 1 + 0.4 * 0.4);
    expect_near(mark.screen_mm, 500 * 0.3 / length, 500 / length, 1e-9);
    mark = mark_of(moment, APP_MARK_POINT, 2);
    expect_near(mark.screen_mm, -200, 100, 0);
    g_array_unref(marks);
    app_moment_unref(moment);
    set(document, "lights[2].enabled", "false");
    moment = moment_of(document);
    assert_false(mark_of(moment, APP_MARK_SOURCE, 2).is_on);
    app_moment_unref(moment);
    g_object_unref(document);
}

static void expect_key_of_place(const AppDocument *document, AppMarkKind kind, gsize index, const char *expected)
{
    char *key = app_place_key(document, kind, index);
    if (expected)
        assert_string_equal(key, expected);
    else
        assert_null(key);
    g_free(key);
}

static void knows_keys_of_places(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("all-sources");
    static const char *const keys[] = {NULL,
                                       NULL,
                                       "lights[2].position",
                                       "lights[3].position",
                                       "lights[4].rectangle.center",
                                       "lights[5].disk.center",
                                       "lights[6].box.center",
                                       "lights[7].sphere.center",
                                       "lights[8].cylinder.center"};
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        expect_key_of_place(document, APP_MARK_SOURCE, i, keys[i]);
    expect_key_of_place(document, APP_MARK_SURFACE, 0, "surfaces[0].center");
    expect_key_of_place(document, APP_MARK_POINT, 3, "points[3]");
    expect_key_of_place(document, APP_MARK_SECTION, 0, NULL);
    g_object_unref(document);
}

/* ---- dragging ---- */

static void drag_each_mark(const char *scene)
{
    AppDocument *document = document_of_builtin(scene);
    AppMoment *moment = moment_of(document);
    GArray *marks = app_marks_of(moment);
    for (guint i = 0; i < marks->len; i++) {
        const AppMark *mark = &g_array_index(marks, AppMark, i);
        if (mark->is_distant)
            continue;
        Drag drag = take_builtin(scene, mark->kind, mark->index);
        assert_true(pull(&drag, 11.25, 4, exact));
        assert_true(pull(&drag, 0.5, -24.625, exact));
        AppMark after = drop(&drag);
        expect_near(after.screen_mm, mark->screen_mm[0] + 11.75, mark->screen_mm[1] - 20.625, 1e-5);
        double height = mark->place_mm[2], stays = after.place_mm[2]; /* of a point of the screen */
        if (mark->kind != APP_MARK_POINT) {
            assert_true(luxel_scene_height(moment->scene, mark->place_mm, &height));
            assert_true(luxel_scene_height(moment->scene, after.place_mm, &stays));
        }
        assert_true(fabs(stays - height) < 1e-6); /* the grain of coordinates, in a turned frame */
        end(&drag);
    }
    g_array_unref(marks);
    app_moment_unref(moment);
    g_object_unref(document);
}

static void moves_what_is_dragged(void **state)
{
    (void)state;
    for (gsize i = 0; i < luxel_builtin_scene_count(); i++)
        drag_each_mark(luxel_builtin_scene_name(i));
}

static void moves_in_space_as_on_the_screen(void **state)
{
    (void)state;
    Drag drag = take_builtin("report", APP_MARK_SOURCE, 0); /* orthographic */
    assert_true(pull(&drag, -100, 50, exact));
    assert_key(drag.document, "lights[0].position", "[1900, 50, 2000]");
    end(&drag);
    drag = take_builtin("spot", APP_MARK_SURFACE, 0); /* in perspective: (3000 - 600) / 3000 of it */
    assert_true(pull(&drag, 100, -50, exact));
    assert_key(drag.document, "surfaces[0].center", "[80, -40, 600]");
    end(&drag);
    drag = take_builtin("report", APP_MARK_POINT, 1);
    assert_true(pull(&drag, -10, 7.5, exact));
    assert_key(drag.document, "points[1]", "[140, 7.5]");
    end(&drag);
}

static void counts_a_tenth_with_shift(void **state)
{
    (void)state;
    Drag drag = take_builtin("report", APP_MARK_SOURCE, 0);
    AppTouch fine = exact;
    fine.fine = TRUE;
    assert_true(pull(&drag, 100, 0, fine));
    assert_key(drag.document, "lights[0].position", "[2010, 0, 2000]");
    assert_true(pull(&drag, 100, 30, exact)); /* from there on whole again, without a jump */
    assert_key(drag.document, "lights[0].position", "[2110, 30, 2000]");
    assert_true(pull(&drag, -50, 0, fine));
    assert_key(drag.document, "lights[0].position", "[2105, 30, 2000]");
    end(&drag);
}

static void rounds(void **state)
{
    (void)state;
    Drag drag = take_builtin("report", APP_MARK_SOURCE, 0);
    AppTouch touch = {.mm_per_pixel = 0.7};
    assert_true(pull(&drag, 12.3456, -7.6543, touch)); /* to a power of ten below the pixel */
    assert_key(drag.document, "lights[0].position", "[2012.3, -7.7, 2000]");
    touch.snap = TRUE; /* steps of some eight pixels */
    assert_true(pull(&drag, 0, 0, touch));
    assert_key(drag.document, "lights[0].position", "[2010, -10, 2000]");
    touch.mm_per_pixel = 0.13;
    assert_true(pull(&drag, 0, 0, touch));
    assert_key(drag.document, "lights[0].position", "[2012, -8, 2000]");
    touch.mm_per_pixel = 0.04;
    assert_true(pull(&drag, 0, 0, touch));
    assert_key(drag.document, "lights[0].position", "[2012.5, -7.5, 2000]");
    end(&drag);
    drag = take_builtin("report", APP_MARK_POINT, 0);
    touch.mm_per_pixel = 0.04;
    touch.snap = FALSE;
    assert_true(pull(&drag, 0.3, 0.7, touch));
    assert_key(drag.document, "points[0]", "[0.3, 0.7]"); /* as people write it */
    end(&drag);
}

static void changes_only_the_height_with_alt(void **state)
{
    (void)state;
    static const char *const scenes[] = {"report", "spot"}; /* orthographic and perspective */
    for (gsize s = 0; s < G_N_ELEMENTS(scenes); s++) {
        Drag drag = take_builtin(scenes[s], APP_MARK_SURFACE, 0);
        AppTouch alt = {.mm_per_pixel = 0.01, .height = TRUE};
        const double *start = drag.mark.place_mm;
        assert_true(pull(&drag, 0, 0, alt)); /* from where it is pressed */
        assert_true(pull(&drag, 40, 25, alt));
        assert_true(pull(&drag, 0, 5.126, alt));
        AppMark after = drop(&drag);
        expect_near(after.place_mm, start[0], start[1], 0);
        assert_true(fabs(after.place_mm[2] - (start[2] + 30.13)) < 1e-9);
        alt.height = FALSE; /* the new height is kept, as it was rounded; sideways motion so far counts */
        assert_true(pull(&drag, 0, 0, alt));
        char *center = app_document_get(drag.document, "surfaces[0].center", NULL);
        double place[3];
        assert_int_equal(app_list_read(center, place, 3), 3);
        assert_true(fabs(place[2] - (start[2] + 30.13)) < 1e-9);
        assert_true(place[2] == round(place[2] * 100) / 100);
        g_free(center);
        end(&drag);
    }
    Drag drag = take_builtin("report", APP_MARK_POINT, 1); /* has no height */
    AppTouch alt = exact;
    alt.height = TRUE;
    assert_true(pull(&drag, 5, 6, alt));
    assert_key(drag.document, "points[1]", "[155, 6]");
    end(&drag);
}

static void turns_distant_light_on_its_dome(void **state)
{
    (void)state;
    Drag drag = take_builtin("distant", APP_MARK_SOURCE, 0);
    const double radius = 400;
    assert_true(drag.mark.is_distant && !drag.mark.is_behind);
    const double step[2] = {0.3 * radius - drag.mark.screen_mm[0], -0.4 * radius - drag.mark.screen_mm[1]};
    assert_true(pull(&drag, step[0], step[1], exact));
    AppMark after = drop(&drag);
    expect_near(after.screen_mm, 0.3 * radius, -0.4 * radius, 0.05);
    assert_true(fabs(after.place_mm[2] - sqrt(1 - 0.09 - 0.16)) < 1e-3); /* of length 1 */
    assert_true(pull(&drag, 10 * radius, 0, exact));                     /* beyond the rim: from the horizon */
    after = drop(&drag);
    assert_true(fabs(hypot(after.screen_mm[0], after.screen_mm[1]) - radius) < 0.1);
    assert_true(fabs(after.place_mm[2]) < 0.02);
    assert_true(pull(&drag, -10.3 * radius, 0.4 * radius, exact)); /* the middle: along the view */
    expect_near(drop(&drag).place_mm, 0, 0, 1e-3);
    end(&drag);
    AppDocument *document = document_of_builtin("distant");
    set(document, "lights[0].direction", "[0.6, 0, 0.8]");
    drag = take(document, APP_MARK_SOURCE, 0);
    assert_true(drag.mark.is_behind);
    assert_true(pull(&drag, 0.6 * radius, 0, exact));
    expect_near(drop(&drag).place_mm, 0, 0, 1e-3);
    assert_true(drop(&drag).is_behind); /* from below it stays */
    end(&drag);
}

static const char polygon[] =
    "luxel: 1\n"
    "screen: {width: 800, height: 800, resolution: [40, 40]}\n"
    "observer: {z: 3000}\n"
    "surfaces:\n  - {type: sphere, center: [0, 0, 1000], radius: 300}\n"
    "lights:\n  - {type: planar, radiance: 10, vertices: [[-100, 0, 2000], [-100.5, 200, 2010], [100, 200, 2010], "
    "[100, 0, 2000]]}\n";

static void moves_a_polygon_with_all_corners(void **state)
{
    (void)state;
    Drag drag = take(document_of_text(polygon), APP_MARK_SOURCE, 0);
    AppTouch touch = {.mm_per_pixel = 10};
    assert_true(pull(&drag, 30, 10, touch));
    assert_true(pull(&drag, 20, -30, touch));
    AppMark after = drop(&drag);
    double numbers[12], first[12] = {-100, 0, 2000, -100.5, 200, 2010, 100, 200, 2010, 100, 0, 2000};
    char *text = app_document_get(drag.document, "lights[0].vertices", NULL);
    assert_int_equal(app_list_read(text, numbers, 12), 12);
    /* the centroid gets round numbers, and all corners go with it */
    const double move[3] = {after.place_mm[0] - drag.mark.place_mm[0], after.place_mm[1] - drag.mark.place_mm[1], 0};
    expect_near(move, 50, -20, 5);
    for (int i = 0; i < 12; i++)
        assert_true(fabs(numbers[i] - first[i] - move[i % 3]) < 2e-6);
    g_free(text);
    end(&drag);
}

static void raises_a_polygon_where_it_stands(void **state)
{
    (void)state;
    Drag drag = take(document_of_text(polygon), APP_MARK_SOURCE, 0);
    const AppTouch touch = {.mm_per_pixel = 1, .height = TRUE};
    assert_true(pull(&drag, 0, 0, touch)); /* from where the key was pressed */
    assert_true(pull(&drag, 70, 30, touch));
    assert_true(pull(&drag, -40, 20, touch)); /* once more: from where the last move left it */
    const AppMark after = drop(&drag);
    expect_near(after.place_mm, drag.mark.place_mm[0], drag.mark.place_mm[1], 1e-6);
    assert_true(fabs(after.place_mm[2] - drag.mark.place_mm[2] - 50) < 1);
    end(&drag);
}

/* Where one source alone is shown, the others do not shine, and their marks say so; each has its number and name. */
static void tells_who_shines(void **state)
{
    (void)state;
    static const char *const labels[] = {"1 key", "2 fill", "3 rim"};
    AppDocument *document = document_of_builtin("three-lights");
    AppMoment *moment = app_moment_new(app_document_copy_scene(document), 1, 1, NULL);
    assert_non_null(moment);
    for (gsize i = 0; i < G_N_ELEMENTS(labels); i++) {
        const AppMark mark = mark_of(moment, APP_MARK_SOURCE, i);
        assert_int_equal(mark.is_on, i == 1);
        assert_string_equal(mark.label, labels[i]);
    }
    assert_string_equal(mark_of(moment, APP_MARK_POINT, 2).label, "P3");
    app_moment_unref(moment);
    set(document, "lights[0].name", "\"очень длинное имя источника света, которое не помещается\"");
    moment = moment_of(document);
    const AppMark mark = mark_of(moment, APP_MARK_SOURCE, 0);
    assert_true(g_utf8_validate(mark.label, -1, NULL)); /* cut between letters */
    assert_true(g_str_has_prefix(mark.label, "1 очень длинное"));
    app_moment_unref(moment);
    g_object_unref(document);
}

static void follows_in_proportion_at_the_edge(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppMoment *moment = moment_of(document);
    AppMark mark = mark_of(moment, APP_MARK_SOURCE, 0);
    AppHand hand;
    const double shown[2] = {mark.screen_mm[0] / 8, mark.screen_mm[1] / 8}, pointer[2] = {shown[0] + 1, shown[1] - 2};
    AppTouch touch = {.mm_per_pixel = 0.5, .pointer_mm = {pointer[0], pointer[1]}};
    app_hand_take(&hand, &mark, pointer, shown);
    assert_true(app_hand_move(&hand, &touch, moment, document)); /* taking it alone moves nothing */
    assert_key(document, "lights[0].position", "[2000, 0, 2000]");
    touch.pointer_mm[0] += 10;
    touch.pointer_mm[1] += 5;
    assert_true(app_hand_move(&hand, &touch, moment, document));
    assert_key(document, "lights[0].position", "[2080, 40, 2000]");
    app_moment_unref(moment);
    g_object_unref(document);
}

static void shifts_by_keys(void **state)
{
    (void)state;
    static const double step[3] = {0.1, -0.2, 5};
    Drag drag = take_builtin("report", APP_MARK_SOURCE, 0);
    assert_true(app_mark_shift(&drag.mark, step, drag.document));
    assert_key(drag.document, "lights[0].position", "[2000.1, -0.2, 2005]");
    /* a second key before a picture shows what the first has done */
    assert_true(app_mark_shift(&drag.mark, step, drag.document));
    assert_key(drag.document, "lights[0].position", "[2000.2, -0.4, 2010]");
    end(&drag);
    drag = take_builtin("report", APP_MARK_POINT, 0);
    assert_true(app_mark_shift(&drag.mark, step, drag.document));
    assert_key(drag.document, "points[0]", "[0.1, -0.2]");
    assert_true(app_mark_shift(&drag.mark, step, drag.document));
    assert_key(drag.document, "points[0]", "[0.2, -0.4]");
    end(&drag);
    drag = take(document_of_text(polygon), APP_MARK_SOURCE, 0);
    assert_true(app_mark_shift(&drag.mark, step, drag.document));
    assert_key(drag.document, "lights[0].vertices",
               "[[-99.9, -0.2, 2005], [-100.4, 199.8, 2015], [100.1, 199.8, 2015], [100.1, -0.2, 2005]]");
    end(&drag);
    drag = take_builtin("distant", APP_MARK_SOURCE, 0);
    assert_true(app_mark_shift(&drag.mark, (double[]){-40, 20, 0}, drag.document));
    expect_near(drop(&drag).screen_mm, drag.mark.screen_mm[0] - 40, drag.mark.screen_mm[1] + 20, 0.1);
    end(&drag);
    drag = take_builtin("report", APP_MARK_SURFACE, 0);
    AppMark nothing = drag.mark;
    nothing.index = 7;
    assert_false(app_mark_shift(&nothing, step, drag.document));
    nothing.kind = APP_MARK_SECTION;
    assert_false(app_mark_shift(&nothing, step, drag.document));
    end(&drag);
}

/* Seen from the side a mark moves as the screen lies, and its height above that stays. */
static void seen_from_the_side(void **state)
{
    static const char text[] = "luxel: 1\nscreen: {width: 500, height: 500, resolution: [100, 100]}\n"
                               "observer: {position: [2000, 0, 1000], target: [0, 0, 1000]}\n"
                               "surfaces: [{type: sphere, center: [100, 20, 1040], radius: 100}]\n"
                               "lights: [{type: point, position: [700, 200, 900], intensity: 10}]\n";
    (void)state;
    for (int i = 0; i < 2; i++) {
        const AppMarkKind kind = i == 0 ? APP_MARK_SOURCE : APP_MARK_SURFACE;
        Drag drag = take(document_of_text(text), kind, 0);
        expect_near(drag.mark.screen_mm, i == 0 ? 100 : -40, i == 0 ? 200 : 20, 1e-9);
        assert_true(pull(&drag, 30, -10, exact));
        assert_true(pull(&drag, 20, -5, exact));
        AppMark mark = drop(&drag);
        expect_near(mark.screen_mm, i == 0 ? 150 : 10, i == 0 ? 185 : 5, 1e-4);
        expect_near(mark.place_mm, i == 0 ? 700 : 100, i == 0 ? 185 : 5, 1e-4);
        expect_near(&mark.place_mm[1], i == 0 ? 185 : 5, i == 0 ? 850 : 990, 1e-4);
        end(&drag);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(marks_everything),
        cmocka_unit_test(seen_from_the_side),
        cmocka_unit_test(knows_keys_of_places),
        cmocka_unit_test(moves_what_is_dragged),
        cmocka_unit_test(moves_in_space_as_on_the_screen),
        cmocka_unit_test(counts_a_tenth_with_shift),
        cmocka_unit_test(rounds),
        cmocka_unit_test(changes_only_the_height_with_alt),
        cmocka_unit_test(turns_distant_light_on_its_dome),
        cmocka_unit_test(moves_a_polygon_with_all_corners),
        cmocka_unit_test(raises_a_polygon_where_it_stands),
        cmocka_unit_test(follows_in_proportion_at_the_edge),
        cmocka_unit_test(tells_who_shines),
        cmocka_unit_test(shifts_by_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
