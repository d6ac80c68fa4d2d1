/* SPDX-License-Identifier: MIT */
/* Moments and shots: a committed scene, its field, and which version of the document they are of. */
#include <string.h>

#include "picture.h"

static void clear_moment(gpointer data)
{
    AppMoment *moment = data;
    app_moment_unref(moment->direct);
    luxel_surface_outlines_free(moment->outlines);
    luxel_scene_free(moment->scene);
}

AppMoment *app_moment_ref(AppMoment *moment)
{
    return g_atomic_rc_box_acquire(moment);
}

void app_moment_unref(AppMoment *moment)
{
    if (moment)
        g_atomic_rc_box_release_full(moment, clear_moment);
}

static void clear_shot(gpointer data)
{
    AppShot *shot = data;
    app_moment_unref(shot->moment);
    luxel_field_free(shot->field);
    app_shot_unref(shot->whole);
}

AppShot *app_shot_ref(AppShot *shot)
{
    return g_atomic_rc_box_acquire(shot);
}

void app_shot_unref(AppShot *shot)
{
    if (shot)
        g_atomic_rc_box_release_full(shot, clear_shot);
}

AppShot *app_shot_view(AppShot *shot, AppChannel channel)
{
    AppShot *whole = shot->whole ? shot->whole : shot;
    luxel_field *field = channel == shot->channel ? NULL : app_display_view(whole->field, channel);
    if (!field)
        return app_shot_ref(channel == shot->channel ? shot : whole);
    AppShot *made = g_atomic_rc_box_new0(AppShot);
    *made =
        (AppShot){app_moment_ref(whole->moment), field, whole->is_fine, whole->seconds, channel, app_shot_ref(whole)};
    return made;
}

const luxel_field *app_shot_light(const AppShot *shot)
{
    return shot->whole ? shot->whole->field : shot->field;
}

AppVersion app_version_of(const AppShot *shot, const AppShot *minus)
{
    return (AppVersion){shot->moment->serial, minus ? minus->moment->serial : 0, shot->moment->is_direct,
                        shot->channel};
}

gboolean app_version_equal(const AppVersion *a, const AppVersion *b)
{
    return a->shot == b->shot && a->minus == b->minus && a->is_direct == b->is_direct && a->channel == b->channel;
}

AppMoment *app_moment_new(luxel_scene *scene, guint64 serial, gssize solo, luxel_diagnostics *faults)
{
    if (luxel_scene_commit(scene, faults) != LUXEL_OK || luxel_scene_check_view(scene, faults) != LUXEL_OK) {
        luxel_scene_free(scene);
        return NULL;
    }
    AppMoment *moment = g_atomic_rc_box_new0(AppMoment);
    *moment = (AppMoment){.scene = scene, .serial = serial, .solo = solo, .only = (gsize)MAX(solo, 0)};
    return moment;
}

gboolean app_scene_leave_direct(luxel_scene *scene)
{
    char *reflections = NULL;
    const gboolean reflects = luxel_scene_get(scene, "reflections", NULL, NULL, &reflections) == LUXEL_OK &&
                              g_strcmp0(reflections, "none") != 0;
    luxel_text_free(reflections);
    return reflects && luxel_scene_set(scene, "reflections=none", NULL) == LUXEL_OK;
}

void app_moment_light(const AppMoment *moment, luxel_settings *settings)
{
    settings->lights = moment->solo >= 0 ? &moment->only : NULL;
    settings->light_count = moment->only < luxel_scene_light_count(moment->scene) ? 1 : 0;
}

gboolean app_moment_is_on(const AppMoment *moment, gsize light)
{
    return moment->solo >= 0 ? moment->only == light : luxel_scene_light_enabled(moment->scene, light);
}

const char *app_moment_unit(const AppMoment *moment, luxel_quantity quantity)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    app_moment_light(moment, &settings);
    return luxel_settings_unit(moment->scene, &settings);
}
