/* SPDX-License-Identifier: MIT */
/*
 * Light on and behind closed meshes against what needs no mesh to be known: the furnace of six shining walls, in which
 * every element of a convex body gets pi L; the inside of a closed body, where nothing arrives; a sphere of triangles,
 * whose shadow tends to that of a sphere as the square of their size.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "place.h"
#include "scenes.h"

enum { TEXT_SIZE = 3000 };

static luxel_scene *scene_of(const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    const int length = snprintf(text, sizeof text,
                                "luxel: 1\nscreen: {width: 400, height: 400, resolution: [4, 4]}\n"
                                "observer: {z: 30000}\nsurfaces: [%s]\nlights: [%s]\n",
                                surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* The irradiance of a free element, its error to *error. */
static double irradiance_at(const luxel_scene *scene, const double place_mm[3], const double normal[3], double *error)
{
    luxel_settings settings;
    luxel_probe *probe;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    assert_int_equal(luxel_probe_element(scene, &settings, place_mm, normal, NULL, &probe), LUXEL_OK);
    assert_true(probe->has_value);
    const double value = probe->value;
    *error = probe->error;
    luxel_probe_free(probe);
    return value;
}

/* An octahedron with corners on axes that are no multiples of each other, its faces outwards. */
static const double corners[6][3] = {{710, 0, 0}, {-510, 0, 0}, {0, 630, 0}, {0, -470, 0}, {0, 0, 390}, {0, 0, -830}};

/* The corners of a face, one on each axis, counter-clockwise from outside. */
static void face_of(int face, int at[3])
{
    const int x = face & 1, y = 2 + (face >> 1 & 1), z = 4 + (face >> 2 & 1);
    const bool is_mirrored = ((face ^ face >> 1 ^ face >> 2) & 1) != 0;
    at[0] = x, at[1] = is_mirrored ? z : y, at[2] = is_mirrored ? y : z;
}

static void write_octahedron(const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n6 8 0\n");
    for (int i = 0; i < 6; i++)
        fprintf(file, "%.17g %.17g %.17g\n", corners[i][0], corners[i][1], corners[i][2]);
    for (int face = 0; face < 8; face++) {
        int at[3];
        face_of(face, at);
        fprintf(file, "3 %d %d %d\n", at[0], at[1], at[2]);
    }
    assert_int_equal(fclose(file), 0);
}

/* Six walls of 4 m that shine inwards. */
static const char walls[] =
    "{type: planar, rectangle: {center: [0, 0, 2000], size: [4000, 4000], axis: [0, 0, -1]}, radiance: 10},"
    "{type: planar, rectangle: {center: [0, 0, -2000], size: [4000, 4000], axis: [0, 0, 1]}, radiance: 10},"
    "{type: planar, rectangle: {center: [0, 2000, 0], size: [4000, 4000], axis: [0, -1, 0]}, radiance: 10},"
    "{type: planar, rectangle: {center: [0, -2000, 0], size: [4000, 4000], axis: [0, 1, 0]}, radiance: 10},"
    "{type: planar, rectangle: {center: [2000, 0, 0], size: [4000, 4000], axis: [-1, 0, 0]}, radiance: 10},"
    "{type: planar, rectangle: {center: [-2000, 0, 0], size: [4000, 4000], axis: [1, 0, 0]}, radiance: 10}";

static void test_furnace(void **state)
{
    const struct place *place = *state;
    char path[64], surface[128];
    snprintf(path, sizeof path, "%s/body.off", place->folder);
    write_octahedron(path);
    snprintf(surface, sizeof surface, "{type: mesh, file: '%s'}", path);
    luxel_scene *scene = scene_of(surface, walls);
    for (int face = 0; face < 8; face++) {
        int of[3];
        double at[3], first[3], second[3], normal[3], error;
        face_of(face, of);
        for (int k = 0; k < 3; k++) {
            at[k] = 0.2 * corners[of[0]][k] + 0.5 * corners[of[1]][k] + 0.3 * corners[of[2]][k];
            first[k] = corners[of[1]][k] - corners[of[0]][k];
            second[k] = corners[of[2]][k] - corners[of[0]][k];
        }
        lx_cross(first, second, normal);
        assert_true(lx_dot(normal, at) > 0);
        const double value = irradiance_at(scene, at, normal, &error), truth = 10 * M_PI;
        if (!(fabs(value - truth) <= error && error <= 1e-8 * truth))
            fail_msg("face %d: %.17g +- %g, not %.17g", face, value, error, truth);
    }
    /* nothing comes in */
    const double inside[3] = {30, -20, 10}, up[3] = {0.3, 0.2, 1};
    double error;
    assert_true(irradiance_at(scene, inside, up, &error) == 0 && error == 0);
    luxel_scene_free(scene);
}

/* A sphere of N bands of 2N triangles and their halves, its corners on the sphere of the radius 1. */
static void write_sphere(const char *path, int bands)
{
    const int around = 2 * bands, count = 2 + (bands - 1) * around;
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n0 0 1\n", count, 2 * around * (bands - 1));
    for (int i = 1; i < bands; i++)
        for (int k = 0; k < around; k++) {
            const double theta = M_PI * i / bands, phi = 2 * M_PI * k / around;
            fprintf(file, "%.17g %.17g %.17g\n", sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
        }
    fprintf(file, "0 0 -1\n");
    for (int k = 0; k < around; k++) {
        const int next = (k + 1) % around, last = 1 + (bands - 2) * around;
        fprintf(file, "3 0 %d %d\n3 %d %d %d\n", 1 + k, 1 + next, count - 1, last + next, last + k);
        for (int i = 1; i < bands - 1; i++) {
            const int up = 1 + (i - 1) * around, down = up + around;
            fprintf(file, "3 %d %d %d\n3 %d %d %d\n", up + k, down + k, down + next, up + k, down + next, up + next);
        }
    }
    assert_int_equal(fclose(file), 0);
}

/* Under a disk that the sphere hides in part: what triangles let through beside it falls as N^-2. */
static void test_tends_to_the_sphere(void **state)
{
    const struct place *place = *state;
    static const char disk[] = "{type: planar, disk: {center: [0, 0, 2000], radius: 500}, radiance: 1}";
    static const double at[3] = {10, 20, 0}, normal[3] = {0, 0, 1};
    enum { SIZES = 3 };
    double error, off[SIZES];
    luxel_scene *scene = scene_of("{type: sphere, center: [0, 0, 1000], radius: 200}", disk);
    const double truth = irradiance_at(scene, at, normal, &error);
    luxel_scene_free(scene);
    for (int i = 0; i < SIZES; i++) {
        char path[64], surface[256];
        snprintf(path, sizeof path, "%s/sphere-%d.off", place->folder, i);
        write_sphere(path, 8 << i);
        snprintf(surface, sizeof surface,
                 "{type: mesh, file: '%s', scale: 200, rotate: [20, 30, 40], position: [0, 0, 1000]}", path);
        scene = scene_of(surface, disk);
        off[i] = irradiance_at(scene, at, normal, &error) - truth;
        luxel_scene_free(scene);
        if (!(off[i] > error)) /* what is inscribed hides less */
            fail_msg("%d bands: off by %g", 8 << i, off[i]);
    }
    for (int i = 0; i + 1 < SIZES; i++)
        if (!(off[i] / off[i + 1] > 3 && off[i] / off[i + 1] < 5.5))
            fail_msg("%d bands: %g, and %g by twice as many", 8 << i, off[i], off[i + 1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {CASE(furnace), CASE(tends_to_the_sphere)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
