/* SPDX-License-Identifier: MIT */
/* Gathering: what all faces send to one receiver. */
#include <math.h>
#include <string.h>

#include "solution.h"

struct lx_arrival lx_gather(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                            const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                            const double *indirect, const double *slack, struct lx_veils *veils, float *row)
{
    struct lx_arrival sum = {0};
    if (row)
        memset(row, 0, reflected->tile_count * LX_RULE_NODES * sizeof *row);
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        const bool is_own = face->surface == receiver->own && !receiver->is_turned;
        if ((is_own && (face->is_flat || face->sheet.turn > 0)) ||
            !lx_veils_set(prepared, receiver, face, reflected->size_mm, veils))
            continue;
        double value = 0, error = 0;
        for (size_t t = reflected->first_tile[f]; t < reflected->first_tile[f + 1]; t++) {
            const struct lx_tile *tile = &reflected->tiles[t];
            struct lx_sent sent;
            double total = 0;
            lx_transfer(fineness, receiver, veils, face, tile, &sent);
            value += sent.direct;
            for (int q = 0; q < LX_RULE_NODES; q++) {
                const size_t i = t * LX_RULE_NODES + (size_t)q;
                total += fabs(sent.weights[q]);
                sum.seen += sent.weights[q];
                if (indirect)
                    value += sent.weights[q] * indirect[i];
                if (slack)
                    error += fabs(sent.weights[q]) * slack[i];
                if (row)
                    row[i] = (float)sent.weights[q];
            }
            error += total * tile->direct_error;
        }
        sum.value += face->reflectance * value;
        sum.slack += face->reflectance * error;
    }
    return sum;
}
