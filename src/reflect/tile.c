/* SPDX-License-Identifier: MIT */
/* Faces and cells: where they lie, and the nodes of Gauss's rule on them. */
#include "tile.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

static void bound_straight(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    struct lx_sheet_part part;
    double normal[3];
    lx_sheet_place(&face->sheet, window->middle[0], window->middle[1], cell->center_mm, normal);
    face->sheet.type->part(&face->sheet, window->middle, window->half, &part);
    memcpy(cell->first_mm, part.first_mm, sizeof cell->first_mm);
    memcpy(cell->second_mm, part.second_mm, sizeof cell->second_mm);
    memcpy(cell->lengths_mm, part.lengths_mm, sizeof cell->lengths_mm);
    cell->radius_mm = part.radius_mm;
    cell->narrow = part.narrow;
}

/* Curved cells are within the ball around their middle that holds the corners and the middles of their edges, but for
 * what bulges. */
static void bound_round(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    const double room = 1.05;
    double normal[3], place[3];
    struct lx_sheet_line lines[2][3];
    for (int way = 0; way < 2; way++)
        for (int k = 0; k < 3; k++)
            lines[way][k] = lx_sheet_line(&face->sheet, way, window->middle[way] + (k - 1) * window->half[way]);
    lx_sheet_cross(&face->sheet, &lines[0][1], &lines[1][1], cell->center_mm, normal);
    memset(cell->first_mm, 0, sizeof cell->first_mm);
    memset(cell->second_mm, 0, sizeof cell->second_mm);
    cell->narrow = 1;
    cell->radius_mm = cell->lengths_mm[0] = cell->lengths_mm[1] = 0;
    for (int i = 0; i < 9; i++) {
        lx_sheet_cross(&face->sheet, &lines[0][i % 3], &lines[1][i / 3], place, normal);
        const double away = distance(place, cell->center_mm);
        cell->radius_mm = fmax(cell->radius_mm, room * away);
        if (i / 3 == 1)
            cell->lengths_mm[0] = fmax(cell->lengths_mm[0], away);
        if (i % 3 == 1)
            cell->lengths_mm[1] = fmax(cell->lengths_mm[1], away);
    }
}

void lx_cell_bound(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    if (lx_is_polygon(face))
        bound_straight(face, window, cell);
    else
        bound_round(face, window, cell);
}

/*
 * The rule knows areas of balls to 1e-7 of large cells, which light that goes to and fro in them adds up, in all places
 * alike, so that no residual shows it: weights are scaled to the area that is known.  Of small cells it has all digits.
 */
static void scale_to_area(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    const double least = 1.0 / 64;
    if (fmax(window->half[0], window->half[1]) < least)
        return;
    double low[2], high[2], sum = 0;
    for (int k = 0; k < 2; k++)
        low[k] = window->middle[k] - window->half[k], high[k] = window->middle[k] + window->half[k];
    for (int q = 0; q < LX_RULE_NODES; q++)
        sum += cell->area[q];
    const double scale = face->sheet.type->area(&face->sheet, low, high) / sum;
    for (int q = 0; q < LX_RULE_NODES; q++)
        cell->area[q] *= scale;
}

void lx_cell_nodes(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    const double share = window->half[0] * window->half[1];
    struct lx_sheet_line lines[2][LX_ORDER];
    for (int way = 0; way < 2; way++)
        for (int k = 0; k < LX_ORDER; k++)
            lines[way][k] =
                lx_sheet_line(&face->sheet, way, window->middle[way] + window->half[way] * lx_rule_places[k]);
    for (int i = 0; i < LX_ORDER; i++)
        for (int j = 0; j < LX_ORDER; j++) {
            const int q = LX_ORDER * i + j;
            cell->area[q] =
                share * lx_rule_weights[i] * lx_rule_weights[j] *
                lx_sheet_cross(&face->sheet, &lines[0][i], &lines[1][j], cell->place_mm[q], cell->normal[q]);
        }
    if (face->sheet.type->area)
        scale_to_area(face, window, cell);
}

void lx_cell_make(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell)
{
    lx_cell_bound(face, window, cell);
    lx_cell_nodes(face, window, cell);
}

double lx_face_reach(const struct lx_matte_face *face, const double axis[3], const double from_mm[3])
{
    const struct lx_smooth_sheet *sheet = &face->sheet;
    const double *center = face->is_flat ? sheet->center_mm : face->center_mm;
    return lx_dot(axis, center) - lx_dot(axis, from_mm) +
           (face->is_flat ? sheet->type->reach(sheet, axis) : face->radius_mm);
}

void lx_face_make(const struct lx_smooth_sheet *sheet, size_t surface, double reflectance, struct lx_matte_face *face)
{
    const struct lx_window whole = {{0, 0}, {1, 1}};
    *face = (struct lx_matte_face){.sheet = *sheet, .surface = surface, .reflectance = reflectance};
    face->is_flat = sheet->type->bends == 0;
    lx_cell_bound(face, &whole, &face->cell);
    memcpy(face->center_mm, face->cell.center_mm, sizeof face->center_mm);
    face->radius_mm = face->cell.radius_mm;
    for (int k = 0; k < 2; k++)
        face->size_mm[k] = 2 * face->cell.lengths_mm[k];
}

double lx_cell_area(const struct lx_tile_cell *cell)
{
    double area = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        area += cell->area[q];
    return area;
}

double lx_tile_area(const struct lx_tile *tile)
{
    return lx_cell_area(&tile->cell);
}

double lx_tile_unsure(const struct lx_tile *tile)
{
    double light = 0;
    for (int q = 0; q < LX_RULE_NODES && tile->is_overlaid; q++)
        light += tile->cell.area[q] * fabs(tile->direct.nodes[q]);
    return tile->direct_error + light / lx_tile_area(tile);
}

double lx_tile_unsure_at(const struct lx_tile *tile, int q)
{
    double local = 0;
    for (int k = 0; k < LX_RULE_NODES; k++)
        local += tile->local_error[k];
    return lx_tile_unsure(tile) - local / lx_tile_area(tile) + tile->local_error[q] / tile->cell.area[q];
}
