/* SPDX-License-Identifier: MIT */
/* Clouds of point sources: the same numbers, to the last bit, as from as many sources of their own. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scenes.h"

enum { ROWS = 40 };

static const char form[] = "luxel: 1\n"
                           "screen: {width: 500, height: 500, resolution: [40, 40]}\n"
                           "observer: {z: 2500}\n"
                           "surfaces:\n"
                           "  - {type: sphere, center: [0, 0, 1000], radius: 200}\n"
                           "  - {type: sphere, center: [150, 0, 1400], radius: 60}\n"
                           "  - {type: rectangle, center: [0, 0, 700], size: [900, 900], material: {specular: 0}}\n"
                           "lights:\n"
                           "  - {type: distant, direction: [1, 1, -3], irradiance: 0.5}\n"
                           "  - {type: planar, disk: {center: [0, 0, 2200], radius: 90}, power: 3, parts: 2}\n";

/* Another light behind the cloud, or its points. */
static const char last[] =
    "  - {type: planar, rectangle: {center: [9, 0, 2100], size: [90, 80]}, power: 4, parts: 2}\n";

/* The number of the cloud. */
enum { CLOUD = 2 };

/* A file of rows: in the ending of the unit in the last place, some below the surfaces, one dark. */
static void make_rows(double rows[ROWS][4], char path[40])
{
    strcpy(path, "/tmp/luxel-points-XXXXXX");
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    for (int i = 0; i < ROWS; i++) {
        const double row[4] = {900 * sin(7.1 * i), 900 * cos(3.3 * i), 1500 + 1000 * sin(i), i % 9 ? 1 + i / 7.0 : 0};
        memcpy(rows[i], row, sizeof row);
        fprintf(file, "%.17g,%.17g,%.17g,%.17g\n", row[0], row[1], row[2], row[3]);
    }
    fclose(file);
}

static luxel_scene *scene_of_cloud(const char *path, const char *keys)
{
    char text[2048];
    luxel_scene *scene;
    snprintf(text, sizeof text, "%s  - {type: points, file: %s, %s}\n%s", form, path, keys, last);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

static luxel_scene *scene_of_points(double rows[ROWS][4], const char *keys)
{
    static char text[1 << 16];
    luxel_scene *scene;
    size_t used = (size_t)snprintf(text, sizeof text, "%s", form);
    for (int i = 0; i < ROWS; i++)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "  - {type: point, position: [%.17g, %.17g, %.17g], intensity: %.17g, %s}\n",
                                 rows[i][0], rows[i][1], rows[i][2], rows[i][3], keys);
    snprintf(text + used, sizeof text - used, "%s", last);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

static void expect_same_pictures(const luxel_scene *cloud, const luxel_scene *points, luxel_precision precision)
{
    luxel_field *first, *second;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.precision = precision;
    assert_int_equal(luxel_render(cloud, &settings, NULL, &first), LUXEL_OK);
    assert_int_equal(luxel_render(points, &settings, NULL, &second), LUXEL_OK);
    assert_string_equal(luxel_field_unit(first), luxel_field_unit(second));
    for (unsigned row = 0; row < luxel_field_rows(first); row++)
        for (unsigned column = 0; column < luxel_field_columns(first); column++) {
            double a = luxel_field_value(first, column, row), b = luxel_field_value(second, column, row);
            assert_memory_equal(&a, &b, sizeof a);
        }
    luxel_field_free(first);
    luxel_field_free(second);
}

/* One share for the cloud, which is the sum of all those of the points. */
static void expect_same_probes(const luxel_scene *cloud, const luxel_scene *points)
{
    static const double places[][2] = {{0, 0}, {100, -50}, {-180, 20}, {151, 3}, {240, 240}};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        luxel_probe *first, *second;
        assert_int_equal(luxel_probe_screen(cloud, NULL, places[i][0], places[i][1], NULL, &first), LUXEL_OK);
        assert_int_equal(luxel_probe_screen(points, NULL, places[i][0], places[i][1], NULL, &second), LUXEL_OK);
        assert_int_equal(first->share_count, CLOUD + 2);
        assert_int_equal(second->share_count, CLOUD + ROWS + 1);
        double irradiance = 0, diffuse = 0, specular = 0;
        for (size_t k = CLOUD; k < CLOUD + ROWS; k++) {
            irradiance += second->shares[k].irradiance;
            diffuse += second->shares[k].diffuse;
            specular += second->shares[k].specular;
        }
        assert_string_equal(first->shares[CLOUD].type, "points");
        assert_true(first->shares[CLOUD].irradiance == irradiance && first->shares[CLOUD].diffuse == diffuse &&
                    first->shares[CLOUD].specular == specular);
        /* the values are summed up in another order */
        assert_true(fabs(first->value - second->value) <= first->error + second->error);
        assert_true(first->pixel_value == second->pixel_value);
        luxel_probe_free(first);
        luxel_probe_free(second);
    }
}

static void as_many_points(void **state)
{
    (void)state;
    static const char *const patterns[] = {"pattern: isotropic",
                                           "pattern: lambertian",
                                           "pattern: lambertian, aim: [10, 20, 1000]",
                                           "pattern: lambertian, axis: [1, 0.3, -2]",
                                           "pattern: cosine, exponent: 2.5, aim: [0, 0, 900]",
                                           "pattern: cosine, exponent: 0"};
    static const char *const laws[] = {"attenuation: inverse-square", "attenuation: practical, k: 300",
                                       "attenuation: none"};
    double rows[ROWS][4];
    char path[40];
    make_rows(rows, path);
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
            char keys[128];
            snprintf(keys, sizeof keys, "%s, %s", patterns[i], laws[k]);
            luxel_scene *cloud = scene_of_cloud(path, keys), *points = scene_of_points(rows, keys);
            expect_same_pictures(cloud, points, LUXEL_SINGLE);
            expect_same_pictures(cloud, points, LUXEL_DOUBLE);
            expect_same_probes(cloud, points);
            luxel_scene_free(cloud);
            luxel_scene_free(points);
        }
    unlink(path);
}

static void totals(void **state)
{
    (void)state;
    double rows[ROWS][4], flux, sum = 0, middle[3] = {0}, place[3], direction[3];
    char path[40];
    make_rows(rows, path);
    luxel_scene *scene = scene_of_cloud(path, "pattern: lambertian");
    for (int i = 0; i < ROWS; i++) {
        sum += rows[i][3];
        for (int k = 0; k < 3; k++)
            middle[k] += rows[i][3] * rows[i][k];
    }
    assert_int_equal(luxel_scene_light_flux(scene, CLOUD, &flux), LUXEL_OK);
    assert_true(fabs(flux - sum * M_PI) <= 1e-13 * flux);
    assert_true(luxel_scene_light_place(scene, CLOUD, place));
    for (int k = 0; k < 3; k++)
        assert_true(fabs(place[k] - middle[k] / sum) <= 1e-12 * 2500);
    assert_true(luxel_scene_light_direction(scene, CLOUD, direction) && direction[2] == -1);
    luxel_scene_free(scene);
    scene = scene_of_cloud(path, "pattern: lambertian, aim: [0, 0, 900]");
    assert_false(luxel_scene_light_direction(scene, CLOUD, direction));
    luxel_scene_free(scene);
    unlink(path);
}

/* Dark sources stand somewhere, too. */
static void dark(void **state)
{
    (void)state;
    char path[] = "/tmp/luxel-points-XXXXXX";
    double place[3], flux;
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0 && write(descriptor, "1,2,3,0\n3,2,1,0\n", 16) == 16 && close(descriptor) == 0);
    luxel_scene *scene = scene_of_cloud(path, "attenuation: none");
    assert_true(luxel_scene_light_place(scene, CLOUD, place) && place[0] == 2 && place[1] == 2 && place[2] == 2);
    assert_true(luxel_scene_light_flux(scene, CLOUD, &flux) == LUXEL_OK && flux == 0);
    luxel_scene_free(scene);
    unlink(path);
}

/* ---- many ---- */

enum { MANY = 6000, PARTS = 3 };

/* A file with some of the rows of a large cloud. */
static void write_rows(size_t first, size_t end, char path[40])
{
    strcpy(path, "/tmp/luxel-points-XXXXXX");
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    for (size_t i = first; i < end; i++)
        fprintf(file, "%.17g,%.17g,%.17g,%.17g\n", 300 * sin(7.1 * (double)i) - 900, 400 * cos(3.3 * (double)i),
                1900 + 200 * sin((double)i), i % 9 ? 1 + (double)(i % 13) / 7 : 0);
    assert_int_equal(fclose(file), 0);
}

/* A large cloud, whose constants are not stored, is byte for byte what smaller ones are that follow each other. */
static void large(void **state)
{
    (void)state;
    static const char *const patterns[] = {"pattern: isotropic", "pattern: lambertian, aim: [10, 20, 1000]",
                                           "pattern: cosine, exponent: 2.5, axis: [1, 0.3, -2]"};
    char path[40], parts[PARTS][40], text[4096];
    write_rows(0, MANY, path);
    for (size_t i = 0; i < PARTS; i++)
        write_rows(i * MANY / PARTS, (i + 1) * MANY / PARTS, parts[i]);
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        luxel_scene *whole = scene_of_cloud(path, patterns[i]), *cut;
        size_t used = (size_t)snprintf(text, sizeof text, "%s", form);
        for (size_t k = 0; k < PARTS; k++)
            used += (size_t)snprintf(text + used, sizeof text - used, "  - {type: points, file: %s, %s}\n", parts[k],
                                     patterns[i]);
        snprintf(text + used, sizeof text - used, "%s", last);
        assert_int_equal(load(text, NULL, &cut), LUXEL_OK);
        expect_same_pictures(whole, cut, LUXEL_SINGLE);
        expect_same_pictures(whole, cut, LUXEL_DOUBLE);
        luxel_scene_free(whole);
        luxel_scene_free(cut);
    }
    for (size_t i = 0; i < PARTS; i++)
        unlink(parts[i]);
    unlink(path);
}

static bool count_down(double done, void *data)
{
    int *left = data;
    assert_true(done >= 0 && done <= 1);
    return --*left > 0;
}

/* Clustered: the same bytes by any number of threads and in probes, the allowed error, and it can be stopped. */
static void clustered(void **state)
{
    (void)state;
    char path[40];
    luxel_field *full, *first, *other;
    luxel_settings settings;
    write_rows(0, MANY, path);
    luxel_scene *scene = scene_of_cloud(path, "pattern: lambertian, aim: [10, 20, 1000]");
    luxel_settings_init(&settings);
    assert_int_equal(luxel_render(scene, &settings, NULL, &full), LUXEL_OK);
    settings.light_error = 0.05;
    settings.threads = 1;
    assert_int_equal(luxel_render(scene, &settings, NULL, &first), LUXEL_OK);
    const double maximum = luxel_field_statistics(full)->maximum.value;
    bool differs = false;
    for (unsigned threads = 1; threads <= 7; threads += 6) {
        settings.threads = threads;
        assert_int_equal(luxel_render(scene, &settings, NULL, &other), LUXEL_OK);
        for (unsigned row = 0; row < luxel_field_rows(full); row++)
            for (unsigned column = 0; column < luxel_field_columns(full); column++) {
                double value = luxel_field_value(first, column, row), truth = luxel_field_value(full, column, row);
                assert_true(luxel_field_value(other, column, row) == value);
                assert_true(fabs(value - truth) <= 0.05 * fmax(truth, maximum / 1000) + 4e-6 * maximum);
                differs = differs || value != truth;
            }
        luxel_field_free(other);
    }
    assert_true(differs);
    for (int i = -4; i <= 4; i++) {
        luxel_probe *probe;
        assert_int_equal(luxel_probe_screen(scene, &settings, i * 40.0, i * 20.0, NULL, &probe), LUXEL_OK);
        assert_true(probe->pixel_value == luxel_field_value(first, probe->column, probe->row));
        luxel_probe_free(probe);
    }
    luxel_status status = LUXEL_CANCELLED;
    for (int calls = 1; status == LUXEL_CANCELLED; calls *= 2) {
        int left = calls;
        settings.progress = count_down;
        settings.progress_data = &left;
        other = NULL;
        status = luxel_render(scene, &settings, NULL, &other);
        assert_true(status == LUXEL_OK || (status == LUXEL_CANCELLED && !other));
        luxel_field_free(other);
    }
    assert_int_equal(status, LUXEL_OK);
    luxel_field_free(full);
    luxel_field_free(first);
    luxel_scene_free(scene);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_many_points), cmocka_unit_test(totals),    cmocka_unit_test(dark),
        cmocka_unit_test(large),          cmocka_unit_test(clustered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
