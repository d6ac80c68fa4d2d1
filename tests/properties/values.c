/* SPDX-License-Identifier: MIT */
/* Properties of single values: in their range, and the same by each way that there is to ask for them. */
#include "properties.h"

#include <math.h>

static bool is_finite_picture(struct trial *trial, const luxel_field *picture, const char *what)
{
    for (unsigned row = 0; picture && row < luxel_field_rows(picture); row++)
        for (unsigned column = 0; column < luxel_field_columns(picture); column++) {
            const double value = luxel_field_value(picture, column, row);
            const bool on_surface = luxel_field_mask(picture)[row * luxel_field_columns(picture) + column];
            if (!(isfinite(value) && value >= 0 && !signbit(value)) || (!on_surface && value != 0))
                return trial_fails(trial, "%s at pixel [%u, %u], %s a surface: %.17g", what, column, row,
                                   on_surface ? "on" : "off", value);
        }
    return true;
}

bool is_finite(struct trial *trial)
{
    luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_field *irradiance = trial_render(trial->scene, &settings);
    const bool holds = is_finite_picture(trial, trial_picture(trial, LUXEL_SINGLE), "brightness in float32") &&
                       is_finite_picture(trial, trial_picture(trial, LUXEL_DOUBLE), "brightness in float64") &&
                       is_finite_picture(trial, irradiance, "irradiance in float64");
    luxel_field_free(irradiance);
    return holds;
}

/* The middle of the screen, and a place between pixels. */
enum { PLACES = 2 };
static luxel_probe *probe_at(const struct trial *trial, const luxel_settings *settings, int place)
{
    const struct draft *draft = trial->draft;
    const double x = place ? draft->numbers.pitch * draft->words.columns * 0.171875 : 0;
    const double y = place ? draft->numbers.pitch * draft->words.rows * -0.0859375 : 0;
    luxel_probe *probe = NULL;
    return luxel_probe_screen(trial->scene, settings, x, y, NULL, &probe) == LUXEL_OK ? probe : NULL;
}

static bool has_its_shares(struct trial *trial, const luxel_probe *probe)
{
    double sum = 0, errors = probe->error;
    if (!(isfinite(probe->value) && probe->value >= 0 && probe->error >= 0))
        return trial_fails(trial, "value %.17g, error %.3g", probe->value, probe->error);
    for (size_t i = 0; i < probe->share_count; i++) {
        const luxel_light_share *share = &probe->shares[i];
        if (!(share->irradiance >= 0 && share->diffuse >= 0 && share->specular >= 0 && share->error >= 0))
            return trial_fails(trial, "lights[%zu]: irradiance %.17g, diffuse %.17g, specular %.17g, error %.3g",
                               share->light, share->irradiance, share->diffuse, share->specular, share->error);
        sum += share->diffuse + share->specular;
        errors += share->error;
    }
    return fabs(sum - probe->value) <= errors ||
           trial_fails(trial, "value %.17g, shares %.17g, errors %.3g", probe->value, sum, errors);
}

bool has_shares(struct trial *trial)
{
    luxel_settings settings = trial_settings(LUXEL_SINGLE);
    settings.tolerance = draft_has_extended(trial->draft) ? 1e-4 : 0;
    bool holds = true;
    for (int place = 0; place < PLACES && holds; place++) {
        luxel_probe *probe = probe_at(trial, &settings, place);
        holds = !(probe && probe->has_value) || has_its_shares(trial, probe);
        luxel_probe_free(probe);
    }
    return holds;
}

bool has_pixel_values(struct trial *trial)
{
    bool holds = true;
    for (luxel_precision precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
        const luxel_field *picture = trial_picture(trial, precision);
        const luxel_settings settings = trial_settings(precision);
        luxel_probe *probe = picture ? probe_at(trial, &settings, 1) : NULL;
        if (probe && probe->has_pixel_value) {
            const double shown = luxel_field_value(picture, probe->column, probe->row);
            holds = holds &&
                    (shown == probe->pixel_value || trial_fails(trial, "pixel [%u, %u]: picture %.17g, probe %.17g",
                                                                probe->column, probe->row, shown, probe->pixel_value));
        }
        luxel_probe_free(probe);
    }
    return holds;
}

bool reaches_tolerance(struct trial *trial)
{
    luxel_settings rough = trial_settings(LUXEL_SINGLE);
    bool holds = true;
    if (!draft_has_extended(trial->draft)) /* all else are closed forms */
        return true;
    rough.tolerance = 1e-3;
    luxel_settings fine = rough;
    fine.tolerance = 1e-6;
    for (int place = 0; place < PLACES && holds; place++) {
        luxel_probe *a = probe_at(trial, &rough, place), *b = probe_at(trial, &fine, place);
        if (a && b && a->has_value && b->has_value)
            holds = fabs(a->value - b->value) <= a->error + b->error ||
                    trial_fails(trial, "%.17g +- %.3g with the tolerance 1e-3, %.17g +- %.3g with 1e-6", a->value,
                                a->error, b->value, b->error);
        luxel_probe_free(a);
        luxel_probe_free(b);
    }
    return holds;
}
