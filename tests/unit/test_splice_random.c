/* SPDX-License-Identifier: MIT */
/*
 * Changed scenes as text, by chance: the built-in scenes, as they are and written in hundreds of random styles, with
 * random changes.  What is written must read as the changed scene, keep the lines that were not changed, in their
 * order, and keep all comments that do not stand inside a replaced value.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/layout.h"
#include "scene/object.h"
#include "scene/splice.h"
#include "scenes.h"
#include "styles.h"

enum { TEXTS = 600, SETS = 8, MOST_LINES = 500 };

/* ---- what must hold ---- */

static size_t split(const char *text, const char **lines, size_t *lengths)
{
    size_t count = 0;
    for (; *text && count < MOST_LINES; count++) {
        lines[count] = text;
        lengths[count] = strcspn(text, "\n");
        text += lengths[count] + (text[lengths[count]] == '\n');
    }
    return count;
}

/* How many lines of a text are not in another one, in their order: their longest common sequence has the rest. */
static size_t lost_lines(const char *before, const char *after)
{
    static const char *old[MOST_LINES], *new_lines[MOST_LINES];
    static size_t old_lengths[MOST_LINES], new_lengths[MOST_LINES], best[MOST_LINES + 1][MOST_LINES + 1];
    size_t old_count = split(before, old, old_lengths), new_count = split(after, new_lines, new_lengths);
    for (size_t i = 1; i <= old_count; i++)
        for (size_t j = 1; j <= new_count; j++) {
            size_t most = best[i - 1][j] > best[i][j - 1] ? best[i - 1][j] : best[i][j - 1];
            if (old_lengths[i - 1] == new_lengths[j - 1] &&
                memcmp(old[i - 1], new_lines[j - 1], old_lengths[i - 1]) == 0)
                most = best[i - 1][j - 1] + 1;
            best[i][j] = most;
        }
    return old_count - best[old_count][new_count];
}

static void expect_comments(const char *before, const char *after)
{
    for (const char *at = before; (at = strstr(at, "#~")); at++) {
        char comment[16];
        snprintf(comment, sizeof comment, "%.*s", (int)(strcspn(at + 2, "~") + 3), at);
        if (!strstr(after, comment))
            fail_msg("lost %s of:\n%s\nin:\n%s", comment, before, after);
    }
}

static void expect_written(const luxel_scene *scene, const char *before, bool json, bool whole, const char *set,
                           char **after)
{
    const struct lx_document *document = &scene->document;
    struct lx_place place = lx_document_place(document, document->root);
    struct lx_text spliced = {0};
    luxel_scene *back = NULL;
    bool is_json;
    if (lx_splice(document, document->root, place.text, place.length, &spliced, &is_json) != LX_SPLICED)
        fail_msg("%s was not spliced into:\n%s", set, before);
    lx_text_clear(&spliced);
    assert_int_equal(luxel_scene_write_text(scene, after), LUXEL_OK);
    if (luxel_scene_read_text(*after, strlen(*after), "a", NULL, &back) != LUXEL_OK ||
        !lx_document_same(document, document->root, &back->document, back->document.root, false))
        fail_msg("%s makes\n%s\nfrom:\n%s", set, *after, before);
    luxel_scene_free(back);
    if (json && !lx_is_json_value(*after, strlen(*after)))
        fail_msg("no JSON: %s", *after);
    if (whole)
        return;
    expect_comments(before, *after);
    if (lost_lines(before, *after) > 2)
        fail_msg("%s touches too much:\n%s\nfrom:\n%s", set, *after, before);
}

/* ---- random changes ---- */

/* Those behind the NULL replace lists and mappings, and what comments stand in them. */
static const char *const assignments[] = {
    "screen.width=%u",
    "screen.sampling=centers",
    "observer.z=%u.5",
    "observer.view=observer",
    "shadows=none",
    "units=photometric",
    "picture.rounding=nearest",
    "lights[0].intensity=%u",
    "lights[0].name=lamp, %u",
    "lights.1.name='it''s'",
    "lights[1].enabled=false",
    "lights[2].intensity=1e%u",
    "surfaces[0].name=шар %u",
    "surfaces[0].name=\"a: b # %u\"",
    "surfaces[0].name=two\n  lines %u",
    "surfaces[0].material.shininess=%u",
    "surfaces[0].material.specular=.%u",
    "surfaces[1].material.model=lambert",
    "points[0][1]=-%u",
    NULL,
    "points[0]=[%u, 2]",
    "screen.resolution=[%u, 40]",
    "lights[0].position=[%u, 0,\n 300]",
    "points=[[1, 2], [3, %u]]",
    "lights[1]={type: spot, position: [1, 2, 3], intensity: %u, inner: 4, outer: 5}",
    "lights[0]=type: ambient\nirradiance: %u",
    "observer={z: %u}",
    "picture.range=[0, %u]",
    "surfaces[0].material={model: phong, shininess: %u}",
    "lights=[]",
    "lights=- type: ambient\n  irradiance: %u",
};

static void change(const char *text, bool json, uint64_t seed)
{
    enum { COUNT = sizeof assignments / sizeof assignments[0] };
    luxel_scene *scene = NULL;
    char *before = strdup(text), *after = NULL;
    if (luxel_scene_read_text(text, strlen(text), "a", NULL, &scene) != LUXEL_OK)
        fail_msg("not read:\n%s", text);
    assert_int_equal(luxel_scene_write_text(scene, &after), LUXEL_OK);
    assert_string_equal(after, text);
    luxel_text_free(after);
    for (unsigned i = 0; i < SETS; i++) {
        char set[200];
        unsigned which = random_below(&seed, COUNT);
        bool whole = false;
        for (unsigned k = 0; k < which; k++)
            whole |= !assignments[k];
        if (!assignments[which])
            continue;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
        snprintf(set, sizeof set, assignments[which], random_below(&seed, 300));
#pragma GCC diagnostic pop
        if (luxel_scene_set(scene, set, NULL) != LUXEL_OK)
            continue;
        expect_written(scene, before, json, whole, set, &after);
        free(before);
        before = after;
    }
    free(before);
    luxel_scene_free(scene);
}

static void changes_builtin_scenes(void **state)
{
    (void)state;
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++)
        for (uint64_t seed = 0; seed < 50; seed++)
            change(luxel_builtin_scene_text(i), false, seed);
}

static void changes_any_style(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < TEXTS; seed++) {
        luxel_scene *scene = NULL;
        bool json;
        const char *name = luxel_builtin_scene_name(seed % luxel_builtin_scene_count());
        assert_int_equal(luxel_scene_open_builtin(name, NULL, &scene), LUXEL_OK);
        char *text = random_style(&scene->document, seed, &json);
        luxel_scene_free(scene);
        change(text, json, seed + 1000);
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_builtin_scenes),
        cmocka_unit_test(changes_any_style),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
