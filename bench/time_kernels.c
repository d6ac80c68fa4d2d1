/* SPDX-License-Identifier: MIT */
/*
 * Times each kernel: time_kernels [THREADS].  Whole pictures of a sphere under lights of one kind, with each
 * instruction set that runs here and that LUXEL_ISA allows, by one thread and by THREADS (0, the default: all), as
 * JSON; beside what the machine could do at best.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "machine.h"

enum { SIDE = 800, STRIP = 6000, NARROW = 60, MANY = 16, LEAST_RUNS = 3, MOST_RUNS = 400 };

/* How long one measurement goes on at least. */
static const double LEAST_SECONDS = 0.15;

/* How the sphere is seen. */
enum bench_view {
    FROM_AFAR, /* by parallel lines of sight */
    IN_PERSPECTIVE,
    IN_A_STRIP, /* as many pixels, but so few rows of them that no polynomials take the place of lights */
    NOT_ALONE,  /* with a small sphere beside the picture, which may throw shadows */
};

/*
 * A case is a sphere that fills the picture, under so many equal lights on a ring.  `operations` are the
 * vector operations that the kernel needs for a vector of elements and a light (docs/KERNELS.md counts them); 0: not
 * counted, as it depends on the elements.
 */
struct bench_case {
    const char *id;
    const char *light; /* a line of the list of lights, x and y left open */
    const char *material;
    unsigned lights, operations;
    luxel_quantity quantity;
    unsigned points;    /* that each light is cut into */
    double light_error; /* allowed for taking them together */
    enum bench_view view;
};

#define LIGHT(words) "  - {type: " words "}\n"
#define POINT(words) LIGHT("point, position: [%.3f, %.3f, 2500], intensity: 10" words)
#define PLANAR(outline) LIGHT("planar, radiance: 10, " outline ", aim: [0, 0, 1000]}")
#define VOLUME(body) LIGHT("volume, radiance: 10, " body "}")
#define RECTANGLE PLANAR("rectangle: {center: [%.3f, %.3f, 2500], size: [1000, 600]")
#define DISK PLANAR("disk: {center: [%.3f, %.3f, 2500], radius: 400")
#define BOX VOLUME("box: {center: [%.3f, %.3f, 2500], size: [600, 600, 600]")
#define BALL VOLUME("sphere: {center: [%.3f, %.3f, 2500], radius: 400")
#define TUBE VOLUME("cylinder: {center: [%.3f, %.3f, 2500], radius: 100, height: 1000, axis: [1, 1, 0]")

static const struct bench_case cases[] = {
    {"point", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"one-point", POINT(""), "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-perspective", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0, IN_PERSPECTIVE},
    {"point-by-pixel", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0, IN_A_STRIP},
    {"point-beside", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {"point-any-exponent", POINT(""), "shininess: 20.5", MANY, 71, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-phong", POINT(""), "model: phong", MANY, 42, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-lambert", POINT(""), "model: lambert", MANY, 19, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-none", POINT(", attenuation: none"), "shininess: 20", MANY, 39, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-practical", POINT(", attenuation: practical, k: 300"), "shininess: 20", MANY, 45, LUXEL_BRIGHTNESS, 1, 0,
     FROM_AFAR},
    {"point-polynomial", POINT(", attenuation: polynomial, coefficients: [1, 0.1, 0.2]"), "shininess: 20", MANY, 48,
     LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"point-lambertian", POINT(", pattern: lambertian, aim: [0, 0, 1000]"), "shininess: 20", MANY, 50, LUXEL_BRIGHTNESS,
     1, 0, FROM_AFAR},
    {"spot", LIGHT("spot, position: [%.3f, %.3f, 2500], intensity: 10, aim: [0, 0, 1000], inner: 10, outer: 20"),
     "shininess: 20", MANY, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"distant", LIGHT("distant, direction: [%.3f, %.3f, -2000], irradiance: 1"), "shininess: 20", MANY, 27,
     LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"rectangle", RECTANGLE, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {"rectangle-highlight", RECTANGLE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"rectangle-highlight-beside", RECTANGLE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {"disk", DISK, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {"disk-highlight", DISK, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"disk-highlight-beside", DISK, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {"box", BOX, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {"box-highlight", BOX, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"ball", BALL, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {"ball-highlight", BALL, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"ball-highlight-beside", BALL, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {"tube", TUBE, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {"tube-highlight", TUBE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {"tube-highlight-beside", TUBE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {"many-points",
     LIGHT("planar, radiance: 10, rectangle: {center: [%.3f, %.3f, 2500], size: [120, 120], aim: [0, 0, 1000]}, "
           "parts: 64"),
     "shininess: 20", MANY, 0, LUXEL_BRIGHTNESS, 64 * 64, 0.01, FROM_AFAR},
};

/* The best of some runs, in seconds. */
static double best_time(const luxel_scene *scene, const luxel_settings *settings, size_t *pixels)
{
    const double start = machine_seconds();
    double best_s = HUGE_VAL;
    for (int run = 0; run < MOST_RUNS && (run < LEAST_RUNS || machine_seconds() - start < LEAST_SECONDS); run++) {
        luxel_field *field = NULL;
        const double begin = machine_seconds();
        if (luxel_render(scene, settings, NULL, &field) != LUXEL_OK)
            exit(1);
        best_s = fmin(best_s, machine_seconds() - begin);
        *pixels = luxel_field_statistics(field)->surface_pixels;
        luxel_field_free(field);
    }
    return best_s;
}

static luxel_scene *scene_of(const struct bench_case *each)
{
    char text[MANY * 256];
    luxel_scene *scene = NULL;
    const bool is_strip = each->view == IN_A_STRIP;
    const int columns = is_strip ? STRIP : SIDE, rows = is_strip ? NARROW : SIDE;
    size_t used = (size_t)snprintf(
        text, sizeof text,
        "luxel: 1\n"
        "screen: {width: 500, height: %g, resolution: [%d, %d]}\n"
        "observer: {z: 1500, projection: %s}\n"
        "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 360, material: {%s}}%s]\n"
        "lights:\n",
        500.0 * rows / columns, columns, rows, each->view == IN_PERSPECTIVE ? "perspective" : "orthographic",
        each->material, each->view == NOT_ALONE ? ", {type: sphere, center: [1500, 0, 1000], radius: 5}" : "");

    for (unsigned i = 0; i < each->lights; i++) {
        const double x = 2000 * cos(2 * M_PI * i / each->lights), y = 2000 * sin(2 * M_PI * i / each->lights);
        used += (size_t)snprintf(text + used, sizeof text - used, each->light, x, y);
    }
    if (luxel_scene_read_text(text, used, "bench", NULL, &scene) != LUXEL_OK ||
        luxel_scene_commit(scene, NULL) != LUXEL_OK)
        exit(1);
    return scene;
}

static void print_number(const char *key, double number)
{
    if (isfinite(number))
        printf("\"%s\": %.17g", key, number);
    else
        printf("\"%s\": null", key);
}

/* Measures a case with an instruction set; prints it as a row. */
static void measure(const struct bench_case *each, const luxel_scene *scene, const char *set, double products,
                    unsigned threads)
{
    luxel_settings settings;
    size_t pixels = 0;
    luxel_settings_init(&settings);
    settings.instruction_set = set;
    settings.quantity = each->quantity;
    settings.light_error = each->light_error;
    settings.threads = threads;
    const double together_s = best_time(scene, &settings, &pixels);
    settings.threads = 1;
    const double alone_s = threads == 1 ? together_s : best_time(scene, &settings, &pixels);
    const size_t lights = (size_t)each->lights * each->points;
    const double ns = 1e9 / ((double)pixels * (double)lights);
    /* an operation on a whole vector takes as long as a product and sum */
    const double floor_ns = each->operations > 0 ? 1e9 * each->operations / products : (double)NAN;
    printf("{\"case\": \"%s\", \"instruction_set\": \"%s\", \"lights\": %zu, \"pixels\": %zu, ", each->id, set, lights,
           pixels);
    const struct {
        const char *key;
        double number;
    } numbers[] = {
        {"one_thread_ms", 1e3 * alone_s}, {"all_threads_ms", 1e3 * together_s},
        {"one_thread_ns", ns * alone_s},  {"all_threads_ns", ns * together_s},
        {"floor_ns", floor_ns},           {"times_floor", ns * alone_s / floor_ns},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        fputs(i > 0 ? ", " : "", stdout);
        print_number(numbers[i].key, numbers[i].number);
    }
    fputs("}", stdout);
}

/* The instruction sets that run here, the best first, or the one that LUXEL_ISA means. */
static size_t find_sets(const char *sets[], size_t most)
{
    const char *asked = getenv("LUXEL_ISA"), *chosen = luxel_instruction_set_chosen(NULL);
    size_t count = 0;
    for (size_t i = 0; luxel_instruction_set_name(i) && count < most; i++) {
        const char *name = luxel_instruction_set_name(i);
        const bool is_meant = !asked || !asked[0] || (chosen && strcmp(chosen, name) == 0);
        if (luxel_instruction_set_runs(i) && is_meant)
            sets[count++] = name;
    }
    return count;
}

int main(int argc, char **argv)
{
    enum { MOST_SETS = 8 };
    const char *sets[MOST_SETS];
    double products[MOST_SETS];
    const unsigned threads = argc > 1 ? (unsigned)strtoul(argv[1], NULL, 10) : 0;
    const size_t set_count = find_sets(sets, MOST_SETS);
    if (argc > 2 || set_count == 0) {
        fputs(argc > 2 ? "usage: time_kernels [THREADS]\n" : "no such instruction set\n", stderr);
        return 2;
    }
    fputs("{\"machine\": {", stdout);
    print_number("copied_bytes_per_second", machine_copied_bytes_per_second());
    fputs(", \"instruction_sets\": [", stdout);
    for (size_t i = 0; i < set_count; i++) {
        products[i] = machine_products_per_second(sets[i]);
        printf("%s{\"name\": \"%s\", ", i > 0 ? ", " : "", sets[i]);
        print_number("products_per_second", products[i]);
        fputs("}", stdout);
    }
    printf("]},\n\"threads\": %u, \"timings\": [\n", threads);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        luxel_scene *scene = scene_of(&cases[c]);
        for (size_t i = 0; i < set_count; i++) {
            fputs(c + i > 0 ? ",\n" : "", stdout);
            measure(&cases[c], scene, sets[i], products[i], threads);
        }
        luxel_scene_free(scene);
    }
    puts("]}");
    return 0;
}
