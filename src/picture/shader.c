/* SPDX-License-Identifier: MIT */
/* Shading a run of pixels: all lights over the elements of each surface that it shows. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../world/among.h"
#include "../world/camera.h"
#include "../world/world.h"
#include "openings.h"
#include "shader_memory.h"

/* Some lights of a run that are summed between two questions whether to go on. */
enum { RUNS_BETWEEN_CHECKS = 16 };

/* Whether some light is a sum over samples. */
static bool has_samples(const struct lx_plan *plan)
{
    bool any = false;
    for (size_t s = 0; s < plan->surface_count; s++)
        any = any || plan->surfaces[s].glossy_count > 0;
    return any;
}

struct lx_shader_memory *lx_shader_memory_new(const struct lx_plan *plan)
{
    enum { ALIGNMENT = 64 };
    size_t head = (sizeof(struct lx_shader_memory) + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    size_t size = has_samples(plan) ? lx_sampling_memory_size(plan->most_patches) : 0;
    struct lx_shader_memory *memory = lx_new_aligned(1, head + size);
    if (!memory)
        return NULL;
    memory->sampling = size > 0 ? lx_sampling_memory_of((char *)memory + head, plan->most_patches) : NULL;
    memory->room = (struct lx_light_room){.of_singles = NULL};
    lx_penumbra_init(&memory->penumbra);
    memory->portion = NULL;
    memory->mirrored_error = 0;
    lx_seen_init(plan, &memory->seen);
    bool has_all = true;
    size_t surfaces = plan->trees.tree_count > 0 ? plan->surface_count : 0;
    memory->cut_count = surfaces < KEPT_CUTS ? surfaces : KEPT_CUTS;
    for (size_t i = 0; i < memory->cut_count; i++)
        has_all &= lx_cut_init(plan, &memory->cuts[i]) == 0;
    if (has_all)
        return memory;
    lx_shader_memory_free(memory);
    return NULL;
}

void lx_shader_memory_free(struct lx_shader_memory *memory)
{
    for (size_t i = 0; memory && i < memory->cut_count; i++)
        lx_cut_clear(&memory->cuts[i]);
    if (memory)
        lx_penumbra_clear(&memory->penumbra);
    free(memory);
}

void lx_shader_choose(struct lx_shader_memory *memory, const struct lx_portion *portion)
{
    memory->portion = portion;
}

struct lx_seen *lx_shader_seen(struct lx_shader_memory *memory)
{
    return &memory->seen;
}

struct lx_sampling_memory *lx_shader_sampling(struct lx_shader_memory *memory)
{
    return memory->sampling;
}

/* The lowest and highest of the three coordinates of vectors. */
struct extent {
    double low[3], high[3];
};

static const struct extent EMPTY = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static void extend(struct extent *extent, const double *x, const double *y, const double *z, size_t count)
{
    const double *all[3] = {x, y, z};
    for (int k = 0; k < 3; k++) {
        double low = extent->low[k], high = extent->high[k];
        for (size_t i = 0; i < count; i++) {
            low = all[k][i] < low ? all[k][i] : low;
            high = all[k][i] > high ? all[k][i] : high;
        }
        extent->low[k] = low;
        extent->high[k] = high;
    }
}

static struct lx_ball ball_around(const struct extent *extent)
{
    struct lx_ball ball;
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double half = (extent->high[k] - extent->low[k]) / 2;
        ball.center[k] = extent->low[k] + half;
        square += half * half;
    }
    ball.radius = sqrt(square);
    return ball;
}

/* Those of many surfaces that may stand between the block's elements and a light. */
static bool find_near(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                      const struct lx_light_double *light, const struct lx_shader_memory *memory, size_t count,
                      struct lx_found *found)
{
    const struct lx_block_double *block = &memory->seen.block;
    struct extent places = EMPTY;
    extend(&places, block->px, block->py, block->pz, count);
    const struct lx_ball from = ball_around(&places);
    const struct lx_ball towards = {.center = {light->x, light->y, light->z}};
    return lx_among_balls(plan->prepared, surface->shape.anchor_mm, &from, &towards, light->kind == LX_DISTANT, found);
}

static const float *find_open(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                              const struct lx_light_run *run, const struct lx_light_double *light,
                              struct lx_shader_memory *memory, size_t count)
{
    if (run->blocker_count == 0)
        return NULL;
    const uint32_t *blockers = surface->blockers + run->blocker_first;
    struct lx_found found;
    const bool is_found = run->blocker_count > LX_FEW_BOXES && find_near(plan, surface, light, memory, count, &found);
    const size_t all = lx_found_count(&found, is_found, run->blocker_count);
    for (size_t i = 0; i < lx_padded(count); i++)
        memory->open[i] = 1;
    for (size_t b = 0; b < all; b++) {
        if (is_found && !lx_is_among(blockers, run->blocker_count, found.items[b]))
            continue;
        const struct lx_planned_surface *blocker = &plan->surfaces[is_found ? found.items[b] : blockers[b]];
        lx_block_one(plan->kernels, &blocker->shape, blocker == surface, surface->shape.anchor_mm, light,
                     &memory->seen.block, count, memory->open);
    }
    return memory->open;
}

/* Sums some lights of a run over the gathered block; where they may be hidden, one. */
static void light_by_run(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                         const struct lx_light_run *run, size_t first, size_t lights, struct lx_shader_memory *memory,
                         size_t count)
{
    const struct lx_light_double *exact = NULL;
    if (run->in_double || run->has_edges || run->blocker_count > 0)
        exact = lx_lights_double(&surface->lights, first, lights, &memory->room);
    const float *open = find_open(plan, surface, run, exact, memory, count);
    if (run->in_double)
        plan->kernels->shade_double(exact, NULL, lights, &surface->lobe_exact, &memory->seen.block, NULL, open, count,
                                    memory->sum);
    else
        plan->kernels->shade_single(lx_lights_single(&surface->lights, first, lights, &memory->room), exact, lights,
                                    &surface->lobe_single, &memory->seen.copy, &memory->seen.block, open, count,
                                    memory->sum);
}

/* The end of lights from `first` on, of a run, all of which are chosen or not as that is. */
static size_t end_of_chosen(const struct lx_portion *portion, size_t first, size_t end)
{
    size_t next = first + 1;
    while (portion && next < end && lx_is_chosen(portion, next) == lx_is_chosen(portion, first))
        next++;
    return portion ? next : end;
}

/* Sums all lights but the extended and the clustered ones over the gathered block. */
static void light_block(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                        struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking)
{
    const struct lx_portion *portion = memory->portion;
    size_t step = 0;
    plan->kernels->set_all(memory->sum, lx_padded(count), !portion || portion->uniform ? surface->uniform : 0);
    for (size_t r = 0; r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        const size_t most = run->blocker_count > 0 ? 1 : LX_MOST_IN_RUN, all = run->first + run->count;
        for (size_t first = run->first, end; first < all; first = end, step++) {
            end = end_of_chosen(portion, first, all - first < most ? all : first + most);
            if (step % plan->every == 0 && lx_is_chosen(portion, first))
                light_by_run(plan, surface, run, first, end - first, memory, count);
            if (step % RUNS_BETWEEN_CHECKS == RUNS_BETWEEN_CHECKS - 1 && !lx_asking_goes_on(asking))
                return;
        }
    }
}

/* ---- clustered points ---- */

unsigned lx_tile_columns(const struct lx_plan *plan, unsigned columns)
{
    /* Small tiles need fewer clusters each, large ones fewer cuts; found by trying (docs/KERNELS.md). */
    const unsigned share = 13, vectors = columns / share / LX_LANES;
    const unsigned most = 128;
    if (plan->trees.tree_count == 0)
        return LX_BLOCK;
    return vectors == 0 ? LX_LANES : vectors * LX_LANES < most ? vectors * LX_LANES : most;
}

void lx_shader_enter(const struct lx_plan *plan, struct lx_shader_memory *memory, const double *y_mm, size_t rows,
                     const double *x_mm, size_t count)
{
    memcpy(memory->tile_y, y_mm, rows * sizeof *y_mm);
    memcpy(memory->tile_x, x_mm, count * sizeof *x_mm);
    for (size_t i = count; i < lx_padded(count); i++)
        memory->tile_x[i] = x_mm[count - 1];
    memory->tile_rows = rows;
    memory->tile_columns = count;
    for (size_t i = 0; i < memory->cut_count; i++)
        memory->cuts[i].surface = NULL;
    if (plan->alone)
        lx_seen_enter(plan, &memory->seen, x_mm, count);
}

double lx_shader_error(const struct lx_shader_memory *memory)
{
    return memory->error;
}

double lx_shader_mirrored_error(const struct lx_shader_memory *memory)
{
    return memory->mirrored_error;
}

/* The cone of unit vectors in a box: they are in the ball around it. */
static struct lx_cone cone_around(const struct extent *extent)
{
    const struct lx_ball ball = ball_around(extent);
    const double *center = ball.center;
    const double length = sqrt(center[0] * center[0] + center[1] * center[1] + center[2] * center[2]);
    const double sine = ball.radius / length;
    if (!(length > ball.radius)) /* all directions */
        return (struct lx_cone){.axis = {0, 0, 1}, .cosine = -1};
    return (struct lx_cone){.axis = {center[0] / length, center[1] / length, center[2] / length},
                            .cosine = sqrt(1 - sine * sine),
                            .sine = sine};
}

/* What a tile shows of a surface; the block and what is nearest in the rows are lost. */
static struct lx_receiver_region find_receiver_region(const struct lx_plan *plan, struct lx_shader_memory *memory,
                                                      size_t s)
{
    const struct lx_planned_surface *surface = &plan->surfaces[s];
    const bool asks_mirrored = LX_IS_BY_MIRROR(surface->limits.lobe.model);
    struct lx_block_double *block = &memory->seen.block;
    struct extent places = EMPTY, normals = EMPTY, views = EMPTY, mirrored = EMPTY;
    struct lx_receiver_region region = {.count = 0};
    for (size_t j = 0; j < memory->tile_rows; j++) {
        if (lx_seen_find(plan, &memory->seen, memory->tile_y[j], memory->tile_x, memory->tile_columns) == 0)
            continue;
        const size_t count = lx_seen_gather(plan, &memory->seen, s, memory->tile_columns).count;
        extend(&places, block->px, block->py, block->pz, count);
        extend(&normals, block->nx, block->ny, block->nz, count);
        extend(&views, block->vx, block->vy, block->vz, count);
        region.count += count;
        for (size_t i = 0; asks_mirrored && i < count; i++) {
            const double nx = block->nx[i], ny = block->ny[i], nz = block->nz[i];
            const double twice = 2 * (nx * block->vx[i] + ny * block->vy[i] + nz * block->vz[i]);
            const double x = twice * nx - block->vx[i], y = twice * ny - block->vy[i], z = twice * nz - block->vz[i];
            extend(&mirrored, &x, &y, &z, 1);
        }
    }
    region.places = ball_around(&places);
    region.normals = cone_around(&normals);
    region.views = cone_around(&views);
    if (asks_mirrored)
        region.mirrored = cone_around(&mirrored);
    return region;
}

/* Makes the cut of what the tile shows of a surface, unless it is there; *made: so that the elements are lost. */
static const struct lx_cut *find_cut(const struct lx_plan *plan, struct lx_shader_memory *memory, size_t s,
                                     const struct lx_asking *asking, bool *made)
{
    struct lx_cut *cut = &memory->cuts[s % memory->cut_count];
    *made = cut->surface != &plan->surfaces[s];
    if (!*made)
        return cut;
    const struct lx_receiver_region region = find_receiver_region(plan, memory, s);
    return lx_cut_make(plan, &plan->surfaces[s], &region, asking, cut) ? cut : NULL;
}

/* ---- lobes that kernels do not know ---- */

/* What all light gives one element; a light that lies on it gives it nothing. */
static lx_bounded light_one(const struct lx_prepared *prepared, const struct lx_element *element,
                            const struct lx_asking *asking)
{
    lx_bounded sum = lx_exact(0);
    for (size_t e = 0; e < prepared->emitters.count && lx_asking_goes_on(asking); e++) {
        struct lx_emitter room;
        const struct lx_lighting light =
            lx_light_element(prepared, element, lx_emitter_at(&prepared->emitters, e, &room));
        if (!light.on_element)
            sum = lx_add(sum, lx_add(light.diffuse, light.specular));
    }
    return sum;
}

/* What a mirror shows at an element of it: what the sight of it meets there, lit as the picture lights that. */
static lx_bounded light_in_mirror(const struct lx_plan *plan, const struct lx_prepared *prepared,
                                  const struct lx_element *element, const struct lx_asking *asking)
{
    double place[3], screen[2];
    struct lx_element shown;
    lx_values3(element->place_mm, place);
    if (!lx_project(&prepared->camera, place, screen) || !lx_element_seen(prepared, screen[0], screen[1], &shown) ||
        shown.shown == LX_SHOWN_NOTHING)
        return lx_exact(0);
    shown.lobe = &plan->surfaces[shown.own - prepared->surfaces].lobe;
    return light_one(prepared, &shown, asking);
}

/* Sums all light over the gathered block, in batches of the world. */
static void light_by_reference(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                               struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking)
{
    const struct lx_block_double *block = &memory->seen.block;
    const double *anchor = surface->shape.anchor_mm;
    struct lx_prepared prepared = *plan->prepared;
    const struct lx_world world = {.prepared = &prepared, .kernels = lx_element_kernels_of(plan->kernels)};
    struct lx_elements elements;
    struct lx_received received;
    const bool is_mirror = plan->prepared->surfaces[surface - plan->surfaces].is_mirror;
    const bool goes_deeper = lx_goes_deeper(&prepared.mirrors);
    prepared.tolerance = plan->tolerance;
    plan->kernels->set_all(memory->sum, lx_padded(count), 0);
    for (size_t start = 0; start < count && (!memory->portion || memory->portion->lights); start += LX_BATCH) {
        const size_t end = start + LX_BATCH < count ? start + LX_BATCH : count;
        lx_elements_begin(&elements, &surface->lobe, false);
        for (size_t i = start; i < end; i++) {
            const struct lx_element element = {
                .place_mm =
                    lx_exact3((double[]){anchor[0] + block->px[i], anchor[1] + block->py[i], anchor[2] + block->pz[i]}),
                .normal = lx_exact3((double[]){block->nx[i], block->ny[i], block->nz[i]}),
                .view = lx_exact3((double[]){block->vx[i], block->vy[i], block->vz[i]}),
                .own = &prepared.surfaces[surface - plan->surfaces],
            };
            lx_elements_append(&prepared, &elements, &element);
        }
        lx_elements_end(&elements);
        if (!is_mirror)
            lx_world_light(&world, &elements, LX_WANT_BRIGHTNESS, asking, &received);
        for (size_t i = start; i < end; i++) {
            const struct lx_element element = lx_elements_get(&prepared, &elements, i - start);
            lx_bounded sum;
            if (is_mirror)
                sum = light_in_mirror(plan, &prepared, &element, asking);
            else if (received.on_element[i - start])
                sum = light_one(&prepared, &element, asking);
            else
                sum = (lx_bounded){received.diffuse.value[i - start] + received.specular.value[i - start],
                                   received.diffuse.error[i - start] + received.specular.error[i - start]};
            memory->sum[i] = sum.value;
            if (goes_deeper)
                memory->mirrored_error =
                    fmax(memory->mirrored_error, sum.error + (double)FLT_EPSILON * fabs(sum.value));
        }
    }
}

/* Sums the light that falls on elements of a surface; `cut`: of the clustered points, where there are some. */
static void light_surface(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          const struct lx_cut *cut, struct lx_shader_memory *memory, size_t elements,
                          const struct lx_asking *asking)
{
    if (surface->by_reference) {
        light_by_reference(plan, surface, memory, elements, asking);
        return;
    }
    light_block(plan, surface, memory, elements, asking);
    if (cut)
        lx_cut_shade(plan, cut, &memory->seen.block, &memory->seen.copy, elements, asking, memory->open, memory->sum);
    if (surface->area_light_count > 0 || surface->glossy_count > 0)
        lx_light_by_area_lights(plan, surface, memory, elements, asking);
    if (surface->opening_count > 0)
        lx_light_by_openings(plan, surface, memory, elements, asking);
}

/* The values of a row where elements in float32 are all that their light takes. */
static size_t shade_in_single(const struct lx_plan *plan, struct lx_shader_memory *memory, double y_mm,
                              const struct lx_asking *asking, double *values, uint8_t *mask)
{
    const size_t count = memory->tile_columns;
    const struct lx_stretch stretch = lx_seen_in_single(plan, &memory->seen, y_mm, mask);
    if (stretch.met < count)
        memset(values, 0, count * sizeof *values);
    if (stretch.met == 0)
        return 0;
    memory->sum = values + stretch.first;
    light_surface(plan, plan->alone, NULL, memory, stretch.count, asking);
    for (size_t i = stretch.first; stretch.met < stretch.count && i < stretch.first + stretch.count; i++)
        values[i] = mask[i] ? values[i] : 0;
    return stretch.met;
}

size_t lx_shade_row(const struct lx_plan *plan, struct lx_shader_memory *memory, size_t row, struct lx_control *control,
                    bool is_caller, double *values, uint8_t *mask)
{
    const struct lx_asking asking = {.control = control, .is_caller = is_caller};
    const double y_mm = memory->tile_y[row], *x_mm = memory->tile_x;
    const size_t count = memory->tile_columns;
    struct lx_seen *seen = &memory->seen;
    memory->error = 0;
    if (plan->alone)
        return shade_in_single(plan, memory, y_mm, &asking, values, mask);
    const size_t found = lx_seen_find(plan, seen, y_mm, x_mm, count);
    size_t left = found;
    memset(mask, seen->shows_one, count);
    memory->sum = seen->shows_one ? values : memory->room_of_sum;
    if (!seen->shows_one)
        memset(values, 0, count * sizeof *values);
    for (size_t i = 0; left > 0 && !seen->shows_one && i < count; i++)
        mask[i] = seen->shown[i] != 0;
    const size_t all = lx_found_count(&seen->found, seen->is_found, plan->surface_count);
    for (size_t i = 0; left > 0 && i < all; i++) {
        const size_t s = lx_found_at(&seen->found, seen->is_found, i);
        struct lx_seen_run gathered = lx_seen_gather(plan, seen, s, count);
        const struct lx_cut *cut = NULL;
        if (gathered.count == 0)
            continue;
        if (plan->trees.tree_count > 0 && !plan->surfaces[s].by_reference) {
            bool made;
            cut = find_cut(plan, memory, s, &asking, &made);
            if (!cut)
                return found;
            if (made) {
                lx_seen_find(plan, seen, y_mm, x_mm, count);
                gathered = lx_seen_gather(plan, seen, s, count);
            }
            memory->error = fmax(memory->error, cut->error);
        }
        light_surface(plan, &plan->surfaces[s], cut, memory, gathered.count, &asking);
        if (!seen->shows_one)
            lx_seen_scatter(seen, gathered, memory->sum, values);
        left -= gathered.count;
    }
    return found;
}

/* The values of a row of which few lights are all (at_once). */
static size_t shade_at_once(const struct lx_plan *plan, struct lx_shader_memory *memory, double y_mm, float *values,
                            uint8_t *mask)
{
    const struct lx_planned_surface *surface = plan->alone;
    const size_t count = memory->tile_columns, lights = surface->lights.count;
    const struct lx_stretch stretch = lx_seen_in_single(plan, &memory->seen, y_mm, mask);
    if (stretch.met < count)
        memset(values, 0, count * sizeof *values);
    if (stretch.met == 0)
        return 0;
    plan->kernels->value_single(lx_lights_single(&surface->lights, 0, lights, &memory->room), lights,
                                &surface->lobe_single, &memory->seen.copy, stretch.count, (float)surface->uniform,
                                values + stretch.first);
    for (size_t i = stretch.first; stretch.met < stretch.count && i < stretch.first + stretch.count; i++)
        values[i] = mask[i] ? values[i] : 0;
    return stretch.met;
}

size_t lx_shade_row_single(const struct lx_plan *plan, struct lx_shader_memory *memory, size_t row,
                           struct lx_control *control, bool is_caller, float *values, uint8_t *mask)
{
    _Alignas(64) double exact[LX_BLOCK];
    if (plan->at_once && !memory->portion)
        return shade_at_once(plan, memory, memory->tile_y[row], values, mask);
    const size_t found = lx_shade_row(plan, memory, row, control, is_caller, exact, mask);
    plan->kernels->round_all(exact, memory->tile_columns, values);
    return found;
}
