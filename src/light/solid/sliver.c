/* SPDX-License-Identifier: MIT */
/*
 * A disk that the horizon cuts, as an integral of what is not negative.  With s along the way in which N.r grows on the
 * disk, w across, both in units of R, and s = cos f, w = y sin f,
 *
 *     E = R^2 h reach  int_0^tau (cos f - cos tau) sin^2 f  int_-1^1 dy/|r|^4  df
 *
 * The panels keep away from where the integrand is singular.  In y: where |r|^2 = 0.  In f: where |r|^2 = 0 at an end
 * of the chord, which is the point w of the rim with w - w0 = +-f and cos w = -K/kappa; and where |r|^2 has a double
 * root in y, (R s + rho cos w0)^2 + h^2 = 0.
 */
#include "../gauss.h"
#include "rim.h"

enum { POLES = 6 };
/* Farther than any panel needs. */
static const double FAR = 100;

/* The piece of the disk that is seen: its highest place, and the ways from there. */
struct sliver {
    double apex_s, apex_w, height; /* r of the highest place: along s, along w, along a */
    double radius, tau;
    double nearest2; /* the least |r|^2 that was met */
    bool complete;   /* the panels sufficed */
};

/* |r|^2 at s = 1 - fall */
static double distance2(struct sliver *sliver, double fall, double w)
{
    double s = sliver->apex_s - sliver->radius * fall, across = sliver->apex_w + sliver->radius * w;
    double result = s * s + across * across + sliver->height * sliver->height;
    sliver->nearest2 = fmin(sliver->nearest2, result);
    return result;
}

/* The integral of 1/|r|^4 over a part of the chord at s = 1 - fall, from one w to another. */
static double chord_panel(struct sliver *sliver, double fall, double from, double to)
{
    double middle = (from + to) / 2, half = (to - from) / 2, sum = 0;
    for (int i = 0; i < LX_GAUSS_NODES; i++) {
        double d2 = distance2(sliver, fall, middle + half * lx_gauss[i].place);
        sum += lx_gauss[i].weight / (d2 * d2);
    }
    return half * sum;
}

static double chord(struct sliver *sliver, double fall, double width)
{
    double s = sliver->apex_s - sliver->radius * fall, sum = 0, from = -width;
    struct lx_pole pole = {-sliver->apex_w / sliver->radius, hypot(s, sliver->height) / sliver->radius};
    for (int i = 0; i < LX_MOST_PANELS && from < width && sliver->complete; i++) {
        double to = lx_panel_end(from, width, &pole, 1);
        sum += chord_panel(sliver, fall, from, to);
        sliver->complete = to > from;
        from = to;
    }
    sliver->complete = sliver->complete && !(from < width);
    return sum;
}

/* The part of the integral over f from one value to another; f and tau - f are each known to their own last place. */
static double panel(struct sliver *sliver, double from, double to)
{
    double middle = (from + to) / 2, half = (to - from) / 2, sum = 0;
    for (int i = 0; i < LX_GAUSS_NODES; i++) {
        double f = middle + half * lx_gauss[i].place, left = (sliver->tau - to) + half * lx_gauss[i].rest;
        double sine = sin(f), versine = 2 * sin(f / 2) * sin(f / 2);
        double above = 2 * sin(left / 2) * sin((sliver->tau + f) / 2);
        sum += lx_gauss[i].weight * above * sine * chord(sliver, versine, sine);
    }
    return half * sum;
}

/* The place whose cosine is x + i y, y > 0: x = cos(along) cosh(off), y = sin(along) sinh(off). */
static struct lx_pole pole_of_cosine(double x, double y)
{
    double b = (x - 1) * (x + 1) + y * y, root = hypot(b, 2 * y);
    double sinh_off = b < 0 ? y * sqrt(2 / (root - b)) : sqrt((root + b) / 2);
    return (struct lx_pole){atan2(y / sinh_off, x / hypot(1, sinh_off)), asinh(sinh_off)};
}

/* Where the outer integrand is singular, and again on both sides of 0 and of pi; w0: the angle of the highest place. */
static void find_poles(const struct lx_rim *rim, struct lx_mark top, struct lx_pole poles[POLES])
{
    double rho = rim->rho.high, radius = rim->radius.high, height = rim->height.high;
    poles[0].along = fabs(atan2(top.sine.high, -top.cosine.high));
    /* arcosh(K/kappa) = 2 artanh(lambda) off the side of the rim that is nearest to the element */
    poles[0].off = fmin(2 * atanh(fmin(rim->lambda.high, 1)), FAR);
    poles[1] = pole_of_cosine(-rho * top.cosine.high / radius, height / radius);
    for (int i = 0; i < 2; i++) {
        poles[2 + i] = (struct lx_pole){-poles[i].along, poles[i].off};
        poles[4 + i] = (struct lx_pole){2 * M_PI - poles[i].along, poles[i].off};
    }
}

double lx_cut_disk_integral(const struct lx_rim *rim, const struct lx_horizon *horizon, double *relative)
{
    const struct lx_mark *top = &horizon->top;
    double radius = lx_wide_value(rim->radius), height = lx_wide_value(rim->height);
    struct sliver sliver = {
        .apex_s = lx_wide_value(lx_wide_add(rim->radius, lx_wide_mul(rim->rho, top->cosine))),
        .apex_w = -lx_wide_value(lx_wide_mul(rim->rho, top->sine)),
        .height = height,
        .radius = radius,
        .tau = lx_wide_value(horizon->half_turn),
        .nearest2 = HUGE_VAL,
        .complete = true,
    };
    struct lx_pole poles[POLES];
    find_poles(rim, *top, poles);
    double sum = 0, from = 0;
    for (int i = 0; i < LX_MOST_PANELS && from < sliver.tau && sliver.complete; i++) {
        double to = lx_panel_end(from, sliver.tau, poles, POLES);
        sum += panel(&sliver, from, to);
        sliver.complete = sliver.complete && to > from;
        from = to;
    }
    double extent = fabs(sliver.apex_s) + fabs(sliver.apex_w) + radius * fmin(sliver.tau, 2);
    *relative = HUGE_VAL;
    if (sliver.complete && !(from < sliver.tau))
        *relative = DBL_EPSILON * (64 + 16 * extent / sqrt(sliver.nearest2));
    return radius * radius * height * lx_wide_value(horizon->reach) * sum;
}
