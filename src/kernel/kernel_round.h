/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by balls, disks and cylinders in closed form, in float64.  Included by kernel.c, once for an
 * instruction set.
 *
 * A circle of radius R about the axis n, its plane the height h below the element and its centre rho beside it, is
 * r = c + R (u cos t + v sin t), u along the centre's offset in the plane, and |r|^2 = D + B cos t.  With
 * W^2 = D^2 - B^2 and b = B/(D + W),
 *
 *     1/|r|^2 = (1 + P(t))/W,   integral of P = -2 atan(b sin t/(1 + b cos t)),
 *
 * and P cos t, P sin t are elementary as well.  As in kernel_facets.h 1/c^2 is taken off where the way to the source's
 * centre is multiplied, and all is written so that no digits are lost for small b.
 */

/* A circle as an element sees it; o is its centre from the source's. */
struct circle {
    struct lane3 o, u, v, n;
    double radius, w, b, excess; /* excess: 1/W - 1/c^2, or 1/W where the source is near */
};

/* A place on it. */
struct turn {
    double angle, cosine, sine;
};

LANE struct turn select_turn(bool first, struct turn a, struct turn b)
{
    return (struct turn){first ? a.angle : b.angle, first ? a.cosine : b.cosine, first ? a.sine : b.sine};
}

LANE struct lane3 on_circle(struct circle circle, struct turn t)
{
    return along3(along3(circle.o, circle.radius * t.cosine, circle.u), circle.radius * t.sine, circle.v);
}

/* flip: 1, or -1 to count angles from the side of the circle that is nearest */
LANE struct circle circle_of(struct lane lane, struct lane3 o, struct lane3 n, struct lane3 u, double height,
                             double rho, double radius, double flip)
{
    double height2 = height * height, square = dot3(lane.c, lane.c);
    double less = rho - radius, more = rho + radius;
    double w = sqrt((less * less + height2) * (more * more + height2));
    w = greatest(w, SMALLEST);
    double d = rho * rho + height2 + radius * radius, product = 2 * radius * rho;
    double beyond = 2 * dot3(lane.c, o) + dot3(o, o) + radius * radius;        /* d - c^2 */
    double below = (product * product - beyond * (square + d)) / (square + w); /* c^2 - W */
    return (struct circle){
        .o = o,
        .u = scale3(u, flip),
        .v = scale3(cross3(n, u), flip),
        .n = n,
        .radius = radius,
        .w = w,
        .b = flip * product / (d + w),
        .excess = lane.inverse > 0 ? below * lane.inverse / w : 1 / w,
    };
}

/* At one end of an arc: psi = atan(b sin t/(1 + b cos t)), and the integral of P cos t but for -b t. */
struct arc_end {
    double psi, p_cos, m; /* m = |r|^2 relative to (D + W)/2 */
};

LANE struct arc_end arc_end_of(double b, struct turn t)
{
    double over = t.sine / greatest(1 + b * t.cosine, SMALLEST), tangent = b * over;
    double missing = gap(tangent * tangent), psi = tangent * (1 - missing);
    return (struct arc_end){psi, b * psi - tangent * t.cosine - over * missing, 1 + 2 * b * t.cosine + b * b};
}

/* The share of -2 E of the circle from one place on it to another. */
LANE double arc_term(struct lane lane, struct circle circle, struct turn from, struct turn to)
{
    const double b = circle.b, r = circle.radius, inverse_w = 1 / circle.w;
    struct arc_end first = arc_end_of(b, from), last = arc_end_of(b, to);
    double turn = to.angle - from.angle, d_cos = to.cosine - from.cosine, d_sin = to.sine - from.sine;
    double p_one = -2 * (last.psi - first.psi), p_cos = last.p_cos - first.p_cos - b * turn;
    double middle = greatest((first.m + last.m) / 2, SMALLEST);
    double zeta = least(fabs(b * d_cos) / middle, 1);
    double missing = negative_gap(zeta, least(first.m, last.m) / greatest(first.m, last.m));
    double p_sin = d_cos * (2 * b * b + b * (from.cosine + to.cosine) + (1 - b * b) * missing) / middle;
    /* N.(c x v) = (N x c).v */
    double a_c = r * dot3(lane.k, circle.v), b_c = -r * dot3(lane.k, circle.u);
    struct lane3 moment = cross3(lane.n, circle.o);
    double a_o = r * dot3(moment, circle.v), b_o = -r * dot3(moment, circle.u), around = r * r * dot3(lane.n, circle.n);
    double by_c = a_c * (circle.excess * d_sin + p_cos * inverse_w) + b_c * (p_sin * inverse_w - circle.excess * d_cos);
    double by_o = a_o * (d_sin + p_cos) + b_o * (p_sin - d_cos) + around * (turn + p_one);
    return by_c + by_o * inverse_w;
}

/* Where the horizon cuts a circle: it is above from middle - half to middle + half. */
struct slice {
    double height, reach; /* of the centre above the horizon; how far the circle goes up and down from there */
    struct turn middle, half;
};

LANE struct slice slice_of(struct lane lane, struct circle circle, double touch)
{
    struct slice slice;
    double x = dot3(lane.n, circle.u), y = dot3(lane.n, circle.v), size = greatest(sqrt(x * x + y * y), SMALLEST);
    slice.height = dot3(lane.n, along3(lane.c, 1, circle.o)) + touch;
    slice.reach = circle.radius * size;
    double angle = angle_of(fabs(y), x), m = greatest(slice.reach, SMALLEST);
    slice.middle = (struct turn){y < 0 ? -angle : angle, x / size, y / size};
    double cosine = least(greatest(-slice.height / m, -1), 1);
    double sine2 = (m - slice.height) * (m + slice.height);
    double sine = sine2 > 0 ? sqrt(sine2) / m : 0;
    slice.half = (struct turn){angle_of(sine, cosine), cosine, sine};
    return slice;
}

/* The places where the horizon cuts: sign 1 where the circle goes below with growing angle, -1 where it comes up. */
LANE struct turn cut_of(struct slice slice, double sign)
{
    struct turn a = slice.middle, b = slice.half;
    return (struct turn){a.angle + sign * b.angle, a.cosine * b.cosine - sign * a.sine * b.sine,
                         a.sine * b.cosine + sign * a.cosine * b.sine};
}

/* Any direction across another. */
LANE struct lane3 beside3(struct lane3 n)
{
    bool along_x = fabs(n.x) > 0.5;
    struct lane3 v = {along_x ? -n.y : 0, along_x ? n.x : -n.z, along_x ? 0 : n.y};
    return scale3(v, 1 / sqrt(dot3(v, v)));
}

/*
 * The foot of the element in a plane across the axis: its offset and the direction from it to the axis.  Of an element
 * on the axis, or as good as on it, rounding leaves an offset of any direction, also along the axis; that part is taken
 * off.
 */
LANE double foot_of(struct lane lane, struct lane3 axis, struct lane3 beside, double height, struct lane3 *u)
{
    struct lane3 s = along3(lane.c, height, axis);
    s = along3(s, -dot3(s, axis), axis);
    double rho = sqrt(dot3(s, s));
    bool is_off = rho > 0x1p-54 * fabs(height);
    *u = select3(is_off, scale3(s, 1 / greatest(rho, SMALLEST)), beside);
    return rho;
}

/*
 * How an element sees a source, or the cap of a cylinder that it is in front of: not at all, wholly above its horizon
 * with room for rounding, or maybe cut by it.
 *
 * Runs of LX_LANES elements go through the loop of each kind that they have elements of, and each element takes what
 * the loop of its own kind gives: compilers round each loop in its own way, and no sum may depend on the elements
 * beside it.  Kinds are of float64, as compilers make vectors of what is of one size.
 */
static const double UNSEEN = 0, WHOLE = 1, CUT = 2, CAP_WHOLE = 3, CAP_CUT = 4;

/* The kind of elements that see the source; below: where the horizon is higher than all of it. */
LANE double kind_by_horizon(const struct lx_area_light *lamp, struct lane lane, double whole, double cut)
{
    const double height = dot3(lane.n, lane.c);
    const double away = fabs(lane.c.x) + fabs(lane.c.y) + fabs(lane.c.z);
    const double reach = 1.001 * lamp->radius_mm + lamp->touch_mm + 0x1p-49 * away;
    const double above = height > reach ? whole : cut;
    return height < -reach ? UNSEEN : above;
}

LANE bool any_is(const double *kinds, double kind)
{
    size_t count = 0;
    for (size_t i = 0; i < LX_LANES; i++)
        count += kinds[i] == kind;
    return count > 0;
}

/* E by a disk that the element is in front of, for a radiance of 1. */
LANE double disk_irradiance(struct lane lane, struct lane3 o, struct lane3 axis, struct lane3 beside, double radius,
                            double touch, bool cuts)
{
    struct lane3 c = along3(lane.c, 1, o), u;
    double height = -dot3(c, axis);
    struct lane at_disk = lane;
    at_disk.c = c;
    double rho = foot_of(at_disk, axis, beside, height, &u);
    struct circle circle = circle_of(lane, o, axis, u, height, rho, radius, 1);
    double past = rho * rho - radius * radius - height * height, w = circle.w;
    double half_sum = rho * rho + height * height + radius * radius + w;
    double inside = past > 0 ? 4 * height * height * rho * rho / (w + past) : w - past;
    double whole =
        M_PI * radius / w * (circle.b * height * dot3(lane.n, u) - radius * inside / half_sum * dot3(lane.n, axis));
    if (!cuts)
        return greatest(whole, 0);
    struct slice slice = slice_of(lane, circle, touch);
    struct turn from = cut_of(slice, -1), to = cut_of(slice, 1);
    struct passage passage = {on_circle(circle, to), on_circle(circle, from), 1};
    double part = -0.5 * (arc_term(lane, circle, from, to) + chord_term(lane, passage));
    double value = slice.height < slice.reach ? part : whole;
    return slice.height > -slice.reach ? greatest(value, 0) : 0;
}

/*
 * E by a ball for a radiance of 1, with sin s = R/d and x the cosine of the angle between N and the centre; k and cos s
 * are the legs of alpha.
 */
LANE double ball_irradiance(struct lane lane, double radius, bool cuts)
{
    double d = sqrt(dot3(lane.c, lane.c)), inverse = 1 / greatest(d, SMALLEST);
    double x = dot3(lane.n, lane.c) * inverse, sine = radius * inverse, whole = M_PI * sine * sine * x;
    if (!cuts)
        return whole;
    double cosine = sqrt(greatest((d - radius) * (d + radius), 0)) * inverse;
    double k2 = (sine - x) * (sine + x), k = sqrt(greatest(k2, 0));
    double tangent = k / greatest(cosine, 1e-150), t2 = tangent * tangent, s2 = 1 - x * x;
    double s_c = k * cosine / greatest(s2, SMALLEST); /* sin alpha cos alpha */
    double series = gap_to_one(least(t2, 1));
    double direct = angle_of(k, cosine) - s_c;
    double bow = t2 < 1 ? tangent * (t2 / (1 + t2) - series) : direct; /* alpha - sin alpha cos alpha */
    double part = bow + x * x * s_c + x * sine * sine * angle_of(k, -cosine * x);
    return k2 > 0 ? greatest(part, 0) : greatest(whole, 0);
}

/* The share of -2 E of what an arc from -end to end has in common with the slice that the horizon leaves. */
LANE double common_arc(struct lane lane, struct circle circle, struct turn up, struct turn down, struct turn end,
                       double shift)
{
    struct turn begin = {-end.angle, end.cosine, -end.sine};
    up.angle += shift, down.angle += shift;
    struct turn first = select_turn(up.angle > begin.angle, up, begin);
    struct turn last = select_turn(down.angle < end.angle, down, end);
    double term = arc_term(lane, circle, first, last);
    return first.angle < last.angle ? term : 0;
}

/* The term of a rim that runs from -end to end where direction is 1, and back where it is -1, and where it passes
 * through the horizon. */
LANE double rim_term(struct lane lane, struct circle circle, double touch, struct turn end, double start_height,
                     double end_height, double direction, bool cuts, struct passage *passage)
{
    if (!cuts)
        return direction * arc_term(lane, circle, (struct turn){-end.angle, end.cosine, -end.sine}, end);
    struct slice slice = slice_of(lane, circle, touch);
    struct turn up = cut_of(slice, -1), down = cut_of(slice, 1);
    double shift = slice.middle.angle < 0 ? 2 * M_PI : -2 * M_PI;
    double sum = common_arc(lane, circle, up, down, end, 0) + common_arc(lane, circle, up, down, end, shift);
    double other_up = up.angle + shift, other_down = down.angle + shift;
    bool has_up = (fabs(up.angle) < end.angle) | (fabs(other_up) < end.angle);
    bool has_down = (fabs(down.angle) < end.angle) | (fabs(other_down) < end.angle);
    /* Its ends tell how often the rim passes through: once, or else twice or never. */
    bool starts = start_height >= 0, ends = end_height >= 0, passes = fabs(slice.height) < slice.reach;
    bool twice = (starts == ends) & has_up & has_down & passes;
    bool goes_down = (starts & !ends) | twice, comes_up = (!starts & ends) | twice;
    bool with = direction > 0;
    bool leaves = (with & goes_down) | (!with & comes_up), enters = (with & comes_up) | (!with & goes_down);
    struct lane3 low = on_circle(circle, down), high = on_circle(circle, up);
    passage->exit = select3(leaves, select3(with, low, high), passage->exit);
    passage->entry = select3(enters, select3(with, high, low), passage->entry);
    passage->cut = leaves ? 1 : passage->cut;
    return slice.height < -slice.reach ? 0 : direction * sum;
}

/* A cylinder beside an element: how the element sees its outline. */
struct outline {
    struct lane3 axis, u;
    double radius, half, touch, height, rho; /* the element over the middle, and from the axis */
    bool cuts;                               /* the horizon may */
    struct lane3 right, left;                /* from the axis to the generators */
    struct turn tangent;                     /* the angle of the left one */
};

/* Upwards on the right, downwards on the left. */
LANE double generator_term(struct lane lane, struct outline outline, struct lane3 from_axis, double weight,
                           struct passage *passage)
{
    struct lane3 bottom = along3(from_axis, -outline.half, outline.axis), e = scale3(outline.axis, 2 * outline.half);
    struct lane3 top = along3(from_axis, outline.half, outline.axis);
    double moment = dot3(lane.n, cross3(bottom, e));
    if (!outline.cuts)
        return weight * edge_term(lane, bottom, top, e, moment);
    double from = dot3(lane.n, along3(lane.c, 1, bottom)) + outline.touch;
    double to = dot3(lane.n, along3(lane.c, 1, top)) + outline.touch;
    return clipped_edge(lane, bottom, e, moment, from, to, weight, passage);
}

/* The part of the rim at the top (side 1) or bottom (side -1) that is in the outline. */
LANE double outline_rim(struct lane lane, struct outline outline, double side, struct passage *passage)
{
    bool seen = side * outline.height - outline.half > outline.touch; /* the cap within this rim is */
    struct lane3 o = scale3(outline.axis, side * outline.half);
    struct circle circle = circle_of(lane, o, outline.axis, outline.u, outline.height - side * outline.half,
                                     outline.rho, outline.radius, seen ? 1 : -1);
    struct turn rest = {M_PI - outline.tangent.angle, -outline.tangent.cosine, outline.tangent.sine};
    struct lane3 right = along3(outline.right, side * outline.half, outline.axis);
    struct lane3 left = along3(outline.left, side * outline.half, outline.axis);
    double at_right = dot3(lane.n, along3(lane.c, 1, right)) + outline.touch;
    double at_left = dot3(lane.n, along3(lane.c, 1, left)) + outline.touch;
    return rim_term(lane, circle, outline.touch, select_turn(seen, outline.tangent, rest), seen ? at_right : at_left,
                    seen ? at_left : at_right, seen ? side : -side, outline.cuts, passage);
}

/* A cylinder from beside it: two generators, and of each rim the side that is seen as the outline. */
LANE double cylinder_irradiance(struct lane lane, struct lane3 axis, struct lane3 beside,
                                const struct lx_area_light *lamp, bool cuts)
{
    const double radius = lamp->round_mm;
    struct outline outline = {
        .axis = axis, .radius = radius, .half = lamp->half_mm, .touch = lamp->touch_mm, .cuts = cuts};
    outline.height = -dot3(lane.c, axis);
    outline.rho = foot_of(lane, axis, beside, outline.height, &outline.u);
    double inverse = 1 / greatest(outline.rho, radius), cosine = -radius * inverse;
    double sine = sqrt(greatest((outline.rho - radius) * (outline.rho + radius), 0)) * inverse;
    struct lane3 v = cross3(axis, outline.u), middle = scale3(outline.u, radius * cosine);
    outline.tangent = (struct turn){angle_of(sine, cosine), cosine, sine};
    outline.right = along3(middle, -radius * sine, v), outline.left = along3(middle, radius * sine, v);
    struct passage passage = {{0, 0, 0}, {0, 0, 0}, 0};
    double sum = generator_term(lane, outline, outline.right, 1, &passage) +
                 generator_term(lane, outline, outline.left, -1, &passage);
    sum += outline_rim(lane, outline, 1, &passage) + outline_rim(lane, outline, -1, &passage);
    if (cuts)
        sum += chord_term(lane, passage);
    return greatest(-0.5 * sum, 0);
}

/* What the loops over the elements of a run have in common; the elements of the kind get their light. */
struct run {
    const struct lx_area_light *lamp;
    const struct lx_block_double *block;
    struct lane3 axis, beside;
    double gain;
    double *kinds;
};

LANE struct run run_of(const struct lx_area_light *lamp, double diffuse, const struct lx_block_double *block,
                       double *kinds)
{
    const struct lane3 axis = lane3_of(lamp->axis);
    return (struct run){lamp, block, axis, beside3(axis), diffuse * lamp->radiance, kinds};
}

/* What of a round source an element is in front of; loops and closed forms are compiled for each. */
enum part { DISK, BALL, BODY, CAP };

LANE double part_irradiance(struct run run, struct lane lane, enum part part, bool cuts)
{
    const double radius = run.lamp->round_mm, touch = run.lamp->touch_mm, half = run.lamp->half_mm;
    const double side = dot3(lane.c, run.axis) > 0 ? -1 : 1;
    const struct lane3 middle = {0, 0, 0}, cap = scale3(run.axis, side * half), outwards = scale3(run.axis, side);
    switch (part) {
    case DISK: return disk_irradiance(lane, middle, run.axis, run.beside, radius, touch, cuts);
    case BALL: return ball_irradiance(lane, radius, cuts);
    case BODY: return cylinder_irradiance(lane, run.axis, run.beside, run.lamp, cuts);
    case CAP: return disk_irradiance(lane, cap, outwards, run.beside, radius, touch, cuts);
    }
    return 0;
}

LANE void add_kind(struct run run, size_t start, enum part part, double kind, bool cuts, double *restrict sum)
{
    if (!any_is(run.kinds, kind))
        return;
    for (size_t i = 0; i < LX_LANES; i++) {
        struct lane lane = lane_of(run.lamp, run.block, start + i);
        double value = part_irradiance(run, lane, part, cuts);
        sum[start + i] += run.kinds[i] == kind ? run.gain * value : 0;
    }
}

/* The kind of an element; none is between the caps within the body of a cylinder. */
LANE double kind_of(struct run run, struct lane lane, enum part part)
{
    const double touch = run.lamp->touch_mm, outside = run.lamp->round_mm + touch, half = run.lamp->half_mm;
    const double height = -dot3(lane.c, run.axis), kind = kind_by_horizon(run.lamp, lane, WHOLE, CUT);
    if (part == DISK)
        return height > touch ? kind : UNSEEN;
    if (part == BALL)
        return sqrt(dot3(lane.c, lane.c)) > outside ? kind : UNSEEN;
    struct lane3 s = along3(lane.c, height, run.axis);
    double cap = kind_by_horizon(run.lamp, lane, CAP_WHOLE, CAP_CUT);
    cap = fabs(height) > half + touch ? cap : UNSEEN;
    return dot3(s, s) <= outside * outside ? cap : kind;
}

LANE void light_by(const struct lx_area_light *lamp, double diffuse, const struct lx_block_double *block, size_t count,
                   enum part part, double *restrict sum)
{
    double kinds[LX_LANES];
    const struct run run = run_of(lamp, diffuse, block, kinds);
    for (size_t start = 0; start < count; start += LX_LANES) {
        for (size_t i = 0; i < LX_LANES; i++)
            kinds[i] = kind_of(run, lane_of(lamp, block, start + i), part);
        add_kind(run, start, part, WHOLE, false, sum);
        add_kind(run, start, part, CUT, true, sum);
        if (part == BODY) {
            add_kind(run, start, CAP, CAP_WHOLE, false, sum);
            add_kind(run, start, CAP, CAP_CUT, true, sum);
        }
    }
}

/* A block is done too soon for anybody to be asked whether to go on. */
#define LX_LIGHT_BY(name, part)                                                                                        \
    static void name(const struct lx_area_light *lamp, double diffuse, const struct lx_block_double *block,            \
                     size_t count, const struct lx_asking *asking, double *restrict sum)                               \
    {                                                                                                                  \
        (void)asking;                                                                                                  \
        light_by(lamp, diffuse, block, count, part, sum);                                                              \
    }
LX_LIGHT_BY(light_by_disk, DISK)
LX_LIGHT_BY(light_by_ball, BALL)
LX_LIGHT_BY(light_by_cylinder, BODY)
#undef LX_LIGHT_BY
