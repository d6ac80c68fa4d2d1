/* SPDX-License-Identifier: MIT */
/* The extended sources that tests share. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "extended_sources.h"
#include "light/solid/facets.h"

struct lx_emitter source_of(int kind, const double center[3], double radiance, double k_mm)
{
    static const double sides[3] = {300, 200, 100}, axis[3] = {0.3, -0.2, -1}, up[3] = {0.1, 1, 0};
    struct lx_emitter source = {
        .type = kind < DISK ? LX_FACETS : (enum lx_emitter_type)(LX_DISK + kind - DISK),
        .radiance = lx_exact(radiance),
        .axis = lx_unit3(lx_exact3(axis)),
        .radius_mm = 150,
        .height_mm = 400,
        .k_mm = k_mm,
        .coefficients = {0.2, 0.3, 0.4},
    };
    memcpy(source.center_mm, center, sizeof source.center_mm);
    switch (kind) {
    case RECTANGLE: source.facets = lx_facets_of_rectangle(center, sides, axis, up); break;
    case BOX: source.facets = lx_facets_of_box(center, sides); break;
    case GLOBE: source.facets = lx_facets_of_sphere(center, 150, 8); break;
    case PRISM: source.facets = lx_facets_of_cylinder(center, 150, 400, axis, 6); break;
    default: break;
    }
    assert_true(kind >= DISK || source.facets);
    return source;
}
