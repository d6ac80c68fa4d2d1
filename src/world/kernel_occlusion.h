/* SPDX-License-Identifier: MIT */
/*
 * What stands in the way of light, for batches of elements: whether a place lies on a surface, what that surface leaves
 * to a normal of its own, and which ways other surfaces close.  kernel_bounded.c includes it behind bounded_lanes.h.
 *
 * The reference decides with bounds, and is in doubt where a way passes an edge by less than they are.  Here the same
 * quantities are formed without bounds and compared with margins that are wider than those bounds could be, in units of
 * the lengths that they come from; what lies within a margin is left to the reference.  So where anything is decided
 * here the reference decides it, too, the same way and without doubt.
 */

/* Some 500 times the bounds of sums of three products, relative to lengths. */
#define MARGIN 0x1p-44
/* Margin of squares, behind a quotient; the place itself is good to MARGIN. */
#define WIDE_MARGIN 0x1p-34

struct plain3 {
    lanes_double x, y, z;
};

LX_LANE struct plain3 values_of(const struct lx_columns3 *columns, size_t i)
{
    return (struct plain3){load_double(columns->x.value + i), load_double(columns->y.value + i),
                           load_double(columns->z.value + i)};
}

LX_LANE lanes_double inner(struct plain3 a, struct plain3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LX_LANE struct plain3 constant3(const double v[3])
{
    return (struct plain3){all_double(v[0]), all_double(v[1]), all_double(v[2])};
}

LX_LANE struct plain3 difference3(struct plain3 a, struct plain3 b)
{
    return (struct plain3){a.x - b.x, a.y - b.y, a.z - b.z};
}

LX_LANE struct plain3 sum3(struct plain3 a, struct plain3 b)
{
    return (struct plain3){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* No less than the length, and at most 1.8 times as much. */
LX_LANE lanes_double length_at_most(struct plain3 a)
{
    return size_of(a.x) + size_of(a.y) + size_of(a.z);
}

LX_LANE lanes_double error_of_place(const struct lx_elements *elements, size_t i)
{
    return load_double(elements->place_mm.x.error + i) + load_double(elements->place_mm.y.error + i) +
           load_double(elements->place_mm.z.error + i);
}

/* 1 where a > b, else 0. */
LX_LANE lanes_double is_above(lanes_double a, lanes_double b)
{
    return only_above(a, b, all_double(1));
}

LX_LANE lanes_double either(lanes_double a, lanes_double b)
{
    return greater_double(a, b);
}

LX_LANE lanes_double not_so(lanes_double a)
{
    return 1 - a;
}

/* The surfaces that elements lie on, as numbers. */
LX_LANE lanes_double owners_of(const struct lx_elements *elements, size_t i)
{
    typedef uint32_t words __attribute__((vector_size(LX_VECTOR_BYTES / 2)));
    words own;
    memcpy(&own, elements->own + i, sizeof own);
    return __builtin_convertvector(own, lanes_double);
}

/* 1 where elements lie on a surface. */
LX_LANE lanes_double lies_on(const struct lx_elements *elements, size_t i, uint32_t surface)
{
    const lanes_double apart = owners_of(elements, i) - (double)surface;
    return not_so(is_above(size_of(apart), all_double(0.5)));
}

LX_LANE struct plain3 way_from(const struct lx_ways *ways, struct plain3 place)
{
    const struct plain3 to = constant3(ways->to);
    return ways->endless ? to : difference3(to, place);
}

/* Closes ways, and tells which are in doubt; each 1 or 0. */
LX_LANE void close_ways(struct lx_openness *openness, size_t i, lanes_double closed, lanes_double in_doubt)
{
    const lanes_double half = all_double(0.5);
    store_double(openness->open.value + i,
                 where_above_double(closed, half, all_double(0), load_double(openness->open.value + i)));
    if (!any_above_double(in_doubt, half))
        return;
    openness->any_in_doubt = true;
    for (size_t k = 0; k < LX_WIDTH_double; k++)
        openness->in_doubt[i + k] = openness->in_doubt[i + k] || in_doubt[k] > 0.5;
}

/* ---- the surface that an element lies on ---- */

static void take(struct lx_elements *elements, size_t i, uint32_t surface, lanes_double apart, lanes_double within)
{
    for (size_t k = 0; k < LX_WIDTH_double; k++)
        if (elements->own[i + k] == 0 && apart[k] <= within[k])
            elements->own[i + k] = surface;
}

/* As sphere_holds(), bit for bit. */
static void hold_sphere(const struct lx_shape *sphere, uint32_t surface, struct lx_elements *elements)
{
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 p = difference3(values_of(&elements->place_mm, i), constant3(sphere->anchor_mm));
        const struct power_of_two scale = scale_for(p.x, p.y, p.z);
        const struct plain3 near = {p.x * scale.value, p.y * scale.value, p.z * scale.value};
        const lanes_double length = square_root(inner(near, near)) * scale.inverse;
        take(elements, i, surface, size_of(length - sphere->radius_mm), all_double(1e-9 * sphere->radius_mm));
    }
}

/* As plate_holds(), bit for bit. */
static void hold_plate(const struct lx_shape *plate, uint32_t surface, struct lx_elements *elements)
{
    const double near = 1e-9 * plate->radius_mm;
    const lanes_double zero = all_double(0);
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 from = difference3(values_of(&elements->place_mm, i), constant3(plate->anchor_mm));
        lanes_double apart = only_above(size_of(inner(from, constant3(plate->axis))), all_double(near), all_double(1));
        for (int k = 0; k < 2; k++) {
            const lanes_double along = inner(from, constant3(k == 0 ? plate->across : plate->upward));
            apart = either(apart, is_above(size_of(along), all_double(plate->half_mm[k] + near)));
        }
        take(elements, i, surface, apart, zero);
    }
}

/* ---- what that surface leaves ---- */

/* Where elements lie on a surface and their normal is not its own, by the cosine between them, keeps the side. */
LX_LANE void keep_sides(struct lx_elements *elements, size_t i, lanes_double on, lanes_double cosine,
                        lanes_double in_doubt, struct plain3 side)
{
    const double doubt = 1e-12, least = 1 - LX_SAME_NORMAL;
    const lanes_double zero = all_double(0), half = all_double(0.5);
    lanes_double turned = is_above(all_double(least - doubt), cosine) * on;
    in_doubt = either(in_doubt, is_above(all_double(least + doubt), cosine) * not_so(turned)) * on;
    turned *= not_so(in_doubt);
    store_double(elements->side_x + i, where_above_double(turned, half, side.x, load_double(elements->side_x + i)));
    store_double(elements->side_y + i, where_above_double(turned, half, side.y, load_double(elements->side_y + i)));
    store_double(elements->side_z + i, where_above_double(turned, half, side.z, load_double(elements->side_z + i)));
    elements->has_sides = elements->has_sides || any_above_double(turned + in_doubt, zero);
    for (size_t k = 0; any_above_double(in_doubt, zero) && k < LX_WIDTH_double; k++)
        elements->asks[i + k] = elements->asks[i + k] || in_doubt[k] > 0;
}

/* As sphere_hides(): an element that looks outwards loses what is below the tangent plane; one that looks inwards, the
 * reference knows. */
static void settle_sphere(const struct lx_shape *sphere, uint32_t surface, struct lx_elements *elements)
{
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 from = difference3(values_of(&elements->place_mm, i), constant3(sphere->anchor_mm));
        const lanes_double cosine = inner(from, values_of(&elements->normal, i)) / square_root(inner(from, from));
        keep_sides(elements, i, lies_on(elements, i, surface), cosine, is_above(all_double(1e-12), cosine), from);
    }
}

/* As plate_hides(): it is on the side that it looks to; a wall of a room hides itself from what looks at its back. */
static void settle_plate(const struct lx_shape *plate, uint32_t surface, struct lx_elements *elements)
{
    const struct plain3 axis = constant3(plate->axis);
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const lanes_double cosine = inner(axis, values_of(&elements->normal, i));
        const lanes_double sign = where_above_double(all_double(0), cosine, all_double(-1), all_double(1));
        const struct plain3 side = {axis.x * sign, axis.y * sign, axis.z * sign};
        keep_sides(elements, i, lies_on(elements, i, surface), plate->behind_mm > 0 ? cosine : size_of(cosine),
                   is_above(all_double(1e-12), size_of(cosine)), side);
    }
}

static void close_own(const struct lx_ways *ways, const struct lx_elements *elements, struct lx_openness *openness)
{
    const lanes_double zero = all_double(0);
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 side = {load_double(elements->side_x + i), load_double(elements->side_y + i),
                                    load_double(elements->side_z + i)};
        const struct plain3 way = way_from(ways, values_of(&elements->place_mm, i));
        const lanes_double long_side = length_at_most(side), long_way = length_at_most(way);
        const lanes_double margin =
            MARGIN * ways->room * long_side * long_way + 4 * error_of_place(elements, i) * (long_side + long_way);
        const lanes_double above = inner(side, way), has_side = is_above(long_side, zero);
        lanes_double in_doubt = not_so(is_above(size_of(above), margin)) * has_side;
        for (size_t k = 0; k < LX_WIDTH_double; k++)
            in_doubt[k] = elements->asks[i + k] ? 1 : in_doubt[k];
        close_ways(openness, i, is_above(-above, margin) * has_side, in_doubt);
    }
}

/* ---- other surfaces ---- */

/*
 * As sphere_blocks(): the nearest point of the way to the centre, cut to the way's ends, is within the sphere, unless
 * both ends are.
 */
static void close_sphere(const struct lx_shape *sphere, uint32_t surface, const struct lx_ways *ways,
                         const struct lx_elements *elements, struct lx_openness *openness)
{
    const double r2 = sphere->radius_mm * sphere->radius_mm, farthest = ways->endless ? HUGE_VAL : 1;
    const double wide_margin = WIDE_MARGIN * ways->room;
    const lanes_double zero = all_double(0);
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 place = values_of(&elements->place_mm, i), way = way_from(ways, place);
        const struct plain3 p = difference3(place, constant3(sphere->anchor_mm));
        const lanes_double p2 = inner(p, p), w2 = inner(way, way);
        const lanes_double t = lesser_double(greater_double(-inner(p, way) / w2, zero), all_double(farthest));
        const struct plain3 nearest = {p.x + t * way.x, p.y + t * way.y, p.z + t * way.z};
        const lanes_double d2 = inner(nearest, nearest), margin = wide_margin * (p2 + r2 + t * t * w2);
        const lanes_double passes = is_above(d2, r2 + margin), reached = is_above(r2 - margin, d2);
        lanes_double leaves = all_double(1), both_inside = zero;
        if (!ways->endless) {
            const struct plain3 end = sum3(p, way);
            const lanes_double e2 = inner(end, end), wide = wide_margin * (p2 + r2 + w2);
            leaves = either(is_above(p2, r2 + wide), is_above(e2, r2 + wide));
            both_inside = is_above(r2 - wide, p2) * is_above(r2 - wide, e2);
        }
        const lanes_double error = error_of_place(elements, i), small = lesser_double(w2, all_double(r2));
        const lanes_double other = not_so(lies_on(elements, i, surface));
        const lanes_double known = is_above(MARGIN * MARGIN * small, error * error) * other;
        const lanes_double closed = reached * leaves * known;
        const lanes_double open = either(passes, reached * both_inside) * known;
        close_ways(openness, i, closed, other - closed - open);
    }
}

/* As plate_blocks(): the ends of the way are on different sides, and it crosses the plane within the edges. */
static void close_plate(const struct lx_shape *plate, uint32_t surface, const struct lx_ways *ways,
                        const struct lx_elements *elements, struct lx_openness *openness)
{
    const struct plain3 axis = constant3(plate->axis);
    const lanes_double zero = all_double(0);
    const double touch = plate->touch_mm, end_touch = ways->endless ? 0 : touch, margin_of = MARGIN * ways->room;
    for (size_t i = 0; i < elements->count; i += LX_WIDTH_double) {
        const struct plain3 place = values_of(&elements->place_mm, i), way = way_from(ways, place);
        const struct plain3 from = difference3(place, constant3(plate->anchor_mm));
        const lanes_double error = error_of_place(elements, i), far = length_at_most(from),
                           long_way = length_at_most(way);
        const lanes_double start = inner(from, axis), change = inner(way, axis);
        const lanes_double end = ways->endless ? change : inner(sum3(from, way), axis);
        const lanes_double beyond = where_above_double(zero, start, end, -end), height = size_of(start);
        const lanes_double start_margin = margin_of * far + 4 * error;
        const lanes_double end_margin = margin_of * (far + long_way) + 4 * error;
        lanes_double closed = is_above(height - touch, start_margin) * is_above(beyond - end_touch, end_margin);
        lanes_double open = either(is_above(touch - height, start_margin), is_above(end_touch - beyond, end_margin)) *
                            is_above(height + touch, start_margin);
        for (int k = 0; k < 2; k++) {
            const struct plain3 edge = constant3(k == 0 ? plate->across : plate->upward);
            const double half = plate->half_mm[k];
            const lanes_double offset = size_of(inner(from, edge) * change - start * inner(way, edge));
            const lanes_double room = half * size_of(change) - offset;
            const lanes_double margin = margin_of * long_way * (4 * far + half) + 8 * error * (far + long_way + half);
            closed *= is_above(room - touch * size_of(change), margin); /* beyond the edge itself it is in doubt */
            open = either(open, is_above(-room, margin));
        }
        const lanes_double other = not_so(lies_on(elements, i, surface));
        close_ways(openness, i, closed * other, (1 - closed - open) * other);
    }
}
