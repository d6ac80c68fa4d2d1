/* SPDX-License-Identifier: MIT */
/* Fits: what is asked, several starts, the search on all readings, and the answer. */
#include <luxel/fit.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../world/camera.h"
#include "starts.h"

enum {
    MOST_STEPS = 100,   /* of the search on all readings, */
    FEW_STEPS = 30,     /* and of one from another start */
    FEW_READINGS = 400, /* that starts look at where there are many */
    STARTS = 8,
    MOST_LISTED = 20 /* readings that are told as wrong */
};

struct own_fit {
    luxel_fit fit; /* first, so that its address is that of the whole */
    luxel_fit_parameter *parameters;
    double *correlation, *residuals;
    luxel_scene *scene;
    struct lx_fit_problem problem; /* its keys, whose texts are told */
    struct lx_conclusion conclusion;
    char **names;
};

void luxel_fit_free(luxel_fit *fit)
{
    struct own_fit *own = (struct own_fit *)(void *)fit;
    if (!own)
        return;
    for (size_t i = 0; own->names && i < own->problem.unknowns; i++)
        free(own->names[i]);
    free(own->names);
    free(own->parameters);
    free(own->correlation);
    free(own->residuals);
    free(own->conclusion.block);
    free(own->conclusion.known);
    free(own->conclusion.ends);
    free(own->conclusion.several);
    free(own->problem.scale);
    free(own->problem.low);
    free(own->problem.high);
    free(own->problem.set.places);
    free(own->problem.set.values);
    free(own->problem.set.pixels);
    lx_changer_clear(&own->problem.changer);
    lx_keys_clear(&own->problem.keys);
    luxel_scene_free(own->scene);
    free(own);
}

const luxel_scene *luxel_fit_scene(const luxel_fit *fit)
{
    return fit ? ((const struct own_fit *)(const void *)fit)->scene : NULL;
}

/* ---- what is asked ---- */

static luxel_status check_how(const luxel_readings *readings, luxel_diagnostics *diagnostics)
{
    const struct {
        const char *name;
        double value;
    } numbers[] = {{"noise", readings->noise},
                   {"relative_noise", readings->relative_noise},
                   {"saturated", readings->saturated},
                   {"quantum", readings->quantum}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (!(isfinite(numbers[i].value) && numbers[i].value >= 0.0))
            return lx_setting_out_of_range(diagnostics, numbers[i].name, numbers[i].value, LX_N("0 or more"));
    return LX_CHECK_RESERVE(readings, diagnostics);
}

/* Whether a value of one key is one of the other's, or has it as a component. */
static bool are_both(const struct lx_key *key, const struct lx_key *other)
{
    for (size_t i = 0; i < key->target_count; i++)
        for (size_t j = 0; j < other->target_count; j++) {
            const size_t length = strlen(key->targets[i].path);
            const char *path = other->targets[j].path;
            if (strncmp(key->targets[i].path, path, length) == 0 && (path[length] == '[' || path[length] == '\0'))
                return true;
        }
    return false;
}

/* No number is free twice, and elements of a list that are to have one number have one. */
static luxel_status check_keys(const struct lx_keys *keys, luxel_diagnostics *diagnostics)
{
    if (keys->count == 0)
        return lx_refuse(diagnostics, LX_MSG_FIT_NO_KEY, NULL);
    for (size_t i = 0; i < keys->count; i++) {
        const struct lx_key *key = &keys->list[i];
        for (size_t j = 0; j < keys->count; j++)
            if (i != j && are_both(key, &keys->list[j]))
                return lx_refuse(diagnostics, LX_MSG_FIT_TWICE, LX_ARGS(key->path, keys->list[j].path));
        for (size_t t = 1; t < key->target_count; t++)
            if (memcmp(key->targets[t].numbers, key->targets[0].numbers, sizeof key->targets[0].numbers) != 0)
                return lx_refuse(diagnostics, LX_MSG_FIT_DIFFERENT,
                                 LX_ARGS(key->path, key->targets[0].path, key->targets[t].path));
    }
    return LUXEL_OK;
}

/* How far readings are from the scene's origin. */
static double extent_of(const struct lx_reading_set *set)
{
    double square = 0.0;
    for (size_t i = 0; i < set->count; i++) {
        const luxel_place *place = &set->places[i];
        for (int k = 0; k < (place->is_element ? 3 : 2); k++) {
            const double at = place->is_element ? place->position_mm[k] : place->screen_mm[k];
            square += at * at;
        }
    }
    return set->count > 0 ? sqrt(square / (double)set->count) : 0.0;
}

static luxel_status make_unknowns(struct lx_fit_problem *problem)
{
    const double extent = extent_of(&problem->set);
    problem->numbers = problem->keys.number_count;
    problem->unknowns = problem->numbers + problem->readings->is_relative;
    problem->scale = lx_new_array(problem->unknowns + 1, sizeof *problem->scale);
    problem->low = lx_new_array(problem->unknowns + 1, sizeof *problem->low);
    problem->high = lx_new_array(problem->unknowns + 1, sizeof *problem->high);
    if (!problem->scale || !problem->low || !problem->high)
        return lx_out_of_memory(problem->diagnostics);
    for (size_t k = 0; k < problem->numbers; k++) {
        const struct lx_key *key = lx_keys_of(&problem->keys, k);
        problem->scale[k] =
            key->is_length ? fmax(key->targets->scale, key->legal.given ? 0.0 : extent) : key->targets->scale;
        problem->low[k] = key->legal.given ? key->legal.low : -HUGE_VAL;
        problem->high[k] = key->legal.given ? key->legal.high : HUGE_VAL;
        if (key->legal.given && key->legal.low_open)
            problem->low[k] += 1e-9 * problem->scale[k];
    }
    if (problem->unknowns > problem->numbers) {
        problem->scale[problem->numbers] = 1.0;
        problem->high[problem->numbers] = HUGE_VAL;
    }
    for (size_t i = 0; i < problem->set.count; i++)
        problem->greatest = fmax(problem->greatest, fabs(problem->set.values[i]));
    return LUXEL_OK;
}

static luxel_status check_count(const struct lx_fit_problem *problem)
{
    char count[LX_NUMBER_SIZE], unknowns[LX_NUMBER_SIZE];
    size_t saturated = 0;
    for (size_t i = 0; i < problem->set.count; i++)
        saturated += lx_is_saturated(problem->readings, problem->set.values[i]);
    if (problem->set.count < problem->unknowns) {
        lx_refuse(problem->diagnostics, LX_MSG_FIT_FEW,
                  LX_ARGS(lx_write_number((double)problem->set.count, count),
                          lx_write_number((double)problem->unknowns, unknowns)));
        lx_hint(problem->diagnostics, LX_MSG_FIT_FEW_HINT, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    if (saturated == problem->set.count) {
        lx_refuse(problem->diagnostics, LX_MSG_FIT_SATURATED,
                  LX_ARGS(lx_write_digits(problem->readings->saturated, 6, count)));
        lx_hint(problem->diagnostics, LX_MSG_FIT_SATURATED_HINT, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    return LUXEL_OK;
}

/* The values that the scene itself gives: where they are missing, how exact they are, and the factor. */
static luxel_status look_at_start(struct lx_fit_problem *problem, bool may_miss)
{
    struct lx_probed *probed = lx_new_array(problem->set.count + 1, sizeof *probed);
    luxel_scene *copy = luxel_scene_copy(problem->scene);
    struct lx_prober prober;
    double error = 0.0, value = 0.0, above = 0.0, below = 0.0;
    size_t missing = 0;
    if (!probed || !copy) {
        luxel_scene_free(copy);
        free(probed);
        return lx_out_of_memory(problem->diagnostics);
    }
    luxel_status status = lx_prober_open(copy, &problem->settings, problem->diagnostics, &prober);
    if (status == LUXEL_OK)
        status = lx_prober_values(&prober, problem->set.places, problem->set.count, problem->diagnostics, probed);
    const bool is_drawn = status == LUXEL_OK && may_miss && prober.evaluator &&
                          !luxel_evaluator_integrates(prober.evaluator) && !luxel_scene_has_color(problem->scene);
    problem->is_slow = status == LUXEL_OK && (!prober.evaluator || luxel_evaluator_integrates(prober.evaluator));
    lx_prober_close(&prober);
    if (!is_drawn) {
        free(problem->set.pixels);
        problem->set.pixels = NULL;
    }
    size_t kept = 0;
    for (size_t i = 0; status == LUXEL_OK && i < problem->set.count; i++) {
        const luxel_place *place = &problem->set.places[i];
        const bool is_outside = may_miss && !probed[i].exists && problem->set.values[i] == 0.0;
        if (!probed[i].exists && !may_miss && missing++ < MOST_LISTED) {
            char number[LX_NUMBER_SIZE], x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE];
            const double *at = place->is_element ? place->position_mm : place->screen_mm;
            lx_refuse(problem->diagnostics, LX_MSG_FIT_OFF,
                      LX_ARGS(lx_write_number((double)i + 1, number), lx_write_digits(at[0], 9, x),
                              lx_write_digits(at[1], 9, y)));
            if (missing == 1)
                lx_hint(problem->diagnostics, LX_MSG_FIT_OFF_HINT, NULL);
        }
        if (probed[i].exists) {
            error = fmax(error, probed[i].error);
            value = fmax(value, fabs(probed[i].value));
            above += problem->set.values[i] * probed[i].value;
            below += probed[i].value * probed[i].value;
        }
        if (!is_outside) {
            if (problem->set.pixels)
                problem->set.pixels[kept] = problem->set.pixels[i];
            problem->set.places[kept] = problem->set.places[i];
            problem->set.values[kept++] = problem->set.values[i];
        }
    }
    free(probed);
    if (status == LUXEL_OK && missing > 0)
        status = LUXEL_ERROR_ARGUMENT;
    problem->set.count = kept;
    problem->precision = value > 0.0 ? error / value : 0.0;
    problem->step = fmin(fmax(cbrt(problem->precision), 1e-5), 0.05);
    if (problem->unknowns > problem->numbers && above > 0.0)
        problem->scale[problem->numbers] = above / below;
    return status;
}

/* ---- the answer ---- */

static bool make_answer(struct own_fit *own, size_t residuals)
{
    const size_t n = own->problem.unknowns;
    own->parameters = lx_new_array(n + 1, sizeof *own->parameters);
    own->correlation = lx_new_array(n * n + 1, sizeof *own->correlation);
    own->residuals = lx_new_array(residuals + 1, sizeof *own->residuals);
    own->names = lx_new_array(n + 1, sizeof *own->names);
    own->conclusion.block = lx_new_array(n + 1, sizeof *own->conclusion.block);
    own->conclusion.known = lx_new_array(n + 1, sizeof *own->conclusion.known);
    own->conclusion.ends = lx_new_array(n + 1, sizeof *own->conclusion.ends);
    own->conclusion.several = lx_new_array(n + 1, sizeof *own->conclusion.several);
    bool good = own->parameters && own->correlation && own->residuals && own->names && own->conclusion.block &&
                own->conclusion.known && own->conclusion.ends && own->conclusion.several;
    for (size_t i = 0; good && i < n; i++) {
        good = (own->names[i] = lx_unknown_name(&own->problem.keys, i)) != NULL;
        own->parameters[i].key = own->names[i];
        own->parameters[i].unit = i < own->problem.numbers ? lx_keys_of(&own->problem.keys, i)->unit : "";
    }
    for (size_t i = 0; good && i < residuals; i++)
        own->residuals[i] = (double)NAN;
    own->fit.parameters = own->parameters;
    own->fit.count = n;
    own->fit.correlation = own->correlation;
    own->fit.residuals = own->residuals;
    return good;
}

/* Searches on all readings from the best start, and concludes. */
static luxel_status finish(struct own_fit *own, struct lx_starts *starts)
{
    struct lx_fit_problem *problem = &own->problem;
    struct lx_trial found;
    if (!lx_trial_make(problem, problem->set.count, &found)) {
        lx_trial_clear(&found);
        return lx_out_of_memory(problem->diagnostics);
    }
    memcpy(found.unknowns, starts->ends[starts->best].unknowns, problem->unknowns * sizeof *found.unknowns);
    if (problem->unknowns > problem->numbers)
        problem->scale[problem->numbers] = found.unknowns[problem->numbers];
    luxel_status status = lx_search(problem, &problem->set, MOST_STEPS, &found);
    if (status == LUXEL_OK)
        status = lx_keys_change(problem->scene, &problem->keys, found.unknowns, problem->diagnostics, &own->scene);
    if (status == LUXEL_OK)
        status =
            lx_conclude(problem, &found, own->scene, &own->fit, own->parameters, own->correlation, &own->conclusion);
    if (status == LUXEL_OK)
        status = lx_starts_compare(problem, starts, &found, &own->fit, &own->conclusion);
    if (status == LUXEL_OK) {
        own->fit.has_converged = found.has_ended;
        for (size_t k = 0; k < problem->unknowns; k++)
            if (own->conclusion.several[k] > 0) {
                luxel_fit_parameter *parameter = &own->parameters[k];
                parameter->is_determined = parameter->has_errors = false;
                parameter->value = parameter->sd = parameter->low = parameter->high = (double)NAN;
                own->fit.undetermined++;
            }
        own->fit.undetermined += own->conclusion.blocks;
    }
    lx_trial_clear(&found);
    return status;
}

/* What is left of each reading that was used. */
static luxel_status tell_residuals(struct own_fit *own, const luxel_place *places, const double *values, size_t count)
{
    struct lx_fit_problem *problem = &own->problem;
    struct lx_probed *probed = lx_new_array(count + 1, sizeof *probed);
    luxel_scene *copy = luxel_scene_copy(own->scene);
    struct lx_prober prober;
    luxel_status status = probed && copy ? lx_prober_open(copy, &problem->settings, problem->diagnostics, &prober)
                                         : lx_out_of_memory(problem->diagnostics);
    if (!probed || !copy) {
        luxel_scene_free(copy);
        free(probed);
        return status;
    }
    if (status == LUXEL_OK)
        status = lx_prober_values(&prober, places, count, problem->diagnostics, probed);
    lx_prober_close(&prober);
    const double factor = own->fit.count > problem->numbers ? own->parameters[problem->numbers].value : 1.0;
    for (size_t i = 0; status == LUXEL_OK && i < count; i++)
        if (isfinite(values[i]) && (probed[i].exists || values[i] != 0.0))
            own->residuals[i] = values[i] - (probed[i].exists ? factor * probed[i].value : 0.0);
    free(probed);
    return status;
}

/* Fits to places and values, some of which may be NaN. */
static luxel_status fit_all(struct own_fit *own, const luxel_place *places, const double *values, size_t count,
                            bool may_miss)
{
    struct lx_fit_problem *problem = &own->problem;
    struct lx_reading_set *set = &problem->set;
    struct lx_starts starts = {.count = 0};
    set->places = lx_new_array(count + 1, sizeof *set->places);
    set->values = lx_new_array(count + 1, sizeof *set->values);
    set->pixels = lx_new_array(count + 1, sizeof *set->pixels);
    if (!set->places || !set->values || !set->pixels)
        return lx_out_of_memory(problem->diagnostics);
    bool sees = false;
    for (size_t i = 0; i < count; i++)
        if (isfinite(values[i])) {
            set->places[set->count] = places[i];
            set->pixels[set->count] = i;
            set->values[set->count++] = values[i];
            sees = sees || !places[i].is_element;
        }
    luxel_status status = sees ? luxel_scene_check_view(problem->scene, problem->diagnostics) : LUXEL_OK;
    if (status == LUXEL_OK)
        status = make_unknowns(problem);
    if (status == LUXEL_OK)
        status = check_count(problem);
    if (status == LUXEL_OK)
        status = look_at_start(problem, may_miss);
    if (status == LUXEL_OK)
        status = check_count(problem);
    if (status == LUXEL_OK)
        status = lx_changer_make(problem->scene, &problem->keys, problem->diagnostics, &problem->changer);
    if (status == LUXEL_OK && !make_answer(own, count))
        status = lx_out_of_memory(problem->diagnostics);
    if (status == LUXEL_OK)
        status = lx_starts_try(problem, &starts);
    if (status == LUXEL_OK)
        status = finish(own, &starts);
    if (status == LUXEL_OK)
        status = tell_residuals(own, places, values, count);
    lx_starts_clear(&starts);
    return status;
}

/* An answer that knows its keys; NULL, and *status: what is wrong. */
static struct own_fit *begin(const luxel_scene *scene, const luxel_settings *settings, const luxel_readings *readings,
                             const char *const *keys, size_t key_count, luxel_diagnostics *diagnostics,
                             luxel_status *status)
{
    struct own_fit *own = lx_new_array(1, sizeof *own);
    if (!own) {
        *status = lx_out_of_memory(diagnostics);
        return NULL;
    }
    struct lx_fit_problem *problem = &own->problem;
    *problem = (struct lx_fit_problem){.scene = scene, .readings = readings, .diagnostics = diagnostics};
    if (settings)
        problem->settings = *settings;
    else
        luxel_settings_init(&problem->settings);
    problem->progress = problem->settings.progress;
    problem->progress_data = problem->settings.progress_data;
    problem->settings.progress = NULL;
    problem->settings.skip_reflected_pixels = true;
    problem->settings.within = 0.0; /* what is differed by is the same each time */
    problem->settings.enough = NULL;
    if (problem->settings.reflected_error == 0.0)
        problem->settings.reflected_error = 1e-2;
    *status = luxel_scene_is_committed(scene) ? check_how(readings, diagnostics)
                                              : lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    if (*status == LUXEL_OK)
        *status = lx_keys_find(scene, keys, key_count, diagnostics, &problem->keys);
    if (*status == LUXEL_OK)
        *status = check_keys(&problem->keys, diagnostics);
    if (*status == LUXEL_OK)
        return own;
    luxel_fit_free(&own->fit);
    return NULL;
}

/* Hands the answer out, which then knows nothing of the caller's. */
static luxel_status end(struct own_fit *own, luxel_status status, luxel_fit **fit)
{
    own->problem.readings = NULL;
    if (status == LUXEL_OK)
        *fit = &own->fit;
    else
        luxel_fit_free(&own->fit);
    return status;
}

luxel_status luxel_fit_readings(const luxel_scene *scene, const luxel_settings *settings,
                                const luxel_readings *readings, const char *const *keys, size_t key_count,
                                luxel_diagnostics *diagnostics, luxel_fit **fit)
{
    luxel_status status;
    if (!scene || !readings || !fit || (!keys && key_count > 0) ||
        (readings->count > 0 && (!readings->places || !readings->values)))
        return LUXEL_ERROR_ARGUMENT;
    struct own_fit *own = begin(scene, settings, readings, keys, key_count, diagnostics, &status);
    if (!own)
        return status;
    return end(own, fit_all(own, readings->places, readings->values, readings->count, false), fit);
}

/* Whether a picture can be one of the scene. */
static luxel_status check_picture(const luxel_scene *scene, const luxel_settings *settings, const luxel_field *picture,
                                  const luxel_readings *readings, luxel_diagnostics *diagnostics)
{
    unsigned columns, rows;
    char found[2][LX_NUMBER_SIZE], wanted[2][LX_NUMBER_SIZE];
    luxel_scene_resolution(scene, &columns, &rows);
    if (luxel_field_columns(picture) != columns || luxel_field_rows(picture) != rows) {
        lx_refuse(diagnostics, LX_MSG_FIT_SIZE,
                  LX_ARGS(lx_write_number(luxel_field_columns(picture), found[0]),
                          lx_write_number(luxel_field_rows(picture), found[1]), lx_write_number(columns, wanted[0]),
                          lx_write_number(rows, wanted[1])));
        lx_hint(diagnostics, LX_MSG_FIT_SIZE_HINT, LX_ARGS(found[0], found[1]));
        return LUXEL_ERROR_ARGUMENT;
    }
    const char *unit = luxel_field_unit(picture), *own = luxel_settings_unit(scene, settings);
    if (*unit == '\0' || readings->is_relative || strcmp(unit, own) == 0)
        return LUXEL_OK;
    lx_refuse(diagnostics, LX_MSG_FIT_UNIT, LX_ARGS(LX_TERM(unit), LX_TERM(own)));
    lx_hint(diagnostics, LX_MSG_FIT_UNIT_HINT, NULL);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status luxel_fit_picture(const luxel_scene *scene, const luxel_settings *settings, const luxel_field *picture,
                               const luxel_readings *readings, const char *const *keys, size_t key_count,
                               luxel_diagnostics *diagnostics, luxel_fit **fit)
{
    static const luxel_readings plain = {.count = 0};
    luxel_status status;
    if (!scene || !picture || !fit || (!keys && key_count > 0))
        return LUXEL_ERROR_ARGUMENT;
    readings = readings ? readings : &plain;
    struct own_fit *own = begin(scene, settings, readings, keys, key_count, diagnostics, &status);
    if (!own)
        return status;
    status = check_picture(scene, settings, picture, readings, diagnostics);
    if (status != LUXEL_OK)
        return end(own, status, fit);
    const struct lx_screen *screen = &lx_scene_parameters(scene)->screen;
    const unsigned columns = luxel_field_columns(picture), rows = luxel_field_rows(picture);
    const size_t count = (size_t)columns * rows;
    luxel_place *places = lx_new_array(count + 1, sizeof *places);
    double *values = lx_new_array(count + 1, sizeof *values);
    for (size_t i = 0; places && values && i < count; i++) {
        const unsigned column = (unsigned)(i % columns), row = (unsigned)(i / columns);
        places[i] = (luxel_place){.screen_mm = {lx_column_x_mm(screen, column), lx_row_y_mm(screen, row)}};
        values[i] = luxel_field_value(picture, column, row);
    }
    status = places && values ? fit_all(own, places, values, count, true) : lx_out_of_memory(diagnostics);
    free(places);
    free(values);
    return end(own, status, fit);
}

/* ---- words ---- */

/* Adds "a, b and c": the names of a block. */
static void add_names(struct lx_text *text, const struct own_fit *own, size_t block)
{
    size_t left = 0;
    for (size_t i = 0; i < own->fit.count; i++)
        left += own->conclusion.block[i] == block;
    for (size_t i = 0; i < own->fit.count; i++)
        if (own->conclusion.block[i] == block) {
            lx_text_add_escaped(text, own->names[i], strlen(own->names[i]));
            left--;
            lx_text_puts(text, left > 0 ? ", " : "");
        }
}

static void add_block(struct lx_text *text, const struct own_fit *own, size_t block)
{
    struct lx_text names = {0};
    char number[LX_NUMBER_SIZE];
    const size_t known = own->conclusion.known[block - 1];
    add_names(&names, own, block);
    const char *list = names.bytes ? names.bytes : "";
    if (known == 0)
        lx_add_phrase(text, LX_N("{0}: the readings do not change with it"), LX_ARGS(list));
    else if (known == 1)
        lx_add_phrase(text, LX_N("{0}: only one combination of these is determined"), LX_ARGS(list));
    else
        lx_add_phrase(text, LX_N("{0}: only {1} combinations of these are determined"),
                      LX_ARGS(list, lx_write_number((double)known, number)));
    lx_text_clear(&names);
}

/* Adds "one combination of a, b": what is determined of a block. */
static void add_known(struct lx_text *text, const struct own_fit *own, size_t block)
{
    struct lx_text names = {0};
    char number[LX_NUMBER_SIZE];
    const size_t known = own->conclusion.known[block - 1];
    add_names(&names, own, block);
    const char *list = names.bytes ? names.bytes : "";
    if (known == 1)
        lx_add_phrase(text, LX_N("one combination of {0}"), LX_ARGS(list));
    else
        lx_add_phrase(text, LX_N("{1} combinations of {0}"), LX_ARGS(list, lx_write_number((double)known, number)));
    lx_text_clear(&names);
}

char *luxel_fit_determined(const luxel_fit *fit, luxel_translate translate, void *data)
{
    const struct own_fit *own = (const struct own_fit *)(const void *)fit;
    struct lx_text text = {0}, list = {0};
    char readings[LX_NUMBER_SIZE], rank[LX_NUMBER_SIZE];
    if (!fit)
        return NULL;
    for (size_t i = 0; i < fit->count; i++)
        if (own->parameters[i].is_determined) {
            lx_text_puts(&list, list.length > 0 ? ", " : "");
            lx_text_add_escaped(&list, own->names[i], strlen(own->names[i]));
        }
    for (size_t block = 1; block <= own->conclusion.blocks; block++)
        if (own->conclusion.known[block - 1] > 0) {
            lx_text_puts(&list, list.length > 0 ? ", " : "");
            add_known(&list, own, block);
        }
    lx_add_phrase(&text, LX_N("{0} readings, {1} determined: {2}"),
                  LX_ARGS(lx_write_number((double)fit->readings, readings), lx_write_number((double)fit->rank, rank),
                          list.bytes ? list.bytes : ""));
    lx_text_clear(&list);
    return lx_text_render(&text, translate, data);
}

static void add_several(struct lx_text *text, const struct own_fit *own, size_t unknown)
{
    struct lx_text values = {0};
    for (size_t i = 0; i < own->conclusion.several[unknown]; i++) {
        char number[LX_NUMBER_SIZE];
        lx_text_printf(&values, "%s%s", i > 0 ? ", " : "",
                       lx_write_digits(own->conclusion.ends[unknown][i], 6, number));
    }
    lx_add_phrase(text, LX_N("{0}: several values fit equally well: {1}"),
                  LX_ARGS(own->names[unknown], values.bytes ? values.bytes : ""));
    lx_text_clear(&values);
}

char *luxel_fit_undetermined(const luxel_fit *fit, size_t i, luxel_translate translate, void *data)
{
    const struct own_fit *own = (const struct own_fit *)(const void *)fit;
    struct lx_text text = {0};
    if (i >= (fit ? fit->undetermined : 0))
        return NULL;
    if (i < own->conclusion.blocks) {
        add_block(&text, own, i + 1);
    } else {
        size_t left = i - own->conclusion.blocks, unknown = 0;
        while (own->conclusion.several[unknown] == 0 || left-- > 0)
            unknown++;
        add_several(&text, own, unknown);
    }
    return lx_text_render(&text, translate, data);
}
