/* SPDX-License-Identifier: MIT */
/* Copies of solutions under way, which stand while the work goes on with finer tiles. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "group.h"
#include "reflected.h"
#include "solution.h"

/* A copy of items in memory of its own; none are copied as none. */
static void *copy_items(const void *items, size_t count, size_t size, bool *failed)
{
    void *copied = items ? lx_new_array(count, size) : NULL;
    if (copied && count > 0)
        memcpy(copied, items, count * size);
    *failed = *failed || (items && !copied);
    return copied;
}

static void copy_direct(const struct lx_direct *direct, struct lx_direct *copied, bool *failed)
{
    *copied = *direct;
    copied->quarters = copy_items(direct->quarters, 4, sizeof *direct->quarters, failed);
    for (int i = 0; copied->quarters && i < 4; i++)
        copy_direct(&direct->quarters[i], &copied->quarters[i], failed);
}

static void copy_tiles(const struct lx_radiosity *reflected, struct lx_radiosity *copied, bool *failed)
{
    copied->tiles = copy_items(reflected->tiles, reflected->tile_count, sizeof *copied->tiles, failed);
    copied->tile_capacity = copied->tile_count = copied->tiles ? reflected->tile_count : 0;
    for (size_t t = 0; t < copied->tile_count; t++) {
        copied->tiles[t].rows = NULL;
        copy_direct(&reflected->tiles[t].direct, &copied->tiles[t].direct, failed);
    }
    copied->parts = copy_items(reflected->parts, reflected->part_count, sizeof *copied->parts, failed);
    copied->part_capacity = copied->part_count = copied->parts ? reflected->part_count : 0;
    for (size_t p = 0; p < copied->part_count; p++)
        copied->parts[p].rows = NULL;
}

/* Numbers at the nodes of tiles or groups. */
static void copy_nodes(const struct lx_radiosity *reflected, struct lx_radiosity *copied, bool *failed)
{
    const size_t tiles = reflected->tile_count * LX_RULE_NODES, groups = reflected->group_count * LX_RULE_NODES;
    copied->indirect = copy_items(reflected->indirect, tiles, sizeof(double), failed);
    copied->before = copy_items(reflected->before, tiles, sizeof(double), failed);
    copied->slack = copy_items(reflected->slack, tiles, sizeof(double), failed);
    copied->slack_before = copy_items(reflected->slack_before, tiles, sizeof(double), failed);
    copied->seen = copy_items(reflected->seen, tiles, sizeof(double), failed);
    copied->sent = copy_items(reflected->sent, groups, sizeof(double), failed);
    copied->sent_slack = copy_items(reflected->sent_slack, groups, sizeof(double), failed);
}

struct lx_radiosity *lx_reflected_copy(const struct lx_radiosity *reflected)
{
    struct lx_radiosity *copied = lx_new_array(1, sizeof *copied);
    bool failed = false;
    if (!copied)
        return NULL;
    *copied = *reflected;
    lx_kept_init(&copied->kept, reflected->kept.end);
    copied->sampling.beams = (struct lx_beams){0}; /* for what is sampled anew */
    copied->sampling.outlines = (struct lx_outlines){0};
    copied->sampling.folds = (struct lx_folds){0};
    copied->efforts = NULL;
    copied->effort_capacity = 0;
    copied->order = NULL;
    copied->key.on = copied->on = copy_items(reflected->on, reflected->light_count, sizeof *copied->on, &failed);
    copied->near = copy_items(reflected->near, reflected->near_count, sizeof *copied->near, &failed);
    copied->near_capacity = copied->near_count;
    copied->faces = copy_items(reflected->faces, reflected->face_count, sizeof *copied->faces, &failed);
    copied->left_out =
        copy_items(reflected->left_out, reflected->left_out_count, sizeof *copied->left_out, &failed);
    copied->boxes.items =
        copy_items(reflected->boxes.items, reflected->boxes.count, sizeof *copied->boxes.items, &failed);
    copied->boxes.capacity = copied->boxes.count;
    copied->boxes.sides =
        copy_items(reflected->boxes.sides, reflected->prepared->surface_count, sizeof *copied->boxes.sides, &failed);
    copied->groups = copy_items(reflected->groups, reflected->group_count, sizeof *copied->groups, &failed);
    copied->group_capacity = copied->group_count;
    copied->first_tile =
        copy_items(reflected->first_tile, reflected->face_count + 1, sizeof *copied->first_tile, &failed);
    copy_tiles(reflected, copied, &failed);
    copy_nodes(reflected, copied, &failed);
    if (!failed)
        return copied;
    lx_reflected_free(copied);
    return NULL;
}
