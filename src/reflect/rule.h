/* SPDX-License-Identifier: MIT */
/*
 * The rule of Gauss on a square: ORDER x ORDER nodes, polynomials by their values there, and their values at other
 * places.  Node q = ORDER i + j is at (place[i], place[j]).
 */
#ifndef LX_REFLECT_RULE_H
#define LX_REFLECT_RULE_H

enum { LX_ORDER = 4, LX_RULE_NODES = LX_ORDER * LX_ORDER };

#define LX_RULE_OUTER 0.86113631159405257522
#define LX_RULE_INNER 0.33998104358485626480
#define LX_RULE_OUTER_WEIGHT 0.34785484513745385737
#define LX_RULE_INNER_WEIGHT 0.65214515486254614263

static const double lx_rule_places[LX_ORDER] = {-LX_RULE_OUTER, -LX_RULE_INNER, LX_RULE_INNER, LX_RULE_OUTER};
static const double lx_rule_weights[LX_ORDER] = {LX_RULE_OUTER_WEIGHT, LX_RULE_INNER_WEIGHT, LX_RULE_INNER_WEIGHT,
                                                 LX_RULE_OUTER_WEIGHT};

/* The polynomials that are 1 at one node and 0 at the others, at x; the nodes lie in pairs. */
static inline void lx_rule_basis(double x, double basis[LX_ORDER])
{
    const double outer = LX_RULE_OUTER, inner = LX_RULE_INNER, apart = outer * outer - inner * inner;
    const double beyond = (x * x - outer * outer) / (-apart * 2 * inner),
                 within = (x * x - inner * inner) / (apart * 2 * outer);
    basis[0] = within * (outer - x);
    basis[1] = beyond * (inner - x);
    basis[2] = beyond * (inner + x);
    basis[3] = within * (outer + x);
}

/* The polynomial with these values at the nodes, at (x, y). */
static inline double lx_rule_value(const double nodes[LX_RULE_NODES], double x, double y)
{
    double across[LX_ORDER], upward[LX_ORDER], sum = 0;
    lx_rule_basis(x, across);
    lx_rule_basis(y, upward);
    for (int i = 0; i < LX_ORDER; i++) {
        double row = 0;
        for (int j = 0; j < LX_ORDER; j++)
            row += upward[j] * nodes[LX_ORDER * i + j];
        sum += across[i] * row;
    }
    return sum;
}

/* A rectangle of coordinates: its middle and half its sides. */
struct lx_window {
    double middle[2], half[2];
};

/* Quarter i of a window; half i of it, cut across direction `way`. */
static inline struct lx_window lx_window_quarter(const struct lx_window *window, int i)
{
    struct lx_window made = *window;
    for (int k = 0; k < 2; k++) {
        made.half[k] /= 2;
        made.middle[k] += (i >> k & 1 ? 1 : -1) * made.half[k];
    }
    return made;
}

static inline struct lx_window lx_window_half(const struct lx_window *window, int way, int i)
{
    struct lx_window made = *window;
    made.half[way] /= 2;
    made.middle[way] += (i ? 1 : -1) * made.half[way];
    return made;
}

/* How small cells have to be, as shares of their distance, or of what normals turn within: those that are seen, those
 * whose direct light is rough, or most of it on a small part of them, and those seen in part, flat and round;
 * groups. */
struct lx_fineness {
    double seen, rough, narrow, flat_part, round_part, group;
    bool has_details; /* light is asked in all detail where a part of it is seen */
    bool is_of_nodes; /* no places are asked: kernels at nodes stand for the greatest on windows of direct light */
};

#endif
