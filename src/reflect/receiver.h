/* SPDX-License-Identifier: MIT */
/* The receiver: a place with a normal that light is reflected to. */
#ifndef LX_REFLECT_RECEIVER_H
#define LX_REFLECT_RECEIVER_H

#include <stdbool.h>
#include <stddef.h>

struct lx_receiver {
    double place_mm[3], normal[3]; /* unit */
    size_t own;                    /* the prepared surface that it lies on; SIZE_MAX: none */
    bool is_turned;                /* its normal is not that of its surface there */
    double smooth_mm;              /* doubts of windows no larger than this cancel */
};

#endif
