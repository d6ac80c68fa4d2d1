/* SPDX-License-Identifier: MIT */
/* The lobe of measures: f is made of |A x L| or 1, and of V.L or nothing; the factor is 1/pi or 1/4. */
#include <math.h>

#include "../base/vector.h"
#include "measure.h"

const char *const lx_measure_names[] = {"plane", "cylindrical", "semicylindrical", "spherical", "hemispherical", NULL};

static bool is_by_sine(enum lx_measure measure)
{
    return measure == LX_MEASURE_CYLINDRICAL || measure == LX_MEASURE_SEMICYLINDRICAL;
}

static bool is_one_sided(enum lx_measure measure)
{
    return measure == LX_MEASURE_SEMICYLINDRICAL || measure == LX_MEASURE_HEMISPHERICAL;
}

struct lx_lobe lx_lobe_of_measure(enum lx_measure measure, bool above)
{
    if (measure == LX_MEASURE_PLANE)
        return lx_lobe_irradiance();
    return (struct lx_lobe){
        .model = LX_MEASURE,
        .highlight = above ? LX_HIGHLIGHT_GATED : LX_HIGHLIGHT_PLAIN,
        .diffuse = lx_exact(0),
        .specular = is_by_sine(measure) ? lx_rounded(M_1_PI, 0, 1) : lx_exact(0.25),
        .ambient = lx_exact(1),
        .exponent = 1,
        .own = {is_by_sine(measure), is_one_sided(measure)},
    };
}

/* |A x L|, which may be 0, where the square root has no slope; squares of what is below 1e-150 vanish. */
static lx_bounded sine_of(lx_bounded3 axis, lx_bounded3 towards)
{
    const lx_bounded3 across = lx_cross3(axis, towards);
    double values[3];
    lx_values3(across, values);
    return lx_rounded(sqrt(lx_dot(values, values)), across.x.error + across.y.error + across.z.error + 1e-150, 4);
}

static lx_bounded value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    const lx_bounded even = lobe->own[0] > 0 ? sine_of(normal, towards) : lx_exact(1);
    return lobe->own[1] > 0 ? lx_positive(lx_add(even, lx_dot3(view, towards))) : even;
}

/* |A x L| has the form of a cone about the axis: a circle comes nearest to it at one place, and to its other end. */
static size_t peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                    double tau[LX_MOST_PEAKS])
{
    (void)lobe;
    tau[0] = atan2(lx_dot(at->normal, b), lx_dot(at->normal, a));
    tau[1] = tau[0] > 0 ? tau[0] - M_PI : tau[0] + M_PI;
    return 2;
}

const struct lx_lobe_kind lx_measure_lobe = {.value = value, .peaks = peaks};

double lx_response_along(const struct lx_response *response, const double way[3])
{
    double across[3], even;
    if (is_by_sine(response->measure)) {
        lx_cross(response->axis, way, across);
        even = sqrt(lx_dot(across, across));
    } else {
        even = sqrt(lx_dot(way, way));
    }
    const double sided = is_one_sided(response->measure) ? fmax(even + lx_dot(response->view, way), 0) : even;
    return sided * (is_by_sine(response->measure) ? M_1_PI : 0.25);
}

double lx_response_most(const struct lx_response *response)
{
    return (is_by_sine(response->measure) ? M_1_PI : 0.25) * (is_one_sided(response->measure) ? 2 : 1);
}
