/* SPDX-License-Identifier: MIT */
/* What both witnesses of light (witness.c, sky_witness.c) know of skies and glass, from the formulas alone. */
#ifndef LX_WITNESS_SKY_H
#define LX_WITNESS_SKY_H

#include <math.h>
#include <stdbool.h>

static const double PI = 3.14159265358979323846;

typedef struct {
    double x, y, z;
} vector;

static vector add(vector a, vector b, double by)
{
    return (vector){a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

static double dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static vector times(vector a, double by)
{
    return (vector){by * a.x, by * a.y, by * a.z};
}

static vector unit(vector a)
{
    return times(a, 1 / sqrt(dot(a, a)));
}

/* Two directions across a unit vector. */
static void across(vector n, vector *a, vector *b)
{
    const vector other = fabs(n.x) < 0.6 ? (vector){1, 0, 0} : (vector){0, 1, 0};
    *a = unit(cross(n, other));
    *b = cross(n, *a);
}

/* SCALE (1 + A exp(B/cos Z)) (1 + C (exp(D chi) - OFF) + E cos^2 chi), or overcast SCALE (1 + 2 cos Z)/3; the radiance
 * of the ground below. */
struct sky {
    bool is_overcast;
    double a, b, c, d, e, off, scale, ground;
    vector up, sun;
};

static double luminance(const struct sky *sky, vector way)
{
    const double cosine = dot(way, sky->up);
    if (cosine <= 0)
        return sky->ground;
    if (sky->is_overcast)
        return sky->scale * (1 + 2 * cosine) / 3;
    const vector side = cross(way, sky->sun);
    const double chi = atan2(sqrt(dot(side, side)), dot(way, sky->sun)), near = cos(chi);
    const double round = 1 + sky->c * (exp(sky->d * chi) - sky->off) + sky->e * near * near;
    return sky->scale * (1 + sky->a * exp(sky->b / cosine)) * round;
}

/* What a pane lets through of unpolarized light, all reflections between its faces included: of a refractive index, of
 * which `left` is left at right angles, for the cosine of the angle to its normal. */
static double pane(double index, double left, double cosine)
{
    const double theta = acos(fmin(fabs(cosine), 1)), within = asin(sin(theta) / index);
    const double a = pow(left, 1 / cos(within));
    double both = 0;
    for (int k = 0; k < 2; k++) {
        double r = (index - 1) / (index + 1);
        if (theta > 1e-6)
            r = k ? tan(theta - within) / tan(theta + within) : sin(theta - within) / sin(theta + within);
        r *= r;
        both += (1 - r) * (1 - r) * a / (1 - r * r * a * a) / 2;
    }
    return both;
}

#endif
