/* SPDX-License-Identifier: MIT */
/* Steps of one number of a key within what is legal. */
#include "steps.h"

#include <math.h>

enum { MOST_HALVINGS = 50 }; /* of the first step, until both of its ends are legal */

/* Things so near each other, by the size of the number, count as touching (a lamp in a ceiling): steps below tell
 * nothing of the scene. */
static const double LEAST_STEP = 1e-9;

double lx_step_of(const struct lx_stepping *stepping, unsigned row)
{
    const volatile double end = stepping->at + ldexp(stepping->first, -(int)row);
    const double step = end - stepping->at;
    return fabs(step) < LEAST_STEP * stepping->key->targets[stepping->target].scale ? 0.0 : step;
}

luxel_status lx_step_scene(const struct lx_stepping *stepping, double change, luxel_diagnostics *diagnostics,
                           luxel_scene **changed)
{
    return lx_key_shift(stepping->scene, stepping->key, stepping->target, stepping->number, change, diagnostics,
                        changed);
}

static bool is_legal(const struct lx_stepping *stepping, double change)
{
    luxel_scene *scene;
    const bool good = lx_step_scene(stepping, change, NULL, &scene) == LUXEL_OK;
    luxel_scene_free(scene);
    return good;
}

luxel_status lx_steps_find(const luxel_scene *scene, const struct lx_key *key, size_t target, size_t number,
                           luxel_diagnostics *diagnostics, struct lx_stepping *stepping)
{
    const double widest = key->targets[target].scale * 0.05;
    bool up = false, down = false;
    *stepping = (struct lx_stepping){.scene = scene,
                                     .key = key,
                                     .target = target,
                                     .number = number,
                                     .at = key->targets[target].numbers[number],
                                     .first = widest};
    for (int i = 0; i < MOST_HALVINGS; i++, stepping->first /= 2.0) {
        up = is_legal(stepping, stepping->first);
        down = is_legal(stepping, -stepping->first);
        if (up && down)
            return LUXEL_OK;
        /* a value at the end of what is legal stays there, however small the step */
        if ((up || down) && stepping->first < widest * 0x1p-30)
            break;
    }
    stepping->is_one_sided = true;
    for (stepping->first = up ? widest : -widest; fabs(stepping->first) > widest * 0x1p-30; stepping->first /= 2.0)
        if (is_legal(stepping, stepping->first))
            return LUXEL_OK;
    luxel_scene *changed;
    return lx_step_scene(stepping, widest, diagnostics, &changed);
}
