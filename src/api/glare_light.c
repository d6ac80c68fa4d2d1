/* SPDX-License-Identifier: MIT */
/* Areas that lights show: those of their emitters, and of a luminaire that shines as a point, of its file's opening. */
#include "glare_light.h"

#include "../base/pose.h"
#include "../base/vector.h"
#include "../format/lamp/photometry_area.h"
#include "../light/distribution.h"
#include "../light/solid/elliptic.h"
#include "../light/solid/extended.h"
#include "../light/totals.h"

/* The area in m^2 that an emitter shows to a direction; 0: it has none. */
static double area_seen(const struct lx_emitter *emitter, const double from_source[3])
{
    const struct lx_pointed *pointed = emitter->profile.luminaire;
    if (lx_is_extended(emitter) && !lx_is_elliptic(emitter))
        return lx_emitter_kind(emitter)->area_seen_mm2(emitter, from_source) / 1e6;
    if (!pointed || emitter->is_back)
        return 0;
    const lx_bounded3 *const ways[3] = {&pointed->axis, &pointed->c0, &pointed->across};
    double direction[3];
    for (int i = 0; i < 3; i++)
        direction[i] = lx_dot((const double[3]){ways[i]->x.value, ways[i]->y.value, ways[i]->z.value}, from_source);
    return lx_opening_seen_area(&pointed->distribution->photometry->shown.opening, direction);
}

/* All emitters together; points of a cloud are many sources and show no area. */
void lx_see_emitters(const struct lx_emitters *emitters, const double eye_mm[3], struct lx_light_seen *seen)
{
    struct lx_emitter room;
    double middle[3], from_source[3];
    *seen = (struct lx_light_seen){.radiance = lx_exact(0)};
    const bool is_one = emitters->count == 1 || emitters->extended == emitters->count;
    seen->is_uniform = emitters->count == 1 && lx_is_uniform(lx_emitter_at(emitters, 0, &room));
    if (!is_one || emitters->count == 0 || !lx_emitters_place(emitters, middle))
        return;
    for (int i = 0; i < 3; i++)
        seen->towards[i] = (middle[i] - eye_mm[i]) / 1e3;
    seen->distance_m = lx_normalize(seen->towards);
    for (int i = 0; i < 3; i++)
        from_source[i] = -seen->towards[i];
    for (size_t i = 0; i < emitters->count && seen->distance_m > 0; i++) {
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        seen->area_m2 += area_seen(emitter, from_source);
        if (lx_is_extended(emitter) && lx_has_closed_form(emitter))
            seen->radiance = emitter->radiance;
    }
}
