/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by extended sources of any law a(r) = 1/(none + root r + square r^2), in one precision, by rules of
 * Gauss over rows.  Included behind each kernel_nodes.h, which does for what is far away.
 *
 * A row is a straight line on a source: of a quadrilateral, a chord of a disk, a generator of a cylinder.  With b the
 * place where the bisector of the angle under which an element sees it meets the row, the half tangent T of the angle
 * to b makes all of it rational: for p = 1 + T^2 and m = (1 - T^2) cos(f) - 2 T sin(f), f the angle between b and the
 * foot of the perpendicular, which has the length D, r = D p/m and dx/r^2 = 2 dT/(D p).  T is never above 1, and the
 * nearest singularities are T = i and where r would be negative, so few places do for a row however near it is.  Here
 * T = D sigma, which needs no D.
 *
 * Rows go across the source in another rule, by sinh where the source is near (Johnston and Elliott 2005), and what the
 * horizon cuts off is cut off the source itself, for each element on its own, so that all is smooth.  docs/MATHS.md
 * ("Laws without closed forms") has the number of places that this takes.
 *
 * Where a quadrilateral is no nearer than some two thirds of its size a product rule does, and takes less.
 *
 * Elements that need the same rule go through the sums together; each takes those of its own rule, and so does not
 * depend on the elements beside it.
 */

/* Which rules each element takes: places on a row, and rows. */
struct NAME(orders) {
    NAME(lanes) along, across;
};

/* A row from v0 to v1, as ways from the elements; at its ends the heights above the horizon, and what it weighs. */
struct NAME(row) {
    struct NAME(space) v0, v1;
    NAME(lanes) height0, height1, weight0, weight1;
};

/* The integral of height weight a(r)/r^2 over the row, for a unit of its length. */
LX_LANE NAME(lanes)
    NAME(row_sum)(const struct NAME(law) * law, const struct NAME(row) * row, const struct lx_gauss_rule *rule)
{
    const NAME(lanes) tiny = NAME(all)((REAL)SMALLEST * 16);
    NAME(lanes) r0 = NAME(root)(NAME(dot)(row->v0, row->v0)), r1 = NAME(root)(NAME(dot)(row->v1, row->v1));
    NAME(lanes) scale = NAME(inverse)(NAME(greater)(r0 + r1, tiny)), f0 = r1 * scale, f1 = r0 * scale;
    struct NAME(space) e = NAME(along)(row->v1, NAME(all)(-1), row->v0);
    struct NAME(space) b = NAME(along)(NAME(times)(f0, row->v0), f1, row->v1), n = NAME(cross)(b, e);
    NAME(lanes) square = NAME(greater)(NAME(dot)(b, b), tiny), inverse = NAME(inverse_root)(square);
    NAME(lanes)
    reach =
        f0 * NAME(inverse)(NAME(greater)(square * inverse * r1 + NAME(dot)(b, row->v1), tiny)); /* of sigma, for e */
    const NAME(lanes) twice = 2 * reach * square * inverse;
    const NAME(lanes) spread = NAME(dot)(n, n) * reach * reach, slant = 2 * reach * NAME(dot)(b, e) * inverse;
    const NAME(lanes) height = f0 * row->height0 + f1 * row->height1, rise = twice * (row->height1 - row->height0);
    const NAME(lanes) weight = f0 * row->weight0 + f1 * row->weight1, change = twice * (row->weight1 - row->weight0);
    const REAL *places = rule->NAME(places), *weights = rule->NAME(weights);
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < rule->count; i++) {
        const REAL x = places[i];
        NAME(lanes) t2 = spread * (x * x), p = 1 + t2, m = (1 - t2) * inverse - slant * x;
        NAME(lanes) divisor = p * (m * (law->none * m + law->root * p) + law->square * p * p);
        sum += weights[i] * (height * m + rise * x) * (weight * m + change * x) * NAME(inverse)(divisor);
    }
    return 2 * reach * sum;
}

LX_LANE NAME(lanes) NAME(natural_log)(NAME(lanes) x)
{
    return (REAL)M_LN2 * NAME(log2_of)(x, NAME(all)(0));
}

/*
 * How many places a rule needs for an integrand that is analytic in the ellipse whose half axes have the sum `reach`:
 * n leave reach^(-2n), times what it is in the ellipse at most.  That is what a tenth, and one place, are added for.
 */
LX_LANE NAME(lanes) NAME(order_of)(REAL digits, NAME(lanes) reach)
{
    const NAME(lanes) least = NAME(all)((REAL)1.0001);
    return 1 + (REAL)0.55 * digits * NAME(inverse)(NAME(natural_log)(NAME(greater)(reach, least)));
}

/*
 * The places on rows that are no longer than that and no nearer.  Beside T = i, 1/T at the row's end away, there are
 * poles where r is negative: beyond 90 degrees from the foot, the farther the greater `pole` is, the least size of 1/r
 * at any of them, until |T| is 1.
 */
LX_LANE NAME(lanes)
    NAME(order_along)(const struct NAME(law) * law, NAME(lanes) pole, NAME(lanes) length, NAME(lanes) distance)
{
    const NAME(lanes) half = (REAL)0.5 * length * NAME(inverse)(distance); /* tangent of half the angle */
    const NAME(lanes) secant = NAME(root)(1 + half * half);
    const NAME(lanes) cotangent = (1 + secant) * NAME(inverse)(NAME(greater)(half, NAME(all)((REAL)1e-12)));
    const NAME(lanes) off = cotangent * NAME(inverse)(1 + 2 * half) * (1 + pole * distance * secant);
    const NAME(lanes) beyond = NAME(lesser)(off, NAME(greater)(cotangent - 1, NAME(all)(0)));
    return NAME(order_of)(law->digits, NAME(lesser)(cotangent + NAME(root)(1 + cotangent * cotangent),
                                                    1 + beyond + NAME(root)(beyond * (2 + beyond))));
}

/* The angle, up to pi/2 and down to -pi/2, that has a sine. */
LX_LANE NAME(lanes) NAME(arc_sine)(NAME(lanes) sine)
{
    const NAME(lanes) one = NAME(all)(1);
    sine = NAME(lesser)(NAME(greater)(sine, -one), one);
    return NAME(angle_of_half_tangent)(sine * NAME(inverse)(1 + NAME(root)((1 - sine) * (1 + sine))));
}

/* Where rows go across: from -1/2 to 1/2, dense about a place, `width` being how near the source is there. */
struct NAME(gather) {
    NAME(lanes) middle, width, mean, growth; /* place = middle + width sinh(mean x + ln growth) */
};

LX_LANE struct NAME(gather) NAME(gather_at)(NAME(lanes) middle, NAME(lanes) width)
{
    NAME(lanes) inverse = NAME(inverse)(width);
    NAME(lanes) up = ((REAL)0.5 - middle) * inverse, down = ((REAL)0.5 + middle) * inverse;
    up = NAME(greater)(up, NAME(all)(0)), down = NAME(greater)(down, NAME(all)(0));
    up += NAME(root)(1 + up * up), down += NAME(root)(1 + down * down);
    return (struct NAME(gather)){middle, width, (REAL)0.5 * NAME(natural_log)(up * down),
                                 NAME(root)(up * NAME(inverse)(down))};
}

LX_LANE NAME(lanes) NAME(order_across)(REAL digits, const struct NAME(gather) * gather, NAME(lanes) angle)
{
    NAME(lanes) far = angle * NAME(inverse)(NAME(greater)(gather->mean, NAME(all)((REAL)1e-6)));
    return NAME(order_of)(digits, far + NAME(root)(1 + far * far));
}

/* A place there, and what it grows by with x. */
LX_LANE NAME(lanes) NAME(gathered)(const struct NAME(gather) * gather, REAL x, NAME(lanes) * slope)
{
    const REAL size = x < 0 ? -x : x;
    NAME(lanes) less = NAME(exp2_of)((REAL)-M_LOG2E * size * gather->mean), more = NAME(inverse)(less);
    NAME(lanes) up = (x < 0 ? less : more) * gather->growth, down = NAME(inverse)(up);
    *slope = (REAL)0.5 * gather->width * gather->mean * (up + down);
    return gather->middle + (REAL)0.5 * gather->width * (up - down);
}

/* Which of the rules has no fewer places; LX_RULES: none has. */
LX_LANE unsigned NAME(rule_for)(REAL order)
{
    static const REAL most[LX_RULES] = {LX_RULE_COUNTS};
    unsigned i = 0;
    while (i < LX_RULES && !(order <= most[i]))
        i++;
    return i;
}

/* Which rules each element of a vector takes, and which elements still have to be summed. */
struct NAME(choice) {
    unsigned along[NAME(LX_WIDTH)], across[NAME(LX_WIDTH)];
    NAME(lanes) wanted;
};

/* The rules for the lanes that are wanted; where none does, sets `left` to 1. */
LX_LANE struct NAME(choice) NAME(choose)(NAME(lanes) wanted, NAME(lanes) along, NAME(lanes) across, NAME(lanes) * left)
{
    struct NAME(choice) choice;
    for (int i = 0; i < NAME(LX_WIDTH); i++) {
        choice.along[i] = NAME(rule_for)(along[i]);
        choice.across[i] = NAME(rule_for)(across[i]);
        if (wanted[i] > 0 && (choice.along[i] == LX_RULES || choice.across[i] == LX_RULES))
            (*left)[i] = 1, wanted[i] = 0;
    }
    choice.wanted = wanted;
    return choice;
}

/* The next pair of rules that is wanted, as that of an element; LX_WIDTH: there is none. */
LX_LANE int NAME(next_of)(const struct NAME(choice) * choice)
{
    int i = 0;
    while (i < NAME(LX_WIDTH) && !(choice->wanted[i] > 0))
        i++;
    return i;
}

/* Adds a sum by the pair of rules of element i for all that want it. */
LX_LANE void NAME(settle)(struct NAME(choice) * choice, int i, NAME(lanes) sum, NAME(lanes) * total)
{
    const unsigned along = choice->along[i], across = choice->across[i];
    for (int j = i; j < NAME(LX_WIDTH); j++)
        if (choice->wanted[j] > 0 && choice->along[j] == along && choice->across[j] == across)
            (*total)[j] += sum[j], choice->wanted[j] = 0;
}

/* ---- quadrilaterals ---- */

/* What rules sum over a quadrilateral. */
struct NAME(plan) {
    struct NAME(orders) orders;
    struct NAME(gather) gather;
};

/* The square of the sine between two edges; 1 where one has no length. */
LX_LANE NAME(lanes) NAME(sine2_between)(struct NAME(space) a, struct NAME(space) b)
{
    const NAME(lanes) tiny = NAME(all)((REAL)SMALLEST * 16);
    const struct NAME(space) n = NAME(cross)(a, b);
    const NAME(lanes) product = NAME(dot)(a, a) * NAME(dot)(b, b);
    return NAME(where_above)(product, tiny, NAME(dot)(n, n) * NAME(inverse)(NAME(greater)(product, tiny)),
                             NAME(all)(1));
}

/* A quadrilateral as elements see it. */
struct NAME(look) {
    NAME(lanes) place, distance; /* of the rows that are nearest, from -1/2 to 1/2, and from the nearest place */
    NAME(lanes) along, across;   /* its greatest lengths */
    NAME(lanes) odd2;            /* how far from a parallelogram it is, squared */
};

LX_LANE struct NAME(look) NAME(look_at)(const struct NAME(quad) * quad)
{
    const NAME(lanes) half = NAME(all)((REAL)0.5), tiny = NAME(all)((REAL)SMALLEST * 16);
    const struct NAME(space) *v = quad->v;
    struct NAME(space) a = NAME(minus)(v[1], v[0]), c = NAME(minus)(v[2], v[3]);
    struct NAME(space) b = NAME(minus)(v[3], v[0]), d = NAME(minus)(v[2], v[1]);
    struct NAME(space) s = NAME(times)(half, NAME(sum_of)(a, c)), t = NAME(times)(half, NAME(sum_of)(b, d));
    struct NAME(space) middle =
        NAME(times)(half * half, NAME(sum_of)(NAME(sum_of)(v[0], v[1]), NAME(sum_of)(v[2], v[3])));
    NAME(lanes) ss = NAME(greater)(NAME(dot)(s, s), tiny), tt = NAME(greater)(NAME(dot)(t, t), tiny);
    NAME(lanes) st = NAME(dot)(s, t), ms = -NAME(dot)(middle, s), mt = -NAME(dot)(middle, t);
    NAME(lanes) by_s = (ms * tt - mt * st) * NAME(inverse)(NAME(greater)(ss * tt - st * st, ss * tt * (REAL)1e-6));
    by_s = NAME(lesser)(NAME(greater)(by_s, -half), half);
    NAME(lanes) by_t = (mt - by_s * st) * NAME(inverse)(tt);
    by_t = NAME(lesser)(NAME(greater)(by_t, -half), half);
    struct NAME(space) near = NAME(along)(NAME(along)(middle, by_s, s), by_t, t);
    /* corners of what is no parallelogram may be nearer than those of the one that it is taken for */
    struct NAME(space) odd = NAME(minus)(b, d), normal = NAME(cross)(s, t);
    NAME(lanes) over = NAME(dot)(normal, middle), odd2 = NAME(dot)(odd, odd);
    NAME(lanes) above = NAME(root)(over * over * NAME(inverse)(NAME(greater)(NAME(dot)(normal, normal), tiny)));
    NAME(lanes) distance = NAME(root)(NAME(dot)(near, near)) - (REAL)0.25 * NAME(root)(odd2);
    return (struct NAME(look)){
        .place = by_t,
        .distance = NAME(greater)(NAME(greater)(distance, above), tiny),
        .along = NAME(root)(NAME(greater)(NAME(greater)(NAME(dot)(a, a), NAME(dot)(c, c)), tiny)),
        .across = NAME(root)(NAME(greater)(NAME(greater)(NAME(dot)(b, b), NAME(dot)(d, d)), tiny)),
        .odd2 = odd2};
}

/* The places along edges that are no longer than that by a product rule: rules.h has what it leaves. */
LX_LANE NAME(lanes) NAME(order_of_product)(REAL digits, NAME(lanes) length, NAME(lanes) distance)
{
    const NAME(lanes) far = 2 * distance * NAME(inverse)(length);
    return (REAL)0.5 * (digits + (REAL)LX_MISSED_BY_PRODUCTS) *
           NAME(inverse)(NAME(natural_log)(far + NAME(root)(1 + far * far)));
}

LX_LANE struct NAME(plan)
    NAME(plan_rows)(const struct NAME(law) * law, const struct NAME(quad) * quad, const struct NAME(look) * look)
{
    const struct NAME(space) *v = quad->v;
    const struct NAME(space) a = NAME(minus)(v[1], v[0]), c = NAME(minus)(v[2], v[3]);
    const struct NAME(space) b = NAME(minus)(v[3], v[0]), d = NAME(minus)(v[2], v[1]);
    struct NAME(plan) plan = {.gather = NAME(gather_at)(look->place, look->distance * NAME(inverse)(look->across))};
    /* where both height and area grow along a row, the law must fall as 1/r^2 to leave nothing at r without end */
    const NAME(lanes) bends = law->square > 0 ? NAME(all)(0) : look->odd2;
    const NAME(lanes) pole =
        NAME(where_above)(bends, (REAL)1e-10 * look->across * look->across, NAME(all)(0), NAME(all)(law->pole));
    plan.orders.along = NAME(order_along)(law, pole, look->along, look->distance);
    NAME(lanes) sine2 = NAME(lesser)(NAME(sine2_between)(a, b), NAME(sine2_between)(a, d));
    sine2 = NAME(lesser)(sine2, NAME(lesser)(NAME(sine2_between)(c, b), NAME(sine2_between)(c, d)));
    /* what leads across rows that lean is as near to the element in other places, but of no more than all of it */
    const NAME(lanes) width2 = plan.gather.width * plan.gather.width;
    sine2 = NAME(greater)(sine2, width2 * NAME(inverse)(1 + width2));
    plan.orders.across = NAME(order_across)(law->digits, &plan.gather, NAME(arc_sine)(NAME(root)(sine2)));
    return plan;
}

/* The integral of height a(r)/r^2 over a quadrilateral in a plane of the normal n by one pair of rules. */
LX_LANE NAME(lanes) NAME(quad_sum)(const struct NAME(law) * law, const struct NAME(quad) * quad, struct NAME(space) n,
                                   const struct NAME(gather) * gather, const struct lx_gauss_rule *along,
                                   const struct lx_gauss_rule *across)
{
    const struct NAME(space) *v = quad->v;
    const struct NAME(space) b = NAME(minus)(v[3], v[0]), d = NAME(minus)(v[2], v[1]);
    const struct NAME(extent) extent = NAME(extent_of)(quad, n);
    const NAME(lanes) *height = quad->height;
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < across->count; i++) {
        NAME(lanes) slope, t = (REAL)0.5 + NAME(gathered)(gather, across->NAME(places)[i], &slope);
        const struct NAME(row) row = {
            .v0 = NAME(along)(v[0], t, b),
            .v1 = NAME(along)(v[1], t, d),
            .height0 = height[0] + t * (height[3] - height[0]),
            .height1 = height[1] + t * (height[2] - height[1]),
            .weight0 = extent.area + t * extent.by_t,
            .weight1 = extent.area + t * extent.by_t + extent.by_s,
        };
        sum += across->NAME(weights)[i] * slope * NAME(row_sum)(law, &row, along);
    }
    return sum;
}

/* Adds the share of a quadrilateral, for those that see it; where rules do not do, sets `left` to 1. */
static __attribute__((noinline)) void NAME(add_quad)(const struct NAME(law) * law, const struct NAME(quad) * quad,
                                                     struct NAME(space) n, NAME(lanes) seen, NAME(lanes) * total,
                                                     NAME(lanes) * left)
{
    const NAME(lanes) zero = NAME(all)(0);
    if (!NAME(any_above)(seen, zero))
        return;
    const struct NAME(look) look = NAME(look_at)(quad);
    const struct NAME(orders) product = {NAME(order_of_product)(law->digits, look.along, look.distance),
                                         NAME(order_of_product)(law->digits, look.across, look.distance)};
    const NAME(lanes) most = NAME(all)(LX_MOST_NODES_ACROSS);
    const NAME(lanes) near = NAME(where_above)(NAME(greater)(product.along, product.across), most, seen, zero);
    struct NAME(choice) choice = NAME(choose)(seen - near, product.along, product.across, left);
    for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice)) {
        const struct lx_gauss_rule *along = &law->rules->rules[choice.along[i]];
        const struct lx_gauss_rule *across = &law->rules->rules[choice.across[i]];
        NAME(settle)(&choice, i, NAME(sum_over_quad)(law, quad, n, along, across), total);
    }
    if (!NAME(any_above)(near, zero))
        return;
    const struct NAME(plan) plan = NAME(plan_rows)(law, quad, &look);
    choice = NAME(choose)(near, plan.orders.along, plan.orders.across, left);
    for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice)) {
        const struct lx_gauss_rule *along = &law->rules->rules[choice.along[i]];
        const struct lx_gauss_rule *across = &law->rules->rules[choice.across[i]];
        NAME(settle)(&choice, i, NAME(quad_sum)(law, quad, n, &plan.gather, along, across), total);
    }
}

LX_LANE void NAME(turn)(NAME(lanes) turns, struct NAME(quad) * quad)
{
    const NAME(lanes) zero = NAME(all)(0);
    const struct NAME(quad) old = *quad;
    for (int k = 0; k < 4; k++) {
        quad->v[k] = NAME(space_where_above)(turns, zero, old.v[(k + 1) % 4], old.v[k]);
        quad->height[k] = NAME(where_above)(turns, zero, old.height[(k + 1) % 4], old.height[k]);
    }
}

/* Where the horizon cuts the way from a corner above it to one below. */
LX_LANE struct NAME(space) NAME(cut_between)(const struct NAME(quad) * quad, int above, int below)
{
    NAME(lanes)
    up = NAME(greater)(quad->height[above], NAME(all)(0)), down = NAME(lesser)(quad->height[below], NAME(all)(0));
    NAME(lanes) share = up * NAME(inverse)(NAME(greater)(up - down, NAME(all)((REAL)SMALLEST * 16)));
    return NAME(along)(quad->v[above], share, NAME(minus)(quad->v[below], quad->v[above]));
}

/*
 * Adds what the horizon leaves of a quadrilateral.  It is turned so that its first corner is the first one above the
 * horizon; then what is left is another quadrilateral and, where one corner alone is below, a triangle.
 */
LX_LANE void NAME(add_cut_quad)(const struct NAME(law) * law, struct NAME(quad) * quad, struct NAME(space) n,
                                NAME(lanes) seen, NAME(lanes) * total, NAME(lanes) * left)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1);
    for (int turn = 0; turn < 3; turn++) {
        NAME(lanes)
        begins = NAME(where_above)(quad->height[0], zero, NAME(where_above)(quad->height[3], zero, zero, one), zero);
        NAME(lanes)
        whole = NAME(lesser)(NAME(lesser)(quad->height[0], quad->height[1]),
                             NAME(lesser)(quad->height[2], quad->height[3]));
        NAME(turn)(NAME(where_above)(whole, zero, zero, 1 - begins), quad);
    }
    const NAME(lanes) up1 = NAME(where_above)(quad->height[1], zero, one, zero);
    const NAME(lanes) up2 = up1 * NAME(where_above)(quad->height[2], zero, one, zero);
    const NAME(lanes) up3 = up2 * NAME(where_above)(quad->height[3], zero, one, zero);
    seen *= NAME(where_above)(quad->height[0], zero, one, zero);
    const struct NAME(space) c01 = NAME(cut_between)(quad, 0, 1), c12 = NAME(cut_between)(quad, 1, 2),
                             c23 = NAME(cut_between)(quad, 2, 3), c30 = NAME(cut_between)(quad, 0, 3);
    struct NAME(quad) part = *quad;
    /* as many corners up: 1: v0 c01 c30; 2: v0 v1 c12 c30; 3: v0 v1 v2 c23, and v0 c23 c30; 4: all */
    part.v[1] = NAME(space_where_above)(up1, zero, quad->v[1], c01);
    part.v[2] = NAME(space_where_above)(up2, zero, quad->v[2], NAME(space_where_above)(up1, zero, c12, c30));
    part.v[3] = NAME(space_where_above)(up3, zero, quad->v[3], NAME(space_where_above)(up2, zero, c23, c30));
    part.height[1] = up1 * quad->height[1];
    part.height[2] = up2 * quad->height[2];
    part.height[3] = up3 * quad->height[3];
    NAME(add_quad)(law, &part, n, seen, total, left);
    const NAME(lanes) has_rest = seen * up2 * (1 - up3);
    if (!NAME(any_above)(has_rest, zero))
        return;
    struct NAME(quad) rest = {.v = {c30, quad->v[0], c23, c30}, .height = {zero, quad->height[0], zero, zero}};
    NAME(add_quad)(law, &rest, n, has_rest, total, left);
}

/* The ways from elements to a place, formed in float64. */
LX_LANE struct NAME(space) NAME(ways_to)(const double place[3], const struct lx_block_double *block, size_t start)
{
    struct NAME(space) way;
    for (int i = 0; i < NAME(LX_WIDTH); i++) {
        way.x[i] = (REAL)(place[0] - block->px[start + (size_t)i]);
        way.y[i] = (REAL)(place[1] - block->py[start + (size_t)i]);
        way.z[i] = (REAL)(place[2] - block->pz[start + (size_t)i]);
    }
    return way;
}

LX_LANE struct NAME(space) NAME(normals_of)(const struct lx_block_double *block, size_t start)
{
    struct NAME(space) n;
    for (int i = 0; i < NAME(LX_WIDTH); i++) {
        n.x[i] = (REAL)block->nx[start + (size_t)i];
        n.y[i] = (REAL)block->ny[start + (size_t)i];
        n.z[i] = (REAL)block->nz[start + (size_t)i];
    }
    return n;
}

LX_LANE struct NAME(audience)
    NAME(audience_of)(const struct lx_area_light *lamp, const struct lx_block_double *block, size_t start)
{
    return (struct NAME(audience)){.n = NAME(normals_of)(block, start),
                                   .to_center = NAME(ways_to)(lamp->center, block, start),
                                   .whole = NAME(all)(0),
                                   .total = NAME(all)(0),
                                   .left = NAME(all)(0)};
}

LX_LANE void NAME(hand_out)(const struct NAME(audience) * audience, double gain, size_t start, size_t count,
                            double *restrict sum, uint8_t *left)
{
    for (size_t i = 0; i < NAME(LX_WIDTH) && start + i < count; i++) {
        const double value = gain * (double)audience->total[i];
        const bool is_left = audience->left[i] > 0;
        sum[start + i] += !is_left && value > 0 ? value : 0;
        left[start + i] |= is_left;
    }
}

/* Whether some of the source may be above the horizon of any of them; finds those who see all of it. */
LX_LANE bool NAME(any_sees)(const struct lx_area_light *lamp, struct NAME(audience) * audience)
{
    const NAME(lanes) reach = NAME(all)((REAL)(1.001 * lamp->radius_mm + lamp->touch_mm));
    const NAME(lanes) up = NAME(dot)(audience->n, audience->to_center);
    if (lamp->nodes_each > 0)
        audience->whole = NAME(where_above)(up, reach, NAME(all)(1), NAME(all)(0));
    return NAME(any_above)(up, -reach);
}

/* Adds a quadrilateral of the area light for those who do not see all of that, or are near. */
LX_LANE void NAME(add_area_light_quad)(const struct NAME(law) * law, const struct lx_area_light_quad *whole,
                                       const REAL face[3], REAL touch, struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1);
    const struct NAME(space) normal = NAME(same)(face);
    struct NAME(quad) quad;
    for (int k = 0; k < 4; k++) {
        const double *corner = whole->corners[k];
        quad.v[k] = NAME(sum_of)(audience->to_center,
                                 NAME(same)((const REAL[]){(REAL)corner[0], (REAL)corner[1], (REAL)corner[2]}));
        quad.height[k] = NAME(dot)(audience->n, quad.v[k]);
    }
    const NAME(lanes) *h = quad.height, above = -NAME(dot)(normal, quad.v[0]);
    const NAME(lanes) highest = NAME(greater)(NAME(greater)(h[0], h[1]), NAME(greater)(h[2], h[3]));
    const NAME(lanes) lowest = NAME(lesser)(NAME(lesser)(h[0], h[1]), NAME(lesser)(h[2], h[3]));
    const NAME(lanes) seen =
        NAME(where_above)(above, NAME(all)(touch), NAME(where_above)(highest, zero, one - audience->whole, zero), zero);
    NAME(lanes) part = zero;
    if (!NAME(any_above)(seen, zero))
        return;
    if (NAME(any_above)(zero, seen * lowest))
        NAME(add_cut_quad)(law, &quad, normal, seen, &part, &audience->left);
    else
        NAME(add_quad)(law, &quad, normal, seen, &part, &audience->left);
    audience->total += above * part;
}

void LX_OF_ISA(NAME(lx_facets_by_rows))(const struct lx_area_light *lamp, const struct lx_gauss_rules *rules,
                                        double diffuse, const struct lx_block_double *block, size_t count,
                                        const struct lx_asking *asking, double *restrict sum, uint8_t *left)
{
    enum { BETWEEN_CHECKS = 64 };
    const struct NAME(law) law = NAME(law_of)(lamp, rules);
    const REAL touch = (REAL)lamp->touch_mm;
    for (size_t start = 0; start < count; start += NAME(LX_WIDTH)) {
        struct NAME(audience) audience = NAME(audience_of)(lamp, block, start);
        if (!NAME(any_sees)(lamp, &audience))
            continue;
        for (size_t q = 0; q < lamp->quad_count; q++) {
            const struct lx_area_light_quad *quad = &lamp->quads[q];
            const REAL face[3] = {(REAL)quad->normal[0], (REAL)quad->normal[1], (REAL)quad->normal[2]};
            if (NAME(any_above)(audience.whole, NAME(all)(0)))
                NAME(add_nodes)(&law, face, lamp->nodes + q * lamp->nodes_each, lamp->nodes_each, touch, &audience);
            if (NAME(any_above)(NAME(all)(1), audience.whole))
                NAME(add_area_light_quad)(&law, quad, face, touch, &audience);
            if (!lx_asking_at_step(asking, q, BETWEEN_CHECKS))
                return;
        }
        NAME(hand_out)(&audience, diffuse * lamp->radiance, start, count, sum, left);
    }
}
