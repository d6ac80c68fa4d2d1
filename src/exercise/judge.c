/* SPDX-License-Identifier: MIT */
/*
 * Judging answers: compared with the exact value, as far as their digits go, then with what each other convention
 * gives, then with slips that are no convention of a scene (a grey level, a share of the maximum, the irradiance), then
 * with two of these together.
 *
 * Many pairs make chance matches likely, so a pair must agree ten times as well.
 */
#include <math.h>
#include <stdlib.h>

#include <luxel/evaluator.h>
#include <luxel/exercise.h>
#include <luxel/render.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../field/field.h"
#include "../world/camera.h"
#include "alternatives.h"

#define PAIR_STRICTNESS 0.1

/* Three digits are asked for.  Of small values, which nobody sees beside the others, so much of the largest is enough.
 * What explains an answer of fewer digits is to lie so near, in parts of the answer. */
enum { DIGITS_ASKED = 3 };
#define MOST_ROUNDING_OF_LARGEST 1e-4
#define MOST_ROUNDING 5e-3

enum { MOST_EXPLANATIONS = 2, MOST_PIXELS = 4000000 };

struct made {
    luxel_judgement shown; /* first, so that its address is the whole's */
    struct lx_choices choices;
    luxel_alternative explanations[MOST_EXPLANATIONS];
};

/* What is looked for, and the nearest that was found. */
struct search {
    struct made *made;
    double answer, tolerance;
    double rounding; /* as it counts for what is compared next */
    double distance; /* of the nearest; HUGE_VAL: none goes yet */
    double maximum;  /* of the picture; 0: there is none */
    luxel_field *field;
};

static const luxel_alternative shares = {
    .convention = LX_N("what is given"),
    .choice = LX_N("share of the maximum"),
    .meaning = LX_N("the value divided by the picture's maximum"),
};
static const luxel_alternative greys = {
    .convention = LX_N("what is given"),
    .choice = LX_N("grey level"),
    .meaning = LX_N("the grey level of the pixel, 0 to 255"),
};
static const luxel_alternative irradiances = {
    .convention = LX_N("what is given"),
    .choice = LX_N("irradiance"),
    .meaning = LX_N("the irradiance of the surface, without its material"),
};

/* How far an answer lies from a value, in units of what is allowed: up to 1 agrees. */
static double distance_from(const struct search *search, bool has_value, double value, double strictness)
{
    if (isnan(search->answer) || !has_value)
        return isnan(search->answer) && !has_value ? 0 : HUGE_VAL;
    double allowed = strictness * search->tolerance * fabs(value) + search->rounding;
    double difference = fabs(search->answer - value);
    if (difference == 0)
        return 0;
    return allowed > 0 ? difference / allowed : HUGE_VAL;
}

/* Takes an explanation of one or two choices if it agrees, and better than what was found before. */
static void offer(struct search *search, const luxel_alternative *one, const luxel_alternative *other,
                  const struct lx_choice_value *found)
{
    double distance = distance_from(search, found->has_value, found->value, other ? PAIR_STRICTNESS : 1);
    luxel_judgement *shown = &search->made->shown;
    if (!(distance <= 1) || !(distance < search->distance))
        return;
    search->distance = distance;
    search->made->explanations[0] = *one;
    if (other)
        search->made->explanations[1] = *other;
    for (int i = 0; i < MOST_EXPLANATIONS; i++) {
        search->made->explanations[i].has_value = found->has_value;
        search->made->explanations[i].value = found->value;
        search->made->explanations[i].error = found->error;
    }
    shown->verdict = LUXEL_ANSWER_CONVENTION;
    shown->explanation_count = other ? 2 : 1;
    shown->explanations = search->made->explanations;
}

static luxel_alternative shown_choice(const struct lx_choice *choice)
{
    return (luxel_alternative){
        .convention = choice->convention,
        .choice = choice->choice,
        .meaning = choice->meaning,
        .assignment = choice->assignment,
    };
}

/* The value with one choice made, or two; what cannot be computed has none. */
static luxel_status value_of(const struct lx_choices *choices, size_t one, size_t other, struct lx_choice_value *found)
{
    const size_t which[] = {one, other};
    luxel_status status = lx_choices_value(choices, which, one == other ? 1 : 2, NULL, found);
    if (status == LUXEL_ERROR_RANGE)
        found->has_value = false;
    return status == LUXEL_ERROR_RANGE ? LUXEL_OK : status;
}

/* One choice if `one` and `other` are the same. */
static luxel_status try_choices(struct search *search, size_t one, size_t other)
{
    const struct lx_choices *choices = &search->made->choices;
    const struct lx_choice *first = &choices->list[one], *second = &choices->list[other];
    luxel_alternative a = shown_choice(first), b = shown_choice(second);
    struct lx_choice_value found;
    if (first->is_present || second->is_present || (one != other && first->convention == second->convention))
        return LUXEL_OK;
    luxel_status status = value_of(choices, one, other, &found);
    if (status == LUXEL_OK)
        offer(search, &a, one == other ? NULL : &b, &found);
    return status;
}

static luxel_status try_irradiance(struct search *search, const luxel_scene *scene)
{
    const struct lx_choices *choices = &search->made->choices;
    luxel_settings settings = choices->settings;
    luxel_probe *probe = NULL;
    if (settings.quantity == LUXEL_IRRADIANCE)
        return LUXEL_OK;
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_status status = luxel_probe_screen(scene, &settings, choices->x_mm, choices->y_mm, NULL, &probe);
    if (status == LUXEL_OK)
        offer(search, &irradiances, NULL, &(struct lx_choice_value){probe->has_value, probe->value, probe->error});
    luxel_probe_free(probe);
    return status == LUXEL_ERROR_RANGE ? LUXEL_OK : status;
}

/* The picture, for those who read the answer off it; of very large ones nobody does. */
static luxel_status render(struct search *search, const luxel_scene *scene)
{
    luxel_settings settings = search->made->choices.settings;
    unsigned columns = 0, rows = 0;
    luxel_scene_resolution(scene, &columns, &rows);
    if ((double)columns * rows > MOST_PIXELS)
        return LUXEL_OK;
    settings.progress = NULL;
    settings.stride = 1;
    luxel_status status = luxel_render(scene, &settings, NULL, &search->field);
    if (status == LUXEL_OK)
        search->maximum = luxel_field_statistics(search->field)->maximum.value;
    return status == LUXEL_ERROR_RANGE ? LUXEL_OK : status;
}

/* A grey level is a whole number above 0: what is black says nothing. */
static luxel_status try_grey(struct search *search, const luxel_probe *probe)
{
    size_t size = (size_t)luxel_field_columns(search->field) * luxel_field_rows(search->field);
    if (!(search->answer >= 1 && search->answer <= 255 && floor(search->answer) == search->answer) || !probe->has_pixel)
        return LUXEL_OK;
    uint8_t *levels = lx_new_array(size, 1);
    if (!levels)
        return LUXEL_ERROR_MEMORY;
    luxel_field_grey(search->field, levels);
    size_t pixel = (size_t)probe->row * luxel_field_columns(search->field) + probe->column;
    if (luxel_field_mask(search->field)[pixel] && levels[pixel] == search->answer)
        offer(search, &greys, NULL, &(struct lx_choice_value){true, search->answer, 0});
    free(levels);
    return LUXEL_OK;
}

/* The present place (`place` is then itself present), or another, divided by the maximum. */
static luxel_status try_share(struct search *search, size_t place)
{
    const struct lx_choices *choices = &search->made->choices;
    const struct lx_choice *choice = &choices->list[place];
    luxel_alternative shown = shown_choice(choice);
    struct lx_choice_value found;
    luxel_status status = value_of(choices, place, place, &found);
    if (status == LUXEL_OK && found.has_value && search->maximum > 0) {
        found.value /= search->maximum;
        found.error /= search->maximum;
        offer(search, choice->is_present ? &shares : &shown, choice->is_present ? NULL : &shares, &found);
    }
    return status;
}

static bool is_place(const struct lx_choice *choice)
{
    return choice->assignment == NULL;
}

/* One change alone goes before two. */
static luxel_status explain(struct search *search, const luxel_scene *scene, const luxel_probe *probe)
{
    const struct lx_choices *choices = &search->made->choices;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; status == LUXEL_OK && i < choices->count; i++)
        status = try_choices(search, i, i);
    if (status == LUXEL_OK && search->distance > 1)
        status = try_irradiance(search, scene);
    if (status != LUXEL_OK || search->distance <= 1)
        return status;
    status = render(search, scene);
    if (status == LUXEL_OK && search->field)
        status = try_grey(search, probe);
    for (size_t i = 0; status == LUXEL_OK && i < choices->count; i++)
        if (is_place(&choices->list[i]) && choices->list[i].is_present)
            status = try_share(search, i);
    if (status != LUXEL_OK || search->distance <= 1)
        return status;
    for (size_t i = 0; status == LUXEL_OK && i < choices->count; i++)
        if (is_place(&choices->list[i]) && !choices->list[i].is_present)
            status = try_share(search, i);
    for (size_t i = 0; status == LUXEL_OK && i < choices->count; i++)
        for (size_t k = i + 1; status == LUXEL_OK && k < choices->count; k++)
            status = try_choices(search, i, k);
    return status;
}

/* The largest of the values at the scene's points. */
static luxel_status find_largest(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, double *largest)
{
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(scene, settings, diagnostics, &evaluator);
    *largest = 0;
    for (size_t i = 0; status == LUXEL_OK && i < luxel_scene_point_count(scene); i++) {
        double x_mm, y_mm;
        luxel_value value;
        luxel_scene_point(scene, i, &x_mm, &y_mm);
        luxel_evaluate_screen(evaluator, x_mm, y_mm, &value, NULL);
        *largest = fmax(*largest, value.value);
    }
    luxel_evaluator_free(evaluator);
    return status;
}

/* Half a unit of the last digit that is asked for. */
static double rounding_asked(double answer)
{
    return answer != 0 && isfinite(answer) ? 0.5 * pow(10, floor(log10(fabs(answer))) - DIGITS_ASKED + 1) : 0;
}

/* Compares with the exact value: right, coarse, or wrong so far.  2.5 stands for 2.50 as well, whose last digit
 * spreadsheets drop: right is what the value is, rounded to three digits, however many are written. */
static luxel_status compare(struct search *search, const luxel_scene *scene, const luxel_settings *settings,
                            const luxel_probe *probe, luxel_diagnostics *diagnostics)
{
    luxel_judgement *shown = &search->made->shown;
    const double given = search->rounding, asked = rounding_asked(search->answer);
    const bool has_digits = isnan(search->answer) || given <= asked * (1 + 1e-9);
    double largest = 0;
    const luxel_status status = has_digits ? LUXEL_OK : find_largest(scene, settings, diagnostics, &largest);
    if (status != LUXEL_OK)
        return status;
    const bool rounds_to_it = distance_from(search, probe->has_value, probe->value, 1) <= 1;
    if (!has_digits)
        search->rounding = fmin(given, fmax(asked, MOST_ROUNDING_OF_LARGEST * largest));
    if (distance_from(search, probe->has_value, probe->value, 1) <= 1)
        shown->verdict = LUXEL_ANSWER_RIGHT;
    else if (rounds_to_it)
        shown->verdict = LUXEL_ANSWER_COARSE;
    if (!has_digits)
        search->rounding = fmin(given, fmax(MOST_ROUNDING * fabs(search->answer), search->rounding));
    return LUXEL_OK;
}

static luxel_status judge(struct made *made, struct search *search, const luxel_scene *scene,
                          const luxel_settings *settings, double x_mm, double y_mm, luxel_diagnostics *diagnostics)
{
    luxel_probe *probe = NULL;
    luxel_status status = luxel_probe_screen(scene, settings, x_mm, y_mm, diagnostics, &probe);
    if (status != LUXEL_OK)
        return status;
    made->shown = (luxel_judgement){.verdict = LUXEL_ANSWER_WRONG, .has_value = probe->has_value};
    if (probe->has_value) {
        made->shown.value = probe->value;
        made->shown.error = probe->error;
    }
    status = compare(search, scene, settings, probe, diagnostics);
    if (status == LUXEL_OK && made->shown.verdict == LUXEL_ANSWER_WRONG) {
        status = lx_choices_find(scene, settings, x_mm, y_mm, diagnostics, &made->choices);
        if (status == LUXEL_OK)
            status = explain(search, scene, probe);
        if (status == LUXEL_ERROR_MEMORY)
            lx_out_of_memory(diagnostics);
    }
    luxel_field_free(search->field);
    luxel_probe_free(probe);
    return status;
}

static luxel_status check(const char *name, double value, luxel_diagnostics *diagnostics)
{
    char number[LX_NUMBER_SIZE];
    if (value >= 0 && isfinite(value))
        return LUXEL_OK;
    return lx_refuse(diagnostics, LX_MSG_SETTING_OUT_OF_RANGE,
                     LX_ARGS(name, lx_write_number(value, number), LX_TERM(LX_N("0 or a positive number"))));
}

luxel_status luxel_judge_answer(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                                double answer, double tolerance, double rounding, luxel_diagnostics *diagnostics,
                                luxel_judgement **judgement)
{
    luxel_status status = check("tolerance", tolerance, diagnostics);
    if (status == LUXEL_OK)
        status = check("rounding", rounding, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct made *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    struct search search = {
        .made = made, .answer = answer, .tolerance = tolerance, .rounding = rounding, .distance = HUGE_VAL};
    status = judge(made, &search, scene, settings, x_mm, y_mm, diagnostics);
    if (status == LUXEL_OK)
        *judgement = &made->shown;
    else
        luxel_judgement_free(&made->shown);
    return status;
}

luxel_status luxel_judge_pixel_answer(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                      double y_mm, double answer, double tolerance, double rounding,
                                      luxel_diagnostics *diagnostics, luxel_judgement **judgement)
{
    unsigned column, row;
    if (luxel_scene_is_committed(scene)) {
        const struct lx_screen *screen = &lx_scene_parameters(scene)->screen;
        if (lx_pixel_at(screen, x_mm, y_mm, &column, &row)) {
            x_mm = lx_column_x_mm(screen, column);
            y_mm = lx_row_y_mm(screen, row);
        }
    }
    return luxel_judge_answer(scene, settings, x_mm, y_mm, answer, tolerance, rounding, diagnostics, judgement);
}

void luxel_judgement_free(luxel_judgement *judgement)
{
    struct made *made = (struct made *)judgement;
    if (!made)
        return;
    lx_choices_clear(&made->choices);
    free(made);
}
