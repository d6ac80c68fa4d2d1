/* SPDX-License-Identifier: MIT */
/* The list of parameters as forms need it: labels, types and ranges that agree with what it says in words. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static const luxel_parameter *find(const luxel_parameters *parameters, const char *path, const char *variant)
{
    const luxel_parameter *parameter;
    for (size_t i = 0; (parameter = luxel_parameters_get(parameters, i)) != NULL; i++)
        if (strcmp(parameter->path, path) == 0 &&
            (variant ? parameter->variant && strcmp(parameter->variant, variant) == 0 : !parameter->variant))
            return parameter;
    fail_msg("there is no %s", path);
    return NULL;
}

static void labels(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    const luxel_parameter *parameter;
    for (size_t i = 0; (parameter = luxel_parameters_get(parameters, i)) != NULL; i++) {
        const char *label = parameter->label;
        if (!(label && label[0] >= 'A' && label[0] <= 'Z' && strlen(label) >= 3 && strlen(label) <= 30))
            fail_msg("%s has no good label: %s", parameter->path, label ? label : "none");
    }
    assert_string_equal(find(parameters, "surfaces[].radius", "sphere")->label, "Radius");
    assert_string_equal(find(parameters, "lights[].cylinder.height", "volume")->label, "Height");
    assert_string_equal(find(parameters, "lights[].type", NULL)->label, "Type");
    luxel_parameters_free(parameters);
}

/* Keys of one mapping that go by one name could not be told apart in a form. */
static void labels_differ(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        for (size_t k = 0; k < i; k++) {
            const luxel_parameter *one = luxel_parameters_get(parameters, i);
            const luxel_parameter *other = luxel_parameters_get(parameters, k);
            const char *end = strrchr(one->path, '.');
            size_t length = end ? (size_t)(end - one->path) + 1 : 0;
            if (strncmp(one->path, other->path, length) != 0 || strchr(other->path + length, '.') ||
                strcmp(one->path, other->path) == 0)
                continue;
            bool together = !one->variant || !other->variant || strcmp(one->variant, other->variant) == 0;
            if (together && strcmp(one->label, other->label) == 0)
                fail_msg("%s and %s are both %s", one->path, other->path, one->label);
        }
    luxel_parameters_free(parameters);
}

/* The words for each type, with the count where they have one. */
static void types(void **state)
{
    (void)state;
    static const struct {
        luxel_parameter_type type;
        const char *words, *path, *variant;
        unsigned count;
    } cases[] = {
        {LUXEL_PARAMETER_NUMBER, "number", "surfaces[].radius", "sphere", 1},
        {LUXEL_PARAMETER_WHOLE_NUMBER, "whole number", "luxel", NULL, 1},
        {LUXEL_PARAMETER_YES_OR_NO, "true or false", "lights[].enabled", NULL, 1},
        {LUXEL_PARAMETER_CHOICE, "one of", "screen.sampling", NULL, 1},
        {LUXEL_PARAMETER_TEXT, "text", "lights[].mesh", "volume", 1},
        {LUXEL_PARAMETER_NUMBERS, "3 numbers", "lights[].position", "spot", 3},
        {LUXEL_PARAMETER_NUMBERS, "2 numbers", "lights[].rectangle.size", "planar", 2},
        {LUXEL_PARAMETER_WHOLE_NUMBERS, "2 whole numbers", "screen.resolution", NULL, 2},
        {LUXEL_PARAMETER_CHOICE_OR_PAIR, "one of, or [low, high]", "picture.range", NULL, 2},
        {LUXEL_PARAMETER_GROUP, "group of keys", "surfaces[].material", NULL, 1},
        {LUXEL_PARAMETER_POINTS, "list of points [x, y]", "points", NULL, 2},
        {LUXEL_PARAMETER_VECTORS, "list of 3 or more places [x, y, z]", "lights[].vertices", "planar", 3},
        {LUXEL_PARAMETER_CHOICE_OR_WHOLE, "one of, or a whole number", "lights[].parts", "volume", 1},
        {LUXEL_PARAMETER_GROUPS, "list of groups of keys", "grids", NULL, 1},
        {LUXEL_PARAMETER_VARIANTS, "list", "lights", NULL, 1},
    };
    luxel_parameters *parameters = luxel_parameters_new();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const luxel_parameter *parameter = find(parameters, cases[i].path, cases[i].variant);
        assert_int_equal(parameter->value_type, cases[i].type);
        assert_string_equal(parameter->type, cases[i].words);
        assert_int_equal(parameter->count, cases[i].count);
    }
    luxel_parameters_free(parameters);
}

static void expect_range(luxel_parameter_range range, bool given, double low, double high, bool low_open)
{
    assert_int_equal(range.given, given);
    assert_true(range.low == low && range.high == high);
    assert_int_equal(range.low_open, low_open);
}

static void ranges(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    const luxel_parameter *parameter;
    for (size_t i = 0; (parameter = luxel_parameters_get(parameters, i)) != NULL; i++) {
        assert_int_equal(parameter->legal_range.given, parameter->legal != NULL);
        for (int k = 0; k < 3; k++) {
            const luxel_parameter_range *advised = &parameter->advised_range[k], *legal = &parameter->legal_range;
            assert_int_equal(advised->given, parameter->advised != NULL);
            assert_true(!advised->given || (advised->low >= legal->low && advised->high <= legal->high));
        }
    }
    parameter = find(parameters, "lights[].position", "point");
    expect_range(parameter->legal_range, false, -HUGE_VAL, HUGE_VAL, false);
    expect_range(parameter->advised_range[0], true, -10000, 10000, false);
    expect_range(parameter->advised_range[1], true, -10000, 10000, false);
    expect_range(parameter->advised_range[2], true, 100, 10000, false);
    parameter = find(parameters, "screen.resolution", NULL);
    expect_range(parameter->legal_range, true, 1, 65536, false);
    expect_range(parameter->advised_range[1], true, 200, 800, false);
    parameter = find(parameters, "surfaces[].radius", "sphere");
    expect_range(parameter->legal_range, true, 0, HUGE_VAL, true);
    parameter = find(parameters, "lights[].type", NULL);
    expect_range(parameter->advised_range[0], false, -HUGE_VAL, HUGE_VAL, false);
    luxel_parameters_free(parameters);
}

/* Whether a number, or two of them, is said to be out of range.  What else the scene lacks does not matter. */
static bool is_out_of_range(const luxel_parameter *parameter, double value)
{
    char text[200], path[100], assignment[250], inner[50] = "";
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    bool found = false;
    const char *list = strstr(parameter->path, "[]"), *usual = parameter->path[0] == 's' ? "sphere" : "point";
    int length = list ? (int)(list - parameter->path) : 0;
    /* a list within an element, such as surfaces[].openings[].center */
    const char *within = list ? strstr(list + 2, "[]") : NULL;
    if (within) {
        snprintf(inner, sizeof inner, ", %.*s: [{}]", (int)(within - list - 3), list + 3);
        snprintf(path, sizeof path, "%.*s[0]%.*s[0]%s", length, parameter->path, (int)(within - list - 2), list + 2,
                 within + 2);
    } else {
        snprintf(path, sizeof path, "%.*s%s%s", length, parameter->path, list ? "[0]" : "",
                 list ? list + 2 : parameter->path);
    }
    if (!list)
        snprintf(text, sizeof text, "luxel: 1\n");
    else if (strncmp(parameter->path, "grids", 5) == 0 || strncmp(parameter->path, "observers", 9) == 0)
        snprintf(text, sizeof text, "luxel: 1\n%.*s: [{name: one}]\n", length, parameter->path);
    else
        snprintf(text, sizeof text, "luxel: 1\n%.*s: [{type: %s%s}]\n", length, parameter->path,
                 parameter->variant ? parameter->variant : usual, inner);
    assert_int_equal(luxel_scene_read_text(text, strlen(text), "test.yaml", NULL, &scene), LUXEL_OK);
    if (parameter->count == 2)
        snprintf(assignment, sizeof assignment, "%s=[%.17g, %.17g]", path, value, value);
    else
        snprintf(assignment, sizeof assignment, "%s=%.17g", path, value);
    assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
    luxel_scene_commit(scene, diagnostics);
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
        found = found || (strcmp(entry->id, "out-of-range") == 0 && strncmp(entry->key, path, strlen(path)) == 0);
    }
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
    return found;
}

/* Every range holds: its ends belong to it, unless they are said to be open, and what lies beyond is refused. */
static void ranges_hold(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    const luxel_parameter *parameter;
    unsigned tried = 0;
    for (size_t i = 0; (parameter = luxel_parameters_get(parameters, i)) != NULL; i++) {
        const luxel_parameter_range *range = &parameter->legal_range;
        bool whole = parameter->value_type == LUXEL_PARAMETER_WHOLE_NUMBER ||
                     parameter->value_type == LUXEL_PARAMETER_WHOLE_NUMBERS;
        if (!range->given || parameter->count > 2 || strcmp(parameter->path, "luxel") == 0 || /* the version */
            !(whole || parameter->value_type == LUXEL_PARAMETER_NUMBER ||
              parameter->value_type == LUXEL_PARAMETER_NUMBERS))
            continue;
        const double step = whole ? 1 : 1e-9;
        const struct {
            double value;
            bool refused;
        } cases[] = {
            {range->low - step, true},   {range->low, range->low_open}, {range->low + step, false},
            {range->high - step, false}, {range->high, false},          {range->high + step, true},
        };
        for (int k = 0; k < (isfinite(range->high) ? 6 : 3); k++) {
            const bool is_end = k == 1 || k == 4;
            bool may_round =
                !is_end && fabs(cases[k].value) > 1e6 * (whole ? 1e3 : 1); /* beside a large end nothing is */
            if (!may_round && is_out_of_range(parameter, cases[k].value) != cases[k].refused)
                fail_msg("%s of %s: %.17g", parameter->path, parameter->variant ? parameter->variant : "all",
                         cases[k].value);
        }
        tried++;
    }
    assert_true(tried > 25);
    luxel_parameters_free(parameters);
}

/* A language of which only one word is known. */
static const char *translate(const char *english, void *data)
{
    return strcmp(english, "Radius") == 0 ? data : english;
}

static void units(void **state)
{
    (void)state;
    static const struct {
        const char *path, *variant, *radiometric, *photometric;
    } cases[] = {
        {"lights[].intensity", "point", "W/sr", "cd"},
        {"lights[].irradiance", "distant", "W/m²", "lx"},
        {"lights[].radiance", "planar", "W/(sr·m²)", "cd/m²"},
        {"lights[].power", "planar", "W", "lm"},
        {"screen.width", NULL, "mm", "mm"},
        {"lights[].type", NULL, "", ""},
    };
    luxel_parameters *parameters = luxel_parameters_new();
    assert_non_null(parameters);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const luxel_parameter *parameter = find(parameters, cases[i].path, cases[i].variant);
        assert_string_equal(parameter->unit, cases[i].radiometric);
        assert_string_equal(parameter->photometric_unit, cases[i].photometric);
    }
    luxel_parameters_free(parameters);
}

static void translated_labels(void **state)
{
    (void)state;
    char word[] = "Радиус";
    luxel_parameters *parameters = luxel_parameters_new_translated(translate, word);
    assert_string_equal(find(parameters, "surfaces[].radius", "sphere")->label, word);
    assert_string_equal(find(parameters, "surfaces[].center", "sphere")->label, "Centre");
    luxel_parameters_free(parameters);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels),      cmocka_unit_test(labels_differ),     cmocka_unit_test(types),
        cmocka_unit_test(ranges),      cmocka_unit_test(translated_labels), cmocka_unit_test(units),
        cmocka_unit_test(ranges_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
