/* SPDX-License-Identifier: MIT */
/*
 * The straight parts of the outlines of round sources, cut by the horizon, in float64: edges and chords, one element
 * after the other, as loops that compilers make vectors of.  Included by kernel.c, once for an instruction set.
 *
 * The formulas are those of kernel_facets.h, whose edges all begin and end in corners and so stay away from the
 * elements that are not on the source; these may pass as near as they like, and take the arc tangent by halvings.
 */
struct lane3 {
    double x, y, z;
};

LANE struct lane3 lane3_of(const double v[3])
{
    return (struct lane3){v[0], v[1], v[2]};
}

LANE double dot3(struct lane3 a, struct lane3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LANE struct lane3 cross3(struct lane3 a, struct lane3 b)
{
    return (struct lane3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* a + factor b */
LANE struct lane3 along3(struct lane3 a, double factor, struct lane3 b)
{
    return (struct lane3){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

LANE struct lane3 scale3(struct lane3 a, double factor)
{
    return (struct lane3){factor * a.x, factor * a.y, factor * a.z};
}

LANE struct lane3 select3(bool first, struct lane3 a, struct lane3 b)
{
    return (struct lane3){first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/* An element and its way to the source's centre. */
struct lane {
    struct lane3 n, c, k; /* k = N x c */
    double inverse;       /* 1/c^2; 0 where the source is near */
};

/* Where a contour, as offsets w from the source's centre, passes the horizon. */
struct passage {
    struct lane3 exit, entry;
    double cut; /* whether it does */
};

LANE struct lane lane_of(const struct lx_area_light *lamp, const struct lx_block_double *block, size_t i)
{
    struct lane lane = {.n = {block->nx[i], block->ny[i], block->nz[i]}};
    lane.c =
        (struct lane3){lamp->center[0] - block->px[i], lamp->center[1] - block->py[i], lamp->center[2] - block->pz[i]};
    lane.k = cross3(lane.n, lane.c);
    double square = dot3(lane.c, lane.c);
    lane.inverse = square > 4 * lamp->radius_mm * lamp->radius_mm ? 1 / square : 0;
    return lane;
}

/* One edge's share of -2 E: u and w where it begins and ends, e between, and N.(u x e). */
LANE double edge_term(struct lane lane, struct lane3 u, struct lane3 w, struct lane3 e, double moment)
{
    struct lane3 a = along3(lane.c, 1, u), b = along3(lane.c, 1, w), g = cross3(a, e);
    double sine2 = dot3(g, g), sine = sqrt(sine2);
    double beyond = dot3(lane.c, along3(u, 1, w)) + dot3(u, w);
    bool is_far = lane.inverse > 0;
    double cosine = is_far ? dot3(lane.c, lane.c) + beyond : dot3(a, b);
    double size = fabs(cosine), length = greatest(sqrt(cosine * cosine + sine2) + size, SMALLEST);
    double t = sine / length, half = t * (1 - gap_to_one(t * t)), divisor = 1 / greatest(sine, SMALLEST);
    double sharp = sine > SMALLEST ? 2 * half * divisor : 2 / length;
    double f = cosine > 0 ? sharp : (M_PI - 2 * half) * divisor;
    double inverse_size = 1 / greatest(size, SMALLEST), tangent = sine * inverse_size;
    double z = cosine > 0 ? tangent * tangent : 1;
    double series = -(gap_to_one(least(z, 1)) + beyond * lane.inverse) * inverse_size;
    double less = z < 1 ? series : f - lane.inverse;
    return is_far ? less * dot3(lane.k, e) + f * moment : f * dot3(lane.n, g);
}

/* An edge's share of -2 E where it is above the horizon, and whether it passes through; weight 1: along it,
 * -1: against it, 0: not at all.  The heights of its ends count from -touch on. */
LANE double clipped_edge(struct lane lane, struct lane3 u, struct lane3 e, double moment, double from, double to,
                         double weight, struct passage *passage)
{
    double change = from - to;
    double cross = from / (fabs(change) > SMALLEST ? change : 1);
    cross = least(greatest(cross, 0), 1);
    double first = from < 0 ? cross : 0, last = to < 0 ? cross : 1, part = last - first;
    double term = edge_term(lane, along3(u, first, e), along3(u, last, e), scale3(e, part), part * moment);
    double down = from < 0 ? 0 : weight, up = to < 0 ? 0 : weight; /* along the edge, or against it */
    double leaves = (to < 0 ? down : 0) - (from < 0 ? up : 0);     /* 1: goes below the horizon; -1: comes up again */
    struct lane3 place = along3(u, cross, e);
    passage->exit = select3(leaves > 0, place, passage->exit);
    passage->entry = select3(leaves < 0, place, passage->entry);
    passage->cut = leaves > 0 ? 1 : passage->cut;
    return greatest(from, to) < 0 ? 0 : weight * term;
}

/* The chord from the exit to the entry closes what the horizon cuts off. */
LANE double chord_term(struct lane lane, struct passage passage)
{
    struct lane3 e = along3(passage.entry, -1, passage.exit);
    double term = edge_term(lane, passage.exit, passage.entry, e, dot3(lane.n, cross3(passage.exit, e)));
    return passage.cut > 0 ? term : 0;
}
