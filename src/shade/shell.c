/* SPDX-License-Identifier: MIT */
/* Shells for the kernels. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../light/extended.h"
#include "shell.h"

/* Faces or edges between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

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
