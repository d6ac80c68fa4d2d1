/* SPDX-License-Identifier: MIT */
/* Shells for the kernels, their patches, and samples of them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../light/extended.h"
#include "shell.h"

/* Faces or edges between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

/* ---- shells ---- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

static void value_of3(lx_wide3 a, double result[3])
{
    result[0] = lx_wide_value(a.x), result[1] = lx_wide_value(a.y), result[2] = lx_wide_value(a.z);
}

static void set_edge(const struct lx_facets *facets, const struct lx_edge *edge, struct lx_shell_edge_double *made)
{
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    lx_wide3 from = lx_wide3_sub(facets->corners_mm[edge->from], center);
    lx_wide3 to = lx_wide3_sub(facets->corners_mm[edge->to], center);
    value_of3(from, made->from);
    value_of3(to, made->to);
    value_of3(lx_wide3_sub(to, from), made->along);
    value_of3(lx_wide3_add(from, to), made->both);
    made->product = lx_wide_value(lx_wide3_dot(from, to));
    value_of3(lx_wide3_cross(from, to), made->moment);
    made->left = edge->left;
    made->right = edge->right;
}

static luxel_status set_facets(const struct lx_facets *facets, const struct lx_asking *asking, struct lx_shell *shell)
{
    shell->faces_double = lx_new_aligned(facets->face_count, sizeof *shell->faces_double);
    shell->edges_double = lx_new_aligned(facets->edge_count, sizeof *shell->edges_double);
    shell->facets = facets;
    if (!shell->faces_double || !shell->edges_double)
        return LUXEL_ERROR_MEMORY;
    shell->face_count = facets->face_count;
    shell->edge_count = facets->edge_count;
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        lx_wide3 corner = lx_wide3_sub(facets->corners_mm[facets->loop[face->first]], center);
        value_of3(face->normal, shell->faces_double[i].normal);
        shell->faces_double[i].height = lx_wide_value(lx_wide3_dot(face->normal, corner));
        shell->most_patches += (face->count - 1) / 2;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return LUXEL_CANCELLED;
    }
    for (size_t i = 0; i < facets->edge_count; i++) {
        set_edge(facets, &facets->edges[i], &shell->edges_double[i]);
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return LUXEL_CANCELLED;
    }
    return LUXEL_OK;
}

luxel_status lx_shell_make(const struct lx_emitter *emitter, const struct lx_shape *lit, const struct lx_asking *asking,
                           struct lx_shell *shell)
{
    const struct lx_facets *facets = emitter->facets;
    bool is_facets = emitter->type == LX_FACETS;
    const double *center = is_facets ? facets->center_mm : emitter->center_mm;
    double half = emitter->type == LX_CYLINDER ? emitter->height_mm / 2 : 0;
    *shell = (struct lx_shell){
        .type = emitter->type,
        .radiance = emitter->radiance.value,
        .radius_mm = is_facets ? facets->radius_mm : hypot(emitter->radius_mm, half),
        .axis = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value},
        .round_mm = is_facets ? 0 : emitter->radius_mm,
        .half_mm = half,
    };
    double away = 0;
    for (int i = 0; i < 3; i++) {
        shell->center[i] = center[i] - lit->anchor_mm[i];
        away += fabs(shell->center[i]);
    }
    shell->touch_mm = 16 * LX_ROUNDING * (away + shell->radius_mm + lit->radius_mm);
    return is_facets ? set_facets(facets, asking, shell) : LUXEL_OK;
}

static void copy3(const double from[3], float to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (float)from[i];
}

luxel_status lx_shell_make_single(struct lx_shell *shell, const struct lx_asking *asking)
{
    struct lx_shell_face_single *faces = lx_new_aligned(shell->face_count, sizeof *faces);
    struct lx_shell_edge_single *edges = lx_new_aligned(shell->edge_count, sizeof *edges);
    luxel_status status = faces && edges ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < shell->face_count && status == LUXEL_OK; i++) {
        copy3(shell->faces_double[i].normal, faces[i].normal);
        faces[i].height = (float)shell->faces_double[i].height;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            status = LUXEL_CANCELLED;
    }
    for (size_t i = 0; i < shell->edge_count && status == LUXEL_OK; i++) {
        const struct lx_shell_edge_double *edge = &shell->edges_double[i];
        copy3(edge->from, edges[i].from);
        copy3(edge->to, edges[i].to);
        copy3(edge->along, edges[i].along);
        copy3(edge->both, edges[i].both);
        copy3(edge->moment, edges[i].moment);
        edges[i].product = (float)edge->product;
        edges[i].left = edge->left;
        edges[i].right = edge->right;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            status = LUXEL_CANCELLED;
    }
    if (status == LUXEL_OK) {
        shell->faces_single = faces;
        shell->edges_single = edges;
        return LUXEL_OK;
    }
    free(faces);
    free(edges);
    return status;
}

void lx_shell_clear(struct lx_shell *shell)
{
    free(shell->faces_double);
    free(shell->edges_double);
    free(shell->faces_single);
    free(shell->edges_single);
    *shell = (struct lx_shell){0};
}

/* ---- patches ---- */

/* Two unit vectors across a third. */
static void make_frame(const double n[3], double a[3], double b[3])
{
    double other[3] = {0, 0, 0};
    other[fabs(n[0]) > 0.5 ? 1 : 0] = 1;
    cross(n, other, b);
    double scale = 1 / sqrt(dot(b, b));
    for (int i = 0; i < 3; i++)
        b[i] *= scale;
    cross(b, n, a);
}

size_t lx_patch_limit(const struct lx_shell *shell)
{
    return shell->type == LX_FACETS ? shell->most_patches : LX_MOST_ROUND_PATCHES;
}

static void set_areas(struct lx_patch *patch)
{
    double whole[3], by_s[3], by_t[3];
    cross(patch->a, patch->b, whole);
    cross(patch->a, patch->g, by_s);
    cross(patch->g, patch->b, by_t);
    patch->area[0] = dot(patch->n, whole), patch->area[1] = dot(patch->n, by_s), patch->area[2] = dot(patch->n, by_t);
}

/* A face as quadrilaterals that share its first corner, the last one maybe a triangle. */
static size_t cut_face(const struct lx_shell *shell, size_t face_index, struct lx_patch *patches)
{
    const struct lx_facets *facets = shell->facets;
    const struct lx_face *face = &facets->faces[face_index];
    const unsigned *loop = facets->loop + face->first;
    lx_wide3 center = lx_wide3_of(facets->center_mm), first = facets->corners_mm[loop[0]];
    size_t count = 0;
    for (unsigned k = 1; k + 1 < face->count; k += 2) {
        struct lx_patch *patch = &patches[count++];
        bool is_triangle = k + 2 == face->count;
        *patch = (struct lx_patch){.kind = LX_PATCH_FLAT};
        memcpy(patch->n, shell->faces_double[face_index].normal, sizeof patch->n);
        value_of3(lx_wide3_sub(first, center), patch->o);
        lx_wide3 a = lx_wide3_sub(facets->corners_mm[loop[k]], first);
        lx_wide3 c = lx_wide3_sub(facets->corners_mm[loop[k + 1]], first);
        lx_wide3 b = is_triangle ? lx_wide3_sub(first, first) : lx_wide3_sub(facets->corners_mm[loop[k + 2]], first);
        value_of3(a, patch->a);
        value_of3(b, patch->b);
        value_of3(lx_wide3_sub(lx_wide3_sub(c, a), b), patch->g);
        for (int i = 0; i < 3; i++)
            patch->o[i] += shell->center[i];
        set_areas(patch);
    }
    return count;
}

static size_t facet_patches(const struct lx_shell *shell, const struct lx_around *around,
                            const struct lx_asking *asking, struct lx_patch *patches)
{
    size_t count = 0;
    for (size_t i = 0; i < shell->face_count && lx_asking_at_step(asking, i, BETWEEN_CHECKS); i++) {
        const struct lx_shell_face_double *face = &shell->faces_double[i];
        double above = -face->height;
        for (int k = 0; k < 3; k++)
            above += face->normal[k] * (around->center[k] - shell->center[k]);
        if (above + around->radius > shell->touch_mm)
            count += cut_face(shell, i, patches + count);
    }
    return count;
}

static size_t disk_patch(const struct lx_shell *shell, const struct lx_around *around, double side,
                         struct lx_patch *patch)
{
    double above = around->radius;
    *patch = (struct lx_patch){.kind = LX_PATCH_DISK, .radius = shell->round_mm};
    for (int i = 0; i < 3; i++) {
        patch->n[i] = (side < 0 ? -1 : 1) * shell->axis[i];
        patch->o[i] = shell->center[i] + side * shell->half_mm * shell->axis[i];
        above += patch->n[i] * (around->center[i] - patch->o[i]);
    }
    make_frame(patch->n, patch->a, patch->b);
    return above > shell->touch_mm;
}

static size_t ball_patch(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_BALL, .radius = shell->round_mm};
    double towards[3];
    for (int i = 0; i < 3; i++) {
        patch->o[i] = shell->center[i];
        towards[i] = around->center[i] - shell->center[i];
    }
    double distance = sqrt(dot(towards, towards));
    for (int i = 0; i < 3; i++)
        towards[i] = distance > 0 ? towards[i] / distance : i == 0;
    make_frame(towards, patch->a, patch->b);
    return distance + around->radius > patch->radius;
}

static size_t side_patch(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_SIDE, .radius = shell->round_mm, .length = 2 * shell->half_mm};
    double offset[3], across[3];
    for (int i = 0; i < 3; i++) {
        patch->o[i] = shell->center[i];
        patch->n[i] = shell->axis[i];
        offset[i] = around->center[i] - shell->center[i];
    }
    cross(offset, patch->n, across);
    return sqrt(dot(across, across)) + around->radius > patch->radius;
}

size_t lx_patches_make(const struct lx_shell *shell, const struct lx_around *around, const struct lx_asking *asking,
                       struct lx_patch *patches)
{
    size_t count = 0;
    switch (shell->type) {
    case LX_FACETS: return facet_patches(shell, around, asking, patches);
    case LX_DISK: return disk_patch(shell, around, 0, patches);
    case LX_BALL: return ball_patch(shell, around, patches);
    default: break;
    }
    count += side_patch(shell, around, patches);
    count += disk_patch(shell, around, 1, patches + count);
    count += disk_patch(shell, around, -1, patches + count);
    return count;
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
    double along = is_side ? dot(n, patch->n) : 0;
    for (int i = 0; i < 3; i++)
        n[i] -= along * patch->n[i];
    double distance = lx_larger(sqrt(dot(n, n)), patch->radius * 1e-15), slant = dot(n, patch->a) / distance;
    for (int i = 0; i < 3; i++) {
        n[i] /= distance;
        a[i] = is_side ? patch->n[i] : patch->a[i] - slant * n[i];
    }
    double length = lx_larger(sqrt(dot(a, a)), 1e-15);
    for (int i = 0; i < 3; i++)
        a[i] /= length;
    cross(n, a, b);
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
        farthest = lx_larger(farthest, dot(place, place));
    }
    return sqrt(farthest);
}

bool lx_cell_is_round(const struct lx_patch *patch, const struct lx_cell *cell)
{
    return cell->dt == 1 && (patch->kind == LX_PATCH_DISK || patch->kind == LX_PATCH_BALL);
}

/* Of all that is round the middle is that of the disk or the ball. */
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
        return radius * (cell->ds / 2 + end * turn);
    }
    double tangent = round_place(patch, s, t, element, middle), last = end * tangent;
    if (!(tangent > 0))
        return -1;
    if (patch->kind == LX_PATCH_BALL)
        return radius * (tangent * cell->ds + 2 * last / (1 + last * last) * turn);
    return patch->length * cell->ds / 2 + radius * lx_smaller(2 * tangent * cell->dt, 2);
}

void lx_patch_samples(const struct lx_patch *patch, double touch_mm, struct lx_samples_double *samples)
{
    static const enum lx_bend bends[] = {LX_FLAT, LX_FLAT, LX_BALL_SHAPED, LX_SIDE};
    samples->bend = bends[patch->kind];
    samples->ox = patch->o[0], samples->oy = patch->o[1], samples->oz = patch->o[2];
    samples->ax = patch->a[0], samples->ay = patch->a[1], samples->az = patch->a[2];
    samples->nx = patch->n[0], samples->ny = patch->n[1], samples->nz = patch->n[2];
    samples->radius = patch->radius;
    samples->height = dot(patch->o, patch->n) + touch_mm;
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
