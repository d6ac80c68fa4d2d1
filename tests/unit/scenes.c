/* SPDX-License-Identifier: MIT */
/* The helpers that tests of scenes share. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

const char good_scene[] = "luxel: 1\n"
                          "units: radiometric\n"
                          "screen: {width: 800, height: 800, resolution: [400, 400], sampling: nodes}\n"
                          "observer: {z: 1500, projection: orthographic, view: parallel}\n"
                          "surfaces:\n"
                          "  - type: sphere\n"
                          "    center: [0, 0, 1000]\n"
                          "    radius: 300\n"
                          "    material: {model: phong, diffuse: 0.8, shininess: 20}\n"
                          "lights:\n"
                          "  - {type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}\n"
                          "points: [[0, 0], [150, 0]]\n"
                          "picture: {range: max, rounding: truncate}\n";

char *changed(const char *old, const char *new_words)
{
    const char *at = strstr(good_scene, old);
    assert_non_null(at);
    size_t before = (size_t)(at - good_scene), size = sizeof good_scene + strlen(new_words);
    char *text = malloc(size);
    assert_non_null(text);
    snprintf(text, size, "%.*s%s%s", (int)before, good_scene, new_words, at + strlen(old));
    return text;
}

luxel_status load(const char *text, luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    *scene = NULL;
    luxel_status status = luxel_scene_read_text(text, strlen(text), "test.yaml", diagnostics, scene);
    return status == LUXEL_OK ? luxel_scene_commit(*scene, diagnostics) : status;
}

static luxel_scene *opened(const char *name)
{
    luxel_scene *scene = NULL;
    char *text = NULL;
    bool is_variant = *name >= '0' && *name <= '9';
    if (is_variant)
        assert_int_equal(luxel_variant_text((unsigned)atoi(name), NULL, &text), LUXEL_OK);
    const char *words = is_variant ? text : name;
    luxel_status status = is_variant || strchr(name, '\n')
                              ? luxel_scene_read_text(words, strlen(words), name, NULL, &scene)
                              : luxel_scene_open_builtin(name, NULL, &scene);
    luxel_text_free(text);
    if (status != LUXEL_OK)
        fail_msg("cannot read %s", name);
    return scene;
}

luxel_scene *opened_with(const char *name, const char *const *changes, size_t count)
{
    luxel_scene *scene = opened(name);
    for (size_t i = 0; i < count && changes[i]; i++)
        if (luxel_scene_set(scene, changes[i], NULL) != LUXEL_OK)
            fail_msg("%s: cannot set %s", name, changes[i]);
    if (luxel_scene_commit(scene, NULL) != LUXEL_OK)
        fail_msg("%s, %s: not a good scene", name, count > 0 && changes[0] ? changes[0] : "as it is");
    return scene;
}

void expect_entry(const luxel_diagnostics *diagnostics, size_t i, struct expected expected)
{
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
    assert_non_null(entry);
    char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
    char *hint = luxel_diagnostics_hint(diagnostics, i, NULL, NULL);
    assert_non_null(message);
    assert_non_null(hint);
    if (expected.id)
        assert_string_equal(entry->id, expected.id);
    if (expected.line)
        assert_int_equal(entry->line, expected.line);
    if (expected.column)
        assert_int_equal(entry->column, expected.column);
    if (expected.key)
        assert_string_equal(entry->key ? entry->key : "", expected.key);
    if (expected.message && !strstr(message, expected.message))
        fail_msg("\"%s\" is not in \"%s\"", expected.message, message);
    if (expected.hint && !strstr(hint, expected.hint))
        fail_msg("\"%s\" is not in \"%s\"", expected.hint, hint);
    luxel_text_free(message);
    luxel_text_free(hint);
}

void expect_text_error(const char *text, struct expected expected)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    assert_non_null(diagnostics);
    luxel_status status = load(text, diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status != LUXEL_ERROR_SCENE)
        fail_msg("no error %s, but status %d", expected.id, (int)status);
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR), 1);
    expect_entry(diagnostics, 0, expected);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

void expect_error(const char *old, const char *new_words, struct expected expected)
{
    char *text = changed(old, new_words);
    expect_text_error(text, expected);
    free(text);
}

luxel_scene *builtin(const char *name)
{
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin(name, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}
