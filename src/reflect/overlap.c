/* SPDX-License-Identifier: MIT */
/* Flat faces that lie on one another: outlines in one plane of which no line keeps one from the other. */
#include <math.h>

#include "../base/vector.h"
#include "overlap.h"

#include "reflected.h"

/* The outline of a window of a disk has the most corners: its arc is a few chords. */
enum { ARC = 5, MOST_CORNERS = ARC + 2 };

/* A convex polygon in the plane of its face. */
struct outline {
    double corners_mm[MOST_CORNERS][3];
    int count;
};

static void add_corner(struct outline *outline, const struct lx_matte_face *face, const struct lx_window *window,
                       double s, double t)
{
    double normal[3];
    lx_sheet_place(&face->sheet, window->middle[0] + s * window->half[0], window->middle[1] + t * window->half[1],
                   outline->corners_mm[outline->count++], normal);
}

static struct outline outline_of(const struct lx_matte_face *face, const struct lx_window *window)
{
    const int far = lx_is_polygon(face) ? 2 : ARC;
    struct outline outline = {.count = 0};
    add_corner(&outline, face, window, -1, -1);
    for (int i = 0; i < far; i++)
        add_corner(&outline, face, window, 2.0 * i / (far - 1) - 1, 1);
    add_corner(&outline, face, window, 1, -1);
    return outline;
}

static void span(const struct outline *outline, const double axis[3], double *low, double *high)
{
    *low = HUGE_VAL, *high = -HUGE_VAL;
    for (int i = 0; i < outline->count; i++) {
        const double at = lx_dot(axis, outline->corners_mm[i]);
        *low = fmin(*low, at);
        *high = fmax(*high, at);
    }
}

/* Whether a side of polygon a has all of b beyond it, or all but a depth. */
static bool has_between(const struct outline *a, const struct outline *b, const double normal[3], double depth_mm)
{
    for (int i = 0; i < a->count; i++) {
        const double *from = a->corners_mm[i], *to = a->corners_mm[(i + 1) % a->count];
        double side[3], axis[3], low[2], high[2];
        for (int k = 0; k < 3; k++)
            side[k] = to[k] - from[k];
        lx_cross(side, normal, axis);
        const double length = sqrt(lx_dot(axis, axis));
        span(a, axis, &low[0], &high[0]);
        span(b, axis, &low[1], &high[1]);
        if (length > 0 && fmin(high[0], high[1]) - fmax(low[0], low[1]) <= depth_mm * length)
            return true;
    }
    return false;
}

/* Whether face b lies on a window of face a. */
static bool lies_on(const struct lx_radiosity *reflected, const struct lx_matte_face *a, const struct lx_window *window,
                    const struct lx_matte_face *b)
{
    const struct lx_window whole = {{0, 0}, {1, 1}};
    const double least_mm = 1e-9 * reflected->size_mm, depth_mm = 1e-6 * fmin(a->radius_mm, b->radius_mm);
    double apart[3];
    for (int k = 0; k < 3; k++)
        apart[k] = a->center_mm[k] - b->center_mm[k];
    if (a == b || !a->is_flat || !b->is_flat ||
        a->sheet.turn * b->sheet.turn * lx_dot(a->sheet.axis, b->sheet.axis) <= 0 ||
        sqrt(lx_dot(apart, apart)) >= a->radius_mm + b->radius_mm)
        return false;
    const struct outline lower = outline_of(a, window), upper = outline_of(b, &whole);
    const double plane = lx_dot(a->sheet.axis, a->sheet.center_mm);
    double low, high;
    span(&upper, a->sheet.axis, &low, &high);
    return fmax(fabs(low - plane), fabs(high - plane)) <= least_mm &&
           !has_between(&lower, &upper, a->sheet.axis, depth_mm) &&
           !has_between(&upper, &lower, a->sheet.axis, depth_mm);
}

void lx_overlap_find(struct lx_radiosity *reflected)
{
    const struct lx_window whole = {{0, 0}, {1, 1}};
    struct lx_matte_face *faces = reflected->faces;
    for (size_t f = 0; f < reflected->face_count; f++)
        faces[f].is_overlaid = false;
    for (size_t f = 0; f < reflected->face_count; f++)
        for (size_t g = 0; g < f; g++)
            if ((!faces[f].is_overlaid || !faces[g].is_overlaid) && lies_on(reflected, &faces[f], &whole, &faces[g]))
                faces[f].is_overlaid = faces[g].is_overlaid = true;
}

const struct lx_matte_face *lx_overlap_on(const struct lx_radiosity *reflected, const struct lx_tile *tile)
{
    const struct lx_matte_face *face = &reflected->faces[tile->face];
    for (size_t f = 0; f < reflected->face_count && face->is_overlaid; f++)
        if (reflected->faces[f].is_overlaid && lies_on(reflected, face, &tile->window, &reflected->faces[f]))
            return &reflected->faces[f];
    return NULL;
}

/* The greatest irradiance at the nodes of a tile. */
static double brightest(const struct lx_radiosity *reflected, size_t t)
{
    double most = 0;
    for (size_t q = 0; q < LX_RULE_NODES; q++)
        most = fmax(most, reflected->tiles[t].direct.nodes[q] + reflected->indirect[t * LX_RULE_NODES + q]);
    return most;
}

bool lx_reflected_overlaps(const struct lx_radiosity *reflected, size_t surfaces[2])
{
    const double least = 1e-3 * reflected->error; /* of the greatest anywhere */
    double greatest = 0;
    for (size_t t = 0; t < reflected->tile_count; t++)
        greatest = fmax(greatest, brightest(reflected, t));
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const bool has_light = tile->is_overlaid && brightest(reflected, t) > least * greatest;
        const struct lx_matte_face *on = has_light ? lx_overlap_on(reflected, tile) : NULL;
        if (!on)
            continue;
        surfaces[0] = reflected->faces[tile->face].surface;
        surfaces[1] = on->surface;
        return true;
    }
    return false;
}
