/* SPDX-License-Identifier: MIT */
/*
 * Crowds of plates and balls over a plane, and what is left of it outside their shadows, by means that share nothing
 * with the library: a union of rectangles cut into cells, and of intervals on many lines.
 */
#ifndef FLUX_CROWD_H
#define FLUX_CROWD_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { CROWD = 40, CROWD_SIZE = 500, CROWD_TEXT = 16384 };

enum crowd_kind {
    CROWD_FLAT, /* plates along the plane and its sides */
    CROWD_MIXED /* balls and plates that lean */
};

static const double CROWD_LAMP[3] = {10, 20, 900};

struct member {
    double center[3], radius; /* 0: a plate */
    double size[2], lean;     /* about the y axis */
};

struct crowd {
    struct member members[CROWD];
    char text[CROWD_TEXT]; /* as surfaces of a scene */
};

static double crowd_number(uint64_t *seed, double from, double to)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * (double)(*seed >> 11) / 9007199254740992.0;
}

static struct crowd make_crowd(enum crowd_kind kind, uint64_t seed)
{
    struct crowd crowd;
    size_t length = 0;
    for (int i = 0; i < CROWD; i++) {
        struct member *one = &crowd.members[i];
        *one = (struct member){
            .center = {crowd_number(&seed, -220, 220), crowd_number(&seed, -220, 220), crowd_number(&seed, 60, 300)},
            .size = {crowd_number(&seed, 20, 60), crowd_number(&seed, 20, 60)}};
        if (kind == CROWD_MIXED && i % 2)
            one->radius = crowd_number(&seed, 8, 30);
        else if (kind == CROWD_MIXED)
            one->lean = crowd_number(&seed, -0.8, 0.8);
        const double *c = one->center;
        size_t room = sizeof crowd.text - length;
        length += (size_t)(one->radius > 0
                               ? snprintf(crowd.text + length, room,
                                          "%s{type: sphere, center: [%.17g, %.17g, %.17g], radius: %.17g}",
                                          i > 0 ? ", " : "", c[0], c[1], c[2], one->radius)
                               : snprintf(crowd.text + length, room,
                                          "%s{type: rectangle, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g], "
                                          "axis: [%.17g, 0, %.17g]}",
                                          i > 0 ? ", " : "", c[0], c[1], c[2], one->size[0], one->size[1],
                                          sin(one->lean), cos(one->lean)));
    }
    return crowd;
}

static int crowd_order(const void *left, const void *right)
{
    const double *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

/* The solid angle of a rectangle in z = 0 as the lamp sees it, its corners from the foot of the lamp. */
static double crowd_angle(double x0, double x1, double y0, double y1)
{
    const double h = CROWD_LAMP[2], x[2] = {x0, x1}, y[2] = {y0, y1};
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        const double a = x[i & 1] - CROWD_LAMP[0], b = y[i >> 1] - CROWD_LAMP[1];
        sum += (i == 0 || i == 3 ? 1 : -1) * atan2(a * b, h * sqrt(a * a + b * b + h * h));
    }
    return sum;
}

/* The solid angle, as the lamp sees it, of what the shadows of plates along the plane leave of that. */
static double open_solid_angle(const struct crowd *crowd)
{
    const double half = CROWD_SIZE / 2.0;
    double shadows[CROWD][4], cuts[2][2 * CROWD + 2], sum = 0;
    for (int i = 0; i < CROWD; i++) {
        const struct member *one = &crowd->members[i];
        const double grow = CROWD_LAMP[2] / (CROWD_LAMP[2] - one->center[2]);
        for (int side = 0; side < 4; side++) { /* low and high x, low and high y */
            const int k = side / 2;
            const double edge = one->center[k] + (side % 2 ? 0.5 : -0.5) * one->size[k];
            const double at = CROWD_LAMP[k] + grow * (edge - CROWD_LAMP[k]);
            shadows[i][side] = cuts[k][2 * i + side % 2] = fmax(-half, fmin(half, at));
        }
    }
    for (int k = 0; k < 2; k++) {
        cuts[k][2 * CROWD] = -half;
        cuts[k][2 * CROWD + 1] = half;
        qsort(cuts[k], 2 * CROWD + 2, sizeof(double), crowd_order);
    }
    for (int i = 0; i <= 2 * CROWD; i++)
        for (int k = 0; k <= 2 * CROWD; k++) {
            const double x = (cuts[0][i] + cuts[0][i + 1]) / 2, y = (cuts[1][k] + cuts[1][k + 1]) / 2;
            int s = 0;
            while (s < CROWD && !(x > shadows[s][0] && x < shadows[s][1] && y > shadows[s][2] && y < shadows[s][3]))
                s++;
            if (s == CROWD)
                sum += crowd_angle(cuts[0][i], cuts[0][i + 1], cuts[1][k], cuts[1][k + 1]);
        }
    return sum;
}

/* The part of the line y that shadows leave, under light along -z. */
static double open_length(const struct crowd *crowd, double y)
{
    const double half = CROWD_SIZE / 2.0;
    double dark[CROWD][2], reached = -half, open = 0;
    int count = 0;
    for (int i = 0; i < CROWD; i++) {
        const struct member *one = &crowd->members[i];
        const double off = fabs(y - one->center[1]);
        double reach = one->radius > 0          ? sqrt(fmax(0, one->radius * one->radius - off * off))
                       : off < one->size[1] / 2 ? one->size[0] / 2 * cos(one->lean)
                                                : 0;
        if (reach > 0) {
            dark[count][0] = one->center[0] - reach;
            dark[count++][1] = one->center[0] + reach;
        }
    }
    qsort(dark, (size_t)count, sizeof *dark, crowd_order);
    for (int i = 0; i < count; i++) {
        open += fmax(0, fmin(dark[i][0], half) - reached);
        reached = fmax(reached, fmin(dark[i][1], half));
    }
    return open + half - reached;
}

/* The area that the shadows leave of the plane under light along -z, in mm^2. */
static double open_area(const struct crowd *crowd)
{
    enum { LINES = 400000 };
    double sum = 0;
    for (int i = 0; i < LINES; i++)
        sum += open_length(crowd, CROWD_SIZE * ((i + 0.5) / LINES - 0.5));
    return sum * CROWD_SIZE / LINES;
}

#endif
