/* SPDX-License-Identifier: MIT */
/* Making the plan: kernel constants, possible blockers, and the choice of precision. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "camera.h"
#include "plan.h"
#include "precision.h"
#include "shader.h"

/* The picture's maximum is bounded from below by this many samples on each axis.  Lights in float32 are summed in runs
 * before they join the float64 sum. */
enum { SAMPLES = 16, MOST_IN_RUN = 16 };

/* Of the highlights of extended sources. */
static const double USUAL_TOLERANCE = 1e-3;

/* Whole exponents beyond this would need more products than the logarithm has. */
enum { MOST_WHOLE = 65536 };

static struct lx_exponent_double exponent_of(double exponent)
{
    bool is_whole = exponent == floor(exponent) && exponent <= MOST_WHOLE;
    return (struct lx_exponent_double){exponent, is_whole ? (unsigned)exponent : 0};
}

static struct lx_exponent_single single_exponent(struct lx_exponent_double exponent)
{
    return (struct lx_exponent_single){(float)exponent.value, exponent.whole};
}

static enum lx_light_kind kind_of(const struct lx_emitter *emitter)
{
    if (emitter->type != LX_POINT)
        return LX_DISTANT;
    if (emitter->profile.falloff != LX_NO_CONE || emitter->profile.exponent > 0)
        return LX_PROFILED;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return LX_BY_SQUARE;
    case LX_PRACTICAL: return LX_BY_SUM;
    case LX_NO_ATTENUATION: break;
    }
    return LX_UNATTENUATED;
}

static void set_exact(const struct lx_emitter *emitter, const struct lx_shape *shape, struct lx_light_double *light)
{
    const struct lx_profile *profile = &emitter->profile;
    *light = (struct lx_light_double){
        .kind = kind_of(emitter),
        .x = emitter->towards.x.value,
        .y = emitter->towards.y.value,
        .z = emitter->towards.z.value,
        .gain = emitter->strength,
        .law = emitter->attenuation,
        .k = emitter->k_mm,
        .falloff = emitter->type == LX_POINT ? profile->falloff : LX_NO_CONE,
        .axis_x = profile->axis.x.value,
        .axis_y = profile->axis.y.value,
        .axis_z = profile->axis.z.value,
        .exponent = exponent_of(profile->exponent),
    };
    if (light->kind == LX_DISTANT)
        return;
    light->x = emitter->position_mm[0] - shape->anchor_mm[0];
    light->y = emitter->position_mm[1] - shape->anchor_mm[1];
    light->z = emitter->position_mm[2] - shape->anchor_mm[2];
    /* The laws are in metres, the kernel's distances in mm. */
    light->gain *= light->law == LX_INVERSE_SQUARE ? 1e6 : light->law == LX_PRACTICAL ? 1e3 : 1;
    bool by_angle = profile->falloff == LX_LINEAR;
    light->edge = by_angle ? profile->outer_rad.value : profile->outer_versine.value;
    double inner = by_angle ? profile->inner_rad.value : profile->inner_versine.value;
    light->edge_slope = profile->falloff == LX_HARD || profile->falloff == LX_NO_CONE ? 0 : 1 / (light->edge - inner);
}

static void set_single(const struct lx_light_double *exact, struct lx_light_single *light)
{
    *light = (struct lx_light_single){
        .kind = exact->kind,
        .x = (float)exact->x,
        .y = (float)exact->y,
        .z = (float)exact->z,
        .gain = (float)exact->gain,
        .law = exact->law,
        .k = (float)exact->k,
        .falloff = exact->falloff,
        .axis_x = (float)exact->axis_x,
        .axis_y = (float)exact->axis_y,
        .axis_z = (float)exact->axis_z,
        .exponent = single_exponent(exact->exponent),
        .edge = (float)exact->edge,
        .edge_slope = (float)exact->edge_slope,
    };
}

static double half_diagonal(const struct lx_planned_surface *surface)
{
    const double *low = surface->low_mm, *high = surface->high_mm;
    return hypot(hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]) / 2;
}

/* Whether a surface comes near the ways from the elements of another to the light, seen as a thick line. */
static bool may_block(const struct lx_planned_surface *blocker, const struct lx_planned_surface *lit,
                      const struct lx_light_double *light)
{
    double way[3] = {light->x, light->y, light->z}, offset[3], along = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        offset[i] = blocker->shape.anchor_mm[i] - lit->shape.anchor_mm[i];
        along += offset[i] * way[i];
        square += way[i] * way[i];
    }
    double t = square > 0 ? fmax(along / square, 0) : 0;
    if (light->kind != LX_DISTANT)
        t = fmin(t, 1);
    double gap = hypot(hypot(offset[0] - t * way[0], offset[1] - t * way[1]), offset[2] - t * way[2]);
    return !(gap > (half_diagonal(blocker) + half_diagonal(lit)) * (1 + 1e-9));
}

static int find_blockers(const struct lx_plan *plan, const struct lx_planned_surface *lit,
                         const struct lx_light_double *exact, struct lx_planned_light *light)
{
    size_t count = 0;
    for (size_t s = 0; plan->prepared->shadows && s < plan->surface_count; s++)
        count += &plan->surfaces[s] != lit && may_block(&plan->surfaces[s], lit, exact);
    light->blockers =
        count > 0 ? lx_new_array(count, sizeof *light->blockers) : NULL; /* of many lights each has some */
    if (count > 0 && !light->blockers)
        return -1;
    for (size_t s = 0; light->blocker_count < count; s++) {
        const struct lx_planned_surface *other = &plan->surfaces[s];
        if (other == lit || !may_block(other, lit, exact))
            continue;
        struct lx_blocker *blocker = &light->blockers[light->blocker_count++];
        *blocker = (struct lx_blocker){
            .shape = other->shape,
            .is_point = exact->kind != LX_DISTANT,
            .light = {exact->x, exact->y, exact->z},
        };
        for (int i = 0; i < 3; i++)
            blocker->shape.anchor_mm[i] -= lit->shape.anchor_mm[i];
    }
    return 0;
}

static struct lx_lobe_single single_lobe(const struct lx_lobe_double *lobe)
{
    return (struct lx_lobe_single){
        .model = lobe->model,
        .highlight = lobe->highlight,
        .diffuse = (float)lobe->diffuse,
        .specular = (float)lobe->specular,
        .exponent = single_exponent(lobe->exponent),
    };
}

static void set_lobes(const struct lx_lobe *lobe, struct lx_planned_surface *surface)
{
    surface->lobe_exact = (struct lx_lobe_double){
        .model = lobe->specular.value > 0 ? lobe->model : LX_LAMBERT,
        .highlight = lobe->highlight,
        .diffuse = lobe->diffuse.value,
        .specular = lobe->specular.value,
        .exponent = exponent_of(lobe->exponent),
    };
    surface->matte_exact = surface->glossy_exact = surface->lobe_exact;
    surface->matte_exact.model = LX_LAMBERT;
    surface->glossy_exact.diffuse = 0;
    surface->lobe = *lobe;
    surface->lobe_single = single_lobe(&surface->lobe_exact);
    surface->glossy_single = single_lobe(&surface->glossy_exact);
    surface->matte_single = single_lobe(&surface->matte_exact);
}

static int plan_shells(struct lx_plan *plan, struct lx_planned_surface *surface)
{
    const struct lx_emitters *emitters = &plan->prepared->emitters;
    size_t count = 0, patches = 0, items = lx_item_count(emitters);
    for (size_t i = 0; i < items; i++)
        count += lx_is_extended(&emitters->items[i]);
    if (count == 0)
        return 0;
    surface->shells = lx_new_array(count, sizeof *surface->shells);
    surface->glossy = lx_new_array(count, sizeof *surface->glossy);
    surface->matte = lx_new_array(count, sizeof *surface->matte);
    if (!surface->shells || !surface->glossy || !surface->matte)
        return -1;
    for (size_t i = 0; i < items; i++) {
        const struct lx_emitter *emitter = &emitters->items[i];
        if (!lx_is_extended(emitter))
            continue;
        struct lx_planned_shell *planned = &surface->shells[surface->shell_count];
        planned->emitter = emitter;
        int failed = lx_shell_make(emitter, &surface->shape, &planned->shell);
        struct lx_sampled *sampled = &surface->glossy[surface->shell_count++];
        if (failed)
            return -1;
        *sampled = (struct lx_sampled){.shell = &planned->shell, .law = emitter->attenuation, .k_mm = emitter->k_mm};
        if (emitter->attenuation != LX_INVERSE_SQUARE) {
            surface->matte[surface->matte_count] = *sampled;
            surface->matte[surface->matte_count++].in_double = true;
        }
        sampled->in_double =
            plan->precision == LUXEL_DOUBLE ||
            !lx_samples_fit_single(&surface->shape, &surface->glossy_exact, &planned->shell, plan->tolerance);
        patches += lx_patch_limit(&planned->shell);
    }
    plan->most_patches = patches;
    return 0;
}

static void find_runs(struct lx_planned_surface *surface)
{
    surface->run_count = 0;
    for (size_t i = 0; i < surface->light_count; i++) {
        const struct lx_planned_light *light = &surface->lights[i];
        struct lx_light_run *last = surface->run_count > 0 ? &surface->runs[surface->run_count - 1] : NULL;
        bool joins = last && last->count < MOST_IN_RUN && last->in_double == light->in_double &&
                     surface->exacts[last->first].kind == surface->exacts[i].kind && light->blocker_count == 0 &&
                     surface->lights[last->first].blocker_count == 0;
        if (joins)
            last->count++;
        else
            surface->runs[surface->run_count++] = (struct lx_light_run){i, 1, light->in_double};
    }
}

static int plan_surface(struct lx_plan *plan, const struct lx_lobe *lobe, struct lx_planned_surface *surface)
{
    const struct lx_prepared *prepared = plan->prepared;
    struct lx_emitter room;
    set_lobes(lobe, surface);
    size_t most = prepared->emitters.count;
    surface->lights = lx_new_array(most, sizeof *surface->lights);
    surface->singles = lx_new_array(most, sizeof *surface->singles);
    surface->exacts = lx_new_array(most, sizeof *surface->exacts);
    surface->runs = lx_new_array(most, sizeof *surface->runs);
    if (!surface->lights || !surface->singles || !surface->exacts || !surface->runs)
        return -1;
    for (size_t i = 0; i < prepared->emitters.count; i++) {
        const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, i, &room);
        if (emitter->type == LX_UNIFORM) {
            surface->uniform += lobe->ambient.value * emitter->strength;
            continue;
        }
        if (lx_is_extended(emitter))
            continue;
        struct lx_light_double *exact = &surface->exacts[surface->light_count];
        struct lx_planned_light *light = &surface->lights[surface->light_count];
        light->in_double = true;
        set_exact(emitter, &surface->shape, exact);
        set_single(exact, &surface->singles[surface->light_count++]);
        lx_bound_light(prepared, &surface->shape, lobe, emitter, light);
        if (!emitter->is_part && find_blockers(plan, surface, exact, light))
            return -1;
    }
    find_runs(surface);
    return plan_shells(plan, surface);
}

/* The largest of some of the picture's own pixels, in float64. */
static int sample_maximum(const struct lx_plan *plan, double *maximum)
{
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    struct lx_shader_memory *memory = lx_shader_memory_new(plan);
    double x[LX_LANES], values[LX_LANES];
    uint8_t mask[LX_LANES];
    _Static_assert((int)SAMPLES <= (int)LX_LANES, "a row of samples fits in one padded block");
    *maximum = 0;
    if (!memory)
        return -1;
    for (unsigned j = 0; j < SAMPLES; j++) {
        unsigned row = (unsigned)((j + 0.5) / SAMPLES * screen->resolution[1]);
        for (unsigned i = 0; i < SAMPLES; i++)
            x[i] = lx_column_x_mm(screen, (unsigned)((i + 0.5) / SAMPLES * screen->resolution[0]));
        lx_shade_points(plan, memory, lx_row_y_mm(screen, row), x, SAMPLES, NULL, false, values, mask);
        for (unsigned i = 0; i < SAMPLES; i++)
            *maximum = fmax(*maximum, values[i]);
    }
    free(memory);
    return 0;
}

/* Finds a lower bound of the picture's maximum, by a rough look at the highlights, and chooses by it. */
static int plan_accuracy(struct lx_plan *plan)
{
    const double rough = 0.1, tolerance = plan->tolerance;
    bool is_sampled = plan->most_patches > 0, is_double = plan->precision == LUXEL_DOUBLE;
    double maximum;
    if (is_double && !is_sampled)
        return 0;
    plan->tolerance = fmax(tolerance, rough);
    if (sample_maximum(plan, &maximum))
        return -1;
    plan->tolerance = tolerance;
    plan->least_maximum = is_sampled ? (1 - rough) * maximum : maximum;
    for (size_t s = 0; s < plan->surface_count && !is_double; s++) {
        lx_choose_precision(&plan->surfaces[s], plan->least_maximum);
        find_runs(&plan->surfaces[s]);
    }
    return 0;
}

int lx_plan_make(const struct lx_prepared *prepared, const struct lx_kernels *kernels, luxel_quantity quantity,
                 luxel_precision precision, double tolerance, struct lx_plan *plan)
{
    *plan = (struct lx_plan){
        .prepared = prepared,
        .kernels = kernels,
        .precision = precision,
        .tolerance = tolerance > 0 ? tolerance : USUAL_TOLERANCE,
        .surfaces = lx_new_array(prepared->surface_count, sizeof *plan->surfaces),
        .surface_count = prepared->surface_count,
    };
    if (!plan->surfaces)
        return -1;
    for (size_t s = 0; s < plan->surface_count; s++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        plan->surfaces[s].shape = surface->shape;
        surface->kind->extent(surface->parameters, plan->surfaces[s].low_mm, plan->surfaces[s].high_mm);
        for (int i = 0; i < 3; i++) {
            plan->surfaces[s].low_mm[i] -= 2 * surface->shape.touch_mm;
            plan->surfaces[s].high_mm[i] += 2 * surface->shape.touch_mm;
        }
    }
    struct lx_lobe irradiance = lx_lobe_irradiance();
    for (size_t s = 0; s < plan->surface_count; s++) {
        const struct lx_lobe *lobe = quantity == LUXEL_IRRADIANCE ? &irradiance : &prepared->surfaces[s].lobe;
        if (plan_surface(plan, lobe, &plan->surfaces[s]))
            return -1;
    }
    return plan_accuracy(plan);
}

void lx_plan_clear(struct lx_plan *plan)
{
    for (size_t s = 0; plan->surfaces && s < plan->surface_count; s++) {
        for (size_t i = 0; i < plan->surfaces[s].light_count; i++)
            free(plan->surfaces[s].lights[i].blockers);
        for (size_t i = 0; i < plan->surfaces[s].shell_count; i++)
            lx_shell_clear(&plan->surfaces[s].shells[i].shell);
        free(plan->surfaces[s].lights);
        free(plan->surfaces[s].singles);
        free(plan->surfaces[s].exacts);
        free(plan->surfaces[s].runs);
        free(plan->surfaces[s].shells);
        free(plan->surfaces[s].glossy);
        free(plan->surfaces[s].matte);
    }
    free(plan->surfaces);
    *plan = (struct lx_plan){0};
}
