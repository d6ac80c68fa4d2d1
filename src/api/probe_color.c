/* SPDX-License-Identifier: MIT */
/* Probes in colour: the sums of grey ones, with the bounds of their errors. */
#include <math.h>

#include "../base/diagnostics.h"
#include "../world/evaluate.h"
#include "color_worlds.h"
#include "coloring.h"
#include "session.h"

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

/* The colour of what a light gives, in the probes that are made. */
static luxel_color *color_of(const luxel_light_share *share)
{
    return (luxel_color *)share->color;
}

/* Adds the shares of a part to those of a probe; `is_sum`: of their luminance as well. */
static void add_shares(luxel_probe *probe, const struct lx_color_part *part, const luxel_probe *from, bool is_sum)
{
    for (size_t s = 0, own = 0; s < from->share_count; s++) {
        const luxel_light_share *share = &from->shares[s];
        const double value =
            part->settings.quantity == LUXEL_IRRADIANCE ? share->irradiance : share->diffuse + share->specular;
        while (own < probe->share_count && probe->shares[own].light != share->light)
            own++;
        if (own == probe->share_count)
            return;
        if (from->has_value)
            lx_color_add(part, (lx_bounded){value, share->error + LX_ROUNDING * fabs(value)},
                         color_of(&probe->shares[own]));
        if (is_sum)
            add_share(&probe->shares[own], part, share);
    }
}

/* Adds a part to the value of a probe, and to all that it consists of. */
static void add_value(luxel_probe *probe, const struct lx_color_part *part, const luxel_probe *from)
{
    const lx_bounded value =
        lx_add_part((lx_bounded){probe->value, probe->error}, part->luminance, from->value, from->error);
    const lx_bounded reflected =
        lx_add_part(probe->reflected, part->luminance, from->reflected.value, from->reflected.error);
    probe->value = value.value;
    probe->error = lx_reported(value).error;
    probe->has_value = probe->has_value && from->has_value;
    probe->tolerance_reached = probe->tolerance_reached && from->tolerance_reached;
    probe->has_reflected = from->has_reflected;
    probe->reflected = lx_reported(reflected);
    probe->reflected_irradiance += part->luminance * from->reflected_irradiance;
    probe->reflected_reached = probe->reflected_reached && from->reflected_reached;
    probe->has_pixel_value = probe->has_pixel_value && from->has_pixel_value;
    probe->pixel_value += part->luminance * from->pixel_value;
    if (from->source_on_element && !probe->source_on_element) {
        probe->source_on_element = true;
        probe->blocking_light = from->blocking_light;
    }
}

/* What the sum of a probe begins with: its place, and no light. */
static void begin_sum(luxel_probes *probes, size_t i, const luxel_probe *first)
{
    lx_probe_take_place(probes, i, first);
    luxel_probe *probe = &lx_probes_list(probes)[i];
    probe->has_value = probe->on_surface;
    probe->value = probe->error = 0;
    probe->reflected = lx_exact(0);
    probe->reflected_irradiance = probe->pixel_value = 0;
    probe->source_on_element = false;
}

static void add_probes(luxel_probes *probes, const struct lx_color_parts *parts, size_t p, const luxel_probes *from)
{
    for (size_t i = 0; i < luxel_probes_count(probes); i++) {
        const luxel_probe *one = luxel_probes_get(from, i);
        luxel_probe *probe = &lx_probes_list(probes)[i];
        if (parts->is_sum && p == 0)
            begin_sum(probes, i, one);
        if (parts->is_sum && one->on_surface)
            add_value(probe, &parts->list[p], one);
        if (one->has_value)
            lx_color_add(&parts->list[p], (lx_bounded){one->value, one->error}, &probe->color);
        if (one->on_surface)
            add_shares(probe, &parts->list[p], one, parts->is_sum);
    }
}

/* Channels that belong to a value, and nothing where there is none. */
static void finish(luxel_probes *probes, const struct lx_color_parts *parts)
{
    for (size_t i = 0; i < luxel_probes_count(probes); i++) {
        luxel_probe *probe = &lx_probes_list(probes)[i];
        probe->color.exists = probe->has_value;
        for (size_t s = 0; s < probe->share_count; s++) {
            luxel_color *color = color_of(&probe->shares[s]);
            color->exists = probe->has_value;
            *color = color->exists ? *color : (luxel_color){.exists = false};
        }
        if (!probe->has_value)
            probe->color = (luxel_color){.exists = false};
        if (!probe->has_value && parts->is_sum)
            probe->value = probe->error = 0;
    }
}

luxel_status lx_probe_in_color(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                               size_t count, luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    struct lx_color_parts parts = {.count = 0};
    struct lx_part_progress progress;
    luxel_settings own;
    luxel_probes *made = NULL;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    if (status == LUXEL_OK)
        status = lx_color_parts_make(scene, settings, diagnostics, &parts);
    const size_t before = parts.is_sum ? 0 : 1, all = parts.is_single ? 1 : parts.count + before;
    lx_part_progress_begin(&progress, 0, all, settings, &own);
    if (status == LUXEL_OK)
        status = parts.is_sum ? lx_probes_new(scene, settings, count, diagnostics, &made)
                              : lx_probe_grey(scene, &own, places, count, diagnostics, &made);
    if (status == LUXEL_OK && !lx_probes_add_colors(made))
        status = lx_out_of_memory(diagnostics);
    for (size_t p = 0; p < parts.count && status == LUXEL_OK; p++) {
        luxel_settings of_part = parts.list[p].settings;
        luxel_probes *from = made;
        lx_part_progress_begin(&progress, p + before, all, settings, &of_part);
        if (!parts.is_single)
            status = lx_probe_grey(parts.list[p].scene, &of_part, places, count, diagnostics, &from);
        if (status == LUXEL_OK)
            add_probes(made, &parts, p, from);
        if (status == LUXEL_OK && from != made)
            luxel_probes_free(from);
    }
    if (status == LUXEL_OK)
        finish(made, &parts);
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        *probes = made;
    else
        luxel_probes_free(made);
    return status;
}
