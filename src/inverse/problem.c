/* SPDX-License-Identifier: MIT */
/* What changed scenes give at the readings of a fit. */
#include "problem.h"

#include <math.h>
#include <stdlib.h>

#include <luxel/render.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"

/* The share of the work that is done, as far as anyone can tell. */
static bool goes_on(struct lx_fit_problem *problem)
{
    const double done = (double)++problem->evaluations;
    return !problem->progress || problem->progress(done / (done + 100.0), problem->progress_data);
}

/* Draws the picture and takes its pixels, which is tenfold quicker than to probe them. */
static luxel_status draw(const struct lx_fit_problem *problem, const luxel_scene *scene,
                         const struct lx_reading_set *set, double *models)
{
    luxel_settings settings = problem->settings;
    luxel_field *field;
    settings.precision = LUXEL_DOUBLE;
    const luxel_status status = luxel_render(scene, &settings, NULL, &field);
    if (status != LUXEL_OK)
        return status;
    for (size_t i = 0; i < set->count; i++)
        models[i] = luxel_field_double(field)[set->pixels[i]];
    luxel_field_free(field);
    return LUXEL_OK;
}

static luxel_status probe(const struct lx_fit_problem *problem, const luxel_scene *scene,
                          const struct lx_reading_set *set, double *models)
{
    struct lx_prober prober;
    struct lx_probed *probed = lx_new_array(set->count + 1, sizeof *probed);
    luxel_status status = probed ? lx_prober_look(scene, &problem->settings, NULL, &prober) : LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK) {
        status = lx_prober_values(&prober, set->places, set->count, NULL, probed);
        lx_prober_close(&prober);
    }
    for (size_t i = 0; status == LUXEL_OK && i < set->count; i++)
        models[i] = probed[i].exists ? probed[i].value : 0.0;
    free(probed);
    return status;
}

luxel_status lx_problem_models(struct lx_fit_problem *problem, const struct lx_reading_set *set, const double *unknowns,
                               double *models)
{
    if (!goes_on(problem))
        return LUXEL_CANCELLED;
    const luxel_scene *scene = lx_changer_change(&problem->changer, unknowns);
    if (!scene)
        return LUXEL_ERROR_SCENE;
    luxel_status status = set->pixels ? draw(problem, scene, set, models) : probe(problem, scene, set, models);
    const double factor = problem->unknowns > problem->numbers ? unknowns[problem->numbers] : 1.0;
    for (size_t i = 0; status == LUXEL_OK && i < set->count; i++) {
        models[i] *= factor;
        if (!isfinite(models[i]))
            status = LUXEL_ERROR_SCENE;
    }
    if (status == LUXEL_ERROR_MEMORY)
        return lx_out_of_memory(problem->diagnostics);
    return status == LUXEL_OK || status == LUXEL_CANCELLED ? status : LUXEL_ERROR_SCENE;
}

/* The slope between the values at both ends of a step: NaN where they jump, or turn, as at a hard shadow's edge. */
static double slope_of(double below, double middle, double above, double width, double least)
{
    const double first = above - below, second = above - middle + (below - middle);
    return fabs(second) > 0.1 * fabs(first) && fabs(second) > least ? (double)NAN : first / width;
}

/* The values with one unknown changed; that is given back as it was.  *width grows by how far it was. */
static luxel_status step_aside(struct lx_fit_problem *problem, const struct lx_reading_set *set, double *unknowns,
                               size_t k, double step, double *width, double *models)
{
    const double at = unknowns[k];
    unknowns[k] = fmin(fmax(at + step, problem->low[k]), problem->high[k]);
    *width += fabs(unknowns[k] - at);
    const luxel_status status = lx_problem_models(problem, set, unknowns, models);
    unknowns[k] = at;
    return status;
}

luxel_status lx_problem_slopes(struct lx_fit_problem *problem, const struct lx_reading_set *set, const double *unknowns,
                               const double *models, double *slopes)
{
    double *below = lx_new_array(set->count + 1, sizeof *below), *above = lx_new_array(set->count + 1, sizeof *above);
    double *changed = lx_new_array(problem->unknowns + 1, sizeof *changed);
    /* so much is no jump, but what values are not known to, or bends over a step */
    const double least = fmax(fmax(1e-6, 4.0 * problem->precision), problem->step * problem->step) * problem->greatest;
    luxel_status status = below && above && changed ? LUXEL_OK : lx_out_of_memory(problem->diagnostics);
    for (size_t k = 0; status == LUXEL_OK && k < problem->unknowns; k++)
        changed[k] = unknowns[k];
    for (size_t k = 0; status == LUXEL_OK && k < problem->unknowns; k++) {
        double *slope = &slopes[k * set->count], width = 0.0;
        if (k == problem->numbers) {
            for (size_t i = 0; i < set->count; i++)
                slope[i] = unknowns[k] != 0.0 ? models[i] / unknowns[k] * problem->scale[k] : 0.0;
            continue;
        }
        const double step = problem->step * problem->scale[k];
        status = step_aside(problem, set, changed, k, step, &width, above);
        if (status == LUXEL_OK || status == LUXEL_ERROR_SCENE) {
            const bool has_above = status == LUXEL_OK;
            double down = 0.0;
            status = step_aside(problem, set, changed, k, -step, &down, below);
            const bool has_below = status == LUXEL_OK;
            if (status == LUXEL_ERROR_SCENE)
                status = LUXEL_OK;
            width = (has_above ? width : 0.0) + (has_below ? down : 0.0);
            for (size_t i = 0; status == LUXEL_OK && i < set->count; i++) {
                const double a = has_above ? above[i] : models[i], b = has_below ? below[i] : models[i];
                const bool is_central = has_above && has_below && down > 0.0 && width > down;
                slope[i] = !(width > 0.0) ? 0.0
                           : is_central   ? slope_of(b, models[i], a, width / problem->scale[k], least)
                                          : (a - b) / width * problem->scale[k];
            }
        }
    }
    free(below);
    free(above);
    free(changed);
    return status;
}
