/* SPDX-License-Identifier: MIT */
/* Trees of groups: making, cutting, and what stands for the light of all tiles of a group. */
#include "group.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "between.h"
#include "links.h"
#include "solution.h"

void lx_tile_clear(struct lx_tile *tile)
{
    lx_direct_clear(&tile->direct);
    lx_rows_free(tile->rows);
    tile->rows = NULL;
}

/* ---- making ---- */

uint32_t lx_group_add(struct lx_radiosity *reflected, uint32_t face, uint32_t parent, const struct lx_window *window)
{
    if (lx_reserve(&reflected->groups, &reflected->group_capacity, reflected->group_count + 1,
                   sizeof *reflected->groups))
        return LX_NO_GROUP;
    const uint32_t made = (uint32_t)reflected->group_count++;
    struct lx_group *group = &reflected->groups[made];
    *group = (struct lx_group){.face = face,
                               .parent = parent,
                               .child = LX_NO_GROUP,
                               .sibling = LX_NO_GROUP,
                               .first_tile = UINT32_MAX,
                               .window = *window};
    lx_cell_make(&reflected->faces[face], window, &group->cell);
    if (parent == LX_NO_GROUP) {
        reflected->faces[face].group = made;
        return made;
    }
    uint32_t *link = &reflected->groups[parent].child;
    while (*link != LX_NO_GROUP)
        link = &reflected->groups[*link].sibling;
    *link = made;
    const struct lx_window *whole = &reflected->groups[parent].window;
    for (int k = 0; k < LX_ORDER; k++) {
        lx_rule_basis((window->middle[0] + window->half[0] * lx_rule_places[k] - whole->middle[0]) / whole->half[0],
                      group->across[k]);
        lx_rule_basis((window->middle[1] + window->half[1] * lx_rule_places[k] - whole->middle[1]) / whole->half[1],
                      group->upward[k]);
    }
    return made;
}

uint32_t lx_group_after(const struct lx_radiosity *reflected, uint32_t group)
{
    while (group != LX_NO_GROUP && reflected->groups[group].sibling == LX_NO_GROUP)
        group = reflected->groups[group].parent;
    return group == LX_NO_GROUP ? group : reflected->groups[group].sibling;
}

/* ---- tiles ---- */

/* Parts of a tile have what is known of it. */
static void inherit(const struct lx_tile *whole, const struct lx_group *group, struct lx_tile *tile)
{
    tile->has_past = true;
    tile->past_error = whole->past_error;
    for (int i = 0; i < LX_ORDER; i++)
        for (int j = 0; j < LX_ORDER; j++)
            for (int k = 0; k < LX_RULE_NODES; k++)
                tile->past[LX_ORDER * i + j] +=
                    group->across[i][k / LX_ORDER] * group->upward[j][k % LX_ORDER] * whole->past[k];
}

static int append_tile(struct lx_radiosity *reflected, struct lx_group *group, struct lx_tile *old,
                       const struct lx_tile *whole)
{
    if (lx_reserve(&reflected->tiles, &reflected->tile_capacity, reflected->tile_count + 1, sizeof *reflected->tiles))
        return -1;
    struct lx_tile *tile = &reflected->tiles[reflected->tile_count];
    if (group->first_tile != UINT32_MAX) {
        *tile = old[group->first_tile];
        tile->face = group->face;
        old[group->first_tile].direct.quarters = NULL;
        old[group->first_tile].rows = NULL;
    } else {
        *tile = (struct lx_tile){.face = group->face, .window = group->window, .cell = group->cell};
        if (whole && whole->has_past)
            inherit(whole, group, tile);
    }
    tile->group = (uint32_t)(group - reflected->groups);
    group->first_tile = (uint32_t)reflected->tile_count++;
    group->tile_count = 1;
    return 0;
}

int lx_groups_number(struct lx_radiosity *reflected)
{
    struct lx_tile *old = reflected->tiles;
    const size_t count = reflected->tile_count;
    int failed = 0;
    reflected->tiles = NULL;
    reflected->tile_count = reflected->tile_capacity = 0;
    free(reflected->first_tile);
    reflected->first_tile = lx_new_array(reflected->face_count + 1, sizeof *reflected->first_tile);
    if (!reflected->first_tile)
        failed = -1;
    for (size_t f = 0; f < reflected->face_count && !failed; f++) {
        const struct lx_tile *whole = NULL; /* that has been cut */
        reflected->first_tile[f] = reflected->tile_count;
        for (uint32_t g = reflected->faces[f].group; g != LX_NO_GROUP && !failed;) {
            struct lx_group *group = &reflected->groups[g];
            if (group->child != LX_NO_GROUP) {
                whole = group->tile_count == 1 ? &old[group->first_tile] : NULL;
                group->first_tile = (uint32_t)reflected->tile_count;
                g = group->child;
                continue;
            }
            failed = append_tile(reflected, group, old, whole);
            g = lx_group_after(reflected, g);
        }
    }
    if (!failed)
        reflected->first_tile[reflected->face_count] = reflected->tile_count;
    for (size_t g = reflected->group_count; g-- > 0 && !failed;) {
        struct lx_group *group = &reflected->groups[g];
        if (group->child == LX_NO_GROUP)
            continue;
        group->tile_count = 0;
        for (uint32_t c = group->child; c != LX_NO_GROUP; c = reflected->groups[c].sibling)
            group->tile_count += reflected->groups[c].tile_count;
    }
    for (size_t t = 0; t < count; t++)
        lx_tile_clear(&old[t]);
    free(old);
    return failed;
}

int lx_groups_cut(struct lx_radiosity *reflected, const bool *cuts)
{
    const size_t count = reflected->group_count;
    for (uint32_t g = 0; g < count; g++) {
        const uint32_t t = reflected->groups[g].first_tile;
        if (reflected->groups[g].child != LX_NO_GROUP || !cuts[t])
            continue;
        const struct lx_window whole = reflected->groups[g].window;
        const struct lx_cuts where = lx_between_cuts(reflected->tiles[t].residual);
        for (unsigned i = 0; i < lx_window_parts(&where); i++) {
            const struct lx_window part = lx_window_part(&whole, &where, i);
            if (lx_group_add(reflected, reflected->groups[g].face, g, &part) == LX_NO_GROUP)
                return -1;
        }
    }
    return lx_groups_number(reflected);
}

/* Groups of a face follow each other as long as nothing has been cut. */
int lx_groups_drop(struct lx_radiosity *reflected, const bool *stays)
{
    size_t kept = 0, faces = 0;
    for (size_t g = 0; g < reflected->group_count; g++) {
        const size_t shift = g - kept;
        struct lx_group *group = &reflected->groups[kept];
        *group = reflected->groups[g];
        if (!stays[group->face])
            continue;
        uint32_t *const links[] = {&group->parent, &group->child, &group->sibling};
        for (int k = 0; k < 3; k++)
            *links[k] -= *links[k] == LX_NO_GROUP ? 0 : (uint32_t)shift;
        if (group->parent == LX_NO_GROUP)
            reflected->faces[group->face].group = (uint32_t)kept;
        kept++;
    }
    reflected->group_count = kept;
    for (size_t f = 0; f < reflected->face_count; f++) {
        if (!stays[f])
            continue;
        reflected->faces[faces] = reflected->faces[f];
        for (uint32_t g = reflected->faces[faces].group; g < kept && reflected->groups[g].face == f; g++)
            reflected->groups[g].face = (uint32_t)faces;
        faces++;
    }
    reflected->face_count = faces;
    return lx_groups_number(reflected);
}

/* ---- light ---- */

/* Adds what stands for values at the nodes of a group at those of its parent, there still times its areas. */
static void lift(const struct lx_group *group, const double *values, double *parent)
{
    for (int i = 0; i < LX_ORDER; i++) {
        double row[LX_ORDER] = {0};
        for (int j = 0; j < LX_ORDER; j++) {
            const int q = LX_ORDER * i + j;
            const double moment = values[q] * group->cell.area[q];
            for (int l = 0; l < LX_ORDER; l++)
                row[l] += moment * group->upward[j][l];
        }
        for (int k = 0; k < LX_ORDER; k++)
            for (int l = 0; l < LX_ORDER; l++)
                parent[LX_ORDER * k + l] += group->across[i][k] * row[l];
    }
}

/* From the last group to the first: all that is in a group comes before it. */
void lx_groups_lift(const struct lx_radiosity *reflected, const double *tiles, double *groups)
{
    memset(groups, 0, reflected->group_count * LX_RULE_NODES * sizeof *groups);
    for (size_t g = reflected->group_count; g-- > 0;) {
        const struct lx_group *group = &reflected->groups[g];
        double *values = groups + g * LX_RULE_NODES;
        if (group->child == LX_NO_GROUP)
            memcpy(values, tiles + group->first_tile * LX_RULE_NODES, LX_RULE_NODES * sizeof *values);
        else
            for (int q = 0; q < LX_RULE_NODES; q++)
                values[q] /= group->cell.area[q];
        if (group->parent != LX_NO_GROUP)
            lift(group, values, groups + group->parent * LX_RULE_NODES);
    }
}

int lx_groups_light(struct lx_radiosity *reflected)
{
    double *tiles = lx_new_array(reflected->tile_count * LX_RULE_NODES, sizeof *tiles);
    double *groups = lx_new_array(reflected->group_count * LX_RULE_NODES, sizeof *groups);
    const int failed = tiles && groups ? 0 : -1;
    for (size_t t = 0; t < reflected->tile_count && !failed; t++)
        memcpy(tiles + t * LX_RULE_NODES, reflected->tiles[t].direct.nodes, sizeof reflected->tiles[t].direct.nodes);
    if (!failed)
        lx_groups_lift(reflected, tiles, groups);
    for (size_t g = reflected->group_count; g-- > 0 && !failed;) {
        struct lx_group *group = &reflected->groups[g];
        memcpy(group->direct, groups + g * LX_RULE_NODES, sizeof group->direct);
        group->unsure = 0;
        for (size_t t = group->first_tile; t < group->first_tile + group->tile_count; t++)
            group->unsure += lx_tile_unsure(&reflected->tiles[t]) * lx_tile_area(&reflected->tiles[t]);
    }
    free(tiles);
    free(groups);
    return failed;
}
