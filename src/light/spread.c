/* SPDX-License-Identifier: MIT */
/* The part of preparing a light of some size that all of them share. */
#include "spread.h"

#include <math.h>

#include "../base/number.h"

const char *const lx_parts_names[] = {"converged", NULL};

/* The areas that the strength of a light may be divided by, in mm^2. */
static const double LEAST_AREA = 1e-100, MOST_AREA = 1e100;

int lx_shapes_add(struct lx_shapes *shapes, const struct lx_emitter *shape)
{
    shapes->area_mm2 = lx_add(shapes->area_mm2, lx_extended_area_mm2(shape));
    return lx_emitters_append(&shapes->emitters, shape);
}

int lx_shapes_add_facets(struct lx_shapes *shapes, struct lx_facets *facets)
{
    const struct lx_emitter shape = {.type = LX_FACETS, .facets = facets};
    return facets ? lx_shapes_add(shapes, &shape) : -1;
}

void lx_shapes_clear(struct lx_shapes *shapes)
{
    lx_emitters_clear(&shapes->emitters);
    *shapes = (struct lx_shapes){0};
}

lx_bounded lx_shapes_area(const struct lx_shapes *shapes)
{
    return lx_div(shapes->area_mm2, lx_exact(1e6));
}

lx_bounded lx_radiance_of_power(double power, const struct lx_shapes *shapes)
{
    return lx_div(lx_exact(power), lx_mul(lx_rounded(M_PI, 0, 1), lx_shapes_area(shapes)));
}

void lx_check_area(const struct lx_check *check, const char *key, const struct lx_shapes *shapes)
{
    double area = shapes->area_mm2.value;
    char number[LX_NUMBER_SIZE];
    if (area >= LEAST_AREA && area <= MOST_AREA)
        return;
    bool written = isfinite(area);
    lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_AREA_OUT_OF_RANGE,
                    LX_ARGS(written ? lx_write_digits(area, 3, number) : "∞"));
}

/* Into how many parts a shape is cut at least; `side`: how many each way, 0 where it is not cut. */
static double least_parts(const struct lx_emitter *shape, unsigned side)
{
    double faces = shape->facets ? (double)shape->facets->face_count : 1;
    return side > 0 ? faces * side * side : 1;
}

int lx_spread_emit(const struct lx_spread *spread, lx_bounded radiance, struct lx_shapes *shapes,
                   struct lx_emitters *emitters)
{
    const unsigned side = spread->parts.choice == LX_CONVERGED || emitters->is_whole ? 0 : spread->parts.whole;
    int result = 0;
    for (size_t i = 0; i < shapes->emitters.count && result == 0; i++) {
        struct lx_emitter *emitter = &shapes->emitters.items[i];
        emitter->radiance = radiance;
        lx_law_set(&spread->law, emitter);
        const double parts = least_parts(emitter, side);
        const size_t faces = side == 0 && emitter->facets ? emitter->facets->face_count : 0;
        const bool in_point_sets = emitter->facets && side >= LX_LEAST_IN_POINT_SET;
        result = lx_emitters_make_room(emitters, in_point_sets ? 0 : parts, faces, in_point_sets ? (size_t)parts : 0);
        if (result == 0 && side == 0) {
            result = lx_emitters_append(emitters, emitter);
            emitter->facets = NULL; /* they are the list's now */
        } else if (result == 0) {
            result = lx_extended_cut(emitter, side, emitters);
        }
    }
    lx_shapes_clear(shapes);
    return result;
}
