/* SPDX-License-Identifier: MIT */
/*
 * Boxes around surfaces, and the questions to the tree over them.  Without a tree lines are held against each box,
 * which spares most of what is computed with all digits; what asks of shafts has quick answers of its own.
 */
#include "among.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "blocking.h"

/* What roundings may do to places of some size. */
static const double ROOM = 1e-9;

/* Its extent, and the balls around it that others ask for, with room. */
static struct lx_box box_of(const struct lx_prepared_surface *surface)
{
    const struct lx_shape *shape = &surface->shape;
    const struct lx_ball ball = lx_shape_ball(shape, surface->low_mm, surface->high_mm, shape->anchor_mm);
    const double radius = fmax(ball.radius, shape->radius_mm);
    struct lx_box box;
    for (int k = 0; k < 3; k++) {
        const double low = fmin(surface->low_mm[k], shape->anchor_mm[k] - radius);
        const double high = fmax(surface->high_mm[k], shape->anchor_mm[k] + radius);
        const double room = lx_shape_room(shape) + 2 * shape->touch_mm + ROOM * (fabs(low) + fabs(high) + radius);
        box.low[k] = low - room;
        box.high[k] = high + room;
    }
    return box;
}

int lx_among_make(struct lx_prepared *prepared)
{
    const size_t count = prepared->surface_count;
    struct lx_box *boxes = lx_new_array(count, sizeof *boxes);
    for (size_t i = 0; boxes && i < count; i++)
        boxes[i] = box_of(&prepared->surfaces[i]);
    const int result = boxes ? lx_boxes_make(boxes, count, &prepared->boxes) : -1;
    free(boxes);
    return result;
}

static struct lx_box_way way_of(const lx_bounded3 *from, const lx_bounded3 *way, bool endless)
{
    const lx_bounded all[6] = {from->x, from->y, from->z, way->x, way->y, way->z};
    double room = 0;
    for (int i = 0; i < 6; i++)
        room += all[i].error + (i < 3 || !endless ? ROOM * fabs(all[i].value) : 0);
    return lx_box_way_of((const double[]){all[0].value, all[1].value, all[2].value},
                         (const double[]){all[3].value, all[4].value, all[5].value}, room, endless);
}

bool lx_among_ray(const struct lx_prepared *prepared, const struct lx_ray *ray, struct lx_found *found)
{
    const lx_bounded3 from = {{ray->origin_mm[0], ray->origin_error[0]},
                              {ray->origin_mm[1], ray->origin_error[1]},
                              {ray->origin_mm[2], ray->origin_error[2]}};
    const lx_bounded3 direction = lx_ray_direction(ray);
    const struct lx_box_way way = way_of(&from, &direction, true);
    return lx_boxes_find_on_way(&prepared->boxes, &way, found);
}

bool lx_among_way(const struct lx_prepared *prepared, const lx_bounded3 *place_mm, const lx_bounded3 *towards,
                  bool endless, struct lx_found *found)
{
    const struct lx_box_way way = way_of(place_mm, towards, endless);
    return lx_boxes_find_on_way(&prepared->boxes, &way, found);
}

bool lx_among_place(const struct lx_prepared *prepared, const double place_mm[3], struct lx_found *found)
{
    static const double nowhere[3];
    const lx_bounded3 place = lx_exact3(place_mm), way = lx_exact3(nowhere);
    return lx_among_way(prepared, &place, &way, false, found);
}

static bool shaft_meets(const void *shaft, const double low[3], const double high[3])
{
    return lx_shaft_meets_box(shaft, low, high);
}

bool lx_among_shaft(const struct lx_prepared *prepared, const struct lx_shaft *shaft, struct lx_found *found)
{
    return prepared->boxes.nodes && lx_boxes_find(&prepared->boxes, shaft_meets, shaft, found);
}

bool lx_among_balls(const struct lx_prepared *prepared, const double anchor_mm[3], const struct lx_ball *from,
                    const struct lx_ball *towards, bool endless, struct lx_found *found)
{
    if (!prepared->boxes.nodes)
        return false;
    double room = (endless ? from->radius : fmax(from->radius, towards->radius)) * (1 + ROOM), begin[3], along[3];
    for (int k = 0; k < 3; k++) {
        begin[k] = anchor_mm[k] + from->center[k];
        along[k] = towards->center[k] - (endless ? 0 : from->center[k]);
        room += ROOM * (fabs(anchor_mm[k]) + fabs(from->center[k]) + (endless ? 0 : fabs(towards->center[k])));
    }
    const struct lx_box_way way = lx_box_way_of(begin, along, room, endless);
    return lx_boxes_find_on_way(&prepared->boxes, &way, found);
}
