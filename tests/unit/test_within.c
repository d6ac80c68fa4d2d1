/* SPDX-License-Identifier: MIT */
/*
 * Reflected light with an end by the clock or by a wish: bounds that are reached by then are told and hold, what was
 * not the end changes nothing, and what was ended early serves nobody who would wait for longer.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static const char text[] = "luxel: 1\nunits: photometric\nreflections: all\n"
                           "screen: {width: 3000, height: 2400, resolution: [30, 24]}\nobserver: {z: 9000}\n"
                           "surfaces:\n"
                           "  - {type: room, center: [0, 0, 0], size: [3000, 2400, 2600], "
                           "material: {model: lambert, diffuse: 0.6, over_pi: true}}\n"
                           "  - {type: box, center: [300, -900, -200], size: [700, 600, 500], rotate: [0, 30, 0], "
                           "material: {model: lambert, diffuse: 0.5, over_pi: true}}\n"
                           "lights:\n"
                           "  - {type: point, position: [-600, 900, 300], power: 4000}\n";

static const luxel_place place = {.is_element = true, .position_mm = {-500, -1200, 500}, .normal = {0, 1, 0}};

/* What was told while light was refined, and after how many bounds that is enough. */
struct asked {
    int bounds, most;
    double first, last;
    bool rises;
};

static bool goes_on(double done, void *data)
{
    (void)done;
    (void)data;
    return true;
}

static bool is_enough(double bound, void *data)
{
    struct asked *asked = data;
    if (asked->bounds == 0 && isinf(bound) && asked->first == 0)
        asked->first = bound;
    asked->rises = asked->rises || bound > asked->last;
    if (bound < asked->last)
        asked->bounds++;
    asked->last = fmin(asked->last, bound);
    return asked->bounds >= asked->most;
}

static luxel_settings settings_of(struct asked *asked, int most)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_true(settings.within == 0 && settings.enough == NULL);
    *asked = (struct asked){.most = most, .last = HUGE_VAL};
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = 3e-3;
    settings.threads = 1;
    settings.progress = goes_on;
    settings.progress_data = asked;
    return settings;
}

static luxel_probe *probe_new(const luxel_settings *settings)
{
    luxel_scene *scene;
    luxel_probe *probe;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_probe_place(scene, settings, &place, NULL, &probe), LUXEL_OK);
    luxel_scene_free(scene);
    return probe;
}

static luxel_probe *exact; /* the light as it is without an end */

static int find_exact(void **state)
{
    (void)state;
    struct asked asked;
    const luxel_settings settings = settings_of(&asked, 0);
    exact = probe_new(&settings);
    return exact->reflected_reached && exact->reflected.value > 0 ? 0 : -1;
}

static int forget_exact(void **state)
{
    (void)state;
    luxel_probe_free(exact);
    return 0;
}

static void agrees(const luxel_probe *probe)
{
    assert_true(isfinite(probe->error) && probe->error >= probe->reflected.error);
    assert_true(fabs(probe->value - exact->value) <= probe->error + exact->error);
}

/* Nothing that is not the end changes a bit. */
static void patience_changes_nothing(void **state)
{
    (void)state;
    struct asked asked;
    luxel_settings settings = settings_of(&asked, 1000);
    settings.within = 1e6;
    settings.enough = is_enough;
    luxel_probe *probe = probe_new(&settings);
    assert_true(probe->value == exact->value && probe->error == exact->error);
    assert_true(isinf(asked.first) && !asked.rises && asked.bounds >= 1 && asked.last > settings.reflected_error);
    luxel_probe_free(probe);
}

/* The first whole solution stands, with the bound that was told. */
static void a_wish_is_the_end(void **state)
{
    (void)state;
    struct asked asked;
    luxel_settings settings = settings_of(&asked, 1);
    settings.enough = is_enough;
    luxel_probe *probe = probe_new(&settings);
    agrees(probe);
    assert_false(probe->reflected_reached);
    assert_true(asked.bounds == 1 && fabs(probe->reflected.error / probe->value - asked.last) <= 1e-6 * asked.last);
    luxel_probe_free(probe);
}

/* Before there is any solution something is told at once, and holds. */
static void no_time_at_all(void **state)
{
    (void)state;
    struct asked asked;
    luxel_settings settings = settings_of(&asked, 1000);
    settings.within = 1e-9;
    luxel_probe *probe = probe_new(&settings);
    agrees(probe);
    assert_false(probe->reflected_reached);
    luxel_probe_free(probe);
    settings.within = 0;
    settings.enough = is_enough;
    asked.most = 0; /* at once */
    probe = probe_new(&settings);
    agrees(probe);
    assert_false(probe->reflected_reached);
    luxel_probe_free(probe);
}

/* Pictures and means, too; what was ended early is not what another one gets. */
static void it_is_not_kept(void **state)
{
    (void)state;
    struct asked asked;
    luxel_scene *scene;
    luxel_field *early, *late;
    luxel_balance *balance;
    luxel_settings settings = settings_of(&asked, 1000);
    settings.within = 1e-9;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_render(scene, &settings, diagnostics, &early), LUXEL_OK);
    assert_false(luxel_field_statistics(early)->reflected_reached);
    assert_true(luxel_diagnostics_count(diagnostics) > 0);
    settings.within = 0;
    settings.reflected_error = 5e-2;
    assert_int_equal(luxel_render(scene, &settings, diagnostics, &late), LUXEL_OK);
    assert_true(luxel_field_statistics(late)->reflected_reached);
    settings.within = 1e-9;
    assert_int_equal(luxel_find_balance(scene, &settings, diagnostics, &balance), LUXEL_OK);
    luxel_balance_free(balance);
    luxel_field_free(early);
    luxel_field_free(late);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

static void wrong_times_are_refused(void **state)
{
    (void)state;
    const double wrong[] = {-1, nan(""), HUGE_VAL};
    luxel_scene *scene;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct asked asked;
        luxel_settings settings = settings_of(&asked, 0);
        luxel_probe *probe;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        settings.within = wrong[i];
        assert_int_equal(luxel_probe_place(scene, &settings, &place, diagnostics, &probe), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
        assert_non_null(strstr(message, "within"));
        assert_non_null(strstr(message, "seconds"));
        free(message);
        luxel_diagnostics_free(diagnostics);
    }
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(patience_changes_nothing), cmocka_unit_test(a_wish_is_the_end),
        cmocka_unit_test(no_time_at_all),           cmocka_unit_test(it_is_not_kept),
        cmocka_unit_test(wrong_times_are_refused),
    };
    return cmocka_run_group_tests(tests, find_exact, forget_exact);
}
