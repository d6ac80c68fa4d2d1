/* SPDX-License-Identifier: MIT */
/* The disk as an emitter, which shines along its axis; as a luminous opening an ellipse, too. */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "elliptic.h"
#include "round.h"

static lx_bounded area(const struct lx_emitter *disk)
{
    const lx_bounded radius = lx_exact(disk->radius_mm);
    return lx_is_elliptic(disk) ? lx_elliptic_area_mm2(disk) : lx_mul(lx_rounded(M_PI, 0, 1), lx_mul(radius, radius));
}

static double section(const struct lx_emitter *disk)
{
    return area(disk).value;
}

static double area_seen(const struct lx_emitter *disk, const double towards[3])
{
    const double axis[3] = {disk->axis.x.value, disk->axis.y.value, disk->axis.z.value};
    return M_PI * disk->radius_mm * disk->radius_mm * fmax(0, lx_dot(axis, towards));
}

static bool plane(const struct lx_emitter *disk, double place_mm[3], double normal[3])
{
    memcpy(place_mm, disk->center_mm, sizeof disk->center_mm);
    normal[0] = disk->axis.x.value, normal[1] = disk->axis.y.value, normal[2] = disk->axis.z.value;
    return true;
}

const struct lx_emitter_kind lx_disk_emitter = {
    .name = "disk",
    .share_seen = 1,
    .area_mm2 = area,
    .section_mm2 = section,
    .area_seen_mm2 = area_seen,
    .touches = lx_round_touches,
    .irradiance = lx_disk_irradiance,
    .cut = lx_disk_cut,
    .extent = lx_round_extent,
    .farthest = lx_round_farthest,
    .plane = plane,
};
