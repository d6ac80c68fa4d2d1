/* SPDX-License-Identifier: MIT */
/* The smallest turn between two directions, made of others. */
#include "turn.h"

#include <math.h>

#include "../base/geometry.h"
#include "../base/number.h"
#include "marks.h"

struct AppTurn {
    gsize held;
    double from[3];    /* unit */
    GArray *followers; /* Follower */
};

typedef struct {
    gsize index;
    double from[3]; /* unit */
} Follower;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

AppTurn *app_turn_begin(AppDocument *document, const GArray *lights, gsize held)
{
    AppTurn *turn = g_new0(AppTurn, 1);
    turn->held = held;
    turn->followers = g_array_new(FALSE, FALSE, sizeof(Follower));
    const gboolean is_held = app_mark_direction(document, held, turn->from);
    for (guint i = 0; is_held && i < lights->len; i++) {
        Follower follower = {.index = g_array_index(lights, gsize, i)};
        if (follower.index != held && app_mark_direction(document, follower.index, follower.from))
            g_array_append_val(turn->followers, follower);
    }
    if (turn->followers->len > 0)
        return turn;
    app_turn_free(turn);
    return NULL;
}

/* Turns a vector as `from` is turned into `to`, both of unit length, about what is at right angles to both; where they
 * are opposite, about the upright or, where that is their own direction, about x. */
static void turn_along(const double from[3], const double to[3], const double a[3], double turned[3])
{
    static const double SAME = 1e-9;
    const double up[3] = {0, 0, 1}, right[3] = {1, 0, 0};
    double axis[3], aside[3], cosine = dot(from, to);
    app_cross(from, to, axis);
    double sine = sqrt(dot(axis, axis));
    if (sine < SAME) {
        app_cross(from, fabs(from[2]) < 0.9 ? up : right, aside);
        app_cross(aside, from, axis); /* at right angles to both, nearest to the upright */
        sine = cosine < 0 ? SAME : 0;
        cosine = cosine < 0 ? -1 : 1;
    }
    const double length = sqrt(dot(axis, axis));
    for (int k = 0; k < 3; k++)
        axis[k] /= length;
    const double along = dot(axis, a) * (1 - cosine);
    app_cross(axis, a, aside);
    for (int k = 0; k < 3; k++)
        turned[k] = cosine * a[k] + sine * aside[k] + along * axis[k];
}

void app_turn_follow(const AppTurn *turn, AppDocument *document)
{
    enum { DIGITS = 10000 };
    double to[3], turned[3];
    if (!turn || !app_mark_direction(document, turn->held, to))
        return;
    for (guint i = 0; i < turn->followers->len; i++) {
        const Follower *follower = &g_array_index(turn->followers, Follower, i);
        turn_along(turn->from, to, follower->from, turned);
        for (int k = 0; k < 3; k++)
            turned[k] = round(turned[k] * DIGITS) / DIGITS + 0.0; /* no -0 */
        char *key = g_strdup_printf("lights[%zu].direction", follower->index), *list = app_list_write(turned, 3);
        app_document_set(document, key, list, NULL);
        g_free(list);
        g_free(key);
    }
}

void app_turn_free(AppTurn *turn)
{
    if (!turn)
        return;
    g_array_unref(turn->followers);
    g_free(turn);
}
