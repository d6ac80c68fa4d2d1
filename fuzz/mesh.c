/* SPDX-License-Identifier: MIT */
/*
 * Any file as the mesh of a volume source: the first byte chooses OFF or OBJ, the rest is the file, which a scene
 * names.  Where it is a body, the sphere beside it is lit by it.
 */
#include "fuzz.h"

#include <stdio.h>
#include <string.h>

static const char scene_text[] = "luxel: 1\n"
                                 "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                                 "observer: {z: 5000}\n"
                                 "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                                 "lights: [{type: volume, mesh: '%s', power: 5}]\n"
                                 "points: [[0, 0], [150, 0]]\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char text[sizeof scene_text + 64];
    luxel_scene *scene;
    if (size == 0)
        return 0;
    struct fuzz_file file = fuzz_open(data + 1, size - 1, data[0] % 2 ? ".obj" : ".off");
    snprintf(text, sizeof text, scene_text, file.path);
    fuzz_must(luxel_scene_read_text(text, strlen(text), "fuzz", NULL, &scene) == LUXEL_OK, "the scene around it");
    fuzz_use_scene(scene);
    fuzz_close(&file);
    return 0;
}
