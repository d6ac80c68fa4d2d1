/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by sources that are far away, of any law, by rules with few places, in one precision: those of flat
 * parts, which are the same for all elements that see all of the source (area_light.c), and product rules over what a
 * horizon leaves of a quadrilateral.  Included behind each kernel_space.h.
 */

/* Constants of a law and of the rules. */
struct NAME(law) {
    REAL none, root, square;
    REAL digits;    /* the natural logarithm of what rules may be off by, with its sign turned */
    bool is_steady; /* a(r) is the same everywhere */
    REAL pole;      /* a(r) has poles where 1/r has no greater real part than minus this */
    const struct lx_gauss_rules *rules;
};

LX_LANE struct NAME(law) NAME(law_of)(const struct lx_area_light *lamp, const struct lx_gauss_rules *rules)
{
    return (struct NAME(law)){.none = (REAL)lamp->law.none,
                              .root = (REAL)lamp->law.root,
                              .square = (REAL)lamp->law.square,
                              .digits = (REAL)rules->digits,
                              .is_steady = lamp->law.root == 0 && lamp->law.square == 0,
                              .pole = (REAL)lamp->law.pole,
                              .rules = rules};
}

/* What a loop over vectors of elements has: their ways to the source's centre, normals, and what they get. */
struct NAME(audience) {
    struct NAME(space) n, to_center;
    NAME(lanes) whole; /* 1 for those that rules with few places do for, as all of the source is above their horizon */
    NAME(lanes) total, left;
};

/* a(r)/r^2 */
LX_LANE NAME(lanes) NAME(fall_off)(const struct NAME(law) * law, NAME(lanes) square)
{
    if (law->is_steady)
        return NAME(inverse)(law->none * square);
    NAME(lanes) r = NAME(root)(square);
    return NAME(inverse)(square * (law->none + law->root * r + law->square * square));
}

/* Adds a flat part by its nodes. */
LX_LANE void NAME(add_nodes)(const struct NAME(law) * law, const REAL face[3], const struct lx_area_light_node *nodes,
                             unsigned count, REAL touch, struct NAME(audience) * audience)
{
    const NAME(lanes) zero = NAME(all)(0);
    const struct NAME(space) *n = &audience->n, c = audience->to_center;
    const REAL height = face[0] * nodes->NAME(x) + face[1] * nodes->NAME(y) + face[2] * nodes->NAME(z);
    const NAME(lanes) above = -(NAME(dot)(NAME(same)(face), c) + height);
    const NAME(lanes) seen = NAME(where_above)(above, NAME(all)(touch), audience->whole, zero);
    NAME(lanes) sum = zero;
    if (!NAME(any_above)(seen, zero))
        return;
    for (unsigned i = 0; i < count; i++) {
        const struct NAME(space) way = {c.x + nodes[i].NAME(x), c.y + nodes[i].NAME(y), c.z + nodes[i].NAME(z)};
        sum += nodes[i].NAME(weight) * NAME(dot)(*n, way) * NAME(fall_off)(law, NAME(dot)(way, way));
    }
    audience->total += NAME(where_above)(seen, zero, above * sum, zero);
}

/* A quadrilateral in a plane, maybe with corners that are the same, as ways from the elements, and the heights of the
 * corners above the horizon. */
struct NAME(quad) {
    struct NAME(space) v[4];
    NAME(lanes) height[4];
};

LX_LANE struct NAME(space) NAME(minus)(struct NAME(space) a, struct NAME(space) b)
{
    return (struct NAME(space)){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* The area of a quadrilateral in a plane of the normal n for a unit of s and t: area + s by_s + t by_t. */
struct NAME(extent) {
    NAME(lanes) area, by_s, by_t;
};

LX_LANE struct NAME(extent) NAME(extent_of)(const struct NAME(quad) * quad, struct NAME(space) n)
{
    const struct NAME(space) *v = quad->v;
    struct NAME(space) a = NAME(minus)(v[1], v[0]), b = NAME(minus)(v[3], v[0]);
    struct NAME(space) g = NAME(minus)(NAME(minus)(v[2], v[1]), b);
    return (struct NAME(extent)){NAME(dot)(n, NAME(cross)(a, b)), NAME(dot)(n, NAME(cross)(a, g)),
                                 NAME(dot)(n, NAME(cross)(g, b))};
}

/* The integral of height a(r)/r^2 over a quadrilateral by the product of two rules. */
LX_LANE NAME(lanes)
    NAME(sum_over_quad)(const struct NAME(law) * law, const struct NAME(quad) * quad, struct NAME(space) n,
                        const struct lx_gauss_rule *along, const struct lx_gauss_rule *across)
{
    const struct NAME(space) *v = quad->v;
    const struct NAME(space) b = NAME(minus)(v[3], v[0]), d = NAME(minus)(v[2], v[1]);
    const struct NAME(extent) extent = NAME(extent_of)(quad, n);
    const NAME(lanes) *h = quad->height;
    NAME(lanes) sum = NAME(all)(0);
    for (unsigned i = 0; i < across->count; i++) {
        const NAME(lanes) t = NAME(all)((REAL)0.5 * (1 + across->NAME(places)[i]));
        const struct NAME(space) from = NAME(along)(v[0], t, b), way = NAME(minus)(NAME(along)(v[1], t, d), from);
        const NAME(lanes) height = h[0] + t * (h[3] - h[0]), rise = h[1] + t * (h[2] - h[1]) - height;
        const NAME(lanes) area = extent.area + t * extent.by_t;
        NAME(lanes) row = NAME(all)(0);
        for (unsigned j = 0; j < along->count; j++) {
            const NAME(lanes) s = NAME(all)((REAL)0.5 * (1 + along->NAME(places)[j]));
            const struct NAME(space) w = NAME(along)(from, s, way);
            row += along->NAME(weights)[j] * (height + s * rise) * (area + s * extent.by_s) *
                   NAME(fall_off)(law, NAME(dot)(w, w));
        }
        sum += across->NAME(weights)[i] * row;
    }
    return (REAL)0.25 * sum;
}
