/* SPDX-License-Identifier: MIT */
/*
 * How fast pictures are made: every instruction set that runs here, one thread and all of them, one source and
 * sixteen, on a sphere that fills most of an 800 x 800 picture.  Prints the best of several runs, in milliseconds for
 * the whole picture and in nanoseconds for each pixel on the sphere and source.  Absolute times depend on the machine
 * and what else it does; compare the rows of one run.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <luxel/luxel.h>

enum { RUNS = 15, SIDE = 800 };

static const char scene_head[] = "luxel: 1\n"
                                 "screen: {width: 500, height: 500, resolution: [800, 800]}\n"
                                 "observer: {z: 1500}\n"
                                 "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 240}]\n"
                                 "lights:\n";

/* A ring of point sources in front of the sphere. */
static luxel_scene *ring_of_lights(int lights)
{
    char text[8192];
    luxel_scene *scene = NULL;
    int used = snprintf(text, sizeof text, "%s", scene_head);
    for (int i = 0; i < lights; i++)
        used += snprintf(text + used, sizeof text - (size_t)used,
                         "  - {type: point, position: [%.3f, %.3f, 2500], intensity: 10}\n",
                         2000 * cos(2 * M_PI * i / lights), 2000 * sin(2 * M_PI * i / lights));
    if (luxel_scene_read_text(text, (size_t)used, "ring", NULL, &scene) != LUXEL_OK ||
        luxel_scene_commit(scene, NULL) != LUXEL_OK) {
        fputs("the scene of the benchmark has errors\n", stderr);
        exit(EXIT_FAILURE);
    }
    return scene;
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The best time of several runs; *pixels becomes the number of pixels on the sphere. */
static double best_time(const luxel_scene *scene, const luxel_settings *settings, size_t *pixels)
{
    double best = HUGE_VAL;
    for (int run = 0; run < RUNS; run++) {
        luxel_field *field = NULL;
        double start = seconds();
        if (luxel_render(scene, settings, NULL, &field) != LUXEL_OK)
            exit(EXIT_FAILURE);
        best = fmin(best, seconds() - start);
        *pixels = luxel_field_statistics(field)->surface_pixels;
        luxel_field_free(field);
    }
    return best;
}

static void measure(const char *set, luxel_precision precision, unsigned threads, int lights)
{
    luxel_scene *scene = ring_of_lights(lights);
    luxel_settings settings;
    size_t pixels;
    luxel_settings_init(&settings);
    settings.instruction_set = set;
    settings.precision = precision;
    settings.threads = threads;
    double best = best_time(scene, &settings, &pixels);
    printf("%-10s  %-6s  %7s  %7d  %9.2f  %12.2f\n", set, precision == LUXEL_DOUBLE ? "double" : "single",
           threads ? "1" : "all", lights, 1e3 * best, 1e9 * best / ((double)pixels * lights));
    luxel_scene_free(scene);
}

int main(void)
{
    printf("%d x %d pixels, Blinn-Phong, shininess 20, inverse-square; best of %d runs\n", SIDE, SIDE, RUNS);
    printf("%-10s  %-6s  %7s  %7s  %9s  %12s\n", "set", "values", "threads", "sources", "ms", "ns/(px*src)");
    for (size_t i = 0; luxel_instruction_set_name(i); i++) {
        const char *set = luxel_instruction_set_name(i);
        if (!luxel_instruction_set_runs(i))
            continue;
        for (int lights = 1; lights <= 16; lights *= 16)
            for (unsigned threads = 0; threads <= 1; threads++)
                measure(set, LUXEL_SINGLE, threads, lights);
        measure(set, LUXEL_DOUBLE, 1, 16);
    }
    return 0;
}
