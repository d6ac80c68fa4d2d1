/* SPDX-License-Identifier: MIT */
/* Goals cell by cell, linear around the values that the cells have. */
#include <math.h>
#include <stdlib.h>

#include "goals.h"

/* Cells of a goal that have a value, and what the rows are made of. */
struct lined {
    const struct lx_goal *goal;
    const double *values, *slopes;
    size_t cells, numbers, count;
    double *rows;
};

size_t lx_goals_most_rows(const struct lx_goal *goals, size_t count)
{
    size_t most = 0;
    for (size_t i = 0; i < count; i++)
        most += 2 * goals[i].count + 1;
    return most;
}

/* A row of this value, with its slopes by the value of two cells, or of one and the average. */
static void add_row(struct lined *lined, double value, size_t first, double by_first, const double *others,
                    double by_others)
{
    double *row = &lined->rows[lined->count++ * (lined->numbers + 1)];
    for (size_t k = 0; k < lined->numbers; k++)
        row[k] = by_first * lined->slopes[k * lined->cells + first] + by_others * others[k];
    row[lined->numbers] = value;
}

static void add_ratios(struct lined *lined, size_t least, size_t greatest, double *others)
{
    const struct lx_goal *goal = lined->goal;
    const double by = goal->wanted > 1 ? goal->wanted : 1 / goal->wanted;
    const double *v = lined->values;
    for (int side = 0; side < 2; side++) {
        const size_t other = side == 0 ? greatest : least;
        for (size_t k = 0; k < lined->numbers; k++)
            others[k] = lined->slopes[k * lined->cells + other];
        for (size_t i = goal->first; i < goal->first + goal->count; i++) {
            if (isnan(v[i]) || !(v[i] > 0) || !(v[greatest] > 0))
                continue;
            if (side == 0)
                add_row(lined, by * v[i] / v[other], i, by / v[other], others, -by * v[i] / (v[other] * v[other]));
            else
                add_row(lined, by * v[other] / v[i], i, -by * v[other] / (v[i] * v[i]), others, by / v[i]);
        }
    }
}

/* The cell that so many percent of all are no darker than. */
static size_t deciding_cell(const struct lined *lined, size_t bright)
{
    const struct lx_goal *goal = lined->goal;
    for (size_t i = goal->first; i < goal->first + goal->count; i++) {
        size_t above = 0, equal = 0;
        for (size_t k = goal->first; k < goal->first + goal->count; k++) {
            above += lined->values[k] > lined->values[i];
            equal += lined->values[k] >= lined->values[i];
        }
        if (!isnan(lined->values[i]) && above < bright && equal >= bright)
            return i;
    }
    return goal->first;
}

static void add_goal(struct lined *lined, double *others)
{
    const struct lx_goal *goal = lined->goal;
    const double *v = lined->values;
    size_t least = goal->first, greatest = goal->first;
    double sum = 0, count = 0;
    for (size_t k = 0; k < lined->numbers; k++)
        others[k] = 0;
    for (size_t i = goal->first; i < goal->first + goal->count; i++) {
        if (isnan(v[i]))
            continue;
        sum += v[i];
        count++;
        if (!(v[least] <= v[i]))
            least = i;
        if (!(v[greatest] >= v[i]))
            greatest = i;
        for (size_t k = 0; k < lined->numbers; k++)
            others[k] += lined->slopes[k * lined->cells + i];
    }
    if (count == 0)
        return;
    const double average = sum / count, wanted = goal->wanted;
    for (size_t k = 0; k < lined->numbers; k++)
        others[k] /= count;
    if (goal->which == LX_LIMIT_AVERAGE)
        add_row(lined, average / wanted, least, 0, others, 1 / wanted);
    else if (goal->which == LX_LIMIT_RATIO)
        add_ratios(lined, least, greatest, others);
    else if (goal->which == LX_LIMIT_SHARE) {
        const size_t cell = deciding_cell(lined, (size_t)fmax(ceil(wanted / 100 * count - 1e-9), 1));
        add_row(lined, goal->above > 0 ? v[cell] / goal->above : HUGE_VAL, cell, goal->above > 0 ? 1 / goal->above : 0,
                others, 0);
    }
    for (size_t i = goal->first; i < goal->first + goal->count; i++) {
        if (isnan(v[i]))
            continue;
        if (goal->which == LX_LIMIT_MINIMUM)
            add_row(lined, v[i] / wanted, i, 1 / wanted, others, 0);
        else if (goal->which == LX_LIMIT_MAXIMUM && v[i] > 0)
            add_row(lined, wanted / v[i], i, -wanted / (v[i] * v[i]), others, 0);
        else if (goal->which == LX_LIMIT_UNIFORMITY && average > 0)
            add_row(lined, v[i] / (average * wanted), i, 1 / (average * wanted), others,
                    -v[i] / (average * average * wanted));
    }
}

size_t lx_goals_rows(const struct lx_goal *goals, size_t count, const double *values, const double *slopes,
                     size_t cells, size_t numbers, double *rows)
{
    struct lined lined = {.values = values, .slopes = slopes, .cells = cells, .numbers = numbers, .rows = rows};
    double others[LX_MOST_TUNED];
    for (size_t i = 0; i < count; i++) {
        lined.goal = &goals[i];
        add_goal(&lined, others);
    }
    return lined.count;
}
