/* SPDX-License-Identifier: MIT */
/* Probes in colour: the sums of grey ones, with the bounds of their errors. */
#include <math.h>

#include "../world/evaluate.h"
#include "coloring.h"
#include "session.h"

/* Adds a part's value to the channels of a probe. */
static void add_channels(luxel_probe *probe, const struct lx_color_part *part, double value, double error)
{
    for (int c = 0; c < LX_CHANNELS; c++) {
        const lx_bounded so_far = {probe->color.rgb[c], probe->color.error[c]};
        const lx_bounded sum = lx_add_part(so_far, part->rgb[c], value, error);
        probe->color.rgb[c] = sum.value;
        probe->color.error[c] = lx_reported_error(sum);
    }
}

/* Adds what one light gives: its irradiance is the same in each channel of the materials. */
static void add_share(luxel_light_share *share, const struct lx_color_part *part, const luxel_light_share *from)
{
    const double made = fabs(part->luminance) * (fabs(from->diffuse) + fabs(from->specular));
    share->irradiance = from->irradiance;
    share->diffuse += part->luminance * from->diffuse;
    share->specular += part->luminance * from->specular;
    share->error += (fabs(part->luminance) * from->error + 8 * LX_ROUNDING * made) * LX_BOUND_SLACK;
    share->parts = from->parts;
}

/* Adds a part to the value of a probe, and to all that it consists of. */
static void add_value(luxel_probe *probe, const struct lx_color_part *part, const luxel_probe *from)
{
    const lx_bounded value =
        lx_add_part((lx_bounded){probe->value, probe->error}, part->luminance, from->value, from->error);
    const lx_bounded reflected = lx_add_part((lx_bounded){probe->reflected_value, probe->reflected_error},
                                             part->luminance, from->reflected_value, from->reflected_error);
    probe->value = value.value;
    probe->error = lx_reported_error(value);
    probe->has_value = probe->has_value && from->has_value;
    probe->tolerance_reached = probe->tolerance_reached && from->tolerance_reached;
    probe->has_reflected = from->has_reflected;
    probe->reflected_value = reflected.value;
    probe->reflected_error = lx_reported_error(reflected);
    probe->reflected_irradiance += part->luminance * from->reflected_irradiance;
    probe->reflected_reached = probe->reflected_reached && from->reflected_reached;
    probe->has_pixel_value = probe->has_pixel_value && from->has_pixel_value;
    probe->pixel_value += part->luminance * from->pixel_value;
    if (from->source_on_element && !probe->source_on_element) {
        probe->source_on_element = true;
        probe->blocking_light = from->blocking_light;
    }
    for (size_t s = 0, own = 0; s < from->share_count; s++) {
        while (own < probe->share_count && probe->shares[own].light != from->shares[s].light)
            own++;
        if (own < probe->share_count)
            add_share(&probe->shares[own], part, &from->shares[s]);
    }
}

/* What the sum of a probe begins with: its place, and no light. */
static void begin_sum(luxel_probe *probes, size_t i, const luxel_probe *first)
{
    lx_probe_take_place(probes, i, first);
    luxel_probe *probe = &probes[i];
    probe->has_value = probe->on_surface;
    probe->value = probe->error = 0;
    probe->reflected_value = probe->reflected_error = probe->reflected_irradiance = probe->pixel_value = 0;
    probe->source_on_element = false;
}

static void add_probes(luxel_probe *probes, size_t count, const struct lx_color_parts *parts, size_t p,
                       const luxel_probe *from)
{
    for (size_t i = 0; i < count; i++) {
        if (parts->is_sum && p == 0)
            begin_sum(probes, i, &from[i]);
        if (parts->is_sum && from[i].on_surface)
            add_value(&probes[i], &parts->list[p], &from[i]);
        if (from[i].has_value)
            add_channels(&probes[i], &parts->list[p], from[i].value, from[i].error);
    }
}

/* Channels that belong to a value, and nothing where there is none. */
static void finish(luxel_probe *probes, size_t count, const struct lx_color_parts *parts)
{
    for (size_t i = 0; i < count; i++) {
        probes[i].color.exists = probes[i].has_value;
        if (!probes[i].has_value)
            probes[i].color = (luxel_color){.exists = false};
        if (!probes[i].has_value && parts->is_sum)
            probes[i].value = probes[i].error = 0;
    }
}

luxel_status lx_probe_in_color(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                               size_t count, luxel_diagnostics *diagnostics, luxel_probe **probes)
{
    struct lx_color_parts parts = {.count = 0};
    struct lx_part_progress progress;
    luxel_settings own;
    luxel_probe *made = NULL;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    if (status == LUXEL_OK)
        status = lx_color_parts_make(scene, settings, diagnostics, &parts);
    const size_t before = parts.is_sum ? 0 : 1, all = parts.is_single ? 1 : parts.count + before;
    lx_part_progress_begin(&progress, 0, all, settings, &own);
    if (status == LUXEL_OK)
        status = parts.is_sum ? lx_probes_new(scene, settings, count, diagnostics, &made)
                              : lx_probe_grey(scene, &own, places, count, diagnostics, &made);
    for (size_t p = 0; p < parts.count && status == LUXEL_OK; p++) {
        luxel_settings of_part = parts.list[p].settings;
        luxel_probe *from = made;
        lx_part_progress_begin(&progress, p + before, all, settings, &of_part);
        if (!parts.is_single)
            status = lx_probe_grey(parts.list[p].scene, &of_part, places, count, diagnostics, &from);
        if (status == LUXEL_OK)
            add_probes(made, count, &parts, p, from);
        if (status == LUXEL_OK && from != made)
            luxel_probe_free(from);
    }
    if (status == LUXEL_OK)
        finish(made, count, &parts);
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        *probes = made;
    else
        luxel_probe_free(made);
    return status;
}
