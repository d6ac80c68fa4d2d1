/* SPDX-License-Identifier: MIT */
/* The names that the files of sheets share: how many sectors go around, and the rims of types. */
#ifndef LX_SURFACE_SHEET_TYPES_H
#define LX_SURFACE_SHEET_TYPES_H

#include <math.h>

#include "sheet.h"

enum { LX_SECTORS = 4 };
#define LX_SECTOR (M_PI / LX_SECTORS) /* half of one */

/* Members of types: sheet_rims.c. */
void lx_rim_of_plate(const struct lx_smooth_sheet *plate, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                     void *data);
void lx_rim_of_disk(const struct lx_smooth_sheet *disk, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data);
void lx_rim_of_tube(const struct lx_smooth_sheet *tube, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data);
void lx_rim_of_ball(const struct lx_smooth_sheet *ball, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data);

#endif
