/* SPDX-License-Identifier: MIT */
/*
 * Any file as the mesh of a volume source: the first byte chooses OFF or OBJ, the rest is the file, which a scene
 * names.  Where it is a body, the sphere beside it is lit by it.
 */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 0)
        fuzz_use_file("luxel: 1\n"
                      "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                      "observer: {z: 5000}\n"
                      "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                      "lights: [{type: volume, mesh: '%s', power: 5}]\n"
                      "points: [[0, 0], [150, 0]]\n",
                      data + 1, size - 1, data[0] % 2 ? ".obj" : ".off");
    return 0;
}
