/* SPDX-License-Identifier: MIT */
/* Light on the cells of a plane by its measure: direct light by its lobe, what is reflected by its response. */
#include "plane_measure.h"

#include "../reflect/reflected.h"
#include "../surface/beside.h"

struct lx_plane_measure lx_plane_measure_of(enum lx_measure measure, const struct lx_cells *cells)
{
    struct lx_plane_measure made = {
        .measure = measure,
        .lobe = lx_lobe_of_measure(measure, false),
        .above = lx_lobe_of_measure(measure, true),
        .view = measure == LX_MEASURE_SEMICYLINDRICAL ? lx_wide3_direction(cells->pose.upward) : cells->normal,
        .response.measure = measure,
    };
    lx_values3(cells->normal, made.response.axis);
    lx_values3(made.view, made.response.view);
    return made;
}

static void set_all(struct lx_column *column, lx_bounded number)
{
    for (size_t i = 0; i < LX_BATCH; i++) {
        column->value[i] = number.value;
        column->error[i] = number.error;
    }
}

/* Whether an element lies on a surface as that does: light from below its horizon would come through. */
static bool lies_flat(const struct lx_world *world, const struct lx_elements *elements, size_t i)
{
    return elements->own[i] > 0 &&
           !lx_shape_is_turned(&world->prepared->surfaces[elements->own[i] - 1].shape,
                               lx_columns_get(&elements->place_mm, i), lx_columns_get(&elements->normal, i));
}

static void copy_number(const struct lx_column *from, size_t k, struct lx_column *to, size_t i)
{
    to->value[i] = from->value[k];
    to->error[i] = from->error[k];
}

/* Elements on a surface one by one, if they lie flat on it. */
static void light_flat(const struct lx_world *world, const struct lx_plane_measure *measure,
                       const struct lx_elements *elements, const struct lx_asking *asking, struct lx_received *received)
{
    for (size_t i = 0; i < elements->count && lx_asking_goes_on(asking); i++) {
        struct lx_elements one;
        struct lx_received own;
        if (!lies_flat(world, elements, i))
            continue;
        lx_elements_begin(&one, &measure->above, elements->are_free);
        lx_elements_copy(&one, elements, i);
        lx_elements_end(&one);
        lx_world_light(world, &one, LX_WANT_BRIGHTNESS, asking, &own);
        copy_number(&own.diffuse, 0, &received->diffuse, i);
        copy_number(&own.specular, 0, &received->specular, i);
        received->on_element[i] = own.on_element[0];
    }
}

static void reflect(const struct lx_world *world, const struct lx_plane_measure *measure,
                    const struct lx_elements *elements, const struct lx_asking *asking, struct lx_received *received)
{
    struct lx_occluder_cones cones = {0};
    for (size_t i = 0; i < elements->count && lx_asking_goes_on(asking); i++) {
        const struct lx_element element = lx_elements_get(world->prepared, elements, i);
        struct lx_receiver receivers[LX_MOST_RECEIVERS];
        const size_t count = lx_receivers_of(world->prepared, &element, &measure->response, receivers);
        lx_bounded sum = lx_exact(0);
        for (size_t k = 0; k < count; k++)
            sum = lx_add(sum, lx_reflected_at(world->reflected, world->prepared, &receivers[k], &cones));
        received->reflected.value[i] = sum.value;
        received->reflected.error[i] = cones.failed ? HUGE_VAL : sum.error;
    }
    lx_occluder_cones_clear(&cones);
}

void lx_plane_light(const struct lx_world *world, const struct lx_plane_measure *measure, struct lx_elements *elements,
                    const struct lx_asking *asking, struct lx_received *received)
{
    if (measure->measure == LX_MEASURE_PLANE) {
        const enum lx_wanted reflected = world->reflected ? LX_WANT_REFLECTED : (enum lx_wanted)0;
        lx_world_light(world, elements, (enum lx_wanted)(LX_WANT_IRRADIANCE | reflected), asking, received);
        return;
    }
    elements->lobe = &measure->lobe;
    set_all(&elements->view.x, measure->view.x);
    set_all(&elements->view.y, measure->view.y);
    set_all(&elements->view.z, measure->view.z);
    lx_world_light(world, elements, LX_WANT_BRIGHTNESS, asking, received);
    light_flat(world, measure, elements, asking, received);
    for (size_t i = 0; i < elements->count; i++) {
        const lx_bounded sum = lx_add(lx_column_get(&received->diffuse, i), lx_column_get(&received->specular, i));
        received->irradiance.value[i] = sum.value;
        received->irradiance.error[i] = sum.error;
    }
    if (world->reflected)
        reflect(world, measure, elements, asking, received);
}
