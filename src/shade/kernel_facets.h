/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by convex facets in closed form, in float64.  Included by kernel.c, once for an instruction set.
 *
 * With c the way to the source's centre, v = c + w a contour point, e = b - a an edge of the contour, which is closed
 * by the chord in the horizon's plane, and F = angle(a, b)/|a x b|,
 *
 *     E = -radiance/2 sum F N.(a x e)         (the contour counter-clockwise as the element sees it)
 *
 * cancels for small sources.  The sum of all e is 0, hence also
 *
 *     E = -radiance/2 sum (F - 1/c^2) (N x c).e + F N.(w x e),
 *
 * where nothing does: with t = |a x b|/(a.b) and d = a.b - c^2, F - 1/c^2 = -(gap(t^2) + d/c^2)/(a.b).
 *
 * Signs count from `touch` on: a face seen along its own plane is not seen, a corner on the horizon is above it,
 * whatever rounding says, so that the edges that meet in a corner, or in a face, agree.
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

LANE struct lane lane_of(const struct lx_shell *shell, const struct lx_block_double *block, size_t i)
{
    struct lane lane = {.n = {block->nx[i], block->ny[i], block->nz[i]}};
    lane.c = (struct lane3){shell->center[0] - block->px[i], shell->center[1] - block->py[i],
                            shell->center[2] - block->pz[i]};
    lane.k = cross3(lane.n, lane.c);
    double square = dot3(lane.c, lane.c);
    lane.inverse = square > 4 * shell->radius_mm * shell->radius_mm ? 1 / square : 0;
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
    double t = sine / length, half = t * arc_over_tangent(t * t, 2), divisor = 1 / greatest(sine, SMALLEST);
    double sharp = sine > SMALLEST ? 2 * half * divisor : 2 / length;
    double f = cosine > 0 ? sharp : (M_PI - 2 * half) * divisor;
    double inverse_size = 1 / greatest(size, SMALLEST), tangent = sine * inverse_size;
    double z = cosine > 0 ? tangent * tangent : 1;
    double series = -(small_gap(least(z, series_end)) + beyond * lane.inverse) * inverse_size;
    double less = z < series_end ? series : f - lane.inverse;
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

/* What is kept of each element from edge to edge. */
struct contour {
    double sum[LX_BLOCK];    /* -2 E */
    double weight[LX_BLOCK]; /* of the edge */
    double exit_x[LX_BLOCK], exit_y[LX_BLOCK], exit_z[LX_BLOCK];
    double entry_x[LX_BLOCK], entry_y[LX_BLOCK], entry_z[LX_BLOCK];
    double cut[LX_BLOCK];
};

LANE struct passage passage_of(const struct contour *contour, size_t i)
{
    return (struct passage){
        .exit = {contour->exit_x[i], contour->exit_y[i], contour->exit_z[i]},
        .entry = {contour->entry_x[i], contour->entry_y[i], contour->entry_z[i]},
        .cut = contour->cut[i],
    };
}

/* Adds sign to the weights of the elements that see the face. */
static void weigh_face(const struct lx_shell *shell, const struct lx_shell_face *face, double sign,
                       const struct lx_block_double *block, size_t count, struct contour *contour)
{
    const struct lane3 normal = lane3_of(face->normal), center = lane3_of(shell->center);
    const double height = face->height + shell->touch_mm;
    for (size_t i = 0; i < count; i++) {
        struct lane3 from = {block->px[i] - center.x, block->py[i] - center.y, block->pz[i] - center.z};
        contour->weight[i] += dot3(normal, from) > height ? sign : 0;
    }
}

static void add_edge(const struct lx_shell *shell, const struct lx_shell_edge *edge,
                     const struct lx_block_double *block, size_t count, struct contour *restrict contour)
{
    const struct lane3 u = lane3_of(edge->from), w = lane3_of(edge->to), e = lane3_of(edge->along);
    const struct lane3 moment = lane3_of(edge->moment);
    const double touch = shell->touch_mm;
    for (size_t i = 0; i < count; i++) {
        struct lane lane = lane_of(shell, block, i);
        struct passage passage = passage_of(contour, i);
        double from = dot3(lane.n, along3(lane.c, 1, u)) + touch, to = dot3(lane.n, along3(lane.c, 1, w)) + touch;
        contour->sum[i] += clipped_edge(lane, u, e, dot3(lane.n, moment), from, to, contour->weight[i], &passage);
        contour->exit_x[i] = passage.exit.x, contour->exit_y[i] = passage.exit.y;
        contour->exit_z[i] = passage.exit.z;
        contour->entry_x[i] = passage.entry.x, contour->entry_y[i] = passage.entry.y;
        contour->entry_z[i] = passage.entry.z;
        contour->cut[i] = passage.cut;
    }
}

/* What a whole block sees of a face: 1, all of it; -1, none; 0, some may. */
static int side_of(const struct lx_shell *shell, const struct lx_shell_face *face, const struct lx_around *around)
{
    double above = -face->height;
    for (int i = 0; i < 3; i++)
        above += face->normal[i] * (around->center[i] - shell->center[i]);
    double doubt = around->radius + 2 * shell->touch_mm;
    return above > doubt ? 1 : above < -doubt ? -1 : 0;
}

static void light_by_facets(const struct lx_shell *shell, double diffuse, const struct lx_block_double *block,
                            const struct lx_around *around, size_t count, double *restrict sum)
{
    struct contour contour;
    count = lx_padded(count);
    memset(&contour, 0, sizeof contour);
    for (size_t k = 0; k < shell->edge_count; k++) {
        const struct lx_shell_edge *edge = &shell->edges[k];
        const struct lx_shell_face *left = &shell->faces[edge->left];
        const struct lx_shell_face *right = edge->right < 0 ? NULL : &shell->faces[edge->right];
        int left_side = side_of(shell, left, around), right_side = right ? side_of(shell, right, around) : -1;
        if (left_side != 0 && left_side == right_side)
            continue;
        for (size_t i = 0; i < count; i++)
            contour.weight[i] = 0;
        weigh_face(shell, left, 1, block, count, &contour);
        if (right)
            weigh_face(shell, right, -1, block, count, &contour);
        add_edge(shell, edge, block, count, &contour);
    }
    const double gain = -0.5 * diffuse * shell->radiance;
    for (size_t i = 0; i < count; i++) {
        double value = gain * (contour.sum[i] + chord_term(lane_of(shell, block, i), passage_of(&contour, i)));
        sum[i] += value > 0 ? value : 0;
    }
}
