/* SPDX-License-Identifier: MIT */
/*
 * Circles and the contours made of their arcs, as an element at the origin sees them, in wide numbers.
 *
 * The frame has a along the circle's axis, away from the element, u from the foot of the perpendicular towards the
 * circle's centre, v = a x u.  The centre is (rho, 0, h), a place on the circle r = (rho + R cos w, R sin w, h), and
 *
 *     N.(r x r') = R (-h Nv sin w + (rho Na - h Nu) cos w + R Na),   D = |r|^2 = K + kappa cos w
 *     K = rho^2 + h^2 + R^2,   kappa = 2 rho R,   W = sqrt(K^2 - kappa^2)
 *
 * With lambda = sqrt((K - kappa)/(K + kappa)) the angle 2 atan(lambda tan(w/2)) has the derivative W/D; it lags behind
 * w by delta = 2 atan2((1 - lambda) sin w, 1 + cos w + lambda (1 - cos w)), and
 *
 *     int dw/D = (w - delta)/W,   int cos w dw/D = (K delta/kappa - w kappa/(K + W))/W,
 *     int sin w dw/D = -log(D)/kappa
 *
 * where delta/kappa and the difference of two logarithms over kappa stay good when kappa vanishes: on the axis, far
 * away.  Edge-on (h = 0) nothing special happens.
 */
#ifndef LX_LIGHT_RIM_H
#define LX_LIGHT_RIM_H

#include "../../base/wide.h"

/* A sum of wide terms; `size` is about how large they, and what they were made of, are: the sum is good to
 * LX_SUM_ROUNDING of it. */
struct lx_wide_sum {
    lx_wide value;
    double size;
};

#define LX_SUM_ROUNDING 0x1p-94

struct lx_rim {
    lx_wide rho, height, radius;
    lx_wide3 normal; /* the element's, in the frame; its length may be off 1 by roundings */
    /* the constants of the integrals */
    lx_wide near2, far2, k, kappa, w, lambda, slope; /* slope = (1 - lambda)/kappa */
};

/* A place on a circle by its angle. */
struct lx_mark {
    lx_wide cosine, sine;
};

/* What of a circle is above the element's horizon: N.r = middle + reach cos(w - w0), the arc from rise to set. */
struct lx_horizon {
    lx_wide middle, reach;
    bool crossed;
    struct lx_mark top, rise, set; /* top: w0; not set where reach is 0.  rise, set: where it is crossed */
    lx_wide half_turn;             /* from the top to where it sets */
};

struct lx_rim lx_rim_of(lx_wide rho, lx_wide height, lx_wide radius, lx_wide3 normal);
struct lx_horizon lx_rim_horizon(const struct lx_rim *rim);
lx_wide3 lx_rim_place(const struct lx_rim *rim, struct lx_mark mark);

/* Twice what an arc of so many radians adds to E, times sign. */
void lx_add_arc(struct lx_wide_sum *sum, const struct lx_rim *rim, struct lx_mark from, struct lx_mark to, lx_wide turn,
                double sign);

/* Twice what the way along the horizon adds; `way` is to - from, known better than their difference. */
void lx_add_chord(struct lx_wide_sum *sum, lx_wide3 normal, lx_wide3 from, lx_wide3 to, lx_wide3 way);

/* Twice the irradiance by the disk within the rim (h > 0). */
void lx_add_disk(struct lx_wide_sum *sum, const struct lx_rim *rim, const struct lx_horizon *horizon);

/*
 * The irradiance by a disk that the horizon cuts, and by the side of a cylinder between two rims (rho > R), as
 * integrals over what is seen of them: no term is negative, so that slivers, and far sources, keep their digits, where
 * the contour's terms cancel.  *relative bounds the relative error.
 */
double lx_cut_disk_integral(const struct lx_rim *rim, const struct lx_horizon *horizon, double *relative);
double lx_side_integral(const struct lx_rim rims[2], const struct lx_horizon horizons[2], double *relative);

/* Twice the irradiance by a cylinder of the half height g about (rho, 0, middle), middle >= 0, from outside. */
void lx_add_cylinder(struct lx_wide_sum *sum, lx_wide rho, lx_wide middle, lx_wide radius, lx_wide half_height,
                     lx_wide3 normal);

#endif
