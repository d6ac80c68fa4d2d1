/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by convex facets in closed form, in one precision.  Included by kernel.c behind each kernel_real.h,
 * whose vectors it uses.
 *
 * With c the way to the source's centre, a = c + u and b = a + e the ends of an edge of the contour, which is closed by
 * the chord in the horizon's plane, and F = angle(a, b)/|a x b|,
 *
 *     E = -radiance/2 sum F N.(a x e)         (the contour counter-clockwise as the element sees it)
 *
 * cancels for small sources.  The sum of all e is 0, hence also
 *
 *     E = -radiance/2 sum (F - 1/c^2) N.(c x e) + F N.(u x e),
 *
 * where nothing does: with t = |a x b|/(a.b) and d = a.b - c^2, F - 1/c^2 = -(gap(t^2) + d/c^2)/(a.b), where
 * gap(z) = 1 - atan(sqrt z)/sqrt z.  This is taken where the source is far, which means that no edge is seen under more
 * than 45 degrees; else F comes from the cosine of the angle.
 *
 * Signs count from `touch` on: a face seen along its own plane is not seen, a corner on the horizon is above it,
 * whatever rounding says, so that the edges that meet in a corner, or in a face, agree.
 *
 * An element's sum does not depend on the elements beside it: shortcuts are taken only where they give the same bytes.
 */

/* A vector of elements and their ways to the source's centre. */
struct NAME(outlook) {
    struct NAME(space) n, c;
    NAME(lanes) square, inverse; /* c^2, 1/c^2 */
    NAME(lanes) beyond_near;     /* above 0 where the source is far */
    NAME(lanes) height;          /* of the centre above the horizon */
};

/* An edge, or its part above the horizon: u where it begins, from the centre, e on to its end, u x e, and the sum of
 * both ends and their dot product. */
struct NAME(edge) {
    struct NAME(space) u, e, moment, both;
    NAME(lanes) product;
};

/* An edge's share of -2 E, where the source is far. */
LX_LANE NAME(lanes) NAME(far_term)(const struct NAME(outlook) * at, const struct NAME(edge) * edge)
{
    struct NAME(space) q = NAME(cross)(at->c, edge->e), g = NAME(sum_of)(q, edge->moment);
    NAME(lanes) beyond = NAME(dot)(at->c, edge->both) + edge->product;
    NAME(lanes) inverse = NAME(inverse)(at->square + beyond);
    NAME(lanes) gap = NAME(gap_of)(NAME(dot)(g, g) * inverse * inverse);
    NAME(lanes) less = (gap + beyond * at->inverse) * inverse, f = (1 - gap) * inverse;
    return f * NAME(dot)(at->n, edge->moment) - less * NAME(dot)(at->n, q);
}

/* The term of an edge that is near. */
LX_LANE NAME(lanes) NAME(near_term)(const struct NAME(outlook) * at, const struct NAME(edge) * edge)
{
    const NAME(lanes) zero = NAME(all)(0), smallest = NAME(all)((REAL)SMALLEST);
    struct NAME(space) a = NAME(sum_of)(at->c, edge->u), g = NAME(cross)(a, edge->e);
    NAME(lanes) cosine = NAME(dot)(a, NAME(sum_of)(a, edge->e)), sine2 = NAME(dot)(g, g);
    NAME(lanes) inverse = NAME(inverse_root)(NAME(greater)(cosine * cosine + sine2, smallest));
    cosine *= inverse;
    NAME(lanes) size = NAME(magnitude)(cosine), f = NAME(arc_over_sine)(1 - size) * inverse;
    if (NAME(any_above)(zero, cosine)) {
        NAME(lanes) obtuse = (REAL)M_PI * NAME(inverse_root)(NAME(greater)(sine2, smallest)) - f;
        f = NAME(where_above)(zero, cosine, obtuse, f);
    }
    return f * NAME(dot)(at->n, g);
}

/* Both are evaluated only where some elements are near and others far. */
LX_LANE NAME(lanes) NAME(edge_term)(const struct NAME(outlook) * at, const struct NAME(edge) * edge)
{
    const NAME(lanes) zero = NAME(all)(0);
    if (!NAME(any_above)(at->beyond_near, zero))
        return NAME(near_term)(at, edge);
    NAME(lanes) far = NAME(far_term)(at, edge);
    if (NAME(all_above)(at->beyond_near, zero))
        return far;
    return NAME(where_above)(at->beyond_near, zero, far, NAME(near_term)(at, edge));
}

/* Where a contour, as offsets from the source's centre, passes the horizon. */
struct NAME(passage) {
    struct NAME(space) exit, entry;
    NAME(lanes) cut; /* 1 where it does */
};

/*
 * An edge's share of -2 E where it is above the horizon, and whether it passes through; weight 1: along it, -1: against
 * it, 0: not at all.  The heights of its ends count from -touch on.
 */
LX_LANE NAME(lanes)
    NAME(clipped_term)(const struct NAME(outlook) * at, const struct NAME(edge) * edge, NAME(lanes) from,
                       NAME(lanes) to, NAME(lanes) weight, struct NAME(passage) * passage)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1);
    NAME(lanes) change = from - to, size = NAME(magnitude)(change);
    NAME(lanes) at_horizon = from * NAME(inverse)(NAME(where_above)(size, NAME(all)((REAL)SMALLEST), change, one));
    at_horizon = NAME(lesser)(NAME(greater)(at_horizon, zero), one);
    NAME(lanes) first = NAME(where_above)(zero, from, at_horizon, zero);
    NAME(lanes) last = NAME(where_above)(zero, to, at_horizon, one), part = last - first;
    struct NAME(space) place = NAME(along)(edge->u, at_horizon, edge->e);
    struct NAME(edge) above = {.u = NAME(along)(edge->u, first, edge->e), .e = NAME(times)(part, edge->e)};
    struct NAME(space) end = NAME(along)(edge->u, last, edge->e);
    above.moment = NAME(times)(part, edge->moment);
    above.both = NAME(space_where_above)(one, part, NAME(sum_of)(above.u, end), edge->both);
    above.product = NAME(where_above)(one, part, NAME(dot)(above.u, end), edge->product);
    NAME(lanes) term = NAME(edge_term)(at, &above);
    /* leaves 1: goes below the horizon; -1: comes up again */
    NAME(lanes) down = NAME(where_above)(zero, from, zero, weight), up = NAME(where_above)(zero, to, zero, weight);
    NAME(lanes) leaves = NAME(where_above)(zero, to, down, zero) - NAME(where_above)(zero, from, up, zero);
    passage->exit = NAME(space_where_above)(leaves, zero, place, passage->exit);
    passage->entry = NAME(space_where_above)(zero, leaves, place, passage->entry);
    passage->cut = NAME(where_above)(leaves, zero, one, passage->cut);
    return NAME(where_above)(zero, NAME(greater)(from, to), zero, weight * term);
}

/* The chord from the exit to the entry closes what the horizon cuts off. */
LX_LANE NAME(lanes) NAME(chord_term)(const struct NAME(outlook) * at, const struct NAME(passage) * passage)
{
    const NAME(lanes) zero = NAME(all)(0), minus = NAME(all)(-1);
    struct NAME(edge) chord = {.u = passage->exit, .e = NAME(along)(passage->entry, minus, passage->exit)};
    chord.moment = NAME(cross)(passage->exit, chord.e);
    chord.both = NAME(sum_of)(passage->exit, passage->entry);
    chord.product = NAME(dot)(passage->exit, passage->entry);
    return NAME(where_above)(passage->cut, zero, NAME(edge_term)(at, &chord), zero);
}

/* What a vector of elements sees of a face: 1 or 0. */
LX_LANE NAME(lanes)
    NAME(sees)(const struct NAME(outlook) * at, const struct NAME(lx_area_light_face) * face, REAL touch)
{
    NAME(lanes) height = -NAME(dot)(NAME(same)(face->normal), at->c);
    return NAME(where_above)(height, NAME(all)(face->height + touch), NAME(all)(1), NAME(all)(0));
}

/* A ball around the places of a block. */
static struct lx_around NAME(around)(const struct NAME(lx_block) * block, size_t count)
{
    const REAL *places[3] = {block->px, block->py, block->pz};
    struct lx_around around = {.radius = 0};
    double square = 0;
    for (int k = 0; k < 3; k++) {
        NAME(lanes) lowest = NAME(load)(places[k]), highest = lowest;
        for (size_t i = NAME(LX_WIDTH); i < count; i += NAME(LX_WIDTH)) {
            lowest = NAME(lesser)(NAME(load)(places[k] + i), lowest);
            highest = NAME(greater)(NAME(load)(places[k] + i), highest);
        }
        REAL low = lowest[0], high = highest[0];
        for (int lane = 1; lane < NAME(LX_WIDTH); lane++) {
            low = lowest[lane] < low ? lowest[lane] : low;
            high = highest[lane] > high ? highest[lane] : high;
        }
        const double half = ((double)high - (double)low) / 2;
        around.center[k] = (double)low + half;
        square += half * half;
    }
    around.radius = (1 + 1e-12) * sqrt(square);
    return around;
}

/* What all of a block's elements see of a face: 1, they do; -1, none does; 0, some may. */
static int NAME(side_of)(const struct lx_area_light *lamp, const struct NAME(lx_area_light_face) * face,
                         const struct lx_around *around)
{
    double above = -(double)face->height, away = 0;
    for (int i = 0; i < 3; i++) {
        double offset = around->center[i] - lamp->center[i];
        above += (double)face->normal[i] * offset;
        away += fabs(offset);
    }
    double rounding = LX_IS_SINGLE ? 0x1p-20 * (away + lamp->radius_mm) : 2 * lamp->touch_mm;
    double doubt = around->radius + rounding;
    return above > doubt ? 1 : above < -doubt ? -1 : 0;
}

/* An edge that elements of a block may have on their contour. */
struct NAME(candidate) {
    const struct NAME(lx_area_light_edge) * edge;
    REAL weight; /* for all elements; 0: each has its own */
};

static bool NAME(is_candidate)(const struct lx_area_light *lamp, const struct lx_around *around,
                               struct NAME(candidate) * candidate)
{
    const struct NAME(lx_area_light_edge) *edge = candidate->edge;
    const struct NAME(lx_area_light_face) *faces = lamp->NAME(faces);
    const int left = NAME(side_of)(lamp, &faces[edge->left], around);
    const int right = edge->right < 0 ? -1 : NAME(side_of)(lamp, &faces[edge->right], around);
    candidate->weight = left == 0 || right == 0 ? 0 : (REAL)((left - right) / 2);
    return left == 0 || left != right;
}

/* What is known of the contours of a vector of elements. */
struct NAME(contour) {
    NAME(lanes) sum; /* -2 E */
    struct NAME(passage) passage;
};

/* What a vector of elements has above its horizon: all of the source, some, nothing. */
enum NAME(share) { NAME(LX_ALL), NAME(LX_SOME), NAME(LX_NOTHING) };

LX_LANE enum NAME(share)
    NAME(share_above)(const struct lx_area_light *lamp, const struct NAME(outlook) * at, double away)
{
    /* with room for rounding, so that no corner of what counts as whole is below by that */
    const double rounding = (LX_IS_SINGLE ? 0x1p-20 : 0x1p-49) * (away + lamp->radius_mm);
    const NAME(lanes) reach = NAME(all)((REAL)(1.001 * lamp->radius_mm + lamp->touch_mm + rounding));
    if (!NAME(any_above)(at->height, -reach))
        return NAME(LX_NOTHING);
    return NAME(all_above)(at->height, reach) ? NAME(LX_ALL) : NAME(LX_SOME);
}

LX_LANE struct NAME(outlook)
    NAME(outlook_of)(const struct lx_area_light *lamp, const struct NAME(lx_block) * block, size_t i)
{
    const REAL far_square = (REAL)(7 * lamp->radius_mm * lamp->radius_mm); /* 1/sin(22.5 degrees)^2 is 6.83 */
    struct NAME(outlook) at = {.n = {NAME(load)(block->nx + i), NAME(load)(block->ny + i), NAME(load)(block->nz + i)}};
    at.c.x = (REAL)lamp->center[0] - NAME(load)(block->px + i);
    at.c.y = (REAL)lamp->center[1] - NAME(load)(block->py + i);
    at.c.z = (REAL)lamp->center[2] - NAME(load)(block->pz + i);
    at.square = NAME(dot)(at.c, at.c);
    at.inverse = NAME(inverse)(NAME(greater)(at.square, NAME(all)((REAL)SMALLEST)));
    at.beyond_near = at.square - far_square;
    at.height = NAME(dot)(at.n, at.c);
    return at;
}

/* The edge's weight for each element, by the faces on its sides. */
LX_LANE NAME(lanes) NAME(weigh)(const struct lx_area_light *lamp, const struct NAME(candidate) * candidate,
                                const struct NAME(outlook) * at)
{
    const struct NAME(lx_area_light_face) *faces = lamp->NAME(faces);
    const struct NAME(lx_area_light_edge) *edge = candidate->edge;
    const REAL touch = (REAL)lamp->touch_mm;
    if (candidate->weight != 0)
        return NAME(all)(candidate->weight);
    NAME(lanes) left = NAME(sees)(at, &faces[edge->left], touch);
    return edge->right < 0 ? left : left - NAME(sees)(at, &faces[edge->right], touch);
}

LX_LANE struct NAME(edge) NAME(edge_of)(const struct NAME(lx_area_light_edge) * edge)
{
    return (struct NAME(edge)){NAME(same)(edge->from), NAME(same)(edge->along), NAME(same)(edge->moment),
                               NAME(same)(edge->both), NAME(all)(edge->product)};
}

/* Adds candidates to the contours of a vector of elements. */
LX_LANE void NAME(add_edges)(const struct lx_area_light *lamp, const struct NAME(candidate) * candidates, size_t count,
                             const struct NAME(outlook) * at, enum NAME(share) share, struct NAME(contour) * contour)
{
    const NAME(lanes) center = at->height + (REAL)lamp->touch_mm;
    for (size_t k = 0; k < count; k++) {
        const struct NAME(lx_area_light_edge) *whole = candidates[k].edge;
        const struct NAME(edge) edge = NAME(edge_of)(whole);
        const NAME(lanes) weight = NAME(weigh)(lamp, &candidates[k], at);
        if (share == NAME(LX_ALL)) {
            contour->sum += weight * NAME(edge_term)(at, &edge);
            continue;
        }
        NAME(lanes) from = center + NAME(dot)(at->n, edge.u);
        NAME(lanes) to = center + NAME(dot)(at->n, NAME(same)(whole->to));
        if (!NAME(any_above)(NAME(all)(0), NAME(lesser)(from, to)))
            contour->sum += weight * NAME(edge_term)(at, &edge);
        else if (!NAME(all_above)(NAME(all)(0), NAME(greater)(from, to)))
            contour->sum += NAME(clipped_term)(at, &edge, from, to, weight, &contour->passage);
    }
}

/*
 * Adds candidates to the contours of two vectors of elements, from the i-th on, side by side, if both see the source
 * far away and wholly above the horizon; else does nothing and returns false.
 */
LX_LANE bool NAME(add_to_two)(const struct lx_area_light *lamp, const struct NAME(candidate) * candidates, size_t count,
                              const struct NAME(lx_block) * block, size_t i, double away,
                              struct NAME(contour) * contours)
{
    struct NAME(outlook) at[2];
    NAME(lanes) sums[2];
    for (size_t j = 0; j < 2; j++) {
        at[j] = NAME(outlook_of)(lamp, block, i + j * NAME(LX_WIDTH));
        sums[j] = contours[j].sum;
        if (NAME(share_above)(lamp, &at[j], away) != NAME(LX_ALL) || !NAME(all_above)(at[j].beyond_near, NAME(all)(0)))
            return false;
    }
    for (size_t k = 0; k < count; k++) {
        const struct NAME(edge) edge = NAME(edge_of)(candidates[k].edge);
        for (int j = 0; j < 2; j++)
            sums[j] += NAME(weigh)(lamp, &candidates[k], &at[j]) * NAME(far_term)(&at[j], &edge);
    }
    for (int j = 0; j < 2; j++)
        contours[j].sum = sums[j];
    return true;
}

static void NAME(light_by_facets)(const struct lx_area_light *lamp, double diffuse, const struct NAME(lx_block) * block,
                                  size_t count, const struct lx_asking *asking, double *restrict sum)
{
    enum { LOT = 64, BETWEEN_CHECKS = 1024 }; /* candidates that are worked off at once; edges that are looked at */
    const size_t width = NAME(LX_WIDTH);
    const struct lx_around around = NAME(around)(block, lx_padded(count));
    const double gain = -0.5 * diffuse * lamp->radiance;
    struct NAME(contour) contours[LX_BLOCK / NAME(LX_WIDTH)];
    _Alignas(LX_VECTOR_BYTES) REAL totals[LX_BLOCK];
    struct NAME(candidate) lot[LOT];
    double away = around.radius;
    for (int i = 0; i < 3; i++)
        away += fabs(around.center[i] - lamp->center[i]);
    count = lx_padded(count);
    memset(contours, 0, count / width * sizeof *contours);
    for (size_t next = 0, found = 0; next < lamp->edge_count; found = 0) {
        for (; next < lamp->edge_count && found < LOT; next++) {
            if (next % BETWEEN_CHECKS == BETWEEN_CHECKS - 1 && !lx_asking_goes_on(asking))
                return;
            lot[found].edge = &lamp->NAME(edges)[next];
            found += NAME(is_candidate)(lamp, &around, &lot[found]);
        }
        if (!lx_asking_goes_on(asking))
            return;
        for (size_t i = 0, vectors; i < count; i += vectors * width) {
            struct NAME(contour) *contour = &contours[i / width];
            const bool two = i + width < count && NAME(add_to_two)(lamp, lot, found, block, i, away, contour);
            vectors = two ? 2 : 1;
            if (two)
                continue;
            const struct NAME(outlook) at = NAME(outlook_of)(lamp, block, i);
            const enum NAME(share) share = NAME(share_above)(lamp, &at, away);
            if (share == NAME(LX_ALL))
                NAME(add_edges)(lamp, lot, found, &at, NAME(LX_ALL), contour);
            else if (share == NAME(LX_SOME))
                NAME(add_edges)(lamp, lot, found, &at, NAME(LX_SOME), contour);
            if (next == lamp->edge_count && NAME(any_above)(contour->passage.cut, NAME(all)(0)))
                contour->sum += NAME(chord_term)(&at, &contour->passage);
        }
    }
    for (size_t i = 0; i < count; i += width)
        NAME(store)(totals + i, contours[i / width].sum);
    for (size_t i = 0; i < count; i++) {
        const double value = gain * (double)totals[i];
        sum[i] += value > 0 ? value : 0;
    }
}
