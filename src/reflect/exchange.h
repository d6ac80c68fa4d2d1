/* SPDX-License-Identifier: MIT */
/*
 * Exchange of light: form factors between the sides of surfaces.  Of what side i sends by Lambert's law, evenly from
 * all of it, the share F_ij arrives at side j:
 *
 *     F_ij = 1/A_i integral over A_i, A_j of V cos cos' / (pi r^2) dA dA'
 *
 * From the places of a tile the shares of all sides are the weights of links; over the tile they are integrated by its
 * rule, with the residual between the nodes as the bound, as reflected light is.  A_i F_ij = A_j F_ji makes two numbers
 * of each pair, which have to agree within their bounds.
 */
#ifndef LX_REFLECT_EXCHANGE_H
#define LX_REFLECT_EXCHANGE_H

#include "request.h"

struct lx_exchange_side {
    size_t surface; /* among the prepared ones */
    bool is_flat, is_back;
    double area_m2;
};

struct lx_exchange {
    struct lx_exchange_side *sides;
    size_t count;
    lx_bounded *factors; /* count x count */
    bool reached;        /* all errors are at most the request's */
};

/*
 * Finds the factors of the request's scene; its error is a share of what a side sends, and places and lights are not
 * asked.  Inner sides of closed bodies are left out, and outer ones of what looks inwards where nothing else may be
 * seen from them.
 * LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED; cleared by lx_exchange_clear() in any case.
 */
luxel_status lx_exchange_make(const struct lx_reflected_request *request, struct lx_exchange *exchange);
void lx_exchange_clear(struct lx_exchange *exchange);

#endif
