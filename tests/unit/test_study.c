/* SPDX-License-Identifier: MIT */
/* Studies: the generator against its authors' numbers, and scenes of a maker against those made by assignments. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scenes.h"
#include "study/random.h"

/* The known answers of Random123, kat_vectors, "philox4x32 10". */
static void generator(void **state)
{
    (void)state;
    static const struct {
        uint32_t counter[4], key[2], words[4];
    } cases[] = {
        {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
         {0xffffffff, 0xffffffff},
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
         {0xa4093822, 0x299f31d0},
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint32_t words[4];
        lx_philox(cases[i].counter, cases[i].key, words);
        assert_memory_equal(words, cases[i].words, sizeof words);
    }
    assert_true(lx_draw(0, 0, 0, 0) == (double)((UINT64_C(0xe169c58d) << 32 | 0x6627e8d5) >> 11) * 0x1p-53);
    assert_true(lx_draw(0, 0, 0, 1) == (double)((UINT64_C(0x9b00dbd8) << 32 | 0xbc57ac4c) >> 11) * 0x1p-53);
}

static luxel_study *read_study(const char *text)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_study *study = NULL;
    luxel_status status = luxel_study_read_text(text, strlen(text), "study", diagnostics, &study);
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
        print_error("%s\n", message);
        luxel_text_free(message);
    }
    luxel_diagnostics_free(diagnostics);
    assert_int_equal(status, LUXEL_OK);
    return study;
}

static luxel_field *picture_of(const luxel_scene *scene)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.threads = 1;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

/* Numbers, words, whole numbers and truth values in any order of scenes give the pictures of scenes read anew. */
static void makers_agree(void **state)
{
    (void)state;
    luxel_study *study = read_study(
        "study: 1\nscene: all-sources\nset: ['screen.resolution=[30, 20]', 'screen.width=600', 'screen.height=400']\n"
        "count: 12\nvary:\n"
        "  - {key: 'surfaces[0].material.shininess', random: log, from: 2, to: 300}\n"
        "  - {key: 'surfaces[0].material.model', random: choice, values: [phong, lambert, blinn-phong]}\n"
        "  - {key: 'lights[0].enabled', random: choice, values: [true, false]}\n"
        "  - {key: 'surfaces[0].material.diffuse', from: 0, to: 1, steps: 3}\n");
    assert_true(luxel_study_count(study) == 36);
    luxel_study_maker *maker = NULL;
    assert_int_equal(luxel_study_maker_new(study, NULL, &maker), LUXEL_OK);
    for (uint64_t k = 0; k < 36; k += 5) {
        const uint64_t i = 35 - k;
        const luxel_scene *quick = NULL;
        luxel_scene *slow = NULL;
        char *text = NULL;
        assert_int_equal(luxel_study_make(maker, i, NULL, &quick), LUXEL_OK);
        assert_int_equal(luxel_study_scene(study, i, NULL, &slow), LUXEL_OK);
        luxel_field *one = picture_of(quick), *other = picture_of(slow);
        assert_memory_equal(luxel_field_single(one), luxel_field_single(other), 600 * sizeof(float));
        /* a scene whose text is behind tells nothing wrong */
        assert_int_equal(luxel_scene_write_text(quick, &text), LUXEL_ERROR_ARGUMENT);
        assert_null(luxel_scene_copy(quick));
        assert_null(luxel_field_scene(one));
        assert_non_null(luxel_field_scene(other));
        luxel_field_free(one);
        luxel_field_free(other);
        luxel_scene_free(slow);
    }
    luxel_study_maker_free(maker);
    luxel_study_free(study);
}

/* What a single value, a rule of a mapping or the scene as a whole forbids is found by the quick way as by the other,
 * and the maker goes on afterwards. */
static void makers_refuse(void **state)
{
    (void)state;
    static const char *const studies[] = {
        "study: 1\nscene: spot\nvary: [{key: 'lights[0].inner', values: [3, 8, 5]}]",
        "study: 1\nvary: [{key: observer.z, values: [1500, 1200, 1600]}]",
        "study: 1\nvary: [{key: screen.width, values: [500, 300, 500]}]",
        ("study: 1\nscene: spot\nset: ['lights[0].aim=[0, 0, 0]']\nvary: [{key: 'lights[0].aim', values: [[0, 0, 5], "
         "[0, 0, 0], [0, 0, 7]]}, {key: 'lights[0].position', values: [[0, 0, 0]]}]"),
    };
    for (size_t s = 0; s < sizeof studies / sizeof studies[0]; s++) {
        const char *text = studies[s];
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_study *study = NULL;
        luxel_study_maker *maker = NULL;
        const luxel_scene *scene = NULL;
        assert_int_equal(luxel_study_read_text(text, strlen(text), "study", diagnostics, &study), LUXEL_OK);
        assert_int_equal(luxel_study_maker_new(study, NULL, &maker), LUXEL_OK);
        for (uint64_t i = 0; i < 3; i++) {
            luxel_scene *slow = NULL;
            const luxel_status expected = luxel_study_scene(study, i, NULL, &slow);
            luxel_diagnostics_clear(diagnostics);
            assert_int_equal(luxel_study_make(maker, i, diagnostics, &scene), expected);
            assert_int_equal(expected, i == 1 ? LUXEL_ERROR_SCENE : LUXEL_OK);
            assert_int_equal(luxel_diagnostics_count(diagnostics) > 0, i == 1);
            luxel_scene_free(slow);
        }
        luxel_study_maker_free(maker);
        luxel_study_free(study);
        luxel_diagnostics_free(diagnostics);
    }
}

static void identities(void **state)
{
    (void)state;
    luxel_study *one =
        read_study("study: 1\ncount: 5\nvary: [{key: observer.z, random: uniform, from: 1500, to: 1600}]");
    luxel_study *same =
        read_study("# words\nstudy: 1\nvary: [{key: observer.z, random: uniform, from: 1.5e3, to: 1600}]\ncount: 5");
    luxel_study *other =
        read_study("study: 1\ncount: 6\nvary: [{key: observer.z, random: uniform, from: 1500, to: 1600}]");
    char *a = luxel_study_identity(one), *b = luxel_study_identity(same), *c = luxel_study_identity(other);
    assert_string_equal(a, b);
    assert_string_not_equal(a, c);
    luxel_text_free(a);
    luxel_text_free(b);
    luxel_text_free(c);
    luxel_study_free(one);
    luxel_study_free(same);
    luxel_study_free(other);
}

/* A sphere from above: depths and normals by hand. */
static void geometry(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[5, 5]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    double depth[25], normals[25][3];
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &(luxel_geometry){.depth_mm = depth, .normals = normals}),
                     LUXEL_OK);
    for (int row = 0; row < 5; row++)
        for (int column = 0; column < 5; column++) {
            const double x = -250 + 125 * column, y = 250 - 125 * row, left = 300 * 300 - x * x - y * y;
            const double *normal = normals[5 * row + column];
            const double z = left > 0 ? sqrt(left) : 0;
            assert_true(fabs(depth[5 * row + column] - (left > 0 ? 500 - z : 0)) < 1e-9);
            assert_true(fabs(normal[0] - (left > 0 ? x / 300 : 0)) < 1e-12);
            assert_true(fabs(normal[1] - (left > 0 ? y / 300 : 0)) < 1e-12);
            assert_true(fabs(normal[2] - z / 300) < 1e-12);
        }
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(generator),  cmocka_unit_test(makers_agree), cmocka_unit_test(makers_refuse),
        cmocka_unit_test(identities), cmocka_unit_test(geometry),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
