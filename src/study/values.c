/* SPDX-License-Identifier: MIT */
/* What varies in scene i: the numbers of each axis, as numbers, as names of columns, and as assignments. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "random.h"
#include "study.h"

/* A place on a sphere, evenly: its height and its longitude are. */
static void draw_on_sphere(const struct lx_axis *axis, const double draws[2], double place[3])
{
    const double z = 2 * draws[0] - 1, around = 2 * M_PI * draws[1], r = sqrt(fmax(0, 1 - z * z));
    place[0] = axis->center[0] + axis->radius * (r * cos(around));
    place[1] = axis->center[1] + axis->radius * (r * sin(around));
    place[2] = axis->center[2] + axis->radius * z;
}

/* A number between two ends, which it never leaves. */
static double between(double from, double to, double share)
{
    const double value = from + share * (to - from);
    return from < to ? fmin(fmax(value, from), to) : fmin(fmax(value, to), from);
}

static double draw_number(const struct lx_axis *axis, unsigned n, double draw)
{
    const double from = axis->from[n], to = axis->to[n];
    const bool is_whole = axis->parameter.type == LX_WHOLE || axis->parameter.type == LX_WHOLES;
    if (axis->random == LX_LOGARITHMIC) {
        const double value = exp(log(from) + draw * (log(to) - log(from)));
        const double held = from < to ? fmin(fmax(value, from), to) : fmin(fmax(value, to), from);
        return is_whole ? round(held) : held;
    }
    if (!is_whole)
        return between(from, to, draw);
    const double low = fmin(from, to), high = fmax(from, to);
    return fmin(low + floor(draw * (high - low + 1)), high);
}

static struct lx_study_choice draw(const struct luxel_study *study, size_t k, uint64_t i)
{
    const struct lx_axis *axis = &study->axes[k];
    struct lx_study_choice choice = {0};
    double draws[LX_MOST_WIDTH];
    const unsigned wanted = axis->random == LX_ON_SPHERE ? 2 : axis->random == LX_RANDOM_CHOICE ? 1 : axis->width;
    for (unsigned n = 0; n < wanted; n++)
        draws[n] = lx_draw(study->parameters.seed, i, (uint32_t)k, n);
    if (axis->random == LX_ON_SPHERE) {
        draw_on_sphere(axis, draws, choice.numbers);
    } else if (axis->random == LX_RANDOM_CHOICE) {
        choice.index = (size_t)(draws[0] * (double)axis->count);
        choice.index = choice.index < axis->count ? choice.index : axis->count - 1;
    } else {
        for (unsigned n = 0; n < axis->width; n++)
            choice.numbers[n] = draw_number(axis, n, draws[n]);
    }
    return choice;
}

struct lx_study_choice lx_axis_at(const struct luxel_study *study, size_t k, uint64_t i)
{
    const struct lx_axis *axis = &study->axes[k];
    struct lx_study_choice choice = {0};
    if (axis->is_random)
        choice = draw(study, k, i);
    else
        choice.index = (size_t)(i / axis->stride % axis->count);
    if (axis->words) {
        if (axis->width)
            memcpy(choice.numbers, axis->numbers + choice.index * axis->width, axis->width * sizeof(double));
    } else if (!axis->is_random) {
        const bool is_whole = axis->parameter.type == LX_WHOLE || axis->parameter.type == LX_WHOLES;
        const double share = (double)choice.index / (double)(axis->count - 1);
        for (unsigned n = 0; n < axis->width; n++) {
            const double value =
                choice.index + 1 == axis->count ? axis->to[n] : between(axis->from[n], axis->to[n], share);
            choice.numbers[n] = is_whole ? round(value) : value;
        }
    }
    return choice;
}

void lx_axis_assignment(const struct luxel_study *study, size_t k, uint64_t i, struct lx_text *text)
{
    const struct lx_axis *axis = &study->axes[k];
    const struct lx_study_choice choice = lx_axis_at(study, k, i);
    const bool is_list = axis->parameter.type == LX_REALS || axis->parameter.type == LX_WHOLES;
    char number[LX_NUMBER_SIZE];
    lx_text_puts(text, axis->key);
    lx_text_puts(text, "=");
    if (axis->words) {
        lx_text_puts(text, axis->words[choice.index]);
        return;
    }
    lx_text_puts(text, is_list ? "[" : "");
    for (unsigned n = 0; n < axis->width; n++) {
        lx_text_puts(text, n ? ", " : "");
        lx_text_puts(text, lx_write_number(choice.numbers[n], number));
    }
    lx_text_puts(text, is_list ? "]" : "");
}

/* ---- the public functions ---- */

size_t luxel_study_parameter_count(const luxel_study *study)
{
    return study ? study->width : 0;
}

void luxel_study_parameters(const luxel_study *study, uint64_t i, double *numbers)
{
    for (size_t k = 0; study && numbers && k < study->axis_count; k++) {
        const struct lx_axis *axis = &study->axes[k];
        const struct lx_study_choice choice = lx_axis_at(study, k, i);
        if (axis->width)
            memcpy(numbers + axis->column, choice.numbers, axis->width * sizeof *numbers);
        else
            numbers[axis->column] = (double)choice.index;
    }
}

/* The axis that a column belongs to; NULL beyond the last. */
static const struct lx_axis *axis_of_column(const luxel_study *study, size_t p)
{
    for (size_t k = 0; study && k < study->axis_count; k++) {
        const struct lx_axis *axis = &study->axes[k];
        if (p >= axis->column && p < axis->column + (axis->width ? axis->width : 1))
            return axis;
    }
    return NULL;
}

char *luxel_study_parameter_name(const luxel_study *study, size_t p)
{
    const struct lx_axis *axis = axis_of_column(study, p);
    struct lx_text text = {0};
    if (!axis)
        return NULL;
    lx_text_puts(&text, axis->key);
    if (axis->parameter.type == LX_REALS || axis->parameter.type == LX_WHOLES)
        lx_text_printf(&text, "[%zu]", p - axis->column);
    return lx_text_take(&text);
}

const char *luxel_study_parameter_word(const luxel_study *study, size_t p, size_t v)
{
    const struct lx_axis *axis = axis_of_column(study, p);
    return axis && !axis->width && axis->words && v < axis->count ? axis->words[v] : NULL;
}
