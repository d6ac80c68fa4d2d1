/* SPDX-License-Identifier: MIT */
/* Angular patterns as profiles. */
#include "pattern.h"

enum { ISOTROPIC, LAMBERTIAN, COSINE };

const char *const lx_pattern_names[] = {"isotropic", "lambertian", "cosine", NULL};

bool lx_pattern_has_axis(const struct lx_pattern *pattern)
{
    return pattern->shape != ISOTROPIC;
}

struct lx_profile lx_pattern_profile(const struct lx_pattern *pattern, lx_bounded3 axis)
{
    if (pattern->shape == ISOTROPIC)
        return lx_profile_isotropic();
    return lx_profile_cosine(axis, pattern->shape == LAMBERTIAN ? 1 : pattern->exponent);
}
