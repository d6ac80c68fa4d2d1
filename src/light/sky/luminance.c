/* SPDX-License-Identifier: MIT */
/* The luminance of the sky, and its integral over the hemisphere. */
#include "luminance.h"

#include <string.h>

#include "../../base/vector.h"
#include "../gauss.h"

/* a, b, c, d, e of the types 1 to 15. */
static const double coefficients[LX_SKY_KINDS - 1][5] = {
    {4, -0.7, 0, -1, 0},        {4, -0.7, 2, -1.5, 0.15},  {1.1, -0.8, 0, -1, 0},       {1.1, -0.8, 2, -1.5, 0.15},
    {0, -1, 0, -1, 0},          {0, -1, 2, -1.5, 0.15},    {0, -1, 5, -2.5, 0.3},       {0, -1, 10, -3, 0.45},
    {-1, -0.55, 2, -1.5, 0.15}, {-1, -0.55, 5, -2.5, 0.3}, {-1, -0.55, 10, -3, 0.45},   {-1, -0.32, 10, -3, 0.45},
    {-1, -0.32, 16, -3, 0.3},   {-1, -0.15, 16, -3, 0.3},  {-1, -0.15, 24, -2.8, 0.15},
};

bool lx_sky_has_sun(unsigned kind)
{
    return kind == LX_SKY_PEREZ || (kind > 0 && kind < LX_SKY_OVERCAST && coefficients[kind - 1][2] != 0);
}

/* phi by the cosine of Z, which is no less than 0. */
static double gradation(const struct lx_sky *sky, double cosine)
{
    return sky->a != 0 ? 1 + sky->a * exp(sky->b / fmax(cosine, DBL_MIN)) : 1;
}

static double indicatrix(const struct lx_sky *sky, double chi)
{
    const double cosine = cos(chi), off = sky->kind == LX_SKY_PEREZ ? 0 : exp(sky->d * M_PI_2);
    return 1 + sky->c * (exp(sky->d * chi) - off) + sky->e * cosine * cosine;
}

static struct lx_sky make(unsigned kind, const double *numbers, const double up[3], const double sun[3])
{
    struct lx_sky sky = {
        .kind = kind, .a = numbers[0], .b = numbers[1], .c = numbers[2], .d = numbers[3], .e = numbers[4]};
    memcpy(sky.up, up, sizeof sky.up);
    memcpy(sky.sun, lx_sky_has_sun(kind) ? sun : up, sizeof sky.sun);
    sky.scale = gradation(&sky, 1);
    if (lx_sky_has_sun(kind))
        sky.scale *= indicatrix(&sky, lx_angle_between(sky.sun, up));
    sky.scale = 1 / sky.scale;
    return sky;
}

struct lx_sky lx_sky_of_kind(unsigned kind, const double up[3], const double sun[3])
{
    static const double none[5] = {0};
    return make(kind, kind == LX_SKY_OVERCAST ? none : coefficients[kind - 1], up, sun);
}

struct lx_sky lx_sky_of_perez(const double numbers[5], const double up[3], const double sun[3])
{
    return make(LX_SKY_PEREZ, numbers, up, sun);
}

double lx_sky_luminance(const struct lx_sky *sky, const double towards[3])
{
    const double cosine = fmax(lx_dot(sky->up, towards), 0);
    if (sky->kind == LX_SKY_OVERCAST)
        return (1 + 2 * cosine) / 3;
    const double around = sky->c != 0 ? indicatrix(sky, lx_angle_between(sky->sun, towards)) : 1;
    return gradation(sky, cosine) * around * sky->scale;
}

double lx_sky_greatest(const struct lx_sky *sky)
{
    if (sky->kind == LX_SKY_OVERCAST)
        return 1;
    if (sky->kind != LX_SKY_PEREZ)
        return (1 + fmax(sky->a, 0)) * indicatrix(sky, 0) * sky->scale;
    const double round = fmax(sky->c, 0) * fmax(exp(sky->d * M_PI), 1) + fmax(sky->e, 0);
    return (1 + fmax(sky->a, 0)) * (1 + round) * sky->scale;
}

/* ---- the integral ---- */

/* How finely: halvings of the azimuth towards a right angle to the zenith, and of a way towards both of its ends:
 * to the horizon, and to the sun, which may be near to that. */
struct fineness {
    int azimuths, ways;
};

/* Along a great circle from the sun, at an azimuth about it from straight down: to where the horizon is. */
static double along(const struct lx_sky *sky, double sine, double cosine, double azimuth, int halvings)
{
    const double down = cosine * cos(azimuth), horizon = atan2(sine, down);
    double sum = 0;
    for (int panel = 0; panel < 2 * (halvings + 1); panel++) {
        const int k = panel / 2;
        const double far = ldexp(horizon, -k - 1), near = k < halvings ? far / 2 : 0, half = (far - near) / 2;
        for (int i = 0; i < LX_GAUSS_NODES; i++) {
            const double off = near + half * (1 + lx_gauss[i].place), chi = panel % 2 ? horizon - off : off;
            const double height = sine * cos(chi) - down * sin(chi);
            double light = sky->kind == LX_SKY_OVERCAST ? (1 + 2 * height) / 3 : gradation(sky, fmax(height, 0));
            if (sky->c != 0)
                light *= indicatrix(sky, chi);
            sum += half * lx_gauss[i].weight * light * fmax(height, 0) * sin(chi);
        }
    }
    return sum * sky->scale;
}

/* Where the sun is low the horizon comes near to it quickly: at azimuths next to a right angle. */
static double all_around(const struct lx_sky *sky, double sine, double cosine, struct fineness fineness)
{
    double sum = 0;
    for (int side = -1; side <= 1; side += 2)
        for (int panel = 0; panel <= fineness.azimuths; panel++) {
            const double from = M_PI_2 * ldexp(1, -panel),
                         to = panel < fineness.azimuths ? M_PI_2 * ldexp(1, -panel - 1) : 0, half = (from - to) / 2;
            for (int i = 0; i < LX_GAUSS_NODES; i++) {
                const double off = to + half * (1 + lx_gauss[i].place);
                sum += half * lx_gauss[i].weight * along(sky, sine, cosine, M_PI_2 + side * off, fineness.ways);
            }
        }
    return 2 * sum;
}

lx_bounded lx_sky_horizontal(const struct lx_sky *sky)
{
    static const struct fineness steps[] = {{2, 2}, {4, 4}, {8, 6}, {16, 10}};
    static const double ENOUGH = 1e-13;
    double cross[3];
    lx_cross(sky->up, sky->sun, cross);
    const double sine = lx_dot(sky->up, sky->sun), cosine = sqrt(lx_dot(cross, cross));
    double value = all_around(sky, sine, cosine, steps[0]), off = value;
    for (int i = 1; i < 4 && off > ENOUGH * value; i++) {
        const double finer = all_around(sky, sine, cosine, steps[i]);
        off = fabs(finer - value);
        value = finer;
    }
    return (lx_bounded){value, off + 1e-14 * value};
}
