/* SPDX-License-Identifier: MIT */
/* Profiles along lines of the screen and great circles of spheres, exact or from a picture. */
#include <luxel/profile.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/rows.h"
#include "../world/camera.h"
#include "../world/evaluate.h"
#include "field.h"
#include "gather.h"

enum { MOST_SAMPLES = 10000000 };

void luxel_profile_free(luxel_profile *profile)
{
    if (!profile)
        return;
    free((luxel_profile_sample *)profile->samples);
    free((double *)profile->shares);
    free(profile);
}

static luxel_status check_path(const luxel_profile_path *path, luxel_diagnostics *diagnostics)
{
    bool finite = isfinite(path->from_mm[0]) && isfinite(path->from_mm[1]) && isfinite(path->to_mm[0]) &&
                  isfinite(path->to_mm[1]);
    bool differ = path->from_mm[0] != path->to_mm[0] || path->from_mm[1] != path->to_mm[1];
    bool counted = path->samples >= 2 && path->samples <= MOST_SAMPLES;
    bool known = path->type == LUXEL_PATH_LINE || path->type == LUXEL_PATH_ARC;
    return finite && differ && counted && known ? LX_CHECK_RESERVE(path, diagnostics)
                                                : lx_refuse(diagnostics, LX_MSG_BAD_PATH, NULL);
}

/* A profile with places along the line; NULL when memory is short. */
static luxel_profile *new_profile(const luxel_profile_path *path, luxel_quantity quantity, const char *word,
                                  size_t lights)
{
    luxel_profile *made = lx_new_array(1, sizeof *made);
    luxel_profile_sample *samples = lx_new_array(path->samples, sizeof *samples);
    double *shares = lights > 0 ? lx_new_array(path->samples * lights, sizeof *shares) : NULL;
    if (!made || !samples || (lights > 0 && !shares)) {
        free(made);
        free(samples);
        free(shares);
        return NULL;
    }
    *made = (luxel_profile){.type = path->type,
                            .quantity = quantity,
                            .quantity_word = word,
                            .count = path->samples,
                            .samples = samples,
                            .lights = lights,
                            .shares = shares};
    return made;
}

/* Equal steps; both ends are exact. */
static void place_on_line(const luxel_profile_path *path, luxel_profile_sample *samples)
{
    double length = hypot(path->to_mm[0] - path->from_mm[0], path->to_mm[1] - path->from_mm[1]);
    for (size_t i = 0; i < path->samples; i++) {
        double share = (double)i / (double)(path->samples - 1);
        samples[i].abscissa = length * share;
        samples[i].x_mm = path->from_mm[0] * (1 - share) + path->to_mm[0] * share;
        samples[i].y_mm = path->from_mm[1] * (1 - share) + path->to_mm[1] * share;
    }
}

/* ---- exact ---- */

/* A great circle: unit vectors from the sphere's centre, to the first place and perpendicular to it. */
struct arc {
    size_t surface; /* among the prepared ones */
    double begin[3], aside[3];
    double angle_rad; /* to the second place */
};

struct job {
    const struct luxel_evaluator *evaluator;
    struct lx_control *control;
    const struct arc *arc; /* NULL: a line */
    luxel_profile_sample *samples;
    double *shares;
    size_t lights;
};

/* Where a place is seen on the screen; the sphere's point need not be visible. */
static void project(const struct lx_camera *camera, const double place[3], luxel_profile_sample *sample)
{
    double at[2];
    lx_seen_at(camera, place, at);
    sample->x_mm = at[0];
    sample->y_mm = at[1];
}

/* A light off has no share anywhere. */
static void evaluate_sample(const struct job *job, size_t i)
{
    luxel_profile_sample *sample = &job->samples[i];
    const struct lx_prepared *prepared = &job->evaluator->prepared;
    double *shares = job->lights > 0 ? &job->shares[i * job->lights] : NULL;
    luxel_value value;
    if (job->arc) {
        double angle = sample->abscissa * (M_PI / 180), normal[3];
        for (int k = 0; k < 3; k++)
            normal[k] = job->arc->begin[k] * cos(angle) + job->arc->aside[k] * sin(angle);
        const struct lx_element element = lx_element_on(prepared, job->arc->surface, normal);
        value = lx_evaluate_element(job->evaluator, &element, shares);
        project(&prepared->camera, value.position_mm, sample);
    } else {
        luxel_evaluate_screen(job->evaluator, sample->x_mm, sample->y_mm, &value, shares);
    }
    sample->has_value = value.has_value;
    sample->value = value.has_value ? value.value : 0;
    sample->error = value.has_value ? value.error : 0;
}

static void evaluate_samples(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct job *job = data;
    (void)worker;
    for (unsigned i = first; i < last && lx_control_goes_on(job->control, is_caller); i++)
        evaluate_sample(job, i);
}

static luxel_status no_sphere(const double place_mm[2], luxel_diagnostics *diagnostics)
{
    char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE];
    struct lx_text place = {0};
    lx_text_printf(&place, "(%s, %s)", lx_write_number(place_mm[0], x), lx_write_number(place_mm[1], y));
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_PATH_OFF_SPHERE, LX_ARGS(place.bytes));
    lx_text_clear(&place);
    return LUXEL_ERROR_ARGUMENT;
}

static luxel_status find_arc(const struct luxel_evaluator *evaluator, const luxel_profile_path *path,
                             luxel_diagnostics *diagnostics, struct arc *arc)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    luxel_value ends[2];
    luxel_trace_screen(evaluator, path->from_mm[0], path->from_mm[1], &ends[0]);
    luxel_trace_screen(evaluator, path->to_mm[0], path->to_mm[1], &ends[1]);
    for (int i = 0; i < 2; i++)
        if (!ends[i].on_surface ||
            !lx_is_by_normal(prepared, lx_prepared_index(prepared, ends[i].surface, ends[i].part)))
            return no_sphere(i == 0 ? path->from_mm : path->to_mm, diagnostics);
    if (ends[0].surface != ends[1].surface)
        return lx_refuse(diagnostics, LX_MSG_PATH_TWO_SPHERES, NULL);
    arc->surface = lx_prepared_index(prepared, ends[0].surface, ends[0].part);
    memcpy(arc->begin, ends[0].normal, sizeof arc->begin);
    const double *a = ends[0].normal, *b = ends[1].normal;
    /* begin x end x begin is aside times the sine of the angle, and its length keeps its digits for a small one */
    double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    double sine = sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
    double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    if (!(sine > 1e-12))
        return lx_refuse(diagnostics, LX_MSG_PATH_OPPOSITE, NULL);
    arc->aside[0] = (cross[1] * a[2] - cross[2] * a[1]) / sine;
    arc->aside[1] = (cross[2] * a[0] - cross[0] * a[2]) / sine;
    arc->aside[2] = (cross[0] * a[1] - cross[1] * a[0]) / sine;
    arc->angle_rad = atan2(sine, cosine);
    return LUXEL_OK;
}

luxel_status luxel_find_profile(const luxel_evaluator *evaluator, const luxel_profile_path *path,
                                luxel_diagnostics *diagnostics, luxel_profile **profile)
{
    struct arc arc;
    const luxel_settings *settings = &evaluator->settings;
    const luxel_quantity quantity = luxel_evaluator_quantity(evaluator);
    const bool photometric = evaluator->prepared.scene->units == LX_PHOTOMETRIC;
    luxel_status status = check_path(path, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(evaluator->scene, diagnostics);
    if (status == LUXEL_OK && path->type == LUXEL_PATH_ARC)
        status = find_arc(evaluator, path, diagnostics, &arc);
    if (status != LUXEL_OK)
        return status;
    luxel_profile *made =
        new_profile(path, quantity, lx_quantity_word(quantity, photometric), luxel_evaluator_light_count(evaluator));
    if (!made)
        return lx_out_of_memory(diagnostics);
    struct lx_control control = {
        .rows = (unsigned)path->samples, .progress = settings->progress, .data = settings->progress_data};
    struct job job = {.evaluator = evaluator,
                      .control = &control,
                      .arc = path->type == LUXEL_PATH_ARC ? &arc : NULL,
                      .samples = (luxel_profile_sample *)made->samples,
                      .shares = (double *)made->shares,
                      .lights = made->lights};
    if (job.arc)
        for (size_t i = 0; i < path->samples; i++)
            job.samples[i].abscissa = arc.angle_rad * (180 / M_PI) * (double)i / (double)(path->samples - 1);
    else
        place_on_line(path, job.samples);
    if (!lx_rows_run(&control, lx_thread_count(settings->threads, control.rows / 64 + 1), evaluate_samples, &job)) {
        luxel_profile_free(made);
        return LUXEL_CANCELLED;
    }
    *profile = made;
    return LUXEL_OK;
}

/* ---- of a picture ---- */

/* The index of the place nearest to a coordinate, in a rising or falling list; false beyond half a pixel outside. */
static bool find_pixel(const double *places, unsigned count, double place, double pixel, unsigned *found)
{
    double sign = count > 1 && places[1] < places[0] ? -1 : 1;
    double offset = sign * (place - places[0]) / pixel;
    if (!(offset >= -0.5 && offset <= count - 0.5))
        return false;
    /* the last pixel has its far edge, too */
    double whole = floor(offset + 0.5);
    *found = whole < 0 ? 0 : whole > count - 1.0 ? count - 1 : (unsigned)whole;
    return true;
}

luxel_status luxel_field_profile(const luxel_field *field, const luxel_profile_path *path,
                                 luxel_diagnostics *diagnostics, luxel_profile **profile)
{
    luxel_status status = check_path(path, diagnostics);
    if (status == LUXEL_OK && path->type != LUXEL_PATH_LINE)
        status = lx_refuse(diagnostics, LX_MSG_PATH_ONLY_LINES, NULL);
    if (status == LUXEL_OK && (!field->x_mm || !field->y_mm))
        status = lx_no_places(diagnostics);
    if (status != LUXEL_OK)
        return status;
    luxel_profile *made = new_profile(path, field->quantity, field->quantity_word, 0);
    if (!made)
        return lx_out_of_memory(diagnostics);
    luxel_profile_sample *samples = (luxel_profile_sample *)made->samples;
    /* pixels are square; of a single one nothing but the place is known */
    double pixel = field->columns > 1 ? fabs(field->x_mm[1] - field->x_mm[0])
                   : field->rows > 1  ? fabs(field->y_mm[1] - field->y_mm[0])
                                      : HUGE_VAL;
    place_on_line(path, samples);
    for (size_t i = 0; i < path->samples; i++) {
        unsigned column, row;
        if (!find_pixel(field->x_mm, field->columns, samples[i].x_mm, pixel, &column) ||
            !find_pixel(field->y_mm, field->rows, samples[i].y_mm, pixel, &row))
            continue;
        size_t place = (size_t)row * field->columns + column;
        samples[i].has_value = field->mask[place];
        samples[i].value = field->mask[place] ? lx_field_value(field, place) : 0;
    }
    *profile = made;
    return LUXEL_OK;
}

/* ---- lines across the screen ---- */

luxel_status luxel_profile_line(const luxel_scene *scene, const double through_mm[2], double degrees,
                                luxel_diagnostics *diagnostics, double from_mm[2], double to_mm[2])
{
    if (!scene || !luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    const struct lx_screen *screen = &lx_scene_parameters(scene)->screen;
    double half[2] = {screen->width_mm / 2, screen->height_mm / 2};
    double turns = remainder(degrees, 360), quarter = remainder(turns, 180); /* at most 90 */
    /* along an axis without rounding */
    double along[2] = {fabs(quarter) == 90 ? 0 : cos(turns * (M_PI / 180)),
                       quarter == 0 ? 0 : sin(turns * (M_PI / 180))};
    double first = -HUGE_VAL, last = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        if (along[i] == 0) {
            if (!(fabs(through_mm[i]) <= half[i]))
                return lx_refuse(diagnostics, LX_MSG_LINE_MISSES, NULL);
            continue;
        }
        double a = (-half[i] - through_mm[i]) / along[i], b = (half[i] - through_mm[i]) / along[i];
        first = fmax(first, fmin(a, b));
        last = fmin(last, fmax(a, b));
    }
    if (!(first < last) || !isfinite(first) || !isfinite(last))
        return lx_refuse(diagnostics, LX_MSG_LINE_MISSES, NULL);
    for (int i = 0; i < 2; i++) {
        from_mm[i] = fmax(-half[i], fmin(half[i], through_mm[i] + first * along[i]));
        to_mm[i] = fmax(-half[i], fmin(half[i], through_mm[i] + last * along[i]));
    }
    return LUXEL_OK;
}
