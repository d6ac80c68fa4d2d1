/* SPDX-License-Identifier: MIT */
/*
 * Scenes made from bytes, which are legal in form whatever the bytes are, with numbers from the whole legal range and
 * its edges: sources on and in surfaces, tiny and huge ones.  Pictures and probes must tell of the same light.
 */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bytes {
    const uint8_t *at, *end;
};

static unsigned next(struct bytes *bytes)
{
    return bytes->at < bytes->end ? *bytes->at++ : 0;
}

/* A number of some size: small whole ones, powers of ten, edges. */
static double number(struct bytes *bytes)
{
    static const double edges[] = {0, 1, -1, 1000, 300, 1300, 1e-3, 1e-6, 1e6, 1e9, 1e12, 1500};
    const unsigned kind = next(bytes), value = next(bytes);
    if (kind % 4 == 0)
        return edges[value % (sizeof edges / sizeof edges[0])];
    if (kind % 4 == 1)
        return (double)value * 16 - 2048;
    if (kind % 4 == 2)
        return ((double)next(bytes) - 128) * pow(10, (double)(value % 16) - 8);
    return 1000 + ((double)value - 128) * 3.0;
}

static double above(struct bytes *bytes)
{
    double value = fabs(number(bytes));
    return value > 0 ? value : 1;
}

static const char *word(struct bytes *bytes, const char *const *words, unsigned count)
{
    return words[next(bytes) % count];
}

#define WORD(bytes, ...)                                                                                               \
    word(bytes, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))

/* A light of one of the kinds that have no outline. */
static void add_light(FILE *text, struct bytes *bytes)
{
    static const char *const laws[] = {"inverse-square", "none", "practical, k: 100"};
    const unsigned kind = next(bytes) % 5;
    if (kind == 0)
        fprintf(text, "  - {type: ambient, irradiance: %.17g}\n", above(bytes));
    else if (kind == 1)
        fprintf(text, "  - {type: distant, direction: [%.17g, %.17g, -1], irradiance: %.17g}\n", number(bytes),
                number(bytes), above(bytes));
    else {
        fprintf(text, "  - {type: %s, position: [%.17g, %.17g, %.17g], intensity: %.17g, attenuation: %s",
                kind == 2 ? "spot, inner: 20, outer: 30" : "point", number(bytes), number(bytes), number(bytes),
                above(bytes), word(bytes, laws, 3));
        if (kind == 2)
            fprintf(text, ", falloff: %s}\n", WORD(bytes, "smoothstep", "squared", "linear", "hard"));
        else
            fprintf(text, ", pattern: %s}\n", WORD(bytes, "isotropic", "lambertian", "cosine, exponent: 3.5"));
    }
}

static char *make_text(struct bytes *bytes)
{
    char *made;
    size_t length;
    FILE *text = open_memstream(&made, &length);
    fuzz_must(text != NULL, "memory");
    fprintf(text, "luxel: 1\nshadows: %s\n", WORD(bytes, "points", "none"));
    fprintf(text, "screen: {width: 500, height: 500, resolution: [9, 9], sampling: %s}\n",
            WORD(bytes, "nodes", "centers"));
    fprintf(text, "observer: {z: 5000, projection: %s, view: %s}\nsurfaces:\n",
            WORD(bytes, "orthographic", "perspective"), WORD(bytes, "parallel", "observer"));
    for (unsigned i = 0, count = 1 + next(bytes) % 2; i < count; i++)
        fprintf(text,
                "  - {type: sphere, center: [%.17g, 0, 1000], radius: %.17g, material: {model: %s, diffuse: %.17g, "
                "specular: %.17g, shininess: %.17g, highlight: %s, over_pi: %s}}\n",
                i ? number(bytes) : 0, above(bytes), WORD(bytes, "blinn-phong", "phong", "lambert"),
                fabs(number(bytes)), fabs(number(bytes)), above(bytes), WORD(bytes, "plain", "gated", "cosine"),
                WORD(bytes, "true", "false"));
    fprintf(text, "lights:\n");
    for (unsigned i = 0, count = 1 + next(bytes) % 4; i < count; i++)
        add_light(text, bytes);
    fprintf(text, "points: [[0, 0], [150, %.17g]]\n", number(bytes));
    fclose(text);
    return made;
}

/* float32 pictures are within 2e-6 of their maximum, but where the exact value jumps. */
static void compare(const luxel_scene *scene)
{
    luxel_settings settings;
    luxel_field *single, *exact;
    luxel_settings_init(&settings);
    settings.threads = 1;
    if (luxel_render(scene, &settings, NULL, &single) != LUXEL_OK)
        return;
    settings.precision = LUXEL_DOUBLE;
    if (luxel_render(scene, &settings, NULL, &exact) == LUXEL_OK) {
        luxel_comparison comparison;
        unsigned far = 0;
        fuzz_must(luxel_compare(exact, single, NULL, &comparison, NULL) == LUXEL_OK, "they are of one screen");
        for (unsigned row = 0; row < luxel_field_rows(exact); row++)
            for (unsigned column = 0; column < luxel_field_columns(exact); column++)
                far += fabs(luxel_field_value(exact, column, row) - luxel_field_value(single, column, row)) >
                       1e-5 * comparison.scale + 1e-37;
        fuzz_must(far <= 8, "single and double precision show the same");
        luxel_field_free(exact);
    }
    luxel_field_free(single);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes bytes = {data, data + size};
    luxel_scene *scene;
    char *text = make_text(&bytes);
    fuzz_must(luxel_scene_read_text(text, strlen(text), "made", NULL, &scene) == LUXEL_OK, "what was made is a scene");
    if (luxel_scene_commit(scene, NULL) == LUXEL_OK)
        compare(scene);
    fuzz_use_scene(scene);
    free(text);
    return 0;
}
