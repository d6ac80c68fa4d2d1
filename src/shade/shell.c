/* SPDX-License-Identifier: MIT */
/* Shells for the kernels, their patches, and samples of them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../light/extended.h"
#include "shell.h"

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

static void set_edge(const struct lx_facets *facets, const struct lx_edge *edge, struct lx_shell_edge *made)
{
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    lx_wide3 from = lx_wide3_sub(facets->corners_mm[edge->from], center);
    lx_wide3 to = lx_wide3_sub(facets->corners_mm[edge->to], center);
    value_of3(from, made->from);
    value_of3(to, made->to);
    value_of3(lx_wide3_sub(to, from), made->along);
    value_of3(lx_wide3_cross(from, to), made->moment);
    made->left = edge->left;
    made->right = edge->right;
}

static int set_facets(const struct lx_facets *facets, struct lx_shell *shell)
{
    shell->faces = lx_new_array(facets->face_count, sizeof *shell->faces);
    shell->edges = lx_new_array(facets->edge_count, sizeof *shell->edges);
    shell->facets = facets;
    if (!shell->faces || !shell->edges)
        return -1;
    shell->face_count = facets->face_count;
    shell->edge_count = facets->edge_count;
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        lx_wide3 corner = lx_wide3_sub(facets->corners_mm[facets->loop[face->first]], center);
        value_of3(face->normal, shell->faces[i].normal);
        shell->faces[i].height = lx_wide_value(lx_wide3_dot(face->normal, corner));
    }
    for (size_t i = 0; i < facets->edge_count; i++)
        set_edge(facets, &facets->edges[i], &shell->edges[i]);
    return 0;
}

int lx_shell_make(const struct lx_emitter *emitter, const struct lx_shape *lit, struct lx_shell *shell)
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
    return is_facets ? set_facets(facets, shell) : 0;
}

void lx_shell_clear(struct lx_shell *shell)
{
    free(shell->faces);
    free(shell->edges);
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
    enum { SIDE_AND_CAPS = 3 };
    size_t limit = 0;
    if (shell->type != LX_FACETS)
        return SIDE_AND_CAPS;
    for (size_t i = 0; i < shell->face_count; i++)
        limit += (shell->facets->faces[i].count - 1) / 2;
    return limit;
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
        memcpy(patch->n, shell->faces[face_index].normal, sizeof patch->n);
        value_of3(lx_wide3_sub(first, center), patch->o);
        lx_wide3 a = lx_wide3_sub(facets->corners_mm[loop[k]], first);
        lx_wide3 c = lx_wide3_sub(facets->corners_mm[loop[k + 1]], first);
        lx_wide3 b = is_triangle ? lx_wide3_sub(first, first) : lx_wide3_sub(facets->corners_mm[loop[k + 2]], first);
        value_of3(a, patch->a);
        value_of3(b, patch->b);
        value_of3(lx_wide3_sub(lx_wide3_sub(c, a), b), patch->g);
        for (int i = 0; i < 3; i++)
            patch->o[i] += shell->center[i];
    }
    return count;
}

static size_t facet_patches(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patches)
{
    size_t count = 0;
    for (size_t i = 0; i < shell->face_count; i++) {
        const struct lx_shell_face *face = &shell->faces[i];
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

/* The largest angle between the direction to the middle of the ball of places and to what one of them sees of a round
 * shape of this radius: acos(R/d) of a place at the distance d, itself turned away by up to asin(r/D). */
static double round_reach(double radius, double distance, double around)
{
    double nearest = distance - around, farthest = distance + around;
    if (!(nearest > 0))
        return farthest > radius ? M_PI : 0;
    return farthest > radius ? fmin(M_PI, acos(fmin(1, radius / farthest)) + asin(around / distance)) : 0;
}

static size_t ball_patch(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_BALL, .radius = shell->round_mm};
    for (int i = 0; i < 3; i++) {
        patch->o[i] = shell->center[i];
        patch->n[i] = around->center[i] - shell->center[i];
    }
    double distance = sqrt(dot(patch->n, patch->n));
    if (!(distance > 0))
        return 0;
    for (int i = 0; i < 3; i++)
        patch->n[i] /= distance;
    make_frame(patch->n, patch->a, patch->b);
    patch->reach = round_reach(shell->round_mm, distance, around->radius);
    return patch->reach > 0;
}

static size_t side_patch(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patch)
{
    *patch = (struct lx_patch){.kind = LX_PATCH_SIDE, .radius = shell->round_mm, .length = 2 * shell->half_mm};
    double offset[3];
    for (int i = 0; i < 3; i++) {
        patch->o[i] = shell->center[i];
        patch->n[i] = shell->axis[i];
        offset[i] = around->center[i] - shell->center[i];
    }
    double height = dot(offset, patch->n);
    for (int i = 0; i < 3; i++)
        patch->a[i] = offset[i] - height * patch->n[i];
    double distance = sqrt(dot(patch->a, patch->a));
    if (distance > around->radius)
        for (int i = 0; i < 3; i++)
            patch->a[i] /= distance;
    else
        make_frame(patch->n, patch->a, patch->b);
    cross(patch->n, patch->a, patch->b);
    patch->reach = round_reach(shell->round_mm, distance, around->radius);
    return patch->reach > 0;
}

size_t lx_patches_make(const struct lx_shell *shell, const struct lx_around *around, struct lx_patch *patches)
{
    size_t count = 0;
    switch (shell->type) {
    case LX_FACETS: return facet_patches(shell, around, patches);
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

/* A place on a patch, the unit normal there, and the area for a unit of s and t. */
static double place_at(const struct lx_patch *patch, double s, double t, double place[3], double normal[3])
{
    double turn = patch->kind == LX_PATCH_SIDE ? (2 * t - 1) * patch->reach : 2 * M_PI * t;
    if (patch->kind == LX_PATCH_FLAT) {
        double by_s[3], by_t[3], area[3];
        for (int i = 0; i < 3; i++) {
            place[i] = patch->o[i] + s * patch->a[i] + t * patch->b[i] + s * t * patch->g[i];
            normal[i] = patch->n[i];
            by_s[i] = patch->a[i] + t * patch->g[i];
            by_t[i] = patch->b[i] + s * patch->g[i];
        }
        cross(by_s, by_t, area);
        return fmax(dot(area, patch->n), 0);
    }
    double cosine = cos(turn), sine = sin(turn), angle = s * patch->reach;
    bool is_ball = patch->kind == LX_PATCH_BALL, is_disk = patch->kind == LX_PATCH_DISK;
    double out = is_ball ? sin(angle) : is_disk ? s : 1;
    double up = is_ball ? patch->radius * cos(angle) : is_disk ? 0 : (s - 0.5) * patch->length;
    for (int i = 0; i < 3; i++) {
        double across = patch->a[i] * cosine + patch->b[i] * sine;
        place[i] = patch->o[i] + up * patch->n[i] + patch->radius * out * across;
        normal[i] = is_ball ? patch->n[i] * cos(angle) + across * out : is_disk ? patch->n[i] : across;
    }
    if (is_disk)
        return 2 * M_PI * patch->radius * patch->radius * s;
    if (is_ball)
        return 2 * M_PI * patch->radius * patch->radius * patch->reach * out;
    return patch->length * patch->radius * 2 * patch->reach;
}

struct lx_around lx_cell_around(const struct lx_patch *patch, const struct lx_cell *cell)
{
    struct lx_around around;
    double normal[3], along = 0, turn = 0;
    place_at(patch, cell->s + cell->ds / 2, cell->t + cell->dt / 2, around.center, normal);
    switch (patch->kind) {
    case LX_PATCH_FLAT:
        around.radius = 0;
        for (int corner = 0; corner < 4; corner++) {
            double place[3];
            place_at(patch, cell->s + (corner & 1) * cell->ds, cell->t + (corner >> 1) * cell->dt, place, normal);
            for (int i = 0; i < 3; i++)
                place[i] -= around.center[i];
            around.radius = fmax(around.radius, sqrt(dot(place, place)));
        }
        return around;
    case LX_PATCH_DISK:
        along = patch->radius * cell->ds / 2;
        turn = M_PI * cell->dt * (cell->s + cell->ds);
        break;
    case LX_PATCH_BALL: {
        double last = patch->reach * (cell->s + cell->ds);
        along = patch->radius * patch->reach * cell->ds / 2;
        turn = M_PI * cell->dt * (last < M_PI / 2 ? sin(last) : 1);
        break;
    }
    case LX_PATCH_SIDE:
        along = patch->length * cell->ds / 2;
        turn = patch->reach * cell->dt;
        break;
    }
    bool straight = patch->kind == LX_PATCH_SIDE;
    double across = patch->radius * fmin(turn, 2);
    around.radius = straight ? hypot(along, across) : along + across;
    return around;
}

void lx_cell_samples(const struct lx_patch *patch, const struct lx_cell *cell, unsigned side, double touch_mm,
                     double gain, size_t first, struct lx_samples_double *samples)
{
    static const double places[3][3] = {
        {0.5}, {0.21132486540518712, 0.78867513459481288}, {0.11270166537925831, 0.5, 0.88729833462074169}};
    static const double weights[3][3] = {{1}, {0.5, 0.5}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
    const double *x = places[side - 1], *w = weights[side - 1];
    for (unsigned i = 0; i < side * side; i++) {
        unsigned j = i / side, k = i % side;
        double place[3], normal[3];
        double area = place_at(patch, cell->s + x[j] * cell->ds, cell->t + x[k] * cell->dt, place, normal);
        size_t at = first + i;
        samples->x[at] = place[0], samples->y[at] = place[1], samples->z[at] = place[2];
        samples->nx[at] = normal[0], samples->ny[at] = normal[1], samples->nz[at] = normal[2];
        samples->height[at] = dot(place, normal) + touch_mm;
        samples->gain[at] = gain * area * w[j] * w[k] * cell->ds * cell->dt;
    }
}
