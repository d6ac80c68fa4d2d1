/* SPDX-License-Identifier: MIT */
/* Pictures under luminaires with random tables: against those in float64, and square by square against what the
 * polynomials promise to be off by at most. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "campaign.h"
#include "lamp_tables.h"
#include "light/distribution.h"
#include "picture/plan_make.h"
#include "picture/polynomial/smooth.h"
#include "picture/seen.h"
#include "picture/shader.h"
#include "random_scenes.h"
#include "scenes.h"

enum { MOST_FILES = 3 };

/* A scene with the files that it names, in a folder of their own. */
struct stage {
    char folder[40], files[MOST_FILES][96], *text;
    size_t file_count;
};

static void append_material(struct randomness *random, char *text)
{
    static const char *const MODELS[] = {"lambert", "phong", "blinn-phong"};
    append(text, "material: {model: %s, diffuse: %.3f, specular: 0.3, shininess: %.1f}}\n", MODELS[pick(random, 3)],
           uniform(random, 0.1, 0.9), logarithmic(random, 2, 60));
}

static void append_light(struct randomness *random, const struct stage *stage, char *text)
{
    append(text, "  - {type: luminaire, file: '%s', position: [%.3f, %.3f, %.3f], factor: %.4f, interpolation: %s,\n",
           stage->files[pick(random, (int)stage->file_count)], uniform(random, -2000, 2000),
           uniform(random, -2000, 2000), uniform(random, 700, 4000), logarithmic(random, 0.1, 1),
           pick(random, 2) ? "angle" : "cosine");
    if (pick(random, 2))
        append(text, "     axis: [%.3f, %.3f, -1], c0: [%.3f, 1, 0.2]}\n", uniform(random, -1, 1),
               uniform(random, -1, 1), uniform(random, -1, 1));
    else
        append(text, "     aim: [%.3f, %.3f, 0]}\n", uniform(random, -500, 500), uniform(random, -500, 500));
}

static void open_stage(int i, struct stage *stage)
{
    struct randomness random = {0x9e3779b97f4a7c15u * (uint64_t)(i + 1)};
    char *text = calloc(1, MOST_TEXT);
    assert_non_null(text);
    strcpy(stage->folder, "/tmp/luxel-lamps-XXXXXX");
    assert_non_null(mkdtemp(stage->folder));
    stage->file_count = 1 + (size_t)pick(&random, MOST_FILES);
    for (size_t f = 0; f < stage->file_count; f++) {
        snprintf(stage->files[f], sizeof stage->files[f], "%s/%zu.ies", stage->folder, f);
        write_table(&random, stage->files[f], text);
    }
    const unsigned columns = 256 + 64 * (unsigned)pick(&random, 4);
    const bool is_near = pick(&random, 2), has_ball = pick(&random, 2);
    *text = 0;
    append(text, "luxel: 1\nunits: photometric\nscreen: {width: 3000, height: 2250, resolution: [%u, %u]}\n", columns,
           columns / 4 * 3);
    append(text, "observer: {z: 5000%s}\nsurfaces:\n", is_near ? ", projection: perspective" : "");
    if (has_ball)
        append(text, "  - {type: sphere, center: [%.1f, 200, -100], radius: %.1f, ", uniform(&random, -800, 800),
               logarithmic(&random, 200, 900));
    if (has_ball)
        append_material(&random, text);
    append(text, "  - {type: rectangle, center: [0, 0, -900], size: [4000, 3500], axis: [%.3f, %.3f, 1], ",
           uniform(&random, -0.5, 0.5), uniform(&random, -0.5, 0.5));
    append_material(&random, text);
    append(text, "lights:\n  - {type: ambient, irradiance: %.3f}\n", pick(&random, 2) ? 0.0 : 5.0);
    if (pick(&random, 3) == 0)
        append(text, "  - {type: point, position: [500, 800, 2500], intensity: 300}\n");
    for (int light = 1 + pick(&random, 6); light > 0; light--)
        append_light(&random, stage, text);
    stage->text = text;
}

static void close_stage(struct stage *stage)
{
    for (size_t f = 0; f < stage->file_count; f++)
        unlink(stage->files[f]);
    rmdir(stage->folder);
    free(stage->text);
}

static luxel_field *render(const luxel_scene *scene, luxel_precision precision, const char *set)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.precision = precision;
    settings.instruction_set = set;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static void random_pictures(void **state)
{
    (void)state;
    for (int i = 0; i < scenes_to_try(40); i++) {
        struct stage stage;
        luxel_scene *scene = NULL;
        open_stage(i, &stage);
        assert_int_equal(load(stage.text, NULL, &scene), LUXEL_OK);
        luxel_field *exact = render(scene, LUXEL_DOUBLE, NULL);
        const double maximum = luxel_field_statistics(exact)->maximum.value;
        for (size_t k = 0; luxel_instruction_set_name(k); k++) {
            if (!luxel_instruction_set_runs(k) || (k > 0 && i % 10 > 0))
                continue;
            luxel_field *picture = render(scene, LUXEL_SINGLE, luxel_instruction_set_name(k));
            double worst = 0;
            for (size_t p = 0; p < (size_t)luxel_field_columns(exact) * luxel_field_rows(exact); p++)
                worst = fmax(worst, fabs((double)luxel_field_single(picture)[p] - luxel_field_double(exact)[p]));
            if (worst > 2e-6 * maximum)
                print_message("scene %d is off by %.2g of its maximum:\n%s", i, worst / maximum, stage.text);
            assert_true(worst <= 2e-6 * maximum);
            luxel_field_free(picture);
        }
        luxel_field_free(exact);
        luxel_scene_free(scene);
        close_stage(&stage);
    }
}

/* ---- squares ---- */

struct tried {
    size_t squares, lights, taken;
    double worst; /* error, of what was promised */
};

/* What lights that were taken give at some pixels of a square: as many columns as rows, `step` apart. */
static void sum_exactly(const struct lx_plan *plan, struct lx_shader_memory *shader, const struct lx_square *square,
                        const uint8_t *is_left, unsigned step, double *sums)
{
    struct lx_basis pixels = {.nodes = LX_MOST_NODES};
    const struct lx_planned_surface *surface = square->surface;
    struct lx_seen *seen = lx_shader_seen(shader);
    for (unsigned k = 0; k < LX_MOST_NODES; k++)
        pixels.place[k] = (2.0 * (k * step) + 1) / square->side - 1;
    lx_gather_nodes(plan, seen, square, &pixels, false);
    const size_t count = (size_t)LX_MOST_NODES * LX_MOST_NODES;
    plan->kernels->set_all(sums, count, 0);
    for (size_t i = 0; i < surface->lights.count; i++)
        if (!is_left[i])
            plan->kernels->shade_double(&surface->lights.exacts[i], NULL, 1, &surface->lobe_exact, &seen->block, NULL,
                                        NULL, count, sums);
}

static void try_square(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                       struct randomness *random, struct tried *tried)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const unsigned side = pick(random, 2) ? LX_PANEL_SIDE : LX_PANEL_SIDE / 2;
    const double half = screen->width_mm / screen->resolution[0] * side / 2;
    struct lx_square square = {.x_mm = uniform(random, -1200, 1200),
                               .y_mm = uniform(random, -900, 900),
                               .half_mm = {half, half},
                               .side = side};
    square.surface = lx_surface_seen(plan, square.x_mm, square.y_mm);
    if (!square.surface || !square.surface->smooth.pays)
        return;
    static float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
    _Alignas(64) static double sums[LX_BLOCK];
    const struct lx_square_values to = {side, side, values, side};
    const struct lx_allowance all = {8e-7 * plan->least_maximum, 2.4e-6 * plan->least_maximum};
    struct lx_allowance left = all;
    memset(values, 0, sizeof values);
    memset(fitting->is_left, 1, square.surface->smooth.count);
    const size_t taken = lx_add_tabled(plan, fitting, shader, &square, &to, &left);
    tried->squares++, tried->lights += square.surface->smooth.luminaires.count, tried->taken += taken;
    if (taken == 0)
        return;
    const unsigned step = side / LX_MOST_NODES;
    sum_exactly(plan, shader, &square, fitting->is_left, step, sums);
    const double promised = all.error - left.error + (all.rounding - left.rounding);
    for (unsigned j = 0; j < LX_MOST_NODES; j++)
        for (unsigned i = 0; i < LX_MOST_NODES; i++) {
            const double exact = sums[j * LX_MOST_NODES + i];
            const double off = fabs((double)values[j * step * side + i * step] - exact);
            const double of_sums = 6e-8 * (double)taken * exact; /* float32 values that are added to */
            if (off > promised + of_sums)
                print_message("off by %g, promised %g and %g\n", off, promised, of_sums);
            assert_true(off <= promised + of_sums);
            tried->worst = fmax(tried->worst, off / (promised + of_sums));
        }
}

static void try_scene(int i, struct tried *tried)
{
    const luxel_settings settings = {.precision = LUXEL_SINGLE};
    struct randomness random = {0xd1342543de82ef95u * (uint64_t)(i + 1)};
    struct stage stage;
    luxel_scene *scene = NULL;
    struct lx_prepared prepared;
    struct lx_plan plan;
    open_stage(i, &stage);
    assert_int_equal(load(stage.text, NULL, &scene), LUXEL_OK);
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
    assert_int_equal(lx_plan_make(&prepared, lx_kernels_choose(NULL), &settings, &plan), LUXEL_OK);
    if (plan.in_panels) {
        struct lx_fitting fitting;
        struct lx_shader_memory *shader = lx_shader_memory_new(&plan);
        assert_non_null(shader);
        assert_int_equal(lx_fitting_make(&plan, &fitting), 0);
        for (int q = 0; q < 20; q++)
            try_square(&plan, &fitting, shader, &random, tried);
        lx_fitting_clear(&fitting);
        lx_shader_memory_free(shader);
    }
    lx_plan_clear(&plan);
    lx_prepared_clear(&prepared);
    luxel_scene_free(scene);
    close_stage(&stage);
}

static void random_squares(void **state)
{
    (void)state;
    struct tried tried = {0};
    for (int i = 0; i < scenes_to_try(100); i++)
        try_scene(i, &tried);
    assert_true(tried.squares >= in_campaign(300));
    assert_true(tried.taken >= tried.lights / 3 && tried.worst > 0.01);
}

/* Directions that go a little way each, and at times far: through cells, across the poles, around. */
static void walk(const struct lx_pointed *pointed, struct randomness *random)
{
    struct lx_kept_cell kept = {0};
    double towards[3] = {1, 0, 0};
    for (int step = 0; step < 400; step++) {
        const double far = pick(random, 20) == 0 ? 2 : pick(random, 2) ? 0.1 : 0.005;
        double length = 0;
        for (int k = 0; k < 3; k++) {
            towards[k] += uniform(random, -far, far);
            length += towards[k] * towards[k];
        }
        for (int k = 0; k < 3; k++)
            towards[k] /= sqrt(length);
        const double value = lx_pointed_plain(pointed, towards), off = lx_pointed_slope(pointed) * 1e-13;
        assert_true(fabs(lx_pointed_near(pointed, towards, &kept) - value) <= off + 1e-13);
    }
}

static void near_directions(void **state)
{
    struct randomness random = {0x2545f4914f6cdd1du};
    size_t walks = 0;
    (void)state;
    for (int i = 0; i < scenes_to_try(100); i++) {
        struct stage stage;
        luxel_scene *scene = NULL;
        struct lx_prepared prepared;
        open_stage(i, &stage);
        assert_int_equal(load(stage.text, NULL, &scene), LUXEL_OK);
        assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
        for (size_t k = 0; k < prepared.emitters.count; k++) {
            struct lx_emitter room;
            const struct lx_emitter *emitter = lx_emitter_at(&prepared.emitters, k, &room);
            if (emitter->profile.luminaire && walks++ < 1000)
                walk(emitter->profile.luminaire, &random);
        }
        lx_prepared_clear(&prepared);
        luxel_scene_free(scene);
        close_stage(&stage);
    }
    assert_true(walks > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_pictures),
        cmocka_unit_test(random_squares),
        cmocka_unit_test(near_directions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
