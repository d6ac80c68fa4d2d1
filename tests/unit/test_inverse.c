/* SPDX-License-Identifier: MIT */
/* Least squares of a few unknowns, and fits through the public interface: numbers, words, what is refused. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "inverse/least_squares.h"
#include "scenes.h"

enum { ROWS = 20, COLUMNS = 6 };

static double draw(void)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-52 - 1.0;
}

/* A matrix whose last column is a sum of others, unless they are all independent. */
static void fill(double a[COLUMNS][ROWS], bool is_degenerate)
{
    for (int k = 0; k < COLUMNS; k++)
        for (int i = 0; i < ROWS; i++)
            a[k][i] = draw() * pow(10.0, 2 * k - 5);
    for (int i = 0; is_degenerate && i < ROWS; i++)
        a[COLUMNS - 1][i] = 3e5 * a[0][i] - 20.0 * a[2][i];
}

static void least_squares(void **state)
{
    (void)state;
    for (int trial = 0; trial < 100; trial++) {
        double a[COLUMNS][ROWS], copy[COLUMNS][ROWS], b[ROWS], right[ROWS], x[COLUMNS];
        const bool is_degenerate = trial % 2 == 1;
        struct lx_least_squares squares;
        fill(a, is_degenerate);
        for (int i = 0; i < ROWS; i++)
            right[i] = b[i] = draw();
        memcpy(copy, a, sizeof a);
        assert_true(lx_least_squares_make(COLUMNS, &squares));
        lx_least_squares_solve(&squares, copy[0], right, ROWS, NULL, true);
        assert_int_equal(lx_least_squares_rank(&squares, 1e-10), is_degenerate ? COLUMNS - 1 : COLUMNS);
        lx_least_squares_step(&squares, 0.0, 1e-10, x);
        for (int k = 0; k < COLUMNS; k++) { /* what is left is perpendicular to all columns */
            double sum = 0.0, length = 0.0;
            for (int i = 0; i < ROWS; i++) {
                double left = b[i];
                for (int j = 0; j < COLUMNS; j++)
                    left -= a[j][i] * x[j];
                sum += left * a[k][i];
                length += a[k][i] * a[k][i];
            }
            assert_true(fabs(sum) < 1e-11 * sqrt(length));
        }
        /* the covariance of independent columns is the inverse of A'A: times that it is 1 */
        for (size_t i = 0; !is_degenerate && i < COLUMNS; i++)
            for (size_t j = 0; j < COLUMNS; j++) {
                double sum = 0.0, size = 0.0;
                for (size_t k = 0; k < COLUMNS; k++) {
                    double product = 0.0;
                    for (int n = 0; n < ROWS; n++)
                        product += a[k][n] * a[j][n];
                    sum += lx_least_squares_covariance(&squares, COLUMNS, i, k) * product;
                    size += fabs(lx_least_squares_covariance(&squares, COLUMNS, i, k) * product);
                }
                assert_true(fabs(sum - (i == j)) < 1e-11 * size);
            }
        lx_least_squares_clear(&squares);
    }
}

static const char desk[] = "luxel: 1\nunits: photometric\n"
                           "screen: {width: 100, height: 100, resolution: [4, 4]}\nobserver: {z: 9000}\nsurfaces: []\n"
                           "lights: [{type: point, position: [1500, 1800, 2200], intensity: 700}]\n";
static const char *const keys[] = {"lights[0].position", "lights[0].intensity"};

static luxel_scene *committed(const char *text)
{
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(text, strlen(text), "desk", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

/* Readings below a lamp at 2.1, 1.7, 2.6 m, or above the middle of the four corners. */
static size_t measure(bool corners, luxel_place *places, double *values)
{
    const double lamp[3] = {corners ? 2000 : 2100, corners ? 1500 : 1700, 2600};
    const size_t side = corners ? 2 : 3;
    for (size_t i = 0; i < side * side; i++) {
        const double x = (double)(i % side) * (corners ? 4000 : 1500) + (corners ? 0 : 500);
        const double y = (double)(i / side) * (corners ? 3000 : 1000) + (corners ? 0 : 500);
        const double r = sqrt((x - lamp[0]) * (x - lamp[0]) + (y - lamp[1]) * (y - lamp[1]) + 1850.0 * 1850.0);
        places[i] = (luxel_place){.is_element = true, .position_mm = {x, y, 750}, .normal = {0, 0, 1}};
        values[i] = 1000.0 * 1850.0 / (r * r * r) * 1e6;
    }
    return side * side;
}

static void fits(void **state)
{
    luxel_scene *scene = committed(desk);
    luxel_settings settings;
    luxel_place places[9];
    double values[9];
    luxel_readings readings = {.places = places, .values = values, .noise = 1.0};
    luxel_fit *fit = NULL;
    (void)state;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    readings.count = measure(false, places, values);
    assert_int_equal(luxel_fit_readings(scene, &settings, &readings, keys, 2, NULL, &fit), LUXEL_OK);
    assert_true(fit->count == 4 && fit->rank == 4 && fit->dof == 5 && fit->undetermined == 0 && fit->has_converged);
    assert_true(fabs(fit->parameters[2].value - 2600) < 1e-6 && fabs(fit->parameters[3].value - 1000) < 1e-6);
    assert_string_equal(fit->parameters[1].key, "lights[0].position[1]");
    assert_string_equal(fit->parameters[1].unit, "mm");
    assert_true(fabs(fit->residuals[8]) < 1e-9 && fit->correlation[5] == 1.0);
    assert_true(luxel_scene_is_committed(luxel_fit_scene(fit)) && luxel_fit_undetermined(fit, 0, NULL, NULL) == NULL);
    luxel_fit_free(fit);

    readings.count = measure(true, places, values);
    assert_int_equal(luxel_fit_readings(scene, &settings, &readings, keys, 2, NULL, &fit), LUXEL_OK);
    char *words = luxel_fit_undetermined(fit, 0, NULL, NULL), *known = luxel_fit_determined(fit, NULL, NULL);
    assert_true(fit->rank == 3 && fit->undetermined == 1 && isnan(fit->parameters[2].value));
    assert_string_equal(words,
                        "lights[0].position[2], lights[0].intensity: only one combination of these is determined");
    assert_string_equal(known,
                        "4 readings, 3 determined: lights[0].position[0], lights[0].position[1], one combination "
                        "of lights[0].position[2], lights[0].intensity");
    luxel_text_free(words);
    luxel_text_free(known);
    luxel_fit_free(fit);
    luxel_scene_free(scene);
}

static bool stop(double done, void *data)
{
    (void)done;
    return --*(int *)data > 0;
}

static void refused(void **state)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = committed(desk);
    luxel_place places[9];
    double values[9];
    luxel_readings readings = {.places = places, .values = values, .reserved = {[1] = state}};
    luxel_settings settings;
    luxel_fit *fit = NULL;
    int calls = 5;
    readings.count = measure(false, places, values);
    assert_int_equal(luxel_fit_readings(scene, NULL, &readings, keys, 2, diagnostics, &fit), LUXEL_ERROR_ARGUMENT);
    expect_entry(diagnostics, 0, WANTED(.id = "reserved-not-null", .hint = "_init"));
    readings.reserved[1] = NULL;
    assert_int_equal(luxel_fit_readings(scene, NULL, &readings, keys, 0, diagnostics, &fit), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_fit_readings(NULL, NULL, &readings, keys, 2, diagnostics, &fit), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_fit_picture(scene, NULL, NULL, &readings, keys, 2, NULL, &fit), LUXEL_ERROR_ARGUMENT);
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.progress = stop;
    settings.progress_data = &calls;
    assert_int_equal(luxel_fit_readings(scene, &settings, &readings, keys, 2, NULL, &fit), LUXEL_CANCELLED);
    assert_null(fit);
    luxel_fit_free(NULL);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(least_squares),
        cmocka_unit_test(fits),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
