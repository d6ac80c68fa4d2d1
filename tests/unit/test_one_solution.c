/* SPDX-License-Identifier: MIT */
/*
 * One solution of reflected light for all that is asked of a scene, where the settings share it: how many are made is
 * counted, numbers agree with those of solutions of their own within both bounds, and pictures keep their bytes.  And
 * what is told of the progress while one is made.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/reflect/reflected.h"
#include "scenes.h"
#include "wrapped.h"

static int made_count;

WRAPPED(luxel_status, lx_reflected_make, const struct lx_reflected_request *wish, struct lx_radiosity **made)
{
    made_count++;
    return REAL(lx_reflected_make)(wish, made);
}

static const char text[] = "luxel: 1\nunits: photometric\nreflections: all\n"
                           "screen: {width: 3000, height: 2400, resolution: [30, 24]}\nobserver: {z: 9000}\n"
                           "surfaces:\n"
                           "  - {type: rectangle, center: [0, 0, 0], size: [4000, 3000], material: {model: lambert, "
                           "diffuse: 0.7, over_pi: true}}\n"
                           "  - {type: rectangle, center: [-1500, 0, 900], size: [1800, 3000], axis: [1, 0, 0.2],\n"
                           "     material: {model: lambert, diffuse: 0.5, over_pi: true}}\n"
                           "lights:\n"
                           "  - {type: point, position: [300, 200, 900], power: 4000}\n"
                           "grids:\n"
                           "  - {center: [0, 0, 300], size: [1000, 600], n: [5, 3]}\n"
                           "points: [[700, 300], [-900, -200]]\n";

static luxel_scene *open_scene(void)
{
    luxel_scene *scene;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

/* Two points of the picture, and an element above it that looks down. */
static const luxel_place places[] = {
    {.screen_mm = {700, 300}},
    {.screen_mm = {-900, -200}},
    {.is_element = true, .position_mm = {200, 100, 600}, .normal = {0, 0, -1}},
};
enum { PLACES = sizeof places / sizeof *places };

/* Whatever may be asked of a scene. */
struct answers {
    luxel_field *field, *coarse;
    luxel_probes *probes;
    luxel_balance *balance;
    luxel_grid *grid;
    luxel_grid_extrema extrema;
    luxel_glare *glare;
    luxel_value value;
};

static void ask(const luxel_scene *scene, const luxel_settings *settings, struct answers *answers)
{
    const luxel_glare_sight sight = {.eye_mm = {0, 0, 2000}, .view = {0, 0.1, -1}};
    luxel_settings quick = *settings;
    luxel_evaluator *evaluator;
    quick.stride = 4;
    assert_int_equal(luxel_render(scene, &quick, NULL, &answers->coarse), LUXEL_OK);
    assert_int_equal(luxel_render(scene, settings, NULL, &answers->field), LUXEL_OK);
    assert_int_equal(luxel_probe_places(scene, settings, places, PLACES, NULL, &answers->probes), LUXEL_OK);
    assert_int_equal(luxel_find_balance(scene, settings, NULL, &answers->balance), LUXEL_OK);
    assert_int_equal(luxel_find_grid(scene, settings, 0, NULL, &answers->grid), LUXEL_OK);
    assert_int_equal(luxel_find_grid_extrema(scene, settings, 0, NULL, &answers->extrema), LUXEL_OK);
    assert_int_equal(luxel_find_glare(scene, settings, &sight, NULL, &answers->glare), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, settings, NULL, &evaluator), LUXEL_OK);
    luxel_evaluate_screen(evaluator, 700, 300, &answers->value, NULL);
    luxel_evaluator_free(evaluator);
}

static void forget(struct answers *answers)
{
    luxel_field_free(answers->field);
    luxel_field_free(answers->coarse);
    luxel_probes_free(answers->probes);
    luxel_balance_free(answers->balance);
    luxel_grid_free(answers->grid);
    luxel_glare_free(answers->glare);
}

static void agree(double a, double b, double error)
{
    if (!(fabs(a - b) <= error))
        fail_msg("%.12g and %.12g differ by more than %.3g", a, b, error);
}

static luxel_settings settings_of(bool shares)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_false(settings.share_reflected);
    settings.share_reflected = shares;
    settings.reflected_error = 2e-2;
    settings.threads = 2;
    return settings;
}

static void one_is_made(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene();
    const luxel_settings settings = settings_of(true);
    struct answers answers;
    made_count = 0;
    ask(scene, &settings, &answers);
    assert_int_equal(made_count, 1);
    forget(&answers);
    luxel_scene_free(scene);
}

/* Without being told to share one, places that are asked one after the other, of grids, probes and eyes, take the
 * solution that is there where it is as exact as they ask for, and so does whoever asks again. */
static void places_share_one(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene();
    const luxel_settings settings = settings_of(false);
    const luxel_glare_sight sight = {.eye_mm = {0, 0, 2000}, .view = {0, 0.1, -1}};
    luxel_alternatives *alternatives;
    luxel_grid *grid, *again;
    luxel_grid_extrema extrema;
    luxel_glare *glare;
    luxel_probe *probe;
    luxel_settings looser = settings;
    made_count = 0;
    assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &grid), LUXEL_OK);
    assert_int_equal(luxel_find_grid_extrema(scene, &settings, 0, NULL, &extrema), LUXEL_OK);
    assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &again), LUXEL_OK);
    assert_int_equal(made_count, 1);
    assert_true(grid->average.value == again->average.value);
    looser.reflected_error = 0.5;
    assert_int_equal(luxel_probe_place(scene, &looser, &places[2], NULL, &probe), LUXEL_OK);
    assert_int_equal(luxel_find_glare(scene, &looser, &sight, NULL, &glare), LUXEL_OK);
    assert_int_equal(made_count, 1);
    assert_true(probe->reflected_reached && probe->reflected.value > 0);
    luxel_glare_free(glare);
    luxel_grid_free(grid);
    luxel_grid_free(again);
    luxel_probe_free(probe);
    looser = settings;
    looser.skip_reflected_pixels = true;
    made_count = 0;
    assert_int_equal(luxel_probe_place(scene, &looser, &places[0], NULL, &probe), LUXEL_OK);
    const int own = made_count;
    assert_int_equal(luxel_find_alternatives(scene, &settings, 700, 300, NULL, &alternatives), LUXEL_OK);
    size_t other = 0;
    for (size_t i = 0; i < alternatives->count; i++)
        other += !alternatives->list[i].is_present && strstr(alternatives->list[i].assignment, "none") == NULL;
    assert_true(other > 0);
    assert_int_equal(made_count, own + (int)other);
    luxel_alternatives_free(alternatives);
    luxel_probe_free(probe);
    luxel_scene_free(scene);
}

/* Whoever comes first makes it: each question by itself leaves it for the picture. */
static void anyone_makes_it(void **state)
{
    (void)state;
    const luxel_settings settings = settings_of(true);
    for (int first = 0; first < 3; first++) {
        luxel_scene *scene = open_scene();
        luxel_probe *probe = NULL;
        luxel_balance *balance = NULL;
        luxel_grid *grid = NULL;
        luxel_field *field;
        made_count = 0;
        if (first == 0)
            assert_int_equal(luxel_probe_place(scene, &settings, &places[2], NULL, &probe), LUXEL_OK);
        else if (first == 1)
            assert_int_equal(luxel_find_balance(scene, &settings, NULL, &balance), LUXEL_OK);
        else
            assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &grid), LUXEL_OK);
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        assert_int_equal(made_count, 1);
        luxel_probe_free(probe);
        luxel_balance_free(balance);
        luxel_grid_free(grid);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

static void numbers_agree(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene(), *other = open_scene();
    const luxel_settings shared = settings_of(true);
    luxel_settings own = settings_of(false);
    struct answers a, b;
    ask(scene, &shared, &a);
    own.reflected_error = 1e-3; /* solutions that are made for each question, more exact ones */
    made_count = 0;
    ask(other, &own, &b);
    assert_true(made_count > 1);
    for (size_t i = 0; i < PLACES; i++) {
        assert_true(luxel_probes_get(a.probes, i)->has_reflected && luxel_probes_get(a.probes, i)->reflected.value > 0);
        assert_true(luxel_probes_get(a.probes, i)->error < 0.1 * luxel_probes_get(a.probes, i)->value);
        agree(luxel_probes_get(a.probes, i)->value, luxel_probes_get(b.probes, i)->value,
              luxel_probes_get(a.probes, i)->error + luxel_probes_get(b.probes, i)->error);
        assert_true(luxel_probes_get(a.probes, i)->reflected_reached ==
                    (luxel_probes_get(a.probes, i)->reflected.error <= 2e-2 * luxel_probes_get(a.probes, i)->value));
    }
    for (size_t i = 0; i < a.balance->side_count; i++)
        agree(a.balance->sides[i].irradiance.value, b.balance->sides[i].irradiance.value,
              a.balance->sides[i].irradiance.error + b.balance->sides[i].irradiance.error);
    assert_true(a.balance->closes);
    agree(a.grid->average.value, b.grid->average.value, a.grid->reflected_error + b.grid->reflected_error);
    agree(a.extrema.maximum.value, b.extrema.maximum.value, a.extrema.maximum.error + b.extrema.maximum.error);
    agree(a.glare->background.value, b.glare->background.value, a.glare->background.error + b.glare->background.error);
    forget(&a);
    forget(&b);
    luxel_scene_free(scene);
    luxel_scene_free(other);
}

/* Pictures and evaluators are the same either way, bit for bit. */
static void pictures_are_the_same(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene(), *other = open_scene();
    const luxel_settings shared = settings_of(true), own = settings_of(false);
    struct answers a, b;
    ask(scene, &shared, &a);
    ask(other, &own, &b);
    const size_t bytes = sizeof(float) * luxel_field_columns(a.field) * luxel_field_rows(a.field);
    assert_memory_equal(luxel_field_single(a.field), luxel_field_single(b.field), bytes);
    assert_true(a.value.value == b.value.value && a.value.error == b.value.error);
    assert_true(luxel_probes_get(a.probes, 0)->pixel_value == luxel_probes_get(b.probes, 0)->pixel_value);
    forget(&a);
    forget(&b);
    luxel_scene_free(scene);
    luxel_scene_free(other);
}

/* ---- progress ---- */

/* Without its pixel a point of the screen is asked as the free element at its place is: by one solution. */
static void pixels_are_skipped(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene();
    luxel_settings settings = settings_of(false);
    luxel_probe *with, *seen, *element, *shared;
    made_count = 0;
    assert_int_equal(luxel_probe_place(scene, &settings, places, NULL, &with), LUXEL_OK);
    assert_true(with->has_pixel_value && made_count > 0);
    luxel_scene *other = open_scene();
    made_count = 0;
    settings.skip_reflected_pixels = true;
    assert_int_equal(luxel_probe_place(other, &settings, places, NULL, &seen), LUXEL_OK);
    assert_int_equal(made_count, 1);
    assert_true(seen->has_pixel && !seen->has_pixel_value && seen->column == with->column && seen->row == with->row);
    assert_int_equal(luxel_probe_element(other, &settings, seen->position_mm, seen->normal, NULL, &element), LUXEL_OK);
    assert_int_equal(made_count, 1); /* that one serves */
    agree(seen->value, element->value, 1e-12 * element->value);
    agree(seen->value, with->value, seen->error + with->error);
    settings.share_reflected = true;
    assert_int_equal(luxel_probe_place(other, &settings, places, NULL, &shared), LUXEL_OK);
    assert_int_equal(made_count, 2);
    assert_true(shared->has_pixel_value && shared->pixel_value == with->pixel_value);
    luxel_probe_free(with);
    luxel_probe_free(seen);
    luxel_probe_free(element);
    luxel_probe_free(shared);
    luxel_scene_free(scene);
    luxel_scene_free(other);
}

/* ---- another camera ---- */

/* A copy that another observer sees takes the solution for its pictures and exact values, within their bounds; one
 * whose light is another, and whoever shares none, makes one of his own. */
static void cameras_share_one(void **state)
{
    (void)state;
    static const char *const camera[] = {"observer={position: [2500, -1500, 6000], target: [0, 0, 300]}",
                                         "screen={width: 2600, height: 1950, resolution: [24, 18]}"};
    static const char *const light = "lights[0].power=5000";
    const luxel_settings shared = settings_of(true), own = settings_of(false);
    luxel_scene *scene = open_scene();
    luxel_field *field, *seen, *exact;
    luxel_evaluator *evaluator;
    luxel_value value;
    assert_int_equal(luxel_render(scene, &shared, NULL, &field), LUXEL_OK);
    luxel_field_free(field);
    luxel_scene *copy = luxel_scene_copy(scene), *other = luxel_scene_copy(scene);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(luxel_scene_set(copy, camera[i], NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_set(other, camera[i], NULL), LUXEL_OK);
    }
    assert_int_equal(luxel_scene_set(other, light, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(copy, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(other, NULL), LUXEL_OK);
    made_count = 0;
    assert_int_equal(luxel_render(copy, &shared, NULL, &seen), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(copy, &shared, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(made_count, 0);
    assert_int_equal(luxel_render(copy, &own, NULL, &exact), LUXEL_OK);
    assert_int_equal(made_count, 1);
    assert_int_equal(luxel_render(other, &shared, NULL, &field), LUXEL_OK);
    assert_int_equal(made_count, 2);
    const luxel_statistics *a = luxel_field_statistics(seen), *b = luxel_field_statistics(exact);
    const double most = b->maximum.value * (a->reflected_error + b->reflected_error + 4e-6);
    assert_true(a->reflected_error > 0 && a->reflected_error < 0.2);
    for (size_t i = 0; i < 24 * 18; i++)
        agree((double)luxel_field_single(seen)[i], (double)luxel_field_single(exact)[i], most);
    luxel_evaluate_screen(evaluator, 300, -200, &value, NULL);
    assert_true(value.has_value && value.error > 0 && value.error < 0.2 * value.value);
    luxel_evaluator_free(evaluator);
    luxel_field_free(field);
    luxel_field_free(seen);
    luxel_field_free(exact);
    luxel_scene_free(scene);
    luxel_scene_free(copy);
    luxel_scene_free(other);
}

struct told {
    double last;
    int steps; /* while the solution is made, which is most of the work */
    bool falls;
};

static bool note(double done, void *data)
{
    struct told *told = data;
    told->falls = told->falls || done < told->last;
    told->steps += done > told->last && done < 0.95;
    told->last = done;
    return true;
}

static void progress_rises(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene();
    luxel_settings settings = settings_of(false);
    luxel_field *field;
    struct told told = {0};
    settings.reflected_error = 1e-4;
    settings.progress = note;
    settings.progress_data = &told;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    luxel_field_free(field);
    assert_false(told.falls);
    assert_true(told.steps > 5);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_is_made),           cmocka_unit_test(anyone_makes_it),    cmocka_unit_test(numbers_agree),
        cmocka_unit_test(pictures_are_the_same), cmocka_unit_test(pixels_are_skipped), cmocka_unit_test(progress_rises),
        cmocka_unit_test(places_share_one),      cmocka_unit_test(cameras_share_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
