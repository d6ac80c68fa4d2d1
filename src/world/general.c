/* SPDX-License-Identifier: MIT */
/* The general way of shapes without kernels: ray by ray and element by element, by their kind. */
#include "general.h"

#include <math.h>

#include "../base/vector.h"

static bool meet_one(const struct lx_shape *shape, const struct lx_ray *ray, double *t, double offset_mm[3])
{
    if (shape->kind->meets) {
        const double from[3] = {ray->origin_mm[0] - shape->anchor_mm[0], ray->origin_mm[1] - shape->anchor_mm[1],
                                ray->origin_mm[2] - shape->anchor_mm[2]};
        return shape->kind->meets(shape, from, ray->direction, t, offset_mm);
    }
    const struct lx_hit hit = shape->kind->hit(shape, ray);
    *t = hit.t;
    offset_mm[0] = hit.place_mm.x.value - shape->anchor_mm[0];
    offset_mm[1] = hit.place_mm.y.value - shape->anchor_mm[1];
    offset_mm[2] = hit.place_mm.z.value - shape->anchor_mm[2];
    return hit.exists;
}

static size_t meet_by_ray(const struct lx_shape *shape, const struct lx_row_view *view, const double *x_mm,
                          size_t count, double *depth, double *px, double *py, double *pz)
{
    size_t met = 0;
    for (size_t i = 0; i < count; i++) {
        struct lx_ray ray = {.origin_mm = {x_mm[i], view->y_mm, view->observer_z_mm}, .direction = {0, 0, -1}};
        double offset[3];
        if (view->perspective)
            ray = (struct lx_ray){.origin_mm = {0, 0, view->observer_z_mm},
                                  .direction = {x_mm[i], view->y_mm, -view->observer_z_mm}};
        const bool is_met = meet_one(shape, &ray, &depth[i], offset);
        depth[i] = is_met ? depth[i] : HUGE_VAL;
        px[i] = is_met ? offset[0] : 0;
        py[i] = is_met ? offset[1] : 0;
        pz[i] = is_met ? offset[2] : 0;
        met += is_met;
    }
    return met;
}

/* The normal that is seen at a place. */
static void normal_from(const struct lx_shape *shape, const struct lx_origin *eye, const double place[3],
                        double normal[3])
{
    double sight[3];
    if (!shape->kind->normal_seen) {
        shape->kind->normal(shape, place, normal);
        return;
    }
    lx_way_to(eye, place, sight);
    for (int k = 0; k < 3; k++)
        sight[k] = -sight[k];
    shape->kind->normal_seen(shape, place, sight, normal);
}

static void complete_by_normal(const struct lx_shape *shape, const double *observer_mm, const struct lx_origin *eye,
                               struct lx_block_double *block, struct lx_block_single *copy, size_t count)
{
    for (size_t i = 0; i < lx_padded(count); i++) {
        const double place[3] = {block->px[i], block->py[i], block->pz[i]};
        double normal[3];
        normal_from(shape, eye, place, normal);
        block->nx[i] = normal[0], block->ny[i] = normal[1], block->nz[i] = normal[2];
        copy->px[i] = (float)place[0], copy->py[i] = (float)place[1], copy->pz[i] = (float)place[2];
        copy->nx[i] = (float)normal[0], copy->ny[i] = (float)normal[1], copy->nz[i] = (float)normal[2];
        if (!observer_mm)
            continue;
        double view[3] = {observer_mm[0] - place[0], observer_mm[1] - place[1], observer_mm[2] - place[2]};
        lx_normalize(view);
        block->vx[i] = view[0], block->vy[i] = view[1], block->vz[i] = view[2];
        copy->vx[i] = (float)view[0], copy->vy[i] = (float)view[1], copy->vz[i] = (float)view[2];
    }
}

static bool takes_one(const struct lx_shape *shape, const double place_mm[3], const double way[3], bool endless)
{
    if (!shape->kind->takes)
        return shape->kind->blocks(shape, lx_exact3(place_mm), lx_exact3(way), endless).value > 0;
    const double from[3] = {place_mm[0] - shape->anchor_mm[0], place_mm[1] - shape->anchor_mm[1],
                            place_mm[2] - shape->anchor_mm[2]};
    return shape->kind->takes(shape, from, way, endless);
}

/* Whether a way leads behind the face of an element of the shape itself. */
static bool is_behind(const struct lx_shape *shape, const struct lx_block_double *block, size_t i, const double way[3])
{
    const double place[3] = {block->px[i], block->py[i], block->pz[i]};
    const double normal[3] = {block->nx[i], block->ny[i], block->nz[i]};
    return shape->kind->is_behind && shape->kind->is_behind(shape, place, normal, way);
}

static void block_by_way(const struct lx_blocker *blocker, bool is_own, const struct lx_block_double *block,
                         size_t count, float *open)
{
    const struct lx_shape *shape = &blocker->shape;
    const struct lx_origin light = {.endless = !blocker->is_point,
                                    .at = {blocker->light[0], blocker->light[1], blocker->light[2]}};
    for (size_t i = 0; i < count; i++) {
        const double place[3] = {block->px[i], block->py[i], block->pz[i]};
        double way[3];
        const bool endless = lx_way_to(&light, place, way);
        if (open[i] > 0 && ((is_own && is_behind(shape, block, i, way)) || takes_one(shape, place, way, endless)))
            open[i] = 0;
    }
}

size_t lx_meet_shape(const struct lx_kernels *kernels, const struct lx_shape *shape, const struct lx_row_view *view,
                     const double *x_mm, size_t count, double *depth, double *px, double *py, double *pz)
{
    lx_meet_lines *meet = lx_has_kernels(shape) ? kernels->meet_lines[shape->type] : meet_by_ray;
    return meet(shape, view, x_mm, count, depth, px, py, pz);
}

void lx_complete_shape(const struct lx_kernels *kernels, const struct lx_shape *shape, const double *observer_mm,
                       const struct lx_origin *eye, struct lx_block_double *block, struct lx_block_single *copy,
                       size_t count)
{
    if (lx_has_kernels(shape))
        kernels->complete_block[shape->type](shape, observer_mm, block, copy, count);
    else
        complete_by_normal(shape, observer_mm, eye, block, copy, count);
}

void lx_block_shape(const struct lx_kernels *kernels, const struct lx_blocker *blocker, bool is_own,
                    const struct lx_block_double *block, size_t count, float *open)
{
    if (lx_has_kernels(&blocker->shape))
        kernels->block_light[blocker->shape.type](blocker, block, count, open);
    else
        block_by_way(blocker, is_own, block, count, open);
}
