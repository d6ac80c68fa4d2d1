/* SPDX-License-Identifier: MIT */
/*
 * Elements put in, taken out and moved by chance, in the built-in scenes written in hundreds of random styles,
 * compared with a plain model: a list of texts; and keys taken out.  All other keys keep their values, what stands
 * above and below the list its bytes, and comments go only with what is taken out.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"
#include "scene/layout.h"
#include "scene/path.h"
#include "scene/tidy.h"
#include "scenes.h"
#include "styles.h"

enum { TEXTS = 900, STEPS = 12, MOST_ELEMENTS = 40 };

/* ---- the model ---- */

struct model {
    const char *list;
    char *elements[MOST_ELEMENTS];
    size_t count;
};

static char *get(const luxel_scene *scene, const char *key)
{
    char *text = NULL;
    if (luxel_scene_get(scene, key, NULL, NULL, &text) != LUXEL_OK)
        fail_msg("not got: %s", key);
    return text;
}

static size_t size_of(const luxel_scene *scene, const char *list)
{
    size_t size = MOST_ELEMENTS;
    assert_int_equal(luxel_scene_list_size(scene, list, NULL, &size), LUXEL_OK);
    assert_true(size < MOST_ELEMENTS);
    return size;
}

static struct model model_of(const luxel_scene *scene, const char *list)
{
    struct model model = {.list = list, .count = size_of(scene, list)};
    for (size_t i = 0; i < model.count; i++) {
        char key[80];
        snprintf(key, sizeof key, "%s[%zu]", list, i);
        model.elements[i] = get(scene, key);
    }
    return model;
}

static void put(struct model *model, size_t index, char *element)
{
    memmove(model->elements + index + 1, model->elements + index, (model->count++ - index) * sizeof element);
    model->elements[index] = element;
}

static char *take(struct model *model, size_t index)
{
    char *element = model->elements[index];
    memmove(model->elements + index, model->elements + index + 1, (--model->count - index) * sizeof element);
    return element;
}

static void clear(struct model *model)
{
    while (model->count)
        luxel_text_free(take(model, 0));
}

static bool same(const struct model *one, const struct model *other)
{
    bool same = one->count == other->count;
    for (size_t i = 0; same && i < one->count; i++)
        same = strcmp(one->elements[i], other->elements[i]) == 0;
    return same;
}

/* ---- what must hold ---- */

static luxel_scene *read(const char *text, const char *what)
{
    luxel_scene *scene = NULL;
    if (luxel_scene_read_text(text, strlen(text), "a", NULL, &scene) != LUXEL_OK)
        fail_msg("%s: not read:\n%s", what, text);
    return scene;
}

/* The keys at the top but the one that the list is below have the values that they had. */
static void expect_others(const luxel_scene *before, const luxel_scene *after, const char *list, const char *what)
{
    const struct lx_document *document = &before->document;
    for (lx_node_id id = lx_document_node(document, document->root)->first; id;
         id = lx_document_node(document, id)->next) {
        const char *key = lx_document_key(document, id);
        if (strncmp(key, list, strlen(key)) == 0)
            continue;
        char *was = get(before, key), *is = get(after, key);
        if (strcmp(was, is) != 0)
            fail_msg("%s changes %s from %s to %s", what, key, was, is);
        luxel_text_free(was);
        luxel_text_free(is);
    }
}

/* Above the key at the top that the list is below, and below its lines, all bytes are as they were. */
static void expect_bytes(const luxel_scene *before, const char *text, const char *after, const char *list,
                         const char *what)
{
    const struct lx_document *document = &before->document;
    struct lx_layout layout = {text, strlen(text), document};
    char key[20];
    snprintf(key, sizeof key, "%.*s", (int)strcspn(list, "["), list);
    lx_node_id id = lx_document_find(document, document->root, key);
    if (!id)
        return;
    size_t start = lx_document_node(document, id)->key_start, end = lx_value_end(&layout, document->root, id);
    end = lx_is_flow(&layout, document->root) ? end : lx_line_end(&layout, end);
    size_t behind = layout.length - end, length = strlen(after);
    if (length < start + behind || memcmp(text, after, start) != 0 ||
        (memcmp(text + end, after + length - behind, behind) != 0 && behind))
        fail_msg("%s touches more than its list:\n%s\nfrom:\n%s", what, after, text);
}

static void expect_comments(const char *before, const char *after, const char *what)
{
    for (const char *at = before; (at = strstr(at, "#~")); at++) {
        char comment[16];
        snprintf(comment, sizeof comment, "%.*s", (int)(strcspn(at + 2, "~") + 3), at);
        if (!strstr(after, comment))
            fail_msg("%s loses %s of:\n%s\nin:\n%s", what, comment, before, after);
    }
}

/* ---- steps ---- */

static const char *const lists[] = {"lights", "lights", "surfaces", "points", "points[0]", "grids"};

/* Something to put into a list, written as luxel_scene_get() gives it. */
static const char *element_for(const char *list, uint64_t *seed)
{
    static const char *const groups[] = {"{type: ambient, irradiance: 3}", "{name: \"a, b\", type: spot}", "{}",
                                         "{type: planar, vertices: [[0, 0, 1], [1, 0, 1], [1, 1, 1]]}"};
    static const char *const points[] = {"[5, 6]", "[-1.5, 2]", "[]"};
    static const char *const numbers[] = {"7", "-8.5"};
    if (strcmp(list, "points") == 0)
        return points[random_below(seed, 3)];
    return strcmp(list, "points[0]") == 0 ? numbers[random_below(seed, 2)] : groups[random_below(seed, 4)];
}

/* Takes a step, in the scene and in the model; false where there is nothing to do. */
static bool step(luxel_scene *scene, struct model *model, uint64_t *seed, bool *loses, char what[80])
{
    unsigned kind = random_below(seed, 3), count = (unsigned)model->count;
    unsigned a = random_below(seed, count + 1), b = random_below(seed, count + 1);
    luxel_status status = LUXEL_OK;
    *loses = kind == 1;
    if (kind > 0 && a >= count)
        return false;
    if (kind == 0) {
        const char *element = element_for(model->list, seed);
        snprintf(what, 80, "%s[%u] in", model->list, a);
        put(model, a, strdup(element));
        status = luxel_scene_insert(scene, model->list, a, element, NULL);
    } else if (kind == 1) {
        snprintf(what, 80, "%s[%u]", model->list, a);
        luxel_text_free(take(model, a));
        status = luxel_scene_remove(scene, what, NULL);
    } else {
        b -= b == count;
        snprintf(what, 80, "%s[%u] to [%u]", model->list, a, b);
        put(model, b, take(model, a));
        status = luxel_scene_move(scene, model->list, a, b, NULL);
    }
    if (status != LUXEL_OK)
        fail_msg("%s fails", what);
    return true;
}

/* What luxel_scene_get() is to say of the mapping `path` when its key `without` is out. */
static char *rest_of(const luxel_scene *scene, const char *path, const char *without)
{
    struct lx_path found;
    struct lx_place place = {.text = path, .length = strlen(path)};
    struct lx_text text = {0};
    assert_int_equal(lx_follow_path(scene, &place, place.length, NULL, &found), LUXEL_OK);
    const struct lx_document *document = &scene->document;
    lx_node_id id = lx_document_node(document, found.nodes[found.count])->first;
    lx_text_puts(&text, "{");
    for (; id; id = lx_document_node(document, id)->next) {
        char key[80];
        if (strcmp(lx_document_key(document, id), without) == 0)
            continue;
        snprintf(key, sizeof key, "%s.%s", path, lx_document_key(document, id));
        char *value = get(scene, key);
        lx_text_puts(&text, text.length > 1 ? ", " : "");
        lx_write_key(&text, lx_document_key(document, id), false);
        lx_text_printf(&text, ": %s", value);
        luxel_text_free(value);
    }
    lx_text_puts(&text, "}");
    return lx_text_take(&text);
}

/* Takes out one key, at the top or below it. */
static void take_key(luxel_scene *scene, const char *key)
{
    char *before = NULL, *after = NULL, *expected = NULL, path[80] = "";
    const char *dot = strrchr(key, '.');
    bool written = false;
    if (luxel_scene_get(scene, key, NULL, &written, &before) != LUXEL_OK || !written) {
        luxel_text_free(before);
        return;
    }
    luxel_text_free(before);
    assert_int_equal(luxel_scene_write_text(scene, &before), LUXEL_OK);
    luxel_scene *was = read(before, key);
    if (dot) {
        snprintf(path, sizeof path, "%.*s", (int)(dot - key), key);
        expected = rest_of(scene, path, dot + 1);
    }
    assert_int_equal(luxel_scene_remove(scene, key, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_write_text(scene, &after), LUXEL_OK);
    luxel_scene *back = read(after, key);
    char *rest = dot ? get(back, path) : NULL;
    if (dot && strcmp(rest, expected) != 0)
        fail_msg("%s leaves %s of:\n%s\nin:\n%s", key, rest, before, after);
    assert_true(dot || !lx_document_find(&back->document, back->document.root, key));
    expect_others(was, back, key, key);
    luxel_scene_free(was);
    luxel_scene_free(back);
    luxel_text_free(rest);
    free(expected);
    luxel_text_free(before);
    luxel_text_free(after);
}

static void take_keys(const char *text, uint64_t seed)
{
    static const char *const keys[] = {"luxel",
                                       "units",
                                       "points",
                                       "observer.view",
                                       "surfaces[0].material.diffuse",
                                       "screen.width",
                                       "observer",
                                       "picture",
                                       "lights[0].name",
                                       "surfaces[0].material.over_pi",
                                       "lights[0].type",
                                       "screen.sampling",
                                       "grids[0].n",
                                       "surfaces[0].center",
                                       "surfaces[0].material",
                                       "picture.range",
                                       "lights[1].name",
                                       "grids[0].up",
                                       "lights[4].rectangle",
                                       "lights[0].intensity",
                                       "lights[2].axis",
                                       "surfaces[0].type",
                                       "observer.z",
                                       "lights[0].disk.radius"};
    luxel_scene *scene = read(text, "the style");
    for (unsigned i = 0; i < STEPS; i++)
        take_key(scene, keys[random_below(&seed, sizeof keys / sizeof keys[0])]);
    luxel_scene_free(scene);
}

static void change(const char *text, bool json, uint64_t seed)
{
    luxel_scene *scene = read(text, "the style");
    char *before = strdup(text), *after, what[80];
    for (unsigned i = 0; i < STEPS; i++) {
        const char *list = lists[random_below(&seed, sizeof lists / sizeof lists[0])];
        bool loses;
        if (strcmp(list, "points[0]") == 0 && size_of(scene, "points") == 0)
            continue;
        struct model model = model_of(scene, list);
        luxel_scene *was = read(before, "before");
        if (step(scene, &model, &seed, &loses, what)) {
            assert_int_equal(luxel_scene_write_text(scene, &after), LUXEL_OK);
            luxel_scene *back = read(after, what);
            struct model now = model_of(scene, list), written = model_of(back, list);
            if (!same(&model, &now) || !same(&model, &written))
                fail_msg("%s is wrong in:\n%s\nfrom:\n%s", what, after, before);
            expect_others(was, back, list, what);
            expect_bytes(was, before, after, list, what);
            if (!loses)
                expect_comments(before, after, what);
            if (json && !lx_is_json_value(after, strlen(after)))
                fail_msg("%s makes no JSON: %s", what, after);
            clear(&now);
            clear(&written);
            luxel_scene_free(back);
            free(before);
            before = after;
        }
        clear(&model);
        luxel_scene_free(was);
    }
    free(before);
    luxel_scene_free(scene);
}

static void changes_builtin_scenes(void **state)
{
    (void)state;
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++)
        for (uint64_t seed = 0; seed < (uint64_t)scenes_to_try(12); seed++) {
            change(luxel_builtin_scene_text(i), false, seed);
            take_keys(luxel_builtin_scene_text(i), seed);
        }
}

static void changes_any_style(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < (uint64_t)scenes_to_try(TEXTS); seed++) {
        luxel_scene *scene = NULL;
        bool json;
        const char *name = luxel_builtin_scene_name(seed % luxel_builtin_scene_count());
        assert_int_equal(luxel_scene_open_builtin(name, NULL, &scene), LUXEL_OK);
        char *text = random_style(&scene->document, seed, &json);
        luxel_scene_free(scene);
        change(text, json, seed + 1000);
        take_keys(text, seed + 2000);
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
