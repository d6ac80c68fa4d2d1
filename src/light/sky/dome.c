/* SPDX-License-Identifier: MIT */
/* Making domes of patches, and patches as extended emitters. */
#include "dome.h"

#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../carry.h"
#include "../emitter_kind.h"
#include "../solid/facets.h"

/* Directions are good to that. */
static const double DIRECTION_ERROR = 4 * DBL_EPSILON;

static void free_dome(struct lx_kept *kept)
{
    struct lx_dome *dome = (struct lx_dome *)kept;
    for (size_t i = 0; i < dome->patch_count; i++)
        lx_facets_free(dome->patches[i].facets);
    free(dome);
}

void lx_dome_free(struct lx_dome *dome)
{
    if (dome)
        lx_kept_release(&dome->kept);
}

static struct lx_dome *new_dome(void)
{
    struct lx_dome *dome = lx_new_array(1, sizeof *dome);
    if (dome)
        lx_kept_init(&dome->kept, free_dome);
    return dome;
}

/* ---- the sky ---- */

/* Appends a triangle between directions, however they run, which shines inwards; one without an area is left out.
 * 0, or -1 when memory ran out. */
static int add_triangle(struct lx_dome *dome, const double *a, const double *b, const double *c, lx_bounded radiance,
                        bool is_even)
{
    static const double LEAST = 1e-12;
    double corners[LX_DOME_CORNERS][3], cross[3];
    struct lx_facets **facets = NULL;
    size_t count = 0;
    lx_cross(b, c, cross);
    const double volume = lx_dot(a, cross);
    memcpy(corners[0], a, sizeof corners[0]);
    memcpy(corners[1], volume > 0 ? c : b, sizeof corners[1]);
    memcpy(corners[2], volume > 0 ? b : c, sizeof corners[2]);
    if (!(fabs(volume) > LEAST))
        return 0;
    const struct lx_shape_report report =
        lx_facets_of_outline((const double(*)[3])corners, LX_DOME_CORNERS, &facets, &count);
    if (report.fault != LX_SHAPE_GOOD || count != 1) {
        for (size_t i = 0; i < count; i++)
            lx_facets_free(facets[i]);
        free((void *)facets);
        return -1;
    }
    dome->patches[dome->patch_count++] =
        (struct lx_dome_patch){.facets = facets[0], .radiance = radiance, .is_even = is_even};
    free((void *)facets);
    return 0;
}

/* The sky between the horizon, `around` it at right angles, and the zenith.  The sun stands over the first of these;
 * where it is the zenith or on the horizon, triangles vanish. */
static int add_sky(struct lx_dome *dome, const struct lx_sky *sky, const double around[4][3], lx_bounded radiance)
{
    static const double NEAR = 1e-7; /* a corner that is off so little is no matter */
    const bool has_sun = lx_sky_has_sun(sky->kind), is_even = sky->kind == LX_SKY_UNIFORM;
    const double *sun = sky->sun, *up = sky->up;
    const bool is_zenith = !has_sun || lx_angle_between(sun, up) < NEAR;
    const bool is_low = has_sun && lx_dot(sun, up) < NEAR;
    int failed = 0;
    for (int i = 0; i < 4 && !failed; i++) {
        const double *from = around[i], *to = around[(i + 1) % 4];
        const bool is_before = i == 0 || i == 3;
        if (!is_before || is_zenith || is_low) {
            failed = add_triangle(dome, up, from, to, radiance, is_even);
            continue;
        }
        failed = add_triangle(dome, sun, from, to, radiance, is_even) ||
                 add_triangle(dome, sun, i == 0 ? to : from, up, radiance, is_even);
    }
    return failed ? -1 : 0;
}

struct lx_dome *lx_dome_of_sky(const struct lx_sky *sky, lx_bounded zenith, lx_bounded ground)
{
    struct lx_dome *dome = new_dome();
    double around[4][3], away[3];
    if (!dome)
        return NULL;
    dome->sky = *sky;
    memcpy(dome->up, sky->up, sizeof dome->up);
    dome->facing = lx_mul(zenith, lx_sky_horizontal(sky));
    const double along = lx_dot(sky->sun, sky->up);
    for (int k = 0; k < 3; k++) {
        around[0][k] = sky->sun[k] - along * sky->up[k];
        away[k] = -sky->up[k];
    }
    if (!(lx_normalize(around[0]) > 1e-9)) {
        double other[3];
        lx_around_axis(sky->up, around[0], other);
    } else {
        const double rest = lx_dot(around[0], sky->up);
        for (int k = 0; k < 3; k++)
            around[0][k] -= rest * sky->up[k];
        lx_normalize(around[0]);
    }
    lx_cross(sky->up, around[0], around[1]);
    for (int k = 0; k < 3; k++) {
        around[2][k] = -around[0][k];
        around[3][k] = -around[1][k];
    }
    int failed = zenith.value > 0 ? add_sky(dome, sky, (const double(*)[3])around, zenith) : 0;
    for (int i = 0; i < 4 && ground.value > 0 && !failed; i++)
        failed = add_triangle(dome, away, around[i], around[(i + 1) % 4], ground, true);
    if (!failed)
        return dome;
    lx_dome_free(dome);
    return NULL;
}

struct lx_dome *lx_dome_of_disk(lx_bounded3 towards, double half_rad, double irradiance)
{
    struct lx_dome *dome = new_dome();
    const double sine = sin(half_rad);
    if (!dome)
        return NULL;
    lx_values3(towards, dome->up);
    dome->facing = lx_exact(irradiance);
    dome->patches[dome->patch_count++] =
        (struct lx_dome_patch){.towards = towards,
                               .radius = tan(half_rad),
                               .radiance = lx_rounded(irradiance / (M_PI * sine * sine), 0, 16),
                               .is_even = true};
    return dome;
}

struct lx_dome *lx_dome_carry(const struct lx_dome *dome, const struct lx_frame *frame)
{
    struct lx_dome *made = new_dome();
    struct lx_frame turned = *frame;
    memset(turned.origin_mm, 0, sizeof turned.origin_mm);
    if (!made)
        return NULL;
    made->sky = dome->sky;
    made->facing = dome->facing;
    lx_frame_turn(frame, dome->up, made->up);
    lx_frame_turn(frame, dome->sky.up, made->sky.up);
    lx_frame_turn(frame, dome->sky.sun, made->sky.sun);
    for (; made->patch_count < dome->patch_count; made->patch_count++) {
        struct lx_dome_patch *patch = &made->patches[made->patch_count];
        *patch = dome->patches[made->patch_count];
        patch->towards = lx_frame_turn_bounded(frame, patch->towards);
        if (!patch->facets)
            continue;
        patch->facets = lx_facets_carry(patch->facets, &turned, NULL);
        if (!patch->facets) {
            lx_dome_free(made);
            return NULL;
        }
    }
    return made;
}

/* ---- patches as emitters ---- */

void lx_dome_see(const struct lx_dome *dome, size_t patch, const double place_mm[3], double away_mm,
                 struct lx_dome_view *view)
{
    const struct lx_dome_patch *seen = &dome->patches[patch];
    view->emitter = (struct lx_emitter){
        .type = seen->facets ? LX_FACETS : LX_DISK,
        .radiance = seen->radiance,
        .attenuation = LX_INVERSE_SQUARE,
        .sky = seen->is_even ? NULL : &dome->sky,
    };
    if (!seen->facets) {
        double towards[3];
        lx_values3(seen->towards, towards);
        for (int k = 0; k < 3; k++)
            view->emitter.center_mm[k] = place_mm[k] + away_mm * towards[k];
        view->emitter.radius_mm = away_mm * seen->radius;
        view->emitter.axis = lx_negate3(seen->towards);
        return;
    }
    view->facets = *seen->facets;
    view->face = seen->facets->faces[0];
    view->emitter.facets = &view->facets;
    view->facets.faces = &view->face;
    view->facets.corners_mm = view->corners_mm;
    const lx_wide3 place = lx_wide3_of(place_mm);
    for (size_t i = 0; i < view->facets.corner_count; i++)
        view->corners_mm[i] =
            lx_wide3_add(place, lx_wide3_mul(seen->facets->corners_mm[i], lx_wide_of(away_mm)));
    for (int k = 0; k < 3; k++)
        view->facets.center_mm[k] = place_mm[k] + away_mm * seen->facets->center_mm[k];
    view->facets.radius_mm *= away_mm * (1 + DIRECTION_ERROR);
    view->facets.area_mm2 *= away_mm * away_mm;
    view->face.area_mm2 *= away_mm * away_mm;
    view->facets.corner_error_mm = DIRECTION_ERROR * away_mm;
}

/* What it gives a plane that faces it, and from where: enough to tell how large other numbers are. */
static struct lx_sample sample_dome(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    (void)place_mm;
    return (struct lx_sample){.towards = lx_exact3(emitter->dome->up), .e_perp = emitter->dome->facing};
}

const struct lx_emitter_kind lx_dome_emitter = {.name = "dome", .sample = sample_dome};
