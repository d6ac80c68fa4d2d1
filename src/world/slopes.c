/* SPDX-License-Identifier: MIT */
/* Slopes of values from gradients at elements and the rates of a scene's constants. */
#include "slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "camera.h"

/* Scenes of more are point clouds, whose constants would take more memory than they save time. */
enum { MOST_EMITTERS = 4096 };

/* ---- constants ---- */

/* Where the constants of something begin: emitter i, the lobe of surface i, the lobe of one as its list has it, the
 * shape of surface i, the camera. */
static size_t of_lobe(const struct lx_constants *all, size_t i)
{
    return all->emitters * LX_OF_EMITTER + i * LX_OF_LOBE;
}

static size_t of_authored(const struct lx_constants *all, size_t i)
{
    return of_lobe(all, all->surfaces) + i * LX_OF_LOBE;
}

static size_t of_shape(const struct lx_constants *all, size_t i)
{
    return of_authored(all, all->authored) + i * LX_OF_SHAPE;
}

static size_t of_camera(const struct lx_constants *all)
{
    return of_shape(all, all->surfaces);
}

static void put3(lx_bounded *to, lx_bounded3 vector)
{
    to[0] = vector.x;
    to[1] = vector.y;
    to[2] = vector.z;
}

/* What may have been rounded while it was made of lengths up to `size`. */
static lx_bounded3 rounded3(const double v[3], double size)
{
    const double error = 8 * LX_ROUNDING * size;
    return (lx_bounded3){{v[0], error}, {v[1], error}, {v[2], error}};
}

static lx_bounded rounded(double value)
{
    return (lx_bounded){value, 8 * LX_ROUNDING * fabs(value)};
}

static double greatest3(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* The greatest coordinate at which an emitter stands. */
static double reach_of(const struct lx_emitters *emitters)
{
    double reach = 0;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        reach = fmax(reach, greatest3(lx_emitter_at(emitters, i, &room)->position_mm));
    }
    return reach;
}

static void put_emitter(const struct lx_emitter *emitter, double reach, lx_bounded *to)
{
    const struct lx_profile *profile = &emitter->profile;
    const bool by_angle = profile->falloff == LX_LINEAR;
    put3(&to[LX_BY_ORIGIN], lx_is_endless(emitter) ? emitter->towards : rounded3(emitter->position_mm, reach));
    to[LX_BY_STRENGTH] = rounded(emitter->strength);
    to[LX_BY_STRENGTH].error += emitter->strength_error;
    put3(&to[LX_BY_AXIS], profile->axis);
    to[LX_BY_INNER] = by_angle ? profile->inner_rad : profile->inner_versine;
    to[LX_BY_OUTER] = by_angle ? profile->outer_rad : profile->outer_versine;
    to[LX_BY_PATTERN] = rounded(profile->exponent);
    put3(&to[LX_BY_LAW], rounded3(emitter->coefficients, greatest3(emitter->coefficients)));
    if (emitter->attenuation == LX_PRACTICAL)
        to[LX_BY_LAW] = rounded(emitter->k_mm);
}

static void put_lobe(const struct lx_lobe *lobe, lx_bounded *to)
{
    to[0] = lobe->diffuse;
    to[1] = lobe->specular;
    to[2] = rounded(lobe->exponent);
    to[3] = lobe->ambient;
}

static void put_shape(const struct lx_shape *shape, lx_bounded *to)
{
    const double *axis = shape->axis, *error = shape->axis_error;
    put3(&to[0], rounded3(shape->anchor_mm, greatest3(shape->anchor_mm) + shape->radius_mm));
    to[3] = rounded(shape->radius_mm);
    for (int k = 0; k < 3; k++)
        to[4 + k] = (lx_bounded){axis[k], error[k]};
}

static void put_camera(const struct lx_camera *camera, lx_bounded *to)
{
    put3(&to[0], rounded3(camera->position_mm, greatest3(camera->position_mm)));
    put3(&to[3], rounded3(camera->frame.origin_mm, greatest3(camera->frame.origin_mm)));
    for (int k = 0; k < 3; k++)
        put3(&to[6 + 3 * k], camera->frame.rounded[k]);
}

/* Whether a lobe is a power, or has no highlight, even where its weight is 0. */
static bool is_known(const struct lx_lobe *lobe)
{
    return !lx_lobe_is_rough(lobe) && (!lx_lobe_kind_of(lobe)->value || lx_lobe_kind_of(lobe)->power);
}

static bool are_known(const struct lx_prepared *prepared, bool bright)
{
    const struct lx_emitters *emitters = &prepared->emitters;
    bool known = emitters->count <= MOST_EMITTERS;
    for (size_t i = 0; i < emitters->count && known; i++) {
        struct lx_emitter room;
        known = lx_world_is_vectored(prepared, lx_emitter_at(emitters, i, &room));
    }
    for (size_t i = 0; i < prepared->surface_count && known && bright; i++)
        known = is_known(&prepared->surfaces[i].lobe);
    for (size_t i = 0; i < lx_material_count(prepared->scene) && known && bright; i++)
        known = is_known(&prepared->authored[i].lobe);
    return known && prepared->mirrors.count == 0;
}

int lx_constants_make(const struct lx_prepared *prepared, bool bright, struct lx_constants *constants)
{
    struct lx_constants made = {.emitters = prepared->emitters.count,
                                .surfaces = prepared->surface_count,
                                .authored = lx_material_count(prepared->scene)};
    *constants = (struct lx_constants){.count = 0};
    if (!are_known(prepared, bright))
        return -1;
    const double reach = reach_of(&prepared->emitters);
    made.count = of_camera(&made) + LX_OF_CAMERA;
    made.list = lx_new_array(made.count, sizeof *made.list);
    if (!made.list)
        return -1;
    for (size_t i = 0; i < made.emitters; i++) {
        struct lx_emitter room;
        put_emitter(lx_emitter_at(&prepared->emitters, i, &room), reach, &made.list[i * LX_OF_EMITTER]);
    }
    for (size_t i = 0; i < made.surfaces; i++) {
        put_lobe(&prepared->surfaces[i].lobe, &made.list[of_lobe(&made, i)]);
        put_shape(&prepared->surfaces[i].shape, &made.list[of_shape(&made, i)]);
    }
    for (size_t i = 0; i < made.authored; i++)
        put_lobe(&prepared->authored[i].lobe, &made.list[of_authored(&made, i)]);
    put_camera(&prepared->camera, &made.list[of_camera(&made)]);
    *constants = made;
    return 0;
}

void lx_constants_clear(struct lx_constants *constants)
{
    free(constants->list);
    *constants = (struct lx_constants){.count = 0};
}

static bool emitters_are_alike(const struct lx_emitter *a, const struct lx_emitter *b)
{
    return a->type == b->type && a->light == b->light && a->attenuation == b->attenuation &&
           a->profile.falloff == b->profile.falloff && !a->profile.luminaire == !b->profile.luminaire;
}

static bool lobes_are_alike(const struct lx_lobe *a, const struct lx_lobe *b)
{
    return a->model == b->model && a->highlight == b->highlight && a->diffuse_model == b->diffuse_model &&
           memcmp(a->own, b->own, sizeof a->own) == 0 &&
           memcmp(a->diffuse_own, b->diffuse_own, sizeof a->diffuse_own) == 0;
}

bool lx_constants_are_alike(const struct lx_prepared *a, const struct lx_prepared *b)
{
    bool alike = a->emitters.count == b->emitters.count && a->surface_count == b->surface_count &&
                 a->camera.is_parallel == b->camera.is_parallel && a->camera.is_perspective == b->camera.is_perspective;
    for (size_t i = 0; i < a->emitters.count && alike; i++) {
        struct lx_emitter rooms[2];
        alike =
            emitters_are_alike(lx_emitter_at(&a->emitters, i, &rooms[0]), lx_emitter_at(&b->emitters, i, &rooms[1]));
    }
    for (size_t i = 0; i < a->surface_count && alike; i++) {
        const struct lx_prepared_surface *one = &a->surfaces[i], *other = &b->surfaces[i];
        alike = one->shape.kind == other->shape.kind && one->authored == other->authored && one->part == other->part &&
                lobes_are_alike(&one->lobe, &other->lobe);
    }
    for (size_t i = 0; i < lx_material_count(a->scene) && alike; i++)
        alike = lobes_are_alike(&a->authored[i].lobe, &b->authored[i].lobe);
    return alike;
}

/* ---- rates ---- */

static int by_constant(const void *a, const void *b)
{
    const struct lx_rate *one = a, *other = b;
    if (one->constant != other->constant)
        return one->constant < other->constant ? -1 : 1;
    return (one->number > other->number) - (one->number < other->number);
}

void lx_slopes_sort(struct lx_slopes *slopes)
{
    if (slopes->rate_count > 0)
        qsort(slopes->rates, slopes->rate_count, sizeof *slopes->rates, by_constant);
}

void lx_slopes_clear(struct lx_slopes *slopes)
{
    lx_constants_clear(&slopes->constants);
    free(slopes->rates);
    free(slopes->numbers);
    *slopes = (struct lx_slopes){.number_count = 0};
}

/* The first rate of a constant of at least `constant`. */
static size_t first_of(const struct lx_slopes *slopes, size_t constant)
{
    size_t low = 0, high = slopes->rate_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (slopes->rates[middle].constant < constant)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* What number k makes of `count` constants from `constant` on: false where it changes none. */
static bool find_rates(const struct lx_slopes *slopes, size_t constant, size_t count, size_t k, lx_bounded *rates)
{
    bool any = false;
    for (size_t i = 0; i < count; i++)
        rates[i] = lx_exact(0);
    for (size_t r = first_of(slopes, constant); r < slopes->rate_count && slopes->rates[r].constant < constant + count;
         r++)
        if (slopes->rates[r].number == k) {
            lx_bounded *sum = &rates[slopes->rates[r].constant - constant];
            *sum = lx_is_zero(*sum) ? slopes->rates[r].rate : lx_add(*sum, slopes->rates[r].rate);
            any = true;
        }
    return any;
}

/* ---- what moves beneath a line of sight ---- */

static lx_bounded3 get3(const lx_bounded *from)
{
    return (lx_bounded3){from[0], from[1], from[2]};
}

/* a + f b */
static lx_bounded3 add_times3(lx_bounded3 a, lx_bounded3 b, lx_bounded f)
{
    return lx_add3(a, lx_mul3(b, f));
}

/* An element and the changes of its place, normal and view. */
struct motion {
    lx_bounded3 place, normal, view;
};

/* How the view turns with a place and the observer's. */
static lx_bounded3 turn_view(const struct lx_camera *camera, lx_bounded3 place_mm, lx_bounded3 moved,
                             const lx_bounded *of_camera)
{
    if (camera->is_parallel)
        return get3(&of_camera[12]);
    const lx_bounded3 way = lx_sub3(lx_exact3(camera->position_mm), place_mm), view = lx_unit3(way);
    const lx_bounded3 change = lx_sub3(get3(of_camera), moved);
    const lx_bounded3 across = lx_sub3(change, lx_mul3(view, lx_dot3(change, view)));
    const lx_bounded inverse = lx_div(lx_exact(1), lx_length3(way));
    return lx_mul3(across, inverse);
}

/* Lines of sight that graze a surface more than this slide over it. */
static const double GRAZING = 1e-6;

/* The motion of what a line of sight meets on a shape; false: that is not known. */
static bool find_motion(const struct lx_prepared *prepared, const struct lx_element *element, const double at_mm[2],
                        const lx_bounded *shape_rates, const lx_bounded *camera_rates, struct motion *motion)
{
    const struct lx_shape *shape = &element->own->shape;
    const struct lx_camera *camera = &prepared->camera;
    const struct lx_ray ray = lx_line_of_sight(camera, at_mm[0], at_mm[1]);
    const lx_bounded3 direction = lx_ray_direction(&ray), place = element->place_mm, normal = element->normal;
    const lx_bounded3 anchor = lx_exact3(shape->anchor_mm), moved_anchor = get3(shape_rates);
    const bool is_round = lx_curvature(shape) > 0;
    const lx_bounded3 origin = {{ray.origin_mm[0], ray.origin_error[0]},
                                {ray.origin_mm[1], ray.origin_error[1]},
                                {ray.origin_mm[2], ray.origin_error[2]}};
    const lx_bounded length = lx_square3(direction);
    const lx_bounded t = lx_div(lx_dot3(lx_sub3(place, origin), direction), length);
    const lx_bounded3 aside = lx_add3(lx_mul3(get3(&camera_rates[6]), lx_exact(at_mm[0])),
                                      lx_mul3(get3(&camera_rates[9]), lx_exact(at_mm[1])));
    lx_bounded3 moved = lx_add3(get3(camera_rates), aside), turned = lx_negate3(get3(&camera_rates[12]));
    if (camera->is_perspective) {
        moved = get3(camera_rates);
        turned = lx_add3(lx_sub3(get3(&camera_rates[3]), moved), aside);
    }
    const lx_bounded3 along = add_times3(moved, turned, t), from = lx_sub3(place, anchor);
    const lx_bounded facing = lx_dot3(normal, direction);
    if (!(fabs(facing.value) > GRAZING * sqrt(length.value)))
        return false;
    const bool is_outside = lx_dot3(normal, from).value > 0;
    const lx_bounded3 axis = {{shape->axis[0], shape->axis_error[0]},
                              {shape->axis[1], shape->axis_error[1]},
                              {shape->axis[2], shape->axis_error[2]}};
    const bool is_front = lx_dot3(normal, axis).value > 0;
    const lx_bounded3 tilt = is_front ? get3(&shape_rates[4]) : lx_negate3(get3(&shape_rates[4]));
    const lx_bounded grown = is_outside ? shape_rates[3] : lx_negate(shape_rates[3]);
    const lx_bounded rises = is_round ? grown : lx_negate(lx_dot3(from, tilt));
    const lx_bounded later = lx_div(lx_add(lx_dot3(normal, lx_sub3(moved_anchor, along)), rises), facing);
    motion->place = add_times3(along, direction, later);
    motion->normal = tilt;
    if (is_round) {
        const lx_bounded inverse = lx_div(lx_exact(is_outside ? 1 : -1), lx_exact(shape->radius_mm));
        motion->normal = lx_mul3(lx_sub3(lx_sub3(motion->place, moved_anchor), lx_mul3(normal, grown)), inverse);
    }
    motion->view = turn_view(camera, place, motion->place, camera_rates);
    return true;
}

/* Whether the same surface is seen all around a point of the screen. */
static bool is_seen_around(const struct lx_prepared *prepared, const struct lx_element *element, const double at_mm[2])
{
    static const double ways[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const struct lx_screen *screen = &prepared->scene->screen;
    const double step = 1e-8 * (screen->width_mm + screen->height_mm);
    bool same = true;
    for (int i = 0; i < 4 && same; i++) {
        struct lx_element beside;
        same = lx_element_seen(prepared, at_mm[0] + ways[i][0] * step, at_mm[1] + ways[i][1] * step, &beside) &&
               beside.own == element->own;
    }
    return same;
}

/* ---- slopes ---- */

static void add_scaled(struct lx_column *sum, size_t i, const struct lx_column *by, lx_bounded rate)
{
    const lx_bounded made = lx_add(lx_column_get(sum, i), lx_mul(lx_column_get(by, i), rate));
    sum->value[i] = made.value;
    sum->error[i] = made.error;
}

static void add_scaled3(struct lx_column *sum, size_t i, const struct lx_gradient *gradient, unsigned by,
                        lx_bounded3 rate)
{
    add_scaled(sum, i, &gradient->by[by], rate.x);
    add_scaled(sum, i, &gradient->by[by + 1], rate.y);
    add_scaled(sum, i, &gradient->by[by + 2], rate.z);
}

/* What a number that moves elements of a batch adds, where it does. */
static void add_motion(const struct lx_world *world, const struct lx_slopes *slopes, const struct lx_elements *elements,
                       const double (*screen_mm)[2], bool have_views, size_t k, const struct lx_gradient *gradient,
                       struct lx_column *sum, bool in_doubt[LX_BATCH])
{
    const struct lx_prepared *prepared = world->prepared;
    lx_bounded camera_rates[LX_OF_CAMERA];
    const bool is_observer = find_rates(slopes, of_camera(&slopes->constants), LX_OF_CAMERA, k, camera_rates);
    for (size_t i = 0; i < elements->count; i++) {
        lx_bounded rates[LX_OF_SHAPE];
        struct motion motion;
        const struct lx_element element = lx_elements_get(prepared, elements, i);
        const bool is_moved = element.own && find_rates(slopes, of_shape(&slopes->constants, elements->own[i] - 1),
                                                        LX_OF_SHAPE, k, rates);
        const bool is_meant = element.own && element.own->authored + 1 == slopes->numbers[k].surface;
        if (!is_moved && !is_observer && !is_meant)
            continue;
        const struct lx_shape *shape = element.own ? &element.own->shape : NULL;
        const bool has_motion = shape && lx_curvature(shape) >= 0;
        if (!screen_mm) {
            in_doubt[i] = in_doubt[i] || is_moved || is_meant;
            if (is_observer && !have_views)
                add_scaled3(
                    sum, i, gradient, LX_BY_VIEW,
                    turn_view(&prepared->camera, element.place_mm, lx_exact3((double[]){0, 0, 0}), camera_rates));
        } else if (has_motion && find_motion(prepared, &element, screen_mm[i], rates, camera_rates, &motion)) {
            add_scaled3(sum, i, gradient, LX_BY_PLACE, motion.place);
            add_scaled3(sum, i, gradient, LX_BY_NORMAL, motion.normal);
            add_scaled3(sum, i, gradient, LX_BY_VIEW, motion.view);
        } else {
            in_doubt[i] = true;
        }
    }
}

/* Where the constants of a batch's lobe begin. */
static size_t lobe_constants(const struct lx_prepared *prepared, const struct lx_constants *all,
                             const struct lx_lobe *lobe)
{
    for (size_t i = 0; i < all->surfaces; i++)
        if (lobe == &prepared->surfaces[i].lobe)
            return of_lobe(all, i);
    for (size_t i = 0; i < all->authored; i++)
        if (lobe == &prepared->authored[i].lobe)
            return of_authored(all, i);
    return of_shape(all, 0); /* none, whose constants come before */
}

/* What of an emitter's gradient rates ask for, from one of them to that of its last constant. */
static unsigned needs_of(const struct lx_slopes *slopes, size_t rate, size_t constant)
{
    unsigned needs = 0;
    for (; rate < slopes->rate_count && slopes->rates[rate].constant < constant + LX_OF_EMITTER; rate++) {
        const unsigned by = (unsigned)(slopes->rates[rate].constant - constant);
        needs |= LX_BIT_BY(by < LX_BY_STRENGTH                    ? LX_BY_ORIGIN
                           : by >= LX_BY_AXIS && by < LX_BY_INNER ? LX_BY_AXIS
                           : by >= LX_BY_LAW                      ? LX_BY_LAW
                                                                  : by);
    }
    return needs;
}

/* What of gradients by the elements is asked for. */
static unsigned needs_of_elements(const struct lx_slopes *slopes, size_t lobe, enum lx_wanted wanted)
{
    static const unsigned by_lobe[LX_OF_LOBE] = {LX_BY_DIFFUSE, LX_BY_SPECULAR, LX_BY_SHININESS, LX_BY_AMBIENT};
    unsigned needs = slopes->moves ? LX_BIT_BY(LX_BY_PLACE) | LX_BIT_BY(LX_BY_NORMAL) | LX_BIT_BY(LX_BY_VIEW) : 0;
    for (size_t r = first_of(slopes, lobe);
         wanted == LX_WANT_BRIGHTNESS && r < slopes->rate_count && slopes->rates[r].constant < lobe + LX_OF_LOBE; r++)
        needs |= LX_BIT_BY(by_lobe[slopes->rates[r].constant - lobe]);
    return needs;
}

static void add_rates(const struct lx_world *world, const struct lx_slopes *slopes, size_t constant, size_t count,
                      const struct lx_column *by, size_t elements, struct lx_column *sums)
{
    for (size_t r = first_of(slopes, constant); r < slopes->rate_count && slopes->rates[r].constant < constant + count;
         r++) {
        const struct lx_rate *rate = &slopes->rates[r];
        world->kernels->add_rate(&by[rate->constant - constant], rate->rate, elements, &sums[rate->number]);
    }
}

void lx_slope_elements(const struct lx_world *world, const struct lx_slopes *slopes, const struct lx_elements *elements,
                       enum lx_wanted wanted, const double (*screen_mm)[2], bool have_views, struct lx_column *sums,
                       bool in_doubt[LX_BATCH])
{
    const struct lx_prepared *prepared = world->prepared;
    const size_t lobe = lobe_constants(prepared, &slopes->constants, elements->lobe), count = elements->count;
    const unsigned of_elements = needs_of_elements(slopes, lobe, wanted);
    struct lx_gradient gradient;
    for (unsigned by = LX_BY_EMITTER; by < LX_BY_ALL; by++)
        lx_column_clear(&gradient.by[by], count);
    memset(gradient.in_doubt, 0, sizeof gradient.in_doubt);
    for (size_t k = 0; k < slopes->number_count; k++)
        lx_column_clear(&sums[k], count);
    for (size_t e = 0; e < slopes->constants.emitters; e++) {
        struct lx_emitter room;
        const size_t constant = e * LX_OF_EMITTER;
        const unsigned needs = of_elements | needs_of(slopes, first_of(slopes, constant), constant);
        lx_world_gradient(world, elements, lx_emitter_at(&prepared->emitters, e, &room), wanted, needs, &gradient);
        add_rates(world, slopes, constant, LX_OF_EMITTER, gradient.by, count, sums);
    }
    if (wanted == LX_WANT_BRIGHTNESS)
        add_rates(world, slopes, lobe, LX_OF_LOBE, &gradient.by[LX_BY_DIFFUSE], count, sums);
    for (size_t i = 0; i < count; i++)
        in_doubt[i] = gradient.in_doubt[i];
    for (size_t k = 0; k < slopes->number_count; k++)
        if (slopes->numbers[k].is_known && slopes->numbers[k].moves)
            add_motion(world, slopes, elements, screen_mm, have_views, k, &gradient, &sums[k], in_doubt);
    for (size_t i = 0; slopes->moves && screen_mm && i < count; i++) {
        const struct lx_element element = lx_elements_get(prepared, elements, i);
        in_doubt[i] = in_doubt[i] || !is_seen_around(prepared, &element, screen_mm[i]);
    }
}
