/* SPDX-License-Identifier: MIT */
/*
 * The exercise as a plain loop in C, in float32, left to the compiler's own vectors; one thread.
 * Prints the best time of some runs in ms, and the maximum.  Usage: plain_sphere SIDE LIGHTS RUNS
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Not inlined, where its arrays would be thought to overlap. */
__attribute__((noinline)) static void light_row(const float *restrict x, float y, int side, float lx, float ly,
                                                float lz, float *restrict row)
{
    const float radius = 360, diffuse = 0.8F, specular = 0.5F;
    for (int i = 0; i < side; i++) {
        float below = radius * radius - x[i] * x[i] - y * y, z = sqrtf(below > 0 ? below : 0);
        float nx = x[i] / radius, ny = y / radius, nz = z / radius;
        float dx = lx - x[i], dy = ly - y, dz = lz - z, r2 = dx * dx + dy * dy + dz * dz, r = 1 / sqrtf(r2);
        dx *= r, dy *= r, dz *= r;
        float cosine = nx * dx + ny * dy + nz * dz;
        float hz = dz + 1, h = 1 / sqrtf(dx * dx + dy * dy + hz * hz), s = (nx * dx + ny * dy + nz * hz) * h;
        s = s > 0 ? s : 0;
        float s2 = s * s, s4 = s2 * s2, s16 = s4 * s4 * s4 * s4;
        row[i] += 10e6F * r * r * (diffuse * (cosine > 0 ? cosine : 0) + specular * s16 * s4);
    }
}

int main(int argc, char **argv)
{
    if (argc != 4)
        return 2;
    const int side = atoi(argv[1]), lights = atoi(argv[2]), runs = atoi(argv[3]);
    float *x = malloc((size_t)side * sizeof *x), *picture = malloc((size_t)side * (size_t)side * sizeof *picture);
    double best = HUGE_VAL;
    float maximum = 0;
    if (!x || !picture)
        return 1;
    for (int i = 0; i < side; i++)
        x[i] = ((float)i + 0.5F) / (float)side * 500 - 250;
    for (int run = 0; run < runs; run++) {
        const double start = seconds();
        for (int row = 0; row < side; row++) {
            float *line = picture + (size_t)row * (size_t)side;
            for (int i = 0; i < side; i++)
                line[i] = 0;
            for (int k = 0; k < lights; k++)
                light_row(x, -x[row], side, (float)(2000 * cos(2 * M_PI * k / lights)),
                          (float)(2000 * sin(2 * M_PI * k / lights)), 1500, line);
            for (int i = 0; i < side; i++)
                maximum = line[i] > maximum ? line[i] : maximum;
        }
        best = fmin(best, seconds() - start);
    }
    printf("%.3f %.6f\n", 1e3 * best, (double)maximum);
    return 0;
}
