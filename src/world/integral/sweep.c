/* SPDX-License-Identifier: MIT */
/* Cutting sources into sweeps, and the arcs of each kind. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../light/sky/luminance.h"
#include "sweep_make.h"

/* ---- vectors ---- */

double lx_sweep_normalize(double a[3])
{
    double length = hypot(hypot(a[0], a[1]), a[2]);
    for (int i = 0; i < 3 && length > 0; i++)
        a[i] /= length;
    return length;
}

struct lx_sweep_frame lx_sweep_frame_about(const double x[3], const double across[3])
{
    struct lx_sweep_frame frame;
    memcpy(frame.x, x, sizeof frame.x);
    lx_cross(x, across, frame.z);
    if (lx_sweep_normalize(frame.z) < 1e-6) {
        double other[3] = {0, 0, 0};
        other[fabs(x[0]) < 0.6 ? 0 : fabs(x[1]) < 0.6 ? 1 : 2] = 1;
        lx_cross(x, other, frame.z);
        lx_sweep_normalize(frame.z);
    }
    lx_cross(frame.z, x, frame.y);
    lx_sweep_normalize(frame.y);
    return frame;
}

int lx_sweeps_append(struct lx_sweeps *sweeps, const struct lx_sweep *sweep)
{
    if (lx_reserve(&sweeps->items, &sweeps->capacity, sweeps->count + 1, sizeof *sweep))
        return -1;
    sweeps->items[sweeps->count++] = *sweep;
    return 0;
}

/* ---- polygons ---- */

/* A corner in the plane of its face, as an offset from the source's centre: across and along the arcs. */
struct corner {
    double y, s;
};

/* Where the edge from a to b is at y, between its ends. */
static double edge_at(struct corner a, struct corner b, double y)
{
    return fabs(y - a.y) < fabs(y - b.y) ? a.s + (b.s - a.s) * ((y - a.y) / (b.y - a.y))
                                         : b.s + (a.s - b.s) * ((y - b.y) / (a.y - b.y));
}

/* The strip of a convex polygon between two values of y with no corner between them. */
static bool cut_strip(const struct corner *corners, unsigned count, struct lx_sweep *strip)
{
    double middle = strip->y1_mm + (strip->y2_mm - strip->y1_mm) / 2, at1[2], at2[2];
    unsigned found = 0;
    for (unsigned i = 0; i < count && found < 2; i++) {
        struct corner a = corners[i], b = corners[(i + 1) % count];
        if ((a.y <= middle) == (b.y <= middle))
            continue;
        at1[found] = edge_at(a, b, strip->y1_mm);
        at2[found++] = edge_at(a, b, strip->y2_mm);
    }
    if (found < 2)
        return false;
    bool swap = at1[0] + at2[0] > at1[1] + at2[1];
    strip->s1_mm = at1[swap];
    strip->s2_mm = at2[swap];
    strip->width1_mm = fmax(at1[!swap] - at1[swap], 0);
    strip->width2_mm = fmax(at2[!swap] - at2[swap], 0);
    return strip->width1_mm > 0 || strip->width2_mm > 0;
}

/*
 * The height of a place over a flat source, 0 where it sees nothing of it.  Openings are seen from their plane as well:
 * nothing of them depends on the angle under which they are seen, so a height too small for the sums may be replaced.
 */
static double height_over(const struct lx_emitter *emitter, double height, double distance)
{
    if (!lx_is_opening(emitter))
        return height > 0 ? height : 0;
    return height > 0 || (height == 0 && !emitter->is_back) ? fmax(height, LX_FLATTEST * distance) : 0;
}

/*
 * The way across the edge beyond the sun, of a patch of the sky that has the sun in a corner, where its radiance has
 * one, too.  Arcs along that edge make the integral over them a smooth function of how far they are from the sun.
 * False: the patch has none.
 */
static bool across_from_sun(const struct lx_emitter *emitter, const unsigned *loop, unsigned count,
                            const double place_mm[3], const double normal[3], double across[3])
{
    static const double SAME = 1e-6;
    const lx_wide3 place = lx_wide3_of(place_mm);
    for (unsigned i = 0; emitter->sky && i < count; i++) {
        double corner[3], edge[3];
        lx_wide3_values(lx_wide3_sub(emitter->facets->corners_mm[loop[i]], place), corner);
        if (!(lx_angle_between(corner, emitter->sky->sun) < SAME))
            continue;
        lx_wide3_values(lx_wide3_sub(emitter->facets->corners_mm[loop[(i + 2) % count]],
                                     emitter->facets->corners_mm[loop[(i + 1) % count]]),
                        edge);
        lx_cross(edge, normal, across);
        return lx_sweep_normalize(across) > 0;
    }
    return false;
}

static int sweep_face(const struct lx_emitter *emitter, const struct lx_face *face, const double place_mm[3],
                      const double across[3], struct lx_sweeps *sweeps)
{
    const struct lx_facets *facets = emitter->facets;
    const unsigned *loop = facets->loop + face->first;
    lx_wide3 place = lx_wide3_of(place_mm), center = lx_wide3_of(facets->center_mm);
    double height = lx_wide_value(lx_wide3_dot(face->normal, lx_wide3_sub(place, facets->corners_mm[loop[0]])));
    double normal[3], to_center[3];
    lx_wide3_values(lx_wide3_sub(center, place), to_center);
    height = height_over(emitter, height, facets->radius_mm + sqrt(lx_dot(to_center, to_center)));
    if (!(height > 0))
        return 0;
    lx_wide3_values(face->normal, normal);
    for (int i = 0; i < 3; i++)
        normal[i] = -normal[i];
    double from_sun[3];
    const bool is_aside = across_from_sun(emitter, loop, face->count, place_mm, normal, from_sun);
    struct lx_sweep strip = {.kind = LX_SWEEP_STRIP,
                             .frame = lx_sweep_frame_about(normal, is_aside ? from_sun : across),
                             .height_mm = height};
    strip.y_mm = lx_dot(strip.frame.y, to_center);
    strip.s_mm = lx_dot(strip.frame.z, to_center);

    struct corner *corners = lx_new_array(face->count, sizeof *corners);
    double *cuts = lx_new_array(face->count + 1, sizeof *cuts);
    int failed = corners && cuts ? 0 : -1;
    for (unsigned i = 0; i < face->count && !failed; i++) {
        double offset[3];
        lx_wide3_values(lx_wide3_sub(facets->corners_mm[loop[i]], center), offset);
        corners[i] = (struct corner){lx_dot(strip.frame.y, offset), lx_dot(strip.frame.z, offset)};
        cuts[i] = corners[i].y;
    }
    if (!failed) {
        cuts[face->count] = -strip.y_mm; /* the foot: arcs on both sides of it are kept apart */
        qsort(cuts, face->count + 1, sizeof *cuts, lx_by_value);
    }
    for (unsigned i = 0; i < face->count && !failed; i++) {
        strip.y1_mm = cuts[i];
        strip.y2_mm = cuts[i + 1];
        if (strip.y2_mm > strip.y1_mm && cut_strip(corners, face->count, &strip))
            failed = lx_sweeps_append(sweeps, &strip);
    }
    free(corners);
    free(cuts);
    return failed;
}

/* A line in a flat source's plane. */
struct line {
    double from_end; /* of the end of its range that is farther from the foot, in mm */
    double y;        /* from the foot, towards that end */
    double measure;  /* d beta/d share */
};

/*
 * Lines are chosen evenly in w, y = h sinh(w), which knows both lengths: the plane's distance h and the source's size.
 * d beta = dw/cosh(w).  `share` of the range is gone through between near and far (>= 0, from the foot); y is found
 * from the end where nothing cancels.
 */
static struct line line_at(double h, double near, double far, double span, double share)
{
    double to_near = hypot(h, near), to_far = hypot(h, far);
    double range = asinh(span * (far + near) / (far * to_near + near * to_far));
    double gone = share * range / 2, left = (1 - share) * range / 2;
    struct line line;
    if (left < 0.5) {
        line.from_end = fmin(2 * sinh(left) * (to_far * cosh(left) - far * sinh(left)), span);
        line.y = far - line.from_end;
    } else {
        line.y = near + 2 * sinh(gone) * (to_near * cosh(gone) + near * sinh(gone));
        line.from_end = far - line.y;
    }
    line.measure = range * (h / hypot(h, line.y));
    return line;
}

/* The arc of a flat source along a line that begins at s and is `width` long. */
static struct lx_arc flat_arc(const struct lx_sweep *flat, double y, double s, double width)
{
    double h = flat->height_mm, c = hypot(h, y);
    struct lx_arc arc = {
        .from = atan2(s, c),
        .width = atan2(c * width, c * c + s * (s + width)),
        .distance_mm = c,
    };
    for (int i = 0; i < 3; i++)
        arc.direction[i] = flat->frame.x[i] * (h / c) + flat->frame.y[i] * (y / c);
    return arc;
}

/* The chord of a strip at x: its line, where on it the strip begins, and for how long. */
struct chord {
    struct line line; /* y is counted upwards from the foot, on either side of it */
    double s, width;
};

static struct chord chord_at(const struct lx_sweep *strip, double x)
{
    double y1 = strip->y_mm + strip->y1_mm, y2 = strip->y_mm + strip->y2_mm, span = strip->y2_mm - strip->y1_mm;
    bool upwards = y1 + y2 > 0; /* the far end is y2 */
    struct line line = upwards ? line_at(strip->height_mm, fmax(y1, 0), y2, span, x)
                               : line_at(strip->height_mm, fmax(-y2, 0), -y1, span, 1 - x);
    double share = line.from_end / span, at1 = upwards ? share : 1 - share, at2 = upwards ? 1 - share : share;
    if (!upwards)
        line.y = -line.y;
    return (struct chord){.line = line,
                          .s = strip->s_mm + (at1 * strip->s1_mm + at2 * strip->s2_mm),
                          .width = at1 * strip->width1_mm + at2 * strip->width2_mm};
}

static struct lx_arc strip_arc(const struct lx_sweep *strip, double x)
{
    struct chord chord = chord_at(strip, x);
    struct lx_arc arc = flat_arc(strip, chord.line.y, chord.s, chord.width);
    arc.measure = chord.line.measure;
    return arc;
}

/* ---- disks and ellipses ---- */

/* The extent of an ellipse across the arcs, half the chord through its middle, and how the middles of chords move. */
static void set_ellipse(struct lx_sweep *disk, const struct lx_emitter *emitter)
{
    double first[3], second[3];
    disk->radius_mm = disk->half_mm = emitter->radius_mm;
    if (!lx_is_elliptic(emitter))
        return;
    lx_half_axes(emitter, first, second);
    const double y1 = lx_dot(first, disk->frame.y), y2 = lx_dot(second, disk->frame.y);
    const double z1 = lx_dot(first, disk->frame.z), z2 = lx_dot(second, disk->frame.z);
    disk->radius_mm = hypot(y1, y2);
    disk->half_mm = fabs(y1 * z2 - y2 * z1) / disk->radius_mm;
    disk->slope = (y1 * z1 + y2 * z2) / (disk->radius_mm * disk->radius_mm);
}

int lx_sweep_disk(const struct lx_emitter *emitter, const double center_mm[3], const double axis[3],
                  const double place_mm[3], const double across[3], struct lx_sweeps *sweeps)
{
    double inwards[3], to_center[3], height = 0;
    for (int i = 0; i < 3; i++) {
        inwards[i] = -axis[i];
        to_center[i] = center_mm[i] - place_mm[i];
        height += inwards[i] * to_center[i];
    }
    height = height_over(emitter, height, emitter->radius_mm + sqrt(lx_dot(to_center, to_center)));
    if (!(height > 0))
        return 0;
    struct lx_sweep disk = {.kind = LX_SWEEP_DISK, .frame = lx_sweep_frame_about(inwards, across), .height_mm = height};
    set_ellipse(&disk, emitter);
    disk.y_mm = lx_dot(disk.frame.y, to_center);
    disk.s_mm = lx_dot(disk.frame.z, to_center);
    double low = disk.y_mm - disk.radius_mm, high = disk.y_mm + disk.radius_mm;
    disk.y1_mm = low;
    disk.y2_mm = low < 0 && high > 0 ? 0 : high;
    if (lx_sweeps_append(sweeps, &disk))
        return -1;
    disk.y1_mm = disk.y2_mm;
    disk.y2_mm = high;
    return disk.y1_mm < high ? lx_sweeps_append(sweeps, &disk) : 0;
}

/* From rim to rim, or to the foot; as the square of a sine, for the chords' lengths go like roots at a rim. */
static struct lx_arc disk_arc(const struct lx_sweep *disk, double x)
{
    double y1 = disk->y1_mm, y2 = disk->y2_mm, root = sin(M_PI_2 * x), share = root * root;
    bool upwards = y1 + y2 > 0, whole = y1 > 0 || y2 < 0; /* whole: the foot lies outside */
    double span = whole ? 2 * disk->radius_mm : y2 - y1;
    struct line line = upwards ? line_at(disk->height_mm, fmax(y1, 0), y2, span, share)
                               : line_at(disk->height_mm, fmax(-y2, 0), -y1, span, 1 - share);
    const double half =
        sqrt(line.from_end * fmax(2 * disk->radius_mm - line.from_end, 0)) * (disk->half_mm / disk->radius_mm);
    const double y = upwards ? line.y : -line.y, middle = disk->s_mm + disk->slope * (y - disk->y_mm);
    struct lx_arc arc = flat_arc(disk, y, middle - half, 2 * half);
    arc.measure = line.measure * M_PI_2 * sin(M_PI * x);
    return arc;
}

/* ---- the kinds together ---- */

/*
 * The middles of a strip's chords stand on a line (y, s(y)) in its plane, and are nearest to the element where
 * y + s ds/dy = 0.
 */
double lx_sweep_approach(const struct lx_sweep *sweep, double x)
{
    const double OFTEN = 8; /* as far as it is away and long */
    if (sweep->kind != LX_SWEEP_STRIP)
        return 1;
    const double first = sweep->s1_mm + sweep->width1_mm / 2, travel = sweep->s2_mm + sweep->width2_mm / 2 - first;
    const double slope = travel / (sweep->y2_mm - sweep->y1_mm);
    const double at_foot = sweep->s_mm + first - slope * (sweep->y_mm + sweep->y1_mm);
    const double nearest = hypot(sweep->height_mm, at_foot / sqrt(1 + slope * slope));
    if (!(fabs(travel) > OFTEN * (nearest + fmax(sweep->width1_mm, sweep->width2_mm))))
        return 1;
    const struct chord chord = chord_at(sweep, x);
    return chord.line.y + slope * (chord.s + chord.width / 2);
}

/* Makes sweeps of both sides of bodies sweeps of the near one, and appends those of the far one. */
static int part_walls(struct lx_sweeps *sweeps)
{
    for (size_t i = 0, count = sweeps->count; i < count; i++) {
        struct lx_sweep far = sweeps->items[i];
        far.wall = LX_FAR_WALL;
        sweeps->items[i].wall = LX_NEAR_WALL;
        if (lx_sweeps_append(sweeps, &far))
            return -1;
    }
    return 0;
}

int lx_sweeps_make(const struct lx_emitter *emitter, const double place_mm[3], const double across[3], bool is_occluded,
                   struct lx_sweeps *sweeps)
{
    const struct lx_facets *facets = emitter->facets;
    if (facets) {
        for (size_t i = 0; i < facets->face_count; i++)
            if (sweep_face(emitter, &facets->faces[i], place_mm, across, sweeps))
                return -1;
        return 0;
    }
    if (!lx_has_axis(emitter)) {
        if (lx_is_elliptic(emitter) ? lx_sweep_ellipsoid(emitter, place_mm, across, sweeps)
                                    : lx_sweep_ball(emitter, place_mm, across, sweeps))
            return -1;
        return is_occluded && lx_is_opening(emitter) ? part_walls(sweeps) : 0;
    }
    if (lx_emitter_kind(emitter)->has_side)
        return lx_sweep_cylinder(emitter, place_mm, across, is_occluded, sweeps);
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    return lx_sweep_disk(emitter, emitter->center_mm, axis, place_mm, across, sweeps);
}

struct lx_arc lx_sweep_arc(const struct lx_sweep *sweep, double x)
{
    switch (sweep->kind) {
    case LX_SWEEP_STRIP: return strip_arc(sweep, x);
    case LX_SWEEP_DISK: return disk_arc(sweep, x);
    default: return lx_body_arc(sweep, x);
    }
}

double lx_sweep_distance(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau,
                         double *incidence)
{
    if (sweep->wall == LX_FAR_WALL) {
        double incidences[2];
        const double far = lx_sweep_far(sweep, arc, atan2(sin_tau, cos_tau), incidences);
        *incidence = incidences[1];
        return far;
    }
    if (lx_sweep_bulges(sweep))
        return lx_body_distance(sweep, arc, cos_tau, sin_tau, incidence);
    double distance = arc->distance_mm / cos_tau;
    *incidence = sweep->kind == LX_SWEEP_SIDE || sweep->kind == LX_SWEEP_TUBE ? arc->slant * cos_tau
                                                                              : sweep->height_mm / distance;
    return distance;
}

bool lx_sweep_find(const struct lx_sweep *sweep, const double towards[3], double *x)
{
    const double ahead = lx_dot(towards, sweep->frame.x), aside = lx_dot(towards, sweep->frame.y), h = sweep->height_mm;
    if (!(ahead > 0))
        return false;
    if (sweep->kind == LX_SWEEP_STRIP || sweep->kind == LX_SWEEP_DISK) {
        const bool is_strip = sweep->kind == LX_SWEEP_STRIP;
        const double shift = is_strip ? sweep->y_mm : 0, low = asinh((shift + sweep->y1_mm) / h);
        const double high = asinh((shift + sweep->y2_mm) / h), share = (asinh(aside / ahead) - low) / (high - low);
        const bool is_on = share > -LX_SAME_ARC && share < 1 + LX_SAME_ARC;
        *x = fmax(0, fmin(share, 1));
        if (!is_strip)
            *x = asin(sqrt(*x)) / M_PI_2;
        return is_on;
    }
    return lx_body_find(sweep, ahead, aside, x);
}
