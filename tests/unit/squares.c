/* SPDX-License-Identifier: MIT */
/* Random squares, and complex places around them. */
#include "squares.h"
#include "campaign.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "picture/plan_make.h"
#include "world/camera.h"

static struct lx_square random_square(struct randomness *random, const struct lx_plan *plan)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const struct lx_planned_surface *surface = plan->surfaces;
    const unsigned side = pick(random, 2) ? LX_PANEL_SIDE : LX_PANEL_SIDE / 2;
    const double half = screen->width_mm / screen->resolution[0] * side / 2;
    const double *anchor = surface->shape.anchor_mm;
    const double scale = lx_scale_at(&plan->prepared->camera, anchor[2]);
    const bool is_central = pick(random, 4) == 0;
    return (struct lx_square){
        .surface = surface,
        .x_mm = scale * (is_central ? anchor[0] : uniform(random, surface->low_mm[0], surface->high_mm[0])),
        .y_mm = scale * (is_central ? anchor[1] : uniform(random, surface->low_mm[1], surface->high_mm[1])),
        .half_mm = {half, half},
        .side = side,
    };
}

bool open_workplace(const struct test_scene *test, const struct lx_kernels *kernels, struct workplace *work)
{
    const luxel_settings settings = {.precision = LUXEL_SINGLE};
    *work = (struct workplace){.shader = NULL};
    assert_int_equal(lx_plan_make(&test->prepared, kernels, &settings, &work->plan), LUXEL_OK);
    if (!work->plan.in_panels)
        return false;
    work->shader = lx_shader_memory_new(&work->plan);
    assert_non_null(work->shader);
    assert_int_equal(lx_fitting_make(&work->plan, &work->fitting), 0);
    return true;
}

void close_workplace(struct workplace *work)
{
    if (work->plan.in_panels)
        lx_fitting_clear(&work->fitting);
    lx_shader_memory_free(work->shader);
    lx_plan_clear(&work->plan);
}

void make_finer_scene(struct randomness *random, bool is_plate, struct test_scene *test, double direction[3],
                      double center[3])
{
    make_random_scene(random, is_plate, test);
    const struct lx_shape *shape = &test->surfaces[0].shape;
    const double away = shape->radius_mm + 150 + 300 * logarithmic(random, 0.05, 20);
    const unsigned finer = (unsigned)logarithmic(random, 8, 50);
    random_direction(random, direction);
    for (int k = 0; k < 3; k++)
        center[k] =
            shape->anchor_mm[k] + away * (shape->type == LX_PLATE ? shape->axis[k] + 0.7 * direction[k] : direction[k]);
    test->prepared.surface_count = 1;
    test->prepared.shadows = false;
    test->scene.screen.resolution[0] *= finer;
    test->scene.screen.resolution[1] *= finer;
}

static void visit_each(const struct campaign *campaign, int step, const struct lx_kernels *kernels, void *data)
{
    for (int i = 0; i < scenes_to_try(campaign->scenes); i += step) {
        struct randomness random = {.state = campaign->seed * ((uint64_t)i + 1)};
        struct test_scene test;
        struct workplace work;
        campaign->make(i, &test);
        if (open_workplace(&test, kernels, &work))
            for (int q = 0; q < campaign->squares; q++) {
                const struct lx_square square = random_square(&random, &work.plan);
                campaign->visit(&test, &work, &square, q, &random, data);
            }
        close_workplace(&work);
        if (campaign->clear)
            campaign->clear(&test);
    }
}

void visit_squares(const struct campaign *campaign, const struct lx_kernels *kernels, void *data)
{
    visit_each(campaign, 1, kernels, data);
}

void visit_by_all_sets(const struct campaign *campaign, void *data)
{
    int step = 1;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        if (!lx_kernels_get(k)->runs())
            continue;
        visit_each(campaign, step, lx_kernels_get(k), data);
        step = 10;
    }
}

double complex dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct vector plus(struct vector a, double complex times, struct vector b)
{
    return (struct vector){a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}

struct vector unit(struct vector a)
{
    return plus((struct vector){0, 0, 0}, 1 / csqrt(dot(a, a)), a);
}

struct vector cross(struct vector a, struct vector b)
{
    return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct vector vector_of(const double a[3])
{
    return (struct vector){a[0], a[1], a[2]};
}

struct vector across(struct vector a, struct vector axis)
{
    return plus(a, -dot(a, axis), axis);
}

double length_of_real(struct vector a)
{
    return sqrt(creal(a.x) * creal(a.x) + creal(a.y) * creal(a.y) + creal(a.z) * creal(a.z));
}

/* The observer, from the surface's anchor. */
static struct vector observer_from(const struct lx_plan *plan)
{
    const double *anchor = plan->surfaces->shape.anchor_mm, z = plan->prepared->camera.z_mm;
    return (struct vector){-anchor[0], -anchor[1], z - anchor[2]};
}

struct vector place_at(const struct lx_plan *plan, double complex x, double complex y, struct vector *normal)
{
    const struct lx_camera *camera = &plan->prepared->camera;
    const struct lx_shape *shape = &plan->surfaces->shape;
    const bool is_central = camera->is_perspective;
    const struct vector n = {shape->axis[0], shape->axis[1], shape->axis[2]}, zero = {0, 0, 0},
                        from = is_central ? observer_from(plan)
                                          : (struct vector){x - shape->anchor_mm[0], y - shape->anchor_mm[1], 0},
                        line = is_central ? (struct vector){x, y, -camera->z_mm} : (struct vector){0, 0, -1},
                        moment = cross(from, line);
    *normal = n;
    if (shape->type == LX_PLATE)
        return plus(zero, 1 / dot(n, line), cross(n, moment));
    const double complex square = dot(line, line);
    const double complex root = csqrt(square * shape->radius_mm * shape->radius_mm - dot(moment, moment));
    const struct vector place = plus(plus(zero, 1 / square, cross(line, moment)), -root / square, line);
    *normal = plus(zero, 1 / shape->radius_mm, place);
    return place;
}

struct vector view_at(const struct lx_plan *plan, struct vector place)
{
    if (plan->prepared->camera.is_parallel)
        return (struct vector){0, 0, 1};
    return unit(plus(observer_from(plan), -1, place));
}

double complex attenuated(const struct lx_area_light_law *law, double complex square)
{
    return 1 / (law->none + law->root * csqrt(square) + law->square * square);
}

struct seen_place seen_of_side(const struct lx_area_light *lamp, struct vector place, double s, double t)
{
    const struct vector axis = vector_of(lamp->axis), from = plus(place, -1, vector_of(lamp->center));
    const struct vector u = unit(across(from, axis)), v = cross(u, axis), zero = {0, 0, 0};
    const double radius = lamp->round_mm, share = 2 * t - 1;
    const double complex distance = dot(from, u), whole = csqrt((distance - radius) / (distance + radius));
    const double complex turn = 2 * catan(share * whole), turns = 4 * whole / (1 + share * share * whole * whole);
    const struct vector face = plus(plus(zero, ccos(turn), u), csin(turn), v);
    const struct vector at = plus(plus(zero, (2 * s - 1) * lamp->half_mm, axis), radius, face),
                        way = plus(from, -1, at);
    return (struct seen_place){at, radius * 2 * lamp->half_mm * turns * dot(way, face) / csqrt(dot(way, way))};
}

double complex irradiance_by_cylinder(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                                      struct vector place, struct vector normal)
{
    enum { PARTS = 20 };
    const struct vector axis = vector_of(lamp->axis), center = vector_of(lamp->center), zero = {0, 0, 0};
    const struct vector middle = plus(vector_of(at->place), -1, center);
    const double along = creal(dot(middle, axis)), half = lamp->half_mm, radius = lamp->round_mm;
    const bool sees_side = length_of_real(across(middle, axis)) > radius, sees_end = fabs(along) > half;
    const struct vector outward = plus(zero, along < 0 ? -1 : 1, axis), u = unit(across(middle, axis)),
                        v = cross(axis, u);
    double complex sum = 0;
    for (int i = 0; i < PARTS * PARTS; i++) {
        const double s = (i % PARTS + 0.5) / PARTS, t = (i / PARTS + 0.5) / PARTS, turn = 2 * M_PI * t;
        const struct seen_place seen = seen_of_side(lamp, place, s, t);
        const struct vector way = plus(plus(center, 1, seen.from_center), -1, place);
        const struct vector beside = plus(plus(zero, radius * s * cos(turn), u), radius * s * sin(turn), v);
        const struct vector to_end = plus(plus(plus(center, half, outward), 1, beside), -1, place);
        const double complex square = dot(to_end, to_end);
        if (sees_side)
            sum += seen.e * dot(normal, unit(way)) * attenuated(&lamp->law, dot(way, way));
        if (sees_end)
            sum -= 2 * M_PI * s * radius * radius * dot(normal, to_end) * dot(outward, to_end) *
                   attenuated(&lamp->law, square) / square;
    }
    return sum / (PARTS * PARTS);
}

struct falling falling_along(const struct lx_plan *plan, struct vector way, double complex e, struct vector place,
                             struct vector normal)
{
    const struct vector view = view_at(plan, place), towards = unit(way);
    const double complex cosine = dot(normal, towards);
    const struct vector half = unit(plus(towards, 1, view)),
                        mirrored = plus(plus((struct vector){0, 0, 0}, -1, towards), 2 * cosine, normal);
    const bool is_phong = plan->surfaces->lobe_exact.model == LX_PHONG;
    return (struct falling){.e = e, .cosine = cosine, .s = is_phong ? dot(mirrored, view) : dot(normal, half)};
}

struct falling falling_at(const struct lx_plan *plan, const struct lx_light_double *light, double complex x,
                          double complex y)
{
    struct vector normal;
    const struct vector place = place_at(plan, x, y, &normal);
    const struct vector from = {light->x, light->y, light->z}, axis = {light->axis_x, light->axis_y, light->axis_z};
    const bool is_point = light->kind != LX_DISTANT;
    const struct vector way = plus(from, is_point ? -1 : 0, place), towards = unit(way);
    const double complex r = csqrt(dot(way, way));
    double complex e = light->gain;
    if (is_point && light->law == LX_INVERSE_SQUARE)
        e /= r * r;
    if (is_point && light->law == LX_PRACTICAL)
        e /= light->k + r;
    if (is_point && light->law == LX_POLYNOMIAL)
        e /= light->by_none + 1e-3 * r * (light->by_root + 1e-3 * r * light->by_square);
    if (light->exponent.value > 0)
        e *= cpow(-dot(axis, towards), light->exponent.value);
    return falling_along(plan, way, e, place, normal);
}

double complex brightness_of(const struct lx_lobe_double *lobe, struct falling falling, bool is_dark,
                             bool has_highlight)
{
    double complex specular =
        lobe->model == LX_LAMBERT || !has_highlight ? 0 : lobe->specular * cpow(falling.s, lobe->exponent.value);
    if (lobe->highlight == LX_HIGHLIGHT_COSINE)
        specular *= is_dark ? 0 : falling.cosine;
    if (lobe->highlight == LX_HIGHLIGHT_GATED && is_dark)
        specular = 0;
    return falling.e * ((is_dark ? 0 : lobe->diffuse * falling.cosine) + specular);
}

static double complex brightness_by_light(const struct lx_plan *plan, const struct lx_lobe_double *lobe,
                                          const void *light, bool is_dark, bool has_highlight, double complex x,
                                          double complex y)
{
    return brightness_of(lobe, falling_at(plan, light, x, y), is_dark, has_highlight);
}

void random_place(struct randomness *random, const struct lx_square *square, const struct lx_basis *basis,
                  double complex place[2])
{
    const double reach = pick(random, 4) ? basis->reach : uniform(random, 1, basis->reach);
    const double turn = pick(random, 2) ? uniform(random, 0, 2 * M_PI) : pick(random, 4) * M_PI / 2;
    const double parts[2] = {(reach + 1 / reach) / 2 * cos(turn), (reach - 1 / reach) / 2 * sin(turn)};
    const int axis = pick(random, 2);
    memcpy(&place[axis], parts, sizeof parts); /* as a complex number lies in memory */
    place[1 - axis] = uniform(random, -1, 1);
    place[0] = square->x_mm + square->half_mm[0] * place[0];
    place[1] = square->y_mm + square->half_mm[1] * place[1];
}

/* Whether a size holds with the highlight, of which it may be that it is not analytic, as a slip: the rest keeps to it,
 * and what the highlight comes to in the square to that over the slip. */
static bool is_slip(const struct lx_plan *plan, const struct lx_lobe_double *lobe, brightness_by *by, const void *what,
                    const struct lx_square *square, double size, double slip, const double complex place[2])
{
    bool holds = cabs(by(plan, lobe, what, size > 0, false, place[0], place[1])) <= fabs(size) * (1 + 1e-7);
    for (int i = 0; holds && i < 9; i++) {
        const double x = square->x_mm + square->half_mm[0] * (i % 3 - 1),
                     y = square->y_mm + square->half_mm[1] * (i / 3 - 1);
        const double complex all = by(plan, lobe, what, false, true, x, y),
                             diffuse = by(plan, lobe, what, false, false, x, y);
        holds = cabs(all - diffuse) * slip <= fabs(size) * (1 + 1e-7);
    }
    return holds;
}

/* On which side of the horizon a light is in the middle of a square; and whether there is a highlight there. */
static bool is_below(const struct lx_plan *plan, const struct lx_light_double *light, const struct lx_vicinity *at,
                     bool *has_highlight)
{
    const struct lx_lobe_double *lobe = &plan->surfaces->lobe_exact;
    const double moves = light->kind == LX_DISTANT ? 0 : 1, *n = at->normal, *v = at->view;
    double way[3] = {light->x - moves * at->place[0], light->y - moves * at->place[1], light->z - moves * at->place[2]};
    const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    const double height = (n[0] * way[0] + n[1] * way[1] + n[2] * way[2]) / length;
    const double n_v = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    const double l_v = (way[0] * v[0] + way[1] * v[1] + way[2] * v[2]) / length;
    *has_highlight = lobe->model == LX_PHONG ? 2 * height * n_v - l_v > 0 : height + n_v > 0;
    return height < 0;
}

void check_size_by(const struct lx_plan *plan, const struct lx_lobe_double *lobe, brightness_by *by, const void *what,
                   const struct lx_light_double *about, double size, const struct lx_vicinity *at,
                   const struct lx_square *square, const struct lx_basis *basis, struct randomness *random)
{
    bool has_highlight;
    const bool is_dark = is_below(plan, about, at, &has_highlight) && !(size < 0);
    double complex place[2];
    random_place(random, square, basis, place);
    const double value = cabs(by(plan, lobe, what, is_dark, has_highlight, place[0], place[1]));
    if (!(value <= fabs(size) * (1 + 1e-7)) && !is_slip(plan, lobe, by, what, square, size, basis->slip, place))
        fail_msg("light of kind %d: %g, but no more than %g was promised", (int)about->kind, value, size);
}

void check_size(const struct lx_plan *plan, const struct lx_lobe_double *lobe, const struct lx_light_double *light,
                double size, const struct lx_vicinity *at, const struct lx_square *square, const struct lx_basis *basis,
                struct randomness *random)
{
    check_size_by(plan, lobe, brightness_by_light, light, light, size, at, square, basis, random);
}
