/* SPDX-License-Identifier: MIT */
/*
 * The thread that measures grids and rates what observers see, of which the latter waits for the hand to rest.  It has
 * solutions of reflected light of its own, at first to a hundredth: that of the picture, which has to hold at every
 * pixel, takes many times as long, and one to a thousandth, as `luxel grid` has it, much room.
 */
#include "../base/runner.h"
#include "lighting.h"

enum { REST_MS = 120, PATIENCE_MICROSECONDS = 400000, NICE = 8 };

typedef struct Job {
    luxel_scene *scene; /* not committed; NULL: a moment has taken it over */
    guint64 serial;
    gssize solo;
} Job;

typedef struct Found {
    AppGrids *grids;
    AppEyes *eyes;
    guint64 serial;
} Found;

struct AppSurvey {
    AppRunner *runner;
    AppSurveyTell tell;
    gpointer owner;
};

/* Grids go on for a while though they are outdated, so that they follow a hand that never rests. */
typedef struct Work {
    AppRunner *runner;
    gint64 until;
} Work;

static bool go_on(double done, void *data)
{
    const Work *work = data;
    (void)done;
    return !app_runner_is_outdated(work->runner) || g_get_monotonic_time() < work->until;
}

static void report(AppRunner *runner, guint64 serial, AppGrids *grids, AppEyes *eyes)
{
    Found *found = g_new(Found, 1);
    *found = (Found){grids, eyes, serial};
    app_runner_report(runner, found);
}

static gboolean reflects(const AppMoment *moment)
{
    char *reflections = NULL;
    const gboolean is_so = luxel_scene_get(moment->scene, "reflections", NULL, NULL, &reflections) == LUXEL_OK &&
                           g_strcmp0(reflections, "none") != 0;
    luxel_text_free(reflections);
    return is_so;
}

/* Whether a number's bound spans a limit; what has no number is not known any better later. */
static gboolean is_open(const luxel_limit *limits, gsize count)
{
    for (gsize i = 0; i < count; i++)
        if (limits[i].verdict == LUXEL_UNDECIDED && limits[i].has_value)
            return TRUE;
    return FALSE;
}

static gboolean are_grids_open(const AppGrids *grids)
{
    for (gsize i = 0; i < grids->count; i++)
        if (is_open(grids->list[i].limits, grids->list[i].limit_count))
            return TRUE;
    return FALSE;
}

static gboolean are_eyes_open(const AppEyes *eyes)
{
    for (gsize i = 0; i < eyes->count; i++)
        if (is_open(eyes->list[i].limits, eyes->list[i].limit_count))
            return TRUE;
    return FALSE;
}

static gboolean measure_grids(AppRunner *runner, AppMoment *moment, const luxel_settings *settings)
{
    AppGrids *grids = app_grids_new(moment, settings);
    const gboolean is_done = !grids || !reflects(moment) || !are_grids_open(grids);
    if (grids || !app_runner_is_outdated(runner))
        report(runner, moment->serial, grids, NULL);
    return is_done;
}

static gboolean rate_eyes(AppRunner *runner, AppMoment *moment, const luxel_settings *settings)
{
    AppEyes *eyes = app_eyes_new(moment, settings);
    const gboolean is_done = !eyes || !reflects(moment) || !are_eyes_open(eyes);
    if (eyes)
        report(runner, moment->serial, NULL, eyes);
    return is_done;
}

/* Limits that are left undecided are asked more exactly. */
static void measure(AppRunner *runner, AppMoment *moment)
{
    static const double errors[] = {0.01, 0.001};
    Work work = {runner, g_get_monotonic_time() + PATIENCE_MICROSECONDS};
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = 1;
    settings.progress = go_on;
    settings.progress_data = &work;
    app_moment_light(moment, &settings);
    for (gsize i = 0; i < G_N_ELEMENTS(errors) && (i == 0 || !app_runner_is_outdated(runner)); i++) {
        settings.reflected_error = errors[i];
        if (measure_grids(runner, moment, &settings))
            break;
        work.until = 0;
    }
    if (luxel_scene_observer_count(moment->scene) == 0 || app_runner_rest(runner, REST_MS))
        return;
    work.until = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(errors) && !app_runner_is_outdated(runner); i++) {
        settings.reflected_error = errors[i];
        if (rate_eyes(runner, moment, &settings))
            break;
    }
}

/* Scenes that are refused are not measured: the window says why. */
static void survey(AppRunner *runner, gpointer data, gpointer state)
{
    Job *job = data;
    luxel_diagnostics *faults = luxel_diagnostics_new();
    AppMoment *moment = app_moment_new(g_steal_pointer(&job->scene), job->serial, job->solo, faults);
    (void)state;
    if (moment)
        measure(runner, moment);
    app_moment_unref(moment);
    luxel_diagnostics_free(faults);
}

static void free_job(gpointer data)
{
    Job *job = data;
    luxel_scene_free(job->scene);
    g_free(job);
}

static void free_found(gpointer data)
{
    Found *found = data;
    app_grids_unref(found->grids);
    app_eyes_unref(found->eyes);
    g_free(found);
}

static void tell_found(gpointer data, gpointer owner)
{
    const Found *found = data;
    AppSurvey *survey = owner;
    survey->tell(found->grids, found->eyes, found->serial, survey->owner);
}

AppSurvey *app_survey_new(AppSurveyTell tell, gpointer owner)
{
    static const AppRunnerClass class = {"survey", survey, free_job, free_found, NULL, NICE};
    AppSurvey *self = g_new0(AppSurvey, 1);
    *self = (AppSurvey){.tell = tell, .owner = owner};
    self->runner = app_runner_new(&class, NULL, tell_found, self);
    return self;
}

void app_survey_free(AppSurvey *survey)
{
    if (!survey)
        return;
    app_runner_stop(survey->runner);
    g_free(survey);
}

void app_survey_ask(AppSurvey *survey, luxel_scene *scene, guint64 serial, gssize solo)
{
    Job *job = g_new(Job, 1);
    *job = (Job){scene, serial, solo};
    app_runner_post(survey->runner, job);
}
