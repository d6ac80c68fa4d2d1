/* SPDX-License-Identifier: MIT */
/*
 * Jets: what is known of a function of directions over some of them, by bounds of its value and of its first and second
 * derivatives on the unit sphere.  The jet of a product is made of those of its factors.
 */
#ifndef LX_PICTURE_JET_H
#define LX_PICTURE_JET_H

#include "../../light/emitter.h"

/*
 * How far the derivatives go.
 *
 * smooth  there are second ones, or they jump
 * folded  max(0, f) of a smooth f, or that times something smooth; the bounds, but for the value, are those of f
 * steep   only first ones
 * rough   not even these
 */
enum lx_jet_order { LX_SMOOTH, LX_FOLDED, LX_STEEP, LX_ROUGH };

struct lx_jet {
    enum lx_jet_order order;
    double least, most; /* the value, which is never below 0 */
    double size;        /* no value, and none of f, is larger */
    double slope, bend; /* largest lengths of the gradient, and of the matrix of second derivatives */
};

struct lx_jet lx_jet_of_constant(double value);
struct lx_jet lx_jet_times(const struct lx_jet *a, const struct lx_jet *b);

/* Some cosines. */
struct lx_cosines {
    double least, most;
};

/* What is known of max(0, cos)^exponent on the whole sphere: its largest slope and bend, and at which cosines. */
struct lx_power {
    double exponent;
    unsigned whole; /* the same where it is whole and not very large; else 0 */
    double slope, bend, slope_cosine, bend_cosine;
};

struct lx_power lx_power_of(double exponent);

/* max(0, cos)^exponent of the angle from an axis, for those cosines of it. */
struct lx_jet lx_jet_of_power(const struct lx_power *power, struct lx_cosines cosines);

/* The cone of a profile, likewise. */
struct lx_jet lx_jet_of_cone(const struct lx_profile *profile, struct lx_cosines cosines);

#endif
