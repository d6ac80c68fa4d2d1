/* SPDX-License-Identifier: MIT */
/* Curves: the samples are copied, so that a difference can be taken. */
#include "curve.h"

#include <math.h>

/* Where one of the two has no value, there is no difference. */
static double take_off(luxel_profile_sample *samples, const luxel_profile *profile, const luxel_profile *minus)
{
    double largest = 0;
    for (gsize i = 0; i < profile->count; i++) {
        samples[i].has_value = samples[i].has_value && minus->samples[i].has_value;
        samples[i].value = samples[i].has_value ? samples[i].value - minus->samples[i].value : 0;
        samples[i].error += minus->samples[i].error;
        largest = MAX(largest, fabs(samples[i].value));
    }
    return largest;
}

AppCurve *app_curve_new(luxel_profile *profile, const luxel_profile *minus)
{
    AppCurve *curve = g_new0(AppCurve, 1);
    luxel_profile_sample *samples = g_memdup2(profile->samples, profile->count * sizeof *samples);
    curve->profile = *profile;
    curve->profile.samples = samples;
    curve->is_difference = minus && minus->count == profile->count;
    if (curve->is_difference) {
        const double largest = take_off(samples, profile, minus);
        curve->high = largest > 0 ? 1.1 * largest : 1;
        curve->low = -curve->high;
        curve->profile.lights = 0; /* which of the two scenes', is a question without an answer */
        curve->profile.shares = NULL;
    } else if (profile->shares)
        curve->profile.shares = g_memdup2(profile->shares, profile->count * profile->lights * sizeof *profile->shares);
    luxel_profile_free(profile);
    return curve;
}

void app_curve_free(AppCurve *curve)
{
    if (!curve)
        return;
    g_free((gpointer)curve->profile.samples);
    g_free((gpointer)curve->profile.shares);
    g_free(curve);
}
