/* SPDX-License-Identifier: MIT */
/* What the witness of daylight (sky_witness.c) has in its scene: bodies, holes, sources, and what rays meet of them. */
#ifndef LX_SKY_WITNESS_SCENE_H
#define LX_SKY_WITNESS_SCENE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "witness_sky.h"

enum { MOST = 4000, MOST_MARKS = 20000 };
static const double HERE_MM = 1e-7;

/* ---- what there is ---- */

enum kind { QUAD, TRI, DISK, BALL, TUBE, WALL, HOLE };

/* C is a corner of a tri, U and V lead to the others. */
struct body {
    enum kind kind;
    vector c, u, v;
    double half, radius, index, left;
};

enum source_kind { SKY, OVERCAST, SUN, PLATE, GLOBE, POINT, DISTANT };

struct source {
    enum source_kind kind;
    struct sky sky; /* of suns: its directions */
    vector at, u, v;
    double radius, value;
};

static struct body bodies[MOST];
static int body_count;
static struct source source;
static vector place, normal;

/* ---- rays ---- */

/* How far a plane is, and where it is met as shares of U and V; 0: it is not. */
static double meet_plane(vector c, vector u, vector v, vector way, double *s, double *t)
{
    const vector n = cross(u, v), from = add(c, place, -1);
    const double change = dot(n, way), size = sqrt(dot(n, n));
    if (fabs(change) < 1e-15 * size)
        return 0;
    const double away = dot(n, from) / change;
    const vector at = add(times(way, away), from, -1);
    *s = dot(cross(at, v), n) / (size * size);
    *t = dot(cross(u, at), n) / (size * size);
    return away;
}

/* What is left of light from a way, from no farther than `far` mm. */
static double left_of(vector way, double far)
{
    double left = 1;
    bool in_hole = false;
    for (int i = body_count - 1; i >= 0 && left > 0; i--) {
        const struct body *body = &bodies[i];
        const vector from = add(place, body->c, -1);
        double s = 0, t = 0, away = 0;
        bool hides = false;
        switch (body->kind) {
        case QUAD:
        case WALL:
            away = meet_plane(body->c, body->u, body->v, way, &s, &t);
            hides = away > HERE_MM && away < far && fabs(s) <= 1 && fabs(t) <= 1 && !in_hole;
            in_hole = false;
            break;
        case HOLE:
            away = meet_plane(body->c, body->u, body->v, way, &s, &t);
            if (fabs(s) > 1 || fabs(t) > 1)
                break;
            in_hole = true;
            if (away > HERE_MM && away < far && body->index > 0)
                left *= pane(body->index, body->left, dot(unit(cross(body->u, body->v)), way));
            break;
        case TRI:
            away = meet_plane(body->c, body->u, body->v, way, &s, &t);
            hides = away > HERE_MM && away < far && s >= 0 && t >= 0 && s + t <= 1;
            break;
        case DISK: {
            away = meet_plane(body->c, body->u, body->v, way, &s, &t);
            hides = away > HERE_MM && away < far && s * s + t * t <= 1;
            break;
        }
        case BALL: {
            const double b = dot(from, way);
            double c = dot(from, from) - body->radius * body->radius;
            if (fabs(c) < 1e-9 * body->radius * body->radius)
                c = 0;
            const double root = b * b - c;
            if (root <= 0)
                break;
            const double first = -b - sqrt(root), second = -b + sqrt(root);
            hides = (first > HERE_MM && first < far) || (second > HERE_MM && second < far);
            break;
        }
        case TUBE: {
            const vector axis = body->u;
            const vector p = add(from, axis, -dot(from, axis)), w = add(way, axis, -dot(way, axis));
            const double a = dot(w, w), b = dot(p, w);
            double c = dot(p, p) - body->radius * body->radius;
            if (fabs(c) < 1e-9 * body->radius * body->radius)
                c = 0;
            if (!(b * b > a * c) || a < 1e-30)
                break;
            for (int k = -1; k <= 1; k += 2) {
                const double share = (-b + k * sqrt(b * b - a * c)) / a;
                if (share > HERE_MM && share < far && fabs(dot(from, axis) + share * dot(way, axis)) <= body->half)
                    hides = true;
            }
            break;
        }
        }
        if (hides)
            left = 0;
    }
    return left;
}

/* ---- sources ---- */

/* The radiance that comes by a way. */
static double radiance(vector way)
{
    double s, t, away;
    switch (source.kind) {
    case SKY:
    case OVERCAST: return luminance(&source.sky, way) * left_of(way, HUGE_VAL);
    case SUN: return source.value * left_of(way, HUGE_VAL);
    case PLATE:
        away = meet_plane(source.at, source.u, source.v, way, &s, &t);
        if (!(away > HERE_MM) || fabs(s) > 1 || fabs(t) > 1 || dot(cross(source.u, source.v), way) > 0)
            return 0;
        return source.value * left_of(way, away);
    default: {
        const vector from = add(place, source.at, -1);
        const double b = dot(from, way), root = b * b - dot(from, from) + source.radius * source.radius;
        if (root <= 0 || -b - sqrt(root) <= 0)
            return 0;
        return source.value * left_of(way, -b - sqrt(root));
    }
    }
}

#endif
