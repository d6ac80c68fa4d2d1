/* SPDX-License-Identifier: MIT */
/*
 * Flat openings of luminaires with random tables, line by line to coarse tolerances, against fine integrals over arcs:
 * within both bounds, near and far, in their planes, from the side, by every law of attenuation.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "campaign.h"
#include "lamp_tables.h"
#include "scenes.h"

#include "../../src/base/vector.h"
#include "../../src/light/solid/extended.h"
#include "../../src/world/integral/opening_light.h"
#include "../../src/world/reference.h"

static void write_scene(struct randomness *random, const char *file, char *text)
{
    static const char *const laws[] = {"inverse-square", "practical, k: 700", "none",
                                       "polynomial, coefficients: [0.2, 0.1, 1]"};
    *text = 0;
    append(text,
           "luxel: 1\nunits: photometric\nobserver: {z: 5000}\n"
           "screen: {width: 400, height: 400, resolution: [8, 8]}\nsurfaces:\n"
           "  - {type: rectangle, center: [0, 0, -9000], size: [10, 10], axis: [0, 0, 1], up: [0, 1, 0]}\n"
           "lights:\n  - {type: luminaire, file: '%s', position: [0, 0, 0], interpolation: %s, attenuation: %s,",
           file, pick(random, 2) ? "angle" : "cosine", laws[pick(random, 2) ? 0 : pick(random, 4)]);
    if (pick(random, 2))
        append(text, " axis: [0, 0, -1],");
    else
        append(text, " axis: [%.3f, %.3f, %.3f],", uniform(random, -1, 1), uniform(random, -1, 1),
               uniform(random, -1, 1));
    if (pick(random, 3) > 0)
        append(text, " opening: {rectangle: {size: [%.4g, %.4g]}}}\n", logarithmic(random, 20, 1500),
               logarithmic(random, 20, 1500));
    else
        append(text, " opening: {disk: {radius: %.4g}}}\n", logarithmic(random, 20, 800));
}

/* A place near or far, beside the opening in its plane, or on a plane that it lies in; a normal likewise. */
static luxel_place random_place(struct randomness *random, const struct lx_emitter *emitter)
{
    double plane[3], axis[3];
    luxel_place place = {0};
    assert_true(lx_emitter_plane(emitter, plane, axis));
    const double far = logarithmic(random, 0.3, 30) * lx_emitter_radius(emitter);
    for (int k = 0; k < 3; k++) {
        place.position_mm[k] = far * uniform(random, -1, 1);
        place.normal[k] = pick(random, 3) == 0 ? uniform(random, -1, 1) : -place.position_mm[k] / far;
    }
    const int way = pick(random, 6);
    const double height = way < 2 ? lx_dot(axis, place.position_mm) : 0;
    for (int k = 0; k < 3; k++) {
        place.position_mm[k] -= height * axis[k];
        place.normal[k] = way == 0 ? axis[k] : place.normal[k];
    }
    return place;
}

/* How many integrals went line by line. */
struct tally {
    size_t by_lines, all;
};

static void compare(const luxel_scene *scene, const char *text, struct randomness *random, struct tally *tally)
{
    enum { ELEMENTS = 8 };
    struct lx_prepared prepared;
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
    const size_t sides = lx_item_count(&prepared.emitters);
    for (int i = 0; i < ELEMENTS * (int)sides; i++) {
        const struct lx_emitter *emitter = &prepared.emitters.items[i % (int)sides];
        const luxel_place place = random_place(random, emitter);
        const struct lx_element element = lx_element_at(&prepared, &place);
        prepared.tolerance = 1e-9;
        const struct lx_lighting fine = lx_light_directly(&prepared, &element, emitter);
        prepared.tolerance = logarithmic(random, 1e-6, 1e-1);
        const struct lx_lighting found = lx_light_directly(&prepared, &element, emitter);
        if (fine.on_element)
            continue;
        size_t parts = 0;
        const lx_bounded lines = lx_opening_light(emitter, &element, prepared.tolerance, 0, NULL, &parts);
        tally->all += fine.irradiance.value > 0;
        tally->by_lines += parts > 0 && lx_mul(emitter->radiance, lines).value == found.irradiance.value;
        if (!(fabs(found.irradiance.value - fine.irradiance.value) <= fine.irradiance.error + found.irradiance.error))
            fail_msg("%.17g +- %g at %g, %.17g +- %g, at (%.17g, %.17g, %.17g), normal %g %g %g:\n%s",
                     found.irradiance.value, found.irradiance.error, prepared.tolerance, fine.irradiance.value,
                     fine.irradiance.error, place.position_mm[0], place.position_mm[1], place.position_mm[2],
                     place.normal[0], place.normal[1], place.normal[2], text);
    }
    lx_prepared_clear(&prepared);
}

static void random_openings(void **state)
{
    struct randomness random = {0x9e6c63d0676a9a99u};
    struct tally tally = {0};
    char folder[] = "/tmp/luxel-openings-XXXXXX", file[64], *text = calloc(1, MOST_TEXT);
    (void)state;
    assert_non_null(text);
    assert_non_null(mkdtemp(folder));
    snprintf(file, sizeof file, "%s/lamp.ies", folder);
    for (int i = 0; i < scenes_to_try(12); i++) {
        luxel_scene *scene = NULL;
        write_table(&random, file, text);
        write_scene(&random, file, text);
        if (load(text, NULL, &scene) != LUXEL_OK)
            fail_msg("not a scene:\n%s", text);
        compare(scene, text, &random, &tally);
        luxel_scene_free(scene);
    }
    assert_true(tally.by_lines * 3 > tally.all * 2);
    unlink(file);
    rmdir(folder);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_openings)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
