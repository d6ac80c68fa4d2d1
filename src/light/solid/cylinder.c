/* SPDX-License-Identifier: MIT */
/*
 * The contour of a cylinder as an element sees it.  Seen from beyond the plane of a cap and within its radius it is
 * that cap's rim.  Else the two generators that the element's tangents touch part each rim into a near and a far arc,
 * and the contour is, counter-clockwise about the way to the cylinder:
 *
 *     the near cap's rim, its far arc where that cap is seen, its near arc (backwards) where it is not,
 *     a generator, the near arc of the far cap's rim, the other generator.
 *
 * In the plane of a cap both its arcs add the same.  The horizon crosses the contour of a convex body twice or not at
 * all.
 */
#include "rim.h"

/* Bits of the four corners, where generators meet rims. */
struct corner {
    struct lx_mark mark;
    lx_wide above; /* N.r */
    bool seen;
};

struct walk {
    struct lx_wide_sum *sum;
    struct lx_rim rims[2]; /* of the near cap, of the far one */
    struct lx_horizon horizons[2];
    struct corner corners[2][2]; /* by rim and side: the side of positive v, the other one */
    lx_wide caps[2];             /* the heights of the rims above the near cap */
    lx_wide tangent;             /* the length of the way to a generator, across the axis */
    lx_wide near_turn, far_turn; /* of the arcs */
    bool crossed;
    lx_wide3 exit, entry; /* through the horizon: from the middle of the near cap */
};

/* A place on the side, from the middle of the near cap. */
static lx_wide3 from_cap(lx_wide radius, struct lx_mark mark, lx_wide z)
{
    return (lx_wide3){lx_wide_mul(radius, mark.cosine), lx_wide_mul(radius, mark.sine), z};
}

/* From 0 to a full turn. */
static lx_wide turn_between(struct lx_mark from, struct lx_mark to)
{
    lx_wide sine = lx_wide_sub(lx_wide_mul(from.cosine, to.sine), lx_wide_mul(from.sine, to.cosine));
    lx_wide cosine = lx_wide_add(lx_wide_mul(from.cosine, to.cosine), lx_wide_mul(from.sine, to.sine));
    lx_wide turn = lx_wide_atan2(sine, cosine);
    /* an empty arc may have come out backwards */
    if (turn.high < -0x1p-90)
        return lx_wide_add(turn, lx_wide_scale(lx_wide_pi(), 2));
    return turn.high < 0 ? lx_wide_of(0) : turn;
}

/* Adds a visible arc that runs counter-clockwise. */
static void add_part(struct walk *walk, int rim, struct lx_mark from, struct lx_mark to, double sign)
{
    lx_add_arc(walk->sum, &walk->rims[rim], from, to, turn_between(from, to), sign);
}

static void cross_horizon(struct walk *walk, bool enters, lx_wide3 place)
{
    walk->crossed = true;
    if (enters)
        walk->entry = place;
    else
        walk->exit = place;
}

/* Adds what is seen of the counter-clockwise arc from one side's corner to the other's; with sign -1 the contour runs
 * along it backwards. */
static void add_seen_arc(struct walk *walk, int index, int from_side, lx_wide turn, double sign)
{
    const struct lx_rim *rim = &walk->rims[index];
    const struct lx_horizon *horizon = &walk->horizons[index];
    const struct corner *from = &walk->corners[index][from_side], *to = &walk->corners[index][1 - from_side];
    struct lx_mark rise = horizon->crossed ? horizon->rise : to->mark;
    struct lx_mark set = horizon->crossed ? horizon->set : from->mark;
    if (from->seen != to->seen) {
        if (from->seen)
            add_part(walk, index, from->mark, set, sign);
        else
            add_part(walk, index, rise, to->mark, sign);
        cross_horizon(walk, to->seen == (sign > 0), from_cap(rim->radius, from->seen ? set : rise, walk->caps[index]));
        return;
    }
    /* Both ends are alike: the horizon crosses twice where the highest, or lowest, place lies between them. */
    struct lx_mark extreme = horizon->top;
    if (from->seen)
        extreme = (struct lx_mark){lx_wide_negate(extreme.cosine), lx_wide_negate(extreme.sine)};
    bool twice = horizon->crossed && lx_wide_compare(turn_between(from->mark, extreme), turn) < 0;
    if (!twice) {
        if (from->seen)
            lx_add_arc(walk->sum, rim, from->mark, to->mark, turn, sign);
        return;
    }
    if (from->seen) {
        add_part(walk, index, from->mark, set, sign);
        add_part(walk, index, rise, to->mark, sign);
    } else {
        lx_add_arc(walk->sum, rim, rise, set, lx_wide_scale(horizon->half_turn, 2), sign);
    }
    cross_horizon(walk, sign > 0, from_cap(rim->radius, rise, walk->caps[index]));
    cross_horizon(walk, sign < 0, from_cap(rim->radius, set, walk->caps[index]));
}

/*
 * Adds what is seen of a generator from one rim to the other.  It passes the element at the distance l = |tangent|,
 * and its foot f, of the height of the element, is perpendicular to it: theta = atan2(l (z2 - z1), l^2 + z1 z2).
 */
static void add_generator(struct walk *walk, int side, int from_rim)
{
    const struct corner *from = &walk->corners[from_rim][side], *to = &walk->corners[1 - from_rim][side];
    if (!from->seen && !to->seen)
        return;
    lx_wide z1 = walk->rims[from_rim].height, z2 = walk->rims[1 - from_rim].height;
    lx_wide length = lx_wide_sub(walk->caps[1 - from_rim], walk->caps[from_rim]);
    if (from->seen != to->seen) {
        lx_wide span = lx_wide_sub(from->above, to->above), part = lx_wide_mul(length, lx_wide_div(from->above, span));
        lx_wide z = lx_wide_add(walk->caps[from_rim], part);
        cross_horizon(walk, to->seen, from_cap(walk->rims[0].radius, from->mark, z));
        if (from->seen) {
            length = part;
            z2 = lx_wide_add(z1, part);
        } else {
            length = lx_wide_negate(lx_wide_mul(length, lx_wide_div(to->above, span)));
            z1 = lx_wide_add(z1, part);
        }
    }
    lx_wide l = walk->tangent;
    if (!(l.high > 0))
        return;
    lx_wide square = lx_wide_add(lx_wide_mul(l, l), lx_wide_mul(z1, z2));
    lx_wide angle = lx_wide_atan2(lx_wide_mul(l, length), square);
    /* N.(f x a)/l; f/l = (l, +-R)/rho */
    const lx_wide3 *n = &walk->rims[0].normal;
    lx_wide fx = walk->corners[0][0].mark.sine, fy = from->mark.cosine;
    if (side == 0)
        fy = lx_wide_negate(fy);
    lx_wide across = lx_wide_sub(lx_wide_mul(n->x, fy), lx_wide_mul(n->y, fx));
    lx_wide term = lx_wide_mul(angle, across);
    walk->sum->value = lx_wide_add(walk->sum->value, term);
    walk->sum->size += 4 * fabs(angle.high) * hypot(n->x.high, n->y.high);
}

static void set_corner(struct walk *walk, int rim, int side, lx_wide cosine, lx_wide sine)
{
    struct corner *corner = &walk->corners[rim][side];
    corner->mark = (struct lx_mark){cosine, side == 0 ? sine : lx_wide_negate(sine)};
    corner->above = lx_wide3_dot(walk->rims[rim].normal, lx_rim_place(&walk->rims[rim], corner->mark));
    corner->seen = corner->above.high >= 0;
}

void lx_add_cylinder(struct lx_wide_sum *sum, lx_wide rho, lx_wide middle, lx_wide radius, lx_wide half_height,
                     lx_wide3 normal)
{
    struct walk walk = {.sum = sum};
    lx_wide near = lx_wide_sub(middle, half_height), far = lx_wide_add(middle, half_height);
    walk.rims[0] = lx_rim_of(rho, near, radius, normal);
    walk.horizons[0] = lx_rim_horizon(&walk.rims[0]);
    if (lx_wide_compare(rho, radius) <= 0) {
        if (near.high > 0)
            lx_add_disk(sum, &walk.rims[0], &walk.horizons[0]);
        return;
    }
    walk.rims[1] = lx_rim_of(rho, far, radius, normal);
    walk.horizons[1] = lx_rim_horizon(&walk.rims[1]);
    walk.caps[1] = lx_wide_scale(half_height, 2);
    walk.tangent = lx_wide_mul(lx_wide_sqrt(lx_wide_sub(rho, radius)), lx_wide_sqrt(lx_wide_add(rho, radius)));
    lx_wide cosine = lx_wide_negate(lx_wide_div(radius, rho)), sine = lx_wide_div(walk.tangent, rho);
    walk.near_turn = lx_wide_scale(lx_wide_atan2(walk.tangent, radius), 2);
    walk.far_turn = lx_wide_scale(lx_wide_atan2(walk.tangent, lx_wide_negate(radius)), 2);
    for (int rim = 0; rim < 2; rim++)
        for (int side = 0; side < 2; side++)
            set_corner(&walk, rim, side, cosine, sine);
    /* side 0, at positive v: counter-clockwise from there the arcs are near ones */
    if (near.high > 0)
        add_seen_arc(&walk, 0, 1, walk.far_turn, 1);
    else
        add_seen_arc(&walk, 0, 0, walk.near_turn, -1);
    add_generator(&walk, 0, 0);
    add_seen_arc(&walk, 1, 0, walk.near_turn, 1);
    add_generator(&walk, 1, 1);
    if (walk.crossed) {
        lx_wide3 way = lx_wide3_sub(walk.entry, walk.exit);
        lx_wide3 center = {rho, lx_wide_of(0), near};
        lx_add_chord(sum, normal, lx_wide3_add(walk.exit, center), lx_wide3_add(walk.entry, center), way);
    }
}
