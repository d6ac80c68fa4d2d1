/* SPDX-License-Identifier: MIT */
/* luxel bench: how long pictures take with each instruction set, beside what the machine could do at best. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "load.h"
#include "machine.h"
#include "message.h"
#include "options.h"
#include "progress.h"
#include "text.h"

enum {
    SIDE = 800,
    STRIP = 6000,
    NARROW = 60,
    MANY = 16,
    LEAST_RUNS = 3,
    MOST_RUNS = 400,
    MOST_ROWS = 128,
    MOST_SETS = 8
};

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
 * What is measured: a sphere that fills the picture, under so many equal lights on a ring.  `operations` are the
 * vector operations that the kernel needs for a vector of elements and a light (docs/KERNELS.md counts them); 0: not
 * counted, as it depends on the elements.
 */
struct bench_case {
    const char *name, *id;
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
    {N_("point, shininess 20"), "point", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("one point alone"), "one-point", POINT(""), "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("point, in perspective"), "point-perspective", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0,
     IN_PERSPECTIVE},
    {N_("point, each pixel on its own"), "point-by-pixel", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0,
     IN_A_STRIP},
    {N_("point, a far sphere"), "point-beside", POINT(""), "shininess: 20", MANY, 41, LUXEL_BRIGHTNESS, 1, 0,
     NOT_ALONE},
    {N_("point, shininess 20.5"), "point-any-exponent", POINT(""), "shininess: 20.5", MANY, 71, LUXEL_BRIGHTNESS, 1, 0,
     FROM_AFAR},
    {N_("point, Phong"), "point-phong", POINT(""), "model: phong", MANY, 42, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("point, Lambert"), "point-lambert", POINT(""), "model: lambert", MANY, 19, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("point, no attenuation"), "point-none", POINT(", attenuation: none"), "shininess: 20", MANY, 39,
     LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("point, 1/(k + r)"), "point-practical", POINT(", attenuation: practical, k: 300"), "shininess: 20", MANY, 45,
     LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("point, 1/(kc + kl·r + kq·r²)"), "point-polynomial",
     POINT(", attenuation: polynomial, coefficients: [1, 0.1, 0.2]"), "shininess: 20", MANY, 48, LUXEL_BRIGHTNESS, 1, 0,
     FROM_AFAR},
    {N_("point, cosine pattern"), "point-lambertian", POINT(", pattern: lambertian, aim: [0, 0, 1000]"),
     "shininess: 20", MANY, 50, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("spot"), "spot",
     LIGHT("spot, position: [%.3f, %.3f, 2500], intensity: 10, aim: [0, 0, 1000], inner: 10, outer: 20"),
     "shininess: 20", MANY, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("distant"), "distant", LIGHT("distant, direction: [%.3f, %.3f, -2000], irradiance: 1"), "shininess: 20", MANY,
     27, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("rectangle, irradiance"), "rectangle", RECTANGLE, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {N_("rectangle, highlight"), "rectangle-highlight", RECTANGLE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0,
     FROM_AFAR},
    {N_("rectangle, highlight, a far sphere"), "rectangle-highlight-beside", RECTANGLE, "shininess: 20", 1, 0,
     LUXEL_BRIGHTNESS, 1, 0, NOT_ALONE},
    {N_("disk, irradiance"), "disk", DISK, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {N_("disk, highlight"), "disk-highlight", DISK, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("disk, highlight, a far sphere"), "disk-highlight-beside", DISK, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0,
     NOT_ALONE},
    {N_("box, irradiance"), "box", BOX, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {N_("box, highlight"), "box-highlight", BOX, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("ball, irradiance"), "ball", BALL, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {N_("ball, highlight"), "ball-highlight", BALL, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("ball, highlight, a far sphere"), "ball-highlight-beside", BALL, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0,
     NOT_ALONE},
    {N_("tube, irradiance"), "tube", TUBE, "shininess: 20", 1, 0, LUXEL_IRRADIANCE, 1, 0, FROM_AFAR},
    {N_("tube, highlight"), "tube-highlight", TUBE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0, FROM_AFAR},
    {N_("tube, highlight, a far sphere"), "tube-highlight-beside", TUBE, "shininess: 20", 1, 0, LUXEL_BRIGHTNESS, 1, 0,
     NOT_ALONE},
    {N_("65536 points in 16 lamps"), "many-points",
     LIGHT("planar, radiance: 10, rectangle: {center: [%.3f, %.3f, 2500], size: [120, 120], aim: [0, 0, 1000]}, "
           "parts: 64"),
     "shininess: 20", MANY, 0, LUXEL_BRIGHTNESS, 64 * 64, 0.01, FROM_AFAR},
};

/* One measurement. */
struct timing {
    const char *name, *id, *set;
    size_t lights, pixels;
    double alone_s, together_s; /* the best time of one thread, and of all */
    double floor_ns;            /* per pixel and light, one thread; 0: not known */
};

struct bench {
    const struct options *options;
    struct progress progress;
    double done; /* the share of all measurements */
    struct timing rows[MOST_ROWS];
    size_t row_count;
    const char *sets[MOST_SETS]; /* those that run here */
    double products[MOST_SETS];  /* a second, by one thread */
    size_t set_count;
    double copied;
};

static bool go_on(double done, void *data)
{
    struct bench *bench = data;

    (void)done;
    return progress_report(bench->done, &bench->progress);
}

/* The best of some runs, in seconds. */
static luxel_status best_time(struct bench *bench, const luxel_scene *scene, luxel_settings settings,
                              luxel_diagnostics *diagnostics, double *best_s, size_t *pixels)
{
    const double start = machine_seconds();

    *best_s = HUGE_VAL;
    settings.progress = go_on;
    settings.progress_data = bench;
    for (int run = 0; run < MOST_RUNS && (run < LEAST_RUNS || machine_seconds() - start < LEAST_SECONDS); run++) {
        luxel_field *field = NULL;
        const double begin = machine_seconds();
        const luxel_status status = luxel_render(scene, &settings, diagnostics, &field);

        if (status != LUXEL_OK)
            return status;
        *best_s = fmin(*best_s, machine_seconds() - begin);
        *pixels = luxel_field_statistics(field)->surface_pixels;
        luxel_field_free(field);
    }
    return LUXEL_OK;
}

static luxel_status measure(struct bench *bench, const luxel_scene *scene, luxel_settings settings, size_t set,
                            unsigned operations, luxel_diagnostics *diagnostics, struct timing *row)
{
    const unsigned threads = settings.threads;
    luxel_status status;

    row->set = settings.instruction_set = bench->sets[set];
    status = best_time(bench, scene, settings, diagnostics, &row->together_s, &row->pixels);
    settings.threads = 1;
    row->alone_s = row->together_s;
    if (status == LUXEL_OK && threads != 1)
        status = best_time(bench, scene, settings, diagnostics, &row->alone_s, &row->pixels);
    /* an operation on a whole vector takes as long as a product and sum */
    row->floor_ns = 1e9 * operations / bench->products[set];
    return status;
}

static luxel_scene *scene_of(const struct bench_case *each, luxel_diagnostics *diagnostics)
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
    if (luxel_scene_read_text(text, used, "bench", diagnostics, &scene) == LUXEL_OK)
        luxel_scene_commit(scene, diagnostics);
    return scene;
}

static luxel_status measure_cases(struct bench *bench, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;

    for (size_t i = 0; i < COUNT_OF(cases) && status == LUXEL_OK; i++) {
        const struct bench_case *each = &cases[i];
        luxel_scene *scene = scene_of(each, diagnostics);
        luxel_settings settings = bench->options->settings;

        settings.quantity = each->quantity;
        settings.light_error = each->light_error;
        for (size_t set = 0; set < bench->set_count && status == LUXEL_OK; set++) {
            struct timing *row = &bench->rows[bench->row_count++];

            *row =
                (struct timing){.name = _(each->name), .id = each->id, .lights = (size_t)each->lights * each->points};
            status = measure(bench, scene, settings, set, each->operations, diagnostics, row);
            bench->done = (double)bench->row_count / (double)(COUNT_OF(cases) * bench->set_count);
        }
        luxel_scene_free(scene);
    }
    return status;
}

static luxel_status measure_scene(struct bench *bench, const struct loaded *loaded)
{
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(loaded->scene, NULL, loaded->diagnostics, &evaluator);
    const size_t lights = evaluator ? luxel_evaluator_light_count(evaluator) : 0;

    luxel_evaluator_free(evaluator);
    for (size_t set = 0; set < bench->set_count && status == LUXEL_OK; set++) {
        struct timing *row = &bench->rows[bench->row_count++];

        *row = (struct timing){.name = loaded->name, .id = loaded->name, .lights = lights};
        status = measure(bench, loaded->scene, bench->options->settings, set, 0, loaded->diagnostics, row);
        bench->done = (double)(set + 1) / (double)bench->set_count;
    }
    return status;
}

static double ns_of(const struct timing *row, double seconds)
{
    return 1e9 * seconds / ((double)row->pixels * (double)row->lights);
}

static bool is_countable(const struct timing *row)
{
    return row->pixels > 0 && row->lights > 0;
}

static void print_json(const struct bench *bench)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_open(&json, "machine", '{');
    json_number(&json, "copied_bytes_per_second", bench->copied);
    json_open(&json, "instruction_sets", '[');
    for (size_t i = 0; i < bench->set_count; i++) {
        json_open(&json, NULL, '{');
        json_text(&json, "name", bench->sets[i]);
        json_number(&json, "products_per_second", bench->products[i]);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
    json_whole(&json, "threads", bench->options->settings.threads);
    json_open(&json, "timings", '[');
    for (size_t i = 0; i < bench->row_count; i++) {
        const struct timing *row = &bench->rows[i];
        const double none = (double)NAN, alone = is_countable(row) ? ns_of(row, row->alone_s) : none;

        json_open(&json, NULL, '{');
        json_text(&json, "case", row->id);
        json_text(&json, "instruction_set", row->set);
        json_whole(&json, "lights", row->lights);
        json_whole(&json, "pixels", row->pixels);
        json_number(&json, "one_thread_ms", 1e3 * row->alone_s);
        json_number(&json, "all_threads_ms", 1e3 * row->together_s);
        json_number(&json, "one_thread_ns", alone);
        json_number(&json, "all_threads_ns", is_countable(row) ? ns_of(row, row->together_s) : none);
        json_number(&json, "floor_ns", row->floor_ns > 0 ? row->floor_ns : none);
        json_number(&json, "times_floor", row->floor_ns > 0 ? alone / row->floor_ns : none);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
}

static void print_machine(const struct bench *bench)
{
    struct text_table *table = text_table_new("lr");
    char cell[TEXT_SIZE];

    fputs(_("At best, measured now, by one thread:\n\n"), stdout);
    for (size_t i = 0; i < bench->set_count; i++) {
        char name[TEXT_SIZE];

        text_format(name, _("%s: products and sums of float32"), bench->sets[i]);
        text_table_row(table,
                       TEXT_CELLS(name, text_format(cell, _("%.1f billion a second"), 1e-9 * bench->products[i])));
    }
    text_table_row(table,
                   TEXT_CELLS(_("memory, copying"), text_format(cell, _("%.1f GB a second"), 1e-9 * bench->copied)));
    text_table_print(table, stdout, 2);
    fputc('\n', stdout);
}

static void print_text(const struct bench *bench)
{
    struct text_table *table = text_table_new("llrrrrrr");

    print_machine(bench);
    fputs(_("Whole pictures, the best of some runs; ns for each pixel on a surface and light:\n\n"), stdout);
    text_table_row(table, TEXT_CELLS("", _("set"), _("lights"), _("1 thread, ms"), _("ns"), _("times floor"),
                                     _("all threads, ms"), _("ns")));
    for (size_t i = 0; i < bench->row_count; i++) {
        const struct timing *row = &bench->rows[i];
        char cells[6][TEXT_SIZE];
        const bool countable = is_countable(row), bounded = countable && row->floor_ns > 0;
        const int digits = row->lights > 1000 ? 4 : 2;

        text_table_row(
            table,
            TEXT_CELLS(i > 0 && row[-1].id == row->id ? "" : row->name, row->set,
                       text_format(cells[0], "%zu", row->lights), text_format(cells[1], "%.2f", 1e3 * row->alone_s),
                       countable ? text_format(cells[2], "%.*f", digits, ns_of(row, row->alone_s)) : "",
                       bounded ? text_format(cells[3], "%.1f", ns_of(row, row->alone_s) / row->floor_ns) : "",
                       text_format(cells[4], "%.2f", 1e3 * row->together_s),
                       countable ? text_format(cells[5], "%.*f", digits, ns_of(row, row->together_s)) : ""));
    }
    text_table_print(table, stdout, 2);
}

/* The sets to measure: all that run here, or that of LUXEL_ISA alone, by whichever of its names. */
static luxel_status find_sets(struct bench *bench, luxel_diagnostics *diagnostics)
{
    const char *forced = getenv("LUXEL_ISA");
    luxel_scene *scene = scene_of(&cases[0], diagnostics);
    luxel_field *field = NULL;
    const luxel_status status = luxel_render(scene, NULL, diagnostics, &field);

    luxel_scene_free(scene);
    if (status != LUXEL_OK)
        return status;
    for (size_t i = 0; luxel_instruction_set_name(i) && bench->set_count < MOST_SETS; i++) {
        const char *name = luxel_instruction_set_name(i);

        if (!luxel_instruction_set_runs(i) ||
            (forced && *forced && strcmp(luxel_field_instruction_set(field), name) != 0))
            continue;
        bench->sets[bench->set_count] = name;
        bench->products[bench->set_count++] = machine_products_per_second(name);
    }
    luxel_field_free(field);
    bench->copied = machine_copied_bytes_per_second();
    return LUXEL_OK;
}

/* `loaded` NULL: the cases of the tool. */
static int bench_all(const struct options *options, const struct loaded *loaded)
{
    luxel_diagnostics *diagnostics = loaded ? loaded->diagnostics : message_new_diagnostics();
    struct bench *bench = message_allocate(1, sizeof *bench);
    luxel_status status;
    int code;

    _Static_assert(COUNT_OF(cases) * MOST_SETS / 2 <= MOST_ROWS, "room for four sets and more");
    bench->options = options;
    progress_begin(&bench->progress, options->quiet);
    status = find_sets(bench, diagnostics);
    if (status == LUXEL_OK)
        status = loaded ? measure_scene(bench, loaded) : measure_cases(bench, diagnostics);
    progress_end(&bench->progress);
    code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
    if (code == EXIT_DONE && options->json)
        print_json(bench);
    else if (code == EXIT_DONE)
        print_text(bench);
    free(bench);
    if (!loaded)
        luxel_diagnostics_free(diagnostics);
    return code;
}

static int run(const struct options *options)
{
    if (options->operand || options->assignment_count > 0)
        return load_and(options, bench_all);
    return bench_all(options, NULL);
}

const struct command command_bench = {
    .name = "bench",
    .bit = COMMAND_BENCH,
    .operand = N_("SCENE"),
    .summary = N_("measure how fast this machine makes pictures"),
    .description =
        N_("Without SCENE, 800 × 800 pixels of one sphere under each kind of source, with every instruction set that "
           "runs here, by one thread and by all of them (or --threads); many points with --light-error 0.01; with "
           "SCENE, its picture. Beside them stands "
           "what the machine can do at best, measured in the same run: times floor is how many times as long a "
           "picture takes as the products and sums of all its sources at every pixel alone would; it is below 1 "
           "where sums at some pixels do for those around them. Compare the rows of one run; absolute times depend "
           "on what else the machine does."),
    .examples = "luxel bench\n"
                "luxel bench three-lights --threads 1\n"
                "luxel bench --json > bench.json",
    .run = run,
};
