/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by disks and cylinders of any law by rows (kernel_rows.h), in one precision: chords that lie level for
 * each element, so that the horizon cuts none in two, and generators, of which it leaves a part.
 */

/* Sine and cosine of an angle up to pi/2, or down to its negative. */
LX_LANE void NAME(sine_and_cosine)(NAME(lanes) angle, NAME(lanes) * sine, NAME(lanes) * cosine)
{
    static const REAL terms[] = {1,
                                 (REAL)(-1.0 / 6),
                                 (REAL)(1.0 / 120),
                                 (REAL)(-1.0 / 5040),
                                 (REAL)(1.0 / 362880),
                                 (REAL)(-1.0 / 39916800),
                                 (REAL)(1.0 / 6227020800),
                                 (REAL)(-1.0 / 1307674368000),
                                 (REAL)(1.0 / 355687428096000)};
    const int count = LX_IS_SINGLE ? 5 : 9;
    const NAME(lanes) half = (REAL)0.5 * angle, sine_of_half = half * NAME(polynomial)(half * half, terms, count);
    const NAME(lanes) square = sine_of_half * sine_of_half;
    *cosine = 1 - 2 * square;
    *sine = 2 * sine_of_half * NAME(root)(1 - square);
}

/* A disk as elements see it: with chords level above their horizons, which go up along `up`. */
struct NAME(disk) {
    struct NAME(space) center, up, aside;
    NAME(lanes) above;        /* elements over the plane */
    NAME(lanes) height, rise; /* of the centre above the horizon, and what that grows by along `up` */
    NAME(lanes) lowest;       /* the angle of the lowest chord from the level of the centre */
    REAL radius;
};

LX_LANE struct NAME(disk) NAME(disk_of)(struct NAME(space) center, struct NAME(space) axis, REAL radius,
                                        struct NAME(space) beside, struct NAME(space) n)
{
    const NAME(lanes) tiny = NAME(all)((REAL)(LX_IS_SINGLE ? 1e-6 : 1e-14)), least = NAME(all)((REAL)SMALLEST * 16);
    const NAME(lanes) along = NAME(dot)(n, axis);
    struct NAME(space) up = NAME(along)(n, -along, axis);
    NAME(lanes) sine = NAME(root)(NAME(dot)(up, up));
    up = NAME(space_where_above)(sine, tiny, NAME(times)(NAME(inverse)(NAME(greater)(sine, tiny)), up), beside);
    up = NAME(along)(up, -NAME(dot)(up, axis), axis); /* where the element faces the disk that has lost digits */
    struct NAME(disk) disk = {.center = center, .up = up, .aside = NAME(cross)(axis, up), .radius = radius};
    disk.above = -NAME(dot)(axis, center);
    disk.height = NAME(dot)(n, center);
    disk.rise = NAME(greater)(NAME(dot)(n, up), least);
    disk.lowest = NAME(arc_sine)(-disk.height * NAME(inverse)(disk.rise * radius + least));
    return disk;
}

LX_LANE struct NAME(plan) NAME(plan_disk)(const struct NAME(law) * law, const struct NAME(disk) * disk)
{
    const REAL r = disk->radius, natural = law->digits / 5; /* what chords need however far the disk is */
    const NAME(lanes) tiny = NAME(all)((REAL)SMALLEST * 16), zero = NAME(all)(0), one = NAME(all)(1);
    const NAME(lanes) x = -NAME(dot)(disk->center, disk->aside), y = -NAME(dot)(disk->center, disk->up);
    const NAME(lanes) level = NAME(lesser)(NAME(greater)(y, NAME(all)(-r)), NAME(all)(r));
    const NAME(lanes) chord = NAME(root)((r - level) * (r + level));
    const NAME(lanes) beyond = NAME(greater)(NAME(magnitude)(x) - chord, zero);
    const NAME(lanes) off = NAME(root)(disk->above * disk->above + beyond * beyond);
    const NAME(lanes) distance = NAME(greater)(NAME(root)(off * off + (y - level) * (y - level)), tiny);
    /* the angle whose sine is (y + i above)/r, where the distance from a chord is 0; of an element beside the disk the
     * angle where that from the end of a chord is */
    const NAME(lanes) re = y / r, im = disk->above / r, foot2 = x * x + y * y;
    const NAME(lanes) more = NAME(root)((re + 1) * (re + 1) + im * im),
                      less = NAME(root)((re - 1) * (re - 1) + im * im);
    const NAME(lanes) foot = NAME(greater)(NAME(root)(foot2), tiny), is_beside = foot - r;
    NAME(lanes) axis = (REAL)0.5 * (more + less), sine = (REAL)0.5 * (more - less);
    axis = NAME(where_above)(is_beside, zero,
                             (REAL)0.5 * (r * r + foot2 + disk->above * disk->above) * NAME(inverse)(r * foot), axis);
    sine = NAME(where_above)(is_beside, zero, y * NAME(inverse)(foot), sine);
    axis = NAME(greater)(axis, one);
    const NAME(lanes) angle = NAME(arc_sine)(sine);
    const NAME(lanes) width = NAME(natural_log)(axis + NAME(root)((axis - 1) * (axis + 1)));
    const NAME(lanes) half_turn = NAME(all)((REAL)M_PI_2),
                      span = NAME(greater)(half_turn - disk->lowest, NAME(all)((REAL)1e-6));
    const NAME(lanes) inverse = NAME(inverse)(span), middle = (REAL)0.5 * (half_turn + disk->lowest);
    const NAME(lanes) place = (angle - middle) * inverse;
    const NAME(lanes) inside = NAME(lesser)(NAME(greater)(place, NAME(all)((REAL)-0.5)), NAME(all)((REAL)0.5));
    const NAME(lanes) apart = (place - inside) * (place - inside) + width * width * inverse * inverse;
    struct NAME(plan)
        plan = {.gather = NAME(gather_at)(inside, NAME(root)(NAME(greater)(apart, NAME(all)((REAL)1e-12))))};
    /* level chords have nothing that grows along them */
    plan.orders.along =
        NAME(order_along)(law, NAME(all)(law->is_steady ? (REAL)1e30 : law->pole), NAME(all)(2 * r), distance);
    plan.orders.across = NAME(greater)((REAL)1.25 * NAME(order_across)(law->digits, &plan.gather, half_turn),
                                       natural * (1 + span * (REAL)(2 / M_PI)));
    return plan;
}

LX_LANE NAME(lanes)
    NAME(disk_sum)(const struct NAME(law) * law, const struct NAME(disk) * disk, const struct NAME(gather) * gather,
                   const struct lx_gauss_rule *along, const struct lx_gauss_rule *across)
{
    const NAME(lanes) half_turn = NAME(all)((REAL)M_PI_2), span = half_turn - disk->lowest;
    const NAME(lanes) middle = (REAL)0.5 * (half_turn + disk->lowest);
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < across->count; i++) {
        NAME(lanes) slope, sine, cosine;
        NAME(lanes) angle = middle + span * NAME(gathered)(gather, across->NAME(places)[i], &slope);
        NAME(sine_and_cosine)(angle, &sine, &cosine);
        const NAME(lanes) half = disk->radius * cosine, level = disk->radius * sine;
        const NAME(lanes) height = disk->height + disk->rise * level, weight = 2 * half * half;
        const struct NAME(space) place = NAME(along)(disk->center, level, disk->up);
        const struct NAME(row) row = {NAME(along)(place, -half, disk->aside),
                                      NAME(along)(place, half, disk->aside),
                                      height,
                                      height,
                                      weight,
                                      weight};
        sum += across->NAME(weights)[i] * slope * NAME(row_sum)(law, &row, along);
    }
    return sum * span;
}

static __attribute__((noinline)) void NAME(add_disk)(const struct NAME(law) * law, const struct lx_area_light *lamp,
                                                     double side, struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1), touch = NAME(all)((REAL)lamp->touch_mm);
    REAL axis[3], beside[3] = {0, 0, 0}, offset[3];
    const REAL turn = side < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++) {
        axis[k] = turn * (REAL)lamp->axis[k];
        offset[k] = (REAL)(side * lamp->half_mm * lamp->axis[k]);
    }
    if (NAME(any_above)(audience->whole, zero))
        NAME(add_nodes)
    (law, axis, lamp->nodes + (side < 0 ? lamp->nodes_each : 0), lamp->nodes_each, (REAL)lamp->touch_mm, audience);
    if (!NAME(any_above)(one, audience->whole))
        return;
    const int other = axis[0] * axis[0] > (REAL)0.25 ? 1 : 0; /* beside[other] = 1, made perpendicular */
    const REAL along = axis[other], scale = 1 / SQRT(1 - along * along);
    for (int k = 0; k < 3; k++)
        beside[k] = scale * ((k == other ? 1 : 0) - along * axis[k]);
    const struct NAME(space) center = NAME(sum_of)(audience->to_center, NAME(same)(offset));
    const struct NAME(disk) disk =
        NAME(disk_of)(center, NAME(same)(axis), (REAL)lamp->round_mm, NAME(same)(beside), audience->n);
    const NAME(lanes) top = disk.height + disk.rise * disk.radius;
    const NAME(lanes) seen =
        NAME(where_above)(disk.above, touch, NAME(where_above)(top, zero, one - audience->whole, zero), zero);
    NAME(lanes) part = zero;
    if (!NAME(any_above)(seen, zero))
        return;
    const struct NAME(plan) plan = NAME(plan_disk)(law, &disk);
    struct NAME(choice) choice = NAME(choose)(seen, plan.orders.along, plan.orders.across, &audience->left);
    for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice))
        NAME(settle)
    (&choice, i,
     NAME(disk_sum)(law, &disk, &plan.gather, &law->rules->rules[choice.along[i]],
                    &law->rules->rules[choice.across[i]]),
     &part);
    audience->total += disk.above * part;
}

/* ---- the sides of cylinders ---- */

/* A side as elements see it: at y from -1 to 1 a generator at the angle 2 atan(y T) from the direction to them. */
struct NAME(side) {
    struct NAME(space) center, axis, towards, across; /* `towards` an element, and across that and the axis */
    NAME(lanes) tangent, above;                       /* T; how far the element is from the side */
    NAME(lanes) distance;                             /* from what there is of it */
    struct NAME(space) n;
    REAL radius, half;
};

LX_LANE struct NAME(side)
    NAME(side_of_cylinder)(const struct lx_area_light *lamp, const struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0), tiny = NAME(all)((REAL)SMALLEST * 16);
    const REAL axis[3] = {(REAL)lamp->axis[0], (REAL)lamp->axis[1], (REAL)lamp->axis[2]};
    struct NAME(side) side = {.center = audience->to_center,
                              .axis = NAME(same)(axis),
                              .n = audience->n,
                              .radius = (REAL)lamp->round_mm,
                              .half = (REAL)lamp->half_mm};
    const NAME(lanes) along = NAME(dot)(side.center, side.axis);
    const struct NAME(space) out = NAME(along)(NAME(times)(NAME(all)(-1), side.center), along, side.axis);
    const NAME(lanes) away = NAME(root)(NAME(greater)(NAME(dot)(out, out), tiny));
    side.towards = NAME(times)(NAME(inverse)(away), out);
    side.across = NAME(cross)(side.axis, side.towards);
    side.above = NAME(greater)(away - side.radius, zero);
    side.tangent = NAME(root)(side.above * NAME(inverse)(away + side.radius));
    const NAME(lanes) beyond = NAME(greater)(NAME(magnitude)(along) - side.half, zero);
    side.distance = NAME(root)(side.above * side.above + beyond * beyond);
    return side;
}

/* Between -1 and 1 the places y where a rim passes the horizon; the end 1 where it does not. */
LX_LANE void NAME(find_passages)(const struct NAME(side) * side, REAL end, NAME(lanes) passages[2])
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1), tiny = NAME(all)((REAL)SMALLEST * 16);
    const NAME(lanes) height = NAME(dot)(side->n, side->center) + end * NAME(dot)(side->n, side->axis);
    const NAME(lanes) x = side->radius * NAME(dot)(side->n, side->towards),
                      y = side->radius * NAME(dot)(side->n, side->across);
    const NAME(lanes) square = x * x + y * y - height * height, root = NAME(root)(NAME(greater)(square, zero));
    const NAME(lanes) sum = -(y + NAME(where_above)(zero, y, -root, root));
    const NAME(lanes) down = height - x, up = height + x, scale = NAME(inverse)(NAME(greater)(side->tangent, tiny));
    const NAME(lanes) sizes[2] = {NAME(magnitude)(down), NAME(magnitude)(sum)}, tops[2] = {sum, up},
                      bottoms[2] = {down, sum};
    for (int i = 0; i < 2; i++) {
        const NAME(lanes) divisor = NAME(where_above)(sizes[i], tiny, bottoms[i], one);
        NAME(lanes) at = tops[i] * NAME(inverse)(divisor) * scale;
        at = NAME(where_above)(square, zero, NAME(where_above)(sizes[i], tiny, at, one), one);
        passages[i] = NAME(lesser)(NAME(greater)(at, -one), one);
    }
}

LX_LANE void NAME(order_two)(NAME(lanes) * a, NAME(lanes) * b)
{
    const NAME(lanes) first = NAME(lesser)(*a, *b), last = NAME(greater)(*a, *b);
    *a = first, *b = last;
}

/* A row cut by the horizon. */
LX_LANE struct NAME(row) NAME(cut_row)(struct NAME(row) row)
{
    const NAME(lanes) zero = NAME(all)(0), tiny = NAME(all)((REAL)SMALLEST * 16);
    const NAME(lanes) low = NAME(lesser)(row.height0, row.height1), high = NAME(greater)(row.height0, row.height1);
    const NAME(lanes) scale = NAME(inverse)(NAME(greater)(high - low, tiny));
    const NAME(lanes) cut = NAME(lesser)(NAME(greater)(-low, zero) * scale, NAME(all)(1)); /* from the lower end */
    const NAME(lanes) first = NAME(where_above)(row.height1, row.height0, cut, zero),
                      last = NAME(where_above)(row.height1, row.height0, zero, cut);
    const struct NAME(space) e = NAME(minus)(row.v1, row.v0);
    const NAME(lanes) left = 1 - cut;
    row.v0 = NAME(along)(row.v0, first, e);
    row.v1 = NAME(along)(row.v1, -last, e);
    row.height0 = NAME(greater)(row.height0, zero), row.height1 = NAME(greater)(row.height1, zero);
    row.weight0 *= left, row.weight1 *= left;
    return row;
}

/* The share of the side between two places y. */
LX_LANE NAME(lanes) NAME(side_sum)(const struct NAME(law) * law, const struct NAME(side) * side, NAME(lanes) from,
                                   NAME(lanes) to, const struct NAME(gather) * gather,
                                   const struct lx_gauss_rule *along, const struct lx_gauss_rule *across)
{
    const NAME(lanes) span = to - from, middle = (REAL)0.5 * (from + to), zero = NAME(all)(0);
    const struct NAME(space) half = NAME(times)(NAME(all)(side->half), side->axis);
    const NAME(lanes) slant = NAME(dot)(side->n, half);
    NAME(lanes) sum = zero;
    for (unsigned i = 0; i < across->count; i++) {
        NAME(lanes) slope, y = middle + span * NAME(gathered)(gather, across->NAME(places)[i], &slope);
        const NAME(lanes) t = y * side->tangent, inverse = NAME(inverse)(1 + t * t);
        const NAME(lanes) cosine = (1 - t * t) * inverse, sine = 2 * t * inverse;
        const NAME(lanes) above = side->above * (1 - y * y) * inverse, turn = 2 * side->tangent * inverse;
        struct NAME(space) place = NAME(along)(side->center, side->radius * cosine, side->towards);
        place = NAME(along)(place, side->radius * sine, side->across);
        const NAME(lanes) height = NAME(dot)(side->n, place);
        const NAME(lanes) weight = 2 * side->half * side->radius * turn * above;
        const struct NAME(row) whole = {
            NAME(minus)(place, half), NAME(sum_of)(place, half), height - slant, height + slant, weight, weight};
        const struct NAME(row) row = NAME(cut_row)(whole);
        sum += across->NAME(weights)[i] * slope * NAME(row_sum)(law, &row, along);
    }
    return sum * span;
}

static __attribute__((noinline)) void NAME(add_side)(const struct NAME(law) * law, const struct lx_area_light *lamp,
                                                     struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1), touch = NAME(all)((REAL)lamp->touch_mm);
    const struct NAME(side) side = NAME(side_of_cylinder)(lamp, audience);
    const NAME(lanes) outside = NAME(where_above)(side.above, touch, one, zero);
    if (!NAME(any_above)(outside, zero))
        return;
    enum { PASSAGES = 4, ENDS = PASSAGES + 2 };
    NAME(lanes) y[ENDS];
    y[0] = -one, y[ENDS - 1] = one;
    NAME(find_passages)(&side, side.half, y + 1);
    NAME(find_passages)(&side, -side.half, y + 3);
    NAME(order_two)(&y[1], &y[2]), NAME(order_two)(&y[3], &y[4]);
    NAME(order_two)(&y[1], &y[3]), NAME(order_two)(&y[2], &y[4]);
    NAME(order_two)(&y[2], &y[3]);
    const NAME(lanes) along =
        NAME(order_along)(law, NAME(all)(law->pole), NAME(all)(2 * side.half), NAME(greater)(side.distance, touch));
    /* where the horizon runs along generators the place where it cuts them passes the element as quickly as that */
    const NAME(lanes) share = side.distance * (1 / side.half);
    const NAME(lanes) swept = NAME(order_of)(law->digits, share + NAME(root)(1 + share * share));
    for (int k = 0; k + 1 < ENDS; k++) {
        const NAME(lanes) span = y[k + 1] - y[k], middle = (REAL)0.5 * (y[k] + y[k + 1]), t = middle * side.tangent;
        const NAME(lanes) x = NAME(dot)(side.n, side.towards) * (1 - t * t) + NAME(dot)(side.n, side.across) * 2 * t;
        const NAME(lanes) level = NAME(dot)(side.n, side.center) + side.radius * x * NAME(inverse)(1 + t * t);
        const NAME(lanes) tilt = NAME(magnitude)(side.half * NAME(dot)(side.n, side.axis));
        const NAME(lanes) highest = level + tilt, lowest = level - tilt;
        NAME(lanes)
        wanted = outside * NAME(where_above)(span, NAME(all)((REAL)(LX_IS_SINGLE ? 1e-6 : 1e-14)), one, zero);
        wanted *= NAME(where_above)(highest, zero, one, zero);
        if (!NAME(any_above)(wanted, zero))
            continue;
        const NAME(lanes) inverse = NAME(inverse)(NAME(greater)(span, NAME(all)((REAL)1e-14))),
                          place = -middle * inverse;
        const NAME(lanes) inside = NAME(lesser)(NAME(greater)(place, NAME(all)((REAL)-0.5)), NAME(all)((REAL)0.5));
        const NAME(lanes) apart = (place - inside) * (place - inside) + side.tangent * side.tangent * inverse * inverse;
        const struct NAME(gather) gather =
            NAME(gather_at)(inside, NAME(root)(NAME(greater)(apart, NAME(all)((REAL)1e-12))));
        NAME(lanes)
        across = NAME(greater)(NAME(order_across)(law->digits, &gather, NAME(all)((REAL)M_PI_2)),
                               law->digits / 5 * (1 + span));
        across = NAME(where_above)(zero, lowest, NAME(greater)(across, swept), across);
        struct NAME(choice) choice = NAME(choose)(wanted, along, across, &audience->left);
        for (int i = NAME(next_of)(&choice); i < NAME(LX_WIDTH); i = NAME(next_of)(&choice))
            NAME(settle)
        (&choice, i,
         NAME(side_sum)(law, &side, y[k], y[k + 1], &gather, &law->rules->rules[choice.along[i]],
                        &law->rules->rules[choice.across[i]]),
         &audience->total);
    }
}

void LX_OF_ISA(NAME(lx_round_by_rows))(const struct lx_area_light *lamp, const struct lx_gauss_rules *rules,
                                       double diffuse, const struct lx_block_double *block, size_t count,
                                       const struct lx_asking *asking, double *restrict sum, uint8_t *left)
{
    const struct NAME(law) law = NAME(law_of)(lamp, rules);
    for (size_t start = 0; start < count; start += NAME(LX_WIDTH)) {
        struct NAME(audience) audience = NAME(audience_of)(lamp, block, start);
        if (!NAME(any_sees)(lamp, &audience))
            continue;
        if (lamp->has_side) {
            NAME(add_side)(&law, lamp, &audience);
            NAME(add_disk)(&law, lamp, -1, &audience);
        }
        NAME(add_disk)(&law, lamp, 1, &audience);
        NAME(hand_out)(&audience, diffuse * lamp->radiance, start, count, sum, left);
        if (!lx_asking_at_step(asking, start, 1))
            return;
    }
}
