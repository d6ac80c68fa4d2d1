/* SPDX-License-Identifier: MIT */
/*
 * Any file as a mesh: the first byte chooses the ending, the rest is the file, which a scene names: as the body of a
 * volume source, and as a surface that is seen and casts shadows.
 */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const endings[] = {".off", ".obj", ".ply", ".stl", ".gltf", ".glb"};
    if (size == 0)
        return 0;
    const char *ending = endings[data[0] % (sizeof endings / sizeof endings[0])];
    fuzz_use_file("luxel: 1\n"
                  "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                  "observer: {z: 5000}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                  "lights: [{type: volume, mesh: '%s', power: 5}]\n"
                  "points: [[0, 0], [150, 0]]\n",
                  data + 1, size - 1, ending);
    fuzz_use_file("luxel: 1\n"
                  "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                  "observer: {z: 5000}\n"
                  "surfaces: [{type: mesh, file: '%s', normals: smooth, rotate: [10, 20, 30]}]\n"
                  "lights: [{type: point, position: [500, 600, 4000], intensity: 5}]\n"
                  "points: [[0, 0], [150, 0]]\n",
                  data + 1, size - 1, ending);
    return 0;
}
