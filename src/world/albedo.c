/* SPDX-License-Identifier: MIT */
/*
 * The directional albedo: the diffuse part's has a closed form, that of other lobes is integrated in polar coordinates
 * around the normal, in which V is turned by pi, so that the mirrored V lies where panels begin.
 */
#include "albedo.h"

#include <math.h>

#include "../base/vector.h"
#include "../material/lobe.h"
#include "integral/adaptive.h"

enum { OUTER_PANELS = 256, INNER_PANELS = 256 };

/* Absolute, of each of the two integrals. */
static const double TOLERANCE = 2e-12;

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

static double target(void *data, const struct lx_integral *integral)
{
    (void)data;
    return TOLERANCE * fmax(integral->value, 1);
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
    return lx_lobe_shines(&lobe) ? albedo + lobe.specular.value * sum_lobe(&lobe, n_dot_v) : albedo;
}
