/* SPDX-License-Identifier: MIT */
/*
 * Tiles at first: graded towards the edges of each face, and towards the lines where other surfaces stand on it, where
 * the light that is reflected has kinks and jumps.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "between.h"
#include "solution.h"

enum { MOST_LINES = 64 };
/* Cells along a face, or between lines of it, at first. */
enum { MOST_CELLS = 4 };

static int append_tile(struct lx_radiosity *reflected, uint32_t face, const struct lx_window *window)
{
    if (lx_reserve(&reflected->tiles, &reflected->tile_capacity, reflected->tile_count + 1, sizeof *reflected->tiles))
        return -1;
    struct lx_tile *tile = &reflected->tiles[reflected->tile_count++];
    *tile = (struct lx_tile){.face = face, .window = *window};
    lx_cell_make(&reflected->faces[face], window, &tile->cell);
    return 0;
}

/* ---- lines across a face ---- */

struct lines {
    int count;
    double at[MOST_LINES];
};

static void add_line(struct lines *lines, double at)
{
    const double least = 1e-6;
    for (int i = 0; i < lines->count; i++)
        if (fabs(lines->at[i] - at) < least)
            return;
    if (lines->count < MOST_LINES && fabs(at) < 1 - least)
        lines->at[lines->count++] = at;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where corners of other plates touch a plate, along direction `way`. */
static void find_feet(const struct lx_radiosity *reflected, const struct lx_matte_face *face, int way,
                      struct lines *lines)
{
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *other = &reflected->faces[f];
        if (face->sheet.type != LX_SHEET_PLATE || other->sheet.type != LX_SHEET_PLATE ||
            other->surface == face->surface)
            continue;
        for (int k = 0; k < 4; k++) {
            double place[3], normal[3], from[3], at[2];
            lx_sheet_place(&other->sheet, k & 1 ? 1 : -1, k & 2 ? 1 : -1, place, normal);
            for (int i = 0; i < 3; i++)
                from[i] = place[i] - face->sheet.center_mm[i];
            lx_sheet_locate(&face->sheet, place, at);
            if (fabs(lx_dot(from, face->sheet.axis)) < 1e-9 * reflected->size_mm && fabs(at[1 - way]) < 1 + 1e-9)
                add_line(lines, at[way]);
        }
    }
}

/* Cuts from one line to the next, graded towards both. */
static void grade(double low, double high, int cells, struct lines *cuts)
{
    const double power = 3;
    for (int i = 1; i < cells; i++) {
        const double x = (double)i / cells;
        const double at = x < 0.5 ? pow(2 * x, power) / 2 : 1 - pow(2 - 2 * x, power) / 2;
        if (cuts->count < MOST_LINES)
            cuts->at[cuts->count++] = low + at * (high - low);
    }
}

/* The cuts across a face along one of its directions, with both ends. */
static void find_cuts(const struct lx_radiosity *reflected, const struct lx_matte_face *face, int way, double scale_mm,
                      struct lines *cuts)
{
    struct lines lines = {0};
    find_feet(reflected, face, way, &lines);
    qsort(lines.at, (size_t)lines.count, sizeof *lines.at, compare);
    *cuts = (struct lines){.count = 1, .at = {-1}};
    for (int i = 0; i <= lines.count; i++) {
        const double low = i == 0 ? -1 : lines.at[i - 1], high = i == lines.count ? 1 : lines.at[i];
        const double length = (high - low) / 2 * face->size_mm[way] / scale_mm;
        int cells = length > 0.5 ? MOST_CELLS : length > 0.12 ? 2 : 1;
        if (face->sheet.type != LX_SHEET_PLATE && cells > 2)
            cells = 2;
        grade(low, high, cells, cuts);
        if (cuts->count < MOST_LINES)
            cuts->at[cuts->count++] = high;
    }
    cuts->at[cuts->count - 1] = 1;
}

static int cut_face(struct lx_radiosity *reflected, uint32_t f, double scale_mm)
{
    struct lines across, upward;
    find_cuts(reflected, &reflected->faces[f], 0, scale_mm, &across);
    find_cuts(reflected, &reflected->faces[f], 1, scale_mm, &upward);
    for (int i = 0; i + 1 < across.count; i++)
        for (int j = 0; j + 1 < upward.count; j++) {
            const struct lx_window window =
                lx_window_of(across.at[i], across.at[i + 1], upward.at[j], upward.at[j + 1]);
            if (append_tile(reflected, f, &window))
                return -1;
        }
    return 0;
}

/* ---- faces ---- */

static int add_faces(struct lx_radiosity *reflected, size_t s)
{
    const struct lx_prepared_surface *surface = &reflected->prepared->surfaces[s];
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    const int count = lx_shape_sheets(&surface->shape, sheets);
    for (int i = 0; i < count; i++) {
        struct lx_matte_face *face = &reflected->faces[reflected->face_count++];
        lx_face_make(&sheets[i], s, surface->material->diffuse, face);
        reflected->has_round_faces = reflected->has_round_faces || !face->is_flat;
    }
    return 0;
}

/* How far before the plane of a flat face anything of the other one is. */
static double highest_over(const struct lx_matte_face *flat, const struct lx_matte_face *other)
{
    const struct lx_smooth_sheet *plane = &flat->sheet, *sheet = &other->sheet;
    double from[3], reach = other->radius_mm;
    const double *center = other->is_flat ? sheet->center_mm : other->center_mm;
    if (other->is_flat) {
        const double a = lx_dot(plane->axis, sheet->across), b = lx_dot(plane->axis, sheet->upward);
        reach = sheet->type == LX_SHEET_PLATE ? fabs(a) * sheet->half_mm[0] + fabs(b) * sheet->half_mm[1]
                                              : sheet->half_mm[0] * hypot(a, b);
    }
    for (int i = 0; i < 3; i++)
        from[i] = center[i] - plane->center_mm[i];
    return plane->turn * lx_dot(plane->axis, from) + reach;
}

bool lx_faces_meet(const struct lx_matte_face *a, const struct lx_matte_face *b)
{
    const double least = 1e-9;
    if (a->is_flat && highest_over(a, b) <= least * (a->radius_mm + b->radius_mm))
        return false;
    return !(b->is_flat && highest_over(b, a) <= least * (a->radius_mm + b->radius_mm));
}

static int index_tiles(struct lx_radiosity *reflected)
{
    size_t t = 0;
    free(reflected->first_tile);
    reflected->first_tile = lx_new_array(reflected->face_count + 1, sizeof *reflected->first_tile);
    if (!reflected->first_tile)
        return -1;
    for (size_t f = 0; f <= reflected->face_count; f++) {
        while (t < reflected->tile_count && reflected->tiles[t].face < f)
            t++;
        reflected->first_tile[f] = t;
    }
    return 0;
}

int lx_tiling_make(struct lx_radiosity *reflected)
{
    const size_t surfaces = reflected->prepared->surface_count;
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, square = 0, area = 0;
    reflected->faces = lx_new_array(surfaces * LX_MOST_SHEETS, sizeof *reflected->faces);
    if (!reflected->faces)
        return -1;
    for (size_t s = 0; s < surfaces; s++) {
        add_faces(reflected, s);
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], reflected->prepared->surfaces[s].low_mm[i]);
            high[i] = fmax(high[i], reflected->prepared->surfaces[s].high_mm[i]);
        }
    }
    for (int i = 0; i < 3; i++)
        square += (high[i] - low[i]) * (high[i] - low[i]);
    reflected->size_mm = sqrt(square);
    for (size_t f = 0; f < reflected->face_count; f++)
        area = fmax(area, reflected->faces[f].size_mm[0] * reflected->faces[f].size_mm[1]);
    for (size_t f = 0; f < reflected->face_count; f++)
        if (cut_face(reflected, (uint32_t)f, sqrt(area)))
            return -1;
    return index_tiles(reflected);
}

int lx_tiling_cut(struct lx_radiosity *reflected, const uint8_t *cuts)
{
    struct lx_tile *old = reflected->tiles;
    const size_t count = reflected->tile_count;
    int failed = 0;
    reflected->tiles = NULL;
    reflected->tile_count = reflected->tile_capacity = 0;
    for (size_t t = 0; t < count; t++) {
        struct lx_tile *tile = &old[t];
        if (cuts[t] == 0) {
            failed = failed || lx_reserve(&reflected->tiles, &reflected->tile_capacity, reflected->tile_count + 1,
                                          sizeof *reflected->tiles);
            if (!failed)
                reflected->tiles[reflected->tile_count++] = *tile;
            else
                lx_direct_clear(&tile->direct);
            continue;
        }
        lx_direct_clear(&tile->direct);
        for (unsigned i = 0; i < lx_window_parts(cuts[t]) && !failed; i++) {
            const struct lx_window part = lx_window_part(&tile->window, cuts[t], i);
            failed = append_tile(reflected, tile->face, &part);
        }
    }
    free(old);
    return failed ? -1 : index_tiles(reflected);
}

int lx_tiling_drop(struct lx_radiosity *reflected, const uint8_t *is_lit)
{
    uint8_t *stays = lx_new_array(reflected->face_count, sizeof *stays);
    size_t kept = 0, tile = 0;
    if (!stays)
        return -1;
    for (size_t f = 0; f < reflected->face_count; f++) {
        stays[f] = is_lit[f];
        for (size_t g = 0; g < reflected->face_count && !stays[f]; g++)
            stays[f] = g != f && lx_faces_meet(&reflected->faces[f], &reflected->faces[g]);
    }
    for (size_t f = 0; f < reflected->face_count; f++) {
        for (size_t t = reflected->first_tile[f]; t < reflected->first_tile[f + 1]; t++) {
            if (!stays[f]) {
                lx_direct_clear(&reflected->tiles[t].direct);
                continue;
            }
            reflected->tiles[tile] = reflected->tiles[t];
            reflected->tiles[tile++].face = (uint32_t)kept;
        }
        if (stays[f])
            reflected->faces[kept++] = reflected->faces[f];
    }
    free(stays);
    reflected->face_count = kept;
    reflected->tile_count = tile;
    return index_tiles(reflected);
}
