/* SPDX-License-Identifier: MIT */
/* Sketches have the grey levels of the scenes' own pictures, come in order, and tell what is not to be had. */
#include <glib/gstdio.h>

#include "../../app/picture/sketch.h"
#include "scenes.h"

enum { MOST = 8 };

typedef struct Seen {
    AppSketch sketches[MOST];
    guint count, wanted;
} Seen;

static void keep(const AppSketch *sketch, gpointer owner)
{
    Seen *seen = owner;
    assert_true(seen->count < MOST);
    AppSketch *kept = &seen->sketches[seen->count++];
    *kept = *sketch;
    kept->scene = g_strdup(sketch->scene);
    if (kept->pixels)
        g_bytes_ref(kept->pixels);
}

static gboolean is_all(gpointer data)
{
    const Seen *seen = data;
    return seen->count >= seen->wanted;
}

static void clear(Seen *seen)
{
    for (guint i = 0; i < seen->count; i++) {
        g_free(seen->sketches[i].scene);
        g_clear_pointer(&seen->sketches[i].pixels, g_bytes_unref);
    }
}

/* The scene's picture has fewer than twice the pixels of a sketch, so that each is computed. */
static void assert_like_the_picture(const AppSketch *sketch, const AppDocument *document)
{
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    const guint columns = luxel_field_columns(shot->field), rows = luxel_field_rows(shot->field);
    const gsize count = (gsize)columns * rows;
    guint8 *grey = g_malloc(count);
    gsize size;
    assert_non_null(sketch->pixels);
    const guint8 *pixels = g_bytes_get_data(sketch->pixels, &size);
    luxel_field_grey(shot->field, grey);
    assert_int_equal(sketch->columns, columns);
    assert_int_equal(sketch->rows, rows);
    assert_int_equal(size, 3 * count);
    for (gsize i = 0; i < 3 * count; i++)
        assert_int_equal(pixels[i], grey[i / 3]);
    g_free(grey);
    app_shot_unref(shot);
}

static void pictures_of_scenes(void **state)
{
    static const char *const scenes[] = {"builtin:report", "/nowhere/at-all.yaml", "builtin:three-lights",
                                         "builtin:none", NULL};
    Seen seen = {.wanted = 4};
    AppSketcher *sketcher = app_sketcher_new(keep, &seen);
    AppDocument *document = document_of_builtin("report");
    (void)state;
    app_sketcher_ask(sketcher, scenes);
    wait_until(is_all, &seen);
    for (guint i = 0; i < seen.count; i++)
        assert_string_equal(seen.sketches[i].scene, scenes[i]);
    assert_like_the_picture(&seen.sketches[0], document);
    assert_null(seen.sketches[1].pixels);
    assert_null(seen.sketches[3].pixels);
    /* 500 x 400, each second pixel */
    assert_int_equal(seen.sketches[2].columns, 250);
    assert_int_equal(seen.sketches[2].rows, 200);
    g_object_unref(document);
    app_sketcher_free(sketcher);
    clear(&seen);
}

static void files(void **state)
{
    char *path = g_build_filename(g_get_tmp_dir(), "luxel-sketch-XXXXXX.yaml", NULL);
    const int file = g_mkstemp(path);
    const char *const scenes[] = {path, NULL};
    Seen seen = {.wanted = 1};
    AppSketcher *sketcher = app_sketcher_new(keep, &seen);
    AppDocument *document = document_of_builtin("two-spheres");
    (void)state;
    assert_true(file >= 0);
    assert_true(g_close(file, NULL));
    set(document, "screen.resolution", "[120, 96]");
    assert_true(g_file_set_contents(path, app_document_text(document), -1, NULL));
    app_sketcher_ask(sketcher, scenes);
    wait_until(is_all, &seen);
    assert_like_the_picture(&seen.sketches[0], document);
    g_remove(path);
    g_object_unref(document);
    app_sketcher_free(sketcher);
    clear(&seen);
    g_free(path);
}

/* Whoever stops asking is not told the rest. */
static void end_while_drawing(void **state)
{
    static const char *const scenes[] = {"builtin:report", "builtin:tin", "builtin:desk", NULL};
    Seen seen = {0};
    (void)state;
    AppSketcher *sketcher = app_sketcher_new(keep, &seen);
    app_sketcher_ask(sketcher, scenes);
    app_sketcher_free(sketcher);
    app_sketcher_free(NULL);
    run_for(50);
    assert_int_equal(seen.count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_of_scenes),
        cmocka_unit_test(files),
        cmocka_unit_test(end_while_drawing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
