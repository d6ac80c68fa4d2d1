/* SPDX-License-Identifier: MIT */
/*
 * The light of facets in closed form.
 *
 * From an element only those faces are seen before whose planes it stands.  Their sum is the area of the contours
 * between faces that are seen and faces that are not (facets_contour.h): the silhouette of a polyhedron, or the whole
 * outline of a polygon.  The faces' own edges inside cancel.
 *
 * All is computed at the float64 place P and normal N of the element, as wide numbers.  What the bounds dP and dN of
 * P and N change comes on top.  E is the integral over the solid angle of max(0, N.L), hence
 *
 *     |dE| <= Omega |dN|.
 *
 * As an integral over the surface, E = integral of (N.r)+ (-n.r)+/|r|^4 dA, whose gradient by P is at most
 * ((-n.r) + (N.r))/|r|^4 + 4 (N.r) (-n.r)/|r|^5.  With dw = (-n.r)/|r|^3 dA and d the least distance,
 *
 *     |dE| <= |dP| (5 Omega/d + integral of dA/|r|^3),     integral of dA/|r|^3 <= min(A/d^3, 12 pi/d),
 *
 * the latter because a convex surface has at most the area 4 pi r^2 within the distance r: by parts,
 * integral of 3 A(r)/r^4 dr from d on.  Omega is at most min(2 pi, A/d^2).  A face in whose plane P stands but for
 * rounding is not seen; the rounding is added to dP.
 *
 * A corner that moves by k, as those do that are rounded, moves the edges to it: E changes by the solid angle that
 * they sweep.
 */
#include "facets.h"
#include "facets_contour.h"
#include "facets_plain.h"

/* Bounds what a height over a face, a distance, a rounded corner are wrong by, relative to what they are made of. */
static const double ROUNDING = 0x1p-92;

/* A bit more, for bounds that are computed in float64. */
static const double MORE = 1 + 0x1p-40;

/* A sum that is good to this is good enough; areas above SMALL go for some of all sides of the element. */
static const double ENOUGH = 0x1p-50, SMALL = 0.5;

/* An area in float64 that is as good as this needs no wide numbers. */
static const double PLAIN = 0x1p-43;

/* Bounds the area of what is above the horizon but for rounding, a square of roundings. */
static const double UNSEEN = 0x1p-180;

struct view {
    const struct lx_facets *facets;
    double place_mm[3];
    lx_wide3 place;
    double place_error_mm; /* |dP| */
    double doubt_mm;       /* what P would have to be moved by so that the faces said to be seen are the right ones */
    bool seen;             /* at least one face is */
    bool may_be_seen;      /* or would be, for some P within its bound */
};

static double length3(double x, double y, double z)
{
    return hypot(hypot(x, y), z) * MORE;
}

static double size(lx_wide3 a)
{
    return hypot(hypot(a.x.high, a.y.high), a.z.high);
}

static const lx_wide3 *corner_of(const struct lx_facets *facets, const struct lx_face *face, unsigned k)
{
    return &facets->corners_mm[facets->loop[face->first + k]];
}

static struct view view_from(const struct lx_facets *facets, lx_bounded3 place_mm)
{
    struct view view = {.facets = facets, .place_mm = {place_mm.x.value, place_mm.y.value, place_mm.z.value}};
    view.place = lx_wide3_of(view.place_mm);
    view.place_error_mm = length3(place_mm.x.error, place_mm.y.error, place_mm.z.error);
    return view;
}

/* ---- heights over faces ---- */

/* What the face's normal is wrong by, as far as that comes from its being narrow. */
static double narrowness(const struct lx_facets *facets, const struct lx_face *face)
{
    double around = 0;
    for (unsigned k = 0; k < face->count; k++)
        around += size(lx_wide3_sub(*corner_of(facets, face, (k + 1) % face->count), *corner_of(facets, face, k)));
    return fmax(1, around * around / face->area_mm2);
}

/* Along an axis a height is one difference, whose sign is right. */
static bool is_along_axis(double x, double y, double z)
{
    return (x == 0) + (y == 0) + (z == 0) == 2;
}

/* How high P is over a face, or 0 where that is all rounding; *error bounds the rounding. */
static double exact_height(const struct view *view, const struct lx_face *face, double *error)
{
    const lx_wide3 *corner = corner_of(view->facets, face, 0);
    lx_wide3 way = lx_wide3_sub(view->place, *corner);
    double height = lx_wide3_dot(face->normal, way).high;
    *error = ROUNDING * size(way) * narrowness(view->facets, face) + 2 * view->facets->corner_error_mm;
    if (is_along_axis(face->normal.x.high, face->normal.y.high, face->normal.z.high))
        *error = 0;
    return fabs(height) <= *error ? 0 : height;
}

/* The height in float64 where that will do. */
static double height_over(const struct view *view, const struct lx_face *face, double *error)
{
    const lx_wide3 *corner = corner_of(view->facets, face, 0);
    double x = view->place_mm[0] - corner->x.high, y = view->place_mm[1] - corner->y.high;
    double z = view->place_mm[2] - corner->z.high;
    double height = face->normal.x.high * x + face->normal.y.high * y + face->normal.z.high * z;
    double parts = fabs(x) + fabs(y) + fabs(z) + fabs(corner->x.high) + fabs(corner->y.high) + fabs(corner->z.high);
    *error = 8 * DBL_EPSILON * parts;
    return fabs(height) > *error ? height : exact_height(view, face, error);
}

static bool is_seen(const struct view *view, int face)
{
    double error;
    return face != LX_NO_FACE && height_over(view, &view->facets->faces[face], &error) > 0;
}

static void survey(struct view *view)
{
    for (size_t i = 0; i < view->facets->face_count; i++) {
        double error, height = height_over(view, &view->facets->faces[i], &error);
        view->seen |= height > 0;
        view->may_be_seen |= height + error + view->place_error_mm > 0;
        if (height == 0)
            view->doubt_mm = fmax(view->doubt_mm, error);
    }
}

/* ---- distances ---- */

/* The distance from P to the edge between two corners, given by the ways to them. */
static double edge_distance(lx_wide3 a, lx_wide3 b)
{
    lx_wide3 e = lx_wide3_sub(b, a);
    double along = -lx_wide3_dot(a, e).high, length2 = lx_wide3_dot(e, e).high;
    if (along <= 0)
        return size(a);
    if (along >= length2)
        return size(b);
    return size(lx_wide3_cross(a, e)) / sqrt(length2);
}

static double face_distance(const struct view *view, const struct lx_face *face)
{
    const struct lx_facets *facets = view->facets;
    lx_wide3 before = lx_wide3_sub(*corner_of(facets, face, face->count - 1), view->place);
    double height = fabs(lx_wide3_dot(face->normal, before).high), nearest = HUGE_VAL;
    bool above = true; /* the foot of P lies in the face */
    for (unsigned k = 0; k < face->count; k++) {
        lx_wide3 next = lx_wide3_sub(*corner_of(facets, face, k), view->place), e = lx_wide3_sub(next, before);
        /* Its way is to the left of the edge, and the foot with it, where a x e points along the normal. */
        above &= lx_wide3_dot(face->normal, lx_wide3_cross(before, e)).high >= 0;
        nearest = fmin(nearest, edge_distance(before, next));
        before = next;
    }
    return above ? height : nearest;
}

static double center_distance(const struct view *view)
{
    const double *center = view->facets->center_mm;
    return hypot(hypot(view->place_mm[0] - center[0], view->place_mm[1] - center[1]), view->place_mm[2] - center[2]);
}

/* What a distance may be wrong by. */
static double distance_rounding(const struct view *view)
{
    const struct lx_facets *facets = view->facets;
    const double *center = facets->center_mm;
    double away = fabs(center[0]) + fabs(center[1]) + fabs(center[2]);
    return 16 * ROUNDING * (away + facets->radius_mm + center_distance(view));
}

/* A bound from below of the distance of P from the faces that are, or might be, seen. */
static double least_distance(const struct view *view)
{
    const struct lx_facets *facets = view->facets;
    double outside = center_distance(view) * (1 - 0x1p-40) - facets->radius_mm, nearest = HUGE_VAL;
    if (outside > facets->radius_mm)
        return outside;
    for (size_t i = 0; i < facets->face_count; i++) {
        double error, height = height_over(view, &facets->faces[i], &error);
        if (height + error + view->place_error_mm > 0 && height < nearest)
            nearest = fmin(nearest, face_distance(view, &facets->faces[i]));
    }
    return nearest * (1 - 0x1p-40) - distance_rounding(view);
}

bool lx_facets_touch(const struct lx_facets *facets, lx_bounded3 place_mm)
{
    struct view view = view_from(facets, place_mm);
    double within = view.place_error_mm + distance_rounding(&view);
    if (center_distance(&view) * (1 - 0x1p-40) > facets->radius_mm + within)
        return false;
    for (size_t i = 0; i < facets->face_count; i++) {
        double error, height = height_over(&view, &facets->faces[i], &error);
        if (fabs(height) - error <= within && face_distance(&view, &facets->faces[i]) * (1 - 0x1p-40) <= within)
            return true;
    }
    return false;
}

/* ---- the horizon ---- */

/* Whether a corner is not above the horizon, whatever P and N within their bounds. */
static bool is_below(const struct view *view, const lx_wide3 *corner, const double n[3], double normal_error)
{
    double x = corner->x.high - view->place_mm[0], y = corner->y.high - view->place_mm[1];
    double z = corner->z.high - view->place_mm[2], away = fabs(x) + fabs(y) + fabs(z);
    double parts = away + fabs(corner->x.high) + fabs(corner->y.high) + fabs(corner->z.high);
    double error = 16 * DBL_EPSILON * parts + normal_error * away + 2 * view->place_error_mm;
    if (n[0] * x + n[1] * y + n[2] * z + error < 0)
        return true;
    if (normal_error > 0 || view->place_error_mm > 0 || !is_along_axis(n[0], n[1], n[2]))
        return false;
    return !(lx_wide3_dot(lx_wide3_of(n), lx_wide3_sub(*corner, view->place)).high > 0);
}

static bool is_set(const struct view *view, const double normal[3], double normal_error)
{
    const struct lx_facets *facets = view->facets;
    size_t i = 0;
    while (i < facets->corner_count && is_below(view, &facets->corners_mm[i], normal, normal_error))
        i++;
    return i == facets->corner_count;
}

/* ---- the contour ---- */

/* 1 where the contour runs along the edge, -1 where against it, 0 where the edge is no part of it. */
static int weight_of(const struct view *view, const struct lx_edge *edge)
{
    return is_seen(view, edge->left) - is_seen(view, edge->right);
}

/* Looks for a corner of the contour above the horizon.  As many edges begin as end in a corner: the first will do. */
static bool find_base(const struct view *view, struct lx_contour *contour)
{
    const struct lx_facets *facets = view->facets;
    for (size_t i = 0; i < facets->edge_count; i++) {
        const struct lx_edge *edge = &facets->edges[i];
        int weight = weight_of(view, edge);
        unsigned first = weight > 0 ? edge->to : edge->from;
        if (weight && lx_contour_height(contour, first).high >= 0) {
            lx_contour_set_base(contour, first);
            return true;
        }
    }
    return false;
}

/* The way of the contour along an edge; false: the edge is no part of it. */
static bool follow_edge(const struct view *view, const struct lx_edge *edge, unsigned *from, unsigned *to)
{
    const int weight = weight_of(view, edge);
    /* As the element sees it a face's loop runs clockwise about the normal. */
    *from = weight > 0 ? edge->to : edge->from;
    *to = weight > 0 ? edge->from : edge->to;
    return weight != 0;
}

/* Adds the edges to the contour, or, where `low` is given, to that. */
static void add_edges(const struct view *view, struct lx_contour *contour, struct lx_low_area *low)
{
    const struct lx_facets *facets = view->facets;
    for (size_t i = 0; i < facets->edge_count; i++) {
        unsigned from, to;
        if (!follow_edge(view, &facets->edges[i], &from, &to))
            continue;
        if (low)
            lx_contour_add_low(contour, from, to, low);
        else
            lx_contour_add(contour, from, to, facets->corner_error_mm);
    }
}

/* The area within the contour by float64; an infinite bound where it does not lead to it. */
static lx_bounded plain_area(const struct view *view, const double normal[3], double scale)
{
    const struct lx_facets *facets = view->facets;
    struct lx_plain_contour contour = lx_plain_start(facets, view->place_mm, normal, scale);
    for (size_t i = 0; i < facets->edge_count && contour.sum.error < HUGE_VAL; i++) {
        unsigned from, to;
        if (follow_edge(view, &facets->edges[i], &from, &to))
            lx_plain_add(&contour, from, to);
    }
    return lx_scale(contour.sum, 0.5);
}

/* The area within the contour; what it cancels to is found in another way where it is low above the horizon. */
static double area_of(const struct view *view, struct lx_contour *contour, double *error)
{
    add_edges(view, contour, NULL);
    double area = fmax(0, lx_wide_value(lx_wide_scale(contour->sum, 0.5)));
    *error = contour->error + contour->corners_error;
    if (contour->error <= ENOUGH * area || !(area + *error < SMALL))
        return area;
    struct lx_low_area low = {.error = contour->corners_error};
    add_edges(view, contour, &low);
    if (low.failed || !(low.error < *error))
        return area;
    *error = low.error;
    return fmax(0, lx_wide_value(lx_wide_scale(low.sum, 0.5)));
}

/* What the bounds of place and normal, and roundings, change. */
static double inherited_error(const struct view *view, double distance_mm, double normal_error)
{
    double shift = view->place_error_mm + view->doubt_mm, d = distance_mm - shift, area = view->facets->area_mm2;
    if (shift == 0 && normal_error == 0)
        return 0;
    if (!(d > 0))
        return HUGE_VAL;
    double omega = fmin(2 * M_PI, area / d / d);
    double slope = 5 * omega / d + fmin(area / d / d / d, 12 * M_PI / d);
    return (omega * normal_error + shift * slope) * MORE;
}

lx_bounded lx_facets_irradiance(const struct lx_facets *facets, lx_bounded3 place_mm, lx_bounded3 normal)
{
    struct view view = view_from(facets, place_mm);
    const double n[3] = {normal.x.value, normal.y.value, normal.z.value};
    double normal_error = length3(normal.x.error, normal.y.error, normal.z.error);
    survey(&view);
    if (!view.may_be_seen || is_set(&view, n, normal_error))
        return lx_exact(0);

    double distance = least_distance(&view), value = 0;
    double error = inherited_error(&view, distance, normal_error);
    if (view.seen) {
        double scale = ldexp(1, -ilogb(fmax(center_distance(&view), facets->radius_mm)));
        struct lx_contour contour =
            lx_contour_start(facets->corners_mm, view.place, lx_wide3_of(n), scale, fmax(distance, 0));
        const lx_bounded plain = plain_area(&view, n, scale);
        double left = 0;
        if (plain.error <= PLAIN * plain.value)
            value = plain.value, left = plain.error;
        else if (find_base(&view, &contour))
            value = area_of(&view, &contour, &left);
        error += left + LX_ROUNDING * value;
        error += UNSEEN;
    }
    double most = M_PI * (1 + normal_error) * MORE;
    error *= MORE;
    return (lx_bounded){value, error < fmax(value, most - value) ? error : fmax(value, most - value)};
}
