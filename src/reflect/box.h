/* SPDX-License-Identifier: MIT */
/*
 * Closed boxes: furniture of plates.  Six rectangles that plates fill, or cover, as a floor does that the box stands
 * on, keep what is inside from what is outside: seen from outside, the sides that are turned away hide nothing that the
 * others do not, and where it is dark inside the inner sides take no part.
 */
#ifndef LX_REFLECT_BOX_H
#define LX_REFLECT_BOX_H

#include "closed_box.h"

struct lx_radiosity;
struct lx_matte_face;

/* Finds the boxes of the prepared scene; 0, or -1: memory ran out. */
int lx_closed_boxes_find(struct lx_radiosity *reflected);
void lx_closed_boxes_clear(struct lx_closed_boxes *boxes);

/* Whether a surface is a side of a box that has the place outside and before another side. */
bool lx_closed_boxes_turn_away(const struct lx_closed_boxes *boxes, size_t surface, const double place_mm[3]);

/* Whether a place is inside a box and all of a face outside. */
bool lx_closed_boxes_part(const struct lx_closed_boxes *boxes, const double place_mm[3],
                          const struct lx_matte_face *face);

/* Takes the inner sides of boxes that are dark inside from the faces that stay. */
void lx_closed_boxes_darken(const struct lx_radiosity *reflected, bool *stays);

#endif
