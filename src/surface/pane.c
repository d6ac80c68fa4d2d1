/* SPDX-License-Identifier: MIT */
/* What glass lets through. */
#include "pane.h"

#include <float.h>
#include <math.h>

#include "../base/vector.h"

struct lx_glass_pane lx_pane_carried(const struct lx_glass_pane *pane, const struct lx_frame *frame)
{
    struct lx_glass_pane carried = *pane;
    lx_frame_carry(frame, pane->center_mm, carried.center_mm);
    lx_frame_turn(frame, pane->across, carried.across);
    lx_frame_turn(frame, pane->upward, carried.upward);
    lx_frame_turn(frame, pane->axis, carried.axis);
    lx_frame_carry(frame, pane->room_center_mm, carried.room_center_mm);
    for (int i = 0; i < 3; i++)
        lx_frame_turn(frame, pane->room_axes[i], carried.room_axes[i]);
    return carried;
}

void lx_pane_edges(const struct lx_glass_pane *pane, const double place_mm[3], double inwards[LX_RIM][3])
{
    double corners[LX_RIM][3], middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = pane->center_mm[k] - place_mm[k];
    for (int i = 0; i < LX_RIM; i++)
        for (int k = 0; k < 3; k++)
            corners[i][k] = middle[k] + (i == 0 || i == 3 ? 1 : -1) * pane->half_mm[0] * pane->across[k] +
                            (i < 2 ? 1 : -1) * pane->half_mm[1] * pane->upward[k];
    for (int i = 0; i < LX_RIM; i++) {
        lx_cross(corners[i], corners[(i + 1) % LX_RIM], inwards[i]);
        lx_normalize(inwards[i]);
        for (int k = 0, is_turned = lx_dot(inwards[i], middle) < 0; k < 3 && is_turned; k++)
            inwards[i][k] = -inwards[i][k];
    }
}

/* What of one polarization comes through two faces that reflect so much each. */
static double through(double reflected, double left)
{
    return (1 - reflected) * (1 - reflected) * left / (1 - reflected * reflected * left * left);
}

double lx_pane_transmittance(const struct lx_glass_pane *pane, double cosine)
{
    const double n = pane->index, sine = (1 - cosine) * (1 + cosine) / (n * n), within = sqrt(fmax(1 - sine, 0));
    if (!(cosine > 0) || !(within > 0))
        return 0;
    const double left = pow(pane->transmittance, 1 / within);
    const double across = (cosine - n * within) / (cosine + n * within);
    const double along = (n * cosine - within) / (n * cosine + within);
    return (through(across * across, left) + through(along * along, left)) / 2;
}

double lx_panes_pass(const struct lx_glass_pane *panes, size_t count, const struct lx_glass_pane *through,
                     const double place_mm[3], const double way[3], bool endless)
{
    double passed = 1;
    for (size_t i = 0; i < count; i++) {
        const struct lx_glass_pane *pane = &panes[i];
        double from[3], met[3];
        if (!(pane->index > 0) || (through && pane != through && pane->surface == through->surface))
            continue;
        if (pane == through) {
            passed *= lx_pane_transmittance(pane, fabs(lx_dot(way, pane->axis)) / sqrt(lx_dot(way, way)));
            continue;
        }
        for (int k = 0; k < 3; k++)
            from[k] = place_mm[k] - pane->center_mm[k];
        const double height = lx_dot(from, pane->axis), change = lx_dot(way, pane->axis), share = -height / change;
        if (!(share > 0) || (!endless && share > 1))
            continue;
        for (int k = 0; k < 3; k++)
            met[k] = from[k] + share * way[k];
        if (fabs(lx_dot(met, pane->across)) <= pane->half_mm[0] && fabs(lx_dot(met, pane->upward)) <= pane->half_mm[1])
            passed *= lx_pane_transmittance(pane, fabs(change) / sqrt(lx_dot(way, way)));
    }
    return passed;
}
