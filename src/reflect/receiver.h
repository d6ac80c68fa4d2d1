/* SPDX-License-Identifier: MIT */
/* The receiver: a place with a normal that light is reflected to, and how it counts there. */
#ifndef LX_REFLECT_RECEIVER_H
#define LX_REFLECT_RECEIVER_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/vector.h"
#include "../material/measure.h"
#include "../world/element.h"
#include "../world/prepared.h"

struct lx_receiver {
    double place_mm[3], normal[3];      /* unit */
    size_t own;                         /* the prepared surface that it lies on; SIZE_MAX: none */
    bool is_turned;                     /* its normal is not that of its surface there */
    double smooth_mm;                   /* doubts of windows no larger than this cancel */
    const struct lx_response *response; /* by which light from above counts; NULL: the cosine */
};

/* The cosine, or what counts in its place, times the length of a way; *is_above: whether it leads above the horizon. */
static inline double lx_receiver_takes(const struct lx_receiver *receiver, const double way[3], bool *is_above)
{
    const double height = lx_dot(receiver->normal, way);
    *is_above = height > 0;
    return receiver->response ? lx_response_along(receiver->response, way) : height;
}

/* The receiver of an element. */
struct lx_receiver lx_receiver_of(const struct lx_prepared *prepared, const struct lx_element *element);

/* Those of an element by a response, whose sum it receives: one for what is above its horizon and one for what is
 * below, unless it lies on a surface.  Without a response there is the one of the element.  Returns how many. */
enum { LX_MOST_RECEIVERS = 2 };
size_t lx_receivers_of(const struct lx_prepared *prepared, const struct lx_element *element,
                       const struct lx_response *response, struct lx_receiver receivers[LX_MOST_RECEIVERS]);

#endif
