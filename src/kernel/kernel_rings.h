/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by balls of any law, in one precision.  Included behind each kernel_rows.h, whose rules it uses.
 *
 * Where an element sees a ball of the radius R, the distance d away, under the angle f from its centre, the ball is the
 * distance r = d cos f - R v away, with sin^2 f = q (1 - v^2), q = R^2/d^2.  With x the cosine of the angle between the
 * normal and the centre a ring of such places gives, for a radiance of 1,
 *
 *     r^2 a(r) 2 q v dv (x psi + s tan(f) sin(psi)),    s^2 = 1 - x^2,   cos(psi) = -x/(s tan f),
 *
 * psi being how far round the ring is above the horizon on either side: pi where all of it is, then the second term is
 * none.
 */

/* A ball as elements see it. */
struct NAME(ball_view) {
    NAME(lanes) x, s2, q, distance, radius;
};

/* r^2 a(r) at v. */
LX_LANE NAME(lanes) NAME(gain_at)(const struct NAME(law) * law, const struct NAME(ball_view) * view, NAME(lanes) v)
{
    NAME(lanes) cosine2 = 1 - view->q * (1 - v) * (1 + v);
    NAME(lanes) r = view->distance * NAME(root)(NAME(greater)(cosine2, NAME(all)(0))) - view->radius * v;
    return r * r * NAME(inverse)(law->none + r * (law->root + r * law->square));
}

/* All rings where the ball is far away, none of which the horizon cuts. */
LX_LANE NAME(lanes)
    NAME(few_rings)(const struct NAME(law) * law, const struct NAME(ball_view) * view, const struct lx_gauss_rule *rule)
{
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < rule->count; i++) {
        const NAME(lanes) v = NAME(all)((REAL)0.5 * (1 + rule->NAME(places)[i]));
        sum += rule->NAME(weights)[i] * v * NAME(gain_at)(law, view, v);
    }
    return (REAL)M_PI * view->q * view->x * sum;
}

/* The rings that are whole, from v on. */
LX_LANE NAME(lanes)
    NAME(whole_rings)(const struct NAME(law) * law, const struct NAME(ball_view) * view, NAME(lanes) from,
                      const struct NAME(gather) * gather, const struct lx_gauss_rule *rule)
{
    const NAME(lanes) span = 1 - from, middle = (REAL)0.5 * (1 + from);
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < rule->count; i++) {
        NAME(lanes) slope, v = middle + span * NAME(gathered)(gather, rule->NAME(places)[i], &slope);
        sum += rule->NAME(weights)[i] * slope * v * NAME(gain_at)(law, view, v);
    }
    return (REAL)(2 * M_PI) * span * view->q * view->x * sum;
}

/* One half of the rings that the horizon cuts, from v = 0 to v = to: v = to (1 - z^2), where all is smooth. */
LX_LANE NAME(lanes) NAME(cut_rings)(const struct NAME(law) * law, const struct NAME(ball_view) * view, NAME(lanes) to,
                                    REAL begin, const struct NAME(gather) * gather, const struct lx_gauss_rule *rule)
{
    const NAME(lanes) zero = NAME(all)(0), tiny = NAME(all)((REAL)SMALLEST * 16);
    NAME(lanes) sum = zero;
    for (unsigned i = 0; i < rule->count; i++) {
        NAME(lanes) slope, z = begin + (REAL)0.25 + (REAL)0.5 * NAME(gathered)(gather, rule->NAME(places)[i], &slope);
        NAME(lanes) v = to * (1 - z) * (1 + z), u = view->q * (1 - v) * (1 + v);
        NAME(lanes) over = NAME(greater)(view->q * (to - v) * (to + v), zero); /* u - x^2 */
        NAME(lanes) flat = NAME(root)(over), high = NAME(magnitude)(view->x) * NAME(root)(NAME(greater)(1 - u, zero));
        NAME(lanes) whole = NAME(root)(NAME(greater)(view->s2 * u, tiny)); /* flat and high are its legs */
        NAME(lanes) angle = NAME(angle_of_half_tangent)(flat * NAME(inverse)(whole + high));
        NAME(lanes) psi = NAME(where_above)(view->x, zero, (REAL)M_PI - angle, angle);
        NAME(lanes) ring = view->x * psi + flat * NAME(inverse_root)(NAME(greater)(1 - u, tiny));
        sum += rule->NAME(weights)[i] * slope * z * v * ring * NAME(gain_at)(law, view, v);
    }
    return 2 * view->q * to * sum;
}

/* Adds the rings that the horizon cuts: the halves of z, at the ends of which singularities are near. */
static __attribute__((noinline)) void NAME(add_cut_rings)(const struct NAME(law) * law,
                                                          const struct NAME(ball_view) * view, NAME(lanes) to,
                                                          NAME(lanes) off, NAME(lanes) cut,
                                                          struct NAME(audience) * audience)
{
    const NAME(lanes) one = NAME(all)(1), scale = NAME(inverse)(NAME(greater)(to, NAME(all)((REAL)1e-9)));
    const NAME(lanes) widths[2] = {NAME(root)(NAME(greater)((1 - to) * scale, NAME(all)(0))), (REAL)0.5 * off * scale};
    for (int half = 0; half < 2; half++) {
        const NAME(lanes) width =
            NAME(lesser)(NAME(greater)(2 * widths[half], NAME(all)((REAL)1e-6)), NAME(all)((REAL)1e3));
        const struct NAME(gather) gather = NAME(gather_at)(NAME(all)((REAL)half - (REAL)0.5), width);
        const NAME(lanes) least = NAME(all)(law->digits / 3);
        const NAME(lanes) order =
            NAME(greater)(NAME(order_across)(law->digits, &gather, NAME(all)((REAL)M_PI_2)), least);
        struct NAME(choice) choice = NAME(choose)(cut, order, one, &audience->left);
        for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice))
            NAME(settle)
        (&choice, i,
         NAME(cut_rings)(law, view, to, (REAL)0.5 * (REAL)half, &gather, &law->rules->rules[choice.along[i]]),
         &audience->total);
    }
}

LX_LANE void NAME(add_rings)(const struct NAME(law) * law, const struct lx_area_light *lamp,
                             struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1);
    const struct NAME(space) *c = &audience->to_center;
    const NAME(lanes) square = NAME(dot)(*c, *c), distance = NAME(root)(square), inverse = NAME(inverse)(distance);
    struct NAME(ball_view) view = {.distance = distance, .radius = NAME(all)((REAL)lamp->round_mm)};
    const struct NAME(space) turned = NAME(cross)(audience->n, *c);
    const NAME(lanes) sine = view.radius * inverse;
    view.x = NAME(dot)(audience->n, *c) * inverse;
    view.s2 = NAME(dot)(turned, turned) * inverse * inverse;
    view.q = sine * sine;
    const NAME(lanes) beyond = (distance - view.radius) * (distance + view.radius);
    const NAME(lanes) off = NAME(root)(NAME(greater)(beyond, zero)) * NAME(inverse)(view.radius);
    const NAME(lanes) others = one - audience->whole;
    const NAME(lanes) outside = NAME(where_above)(distance, view.radius + (REAL)lamp->touch_mm, others, zero);
    if (lamp->nodes_each > 0)
        audience->total = audience->whole * NAME(few_rings)(law, &view, &law->rules->rules[lamp->nodes_each - 1]);
    if (!NAME(any_above)(others, zero))
        return;
    const NAME(lanes) from2 = (sine - view.x) * (sine + view.x) * NAME(inverse)(view.q);
    const NAME(lanes) cut = NAME(where_above)(from2, zero, outside * NAME(where_above)(view.x, -sine, one, zero), zero);
    const NAME(lanes) from = NAME(root)(NAME(greater)(from2, zero));
    const NAME(lanes) whole = outside * NAME(where_above)(view.x, zero, one, zero);
    const NAME(lanes) width =
        NAME(root)(off * off + from * from) * NAME(inverse)(NAME(greater)(1 - from, NAME(all)((REAL)1e-9)));
    const struct NAME(gather) gather = NAME(gather_at)(
        NAME(all)((REAL)-0.5), NAME(lesser)(NAME(greater)(width, NAME(all)((REAL)1e-6)), NAME(all)((REAL)1e3)));
    const NAME(lanes) order = NAME(order_across)(law->digits, &gather, NAME(all)((REAL)M_PI_2));
    struct NAME(choice) choice = NAME(choose)(whole, order, one, &audience->left);
    for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice))
        NAME(settle)
    (&choice, i, NAME(whole_rings)(law, &view, from, &gather, &law->rules->rules[choice.along[i]]), &audience->total);
    if (NAME(any_above)(cut, zero))
        NAME(add_cut_rings)(law, &view, from, off, cut, audience);
}

void LX_OF_ISA(NAME(lx_ball_by_rings))(const struct lx_area_light *lamp, const struct lx_gauss_rules *rules,
                                       double diffuse, const struct lx_block_double *block, size_t count,
                                       const struct lx_asking *asking, double *restrict sum, uint8_t *left)
{
    const struct NAME(law) law = NAME(law_of)(lamp, rules);
    (void)asking;
    for (size_t start = 0; start < count; start += NAME(LX_WIDTH)) {
        struct NAME(audience) audience = NAME(audience_of)(lamp, block, start);
        if (!NAME(any_sees)(lamp, &audience))
            continue;
        NAME(add_rings)(&law, lamp, &audience);
        NAME(hand_out)(&audience, diffuse * lamp->radiance, start, count, sum, left);
    }
}
