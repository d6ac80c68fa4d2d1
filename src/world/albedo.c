/* SPDX-License-Identifier: MIT */
/*
 * The directional albedo: the diffuse part's has a closed form.  Powers of a cosine are integrated in polar coordinates
 * around the vector that stands still, in which the integral around it has one, too; other lobes in both angles around
 * the normal, in which V is turned by pi, so that the mirrored V lies where panels begin.
 */
#include "albedo.h"

#include <math.h>

#include "../base/vector.h"
#include "../material/lobe.h"
#include "integral/adaptive.h"

enum { OUTER_PANELS = 256, INNER_PANELS = 256 };

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
    struct lx_panel memory[OUTER_PANELS] = {{.interval = 0, .from = 0, .to = 1}, {.interval = 1, .from = 0, .to = 1}};
    struct lx_panels panels = {memory, 2, OUTER_PANELS};
    const struct lx_integrand integrand = {.at = by_circle, .target = target, .data = &circles};
    return lx_integrate_panels(&integrand, &panels).value;
}

struct hemisphere {
    const struct lx_lobe *lobe;
    struct lx_lobe_at at;
    double slant; /* of V */
    double cos_turn, sin_turn;
};

/* What L at an angle to the normal gives. */
static struct lx_point_value by_angle(void *data, size_t interval, double angle)
{
    const struct hemisphere *sky = data;
    const double sine = sin(angle), cosine = cos(angle);
    const double towards[3] = {sine * sky->cos_turn, sine * sky->sin_turn, cosine};
    double unused;
    (void)interval;
    const double f = exp(lx_lobe_log(sky->lobe, &sky->at, towards, 0, &unused));
    return (struct lx_point_value){.value = f * lx_lobe_weight(sky->lobe, cosine) * sine};
}

static struct lx_point_value by_turn(void *data, size_t interval, double turn)
{
    struct hemisphere *sky = data;
    struct lx_panel memory[INNER_PANELS] = {{.from = 0, .to = sky->slant}, {.from = sky->slant, .to = M_PI / 2}};
    const size_t first = sky->slant > 0 ? (size_t)0 : (size_t)1;
    struct lx_panels panels = {memory + first, 2 - first, INNER_PANELS - first};
    const struct lx_integrand integrand = {.at = by_angle, .target = target, .data = sky};
    (void)interval;
    sky->cos_turn = cos(turn);
    sky->sin_turn = sin(turn);
    return (struct lx_point_value){.value = lx_integrate_panels(&integrand, &panels).value};
}

/* The integral of f w over all L above the horizon. */
static double sum_lobe(const struct lx_lobe *lobe, double n_dot_v)
{
    struct hemisphere sky = {.lobe = lobe, .slant = acos(n_dot_v)};
    lx_lobe_at_set((const double[]){0, 0, 1}, (const double[]){-sin(sky.slant), 0, n_dot_v}, &sky.at);
    struct lx_panel memory[OUTER_PANELS] = {{.from = 0, .to = M_PI / 2}, {.from = M_PI / 2, .to = M_PI}};
    struct lx_panels panels = {memory, 2, OUTER_PANELS};
    const struct lx_integrand integrand = {.at = by_turn, .target = target, .data = &sky};
    return 2 * lx_integrate_panels(&integrand, &panels).value;
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
        albedo += lobe.specular.value * (lx_power_lobe_of(lobe.model) ? sum_power : sum_lobe)(&lobe, n_dot_v);
    return albedo;
}
