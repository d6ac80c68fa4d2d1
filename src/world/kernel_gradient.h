/* SPDX-License-Identifier: MIT */
/*
 * Gradients of the light of points and directions, by the rules of differentiation applied to what light() computes, of
 * a batch of elements at once, with bounds.  kernel_bounded.c includes it behind light().
 *
 * Where the value jumps or turns nearby, as at the horizon, a cone's edge or the border of a shadow, the element is in
 * doubt: what it has there are the rules of one side.
 */

/* Cosines, and shares of a penumbra, that are nearer to where a rule changes. */
#define NEAR_CHANGE 0x1p-24

/* 1 where a number is about 0, or none. */
LX_LANE lanes_double is_near(lanes_double a)
{
    return not_so(is_above(size_of(a), all_double(NEAR_CHANGE)));
}

LX_LANE struct bounded where_positive(lanes_double a, struct bounded number)
{
    const lanes_double zero = all_double(0);
    return (struct bounded){only_above(a, zero, number.value), only_above(a, zero, number.error)};
}

/* The logarithm of a cosine above 0, also known by the squared sine. */
static struct bounded log_of(struct bounded cosine, struct bounded sine_squared)
{
    struct bounded made = exactly(all_double(0));
    for (int i = 0; i < LX_WIDTH_double; i++) {
        const lx_bounded c = {cosine.value[i], cosine.error[i]}, s = {sine_squared.value[i], sine_squared.error[i]};
        const lx_bounded found =
            s.value < 0.5 ? lx_scale(lx_log1p(lx_negate(s)), 0.5) : lx_log1p(lx_sub(c, lx_exact(1)));
        made.value[i] = c.value > 0 ? found.value : 0;
        made.error[i] = c.value > 0 ? found.error : 0;
    }
    return made;
}

/* c^n for the cosine of an angle, 0 below 0, and its derivatives; `in_doubt` where it turns at 0. */
struct power_slopes {
    struct bounded value, by_cosine, by_exponent;
    lanes_double in_doubt;
};

LX_LANE struct power_slopes power_slopes(struct bounded cosine, struct bounded sine_squared, double exponent,
                                         bool wants_exponent)
{
    const struct bounded none = exactly(all_double(0));
    struct power_slopes power = {cosine_power(cosine, sine_squared, exponent), none, none, all_double(0)};
    if (exponent > 0)
        power.by_cosine = where_positive(cosine.value, times_exactly(over(power.value, cosine), all_double(exponent)));
    if (wants_exponent)
        power.by_exponent = where_positive(cosine.value, times(power.value, log_of(cosine, sine_squared)));
    if (exponent > 0 && exponent < 2)
        power.in_doubt = is_near(cosine.value);
    if (exponent == 0 && wants_exponent)
        power.in_doubt = not_so(is_above(cosine.value, all_double(NEAR_CHANGE)));
    return power;
}

/* g of a profile, and its derivatives by the cosine to the axis and by its own numbers. */
struct profile_slopes {
    struct bounded value, by_cosine, by_inner, by_outer, by_exponent;
    lanes_double in_doubt;
};

/* A cone's f(t), with t falling from 1 at the inner to 0 at the outer angle, linear in a measure m of the angle. */
LX_LANE void add_cone(const struct lx_profile *profile, struct bounded cosine, struct bounded sine_squared,
                      struct profile_slopes *slopes)
{
    const lanes_double zero = all_double(0), one = all_double(1);
    const bool by_angle = profile->falloff == LX_LINEAR;
    const struct bounded outer = everywhere(by_angle ? profile->outer_rad : profile->outer_versine);
    const struct bounded inner_end = everywhere(by_angle ? profile->inner_rad : profile->inner_versine);
    const struct bounded near = over(sine_squared, plus(exactly(one), cosine)), far = minus(exactly(one), cosine);
    const struct bounded versine = {where_above_double(cosine.value, zero, near.value, far.value),
                                    where_above_double(cosine.value, zero, near.error, far.error)};
    const struct bounded sine = root_of(sine_squared);
    const struct bounded measure = by_angle ? angle(sine, cosine) : versine, inside = minus(outer, measure);
    const struct bounded f = cone(profile, cosine, sine_squared);
    const struct bounded pattern = slopes->value;
    slopes->value = times(f, pattern);
    slopes->by_exponent = times(f, slopes->by_exponent);
    slopes->by_cosine = times(f, slopes->by_cosine);
    if (profile->falloff == LX_HARD) {
        slopes->in_doubt = either(slopes->in_doubt, is_near(inside.value));
        return;
    }
    const struct bounded width = minus(outer, inner_end), t = over(inside, width);
    struct bounded steep = exactly(one); /* df/dt */
    if (profile->falloff == LX_SQUARED)
        steep = scaled(t, all_double(2));
    if (profile->falloff == LX_SMOOTHSTEP)
        steep = times_exactly(times(t, minus(exactly(one), t)), all_double(6));
    steep = where_positive(t.value, where_positive(1 - t.value, times(over(steep, width), pattern)));
    slopes->in_doubt = either(slopes->in_doubt, either(is_near(t.value), is_near(1 - t.value)));
    /* dm/dc: -1 of the versine, -1/sin of the angle, of which a cone without an inner part has a tip */
    const struct bounded turn = by_angle ? where_positive(steep.value, over(steep, sine)) : steep;
    slopes->by_cosine = plus(slopes->by_cosine, turn);
    slopes->by_inner = times(steep, t);
    slopes->by_outer = times(steep, minus(exactly(one), t));
}

LX_LANE struct profile_slopes profile_slopes(const struct lx_profile *profile, struct bounded3 towards,
                                             bool wants_exponent)
{
    const struct bounded none = exactly(all_double(0));
    if (profile->falloff == LX_NO_CONE && profile->exponent == 0 && !wants_exponent)
        return (struct profile_slopes){exactly(all_double(1)), none, none, none, none, all_double(0)};
    const struct bounded3 axis = everywhere3(profile->axis);
    const struct bounded cosine = negated(dot3(axis, towards)), sine_squared = square3(cross3(axis, towards));
    const struct power_slopes power = power_slopes(cosine, sine_squared, profile->exponent, wants_exponent);
    struct profile_slopes slopes = {power.value, power.by_cosine, none, none, power.by_exponent, power.in_doubt};
    if (profile->falloff != LX_NO_CONE)
        add_cone(profile, cosine, sine_squared, &slopes);
    return slopes;
}

/* a(r) and its derivatives by the distance in mm and by the law's own numbers. */
struct law_slopes {
    struct bounded value, by_distance, by_own[3];
};

LX_LANE struct law_slopes law_slopes(const struct lx_emitter *emitter, struct bounded distance_mm)
{
    const struct bounded r = metres(distance_mm), none = exactly(all_double(0));
    struct law_slopes law = {attenuation(emitter, r), none, {none, none, none}};
    const struct bounded less = negated(times(law.value, law.value));
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: law.by_distance = over(scaled(negated(law.value), all_double(2)), distance_mm); break;
    case LX_PRACTICAL: law.by_distance = law.by_own[0] = over_exactly(less, 1000); break;
    case LX_POLYNOMIAL:
        law.by_own[0] = less;
        law.by_own[1] = times(less, r);
        law.by_own[2] = times(law.by_own[1], r);
        law.by_distance = over_exactly(plus(times_exactly(less, all_double(emitter->coefficients[1])),
                                            times_exactly(law.by_own[1], all_double(2 * emitter->coefficients[2]))),
                                       1000);
        break;
    case LX_NO_ATTENUATION: break;
    }
    return law;
}

/* What an element makes of light from L, for each unit of E_perp: C, and its derivatives. */
struct lobe_slopes {
    struct bounded value, by_diffuse, by_specular, by_shininess;
    struct bounded3 by_towards, by_normal, by_view;
    lanes_double in_doubt;
};

/* S^n and its derivatives. */
LX_LANE void add_highlight(const struct lx_lobe *lobe, struct bounded3 normal, struct bounded3 view,
                           struct bounded3 towards, struct bounded n_dot_l, bool wants_exponent,
                           struct lobe_slopes *slopes)
{
    struct bounded3 moving, fixed, by_towards, by_normal, by_view;
    if (LX_IS_BY_HALF(lobe->model)) {
        struct bounded length;
        moving = unit3(plus3(towards, view), &length);
        fixed = normal;
        const struct bounded3 aside = minus3(normal, times3(moving, dot3(normal, moving)));
        by_view = by_towards = (struct bounded3){over(aside.x, length), over(aside.y, length), over(aside.z, length)};
        by_normal = moving;
    } else {
        const struct bounded n_dot_v = scaled(dot3(normal, view), all_double(2));
        const struct bounded twice = scaled(n_dot_l, all_double(2));
        moving = minus3(times3(normal, twice), towards);
        fixed = view;
        by_towards = minus3(times3(normal, n_dot_v), view);
        by_view = moving;
        by_normal = plus3(times3(towards, n_dot_v), times3(view, twice));
    }
    const struct bounded cosine = dot3(fixed, moving);
    const struct power_slopes power =
        power_slopes(cosine, square3(cross3(fixed, moving)), lobe->exponent, wants_exponent);
    const struct bounded factor = everywhere(lobe->specular), weight = highlight_weight(lobe, n_dot_l);
    const struct bounded steep = times(times(factor, weight), power.by_cosine);
    const bool falls = LX_FALLS_TO_HORIZON(lobe->highlight);
    const struct bounded leans =
        falls ? where_positive(n_dot_l.value, times(factor, power.value)) : exactly(all_double(0));
    slopes->by_specular = times(weight, power.value);
    slopes->by_shininess = times(times(factor, weight), power.by_exponent);
    slopes->value = plus(slopes->value, times(factor, slopes->by_specular));
    slopes->by_towards = plus3(slopes->by_towards, plus3(times3(by_towards, steep), times3(normal, leans)));
    slopes->by_normal = plus3(slopes->by_normal, plus3(times3(by_normal, steep), times3(towards, leans)));
    slopes->by_view = times3(by_view, steep);
    slopes->in_doubt = either(slopes->in_doubt, power.in_doubt);
    if (LX_IS_BY_HALF(lobe->model)) /* opposite directions have no half */
        slopes->in_doubt = either(slopes->in_doubt, not_so(is_above(all_double(2), size_of(cosine.value))));
}

LX_LANE struct lobe_slopes lobe_slopes(const struct lx_lobe *lobe, struct bounded3 normal, struct bounded3 view,
                                       struct bounded3 towards, struct bounded n_dot_l, enum lx_wanted wanted,
                                       unsigned needs)
{
    const struct bounded none = exactly(all_double(0)), cosine = positive(n_dot_l);
    const struct bounded3 none3 = {none, none, none};
    const bool is_bright = wanted == LX_WANT_BRIGHTNESS;
    const struct bounded diffuse = is_bright ? everywhere(lobe->diffuse) : exactly(all_double(1));
    const struct bounded steep = where_positive(n_dot_l.value, diffuse);
    struct lobe_slopes slopes = {.value = times(diffuse, cosine),
                                 .by_diffuse = cosine,
                                 .by_specular = none,
                                 .by_shininess = none,
                                 .by_towards = times3(normal, steep),
                                 .by_normal = times3(towards, steep),
                                 .by_view = none3,
                                 .in_doubt = is_near(n_dot_l.value)};
    if (is_bright && (lobe->specular.value > 0 || needs & LX_BIT_BY(LX_BY_SPECULAR)))
        add_highlight(lobe, normal, view, towards, n_dot_l, needs & LX_BIT_BY(LX_BY_SHININESS), &slopes);
    return slopes;
}

LX_LANE void store3(struct lx_gradient *gradient, unsigned by, size_t i, struct bounded3 vector)
{
    store_bounded(&gradient->by[by], i, vector.x);
    store_bounded(&gradient->by[by + 1], i, vector.y);
    store_bounded(&gradient->by[by + 2], i, vector.z);
}

LX_LANE void add3_to(struct lx_gradient *gradient, unsigned by, size_t i, struct bounded3 vector)
{
    add_to(&gradient->by[by], i, vector.x);
    add_to(&gradient->by[by + 1], i, vector.y);
    add_to(&gradient->by[by + 2], i, vector.z);
}

static void gradient_uniform(const struct lx_emitter *emitter, const struct lx_elements *elements,
                             enum lx_wanted wanted, struct lx_gradient *gradient)
{
    const bool is_bright = wanted == LX_WANT_BRIGHTNESS;
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        store_bounded(&gradient->by[LX_BY_STRENGTH], i,
                      is_bright ? everywhere(elements->lobe->ambient) : exactly(all_double(1)));
        add_to(&gradient->by[LX_BY_AMBIENT], i, everywhere(lx_strength(emitter)));
    }
}

/* What an emitter gives to the elements from i on: all but L, the distance and C. */
struct light_slopes {
    struct bounded3 towards;
    struct bounded distance_mm, strength;
    struct law_slopes law;
    struct profile_slopes profile;
};

LX_LANE struct light_slopes light_slopes(const struct lx_emitter *emitter, struct bounded3 place, unsigned needs)
{
    const struct bounded one = exactly(all_double(1)), none = exactly(all_double(0));
    struct light_slopes light = {.strength = everywhere(lx_strength(emitter))};
    if (lx_is_endless(emitter)) {
        light.towards = everywhere3(emitter->towards);
        light.distance_mm = one;
        light.law = (struct law_slopes){one, none, {none, none, none}};
        light.profile = (struct profile_slopes){one, none, none, none, none, all_double(0)};
        return light;
    }
    light.towards = unit3(minus3(everywhere3(lx_exact3(emitter->position_mm)), place), &light.distance_mm);
    light.law = law_slopes(emitter, light.distance_mm);
    light.profile = profile_slopes(&emitter->profile, light.towards, needs & LX_BIT_BY(LX_BY_PATTERN));
    return light;
}

/* The derivative by the place of a point: across L it turns L, along L it changes the law. */
LX_LANE struct bounded3 by_origin(const struct light_slopes *light, const struct lobe_slopes *lobe,
                                  struct bounded3 axis, struct bounded strength)
{
    const struct bounded a = times(strength, light->law.value), e = times(a, light->profile.value);
    const struct bounded turn = negated(times(times(a, lobe->value), light->profile.by_cosine));
    const struct bounded3 by_towards = plus3(times3(lobe->by_towards, e), times3(axis, turn));
    const struct bounded along = dot3(by_towards, light->towards);
    const struct bounded3 across = minus3(by_towards, times3(light->towards, along));
    const struct bounded by_distance =
        times(times(strength, light->law.by_distance), times(light->profile.value, lobe->value));
    const struct bounded d = light->distance_mm;
    return plus3((struct bounded3){over(across.x, d), over(across.y, d), over(across.z, d)},
                 times3(light->towards, by_distance));
}

static void gradient(const struct lx_emitter *emitter, const struct lx_elements *elements, const struct lx_column *open,
                     enum lx_wanted wanted, unsigned needs, struct lx_gradient *gradient)
{
    const bool is_endless = lx_is_endless(emitter);
    const struct bounded3 axis = everywhere3(is_endless ? lx_exact3((double[]){0, 0, 0}) : emitter->profile.axis);
    const lanes_double half = all_double(0.5);
    if (lx_is_uniform(emitter)) {
        gradient_uniform(emitter, elements, wanted, gradient);
        return;
    }
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct bounded3 normal = load_bounded3(&elements->normal, i), view = load_bounded3(&elements->view, i);
        const struct light_slopes light = light_slopes(emitter, load_bounded3(&elements->place_mm, i), needs);
        const struct lobe_slopes lobe =
            lobe_slopes(elements->lobe, normal, view, light.towards, dot3(normal, light.towards), wanted, needs);
        const struct bounded is_open = open ? load_bounded(open, i) : exactly(all_double(1));
        const struct bounded strength = times(light.strength, is_open);
        const struct bounded a = times(strength, light.law.value), e = times(a, light.profile.value);
        const struct bounded c = times(a, lobe.value),
                             unit = times(times(is_open, light.law.value), light.profile.value);
        const lanes_double in_doubt =
            either(is_above(is_open.error, all_double(0)),
                   where_above_double(is_open.value, half,
                                      either(either(lobe.in_doubt, light.profile.in_doubt),
                                             not_so(is_above(light.distance_mm.value, light.distance_mm.error))),
                                      all_double(0)));
        for (size_t k = 0; k < LX_WIDTH_double; k++)
            gradient->in_doubt[i + k] = gradient->in_doubt[i + k] || !(in_doubt[k] < 0.5);
        if (needs & LX_BIT_BY(LX_BY_STRENGTH))
            store_bounded(&gradient->by[LX_BY_STRENGTH], i, times(unit, lobe.value));
        if (needs & (LX_BIT_BY(LX_BY_ORIGIN) | LX_BIT_BY(LX_BY_PLACE)) && is_endless) {
            store3(gradient, LX_BY_ORIGIN, i, times3(lobe.by_towards, e));
        } else if (needs & (LX_BIT_BY(LX_BY_ORIGIN) | LX_BIT_BY(LX_BY_PLACE))) {
            const struct bounded3 moved = by_origin(&light, &lobe, axis, strength);
            store3(gradient, LX_BY_ORIGIN, i, moved);
            add3_to(gradient, LX_BY_PLACE, i, (struct bounded3){negated(moved.x), negated(moved.y), negated(moved.z)});
        }
        if (needs & LX_BIT_BY(LX_BY_AXIS))
            store3(gradient, LX_BY_AXIS, i, times3(light.towards, negated(times(c, light.profile.by_cosine))));
        if (needs & (LX_BIT_BY(LX_BY_INNER) | LX_BIT_BY(LX_BY_OUTER))) {
            store_bounded(&gradient->by[LX_BY_INNER], i, times(c, light.profile.by_inner));
            store_bounded(&gradient->by[LX_BY_OUTER], i, times(c, light.profile.by_outer));
        }
        if (needs & LX_BIT_BY(LX_BY_PATTERN))
            store_bounded(&gradient->by[LX_BY_PATTERN], i, times(c, light.profile.by_exponent));
        const struct bounded of_law = times(times(strength, light.profile.value), lobe.value);
        for (unsigned k = 0; needs & LX_BIT_BY(LX_BY_LAW) && k < 3; k++)
            store_bounded(&gradient->by[LX_BY_LAW + k], i, times(of_law, light.law.by_own[k]));
        if (needs & LX_BIT_BY(LX_BY_NORMAL))
            add3_to(gradient, LX_BY_NORMAL, i, times3(lobe.by_normal, e));
        if (needs & LX_BIT_BY(LX_BY_VIEW))
            add3_to(gradient, LX_BY_VIEW, i, times3(lobe.by_view, e));
        if (needs & LX_BIT_BY(LX_BY_DIFFUSE))
            add_to(&gradient->by[LX_BY_DIFFUSE], i, times(e, lobe.by_diffuse));
        if (needs & LX_BIT_BY(LX_BY_SPECULAR))
            add_to(&gradient->by[LX_BY_SPECULAR], i, times(e, lobe.by_specular));
        if (needs & LX_BIT_BY(LX_BY_SHININESS))
            add_to(&gradient->by[LX_BY_SHININESS], i, times(e, lobe.by_shininess));
    }
}

/* Adds what a number that changes at a rate makes of a derivative by it. */
static void add_rate(const struct lx_column *derivative, lx_bounded rate, size_t count, struct lx_column *sum)
{
    const struct bounded factor = everywhere(rate);
    for (size_t i = 0; i < count; i += LX_WIDTH_double)
        add_to(sum, i, times(load_bounded(derivative, i), factor));
}
