/* SPDX-License-Identifier: MIT */
/* The tester: what is false is caught, made as small as it can be, and can be repeated; scenes are of all kinds. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tester.h"

/* Not so: nothing keeps a scene from being bright. */
static bool is_never_bright(struct trial *trial)
{
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    return !picture || trial_maximum(picture) <= 3 || trial_fails(trial, "maximum %g", trial_maximum(picture));
}

static bool holds_always(struct trial *trial)
{
    return trial->scene != NULL;
}

static const struct property properties[] = {
    {"never-bright", "no scene is bright", is_never_bright, 1},
    {"always", "there is a scene", holds_always, 2},
};

static char *run(const struct tester_options *options, size_t broken)
{
    char *made;
    size_t length;
    FILE *out = open_memstream(&made, &length);
    assert_non_null(out);
    assert_int_equal(tester_run(properties, 2, options, out), broken);
    fclose(out);
    return made;
}

/* The scene of the first report, without the marks before its lines. */
static char *scene_in(const char *report)
{
    static const char mark[] = "#   ";
    char *text = calloc(1, strlen(report) + 1);
    const char *line = strstr(report, "#   luxel: 1");
    assert_true(text && line);
    while (strncmp(line, mark, strlen(mark)) == 0) {
        const char *end = strchr(line, '\n') + 1;
        strncat(text, line + strlen(mark), (size_t)(end - line) - strlen(mark));
        line = end;
    }
    return text;
}

static void test_false_is_caught(void **state)
{
    (void)state;
    char *report = run(&(struct tester_options){.seed = 1, .scenes = 40}, 1);
    assert_non_null(strstr(report, "not ok 1 - never-bright"));
    assert_non_null(strstr(report, "\nok 2 - always"));
    assert_non_null(strstr(report, "1..2"));
    free(report);
}

static size_t list_size(const luxel_scene *scene, const char *list)
{
    size_t size = 0;
    assert_int_equal(luxel_scene_list_size(scene, list, NULL, &size), LUXEL_OK);
    return size;
}

static void test_false_shrinks(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 5; seed++) {
        char *report = run(&(struct tester_options){.seed = seed * 1000, .scenes = 20, .only = "never-bright"}, 1);
        char *text = scene_in(report);
        luxel_scene *scene = NULL;
        unsigned columns, rows;
        assert_int_equal(luxel_scene_read_text(text, strlen(text), "report", NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        assert_int_equal(list_size(scene, "lights"), 1);
        assert_int_equal(list_size(scene, "surfaces"), 1);
        luxel_scene_resolution(scene, &columns, &rows);
        assert_true(columns <= 2 && rows <= 2); /* the only one of an odd number may be dark, being in the middle */
        assert_true(strlen(text) < 420);        /* all that is left is plain, in few digits */
        luxel_settings settings = trial_settings(LUXEL_DOUBLE);
        luxel_field *picture = trial_render(scene, &settings);
        assert_true(picture && trial_maximum(picture) > 3);
        luxel_field_free(picture);
        luxel_scene_free(scene);
        free(text);
        free(report);
    }
}

static void test_failure_repeats(void **state)
{
    (void)state;
    char *report = run(&(struct tester_options){.seed = 1, .scenes = 40}, 1);
    const char *named = strstr(report, "--seed ");
    assert_non_null(named);
    const uint64_t seed = strtoull(named + strlen("--seed "), NULL, 10);
    char *again = run(&(struct tester_options){.seed = seed, .scenes = 1, .only = "never-bright"}, 1);
    char *first = scene_in(report), *second = scene_in(again);
    assert_string_equal(first, second);
    free(first);
    free(second);
    free(again);
    free(report);
}

/* A name that is none, and a property that no scene came to, are failures. */
static void test_nothing_is_no_success(void **state)
{
    (void)state;
    free(run(&(struct tester_options){.seed = 1, .scenes = 10, .only = "no such"}, 1));
    free(run(&(struct tester_options){.seed = 1, .scenes = 0, .only = "always"}, 1));
}

enum { DRAFTS = 4000 };

/* What the drafts have of a kind, as bits. */
struct kinds {
    unsigned surfaces, models, highlights, lights, laws, patterns, falloffs, outlines, bodies, measures;
};

static void note_kinds(const struct draft *draft, struct kinds *kinds)
{
    for (size_t i = 0; i < draft->surface_count; i++) {
        const struct draft_surface_words *words = &draft->surfaces[i].words;
        kinds->surfaces |= 1U << words->type;
        kinds->models |= 1U << words->model;
        kinds->highlights |= 1U << words->highlight;
    }
    for (size_t i = 0; i < draft->light_count; i++) {
        const struct draft_light_words *words = &draft->lights[i].words;
        kinds->lights |= 1U << words->type;
        kinds->laws |= 1U << words->law;
        kinds->patterns |= 1U << words->pattern;
        kinds->falloffs |= 1U << words->falloff;
        kinds->outlines |= words->type == DRAFT_PLANAR ? 1U << words->shape : 0;
        kinds->bodies |= words->type == DRAFT_VOLUME ? 1U << words->shape : 0;
        kinds->measures |= 1U << words->measure;
    }
}

static void test_drafts_are_of_all_kinds(void **state)
{
    (void)state;
    struct kinds kinds = {0};
    unsigned legal = 0, with_grid = 0;
    for (uint64_t seed = 0; seed < DRAFTS; seed++) {
        struct choices choices = choices_of_seed(seed);
        struct draft draft;
        draft_make(&choices, DRAFT_EXTENDED_ONE_IN, &draft);
        note_kinds(&draft, &kinds);
        with_grid += draft.grid.words.columns > 0 && draft.grid.words.rows > 0;
        luxel_scene *scene = seed % 10 == 0 ? trial_scene_of(&draft) : NULL;
        legal += scene != NULL;
        luxel_scene_free(scene);
    }
    assert_true(kinds.surfaces == 3 && kinds.models == 7 && kinds.highlights == 7);
    assert_true(kinds.lights == 63 && kinds.laws == 15 && kinds.patterns == 7 && kinds.falloffs == 15);
    assert_true(kinds.outlines == 7 && kinds.bodies == 7 && kinds.measures == 7);
    assert_true(legal * 10 > DRAFTS * 19 / 20);
    assert_true(with_grid > DRAFTS / 3 && with_grid < DRAFTS * 2 / 3);
}

/* As many scenes as are asked for have an extended source: all but those with no lights or cut up, a share, or none. */
static void test_share_of_extended_sources(void **state)
{
    static const unsigned one_in[] = {0, 1, 8, DRAFT_EXTENDED_ONE_IN};
    unsigned counts[] = {0, 0, 0, 0};
    (void)state;
    for (uint64_t seed = 0; seed < DRAFTS; seed++)
        for (int i = 0; i < 4; i++) {
            struct choices choices = choices_of_seed(seed);
            struct draft draft;
            draft_make(&choices, one_in[i], &draft);
            counts[i] += draft_has_extended(&draft);
        }
    assert_true(counts[0] == 0 && counts[1] > DRAFTS * 3 / 4);
    assert_true(counts[2] > DRAFTS / 8 && counts[2] < DRAFTS / 2 && counts[3] < DRAFTS / 10);
}

static void expect_scene(const struct draft *draft)
{
    luxel_scene *scene = trial_scene_of(draft);
    assert_non_null(scene);
    luxel_scene_free(scene);
}

/* Bytes that have run out choose the simplest, which is a scene. */
static void test_drafts_of_bytes(void **state)
{
    (void)state;
    static const uint8_t bytes[64] = {3, 141, 59, 26, 53, 58, 97, 93, 23, 84, 62, 64, 33, 83, 27, 95};
    struct draft none, some;
    struct choices choices = choices_of_bytes(bytes, 0);
    draft_make(&choices, DRAFT_EXTENDED_ONE_IN, &none);
    expect_scene(&none);
    assert_int_equal(none.surface_count, 1);
    choices = choices_of_bytes(bytes, sizeof bytes);
    draft_make(&choices, DRAFT_EXTENDED_ONE_IN, &some);
    expect_scene(&some);
    assert_memory_not_equal(&none, &some, sizeof none);
}

/* Four quarter turns, and the same mirror twice, give the draft back. */
static void test_drafts_turn(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct choices choices = choices_of_seed(seed);
        struct draft draft, turned;
        draft_make(&choices, DRAFT_EXTENDED_ONE_IN, &draft);
        turned = draft;
        for (int i = 0; i < 4; i++)
            draft_turn(&turned, (struct draft_map){.xy = -1, .yx = 1});
        draft_turn(&turned, (struct draft_map){.xx = -1, .yy = 1});
        draft_turn(&turned, (struct draft_map){.xx = -1, .yy = 1});
        char *before = draft_write(&draft), *after = draft_write(&turned);
        assert_string_equal(before, after);
        free(before);
        free(after);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_false_is_caught),         cmocka_unit_test(test_false_shrinks),
        cmocka_unit_test(test_failure_repeats),         cmocka_unit_test(test_nothing_is_no_success),
        cmocka_unit_test(test_drafts_are_of_all_kinds), cmocka_unit_test(test_share_of_extended_sources),
        cmocka_unit_test(test_drafts_of_bytes),         cmocka_unit_test(test_drafts_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
