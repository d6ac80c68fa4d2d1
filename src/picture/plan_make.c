/* SPDX-License-Identifier: MIT */
/* Making the plan: kernel constants, possible blockers, and the choice of precision. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/frame.h"
#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "../world/camera.h"
#include "../world/general.h"
#include "blockers.h"
#include "openings.h"
#include "plan_make.h"
#include "polynomial/smooth_gloss.h"

/* The picture's maximum is bounded from below by this many samples on each axis, or by all its pixels. */
enum { SAMPLES = 16 };
/* The most lights that are all summed to find the brightest row of samples; of more only some are. */
enum { MANY_LIGHTS = 1 << 16 };
/* Lights that are looked at between two questions whether to go on. */
enum { LIGHTS_BETWEEN_CHECKS = 64 };
/*
 * Polynomials seldom pay where half a surface's size on the screen is not so many times the side of a panel: under
 * enough lights, or extended sources, and under fewer.
 */
enum { ENOUGH_LIGHTS = 4, LEAST_PANELS = 1, LEAST_OF_FEW_LIGHTS = 7 };

/* The usual tolerance of the highlights of extended sources. */
static const double USUAL_TOLERANCE = 1e-3;

/* Dim pixels need not be better than a thousandth of the picture's maximum. */
static const double DIM = 1e-3;

static void set_lobes(const struct lx_lobe *lobe, struct lx_planned_surface *surface)
{
    surface->lobe_exact = (struct lx_lobe_double){
        .model = lx_lobe_kernel_model(lobe),
        .highlight = lobe->highlight,
        .diffuse = lobe->diffuse.value,
        .specular = lobe->specular.value,
        .exponent = lx_exponent_of(lobe->exponent),
    };
    surface->matte_exact = surface->glossy_exact = surface->lobe_exact;
    surface->matte_exact.model = lx_lobe_kernel_model(&(struct lx_lobe){.model = lobe->model});
    surface->glossy_exact.diffuse = 0;
    surface->limits = lx_lobe_limits_of(&surface->lobe_exact);
    surface->lobe = *lobe;
    surface->lobe_single = lx_lobe_single_of(&surface->lobe_exact);
    surface->glossy_single = lx_lobe_single_of(&surface->glossy_exact);
}

static bool goes_on(struct lx_control *control, size_t i)
{
    return i % LIGHTS_BETWEEN_CHECKS != 0 || lx_control_goes_on(control, true);
}

/* The rules that extended sources by laws other than 1/r^2 are summed by. */
static luxel_status plan_rules(struct lx_plan *plan, struct lx_control *control, struct lx_planned_surface *surface)
{
    const struct lx_asking asking = {.control = control, .is_caller = true};
    if (!plan->rules) {
        plan->rules = lx_gauss_rules_new(plan->precision == LUXEL_DOUBLE ? LX_DOUBLE_RULES : LX_SINGLE_RULES);
        plan->node_rules = lx_gauss_rules_new(LX_NODE_RULES);
    }
    luxel_status status = plan->rules && plan->node_rules ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    for (size_t s = 0; s < surface->area_light_count && status == LUXEL_OK; s++) {
        struct lx_planned_area_light *planned = &surface->area_lights[s];
        if (planned->emitter->attenuation != LX_INVERSE_SQUARE)
            status =
                lx_area_light_set_nodes(plan->rules, lx_gap(&surface->shape, &planned->lamp, &asking), &planned->lamp);
        if (!lx_control_goes_on(control, true))
            return LUXEL_CANCELLED;
    }
    return status;
}

bool lx_is_set_in(const struct lx_planned_surface *surface, const struct lx_emitter *emitter)
{
    const struct lx_shape *shape = &surface->shape;
    return lx_shape_is_flat(shape) && !lx_lobe_reaches_below(&surface->lobe) &&
           fabs(lx_emitter_extent(emitter, shape->anchor_mm, shape->axis, &(double){0})) <=
               lx_plane_rounding_mm(shape->anchor_mm, lx_distance(lx_emitter_center(emitter), shape->anchor_mm) +
                                                          lx_emitter_radius(emitter));
}

static luxel_status plan_lamps(struct lx_plan *plan, struct lx_control *control, struct lx_planned_surface *surface)
{
    const struct lx_emitters *emitters = &plan->prepared->emitters;
    const struct lx_asking asking = {.control = control, .is_caller = true};
    size_t count = 0, patches = 0, items = lx_item_count(emitters);
    for (size_t i = 0; i < items; i++) {
        count += lx_is_area_light(&emitters->items[i]);
        if (!goes_on(control, i))
            return LUXEL_CANCELLED;
    }
    if (count == 0)
        return LUXEL_OK;
    surface->area_lights = lx_new_array(count, sizeof *surface->area_lights);
    surface->glossy = lx_new_array(count, sizeof *surface->glossy);
    if (!surface->area_lights || !surface->glossy)
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < items; i++) {
        const struct lx_emitter *emitter = &emitters->items[i];
        if (!goes_on(control, i))
            return LUXEL_CANCELLED;
        if (!lx_is_area_light(emitter) || lx_is_set_in(surface, emitter))
            continue;
        struct lx_planned_area_light *planned = &surface->area_lights[surface->area_light_count];
        planned->emitter = emitter;
        luxel_status status = lx_area_light_make(emitter, &surface->shape, &asking, &planned->lamp);
        planned->by_reference = planned->lamp.is_general;
        struct lx_sampled *sampled = &surface->glossy[surface->area_light_count++];
        surface->glossy_count += lx_lobe_shines(&surface->lobe);
        if (status == LUXEL_OK && lx_find_area_light_blockers(plan, surface, planned))
            status = LUXEL_ERROR_MEMORY;
        if (status != LUXEL_OK)
            return status;
        *sampled = (struct lx_sampled){.emitter = emitter, .lamp = &planned->lamp, .law = emitter->attenuation};
        surface->by_law_count += emitter->attenuation != LX_INVERSE_SQUARE;
        sampled->in_double =
            plan->precision == LUXEL_DOUBLE ||
            !lx_samples_fit_single(&surface->shape, &surface->glossy_exact, &planned->lamp, plan->tolerance);
        patches += lx_patch_limit(&planned->lamp);
    }
    plan->most_patches = patches;
    return surface->by_law_count > 0 ? plan_rules(plan, control, surface) : LUXEL_OK;
}

/* Appends light i, whose blockers stand at the end of their list, to the runs. */
static int append_to_runs(struct lx_planned_surface *surface, const struct lx_emitter *emitter, size_t i,
                          size_t blocker_count)
{
    const enum lx_kernel_light kind = lx_light_kind_of(emitter);
    const bool has_edges = lx_has_edges(emitter, &surface->lobe_exact);
    struct lx_light_run *last = surface->run_count > 0 ? &surface->runs[surface->run_count - 1] : NULL;
    const uint32_t *blockers = surface->blockers;
    if (last && kind == last->kind && last->blocker_count == blocker_count &&
        (blocker_count == 0 || memcmp(blockers + last->blocker_first, blockers + surface->blocker_count,
                                      blocker_count * sizeof *blockers) == 0)) {
        last->count++;
        last->has_edges |= has_edges;
        return 0;
    }
    if (lx_reserve(&surface->runs, &surface->run_capacity, surface->run_count + 1, sizeof *surface->runs))
        return -1;
    surface->runs[surface->run_count++] = (struct lx_light_run){
        .first = i,
        .count = 1,
        .kind = kind,
        .has_edges = has_edges,
        .in_double = true,
        .blocker_first = surface->blocker_count,
        .blocker_count = blocker_count,
    };
    surface->blocker_count += blocker_count;
    return 0;
}

/* Whether an emitter is a light of the plan: neither extended, nor uniform, nor clustered. */
static bool is_light(const struct lx_plan *plan, const struct lx_emitter *emitter)
{
    return lx_has_one_way(emitter) && !lx_is_clustered(&plan->trees, emitter);
}

/* The next span of emitters that are lights all of them, or else of one item; false: there is none. */
static bool next_lights(const struct lx_plan *plan, struct lx_emitter_span *span)
{
    while (lx_emitters_next(&plan->prepared->emitters, span))
        if (!span->set || is_light(plan, &span->set->model))
            return true;
    return false;
}

static luxel_status plan_lights(struct lx_plan *plan, struct lx_control *control, struct lx_planned_surface *surface)
{
    struct lx_emitter room;
    struct lx_lights *lights = &surface->lights;
    size_t i = 0;
    const struct lx_emitters *emitters = &plan->prepared->emitters;
    const size_t most = lx_item_count(emitters);
    lx_lights_set_plane(lights, &surface->shape);
    if (most > LX_MOST_STORED && plan->trees.tree_count == 0 && lx_lights_make_room(lights, most))
        return LUXEL_ERROR_MEMORY;
    for (struct lx_emitter_span span = {0}; next_lights(plan, &span);) {
        if (span.set && lx_lights_append_point_set(lights, span.set))
            return LUXEL_ERROR_MEMORY;
        for (size_t e = span.first; e < span.end; e++) {
            const struct lx_emitter *emitter = lx_span_at(&span, e, &room);
            if (!goes_on(control, e))
                return LUXEL_CANCELLED;
            if (lx_is_uniform(emitter))
                surface->uniform += surface->lobe.ambient.value * emitter->strength;
            if (!span.set && !is_light(plan, emitter))
                continue;
            if (span.items && lx_lights_append(lights, emitter))
                return LUXEL_ERROR_MEMORY;
            int blockers = plan->prepared->shadows ? lx_find_blockers(plan, surface, emitter) : 0;
            if (blockers < 0 || append_to_runs(surface, emitter, i++, (size_t)blockers))
                return LUXEL_ERROR_MEMORY;
        }
    }
    return LUXEL_OK;
}

static luxel_status plan_surface(struct lx_plan *plan, struct lx_control *control, const struct lx_lobe *lobe,
                                 struct lx_planned_surface *surface)
{
    set_lobes(lobe, surface);
    surface->by_reference = !lx_lobe_has_kernels(lobe) || !lx_prepared_has_kernels(plan->prepared);
    plan->asks_reference = plan->asks_reference || surface->by_reference;
    if (surface->by_reference)
        return LUXEL_OK;
    luxel_status status = plan_lights(plan, control, surface);
    if (status == LUXEL_OK)
        status = plan_lamps(plan, control, surface);
    return status == LUXEL_OK ? lx_plan_openings(plan, control, surface) : status;
}

/* Splits the runs into those whose bounds say float32, being negative, and those of the others. */
static luxel_status split_runs(const double *bounds, struct lx_control *control, struct lx_planned_surface *surface)
{
    struct lx_light_run *runs = NULL;
    size_t count = 0, capacity = 0;
    for (size_t r = 0; r < surface->run_count; r++) {
        struct lx_light_run run = surface->runs[r];
        for (size_t first = run.first, end = first + run.count; first < end; first = run.first + run.count) {
            run.first = first;
            run.in_double = !(bounds[first] < 0);
            for (run.count = 1; first + run.count < end && !(bounds[first + run.count] < 0) == run.in_double;)
                run.count++;
            const bool is_stopped = !goes_on(control, r);
            if (is_stopped || lx_reserve(&runs, &capacity, count + 1, sizeof *runs)) {
                free(runs);
                return is_stopped ? LUXEL_CANCELLED : LUXEL_ERROR_MEMORY;
            }
            runs[count++] = run;
        }
    }
    free(surface->runs);
    surface->runs = runs;
    surface->run_count = count;
    surface->run_capacity = capacity;
    return LUXEL_OK;
}

/* Leaves lights to float32, or, where it has to be `all` of them and is not, none.  `*fits`: all. */
static luxel_status choose_precision(const struct lx_plan *plan, struct lx_control *control, bool all,
                                     struct lx_planned_surface *surface, bool *fits)
{
    size_t count = surface->lights.count, i = 0;
    struct lx_emitter room;
    double *bounds = count > 0 ? lx_new_aligned(count, sizeof *bounds) : NULL;
    const struct lx_asking asking = {.control = control, .is_caller = true};
    luxel_status status = count > 0 && !bounds ? LUXEL_ERROR_MEMORY : LUXEL_OK;
    for (struct lx_emitter_span span = {0}; status == LUXEL_OK && count > 0 && next_lights(plan, &span);)
        for (size_t e = span.first; e < span.end && status == LUXEL_OK; e++) {
            const struct lx_emitter *emitter = lx_span_at(&span, e, &room);
            if (!goes_on(control, e))
                status = LUXEL_CANCELLED;
            if (span.set || is_light(plan, emitter))
                bounds[i++] = lx_bound_light(plan->prepared, &surface->shape, &surface->lobe, emitter);
        }
    if (status == LUXEL_OK) {
        surface->rounding = (struct lx_rounding_sum){0};
        *fits = lx_choose_precision(bounds, count, plan->least_maximum, &asking, &surface->rounding) == count;
        if (!lx_control_goes_on(control, true))
            status = LUXEL_CANCELLED;
    }
    if (status == LUXEL_OK && count > 0 && (*fits || !all))
        status = split_runs(bounds, control, surface);
    free(bounds);
    return status;
}

/*
 * Whether the diffuse light of facets has to be left to the reference: where all that is seen lies nearly in one plane
 * with a small source far away, its terms cancel to less than their roundings.  Not for those with many edges, of
 * which the reference takes milliseconds for an element.
 */
static bool needs_reference(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                            const struct lx_area_light *lamp, const struct lx_asking *asking)
{
    enum { MOST_EDGES = 1000 };
    const double promised = plan->precision == LUXEL_DOUBLE ? 1e-11 : 2e-6;
    const double share = promised * plan->least_maximum / sqrt((double)surface->area_light_count);
    return lamp->facets && lamp->edge_count <= MOST_EDGES &&
           lx_bound_area_light_double(&surface->shape, surface->lobe_exact.diffuse, lamp, asking) > share;
}

/* Leaves the diffuse light of facets to float32, or to float64, where that keeps the picture's accuracy. */
static luxel_status choose_area_lights(const struct lx_plan *plan, struct lx_control *control,
                                       struct lx_planned_surface *surface)
{
    const struct lx_asking asking = {.control = control, .is_caller = true};
    const double diffuse = surface->lobe_exact.diffuse;
    for (size_t s = 0; s < surface->area_light_count && diffuse > 0; s++) {
        struct lx_planned_area_light *planned = &surface->area_lights[s];
        const bool by_law = planned->emitter->attenuation != LX_INVERSE_SQUARE;
        bool in_single = plan->precision == LUXEL_SINGLE && !planned->lamp.is_general;
        if (in_single) {
            double bound = by_law ? lx_bound_law(&surface->shape, diffuse, &planned->lamp, &asking)
                                  : lx_bound_area_light(&surface->shape, diffuse, &planned->lamp, &asking);
            in_single = lx_choose_precision(&bound, 1, plan->least_maximum, &asking, &surface->rounding) > 0;
        }
        planned->in_single = by_law && in_single;
        if (by_law)
            continue;
        planned->by_reference |= !in_single && needs_reference(plan, surface, &planned->lamp, &asking);
        if (!lx_control_goes_on(control, true))
            return LUXEL_CANCELLED;
        luxel_status status = in_single ? lx_area_light_make_single(&planned->lamp, &asking) : LUXEL_OK;
        if (status != LUXEL_OK)
            return status;
    }
    return LUXEL_OK;
}

/* The number of samples on an axis. */
static unsigned sample_count(unsigned pixels)
{
    return pixels < SAMPLES ? pixels : SAMPLES;
}

/* A row of the samples of the picture: the largest of them; NaN where the work was stopped. */
static double sample_row(const struct lx_plan *plan, struct lx_control *control, struct lx_shader_memory *memory,
                         unsigned j)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const unsigned columns = sample_count(screen->resolution[0]), rows = sample_count(screen->resolution[1]);
    const double y = lx_row_y_mm(screen, (unsigned)((j + 0.5) / rows * screen->resolution[1]));
    /* Clustered points are cut for each sample alone: together they are too far from each other. */
    const unsigned step = plan->trees.tree_count > 0 ? 1 : columns;
    double x[LX_LANES], values[LX_LANES], maximum = 0;
    uint8_t mask[LX_LANES];
    _Static_assert((int)SAMPLES <= (int)LX_LANES, "a row of samples fits in one padded block");
    for (unsigned first = 0; first < columns; first += step) {
        for (unsigned i = 0; i < step; i++)
            x[i] = lx_column_x_mm(screen, (unsigned)((first + i + 0.5) / columns * screen->resolution[0]));
        lx_shader_enter(plan, memory, &y, 1, x, step);
        lx_shade_row(plan, memory, 0, control, true, values, mask);
        if (!lx_control_goes_on(control, true))
            return (double)NAN;
        for (unsigned i = 0; i < step; i++)
            maximum = fmax(maximum, values[i] - lx_shader_error(memory));
    }
    return maximum;
}

/*
 * The largest of some of the picture's own pixels, in float64, at least.  With `every` above 1 of those in the row that
 * promises most by each such light alone.
 */
static luxel_status sample_maximum(struct lx_plan *plan, struct lx_control *control, size_t every, double *maximum)
{
    struct lx_shader_memory *memory = lx_shader_memory_new(plan);
    const unsigned rows = sample_count(plan->prepared->scene->screen.resolution[1]);
    unsigned best = 0;
    *maximum = 0;
    if (!memory)
        return LUXEL_ERROR_MEMORY;
    plan->every = every;
    for (unsigned j = 0; j < rows && !isnan(*maximum); j++) {
        double row = sample_row(plan, control, memory, j);
        if (isnan(row) || row > *maximum) {
            *maximum = row;
            best = j;
        }
        /* What is dimmer need not be good by itself: else the faint tail of a highlight takes most of the time. */
        plan->least_value = plan->least_maximum = *maximum;
    }
    plan->every = 1;
    if (every > 1 && !isnan(*maximum))
        *maximum = sample_row(plan, control, memory, best);
    lx_shader_memory_free(memory);
    return isnan(*maximum) ? LUXEL_CANCELLED : LUXEL_OK;
}

/* Finds a lower bound of the picture's maximum, by a rough look at the highlights and at clusters. */
static luxel_status find_maximum(struct lx_plan *plan, struct lx_control *control, size_t every)
{
    const double rough = LX_ROUGH, tolerance = plan->tolerance, light_error = plan->light_error;
    double maximum;
    plan->tolerance = fmax(tolerance, rough);
    plan->light_error = rough;
    plan->least_maximum = plan->least_value = 0;
    luxel_status status = sample_maximum(plan, control, every, &maximum);
    plan->tolerance = tolerance;
    plan->light_error = light_error;
    const bool is_rough = plan->most_patches > 0 || plan->has_openings || plan->asks_reference;
    plan->least_maximum = lx_share_of_channel(plan->prepared->scene) * (is_rough ? (1 - rough) * maximum : maximum);
    plan->least_value = DIM * plan->least_maximum;
    return status;
}

/* Finds a lower bound of the picture's maximum, and chooses by it.  `*fits`: all that had to. */
static luxel_status find_accuracy(struct lx_plan *plan, struct lx_control *control, size_t every, bool *fits)
{
    luxel_status status = find_maximum(plan, control, every);
    *fits = true;
    for (size_t s = 0; s < plan->surface_count && status == LUXEL_OK; s++) {
        bool all = true;
        if (plan->precision == LUXEL_SINGLE)
            status = choose_precision(plan, control, every > 1, &plan->surfaces[s], &all);
        if (status == LUXEL_OK)
            status = choose_area_lights(plan, control, &plan->surfaces[s]);
        *fits = *fits && all;
    }
    return status;
}

static luxel_status plan_accuracy(struct lx_plan *plan, struct lx_control *control)
{
    size_t every = 1;
    bool fits;
    if (plan->precision == LUXEL_DOUBLE && plan->most_patches == 0 && plan->trees.tree_count == 0 &&
        !plan->has_openings && !plan->asks_reference)
        return LUXEL_OK;
    for (size_t s = 0; s < plan->surface_count && plan->most_patches == 0; s++)
        every =
            plan->surfaces[s].lights.count > every * MANY_LIGHTS ? plan->surfaces[s].lights.count / MANY_LIGHTS : every;
    luxel_status status = find_accuracy(plan, control, every, &fits);
    /* The maximum may be more than a quick look has found. */
    return status == LUXEL_OK && every > 1 && !fits ? find_accuracy(plan, control, 1, &fits) : status;
}

/* Whether elements in float32 are all that a surface's light takes. */
static bool is_in_single(const struct lx_planned_surface *surface)
{
    bool all = lx_has_kernels(&surface->shape) && surface->by_law_count == 0 && surface->glossy_count == 0;
    all = all && surface->opening_count == 0 && !surface->by_reference;
    for (size_t s = 0; all && s < surface->area_light_count; s++)
        all = surface->area_lights[s].lamp.edges_single && !surface->area_lights[s].by_reference &&
              surface->area_lights[s].blocker_count == 0;
    for (size_t r = 0; all && r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        all = !run->in_double && !run->has_edges && run->blocker_count == 0;
    }
    return all;
}

/* The only surface that the picture may show, by parallel lines of sight along -z; NULL: there are more, or none. */
static const struct lx_planned_surface *find_alone(const struct lx_plan *plan)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const double left = lx_column_x_mm(screen, 0), right = lx_column_x_mm(screen, screen->resolution[0] - 1);
    const double top = lx_row_y_mm(screen, 0), bottom = lx_row_y_mm(screen, screen->resolution[1] - 1);
    const struct lx_planned_surface *alone = plan->surface_count == 1 ? plan->surfaces : NULL;
    for (size_t s = 0; plan->surface_count > 1 && s < plan->surface_count; s++) {
        const struct lx_planned_surface *surface = &plan->surfaces[s];
        if (right < surface->low_mm[0] || left > surface->high_mm[0] || top < surface->low_mm[1] ||
            bottom > surface->high_mm[1])
            continue;
        if (alone)
            return NULL;
        alone = surface;
    }
    return alone;
}

static void plan_alone(struct lx_plan *plan)
{
    if (plan->trees.tree_count > 0 || !plan->prepared->camera.is_parallel)
        return;
    const struct lx_planned_surface *alone = find_alone(plan);
    if (!alone || !is_in_single(alone))
        return;
    plan->alone = alone;
    plan->at_once = alone->run_count == 1 && alone->area_light_count == 0 && alone->lights.count <= LX_MOST_IN_RUN &&
                    plan->every == 1;
}

/* Half the size of a surface as it looks on the screen. */
static double radius_on_screen(const struct lx_plan *plan, const struct lx_planned_surface *surface)
{
    const struct lx_shape *shape = &surface->shape;
    return shape->radius_mm * lx_scale_at(&plan->prepared->camera, shape->anchor_mm[2]);
}

/* Whether polynomials may take the place of a surface's lights (smooth.h), and pay. */
static bool is_smooth(const struct lx_plan *plan, const struct lx_planned_surface *surface)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const size_t all = surface->lights.count + surface->area_light_count;
    const unsigned least = surface->area_light_count > 0 || all >= ENOUGH_LIGHTS ? LEAST_PANELS : LEAST_OF_FEW_LIGHTS;
    return lx_curvature(&surface->shape) >= 0 && all > 0 && all <= LX_MOST_SMOOTH &&
           (surface->glossy_count == 0 || lx_has_smooth_highlights(surface)) &&
           radius_on_screen(plan, surface) > least * screen->width_mm / screen->resolution[0] * LX_PANEL_SIDE;
}

/* Whether the picture is shaded by panels; then what they need is made. */
static luxel_status plan_panels(struct lx_plan *plan, struct lx_control *control)
{
    const unsigned *resolution = plan->prepared->scene->screen.resolution;
    const struct lx_asking asking = {.control = control, .is_caller = true};
    luxel_status status = LUXEL_OK;
    bool any = false, all = true, has_gloss = false;
    if (plan->precision != LUXEL_SINGLE || plan->trees.tree_count > 0 || plan->every > 1 ||
        !(plan->least_maximum > 0) || resolution[0] < LX_PANEL_SIDE || resolution[1] < LX_PANEL_SIDE)
        return LUXEL_OK;
    for (size_t s = 0; s < plan->surface_count; s++) {
        const struct lx_planned_surface *surface = &plan->surfaces[s];
        any = any || is_smooth(plan, surface);
        all = all && (surface->glossy_count == 0 || lx_has_smooth_highlights(surface)) && surface->opening_count == 0;
        has_gloss = has_gloss || surface->glossy_count > 0;
    }
    plan->in_panels = any && all;
    plan->has_gloss = plan->in_panels && has_gloss;
    lx_bases_make(plan->bases);
    lx_gloss_bases_make(plan->gloss_bases);
    lx_table_bases_make(plan->table_bases);
    for (size_t s = 0; plan->in_panels && s < plan->surface_count && status == LUXEL_OK; s++) {
        struct lx_planned_surface *surface = &plan->surfaces[s];
        if (is_smooth(plan, surface))
            status = lx_smooth_make(surface, radius_on_screen(plan, surface), &asking, &surface->smooth);
    }
    return status;
}

luxel_status lx_plan_sight(const struct lx_prepared *prepared, const struct lx_kernels *kernels,
                           const luxel_settings *settings, struct lx_plan *plan)
{
    static const double ORIGIN[3] = {0, 0, 0};
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    *plan = (struct lx_plan){
        .kernels = kernels,
        .precision = settings->precision,
        .surfaces = lx_new_array(prepared->surface_count, sizeof *plan->surfaces),
        .balls = lx_new_array(prepared->surface_count, sizeof *plan->balls),
        .surface_count = prepared->surface_count,
        .every = 1,
    };
    plan->prepared = prepared = lx_prepared_on_screen(prepared, &asking, &plan->carried);
    if (!plan->surfaces || !plan->balls || !prepared)
        return atomic_load(&control.stop) ? LUXEL_CANCELLED : LUXEL_ERROR_MEMORY;
    for (size_t s = 0; s < plan->surface_count; s++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        struct lx_planned_surface *planned = &plan->surfaces[s];
        planned->shape = surface->shape;
        for (int i = 0; i < 3; i++) {
            planned->low_mm[i] = surface->low_mm[i] - lx_shape_room(&surface->shape);
            planned->high_mm[i] = surface->high_mm[i] + lx_shape_room(&surface->shape);
        }
        plan->balls[s] = lx_shape_ball(&planned->shape, planned->low_mm, planned->high_mm, ORIGIN);
    }
    return lx_seen_plan(plan) ? LUXEL_ERROR_MEMORY : LUXEL_OK;
}

luxel_status lx_plan_make(const struct lx_prepared *prepared, const struct lx_kernels *kernels,
                          const luxel_settings *settings, struct lx_plan *plan)
{
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    luxel_status status = lx_plan_sight(prepared, kernels, settings, plan);
    if (status != LUXEL_OK)
        return status;
    prepared = plan->prepared;
    plan->tolerance = settings->tolerance > 0 ? settings->tolerance : USUAL_TOLERANCE;
    plan->light_error = settings->light_error;
    plan->part_tolerance = settings->precision == LUXEL_DOUBLE ? 1e-12 : 3e-7;
    if (settings->light_error > 0)
        status = lx_light_trees_build(&prepared->emitters, &control, &plan->trees);
    struct lx_lobe irradiance = lx_lobe_irradiance();
    for (size_t s = 0; s < plan->surface_count && status == LUXEL_OK; s++) {
        const struct lx_lobe *lobe = settings->quantity == LUXEL_IRRADIANCE ? &irradiance : &prepared->surfaces[s].lobe;
        status = plan_surface(plan, &control, lobe, &plan->surfaces[s]);
    }
    if (status == LUXEL_OK)
        status = plan_accuracy(plan, &control);
    if (status == LUXEL_OK)
        status = plan_panels(plan, &control);
    if (status == LUXEL_OK)
        plan_alone(plan);
    return status;
}

void lx_plan_clear(struct lx_plan *plan)
{
    for (size_t s = 0; plan->surfaces && s < plan->surface_count; s++) {
        struct lx_planned_surface *surface = &plan->surfaces[s];
        for (size_t i = 0; i < surface->area_light_count; i++)
            lx_area_light_clear(&surface->area_lights[i].lamp), free(surface->area_lights[i].blockers);
        lx_openings_clear(surface);
        lx_lights_clear(&surface->lights);
        lx_smooth_clear(&surface->smooth);
        free(surface->runs);
        free(surface->blockers);
        free(surface->area_lights);
        free(surface->glossy);
    }
    free(plan->surfaces);
    free(plan->balls);
    lx_boxes_clear(&plan->on_screen);
    free(plan->rules);
    free(plan->node_rules);
    lx_light_trees_clear(&plan->trees);
    lx_prepared_free(plan->carried);
    *plan = (struct lx_plan){0};
}
