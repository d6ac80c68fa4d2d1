/* SPDX-License-Identifier: MIT */
/* Light adds up, grows with its sources, and a white surface reflects what it gets. */
#include "properties.h"
#include "truth.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_PIXELS = 128 };

/* The pictures of the single lights added up; false where one of them is beyond the range. */
static bool sum_pictures(const struct draft *draft, double sum[MOST_PIXELS], double *maxima)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    memset(sum, 0, MOST_PIXELS * sizeof *sum);
    *maxima = 0;
    for (size_t i = 0; i < draft->light_count; i++) {
        struct draft single = *draft;
        single.lights[0] = draft->lights[i];
        single.light_count = 1;
        luxel_field *picture = trial_render_draft(&single, &settings);
        if (!picture)
            return false;
        *maxima += trial_maximum(picture);
        for (unsigned p = 0; p < luxel_field_columns(picture) * luxel_field_rows(picture); p++)
            sum[p] += luxel_field_double(picture)[p];
        luxel_field_free(picture);
    }
    return true;
}

bool is_sum_of_lights(struct trial *trial)
{
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    double sum[MOST_PIXELS], maxima;
    if (!picture || trial->draft->light_count < 2)
        return true;
    if (!sum_pictures(trial->draft, sum, &maxima))
        return trial_fails(trial, "a light alone is beyond the range, but not all of them");
    /* Integrals are taken to a share of the picture's maximum, all else to a few roundings. */
    const double slack = draft_has_extended(trial->draft) ? 2 * trial_slack(trial, picture) : 0;
    for (unsigned p = 0; p < luxel_field_columns(picture) * luxel_field_rows(picture); p++) {
        const double whole = luxel_field_double(picture)[p];
        if (!(fabs(whole - sum[p]) <= slack + 1e-13 * whole + 1e-300))
            return trial_fails(trial, "pixel %u: %.17g, one by one %.17g", p, whole, sum[p]);
    }
    return true;
}

/* By powers of two, which round nothing, but where numbers end. */
bool scales_with_lights(struct trial *trial)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    const double factor = 0x1p20, ends = DBL_MIN * 0x1p200;
    struct draft scaled = *trial->draft;
    if (!picture || trial_maximum(picture) > 1e290)
        return true;
    for (size_t i = 0; i < scaled.light_count; i++) {
        double *strength = &scaled.lights[i].numbers.strength;
        if (*strength > 1e290 || (*strength > 0 && *strength < 1e-290))
            return true;
        *strength *= factor;
    }
    luxel_field *larger = trial_render_draft(&scaled, &settings);
    bool holds = larger != NULL || trial_fails(trial, "beyond the range with %g times the light", factor);
    for (unsigned p = 0; holds && p < luxel_field_columns(picture) * luxel_field_rows(picture); p++) {
        const double once = luxel_field_double(picture)[p], more = luxel_field_double(larger)[p];
        holds = more == factor * once || once < ends ||
                trial_fails(trial, "pixel %u: %.17g, with %g times the light %.17g", p, once, factor, more);
    }
    luxel_field_free(larger);
    return holds;
}

/* A Lambertian surface of the weight 1 over pi: its brightness is the irradiance over pi. */
bool is_white_by_pi(struct trial *trial)
{
    struct draft white = *trial->draft;
    for (size_t i = 0; i < white.surface_count; i++) {
        white.surfaces[i].words.model = white.surfaces[i].words.has_ambient = 0;
        white.surfaces[i].words.over_pi = 1;
        white.surfaces[i].numbers.diffuse = 1;
    }
    luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    luxel_field *brightness = trial_render_draft(&white, &settings);
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_field *irradiance = trial_render(trial->scene, &settings);
    bool holds = true;
    for (unsigned p = 0;
         holds && brightness && irradiance && p < luxel_field_columns(brightness) * luxel_field_rows(brightness); p++) {
        const double reflected = luxel_field_double(brightness)[p] * M_PI, got = luxel_field_double(irradiance)[p];
        holds = fabs(reflected - got) <= 1e-13 * got + 1e-300 ||
                trial_fails(trial, "pixel %u: irradiance %.17g, brightness times pi %.17g", p, got, reflected);
    }
    luxel_field_free(brightness);
    luxel_field_free(irradiance);
    return holds;
}
