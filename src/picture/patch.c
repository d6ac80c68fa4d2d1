/* SPDX-License-Identifier: MIT */
/* Patches of area lights, their cells, and samples of them. */
#include <math.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "patch.h"

/* Faces between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

/* Cells that are so many times as long one way as the other are cut across the longer one alone. */
static const double LONG = 2;

/* From what is so many times as large as its distance some of it is seen at so many times the size of the rest, and
 * cells have to fit that. */
static const double NEAR = 2;

/* ---- vectors ---- */

/* ---- patches ---- */

/* Two unit vectors across a third. */
static void make_frame(const double n[3], double a[3], double b[3])
{
    double other[3] = {0, 0, 0};
    other[fabs(n[0]) > 0.5 ? 1 : 0] = 1;
    lx_cross(n, other, b);
    double scale = 1 / sqrt(lx_dot(b, b));
    for (int i = 0; i < 3; i++)
        b[i] *= scale;
    lx_cross(b, n, a);
}

size_t lx_patch_limit(const struct lx_area_light *lamp)
{
    return lamp->facets ? lamp->most_patches : LX_MOST_ROUND_PATCHES;
}

static void set_areas(struct lx_patch *patch)
{
    double whole[3], by_s[3], by_t[3];
    lx_cross(patch->a, patch->b, whole);
    lx_cross(patch->a, patch->g, by_s);
    lx_cross(patch->g, patch->b, by_t);
    patch->area[0] = lx_dot(patch->n, whole), patch->area[1] = lx_dot(patch->n, by_s),
    patch->area[2] = lx_dot(patch->n, by_t);
}

/* A face as quadrilaterals that share its first corner, the last one maybe a triangle. */
static size_t cut_face(const struct lx_area_light *lamp, size_t face_index, struct lx_patch *patches)
{
    const struct lx_facets *facets = lamp->facets;
    const struct lx_face *face = &facets->faces[face_index];
    const unsigned *loop = facets->loop + face->first;
    lx_wide3 center = lx_wide3_of(facets->center_mm), first = facets->corners_mm[loop[0]];
    size_t count = 0;
    for (unsigned k = 1; k + 1 < face->count; k += 2) {
        struct lx_patch *patch = &patches[count++];
        bool is_triangle = k + 2 == face->count;
        *patch = (struct lx_patch){.kind = LX_PATCH_FLAT};
        memcpy(patch->n, lamp->faces_double[face_index].normal, sizeof patch->n);
        lx_wide3_values(lx_wide3_sub(first, center), patch->o);
        lx_wide3 a = lx_wide3_sub(facets->corners_mm[loop[k]], first);
        lx_wide3 c = lx_wide3_sub(facets->corners_mm[loop[k + 1]], first);
        lx_wide3 b = is_triangle ? lx_wide3_sub(first, first) : lx_wide3_sub(facets->corners_mm[loop[k + 2]], first);
        lx_wide3_values(a, patch->a);
        lx_wide3_values(b, patch->b);
        lx_wide3_values(lx_wide3_sub(lx_wide3_sub(c, a), b), patch->g);
        for (int i = 0; i < 3; i++)
            patch->o[i] += lamp->center[i];
        set_areas(patch);
    }
    return count;
}

static size_t facet_patches(const struct lx_area_light *lamp, const struct lx_around *around,
                            const struct lx_asking *asking, struct lx_patch *patches)
{
    size_t count = 0;
    for (size_t i = 0; i < lamp->face_count && lx_asking_at_step(asking, i, BETWEEN_CHECKS); i++) {
        const struct lx_area_light_face_double *face = &lamp->faces_double[i];
        double above = -face->height;
        for (int k = 0; k < 3; k++)
            above += face->normal[k] * (around->center[k] - lamp->center[k]);
        if (above + around->radius > lamp->touch_mm)
            count += cut_face(lamp, i, patches + count);
    }
    return count;
}

static size_t disk_patch(const struct lx_area_light *lamp, const struct lx_around *around, double side,
                         struct lx_patch *patch)
{
    double above = around->radius;
    *patch = (struct lx_patch){.kind = LX_PATCH_DISK, .radius = lamp->round_mm};
    for (int i = 0; i < 3; i++) {
        patch->n[i] = (side < 0 ? -1 : 1) * lamp->axis[i];
        patch->o[i] = lamp->center[i] + side * lamp->half_mm * lamp->axis[i];
        above += patch->n[i] * (around->center[i] - patch->o[i]);
    }
    make_frame(patch->n, patch->a, patch->b);
    return above > lamp->touch_mm;
}

static size_t ball_patch(const struct lx_area_light *lamp, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_BALL, .radius = lamp->round_mm};
    double towards[3];
    for (int i = 0; i < 3; i++) {
        patch->o[i] = lamp->center[i];
        towards[i] = around->center[i] - lamp->center[i];
    }
    double distance = sqrt(lx_dot(towards, towards));
    for (int i = 0; i < 3; i++)
        towards[i] = distance > 0 ? towards[i] / distance : i == 0;
    make_frame(towards, patch->a, patch->b);
    return distance + around->radius > patch->radius;
}

static size_t side_patch(const struct lx_area_light *lamp, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_SIDE, .radius = lamp->round_mm, .length = 2 * lamp->half_mm};
    double offset[3], across[3];
    for (int i = 0; i < 3; i++) {
        patch->o[i] = lamp->center[i];
        patch->n[i] = lamp->axis[i];
        offset[i] = around->center[i] - lamp->center[i];
    }
    lx_cross(offset, patch->n, across);
    const double farthest = sqrt(lx_dot(across, across)) + around->radius;
    if (!(farthest > patch->radius))
        return 0;
    patch->breadth = 4 * patch->radius * atan(sqrt((farthest - patch->radius) / (farthest + patch->radius)));
    return 1;
}

/* ---- cells ---- */

static void flat_place(const struct lx_patch *patch, double s, double t, double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = patch->o[i] + s * patch->a[i] + t * patch->b[i] + s * t * patch->g[i];
}

/* n.((a + t g) x (b + s g)), the area for a unit of s and t. */
static double flat_area(const struct lx_patch *patch, double s, double t)
{
    return lx_larger(patch->area[0] + s * patch->area[1] + t * patch->area[2], 0);
}

/* The place on a ball or side at s, t for an element, as kernel_samples.h has it; returns the element's T. */
static double round_place(const struct lx_patch *patch, double s, double t, const double element[3], double place[3])
{
    bool is_side = patch->kind == LX_PATCH_SIDE;
    double n[3], a[3], b[3];
    for (int i = 0; i < 3; i++)
        n[i] = element[i] - patch->o[i];
    double along = is_side ? lx_dot(n, patch->n) : 0;
    for (int i = 0; i < 3; i++)
        n[i] -= along * patch->n[i];
    double distance = lx_larger(sqrt(lx_dot(n, n)), patch->radius * 1e-15), slant = lx_dot(n, patch->a) / distance;
    for (int i = 0; i < 3; i++) {
        n[i] /= distance;
        a[i] = is_side ? patch->n[i] : patch->a[i] - slant * n[i];
    }
    double length = lx_larger(sqrt(lx_dot(a, a)), 1e-15);
    for (int i = 0; i < 3; i++)
        a[i] /= length;
    lx_cross(n, a, b);
    double above = lx_larger(distance - patch->radius, 0), share = is_side ? 2 * t - 1 : s;
    double whole = sqrt(above / (distance + patch->radius)), tangent = share * whole;
    double inverse = 1 / (1 + tangent * tangent);
    double cosine = (1 - tangent * tangent) * inverse, sine = 2 * tangent * inverse;
    double by_a = is_side ? 0 : sine * cos(2 * M_PI * t), by_b = is_side ? sine : sine * sin(2 * M_PI * t);
    double up = is_side ? (s - 0.5) * patch->length : 0;
    for (int i = 0; i < 3; i++)
        place[i] = patch->o[i] + up * patch->n[i] + patch->radius * (cosine * n[i] + by_a * a[i] + by_b * b[i]);
    return whole;
}

static void disk_place(const struct lx_patch *patch, double s, double cosine, double sine, double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = patch->o[i] + patch->radius * s * (cosine * patch->a[i] + sine * patch->b[i]);
}

/* The middle of a flat cell and the distance of its farthest corner. */
static double look_at_flat(const struct lx_patch *patch, const struct lx_cell *cell, double middle[3])
{
    double farthest = 0;
    flat_place(patch, cell->s + cell->ds / 2, cell->t + cell->dt / 2, middle);
    for (int corner = 0; corner < 4; corner++) {
        double place[3];
        flat_place(patch, cell->s + (corner & 1) * cell->ds, cell->t + (corner >> 1) * cell->dt, place);
        for (int i = 0; i < 3; i++)
            place[i] -= middle[i];
        farthest = lx_larger(farthest, lx_dot(place, place));
    }
    return sqrt(farthest);
}

bool lx_cell_is_round(const struct lx_patch *patch, const struct lx_cell *cell)
{
    return cell->dt == 1 && (patch->kind == LX_PATCH_DISK || patch->kind == LX_PATCH_BALL);
}

/* The middle of a round patch: that of the disk or the ball. */
static double look_at_round(const struct lx_patch *patch, const double element[3], double middle[3])
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        middle[i] = patch->o[i];
        square += (element[i] - middle[i]) * (element[i] - middle[i]);
    }
    return patch->kind == LX_PATCH_BALL && !(square > patch->radius * patch->radius) ? -1 : patch->radius;
}

double lx_cell_look(const struct lx_patch *patch, const struct lx_cell *cell, const double element[3], double middle[3])
{
    const double s = cell->s + cell->ds / 2, t = cell->t + cell->dt / 2, radius = patch->radius;
    const double end = cell->s + cell->ds, turn = lx_smaller(M_PI * cell->dt, 2);
    if (patch->kind == LX_PATCH_FLAT)
        return look_at_flat(patch, cell, middle);
    if (lx_cell_is_round(patch, cell))
        return look_at_round(patch, element, middle);
    if (patch->kind == LX_PATCH_DISK) {
        disk_place(patch, s, cos(2 * M_PI * t), sin(2 * M_PI * t), middle);
        return radius * (patch->is_near ? hypot(cell->ds / 2, sqrt(s * end) * turn) : cell->ds / 2 + end * turn);
    }
    double tangent = round_place(patch, s, t, element, middle), last = end * tangent;
    if (!(tangent > 0))
        return -1;
    const double sine = 2 * last / (1 + last * last), by_turn = radius * lx_smaller(2 * tangent * cell->dt, 2);
    if (patch->kind == LX_PATCH_BALL && patch->is_near) /* no sine is more than the last one nor the tangent's twice */
        return radius * hypot(tangent * cell->ds, sqrt(lx_smaller(2 * s * tangent, 1) * sine) * turn);
    if (patch->kind == LX_PATCH_BALL)
        return radius * (tangent * cell->ds + sine * turn);
    return patch->is_near ? hypot(patch->length * cell->ds / 2, by_turn) : patch->length * cell->ds / 2 + by_turn;
}

double lx_patch_above(const struct lx_patch *patch, const double element[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = element[i] - patch->o[i];
    const double along = patch->kind == LX_PATCH_BALL ? 0 : lx_dot(from, patch->n);
    if (patch->kind == LX_PATCH_FLAT || patch->kind == LX_PATCH_DISK)
        return along;
    for (int i = 0; i < 3; i++)
        from[i] -= along * patch->n[i];
    return sqrt(lx_dot(from, from)) - patch->radius;
}

/* How long a cell is in each direction, on average; of what is bent relative to each other. */
static void cell_lengths(const struct lx_patch *patch, const struct lx_cell *cell, double lengths[2])
{
    const double s = cell->s + cell->ds / 2, t = cell->t + cell->dt / 2;
    double by_s[3], by_t[3];
    switch (patch->kind) {
    case LX_PATCH_FLAT:
        for (int i = 0; i < 3; i++)
            by_s[i] = patch->a[i] + t * patch->g[i], by_t[i] = patch->b[i] + s * patch->g[i];
        lengths[0] = sqrt(lx_dot(by_s, by_s)) * cell->ds, lengths[1] = sqrt(lx_dot(by_t, by_t)) * cell->dt;
        return;
    case LX_PATCH_SIDE: lengths[0] = patch->length * cell->ds, lengths[1] = patch->breadth * cell->dt; return;
    case LX_PATCH_DISK:
    case LX_PATCH_BALL: break;
    }
    lengths[0] = cell->ds, lengths[1] = 2 * M_PI * s * cell->dt;
}

struct lx_cell lx_cell_quarter(const struct lx_patch *patch, const struct lx_cell *cell, int quarter)
{
    const double ds = cell->ds / 2, dt = cell->dt / 2;
    if (lx_cell_is_round(patch, cell))
        return (struct lx_cell){cell->s, quarter / (double)LX_QUARTERS, cell->ds, 1.0 / LX_QUARTERS};
    return (struct lx_cell){cell->s + (quarter & 1 ? ds : 0), cell->t + (quarter & 2 ? dt : 0), ds, dt};
}

bool lx_cell_is_long(const struct lx_patch *patch, const struct lx_cell *cell)
{
    double lengths[2];
    if (!patch->is_near || lx_cell_is_round(patch, cell))
        return false;
    cell_lengths(patch, cell, lengths);
    return lx_larger(lengths[0], lengths[1]) > LONG * lx_smaller(lengths[0], lengths[1]);
}

struct lx_cell lx_cell_fourth(const struct lx_patch *patch, const struct lx_cell *cell, int fourth)
{
    const double ds = cell->ds / LX_QUARTERS, dt = cell->dt / LX_QUARTERS;
    double lengths[2];
    if (!lx_cell_is_long(patch, cell))
        return lx_cell_quarter(patch, cell, fourth);
    cell_lengths(patch, cell, lengths);
    if (lengths[0] > lengths[1])
        return (struct lx_cell){cell->s + fourth * ds, cell->t, ds, cell->dt};
    return (struct lx_cell){cell->s, cell->t + fourth * dt, cell->ds, dt};
}

/* ---- the patches that are seen ---- */

static size_t make_patches(const struct lx_area_light *lamp, const struct lx_around *around,
                           const struct lx_asking *asking, struct lx_patch *patches)
{
    size_t count = 0;
    if (lamp->facets)
        return facet_patches(lamp, around, asking, patches);
    if (!lamp->has_side)
        return lamp->is_ball ? ball_patch(lamp, around, patches) : disk_patch(lamp, around, 0, patches);
    count += side_patch(lamp, around, patches);
    count += disk_patch(lamp, around, 1, patches + count);
    count += disk_patch(lamp, around, -1, patches + count);
    return count;
}

/* Half the length of a patch's diagonal, or more, and its middle. */
static double patch_size(const struct lx_patch *patch, double middle[3])
{
    const struct lx_cell whole = {0, 0, 1, 1};
    if (patch->kind == LX_PATCH_FLAT)
        return look_at_flat(patch, &whole, middle);
    memcpy(middle, patch->o, sizeof patch->o);
    return hypot(patch->radius, patch->length / 2);
}

static bool is_near(const struct lx_patch *patch, const struct lx_around *around)
{
    double middle[3], away[3], above = lx_patch_above(patch, around->center);
    const double size = patch_size(patch, middle);
    for (int i = 0; i < 3; i++)
        away[i] = around->center[i] - middle[i];
    const double distance = lx_larger(above, sqrt(lx_dot(away, away)) - size) - around->radius;
    return size > NEAR * distance;
}

size_t lx_patches_make(const struct lx_area_light *lamp, const struct lx_around *around, const struct lx_asking *asking,
                       struct lx_patch *patches)
{
    const size_t count = make_patches(lamp, around, asking, patches);
    for (size_t i = 0; i < count; i++)
        patches[i].is_near = is_near(&patches[i], around);
    return count;
}

/* ---- samples ---- */

void lx_patch_samples(const struct lx_patch *patch, double touch_mm, struct lx_samples_double *samples)
{
    static const enum lx_bend bends[] = {LX_FLAT, LX_FLAT, LX_BALL_SHAPED, LX_SIDE};
    samples->bend = bends[patch->kind];
    samples->ox = patch->o[0], samples->oy = patch->o[1], samples->oz = patch->o[2];
    samples->ax = patch->a[0], samples->ay = patch->a[1], samples->az = patch->a[2];
    samples->nx = patch->n[0], samples->ny = patch->n[1], samples->nz = patch->n[2];
    samples->radius = patch->radius;
    samples->height = lx_dot(patch->o, patch->n) + touch_mm;
    samples->touch = touch_mm;
}

/* What stands for a sample at s, t, told cosine and sine of 2 pi t; and its area for a unit of both. */
static double sample_at(const struct lx_patch *patch, double s, double t, double cosine, double sine, double place[3])
{
    switch (patch->kind) {
    case LX_PATCH_FLAT: flat_place(patch, s, t, place); return flat_area(patch, s, t);
    case LX_PATCH_BALL: place[0] = s, place[1] = cosine, place[2] = sine; return 2 * M_PI;
    case LX_PATCH_SIDE:
        place[0] = (s - 0.5) * patch->length, place[1] = 2 * t - 1, place[2] = 0;
        return 2 * patch->length;
    case LX_PATCH_DISK: break;
    }
    disk_place(patch, s, cosine, sine, place);
    return 2 * M_PI * patch->radius * patch->radius * s;
}

/* Rules of Gauss for 1 to 3 samples between 0 and 1. */
static const double PLACES[3][3] = {
    {0.5}, {0.21132486540518712, 0.78867513459481288}, {0.11270166537925831, 0.5, 0.88729833462074169}};
static const double WEIGHTS[3][3] = {{1}, {0.5, 0.5}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};

void lx_cell_samples(const struct lx_patch *patch, const struct lx_cell *cell, unsigned side, double gain, size_t first,
                     struct lx_samples_double *samples)
{
    const double *x = PLACES[side - 1], *w = WEIGHTS[side - 1];
    for (unsigned k = 0; k < side; k++) {
        const double t = cell->t + x[k] * cell->dt;
        bool turns = patch->kind == LX_PATCH_DISK || patch->kind == LX_PATCH_BALL;
        const double cosine = turns ? cos(2 * M_PI * t) : 0, sine = turns ? sin(2 * M_PI * t) : 0;
        for (unsigned j = 0; j < side; j++) {
            const double s = cell->s + x[j] * cell->ds;
            double place[3], area = sample_at(patch, s, t, cosine, sine, place);
            size_t at = first + (size_t)k * side + j;
            samples->x[at] = place[0], samples->y[at] = place[1], samples->z[at] = place[2];
            samples->gain[at] = gain * area * w[j] * w[k] * cell->ds * cell->dt;
        }
    }
}

void lx_round_samples(const struct lx_patch *patch, double from_s, double to_s, unsigned rings, unsigned spokes,
                      double off, double gain, struct lx_samples_double *samples)
{
    const double *x = PLACES[rings - 1], *w = WEIGHTS[rings - 1], ds = to_s - from_s;
    for (unsigned k = 0; k < spokes; k++) {
        const double t = (k + off) / spokes, cosine = cos(2 * M_PI * t), sine = sin(2 * M_PI * t);
        for (unsigned j = 0; j < rings; j++) {
            double place[3], area = sample_at(patch, from_s + x[j] * ds, t, cosine, sine, place);
            const size_t at = (size_t)k * rings + j;
            samples->x[at] = place[0], samples->y[at] = place[1], samples->z[at] = place[2];
            samples->gain[at] = gain * area * w[j] * ds / spokes;
        }
    }
}
