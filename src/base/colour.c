/* SPDX-License-Identifier: MIT */
/*
 * Colour science: spectra and Planck's law through the eyes of the CIE 1931 observer, linear sRGB, chromaticities, and
 * the black body that is nearest to a colour.
 */
#include "colour.h"

#include <math.h>

#include "memory.h"
#include "observer_table.h"

static const double C2_NM_K = 1.438776877e7; /* the second radiation constant (CODATA 2018) */

/* Linear sRGB to X, Y, Z and back, of the primaries (.64, .33), (.30, .60), (.15, .06) and the white (.3127, .3290). */
static const double TO_XYZ[3][3] = {{0.4123907992659595, 0.35758433938387796, 0.1804807884018343},
                                    {0.21263900587151036, 0.7151686787677559, 0.07219231536073371},
                                    {0.01933081871559185, 0.11919477979462599, 0.9505321522496606}};
static const double TO_RGB[3][3] = {{3.2409699419045213, -1.5373831775700935, -0.4986107602930033},
                                    {-0.9692436362808798, 1.8759675015077206, 0.04155505740717561},
                                    {0.05563007969699361, -0.20397695888897657, 1.0569715142428786}};

static void multiply(const double matrix[3][3], const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = matrix[i][0] * from[0] + matrix[i][1] * from[1] + matrix[i][2] * from[2];
}

double luxel_rgb_luminance(const double rgb[3])
{
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2])
        return rgb[0];
    return TO_XYZ[1][0] * rgb[0] + TO_XYZ[1][1] * rgb[1] + TO_XYZ[1][2] * rgb[2];
}

void luxel_xy_to_rgb(const double xy[2], double rgb[3])
{
    const double xyz[3] = {xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]};
    multiply(TO_RGB, xyz, rgb);
}

bool lx_spectrum_xy(const double power[LX_WAVELENGTHS], double xy[2])
{
    double xyz[3] = {0, 0, 0};
    for (int i = 0; i < LX_WAVELENGTHS; i++)
        for (int k = 0; k < 3; k++)
            xyz[k] += power[i] * observer_table[3 * i + k];
    const double sum = xyz[0] + xyz[1] + xyz[2];
    if (!(xyz[1] > 0) || !isfinite(sum))
        return false;
    xy[0] = xyz[0] / sum;
    xy[1] = xyz[1] / sum;
    return true;
}

/* Planck's law relative to 560 nm, so that no temperature leaves the range of float64. */
void luxel_planck_xy(double kelvin, double xy[2])
{
    double power[LX_WAVELENGTHS];
    for (int i = 0; i < LX_WAVELENGTHS; i++) {
        const double nm = LX_FIRST_NM + i, exponent = C2_NM_K / (nm * kelvin), at_560 = C2_NM_K / (560 * kelvin);
        power[i] = pow(560 / nm, 5) * exp(at_560 - exponent) * (expm1(-at_560) / expm1(-exponent));
    }
    lx_spectrum_xy(power, xy);
}

bool lx_is_light(const double xy[2])
{
    static const double ROUNDING = 1e-9;
    bool is_inside = false;
    double before[2] = {0, 0};
    for (int i = -1; i < LX_WAVELENGTHS; i++) {
        const double *xyz = &observer_table[3 * (i < 0 ? LX_WAVELENGTHS - 1 : i)], sum = xyz[0] + xyz[1] + xyz[2];
        const double at[2] = {xyz[0] / sum, xyz[1] / sum};
        if (i >= 0 && (at[1] > xy[1]) != (before[1] > xy[1])) {
            const double crossing = at[0] + (before[0] - at[0]) * (xy[1] - at[1]) / (before[1] - at[1]);
            if (fabs(xy[0] - crossing) < ROUNDING)
                return true;
            is_inside ^= xy[0] < crossing;
        }
        before[0] = at[0], before[1] = at[1];
    }
    return is_inside;
}

/* ---- the nearest black body ---- */

/* u, v of 1960, in which distances are taken. */
static void uv_of(const double xy[2], double uv[2])
{
    const double d = -2 * xy[0] + 12 * xy[1] + 3;
    uv[0] = 4 * xy[0] / d;
    uv[1] = 6 * xy[1] / d;
}

/* How far the black body of a reciprocal temperature in 1/MK is. */
static double distance_from(const double uv[2], double mired, double black[2])
{
    double xy[2];
    luxel_planck_xy(1e6 / mired, xy);
    uv_of(xy, black);
    return hypot(uv[0] - black[0], uv[1] - black[1]);
}

/* The slope of half the squared distance, which is 0 at the nearest one. */
static double slope_at(const double uv[2], double mired)
{
    const double step = mired * 1e-4;
    double before[2], behind[2], at[2];
    distance_from(uv, mired - step, before);
    distance_from(uv, mired + step, behind);
    distance_from(uv, mired, at);
    return ((at[0] - uv[0]) * (behind[0] - before[0]) + (at[1] - uv[1]) * (behind[1] - before[1])) / (2 * step);
}

/* The nearest of some black bodies from 25500 to 980 K, then the zero of the slope between its neighbours. */
static void find_temperature(const double uv[2], luxel_chromaticity *chromaticity)
{
    enum { STEPS = 48 };
    const double first = 1e6 / 25500, ratio = pow(25500.0 / 980, 1.0 / STEPS);
    double nearest = HUGE_VAL, mired = first, best = first, black[2];
    for (int i = 0; i <= STEPS; i++, mired *= ratio) {
        const double distance = distance_from(uv, mired, black);
        best = distance < nearest ? mired : best;
        nearest = fmin(nearest, distance);
    }
    double low = best / ratio, high = best * ratio, of_low = slope_at(uv, low), of_high = slope_at(uv, high);
    if (!(of_low < 0 && of_high > 0))
        return;
    for (int i = 0; i < 60 && high - low > 1e-12 * high; i++) {
        /* a secant, kept off the ends so that both come nearer */
        const double share = fmin(fmax(of_low / (of_low - of_high), 0.01), 0.99);
        const double between = low + share * (high - low), slope = slope_at(uv, between);
        if (slope < 0)
            low = between, of_low = slope;
        else
            high = between, of_high = slope;
    }
    mired = (low + high) / 2;
    const double distance = distance_from(uv, mired, black), kelvin = 1e6 / mired;
    chromaticity->duv = uv[1] < black[1] ? -distance : distance;
    chromaticity->cct_k = kelvin;
    chromaticity->has_cct = kelvin >= 999.999 && kelvin <= 25000.001 && distance <= 0.05;
    if (!chromaticity->has_cct)
        chromaticity->cct_k = chromaticity->duv = 0;
}

void luxel_find_chromaticity(const double rgb[3], luxel_chromaticity *chromaticity)
{
    double uv[2];
    *chromaticity = (luxel_chromaticity){.has_xy = false};
    multiply(TO_XYZ, rgb, chromaticity->xyz);
    const double *xyz = chromaticity->xyz, sum = xyz[0] + xyz[1] + xyz[2];
    chromaticity->has_xy = xyz[1] > 0 && sum > 0 && isfinite(sum);
    if (!chromaticity->has_xy)
        return;
    chromaticity->xy[0] = xyz[0] / sum;
    chromaticity->xy[1] = xyz[1] / sum;
    uv_of(chromaticity->xy, uv);
    chromaticity->uv[0] = uv[0];
    chromaticity->uv[1] = 1.5 * uv[1];
    find_temperature(uv, chromaticity);
}

/* ---- many colours ---- */

enum { BODIES = 1024 };

struct lx_black_bodies {
    double ratio;         /* of the mireds of two neighbours */
    double uv[BODIES][2]; /* from 26000 K down to 950 K */
};

static const double HOTTEST = 26000, COLDEST = 950;

struct lx_black_bodies *lx_black_bodies_new(void)
{
    struct lx_black_bodies *bodies = lx_new_array(1, sizeof *bodies);
    if (!bodies)
        return NULL;
    bodies->ratio = pow(HOTTEST / COLDEST, 1.0 / (BODIES - 1));
    for (int i = 0; i < BODIES; i++)
        distance_from((const double[]){0, 0}, 1e6 / HOTTEST * pow(bodies->ratio, i), bodies->uv[i]);
    return bodies;
}

/* The place on the cubic through four neighbours, t steps behind the second, and how fast it moves. */
static void place_at(const struct lx_black_bodies *bodies, int second, double t, double uv[2], double way[2])
{
    for (int k = 0; k < 2; k++) {
        const double a = bodies->uv[second - 1][k], b = bodies->uv[second][k], c = bodies->uv[second + 1][k];
        const double d = bodies->uv[second + 2][k];
        const double c1 = c - a / 3 - b / 2 - d / 6, c2 = (a + c) / 2 - b, c3 = (d - a) / 6 + (b - c) / 2;
        uv[k] = b + t * (c1 + t * (c2 + t * c3));
        way[k] = c1 + t * (2 * c2 + 3 * t * c3);
    }
}

double lx_black_body_near(const struct lx_black_bodies *bodies, const double rgb[3])
{
    double xyz[3], uv[2], at[2], way[2], nearest = HUGE_VAL, t = 0;
    int best = 0;
    multiply(TO_XYZ, rgb, xyz);
    const double sum = xyz[0] + xyz[1] + xyz[2];
    if (!(xyz[1] > 0 && sum > 0 && isfinite(sum)))
        return 0;
    uv_of((const double[]){xyz[0] / sum, xyz[1] / sum}, uv);
    for (int i = 0; i < BODIES; i++) {
        const double u = bodies->uv[i][0] - uv[0], v = bodies->uv[i][1] - uv[1], square = u * u + v * v;
        best = square < nearest ? i : best;
        nearest = fmin(nearest, square);
    }
    const int second = best < 1 ? 1 : best > BODIES - 3 ? BODIES - 3 : best;
    /* from tangent to tangent, by the foot of the perpendicular: at such distances they come together */
    double step = 1;
    for (int i = 0; i < 60 && fabs(step) > 1e-7; i++) {
        place_at(bodies, second, t, at, way);
        step = ((at[0] - uv[0]) * way[0] + (at[1] - uv[1]) * way[1]) / (way[0] * way[0] + way[1] * way[1]);
        t = fmax(-2, fmin(t - step, 3));
    }
    const double kelvin = HOTTEST * pow(bodies->ratio, -(second + t));
    return kelvin >= 999.999 && kelvin <= 25000.001 && hypot(at[0] - uv[0], at[1] - uv[1]) <= 0.05 ? kelvin : 0;
}

double luxel_srgb_curve(double channel)
{
    if (channel >= 1)
        return 1; /* to the last bit */
    return channel <= 0.0031308 ? 12.92 * channel : 1.055 * pow(channel, 1 / 2.4) - 0.055;
}
