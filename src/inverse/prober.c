/* SPDX-License-Identifier: MIT */
/* Values by an evaluator or, where surfaces reflect light to each other, by probes that share a solution. */
#include "prober.h"

#include <stdlib.h>

#include "../api/refuse.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../scene/scene.h"

bool lx_prober_solves(const luxel_scene *scene)
{
    return lx_wants_reflections(lx_scene_parameters(scene));
}

luxel_status lx_prober_look(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct lx_prober *prober)
{
    luxel_status status = LUXEL_OK;
    *prober = (struct lx_prober){.scene = scene, .settings = *settings};
    if (!lx_prober_solves(scene))
        status = luxel_evaluator_new(scene, settings, diagnostics, &prober->evaluator);
    if (status != LUXEL_OK)
        lx_prober_close(prober);
    return status;
}

luxel_status lx_prober_open(luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct lx_prober *prober)
{
    const luxel_status status = lx_prober_look(scene, settings, diagnostics, prober);
    if (status == LUXEL_OK)
        prober->own = scene;
    else
        luxel_scene_free(scene);
    return status;
}

luxel_status lx_prober_measure(luxel_scene *scene, const luxel_settings *settings, size_t i, size_t count,
                               luxel_diagnostics *diagnostics, struct lx_prober *prober)
{
    luxel_grid *grid = NULL;
    *prober = (struct lx_prober){.scene = scene, .own = scene, .cells = lx_new_array(count + 1, sizeof *prober->cells)};
    luxel_status status =
        prober->cells ? luxel_find_grid_values(scene, settings, i, diagnostics, &grid) : lx_out_of_memory(diagnostics);
    const bool is_same = status == LUXEL_OK && (size_t)grid->columns * grid->rows == count;
    for (size_t k = 0; is_same && k < count; k++)
        prober->cells[k] = (struct lx_probed){grid->mask[k], grid->values[k], grid->errors[k]};
    luxel_grid_free(grid);
    if (status != LUXEL_OK)
        lx_prober_close(prober);
    return status;
}

void lx_prober_close(struct lx_prober *prober)
{
    free(prober->cells);
    luxel_evaluator_free(prober->evaluator);
    luxel_scene_free(prober->own);
    *prober = (struct lx_prober){.scene = NULL};
}

static luxel_status solve(const struct lx_prober *prober, const luxel_place *places, size_t count,
                          luxel_diagnostics *diagnostics, struct lx_probed *values)
{
    luxel_probes *probes;
    const luxel_status status =
        luxel_probe_places(prober->scene, &prober->settings, places, count, diagnostics, &probes);
    if (status != LUXEL_OK)
        return status;
    for (size_t i = 0; i < count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        values[i] = (struct lx_probed){probe->has_value, probe->value, probe->error};
    }
    luxel_probes_free(probes);
    return LUXEL_OK;
}

luxel_status lx_prober_values(const struct lx_prober *prober, const luxel_place *places, size_t count,
                              luxel_diagnostics *diagnostics, struct lx_probed *values)
{
    if (!prober->evaluator)
        return solve(prober, places, count, diagnostics, values);
    luxel_value *found = lx_new_array(count + 1, sizeof *found);
    if (!found)
        return lx_out_of_memory(diagnostics);
    const luxel_status status = luxel_evaluate_places(prober->evaluator, places, count, found, NULL);
    for (size_t i = 0; status == LUXEL_OK && i < count; i++)
        values[i] = (struct lx_probed){found[i].has_value, found[i].value, found[i].error};
    free(found);
    return status;
}
