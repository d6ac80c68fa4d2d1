/* SPDX-License-Identifier: MIT */
/*
 * What meshes hide of extended sources, in random scenes with other surfaces between: by their outlines, against each
 * of their triangles cut out of the source by itself, to the errors that are told; from elements below, and of their
 * own.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "campaign.h"
#include "light/solid/extended.h"
#include "place.h"
#include "scenes.h"
#include "shadow_scenes.h"
#include "surface/mesh.h"
#include "world/integral/cubature.h"
#include "world/reference.h"

enum { MOST_CORNERS = 64, MOST_TRIANGLES = 128 };

struct model {
    double corners[MOST_CORNERS][3];
    unsigned triangles[MOST_TRIANGLES][3], corner_count, count;
};

static void add_triangle(struct model *model, unsigned a, unsigned b, unsigned c, bool flipped)
{
    unsigned *triangle = model->triangles[model->count++];
    triangle[0] = a, triangle[1] = flipped ? c : b, triangle[2] = flipped ? b : c;
}

/* A dented ball of few triangles; some of them missing, or looking inwards, where it is not to be a good one. */
static void make_ball(struct model *model, struct dice *dice, const double center[3], double radius, bool good)
{
    const unsigned bands = 2 + (unsigned)dice_pick(dice, 2), around = 3 + (unsigned)dice_pick(dice, 3);
    const unsigned south = 1 + (bands - 1) * around;
    model->count = 0;
    model->corner_count = south + 1;
    for (unsigned i = 0; i <= south; i++) {
        const unsigned band = i == 0 ? 0 : i == south ? bands : 1 + (i - 1) / around;
        const double theta = M_PI * band / bands, phi = 2 * M_PI * ((i - 1) % around) / around + 0.3;
        const double r = radius * dice_uniform(dice, 0.4, 1),
                     at[3] = {r * sin(theta) * cos(phi), r * sin(theta) * sin(phi), r * cos(theta)};
        for (int k = 0; k < 3; k++)
            model->corners[i][k] = center[k] + at[k];
    }
    for (unsigned i = 0; i < bands; i++)
        for (unsigned k = 0; k < around; k++) {
            const unsigned next = (k + 1) % around, up = 1 + (i - 1) * around, down = 1 + i * around;
            const bool flipped = !good && dice_pick(dice, 6) == 0;
            if (!good && dice_pick(dice, 5) == 0)
                continue;
            if (i == 0)
                add_triangle(model, 0, down + k, down + next, flipped);
            else if (i == bands - 1)
                add_triangle(model, up + k, south, up + next, flipped);
            if (i > 0 && i < bands - 1) {
                add_triangle(model, up + k, down + k, down + next, flipped);
                add_triangle(model, up + k, down + next, up + next, flipped);
            }
        }
    if (model->count == 0)
        add_triangle(model, 0, 1, 2, false);
}

static void write_model(const struct model *model, const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%u %u 0\n", model->corner_count, model->count);
    for (unsigned i = 0; i < model->corner_count; i++)
        fprintf(file, "%.17g %.17g %.17g\n", model->corners[i][0], model->corners[i][1], model->corners[i][2]);
    for (unsigned i = 0; i < model->count; i++)
        fprintf(file, "3 %u %u %u\n", model->triangles[i][0], model->triangles[i][1], model->triangles[i][2]);
    assert_int_equal(fclose(file), 0);
}

struct stage {
    luxel_scene *scene;
    struct lx_prepared prepared;
};

static struct stage staged(const char *text, double tolerance)
{
    struct stage stage;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &stage.scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    luxel_diagnostics_free(diagnostics);
    const luxel_settings settings = {.tolerance = tolerance};
    assert_int_equal(lx_prepare(lx_scene_parameters(stage.scene), &settings, NULL, &stage.prepared), 0);
    return stage;
}

static void leave(struct stage *stage)
{
    lx_prepared_clear(&stage->prepared);
    luxel_scene_free(stage->scene);
}

/* The mesh's triangles as obstacles, but for those that the place lies on. */
static void gather_triangles(const struct model *model, const struct lx_shape *shape, struct lx_occlusion *occlusion)
{
    for (unsigned t = 0; t < model->count; t++) {
        struct lx_obstacle obstacle = {.type = LX_OBSTACLE_POLYGON, .corner_count = 3, .touch_mm = shape->touch_mm};
        struct lx_tree_triangle triangle;
        for (int c = 0; c < 3; c++) {
            memcpy(obstacle.corners_mm[c], model->corners[model->triangles[t][c]], sizeof obstacle.corners_mm[c]);
            memcpy(triangle.corners[c], obstacle.corners_mm[c], sizeof triangle.corners[c]);
        }
        if (lx_triangle_square(&triangle, occlusion->place_mm) > shape->touch_mm * shape->touch_mm)
            assert_int_equal(lx_obstacles_append(&occlusion->obstacles, &obstacle), 0);
    }
}

/* What an element sees of a source with each triangle cut out by itself. */
static struct lx_cubature by_triangles(const struct lx_prepared *prepared, const struct lx_element *element,
                                       const struct lx_emitter *emitter, const struct model *model)
{
    struct lx_occlusion occlusion = {.place_mm = {0}};
    const double place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value};
    const double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    lx_occlusion_begin(place, NULL, emitter, &occlusion);
    for (size_t i = 0; i < prepared->surface_count; i++) {
        const struct lx_shape *shape = &prepared->surfaces[i].shape;
        const bool is_own = &prepared->surfaces[i] == element->own;
        if (shape->kind->layers && is_own)
            assert_int_equal(lx_obstacles_append(&occlusion.obstacles,
                                                 &(struct lx_obstacle){.type = LX_OBSTACLE_SPACE,
                                                                       .axis = {normal[0], normal[1], normal[2]}}),
                             0);
        if (shape->kind->layers)
            gather_triangles(model, shape, &occlusion);
        else
            assert_int_equal(lx_occlusion_gather(shape, is_own, false, normal, &occlusion), 0);
    }
    assert_int_equal(
        lx_occlusion_settle(emitter, element->place_mm.x.error + element->place_mm.y.error + element->place_mm.z.error,
                            &occlusion),
        0);
    const struct lx_cubature result = lx_integrate(emitter, element, &occlusion, true, 0, prepared->tolerance, NULL);
    lx_occlusion_clear(&occlusion);
    return result;
}

/* What no rounding tells from nothing counts as hidden. */
static void assert_within(lx_bounded found, lx_bounded other, double whole, const char *what, const char *text)
{
    if (!(fabs(found.value - other.value) <= found.error + other.error + 1e-14 * whole))
        fail_msg("%s: %.17g +- %g by outlines, %.17g +- %g by triangles, off by %g, of\n%s", what, found.value,
                 found.error, other.value, other.error, found.value - other.value, text);
}

/* A scene with a mesh, behind the other surfaces. */
static void insert_mesh(const struct text *text, const char *path, char *made, size_t size)
{
    const char *lights = strstr(text->words, "lights:\n");
    snprintf(made, size, "%.*s  - {type: mesh, file: %s, scale: 1, normals: flat, material: {model: %s}}\n%s",
             (int)(lights - text->words), text->words, path, "blinn-phong, highlight: cosine", lights);
}

/* An element of the plate, or in the middle of a triangle of the mesh, on either of its sides. */
static struct lx_element choose_element(const struct lx_prepared *prepared, const struct model *model,
                                        struct dice *dice)
{
    luxel_place asked = {.position_mm = {dice_uniform(dice, -15, 15), dice_uniform(dice, -15, 15), 0},
                         .normal = {0, 0, 1}};
    if (dice_pick(dice, 3) == 0) {
        const unsigned *names = model->triangles[dice_pick(dice, (int)model->count)];
        double sides[2][3], sign = dice_pick(dice, 2) ? 1 : -1;
        for (int k = 0; k < 3; k++) {
            const double *a = model->corners[names[0]], *b = model->corners[names[1]], *c = model->corners[names[2]];
            asked.position_mm[k] = 0.3 * a[k] + 0.25 * b[k] + 0.45 * c[k];
            sides[0][k] = b[k] - a[k], sides[1][k] = c[k] - a[k];
        }
        lx_cross(sides[0], sides[1], asked.normal);
        lx_normalize(asked.normal);
        for (int k = 0; k < 3; k++)
            asked.normal[k] *= sign;
    }
    return lx_element_at(prepared, &asked);
}

static void outlines_against_triangles(void **state)
{
    const struct place *folder = *state;
    const char *from = getenv("LUXEL_SHADOW_SEED");
    const int count = scenes_to_try(240);
    struct dice dice = {from ? strtoull(from, NULL, 0) : 7131};
    int partly = 0, precise = 0, own = 0;
    for (int n = 0; n < count; n++) {
        const struct text text = shadow_scene(&dice, n % KINDS, n / KINDS % SOURCES, n % 3 == 2, 10);
        static struct model model;
        static char words[2 * MOST_TEXT];
        const double share = dice_uniform(&dice, 0.1, 1.1), spread = 150 * share;
        const double *to;
        insert_mesh(&text, folder->file, words, sizeof words);
        make_ball(&model, &dice, (const double[]){0, 0, 500}, 100, true);
        write_model(&model, folder->file);
        struct stage stage = staged(words, 1e-9);
        const struct lx_emitter *emitter = &stage.prepared.emitters.items[0];
        to = emitter->type == LX_FACETS ? emitter->facets->center_mm : emitter->center_mm;
        const double center[3] = {share * to[0] + dice_uniform(&dice, -spread, spread),
                                  share * to[1] + dice_uniform(&dice, -spread, spread), share * to[2]};
        make_ball(&model, &dice, center, 30 + pow(10, dice_uniform(&dice, 1, 2.5)), dice_pick(&dice, 2));
        leave(&stage);
        write_model(&model, folder->file);
        stage = staged(words, 1e-9);
        emitter = &stage.prepared.emitters.items[0];
        const struct lx_element element = choose_element(&stage.prepared, &model, &dice);
        const struct lx_lighting light = lx_light_element(&stage.prepared, &element, emitter);
        if (!light.on_element) {
            const struct lx_cubature truth = by_triangles(&stage.prepared, &element, emitter, &model);
            if (getenv("LUXEL_SHADOW_VERBOSE"))
                printf("%d: %.12g +- %.1e, %.12g +- %.1e; %.12g, %.12g\n", n, light.irradiance.value,
                       light.irradiance.error, truth.irradiance.value, truth.irradiance.error, light.specular.value,
                       truth.specular.value);
            const double whole = lx_extended_irradiance(emitter, element.place_mm, element.normal).value;
            assert_within(light.irradiance, truth.irradiance, whole, "irradiance", words);
            assert_within(light.specular, truth.specular, whole, "highlight", words);
            partly += light.irradiance.value > 1e-9 && light.irradiance.value < 0.999 * whole;
            precise += light.irradiance.error <= 2e-9 * light.irradiance.value + 1e-300;
            own += element.own && element.own->kind->layers;
        }
        leave(&stage);
    }
    if (getenv("LUXEL_SHADOW_VERBOSE"))
        printf("%d partly, %d precise, %d on the mesh\n", partly, precise, own);
    assert_true(partly > count / 8 && own > count / 8 && precise > count / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(outlines_against_triangles, make_place, remove_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
