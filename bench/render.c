/* SPDX-License-Identifier: MIT */
/*
 * How fast pictures are made: every instruction set that runs here, one thread and all of them, one source and
 * sixteen, and each extended source with and without its highlight, on a sphere that fills most of an 800 x 800
 * picture.  Prints the best of several runs, in milliseconds for
 * the whole picture and in nanoseconds for each pixel on the sphere and source.  Absolute times depend on the machine
 * and what else it does; compare the rows of one run.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <luxel/luxel.h>

enum { RUNS = 15, FEW_RUNS = 5, SIDE = 800 };

static const char scene_head[] = "luxel: 1\n"
                                 "screen: {width: 500, height: 500, resolution: [800, 800]}\n"
                                 "observer: {z: 1500}\n"
                                 "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 240}]\n"
                                 "lights:\n";

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene = NULL;
    if (luxel_scene_read_text(text, strlen(text), "benchmark", NULL, &scene) != LUXEL_OK ||
        luxel_scene_commit(scene, NULL) != LUXEL_OK) {
        fputs("the scene of the benchmark has errors\n", stderr);
        exit(EXIT_FAILURE);
    }
    return scene;
}

/* A ring of point sources in front of the sphere. */
static luxel_scene *ring_of_lights(int lights)
{
    char text[8192];
    int used = snprintf(text, sizeof text, "%s", scene_head);
    for (int i = 0; i < lights; i++)
        used += snprintf(text + used, sizeof text - (size_t)used,
                         "  - {type: point, position: [%.3f, %.3f, 2500], intensity: 10}\n",
                         2000 * cos(2 * M_PI * i / lights), 2000 * sin(2 * M_PI * i / lights));
    return scene_of(text);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The best time of several runs; *pixels becomes the number of pixels on the sphere. */
static double best_time(const luxel_scene *scene, const luxel_settings *settings, int runs, size_t *pixels)
{
    double best = HUGE_VAL;
    for (int run = 0; run < runs; run++) {
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
    double best = best_time(scene, &settings, RUNS, &pixels);
    printf("%-10s  %-6s  %7s  %7d  %9.2f  %12.2f\n", set, precision == LUXEL_DOUBLE ? "double" : "single",
           threads ? "1" : "all", lights, 1e3 * best, 1e9 * best / ((double)pixels * lights));
    luxel_scene_free(scene);
}

static const char *const extended[][2] = {
    {"rectangle", "planar, rectangle: {center: [300, 400, 2200], size: [1000, 600], aim: [0, 0, 1000]}"},
    {"disk", "planar, disk: {center: [300, 400, 2200], radius: 400, aim: [0, 0, 1000]}"},
    {"box", "volume, box: {center: [300, 400, 2200], size: [600, 600, 600]}"},
    {"sphere", "volume, sphere: {center: [300, 400, 2200], radius: 400}"},
    {"cylinder", "volume, cylinder: {center: [300, 400, 2200], radius: 100, height: 1000, axis: [1, 1, 0]}"},
};

static void measure_extended(const char *set, size_t source)
{
    char text[1024];
    double times[4];
    size_t pixels;
    snprintf(text, sizeof text, "%s  - {type: %s, radiance: 10}\n", scene_head, extended[source][1]);
    luxel_scene *scene = scene_of(text);
    for (unsigned i = 0; i < 4; i++) {
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.instruction_set = set;
        settings.threads = i & 1;
        settings.quantity = i & 2 ? LUXEL_BRIGHTNESS : LUXEL_IRRADIANCE;
        times[i] = best_time(scene, &settings, FEW_RUNS, &pixels);
    }
    printf("%-10s  %-9s  %9.2f  %9.2f  %9.2f  %9.2f  %9.2f\n", set, extended[source][0], 1e3 * times[0], 1e3 * times[1],
           1e9 * times[1] / (double)pixels, 1e3 * times[2], 1e3 * times[3]);
    luxel_scene_free(scene);
}

/* By the best set alone: the others take long for the highlights. */
static void measure_all_extended(void)
{
    size_t best = 0;
    while (!luxel_instruction_set_runs(best))
        best++;
    printf(
        "\nextended sources: irradiance E, and brightness B with highlights to 1e-3 of the maximum; best of %d runs\n",
        FEW_RUNS);
    printf("%-10s  %-9s  %9s  %9s  %9s  %9s  %9s\n", "", "", "E, ms", "E, ms", "E, ns/px", "B, ms", "B, ms");
    printf("%-10s  %-9s  %9s  %9s  %9s  %9s  %9s\n", "set", "source", "all thr.", "1 thread", "1 thread", "all thr.",
           "1 thread");
    for (size_t k = 0; k < sizeof extended / sizeof extended[0]; k++)
        measure_extended(luxel_instruction_set_name(best), k);
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
    measure_all_extended();
    return 0;
}
