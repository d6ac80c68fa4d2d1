/* SPDX-License-Identifier: MIT */
/*
 * The side of a cylinder, as an integral of what is not negative.  At the angle w about the axis a generator lies at
 * the distance sqrt(s) across the axis, and
 *
 *     E = R  int -(rho cos w + R)  int max(0, N.r)/(s + z^2)^2 dz  dw,   s = (rho - R)^2 + 4 rho R cos^2(w/2)
 *
 * over the near side, where the first factor is positive.  N.r is linear in z between its values at the rims, and these
 * are sinusoids of w; where one changes its sign the integral over w is divided, so that the pieces' integrands are
 * smooth.  Distances of w from these places and from the tangents, whose sines make up the factors, are known better
 * than w: they are added up from the nearer end of the piece.
 *
 * The inner panels keep away from z = +-i sqrt(s), the outer ones from w = pi +- i log(rho/R), where s vanishes; these
 * are then halved until both halves together agree with the whole.
 */
#include "../gauss.h"
#include "rim.h"

enum { MOST_HALVINGS = 30, MOST_REFINED = 2000, ROOTS = 6 };
static const double AGREED = 0x1p-46;

/* Places that w is measured from, all in (0, 2 pi): where it touches, where each rim sets and rises. */
enum root { FIRST, LAST, RISE, SET };

/* A range of w between neighbouring roots. */
struct piece {
    double length;
    double before[ROOTS], after[ROOTS]; /* its ends from the roots: begin - root, root - end; one is not negative */
    double from_middle;                 /* its begin from pi */
};

/* N.r at a rim. */
struct height {
    bool crossed, inverted; /* inverted: it sets before it rises */
    double reach, top;      /* top: the angle w0 */
    double excess;          /* what it is beyond reach where it is not crossed; negative where it is below */
};

struct side {
    double rho, radius, gap, near, length; /* gap = rho - R; near: z of the first rim; length of the side */
    struct height heights[2];
    double nearest2, size; /* the least |r|^2 that was met; the largest |z| */
    bool complete;         /* the panels sufficed */
    int refined;           /* panels of the outer integral so far */
    double doubt;          /* how far panels and their halves were apart */
};

/* The distance of a place in the piece from a root; left and right: from the piece's ends. */
static double distance_from(const struct piece *piece, int root, double left, double right)
{
    return piece->before[root] >= 0 ? piece->before[root] + left : piece->after[root] + right;
}

/* N.r at a rim and its sign, w being so far from pi. */
static double height_at(const struct side *side, const struct piece *piece, int rim, double left, double right)
{
    const struct height *height = &side->heights[rim];
    int rise = RISE + 2 * rim, set = SET + 2 * rim;
    if (!height->crossed) {
        double half = (piece->from_middle + left + M_PI - height->top) / 2;
        double bow = height->excess >= 0 ? cos(half) : sin(half), size = 2 * height->reach * bow * bow;
        return height->excess >= 0 ? height->excess + size : height->excess - size;
    }
    double from_rise = distance_from(piece, rise, left, right), from_set = distance_from(piece, set, left, right);
    double size = 2 * height->reach * sin(from_rise / 2) * sin(from_set / 2);
    /* between rise and set in that order it is above, or beyond them where they come in the other order */
    bool between = (piece->before[rise] >= 0) != (piece->before[set] >= 0);
    return between != height->inverted ? size : -size;
}

/* The integral of a linear function, first at z = from, last at z = to, over (s + z^2)^2; length = to - from. */
static double along(struct side *side, double s, double from, double length, double first, double last)
{
    struct lx_pole pole = {-from / length, sqrt(s) / length};
    double sum = 0, begin = 0;
    for (int k = 0; k < LX_MOST_PANELS && begin < 1 && side->complete; k++) {
        double end = lx_panel_end(begin, 1, &pole, 1);
        double middle = (begin + end) / 2, half = (end - begin) / 2, part = 0;
        for (int i = 0; i < LX_GAUSS_NODES; i++) {
            double t = middle + half * lx_gauss[i].place, rest = (1 - end) + half * lx_gauss[i].rest;
            double z = from + length * t, d2 = s + z * z;
            side->nearest2 = fmin(side->nearest2, d2);
            part += lx_gauss[i].weight * (first * rest + last * t) / (d2 * d2);
        }
        sum += half * part;
        side->complete = end > begin;
        begin = end;
    }
    side->complete = side->complete && !(begin < 1);
    return sum * length;
}

/* The integrand of the outer integral, without R. */
static double generator(struct side *side, const struct piece *piece, double left, double right)
{
    double f1 = height_at(side, piece, 0, left, right), f2 = height_at(side, piece, 1, left, right);
    if (f1 <= 0 && f2 <= 0)
        return 0;
    double from_middle = piece->from_middle + left, bow = sin(from_middle / 2);
    double s = side->gap * side->gap + 4 * side->rho * side->radius * bow * bow;
    double facing = 2 * side->rho * sin(distance_from(piece, FIRST, left, right) / 2) *
                    sin(distance_from(piece, LAST, left, right) / 2);
    if (f1 > 0 && f2 > 0)
        return facing * along(side, s, side->near, side->length, f1, f2);
    double seen = side->length * fmax(f1, f2) / (fabs(f1) + fabs(f2));
    if (f1 > 0)
        return facing * along(side, s, side->near, seen, f1, 0);
    return facing * along(side, s, side->near + (side->length - seen), seen, 0, f2);
}

static double panel(struct side *side, const struct piece *piece, double from, double to)
{
    side->refined++;
    double middle = (from + to) / 2, half = (to - from) / 2, sum = 0;
    for (int i = 0; i < LX_GAUSS_NODES; i++) {
        double right = (piece->length - to) + half * lx_gauss[i].rest;
        sum += lx_gauss[i].weight * generator(side, piece, middle + half * lx_gauss[i].place, right);
    }
    return half * sum;
}

/* What the roundings in z and s do to the integrand, relative to it. */
static double rounding(const struct side *side)
{
    return DBL_EPSILON * (64 + 16 * (side->size + side->radius) / sqrt(side->nearest2));
}

/* Halves until the halves agree with the whole. */
static double refine(struct side *side, const struct piece *piece, double from, double to, double whole, int halvings)
{
    double middle = from + (to - from) / 2;
    double first = panel(side, piece, from, middle), second = panel(side, piece, middle, to);
    double off = fabs(first + second - whole);
    bool agreed = off <= fmax(AGREED, rounding(side)) * (first + second);
    if (agreed || halvings == 0 || side->refined > MOST_REFINED) {
        side->doubt += off;
        return first + second;
    }
    return refine(side, piece, from, middle, first, halvings - 1) +
           refine(side, piece, middle, to, second, halvings - 1);
}

static double over_piece(struct side *side, const struct piece *piece)
{
    struct lx_pole pole = {-piece->from_middle, log1p(side->gap / side->radius)};
    double sum = 0, from = 0;
    for (int k = 0; k < LX_MOST_PANELS && from < piece->length && side->complete; k++) {
        double to = lx_panel_end(from, piece->length, &pole, 1);
        sum += refine(side, piece, from, to, panel(side, piece, from, to), MOST_HALVINGS);
        side->complete = side->complete && to > from;
        from = to;
    }
    side->complete = side->complete && !(from < piece->length);
    return sum;
}

/* ---- making ---- */

/* An angle in (0, 2 pi]. */
static lx_wide angle_of(struct lx_mark mark)
{
    lx_wide angle = lx_wide_atan2(mark.sine, mark.cosine);
    return angle.high > 0 ? angle : lx_wide_add(angle, lx_wide_scale(lx_wide_pi(), 2));
}

static struct height height_of(const struct lx_horizon *horizon)
{
    struct height height = {.crossed = horizon->crossed, .reach = lx_wide_value(horizon->reach)};
    if (height.reach > 0)
        height.top = atan2(horizon->top.sine.high, horizon->top.cosine.high);
    if (horizon->middle.high > 0)
        height.excess = lx_wide_value(lx_wide_sub(horizon->middle, horizon->reach));
    else
        height.excess = lx_wide_value(lx_wide_add(horizon->middle, horizon->reach));
    return height;
}

static struct piece piece_between(const lx_wide roots[ROOTS], lx_wide begin, lx_wide end)
{
    struct piece piece = {
        .length = lx_wide_value(lx_wide_sub(end, begin)),
        .from_middle = lx_wide_value(lx_wide_sub(begin, lx_wide_pi())),
    };
    for (int i = 0; i < ROOTS; i++) {
        piece.before[i] = lx_wide_value(lx_wide_sub(begin, roots[i]));
        piece.after[i] = lx_wide_value(lx_wide_sub(roots[i], end));
    }
    return piece;
}

static void sort(lx_wide values[], int count)
{
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && lx_wide_compare(values[k], values[k - 1]) < 0; k--) {
            lx_wide lower = values[k];
            values[k] = values[k - 1];
            values[k - 1] = lower;
        }
}

double lx_side_integral(const struct lx_rim rims[2], const struct lx_horizon horizons[2], double *relative)
{
    const struct lx_rim *rim = &rims[0];
    lx_wide gap = lx_wide_sub(rim->rho, rim->radius), length = lx_wide_sub(rims[1].height, rim->height);
    struct side side = {
        .rho = lx_wide_value(rim->rho),
        .radius = lx_wide_value(rim->radius),
        .gap = lx_wide_value(gap),
        .near = lx_wide_value(rim->height),
        .length = lx_wide_value(length),
        .heights = {height_of(&horizons[0]), height_of(&horizons[1])},
        .nearest2 = HUGE_VAL,
        .size = fmax(fabs(rim->height.high), fabs(rims[1].height.high)),
        .complete = true,
    };
    *relative = HUGE_VAL;
    if (!(side.gap > 0))
        return 0;
    /* half the angle of the near side has the tangent l/R */
    lx_wide tangent = lx_wide_mul(lx_wide_sqrt(gap), lx_wide_sqrt(lx_wide_add(rim->rho, rim->radius)));
    lx_wide half = lx_wide_atan2(tangent, rim->radius);
    lx_wide roots[ROOTS] = {lx_wide_sub(lx_wide_pi(), half), lx_wide_add(lx_wide_pi(), half)}, ends[ROOTS];
    int count = 0;
    ends[count++] = roots[FIRST];
    ends[count++] = roots[LAST];
    for (int i = 0; i < 2; i++) {
        if (!horizons[i].crossed)
            continue;
        lx_wide *rise = &roots[RISE + 2 * i], *set = &roots[SET + 2 * i];
        *rise = angle_of(horizons[i].rise);
        *set = angle_of(horizons[i].set);
        side.heights[i].inverted = lx_wide_compare(*set, *rise) < 0;
        for (int k = 0; k < 2; k++) {
            lx_wide root = k == 0 ? *rise : *set;
            if (lx_wide_compare(root, roots[FIRST]) > 0 && lx_wide_compare(root, roots[LAST]) < 0)
                ends[count++] = root;
        }
    }
    sort(ends, count);
    double sum = 0;
    for (int i = 0; i + 1 < count; i++) {
        struct piece piece = piece_between(roots, ends[i], ends[i + 1]);
        if (piece.length > 0)
            sum += over_piece(&side, &piece);
    }
    if (side.complete)
        *relative = rounding(&side) + (sum > 0 ? 2 * side.doubt / sum : 0);
    return side.radius * sum;
}
