/* SPDX-License-Identifier: MIT */
/* The two threads that read numbers off a shot. */
#include "measures.h"

#include <math.h>
#include <string.h>

#include "../base/runner.h"
#include "color.h"

enum {
    REST_MS = 120,
    PATIENCE_MICROSECONDS = 60000,
    PATIENCE_OF_POINTS = 400000,
    SECTION_SAMPLES = 401,
    BINS = 64,
    LEVELS = 8,
    MOST_LEVELS = 64
};

/* ---- shared ---- */

/* What is kept of a shot as long as it is asked about. */
typedef struct Kept {
    AppShot *shot;
    luxel_evaluator *evaluator; /* NULL: there is none, or it was not asked for yet */
    guint8 *grey;               /* levels, likewise */
    AppRunner *runner;
    gint64 begun;    /* when the present answer was, monotonic time */
    gint64 patience; /* so long it goes on although it is outdated */
} Kept;

static void drop(Kept *kept)
{
    g_clear_pointer(&kept->evaluator, luxel_evaluator_free);
    g_clear_pointer(&kept->shot, app_shot_unref);
    g_clear_pointer(&kept->grey, g_free);
}

/* Another picture, or channel, of the same scene has other pixels only. */
static void keep(Kept *kept, AppShot *shot)
{
    if (kept->shot == shot)
        return;
    luxel_evaluator *evaluator = kept->shot && kept->shot->moment == shot->moment ? kept->evaluator : NULL;
    if (evaluator)
        kept->evaluator = NULL;
    drop(kept);
    kept->shot = app_shot_ref(shot);
    kept->evaluator = evaluator;
}

/* The shot that is asked about, and the one that is taken off. */
typedef struct Both {
    Kept shot, minus;
} Both;

static void free_both(gpointer data)
{
    Both *both = data;
    drop(&both->shot);
    drop(&both->minus);
    g_free(both);
}

/* What is nearly done is worth more than what is newer: a line that moves all the time is followed all the same. */
static bool go_on(double done, void *data)
{
    const Kept *kept = data;
    (void)done;
    return !app_runner_is_outdated(kept->runner) || g_get_monotonic_time() - kept->begun < kept->patience;
}

/* One thread, as pictures have the others; the answers are the same.  Reflected light is what the picture has. */
static luxel_settings settings_of(const AppShot *shot, Kept *kept)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.share_reflected = true;
    settings.quantity = luxel_field_quantity(shot->field);
    settings.threads = 1;
    settings.progress = go_on;
    settings.progress_data = kept;
    app_moment_light(shot->moment, &settings);
    return settings;
}

static const luxel_evaluator *evaluator_of(Kept *kept, AppRunner *runner, AppShot *shot)
{
    luxel_settings settings = settings_of(shot, kept);
    kept->runner = runner;
    kept->begun = g_get_monotonic_time();
    kept->patience = PATIENCE_MICROSECONDS;
    keep(kept, shot);
    if (!kept->evaluator && luxel_evaluator_new(shot->moment->scene, &settings, NULL, &kept->evaluator) != LUXEL_OK)
        kept->evaluator = NULL;
    return kept->evaluator;
}

static gboolean is_grey(const AppShot *shot)
{
    return luxel_field_channels(app_shot_light(shot)) == 1;
}

/* The grey level of a pixel of a fine shot. */
static guint8 grey_at(Kept *kept, AppShot *shot, guint column, guint row)
{
    const gsize columns = luxel_field_columns(shot->field);
    keep(kept, shot);
    if (!kept->grey) {
        kept->grey = g_malloc(columns * luxel_field_rows(shot->field));
        luxel_field_grey(shot->field, kept->grey);
    }
    return kept->grey[row * columns + column];
}

/* The sample nearest to a value among samples that rise or fall; FALSE beyond half a step from the ends. */
static gboolean nearest(const double *samples, guint count, double value, guint *index)
{
    if (count < 2) {
        *index = 0;
        return count == 1;
    }
    double step = (samples[count - 1] - samples[0]) / (count - 1), place = (value - samples[0]) / step;
    if (!(place >= -0.5 - 1e-9 && place <= count - 0.5 + 1e-9))
        return FALSE;
    *index = (guint)CLAMP(floor(place + 0.5), 0, count - 1);
    return TRUE;
}

gboolean app_pixel_at(const luxel_field *field, double x_mm, double y_mm, guint *column, guint *row)
{
    return nearest(luxel_field_x_mm(field), luxel_field_columns(field), x_mm, column) &&
           nearest(luxel_field_y_mm(field), luxel_field_rows(field), y_mm, row);
}

/* ---- points and sources ---- */

/* The points of a shot's scene by the scene of another one, or of itself; NULL: it was given up, or failed. */
static luxel_probes *probe_points(const AppShot *of, const AppShot *by, gsize count, Kept *kept)
{
    luxel_settings settings = settings_of(by, kept);
    luxel_place *places = g_new0(luxel_place, count);
    luxel_probes *probes = NULL;
    for (gsize i = 0; i < count; i++)
        luxel_scene_point(of->moment->scene, i, &places[i].screen_mm[0], &places[i].screen_mm[1]);
    if (luxel_probe_places(by->moment->scene, &settings, places, count, NULL, &probes) != LUXEL_OK)
        probes = NULL;
    g_free(places);
    return probes;
}

static AppPoint point_of(Kept *kept, AppShot *shot, const luxel_probe *probe)
{
    AppPoint point = {
        .x_mm = probe->x_mm,
        .y_mm = probe->y_mm,
        .on_surface = probe->on_surface,
        .has_value = probe->has_value,
        .source_on_element = probe->source_on_element,
        .value = probe->value,
        .error = probe->error,
        .has_pixel = probe->has_pixel && probe->has_pixel_value,
        .pixel_value = probe->pixel_value,
        .color = probe->color,
        .column = probe->column,
        .row = probe->row,
    };
    point.has_grey = point.has_pixel && shot->is_fine && is_grey(shot);
    if (point.has_grey)
        point.grey = grey_at(kept, shot, point.column, point.row);
    return point;
}

/* Takes off what the other shot has at the same place. */
static void take_off(AppPoint *point, const luxel_probe *probe)
{
    point->has_grey = point->color.exists = FALSE;
    point->on_surface = point->on_surface && probe->on_surface;
    point->source_on_element = point->source_on_element || probe->source_on_element;
    point->has_value = point->has_value && probe->has_value;
    point->value -= probe->value;
    point->error += probe->error;
    point->has_pixel = point->has_pixel && probe->has_pixel && probe->has_pixel_value;
    point->pixel_value -= probe->pixel_value;
}

/* The point of the screen at which the sources are asked what they give; FALSE: there is none. */
static gboolean find_place(const AppQuestion *question, const luxel_scene *scene, double screen_mm[2])
{
    double center[3];
    memcpy(screen_mm, question->place_mm, sizeof question->place_mm);
    return question->is_placed ||
           (luxel_scene_surface_place(scene, 0, center) == LUXEL_OK && luxel_scene_project(scene, center, screen_mm));
}

/* The irradiance that each source gives at a place. */
static void read_sources(const AppQuestion *question, Kept *kept, AppMeasures *measures)
{
    const AppShot *shot = measures->live;
    const AppMoment *moment = shot->moment->direct ? shot->moment->direct : shot->moment;
    const luxel_scene *scene = moment->scene;
    luxel_settings irradiance = settings_of(shot, kept);
    luxel_probe *probe = NULL;
    double screen[2];
    measures->source_count = luxel_scene_light_count(scene);
    measures->sources = g_new0(AppSource, measures->source_count);
    irradiance.quantity = LUXEL_IRRADIANCE;
    irradiance.tolerance = 1e-6;
    app_moment_light(moment, &irradiance);
    if (find_place(question, scene, screen) &&
        luxel_probe_screen(scene, &irradiance, screen[0], screen[1], NULL, &probe) != LUXEL_OK)
        probe = NULL;
    for (gsize i = 0; i < measures->source_count; i++) {
        AppSource *source = &measures->sources[i];
        source->irradiance = (double)NAN;
        if (luxel_scene_light_flux(scene, i, &source->flux) != LUXEL_OK)
            source->flux = (double)NAN;
    }
    for (gsize k = 0; probe && k < probe->share_count; k++)
        measures->sources[probe->shares[k].light].irradiance = probe->shares[k].irradiance;
    luxel_probe_free(probe);
}

static AppMeasures *new_measures(const AppQuestion *question)
{
    AppMeasures *measures = g_new0(AppMeasures, 1);
    measures->version = app_version_of(question->shot, question->minus);
    measures->shot = app_shot_ref(question->shot);
    measures->live = app_shot_ref(question->live ? question->live : question->shot);
    measures->is_difference = question->minus != NULL;
    return measures;
}

static void free_measures(gpointer data)
{
    AppMeasures *measures = data;
    app_shot_unref(measures->shot);
    app_shot_unref(measures->live);
    g_free(measures->points);
    g_free(measures->sources);
    app_curve_free(measures->curves[0]);
    app_curve_free(measures->curves[1]);
    luxel_histogram_free(measures->histogram);
    luxel_isophotes_free(measures->isophotes);
    luxel_balance_free(measures->balance);
    g_free(measures);
}

static void measure_sources(AppRunner *runner, const AppQuestion *question, Kept *kept)
{
    AppMeasures *measures = new_measures(question);
    measures->has_sources = TRUE;
    read_sources(question, kept, measures);
    app_runner_report(runner, measures);
}

static void measure_points(AppRunner *runner, const AppQuestion *question, Kept *kept)
{
    const gsize all = luxel_scene_point_count(question->shot->moment->scene), count = MIN(all, APP_MOST_POINTS);
    luxel_probes *probes = count > 0 ? probe_points(question->shot, question->shot, count, kept) : NULL;
    luxel_probes *minus = probes && question->minus ? probe_points(question->shot, question->minus, count, kept) : NULL;
    const gboolean is_whole = probes && (minus || !question->minus);
    if (count == 0 || is_whole || !app_runner_is_outdated(runner)) { /* else it was given up */
        AppMeasures *measures = new_measures(question);
        measures->has_points = TRUE;
        measures->point_count = count;
        measures->points_left = all - count;
        measures->points = g_new0(AppPoint, count);
        for (gsize i = 0; i < count; i++) {
            AppPoint *point = &measures->points[i];
            luxel_scene_point(question->shot->moment->scene, i, &point->x_mm, &point->y_mm);
            if (is_whole)
                *point = point_of(kept, question->shot, luxel_probes_get(probes, i));
            if (is_whole && minus)
                take_off(point, luxel_probes_get(minus, i));
        }
        app_runner_report(runner, measures);
    }
    luxel_probes_free(probes);
    luxel_probes_free(minus);
}

/* ---- sections ---- */

/* Whether it was not given up; *profile NULL: there is none. */
static gboolean read_section(const luxel_profile_path *path, const luxel_evaluator *evaluator, luxel_profile **profile)
{
    const luxel_status status = luxel_find_profile(evaluator, path, NULL, profile);
    if (status != LUXEL_OK)
        *profile = NULL;
    return status != LUXEL_CANCELLED;
}

/* The same; `minus` NULL: nothing is taken off.  The way is that across the shot's screen. */
static gboolean read_curve(const AppQuestion *question, const luxel_evaluator *evaluator, const luxel_evaluator *minus,
                           double degrees, AppCurve **curve)
{
    luxel_profile_path path = {.type = LUXEL_PATH_LINE, .samples = SECTION_SAMPLES};
    luxel_profile *profile = NULL, *other = NULL;
    *curve = NULL;
    if (luxel_profile_line(question->shot->moment->scene, question->section_mm, degrees, NULL, path.from_mm,
                           path.to_mm) != LUXEL_OK)
        return TRUE;
    const gboolean whole = read_section(&path, evaluator, &profile) && (!minus || read_section(&path, minus, &other));
    if (whole && profile && (other || !question->minus))
        *curve = app_curve_new(g_steal_pointer(&profile), other);
    luxel_profile_free(profile);
    luxel_profile_free(other);
    return whole;
}

/* The curves that are shown stay until there are newer ones: half a section is not told. */
static void measure_section(AppRunner *runner, const AppQuestion *question, const luxel_evaluator *evaluator,
                            const luxel_evaluator *minus)
{
    AppMeasures *measures = new_measures(question);
    memcpy(measures->section_mm, question->section_mm, sizeof measures->section_mm);
    measures->has_section = read_curve(question, evaluator, minus, 0, &measures->curves[0]) &&
                            read_curve(question, evaluator, minus, 90, &measures->curves[1]);
    if (measures->has_section)
        app_runner_report(runner, measures);
    else
        free_measures(measures);
}

/* ---- what waits for the hand to rest ---- */

/* Which pixels light arrives at is found out by a picture of its own, as those that follow the hand do not tell. */
static luxel_extremum find_reached(const AppShot *shot, Kept *kept)
{
    luxel_settings settings = settings_of(shot, kept);
    luxel_field *field;
    settings.minimum_reached = true;
    if (luxel_render(shot->moment->scene, &settings, NULL, &field) != LUXEL_OK)
        return (luxel_extremum){.exists = false};
    const luxel_extremum reached = luxel_field_statistics(field)->minimum_reached;
    luxel_field_free(field);
    return reached;
}

static void measure_statistics(AppRunner *runner, const AppQuestion *question, const luxel_evaluator *evaluator,
                               Kept *kept)
{
    AppMeasures *measures = new_measures(question);
    luxel_comparison comparison;
    luxel_field *difference = NULL;
    if (question->minus)
        luxel_compare(question->minus->field, question->shot->field, NULL, &comparison, &difference);
    const luxel_field *field = difference ? difference : question->shot->field;
    const gboolean is_light = !difference && question->shot->channel <= APP_CHANNEL_LUMINANCE;
    const gboolean logarithmic = question->logarithmic && !difference;
    measures->has_statistics = luxel_field_summary(field, NULL, NULL, &measures->summary) == LUXEL_OK;
    if (luxel_field_histogram(field, NULL, logarithmic ? LUXEL_HISTOGRAM_LOGARITHMIC : LUXEL_HISTOGRAM_LINEAR,
                              (double)NAN, (double)NAN, BINS, NULL, &measures->histogram) != LUXEL_OK)
        measures->histogram = NULL;
    measures->is_difference = difference != NULL;
    if (!difference)
        measures->mean = app_color_mean(app_shot_light(question->shot));
    if (is_light && !app_runner_is_outdated(runner))
        measures->has_extrema =
            luxel_find_extrema(evaluator, app_shot_light(question->shot), NULL, NULL, &measures->extrema) == LUXEL_OK;
    if (is_light && !app_runner_is_outdated(runner))
        measures->reached = find_reached(question->shot, kept);
    luxel_field_free(difference);
    app_runner_report(runner, measures);
}

/* The balance of the flux, which takes as long as the picture. */
static void measure_balance(AppRunner *runner, const AppQuestion *question, Kept *kept)
{
    const luxel_statistics *statistics = luxel_field_statistics(app_shot_light(question->shot));
    if (!statistics->has_reflected || question->minus || app_runner_is_outdated(runner))
        return;
    luxel_settings settings = settings_of(question->shot, kept);
    luxel_balance *balance = NULL;
    const luxel_status status = luxel_find_balance(question->shot->moment->scene, &settings, NULL, &balance);
    if (status == LUXEL_CANCELLED)
        return;
    AppMeasures *measures = new_measures(question);
    measures->has_balance = TRUE;
    measures->balance = status == LUXEL_OK ? balance : NULL;
    app_runner_report(runner, measures);
}

static void measure_isophotes(AppRunner *runner, const AppQuestion *question)
{
    double levels[MOST_LEVELS];
    AppMeasures *measures = new_measures(question);
    const gsize count =
        luxel_round_levels(question->low, question->high, question->logarithmic, LEVELS, levels, MOST_LEVELS);
    measures->has_isophotes =
        luxel_find_isophotes(question->shot->field, NULL, levels, count, NULL, &measures->isophotes) == LUXEL_OK;
    app_runner_report(runner, measures);
}

/* A coarse shot gives points and sections, which are exact; what is read off pixels waits for the fine one. */
static void answer(AppRunner *runner, gpointer job, gpointer state)
{
    const AppQuestion *question = job;
    Both *both = state;
    both->shot.runner = runner;
    both->shot.begun = g_get_monotonic_time();
    both->shot.patience = PATIENCE_OF_POINTS; /* few numbers, which follow a hand that never rests as well */
    measure_sources(runner, question, &both->shot);
    if (question->shot->moment->is_direct)
        return;
    measure_points(runner, question, &both->shot);
    const luxel_evaluator *evaluator = evaluator_of(&both->shot, runner, question->shot);
    const luxel_evaluator *minus = question->minus ? evaluator_of(&both->minus, runner, question->minus) : NULL;
    if (evaluator && question->section && (minus || !question->minus))
        measure_section(runner, question, evaluator, minus);
    if (!question->shot->is_fine)
        return;
    if (question->isophotes && !question->minus)
        measure_isophotes(runner, question);
    if (evaluator && question->statistics && !app_runner_rest(runner, REST_MS)) {
        measure_statistics(runner, question, evaluator, &both->shot);
        measure_balance(runner, question, &both->shot);
    }
}

static void free_question(gpointer data)
{
    AppQuestion *question = data;
    app_shot_unref(question->shot);
    app_shot_unref(question->minus);
    app_shot_unref(question->live);
    g_free(question);
}

struct AppMeter {
    AppRunner *runner;
    void (*tell)(AppMeasures *measures, gpointer owner);
    gpointer owner;
};

static void tell_measures(gpointer report, gpointer owner)
{
    AppMeter *meter = owner;
    meter->tell(report, meter->owner);
}

AppMeter *app_meter_new(void (*tell)(AppMeasures *measures, gpointer owner), gpointer owner)
{
    static const AppRunnerClass class = {"meter", answer, free_question, free_measures, free_both, 15};
    AppMeter *meter = g_new0(AppMeter, 1);
    *meter = (AppMeter){.tell = tell, .owner = owner};
    meter->runner = app_runner_new(&class, g_new0(Both, 1), tell_measures, meter);
    return meter;
}

void app_meter_free(AppMeter *meter)
{
    if (!meter)
        return;
    app_runner_stop(meter->runner);
    g_free(meter);
}

void app_meter_ask(AppMeter *meter, const AppQuestion *question)
{
    AppQuestion *copy = g_memdup2(question, sizeof *question);
    app_shot_ref(copy->shot);
    if (copy->minus)
        app_shot_ref(copy->minus);
    if (copy->live)
        app_shot_ref(copy->live);
    app_runner_post(meter->runner, copy);
}

/* ---- the pointer ---- */

static int by_share(gconstpointer a, gconstpointer b, gpointer shares)
{
    const double *of = shares, first = fabs(of[*(const gsize *)a]), second = fabs(of[*(const gsize *)b]);
    return first < second ? 1 : first > second ? -1 : 0;
}

gsize *app_reading_order(const AppReading *reading)
{
    gsize *order = g_new(gsize, reading->share_count);
    for (gsize i = 0; i < reading->share_count; i++)
        order[i] = i;
    g_qsort_with_data(order, (int)reading->share_count, sizeof *order, by_share, reading->shares);
    return order;
}

typedef struct Place {
    AppShot *shot, *minus;
    double x_mm, y_mm;
} Place;

struct AppPointer {
    AppRunner *runner;
    void (*tell)(const AppReading *reading, gpointer owner);
    gpointer owner;
};

/* The channels of the value that was read. */
static luxel_color read_color(const Place *place, Kept *kept)
{
    luxel_settings settings = settings_of(place->shot, kept);
    luxel_color color = {.exists = FALSE};
    luxel_probe *probe;
    settings.skip_reflected_pixels = true;
    if (luxel_scene_has_color(place->shot->moment->scene) &&
        luxel_probe_screen(place->shot->moment->scene, &settings, place->x_mm, place->y_mm, NULL, &probe) == LUXEL_OK) {
        color = probe->color;
        luxel_probe_free(probe);
    }
    return color;
}

static void read_place(AppRunner *runner, gpointer job, gpointer state)
{
    const Place *place = job;
    Both *both = state;
    const luxel_evaluator *evaluator = evaluator_of(&both->shot, runner, place->shot);
    const luxel_evaluator *minus = place->minus ? evaluator_of(&both->minus, runner, place->minus) : NULL;
    if (!evaluator)
        return;
    AppReading *reading = g_new0(AppReading, 1);
    reading->x_mm = place->x_mm;
    reading->y_mm = place->y_mm;
    reading->moment = app_moment_ref(place->shot->moment);
    reading->version = app_version_of(place->shot, place->minus);
    reading->quantity = luxel_field_quantity(place->shot->field);
    reading->share_count = luxel_evaluator_light_count(evaluator);
    reading->shares = g_new0(double, reading->share_count);
    luxel_evaluate_screen(evaluator, place->x_mm, place->y_mm, &reading->value, reading->shares);
    reading->has_minus = minus != NULL;
    if (minus)
        luxel_evaluate_screen(minus, place->x_mm, place->y_mm, &reading->minus, NULL);
    reading->has_pixel = place->shot->is_fine && !place->minus &&
                         app_pixel_at(place->shot->field, place->x_mm, place->y_mm, &reading->column, &reading->row);
    if (reading->value.has_value && !minus)
        reading->color = read_color(place, &both->shot);
    reading->has_grey = reading->has_pixel && is_grey(place->shot);
    if (reading->has_grey)
        reading->grey = grey_at(&both->shot, place->shot, reading->column, reading->row);
    app_runner_report(runner, reading);
}

static void free_place(gpointer data)
{
    Place *place = data;
    app_shot_unref(place->shot);
    app_shot_unref(place->minus);
    g_free(place);
}

static void free_reading(gpointer data)
{
    AppReading *reading = data;
    app_moment_unref(reading->moment);
    g_free(reading->shares);
    g_free(reading);
}

static void tell_reading(gpointer report, gpointer owner)
{
    AppPointer *pointer = owner;
    pointer->tell(report, pointer->owner);
}

AppPointer *app_pointer_new(void (*tell)(const AppReading *reading, gpointer owner), gpointer owner)
{
    static const AppRunnerClass class = {"pointer", read_place, free_place, free_reading, free_both, 12};
    AppPointer *pointer = g_new0(AppPointer, 1);
    *pointer = (AppPointer){.tell = tell, .owner = owner};
    pointer->runner = app_runner_new(&class, g_new0(Both, 1), tell_reading, pointer);
    return pointer;
}

void app_pointer_free(AppPointer *pointer)
{
    if (!pointer)
        return;
    app_runner_stop(pointer->runner);
    g_free(pointer);
}

void app_pointer_ask(AppPointer *pointer, AppShot *shot, AppShot *minus, double x_mm, double y_mm)
{
    Place *place = g_new(Place, 1);
    *place = (Place){app_shot_ref(shot), minus ? app_shot_ref(minus) : NULL, x_mm, y_mm};
    app_runner_post(pointer->runner, place);
}
