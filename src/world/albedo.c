/* SPDX-License-Identifier: MIT */
/*
 * The directional albedo: the diffuse part's has a closed form.  Powers of a cosine are integrated in polar coordinates
 * around the vector that stands still, in which the integral around it has one, too; facets in polar coordinates around
 * the normal, which are changed so that their peak is as wide as all else.
 */
#include "albedo.h"

#include <math.h>

#include "../base/vector.h"
#include "../material/lobe.h"
#include "integral/adaptive.h"

enum { PANELS = 256 };

/* Absolute, of each integral. */
static const double TOLERANCE = 2e-12;

static double target(void *data, const struct lx_integral *integral)
{
    (void)data;
    return TOLERANCE * fmax(integral->value, 1);
}

/* A power, and between which angles to the still vector its circles are, by interval. */
struct circles {
    const struct lx_lobe *lobe;
    double cosine, sine; /* of the angle of V to the normal */
    double ends[3];
};

/*
 * The integral of the weight over the part above the horizon of the circle at an angle to the still vector: that is M,
 * around which L goes, or N, around which H does, while L goes 4 V.H times as fast.  N.L = a + b cos(phi), and that
 * speed is p + q cos(phi).
 */
static double around(const struct circles *circles, double cosine, double sine)
{
    const struct lx_lobe *lobe = circles->lobe;
    const bool by_half = LX_IS_BY_HALF(lobe->model);
    const double along = circles->cosine * cosine, across = circles->sine * sine;
    const double a = by_half ? 2 * along * cosine - circles->cosine : along, b = by_half ? 2 * across * cosine : across;
    const double p = by_half ? 4 * along : 1, q = by_half ? 4 * across : 0;
    const double turn = a >= b ? M_PI : a <= -b ? 0 : acos(-a / b), first = sin(turn);
    if (!LX_FALLS_TO_HORIZON(lobe->highlight))
        return 2 * (p * turn + q * first);
    return 2 * (p * a * turn + (p * b + q * a) * first) + q * b * (turn + first * cos(turn));
}

/* The angle goes as a cubic without slope at the ends, where `turn` begins and ends as a root. */
static struct lx_point_value by_circle(void *data, size_t interval, double x)
{
    const struct circles *circles = data;
    const double from = circles->ends[interval], width = circles->ends[interval + 1] - from;
    const double angle = from + width * x * x * (3 - 2 * x), cosine = cos(angle), sine = sin(angle);
    const double slope = 6 * width * x * (1 - x);
    return (struct lx_point_value){
        .value = cosine > 0 ? pow(cosine, circles->lobe->exponent) * sine * slope * around(circles, cosine, sine) : 0};
}

/* The integral of S^n w over all L above the horizon: circles are whole, then cut by the horizon. */
static double sum_power(const struct lx_lobe *lobe, double n_dot_v)
{
    const double slant = acos(n_dot_v);
    const bool by_half = LX_IS_BY_HALF(lobe->model);
    struct circles circles = {.lobe = lobe, .cosine = n_dot_v, .sine = sin(slant)};
    circles.ends[1] = (M_PI / 2 - slant) / (by_half ? 2 : 1);
    circles.ends[2] = by_half ? (M_PI / 2 + slant) / 2 : M_PI / 2;
    struct lx_panel memory[PANELS] = {{.interval = 0, .from = 0, .to = 1}, {.interval = 1, .from = 0, .to = 1}};
    struct lx_panels panels = {memory, 2, PANELS};
    const struct lx_integrand integrand = {.at = by_circle, .target = target, .data = &circles};
    return lx_integrate_panels(&integrand, &panels).value;
}

/*
 * Facets, at an angle theta of L to the normal.  With the angle phi around the normal from the mirrored V on, 1 + L.V =
 * 2 C + S (1 - cos phi), and D has the denominator (u + 2 S (1 - cos phi))^2.
 */
struct facets {
    const struct lx_lobe *lobe;
    double slant, n_dot_v;
    double c, s, u, w; /* w: u + 4 S */
};

/*
 * The integral of F D around the normal, without a^2.  With tan(phi/2) = sqrt(u/w) sinh(y) it is one over all y whose
 * function has no pole nearer to them than pi/2 and falls as exp(-y) in the end: the sum in steps of h, from 0 on and
 * twice, is off by a share of some 1000 exp(-pi^2/h).
 */
static double around_facets(const struct facets *facets)
{
    static const double step = 0.25, least = 1e-15;
    const double m = sqrt(facets->u / facets->w), f0 = facets->lobe->own[1], growth = exp(step);
    double sum = 0, value = 1;
    for (double e = 1; value > least * sum || m * e < 2; e *= growth) {       /* e: exp(y) */
        const double t = m * (e - 1 / e) / 2, part = 2 * t * t / (1 + t * t); /* 1 - cos(phi) */
        const double both = 2 * facets->c + facets->s * part;
        const double versine = fmax(1 - sqrt(both / 2), 0), square = versine * versine;
        const double ratio = 2 * both / (facets->u + 2 * facets->s * part);
        value = (f0 + (1 - f0) * square * square * versine) * ratio * ratio * m * (e + 1 / e) / (1 + t * t);
        sum += e > 1 ? value : value / 2;
    }
    return 2 * step * sum;
}

/* What all L at an angle to the normal give: theta = theta_V + 2 atan(a sinh x), over which D has no peak. */
static struct lx_point_value by_slant(void *data, size_t interval, double x)
{
    struct facets *facets = data;
    const double square = facets->lobe->own[0], a = facets->lobe->own[2];
    const double delta = atan(a * sinh(x)), theta = facets->slant + 2 * delta, mean = facets->slant + delta;
    const double n_dot_l = cos(theta), cosine = cos(mean), sine = sin(mean), near = cos(delta);
    (void)interval;
    facets->c = cosine * cosine;
    facets->s = fmax(sin(theta), 0) * sin(facets->slant);
    facets->u = 4 * facets->c * (sin(delta) * sin(delta) + square * near * near);
    facets->w = 4 * near * near * (sine * sine + square * facets->c);
    if (!(n_dot_l > 0 && facets->u > 0 && facets->w > 0))
        return (struct lx_point_value){.value = 0};
    const double seen_root = sqrt(square + (1 - square) * facets->n_dot_v * facets->n_dot_v);
    const double lit_root = sqrt(square + (1 - square) * n_dot_l * n_dot_l);
    const double slope = 2 * a * cosh(x) * near * near; /* of theta by x */
    return (struct lx_point_value){.value = square * n_dot_l * around_facets(facets) * fmax(sin(theta), 0) * slope /
                                            (2 * (n_dot_l * seen_root + facets->n_dot_v * lit_root))};
}

/* The integral of f w of facets over all L above the horizon. */
static double sum_facets(const struct lx_lobe *lobe, double n_dot_v)
{
    struct facets facets = {.lobe = lobe, .slant = acos(n_dot_v), .n_dot_v = n_dot_v};
    const double a = lobe->own[2];
    struct lx_panel memory[PANELS] = {
        {.from = -asinh(tan(facets.slant / 2) / a), .to = asinh(tan(M_PI / 4 - facets.slant / 2) / a)}};
    struct lx_panels panels = {memory, 1, PANELS};
    const struct lx_integrand integrand = {.at = by_slant, .target = target, .data = &facets, .is_smooth = true};
    return lx_integrate_panels(&integrand, &panels).value;
}

double lx_material_albedo(const struct lx_material *material, double n_dot_v)
{
    struct lx_material divided = *material;
    if (!(n_dot_v > 0))
        return (double)NAN;
    divided.over_pi = true;
    n_dot_v = fmin(n_dot_v, 1);
    const struct lx_lobe lobe = lx_lobe_prepare(&divided);
    double albedo = M_PI * lobe.diffuse.value;
    if (lx_lobe_is_rough(&lobe)) {
        const struct lx_lobe rough = lx_lobe_of_diffuse(&lobe);
        albedo *= lx_lobe_kind_of(&rough)->albedo(&rough, n_dot_v);
    }
    if (lx_lobe_shines(&lobe))
        albedo += lobe.specular.value * (lx_power_lobe_of(lobe.model) ? sum_power : sum_facets)(&lobe, n_dot_v);
    return albedo;
}
