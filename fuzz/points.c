/* SPDX-License-Identifier: MIT */
/* Any file as a cloud of points, CSV or NPY by its content, which lights a sphere. */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_use_file("luxel: 1\n"
                  "screen: {width: 500, height: 500, resolution: [8, 8]}\n"
                  "observer: {z: 5000}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]\n"
                  "lights: [{type: points, file: '%s', pattern: cosine, exponent: 2, aim: [0, 0, 1000]}]\n"
                  "points: [[0, 0], [150, 0]]\n",
                  data, size, ".csv");
    return 0;
}
