/* SPDX-License-Identifier: MIT */
/*
 * Any file as a cloud of points, a table or an array by its content, which lights a sphere; and as places to probe on
 * a sphere, as `luxel probe --points` reads them.
 */
#include "fuzz.h"

#include <math.h>
#include <string.h>

#include "../cli/cli.h"
#include "../cli/places.h"

enum { MOST_PROBED = 8 };

static const char scene_text[] = "luxel: 1\n"
                                 "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                                 "observer: {z: 5000}\n"
                                 "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                                 "lights: [{type: point, position: [500, 0, 2000], intensity: 10}]\n";

static void check(const luxel_place *place)
{
    const double *numbers = place->is_element ? place->position_mm : place->screen_mm;
    for (size_t i = 0; i < (place->is_element ? 3 : 2); i++)
        fuzz_must(isfinite(numbers[i]), "a place has numbers");
    if (place->is_element)
        fuzz_must(place->normal[0] != 0 || place->normal[1] != 0 || place->normal[2] != 0, "an element has a normal");
}

static void probe(const struct places *places)
{
    luxel_scene *scene;
    luxel_probes *probes;
    const size_t count = places->count < MOST_PROBED ? places->count : MOST_PROBED;
    fuzz_must(luxel_scene_read_text(scene_text, strlen(scene_text), "fuzz", NULL, &scene) == LUXEL_OK &&
                  luxel_scene_commit(scene, NULL) == LUXEL_OK,
              "the scene of the places");
    if (luxel_probe_places(scene, NULL, places->list, count, NULL, &probes) == LUXEL_OK) {
        for (size_t i = 0; i < count; i++) {
            const luxel_probe *probe = luxel_probes_get(probes, i);
            fuzz_must(!probe->has_value || (isfinite(probe->value) && probe->error >= 0), "a value is finite");
        }
        luxel_probes_free(probes);
    }
    luxel_scene_free(scene);
}

static void use_places(const uint8_t *data, size_t size)
{
    struct fuzz_file file = fuzz_open(data, size, ".csv");
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct places places = {.list = NULL};
    struct fuzz_words words;
    fuzz_listen(&words);
    int code = places_read(file.path, diagnostics, size % 2 > 0, &places);
    size_t lines = fuzz_heard(&words);
    fuzz_must(code == EXIT_DONE ? places.count > 0 : lines > 0, "there are places, or words why not");
    for (size_t i = 0; i < places.count; i++)
        check(&places.list[i]);
    if (code == EXIT_DONE)
        probe(&places);
    places_clear(&places);
    luxel_diagnostics_free(diagnostics);
    fuzz_close(&file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_use_file("luxel: 1\n"
                  "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                  "observer: {z: 5000}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                  "lights: [{type: points, file: '%s', pattern: cosine, exponent: 2, aim: [0, 0, 1000]}]\n"
                  "points: [[0, 0], [150, 0]]\n",
                  data, size, ".csv");
    use_places(data, size);
    return 0;
}
