/* SPDX-License-Identifier: MIT */
/* The surfaces that a run of pixels shows, from the lines of sight to blocks of elements. */
#include "seen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../world/camera.h"
#include "../world/general.h"

static struct lx_sight_lines lines_in(struct lx_lines_room *room)
{
    return (struct lx_sight_lines){room->depth, room->px, room->py, room->pz};
}

void lx_seen_init(const struct lx_plan *plan, struct lx_seen *seen)
{
    seen->nearest = lines_in(&seen->room_of_nearest);
    if (plan->surface_count == 1)
        seen->nearest = (struct lx_sight_lines){seen->nearest.depth, seen->block.px, seen->block.py, seen->block.pz};
    /* where view vectors are the same everywhere they stay */
    for (size_t i = 0; i < LX_BLOCK; i++) {
        seen->block.vx[i] = seen->block.vy[i] = 0, seen->block.vz[i] = 1;
        seen->copy.vx[i] = seen->copy.vy[i] = 0, seen->copy.vz[i] = 1;
    }
}

/* Whether a surface may be seen through a row at all; in perspective only the lines themselves tell. */
static bool may_show(const struct lx_planned_surface *surface, const struct lx_row_view *view, const double *x_mm,
                     size_t count)
{
    return view->perspective || (view->y_mm >= surface->low_mm[1] && view->y_mm <= surface->high_mm[1] &&
                                 x_mm[count - 1] >= surface->low_mm[0] && x_mm[0] <= surface->high_mm[0]);
}

static size_t meet(const struct lx_plan *plan, const struct lx_planned_surface *surface, const struct lx_row_view *view,
                   const double *x_mm, size_t count, struct lx_sight_lines lines)
{
    return lx_meet_shape(plan->kernels, &surface->shape, view, x_mm, count, lines.depth, lines.px, lines.py, lines.pz);
}

/* Takes over what a further surface hides of the nearest so far; returns how many pixels showed none. */
static size_t merge(struct lx_seen *seen, uint32_t surface, size_t count)
{
    const struct lx_sight_lines *nearest = &seen->nearest;
    const struct lx_lines_room *candidate = &seen->candidate;
    size_t new = 0;
    for (size_t i = 0; i < count; i++) {
        if (candidate->depth[i] >= nearest->depth[i])
            continue;
        new += seen->shown[i] == 0;
        seen->shown[i] = surface + 1;
        nearest->depth[i] = candidate->depth[i];
        nearest->px[i] = candidate->px[i];
        nearest->py[i] = candidate->py[i];
        nearest->pz[i] = candidate->pz[i];
    }
    return new;
}

struct lx_row_view lx_row_view_of(const struct lx_plan *plan, double y_mm)
{
    const struct lx_camera *camera = &plan->prepared->camera;
    return (struct lx_row_view){.perspective = camera->is_perspective, .observer_z_mm = camera->z_mm, .y_mm = y_mm};
}

void lx_seen_enter(const struct lx_plan *plan, struct lx_seen *seen, const double *x_mm, size_t count)
{
    lx_set_shape_columns(plan->kernels, &plan->alone->shape, x_mm, count, &seen->columns);
}

struct lx_stretch lx_seen_in_single(const struct lx_plan *plan, struct lx_seen *seen, double y_mm, uint8_t *mask)
{
    const struct lx_planned_surface *surface = plan->alone;
    const struct lx_columns *columns = &seen->columns;
    const struct lx_row_view view = lx_row_view_of(plan, y_mm);
    if (may_show(surface, &view, columns->x_mm, columns->count))
        return lx_view_shape(plan->kernels, &surface->shape, &view, columns, &seen->copy, mask);
    memset(mask, 0, columns->count);
    return (struct lx_stretch){0};
}

/* The box on the screen in which a surface may be seen. */
static struct lx_box box_on_screen(const struct lx_camera *camera, const struct lx_planned_surface *surface)
{
    static const double ROOM = 1e-6; /* what touches a surface may seem to be on it */
    const double z_mm = camera->z_mm, under = z_mm - surface->low_mm[2], above = z_mm - surface->high_mm[2];
    struct lx_box box = {.low = {0, 0, 0}, .high = {0, 0, 0}};
    for (int k = 0; k < 2; k++) {
        double low = surface->low_mm[k], high = surface->high_mm[k];
        const double size = high - low;
        if (camera->is_perspective && !(above > ROOM * z_mm)) {
            low = -HUGE_VAL, high = HUGE_VAL;
        } else if (camera->is_perspective) {
            low *= z_mm / (low < 0 ? above : under);
            high *= z_mm / (high > 0 ? above : under);
        }
        const double room = ROOM * (fabs(low) + fabs(high) + size * (camera->is_perspective ? z_mm / above : 1));
        box.low[k] = low > -HUGE_VAL ? low - room : low;
        box.high[k] = high < HUGE_VAL ? high + room : high;
    }
    return box;
}

int lx_seen_plan(struct lx_plan *plan)
{
    if (plan->surface_count <= LX_FEW_BOXES)
        return 0;
    struct lx_box *boxes = lx_new_array(plan->surface_count, sizeof *boxes);
    for (size_t s = 0; boxes && s < plan->surface_count; s++)
        boxes[s] = box_on_screen(&plan->prepared->camera, &plan->surfaces[s]);
    const int result = boxes ? lx_boxes_make(boxes, plan->surface_count, &plan->on_screen) : -1;
    free(boxes);
    return result;
}

/* A rectangle on the screen. */
struct within {
    const double *low, *high;
};

static bool is_within(const void *data, const double low[3], const double high[3])
{
    const struct within *within = data;
    return within->low[0] <= high[0] && within->high[0] >= low[0] && within->low[1] <= high[1] &&
           within->high[1] >= low[1];
}

bool lx_seen_within(const struct lx_plan *plan, const double low_mm[2], const double high_mm[2], struct lx_found *found)
{
    const struct within within = {low_mm, high_mm};
    return lx_boxes_find(&plan->on_screen, is_within, &within, found);
}

size_t lx_seen_find(const struct lx_plan *plan, struct lx_seen *seen, double y_mm, const double *x_mm, size_t count)
{
    const struct lx_row_view view = lx_row_view_of(plan, y_mm);
    size_t found = 0;
    bool any = false;
    seen->shows_one = false;
    seen->is_found =
        lx_seen_within(plan, (const double[]){x_mm[0], y_mm}, (const double[]){x_mm[count - 1], y_mm}, &seen->found);
    const size_t all = lx_found_count(&seen->found, seen->is_found, plan->surface_count);
    for (size_t i = 0; i < all; i++) {
        const uint32_t s = (uint32_t)lx_found_at(&seen->found, seen->is_found, i);
        if (!may_show(&plan->surfaces[s], &view, x_mm, count))
            continue;
        const size_t met =
            meet(plan, &plan->surfaces[s], &view, x_mm, count, any ? lines_in(&seen->candidate) : seen->nearest);
        seen->shows_one = plan->surface_count == 1 && met == count;
        if (seen->shows_one)
            return count;
        found += any ? merge(seen, s, count) : met;
        for (size_t k = 0; !any && k < count; k++)
            seen->shown[k] = seen->nearest.depth[k] < HUGE_VAL ? s + 1 : 0;
        any = true;
    }
    return found;
}

const double *lx_observer_from(const struct lx_plan *plan, const struct lx_planned_surface *surface, double from[3])
{
    const struct lx_camera *camera = &plan->prepared->camera;
    if (camera->is_parallel)
        return NULL;
    from[0] = -surface->shape.anchor_mm[0];
    from[1] = -surface->shape.anchor_mm[1];
    from[2] = camera->z_mm - surface->shape.anchor_mm[2];
    return from;
}

struct lx_origin lx_eye_from(const struct lx_plan *plan, const struct lx_planned_surface *surface)
{
    struct lx_origin eye = lx_eye(&plan->prepared->camera);
    for (int i = 0; i < 3 && !eye.endless; i++)
        eye.at[i] -= surface->shape.anchor_mm[i];
    return eye;
}

void lx_seen_pad(double *numbers, size_t count)
{
    for (size_t k = count; k < lx_padded(count); k++)
        numbers[k] = numbers[0];
}

/* One coordinate of the elements' pixels, which may stand in the block already, no sooner than it is to. */
static void gather_places(const struct lx_seen *seen, const double *from, bool in_one, size_t elements, double *to)
{
    if (in_one && from + seen->place[0] != to)
        memmove(to, from + seen->place[0], elements * sizeof *to);
    for (size_t k = 0; k < elements && !in_one; k++)
        to[k] = from[seen->place[k]];
    lx_seen_pad(to, elements);
}

struct lx_seen_run lx_seen_gather(const struct lx_plan *plan, struct lx_seen *seen, size_t s, size_t count)
{
    const struct lx_planned_surface *surface = &plan->surfaces[s];
    const bool all = seen->shows_one;
    size_t elements = all ? count : 0;
    seen->place[0] = 0;
    for (size_t i = 0; !all && i < count; i++) {
        seen->place[elements] = (unsigned)i;
        elements += seen->shown[i] == s + 1;
    }
    const unsigned first = seen->place[0];
    const bool in_one = all || (elements > 0 && seen->place[elements - 1] - first == elements - 1);
    gather_places(seen, seen->nearest.px, in_one, elements, seen->block.px);
    gather_places(seen, seen->nearest.py, in_one, elements, seen->block.py);
    gather_places(seen, seen->nearest.pz, in_one, elements, seen->block.pz);
    double from[3];
    const struct lx_origin eye = lx_eye_from(plan, surface);
    if (elements > 0)
        lx_complete_shape(plan->kernels, &surface->shape, lx_observer_from(plan, surface, from), &eye, &seen->block,
                          &seen->copy, elements);
    return (struct lx_seen_run){elements, in_one ? first : LX_BLOCK};
}

void lx_seen_scatter(const struct lx_seen *seen, struct lx_seen_run gathered, const double *sums, double *values)
{
    if (gathered.first < LX_BLOCK)
        memcpy(values + gathered.first, sums, gathered.count * sizeof *values);
    for (size_t k = 0; gathered.first == LX_BLOCK && k < gathered.count; k++)
        values[seen->place[k]] = sums[k];
}
