/* SPDX-License-Identifier: MIT */
/*
 * A disk that the horizon cuts, as an integral of what is not negative.  With s along the way in which N.r grows on the
 * disk, w across, both in units of R, and s = cos f, w = y sin f,
 *
 *     E = R^2 h reach  int_0^tau (cos f - cos tau) sin^2 f  int_-1^1 dy/|r|^4  df
 *
 * Gauss's rule takes panels that are halved until they are short against their distance from the places in the complex
 * plane where the integrand is singular.  These are known.  In y: where |r|^2 = 0.  In f: where |r|^2 = 0 at an end
 * of the chord, which is the point w of the rim with w - w0 = +-f and cos w = -K/kappa; and where |r|^2 has a double
 * root in y, (R s + rho cos w0)^2 + h^2 = 0.
 *
 * Where a panel's middle is 3 of its half lengths from the nearest of them, the integrand is analytic within an ellipse
 * about the panel with Bernstein's parameter 4.7, and there at most some 1000 times as large as on the panel: 16 nodes
 * leave 1000 * 4.7^-32 = 3e-19 of it.
 */
#include <complex.h>

#include "rim.h"

const double lx_gauss_nodes[LX_GAUSS_HALF] = {
    0.09501250983763744, 0.2816035507792589, 0.45801677765722737, 0.6178762444026438,
    0.755404408355003,   0.8656312023878318, 0.9445750230732326,  0.9894009349916499,
};
const double lx_gauss_weights[LX_GAUSS_HALF] = {
    0.1894506104550685,  0.18260341504492358, 0.16915651939500254,  0.14959598881657674,
    0.12462897125553388, 0.09515851168249279, 0.062253523938647894, 0.027152459411754096,
};

enum { MOST_PANELS = 200 };
/* How far a panel must keep from singular places, in its half lengths. */
static const double CLEARANCE = 3;
/* Farther than any panel needs. */
static const double FAR = 50;

/* The piece of the disk that is seen: its highest place, and the ways from there. */
struct sliver {
    double apex_s, apex_w, height; /* r of the highest place: along s, along w, along a */
    double radius, tau;
    double complex singular[2];
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
    for (int i = 0; i < 2 * LX_GAUSS_HALF; i++) {
        double node = i < LX_GAUSS_HALF ? lx_gauss_nodes[i] : -lx_gauss_nodes[i - LX_GAUSS_HALF];
        double d2 = distance2(sliver, fall, middle + half * node);
        sum += lx_gauss_weights[i % LX_GAUSS_HALF] / (d2 * d2);
    }
    return half * sum;
}

static double chord(struct sliver *sliver, double fall, double width)
{
    double s = sliver->apex_s - sliver->radius * fall;
    double pole_w = -sliver->apex_w / sliver->radius, pole_off = hypot(s, sliver->height) / sliver->radius;
    double sum = 0, from = -width;
    for (int i = 0; i < MOST_PANELS && from < width && sliver->complete; i++) {
        /* as long as it may be: halves of what is left */
        double to = width;
        while (hypot((from + to) / 2 - pole_w, pole_off) < CLEARANCE * (to - from) / 2)
            to = from + (to - from) / 2;
        sum += chord_panel(sliver, fall, from, to);
        from = to;
    }
    sliver->complete = sliver->complete && from == width;
    return sum;
}

/* The part of the integral over f from one value to another; f and tau - f are each known to their own last place. */
static double panel(struct sliver *sliver, double from, double to)
{
    double middle = (from + to) / 2, half = (to - from) / 2, sum = 0;
    for (int i = 0; i < 2 * LX_GAUSS_HALF; i++) {
        double node = i < LX_GAUSS_HALF ? lx_gauss_nodes[i] : -lx_gauss_nodes[i - LX_GAUSS_HALF];
        double f = middle + half * node, left = (sliver->tau - to) + half * (1 - node);
        double sine = sin(f), versine = 2 * sin(f / 2) * sin(f / 2);
        double above = 2 * sin(left / 2) * sin((sliver->tau + f) / 2);
        sum += lx_gauss_weights[i % LX_GAUSS_HALF] * above * sine * chord(sliver, versine, sine);
    }
    return half * sum;
}

static double clearance(const struct sliver *sliver, double f)
{
    double least = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        double complex z = sliver->singular[i];
        least = fmin(least, fmin(cabs(z - f), cabs(z + f)));
        least = fmin(least, cabs(2 * M_PI - z - f));
    }
    return least;
}

double lx_cut_disk_integral(const struct lx_rim *rim, const struct lx_horizon *horizon, double *relative)
{
    lx_wide c0 = horizon->top.cosine, s0 = horizon->top.sine;
    double rho = lx_wide_value(rim->rho), radius = lx_wide_value(rim->radius), height = lx_wide_value(rim->height);
    struct sliver sliver = {
        .apex_s = lx_wide_value(lx_wide_add(rim->radius, lx_wide_mul(rim->rho, c0))),
        .apex_w = -lx_wide_value(lx_wide_mul(rim->rho, s0)),
        .height = height,
        .radius = radius,
        .tau = lx_wide_value(horizon->half_turn),
        .nearest2 = HUGE_VAL,
        .complete = true,
    };
    /* arcosh(K/kappa) = 2 artanh(lambda) off the side of the rim that is nearest to the element */
    double offset = 2 * atanh(fmin(lx_wide_value(rim->lambda), 1));
    double opposite = atan2(lx_wide_value(s0), -lx_wide_value(c0));
    sliver.singular[0] = CMPLX(fabs(opposite), fmin(offset, 2 * FAR));
    sliver.singular[1] = cacos(CMPLX(-rho * lx_wide_value(c0) / radius, height / radius));

    double sum = 0, from = 0;
    for (int i = 0; i < MOST_PANELS && from < sliver.tau && sliver.complete; i++) {
        double to = sliver.tau;
        while (clearance(&sliver, (from + to) / 2) < CLEARANCE * (to - from) / 2)
            to = from + (to - from) / 2;
        sum += panel(&sliver, from, to);
        from = to;
    }
    double reach = lx_wide_value(horizon->reach);
    double extent = fabs(sliver.apex_s) + fabs(sliver.apex_w) + radius * fmin(sliver.tau, 2);
    *relative = DBL_EPSILON * (64 + 16 * extent / sqrt(sliver.nearest2));
    if (!sliver.complete || from != sliver.tau)
        *relative = HUGE_VAL;
    return radius * radius * height * reach * sum;
}
