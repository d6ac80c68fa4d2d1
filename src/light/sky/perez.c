/* SPDX-License-Identifier: MIT */
/* The table of the all-weather sky, and what follows from it. */
#include "perez.h"

#include <math.h>
#include <string.h>

/* What of the data the table was made from: clearness and brightness between these. */
static const double MOST_CLEAR = 12.1, LEAST_BRIGHT = 0.01, MOST_BRIGHT = 0.6;
/* The lines to which the erratum applies, and the least brightness in them. */
static const double FIRST_RAISED = 1.065, LAST_RAISED = 2.8, RAISED = 0.2;
/* The least that either factor of the luminance may be: below it the model is none of a sky. */
static const double LEAST_FACTOR = 0.05;

enum { LINES = 8, NUMBERS = 20 };
static const double line_ends[LINES - 1] = {1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2};

/* x1 to x4 of each of a, b, c, d, e: x = x1 + x2 Z + brightness (x3 + x4 Z). */
static const double table[LINES][NUMBERS] = {
    {1.3525, -0.2576, -0.269, -1.4366, -0.767, 0.0007, 1.2734, -0.1233, 2.8,     0.6004,
     1.2375, 1,       1.8734, 0.6297,  0.9738, 0.2809, 0.0356, -0.1246, -0.5718, 0.9938},
    {-1.2219, -0.773,  1.4148,  1.1016,  -0.2054, 0.0367, -3.9128, 0.9156, 6.975,  0.1774,
     6.4477,  -0.1239, -1.5798, -0.5081, -1.7812, 0.108,  0.2624,  0.0672, -0.219, -0.4285},
    {-1.1,  -0.2515, 0.8952, 0.0156, 0.2782, -0.1812, -4.5,    1.1766, 24.7219, -13.0812,
     -37.7, 34.8438, -5,     1.5218, 3.9229, -2.6204, -0.0156, 0.1597, 0.4199,  -0.5562},
    {-0.5484, -0.6654, -0.2672, 0.7117, 0.7234, -0.6219, -5.6812, 2.6297,  33.3389, -18.3,
     -62.25,  52.0781, -3.5,    0.0016, 1.1477, 0.1062,  0.4659,  -0.3296, -0.0876, -0.0329},
    {-0.6,     -0.3566, -2.5, 2.325,   0.2937, 0.0496, -5.6812, 1.8415, 21,      -4.7656,
     -21.5906, 7.2492,  -3.5, -0.1554, 1.4062, 0.3988, 0.0032,  0.0766, -0.0656, -0.1294},
    {-1.0156, -0.367, 1.0078, 1.4051,  0.2875, -0.5328, -3.85,   3.375,  14,     -0.9999,
     -7.1406, 7.5469, -3.4,   -0.1078, -1.075, 1.5702,  -0.0672, 0.4016, 0.3017, -0.4844},
    {-1,     0.0211,  0.5025, -0.5119, -0.3,   0.1922, 0.7023, -1.6317, 19,      -5,
     1.2438, -1.9094, -4,     0.025,   0.3844, 0.2656, 1.0468, -0.3788, -2.4517, 1.4656},
    {-1.05,    0.0289, 0.426,   0.359, -0.325, 0.1156, 0.7781, 0.0025,  31.0625, -14.5,
     -46.1148, 55.375, -7.2312, 0.405, 13.35,  0.6234, 1.5,    -0.6426, 1.8564,  0.5636},
};

/* Those of overcast skies, where c and d follow another law. */
static void find_first_line(const double *line, double zenith, double brightness, double coefficients[5])
{
    const double *c = line + 8, *d = line + 12;
    coefficients[2] = exp(pow(brightness * (c[0] + c[1] * zenith), c[2])) - c[3];
    coefficients[3] = -exp(brightness * (d[0] + d[1] * zenith)) + d[2] + brightness * d[3];
}

/* Whether both factors of the luminance are positive in all directions, and it has an end at the horizon. */
static bool is_sky(const double coefficients[5])
{
    enum { STEPS = 720 };
    if (!(coefficients[1] < 0) || 1 + coefficients[0] * exp(coefficients[1]) < LEAST_FACTOR)
        return false;
    for (int i = 0; i <= STEPS; i++) {
        const double chi = M_PI * i / STEPS;
        if (1 + coefficients[2] * exp(coefficients[3] * chi) + coefficients[4] * cos(chi) * cos(chi) < LEAST_FACTOR)
            return false;
    }
    return true;
}

bool lx_perez_find(const struct lx_weather *weather, struct lx_perez *perez)
{
    const double altitude = weather->altitude_deg, zenith = (90 - altitude) * (M_PI / 180);
    const double cube = 1.041 * zenith * zenith * zenith;
    const double mass = 1 / (sin(altitude * (M_PI / 180)) + 0.15 * pow(altitude + 3.885, -1.253));
    const double whole = weather->extraterrestrial / mass;
    *perez = (struct lx_perez){
        .clearness = ((weather->diffuse + weather->direct) / weather->diffuse + cube) / (1 + cube),
        .brightness = weather->diffuse / whole,
        .diffuse = {fmax(LEAST_BRIGHT * whole, weather->direct / ((MOST_CLEAR - 1) * (1 + cube))), MOST_BRIGHT * whole},
    };
    const double clearness = perez->clearness;
    double brightness = perez->brightness;
    if (!(clearness <= MOST_CLEAR) || !(brightness >= LEAST_BRIGHT && brightness <= MOST_BRIGHT))
        return false;
    if (clearness > FIRST_RAISED && clearness < LAST_RAISED)
        brightness = fmax(brightness, RAISED);
    int line = 0;
    while (line < LINES - 1 && clearness >= line_ends[line])
        line++;
    for (int i = 0; i < 5; i++) {
        const double *x = table[line] + 4 * i;
        perez->coefficients[i] = x[0] + x[1] * zenith + brightness * (x[2] + x[3] * zenith);
    }
    if (line == 0)
        find_first_line(table[0], zenith, brightness, perez->coefficients);
    return is_sky(perez->coefficients);
}
