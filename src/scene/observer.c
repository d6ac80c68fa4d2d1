/* SPDX-License-Identifier: MIT */
/* The table of the observer, and the frame of the screen that it makes. */
#include "observer.h"

#include <math.h>
#include <string.h>

#include "../base/pose.h"
#include "../base/vector.h"
#include "../parameter/check.h"
#include "../parameter/decode.h"

static const char *const projection_names[] = {"orthographic", "perspective", NULL};
static const char *const view_names[] = {"parallel", "observer", NULL};

static const struct lx_parameter observer_parameters[] = {
    {
        .name = "z",
        .label = "Height z",
        .type = LX_REAL,
        .offset = offsetof(struct lx_observer, z_mm),
        .unit = LX_UNIT_MM,
        .advised = {LX_BETWEEN(100, 10000)},
        .meaning = "the height of the observer above the screen, at (0, 0, z); for pictures, outside of all surfaces "
                   "and above "
                   "them",
    },
    {
        .name = "position",
        .label = "Position",
        .type = LX_REALS,
        .offset = offsetof(struct lx_observer, position_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .meaning = "where the observer stands instead, anywhere in the scene; the screen is carried along as a whole, "
                   "its middle to the target, its z axis towards the position",
    },
    {
        .name = "target",
        .label = "Target",
        .type = LX_REALS,
        .offset = offsetof(struct lx_observer, target_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .meaning = "the place at which an observer with a position looks, in the middle of the screen",
    },
    {
        .name = "up",
        .label = "Up direction",
        .type = LX_REALS,
        .offset = offsetof(struct lx_observer, up),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning = "the direction that is up on the screen of an observer with a position, made perpendicular to the "
                   "way it looks; where it is not given and the observer looks along y, (0, 0, 1)",
    },
    {
        .name = "projection",
        .label = "Projection",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_observer, projection),
        .initial = "orthographic",
        .choices = projection_names,
        .meaning = "how points of the screen see the surface: along its z axis, or from the observer through the point",
    },
    {
        .name = "view",
        .label = "View vector",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_observer, view),
        .initial = "parallel",
        .choices = view_names,
        .meaning = "the view vector of the highlight: (0, 0, 1), the screen's z axis, everywhere, or from each point "
                   "to the observer",
    },
};

enum { Z, POSITION, TARGET, UP }; /* where they stand in the table */

static const struct lx_rule observer_rules[] = {
    {LX_RULE_ONE, "z", NULL, "z|position"},
    {LX_RULE_NEEDED, "target", "position", NULL},
    {LX_RULE_NEEDED, "position", "target", NULL},
    {LX_RULE_DISTINCT, "position", "target", NULL},
    {LX_RULE_USED, "up", "position", NULL},
    {LX_RULE_USED, "view", "projection", "orthographic"},
    {LX_RULE_POSITIVE, "z", "projection", "perspective"},
};

static bool is_given(const struct lx_observer *observer, int parameter)
{
    return observer->given >> parameter & 1;
}

/* The direction that is up where none is given, or that which is. */
static void choose_up(const struct lx_observer *observer, const double way[3], double up[3])
{
    if (is_given(observer, UP))
        memcpy(up, observer->up, sizeof observer->up);
    else
        lx_usual_up(way, up);
}

static void find_way(const struct lx_observer *observer, double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] = observer->position_mm[i] - observer->target_mm[i];
}

static void check_observer(const struct lx_check *check, void *parameters)
{
    const struct lx_observer *observer = parameters;
    double way[3];
    if (!lx_observer_is_placed(observer))
        return;
    find_way(observer, way);
    if (!isfinite(lx_observer_height(observer)))
        lx_check_report(check, "position", LX_ALL_OF_IT, LX_MSG_TOO_FAR_APART, NULL);
    else if (is_given(observer, UP) && lx_are_parallel(way, observer->up))
        lx_check_report(check, "up", LX_ALL_OF_IT, LX_MSG_UP_ALONG_VIEW, NULL);
}

const struct lx_table lx_observer_table = {
    .parameters = observer_parameters,
    .count = LX_COUNT(observer_parameters),
    .rules = observer_rules,
    .rule_count = LX_COUNT(observer_rules),
    .size = sizeof(struct lx_observer),
    .check = check_observer,
};

bool lx_observer_is_sound(const struct lx_observer *observer)
{
    double way[3];
    if (!lx_observer_is_placed(observer))
        return is_given(observer, Z);
    const double height = lx_observer_height(observer);
    find_way(observer, way);
    return is_given(observer, TARGET) && height > 0 && isfinite(height) &&
           !(is_given(observer, UP) && lx_are_parallel(way, observer->up));
}

bool lx_observer_is_placed(const struct lx_observer *observer)
{
    return is_given(observer, POSITION);
}

struct lx_frame lx_observer_frame(const struct lx_observer *observer)
{
    double way[3], up[3];
    if (!lx_observer_is_placed(observer))
        return lx_frame_own();
    find_way(observer, way);
    choose_up(observer, way, up);
    return lx_frame_towards(observer->target_mm, observer->position_mm, up);
}

const double *lx_scene_up(const struct lx_scene_parameters *scene)
{
    static const double axes[2][3] = {{0, 1, 0}, {0, 0, 1}};
    for (size_t i = 0; i < scene->surfaces.count; i++) {
        const struct lx_item *item = &scene->surfaces.items[i];
        const struct lx_parameter *up = lx_find_parameter(item->variant->table, "up");
        if (up && up->type == LX_CHOICE && lx_is_given(item->variant->table, item->parameters, "up"))
            return axes[strcmp(up->choices[*(const int *)lx_const_member(up, item->parameters)], "z") == 0];
    }
    return lx_is_given(&lx_observer_table, &scene->observer, "up") ? scene->observer.up : NULL;
}

double lx_observer_height(const struct lx_observer *observer)
{
    return lx_observer_is_placed(observer) ? lx_distance(observer->position_mm, observer->target_mm) : observer->z_mm;
}

void lx_observer_sight(const struct lx_scene_parameters *scene, const struct lx_glare_observer *observer, size_t place,
                       size_t view, double eye_mm[3], double direction[3])
{
    static const double z[3] = {0, 0, 1};
    const double *given = lx_scene_up(scene);
    double up[3], across[3], along[3];
    memcpy(up, given ? given : z, sizeof up);
    lx_normalize(up);
    /* across is x made level, or y where x goes up */
    const double sideways[3] = {fabs(up[0]) < 0.9, !(fabs(up[0]) < 0.9), 0};
    for (int i = 0; i < 3; i++)
        across[i] = sideways[i] - lx_dot(sideways, up) * up[i];
    lx_normalize(across);
    lx_cross(up, across, along);
    const double x = ((double)(place % observer->n[0]) + 0.5) / observer->n[0] - 0.5;
    const double y = 0.5 - ((double)(place / observer->n[0]) + 0.5) / observer->n[1];
    const double ways[LX_LEVEL_VIEWS][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int i = 0; i < 3; i++) {
        eye_mm[i] = observer->eye_mm[i] + x * observer->size_mm[0] * across[i] + y * observer->size_mm[1] * along[i];
        direction[i] = lx_observer_has_view(observer) ? observer->view[i]
                                                      : ways[view][0] * across[i] + ways[view][1] * along[i] + 0.0;
    }
}
