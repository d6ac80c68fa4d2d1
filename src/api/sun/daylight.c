/* SPDX-License-Identifier: MIT */
/*
 * Daylight factors: grids and elements of the scene, measured with the light of its skies alone, three times: with all
 * that surfaces reflect, without, and under a sky with dark ground.
 */
#include <luxel/daylight.h>

#include <luxel/grid.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../base/phrase.h"
#include "../../light/array.h"
#include "../../light/sky/dome.h"
#include "../../scene/object.h"
#include "../../scene/scene.h"
#include "../refuse.h"
#include "daylight.h"

static const double levels[LUXEL_DAYLIGHT_LEVELS] = {100, 300, 500, 750};

double luxel_daylight_level(size_t i)
{
    return i < LUXEL_DAYLIGHT_LEVELS ? levels[i] : (double)NAN;
}

void luxel_daylight_free(luxel_daylight *daylight)
{
    if (!daylight)
        return;
    for (size_t i = 0; i < daylight->grid_count; i++) {
        free((char *)daylight->grids[i].name);
        free(daylight->grids[i].cells);
    }
    free(daylight->grids);
    free(daylight->elements);
    free(daylight);
}

/* Which light counts, and the scenes that part it: as it is, without reflections, and with dark ground, too. */
enum part { ALL, DIRECT, SKY, PARTS };

struct asked {
    const luxel_scene *scenes[PARTS]; /* NULL: as the one before */
    luxel_scene *made[PARTS];
    luxel_settings settings;
    struct lx_skies skies;
    luxel_diagnostics *diagnostics;
};

/* A copy with changes, which the caller frees. */
static luxel_status change(const luxel_scene *scene, const char *const *assignments, size_t count,
                           luxel_diagnostics *diagnostics, luxel_scene **made)
{
    luxel_status status = LUXEL_OK;
    *made = luxel_scene_copy(scene);
    if (!*made)
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        status = luxel_scene_set(*made, assignments[i], diagnostics);
    return status == LUXEL_OK ? luxel_scene_commit(*made, diagnostics) : status;
}

static luxel_status part_scenes(const luxel_scene *scene, struct asked *asked)
{
    static const char *const none = "reflections=none";
    luxel_status status = LUXEL_OK;
    asked->scenes[ALL] = asked->scenes[DIRECT] = scene;
    if (lx_wants_reflections(&scene->parameters)) {
        status = change(scene, &none, 1, asked->diagnostics, &asked->made[DIRECT]);
        asked->scenes[DIRECT] = asked->made[DIRECT];
    }
    asked->scenes[SKY] = asked->scenes[DIRECT];
    for (size_t i = 0; i < asked->skies.count && status == LUXEL_OK; i++) {
        const struct lx_item *sky = &scene->parameters.lights.items[asked->skies.items[i]];
        const struct lx_parameter *ground = lx_find_parameter(sky->variant->table, "ground");
        char key[64];
        if (*(const double *)((const char *)sky->parameters + ground->offset) == 0)
            continue;
        snprintf(key, sizeof key, "lights[%zu].ground=0", asked->skies.items[i]);
        const char *const dark = key;
        luxel_scene *before = asked->made[SKY];
        status = change(before ? before : asked->scenes[DIRECT], &dark, 1, asked->diagnostics, &asked->made[SKY]);
        luxel_scene_free(before);
        asked->scenes[SKY] = asked->made[SKY];
    }
    return status;
}

/* Whether a part is what the one before is: it is not calculated anew. */
static bool is_repeated(const struct asked *asked, int part)
{
    return part > ALL && asked->scenes[part] == asked->scenes[part - 1];
}

/* ---- factors ---- */

static luxel_bounded percent(const struct asked *asked, luxel_bounded irradiance)
{
    return lx_div(lx_mul(lx_exact(100), irradiance), asked->skies.horizontal);
}

/* What is left of a sum, which is no less than 0. */
static luxel_bounded rest(luxel_bounded sum, luxel_bounded part)
{
    return sum.value == part.value && sum.error == part.error ? lx_exact(0) : lx_positive(lx_sub(sum, part));
}

static luxel_daylight_factor factor_of(const struct asked *asked, const luxel_bounded found[PARTS])
{
    const luxel_bounded all = percent(asked, found[ALL]), direct = percent(asked, found[DIRECT]);
    const luxel_bounded sky = percent(asked, found[SKY]);
    return (luxel_daylight_factor){.has_value = true,
                                   .value = all,
                                   .sky = sky,
                                   .external = rest(direct, sky),
                                   .internal = asked->made[DIRECT] ? rest(all, direct) : lx_exact(0)};
}

static luxel_status find_elements(struct asked *asked, const luxel_place *places, luxel_daylight *made)
{
    luxel_probes *found[PARTS] = {NULL};
    luxel_status status = LUXEL_OK;
    for (int part = 0; part < PARTS && status == LUXEL_OK; part++)
        if (!is_repeated(asked, part))
            status = luxel_probe_places(asked->scenes[part], &asked->settings, places, made->element_count,
                                        asked->diagnostics, &found[part]);
    for (size_t i = 0; i < made->element_count && status == LUXEL_OK; i++) {
        luxel_bounded values[PARTS];
        bool has_values = true;
        for (int part = 0; part < PARTS; part++) {
            if (!found[part]) {
                values[part] = values[part - 1];
                continue;
            }
            const luxel_probe *probe = luxel_probes_get(found[part], i);
            has_values = has_values && probe->has_value;
            values[part] = (luxel_bounded){probe->value, probe->error};
            const bool is_known = probe->tolerance_reached && (!probe->has_reflected || probe->reflected_reached);
            made->reached = made->reached && (!probe->has_value || is_known);
        }
        made->elements[i] = has_values ? factor_of(asked, values) : (luxel_daylight_factor){.has_value = false};
    }
    for (int part = 0; part < PARTS; part++)
        luxel_probes_free(found[part]);
    return status;
}

/* The mean, the median and the shares; the median of numbers that are each off by no more than its bound is so, too. */
static void judge(const luxel_daylight *daylight, luxel_daylight_grid *grid, double *sorted)
{
    const size_t cells = (size_t)grid->columns * grid->rows;
    luxel_bounded sum = lx_exact(0);
    double error = 0;
    size_t reached[LUXEL_DAYLIGHT_LEVELS] = {0};
    for (size_t i = 0; i < cells; i++) {
        const luxel_daylight_factor *cell = &grid->cells[i];
        if (!cell->has_value)
            continue;
        sorted[grid->measured++] = cell->value.value;
        sum = lx_add(sum, cell->value);
        error = fmax(error, cell->value.error);
        for (int k = 0; k < LUXEL_DAYLIGHT_LEVELS; k++)
            reached[k] += (cell->value.value - cell->value.error) / 100 * daylight->outdoor >= levels[k];
    }
    const size_t count = grid->measured;
    for (int k = 0; k < LUXEL_DAYLIGHT_LEVELS; k++)
        grid->shares[k] = count > 0 && isfinite(daylight->outdoor) ? (double)reached[k] / (double)count : (double)NAN;
    if (count == 0)
        return;
    qsort(sorted, count, sizeof *sorted, lx_by_value);
    grid->mean = lx_div(sum, lx_exact((double)count));
    grid->median = lx_rounded((sorted[(count - 1) / 2] + sorted[count / 2]) / 2, error, 2);
}

static luxel_status find_grid(struct asked *asked, size_t i, luxel_daylight *made)
{
    luxel_daylight_grid *grid = &made->grids[i];
    luxel_grid *found[PARTS] = {NULL};
    luxel_status status = LUXEL_OK;
    double *sorted = NULL;
    for (int part = 0; part < PARTS && status == LUXEL_OK; part++)
        if (!is_repeated(asked, part))
            status = luxel_find_grid_values(asked->scenes[part], &asked->settings, i, asked->diagnostics, &found[part]);
    if (status == LUXEL_OK) {
        const size_t cells = (size_t)found[ALL]->columns * found[ALL]->rows;
        grid->columns = found[ALL]->columns;
        grid->rows = found[ALL]->rows;
        grid->name = found[ALL]->name ? lx_copy_text(found[ALL]->name, strlen(found[ALL]->name)) : NULL;
        grid->cells = lx_new_array(cells, sizeof *grid->cells);
        sorted = lx_new_array(cells, sizeof *sorted);
        status = grid->cells && sorted && (grid->name || !found[ALL]->name) ? LUXEL_OK : LUXEL_ERROR_MEMORY;
        for (size_t cell = 0; cell < cells && status == LUXEL_OK; cell++) {
            luxel_bounded values[PARTS];
            for (int part = 0; part < PARTS; part++)
                values[part] = found[part] ? (luxel_bounded){found[part]->values[cell], found[part]->errors[cell]}
                                           : values[part - 1];
            if (found[ALL]->mask[cell])
                grid->cells[cell] = factor_of(asked, values);
        }
    }
    for (int part = 0; part < PARTS; part++) {
        const luxel_grid *one = found[part];
        made->reached =
            made->reached && (!one || (one->tolerance_reached && (!one->has_reflected || one->reflected_reached)));
        luxel_grid_free(found[part]);
    }
    if (status == LUXEL_OK)
        judge(made, grid, sorted);
    free(sorted);
    return status;
}

static luxel_status find(const luxel_scene *scene, struct asked *asked, const luxel_place *places, size_t place_count,
                         double outdoor, luxel_daylight **made)
{
    luxel_status status = lx_find_skies(scene, asked->diagnostics, &asked->skies);
    if (status == LUXEL_OK)
        status = part_scenes(scene, asked);
    if (status != LUXEL_OK)
        return status;
    luxel_daylight *daylight = *made = lx_new_array(1, sizeof *daylight);
    if (!daylight)
        return LUXEL_ERROR_MEMORY;
    const bool is_photometric = scene->parameters.units == LX_PHOTOMETRIC;
    *daylight = (luxel_daylight){
        .horizontal = asked->skies.horizontal,
        .outdoor = outdoor > 0      ? outdoor
                   : is_photometric ? asked->skies.horizontal.value
                                    : (double)NAN,
        .grids = lx_new_array(luxel_scene_grid_count(scene) + 1, sizeof *daylight->grids),
        .elements = lx_new_array(place_count + 1, sizeof *daylight->elements),
        .reached = true,
    };
    if (!daylight->grids || !daylight->elements)
        return LUXEL_ERROR_MEMORY;
    asked->settings.quantity = LUXEL_IRRADIANCE;
    asked->settings.lights = asked->skies.items;
    asked->settings.light_count = asked->skies.count;
    asked->settings.within /= fmax((double)(luxel_scene_grid_count(scene) + (place_count > 0)), 1); /* one each */
    daylight->element_count = place_count;
    if (place_count > 0)
        status = find_elements(asked, places, daylight);
    for (size_t i = 0; i < luxel_scene_grid_count(scene) && status == LUXEL_OK; i++) {
        daylight->grid_count++;
        status = find_grid(asked, i, daylight);
    }
    return status;
}

luxel_status luxel_find_daylight(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                                 size_t place_count, double outdoor, luxel_diagnostics *diagnostics,
                                 luxel_daylight **daylight)
{
    struct asked asked = {.diagnostics = diagnostics};
    *daylight = NULL;
    if (!luxel_scene_is_committed(scene))
        return LUXEL_ERROR_ARGUMENT;
    luxel_settings_init(&asked.settings);
    if (settings)
        asked.settings = *settings;
    const luxel_status status = find(scene, &asked, places, place_count, outdoor, daylight);
    for (int part = 0; part < PARTS; part++)
        luxel_scene_free(asked.made[part]);
    free(asked.skies.items);
    if (status == LUXEL_ERROR_MEMORY)
        lx_out_of_memory(diagnostics);
    if (status != LUXEL_OK) {
        luxel_daylight_free(*daylight);
        *daylight = NULL;
    }
    return status;
}
