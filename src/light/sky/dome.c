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
    dome->zenith = zenith;
    dome->ground = ground;
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
    made->zenith = dome->zenith;
    made->ground = dome->ground;
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
        view->corners_mm[i] = lx_wide3_add(place, lx_wide3_mul(seen->facets->corners_mm[i], lx_wide_of(away_mm)));
    for (int k = 0; k < 3; k++)
        view->facets.center_mm[k] = place_mm[k] + away_mm * seen->facets->center_mm[k];
    view->facets.radius_mm *= away_mm * (1 + DIRECTION_ERROR);
    view->facets.area_mm2 *= away_mm * away_mm;
    view->face.area_mm2 *= away_mm * away_mm;
    view->facets.corner_error_mm = DIRECTION_ERROR * away_mm;
}

/* Cuts a polygon to what is on the side of a plane through the place to which the normal points; its corners stand as
 * offsets from the place.  Returns how many are left. */
static size_t cut_polygon(lx_wide3 *corners, size_t count, const lx_wide3 *normal)
{
    lx_wide3 kept[LX_MOST_VIEW_CORNERS];
    size_t left = 0;
    for (size_t i = 0; i < count; i++) {
        const lx_wide3 *from = &corners[i], *to = &corners[(i + 1) % count];
        const lx_wide above = lx_wide3_dot(*normal, *from), beyond = lx_wide3_dot(*normal, *to);
        if (above.high >= 0 && left < LX_MOST_VIEW_CORNERS)
            kept[left++] = *from;
        if ((above.high >= 0) != (beyond.high >= 0) && left < LX_MOST_VIEW_CORNERS) {
            const lx_wide share = lx_wide_div(above, lx_wide_sub(above, beyond));
            kept[left++] = lx_wide3_add(*from, lx_wide3_mul(lx_wide3_sub(*to, *from), share));
        }
    }
    memcpy(corners, kept, left * sizeof *corners);
    return left;
}

/* Lays a polygon of a view out anew; false: it has no area. */
static bool lay_polygon(struct lx_dome_view *view, size_t count, const double place_mm[3])
{
    const lx_wide3 place = lx_wide3_of(place_mm);
    struct lx_facets *facets = &view->facets;
    lx_wide3 sum = {{0, 0}, {0, 0}, {0, 0}};
    double middle[3] = {0}, corner[3];
    for (size_t i = 1; i + 1 < count; i++)
        sum = lx_wide3_add(sum, lx_wide3_cross(lx_wide3_sub(view->corners_mm[i], view->corners_mm[0]),
                                               lx_wide3_sub(view->corners_mm[i + 1], view->corners_mm[0])));
    view->face.area_mm2 = facets->area_mm2 = lx_wide_value(lx_wide3_length(sum)) / 2;
    view->face.first = 0;
    view->face.count = (unsigned)count;
    facets->corner_count = facets->edge_count = count;
    for (size_t i = 0; i < count; i++) {
        view->loop[i] = (unsigned)i;
        view->edges[i] = (struct lx_edge){(unsigned)i, (unsigned)((i + 1) % count), 0, LX_NO_FACE};
        lx_wide3_values(view->corners_mm[i], corner);
        for (int k = 0; k < 3; k++)
            middle[k] += corner[k] / (double)count;
        view->corners_mm[i] = lx_wide3_add(place, view->corners_mm[i]);
    }
    facets->radius_mm = 0;
    for (size_t i = 0; i < count; i++) {
        lx_wide3_values(lx_wide3_sub(view->corners_mm[i], place), corner);
        for (int k = 0; k < 3; k++)
            corner[k] -= middle[k];
        facets->radius_mm = fmax(facets->radius_mm, sqrt(lx_dot(corner, corner)) * (1 + DIRECTION_ERROR));
    }
    for (int k = 0; k < 3; k++)
        facets->center_mm[k] = place_mm[k] + middle[k];
    return facets->area_mm2 > 1e-28 * facets->radius_mm * facets->radius_mm && facets->area_mm2 > 0;
}

/* A polygon of offsets from a place, in the plane of an opening, that shines to the place; false: it has no area. */
static bool set_view(const lx_wide3 *corners, size_t count, lx_wide3 inwards, lx_bounded radiance,
                     const struct lx_sky *sky, const double place_mm[3], struct lx_dome_view *view)
{
    *view = (struct lx_dome_view){.facets = {.face_count = 1}, .face = {.normal = inwards}};
    view->emitter =
        (struct lx_emitter){.type = LX_FACETS, .radiance = radiance, .attenuation = LX_INVERSE_SQUARE, .sky = sky};
    view->emitter.facets = &view->facets;
    view->facets.faces = &view->face;
    view->facets.corners_mm = view->corners_mm;
    view->facets.edges = view->edges;
    view->facets.loop = view->loop;
    memcpy(view->corners_mm, corners, count * sizeof *corners);
    return count >= LX_DOME_CORNERS && lay_polygon(view, count, place_mm);
}

/* Whether a direction leads through a convex polygon around a place; its corners run counter-clockwise as seen from
 * there. */
static bool leads_through(const lx_wide3 *corners, size_t count, lx_wide3 towards)
{
    bool is_within = count >= LX_DOME_CORNERS;
    for (size_t i = 0; i < count && is_within; i++)
        is_within = lx_wide3_dot(lx_wide3_cross(corners[i], corners[(i + 1) % count]), towards).high <= 0;
    return is_within;
}

size_t lx_dome_see_through(const struct lx_dome *dome, const lx_wide3 rim[4], lx_wide3 outwards,
                           const double place_mm[3], double away_mm, bool is_cut,
                           struct lx_dome_view views[LX_MOST_DOME_VIEWS])
{
    enum { RIM = 4 };
    const lx_wide height = lx_wide3_dot(outwards, rim[0]);
    const lx_wide3 up = lx_wide3_of(dome->sky.up), down = lx_wide3_mul(up, lx_wide_of(-1));
    const lx_wide3 inwards = lx_wide3_mul(outwards, lx_wide_of(-1)), sun = lx_wide3_of(dome->sky.sun);
    const struct lx_sky *sky = dome->sky.kind == LX_SKY_UNIFORM ? NULL : &dome->sky;
    lx_wide3 above[LX_MOST_VIEW_CORNERS], below[LX_MOST_VIEW_CORNERS];
    size_t seen = 0;
    if (!(height.high > 0))
        return 0;
    const lx_wide scale = lx_wide_div(lx_wide_of(away_mm), height);
    const lx_wide3 across = lx_wide3_cross(lx_wide3_sub(rim[1], rim[0]), lx_wide3_sub(rim[2], rim[1]));
    const bool is_clockwise = lx_wide3_dot(across, inwards).high < 0;
    double size = 0;
    for (int i = 0; i < RIM; i++) {
        const lx_wide3 *corner = &rim[is_clockwise ? RIM - 1 - i : i];
        above[i] = below[i] = lx_wide3_mul(*corner, scale);
        size = fmax(size, fabs(corner->x.high) + fabs(corner->y.high) + fabs(corner->z.high));
    }
    const size_t above_count = cut_polygon(above, RIM, &up), below_count = cut_polygon(below, RIM, &down);
    const bool has_sun = is_cut && lx_sky_has_sun(dome->sky.kind) && leads_through(above, above_count, sun);
    if (dome->ground.value > 0)
        seen += set_view(below, below_count, inwards, dome->ground, NULL, place_mm, &views[seen]);
    for (size_t i = 0; i < above_count && has_sun; i++) {
        const lx_wide far = lx_wide_div(lx_wide_of(away_mm), lx_wide3_dot(outwards, sun));
        const lx_wide3 triangle[LX_DOME_CORNERS] = {lx_wide3_mul(sun, far), above[i], above[(i + 1) % above_count]};
        seen += set_view(triangle, LX_DOME_CORNERS, inwards, dome->zenith, sky, place_mm, &views[seen]);
    }
    if (dome->zenith.value > 0 && !has_sun)
        seen += set_view(above, above_count, inwards, dome->zenith, sky, place_mm, &views[seen]);
    for (int k = 0; k < 3; k++)
        size += fabs(place_mm[k]);
    for (size_t i = 0; i < seen; i++)
        views[i].facets.corner_error_mm = DIRECTION_ERROR * away_mm * (1 + size / height.high);
    return seen;
}

/* What it gives a plane that faces it, and from where: enough to tell how large other numbers are. */
static struct lx_sample sample_dome(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    (void)place_mm;
    return (struct lx_sample){.towards = lx_exact3(emitter->dome->up), .e_perp = emitter->dome->facing};
}

const struct lx_emitter_kind lx_dome_emitter = {.name = "dome", .sample = sample_dome};
