/* SPDX-License-Identifier: MIT */
/* Doubts of direct light, as places nearby have them. */
#include "doubt.h"

#include <math.h>

#include "../base/vector.h"

/* The samples light may be farther off than they tell. */
static const double BETWEEN = 4;
/* Cells farther away than so many of their radii have the kernel of their nodes. */
static const double NEAR = 4;

double lx_kernel_at(const struct lx_receiver *receiver, const double place_mm[3], const double normal[3])
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = place_mm[i] - receiver->place_mm[i];
    bool is_above;
    const double square = lx_dot(way, way), here = lx_receiver_takes(receiver, way, &is_above),
                 there = -lx_dot(normal, way);
    return is_above && there > 0 ? here * there / (M_PI * square * square) : 0;
}

/* On a cell that is not near, and on which normals turn little, the kernel is no greater than a little above that at
 * its nodes. */
double lx_kernel_of_nodes(const struct lx_receiver *receiver, const struct lx_tile_cell *cell)
{
    const double beyond = 1.3;
    double greatest = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        greatest = fmax(greatest, lx_kernel_at(receiver, cell->place_mm[q], cell->normal[q]));
    return beyond * greatest;
}

double lx_greatest_kernel(const struct lx_receiver *receiver, const struct lx_matte_face *face,
                          const struct lx_tile_cell *cell)
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = cell->center_mm[i] - receiver->place_mm[i];
    if (1.5 * cell->radius_mm < fmin(sqrt(lx_dot(way, way)), face->is_flat ? HUGE_VAL : 1.5 * face->sheet.half_mm[0]))
        return lx_kernel_of_nodes(receiver, cell);
    const double here = lx_dot(receiver->normal, way) + cell->radius_mm;
    double least = sqrt(lx_dot(way, way)) - cell->radius_mm, there = HUGE_VAL;
    if (face->is_flat) {
        there = -face->sheet.turn * lx_dot(face->sheet.axis, way);
        least = fmax(least, there);
    }
    if (here <= 0 || there <= 0)
        return 0;
    if (least <= 0)
        return HUGE_VAL;
    const double taken = receiver->response ? lx_response_most(receiver->response) : fmin(here / least, 1);
    return taken * fmin(there / least, 1) / (M_PI * least * least);
}

bool lx_looks_at(const struct lx_receiver *receiver, const struct lx_matte_face *flat)
{
    double down[3], way[3];
    for (int i = 0; i < 3; i++) {
        down[i] = flat->sheet.center_mm[i] - receiver->place_mm[i];
        way[i] = flat->center_mm[i] - receiver->place_mm[i];
    }
    return -flat->sheet.turn * lx_dot(flat->sheet.axis, down) > 0 &&
           lx_dot(receiver->normal, way) + flat->radius_mm > 0;
}

/* No more than so much is told wrongly of what is seen. */
static double most_at(const struct lx_doubt *doubt, double view)
{
    return doubt->greatest * view;
}

/* Windows have their light, and its moments, so that only those count that take a good part of the view. */
double lx_doubt_at(const struct lx_doubt *doubt, double kernel, double view)
{
    double sum = 0;
    if (!(kernel > 0))
        return 0;
    if (doubt->off > 0) {
        const double reach = doubt->reach / doubt->off;
        sum += BETWEEN * doubt->off * kernel * fmin(M_PI * reach * reach * kernel, 1);
    }
    if (doubt->left > 0)
        sum += doubt->left * kernel;
    return fmin(sum, most_at(doubt, view));
}

double lx_doubt_differs(const struct lx_doubt *doubt, double kernel, double view)
{
    return doubt->squares > 0 && kernel > 0 ? fmin(sqrt(doubt->squares) * kernel, most_at(doubt, view)) : 0;
}

void lx_doubt_add(struct lx_doubt *sum, const struct lx_doubt *doubt)
{
    sum->off += doubt->off;
    sum->reach += doubt->reach;
    sum->left += doubt->left;
    sum->squares += doubt->squares;
    sum->greatest = fmax(sum->greatest, doubt->greatest);
}

size_t lx_near_find(const struct lx_near *all, size_t count, const struct lx_matte_face *face,
                    const struct lx_tile_cell *cell, struct lx_near *found)
{
    size_t near = 0;
    for (size_t i = 0; i < count; i++) {
        double square = 0;
        for (int k = 0; k < 3; k++) {
            const double way = cell->center_mm[k] - all[i].receiver.place_mm[k];
            square += way * way;
        }
        if (square < NEAR * NEAR * cell->radius_mm * cell->radius_mm &&
            lx_greatest_kernel(&all[i].receiver, face, cell) > 0)
            found[near++] = all[i];
    }
    return near;
}

bool lx_near_counts(const struct lx_near *near, size_t count, const struct lx_matte_face *face,
                    const struct lx_tile_cell *cell, const struct lx_doubt *doubt)
{
    for (size_t i = 0; i < count; i++) {
        if (cell->radius_mm <= near[i].receiver.smooth_mm)
            continue;
        const double kernel = lx_greatest_kernel(&near[i].receiver, face, cell);
        if (face->reflectance * (lx_doubt_at(doubt, kernel, 1) + lx_doubt_differs(doubt, kernel, 1)) > near[i].least)
            return true;
    }
    return false;
}
