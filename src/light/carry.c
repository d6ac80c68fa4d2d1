/* SPDX-License-Identifier: MIT */
/* Copies of emitters in another frame: points, directions and profiles are turned, facets and clouds made anew. */
#include "carry.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/rows.h"
#include "../format/cloud.h"
#include "distribution.h"
#include "sky/dome_keeping.h"
#include "solid/facets_make.h"

/* Emitters, corners or rows of clouds between two questions whether to go on. */
enum { BETWEEN_CHECKS = 1024 };

/* What wide numbers lose when a corner is carried, relative to its coordinates and the frame's. */
static const double LOST = 0x1p-90;

/* The work on a list; what was carried last is often wanted again. */
struct carrying {
    const struct lx_frame *frame;
    const struct lx_asking *asking;
    struct lx_emitters *carried;
    size_t turned_capacity;
    const struct lx_pointed *pointed; /* of the last of carried->turned */
    const struct lx_facets *facets;
    struct lx_facets *facets_carried;
};

/* The profile of a luminaire points to what is turned with it. */
static int carry_luminaire(struct carrying *carrying, struct lx_profile *profile)
{
    struct lx_emitters *list = carrying->carried;
    if (carrying->pointed != profile->luminaire) {
        if (lx_reserve((void **)&list->turned, &carrying->turned_capacity, list->turned_count + 1,
                       sizeof *list->turned))
            return -1;
        struct lx_pointed *turned = malloc(sizeof *turned);
        if (!turned)
            return -1;
        lx_turn_distribution(profile->luminaire, carrying->frame, turned);
        list->turned[list->turned_count++] = turned;
        carrying->pointed = profile->luminaire;
    }
    profile->luminaire = list->turned[list->turned_count - 1];
    return 0;
}

struct lx_facets *lx_facets_carry(const struct lx_facets *facets, const struct lx_frame *frame,
                                  const struct lx_asking *asking)
{
    const struct lx_face *last = &facets->faces[facets->face_count - 1];
    const size_t loop_count = last->first + last->count;
    struct lx_facets *made = lx_facets_new(facets->corner_count, facets->face_count, loop_count);
    if (made)
        made->edges = lx_new_aligned(facets->edge_count, sizeof *made->edges);
    if (!made || !made->edges) {
        lx_facets_free(made);
        return NULL;
    }
    memcpy(made->loop, facets->loop, loop_count * sizeof *made->loop);
    memcpy(made->edges, facets->edges, facets->edge_count * sizeof *made->edges);
    made->edge_count = facets->edge_count;
    made->face_count = facets->face_count;
    double size = facets->radius_mm;
    for (int i = 0; i < 3; i++)
        size += fabs(facets->center_mm[i]) + fabs(frame->origin_mm[i]);
    for (size_t i = 0; i < facets->corner_count; i++) {
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS)) {
            lx_facets_free(made);
            return NULL;
        }
        made->corners_mm[i] = lx_frame_carry_wide(frame, facets->corners_mm[i]);
    }
    for (size_t i = 0; i < facets->face_count; i++) {
        made->faces[i] = facets->faces[i];
        made->faces[i].normal = lx_frame_turn_wide(frame, facets->faces[i].normal);
    }
    lx_frame_carry(frame, facets->center_mm, made->center_mm);
    made->radius_mm = facets->radius_mm + 4 * DBL_EPSILON * size;
    made->area_mm2 = facets->area_mm2;
    made->corner_error_mm = facets->corner_error_mm + LOST * size;
    return made;
}

/* Facets that several emitters use one after the other are copied once. */
static int carry_area_light(struct carrying *carrying, struct lx_emitter *emitter)
{
    if (carrying->facets != emitter->facets) {
        lx_facets_free(carrying->facets_carried);
        carrying->facets = emitter->facets;
        carrying->facets_carried = lx_facets_carry(emitter->facets, carrying->frame, carrying->asking);
    }
    emitter->facets = NULL;
    if (carrying->facets_carried)
        emitter->facets = (struct lx_facets *)lx_kept_hold(&carrying->facets_carried->kept);
    return emitter->facets ? 0 : -1;
}

/* An opening takes its luminaire along. */
static int carry_opening(struct carrying *carrying, struct lx_emitter *emitter)
{
    if (!emitter->profile.luminaire)
        return 0;
    emitter->profile.axis = lx_frame_turn_bounded(carrying->frame, emitter->profile.axis);
    return carry_luminaire(carrying, &emitter->profile);
}

/* A copy of an emitter becomes the carried one; what of it could not be made is NULL. */
static int carry_one(struct carrying *carrying, struct lx_emitter *emitter)
{
    const struct lx_frame *frame = carrying->frame;
    if (lx_is_uniform(emitter))
        return 0;
    if (lx_is_endless(emitter)) {
        emitter->towards = lx_frame_turn_bounded(frame, emitter->towards);
        return 0;
    }
    if (lx_is_dome(emitter)) {
        emitter->towards = lx_frame_turn_bounded(frame, emitter->towards);
        emitter->dome = lx_dome_carry(emitter->dome, frame);
        return emitter->dome ? 0 : -1;
    }
    if (lx_is_point(emitter)) {
        lx_frame_carry(frame, emitter->position_mm, emitter->position_mm);
        emitter->profile.axis = lx_frame_turn_bounded(frame, emitter->profile.axis);
        return emitter->profile.luminaire ? carry_luminaire(carrying, &emitter->profile) : 0;
    }
    if (emitter->facets)
        return carry_area_light(carrying, emitter) || carry_opening(carrying, emitter) ? -1 : 0;
    lx_frame_carry(frame, emitter->center_mm, emitter->center_mm);
    emitter->axis = lx_frame_turn_bounded(frame, emitter->axis);
    return carry_opening(carrying, emitter);
}

struct lx_cloud *lx_cloud_carry(const struct lx_cloud *cloud, const struct lx_frame *frame,
                                const struct lx_asking *asking)
{
    struct lx_cloud *made = lx_cloud_new(cloud->count);
    double *row = made ? made->values : NULL;
    if (!made)
        return NULL;
    made->intensities = cloud->intensities;
    made->tree = cloud->tree ? lx_kept_slot_new() : NULL;
    for (size_t i = 0; i < cloud->count; i++, row += LX_CLOUD_COLUMNS) {
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS)) {
            lx_cloud_free(&made->kept);
            return NULL;
        }
        lx_cloud_row(cloud, i, row);
        lx_frame_carry(frame, row, row);
    }
    return made;
}

static int carry_point_set(struct carrying *carrying, struct lx_point_set *set)
{
    set->cloud = lx_cloud_carry(set->cloud, carrying->frame, carrying->asking);
    set->is_owned = set->cloud != NULL;
    lx_frame_carry(carrying->frame, set->aim_mm, set->aim_mm);
    return set->cloud ? carry_one(carrying, &set->model) : -1;
}

static int carry_all(struct carrying *carrying, const struct lx_emitters *emitters)
{
    struct lx_emitters *list = carrying->carried;
    for (size_t i = 0; i < lx_item_count(emitters); i++) {
        list->items[i] = emitters->items[i];
        if (carry_one(carrying, &list->items[i]) || !lx_asking_at_step(carrying->asking, i, BETWEEN_CHECKS))
            return -1;
    }
    for (; list->point_set_count < emitters->point_set_count; list->point_set_count++) {
        struct lx_point_set *set = &list->point_sets[list->point_set_count];
        *set = emitters->point_sets[list->point_set_count];
        if (carry_point_set(carrying, set)) {
            list->point_set_count += set->is_owned;
            return -1;
        }
    }
    return 0;
}

int lx_emitters_carry(const struct lx_emitters *emitters, const struct lx_frame *frame, const struct lx_asking *asking,
                      struct lx_emitters *carried)
{
    const size_t items = lx_item_count(emitters);
    struct carrying carrying = {.frame = frame, .asking = asking, .carried = carried};
    *carried = *emitters;
    carried->asking = NULL;
    carried->items = lx_new_array(items, sizeof *carried->items);
    carried->point_sets = lx_new_array(emitters->point_set_count, sizeof *carried->point_sets);
    carried->capacity = items;
    carried->point_set_capacity = emitters->point_set_count;
    carried->point_set_count = 0;
    carried->turned = NULL;
    carried->turned_count = 0;
    const int failed = carried->items && carried->point_sets ? carry_all(&carrying, emitters) : -1;
    lx_facets_free(carrying.facets_carried);
    return failed;
}
