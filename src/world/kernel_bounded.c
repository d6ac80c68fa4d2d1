/* SPDX-License-Identifier: MIT */
/*
 * The reference on batches of elements (elements.h), compiled once for each instruction set as kernel.c is, but without
 * contraction: making unit vectors and views, what stands in the way of light, and the light of points and directions,
 * with its gradients.  The functions are those of light/emitter.c, material/ and reference.c, operation by operation.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../kernel/kernel_law.h"
#include "../surface/beside.h"
#include "kernel_elements.h"

#include "../kernel/lanes_double.h"

#include "bounded_lanes.h"

LX_LANE struct bounded load_bounded(const struct lx_column *column, size_t i)
{
    return (struct bounded){load_double(column->value + i), load_double(column->error + i)};
}

LX_LANE void store_bounded(struct lx_column *column, size_t i, struct bounded number)
{
    store_double(column->value + i, number.value);
    store_double(column->error + i, number.error);
}

LX_LANE struct bounded3 load_bounded3(const struct lx_columns3 *columns, size_t i)
{
    return (struct bounded3){load_bounded(&columns->x, i), load_bounded(&columns->y, i), load_bounded(&columns->z, i)};
}

LX_LANE void store_bounded3(struct lx_columns3 *columns, size_t i, struct bounded3 vector)
{
    store_bounded(&columns->x, i, vector.x);
    store_bounded(&columns->y, i, vector.y);
    store_bounded(&columns->z, i, vector.z);
}

LX_LANE void add_to(struct lx_column *sum, size_t i, struct bounded number)
{
    store_bounded(sum, i, plus(load_bounded(sum, i), number));
}

static void unit(struct lx_columns3 *columns, size_t count)
{
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const struct bounded3 made = {
            exactly(load_double(columns->x.value + i)),
            exactly(load_double(columns->y.value + i)),
            exactly(load_double(columns->z.value + i)),
        };
        store_bounded3(columns, i, unit3(made, NULL));
    }
}

static void look_at(const double place_mm[3], struct lx_elements *elements)
{
    const struct bounded3 eye = everywhere3(lx_exact3(place_mm));
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double)
        store_bounded3(&elements->view, i, unit3(minus3(eye, load_bounded3(&elements->place_mm, i)), NULL));
}

static void sum(const struct lx_received *received, enum lx_wanted wanted, size_t count, struct lx_column *value,
                struct lx_column *total)
{
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const struct bounded made = wanted == LX_WANT_IRRADIANCE ? load_bounded(&received->irradiance, i)
                                                                 : plus(load_bounded(&received->diffuse, i),
                                                                        load_bounded(&received->specular, i));
        store_bounded(value, i, made);
        add_to(total, i, made);
    }
}

/* ---- light ---- */

LX_LANE struct bounded metres(struct bounded length_mm)
{
    return over_exactly(length_mm, 1000);
}

LX_LANE struct bounded attenuation(const struct lx_emitter *emitter, struct bounded distance_m)
{
    const struct bounded one = exactly(all_double(1));
    const double *coefficients = emitter->coefficients;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return over(one, times(distance_m, distance_m));
    case LX_PRACTICAL: return over(one, plus(metres(exactly(all_double(emitter->k_mm))), distance_m));
    case LX_POLYNOMIAL:
        return over(one, plus(exactly(all_double(coefficients[0])),
                              times(distance_m, plus(exactly(all_double(coefficients[1])),
                                                     times(distance_m, exactly(all_double(coefficients[2])))))));
    case LX_NO_ATTENUATION: break;
    }
    return one;
}

LX_LANE struct bounded clamp01(struct bounded a)
{
    const lanes_double one = all_double(1), zero = all_double(0);
    const struct bounded low = positive(a);
    return (struct bounded){
        where_above_double(one, a.value, low.value, one),
        where_above_double(one, a.value, low.error, greater_double(a.error - (a.value - 1), zero)),
    };
}

LX_LANE struct bounded cone(const struct lx_profile *profile, struct bounded cosine, struct bounded sine_squared)
{
    const struct bounded one = exactly(all_double(1)), outer = everywhere(profile->outer_versine);
    const struct bounded near = over(sine_squared, plus(one, cosine)), far = minus(one, cosine);
    const struct bounded versine = {where_above_double(cosine.value, all_double(0), near.value, far.value),
                                    where_above_double(cosine.value, all_double(0), near.error, far.error)};
    const struct bounded inside = minus(outer, versine);
    if (profile->falloff == LX_HARD)
        return step(inside, true);
    if (profile->falloff == LX_LINEAR)
        return clamp01(over(minus(everywhere(profile->outer_rad), angle(root_of(sine_squared), cosine)),
                            minus(everywhere(profile->outer_rad), everywhere(profile->inner_rad))));
    const struct bounded t = clamp01(over(inside, minus(outer, everywhere(profile->inner_versine))));
    if (profile->falloff == LX_SQUARED)
        return times(t, t);
    return times(times(t, t), minus(exactly(all_double(3)), scaled(t, all_double(2))));
}

LX_LANE struct bounded profile_value(const struct lx_profile *profile, struct bounded3 towards)
{
    const struct bounded3 axis = everywhere3(profile->axis);
    const struct bounded cosine = negated(dot3(axis, towards)), sine_squared = square3(cross3(axis, towards));
    const struct bounded power = cosine_power(cosine, sine_squared, profile->exponent);
    if (profile->falloff == LX_NO_CONE)
        return times_exactly(power, all_double(1));
    return times(cone(profile, cosine, sine_squared), power);
}

/* L and E_perp. */
struct sample {
    struct bounded3 towards;
    struct bounded e_perp;
};

/* As of a point that is away from the elements; tells those that it may lie on. */
LX_LANE struct sample sample_point(const struct lx_emitter *emitter, struct bounded3 place, bool *on_element)
{
    struct sample sample;
    struct bounded distance;
    const struct bounded3 offset = minus3(everywhere3(lx_exact3(emitter->position_mm)), place);
    sample.towards = unit3(offset, &distance);
    for (int i = 0; !all_above_double(distance.value, distance.error) && i < LX_WIDTH_double; i++)
        on_element[i] = on_element[i] || !(distance.value[i] > distance.error[i]);
    const struct bounded strength = everywhere(lx_strength(emitter));
    const struct lx_profile *profile = &emitter->profile;
    const struct bounded e_perp = times(strength, attenuation(emitter, metres(distance)));
    if (profile->falloff == LX_NO_CONE && profile->exponent == 0)
        sample.e_perp = times_exactly(e_perp, all_double(1));
    else
        sample.e_perp = times(e_perp, profile_value(profile, sample.towards));
    return sample;
}

/* f of a lobe that is no power, lane by lane as the reference has it. */
static struct bounded lobe_value(const struct lx_lobe *lobe, struct bounded3 normal, struct bounded3 view,
                                 struct bounded3 towards)
{
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    struct bounded made = exactly(all_double(0));
    const struct bounded3 *vectors[3] = {&normal, &view, &towards};
    for (int i = 0; i < LX_WIDTH_double; i++) {
        lx_bounded3 one[3];
        for (int k = 0; k < 3; k++)
            one[k] = (lx_bounded3){{vectors[k]->x.value[i], vectors[k]->x.error[i]},
                                   {vectors[k]->y.value[i], vectors[k]->y.error[i]},
                                   {vectors[k]->z.value[i], vectors[k]->z.error[i]}};
        const lx_bounded value = kind->value(lobe, one[0], one[1], one[2]);
        made.value[i] = value.value;
        made.error[i] = value.error;
    }
    return made;
}

/* S^n by the cosine and the squared sine of the angle that S is the cosine of. */
LX_LANE struct bounded lobe_power(const struct lx_lobe *lobe, struct bounded3 normal, struct bounded3 view,
                                  struct bounded3 towards)
{
    if (LX_IS_BY_HALF(lobe->model)) {
        const struct bounded3 half = unit3(plus3(towards, view), NULL);
        return cosine_power(dot3(normal, half), square3(cross3(normal, half)), lobe->exponent);
    }
    const struct bounded twice = scaled(dot3(normal, towards), all_double(2));
    const struct bounded3 mirrored = minus3(times3(normal, twice), towards);
    return cosine_power(dot3(mirrored, view), square3(cross3(mirrored, view)), lobe->exponent);
}

LX_LANE struct bounded highlight_weight(const struct lx_lobe *lobe, struct bounded n_dot_l)
{
    if (LX_JUMPS_AT_HORIZON(lobe->highlight))
        return step(n_dot_l, false);
    return LX_FALLS_TO_HORIZON(lobe->highlight) ? positive(n_dot_l) : exactly(all_double(1));
}

/* N.L; normals along an axis have no errors, and parts that are 0. */
LX_LANE struct bounded dot_normal(const struct lx_elements *elements, struct bounded3 normal, struct bounded3 towards)
{
    if (!elements->has_exact_normals)
        return dot3(normal, towards);
    return plus(plus(times_exactly(towards.x, normal.x.value), times_exactly(towards.y, normal.y.value)),
                times_exactly(towards.z, normal.z.value));
}

static void light_uniform(const struct lx_emitter *emitter, const struct lx_elements *elements, enum lx_wanted wanted,
                          struct lx_received *received)
{
    const lx_bounded e = lx_strength(emitter);
    const struct bounded e_perp = everywhere(e), diffuse = everywhere(lx_mul(elements->lobe->ambient, e));
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        if (wanted & LX_WANT_IRRADIANCE)
            add_to(&received->irradiance, i, e_perp);
        if (!(wanted & LX_WANT_BRIGHTNESS))
            continue;
        add_to(&received->diffuse, i, diffuse);
        add_to(&received->specular, i, exactly(all_double(0)));
    }
}

static void light(const struct lx_emitter *emitter, const struct lx_elements *elements, const struct lx_column *open,
                  enum lx_wanted wanted, struct lx_received *received)
{
    const struct lx_lobe *lobe = elements->lobe;
    const bool is_rough = lx_lobe_is_rough(lobe), is_power = lx_power_lobe_of(lobe->model);
    const struct lx_lobe rough = is_rough ? lx_lobe_of_diffuse(lobe) : *lobe;
    const struct sample everywhere_same = {everywhere3(emitter->towards), everywhere(lx_strength(emitter))};
    if (lx_is_uniform(emitter)) {
        light_uniform(emitter, elements, wanted, received);
        return;
    }
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct bounded3 normal = load_bounded3(&elements->normal, i);
        const struct sample sample =
            lx_is_endless(emitter)
                ? everywhere_same
                : sample_point(emitter, load_bounded3(&elements->place_mm, i), received->on_element + i);
        const struct bounded n_dot_l = dot_normal(elements, normal, sample.towards), cosine = positive(n_dot_l);
        const struct bounded e_perp =
            open ? times(sample.e_perp, load_bounded(open, i)) : times_exactly(sample.e_perp, all_double(1));
        if (wanted & LX_WANT_IRRADIANCE)
            add_to(&received->irradiance, i, times(e_perp, cosine));
        if (!(wanted & LX_WANT_BRIGHTNESS))
            continue;
        const struct bounded3 view = load_bounded3(&elements->view, i);
        struct bounded specular = exactly(all_double(0));
        if (lobe->specular.value > 0)
            specular = times(times(everywhere(lobe->specular), highlight_weight(lobe, n_dot_l)),
                             is_power ? lobe_power(lobe, normal, view, sample.towards)
                                      : lobe_value(lobe, normal, view, sample.towards));
        struct bounded diffuse = times(everywhere(lobe->diffuse), cosine);
        if (is_rough)
            diffuse = times(diffuse, lobe_value(&rough, normal, view, sample.towards));
        add_to(&received->diffuse, i, times(e_perp, diffuse));
        add_to(&received->specular, i, times(e_perp, specular));
    }
}

#include "kernel_occlusion.h"

#include "kernel_gradient.h"

extern const struct lx_element_kernels LX_OF_ISA(lx_element_kernels);
const struct lx_element_kernels LX_OF_ISA(lx_element_kernels) = {
    .unit = unit,
    .look_at = look_at,
    .sum = sum,
    .light = light,
    .gradient = gradient,
    .add_rate = add_rate,
    .close_own = close_own,
    .hold = LX_BY_SHAPE(hold),
    .close = LX_BY_SHAPE(close),
    .settle = LX_BY_SHAPE(settle),
};
