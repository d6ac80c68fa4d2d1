/* SPDX-License-Identifier: MIT */
/* Regions of the screen: which there may be, and what lies in them. */
#include "region.h"

#include <math.h>

#include "../base/diagnostics.h"

luxel_status lx_region_check(const luxel_region *region, luxel_diagnostics *diagnostics)
{
    if (!region)
        return LUXEL_OK;
    if (LX_CHECK_RESERVE(region, diagnostics) != LUXEL_OK)
        return LUXEL_ERROR_ARGUMENT;
    if (region->type == LUXEL_REGION_ALL)
        return LUXEL_OK;
    bool round = region->type == LUXEL_REGION_CIRCLE, known = round || region->type == LUXEL_REGION_RECTANGLE;
    bool placed = isfinite(region->center_mm[0]) && isfinite(region->center_mm[1]);
    bool sized = round ? region->radius_mm > 0 && isfinite(region->radius_mm)
                       : region->size_mm[0] > 0 && isfinite(region->size_mm[0]) && region->size_mm[1] > 0 &&
                             isfinite(region->size_mm[1]);
    if (known && placed && sized)
        return LUXEL_OK;
    return lx_refuse(diagnostics, LX_MSG_BAD_REGION, NULL);
}

bool luxel_region_holds(const luxel_region *region, double x_mm, double y_mm)
{
    if (!region || region->type == LUXEL_REGION_ALL)
        return true;
    double x = x_mm - region->center_mm[0], y = y_mm - region->center_mm[1];
    if (region->type == LUXEL_REGION_CIRCLE)
        return hypot(x, y) <= region->radius_mm;
    return fabs(x) <= region->size_mm[0] / 2 && fabs(y) <= region->size_mm[1] / 2;
}
